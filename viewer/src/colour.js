import { data, show } from './data.js';

const parse = hex => [1, 3, 5].map(k => parseInt(hex.slice(k, k + 2), 16) / 255);
const stops = data.colours.map(parse);
const none = parse(data.no_colour);

/** sRGB, 0 to 1, of a share from 0 (dark) to 1 (bright); grey where it is not a number. */
export const colourOf = share => {
  if (!Number.isFinite(share)) return none;
  const x = Math.min(1, Math.max(0, share)) * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(x));
  return stops[i].map((v, k) => v + (stops[i + 1][k] - v) * (x - i));
};

export const css = ([r, g, b]) => `rgb(${[r, g, b].map(v => Math.round(255 * v)).join()})`;

/** Share of a value in a range; one half where all are alike. */
export const shareOf = (v, [lo, hi]) => (hi - lo > 1e-9 * Math.max(Math.abs(lo), Math.abs(hi)) ? (v - lo) / (hi - lo) : v === v ? 0.5 : NaN);

/** A legend: the scale with least, middle and greatest value. */
export const legend = (name, unit, range, missing) => {
  const mid = (range[0] + range[1]) / 2;
  const bar = data.colours.map((c, k) => `${c} ${(100 * k) / (data.colours.length - 1)}%`).join(',');
  const words = [range[0], mid, range[1]].map(v => `<span>${show(v)}</span>`).join('');
  return `<b>${name}${unit ? `, ${unit}` : ''}</b><i style="background:linear-gradient(90deg,${bar})"></i><span class="ends">${words}</span>${missing ? '<small>grey: not measured</small>' : ''}`;
};
