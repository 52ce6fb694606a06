"""How time and memory of the program grow with the size of what it is given.

    python3 benches/growth.py [--kinds K,...] [--formats F,...] [--sizes N,...] [--net-sizes N,...]
                              [--seconds T] [--gigabytes G] [--program FILE] [--keep FOLDER]

Curves: a closed wave of constant wavelength round a circle that grows with the number of points, so that neighbors stay
a unit apart and each piece of curve looks the same at every size. Nets: n by n quads of a torus, which have circles as they
are, and of a shallow roof, whose vertices `make_circular` moves; edges stay a unit long, and the surfaces grow with n. Each
file is made in a run of its own of the built program, with a limit of processor time and of address space; what goes beyond
is "over", and no larger one is tried.

Prints the tables of docs/files.md, "How it grows": a row for each object and format with the seconds of processor time
(user) for each number of points or quads, the power of the number by which the last step grew (1: linear), and of the
largest file the bytes for each point or quad, those of the largest memory, and the ratio of both. Where a limit was exceeded
nothing stands. Wall clock and what was refused go to standard error.
"""

import argparse
import json
import math
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
# Constant, since the default grows with the size of the model.
TOLERANCE = 0.001
CURVES = {
    "fair-spline": {"type": "fair-spline", "closed": True},
    "circle-spline": {"type": "circle-spline", "closed": True, "order": 2},
    "trigonometric": {"type": "circle-spline", "closed": True, "order": 2, "variant": "trigonometric"},
    "arc-spline": {"type": "arc-spline", "closed": True},
    "arc-fit": {"type": "arc-fit", "closed": True, "tolerance": 0.01},
    "fair-fit": {"type": "fair-fit", "closed": True, "tolerance": 0.01},
}
NETS = {"net": {}, "net-made-circular": {"make_circular": True}}
CURVE_FORMATS = ["step", "dxf", "csv", "svg", "json", "glb", "obj", "png"]
NET_FORMATS = ["step", "glb", "obj", "stl", "svg", "json", "png"]
# What the table calls an object, where that is not its type.
LABELS = {"trigonometric": "`circle-spline`, trigonometric", "net": "`cyclidic-net`", "net-made-circular": "`make_circular`"}
PERIOD, HEIGHT = 40, 3.0
ROOF_SAG, TORUS_PART = 0.15, 1.2


def wave(count):
    """A closed wave of `count` points, about a unit apart."""
    waves, radius = max(count // PERIOD, 3), count / (2 * math.pi)
    for i in range(count):
        angle = 2 * math.pi * i / count
        r = radius + HEIGHT * math.sin(waves * angle)
        yield r * math.cos(angle), r * math.sin(angle)


def torus(n):
    """Part of a torus: the quads between its parameter lines are isosceles trapezoids, which have circles."""
    tube, middle = n / TORUS_PART, 3 * n / TORUS_PART
    for j in range(n + 1):
        v = TORUS_PART * (j / n - 0.5)
        r, z = middle + tube * math.cos(v), tube * math.sin(v)
        yield [(r * math.cos(u), r * math.sin(u), z) for u in (TORUS_PART / 4 * (i / n - 0.5) for i in range(n + 1))]


def roof(n):
    """A shallow dome with two bendings, near its curvature lines but not on them."""
    for j in range(n + 1):
        y = j / n - 0.5
        yield [(n * x, n * y, -n * ROOF_SAG * (x * x + 2 * y * y)) for x in (i / n - 0.5 for i in range(n + 1))]


def document(folder, kind, size):
    """Writes a document, with its points beside it, and gives back its path and the number of its points or quads."""
    path = folder / f"{kind}-{size}.document.json"
    if kind in NETS:
        rows = list(roof(size) if "circular" in kind else torus(size))
        shape, count = {"type": "cyclidic-net", "grid": rows, **NETS[kind]}, size * size
    else:
        points = folder / f"wave-{size}.csv"
        with points.open("w") as file:
            file.write("x_mm,y_mm\n")
            # Line by line: what this process holds when it starts the program would count as the program's memory.
            file.writelines(f"{x:.9f},{y:.9f}\n" for x, y in wave(size))
        shape, count = {"points": {"csv": points.name}, **CURVES[kind]}, size
    path.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {kind: shape}}))
    return path, count


