"""Nets round extraordinary vertices, read by OpenCASCADE: one smooth shell, one solid, over the vertices of the mesh."""

import json

import numpy as np
import pytest

from OCP.BRep import BRep_Tool
from OCP.TopoDS import TopoDS

from conftest import ROOT
from step_checks import EDGES, NORMAL_LIMIT, assert_area, assert_quaternion_form, assert_volume, normals_across_joints, structure
from step_faces import StepFaces, vector

# The example: five sectors of 6 x 6 quads, of which the five at the top stay open.
PATCHES, BORDER, OPENING = 5 * 35, 60, 10


def mesh():
    """Vertices and quads of the example."""
    lines = [line.split() for line in (ROOT / "examples/oculus.obj").read_text().splitlines()]
    vertices = np.array([line[1:] for line in lines if line[0] == "v"], float)
    return vertices, [[int(v) - 1 for v in line[1:]] for line in lines if line[0] == "f"]


def document(folder, objects):
    path = folder / "oculus.json"
    path.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    return path


SKIN = {"type": "cyclidic-net", "grid": {"obj": str(ROOT / "examples/oculus.obj")}, "make_circular": True}


@pytest.mark.parametrize("edges", EDGES)
def test_the_skin_is_one_smooth_shell(edges, program, tmp_path):
    path = document(tmp_path, {"skin": SKIN})
    program("build", path, "-o", tmp_path / "skin.step", "--step-faces", "split", "--step-edges", edges)
    step = StepFaces(tmp_path / "skin.step")
    size, users = structure(step, closed=False)
    assert (len(step.shells), len(step.faces)) == (1, PATCHES)
    # A disc with one hole.
    assert len(step.vertices) - len(step.edges) + len(step.faces) == 0
    assert sum(len(group) == 1 for group in users) == BORDER + OPENING
    assert normals_across_joints(users) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
    # Every vertex is near one of the mesh, and only that at the top is missing.
    vertices, quads = mesh()
    edge = np.median([np.linalg.norm(vertices[q[0]] - vertices[q[1]]) for q in quads])
    found = np.array([vector(BRep_Tool.Pnt_s(TopoDS.Vertex(vertex))) for vertex in step.vertices])
    assert len(found) == len(vertices) - 1
    off = np.linalg.norm(found[:, None] - vertices[None], axis=-1).min(0)
    assert off[0] > 0.5 * edge and off[1:].max() < 0.5 * edge


def test_the_shell_of_the_example_is_a_solid(program, tmp_path):
    program("build", ROOT / "examples/oculus.json", "-o", tmp_path / "shell.step", "--step-faces", "split")
    step = StepFaces(tmp_path / "shell.step")
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells), len(step.faces)) == (1, 1, 2 * PATCHES + BORDER + OPENING)
    # Creases: rims along both skins, and between rims at the corners of the border (five) and of the opening (five; lines run on smoothly between).
    assert normals_across_joints(users, 2 * (BORDER + OPENING) + 5 + 5) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
    report = json.loads(program("report", ROOT / "examples/oculus.json", "--json"))
    shell = report["objects"]["shell"]
    # The reader has millimetres.
    assert_area(step, 1e6 * shell["total_area"])
    assert_volume(step, 1e9 * shell["volume"])


# The example of two umbilics: six quads stay open at each.
UMBILICS = ROOT / "examples/two_umbilics.json"


def test_one_mesh_round_umbilics_is_one_smooth_skin(program, tmp_path):
    """Grids that share their borders: one shell with two holes, smooth all over, near the B-spline surface it was laid on."""
    document = json.loads(UMBILICS.read_text())
    document["objects"]["skin"]["construction"] = False
    del document["objects"]["glass"]
    path = tmp_path / "umbilics.json"
    path.write_text(json.dumps(document))
    program("build", path, "-o", tmp_path / "skin.step", "--step-faces", "split")
    step = StepFaces(tmp_path / "skin.step")
    size, users = structure(step, closed=False)
    assert len(step.shells) == 1
    # A disc with two holes.
    assert len(step.vertices) - len(step.edges) + len(step.faces) == -1
    assert normals_across_joints(users) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
    report = json.loads(program("report", path, "--json"))["objects"]
    assert report["lattice"]["principal"]["joined_round"] == 2
    pieces = report["lattice"]["principal"]["pieces"]
    quads = sum(piece["coverage"] for piece in pieces)
    assert 0.85 < quads < 1.0 and len(pieces) == 13
    # The Bezier surface by its own polynomials, metres; the reader has millimetres.
    heights = np.array([[p[2] for p in row] for row in document["objects"]["lattice"]["nurbs"]["control_points"]])
    def bernstein(t):
        return np.array([(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t**3])
    found = np.array([vector(BRep_Tool.Pnt_s(TopoDS.Vertex(vertex))) for vertex in step.vertices]) / 1000
    off = [z - bernstein((y + 10) / 20) @ heights @ bernstein((x + 10) / 20) for x, y, z in found]
    moved = report["skin"]["circular"]["move_max"]
    # Vertices slide along the surface, and leave it by little: a hundredth of an edge.
    assert np.abs(off).max() < 0.02 * 0.8 and moved < 0.3 * 0.8


def test_glass_over_two_umbilics_is_a_solid(program, tmp_path):
    program("build", UMBILICS, "-o", tmp_path / "glass.step", "--step-faces", "split")
    step = StepFaces(tmp_path / "glass.step")
    structure(step, closed=True)
    assert (len(step.solids), len(step.shells)) == (1, 1)
    glass = json.loads(program("report", UMBILICS, "--json"))["objects"]["glass"]
    assert_volume(step, 1e9 * glass["volume"])
