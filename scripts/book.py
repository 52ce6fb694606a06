"""Checks the book (docs/ and README.md), runs its commands, and builds it where mdbook is installed.

    python3 scripts/book.py                      links, SUMMARY.md, length of lines, size of the README; then mdbook
    python3 scripts/book.py --run CYCLIDE [PAGE…]    runs the commands of the pages with this program
    python3 scripts/book.py --write CYCLIDE [PAGE…]  the same, and writes what they print into the pages

Commands are the lines `$ cyclide …` (and the TOOLS below) of blocks marked `console`, and `cyclide …` of blocks marked `sh`. Those of a page run one
after the other in a temporary folder with a copy of `examples`; a block marked `json file=NAME` (or `csv`, …) is written there
first. What stands below a command of a `console` block must be what it prints: a line of `…` stands for any lines, a line that
ends in `…` for all that begin so. Figures that are rounding (below 1e-7) and sizes of files are not compared. Commands must
succeed; those of a block marked `console fails` must not.
"""

import argparse
import difflib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import textwrap
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DOCS = ROOT / "docs"
sys.path.insert(0, str(ROOT / "tests"))

import citations  # noqa: E402  (the one place that looks links up)

README_BYTES = 6000
LINE = 160
# Pages that people read from top to bottom; of the others rows of tables and formulas may be longer.
SHORT_LINES = ["README.md", "docs/README.md", "docs/SUMMARY.md", "docs/files.md", "docs/formats.md", "docs/schedule.md", "docs/guide/*.md", "docs/kinds/*.md"]
WITH_COMMANDS = SHORT_LINES
OTHER_PAGES = ["*.md", "docs/*.md", "docs/math/*.md"]
# What pages may run beside the program itself.
TOOLS = {"cyclide", "grep", "head", "sed"}
# It has a test of its own (crates/cyclide-cli/tests), and takes a minute.
ELSEWHERE = re.compile(r"cyclide gallery\b")
# Fewer commands than this are a fault of this program.
AT_LEAST = 30

FENCE = re.compile(r"^```([^\n`]*)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
ROUNDING = re.compile(r"\b\d(?:\.\d+)?e-(?:0?[89]|[1-9]\d+)\b")
SIZE = re.compile(r"\s*\b\d+(?:\.\d+)? (?:bytes|kB|MB)$")


def pages_of(patterns):
    """The pages of these patterns, as paths relative to the root."""
    return sorted({path.relative_to(ROOT) for pattern in patterns for path in ROOT.glob(pattern)})


def broken_links():
    """Links and anchors of the book that lead nowhere, by the check of all citations; and how many were looked up."""
    places = citations.Places(citations.tracked())
    faults, looked = [], 0
    for path in pages_of(["README.md", "docs/**/*.md"]):
        found, count = citations.faults_of(path, (ROOT / path).read_text(encoding="utf-8"), places)
        faults, looked = faults + found, looked + count
    return faults, looked


def missing_chapters():
    """Pages that SUMMARY.md does not name, or names twice."""
    linked = citations.LINK.findall((DOCS / "SUMMARY.md").read_text(encoding="utf-8"))
    pages = [str(path.relative_to(DOCS)) for path in DOCS.rglob("*.md") if path.name != "SUMMARY.md"]
    faults = [f"docs/SUMMARY.md: {page} is named {linked.count(page)} times" for page in pages if linked.count(page) != 1]
    return faults + [f"docs/SUMMARY.md: {page} is no page of docs" for page in linked if page not in pages]


def long_lines():
    """Lines that are too long to read in a terminal, and a README that is too long to read at all."""
    faults, short = [], pages_of(SHORT_LINES)
    for path in sorted({*short, *pages_of(OTHER_PAGES)}):
        in_formula = False
        for n, line in enumerate((ROOT / path).read_text(encoding="utf-8").splitlines(), 1):
            is_free = path not in short and (in_formula or "$$" in line or line.startswith("|"))
            in_formula ^= line.count("$$") % 2 == 1 or line.startswith("```")
            if len(line) > LINE and not is_free:
                faults.append(f"{path}:{n}: {len(line)} characters, limit {LINE}")
    size = (ROOT / "README.md").stat().st_size
    return faults + ([f"README.md: {size} bytes, limit {README_BYTES}"] if size > README_BYTES else [])


def check():
    """All that needs no program. True if nothing is wrong."""
    faults, looked = broken_links()
    faults += missing_chapters() + long_lines()
    print("\n".join(faults) or f"{looked} links of the book lead somewhere, every page is in SUMMARY.md")
    return not faults and looked > 0


def staged(stage):
    """Lays the pages out for mdbook: README.md and docs beside what they link to, so that all links hold in the built book too."""
    tracked = citations.tracked()
    pages = [path for path in tracked if path.suffix == ".md" and (path.parts[0] == "docs" or len(path.parts) == 1)]
    linked = {citations.from_here(page, link) for page in pages for link in citations.LINK.findall((ROOT / page).read_text("utf-8"))}
    linked = {Path(link.partition("#")[0]) for link in linked if link}
    for path in tracked:
        if path in pages or path.parts[0] == "docs" or any(path == link or link in path.parents for link in linked):
            (stage / path).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / path, stage / path)
    chapters = (DOCS / "SUMMARY.md").read_text(encoding="utf-8")
    chapters = "# Summary\n\n[cyclide](README.md)\n\n" + citations.LINK.sub(r"](docs/\1)", chapters.partition("\n")[2])
    chapters = chapters.replace("\n[The book](docs/README.md)\n", "\n# The book\n\n- [What it holds](docs/README.md)\n")
    project = [page.name for page in pages if len(page.parts) == 1 and page.name != "README.md"]
    chapters += "\n# The project\n\n" + "".join(f"- [{name[:-3].capitalize()}]({name})\n" for name in sorted(project))
    (stage / "docs" / "SUMMARY.md").unlink()
    (stage / "SUMMARY.md").write_text(chapters, encoding="utf-8")
    # mdbook makes index.html of README.md, and leaves links to it as they are.
    for page in stage.rglob("*.md"):
        text = page.read_text(encoding="utf-8")
        if page.name != "SUMMARY.md":
            page.write_text(citations.LINK.sub(lambda link: link.group(0).replace("README.md", "index.md"), text), encoding="utf-8")


