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

from quaternion_form import cross, inverse, multiply, pure, unit

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

    def jet(self, s, t):
        """Point, derivatives by s and t, unit normal."""
        s, t = np.broadcast_arrays(np.asarray(s, float), np.asarray(t, float))
        rows = np.concatenate([self.w, self.n], axis=1)  # denominator and numerator side by side
        forms = np.stack([(1 - s) * (1 - t), s * (1 - t), (1 - s) * t, s * t], -1) @ rows
        slopes = (
            np.stack([1 - t, t], -1) @ (rows[[1, 3]] - rows[[0, 2]]),
            np.stack([1 - s, s], -1) @ (rows[[2, 3]] - rows[[0, 1]]),
        )
        d, n = forms[..., :4], forms[..., 4:]
        i = inverse(d)
        f = multiply(n, i)
        size = max(np.ptp(self.a, axis=0).max(), abs(f).max())
        assert abs(f[..., 0]).max() < 1e-9 * size, "the patch leaves three-space"

        partial = [multiply(slope[..., 4:] - multiply(f, slope[..., :4]), i)[..., 1:] for slope in slopes]
        normal = _chain(d, np.broadcast_to(self.v3, d.shape), i)[..., 1:]
        return self.a[0] + f[..., 1:], partial[0], partial[1], normal

    def area(self, cells=8):
        """Gauss-Legendre, 16 x 16 nodes on every cell."""
        edges = np.linspace(0.0, 1.0, cells + 1)
        x = (edges[:-1, None] + np.diff(edges)[:, None] * 0.5 * (_NODES + 1)).ravel()
        w = np.tile(0.5 * _WEIGHTS / cells, cells)
        s, t = np.meshgrid(x, x, indexing="ij")
        _, fs, ft, _ = self.jet(s, t)
        return float(w @ np.linalg.norm(cross(fs, ft), axis=-1) @ w)

    def length(self, side):
        """Length of the side t=0, t=1, s=0 or s=1."""
        along, at = side // 2, np.full(len(_NODES), float(side % 2))
        x = 0.5 * (_NODES + 1)
        jet = self.jet(x, at) if along == 0 else self.jet(at, x)
        return float(0.5 * _WEIGHTS @ np.linalg.norm(jet[1 + along], axis=-1))

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
            before = s, t
            s, t = (np.clip(u + np.clip(du, -0.05, 0.05), 0.0, 1.0) for u, du in zip((s, t), step))
            if max(abs(s - before[0]).max(), abs(t - before[1]).max()) < 1e-15:
                break
        f, _, _, normal = self.jet(s, t)
        return np.linalg.norm(points - f, axis=-1), normal


# Corners at the ends of the sides t=0, t=1, s=0, s=1 and the direction along them.
SIDES = ((0, 1, 0), (2, 3, 0), (0, 2, 1), (1, 3, 1))


def rim(first, second, side):
    """The ruled patch between two parallel patches along a side; none at a side that is a point of both."""
    i, j, along = SIDES[side]
    # The first two corners are apart: at a tip one of the patches has only one.
    first, second = sorted((first, second), key=lambda patch: -math.dist(patch.a[i], patch.a[j]))
    if math.dist(first.a[i], first.a[j]) == 0.0:
        return None
    tangent = first.jet(*(np.array(float(i >> bit & 1)) for bit in (0, 1)))[1 + along]
    return Patch([first.a[i], first.a[j], second.a[i], second.a[j]], tangent, second.a[i] - first.a[i])


def layer(first, second, columns=1, closed=(False, False)):
    """The faces of the layer between two parallel nets of so many patches a row: both nets and the rims along free sides."""
    rows = len(first) // columns
    rims = []
    for k, pair in enumerate(zip(first, second)):
        free = (k < columns, k >= (rows - 1) * columns, k % columns == 0, k % columns == columns - 1)
        rims += [rim(*pair, side) for side in range(4) if free[side] and not closed[1 - SIDES[side][2]]]
    return [*first, *second, *(r for r in rims if r)]


def reflect(v, chord):
    """The vector reflected in the plane across the chord."""
    u = unit(chord)
    return v - 2.0 * np.dot(u, v) * u


