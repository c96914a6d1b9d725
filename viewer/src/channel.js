// S–θ plot of a path: the channel of the turns shown, and all schedules in it.
import { $ } from './basics.js';
import { data, list } from './data.js';
import { cursor } from './cursor.js';
import { plot } from './plot.js';
import { joined, toPath, toPlot, turns } from './turns.js';

let channel = null;

export function draw(shown) {
  if (!shown.length) { $('chart-channel').innerHTML = '<p class="empty">The run has no channel.</p>'; return; }
  const [first] = shown;
  const angle = t => turns[t].zero - turns[first].zero;
  const x = joined(shown, 's', t => turns[t].from - turns[first].from);
  const end = shown[shown.length - 1];
  const total = turns[end].from + turns[end].length - turns[first].from;
  const rise = turns[end + 1] ? turns[end + 1].zero - turns[first].zero : [...list(turns[end].theta)].pop() + angle(end);
  const slope = $('guide').checked && total > 0 ? rise / total : 0;
  const curve = field => joined(shown, field, angle).map((v, i) => v - slope * x[i]);
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
    onMove: s => cursor.set(toPath(shown, s), 'channel'),
    onPick: s => cursor.set(toPath(shown, s), 'channel', true),
  });
}

/** Marks a place of the path. */
export function mark(shown, s, from) {
  if (from !== 'channel') channel?.mark(toPlot(shown, s));
}
