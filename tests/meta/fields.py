#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that the comment of each public member says what `fields_of` says of it: the unit, then the same words.

An editor shows the comment of a member, programs and pages show the list of fields. So both must agree:

    double mass = 0.05;  ///< [kg] mass of the simulated tool
    field("mass", &CouplingGains::mass, "kg", Range::positive(), "mass of the simulated tool")

The comment may go on behind these words.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIST = re.compile(r"^constexpr auto fields_of\(Of<([\w:]+)>\)\s*\{", re.M)
TEXT = re.compile(r'"((?:[^"\\]|\\.)*)"')


def after(text: str, start: int) -> int:
    """The place behind the bracket that closes the one at `start`; brackets in texts and comments do not count."""
    depth = 0
    for found in re.compile(r'"(?:[^"\\]|\\.)*"|//[^\n]*|(?<!\w)\'(?:[^\'\\]|\\.)\'|[(){}\[\]]').finditer(text, start):
        depth += {"(": 1, "{": 1, "[": 1, ")": -1, "}": -1, "]": -1}.get(found[0], 0)
        if depth == 0:
            return found.end()
    raise ValueError(f"no bracket closes {text[start:start + 60]!r}")


def arguments(text: str) -> list[str]:
    """The arguments of a call, `text` without its brackets."""
    parts, depth, start = [], 0, 0
    for found in re.finditer(r'"(?:[^"\\]|\\.)*"|[(){},]', text):
        depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(found[0], 0)
        if found[0] == "," and depth == 0:
            parts.append(text[start:found.start()])
            start = found.end()
    return [part.strip() for part in [*parts, text[start:]] if part.strip()]


def literal(text: str) -> str:
    return "".join(TEXT.findall(text)).replace('\\"', '"').replace("\\\\", "\\")


def fields(text: str):
    """The described structs of a header, with name, unit and words of each field."""
    for found in LIST.finditer(text):
        body = text[found.end():after(text, found.end() - 1)]
        listed = []
        for call in re.finditer(r"(?<!\w)field\(", body):
            given = arguments(body[call.end():after(body, call.end() - 1) - 1])
            member = re.fullmatch(r"&(?:\w+::)*(\w+)", given[1])
            if member:
                unit = literal(given[2]) if len(given) > 3 and given[2].startswith('"') else ""
                listed.append((member[1], unit, literal(given[-1])))
        yield found[1], listed


def comment_of(body: str, member: str) -> str | None:
    """The comment above or behind a member; None without such a member."""
    found = re.search(rf"^(?P<declaration>[^\n/]*[\s&*>]{member}(?: = [^;\n]*(?:\n[^;\n]*)*|\{{[^;]*\}})?;)"
                      rf"(?P<behind>[^\n]*(?:\n *///<[^\n]*|\n {{10,}}///<[^\n]*)*)", body, re.M)
    if not found:
        return None
    lines = []
    for line in reversed(body[:found.start()].splitlines()):
        if not line.strip().startswith("///"):
            break
        lines.insert(0, line)
    lines += found["behind"].splitlines()
    return " ".join(" ".join(line.strip().lstrip("/<") for line in lines).split())


def lower(text: str) -> str:
    """With a small first letter: a comment above a member is a sentence."""
    return text[:1].lower() + text[1:]


def main() -> None:
    mistakes, count = [], 0
    for path in sorted([*ROOT.glob("include/**/*.hpp"), *ROOT.glob("*/*/include/**/*.hpp")]):
        text = path.read_text(encoding="utf-8")
        for struct, listed in fields(text):
            name = struct.split("::")[-1]
            if not listed:
                continue
            begin = re.search(rf"^ *struct (?:alignas\(\w+\) )?{name}(?: final)?(?: : [^{{;]*)? \{{", text, re.M)
            if not begin:
                mistakes.append(f"{path.relative_to(ROOT)}: there is no struct {name}")
                continue
            body = text[begin.end():after(text, begin.end() - 1)]
            for member, unit, words in listed:
                count += 1
                expected = " ".join((f"[{unit}] " * bool(unit) + words).split())
                comment = comment_of(body, member)
                if comment is None or not lower(comment).startswith(lower(expected)):
                    mistakes.append(f"{path.relative_to(ROOT)}: the comment of {struct}::{member} must begin with what "
                                    f"fields_of says, '{expected}', but is '{comment}'")
    if count < 400:
        mistakes.append(f"only {count} fields were found; has the form of the lists changed?")
    print(f"{count} fields, {len(mistakes)} wrong")
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    sys.exit(1 if mistakes else 0)


if __name__ == "__main__":
    main()
