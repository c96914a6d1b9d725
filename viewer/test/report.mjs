// report.html in headless Chromium: `node test/report.mjs RUN_FOLDER…`, with SHOTS=DIR also
// pictures.
//
// Opens from file://, no console error, no network; the 3-D canvas is not blank; slider, section, motion, colours, plots and the link
// between them answer; every figure shown is the one in summary.json, verify.json and compare.json;
// a phone's width does not overflow. At the first look the tool is in sight and playing is above
// the fold; every colouring has its legend and more than one colour; the line of the program is the
// file's; the sheet of setup and tool is one page of paper.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { open } from './browser.mjs';
import { everyReport, figures, look, plays, set } from './page.mjs';
import { wheel } from './wheel.mjs';

const shots = process.env.SHOTS;
if (shots) mkdirSync(shots, { recursive: true });

/** The canvas' picture changes by an action, at once or, where a machine is busy, soon. */
async function changes(page, what, act) {
  const before = await look(page);
  await act();
  for (let k = 0; k < 20; k++) {
    if ((await look(page)).hash !== before.hash) {
      return;
    }
    await page.waitForTimeout(250);
  }
  assert.fail(`${what} does not change the 3-D view`);
}

/** Play and slider are seen without scrolling. */
async function playsAboveTheFold(page, height) {
  for (const id of ['play', 'along']) {
    const box = await page.locator(`#${id}`).boundingBox();
    assert.ok(box.y >= 0 && box.y + box.height <= height, `#${id} ends at ${box.y + box.height} of ${height}`);
  }
}

/**
 * The lower end of the tool lies in the picture with nothing of the blade before it; so do, of what
 * must be seen, all points.
 */
async function toolInSight(page, what) {
  const found = await page.evaluate(() => {
    const v = globalThis.bladewright.view;
    const { centre } = v.toolPlace;
    const ball = centre.clone().applyMatrix4(v.carrier.matrixWorld);
    const onScreen = p => { const q = p.clone().project(v.camera); return Math.max(Math.abs(q.x), Math.abs(q.y)); };
    return { ball: onScreen(ball), clear: v.clear(v.camera.position.clone().sub(ball).normalize()), all: Math.max(...v.wanted().map(onScreen)), count: v.wanted().length };
  });
  assert.ok(found.ball < 0.95 && found.all < 1.001, `${what}: not all is in the picture: ${JSON.stringify(found)}`);
  assert.ok(found.clear, `${what}: the blade hides the tool`);
  return found.count;
}

/** The program's line beside the tool is the line of the file, and lines go on with the tool. */
async function programLine(page, folder) {
  if (!(await page.locator('#block').isVisible())) { assert.fail('no line of a program is shown'); }
  const shown = [];
  let text = null;
  for (const share of [0, 0.2, 0.5, 0.77, 1]) {
    await set(page, 'along', share);
    const [, file, line] = (await page.textContent('#block-where')).match(/^(.+), line (\d+)/);
    text ??= readFileSync(join(folder, file), 'utf8').split('\n');
    assert.equal(await page.textContent('#block-lines b'), text[line - 1], `line ${line} of ${file}`);
    shown.push(+line);
  }
  assert.ok(shown.every((n, k) => k === 0 || n > shown[k - 1]), `lines do not go on: ${shown}`);
  assert.ok(shown.at(-1) - shown[0] > 0.8 * text.length - 300, `${shown} of ${text.length} lines`);
}

/** The pages of paper that the sheet alone takes. */
async function sheetIsOnePage(page, folder) {
  await page.evaluate(() => { document.documentElement.dataset.print = 'sheet'; });
  const pdf = await page.pdf({ format: 'A4', ...(shots ? { path: join(shots, `${basename(folder)}-sheet.pdf`) } : {}) });
  await page.evaluate(() => { delete document.documentElement.dataset.print; });
  const pages = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g)?.length;
  assert.equal(pages, 1, 'the sheet of setup and tool is one page');
  if (!shots) return;
  // The same as a picture: what fills a page of A4, at 96 dots per inch less its margins.
  await page.emulateMedia({ media: 'print' });
  await page.setViewportSize({ width: 688, height: 1017 });
  await page.evaluate(() => { document.documentElement.dataset.print = 'sheet'; document.documentElement.dataset.theme = 'light'; });
  await page.screenshot({ path: join(shots, `${basename(folder)}-sheet.png`) });
  await page.evaluate(() => { delete document.documentElement.dataset.print; });
  await page.emulateMedia({ media: 'screen' });
  await page.setViewportSize({ width: 1440, height: 900 });
}

