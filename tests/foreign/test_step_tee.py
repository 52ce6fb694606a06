"""Tees of pipes as OpenCASCADE reads them: solids, tangency, and the blend against the envelope of balls that touch both pipes."""

import json
import math

import numpy as np
import pytest
import trimesh

import step_modeling as modeling
from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from rolling_balls import TANGENT, check_envelopes, smooth_edges
from step_checks import assert_cuts, structure
from step_faces import StepFaces

MAIN = {"radius": 30, "ends": [-90, 110]}
LAW = {"crotch": 10, "flank": 6}
# Branches, other fields.
TEES = {
    "upright": ([{"radius": 20, "length": 80, "blend": LAW}], {}),
    "least": ([{"radius": 8, "length": 80, "blend": {"least": 4}}], {}),
    "lateral": ([{"radius": 18, "length": 100, "angle": {"degrees": 45}, "blend": 5}], {"wall": 3}),
    "offset": ([{"radius": 12, "length": 80, "angle": {"degrees": 115}, "offset": 12, "blend": LAW}], {"wall": 2, "ends": "closed"}),
    "tapered": ([{"radius": 18, "length": 90, "angle": {"degrees": 70}, "taper": {"degrees": 5}, "offset": 5, "blend": LAW}], {"wall": 2}),
    "wider": ([{"radius": 10, "length": 80, "angle": {"degrees": 110}, "taper": {"degrees": -9}, "offset": -4, "blend": 5}], {}),
    "equal": ([{"radius": 30, "length": 100, "blend": 5}], {}),
    "equal lateral": ([{"radius": 30, "length": 130, "angle": {"degrees": 55}, "azimuth": {"degrees": 30}, "blend": 4}], {"wall": 3}),
    "manifold": (
        [
            {"radius": 14, "length": 70, "at": -55, "blend": LAW},
            {"radius": 10, "length": 70, "at": 5, "azimuth": {"degrees": 70}, "offset": -8, "blend": {"values": [{"angle": 0, "radius": 5}]}},
            {"radius": 14, "length": 75, "at": 60, "angle": {"degrees": 70}, "blend": {"crotch": 7, "flank": 4}},
        ],
        {"wall": 2},
    ),
    "cross": ([{"radius": 18, "length": 80, "blend": LAW}, {"radius": 13, "length": 80, "at": 6, "angle": {"degrees": 70}, "azimuth": {"degrees": 175}, "blend": 4}], {}),
    "three": (
        [
            {"radius": 14, "length": 70, "blend": 3},
            {"radius": 11, "length": 75, "taper": {"degrees": 3}, "azimuth": {"degrees": 120}, "at": 5, "blend": {"crotch": 4, "flank": 3}},
            {"radius": 12, "length": 80, "angle": {"degrees": 65}, "azimuth": {"degrees": 240}, "blend": 3},
        ],
        {"wall": 2, "ends": "closed"},
    ),
    "row": (
        [
            {"radius": 26, "length": 80, "blend": 4},
            {"radius": 8, "length": 70, "azimuth": {"degrees": 185}, "at": -18, "blend": 2},
            {"radius": 8, "length": 70, "azimuth": {"degrees": 170}, "at": 14, "blend": 2},
        ],
        {},
    ),
    "reducer": (
        [
            {"radius": 16, "length": 90, "angle": {"degrees": 65}, "offset": 5, "taper": {"degrees": 3}, "blend": LAW},
            {"radius": 10, "length": 80, "angle": {"degrees": 105}, "azimuth": {"degrees": 180}, "offset": -4, "blend": 4},
        ],
        {"main": {"radius": 30, "taper": {"degrees": 4}, "ends": [-90, 110]}, "wall": 2, "ends": "closed"},
    ),
    "equal cross": ([{"radius": 30, "length": 90, "blend": 5}, {"radius": 30, "length": 90, "azimuth": {"degrees": 180}, "blend": 8}], {}),
    "equal laterals": (
        [
            {"radius": 30, "length": 120, "angle": {"degrees": 60}, "azimuth": {"degrees": 30}, "blend": 4},
            {"radius": 30, "length": 120, "angle": {"degrees": 110}, "azimuth": {"degrees": 210}, "blend": 6},
        ],
        {"wall": 3},
    ),
}
# Branches beside each other.
CROSSES = ["cross", "row", "reducer", "equal cross"]


