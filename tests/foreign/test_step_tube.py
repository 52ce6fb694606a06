"""Tubes of changing radius as OpenCASCADE reads them, against the envelope of the balls, computed here."""

import json
import math

import numpy as np
import pytest

import step_modeling as modeling
from step_checks import NORMAL_LIMIT, assert_cuts, normals_across_joints, structure
from step_faces import StepFaces

RUN = {"type": "polyline", "points": [[0, 0, 0], [60, 0, 0], [60, 50, 20], [0, 80, 30]], "radius": 16, "construction": True}
RING = {"type": "circle", "center": [0, 0], "radius": 30, "construction": True}
SPLINE = {"type": "fair-spline", "points": [[0, 0, 0], [60, 0, 0], [95, 35, 10], [70, 75, 30], [20, 70, 45]], "construction": True}
# Curve, fields, kinds of the faces, creases.
TUBES = {
    "cone": (None, {"balls": [[0, 0, 0, 8], [50, 10, 5, 3]], "ends": "round"}, {"cone", "sphere"}, 0),
    "handle": (None, {"balls": [[0, 0, 0, 7], [30, 8, 0, 5], [70, 0, 9, 9], [95, 10, 0, 6]]}, {"b-spline", "plane"}, 8),
    "bottle": (None, {"balls": [[0, 0, 0, 7], [30, 8, 0, 5], [70, 0, 9, 9]], "wall": 1}, {"b-spline", "cone"}, 16),
    "constant": (RUN, {"radius": 6}, {"cylinder", "torus", "plane"}, 8),
    "horn": (SPLINE, {"radius": [4, 5, 7, 13], "wall": 1.2, "tolerance": 0.05}, {"b-spline", "plane"}, 16),
    "closed": (RING, {"radius": [4, 7, 4], "tolerance": 0.02}, {"b-spline"}, 0),
}


@pytest.fixture(scope="module", params=TUBES)
def tube(request, program, tmp_path_factory):
    curve, fields, kinds, creases = TUBES[request.param]
    folder = tmp_path_factory.mktemp("tube")
    objects = {"way": curve} if curve else {}
    objects["tube"] = {"type": "tube", **({"of": "way"} if curve else {}), **fields}
    (folder / "tube.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", folder / "tube.json", "-o", folder / "tube.step", "--step-faces", "split", "--json"))
    return StepFaces(folder / "tube.step"), report["objects"]["tube"], fields, kinds, creases


def test_tubes_are_closed_solids_with_the_measures_of_the_report(tube):
    step, report, fields, kinds, creases = tube
    size, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    assert {face.kind for face in step.faces} == kinds
    assert modeling.volume(step.shape) == pytest.approx(report["volume"], rel=1e-8)
    assert step.area() == pytest.approx(report["total_area"] if "total_area" in report else report["area"], rel=1e-8)
    # The spline is approximated by arcs here, whose curvature jumps: faces of a changing radius meet in an angle there (docs/math/tubes.md, creases).
    assert normals_across_joints(users, creases) <= (5e-3 if fields is TUBES["horn"][1] else NORMAL_LIMIT)


def test_tubes_are_cut_and_sectioned(tube):
    step, _, fields, *_ = tube
    assert_cuts(step, modeling.volume(step.shape), modeling.slab, judged=fields != TUBES["horn"][1])
    low, high = modeling.box(step)
    middle = modeling.section(step.shape, 0.5 * (low + high), (1.0, 0.0, 0.0))
    points = modeling.wire_points(middle)
    assert len(points) > 0 and np.abs(points[:, 0] - 0.5 * (low + high)[0]).max() < 1e-6


def test_a_cone_is_the_hull_of_its_balls(program, tmp_path):
    """Points of the solid are at their distance from the hull of two balls: the sum over it is in closed form."""
    fields = TUBES["cone"][1]
    (tmp_path / "c.json").write_text(json.dumps({"cyclide": 1, "objects": {"c": {"type": "tube", **fields}}}))
    program("build", tmp_path / "c.json", "-o", tmp_path / "c.step", "--step-faces", "split")
    step = StepFaces(tmp_path / "c.step")
    (a, b) = (np.array(ball[:3], float) for ball in fields["balls"])
    r, s = (ball[3] for ball in fields["balls"])
    length = np.linalg.norm(b - a)
    way, lean = (b - a) / length, (r - s) / length
    generator = np.random.default_rng(3)
    for face in step.faces:
        points, _ = face.points(1000, generator)
        along = (points - a) @ way
        off = np.linalg.norm(points - a - along[:, None] * way, axis=-1)
        # The ball that is nearest: its contact is lean of the radius ahead of its centre.
        at = np.clip((along - lean * off / math.sqrt(1 - lean * lean)), 0, length)
        distance = np.hypot(along - at, off) - (r + (s - r) * at / length)
        assert np.abs(distance).max() < 1e-9 * length, face.kind
