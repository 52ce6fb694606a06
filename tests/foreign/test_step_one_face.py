"""One face in STEP for each plane, cylinder, cone, sphere and torus of a body: what OpenCASCADE reads, measures and cuts of it."""

import collections
import json
import math

import pytest
from OCP.BRepAlgoAPI import BRepAlgoAPI_Cut
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox
from OCP.gp import gp_Pnt
from OCP.GProp import GProp_GProps

from step_faces import StepFaces

RUN = {"type": "polyline", "points": [[0, 0, 0], [100, 0, 0], [100, 80, 0], [100, 80, 60]], "radius": 20, "construction": True}
# Solid, and the length of its middle line: three legs less four tangents, two quarter bends.
LENGTH = 240 - 4 * 20 + 20 * math.pi
MODELS = {
    "pipe": ({"run": RUN, "o": {"type": "pipe", "of": "run", "radius": 8}}, {"plane": 2, "cylinder": 3, "torus": 2}),
    "hollow": ({"run": RUN, "o": {"type": "pipe", "of": "run", "radius": 8, "wall": 2}}, {"plane": 2, "cylinder": 6, "torus": 4}),
    "torus": ({"o": {"type": "cyclide", "a": 30, "c": 0, "mu": 10}}, {"torus": 1}),
    "sphere": (
        {"a": {"type": "arc", "through": [[0, 0, -5], [3, 0, 4], [0, 0, 5]], "construction": True}, "o": {"type": "revolution", "of": "a"}},
        {"sphere": 1},
    ),
}
VOLUMES = {"pipe": math.pi * 64 * LENGTH, "hollow": math.pi * (64 - 36) * LENGTH, "torus": 2 * math.pi**2 * 30 * 100, "sphere": 4 / 3 * math.pi * 125}

HALVED = ("torus", "sphere")


def volume(shape):
    found = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, found, 1e-12)
    return found.Mass()


@pytest.mark.parametrize("name", MODELS)
def test_each_surface_is_one_face_of_a_valid_solid(program, tmp_path, name):
    objects, kinds = MODELS[name]
    document, path = tmp_path / "m.json", tmp_path / "m.step"
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": objects}))
    program("build", document, "-o", path)
    step = StepFaces(path)
    shape = step.shape
    assert collections.Counter(face.kind for face in step.faces) == kinds
    # As for booleans: curves and surfaces at equal parameters.
    assert step.valid and step.exactly_valid and step.tolerance <= 1e-7 and len(step.solids) == 1
    assert volume(shape) == pytest.approx(VOLUMES[name], rel=1e-9)
    # The half of the torus or sphere, and what of the pipe is beyond a plane across its first leg.
    box = BRepPrimAPI_MakeBox(gp_Pnt(-200, -200, -200), gp_Pnt(0 if name in HALVED else 40, 200, 200)).Shape()
    cut = BRepAlgoAPI_Cut(shape, box).Shape()
    assert BRepCheck_Analyzer(cut).IsValid()
    rest = 0.5 if name in HALVED else (LENGTH - 40) / LENGTH
    assert volume(cut) == pytest.approx(rest * VOLUMES[name], rel=1e-7)
