// uPlot as this page wants it: theme, legend that switches, keyboard, values under the cursor, place shared with the 3-D view.
import uPlot from 'uplot';
import { $, minus, show } from './data.js';

/** The plots by their boxes. */
export const plots = new Map();
const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const dashes = { solid: [], dash: [7, 4], dot: [2, 3], long: [13, 4] };

/** Draws all plots anew, for another theme or width. */
export const redrawAll = () => { for (const f of [...plots.values()]) f.redraw(); };

const ticks = (u, values) => {
  const step = values.length > 1 ? Math.abs(values[1] - values[0]) : 1;
  // As many digits as the step has: 2.5 needs one.
  let digits = 0;
  while (digits < 6 && Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-6 * step * 10 ** digits) digits++;
  return values.map(v => minus(v.toFixed(digits)));
};

/**
 * A plot in a box.
 * spec: {x: label, y: label, series: [{name, x, y, colour, dash, width, fill, bars, marks, steps}], band: [i, j], equal,
 *        onMove(x), onPick(x), draw(u, context), legend()}; series may have lists of x of their own.
 */
export function plot(id, spec) {
  const box = $(id);
  const hidden = plots.get(id)?.hidden || new Set();
  const old = plots.get(id);
  old?.u?.destroy();
  const series = spec.series.filter(s => s.y.length && s.y.some(v => v != null && v === v));
  if (!series.length) {
    box.innerHTML = '<p class="empty">Nothing to show.</p>';
    plots.delete(id);
    return null;
  }
  box.innerHTML = '<div class="legend"></div><div class="canvas" tabindex="0" role="img"></div><p class="readout" aria-live="polite"></p>';
  const holder = box.querySelector('.canvas');
  const out = box.querySelector('.readout');
  const label = `${spec.y} over ${spec.x}: ${[...new Set(series.map(s => s.name))].join(', ')}.`;
  holder.setAttribute('aria-label', `${label} Arrow keys read values.`);
  const nulls = list => Array.from(list, v => (v === v ? v : null));
  const tables = series.map(s => [Array.from(s.x), nulls(s.y)]);
  const same = series.every(s => s.x === series[0].x);
  const values = same ? [tables[0][0], ...tables.map(t => t[1])] : uPlot.join(tables, tables.map(() => [1, 1]));
  const gaps = !same;
  const width = Math.max(240, box.clientWidth || 600);
  const height = spec.equal ? Math.round(Math.min(width * 0.75, 420)) : Math.round(Math.max(210, Math.min(width * 0.42, 340)));
  const axis = { stroke: style('--soft'), grid: { stroke: style('--line'), width: 1 }, ticks: { stroke: style('--line'), width: 1 }, font: '12px system-ui', labelFont: '12px system-ui' };
  const row = s => ({
    label: s.name,
    show: !hidden.has(s.name),
    stroke: style(`--${s.colour}`) || s.colour,
    width: s.marks ? 0 : s.width || 1.5,
    dash: dashes[s.dash || 'solid'],
    fill: s.fill,
    spanGaps: gaps,
    points: s.marks ? { show: true, size: 8, fill: style(`--${s.colour}`), width: 1, stroke: style('--bg') } : { show: false },
    paths: s.marks ? () => null : s.bars ? uPlot.paths.bars({ size: [1], align: 1 }) : undefined,
  });
  const range = spec.range || {};
  const frame = (u, lo, hi, pad) => {
    if (lo == null || hi == null) return [0, 1];
    const more = hi > lo ? pad * (hi - lo) : Math.max(1, 0.05 * Math.abs(hi));
    return [lo - more, hi + more];
  };
  const onEqual = (u, key, lo, hi) => {
    const [w, h] = [u.bbox.width || 1, u.bbox.height || 1];
    const other = key === 'x' ? spec.extent.y : spec.extent.x;
    const own = spec.extent[key];
    const [a, b] = key === 'x' ? [w, h] : [h, w];
    const unit = 1.06 * Math.max((own[1] - own[0]) / a, (other[1] - other[0]) / b);
    const mid = (own[0] + own[1]) / 2;
    return [mid - 0.5 * unit * a, mid + 0.5 * unit * a];
  };
  let moved = false;
  const u = new uPlot({
    width, height,
    padding: [8, 12, 0, 0],
    legend: { show: false },
    scales: {
      x: { time: false, range: spec.equal ? (u, lo, hi) => onEqual(u, 'x', lo, hi) : range.x || ((u, lo, hi) => frame(u, lo, hi, 0)) },
      y: { range: spec.equal ? (u, lo, hi) => onEqual(u, 'y', lo, hi) : range.y || ((u, lo, hi) => frame(u, lo, hi, 0.05)) },
    },
    series: [{ label: spec.x }, ...series.map(row)],
    bands: (spec.bands || []).map(([a, b]) => [series.findIndex(s => s.key === a) + 1, series.findIndex(s => s.key === b) + 1])
      .filter(([a, b]) => a && b).map(([a, b]) => ({ series: [a, b], fill: style('--fill') })),
    axes: [{ ...axis, label: spec.x, labelSize: 18, size: 34, values: ticks }, { ...axis, label: spec.y, labelSize: 18, size: 52, values: ticks }],
    cursor: { points: { size: 7 }, drag: { x: !spec.equal, y: false, uni: 20 }, focus: { prox: spec.equal ? 30 : -1 } },
    hooks: {
      draw: [u => spec.draw?.(u, u.ctx)],
      setCursor: [u => {
        const i = u.cursor.idx;
        if (i == null || u.cursor.left < 0) { out.textContent = ''; return; }
        const x = u.data[0][i];
        const said = new Map();
        series.forEach((s, k) => {
          if (!u.series[k + 1].show || s.quiet) return;
          let v = u.data[k + 1][i];
          // A list with places of its own has the nearest of them, as far as it goes.
          if (v == null && !same && !s.marks && x >= s.x[0] && x <= s.x[s.x.length - 1]) v = s.y[nearest(s.x, x)];
          if (v != null && v === v) said.set(s.name, [...(said.get(s.name) || []), v]);
        });
        const words = [...said].map(([name, values]) => `${name} ${values.map(show).join(' to ')}`);
        out.textContent = `${spec.x} ${show(x)}: ${words.join(' · ')}${spec.more ? spec.more(i, x) : ''}`;
        if (moved) spec.onMove?.(x, i);
      }],
    },
  }, values, holder);
  const over = u.over;
  over.addEventListener('pointermove', () => { moved = true; });
  over.addEventListener('pointerleave', () => { moved = false; });
  over.addEventListener('click', () => { if (u.cursor.idx != null) spec.onPick?.(u.data[0][u.cursor.idx], u.cursor.idx); });
  over.addEventListener('dblclick', () => u.setData(values, true));
  const go = i => {
    const n = values[0].length;
    const k = Math.max(0, Math.min(n - 1, i));
    moved = true;
    const y = u.data.slice(1).map(list => list[k]).find(v => v != null);
    u.setCursor({ left: u.valToPos(values[0][k], 'x'), top: u.valToPos(y ?? 0, 'y') });
    moved = false;
  };
  holder.addEventListener('keydown', e => {
    const now = u.cursor.idx ?? 0;
    const by = { ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10 }[e.key];
    if (by) go(now + by);
    else if (e.key === 'Home') go(0);
    else if (e.key === 'End') go(values[0].length - 1);
    else if (e.key === 'Enter' && u.cursor.idx != null) spec.onPick?.(u.data[0][u.cursor.idx], u.cursor.idx);
    else return;
    e.preventDefault();
  });
  const keys = box.querySelector('.legend');
  if (spec.legend) keys.innerHTML = spec.legend();
  for (const name of new Set(series.filter(s => !s.quiet).map(s => s.name))) {
    const s = series.find(q => q.name === name);
    const b = document.createElement('button');
    b.type = 'button';
    b.setAttribute('aria-pressed', String(!hidden.has(name)));
    const c = style(`--${s.colour}`) || s.colour;
    const dash = dashes[s.dash || 'solid'].join(' ');
    b.innerHTML = s.marks
      ? `<svg aria-hidden="true" viewBox="0 0 26 12"><circle cx="13" cy="6" r="4.5" fill="${c}"/></svg>`
      : `<svg aria-hidden="true" viewBox="0 0 26 12"><path d="M1 6H25" stroke="${c}" stroke-width="${s.bars ? 8 : 2.5}" stroke-dasharray="${dash}"/></svg>`;
    b.append(name);
    b.addEventListener('click', () => {
      if (hidden.has(name)) hidden.delete(name);
      else hidden.add(name);
      b.setAttribute('aria-pressed', String(!hidden.has(name)));
      series.forEach((q, k) => { if (q.name === name) u.setSeries(k + 1, { show: !hidden.has(name) }); });
    });
    keys.append(b);
  }
  const entry = { u, hidden, redraw: () => plot(id, spec) };
  plots.set(id, entry);
  return {
    u,
    /** Shows the place of x without moving anything else. */
    mark(x) {
      // A plot that was just made has its scales at the end of this task.
      if (!u.status) { queueMicrotask(() => u.status && this.mark(x)); return; }
      if (!(x >= values[0][0] && x <= values[0][values[0].length - 1])) { u.setCursor({ left: -10, top: -10 }); return; }
      moved = false;
      u.setCursor({ left: u.valToPos(x, 'x'), top: 10 });
    },
  };
}

function nearest(xs, x) {
  let best = 0;
  for (let i = 1; i < xs.length; i++) if (Math.abs(xs[i] - x) < Math.abs(xs[best] - x)) best = i;
  return best;
}
