"""Motions through poses against SciPy's RotationSpline and Slerp with splines of the positions, and curves through five and seven points against
rational-linkages, all in one run.

    .venv/bin/python benches/compare_motions.py [POSES] [SAMPLES_PER_SPAN] [JUDGE]      default 10000 16

JUDGE: the Python of an environment with rational-linkages (see tests/foreign/judges); without it those lines are left out. One thread;
the smallest of five times. Both sides give rotations as quaternions and positions. SciPy's rotations and positions are splines
of their own (RotationSpline is C2 in rotations, Slerp C0): points of the body do not run on rational curves. The comparison is of speed only.
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
from scipy.interpolate import CubicSpline, interp1d
from scipy.spatial.transform import Rotation, RotationSpline, Slerp

ROOT = Path(__file__).resolve().parent.parent
# Solves curves of random points; prints seconds for each count.
JUDGED = """
import json, sys, time
from rational_linkages import MotionInterpolation, PointHomogeneous
for points in json.load(sys.stdin):
    best = float("inf")
    for _ in range(3):
        start = time.perf_counter()
        MotionInterpolation.interpolate([PointHomogeneous([1.0, *p]) for p in points])
        best = min(best, time.perf_counter() - start)
    print(len(points), best)
"""


def poses(count):
    """A wandering body: times, positions, quaternions (w, x, y, z)."""
    t = np.arange(count) + 0.2 * np.sin(np.arange(count))
    positions = np.stack([20 * np.sin(0.21 * t), 15 * np.cos(0.17 * t), 0.1 * t], axis=1)
    rotations = Rotation.from_rotvec(np.stack([np.sin(0.3 * t), np.cos(0.23 * t), 0.5 * np.sin(0.11 * t)], axis=1))
    return t, positions, rotations


def scipy_times(make, samples):
    build = evaluate = float("inf")
    for _ in range(5):
        start = time.perf_counter()
        rotation, position = make()
        built = time.perf_counter()
        quaternions, points = rotation(samples).as_quat(), position(samples)
        evaluate = min(evaluate, time.perf_counter() - built)
        build = min(build, built - start)
    assert len(quaternions) == len(points) == len(samples)
    return build, evaluate


def our_times(t, positions, rotations, samples):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "poses.csv")
        table = np.column_stack([t, positions, rotations.as_quat()[:, [3, 0, 1, 2]]])
        np.savetxt(path, table, fmt="%.17g", delimiter=",")
        profile = os.environ.get("PROFILE", "release")
        command = ["cargo", "run", "--profile", profile, "--quiet", "--package", "cyclide", "--example", "motion_throughput", "--"]
        done = subprocess.run([*command, path, str(samples)], cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def main():
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 10_000
    per_span = int(sys.argv[2]) if len(sys.argv) > 2 else 16
    t, positions, rotations = poses(count)
    total = per_span * (count - 1)
    samples = t[0] + (t[-1] - t[0]) * np.arange(total) / total
    smooth = scipy_times(lambda: (RotationSpline(t, rotations), CubicSpline(t, positions)), samples)
    linear = scipy_times(lambda: (Slerp(t, rotations), interp1d(t, positions, axis=0)), samples)
    ours = our_times(t, positions, rotations, per_span)
    print(f"{count} poses, {total} samples; build in ms, poses in millions a second, ratio = ours / SciPy in speed")
    print(f"{'':44} {'build':>9} {'ratio':>7} {'poses/s':>9} {'ratio':>7}")
    for name, peer, (build, evaluate) in (
        ("SciPy RotationSpline + CubicSpline", "spline", smooth),
        ("SciPy Slerp + linear", "screws", linear),
    ):
        print(f"{name:44} {build * 1e3:9.2f} {'':7} {total / evaluate / 1e6:9.2f}")
        for row in (row for row in ours if row["name"] == peer):
            ratios = f"{build / row['build']:7.2f}", f"{evaluate / row['evaluate']:7.2f}"
            print(f"{'  our ' + peer:44} {row['build'] * 1e3:9.2f} {ratios[0]} {total / row['evaluate'] / 1e6:9.2f} {ratios[1]}")
    solves = {row["points"]: row for row in ours if row["name"] == "interpolation"}
    judged = {}
    if len(sys.argv) > 3:
        given = json.dumps([row["given"] for row in solves.values()])
        done = subprocess.run([sys.argv[3], "-c", JUDGED], input=given, check=True, stdout=subprocess.PIPE, text=True)
        judged = {int(n): float(s) for n, s in (line.split() for line in done.stdout.splitlines())}
    for n, row in solves.items():
        ratio = f", rational-linkages {judged[n] * 1e6:.0f} µs, ratio {judged[n] / row['build']:.0f}" if n in judged else ""
        print(f"curve through {n} points: {row['build'] * 1e6:.2f} µs{ratio}")


if __name__ == "__main__":
    main()
