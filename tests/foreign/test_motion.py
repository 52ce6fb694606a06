"""Motions judged without our code: poses and paths from SciPy and dual quaternions written here, STEP by OpenCASCADE, animations by the
validator of glTF and trimesh, their motion by the interpolation rules of glTF."""

import json
import struct
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

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


def product(p, q):
    w, v = p[0] * q[0] - np.dot(p[1:], q[1:]), p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])
    return np.r_[w, v]


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
            rows.append(np.r_[p, 0.5 * product(np.r_[0.0, pose["position"]], p)])
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
        conj = np.r_[p[0], -p[1:]]
        return p / np.linalg.norm(p), 2 * product(r, conj)[1:] / np.dot(p, p)

    def point(self, t, x):
        p, tau = self.pose(t)
        return product(product(p, np.r_[0.0, x]), np.r_[p[0], -p[1:]])[1:] + tau


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
    fine = np.array([spline.point(t, POINT) for t in np.linspace(0, 3, 20001)])
    # Each point of the file is near the path: by the foot on the nearest chord, whose sagitta is 1e-7 here.
    for point in points[::7]:
        k = np.clip(np.argmin(np.linalg.norm(fine - point, axis=1)), 1, len(fine) - 2)
        t = np.linspace(0, 3, 20001)[k]
        step = 3 / 20000
        for _ in range(30):
            ahead, behind, here = (spline.point(t + e, POINT) for e in (1e-6, -1e-6, 0))
            d1 = (ahead - behind) / 2e-6
            t += np.clip(np.dot(point - here, d1) / np.dot(d1, d1), -step, step)
        assert np.linalg.norm(spline.point(t, POINT) - point) < 1e-7


def test_swept_surfaces_are_valid_shells_in_step(made):
    folder, _ = made
    step = StepFaces(folder / "run.step")
    assert step.exactly_valid
    spline, (a, b) = Spline(POSES), np.array(PROFILE)
    # The area by the midpoint rule, with derivatives by differences.
    total, count = 0.0, 120
    for t in (np.arange(3 * count) + 0.5) / count:
        for s in (np.arange(24) + 0.5) / 24:
            x = a + (b - a) * s
            across = spline.point(t, b) - spline.point(t, a)
            along = (spline.point(t + 1e-5, x) - spline.point(t - 1e-5, x)) / 2e-5
            total += np.linalg.norm(np.cross(across, along)) / count / 24
    assert step.area() == pytest.approx(total, rel=2e-4)


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
