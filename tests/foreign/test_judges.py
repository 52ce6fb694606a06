"""Curves through points and motions through poses against those of another program, whose numbers were written down once:
`judges/rational_linkages_numbers.py` says how."""

import json
from pathlib import Path

import numpy as np
import pytest

NUMBERS = json.loads((Path(__file__).parent / "judges" / "rational_linkages.json").read_text())
COUNT = len(NUMBERS["places"])


def sampled(program, folder, kind, fields):
    path = folder / "object.json"
    path.write_text(json.dumps({"cyclide": 1, "units": "mm", "objects": {"o": {"type": kind, **fields}}}))
    table = program("sample", path, "--object", "o", "--count", COUNT)
    head, *rows = table.splitlines()
    return head.split(","), np.array([[float(v or "nan") for v in row.split(",")] for row in rows])


@pytest.mark.parametrize("case", range(len(NUMBERS["points"])))
def test_curves_through_points_are_the_same(program, tmp_path, case):
    case = NUMBERS["points"][case]
    fields = {"points": case["points"], "parameters": "uniform"}
    head, rows = sampled(program, tmp_path, "qb-interpolation", fields)
    ours = rows[:, [head.index(axis) for axis in "xyz"]]
    # Curves of degree 3 through random points swing out: their points are rounded by that.
    size = max(1.0, np.abs(case["samples"]).max())
    assert np.abs(ours - case["samples"]).max() < 1e-11 * size


@pytest.mark.parametrize("case", range(len(NUMBERS["conics"])))
def test_motions_through_three_poses_are_the_same(program, tmp_path, case):
    case = NUMBERS["conics"][case]
    # Through three poses there is one conic, whatever the times, up to a projective change of time: poses at 0, 1/2 and 1 have theirs at
    # infinity, 1 and 0.
    times = (0.0, 0.5, 1.0)
    poses = [{"time": t, "matrix": pose} for t, pose in zip(times, case["poses"])]
    _, rows = sampled(program, tmp_path, "motion", {"kind": "conic", "poses": poses})
    matrices = rows[1:, 8:20].reshape(-1, 3, 4)
    size = max(1.0, np.abs(case["samples"]).max())
    assert np.abs(matrices - case["samples"]).max() < 1e-11 * size
