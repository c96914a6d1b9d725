// The line of the program that moves the tool to where it is.
import { $ } from './basics.js';
import { unpacked } from './data.js';

const P = JSON.parse($('program').textContent);
let texts = [];
let lines = [];
let until = [];

/** A whole number of last digits as the program has it. */
const written = (value, decimals, plus) => {
  const digits = String(Math.abs(value)).padStart(decimals + 1, '0');
  const at = digits.length - decimals;
  return `${value < 0 ? '-' : plus ? '+' : ''}${digits.slice(0, at)}${decimals ? `.${digits.slice(at)}` : ''}`;
};

/**
 * Makes the texts of all lines: how they are kept stands in src/write/preview/report/program.rs.
 */
export async function read() {
  if (!P) return;
  const lists = await unpacked(P.block);
  const next = P.columns.map(() => 0);
  const number = k => {
    const [decimals, plus, ref] = P.columns[k];
    return written(lists[ref][next[k]++], decimals, plus);
  };
  texts = Array.from(lists[P.frame_of], f => P.frames[f].map(p => (typeof p === 'string' ? p : number(p))).join(''));
  lines = lists[P.line];
  until = lists[P.until];
}

/** Shows the line that has brought the tool to where it is at a time, s, or is about to. */
export function show(t) {
  $('block').hidden = !texts.length;
  if (!texts.length) return;
  // The first line that ends no sooner; times are rounded, so a line that ends just there may seem
  // to end before.
  let [lo, hi] = [0, until.length - 1];
  while (lo < hi) {
    const mid = (lo + hi) >> 1;
    if (until[mid] < t - 1e-4) lo = mid + 1;
    else hi = mid;
  }
  $('block-where').textContent = `${P.file}, line ${lines[lo]}${P.every > 1 ? ` (one line in ${P.every} is shown)` : ''}`;
  const near = [lo - 1, lo, lo + 1].filter(k => k >= 0 && k < texts.length);
  $('block-lines').replaceChildren(...near.map(k => {
    const line = document.createElement(k === lo ? 'b' : 'span');
    line.textContent = texts[k];
    return line;
  }));
}
