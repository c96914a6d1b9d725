// The page's data: JSON, and one block of lists of numbers that it refers to by their places in the
// block.
const inflated = async text => {
  const raw = Uint8Array.fromBase64 ? Uint8Array.fromBase64(text) : Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const stream = new Blob([raw]).stream().pipeThrough(new DecompressionStream('deflate-raw'));
  return new Response(stream).arrayBuffer();
};

export const data = JSON.parse(document.getElementById('data').textContent);
const none = new Float64Array();
let lists = [];
let scene = null;

/** Reads what is deflated; nothing else of the page's script may run before. */
export async function unpack() {
  const [numbers, file] = await Promise.all(['numbers', 'scene-glb'].map(async id => {
    const text = document.getElementById(id).textContent;
    return text ? (id === 'numbers' ? unpacked(text) : inflated(text)) : null;
  }));
  lists = numbers || [];
  scene = file;
}

/** All lists of a block. */
export const unpacked = async text => read(new Uint8Array(await inflated(text)));

/** Lists from bytes: how a block is written stands in src/write/preview/report/pack.rs. */
function read(bytes) {
  const all = [];
  let at = 0;
  // Numbers may be longer than the 32 bits that shifts know.
  const next = () => {
    let [value, unit] = [0, 1];
    for (;;) {
      const byte = bytes[at++];
      value += (byte & 127) * unit;
      if (byte < 128) return value;
      unit *= 128;
    }
  };
  while (at < bytes.length) {
    const out = new Float64Array(next());
    const digits = bytes[at++] - 32;
    const order = bytes[at++];
    // Powers of ten are whole numbers, so that what comes out is the decimal number nearest to it.
    const scale = 10 ** Math.abs(digits);
    // The last three, the latest first.
    let [a, b, c] = [0, 0, 0];
    for (let i = 0; i < out.length; i++) {
      const code = next();
      if (!code) { out[i] = NaN; continue; }
      const off = code % 2 ? (code - 1) / 2 : -code / 2;
      const step = off + [0, a, 2 * a - b, 3 * (a - b) + c][order];
      [a, b, c] = [step, a, b];
      out[i] = digits < 0 ? step * scale : step / scale;
    }
    all.push(out);
  }
  return all;
}

/** The list that a reference means; an empty one where there is none. */
export const list = ref => (ref == null ? none : lists[ref]);

/** The scene as a .glb file, or null. */
export const glb = () => scene;
