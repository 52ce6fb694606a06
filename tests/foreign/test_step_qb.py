"""Curves of quaternion pairs as OpenCASCADE reads them, against continued fractions of vector inversions: no quaternion, no B-spline."""

import json
import re

import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

import step_modeling as modeling
from conftest import ROOT
from step_reader import StepFile

FIVE = np.array([[0, 0, 0], [20, 30, 5], [45, 35, 20], [70, 15, 25], [80, -10, 10]], float)
LOOP = np.array([[0, 0, 0], [35, 5, 4], [50, 35, 0], [30, 60, 10], [0, 50, 20], [-25, 60, 10], [-35, 25, 5]], float)
# Of coordinates up to 100: rounding of control points of degree 7.
SAME = 1e-9


def invert(v):
    return v / (v @ v)


def inverted_change(v, change):
    """The change of the inverse of a vector."""
    return (change - 2 * (v @ change) * v / (v @ v)) / (v @ v)


def thiele(points, parameters):
    """The continued fraction through points at their parameters."""
    rows, coefficients = [np.array(p) for p in points], []
    for k in range(len(points)):
        coefficients.append(rows[k])
        for i in range(k + 1, len(points)):
            rows[i] = (parameters[i] - parameters[k]) * invert(rows[i] - rows[k])

    def at(t):
        value = coefficients[-1]
        for k in range(len(points) - 2, -1, -1):
            value = coefficients[k] + (t - parameters[k]) * invert(value)
        return value

    return at


def span(a0, v0, a1, v1):
    """The continued fraction with two conditions at each end and the middle of the invariant span."""
    d = a1 - a0
    c = (2 * (d @ v1) * d - (d @ d) * v1) / (v1 @ v1)
    h = v0 / np.linalg.norm(v0) + c / np.linalg.norm(c)
    g = np.sqrt(np.linalg.norm(v0) * np.linalg.norm(c)) * h / np.linalg.norm(h)
    middle = invert(invert(g) + invert(d))
    b1 = invert(v0)
    first = {0.5: 0.5 * invert(middle), 1.0: invert(d)}
    change1 = invert(d) + inverted_change(d, v1)
    second = {t: t * invert(first[t] - b1) for t in (0.5, 1.0)}
    w = first[1.0] - b1
    change2 = invert(w) + inverted_change(w, change1)
    b2 = second[0.5]
    w = second[1.0] - b2
    b3 = 0.5 * invert(w)
    change3 = invert(w) + 0.5 * inverted_change(w, change2)
    b4 = invert(change3)

    def at(t):
        if t == 0.0:
            return a0
        if t == 1.0:
            return a1
        value = b3 + (t - 1.0) * invert(b4)
        value = b2 + (t - 0.5) * invert(value)
        return a0 + t * invert(b1 + t * invert(value))

    return at


def chain(points, closed):
    """Spans and knots of the Möbius spline with knots by chords."""
    n = len(points)
    d = [points[(i + 1) % n] - points[i] for i in range(n if closed else n - 1)]
    h = [np.linalg.norm(v) for v in d]

    def inner(d0, d1, h0, h1):
        both = d0 + d1
        return (h0 + h1) / (h0 * h1) * ((d1 @ d1) * d0 + (d0 @ d0) * d1) / (both @ both)

    def end(d0, d1, h0, h1):
        return invert((invert(d0) - invert(d0 + d1)) / (1 / h0 - 1 / (h0 + h1)))

    v = [None] * n
    for i in range(n):
        if closed or 0 < i < n - 1:
            v[i] = inner(d[i - 1], d[i], h[i - 1], h[i])
    if not closed:
        v[0] = end(d[0], d[1], h[0], h[1])
        v[-1] = -end(-d[-1], -d[-2], h[-1], h[-2])
    spans = [span(points[i], v[i] * h[i], points[(i + 1) % n], v[(i + 1) % n] * h[i]) for i in range(len(d))]
    knots = np.r_[0.0, np.cumsum(h)]

    def at(t):
        u = t * knots[-1]
        i = min(int(np.searchsorted(knots, u, side="right")) - 1, len(spans) - 1)
        return spans[i]((u - knots[i]) / h[i])

    return at


