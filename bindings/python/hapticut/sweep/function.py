# SPDX-License-Identifier: Apache-2.0
"""The identity of the function of a study, equal in all processes: its name, and a hash of all that it consists of."""
from __future__ import annotations

import functools
import hashlib
import re
import types
from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

PLAIN = (bool, int, float, complex, str, bytes, type(None), type(Ellipsis))


def name_of(run: Any) -> str:
    """Module and qualified name of a function; those of the class for an instance."""
    while isinstance(run, functools.partial):
        run = run.func
    named = run if hasattr(run, "__qualname__") else type(run)
    return f"{named.__module__}.{named.__qualname__}"


def code_of(run: Any) -> str:
    """A hash of a function's code, constants, defaults, closure, bound arguments and instance state."""
    return hashlib.sha256(_text(run, ()).encode("utf-8", "surrogatepass")).hexdigest()


def _text(value: Any, around: tuple[int, ...]) -> str:
    """Describes a value by its content; `around` are the ids of the values that contain it."""
    if isinstance(value, PLAIN):
        return f"{type(value).__name__} {value!r}"
    if id(value) in around:
        return f"outer {len(around) - around.index(id(value))}"
    around = (*around, id(value))
    parts: Iterable[Any]
    if isinstance(value, types.CodeType):
        parts = (value.co_code, value.co_consts, value.co_names)
    elif isinstance(value, types.FunctionType):
        parts = (name_of(value), value.__code__, value.__defaults__, value.__kwdefaults__,
                 [_content(cell) for cell in value.__closure__ or ()])
    elif isinstance(value, types.MethodType):
        parts = (value.__func__, value.__self__)
    elif isinstance(value, functools.partial):
        parts = (value.func, value.args, value.keywords)
    elif isinstance(value, (types.ModuleType, types.BuiltinFunctionType)):
        parts = (getattr(value, "__module__", None), value.__name__)
    elif isinstance(value, type):
        call = vars(value).get("__call__")
        parts = (name_of(value), call if isinstance(call, types.FunctionType) else None)
    elif isinstance(value, np.ndarray) and not value.dtype.hasobject:
        parts = (str(value.dtype), value.shape, value.tobytes())
    elif isinstance(value, (set, frozenset)):
        parts = sorted(_text(one, around) for one in value)
    elif isinstance(value, Mapping):
        parts = (type(value), *(one for item in value.items() for one in item))
    elif isinstance(value, (list, tuple)):
        parts = (type(value), *value)
    else:
        parts = (type(value), *_state(value))
    return f"{type(value).__name__}({', '.join(_text(one, around) for one in parts)})"


def _content(cell: types.CellType) -> Any:
    try:
        return cell.cell_contents
    except ValueError:  # not yet assigned
        return None


def _state(value: Any) -> tuple[Any, ...]:
    """What pickle would store; the representation without its address for a value that pickle refuses."""
    try:
        reduced = value.__reduce_ex__(4)
    except Exception:
        return (re.sub(r" at 0x[0-9a-f]+", "", repr(value)),)
    if isinstance(reduced, str):
        return (reduced,)
    return (*reduced[:3], *(list(items) for items in reduced[3:5] if items is not None))
