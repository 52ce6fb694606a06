"""Makes the pictures of the kinds of object, docs/kinds/images: of each starter document one, by the command itself.

    python3 scripts/kind_pictures.py CYCLIDE [KIND…]

Then `cargo xtask pages` puts them on the pages. A kind whose document makes no picture (a motion alone) has none. The colors are
reduced until a picture has at most 25 kB; this needs Pillow, which scripts/setup.sh installs.
"""

import argparse
import io
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    from PIL import Image
except ImportError:
    sys.exit("kind_pictures.py needs Pillow, which scripts/setup.sh installs")

ROOT = Path(__file__).resolve().parent.parent
STARTERS = ROOT / "crates/cyclide-io/src/document/starters"
IMAGES = ROOT / "docs/kinds/images"

WIDTH = 480
MOST_BYTES = 25_000
# Widths with numbers of colors; the first that is small enough is taken.
SIZES = [(480, 96), (480, 64), (480, 48), (420, 64), (420, 48), (360, 64), (360, 48), (320, 48)]


def rendered(program, kind, folder):
    """The picture of a starter document, or `None` if it makes none."""
    document, picture = folder / f"{kind}.json", folder / f"{kind}.png"
    document.write_bytes(subprocess.run([program, "new", kind], check=True, capture_output=True).stdout)
    command = [program, "build", document, "-o", picture, "--png-plain", "--width", str(WIDTH)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        print(f"{kind}: no picture: {done.stderr.strip()}")
        return None
    return Image.open(picture).convert("RGB")


def reduced(picture):
    """The bytes of a picture with as many colors as there is room for."""
    for width, colors in SIZES:
        file = io.BytesIO()
        size = (width, round(picture.height * width / picture.width))
        small = picture if size == picture.size else picture.resize(size, Image.Resampling.LANCZOS)
        small.quantize(colors, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(file, "PNG", optimize=True)
        if len(file.getvalue()) <= MOST_BYTES:
            break
    return file.getvalue()


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", metavar="CYCLIDE", type=Path)
    parser.add_argument("kinds", nargs="*", metavar="KIND")
    asked = parser.parse_args()
    IMAGES.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        for kind in asked.kinds or sorted(path.stem for path in STARTERS.glob("*.json")):
            picture = rendered(asked.program.resolve(), kind, Path(folder))
            if picture is not None:
                (IMAGES / f"{kind}.png").write_bytes(reduced(picture))
    sizes = [path.stat().st_size for path in IMAGES.glob("*.png")]
    print(f"{len(sizes)} pictures, {sum(sizes)} bytes, the largest {max(sizes)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
