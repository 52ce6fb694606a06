"""Tubes of sections and sections along paths as OpenCASCADE reads them: valid solids, with the volumes of Pappus computed here."""

import json
import math

import numpy as np
import pytest

import step_modeling as modeling
from step_faces import StepFaces

LINE = {"type": "polyline", "points": [[0, 0, 0], [0, 0, 100]], "construction": True}
RUN = {"type": "polyline", "points": [[0, 0, 0], [60, 0, 0], [60, 50, 20], [0, 80, 30]], "radius": 16, "construction": True}
CORNERS = {"type": "polyline", "points": [[0, 0, 0], [60, 0, 0], [60, 50, 20], [0, 80, 30]], "construction": True}
BAR = {"type": "polyline", "points": [[-2, -3], [2, -3], [2, 3], [-2, 3]], "closed": True, "construction": True}
BOX = {"type": "polyline", "points": [[[-4, -4], [4, -4], [4, 4], [-4, 4]], [[-2, -2], [2, -2], [2, 2], [-2, 2]]], "closed": True, "construction": True}


def length(path):
    """Length of a polyline with its corners rounded."""
    points = np.array(path["points"], float)
    ways = np.diff(points, axis=0)
    total = np.linalg.norm(ways, axis=1).sum()
    for a, b in zip(ways, ways[1:]):
        turn = math.acos(np.dot(a, b) / np.linalg.norm(a) / np.linalg.norm(b))
        radius = path.get("radius", 0)
        total += radius * (turn - 2 * math.tan(turn / 2))
    return total


def frustum(a, b, height):
    return math.pi / 3 * height * (a * a + a * b + b * b)


BODIES = {
    "reducer": (LINE, None, {"type": "tube", "radius": [60, 30]}, lambda path: frustum(60, 30, length(path)), 1e-9),
    "hollow": (LINE, None, {"type": "tube", "radius": [60, 30], "wall": 3}, lambda path: frustum(60, 30, length(path)) - frustum(57, 27, length(path)), 1e-9),
    "bent": (RUN, None, {"type": "tube", "radius": [8, 4]}, lambda path: frustum(8, 4, length(path)), 1e-4),
    "bent hollow": (RUN, None, {"type": "tube", "radius": [8, 4], "wall": 1}, lambda path: frustum(8, 4, length(path)) - frustum(7, 3, length(path)), 1e-4),
    "bar": (RUN, BAR, {"type": "sweep"}, lambda path: 24 * length(path), 1e-9),
    "mitred": (CORNERS, BAR, {"type": "sweep"}, lambda path: 24 * length(path), 1e-9),
    "twisted": (LINE, BAR, {"type": "sweep", "twist": 3}, lambda path: 24 * length(path), 1e-9),
    "box": (RUN, BOX, {"type": "sweep", "frame": "up", "up": [1, 2, 3]}, lambda path: 48 * length(path), 1e-9),
}


@pytest.mark.parametrize("name", BODIES)
def test_bodies_along_paths_are_valid_solids_of_the_right_volume(name, program, tmp_path):
    path, section, fields, volume, within = BODIES[name]
    objects = {"way": path, "body": {"of": "way", **fields}}
    if section:
        objects = {"section": section, **objects}
        objects["body"]["section"] = "section"
    (tmp_path / "b.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", tmp_path / "b.json", "-o", tmp_path / "b.step")
    step = StepFaces(tmp_path / "b.step")
    assert len(step.solids) == 1 and step.exactly_valid
    assert modeling.volume(step.shape) == pytest.approx(volume(path), rel=within)
    if path is LINE:
        low, high = modeling.box(step)
        assert low[2] == pytest.approx(0, abs=1e-6) and high[2] == pytest.approx(100, abs=1e-6)
