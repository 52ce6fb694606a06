"""The faces of a STEP file as OpenCASCADE sees them: topology, tolerances, areas, points and normals."""

import functools
import math

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepGProp import BRepGProp
from OCP.BRepTools import BRepTools, BRepTools_WireExplorer
from OCP.GeomAbs import GeomAbs_CurveType as Curve
from OCP.GeomAbs import GeomAbs_SurfaceType as Kind
from OCP.gp import gp_Pnt, gp_Vec
from OCP.GProp import GProp_GProps
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_REVERSED, TopAbs_SHELL, TopAbs_SOLID, TopAbs_VERTEX, TopAbs_WIRE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

import surface_form as form
from quaternion_form import cross

KINDS = {
    Kind.GeomAbs_Plane: "plane",
    Kind.GeomAbs_Cylinder: "cylinder",
    Kind.GeomAbs_Cone: "cone",
    Kind.GeomAbs_Sphere: "sphere",
    Kind.GeomAbs_Torus: "torus",
    Kind.GeomAbs_BSplineSurface: "b-spline",
    Kind.GeomAbs_BezierSurface: "b-spline",
}
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)


def _each(shape, kind):
    explorer = TopExp_Explorer(shape, kind)
    while explorer.More():
        yield explorer.Current()
        explorer.Next()


def distinct(shape, kind):
    """Sub-shapes of a kind, each once."""
    found = {}
    for s in _each(shape, kind):
        same = found.setdefault(hash(s), [])
        if not any(s.IsSame(other) for other in same):
            same.append(s)
    return [s for same in found.values() for s in same]


def vector(v):
    return np.array([v.X(), v.Y(), v.Z()])


class Edge:
    def __init__(self, edge):
        self.shape, self.curve = edge, BRepAdaptor_Curve(edge)
        self.first, self.last = self.curve.FirstParameter(), self.curve.LastParameter()
        self.tolerance = BRep_Tool.Tolerance_s(edge)

    def point(self, x):
        """At the fraction x of the parameter's range."""
        return vector(self.curve.Value(self.first + (self.last - self.first) * x))

    def moving(self, places):
        """Points and derivatives by the fraction at fractions of the parameter's range."""
        found, length = [], self.last - self.first
        for x in places:
            p, d = gp_Pnt(), gp_Vec()
            self.curve.D1(self.first + length * float(x), p, d)
            found.append((p.X(), p.Y(), p.Z(), d.X(), d.Y(), d.Z()))
        found = np.array(found)
        return found[:, :3], found[:, 3:] * length


class Bezier:
    """A rational surface of one span per parameter, from the poles, weights and knots as read: the reader's own evaluation
    of single points is too slow for all points of thousands of faces."""

    def __init__(self, surface):
        assert (surface.NbUKnots(), surface.NbVKnots()) == (2, 2), "a face of several spans"
        self.degrees = surface.UDegree(), surface.VDegree()
        self.ranges = (surface.UKnot(1), surface.UKnot(2)), (surface.VKnot(1), surface.VKnot(2))
        rows = []
        for i in range(self.degrees[0] + 1):
            for j in range(self.degrees[1] + 1):
                w = surface.Weight(i + 1, j + 1)
                assert w > 0
                rows.append([*(w * vector(surface.Pole(i + 1, j + 1))), w])
        self.rows = np.array(rows).reshape(self.degrees[0] + 1, self.degrees[1] + 1, 4)
        places = [(a + 0.3 * (b - a)) for a, b in self.ranges]
        p, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
        surface.D1(*places, p, du, dv)
        # Derivatives of small faces are differences of coordinates, with their rounding.
        rounding = 1e-14 * abs(vector(p)).max()
        for own, read in zip(self.jet(*places), (p, du, dv)):
            limit = 1e-12 * abs(own).max() + rounding
            assert np.allclose(own, vector(read), rtol=1e-12, atol=limit), "not the reader's surface"

    def patch(self, given=None):
        """A given patch in the parameters of this surface, else that in the quaternion form through the corners as read, with
        the frame of the first corner as read: corners and frame fix a principal patch, all else of the face is to be compared."""
        h = self.rows
        at = h[..., :3] / h[..., 3:]
        if given is None:
            v1, v2 = form.unit(at[1, 0] - at[0, 0]), form.unit(at[0, 1] - at[0, 0])
            given = form.Patch([at[0, 0], at[-1, 0], at[0, -1], at[-1, -1]], v1, v2)
        norms = [math.sqrt(h[i, j, 3] / h[0, 0, 3]) for i, j in ((-1, 0), (0, -1))]
        return given.with_factors(*(n / np.linalg.norm(w) for n, w in zip(norms, given.w[1:3])))

    @staticmethod
    def _bernstein(x, degree, order):
        """Values of the polynomials, or of their derivatives, in a last axis."""
        if order:
            low = Bezier._bernstein(x, degree - 1, 0)
            zero = np.zeros_like(low[..., :1])
            return degree * (np.concatenate([zero, low], -1) - np.concatenate([low, zero], -1))
        return np.stack([math.comb(degree, i) * x**i * (1 - x) ** (degree - i) for i in range(degree + 1)], -1)

    def scaled(self, x, y):
        """The parameters at fractions of their ranges."""
        (u0, u1), (v0, v1) = self.ranges
        return u0 + (u1 - u0) * x, v0 + (v1 - v0) * y

    def jet(self, us, vs):
        """Point and derivatives by both parameters."""
        (u0, u1), (v0, v1) = self.ranges
        x, y = (np.asarray(us, float) - u0) / (u1 - u0), (np.asarray(vs, float) - v0) / (v1 - v0)
        basis = [[self._bernstein(z, d, order) for order in (0, 1)] for z, d in ((x, self.degrees[0]), (y, self.degrees[1]))]
        count = self.rows.shape[1]
        across = [(b @ self.rows.reshape(len(self.rows), -1)).reshape(*b.shape[:-1], count, 4) for b in basis[0]]
        h, hu, hv = (np.einsum("...j,...jk->...k", basis[1][b], across[a]) for a, b in ((0, 0), (1, 0), (0, 1)))
        point = h[..., :3] / h[..., 3:]
        du, dv = ((d[..., :3] - point * d[..., 3:]) / h[..., 3:] for d in (hu, hv))
        return point, du / (u1 - u0), dv / (v1 - v0)


