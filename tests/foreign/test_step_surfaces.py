"""STEP bodies read by OpenCASCADE, against surfaces computed from the documents' input data alone."""

import json
import math

import numpy as np
import pytest

import surface_form as form
from conftest import ROOT
from reference_objects import reported_area
from step_checks import (
    EDGES,
    NORMAL_LIMIT,
    assert_area,
    assert_points,
    assert_quaternion_form,
    assert_volume,
    built,
    counts,
    normals_across_joints,
    revolved,
    structure,
)
from step_faces import StepFaces

# Start, middle and end of the sides t=0, t=1, s=0, s=1.
SIDES = [[(x, 0.0) for x in (0.0, 0.5, 1.0)], [(x, 1.0) for x in (0.0, 0.5, 1.0)]]
SIDES += [[(y, x) for x, y in side] for side in SIDES]


def turn_between(a, b):
    """Angle between two tangents of a circle less than half a turn apart."""
    return math.atan2(np.linalg.norm(np.cross(a, b)), np.dot(a, b))


def oblique(generator, narrowest, widest):
    """A patch over random concircular corners with a random frame, whose widest edge is between these angles in degrees."""
    while True:
        angles = np.sort(generator.uniform(0, 2 * math.pi, 4))
        if np.diff([*angles, angles[0] + 2 * math.pi]).min() < 0.3:
            continue
        axes = np.linalg.qr(generator.normal(size=(3, 3)))[0]
        frame = np.linalg.qr(generator.normal(size=(3, 3)))[0]
        center, radius = generator.normal(size=3), generator.uniform(1, 5)
        at = [center + radius * (math.cos(x) * axes[0] + math.sin(x) * axes[1]) for x in angles]
        corners = [at[0], at[1], at[3], at[2]]
        patch = form.Patch(corners, frame[0], frame[1])
        x = np.linspace(0, 1, 4001)
        jets = [patch.jet(0.5 + 0 * x, x), patch.jet(x, 0.5 + 0 * x)]
        # Regular patches that stay near their corners; singular ones have a test of their own. Each speed depends on one
        # parameter only, up to a positive factor.
        turns = [np.sum(np.cross(fs, ft) * normal, -1) for _, fs, ft, normal in jets]
        far = max(np.linalg.norm(jet[0] - center, axis=-1).max() for jet in jets)
        slowest = min(abs(turn).min() / abs(turn).max() for turn in turns)
        ends = [[patch.jet(*(np.array(x) for x in place)) for place in side] for side in SIDES]
        along = [[jet[1 if k < 2 else 2] for jet in side] for k, side in enumerate(ends)]
        turn = max(sum(turn_between(side[i], side[i + 1]) for i in (0, 1)) for side in along)
        regular = all(np.all(turn > 0) or np.all(turn < 0) for turn in turns)
        if far < 12 * radius and regular and slowest > 1e-3 and narrowest < math.degrees(turn) < widest:
            return {"corners": [c.tolist() for c in corners], "frame": [v.tolist() for v in frame[:2]]}


def cut(columns, rows):
    """Faces, edges and vertices of a patch cut into so many columns and rows."""
    return columns * rows, columns * (rows + 1) + (columns + 1) * rows, (columns + 1) * (rows + 1)


def lobe(strips, round_=4):
    """Faces, edges and vertices of a lobe of so many strips between two nodes; the faces at a node have an edge in it."""
    faces, rings = strips * round_, (strips - 1) * round_
    return faces, faces + rings + 2 * round_, rings + 2


