#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that a test proves each term of docs/forces.md, and each closed form and each cure of docs/model.md.

    proofs.py [--list] [--root FOLDER]

The terms are the words in bold of docs/forces.md. A test that proves terms names them in a comment above it:
``// Proves: normal force; damping.`` An experiment of `hapticut validate` names them in its list in apps/experiments.
The closed forms (C) and the cures of defects (D) are rows of docs/model.md. The name of their test contains the number:
`BallDepth.C1ForceIsThatOfTheCap`. An experiment has the number in the id of a check. --list prints the tests of each
term and each number.
"""
import argparse
import re
import sys
from pathlib import Path

TEST = re.compile(r"((?:^//[^\n]*\n)*)^(?:TEST|TEST_P|TEST_F|RC_GTEST_PROP)\(\s*(\w+),\s*(\w+)", re.M)
PROVES = re.compile(r"Proves: (.*?)\.(?:\s|$)", re.S)
TERM = re.compile(r"\*\*(.+?)\*\*", re.S)
EXPERIMENT = re.compile(r"// Proves: ([^\n]*?)\.\n\s*(?:return \{)?\{\"(.+?)(?:, )?\"[, ]")
CHECK = re.compile(r"\"([CD]\d+)[ \"]")
ROW = re.compile(r"^\| ([CD]\d+) \|", re.M)


def tests_of(root: Path) -> list[tuple[str, str]]:
    """Name of each test, and the comment above it."""
    return [(f"{suite}.{name}", re.sub(r"\n?// ?", " ", comment)) for path in sorted((root / "tests").rglob("*.cpp"))
            for comment, suite, name in TEST.findall(path.read_text(encoding="utf-8"))]


def numbers_in(name: str) -> list[str]:
    """Numbers such as C1 and D8 in the name of a test."""
    return re.findall(r"(?<=[.a-z0-9])[CD]\d{1,2}(?=[A-Z]|$)", name)


def proofs_of(root: Path) -> tuple[dict[str, list[str]], list[str]]:
    """The tests of each term and each number, and the mistakes in page or tests."""
    page = (root / "docs/forces.md").read_text(encoding="utf-8")
    terms = {" ".join(term.split()).lower(): [] for term in TERM.findall(page)}
    numbers: dict[str, list[str]] = {n: [] for n in ROW.findall((root / "docs/model.md").read_text(encoding="utf-8"))}
    experiments = {path: path.read_text(encoding="utf-8") for path in sorted((root / "apps/experiments").glob("*.cpp"))}
    tests = tests_of(root)
    claims = [(f"validate: {name}", terms) for text in experiments.values() for terms, name in EXPERIMENT.findall(text)]
    claims += [(name, claim) for name, comment in tests for claim in PROVES.findall(comment)]
    mistakes = []
    for name, claim in claims:
        for term in (" ".join(part.split()) for part in claim.split(";")):
            if term.lower() in terms:
                terms[term.lower()].append(name)
            else:
                mistakes.append(f"{name} proves '{term}', which is not in bold in docs/forces.md")
    held = [(number, f"apps/experiments/{path.name}") for path, text in experiments.items()
            for number in CHECK.findall(text)]
    held += [(number, name) for name, _ in tests for number in numbers_in(name)]
    for number, name in dict.fromkeys(held):
        numbers.get(number, []).append(name)
    mistakes += [f"no test proves '{term}', a word in bold of docs/forces.md" for term, names in terms.items() if not names]
    mistakes += [f"no test and no experiment has the number {number}, a row of docs/model.md"
                 for number, names in numbers.items() if not names]
    if len(terms) < 40 or len(numbers) < 50:
        mistakes.append(f"only {len(terms)} terms and {len(numbers)} numbers were found: the search for them is broken")
    return terms | numbers, mistakes


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--list", action="store_true", help="print the tests of each term and each number")
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    proofs, mistakes = proofs_of(options.root)
    if options.list:
        for what, names in proofs.items():
            print(f"{what}: {', '.join(names)}")
    for mistake in mistakes:
        print(mistake)
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
