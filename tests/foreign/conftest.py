"""Builds every model once with the program as the tests build it and hands the files to the readers' tests."""

import fcntl
import json
import os
import subprocess
from pathlib import Path

import pytest

import reference_objects

pytest.register_assert_rewrite("step_checks")

ROOT = Path(__file__).resolve().parents[2]
MODELS = {
    **{name: ROOT / "examples" / f"{name}.json" for name in ("track", "logo", "cable")},
    **{p.stem: p for p in sorted((ROOT / "tests" / "foreign" / "models").glob("*.json"))},
}


def program_path():
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"]
    folder = json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True).stdout)["target_directory"]
    path = Path(folder, "debug", "cyclide")
    assert path.exists(), f"{path} is missing: cargo build --profile test --workspace --bins first"
    return path


@pytest.fixture(scope="session")
def program():
    """Runs the program; the arguments are those of its command line. Returns what it printed."""
    path = program_path()

    def run(*arguments, cwd=ROOT):
        done = subprocess.run([path, *map(str, arguments)], cwd=cwd, capture_output=True, text=True)
        assert done.returncode == 0, f"{arguments}: exit {done.returncode}\n{done.stderr}"
        return done.stdout

    return run


def shared_folder(factory, name, make):
    """A folder that one of the workers makes, and all use."""
    base = factory.getbasetemp()
    root = base.parent if "PYTEST_XDIST_WORKER" in os.environ else base
    folder, done = root / name, root / f"{name}.done"
    with open(root / f"{name}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if not done.exists():
            make(folder)
            done.touch()
    return folder


class Built:
    """One model: its document, the reference curves, the report and the files written."""

    def __init__(self, name, document, folder, run):
        self.name, self.document, self.folder = name, document, folder
        self.units, self.objects = reference_objects.load(document)
        self.in_millimetres = reference_objects.MILLIMETRES[self.units]
        self._run = run
        self._written = {}

    def _build(self, suffix, options):
        """Path and report of the model's file with this suffix, made on first use."""
        key = (suffix, options)
        if key not in self._written:
            path = self.folder / f"{self.name}-{len(self._written)}.{suffix}"
            report = json.loads(self._run("build", self.document, "-o", path, "--json", *options))
            self._written[key] = path, report
        return self._written[key]

    def file(self, suffix, *options):
        return self._build(suffix, options)[0]

    def file_report(self, suffix, *options):
        """What the program says about the file: format, exact, deviation, bound."""
        path, report = self._build(suffix, options)
        (entry,) = report["files"]
        assert Path(entry["path"]).resolve() == path.resolve()
        return entry

    def report(self):
        return json.loads(self._run("report", self.document, "--json"))

    def contours(self):
        """(object name, contour index, reference curve or None, points or None) of every connected curve."""
        for name, reference in self.objects.items():
            count = len(reference.curves or reference.points)
            for i in range(count):
                yield (
                    name,
                    i,
                    reference.curves[i] if reference.curves else None,
                    reference.points[i] if reference.points else None,
                )


@pytest.fixture(scope="session", params=sorted(MODELS))
def built(request, program, tmp_path_factory):
    return Built(request.param, MODELS[request.param], tmp_path_factory.mktemp(request.param), program)


@pytest.fixture(scope="session")
def examples(program, tmp_path_factory):
    """The three example models by name."""
    names = ("track", "logo", "cable")
    return {n: Built(n, MODELS[n], tmp_path_factory.mktemp(n), program) for n in names}
