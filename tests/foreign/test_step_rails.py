"""Ruled and circular surfaces as OpenCASCADE reads them, against lines and circles between rails that are evaluated here."""

import json

import numpy as np
import pytest

from reference_objects import reported_area
from step_checks import NORMAL_LIMIT, POINT_LIMIT, POINTS_PER_FACE, assert_area, assert_parallel, structure
from step_faces import StepFaces

# Three points of each arc; less than a third of a turn, so that it is one face.
RAILS = {
    "leaning": ([[10, 0, 0], [8, 6, 0], [6, 8, 0]], [[14, 1, 12], [11, 9, 14], [5, 12, 11]]),
    "straight": ([[0, 0, 0], [5, 0, 0], [10, 0, 0]], [[0, 3, 4], [5, 5, 6.8], [10, 3, 9]]),
    "far": ([[1e4, 1e4, 0], [1e4 + 8, 1e4 + 3, 0], [1e4 + 15, 1e4, 2]], [[1e4, 1e4, 9], [1e4 + 7, 1e4 - 2, 10], [1e4 + 15, 1e4, 9]]),
}
TANGENT = [0.4, -0.5, 2.0]


class Rail:
    """The arc through three points at the parameter that runs at the same speed at both ends, from its rational form by hand:
    the middle control point is where the end tangents meet, its weight the cosine of half the angle."""

    def __init__(self, points):
        a, m, b = (np.array(p, float) for p in points)
        chord = b - a
        u, v = a - m, b - m
        # The inscribed angle is half of the turn on the other side.
        cos = -(u @ v) / np.linalg.norm(u) / np.linalg.norm(v)
        across = np.cross(np.cross(u, v), chord)
        length = np.linalg.norm(across)
        self.w = cos
        sine = np.sqrt(max(0.0, 1 - cos**2))
        off = across / length * np.linalg.norm(chord) / 2 * sine / cos if length > 0 else 0 * chord
        off = off * (1 if off @ (m - (a + b) / 2) >= 0 else -1)
        self.rows = np.array([a, (a + b) / 2 + off, b]), np.array([1.0, cos, 1.0])

    def jet(self, s):
        points, weights = self.rows
        basis = np.stack([(1 - s) ** 2, 2 * s * (1 - s), s**2], -1)
        slope = np.stack([-2 * (1 - s), 2 - 4 * s, 2 * s], -1)
        w, dw = basis @ weights, slope @ weights
        x = basis @ (points * weights[:, None]) / w[:, None]
        return x, (slope @ (points * weights[:, None]) - x * dw[:, None]) / w[:, None]


@pytest.fixture
def spanned(program, tmp_path):
    def make(name, fields):
        rails = {key: {"type": "arc", "through": points, "construction": True} for key, points in zip("ab", RAILS[name])}
        objects = {**rails, "s": {"rails": ["a", "b"], **fields}}
        (tmp_path / "s.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
        report = json.loads(program("build", tmp_path / "s.json", "-o", tmp_path / "s.step", "--step-faces", "split", "--json"))["objects"]["s"]
        return StepFaces(tmp_path / "s.step"), report, [Rail(points) for points in RAILS[name]]

    return make


def places(step):
    """Points and normals of the one face at random parameters, and the parameters along the rails."""
    (face,) = step.faces
    x, y = np.random.default_rng(3).uniform(0.0, 1.0, (2, POINTS_PER_FACE))
    points, du, dv = face.rational.jet(*face.rational.scaled(x, y))
    normal = np.cross(du, dv)
    return points, normal / np.linalg.norm(normal, axis=-1, keepdims=True), x


@pytest.mark.parametrize("name", RAILS)
def test_rulings_are_lines_between_equal_parameters(name, spanned):
    step, report, (first, second) = spanned(name, {"type": "ruled"})
    size, _ = structure(step, closed=False)
    assert_area(step, reported_area([report]))
    points, normals, s = places(step)
    (a, da), (b, db) = first.jet(s), second.jet(s)
    way = b - a
    t = np.sum((points - a) * way, -1) / np.sum(way * way, -1)
    assert (t >= -1e-9).all() and (t <= 1 + 1e-9).all()
    assert np.linalg.norm(points - a - t[:, None] * way, axis=-1).max() <= POINT_LIMIT * size
    expected = np.cross(da * (1 - t)[:, None] + db * t[:, None], way)
    assert_parallel(normals, expected / np.linalg.norm(expected, axis=-1, keepdims=True))


@pytest.mark.parametrize("name", RAILS)
def test_arcs_leave_the_first_rail_along_the_direction(name, spanned):
    step, report, (first, second) = spanned(name, {"type": "circular-surface", "tangent": TANGENT})
    size, _ = structure(step, closed=False)
    assert_area(step, reported_area([report]))
    points, normals, s = places(step)
    (a, _), (b, _) = first.jet(s), second.jet(s)
    # The arc from a to b with this direction in a: ((1-t) a + t b w) ((1-t) + t w)^-1 with w = (b - a)^-1 v.
    v = np.array(TANGENT)
    chord = b - a
    across = chord - v * (chord @ v / (v @ v))[:, None]
    inward = across / np.linalg.norm(across, axis=-1, keepdims=True)
    radius = np.sum(chord * chord, -1) / (2 * np.sum(chord * inward, -1))
    off = points - a - radius[:, None] * inward
    assert np.abs(np.linalg.norm(off, axis=-1) - radius).max() <= POINT_LIMIT * size
    plane = np.cross(inward, v / np.linalg.norm(v))
    assert np.abs(np.sum((points - a) * plane, -1)).max() <= POINT_LIMIT * size
    # The normal is across the arc.
    along = np.cross(plane, off)
    assert np.abs(np.sum(normals * along, -1) / np.linalg.norm(along, axis=-1)).max() <= NORMAL_LIMIT
