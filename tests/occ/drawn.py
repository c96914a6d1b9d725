"""Blades that nobody has seen: drawn at random with OpenCASCADE, written as STEP, then looked at and planned.

    python drawn.py PROGRAM COUNT [--first SEED] [--plan] [--keep FOLDER]

PROGRAM is the `bladewright` of a release build. Needs Python with cadquery: `pip install cadquery`. A seed always draws the same
blade: chord over height, taper, twist, camber, thickness, bow, sweep and the trailing edge differ; the airfoil is of smooth or ruled
faces, on a flat, tilted or round platform or on none, with or without a fillet and a shroud, and often moved and turned.

`inspect` is to find the axis that the blade was drawn along, within 15 degrees, or to say that it is not certain. Where nothing but
the airfoil or one shroud is there, either end may be the root. With --plan, `plan` is to end well at its defaults. Solids
that OpenCASCADE itself calls invalid (fillets that fail) are left out, and counted. Exit code 1 if anything is wrong.
"""

import argparse
import json
import math
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import cadquery as cq
import numpy as np
from cadquery import Edge, Solid, Vector, Wire

# Greatest angle between the axis found and the one drawn along, degrees: sweep alone moves the tip aside by up to 11.
WITHIN_DEG = 15.0


def sides(chord, thickness, camber, blunt, n=40):
    """Upper and lower side of a section, leading to trailing edge: a circular camber line with four-digit thickness."""
    u = (1 - np.cos(np.linspace(0, math.pi, n))) / 2
    half = 5 * thickness * (0.2969 * np.sqrt(u) - 0.126 * u - 0.3516 * u**2 + 0.2843 * u**3 - 0.1036 * u**4) + blunt * u / 2 / chord
    slope = np.arctan(camber * 4 * (1 - 2 * u))
    line = camber * 4 * u * (1 - u)
    out = [np.c_[u - sign * half * np.sin(slope), line + sign * half * np.cos(slope)] for sign in (1, -1)]
    middle = np.array([0.42, 0.7 * camber])
    return [(side - middle) * chord for side in out]


def wire(section, angle, shift, z, in_four):
    """The section at a height, closed round its trailing edge by an arc."""
    c, s = math.cos(angle), math.sin(angle)
    upper, lower = ([Vector(c * x - s * y + shift[0], s * x + c * y + shift[1], z) for x, y in side] for side in section)
    upper.reverse()
    a, b = lower[-1], upper[0]
    out = ((lower[-1] - lower[-2]).normalized() + (upper[0] - upper[1]).normalized()).normalized()
    arc = Edge.makeThreePointArc(a, (a + b) * 0.5 + out * ((a - b).Length / 2), b)
    if in_four:
        nose = 6
        edges = [upper[:-nose], upper[-nose - 1 :] + lower[1 : nose + 1], lower[nose:]]
    else:
        edges = [upper + lower[1:]]
    return Wire.assembleEdges([*(Edge.makeSpline(e) for e in edges), arc])


def platform(kind, wide, deep, thick, round_mm, tilt_deg):
    """A platform with its top at height 0."""
    if kind == "round":
        block = cq.Workplane("XY").box(wide, deep, 2 * thick).translate((0, 0, -thick))
        return cq.Workplane("YZ").circle(round_mm).extrude(wide / 2, both=True).translate((0, 0, -round_mm)).intersect(block).val()
    block = cq.Workplane("XY").box(wide, deep, thick).translate((0, 0, -thick / 2))
    return (block.rotate((0, 0, 0), (0, 1, 0), tilt_deg) if kind == "tilted" else block).val()


def filleted(shape, radius, wide, deep, high):
    """The shape with the corner between airfoil and platform rounded; as it is where OpenCASCADE cannot."""
    at = lambda e: abs(e.Center().x) < wide and abs(e.Center().y) < deep and abs(e.Center().z) < high
    try:
        return shape.Solids()[0].fillet(radius, [e for e in shape.Edges() if at(e) and e.geomType() != "LINE"])
    except Exception:
        return shape


