"""Meshes as trimesh and, of 3MF, lib3mf see them, GLB files as the Khronos validator sees them."""

import json
import subprocess
from pathlib import Path

import numpy as np
import pytest
import trimesh

import surface_form as form

GLTF = Path(__file__).resolve().parent / "gltf"
A, C, MU = 50.0, 20.0, 32.0
RING = {"type": "cyclide", "a": A, "c": C, "mu": MU, "segments": [8, 8]}
PATCH = {
    "type": "cyclide-patch",
    "corners": [[-40, -30], [40, -30], [-30, 40], [30, 40]],
    "frame": [[8, -1, 4], [-1, 4, 3]],
}
ARC = {"type": "arc", "from": [0, 0, 50], "to": [10, 0, 50], "tangent": [1, 1, 0]}
SUFFIXES = ["glb", "obj", "stl", "ply", "3mf"]
NET = form.turned_net()
NET_OBJECT = form.net_document(*NET)
# All round a ring, both directions closed.
TURN = np.arange(8) * np.pi / 4
WHOLE_NET = form.grid_on_cyclide(6, 2, 3.5, TURN, TURN)


def thick(shell, distance):
    layer = {"type": "offset", "of": "shell", "distance": distance, "thick": True}
    return {"shell": dict(shell, construction=True), "layer": layer}


def lobes(a, c, mu):
    """Area and volume of all lobes together."""
    return np.sum(form.cyclide_lobes(a, c, mu), axis=0)


def thick_open_net():
    skins = [form.net(*NET, offset=h) for h in (0.0, -0.1, -0.2)]
    area = sum(patch.area(2) for patch in form.layer(skins[0], skins[2], 4))
    return area, form.simpson([sum(patch.area(2) for patch in skin) for skin in skins], -0.2)


def thick_closed_net():
    (inner, hollow), (outer, whole) = (form.cyclide_measures(6, 2, mu) for mu in (3.5, 3.9))
    return inner + outer, whole - hollow


INVERSION = (75, 0, 20), 70
# name: (objects, function to area and volume)
BODIES = {
    "torus": ({"torus": {"type": "cyclide", "a": 5, "mu": 2}}, lambda: form.cyclide_measures(5, 0, 2)),
    "horn": ({"horn": {"type": "cyclide", "a": 4, "c": 2, "mu": 1}}, lambda: lobes(4, 2, 1)),
    "spindle": ({"spindle": {"type": "cyclide", "a": 4, "c": 1, "mu": 6}}, lambda: lobes(4, 1, 6)),
    "inverted torus": (
        {
            "torus": {"type": "cyclide", "a": 40, "mu": 14, "construction": True},
            "inverted": {
                "type": "transform",
                "of": "torus",
                "steps": [{"inversion": dict(zip(("center", "radius"), INVERSION))}],
            },
        },
        lambda: form.cyclide_measures(40, 0, 14, INVERSION),
    ),
    "offset with nodes": (
        {
            "ring": {"type": "cyclide", "a": A, "c": C, "mu": MU, "construction": True},
            "offset": {"type": "offset", "of": "ring", "distance": -20},
        },
        lambda: lobes(A, C, MU - 20),
    ),
    "thick open net": (thick(NET_OBJECT, -0.2), thick_open_net),
    "thick closed net": (thick(form.net_document(*WHOLE_NET, closed=[True, True]), 0.4), thick_closed_net),
}


@pytest.fixture(scope="module")
def build(program, tmp_path_factory):
    """Builds a file of objects; gives its path and the report on it."""
    folder = tmp_path_factory.mktemp("meshes")

    def run(name, suffix, objects, *options, units="mm"):
        document, path = folder / f"{name}.json", folder / f"{name}.{suffix}"
        document.write_text(json.dumps({"cyclide": 1, "units": units, "objects": objects}))
        report = json.loads(program("build", document, "-o", path, "--json", *options))
        return path, report["files"][0]

    return run


def read_3mf(path):
    """The model of a 3MF file, without a single warning in strict mode, and its meshes."""
    import lib3mf

    model = lib3mf.get_wrapper().CreateModel()
    reader = model.QueryReader("3mf")
    reader.SetStrictModeActive(True)
    reader.ReadFromFile(str(path))
    assert reader.GetWarningCount() == 0
    listed, objects = model.GetMeshObjects(), []
    while listed.MoveNext():
        objects.append(listed.GetCurrentMeshObject())
    return model, objects


