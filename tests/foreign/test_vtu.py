"""VTU files read by VTK: every kind of cell at inner parameters against forms computed here, volumes by integration of VTK's points."""

import json
from pathlib import Path

import numpy as np
import pytest
from numpy.polynomial import chebyshev

from volume_form import Block

CORNERS = [[0, 0, 0], [60, 8, -6], [-10, 50, 4], [5, -6, 45]]


def vtk_grid(path):
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def cell_point(grid, cell, parameters):
    """The point of a cell as VTK evaluates it."""
    from vtkmodules.vtkCommonCore import reference

    it = grid.GetCell(cell)
    x, sub = [0.0] * 3, reference(0)
    weights = [0.0] * it.GetNumberOfPoints()
    it.EvaluateLocation(sub, list(parameters) + [0.0] * (3 - len(parameters)), x, weights)
    return np.array(x)


def inner(dimension, count=25):
    """Places inside a cell, the same in every run."""
    return np.random.default_rng(1).uniform(0.02, 0.98, (count, dimension))


@pytest.fixture(scope="module")
def built(program, tmp_path_factory):
    """Blocks of all kinds with the samples that the program takes of them, and curves and surfaces of many degrees."""
    folder = tmp_path_factory.mktemp("vtu")

    def write(name, objects, units="mm"):
        model = folder / f"{name}.json"
        model.write_text(json.dumps({"cyclide": 1, "units": units, "objects": objects}))
        program("build", model, "-o", folder / f"{name}.vtu", "-o", folder / f"{name}.exact.json", "--json")
        return model, folder / f"{name}.vtu", json.loads((folder / f"{name}.exact.json").read_text())

    return write


def corners_of(program, model, name):
    """The corners of a block as the program samples them, s fastest."""
    rows = program("sample", model, "--object", name, "--count", "2").splitlines()[1:]
    return [[float(v) for v in row.split(",")[3:6]] for row in rows]


def test_blocks_are_what_their_corners_and_frame_say(built, program):
    frame = [[0.97, 0.12, -0.21], [-0.12, 0.97, 0.0]]
    objects = {
        "framed": {"type": "cyclide-volume", "corners": CORNERS, "inside": [1, 1.3, 0.8], "frame": frame},
        # Sides of more than half a circle: more than one cell.
        "ring": {
            "type": "cyclide-volume",
            "corners": [[10, 0, 0], [-10, 0, 0], [10, 0, 5], [-10, 0, 5], [20, 0, 0], [-20, 0, 0], [20, 0, 5]],
            "frame": [[0, 1, 0], [0, 0, 1]],
        },
    }
    # The two directions of the frame are perpendicular.
    frame[1] = list(np.cross([0.3, 0.1, 1.0], frame[0]))
    model, path, _ = built("blocks", objects)
    grid = vtk_grid(path)
    kinds = [grid.GetCellType(k) for k in range(grid.GetNumberOfCells())]
    assert set(kinds) == {79}
    block = Block(corners_of(program, model, "framed"), *frame)
    size = 60.0
    for place in inner(3):
        # Corners and frame are known to rounding; three-fold products of it.
        assert np.linalg.norm(cell_point(grid, 0, place) - block.point(*place)) < 1e-12 * size
    ring = [k for k in range(grid.GetNumberOfCells()) if grid.GetCellData().GetArray("object").GetValue(k) == 1]
    assert len(ring) > 1
    for k in ring:
        for place in inner(3, 10):
            x, y, z = cell_point(grid, k, place)
            assert 10 - 1e-12 < np.hypot(x, y) < 20 + 1e-12 and -1e-12 < z < 5 + 1e-12 and y > -1e-12
    volumes = {"framed": sum(integral(grid, k) for k in [0]), "ring": sum(integral(grid, k) for k in ring)}
    assert abs(volumes["ring"] / (np.pi / 2 * 300 * 5) - 1) < 1e-12
    report = json.loads(program("report", model, "--json"))["objects"]
    for name, volume in volumes.items():
        assert abs(report[name]["volume"] / volume - 1) < 1e-12


def integral(grid, cell, count=20):
    """The volume of a cell: derivatives of the polynomials through VTK's points, which are rational functions of degree 2."""
    nodes = np.cos(np.pi * (np.arange(count) + 0.5) / count)
    values = np.empty((count,) * 3 + (3,))
    for index in np.ndindex(count, count, count):
        values[index] = cell_point(grid, cell, [(1 + nodes[k]) / 2 for k in index])
    to_coefficients = np.linalg.inv(chebyshev.chebvander(nodes, count - 1))
    derivative = chebyshev.chebvander(nodes, count - 2) @ chebyshev.chebder(to_coefficients)
    slopes = [np.moveaxis(np.tensordot(derivative, values, (1, axis)), 0, axis) for axis in range(3)]
    jacobian = np.einsum("...i,...i", np.cross(slopes[0], slopes[1]), slopes[2])
    x, w = np.polynomial.legendre.leggauss(count)
    between = chebyshev.chebvander(x, count - 1) @ to_coefficients
    for _ in range(3):
        jacobian = np.moveaxis(np.tensordot(between, jacobian, (1, 0)), 0, 2)
    return np.einsum("i,j,k,ijk", w, w, w, jacobian)


def bernstein(n, t):
    from math import comb

    return np.array([comb(n, i) * t**i * (1 - t) ** (n - i) for i in range(n + 1)])


