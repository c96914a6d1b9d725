// Builds what is in dist from src and from the packages that package-lock.json pins: a script for
// the report, one for the page of a family, and the style that both have. `node build.mjs` writes
// them; `node build.mjs --check` compares with what is there and fails where it differs.
import { build } from 'esbuild';
import { readFile, writeFile } from 'node:fs/promises';

const here = new URL('.', import.meta.url);
const lock = JSON.parse(await readFile(new URL('package-lock.json', here), 'utf8'));
const text = async name => (await readFile(new URL(name, here), 'utf8')).trim();
const version = name => lock.packages[`node_modules/${name}`].version;

/** Packages and their names in words. */
const three = ['three', 'three.js'];
const uplot = ['uplot', 'uPlot'];

/** What stands at the head of a script: what it is, what is in it, and the licences of that. */
const banner = async (page, packages) => [
  `/*! The script of bladewright's ${page}: sources in viewer/src, built by \`npm ci && npm run build\` in viewer/.`,
  `In it: ${packages.map(([name, word]) => `${word} ${version(name)} (npm package ${name})`).join(' and ')}, ${packages.length > 1 ? 'both ' : ''}under the MIT licence${packages.length > 1 ? ':' : '.'}`,
  ...(await Promise.all(packages.map(async ([name, word]) => ['', `${word}:`, await text(`node_modules/${name}/LICENSE`)]))).flat(),
  '*/',
].join('\n');

async function script(entry, page, packages) {
  const js = await build({
    entryPoints: [new URL(entry, here).pathname],
    absWorkingDir: new URL('.', here).pathname,
    bundle: true,
    minify: true,
    format: 'iife',
    target: ['es2020'],
    charset: 'ascii',
    legalComments: 'none',
    banner: { js: await banner(page, packages) },
    write: false,
  });
  // Inside a script element the text must not end it.
  return js.outputFiles[0].text.replaceAll('</script', '<\\/script').replaceAll('<!--', '<\\!--');
}

const style = [`/* uPlot ${version('uplot')}, MIT licence: see the head of the script. */`, await text('node_modules/uplot/dist/uPlot.min.css'), await text('src/page.css'), ''].join('\n');

let differs = false;
for (const [name, made] of [
  ['dist/viewer.js', await script('src/boot.js', 'report.html', [three, uplot])],
  ['dist/family.js', await script('src/family.js', 'family.html', [uplot])],
  ['dist/viewer.css', style],
]) {
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
