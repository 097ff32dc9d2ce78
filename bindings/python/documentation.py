#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the comments of the C++ headers into the docstrings of the Python package.

    documentation.py OUTPUT HEADER...

Every declaration with a ``///`` comment becomes an entry ``{"Scope::name", "text"}`` of OUTPUT, sorted by key. If
several overloads have comments, each is an entry with the types of its parameters, ``name(Gravity)``, and there is none
without: a binding has to say which. Doxygen's commands become the sections of NumPy's style. So every object has one
description, in the header. Arrays get their shape from the C++ type.
"""
import itertools
import keyword
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

SHAPES = {"Vec3": "(3,)", "VoxelIndex": "(3,)", "Mat3": "(3, 3)", "Pose": "(4, 4)", "Twist": "(6,)",
          "Stiffness": "(6, 6)", "std::vector<Vec3>": "(n, 3)", "std::span<const Vec3>": "(n, 3)",
          "std::span<const VoxelIndex>": "(n, 3)",
          "std::optional<Vec3>": "(3,) or None;",
          "ScriptedPath": "function from time [s] to (4, 4);",
          "std::function<double(const Vec3& p_WQ)>": "function from (3,) to a number;",
          "std::function<MaterialId(const Vec3& p_WQ)>": "function from (3,) to a whole number;"}
ARRAY = r"(?<![\w:<])(" + "|".join(re.escape(kind) for kind in sorted(SHAPES, key=len, reverse=True)) + ")&?"
SECTIONS = {"param": "Parameters", "return": "Returns", "throws": "Raises", "realtime": "Notes", "pre": "Notes"}
BEGINS = {"pre": "Requires: ", "realtime": "Real time: "}
# A command may also follow a sentence on the same line, after two spaces.
COMMAND = re.compile(r"(?:^|(?<=  ))@(param|return|throws|realtime|pre)\b\s*")
SCOPE = re.compile(r"\s*(?:struct|class|enum(?: class)?|namespace)\s+(?:alignas\(\w+\)\s+)?(\w+)")
NO_DECLARATION = re.compile(r"\s*(?:(?:public|private|protected|using|friend)\b|~)")
PREAMBLE = re.compile(r"\s*(?:template|requires)\b[^{;]*$")  # its comment belongs to the next line
# Parameters of C++ that the functions of Python lack.
NOT_IN_PYTHON = {"Simulation::step": ["coupling"], "SafetyGuard::SafetyGuard": ["requests"],
                 "HeatField::update": ["origin", "material"], "IslandFinder::update": ["origin", "fill"],
                 "SurfaceStream::update": ["origin", "material"]}  # the first name of "@param material, fill"
# Remarks about references. Python has none: its results own their data.
LIFETIME = re.compile(r"a reference that stays valid; its contents are those of the last call"
                      r"|[;,] valid until the next (?:call|one|step)|valid until the next call\. ")


@dataclass
class Declaration:
    """What one declaration of C++ declares."""
    names: list[str]
    is_function: bool = False
    types: str = ""  # of a function's parameters, with commas, without const, reference, namespace and default
    shape: str = ""  # of a field or a result; empty: no array
    parameters: dict[str, str] = field(default_factory=dict)  # shapes of those that are arrays

    @staticmethod
    def of(code: str) -> "Declaration":
        if scope := SCOPE.match(code):
            return Declaration([scope[1]])
        plain = re.sub(r"\[\[\w+\]\]|alignas\(\w+\)", "", code).strip()
        plain = re.sub(r"^(?:(?:static|inline|constexpr|const|mutable) )+", "", plain)
        flat = re.sub(r"std::function<.*?>(?= \w)", lambda kind: "_" * len(kind[0]), plain)  # hides its parentheses
        function = re.search(r"(operator\S+|\w+)\s*\(", flat)
        if function and "=" not in plain[: function.start()]:
            result = re.search(ARRAY + r"\s*$", plain[: function.start()])
            inside = re.split(r"\)\s*(?:[;{:=]|const|noexcept|override)", plain[function.start() :])[0] + ")"
            parameters = re.findall(ARRAY + r" (\w+)(?=\s*[,)={])", inside)
            return Declaration([function[1]], True, types_of(inside[len(function[0]) - 1 :]),
                               SHAPES[result[1]] if result else "",
                               {name: SHAPES[kind] for kind, name in parameters})
        one = re.match(r"([\w:]+(?:<.*>)?)[*&]* +(\w.*)", plain)
        if one is None:
            return Declaration([])
        names = re.sub(r"\{[^}]*\}|\([^)]*\)|;", "", one[2]).split(",")
        names = [name.split("=")[0].strip(" *&") for name in names]
        return Declaration([name for name in names if re.fullmatch(r"\w+", name)], shape=SHAPES.get(one[1], ""))


def types_of(parameters: str) -> str:
    """The types in "(const std::vector<GreyRange>& ranges, double margin = 0)": "vector, double"."""
    while (plain := re.sub(r"<[^<>]*>|(?<=.)\([^()]*\)", "", parameters)) != parameters:
        parameters = plain
    declared = [re.findall(r"[\w:]+", one.split("=")[0].replace("const ", "")) for one in parameters.strip("()").split(",")]
    return ", ".join(words[max(0, len(words) - 2)].split("::")[-1] for words in declared if words)


def with_shape(text: str, shape: str) -> str:
    """A description with a shape inserted after its unit in brackets."""
    unit = re.match(r"(?:\[[^\]]*\])?", text)[0]
    return " ".join(filter(None, [unit, shape, text[len(unit) :].lstrip(", ")]))


def sections_of(comment: list[str]) -> tuple[list[str], dict[str, list[list[str]]]]:
    """The lines before the first command, and the lines of each command in its section."""
    text: list[str] = []
    sections: dict[str, list[list[str]]] = {title: [] for title in SECTIONS.values()}
    lines = text
    for line in comment:
        first, *commands = COMMAND.split(LIFETIME.sub("", line).rstrip())
        if first or lines is text:
            lines.append(first.rstrip() if lines is text else first.strip())
        for command, rest in zip(commands[::2], commands[1::2]):
            lines = [BEGINS.get(command, "") + rest.strip()]
            sections[SECTIONS[command]].append(lines)
    return "\n".join(text).strip("\n").split("\n") if any(text) else [], sections


def parameter(lines: list[str], shapes: dict[str, str]) -> list[str]:
    """The entry of "@param from, to  text" in NumPy's style."""
    names, text = re.match(r"((?:\w+, )*\S+)\s*(.*)", lines[0]).groups()
    shape = shapes.get(names.split(",")[0])
    names = re.sub(r"\w+", lambda name: name[0] + "_" * keyword.iskeyword(name[0]), names)
    return [f"{names} : {shape}" if shape else names, *(f"    {line}" for line in [text, *lines[1:]] if line)]