def _carried(p, vectors):
    """Vectors at the first of the rows of points, carried to all by reflection across the edges."""
    out = np.empty((*p.shape[:2], *np.shape(vectors)))
    for j in range(p.shape[0]):
        for i in range(p.shape[1]):
            before = (j, i - 1) if i else (j - 1, 0)
            out[j, i] = [reflect(v, p[j, i] - p[before]) for v in out[before]] if i or j else vectors
    return out


def net(grid, v1, v2, closed=(False, False), offset=0.0):
    """The patches of a net over rows of points (s along a row), from the frame at its first point: frames go along every
    edge by reflection across it, the tangent along the edge reversed."""
    p = np.asarray(grid, float)
    rows, columns = p.shape[:2]
    v1 = unit(v1)
    frames = _carried(p, [v1, unit(np.asarray(v2, float) - np.dot(v1, v2) * v1)])
    frames[:, 1::2, 0] *= -1
    frames[1::2, :, 1] *= -1
    patches = []
    for j in range(rows if closed[1] else rows - 1):
        for i in range(columns if closed[0] else columns - 1):
            k, m = (i + 1) % columns, (j + 1) % rows
            patches.append(Patch([p[j, i], p[j, k], p[m, i], p[m, k]], *frames[j, i], offset=offset))
    return patches


def residuals(grid):
    """How far the quads of rows of points are from circles: the vector part of the product of their unit edges."""
    p = np.asarray(grid, float)
    round_ = [p[:-1, :-1], p[:-1, 1:], p[1:, 1:], p[1:, :-1], p[:-1, :-1]]
    edges = np.diff(round_, axis=0)
    product = _chain(*pure(edges / np.linalg.norm(edges, axis=-1, keepdims=True)))
    return np.linalg.norm(product[..., 1:], axis=-1)


def line_tangent(line, k):
    """Unit tangent at a point of a line of points: of the circle through it and its neighbors, at an end the next two."""
    first = min(max(k - 1, 0), len(line) - 3)
    if len(line) == 2:
        return unit(line[1] - line[0])
    a, b, c = line[first : first + 3]
    normal = np.cross(b - a, c - a)
    u, v = b - a, c - a
    if np.linalg.norm(normal) < 1e-9 * np.linalg.norm(u) * np.linalg.norm(v):
        return unit(v)
    # The circumcentre from a.
    centre = a + np.cross(u @ u * v - v @ v * u, normal) / (2 * normal @ normal)
    return unit(np.cross(normal, line[k] - centre))


def fitted_frame(grid):
    """The frame at the first point of an open net whose copies are nearest to the lines: the rotation nearest to the sum
    of the orthonormal frames nearest to the tangents of the lines at each point, carried back to the first."""
    p = np.asarray(grid, float)
    back, total = _carried(p, np.eye(3)), np.zeros((3, 3))
    rows, columns = p.shape[:2]
    for j in range(rows):
        for i in range(columns):
            tangents = [line_tangent(p[j], i), line_tangent(p[:, i], j)]
            u, _, v = np.linalg.svd(np.stack(tangents, axis=1), full_matrices=False)
            t1, t2 = (u @ v).T
            total += back[j, i] @ np.stack([t1 * (-1) ** i, t2 * (-1) ** j, np.cross(t1, t2)], axis=1)
    u, _, v = np.linalg.svd(total)
    rotation = u @ np.diag([1.0, 1.0, np.linalg.det(u @ v)]) @ v
    return rotation[:, 0], rotation[:, 1]


def cyclide_point(a, c, mu, th, ps):
    """Point and unit normal of a cyclide in standard position."""
    b = math.sqrt(a * a - c * c)
    ct, st, cp, sp = np.cos(th), np.sin(th), np.cos(ps), np.sin(ps)
    den = a - c * ct * cp
    p = np.stack([mu * (c - a * ct * cp) + b * b * ct, b * st * (a - mu * cp), b * sp * (c * ct - mu)], -1)
    n = np.stack([c - a * ct * cp, -b * st * cp, -b * sp], -1)
    return p / den[..., None], n / den[..., None]


