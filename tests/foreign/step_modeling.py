"""What people do to a solid after reading it, in OpenCASCADE: checks, booleans, sections, fillets, thickening."""

import contextlib
import os
import sys

import numpy as np
from OCP.Bnd import Bnd_Box
from OCP.BOPAlgo import BOPAlgo_ArgumentAnalyzer
from OCP.BRep import BRep_Tool
from OCP.BRepAlgoAPI import BRepAlgoAPI_Common, BRepAlgoAPI_Cut, BRepAlgoAPI_Fuse, BRepAlgoAPI_Section
from OCP.BRepBndLib import BRepBndLib
from OCP.BRepCheck import BRepCheck_Analyzer
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepGProp import BRepGProp
from OCP.BRepOffsetAPI import BRepOffsetAPI_MakeThickSolid
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCylinder
from OCP.gp import gp_Ax2, gp_Dir, gp_Pln, gp_Pnt
from OCP.GProp import GProp_GProps
from OCP.ShapeAnalysis import ShapeAnalysis_Surface
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopoDS import TopoDS

from quaternion_form import cross
from step_faces import Edge, angle, distinct, vector

# As FreeCAD's "BOP check" sets them, and all others.
CHECKS = (
    "ArgumentTypeMode SelfInterMode SmallEdgeMode RebuildFaceMode TangentMode MergeVertexMode MergeEdgeMode "
    "ContinuityMode CurveOnSurfaceMode"
).split()
OPERATIONS = {"cut": BRepAlgoAPI_Cut, "fuse": BRepAlgoAPI_Fuse, "common": BRepAlgoAPI_Common}
# Places of an edge at which it is held against its faces: between those that the reader interpolates.
PLACES = 41
# Halvings of a face's parameters where a field has kinks.
LEVELS = 8


@contextlib.contextmanager
def quiet():
    """Without what OpenCASCADE prints."""
    sys.stdout.flush()
    keep, null = os.dup(1), os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    try:
        yield
    finally:
        sys.stdout.flush()
        os.dup2(keep, 1)
        os.close(keep)
        os.close(null)


def valid(shape):
    return BRepCheck_Analyzer(shape, True).IsValid()


def faults(shape):
    """What the check before boolean operations finds, by kind."""
    check = BOPAlgo_ArgumentAnalyzer()
    check.SetShape1(shape)
    for mode in CHECKS:
        setattr(check, mode, True)
    with quiet():
        check.Perform()
    return sorted({str(found.GetCheckStatus()).split("_")[-1] for found in check.GetCheckResult()})


def volume(shape):
    measure = GProp_GProps()
    BRepGProp.VolumeProperties_s(shape, measure, 1e-12)
    return measure.Mass()


def departures(step):
    """(largest distance at equal parameters, tolerance) of every edge on every face."""
    found = []
    for face in step.faces:
        surface = BRep_Tool.Surface_s(face.shape)
        for edge in face.edges:
            if BRep_Tool.Degenerated_s(edge):
                continue
            own = Edge(edge)
            curve = BRep_Tool.CurveOnSurface_s(edge, face.shape, 0.0, 0.0)
            curve = curve[0] if isinstance(curve, tuple) else curve
            largest = 0.0
            for x in np.linspace(own.first, own.last, PLACES):
                at = curve.Value(float(x))
                largest = max(largest, surface.Value(at.X(), at.Y()).Distance(own.curve.Value(float(x))))
            found.append((largest, own.tolerance))
    return found


def slab(low, high):
    """A box across a solid between 0.31 and 0.57 of its extent along x: its shape, volume and the field whose divergence is 1
    inside and 0 outside, as long as it is longer than the solid in y and z."""
    size = high - low
    at, to = low + size * [0.31, -0.1, -0.1], low + size * [0.57, 1.1, 1.1]

    def field(p, n):
        return np.clip(p[..., 0], at[0], to[0]) * n[..., 0]

    return BRepPrimAPI_MakeBox(gp_Pnt(*at), gp_Pnt(*to)).Shape(), float(np.prod(to - at)), field


def drill(low, high):
    """A cylinder along z through a solid, off its middle, likewise."""
    size = high - low
    at, radius, length = low + size * [0.37, 0.43, -0.2], 0.29 * min(size[:2]), 1.4 * size[2]

    def field(p, n):
        x, y = p[..., 0] - at[0], p[..., 1] - at[1]
        inside = np.minimum(1.0, radius**2 / np.maximum(x**2 + y**2, 1e-300))
        return 0.5 * inside * (x * n[..., 0] + y * n[..., 1])

    axis = gp_Ax2(gp_Pnt(*at), gp_Dir(0, 0, 1))
    return BRepPrimAPI_MakeCylinder(axis, radius, length).Shape(), float(np.pi * radius**2 * length), field