_generator = np.random.default_rng(20)
LOW, HIGH = 0.3, 1.1
# name: (fields of the object, kinds of the surfaces read, (faces, edges, vertices))
PATCHES = {
    "plane": (revolved(1, 0, 2, 0, 1, 0), {"plane"}, (1, 4, 4)),
    "cylinder": (revolved(2, -1, 2, 2, 0, 1), {"cylinder"}, (1, 4, 4)),
    "half a cylinder": (revolved(2, -1, 2, 2, 0, 1, 0.3, 0.3 + math.pi), {"cylinder"}, (2, 7, 6)),
    "cone": (revolved(2, -1, 1, 2, -1, 3), {"cone"}, (1, 4, 4)),
    "tip of a cone": (revolved(2, -1, 0, 2, -2, 3), {"cone"}, (1, 3, 3)),
    "sphere": (
        revolved(2 * math.cos(LOW), 2 * math.sin(LOW), 2 * math.cos(HIGH), 2 * math.sin(HIGH), -math.sin(LOW), math.cos(LOW)),
        {"sphere"},
        (1, 4, 4),
    ),
    "octant": (
        {"corners": [[2, 0, 0], [0, 2, 0], [0, 0, 2], [0, 0, 2]], "frame": [[0, 1, 0], [0, 0, 1]]},
        {"sphere"},
        (1, 3, 3),
    ),
    "inside of a torus": (revolved(3, 1, 2, 0, -1, 0), {"torus"}, (1, 4, 4)),
    "outside of a torus": (revolved(4.5, -1, 4.5, 1, 1, 1), {"torus"}, (1, 4, 4)),
    "example": (
        {"corners": [[-40, -30, 0], [40, -30, 0], [-30, 40, 0], [30, 40, 0]], "frame": [[8 / 9, -1 / 9, 4 / 9], [-1 / 9, 8 / 9, 4 / 9]]},
        {"b-spline"},
        cut(1, 1),
    ),
    # The reader integrates faces as wide as 150 degrees to 1e-4 only: those are halved until it finds its accuracy.
    **{
        f"oblique {k}": (oblique(_generator, 30 * k, 30 * k + 50), {"b-spline"}, cut(*halves))
        for k, halves in ((1, (1, 1)), (2, (1, 1)), (3, (2, 1)), (4, (2, 2)))
    },
    **{
        f"wide {k}": (oblique(_generator, 130, 170), {"b-spline"}, cut(*halves))
        for k, halves in enumerate(((2, 1), (1, 1), (2, 1), (2, 2)))
    },
}


@pytest.mark.parametrize("edges", EDGES)
@pytest.mark.parametrize("name", PATCHES)
def test_patch(name, edges, program, tmp_path):
    spec, kinds, expected = PATCHES[name]
    path, entry = built(program, tmp_path, {name: {"type": "cyclide-patch", **spec}}, "--step-edges", edges)
    step, patch = StepFaces(path), form.Patch(spec["corners"], *spec["frame"])
    size, users = structure(step, closed=False)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    # With rational edges all faces but planes are rational, and those halved that the reader would not integrate.
    rational = edges == "rational" and kinds != {"plane"}
    assert {face.kind for face in step.faces} == ({"b-spline"} if rational else kinds)
    found = (len(step.faces), len(step.edges), len(step.vertices))
    assert found == expected or (rational and kinds != {"b-spline"} and found[0] > expected[0])
    assert len(step.shells) == 1
    assert step.exactly_valid
    assert_area(step, patch.area())
    assert_points(step, size, patch.locate)
    assert normals_across_joints(users) <= NORMAL_LIMIT


def test_singular_patch_is_cut_at_its_nodes(program, tmp_path):
    """A wedge of a spindle torus: outer part, lemon, outer part, touching in the nodes."""
    a, b, u = 2 / 3 * math.pi - 0.5, 4 / 3 * math.pi + 0.5, (0.2, 1.4)
    spec = revolved(1 + 2 * math.cos(a), 2 * math.sin(a), 1 + 2 * math.cos(b), 2 * math.sin(b), -math.sin(a), math.cos(a), *u)
    path, _ = built(program, tmp_path, {"wedge": {"type": "cyclide-patch", **spec}})
    step = StepFaces(path)
    size, users = structure(step, closed=False)
    # The outer parts have one side in a node, the lemon has two; an edge in a node counts.
    assert sorted(counts(shell) for shell in step.shells) == [(1, 4, 2), (1, 4, 3), (1, 4, 3)]
    assert (len(step.faces), len(step.edges), len(step.vertices), step.poles) == (3, 8, 6, 4)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    assert_points(step, size, lambda points: form.cyclide_distance(1, 0, 2, points))
    # Pappus: the distance 1 + 2 cos x from the axis along the meridian, times the angle.
    node = 2 / 3 * math.pi
    outer, inner = 2 * (node + 2 * math.sin(node) - a - 2 * math.sin(a)), 4 * math.sin(node) - 2 * (math.pi - node)
    assert_area(step, (u[1] - u[0]) * 2 * (outer + inner))


# Major and minor radius of tori that meet or cross themselves, and the arc of the meridian: angles from the outer equator.
TOUCHING = {
    "lemon of a spindle": (1, 2, (2.3, 3.9)),
    "lemon to the pole": (1, 2, (3.5, 2 / 3 * math.pi)),
    "apple of a spindle": (1, 2, (0.4, 1.6)),
    "apple to the pole": (1, 2, (0.9, 2 / 3 * math.pi)),
    "horn": (2, 2, (0.5, 1.9)),
    "horn to the pole": (2, 2, (1.9, math.pi)),
    "almost a horn": (2.0000001, 2, (2.0, 2.9)),
}


