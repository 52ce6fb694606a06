"""The published schema against the program: what a validator of JSON Schema accepts and refuses, cyclide does too."""

import json
import subprocess
from pathlib import Path

import jsonschema
import pytest

from conftest import MODELS, ROOT, program_path

SCHEMA = json.loads((ROOT / "docs" / "schema" / "cyclide-1.schema.json").read_text())
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
DOCUMENTS = {**MODELS, **{p.stem: p for p in sorted((ROOT / "examples").rglob("*.json"))}}

ARC = {"type": "arc", "from": [0, 0], "to": [1, 0], "bulge": 0.5}
SECOND = {"type": "arc", "from": [0, 2], "to": [1, 2], "bulge": 0.2}
SPLINE = {"type": "circle-spline", "points": [[0, 0], [1, 0], [1, 1]]}
FIT = {"type": "arc-fit", "points": [[0, 0], [1, 0], [1, 1]], "tolerance": 0.1}
CIRCLE = {"type": "circle", "center": [0, 0], "radius": 1}
BIARC = {"type": "biarc", "from": [0, 0], "from_tangent": [1, 0], "to": [1, 1], "to_tangent": [1, 0]}

PATCH = {"type": "cyclide-patch", "corners": [[0, 0], [1, 0], [0, 1], [1, 1]], "frame": [[1, 0, 1], [0, 1]]}
CYCLIDE = {"type": "cyclide", "a": 3, "mu": 2}
NET = {"type": "cyclidic-net", "grid": [[[0, 0], [1, 0], [3, 0]], [[0, 1], [1, 1], [3, 1]]]}
BRANCH = {"radius": 8, "length": 30, "blend": 2}
TEE = {"type": "pipe-tee", "main": {"radius": 12, "ends": [-40, 40]}, "branches": [BRANCH]}
PIPE = {"radius": 12, "ends": [-40, 40]}
CROSSING = {"type": "pipe-crossing", "pipes": [PIPE, PIPE], "distance": 18, "blend": 3}
CONTACT = {"type": "contact-blend", "tube": {"radius": 9, "length": 60}, "sphere": 30, "blend": 4}
NECK = {"type": "plate-with-neck", "pipe_radius": 9, "ball_radius": 4, "height": 40, "plate": [60, 50]}
BRIDGE = {"type": "ellipse-bridge", "ellipses": [[10, 20], [20, 25]]}
STEPS = [
    {"translation": [1, 0]},
    {"rotation": {"angle": 1, "axis": [0, 1, 0], "center": [1, 1]}},
    {"scale": {"factor": 2}},
    {"mirror": {"normal": [1, 0]}},
    {"inversion": {"center": [9, 9], "radius": 1}},
    {"matrix": [[[1, 0, 0, 0], [0, 1, 0, 0]], [[0, 0, 0, 0], [1, 0, 0, 0]]]},
]


def without(fields, *names):
    return {k: v for k, v in fields.items() if k not in names}


