# SPDX-License-Identifier: Apache-2.0
"""Many runs over many parameters, on a laptop or a cluster: ``hapticut.sweep(space, run, ...)``.

The results depend on the space, the seed and the function alone: not on the executor, the number of workers or the
order in which the runs end. A sweep that was killed goes on where it was.
"""
from __future__ import annotations

import os
import sys
import types
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from typing import TYPE_CHECKING, Any, Optional, Union

from .._export import export
from .._hapticut import Error
from .chunks import Run, generator
from .scheduler import Scheduler, SerialExecutor
from .spaces import Parameters, Space, design, grid, latin_hypercube, sobol, space_from, whole
from .study import Study, load_traces

if TYPE_CHECKING:
    import pandas as pd

__all__ = ["Parameters", "Run", "SerialExecutor", "Space", "design", "generator", "grid", "latin_hypercube",
           "load_traces", "main", "sobol", "sweep"]


def name_of(run: Run) -> str:
    """What a study calls its function."""
    return str(getattr(run, "__qualname__", type(run).__qualname__))


def sweep(space: Union[Space, Mapping[str, Sequence[Any]], Sequence[Mapping[str, Any]]], run: Run,
          executor: Optional[Executor] = None, out: Union[str, "os.PathLike[str]"] = "out/sweep", *,
          resume: bool = True, seed: int = 0, units: Optional[Mapping[str, str]] = None,
          workers: Optional[int] = None, progress: bool = True) -> pd.DataFrame:
    """Makes a run for every set of parameters, and returns the table of the results.

    Parameters
    ----------
    space
        `grid`, `latin_hypercube`, `sobol` or `design`; a dict of lists is a grid, a list of dicts a list of runs.
    run
        Called as ``run(parameters, rng)`` with a dict and a `numpy.random.Generator` of its own. Returns a dict of
        numbers and texts, which become columns, and of arrays, which `load_traces` finds again. A run that raises is a
        row with its error; so is one whose simulation took none of its steps. With a pool of processes it must be at the top level of a module, and a script needs
        ``if __name__ == "__main__":`` around what it does.
    executor
        None: a pool of one process per processor. Else any `concurrent.futures.Executor`, which stays open:
        ``dask.distributed.Client(...).get_executor()`` for a cluster, an MPI pool, `SerialExecutor()`.
    out
        The folder of the study. Every chunk of about a second of work is a file in it, so that nothing is lost.
    resume
        Go on with what is in the folder; False: refuse a folder that holds runs.
    seed
        Of the study. The random numbers of a run follow from it and the run's index.
    units
        dict from a column to its unit, kept with the table.
    workers
        Processes of the pool, or how many the executor has; None: as many as there are processors.
    progress
        A progress bar, where tqdm is there.

    Returns
    -------
    pandas.DataFrame
        One row per run in the order of the space: run, parameters, summary columns, error (missing where there is none);
        ``attrs["units"]``. The same is in ``table.parquet`` in the folder, or ``table.csv`` where pyarrow is missing.

    Raises
    ------
    Error
        When the space is empty, the folder cannot be written or holds another study, or the executor dies. What was
        finished is kept.

    Warns
    -----
    UserWarning
        When a column mixes texts and numbers, so that the table is written as CSV, not Parquet.
    """
    try:
        import pandas  # noqa: F401
    except ImportError:
        raise Error("sweeps need pandas: pip install 'hapticut[sweep]'.") from None
    if not callable(run):
        raise Error(f"run is {run!r}; it must be a function of a dict of parameters and a generator.")
    if executor is not None and not isinstance(executor, Executor):
        hint = " (a Client of dask has one: get_executor())" if hasattr(executor, "get_executor") else ""
        raise Error(f"executor is {executor!r}; it must be a concurrent.futures.Executor{hint}.")
    if units is not None and not isinstance(units, Mapping):
        raise Error(f"units are {units!r}; needed is a dict from a column to its unit.")
    if workers is not None:
        workers = whole(workers, "workers", 1)
    seed = whole(seed, "seed", 0)
    points = space_from(space)
    study = Study(out, points, name_of(run), seed, units or {}, resume)
    missing = study.missing()
    if missing:
        scheduler = Scheduler(points, run, seed, missing, executor, workers)
        with _Bar(len(points), len(points) - len(missing), progress) as bar:
            chunks = scheduler.chunks()
            try:
                for chunk in chunks:
                    study.keep(chunk.rows)
                    bar.advance(len(chunk.rows))
            finally:
                chunks.close()
    return study.write_table()[0]


class _Bar:
    """A progress bar, or nothing."""

    def __init__(self, total: int, done: int, wanted: bool):
        self._bar: Any = None
        if wanted:
            try:
                from tqdm import tqdm
            except ImportError:
                return
            self._bar = tqdm(total=total, initial=done, unit="run", disable=None)

    def advance(self, runs: int) -> None:
        if self._bar is not None:
            self._bar.update(runs)

    def __enter__(self) -> _Bar:
        return self

    def __exit__(self, *_: object) -> None:
        if self._bar is not None:
            self._bar.close()


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """The command `hapticut-sweep`."""
    from .command import main as command

    return command(arguments)


class _CallableModule(types.ModuleType):
    """So that `hapticut.sweep` is the function as well as the module of what belongs to it."""

    def __call__(self, *arguments: Any, **keywords: Any) -> pd.DataFrame:
        return sweep(*arguments, **keywords)


export(__name__)
sys.modules[__name__].__class__ = _CallableModule
