"""Surfaces of revolution as OpenCASCADE reads them, against the profile turned with NumPy, and as solids that people model with."""

import json
import math

import numpy as np
import pytest
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from scipy.interpolate import BSpline
from scipy.spatial import cKDTree

import step_modeling as modeling
from conftest import ROOT
from reference_objects import reported_area
from step_checks import NORMAL_LIMIT, assert_area, assert_cuts, assert_points, assert_volume, normals_across_joints, structure
from step_faces import StepFaces

VASE = json.loads((ROOT / "examples/vase.json").read_text())
SPINDLE = {"type": "arc-spline", "points": [[0, 0, 0], [9, 0, 2], [14, 0, 11], [6, 0, 19], [0, 0, 21]], "construction": True}


class Profile:
    """The curves of a profile in the plane of x and z as a foreign library evaluates them, for distances from their points."""

    def __init__(self, curves):
        self.curves = []
        for curve in curves:
            weights = np.array(curve["weights"])[:, None]
            rows = np.hstack([np.array(curve["control_points"])[:, [0, 2]] * weights, weights])
            spline = BSpline(np.array(curve["knots"], float), rows, curve["degree"])
            self.curves.append(spline)
        self.places = [np.linspace(spline.t[0], spline.t[-1], 4001) for spline in self.curves]
        self.trees = [cKDTree(self._jet(k, places)[0]) for k, places in enumerate(self.places)]

    def _jet(self, k, x):
        h, h1, h2 = (self.curves[k](x, order) for order in range(3))
        p = h[:, :2] / h[:, 2:]
        d = (h1[:, :2] - p * h1[:, 2:]) / h[:, 2:]
        return p, d, (h2[:, :2] - 2 * d * h1[:, 2:] - p * h2[:, 2:]) / h[:, 2:]

    def locate(self, points):
        """Distances from the surface about the third axis, and its normals."""
        radius = np.hypot(points[:, 0], points[:, 1])
        plane = np.stack([radius, points[:, 2]], -1)
        k = min(range(len(self.curves)), key=lambda k: self.trees[k].query(plane[:1])[0][0])
        x = self.places[k][self.trees[k].query(plane)[1]]
        for _ in range(4):  # from the nearest of 4,001 places
            p, d, dd = self._jet(k, x)
            off = plane - p
            x = np.clip(x + np.sum(off * d, -1) / (np.sum(d * d, -1) - np.sum(off * dd, -1)), *self.places[k][[0, -1]])
        p, d, _ = self._jet(k, x)
        d = d / np.linalg.norm(d, axis=-1, keepdims=True)
        around = points[:, :2] / radius[:, None]
        return np.linalg.norm(plane - p, axis=-1), np.column_stack([around * d[:, 1:], -d[:, 0]])


@pytest.fixture
def revolved(program, tmp_path):
    """The solid of a profile by name, as read, its report, and the profile alone."""

    def make(profile, rest):
        alone = {key: value for key, value in profile.items() if key != "construction"}
        documents = {"profile": {"p": alone}, "solid": {"p": profile, "solid": {"type": "revolution", "of": "p", **rest}}}
        for name, objects in documents.items():
            (tmp_path / f"{name}.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
        program("build", tmp_path / "profile.json", "-o", tmp_path / "curves.json")
        contours = json.loads((tmp_path / "curves.json").read_text())["objects"]["p"]["contours"]
        report = json.loads(program("build", tmp_path / "solid.json", "-o", tmp_path / "solid.step", "--step-faces", "split", "--json"))
        entry = report["objects"]["solid"]
        return StepFaces(tmp_path / "solid.step"), entry, Profile(contours[0]["curves"])

    return make


@pytest.mark.parametrize("name", ["vase", "spindle"])
def test_solids_are_their_profiles_turned(name, revolved):
    profile = {"vase": VASE["objects"]["profile"], "spindle": SPINDLE}[name]
    step, report, curve = revolved(profile, {})
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells)) == (1, 1) and step.exactly_valid
    assert_area(step, reported_area([report]))
    assert_volume(step, report["volume"])
    assert_points(step, size, curve.locate)
    assert normals_across_joints(users, report["joints"]["creases"]) <= NORMAL_LIMIT
    # The foot and the lip of the vase are plane. Arcs whose circle meets the axis give tori that cross themselves, without an entity.
    assert {face.kind for face in step.faces} == {"b-spline", {"vase": "plane", "spindle": "torus"}[name]}


def test_arcs_and_segments_give_analytic_faces(revolved):
    """A knob of a plane, a cylinder, a fillet, a cone and a plane: the kinds, and the volume by Pappus' theorem."""
    corners = [[0, 0, 0], [12, 0, 0], [12, 0, 8], [5, 0, 20], [0, 0, 20]]
    profile = {"type": "fair-spline", "points": corners, "corner_angle": 0.1, "construction": True}
    step, report, _ = revolved(profile, {})
    structure(step, closed=True)
    cone = math.pi * 12 / 3 * (12**2 + 12 * 5 + 5**2)
    assert_volume(step, math.pi * 12**2 * 8 + cone)
    assert {face.kind for face in step.faces} == {"plane", "cylinder", "cone"}


def test_a_part_of_a_turn_has_ends(revolved):
    """The wall of the vase is bent and thin: no point sees all of its profile."""
    _, whole, _ = revolved(VASE["objects"]["profile"], {})
    step, report, curve = revolved(VASE["objects"]["profile"], {"angle": {"degrees": 100}})
    size, _ = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    assert report["volume"] == pytest.approx(whole["volume"] * 100 / 360, rel=1e-9)
    assert_volume(step, report["volume"])
    angle = math.radians(100)
    across = np.array([[0.0, 1.0, 0.0], [-math.sin(angle), math.cos(angle), 0.0]])

    def locate(p):
        off = np.abs(p @ across.T)
        k = int(off.max(axis=0).argmin())
        if off[:, k].max() <= 1e-9 * size:
            return off[:, k], np.broadcast_to(across[k], p.shape)
        return curve.locate(p)

    assert_points(step, size, locate)


