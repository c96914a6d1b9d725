"""Loading time beside OpenCASCADE, STEP and IGES.

    python load.py PROGRAM_FOLDER MODEL...

PROGRAM_FOLDER holds `examples/load_time` (a release build). Needs Python with cadquery-ocp and numpy.

Processor seconds, a mean of several rounds, the file in the cache. Like for like:
  read     to faces with their trimming curves, sewn where they are loose (ours always, OpenCASCADE for IGES);
  queries  that, a mesh of all faces within 0.01 mm and 12 degrees, and one closest point: ours to all exact faces through an index that it
           builds, OpenCASCADE's to all faces without one (it keeps none, so its second point costs as much as its first).
  whole    ours alone: with what planning needs besides: which way faces look, blade axis, regions.
The ratios are ours over OpenCASCADE's.
"""

import subprocess
import sys
import time
from pathlib import Path

from OCP.BRepMesh import BRepMesh_IncrementalMesh

from parts import compound, distance, read

# Rounds of ours and of their reading; their queries take seconds and are run once.
ROUNDS = 3
DEFLECTION_MM = 0.01
ANGLE_RAD = 0.2094


def timed(work, rounds):
    begin = time.process_time()
    for _ in range(rounds):
        work()
    return (time.process_time() - begin) / rounds


def queries(path):
    shape = read(path)
    BRepMesh_IncrementalMesh(shape, DEFLECTION_MM, False, ANGLE_RAD, False)
    distance([1.0, 2.0, 3.0], compound(shape))


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program = Path(sys.argv[1]) / "examples" / "load_time"
    heads = ("read", "OCC", "ratio", "queries", "OCC", "ratio", "whole")
    print(f"{'file':36}" + "".join(f"{h:>9}" for h in heads))
    for path in map(Path, sys.argv[2:]):
        answer = subprocess.run([str(program), str(path), str(ROUNDS)], text=True, capture_output=True)
        if answer.returncode:
            print(f"{path.name:36} {answer.stderr.strip()}")
            continue
        ours = answer.stdout.split()
        theirs = [timed(lambda: read(path), ROUNDS), timed(lambda: queries(path), 1)]
        line = f"{path.name:36}"
        for mine, other in zip(ours, theirs):
            line += f"{float(mine):9.3f}{other:9.3f}{float(mine) / other:9.2f}"
        print(line + f"{ours[2]:>9}", flush=True)


if __name__ == "__main__":
    main()
