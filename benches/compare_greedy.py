"""Arc fits against a greedy chain of biarcs on the same points.

    .venv/bin/python benches/compare_greedy.py FILE.csv [TOLERANCE]      default examples/survey.csv 0.05

The chain is what a script does: tangents of the circles through three neighbors, and from each joint the farthest point
to which one biarc keeps all points between within the tolerance (the length is doubled, then halved). The points are read
as a closed planar curve; both distances are those of the points. The counts are printed, not the times.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent


def read(path):
    rows = []
    for line in Path(path).read_text().splitlines():
        try:
            rows.append([float(v) for v in line.split(",")[:2]])
        except ValueError:
            continue
    points = np.array([complex(*row) for row in rows])
    return points[:-1] if abs(points[0] - points[-1]) < 1e-9 else points


def tangents(p):
    """Of the circles through each point and its neighbors: the chords, each weighted with the other's square."""
    before, after = p - np.roll(p, 1), np.roll(p, -1) - p
    t = before / abs(before) ** 2 + after / abs(after) ** 2
    return t / abs(t)


def arc_distances(q, a, t, b):
    """Distances of points from the arc that leaves a along t and ends in b."""
    chord = b - a
    sine = (np.conj(t) * chord).imag / abs(chord)
    if abs(sine) < 1e-12:
        s = np.clip(((q - a) * np.conj(chord)).real / abs(chord) ** 2, 0, 1)
        return abs(q - a - s * chord)
    radius = abs(chord) / (2 * sine)
    centre = a + 1j * t * radius
    sweep = np.angle((b - centre) / (a - centre))
    turn = np.sign(radius)
    sweep = sweep % (turn * 2 * np.pi)
    at = np.angle((q - centre) / (a - centre)) % (turn * 2 * np.pi)
    on = turn * at <= turn * sweep
    ends = np.minimum(abs(q - a), abs(q - b))
    return np.where(on, abs(abs(q - centre) - abs(radius)), ends)


def fits(p, t, i, j, tolerance):
    """Does the biarc of equal legs from point i to point j pass all points between them?"""
    n = len(p)
    a, b, ta, tb = p[i % n], p[j % n], t[i % n], t[j % n]
    v, w = b - a, ta + tb
    d2 = 2 * (1 - (ta * np.conj(tb)).real)
    vw = (v * np.conj(w)).real
    if d2 < 1e-12:
        if vw <= 0:
            return False
        d = abs(v) ** 2 / (2 * vw)
    else:
        d = (-vw + np.sqrt(vw * vw + d2 * abs(v) ** 2)) / d2
    joint = (a + d * ta + b - d * tb) / 2
    q = p[np.arange(i + 1, j) % n]
    if not len(q):
        return True
    first = arc_distances(q, a, ta, joint)
    # The second arc backwards: it leaves b against its tangent.
    second = arc_distances(q, b, -tb, joint)
    return bool(np.minimum(first, second).max() <= tolerance)


def greedy(p, tolerance):
    t, n = tangents(p), len(p)
    pieces, i = 0, 0
    while i < n:
        good, step = 1, 2
        while i + step <= n and fits(p, t, i, i + step, tolerance):
            good, step = step, 2 * step
        bad = min(step, n - i + 1)
        while bad - good > 1:
            middle = (good + bad) // 2
            good, bad = (middle, bad) if fits(p, t, i, i + middle, tolerance) else (good, middle)
        pieces, i = pieces + 2, i + good
    return pieces


def main():
    path = sys.argv[1] if len(sys.argv) > 1 else ROOT / "examples" / "survey.csv"
    tolerance = float(sys.argv[2]) if len(sys.argv) > 2 else 0.05
    p = read(path)
    with tempfile.TemporaryDirectory() as folder:
        csv, out = Path(folder, "points.csv"), Path(folder, "fit.json")
        csv.write_text("x,y\n" + "".join(f"{float(z.real)!r},{float(z.imag)!r}\n" for z in p))
        command = [ROOT / "target/release/cyclide", "curve", csv, "--closed", "--kind", "arc-fit"]
        subprocess.run([*command, "--tolerance", str(tolerance), "-o", out], check=True, capture_output=True)
        contours = json.loads(out.read_text())["objects"]["points"]["contours"]
        ours = sum(len(set(curve["knots"])) - 1 for contour in contours for curve in contour["curves"])
    print(f"{len(p)} points, tolerance {tolerance}: greedy biarcs {greedy(p, tolerance)} pieces, arc fit {ours} pieces")


if __name__ == "__main__":
    main()
