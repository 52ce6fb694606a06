"""Objects of a STEP file as an assembly-aware reader (OpenCASCADE's XCAF, which FreeCAD and build123d use) shows them."""

import json

import numpy as np
import pytest
from OCP.collections import Sequence_TDF_Label
from OCP.Quantity import Quantity_Color
from OCP.STEPCAFControl import STEPCAFControl_Reader
from OCP.TCollection import TCollection_AsciiString, TCollection_ExtendedString
from OCP.TDataStd import TDataStd_Name
from OCP.TDocStd import TDocStd_Document
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_SOLID
from OCP.XCAFApp import XCAFApp_Application
from OCP.XCAFDoc import XCAFDoc_ColorType, XCAFDoc_DocumentTool, XCAFDoc_ShapeTool

from step_faces import distinct
from step_modeling import quiet

AWKWARD = "it's 5° \\ é中😀 #1; \"''"
OBJECTS = {
    "ring": {"type": "cyclide", "a": 50, "c": 20, "mu": 32, "segments": [6, 6]},
    "panel": {
        "type": "cyclide-patch",
        "corners": [[-40, -30, 90], [40, -30, 90], [-30, 40, 90], [30, 40, 90]],
        "frame": [[8 / 9, -1 / 9, 4 / 9], [-1 / 9, 8 / 9, 4 / 9]],
    },
    AWKWARD: {"type": "circle", "center": [82, -22], "radius": 20},
    "rail": {"type": "arc", "through": [[0, 0], [15, 12], [30, 0]]},
}
# The colours of the pictures: of surfaces and of curves, by the index of the object.
SURFACES = [0xC3D3E6, 0xB4DAD4, 0xE2C8D3, 0xC3CEE9]
CURVES = [0x1B2A41, 0x0B6E6E, 0x7A2E52, 0x3A5A98]


class Assembly:
    """The products of a file: names, shapes, colours and layers."""

    def __init__(self, path):
        self.document = TDocStd_Document(TCollection_ExtendedString("MDTV-XCAF"))
        XCAFApp_Application.GetApplication_s().InitDocument(self.document)
        reader = STEPCAFControl_Reader()
        reader.SetNameMode(True)
        reader.SetColorMode(True)
        reader.SetLayerMode(True)
        with quiet():
            reader.ReadFile(str(path))
            reader.Transfer(self.document)
        main = self.document.Main()
        self.shapes = XCAFDoc_DocumentTool.ShapeTool_s(main)
        self.colours = XCAFDoc_DocumentTool.ColorTool_s(main)
        self.layers = XCAFDoc_DocumentTool.LayerTool_s(main)
        roots = Sequence_TDF_Label()
        self.shapes.GetFreeShapes(roots)
        self.roots = [roots.Value(i + 1) for i in range(roots.Length())]

    @staticmethod
    def name(label):
        found = TDataStd_Name()
        assert label.IsAttribute(TDataStd_Name.GetID_s()) and label.FindAttribute(TDataStd_Name.GetID_s(), found)
        return TCollection_AsciiString(found.Get(), "\0").ToCString()

    def parts(self, root):
        """(label of the occurrence, label of the part) of an assembly."""
        found = Sequence_TDF_Label()
        XCAFDoc_ShapeTool.GetComponents_s(root, found)
        for i in range(found.Length()):
            part = type(root)()
            assert XCAFDoc_ShapeTool.GetReferredShape_s(found.Value(i + 1), part)
            yield found.Value(i + 1), part

    def colour(self, shape, kind):
        """Of a shape or one that contains it, as on a screen."""
        colour = Quantity_Color()
        if not self.colours.GetColor(shape, kind, colour):
            return None

        def screen(v):
            return round(255 * (12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055))

        return screen(colour.Red()) << 16 | screen(colour.Green()) << 8 | screen(colour.Blue())


@pytest.fixture(scope="module")
def path(program, tmp_path_factory):
    folder = tmp_path_factory.mktemp("assembly")
    source = folder / "model.json"
    source.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": OBJECTS}))
    # Of curves and surfaces together one product would be made.
    program("build", source, "-o", folder / "model.step", "--step-products", "assembly")
    return folder / "model.step"


@pytest.fixture(scope="module")
def assembly(path):
    return Assembly(path)


def test_every_object_is_a_part_of_its_name(assembly):
    (root,) = assembly.roots
    assert XCAFDoc_ShapeTool.IsAssembly_s(root)
    assert assembly.name(root) == "model"
    parts = list(assembly.parts(root))
    assert [assembly.name(part) for _, part in parts] == list(OBJECTS)
    assert [assembly.name(occurrence) for occurrence, _ in parts] == list(OBJECTS)
    shapes = [XCAFDoc_ShapeTool.GetShape_s(part) for _, part in parts]
    counts = [[len(distinct(s, kind)) for kind in (TopAbs_SOLID, TopAbs_FACE)] for s in shapes]
    assert counts == [[1, 36], [0, 1], [0, 0], [0, 0]]
    for occurrence, _ in parts:
        place = XCAFDoc_ShapeTool.GetLocation_s(occurrence).Transformation()
        assert [[place.Value(i, j) for j in range(1, 5)] for i in range(1, 4)] == np.eye(3, 4).tolist()


def test_objects_have_the_colours_of_the_pictures(assembly):
    kinds = XCAFDoc_ColorType
    for index, (_, part) in enumerate(assembly.parts(assembly.roots[0])):
        shape = XCAFDoc_ShapeTool.GetShape_s(part)
        if distinct(shape, TopAbs_FACE):
            assert assembly.colour(shape, kinds.XCAFDoc_ColorSurf) == SURFACES[index]
        else:
            found = [assembly.colour(s, kinds.XCAFDoc_ColorCurv) for s in (shape, *distinct(shape, TopAbs_EDGE))]
            assert CURVES[index] in found, found


def test_objects_are_on_layers_of_their_names(assembly):
    layers = Sequence_TDF_Label()
    assembly.layers.GetLayerLabels(layers)
    names = [assembly.name(layers.Value(i + 1)) for i in range(layers.Length())]
    assert sorted(names) == sorted(OBJECTS)


def test_curves_and_surfaces_together_are_one_product_unless_asked(program, path, tmp_path):
    """FreeCAD 0.20 without its window merges the parts of an assembly and crashes."""
    report = json.loads(program("build", path.parent / "model.json", "-o", tmp_path / "model.step", "--json"))
    assert "--step-products assembly" in report["files"][0]["notes"][0]
    assembly = Assembly(tmp_path / "model.step")
    (root,) = assembly.roots
    assert not XCAFDoc_ShapeTool.IsAssembly_s(root)
    shape = XCAFDoc_ShapeTool.GetShape_s(root)
    assert [len(distinct(shape, kind)) for kind in (TopAbs_SOLID, TopAbs_FACE)] == [1, 37]


def test_one_object_is_one_product(program, tmp_path):
    source = tmp_path / "model.json"
    source.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"ring": OBJECTS["ring"]}}))
    program("build", source, "-o", tmp_path / "model.step")
    assembly = Assembly(tmp_path / "model.step")
    (root,) = assembly.roots
    assert not XCAFDoc_ShapeTool.IsAssembly_s(root)
    assert assembly.name(root) == "ring"


def test_lines_are_short(path):
    """But for that of the long name."""
    assert all(len(line) < 80 or "\\X" in line for line in path.read_text("ascii").splitlines())
