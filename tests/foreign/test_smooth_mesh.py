"""Smooth surfaces over triangles against their formulas, and their files as trimesh sees them."""

import io
import json

import numpy as np
import pytest
import trimesh

import smooth_form as form
from test_mesh import load, validate

SUFFIXES = ["glb", "obj", "stl"]


def bumpy():
    """A closed mesh without symmetries."""
    ball = trimesh.creation.icosphere(subdivisions=1, radius=20.0)
    x, y, z = ball.vertices.T / 20
    scale = 1 + 0.2 * np.sin(3 * x + 1) * np.cos(2 * y) + 0.1 * z
    return np.round(ball.vertices * scale[:, None] * [1.3, 1.0, 0.8], 3), ball.faces


def open_cap():
    """The upper part of it: a border all round."""
    points, triangles = bumpy()
    kept = triangles[(points[triangles][:, :, 2] > -2).all(axis=1)]
    used, index = np.unique(kept, return_inverse=True)
    return points[used], index.reshape(-1, 3)


def smooth(points, triangles, **fields):
    return {"type": "smooth-mesh", "vertices": points.tolist(), "triangles": triangles.tolist(), **fields}


@pytest.fixture(scope="module")
def build(program, tmp_path_factory):
    """Builds files of objects; gives their paths and the report."""
    folder = tmp_path_factory.mktemp("smooth")

    def run(name, suffixes, objects, *options, units="mm"):
        document, paths = folder / f"{name}.json", [folder / f"{name}.{suffix}" for suffix in suffixes]
        document.write_text(json.dumps({"cyclide": 1, "units": units, "objects": objects}))
        outputs = [word for path in paths for word in ("-o", path)]
        words = ("build", document, *outputs) if outputs else ("report", document)
        report = json.loads(program(*words, "--json", *options))
        return paths, report

    run.folder = folder
    return run


def samples(program, build, name, count):
    """Rows of triangle, two barycentric coordinates, point and normal."""
    text = program("sample", build.folder / f"{name}.json", "--object", name, "--count", count)
    return np.loadtxt(io.StringIO(text), delimiter=",", skiprows=1)


def test_points_are_those_of_the_formula(program, build):
    points, triangles = bumpy()
    build("bumpy", [], {"bumpy": smooth(points, triangles)})
    normals = form.angle_normals(points, triangles)
    rows = samples(program, build, "bumpy", 7)
    inside = rows[(rows[:, 1] > 0) & (rows[:, 2] > 0) & (rows[:, 1] + rows[:, 2] < 1 - 1e-9)]
    assert len(inside) == 10 * len(triangles)
    size = np.ptp(points, axis=0).max()
    for row in inside[::3]:
        triangle, a, b = triangles[int(row[0])], row[1], row[2]
        at = lambda a, b: form.patch(points[triangle], normals[triangle], [a, b, 1 - a - b])
        # The derivative along the sides is a central difference there: 1e-10 of the size.
        assert np.linalg.norm(at(a, b) - row[3:6]) < 1e-8 * size
        h = 1e-4
        normal = form.unit(np.cross(at(a + h, b) - at(a - h, b), at(a, b + h) - at(a, b - h)))
        # A central difference of step 1e-4 of third derivatives of some tens.
        assert np.linalg.norm(normal - row[6:9]) < 1e-5


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("tolerance", [0.5, 0.02])
def test_a_closed_mesh_is_watertight_with_its_volume(build, suffix, tolerance):
    points, triangles = bumpy()
    (path,), report = build(f"closed-{tolerance}", [suffix], {"m": smooth(points, triangles)}, "--tolerance", tolerance)
    (file,), measured = report["files"], report["objects"]["m"]
    mesh, _ = load(path)
    scale = 1000.0 if suffix == "glb" else 1.0
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.euler_number == 2
    assert file["proof"] == "sampled" and file["deviation"] <= file["bound"] <= tolerance * 1.0001
    assert abs(mesh.volume * scale**3 - measured["volume"]) <= 1.02 * file["bound"] * measured["area"]
    assert abs(mesh.area * scale**2 / measured["area"] - 1) < 0.05


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_an_open_mesh_keeps_its_border(build, suffix):
    points, triangles = open_cap()
    (path,), report = build("open", [suffix], {"m": smooth(points, triangles)}, "--tolerance", 0.05)
    mesh, _ = load(path)
    assert mesh.is_winding_consistent and not mesh.is_watertight and mesh.euler_number == 1, "a disc"
    measured = report["objects"]["m"]
    assert measured["volume"] is None and measured["free_edges"] > 0 and not measured["closed"]


