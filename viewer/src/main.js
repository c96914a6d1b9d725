// The page's script: theme, the 3-D view with its controls, the plots.
import { $, before, show } from './basics.js';
import { data, list as numbers } from './data.js';
import { legend } from './colour.js';
import { cursor } from './cursor.js';
import { plots, redrawAll } from './plot.js';
import { View, minmax, path, placeOf, timeOf } from './scene.js';
import { theme } from './theme.js';
import * as turns from './turns.js';
import * as channel from './channel.js';
import * as pinch from './pinch.js';
import * as scallop from './scallop.js';
import * as sections from './sections.js';
import * as free from './free.js';
import * as program from './program.js';

const P = data.scene.path;
/** What a part of the path is called. */
const turn = data.word || 'turn';
let view = null;

const drawn = () => { view?.theme(); redrawAll(); };
theme(drawn, () => {
  const closed = [...document.querySelectorAll('details:not([open])')];
  for (const d of closed) d.open = true;
  return () => { for (const d of closed) d.open = false; };
});
addEventListener('beforeprint', () => view?.refine());

// ---- 3-D view -----------------------------------------------------------------------------------
const words = i => {
  const of = k => P.quantities[k];
  const values = P.quantities.slice(1).map((q, k) => `${q.name} ${show(listOf(of(k + 1))[i])} ${q.unit}`);
  const deg = 180 / Math.PI;
  return `${turn} ${path.turn[i]}, S ${show(path.turn_s[i])} mm · θ ${show(path.theta[i] * deg)}° in ${show(path.min[i] * deg)}° – ${show(path.max[i] * deg)}° · ${values.join(' · ')}`;
};
const cache = new Map();
function listOf(q) {
  if (!cache.has(q.key)) cache.set(q.key, numbers(q.of));
  return cache.get(q.key);
}

const clock = t => `${Math.floor(t / 60)}:${(t % 60).toFixed(1).padStart(4, '0')}`;
/** Where the first turn begins: before it tools may be lifted. */
const begin = data.turns?.[0]?.from || 0;
const total = path?.t.length ? path.t[path.t.length - 1] : 0;

function follow(s, from) {
  if (!path?.s.length) return;
  view?.setPlace(s);
  const t = timeOf(s);
  if (from !== 'slider') $('along').value = total ? t / total : 0;
  const i = before(path.s, s);
  program.show(t);
  $('along-out').textContent = `${turn} ${path.turn[i]}, S ${show(path.turn_s[i])} mm, ${clock(t)} of ${clock(total)} min`;
}

let playing = null;
function play(on) {
  if (on === Boolean(playing)) return;
  $('play').setAttribute('aria-pressed', String(on));
  $('play').textContent = on ? '❚❚ Pause' : '▶ Play';
  if (!on) { cancelAnimationFrame(playing); playing = null; return; }
  let t = timeOf(cursor.s) >= total - 1e-6 ? 0 : timeOf(cursor.s);
  let last = performance.now();
  const step = now => {
    t += ((now - last) / 1000) * +$('speed').value;
    last = now;
    cursor.set(placeOf(Math.min(t, total)), 'play');
    if (t >= total) { playing = null; play(false); $('play').setAttribute('aria-pressed', 'false'); $('play').textContent = '▶ Play'; return; }
    playing = requestAnimationFrame(step);
  };
  playing = requestAnimationFrame(step);
}

const TOOLS = data.scene.second
  ? [['path', 'rows of tool 1', true], ['path 2', 'rows of tool 2', true], ['tool 1', 'tool 1', true], ['tool 2', 'tool 2', true]]
  : [['path', 'path', true], ['leads', 'lead-in and lead-out', true], ['tool', 'tool', true]];
const LAYERS = [
  ['blade', 'blade', true], ...TOOLS, ['neighbours', 'other blades and hub', true], ['uncut', 'uncut', true], ['cutter contacts', 'cutter contacts', false],
  ['channel', 'channel limits', false], ['base vectors', 'base vectors', false], ['altered points', 'altered points', false],
  ['scallop', 'scallop map', false], ['machine', 'machine parts', false],
];

/** Legends of what is shown in the scale of colours. */
function legends() {
  const on = (name, otherwise) => $(`layer-${name}`)?.checked ?? otherwise;
  const q = P?.quantities[+$('colouring').value];
  const all = [
    q && (on('path', true) || on('path-2', false)) ? legend(q.name, q.unit, q.range, q.shown, listOf(q).some(v => v !== v)) : '',
    on('scallop', false) ? scallop.mapLegend() : '',
  ];
  $('scale').innerHTML = all.join('');
  $('scale').hidden = !all.some(Boolean);
}

