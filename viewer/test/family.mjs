// family.html in headless Chromium: `node test/family.mjs FAMILY_FOLDER`, with SHOTS=DIR also
// pictures.
//
// Opens from file://, no console error, no network. What is drawn is compared with family.csv: every member's point in the colour of its status at the
// place of its figures and no point elsewhere, every bar as high as it has members, for the columns
// chosen at first and for others. The pointer and the keyboard name members and open their reports;
// the table sorts and filters; dark, print and a phone's width.
import assert from 'node:assert/strict';
import { mkdirSync, readFileSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch, open } from './browser.mjs';

const shots = process.env.SHOTS;
if (shots) mkdirSync(shots, { recursive: true });
const folder = resolve(process.argv[2]);
const file = join(folder, 'family.html');
const url = pathToFileURL(file).href;

/** Rows of a table of comma-separated values as objects. */
function table(text) {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^,\n"]*))(,|\n|$)/g)) {
    rows.at(-1).push(quoted?.replaceAll('""', '"') ?? plain);
    if (end === '\n') rows.push([]);
  }
  const [head, ...body] = rows.filter(r => r.length > 1);
  return body.map(r => Object.fromEntries(head.map((name, k) => [name, r[k]])));
}

const members = table(readFileSync(join(folder, 'family.csv'), 'utf8'));
const number = text => (text !== '' && Number.isFinite(Number(text)) ? Number(text) : null);
const figures = name => members.map(m => number(m[name]));
const differs = name => new Set(figures(name).filter(v => v !== null)).size > 1;
/** As the page shows numbers. */
const shown = v => String(Number.isInteger(v) ? v : +v.toPrecision(5)).replace('-', '−');

/** A chart's pixels, and where its scales put values on the page. */
const chart = (page, id) => page.evaluate(id => {
  const { u } = globalThis.bladewright.plots.get(id);
  const { left, top, width, height } = u.bbox;
  const pixels = [...u.ctx.getImageData(left, top, width, height).data];
  const over = u.over.getBoundingClientRect();
  return { width, height, pixels, x: [u.scales.x.min, u.scales.x.max], y: [u.scales.y.min, u.scales.y.max], over: [over.left, over.top] };
}, id);
const placed = (c, x, y) => [((x - c.x[0]) / (c.x[1] - c.x[0])) * c.width, (1 - (y - c.y[0]) / (c.y[1] - c.y[0])) * c.height];
const pixel = (c, x, y) => {
  const at = 4 * (Math.round(y) * c.width + Math.round(x));
  return c.pixels.slice(at, at + 3);
};
const colours = page => page.evaluate(() => Object.fromEntries([['good', 'good'], ['findings', 'c5'], ['failed', 'bad']].map(([status, name]) => {
  const hex = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  return [status, [1, 3, 5].map(k => parseInt(hex.slice(k, k + 2), 16))];
})));
const alike = (a, b) => a.every((v, k) => Math.abs(v - b[k]) < 12);

/**
 * Every member's point in its colour at its place, and no such colour elsewhere. Gives the places
 * on the page.
 */
async function points(page, x, y) {
  const [xs, ys] = [figures(x), figures(y)];
  const both = members.map((m, k) => ({ name: m.name, status: m.status, x: xs[k], y: ys[k] })).filter(m => m.x !== null && m.y !== null);
  assert.ok(both.length > 5, `${both.length} members with ${x} and ${y}`);
  const c = await chart(page, 'scatter');
  const look = await colours(page);
  const all = both.map(m => ({ ...m, at: placed(c, m.x, m.y) }));
  const count = Object.fromEntries(all.map(m => [m.name, 0]));
  for (let py = 0; py < c.height; py++) {
    for (let px = 0; px < c.width; px++) {
      const rgb = pixel(c, px, py);
      for (const [status, colour] of Object.entries(look)) {
        if (!alike(rgb, colour)) continue;
        const near = all.filter(m => m.status === status && Math.hypot(m.at[0] - px, m.at[1] - py) < 7);
        assert.ok(near.length, `a pixel of ${status} at ${px}, ${py}, where no member is: ${x}, ${y}`);
        for (const m of near) count[m.name]++;
      }
    }
  }
  for (const m of all) {
    const covered = all.some(o => o !== m && Math.hypot(o.at[0] - m.at[0], o.at[1] - m.at[1]) < 10);
    assert.ok(covered || count[m.name] > 25, `${m.name}: ${count[m.name]} pixels at its place over ${x}, ${y}`);
  }
  return all.map(m => ({ ...m, page: [m.at[0] + c.over[0], m.at[1] + c.over[1]] }));
}