@pytest.fixture(scope="module", params=TEES)
def tee(request, program, tmp_path_factory):
    branches, fields = TEES[request.param]
    return made(program, tmp_path_factory.mktemp("tee"), MAIN, branches, fields)


def made(program, folder, main, branches, fields):
    spec = {"type": "pipe-tee", "main": main, "branches": branches, **fields}
    document = folder / "tee.json"
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"tee": spec}}))
    report = json.loads(program("build", document, "-o", folder / "tee.step", "--step-faces", "split", "--json"))
    return StepFaces(folder / "tee.step"), spec, report["objects"]["tee"]


def radians(value, default):
    return math.radians(value["degrees"]) if isinstance(value, dict) else default


def axes(spec):
    """Point, direction, radius and taper of the main pipe and of every branch."""
    found = [(np.zeros(3), np.array([1.0, 0, 0]), spec["main"]["radius"], radians(spec["main"].get("taper"), 0.0))]
    for branch in spec["branches"]:
        lean, turn = radians(branch.get("angle"), math.pi / 2), radians(branch.get("azimuth"), 0.0)
        up = np.array([0, -math.sin(turn), math.cos(turn)])
        side = np.array([0, math.cos(turn), math.sin(turn)])
        way = math.cos(lean) * np.array([1.0, 0, 0]) + math.sin(lean) * up
        found.append((branch.get("at", 0) * np.array([1.0, 0, 0]) + branch.get("offset", 0) * side, way, branch["radius"], radians(branch.get("taper"), 0.0)))
    return found


def is_blend(face):
    return face.rational is not None and sorted(face.rational.degrees) in ([2, 8], [2, 12])


def test_blends_are_envelopes_of_balls_that_touch_both_pipes(tee):
    step, spec, report = tee
    pipes, wall = axes(spec), spec.get("wall", 0.0)
    pairs = [((pipes[0], branch), blend["radius"]) for branch, blend in zip(pipes[1:], report["blends"])]
    faces = check_envelopes(step, is_blend, pairs, wall)
    assert faces == (2 if wall else 1) * sum(blend["pieces"] for blend in report["blends"])


def test_tees_are_one_closed_solid_and_tangent_along_contacts(tee):
    step, spec, report = tee
    _, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    # All but the blends is planes, cylinders and cones, with curves in the parameters that are off by rounding.
    tapered = any("taper" in pipe for pipe in [spec["main"], *spec["branches"]])
    kinds = {face.kind for face in step.faces if not is_blend(face)}
    assert {"plane", "cylinder"} <= kinds and kinds - {"plane", "cylinder"} == ({"cone"} if tapered else set())
    assert max(gap for gap, _ in modeling.departures(step)) <= 1e-12 * step.size()
    assert len(step.shells) == (2 if spec.get("ends") == "closed" else 1)
    assert step.volume() == pytest.approx(report["volume"], rel=1e-7)
    assert sum(face.volume() for face in step.faces) == pytest.approx(report["volume"], rel=1e-9)
    smooth, contacts, creases = smooth_edges(users, is_blend)
    skins = 2 if spec.get("wall") else 1
    assert contacts == 2 * skins * sum(blend["pieces"] for blend in report["blends"]) and creases > 0
    assert smooth <= TANGENT


@pytest.mark.parametrize("name", ["equal", "equal lateral"])
def test_equal_tees_are_cut_and_fused(name, program, tmp_path):
    branches, fields = TEES[name]
    step, _, report = made(program, tmp_path, MAIN, branches, fields)
    assert_cuts(step, report["volume"], modeling.slab, judged=False)
    fused = BRepAlgoAPI_Fuse(step.shape, BRepPrimAPI_MakeBox(gp_Pnt(-60, -50, -45), gp_Pnt(80, 50, -25)).Shape()).Shape()
    assert modeling.valid(fused) and modeling.volume(fused) > report["volume"]


