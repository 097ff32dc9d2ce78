#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the comments of the C++ headers into the docstrings of the Python package.

    documentation.py OUTPUT HEADER...

Every declaration with a ``///`` comment becomes an entry ``{"Scope::name", "text"}`` of OUTPUT, sorted by key; further
overloads are ``name#2``, ``name#3``. Doxygen's commands become the sections of NumPy's style. So every object has one
description, in the header. Arrays get their shape from the C++ type.
"""
import keyword
import re
import sys
from pathlib import Path
from typing import Optional

SECTIONS = {"param": "Parameters", "return": "Returns", "throws": "Raises", "realtime": "Notes", "pre": "Notes"}
SCOPE = re.compile(r"^\s*(?:struct|class|enum(?: class)?|namespace)\s+(?:alignas\(\d+\)\s+)?(\w+)[^;(]*\{")
ENUMERATOR = re.compile(r"^\s*(\w+)\s*(?:=[^,]*)?,?\s*(?:///<.*)?$")
FUNCTION = re.compile(r"(\w+|operator\S+)\s*\(")
PREAMBLE = re.compile(r"^\s*(?:template|requires)\b[^{;]*$")
NO_DECLARATION = re.compile(r"^\s*(?:public|private|protected|using|friend)\b")
SHAPES = {"Vec3": "(3,)", "VoxelIndex": "(3,)", "Mat3": "(3, 3)", "Pose": "(4, 4)", "Twist": "(6,)",
          "Stiffness": "(6, 6)", "std::vector<Vec3>": "(n, 3)", "std::span<const Vec3>": "(n, 3)",
          "std::span<const VoxelIndex>": "(n, 3)",
          "std::optional<Vec3>": "(3,) or None;",
          "ScriptedPath": "function from time [s] to (4, 4);",
          "std::function<double(const Vec3& p_WQ)>": "function from (3,) to a number;",
          "std::function<MaterialId(const Vec3& p_WQ)>": "function from (3,) to a whole number;"}
# Parameters of C++ that the functions of Python lack.
NOT_IN_PYTHON = {"Simulation::step": ["coupling"], "SafetyGuard::SafetyGuard": ["requests"],
                 "HeatField::update": ["origin", "material"], "IslandFinder::update": ["origin", "fill"],
                 "SurfaceStream::update": ["origin", "material"]}  # the first name of "@param material, fill"
# Remarks about references. Python has none: its results own their data.
LIFETIME = re.compile(r"a reference that stays valid; its contents are those of the last call"
                      r"|[;,] valid until the next (?:call|one|step)|valid until the next call\. ")


def shape_of(cpp_type: str) -> Optional[str]:
    """The shape in Python of a C++ type, or None when it is not an array."""
    words = r"\b(?:static|inline|constexpr|virtual|explicit|mutable)\b|\[\[\w+\]\]"
    plain = re.sub(r"^const\b|&$", "", re.sub(words, "", cpp_type).strip()).strip()
    return SHAPES.get(plain)


def shapes_of_parameters(declaration: str) -> dict[str, str]:
    """The shapes of a function's array parameters, by name."""
    depth, parts = 0, [""]
    for character in declaration[declaration.index("(") + 1 :]:
        depth += {"(": 1, "<": 1, "{": 1, ")": -1, ">": -1, "}": -1}.get(character, 0)
        if depth < 0:
            break
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    shapes = {}
    for part in parts:
        found = re.match(r"(.*[\s&])(\w+)\s*$", part.split("=")[0].split("{")[0].strip())
        shape = shape_of(found[1].strip()) if found else None
        if found and shape:
            shapes[found[2]] = shape
    return shapes


def after_the_unit(text: str, shape: str) -> str:
    """A description with the shape inserted after its unit in brackets."""
    unit = re.match(r"(?:\[[^\]]*\])?", text)[0]
    return " ".join(filter(None, [unit, shape, text[len(unit) :].lstrip(", ")]))


