"""Motions judged without our code: poses and paths from SciPy and dual quaternions written here, STEP by OpenCASCADE, animations by the
validator of glTF and trimesh, their motion by the interpolation rules of glTF."""

import json
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from quaternion_form import inverse, multiply, pure
from step_faces import StepFaces
from step_reader import StepFile

GLTF = Path(__file__).resolve().parent / "gltf"
POSES = [
    {"time": 0.0, "position": [0, 0, 40], "quaternion": [0, 1, 0, 0.1]},
    {"time": 1.0, "position": [60, 20, 120], "quaternion": [0.2, 0.9, 0.3, 0.1]},
    {"time": 2.5, "position": [160, 80, 140], "quaternion": [0.5, 0.7, 0.5, -0.1]},
    {"time": 3.0, "position": [220, 160, 60], "quaternion": [0.7, 0.5, 0.5, 0.0]},
]
POINT = [10.0, -5.0, 30.0]
PROFILE = [[-20.0, 0.0, 0.0], [20.0, 0.0, 5.0]]


class Spline:
    """The C1 spline of dual quaternions, by its definition: Hermite cubics, translation 2 Im(r conj p)/|p|²."""

    def __init__(self, poses):
        self.t = np.array([p["time"] for p in poses])
        rows = []
        for pose in poses:
            p = np.array(pose["quaternion"], float)
            p /= np.linalg.norm(p)
            if rows and np.dot(rows[-1][:4], p) < 0:
                p = -p
            rows.append(np.r_[p, 0.5 * multiply(pure(pose["position"]), p)])
        self.y = np.array(rows)
        h, slope = np.diff(self.t), np.diff(self.y, axis=0) / np.diff(self.t)[:, None]
        inner = (slope[:-1] * h[1:, None] + slope[1:] * h[:-1, None]) / (h[:-1] + h[1:])[:, None]
        self.d = np.vstack([2 * slope[0] - inner[0], inner, 2 * slope[-1] - inner[-1]])

    def pose(self, t):
        i = min(max(np.searchsorted(self.t, t, side="right") - 1, 0), len(self.t) - 2)
        h = self.t[i + 1] - self.t[i]
        s = (t - self.t[i]) / h
        y = (
            (1 + 2 * s) * (1 - s) ** 2 * self.y[i]
            + s * (1 - s) ** 2 * h * self.d[i]
            + s * s * (3 - 2 * s) * self.y[i + 1]
            - s * s * (1 - s) * h * self.d[i + 1]
        )
        p, r = y[:4], y[4:]
        return p / np.linalg.norm(p), 2 * multiply(r, inverse(p))[1:]

    def point(self, t, x):
        p, tau = self.pose(t)
        return multiply(multiply(p, pure(x)), inverse(p))[1:] + tau


@pytest.fixture(scope="module")
def made(program, tmp_path_factory):
    folder = tmp_path_factory.mktemp("motion")
    objects = {
        "m": {"type": "motion", "poses": POSES},
        "path": {"type": "trajectory", "of": "m", "point": POINT},
        "blade": {"type": "polyline", "points": PROFILE, "construction": True},
        "run": {"type": "swept-surface", "of": "m", "profile": "blade"},
    }
    (folder / "m.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", folder / "m.json", "-o", folder / "m.glb", "--json"))
    for name in ("path", "run"):
        only = {**objects, "m": {**objects["m"], "construction": True}}
        only = {k: v for k, v in only.items() if k in ("m", "blade", name) and (k != "blade" or name == "run")}
        (folder / f"{name}.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": only}))
        program("build", folder / f"{name}.json", "-o", folder / f"{name}.step")
    return folder, report


