"""Side-vertex patches of circle blends over triangles, from their formulas, and angle-weighted normals.

A blend of order 2 between two points p, q with unit tangents: x = p + |d| l N / |N|^2 with N = l u + (1 - l) t(l), d = q - p = |d| u;
t(l) runs on a circle of directions from the tangent t1 at p to the reflected tangent t2 of q, turned by f(l) = 3 l^2 - 2 l^3.
Tangents are what the chord has across the normals. A patch is the mean of the blends from its corners to the opposite sides with the weights
(lam_j lam_k)^2. Nothing here is taken from the program.
"""

import numpy as np


def unit(v):
    return v / np.linalg.norm(v)


def across(v, n):
    return v - n * np.dot(v, n)


def blend(p, n, q, m, l):
    d = q - p
    length = np.linalg.norm(d)
    u = d / length
    t1, te = unit(across(u, n)), unit(across(u, m))
    t2 = 2 * np.dot(u, te) * u - te
    a, g = t1 + t2, t2 - t1
    angle = 2 * np.arctan2(np.linalg.norm(g), np.linalg.norm(a))
    if np.linalg.norm(g) < 1e-15:
        angle, b = 0.0, np.zeros(3)
    else:
        b = np.linalg.norm(a) / 2 * unit(g) + np.linalg.norm(g) / 2 * unit(a)
        if np.dot(u + t1, u + t2) < 0:
            angle, b = 2 * np.pi - angle, -b
    f = l * l * (3 - 2 * l)
    way = l * u + (1 - l) * (np.cos(f * angle) * t1 + np.sin(f * angle) * b)
    return p + length * l * way / np.dot(way, way)


def side(p, n, q, m, mu):
    """Point and normal of a side: of the mean normal what is across the curve."""
    h = 1e-6
    step = min(h, mu / 2, (1 - mu) / 2)
    along = unit(blend(p, n, q, m, mu + step) - blend(p, n, q, m, mu - step))
    return blend(p, n, q, m, mu), unit(across((1 - mu) * n + mu * m, along))


def patch(corners, normals, lam):
    """A point inside: no coordinate is 0."""
    total = weights = 0.0
    for i in range(3):
        j, k = (i + 1) % 3, (i + 2) % 3
        mu = lam[k] / (lam[j] + lam[k])
        foot, normal = side(corners[j], normals[j], corners[k], normals[k], mu)
        weight = (lam[j] * lam[k]) ** 2
        total = total + weight * blend(corners[i], normals[i], foot, normal, 1 - lam[i])
        weights += weight
    return total / weights


def angle_normals(points, triangles):
    sums = np.zeros_like(points)
    for triangle in triangles:
        a, b, c = points[triangle]
        normal = unit(np.cross(b - a, c - a))
        for k in range(3):
            p, q, r = np.roll(points[triangle], -k, axis=0)
            x, y = unit(q - p), unit(r - p)
            sums[triangle[k]] += normal * np.arctan2(np.linalg.norm(np.cross(x, y)), np.dot(x, y))
    return sums / np.linalg.norm(sums, axis=1, keepdims=True)
