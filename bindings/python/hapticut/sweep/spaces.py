# SPDX-License-Identifier: Apache-2.0
"""What a sweep goes over: a grid, a list, or a design."""
from __future__ import annotations

import hashlib
import itertools
import json
import math
import operator
from collections.abc import Iterator, Mapping, Sequence
from typing import Any, Optional, Protocol, Union

import numpy as np

from .._hapticut import Error

Scalar = Union[bool, int, float, str]
Parameters = dict[str, Scalar]
Bounds = Mapping[str, Sequence[Any]]
RESERVED = ("run", "error")  # columns of every table
LARGEST_INTEGER = 2**63 - 1  # that a column can hold


def plain(value: Any, what: str) -> Scalar:
    """A number, text or truth value, without NumPy around it."""
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, int) and not -LARGEST_INTEGER <= value <= LARGEST_INTEGER:
        raise Error(f"{what} is {value!r}; whole numbers must fit in 64 bits. Give a float.")
    if isinstance(value, str) and value != value.encode("utf-8", "replace").decode():
        raise Error(f"{what} is {value!r}, a text that UTF-8 cannot hold.")
    if isinstance(value, (bool, int, float, str)):
        return value
    raise Error(f"{what} is {value!r}; it must be a number, a text or True or False.")


def whole(value: Any, what: str, least: int) -> int:
    """A whole number, which NumPy's are as well."""
    try:
        number: Optional[int] = operator.index(value)
    except TypeError:
        number = None
    if number is None or number < least:
        raise Error(f"{what} = {value!r}; it must be a whole number, at least {least}.")
    return number


class Space(Sequence[Parameters]):
    """The parameters of every run, by the run's index."""

    def __init__(self, rows: Sequence[Mapping[str, Any]]):
        if len(rows) == 0:
            raise Error("a sweep over no runs was asked for; give at least one set of parameters.")
        if not all(isinstance(row, Mapping) for row in rows):
            raise Error("a sweep's list must hold one dict of parameters for each run.")
        names = list(rows[0])
        if not all(isinstance(name, str) and name and name not in RESERVED for name in names):
            raise Error(f"the parameters are named {names!r}; names must be texts that are not empty, and neither "
                        f"{' nor '.join(RESERVED)}, which are columns of every table.")
        self._rows: list[Parameters] = []
        for index, row in enumerate(rows):
            if list(row) != names:
                raise Error(f"run {index} has the parameters {list(row)}, but run 0 has {names}; they must be the "
                            "same.")
            self._rows.append({name: plain(row[name], f"parameter {name} of run {index}") for name in names})
        self.names = names

    def __len__(self) -> int:
        return len(self._rows)

    def __getitem__(self, index: Any) -> Any:
        return self._rows[index]

    def __iter__(self) -> Iterator[Parameters]:
        return iter(self._rows)

    def digest(self) -> str:
        """The same for the same runs in the same order."""
        text = json.dumps([self.names, [list(row.values()) for row in self._rows]])
        return hashlib.sha256(text.encode()).hexdigest()


def grid(**axes: Sequence[Any]) -> Space:
    """Every combination of the values; the last axis runs fastest.

    >>> len(grid(feed=[1e-3, 2e-3], material=["enamel", "dentin", "pulp"]))
    6
    """
    if not axes:
        raise Error("a grid without axes was asked for; give at least one, e.g. grid(feed=[1e-3, 2e-3]).")
    for name, values in axes.items():
        if isinstance(values, str) or not hasattr(values, "__len__") or len(values) == 0:
            raise Error(f"axis {name} is {values!r}; it must be a list of values that is not empty.")
    return Space([dict(zip(axes, values)) for values in itertools.product(*axes.values())])


class Sampler(Protocol):
    """What `design` needs of a `scipy.stats.qmc.QMCEngine`."""

    def random(self, n: int) -> Any: ...


def design(sampler: Sampler, n: int, bounds: Bounds) -> Space:
    """n points of a sampler on the unit cube, scaled to bounds.

    Parameters
    ----------
    sampler
        e.g. ``scipy.stats.qmc.Halton(d=2, rng=1)``, with as many dimensions as there are bounds.
    n
        How many points.
    bounds
        dict from a parameter's name to (low, high), or to (low, high, "log") for even steps of the logarithm.
    """
    n = whole(n, "n", 1)
    if not isinstance(bounds, Mapping):
        raise Error(f"bounds are {bounds!r}; needed is a dict from a parameter's name to (low, high).")
    scales = []
    for name, bound in bounds.items():
        try:
            low, high = (float(end) for end in bound[:2])
            logarithmic = tuple(bound[2:]) == ("log",)
            known = logarithmic or len(bound) == 2
        except (KeyError, TypeError, ValueError):
            known = False
        if not known:
            raise Error(f"bounds of {name} are {bound!r}; needed is (low, high) or (low, high, 'log').")
        if not (math.isfinite(low) and math.isfinite(high) and low < high and (low > 0 or not logarithmic)):
            raise Error(f"bounds of {name} are {bound!r}; needed is low < high{', both > 0' if logarithmic else ''}.")
        scales.append((name, low, high, logarithmic))
    if not scales:
        raise Error("a design without bounds was asked for; give at least one parameter.")
    if not callable(getattr(sampler, "random", None)):
        raise Error(f"the sampler is {sampler!r}; needed is one of scipy.stats.qmc, e.g. Halton(d=2).")
    points = np.asarray(sampler.random(n), dtype=float)
    if points.shape != (n, len(scales)):
        raise Error(f"the sampler gave an array of shape {points.shape} for {n} runs of {len(scales)} parameters.")
    rows: list[Parameters] = [{} for _ in range(n)]
    for column, (name, low, high, logarithmic) in enumerate(scales):
        share = points[:, column]
        values = low * (high / low) ** share if logarithmic else low + (high - low) * share
        for row, value in zip(rows, values.tolist()):
            row[name] = value
    return Space(rows)


def _design_of(engine: str, n: int, bounds: Bounds, seed: int) -> Space:
    try:
        from scipy.stats import qmc
    except ImportError:
        raise Error("designs need scipy: pip install 'hapticut[sweep]'.") from None
    dimensions = len(bounds) if isinstance(bounds, Mapping) and bounds else 1  # design refuses the others
    return design(getattr(qmc, engine)(d=dimensions, seed=whole(seed, "seed", 0)), n, bounds)


def latin_hypercube(n: int, bounds: Bounds, seed: int = 0) -> Space:
    """A Latin hypercube: one point in each of n slices of every parameter. See `design` for the bounds."""
    return _design_of("LatinHypercube", n, bounds, seed)


def sobol(n: int, bounds: Bounds, seed: int = 0) -> Space:
    """A scrambled Sobol sequence; n should be a power of two. See `design` for the bounds."""
    return _design_of("Sobol", n, bounds, seed)


def space_from(given: Space | Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]]) -> Space:
    """A space as it is; a dict of lists as a grid; a list of dicts as a list of runs."""
    if isinstance(given, Space):
        return given
    if isinstance(given, Mapping):
        if not all(isinstance(name, str) for name in given):
            raise Error(f"the axes of a grid are named {list(given)!r}; names must be texts.")
        return grid(**given)
    if isinstance(given, Sequence) and not isinstance(given, str):
        return Space(given)
    raise Error(f"a sweep over {type(given).__name__} was asked for; give a grid, a list of dicts or a design.")
