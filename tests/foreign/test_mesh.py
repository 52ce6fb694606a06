"""Meshes as trimesh sees them, GLB files as the Khronos validator sees them."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

GLTF = Path(__file__).resolve().parent / "gltf"
A, C, MU = 50.0, 20.0, 32.0
RING = {"type": "cyclide", "a": A, "c": C, "mu": MU, "segments": [8, 8]}
PATCH = {
    "type": "cyclide-patch",
    "corners": [[-40, -30], [40, -30], [-30, 40], [30, 40]],
    "frame": [[8, -1, 4], [-1, 4, 3]],
}
ARC = {"type": "arc", "from": [0, 0, 50], "to": [10, 0, 50], "tangent": [1, 1, 0]}
SUFFIXES = ["glb", "obj", "stl"]


def ring_volume():
    """Volume and area of the ring cyclide by the divergence theorem on its parametrisation (periodic: spectral)."""
    n = 256
    theta, psi = np.meshgrid(2 * np.pi * np.arange(n) / n, 2 * np.pi * np.arange(n) / n, indexing="ij")
    b = np.sqrt(A * A - C * C)
    d = A - C * np.cos(theta) * np.cos(psi)
    points = np.stack(
        [
            (MU * (C - A * np.cos(theta) * np.cos(psi)) + b * b * np.cos(theta)) / d,
            b * np.sin(theta) * (A - MU * np.cos(psi)) / d,
            b * np.sin(psi) * (C * np.cos(theta) - MU) / d,
        ],
        axis=-1,
    )

    def derivative(f, axis):
        k = 1j * np.fft.fftfreq(n, 1.0 / n)
        k = k[:, None, None] if axis == 0 else k[None, :, None]
        return np.fft.ifft(k * np.fft.fft(f, axis=axis), axis=axis).real

    normal = np.cross(derivative(points, 0), derivative(points, 1)) * (2 * np.pi / n) ** 2
    return abs(np.sum(points * normal)) / 3.0, np.sum(np.linalg.norm(normal, axis=-1))


@pytest.fixture(scope="module")
def build(program, tmp_path_factory):
    """Builds a file of objects; gives its path and the report on it."""
    folder = tmp_path_factory.mktemp("meshes")

    def run(name, suffix, objects, *options, units="mm"):
        document, path = folder / f"{name}.json", folder / f"{name}.{suffix}"
        document.write_text(json.dumps({"cyclide": 1, "units": units, "objects": objects}))
        report = json.loads(program("build", document, "-o", path, "--json", *options))
        return path, report["files"][0]

    return run


def load(path):
    """All triangles of a file in one mesh, equal vertices merged, and its curves."""
    scene = trimesh.load_scene(path)
    placed = scene.dump()
    curves = [g for g in placed if isinstance(g, trimesh.path.Path3D)]
    mesh = trimesh.util.concatenate([g for g in placed if isinstance(g, trimesh.Trimesh)])
    if isinstance(mesh, trimesh.Trimesh):
        mesh.merge_vertices(merge_norm=True, merge_tex=True)
    return mesh, curves


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("tolerance", [0.5, 0.01])
def test_a_closed_surface_is_watertight_with_its_volume(build, suffix, tolerance):
    path, report = build(f"ring-{tolerance}", suffix, {"ring": RING}, "--tolerance", tolerance)
    mesh, _ = load(path)
    scale = 1000.0 if suffix == "glb" else 1.0  # GLB is in metres
    volume, area = ring_volume()
    assert mesh.is_watertight and mesh.is_winding_consistent
    assert mesh.euler_number == 0, "a ring has one hole"
    # The mesh is within the bound of the surface: a layer of that thickness on both sides.
    assert abs(mesh.volume * scale**3 - volume) <= 1.02 * report["bound"] * area
    assert mesh.volume > 0, "the normals point outward"
    assert report["deviation"] <= report["bound"] <= tolerance + 1e-5


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_an_open_surface_has_one_border(build, suffix):
    path, _ = build("patch", suffix, {"patch": PATCH}, "--tolerance", 0.05)
    mesh, _ = load(path)
    assert mesh.is_winding_consistent and not mesh.is_watertight
    assert mesh.euler_number == 1, "a disc"


def test_obj_has_quads(build):
    path, _ = build("ring-quads", "obj", {"ring": RING}, "--tolerance", 0.5)
    corners = [len(line.split()) - 1 for line in path.read_text().splitlines() if line.startswith("f ")]
    assert corners and set(corners) == {4}


def validate(*paths):
    done = subprocess.run(["node", "validate.cjs", *map(str, paths)], cwd=GLTF, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def test_glb_passes_the_validator(build):
    far = dict(PATCH, corners=[[x + 3e4, y - 1e4, 5e4] for x, y in PATCH["corners"]])
    cases = [
        build("glb-patch", "glb", {"patch": PATCH}),
        build("glb-ring", "glb", {"ring": RING}),
        build("glb-curve", "glb", {"arc": ARC}),
        build("glb-all", "glb", {"arc": ARC, "patch": PATCH, "ring": RING}, units="in"),
        build("glb-far", "glb", {"patch": far}),
    ]
    for issues in validate(*[path for path, _ in cases]):
        assert (issues["errors"], issues["warnings"]) == (0, 0), issues["messages"]


def test_glb_stands_upright_in_metres(build):
    path, _ = build("glb-inch", "glb", {"arc": ARC, "ring": RING}, units="in")
    mesh, curves = load(path)
    assert len(curves) == 1
    inch = 0.0254
    low, high = mesh.bounds / inch
    assert high[0] - low[0] == pytest.approx(2 * (A + MU), abs=0.1)
    # Upright it is as high as its widest tube, of radius mu + c.
    assert high[1] - low[1] == pytest.approx(2 * (MU + C), abs=0.1)
    assert np.allclose(curves[0].bounds[:, 1] / inch, 50.0, atol=1e-4), "the arc is 50 inches up"


def test_the_validator_finds_faults(build, tmp_path):
    """The judge itself: a wrong bound is an error."""
    path, _ = build("glb-spoilt", "glb", {"patch": PATCH})
    data = path.read_bytes()
    at = data.index(b'"max":[') + len(b'"max":[')
    digit = next(i for i in range(at, len(data)) if data[i : i + 1].isdigit())
    spoilt = tmp_path / "spoilt.glb"
    spoilt.write_bytes(data[:digit] + (b"1" if data[digit : digit + 1] != b"1" else b"2") + data[digit + 1 :])
    assert validate(spoilt)[0]["errors"] > 0