/** The pointer names the members at each point, beside it and below. */
async function names(page, all) {
  for (const m of all) {
    await page.mouse.move(m.page[0] + 2, m.page[1] - 2);
    const tip = await page.textContent('#scatter .tip');
    assert.ok(await page.locator('#scatter .tip').isVisible());
    assert.equal(tip, await page.textContent('#scatter .readout'));
    const together = all.filter(o => Math.hypot(o.at[0] - m.at[0], o.at[1] - m.at[1]) < 1);
    const near = all.filter(o => Math.hypot(o.at[0] - m.at[0], o.at[1] - m.at[1]) < 4);
    const [said, figuresSaid] = tip.split(': ');
    const named = said.replace(/ and \d+ more$/, '').split(', ');
    assert.ok(named.every(n => near.some(o => o.name === n)), `${tip}, at ${m.name}`);
    if (near.length === together.length) assert.equal(named.length + Number(said.match(/ and (\d+) more$/)?.[1] || 0), together.length, tip);
    assert.ok(near.some(o => figuresSaid === `${shown(o.x)}, ${shown(o.y)}`), `${tip}, at ${m.x}, ${m.y}`);
  }
}

/** Each bar stands from its lower to its upper end, as high as members lie between. */
async function bars(page, name) {
  const values = figures(name).filter(v => v !== null).sort((a, b) => a - b);
  const [lo, hi] = [values[0], values.at(-1)];
  const c = await chart(page, 'bars');
  assert.ok(Math.abs(c.x[0] - lo) < 1e-9 * Math.abs(lo) && Math.abs(c.x[1] - hi) < 1e-9 * Math.abs(hi), `${c.x} of ${lo} to ${hi}`);
  const ground = pixel(c, 2, 2);
  const bins = Math.max(5, Math.min(30, Math.ceil(1.5 * Math.sqrt(values.length))));
  let seen = 0;
  for (let k = 0; k < bins; k++) {
    const [from, to] = [k, k + 1].map(i => lo + (i * (hi - lo)) / bins);
    const inside = values.filter(v => v >= from && (v < to || k === bins - 1)).length;
    seen += inside;
    // Beside the middle, where no line of the grid need be; the bar's own line is at its top.
    const [px, top] = placed(c, from + 0.37 * (to - from), inside);
    if (inside) assert.ok(pixel(c, px, Math.min(top + 6, c.height - 3)).some((v, i) => Math.abs(v - ground[i]) > 30), `no bar of ${inside} from ${from}`);
    assert.ok(pixel(c, px, top - 6).every((v, i) => Math.abs(v - ground[i]) < 60), `a bar above ${inside} from ${from}`);
    await page.mouse.move(c.over[0] + px, c.over[1] + c.height / 2);
    assert.equal(await page.textContent('#bars .readout'), `${shown(+from.toPrecision(12))} to ${shown(+to.toPrecision(12))}: ${inside} ${inside === 1 ? 'member' : 'members'}`);
  }
  assert.equal(seen, values.length);
}

const choose = async (page, x, y) => { await page.selectOption('#plot-x', x); await page.selectOption('#plot-y', y); };
const column = (page, n) => page.$$eval('#table tbody tr', (rows, n) => rows.map(r => r.cells[n].textContent), n);

async function theTable(page) {
  const heads = await page.$$eval('#table th', all => all.map(e => e.textContent));
  const at = heads.indexOf('machining_time_s');
  const button = page.locator('#table th button', { hasText: /^machining_time_s$/ });
  for (const sign of [1, -1]) {
    await button.click();
    const values = (await column(page, at)).map(number);
    const [full, empty] = [values.filter(v => v !== null), values.findIndex(v => v === null)];
    assert.ok(full.length > 5 && full.every((v, k) => k === 0 || sign * (v - full[k - 1]) >= 0), `${values}`);
    assert.ok(empty === -1 || empty === full.length, 'empty cells are last');
  }
  assert.ok(await button.evaluate(e => document.activeElement === e), 'the keyboard stays at the heading');
  await page.selectOption('#status', 'findings');
  const found = members.filter(m => m.status === 'findings').map(m => m.name).sort();
  assert.deepEqual((await column(page, 0)).sort(), found);
  await page.selectOption('#status', '');
  await page.fill('#search', found[0].toUpperCase());
  assert.deepEqual(await column(page, 0), [found[0]]);
  await page.fill('#search', '');
  await page.check('#all-columns');
  assert.ok((await page.locator('#table th').count()) > heads.length);
  await page.uncheck('#all-columns');
  assert.equal(await page.locator('#table td svg .schedule').count(), members.filter(m => m.status !== 'failed').length, 'a picture of each plan');
}