function controls() {
  $('colouring').innerHTML = (P?.quantities || []).map((q, k) => `<option value="${k}">${q.name}</option>`).join('');
  const colouring = () => {
    view?.setColouring(+$('colouring').value);
    legends();
  };
  if (P) { $('colouring').addEventListener('change', colouring); colouring(); }
  $('motion').addEventListener('change', () => {
    // The machine's parts come with its motion, and go with it.
    const box = $('layer-machine');
    if (box && box.checked !== ($('motion').value === 'machine')) box.click();
    view?.setMode($('motion').value);
    $('look').value = view?.from;
  });
  $('look').addEventListener('change', () => view?.look($('look').value));
  $('play').addEventListener('click', () => play(!playing));
  $('scene').addEventListener('keydown', e => { if (e.key === ' ') { play(!playing); e.preventDefault(); } });
  $('along').addEventListener('input', () => cursor.set(placeOf(+$('along').value * total), 'slider', true));
  const box = data.scene.box || [[0], [1]];
  const cut = () => {
    const x = box[0][0] + (box[1][0] - box[0][0]) * (+$('cut').value / 1000);
    view?.setCut($('cut-on').checked ? x : null);
    $('cut-out').textContent = `at ${show(+x.toFixed(2))} mm`;
  };
  // The section begins where the path is, which is what the first look frames.
  if (path?.x.length) {
    const [a, b] = minmax(path.x);
    $('cut').value = Math.round(1000 * ((a + b) / 2 - box[0][0]) / (box[1][0] - box[0][0]));
  }
  $('cut').addEventListener('input', () => { $('cut-on').checked = true; cut(); });
  $('cut-on').addEventListener('change', cut);
  cut();
  const last = P?.turns || 1;
  for (const id of ['first-turn', 'last-turn']) { $(id).max = last; $(id).addEventListener('change', () => view?.setTurns(+$('first-turn').value, +$('last-turn').value)); }
  $('last-turn').value = last;
}

function layers() {
  for (const [name, label, on] of LAYERS) {
    const there = view.tools.some(t => t.way === name && t.lines) || (name === 'scallop' && view.dots) || view.layers.has(name);
    if (!there) continue;
    const id = `layer-${name.replaceAll(' ', '-')}`;
    const l = document.createElement('label');
    const colours = name === 'blade' ? [] : view.coloursOf(name).slice(0, 6);
    l.innerHTML = `<input type="checkbox" id="${id}"${on ? ' checked' : ''}> ${label} ${colours.map(c => `<i class="swatch" style="background:${c}"></i>`).join('')}`;
    l.firstChild.addEventListener('change', e => {
      view.setLayer(name, e.target.checked);
      legends();
      // The machine is larger than what is looked at without it.
      if (name === 'machine' && view.mode === 'machine') view.look(view.from);
    });
    $('layers').append(l);
    view.setLayer(name, on);
  }
}

function picked(i, settle, e) {
  const tip = $('pick');
  if (i < 0) { tip.hidden = true; return; }
  tip.hidden = false;
  tip.textContent = words(i);
  const r = $('stage').getBoundingClientRect();
  tip.style.left = `${Math.min(e.clientX - r.left + 12, Math.max(8, r.width - 330))}px`;
  tip.style.top = `${e.clientY - r.top + 14}px`;
  if (settle) cursor.set(path.s[i], 'view', true);
}

async function start() {
  cursor.on((s, from) => follow(s, from));
  controls();
  for (const b of document.querySelectorAll('button.go')) {
    b.addEventListener('click', () => {
      if (!path?.row.length) return;
      cursor.set(path.s[before(path.row, +b.dataset.row)], 'table', true);
      $('view').scrollIntoView({ behavior: 'smooth' });
    });
  }
  try {
    view = new View($('scene'), picked);
    view.theme();
    await view.load();
    layers();
    view.setPlace(begin);
    view.look('side');
    if (P) view.setColouring(+$('colouring').value);
  } catch (e) {
    view = null;
    $('stage').innerHTML = `<p class="empty">This browser cannot show the 3-D view (${String(e.message || e).replace(/[&<>]/g, '')}). Tables and plots hold all figures.</p>`;
  }
  globalThis.bladewright = { view, cursor, plots };
  await program.read();
  cursor.set(begin, 'start');
  view?.finish();
  document.documentElement.dataset.ready = String(Math.round(performance.now()));
  // The view answers already; the plots come one after another, so that it goes on answering.
  const all = data.scene.second
    ? [() => turns.start(pinch.draw, pinch.mark)]
    : [free.start, () => turns.start(channel.draw, channel.mark), scallop.drawHistogram, scallop.drawMap, sections.start];
  for (const draw of all) {
    await new Promise(done => setTimeout(done));
    draw();
  }
  document.documentElement.dataset.drawn = String(Math.round(performance.now()));
  let width = innerWidth;
  addEventListener('resize', () => { if (innerWidth !== width) { width = innerWidth; redrawAll(); } });
  $('print-sheet').addEventListener('click', () => {
    document.documentElement.dataset.print = 'sheet';
    print();
    delete document.documentElement.dataset.print;
  });
}
start();
