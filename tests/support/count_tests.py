#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lists the result of each test of a run of ctest, one per line: passed|failed|skipped <tab> name <tab> reason.

    count_tests.py JUNIT REPORTS

JUNIT is the file that `ctest --output-junit` wrote. If REPORTS contains <name>.xml, the report of a GoogleTest program
with the name <name> in ctest, the tests in that report are counted instead. These cases count as failed:

* a program that ended before it wrote its report: the test that was running; the results of earlier tests are kept
* a program without any test, because its filter names tests that do not exist
* a program that ctest could not start
"""
import re
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SWITCHED_OFF = "switched off in its source"


def of_program(report):
    """The tests of a GoogleTest program."""
    # Messages of tests may contain bytes that are not text, and characters that XML forbids.
    text = re.sub("[\0-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]", "?", report.read_bytes().decode("utf-8", "replace"))
    for test in ElementTree.fromstring(text).iter("testcase"):
        name = f'{test.get("classname")}.{test.get("name")}'
        skipped = test.find("skipped")
        if test.find("failure") is not None:
            yield "failed", name, ""
        elif test.get("status") == "notrun":
            yield "skipped", name, SWITCHED_OFF
        elif skipped is not None:
            # GoogleTest writes "file:line" before the message of the test.
            message = (skipped.get("message") or skipped.text or "").strip().splitlines()
            yield "skipped", name, next((line for line in message[1:] if line.strip()), "no reason given")
        else:
            yield "passed", name, ""


def of_output(name, output):
    """The tests of a GoogleTest program that left no report."""
    ended = re.findall(r"^\[ +(OK|FAILED|SKIPPED) +\] (\S+?)(?:,.*)? \(\d+ ms\)$", output, re.M)
    for outcome, test in ended:
        reason = "its program ended before it gave a reason" if outcome == "SKIPPED" else ""
        yield {"OK": "passed", "FAILED": "failed", "SKIPPED": "skipped"}[outcome], test, reason
    begun = re.findall(r"^\[ RUN +\] (\S+)$", output, re.M)
    inside = begun[-1] if len(begun) > len(ended) else "no test"
    yield "failed", f"{name}: ended in {inside}", ""


def of_ctest(test):
    """The result of a test without a report."""
    name, status = test.get("name"), test.get("status")
    output = test.findtext("system-out") or ""
    if re.search(r"^\[=+\] Running ", output, re.M):
        return of_output(name, output)
    if status == "run":
        return [("passed", name, "")]
    if status == "fail":
        return [("failed", name, "")]
    if status == "disabled":
        return [("skipped", name, SWITCHED_OFF)]
    skipped = test.find("skipped")
    why = "" if skipped is None else skipped.get("message") or ""
    if not why.startswith("SKIP_"):
        return [("failed", f"{name}: {why or 'was not run'}", "")]
    said = re.search(r"^SKIPPED: (.+)", output, re.M)
    return [("skipped", name, said.group(1) if said else "no reason given")]


def outcomes(test, report):
    """The results of a test of ctest, or of the tests in the report of its program."""
    if not report.is_file():
        return list(of_ctest(test))
    try:
        return list(of_program(report))
    except ElementTree.ParseError as fault:
        return [("failed", f'{test.get("name")}: its report cannot be read: {fault}', "")]


def main():
    junit, reports = Path(sys.argv[1]), Path(sys.argv[2])
    for test in ElementTree.parse(junit).iter("testcase"):
        results = outcomes(test, reports / f'{test.get("name")}.xml')
        if test.get("status") == "fail" and not any(kind == "failed" for kind, _, _ in results):
            results.append(("failed", test.get("name"), ""))
        if not results:
            results = [("failed", f'{test.get("name")}: its filter names no test', "")]
        for result in results:
            print("\t".join(result))


if __name__ == "__main__":
    main()
