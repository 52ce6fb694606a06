"""A STEP file as OpenCASCADE sees it: wires, their edges, validity, points and lengths."""

import numpy as np
from OCP.BRep import BRep_Tool
from OCP.BRepAdaptor import BRepAdaptor_Curve
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepTools import BRepTools_WireExplorer
from OCP.GeomAbs import GeomAbs_BSplineCurve, GeomAbs_Circle, GeomAbs_Line, GeomAbs_Shape
from OCP.gp import gp_Pnt, gp_Vec
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE, TopAbs_REVERSED, TopAbs_WIRE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

KINDS = {GeomAbs_Line: "line", GeomAbs_Circle: "circle", GeomAbs_BSplineCurve: "b-spline"}
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(24)


class Edge:
    """An edge with the curve and the parameter range OpenCASCADE gives it."""

    def __init__(self, edge):
        self.curve = BRepAdaptor_Curve(edge)
        self.first, self.last = self.curve.FirstParameter(), self.curve.LastParameter()
        self.kind = KINDS.get(self.curve.GetType(), "other")
        self.tolerance = BRep_Tool.Tolerance_s(edge)
        self.reversed = edge.Orientation() == TopAbs_REVERSED

    def points(self, count):
        """Points at equal steps of the parameter, ends included, in the wire's direction."""
        out = np.empty((count, 3))
        for row, t in zip(out, np.linspace(self.first, self.last, count)):
            p = self.curve.Value(float(t))
            row[:] = p.X(), p.Y(), p.Z()
        return out[::-1] if self.reversed else out

    def speed(self, t):
        point, d1 = gp_Pnt(), gp_Vec()
        self.curve.D1(float(t), point, d1)
        return d1.Magnitude()

    def knots(self):
        """The parameters between which the curve is smooth."""
        if self.kind != "b-spline":
            return np.array([self.first, self.last])
        spline = self.curve.BSpline()
        knots = np.array([spline.Knot(i) for i in range(1, spline.NbKnots() + 1)])
        inside = knots[(knots > self.first) & (knots < self.last)]
        return np.r_[self.first, inside, self.last]

    def length(self):
        """Gauss-Legendre, 24 nodes on each eighth of every knot span."""
        total = 0.0
        knots = self.knots()
        for a, b in zip(knots, knots[1:]):
            for s, e in zip(np.linspace(a, b, 9)[:-1], np.linspace(a, b, 9)[1:]):
                mid, half = 0.5 * (s + e), 0.5 * (e - s)
                total += half * sum(w * self.speed(mid + half * x) for x, w in zip(_NODES, _WEIGHTS))
        return total

    def is_c1(self):
        return self.curve.Continuity().value >= GeomAbs_Shape.GeomAbs_C1.value


class Wire:
    """A wire: its edges in the order of travel."""

    def __init__(self, wire):
        self.closed = BRep_Tool.IsClosed_s(wire)
        self.edges = []
        explorer = BRepTools_WireExplorer(wire)
        while explorer.More():
            self.edges.append(Edge(explorer.Current()))
            explorer.Next()
        self.edge_count = _count(wire, TopAbs_EDGE)

    def points(self, per_edge):
        return np.vstack([edge.points(per_edge) for edge in self.edges])

    def length(self):
        return sum(edge.length() for edge in self.edges)


def _count(shape, kind):
    explorer, count = TopExp_Explorer(shape, kind), 0
    while explorer.More():
        count += 1
        explorer.Next()
    return count


class StepFile:
    """Everything in the file; `edge_count` counts all edges, in wires or not."""

    def __init__(self, path):
        reader = STEPControl_Reader()
        assert reader.ReadFile(str(path)) == IFSelect_RetDone, f"OpenCASCADE does not read {path}"
        reader.TransferRoots()
        shape = reader.OneShape()
        assert not shape.IsNull(), f"{path} holds no shape"
        self.valid = BRepCheck_Analyzer(shape).IsValid()
        self.edge_count = _count(shape, TopAbs_EDGE)
        self.wires = []
        self.found = {}  # which wire runs along which reference curve, filled by the tests
        explorer = TopExp_Explorer(shape, TopAbs_WIRE)
        while explorer.More():
            self.wires.append(Wire(TopoDS.Wire(explorer.Current())))
            explorer.Next()