def load(path):
    """All triangles of a file in one mesh, vertices that are equal to the bit being one, and its curves."""
    if path.suffix == ".3mf":
        _, objects = read_3mf(path)
        assert all(own.IsManifoldAndOriented() for own in objects)
        meshes = [
            trimesh.Trimesh([p.Coordinates[:] for p in own.GetVertices()], [t.Indices[:] for t in own.GetTriangleIndices()], process=False)
            for own in objects
        ]
        return trimesh.util.concatenate(meshes), []
    placed = trimesh.load_scene(path, process=False).dump()
    curves = [g for g in placed if isinstance(g, trimesh.path.Path3D)]
    meshes = [g for g in placed if isinstance(g, trimesh.Trimesh)]
    if not meshes:
        return None, curves
    mesh = trimesh.util.concatenate(meshes)
    vertices, index = np.unique(mesh.vertices, axis=0, return_inverse=True)
    return trimesh.Trimesh(vertices, index.reshape(-1)[mesh.faces], process=False), curves


def assert_body(path, report, area, volume):
    """Closed, turned outward, and of this volume as far as a mesh within the bound of a surface of this area can be."""
    mesh, _ = load(path)
    scale = 1000.0 if path.suffix == ".glb" else 1.0  # GLB is in metres
    assert mesh.is_watertight and mesh.is_winding_consistent
    # The mesh is within the bound of the surface: a layer of that thickness on both sides.
    assert abs(mesh.volume * scale**3 - volume) <= 1.02 * report["bound"] * area
    assert mesh.volume > 0, "the normals point outward"
    return mesh


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("tolerance", [0.5, 0.01])
def test_a_closed_surface_is_watertight_with_its_volume(build, suffix, tolerance):
    path, report = build(f"ring-{tolerance}", suffix, {"ring": RING}, "--tolerance", tolerance)
    mesh = assert_body(path, report, *form.cyclide_measures(A, C, MU))
    assert mesh.euler_number == 0, "a ring has one hole"
    assert report["deviation"] <= report["bound"] <= tolerance + 1e-5


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("name", BODIES)
def test_a_body_is_watertight_with_its_volume(build, suffix, name):
    objects, measures = BODIES[name]
    path, report = build(name, suffix, objects)
    mesh = assert_body(path, report, *measures())
    # As fine as it is by default, so that the volume means something: 1e-4 of the model, and the rounding to f32 of GLB and STL.
    size = np.linalg.norm(mesh.extents) * (1000.0 if suffix == "glb" else 1.0)
    assert report["bound"] <= 1.001e-4 * size


@pytest.mark.parametrize("suffix", [suffix for suffix in SUFFIXES if suffix != "3mf"])
def test_an_open_surface_has_one_border(build, suffix):
    path, _ = build("patch", suffix, {"patch": PATCH}, "--tolerance", 0.05)
    mesh, _ = load(path)
    assert mesh.is_winding_consistent and not mesh.is_watertight
    assert mesh.euler_number == 1, "a disc"


def test_3mf_has_unit_names_and_dates_that_never_change(build):
    import zipfile

    objects = {"tube <1>": RING, "other": {"type": "cyclide", "a": 5, "mu": 2}}
    path, _ = build("printed", "3mf", objects, "--tolerance", 0.5, units="in")
    model, meshes = read_3mf(path)
    assert model.GetUnit().name == "Inch" and [own.GetName() for own in meshes] == list(objects)
    items, built = model.GetBuildItems(), 0
    while items.MoveNext():
        built += 1
    assert built == len(objects)
    with zipfile.ZipFile(path) as archive:
        assert archive.testzip() is None and [entry.date_time for entry in archive.infolist()] == [(1980, 1, 1, 0, 0, 0)] * 3


def test_ply_says_of_each_vertex_whose_it_is(build):
    path, _ = build("torus-quads", "ply", {"torus": {"type": "cyclide", "a": 5, "mu": 2}, "patch": PATCH}, "--tolerance", 0.05)
    head, body = path.read_bytes().split(b"end_header\n")
    words = head.decode().split()
    vertices, faces = (int(words[words.index(name) + 1]) for name in ("vertex", "face"))
    vertex = np.dtype([("place", "<f8", 3), ("normal", "<f4", 3), ("object", "<i4")])
    own = np.frombuffer(body, vertex, vertices)
    quads = np.frombuffer(body, np.dtype([("count", "u1"), ("corners", "<i4", 4)]), faces, vertices * vertex.itemsize)
    assert len(body) == vertices * vertex.itemsize + faces * quads.itemsize
    assert set(quads["count"]) == {4} and set(own["object"]) == {0, 1} and (np.diff(own["object"]) >= 0).all()
    assert "object 0: torus" in head.decode() and "units mm" in head.decode()
    # The normal is the way from the middle line of the tube, to single precision.
    torus = own[own["object"] == 0]
    middle = torus["place"] * [1, 1, 0]
    middle *= 5 / np.linalg.norm(middle, axis=1)[:, None]
    assert np.abs((torus["place"] - middle) / 2 - torus["normal"]).max() < 1e-7


