"""Crossings of pipes, cylinders and cones, as OpenCASCADE reads them: solids, tangency, and the blend against the envelope of balls that touch both pipes, outside, inside and mixed."""

import json

import numpy as np
import pytest

import step_modeling as modeling
from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from rolling_balls import TANGENT, check_envelopes, off_pipe, smooth_edges
from step_checks import assert_cuts, structure
from step_faces import StepFaces

ENDS = [-80, 90]
# Radii, or these with tapers in degrees, the distance of the axes, the radius of the ball, other fields.
CROSSINGS = {
    "equal": ([20, 20], 30, 8, {"wall": 3}),
    "thin on thick": ([28, 10], 36, 6, {}),
    "bridge": ([15, 12], 33, 9, {"wall": 2, "ends": "closed"}),
    "deep": ([20, 20], 8, 4, {}),
    "askew": ([20, 15], 24, 4, {"wall": 2, "angle": {"degrees": 50}}),
    "acute": ([20, 20], 30, 3, {"angle": {"degrees": 150}}),
    "two radii": ([20, 15], 27, {"first": 5, "second": 8}, {"wall": 2, "angle": {"degrees": 75}}),
    "law": ([20, 20], 30, {"values": [{"angle": a, "radius": r} for a, r in ((0.3, 8), (1.6, 5), (2.9, 6), (4.6, 10))]}, {}),
    "lens with a law": ([20, 15], 21, {"first": 4, "second": 2.5}, {"side": "inside", "angle": {"degrees": 70}}),
    "hollow lens": ([28, 20], 24, 5, {"side": "inside", "wall": 2}),
    "notch with a law": ([15, 20], 20, {"first": 2.5, "second": 4}, {"side": "mixed", "angle": {"degrees": 70}}),
    "cones": ([(20, 6), (20, -5)], 30, 6, {"wall": 3, "tolerance": 0.1}),
    "cone askew": ([20, (15, 8)], 24, 4, {"tolerance": 0.1, "angle": {"degrees": 65}}),
    "bridge of cones": ([(20, 7), (16, 7)], 40, 9, {"wall": 2, "tolerance": 0.2, "ends": "closed", "angle": {"degrees": 100}}),
    "lens of cones": ([(20, 10), (24, -8)], 24, 4, {"side": "inside", "angle": {"degrees": 80}, "tolerance": 0.1}),
    "notched tube": ([20, 25], 36, 4, {"side": "mixed", "wall": 2}),
}


@pytest.fixture(scope="module", params=CROSSINGS)
def crossing(request, program, tmp_path_factory):
    return made(program, tmp_path_factory.mktemp("crossing"), *CROSSINGS[request.param])


def made(program, folder, radii, distance, blend, fields):
    pipes = [pipe(radius) for radius in radii]
    spec = {"type": "pipe-crossing", "pipes": pipes, "distance": distance, "blend": blend, **fields}
    document = folder / "crossing.json"
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"crossing": spec}}))
    report = json.loads(program("build", document, "-o", folder / "crossing.step", "--step-faces", "split", "--json"))
    return StepFaces(folder / "crossing.step"), spec, report["objects"]["crossing"]


def pipe(radius):
    if not isinstance(radius, tuple):
        return {"radius": radius, "ends": ENDS}
    radius, taper = radius
    return {"radius": radius, "taper": {"degrees": taper}, "ends": ENDS}


def axes(spec):
    """Point, direction, radius and taper of both pipes."""
    first, second = ((pipe["radius"], np.radians(pipe.get("taper", {"degrees": 0.0})["degrees"])) for pipe in spec["pipes"])
    angle = np.radians(spec["angle"]["degrees"]) if "angle" in spec else np.pi / 2
    return (
        (np.zeros(3), np.array([1.0, 0, 0]), *first),
        (np.array([0, 0, float(spec["distance"])]), np.array([np.cos(angle), np.sin(angle), 0.0]), *second),
    )


def envelope(spec, radius):
    """Both pipes with the range of signed radii, for which balls x + R n are R and the pipe's radius off each axis, n the outer normal: in the material R is negative, and so is
    the radius of a pipe that is not."""
    first, second = axes(spec)
    if "side" not in spec:
        return (first, second), radius
    point, way, r, taper = first
    cut = (point, way, -r if spec["side"] == "mixed" else r, taper)
    return (cut, second), {"min": -radius["max"], "max": -radius["min"]}


def law(spec):
    """Radii by the angles of the ball about the upward normal."""
    blend, turn = spec["blend"], axes(spec)[1][1]
    if not isinstance(blend, dict):
        return [(0.0, blend)]
    if "values" in blend:
        return [(value["angle"], value["radius"]) for value in blend["values"]]
    angle = np.arctan2(turn[1], turn[0])
    return [(0.0, blend["first"]), (angle, blend["second"]), (np.pi, blend["first"]), (np.pi + angle, blend["second"])]


def on_a_cone(face, spec, size):
    """Whether a rational face is that of a pipe with a taper, or as far below it as the wall is thick."""
    places = np.linspace(0, 1, 5)
    points, _ = face.at_all(*face.rational.scaled(*np.meshgrid(places, places, indexing="ij")))
    off = [off_pipe(points, axis) + depth for axis in axes(spec) for depth in {0.0, spec.get("wall", 0.0)} if axis[3] != 0]
    return min(abs(o).max() for o in off) <= 1e-12 * size


def is_blend(face):
    return face.rational is not None and sorted(face.rational.degrees) in ([2, 12], [2, 14])


