"""Surfaces of a model document, computed from the document's input data alone: the judge of the surface tests.

A principal patch of a Dupin cyclide is the quotient of bilinear quaternion forms

    f(s, t) = (sum a_k w_k B_k) (sum w_k B_k)^-1,   B = (1-s)(1-t), s(1-t), (1-s)t, st

with the weights w0 = 1, w1 = d01 v1, w2 = d02 v2, w3 = |a1 - a2|/|a0 - a3| d31 d10 v1 v2 for corners on one circle and an
orthonormal frame v1, v2 at the first (S. Zube, "Quaternionic Bezier curves, surfaces and volume", equations (9), (10)); the unit
normal is D V3 D^-1. Whole cyclides are taken from their trigonometric form. No code is shared with the program.
"""

import math

import numpy as np
from scipy.spatial import cKDTree

from quaternion_form import inverse, multiply, pure, unit

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(16)


def _chain(*factors):
    out = factors[0]
    for factor in factors[1:]:
        out = multiply(out, factor)
    return out


class Patch:
    """A principal patch from corners (0,0), (1,0), (0,1), (1,1) and the frame at the first."""

    def __init__(self, corners, v1, v2, offset=0.0):
        a = np.asarray([[*p, 0.0][:3] for p in corners], float)
        v1 = unit(v1)
        v2 = np.asarray(v2, float)
        v2 = unit(v2 - np.dot(v1, v2) * v1)
        self.v3 = pure(np.cross(v1, v2))
        b = [None] + [inverse(pure(a[k] - a[0])) for k in (1, 2, 3)]
        # (9) without d31, which has no direction where two corners are one: b3 (b1 - b2) v1 v2 times real factors.
        l1, l2 = math.dist(a[0], a[1]), math.dist(a[0], a[2])
        self.w = [
            np.array([1.0, 0.0, 0.0, 0.0]),
            multiply(b[1], pure(v1)) * l1,
            multiply(b[2], pure(v2)) * l2,
            _chain(b[3], b[1] - b[2], pure(v1), pure(v2)) * (l1 * l2),
        ]
        if offset:
            a = a + [offset * _chain(w, self.v3, inverse(w))[1:] for w in self.w]
        self.a = a
        self.n = [multiply(pure(p - a[0]), w) for p, w in zip(a, self.w)]

    def with_factors(self, lam, mu):
        """The same patch in other parameters: the weights times 1, lam, mu, lam mu."""
        for q in (self.w, self.n):
            q[1], q[2], q[3] = q[1] * lam, q[2] * mu, q[3] * (lam * mu)
        return self

    @staticmethod
    def _bilinear(q, s, t):
        s, t = np.asarray(s, float)[..., None], np.asarray(t, float)[..., None]
        return q[0] * (1 - s) * (1 - t) + q[1] * s * (1 - t) + q[2] * (1 - s) * t + q[3] * s * t

    def jet(self, s, t):
        """Point, derivatives by s and t, unit normal."""
        d, n = self._bilinear(self.w, s, t), self._bilinear(self.n, s, t)
        i = inverse(d)
        f = multiply(n, i)
        size = max(np.ptp(self.a, axis=0).max(), abs(f).max())
        assert abs(f[..., 0]).max() < 1e-9 * size, "the patch leaves three-space"

        def derivative(q, along):
            x = np.asarray(t if along == 0 else s, float)[..., None]
            pairs = ((0, 1), (2, 3)) if along == 0 else ((0, 2), (1, 3))
            (a, b), (c, e) = pairs
            return (q[b] - q[a]) * (1 - x) + (q[e] - q[c]) * x

        partial = [multiply(derivative(self.n, k) - multiply(f, derivative(self.w, k)), i)[..., 1:] for k in (0, 1)]
        normal = _chain(d, np.broadcast_to(self.v3, d.shape), i)[..., 1:]
        return self.a[0] + f[..., 1:], partial[0], partial[1], normal

    def area(self, cells=8):
        """Gauss-Legendre, 16 x 16 nodes on every cell."""
        edges = np.linspace(0.0, 1.0, cells + 1)
        x = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (_NODES + 1)).ravel()
        w = np.tile(0.5 * _WEIGHTS / cells, cells)
        s, t = np.meshgrid(x, x, indexing="ij")
        _, fs, ft, _ = self.jet(s, t)
        return float(np.einsum("i,j,ij", w, w, np.linalg.norm(np.cross(fs, ft), axis=-1)))

    def locate(self, points):
        """Distance to the patch and unit normal at the nearest place: nearest samples, then Gauss-Newton."""
        points = np.asarray(points, float)
        x = 0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, 65))
        s, t = (g.ravel() for g in np.meshgrid(x, x, indexing="ij"))
        _, nearest = cKDTree(self.jet(s, t)[0]).query(points)
        s, t = s[nearest], t[nearest]
        for _ in range(40):
            f, fs, ft, _ = self.jet(s, t)
            r = points - f
            # The parameter lines are orthogonal: two divisions.
            step = [np.sum(r * d, -1) / np.maximum(np.sum(d * d, -1), 1e-300) for d in (fs, ft)]
            s, t = (np.clip(u + np.clip(du, -0.05, 0.05), 0.0, 1.0) for u, du in zip((s, t), step))
        f, _, _, normal = self.jet(s, t)
        return np.linalg.norm(points - f, axis=-1), normal


