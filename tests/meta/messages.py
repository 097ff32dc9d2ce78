#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the names in messages (core/sentence.hpp).

No code searches a message of the library, and the page searches no sentence. In a message each C++ name and each key of
a setting is a Name. Each Name exists in the headers or is the key of a setting; program, C and Python have a word for
it; each word of a table exists and is used. No public header has consteval, so that names in templates link with clang
14.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM, C, KEYS = "apps/reports/flag_words.cpp", "src/c/words_of_c.cpp", "src/settings/names.cpp"
SENTENCE, C_HEADERS = "include/hapticut/core/sentence.hpp", "include/hapticut/c/"
HEAD, COMMANDS = "include/hapticut/tool/head.hpp", "include/hapticut/loop/commands.hpp"

# They search messages of other libraries, which have no types.
OF_OTHERS = {"src/core/lack_of_memory.hpp", "src/import/mesh/assimp.cpp", "src/io/recording/hdf5.cpp",
             "src/import/volume/itk_volume.cpp", "src/import/volume/tiff_file.cpp", "src/settings/settings_file.cpp"}
SEARCHED = re.compile(r"(?:what\(\)\)?|\b(?:reason|message|sentence|said|complaint|failure|missing)_?)"
                      r"\.(?:r?find\w*|starts_with|ends_with|contains|replace|erase)\(|\bstd::w?regex\b")
OF_THE_PAGE = "apps/page/web/src"
SEARCHED_BY_THE_PAGE = re.compile(r"\.(?:startsWith|endsWith|includes|indexOf|search|match)\(\s*[\"'`/][^)\n]*\)")
MESSAGE = re.compile(r"\b(?:Error|FileError|Failure|UsageError|cannot_read|cannot_write|fail|fail_missing|refuse|"
                     r"required|require_at_most|require_points|warn)\("
                     r"((?:[^;\"]|\"(?:[^\"\\]|\\.)*\")*);")
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"(_name)?')
CPP_NAME = re.compile(r"\b[A-Z]\w*::\w+")
KEY_AND_FLAG = re.compile(r'"([a-z]+)\.\w+",\s*"--\w+"')

# Users of the program and of C do not have these structs, or their settings are checked first, in their own words. If a
# message names a member, it stands without the struct. The structs of drivers/*/include are such, and not in Python.
IN_CODE_ONLY = {
    "ClosedLoop", "ClosedLoopConfig", "CouplingGains", "DeltaFilter", "Device", "DryFriction", "GridFrame",
    "GridImport", "GuardOptions", "HeatField", "IslandOptions", "Material", "Profile", "Shank", "Spindle",
    "StabilitySearch", "Vibration", "Volume", "Workpiece", "WorkspaceMapOptions"}
NOT_IN_PYTHON = {"GridImport", "units"}


def sources() -> dict[str, str]:
    files = [path for folder in ("src", "include", "drivers", "apps", "bindings/python") for path in sorted((ROOT / folder).rglob("*"))
             if path.suffix in (".hpp", ".cpp", ".inl", ".h", ".py") and not {"tests", "node_modules"} & set(path.parts[len(ROOT.parts):])]
    return {str(path.relative_to(ROOT)): path.read_text(encoding="utf-8") for path in files}


def pairs(text: str, table: str) -> dict[str, str]:
    """The pairs of texts of a table in C++."""
    body = text[text.index(table + "[]"):]
    return dict(re.findall(r'\{"([^"]+)",\s*"([^"]*)"\}', body[:body.index("};")]))


def numbers_of_shapes(code: dict[str, str]) -> set[str]:
    """The numbers of the shapes of ToolHead, as ConeHead::height. Their keys follow from fields_of."""
    shapes = re.search(r"using Shape = std::variant<([^>]*)>", code[HEAD])[1].split(", ")
    fields = re.findall(r'\bfield\("\w+",\s*&(\w+)::(\w+),\s*"[^"]*",', "".join(code.values()))
    return {f"{shape}::{field}" for shape, field in fields if shape in shapes}


def words_in(text: str) -> set[str]:
    return set(re.findall(r"\w+", text))


def keys_in(code: dict[str, str]) -> re.Pattern:
    """A key of a setting in a text: tool.radius_mm."""
    tables = set().union(*(KEY_AND_FLAG.findall(text) for path, text in code.items() if path != PROGRAM))
    return re.compile(rf"(?<![\w./-])(?:{'|'.join(sorted(tables))})\.[a-z]\w*")


def check_page() -> list[str]:
    return [f"{path.relative_to(ROOT)} searches a sentence: {found.group()}"
            for path in sorted((ROOT / OF_THE_PAGE).rglob("*.ts"))
            for found in SEARCHED_BY_THE_PAGE.finditer(path.read_text(encoding="utf-8"))]


