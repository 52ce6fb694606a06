"""Rolling-ball blends: cyclide against the fillets of OpenCASCADE, in one run.

    cargo build --profile test --workspace --bins
    .venv/bin/python benches/compare_fillets.py

Three corners of natural quadrics with a ball of radius 0.4: two perpendicular skew cylinders, a cylinder on an oblique plane, a cone on
a cylinder. Of every blend face points on a grid are held against the true canal surface: the ball that touches both partners and whose
circle runs through the point is found by Newton's method on the equations of the partners, so that the figure is the distance from
the envelope of the balls of exactly this radius. cyclide's tee is an exact envelope of balls whose radius is within a tolerance: it is
measured as if its radius were constant (tests/foreign/test_step_tee.py holds it against its own balls). Times: of OpenCASCADE the fillet
alone, of cyclide the whole program with its check of the file.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np
from OCP.BRepAdaptor import BRepAdaptor_Curve, BRepAdaptor_Surface
from OCP.BRepAlgoAPI import BRepAlgoAPI_Fuse
from OCP.BRepClass import BRepClass_FaceClassifier
from OCP.BRepFilletAPI import BRepFilletAPI_MakeFillet
from OCP.BRepPrimAPI import BRepPrimAPI_MakeBox, BRepPrimAPI_MakeCone, BRepPrimAPI_MakeCylinder
from OCP.BRepTools import BRepTools
from OCP.GeomAbs import GeomAbs_BSplineSurface
from OCP.gp import gp_Ax2, gp_Dir, gp_Pnt, gp_Pnt2d, gp_Vec
from OCP.STEPControl import STEPControl_AsIs, STEPControl_Reader, STEPControl_Writer
from OCP.TopAbs import TopAbs_EDGE, TopAbs_FACE, TopAbs_IN
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "foreign"))
from step_modeling import quiet  # noqa: E402

RADIUS = 0.4


class Plane:
    def __init__(self, point, normal):
        self.point, self.normal = np.array(point, float), np.array(normal, float)

    def distance(self, points):
        return (points - self.point) @ self.normal, np.tile(self.normal, (len(points), 1))


class Quadric:
    """A cylinder (`half` = 0, radius at the point) or a cone that widens along its axis, from the outside."""

    def __init__(self, point, axis, radius, half=0.0):
        self.point, self.axis = np.array(point, float), np.array(axis, float) / np.linalg.norm(axis)
        self.radius, self.half = radius, half

    def distance(self, points):
        offset = points - self.point
        height = offset @ self.axis
        across = offset - np.outer(height, self.axis)
        length = np.linalg.norm(across, axis=1)
        cos, sin = np.cos(self.half), np.sin(self.half)
        return (length - self.radius) * cos - height * sin, across / np.maximum(length, 1e-300)[:, None] * cos - self.axis * sin


def canal_deviation(points, first, second):
    """How far each point is from the envelope of the balls of the radius that touch both from outside."""
    gradients = first.distance(points)[1] + second.distance(points)[1]
    centers = points + RADIUS * gradients / np.maximum(np.linalg.norm(gradients, axis=1), 1e-300)[:, None]
    for _ in range(60):
        (a, da), (b, db) = first.distance(centers), second.distance(centers)
        along = np.cross(da, db)
        off = np.stack([a - RADIUS, b - RADIUS, np.einsum("ij,ij->i", centers - points, along)], axis=1)
        step = np.linalg.solve(np.stack([da, db, along], axis=1), -off[:, :, None])[:, :, 0]
        length = np.linalg.norm(step, axis=1)
        centers += step * np.minimum(1, 0.3 * RADIUS / np.maximum(length, 1e-300))[:, None]
    assert length.max() < 1e-12, "no ball was found"
    return np.abs(np.linalg.norm(points - centers, axis=1) - RADIUS)


def shapes(shape, kind, cast):
    found, explorer = [], TopExp_Explorer(shape, kind)
    while explorer.More():
        item = cast(explorer.Current())
        if not any(item.IsSame(other) for other in found):
            found.append(item)
        explorer.Next()
    return found


def grid_of(face, counts, trimmed):
    """Points and normals of the face on a grid; if it is trimmed, those outside its border are left out."""
    surface, inside = BRepAdaptor_Surface(face), BRepClass_FaceClassifier()
    u0, u1, v0, v1 = BRepTools.UVBounds_s(face)
    points, normals = [], []
    for u in np.linspace(u0, u1, counts[0])[1:-1]:
        for v in np.linspace(v0, v1, counts[1])[1:-1]:
            if trimmed:
                inside.Perform(face, gp_Pnt2d(u, v), 1e-9)
            if not trimmed or inside.State() == TopAbs_IN:
                point, du, dv = gp_Pnt(), gp_Vec(), gp_Vec()
                surface.D1(u, v, point, du, dv)
                points.append(point.Coord())
                normals.append(np.cross(du.Coord(), dv.Coord()))
    return np.array(points), np.array(normals)


def poles(face):
    surface = BRepAdaptor_Surface(face)
    if surface.GetType() != GeomAbs_BSplineSurface:
        return 0, (0, 0)
    spline = surface.BSpline()
    return spline.NbUPoles() * spline.NbVPoles(), (spline.UDegree(), spline.VDegree())


def facts(faces, first, second, counts, trimmed):
    total, degrees, worst = 0, set(), 0.0
    for face in faces:
        count, degree = poles(face)
        total += count
        degrees.add(degree)
        worst = max(worst, canal_deviation(grid_of(face, counts, trimmed)[0], first, second).max())
    return dict(faces=len(faces), degrees=sorted(degrees), poles=total, deviation=worst)


def is_blend(face, first, second):
    """A face off both partners, and not flat."""
    points, normals = grid_of(face, (5, 5), False)
    flat = np.linalg.norm(np.cross(normals[0], normals), axis=1).max() < 1e-12 * np.linalg.norm(normals, axis=1).max() ** 2
    off = min(np.abs(partner.distance(points)[0]).max() for partner in (first, second))
    return not flat and off > 1e-9 and np.abs(first.distance(points)[0]).max() < 2 * RADIUS


def of_opencascade(solids, first, second, folder):
    fused = BRepAlgoAPI_Fuse(*solids).Shape()

    def common(edge):
        curve = BRepAdaptor_Curve(edge)
        places = np.linspace(curve.FirstParameter(), curve.LastParameter(), 9)[1:-1]
        points = np.array([curve.Value(place).Coord() for place in places])
        return max(np.abs(partner.distance(points)[0]).max() for partner in (first, second)) < 1e-4

    edges = [edge for edge in shapes(fused, TopAbs_EDGE, TopoDS.Edge) if common(edge)]
    start = time.perf_counter()
    fillet = BRepFilletAPI_MakeFillet(fused)
    for edge in edges:
        fillet.Add(RADIUS, edge)
    fillet.Build()
    seconds = time.perf_counter() - start
    if not fillet.IsDone():
        return None
    blend = [TopoDS.Face(face) for edge in edges for face in fillet.Generated(edge) if face.ShapeType() == TopAbs_FACE]
    writer, path = STEPControl_Writer(), Path(folder, "peer.step")
    with quiet():
        writer.Transfer(fillet.Shape(), STEPControl_AsIs)
        writer.Write(str(path))
    return facts(blend, first, second, (101, 41), True) | dict(bytes=path.stat().st_size, seconds=seconds)


def program():
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"]
    found = json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True).stdout)
    return Path(found["target_directory"], "debug", "cyclide")


def of_cyclide(thing, first, second, folder):
    document, path = Path(folder, "model.json"), Path(folder, "model.step")
    document.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"blend": thing}}))
    start = time.perf_counter()
    subprocess.run([program(), "build", document, "-o", path, "--force"], check=True, capture_output=True)
    seconds = time.perf_counter() - start
    reader = STEPControl_Reader()
    with quiet():
        reader.ReadFile(str(path))
        reader.TransferRoots()
    faces = shapes(reader.OneShape(), TopAbs_FACE, TopoDS.Face)
    blend = [face for face in faces if is_blend(face, first, second)]
    # Its faces end where their surfaces do.
    return facts(blend, first, second, (21, 21), False) | dict(bytes=path.stat().st_size, seconds=seconds)


def axis(point, direction):
    return gp_Ax2(gp_Pnt(*point), gp_Dir(*direction))


def cases():
    tee = {"type": "pipe-tee", "main": {"radius": 2, "ends": [-5, 5]}}
    branch = {"radius": 1, "length": 5, "offset": 0.5}
    skew = (
        [BRepPrimAPI_MakeCylinder(axis((-5, 0, 0), (1, 0, 0)), 2, 10).Shape(), BRepPrimAPI_MakeCylinder(axis((0, 0.5, 0), (0, 0, 1)), 1, 5).Shape()],
        Quadric((0, 0, 0), (1, 0, 0), 2),
        Quadric((0, 0.5, 0), (0, 0, 1), 1),
    )
    laws = {f"cyclide, radius to {t:.0e}": tee | {"branches": [branch | {"blend": {"radius": RADIUS, "tolerance": t}}]} for t in (1e-3, 1e-6)}
    yield "perpendicular skew cylinders", *skew, laws
    slope = np.radians(45)
    along = (0, np.sin(slope), np.cos(slope))
    yield (
        "cylinder on an oblique plane",
        [BRepPrimAPI_MakeBox(gp_Pnt(-6, -6, -1), gp_Pnt(6, 6, 0)).Shape(), BRepPrimAPI_MakeCylinder(axis((0, 0, 0), along), 1, 6).Shape()],
        Plane((0, 0, 0), (0, 0, 1)),
        Quadric((0, 0, 0), along, 1),
        {
            "cyclide, exact": {
                "type": "plate-with-neck", "pipe_radius": 1, "ball_radius": RADIUS, "height": 6, "plate": [12, 12],
                "slope": slope, "thickness": 1,
            }
        },
    )  # fmt: skip
    half = np.arctan(0.2)
    yield (
        "cone on a cylinder",
        [BRepPrimAPI_MakeCylinder(axis((-5, 0, 0), (1, 0, 0)), 2, 10).Shape(), BRepPrimAPI_MakeCone(axis((0, 0.5, 0), (0, 0, 1)), 1.5, 0.5, 5).Shape()],
        Quadric((0, 0, 0), (1, 0, 0), 2),
        Quadric((0, 0.5, 0), (0, 0, -1), 1.5, half),
        # The cone is 1.5 wide where the axes are nearest.
        {
            f"cyclide, radius to {t:.0e}": tee
            | {"branches": [{"radius": 1.5, "taper": half, "length": 5, "offset": 0.5, "blend": {"radius": RADIUS, "tolerance": t}}]}
            for t in (1e-3, 1e-6)
        },
    )  # fmt: skip
    pipes = [{"radius": 2, "ends": [-6, 6]}, {"radius": 1.5, "ends": [-6, 6]}]
    yield (
        "cylinders that pass each other",
        [BRepPrimAPI_MakeCylinder(axis((-6, 0, 0), (1, 0, 0)), 2, 12).Shape(), BRepPrimAPI_MakeCylinder(axis((0, -6, 3), (0, 1, 0)), 1.5, 12).Shape()],
        Quadric((0, 0, 0), (1, 0, 0), 2),
        Quadric((0, 0, 3), (0, 1, 0), 1.5),
        {
            f"cyclide, radius to {t:.0e}": {"type": "pipe-crossing", "pipes": pipes, "distance": 3, "blend": RADIUS, "tolerance": t}
            for t in (1e-3, 1e-6)
        },
    )  # fmt: skip


def main():
    print("| case | by | faces | degrees | poles | off the canal of radius 0.4 | STEP | time |")
    print("|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for name, solids, first, second, ours in cases():
            rows = {"OpenCASCADE": of_opencascade(solids, first, second, folder)}
            rows |= {by: of_cyclide(thing, first, second, folder) for by, thing in ours.items()}
            for by, row in rows.items():
                if row is None:
                    print(f"| {name} | {by} | no result | | | | | |")
                    continue
                degrees = ", ".join(f"({u}, {v})" for u, v in row["degrees"])
                print(
                    f"| {name} | {by} | {row['faces']} | {degrees} | {row['poles']} | {row['deviation']:.1e} |"
                    f" {row['bytes'] / 1e3:.0f} kB | {row['seconds'] * 1e3:.0f} ms |"
                )


if __name__ == "__main__":
    main()