@pytest.mark.parametrize("edges", EDGES)
@pytest.mark.parametrize("name", TOUCHING)
def test_tori_that_meet_themselves_are_the_right_part(name, edges, program, tmp_path):
    """Where a torus meets or crosses itself its two parts, or the sides of a node, are faces that readers confuse."""
    major, minor, (a, b) = TOUCHING[name]
    u = (0.2, 1.3)

    def at(x):
        # In the poles exactly on the axis.
        r = major + minor * math.cos(x)
        return (0.0 if abs(r) < 1e-12 else r), minor * math.sin(x)

    along = 1.0 if b > a else -1.0
    sign = 1.0 if at(0.5 * (a + b))[0] > 0 else -1.0
    spec = revolved(*at(a), *at(b), -along * math.sin(a), along * math.cos(a), *u)
    spec["frame"][0] = [sign * x for x in spec["frame"][0]]
    path, entry = built(program, tmp_path, {"part": {"type": "cyclide-patch", **spec}}, "--step-edges", edges)
    step = StepFaces(path)
    size, users = structure(step, closed=False)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert {face.kind for face in step.faces} == {"b-spline"}
    # Pappus: the distance from the axis along the meridian, times the angle. On the lemon it is negative all along.
    assert_area(step, (u[1] - u[0]) * minor * abs(major * (b - a) + minor * (math.sin(b) - math.sin(a))))
    assert normals_across_joints(users) <= NORMAL_LIMIT

    def locate(points):
        """Distance from the part's own circle in the half plane of each point, and the normal there."""
        r, z = np.hypot(points[:, 0], points[:, 1]), points[:, 2]
        # The half plane of a point of the lemon is that beyond the axis.
        x, y = sign * r - major, z
        across = np.hypot(x, y)
        n = np.stack([x / across * sign * points[:, 0] / r, x / across * sign * points[:, 1] / r, y / across], -1)
        return abs(across - minor), n

    assert_points(step, size, locate)
    middle = sign * np.array([math.cos(0.5 * (u[0] + u[1])), math.sin(0.5 * (u[0] + u[1]))])
    for face in step.faces:
        outward = face.points(50, np.random.default_rng(1))[0][:, :2]
        outward = outward / np.linalg.norm(outward, axis=-1, keepdims=True)
        assert np.all(outward @ middle > math.cos(0.5 * (u[1] - u[0])) - 1e-9), "on the other side of the axis"


# Closed surfaces that touch in their nodes, a solid each: the numbers of their strips, and of the faces round where not 4.
WHOLE = {
    "horn": ({"a": 4, "c": 2, "mu": 2}, [(8,)]),
    "spindle": ({"a": 4, "c": 1, "mu": 6}, [(2,), (4, 6)]),
    "spindle torus": ({"a": 1, "mu": 2}, [(2,), (4,)]),
    "horn torus": ({"a": 2, "mu": 2}, [(4,)]),
}


def assert_lobes(step, a, c, mu):
    """Area and volume are those of the lobes of a cyclide."""
    areas, volumes = zip(*form.cyclide_lobes(a, c, mu))
    assert_area(step, sum(areas))
    assert_volume(step, sum(volumes))


@pytest.mark.parametrize("name", WHOLE)
def test_whole_cyclides_with_nodes(name, program, tmp_path):
    spec, strips = WHOLE[name]
    path, entry = built(program, tmp_path, {name: {"type": "cyclide", **spec}})
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert {face.kind for face in step.faces} == {"b-spline"}
    assert sorted(counts(shell) for shell in step.shells) == [lobe(*n) for n in strips]
    assert len(step.solids) == len(strips)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    a, c, mu = spec["a"], spec.get("c", 0), spec["mu"]
    assert_lobes(step, a, c, mu)
    assert_points(step, size, lambda points: form.cyclide_distance(a, c, mu, points))


# Rings offset to horns and spindles, their nodes inside patches or on edges, and the strips of their lobes.
OFFSETS = {
    "horn": ({"a": 50, "c": 20, "mu": 32}, -20, [(2,), (6,)]),
    "horn on edges": ({"a": 4, "c": 1, "mu": 2}, -2, [(4,), (4,)]),
    "horn on edges by rounding": ({"a": 4, "c": 1, "mu": 2, "segments": [6, 4]}, -1.5, [(2,), (4,)]),
    "spindle": ({"a": 4, "c": 1, "mu": 2}, 3, [(2,), (4, 6)]),
}


@pytest.mark.parametrize("name", OFFSETS)
def test_offsets_with_nodes_are_the_solids_of_their_lobes(name, program, tmp_path):
    spec, distance, strips = OFFSETS[name]
    ring = {"type": "cyclide", "construction": True, **spec}
    path, entry = built(program, tmp_path, {"ring": ring, name: {"type": "offset", "of": "ring", "distance": distance}})
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert len(step.solids) == 2
    assert sorted(counts(shell) for shell in step.shells) == [lobe(*n) for n in strips]
    assert normals_across_joints(users) <= NORMAL_LIMIT
    a, c, mu = spec["a"], spec["c"], spec["mu"] + distance
    assert_lobes(step, a, c, mu)
    assert_points(step, size, lambda points: form.cyclide_distance(a, c, mu, points))