def draw(seed):
    """A blade, the line that it was drawn along, and its features in words."""
    r = random.Random(seed)
    height = r.choice([25, 40, 70, 110, 180])
    chord, count = height * r.uniform(0.35, 0.9), r.choice([3, 5, 7])
    camber, thickness = r.uniform(0.02, 0.22), r.uniform(0.07, 0.2)
    flatter, thinner, taper = r.uniform(0.2, 0.9), r.uniform(0.35, 0.9), r.uniform(0.55, 1.15)
    stagger, twist = r.uniform(-10, 40), r.uniform(0, 50)
    bow, sweep = r.uniform(-0.12, 0.12) * height, r.uniform(-0.2, 0.2) * height
    blunt, in_four, ruled = r.choice([0.006, 0.02, 0.03]) * chord, r.random() < 0.4, r.random() < 0.15
    wires = []
    for v in np.linspace(0, 1, count):
        section = sides(chord * (1 + (taper - 1) * v), thickness * (1 + (thinner - 1) * v), camber * (1 + (flatter - 1) * v), blunt)
        shift = [sweep * v * v, bow * math.sin(math.pi * v)]
        wires.append(wire(section, math.radians(stagger + twist * v), shift, height * (1.08 * v - 0.08), in_four))
    shape = Solid.makeLoft(wires, ruled)
    words = [f"{height} mm high, chord {chord:.1f}"]
    base = r.choice(["flat", "tilted", "round", "none"])
    if base != "none":
        block = platform(base, 1.5 * chord, 1.3 * chord, 0.25 * height, max(4 * height, 1.8 * chord), r.uniform(4, 12))
        shape = block.fuse(shape)
        words.append(f"{base} platform")
        radius = r.choice([0, 0.02, 0.05]) * height
        if radius > 0:
            shape = filleted(shape, radius, 0.65 * chord, 0.6 * chord, 0.15 * height)
            words.append(f"fillet {radius:.1f}")
    if r.random() < 0.2:
        shroud = cq.Workplane("XY").box(0.9 * chord, 0.7 * chord, 0.04 * height).translate((sweep, 0, 0.98 * height))
        shape = shape.fuse(shroud.val())
        words.append("shroud")
    axis = Vector(0, 0, 1)
    if r.random() < 0.3:
        angle, to = r.uniform(20, 160), Vector(r.uniform(-100, 100), 50, r.uniform(-300, 300))
        turn = lambda s: s.rotate(Vector(0, 0, 0), Vector(1, 0.3, 0.2), angle)
        shape, axis = turn(shape).translate(to), turn(cq.Vertex.makeVertex(0, 0, 1)).Center()
        words.append("moved")
    return shape, axis, base, ", ".join(words)


def found_axis(text):
    """The direction that `inspect` prints, root to tip; None where it finds none."""
    named = re.search(r"axis: ([+-])([XYZ]) of the model", text)
    if named:
        return Vector(*((1 if named[1] == "+" else -1) * (k == named[2]) for k in "XYZ"))
    free = re.search(r"axis: \((-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\)", text)
    return Vector(*map(float, free.groups())) if free else None


def looked_at(program, model, axis, base):
    """What is wrong with what `inspect` says; empty where nothing is."""
    run = subprocess.run([program, "inspect", model], capture_output=True, text=True)
    text = run.stdout + run.stderr
    if run.returncode not in (0, 3, 4) or "panicked" in text:
        return f"inspect ends with code {run.returncode}"
    found = found_axis(text)
    if found is None:
        return "no axis: " + next((line for line in text.splitlines() if line.startswith(("error", "found"))), text[-200:])
    cos = found.dot(axis) / found.Length
    off_deg = math.degrees(math.acos(min(1.0, abs(cos))))
    if off_deg > WITHIN_DEG:
        return "" if "axis is not certain" in text else f"axis {off_deg:.1f} degrees off"
    return "root and tip exchanged" if cos < 0 and base != "none" else ""


def planned(program, model, folder):
    """What is wrong with the plan; empty where nothing is."""
    run = subprocess.run([program, "--quiet", "plan", model, "-o", folder], capture_output=True, text=True)
    if run.returncode == 0:
        return ""
    lines = (run.stdout + run.stderr).splitlines()
    why = next((line for line in lines if line.startswith(("error", "finding"))), "")
    return f"plan ends with code {run.returncode}: {why}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("count", type=int)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--plan", action="store_true")
    parser.add_argument("--keep")
    args = parser.parse_args()
    wrong = left_out = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(args.keep or temporary)
        folder.mkdir(parents=True, exist_ok=True)
        for seed in range(args.first, args.first + args.count):
            model = folder / f"drawn_{seed}.step"
            try:
                shape, axis, base, words = draw(seed)
                is_solid = shape.isValid() and len(shape.Solids()) == 1 and shape.Volume() > 0
            except Exception as e:
                is_solid, words = False, f"not drawn: {e}"
            if not is_solid:
                left_out += 1
                continue
            cq.exporters.export(cq.Workplane(obj=shape), str(model))
            said = looked_at(args.program, str(model), axis, base)
            if not said and args.plan:
                said = planned(args.program, str(model), str(folder / f"plan_{seed}"))
            wrong += bool(said)
            print(f"{seed}: {said or 'ok'} ({words})", flush=True)
    print(json.dumps({"looked at": args.count - left_out, "wrong": wrong, "no valid solid": left_out}))
    sys.exit(1 if wrong else 0)


main()
