"""NURBS curves and frames against SciPy, and the files of NURBS curves as OpenCASCADE reads them."""

import csv
import io
import json

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS
from scipy.integrate import solve_ivp
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

import step_modeling as modeling

CURVE = {
    "type": "nurbs",
    "degree": 3,
    "knots": [0, 0, 0, 0, 0.4, 0.4, 0.7, 1, 1, 1, 1],
    "control_points": [[0, 0, 0], [8, 24, 5], [30, 34, 12], [55, 20, 0], [78, 8, -9], [90, 20, 3], [100, 0, 8]],
    "weights": [1, 1, 1.6, 1, 0.8, 1.2, 1],
}
UNCLAMPED = {
    "type": "nurbs",
    "degree": 3,
    "knots": [0, 1, 2, 3.5, 4, 5, 6, 7, 8, 9, 10.5, 11],
    "control_points": CURVE["control_points"] + [[110, 5, 0]],
}
CENTER, RADIUS = np.array([40.0, -20.0, 10.0]), 30.0
IMAGE = {"type": "transform", "of": "curve", "steps": [{"inversion": {"center": CENTER.tolist(), "radius": RADIUS}}]}


def homogeneous(spec):
    points = np.array(spec["control_points"], float)
    weights = np.array(spec.get("weights", np.ones(len(points))), float)[:, None]
    return BSpline(np.array(spec["knots"], float), np.hstack([points * weights, weights]), spec["degree"])


def domain(spec):
    return spec["knots"][spec["degree"]], spec["knots"][-spec["degree"] - 1]


def points_by_scipy(spec, u):
    rows = homogeneous(spec)(u)
    return rows[:, :3] / rows[:, 3:]


def jet_by_scipy(spec, u):
    """Point, first and second derivative by the quotient rule."""
    spline = homogeneous(spec)
    rows = [spline(u, k) for k in range(3)]
    a, w = [r[..., :3] for r in rows], [r[..., 3:] for r in rows]
    x = a[0] / w[0]
    x1 = (a[1] - x * w[1]) / w[0]
    return x, x1, (a[2] - 2.0 * x1 * w[1] - x * w[2]) / w[0]


def inverted(points):
    away = points - CENTER
    return CENTER + RADIUS**2 * away / np.sum(away * away, axis=1, keepdims=True)


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    path = tmp_path_factory.mktemp("nurbs") / "n.json"
    objects = {"curve": CURVE, "unclamped": UNCLAMPED, "image": IMAGE}
    path.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    return path


def samples(program, model, *options):
    return list(csv.DictReader(io.StringIO(program("sample", model, *options))))


def vector(row, *names):
    return np.array([float(row[name]) for name in names])


@pytest.mark.parametrize("name, spec", [("curve", CURVE), ("unclamped", UNCLAMPED)])
def test_points_and_curvatures_are_those_of_scipy(program, model, name, spec):
    rows = samples(program, model, "--object", name, "--count", "361")
    first, last = domain(spec)
    breaks = np.unique([k for k in spec["knots"] if first <= k <= last])
    # The parameter of the program runs evenly over the spans.
    t = np.array([float(row["t"]) for row in rows]) * (len(breaks) - 1)
    span = np.minimum(t.astype(int), len(breaks) - 2)
    u = breaks[span] + (t - span) * np.diff(breaks)[span]
    x, d1, d2 = jet_by_scipy(spec, u)
    ours = np.array([vector(row, "x", "y", "z") for row in rows])
    assert np.abs(ours - x).max() < 1e-12
    speed = np.linalg.norm(d1, axis=1)
    curvature = np.linalg.norm(np.cross(d1, d2), axis=1) / speed**3
    inner = np.abs(t - np.round(t)) > 1e-9  # at a knot SciPy may take the other side
    ours = np.array([float(row["curvature"]) for row in rows])
    assert np.abs(ours - curvature)[inner].max() < 1e-11 * curvature.max()


