"""Curves cut by stations and run backwards, as OpenCASCADE reads them: the part has the length asked for and lies where the whole one
has it, by OpenCASCADE's own lengths along the whole one."""

import json

import numpy as np
import pytest

from step_reader import StepFile

LOOP = [[0, 0, 0], [35, 5, 4], [50, 35, 0], [30, 60, 10], [0, 50, 20], [-25, 60, 10]]
CURVES = {
    "circle": {"type": "circle", "center": [3, 2], "radius": 30},
    "arc spline": {"type": "arc-spline", "points": [p[:2] for p in LOOP]},
    "fair spline": {"type": "fair-spline", "points": LOOP, "closed": True},
    "circle spline": {"type": "circle-spline", "points": LOOP, "closed": True},
    "moebius spline": {"type": "moebius-spline", "points": LOOP, "closed": True},
    "torus knot": {"type": "torus-knot", "torus": {"major_radius": 30, "minor_radius": 10}, "turns": [2, 3]},
    "nurbs": {"type": "nurbs", "degree": 3, "control_points": LOOP, "knots": [0, 0, 0, 0, 1, 3, 4, 4, 4, 4], "weights": [1, 2, 1, 0.5, 1, 1]},
}


@pytest.mark.parametrize("name", CURVES)
def test_parts_have_their_stations(name, program, tmp_path):
    objects = {"whole": CURVES[name]}
    (tmp_path / "whole.json").write_text(json.dumps({"cyclide": 1, "objects": objects}))
    program("build", tmp_path / "whole.json", "-o", tmp_path / "whole.step", "--step-faces", "split")
    (whole,) = StepFile(tmp_path / "whole.step").wires
    length = whole.length()
    # Inside, and past the start of closed ones.
    for a, b in [(0.21, 0.64)] + ([(0.83, 0.17)] if whole.closed else []):
        steps = [{"cut": {"stations": [a * length, b * length]}}, "reverse"]
        objects["part"] = {"type": "transform", "of": "whole", "steps": steps}
        objects["whole"] = {**CURVES[name], "construction": True}
        (tmp_path / "part.json").write_text(json.dumps({"cyclide": 1, "objects": objects}))
        program("build", tmp_path / "part.json", "-o", tmp_path / "part.step", "--step-faces", "split")
        file = StepFile(tmp_path / "part.step")
        (part,) = file.wires
        assert file.valid and not part.closed
        # Stations are found to 1e-12 of the length, and lengths by quadrature to less.
        assert part.length() == pytest.approx((b - a) % 1.0 * length, rel=1e-9)
        points = part.points(2)
        for station, place in ((b, points[0]), (a, points[-1])):
            assert np.linalg.norm(at(whole, station * length) - place) <= 1e-8 * length


def at(wire, station):
    """The point of a wire at a station, by bisection of the length of its edges."""
    for edge in wire.edges:
        length = edge.length()
        if station <= length:
            break
        station -= length
    low, high = (edge.last, edge.first) if edge.reversed else (edge.first, edge.last)
    start = low
    for _ in range(45):
        middle = 0.5 * (low + high)
        if between(edge, start, middle) < station:
            low = middle
        else:
            high = middle
    p = edge.curve.Value(low)
    return np.array([p.X(), p.Y(), p.Z()])


def between(edge, a, b):
    """The length from one parameter to another."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    a, b = min(a, b), max(a, b)
    knots = edge.knots()
    places = np.r_[a, knots[(knots > a) & (knots < b)], b]
    total = 0.0
    for low, high in zip(places, places[1:]):
        for s, e in zip(np.linspace(low, high, 9)[:-1], np.linspace(low, high, 9)[1:]):
            total += 0.5 * (e - s) * sum(w * edge.speed(0.5 * (s + e) + 0.5 * (e - s) * x) for x, w in zip(nodes, weights))
    return total
