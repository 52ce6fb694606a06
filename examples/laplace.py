"""Laplace's equation on grids of cyclide: the seven-point scheme, which only orthogonal grids allow.

    python3 examples/laplace.py [PROGRAM]

PROGRAM is the command cyclide; needs numpy and SciPy. Each unknown has six neighbours; the flux between two nodes is the area between them over their
distance, which is right to second order where the grid is orthogonal, and without cross derivatives is wrong elsewhere by a constant. Values are given on
the boundary by a harmonic function, which is then also the solution inside. Three grids:

- a block (`cyclide-volume`), its nodes as `cyclide sample` gives them;
- the trilinear block with the same eight corners, whose lines are skew;
- the wall of a bent tube (`cyclide-grid`), blocks between two Dupin cyclides, closed in both directions, its nodes from `cyclide sample --cells`.
"""

import csv
import io
import itertools
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import cg

CORNERS = [[0, 0, 0], [1, 0.15, -0.1], [-0.2, 0.9, 0.1], [0.1, -0.1, 0.8]]
TUBE = {"a": 4, "c": 1, "mu": [1.4, 2], "segments": [4, 4]}


def harmonic(p, size):
    """Harmonic in space: its Laplacian is (2 - 1 - 1) of itself."""
    x, y, z = np.moveaxis(p / size, -1, 0)
    return np.exp(np.sqrt(2) * x) * np.cos(y) * np.sin(z + 0.3)


def rows(program, document, *options):
    """The table that the program samples."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "grid.json")
        path.write_text(json.dumps({"cyclide": 1, "objects": {"grid": document}}))
        done = subprocess.run([program, "sample", path, *options], check=True, capture_output=True, text=True)
    return list(csv.DictReader(io.StringIO(done.stdout)))


def points(table):
    return np.array([[float(row[name]) for name in "xyz"] for row in table])


def block(program, n):
    """Nodes [i, j, k] of a block, i along s."""
    table = rows(program, {"type": "cyclide-volume", "corners": CORNERS}, "--count", str(n + 1))
    return points(table).reshape(n + 1, n + 1, n + 1, 3).transpose(2, 1, 0, 3)


def skewed(nodes):
    """The trilinear block with the same corners and as many nodes."""
    t = np.linspace(0, 1, len(nodes))
    ends = np.stack([1 - t, t], -1)
    corners = nodes[:: len(t) - 1, :: len(t) - 1, :: len(t) - 1]
    return np.einsum("ai,bj,ck,ijkd->abcd", ends, ends, ends, corners)


def tube(program, n):
    """Nodes of the wall, closed along s and t: n cells in each direction of every block."""
    table = rows(program, {"type": "cyclide-grid", "whole": TUBE, "cells": n}, "--cells")
    nodes = points(table).reshape(4, 4, n + 1, n + 1, n + 1, 3)  # block t, block s, u, t, s
    nodes = nodes[:, :, :, :n, :n]
    return nodes.transpose(1, 4, 0, 3, 2, 5).reshape(4 * n, 4 * n, n + 1, 3)


def solve(nodes, closed, size):
    """Largest error of the seven-point scheme, relative to the range of the solution."""
    exact = harmonic(nodes, size)
    shape = exact.shape
    number = np.arange(exact.size).reshape(shape)
    inner = np.ones(shape, bool)
    for axis in range(3):
        if not closed[axis]:
            inner[tuple([0, -1] if d == axis else slice(None) for d in range(3))] = False
    # Lengths of sides from each node to the next, and half of those on both sides of a node.
    ahead, width = [], []
    for axis in range(3):
        length = np.linalg.norm(np.roll(nodes, -1, axis) - nodes, axis=-1)
        ahead.append(length)
        width.append(0.5 * (length + np.roll(length, 1, axis)))
    entries = []
    for axis in range(3):
        a, b = [d for d in range(3) if d != axis]
        area = [width[d] + np.roll(width[d], -1, axis) for d in (a, b)]
        flux = 0.25 * area[0] * area[1] / ahead[axis]
        i, j = number.ravel(), np.roll(number, -1, axis).ravel()
        # A pair that goes over an open end is none, and so is one of two nodes whose values are given.
        used = inner.ravel()[i] | inner.ravel()[j]
        if not closed[axis]:
            last = np.zeros(shape, bool)
            last[tuple(-1 if d == axis else slice(None) for d in range(3))] = True
            used &= ~last.ravel()
        entries.append((i[used], j[used], flux.ravel()[used]))
    i, j, flux = (np.concatenate(part) for part in zip(*entries))
    total = np.bincount(i, flux, exact.size) + np.bincount(j, flux, exact.size)
    matrix = coo_matrix(
        (np.concatenate([-flux, -flux, total]), (np.concatenate([i, j, number.ravel()]), np.concatenate([j, i, number.ravel()])))
    ).tocsr()
    unknown, known = number[inner], number[~inner]
    system = matrix[unknown][:, unknown]
    right = -matrix[unknown][:, known] @ exact[~inner]
    scale = 1 / np.sqrt(system.diagonal())
    scaled = coo_matrix(system).multiply(scale[:, None]).multiply(scale[None, :]).tocsr()
    found, stopped = cg(scaled, right * scale, rtol=1e-12, maxiter=10_000)
    assert stopped == 0, "the solver did not come to its end"
    return np.abs(found * scale - exact[inner]).max() / np.ptp(exact)


def table(program, divisions):
    """Rows [grid, divisions, error, order]; the order is none in the first row of a grid."""
    made = {
        "block": lambda n: solve(block(program, n), [False] * 3, 1),
        "trilinear": lambda n: solve(skewed(block(program, n)), [False] * 3, 1),
        "tube": lambda n: solve(tube(program, n // 2), [True, True, False], 4),
    }
    found = []
    for name, error in made.items():
        errors = [error(n) for n in divisions]
        orders = [None] + [np.log(a / b) / np.log(m / n) for (a, b), (n, m) in zip(itertools.pairwise(errors), itertools.pairwise(divisions))]
        found.extend(zip(itertools.repeat(name), divisions, errors, orders))
    return found


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "cyclide"
    print(f"{'grid':12}{'divisions':>10}{'largest error':>16}{'order':>8}")
    for name, n, error, order in table(program, [8, 16, 32]):
        print(f"{name:12}{n:>10}{error:>16.2e}{'' if order is None else f'{order:.2f}':>8}")


if __name__ == "__main__":
    main()
