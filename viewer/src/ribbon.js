// Lines some pixels wide. WebGL draws lines one pixel wide only; three.js' fat lines are instanced, which takes seconds a frame where the browser
// draws without a graphics card. Here each point is two vertices that the vertex shader moves apart across the line on the screen.
import { BufferAttribute, BufferGeometry, Color, DoubleSide, InterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial, Vector2, Vector3 } from 'three';

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
  /** `x`, `y`, `z`: the points; `stops`: colours of the scale; `none`: where there is no value; `width` in pixels. */
  constructor(x, y, z, stops, none, width) {
    const n = x.length;
    const at = new Float32Array(6 * (n + 2));
    for (let i = -1; i <= n; i++) {
      const k = Math.min(n - 1, Math.max(0, i));
      const o = 6 * (i + 1);
      at[o] = at[o + 3] = x[k]; at[o + 1] = at[o + 4] = y[k]; at[o + 2] = at[o + 5] = z[k];
    }
    const index = new Uint32Array(6 * Math.max(0, n - 1));
    for (let i = 0, o = 0; i + 1 < n; i++, o += 6) {
      const a = 2 * i;
      index[o] = a; index[o + 1] = a + 1; index[o + 2] = a + 2; index[o + 3] = a + 2; index[o + 4] = a + 1; index[o + 5] = a + 3;
    }
    // One list of points seen from three places: the one before, the point itself, the one after.
    const points = new InterleavedBuffer(at, 3);
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new InterleavedBufferAttribute(points, 3, 6));
    geometry.setAttribute('before', new InterleavedBufferAttribute(points, 3, 0));
    geometry.setAttribute('after', new InterleavedBufferAttribute(points, 3, 12));
    geometry.setAttribute('share', new BufferAttribute(new Float32Array(2 * n), 1));
    geometry.setIndex(new BufferAttribute(index, 1));
    // Colours are those of the page: they pass as they are.
    const colour = hex => { const c = new Color(hex).convertLinearToSRGB(); return new Vector3(c.r, c.g, c.b); };
    super(geometry, new ShaderMaterial({
      uniforms: { stops: { value: stops.map(colour) }, none: { value: colour(none) }, width: { value: width }, size: { value: new Vector2(1, 1) } },
      vertexShader: vertex, fragmentShader: fragment(stops.length), side: DoubleSide, clipping: true,
    }));
    this.frustumCulled = false;
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
  range(first, last) { this.geometry.setDrawRange(6 * first, 6 * Math.max(0, last - first)); }
}
