// What the page of a blade of a wheel shows besides: the rest of the wheel, the free tool axes at
// the cursor, both rotary axes.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { look, set } from './page.mjs';

const map = page => look(page, 'free-map');

/** Tries the panel of the free tool axes. */
async function freeAxes(page) {
  const words = id => page.textContent(`#free-${id}`);
  await page.locator('#free-map').scrollIntoViewIfNeeded();
  // A map that is not seen is drawn when it is.
  await map(page);
  await set(page, 'along', 0.12);
  const first = { ...(await map(page)), out: await words('out') };
  assert.ok(first.colours > 20, `the map is blank: ${first.colours} colours`);
  assert.match(first.out, /computed at turn \d+, S [\d.]+ mm.*\(location \d+ of \d+\)/);
  assert.match(await words('legend'), /free, [\d.]+ %/);
  await set(page, 'along', 0.61);
  const second = { ...(await map(page)), out: await words('out') };
  assert.ok(second.hash !== first.hash && second.out !== first.out, `the map does not follow the cursor: ${second.out}`);
  // Everywhere the plan's axis is free, or in a cell that is not decided.
  const taken = await page.evaluate(() => {
    const free = globalThis.bladewright.plots.get('free-map');
    return free.maps.filter(m => free.codeAt(m, free.coneAt(m, m.theta[2])) > 2).length;
  });
  assert.equal(taken, 0, 'the axis of the plan is taken on some maps');
  // Shares are those of all maps' cells: nothing is left out.
  const parts = (await words('legend')).match(/[\d.]+ %/g).map(parseFloat);
  assert.ok(Math.abs(parts.reduce((a, b) => a + b) - 100) < 3, `shares are ${parts}`);
  const plan = await words('said');
  assert.match(plan, /^Tool axis of the plan [\d.]+° off the normal: (free|not decided)$/);
  const box = await page.locator('#free-map').boundingBox();
  await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.07 * box.height);
  assert.match(await words('said'), /^[\d.]+° off the normal: taken: .+ against the part$/);
  await page.mouse.move(5, 5);
  assert.equal(await words('said'), plan);
  const along = await page.textContent('#along-out');
  await page.focus('#free-map');
  await page.keyboard.press('ArrowRight');
  const third = await map(page);
  assert.ok(third.hash !== second.hash && (await page.textContent('#along-out')) !== along, 'an arrow key goes to the next map');
  assert.doesNotMatch(await words('out'), /from the cursor/);
}

/** Tries all of it, as far as the run has it. */
export async function wheel(page, folder) {
  const job = readFileSync(join(folder, 'job.resolved.toml'), 'utf8');
  const [isOne, isFive] = [/^\[wheel\]/m.test(job), /^kind = "five-axis"/m.test(job)];
  assert.equal(await page.locator('#layer-neighbours').count(), Number(isOne), 'the other blades are a layer of their own');
  assert.equal(await page.locator('#free-axes').count(), Number(isFive), 'five axes have maps of the free tool axes');
  if (!isFive) return;
  await freeAxes(page);
  const names = await page.$$eval('#axis option', all => all.map(o => o.textContent));
  const chosen = await page.$eval('#axis', e => e.selectedOptions[0].textContent);
  const rotary = chosen.split(' and ');
  assert.ok(rotary.length === 2 && rotary.every(n => names.includes(n)), `both rotary axes are shown: ${chosen} of ${names}`);
  assert.equal(await page.getAttribute('#chart-position .canvas', 'aria-label').then(t => t.split(' over ')[0]), `Position of ${chosen}, °`);
  for (const name of rotary) assert.match(await page.textContent('#chart-velocity .legend'), new RegExp(`${name}, this plan`));
}
