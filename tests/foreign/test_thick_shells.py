"""Thick shells beyond focal sets, over poles and nodes, and turned inside out, as OpenCASCADE reads them."""

import math

import pytest

import surface_form as form
from step_checks import (
    NORMAL_LIMIT,
    assert_area,
    assert_points,
    assert_volume,
    built,
    nearest,
    normals_across_joints,
    revolved,
    structure,
)
from step_faces import StepFaces

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


def layer(fields, start, thickness):
    """Areas and places of the faces between two offsets of a patch."""
    patches = [form.Patch(fields["corners"], *fields["frame"], offset=h) for h in (start, start + thickness)]
    return [(patch.area(), patch.locate) for patch in form.layer(*([patch] for patch in patches))]


def tori(major, *minors):
    return [(form.cyclide_measures(major, 0, r)[0], lambda p, r=r: form.cyclide_distance(major, 0, r, p)) for r in minors]


# name: (objects before the thick shell `k` of `o`, thickness, volume, faces, creases, areas and places of the surfaces)
SOLIDS = {
    "behind the axis": (
        {"p": patch(CYLINDER), "o": offset("p", -1.5, construction=True)},
        0.2,
        2 * HALF * (0.5**2 - 0.3**2),
        6,
        12,
        layer(CYLINDER, -1.5, 0.2),
    ),
    "behind the centre": (
        {"p": patch(SPHERE), "o": offset("p", -1.5, construction=True)},
        0.2,
        0.9 * math.sin(0.8) * (0.5**3 - 0.3**3) / 3,
        6,
        12,
        layer(SPHERE, -1.5, 0.2),
    ),
    "behind the circle of centres": (
        {"p": {"type": "cyclide", "a": 4, "mu": 1, "construction": True}, "o": offset("p", -2.5, construction=True)},
        0.2,
        2 * math.pi**2 * 4 * (1.5**2 - 1.3**2),
        32,
        0,
        tori(4, 1.5, 1.3),
    ),
    "over a pole": ({"o": patch(OCTANT)}, 0.2, math.pi / 6 * (1.2**3 - 1), 5, 9, layer(OCTANT, 0, 0.2)),
    # The layer over a cone: slant sqrt(2), area pi sqrt(2)/4, mean circumference grown by the normal's slope.
    "over a tip": ({"o": patch(CONE)}, 0.2, math.pi / 4 * (0.2 * math.sqrt(2) + 0.2**2), 6, 11, layer(CONE, 0, 0.2)),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_thick_shell_is_a_solid(name, program, tmp_path):
    objects, thickness, volume, faces, creases, surfaces = SOLIDS[name]
    path, entry = built(program, tmp_path, {**objects, "k": offset("o", thickness, thick=True)})
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert (len(step.solids), len(step.shells)) == (1, 1 if creases else 2)
    assert len(step.faces) == faces
    # The sides of a patch are creases, the joints of a whole surface are smooth.
    assert len(users) == (creases or 2 * faces)
    assert normals_across_joints(users, creases) <= NORMAL_LIMIT
    assert_volume(step, volume)
    assert_area(step, sum(area for area, _ in surfaces))
    assert_points(step, size, nearest([locate for _, locate in surfaces]))


def test_hollow_turned_outside_is_a_solid_with_a_hollow(program, tmp_path):
    inversion = center, radius = (4.0, 0.2, 0.1), 1.5
    objects = {
        "torus": {"type": "cyclide", "a": 4, "mu": 1, "segments": [6, 6], "construction": True},
        "thick": offset("torus", -0.4, thick=True, construction=True),
        "out": {"type": "transform", "of": "thick", "steps": [{"inversion": {"center": center, "radius": radius}}]},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells)) == (1, 2)
    # 36 faces on each side, some halved where edges are wide.
    assert len(step.faces) >= 72
    assert normals_across_joints(users) <= NORMAL_LIMIT
    # The tube's inside is outside now.
    (hollow_area, hollow), (area, whole) = (form.cyclide_measures(4, 0, r, inversion) for r in (1.0, 0.6))
    assert_area(step, hollow_area + area)
    assert_volume(step, whole - hollow)
    assert_points(step, size, nearest([form.inverted(locate, *inversion) for _, locate in tori(4, 1.0, 0.6)]))