async function desktop(browser, folder, url) {
  const name = basename(folder);
  const { page, bad } = await open(browser, url, { viewport: { width: 1440, height: 900 } });
  await page.waitForSelector('html[data-ready]', { timeout: 30000 });
  const ready = +(await page.getAttribute('html', 'data-ready'));
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  const drawn = +(await page.getAttribute('html', 'data-drawn'));
  // What changes must be what was done, not the finer picture that comes with rest.
  await page.evaluate(() => { globalThis.bladewright.view.patience = Infinity; globalThis.bladewright.view.render(); });
  const first = await look(page);
  assert.ok(first.colours > 200, `the canvas is blank: ${first.colours} colours`);
  await playsAboveTheFold(page, 900);
  await toolInSight(page, 'the first look');
  if (shots) await page.screenshot({ path: join(shots, `${name}-first.png`) });
  const shown = await figures(page, folder, 60);
  const verify = JSON.parse(readFileSync(join(folder, 'verify.json'), 'utf8'));
  assert.equal(await page.locator('#checks tbody tr').count(), verify.checks.length, 'every check has its row');

  await changes(page, 'the slider', () => set(page, 'along', 0.4));
  const said = await page.textContent('#along-out');
  assert.match(said, /turn \d+, S /);
  // The S–θ plot has gone to that turn and marks the place, to one of its stretches.
  const [turnSaid, placeSaid] = said.match(/turn (\d+), S ([\d.]+)/).slice(1).map(Number);
  assert.match(await page.textContent('#turn-out'), new RegExp(`^${turnSaid} of`));
  const [marked, longest] = await page.evaluate(() => {
    const plot = globalThis.bladewright.plots.get('chart-channel').u;
    return [plot.posToVal(plot.cursor.left, 'x'), plot.scales.x.max];
  });
  assert.ok(Math.abs(marked - placeSaid) < 0.02 * longest, `S ${placeSaid} is marked at ${marked} of ${longest}`);
  await changes(page, 'the section', () => page.check('#cut-on'));
  await changes(page, 'the section\'s height', async () => set(page, 'cut', +(await page.inputValue('#cut')) - 40));
  await page.uncheck('#cut-on');
  for (const k of await page.$$eval('#colouring option', o => o.map(e => e.value))) {
    await page.selectOption('#colouring', k);
    assert.match(await page.textContent('#scale'), /^\D+[−\d]/, 'the legend has a name and values');
    const spread = await page.evaluate(() => {
      const all = [...globalThis.bladewright.view.lines.geometry.attributes.share.array].filter(v => v >= 0).sort((a, b) => a - b);
      return all.length && all[0] !== 0.5 ? all[Math.floor(0.95 * all.length)] - all[Math.floor(0.05 * all.length)] : 1;
    });
    assert.ok(spread > 0.1, `colouring ${k} is one colour: 9 in 10 places within ${spread} of its scale`);
  }
  await programLine(page, folder);
  if (await page.locator('#layer-scallop').count()) {
    await page.check('#layer-scallop');
    assert.match(await page.textContent('#scale'), /scallop on the surface, µm[−\d.]+/, 'the scallop map has its legend');
    if (shots) await page.locator('#stage').screenshot({ path: join(shots, `${name}-scallop.png`) });
    await page.uncheck('#layer-scallop');
    assert.doesNotMatch(await page.textContent('#scale'), /on the surface/);
  }
  await changes(page, 'a colour', () => page.selectOption('#colouring', '2'));
  const few = await page.evaluate(() => globalThis.bladewright.view.wanted().length);
  await changes(page, 'the machine\'s motion', () => page.selectOption('#motion', 'machine'));
  assert.ok((await toolInSight(page, 'as on the machine')) > few, 'the machine\'s parts are framed');
  if (shots) { await page.locator('#view').scrollIntoViewIfNeeded(); await page.locator('#stage').screenshot({ path: join(shots, `${name}-machine.png`) }); }
  await changes(page, 'playing as on the machine', () => plays(page, () => page.click('#play')));
  await page.selectOption('#motion', 'part');
  await changes(page, 'playing with the part fixed', () => plays(page, () => page.press('#scene', ' ')));
  // Where playing stopped is not the same each time, and a tool there may hide a small layer.
  await set(page, 'along', 0.1);
  await page.selectOption('#look', 'side');
  for (const box of await page.$$('#layers input')) await changes(page, await box.getAttribute('id'), () => box.click()).catch(e => { if (!/machine|uncut|layer-tool/.test(String(e))) throw e; });
  for (const box of await page.$$('#layers input')) await box.click();
  await changes(page, 'an arrow key', () => page.press('#scene', 'ArrowLeft'));

  // Plots: values under the pointer, and the link to the 3-D view.
  await page.locator('#chart-channel .u-over').scrollIntoViewIfNeeded();
  const over = await page.locator('#chart-channel .u-over').boundingBox();
  const place = await page.textContent('#along-out');
  await page.mouse.move(over.x + over.width * 0.3, over.y + over.height * 0.5);
  await page.mouse.move(over.x + over.width * 0.7, over.y + over.height * 0.5);
  const readout = await page.textContent('#chart-channel .readout');
  assert.match(readout, /S, mm .*true channel .*tangent channel .*schedule/);
  // The view follows with the next picture that it draws.
  await page.waitForFunction(before => document.querySelector('#along-out').textContent !== before, place, { timeout: 5000 })
    .catch(() => assert.fail(`hovering the plot moves the tool, which stays at ${place}`));
  const turn = await page.textContent('#turn-out');
  await page.click('#turn-up');
  assert.notEqual(await page.textContent('#turn-out'), turn, 'another turn is shown');
  await page.focus('#chart-velocity .canvas');
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowRight');
  assert.match(await page.textContent('#chart-velocity .readout'), /time, s .*this plan/);
  // The map of the scallop answers with the dot under the pointer, not with another of the same way
  // round.
  await page.locator('#chart-map').scrollIntoViewIfNeeded();
  const dot = await page.evaluate(() => {
    const u = globalThis.bladewright.plots.get('chart-map')?.u;
    if (!u) return null;
    const k = Math.floor(u.data[0].length / 2);
    const { left, top } = u.over.getBoundingClientRect();
    return { at: [left + u.valToPos(u.data[0][k], 'x'), top + u.valToPos(u.data[1][k], 'y')], height: u.data[1][k] };
  });
  if (dot) {
    await page.mouse.move(...dot.at);
    const shown = +(await page.textContent('#chart-map .readout')).match(/µm at height (\S+) mm$/)[1].replace('−', '-');
    assert.ok(Math.abs(shown - dot.height) < 1e-4 * Math.abs(dot.height) + 0.3, `the dot at height ${dot.height} answers as ${shown}`);
  }
  await wheel(page, folder);
  // Every control is reached by the Tab key.
  const wanted = await page.$$eval('main a[href], main button, main select, main input, main summary, main [tabindex="0"]', all => all.filter(e => !e.disabled && e.checkVisibility({ contentVisibilityAuto: true }) && !e.closest("details:not([open]) pre")).length);
  await page.focus('#theme');
  const reached = new Set();
  for (let k = 0; k < wanted + 40; k++) {
    await page.keyboard.press('Tab');
    reached.add(await page.evaluate(() => { const e = document.activeElement; e.dataset.tab ??= String(document.querySelectorAll('[data-tab]').length); return e.closest('main') ? e.dataset.tab : ''; }));
  }
  reached.delete('');
  assert.ok(reached.size >= wanted, `${reached.size} of ${wanted} controls are reached by the keyboard`);
  // A click on the path in the 3-D view goes to its turn.
  await page.locator('#scene').scrollIntoViewIfNeeded();
  const box = await page.locator('#scene').boundingBox();
  const was = await page.textContent('#along-out');
  let hit = false;
  for (let k = 0; k < 300 && !hit; k++) {
    await page.mouse.move(box.x + box.width * (0.3 + 0.4 * ((k * 0.7549) % 1)), box.y + box.height * (0.2 + 0.6 * ((k * 0.5698) % 1)));
    await page.evaluate(() => new Promise(d => requestAnimationFrame(() => requestAnimationFrame(d))));
    hit = await page.locator('#pick').isVisible();
  }
  assert.ok(hit, 'the pointer finds the path');
  await page.mouse.down(); await page.mouse.up();
  assert.notEqual(await page.textContent('#along-out'), was, 'a click on the path moves the tool');
  await page.mouse.move(5, 5);
  await page.click('#theme');
  assert.equal(await page.getAttribute('html', 'data-theme'), 'dark');
  if (shots) { await page.evaluate(() => scrollTo(0, 0)); await page.screenshot({ path: join(shots, `${name}-dark.png`) }); }
  await page.click('#theme');
  await sheetIsOnePage(page, folder);
  assert.deepEqual(bad, []);
  await page.close();
  return { ready, drawn, shown };
}

