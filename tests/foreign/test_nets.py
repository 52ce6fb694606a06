"""STEP bodies of nets read by OpenCASCADE: every face against the patch computed from the document's points and frame."""

import csv
import json

import numpy as np
import pytest

import surface_form as form
from conftest import ROOT
from step_checks import (
    EDGES,
    NORMAL_LIMIT,
    assert_area,
    assert_quaternion_form,
    assert_volume,
    built,
    normals_across_joints,
    partners,
    structure,
)
from step_faces import StepFaces

# The rim of the net below meets both skins in 14 edges, and itself in the corners of the grid.
CREASES = 2 * 14 + 4


def assert_patches(step, size, patches):
    """Every face is one of the patches, and their areas are the area."""
    assert_quaternion_form(step, size, partners(step, patches, size))
    # A quarter of the cells of other tests in each direction: these patches turn by a quarter at most.
    assert_area(step, sum(patch.area(2) for patch in patches))


@pytest.mark.parametrize("edges", EDGES)
def test_net_and_its_offset_are_one_open_shell_each(edges, program, tmp_path):
    net = form.turned_net()
    objects = {"skin": form.net_document(*net), "inner": {"type": "offset", "of": "skin", "distance": -0.2}}
    path, _ = built(program, tmp_path, objects, "--step-edges", edges)
    step = StepFaces(path)
    size, users = structure(step, closed=False)
    assert (len(step.shells), len(step.faces)) == (2, 24)
    assert (len(step.edges), len(step.vertices)) == (2 * 31, 2 * 20)
    assert sum(len(group) == 1 for group in users) == 2 * 14, "only the rim is free"
    assert step.exactly_valid or edges == "circle"
    assert normals_across_joints(users) <= NORMAL_LIMIT
    assert_patches(step, size, form.net(*net) + form.net(*net, offset=-0.2))


def test_thick_net_with_a_rim_is_a_solid(program, tmp_path):
    net = form.turned_net()
    objects = {
        "skin": form.net_document(*net, construction=True),
        "thick": {"type": "offset", "of": "skin", "distance": -0.2, "thick": True},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells), len(step.faces)) == (1, 1, 24 + 14)
    assert normals_across_joints(users, CREASES) <= NORMAL_LIMIT
    assert {face.kind for face in step.faces} <= {"b-spline", "cone", "cylinder", "plane"}
    skins = [form.net(*net, offset=h) for h in (0.0, -0.1, -0.2)]
    assert_patches(step, size, form.layer(skins[0], skins[2], 4))
    assert_volume(step, form.simpson([sum(p.area(2) for p in skin) for skin in skins], -0.2))


def test_handle_is_what_its_document_says(program, tmp_path):
    """The example from its document alone: a tube of 4 by 3 patches, its offset and the rims at both ends."""
    objects = json.loads((ROOT / "examples/handle.json").read_text())["objects"]
    skin, distance = objects["skin"], objects["handle"]["distance"]
    skins = [form.net(skin["grid"], *skin["frame"], skin["closed"], offset=x * distance) for x in (0.0, 0.5, 1.0)]
    program("build", ROOT / "examples/handle.json", "-o", tmp_path / "handle.step", "--step-faces", "split")
    step = StepFaces(tmp_path / "handle.step")
    size, _ = structure(step, closed=True)
    assert_patches(step, size, form.layer(skins[0], skins[2], 4, skin["closed"]))
    assert_volume(step, form.simpson([sum(p.area() for p in skin) for skin in skins], distance))


def tower(u, v):
    """A tower with bumps, closed along u."""
    r = 20 * (1 + 0.1 * np.cos(3 * u) * np.sin(np.pi * v) + 0.05 * np.sin(2 * u + 1) * v)
    return np.stack([r * np.cos(u), r * np.sin(u), 50 * v], -1)


def ring(u, v):
    """A ring that undulates, closed along u and v."""
    r, w = 12 * (1 + 0.15 * np.cos(3 * u)), 2 * np.pi * v
    return np.stack([(50 + r * np.cos(w)) * np.cos(u), (50 + r * np.cos(w)) * np.sin(u), r * np.sin(w) + 3 * np.sin(2 * u)], -1)


def closed_net(surface, columns, rows, closed):
    """The object of a document, with a frame near the edges: round an even number of them every frame comes back."""
    u, v = np.meshgrid(2 * np.pi * np.arange(columns) / columns, np.arange(rows) / (rows if closed[1] else rows - 1))
    grid = surface(u, v)
    v1 = form.unit(grid[0, 1] - grid[0, -1])
    v2 = grid[1, 0] - grid[0, 0]
    v2 = form.unit(v2 - np.dot(v1, v2) * v1)
    return grid, (v1, v2), form.net_document(grid, v1, v2, closed=list(closed), make_circular=True)


