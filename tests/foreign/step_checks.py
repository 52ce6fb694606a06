"""What every STEP file of surfaces must keep, and documents of single objects."""

import json
import math

import numpy as np
import pytest
from scipy.spatial import cKDTree

import step_modeling as modeling
from quaternion_form import cross
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_VERTEX
from step_faces import Edge, angle, distinct

POINTS_PER_FACE = 1000
# Of the model's size, as the project promises: a few roundings with a wide margin.
POINT_LIMIT = 1e-9
# Of the whole area.
AREA_LIMIT = 1e-9
READER_AREA_LIMIT = 1e-7
VOLUME_LIMIT = 1e-9
NORMAL_LIMIT = 1e-7
# Volume of a cut, of the solid's: what OpenCASCADE's intersections keep.
CUT_LIMIT = 1e-6
TOLERANCE_LIMIT = 1e-6
# Kinds of edges that the program writes.
EDGES = ("circle", "rational")
# Fractions of an edge at which its two faces are compared.
PLACES = np.array([0.1, 0.3, 0.5, 0.7, 0.9])


def revolved(r0, z0, r1, z1, dr, dz, u0=0.3, u1=2.0):
    """Corners and frame of a patch of revolution about the third axis; the frame's vectors are unit and perpendicular."""

    def at(r, z, u):
        return [r * math.cos(u), r * math.sin(u), z]

    n = math.hypot(dr, dz)
    frame = [[-math.sin(u0), math.cos(u0), 0.0], [dr * math.cos(u0) / n, dr * math.sin(u0) / n, dz / n]]
    return {"corners": [at(r0, z0, u0), at(r0, z0, u1), at(r1, z1, u0), at(r1, z1, u1)], "frame": frame}


def built(program, folder, objects, *options):
    """The STEP file of a document and the program's entry about it."""
    document, path = folder / "model.json", folder / f"model{len(options)}.step"
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", document, "-o", path, "--step-faces", "split", "--json", *options))
    return path, report["files"][0]


def counts(shape):
    """Faces, edges and vertices; a pole counts as an edge of every face that ends in it."""
    return tuple(len(distinct(shape, kind)) for kind in (TopAbs_FACE, TopAbs_EDGE, TopAbs_VERTEX))


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
    """The largest angle between the normals of neighbors at five places of their edges, but for this number of creases."""
    angles = []
    for group in users:
        if len(group) == 2:
            points = np.array([Edge(group[0][1]).point(x) for x in PLACES])
            sides = [face.normals_near(points, edge, PLACES) for face, edge in group]
            angles.append([angle(a, b) for a, b in zip(*sides)])
    angles.sort(key=max)
    smooth = len(angles) - creases
    assert all(min(crease) > 0.1 for crease in angles[smooth:]), "fewer creases"
    return max(angles[smooth - 1]) if smooth > 0 else 0.0


def assert_quaternion_form(step, size, patch_of=None):
    """Random points of every face are on its patch in the quaternion form, with the patch's normals: at equal parameters of
    rational faces, else at the nearest place. The patch is the given one, else that through the corners of the face as read."""
    generator = np.random.default_rng(11)
    for face in step.faces:
        patch = patch_of(face) if patch_of else None
        if face.rational:
            x, y = generator.uniform(0.0, 1.0, (2, POINTS_PER_FACE))
            points, du, dv = face.rational.jet(*face.rational.scaled(x, y))
            expected, _, _, normals = face.rational.patch(patch).jet(x, y)
            distance, own = np.linalg.norm(points - expected, axis=-1), cross(du, dv)
            own = own / np.linalg.norm(own, axis=-1, keepdims=True)
        else:
            points, own = face.points(POINTS_PER_FACE, generator)
            distance, normals = (patch or face.patch()).locate(points)
        assert distance.max() <= POINT_LIMIT * size
        assert_parallel(own, normals)


def partners(step, patches, size):
    """For `assert_quaternion_form`: the patch of each face by the middle of its corners; each patch is that of one face."""
    assert len(patches) == len(step.faces)
    tree = cKDTree([np.mean(patch.a, axis=0) for patch in patches])
    distance, at = tree.query([face.middle_of_corners() for face in step.faces])
    assert distance.max() <= POINT_LIMIT * size
    assert sorted(at) == list(range(len(patches)))
    found = {id(face): patches[k] for face, k in zip(step.faces, at)}
    return lambda face: found[id(face)]


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


def assert_cuts(step, own, *tools, judged=True):
    """OpenCASCADE cuts the solid, of this volume, with each tool (a solid in its box), fuses and intersects it: valid shapes whose
    volumes add up. Whether its faces meet between their edges is judged too, which takes longest: for one solid of a kind."""
    if judged:
        assert modeling.faults(step.shape) == []
    for make_tool in tools:
        tool, volume, _ = make_tool(*modeling.box(step))
        found = {kind: make(step.shape, tool).Shape() for kind, make in modeling.OPERATIONS.items()}
        assert all(modeling.valid(shape) for shape in found.values())
        cut, fused, common = (modeling.volume(found[kind]) for kind in ("cut", "fuse", "common"))
        assert 0 < common < own
        assert cut + common == pytest.approx(own, rel=CUT_LIMIT)
        assert fused - cut == pytest.approx(volume, rel=CUT_LIMIT)


def assert_points(step, size, locate):
    """Random points of every face on the reference surface, normals parallel to its normals."""
    generator = np.random.default_rng(7)
    for face in step.faces:
        points, normals = face.points(POINTS_PER_FACE, generator)
        distance, expected = locate(points)
        assert distance.max() <= POINT_LIMIT * size
        assert_parallel(normals, expected)


def nearest(surfaces):
    """Of several surfaces, each a function from points to distances and normals, the one at the first of the points."""

    def locate(points):
        return min(surfaces, key=lambda surface: surface(points[:1])[0][0])(points)

    return locate
