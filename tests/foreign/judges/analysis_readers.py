"""Files for analysis programs read by these: MFEM, G+Smo and splinepy evaluate what they have read, and the numbers are written down as JSON, which
test_analysis.py compares with forms that it computes itself.

The three are called here through their public interfaces, in an environment of their own (MFEM's wheel and what it needs take 700 MB), and are needed for
nothing else: neither by the program nor by the tests, which read the numbers.

    python -m venv judge && judge/bin/pip install mfem==4.10.0.1 pygismo==26.9.0 splinepy==0.2.1
    judge/bin/python tests/foreign/judges/analysis_readers.py target/debug/cyclide > tests/foreign/judges/analysis_readers.json
"""

import json
import subprocess
import sys
import tempfile
from importlib.metadata import version
from pathlib import Path

import numpy as np

PLACES = 40
CORNERS = [[0, 0, 0], [60, 8, -6], [-10, 50, 4], [5, -6, 45]]
# The rotation nearest to the unit directions of its sides.
FRAME = [[0.981816640315856, 0.1666945364060334, -0.09082409554332212], [-0.15634230490022683, 0.9814245325342454, 0.11118889620111176]]
HALF_RING = [[10, 0, 0], [-10, 0, 0], [10, 0, 5], [-10, 0, 5], [20, 0, 0], [-20, 0, 0], [20, 0, 5]]
DOCUMENTS = {
    "block": {"b": {"type": "cyclide-volume", "corners": CORNERS, "inside": [1, 1.3, 0.8], "frame": FRAME}},
    # Sides of half a circle: four parts, which share faces.
    "half ring": {"ring": {"type": "cyclide-volume", "corners": HALF_RING, "frame": [[0, 1, 0], [0, 0, 1]]}},
    # Closed round and round: every block has neighbors on four sides.
    "layers": {
        "tube": {"type": "cyclide", "a": 3, "c": 1, "mu": 1.5, "construction": True},
        "wall": {"type": "layers", "of": "tube", "distances": [-0.3, -0.1, 0, 0.2]},
    },
    "surfaces": {
        "patch": {"type": "cyclide-patch", "corners": [[-4, -3], [4, -3], [-3, 4], [3, 4]], "frame": [[8, -1, 4], [-1, 4, 3]]},
        "cyclide": {"type": "cyclide", "a": 3, "c": 1, "mu": 1.5},
    },
    "curves": {
        "arcs": {"type": "arc-spline", "points": [[0, 0], [3, 1], [4, 4], [9, 5]]},
        "fair": {"type": "fair-spline", "points": [[0, 0, 0], [4, 1, 2], [6, 5, 0], [2, 6, 1]], "closed": True},
        "round": {"type": "circle", "center": [1, 1], "radius": 2},
    },
}


def places(count, dimension):
    """Patches of a file with places inside them, the same in every run."""
    random = np.random.default_rng(1)
    return list(zip(random.integers(0, count, PLACES).tolist(), random.uniform(0.02, 0.98, (PLACES, dimension)).tolist()))


def by_mfem(path):
    """Of curves each span is an element."""
    import mfem.ser as mfem

    mesh = mfem.Mesh(str(path), 1, 1)
    dimension, measure, rows = mesh.Dimension(), 0.0, []
    for element, place in places(mesh.GetNE(), dimension):
        ip = mfem.IntegrationPoint()
        ip.Set3(*(place + [0.0] * (3 - dimension)))
        point = mesh.GetElementTransformation(element).Transform(ip)
        rows.append([element, place, np.array(point).tolist()])
    for element in range(mesh.GetNE()):
        transformation = mesh.GetElementTransformation(element)
        rule = mfem.IntRules.Get(transformation.GetGeometryType(), 24)
        for k in range(rule.GetNPoints()):
            ip = rule.IntPoint(k)
            transformation.SetIntPoint(ip)
            measure += ip.weight * transformation.Weight()
    wrong = mesh.CheckElementOrientation(False) + mesh.CheckBdrElementOrientation(False) if dimension == 3 else 0
    attributes = sorted(set(map(int, mesh.GetBdrAttributeArray())))
    counts = {"elements": mesh.GetNE(), "boundary": mesh.GetNBE(), "boundary_attributes": attributes}
    return {"rows": rows, "measure": measure, "wrong_orientations": wrong, **counts}


def by_gismo(path):
    """G+Smo takes the first multi-patch of a file."""
    import pygismo

    multi = pygismo.core.gsMultiPatch()
    pygismo.io.gsReadFile(str(path), multi)
    rows = []
    for patch, place in places(multi.nPatches(), multi.patch(0).parDim()):
        rows.append([patch, place, np.array(multi.patch(patch).eval(np.array([place]).T)).ravel().tolist()])
    counts = {"patches": multi.nPatches(), "interfaces": len(multi.interfaces()), "boundary": len(multi.boundaries())}
    return {"rows": rows, **counts}


def by_splinepy(path):
    import splinepy

    loaded = splinepy.io.gismo.load(str(path))[0]
    patches = getattr(loaded, "patches", loaded)
    rows = []
    for patch, place in places(len(patches), patches[0].para_dim):
        rows.append([patch, place, np.ravel(patches[patch].evaluate([place])).tolist()])
    return {"rows": rows, "patches": len(patches)}


def main():
    program = Path(sys.argv[1]).resolve()
    found = {"versions": {name: version(name) for name in ("mfem", "pygismo", "splinepy")}, "documents": {}}
    with tempfile.TemporaryDirectory() as folder:
        for name, objects in DOCUMENTS.items():
            document = {"cyclide": 1, "units": "mm", "objects": objects}
            model = Path(folder, "model.json")
            model.write_text(json.dumps(document))
            files = [Path(folder, f"o.{suffix}") for suffix in ("mesh", "xml")]
            subprocess.run([program, "build", model, *(word for file in files for word in ("-o", file))], check=True, stdout=subprocess.DEVNULL)
            mesh, xml = files
            read = {"mfem": by_mfem(mesh), "pygismo": by_gismo(xml)}
            if name != "curves":
                # G+Smo wants curves to be called `Nurbs`, splinepy another word.
                read["splinepy"] = by_splinepy(xml)
            found["documents"][name] = {"document": document, "read": read}
    json.dump(found, sys.stdout, indent=None, separators=(",", ":"))
    print()


if __name__ == "__main__":
    main()
