"""The curves of a model document, computed from the document's input data alone.

This is the judge of the foreign-reader tests: it shares no code and no intermediate result with the program. Points of
three-space are pure quaternions, an arc is the linear fraction

    x(t) = (a0 w0 (1 - t) + a1 w1 t) (w0 (1 - t) + w1 t)^-1

(S. Zube, "A circle representation using complex and quaternion numbers", equation (4)), and a segment of a circle spline
is such a fraction whose weight turns with its own parameter (C. Doran, "Circle and sphere blending with conformal
geometric algebra", section 4). Quaternions are arrays [w, x, y, z]; all functions take arrays of parameters.
"""

import functools
import math

import numpy as np
from scipy.optimize import root
from scipy.spatial import cKDTree

# ---------------------------------------------------------------------------------------------------- quaternions

_CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])


def multiply(p, q):
    """Product of quaternions, component by component, over arrays."""
    p, q = np.asarray(p, float), np.asarray(q, float)
    a, b, c, d = (p[..., k] for k in range(4))
    e, f, g, h = (q[..., k] for k in range(4))
    out = np.empty(np.broadcast_shapes(p.shape, q.shape))
    out[..., 0] = a * e - b * f - c * g - d * h
    out[..., 1] = a * f + b * e + c * h - d * g
    out[..., 2] = a * g - b * h + c * e + d * f
    out[..., 3] = a * h + b * g - c * f + d * e
    return out


def cross(p, q):
    """Product of vectors, component by component, over arrays; numpy's own takes most of its time for the order of axes."""
    (a, b, c), (e, f, g) = ([v[..., k] for k in range(3)] for v in (p, q))
    out = np.empty(np.broadcast_shapes(p.shape, q.shape))
    out[..., 0] = b * g - c * f
    out[..., 1] = c * e - a * g
    out[..., 2] = a * f - b * e
    return out


def inverse(q):
    """Inverse: the conjugate divided by the squared norm."""
    q = np.asarray(q, float)
    return q * _CONJUGATE / np.sum(q * q, axis=-1, keepdims=True)


def pure(v):
    """The pure quaternion of a vector."""
    v = np.asarray(v, float)
    out = np.zeros((*v.shape[:-1], 4))
    out[..., 1:] = v
    return out


def real(r):
    """The real quaternions of an array of numbers."""
    r = np.asarray(r, float)
    return np.stack([r, 0 * r, 0 * r, 0 * r], axis=-1)


def unit(v):
    v = np.asarray(v, float)
    size = math.hypot(*v)
    assert size > 0.0, "a direction is zero"
    return v / size


def reflect(t, chord):
    """Tangent at the other end of the arc with start tangent `t` over `chord`."""
    c = unit(chord)
    return 2.0 * np.dot(c, t) * c - np.asarray(t, float)


# ------------------------------------------------------------------------------------------------------- the arc


