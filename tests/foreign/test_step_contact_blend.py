"""Tubes on spheres and plates as OpenCASCADE reads them: solids, tangency, and the blend against the envelope of balls that touch both."""

import json
import math

import numpy as np
import pytest

import step_modeling as modeling
from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from rolling_balls import TANGENT, off_pipe, smooth_edges
from step_checks import assert_cuts, structure
from step_faces import Edge, StepFaces

STRUT = {"through": [0, 12, 0], "radius": 10, "length": 90}
CONE = {"direction": [0.45, -0.2, 1], "radius": 20, "taper": {"degrees": 6}, "length": 90}
PLATE = {"plate": [130, 120], "thickness": 10}
BLENDS = {
    "strut": {"tube": STRUT, "sphere": 40, "blend": 6},
    "hollow": {"tube": {**STRUT, "direction": [0.2, 0, 1]}, "sphere": 40, "blend": 6, "wall": 2},
    "closed cone": {"tube": {**STRUT, "taper": {"degrees": 3}}, "sphere": 40, "blend": 6, "wall": 2, "ends": "closed"},
    "central": {"tube": {"radius": 10, "length": 90}, "sphere": 40, "blend": 6},
    "boss": {"tube": CONE, **PLATE, "blend": 8},
    "disk": {"tube": CONE, "plate": {"radius": 70}, "blend": 8, "wall": 3},
    "head": {"tube": {"through": [5, 0, -60], "radius": 40, "length": 45}, "sphere": 75, "blend": 14, "side": "inside", "wall": 4},
    "rod": {"tube": CONE, "blend": 5, "side": "inside"},
}


@pytest.fixture(scope="module", params=BLENDS)
def blend(request, program, tmp_path_factory):
    return made(program, tmp_path_factory.mktemp("blend"), BLENDS[request.param])


def made(program, folder, fields):
    document = folder / "blend.json"
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"b": {"type": "contact-blend", **fields}}}))
    report = json.loads(program("build", document, "-o", folder / "blend.step", "--step-faces", "split", "--json"))
    return StepFaces(folder / "blend.step"), fields, report["objects"]["b"]


def tube(fields):
    """Point, direction, radius and taper."""
    spec = fields["tube"]
    way = np.array(spec.get("direction", [0, 0, 1]), float)
    taper = math.radians(spec.get("taper", {"degrees": 0})["degrees"])
    return np.array(spec.get("through", [0, 0, 0]), float), way / np.linalg.norm(way), spec["radius"], taper


def strips(fields):
    """Which faces are blends: of degree 16 over spheres, of which what is left has the degree 8, and 8 over planes; where blends are tori files say so."""
    degree = 16 if "sphere" in fields else 8
    return lambda face: face.kind == "torus" or face.rational is not None and sorted(face.rational.degrees) == [2, degree]


def test_blends_are_one_closed_solid_and_tangent_along_contacts(blend):
    step, fields, report = blend
    _, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    assert max(gap for gap, _ in modeling.departures(step)) <= 1e-12 * step.size()
    assert len(step.shells) == (2 if fields.get("ends") == "closed" else 1)
    assert sum(face.volume() for face in step.faces) == pytest.approx(report["volume"], rel=1e-9)
    smooth, contacts, creases = smooth_edges(users, strips(fields))
    assert contacts >= report["blends"][0]["pieces"] and creases > 0
    assert smooth <= TANGENT


def test_normals_of_the_strip_meet_in_centres_of_balls_that_touch_both(blend):
    step, fields, report = blend
    facts, wall = report["blends"][0], fields.get("wall", 0.0)
    sign = -1 if fields.get("side") == "inside" else 1
    # Balls of the outer skin, and of the inner one: their centres are the same.
    seen, size, is_strip = 0, step.size(), strips(fields)
    for face in step.faces:
        if face.rational is None or not is_strip(face):
            continue
        x, y = np.meshgrid(np.linspace(0.02, 0.98, 9), np.linspace(0.02, 0.98, 9), indexing="ij")
        points, normals = face.at_all(*face.rational.scaled(x, y))
        normals = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
        errors = []
        for radius in (facts["radius"]["min"], facts["radius"]["max"]):
            for skin in {0.0, wall}:
                for way in (normals, -normals):
                    centre = points + way * (radius + sign * skin)
                    base = centre[..., 2] if "sphere" not in fields else sign * (np.linalg.norm(centre, axis=-1) - fields["sphere"])
                    off = np.maximum(abs(sign * off_pipe(centre, tube(fields)) - radius), abs(base - radius))
                    errors.append(off.max())
        # The radius is known to its bounds only.
        assert min(errors) <= 3 * (facts["radius"]["max"] - facts["radius"]["min"]) + 1e-9 * size
        seen += points.shape[0] * points.shape[1]
    assert seen > 0 or all(face.kind != "b-spline" for face in step.faces)


