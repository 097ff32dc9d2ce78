#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the messages of the browser page in TypeScript with those of the server in C++: the version, the kinds, the fields
of a snapshot and of each command. A name in TypeScript is the name in C++ or a part of it: `depth` is contact_depth.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
READ = {"std::uint32_t": "u32", "std::uint64_t": "u64", "double": "f64", "Vec3": "vec", "Pose": "pose"}
WRITTEN = {"AngularSpeed": ["f64"], "double": ["f64"], "bool": ["u8"], "std::uint16_t": ["u16"], "Vec3": ["all"],
           "Pose": ["all", "all"], "std::string": ["text"]}


def text_of(path):
    """A source without comments."""
    return re.sub(r"/\*.*?\*/|//[^\n]*", "", (ROOT / path).read_text(encoding="utf-8"), flags=re.S)


def is_part(name, whole):
    return name.replace("_", "").lower() in whole.replace("_", "").lower()


def members(source, struct):
    """Type and name of each member of a plain struct."""
    body = re.search(rf"struct {struct} \{{(\}};|.*?\n\}};)", source, re.S)[1]
    return re.findall(r"([\w:]+) (\w+)(?: = [^;]*)?;", body)


def snapshot_of_the_server(source):
    """Name and type of each number that encode(const LoopSnapshot&) adds."""
    header = text_of("include/hapticut/loop/snapshot.hpp")
    types = {name: kind for struct in ("LoopSnapshot", "ToolSnapshot") for kind, name in members(header, struct)}
    body = source[source.index("Message encode(const LoopSnapshot&"):].split("\n}\n")[0]
    for cast, name in re.findall(r"\.add\((std::uint32_t\()?(?:snapshot\.|tool\.)?(\w+)\)", body):
        yield name, "u32" if cast or name == "flags" else READ[types[name]]


def compare_snapshots(server, page):
    body = page[page.index("case 3:"):page.index("case 4:")]
    own, theirs = list(snapshot_of_the_server(server)), re.findall(r"(\w+) = r\.(\w+)\(\)", body)
    if len(own) < 15:
        yield "protocol.cpp: too few fields of a snapshot were found: the search for them is broken"
    for n in range(max(len(own), len(theirs))):
        cpp, ts = own[n] if n < len(own) else ("nothing", ""), theirs[n] if n < len(theirs) else ("nothing", "")
        if cpp[1] != ts[1] or not is_part(ts[0], cpp[0]):
            yield f"protocol.ts: reads {' '.join(ts)} of a snapshot where the server adds {' '.join(cpp)}"
            return


def compare_commands(header, page):
    """The order of ViewCommand gives the kinds; fields follow in the order of their description."""
    order = re.findall(r"(?:commands::)?(\w+)", header[header.index("using ViewCommand = std::variant<"):].split("<")[1].split(">")[0])
    order = [name for name in order if name not in ("commands", "WriterLeft")]
    structs = header + text_of("include/hapticut/loop/commands.hpp")
    table = page[page.index("export const commands"):]
    theirs = {int(kind): (name, re.findall(r"\.(u8|u16|f64|all|text)\(", calls))
              for name, kind, calls in re.findall(r"(\w+): \([^)]*\) =>\s*new Writer\((\d+)\)(.*?)\.finish\(\)", table)}
    for kind, command in enumerate(order, 1):
        fields = [one for cpp_type, _ in members(structs, command) for one in WRITTEN[cpp_type]]
        name, written = theirs.pop(kind, ("nothing", None))
        if written != fields or not is_part(name, command):
            yield f"protocol.ts: writes {name} {written} as command {kind}, which is {command} {fields}"
    for kind, (name, _) in theirs.items():
        yield f"protocol.ts: writes {name} as command {kind}, which the server does not know"


def main():
    header, server = text_of("apps/page/include/hapticut/view/protocol.hpp"), text_of("apps/page/server/protocol.cpp")
    page = text_of("apps/page/web/src/protocol.ts")
    mistakes = []
    version, own = re.search(r"kProtocolVersion = (\d+)", header)[1], re.search(r"kVersion = (\d+)", page)[1]
    if version != own:
        mistakes.append(f"protocol.ts: the version is {own}, in protocol.hpp {version}")
    kinds = re.findall(r"(\w+) = (\d+),", re.search(r"enum class MessageKind.*?\};", header, re.S)[0])
    read = re.findall(r'case (\d+): \{.*?kind: "(\w+)"', page, re.S)
    if [(name, number) for number, name in read] != kinds:
        mistakes.append(f"protocol.ts: reads the messages {read}, MessageKind has {kinds}")
    mistakes += [*compare_snapshots(server, page), *compare_commands(header, page)]
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    sys.exit(1 if mistakes else 0)


if __name__ == "__main__":
    main()
