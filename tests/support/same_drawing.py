#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares two drawings in SVG: the same words, and numbers that differ by less than half a pixel.
Usage: same_drawing.py NEW IN_THE_DOCS"""
import re
import sys
from pathlib import Path

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[+-]?\d+)?")


def parts(file: str) -> tuple[list[str], list[float]]:
    text = Path(file).read_text(encoding="utf-8")
    return NUMBER.split(text), [float(number) for number in NUMBER.findall(text)]


(new_words, new), (old_words, old) = parts(sys.argv[1]), parts(sys.argv[2])
if new_words != old_words or any(abs(a - b) >= 0.5 for a, b in zip(new, old)):
    sys.exit(f"{sys.argv[2]} is not what the program draws: look at {Path(sys.argv[1]).resolve()}, and copy it there.")