async function picture(browser, folder, url, [width, height], suffix) {
  const { page, bad } = await open(browser, url, { viewport: { width, height } });
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `${wide} px too wide at ${width}`);
  await playsAboveTheFold(page, height);
  await set(page, 'along', 0.45);
  await look(page);
  if (shots) {
    const name = basename(folder);
    await page.screenshot({ path: join(shots, `${name}-${suffix}.png`) });
    await page.screenshot({ path: join(shots, `${name}-${suffix}-full.png`), fullPage: true });
    if (suffix === '1440') {
      await page.pdf({ path: join(shots, `${name}-print.pdf`), format: 'A4' });
      // The same as one long picture, as wide as the paper less its margins.
      await page.setViewportSize({ width: 688, height: 1017 });
      await page.emulateMedia({ media: 'print' });
      await page.waitForTimeout(1000);
      await page.screenshot({ path: join(shots, `${name}-print.png`), fullPage: true });
    }
  }
  assert.deepEqual(bad, []);
  await page.close();
}

await everyReport(async (browser, folder, url) => {
  const { ready, drawn, shown } = await desktop(browser, folder, url);
  await picture(browser, folder, url, [1440, 900], '1440');
  await picture(browser, folder, url, [390, 844], '390');
  return `interactive after ${ready} ms, all plots after ${drawn} ms, ${shown} figures as in the files`;
});
