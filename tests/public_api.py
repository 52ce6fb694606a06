"""The public API of each published library is the one in `docs/api`: a change of it is seen, and meant.

`cargo doc` knows every public item; its pages are read for declarations and the signatures of methods, without trait implementations.
`python3 tests/public_api.py --write` sets the lists to what there is now.
"""

import difflib
import html
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LISTS = ROOT / "docs" / "api"
CRATES = ["cyclide", "cyclide_grids", "cyclide_io"]
ITEM = re.compile(r'<a href="((?:[\w]+/)*(?:struct|enum|trait|fn|constant|type|macro|union)\.\w+\.html)">([^<]+)</a>')
DECLARATION = re.compile(r'<pre class="rust item-decl"><code>(.*?)</code></pre>', re.S)
METHOD = re.compile(r'<section id="(?:ty)?(?:method|associatedconstant|tymethod)\.[^"]*"[^>]*>.*?<h4 class="code-header">(.*?)</h4>', re.S)
# What comes before the methods of traits.
OTHERS = ['<h2 id="trait-implementations"', '<h2 id="implementors"', '<h2 id="foreign-impls"']
DERIVED = re.compile(r"#\[(?:automatically_derived|must_use[^\]]*)\]")


def text(of):
    """HTML as one line of text."""
    plain = html.unescape(re.sub(r"<[^>]+>", "", of))
    # Long lists of fields are folded away, and where a signature breaks depends on its length.
    plain = DERIVED.sub("", re.sub(r"(?:Show|Hide) \d+ (?:fields?|variants?)", "", plain))
    return re.sub(r"\s+", " ", plain).replace("( ", "(").replace(", )", ")").strip()


def api(folder):
    """Lines of a crate: each item with its declaration, and below it its methods."""
    lines = []
    for page, name in sorted(ITEM.findall((folder / "all.html").read_text(encoding="utf-8"))):
        source = (folder / page).read_text(encoding="utf-8")
        own = source
        for mark in OTHERS:
            own = own.partition(mark)[0]
        kind = page.rpartition("/")[2].partition(".")[0]
        declared = DECLARATION.search(source)
        lines.append(f"{kind} {name}: {text(declared[1]) if declared else ''}")
        lines += sorted({f"    {text(method)}" for method in METHOD.findall(own)})
    return lines


def docs():
    command = ["cargo", "metadata", "--format-version", "1", "--no-deps", "--offline"]
    return Path(json.loads(subprocess.run(command, cwd=ROOT, check=True, capture_output=True).stdout)["target_directory"]) / "doc"


def main():
    same = True
    for crate in CRATES:
        now = api(docs() / crate)
        file = LISTS / f"{crate}.txt"
        if "--write" in sys.argv:
            LISTS.mkdir(exist_ok=True)
            file.write_text("\n".join(now) + "\n", encoding="utf-8")
        was = file.read_text(encoding="utf-8").splitlines() if file.is_file() else []
        changes = [line for line in difflib.unified_diff(was, now, lineterm="", n=0) if not line.startswith(("---", "+++", "@@"))]
        print("\n".join(changes[:40]))
        print(f"{crate}: {len(now)} public items and methods, {len(changes)} lines differ from {file.relative_to(ROOT)}")
        same = same and not changes
    if not same:
        print("if the change is meant: cargo doc --workspace --no-deps && python3 tests/public_api.py --write")
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
