"""Circle splines and Möbius splines against SciPy's CubicSpline and Pchip on the same points in the same run.

    .venv/bin/python benches/compare_scipy.py [POINTS] [SAMPLES_PER_SEGMENT]      default 100000 16

Both build a closed curve through the points and evaluate it at the same number of parameters, on one thread; the smallest
of five times is printed. The cubic is C2 and polynomial, Pchip is C1 (and not periodic), circle splines (order 2) and fair splines are G2 and exact on
circles, Möbius splines C1: the comparison is of speed only; ratios are to the cubic. The points lie in space; the planar fair spline and the planar cubic have them without their heights.
"""

import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from scipy.interpolate import CubicSpline, PchipInterpolator

ROOT = Path(__file__).resolve().parent.parent


def closed_points(count):
    """A closed space curve with slowly varying radius and height, about unit spacing."""
    a = np.arange(count) * (2 * np.pi / count)
    r = count / (2 * np.pi) * (1 + 0.3 * np.cos(7 * a))
    return np.stack([r * np.cos(a), r * np.sin(a), 0.1 * count * np.sin(5 * a)], axis=1)


def scipy_times(points, samples, make=lambda t, x: CubicSpline(t, x, bc_type="periodic")):
    closed = np.vstack([points, points[:1]])
    chord = np.r_[0.0, np.cumsum(np.linalg.norm(np.diff(closed, axis=0), axis=1))]
    parameters = np.arange(samples * len(points)) * (chord[-1] / (samples * len(points)))
    build = evaluate = float("inf")
    for _ in range(5):
        start = time.perf_counter()
        spline = make(chord, closed)
        built = time.perf_counter()
        out = spline(parameters)
        evaluate = min(evaluate, time.perf_counter() - built)
        build = min(build, built - start)
    assert out.shape == (samples * len(points), points.shape[1])
    return build, evaluate


def our_times(points, samples):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "points.csv")
        np.savetxt(path, points, fmt="%.17g", delimiter=",")
        profile = os.environ.get("PROFILE", "release")
        command = ["cargo", "run", "--profile", profile, "--quiet", "--package", "cyclide", "--example", "spline_throughput", "--"]
        done = subprocess.run([*command, path, str(samples)], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    samples = int(sys.argv[2]) if len(sys.argv) > 2 else 16
    points = closed_points(count)
    cubics = {"planar": scipy_times(points[:, :2], samples), "space": scipy_times(points, samples)}
    total = count * samples
    print(f"{count} points, {total} samples; build in ms, evaluation in ns per sample, ratio = SciPy / ours")
    print(f"{'':38} {'build':>9} {'ratio':>7} {'evaluate':>9} {'ratio':>7}")
    for where, (build, evaluate) in cubics.items():
        name = f"SciPy CubicSpline, periodic, {where}"
        print(f"{name:38} {build * 1e3:9.2f} {'':7} {evaluate / total * 1e9:9.1f}")
    build, evaluate = scipy_times(points, samples, PchipInterpolator)
    print(f"{'SciPy Pchip, space':38} {build * 1e3:9.2f} {'':7} {evaluate / total * 1e9:9.1f}")
    for ours in our_times(points, samples):
        build, evaluate = cubics["planar" if "planar" in ours["name"] else "space"]
        ratios = f"{build / ours['build']:7.2f}", f"{evaluate / ours['evaluate']:7.2f}"
        print(f"{ours['name']:38} {ours['build'] * 1e3:9.2f} {ratios[0]} {ours['evaluate'] / total * 1e9:9.1f} {ratios[1]}")


if __name__ == "__main__":
    main()
