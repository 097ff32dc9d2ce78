# SPDX-License-Identifier: Apache-2.0
"""The work of a worker: one run with its random numbers."""
from __future__ import annotations

import traceback
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Callable

import numpy as np
from numpy.typing import NDArray

from .._runs import no_steps_are_an_error
from .spaces import RESERVED, Parameters, plain

Run = Callable[[Parameters, np.random.Generator], Mapping[str, Any]]


@dataclass
class Outcome:
    """The result of one run: summary and traces, or an error."""

    index: int
    summary: Parameters = field(default_factory=dict)
    traces: dict[str, NDArray[Any]] = field(default_factory=dict)
    error: str = ""

    def store(self, result: Any, parameters: Parameters) -> None:
        """Divides the result of a run into summary and traces."""
        if not isinstance(result, Mapping):
            raise TypeError(f"run returned {type(result).__name__}; it must return a dict of its summary")
        for name, value in result.items():
            if not isinstance(name, str):
                raise TypeError(f"run returned a column named {name!r}; names must be texts")
            if name in parameters or name in RESERVED:
                raise ValueError(f"run returned a column named {name!r}; a parameter or column has that name")
            if not isinstance(value, np.ndarray) or value.ndim == 0:
                self.summary[name] = plain(value, f"column {name}")
            elif value.dtype.hasobject:
                raise TypeError(f"run returned an array {name!r} of dtype {value.dtype}; it must contain plain numbers")
            else:
                self.traces[name] = value


def generator(seed: int, index: int) -> np.random.Generator:
    """The random numbers of a run. They depend only on the study's seed and the run's index."""
    return np.random.default_rng(np.random.SeedSequence(seed, spawn_key=(index,)))


def outcome_of(run: Run, seed: int, index: int, parameters: Parameters) -> Outcome:
    """Makes a run. If it raises, the outcome has the error."""
    outcome = Outcome(index)
    try:
        with no_steps_are_an_error():
            result = run(dict(parameters), generator(seed, index))
        outcome.store(result, parameters)
        return outcome
    except (Exception, SystemExit) as error:
        text = traceback.format_exception_only(type(error), error)[-1].strip().replace("\n", " ")
        return Outcome(index, error=text.encode("utf-8", "backslashreplace").decode())