class Arc:
    """Quaternionic linear fraction from a0 to a1; weights are quaternions, only w1 w0^-1 matters."""

    def __init__(self, a0, a1, w0, w1):
        self.a0, self.a1 = np.asarray(a0, float), np.asarray(a1, float)
        self.w0, self.w1 = np.asarray(w0, float), np.asarray(w1, float)

    @classmethod
    def segment(cls, a0, a1):
        return cls(a0, a1, [1, 0, 0, 0], [1, 0, 0, 0])

    @classmethod
    def through(cls, a0, b, a1):
        """Through three points, `b` at t = 1/2: w0 = (b - a0)^-1, w1 = (a1 - b)^-1."""
        a0, b, a1 = (np.asarray(p, float) for p in (a0, b, a1))
        return cls(a0, a1, inverse(pure(b - a0)), inverse(pure(a1 - b)))

    @classmethod
    def start_tangent(cls, a0, a1, v0):
        """With derivative v0 at t = 0: w = (a1 - a0)^-1 v0."""
        a0, a1 = np.asarray(a0, float), np.asarray(a1, float)
        return cls(a0, a1, [1, 0, 0, 0], multiply(inverse(pure(a1 - a0)), pure(v0)))

    @classmethod
    def end_tangent(cls, a0, a1, v1):
        """With derivative v1 at t = 1: w = v1^-1 (a1 - a0)."""
        a0, a1 = np.asarray(a0, float), np.asarray(a1, float)
        return cls(a0, a1, [1, 0, 0, 0], multiply(inverse(pure(v1)), pure(a1 - a0)))

    @classmethod
    def bulge(cls, a0, a1, b, normal=(0.0, 0.0, 1.0)):
        """With DXF bulge b = tan(sweep / 4), counter-clockwise about the normal (across the chord) if positive."""
        half = 2.0 * math.atan(b)  # half the swept angle: the argument of the weight ratio
        return cls(a0, a1, [1, 0, 0, 0], [math.cos(half), *(math.sin(half) * unit(normal))])

    def evenly(self):
        """The same arc with a unit weight ratio, which only changes the parameter: equal speeds at both ends."""
        w = self.weight()
        return Arc(self.a0, self.a1, [1, 0, 0, 0], w / math.hypot(*w))

    def weight(self):
        return multiply(self.w1, inverse(self.w0))

    def point(self, t):
        t = np.asarray(t, float)[..., None]
        n = multiply(pure(self.a0), self.w0) * (1 - t) + multiply(pure(self.a1), self.w1) * t
        d = self.w0 * (1 - t) + self.w1 * t
        x = multiply(n, inverse(d))
        scale = 1.0 + max(abs(self.a0).max(), abs(self.a1).max())
        assert np.all(abs(x[..., 0]) < 1e-9 * scale), "the arc leaves three-space"
        return x[..., 1:]

    def derivative(self, t):
        """x'(t) = (a1 - a0) w1 d^-1 w0 d^-1 with d = w0 (1 - t) + w1 t."""
        t = np.asarray(t, float)[..., None]
        d = inverse(self.w0 * (1 - t) + self.w1 * t)
        return multiply(multiply(multiply(multiply(pure(self.a1 - self.a0), self.w1), d), self.w0), d)[..., 1:]

    def length(self):
        """Swept angle times radius from the weight ratio (r, p): |c| n / |p| * atan2(|p|, r)."""
        w = self.weight()
        p, n = math.hypot(*w[1:]), math.hypot(*w)
        chord = math.dist(self.a0, self.a1)
        return chord if p < 1e-14 * n else chord * n / p * math.atan2(p, w[0])

    def radius(self):
        """Radius; infinite for a segment."""
        w = self.weight()
        p = math.hypot(*w[1:])
        return math.inf if p < 1e-14 * math.hypot(*w) else math.dist(self.a0, self.a1) * math.hypot(*w) / (2 * p)


def circle(center, normal, radius):
    """Full circle as two half arcs about `normal`: antipodal ends, weight ratio a pure unit quaternion."""
    n = unit(normal)
    e = unit(np.cross(n, [1.0, 0.0, 0.0] if abs(n[0]) < 0.6 else [0.0, 1.0, 0.0])) * radius
    a, b = np.asarray(center, float) + e, np.asarray(center, float) - e
    return Curve([Arc(a, b, [1, 0, 0, 0], pure(n)), Arc(b, a, [1, 0, 0, 0], pure(n))], closed=True)


# --------------------------------------------------------------------------------------- biarcs and arc splines


def biarc(p0, t0, p1, t1, rule="equal-d"):
    """Two arcs from p0 (direction t0) to p1 (direction t1), tangent at the joint."""
    p0, p1, t0, t1 = np.asarray(p0, float), np.asarray(p1, float), unit(t0), unit(t1)
    w = p1 - p0
    if rule == "equal-d":
        # Equal legs d of the two control triangles: |w - d (t0 + t1)| = 2 d, a quadratic in d.
        a = 4.0 - np.dot(t0 + t1, t0 + t1)
        b = np.dot(w, t0 + t1)
        s = math.sqrt(b * b + a * np.dot(w, w))
        d = np.dot(w, w) / (b + s) if b >= 0.0 else (s - b) / a
        joint = 0.5 * (p0 + p1) + 0.5 * d * (t0 - t1)
    elif rule == "equal-chord":
        # Middle of the shorter of the two arcs of the joint circle, start tangents +-(t0 + mirrored t1).
        k = t0 + reflect(t1, w)
        middles = []
        for sign in (1.0, -1.0):
            arc = Arc.start_tangent(p0, p1, sign * k)
            middle = arc.point(np.array(1.0 / (1.0 + math.hypot(*arc.weight()))))
            pair = _two_arcs(p0, t0, middle, p1)
            middles.append((sum(a.length() for a in pair), -sign, middle))
        joint = min(middles, key=lambda m: m[:2])[2]
    else:
        raise ValueError(f"no reference for the rule {rule}")
    return _two_arcs(p0, t0, joint, p1)


