"""Pipes as OpenCASCADE reads them: analytic faces, the measures of Pappus, and what people do to a solid."""

import json
import math

import numpy as np
import pytest

import step_modelling as modelling
from conftest import ROOT
from step_checks import NORMAL_LIMIT, assert_area, assert_cuts, assert_volume, normals_across_joints, structure
from step_faces import StepFaces

RUN = json.loads((ROOT / "examples/pipe.json").read_text())["objects"]["run"]
SHORT = {**RUN, "points": RUN["points"][:5]}
SKEW = {"type": "polyline", "points": [[0, 0, 0], [60, 0, 10], [70, 50, -20], [-10, 40, 30]], "closed": True, "construction": True}
# Middle line, pipe, radii of the outer side and the bore, kinds of the faces, creases.
PIPES = {
    "bore": (SHORT, {"radius": 14, "wall": 2}, (14, 12), {"cylinder", "torus", "plane"}, 16),
    "round": (RUN, {"radius": 14, "ends": "round"}, (14, 0), {"cylinder", "torus", "sphere"}, 0),
    "closed": ({**SKEW, "radius": 12}, {"radius": 4, "wall": 1}, (4, 3), {"cylinder", "torus", "b-spline"}, 0),
    "mitred": (SKEW, {"radius": 4}, (4, 0), {"b-spline"}, 16),
}


@pytest.fixture(scope="module", params=PIPES)
def pipe(request, program, tmp_path_factory):
    run, fields, radii, kinds, creases = PIPES[request.param]
    folder = tmp_path_factory.mktemp("pipe")
    objects = {"run": run, "pipe": {"type": "pipe", "of": "run", **fields}}
    (folder / "pipe.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", folder / "pipe.json", "-o", folder / "pipe.step", "--json"))
    length = report["objects"]["run"]["length"]
    return StepFaces(folder / "pipe.step"), length, fields, radii, kinds, creases


def test_pipes_are_what_pappus_says(pipe):
    step, length, fields, (outer, inner), kinds, creases = pipe
    size, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    assert {face.kind for face in step.faces} == kinds
    ends = {"flat": 2 * math.pi * (outer**2 - inner**2), "round": 4 * math.pi * outer**2}[fields.get("ends", "flat")]
    caps = {"flat": 0.0, "round": 4 / 3 * math.pi * outer**3}[fields.get("ends", "flat")]
    is_closed = kinds >= {"b-spline"}
    assert_area(step, 2 * math.pi * (outer + inner) * length + (0.0 if is_closed else ends))
    assert_volume(step, math.pi * (outer**2 - inner**2) * length + caps)
    if kinds != {"b-spline"}:  # lines of mitred faces are not orthogonal, which the search of the normals needs
        assert normals_across_joints(users, creases) <= NORMAL_LIMIT


def test_pipes_are_cut_and_measured(pipe):
    step, *_ = pipe
    assert_cuts(step, modelling.volume(step.shape), modelling.slab)
    low, high = modelling.box(step)
    middle = modelling.section(step.shape, 0.5 * (low + high), (0.0, 0.0, 1.0))
    points = modelling.wire_points(middle)
    assert len(points) > 0 and np.abs(points[:, 2] - 0.5 * (low + high)[2]).max() < 1e-6