def broken_pages(book):
    """Links of the built book that lead to no file."""
    faults = []
    for page in book.rglob("*.html"):
        for link in re.findall(r'(?:href|src)="([^"#:]+)(?:#[^"]*)?"', page.read_text(encoding="utf-8")):
            if page.name != "print.html" and not (page.parent / link).exists():
                faults.append(f"{page.relative_to(book)}: {link} leads nowhere")
    return faults


def build():
    """The book as HTML, if mdbook is installed. True unless it fails."""
    program = shutil.which("mdbook")
    if program is None:
        print("mdbook is not installed: the book is not built")
        return True
    target = ROOT / "target" / "book"
    with tempfile.TemporaryDirectory() as folder:
        staged(Path(folder) / "docs")
        shutil.copyfile(ROOT / "book.toml", Path(folder) / "book.toml")
        done = subprocess.run([program, "build", "--dest-dir", str(target), folder], capture_output=True, text=True)
    faults = [line for line in done.stderr.splitlines() if done.returncode or re.search(r"\b(WARN|ERROR)\b", line)]
    faults += broken_pages(target)
    print("\n".join(faults) or f"the book is {target.relative_to(ROOT)}/index.html")
    return done.returncode == 0 and not faults


class Block:
    """A block of a page: its words, its lines, and where in the text they are."""

    def __init__(self, found):
        self.words = found.group(1).split()
        self.kind = self.words[0] if self.words else ""
        self.fails = "fails" in self.words
        self.file = next((word[5:] for word in self.words if word.startswith("file=")), None)
        self.body, self.start = found.group(2), found.start(2)

    def commands(self):
        """Pairs of a command and the lines that stand below it; of blocks `sh` there are none of these (`None`)."""
        found = []
        for line in re.sub(r"\\\n\s*", "", self.body).splitlines():
            if self.kind == "sh" and line.startswith("cyclide "):
                found.append((line, None))
            elif self.kind == "console" and line.startswith("$ "):
                found.append((line[2:], []))
            elif self.kind == "console" and found:
                found[-1][1].append(line)
        return found


def runs(command):
    """True for a command that is run here."""
    return command.split()[0] in TOOLS and not ELSEWHERE.match(command)


def plain(line):
    """A line without what differs from machine to machine."""
    return " ".join(SIZE.sub("", ROUNDING.sub("0", line)).split())


def same(shown, printed):
    """True if a line of a page is the line that was printed."""
    if shown.endswith("…"):
        return plain(printed).startswith(plain(shown[:-1].rstrip()))
    return plain(shown) == plain(printed)


def begins(shown, printed):
    """True if a printed line begins as this line of a page does."""
    return plain(printed).startswith(plain(shown.rstrip("…")))


def differs(shown, printed):
    """The first line of a page that was not printed so, or `None`."""
    at, anywhere, rest = 0, False, list(shown)
    while rest:
        line = rest.pop(0)
        if line.strip() == "…":
            anywhere = True
            continue
        if anywhere:
            at = next((k for k in range(at, len(printed)) if begins(line, printed[k])), len(printed))
        if at == len(printed):
            return line
        while not same(line, printed[at]) and begins(line, printed[at]) and rest:
            line += " " + rest.pop(0)  # a line of the program that is broken on the page
        if not same(line, printed[at]):
            return line
        at, anywhere = at + 1, False
    return None if anywhere or at == len(printed) else "(the end)"