def _two_arcs(p0, t0, joint, p1):
    return [Arc.start_tangent(p0, joint, t0), Arc.start_tangent(joint, p1, reflect(t0, joint - p0))]


def three_point_tangent(a, b, c):
    """Direction at b of the circle through a, b, c: the sum of the inverses of the two chords."""
    e, f = b - a, c - b
    return unit(e / np.dot(e, e) + f / np.dot(f, f))


def arc_spline(points, closed=False, tangents=None, rule="equal-d"):
    """One biarc per span; estimated tangents are those of the circles through three neighbors."""
    p = np.asarray(points, float)
    n = len(p)
    if tangents is None:
        if closed:
            tangents = [three_point_tangent(p[i - 1], p[i], p[(i + 1) % n]) for i in range(n)]
        elif n == 2:
            tangents = [unit(p[1] - p[0])] * 2
        else:
            inner = [three_point_tangent(p[i - 1], p[i], p[i + 1]) for i in range(1, n - 1)]
            tangents = [reflect(inner[0], p[1] - p[0]), *inner, reflect(inner[-1], p[-1] - p[-2])]
    arcs = []
    for i in range(n if closed else n - 1):
        j = (i + 1) % n
        arcs += biarc(p[i], tangents[i], p[j], tangents[j], rule)
    return Curve(arcs, closed)


# ------------------------------------------------------------------------------------------------ circle splines


def smooth_step(k, x):
    """The step of order k and its derivative: x^k sum C(k-1+j, j) (1-x)^j, derivative prop. to (x (1-x))^(k-1)."""
    f = x**k * sum(math.comb(k - 1 + j, j) * (1 - x) ** j for j in range(k))
    return f, math.comb(2 * k - 1, k) * k * (x * (1 - x)) ** (k - 1)


class Blend:
    """One segment of a circle spline: from x1 to x2 between the circles with start tangents t1, t2 AT x1."""

    def __init__(self, x1, x2, t1, t2, order, variant):
        self.x1, self.d = np.asarray(x1, float), np.asarray(x2, float) - np.asarray(x1, float)
        self.size = math.hypot(*self.d)
        u, t1, t2 = self.d / self.size, unit(t1), unit(t2)
        self.u, self.t1, self.t2, self.order, self.variant = u, t1, t2, order, variant
        a, g = t1 + t2, t2 - t1
        na, ng = math.hypot(*a), math.hypot(*g)
        assert na > 1e-6, "opposite circles have no reference here"
        self.theta, self.h = 2.0 * math.atan2(ng, na), a / na
        self.b = np.zeros(3) if ng == 0.0 else 0.5 * na * g / ng + 0.5 * ng * self.h
        if np.dot(u + t1, u + t2) < 0.0:  # the shorter turn would pass through infinity
            self.theta, self.b, self.h = 2.0 * math.pi - self.theta, -self.b, -self.h
        self.c = math.cos(0.5 * self.theta)

    def direction(self, l):
        """Start tangent t(l) of the arc that the point of parameter l lies on, and its derivative."""
        l = np.asarray(l, float)[..., None]
        if self.variant == "trigonometric":
            f, df = smooth_step(self.order, l)
            cos, sin = np.cos(f * self.theta), np.sin(f * self.theta)
            return cos * self.t1 + sin * self.b, df * self.theta * (cos * self.b - sin * self.t1)
        a, b, da, db = self.factors(l)
        n = a * a * self.t1 + 2 * a * b * self.h + b * b * self.t2
        q = a * a + 2 * a * b * self.c + b * b
        dn = 2 * a * da * self.t1 + 2 * (da * b + a * db) * self.h + 2 * b * db * self.t2
        dq = 2 * a * da + 2 * (da * b + a * db) * self.c + 2 * b * db
        return n / q, (dn * q - n * dq) / (q * q)

    def factors(self, l):
        """The functions A and B of the rational angle law, and their derivatives."""
        k, m = self.order, 1.0 - l
        return m**k, l**k, -k * m ** (k - 1), k * l ** (k - 1)

    def point(self, l):
        """The linear fraction (x1 m + x2 w l)(m + w l)^-1 with w = d^-1 |d| t(l), a unit quaternion."""
        l = np.asarray(l, float)
        t, _ = self.direction(l)
        w = multiply(inverse(pure(self.d)), pure(self.size * t))
        # Relative to x1: (d w l)(m + w l)^-1, the same quotient without the cancellation of far-away points.
        n = multiply(pure(self.d), w) * l[..., None]
        x = multiply(n, inverse(real(1.0 - l) + w * l[..., None]))
        assert np.all(abs(x[..., 0]) < 1e-9 * self.size), "the blend leaves three-space"
        return self.x1 + x[..., 1:]

    def derivative(self, l):
        """Derivative of x1 + |d| l N / |N|^2 with N = l u + (1 - l) t(l)."""
        l = np.asarray(l, float)
        t, dt = self.direction(l)
        l = l[..., None]
        n, dn = l * self.u + (1 - l) * t, self.u + (1 - l) * dt - t
        s = np.sum(n * n, axis=-1, keepdims=True)
        g = n / s
        dg = dn / s - n * (2.0 * np.sum(n * dn, axis=-1, keepdims=True)) / (s * s)
        return self.size * (g + l * dg)


