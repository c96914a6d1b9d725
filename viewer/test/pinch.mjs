// report.html of rows for two tools in headless Chromium: `node test/pinch.mjs FOLDER…`, with
// SHOTS=DIR also pictures.
//
// Opens from file://, no console error, no network; playing moves both tools; all plots have data
// and are linked with the view; every figure shown is the one in pinch.json; a phone's width does
// not overflow.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { open } from './browser.mjs';
import { everyReport, figures, look, plays, set } from './page.mjs';

const shots = process.env.SHOTS;
if (shots) mkdirSync(shots, { recursive: true });

/** Where both tools stand. */
const places = page => page.evaluate(() => globalThis.bladewright.view.tools.map(t => [...t.group.matrixWorld.elements]));

/** How many values each plot has, by the names of its curves. */
const curves = page => page.evaluate(() => Object.fromEntries([...globalThis.bladewright.plots].map(([id, { u }]) => [id, u.series.slice(1).map((_, k) => u.data[k + 1].filter(v => v != null).length)])));

async function desktop(browser, folder, url) {
  const name = basename(folder);
  const { page, bad } = await open(browser, url, { viewport: { width: 1440, height: 900 } });
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  await page.evaluate(() => { globalThis.bladewright.view.patience = Infinity; globalThis.bladewright.view.render(); });
  const first = await look(page);
  assert.ok(first.colours > 200, `the canvas is blank: ${first.colours} colours`);
  if (shots) await page.screenshot({ path: join(shots, `${name}-first.png`) });
  const shown = await figures(page, folder, 45);

  // Both tools stand at the first place, with the blade between them and hidden by nothing.
  const sight = await page.evaluate(() => {
    const v = globalThis.bladewright.view;
    const ends = v.tools.map(t => t.place.centre.clone().applyMatrix4(v.carrier.matrixWorld));
    const mid = ends[0].clone().add(ends[1]).multiplyScalar(0.5);
    const seen = ends.map(p => { const q = p.clone().project(v.camera); return Math.max(Math.abs(q.x), Math.abs(q.y)); });
    return { seen, clear: v.clear(v.camera.position.clone().sub(mid).normalize()), axes: v.tools[0].place.axis.dot(v.tools[1].place.axis) };
  });
  assert.ok(sight.seen.every(v => v < 0.95) && sight.clear, `not both tools are in sight: ${JSON.stringify(sight)}`);
  assert.ok(sight.axes < 0, 'the tools come from opposite sides');

  // Playing moves both.
  const before = await places(page);
  await plays(page, () => page.click('#play'));
  const after = await places(page);
  for (const k of [0, 1]) assert.notDeepEqual(after[k], before[k], `playing moves tool ${k + 1}`);
  assert.match(await page.textContent('#along-out'), /^(row|stretch) \d+, S /);

  // All curves are there.
  const pinch = JSON.parse(readFileSync(join(folder, 'pinch.json'), 'utf8'));
  const all = await curves(page);
  const wanted = { 'chart-channel': 7, 'chart-angle': 2, 'chart-apart': 2, ...(pinch.program ? Object.fromEntries(['position', 'velocity', 'acceleration', 'jerk'].map(k => [`chart-${k}`, 9])) : {}) };
  for (const [id, count] of Object.entries(wanted)) {
    assert.equal(all[id]?.length, count, `curves of ${id}`);
    assert.ok(all[id].every(n => n > pinch.stretches), `${id} has values: ${all[id]}`);
  }
  for (const axis of pinch.program ? ['0', '3'] : []) {
    await page.selectOption('#axis', axis);
    assert.ok((await curves(page))['chart-position'][0] > 1, `axis ${axis} has a curve`);
  }
  // A row alone, and back to all.
  await page.click('#turn-up');
  assert.match(await page.textContent('#turn-out'), /^\d+ of \d+$/);
  const one = await curves(page);
  assert.ok(one['chart-channel'][0] < all['chart-channel'][0], 'one row has fewer places than all');
  await page.selectOption('#count', 'all');

  // The plots move the tools, and mark where they are.
  await page.locator('#chart-angle .u-over').scrollIntoViewIfNeeded();
  const over = await page.locator('#chart-angle .u-over').boundingBox();
  const was = await page.textContent('#along-out');
  await page.mouse.move(over.x + over.width * 0.3, over.y + over.height * 0.5);
  await page.mouse.move(over.x + over.width * 0.7, over.y + over.height * 0.5);
  assert.match(await page.textContent('#chart-angle .readout'), /S along the rows, mm .*lack of being opposite .*limit/);
  await page.waitForFunction(text => document.querySelector('#along-out').textContent !== text, was, { timeout: 5000 })
    .catch(() => assert.fail('hovering a plot moves the tools'));
  const marked = await page.evaluate(() => { const { u } = globalThis.bladewright.plots.get('chart-channel'); return u.cursor.left / u.over.clientWidth; });
  assert.ok(Math.abs(marked - 0.7) < 0.02, `the plot of the table marks ${marked}`);
  // Colourings have more than one colour, and a legend.
  for (const k of await page.$$eval('#colouring option', o => o.map(e => e.value))) {
    await page.selectOption('#colouring', k);
    assert.match(await page.textContent('#scale'), /^\D+[−\d]/, 'the legend has a name and values');
    const shares = await page.evaluate(() => new Set(globalThis.bladewright.view.tools[1].lines.geometry.attributes.share.array).size);
    assert.ok(shares > 5, `colouring ${k} has ${shares} colours`);
  }
  await set(page, 'along', 0.5);
  if (shots) await page.screenshot({ path: join(shots, `${name}-full.png`), fullPage: true });
  // The sheet of setup and tools is one page of paper.
  await page.evaluate(() => { document.documentElement.dataset.print = 'sheet'; });
  const pdf = await page.pdf({ format: 'A4' });
  await page.evaluate(() => { delete document.documentElement.dataset.print; });
  assert.equal(pdf.toString('latin1').match(/\/Type\s*\/Page\b/g)?.length, 1, 'the sheet of setup and tools is one page');
  await page.click('#theme');
  if (shots) { await page.evaluate(() => scrollTo(0, 0)); await page.screenshot({ path: join(shots, `${name}-dark.png`) }); }
  assert.deepEqual(bad, []);
  await page.close();
  return shown;
}

async function phone(browser, folder, url) {
  const { page, bad } = await open(browser, url, { viewport: { width: 390, height: 844 } });
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `${wide} px too wide`);
  if (shots) await page.screenshot({ path: join(shots, `${basename(folder)}-390-full.png`), fullPage: true });
  assert.deepEqual(bad, []);
  await page.close();
}

await everyReport(async (browser, folder, url) => {
  const shown = await desktop(browser, folder, url);
  await phone(browser, folder, url);
  return `both tools move, all plots have data, ${shown} figures as in the file`;
});