@pytest.mark.parametrize("name", CROSSES)
def test_crosses_are_cut_fused_and_sectioned(name, program, tmp_path):
    branches, fields = TEES[name]
    step, _, report = made(program, tmp_path, MAIN, branches, fields)
    assert_cuts(step, report["volume"], modeling.slab, judged=name == "equal cross")
    # A plate beside the main pipe, into which flanks and branches sink.
    fused = BRepAlgoAPI_Fuse(step.shape, BRepPrimAPI_MakeBox(gp_Pnt(-60, 25, -45), gp_Pnt(80, 45, 40)).Shape()).Shape()
    assert modeling.valid(fused) and modeling.volume(fused) > report["volume"]
    section = modeling.wire_points(modeling.section(step.shape, (0, 0, 0), (0, 1, 0)))
    assert len(section) > 0 and np.abs(section[:, 1]).max() < 1e-6


@pytest.mark.parametrize("name", ["cross", "equal cross"])
def test_meshes_of_crosses_are_watertight_at_all_scales(name, program, tmp_path):
    def scaled(value, scale):
        if isinstance(value, dict):
            return value if "degrees" in value else {key: scaled(entry, scale) for key, entry in value.items()}
        return [scaled(entry, scale) for entry in value] if isinstance(value, list) else scale * value

    for scale in (1e-6, 1.0, 1e6):
        spec = {"type": "pipe-tee", "main": scaled(MAIN, scale), "branches": scaled(TEES[name][0], scale)}
        document, path = tmp_path / "cross.json", tmp_path / "cross.stl"
        document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"cross": spec}}))
        report = json.loads(program("build", document, "-o", path, "--tolerance", 0.02 * scale, "--json"))
        # Vertices are one where they are equal; the reader merges to 1e-8.
        mesh = trimesh.load(path, process=False).apply_scale(1 / scale)
        mesh.merge_vertices()
        assert mesh.is_watertight and mesh.is_winding_consistent and len(mesh.split()) == 1
        # Within the tolerance of an area of 60,000, in a volume of 600,000.
        assert mesh.volume == pytest.approx(report["objects"]["cross"]["volume"] / scale**3, rel=2e-3)


@pytest.fixture(scope="module")
def upright(program, tmp_path_factory):
    branches, fields = TEES["upright"]
    return made(program, tmp_path_factory.mktemp("upright"), MAIN, branches, fields)


def test_a_tee_is_cut_fused_and_sectioned(upright):
    step, _, report = upright
    assert_cuts(step, report["volume"], modeling.slab)
    # A plate under the main pipe, into which it sinks.
    plate = BRepPrimAPI_MakeBox(gp_Pnt(-60, -50, -45), gp_Pnt(80, 50, -25)).Shape()
    fused = BRepAlgoAPI_Fuse(step.shape, plate).Shape()
    assert modeling.valid(fused)
    volume = modeling.volume(fused)
    # The part of the pipe in the plate is a segment of its circle, 5 high, over the length of the plate.
    half = math.acos(25 / 30)
    common = 140 * 30**2 * (half - math.sin(half) * math.cos(half))
    assert volume == pytest.approx(report["volume"] + 140 * 100 * 20 - common, rel=1e-6)
    section = modeling.wire_points(modeling.section(step.shape, (0, 0, 0), (0, 1, 0)))
    assert len(section) > 0 and np.abs(section[:, 1]).max() < 1e-6


def test_random_tees_are_valid(program, tmp_path):
    generator = np.random.default_rng(5)
    for k in range(3):
        r = 30 * generator.uniform(0.05, 0.98)
        lean = generator.uniform(35, 145)
        branch = {
            "radius": r,
            "length": 160,
            "angle": {"degrees": lean},
            "offset": (30 - r) * generator.uniform(-0.9, 0.9),
            "blend": {"radius": 0.15 * r, "tolerance": 0.01 * r},
        }
        folder = tmp_path / str(k)
        folder.mkdir()
        fields = {"wall": 0.1 * r} if k % 2 else {}
        step, _, report = made(program, folder, {"radius": 30, "ends": [-150, 150]}, [branch], fields)
        structure(step, closed=True)
        assert len(step.solids) == 1 and step.exactly_valid, branch
        assert step.volume() == pytest.approx(report["volume"], rel=1e-7), branch
