// One place of the path that the 3-D view and all plots share: arc length from its start, mm.
const listeners = [];
let at = 0;

export const cursor = {
  get s() { return at; },
  /**
   * Moves it; `from` names who did, so that it need not follow itself. `settle` is true for clicks
   * and false for hovering.
   */
  set(s, from, settle = false) {
    if (!Number.isFinite(s)) return;
    at = s;
    for (const f of listeners) f(s, from, settle);
  },
  on(f) { listeners.push(f); },
};