GOOD = {
    "arc through points": {"type": "arc", "through": [[0, 0], [1, 1], [2, 0, 1]]},
    "arc with weights": {**without(ARC, "bulge"), "weights": [[1, 0, 0, 0], [1, 0, 0, 1]]},
    "arc with a normal": {**ARC, "normal": [0, 1, 1]},
    "circle": CIRCLE,
    "circle through three points": {"type": "circle", "through": [[0, 0], [1, 1], [2, 0, 1]]},
    "object with a comment": {**CIRCLE, "comment": "a hole"},
    "object with comments": {**CIRCLE, "comment": ["a hole", "for a bolt"]},
    "biarc": {**BIARC, "rule": "equal-chord"},
    "contours": {**SPLINE, "points": [[[0, 0], [1, 0], [1, 1]], [[5, 5], [6, 6]]]},
    "clamped": {**SPLINE, "ends": {"start": [0, 1]}, "order": 4, "variant": "trigonometric", "corner_angle": 1.5},
    "natural": {**SPLINE, "ends": "natural", "closed": True},
    "fit": {**FIT, "target": "polyline", "effort": "fast", "corner_angle": 3},
    "construction": {**CIRCLE, "construction": True},
    "patch": PATCH,
    "cyclide": CYCLIDE,
    "cyclide somewhere": {**CYCLIDE, "c": 1, "center": [1, 2], "axis": [0, 1], "x_direction": [0, 0, 1], "segments": [5, 4]},
    "net": NET,
    "net with a frame": {**NET, "frame": [[1, 0], [0, 1]], "closed": [False, False]},
    "net made circular": {**NET, "make_circular": True},
    "net made circular with its border": {**NET, "make_circular": {"border": "free", "max_steps": 5}},
    "net with a frame that is chosen": {**NET, "frame": "auto"},
    "patch with its frame elsewhere": {**PATCH, "frame": [[1, 0], [0, 1]], "frame_corner": 3},
    "neck": NECK,
    "neck on a disk": {**NECK, "plate": {"radius": 30}, "slope": {"degrees": 10}, "variant": "vertical", "thickness": 3, "wall": 2},
    "neck inside": {**without(NECK, "plate"), "side": "inside", "thickness": 3},
    "tee": TEE,
    "tee with a wall and laws": {**TEE, "wall": 2, "ends": "closed", "branches": [{**BRANCH, "angle": {"degrees": 60}, "offset": 1, "azimuth": 0.5, "blend": {"crotch": 4, "flank": 3}}]},
    "tee with values": {**TEE, "branches": [{**BRANCH, "blend": {"values": [{"angle": {"degrees": 90}, "radius": 3}]}}]},
    "crossing": CROSSING,
    "tube on a sphere": CONTACT,
    "tube on a plate": {**without(CONTACT, "sphere"), "plate": [60, 50], "thickness": 4},
    "ring on a sphere": {**without(CONTACT, "tube"), "ring": {"radius": 30, "tube": 8, "height": 2}},
    "ring on a plate": {**without(CONTACT, "tube", "sphere"), "ring": {"radius": 30, "tube": 8}, "plate": {"radius": 60}, "thickness": 4},
    "tube that ends at a plane": {**without(CONTACT, "sphere"), "side": "inside", "wall": 2},
    "crossing with a wall": {**CROSSING, "wall": 2, "ends": "closed", "tolerance": 0.01, "angle": {"degrees": 60}},
    "bridge": BRIDGE,
    "bridge with walls": {**BRIDGE, "depth": 3},
    "tangents": {"type": "arc-spline", "points": [[0, 0], [1, 1]], "tangents": [[1, 0], [0, 1, 0]], "rule": "auto"},
}

