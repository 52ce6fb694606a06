"""Every place of the documentation that the sources and documents lead to exists, and every public type has an example.

Comments cite `docs/math/PAGE.md#heading`, documents link to each other; the pages of `docs/math` name files, functions and
tests. All of these are looked up. Marks of derivations that have no page here lead nowhere and are faults too.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

SOURCES = {".rs", ".py", ".toml", ".sh", ".md", ".json"}
# Comments and documents cite pages from the root; documents link relative to themselves.
CITATION = re.compile(r"\bdocs/[\w/-]+\.md(?:#[^\s`)\]>'\",;]*)?")
LINK = re.compile(r"\]\(([^)\s]*)\)")
NOWHERE = re.compile(r"`(?:10|20|30|40|50|60|65|66|70)`(?:,? (?:sections?|part|limit)\b|, \(| \d|, [A-D]\d?\b)")
CODE_FILE = re.compile(r"`([\w./-]+\.(?:rs|py))`")
CODE_NAME = re.compile(r"`(?:[A-Z]\w*)::(\w+)`")
FENCE = re.compile(r"^(```|~~~).*?^\1\s*$", re.DOTALL | re.MULTILINE)


def tracked():
    """The text files of the repository, as paths relative to its root."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listing = subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True).stdout
    return [Path(name) for name in listing.splitlines() if (ROOT / name).is_file()]


def anchors(text):
    """The anchors of a document's headings, as GitHub makes them."""
    found, seen = set(), {}
    for heading in re.findall(r"^#+\s+(.*?)\s*$", FENCE.sub("", text), re.MULTILINE):
        plain = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading)
        slug = re.sub(r"[^\w\- ]", "", plain.lower()).replace(" ", "-")
        count = seen.get(slug, 0)
        seen[slug] = count + 1
        found.add(f"{slug}-{count}" if count else slug)
    return found


class Places:
    """What can be cited."""

    def __init__(self, files):
        self.files = {str(path) for path in files}
        self.folders = {str(parent) for path in files for parent in path.parents}
        code = [path for path in files if path.suffix in {".rs", ".py"}]
        self.code_files = [str(path) for path in code]
        self.names = set()
        for path in code:
            self.names.update(re.findall(r"\w+", (ROOT / path).read_text(encoding="utf-8")))
        self.anchors = {}

    def has(self, target):
        """True if `path` or `path#anchor`, from the root, exists."""
        path, _, anchor = target.partition("#")
        if path not in self.files:
            return not anchor and path.rstrip("/") in self.folders
        if not anchor:
            return True
        if path not in self.anchors:
            self.anchors[path] = anchors((ROOT / path).read_text(encoding="utf-8"))
        return anchor in self.anchors[path]

    def has_code_file(self, name):
        """True if a source file ends with these folders and this name, wherever its room is."""
        return any(file == name or file.endswith("/" + name) for file in self.code_files)


def from_here(path, target):
    """A link relative to a document as a path from the root; `None` for links to other places."""
    if re.match(r"[a-z][a-z0-9+.-]*:", target) or not target:
        return None
    name, _, anchor = target.partition("#")
    place = path if not name else Path(*normal(path.parent / name))
    return f"{place}#{anchor}" if anchor else str(place)


def normal(path):
    """The parts of a path without `..`."""
    parts = []
    for part in path.parts:
        if part == ".." and parts:
            parts.pop()
        elif part != "..":
            parts.append(part)
    return parts or ["."]


def faults_of(path, text, places):
    """What in a file leads nowhere, as sentences; and how much was looked up."""
    faults, looked = [], 0

    def look(found, exists):
        nonlocal looked
        looked += 1
        if not exists:
            line = text.count("\n", 0, found.start()) + 1
            faults.append(f"{path}:{line}: {found.group(0).strip('](')} leads nowhere")

    for found in CITATION.finditer(text):
        target = found.group(0).rstrip(".")
        look(found, places.has(target))
    for found in NOWHERE.finditer(text):
        look(found, False)
    if path.suffix == ".md":
        shown = FENCE.sub(lambda block: "\n" * block.group(0).count("\n"), text)
        for found in LINK.finditer(shown):
            target = from_here(path, found.group(1))
            if target is not None:
                look(found, places.has(target))
    if path.parent == Path("docs/math"):
        for found in CODE_FILE.finditer(text):
            look(found, places.has_code_file(found.group(1)))
        for found in CODE_NAME.finditer(text):
            look(found, found.group(1) in places.names)
    return faults, looked


