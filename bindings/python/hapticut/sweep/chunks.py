# SPDX-License-Identifier: Apache-2.0
"""What a worker does: some runs, one after the other, each with its own random numbers."""
from __future__ import annotations

import pickle
import time
import traceback
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from .._runs import none_taken_is_an_error
from .spaces import RESERVED, Parameters, plain

Run = Callable[[Parameters, np.random.Generator], Mapping[str, Any]]


class Row:
    """What became of one run: its summary and its traces, or its error."""

    def __init__(self, index: int):
        self.index = index
        self.summary: Parameters = {}
        self.traces: dict[str, NDArray[Any]] = {}
        self.error = ""

    def as_json(self) -> dict[str, Any]:
        return {"run": self.index, "summary": self.summary, "error": self.error, "traces": sorted(self.traces)}


class Chunk:
    """Rows and how long they took."""

    def __init__(self, rows: list[Row], seconds: float):
        self.rows = rows
        self.seconds = seconds


@lru_cache(maxsize=4)
def _function(pickled: bytes) -> Run:
    function: Run = pickle.loads(pickled)
    return function


def generator(seed: int, index: int) -> np.random.Generator:
    """The random numbers of a run: they depend on nothing but the study's seed and the run's index."""
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(index,)))


def _outcome(row: Row, result: Any, taken: frozenset[str]) -> None:
    if not isinstance(result, Mapping):
        raise TypeError(f"run returned {type(result).__name__}; it must return a dict of its summary")
    for name, value in result.items():
        if not isinstance(name, str):
            raise TypeError(f"run returned a column named {name!r}; names must be texts")
        if name in taken:
            raise ValueError(f"run returned a column named {name!r}, but there is a parameter or column of that name")
        if isinstance(value, np.ndarray) and value.ndim > 0:
            if value.dtype.hasobject:
                raise TypeError(f"run returned an array {name!r} of dtype {value.dtype}; it must hold plain numbers")
            row.traces[name] = value
        else:
            row.summary[name] = plain(value.item() if isinstance(value, np.ndarray) else value, f"column {name}")


def run_chunk(pickled: bytes, seed: int, first: Sequence[int], parameters: Sequence[Parameters]) -> Chunk:
    """The runs of some indices. A run that raises becomes a row with its error; the others go on."""
    function = _function(pickled)
    taken = frozenset(parameters[0]) | frozenset(RESERVED) if parameters else frozenset()
    rows = []
    begin = time.perf_counter()
    for index, row_parameters in zip(first, parameters):
        row = Row(index)
        try:
            with none_taken_is_an_error():
                result = function(dict(row_parameters), generator(seed, index))
            _outcome(row, result, taken)
        except (Exception, SystemExit) as error:
            row = Row(index)
            text = traceback.format_exception_only(type(error), error)[-1].strip().replace("\n", " ")
            row.error = text.encode("utf-8", "backslashreplace").decode()
        rows.append(row)
    return Chunk(rows, time.perf_counter() - begin)