BAD = {
    "no type": without(CIRCLE, "type"),
    "unknown type": {**CIRCLE, "type": "sphere"},
    "unknown field": {**CIRCLE, "colour": "red"},
    "missing field": without(CIRCLE, "radius"),
    "circle twice": {**CIRCLE, "through": [[0, 0], [1, 1], [2, 0]]},
    "circle with points and a normal": {"type": "circle", "through": [[0, 0], [1, 1], [2, 0]], "normal": [0, 0, 1]},
    "comment that is no text": {**CIRCLE, "comment": 7},
    "comment of numbers": {**CIRCLE, "comment": ["a", 7]},
    "null": {**CIRCLE, "normal": None},
    "text for a number": {**CIRCLE, "radius": "1"},
    "radius zero": {**CIRCLE, "radius": 0},
    "one coordinate": {**CIRCLE, "center": [0]},
    "four coordinates": {**CIRCLE, "center": [0, 0, 0, 0]},
    "arc without a datum": without(ARC, "bulge"),
    "arc with two data": {**ARC, "tangent": [0, 1]},
    "arc both ways": {**ARC, "through": [[0, 0], [1, 1], [2, 0]]},
    "arc through points with a bulge": {"type": "arc", "through": [[0, 0], [1, 1], [2, 0]], "bulge": 1},
    "normal without a bulge": {**without(ARC, "bulge"), "tangent": [0, 1], "normal": [0, 0, 1]},
    "two points": {"type": "arc", "through": [[0, 0], [1, 1]]},
    "weights of three numbers": {**without(ARC, "bulge"), "weights": [[1, 0, 0], [1, 0, 0]]},
    "order 0": {**SPLINE, "order": 0},
    "order 5": {**SPLINE, "order": 5},
    "order 1.5": {**SPLINE, "order": 1.5},
    "ends of another kind": {**SPLINE, "ends": "free"},
    "ends with another field": {**SPLINE, "ends": {"middle": [0, 1]}},
    "no points": {**SPLINE, "points": []},
    "points and contours": {**SPLINE, "points": [[0, 0], [[1, 1], [2, 2]]]},
    "file with another field": {**SPLINE, "points": {"csv": "p.csv", "sheet": 1}},
    "corner angle 0": {**SPLINE, "corner_angle": 0},
    "corner angle above a half turn": {**SPLINE, "corner_angle": 4},
    "fit without a tolerance": without(FIT, "tolerance"),
    "fit with tolerance 0": {**FIT, "tolerance": 0},
    "fit with a rule": {**FIT, "rule": "auto"},
    "construction in words": {**CIRCLE, "construction": "yes"},
    "patch with three corners": {**PATCH, "corners": [[0, 0], [1, 0], [0, 1]]},
    "patch without a frame": without(PATCH, "frame"),
    "frame of one direction": {**PATCH, "frame": [[1, 0]]},
    "frame at a fifth corner": {**PATCH, "frame_corner": 4},
    "cyclide without mu": without(CYCLIDE, "mu"),
    "cyclide with a negative radius": {**CYCLIDE, "mu": -1},
    "cyclide with half a segment": {**CYCLIDE, "segments": [4, 0.5]},
    "net without a grid": without(NET, "grid"),
    "net with one row": {**NET, "grid": NET["grid"][:1]},
    "net with half a frame": {**NET, "frame": [[1, 0]]},
    "net with a frame in words": {**NET, "frame": "best"},
    "net made circular in words": {**NET, "make_circular": "yes"},
    "net with another border": {**NET, "make_circular": {"border": "loose"}},
    "net with an unknown side": {**NET, "make_circular": {"border": {"left": "a"}}},
    "net made circular in no steps": {**NET, "make_circular": {"max_steps": 0}},
    "net from another file": {**NET, "grid": {"stl": "a.stl"}},
    "net closed in words": {**NET, "closed": "s"},
    "another rule": {**BIARC, "rule": "best"},
    "tee without branches": {**TEE, "branches": []},
    "tee with a blend of nothing": {**TEE, "branches": [{**BRANCH, "blend": {}}]},
    "tee with a wall that is open": {**TEE, "wall": 2, "ends": "open"},
    "tube and ring": {**CONTACT, "ring": {"radius": 30, "tube": 8}},
    "ring on a rectangle": {**without(CONTACT, "tube", "sphere"), "ring": {"radius": 30, "tube": 8}, "plate": [60, 50]},
    "ring with a wall": {**without(CONTACT, "tube"), "ring": {"radius": 30, "tube": 8}, "wall": 1},
    "tube on nothing": without(CONTACT, "sphere"),
    "tube on a sphere and a plate": {**CONTACT, "plate": [60, 50]},
    "tube with a wall that is open": {**CONTACT, "wall": 2, "ends": "open"},
    "crossing of one pipe": {**CROSSING, "pipes": [PIPE]},
    "crossing with a wall that is open": {**CROSSING, "wall": 2, "ends": "open"},
    "crossing with a blend of radius zero": {**CROSSING, "blend": 0},
    "tee with a blend of radius zero": {**TEE, "branches": [{**BRANCH, "blend": 0}]},
    "neck without a plate": without(NECK, "plate"),
    "neck inside with a plate": {**NECK, "side": "inside"},
    "neck with a wall of a surface": {**NECK, "wall": 2},
    "neck of radius zero": {**NECK, "ball_radius": 0},
    "neck on a plate of one side": {**NECK, "plate": [60]},
    "neck on a plate without size": {**NECK, "plate": [60, 0]},
    "neck with another variant": {**NECK, "variant": "smooth"},
    "bridge of one ellipse": {**BRIDGE, "ellipses": [[10, 20]]},
    "bridge of a point": {**BRIDGE, "ellipses": [[10, 20], [0, 25]]},
    "bridge without depth": {**BRIDGE, "depth": 0},
}