@pytest.mark.parametrize("suffix", ["glb", "obj"])
def test_normals_are_those_of_the_surface(build, suffix):
    """Vertices of the mesh with the normals of the file, against the normal of the triangles around: nearer than these turn."""
    points, triangles = bumpy()
    (path,), _ = build("normals", [suffix], {"m": smooth(points, triangles)}, "--tolerance", 0.01)
    (mesh,) = trimesh.load_scene(path, process=False).dump()
    given = np.asarray(mesh.vertex_normals)
    assert np.allclose(np.linalg.norm(given, axis=1), 1, atol=1e-6)
    corners = given[mesh.faces]
    facets = np.cross(*(mesh.vertices[mesh.faces[:, k]] - mesh.vertices[mesh.faces[:, 0]] for k in (1, 2)))
    facets /= np.linalg.norm(facets, axis=1, keepdims=True)
    assert (np.einsum("ijk,ik->ij", corners, facets) > 0.9).all()


def test_glb_passes_the_validator(build):
    points, triangles = open_cap()
    (path,), _ = build("valid", ["glb"], {"m": smooth(points, triangles, crease_angle=0.4)}, "--tolerance", 0.1)
    (lines,), _ = build("lines", ["glb"], {"m": smooth(points, triangles)}, "--tolerance", 0.1, "--glb-edges")
    for issues in validate(path, lines):
        assert (issues["errors"], issues["warnings"]) == (0, 0), issues["messages"]


@pytest.mark.parametrize("suffix", ["ply", "stl", "obj", "glb"])
def test_meshes_of_other_programs_are_read(build, suffix):
    points, triangles = bumpy()
    # Coordinates that single precision holds, so that every format says the same; glTF has the second axis up and metres.
    points = points.astype(np.float32).astype(float)
    place = points[:, [0, 2, 1]] * [1, 1, -1] if suffix == "glb" else points
    mesh = trimesh.Trimesh(place, triangles, process=False)
    path = build.folder / f"input.{suffix}"
    mesh.export(path)
    objects = {"read": {"type": "smooth-mesh", "mesh": {suffix: path.name}}, "inline": smooth(points, triangles)}
    _, report = build(f"read-{suffix}", [], objects, units="m")
    read, inline = (report["objects"][name] for name in ("read", "inline"))
    assert [warning["reason"] for warning in read["warnings"]] == []
    for name in ("triangles", "vertices", "closed"):
        assert read[name] == inline[name]
    # Decimals of OBJ: eight digits.
    assert read["volume"] == pytest.approx(inline["volume"], rel=1e-7)


def test_ascii_ply_and_creases_of_a_file(build):
    """A box with a normal for each of its sides: every edge of the box is a crease."""
    box = trimesh.creation.box(extents=[4, 3, 2])
    faceted = trimesh.Trimesh(box.vertices[box.faces].reshape(-1, 3), np.arange(36).reshape(-1, 3), process=False)
    normals = np.repeat(box.face_normals, 3, axis=0)
    path = build.folder / "box.ply"
    faceted = trimesh.Trimesh(faceted.vertices, faceted.faces, vertex_normals=normals, process=False)
    path.write_bytes(trimesh.exchange.ply.export_ply(faceted, encoding="ascii", vertex_normal=True))
    _, report = build("box", [], {"box": {"type": "smooth-mesh", "mesh": {"ply": "box.ply"}, "normals": "file"}})
    measured = report["objects"]["box"]
    assert (measured["creases"], measured["vertices"], measured["closed"]) == (12, 8, True)
    assert measured["volume"] == pytest.approx(24.0, rel=1e-12) and measured["area"] == pytest.approx(52.0, rel=1e-12)


def test_step_is_refused_by_name(program, build):
    points, triangles = bumpy()
    build("refused", [], {"m": smooth(points, triangles)})
    document = build.folder / "refused.json"
    with pytest.raises(AssertionError, match="no-exact-form"):
        program("build", document, "-o", build.folder / "refused.step")
    assert not (build.folder / "refused.step").exists()
