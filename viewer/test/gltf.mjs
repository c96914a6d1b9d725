// preview.glb: `node test/gltf.mjs FILE…`: Khronos' validator finds no error and no warning, and
// three.js in headless Chromium loads all of it, finds every node and plays every animation.
import assert from 'node:assert/strict';
import { build } from 'esbuild';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { pathToFileURL } from 'node:url';
import validator from 'gltf-validator';
import { launch, open } from './browser.mjs';

const loader = await build({
  stdin: {
    contents: `
      import { AnimationMixer, Vector3 } from 'three';
      import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
      globalThis.probe = async text => {
        const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
        const g = await new GLTFLoader().parseAsync(bytes.buffer, '');
        const names = [];
        let onMeshes = 0, meshes = 0, lines = 0, triangles = 0;
        g.scene.traverse(n => {
          names.push(n.userData.name || n.name);
          if (n.isMesh) { meshes++; triangles += (n.geometry.index?.count ?? n.geometry.attributes.position.count) / 3; }
          if (n.isLine) lines++;
          if (n.isMesh && n.userData.gltfExtensions?.KHR_materials_variants) onMeshes++;
        });
        const motions = [];
        for (const clip of g.animations) {
          const mixer = new AnimationMixer(g.scene);
          mixer.clipAction(clip).play();
          const places = ['workpiece', 'tool'].map(name => g.scene.getObjectByName(name));
          const at = share => { mixer.setTime(share * clip.duration); g.scene.updateMatrixWorld(true); return places.map(p => [...p.matrixWorld.elements]); };
          const [a, b] = [at(0), at(0.37)];
          motions.push({ name: clip.name, duration: clip.duration, moved: a.map((m, k) => Math.max(...m.map((v, i) => Math.abs(v - b[k][i])))), finite: b.flat().every(Number.isFinite) });
          mixer.stopAllAction();
        }
        const variants = (g.userData.gltfExtensions?.KHR_materials_variants?.variants || []).map(v => v.name);
        return { names, meshes, lines, triangles, motions, variants, onMeshes };
      };`,
    resolveDir: new URL('..', import.meta.url).pathname,
  },
  bundle: true, format: 'iife', write: false, minify: true,
});
const dir = mkdtempSync(join(tmpdir(), 'bladewright-gltf-'));
const html = join(dir, 'probe.html');
writeFileSync(html, `<!doctype html><meta charset="utf-8"><link rel="icon" href="data:,"><script>${loader.outputFiles[0].text.replaceAll('</script', '<\\/script')}</script>`);

const browser = await launch();
try {
  for (const file of process.argv.slice(2)) {
    const bytes = readFileSync(file);
    const { issues } = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: 50 });
    const bad = issues.messages.filter(m => m.severity < 2);
    assert.deepEqual(bad, [], `${file}: ${bad.length} errors and warnings`);
    const { page, bad: wrong } = await open(browser, pathToFileURL(html).href);
    const found = await page.evaluate(text => probe(text), bytes.toString('base64'));
    for (const name of ['workpiece', 'blade', 'path', 'leads', 'cutter contacts', 'channel', 'base vectors', 'table', 'tool', 'ball', 'shank', 'head']) {
      assert.ok(found.names.includes(name), `${file}: no node ${name}`);
    }
    const isOne = /^\[wheel\]/m.test(readFileSync(join(dirname(file), 'job.resolved.toml'), 'utf8'));
    assert.equal(found.names.includes('neighbours'), isOne, `${file}: the rest of the wheel`);
    assert.equal(found.variants.length, 6, `${file}: variants`);
    // Viewers offer variants of meshes alone.
    assert.ok(found.onMeshes > 0, `${file}: no mesh has variants`);
    assert.equal(found.motions.length, 2, `${file}: animations`);
    const [fixed, machine] = found.motions;
    assert.ok(fixed.finite && machine.finite && fixed.duration > 0 && machine.duration > 0);
    assert.ok(fixed.moved[0] < 1e-9 && fixed.moved[1] > 1e-6, `${file}: with the part fixed only the tool moves: ${fixed.moved}`);
    assert.ok(machine.moved[0] > 1e-6, `${file}: on the machine the part turns: ${machine.moved}`);
    assert.deepEqual(wrong, []);
    await page.close();
    console.log(`${file}: ${(bytes.length / 1e6).toFixed(2)} MB, ${Math.round(found.triangles)} triangles, ${found.lines} lines, ${issues.numInfos} remarks; ${found.motions.map(m => `${m.name} (${m.duration.toFixed(1)} s)`).join(', ')}`);
  }
} finally {
  await browser.close();
}