def section(shape, point, normal):
    cut = BRepAlgoAPI_Section(shape, gp_Pln(gp_Pnt(*point), gp_Dir(*normal)))
    cut.Build()
    return cut.Shape()


def normal(face, edge):
    """The outer normal in the middle of an edge of the face."""
    own = Edge(edge)
    curve = BRep_Tool.CurveOnSurface_s(edge, face.shape, 0.0, 0.0)
    curve = curve[0] if isinstance(curve, tuple) else curve
    at = curve.Value(0.5 * (own.first + own.last))
    n = face.at(at.X(), at.Y())[1]
    return n / np.linalg.norm(n)


def creases(users):
    """The edges at which two faces meet at an angle, from the faces of every edge."""
    pairs = [group for group in users if len(group) == 2]
    return [group[0][1] for group in pairs if angle(*(normal(face, edge) for face, edge in group)) > 0.05]


def fillets(shape, edges, radius):
    """How many of the edges take a fillet of this radius, each alone; the result is valid."""
    good = 0
    for edge in edges:
        make = BRepFilletAPI_MakeFillet(shape)
        make.Add(radius, edge)
        try:
            with quiet():
                make.Build()
            good += make.IsDone() and valid(make.Shape())
        except Exception:  # the reader's own failures: Standard_Failure and what derives from it
            pass
    return good


def thickened(shell, distance):
    """The solid that OpenCASCADE itself makes of a shell."""
    make = BRepOffsetAPI_MakeThickSolid()
    make.MakeThickSolidBySimple(shell, distance)
    return make.Shape()


def box(step):
    """The corners of the smallest box round the shape."""
    bounds = Bnd_Box()
    BRepBndLib.AddOptimal_s(step.shape, bounds, False, False)
    return vector(bounds.CornerMin()), vector(bounds.CornerMax())


def wire_points(shape):
    """Points of all edges of a section."""
    edges = [Edge(TopoDS.Edge(e)) for e in distinct(shape, TopAbs_EDGE)]
    return np.array([vector(e.curve.Value(e.first + (e.last - e.first) * x)) for e in edges for x in (0.0, 0.4, 1.0)])


def common_volume(step, field):
    """Volume of a solid's part in a tool from the flux of the tool's field through the faces, each the patch in the quaternion
    form through its corners as read."""
    total, limit = 0.0, 1e-13 * step.size() ** 3
    for face in step.faces:
        patch = face.patch()
        p, fs, ft, _ = patch.jet(np.array(0.5), np.array(0.5))
        at = ShapeAnalysis_Surface(BRep_Tool.Surface_s(face.shape)).ValueOfUV(gp_Pnt(*p), 1e-6)
        sign = np.sign(np.dot(np.cross(fs, ft), face.at(at.X(), at.Y())[1]))
        total += sign * flux(patch, field, limit)
    return total


def flux(patch, field, limit):
    """Gauss-Legendre, 6 x 6 nodes a cell; cells are quartered until that changes nothing. A field has kinks in the faces of its
    tool: there it ends after eight halvings, in cells of 1/65,000 of the face, of which those on the kink miss parts of 1e-7."""
    nodes, weights = np.polynomial.legendre.leggauss(6)
    nodes, weights = 0.5 + 0.5 * nodes, 0.25 * np.outer(weights, weights)

    def values(cells, width):
        s = cells[:, 0, None, None] + width * nodes[:, None] + 0.0 * nodes
        t = cells[:, 1, None, None] + width * nodes + 0.0 * nodes[:, None]
        p, fs, ft, _ = patch.jet(s, t)
        return width**2 * np.sum(weights * field(p, cross(fs, ft)), axis=(1, 2))

    cells, width, total = np.stack(np.meshgrid([0.0, 0.5], [0.0, 0.5]), -1).reshape(-1, 2), 0.5, 0.0
    whole = values(cells, width)
    for level in range(LEVELS):
        width *= 0.5
        quarters = (cells[:, None] + width * np.array([[0, 0], [1, 0], [0, 1], [1, 1]])).reshape(-1, 2)
        parts = values(quarters, width)
        finer = parts.reshape(-1, 4).sum(axis=1)
        rough = abs(finer - whole) > limit if level < LEVELS - 1 else np.zeros(len(finer), bool)
        total += finer[~rough].sum()
        cells, whole = quarters.reshape(-1, 4, 2)[rough].reshape(-1, 2), parts.reshape(-1, 4)[rough].ravel()
        if not len(cells):
            break
    return float(total)
