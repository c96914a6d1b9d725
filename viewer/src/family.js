// The script of family.html: the table of members, and charts of the figures that are chosen.
import { $, minus, show } from './basics.js';
import { plot, plots, redrawAll } from './plot.js';
import { theme } from './theme.js';

const data = JSON.parse($('data').textContent);
const { columns, links } = data;
const column = name => columns.find(c => c.name === name);
const status = column('status').cells;
const names = column('name').cells;
const rows = [...names.keys()];
const isNumber = v => typeof v === 'number';
/** Counts keep all their digits. */
const shown = v => (Number.isInteger(v) ? minus(v) : show(v));

// ---- table --------------------------------------------------------------------------------------
let sortBy = null;
let direction = 1;

const shownColumns = () => columns.filter(c => $('all-columns').checked || (c.shown && c.cells.some(v => v !== null)));

/** The members that the filters leave, in the order of the column that was clicked. */
const shownRows = () => {
  const wanted = $('search').value.toLowerCase();
  const only = $('status').value;
  const left = rows.filter(k => (!only || status[k] === only) && (!wanted || columns.some(c => c.cells[k] !== null && String(c.cells[k]).toLowerCase().includes(wanted))));
  if (!sortBy) return left;
  const { cells } = sortBy;
  return left.sort((a, b) => {
    const [x, y] = [cells[a], cells[b]];
    // Empty cells come last either way.
    if (x === null || y === null) return (x === null) - (y === null) || a - b;
    const d = isNumber(x) && isNumber(y) ? x - y : String(x).localeCompare(String(y), 'en', { numeric: true });
    return direction * d || a - b;
  });
};

const element = (name, properties = {}) => Object.assign(document.createElement(name), properties);

function heading(c) {
  const th = element('th', { scope: 'col' });
  th.setAttribute('aria-sort', sortBy === c ? (direction > 0 ? 'ascending' : 'descending') : 'none');
  const button = element('button', { type: 'button', textContent: c.name });
  button.addEventListener('click', () => {
    direction = sortBy === c ? -direction : 1;
    sortBy = c;
    drawTable();
    // The button was made anew.
    [...$('table').tHead.querySelectorAll('button')].find(b => b.textContent === c.name)?.focus();
  });
  th.append(button);
  return th;
}

function cell(c, k) {
  const v = c.cells[k];
  const td = element('td');
  if (c.name === 'name') {
    td.append(links[k] ? element('a', { href: links[k], textContent: v }) : v);
  } else if (c.name === 'status') {
    td.append(element('span', { className: `tag ${v}`, textContent: v }));
  } else if (isNumber(v)) {
    Object.assign(td, { className: 'number', textContent: shown(v), title: String(v) });
  } else if (v !== null) {
    td.textContent = String(v);
    if (td.textContent.length > 40) td.className = 'wide';
  }
  return td;
}

function drawTable() {
  const across = shownColumns();
  const left = shownRows();
  // The picture stands beside the name.
  const beside = (c, one, picture) => (c.name === 'name' ? [one, picture()] : [one]);
  const head = element('tr');
  head.append(...across.flatMap(c => beside(c, heading(c), () => element('th', { scope: 'col', textContent: 'picture' }))));
  $('table').tHead.replaceChildren(head);
  $('table').tBodies[0].replaceChildren(...left.map(k => {
    const tr = element('tr');
    // The program makes pictures from numbers alone, so they are safe as markup.
    tr.append(...across.flatMap(c => beside(c, cell(c, k), () => element('td', { innerHTML: data.pictures[k] || '' }))));
    return tr;
  }));
  $('shown').textContent = `${left.length} of ${names.length} members`;
}

// ---- charts -------------------------------------------------------------------------------------
/** How a status looks, also for eyes that do not tell the colours apart. */
const looks = [['good', 'good', false], ['findings', 'c5', true], ['failed', 'bad', true], ['missing', 'soft', true]];
const different = columns.filter(c => new Set(c.cells.filter(isNumber)).size > 1);
/** Most names that are said of members on one another. */
const NAMES = 3;

const open = k => { if (links[k]) location.href = links[k]; };

function drawScatter(cx, cy) {
  const both = rows.filter(k => isNumber(cx.cells[k]) && isNumber(cy.cells[k])).sort((a, b) => cx.cells[a] - cx.cells[b] || a - b);
  const x = both.map(k => cx.cells[k]);
  plot('scatter', {
    x: cx.name, y: cy.name, points: true, tip: true,
    series: looks.map(([word, colour, hollow]) => ({ name: word, x, y: both.map(k => (status[k] === word ? cy.cells[k] : null)), colour, hollow, marks: true })),
    say: on => {
      const more = on.length > NAMES ? ` and ${on.length - NAMES} more` : '';
      return `${on.slice(0, NAMES).map(i => names[both[i]]).join(', ')}${more}: ${shown(cx.cells[both[on[0]]])}, ${shown(cy.cells[both[on[0]]])}`;
    },
    onPick: (_, i) => open(both[i]),
  });
  $('scatter-note').textContent = `${both.length} members have both figures.`;
}

function drawBars(c) {
  const sorted = Float64Array.from(c.cells.filter(isNumber)).sort();
  const [lo, hi] = [sorted[0], sorted[sorted.length - 1]];
  const bins = Math.max(5, Math.min(30, Math.ceil(1.5 * Math.sqrt(sorted.length))));
  const edge = k => lo + (k * (hi - lo)) / bins;
  const count = new Array(bins + 1).fill(0);
  for (const v of sorted) count[Math.min(bins - 1, Math.floor(((v - lo) / (hi - lo)) * bins))] += 1;
  plot('bars', {
    x: c.name, y: 'members',
    series: [{ name: 'members', x: Array.from(count, (_, k) => edge(k)), y: count, colour: 'c1', bars: true, width: 1, quiet: true }],
    range: { y: (u, least, most) => [0, 1.08 * (most || 1)] },
    say: ([k]) => `${show(edge(k))} to ${show(edge(k + 1))}: ${count[k]} ${count[k] === 1 ? 'member' : 'members'}`,
  });
  const at = share => shown(sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]);
  $('bars-note').textContent = `${c.name}: least ${at(0)}, median ${at(0.5)}, greatest ${shown(hi)}`;
}

function drawCharts() {
  const [cx, cy] = ['plot-x', 'plot-y'].map(id => column($(id).value));
  if (!cx || !cy) {
    $('scatter-note').textContent = 'There are no figures that differ between members.';
    return;
  }
  drawScatter(cx, cy);
  drawBars(cy);
}

function start() {
  theme(redrawAll);
  for (const id of ['search', 'status', 'all-columns']) $(id).addEventListener('input', drawTable);
  const first = (...wanted) => wanted.map(name => different.find(c => c.name === name)).find(Boolean) || different[0];
  const begin = { 'plot-x': different.find(c => c.shown && c.name.includes('.')) || first('path_length_mm'), 'plot-y': first('machining_time_s', 'path_length_mm') };
  for (const [id, c] of Object.entries(begin)) {
    $(id).append(...different.map(one => element('option', { textContent: one.name, selected: one === c })));
    $(id).addEventListener('input', drawCharts);
  }
  drawTable();
  drawCharts();
  let width = innerWidth;
  addEventListener('resize', () => { if (innerWidth !== width) { width = innerWidth; redrawAll(); } });
  globalThis.bladewright = { plots };
  document.documentElement.dataset.drawn = String(Math.round(performance.now()));
}
start();
