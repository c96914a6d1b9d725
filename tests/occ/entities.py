"""Every kind of face, file and unit of STEP and IGES, as OpenCASCADE writes them, read by us: closed, with its area and volume.

    python entities.py PROGRAM_FOLDER

PROGRAM_FOLDER holds `bladewright` (a release build). Needs Python with cadquery-ocp. Faces are planes, cylinders, cones, spheres, tori,
surfaces of revolution and of extrusion, B-splines and rational B-splines, with seams, degenerate edges and turned faces; STEP is AP203,
AP214 and AP242, as a solid, as a shell, as loose faces and as an assembly; IGES has trimmed faces (144) or solids (186). Exit code 1 if
one is not read as what it is.
"""

import itertools
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import (
    BRepBuilderAPI_MakeEdge,
    BRepBuilderAPI_MakeFace,
    BRepBuilderAPI_MakeWire,
    BRepBuilderAPI_NurbsConvert,
    BRepBuilderAPI_Transform,
)
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepGProp import BRepGProp
from OCP.BRepPrimAPI import (
    BRepPrimAPI_MakeBox,
    BRepPrimAPI_MakeCone,
    BRepPrimAPI_MakeCylinder,
    BRepPrimAPI_MakePrism,
    BRepPrimAPI_MakeRevol,
    BRepPrimAPI_MakeSphere,
    BRepPrimAPI_MakeTorus,
)
from OCP.GeomAPI import GeomAPI_PointsToBSpline
from OCP.GProp import GProp_GProps
from OCP.gp import gp_Ax1, gp_Ax2, gp_Dir, gp_Pnt, gp_Trsf, gp_Vec
from OCP.IGESControl import IGESControl_Controller, IGESControl_Writer
from OCP.Interface import Interface_Static
from OCP.Message import Message, Message_Gravity
from OCP.STEPControl import STEPControl_StepModelType, STEPControl_Writer
from OCP.TopAbs import TopAbs_SHELL
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS_Compound

from parts import as_shell, faces_of

try:
    from OCP.TColgp import TColgp_Array1OfPnt
except ImportError:  # Later bindings have their arrays in one place.
    from OCP.collections import Array1_gp_Pnt as TColgp_Array1OfPnt

# Area and volume are alike within this share.
SHARE = 1e-4
SCHEMAS = {"AP203": 3, "AP214": 1, "AP242": 5}
MM = {"MM": 1.0, "CM": 10.0, "M": 1000.0, "INCH": 25.4}


def spline(points):
    poles = TColgp_Array1OfPnt(1, len(points))
    for k, p in enumerate(points):
        poles.SetValue(k + 1, gp_Pnt(*p))
    return BRepBuilderAPI_MakeEdge(GeomAPI_PointsToBSpline(poles).Curve()).Edge()


def outline(points):
    """A face in y = 0 within a spline through the points and straight lines to the z axis."""
    (xa, _, za), (xb, _, zb) = points[0], points[-1]
    line = lambda a, b: BRepBuilderAPI_MakeEdge(gp_Pnt(*a), gp_Pnt(*b)).Edge()
    wire = BRepBuilderAPI_MakeWire(spline(points))
    for edge in (line((xb, 0, zb), (0, 0, zb)), line((0, 0, zb), (0, 0, za)), line((0, 0, za), (xa, 0, za))):
        wire.Add(edge)
    return BRepBuilderAPI_MakeFace(wire.Wire()).Face()


def shapes():
    axis = gp_Ax2(gp_Pnt(3, -2, 5), gp_Dir(1, 2, 3))
    profile = outline([(8, 0, 0), (5, 0, 10), (7, 0, 22), (4, 0, 40)])
    box = BRepPrimAPI_MakeBox(40.0, 8.0, 90.0).Shape()
    yield "planes", box
    yield "cylinder", BRepPrimAPI_MakeCylinder(axis, 7.0, 60.0).Shape()
    yield "cone", BRepPrimAPI_MakeCone(axis, 9.0, 3.0, 50.0).Shape()
    yield "cone to its tip", BRepPrimAPI_MakeCone(axis, 9.0, 0.0, 50.0).Shape()
    yield "sphere", BRepPrimAPI_MakeSphere(axis, 20.0).Shape()
    yield "torus", BRepPrimAPI_MakeTorus(axis, 30.0, 6.0).Shape()
    yield "revolution", BRepPrimAPI_MakeRevol(profile, gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))).Shape()
    yield "extrusion", BRepPrimAPI_MakePrism(profile, gp_Vec(3, 30, 0)).Shape()
    hole = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(20, -5, 40), gp_Dir(0, 1, 0)), 6.0, 30.0).Shape()
    yield "a hole", BRepAlgoAPI_Cut(box, hole).Shape()
    dent = BRepPrimAPI_MakeSphere(gp_Pnt(20, 4, 90), 3.0).Shape()
    yield "a dent", BRepAlgoAPI_Cut(box, dent).Shape()