def test_a_node_is_cut_fused_and_sectioned(program, tmp_path):
    step, fields, report = made(program, tmp_path, BLENDS["strut"])
    assert_cuts(step, report["volume"], modeling.slab, judged=False)
    # A plate into which the sphere sinks by 8.
    plate = BRepPrimAPI_MakeBox(gp_Pnt(-60, -50, -50), gp_Pnt(70, 60, -32)).Shape()
    fused = BRepAlgoAPI_Fuse(step.shape, plate).Shape()
    assert modeling.valid(fused)
    common = math.pi * 8**2 * (40 - 8 / 3)
    assert modeling.volume(fused) == pytest.approx(report["volume"] + 130 * 110 * 18 - common, rel=1e-6)
    section = modeling.wire_points(modeling.section(step.shape, (0, 0, 0), (0, 1, 0)))
    assert len(section) > 0 and np.abs(section[:, 1]).max() < 1e-6


STRAIGHT = {"direction": [0.45, -0.2, 1], "radius": 20, "length": 90}
PAIRS = {
    "cylinder and plate": {"tube": STRAIGHT, **PLATE, "blend": 8},
    "cone and plate": BLENDS["boss"],
    "cylinder and sphere": BLENDS["strut"],
    "cone and sphere": {"tube": {**STRUT, "direction": [0.2, 0, 1], "taper": {"degrees": 3}}, "sphere": 40, "blend": 6},
}


@pytest.mark.parametrize("name", PAIRS)
def test_solids_of_every_pair_are_cut_rounded_and_sectioned(name, program, tmp_path):
    step, _, report = made(program, tmp_path, PAIRS[name])
    assert len(step.solids) == 1 and step.exactly_valid
    tube = {face.kind for face in step.faces if face.kind in ("cylinder", "cone")}
    assert tube == {name.split()[0]}
    assert_cuts(step, report["volume"], modeling.slab, modeling.drill, judged=name != "cylinder and sphere")
    # The ends of tubes: all edges of one circle at once, as somebody would round them.
    _, users = structure(step, closed=True)
    rim = [edge for edge in modeling.creases(users) if at_end(edge, PAIRS[name])]
    make = BRepFilletAPI_MakeFillet(step.shape)
    for edge in rim:
        make.Add(1.0, edge)
    with modeling.quiet():
        make.Build()
    assert make.IsDone() and modeling.valid(make.Shape())
    # The corner that a fillet of 1 takes off the rim: less than its square round it.
    taken = report["volume"] - modeling.volume(make.Shape())
    assert 0 < taken < 2 * math.pi * PAIRS[name]["tube"]["radius"]
    low, high = modeling.box(step)
    section = modeling.wire_points(modeling.section(step.shape, 0.5 * (low + high), (0.3, 1, 0.1)))
    assert len(section) > 0 and abs((section - 0.5 * (low + high)) @ [0.3, 1, 0.1]).max() < 1e-6


RINGS = {
    "plate": {"ring": {"radius": 30, "tube": 8, "height": 2}, "plate": {"radius": 60}, "thickness": 7, "blend": 3},
    "sphere": {"ring": {"radius": 20, "tube": 6, "height": 18}, "sphere": 30, "blend": 2},
}


@pytest.mark.parametrize("name", RINGS)
def test_rings_are_solids_of_analytic_surfaces_and_are_cut(name, program, tmp_path):
    step, fields, report = made(program, tmp_path, RINGS[name])
    _, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    kinds = {face.kind for face in step.faces}
    assert kinds == ({"torus", "plane", "cylinder"} if name == "plate" else {"torus", "sphere"})
    assert sum(face.volume() for face in step.faces) == pytest.approx(report["volume"], rel=1e-9)
    # Smooth but for both circles of the rim of a plate, in quarters.
    assert len(modeling.creases(users)) == (8 if name == "plate" else 0)
    assert_cuts(step, report["volume"], modeling.slab, modeling.drill)


def at_end(edge, fields):
    """Whether an edge lies in the plane of the tube's end."""
    through, way, _, _ = tube(fields)
    points = np.array([Edge(edge).point(x) for x in (0.1, 0.5, 0.9)])
    return abs((points - through) @ way - fields["tube"]["length"]).max() < 1e-6


def test_random_blends_are_valid(program, tmp_path):
    generator = np.random.default_rng(11)
    for k in range(6):
        lean = generator.uniform(-0.4, 0.4, 2)
        fields = {"tube": {"direction": [*lean, 1], "radius": 10, "length": 110, "taper": {"degrees": generator.uniform(-2, 3)}}, "blend": generator.uniform(1, 5)}
        fields["tube"]["through"] = [*generator.uniform(-9, 9, 2), 0]
        fields.update({"sphere": generator.uniform(32, 60)} if k % 2 else {"plate": [120, 110], "thickness": 6})
        folder = tmp_path / str(k)
        folder.mkdir()
        step, _, report = made(program, folder, fields)
        structure(step, closed=True)
        assert len(step.solids) == 1 and step.exactly_valid, fields
        assert sum(face.volume() for face in step.faces) == pytest.approx(report["volume"], rel=1e-9), fields
