#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What came of each test of a run of ctest, one a line: passed|failed|skipped <tab> name <tab> reason.

    count_tests.py JUNIT REPORTS

JUNIT is what `ctest --output-junit` wrote. Where REPORTS holds <name>.xml, the report of a GoogleTest program that ctest
knows as <name>, the tests in it are counted instead. A program that ended before it wrote one has failed in the test that
it was in; one without any test has failed, for its filter names tests that do not exist.
"""
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SWITCHED_OFF = "switched off in its source"


def of_program(report):
    """The tests of a GoogleTest program."""
    # Messages of tests may hold bytes that are no text.
    for test in ElementTree.fromstring(report.read_bytes().decode("utf-8", "replace")).iter("testcase"):
        name = f'{test.get("classname")}.{test.get("name")}'
        skipped = test.find("skipped")
        if test.find("failure") is not None:
            yield "failed", name, ""
        elif test.get("status") == "notrun":
            yield "skipped", name, SWITCHED_OFF
        elif skipped is not None:
            # GoogleTest writes "file:line" before what the test says.
            message = (skipped.get("message") or skipped.text or "").strip().splitlines()
            yield "skipped", name, next((line for line in message[1:] if line.strip()), "no reason given")
        else:
            yield "passed", name, ""


def of_ctest(test):
    """A test that ctest knows and nobody else."""
    name, status = test.get("name"), test.get("status")
    output = test.findtext("system-out") or ""
    if status == "run":
        return "passed", name, ""
    if status == "fail":
        begun = re.findall(r"^\[ RUN      \] (\S+)", output, re.M)
        ended = re.findall(r"^\[(?:       OK|  FAILED  |  SKIPPED ) ?\] (\S+?),? ", output, re.M)
        inside = [one for one in begun if one not in ended][-1:]
        return "failed", f"{name}: ended in {inside[0]}" if inside else name, ""
    said = re.search(r"SKIPPED: (.+)", output)
    return "skipped", name, said.group(1) if said else SWITCHED_OFF if status == "disabled" else "no reason given"


def main():
    junit, reports = Path(sys.argv[1]), Path(sys.argv[2])
    for test in ElementTree.parse(junit).iter("testcase"):
        report = reports / f'{test.get("name")}.xml'
        results = list(of_program(report)) if report.is_file() else [of_ctest(test)]
        if test.get("status") == "fail" and not any(kind == "failed" for kind, _, _ in results):
            results.append(("failed", test.get("name"), ""))
        if not results:
            results = [("failed", f'{test.get("name")}: its filter names no test', "")]
        for result in results:
            print("\t".join(result))


if __name__ == "__main__":
    main()
