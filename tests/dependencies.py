"""Licences and sources of every crate in Cargo.lock against the lists of deny.toml, and what can be left out, by cargo alone.

Advisories need a database from elsewhere: `cargo deny check` has it. Here it is checked only that none is ignored without a reason.
"""

import json
import re
import subprocess
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def licences(expression):
    """The licences that an SPDX expression names (`/` is the old spelling of OR)."""
    return {licence.strip() for licence in re.split(r"\bOR\b|\bAND\b|/|[()]", expression)} - {""}


def unused(rules, packages):
    """Allowed licences that no crate names: a list that grows only allows what nobody has looked at."""
    if rules["licenses"]["unused-allowed-license"] == "allow":
        return ["deny.toml: unused licences are allowed silently"]
    named = {licence for package in packages for licence in licences(package["license"] or "")}
    return [f"deny.toml: licence {licence} is allowed, and no crate has it" for licence in rules["licenses"]["allow"] if licence not in named]


def advisories(rules):
    """What is wrong with the rules about advisories."""
    rules = rules.get("advisories", {})
    faults = [] if rules.get("yanked") == "deny" else ["deny.toml: advisories: crates that were withdrawn are not refused"]
    silent = [entry for entry in rules.get("ignore", []) if not (isinstance(entry, dict) and entry.get("reason"))]
    return faults + [f"deny.toml: advisories: {entry} is ignored without a reason" for entry in silent]


def accepted(expression, allow):
    """True if the SPDX expression can be met with allowed licences (`/` is the old spelling of OR)."""
    tokens = re.findall(r"\(|\)|[^()\s]+", expression.replace("/", " OR "))
    words, i = [], 0
    while i < len(tokens):  # join `X WITH Y` to one licence name
        if i + 2 < len(tokens) and tokens[i + 1] == "WITH":
            words.append(" ".join(tokens[i : i + 3]))
            i += 3
        else:
            words.append(tokens[i])
            i += 1
    code = {"(": "(", ")": ")", "AND": " and ", "OR": " or "}
    return bool(eval("".join(code.get(w, str(w in allow)) for w in words)))  # only True, False, and, or, brackets


def version(text):
    """A version as numbers."""
    return ([int(part) for part in re.findall(r"\d+", text)] + [0, 0])[:3]


# Crates that a package can be built without.
OPTIONAL = [("cyclide", "faer"), ("cyclide-io", "tiny-skia"), ("cyclide-io", "tempfile")]


def is_needed(package, crate):
    """True if a package without its default features depends on a crate."""
    command = ["cargo", "tree", "--package", package, "--no-default-features", "--edges", "normal,build", "--prefix", "none", "--locked"]
    listing = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True).stdout
    names = [line.split()[0] for line in listing.splitlines() if line]
    assert package in names, listing
    return crate in names


def main():
    rules = tomllib.loads((ROOT / "deny.toml").read_text())
    allow, registries = set(rules["licenses"]["allow"]), set(rules["sources"]["allow-registry"])
    banned = {d["crate"] for d in rules["bans"]["deny"]}
    oldest = version(tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]["rust-version"])
    listing = subprocess.run(
        ["cargo", "metadata", "--format-version", "1", "--locked"], cwd=ROOT, check=True, stdout=subprocess.PIPE
    )
    packages = json.loads(listing.stdout)["packages"]
    faults = []
    for package in packages:
        name = f"{package['name']} {package['version']}"
        if not accepted(package["license"] or "none", allow):
            faults.append(f"{name}: licence {package['license']}")
        if package["source"] and package["source"].removeprefix("registry+") not in registries:
            faults.append(f"{name}: source {package['source']}")
        needs = package["rust_version"] or "0"
        if version(needs) > oldest:
            faults.append(f"{name}: needs Rust {needs}, and the workspace promises {'.'.join(map(str, oldest))}")
        if package["name"] in banned:
            faults.append(f"{name}: banned")
    faults += [f"{package} needs {crate} without its features" for package, crate in OPTIONAL if is_needed(package, crate)]
    faults += unused(rules, packages) + advisories(rules)
    print("\n".join(faults) or f"{len(packages)} crates: licences, sources and Rust versions as deny.toml and Cargo.toml allow")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