def check_itself(places):
    """The check must find what is wrong: it is shown a text of which each line but the last leads nowhere."""
    wrong = [
        "(`docs/math/arcs.md#no-such-heading`)",
        "(`docs/math/no-such-page.md`)",
        "(`" + "50`, section 2, (B))",
        "[a link](no-such-page.md)",
        "[a link](arcs.md#no-such-heading)",
        "`no/such/file.rs`",
        "`Arc::no" + "_such_function`",
    ]
    faults, _ = faults_of(Path("docs/math/sample.md"), "\n".join([*wrong, "[arcs](arcs.md)"]), places)
    lines = {int(fault.split(":")[1]) for fault in faults}
    if lines != set(range(1, len(wrong) + 1)):
        raise AssertionError(f"faults found in lines {sorted(lines)} of {len(wrong)} wrong ones: {faults}")
    shown = "/// Shown.\n///\n/// ```\n/// ```\n#[derive(\n    Debug\n)]\npub struct A;\n\n/// Not shown.\npub enum B {\n}\n"
    if without_example("sample.rs", shown, {"A", "B"}) != ["sample.rs:11: `B` has no example"]:
        raise AssertionError("a type without an example is not found")


# The crates, and how many public names they have at least.
CRATES = {"cyclide": 300, "cyclide-grids": 20, "cyclide-io": 150}


def not_in_index(module, names):
    """Names of a public module that its index by topic lacks, if it has one."""
    text = (ROOT / module).read_text(encoding="utf-8")
    index = text.partition("//! | topic |")[2].partition("\nmod ")[0]
    listed = set(re.findall(r"`(\w+)", index))
    return [f"{module}: `{name}` is not in the index by topic" for name in sorted(names - listed) if index]


# In a table of a macro, too.
NOUN = re.compile(r" *pub (?:struct|enum|trait|type) (\w+)")


def public_names(crate, at_least):
    """The public names of a crate by the file of their module, from the list that `tests/public_api.py` holds against the documentation."""
    text = (ROOT / "docs/api" / f"{crate.replace('-', '_')}.txt").read_text(encoding="utf-8")
    source, modules = Path("crates") / crate / "src", {}
    for module, name in re.findall(r"^\w+ ((?:\w+::)*)(\w+):", text, re.MULTILINE):
        folder = source / module.replace("::", "/")
        files = [source / "lib.rs"] if not module else [folder / "mod.rs", folder.with_suffix(".rs")]
        file = next((file for file in files if (ROOT / file).is_file()), None)
        modules.setdefault(file, set()).add(name)
    if sum(map(len, modules.values())) < at_least:
        raise AssertionError(f"the public names of {crate} were not found: {sorted(map(str, modules))}")
    return modules


def without_example(path, text, names):
    """Public types and traits in a source file whose documentation has no example."""
    lines, faults = text.splitlines(), []
    for number, line in enumerate(lines):
        noun = NOUN.match(line)
        if noun is None or noun.group(1) not in names:
            continue
        above = number
        # Comments and attributes, of several lines too: up to the last line that ends an item, or to a blank one.
        while above > 0 and lines[above - 1].strip() and lines[above - 1].rstrip() != "}":
            above -= 1
        if not any(line.lstrip().startswith("/// ```") for line in lines[above:number]):
            faults.append(f"{path}:{number + 1}: `{noun.group(1)}` has no example")
    return faults


def main():
    files = [path for path in tracked() if path.suffix in SOURCES]
    places = Places(tracked())
    check_itself(places)
    faults, looked, pages = [], 0, set()
    for path in files:
        if path == Path("tests/citations.py"):
            continue
        text = (ROOT / path).read_text(encoding="utf-8")
        found, count = faults_of(path, text, places)
        faults, looked = faults + found, looked + count
        if path.suffix in {".rs", ".py"}:
            pages.update(found.group(0).partition("#")[0] for found in CITATION.finditer(text))
    index = (ROOT / "docs/math/README.md").read_text(encoding="utf-8")
    for page in sorted((ROOT / "docs/math").glob("*.md")):
        if page.name != "README.md" and f"({page.name})" not in index:
            faults.append(f"docs/math/{page.name} is not in the index")
    for crate, at_least in CRATES.items():
        modules = public_names(crate, at_least)
        for module, names in modules.items():
            faults += not_in_index(module, names) if module else []
        names = set().union(*modules.values())
        for path in (path for path in files if path.suffix == ".rs" and path.is_relative_to(Path("crates") / crate / "src")):
            faults += without_example(path, (ROOT / path).read_text(encoding="utf-8"), names)
    print("\n".join(faults) or f"{looked} citations and links lead somewhere; sources cite {len(pages)} pages")
    return 1 if faults or not looked else 0


if __name__ == "__main__":
    sys.exit(main())
