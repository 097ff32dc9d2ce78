#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the C++ code of pages is code of compiled examples, and that they print what the pages show.

    page_code.py [--root FOLDER]

A page of PAGES names an example of examples/cpp and then shows lines of it. The example that the page named last must
contain each block of C++ word for word, except for indentation. A block without a language is what the example prints:
the expression in examples/CMakeLists.txt, which the test of the example compares with its output, must match it too.
"""
import argparse
import re
import sys
import textwrap
from pathlib import Path

PAGES = {"docs/tutorial.md": 8, "docs/your-own-loop.md": 6, "docs/other-scenes.md": 8}  # page: minimum number of blocks
EXAMPLE = re.compile(r"examples/cpp/\w+\.cpp")
PRINTS = re.compile(r'hapticut_example\((\w+)\s+"([^"]*)"')


def without_indentation(lines: list[str]) -> str:
    return textwrap.dedent("\n".join(lines))


def is_in(block: str, example: str) -> bool:
    lines, wanted = example.splitlines(), block.splitlines()
    return any(without_indentation(lines[n:n + len(wanted)]) == without_indentation(wanted)
               for n in range(len(lines) - len(wanted) + 1))


def outputs(root: Path) -> dict[str, str]:
    """For each example the expression that its output must match."""
    text = (root / "examples/CMakeLists.txt").read_text(encoding="utf-8")
    return {f"examples/cpp/{name}.cpp": expression.replace("\\n", "\n") for name, expression in PRINTS.findall(text)}


def check(root: Path, page: str, at_least: int) -> tuple[list[str], int]:
    wrong, blocks, example, block, fence, prints = [], 0, "", [], "", outputs(root)
    for number, line in enumerate((root / page).read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("```"):
            if fence == "cpp":
                blocks += 1
                if not example:
                    wrong.append(f"{page}:{number - len(block)} shows code before it names an example")
                elif not is_in("\n".join(block), (root / example).read_text(encoding="utf-8")):
                    wrong.append(f"{page}:{number - len(block)} shows code that {example} does not have")
            if fence == "text" and example not in prints:
                wrong.append(f"{page}:{number - len(block)} shows output before it names an example that has any")
            elif fence == "text" and not re.search(prints[example], "\n".join(block), re.DOTALL):
                wrong.append(f"{page}:{number - len(block)} shows what {example} does not print: {prints[example]}")
            fence = "" if fence else line[3:] or "text"
            block = []
        elif fence:
            block.append(line)
        else:
            example = (EXAMPLE.findall(line) or [example])[-1]
    if blocks < at_least:
        wrong.append(f"{page} has only {blocks} blocks of C++: the search for them is broken")
    return wrong, blocks


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    options = parser.parse_args()
    wrong, total = [], 0
    for page, at_least in PAGES.items():
        found, blocks = check(options.root, page, at_least)
        wrong += found
        total += blocks
    for sentence in wrong:
        print(sentence)
    print(f"{total} blocks of C++, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
