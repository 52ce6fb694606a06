"""Blocks with three orthogonal families of cyclides, computed without the program's formulas.

The last corner is where three circles meet, found in the plane of the inverted corners. Weights run from corner to corner by reflection, with the
lengths that put each face into space.
"""

import numpy as np

from quaternion_form import inverse, multiply, pure


def inverted(a, a0):
    x = np.asarray(a, float) - a0
    return -x / (x @ x)


def eighth_corner(corners):
    """The point on the circles of the three far faces; corners in binary order."""
    a0 = np.asarray(corners[0], float)
    b = [None] + [inverted(a, a0) for a in corners[1:7]]
    x, y = b[2] - b[1], b[4] - b[1]
    x = x / np.linalg.norm(x)
    y = y - (y @ x) * x
    y = y / np.linalg.norm(y)
    flat = {k: np.array([(b[k] - b[1]) @ x, (b[k] - b[1]) @ y]) for k in range(1, 7)}

    def centre(p, q, r):
        rows = 2 * np.array([q - p, r - p])
        return np.linalg.solve(rows, [q @ q - p @ p, r @ r - p @ p])

    # Circles through 1, 12, 13 and 2, 12, 23 meet in 12 and in its mirror image in the line of their centres.
    first, second = centre(flat[1], flat[3], flat[5]), centre(flat[2], flat[3], flat[6])
    along = (second - first) / np.linalg.norm(second - first)
    way = flat[3] - first
    meeting = first + 2 * along * (along @ way) - way
    image = b[1] + meeting[0] * x + meeting[1] * y
    return a0 - image / (image @ image)


class Block:
    """A block of seven corners in binary order and the frame at the first."""

    def __init__(self, corners, v1, v2):
        corners = [np.asarray(c, float) for c in corners[:7]]
        self.corners = corners + [eighth_corner(corners)]
        v1, v2 = np.asarray(v1, float), np.asarray(v2, float)
        v = [v1 / np.linalg.norm(v1), v2 / np.linalg.norm(v2)]
        self.v = [pure(x) for x in v + [np.cross(*v)]]
        weights = {0: np.array([1.0, 0, 0, 0])}
        for corner in (1, 2, 4):
            weights[corner] = self.step(weights[0], 0, corner)
        for corner, (before, other, start) in {3: (1, 2, 0), 5: (1, 4, 0), 6: (2, 4, 0), 7: (3, 5, 1)}.items():
            # Along one side for the direction; the length by the diagonals of the face.
            turned = self.step(weights[before], before, corner)
            a = self.corners
            diagonals = np.linalg.norm(a[before] - a[other]) / np.linalg.norm(a[start] - a[corner])
            length = np.linalg.norm(weights[before]) * np.linalg.norm(weights[other]) / np.linalg.norm(weights[start])
            weights[corner] = turned * (length * diagonals)
        self.weights = [weights[k] for k in range(8)]

    def step(self, w, start, end):
        """The unit weight at the other end of a side: d^-1 w V."""
        d = self.corners[end] - self.corners[start]
        v = self.v[{1: 0, 2: 1, 4: 2}[start ^ end]]
        next_one = multiply(multiply(pure(-d), w), v)
        return next_one / np.linalg.norm(next_one)

    def point(self, s, t, u):
        n, d = np.zeros(4), np.zeros(4)
        for k, (a, w) in enumerate(zip(self.corners, self.weights)):
            basis = (s if k & 1 else 1 - s) * (t if k & 2 else 1 - t) * (u if k & 4 else 1 - u)
            d = d + basis * w
            n = n + basis * multiply(pure(a), w)
        quotient = multiply(n, inverse(d))
        assert abs(quotient[0]) < 1e-9
        return np.asarray(quotient[1:], float)