def test_obj_has_quads(build):
    path, _ = build("ring-quads", "obj", {"ring": RING}, "--tolerance", 0.5)
    corners = [len(line.split()) - 1 for line in path.read_text().splitlines() if line.startswith("f ")]
    assert corners and set(corners) == {4}


def validate(*paths):
    done = subprocess.run(["node", "validate.cjs", *map(str, paths)], cwd=GLTF, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return [json.loads(line) for line in done.stdout.splitlines()]


def test_glb_passes_the_validator(build):
    far = dict(PATCH, corners=[[x + 3e4, y - 1e4, 5e4] for x, y in PATCH["corners"]])
    cases = [
        build("glb-patch", "glb", {"patch": PATCH}),
        build("glb-ring", "glb", {"ring": RING}),
        build("glb-curve", "glb", {"arc": ARC}),
        build("glb-all", "glb", {"arc": ARC, "patch": PATCH, "ring": RING}, units="in"),
        build("glb-far", "glb", {"patch": far}),
        build("glb-net", "glb", {"net": NET_OBJECT}),
        build("glb-thick", "glb", thick(NET_OBJECT, -0.2)),
        build("glb-edges", "glb", {"net": NET_OBJECT, "ring": RING}, "--glb-edges"),
    ]
    for issues in validate(*[path for path, _ in cases]):
        assert (issues["errors"], issues["warnings"]) == (0, 0), issues["messages"]


def segments(path):
    """Ends of the line segments of a GLB file, read by hand: trimesh joins all points in their order."""
    data = path.read_bytes()
    start = 20 + int.from_bytes(data[12:16], "little")
    document, buffer = json.loads(data[20:start]), data[start + 8 :]

    def numbers(accessor):
        entry = document["accessors"][accessor]
        kind, width = {5126: ("<f4", 3), 5125: ("<u4", 1)}[entry["componentType"]]
        at = document["bufferViews"][entry["bufferView"]]["byteOffset"]
        return np.frombuffer(buffer, kind, entry["count"] * width, at).reshape(-1, width)

    lines = [p for mesh in document["meshes"] for p in mesh["primitives"] if p["mode"] == 1]
    return [numbers(p["attributes"]["POSITION"]).astype(float)[numbers(p["indices"])[:, 0]].reshape(-1, 2, 3) for p in lines]


def test_edges_of_patches_are_lines_if_asked_for(build):
    objects = {"net": NET_OBJECT}
    assert not segments(build("glb-plain", "glb", objects)[0])
    (lines,) = segments(build("glb-lines", "glb", objects, "--glb-edges")[0])
    sides = np.array([[patch.length(side) for side in range(4)] for patch in form.net(*NET)]).reshape(3, 4, 4)
    length = sides[:, :, 0].sum() + sides[-1, :, 1].sum() + sides[:, :, 2].sum() + sides[:, -1, 3].sum()
    # Chords within 1e-4 of the model's size: shorter than their arcs by parts in ten thousand.
    assert np.linalg.norm(lines[:, 1] - lines[:, 0], axis=-1).sum() == pytest.approx(length, rel=5e-4)


def test_glb_stands_upright_in_metres(build):
    path, _ = build("glb-inch", "glb", {"arc": ARC, "ring": RING}, units="in")
    mesh, curves = load(path)
    assert len(curves) == 1
    inch = 0.0254
    low, high = mesh.bounds / inch
    assert high[0] - low[0] == pytest.approx(2 * (A + MU), abs=0.1)
    # Upright it is as high as its widest tube, of radius mu + c.
    assert high[1] - low[1] == pytest.approx(2 * (MU + C), abs=0.1)
    assert np.allclose(curves[0].bounds[:, 1] / inch, 50.0, atol=1e-4), "the arc is 50 inches up"


def test_the_validator_finds_faults(build, tmp_path):
    """The judge itself: a wrong bound is an error."""
    path, _ = build("glb-spoiled", "glb", {"patch": PATCH})
    data = path.read_bytes()
    at = data.index(b'"max":[') + len(b'"max":[')
    digit = next(i for i in range(at, len(data)) if data[i : i + 1].isdigit())
    spoiled = tmp_path / "spoiled.glb"
    spoiled.write_bytes(data[:digit] + (b"1" if data[digit : digit + 1] != b"1" else b"2") + data[digit + 1 :])
    assert validate(spoiled)[0]["errors"] > 0
