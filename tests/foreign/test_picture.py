"""PNG pictures: they open, have their size, and show something."""

import numpy as np
import pytest
from PIL import Image


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
