"""PNG pictures: they open, have their size, and show something."""

import resource
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

ROOT = Path(__file__).resolve().parents[2]


@pytest.mark.parametrize("name", ["track", "logo", "cable"])
def test_picture_shows_the_curve(examples, name):
    image = Image.open(examples[name].file("png"))
    image.load()
    assert image.format == "PNG"
    assert image.width >= 400 and image.height >= 300
    pixels = np.asarray(image.convert("RGB"), float)
    ink = np.abs(pixels - pixels[0, 0]).max(axis=-1) > 40.0
    assert 0.001 < ink.mean() < 0.5
    rows, columns = np.nonzero(ink)
    # The drawing fills the picture in at least one direction.
    assert max(np.ptp(rows) / image.height, np.ptp(columns) / image.width) > 0.6


@pytest.mark.parametrize("width", [300, 900, 2200])
def test_picture_is_as_wide_as_asked_for(program, tmp_path, width):
    path = tmp_path / "track.png"
    program("build", ROOT / "examples" / "track.json", "-o", path, "--width", width, "--camera", "top", "--axes")
    with Image.open(path) as image:
        assert image.width == width and image.height <= 0.75 * width + 1


def test_the_bar_below_a_drawing_is_its_scale(program, tmp_path):
    """A square of 90 m: the bar is a round length in the square's own scale."""
    points = tmp_path / "square.csv"
    points.write_text("x,y\n0,0\n90,0\n90,90\n0,90\n")
    path = tmp_path / "square.png"
    options = ("--closed", "--units", "m", "--kind", "arc-fit", "--tolerance", 0.001, "--target", "polyline")
    program("curve", points, *options, "-o", path)
    with Image.open(path) as image:
        pixels = np.asarray(image.convert("RGB"), int)

    def places(colour):
        return np.nonzero((np.abs(pixels - colour).max(axis=-1) < 4))

    rows, columns = places([0x1B, 0x2A, 0x41])
    square = np.ptp(columns[rows < 0.8 * image.height])
    rows, columns = places([0x1D, 0x24, 0x2B])
    row = np.bincount(rows[rows > 0.8 * image.height]).argmax()
    bar = np.sort(columns[rows == row])
    bar = bar[: 1 + np.argmax(np.diff(bar, append=10**6) > 1)]
    metres = 90.0 * len(bar) / square
    assert min(abs(metres / m - 1.0) for m in (10.0, 20.0, 50.0)) < 0.02


@pytest.fixture(scope="module")
def surface_pictures(program, tmp_path_factory):
    """Pictures of the example surfaces: the image and the processor time that its build took, seconds."""
    folder, pictures = tmp_path_factory.mktemp("surfaces"), {}
    for name in ("patch", "ring", "inverted_torus", "handle"):
        path = folder / f"{name}.png"
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        program("build", ROOT / "examples" / f"{name}.json", "-o", path)
        spent = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        with Image.open(path) as image:
            pictures[name] = np.asarray(image.convert("RGB"), float), spent
    return pictures


@pytest.mark.parametrize("name", ["patch", "ring", "inverted_torus", "handle"])
def test_picture_of_a_surface(surface_pictures, name):
    pixels, spent = surface_pictures[name]
    assert pixels.shape == (1200, 1600, 3)
    paper = np.array([0xFB, 0xFB, 0xF9], float)
    # The upper corners are beyond model and shadow, for the ground lies below the model.
    assert (pixels[0, 0] == paper).all() and (pixels[0, -1] == paper).all()
    # The first object is blue: more blue than red by a tenth of the scale or more. Shadows are less so.
    surface = pixels[..., 2] - pixels[..., 0] > 12.0
    assert 0.1 < surface.mean() < 0.75
    rows, columns = np.nonzero(surface)
    # Fitted to 0.85 of one side, less where a pole's region at the outline shines in white.
    assert max(np.ptp(rows) / 1200, np.ptp(columns) / 1600) > 0.75
    red, green, blue = pixels[surface].mean(axis=0)
    assert 120 < red < green < blue < 250, "pale blue"
    # Shaded: neither flat nor noise.
    assert 10 < pixels[surface].std(axis=0).mean() < 60
    # Picture with all the rest of the program, on a machine that may be busy; below one second where it is not.
    assert spent < 4.0
