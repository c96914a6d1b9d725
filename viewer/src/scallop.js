// How often which scallop occurs, and where.
import { $, show } from './basics.js';
import { data, list } from './data.js';
import { colourOf, css, legend, shareOf } from './colour.js';
import { cursor } from './cursor.js';
import { plot } from './plot.js';

const S = data.scallop;

export function drawHistogram() {
  if (!S?.histogram) { $('chart-histogram').innerHTML = '<p class="empty">Nothing was measured.</p>'; return; }
  const h = S.histogram;
  const edge = k => 1000 * (h.from + k * h.step);
  const n = h.samples.length;
  const x = Float64Array.from({ length: n + 1 }, (_, k) => edge(k));
  const share = list => { const all = list.reduce((a, b) => a + b, 0) || 1; return Float64Array.from([...list, 0], v => (100 * v) / all); };
  const outline = uneven(share(h.ridges), x);
  plot('chart-histogram', {
    x: 'height, µm', y: 'share, %',
    series: [
      { name: 'surface', x, y: share(h.samples), colour: 'c1', bars: true, width: 1 },
      { name: 'ridges', x: outline[0], y: outline[1], colour: 'c2', width: 2 },
    ],
    range: { y: (u, lo, hi) => [0, 1.08 * (hi || 1)] },
    draw: (u, c) => {
      if (!S.asked) return;
      const at = u.valToPos(1000 * S.asked, 'x', true);
      c.save(); c.strokeStyle = getComputedStyle(document.documentElement).getPropertyValue('--text'); c.setLineDash([6, 4]); c.lineWidth = 1.5 * devicePixelRatio;
      c.beginPath(); c.moveTo(at, u.bbox.top); c.lineTo(at, u.bbox.top + u.bbox.height); c.stroke(); c.restore();
    },
  });
}

/** Steps along the bars' tops. */
function uneven(y, x) {
  const [xs, ys] = [[], []];
  for (let k = 0; k + 1 < x.length; k++) { xs.push(x[k] + 1e-6, x[k + 1] - 1e-6); ys.push(y[k], y[k]); }
  return [Float64Array.from(xs), Float64Array.from(ys)];
}

/** The legend of the map, here and in the 3-D view. */
export const mapLegend = () => legend('scallop on the surface', 'µm', ...[S.map.range, S.map.shown].map(r => r.map(v => 1000 * v)), false);

export function drawMap() {
  const box = $('chart-map');
  if (!S?.map || !list(S.map.height).length) { box.innerHTML = '<p class="empty">Nothing was measured.</p>'; return; }
  const [height, x, round, s] = ['height', 'x', 'round', 's'].map(k => list(S.map[k]));
  // By the percentage of the way round; order by it, as the plot wants.
  const order = Array.from(round.keys()).filter(i => round[i] === round[i]).sort((a, b) => round[a] - round[b]);
  const range = S.map.shown.map(v => 1000 * v);
  plot('chart-map', {
    x: 'way round the turn, %', y: 'height along the blade, mm',
    series: [{ name: 'scallop', x: Float64Array.from(order, i => round[i]), y: Float64Array.from(order, i => x[i]), colour: 'soft', marks: true, quiet: true }],
    legend: () => `<div class="scale inline">${mapLegend()}</div>`,
    points: true,
    onMove: (_, i) => cursor.set(s[order[i]], 'map'), onPick: (_, i) => cursor.set(s[order[i]], 'map', true),
    say: ([i], share) => `way round the turn ${show(share)} %: ${show(1000 * height[order[i]])} µm at height ${show(x[order[i]])} mm`,
    draw: (u, c) => {
      c.save();
      const r = 2.2 * devicePixelRatio;
      c.beginPath(); c.rect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height); c.clip();
      c.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--panel'); c.fillRect(u.bbox.left, u.bbox.top, u.bbox.width, u.bbox.height);
      for (let i = 0; i < height.length; i++) {
        if (round[i] !== round[i]) continue;
        c.fillStyle = css(colourOf(shareOf(1000 * height[i], range)));
        c.fillRect(u.valToPos(round[i], 'x', true) - r, u.valToPos(x[i], 'y', true) - r, 2 * r, 2 * r);
      }
      c.restore();
    },
  });
}