def by_chords(points):
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    return np.r_[0.0, np.cumsum(steps)] / steps.sum()


def inversion(center, radius):
    return lambda p: center + radius**2 * invert(p - center)


CENTER = np.array([20.0, 25.0, -60.0])
INVERT = {"type": "transform", "of": "curve", "steps": [{"inversion": {"center": CENTER.tolist(), "radius": 70}}]}
THROUGH = {"type": "qb-interpolation", "points": FIVE.tolist()}
CURVES = {
    "by chords": ({**THROUGH, "parameters": "chord"}, thiele(FIVE, by_chords(FIVE))),
    "even": ({**THROUGH, "parameters": "uniform"}, thiele(FIVE, np.linspace(0, 1, 5))),
    "open": ({"type": "moebius-spline", "points": LOOP.tolist()}, chain(LOOP, False)),
    "closed": ({"type": "moebius-spline", "points": LOOP.tolist(), "closed": True}, chain(LOOP, True)),
}


def edges(program, folder, objects):
    (folder / "m.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", folder / "m.json", "-o", folder / "m.step", "--step-faces", "split")
    reader = STEPControl_Reader()
    with modeling.quiet():
        reader.ReadFile(str(folder / "m.step"))
        reader.TransferRoots()
    shape = reader.OneShape()
    assert modeling.valid(shape)
    search, found = TopExp_Explorer(shape, TopAbs_EDGE), []
    while search.More():
        found.append(BRep_Tool.Curve_s(TopoDS.Edge(search.Current()), 0.0, 1.0))
        search.Next()
    return found


@pytest.mark.parametrize("inverted", [False, True])
@pytest.mark.parametrize("name", CURVES)
def test_points_are_those_of_the_continued_fraction(name, inverted, program, tmp_path):
    spec, at = CURVES[name]
    objects = {"curve": {**spec, "construction": inverted}}
    image = inversion(CENTER, 70.0) if inverted else lambda p: p
    if inverted:
        objects["image"] = INVERT
    [found] = edges(program, tmp_path, objects)
    line = found[0] if isinstance(found, tuple) else found
    first, last = line.FirstParameter(), line.LastParameter()
    for t in np.linspace(0.0, 1.0, 1001):
        p = line.Value(first + float(t) * (last - first))
        want = image(at(float(t)))
        assert np.linalg.norm(np.array([p.X(), p.Y(), p.Z()]) - want) < SAME, f"{name} at {t}"


def track(count=400):
    """A closed track with an elevation profile, metres."""
    a = np.arange(count) * (2 * np.pi / count)
    r = 700 + 150 * np.cos(3 * a) + 20 * np.sin(17 * a)
    return np.stack([r * np.cos(a), r * np.sin(a), 20 * np.sin(a) + 5 * np.cos(9 * a)], axis=1)


@pytest.mark.parametrize(
    "fields",
    [
        {"type": "circle-spline", "order": 1, "variant": "rational"},
        {"type": "circle-spline", "variant": "rational"},
        {"type": "moebius-spline"},
        {"type": "moebius-spline", "continuity": "g1"},
    ],
    ids=lambda fields: "-".join(map(str, fields.values())),
)
def test_a_closed_track_is_one_closed_smooth_b_spline(program, tmp_path, fields):
    points = track()
    np.savetxt(tmp_path / "track.csv", points, fmt="%.17g", delimiter=",", header="x,y,z", comments="")
    objects = {"track": {**fields, "points": {"csv": "track.csv"}, "closed": True}}
    (tmp_path / "t.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", tmp_path / "t.json", "-o", tmp_path / "t.step", "--step-faces", "split")
    text = (tmp_path / "t.step").read_text()
    assert text.count("B_SPLINE_CURVE_WITH_KNOTS(") == 1
    # The closed flag of the file.
    assert re.search(r"B_SPLINE_CURVE\s*\(\s*\d+\s*,\s*\([^)]*\)\s*,\s*\.UNSPECIFIED\.\s*,\s*\.T\.", text)
    (wire,) = StepFile(tmp_path / "t.step").wires
    (edge,) = wire.edges
    curve = edge.curve.BSpline()
    assert curve.IsClosed() and edge.is_c1()
    # C1 knots at every point: nowhere the multiplicity of a corner.
    inner = [curve.Multiplicity(i) for i in range(2, curve.NbKnots())]
    assert len(inner) == len(points) - 1 and set(inner) == {curve.Degree() - 1}
    at_knots = [curve.Value(curve.Knot(i)) for i in range(1, curve.NbKnots())]
    at_knots = np.array([[p.X(), p.Y(), p.Z()] for p in at_knots])
    assert np.linalg.norm(at_knots - points, axis=1).max() < 1e-9


