"""Loading time beside OpenCASCADE, STEP and IGES.

    python load.py PROGRAM_FOLDER MODEL...

PROGRAM_FOLDER holds `examples/load_time` (a release build). Needs Python with cadquery-ocp and numpy.

Processor seconds, a mean of several rounds each, the file in the cache:
  queries  ours: read, sew, mesh, index the exact faces, one closest point;
  OCC      read, transfer, sew loose faces (IGES), one closest point to all faces (it keeps no index);
  whole    ours, with what planning needs besides: mesh, which way faces look, blade axis, regions. OpenCASCADE does none of that.
The ratio is that of the first two.
"""

import subprocess
import sys
import time
from pathlib import Path

from OCP.BRep import BRep_Builder
from OCP.TopoDS import TopoDS_Compound

from compare import distance, faces_of, read

ROUNDS = 5


def theirs(path):
    begin = time.process_time()
    for _ in range(ROUNDS):
        faces, builder = TopoDS_Compound(), BRep_Builder()
        builder.MakeCompound(faces)
        for face in faces_of(read(path)):
            builder.Add(faces, face)
        distance([1.0, 2.0, 3.0], faces)
    return (time.process_time() - begin) / ROUNDS


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program = Path(sys.argv[1]) / "examples" / "load_time"
    print(f"{'file':40} {'queries':>9} {'OCC':>9} {'ratio':>7} {'whole':>9}")
    for path in map(Path, sys.argv[2:]):
        answer = subprocess.run([str(program), str(path), str(ROUNDS)], text=True, capture_output=True)
        other = theirs(path)
        if answer.returncode:
            print(f"{path.name:40} {answer.stderr.strip()}")
            continue
        ready, whole = answer.stdout.split()
        print(f"{path.name:40} {float(ready):9.3f} {other:9.3f} {float(ready) / other:7.2f} {whole:>9}", flush=True)


if __name__ == "__main__":
    main()
