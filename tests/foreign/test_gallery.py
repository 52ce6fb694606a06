"""The gallery: its page, and every file of it in the hands of a foreign reader. How models are turned in a browser is tried by `tests/browser`."""

import base64
import json
import re
from html.parser import HTMLParser
from pathlib import Path

import pytest
import trimesh
from PIL import Image

from conftest import ROOT, shared_folder
from reference_objects import reported_area
from step_reader import StepFile
from test_mesh import validate

EXAMPLES = sorted(p.stem for p in (ROOT / "examples").glob("*.json"))
# Smooth surfaces over triangles have no exact form.
MESHES = {"stone", "scan", "sphere_blend"}
VOID = {"meta", "img", "link", "br"}


@pytest.fixture(scope="session")
def gallery(program, tmp_path_factory):
    return shared_folder(tmp_path_factory, "gallery", lambda folder: program("gallery", "-o", folder))


class Page(HTMLParser):
    """Links, pictures and whether every element is closed in order."""

    def __init__(self, text):
        super().__init__()
        self.links, self.pictures, self.scripts, self.open = [], [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if tag == "a":
            self.links.append(attributes["href"])
        if tag == "img":
            self.pictures.append(attributes["src"])
            assert attributes["alt"], "pictures are described"
        if tag == "script":
            self.scripts.append(attributes["src"])
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag


def test_every_type_of_curve_has_a_picture():
    """The kinds of the documentation's groups of curves: those on a torus in the models of a torus, all others in one model."""
    index = (ROOT / "docs" / "kinds" / "README.md").read_text()

    def group(name):
        return set(re.findall(r"^- \[`([a-z-]+)`\]", index.split(f"\n## {name}\n\n")[1].split("\n\n")[0], re.MULTILINE))

    off_a_torus, on_a_torus = group("Curves"), group("Curves on a torus")
    assert len(off_a_torus) > 8

    def shown(*names):
        documents = [json.loads((ROOT / "examples" / f"{name}.json").read_text()) for name in names]
        return {spec["type"] for document in documents for spec in document["objects"].values()}

    assert off_a_torus <= shown("gallery")
    assert on_a_torus <= shown(*EXAMPLES)


def test_the_page_leads_to_every_file(gallery):
    text = (gallery / "index.html").read_text()
    page = Page(text)
    assert not page.open
    assert not re.search(r"https?://", text), "the page needs nothing from elsewhere"
    # What turns the models, and hands them over.
    scripts = {"viewer.js"} | {f"{p.name}.js" for p in gallery.glob("*.glb")}
    assert page.scripts == ["viewer.js"]
    files = {p.name for p in gallery.iterdir()} - {"index.html"}
    assert set(page.links) | set(page.pictures) | scripts == files
    assert {Path(f).stem for f in files if f.endswith(".json")} == set(EXAMPLES)
    # Each skin of the roof has an area of its own.
    assert "<dt>area</dt><dd>outer skin 1703.4 m², inner skin 1661.8 m²</dd>" in text
    assert "NaN" not in text and "inf" not in re.sub(r"<style>.*</style>", "", text, flags=re.S)


@pytest.mark.parametrize("name", [name for name in EXAMPLES if name not in MESHES])
def test_step_files_are_valid(gallery, name):
    assert StepFile(gallery / f"{name}.step").valid


@pytest.mark.parametrize("name", EXAMPLES)
def test_pictures_show_something(gallery, name):
    with Image.open(gallery / f"{name}.png") as picture:
        picture.verify()
    with Image.open(gallery / f"{name}.png") as picture:
        colours = picture.convert("RGB").getcolors(maxcolors=1 << 24)
        background = max(count for count, _ in colours)
        assert len(colours) > 16
        # At least a hundredth of the picture is not background.
        assert background < 0.99 * picture.width * picture.height


def test_meshes_are_those_of_the_report(gallery, program):
    for path in sorted(gallery.glob("*.glb")):
        (check,) = validate(path)
        assert (check["errors"], check["warnings"]) == (0, 0), check
        report = json.loads(program("report", gallery / f"{path.stem}.json", "--json"))
        objects = [o for o in report["objects"].values() if not o.get("construction")]
        scene = trimesh.load(path)
        area = reported_area([o for o in objects if "area" in o or "parts" in o])
        # Faces within 1e-4 of the model's size miss the square of their angle to the surface, parts of a thousand.
        assert scene.area == pytest.approx(area, rel=5e-3), path.name


def test_models_that_are_turned_in_the_page_are_the_files(gallery):
    text = (gallery / "index.html").read_text()
    turned = re.findall(r'data-model="(\w+)" data-eye="([^"]+)"', text)
    assert {name for name, _ in turned} == {p.stem for p in gallery.glob("*.glb")}
    for name, eye in turned:
        handed, bytes_of = re.fullmatch(r'cyclideModel\("(\w+)", "([^"]+)"\);\n', (gallery / f"{name}.glb.js").read_text()).groups()
        assert handed == name
        assert base64.b64decode(bytes_of, validate=True) == (gallery / f"{name}.glb").read_bytes()
        # The viewer reads two numbers.
        assert len([float(degrees) for degrees in eye.split(",")]) == 2


def test_the_documents_beside_the_files_are_the_examples(gallery, program, tmp_path):
    for name in EXAMPLES:
        assert (gallery / f"{name}.json").read_bytes() == (ROOT / "examples" / f"{name}.json").read_bytes()
    # With the files they are made from: what is shown can be built again.
    program("build", gallery / "track.json", "-o", tmp_path / "again.step")
    assert (tmp_path / "again.step").stat().st_size > 0
