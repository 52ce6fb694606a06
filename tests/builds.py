"""Builds that no other check has, by `cargo check`: each feature of a crate alone, the fuzz targets, and the build for
browsers where its standard library is installed. Ends with the line `N passed, M failed`; what cannot be built here is named as skipped.
With `--kernel` the features of the kernel alone (a minute on two cores). No part of `./test.sh`, which has no time left for it.

The oldest Rust that serves is checked without it: clippy knows since when each function of the standard library exists
(`incompatible_msrv` follows `rust-version`), and `tests/dependencies.py` asks the dependencies.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WASM = "wasm32-unknown-unknown"
# The libraries, each with every feature alone; `cyclide-io` without any is linted by a step of its own.
CRATES = ["cyclide", "cyclide-grids", "cyclide-io"]


def packages():
    """The packages of the workspace by name, and where cargo puts what it builds."""
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--locked"]
    found = json.loads(subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE).stdout)
    return {package["name"]: package for package in found["packages"]}, found["target_directory"]


def has_wasm():
    """True if this toolchain can build for browsers."""
    command = ["rustc", "--print", "target-libdir", "--target", WASM]
    found = subprocess.run(command, stdout=subprocess.PIPE, text=True)
    return found.returncode == 0 and Path(found.stdout.strip()).is_dir()


def checks(*arguments, **environment):
    """True if it builds without a warning."""
    command = ["cargo", "check", "--quiet", "--locked", *arguments]
    return subprocess.run(command, cwd=ROOT, env=dict(os.environ, **environment)).returncode == 0


def main():
    members, target = packages()
    builds = []
    for crate in CRATES[:1] if "--kernel" in sys.argv else CRATES:
        alone = ["--package", crate, "--no-default-features"]
        if crate != "cyclide-io":
            builds.append((f"{crate} without features", alone))
        for feature in sorted(set(members[crate]["features"]) - {"default"}):
            builds.append((f"{crate} with {feature} alone", [*alone, "--features", feature]))
    if "--kernel" not in sys.argv:
        builds.append(("fuzz targets", ["--manifest-path", "fuzz/Cargo.toml", "--target-dir", target, "--bins"]))
        if has_wasm():
            builds.append((f"cyclide-io for {WASM}", ["--package", "cyclide-io", "--no-default-features", "--target", WASM]))
        else:
            print(f"skipped: the build for browsers (rustup target add {WASM})")
    failed = 0
    for name, arguments in builds:
        # The library of the fuzzer is C++, and nothing is linked here.
        ok = checks(*arguments, CUSTOM_LIBFUZZER_PATH=os.devnull)
        failed += not ok
        print(f"{name}: {'ok' if ok else 'FAILED'}", flush=True)
    print(f"{len(builds) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
