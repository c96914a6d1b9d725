// The 3-D view: the scene that the page carries as glTF, the path of each tool in colours, the
// tools where the cursor is, two ways of motion.
//
// Everything lies in the blade frame, mm, under `carrier`; what turns on the machine is the
// carrier.
import {
  AmbientLight, BackSide, Box3, BufferAttribute, BufferGeometry, Color, DirectionalLight, DoubleSide, FrontSide, Group, Matrix4, Mesh, MeshBasicMaterial, MeshPhongMaterial, PerspectiveCamera, Plane, Points, PointsMaterial, Quaternion, Raycaster, Scene, Spherical, SRGBColorSpace, Vector3,
  WebGLRenderer, TOUCH,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { before } from './basics.js';
import { data, glb, list } from './data.js';
import { colourOf, shareOf } from './colour.js';
import { Ribbon } from './ribbon.js';

const S = data.scene;
const P = S.path;
const pick = names => Object.fromEntries(names.map(n => [n, list(P?.[n])]));
/** The path of the first tool. */
export const path = P ? { ...pick(['x', 'y', 'z', 's', 'turn_s', 't', 'theta', 'min', 'max', 'row', ...(P.ix ? ['ix', 'iy', 'iz'] : [])]), turn: list(P.quantities[0].of) } : null;

/**
 * The tools: names of their layers and of their nodes in the scene, sizes, the places of their
 * centres along the path, and either the lean or, by the first tool's lists, the axes. A second
 * tool stands on from the first by the angle `over`.
 */
const tools = [{ ...S, of: P }, ...(S.second ? [{ ...S.second, of: P?.second }] : [])].map(({ radius, length, of }, k, all) => ({
  name: all.length > 1 ? `tool ${k + 1}` : 'tool', node: all.length > 1 ? `tool_${k + 1}` : 'tool', way: k ? `path ${k + 1}` : 'path',
  radius, length, lean: of?.b, over: of?.over || 0, ...Object.fromEntries(['x', 'y', 'z'].map(n => [n, list(of?.[n])])),
}));
/** From which points on no piece of the path is drawn, where tools are lifted between rows. */
const lifted = P?.cuts == null ? null : list(P.cuts).map(v => 1 - v);

/** Where between two points of the path a time or an arc length is. */
const between = (rising, v) => {
  const i = Math.min(before(rising, v), Math.max(0, rising.length - 2));
  const span = rising[i + 1] - rising[i];
  return [i, span > 0 ? Math.min(1, Math.max(0, (v - rising[i]) / span)) : 0];
};
const mix = (of, [i, f]) => of[i] + (of[Math.min(i + 1, of.length - 1)] - of[i]) * f;
export const timeOf = s => mix(path.t, between(path.s, s));
export const placeOf = t => mix(path.s, between(path.t, t));

const axisOf = (b, theta) => new Vector3(Math.sin(b), Math.cos(b) * Math.cos(theta), Math.cos(b) * Math.sin(theta));
const rigid = ({ q, t }) => new Matrix4().compose(new Vector3(...t), new Quaternion(...q), new Vector3(1, 1, 1));

export class View {
  constructor(canvas, onPick) {
    this.canvas = canvas;
    this.onPick = onPick;
    this.slow = withoutCard();
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.slow, preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = SRGBColorSpace;
    this.renderer.localClippingEnabled = true;
    // Milliseconds of rest after which the picture is drawn anew with finer pixels, where smooth
    // edges are too dear in motion.
    this.patience = this.slow ? 600 : Infinity;
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(30, 1, 1, 10000);
    this.carrier = new Group();
    this.carrier.matrixAutoUpdate = false;
    this.tools = tools.map(t => ({ ...t, group: new Group(), place: null, lines: null }));
    for (const { group } of this.tools) {
      group.matrixAutoUpdate = false;
      this.carrier.add(group);
    }
    this.scene.add(this.carrier, this.camera, new AmbientLight(0xffffff, 1.1));
    const sun = new DirectionalLight(0xffffff, 2.4);
    sun.position.set(-0.6, 0.9, 1);
    this.camera.add(sun);
    this.mode = 'part';
    this.s = 0;
    this.turns = [1, P?.turns || 1];
    this.cut = null;
    this.plane = new Plane();
    this.layers = new Map();
    this.frame();
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.touches = { ONE: TOUCH.ROTATE, TWO: TOUCH.DOLLY_PAN };
    canvas.style.touchAction = 'pan-y';
    // The page scrolls by the wheel unless the view was clicked or Ctrl is held.
    canvas.parentElement.addEventListener('wheel', e => {
      if (!e.ctrlKey && document.activeElement !== canvas) e.stopPropagation();
    }, { capture: true, passive: true });
    this.controls.addEventListener('change', () => this.invalidate());
    this.listen();
    this.addPath();
    this.addScallop();
    this.place();
    this.look('side');
    new ResizeObserver(() => this.canvas.isConnected && this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  /** The path of the first tool. */
  get lines() { return this.tools[0].lines; }

  /** Centre and axis of the first tool where it stands. */
  get toolPlace() { return this.tools[0].place; }

  /** The glTF part of the page; resolves when it is shown. */
  async load() {
    const file = glb();
    if (!file) { this.loaded = true; return; }
    const loaded = await new GLTFLoader().parseAsync(file, '');
    const nodes = {};
    loaded.scene.traverse(n => { nodes[n.name] ??= n; });
    const workpiece = nodes.workpiece;
    if (workpiece) {
      workpiece.matrixAutoUpdate = false;
      workpiece.matrix.copy(rigid(S.model_from_blade).invert());
      this.carrier.add(workpiece);
      for (const child of workpiece.children) {
        this.layers.set(child.name === 'table' ? 'machine' : child.userData.name || child.name, [child]);
        const meshes = [];
        child.traverse(m => { if (m.material) meshes.push(m); });
        for (const m of meshes) this.prepare(m, child.name === 'blade');
      }
    }
    for (const tool of this.tools) {
      if (!nodes[tool.node]) continue;
      for (const part of [...nodes[tool.node].children]) {
        tool.group.add(part);
        if (part.name.startsWith('head')) this.layers.set('machine', [...(this.layers.get('machine') || []), part]);
        part.traverse(m => { if (m.material) m.material = plain(m.material); });
      }
      this.layers.set(tool.name, [tool.group]);
    }
    this.loaded = true;
    this.place();
  }

  prepare(mesh, solid) {
    const m = mesh.material = plain(mesh.material);
    (this.clipped ??= []).push(m);
    if (solid) {
      m.side = FrontSide;
      // What is seen inside of a cut is the back of the far wall: painted flat, it looks like the
      // cut itself.
      const inside = new Mesh(mesh.geometry, new MeshBasicMaterial({ color: 0xb5651d, side: BackSide }));
      inside.visible = false;
      mesh.add(inside);
      (this.insides ??= []).push(inside);
      this.clipped.push(inside.material);
    }
  }

  frame() {
    const box = S.box || [[-1, -1, -1], [1, 1, 1]];
    const extent = (lists, fallback) => lists.map((l, k) => (l?.length ? [Math.min(...minmax(l)), Math.max(...minmax(l))] : [fallback[0][k], fallback[1][k]]));
    const blade = [0, 1, 2].map(k => [box[0][k], box[1][k]]);
    // Where tools are lifted between rows there is nothing to see.
    const along = l => (lifted ? l.filter((_, i) => !lifted[i]) : l);
    const own = path?.x.length ? extent(['x', 'y', 'z'].map(n => tools.flatMap(t => [...along(t[n])])), box) : blade;
    const diagonal = e => Math.hypot(...e.map(([a, b]) => b - a));
    const chosen = diagonal(blade) < 2.2 * diagonal(own) ? blade.map(([a, b], k) => [Math.min(a, own[k][0]), Math.max(b, own[k][1])]) : own;
    this.seen = chosen;
    this.target = new Vector3(...chosen.map(([a, b]) => (a + b) / 2));
    this.reach = 0.5 * diagonal(chosen);
  }

  /** Matrices of carrier and tool for the place and way of motion. */
  place() {
    let theta = 0;
    if (path?.x.length) {
      const at = between(path.s, this.s);
      theta = mix(path.theta, at);
      for (const tool of this.tools) {
        const centre = new Vector3(mix(tool.x, at), mix(tool.y, at), mix(tool.z, at));
        const z = new Vector3(0, 0, 1);
        if (path.ix) {
          // Each location has a cone of its own: the tool axis itself is given, and the table turns
          // with it.
          const axis = new Vector3(mix(path.ix, at), mix(path.iy, at), mix(path.iz, at)).normalize();
          theta = Math.atan2(axis.z, axis.y);
          tool.group.matrix.compose(centre, new Quaternion().setFromUnitVectors(z, axis), new Vector3(1, 1, 1));
          tool.place = { centre, axis };
        } else {
          const lean = new Quaternion().setFromUnitVectors(z, axisOf(tool.lean, 0));
          const turn = new Quaternion().setFromAxisAngle(new Vector3(1, 0, 0), theta + tool.over);
          tool.group.matrix.compose(centre, turn.multiply(lean), new Vector3(1, 1, 1));
          tool.place = { centre, axis: axisOf(tool.lean, theta + tool.over) };
        }
      }
    }
    const [x, y, z] = [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)];
    if (this.mode === 'part') {
      // Blade x is up.
      this.carrier.matrix.makeBasis(y, z, x).premultiply(new Matrix4()).multiply(new Matrix4().makeTranslation(this.target.clone().negate()));
    } else {
      if (P?.part) { this.placeOnMachine(); return this.placed(); }
      const [cy, cz] = S.machine.axis;
      const phi = S.machine.turn[0] + S.machine.turn[1] * theta;
      const table = new Matrix4().makeTranslation(0, cy, cz)
        .multiply(new Matrix4().makeRotationX(phi))
        .multiply(new Matrix4().makeTranslation(0, -cy, -cz))
        .multiply(rigid(S.machine.part_at_zero));
      const mid = this.target.clone().applyMatrix4(rigid(S.machine.part_at_zero));
      // Machine Z is up.
      this.carrier.matrix.makeBasis(x, z.clone().negate(), y).multiply(new Matrix4().makeTranslation(-mid.x, -cy, -cz)).multiply(table);
    }
    this.placed();
  }

  /** The part where the machine's axes carry it, about where it was first. */
  placeOnMachine() {
    const at = between(path.s, this.s);
    const lists = P.part.map(list);
    const [qx, qy, qz, qw, x, y, z] = lists.map(of => mix(of, at));
    const first = rigid({ q: new Quaternion(...lists.slice(0, 4).map(of => of[0])).normalize(), t: lists.slice(4).map(of => of[0]) });
    const mid = this.target.clone().applyMatrix4(first);
    const part = rigid({ q: new Quaternion(qx, qy, qz, qw).normalize(), t: [x, y, z] });
    // Machine Z is up.
    this.carrier.matrix.makeBasis(new Vector3(1, 0, 0), new Vector3(0, 0, -1), new Vector3(0, 1, 0)).multiply(new Matrix4().makeTranslation(-mid.x, -mid.y, -mid.z)).multiply(part);
  }

  /** What follows from the carrier's new place. */
  placed() {
    this.carrier.matrixWorldNeedsUpdate = true;
    this.carrier.updateMatrixWorld(true);
    if (this.cut != null) this.plane.set(new Vector3(-1, 0, 0), this.cut).applyMatrix4(this.carrier.matrixWorld);
    this.invalidate();
  }

  setPlace(s) { this.s = s; this.place(); }
  setMode(mode) { this.mode = mode; this.place(); this.look(mode === 'part' ? 'side' : 'front'); }

  /** Height of the section along the blade axis, mm; null: none. */
  setCut(x) {
    this.cut = x;
    const planes = x == null ? null : [this.plane];
    for (const m of [...(this.clipped || []), ...this.tools.map(t => t.lines?.material), this.dots?.material]) {
      if (m) { m.clippingPlanes = planes; m.needsUpdate = true; }
    }
    for (const m of this.insides || []) m.visible = x != null;
    this.place();
  }

  /** Colours of a layer that the page's scale of colours does not say, as CSS. */
  coloursOf(name) {
    const found = new Set();
    for (const n of this.layers.get(name) || []) n.traverse(m => { if (m.material?.color && !m.material.map) found.add(`#${m.material.color.getHexString()}`); });
    return [...found];
  }

  setLayer(name, on) {
    for (const t of this.tools) if (name === t.way && t.lines) t.lines.visible = on;
    if (name === 'scallop' && this.dots) this.dots.visible = on;
    for (const n of this.layers.get(name) || []) n.visible = on;
    this.invalidate();
  }

  addPath() {
    if (!path?.x.length) return;
    for (const tool of this.tools) {
      const { x, y, z } = tool;
      tool.lines = new Ribbon({ x, y, z, gaps: lifted }, data.colours, data.no_colour, 2);
      // Without a graphics card each piece of the line takes its time: from afar, fewer do, half a
      // pixel off at most.
      if (this.slow) tool.lines.thin(x, y, z, this.reach / 600, this.reach / 75);
      this.carrier.add(tool.lines);
    }
    this.setTurns(...this.turns);
    this.setColouring(0);
  }

  /** Shows turns `from` to `to`, from 1. */
  setTurns(from, to) {
    const first = Math.max(0, path.turn.findIndex(t => t >= from));
    let last = path.turn.length - 1;
    while (last > first && path.turn[last] > to) last--;
    this.shown = [first, last];
    for (const t of this.tools) t.lines?.range(first, last);
    this.invalidate();
  }

  /** Colours the path by its quantity `k`. */
  setColouring(k) {
    const q = P.quantities[k];
    const shares = list(q.of).map(v => shareOf(v, q.shown));
    for (const t of this.tools) t.lines?.colour(shares);
    this.invalidate();
  }

  addScallop() {
    const m = data.scallop?.map;
    if (!list(m?.height).length) return;
    const [h, x, y, z] = [m.height, m.x, m.y, m.z].map(list);
    const [at, rgb, c] = [new Float32Array(3 * h.length), new Float32Array(3 * h.length), new Color()];
    h.forEach((v, i) => {
      at.set([x[i], y[i], z[i]], 3 * i);
      c.setRGB(...colourOf(shareOf(v, m.shown)), SRGBColorSpace);
      rgb.set([c.r, c.g, c.b], 3 * i);
    });
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(at, 3));
    geometry.setAttribute('color', new BufferAttribute(rgb, 3));
    this.dots = new Points(geometry, new PointsMaterial({ size: 4, sizeAttenuation: false, vertexColors: true }));
    this.dots.visible = false;
    this.carrier.add(this.dots);
  }

  /**
   * Looks from a side, so near that all that matters fills the picture: blade or path, the tool
   * where it stands, and on the machine what is shown of that.
   */
  look(from) {
    this.from = from;
    const way = this.wayTo(from).normalize();
    const right = new Vector3(0, 1, 0).cross(way).normalize();
    const up = way.clone().cross(right);
    const half = Math.tan((Math.PI / 360) * this.camera.fov);
    // The program's line lies over the upper edge of the picture.
    const [down, top, across] = [half * 0.92, half * (1 - Math.min(0.35, 160 / (this.height || 500))), half * this.camera.aspect * 0.92];
    // A point is seen where it is no farther to a side than the pyramid of sight is wide at its
    // depth: the steepest decide about both the place beside which the camera stands and its
    // distance.
    const most = [-Infinity, -Infinity, -Infinity, -Infinity];
    for (const p of this.wanted()) {
      const [u, v, w] = [p.dot(right), p.dot(up), p.dot(way)];
      [u + w * across, -u + w * across, v + w * top, -v + w * down].forEach((m, k) => { if (m > most[k]) most[k] = m; });
    }
    const far = this.far = Math.max((most[0] + most[1]) / (2 * across), (most[2] + most[3]) / (top + down), 1e-3);
    const level = (most[2] - most[3] + far * (down - top)) / 2;
    const target = right.multiplyScalar((most[0] - most[1]) / 2).addScaledVector(up, level);
    this.camera.position.copy(target).addScaledVector(way, far);
    this.camera.near = far / 100;
    this.camera.far = far * 20;
    this.camera.updateProjectionMatrix();
    this.controls?.target.copy(target);
    this.controls?.update();
    this.invalidate();
  }

  /** Points that must be in the picture, as they stand. */
  wanted() {
    const corners = box => [0, 1, 2, 3, 4, 5, 6, 7].map(k => new Vector3(...[0, 1, 2].map(i => box[i][(k >> i) & 1])));
    const out = corners(this.seen).map(p => p.applyMatrix4(this.carrier.matrixWorld));
    for (const tool of this.tools) {
      if (!tool.place || !tool.group.visible || !this.layers.has(tool.name)) continue;
      // Of a long tool as much as the blade is large, and of two tools less: the rest would make
      // all of it small.
      const most = (this.tools.length > 1 ? 0.8 : 1.3) * this.reach;
      const length = this.mode === 'part' ? Math.min(tool.length, most) : tool.length;
      const { centre, axis } = tool.place;
      for (const l of [-tool.radius, length]) out.push(centre.clone().addScaledVector(axis, l).applyMatrix4(this.carrier.matrixWorld));
    }
    for (const n of this.mode === 'machine' ? this.layers.get('machine') || [] : []) {
      if (!n.visible) continue;
      const { min, max } = new Box3().setFromObject(n);
      out.push(...corners([0, 1, 2].map(k => [min.getComponent(k), max.getComponent(k)])));
    }
    return out;
  }

  /** The way from what is looked at to the eye. */
  wayTo(from) {
    const axis = this.toolPlace?.axis.clone().transformDirection(this.carrier.matrixWorld);
    const at = (azimuth, up) => new Vector3(Math.sin(azimuth) * Math.cos(up), Math.sin(up), Math.cos(azimuth) * Math.cos(up));
    const deg = Math.PI / 180;
    if (from === 'tip') return this.mode === 'part' ? new Vector3(0.02, 1, 0.02) : new Vector3(1, 0.15, 0.1);
    if (from === 'tool' && axis) return new Vector3(axis.x, axis.y + 0.25, axis.z);
    // From the side of the tool, at an angle to it, and where nothing of the blade is before it;
    // the machine as far from its front as need be.
    const level = from === 'front' || !axis || Math.hypot(axis.x, axis.z) < 0.2;
    const around = level ? 7 * deg : this.besideTools();
    const turns = from === 'front' ? [0, 25, -25, 50, -50, 75, -75, 110, -110, 180] : this.tools.length > 1 ? [0, 180, 15, -15, 165, -165, 30, -30, 150, -150] : [50, -50, 65, -65, 35, -35, 85, -85, 15, -15];
    const rise = (from === 'front' ? [17, 40] : [22, 45, 5]).map(r => r * deg);
    const all = rise.flatMap(r => turns.map(t => at(around + t * deg, r)));
    return (this.toolPlace && all.find(way => this.clear(way))) || all[0];
  }

  /**
   * The way round, rad, from which one tool is looked at; of two tools the way midway between them
   * on the side where that is farther from both.
   */
  besideTools() {
    const [first, second] = this.tools.map(({ place }) => {
      const axis = place.axis.clone().transformDirection(this.carrier.matrixWorld);
      return Math.atan2(axis.x, axis.z);
    });
    if (second === undefined) return first;
    const half = ((second - first + 2 * Math.PI) % (2 * Math.PI)) / 2;
    return first + half + (half < Math.PI / 2 ? Math.PI : 0);
  }

  /** Whether the blade leaves the lower ends of all tools in sight of an eye far off that way. */
  clear(way) {
    const blade = this.layers.get('blade')?.[0];
    if (!blade) return true;
    return this.tools.every(({ place: { centre, axis }, radius }) => [0, 2.5].every(radii => {
      const p = centre.clone().addScaledVector(axis, radii * radius).applyMatrix4(this.carrier.matrixWorld);
      return !this.ray(blade, p, way);
    }));
  }

  /** Whether a ray meets the faces of a node on the side that they are seen from. */
  ray(node, from, way) {
    const caster = new Raycaster(from, way);
    // What looks like the inside of a cut is no second blade.
    const meshes = [];
    node.traverse(m => { if (m.isMesh && !(this.insides || []).includes(m)) meshes.push(m); });
    return meshes.some(m => {
      const was = m.material.side;
      m.material.side = DoubleSide;
      const hits = caster.intersectObject(m, false).length;
      m.material.side = was;
      return hits > 0;
    });
  }

  listen() {
    let down = null;
    this.canvas.addEventListener('pointerdown', e => { down = [e.clientX, e.clientY]; this.canvas.focus({ preventScroll: true }); });
    this.canvas.addEventListener('click', e => {
      if (!down || Math.hypot(e.clientX - down[0], e.clientY - down[1]) > 4) return;
      const i = this.nearest(e);
      if (i >= 0) this.onPick(i, true, e);
    });
    let queued = false;
    this.canvas.addEventListener('pointermove', e => {
      if (e.buttons || queued) return;
      queued = true;
      requestAnimationFrame(() => { queued = false; this.onPick(this.nearest(e), false, e); });
    });
    this.canvas.addEventListener('pointerleave', e => this.onPick(-1, false, e));
    this.canvas.addEventListener('keydown', e => {
      const step = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[e.key];
      const zoom = { '+': 0.85, '=': 0.85, '-': 1 / 0.85 }[e.key];
      if (!step && !zoom) return;
      const at = new Spherical().setFromVector3(this.camera.position.clone().sub(this.controls.target));
      if (step) { at.theta += step[0]; at.phi = Math.min(3.1, Math.max(0.05, at.phi + step[1])); }
      if (zoom) at.radius *= zoom;
      this.camera.position.setFromSpherical(at).add(this.controls.target);
      this.controls.update();
      this.invalidate();
      e.preventDefault();
    });
  }

  /**
   * Index of the path's point under the pointer: the nearest to the eye of those within some
   * pixels; −1 without one.
   */
  nearest(e) {
    const seen = this.tools.filter(t => t.lines?.visible);
    if (!path || !seen.length) return -1;
    const r = this.canvas.getBoundingClientRect();
    const [px, py] = [e.clientX - r.left, e.clientY - r.top];
    const m = new Matrix4().multiplyMatrices(this.camera.projectionMatrix, this.camera.matrixWorldInverse).multiply(this.carrier.matrixWorld).elements;
    const within = e.pointerType === 'touch' ? 18 : 7;
    let [best, depth] = [-1, Infinity];
    for (let k = this.shown[0] * seen.length; k < (this.shown[1] + 1) * seen.length; k++) {
      const [i, t] = [Math.floor(k / seen.length), seen[k % seen.length]];
      if (lifted?.[i]) continue;
      const [x, y, z] = [t.x[i], t.y[i], t.z[i]];
      if (this.cut != null && x > this.cut) continue;
      const w = m[3] * x + m[7] * y + m[11] * z + m[15];
      const u = ((m[0] * x + m[4] * y + m[8] * z + m[12]) / w + 1) * 0.5 * r.width;
      const v = (1 - (m[1] * x + m[5] * y + m[9] * z + m[13]) / w) * 0.5 * r.height;
      if (w > 0 && w < depth && Math.abs(u - px) < within && Math.abs(v - py) < within) [best, depth] = [i, w];
    }
    return best;
  }

  resize() {
    const box = this.canvas.parentElement.getBoundingClientRect();
    if (!box.width || !box.height || (box.width === this.width && box.height === this.height)) return;
    [this.width, this.height] = [box.width, box.height];
    const was = this.camera.aspect;
    this.ratio = this.slow ? 1 : Math.min(2, devicePixelRatio || 1);
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(box.width, box.height, false);
    this.camera.aspect = box.width / box.height;
    this.camera.updateProjectionMatrix();
    if (!this.sized || (was < 1) !== (this.camera.aspect < 1)) { this.sized = true; this.look(this.from); }
    this.render();
  }

  theme() {
    const back = getComputedStyle(document.documentElement).getPropertyValue('--stage').trim();
    this.scene.background = new Color(back);
    this.invalidate();
  }

  invalidate() {
    if (this.queued) return;
    this.queued = true;
    requestAnimationFrame(() => { this.queued = false; this.render(); });
  }

  /** Draws, once everything is there. */
  render() {
    if (!this.loaded) return;
    const near = this.camera.position.distanceTo(this.controls.target) < 0.3 * this.far;
    if (this.slow) for (const t of this.tools) t.lines?.fine(near);
    if (this.renderer.getPixelRatio() !== this.ratio) this.renderer.setPixelRatio(this.ratio);
    this.renderer.render(this.scene, this.camera);
    clearTimeout(this.rest);
    if (this.patience < Infinity) this.rest = setTimeout(() => this.refine(), this.patience);
  }

  /** Draws with finer pixels, at once. */
  refine() {
    if (!this.loaded) return;
    this.renderer.setPixelRatio(2);
    this.renderer.render(this.scene, this.camera);
  }

  /** Draws and waits for the picture. */
  finish() {
    this.render();
    const gl = this.renderer.getContext();
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }
}

/** Whether this browser draws with the processor alone. */
function withoutCard() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const named = gl?.getExtension('WEBGL_debug_renderer_info');
  const words = gl ? gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(words);
}

/**
 * A material that takes a processor half the time of the physical one, and looks no worse without
 * surroundings to mirror.
 */
function plain(m) {
  if (!m.isMeshStandardMaterial) return m;
  const { name, color, side, vertexColors, transparent, opacity, flatShading } = m;
  return new MeshPhongMaterial({ name, color, side, vertexColors, transparent, opacity, flatShading, specular: 0x1c1c1c, shininess: 24 });
}

export function minmax(l) {
  let [lo, hi] = [Infinity, -Infinity];
  for (const v of l) { if (v < lo) lo = v; if (v > hi) hi = v; }
  return [lo, hi];
}
