#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the rows, files and headings that the repository cites exist.

    cited.py closed_forms|files|names [--root FOLDER]

closed_forms  each cited closed form (C1) and defect (D1) has a row in docs/model.md; a range "C1 ... C9" ends with the
              last closed form; each row of a closed form names its functions of include/hapticut/closed_forms; each
              cited measurement (B1a, DC4) has a source in docs/validation.md
files         each file exists that a comment or a page names by its path in the repository; each page and heading
              exists that a page links to; README.md names no engine without a folder in bindings
names         each name in backticks in docs/decisions, e.g. `Simulation::step`, stands in the code or on another page
"""
import argparse
import re
import sys
from pathlib import Path

FOLDERS = ("include", "src", "drivers", "apps", "tests", "docs", "bindings", "examples", "benchmarks")
ENDINGS = {".hpp", ".inl", ".cpp", ".h", ".py", ".md", ".txt", ".cmake", ".toml", ".sh"}

ROW = re.compile(r"^\| ([CD]\d+) \|", re.M)
# Either a word or a part of the name of a test: `C20`, `BallDepth.C1ForceIsThatOfTheCap`.
CITED = re.compile(r"(?:(?<![\w\\])|(?<=[CD]\d)|(?<=[CD]\d\d))([CD]\d{1,2})(?=[A-Z]\w*[a-z]|(?![\w.]\w))")
WHOLE_RANGE = re.compile(r"C1[`]? \.\.\. [`]?(C\d+)")
FUNCTION = re.compile(r"((?:///.*\n)+)(?:template.*\n)?(?:\[\[nodiscard\]\] )?(?:inline )?(?:constexpr )?[\w:]+ (\w+)\b")
MEASURED = re.compile(r"(?<![\w\\])(B\d{1,2}[a-f]?|DC\d[a-z]?)(?=[A-Z]\w*[a-z]|(?!\w))")
PATH = re.compile(r"(?<![\w/.-])((?:docs|decisions|src|apps|drivers|tests|examples|scripts|bindings|benchmarks|hapticut)/[\w./-]*\w"
                  r"\.(?:md|cpp|hpp|inl|py|toml|sh|svg|png|json|cs|mjs|ts))(?!\w)")
LINK = re.compile(r"\]\(([^)#:\s]*)(?:#([^)\s]*))?\)")
HEADING = re.compile(r"^#+ (.*)$", re.M)
ENGINES = ("Unity", "Unreal", "SOFA", "CHAI3D", "Godot")
A_LANGUAGE = "C99"  # not a closed form
IN_BACKTICKS = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
NAME = re.compile(r"[A-Za-z_]\w{4,}")
DECISIONS = "docs/decisions"
GIVEN_BY_TOOLS = {"__FILE__", "CMAKE_UNITY_BUILD"}
WRITTEN_BY_THE_BUILD = {"hapticut/version.hpp"}


def texts(root: Path) -> list[tuple[Path, str]]:
    files = [path for folder in FOLDERS for path in sorted((root / folder).rglob("*"))
             if path.suffix in ENDINGS and "node_modules" not in path.parts]
    files += [root / name for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md")]
    return [(path.relative_to(root), path.read_text(encoding="utf-8")) for path in files]


def line_of(text: str, place: int) -> int:
    return text.count("\n", 0, place) + 1


def check_closed_forms(root: Path) -> tuple[list[str], int]:
    model = (root / "docs/model.md").read_text(encoding="utf-8")
    rows = set(ROW.findall(model))
    last = max((row for row in rows if row[0] == "C"), key=lambda row: int(row[1:]))
    sources = (root / "docs/validation.md").read_text(encoding="utf-8")
    sources = sources[sources.index("### Sources"):]
    headers = "".join(path.read_text(encoding="utf-8")
                      for path in sorted((root / "include/hapticut/closed_forms").glob("*.hpp")))
    documented = FUNCTION.findall(headers)
    wrong = []
    for form in sorted(row for row in rows if row[0] == "C"):
        own = {name for comment, name in documented if comment.startswith(f"/// {form}")
               and not comment[len(form) + 4].isdigit()}
        functions = own or {name for comment, name in documented if re.search(rf"\b{form}\b", comment)}
        cells = "".join(line for line in model.splitlines() if line.startswith(f"| {form} |"))
        missing = sorted(name for name in functions if f"`{name}`" not in cells)
        if (own and missing) or len(missing) == len(functions):
            wrong.append(f"{form} of docs/model.md does not name its functions of include/hapticut/closed_forms: {missing}")
    cited = 0
    for path, text in texts(root):
        for found in CITED.finditer(text):
            if found[1] == A_LANGUAGE:
                continue
            cited += 1
            if found[1] not in rows:
                wrong.append(f"{path}:{line_of(text, found.start())} cites {found[1]}, which has no row in docs/model.md")
        for found in WHOLE_RANGE.finditer(text):
            if found[1] != last and (path.suffix == ".md" or path.name == "closed_forms.hpp"):
                wrong.append(f"{path}:{line_of(text, found.start())} ends with {found[1]}, but the last form is {last}")
        for found in MEASURED.finditer(text):
            cited += 1
            if not re.search(rf"\| (?:\w+ \.\.\. )?{found[1]}\b", sources) and not found[1].startswith("B1"):
                wrong.append(f"{path}:{line_of(text, found.start())} cites {found[1]}, which has no source in "
                             "docs/validation.md")
    return wrong, cited


def anchors_of(page: Path) -> set[str]:
    """The anchors of the headings of a page, as GitHub writes them."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.M | re.S)
    titles = [re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", title) for title in HEADING.findall(text)]
    return {re.sub(r"[^\w\- ]", "", title.strip().lower()).replace(" ", "-") for title in titles}


def check_files(root: Path) -> tuple[list[str], int]:
    readme, cited = (root / "README.md").read_text(encoding="utf-8"), 0
    wrong = [f"README.md names {engine}, but there is no bindings/{engine.lower()}" for engine in ENGINES
             if engine in readme and not (root / "bindings" / engine.lower()).is_dir()]
    for path, text in texts(root):
        for found in PATH.finditer(text):
            name = found[1]
            cited += 1
            places = (root / name, root / "docs" / name, root / "include" / name, root / "bindings/python" / name,
                      root / path.parent / name, *(own / name for own in root.glob("*/*/include")))
            if name not in WRITTEN_BY_THE_BUILD and not any(place.exists() for place in places):
                wrong.append(f"{path}:{line_of(text, found.start())} names {name}, which does not exist")
        for found in LINK.finditer(text) if path.suffix == ".md" else ():
            page = root / path.parent / found[1] if found[1] else root / path
            if not page.exists() or (found[2] and page.suffix == ".md" and found[2] not in anchors_of(page)):
                wrong.append(f"{path}:{line_of(text, found.start())} links to {found[0][2:-1]}, which does not exist")
    return wrong, cited


def check_names(root: Path) -> tuple[list[str], int]:
    known = set(GIVEN_BY_TOOLS)
    for path, text in texts(root):
        if not path.is_relative_to(DECISIONS) and path.name != "CHANGELOG.md":
            known |= {path.stem} | set(NAME.findall(text))
    wrong, cited = [], 0
    for path, text in texts(root):
        for found in IN_BACKTICKS.finditer(text) if path.is_relative_to(DECISIONS) else ():
            for name in NAME.findall(found[1]):
                cited += 1
                if name not in known:
                    wrong.append(f"{path}:{line_of(text, found.start())} names {name}, which stands nowhere in the code")
    return wrong, cited


CHECKS = {"closed_forms": check_closed_forms, "files": check_files, "names": check_names}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("what", choices=CHECKS)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    wrong, cited = CHECKS[options.what](options.root)
    if cited < 100:
        wrong.append(f"only {cited} citations were found: the search for them is broken")
    for sentence in wrong:
        print(sentence)
    print(f"{cited} citations, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
