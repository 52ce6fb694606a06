"""Rounded polyhedra as OpenCASCADE reads them, against SciPy's hull, Steiner's formulas and the distance from the polyhedron."""

import json
import math

import numpy as np
import pytest
from scipy.spatial import ConvexHull

import step_modeling as modeling
from conftest import ROOT
from step_checks import NORMAL_LIMIT, assert_area, assert_cuts, assert_points, assert_volume, normals_across_joints, structure
from step_faces import StepFaces



def sphere(count, seed):
    points = np.random.default_rng(seed).normal(size=(count, 3))
    return 50 * points / np.linalg.norm(points, axis=1, keepdims=True)


DODECAHEDRON = json.loads((ROOT / "examples/dodecahedron.json").read_text())["objects"]["dodecahedron"]
SOLIDS = {
    "dodecahedron": (np.array(DODECAHEDRON["points"]), DODECAHEDRON["radius"]),
    "hull": (sphere(50, 5), 2.0),
}
# Solids that are cut, and whose points are held against the hull: both take the time of their faces.
CUT = {"dodecahedron": SOLIDS["dodecahedron"], "small hull": (sphere(10, 6), 2.0)}
# Measured by the program and SciPy alone.
LARGE = sphere(200, 5), 2.0


def steiner(points, radius):
    """Volume and area of the points within the radius of the hull, from its triangles."""
    hull = ConvexHull(points)
    normals = hull.equations[:, :3]
    mean = 0.0
    for k, (triangle, beside) in enumerate(zip(hull.simplices, hull.neighbors)):
        for corner, other in enumerate(beside):
            if k < other:
                a, b = (points[triangle[i]] for i in range(3) if i != corner)
                turn = math.atan2(np.linalg.norm(np.cross(normals[k], normals[other])), normals[k] @ normals[other])
                mean += 0.5 * np.linalg.norm(b - a) * turn
    volume = hull.volume + radius * hull.area + radius**2 * mean + 4 / 3 * math.pi * radius**3
    return volume, hull.area + 2 * radius * mean + 4 * math.pi * radius**2


def located(points, radius):
    """Distances of points from the surface at a radius from the hull, and its normals: from the nearest point of its triangles."""
    hull = ConvexHull(points)
    triangles = points[hull.simplices]

    def foot(p):
        best = np.full(len(p), np.inf)
        feet = np.zeros_like(p)
        for (a, b, c), normal in zip(triangles, hull.equations[:, :3]):
            candidates = []
            for u, v in ((a, b), (b, c), (c, a)):
                x = np.clip((p - u) @ (v - u) / ((v - u) @ (v - u)), 0, 1)
                candidates.append(u + np.outer(x, v - u))
            inside = p - np.outer((p - a) @ normal, normal)
            area = np.cross(b - a, c - a) @ normal
            signs = [np.cross(v - u, inside - u) @ normal * area >= 0 for u, v in ((a, b), (b, c), (c, a))]
            candidates.append(np.where(np.all(signs, axis=0)[:, None], inside, candidates[0]))
            for candidate in candidates:
                distance = np.linalg.norm(p - candidate, axis=-1)
                nearer = distance < best
                best = np.where(nearer, distance, best)
                feet[nearer] = candidate[nearer]
        return best, feet

    def locate(p):
        distance, feet = foot(p)
        return np.abs(distance - radius), (p - feet) / distance[:, None]

    return locate


@pytest.fixture
def rounded(program, tmp_path):
    def make(name):
        points, radius = {**SOLIDS, **CUT}[name]
        fields = {"type": "smooth-polyhedron", "points": points.tolist(), "radius": radius}
        (tmp_path / "p.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"p": fields}}))
        report = json.loads(program("build", tmp_path / "p.json", "-o", tmp_path / "p.step", "--step-faces", "split", "--json"))
        return StepFaces(tmp_path / "p.step"), report["objects"]["p"]

    return make


@pytest.mark.parametrize("name", SOLIDS)
def test_solids_have_the_measures_of_steiner(name, rounded):
    step, report = rounded(name)
    _, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells)) == (1, 1) and step.exactly_valid
    volume, area = steiner(*SOLIDS[name])
    for found in (report, report["polyhedron"]):
        assert found["volume"] == pytest.approx(volume, rel=1e-9)
        assert found["area"] == pytest.approx(area, rel=1e-9)
    assert_area(step, area)
    assert_volume(step, volume)
    assert normals_across_joints(users, 0) <= NORMAL_LIMIT
    assert {face.kind for face in step.faces} == {"plane", "cylinder", "b-spline"}


@pytest.mark.parametrize("name", CUT)
def test_solids_are_at_their_radius_and_cut(name, rounded):
    step, report = rounded(name)
    assert_points(step, step.size(), located(*CUT[name]))
    assert_cuts(step, report["volume"], modeling.slab, modeling.drill, judged=name == "small hull")


def test_a_large_hull_has_the_measures_of_steiner(program, tmp_path):
    points, radius = LARGE
    fields = {"type": "smooth-polyhedron", "points": points.tolist(), "radius": radius}
    (tmp_path / "p.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"p": fields}}))
    report = json.loads(program("build", tmp_path / "p.json", "-o", tmp_path / "p.obj", "--json"))["objects"]["p"]
    volume, area = steiner(points, radius)
    assert report["volume"] == pytest.approx(volume, rel=1e-9)
    assert report["area"] == pytest.approx(area, rel=1e-9)
