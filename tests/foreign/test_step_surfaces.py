"""STEP bodies read by OpenCASCADE, against surfaces computed from the documents' input data alone."""

import json
import math

import numpy as np
import pytest

import surface_form as form
from conftest import ROOT
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_VERTEX
from step_faces import Edge, StepFaces, angle, distinct

POINTS_PER_FACE = 1000
# Of the model's size, as the project promises: a few roundings with a wide margin.
POINT_LIMIT = 1e-9
# Of the whole area.
AREA_LIMIT = 1e-9
READER_AREA_LIMIT = 1e-7
VOLUME_LIMIT = 1e-9
NORMAL_LIMIT = 1e-7
TOLERANCE_LIMIT = 1e-6


def revolved(r0, z0, r1, z1, dr, dz, u0=0.3, u1=2.0):
    """Corners and frame of a patch of revolution about the third axis; the frame's vectors are unit and perpendicular."""

    def at(r, z, u):
        return [r * math.cos(u), r * math.sin(u), z]

    n = math.hypot(dr, dz)
    frame = [[-math.sin(u0), math.cos(u0), 0.0], [dr * math.cos(u0) / n, dr * math.sin(u0) / n, dz / n]]
    return {"corners": [at(r0, z0, u0), at(r0, z0, u1), at(r1, z1, u0), at(r1, z1, u1)], "frame": frame}


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


_generator = np.random.default_rng(20)
LOW, HIGH = 0.3, 1.1
# name: (fields of the object, kinds of the surfaces read, (faces, edges, vertices) or None where faces are halved)
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
        None,
    ),
    # The reader integrates faces as wide as 150 degrees to 1e-4 only: those are halved until it finds its accuracy.
    **{f"oblique {k}": (oblique(_generator, 30 * k, 30 * k + 50), {"b-spline"}, None) for k in range(1, 5)},
    **{f"wide {k}": (oblique(_generator, 130, 170), {"b-spline"}, None) for k in range(4)},
}
EDGES = ("circle", "rational")


def built(program, folder, objects, *options):
    """The STEP file of a document and the program's entry about it."""
    document, path = folder / "model.json", folder / f"model{len(options)}.step"
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", document, "-o", path, "--json", *options))
    return path, report["files"][0]


def structure(step, closed):
    """Valid, tolerances, and every edge with as many faces as it should have."""
    assert step.valid
    size = step.size()
    assert step.tolerance <= TOLERANCE_LIMIT * size
    users = step.faces_of_edges()
    assert len(users) == len(step.edges)
    assert max(len(group) for group in users) <= 2
    free = sum(len(group) == 1 for group in users)
    assert free == 0 if closed else free > 0
    return size, users


def normals_across_joints(users, creases=0):
    """The largest angle between the normals of neighbours in the middle of their edges, but for this number of creases."""
    angles = []
    for group in users:
        if len(group) == 2:
            point = Edge(group[0][1]).point(0.5)
            angles.append(angle(*(face.normal_near(point, edge) for face, edge in group)))
    angles.sort()
    if creases:
        assert angles[-creases] > 0.1, "fewer creases"
    return angles[-creases - 1] if len(angles) > creases else 0.0


def assert_quaternion_form(step, size):
    """Random points of every face are on the patch in the quaternion form through its corners, with its normals: at equal
    parameters of rational faces, else at the nearest place."""
    generator = np.random.default_rng(11)
    for face in step.faces:
        if face.rational:
            x, y = generator.uniform(0.0, 1.0, (2, POINTS_PER_FACE))
            points, du, dv = face.rational.jet(*face.rational.scaled(x, y))
            expected, _, _, normals = face.rational.patch().jet(x, y)
            distance, own = np.linalg.norm(points - expected, axis=-1), np.cross(du, dv)
            own = own / np.linalg.norm(own, axis=-1, keepdims=True)
        else:
            points, own = face.points(POINTS_PER_FACE, generator)
            distance, normals = face.patch().locate(points)
        assert distance.max() <= POINT_LIMIT * size
        assert_parallel(own, normals)


def assert_parallel(own, normals):
    parallel = np.minimum(np.linalg.norm(own - normals, axis=-1), np.linalg.norm(own + normals, axis=-1))
    assert parallel.max() <= NORMAL_LIMIT


def assert_area(step, expected):
    own = sum(face.area() for face in step.faces)
    assert own == pytest.approx(expected, rel=AREA_LIMIT)
    assert step.area() == pytest.approx(expected, rel=READER_AREA_LIMIT)


def assert_volume(step, expected):
    assert sum(face.volume() for face in step.faces) == pytest.approx(expected, rel=VOLUME_LIMIT)
    assert step.volume() == pytest.approx(expected, rel=READER_AREA_LIMIT)


def assert_points(step, size, locate):
    """Random points of every face on the reference surface, normals parallel to its normals."""
    generator = np.random.default_rng(7)
    for face in step.faces:
        points, normals = face.points(POINTS_PER_FACE, generator)
        distance, expected = locate(points)
        assert distance.max() <= POINT_LIMIT * size
        assert_parallel(normals, expected)


