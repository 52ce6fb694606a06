"""The formulas of docs/math/pipe-tees.md and docs/math/tubes.md in exact rational arithmetic: identities, without a digit lost."""

import random
from fractions import Fraction as F


class Dual:
    """A value with its derivative along a loop."""

    def __init__(self, value, rate=0):
        self.value, self.rate = F(value), F(rate)

    def __add__(self, other):
        other = dual(other)
        return Dual(self.value + other.value, self.rate + other.rate)

    def __sub__(self, other):
        return self + dual(other) * -1

    def __mul__(self, other):
        other = dual(other)
        return Dual(self.value * other.value, self.value * other.rate + self.rate * other.value)

    __radd__, __rmul__ = __add__, __mul__


def dual(x):
    return x if isinstance(x, Dual) else Dual(x)


def product(p, q):
    """Of quaternions (w, x, y, z)."""
    (a, b, c, d), (e, f, g, h) = p, q
    return (
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    )


def turned(q):
    """The third axis turned, times the square of the length."""
    w, x, y, z = q
    return product(product(q, (0, 0, 0, 1)), (w, -x, -y, -z))[1:]


def value_of(random_source):
    return F(random_source.randint(-9, 9), random_source.randint(1, 9))


def tee(source):
    """Rows of the centre and the radius at a place of a random loop, with their rates, and both spinors with the factor."""
    # tau with a rational fourth root of (1 + tau)/(1 - tau).
    mu = F(source.randint(11, 30), 10)
    tau = (mu**4 - 1) / (mu**4 + 1)
    root = 2 * mu**2 / (mu**4 + 1)
    delta, r1 = F(source.randint(1, 9)), F(source.randint(1, 9))
    lean = F(source.randint(-7, 7), 10)  # tan of half the lean
    sin, cos = (1 - lean**2) / (1 + lean**2), -2 * lean / (1 + lean**2)
    s, c = (Dual(value_of(source), value_of(source)) for _ in range(2))
    a, b, d = (F(source.randint(1, 20)) for _ in range(3))
    q = a * (s * s) + b * (s * c) + d * (c * c)
    q_s, q_c = 2 * a * s + b * c, b * s + 2 * d * c
    half = F(1, 2)
    n1, x, y0 = half * ((s * s + c * c) * q), half * ((c * c - s * s) * q), s * c * q
    n2, along = half * (q * q + s * s * c * c), half * (q * q - s * s * c * c)
    weight = F(1, 2) / (delta * root) * ((q - s * s) * (q - c * c))
    reach, y = (n1 - tau * y0) * (1 / root), (y0 - tau * n1) * (1 / root)
    z = (along + cos * x) * (1 / sin)
    radius = reach - r1 * weight
    # The second pipe is touched as well.
    e = tau * delta
    second, beside = (n2 - tau * y0) * (1 / root), y - e * weight
    assert (second - (delta + r1) * weight - radius).value == 0
    assert (beside * beside + along * along - second * second).value == 0
    assert (x * x + y * y - reach * reach).value == 0
    true = lambda first, other: (  # half angles before the boost
        half * ((other + first) * (1 / mu) + (other - first) * mu).value,
        half * ((other + first) * (1 / mu) - (other - first) * mu).value,
    )
    (cf, sf), (cg, sg) = true(s, c), true(s * c, q)
    q1 = product((cf, 0, 0, sf), (1, 0, 1, 0))
    q2 = product((1, 0, lean, 0), (cg, -sg, 0, 0))
    real = (1 + lean) * (q - c * c).value * q_c.value / 2
    other = (1 - lean) * (q - s * s).value * q_s.value / 2
    return (x, y, z), radius, weight, q1, product(q2, (real, 0, 0, other))


def test_circles_of_tees_are_characteristic():
    source = random.Random(11)
    for _ in range(200):
        centre, radius, weight, first, second = tee(source)
        rate = lambda row: row.rate * weight.value - row.value * weight.rate
        for u in (F(0), F(1, 3), F(5, 7), F(1)):
            q = tuple((1 - u) * a + u * b for a, b in zip(first, second))
            normal = turned(q)
            size = sum(v * v for v in q)
            assert sum(n * rate(m) for n, m in zip(normal, centre)) == size * rate(radius)


def test_places_of_tubes_are_carried_along_lines_of_curvature():
    """Transport keeps null ways across the tangents, and the circle of four corners."""

    def dot(a, b):
        return sum(x * y for x, y in zip(a[:3], b[:3])) - a[3] * b[3]

    def tangent(source):
        # A rational way of square 1: a rational unit vector, boosted.
        x, y, t = (value_of(source) / 10 for _ in range(3))
        k = 1 + x * x + y * y
        unit = (2 * x / k, 2 * y / k, (1 - x * x - y * y) / k)
        cosh, sinh = (1 + t * t) / (1 - t * t), 2 * t / (1 - t * t)
        return tuple(cosh * v for v in unit) + (sinh,)

    source = random.Random(3)
    for _ in range(200):
        start, end = tangent(source), tangent(source)
        c = dot(start, end)
        assert dot(start, start) == dot(end, end) == 1
        # Two null ways across the first tangent, by mirroring one in ways across it.
        frame = [tuple(F(i == k) for k in range(4)) for i in range(4)]
        across = [tuple(v - dot(one, start) * t for v, t in zip(one, start)) for one in frame]
        carry = lambda way: tuple(v - dot(way, end) / (1 + c) * (a + b) for v, a, b in zip(way, start, end))
        for one in across:
            for other in across:
                assert dot(carry(one), carry(other)) == dot(one, other), "it is an isometry"
            assert dot(carry(one), end) == 0, "across the last tangent"