def circle_spline(points, closed=False, order=2, variant="rational", start=None, end=None):
    """One smooth run: closed, or open with natural ends, or with clamped end tangents."""
    p = np.asarray(points, float)
    n = len(p)
    if n == 2 and not closed and start is None and end is None:
        return Curve([Arc.segment(p[0], p[1])], False)
    segments = []
    for i in range(n if closed else n - 1):
        x1, x2 = p[i], p[(i + 1) % n]
        first, last = not closed and i == 0, not closed and i == n - 2
        t1 = None if first else three_point_tangent(p[i - 1], x1, x2)
        t2 = None if last else reflect(three_point_tangent(x1, x2, p[(i + 2) % n]), x2 - x1)
        if first:
            t1 = t2 if start is None else unit(start)
        if last:
            t2 = t1 if end is None else reflect(unit(end), x2 - x1)
        if t1 is None:
            t1 = t2
        segments.append(Blend(x1, x2, t1, t2, order, variant))
    return Curve(segments, closed)


# -------------------------------------------------------------------------------------------------- fair splines


class FairBlend(Blend):
    """A segment whose angle law has A = m (m + e l), B = l (l + e m)."""

    def __init__(self, x1, x2, t1, t2, blend):
        super().__init__(x1, x2, t1, t2, None, "fair")
        self.blend = blend

    def factors(self, l):
        e, m = self.blend, 1.0 - l
        return m * (m + e * l), l * (l + e * m), e * (m - l) - 2 * m, e * (m - l) + 2 * l

    def start_curvature(self):
        """The curvature vector at the start: of the arc there, and what the turn of its tangent adds."""
        turning = self.direction(0.0)[1]
        return 2.0 / self.size * (self.u - np.dot(self.u, self.t1) * self.t1 + turning)


def straight_factors(points, closed):
    """By how much the blend at each node is reduced because it is on a straight run beside a corner, or is that corner."""
    turn, n = turn_angles(points, closed), len(points)
    ramp = lambda x, a, b: min(max((x - a) / (b - a), 0.0), 1.0)
    factor = np.ones(n)
    for i in range(0 if closed else 1, n if closed else n - 1):
        beside = [(i - 1) % n, (i + 1) % n]
        largest, smallest = max(turn[beside]), max(turn[i], min(turn[beside]))
        if largest <= math.radians(30):
            continue
        own = 1.0 - ramp(math.degrees(largest), 30, 60) * (1.0 - ramp(smallest / largest, 0.005, 0.02))
        for j in [i] + [j for j in beside if turn[j] == largest]:
            factor[j] = min(factor[j], own)
    return factor


