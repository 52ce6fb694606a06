"""Curves on tori as OpenCASCADE reads them: on the torus of the same file, C1; seams along them are fused to the torus and cut from it."""

import json

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.GeomAbs import GeomAbs_Torus
from OCP.gp import gp_Pnt, gp_Vec
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

import step_modeling as modeling

A, B = 40.0, 12.0
CENTER, AXIS = np.array([5.0, -3.0, 2.0]), np.array([1.0, 2.0, 2.0]) / 3.0
RING = {"type": "cyclide", "a": A, "mu": B, "center": CENTER.tolist(), "axis": AXIS.tolist(), "segments": [3, 3]}
WAVE = {"degrees": [[0, 20], [70, 80], [140, -30], [220, -170], [290, 40]]}
CURVES = {
    "spline": {"type": "torus-spline", "angles": WAVE, "closed": True, "winding": [1, 1]},
    "turning back": {"type": "torus-spline", "angles": WAVE, "rates": {"degrees": [[-300, 0], *4 * ["free"]]}},
    "knot": {"type": "torus-knot", "turns": [3, -5]},
    "villarceau": {"type": "torus-circle", "family": "villarceau", "at": [1, 2]},
}
# Double precision of coordinates up to 100, and of the quotient of degree 7 that they are read from.
ON_TORUS = 1e-12 * (A + B)


def explored(shape, kind, avoid=None):
    search = TopExp_Explorer(shape, kind, avoid) if avoid is not None else TopExp_Explorer(shape, kind)
    while search.More():
        yield search.Current()
        search.Next()


def read(program, folder, objects):
    (folder / "m.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", folder / "m.json", "-o", folder / "m.step", "--step-faces", "split")
    reader = STEPControl_Reader()
    with modeling.quiet():
        reader.ReadFile(str(folder / "m.step"))
        reader.TransferRoots()
    return reader.OneShape()


def off_torus(p):
    """Distance from the torus, by its definition."""
    v = p - CENTER
    height = v @ AXIS
    return abs(np.hypot(np.linalg.norm(v - height * AXIS) - A, height) - B)


@pytest.fixture(scope="module", params=CURVES)
def curve(request, program, tmp_path_factory):
    objects = {"ring": RING, "curve": {**CURVES[request.param], "torus": "ring"}}
    return request.param, read(program, tmp_path_factory.mktemp("torus"), objects)


def test_curves_lie_on_the_torus_of_the_same_file(curve):
    name, shape = curve
    assert modeling.valid(shape) and len(list(explored(shape, TopAbs_SOLID))) == 1
    for face in explored(shape, TopAbs_FACE):
        surface = BRepAdaptor_Surface(TopoDS.Face(face))
        assert surface.GetType() == GeomAbs_Torus
        torus = surface.Torus()
        assert abs(torus.MajorRadius() - A) < 1e-12 and abs(torus.MinorRadius() - B) < 1e-12
        place, axis = torus.Location(), torus.Axis().Direction()
        assert np.linalg.norm(np.array([place.X(), place.Y(), place.Z()]) - CENTER) < 1e-12
        assert abs(abs(np.dot([axis.X(), axis.Y(), axis.Z()], AXIS)) - 1.0) < 1e-14
    edges = [TopoDS.Edge(edge) for edge in explored(shape, TopAbs_EDGE, TopAbs_FACE)]
    assert edges
    for edge in edges:
        line, first, last = curve_of(edge)
        for u in np.linspace(first, last, 2001):
            p = line.Value(float(u))
            assert off_torus(np.array([p.X(), p.Y(), p.Z()])) <= ON_TORUS, name


def curve_of(edge):
    found = BRep_Tool.Curve_s(edge, 0.0, 1.0)
    if isinstance(found, tuple):
        return found
    first, last = BRep_Tool.Range_s(edge)
    return found, first, last


def test_velocities_are_continuous(curve):
    name, shape = curve
    for edge in (TopoDS.Edge(edge) for edge in explored(shape, TopAbs_EDGE, TopAbs_FACE)):
        line = curve_of(edge)[0]
        if not hasattr(line, "NbKnots"):
            assert name == "villarceau"
            continue
        inner = range(2, line.NbKnots())
        assert len(inner) >= 4
        for knot in inner:
            u = line.Knot(knot)
            sides = []
            for spans in ((knot - 1, knot), (knot, knot + 1)):
                p, v = gp_Pnt(), gp_Vec()
                line.LocalD1(u, *spans, p, v)
                sides.append(np.array([v.X(), v.Y(), v.Z()]))
            speed = np.linalg.norm(sides[0])
            # Rounding of control points over the span: some 1e-13 of the size over a hundredth of the parameter.
            assert np.linalg.norm(sides[1] - sides[0]) <= 1e-9 * speed, f"{name}: knot {knot}"


def test_seams_are_fused_and_cut(program, tmp_path):
    """A raised seam and a groove on one ring: every result is one valid solid, and what is common is counted once."""
    line = {"type": "torus-spline", "torus": "ring", "angles": {"degrees": [[10, 20], [40, 60]]}, "construction": True}
    seam = {"type": "torus-seam", "of": "line", "width": 3, "height": [-1, 1], "tolerance": 0.05}
    shape = read(program, tmp_path, {"ring": RING, "line": line, "seam": seam})
    ring, seam = sorted(explored(shape, TopAbs_SOLID), key=modeling.volume, reverse=True)
    assert modeling.valid(shape) and not modeling.faults(seam)
    volumes = {}
    for word, operation in modeling.OPERATIONS.items():
        made = operation(ring, seam)
        made.Build()
        assert modeling.valid(made.Shape()) and len(list(explored(made.Shape(), TopAbs_SOLID))) == 1, word
        volumes[word] = modeling.volume(made.Shape())
    own = [modeling.volume(ring), modeling.volume(seam)]
    # The tolerance of intersections, 1e-7 of 12 mm or so, along 100 mm of borders.
    assert abs(volumes["fuse"] + volumes["common"] - sum(own)) < 1e-4
    assert abs(volumes["cut"] + volumes["common"] - own[0]) < 1e-4
    # Half above and half below, less what the tube bends away under the width: w²/(8 b) of 2 in the middle.
    assert 0.40 < volumes["common"] / own[1] < 0.51