@pytest.mark.parametrize("edges", EDGES)
@pytest.mark.parametrize("name", PATCHES)
def test_patch(name, edges, program, tmp_path):
    spec, kinds, counts = PATCHES[name]
    path, entry = built(program, tmp_path, {name: {"type": "cyclide-patch", **spec}}, "--step-edges", edges)
    step, patch = StepFaces(path), form.Patch(spec["corners"], *spec["frame"])
    size, users = structure(step, closed=False)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert {face.kind for face in step.faces} == kinds
    if counts:
        assert (len(step.faces), len(step.edges), len(step.vertices)) == counts
    assert len(step.shells) == 1
    # Circles and rational edges alike lie on analytic surfaces exactly; on rational ones the latter do.
    assert step.exactly_valid or (kinds == {"b-spline"} and edges == "circle")
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
    assert len(step.shells) == 3
    assert normals_across_joints(users) <= NORMAL_LIMIT
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


WHOLE = {
    # Closed surfaces that touch in their nodes: a solid each.
    "horn": {"a": 4, "c": 2, "mu": 2},
    "spindle": {"a": 4, "c": 1, "mu": 6},
    "spindle torus": {"a": 1, "mu": 2},
    "horn torus": {"a": 2, "mu": 2},
}


@pytest.mark.parametrize("name", WHOLE)
def test_whole_cyclides_with_nodes(name, program, tmp_path):
    spec = WHOLE[name]
    path, entry = built(program, tmp_path, {name: {"type": "cyclide", **spec}})
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert {face.kind for face in step.faces} == {"b-spline"}
    assert normals_across_joints(users) <= NORMAL_LIMIT
    a, c, mu = spec["a"], spec.get("c", 0), spec["mu"]
    assert_area(step, form.cyclide_area(a, c, mu))
    assert_points(step, size, lambda points: form.cyclide_distance(a, c, mu, points))


# Rings offset to horns and spindles: their nodes inside patches or on edges.
OFFSETS = {
    "horn": ({"a": 50, "c": 20, "mu": 32}, -20),
    "horn on edges": ({"a": 4, "c": 1, "mu": 2}, -2),
    "horn on edges by rounding": ({"a": 4, "c": 1, "mu": 2, "segments": [6, 4]}, -1.5),
    "spindle": ({"a": 4, "c": 1, "mu": 2}, 3),
}


@pytest.mark.parametrize("name", OFFSETS)
def test_offsets_with_nodes_are_the_solids_of_their_lobes(name, program, tmp_path):
    spec, distance = OFFSETS[name]
    ring = {"type": "cyclide", "construction": True, **spec}
    path, entry = built(program, tmp_path, {"ring": ring, name: {"type": "offset", "of": "ring", "distance": distance}})
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert entry["exact"] and entry["deviation"] <= 1e-12 * size
    assert (len(step.solids), len(step.shells)) == (2, 2)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    a, c, mu = spec["a"], spec["c"], spec["mu"] + distance
    assert_area(step, form.cyclide_area(a, c, mu))
    assert_points(step, size, lambda points: form.cyclide_distance(a, c, mu, points))


