"""Points and normals of a patch on a 1000 by 1000 grid: cyclide against its peers in one run.

    .venv/bin/python benches/compare_surfaces.py [--rust-peers] [--default-allocator]

The patch is a quarter by a quarter of the torus with radii 2 and 1/2, a rational biquadratic for the peers: numpy
(Bernstein products), SciPy (two passes of BSpline on homogeneous points), splinepy where it is installed, and with
--rust-peers curvo and truck-geometry, which are built first (benches/peers, some minutes). Every peer's points are
checked against the torus. One thread; the smallest of several times is printed. Ratios are time of the peer over time of
cyclide, into a buffer allocated by the call, which is what all peers but the two Rust loops do, and into a kept one.

Memory is the limit, not arithmetic: the first line of each table is a fresh buffer of the same size (24 MB; points and
normals have two) that is filled with one number. What a fresh buffer costs is up to the allocator: pages of 4 kB from the
system alone take longer than all arithmetic. So all programs run under the same one, glibc's with 2 MB pages (as numpy
asks for) and with freed memory kept for the next buffer. --default-allocator leaves that out.
"""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

ALLOCATOR = "glibc.malloc.hugetlb=1:glibc.malloc.mmap_threshold=1073741824:glibc.malloc.trim_threshold=4294967296"
if "--default-allocator" not in sys.argv[1:] and "GLIBC_TUNABLES" not in os.environ:
    # It is read when a process starts: this one starts again.
    os.execve(sys.executable, [sys.executable, *sys.argv], {**os.environ, "GLIBC_TUNABLES": ALLOCATOR})

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from scipy.interpolate import BSpline

ROOT = Path(__file__).resolve().parent.parent
COUNT = 1000
GRID = np.linspace(0, 1, COUNT)
KNOTS = np.array([0, 0, 0, 1, 1, 1.0])


def homogeneous():
    """Control rows [i][j] = [wx, wy, wz, w], i about the axis."""
    half = np.sqrt(0.5)
    turn = [(1, 0, 1), (1, 1, half), (0, 1, 1)]
    profile = [(2.5, 0, 1), (2.5, 0.5, half), (2, 0.5, 1)]
    return np.array([[[r * x * u * v, r * y * u * v, z * u * v, u * v] for r, z, v in profile] for x, y, u in turn])


ROWS = homogeneous()


def quotient(h):
    return h[..., :3] / h[..., 3:]


def with_normals(h, hu, hv):
    x = quotient(h)
    normal = np.cross(hu[..., :3] - x * hu[..., 3:], hv[..., :3] - x * hv[..., 3:])
    return x, normal / np.linalg.norm(normal, axis=-1, keepdims=True)


def bernstein(t):
    return np.stack([(1 - t) ** 2, 2 * t * (1 - t), t * t], -1)


def bernstein_derivative(t):
    return np.stack([2 * (t - 1), 2 - 4 * t, 2 * t], -1)


def numpy_product(u, v):
    return np.matmul(v[None], np.tensordot(u, ROWS, 1))


def numpy_points():
    b = bernstein(GRID)
    return quotient(numpy_product(b, b))


def numpy_normals():
    b, d = bernstein(GRID), bernstein_derivative(GRID)
    return with_normals(numpy_product(b, b), numpy_product(d, b), numpy_product(b, d))


def scipy_points():
    along = BSpline(KNOTS, ROWS, 2)(GRID).transpose(1, 0, 2)
    return quotient(BSpline(KNOTS, along, 2)(GRID))


def scipy_normals():
    first = BSpline(KNOTS, ROWS, 2)
    second = BSpline(KNOTS, first(GRID).transpose(1, 0, 2), 2)
    slope = BSpline(KNOTS, first.derivative()(GRID).transpose(1, 0, 2), 2)
    return with_normals(second(GRID), slope(GRID), second.derivative()(GRID))


def peers():
    yield "numpy", numpy_points, numpy_normals
    yield "SciPy BSpline, two passes", scipy_points, scipy_normals
    try:
        import splinepy
    except ImportError:
        print("splinepy is not installed: left out", file=sys.stderr)
        return
    weights = ROWS[..., 3].T.reshape(-1, 1).copy()
    points = (ROWS[..., :3] / ROWS[..., 3:]).transpose(1, 0, 2).reshape(-1, 3).copy()
    surface = splinepy.RationalBezier(degrees=[2, 2], control_points=points, weights=weights)
    queries = np.stack(np.meshgrid(GRID, GRID, indexing="ij"), -1).reshape(-1, 2).copy()

    def normals():
        jacobian = surface.jacobian(queries, nthreads=1)
        normal = np.cross(jacobian[:, :, 0], jacobian[:, :, 1])
        return surface.evaluate(queries, nthreads=1), normal / np.linalg.norm(normal, axis=1, keepdims=True)

    yield f"splinepy {splinepy.__version__}", lambda: surface.sample([COUNT, COUNT], nthreads=1), normals


def check(points):
    flat = points.reshape(-1, 3)
    off = np.abs(np.hypot(np.hypot(flat[:, 0], flat[:, 1]) - 2, flat[:, 2]) - 0.5).max()
    assert len(flat) == COUNT**2 and off < 1e-13, f"{off} off the torus"


def smallest(run, times):
    least = float("inf")
    for _ in range(times):
        start = time.perf_counter()
        run()
        least = min(least, time.perf_counter() - start)
    return least


def rust(command):
    done = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return [json.loads(line) for line in done.stdout.splitlines()]


def main():
    build = ["cargo", "run", "--release", "--quiet"]
    rows = rust([*build, "--package", "cyclide", "--example", "surface_throughput"])
    for name, points, normals in peers():
        check(points())
        check(normals()[0])
        rows.append({"name": name, "kind": "points", "buffer": "fresh", "seconds": smallest(points, 7)})
        rows.append({"name": name, "kind": "normals", "buffer": "fresh", "seconds": smallest(normals, 5)})
    if "--rust-peers" in sys.argv[1:]:
        rows += rust([*build, "--manifest-path", "benches/peers/Cargo.toml"])
    ours = {(row["kind"], row["buffer"]): row["seconds"] for row in rows if row["name"] == "cyclide"}
    for kind, title in [("points", "points"), ("normals", "points and normals")]:
        print(f"{title} on {COUNT} x {COUNT}")
        print(f"  {'':36} {'buffer':20} {'million/s':>10} {'ratio to fresh':>15} {'to kept':>8}")
        best = {"fresh": float("inf"), "kept": float("inf")}
        for row in (row for row in rows if row["kind"] == kind):
            ratios = {buffer: row["seconds"] / ours[kind, buffer] for buffer in best}
            if row["name"] != "cyclide" and not row["name"].startswith("memory"):
                best = {buffer: min(least, ratios[buffer]) for buffer, least in best.items()}
            rate = COUNT**2 / row["seconds"] / 1e6
            print(f"  {row['name']:36} {row['buffer']:20} {rate:10.1f} {ratios['fresh']:15.2f} {ratios['kept']:8.2f}")
        print(f"  the best peer takes {best['fresh']:.1f} and {best['kept']:.1f} times as long\n")


if __name__ == "__main__":
    main()
