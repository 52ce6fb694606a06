"""Points and Jacobians of a block on a grid of 100 by 100 by 100: cyclide against its peers in one run.

    .venv/bin/python benches/compare_volumes.py [--profile NAME]

The block is a rational triquadratic for the peers: numpy (Bernstein products), SciPy (NdBSpline on homogeneous points), splinepy and geomdl
where they are installed (geomdl, which is plain Python, on 20 by 20 by 20 points, without Jacobians, which it does not give). Peers are checked
against a point and a Jacobian of ours. One thread; the smallest of several times is printed. Ratios are time of the peer over time of cyclide into a
buffer allocated by the call, which is what all peers do. Our side is built by cargo with the profile `release`, or another one.
"""

import json
import os
import subprocess
import sys
import time
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
REPETITIONS = 5
PROFILE = sys.argv[sys.argv.index("--profile") + 1] if "--profile" in sys.argv else "release"


def ours():
    command = ["cargo", "run", "--profile", PROFILE, "--quiet", "--locked", "--example", "volume_throughput"]
    done = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True)
    return json.loads(done.stdout)


OURS = ours()
COUNT = OURS["count"]
GRID = np.linspace(0, 1, COUNT)
ROWS = np.array(OURS["rows"]).reshape(3, 3, 3, 4)
KNOTS = np.array([0, 0, 0, 1, 1, 1.0])


def bernstein(t):
    return np.stack([(1 - t) ** 2, 2 * t * (1 - t), t * t], -1)


def slope(t):
    return np.stack([2 * (t - 1), 2 - 4 * t, 2 * t], -1)


def product(s, t, u):
    return np.einsum("ai,bj,ck,ijkd->abcd", s, t, u, ROWS, optimize=True)


def with_jacobian(h, derivatives):
    x = h[..., :3] / h[..., 3:]
    first = [(d[..., :3] - x * d[..., 3:]) / h[..., 3:] for d in derivatives]
    return x, np.einsum("...i,...i->...", np.cross(first[0], first[1]), first[2])


def numpy_both():
    b, d = bernstein(GRID), slope(GRID)
    return with_jacobian(product(b, b, b), [product(d, b, b), product(b, d, b), product(b, b, d)])


def scipy_both():
    from scipy.interpolate import NdBSpline

    form = NdBSpline((KNOTS,) * 3, ROWS, 2)
    places = np.stack(np.meshgrid(GRID, GRID, GRID, indexing="ij"), -1).reshape(-1, 3)
    shape = (COUNT, COUNT, COUNT, 4)
    at = [form(places, nu=nu).reshape(shape) for nu in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    return with_jacobian(at[0], at[1:])


def splinepy_both(splinepy):
    weights = ROWS[..., 3].transpose(2, 1, 0).reshape(-1, 1).copy()
    points = (ROWS[..., :3] / ROWS[..., 3:]).transpose(2, 1, 0, 3).reshape(-1, 3).copy()
    block = splinepy.RationalBezier(degrees=[2, 2, 2], control_points=points, weights=weights)
    places = np.stack(np.meshgrid(GRID, GRID, GRID, indexing="ij"), -1).reshape(-1, 3).copy()
    shape = (COUNT, COUNT, COUNT)

    def both():
        points = block.evaluate(places, nthreads=1)
        return points.reshape(*shape, 3), np.linalg.det(block.jacobian(places, nthreads=1)).reshape(shape)

    return both


def geomdl_points(count):
    from geomdl import NURBS

    volume = NURBS.Volume()
    volume.degree_u = volume.degree_v = volume.degree_w = 2
    # v fastest, then u, then w.
    volume.set_ctrlpts([list(ROWS[i, j, k]) for k in range(3) for i in range(3) for j in range(3)], 3, 3, 3)
    volume.knotvector_u = volume.knotvector_v = volume.knotvector_w = list(KNOTS)
    volume.sample_size = count
    return lambda: volume.evaluate() or volume.evalpts


def smallest(run, repetitions=REPETITIONS):
    least, result = np.inf, None
    for _ in range(repetitions):
        start = time.perf_counter()
        result = run()
        least = min(least, time.perf_counter() - start)
    return least, result


def check(name, points, jacobians):
    *wanted, jacobian = OURS["check"]
    assert np.abs(points[3, 50, 97] - wanted).max() < 1e-13, f"{name}: another point"
    assert abs(jacobians[3, 50, 97] - jacobian) < 1e-12, f"{name}: another Jacobian"


def line(name, seconds, count, times=None):
    millions = count / seconds / 1e6
    ratio = "" if times is None else f"{times:9.1f} x"
    print(f"{name:44}{seconds * 1e3:10.1f} ms{millions:10.2f} million/s{ratio}")


def main():
    total = COUNT**3
    print(f"{total} points and Jacobians of one block, one thread\n")
    line("cyclide, kept buffer", OURS["kept"], total)
    line("cyclide, fresh buffer", OURS["fresh"], total)
    line("cyclide, one by one", OURS["one by one"], total, OURS["one by one"] / OURS["fresh"])
    peers = [("numpy", numpy_both), ("SciPy NdBSpline", scipy_both)]
    try:
        import splinepy

        peers.append((f"splinepy {splinepy.__version__}", splinepy_both(splinepy)))
    except ImportError:
        print("splinepy is not installed: left out", file=sys.stderr)
    for name, run in peers:
        seconds, (points, jacobians) = smallest(run)
        check(name, points, jacobians)
        line(name, seconds, total, seconds / OURS["fresh"])
    try:
        count = 20
        run = geomdl_points(count)
    except ImportError:
        print("geomdl is not installed: left out", file=sys.stderr)
        return
    seconds, points = smallest(run, 2)
    wanted = numpy_small(count)
    off = min(np.abs(np.sort(np.array(points), axis=0) - np.sort(wanted, axis=0)).max(), np.inf)
    assert off < 1e-12, f"geomdl: other points, {off}"
    line("geomdl, points only, 20 x 20 x 20", seconds, count**3, seconds / count**3 / (OURS["fresh"] / total))


def numpy_small(count):
    b = bernstein(np.linspace(0, 1, count))
    h = product(b, b, b)
    return (h[..., :3] / h[..., 3:]).reshape(-1, 3)


if __name__ == "__main__":
    main()
