"""DXF files read by ezdxf, and the rules that its audit does not know."""

import math

import ezdxf
import numpy as np
import pytest
from ezdxf.math import OCS

import quaternion_form as form

TOLERANCE = 1e-3


@pytest.fixture(scope="module")
def drawing(built):
    return ezdxf.readfile(built.file("dxf", "--tolerance", TOLERANCE))


def polyline_curve(entity):
    """An LWPOLYLINE in world coordinates as quaternion arcs: plane arcs by bulge, then the reader's own frame."""
    ocs = OCS(entity.dxf.extrusion)
    z = entity.dxf.elevation
    vertices = list(entity.get_points("xyb"))
    n = len(vertices)
    pieces = []
    for k in range(n if entity.closed else n - 1):
        (x0, y0, bulge), (x1, y1, _) = vertices[k], vertices[(k + 1) % n]
        flat = form.Arc.bulge([x0, y0, z], [x1, y1, z], bulge)
        middle = flat.point(np.array(0.5))
        a, b, c = (np.array(ocs.to_wcs(tuple(map(float, p)))) for p in (flat.a0, middle, flat.a1))
        pieces.append(form.Arc.segment(a, c) if bulge == 0.0 else form.Arc.through(a, b, c))
    return form.Curve(pieces, entity.closed)


def is_planar(points):
    """One LWPOLYLINE holds the curve: it lies in a plane, and if it is straight, in a level one."""
    x = points - points.mean(axis=0)
    values = np.linalg.svd(x, compute_uv=False)
    straight = values[1] <= 1e-9 * values[0]
    return values[2] <= 1e-9 * values[0] and not (straight and np.ptp(points[:, 2]) > 0.0)


def planar_contours(built):
    """Contours that lie in a plane: those become one LWPOLYLINE each."""
    for name, _, curve, points in built.contours():
        if is_planar(points if curve is None else curve.sample(8)[1]):
            yield name, curve, points


def test_audit_finds_and_fixes_nothing(drawing):
    audit = drawing.audit()
    assert [str(e.message) for e in audit.errors] == []
    assert [str(f.message) for f in audit.fixes] == []


def test_units_are_labeled(built, drawing):
    codes = {"in": 1, "ft": 2, "mm": 4, "cm": 5, "m": 6}
    assert drawing.header["$INSUNITS"] == codes[built.units]
    assert drawing.header["$ACADVER"] == "AC1015"


def test_planar_curves_are_polylines_within_the_tolerance(built, drawing):
    contours = list(planar_contours(built))
    polylines = [(e, polyline_curve(e)) for e in drawing.modelspace().query("LWPOLYLINE")]
    assert len(polylines) == len(contours)
    for name, curve, points in contours:
        if curve is None:
            limit = built.objects[name].spec["tolerance"] * (1 + 1e-9)
            assert min(c.distances(points).max() for _, c in polylines) <= limit, name
            continue
        _, samples = curve.sample(32)
        entity, read = min(polylines, key=lambda p: p[1].gap(samples[::16]))
        exact = all(isinstance(piece, form.Arc) for piece in curve.pieces)
        limit = 1e-9 * curve.extent() + (0.0 if exact else TOLERANCE)
        assert read.distances(samples).max() <= limit, name
        _, back = read.sample(16)
        assert curve.distances(back).max() <= limit, name
        assert entity.closed == curve.closed, name
        # Two curves within T of each other with tangents within a may differ in length by a factor 1/cos(a).
        assert read.length() == pytest.approx(curve.length(), rel=1e-9 if exact else 1e-4), name
        if not exact:
            ends = zip(read.pieces, read.pieces[1:] + (read.pieces[:1] if read.closed else []))
            corners = sum(kink(a, b) > 1e-7 for a, b in ends)
            assert corners == corner_count(built, name, curve), f"{name}: a joint is not tangent"


def corner_count(built, name, curve):
    """Corners of the reference curve itself: joints of its pieces whose tangents differ."""
    pieces = curve.pieces
    return sum(kink(a, b) > 1e-7 for a, b in zip(pieces, pieces[1:] + (pieces[:1] if curve.closed else [])))


def kink(a, b):
    u, v = form.unit(a.derivative(np.array(1.0))), form.unit(b.derivative(np.array(0.0)))
    return 2.0 * math.atan2(math.hypot(*(u - v)), math.hypot(*(u + v)))


def test_curves_in_space_become_lines_and_arcs_in_order(built, drawing):
    planar = len(list(planar_contours(built)))
    entities = [e for e in drawing.modelspace() if e.dxftype() in ("LINE", "ARC")]
    assert bool(entities) == (len(list(built.contours())) > planar)
    curves = [c for _, _, c, _ in built.contours() if c is not None and not is_planar(c.sample(8)[1])]
    if not curves:
        return
    runs = [entity_points(entity) for entity in entities]
    ends = np.cumsum([len(run) for run in runs])[:-1]
    distances = np.array([curve.distances(np.vstack(runs)) for curve in curves])
    limit = TOLERANCE + 1e-9 * max(c.extent() for c in curves)
    for on_curves in np.split(distances, ends, axis=1):
        assert on_curves.max(axis=1).min() <= limit
    # Nothing is left out: the entities together are as long as the curves.
    length = sum(np.linalg.norm(np.diff(run, axis=0), axis=1).sum() for run in runs)
    assert length == pytest.approx(sum(c.length() for c in curves), rel=1e-3)


def entity_points(entity):
    if entity.dxftype() == "LINE":
        return np.array([tuple(entity.dxf.start), tuple(entity.dxf.end)])
    return np.array([tuple(v) for v in entity.flattening(1e-3 * entity.dxf.radius)])


def test_geometry_rules_that_no_audit_checks(drawing):
    layers = {layer.dxf.name for layer in drawing.layers}
    for entity in drawing.modelspace():
        assert entity.dxf.layer in layers, "undefined layer"
        if entity.dxftype() == "LWPOLYLINE":
            vertices = np.array(list(entity.get_points("xyb")))
            assert np.isfinite(vertices).all()
            assert len(vertices) >= 2
            following = np.roll(vertices, -1, axis=0) if entity.closed else vertices[1:]
            steps = np.linalg.norm(following[:, :2] - vertices[: len(following), :2], axis=1)
            assert steps.min() > 0.0, "repeated vertex or zero-length piece"
            assert np.abs(vertices[:, 2]).max() <= 1.0 + 1e-12, "an arc of more than half a turn"
            assert math.hypot(*entity.dxf.extrusion) == pytest.approx(1.0, abs=1e-12)
        elif entity.dxftype() == "ARC":
            assert entity.dxf.radius > 0.0
            assert math.hypot(*entity.dxf.extrusion) == pytest.approx(1.0, abs=1e-12)
            assert (entity.dxf.end_angle - entity.dxf.start_angle) % 360.0 > 0.0, "zero-length arc"
        elif entity.dxftype() == "LINE":
            assert entity.dxf.start.distance(entity.dxf.end) > 0.0
        else:
            assert entity.dxftype() in ("CIRCLE", "SPLINE"), entity.dxftype()


def test_cut_contours_lie_in_the_drawing_plane(examples):
    drawing = ezdxf.readfile(examples["logo"].file("dxf", "--tolerance", TOLERANCE))
    for entity in drawing.modelspace():
        assert tuple(entity.dxf.extrusion) == (0.0, 0.0, 1.0)
        assert entity.closed
