// The charts of all pages, on uPlot: theme, legend that switches, keyboard, values under the
// pointer.
import uPlot from 'uplot';
import { $, before, minus, show } from './basics.js';

/** The plots by their boxes. */
export const plots = new Map();
const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
const colourOf = s => style(`--${s.colour}`) || s.colour;
/** Colours have six digits; two more make them pale. */
const pale = name => `${style(`--${name}`)}22`;
const dashes = { solid: [], dash: [7, 4], dot: [2, 3], long: [13, 4] };
/** Farthest from the pointer that a point answers, px. */
const REACH = 24;

/** Draws all plots anew, for another theme or width. */
export const redrawAll = () => { for (const f of [...plots.values()]) f.redraw(); };

const ticks = (u, values) => {
  const step = values.length > 1 ? Math.abs(values[1] - values[0]) : 1;
  // As many digits as the step has: 2.5 needs one.
  let digits = 0;
  while (digits < 7 && Math.abs(step * 10 ** digits - Math.round(step * 10 ** digits)) > 1e-6 * step * 10 ** digits) digits++;
  return values.map(v => minus(digits < 7 ? v.toFixed(digits) : +v.toPrecision(4)));
};

/** Room for the numbers beside the y axis, px: more where they are long. */
const room = (u, values) => Math.max(52, 20 + 7 * Math.max(0, ...(values || []).map(v => v.length)));

/** How a series is drawn. */
const lineOf = (s, spec) => {
  const size = spec.points ? 10 : 8;
  const dot = s.hollow ? { fill: style('--bg'), width: 2.5, stroke: colourOf(s) } : { fill: colourOf(s), width: 1, stroke: style('--bg') };
  return {
    label: s.name,
    stroke: colourOf(s),
    width: s.marks ? 0 : s.width || 1.5,
    dash: dashes[s.dash || 'solid'],
    fill: s.bars ? `${colourOf(s)}59` : undefined,
    points: s.marks ? { show: true, size, ...dot } : { show: false },
    paths: s.marks ? () => null : s.bars ? uPlot.paths.bars({ size: [1], align: 1 }) : undefined,
  };
};

/** What a scale shows: what the plot asks for, or all values and a little more on either side. */
const rangeOf = (spec, key) => {
  if (spec.equal) return u => onEqual(u, spec.extent, key);
  const pad = key === 'x' && !spec.points ? 0 : 0.05;
  return spec.range?.[key] || ((u, lo, hi) => {
    if (lo == null || hi == null) return [0, 1];
    const more = hi > lo ? pad * (hi - lo) : Math.max(1, 0.05 * Math.abs(hi));
    return [lo - more, hi + more];
  });
};

/** The same length of a unit on both scales. */
const onEqual = (u, extent, key) => {
  const [w, h] = [u.bbox.width || 1, u.bbox.height || 1];
  const [own, other] = key === 'x' ? [extent.x, extent.y] : [extent.y, extent.x];
  const [a, b] = key === 'x' ? [w, h] : [h, w];
  const unit = 1.06 * Math.max((own[1] - own[0]) / a, (other[1] - other[0]) / b);
  const mid = (own[0] + own[1]) / 2;
  return [mid - 0.5 * unit * a, mid + 0.5 * unit * a];
};

/** Puts a tip beside a place of the plot, on the side where there is more room. */
function putBeside(tip, u, left, top) {
  const [w, h] = [u.over.clientWidth, u.over.clientHeight];
  const across = left < w / 2 ? { left: left + 10 } : { right: w - left + 10 };
  const along = top < h / 2 ? { top: top + 10 } : { bottom: h - top + 10 };
  const px = { ...across, ...along };
  for (const side of ['left', 'right', 'top', 'bottom']) tip.style[side] = side in px ? `${px[side]}px` : 'auto';
}

