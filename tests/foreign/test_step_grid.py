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

import step_modeling as modeling

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


def read(program, folder, objects, outer):
    """The shape of the STEP file of an object of blocks named `grid`, or of its outer boundary."""
    if outer:
        grid = {**objects["grid"], "construction": True}
        objects = {**objects, "grid": grid, "skin": {"type": "coordinate-surfaces", "of": "grid", "outer": True}}
    (folder / "m.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", folder / "m.json", "-o", folder / "m.step", "--step-faces", "split")
    reader = STEPControl_Reader()
    with modeling.quiet():
        reader.ReadFile(str(folder / "m.step"))
        reader.TransferRoots()
    return reader.OneShape()


@pytest.fixture(scope="module", params=["blocks", "outer"])
def grid(request, program, tmp_path_factory):
    kind = request.param
    return kind, read(program, tmp_path_factory.mktemp("grid"), {"grid": GRID}, kind == "outer")


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


def test_skins_are_closed_and_walls_are_sewn(program, tmp_path):
    objects = {"grid": {**GRID, "construction": True}, "skins": {"type": "coordinate-surfaces", "of": "grid", "u": [0, 1]}, "walls": {"type": "coordinate-surfaces", "of": "grid", "s": [0, 1]}}
    shape = read(program, tmp_path, objects, False)
    assert BRepCheck_Analyzer(shape).IsValid() and count(shape, TopAbs_SOLID) == 3
    # Three skins of 16 faces; four walls of 4 by 2.
    assert count(shape, TopAbs_FACE) == 3 * 16 + 4 * 8 and count(shape, TopAbs_SHELL) == 3 + 4
    text = (tmp_path / "m.step").read_text()
    assert all(f"'{name}'" in text for name in ["skins u=0 0", "skins u=0 1", "skins u=1", "walls s=0 3"])


def whole(a, c, mu):
    return {"grid": {"type": "cyclide-grid", "whole": {"a": a, "c": c, "mu": mu}}}


POLE = {"type": "cyclide-patch", "construction": True, "corners": [[10, 0, 0], [0, 10, 0], [0, 0, 10], [0, 0, 10]], "frame": [[0, 1, 0], [0, 0, 1]]}
# A wedge at the pole of a sphere, whose face there is a line; grids whose skins have nodes, at which sides are points.
COLLAPSED = {
    "wedge": ({"pole": POLE, "grid": {"type": "layers", "of": "pole", "distances": [0, 1]}}, np.pi / 6 * (11**3 - 10**3)),
    "horn torus": (whole(40, 0, [20, 40]), 2 * np.pi**2 * 40 * (40**2 - 20**2)),
    "node": (whole(40, 10, [10, 20]), None),
    "spindle": (whole(40, 10, [30, 45]), None),
    "horn": (whole(40, 20, [12, 18]), None),
}


def by_corners(at, frame):
    """A block of eight corners of which some coincide."""
    corners = [list(at(k & 1, k >> 1 & 1, k >> 2)) for k in range(8)]
    return {"grid": {"type": "cyclide-volume", "corners": corners, **({"frame": frame} if frame else {})}}


def pie(angle, height):
    def at(inwards, around, up):
        return (1 - inwards) * np.cos(angle * around), (1 - inwards) * np.sin(angle * around), height * up

    return at


def to_the_pole(angle, latitude, radius):
    def at(around, up, out):
        cosine, sine = (0, 1) if up else (np.cos(latitude), np.sin(latitude))
        return radius(out) * cosine * np.cos(angle * around), radius(out) * cosine * np.sin(angle * around), radius(out) * sine

    return at


POLE_SHELL, BALL = to_the_pole(1.3, -0.4, lambda out: 5 + out), to_the_pole(0.8, 0.2, lambda out: 3 * (1 - out))
# The same by their corners, one of which follows from the others.
COLLAPSED |= {
    "slice of a pie": (by_corners(pie(np.pi / 2, 1), None), np.pi / 4),
    "thin slice": (by_corners(pie(0.36, 1.5), [[-1, 0, 0], [0, 1, 0]]), 0.27),
    "shell to the pole": (by_corners(POLE_SHELL, [[0, 1, 0], [np.sin(0.4), 0, np.cos(0.4)]]), 1.3 / 3 * (6**3 - 5**3) * (1 + np.sin(0.4))),
    "part of a ball": (by_corners(BALL, [[0, 1, 0], [-np.sin(0.2), 0, np.cos(0.2)]]), 0.8 / 3 * 27 * (1 - np.sin(0.2))),
}


@pytest.mark.parametrize("name", COLLAPSED)
def test_blocks_with_sides_of_one_point_are_valid_solids(name, program, tmp_path):
    objects, exact = COLLAPSED[name]
    blocks, outer = (read(program, tmp_path, objects, kind) for kind in [False, True])
    report = json.loads(program("report", tmp_path / "m.json", "--json"))["objects"]["grid"]
    assert BRepCheck_Analyzer(blocks).IsValid() and count(blocks, TopAbs_SOLID) == report["blocks"]
    # OpenCASCADE integrates to about 1e-8 where a side is a point.
    assert abs(volume(blocks) / report["volume"] - 1) < 1e-6
    assert BRepCheck_Analyzer(outer).IsValid() and count(outer, TopAbs_SOLID) == 1
    assert abs(volume(outer) / report["volume"] - 1) < 1e-6
    assert exact is None or abs(report["volume"] / exact - 1) < 1e-9