def check_code(code: dict[str, str]) -> tuple[set[str], set[str], list[str]]:
    """The Names of all messages, the subjects of all checks, and the mistakes."""
    names, subjects, mistakes, key = set(), set(), [], keys_in(code)
    for path, text in code.items():
        if path == SENTENCE:
            continue
        text = re.sub(r"^\s*//.*$", "", text, flags=re.M)
        if path not in OF_OTHERS and (found := SEARCHED.search(text)):
            mistakes.append(f"{path} searches a message: {found.group()}")
        for literal, is_name in LITERAL.findall(" ".join(MESSAGE.findall(text))):
            if not is_name and (found := CPP_NAME.search(literal) or key.search(literal)):
                mistakes.append(f'{path} types {found.group()} into a message; write "{found.group()}"_name')
        names |= set(re.findall(r'"([^"]+)"_name', text))
        subjects |= set(re.findall(r'require_\w+\([^;]*?"([A-Z]\w*::\w*)', text))
    return names, subjects, mistakes


def main() -> int:
    code = sources()
    of_drivers = {struct for path, text in code.items() if re.match("drivers/[^/]+/include/", path)
                  for struct in re.findall(r"^struct (\w+)", text, re.M)}
    names, subjects, mistakes = check_code(code)
    mistakes += check_page()
    mistakes += [f"{path} has consteval; clang 14 leaves undefined calls of it in templates"
                 for path, text in code.items() if path.startswith("include/") and re.search(r"\bconsteval\b", text)]
    headers = [text for path, text in code.items() if "include/" in path]
    in_headers = set().union(*map(words_in, headers))
    in_python = words_in("".join(text for path, text in code.items() if path.startswith("bindings")))
    settings = "".join(text for path, text in code.items()
                       if path.startswith(("src/settings", "apps")) and path not in (KEYS, PROGRAM))
    program, c, scopes_of_c, keys = (pairs(code[path], table) for path, table in
                                     ((PROGRAM, "kWords"), (C, "kWords"), (C, "kScopes"), (KEYS, "kKeys")))

    def is_declared(name: str) -> bool:
        scope, _, member = name.rpartition("::")
        first, *inner = member.split(".")
        declared = re.compile(rf"\b(?:struct|class|namespace) {scope}\b" if scope else "")
        return in_headers >= set(inner) and any(declared.search(text) and (not first or first in words_in(text))
                                                for text in headers)

    def is_setting(key: str) -> bool:
        table, _, member = key.partition(".")
        return any(f'"{text}"' in settings for text in (key, member))

    is_key = {name: "::" not in name and "." in name for name in names}
    mistakes += [f"no setting has the key {name}" for name in names if is_key[name] and not is_setting(name)]
    mistakes += [f"no header declares {name}" for name in names | subjects
                 if not is_key.get(name) and not is_declared(name)]
    of_shapes = numbers_of_shapes(code)
    of_commands = set(re.findall(r"^struct (\w+)", code[COMMANDS], re.M))  # C has a word for each
    if len(of_shapes) < 5:
        mistakes.append(f"only {len(of_shapes)} numbers of shapes were found; has {HEAD} changed?")
    for name in sorted(name for name in names if not is_key[name]):
        scope = name.rpartition("::")[0]
        for where, words, scopes in ((PROGRAM, program, set()), (C, c, set(scopes_of_c) | of_commands)):
            if name not in {*words, *keys, *of_shapes} and scope not in scopes | IN_CODE_ONLY | of_drivers:
                mistakes.append(f"{where} has no word for {name}")
        if not {scope, name} & (NOT_IN_PYTHON | of_drivers) and (scope or name) not in in_python:
            mistakes.append(f"Python has no {name}")
    mistakes += [f"{where} has {name}, which no message names"
                 for where, words in ((PROGRAM, program), (C, c), (KEYS, keys)) for name in words
                 if name not in names | subjects and name.rpartition("::")[0] + "::" not in subjects]
    mistakes += [f"{PROGRAM} has the flag {flag}, which no command has"
                 for flag in re.findall(r"--\w+", " ".join(program.values())) if f'"{flag}"' not in settings]
    mistakes += [f"{KEYS} has the key {key}, which no setting has" for key in keys.values() if not is_setting(key)]
    of_c = "".join(text for path, text in code.items() if path.startswith(C_HEADERS))
    for word in re.findall(r"HAPTICUT_\w+|hapticut_\w+\.?\w*", " ".join((c | scopes_of_c).values())):
        struct, _, member = word.partition(".")
        body = of_c.split(f"}} {struct};")[0].rpartition("typedef struct")[2] if member else of_c
        if (member or struct) not in words_in(body):
            mistakes.append(f"{C} has {word}, which no header of C declares")
    print(f"{len(names)} names in messages, {len(mistakes)} mistakes", *mistakes, sep="\n")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
