"""Time and size of VTU files against VTK's own writer and meshio, in one run.

    .venv/bin/python -m pip install meshio==5.3.5 && .venv/bin/python benches/compare_vtu.py PROGRAM [SEGMENTS]      default 40

Layers over a whole ring cyclide of SEGMENTS x SEGMENTS patches, 8 high: rational Bezier hexahedra with weights. Ours is the processor time of the whole
program, which makes the blocks, measures them for the report, writes the file, reads it back and holds it against them; without a file it is that of
`cyclide report`, and the difference is what the file takes. The others are given the arrays, as VTK has read them from our file, and write them alone: meshio as Lagrange cells, for it does not
know Bezier ones, and without the attribute that readers need. Reading is VTK's, of each file.
"""

import json
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader, vtkXMLUnstructuredGridWriter
from vtkmodules.util.numpy_support import vtk_to_numpy


def seconds_of(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def timed(action):
    start = time.process_time()
    result = action()
    return time.process_time() - start, result


def read(path):
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def by_vtk(grid, path, mode):
    writer = vtkXMLUnstructuredGridWriter()
    writer.SetFileName(str(path))
    writer.SetInputData(grid)
    writer.SetCompressorTypeToNone()
    if mode == "ascii":
        writer.SetDataModeToAscii()
    else:
        writer.SetDataModeToAppended()
        writer.SetEncodeAppendedData(True)
    assert writer.Write()


def by_meshio(mesh, path, binary):
    import meshio

    meshio.vtu.write(path, mesh, binary=binary, compression=None)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    program, segments = Path(sys.argv[1]).resolve(), int(sys.argv[2]) if len(sys.argv) > 2 else 40
    rows = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        model = folder / "model.json"
        ring = {"type": "cyclide", "a": 30, "c": 10, "mu": 15, "segments": [segments, segments], "construction": True}
        layers = {"type": "layers", "of": "ring", "first": 0.1, "growth": 1.2, "count": 8}
        model.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"ring": ring, "wall": layers}}))

        def row(what, seconds, path):
            reading, grid = timed(lambda: read(path))
            rows.append((what, seconds, path.stat().st_size / 1e6, reading))
            return grid

        without = seconds_of([program, "report", model])
        own = folder / "own.vtu"
        grid = row("cyclide, digits", seconds_of([program, "build", model, "-o", own]), own)
        own64 = folder / "own64.vtu"
        row("cyclide, base64", seconds_of([program, "build", model, "-o", own64, "--vtu-encoding", "base64"]), own64)
        for mode in ("ascii", "base64"):
            path = folder / f"vtk-{mode}.vtu"
            row(f"VTK, {mode}", timed(lambda: by_vtk(grid, path, mode))[0], path)
        try:
            import meshio
        except ImportError:
            print("meshio is not installed")
        else:
            points = vtk_to_numpy(grid.GetPoints().GetData())
            cells = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 27)
            weights = vtk_to_numpy(grid.GetPointData().GetArray("RationalWeights"))
            mesh = meshio.Mesh(points, [("VTK_LAGRANGE_HEXAHEDRON", cells)], point_data={"RationalWeights": weights})
            for mode in ("ascii", "base64"):
                path = folder / f"meshio-{mode}.vtu"
                row(f"meshio, {mode}", timed(lambda: by_meshio(mesh, path, mode != "ascii"))[0], path)
        print(f"{grid.GetNumberOfCells()} cells, {grid.GetNumberOfPoints()} nodes; without a file {without:.2f} s")
        print("| writer | write, s | size, MB | read by VTK, s |\n|---|---|---|---|")
        for what, seconds, size, reading in rows:
            print(f"| {what} | {seconds:.2f} | {size:.1f} | {reading:.2f} |")


if __name__ == "__main__":
    main()
