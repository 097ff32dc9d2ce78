# SPDX-License-Identifier: Apache-2.0
"""Many runs over many parameters, on a laptop or a cluster: ``hapticut.sweep(space, run, ...)``.

The results depend on the space, the seed and the function alone: not on the executor, the number of workers or the
order in which the runs end. A killed sweep continues where it stopped.
"""
from __future__ import annotations

import contextlib
import multiprocessing
import os
import signal
import sys
import types
from collections.abc import Iterable, Iterator, Mapping, Sequence
from concurrent.futures import BrokenExecutor, Executor, Future, ProcessPoolExecutor, as_completed
from contextlib import ExitStack
from typing import TYPE_CHECKING, Any, Optional, Union

from .._export import export
from .._hapticut import Error
from .outcome import Outcome, Run, generator, outcome_of
from .spaces import Parameters, design, grid, latin_hypercube, points_of, sobol, whole
from .study import Study, load_traces

if TYPE_CHECKING:
    import pandas as pd

    from . import outcome, spaces
    from . import study as study_

__all__ = ["Parameters", "Run", "design", "generator", "grid", "latin_hypercube", "load_traces", "sobol", "sweep"]


def sweep(space: Union[Mapping[str, Sequence[Any]], Sequence[Mapping[str, Any]]], run: Run,
          executor: Optional[Executor] = None, out: Union[str, "os.PathLike[str]"] = "out/sweep", *,
          resume: bool = True, seed: int = 0, units: Optional[Mapping[str, str]] = None,
          workers: Optional[int] = None, progress: bool = True) -> pd.DataFrame:
    """Makes a run for every set of parameters, and returns the table of the results.

    Parameters
    ----------
    space
        `grid`, `latin_hypercube`, `sobol` or `design`; or a dict of lists (a grid), or a list of dicts (one per run).
    run
        Called as ``run(parameters, rng)`` with a dict and a separate `numpy.random.Generator`. Returns a dict: numbers
        and texts become columns, `load_traces` loads arrays. If a run raises, or its simulation made no step, its row
        has the error. With a pool of processes, ``run`` must be at the top level of a module, and a script needs
        ``if __name__ == "__main__":`` around its code.
    executor
        None: a pool with one process per processor. Or any `concurrent.futures.Executor`, which stays open:
        ``dask.distributed.Client(...).get_executor()``, ``mpi4py.futures.MPIPoolExecutor()``, a pool of threads.
    out
        The folder of the study. Every finished run adds a line, so no run is lost.
    resume
        True: continue the study in the folder. False: refuse a folder that contains runs. Two studies are the same if
        their space, seed, version of hapticut and ``run`` are equal. The comparison of ``run`` includes its module,
        name, code, defaults, and the values that it has (closure, partial, instance), but not the functions that it
        calls.
    seed
        Seed of the study. It and the run's index determine the random numbers of a run.
    units
        dict from a column to its unit, kept with the table.
    workers
        Number of processes of the pool; None: number of processors.
    progress
        Shows a progress bar if tqdm is installed.

    Returns
    -------
    pandas.DataFrame
        One row per run in the order of the space: run, parameters, summary columns, error (missing without an
        error); ``attrs["units"]``. The file ``table.csv`` in the folder has the table too.

    Raises
    ------
    Error
        When the space is empty, the folder cannot be written or contains another study, or the executor dies. Finished
        runs are kept.
    KeyboardInterrupt
        After Ctrl-C, within a second. Finished runs are kept: call sweep again to continue. The processes of the
        default pool are ended; an executor that you pass finishes the runs that it has begun.
    """
    try:
        import pandas  # noqa: F401
    except ImportError:
        raise Error("sweeps need pandas: install the extra `sweep`, e.g. pip install '.[sweep]' in the source "
                    "folder.") from None
    if not callable(run):
        raise Error(f"run is {run!r}; it must be a function of a dict of parameters and a generator.")
    if executor is not None and not isinstance(executor, Executor):
        hint = " (a Client of dask has one: get_executor())" if hasattr(executor, "get_executor") else ""
        raise Error(f"executor is {executor!r}; it must be a concurrent.futures.Executor{hint}.")
    if units is not None and not isinstance(units, Mapping):
        raise Error(f"units are {units!r}; they must be a dict from a column to its unit.")
    processes = len(os.sched_getaffinity(0)) if workers is None else whole(workers, "workers", 1)
    seed = whole(seed, "seed", 0)
    points = points_of(space)
    study = Study(out, points, run, seed, resume)
    missing = study.missing()
    with ExitStack() as stack:
        owned = executor is None
        if executor is None and missing:
            # A forked child of a process with threads may hang; a spawned one does not.
            context = multiprocessing.get_context("spawn")
            executor = stack.enter_context(_ended_by_interrupts(
                ProcessPoolExecutor(processes, mp_context=context, initializer=_leave_interrupts_to_the_parent)))
        if executor is not None:
            _make(study, missing, run, seed, executor, processes if owned else 0, progress)
    return study.table(units or {})