def numpy_style(comment: list[str], shapes: dict[str, str], result: Optional[str], absent: list[str]) -> str:
    """The lines of one Doxygen comment as the text of a docstring, with the shapes of parameters and result, without
    the absent parameters."""
    shapes = {name: shape for name, shape in shapes.items() if name not in absent}
    comment = [LIFETIME.sub("", line) for line in comment]
    text: list[str] = []
    sections: dict[str, list[list[str]]] = {}
    target = text
    for line in comment:
        # A command may also follow a sentence on the same line, after two spaces.
        for n, part in enumerate(re.split(r"(?:^|(?<=  ))(?=@(?:param|return|throws|realtime|pre)\b)", line)):
            command = re.match(r"@(param|return|throws|realtime|pre)\b\s*(.*)", part)
            if command is None:
                if part.strip() or n == 0:
                    target.append(part.rstrip() if target is text else part.strip())
                continue
            entry = [command[2].strip()]
            if command[1] == "pre":
                entry[0] = "Requires: " + entry[0]
            if command[1] == "realtime":
                entry[0] = "Real time: " + entry[0]
            sections.setdefault(SECTIONS[command[1]], []).append(entry)
            target = entry
    lines = "\n".join(text).strip("\n").split("\n") if any(text) else []
    parameters = [entry for entry in sections.get("Parameters", [])
                  if re.match(r"\w*", entry[0])[0] not in absent]
    sections["Parameters"] = parameters
    described = " ".join(entry[0] for entry in parameters)
    parameters += [[name] for name in shapes if not re.search(rf"\b{name}\b", described)]
    if result is not None and not parameters and "Returns" not in sections and lines and lines[0].startswith("["):
        lines[0] = after_the_unit(lines[0], result)  # an accessor, which is a property in Python
    elif result is not None:
        returned = sections.setdefault("Returns", [[""]])
        returned[0][0] = after_the_unit(returned[0][0], result)
    for title in ("Parameters", "Returns", "Raises", "Notes"):
        if not any(map(any, sections.get(title, []))):
            continue
        if lines:
            lines.append("")
        lines += [title, "-" * len(title)]
        for entry in sections[title]:
            body = [part for part in entry if part]
            if title == "Parameters":
                name, _, rest = body[0].partition(" ") if body else ("", "", "")
                while rest and name.endswith(","):  # "@param from, to  text"
                    more, _, rest = rest.partition(" ")
                    name += " " + more
                shape = shapes.get(re.split(r"\W+", name)[0])
                name = re.sub(r"\w+", lambda word: word[0] + "_" * keyword.iskeyword(word[0]), name)
                lines.append(f"{name} : {shape}" if shape else name)
                lines += ["    " + part.strip() for part in [rest, *body[1:]] if part.strip()]
            elif title == "Raises":
                sentence = " ".join(body)
                sentence = sentence.removeprefix("Error").strip()
                lines += ["Error", "    " + (sentence[:1].upper() + sentence[1:] if sentence else "See above.")]
            else:
                lines += body
    return "\n".join(lines).replace("`", "``")


def without_comments_and_strings(line: str) -> str:
    return re.sub(r'"(?:\\.|[^"\\])*"', '""', re.sub(r"//.*", "", line))


