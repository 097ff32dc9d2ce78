#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the table of docs/step.md with the code: its stages are the fields of StageTimes in their order, each stage is
defined in the file that the table names, and the step calls the stages in this order. The drawing of the page shows
each stage.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def rows():
    """Stage and file of each row of the first table of the page."""
    page = (ROOT / "docs/step.md").read_text(encoding="utf-8")
    table = page[page.index("| stage |"):].split("\n\n")[0]
    return re.findall(r"^\| `(\w+)` \|.*\| (\S+) \|$", table, re.M)


def body_of(function, code):
    body = code[code.index(f"::{function}("):]
    return body[:body.index("\n}\n")]


def main():
    mistakes = []
    documented = rows()
    header = (ROOT / "include/hapticut/simulation/stage_times.hpp").read_text(encoding="utf-8")
    fields = re.findall(r"^  double (\w+) = 0;", header, re.M)
    if [stage for stage, _ in documented] != fields:
        mistakes.append(f"docs/step.md lists {[s for s, _ in documented]}, StageTimes has {fields}")
    drawn = set(re.findall(r">(\w+)</text>", (ROOT / "docs/images/step.svg").read_text(encoding="utf-8")))
    if missing := [field for field in fields if field not in drawn]:
        mistakes.append(f"docs/images/step.svg does not show {missing}")
    step = (ROOT / "src/simulation/step.cpp").read_text(encoding="utf-8")
    body = body_of("take_step", step).replace("take_sub_steps(", body_of("take_sub_steps", step))
    place = 0
    for stage, file in documented:
        defines = re.search(rf"^[\w:<>&\[\] ]*(?<=[ :]){stage}\(", (ROOT / file).read_text(encoding="utf-8"), re.M)
        if not defines:
            mistakes.append(f"{file} does not define {stage}, as docs/step.md says")
        call = re.search(rf"\b(?:{stage}|{stage.replace('check_input', 'check_step_input')})\(", body[place:])
        if call is None:
            mistakes.append(f"take_step does not call {stage} after the previous stage")
        else:
            place += call.end()
    for mistake in mistakes:
        print(mistake, file=sys.stderr)
    if len(documented) < 8 or mistakes:
        sys.exit("docs/step.md and the step differ" if mistakes else "docs/step.md has no table of stages")


if __name__ == "__main__":
    main()