@pytest.mark.parametrize("name", ["vase", "spindle"])
def test_solids_are_cut(name, revolved):
    profile = {"vase": VASE["objects"]["profile"], "spindle": SPINDLE}[name]
    step, report, _ = revolved(profile, {})
    assert_cuts(step, report["volume"], modeling.slab, modeling.drill)


SWINGING = {
    "degree 5": {"type": "nurbs", "degree": 5, "knots": [0] * 6 + [1] * 6, "control_points": [[0, 0, 0], [30, 0, 20], [2, 0, 40], [40, 0, 10], [3, 0, 30], [0, 0, 60]]},
    "degree 3": {"type": "nurbs", "degree": 3, "knots": [0] * 4 + [1] * 4, "control_points": [[0, 0, 0], [30, 0, 20], [2, 0, 40], [0, 0, 60]]},
    "through five points": {"type": "qb-interpolation", "parameters": "uniform", "points": [[0, 0, 0], [30, 0, 20], [22, 0, 40], [28, 0, 60], [0, 0, 70]]},
}


@pytest.mark.parametrize("name", SWINGING)
def test_faces_are_such_that_readers_integrate_them(name, revolved):
    """Of a face that OpenCASCADE's rule does not integrate 4e-4 of the area are lost without a word."""
    step, report, _ = revolved({**SWINGING[name], "construction": True}, {})
    # It takes fewer nodes where less is asked.
    for accuracy, limit in ((1e-11, 2e-7), (1e-7, 5e-6)):
        measure = GProp_GProps()
        BRepGProp.SurfaceProperties_s(step.shape, measure, accuracy)
        assert measure.Mass() == pytest.approx(report["area"], rel=limit)
    assert modeling.volume(step.shape) == pytest.approx(report["volume"], rel=2e-7)


def green(points):
    """The area within a polygon in the plane of x and z, and the integral of the distance from the axis over it."""
    p, q = np.array(points), np.roll(points, -1, axis=0)
    cross = p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
    return abs(cross.sum()) / 2, abs((cross * (p[:, 0] + q[:, 0])).sum()) / 6


def disk(x, radius):
    return math.pi * radius**2, math.pi * radius**2 * x


U = [[10, 0], [30, 0], [30, 20], [27, 20], [27, 3], [13, 3], [13, 20], [10, 20]]
COMB = [[10 + 2 * k, 18 if k % 2 == 0 else 1] for k in range(11)] + [[30, 0], [10, 0]]


def square(x, half):
    return [[x - half, -half], [x + half, -half], [x + half, half], [x - half, half]]


def ring(x, radius):
    """A circle as arcs through four of its points."""
    return [[x + radius, 0], [x, radius], [x - radius, 0], [x, -radius]]


# Contours, each a list of corners or of points of arcs, with area and moment of each.
SECTIONS = {
    "u": ("polyline", [U], [green(U)]),
    "comb": ("polyline", [COMB], [green(COMB)]),
    "tube": ("arc-spline", [ring(20, 6), ring(20, 5)], [disk(20, 6), disk(20, 5)]),
    "eccentric": ("arc-spline", [ring(20, 6), ring(21, 4.8)], [disk(20, 6), disk(21, 4.8)]),
    "box": ("polyline", [square(20, 8), square(20, 7)], [green(square(20, 8)), green(square(20, 7))]),
}


@pytest.mark.parametrize("name, angle", [("u", 1.0), ("comb", -5.0), ("tube", 1.0), ("eccentric", -5.0), ("box", 5.0)])
def test_parts_of_turns_are_solids(name, angle, program, tmp_path):
    """Contours that no point sees whole, and tubes: valid, closed, with the volume of Pappus and planar ends; cut and fused."""
    word, contours, moments = SECTIONS[name]
    points = [[[x, 0, z] for x, z in contour] for contour in contours]
    contour = {"type": word, "points": points, "closed": True, "construction": True}
    objects = {"contour": contour, "solid": {"type": "revolution", "of": "contour", "angle": angle}}
    (tmp_path / "s.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", tmp_path / "s.json", "-o", tmp_path / "s.step", "--step-faces", "split", "--json"))["objects"]["solid"]
    step = StepFaces(tmp_path / "s.step")
    structure(step, closed=True)
    assert (len(step.solids), len(step.shells)) == (1, 1) and step.exactly_valid
    volume = abs(angle) * (moments[0][1] - sum(m for _, m in moments[1:]))
    assert report["volume"] == pytest.approx(volume, rel=1e-9)
    assert_volume(step, volume)
    ends = 0.0
    across = np.array([[0.0, 1.0, 0.0], [-math.sin(angle), math.cos(angle), 0.0]])
    for face in step.faces:
        if face.kind == "plane":
            p, n = face.at(face.box[0], face.box[2])
            if any(abs(n @ a) > 0.999 * np.linalg.norm(n) and abs(p @ a) < 1e-9 for a in across):
                ends += face.area()
    assert ends == pytest.approx(2 * (moments[0][0] - sum(a for a, _ in moments[1:])), rel=1e-9)
    assert_area(step, reported_area([report]))
    if angle == 1.0:  # the others have the same faces in more sectors
        assert_cuts(step, report["volume"], modeling.slab)
