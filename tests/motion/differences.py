"""Differentiates `axes.csv` of finished runs and compares with the machine's limits: what the axes do, by code that did not plan it.

    python3 differences.py RUN... [--machine FILE.toml]

Needs nothing but Python 3.11. Three ways: divided differences of the positions, of first, second and third order; weighted central
differences one after another (what `numpy.gradient` does on uneven times) for velocity and acceleration; quotients of the printed
velocities and accelerations. All are averages of the derivative, so none may exceed a limit by more than 0.1 %. (Central differences three times
in a row are not: where the step changes they do not even have the third derivative of a cubic.) What rounding of the printed
positions can amount to is allowed for. Printed is the greatest share of each limit that is used. Exit code 1 where one is exceeded.
"""

import csv
import sys
import tomllib
from pathlib import Path

AXES = "XYZAB"
ALLOWED = 1.001


def limits(machine):
    axes = tomllib.loads(Path(machine).read_text())["axes"]
    linear = ("velocity_mm_s", "acceleration_mm_s2", "jerk_mm_s3")
    rotary = ("velocity_deg_s", "acceleration_deg_s2", "jerk_deg_s3")
    return {a: [axes[a.lower()][k] for k in (linear if a in "XYZ" else rotary)] for a in AXES}


def divided(t, values, order):
    """Differences of the given order: (value, allowance for rounding)."""
    size = max(map(abs, values), default=1.0) * 2.0**-51
    for k in range(1, order + 1):
        values = [k * (values[i + 1] - values[i]) / (t[i + k] - t[i]) for i in range(len(values) - 1)]
    steps = [(t[i + order] - t[i]) / order for i in range(len(values))]
    return values, [size * 2**order / s**order for s in steps]


def central(t, values):
    """Derivative at every time but the first and last: the two slopes, each weighted by the other's length."""
    out = []
    for i in range(1, len(values) - 1):
        before, after = t[i] - t[i - 1], t[i + 1] - t[i]
        slopes = (values[i] - values[i - 1]) / before, (values[i + 1] - values[i]) / after
        out.append((after * slopes[0] + before * slopes[1]) / (before + after))
    return t[1:-1], out


def shares(t, row, axis, most):
    """Greatest share of the limits of velocity, acceleration and jerk."""
    positions, out = row(axis), []
    rest, derived = t, positions
    for order, limit in enumerate(most, 1):
        found, rounding = divided(t, positions, order)
        worst = [max((abs(v) - r for v, r in zip(found, rounding)), default=0.0)]
        if order < 3:
            rest, derived = central(rest, derived)
            worst.append(max(map(abs, derived), default=0.0) - max(rounding, default=0.0))
        if order > 1:
            worst.append(max(map(abs, divided(t, row("va"[order - 2] + axis), 1)[0]), default=0.0))
        out.append(max(worst) / limit)
    return out


def main():
    arguments = sys.argv[1:]
    machine = Path(__file__).parents[2] / "models/machines/demo_table_head.toml"
    if "--machine" in arguments:
        at = arguments.index("--machine")
        machine = arguments[at + 1]
        del arguments[at : at + 2]
    most, failed = limits(machine), False
    if not arguments:
        sys.exit(__doc__)
    for run in map(Path, arguments):
        with open(run / "axes.csv", newline="") as f:
            rows = list(csv.DictReader(f))
        t = [float(r["t_s"]) for r in rows]
        print(f"{run}: {len(t)} rows, {t[-1]:.3f} s; greatest share of the limits: velocity, acceleration, jerk")
        for a in AXES:
            found = shares(t, lambda name: [float(r[name]) for r in rows], a, most[a])
            bad = any(s > ALLOWED for s in found)
            failed |= bad
            print(f"  {a}   {'   '.join(f'{max(s, 0):.5f}' for s in found)}{'   EXCEEDED' if bad else ''}")
    sys.exit(failed)


main()
