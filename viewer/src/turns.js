// The turns of a path, or the rows of two tools, that the plots show, and the axes over time of the
// same turns.
import { $, before } from './basics.js';
import { data, list } from './data.js';
import { cursor } from './cursor.js';
import { plot } from './plot.js';

export const turns = data.turns || [];
let axesPlots = [];
let shown = [];

/** Places of the turns chosen in the list; the page counts turns from 1. */
const chosen = () => {
  const every = $('count').value === 'all';
  const first = every ? 0 : Math.max(0, Math.min(+$('turn').value, turns.length) - 1);
  return turns.map((_, t) => t).slice(first, every ? turns.length : first + +$('count').value);
};

/** Where a turn begins along the plots, mm: ways from turn to turn may be left out. */
export const begins = t => turns[t].at ?? turns[t].from;

/** A field of the turns as one list, lifted for each of them. */
export const joined = (of, field, lift) => {
  const out = [];
  for (const t of of) for (const v of list(typeof field === 'function' ? field(turns[t]) : turns[t][field])) out.push(v + lift(t));
  return Float64Array.from(out);
};

/** The place of the path at a place along the plots of some turns. */
export const toPath = (of, x) => {
  const at = x + begins(of[0]);
  const t = of[before(of.map(begins), at)];
  return turns[t].from + at - begins(t);
};

/** The place along the plots of some turns of a place of the path. */
export const toPlot = (of, s) => {
  const t = of[before(of.map(t => turns[t].from), s)];
  return begins(t) - begins(of[0]) + Math.min(s - turns[t].from, turns[t].length);
};

const kinds = [['position', 'Position', ''], ['velocity', 'Velocity', '/s'], ['acceleration', 'Acceleration', '/s²'], ['jerk', 'Jerk', '/s³']];
const looks = ['solid', 'dash', 'dot'].flatMap(dash => ['c1', 'c2', 'c3', 'c4', 'c5', 'c6'].map(colour => ({ colour, dash })));

/**
 * Times and values of an axis over the turns, from the first turn's start: of `who`, and of the
 * kind `k`. What counts from each turn's start is lifted to the first one's.
 */
function over(ts, who, axis, k) {
  const A = data.axes;
  const x = [], y = [];
  const start = A.turns[ts[0]][who].from;
  let lift = 0;
  for (const t of ts) {
    const m = A.turns[t][who];
    const at = list(m.t), v = list(m.axes[axis][k]);
    if (k === 0 && axis === A.counted) lift = m.zero - A.turns[ts[0]][who].zero;
    for (let i = 0; i < at.length; i++) {
      const u = at[i] + m.from - start;
      if (x.length && !(u > x[x.length - 1])) continue;
      x.push(u); y.push(v[i] + lift);
    }
  }
  return [Float64Array.from(x), Float64Array.from(y)];
}

/** Colours of an axis: of this plan, of the other schedule, of its limit. */
const colours = [['c1', 'c2', 'c5'], ['c4', 'c3', 'c6']];

/** Curves of axes of one unit, those of the other schedule too, and the limits of the kind `k`. */
function ofSome(ts, which, k) {
  const A = data.axes;
  const series = [], limits = [];
  which.forEach((axis, n) => {
    const [own, fixed, most] = colours[n % colours.length];
    // Of several axes each has its name before that of the schedule.
    const called = what => (which.length > 1 ? `${A.names[axis]}, ${what}` : what);
    if (A.turns[ts[0]].baseline) {
      const [x, y] = over(ts, 'baseline', axis, k);
      series.push({ name: called(data.baseline), x, y, colour: fixed, dash: 'long' });
    }
    const [x, y] = over(ts, 'plan', axis, k);
    series.push({ name: called('this plan'), x, y, colour: own, width: 2 });
    if (k) limits.push({ name: called('limit'), limit: A.limits[axis][k - 1], colour: most });
  });
  return [series, limits];
}

/** Curves of all axes: positions from the start on, rates as shares of the limits. */
function ofAll(ts, k) {
  const A = data.axes;
  return [A.names.map((name, axis) => {
    const [x, y] = over(ts, 'plan', axis, k);
    return { name, x, y: k ? y.map(v => (100 * v) / A.limits[axis][k - 1]) : y.map(v => v - y[0]), ...looks[axis % looks.length] };
  }), [{ name: 'limit', limit: 100, colour: 'c5' }]];
}

