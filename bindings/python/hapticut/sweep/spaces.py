# SPDX-License-Identifier: Apache-2.0
"""The parameters of a sweep as a list of dicts: a grid, a custom list, or a design."""
from __future__ import annotations

import itertools
import math
import operator
import reprlib
from collections.abc import Mapping, Sequence
from typing import Any, Optional, Union

import numpy as np

from .._hapticut import Error

Scalar = Union[bool, int, float, str]
Parameters = dict[str, Scalar]
Space = list[Parameters]
Bounds = Mapping[str, Sequence[Any]]
RESERVED = ("run", "error")  # columns of every table


def plain(value: Any, what: str) -> Scalar:
    """A number, text or truth value as a plain Python object."""
    if isinstance(value, np.generic) or (isinstance(value, np.ndarray) and value.ndim == 0):
        value = value.item()
    if isinstance(value, (bool, int, float, str)):
        return value
    raise Error(f"{what} is {value!r}; it must be a number, a text or True or False.")


def whole(value: Any, what: str, minimum: int) -> int:
    """A whole number; NumPy's are accepted."""
    try:
        number: Optional[int] = operator.index(value)
    except TypeError:
        number = None
    if number is None or number < minimum:
        raise Error(f"{what} = {value!r}; it must be a whole number, at least {minimum}.")
    return number


def grid(**axes: Sequence[Any]) -> Space:
    """Every combination of the values; the last axis runs fastest.

    >>> len(grid(feed=[1e-3, 2e-3], material=["enamel", "dentin", "pulp"]))
    6
    """
    return _grid(axes)


def _grid(axes: Mapping[str, Sequence[Any]]) -> Space:
    if not axes:
        raise Error("a grid without axes was asked for; give at least one, e.g. grid(feed=[1e-3, 2e-3]).")
    for name, values in axes.items():
        if isinstance(values, str) or not hasattr(values, "__len__") or len(values) == 0:
            raise Error(f"axis {name} is {values!r}; it must be a non-empty list of values.")
    return [dict(zip(axes, values)) for values in itertools.product(*axes.values())]


def _scaled(name: str, bound: Any, fractions: Any) -> list[float]:
    """Maps fractions between 0 and 1 to values between the bounds of a parameter."""
    try:
        low, high = (float(end) for end in bound[:2])
        logarithmic = tuple(bound[2:]) == ("log",)
        known = logarithmic or len(bound) == 2
    except (KeyError, TypeError, ValueError):
        known = False
    if not known:
        raise Error(f"bounds of {name} are {bound!r}; they must be (low, high) or (low, high, 'log').")
    if not (math.isfinite(low) and math.isfinite(high) and low < high and (low > 0 or not logarithmic)):
        positive = ", both > 0" if logarithmic else ""
        raise Error(f"bounds of {name} are {bound!r}; they must satisfy low < high{positive}.")
    values: list[float] = (low * (high / low) ** fractions if logarithmic else low + (high - low) * fractions).tolist()
    return values


def design(sampler: Any, n: int, bounds: Bounds) -> Space:
    """n points of a sampler on the unit cube, scaled to bounds.

    Parameters
    ----------
    sampler
        One of `scipy.stats.qmc`, e.g. ``Halton(d=2, rng=1)``, with as many dimensions as there are bounds.
    n
        Number of points.
    bounds
        dict from a parameter's name to (low, high), or to (low, high, "log") for even steps of the logarithm.
    """
    n = whole(n, "n", 1)
    if not isinstance(bounds, Mapping) or not bounds:
        raise Error(f"bounds are {bounds!r}; they must be a dict from the name of each parameter to (low, high).")
    if not callable(getattr(sampler, "random", None)):
        raise Error(f"the sampler is {sampler!r}; it must be one of scipy.stats.qmc, e.g. Halton(d=2).")
    points = np.asarray(sampler.random(n), dtype=float)
    if points.shape != (n, len(bounds)):
        raise Error(f"the sampler returned an array of shape {points.shape} for {n} runs of {len(bounds)} parameters.")
    columns = [_scaled(name, bound, fractions) for (name, bound), fractions in zip(bounds.items(), points.T)]
    return [dict(zip(bounds, values)) for values in zip(*columns)]


def _design_of(engine: str, n: int, bounds: Bounds, seed: int) -> Space:
    try:
        from scipy.stats import qmc
    except ImportError:
        raise Error("designs need scipy: install the extra `sweep`, e.g. pip install '.[sweep]' in the source "
                    "folder.") from None
    dimensions = len(bounds) if isinstance(bounds, Mapping) and bounds else 1  # `design` refuses invalid bounds
    return design(getattr(qmc, engine)(d=dimensions, seed=whole(seed, "seed", 0)), n, bounds)


def latin_hypercube(n: int, bounds: Bounds, seed: int = 0) -> Space:
    """A Latin hypercube: one point in each of n slices of every parameter. See `design` for the bounds."""
    return _design_of("LatinHypercube", n, bounds, seed)


def sobol(n: int, bounds: Bounds, seed: int = 0) -> Space:
    """A scrambled Sobol sequence; n should be a power of two. See `design` for the bounds."""
    return _design_of("Sobol", n, bounds, seed)


def points_of(space: Mapping[str, Sequence[Any]] | Sequence[Mapping[str, Any]]) -> Space:
    """The parameters of every run. A dict of lists is a grid; a list has one dict per run, with equal names."""
    if isinstance(space, Mapping):
        space = _grid(space)
    if not isinstance(space, Sequence) or not space or not all(isinstance(row, Mapping) for row in space):
        raise Error(f"the space is {reprlib.repr(space)}; give a dict of lists, or a list of one dict for each run.")
    names = list(space[0])
    if not all(isinstance(name, str) and name and name not in RESERVED for name in names):
        raise Error(f"the parameters are named {names!r}; names must be non-empty texts other than "
                    f"{' and '.join(RESERVED)}, the columns of every table.")
    for index, row in enumerate(space):
        if list(row) != names:
            raise Error(f"run {index} has the parameters {list(row)}, but run 0 has {names}; they must be the same.")
    return [{name: plain(row[name], f"parameter {name} of run {index}") for name in names}
            for index, row in enumerate(space)]
