// Builds dist/viewer.js and dist/viewer.css from src and from the packages that package-lock.json pins.
// `node build.mjs` writes them; `node build.mjs --check` compares with what is there and fails where it differs.
import { build } from 'esbuild';
import { readFile, writeFile } from 'node:fs/promises';

const here = new URL('.', import.meta.url);
const lock = JSON.parse(await readFile(new URL('package-lock.json', here), 'utf8'));
const text = async name => (await readFile(new URL(name, here), 'utf8')).trim();
const version = name => lock.packages[`node_modules/${name}`].version;

const banner = [
  '/*! The script of bladewright\'s report.html: sources in viewer/src, built by `npm ci && npm run build` in viewer/.',
  `In it: three.js ${version('three')} (npm package three) and uPlot ${version('uplot')} (npm package uplot), both under the MIT licence:`,
  '',
  'three.js:', await text('node_modules/three/LICENSE'),
  '',
  'uPlot:', await text('node_modules/uplot/LICENSE'),
  '*/',
].join('\n');

const js = await build({
  entryPoints: [new URL('src/boot.js', here).pathname],
  absWorkingDir: new URL('.', here).pathname,
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['es2020'],
  charset: 'ascii',
  legalComments: 'none',
  banner: { js: banner },
  write: false,
});
// Inside a script element the text must not end it.
const script = js.outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
const style = `/* uPlot ${version('uplot')}, MIT licence: see the head of the script. */\n` + await text('node_modules/uplot/dist/uPlot.min.css') + '\n';

let differs = false;
for (const [name, made] of [['dist/viewer.js', script], ['dist/viewer.css', style]]) {
  const file = new URL(name, here);
  if (process.argv.includes('--check')) {
    const there = await readFile(file, 'utf8').catch(() => '');
    if (there !== made) {
      differs = true;
      console.error(`${name} is not what its sources make: run npm run build in viewer/`);
    }
  } else {
    await writeFile(file, made);
    console.log(`${name}: ${Math.round(made.length / 1000)} kB`);
  }
}
process.exit(differs ? 1 : 0);