def measured(command, seconds, memory):
    """Runs a command: why it did not end well or None, its user and wall seconds and its largest memory in bytes."""

    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 5))
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))

    start = time.monotonic()
    with tempfile.TemporaryFile() as said:
        child = subprocess.Popen(command, preexec_fn=limited, stdout=subprocess.DEVNULL, stderr=said)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        last = said.read().decode(errors="replace").strip().rpartition("error: ")[2]
    ended = None
    if child.returncode < 0:
        ended = "over"
    elif child.returncode > 0:
        ended = "refused"
        print(f"{' '.join(map(str, command))}: {last}", file=sys.stderr)
    return ended, usage.ru_utime, time.monotonic() - start, usage.ru_maxrss * 1024


def measure(folder, kind, form, size, options):
    """One run: why it did not end well or None, the number of points or quads, seconds, memory and length of the file."""
    path, count = document(folder, kind, size)
    out = folder / f"{kind}-{size}.{form}"
    tolerance = [] if form == "png" else ["--tolerance", str(TOLERANCE if kind in CURVES else 10 * TOLERANCE)]
    command = [options.program, "build", path, "-o", out, *tolerance]
    ended, user, wall, peak = measured(command, options.seconds, int(options.gigabytes * 2**30))
    length = out.stat().st_size if ended is None else 0
    if out.exists() and not options.keep:
        out.unlink()
    return ended, count, user, wall, peak, length


def two_digits(value):
    """A figure as the table has it."""
    return f"{value:.2f}" if value < 1 else f"{value:.1f}" if value < 10 else f"{value:,.0f}"


def row(folder, kind, form, label, sizes, options):
    """The seconds at every size and what the last two say about the law; the last file and its memory."""
    seconds, last = [], []
    for size in sizes:
        ended, count, user, wall, peak, length = measure(folder, kind, form, size, options)
        seconds.append({None: two_digits(user), "over": ""}.get(ended, ended))
        print(f"{kind} {form} {count}: {ended or 'done'}, user {user:.2f} s, wall {wall:.2f} s, "
              f"file {length} B, peak {peak} B", file=sys.stderr, flush=True)
        if ended is None:
            last.append((count, user, peak, length))
        if ended == "over":
            break
    seconds += [""] * (len(sizes) - len(seconds))
    memory = ["", "", ""]
    if last:
        count, _, peak, length = last[-1]
        memory = [f"{length / count:,.0f}", f"{peak / count:,.0f}", two_digits(peak / max(length, 1))]
    law = ""
    if len(last) > 1:
        (few, quick, *_), (many, slow, *_) = last[-2:]
        law = f"{math.log(max(slow, 1e-3) / max(quick, 1e-3)) / math.log(many / few):.1f}"
    cells = [label, form.upper(), *seconds, law, *memory]
    print("|" + "|".join(f" {cell} " if cell else " " for cell in cells) + "|", flush=True)


def main():
    listed = lambda text: text.split(",")
    numbers = lambda text: [int(float(part)) for part in text.split(",")]
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--kinds", type=listed, default=[*CURVES, *NETS])
    parser.add_argument("--formats", type=listed, default=list(dict.fromkeys([*CURVE_FORMATS, *NET_FORMATS])))
    parser.add_argument("--sizes", type=numbers, default=[10**3, 10**4, 10**5, 10**6])
    parser.add_argument("--net-sizes", type=numbers, default=[50, 100, 200, 400])
    parser.add_argument("--seconds", type=int, default=120)
    parser.add_argument("--gigabytes", type=float, default=12.0)
    parser.add_argument("--program", type=Path, default=ROOT / "target" / "release" / "cyclide")
    parser.add_argument("--keep", type=Path, help="keep documents and files here")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        folder = options.keep or Path(scratch)
        folder.mkdir(exist_ok=True)
        tables = [(CURVES, CURVE_FORMATS, options.sizes, 1), (NETS, NET_FORMATS, options.net_sizes, 2)]
        for own, formats, sizes, dimension in tables:
            kinds = [kind for kind in options.kinds if kind in own]
            if not kinds:
                continue
            counts = " | ".join(f"{size**dimension:,}" for size in sizes)
            print(f"\n| object | file | {counts} | law | file, B | peak, B | peak / file |")
            print("|" + "---|" * (len(sizes) + 6))
            for kind in kinds:
                label = LABELS.get(kind, f"`{kind}`")
                for form in (form for form in formats if form in options.formats):
                    row(folder, kind, form, label, sizes, options)
                    label = ""


if __name__ == "__main__":
    main()
