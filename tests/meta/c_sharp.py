#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares lists of C's interface that no compiler compares. Each difference names the place to change.

  C#     the structs of Structs.cs have the fields of HEADERS, its enumerations the values
  tests  every_layout of tests/unit/c/layout.h has each field of HEADERS
  C++    hapticut_command_kind has the name and the place of each command in LoopCommand that one number can make
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
HEADERS = ["include/hapticut/c/types.h", "include/hapticut/c/heat_types.h"]
NOT_IN_C_SHARP = {"energy_ledger", "probe_result", "coupling_gains"}
OTHER_NAMES = {"page": "NativePage"}  # names of structs in C#; else PascalCase
OTHER_FIELDS = {("Pose", "r00"), ("LoopOptions", "given"), ("Vertex", "x"), ("Vertex", "nx")}  # C# names them unlike C
MORE_THAN_A_NUMBER = {"SetFriction", "SetEffects"}  # described commands that C cannot send
TYPES = {"uint32_t": ["u32"], "int32_t": ["i32"], "uint64_t": ["u64"], "double": ["f64"], "int16_t": ["i16"], "int8_t": ["i8"],
         "uint8_t": ["u8"], "uint": ["u32"], "int": ["i32"], "ulong": ["u64"], "short": ["i16"], "sbyte": ["i8"], "byte": ["u8"],
         "IntPtr": ["pointer"], "hapticut_pose": 12 * ["f64"]}


def text_of(path):
    """A source without comments."""
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", (ROOT / path).read_text(encoding="utf-8"), flags=re.S)


def pascal(name):
    return "".join(word.capitalize() for word in name.lower().split("_"))


def structs_of_c(source):
    """For each struct its fields: name and primitive types."""
    structs = {}
    for name, body in re.findall(r"typedef struct hapticut_(\w+) \{(.*?)\} hapticut_\w+;", source, re.S):
        structs[name] = []
        for kind, pointer, field, count in re.findall(r"(?:const )?(\w+)\s*(\*?)\s*(\w+)(?:\[(\d+)\])?;", body):
            types = ["pointer"] if pointer else [f"char[{count}]"] if kind == "char" else TYPES[kind] * int(count or 1)
            structs[name].append((field, types))
    return structs


def structs_of_c_sharp(source):
    enumerations = set(re.findall(r"enum (\w+) : uint", source))
    fields = {}  # type and name
    for name, body in re.findall(r"struct (\w+) \{\n(.*?)\n  \}", source, re.S):
        fields[name] = [(f"char[{size}]" if size else kind, field)
                        for size, kind, names in re.findall(r"^    (?:\[MarshalAs\(UnmanagedType.ByValArray, SizeConst = (\d+)\)\] )?"
                                                            r"(?:public|internal) ([\w\[\]]+) ([\w, \n]+);", body, re.M)
                        for field in re.split(r",\s*", names)]

    def primitives(kind):
        if kind in fields:
            return [one for inner, _ in fields[kind] for one in primitives(inner)]
        return ["u32"] if kind in enumerations else TYPES.get(kind, [kind])

    return {name: [(field, primitives(kind)) for kind, field in all_of_it] for name, all_of_it in fields.items()}


def compare_structs(c, c_sharp):
    for name, fields in c.items():
        theirs = c_sharp.get(OTHER_NAMES.get(name, pascal(name)))
        if (theirs is None) != (name in NOT_IN_C_SHARP):
            yield f"Structs.cs: hapticut_{name} is {'absent' if theirs is None else 'in NOT_IN_C_SHARP of c_sharp.py'}"
        if theirs is None:
            continue
        starts = {}  # for the number of primitives before a field, its name in C
        for field, types in fields:
            starts[sum(len(before) for _, before in fields[:len(starts)])] = field
        flat = [one for _, types in fields for one in types]
        at = 0
        for field, types in theirs:
            own, their = (word.replace("_", "").lower() for word in (starts.get(at, ""), field))
            alike = not own or their in own or own in their
            unlike = (OTHER_NAMES.get(name, pascal(name)), field) in OTHER_FIELDS
            if flat[at:at + len(types)] != types or not (alike or unlike):
                yield f"Structs.cs: {field} of hapticut_{name} stands where types.h has {starts.get(at, 'another type')}"
                break
            at += len(types)
        else:
            if at != len(flat):
                yield f"Structs.cs: hapticut_{name} ends before {starts.get(at, 'its last field')}"


def enums(source, pattern):
    return {name: dict((key, int(value)) for key, value in re.findall(r"(\w+) = (-?\d+)", body))
            for name, body in re.findall(pattern, source, re.S)}


def compare_enums(c, c_sharp):
    of_c_sharp = enums(c_sharp, r"enum (\w+) : uint \{(.*?)\}")
    for name, values in enums(c, r"enum hapticut_(\w+) \{(.*?)\};").items():
        theirs = of_c_sharp.get(pascal(name)) or of_c_sharp.get(pascal(name) + "s")
        # "HAPTICUT_ARMING_WAIT_FREE" is WaitFree
        own = {pascal(re.sub(rf"^HAPTICUT_{name.split('_')[0].upper()}_", "", key)): value for key, value in values.items()}
        if name != "result" and theirs != own:
            yield f"Structs.cs: values of hapticut_{name} are {theirs}, in types.h {own}"


def compare_layout(c):
    header = (ROOT / "tests/unit/c/layout.h").read_text(encoding="utf-8")
    listed = {(name, field) for name, fields in re.findall(r"STRUCT\(hapticut_(\w+),((?:\s*F\(\w+\))*)\)", header)
              for field in re.findall(r"F\((\w+)\)", fields)}
    for name, field in sorted(listed ^ {(name, field) for name, fields in c.items() for field, _ in fields}):
        yield f"layout.h: hapticut_{name}.{field} is {'not in types.h' if (name, field) in listed else 'absent'}"


def compare_commands(c):
    header = text_of("include/hapticut/loop/commands.hpp")
    order = re.findall(r"commands::(\w+)", header[header.index("using LoopCommand"):].split(";")[0])
    without_fields = set(re.findall(r"struct (\w+) \{\s*\};", header))
    described = set(re.findall(r"fields_of\(Of<(\w+)>\)", header)) | without_fields
    wanted = {name: place for place, name in enumerate(order, 1) if name in described - MORE_THAN_A_NUMBER}
    kinds = enums(c, r"enum hapticut_(\w+) \{(.*?)\};")["command_kind"]
    own = {pascal(re.sub("^HAPTICUT_COMMAND_", "", key)): value for key, value in kinds.items()}
    for name in sorted(wanted.keys() | own.keys()):
        if wanted.get(name) != own.get(name):
            yield f"types.h: the kind of {name} is {own.get(name)}, its place in LoopCommand is {wanted.get(name)}"
    if len(wanted) < 10:
        yield "commands.hpp: too few commands were found: the search for them is broken"


def main():
    c, c_sharp = "".join(map(text_of, HEADERS)), text_of("bindings/csharp/Structs.cs")
    structs = structs_of_c(c)
    mistakes = [*compare_structs(structs, structs_of_c_sharp(c_sharp)), *compare_enums(c, c_sharp), *compare_layout(structs),
                *compare_commands(c)]
    if len(structs) < 20:
        mistakes.append("types.h: too few structs were found: the search for them is broken")
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    sys.exit(1 if mistakes else 0)


if __name__ == "__main__":
    main()
