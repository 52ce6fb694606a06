"""Meshes of a torus patch and of a whole torus against OpenCASCADE's BRepMesh in the same run.

    .venv/bin/python benches/compare_tessellation.py [TOLERANCE]      default 1e-4

The torus has the radii 2 and 0.5; the patch P is a quarter turn both ways, as a rational biquadratic Bezier surface for
OpenCASCADE. BRepMesh runs once, on one thread, without a limit on angles, in processor time, so that a busy machine does
not count against it; ours is the smallest of twenty times by the clock. The deviation is the largest distance of
triangles' and quads' centres from the torus.
"""

import json
import math
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace
from OCP.BRepMesh import BRepMesh_IncrementalMesh
from OCP.BRepPrimAPI import BRepPrimAPI_MakeTorus
from OCP.Geom import Geom_BezierSurface
from OCP.gp import gp_Pnt
from OCP.TopAbs import TopAbs_FACE
from OCP.TopExp import TopExp_Explorer
from OCP.TopLoc import TopLoc_Location
from OCP.TopoDS import TopoDS
from OCP.collections import Array2_double, Array2_gp_Pnt

ROOT = Path(__file__).resolve().parent.parent
OUTER, INNER = 2.0, 0.5


def patch():
    """The quarter by quarter patch: products of two quadratic quarter circles."""
    half = math.sqrt(0.5)
    around = [(1.0, 0.0, 1.0), (1.0, 1.0, half), (0.0, 1.0, 1.0)]
    tube = [(OUTER + INNER, 0.0, 1.0), (OUTER + INNER, INNER, half), (OUTER, INNER, 1.0)]
    points, weights = Array2_gp_Pnt(1, 3, 1, 3), Array2_double(1, 3, 1, 3)
    for i, (x, y, v) in enumerate(around, 1):
        for j, (r, z, w) in enumerate(tube, 1):
            points.SetValue(i, j, gp_Pnt(r * x, r * y, z))
            weights.SetValue(i, j, v * w)
    return BRepBuilderAPI_MakeFace(Geom_BezierSurface(points, weights), 1e-7).Shape()


def first_face(shape):
    face = TopExp_Explorer(shape, TopAbs_FACE).Current()
    return TopoDS.Face_s(face) if hasattr(TopoDS, "Face_s") else TopoDS.Face(face)


def theirs(shape, tolerance):
    start = time.process_time()
    BRepMesh_IncrementalMesh(shape, tolerance, False, 10.0, False)
    seconds = time.process_time() - start
    mesh = BRep_Tool.Triangulation_s(first_face(shape), TopLoc_Location())
    nodes = (mesh.Node(i) for i in range(1, mesh.NbNodes() + 1))
    points = np.array([(p.X(), p.Y(), p.Z()) for p in nodes])
    triangles = np.array([mesh.Triangle(i).Get() for i in range(1, mesh.NbTriangles() + 1)]) - 1
    x, y, z = points[triangles].mean(axis=1).T
    deviation = np.abs(np.hypot(np.hypot(x, y) - OUTER, z) - INNER).max()
    return {"time": seconds, "nodes": len(points), "triangles": len(triangles), "deviation": deviation}


def ours(tolerance):
    command = ["cargo", "run", "--release", "--quiet", "--package", "cyclide", "--example", "tessellation_time", "--"]
    done = subprocess.run([*command, repr(tolerance)], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return {row["name"]: row for row in map(json.loads, done.stdout.splitlines())}


def main():
    tolerance = float(sys.argv[1]) if len(sys.argv) > 1 else 1e-4
    rows = ours(tolerance)
    print(f"chordal tolerance {tolerance:g}; time in ms")
    print(f"{'':8} {'':10} {'time':>10} {'nodes':>8} {'triangles':>9} {'deviation':>10}")
    for name, shape in [("patch", patch()), ("torus", BRepPrimAPI_MakeTorus(OUTER, INNER).Shape())]:
        peer, row = theirs(shape, tolerance), rows[name]
        for who, r in [("BRepMesh", peer), ("cyclide", row)]:
            print(f"{name:8} {who:10} {r['time'] * 1e3:10.3f} {r['nodes']:8} {r['triangles']:9} {r['deviation']:10.2e}")
        print(f"{name:8} {'ratio':10} {peer['time'] / row['time']:10.0f} {row['nodes'] / peer['nodes']:8.3f}", flush=True)


if __name__ == "__main__":
    main()