CYCLIDES = {
    "ring": ({"a": 6, "c": 2, "mu": 3.5}, "b-spline", 16),
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
    assert {face.kind for face in step.faces} == {kind}
    a, c, mu = spec["a"], spec.get("c", 0), spec["mu"]
    area, volume = form.cyclide_measures(a, c, mu)
    assert_area(step, area)
    assert_volume(step, volume)
    assert normals_across_joints(users) <= NORMAL_LIMIT
    if "axis" not in spec:
        assert_points(step, size, lambda points: form.cyclide_distance(a, c, mu, points))


def grid_on_cyclide(a, c, mu, th, ps):
    """Rows of points (th along a row) and the frame at the first."""
    points, _ = form.cyclide_point(a, c, mu, *np.meshgrid(th, ps))
    h = 1e-6
    along = [form.cyclide_point(a, c, mu, np.array(th[0] + x), np.array(ps[0] + y))[0] for x, y in ((h, 0), (-h, 0), (0, h), (0, -h))]
    return points, form.unit(along[0] - along[1]), form.unit(along[2] - along[3])


def turned_net():
    """A net that is no cyclide: a circular grid with a frame turned away from its edges."""
    points, v1, v2 = grid_on_cyclide(6, 2, 3.5, np.linspace(0.3, 1.4, 5), np.linspace(0.4, 1.6, 4))
    x = 0.15
    return points, math.cos(x) * v1 + math.sin(x) * v2, -math.sin(x) * v1 + math.cos(x) * v2


@pytest.mark.parametrize("edges", EDGES)
def test_net_and_its_offset_are_one_open_shell_each(edges, program, tmp_path):
    points, v1, v2 = turned_net()
    v1 = form.unit(v1)
    v2 = form.unit(v2 - np.dot(v1, v2) * v1)
    objects = {
        "skin": {"type": "cyclidic-net", "grid": points.tolist(), "frame": [v1.tolist(), v2.tolist()]},
        "inner": {"type": "offset", "of": "skin", "distance": -0.2},
    }
    path, _ = built(program, tmp_path, objects, "--step-edges", edges)
    step = StepFaces(path)
    size, users = structure(step, closed=False)
    assert (len(step.shells), len(step.faces)) == (2, 24)
    assert (len(step.edges), len(step.vertices)) == (2 * 31, 2 * 20)
    assert sum(len(group) == 1 for group in users) == 2 * 14, "only the rim is free"
    assert step.exactly_valid or edges == "circle"
    patches = form.net(points, v1, v2) + form.net(points, v1, v2, offset=-0.2)
    assert_area(step, sum(patch.area(4) for patch in patches))
    assert normals_across_joints(users) <= NORMAL_LIMIT

    def locate(points):
        found = [patch.locate(points[:1])[0][0] for patch in patches]
        return patches[int(np.argmin(found))].locate(points)

    assert_points(step, size, locate)


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


def test_thick_net_with_a_rim_is_a_solid(program, tmp_path):
    points, v1, v2 = turned_net()
    v1 = form.unit(v1)
    v2 = form.unit(v2 - np.dot(v1, v2) * v1)
    objects = {
        "skin": {"type": "cyclidic-net", "grid": points.tolist(), "frame": [v1.tolist(), v2.tolist()], "construction": True},
        "thick": {"type": "offset", "of": "skin", "distance": -0.2, "thick": True},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.shells), len(step.faces)) == (1, 1, 24 + 14)
    # The rim meets both skins in 14 edges, and itself in the corners of the grid.
    assert normals_across_joints(users, 2 * 14 + 4) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
    assert {face.kind for face in step.faces} <= {"b-spline", "cone", "cylinder", "plane"}
    # Between two parallel surfaces: the integral of the area over the distance, a quadratic in it.
    areas = [sum(p.area(4) for p in form.net(points, v1, v2, offset=h)) for h in (0.0, -0.1, -0.2)]
    expected = 0.2 / 6 * (areas[0] + 4 * areas[1] + areas[2])
    assert_volume(step, expected)


def test_inverted_torus_is_a_solid_cyclide(program, tmp_path):
    objects = {
        "torus": {"type": "cyclide", "a": 40, "mu": 14, "segments": [12, 6], "construction": True},
        "inverted": {"type": "transform", "of": "torus", "steps": [{"inversion": {"center": [75, 0, 20], "radius": 70}}]},
    }
    path, _ = built(program, tmp_path, objects)
    step = StepFaces(path)
    size, users = structure(step, closed=True)
    assert (len(step.solids), len(step.faces)) == (1, 72)
    assert step.volume() > 0
    assert normals_across_joints(users) <= NORMAL_LIMIT

    def locate(points):
        """Back through the inversion, which stretches by (r/d)^2."""
        v = points - np.array([75.0, 0.0, 20.0])
        d2 = np.sum(v * v, -1, keepdims=True)
        distance, normal = form.cyclide_distance(40, 0, 14, np.array([75.0, 0.0, 20.0]) + v * (4900 / d2))
        normal = normal - 2 * v * np.sum(v * normal, -1, keepdims=True) / d2
        return distance * d2[:, 0] / 4900, normal

    assert_points(step, size, locate)


MILLIMETRES = {"mm": 1.0, "m": 1000.0}
# Examples with surfaces: faces, edges and vertices of each shell, and whether each is closed.
EXAMPLES = {
    "patch": [((1, 4, 4), False)],
    "ring": [((64, 128, 64), True)],
    "inverted_torus": [((72, 144, 72), True)],
    "roof": [((400, 840, 441), False)] * 2,
    "handle": [((32, 64, 32), True)],
    "volume_faces": [((1, 4, 4), False)] * 6,
    "roof-40/outer": [((1600, 3280, 1681), False)],
    "roof-40/inner": [((1600, 3280, 1681), False)],
}


def counts(shape):
    return tuple(len(distinct(shape, kind)) for kind in (TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX))


@pytest.mark.parametrize("name", EXAMPLES)
def test_example(name, program, tmp_path):
    """Counts, shared edges, area, the surface of every face and the joints, of every example as its file is read."""
    path = tmp_path / "example.step"
    report = json.loads(program("build", ROOT / "examples" / f"{name}.json", "-o", path, "--json"))
    built = [entry for entry in report["objects"].values() if not entry.get("construction")]
    step, expected = StepFaces(path), EXAMPLES[name]
    size, users = structure(step, closed=all(closed for _, closed in expected))
    assert sorted((counts(shell), shell.Closed()) for shell in step.shells) == sorted(expected)
    # Every edge has two faces but those of the rim, as many as the report says.
    assert sum(len(group) == 1 for group in users) == sum(entry["free_edges"] for entry in built)
    # The reader converts to millimetres.
    assert_area(step, sum(entry["area"] for entry in built) * MILLIMETRES[report["units"]] ** 2)
    assert normals_across_joints(users, sum(entry["joints"]["creases"] for entry in built)) <= NORMAL_LIMIT
    assert_quaternion_form(step, size)
