"""Thick shells beyond focal sets, over poles and nodes, and turned inside out, as OpenCASCADE reads them."""

import json
import math

import pytest

from step_faces import StepFaces
from test_step_surfaces import VOLUME_LIMIT, assert_volume, built, revolved, structure

HALF = 0.6
# Unit cylinder over 2 HALF, height 2; unit sphere over 0.9 in longitude and 0 to 0.8 in latitude; an eighth of it.
CYLINDER = revolved(1, 0, 1, 2, 0, 1, -HALF, HALF)
SPHERE = revolved(1, 0, math.cos(0.8), math.sin(0.8), 0, 1, 0, 0.9)
OCTANT = {"corners": [[1, 0, 0], [0, 1, 0], [0, 0, 1], [0, 0, 1]], "frame": [[0, 1, 0], [0, 0, 1]]}
# A cone of half angle 45 degrees with its tip up, a quarter round.
CONE = revolved(1, 0, 0, 1, -1, 1, 0, math.pi / 2)


def patch(fields):
    return {"type": "cyclide-patch", "construction": True, **fields}


def offset(of, distance, **fields):
    return {"type": "offset", "of": of, "distance": distance, **fields}


# name: (objects before the thick shell `k` of `o`, thickness, volume, faces)
SOLIDS = {
    "behind the axis": ({"p": patch(CYLINDER), "o": offset("p", -1.5, construction=True)}, 0.2, 2 * HALF * (0.5**2 - 0.3**2), 6),
    "behind the centre": (
        {"p": patch(SPHERE), "o": offset("p", -1.5, construction=True)},
        0.2,
        0.9 * math.sin(0.8) * (0.5**3 - 0.3**3) / 3,
        6,
    ),
    "behind the circle of centres": (
        {"p": {"type": "cyclide", "a": 4, "mu": 1, "construction": True}, "o": offset("p", -2.5, construction=True)},
        0.2,
        2 * math.pi**2 * 4 * (1.5**2 - 1.3**2),
        32,
    ),
    "over a pole": ({"o": patch(OCTANT)}, 0.2, math.pi / 6 * (1.2**3 - 1), 5),
    # The layer over a cone: slant sqrt(2), area pi sqrt(2)/4, mean circumference grown by the normal's slope.
    "over a tip": ({"o": patch(CONE)}, 0.2, math.pi / 4 * (0.2 * math.sqrt(2) + 0.2**2), 6),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_thick_shell_is_a_solid(name, program, tmp_path):
    objects, thickness, volume, faces = SOLIDS[name]
    path, _ = built(program, tmp_path, {**objects, "k": offset("o", thickness, thick=True)})
    step = StepFaces(path)
    structure(step, closed=True)
    assert len(step.solids) == 1
    assert len(step.faces) == faces
    assert_volume(step, volume)


def test_hollow_turned_outside_is_a_solid_with_a_hollow(program, tmp_path):
    objects = {
        "torus": {"type": "cyclide", "a": 4, "mu": 1, "segments": [6, 6], "construction": True},
        "thick": offset("torus", -0.4, thick=True, construction=True),
        "out": {"type": "transform", "of": "thick", "steps": [{"inversion": {"center": [4, 0.2, 0.1], "radius": 1.5}}]},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    structure(step, closed=True)
    assert (len(step.solids), len(step.shells)) == (1, 2)
    # 36 faces on each side, some halved where edges are wide.
    assert len(step.faces) >= 72
    report = json.loads(program("report", tmp_path / "model.json", "--json"))
    # The reader's own integral of faces as wide as these is good to a few parts in a thousand.
    volume = sum(face.volume() for face in step.faces)
    assert volume == pytest.approx(report["objects"]["out"]["volume"], rel=VOLUME_LIMIT)
    assert step.volume() == pytest.approx(volume, rel=1e-2)
