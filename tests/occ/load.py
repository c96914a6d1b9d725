"""Loading time beside OpenCASCADE: STEP, IGES, STL, OBJ.

    python load.py PROGRAM_FOLDER MODEL...

A model in metres whatever it says is written MODEL@m. PROGRAM_FOLDER holds `examples/load_time` (a release build). Needs Python with cadquery-ocp and numpy.

Processor seconds, a mean of several rounds, the file in the cache. Like for like:
  read     to faces with their trimming curves, sewn where they are loose (ours always, OpenCASCADE for IGES);
  queries  that, a mesh of all faces within 0.01 mm and 12 degrees, and one closest point: ours to all exact faces through an index that it
           builds, OpenCASCADE's to all faces without one (it keeps none, so its second point costs as much as its first).
           Of a mesh: read, triangles that share their corners (RWStl, RWObj); queries, that, healed, and one closest point, OpenCASCADE's to
           the planar faces that StlAPI makes of an STL's triangles, which is all it can ask there; of an OBJ nothing.
  whole    ours alone: with what planning needs besides: which way faces look, blade axis, regions.
The ratios are ours over OpenCASCADE's.
"""

import ctypes
import subprocess
import sys
import time
from pathlib import Path

import OCP
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.Interface import Interface_Static
from OCP.RWStl import RWStl
from OCP.StlAPI import StlAPI_Reader
from OCP.TopoDS import TopoDS_Shape

from parts import compound, distance, read

# Rounds of ours and of their reading; their queries take seconds and are run once. Meshes are read in hundredths of a second.
ROUNDS = 3
MESH_ROUNDS = 30
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


def triangles(path):
    found = RWStl.ReadFile_s(str(path)) if path.suffix.lower() == ".stl" else obj(path)
    if not found:
        sys.exit(f"{path}: OpenCASCADE does not read it")


def obj(path):
    """`RWObj::ReadFile`, which the bindings leave out: a handle comes back where the hidden first argument points."""
    library = next(Path(OCP.__file__).parents[1].glob("cadquery_ocp.libs/libTKDEOBJ*"))
    read = ctypes.CDLL(str(library))["_ZN5RWObj8ReadFileEPKcRK21Message_ProgressRange"]
    handle, no_progress = ctypes.c_void_p(), ctypes.create_string_buffer(64)
    read(ctypes.byref(handle), str(path).encode(), no_progress)
    return handle.value


def planar_faces(path):
    shape = TopoDS_Shape()
    StlAPI_Reader().Read(shape, str(path))
    distance([1.0, 2.0, 3.0], shape)


def theirs(path):
    """Their seconds, None where they have no such thing."""
    mesh = path.suffix.lower()
    if mesh == ".stl":
        return [timed(lambda: triangles(path), MESH_ROUNDS), timed(lambda: planar_faces(path), 1)]
    if mesh == ".obj":
        return [timed(lambda: triangles(path), MESH_ROUNDS), None]
    return [timed(lambda: read(path), ROUNDS), timed(lambda: queries(path), 1)]


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    program = Path(sys.argv[1]) / "examples" / "load_time"
    heads = ("read", "OCC", "ratio", "queries", "OCC", "ratio", "whole")
    print(f"{'file':36}" + "".join(f"{h:>9}" for h in heads))
    for name in sys.argv[2:]:
        path, metres = Path(name.removesuffix("@m")), name.endswith("@m")
        # Theirs believes the file: what is called a millimetre becomes a thousand micrometres.
        Interface_Static.SetCVal_s("xstep.cascade.unit", "UM" if metres else "MM")
        rounds = MESH_ROUNDS if path.suffix.lower() in (".stl", ".obj") else ROUNDS
        answer = subprocess.run([str(program), str(path), str(rounds)] + ["m"] * metres, text=True, capture_output=True)
        if answer.returncode:
            print(f"{path.name:36} {answer.stderr.strip()}")
            continue
        ours = answer.stdout.split()
        line = f"{path.name:36}"
        for mine, other in zip(ours, theirs(path)):
            ratio = f"{other:9.3f}{float(mine) / other:9.2f}" if other else f"{'-':>9}{'-':>9}"
            line += f"{float(mine):9.3f}{ratio}"
        print(line + f"{ours[2]:>9}", flush=True)


if __name__ == "__main__":
    main()
