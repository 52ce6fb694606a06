"""Whether two builds of the program write the same files.

    python3 scripts/same_bytes.py BEFORE AFTER [DOCUMENT ...]

Builds every document (default: those of `examples/` and what `cyclide new` prints) with both programs into every format,
with each option of a format, and compares files, reports, messages and exit codes byte by byte. For changes that are to
move walls only: run it with the program of the commit before. Prints what differs, and ends with 1 if anything does.
"""

import concurrent.futures
import os
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FORMATS = {
    "step": [[], ["--step-edges", "rational"], ["--step-products", "one"]],
    "dxf": [[], ["--dxf-splines"], ["--dxf-version", "r12"]],
    "svg": [[]],
    "csv": [[]],
    "json": [[]],
    "png": [[]],
    "glb": [[], ["--glb-edges"]],
    "obj": [[]],
    "stl": [[]],
    "ply": [[]],
    "3mf": [[]],
    "vtu": [[], ["--vtu-encoding", "base64"], ["--vtu-cells", "linear"]],
    "mesh": [[]],
    "xml": [[]],
}


def built(program, arguments, folder):
    """Exit code, output, messages and the file of one call, with nothing of the folder's name in them."""
    folder.mkdir()
    result = subprocess.run([program, *arguments], cwd=folder, capture_output=True, check=False)
    files = {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
    return result.returncode, result.stdout, result.stderr, files


def starters(program, folder):
    """The documents that `cyclide new` prints."""
    listed = subprocess.run([program, "new"], capture_output=True, text=True, check=True).stdout
    for line in listed.splitlines():
        # A type and what it is, under a heading.
        if line.startswith("  "):
            name = line.split()[0]
            path = folder / f"new-{name}.json"
            path.write_bytes(subprocess.run([program, "new", name], capture_output=True, check=True).stdout)
            yield path


def difference(before, after):
    """What two results differ in, `None` if in nothing."""
    names = ["exit code", "report", "messages"]
    parts = [name for name, a, b in zip(names, before, after) if a != b]
    for name in sorted(before[3].keys() | after[3].keys()):
        a, b = before[3].get(name), after[3].get(name)
        if a != b:
            at = next((i for i, (x, y) in enumerate(zip(a or b"", b or b"")) if x != y), min(len(a or b""), len(b or b"")))
            parts.append(f"{name} ({len(a or b'')} and {len(b or b'')} bytes, from byte {at})")
    return ", ".join(parts) or None


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    programs = [str(Path(name).resolve()) for name in sys.argv[1:3]]
    with tempfile.TemporaryDirectory() as name:
        scratch = Path(name)
        documents = [Path(name).resolve() for name in sys.argv[3:]]
        documents = documents or sorted((ROOT / "examples").glob("*.json")) + list(starters(programs[0], scratch))
        cases = [(document, suffix, options) for document in documents for suffix in FORMATS for options in FORMATS[suffix]]

        def compared(job):
            index, (document, suffix, options) = job
            arguments = ["build", str(document), "-o", f"out.{suffix}", "--json", *options]
            results = [built(program, arguments, scratch / f"{index}-{k}") for k, program in enumerate(programs)]
            return difference(*results), results[0]

        differences = written = 0
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for (document, suffix, options), (found, result) in zip(cases, pool.map(compared, enumerate(cases))):
                written += result[0] == 0
                if found:
                    differences += 1
                    print(f"{document.name} to {suffix} {' '.join(options)}: {found}")
    print(f"{len(cases)} calls, {written} files written before, {differences} differences")
    sys.exit(differences > 0)


if __name__ == "__main__":
    main()