def moved_vertices(program, path, name, grid, closed):
    """Rows of the vertices as they were made circular."""
    rows, columns = grid.shape[:2]
    moved = np.full(grid.shape, np.nan)
    for row in csv.DictReader(program("sample", path, "--object", name, "--count", 2).splitlines()):
        j, i = divmod(int(row["patch"]), columns)
        moved[(j + int(row["t"])) % rows, (i + int(row["s"])) % columns] = [float(row[k]) for k in "xyz"]
    return moved


@pytest.mark.parametrize(
    "surface, closed, rows, count", [(ring, (True, True), 10, 18 * 10), (tower, (True, False), 9, 18 * 8)]
)
def test_closed_nets_made_circular_are_sewn_all_round(surface, closed, rows, count, program, tmp_path):
    grid, frame, net = closed_net(surface, 18, rows, closed)
    path, _ = built(program, tmp_path, {"skin": net})
    moved = moved_vertices(program, tmp_path / "model.json", "skin", grid, closed)
    assert form.residuals(moved).max() <= 1e-12 and np.linalg.norm(moved - grid, axis=-1).max() > 0.1
    step = StepFaces(path)
    size, users = structure(step, closed=all(closed))
    assert (len(step.shells), len(step.faces)) == (1, count)
    assert len(step.solids) == (1 if all(closed) else 0)
    assert sum(len(group) == 1 for group in users) == (0 if all(closed) else 2 * 18)
    assert normals_across_joints(users) <= NORMAL_LIMIT, "no crease, at the seam neither"
    assert_patches(step, size, form.net(moved, *frame, closed))


def test_closed_net_made_thick_is_a_solid(program, tmp_path):
    grid, frame, net = closed_net(tower, 18, 9, (True, False))
    objects = {"skin": {**net, "construction": True}, "wall": {"type": "offset", "of": "skin", "distance": 0.5, "thick": True}}
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.faces)) == (1, 2 * 18 * 8 + 2 * 18)
    assert normals_across_joints(users, 4 * 18) <= NORMAL_LIMIT
    moved = moved_vertices(program, tmp_path / "model.json", "skin", grid, (True, False))
    skins = [form.net(moved, *frame, (True, False), offset=h) for h in (0.0, 0.25, 0.5)]
    assert_patches(step, size, form.layer(skins[0], skins[2], 18, (True, False)))
    assert_volume(step, form.simpson([sum(p.area(2) for p in skin) for skin in skins], 0.5))


ROOF = ROOT / "examples/roof.json"


@pytest.fixture(scope="module")
def roof_grid(program):
    """Rows of the 21 by 21 vertices that were made circular, metres."""
    rows = csv.DictReader(program("sample", ROOF, "--object", "outer skin", "--count", 2).splitlines())
    grid = np.full((21, 21, 3), np.nan)
    for row in rows:
        j, i = divmod(int(row["patch"]), 20)
        grid[j + int(row["t"]), i + int(row["s"])] = [float(row[k]) for k in "xyz"]
    return grid


def test_roof_vertices_are_on_circles_as_near_as_reported(program, roof_grid):
    """Moves and residuals from the mesh file and the vertices alone."""
    report = json.loads(program("report", ROOF, "--json"))["objects"]["outer skin"]["circular"]
    lines = (ROOT / "examples/roof-20.obj").read_text().splitlines()
    mesh = np.array([line.split()[1:] for line in lines if line.startswith("v ")], float).reshape(roof_grid.shape)
    moves = np.linalg.norm(roof_grid - mesh, axis=-1)
    assert (moves.max(), moves.mean()) == pytest.approx((report["move_max"], report["move_mean"]), rel=1e-12)
    assert moves.argmax() == report["farthest_vertex"]
    assert form.residuals(mesh).max() == pytest.approx(report["residual_before"], rel=1e-12)
    # The program stops at 1e-12; the differences of the coordinates lose a digit or two of sixteen.
    assert form.residuals(roof_grid).max() <= 1e-12


def test_roof_is_the_net_over_its_vertices(program, roof_grid, tmp_path):
    """The example from the vertices that were made circular: frame, patches and offset are computed here."""
    # The reader converts to millimetres.
    grid, distance = 1000 * roof_grid, 1000 * json.loads(ROOF.read_text())["objects"]["inner skin"]["distance"]
    frame = form.fitted_frame(grid)
    program("build", ROOF, "-o", tmp_path / "roof.step", "--step-faces", "split")
    step = StepFaces(tmp_path / "roof.step")
    size, _ = structure(step, closed=False)
    assert_patches(step, size, form.net(grid, *frame) + form.net(grid, *frame, offset=distance))
