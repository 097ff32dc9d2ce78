#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of section 9 of docs/forces.md, or checks that they are up to date.

    proofs.py [--write] [--root FOLDER]

A test that proves a term of the page says so in a comment above it: ``// Proves: normal force; damping.``, and so does an
experiment of `hapticut validate` in its list. The terms are the words in bold of the page, in its order. A test that holds a
closed form or shows a defect has its number in its name, an experiment in an id of docs/validation.md; the numbers are the
rows of docs/model.md.
"""
import argparse
import re
import sys
from pathlib import Path

TEST = re.compile(r"((?:^//[^\n]*\n)*)^(?:TEST|TEST_P|TEST_F|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+)", re.M)
PROVES = re.compile(r"Proves: (.*?)\.(?:\s|$)", re.S)
TERM = re.compile(r"\*\*(.+?)\*\*", re.S)
EXPERIMENT = re.compile(r"// Proves: ([^\n]*?)\.\n\s*(?:return \{)?\{\"(.+?)(?:, )?\"[, ]")
CASE = re.compile(r"^\| ([^|]+?) \| ([CD]\d+)[ ,|]", re.M)
NAMED = re.compile(r"`(\w+\.[A-Z]\w{5,})`")
ROW = re.compile(r"^\| ([CD]\d+) \|", re.M)
MARK = "<!-- proofs -->\n"


def tests_of(root: Path) -> list[tuple[str, str]]:
    """Name of each test, and the comment above it."""
    found = []
    for path in sorted((root / "tests").rglob("*.cpp")):
        for comment, suite, name in TEST.findall(path.read_text(encoding="utf-8")):
            found.append((f"{suite}.{name}", re.sub(r"\n?// ?", " ", comment)))
    return found


def experiments_of(root: Path) -> list[tuple[str, str]]:
    """Name of each experiment that proves terms, and the terms."""
    return [(name, terms) for path in sorted((root / "tests/experiments").glob("*.cpp"))
            for terms, name in EXPERIMENT.findall(path.read_text(encoding="utf-8"))]


def numbers_in(name: str) -> list[str]:
    """C1 and D8 of a test's name, whose words are not apart: `BallDepth.C1ForceIsThatOfTheCap`."""
    return re.findall(r"(?<=[.a-z0-9])[CD]\d{1,2}(?=[A-Z]|$)", name)


def table(heading: str, rows: dict[str, list[str]]) -> str:
    lines = [f"| {heading} | tests |", "|---|---|"]
    lines += [f"| {row} | {', '.join(names)} |" for row, names in rows.items()]
    return "\n".join(lines) + "\n"


def written(root: Path, page: str) -> tuple[str, list[str]]:
    """The page with its tables, and what is wrong with page or tests."""
    text = page[: page.index(MARK) + len(MARK)]
    terms = {" ".join(term.split()).lower(): " ".join(term.split()) for term in TERM.findall(text)}
    proofs: dict[str, list[str]] = {term: [] for term in terms.values()}
    numbers: dict[str, list[str]] = {n: [] for n in ROW.findall((root / "docs/model.md").read_text(encoding="utf-8"))}
    numbers = dict(sorted(numbers.items(), key=lambda item: (item[0][0], int(item[0][1:]))))
    wrong = []
    tests = tests_of(root)
    claims = [(f"`validate: {name}`", claim) for name, claim in experiments_of(root)]
    claims += [(f"`{name}`", claim) for name, comment in tests for claim in PROVES.findall(comment)]
    for name, claim in claims:
        for term in claim.split(";"):
            term = " ".join(term.split())
            if term.lower() in terms:
                proofs[terms[term.lower()]].append(name)
            else:
                wrong.append(f"{name} proves '{term}', and docs/forces.md has no such word in bold")
    held = [(number, f"`validate: {name}`")
            for name, number in CASE.findall((root / "docs/validation.md").read_text(encoding="utf-8"))]
    held += [(number, f"`{name}`") for name, _ in tests for number in numbers_in(name)]
    for number, name in dict.fromkeys(held):
        numbers.get(number, []).append(name)
    names = {name for name, _ in tests}
    cited = NAMED.findall(text + (root / "docs/measurements.md").read_text(encoding="utf-8"))
    wrong += [f"docs/forces.md or measurements.md names {name}, a test that is not there"
              for name in cited if name not in names]
    wrong += [f"no test says that it proves '{term}', a word in bold of docs/forces.md"
              for term, names in proofs.items() if not names]
    wrong += [f"no test and no experiment has {number} in its name" for number, names in numbers.items()
              if not names and number[0] == "C"]
    numbers = {number: names for number, names in numbers.items() if names}
    return text + "\n" + table("term", proofs) + "\n" + table("number", numbers), wrong


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    path = options.root / "docs/forces.md"
    page = path.read_text(encoding="utf-8")
    expected, wrong = written(options.root, page)
    for sentence in wrong:
        print(sentence)
    if options.write:
        path.write_text(expected, encoding="utf-8")
    elif page != expected:
        wrong.append("old")
        print("The tables of docs/forces.md are not those of the tests: run tests/meta/proofs.py --write.")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
