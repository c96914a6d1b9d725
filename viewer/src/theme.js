// Light or dark: as the system has it, or as the page's button says; paper is light.
import { $ } from './basics.js';

const isDark = () => document.documentElement.dataset.theme === 'dark';

const set = dark => {
  document.documentElement.dataset.theme = dark ? 'dark' : 'light';
  $('theme').setAttribute('aria-pressed', String(dark));
  $('theme').textContent = dark ? 'Light' : 'Dark';
};

/**
 * Begins; `redraw` draws anew what takes its colours from the page. `unfold` opens what paper
 * cannot open, and gives what closes it again.
 */
export function theme(redraw, unfold = () => () => {}) {
  const system = matchMedia('(prefers-color-scheme: dark)');
  const change = dark => { set(dark); redraw(); };
  set(system.matches);
  system.addEventListener('change', e => change(e.matches));
  $('theme').addEventListener('click', () => change(!isDark()));
  let back = null;
  addEventListener('beforeprint', () => {
    const [dark, fold] = [isDark(), unfold()];
    change(false);
    back = () => { fold(); change(dark); };
  });
  addEventListener('afterprint', () => { back?.(); back = null; });
}
