// S–θ plot of the turns chosen, and the axes over time of the same turns.
import { $, before, show } from './basics.js';
import { data, list } from './data.js';
import { cursor } from './cursor.js';
import { plot } from './plot.js';

const turns = data.turns || [];
const count = () => +$('count').value;
let channel = null;
let axesPlots = [];
let shown = [];

/** Places of the turns chosen in the list; the page counts turns from 1. */
const chosen = () => {
  const first = Math.max(0, Math.min(+$('turn').value, turns.length) - 1);
  return turns.map((_, t) => t).slice(first, first + count());
};

/** A field of the turns shown as one list, lifted by each turn's start and angle. */
const joined = (field, lift) => {
  const out = [];
  for (const t of shown) for (const v of list(typeof field === 'function' ? field(turns[t]) : turns[t][field])) out.push(v + lift(t));
  return Float64Array.from(out);
};

export function drawChannel() {
  shown = chosen();
  if (!shown.length) { $('chart-channel').innerHTML = '<p class="empty">The run has no channel.</p>'; return; }
  const [first] = shown;
  const angle = t => turns[t].zero - turns[first].zero;
  const x = joined('s', t => turns[t].from - turns[first].from);
  const end = shown[shown.length - 1];
  const total = turns[end].from + turns[end].length - turns[first].from;
  const rise = turns[end + 1] ? turns[end + 1].zero - turns[first].zero : [...list(turns[end].theta)].pop() + angle(end);
  const slope = $('guide').checked && total > 0 ? rise / total : 0;
  const curve = field => joined(field, angle).map((v, i) => v - slope * x[i]);
  const names = data.others || [];
  const looks = [['c2', 'long'], ['c4', 'dash'], ['c5', 'dot'], ['c4', 'long'], ['c2', 'dot']];
  const series = [
    { key: 'min', name: 'true channel', x, y: curve('min'), colour: 'c1' },
    { key: 'max', name: 'true channel', x, y: curve('max'), colour: 'c1' },
    { name: 'monotone hull', x, y: curve('hull_min'), colour: 'c3', dash: 'dash' },
    { name: 'monotone hull', x, y: curve('hull_max'), colour: 'c3', dash: 'dash' },
    { name: 'tangent channel', x, y: curve('tangent_min'), colour: 'c6', dash: 'dot' },
    { name: 'tangent channel', x, y: curve('tangent_max'), colour: 'c6', dash: 'dot' },
    ...names.map((name, k) => ({ name, x, y: curve(t => t.others[k]), colour: looks[k % looks.length][0], dash: looks[k % looks.length][1] })),
    { name: `schedule (${data.schedule})`, x, y: curve('theta'), colour: 'c0', width: 2.5 },
  ];
  const keys = shown.flatMap(t => turns[t].keys.map(([s, v]) => [s + turns[t].from - turns[first].from, v + angle(t)]));
  keys.sort((a, b) => a[0] - b[0]);
  const apart = keys.filter(([s], k) => k === 0 || s > keys[k - 1][0]);
  if (apart.length) series.push({ name: 'key points', x: Float64Array.from(apart, k => k[0]), y: Float64Array.from(apart, k => k[1] - slope * k[0]), colour: 'c0', marks: true });
  channel = plot('chart-channel', {
    x: 'S, mm', y: slope ? 'θ less guide line, °' : 'θ, °', series, bands: [['max', 'min']],
    onMove: s => cursor.set(s + turns[first].from, 'channel'),
    onPick: s => cursor.set(s + turns[first].from, 'channel', true),
  });
  $('turn-out').textContent = `${first + 1}${shown.length > 1 ? ` – ${end + 1}` : ''} of ${turns.length}`;
}

const kinds = [['position', 'Position', ''], ['velocity', 'Velocity', '/s'], ['acceleration', 'Acceleration', '/s²'], ['jerk', 'Jerk', '/s³']];

