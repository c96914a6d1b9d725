// Plane sections: outline and curvature.
import { $, show } from './basics.js';
import { data, list } from './data.js';
import { plot } from './plot.js';

const all = data.sections || [];

function draw() {
  const section = all[+$('section').value];
  if (!section?.loops.length) { for (const id of ['chart-section', 'chart-curvature']) $(id).innerHTML = '<p class="empty">No sections.</p>'; return; }
  const extent = { x: [Infinity, -Infinity], y: [Infinity, -Infinity] };
  const outlines = section.loops.map(l => {
    const [y, z] = [list(l.y), list(l.z)];
    for (const [v, e] of [[y, extent.x], [z, extent.y]]) for (const q of v) { e[0] = Math.min(e[0], q); e[1] = Math.max(e[1], q); }
    return [y, z];
  });
  // Outlines are no functions of y, so they are drawn by hand over an empty plot.
  const corner = [extent.x, extent.y];
  const [loop] = section.loops;
  const mark = (c, u, y, z, colour, into) => {
    const [a, b] = [u.valToPos(y, 'x', true), u.valToPos(z, 'y', true)];
    const r = 5 * devicePixelRatio;
    c.beginPath();
    if (into) { c.moveTo(a, b - r); c.lineTo(a + r, b); c.lineTo(a, b + r); c.lineTo(a - r, b); c.closePath(); } else c.arc(a, b, 0.8 * r, 0, 7);
    c.fillStyle = colour; c.fill();
  };
  const style = name => getComputedStyle(document.documentElement).getPropertyValue(name);
  const point = (l, s) => { const at = list(l.s); let k = 0; for (let i = 0; i < at.length; i++) if (at[i] <= s) k = i; return [list(l.y)[k], list(l.z)[k]]; };
  plot('chart-section', {
    x: 'y, mm', y: 'z, mm', equal: true, extent,
    legend: () => '<span class="key"><i style="background:var(--c2)"></i>into concave</span><span class="key"><i style="background:var(--c4)"></i>into convex</span><span class="key"><i style="background:var(--text)"></i>edges</span>',
    series: [{ name: 'corners', x: Float64Array.from(corner[0]), y: Float64Array.from(corner[1]), colour: 'panel', quiet: true, width: 0 }],
    draw: (u, c) => {
      c.save(); c.lineWidth = 2 * devicePixelRatio;
      outlines.forEach(([y, z], k) => {
        c.beginPath();
        y.forEach((v, i) => c[i ? 'lineTo' : 'moveTo'](u.valToPos(v, 'x', true), u.valToPos(z[i], 'y', true)));
        c.closePath(); c.strokeStyle = style(k ? '--soft' : '--c1'); c.stroke();
      });
      for (const l of section.loops) for (const [y, z, , into] of l.altered) mark(c, u, y, z, style(into ? '--c2' : '--c4'), into);
      for (const s of [loop.le, loop.te]) if (s != null) { const [y, z] = point(loop, s); mark(c, u, y, z, style('--text'), false); }
      c.restore();
    },
  });
  plot('chart-curvature', {
    x: 'arc length, mm', y: 'curvature, 1/mm',
    series: [{ name: 'curvature', x: list(loop.s), y: list(loop.k), colour: 'c1' }, { name: 'altered points', x: Float64Array.from(loop.altered, a => a[2]).sort(), y: new Float64Array(loop.altered.length), colour: 'c2', marks: true }],
  });
  $('section-out').textContent = `${show(section.x)} mm; chord ${show(loop.chord)}, thickness ${show(loop.thickness)} mm`;
}

export function start() {
  $('section').max = Math.max(0, all.length - 1);
  $('section').value = Math.floor(all.length / 2);
  $('section').addEventListener('input', draw);
  draw();
}
