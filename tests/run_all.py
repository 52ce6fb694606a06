"""Runs every check of the project, in order, and ends with the line `N passed, M failed`.

Called by test.sh, which has done the set-up. Nothing is skipped when a tool or reader is missing: that step fails.
Whatever a test framework reports as skipped or ignored is listed and counted before the last line.
"""

import glob
import json
import os
import re
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


class Outcome:
    """Counts of one step, and the names of what did not run."""

    def __init__(self, passed=0, failed=0, skipped=()):
        self.passed, self.failed, self.skipped = passed, failed, list(skipped)


def one(_lines, ok):
    """A step that is a single check."""
    return Outcome(int(ok), int(not ok))


def from_cargo_test(lines, _ok):
    """Sum over the `test result:` lines of all test binaries."""
    out = Outcome()
    for line in lines:
        if match := re.match(r"test result: .* (\d+) passed; (\d+) failed; (\d+) ignored", line):
            out.passed += int(match[1])
            out.failed += int(match[2])
        elif match := re.match(r"test (.*) \.\.\. ignored", line):
            out.skipped.append(match[1])
    return out


def from_last_line(lines, _ok):
    """A closing line `N passed, M failed`; before it every skip is named by a line of its own."""
    counts = [m for line in lines if (m := re.fullmatch(r"(\d+) passed, (\d+) failed", line.strip()))]
    skipped = [line.removeprefix("skipped: ") for line in lines if line.startswith("skipped: ")]
    return Outcome(int(counts[-1][1]), int(counts[-1][2]), skipped) if counts else Outcome()


def from_pytest(lines, _ok):
    """The summary line of pytest; every skip is named by a line of its own (option -rs)."""
    summary = next((line for line in reversed(lines) if re.search(r"\d+ (passed|failed|error|skipped)", line)), "")

    def count(word):
        match = re.search(rf"(\d+) {word}", summary)
        return int(match[1]) if match else 0

    skipped = [line.strip() for line in lines if line.startswith(("SKIPPED", "XFAIL", "XPASS"))]
    return Outcome(count("passed"), count("failed") + count("error"), skipped)


def target_folder():
    """Where cargo puts what it builds."""
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"]
    found = subprocess.run(command, cwd=ROOT, check=True, capture_output=True).stdout
    return Path(json.loads(found)["target_directory"])


PYTHON = sys.executable
# As `cargo xtask`, but of the profile and the features of the tests: so no dependency is built twice.
XTASK = target_folder() / "debug" / "xtask"
STEPS = [
    ("format", ["cargo", "fmt", "--all", "--check"], one),
    ("lints", ["cargo", "clippy", "--workspace", "--all-targets", "--locked", "--", "-D", "warnings"], one),
    ("text and bytes only", ["cargo", "clippy", "--package", "cyclide-io", "--no-default-features", "--all-targets", "--locked", "--", "-D", "warnings"], one),
    ("documentation", ["cargo", "doc", "--workspace", "--no-deps", "--locked"], one),
    ("public API", [PYTHON, "tests/public_api.py"], one),
    ("spelling", [Path(PYTHON).parent / "typos", "--format", "brief"], one),
    ("program", ["cargo", "build", "--profile", "test", "--workspace", "--bins", "--locked"], one),
    ("layers", [XTASK, "layers"], one),
    ("packages", [PYTHON, "tests/packages.py"], one),
    ("dependencies", [PYTHON, "tests/dependencies.py"], one),
    ("citations", [PYTHON, "tests/citations.py"], one),
    ("book", [PYTHON, "scripts/book.py"], one),
    ("its commands", [PYTHON, "scripts/book.py", "--run", target_folder() / "debug" / "cyclide"], from_last_line),
    ("Rust tests", ["cargo", "test", "--workspace", "--locked", "--no-fail-fast"], from_cargo_test),
    ("reference cases", [XTASK, "reference", *sorted(glob.glob("crates/cyclide/tests/reference/*.json", root_dir=ROOT))], from_last_line),
    ("foreign readers", [PYTHON, "-m", "pytest", "tests/foreign", "-q", "-rsxX", "-p", "no:cacheprovider", "-n", "auto", "--dist", "worksteal"], from_pytest),
]


def run(command):
    """Runs a command, shows its output as it comes and returns its lines and exit status."""
    environment = dict(os.environ, RUSTDOCFLAGS="-D warnings", CARGO_TERM_COLOR="never")
    lines = []
    try:
        process = subprocess.Popen(
            command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace"
        )
    except OSError as error:
        print(error)
        return [str(error)], False
    with process:
        for line in process.stdout:
            print(line, end="", flush=True)
            lines.append(line.rstrip("\n"))
    return lines, process.returncode == 0


def main():
    table, passed, failed, skipped = [], 0, 0, []
    for name, command, count in STEPS:
        print(f"\n== {name}: {' '.join(str(c) for c in command)}", flush=True)
        start = time.monotonic()
        lines, ok = run(command)
        outcome = count(lines, ok)
        if not ok and outcome.failed == 0 or ok and outcome.passed == 0:
            outcome.failed += 1  # it broke off, or it checked nothing at all
        table.append((name, outcome, time.monotonic() - start))
        passed, failed, skipped = passed + outcome.passed, failed + outcome.failed, skipped + outcome.skipped

    print("\n== summary")
    for name, outcome, seconds in table:
        print(f"{name:16} {outcome.passed:5} passed {outcome.failed:4} failed {len(outcome.skipped):4} skipped {seconds:8.1f} s")
    for name in skipped:
        print(f"skipped: {name}")
    print(f"{len(skipped)} skipped")
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
