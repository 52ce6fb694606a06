"""Pipes as OpenCASCADE reads them: analytic faces, the measures of Pappus, and what people do to a solid."""

import json
import math

import numpy as np
import pytest

import step_modeling as modeling
from conftest import ROOT
from step_checks import NORMAL_LIMIT, assert_area, assert_cuts, assert_points, assert_volume, nearest, normals_across_joints, structure
from step_faces import StepFaces

RUN = json.loads((ROOT / "examples/pipe.json").read_text())["objects"]["run"]
SHORT = {**RUN, "points": RUN["points"][:5]}
SKEW = {"type": "polyline", "points": [[0, 0, 0], [60, 0, 10], [70, 50, -20], [-10, 40, 30]], "closed": True, "construction": True}
# Middle line, pipe, radii of the outer side and the bore, kinds of the faces, creases.
PIPES = {
    "bore": (SHORT, {"radius": 14, "wall": 2}, (14, 12), {"cylinder", "torus", "plane"}, 16),
    "round": (RUN, {"radius": 14, "ends": "round"}, (14, 0), {"cylinder", "torus", "sphere"}, 0),
    "closed": ({**SKEW, "radius": 12}, {"radius": 4, "wall": 1}, (4, 3), {"cylinder", "torus"}, 0),
    "mitred": (SKEW, {"radius": 4}, (4, 0), {"cylinder"}, 16),
}


def spine(run):
    """Segments (from, to) and arcs (centre, from, across, angle) of a polyline whose corners are rounded, with its ends (point, way)."""
    points = np.array(run["points"], float)
    closed, radius = run.get("closed", False), run.get("radius", 0.0)
    count = len(points)
    cuts = {}
    arcs = []
    for k in range(count):
        if not closed and k in (0, count - 1):
            cuts[k] = points[k], points[k]
            continue
        u, v = points[k] - points[k - 1], points[(k + 1) % count] - points[k]
        u, v = u / np.linalg.norm(u), v / np.linalg.norm(v)
        angle = math.atan2(np.linalg.norm(np.cross(u, v)), u @ v)
        reach = radius * math.tan(angle / 2)
        cuts[k] = points[k] - reach * u, points[k] + reach * v
        if radius:
            inward = (v - u * (u @ v)) / math.sin(angle)
            arcs.append((cuts[k][0] + radius * inward, -inward, u, radius, angle))
    pairs = [(k, (k + 1) % count) for k in range(count if closed else count - 1)]
    segments = [(cuts[a][1], cuts[b][0]) for a, b in pairs]
    ends = [] if closed else [(points[0], points[1] - points[0]), (points[-1], points[-1] - points[-2])]
    return segments, arcs, [(p, way / np.linalg.norm(way)) for p, way in ends]


def feet(p, segments, arcs, infinite):
    """The nearest places of the spine to points; of infinite segments the places on their lines."""
    found = []
    for start, end in segments:
        way = end - start
        x = (p - start) @ way / (way @ way)
        found.append(start + np.outer(x if infinite else np.clip(x, 0, 1), way))
    for centre, off, along, radius, angle in arcs:
        x = np.clip(np.arctan2((p - centre) @ along, (p - centre) @ off), 0, angle)
        found.append(centre + radius * (np.outer(np.cos(x), off) + np.outer(np.sin(x), along)))
    return found


def located(run, radii, round_ends):
    """Distance from the tubes of all radii about the spine, and from its flat ends."""
    segments, arcs, ends = spine(run)
    infinite = not arcs  # mitred: what is beyond a corner lies on the line

    def tube(radius):
        def locate(p):
            places = np.stack(feet(p, segments, arcs, infinite))
            off = p - places
            lengths = np.linalg.norm(off, axis=-1)
            best = np.abs(lengths - radius).argmin(axis=0) if infinite else lengths.argmin(axis=0)
            rows = np.arange(len(p))
            length = lengths[best, rows]
            return np.abs(length - radius), off[best, rows] / length[:, None]

        return locate

    def plane(point, normal):
        return lambda p: (np.abs((p - point) @ normal), np.broadcast_to(normal, p.shape))

    return nearest([tube(r) for r in radii if r] + ([] if round_ends else [plane(*end) for end in ends]))


@pytest.fixture(scope="module", params=PIPES)
def pipe(request, program, tmp_path_factory):
    run, fields, radii, kinds, creases = PIPES[request.param]
    folder = tmp_path_factory.mktemp("pipe")
    objects = {"run": run, "pipe": {"type": "pipe", "of": "run", **fields}}
    (folder / "pipe.json").write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    report = json.loads(program("build", folder / "pipe.json", "-o", folder / "pipe.step", "--step-faces", "split", "--json"))
    length = report["objects"]["run"]["length"]
    return StepFaces(folder / "pipe.step"), length, {**fields, "run": run}, radii, kinds, creases


def test_pipes_are_what_pappus_says(pipe):
    step, length, fields, (outer, inner), kinds, creases = pipe
    size, users = structure(step, closed=True)
    assert len(step.solids) == 1 and step.exactly_valid
    assert {face.kind for face in step.faces} == kinds
    ends = {"flat": 2 * math.pi * (outer**2 - inner**2), "round": 4 * math.pi * outer**2}[fields.get("ends", "flat")]
    caps = {"flat": 0.0, "round": 4 / 3 * math.pi * outer**3}[fields.get("ends", "flat")]
    is_closed = fields["run"].get("closed", False)
    assert_area(step, 2 * math.pi * (outer + inner) * length + (0.0 if is_closed else ends))
    assert_volume(step, math.pi * (outer**2 - inner**2) * length + caps)
    assert_points(step, size, located(fields["run"], (outer, inner), fields.get("ends") == "round"))
    assert normals_across_joints(users, creases) <= NORMAL_LIMIT


def test_pipes_are_cut_and_measured(pipe):
    step, *_ = pipe
    assert_cuts(step, modeling.volume(step.shape), modeling.slab)
    low, high = modeling.box(step)
    middle = modeling.section(step.shape, 0.5 * (low + high), (0.0, 0.0, 1.0))
    points = modeling.wire_points(middle)
    assert len(points) > 0 and np.abs(points[:, 2] - 0.5 * (low + high)[2]).max() < 1e-6
