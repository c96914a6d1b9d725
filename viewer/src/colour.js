import { show } from './basics.js';
import { data } from './data.js';

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

/** Share of a value in a range, 0 to 1 also beyond its ends; one half where all are alike. */
export const shareOf = (v, [lo, hi]) => (hi - lo > 1e-9 * Math.max(Math.abs(lo), Math.abs(hi)) ? Math.min(1, Math.max(0, (v - lo) / (hi - lo))) : v === v ? 0.5 : NaN);

/**
 * A legend: the scale with the values at its ends and in its middle. `range`: least and greatest
 * value; `shown`: what the colours span, where a few values beyond it have the colours of its ends.
 */
export const legend = (name, unit, range, shown, missing) => {
  const mid = (shown[0] + shown[1]) / 2;
  const bar = data.colours.map((c, k) => `${c} ${(100 * k) / (data.colours.length - 1)}%`).join(',');
  const words = [shown[0], mid, shown[1]].map(v => `<span>${show(v)}</span>`).join('');
  const part = show(100 * data.left_out);
  const beyond = [
    shown[0] > range[0] ? `lowest ${part} % in the first colour, down to ${show(range[0])}` : '',
    shown[1] < range[1] ? `highest ${part} % in the last colour, up to ${show(range[1])}` : '',
    missing ? 'grey: not measured' : '',
  ].filter(Boolean).join('; ');
  return `<b>${name}${unit ? `, ${unit}` : ''}</b><i style="background:linear-gradient(90deg,${bar})"></i><span class="ends">${words}</span>${beyond ? `<small>${beyond}</small>` : ''}`;
};
