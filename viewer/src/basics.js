// What all modules use: elements, numbers as text, places in lists.
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
