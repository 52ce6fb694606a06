"""The ways of the centres of balls and the surface of all centres as OpenCASCADE reads them: as far from both pipes as a ball, C1, one on the other."""

import json

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Surface
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.GeomAPI import GeomAPI_ProjectPointOnSurf
from OCP.gp import gp_Pnt, gp_Vec
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE
from OCP.TopoDS import TopoDS

import step_modeling as modeling
from rolling_balls import off_pipe
from test_step_crossing import axes, pipe
from test_step_torus_spline import explored

CROSSINGS = {
    "equal": ([20, 20], 30, 8, {}),
    "bridge with a law": ([16, 13], 36, {"first": 9, "second": 14}, {"angle": {"degrees": 70}}),
    "lens": ([28, 20], 24, 5, {"side": "inside"}),
    "cones": ([(20, 6), (20, -5)], 30, 6, {"tolerance": 0.1}),
}
# Rounding of coordinates up to some hundreds, through a quotient.
ROUNDING = 1e-10


@pytest.fixture(scope="module", params=CROSSINGS)
def centers(request, program, tmp_path_factory):
    radii, distance, blend, fields = CROSSINGS[request.param]
    spec = {"type": "pipe-crossing", "pipes": [pipe(r) for r in radii], "distance": distance, "blend": blend, **fields}
    folder = tmp_path_factory.mktemp("centers")
    objects = {
        "crossing": {**spec, "construction": True},
        "path": {"type": "ball-centers", "of": "crossing"},
        "all": {"type": "center-surface", "of": "crossing", "margin": 0.4},
    }
    (folder / "m.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", folder / "m.json", "-o", folder / "m.step", "--step-faces", "split", "--json"))
    reader = STEPControl_Reader()
    with modeling.quiet():
        reader.ReadFile(str(folder / "m.step"))
        reader.TransferRoots()
    shape = reader.OneShape()
    assert BRepCheck_Analyzer(shape, True, False, True).IsValid()
    # Parts that readers integrate well.
    faces = [TopoDS.Face(face) for face in explored(shape, TopAbs_FACE)]
    [edge] = explored(shape, TopAbs_EDGE, TopAbs_FACE)
    assert report["objects"]["all"]["patches"] == 1 and 1 <= len(faces) <= 16
    return spec, faces, TopoDS.Edge(edge)


def balls(spec, points):
    """Signed radii of the balls about points that touch each pipe."""
    sign = -1 if spec.get("side") == "inside" else 1
    return [sign * off_pipe(points, axis) for axis in axes(spec)]


def test_paths_are_those_of_one_ball(centers):
    spec, _, edge = centers
    curve = BRep_Tool.Curve_s(edge, 0.0, 0.0)
    first, last = curve.FirstParameter(), curve.LastParameter()
    points = np.array([(lambda p: [p.X(), p.Y(), p.Z()])(curve.Value(t)) for t in np.linspace(first, last, 1000)])
    radius, other = balls(spec, points)
    assert np.abs(radius - other).max() < ROUNDING
    asked = spec["blend"] if isinstance(spec["blend"], dict) else {"first": spec["blend"]}
    tolerance = spec.get("tolerance", 0.001 * max(asked.values())) + ROUNDING
    assert min(asked.values()) - tolerance < radius.min() and radius.max() < max(asked.values()) + tolerance
    # One C1 curve: knots of the degree less one, and one direction where it closes.
    assert curve.IsCN(1)
    (p, v), (q, w) = ((gp_Pnt(), gp_Vec()) for _ in range(2))
    curve.D1(first, p, v)
    curve.D1(last, q, w)
    assert p.Distance(q) < ROUNDING and v.Angle(w) < 1e-9


def test_surfaces_are_those_of_all_balls(centers):
    spec, faces, edge = centers
    for face in faces:
        surface = BRepAdaptor_Surface(face)
        assert (surface.UDegree(), surface.VDegree()) == (2, 2) and surface.IsURational()
        u_ends = surface.FirstUParameter(), surface.LastUParameter()
        v_ends = surface.FirstVParameter(), surface.LastVParameter()
        grid = [surface.Value(u, v) for u in np.linspace(*u_ends, 12) for v in np.linspace(*v_ends, 12)]
        points = np.array([[p.X(), p.Y(), p.Z()] for p in grid])
        radius, other = balls(spec, points)
        assert np.abs(radius - other).max() < ROUNDING
    curve = BRep_Tool.Curve_s(edge, 0.0, 0.0)
    first, last = curve.FirstParameter(), curve.LastParameter()
    for t in np.linspace(first, last, 50):
        feet = [GeomAPI_ProjectPointOnSurf(curve.Value(t), BRep_Tool.Surface_s(face)) for face in faces]
        # OpenCASCADE's own search stops there.
        assert min(foot.LowerDistance() for foot in feet if foot.NbPoints() > 0) < 1e-7