def docstring(comment: list[str], declared: Declaration, absent: list[str]) -> str:
    """A comment in NumPy's style, without the parameters that are absent in Python."""
    text, sections = sections_of(comment)
    parameters = [lines for lines in sections["Parameters"] if re.match(r"\w*", lines[0])[0] not in absent]
    described = set(re.findall(r"\w+", " ".join(lines[0] for lines in parameters))) | set(absent)
    parameters += [[name] for name in declared.parameters if name not in described]
    returns = [line for lines in sections["Returns"] for line in lines if line]
    is_accessor = text and text[0].startswith("[") and not parameters and not returns  # a property in Python
    if declared.shape and text and (is_accessor or not declared.is_function):
        text[0] = with_shape(text[0], declared.shape)
    elif declared.shape:
        returns = [with_shape("".join(returns[:1]), declared.shape), *returns[1:]]
    raises = [" ".join(lines).removeprefix("Error").strip() or "see above." for lines in sections["Raises"]]
    bodies = {"Parameters": [line for lines in parameters for line in parameter(lines, declared.parameters)],
              "Returns": returns,
              "Raises": [line for reason in raises for line in ("Error", "    " + reason[0].upper() + reason[1:])],
              "Notes": [line for lines in sections["Notes"] for line in lines if line]}
    for title, body in bodies.items():
        if body:
            text += [*([""] if text else []), title, "-" * len(title), *body]
    return "\n".join(text).replace("`", "``")


def add_header(path: Path, entries: dict[str, dict[str, str]]) -> None:
    """Adds the docstrings of a header: by key, then by the types of a function's parameters."""
    comment: list[str] = []  # before the next declaration
    scopes: list[tuple[int, str]] = []  # the open ones: depth inside and declaration
    depth = 0
    lines = path.read_text(encoding="utf-8").splitlines()
    codes = [re.sub(r'//.*|"(?:\\.|[^"\\])*"', "", line) for line in lines]
    for number, (line, code) in enumerate(zip(lines, codes)):
        if found := re.match(r"\s*///(?!<) ?(.*)", line):
            comment.append(found[1])
        if not line and comment and comment[0].startswith("@file"):
            comment = []
        if not code.strip() or PREAMBLE.match(code):
            continue
        if "///<" in line and not comment:
            after = itertools.takewhile(lambda more: more.lstrip().startswith("///<"), lines[number + 1 :])
            comment = [part.split("///<")[1].strip() for part in [line, *after]]
        if comment and not comment[0].startswith("@file") and not NO_DECLARATION.match(code):
            whole = code + " ".join(codes[number + 1 : number + 20]) if code.count("(") > code.count(")") else code
            is_enumerator = scopes and "enum" in scopes[-1][1]
            declared = Declaration(re.findall(r"\w+", code)[:1]) if is_enumerator else Declaration.of(whole)
            for name in declared.names:
                key = "::".join([SCOPE.match(scope)[1] for _, scope in scopes] + [name]).removeprefix("hapticut::")
                text = docstring(comment, declared, NOT_IN_PYTHON.get(key, []))
                entries.setdefault(key, {})[declared.types if declared.is_function else ""] = text
        comment = []
        depth += code.count("{") - code.count("}")
        while scopes and depth < scopes[-1][0]:
            scopes.pop()
        if SCOPE.match(code) and code.count("{") > code.count("}"):
            scopes.append((depth, code))


def main() -> None:
    output, *headers = sys.argv[1:]
    entries: dict[str, dict[str, str]] = {}
    for header in headers:
        add_header(Path(header), entries)
    texts = {f"{key}({types})" if len(overloads) > 1 else key: text
             for key, overloads in entries.items() for types, text in overloads.items()}
    # Raw strings have a maximum length that no comment reaches.
    lines = [f'{{"{key}", R"~~({text})~~"}},' for key, text in sorted(texts.items())]
    text = "\n".join(["// Written by documentation.py from the headers.", *lines, ""])
    path = Path(output)
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