GOOD_DOCUMENTS = {
    "offset": {"cyclide": 1, "objects": {"o": {"type": "offset", "of": "p", "distance": -0.1}, "p": PATCH}},
    "thick": {"cyclide": 1, "objects": {"p": PATCH, "o": {"type": "offset", "of": "p", "distance": 0.1, "thick": True}}},
    "support": {"cyclide": 1, "objects": {"p": PATCH, "o": {"type": "support-structure", "of": "p"}}},
    "transform": {"cyclide": 1, "objects": {"p": PATCH, "t": {"type": "transform", "of": "p", "steps": STEPS}}},
    "ruled": {"cyclide": 1, "objects": {"a": ARC, "b": {**ARC, "bulge": 0.2}, "r": {"type": "ruled", "rails": ["a", "b"]}}},
    "circular surface": {
        "cyclide": 1,
        "objects": {"a": ARC, "b": SECOND, "c": {"type": "circular-surface", "rails": ["a", "b"], "tangent": [0, 0, 1]}},
    },
    "circular surface with two tangents": {
        "cyclide": 1,
        "objects": {"a": ARC, "b": SECOND, "c": {"type": "circular-surface", "rails": ["a", "b"], "tangent": [[0, 0, 1], [1, 0, 1]]}},
    },
}

BAD_DOCUMENTS = {
    "ruled between three": {"cyclide": 1, "objects": {"a": ARC, "r": {"type": "ruled", "rails": ["a", "a", "a"]}}},
    "circular surface without a tangent": {
        "cyclide": 1,
        "objects": {"a": ARC, "b": SECOND, "c": {"type": "circular-surface", "rails": ["a", "b"]}},
    },
    "offset of nothing": {"cyclide": 1, "objects": {"o": {"type": "offset", "distance": 1}}},
    "offset in words": {"cyclide": 1, "objects": {"p": PATCH, "o": {"type": "offset", "of": "p", "distance": "1"}}},
    "another step": {"cyclide": 1, "objects": {"p": PATCH, "t": {"type": "transform", "of": "p", "steps": [{"shift": [1, 0]}]}}},
    "two maps in a step": {"cyclide": 1, "objects": {"p": PATCH, "t": {"type": "transform", "of": "p", "steps": [{**STEPS[0], **STEPS[3]}]}}},

    "no version": {"objects": {}},
    "another version": {"cyclide": 2, "objects": {}},
    "no objects": {"cyclide": 1},
    "list of objects": {"cyclide": 1, "objects": [CIRCLE]},
    "another unit": {"cyclide": 1, "units": "yd", "objects": {"c": CIRCLE}},
    "comment as an object": {"cyclide": 1, "comment": {}, "objects": {"c": CIRCLE}},
    "another field": {"cyclide": 1, "objects": {"c": CIRCLE}, "author": "me"},
    "object without a name": {"cyclide": 1, "objects": {"": CIRCLE}},
}


def exit_code(document, folder):
    path = folder / "document.json"
    path.write_text(json.dumps(document))
    return subprocess.run([program_path(), "report", path], capture_output=True).returncode


def one(fields):
    return {"cyclide": 1, "objects": {"a": fields}}


def test_the_schema_is_one():
    jsonschema.Draft202012Validator.check_schema(SCHEMA)


@pytest.mark.parametrize("name", DOCUMENTS)
def test_our_documents_are_valid(name):
    VALIDATOR.validate(json.loads(Path(DOCUMENTS[name]).read_text()))


@pytest.mark.parametrize("name", GOOD)
def test_both_accept(name, tmp_path):
    VALIDATOR.validate(one(GOOD[name]))
    assert exit_code(one(GOOD[name]), tmp_path) == 0


@pytest.mark.parametrize("name", GOOD_DOCUMENTS)
def test_both_accept_documents(name, tmp_path):
    VALIDATOR.validate(GOOD_DOCUMENTS[name])
    assert exit_code(GOOD_DOCUMENTS[name], tmp_path) == 0


@pytest.mark.parametrize("document", [pytest.param(one(v), id=k) for k, v in BAD.items()]
                         + [pytest.param(v, id=k) for k, v in BAD_DOCUMENTS.items()])
def test_both_refuse(document, tmp_path):
    assert not VALIDATOR.is_valid(document)
    assert exit_code(document, tmp_path) == 1