def renewed(shown, printed):
    """The lines of a page as they are printed now: the same ones, where some are left out."""
    kept = list(printed)
    if any(line.strip() == "…" for line in shown):
        # Without the rests of lines that are broken on the page.
        starts = [line for n, line in enumerate(shown) if n == 0 or len(shown[n - 1]) < 100 or not re.match(r" {4}\S", line)]
        kept, at = [], 0
        for line in starts:
            if line.strip() != "…":
                likeness = [begins(line, other) or difflib.SequenceMatcher(None, line, other).ratio() for other in printed[at:]]
                if not likeness or max(likeness) < 0.4:
                    continue
                best = likeness.index(max(likeness))
                line, at = printed[at + best], at + best + 1
            if not (line.strip() == "…" and kept and kept[-1].strip() == "…"):
                kept.append(line)
    return [part for line in kept for part in broken(line)]


def broken(line):
    """A printed line as it is set on a page."""
    if len(line) <= LINE:
        return [line]
    return textwrap.wrap(line, 140, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False, drop_whitespace=True)


def run_page(path, program, write):
    """Runs the commands of a page; gives their number and what is wrong with them."""
    text = (ROOT / path).read_text(encoding="utf-8")
    faults, count, changes = [], 0, []
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "bin").mkdir()
        (Path(folder) / "bin" / "cyclide").symlink_to(program)
        work = Path(folder) / "work"
        shutil.copytree(ROOT / "examples", work / "examples")
        (work / "out").mkdir()
        environment = dict(os.environ, PATH=f"{folder}/bin{os.pathsep}{os.environ['PATH']}", LC_ALL="C.UTF-8")
        for block in map(Block, FENCE.finditer(text)):
            if block.file:
                (work / block.file).write_text(block.body, encoding="utf-8")
            new = []
            for command, shown in block.commands():
                new.append(f"$ {command}")
                if not runs(command):
                    new += shown or []
                    continue
                done = subprocess.run(
                    ["bash", "-c", command], cwd=work, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                    stderr=subprocess.STDOUT, text=True, errors="replace",
                )  # fmt: skip
                count += 1
                printed = done.stdout.splitlines()
                if bool(done.returncode) != block.fails:
                    faults.append(f"{path}: {command}\n  exit code {done.returncode}: {done.stdout}")
                elif shown is not None and (line := differs([s for s in shown if s.strip()], [p for p in printed if p.strip()])):
                    faults.append(f"{path}: {command}\n  not printed: {line}")
                    shown = renewed(shown, printed) if write else shown
                new += shown or []
            if block.kind == "console" and write:
                if "\\\n" in block.body:
                    continue
                changes.append((block, "\n".join(new) + "\n"))
    for block, new in reversed(changes):
        text = text[: block.start] + new + text[block.start + len(block.body) :]
    if write:
        (ROOT / path).write_text(text, encoding="utf-8")
    return count, faults


def run(program, pages, write):
    """Runs the commands of the pages, a few pages at a time. True if all did what the pages say."""
    paths = [Path(page) for page in pages] or pages_of(WITH_COMMANDS)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        results = list(pool.map(lambda path: run_page(path, Path(program).resolve(), write), paths))
    count, faults = sum(n for n, _ in results), [fault for _, found in results for fault in found]
    if faults:
        print("\n".join(faults))
    if count < AT_LEAST and not pages:
        faults.append(f"only {count} commands were found")
    print(f"{count - len(faults)} passed, {len(faults)} failed")
    return not faults


def check_itself():
    """The comparison must find what differs."""
    printed = ["a  1e-15 m  26 kB", "b 2", "c 3", "d 4"]
    for shown, fault in [
        (["a 2.3e-14 m 27 kB", "b 2", "c 3", "d 4"], None),
        (["…", "c 3", "…"], None),
        (["a 1e-15 m", "b…", "…", "d 4"], None),
        (["…", "c 4", "…"], "c 4"),
        (["…", "c 3"], "(the end)"),
        (["b 2", "…"], "b 2"),
        (["a 1e-15", "m", "…"], None),
    ]:
        if differs(shown, printed) != fault:
            raise AssertionError(f"{shown}: {differs(shown, printed)}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--run", metavar="CYCLIDE", help="run the commands of the pages with this program")
    parser.add_argument("--write", metavar="CYCLIDE", help="run them and write what they print into the pages")
    parser.add_argument("pages", nargs="*", metavar="PAGE")
    asked = parser.parse_args()
    check_itself()
    if program := asked.run or asked.write:
        return 0 if run(program, asked.pages, bool(asked.write)) else 1
    return 0 if check() and build() else 1


if __name__ == "__main__":
    sys.exit(main())
