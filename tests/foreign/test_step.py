"""STEP files read by OpenCASCADE, against the quaternion form of the input data."""

import math

import numpy as np
import pytest

import quaternion_form as form
from step_reader import StepFile

POINTS_PER_EDGE = 200
# Of the model's size: a few roundings of the file's coordinates and of the reader's evaluation, with a wide margin.
POINT_LIMIT = 1e-9
LENGTH_LIMIT = 1e-9


@pytest.fixture(scope="module")
def step(built):
    return StepFile(built.file("step"))


def wire_of(step, curve, scale):
    """The wire that runs along this reference curve."""
    if curve not in step.found:
        gaps = [curve.gap(wire.points(3)[:60] / scale) for wire in step.wires]
        step.found[curve] = step.wires[int(np.argmin(gaps))]
    return step.found[curve]


def determined(built):
    """Contours whose curve follows from the input data."""
    return [(name, i, curve) for name, i, curve, _ in built.contours() if curve is not None]


def is_exact(built, name):
    return built.objects[name].spec.get("variant", "rational") != "trigonometric"


def test_one_valid_wire_per_connected_curve(built, step):
    contours = list(built.contours())
    assert step.valid
    assert len(step.wires) == len(contours)
    assert all(wire.edge_count == len(wire.edges) for wire in step.wires), "a wire is not traversed as a whole"
    assert step.edge_count == sum(len(wire.edges) for wire in step.wires), "edges outside of wires"
    closed = [bool(built.objects[name].spec.get("closed", built.objects[name].kind == "circle")) for name, *_ in contours]
    assert sorted(wire.closed for wire in step.wires) == sorted(closed)
    for name, _, curve in determined(built):
        assert wire_of(step, curve, built.in_millimetres).closed == curve.closed, name


def test_edges_meet_within_the_file_tolerance(built, step):
    # OpenCASCADE widens the tolerance of an edge whose ends do not meet its vertices; 1e-7 mm is its floor.
    assert max(edge.tolerance for wire in step.wires for edge in wire.edges) <= 1e-7


def test_points_lie_on_the_quaternion_form(built, step):
    for name, _, curve in determined(built):
        points = wire_of(step, curve, built.in_millimetres).points(POINTS_PER_EDGE) / built.in_millimetres
        size = curve.extent()
        limit = POINT_LIMIT * size + (0.0 if is_exact(built, name) else built.file_report("step")["bound"])
        worst = curve.distances(points).max()
        assert worst <= limit, f"{name}: {worst:.3g} off, limit {limit:.3g}"


def test_length_is_that_of_the_quaternion_form(built, step):
    lengths = {name: entry["length"] for name, entry in built.report()["objects"].items()}
    expected = dict.fromkeys(lengths, 0.0)
    for name, _, curve in determined(built):
        length = curve.length()
        expected[name] += length
        if is_exact(built, name):
            read = wire_of(step, curve, built.in_millimetres).length() / built.in_millimetres
            assert read == pytest.approx(length, rel=LENGTH_LIMIT), name
    for name, _, _ in determined(built):
        assert lengths[name] == pytest.approx(expected[name], rel=LENGTH_LIMIT), name


def test_a_smooth_rational_spline_is_one_c1_edge(built, step):
    for name, i, curve in determined(built):
        if built.objects[name].kind not in ("circle-spline", "fair-spline") or not is_exact(built, name):
            continue
        edges = wire_of(step, curve, built.in_millimetres).edges
        corners = built.objects[name].corners[i]
        splines = sum(not is_arcs(run) for run in smooth_runs(curve, corners))
        assert sum(edge.kind == "b-spline" for edge in edges) == splines, name
        assert {edge.kind for edge in edges} <= {"b-spline", "circle", "line"}, name
        assert all(edge.is_c1() for edge in edges), f"{name}: an edge is only {min(e.curve.Continuity() for e in edges)}"


def smooth_runs(curve, corners):
    """The pieces between corners, as lists."""
    n = len(curve)
    if not corners:
        return [curve.pieces]
    cuts = [*corners, corners[0] + n] if curve.closed else [0, *corners, n]
    return [[curve.pieces[k % n] for k in range(a, b)] for a, b in zip(cuts, cuts[1:])]


def is_arcs(run):
    """A run that consists of arcs and segments as it stands: they are written as such."""
    return all(isinstance(piece, form.Arc) or piece.theta < 1e-9 for piece in run)


def test_arcs_are_circles_and_lines(built, step):
    for name, _, curve in determined(built):
        if not all(isinstance(piece, form.Arc) for piece in curve.pieces):
            continue
        wire = wire_of(step, curve, built.in_millimetres)
        assert {edge.kind for edge in wire.edges} <= {"circle", "line"}, name
        read = [edge.curve.Circle().Radius() / built.in_millimetres for edge in wire.edges if edge.kind == "circle"]
        expected = [piece.radius() for piece in curve.pieces if math.isfinite(piece.radius())]
        for radius in read:
            assert min(abs(radius / e - 1.0) for e in expected) < 1e-9, name
        for radius in expected:
            assert min(abs(radius / r - 1.0) for r in read) < 1e-9, name


def test_fitted_arcs_hold_their_tolerance_and_their_tangents(built, step):
    """An arc fit is not determined by its points: here the reader's own circles must pass them all, tangent at joints."""
    arc_wires = [w for w in step.wires if {edge.kind for edge in w.edges} <= {"circle", "line"}]
    curves = [(w, form.Curve([edge_arc(e, built.in_millimetres) for e in w.edges], w.closed)) for w in arc_wires]
    for name, _, determined_curve, points in built.contours():
        if determined_curve is not None:
            continue
        spec = built.objects[name].spec
        worst, wire, curve = min(((c.distances(points).max(), w, c) for w, c in curves), key=lambda found: found[0])
        assert wire.closed == spec.get("closed", False)
        assert worst <= spec["tolerance"] * (1 + 1e-9), f"{name}: a point is {worst} off"
        arcs = curve.pieces
        kinks = [kink(a, b) for a, b in zip(arcs, arcs[1:] + arcs[:1] if wire.closed else arcs[1:])]
        corners = sum(form.turn_angles(points, wire.closed) > math.pi / 6)
        assert sum(k > 1e-8 for k in kinks) == corners, f"{name}: kinks {sorted(kinks)[-3:]}"


def edge_arc(edge, scale):
    """The edge as an arc through three points of it, in document units."""
    a, b, c = edge.points(3) / scale
    return form.Arc.segment(a, c) if edge.kind == "line" else form.Arc.through(a, b, c)


def kink(a, b):
    u, v = form.unit(a.derivative(np.array(1.0))), form.unit(b.derivative(np.array(0.0)))
    return 2.0 * math.atan2(math.hypot(*(u - v)), math.hypot(*(u + v)))