function drawAxes() {
  const A = data.axes;
  if (!$('axis')) return;
  if (!A || !turns.length) { for (const [id] of kinds) $(`chart-${id}`).innerHTML = '<p class="empty">The run has no axis motion.</p>'; return; }
  const all = $('axis').value === 'all';
  const which = $('axis').value === 'rotary' ? A.rotary : [+$('axis').value || 0];
  const ts = $('whole').checked ? A.turns.map((_, t) => t) : chosen();
  const places = Float64Array.from(ts.flatMap(t => [...list(A.turns[t].s)]));
  const times = Float64Array.from(ts.flatMap(t => Array.from(list(A.turns[t].plan.t), v => v + A.turns[t].plan.from - A.turns[ts[0]].plan.from)));
  const to = t => places[before(times, t)];
  axesPlots = kinds.map(([id, name, per], k) => {
    const [series, limits] = all ? ofAll(ts, k) : ofSome(ts, which, k);
    if (k > 0 && $('limits').checked) {
      const x = Float64Array.from([0, times[times.length - 1]]);
      for (const { name, limit, colour } of limits) {
        for (const sign of [1, -1]) series.push({ name, x, y: Float64Array.from([sign * limit, sign * limit]), colour, dash: 'dot' });
      }
    }
    const of = all ? name : `${name} of ${which.map(axis => A.names[axis]).join(' and ')}`;
    const unit = all ? (k ? '% of the axis\' limit' : 'from the start, mm or °') : `${A.units[which[0]]}${per}`;
    const made = plot(`chart-${id}`, {
      x: 'time, s', y: all && !k ? `${of} ${unit}` : `${of}, ${unit}`, series,
      onMove: t => cursor.set(to(t), 'axes'), onPick: t => cursor.set(to(t), 'axes', true),
    });
    return made && { mark: s => made.mark(times[before(places, s)]) };
  });
  const notes = all ? [] : [
    which.includes(A.counted) ? `${A.names[A.counted]} counts from the start of the first turn shown.` : '',
    A.turns[ts[0]].baseline ? 'Each schedule has its own time.' : '',
  ];
  $('axes-note').textContent = notes.filter(Boolean).join(' ');
}

/** Which turns are shown, in words. */
const said = () => {
  const [first, last] = [shown[0] + 1, shown[shown.length - 1] + 1];
  return `${first}${last > first ? ` – ${last}` : ''} of ${turns.length}`;
};

/**
 * Begins: `draw(shown)` draws what is along the path of the turns shown, `mark(shown, s)` marks a
 * place of the path in it.
 */
export function start(draw, mark) {
  const few = turns.length < 2;
  for (const id of ['turn', 'turn-up', 'turn-down']) $(id).disabled = few;
  $('turn').max = Math.max(1, turns.length);
  $('turn').value = Math.floor(turns.length / 2) + 1;
  const A = data.axes;
  if (A && $('axis')) {
    const rotary = A.rotary.length > 1 ? [['rotary', A.rotary.map(i => A.names[i]).join(' and ')]] : [];
    // Where none goes round with the blade, all rotary axes move; two tools move all of them.
    const first = A.counted ?? (rotary.length && !data.scene.second ? 'rotary' : 'all');
    $('axis').innerHTML = [...A.names.map((n, i) => [i, n]), ...rotary, ['all', 'all axes']].map(([v, n]) => `<option value="${v}"${v === first ? ' selected' : ''}>${n}</option>`).join('');
  }
  const drawChosen = () => {
    shown = chosen();
    draw(shown);
    if (shown.length) $('turn-out').textContent = said();
  };
  const both = () => { drawChosen(); drawAxes(); };
  /** Goes to a turn, from 1; where all are shown, to that one alone. */
  const go = turn => {
    if ($('count').value === 'all') $('count').value = '1';
    $('turn').value = turn;
    both();
  };
  $('turn').addEventListener('input', () => go(+$('turn').value));
  $('count').addEventListener('change', both);
  for (const [id, by] of [['turn-down', -1], ['turn-up', 1]]) $(id).addEventListener('click', () => go(+$('turn').value + by));
  $('guide')?.addEventListener('change', drawChosen);
  for (const id of ['axis', 'limits', 'whole']) $(id)?.addEventListener('change', drawAxes);
  both();
  cursor.on((s, from, settle) => {
    if (!turns.length) return;
    const turn = before(turns.map(t => t.from), s);
    if (from !== 'channel' && from !== 'axes' && settle && !shown.includes(turn)) { $('turn').value = turn + 1; both(); }
    if (!shown.includes(turn)) return;
    mark(shown, s, from);
    if (from !== 'axes') for (const p of axesPlots) p?.mark(s);
  });
}
