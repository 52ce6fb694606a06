"""MFEM meshes and G+Smo XML read by the rules of their formats, and evaluated, without anything of the program."""

import xml.etree.ElementTree as ElementTree

import numpy as np
from scipy.interpolate import BSpline


class Patch:
    """Knots and degrees along each parameter, homogeneous control points with the first parameter fastest."""

    def __init__(self, knots, degrees, points, weights):
        self.knots, self.degrees = [np.array(k, float) for k in knots], degrees
        counts = [len(k) - d - 1 for k, d in zip(knots, degrees)]
        rows = np.hstack([np.array(points) * np.array(weights)[:, None], np.array(weights)[:, None]])
        self.net = rows.reshape(counts[::-1] + [4]).transpose(list(range(len(counts)))[::-1] + [len(counts)])
        self.weights = np.array(weights)

    def basis(self, axis, values, derivative=0):
        """Values of all B-splines along a parameter at places, a row for each."""
        knots, degree = self.knots[axis], self.degrees[axis]
        count = len(knots) - degree - 1
        columns = [BSpline(knots, row, degree, extrapolate=False) for row in np.eye(count)]
        return np.array([(c.derivative(derivative) if derivative else c)(values) for c in columns]).T

    def homogeneous(self, grid, derivatives=()):
        """Homogeneous points over a grid of places, or derivatives along the parameters given."""
        out = self.net
        for axis, values in enumerate(grid):
            basis = self.basis(axis, values, list(derivatives).count(axis))
            out = np.moveaxis(np.tensordot(basis, out, (1, axis)), 0, axis)
        return out

    def point(self, place):
        rows = self.homogeneous([np.array([x]) for x in place]).reshape(4)
        return rows[:3] / rows[3]

    def spans(self, axis):
        return np.unique(self.knots[axis])

    def volume(self, count=16):
        """The integral of the Jacobian by a Gauss rule of so many places along each parameter."""
        x, w = np.polynomial.legendre.leggauss(count)
        grid = [(x + 1) / 2] * 3
        rows = self.homogeneous(grid)
        point, weight = rows[..., :3] / rows[..., 3:], rows[..., 3:]
        slopes = []
        for axis in range(3):
            slope = self.homogeneous(grid, [axis])
            slopes.append((slope[..., :3] - point * slope[..., 3:]) / weight)
        jacobian = np.einsum("...i,...i", np.cross(slopes[0], slopes[1]), slopes[2])
        return np.einsum("i,j,k,ijk", w, w, w, jacobian) / 8


class Mesh:
    """An MFEM NURBS mesh."""

    def __init__(self, path):
        lines = [line.strip() for line in path.read_text().splitlines()]
        self.comments = [line for line in lines if line.startswith("#")]
        words = iter(" ".join(line for line in lines if line and not line.startswith("#")).split())
        assert [next(words) for _ in range(4)] == ["MFEM", "NURBS", "mesh", "v1.0"]
        number = lambda: int(next(words))
        assert next(words) == "dimension"
        self.dimension = number()
        corners = {0: 1, 1: 2, 3: 4, 5: 8}
        self.lists = {}
        for name in ("elements", "boundary"):
            assert next(words) == name
            rows = []
            for _ in range(number()):
                attribute, kind = number(), number()
                rows.append((attribute, kind, [number() for _ in range(corners[kind])]))
            self.lists[name] = rows
        assert next(words) == "edges"
        self.edges = [[number(), number(), number()] for _ in range(number())]
        assert next(words) == "vertices"
        self.vertices = number()
        assert next(words) == "patches"
        self.patches = []
        for _ in self.lists["elements"]:
            assert next(words) == "knotvectors" and number() == self.dimension
            knots, degrees = [], []
            for _ in range(self.dimension):
                degree, count = number(), number()
                degrees.append(degree)
                knots.append([float(next(words)) for _ in range(count + degree + 1)])
            assert next(words) == "dimension" and number() == 3 and next(words) == "controlpoints_cartesian"
            count = np.prod([len(k) - d - 1 for k, d in zip(knots, degrees)])
            rows = np.array([float(next(words)) for _ in range(4 * count)]).reshape(-1, 4)
            self.patches.append(Patch(knots, degrees, rows[:, :3], rows[:, 3]))
        assert next(words, None) is None


class Xml:
    """A G+Smo file: patches by their numbers, and the first multi-patch."""

    def __init__(self, path):
        root = ElementTree.parse(path).getroot()
        numbers = lambda element: [float(word) for word in (element.text or "").split()]
        self.patches = {}
        for geometry in root.findall("Geometry"):
            vectors = geometry.findall(".//KnotVector")
            points = np.array(numbers(geometry.find("coefs"))).reshape(-1, int(geometry.find("coefs").get("geoDim")))
            knots, degrees = [numbers(vector) for vector in vectors], [int(vector.get("degree")) for vector in vectors]
            weights = numbers(geometry.find("Basis/weights"))
            self.patches[int(geometry.get("id"))] = Patch(knots, degrees, points, weights)
        multi = root.find("MultiPatch")
        self.dimension = int(multi.get("parDim"))
        self.range = [int(x) for x in numbers(multi.find("patches"))]
        width = 4 + 2 * self.dimension
        self.interfaces = np.array(numbers(multi.find("interfaces")), int).reshape(-1, width).tolist()
        self.boundary = np.array(numbers(multi.find("boundary")), int).reshape(-1, 2).tolist()

    def first(self):
        """The patches of the first multi-patch."""
        return [self.patches[k] for k in range(self.range[0], self.range[1] + 1)]