def test_poses_are_those_of_the_definition(made, program):
    folder, _ = made
    spline = Spline(POSES)
    rows = program("sample", folder / "m.json", "--object", "m", "--count", "61").splitlines()[1:]
    for row in rows:
        values = np.array([float(v) for v in row.split(",")])
        p, tau = spline.pose(values[0])
        assert np.abs(values[1:4] - tau).max() < 1e-9
        assert min(np.abs(values[4:8] - p).max(), np.abs(values[4:8] + p).max()) < 1e-12


def test_paths_are_exact_in_step(made):
    folder, _ = made
    (wire,) = StepFile(folder / "path.step").wires
    spline = Spline(POSES)
    points = np.vstack([edge.points(200) for edge in wire.edges])
    assert off(lambda t: spline.point(t, POINT), points[::7], [(0.0, 3.0)]).max() < 1e-9


def off(at, points, ranges, grid=61):
    """The distances of points from a curve or surface: from the nearest place of a grid by the steps of Gauss and Newton."""
    axes = [np.linspace(*r, grid if len(ranges) == 1 else 25) for r in ranges]
    places = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, len(ranges))
    lows, highs = np.array(ranges).T
    _, nearest = cKDTree([at(*x) for x in places]).query(points)
    found, steps = [], 1e-5 * np.eye(len(ranges))
    for place, point in zip(places[nearest], points):
        for _ in range(60):
            slopes = np.array([(at(*(place + e)) - at(*(place - e))) / 2e-5 for e in steps]).T
            change = np.linalg.lstsq(slopes, point - at(*place), rcond=None)[0]
            place = np.clip(place + change, lows, highs)
            if np.abs(change).max() < 1e-14:
                break
        found.append(np.linalg.norm(at(*place) - point))
    return np.array(found)


def test_swept_surfaces_are_valid_shells_in_step(made):
    folder, _ = made
    step = StepFaces(folder / "run.step")
    assert step.exactly_valid
    spline, (a, b) = Spline(POSES), np.array(PROFILE)
    generator = np.random.default_rng(5)
    for face in step.faces:
        points = face.points(8, generator)[0]
        assert off(lambda t, s: spline.point(t, a + (b - a) * s), points, [(0.0, 3.0), (0.0, 1.0)]).max() < 1e-9
    # The area by Gauss's rule, with derivatives by differences.
    nodes, weights = np.polynomial.legendre.leggauss(16)
    total = 0.0
    for start, end in zip(spline.t, spline.t[1:]):
        for t, dt in zip(start + (end - start) * (nodes + 1) / 2, weights * (end - start) / 2):
            for s, ds in zip((nodes + 1) / 2, weights / 2):
                x = a + (b - a) * s
                across = spline.point(t, b) - spline.point(t, a)
                along = (spline.point(t + 1e-5, x) - spline.point(t - 1e-5, x)) / 2e-5
                total += np.linalg.norm(np.cross(across, along)) * dt * ds
    # What differences of steps of 1e-5 leave.
    assert step.area() == pytest.approx(total, rel=1e-7)


# A bent rod: segments with rounded corners, in space.
ROD, RADIUS = [[0.0, 0.0, 0.0], [60.0, 0.0, 0.0], [90.0, 60.0, 0.0], [90.0, 90.0, 70.0]], 15.0


def carried(corners, radius, x):
    """The paths of a body point along a rod, part by part, by the definition: along segments the body is not turned, round a corner it is
    turned about the corner's axis with the rod."""
    rotation, at = np.eye(3), np.array(corners[0])
    corners = np.array(corners)
    for before, corner, after in zip(corners, corners[1:], corners[2:]):
        d0, d1 = ((v / np.linalg.norm(v)) for v in (corner - before, after - corner))
        axis = np.cross(d0, d1)
        angle = np.arctan2(np.linalg.norm(axis), np.dot(d0, d1))
        axis /= np.linalg.norm(axis)
        tangent = corner - radius * np.tan(angle / 2) * d0
        centre = tangent + radius * np.cross(axis, d0)
        yield lambda u, a=at, b=tangent, r=rotation: a + u * (b - a) + r @ x
        yield lambda u, a=tangent, c=centre, k=axis, g=angle, r=rotation: c + turn(k, g * u) @ (a - c + r @ x)
        rotation, at = turn(axis, angle) @ rotation, corner + radius * np.tan(angle / 2) * d1
    yield lambda u, a=at, b=corners[-1], r=rotation: a + u * (b - a) + r @ x