class Header:
    """Reads one header line by line, with a stack of the open scopes."""

    def __init__(self, entries: dict[str, str]):
        self.entries = entries
        self.scopes: list[tuple[str, int, bool]] = []  # name, depth inside, whether an enumeration
        self.depth = 0
        self.pending: list[str] = []
        self.last: list[str] = []  # keys that a following ///< line continues
        self.trailing: list[str] = []
        self.open_parentheses = 0
        self.below: list[str] = []  # the current line and the following ones
        self.shapes: dict[str, str] = {}  # of the last declaration's parameters
        self.result: Optional[str] = None  # shape of its result

    def key(self, name: str) -> str:
        return "::".join([scope for scope, _, _ in self.scopes if scope != "hapticut"] + [name])

    def add(self, names: list[str], comment: list[str], overloads: bool = False) -> None:
        self.last, self.trailing = [], comment
        for name in names:
            key = self.key(name)
            if key in self.entries and overloads:
                number = 2
                while f"{key}#{number}" in self.entries:
                    number += 1
                key = f"{key}#{number}"
            self.entries[key] = self.docstring(comment, key)
            self.last.append(key)

    def docstring(self, comment: list[str], key: str) -> str:
        return numpy_style(comment, self.shapes, self.result, NOT_IN_PYTHON.get(key, []))

    def read(self, path: Path) -> None:
        lines = path.read_text(encoding="utf-8").splitlines()
        for number, line in enumerate(lines):
            self.below = lines[number:]
            self.read_line(line)

    def read_line(self, line: str) -> None:
        stripped = line.strip()
        if stripped.startswith("///<"):
            if self.last:
                self.trailing.append(stripped[4:].strip())
                for key in self.last:
                    self.entries[key] = self.docstring(self.trailing, key)
            return
        if stripped.startswith("///"):
            self.pending.append(re.sub(r"^///\s?", "", stripped) if stripped != "///" else "")
            return
        if stripped.startswith("//"):
            return
        code = without_comments_and_strings(line)
        in_scope = not self.scopes or self.depth == self.scopes[-1][1]
        if self.open_parentheses == 0 and in_scope and code.strip():
            self.read_declaration(line, code)
        if not stripped:
            self.last = []
            if self.pending and self.pending[0].startswith("@file"):
                self.pending = []
        elif not PREAMBLE.match(code):  # the comment belongs to the next declaration
            self.pending = []
        self.open_parentheses = max(0, self.open_parentheses + code.count("(") - code.count(")"))
        self.depth += code.count("{") - code.count("}")
        while self.scopes and self.depth < self.scopes[-1][1]:
            self.scopes.pop()

    def read_declaration(self, line: str, code: str) -> None:
        comment = self.pending
        self.shapes, self.result = {}, None
        if comment and comment[0].startswith("@file"):
            comment = []
        found = re.search(r"///<\s?(.*)", line)
        trailing = [found[1].strip()] if found else []
        scope = SCOPE.match(code)
        if scope and "(" not in code.split("{")[0].replace("alignas(", ""):
            if comment or trailing:
                self.add([scope[1]], comment or trailing)
            self.scopes.append((scope[1], self.depth + 1, "enum" in code.split("{")[0].split()))
            return
        if self.scopes and self.scopes[-1][2]:
            enumerator = ENUMERATOR.match(line)
            if enumerator and (comment or trailing):
                self.add([enumerator[1]], comment or trailing)
            return
        if not (comment or trailing) or PREAMBLE.match(code) or NO_DECLARATION.match(code):
            return
        head = re.sub(r"\[\[\w+\]\]|alignas\(\w+\)", "", code)
        function = FUNCTION.search(head)
        assigned = head.find("=")
        if function and (assigned < 0 or function.start() < assigned):
            # a field such as std::function<double(int)> f; is not a function
            field = re.match(r"^\s*((?:std::)\w+<.*>)\s+(\w+)\s*(?:=.*|\{.*)?;", head)
            if field:
                self.add_field(field[1], [field[2]], comment or trailing)
                return
            whole = " ".join(map(without_comments_and_strings, self.below[:20]))
            self.shapes = shapes_of_parameters(whole[function.start() :] if head == code else whole)
            self.result = shape_of(head[: function.start()])
            self.add([function[1]], comment or trailing, overloads=True)
            return
        cpp_type = re.match(r"\s*((?:(?:static|inline|constexpr|const|mutable)\s+)*[\w:]+(?:<.*>)?)", head)
        declaration = re.sub(r"<[^<>]*(?:<[^<>]*>[^<>]*)*>", "", head.strip()).rstrip(";")
        declaration = re.sub(r"^(?:(?:static|inline|constexpr|const|mutable)\s+)*[\w:]+[*&]*\s+", "", declaration)
        declaration = re.sub(r"\{[^}]*\}|\([^)]*\)", "", declaration)
        names = [part.split("=")[0].strip(" *&") for part in declaration.split(",")]
        names = [name for name in names if re.fullmatch(r"\w+", name)]
        if names:
            self.add_field(cpp_type[1] if cpp_type else "", names, comment or trailing)

    def add_field(self, cpp_type: str, names: list[str], comment: list[str]) -> None:
        shape = shape_of(cpp_type)
        self.add(names, [after_the_unit(comment[0], shape), *comment[1:]] if shape else comment)


def main() -> None:
    output, *headers = sys.argv[1:]
    entries: dict[str, str] = {}
    for header in headers:
        Header(entries).read(Path(header))
    lines = ["// Written by documentation.py from the headers."]
    for key in sorted(entries):
        # Raw strings have a maximum length that no comment reaches.
        lines.append(f'{{"{key}", R"~~({entries[key]})~~"}},')
    text = "\n".join(lines) + "\n"
    path = Path(output)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
