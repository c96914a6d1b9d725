'use strict';
(() => {
const D = JSON.parse(document.getElementById('data').textContent);
const $ = id => document.getElementById(id);
const text = s => String(s).replace(/[&<>"]/g, c => ({'&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;'})[c]);
const minus = s => String(s).replace('-', '−');
const redraw = [];

// ---- theme -------------------------------------------------------------------------------------------------------
const themeButton = $('theme');
const setTheme = dark => {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  themeButton.setAttribute('aria-pressed', dark);
  themeButton.textContent = dark ? 'Light' : 'Dark';
  redraw.forEach(f => f());
};
themeButton.addEventListener('click', () => setTheme(document.documentElement.dataset.theme !== 'dark'));

// ---- charts ------------------------------------------------------------------------------------------------------
const nice = (lo, hi, count) => {
  const raw = (hi - lo) / Math.max(1, count), power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(m => m * power).find(s => s >= raw * 0.999) || raw;
  const out = [];
  for (let v = Math.ceil(lo / step - 1e-9) * step; v <= hi + step * 1e-9; v += step) out.push(Math.abs(v) < step * 1e-9 ? 0 : v);
  return {ticks: out, digits: Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)))};
};
const show = v => v == null ? '–' : minus(+v.toPrecision(5));
const dashOf = {solid: '', dash: '6 4', dot: '2 3', long: '12 4'};
const hidden = {};

// spec: {x, y: labels, series: [{name, group (legend; the name if absent), x, y, color, dash, width}], bands: [{x, lo, hi}], points: [{name, x, y, color, shape}], equal}
function chart(box, spec) {
  const off = hidden[box.id] = hidden[box.id] || {};
  const series = spec.series.filter(s => s.y.some(v => v != null));
  if (!series.length) { box.innerHTML = '<p class="empty">Nothing to show.</p>'; return; }
  const groupOf = s => s.group || s.name;
  const seen = series.filter(s => !off[groupOf(s)]), points = (spec.points || []).filter(p => !off[p.name]);
  const W = Math.max(260, box.clientWidth || 600), left = 58, right = 10, top = 8, bottom = 40;
  let H = spec.equal ? Math.min(W * 0.7, 440) : Math.max(210, Math.min(W * 0.42, 360));
  let xl = Infinity, xh = -Infinity, yl = Infinity, yh = -Infinity;
  for (const s of (seen.length ? seen : series)) for (let i = 0; i < s.x.length; i++) {
    const u = s.x[i], v = s.y[i];
    if (u == null || v == null) continue;
    if (u < xl) xl = u; if (u > xh) xh = u; if (v < yl) yl = v; if (v > yh) yh = v;
  }
  if (!(xh > xl)) { xl -= 1; xh += 1; }
  const pad = yh > yl ? (yh - yl) * 0.05 : Math.max(1, Math.abs(yh) * 0.05);
  yl -= pad; yh += pad;
  const w = W - left - right;
  let h = H - top - bottom;
  if (spec.equal) {
    const m = (xh - xl) * 0.03; xl -= m; xh += m;
    const unit = Math.max((xh - xl) / w, (yh - yl) / h);
    const cx = (xl + xh) / 2, cy = (yl + yh) / 2;
    xl = cx - unit * w / 2; xh = cx + unit * w / 2; yl = cy - unit * h / 2; yh = cy + unit * h / 2;
  }
  const X = v => left + (v - xl) / (xh - xl) * w, Y = v => top + (yh - v) / (yh - yl) * h;
  const tx = nice(xl, xh, w / 90), ty = nice(yl, yh, h / 45);
  let g = '';
  for (const v of ty.ticks) g += `<line class="${v === 0 ? 'zero' : 'grid'}" x1="${left}" x2="${W - right}" y1="${Y(v)}" y2="${Y(v)}"/><text x="${left - 6}" y="${Y(v) + 4}" text-anchor="end">${minus(v.toFixed(ty.digits))}</text>`;
  for (const v of tx.ticks) g += `<line class="grid" x1="${X(v)}" x2="${X(v)}" y1="${top}" y2="${H - bottom}"/><text x="${X(v)}" y="${H - bottom + 16}" text-anchor="middle">${minus(v.toFixed(tx.digits))}</text>`;
  for (const b of spec.bands || []) {
    let d = '', back = '';
    b.x.forEach((u, i) => { if (b.lo[i] == null || b.hi[i] == null) return; d += `${d ? 'L' : 'M'}${X(u).toFixed(1)} ${Y(b.lo[i]).toFixed(1)}`; back = `L${X(u).toFixed(1)} ${Y(b.hi[i]).toFixed(1)}` + back; });
    if (d) g += `<path d="${d}${back}Z" fill="var(--fill)"/>`;
  }
  for (const s of seen) {
    let d = '', pen = false;
    for (let i = 0; i < s.x.length; i++) {
      if (s.y[i] == null || s.x[i] == null) { pen = false; continue; }
      d += `${pen ? 'L' : 'M'}${X(s.x[i]).toFixed(1)} ${Y(s.y[i]).toFixed(1)}`; pen = true;
    }
    g += `<path d="${d}" fill="none" stroke="var(--${s.color})" stroke-width="${s.width || 1.5}" stroke-dasharray="${dashOf[s.dash || 'solid']}" stroke-linejoin="round"/>`;
  }
  const mark = (shape, x, y, c) => shape === 'square' ? `<rect x="${x - 4}" y="${y - 4}" width="8" height="8" fill="var(--${c})"/>` : shape === 'diamond' ? `<path d="M${x} ${y - 5.5}L${x + 5.5} ${y}L${x} ${y + 5.5}L${x - 5.5} ${y}Z" fill="var(--${c})"/>` : `<circle cx="${x}" cy="${y}" r="4" fill="var(--bg)" stroke="var(--${c})" stroke-width="2"/>`;
  for (const p of points) p.x.forEach((u, i) => { g += mark(p.shape, X(u), Y(p.y[i]), p.color); });
  const label = `${spec.y} over ${spec.x}: ${series.map(s => s.name).join(', ')}. Arrow keys read values.`;
  const clip = 'clip-' + box.id;
  box.innerHTML = `<div class="legend"></div><svg viewBox="0 0 ${W} ${H}" width="${W}" height="${H}" tabindex="0" role="img" aria-label="${text(label)}"><defs><clipPath id="${clip}"><rect x="${left}" y="${top}" width="${w}" height="${h}"/></clipPath></defs>${g}<g class="at"></g><text x="${left + w / 2}" y="${H - 6}" text-anchor="middle">${text(spec.x)}</text><text transform="translate(13 ${top + h / 2}) rotate(-90)" text-anchor="middle">${text(spec.y)}</text></svg><p class="readout" aria-live="polite"></p>`;
  const legend = box.querySelector('.legend');
  const entry = (name, icon) => {
    const b = document.createElement('button');
    b.type = 'button'; b.setAttribute('aria-pressed', !off[name]);
    b.innerHTML = `<svg aria-hidden="true" viewBox="0 0 26 12">${icon}</svg>${text(name)}`;
    b.addEventListener('click', () => { off[name] = !off[name]; chart(box, spec); [...box.querySelectorAll('.legend button')].find(x => x.textContent === name)?.focus(); });
    legend.append(b);
  };
  const names = new Set();
  for (const s of series) if (!names.has(groupOf(s))) { names.add(groupOf(s)); entry(groupOf(s), `<path d="M1 6H25" stroke="var(--${s.color})" stroke-width="${Math.max(2, s.width || 0)}" stroke-dasharray="${dashOf[s.dash || 'solid']}"/>`); }
  for (const p of spec.points || []) if (p.x.length && !names.has(p.name)) { names.add(p.name); entry(p.name, mark(p.shape, 13, 6, p.color)); }
  const svg = box.querySelector('svg[role=img]'), at = box.querySelector('.at'), out = box.querySelector('.readout');
  const base = seen[0];
  let index = -1;
  const read = i => {
    if (!base || i < 0 || i >= base.x.length) return;
    index = i;
    const u = base.x[i];
    let dots = spec.equal ? '' : `<line class="cursor" x1="${X(u)}" x2="${X(u)}" y1="${top}" y2="${H - bottom}"/>`;
    const words = [];
    for (const s of seen) {
      if (spec.equal && s !== base) continue;
      let k = i;
      if (s.x !== base.x) { k = 0; s.x.forEach((v, j) => { if (Math.abs(v - u) < Math.abs(s.x[k] - u)) k = j; }); }
      if (s.y[k] == null) continue;
      dots += `<circle cx="${X(s.x[k])}" cy="${Y(s.y[k])}" r="3.5" fill="var(--${s.color})"/>`;
      words.push(`${s.name} ${show(s.y[k])}`);
    }
    at.innerHTML = dots;
    out.textContent = `${spec.x} ${show(u)}: ${words.join(' · ')}`;
  };
  svg.addEventListener('pointermove', e => {
    if (!base) return;
    const r = svg.getBoundingClientRect(), u = (e.clientX - r.left) * W / r.width, v = (e.clientY - r.top) * H / r.height;
    let best = -1, d = Infinity;
    base.x.forEach((bx, i) => { if (bx == null || base.y[i] == null) return; const q = Math.abs(X(bx) - u) + (spec.equal ? Math.abs(Y(base.y[i]) - v) : 0); if (q < d) { d = q; best = i; } });
    read(best);
  });
  svg.addEventListener('pointerleave', () => { at.innerHTML = ''; out.textContent = ''; });
  svg.addEventListener('keydown', e => {
    const n = base ? base.x.length : 0, go = {ArrowRight: 1, ArrowLeft: -1, PageDown: 10, PageUp: -10}[e.key];
    if (go) { read(Math.max(0, Math.min(n - 1, index + go))); e.preventDefault(); }
    else if (e.key === 'Home') { read(0); e.preventDefault(); } else if (e.key === 'End') { read(n - 1); e.preventDefault(); }
  });
}

// ---- channel and axes --------------------------------------------------------------------------------------------
const turns = D.turns || [];
const turnRange = $('turn'), count = $('count');
turnRange.max = Math.max(0, turns.length - 1);
const chosen = () => {
  const first = Math.min(+turnRange.value, turns.length - 1), out = [];
  for (let t = Math.max(0, first); t < Math.min(turns.length, first + +count.value); t++) out.push(t);
  return out;
};
// Joins a list of the chosen turns into one, shifted by each turn's start and angle.
function joined(ts, field) {
  const out = [];
  for (const t of ts) { const lift = turns[t].zero - turns[ts[0]].zero; (turns[t][field] || turns[t].s.map(() => null)).forEach(v => out.push(v == null ? null : v + lift)); }
  return out;
}
function arc(ts, list) {
  const out = []; let from = 0;
  for (const t of ts) { list(t).forEach(v => out.push(v + from)); from += turns[t].length; }
  return out;
}
function drawChannel() {
  const ts = chosen(), box = $('chart-channel');
  if (!ts.length) { box.innerHTML = '<p class="empty">The run has no channel.</p>'; return; }
  const s = arc(ts, t => turns[t].s), total = ts.reduce((a, t) => a + turns[t].length, 0);
  const last = ts[ts.length - 1], next = turns[last + 1];
  const rise = (next ? next.zero : turns[last].zero + (turns[last].theta.at(-1) || 0)) - turns[ts[0]].zero;
  const slope = $('guide').checked && total > 0 ? rise / total : 0;
  const less = (xs, ys) => ys.map((v, i) => v == null ? null : +(v - slope * xs[i]).toFixed(4));
  const of = f => less(s, joined(ts, f));
  const hullMin = of('hull_min'), hullMax = of('hull_max');
  const kx = [], ky = [];
  { let from = 0; for (const t of ts) { const lift = turns[t].zero - turns[ts[0]].zero; for (const [u, v] of turns[t].keys) { kx.push(u + from); ky.push(v + lift - slope * (u + from)); } from += turns[t].length; } }
  chart(box, {
    x: 'S (mm)', y: slope ? 'θ less guide (°)' : 'θ (°)',
    bands: [{x: s, lo: hullMin, hi: hullMax}],
    series: [
      {name: 'schedule', x: s, y: of('theta'), color: 'c2', width: 2.5},
      {name: 'true channel, least', group: 'true channel', x: s, y: of('min'), color: 'c1'},
      {name: 'true channel, greatest', group: 'true channel', x: s, y: of('max'), color: 'c1'},
      {name: 'monotone hull, least', group: 'monotone hull', x: s, y: hullMin, color: 'c3', dash: 'dash'},
      {name: 'monotone hull, greatest', group: 'monotone hull', x: s, y: hullMax, color: 'c3', dash: 'dash'},
      {name: 'tangent limits, least', group: 'tangent limits', x: s, y: of('tangent_min'), color: 'c4', dash: 'dot'},
      {name: 'tangent limits, greatest', group: 'tangent limits', x: s, y: of('tangent_max'), color: 'c4', dash: 'dot'},
      {name: D.baseline || 'baseline', x: s, y: of('fixed'), color: 'c0', dash: 'long'},
    ],
    points: [{name: 'key points', x: kx, y: ky, color: 'c2', shape: 'diamond'}],
  });
}
const axisSelect = $('axis');
if (D.axes) D.axes.names.forEach((n, i) => axisSelect.add(new Option(`${n} (${i < 3 ? 'linear' : 'rotary'})`, i, i === 3, i === 3)));
function drawAxes() {
  const ts = chosen();
  ['position', 'velocity', 'acceleration'].forEach((kind, k) => {
    const box = $('chart-' + kind);
    if (!D.axes || !ts.length) { box.innerHTML = '<p class="empty">The run has no axis motion.</p>'; return; }
    const a = +axisSelect.value || 0, unit = D.axes.units[a] + ['', '/s', '/s²'][k];
    const x = arc(ts, t => D.axes.turns[t].s);
    const get = who => ts.flatMap(t => {
      const lift = a === 3 && k === 0 ? aLift(ts[0], t, who) : 0;
      const row = D.axes.turns[t][who]; return row ? row[a][k].map(v => v == null ? null : v + lift) : D.axes.turns[t].s.map(() => null);
    });
    const series = [{name: 'this plan', x, y: get('plan'), color: 'c2', width: 2}, {name: D.baseline || 'baseline', x, y: get('baseline'), color: 'c0', dash: 'long'}];
    const limit = k > 0 ? D.axes.limits[a][k - 1] : null;
    if ($('limits').checked && limit != null) for (const sign of [1, -1]) series.push({name: 'limit', x: [x[0], x.at(-1)], y: [sign * limit, sign * limit], color: 'c4', dash: 'dot'});
    chart(box, {x: 'S (mm)', y: `${D.axes.names[a]} (${unit})`, series});
  });
  $('axes-note').textContent = axisSelect.value === '3' ? 'Position of A from the start of the turn.' : '';
}
// A is stored from the start of each turn; whole turns joined continue where the turn before ended.
function aLift(first, t, who) {
  let lift = 0;
  for (let i = first; i < t; i++) { const row = D.axes.turns[i][who]; if (row) { const p = row[3][0], n = p.length; lift += n > 1 ? p[n - 1] + (p[n - 1] - p[n - 2]) : 0; } }
  return lift;
}
function drawTurns() {
  const ts = chosen();
  $('turn-out').textContent = turns.length ? `${ts[0]}${ts.length > 1 ? '–' + ts.at(-1) : ''} of 0–${turns.length - 1}` : 'none';
  drawChannel(); drawAxes();
}
turnRange.addEventListener('input', drawTurns);
for (const id of ['count', 'guide']) $(id).addEventListener('change', drawTurns);
for (const id of ['axis', 'limits']) $(id).addEventListener('change', drawAxes);
const stepTurn = by => { turnRange.value = +turnRange.value + by; drawTurns(); };
$('turn-down').addEventListener('click', () => stepTurn(-1));
$('turn-up').addEventListener('click', () => stepTurn(1));

// ---- sections ----------------------------------------------------------------------------------------------------
const sectionRange = $('section');
sectionRange.max = Math.max(0, D.sections.length - 1);
function drawSection() {
  const section = D.sections[+sectionRange.value], box = $('chart-section'), curve = $('chart-curvature');
  $('section-out').textContent = section ? `x = ${show(section.x)} mm` : 'none';
  if (!section || !section.loops.length) { box.innerHTML = '<p class="empty">The run has no section here.</p>'; curve.innerHTML = ''; return; }
  const series = [], points = [];
  section.loops.forEach((l, i) => {
    const x = [], y = [];
    for (let k = 0; k < l.p.length; k += 2) { x.push(l.p[k]); y.push(l.p[k + 1]); }
    const near = s => { let b = 0; l.s.forEach((v, k) => { if (Math.abs(v - s) < Math.abs(l.s[b] - s)) b = k; }); return b; };
    if (i > 0) { series.push({name: 'other loops', x: x.concat(x[0]), y: y.concat(y[0]), color: 'c0', dash: 'dot'}); return; }
    // From the leading edge on: first one side, then, after the trailing edge, the other.
    const n = x.length, le = near(l.le), te = near(l.te), walk = (a, b) => { const out = []; for (let k = a; ; k = (k + 1) % n) { out.push(k); if (k === b) break; } return out; };
    const one = walk(le, te), two = walk(te, le), other = l.first_side === 'suction' ? 'pressure' : 'suction';
    for (const [name, ks] of [[l.first_side, one], [other, two]]) series.push({name: name + ' side', x: ks.map(k => x[k]), y: ks.map(k => y[k]), color: name === 'suction' ? 'c1' : 'c3', dash: name === 'suction' ? 'solid' : 'dash', width: 2});
    points.push({name: 'leading edge', x: [x[le]], y: [y[le]], color: 'c5', shape: 'square'}, {name: 'trailing edge', x: [x[te]], y: [y[te]], color: 'c4', shape: 'diamond'});
    points.push({name: 'altered points', x: l.altered.map(a => a[0]), y: l.altered.map(a => a[1]), color: 'c2', shape: 'circle'});
  });
  chart(box, {x: 'y (mm)', y: 'z (mm)', equal: true, series, points});
  const l = section.loops[0];
  $('section-out').textContent += `, chord ${show(l.chord)}, thickness ${show(l.thickness)} mm`;
  chart(curve, {x: 'arc length (mm)', y: 'curvature (1/mm)', series: [{name: 'curvature, positive where convex', x: l.s, y: l.k, color: 'c1'}]});
}
sectionRange.addEventListener('input', drawSection);

// ---- 3-D picture -------------------------------------------------------------------------------------------------
const canvas = $('scene'), S = D.scene, P = S.path;
let yaw = -0.7, tilt = 0.5, zoom = 1;
const sceneBox = (() => {
  const b = [[Infinity, -Infinity], [Infinity, -Infinity], [Infinity, -Infinity]];
  const add = a => { for (let i = 0; i < a.length; i++) { const v = a[i]; if (v == null) continue; const r = b[i % 3]; if (v < r[0]) r[0] = v; if (v > r[1]) r[1] = v; } };
  add(S.points); if (P) add(P.p);
  return b.map(r => r[1] >= r[0] ? r : [0, 1]);
})();
// Long triangles are halved until they are short: whole faces are sorted by depth, so big ones would hide the path.
const pieces = (() => {
  const at = i => S.points.slice(3 * i, 3 * i + 3), most = 12000, out = [], todo = [];
  const short = Math.hypot(...sceneBox.map(r => r[1] - r[0])) / 16;
  for (let t = 0; t < S.triangles.length; t += 3) todo.push([0, 1, 2].map(k => at(S.triangles[t + k])));
  while (todo.length) {
    const c = todo.pop();
    const len = [0, 1, 2].map(k => Math.hypot(...c[k].map((v, d) => v - c[(k + 1) % 3][d]))), k = len.indexOf(Math.max(...len));
    if (len[k] <= short || out.length + todo.length >= most) { out.push(c); continue; }
    const a = c[k], b = c[(k + 1) % 3], o = c[(k + 2) % 3], m = a.map((v, d) => (v + b[d]) / 2);
    todo.push([a, m, o], [m, b, o]);
  }
  return out;
})();
const turnColour = f => {
  const stops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]], x = Math.min(3.999, f * 4), i = Math.floor(x), k = x - i;
  return `rgb(${stops[i].map((a, j) => Math.round(a + (stops[i + 1][j] - a) * k)).join()})`;
};
function toolFaces(add) {
  if (!P || !P.theta.length || !$('show-tool').checked) return;
  const i = Math.round($('along').value / 1000 * (P.theta.length - 1)), th = P.theta[i], b = P.b, q = P.p.slice(3 * i, 3 * i + 3);
  $('along-out').textContent = `turn ${P.turn[i]}`;
  const a = [Math.sin(b), Math.cos(b) * Math.cos(th), Math.cos(b) * Math.sin(th)], u = [0, -Math.sin(th), Math.cos(th)];
  const v = [a[1] * u[2] - a[2] * u[1], a[2] * u[0] - a[0] * u[2], a[0] * u[1] - a[1] * u[0]];
  const N = 20, rows = [], z0 = S.tool.length ? S.tool[0][0] : 0;
  for (let k = 0; k <= 6; k++) { const t = -Math.PI / 2 + (Math.asin(Math.min(1, z0 / S.radius)) + Math.PI / 2) * k / 6; rows.push([S.radius * Math.sin(t), S.radius * Math.cos(t), 0]); }
  for (const [za, ra, zb, rb, holder] of S.tool) rows.push([za, ra, holder ? 2 : 1], [zb, rb, holder ? 2 : 1]);
  if (S.tool.length) { const e = S.tool.at(-1); rows.push([e[2], 0, 2]); }
  const ring = ([z, r]) => Array.from({length: N}, (_, k) => { const c = r * Math.cos(2 * Math.PI * k / N), s = r * Math.sin(2 * Math.PI * k / N); return [0, 1, 2].map(d => q[d] + a[d] * z + u[d] * c + v[d] * s); });
  for (let k = 1; k < rows.length; k++) {
    const A = ring(rows[k - 1]), B = ring(rows[k]);
    for (let j = 0; j < N; j++) add([A[j], A[(j + 1) % N], B[(j + 1) % N], B[j]], [[213, 94, 0], [230, 159, 0], [86, 140, 180]][rows[k][2]]);
  }
}
function drawScene() {
  const dpr = Math.min(2, window.devicePixelRatio || 1), W = canvas.clientWidth, H = canvas.clientHeight;
  if (!W || !H) return;
  canvas.width = W * dpr; canvas.height = H * dpr;
  const c = canvas.getContext('2d');
  c.scale(dpr, dpr); c.clearRect(0, 0, W, H);
  const mid = sceneBox.map(r => (r[0] + r[1]) / 2), size = Math.hypot(...sceneBox.map(r => r[1] - r[0]));
  const k = Math.min(W, H) / size * 0.95 * zoom, cy = Math.cos(yaw), sy = Math.sin(yaw), ct = Math.cos(tilt), st = Math.sin(tilt);
  // Blade axis x up; turn about it by yaw, then lean towards the viewer by tilt. Right x up = towards the viewer.
  const project = p => { const x = p[0] - mid[0], y = p[1] - mid[1], z = p[2] - mid[2], r = y * cy - z * sy, f = -y * sy - z * cy; return [W / 2 + r * k, H / 2 - (x * ct - f * st) * k, f * ct + x * st]; };
  const items = [];
  const face = (corners, rgb, twoSided) => {
    const q = corners.map(project);
    // The normal from the whole outline, so that a corner on the axis does no harm.
    let area = 0; q.forEach((p, i) => { const n = q[(i + 1) % q.length]; area += p[0] * n[1] - n[0] * p[1]; });
    if (!twoSided && area > 0) return;
    const e = [1, 2].map(i => q[i].map((v, d) => v - q[0][d])), n = [e[0][1] * e[1][2] - e[0][2] * e[1][1], e[0][2] * e[1][0] - e[0][0] * e[1][2], e[0][0] * e[1][1] - e[0][1] * e[1][0]];
    const len = Math.hypot(...n) || 1, light = 0.45 + 0.55 * Math.abs((n[0] * 0.35 - n[1] * 0.45) / len * 0.6 + n[2] / len * 0.8);
    items.push([q.reduce((s, p) => s + p[2], 0) / q.length, q, `rgb(${rgb.map(v => Math.round(v * light)).join()})`, true]);
  };
  for (const corners of pieces) face(corners, [168, 174, 184], true);
  if (P) for (let i = 0, prev = null; i < P.turn.length; i++) {
    const q = project(P.p.slice(3 * i, 3 * i + 3));
    if (prev) items.push([(prev[2] + q[2]) / 2 + size * 2e-3, [prev, q], turnColour(P.turns > 1 ? P.turn[i] / (P.turns - 1) : 0.5), false]);
    prev = q;
  }
  toolFaces((corners, rgb) => face(corners, rgb, true));
  items.sort((a, b) => a[0] - b[0]);
  c.lineJoin = 'round';
  for (const [, q, colour, filled] of items) {
    c.beginPath(); q.forEach((p, i) => i ? c.lineTo(p[0], p[1]) : c.moveTo(p[0], p[1]));
    c.strokeStyle = colour;
    if (filled) { c.closePath(); c.fillStyle = colour; c.fill(); c.lineWidth = 0.6; } else c.lineWidth = 1.4;
    c.stroke();
  }
  const style = getComputedStyle(document.documentElement);
  c.fillStyle = c.strokeStyle = style.getPropertyValue('--soft'); c.font = '12px system-ui'; c.lineWidth = 1.5;
  const o = project(mid);
  [['x (tip)', [1, 0, 0]], ['y', [0, 1, 0]], ['z', [0, 0, 1]]].forEach(([name, d]) => {
    const e = project(mid.map((v, i) => v + d[i] * 30 / k)), ex = 44 + e[0] - o[0], ey = H - 44 + e[1] - o[1];
    c.beginPath(); c.moveTo(44, H - 44); c.lineTo(ex, ey); c.stroke(); c.fillText(name, ex + 3, ey + 3);
  });
}
let dragging = null, queued = false;
const later = () => { if (!queued) { queued = true; requestAnimationFrame(() => { queued = false; drawScene(); }); } };
const pointers = new Map();
canvas.addEventListener('pointerdown', e => { pointers.set(e.pointerId, [e.clientX, e.clientY]); dragging = [e.clientX, e.clientY]; canvas.setPointerCapture(e.pointerId); });
canvas.addEventListener('pointermove', e => {
  if (!pointers.has(e.pointerId)) return;
  if (pointers.size === 2) {
    const span = () => { const [a, b] = [...pointers.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]) || 1; };
    const before = span(); pointers.set(e.pointerId, [e.clientX, e.clientY]); zoom = Math.max(0.2, Math.min(30, zoom * span() / before)); later(); return;
  }
  pointers.set(e.pointerId, [e.clientX, e.clientY]);
  if (!dragging) return;
  yaw += (e.clientX - dragging[0]) * 0.01; tilt = Math.max(-1.57, Math.min(1.57, tilt + (e.clientY - dragging[1]) * 0.01));
  dragging = [e.clientX, e.clientY]; later();
});
for (const kind of ['pointerup', 'pointercancel']) canvas.addEventListener(kind, e => { pointers.delete(e.pointerId); dragging = null; });
canvas.addEventListener('wheel', e => { if (!e.ctrlKey) return; e.preventDefault(); zoom = Math.max(0.2, Math.min(30, zoom * Math.exp(-e.deltaY * 0.002))); later(); }, {passive: false});
canvas.addEventListener('keydown', e => {
  const go = {ArrowLeft: () => yaw -= 0.1, ArrowRight: () => yaw += 0.1, ArrowUp: () => tilt = Math.min(1.57, tilt + 0.1), ArrowDown: () => tilt = Math.max(-1.57, tilt - 0.1), '+': () => zoom *= 1.2, '=': () => zoom *= 1.2, '-': () => zoom /= 1.2}[e.key];
  if (go) { go(); later(); e.preventDefault(); }
});
$('along').addEventListener('input', later);
$('show-tool').addEventListener('change', later);

// ---- start -------------------------------------------------------------------------------------------------------
redraw.push(drawScene);
setTheme(window.matchMedia && matchMedia('(prefers-color-scheme: dark)').matches);
drawTurns(); drawSection();
let width = innerWidth;
addEventListener('resize', () => { if (innerWidth !== width) { width = innerWidth; drawTurns(); drawSection(); } later(); });
})();
