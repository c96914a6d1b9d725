// Pictures for README and examples: `node test/pictures.mjs DIR RUN_FOLDER…`. For each run
// NAME.png, its 3-D view; of the last also report.png (1440 x 900), report-phone.png (390 x 844),
// report-machine.png and report-plots.png.
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { launch, open } from './browser.mjs';

const [dir, ...folders] = process.argv.slice(2);
const browser = await launch();
const ready = async (folder, width, height) => {
  const { page } = await open(browser, pathToFileURL(resolve(folder, 'report.html')).href, { viewport: { width, height } });
  await page.waitForSelector('html[data-drawn]', { timeout: 60000 });
  // Seen from where the tool is in sight then.
  await page.evaluate(() => {
    const e = document.getElementById('along');
    e.value = 0.55;
    e.dispatchEvent(new Event('input'));
    globalThis.bladewright.view.look('side');
  });
  await page.waitForTimeout(3000);
  return page;
};
const stage = (page, name) => page.locator('#stage').screenshot({ path: join(dir, name) });

for (const folder of folders) {
  const page = await ready(folder, 1000, 800);
  await stage(page, `${basename(folder)}.png`);
  await page.close();
}
const shown = folders.find(f => basename(f) === 'steam_root') || folders[folders.length - 1];
const page = await ready(shown, 1440, 900);
await page.evaluate(() => scrollTo(0, 0));
await page.screenshot({ path: join(dir, 'report.png') });
await page.locator('#channel').screenshot({ path: join(dir, 'report-plots.png') });
await page.selectOption('#motion', 'machine');
await page.selectOption('#colouring', '4');
await page.waitForTimeout(3000);
await stage(page, 'report-machine.png');
await page.close();
const phone = await ready(shown, 390, 844);
await phone.locator('#view').scrollIntoViewIfNeeded();
await phone.evaluate(() => document.getElementById('view').scrollIntoView());
await phone.waitForTimeout(3000);
await phone.screenshot({ path: join(dir, 'report-phone.png') });
await browser.close();