def test_curves_and_faces_of_all_degrees_are_those_of_the_exact_json(built):
    objects = {
        "arc": {"type": "arc", "through": [[0, 0, 0], [3, 4, 1], [8, 1, 0]]},
        "circle": {"type": "circle", "center": [0, 0, 9], "radius": 2},
        "fair": {"type": "fair-spline", "points": [[0, 0, 0], [4, 1, 2], [6, 5, 0], [2, 6, 1]], "closed": True},
        "patch": {"type": "cyclide-patch", "corners": [[-4, -3], [4, -3], [-3, 4], [3, 4]], "frame": [[8, -1, 4], [-1, 4, 3]]},
        "tee": json.loads((Path(__file__).parents[2] / "examples" / "tee.json").read_text())["objects"],
    }
    tee = objects.pop("tee")
    objects.update(tee)
    _, path, exact = built("many", objects)
    grid = vtk_grid(path)
    kinds = [grid.GetCellType(k) for k in range(grid.GetNumberOfCells())]
    listed = grid.GetFieldData().GetAbstractArray("objects")
    names = [listed.GetValue(k) for k in range(listed.GetNumberOfValues())]
    assert names == list(exact["objects"]) and grid.GetFieldData().GetAbstractArray("units").GetValue(0) == "mm"
    faces = [
        patch
        for item in exact["objects"].values()
        for body in item.get("surfaces", [])
        for shell in body["shells"]
        for patch in shell["patches"]
    ]
    quads = [k for k, kind in enumerate(kinds) if kind == 77]
    assert len(quads) == len(faces) and {tuple(face["degrees"]) for face in faces} > {(2, 2)}
    size = max(np.abs(np.concatenate([face["control_points"] for face in faces])).max(), 1)
    for cell, face in zip(quads, faces):
        p, q = face["degrees"]
        points = np.array(face["control_points"]).reshape(p + 1, q + 1, 3)
        weights = np.array(face["weights"]).reshape(p + 1, q + 1)
        for s, t in inner(2):
            basis = np.outer(bernstein(p, s), bernstein(q, t)) * weights
            expected = np.einsum("ij,ijk", basis, points) / basis.sum()
            assert np.linalg.norm(cell_point(grid, cell, [s, t]) - expected) < 1e-12 * size
    # Curves by where they must be: on their circle, and through their points.
    of = lambda name: [k for k in range(len(kinds)) if kinds[k] == 75 and grid.GetCellData().GetArray("object").GetValue(k) == names.index(name)]
    for cell in of("circle"):
        for (t,) in inner(1):
            x, y, z = cell_point(grid, cell, [t])
            assert abs(np.hypot(x, y) - 2) < 1e-14 and abs(z - 9) < 1e-14
    ends = [cell_point(grid, cell, [0.0]) for cell in of("fair")]
    for point in objects["fair"]["points"]:
        assert min(np.linalg.norm(end - point) for end in ends) < 1e-12


def test_what_readers_need_stands_in_the_file(built):
    _, path, _ = built("head", {"b": {"type": "cyclide-volume", "corners": CORNERS}}, units="m")
    text = path.read_text()
    assert 'version="2.2"' in text and 'RationalWeights="RationalWeights"' in text
    assert 'HigherOrderDegrees="HigherOrderDegrees"' in text


def test_divided_blocks_are_plain_hexahedra_of_one_mesh(program, tmp_path):
    """The wall of a torus in cells: VTK's own volumes of them, and no node twice."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    torus = {"type": "cyclide", "a": 3, "mu": 1, "construction": True}
    layers = {"type": "layers", "of": "torus", "distances": [-0.5, 0], "cells": [8, 8, 3]}
    model = tmp_path / "wall.json"
    model.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"torus": torus, "wall": layers}}))
    for encoding in ("ascii", "base64"):
        path = tmp_path / f"{encoding}.vtu"
        program("build", model, "-o", path, "--vtu-cells", "linear", "--vtu-encoding", encoding)
        grid = vtk_grid(path)
        cells = grid.GetNumberOfCells()
        points = vtk_to_numpy(grid.GetPoints().GetData())
        assert {grid.GetCellType(k) for k in range(cells)} == {12}
        assert len(np.unique(points, axis=0)) == len(points) == cells // 3 * 4
        nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 8)
        # Nodes are on circles round the middle line of the tube, from the inner skin to the outer one.
        radius = np.hypot(np.hypot(points[:, 0], points[:, 1]) - 3, points[:, 2])
        assert radius.min() > 0.5 - 1e-14 and radius.max() < 1 + 1e-14
        a = points[nodes]
        # Six tetrahedra a cell, by the diagonal; the wall is 2 pi 3 (pi - pi/4), chords are within the tube by 2 (pi/32)^2/3 and so on.
        ways = [(1, 2), (2, 3), (3, 7), (7, 4), (4, 5), (5, 1)]
        volume = sum(np.einsum("ij,ij", a[:, i] - a[:, 0], np.cross(a[:, j] - a[:, 0], a[:, 6] - a[:, 0])) for i, j in ways) / 6
        assert abs(volume / (6 * np.pi * 0.75 * np.pi) - 1) < 0.02
        quality = {name: vtk_to_numpy(grid.GetCellData().GetArray(name)) for name in ("orthogonality", "scaled_jacobian", "aspect_ratio")}
        assert quality["orthogonality"].max() < 1e-13 and quality["scaled_jacobian"].min() > 0.9 and quality["aspect_ratio"].min() > 1
