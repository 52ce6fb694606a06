"""MFEM meshes and G+Smo XML: our files against forms computed here, and against what these programs made of the same models, whose numbers were written down
once: `judges/analysis_readers.py` says how."""

import json
from pathlib import Path

import numpy as np
import pytest

from spline_files import Mesh, Xml
from volume_form import Block

NUMBERS = json.loads((Path(__file__).parent / "judges" / "analysis_readers.json").read_text())["documents"]
CORNERS = [[0, 0, 0], [60, 8, -6], [-10, 50, 4], [5, -6, 45]]


def built(program, folder, document):
    """The mesh, the XML and the report of a document."""
    model, mesh, xml = (folder / name for name in ("model.json", "o.mesh", "o.xml"))
    model.write_text(json.dumps(document))
    report = json.loads(program("build", model, "-o", mesh, "-o", xml, "--json"))
    return Mesh(mesh), Xml(xml), report


def test_a_block_is_what_its_corners_and_frame_say(program, tmp_path):
    frame = [[0.97, 0.12, -0.21]]
    frame.append(list(np.cross([0.3, 0.1, 1.0], frame[0])))
    block = {"type": "cyclide-volume", "corners": CORNERS, "inside": [1, 1.3, 0.8], "frame": frame}
    document = {"cyclide": 1, "units": "mm", "objects": {"b": block}}
    mesh, xml, report = built(program, tmp_path, document)
    rows = program("sample", tmp_path / "model.json", "--object", "b", "--count", "2").splitlines()[1:]
    own = Block([[float(v) for v in row.split(",")[3:6]] for row in rows], *frame)
    for patch in (mesh.patches[0], *xml.patches.values()):
        assert patch.degrees == [2, 2, 2] and patch.weights.min() > 0
        for place in np.random.default_rng(2).uniform(0, 1, (40, 3)):
            # Corners and frame are known to rounding; threefold products of it.
            assert np.linalg.norm(patch.point(place) - own.point(*place)) < 1e-12 * 60
        assert abs(patch.volume() / report["objects"]["b"]["volume"] - 1) < 1e-12


def size(patches):
    return max(np.abs(patch.net[..., :3] / patch.net[..., 3:]).max() for patch in patches)


@pytest.mark.parametrize("name", NUMBERS)
def test_the_programs_read_what_stands_in_the_files(program, tmp_path, name):
    read = NUMBERS[name]["read"]
    mesh, xml, report = built(program, tmp_path, NUMBERS[name]["document"])
    # Rounding of coordinates, threefold products of it.
    limit = 1e-12 * size(mesh.patches)
    # MFEM's elements are the spans of the patches, in their order.
    elements = [(patch, span) for patch in mesh.patches for span in spans_of(patch)]
    assert len(elements) == read["mfem"]["elements"]
    for element, place, point in read["mfem"]["rows"]:
        patch, span = elements[element]
        place = [low + (high - low) * x for (low, high), x in zip(span, place)]
        assert np.linalg.norm(patch.point(place) - point) < limit
    for reader in {"pygismo", "splinepy"} & read.keys():
        patches = xml.first()
        assert len(patches) == read[reader]["patches"]
        for patch, place, point in read[reader]["rows"]:
            assert np.linalg.norm(patches[patch].point(place) - point) < limit
    assert [len(xml.interfaces), len(xml.boundary)] == [read["pygismo"][key] for key in ("interfaces", "boundary")]
    assert read["mfem"]["wrong_orientations"] == 0
    boundary = mesh.lists["boundary"]
    assert len(boundary) == read["mfem"]["boundary"]
    assert sorted({row[0] for row in boundary}) == read["mfem"]["boundary_attributes"]
    if mesh.dimension == 3:
        # What MFEM integrated, by a rule of order 24.
        whole = sum(item["volume"] for item in report["objects"].values() if "blocks" in item)
        assert abs(read["mfem"]["measure"] / whole - 1) < 1e-12
        assert abs(sum(patch.volume() for patch in mesh.patches) / whole - 1) < 1e-12


def spans_of(patch):
    """The ranges of parameters between knots; of faces and blocks there is one."""
    if len(patch.knots) > 1:
        return [[(0.0, 1.0)] * len(patch.knots)]
    breaks = patch.spans(0)
    return [[pair] for pair in zip(breaks, breaks[1:])]


def side_nodes(patch, side):
    axis, end = divmod(side, 2)
    return patch.net.take(-end, axis).reshape(-1, 4)


def test_neighbors_share_corners_knots_and_control_points(program, tmp_path):
    """Layers round a closed tube: nothing hangs loose, and what is shared is the same on both sides."""
    mesh, xml, _ = built(program, tmp_path, NUMBERS["layers"]["document"])
    order = [0, 1, 3, 2, 4, 5, 7, 6]
    elements = [[corners[k] for k in order] for _, _, corners in mesh.lists["elements"]]
    places = {}
    for element, patch in zip(elements, mesh.patches):
        assert len(set(element)) == 8
        for corner, vertex in enumerate(element):
            node = patch.net[tuple(-(corner >> axis & 1) for axis in range(3))]
            places.setdefault(vertex, []).append(node)
    # Rounding: blocks have their corners to the bit, and weights by other sums.
    limit = 1e-12 * size(mesh.patches)
    assert sorted(places) == list(range(mesh.vertices))
    assert all(np.abs(np.array(nodes) - nodes[0]).max() < limit for nodes in places.values())
    # Only the inner skin and the outer one are free.
    assert {attribute for attribute, *_ in mesh.lists["boundary"]} == {5, 6}
    edges = {tuple(sorted(edge[1:])): edge[0] for edge in mesh.edges}
    assert len(edges) == len(mesh.edges)
    for element in elements:
        for axis in range(3):
            along = [k for k in range(8) if not k >> axis & 1]
            classes = {edges[tuple(sorted((element[k], element[k | 1 << axis])))] for k in along}
            assert len(classes) == 1
    # Interfaces of G+Smo: sides that are one, in the order that the directions say.
    for first, side, second, other, *rest in xml.interfaces:
        assert rest[:3] == [0, 1, 2] and all(rest[3:])
        difference = side_nodes(xml.patches[first], side - 1) - side_nodes(xml.patches[second], other - 1)
        assert np.abs(difference).max() < limit
    assert 2 * len(xml.interfaces) + len(xml.boundary) == 6 * len(xml.patches)


def test_names_and_units_stand_in_comments(program, tmp_path):
    document = {"cyclide": 1, "units": "in", "objects": {"a -- b <c>": {"type": "cyclide-volume", "corners": CORNERS}}}
    mesh, _, report = built(program, tmp_path, document)
    assert mesh.comments[:2] == ["# cyclide, units in", "# attribute 1: a -- b <c>"]
    assert "<!-- cyclide, units in -->" in (tmp_path / "o.xml").read_text()
    assert [file["exact"] for file in report["files"]] == [True, True]
