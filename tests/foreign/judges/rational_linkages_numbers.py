"""Writes what the package rational-linkages makes of random points and poses, as JSON: what test_judges.py compares our curves and motions with.

rational-linkages is under the GPL. It is called here through its public interface, in an environment of its own, and is needed for nothing else:
neither by the program nor by the tests, which read the numbers.

    python -m venv judge && judge/bin/pip install rational-linkages==3.0.1
    judge/bin/python tests/foreign/judges/rational_linkages_numbers.py > tests/foreign/judges/rational_linkages.json
"""

import json
from importlib.metadata import version

import numpy as np
from rational_linkages import DualQuaternion, MotionInterpolation, PointHomogeneous, TransfMatrix

PLACES = [k / 12 for k in range(13)]


def matrix_at(curve, t):
    """The matrix of the pose, the translation in its last column."""
    rows = np.array(DualQuaternion(curve.evaluate(t)).dq2matrix(), float)
    rows /= rows[0, 0]
    return np.hstack([rows[1:, 1:], rows[1:, :1]])


def random_pose(random):
    w, x, y, z = (p := random.normal(size=4)) / np.linalg.norm(p)
    turn = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]
    return np.hstack([turn, random.uniform(-3, 3, (3, 1))])


def judged(pose):
    """A pose as the package has it: homogeneous coordinates first."""
    return TransfMatrix(np.vstack([[1, 0, 0, 0], np.hstack([pose[:, 3:], pose[:, :3]])]))


def main():
    random = np.random.default_rng(40)
    points, conics = [], []
    for count in (5, 7):
        for _ in range(6):
            given = random.uniform(-3, 3, (count, 3)).round(6)
            curve = MotionInterpolation.interpolate([PointHomogeneous([1.0, *p]) for p in given])
            samples = [matrix_at(curve, t)[:, 3].tolist() for t in PLACES]
            points.append({"points": given.tolist(), "samples": samples})
    for _ in range(6):
        # It wants the first pose to be the identity, and takes the poses at the parameters infinity, 1 and 0.
        poses = [np.eye(4)[:3], random_pose(random), random_pose(random)]
        curve = MotionInterpolation.interpolate([judged(pose) for pose in poses])
        samples = [matrix_at(curve, (1 - t) / t).tolist() for t in PLACES[1:]]
        conics.append({"poses": [pose.tolist() for pose in poses], "samples": samples})
    numbers = {"package": f"rational-linkages {version('rational-linkages')}", "places": PLACES}
    print(json.dumps(numbers | {"points": points, "conics": conics}))


if __name__ == "__main__":
    main()
