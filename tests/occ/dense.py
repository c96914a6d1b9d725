"""Closest points against OpenCASCADE from many starts, for parts on which its own search over all faces takes too long.

    python dense.py PROGRAM_FOLDER POINTS MODEL...

As compare.py, but theirs is the least of: the nearest vertices and middles of triangles of OpenCASCADE's own fine mesh of the part, and
OpenCASCADE's local search (`Extrema_GenLocateExtPS`) on the exact surface from each of the nearest of them, where it ends inside the face. All should
be points of the part (middles within the mesh's deflection, taken off). Where edges lie off their faces, within the tolerance that
the file gives them, they are not: nodes of the mesh may lie on neither face, and the search may end beyond the edge. So wherever one of them is nearer
than ours by more than 1 µm, OpenCASCADE's exact search says how far it is from the trimmed faces, which is added; ours is wrong if it is
then more than 1 µm farther. Ours is wrong too if its foot lies more than 1 µm off all faces. Exit code 1 if anything is wrong.
"""

import sys
from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepClass import BRepClass_FaceClassifier
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.Extrema import Extrema_GenLocateExtPS
from OCP.gp import gp_Pnt, gp_Pnt2d
from OCP.TopAbs import TopAbs_IN, TopAbs_ON
from OCP.TopLoc import TopLoc_Location
from scipy.spatial import cKDTree

from parts import MICRON, as_face, ask, compound, distance, faces_of, read

DEFLECTION = 0.01
STARTS = 12


def samples(shape):
    """Points of all faces: place, face, parameters, how far off the exact face."""
    BRepMesh_IncrementalMesh(shape, DEFLECTION, False, 0.1, True)
    places, owner, uvs, off = [], [], [], []
    faces = [as_face(f) for f in faces_of(shape)]
    for k, face in enumerate(faces):
        where = TopLoc_Location()
        mesh = BRep_Tool.Triangulation_s(face, where)
        if mesh is None:
            continue
        move = where.Transformation()
        nodes = [mesh.Node(i + 1).Transformed(move) for i in range(mesh.NbNodes())]
        nodes = np.array([[p.X(), p.Y(), p.Z()] for p in nodes])
        flat = np.array([[mesh.UVNode(i + 1).X(), mesh.UVNode(i + 1).Y()] for i in range(mesh.NbNodes())])
        tri = np.array([mesh.Triangle(i + 1).Get() for i in range(mesh.NbTriangles())]) - 1
        for p, uv, slack in ((nodes, flat, 0.0), (nodes[tri].mean(axis=1), flat[tri].mean(axis=1), 2 * DEFLECTION)):
            places.append(p)
            uvs.append(uv)
            owner.append(np.full(len(p), k))
            off.append(np.full(len(p), slack))
    return faces, np.concatenate(places), np.concatenate(owner), np.concatenate(uvs), np.concatenate(off)


class Local:
    """The local search on each face."""

    def __init__(self, faces):
        self.faces = faces
        self.surfaces = [BRepAdaptor_Surface(f) for f in faces]
        self.search = [Extrema_GenLocateExtPS(s, 1e-10, 1e-10) for s in self.surfaces]

    def foot(self, face, point, uv):
        """Distance, and the parameters, or None."""
        search = self.search[face]
        try:
            search.Perform(gp_Pnt(*map(float, point)), float(uv[0]), float(uv[1]), True)
            if not search.IsDone():
                return None
            u, v = search.Point().Parameter()
            return float(np.sqrt(search.SquareDistance())), (u, v)
        except Exception:
            return None

    def point(self, face, uv):
        p = self.surfaces[face].Value(*uv)
        return np.array([p.X(), p.Y(), p.Z()])

    def inside(self, face, uv):
        return BRepClass_FaceClassifier(self.faces[face], gp_Pnt2d(*uv), 1e-9).State() in (TopAbs_IN, TopAbs_ON)


def compare(folder, count, path):
    shape = read(path)
    points, ours = ask(folder, count, path, shape)
    if ours is None:
        return True
    faces, places, owner, uvs, off = samples(shape)
    local, tree = Local(faces), cKDTree(places)
    whole = compound(shape)
    gaps, near = tree.query(points, k=STARTS)
    theirs = (gaps + off[near]).min(axis=1)
    farther, doubts, stray, worst = 0, 0, 0, 0.0
    _, beside = tree.query(ours[:, 1:4], k=STARTS)
    exact = 0
    for i, q in enumerate(points):
        feet = [(k, local.foot(owner[k], q, uvs[k])) for k in near[i]]
        feet = [(f[0], owner[k], f[1]) for k, f in feet if f and f[0] < theirs[i] and local.inside(owner[k], f[1])]
        exact += bool(feet)
        theirs[i] = min([theirs[i], *(f[0] for f in feet)])
        if ours[i, 0] > theirs[i] + MICRON:
            doubts += 1
            candidates = [places[k] for k in near[i]] + [local.point(face, uv) for _, face, uv in feet]
            nearer = [p for p in candidates if np.linalg.norm(p - q) < ours[i, 0]]
            theirs[i] = min((np.linalg.norm(p - q) + distance(p, whole) for p in nearer), default=np.inf)
        if ours[i, 0] > theirs[i] + MICRON:
            farther += 1
            if farther <= 5:
                print(f"  at {q.tolist()}: ours {ours[i, 0]!r}, theirs {theirs[i]!r}")
        foot = ours[i, 1:4]
        on = [f[0] for f in (local.foot(owner[k], foot, uvs[k]) for k in beside[i]) if f]
        off_all = min(on, default=np.inf)
        if off_all > MICRON:
            # On an edge, or on a face so flat that its samples are far apart.
            off_all = distance(foot, whole)
        worst = max(worst, off_all)
        stray += off_all > MICRON
    print(f"{path.name}: {count} points, {farther} farther than theirs by more than 1 µm ({doubts - farther} of theirs lie off the trimmed faces); the local search ended in a face for {exact}; ", end="")
    print(f"{stray} feet off all faces by more than 1 µm (at most {worst:.1e} mm)", flush=True)
    return farther == 0 and stray == 0


def main():
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    good = [compare(Path(sys.argv[1]), int(sys.argv[2]), Path(p)) for p in sys.argv[3:]]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