/** The legend, whose buttons switch series on and off. */
function switches(keys, spec, series, hidden, u) {
  if (spec.legend) keys.innerHTML = spec.legend();
  for (const name of new Set(series.filter(s => !s.quiet).map(s => s.name))) {
    const s = series.find(q => q.name === name);
    const b = document.createElement('button');
    b.type = 'button';
    b.setAttribute('aria-pressed', String(!hidden.has(name)));
    const c = colourOf(s);
    const dash = dashes[s.dash || 'solid'].join(' ');
    b.innerHTML = s.marks
      ? `<svg aria-hidden="true" viewBox="0 0 26 12"><circle cx="13" cy="6" r="4" fill="${s.hollow ? 'none' : c}" stroke="${c}" stroke-width="2"/></svg>`
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
}

/**
 * A plot in a box.
 * spec: {x: label, y: label,
 *        series: [{name, x, y, colour, dash, width, bars, marks, hollow, quiet}],
 *        bands: [[key, key, colour]], range, equal, extent, points, tip, say(rows, x),
 *        onMove(x, row), onPick(x, row), draw(u, context), legend()}
 * Series may have lists of x of their own, each in rising order. `bars` stand from their x to the
 * next. `marks` are points without a line, `hollow` ones are rings. With `points` the mark nearest
 * to the pointer answers, in both directions; rows that lie on one another answer together. With
 * `tip` its words stand beside it too. `say` gives the words, where they are not the values of all
 * series at a place.
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
  const width = Math.max(240, box.clientWidth || 600);
  const height = spec.equal ? Math.round(Math.min(width * 0.75, 420)) : Math.round(Math.max(210, Math.min(width * 0.42, 340)));
  const axis = { stroke: style('--soft'), grid: { stroke: style('--line'), width: 1 }, ticks: { stroke: style('--line'), width: 1 }, font: '12px system-ui', labelFont: '12px system-ui' };

  // Bars answer up to the next one, and the last place is only the end of the last bar.
  const bars = same && series.every(s => s.bars);
  const last = values[0].length - (bars ? 2 : 1);
  // The row that answers. The keyboard names it; otherwise it is the one under the pointer.
  let moved = false;
  let asked = null;
  let here = null;
  const heightOf = (u, i) => u.data.slice(1).find((list, k) => u.series[k + 1].show && list[i] != null)?.[i];
  const away = (u, i, left, top) => {
    const y = heightOf(u, i);
    return y == null ? Infinity : Math.hypot(u.valToPos(u.data[0][i], 'x') - left, u.valToPos(y, 'y') - top);
  };
  const find = (u, idx) => {
    const { left, top } = u.cursor;
    if (idx == null || left < 0) return null;
    if (asked != null) return asked;
    if (spec.points) {
      let [best, least] = [null, REACH];
      u.data[0].forEach((_, i) => {
        const d = away(u, i, left, top);
        if (d < least) [best, least] = [i, d];
      });
      return best;
    }
    return Math.min(last, before(u.data[0], u.posToVal(left, 'x')));
  };
  // uPlot itself takes the nearest x. It asks for the places of all series, that of x first, before
  // it reports the pointer.
  const own = spec.points || bars;
  const dataIdx = (u, k, idx) => {
    if (k === 0) here = find(u, idx);
    return k === 0 ? idx : here != null && u.data[k][here] != null ? here : null;
  };
  /** The row and all that are drawn on it. */
  const together = (u, i) => {
    if (!spec.points) return [i];
    const at = [u.valToPos(u.data[0][i], 'x'), u.valToPos(heightOf(u, i), 'y')];
    return [i, ...u.data[0].keys()].filter((k, n) => n === 0 || (k !== i && away(u, k, ...at) < 1));
  };
  const words = (u, i) => {
    const x = u.data[0][i];
    if (spec.say) return spec.say(together(u, i), x);
    const said = new Map();
    series.forEach((s, k) => {
      if (!u.series[k + 1].show || s.quiet) return;
      let v = u.data[k + 1][i];
      // A list with places of its own has the nearest of them, as far as it goes.
      if (v == null && !same && !s.marks && x >= s.x[0] && x <= s.x[s.x.length - 1]) v = s.y[s.bars ? before(s.x, x) : nearest(s.x, x)];
      if (v != null && v === v) said.set(s.name, [...(said.get(s.name) || []), v]);
    });
    return `${spec.x} ${show(x)}: ${[...said].map(([name, list]) => `${name} ${list.map(show).join(' to ')}`).join(' · ')}`;
  };
  const tip = document.createElement('p');
  tip.className = 'tip';
  tip.hidden = true;
  const tell = u => {
    out.textContent = here == null ? '' : words(u, here);
    u.over.style.cursor = here != null && spec.onPick ? 'pointer' : '';
    if (!spec.tip) return;
    tip.hidden = here == null;
    if (here == null) return;
    tip.textContent = out.textContent;
    putBeside(tip, u, u.valToPos(u.data[0][here], 'x'), u.valToPos(heightOf(u, here) ?? 0, 'y'));
  };

  const u = new uPlot({
    width, height,
    padding: [8, 12, 0, 0],
    legend: { show: false },
    scales: { x: { time: false, range: rangeOf(spec, 'x') }, y: { range: rangeOf(spec, 'y') } },
    series: [{ label: spec.x }, ...series.map(s => ({ ...lineOf(s, spec), show: !hidden.has(s.name), spanGaps: !same }))],
    bands: (spec.bands || []).map(([a, b, colour]) => [series.findIndex(s => s.key === a) + 1, series.findIndex(s => s.key === b) + 1, colour])
      .filter(([a, b]) => a && b).map(([a, b, colour]) => ({ series: [a, b], fill: colour ? pale(colour) : style('--fill') })),
    axes: [{ ...axis, label: spec.x, labelSize: 18, size: 34, values: ticks }, { ...axis, label: spec.y, labelSize: 18, size: room, values: ticks }],
    cursor: {
      points: { size: 7, show: !series.some(s => s.bars) },
      drag: { x: !spec.equal, y: false, uni: 20 },
      focus: { prox: spec.equal ? 30 : -1 },
      ...(own && { dataIdx }),
    },
    hooks: {
      draw: [u => spec.draw?.(u, u.ctx)],
      setCursor: [u => {
        if (!own) here = u.cursor.idx;
        if (u.cursor.idx == null || u.cursor.left < 0) here = null;
        tell(u);
        if (moved && here != null) spec.onMove?.(u.data[0][here], here);
      }],
    },
  }, values, holder);
  const over = u.over;
  if (spec.tip) over.append(tip);
  const pick = () => { if (here != null) spec.onPick?.(u.data[0][here], here); };
  over.addEventListener('pointermove', () => { moved = true; });
  over.addEventListener('pointerleave', () => { moved = false; });
  over.addEventListener('click', pick);
  over.addEventListener('dblclick', () => u.setData(values, true));
  /** Reads a row, or the next one that way where something is shown. */
  const go = (i, way) => {
    asked = Math.max(0, Math.min(last, i));
    while (heightOf(u, asked) == null && asked + way >= 0 && asked + way <= last) asked += way;
    moved = true;
    u.setCursor({ left: u.valToPos(values[0][asked], 'x'), top: u.valToPos(heightOf(u, asked) ?? 0, 'y') });
    moved = false;
    asked = null;
  };
  holder.addEventListener('keydown', e => {
    const by = { ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10 }[e.key];
    // The first key reads the first place.
    if (by) go(here == null ? 0 : here + by, Math.sign(by));
    else if (e.key === 'Home') go(0, 1);
    else if (e.key === 'End') go(last, -1);
    else if (e.key === 'Enter' && here != null) pick();
    else return;
    e.preventDefault();
  });
  switches(box.querySelector('.legend'), spec, series, hidden, u);
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
