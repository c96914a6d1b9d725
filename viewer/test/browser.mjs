// Headless Chromium for the tests: no network, software WebGL.
import { chromium } from 'playwright-core';
import { existsSync } from 'node:fs';

const found = [process.env.CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome'].find(f => f && existsSync(f));
if (!found) throw new Error('no Chromium found: apt-get install chromium, or name it in CHROMIUM');

export const launch = () => chromium.launch({
  executablePath: found,
  headless: true,
  args: ['--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

/**
 * A page that remembers what must not happen: console errors, page errors, requests to anything but
 * this file.
 */
export async function open(browser, url, options = {}) {
  const page = await browser.newPage(options);
  const bad = [];
  page.on('console', m => { if (m.type() === 'error' || (m.type() === 'warning' && !/GPU stall|GL Driver Message/.test(m.text()))) bad.push(`console: ${m.text()}`); });
  page.on('pageerror', e => bad.push(`page: ${e.message}`));
  page.on('request', r => { if (!/^(data|blob):/.test(r.url()) && r.url() !== url && !r.url().startsWith(`${url}#`)) bad.push(`request: ${r.url()}`); });
  await page.goto(url, { waitUntil: 'commit' });
  return { page, bad };
}
