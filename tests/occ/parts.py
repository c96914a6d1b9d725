"""What the comparisons with OpenCASCADE share: reading a model with it, its faces, and asking us for closest points."""

import subprocess
import sys

import numpy as np
from OCP.Bnd import Bnd_Box
from OCP.BRep import BRep_Builder
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeSolid, BRepBuilderAPI_MakeVertex, BRepBuilderAPI_Sewing
from OCP.BRepExtrema import BRepExtrema_DistShapeShape
from OCP.BRepLib import BRepLib
from OCP.gp import gp_Pnt
from OCP.IGESControl import IGESControl_Reader
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS, TopoDS_Compound

MICRON = 1e-3
# Between these tolerances loose faces are sewn, the first that closes them, mm.
SEW = (1e-3, 1e-2, 0.05)


def read(path):
    iges = path.suffix.lower() in (".igs", ".iges")
    reader = IGESControl_Reader() if iges else STEPControl_Reader()
    if reader.ReadFile(str(path)) != 1:
        sys.exit(f"{path}: OpenCASCADE does not read it")
    reader.TransferRoots()
    shape = reader.OneShape()
    return sewn(shape) if iges else shape


def sewn(shape):
    """Loose faces as one solid, wound outwards; as they are where they do not close."""
    for tolerance in SEW:
        sewing = BRepBuilderAPI_Sewing(tolerance)
        sewing.Add(shape)
        sewing.Perform()
        shells = TopExp_Explorer(sewing.SewedShape(), TopAbs_SHELL)
        if sewing.NbFreeEdges() == 0 and shells.More():
            solid = BRepBuilderAPI_MakeSolid(as_shell(shells.Current())).Solid()
            BRepLib.OrientClosedSolid_s(solid)
            return solid
    return shape


# The names of the casts differ between versions of the bindings.
as_face = getattr(TopoDS, "Face_s", None) or TopoDS.Face
as_shell = getattr(TopoDS, "Shell_s", None) or TopoDS.Shell


def faces_of(shape):
    found = TopExp_Explorer(shape, TopAbs_FACE)
    while found.More():
        yield found.Current()
        found.Next()


def corners(shape):
    box = Bnd_Box()
    BRepBndLib.AddOptimal_s(shape, box)
    return [np.array([p.X(), p.Y(), p.Z()]) for p in (box.CornerMin(), box.CornerMax())]


def distance(point, faces):
    vertex = BRepBuilderAPI_MakeVertex(gp_Pnt(*map(float, point))).Vertex()
    extrema = BRepExtrema_DistShapeShape(vertex, faces)
    return extrema.Value() if extrema.IsDone() else np.nan


def compound(shape):
    """The faces alone: to a solid every point inside would be at no distance."""
    faces, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(faces)
    for face in faces_of(shape):
        builder.Add(faces, face)
    return faces


def ask(folder, count, path, shape):
    """Random points in the shape's box, enlarged by a fifth, the same on every run, and our answer to each (a line of
    `closest_points`); no answer where the model is refused, which is printed."""
    low, high = corners(shape)
    spread = np.random.default_rng(7).random((count, 3)) - 0.5
    points = (low + high) / 2 + 1.2 * (high - low) * spread
    listing = "\n".join(" ".join(repr(float(x)) for x in p) for p in points)
    asked = [str(folder / "examples" / "closest_points"), str(path)]
    answer = subprocess.run(asked, input=listing, text=True, capture_output=True)
    if answer.returncode:
        print(f"{path.name}: {answer.stderr.strip()}")
        return points, None
    return points, np.array([[float(w) for w in line.split()] for line in answer.stdout.splitlines()])