async function desktop(browser) {
  const { page, bad } = await open(browser, url, { viewport: { width: 1440, height: 900 } });
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  const options = await page.$$eval('#plot-x option', all => all.map(e => e.value));
  assert.deepEqual(options, Object.keys(members[0]).filter(name => name !== 'key' && differs(name)), 'the columns that differ are offered');
  const [x, y] = [await page.inputValue('#plot-x'), await page.inputValue('#plot-y')];
  assert.deepEqual([x, y], ['design.fillet_radius_mm', 'machining_time_s']);
  await names(page, await points(page, x, y));
  await bars(page, y);
  if (shots) await page.screenshot({ path: join(shots, 'family.png') });

  const others = ['channel_width_min_deg', 'path_length_mm'];
  await choose(page, ...others);
  const all = await points(page, ...others);
  await names(page, all);
  await bars(page, others[1]);
  // Away from all points there is nothing to name.
  await page.mouse.move(5, 5);
  assert.equal(await page.locator('#scatter .tip').isVisible(), false);

  // The keyboard reads the members one after another.
  await page.focus('#scatter .canvas');
  const said = new Set();
  for (let k = 0; k < all.length; k++) {
    await page.keyboard.press('ArrowRight');
    said.add((await page.textContent('#scatter .readout')).split(/[,:]| and /)[0]);
  }
  assert.deepEqual([...said].sort(), all.map(m => m.name).sort());

  // A status that is switched off is not drawn and not named.
  const good = page.locator('#scatter .legend button', { hasText: 'good' });
  await good.click();
  const alone = all.find(m => m.status === 'good' && all.every(o => o === m || o.status === 'good' || Math.hypot(o.at[0] - m.at[0], o.at[1] - m.at[1]) > 40));
  if (alone) {
    await page.mouse.move(...alone.page);
    assert.equal(await page.textContent('#scatter .readout'), '');
  }
  await page.focus('#scatter .canvas');
  for (const key of ['Home', 'End']) {
    await page.keyboard.press(key);
    const name = (await page.textContent('#scatter .readout')).split(/[,:]| and /)[0];
    assert.equal(all.find(m => m.name === name)?.status, 'findings', `${key} reads ${name}`);
  }
  await good.click();
  await theTable(page);

  await page.click('#theme');
  assert.equal(await page.getAttribute('html', 'data-theme'), 'dark');
  await page.evaluate(() => scrollTo(0, 0));
  await points(page, ...others);
  if (shots) await page.screenshot({ path: join(shots, 'family-dark.png') });
  // Paper is light, and shows the whole table.
  await page.evaluate(() => addEventListener('beforeprint', () => { globalThis.onPaper = document.documentElement.dataset.theme; }));
  const pdf = await page.pdf(shots ? { path: join(shots, 'family.pdf') } : {});
  assert.ok(pdf.length > 1000);
  assert.equal(await page.evaluate(() => globalThis.onPaper), 'light');
  assert.equal(await page.getAttribute('html', 'data-theme'), 'dark');
  await page.emulateMedia({ media: 'print' });
  assert.ok(await page.$eval('.scroll', e => e.scrollHeight <= e.clientHeight + 1), 'the table is cut off on paper');
  await page.emulateMedia({ media: 'screen' });
  assert.deepEqual(bad, []);

  // A click and the enter key open the member's report.
  const [one] = all;
  const report = name => pathToFileURL(join(folder, 'members', name, 'report.html')).href;
  const back = await points(page, ...others);
  await page.mouse.move(...back[0].page);
  const first = (await page.textContent('#scatter .readout')).split(/[,:]| and /)[0];
  await page.mouse.click(...back[0].page);
  await page.waitForURL(report(first), { waitUntil: 'commit' });
  assert.ok(back.some(m => m.name === first && Math.hypot(m.at[0] - back[0].at[0], m.at[1] - back[0].at[1]) < 4), `${one.name} is at the click, ${first} opens`);
  await page.goto(url, { waitUntil: 'commit' });
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  await page.focus('#scatter .canvas');
  await page.keyboard.press('End');
  const last = (await page.textContent('#scatter .readout')).split(/[,:]| and /)[0];
  await page.keyboard.press('Enter');
  await page.waitForURL(report(last), { waitUntil: 'commit' });
  await page.close();
}

async function phone(browser) {
  const { page, bad } = await open(browser, url, { viewport: { width: 390, height: 844 }, colorScheme: 'dark' });
  await page.waitForSelector('html[data-drawn]', { timeout: 30000 });
  assert.equal(await page.getAttribute('html', 'data-theme'), 'dark', 'as the system has it');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(wide <= 0, `${wide} px too wide`);
  if (shots) await page.screenshot({ path: join(shots, 'family-390.png') });
  assert.deepEqual(bad, []);
  await page.close();
}

const kb = statSync(file).size / 1e3;
assert.ok(kb < 200, `${file} is ${kb.toFixed(0)} kB`);
const browser = await launch();
try {
  await desktop(browser);
  await phone(browser);
  console.log(`${file}: ${kb.toFixed(0)} kB, ${members.length} members as in family.csv`);
} finally {
  await browser.close();
}
