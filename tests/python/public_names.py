# SPDX-License-Identifier: Apache-2.0
"""What the C++ headers offer: every public type, field, enumerator, function and constant by its name.

Not a parser of C++, only of the headers of this library: namespaces, classes with their access, enumerations, fields,
functions with or without bodies. `python public_names.py` prints what it finds.
"""
from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

HEADERS = Path(__file__).resolve().parents[2] / "include" / "hapticut"

SCOPE = re.compile(r"(?:template\s*<.*>\s*)?(namespace|struct|class|enum(?:\s+class)?)\b\s*(?:alignas\(\w+\)\s*)?([\w:]*\w|)")
NOISE = re.compile(r"//[^\n]*|/\*.*?\*/|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.S | re.M)
STRING = re.compile(r'"(?:\\.|[^"\\\n])*"' + r"|'(?:\\.|[^'\\\n])'")
FUNCTION = re.compile(r"(operator\s*(?:\(\)|[^\s\w(]+)|~?\w+)\s*\(")
NO_NAME = re.compile(r"^(?:friend|static_assert|using namespace)\b|= default$|= delete$")


@dataclass
class Name:
    """One public name of C++."""

    kind: str  # type, alias, enumerator, field or function
    header: str
    overloads: int = 0  # of a function: without templates, copies and moves


@dataclass
class Scope:
    kind: str
    name: str
    access: str


def without_angles(text: str) -> str:
    """The text without what is between < and > of template arguments, parameters of functions among it included."""
    kept, depth = "", 0
    for place, character in enumerate(text):
        opens = character == "<" and re.search(r"\w$", text[:place]) and not text[:place].endswith("operator")
        if opens or (depth and character == "<"):
            depth += 1
        elif depth and character == ">" and text[place - 1] != "-":
            depth -= 1
        elif not depth:
            kept += character
    return kept


def closing(text: str, start: int) -> int:
    """Where the brace that opens at `start` closes."""
    depth = 0
    for place in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[place], 0)
        if depth == 0:
            return place
    raise ValueError("a brace does not close")


class Reader:
    """Reads one header."""

    def __init__(self, header: str, names: dict[str, Name]):
        self.header = header
        self.names = names
        self.scopes: list[Scope] = []

    def add(self, name: str, kind: str, counts: bool = False) -> None:
        if any(scope.access == "private" or scope.name == "detail" for scope in self.scopes):
            return
        # In Python a name of hapticut::units is looked for in the package and in its module `units`.
        parts = [scope.name.removeprefix("hapticut::") for scope in self.scopes
                 if scope.name not in ("", "hapticut", "hapticut::units")]
        found = self.names.setdefault("::".join([*parts, name]), Name(kind, self.header))
        found.overloads += counts

    def declare(self, statement: str) -> bool:
        """One declaration without its body. @return whether it was a function"""
        text = re.sub(r"\[\[\w+\]\]|\balignas\(\w+\)|\bdecltype\(auto\)", "", " ".join(statement.split())).strip()
        generic = text.startswith("template")
        text = re.sub(r"^template\s*<[^{;]*?>\s*(?:requires [\w:]+<[^<>]*> )?(?=\w)", "", text)
        alias = re.match(r"using (\w+) =", text)
        if alias:
            self.add(alias[1], "alias")
            return False
        if not text or NO_NAME.search(text) or re.match(r"(?:struct|class|enum|using)\b", text):
            return "(" in text
        head = without_angles(text)
        function = FUNCTION.search(head)
        if function and head.find("=") not in range(0, function.start()):
            name = function[1].replace(" ", "")
            moves = re.match(r"(?:const )?(\w+)&&?", head[function.end() :])  # or copies
            self.add(name, "function", not generic and (moves is None or moves[1] != name))
            return True
        for part in re.sub(r"\{[^}]*\}|\([^)]*\)", "", head).split(","):
            name = re.search(r"(\w+)\s*(?:\[\w*\]\s*)*$", part.split("=")[0])
            if name:
                self.add(name[1], "field")
        return False

    def read(self, text: str) -> None:
        text = STRING.sub('""', NOISE.sub("", text))
        begin = place = 0
        while place < len(text):
            character = text[place]
            if character == "(":  # parameters, with braces of defaults in them
                depth = 1
                while depth:
                    place += 1
                    depth += {"(": 1, ")": -1}.get(text[place], 0)
            elif character == ";":
                self.declare(text[begin:place])
                begin = place + 1
            elif character == ":" and text[begin:place].strip() in ("public", "protected", "private"):
                self.scopes[-1].access = text[begin:place].strip().replace("protected", "private")
                begin = place + 1
            elif character == "{":
                scope = SCOPE.match(text[begin:place].strip())
                if scope and scope[1].startswith("enum"):
                    self.add(scope[2], "type")
                    end = closing(text, place)
                    self.scopes.append(Scope("enum", scope[2], "public"))
                    for value in text[place + 1 : end].split(","):
                        if value.strip():
                            self.add(value.split("=")[0].strip(), "enumerator")
                    self.scopes.pop()
                    place, begin = end, end + 1
                elif scope:
                    if scope[1] != "namespace":
                        self.add(scope[2], "type")
                    access = "private" if scope[1] == "class" else "public"
                    self.scopes.append(Scope(scope[1], scope[2], access))
                    begin = place + 1
                else:
                    end = closing(text, place)
                    head = text[begin:place]
                    is_body = re.search(r"\)\s*(?:const|noexcept|override|final|->.*|:[^:].*|\s)*$", head, re.S)
                    if is_body and self.declare(re.split(r"\)\s*:[^:]", head)[0] + ")"):
                        begin = end + 1
                    place = end
            elif character == "}":
                self.scopes.pop()
                begin = place + 1
            place += 1


def public_names() -> dict[str, Name]:
    """Every public name of C++, without the namespace hapticut."""
    names: dict[str, Name] = {}
    for path in sorted(HEADERS.rglob("*.hpp")):
        Reader(path.relative_to(HEADERS).as_posix(), names).read(path.read_text(encoding="utf-8"))
    return names


if __name__ == "__main__":
    for name, found in sorted(public_names().items()):
        print(f"{found.header:40} {found.kind:10} {found.overloads or '':3} {name}")