def fair_spline(points, closed=False, tension=0.0, straight="auto", ends=("circle", "circle")):
    """One run with continuous curvature: its tangents are found by SciPy's root finder from those of the three-point circles.

    Ends are "circle", "arc", "free" or a direction. Data that would have to be relaxed have no reference here."""
    p = np.asarray(points, float)
    n, count = len(p), len(points) if closed else len(points) - 1
    if n == 2 and all(isinstance(end, str) for end in ends):
        return Curve([Arc.segment(p[0], p[1])], False)
    factor = straight_factors(p, closed) if straight == "auto" else np.ones(n)
    blends = [(1.0 - tension) * min(factor[i], factor[(i + 1) % n]) for i in range(count)]
    normal = np.linalg.svd(p - p.mean(axis=0))[2][2]
    flat = np.abs((p - p[0]) @ normal).max() < 1e-9 * np.ptp(p, axis=0).max()
    inner = range(0 if closed else 1, n if closed else n - 1)
    start = {i: three_point_tangent(p[i - 1], p[i], p[(i + 1) % n]) for i in inner}
    free = list(inner)
    given = {}
    for end, at, beside in (((ends[0], 0, 1), (ends[1], n - 1, n - 2)) if not closed else ()):
        if not isinstance(end, str):
            given[at] = unit(end)
        elif end == "circle":
            along = unit(p[beside] - p[at])
            given[at] = reflect(start[beside], along)
            sign = 1.0 if at == 0 else -1.0
            if flat and sign * np.dot(given[at], along) < 0.0:
                given[at] = unit(given[at] - np.dot(given[at], along) * along)
        elif end == "free":
            start[at] = reflect(start[beside], p[beside] - p[at])
            free.append(at)
    # Each unknown tangent moves in one direction across it in a plane, in two in space.
    across = {}
    for i in free:
        side = unit(np.cross(normal, start[i]) if flat else np.cross(start[i], np.eye(3)[np.argmin(abs(start[i]))]))
        across[i] = [side] if flat else [side, np.cross(start[i], side)]
    step = 1 if flat else 2

    def tangents(y):
        t = dict(given)
        for k, i in enumerate(free):
            t[i] = unit(start[i] + sum(y[step * k + r] * v for r, v in enumerate(across[i])))
        if not closed:
            for end, at, beside in ((ends[0], 0, 1), (ends[1], n - 1, n - 2)):
                if isinstance(end, str) and end == "arc":
                    t[at] = reflect(t[beside], p[beside] - p[at])
        return t

    def segment(t, i, backward=False):
        a, b = i, (i + 1) % n
        if backward:
            return FairBlend(p[b], p[a], -t[b], reflect(-t[a], p[a] - p[b]), blends[i])
        return FairBlend(p[a], p[b], t[a], reflect(t[b], p[b] - p[a]), blends[i])

    def jumps(y):
        t, out = tangents(y), []
        for i in free:
            after = segment(t, i).start_curvature() if i < count else 0.0
            before = segment(t, (i - 1) % n, backward=True).start_curvature() if closed or i > 0 else 0.0
            sizes = [np.linalg.norm(p[(i + 1) % n] - p[i]), np.linalg.norm(p[i] - p[i - 1])]
            out += [np.dot(after - before, v) * min(sizes) for v in across[i]]
        return np.array(out)

    y = np.zeros(step * len(free))
    if len(y):
        for _ in range(3):  # the finder stops a little early: from where it stopped, again
            y = root(jumps, y, tol=1e-14).x
        assert np.abs(jumps(y)).max() < 1e-11, "the reference tangents were not found"
    t = tangents(y)
    segments = [segment(t, i) for i in range(count)]
    assert all(min(np.dot(s.u, s.t1), np.dot(s.u, s.t2)) > -0.8 for s in segments), "this would be relaxed"
    return Curve(segments, closed)


def fair_spline_with_corners(points, closed, corners, tension=0.0, straight="auto"):
    """Runs between the corners, each ending along the circle of its last three points."""
    p, n = np.asarray(points, float), len(points)
    cuts = [*corners, corners[0] + n] if closed else [0, *corners, n - 1]
    runs = [[p[k % n] for k in range(i, j + 1)] for i, j in zip(cuts, cuts[1:])]
    return Curve([s for run in runs for s in fair_spline(run, False, tension, straight).pieces], closed)


def turn_angles(points, closed):
    """Turn of the polygon at every point, radians; 0 at open ends."""
    p = np.asarray(points, float)
    n, turn = len(p), np.zeros(len(points))
    for i in range(0 if closed else 1, n if closed else n - 1):
        e, f = p[i] - p[i - 1], p[(i + 1) % n] - p[i]
        turn[i] = 2.0 * math.atan2(math.hypot(*(unit(f) - unit(e))), math.hypot(*(unit(f) + unit(e))))
    return turn


def circle_spline_with_corners(points, closed, corners, order=2, variant="rational"):
    """Runs between the corners (indices of points), with natural ends at each corner."""
    p = np.asarray(points, float)
    n, corners = len(p), sorted(corners)
    if not corners:
        return circle_spline(p, closed, order, variant)
    if closed:
        cuts = [*corners, corners[0] + n]
    else:
        cuts = [0, *corners, n - 1]
    runs = [[p[k % n] for k in range(i, j + 1)] for i, j in zip(cuts, cuts[1:])]
    return Curve([s for run in runs for s in circle_spline(run, False, order, variant).pieces], closed)


