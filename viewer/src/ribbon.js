// Lines some pixels wide. WebGL draws lines one pixel wide only; three.js' fat lines are instanced,
// which takes seconds a frame where the browser draws without a graphics card. Here each point is
// two vertices that the vertex shader moves apart across the line on the screen.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, InterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial, Sphere, Vector2, Vector3 } from 'three';
import { before } from './basics.js';

const vertex = `
#include <clipping_planes_pars_vertex>
attribute vec3 before;
attribute vec3 after;
attribute float share;
uniform vec2 size;
uniform float width;
varying float vShare;
vec2 seen(vec4 p) { return 0.5 * size * p.xy / max(p.w, 1e-6); }
void main() {
  vShare = share;
  vec4 mvPosition = modelViewMatrix * vec4(position, 1.0);
  vec4 here = projectionMatrix * mvPosition;
  vec2 along = seen(projectionMatrix * modelViewMatrix * vec4(after, 1.0)) - seen(projectionMatrix * modelViewMatrix * vec4(before, 1.0));
  float reach = length(along);
  vec2 across = reach > 1e-6 ? vec2(-along.y, along.x) / reach : vec2(0.0, 1.0);
  float side = gl_VertexID % 2 == 0 ? 1.0 : -1.0;
  gl_Position = here + vec4(side * width * across / size * here.w, 0.0, 0.0);
  #include <clipping_planes_vertex>
}`;
const fragment = stops => `
#include <clipping_planes_pars_fragment>
uniform vec3 stops[${stops}];
uniform vec3 none;
varying float vShare;
void main() {
  #include <clipping_planes_fragment>
  float x = clamp(vShare, 0.0, 1.0) * ${(stops - 1).toFixed(1)};
  int i = int(min(floor(x), ${(stops - 2).toFixed(1)}));
  gl_FragColor = vec4(vShare < 0.0 ? none : mix(stops[i], stops[i + 1], x - float(i)), 1.0);
}`;

/** A line through points, coloured by a share from 0 to 1 at each; below 0: not known. */
export class Ribbon extends Mesh {
  /**
   * `x`, `y`, `z`: the points; `gaps`: not 0 at points from which on nothing is drawn up to the
   * next, or null; `stops`: colours of the scale; `none`: where there is no value; `width` in
   * pixels.
   */
  constructor({ x, y, z, gaps }, stops, none, width) {
    const n = x.length;
    const at = new Float32Array(6 * (n + 2));
    for (let i = -1; i <= n; i++) {
      const k = Math.min(n - 1, Math.max(0, i));
      const o = 6 * (i + 1);
      at[o] = at[o + 3] = x[k]; at[o + 1] = at[o + 4] = y[k]; at[o + 2] = at[o + 5] = z[k];
    }
    // One list of points seen from three places: the one before, the point itself, the one after.
    const points = new InterleavedBuffer(at, 3);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new InterleavedBufferAttribute(points, 3, 6));
    geometry.setAttribute('before', new InterleavedBufferAttribute(points, 3, 0));
    geometry.setAttribute('after', new InterleavedBufferAttribute(points, 3, 12));
    geometry.setAttribute('share', new BufferAttribute(new Float32Array(2 * n), 1));
    // Only the order of drawing asks for it, and the list above has more points than the line.
    geometry.boundingSphere = new Sphere(new Vector3(x[n >> 1], y[n >> 1], z[n >> 1]), 1);
    // Colours are those of the page: they pass as they are.
    const colour = hex => { const c = new Color(hex).convertLinearToSRGB(); return new Vector3(c.r, c.g, c.b); };
    super(geometry, new ShaderMaterial({
      uniforms: { stops: { value: stops.map(colour) }, none: { value: colour(none) }, width: { value: width }, size: { value: new Vector2(1, 1) } },
      vertexShader: vertex, fragmentShader: fragment(stops.length), side: DoubleSide, clipping: true,
    }));
    this.frustumCulled = false;
    this.gaps = gaps;
    this.all = Uint32Array.from({ length: n }, (_, i) => i);
    this.few = this.all;
    this.ends = [0, n - 1];
    this.take(this.all);
    this.onBeforeRender = renderer => {
      renderer.getDrawingBufferSize(this.material.uniforms.size.value);
      this.material.uniforms.width.value = width * renderer.getPixelRatio();
    };
  }

  /** Shares of all points. */
  colour(shares) {
    const own = this.geometry.attributes.share;
    for (let i = 0; i < shares.length; i++) own.array[2 * i] = own.array[2 * i + 1] = Number.isFinite(shares[i]) ? shares[i] : -1;
    own.needsUpdate = true;
  }

  /** Shows the line from point `first` to point `last` only. */
  range(first, last) {
    this.ends = [first, last];
    const from = before(this.kept, first);
    this.geometry.setDrawRange(6 * from, 6 * Math.max(0, before(this.kept, last) - from));
  }

  /**
   * From here on the line can be drawn with fewer points: those that leave it by no more than
   * `off`, and no farther apart than `apart`.
   */
  thin(x, y, z, off, apart) {
    const kept = [0];
    let [length, angle] = [0, 0];
    let was = null;
    for (let i = 1; i < x.length; i++) {
      const d = new Vector3(x[i] - x[i - 1], y[i] - y[i - 1], z[i] - z[i - 1]);
      const step = d.length();
      if (was && step > 0) angle += d.angleTo(was);
      if (step > 0) was = d;
      // An arc that turns by an angle is off its chord by an eighth of angle times length. A gap
      // begins and ends where it does.
      const edge = this.gaps && (this.gaps[i - 1] || this.gaps[i - 2]);
      if (kept[kept.length - 1] !== i - 1 && (edge || length + step > apart || ((length + step) * angle) / 8 > off)) {
        kept.push(i - 1);
        [length, angle] = [0, 0];
      }
      length += step;
    }
    kept.push(x.length - 1);
    this.few = Uint32Array.from(kept);
  }

  /** Draws all points, or few of them. */
  fine(all) {
    const kept = all ? this.all : this.few;
    if (kept !== this.kept) { this.take(kept); this.range(...this.ends); }
  }

  take(kept) {
    this.kept = kept;
    const index = new Uint32Array(6 * Math.max(0, kept.length - 1));
    for (let i = 0, o = 0; i + 1 < kept.length; i++, o += 6) {
      // Pieces of no size are not drawn, and the number of all stays as it is.
      if (this.gaps?.[kept[i]]) continue;
      const [a, b] = [2 * kept[i], 2 * kept[i + 1]];
      index[o] = a; index[o + 1] = a + 1; index[o + 2] = b; index[o + 3] = b; index[o + 4] = a + 1; index[o + 5] = b + 1;
    }
    this.geometry.index?.array && this.geometry.dispose();
    this.geometry.setIndex(new BufferAttribute(index, 1));
  }
}
