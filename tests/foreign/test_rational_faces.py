"""Faces that are no cyclides, which the kernel holds and no document makes: a G1 pair of bicubic faces with uneven weights, and an
egg of revolution with two poles, in every format of surfaces, against their control points as the formulas below give them."""

import math
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

from conftest import program_path
from step_checks import NORMAL_LIMIT, assert_volume, normals_across_joints, structure
from step_faces import StepFaces


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    path = tmp_path_factory.mktemp("faces")
    subprocess.run([program_path().with_name("xtask"), "faces", path], check=True, capture_output=True)
    return Path(path)


def pair():
    """Homogeneous control points of both faces; the fourth column of the first is the edge, beside which the second goes on."""

    def control(i, j):
        w = 1.0 + 0.2 * math.sin(2.1 * i + 1.7 * j)
        height = 0.4 * math.sin(1.3 * i + 0.4) * math.cos(0.9 * j - 0.2)
        return np.array([(i - 1.0) * w, (j + 0.1 * i) * w, height * w, w])

    first = np.array([[control(i, j) for j in range(4)] for i in range(4)])
    second = np.array([[control(i, j + 3) for j in range(4)] for i in range(4)])
    second[:, 0] = first[:, 3]
    second[:, 1] = first[:, 3] + 0.75 * (first[:, 3] - first[:, 2])
    return first, second


def jet(rows, u, v):
    """Point and normal of a bicubic face by de Casteljau's sums."""
    b = [np.array([math.comb(3, k) * x**k * (1 - x) ** (3 - k) for k in range(4)]) for x in (u, v)]
    h = np.einsum("i...,j...,ijk->...k", b[0], b[1], rows)
    return h[..., :3] / h[..., 3:]


def test_opencascade_reads_the_pair(folder):
    step = StepFaces(folder / "pair.step")
    size, users = structure(step, closed=False)
    assert step.exactly_valid and len(step.faces) == 2 and not step.solids
    for face, rows in zip(step.faces, pair()):
        # The weights of a face may have a common factor.
        read = face.rational.rows / face.rational.rows[0, 0, 3]
        assert np.abs(read - rows / rows[0, 0, 3]).max() <= 1e-14
        x, y = np.random.default_rng(5).uniform(0.0, 1.0, (2, 1000))
        points, *_ = face.rational.jet(*face.rational.scaled(x, y))
        assert np.linalg.norm(points - jet(rows, x, y), axis=-1).max() <= 1e-14 * size
    assert normals_across_joints(users) <= NORMAL_LIMIT


def test_opencascade_reads_the_egg(folder):
    step = StepFaces(folder / "egg.step")
    structure(step, closed=True)
    assert step.exactly_valid and len(step.solids) == 1 and len(step.faces) == 8  # halved for integration
    # Discs along the profile, of radius r and height dz, by Gauss's rule on parts of it: the profile is smooth.
    profile = np.array([[0.0, -1.0, 1.0], [1.6, -1.0, 1.2], [1.1, 1.3, 0.9], [0.0, 1.5, 1.1]])
    rows = np.column_stack([profile[:, 0] * profile[:, 2], profile[:, 1] * profile[:, 2], profile[:, 2]])
    nodes, weights = np.polynomial.legendre.leggauss(20)
    x = ((np.arange(16)[:, None] + 0.5 * (nodes + 1.0)) / 16).ravel()
    b = np.array([math.comb(3, k) * x**k * (1 - x) ** (3 - k) for k in range(4)])
    low = [math.comb(2, k) * x**k * (1 - x) ** (2 - k) for k in range(3)]
    db = 3.0 * np.array([-low[0], low[0] - low[1], low[1] - low[2], low[2]])
    h, dh = b.T @ rows, db.T @ rows
    r, z = h[:, 0] / h[:, 2], h[:, 1] / h[:, 2]
    dz = (dh[:, 1] - z * dh[:, 2]) / h[:, 2]
    assert_volume(step, math.pi * float(np.sum(np.tile(weights, 16) / 32 * r**2 * dz)))


@pytest.mark.parametrize("suffix", ["glb", "obj", "stl"])
@pytest.mark.parametrize("name", ["pair", "egg"])
def test_meshes_have_its_area(folder, name, suffix):
    mesh = trimesh.load(folder / f"{name}.{suffix}", force="mesh")
    scale = 1000.0 if suffix == "glb" else 1.0  # GLB counts in metres
    expected = StepFaces(folder / f"{name}.step").area()
    # Chords within 1e-4 of the size lose that part of the area at most, and some of it in rounding of single precision.
    assert mesh.area * scale**2 == pytest.approx(expected, rel=2e-3)
    mesh.merge_vertices(merge_norm=True)
    assert mesh.is_watertight == (name == "egg")
