"""Bull-nose, flat and ball cutters dropped on a wavy surface: OpenCAMLib beside bladewright.

Usage: compare.py DROP_CUTTER [PLACES]; DROP_CUTTER is the built example `drop_cutter`. Needs
`pip install opencamlib`. Heights are of the tip, the axis is vertical.
"""

import math
import random
import subprocess
import sys

import opencamlib as ocl

LIMIT_MM = 1e-5


def surface(n=40, size=40.0):
    """Triangles of a wavy square with a ridge."""

    def z(x, y):
        return 2.0 * math.sin(0.31 * x) * math.cos(0.23 * y) - 0.02 * (x - 20) ** 2 + 3.0 * max(0.0, 1 - abs(y - 25))

    step = size / n
    grid = [[(i * step, j * step, z(i * step, j * step)) for j in range(n + 1)] for i in range(n + 1)]
    for i in range(n):
        for j in range(n):
            a, b, c, d = grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]
            yield a, b, c
            yield a, c, d


def theirs(triangles, radius, corner, places):
    stl = ocl.STLSurf()
    for t in triangles:
        stl.addTriangle(ocl.Triangle(*(ocl.Point(*p) for p in t)))
    length = 50.0
    if corner >= radius:
        cutter = ocl.BallCutter(2 * radius, length)
    else:
        cutter = ocl.BullCutter(2 * radius, corner, length)
    drop = ocl.BatchDropCutter()
    drop.setSTL(stl)
    drop.setCutter(cutter)
    for x, y in places:
        drop.appendPoint(ocl.CLPoint(x, y, -1000.0))
    drop.run()
    return [p.z for p in drop.getCLPoints()]


def ours(program, triangles, radius, corner, places):
    lines = [f"cutter {radius} {corner}"]
    lines += ["triangle " + " ".join(repr(x) for p in t for x in p) for t in triangles]
    lines += [f"at {x!r} {y!r}" for x, y in places]
    out = subprocess.run([program], input="\n".join(lines), capture_output=True, text=True, check=True)
    return [None if line == "none" else float(line) for line in out.stdout.split()]


def main():
    program, count = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    triangles = list(surface())
    dice, failed = random.Random(3), False
    for radius, corner in [(8.0, 2.0), (5.0, 0.05), (4.0, 3.9), (3.0, 1.0), (4.0, 4.0)]:
        places = [(dice.uniform(8, 32), dice.uniform(8, 32)) for _ in range(count)]
        a, b = theirs(triangles, radius, corner, places), ours(program, triangles, radius, corner, places)
        missing = sum(z is None for z in b)
        off = sorted((z - w, p) for z, w, p in zip(b, a, places) if z is not None)
        low, high = off[0], off[-1]
        failed |= missing > 0 or max(abs(low[0]), abs(high[0])) > LIMIT_MM
        print(
            f"R {radius} r {corner}: {len(off)} places, ours less theirs {low[0]:.2e} to {high[0]:.2e} mm "
            f"at {low[1][0]:.3f}, {low[1][1]:.3f} and {high[1][0]:.3f}, {high[1][1]:.3f}; {missing} without a touch"
        )
    sys.exit(failed)


if __name__ == "__main__":
    main()
