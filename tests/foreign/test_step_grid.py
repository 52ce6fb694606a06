"""Grids of blocks in STEP as OpenCASCADE reads them: each block a solid, or the outer boundary as one with its hollow."""

import json

import numpy as np
import pytest
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.GProp import GProp_GProps
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_FACE, TopAbs_SHELL, TopAbs_SOLID
from OCP.TopExp import TopExp_Explorer

import step_modelling as modelling

A, MU = 40.0, [14.0, 17.0, 20.0]
GRID = {"type": "cyclide-grid", "whole": {"a": A, "mu": MU, "segments": [4, 4]}}
# Between two tori, by Pappus: 2 pi a times the area between two circles.
VOLUME = 2 * np.pi**2 * A * (MU[-1] ** 2 - MU[0] ** 2)


def count(shape, kind):
    search, found = TopExp_Explorer(shape, kind), 0
    while search.More():
        found += 1
        search.Next()
    return found


def volume(shape):
    properties = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, properties, 1e-10)
    return properties.Mass()


@pytest.fixture(scope="module", params=["blocks", "outer"])
def grid(request, program, tmp_path_factory):
    folder = tmp_path_factory.mktemp("grid")
    objects = {"grid": GRID}
    if request.param == "outer":
        objects = {"grid": {**GRID, "construction": True}, "skin": {"type": "coordinate-surfaces", "of": "grid", "outer": True}}
    (folder / "m.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", folder / "m.json", "-o", folder / "m.step")
    reader = STEPControl_Reader()
    with modelling.quiet():
        reader.ReadFile(str(folder / "m.step"))
        reader.TransferRoots()
    return request.param, reader.OneShape()


def test_solids_are_valid_and_have_the_volume(grid):
    kind, shape = grid
    assert BRepCheck_Analyzer(shape).IsValid()
    assert count(shape, TopAbs_SOLID) == (1 if kind == "outer" else 32)
    assert abs(volume(shape) / VOLUME - 1) < 1e-9


def test_the_outer_boundary_has_two_shells(grid):
    kind, shape = grid
    if kind == "outer":
        assert count(shape, TopAbs_SHELL) == 2 and count(shape, TopAbs_FACE) == 32
    else:
        assert count(shape, TopAbs_FACE) == 32 * 6
