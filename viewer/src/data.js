// The page's data: JSON, and one block of 32-bit numbers that lists refer to by {at, n}.
const bytes = id => {
  const text = document.getElementById(id).textContent;
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text).buffer;
  const raw = atob(text);
  const out = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) out[i] = raw.charCodeAt(i);
  return out.buffer;
};

export const data = JSON.parse(document.getElementById('data').textContent);
const numbers = new Float32Array(bytes('numbers'));

/** The list that a reference means; an empty one where there is none. */
export const list = ref => (ref ? numbers.subarray(ref.at, ref.at + ref.n) : new Float32Array());

/** The scene as a .glb file, or null. */
export const glb = () => (document.getElementById('scene-glb').textContent ? bytes('scene-glb') : null);

export const $ = id => document.getElementById(id);
export const minus = text => String(text).replace('-', '−');

/** A number for people: five digits that count. */
export const show = v => (v == null || !Number.isFinite(v) ? '–' : minus(Math.abs(v) < 1e-9 ? 0 : +v.toPrecision(5)));

/** Index of the last value not above x in a rising list. */
export const before = (rising, x) => {
  let lo = 0;
  let hi = rising.length - 1;
  while (lo < hi) {
    const mid = (lo + hi + 1) >> 1;
    if (rising[mid] <= x) lo = mid;
    else hi = mid - 1;
  }
  return lo;
};