def turn(axis, angle):
    k = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * k + (1 - np.cos(angle)) * k @ k


def test_a_body_on_a_rod_turns_with_its_bends(program, tmp_path):
    objects = {
        "rod": {"type": "polyline", "points": ROD, "radius": RADIUS, "construction": True},
        "m": {"type": "motion", "along": "rod", "construction": True},
        "path": {"type": "trajectory", "of": "m", "point": [0, 12, 5]},
    }
    (tmp_path / "a.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", tmp_path / "a.json", "-o", tmp_path / "a.step")
    (wire,) = StepFile(tmp_path / "a.step").wires
    paths = list(carried(ROD, RADIUS, np.array([0.0, 12.0, 5.0])))
    points = np.vstack([edge.points(60) for edge in wire.edges])
    assert np.linalg.norm(points[-1] - paths[-1](1.0)) < 1e-9
    assert np.min([off(path, points, [(0.0, 1.0)]) for path in paths], axis=0).max() < 1e-9


def chunks(path):
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20 : 20 + length]), data[28 + length :]


def accessor(document, binary, index):
    entry = document["accessors"][index]
    view = document["bufferViews"][entry["bufferView"]]
    size = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[entry["type"]]
    return np.frombuffer(binary, "<f4", entry["count"] * size, view["byteOffset"]).reshape(-1, size).astype(float)


def hermite(times, values, t):
    """The cubic spline of glTF 2.0, appendix C."""
    k = min(max(np.searchsorted(times, t, side="right") - 1, 0), len(times) - 2)
    h = times[k + 1] - times[k]
    s = (t - times[k]) / h
    v0, b0, a1, v1 = values[3 * k + 1], values[3 * k + 2], values[3 * k + 3], values[3 * k + 4]
    return (
        (2 * s**3 - 3 * s**2 + 1) * v0
        + h * (s**3 - 2 * s**2 + s) * b0
        + (-2 * s**3 + 3 * s**2) * v1
        + h * (s**3 - s**2) * a1
    )


def test_animations_show_the_motion(made):
    folder, report = made
    (entry,) = report["files"]
    document, binary = chunks(folder / "m.glb")
    (animation,) = document["animations"]
    times = accessor(document, binary, animation["samplers"][0]["input"])[:, 0]
    translations = accessor(document, binary, animation["samplers"][0]["output"])
    rotations = accessor(document, binary, animation["samplers"][1]["output"])
    node = animation["channels"][0]["target"]["node"]
    (parent,) = (n for n in document["nodes"] if node in n.get("children", []) and "rotation" not in n)
    spline, worst = Spline(POSES), 0.0
    for t in np.linspace(0, 3, 997):
        x, y, z, w = hermite(times, rotations, t)
        p, tau = spline.pose(t)
        q = np.array([w, x, y, z]) / np.linalg.norm([w, x, y, z])
        worst = max(worst, np.abs(hermite(times, translations, t) + parent["translation"] - tau).max())
        worst = max(worst, 20 * min(np.linalg.norm(q - p), np.linalg.norm(q + p)))
    assert worst < entry["bound"]


def test_animations_pass_the_validator_and_load(made):
    folder, _ = made
    scene = trimesh.load(folder / "m.glb")
    assert len(scene.geometry) >= 3
    done = subprocess.run(["node", "validate.cjs", folder / "m.glb"], cwd=GLTF, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    (issues,) = (json.loads(line) for line in done.stdout.splitlines())
    assert (issues["errors"], issues["warnings"]) == (0, 0), issues["messages"]