CYCLIDES = {
    "ring": ({"a": 6, "c": 2, "mu": 3.5}, "b-spline", 32),
    "torus": ({"a": 5, "mu": 2, "center": [1, 2, 3], "axis": [1, 2, 2]}, "torus", 16),
    "fine ring": ({"a": 6, "c": 2, "mu": 3.5, "segments": [12, 6]}, "b-spline", 72),
}


@pytest.mark.parametrize("edges", EDGES)
@pytest.mark.parametrize("name", CYCLIDES)
def test_whole_cyclide_is_a_solid(name, edges, program, tmp_path):
    spec, kind, faces = CYCLIDES[name]
    path, _ = built(program, tmp_path, {name: {"type": "cyclide", **spec}}, "--step-edges", edges)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.faces), len(step.edges), len(step.vertices)) == (faces, 2 * faces, faces)
    assert (len(step.solids), len(step.shells), step.poles) == (1, 1, 0)
    assert {face.kind for face in step.faces} == {"b-spline" if edges == "rational" else kind}
    a, c, mu = spec["a"], spec.get("c", 0), spec["mu"]
    area, volume = form.cyclide_measures(a, c, mu)
    assert_area(step, area)
    assert_volume(step, volume)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    if "axis" not in spec:
        assert_points(step, size, lambda points: form.cyclide_distance(a, c, mu, points))


def test_thick_torus_is_a_solid_with_a_hollow(program, tmp_path):
    objects = {
        "torus": {"type": "cyclide", "a": 5, "mu": 2, "construction": True},
        "thick": {"type": "offset", "of": "torus", "distance": 0.4, "thick": True},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells), len(step.faces)) == (1, 2, 32)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
    assert_volume(step, 2 * math.pi**2 * 5 * (2.4**2 - 2**2))
    assert_area(step, form.cyclide_measures(5, 0, 2)[0] + form.cyclide_measures(5, 0, 2.4)[0])


def test_inverted_torus_is_a_solid_cyclide(program, tmp_path):
    inversion = center, radius = (75.0, 0.0, 20.0), 70.0
    objects = {
        "torus": {"type": "cyclide", "a": 40, "mu": 14, "segments": [12, 6], "construction": True},
        "inverted": {"type": "transform", "of": "torus", "steps": [{"inversion": {"center": center, "radius": radius}}]},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    # Some are halved for the reader's integration.
    assert (len(step.solids), len(step.faces)) == (1, 84)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    area, volume = form.cyclide_measures(40, 0, 14, inversion)
    assert_area(step, area)
    assert_volume(step, volume)
    assert_points(step, size, form.inverted(lambda points: form.cyclide_distance(40, 0, 14, points), *inversion))


MILLIMETRES = {"mm": 1.0, "m": 1000.0}
# Examples with surfaces: faces, edges and vertices of each shell, and whether each is closed.
EXAMPLES = {
    "patch": [((1, 4, 4), False)],
    "ring": [((64, 128, 64), True)],
    "inverted_torus": [((84, 168, 84), True)],
    "roof": [((400, 840, 441), False)] * 2,
    "handle": [((32, 64, 32), True)],
    "volume_faces": [((1, 4, 4), False)] * 6,
    "roof-40/outer": [((1600, 3280, 1681), False)],
    "roof-40/inner": [((1600, 3280, 1681), False)],
}


@pytest.mark.parametrize("name", EXAMPLES)
def test_example(name, program, tmp_path):
    """Counts, shared edges, area, the surface of every face and the joints, of every example as its file is read."""
    path = tmp_path / "example.step"
    report = json.loads(program("build", ROOT / "examples" / f"{name}.json", "-o", path, "--step-faces", "split", "--json"))
    built = [entry for entry in report["objects"].values() if not entry.get("construction")]
    step, expected = StepFaces(path), EXAMPLES[name]
    size, users = structure(step, closed=all(closed for _, closed in expected))
    assert sorted((counts(shell), shell.Closed()) for shell in step.shells) == sorted(expected)
    # Every edge has two faces but those of the rim, as many as the report says.
    assert sum(len(group) == 1 for group in users) == sum(entry["free_edges"] for entry in built)
    # The reader converts to millimetres.
    assert_area(step, reported_area(built) * MILLIMETRES[report["units"]] ** 2)
    assert normals_across_joints(users, sum(entry["joints"]["creases"] for entry in built)) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