def converted():
    """The same as rational B-splines: of those OpenCASCADE's area and volume are off by up to a hundredth, so the others' are taken."""
    for name, shape in shapes():
        yield name, shape, shape
        yield name + ", rational", BRepBuilderAPI_NurbsConvert(shape, True).Shape(), shape


def measures(shape):
    area, volume = GProp_GProps(), GProp_GProps()
    BRepGProp.SurfaceProperties_s(shape, area)
    BRepGProp.VolumeProperties_s(shape, volume)
    return area.Mass(), abs(volume.Mass())


def step(path, schema, unit, shape):
    Interface_Static.SetIVal_s("write.step.schema", SCHEMAS[schema])
    Interface_Static.SetCVal_s("write.step.unit", unit)
    # Two placed parts become an assembly.
    Interface_Static.SetIVal_s("write.step.assembly", 1)
    writer = STEPControl_Writer()
    writer.Transfer(shape, STEPControl_StepModelType.STEPControl_AsIs)
    writer.Write(str(path))


def iges(path, unit, solids, shape):
    writer = IGESControl_Writer(unit, 1 if solids else 0)
    writer.AddShape(shape)
    writer.ComputeModel()
    writer.Write(str(path))


def loose(shape):
    """Each face with edges of its own."""
    faces, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(faces)
    for face in faces_of(shape):
        move = gp_Trsf()
        builder.Add(faces, BRepBuilderAPI_Transform(face, move, True).Shape())
    return faces


def shell(shape):
    return as_shell(TopExp_Explorer(shape, TopAbs_SHELL).Current())


def assembly():
    """Two bars, placed by a turn and a shift each."""
    both, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(both)
    bar = BRepPrimAPI_MakeBox(10.0, 4.0, 60.0).Shape()
    for k in range(2):
        move = gp_Trsf()
        move.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(1, 1, 0)), 0.5 * k)
        move.SetTranslationPart(gp_Vec(40.0 * k, 3, 1))
        builder.Add(both, bar.Moved(TopLoc_Location(move)))
    return both


def cases(folder):
    for (name, shape, same), (k, schema) in itertools.product(list(converted()), enumerate(SCHEMAS)):
        unit = list(MM)[k % len(MM)]
        path = folder / f"{name} {schema} {unit}.step"
        step(path, schema, unit, shape)
        yield path, same, True
    box = dict(shapes())["a hole"]
    for unit in MM:
        for kind, shape in (("solid", box), ("shell", shell(box)), ("faces", loose(box))):
            path = folder / f"{kind} {unit}.step"
            step(path, "AP214", unit, shape)
            yield path, box, True
    both = assembly()
    step(folder / "assembly.step", "AP214", "MM", both)
    yield folder / "assembly.step", both, True
    for (name, shape, same), solids in itertools.product(list(converted()), (False, True)):
        for unit in ("MM", "INCH") if name == "a hole" else ("MM",):
            path = folder / f"{name} {'186' if solids else '144'} {unit}.igs"
            iges(path, unit, solids, shape)
            yield path, same, True
    # All faces but one: an open shell.
    opened, builder = TopoDS_Compound(), BRep_Builder()
    builder.MakeCompound(opened)
    for face in list(faces_of(box))[1:]:
        builder.Add(opened, face)
    step(folder / "open.step", "AP214", "MM", opened)
    yield folder / "open.step", opened, False


def quiet():
    """OpenCASCADE tells of every file it writes."""
    printers = Message.DefaultMessenger_s().Printers()
    for printer in list(printers):
        printer.SetTraceLevel(Message_Gravity.Message_Fail)


def number(text, key):
    found = re.search(rf"^{key} +([-0-9.e+]+) mm", text, re.MULTILINE)
    return float(found.group(1)) if found else float("nan")


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    program = Path(sys.argv[1]) / "bladewright"
    IGESControl_Controller.Init_s()
    wrong, count, worst = 0, 0, 0.0
    quiet()
    with tempfile.TemporaryDirectory() as folder:
        for path, shape, closed in cases(Path(folder)):
            count += 1
            ran = subprocess.run([str(program), "--quiet", "inspect", str(path)], text=True, capture_output=True)
            area, volume = measures(shape)
            said = "yes" if closed else "no"
            off = abs(number(ran.stdout, "area") / area - 1)
            if closed:
                off = max(off, abs(number(ran.stdout, "volume") / volume - 1))
            if ran.returncode or not re.search(rf"^closed +{said}", ran.stdout, re.MULTILINE) or not off < SHARE:
                wrong += 1
                told = ran.stderr.strip() or [l for l in ran.stdout.splitlines() if l.startswith(("closed", "area", "volume"))]
                print(f"{path.name}: off by {off:.2e} of {area:.3f} mm2, {volume} mm3; {told}")
            else:
                worst = max(worst, off)
    print(f"{count} files, {wrong} wrong, area and volume within {worst:.1e} on the others")
    sys.exit(wrong > 0)


if __name__ == "__main__":
    main()
