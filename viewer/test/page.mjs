// What the tests of all reports ask of a page.
import assert from 'node:assert/strict';
import { readFileSync, statSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch } from './browser.mjs';

/** Most that a report may have, MB. */
const MOST_MB = 4;

/** Tries the report of each folder that the command line names: `one(browser, folder, url)` gives what is printed of it. */
export async function everyReport(one) {
  const browser = await launch();
  try {
    for (const folder of process.argv.slice(2)) {
      const file = resolve(folder, 'report.html');
      const mb = statSync(file).size / 1e6;
      assert.ok(mb <= MOST_MB, `${file} is ${mb.toFixed(2)} MB`);
      console.log(`${folder}: ${mb.toFixed(2)} MB, ${await one(browser, folder, pathToFileURL(file).href)}`);
    }
  } finally {
    await browser.close();
  }
}

/** How many colours a canvas shows, and a hash of its pixels, with the next picture that is drawn. */
export const look = (page, id = 'scene') => page.evaluate(id => new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => {
  const c = document.getElementById(id);
  const gl = c.getContext('webgl2');
  let p;
  if (gl) {
    const [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    p = new Uint8Array(4 * w * h);
    gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, p);
  } else {
    // Read from a copy: the browser complains of a canvas that is drawn on and read in turn.
    const copy = Object.assign(document.createElement('canvas'), { width: c.width, height: c.height }).getContext('2d', { willReadFrequently: true });
    copy.drawImage(c, 0, 0);
    p = copy.getImageData(0, 0, c.width, c.height).data;
  }
  const colours = new Set();
  let hash = 0;
  for (let i = 0; i < p.length; i += 4) {
    const v = (p[i] << 16) | (p[i + 1] << 8) | p[i + 2];
    colours.add(v);
    hash = (Math.imul(hash, 31) + v) | 0;
  }
  done({ colours: colours.size, hash });
}))), id);

/** Starts and stops the motion, which moves the place and says so. */
export async function plays(page, toggle) {
  // From the start and slowly, so that the end is far.
  await page.selectOption('#speed', '1');
  await set(page, 'along', 0.1);
  const from = +(await page.inputValue('#along'));
  await toggle();
  assert.equal(await page.getAttribute('#play', 'aria-pressed'), 'true');
  await page.waitForFunction(from => +document.getElementById('along').value !== from, from, { timeout: 20000 });
  await toggle();
  assert.equal(await page.getAttribute('#play', 'aria-pressed'), 'false');
}

export const set = (page, id, value, event = 'input') => page.evaluate(([id, value, event]) => {
  const e = document.getElementById(id);
  e.value = value;
  e.dispatchEvent(new Event(event, { bubbles: true }));
}, [id, value, event]);

const pointer = (json, path) => path.split('/').slice(1).reduce((v, k) => v?.[k], json);

/**
 * What is shown is the file's number, to the last digit shown; of figures there are more than
 * `least`. Their number.
 */
export async function figures(page, folder, least) {
  const cells = await page.$$eval('[data-figure]', all => all.map(e => [e.dataset.figure, e.textContent]));
  assert.ok(cells.length > least, `only ${cells.length} figures`);
  const files = {};
  for (const [from, text] of cells) {
    const [name, ...path] = from.split('/');
    files[name] ??= JSON.parse(readFileSync(join(folder, `${name}.json`), 'utf8'));
    const value = pointer(files[name], `/${path.join('/')}`);
    if (text === '–') { assert.equal(value ?? null, null, `${from} is not shown`); continue; }
    const shown = Number(text);
    const [digits, power] = text.split('e');
    const unit = 10 ** ((Number(power) || 0) - (digits.split('.')[1]?.length || 0));
    assert.ok(Math.abs(shown - value) <= 0.5000001 * Math.max(unit, Math.abs(value) * 1e-4 * 5), `${from}: ${text} shown, ${value} in the file`);
    assert.ok(Number.isInteger(value) ? shown === value || Math.abs(value) >= 1e4 : true, `${from}: ${text}, ${value}`);
  }
  return cells.length;
}