def distances(first, last):
    return np.linalg.norm(np.asarray(first) - last, axis=1)


def as_rows(curve, parameters):
    points = [curve.Value(float(u)) for u in parameters]
    return np.array([[p.X(), p.Y(), p.Z()] for p in points]) / 1000  # of metres


HILLS = ROOT / "examples" / "track3d.csv"
# Points that are pushed aside, and marked.
CORNERS = [10, 40]


@pytest.mark.parametrize("corners", [[], CORNERS[:1], CORNERS], ids=["smooth", "one corner", "two corners"])
def test_the_track_with_hills_is_one_b_spline_from_corner_to_corner(program, tmp_path, corners):
    """A curve of degree d is C1 at a knot of multiplicity d - 1: no knot has the multiplicity d of a corner; at corners one B-spline ends and the next begins."""
    points = np.loadtxt(HILLS, delimiter=",", skiprows=1)
    for i in corners:
        aside = points[i] - (points[i - 1] + points[i + 1]) / 2
        points[i] += 25 * aside / np.linalg.norm(aside)
    rows = np.c_[points, np.isin(np.arange(len(points)), corners)]
    np.savetxt(tmp_path / "hills.csv", rows, fmt="%.17g", delimiter=",", header="x_m,y_m,z_m,corner", comments="")
    step = tmp_path / "hills.step"
    options = ("--kind", "moebius-spline", "--closed", "--units", "m", "-o", step)
    program("curve", tmp_path / "hills.csv", *options)
    (wire,) = StepFile(step).wires
    assert wire.closed and len(wire.edges) == max(1, len(corners))
    start = corners[0] if corners else 0
    ends = [*corners, start + len(points)] if corners else [0, len(points)]
    runs = [np.take(points, range(a, b + 1), axis=0, mode="wrap") for a, b in zip(ends, ends[1:])]
    for run in runs:
        # A chain without corners is closed, its first point not repeated.
        expected = chain(run, False) if corners else chain(points, True)
        knots = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(run, axis=0), axis=1))]
        gaps = []
        for edge in wire.edges:
            curve = edge.curve.BSpline()
            gaps.append((np.linalg.norm(as_rows(curve, [curve.FirstParameter()])[0] - run[0]), curve, edge))
        _, curve, edge = min(gaps, key=lambda gap: gap[0])
        assert edge.is_c1() and curve.IsClosed() == (len(corners) < 2)
        assert curve.Degree() == 7 and curve.NbKnots() == len(run)
        assert {curve.Multiplicity(i) for i in range(2, curve.NbKnots())} == {curve.Degree() - 1}
        assert distances(as_rows(curve, [curve.Knot(i) for i in range(1, len(run) + 1)]), run).max() < 1e-9
        # Of 700 m: 16 places of every span.
        places = np.linspace(0.0, 1.0, 16 * len(knots))
        first, last = curve.FirstParameter(), curve.LastParameter()
        read = as_rows(curve, first + places * (last - first))
        assert distances(read, [expected(t) for t in places]).max() < 1e-9
