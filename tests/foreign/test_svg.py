"""SVG files drawn by two renderers: ink where the curves are, none elsewhere."""

import io
import xml.etree.ElementTree as ElementTree

import cairosvg
import numpy as np
import pytest
import resvg_py
from PIL import Image

import quaternion_form as form

DPI = 127  # five pixels to a millimetre of paper: no rounding of the page's size in between


def by_cairo(path):
    return Image.open(io.BytesIO(cairosvg.svg2png(url=str(path), dpi=DPI)))


def by_resvg(path):
    return Image.open(io.BytesIO(bytes(resvg_py.svg_to_bytes(svg_path=str(path), dpi=DPI))))


def ink_of(image):
    """True where the picture differs from its background (the colour of its corner)."""
    pixels = np.asarray(image.convert("RGBA"), float)
    flat = pixels[..., :3] * pixels[..., 3:] / 255.0 + 255.0 - pixels[..., 3:]
    return np.abs(flat - flat[0, 0]).max(axis=-1) > 48.0


@pytest.mark.parametrize("render", [by_cairo, by_resvg])
@pytest.mark.parametrize("name", ["track", "logo"])
def test_ink_lies_on_the_curves(examples, name, render):
    built = examples[name]
    path = built.file("svg")
    root = ElementTree.parse(path).getroot()
    x0, y0, width, height = map(float, root.get("viewBox").split())
    paper_width, paper_height = (float(root.get(side).removesuffix("mm")) for side in ("width", "height"))
    if built.units == "mm":  # true size
        assert (paper_width, paper_height) == (width, height)
    assert paper_width / paper_height == pytest.approx(width / height, rel=1e-12)
    image = render(path)
    assert abs(image.width - paper_width * DPI / 25.4) <= 1.0
    assert abs(image.height - paper_height * DPI / 25.4) <= 1.0
    ink = ink_of(image)
    pixel = width / image.width

    rows, columns = np.nonzero(ink)
    assert len(rows) > 0
    centres = np.stack([x0 + (columns + 0.5) * pixel, -(y0 + (rows + 0.5) * pixel), 0 * rows], axis=1)
    curves = [curve or nearby(points, built.objects[name].spec) for name, _, curve, points in built.contours()]
    distance = np.min([curve.distances(centres[::17]) for curve in curves], axis=0)
    fit = max((r.spec["tolerance"] for r in built.objects.values() if r.kind == "arc-fit"), default=0.0)
    assert distance.max() <= 0.5 * stroke_width(root) + 1.5 * pixel + 2 * fit, "ink away from the curves"

    for curve in curves:  # and every point of the curve is inked
        _, samples = curve.sample(40)
        i = np.clip(((-samples[:, 1] - y0) / pixel).astype(int), 1, image.height - 2)
        j = np.clip(((samples[:, 0] - x0) / pixel).astype(int), 1, image.width - 2)
        near = np.max([ink[i + a, j + b] for a in (-1, 0, 1) for b in (-1, 0, 1)], axis=0)
        assert near.all(), f"{np.sum(~near)} points of the curve are blank"


def nearby(points, spec):
    """A curve through the points of an arc fit, as near to it as the points are."""
    return form.arc_spline(points, spec.get("closed", False))


def stroke_width(root):
    widths = [float(e.get("stroke-width")) for e in root.iter() if e.get("stroke-width")]
    assert widths, "no stroke width"
    return max(widths)


def test_arcs_are_true_arcs(examples):
    text = examples["logo"].file("svg").read_text()
    root = ElementTree.fromstring(text)
    data = " ".join(e.get("d") for e in root.iter() if e.get("d"))
    assert "A" in data
    assert "C" not in data.upper().replace("A", "") and "Q" not in data.upper()
    assert data.upper().count("Z") == 3
