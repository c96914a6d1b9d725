// Rows of two tools: what of the table's turn is free along them, where the table stands, and how
// far the normals of both contacts are from opposite.
import { $ } from './basics.js';
import { data, list } from './data.js';
import { cursor } from './cursor.js';
import { plot } from './plot.js';
import { begins, joined, toPath, toPlot, turns } from './turns.js';

let made = [];

export function draw(shown) {
  if (!shown.length) { for (const id of ['channel', 'angle', 'apart']) $(`chart-${id}`).innerHTML = '<p class="empty">There are no rows.</p>'; return; }
  const [first] = shown;
  const x = joined(shown, 's', t => begins(t) - begins(first));
  const curve = field => joined(shown, field, () => 0);
  const even = of => Float64Array.from(shown.flatMap(t => new Array(list(turns[t].s).length).fill(of(t))));
  // Where the table turns along a row there is an angle for each piece.
  const stands = t => (typeof t.held === 'number' ? new Array(list(t.s).length).fill(t.held) : [...list(t.held)]);
  const from = id => `rows ${id}`;
  const along = (id, y, series, more) => plot(`chart-${id}`, {
    x: 'S along the rows, mm', y, series, ...more,
    onMove: s => cursor.set(toPath(shown, s), from(id)), onPick: s => cursor.set(toPath(shown, s), from(id), true),
  });
  const walls = (name, k, look) => [0, 1].map(end => ({ key: `${k}${end}`, name, x, y: curve(t => t.free[k][end]), ...look }));
  const channel = along('channel', 'angle of the table, °', [
    // What is free for both ends where that of one tool does, whose line is seen on it.
    ...walls('free for both', 2, { colour: 'c3', width: 5 }),
    ...walls('free for tool 1', 0, { colour: 'c1', width: 2 }),
    ...walls('free for tool 2', 1, { colour: 'c2', width: 2, dash: 'dash' }),
    { name: 'table stands', x, y: Float64Array.from(shown.flatMap(t => stands(turns[t]))), colour: 'c0', width: 2.5 },
  ], { bands: [['21', '20', 'c3']] });
  const limited = (id, y, field, name, limit) => along(id, y, [
    { name, x, y: curve(field), colour: 'c1', width: 2 },
    { name: 'limit', x, y: even(() => limit), colour: 'c5', dash: 'dot' },
  ], { range: { y: (u, lo, hi) => [0, 1.08 * (hi || 1)] } });
  made = [
    ['channel', channel],
    ['angle', limited('angle', 'β, °', 'angle', 'what the normals lack of being opposite', data.limits.angle_deg)],
    ['apart', limited('apart', 'distance, mm', 'apart', 'distance of the normal lines', data.limits.apart_mm)],
  ].map(([id, plot]) => [from(id), plot]);
}

/** Marks a place of the path. */
export function mark(shown, s, from) {
  for (const [id, plot] of made) if (id !== from) plot?.mark(toPlot(shown, s));
}
