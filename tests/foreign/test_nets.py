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
    # A quarter of the cells of other tests: these patches turn by less than a radian.
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
    program("build", ROOT / "examples/handle.json", "-o", tmp_path / "handle.step")
    step = StepFaces(tmp_path / "handle.step")
    size, _ = structure(step, closed=True)
    assert_patches(step, size, form.layer(skins[0], skins[2], 4, skin["closed"]))
    assert_volume(step, form.simpson([sum(p.area() for p in skin) for skin in skins], distance))


def test_roof_is_the_net_over_its_vertices(program, tmp_path):
    """The example from the vertices that were made circular: frame, patches and offset are computed here."""
    document, size = ROOT / "examples/roof.json", 20
    rows = csv.DictReader(program("sample", document, "--object", "outer skin", "--count", 2).splitlines())
    grid = np.full((size + 1, size + 1, 3), np.nan)
    for row in rows:
        j, i = divmod(int(row["patch"]), size)
        # The reader converts to millimetres.
        grid[j + int(row["t"]), i + int(row["s"])] = [1000 * float(row[k]) for k in "xyz"]
    distance = 1000 * json.loads(document.read_text())["objects"]["inner skin"]["distance"]
    frame = form.fitted_frame(grid)
    program("build", document, "-o", tmp_path / "roof.step")
    step = StepFaces(tmp_path / "roof.step")
    extent, _ = structure(step, closed=False)
    assert_patches(step, extent, form.net(grid, *frame) + form.net(grid, *frame, offset=distance))