class Face:
    def __init__(self, face):
        self.shape, self.surface = face, BRepAdaptor_Surface(face)
        self.kind = KINDS.get(self.surface.GetType(), "other")
        self.box = BRepTools.UVBounds_s(face)
        self.sign = -1.0 if face.Orientation() == TopAbs_REVERSED else 1.0
        self.edges = [TopoDS.Edge(e) for e in _each(face, TopAbs_EDGE)]
        self.rational = Bezier(self.surface.BSpline()) if self.kind == "b-spline" else None

    def at(self, u, v):
        """Point and the product of the derivatives, towards the outer side."""
        p, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
        self.surface.D1(float(u), float(v), p, du, dv)
        return vector(p), self.sign * vector(du.Crossed(dv))

    def at_all(self, us, vs):
        """`at` for arrays of parameters."""
        us, vs = np.broadcast_arrays(np.asarray(us, float), np.asarray(vs, float))
        if self.rational:
            points, du, dv = self.rational.jet(us, vs)
            return points, self.sign * cross(du, dv)
        found = [self.at(u, v) for u, v in zip(us.ravel(), vs.ravel())]
        return tuple(np.array(x).reshape(*us.shape, 3) for x in zip(*found))

    def points(self, count, generator):
        """Random places inside: points and unit normals. The range of the parameters is the face, except in a plane,
        where the places are on chords between opposite edges, arcs first, or between an edge and the opposite corner."""
        places = generator.uniform(0.02, 0.98, (count, 2))
        if self.kind == "plane":
            lines = [BRepAdaptor_Curve(edge).GetType() == Curve.GeomAbs_Line for edge in self.edges]
            k = 1 if lines[0] else 0
            if len(self.edges) == 3:
                # A sector: from its arc to where the others meet.
                k = lines.index(False) if False in lines else 0
                tip = self._along(self.edges[(k + 1) % 3])(1.0)
                from_, to = self._along(self.edges[k]), lambda x: np.broadcast_to(tip, (*np.shape(x), 3))
            else:
                from_, to = (self._along(self.edges[k + j]) for j in (0, 2))
            normal = self.at(self.box[0], self.box[2])[1]
            points = np.array([from_(a) * (1 - b) + to(1 - a) * b for a, b in places])
            return points, np.broadcast_to(normal / np.linalg.norm(normal), points.shape)
        u0, u1, v0, v1 = self.box
        points, normals = self.at_all(u0 + (u1 - u0) * places[:, 0], v0 + (v1 - v0) * places[:, 1])
        return points, normals / np.linalg.norm(normals, axis=-1, keepdims=True)

    def patch(self):
        """The patch in the quaternion form through the corners as read, with the tangents of the edges at the first."""
        found = []
        explorer = BRepTools_WireExplorer(TopoDS.Wire(distinct(self.shape, TopAbs_WIRE)[0]), self.shape)
        while explorer.More():
            found.append(explorer.Current())
            explorer.Next()
        assert len(found) == 4, "a side is one point"
        corners = [self._along(edge)(0.0) for edge in found]
        v1, v2 = self._leaving(found[0], 0.0), self._leaving(found[3], 1.0)
        return form.Patch([corners[0], corners[1], corners[3], corners[2]], v1, v2)

    @staticmethod
    def _leaving(edge, x):
        """Direction into an edge from its start (x = 0) or end (x = 1) in the direction of the loop."""
        curve = BRepAdaptor_Curve(edge)
        at_last = (x == 1.0) != (edge.Orientation() == TopAbs_REVERSED)
        p, d = gp_Pnt(), gp_Vec()
        curve.D1(curve.LastParameter() if at_last else curve.FirstParameter(), p, d)
        return -vector(d) if at_last else vector(d)

    @staticmethod
    def _along(edge):
        """Points of an edge in the direction of the loop."""
        curve = Edge(edge)
        back = edge.Orientation() == TopAbs_REVERSED
        return lambda x: curve.point(1 - x if back else x)

    def middle_of_corners(self):
        return np.mean([vector(BRep_Tool.Pnt_s(TopoDS.Vertex(v))) for v in distinct(self.shape, TopAbs_VERTEX)], axis=0)

    def area(self):
        """Own quadrature; in a plane, on a cylinder and on a cone along the edges."""
        if self._is_round:
            return self._round_integrals[0]
        return self._plane_area() if self.kind == "plane" else self._integrals[0]

    def volume(self):
        """Volume of the cone over the face from the origin, signed by the outer side."""
        if self.kind == "plane":
            p, n = self.at(self.box[0], self.box[2])
            return float(np.dot(p, n) / np.linalg.norm(n)) * self._plane_area() / 3
        return self._round_integrals[1] if self._is_round else self._integrals[1]

    @functools.cached_property
    def _is_round(self):
        """A part of a cylinder, or one of a cone between other lines than those of its parameters, which never reaches the tip."""
        edges = [Edge(edge) for edge in self.edges if not BRep_Tool.Degenerated_s(edge)]
        straight = all(edge.curve.GetType() in (Curve.GeomAbs_Line, Curve.GeomAbs_Circle) for edge in edges)
        return self.kind == "cylinder" or (self.kind == "cone" and not straight)

    @functools.cached_property
    def _round_integrals(self):
        """Area and volume of any part of a cylinder or cone: with height v and angle u about the axis and the radius r + v tan a, the integrals
        of R du / cos a and of R (c.e + r - c.z tan a) du / 3 round the face, R = r v + v² tan a / 2, c the origin of the axis z and e the direction off it."""
        is_cone = self.kind == "cone"
        surface = self.surface.Cone() if is_cone else self.surface.Cylinder()
        radius, slope = (surface.RefRadius(), math.tan(surface.SemiAngle())) if is_cone else (surface.Radius(), 0.0)
        axis = surface.Axis()
        origin, z = vector(axis.Location()), vector(axis.Direction())
        area, volume = 0.0, 0.0
        places = np.concatenate([0.25 + 0.25 * _NODES, 0.75 + 0.25 * _NODES])
        weights = 0.25 * np.concatenate([_WEIGHTS, _WEIGHTS])
        for edge in self.edges:
            sign = -1.0 if edge.Orientation() == TopAbs_REVERSED else 1.0
            points, ways = Edge(edge).moving(places)
            v = points - origin
            height = v @ z
            off = v - height[:, None] * z
            inside = radius * height + 0.5 * slope * height**2
            steps = sign * weights * inside * (cross(off, ways) @ z) / np.sum(off * off, -1)
            area += math.hypot(1.0, slope) * steps.sum()
            volume += np.sum(steps * (off @ origin / np.linalg.norm(off, axis=-1) + radius - slope * (origin @ z))) / 3
        p, n = self.at(self.box[0], self.box[2])
        v = p - origin
        outward = np.dot(n, v - (v @ z) * z) > 0
        return abs(area), (1.0 if outward else -1.0) * math.copysign(1.0, area) * volume

    @functools.cached_property
    def _integrals(self):
        """Area and volume by Gauss-Legendre, 24 x 24 nodes on each quarter of the range of the parameters, which is the face."""
        u0, u1, v0, v1 = self.box
        places = np.concatenate([0.25 + 0.25 * _NODES, 0.75 + 0.25 * _NODES])
        weights = 0.25 * np.concatenate([_WEIGHTS, _WEIGHTS])
        p, n = self.at_all(u0 + (u1 - u0) * places[:, None], v0 + (v1 - v0) * places[None, :])
        elements = np.linalg.norm(n, axis=-1), np.sum(p * n, axis=-1) / 3
        return [float((u1 - u0) * (v1 - v0) * (weights @ values @ weights)) for values in elements]

    def _plane_area(self):
        """Half the integral of r x dr round the face."""
        origin, total = self.at(self.box[0], self.box[2])[0], np.zeros(3)
        for edge in self.edges:
            sign = -1.0 if edge.Orientation() == TopAbs_REVERSED else 1.0
            points, ways = Edge(edge).moving(0.5 + 0.5 * _NODES)
            total += sign * 0.25 * _WEIGHTS @ cross(points - origin, ways)
        return float(np.linalg.norm(total))

    def normals_near(self, points, edge, places):
        """Unit normals at points of an edge of this face, at these fractions of its parameter's range, found through the
        edge's curve in the parameters."""
        curve = BRep_Tool.CurveOnSurface_s(edge, self.shape, 0.0, 0.0)
        curve = curve[0] if isinstance(curve, tuple) else curve
        adaptor = BRepAdaptor_Curve(edge)
        first, last = adaptor.FirstParameter(), adaptor.LastParameter()
        found = []
        for point, place in zip(points, places):
            at = curve.Value(first + (last - first) * place)
            u, v = at.X(), at.Y()
            goal = gp_Pnt(*map(float, point))
            for _ in range(6):  # the interpolated curve is near the edge: a few Newton steps are enough
                p, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
                self.surface.D1(u, v, p, du, dv)
                r = gp_Vec(p, goal)
                a, b, c = du.SquareMagnitude(), du.Dot(dv), dv.SquareMagnitude()
                e, f, det = r.Dot(du), r.Dot(dv), a * c - b * b
                steps = (c * e - b * f) / det, (a * f - b * e) / det
                u, v = u + steps[0], v + steps[1]
                if max(map(abs, steps)) < 1e-15 * (1 + abs(u) + abs(v)):
                    break
            p, normal = self.at(u, v)
            assert np.linalg.norm(p - point) < 1e-9 * (1 + abs(point).max()), "the edge is not on the face"
            found.append(normal / np.linalg.norm(normal))
        return found


