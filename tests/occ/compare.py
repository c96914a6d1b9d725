"""Compares bladewright with OpenCASCADE: closest points, inside and outside, area and volume, of STEP and IGES files.

    python compare.py PROGRAM_FOLDER POINTS MODEL...

PROGRAM_FOLDER holds `bladewright` and `examples/closest_points` (a release build). Needs Python with cadquery-ocp and numpy:
`pip install cadquery-ocp numpy`. Points are random in the model's box, enlarged by a fifth, the same on every run.

A point is wrong if our distance exceeds OpenCASCADE's by more than 1 µm, or is less by more than 1 µm while our foot does not
lie on a face (both are distances to points of the part, so the lesser one is right). Where signs differ and the part is a valid solid,
the winding of a fine mesh of OpenCASCADE's own decides between the two. Exit code 1 if anything is wrong.
"""

import re
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepClass3d import BRepClass3d_SolidClassifier
from OCP.BRepGProp import BRepGProp
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.gp import gp_Pnt
from OCP.GProp import GProp_GProps
from OCP.TopAbs import TopAbs_IN, TopAbs_REVERSED
from OCP.TopLoc import TopLoc_Location

from parts import MICRON, as_face, ask, compound, distance, faces_of, read

# Areas and volumes are alike within this share.
SHARE = 1e-3


def triangles(shape):
    """A fine mesh, corners by triangle, wound outwards."""
    BRepMesh_IncrementalMesh(shape, 0.01, False, 0.1, True)
    out = []
    for face in faces_of(shape):
        where = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(as_face(face), where)
        if mesh is None:
            continue
        move = where.Transformation()
        points = [mesh.Node(i + 1).Transformed(move) for i in range(mesh.NbNodes())]
        points = np.array([[p.X(), p.Y(), p.Z()] for p in points])
        flip = face.Orientation() == TopAbs_REVERSED
        for i in range(mesh.NbTriangles()):
            a, b, c = mesh.Triangle(i + 1).Get()
            out.append(points[[a - 1, c - 1, b - 1] if flip else [a - 1, b - 1, c - 1]])
    return np.array(out)


def winding(mesh, point):
    """How often the mesh goes round the point (van Oosterom and Strackee 1983)."""
    a, b, c = (mesh[:, k] - point for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    dot = lambda x, y: np.einsum("ij,ij->i", x, y)
    top = np.einsum("ij,ij->i", a, np.cross(b, c))
    bottom = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb
    return np.arctan2(top, bottom).sum() / (2 * np.pi)


def figure(text, key):
    found = re.search(rf"^{key}\s+(-?[\d.]+) mm", text, re.M)
    return float(found.group(1)) if found else None


def measures(shape, report):
    """Our area and volume against theirs; whether both agree."""
    good = True
    # With an accuracy: without one OpenCASCADE's own figures are off by up to 0.1 %.
    area = lambda found: BRepGProp.SurfaceProperties_s(shape, found, 1e-6, False)
    volume = lambda found: BRepGProp.VolumeProperties_s(shape, found, 1e-6, False, False)
    for key, measure in (("area", area), ("volume", volume)):
        theirs = GProp_GProps()
        measure(theirs)
        ours, theirs = figure(report, key), theirs.Mass()
        if ours is None:
            print(f"  {key}: none of ours; OpenCASCADE {theirs:.3f}")
            continue
        off = abs(ours - theirs) / abs(theirs)
        good &= off <= SHARE
        print(f"  {key}: ours {ours:.3f}, OpenCASCADE {theirs:.3f}, apart by {100 * off:.5f} %")
    return good


def compare(folder, count, path):
    shape = read(path)
    points, ours = ask(folder, count, path, shape)
    if ours is None:
        return True
    faces = compound(shape)
    begin = time.time()
    theirs = np.array([distance(p, faces) for p in points])
    rate = count / (time.time() - begin)
    off = ours[:, 0] - theirs
    wrong = int((off > MICRON).sum())
    for i in np.where(off < -MICRON)[0]:
        wrong += int(distance(ours[i, 1:4], faces) > MICRON)
    print(f"{path.name}: {count} points, wrong {wrong}; farther than OpenCASCADE's by up to {off.max():.1e} mm, ", end="")
    print(f"nearer by up to {-off.min():.1e} mm in {int((off < -MICRON).sum())} places where it is wrong ({rate:.0f} a second)")
    for i in np.where(off > MICRON)[0][:5]:
        print(f"  at {points[i].tolist()}: ours {ours[i, 0]!r}, OpenCASCADE {theirs[i]!r}")
    classify, mesh, doubts, lost = BRepClass3d_SolidClassifier(shape), None, 0, 0
    for i, point in enumerate(points):
        classify.Perform(gp_Pnt(*map(float, point)), 1e-7)
        inside = classify.State() == TopAbs_IN
        if inside != (ours[i, -1] == 1):
            doubts += 1
            mesh = triangles(shape) if mesh is None else mesh
            lost += int((winding(mesh, point) > 0.5) != (ours[i, -1] == 1))
    print(f"  inside: {doubts} differ, of those {lost} against the winding of OpenCASCADE's mesh")
    report = subprocess.run([str(folder / "bladewright"), "inspect", str(path)], text=True, capture_output=True).stdout
    return measures(shape, report) and wrong == 0


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    folder, count = Path(sys.argv[1]), int(sys.argv[2])
    good = [compare(folder, count, Path(p)) for p in sys.argv[3:]]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
