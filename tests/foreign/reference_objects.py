"""The reference curves of every object of a model document, from the document and its point lists alone."""

import functools
import json
from pathlib import Path

import numpy as np

import quaternion_form as form

MILLIMETRES = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, "ft": 304.8}


class Reference:
    """The contours of one object; `curves` is None where the data do not determine the curve (an arc fit)."""

    def __init__(self, kind, spec, points, corners, curves):
        self.kind, self.spec, self.points, self.corners, self.curves = kind, spec, points, corners, curves


def read_contours(path, columns):
    """(points, indices of corners) for every contour of a CSV file; contours are separated by blank lines."""
    rows = Path(path).read_text().splitlines()
    names = [name.strip(" #") for name in rows[0].split(",")]
    where = [names.index(column) for column in columns]
    corner = names.index("corner") if "corner" in names else None
    contours = [([], [])]
    for row in rows[1:]:
        if not row.strip():
            contours.append(([], []))
            continue
        fields = row.split(",")
        points, corners = contours[-1]
        if corner is not None and fields[corner] == "1":
            corners.append(len(points))
        points.append(_space([float(fields[i]) for i in where]))
    return [(np.array(points), corners) for points, corners in contours if points]


@functools.cache
def load(document_path):
    """Units and {name: Reference} of a document; the equations of fair curves are solved once."""
    path = Path(document_path)
    document = json.loads(path.read_text())
    objects = {name: _object(spec, path.parent) for name, spec in document["objects"].items()}
    return document.get("units", "mm"), objects


def _contours(spec, folder):
    points = spec["points"]
    if isinstance(points, dict):
        contours = read_contours(folder / points["csv"], points["columns"])
    else:
        contours = [(np.array([_space(p) for p in points], float), [])]
    if "corner_angle" in spec:
        for points, corners in contours:
            turns = form.turn_angles(points, spec.get("closed", False))
            corners[:] = sorted({*corners, *np.flatnonzero(turns > spec["corner_angle"]).tolist()})
    return contours


def _object(spec, folder):
    kind = spec["type"]
    single = {"arc": _arc, "circle": _circle, "biarc": _biarc}
    if kind in single:
        return Reference(kind, spec, None, [[]], [single[kind](spec)])
    points, corners = map(list, zip(*_contours(spec, folder)))
    if kind == "arc-fit":
        return Reference(kind, spec, points, corners, None)
    build = {"arc-spline": _arc_spline, "circle-spline": _circle_spline, "fair-spline": _fair_spline}[kind]
    return Reference(kind, spec, points, corners, [build(spec, p, c) for p, c in zip(points, corners)])


def _space(point):
    return [*point, 0.0][:3]


def _arc(spec):
    if "through" in spec:
        return form.Curve([form.Arc.through(*map(_space, spec["through"]))], False)
    a0, a1 = _space(spec["from"]), _space(spec["to"])
    if "tangent" in spec:
        arc = form.Arc.start_tangent(a0, a1, _space(spec["tangent"]))
    elif "end_tangent" in spec:
        arc = form.Arc.end_tangent(a0, a1, _space(spec["end_tangent"]))
    elif "weights" in spec:
        arc = form.Arc(a0, a1, *spec["weights"])
    else:
        arc = form.Arc.bulge(a0, a1, spec["bulge"], spec.get("normal", [0, 0, 1]))
    return form.Curve([arc], False)


def _circle(spec):
    return form.circle(_space(spec["center"]), spec.get("normal", [0, 0, 1]), spec["radius"])


def _biarc(spec):
    ends = [_space(spec[key]) for key in ("from", "from_tangent", "to", "to_tangent")]
    return form.Curve(form.biarc(*ends, spec.get("rule", "equal-d")), False)


def _arc_spline(spec, points, _corners):
    tangents = [form.unit(_space(t)) for t in spec["tangents"]] if "tangents" in spec else None
    return form.arc_spline(points, spec.get("closed", False), tangents, spec.get("rule", "equal-d"))


def _circle_spline(spec, points, corners):
    closed, order, variant = spec.get("closed", False), spec.get("order", 2), spec.get("variant", "rational")
    if corners:
        return form.circle_spline_with_corners(points, closed, corners, order, variant)
    ends = spec.get("ends", "natural")
    clamped = ends if isinstance(ends, dict) else {}
    start, end = (_space(clamped[k]) if k in clamped else None for k in ("start", "end"))
    return form.circle_spline(points, closed, order, variant, start, end)


def _fair_spline(spec, points, corners):
    assert "tight" not in spec, "tight corners have no reference here"
    closed, tension, straight = spec.get("closed", False), spec.get("tension", 0.0), spec.get("straight", "auto")
    if corners:
        return form.fair_spline_with_corners(points, closed, sorted(corners), tension, straight)
    given = spec.get("ends", "circle")
    ends = [given, given] if isinstance(given, str) else [given.get(k, "circle") for k in ("start", "end")]
    return form.fair_spline(points, closed, tension, straight, [e if isinstance(e, str) else _space(e) for e in ends])


def reported_area(objects):
    """Area of objects of a report. A thick shell has one for each of its skins and rims, and none for all."""
    # Of a block the parts are a number: those of its exact form with positive weights.
    def parts(entry):
        given = entry.get("parts")
        return given if isinstance(given, list) else [entry]

    return sum(part["area"] for entry in objects for part in parts(entry))