def reflect(v, chord):
    """The vector reflected in the plane across the chord."""
    u = unit(chord)
    return v - 2.0 * np.dot(u, v) * u


def net(grid, v1, v2, closed=(False, False), offset=0.0):
    """The patches of a net over rows of points (s along a row), from the frame at its first point: frames go along every
    edge by reflection across it, the tangent along the edge reversed."""
    p = np.asarray(grid, float)
    rows, columns = p.shape[:2]
    frames = np.empty((rows, columns, 2, 3))
    v1 = unit(v1)
    frames[0, 0] = v1, unit(np.asarray(v2, float) - np.dot(v1, v2) * v1)
    for j in range(rows):
        for i in range(columns):
            if i:
                a, b, (e1, e2) = p[j, i - 1], p[j, i], frames[j, i - 1]
                frames[j, i] = -reflect(e1, b - a), reflect(e2, b - a)
            elif j:
                a, b, (e1, e2) = p[j - 1, i], p[j, i], frames[j - 1, i]
                frames[j, i] = reflect(e1, b - a), -reflect(e2, b - a)
    patches = []
    for j in range(rows if closed[1] else rows - 1):
        for i in range(columns if closed[0] else columns - 1):
            k, m = (i + 1) % columns, (j + 1) % rows
            patches.append(Patch([p[j, i], p[j, k], p[m, i], p[m, k]], *frames[j, i], offset=offset))
    return patches


def cyclide_point(a, c, mu, th, ps):
    """Point and unit normal of a cyclide in standard position."""
    b = math.sqrt(a * a - c * c)
    ct, st, cp, sp = np.cos(th), np.sin(th), np.cos(ps), np.sin(ps)
    den = a - c * ct * cp
    p = np.stack([mu * (c - a * ct * cp) + b * b * ct, b * st * (a - mu * cp), b * sp * (c * ct - mu)], -1)
    n = np.stack([c - a * ct * cp, -b * st * cp, -b * sp], -1)
    return p / den[..., None], n / den[..., None]


def cyclide_measures(a, c, mu, nodes=400):
    """Area and enclosed volume of a ring: the trapezoidal rule over both periods converges geometrically."""
    x = np.arange(nodes) * 2 * math.pi / nodes
    th, ps = np.meshgrid(x, x, indexing="ij")
    p, n = cyclide_point(a, c, mu, th, ps)
    b2, den = a * a - c * c, a - c * np.cos(th) * np.cos(ps)
    element = b2 * abs(a - mu * np.cos(ps)) * abs(mu - c * np.cos(th)) / den**2 * (2 * math.pi / nodes) ** 2
    return float(element.sum()), abs(float((np.sum(p * n, -1) * element).sum() / 3))


def cyclide_area(a, c, mu, cells=16):
    """Area of any cyclide: Gauss-Legendre between the angles at which a factor of the element changes its sign (nodes)."""

    def places(cosine):
        turn = math.acos(cosine) if abs(cosine) <= 1 else math.pi / 2
        ends = np.concatenate([np.linspace(x, y, cells + 1)[:-1] for x, y in ((0, turn), (turn, math.pi))] + [[math.pi]])
        half = 0.5 * np.diff(ends)[:, None]
        return ((ends[:-1, None] + half) + half * _NODES).ravel(), (half * _WEIGHTS).ravel()

    (th, wt), (ps, wp) = places(mu / c if c else 2.0), places(a / mu if mu else 2.0)
    element = (a * a - c * c) * abs(a - mu * np.cos(ps)) * abs(mu - c * np.cos(th[:, None])) / (a - c * np.cos(th[:, None]) * np.cos(ps)) ** 2
    # Both angles over half their period: the element is even in them.
    return float(4 * wt @ element @ wp)


def cyclide_distance(a, c, mu, points):
    """Distance to the cyclide in standard position and its normal there, to first order: the quartic over its gradient."""
    b2 = a * a - c * c
    x, y, _ = np.moveaxis(points, -1, 0)
    g = np.sum(points * points, -1) + b2 - mu * mu
    f = g * g - 4 * (a * x - c * mu) ** 2 - 4 * b2 * y * y
    gradient = 4 * g[..., None] * points
    gradient[..., 0] -= 8 * a * (a * x - c * mu)
    gradient[..., 1] -= 8 * b2 * y
    length = np.linalg.norm(gradient, axis=-1)
    return abs(f) / length, gradient / length[..., None]
