"""Each crate that is published can be: its package holds a README, both licenses and all that its sources include.

`cargo package --list` names the files of a package without building it. The licenses are copies, since a package holds no files
of the folders above it and not every system has symbolic links: they must be those of the root.
"""

import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LICENSES = ["LICENSE-MIT", "LICENSE-APACHE"]
INCLUDED = re.compile(r'include_(?:str|bytes)!\("([^"]+)"\)')
# Examples of the gallery are included by a macro, from the folder of this name.
EXAMPLE = re.compile(r'(?:example|input)!\("([^"]+)"\)')


def cargo(*arguments):
    return subprocess.run(["cargo", *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def published():
    """The packages of the workspace that are published, as cargo describes them."""
    found = json.loads(cargo("metadata", "--format-version", "1", "--no-deps", "--offline"))["packages"]
    return [package for package in found if package["publish"] != []]


def faults_of(package):
    """What is missing or wrong in one package, as sentences."""
    name, folder = package["name"], Path(package["manifest_path"]).parent
    files = set(cargo("package", "--list", "--locked", "--offline", "--allow-dirty", "--package", name).split())
    faults = [f"{name}: {file} is not in the package" for file in ["README.md", *LICENSES, "Cargo.toml"] if file not in files]
    for license in LICENSES:
        if not (folder / license).is_file() or (folder / license).read_bytes() != (ROOT / license).read_bytes():
            faults.append(f"{name}: {license} is not a copy of the one of the root")
    for field in ["description", "license", "documentation", "readme", "rust_version", "categories", "keywords"]:
        if not package[field]:
            faults.append(f"{name}: Cargo.toml has no {field}")
    if len(package["keywords"]) > 5 or any(len(word) > 20 for word in package["keywords"]):
        faults.append(f"{name}: at most five keywords of at most twenty characters are allowed")
    for file in sorted(files):
        if file.endswith(".rs") and file.startswith("src/"):
            # What is compiled for tests only may use the workspace.
            text = re.sub(r"#\[cfg\((?:all\()?(?:doctest|test)[^\n]*\n(?:#\[[^\n]*\n)+", "", (folder / file).read_text(encoding="utf-8"))
            text = text.partition("#[cfg(test)]\nmod tests {")[0]
            wanted = [(folder / file).parent / found for found in INCLUDED.findall(text)]
            wanted += [folder / "gallery" / found for found in EXAMPLE.findall(text)]
            faults += [f"{name}: {file} includes {path.name}, which is not in the package" for path in wanted if not held(path, folder, files)]
    return faults, len(files)


def held(path, folder, files):
    """True if a file beside the sources is in the package."""
    parts = []
    for part in path.relative_to(folder).parts:
        if part == "..":
            if not parts:
                return False
            parts.pop()
        else:
            parts.append(part)
    return "/".join(parts) in files


def main():
    packages = published()
    results = [faults_of(package) for package in packages]
    faults = [fault for found, _ in results for fault in found]
    counts = ", ".join(f"{package['name']} {count} files" for package, (_, count) in zip(packages, results))
    print("\n".join(faults) or f"packages hold all that they need: {counts}")
    return 1 if faults or len(packages) < 3 else 0


if __name__ == "__main__":
    sys.exit(main())
