# SPDX-License-Identifier: Apache-2.0
"""Hands out the runs to an executor in chunks of about a second, and outlives the death of its workers."""
from __future__ import annotations

import math
import multiprocessing
import os
import pickle
from collections import deque
from collections.abc import Generator, Iterator
from concurrent.futures import (
    FIRST_COMPLETED,
    BrokenExecutor,
    CancelledError,
    Executor,
    Future,
    ProcessPoolExecutor,
    wait,
)
from typing import Any, Callable, Optional

from .._hapticut import Error
from .chunks import Chunk, Row, Run, run_chunk
from .spaces import Space

SECONDS_PER_CHUNK = 1.0
LEAST_SECONDS_PER_CHUNK = 0.05  # what handing out a chunk costs is small against this
LONGEST_CHUNK = 10_000
GREATEST_STRIKES = 3  # deaths of a pool that a run may have been part of, alone, before it counts as their cause


def processors() -> int:
    """How many processors this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class SerialExecutor(Executor):
    """Runs everything at once, in the calling thread: for debugging, and as the reference for the others."""

    def submit(self, function: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        future: Future[Any] = Future()
        future.set_running_or_notify_cancel()
        try:
            future.set_result(function(*args, **kwargs))
        except Exception as error:
            future.set_exception(error)
        return future


def pickled(run: Run) -> bytes:
    """The function for the workers; by value where cloudpickle is there and it has no module of its own."""
    try:
        import cloudpickle
    except ImportError:
        dumps: Callable[[Any], bytes] = pickle.dumps
    else:
        dumps = cloudpickle.dumps
    try:
        return dumps(run)
    except Exception as error:
        raise Error(f"run cannot be sent to a worker: {error}. Define it at the top level of a module.") from None


class Pool:
    """The default pool of processes, which is made anew when one of them dies."""

    def __init__(self, workers: int):
        self.workers = workers
        self._make()

    def _make(self) -> None:
        # A forked child of a process with threads may hang; a fresh one cannot.
        context = multiprocessing.get_context("spawn")
        self.executor = ProcessPoolExecutor(self.workers, mp_context=context)

    def renew(self) -> None:
        self.executor.shutdown(wait=True, cancel_futures=True)
        self._make()

    def close(self) -> None:
        self.executor.shutdown(wait=True, cancel_futures=True)


class _Piece:
    """Some runs on their way, and how often a pool has died under them."""

    def __init__(self, indices: list[int], strikes: int = 0):
        self.indices = indices
        self.strikes = strikes


class Scheduler:
    """One pass over the missing runs of a space."""

    def __init__(self, space: Space, run: Run, seed: int, missing: list[int], executor: Optional[Executor],
                 workers: Optional[int]):
        self.space = space
        self.pickled = pickled(run)
        self.seed = seed
        self.missing = deque(missing)
        self.again: deque[_Piece] = deque()  # whose pool has died
        self.pool = Pool(workers or processors()) if executor is None else None
        self.given = executor
        if isinstance(executor, SerialExecutor):
            self.in_flight = 1
        elif executor is None:
            self.in_flight = 2 * (workers or processors())
        else:
            self.in_flight = 2 * workers if workers else max(32, 4 * processors())
        self.on_their_way: dict[Future[Chunk], _Piece] = {}
        self.seconds = 0.0
        self.made = 0
        self.deaths = 0

    def _chunk_length(self) -> int:
        if self.made == 0:
            return 1
        rate = self.made / max(self.seconds, 1e-9)
        # Shrink at the end, so that all workers finish together; grow step by step, because the first runs may not be
        # like the others.
        length = max(min(SECONDS_PER_CHUNK * rate, len(self.missing) / self.in_flight), LEAST_SECONDS_PER_CHUNK * rate)
        return max(1, math.floor(min(length, 4 * self.made, LONGEST_CHUNK)))

    def _next(self) -> Optional[_Piece]:
        if self.again:
            # One at a time: a run that brings the pool down then has done it alone.
            return self.again.popleft() if not self.on_their_way else None
        if not self.missing:
            return None
        return _Piece([self.missing.popleft() for _ in range(min(self._chunk_length(), len(self.missing)))])

    def _submit(self) -> None:
        while len(self.on_their_way) < self.in_flight:
            piece = self._next()
            if piece is None:
                return
            executor = self.pool.executor if self.pool is not None else self.given
            assert executor is not None
            parameters = [self.space[index] for index in piece.indices]
            try:
                future = executor.submit(run_chunk, self.pickled, self.seed, piece.indices, parameters)
            except Exception as error:  # every executor has its own for having died
                self._died(error, piece)
                continue
            self.on_their_way[future] = piece

    def _died(self, error: BaseException, *pieces: _Piece) -> None:
        """The executor is gone, and with it everything that was on its way."""
        if self.pool is None:
            raise Error(f"the executor died ({type(error).__name__}: {error}). All finished chunks are kept: call "
                        "sweep again with another executor to go on.") from error
        self.deaths += 1
        if self.made == 0 and self.deaths >= 2 * GREATEST_STRIKES:
            raise Error("the worker processes die before they finish a run. A script needs `if __name__ == "
                        "\"__main__\":` around what it does; else make a run with executor=SerialExecutor() to see "
                        "what is wrong.") from error
        lost = [*pieces, *self.on_their_way.values()]
        alone = len(lost) == 1
        self.on_their_way.clear()
        for piece in lost:
            if alone and len(piece.indices) > 1:
                self.again.extend(_Piece([index]) for index in piece.indices)
            else:
                self.again.append(_Piece(piece.indices, piece.strikes + 1 if alone else piece.strikes))
        self.pool.renew()

    def _given_up(self) -> Iterator[Chunk]:
        for piece in [piece for piece in self.again if piece.strikes >= GREATEST_STRIKES]:
            self.again.remove(piece)
            rows = [Row(index) for index in piece.indices]
            for row in rows:
                row.error = f"WorkerDied: the process that made this run died {GREATEST_STRIKES} times"
            yield Chunk(rows, 0.0)

    def chunks(self) -> Generator[Chunk, None, None]:
        """Finished chunks, in the order in which they finish."""
        try:
            while True:
                yield from self._given_up()
                self._submit()
                if not self.on_their_way:
                    if self.again or self.missing:
                        continue
                    return
                finished, _ = wait(self.on_their_way, return_when=FIRST_COMPLETED)
                for future in finished:
                    if future not in self.on_their_way:
                        continue
                    try:
                        chunk = future.result()
                    except (BrokenExecutor, CancelledError) as error:
                        self._died(error)
                        break
                    except Exception as error:
                        # run_chunk itself does not raise: the function did not arrive, or the executor gave up.
                        raise Error(f"the executor could not make a chunk ({type(error).__name__}: {error}). All "
                                    "finished chunks are kept: call sweep again to go on. The workers need hapticut, "
                                    "and the module of run.") from error
                    del self.on_their_way[future]
                    self.seconds += chunk.seconds
                    self.made += len(chunk.rows)
                    yield chunk
        finally:
            for future in self.on_their_way:
                future.cancel()
            if self.pool is not None:
                self.pool.close()
