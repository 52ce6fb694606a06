"""Blends between pipes against what defines them: envelopes of balls that touch both, computed from points and normals alone; and
tangency along the edges of such bodies."""

import math

import numpy as np

from step_checks import PLACES, POINT_LIMIT
from step_faces import Edge, angle

# Of normals at edges: the reader's own curves in the parameters are interpolated, and corrected here by Newton steps.
TANGENT = 1e-6


def off_axis(points, axis):
    origin, way, *_ = axis
    v = points - origin
    return v - (v @ way)[..., None] * way


def off_pipe(points, pipe):
    """Distance of points from a pipe, a cylinder or a cone."""
    origin, way, radius, taper = pipe
    return (np.linalg.norm(off_axis(points, pipe), axis=-1) - radius) * math.cos(taper) + (points - origin) @ way * math.sin(taper)


def ball(points, normals, axis, depth):
    """The radius of the ball that touches a pipe and has a point with this normal: |P + R N| = r + R across the axis, of a cone a linear form q + p R."""
    origin, way, r, taper = axis
    rise = normals @ way
    v, n = off_axis(points, axis), normals - rise[..., None] * way
    p = (1 - rise * math.sin(taper)) / math.cos(taper)
    q = r - (depth + (points - origin) @ way * math.sin(taper)) / math.cos(taper)
    # (n.n - p^2) R^2 + 2 (v.n - p q) R + v.v - q^2 = 0; stable for n.n near p^2.
    a, b, c = np.sum(n * n, -1) - p * p, np.sum(v * n, -1) - p * q, np.sum(v * v, -1) - q * q
    root = np.sqrt(np.maximum(b * b - a * c, 0))
    first, second = -c / (b - root), -c / (b + root)
    return first, second


def check_envelopes(step, is_blend, pairs, wall):
    """Every blend face is, at more than 10,000 points in all, of balls that touch both pipes of one of the pairs; each pair comes with the
    least and greatest radius that the report gives. The count of the faces is returned."""
    blends = [face for face in step.faces if is_blend(face)]
    count = max(6, math.ceil(math.sqrt(10_000 / len(blends))))
    along, across = np.linspace(0.03, 0.97, count), np.linspace(0.04, 0.96, count)
    total = 0
    for face in blends:
        turned = face.rational.degrees[0] == 2
        x, y = (across[None, :], along[:, None]) if turned else (along[:, None], across[None, :])
        x, y = np.broadcast_arrays(x, y)
        points, normals = face.at_all(*face.rational.scaled(x, y))
        normals = normals / np.linalg.norm(normals, axis=-1, keepdims=True)
        skins = ((0.0, 1.0), (wall, -1.0))[: 2 if wall else 1]
        errors = [departure(points, sign * normals, pipes, radii, depth) for pipes, radii in pairs for depth, sign in skins]
        assert min(errors) <= POINT_LIMIT * step.size()
        total += points.shape[0] * points.shape[1]
    assert total >= 10_000
    return len(blends)


def departure(points, normals, pipes, radii, depth):
    """How far the balls at points, each row of which is on one ball, are from touching pipes that are thinner by the depth, with radii in a range."""
    errors = []
    for radius in ball(points, normals, pipes[0], depth):
        centre = points + radius[..., None] * normals
        touches = abs(off_pipe(centre, pipes[1]) + depth - radius)
        # One ball for all points of a circle.
        moves = np.linalg.norm(centre - centre[:, :1], axis=-1) + abs(radius - radius[:, :1])
        outside = np.maximum(radii["min"] + depth - radius, radius - radii["max"] - depth)
        errors.append(max(touches.max(), moves.max(), outside.max(), 0.0))
    return min(errors)


def smooth_edges(users, is_blend):
    """The largest angle between normals at smooth edges, the count of edges between a blend and a pipe, and of the creases at plane ends."""
    creases, smooth, contacts = 0, 0.0, 0
    for (first, edge), (second, other) in users:
        points = np.array([Edge(edge).point(x) for x in PLACES])
        sides = [face.normals_near(points, own, PLACES) for face, own in ((first, edge), (second, other))]
        largest = max(map(angle, *sides))
        if largest > 0.1:
            creases += 1
            assert "plane" in (first.kind, second.kind) or math.isclose(largest, math.pi / 2, abs_tol=1e-6)
        else:
            smooth = max(smooth, largest)
            contacts += is_blend(first) != is_blend(second)
    return smooth, contacts, creases