export function drawAxes() {
  const A = data.axes;
  if (!A || !turns.length) { for (const [id] of kinds) $(`chart-${id}`).innerHTML = '<p class="empty">The run has no axis motion.</p>'; return; }
  const which = +$('axis').value || 0;
  const ts = $('whole').checked ? A.turns.map((_, t) => t) : chosen();
  const whole = which === 3;
  const of = (who, k, lifted) => {
    const x = [], y = [];
    const start = A.turns[ts[0]][who].from;
    let lift = 0;
    for (const t of ts) {
      const m = A.turns[t][who];
      const at = list(m.t), v = list(m.axes[which][k]);
      if (lifted && t !== ts[0]) lift = turns[t].zero - turns[ts[0]].zero;
      for (let i = 0; i < at.length; i++) {
        const u = at[i] + m.from - start;
        if (x.length && !(u > x[x.length - 1])) continue;
        x.push(u); y.push(v[i] + lift);
      }
    }
    return [Float64Array.from(x), Float64Array.from(y)];
  };
  const places = Float64Array.from(ts.flatMap(t => [...list(A.turns[t].s)]));
  const times = Float64Array.from(ts.flatMap(t => Array.from(list(A.turns[t].plan.t), v => v + A.turns[t].plan.from - A.turns[ts[0]].plan.from)));
  const to = t => places[before(times, t)];
  axesPlots = kinds.map(([id, name, per], k) => {
    const series = [];
    if (A.turns[ts[0]].baseline) {
      const [x, y] = of('baseline', k, whole && k === 0);
      series.push({ name: data.baseline, x, y, colour: 'c2', dash: 'long' });
    }
    const [x, y] = of('plan', k, whole && k === 0);
    series.push({ name: 'this plan', x, y, colour: 'c1', width: 2 });
    if (k > 0 && $('limits').checked) {
      const limit = A.limits[which][k - 1];
      for (const sign of [1, -1]) series.push({ name: 'limit', x: Float64Array.from([x[0], x[x.length - 1]]), y: Float64Array.from([sign * limit, sign * limit]), colour: 'c5', dash: 'dot' });
    }
    const made = plot(`chart-${id}`, {
      x: 'time, s', y: `${name}, ${A.units[which]}${per}`, series,
      onMove: t => cursor.set(to(t), 'axes'), onPick: t => cursor.set(to(t), 'axes', true),
    });
    return made && { mark: s => made.mark(times[before(places, s)]) };
  });
  const other = A.turns[ts[0]].baseline;
  $('axes-note').textContent = whole ? `${A.names[3]} counts from the start of the first turn shown.` : other ? 'Each schedule has its own time.' : '';
}

export function start() {
  $('turn').max = Math.max(1, turns.length);
  $('turn').value = Math.floor(turns.length / 2) + 1;
  const A = data.axes;
  if (A) {
    $('axis').innerHTML = A.names.map((n, i) => `<option value="${i}"${i === 3 ? ' selected' : ''}>${n}</option>`).join('');
  }
  const both = () => { drawChannel(); drawAxes(); };
  $('turn').addEventListener('input', both);
  $('count').addEventListener('change', both);
  for (const [id, by] of [['turn-down', -1], ['turn-up', 1]]) $(id).addEventListener('click', () => { $('turn').value = +$('turn').value + by; both(); });
  $('guide').addEventListener('change', drawChannel);
  for (const id of ['axis', 'limits', 'whole']) $(id).addEventListener('change', drawAxes);
  both();
  cursor.on((s, from, settle) => {
    if (!turns.length) return;
    const turn = before(turns.map(t => t.from), s);
    if (from !== 'channel' && from !== 'axes' && settle && !shown.includes(turn)) { $('turn').value = turn + 1; both(); }
    if (!shown.includes(turn)) return;
    if (from !== 'channel') channel?.mark(s - turns[shown[0]].from);
    if (from !== 'axes') for (const p of axesPlots) p?.mark(s);
  });
}