def test_rotation_minimizing_frames_solve_their_equation(program, model):
    """N' = -(N . T') T, integrated by SciPy from the first normal."""
    rows = samples(program, model, "--object", "unclamped", "--count", "41", "--frames", "rotation-minimizing")
    breaks = np.unique([k for k in UNCLAMPED["knots"] if 3.5 <= k <= 8])
    spans = len(breaks) - 1

    def rate(u, normal):
        _, d1, d2 = jet_by_scipy(UNCLAMPED, np.array([u]))
        d1, d2 = d1[0], d2[0]
        speed = np.linalg.norm(d1)
        tangent = d1 / speed
        turn = (d2 - tangent * (d2 @ tangent)) / speed
        return -(normal @ turn) * tangent

    normal = vector(rows[0], "normal_x", "normal_y", "normal_z")
    for before, after in zip(rows, rows[1:]):
        places = []
        for row in (before, after):
            t = float(row["t"]) * spans
            span = min(int(t), spans - 1)
            places.append(breaks[span] + (t - span) * (breaks[span + 1] - breaks[span]))
        normal = solve_ivp(rate, places, normal, rtol=1e-11, atol=1e-12).y[:, -1]
        found = vector(after, "normal_x", "normal_y", "normal_z")
        # The tolerance of the frames is 1e-9, that of the integration below it.
        assert np.linalg.norm(found - normal) < 3e-9
        tangent = vector(after, "tangent_x", "tangent_y", "tangent_z")
        binormal = vector(after, "binormal_x", "binormal_y", "binormal_z")
        assert np.linalg.norm(np.cross(tangent, found) - binormal) < 1e-14


def test_stations_are_the_integral_of_the_speed(program, model):
    rows = samples(program, model, "--object", "curve", "--step", "10")
    dense = np.linspace(0, 1, 400_001)
    x = points_by_scipy(CURVE, dense)
    sums = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(x, axis=0), axis=1))])
    tree = cKDTree(x)
    for i, row in enumerate(rows):
        station = float(row["station"])
        if i + 1 < len(rows):
            assert abs(station - 10 * i) < 1e-10
        _, at = tree.query(vector(row, "x", "y", "z"))
        # Samples are 4e-4 apart at most.
        assert abs(sums[at] - station) < 5e-4


def read_edges(path):
    reader = STEPControl_Reader()
    with modeling.quiet():
        reader.ReadFile(str(path))
        reader.TransferRoots()
    search = TopExp_Explorer(reader.OneShape(), TopAbs_EDGE)
    edges = []
    while search.More():
        edge = TopoDS.Edge(search.Current())
        found = BRep_Tool.Curve_s(edge, 0.0, 1.0)
        edges.append(found if isinstance(found, tuple) else (found, *BRep_Tool.Range_s(edge)))
        search.Next()
    return edges


def test_opencascade_reads_the_curve_and_its_image(program, model):
    path = model.parent / "n.step"
    report = json.loads(program("build", model, "-o", path, "--json"))
    assert report["files"][0]["exact"] is True
    dense = points_by_scipy(CURVE, np.linspace(0, 1, 200_001))
    unclamped = points_by_scipy(UNCLAMPED, np.linspace(3.5, 8, 200_001))
    expected = {"curve": dense, "unclamped": unclamped, "image": inverted(dense)}
    trees = {name: (cKDTree(points), points) for name, points in expected.items()}
    edges = read_edges(path)
    assert len(edges) == 3
    seen = set()
    for curve, first, last in edges:
        found = [curve.Value(float(u)) for u in np.linspace(first, last, 401)]
        found = np.array([[p.X(), p.Y(), p.Z()] for p in found])
        distances = {name: tree.query(found)[0].max() for name, (tree, _) in trees.items()}
        name = min(distances, key=distances.get)
        seen.add(name)
        points = trees[name][1]
        # To the nearest chord of the dense samples: their sagitta is below 1e-9.
        _, at = trees[name][0].query(found)
        near = [min(chord_distance(p, points, i - 1), chord_distance(p, points, i)) for p, i in zip(found, at)]
        assert max(near) < 1e-9, name
    assert seen == set(expected)


def chord_distance(p, points, i):
    if not 0 <= i < len(points) - 1:
        return np.inf
    a, b = points[i], points[i + 1]
    chord = b - a
    s = np.clip((p - a) @ chord / (chord @ chord), 0, 1)
    return np.linalg.norm(p - a - s * chord)
