"""STEP solids read by truck, whose parser, topology and mesher share nothing with OpenCASCADE: it finds them closed.

Its crate `tests/foreign/truck` is built on first use (about two minutes of one core, kept in the target folder).
"""

import json
import subprocess

import pytest

from conftest import ROOT, program_path
from step_checks import EDGES
from test_step_modeling import SOLIDS, document, total

# truck merges points that are 5e-5 apart: it is given models of tens of millimetres.
NAMES = ("ring", "inverted_torus", "handle", "thick patch", "thick ring", "thick cylinder", "thick cone", "thick part of a torus")
# Chord error 1e-3 of the size: what is cut off a solid.
VOLUME_LIMIT = 0.03


@pytest.fixture(scope="module")
def truck():
    """Runs truck on a file: one entry per shell."""
    target = program_path().parent.parent / "truck"
    manifest = ROOT / "tests" / "foreign" / "truck" / "Cargo.toml"
    command = ["cargo", "build", "--quiet", "--locked", "--manifest-path", manifest, "--target-dir", target]
    subprocess.run(command, check=True)

    def run(path):
        done = subprocess.run([target / "debug" / "cyclide-truck", path], capture_output=True, text=True, check=True)
        return [json.loads(line) for line in done.stdout.splitlines()]

    return run


@pytest.mark.parametrize("edges", EDGES)
@pytest.mark.parametrize("name", NAMES)
def test_solids_are_closed(name, edges, program, truck, tmp_path):
    source, path = tmp_path / "model.json", tmp_path / "model.step"
    source.write_text(json.dumps(SOLIDS[name]))
    report = json.loads(program("build", source, "-o", path, "--step-faces", "split", "--json", "--step-edges", edges))
    shells = truck(path)
    assert [shell["topology"] for shell in shells] == ["Closed"] * len(shells)
    assert all(shell["meshed"] == shell["faces"] for shell in shells)
    # Of the rational handle truck's mesher samples some edges differently from either side.
    assert all(shell["mesh"] == "Closed" for shell in shells) or (name, edges) == ("handle", "rational")
    # Of a hollow solid the first shell is the outer one.
    volumes = sorted((abs(shell["volume"]) for shell in shells), reverse=True)
    assert volumes[0] - sum(volumes[1:]) == pytest.approx(total(report, "volume"), rel=VOLUME_LIMIT)


def test_any_name_can_be_read(program, truck, tmp_path):
    """A quote in a name, which the standard doubles, ends the text for this reader."""
    source, path = tmp_path / "model.json", tmp_path / "model.step"
    ring = {"type": "cyclide", "a": 50, "c": 20, "mu": 32}
    source.write_text(json.dumps(document({"it's a \"ring\" \\ 5°, #1; ''": ring, "円": {**ring, "center": [200, 0, 0]}})))
    program("build", source, "-o", path, "--step-faces", "split")
    assert [shell["topology"] for shell in truck(path)] == ["Closed"] * 2