# ------------------------------------------------------------------------------------- a curve made of pieces

_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(20)


class Curve:
    """Pieces in order; the parameter runs over [0, number of pieces]."""

    def __init__(self, pieces, closed):
        self.pieces = [p.evenly() if isinstance(p, Arc) else p for p in pieces]
        self.closed = closed
        # Of arcs alone their points and weights in columns: many short pieces are evaluated together.
        arcs = self.pieces and all(isinstance(p, Arc) for p in self.pieces)
        self._columns = [np.array(c) for c in zip(*((p.a0, p.a1, p.w0, p.w1) for p in self.pieces))] if arcs else None

    def __len__(self):
        return len(self.pieces)

    def _each(self, index, s, method):
        """A method of the pieces `index` at their own parameters `s`."""
        if self._columns:
            return getattr(Arc(*(column[index] for column in self._columns)), method)(s)
        out = np.empty((len(s), 3))
        order = np.argsort(index, kind="stable")
        starts = np.flatnonzero(np.diff(index[order], prepend=-1))
        for places in np.split(order, starts[1:]):
            if len(places):
                out[places] = getattr(self.pieces[index[places[0]]], method)(s[places])
        return out

    def point(self, t):
        """Points at global parameters; at a joint those of the piece that starts there."""
        t = np.atleast_1d(np.asarray(t, float))
        index = np.clip(t.astype(int), 0, len(self) - 1)
        return self._each(index, t - index, "point")

    def length(self):
        return sum(p.length() if isinstance(p, Arc) else self._quadrature(p) for p in self.pieces)

    @staticmethod
    def _quadrature(piece):
        """Gauss-Legendre with 20 nodes on halved intervals until two levels agree to 1e-13."""
        before = None
        for level in range(1, 10):
            edges = np.linspace(0.0, 1.0, 2**level + 1)
            mid, half = 0.5 * (edges[1:] + edges[:-1]), 0.5 * (edges[1:] - edges[:-1])
            t = (mid[:, None] + half[:, None] * _NODES).ravel()
            w = (half[:, None] * _WEIGHTS).ravel()
            value = float(np.sum(w * np.linalg.norm(piece.derivative(t), axis=-1)))
            if before is not None and abs(value - before) <= 1e-13 * value:
                return value
            before = value
        raise AssertionError("the length of a reference piece did not converge")

    @functools.cached_property
    def _samples(self):
        """The samples of `sample()` and a tree of them: curves do not change."""
        t, x = self.sample(64)
        return t, x, cKDTree(x)

    def sample(self, per_piece=64):
        t = np.linspace(0.0, len(self), per_piece * len(self) + 1)
        return t, self.point(t)

    def extent(self):
        """Diagonal of the bounding box."""
        _, x, _ = self._samples
        return float(np.linalg.norm(x.max(axis=0) - x.min(axis=0)))

    def gap(self, points):
        """The largest distance of points from the nearest samples: enough to tell which of several curves they are on."""
        return float(self._samples[2].query(points)[0].max())

    def distances(self, points):
        """Distance of every given point to the curve: nearest samples, then Gauss-Newton inside their pieces."""
        points = np.atleast_2d(np.asarray(points, float))
        t, _, tree = self._samples
        _, nearest = tree.query(points, k=2)
        best = np.full(len(points), np.inf)
        for column in nearest.T:
            for side in (-1e-9, 1e-9):  # a sample at a joint belongs to both pieces
                index = np.floor(t[column] + side).astype(int)
                s = np.clip(t[column] - index, 0.0, 1.0)
                index = index % len(self) if self.closed else np.clip(index, 0, len(self) - 1)
                for _ in range(30):
                    d = self._each(index, s, "derivative")
                    step = np.sum((points - self._each(index, s, "point")) * d, axis=1) / np.sum(d * d, axis=1)
                    before, s = s, np.clip(s + np.clip(step, -0.05, 0.05), 0.0, 1.0)
                    if np.abs(s - before).max() < 1e-10:  # the next step would be its square
                        break
                best = np.minimum(best, np.linalg.norm(points - self._each(index, s, "point"), axis=1))
        return best