def _leave_interrupts_to_the_parent() -> None:
    """In a worker: a terminal sends Ctrl-C to all its processes, but only the parent knows which results to keep."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)


@contextlib.contextmanager
def _ended_by_interrupts(pool: ProcessPoolExecutor) -> Iterator[ProcessPoolExecutor]:
    """Waits at the end for the processes of a pool; ends them when an exception such as KeyboardInterrupt leaves."""
    try:
        yield pool
    except BaseException:
        for process in list((getattr(pool, "_processes", None) or {}).values()):
            process.terminate()
        raise
    finally:
        pool.shutdown(cancel_futures=True)


def _make(study: Study, missing: Sequence[int], run: Run, seed: int, executor: Executor, processes: int,
          progress: bool) -> None:
    """Submits the missing runs to the executor, and stores each finished run.

    Parameters
    ----------
    processes
        Number of processes of the pool of this sweep; 0: another executor.
    """
    futures: set[Future[Outcome]] = set()
    failure: Optional[Exception] = None  # of the executor; outcome_of does not raise
    try:
        try:
            for index in missing:
                futures.add(executor.submit(outcome_of, run, seed, index, study.space[index]))
        except Exception as error:
            failure = error
        for future in _with_bar(as_completed(futures), len(study.space), len(missing), progress):
            try:
                outcome = future.result()
            except Exception as error:
                failure = failure or error
            else:
                study.keep(outcome)
            futures.discard(future)  # frees its traces
    except BaseException:  # KeyboardInterrupt
        for future in futures:
            # The own pool ends its processes next, and fails at a cancelled run whose process dies.
            cancelled = processes == 0 and future.cancel()
            if not cancelled and future.done() and future.exception() is None:
                study.keep(future.result())  # finished, but not stored yet
        raise
    if failure is not None:
        killer = ""
        if isinstance(failure, BrokenExecutor) and processes:
            # The pool starts the runs in this order, so the runs that its processes were making are among these.
            suspects = ", ".join(map(str, study.missing()[:processes]))
            killer = (f" A process of the pool died, probably in run {suspects}: call run with those parameters alone "
                      "to find out why.")
        raise Error(f"the executor failed ({type(failure).__name__}: {failure}).{killer} Finished runs are kept: call "
                    "sweep again to continue. The workers need hapticut and the module of run, and a script `if "
                    "__name__ == \"__main__\":` around its code.") from failure


def _with_bar(finished: Iterable[Future[Outcome]], total: int, missing: int, shown: bool) -> Iterable[Future[Outcome]]:
    """Adds a progress bar if tqdm is installed."""
    try:
        from tqdm import tqdm
    except ImportError:
        return finished
    bar: Iterable[Future[Outcome]] = tqdm(finished, total=total, initial=total - missing, unit="run",
                                          disable=None if shown else True)
    return bar


class CallableModule(types.ModuleType):
    """Makes `hapticut.sweep` both a function and a module."""

    if TYPE_CHECKING:
        __call__ = staticmethod(sweep)
        sweep = staticmethod(sweep)
        design = staticmethod(spaces.design)
        generator = staticmethod(outcome.generator)
        grid = staticmethod(spaces.grid)
        latin_hypercube = staticmethod(spaces.latin_hypercube)
        load_traces = staticmethod(study_.load_traces)
        sobol = staticmethod(spaces.sobol)
    else:

        def __call__(self, *arguments, **keywords):
            return sweep(*arguments, **keywords)


export(__name__)
sys.modules[__name__].__class__ = CallableModule