def test_blends_are_envelopes_of_balls_that_touch_both_pipes(crossing):
    step, spec, report = crossing
    [blend], wall = report["blends"], spec.get("wall", 0.0)
    radii = [radius for _, radius in law(spec)]
    for asked, found in ((min(radii), blend["radius"]["min"]), (max(radii), blend["radius"]["max"])):
        assert abs(found - asked) <= spec.get("tolerance", 0.001 * asked)
    faces = check_envelopes(step, is_blend, [envelope(spec, blend["radius"])], wall)
    assert faces == (2 if wall else 1) * blend["pieces"]


@pytest.mark.parametrize("name", ["law", "lens with a law", "notch with a law"])
def test_balls_have_the_radii_of_the_law_in_their_directions(program, tmp_path, name):
    step, spec, _ = made(program, tmp_path, *CROSSINGS[name])
    radii = {}
    for face in filter(is_blend, step.faces):
        # Both ends of each arc at the ends of the piece, and from these the ball: x + R n is one centre.
        corners = [(s, t) for s in (0.0, 1.0) for t in (0.0, 1.0)]
        points, normals = face.at_all(*face.rational.scaled(*np.array(corners).T))
        normals = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
        pairs = ((0, 2), (1, 3)) if face.rational.degrees[0] == 2 else ((0, 1), (2, 3))
        for k, j in pairs:
            turn = normals[k] - normals[j]
            radius = (points[j] - points[k]) @ turn / (turn @ turn)
            x, y, _ = points[k] + radius * normals[k]
            radii[np.arctan2(y, x) % (2 * np.pi)] = abs(radius)
    for asked, radius in law(spec):
        off = min(radii, key=lambda at: abs((at - asked + np.pi) % (2 * np.pi) - np.pi))
        assert abs((off - asked + np.pi) % (2 * np.pi) - np.pi) < 1e-7
        assert radii[off] == pytest.approx(radius, rel=1e-7)


def test_crossings_are_one_closed_solid_and_tangent_along_contacts(crossing):
    step, spec, report = crossing
    _, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    lens, cones = spec.get("side") == "inside", any("taper" in pipe for pipe in spec["pipes"])
    others = [face for face in step.faces if not is_blend(face) and face.kind not in ("cylinder", "cone", "plane")]
    assert all(lens and cones and on_a_cone(face, spec, step.size()) for face in others)
    assert cones == any(face.kind == "cone" for face in step.faces)
    # The caps of cones are rational faces that come to a point, where the reader finds the parameter of an edge to less.
    assert max(gap for gap, _ in modeling.departures(step)) <= (1e-9 if lens and cones else 1e-12) * step.size()
    assert len(step.shells) == (2 if spec.get("ends") == "closed" or (lens and spec.get("wall")) else 1)
    assert step.volume() == pytest.approx(report["volume"], rel=1e-7)
    assert sum(face.volume() for face in step.faces) == pytest.approx(report["volume"], rel=1e-9)
    smooth, contacts, creases = smooth_edges(users, is_blend)
    assert contacts == 2 * (2 if spec.get("wall") else 1) * report["blends"][0]["pieces"] and (creases == 0 if lens else creases > 0)
    assert smooth <= TANGENT


def test_a_crossing_of_cones_is_cut(program, tmp_path):
    step, _, report = made(program, tmp_path, *CROSSINGS["cone askew"])
    assert_cuts(step, report["volume"], modeling.slab)


def test_a_crossing_is_cut_fused_and_sectioned(program, tmp_path):
    step, spec, report = made(program, tmp_path, [20, 20], 30, 8, {})
    assert_cuts(step, report["volume"], modeling.slab)
    # A plate under the first pipe, into which it sinks.
    plate = BRepPrimAPI_MakeBox(gp_Pnt(-60, -50, -40), gp_Pnt(70, 50, -15)).Shape()
    fused = BRepAlgoAPI_Fuse(step.shape, plate).Shape()
    assert modeling.valid(fused)
    half = np.arccos(15 / 20)
    common = 130 * 20**2 * (half - np.sin(half) * np.cos(half))
    assert modeling.volume(fused) == pytest.approx(report["volume"] + 130 * 100 * 25 - common, rel=1e-6)
    section = modeling.wire_points(modeling.section(step.shape, (0, 0, 0), (0, 1, 0)))
    assert len(section) > 0 and np.abs(section[:, 1]).max() < 1e-6


@pytest.mark.parametrize("name", ["lens with a law", "notch with a law"])
def test_what_is_rounded_outside_is_cut(program, tmp_path, name):
    radii, distance, blend, fields = CROSSINGS[name]
    step, _, report = made(program, tmp_path, radii, distance, blend, {**fields, "tolerance": 0.1})
    assert_cuts(step, report["volume"], modeling.slab)


def test_random_crossings_are_valid(program, tmp_path):
    generator = np.random.default_rng(7)
    for k in range(4):
        radii = [20.0, 20 * generator.uniform(0.4, 1)]
        # From well sunk to nearly apart.
        distance = (radii[0] - radii[1]) + generator.uniform(0.3, 0.95) * 2 * radii[1]
        lean = generator.uniform(35, 145) if k % 2 else 90.0
        blend = generator.uniform(0.05, 0.4) * radii[1] * np.sin(np.radians(lean)) ** 2
        folder = tmp_path / str(k)
        folder.mkdir()
        step, spec, report = made(program, folder, radii, distance, blend, {"angle": {"degrees": lean}, **({"wall": 0.05 * radii[1]} if k % 2 else {})})
        structure(step, closed=True)
        assert len(step.solids) == 1 and step.exactly_valid, spec
        assert step.volume() == pytest.approx(report["volume"], rel=1e-7), spec
