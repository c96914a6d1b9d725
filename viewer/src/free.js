// The free tool axes at the location nearest to the cursor that has a map: the sphere, seen along
// the surface normal. What a map is stands in src/write/preview/report/free_axes.rs.
import { $, before, show } from './basics.js';
import { data, list } from './data.js';
import { cursor } from './cursor.js';
import { plots } from './plot.js';
import { path } from './scene.js';

const F = data.free_axes;
const [QUARTERED, FREE, OPEN, TAKEN] = [0, 1, 2, 3];
/** Cells are drawn in pieces no larger than octants quartered so often: 6°. */
const DEPTH = 4;
/** Steps of a circle, rad. */
const STEP = 0.02;
/** What is seen beyond the tangent plane, as a height over it, is cut off at the rim. */
const BEYOND = -0.35;
const DEG = 180 / Math.PI;
/** Colours and words of what takes cells. */
const KINDS = {
  blade: ['#68717e', 'taken by the part'], wheel: ['#9b87b5', 'taken by the rest of the wheel'], fixture: ['#b08d57', 'taken by fixtures or stock'],
  contact: ['#cdd2d9', 'beyond the contact angle'], machine: ['#dd9a94', 'out of the machine\'s reach'], other: ['#b7bcc4', 'taken'],
};
const LOOKS = new Map([[FREE, ['#7bc47f', 'free']], [OPEN, ['#f2b134', 'not decided']]]);
const lookOf = code => LOOKS.get(code) || KINDS[F.names[code - TAKEN]?.[0]] || KINDS.other;

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const sum = (...all) => all.reduce((a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
const times = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
const unit = a => times(a, 1 / (Math.hypot(...a) || 1));

/** The octants and the quarters of a triangle, in the order that maps have. */
const OCTANTS = [0, 1, 2, 3, 4, 5, 6, 7].map(k => {
  const s = [0, 1, 2].map(bit => ((k >> bit) & 1 ? -1 : 1));
  const [x, y, z] = [[s[0], 0, 0], [0, s[1], 0], [0, 0, s[2]]];
  return s[0] * s[1] * s[2] > 0 ? [x, y, z] : [x, z, y];
});
const quarters = ([a, b, c]) => {
  const [ab, bc, ca] = [sum(a, b), sum(b, c), sum(c, a)].map(unit);
  return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
};

/** The cells of a map, as small as they are drawn: [corners, code]. */
function cellsOf(map) {
  const codes = list(map.cells);
  const out = [];
  let at = 0;
  const pieces = (corners, code, depth) => {
    if (depth >= DEPTH) out.push([corners, code]);
    else for (const q of quarters(corners)) pieces(q, code, depth + 1);
  };
  const read = (corners, depth) => {
    const code = codes[at++];
    if (code !== QUARTERED) return pieces(corners, code, depth);
    for (const q of quarters(corners)) read(q, depth + 1);
  };
  if (codes.length) for (const o of OCTANTS) read(o, 0);
  return out;
}

/** Cells, and the frame that a map is seen in: right, up and towards the eye. */
function opened(map) {
  if (map.open) return map.open;
  const eye = unit(map.normal);
  let up = sum([1, 0, 0], times(eye, -eye[0]));
  if (Math.hypot(...up) < 1e-3) up = sum([0, 1, 0], times(eye, -eye[1]));
  up = unit(up);
  return (map.open = { cells: cellsOf(map), frame: [cross(up, eye), up, eye] });
}

/** Lambert's equal-area projection: the tangent plane is the circle of radius 1. */
function placed(frame, axis) {
  const [x, y, z] = frame.map(f => dot(f, axis));
  const k = 1 / Math.sqrt(Math.max(1e-6, 1 + z));
  return [x * k, y * k, z];
}
/** The axis at a place of the picture; null beyond the rim. */
function axisAt(frame, x, y) {
  const z = 1 - x * x - y * y;
  if (z < 0) return null;
  const k = Math.sqrt(1 + z);
  return sum(times(frame[0], x * k), times(frame[1], y * k), times(frame[2], z));
}

const codeAt = (map, axis) => opened(map).cells.find(([[a, b, c]]) => [[a, b], [b, c], [c, a]].every(([p, q]) => dot(cross(p, q), axis) >= -1e-12))?.[1];
const coneAt = (map, theta) => {
  const [s, c] = [Math.sin(map.lean), Math.cos(map.lean)];
  const across = cross(map.axis, map.reference);
  return sum(times(map.axis, s), times(map.reference, c * Math.cos(theta)), times(across, c * Math.sin(theta)));
};
const arc = (map, from, to) => {
  const n = Math.max(1, Math.ceil((to - from) / STEP));
  return Array.from({ length: n + 1 }, (_, k) => coneAt(map, from + ((to - from) * k) / n));
};
const planAxis = i => [path.ix[i], path.iy[i], path.iz[i]];

/** Rows of the path about a place of the same turn that have the same map. */
function about(i, k) {
  const near = list(F.nearest);
  const same = j => j >= 0 && j < near.length && near[j] === k && path.turn[j] === path.turn[i];
  let [a, b] = [i, i];
  while (same(a - 1)) a--;
  while (same(b + 1)) b++;
  return [a, b];
}

let shown = 0;
let here = 0;
let pointed = null;
let kept = {};

/** Share of the half sphere that each look takes, the greatest first. */
function shares(map) {
  if (map.shares) return map.shares;
  const { cells, frame } = opened(map);
  const out = new Map();
  let all = 0;
  for (const [corners, code] of cells) {
    const p = corners.map(c => placed(frame, c));
    if (p[0][2] + p[1][2] + p[2][2] < 0) continue;
    const area = Math.abs((p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]));
    const look = lookOf(code);
    out.set(look, (out.get(look) || 0) + area);
    all += area;
  }
  return (map.shares = [...out].map(([look, area]) => [look, (100 * area) / all]).sort((a, b) => b[1] - a[1]));
}

/** The cells of a map as a picture so many pixels wide; of the map shown last it is kept. */
function pictureOf(map, px, at) {
  if (kept.map === map && kept.px === px) return kept.canvas;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = px;
  const c = canvas.getContext('2d');
  c.lineWidth = 0.0025 * px;
  for (const [corners, code] of opened(map).cells) {
    const p = corners.map(at);
    if (p.some(q => q[2] < BEYOND)) continue;
    c.fillStyle = c.strokeStyle = lookOf(code)[0];
    c.beginPath();
    p.forEach(([x, y], k) => c[k ? 'lineTo' : 'moveTo'](x, y));
    c.closePath(); c.fill(); c.stroke();
  }
  kept = { map, px, canvas };
  return canvas;
}

function draw() {
  const canvas = $('free-map');
  const map = F.maps[shown];
  const { frame } = opened(map);
  const px = Math.round((canvas.clientWidth || 400) * Math.min(2, devicePixelRatio || 1));
  canvas.width = canvas.height = px;
  const c = canvas.getContext('2d');
  const style = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();
  const [rim, mid, text] = [0.46 * px, px / 2, style('--text')];
  const at = axis => { const [x, y, z] = placed(frame, axis); return [mid + rim * x, mid - rim * y, z]; };
  c.save();
  c.beginPath(); c.arc(mid, mid, rim, 0, 7); c.clip();
  c.drawImage(pictureOf(map, px, at), 0, 0);
  const line = (axes, width, colour) => {
    c.beginPath(); c.lineWidth = width * px; c.strokeStyle = colour;
    let pen = false;
    for (const p of axes.map(at)) {
      if (p[2] < BEYOND) { pen = false; continue; }
      c[pen ? 'lineTo' : 'moveTo'](p[0], p[1]);
      pen = true;
    }
    c.stroke();
  };
  // Blue and black on the map's own colours, which are the same in light and dark.
  line(arc(map, 0, 2 * Math.PI), 0.004, '#0060a0');
  line(arc(map, map.theta[0], map.theta[1]), 0.012, '#0060a0');
  const [a, b] = about(here, shown);
  line(Array.from({ length: b - a + 1 }, (_, k) => planAxis(a + k)), 0.006, '#111111');
  const mark = (axis, r, fill) => {
    const [x, y, z] = at(axis);
    if (z < BEYOND) return;
    c.beginPath(); c.arc(x, y, r * px, 0, 7);
    c.fillStyle = fill; c.fill();
    c.lineWidth = 0.006 * px; c.strokeStyle = '#111111'; c.stroke();
  };
  mark(planAxis(here), 0.017, '#ffffff');
  mark(coneAt(map, map.theta[2]), 0.012, '#111111');
  c.restore();
  c.lineWidth = 0.004 * px; c.strokeStyle = text;
  c.beginPath(); c.arc(mid, mid, rim, 0, 7); c.stroke();
  c.beginPath(); c.moveTo(mid, mid - rim); c.lineTo(mid, mid - rim - 0.015 * px); c.stroke();
  c.fillStyle = text; c.font = `${Math.round(0.028 * px)}px system-ui`; c.textAlign = 'center';
  c.fillText('towards the tip', mid, 0.022 * px);
  tell(map);
}

/** Words beside the picture. */
function tell(map) {
  const words = axis => {
    const code = codeAt(map, axis);
    const off = Math.acos(Math.max(-1, Math.min(1, dot(unit(map.normal), axis)))) * DEG;
    const by = code >= TAKEN ? `taken: ${F.names[code - TAKEN][1]}` : lookOf(code)[1];
    return `${off.toFixed(1)}° off the normal: ${by}`;
  };
  const away = Math.hypot(...[path.x, path.y, path.z].map((of, k) => of[here] - map.at[k]));
  const off = away > 0.05 ? `, ${away.toFixed(1)} mm from the cursor` : '';
  $('free-out').textContent = `computed at turn ${map.turn}, S ${show(map.turn_s)} mm${off} (location ${shown + 1} of ${F.maps.length})`;
  $('free-said').textContent = pointed ? words(pointed) : `Tool axis of the plan ${words(coneAt(map, map.theta[2]))}`;
  const found = shares(map);
  const key = ([colour, word], share) => `<span class="key"><i style="background:${colour}"></i>${word}, ${show(+share.toPrecision(2))} %</span>`;
  $('free-legend').innerHTML = found.map(([look, share]) => key(look, share)).join('')
    + '<span class="key"><i class="axis"></i>tool axis of the plan there</span><span class="key"><i class="ring"></i>at the cursor, and its way about it</span>'
    + '<span class="key"><i class="cone"></i>cone that the plan uses, thick where its channel is</span>';
  $('free-map').setAttribute('aria-label', `Free tool axes, turn ${map.turn}, S ${show(map.turn_s)} mm: ${found.map(([[, word], share]) => `${word} ${show(+share.toPrecision(2))} %`).join(', ')}. Arrow keys go to the next location.`);
}

/** Begins, where the page has maps. */
export function start() {
  const canvas = $('free-map');
  if (!canvas) return;
  if (!F || !path?.ix) {
    $('free-axes').querySelector('.sphere').innerHTML = '<p class="empty">No maps were made.</p>';
    $('free-axes').querySelector('.controls').hidden = true;
    return;
  }
  const near = list(F.nearest);
  let [queued, seen] = [false, true];
  const redraw = () => {
    if (queued || !seen) return;
    queued = true;
    requestAnimationFrame(() => { queued = false; draw(); });
  };
  // A picture that is not seen is drawn when it is.
  new IntersectionObserver(all => { seen = all.at(-1).isIntersecting; redraw(); }).observe(canvas);
  const follow = (s, k) => {
    here = before(path.s, s + 5e-4);
    shown = k ?? near[here] ?? 0;
    redraw();
  };
  const step = by => {
    const k = (shown + by + F.maps.length) % F.maps.length;
    cursor.set(F.maps[k].s, 'free', true);
    follow(F.maps[k].s, k);
  };
  cursor.on((s, from) => { if (from !== 'free') follow(s); });
  $('free-before').addEventListener('click', () => step(-1));
  $('free-next').addEventListener('click', () => step(1));
  canvas.addEventListener('keydown', e => {
    const by = { ArrowLeft: -1, ArrowRight: 1 }[e.key];
    if (by) { step(by); e.preventDefault(); }
  });
  const point = axis => { pointed = axis; tell(F.maps[shown]); };
  canvas.addEventListener('pointermove', e => {
    const r = canvas.getBoundingClientRect();
    const [x, y] = [(e.clientX - r.left) / r.width - 0.5, 0.5 - (e.clientY - r.top) / r.height].map(v => v / 0.46);
    point(axisAt(opened(F.maps[shown]).frame, x, y));
  });
  canvas.addEventListener('pointerleave', () => point(null));
  plots.set('free-map', { redraw: draw, maps: F.maps, codeAt, coneAt });
  follow(cursor.s);
  draw();
}
