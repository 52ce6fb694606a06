"""The workshop's lists of `cyclide schedule` recomputed from the STEP file of the same model as OpenCASCADE reads it, and its
drawings as ezdxf reads them."""

import csv
import json
import math

import ezdxf
import numpy as np
import pytest
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.GeomAbs import GeomAbs_CurveType as Curve
from OCP.TopAbs import TopAbs_EDGE, TopAbs_VERTEX
from OCP.TopoDS import TopoDS

from conftest import ROOT
from step_faces import Edge, StepFaces, distinct, vector

# Of lengths, areas and positions: what two programs' roundings leave of a model of this size.
LIMIT = 1e-9
DEPTH = -0.25
THICKNESS = 0.04
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)


def rows(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def point(row, name, unit="_m"):
    return np.array([float(row[f"{name}_{axis}{unit}"]) for axis in "xyz"])


def vertices(shape):
    return [vector(BRep_Tool.Pnt_s(TopoDS.Vertex(v))) for v in distinct(shape, TopAbs_VERTEX)]


def key(points):
    """A place by which a part is found again, whatever the order of its corners."""
    return tuple(np.round(np.mean(points, axis=0), 6) + 0.0)


def length(edge):
    """Gauss-Legendre on each half of the edge."""
    places = np.concatenate([0.25 + 0.25 * _NODES, 0.75 + 0.25 * _NODES])
    _, ways = Edge(edge).moving(places)
    return float(0.25 * np.concatenate([_WEIGHTS, _WEIGHTS]) @ np.linalg.norm(ways, axis=1))


class Workshop:
    def __init__(self, folder, step):
        self.folder, self.step = folder, step
        self.panels, self.edges, self.nodes, self.beams = (
            rows(folder / f"{name}.csv") for name in ("panels", "edges", "nodes", "beams")
        )
        self.totals = json.loads((folder / "schedule.json").read_text())


@pytest.fixture(scope="module")
def workshop(program, tmp_path_factory):
    """The example, with the skin alone as STEP."""
    folder = tmp_path_factory.mktemp("workshop")
    model = ROOT / "examples" / "canopy.json"
    program("schedule", model, "-o", folder / "lists", "--beam-depth", DEPTH)
    document = json.loads(model.read_text())
    document["objects"] = {"skin": document["objects"]["skin"]}
    (folder / "skin.json").write_text(json.dumps(document))
    program("build", folder / "skin.json", "-o", folder / "skin.step")
    # STEP in OpenCASCADE is in millimetres.
    return Workshop(folder / "lists", StepFaces(folder / "skin.step"))


MILLIMETRES = 1000.0


def test_panels_are_the_faces_of_the_step_file(workshop):
    faces = {key(vertices(face.shape)): face for face in workshop.step.faces}
    assert len(faces) == len(workshop.panels) == 48
    for row in workshop.panels:
        corners = np.array([point(row, f"corner_{corner}") for corner in ("00", "10", "01", "11")]) * MILLIMETRES
        face = faces[key(corners)]
        assert float(row["area_m2"]) * MILLIMETRES**2 == pytest.approx(face.area(), rel=LIMIT)
        # The farthest place from the plane of the corners, over a fine grid of the face.
        a, b, c = corners[:3]
        normal = np.cross(b - a, c - a)
        normal /= np.linalg.norm(normal)
        u0, u1, v0, v1 = face.box
        us, vs = np.meshgrid(np.linspace(u0, u1, 81), np.linspace(v0, v1, 81))
        points, _ = face.at_all(us, vs)
        height = np.abs((points - a) @ normal).max()
        sagitta = float(row["sagitta_m"]) * MILLIMETRES
        # Between places of the grid it is higher by a part of their distance squared at most.
        assert height - 1e-6 <= sagitta <= height * (1 + 1e-3)
    assert sum(float(row["area_m2"]) for row in workshop.panels) == pytest.approx(
        workshop.totals["totals"]["area"], rel=1e-12
    )


def test_edges_are_those_of_the_step_file(workshop):
    read = [TopoDS.Edge(edge) for edge in distinct(workshop.step.shape, TopAbs_EDGE)]
    edges = {key(vertices(edge)): edge for edge in read}
    nodes = {row["id"]: row for row in workshop.nodes}
    assert len(edges) == len(workshop.edges) == 8 * 7 + 9 * 6
    total = 0.0
    for row in workshop.edges:
        ends = [point(nodes[row[f"{end}_node"]], "position") * MILLIMETRES for end in ("start", "end")]
        edge = edges[key(ends)]
        found = length(edge)
        total += found / MILLIMETRES
        assert float(row["length_m"]) * MILLIMETRES == pytest.approx(found, rel=LIMIT)
        assert float(row["chord_m"]) * MILLIMETRES == pytest.approx(np.linalg.norm(ends[1] - ends[0]), rel=LIMIT)
        curve = BRepAdaptor_Curve(edge)
        assert (row["kind"], curve.GetType()) == ("arc", Curve.GeomAbs_Circle)
        circle = curve.Circle()
        radius = float(row["radius_m"]) * MILLIMETRES
        assert radius == pytest.approx(circle.Radius(), rel=LIMIT)
        assert float(row["sweep_rad"]) == pytest.approx(found / circle.Radius(), rel=LIMIT)
        assert point(row, "centre") * MILLIMETRES == pytest.approx(vector(circle.Location()), abs=LIMIT * radius)
        axis = np.array([float(row[f"axis_{k}"]) for k in "xyz"])
        along = vector(circle.Axis().Direction())
        assert abs(axis @ along) == pytest.approx(1.0, abs=LIMIT)
        # It turns right-handed about its axis from the start to the end.
        a, b = (end - vector(circle.Location()) for end in ends)
        assert np.cross(a, b) @ axis > 0
    assert total == pytest.approx(workshop.totals["totals"]["edge_length"], rel=1e-10)


def test_nodes_have_the_normals_of_the_faces(workshop):
    for row in workshop.nodes:
        here = point(row, "position") * MILLIMETRES
        normal = np.array([float(row[f"normal_{k}"]) for k in "xyz"])
        assert point(row, "offset_position") == pytest.approx(here / MILLIMETRES + THICKNESS * normal, abs=1e-12)
        for k in range(1, int(row["valence"]) + 1):
            beam = np.array([float(row[f"beam{k}_{axis}"]) for axis in "xyz"])
            assert np.linalg.norm(beam) == pytest.approx(1.0, abs=LIMIT)
            assert abs(beam @ normal) < LIMIT and abs(float(row[f"beam{k}_tilt_rad"])) < LIMIT
    # A face's normal at its first corner, by its own derivatives.
    faces = {key(vertices(face.shape)): face for face in workshop.step.faces}
    nodes = {row["id"]: row for row in workshop.nodes}
    for row in workshop.panels:
        corners = [point(row, f"corner_{corner}") * MILLIMETRES for corner in ("00", "10", "01", "11")]
        face = faces[key(corners)]
        u0, u1, v0, v1 = face.box
        found = [face.at(u, v) for u in (u0, u1) for v in (v0, v1)]
        for name, corner in zip(("00", "10", "01", "11"), corners):
            at, normal = min(found, key=lambda item: np.linalg.norm(item[0] - corner))
            assert np.linalg.norm(at - corner) < 1e-6
            own = np.array([float(nodes[row[f"node_{name}"]][f"normal_{k}"]) for k in "xyz"])
            assert own @ normal / np.linalg.norm(normal) == pytest.approx(1.0, abs=LIMIT)


def outline(entity):
    """Lengths of the parts of a closed polyline with bulges."""
    points = list(entity.get_points("xyb"))
    lengths = []
    for (x0, y0, bulge), (x1, y1, _) in zip(points, points[1:] + points[:1]):
        chord = math.hypot(x1 - x0, y1 - y0)
        sweep = 4 * math.atan(bulge)
        lengths.append(chord if sweep == 0 else chord * (0.5 * sweep) / math.sin(0.5 * sweep))
    return lengths


def parallel_length(workshop, row):
    """Length of the edge moved along the normals at both of its ends: the circle of the same axis through the moved ends. All normals
    along a line of curvature lean alike against its plane, so the moved edge is an arc of the same sweep."""
    nodes = {node["id"]: node for node in workshop.nodes}
    ends = []
    for end in ("start", "end"):
        node = nodes[row[f"{end}_node"]]
        normal = np.array([float(node[f"normal_{k}"]) for k in "xyz"])
        ends.append(point(node, "position") + DEPTH * normal)
    chord = np.linalg.norm(ends[1] - ends[0])
    half = 0.5 * float(row["sweep_rad"])
    return chord * half / math.sin(half)


def test_strips_are_as_long_as_the_edges_they_carry(workshop):
    drawing = ezdxf.readfile(workshop.folder / "beams.dxf")
    assert not drawing.audit().errors
    assert drawing.header["$INSUNITS"] == 6, "metres"
    assert {layer.dxf.name for layer in drawing.layers} >= {"CUT", "LABEL", "SCORE"}
    space = drawing.modelspace()
    strips = [entity for entity in space.query("LWPOLYLINE") if entity.dxf.layer == "CUT"]
    marks = [entity for entity in space.query("LWPOLYLINE") if entity.dxf.layer == "SCORE"]
    texts = [entity for entity in space.query("TEXT") if entity.dxf.layer == "LABEL"]
    assert len(strips) == len(marks) == len(texts) == len(workshop.edges) == len(workshop.beams)
    boxes = []
    for strip, mark, text, row in zip(strips, marks, texts, workshop.edges):
        assert text.dxf.text == row["id"] and strip.closed and text.dxf.rotation == 0
        far, end, near, start = outline(strip)
        assert near == pytest.approx(float(row["length_m"]), rel=LIMIT)
        assert far == pytest.approx(parallel_length(workshop, row), rel=LIMIT)
        assert end == pytest.approx(-DEPTH, rel=LIMIT) and start == pytest.approx(-DEPTH, rel=LIMIT)
        # The text lies within the strip: its box is inside the ring, sampled.
        border = np.array(list(strip.flattening(1e-4)) if hasattr(strip, "flattening") else strip.get_points("xy"))[:, :2]
        middle = np.array(text.get_placement()[1])[:2]
        wide, high = 0.5 * text.dxf.height * len(text.dxf.text), 0.5 * text.dxf.height
        for dx in (-wide, 0, wide):
            for dy in (-high, high):
                assert inside(middle + (dx, dy), border), f"{row['id']}: its name leaves the strip"
        boxes.append((border.min(axis=0), border.max(axis=0)))
    for i, (low, high) in enumerate(boxes):
        for other_low, other_high in boxes[:i]:
            assert (low > other_high).any() or (other_low > high).any(), "strips lie on each other"


def inside(p, border):
    """True for a point within a polygon."""
    crossings, n = 0, len(border)
    for k in range(n):
        (x0, y0), (x1, y1) = border[k], border[(k + 1) % n]
        if (y0 > p[1]) != (y1 > p[1]) and p[0] < x0 + (p[1] - y0) / (y1 - y0) * (x1 - x0):
            crossings += 1
    return crossings % 2 == 1


def test_the_plan_numbers_every_panel_where_it_is(workshop):
    drawing = ezdxf.readfile(workshop.folder / "plan.dxf")
    assert not drawing.audit().errors
    assert drawing.header["$INSUNITS"] == 6, "metres"
    space = drawing.modelspace()
    kinds = {"PLANE", "SPHERE", "CYLINDER", "CONE", "TORUS", "CYCLIDE"}
    numbers = {text.dxf.text: text for text in space.query("TEXT") if text.dxf.layer in kinds}
    assert len(numbers) == len(workshop.panels)
    boxes = []
    for row in workshop.panels:
        text = numbers[row["id"].removeprefix("skin-")]
        assert text.dxf.layer == row["kind"].upper() and text.dxf.rotation == 0
        corners = np.array([point(row, f"corner_{corner}")[:2] for corner in ("00", "10", "11", "01")])
        middle = np.array(text.get_placement()[1])[:2]
        half = 0.5 * text.dxf.height * np.array([len(text.dxf.text), 1.0])
        for sign in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
            assert inside(middle + half * sign, corners), f"{row['id']}: its number leaves the panel"
        boxes.append((middle - half, middle + half))
    lines = [entity for entity in space.query("LWPOLYLINE")]
    assert len(lines) == len(workshop.edges)
    assert sum(entity.dxf.layer == "BORDER" for entity in lines) == 2 * (8 + 6)


def distances(row, points):
    """Distances of points from the surface that a row says is near its panel."""
    kind = row["near_kind"]
    origin = point(row, "near_origin") * MILLIMETRES
    away = points - origin
    if kind == "sphere":
        return np.abs(np.linalg.norm(away, axis=-1) - float(row["near_radius_m"]) * MILLIMETRES)
    axis = np.array([float(row[f"near_axis_{k}"]) for k in "xyz"])
    height = away @ axis
    if kind == "plane":
        return np.abs(height)
    rho = np.linalg.norm(away - height[..., None] * axis, axis=-1)
    radius = float(row["near_radius_m"]) * MILLIMETRES
    if kind == "cylinder":
        return np.abs(rho - radius)
    if kind == "cone":
        half = float(row["near_half_angle_rad"])
        return np.abs((rho - radius) * math.cos(half) - height * math.sin(half))
    major = float(row["near_major_radius_m"]) * MILLIMETRES
    return np.minimum(*(np.abs(np.hypot(side * rho - major, height) - radius) for side in (1, -1)))


@pytest.mark.parametrize("tolerance", [0.02, 0.001])
def test_panels_are_as_near_their_moulds_as_said(tolerance, workshop, program, tmp_path):
    program("schedule", ROOT / "examples" / "canopy.json", "-o", tmp_path, "--tolerance", tolerance)
    faces = {key(vertices(face.shape)): face for face in workshop.step.faces}
    found = [row for row in rows(tmp_path / "panels.csv") if row["near_kind"]]
    assert found, "some panels are near a simple surface"
    for row in found:
        corners = [point(row, f"corner_{corner}") * MILLIMETRES for corner in ("00", "10", "01", "11")]
        face = faces[key(corners)]
        u0, u1, v0, v1 = face.box
        us, vs = np.meshgrid(np.linspace(u0, u1, 61), np.linspace(v0, v1, 61))
        largest = distances(row, face.at_all(us, vs)[0]).max()
        said = float(row["near_distance_m"]) * MILLIMETRES
        assert said <= tolerance * MILLIMETRES * (1 + LIMIT)
        # Coordinates and radii of some ten thousand millimetres are rounded; between places of the grid it is a little farther.
        assert largest - 1e-7 <= said <= largest * (1 + 5e-3) + 1e-7, row["id"]


def test_flat_patterns_have_the_area_and_the_sides_of_their_panels(program, tmp_path):
    grid = [
        [[-4 * math.cos(math.pi * i / 6), 2.0 * j, 4 * math.sin(math.pi * i / 6)] for i in range(7)] for j in range(3)
    ]
    document = tmp_path / "vault.json"
    objects = {"vault": {"type": "cyclidic-net", "grid": grid}}
    document.write_text(json.dumps({"cyclide": 1, "units": "m", "objects": objects}))
    program("schedule", document, "-o", tmp_path / "lists")
    program("build", document, "-o", tmp_path / "vault.step")
    step = StepFaces(tmp_path / "vault.step")
    faces = {key(vertices(face.shape)): face for face in step.faces}
    drawing = ezdxf.readfile(tmp_path / "lists" / "patterns.dxf")
    assert not drawing.audit().errors and drawing.header["$INSUNITS"] == 6
    space = drawing.modelspace()
    outlines = [entity for entity in space.query("LWPOLYLINE") if entity.dxf.layer == "CUT"]
    panels = rows(tmp_path / "lists" / "panels.csv")
    assert [text.dxf.text for text in space.query("TEXT")] == [row["id"] for row in panels]
    assert len(outlines) == len(panels) == len(faces) == 12
    for row, cut in zip(panels, outlines):
        corners = [point(row, f"corner_{corner}") * MILLIMETRES for corner in ("00", "10", "01", "11")]
        face = faces[key(corners)]
        places = np.array([(x, y) for x, y in cut.get_points("xy")])
        x, y = places.T
        area = 0.5 * abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)))
        assert area * MILLIMETRES**2 == pytest.approx(face.area(), rel=LIMIT)
        sides = sorted(outline(cut))
        read = sorted(length(edge) / MILLIMETRES for edge in face.edges)
        assert sides == pytest.approx(read, rel=LIMIT)