class StepFaces:
    """Everything in the file that belongs to faces."""

    def __init__(self, path):
        reader = STEPControl_Reader()
        assert reader.ReadFile(str(path)) == IFSelect_RetDone, f"OpenCASCADE does not read {path}"
        reader.TransferRoots()
        shape = reader.OneShape()
        assert not shape.IsNull(), f"{path} holds no shape"
        self._take(shape)

    @classmethod
    def of(cls, shape):
        """The faces of a shape that is no file."""
        made = cls.__new__(cls)
        made._take(shape)
        return made

    def _take(self, shape):
        self.shape = shape
        self.valid = BRepCheck_Analyzer(self.shape).IsValid()
        self.faces = [Face(TopoDS.Face(f)) for f in distinct(self.shape, TopAbs_FACE)]
        edges = [TopoDS.Edge(e) for e in distinct(self.shape, TopAbs_EDGE)]
        self.poles = sum(BRep_Tool.Degenerated_s(e) for e in edges)
        self.edges = [Edge(e) for e in edges if not BRep_Tool.Degenerated_s(e)]
        self.vertices = distinct(self.shape, TopAbs_VERTEX)
        self.shells = distinct(self.shape, TopAbs_SHELL)
        self.solids = distinct(self.shape, TopAbs_SOLID)
        self.tolerance = max(
            [e.tolerance for e in self.edges] + [BRep_Tool.Tolerance_s(TopoDS.Vertex(v)) for v in self.vertices]
        )

    @functools.cached_property
    def exactly_valid(self):
        return BRepCheck_Analyzer(self.shape, True, False, True).IsValid()

    def faces_of_edges(self):
        """(edge, faces) with the edge as each face uses it."""
        users = {}
        for face in self.faces:
            for edge in face.edges:
                if BRep_Tool.Degenerated_s(edge):
                    continue
                groups = users.setdefault(hash(edge), [])
                for group in groups:
                    if group[0][1].IsSame(edge):
                        group.append((face, edge))
                        break
                else:
                    groups.append([(face, edge)])
        return [group for groups in users.values() for group in groups]

    def size(self):
        points = np.array([e.point(x) for e in self.edges for x in (0.0, 0.5, 1.0)])
        return float(np.linalg.norm(np.ptp(points, axis=0)))

    def area(self):
        """By OpenCASCADE's adaptive integration."""
        measure = GProp_GProps()
        BRepGProp.SurfaceProperties_s(self.shape, measure, 1e-11)
        return measure.Mass()

    def volume(self):
        measure = GProp_GProps()
        BRepGProp.VolumeProperties_s(self.shape, measure, 1e-11)
        return measure.Mass()


def angle(a, b):
    """Angle between unit vectors without loss for small ones."""
    return 2.0 * math.atan2(np.linalg.norm(a - b), np.linalg.norm(a + b))