def cyclide_measures(a, c, mu, inversion=None, nodes=400):
    """Area and enclosed volume of a ring, or of its image under an inversion (centre, radius) that leaves it finite: the
    trapezoidal rule over both periods converges geometrically."""
    x = np.arange(nodes) * 2 * math.pi / nodes
    th, ps = np.meshgrid(x, x, indexing="ij")
    p, n = cyclide_point(a, c, mu, th, ps)
    b2, den = a * a - c * c, a - c * np.cos(th) * np.cos(ps)
    element = b2 * abs(a - mu * np.cos(ps)) * abs(mu - c * np.cos(th)) / den**2 * (2 * math.pi / nodes) ** 2
    if inversion:
        p, n, stretch = _inverted(p, n, *inversion)
        element = element * stretch**2
    return float(element.sum()), abs(float((np.sum(p * n, -1) * element).sum() / 3))


def _inverted(points, normals, center, radius):
    """Images of points and unit normals under an inversion, and by how much it stretches there."""
    v = points - np.asarray(center, float)
    d2 = np.sum(v * v, -1, keepdims=True)
    image = normals - 2 * v * np.sum(v * normals, -1, keepdims=True) / d2
    return center + v * (radius**2 / d2), image, radius**2 / d2[..., 0]


def inverted(locate, center, radius):
    """`locate` (points to distances and normals) of the image of a surface under an inversion, distances to first order."""

    def located(points):
        back, _, stretch = _inverted(points, points, center, radius)
        distance, normals = locate(back)
        return distance / stretch, _inverted(back, normals, center, radius)[1]

    return located


def cyclide_lobes(a, c, mu, cells=16):
    """Areas and enclosed volumes of the lobes between the nodes of any cyclide, a ring being one: Gauss-Legendre between the
    angles at which a factor of the element changes its sign (nodes)."""

    def places(cosine):
        turn = math.acos(cosine) if abs(cosine) <= 1 else math.pi / 2
        ends = np.concatenate([np.linspace(x, y, cells + 1)[:-1] for x, y in ((0, turn), (turn, math.pi))] + [[math.pi]])
        half = 0.5 * np.diff(ends)[:, None]
        return ((ends[:-1, None] + half) + half * _NODES).ravel(), (half * _WEIGHTS).ravel()

    (th, wt), (ps, wp) = places(mu / c if c else 2.0), places(a / mu if mu else 2.0)
    th, ps = np.meshgrid(th, ps, indexing="ij")
    element = (a * a - c * c) * (a - mu * np.cos(ps)) * (mu - c * np.cos(th)) / (a - c * np.cos(th) * np.cos(ps)) ** 2
    p, n = cyclide_point(a, c, mu, th, ps)
    # Both angles over half their period: the integrands are even in them.
    weight = 4 * element * wt[:, None] * wp[None, :]
    cone = np.sum(p * n, -1) / 3
    lobes = [weight[side] for side in (element > 0, element < 0)], [cone[side] for side in (element > 0, element < 0)]
    return [(float(abs(w).sum()), abs(float((w * h).sum()))) for w, h in zip(*lobes) if len(w)]


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


def grid_on_cyclide(a, c, mu, th, ps):
    """Rows of points (th along a row) and the frame at the first."""
    points, _ = cyclide_point(a, c, mu, *np.meshgrid(th, ps))
    h = 1e-6
    along = [cyclide_point(a, c, mu, np.array(th[0] + x), np.array(ps[0] + y))[0] for x, y in ((h, 0), (-h, 0), (0, h), (0, -h))]
    v1, v2 = unit(along[0] - along[1]), along[2] - along[3]
    return points, v1, unit(v2 - np.dot(v1, v2) * v1)


def turned_net():
    """A net that is no cyclide: a circular grid with a frame turned away from its edges."""
    points, v1, v2 = grid_on_cyclide(6, 2, 3.5, np.linspace(0.3, 1.4, 5), np.linspace(0.4, 1.6, 4))
    x = 0.15
    return points, math.cos(x) * v1 + math.sin(x) * v2, -math.sin(x) * v1 + math.cos(x) * v2


def net_document(points, v1, v2, **fields):
    """The net as an object of a document."""
    return {"type": "cyclidic-net", "grid": points.tolist(), "frame": [v1.tolist(), v2.tolist()], **fields}


def simpson(areas, distance):
    """Volume between parallel surfaces from the areas at both and in the middle: the area is a quadratic in the distance."""
    first, middle, last = areas
    return abs(distance) / 6 * (first + 4 * middle + last)
