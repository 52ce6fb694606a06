"""JSON of the exact B-splines evaluated by SciPy, and CSV samples, against the quaternion form."""

import csv
import json

import numpy as np
import pytest
from scipy.interpolate import BSpline

# Of the model's size: the rounding of the coordinates and of de Boor's recurrence at degree up to 21.
EXACT_LIMIT = 1e-12


def evaluate(curve, count):
    """Points of a rational B-spline at equal parameter steps, by SciPy on the homogeneous control points."""
    weights = np.array(curve["weights"])
    rows = np.column_stack([np.array(curve["control_points"]) * weights[:, None], weights])
    spline = BSpline(np.array(curve["knots"]), rows, curve["degree"])
    low, high = curve["knots"][0], curve["knots"][-1]
    values = spline(np.linspace(low, high, count))
    return values[:, :3] / values[:, 3:]


def test_exact_b_splines_are_the_quaternion_form(built):
    document = json.loads(built.file("json").read_text())
    assert document["cyclide-nurbs"] == 1
    assert document["units"] == built.units
    assert list(document["objects"]) == list(built.objects)
    for name, index, curve, points in built.contours():
        contour = document["objects"][name]["contours"][index]
        assert document["objects"][name]["type"] == built.objects[name].kind
        for part in contour["curves"]:
            assert min(part["weights"]) > 0.0
            assert len(part["knots"]) == len(part["control_points"]) + part["degree"] + 1
        read = np.vstack([evaluate(part, 40 * len(part["knots"]) + 1) for part in contour["curves"]])
        if curve is None:  # an arc fit: its points must be near
            limit = built.objects[name].spec["tolerance"] + step_length(read)
            gaps = [np.linalg.norm(read - p, axis=1).min() for p in points]
            assert max(gaps) <= limit, name
            continue
        assert contour["closed"] == curve.closed
        trigonometric = built.objects[name].spec.get("variant") == "trigonometric"
        assert contour["exact"] == (not trigonometric)
        limit = EXACT_LIMIT * curve.extent() + contour["bound"]
        # Far from the origin the coordinates themselves are rounded.
        limit += 8 * np.finfo(float).eps * np.abs(read).max()
        worst = curve.distances(read).max()
        assert worst <= limit, f"{name}: {worst:.3g}, limit {limit:.3g}"
        joined = contour["curves"]
        for a, b in zip(joined, joined[1:] + (joined[:1] if curve.closed else [])):
            assert a["control_points"][-1] == b["control_points"][0], f"{name}: curves do not meet to the bit"
        # Both ends, and nothing left out: the polygon of the points has nearly the curve's length.
        assert np.linalg.norm(np.diff(read, axis=0), axis=1).sum() == pytest.approx(curve.length(), rel=2e-3), name


def step_length(points):
    return np.linalg.norm(np.diff(points, axis=0), axis=1).max()


def test_csv_rows_are_points_of_the_curves(built):
    rows = list(csv.DictReader(built.file("csv").read_text().splitlines()))
    for name, index, curve, _ in built.contours():
        if curve is None:
            continue
        own = [row for row in rows if row["object"] == name and int(row["contour"]) == index]
        assert len(own) >= 2
        points = np.array([[float(row[k]) for k in "xyz"] for row in own])
        size = curve.extent() + 1e3 * np.finfo(float).eps * np.abs(points).max()
        assert curve.distances(points).max() <= EXACT_LIMIT * size + 8 * np.finfo(float).eps * np.abs(points).max()
        if curve.closed:
            assert (points[0] == points[-1]).all()


@pytest.mark.parametrize("name, object_name", [("track", "centre line"), ("cable", "cable"), ("cable", "arcs")])
def test_samples_are_the_quaternion_form(examples, program, name, object_name):
    built = examples[name]
    text = program("sample", built.document, "--object", object_name, "--count", 257)
    rows = list(csv.DictReader(text.splitlines()))
    assert len(rows) == 257
    curve = built.objects[object_name].curves[0]
    points = np.array([[float(row[k]) for k in "xyz"] for row in rows])
    assert curve.distances(points).max() <= EXACT_LIMIT * curve.extent()
    tangents = np.array([[float(row[k]) for k in ("tangent_x", "tangent_y", "tangent_z")] for row in rows])
    assert np.abs(np.linalg.norm(tangents, axis=1) - 1.0).max() < 1e-14
    # Along the curve: the chord to the next sample leaves in the direction of the tangent.
    chords = np.diff(points, axis=0)
    cosines = np.sum(chords * tangents[:-1], axis=1) / np.linalg.norm(chords, axis=1)
    assert cosines.min() > 0.8
