# SPDX-License-Identifier: Apache-2.0
"""Notes which functions, methods, properties and constructors of the compiled module are called while the tests run."""
from __future__ import annotations

import functools
import inspect
import types
from typing import Any

import hapticut

core = hapticut._hapticut
MODULES = [hapticut, *(module for name, module in vars(hapticut).items()
                       if inspect.ismodule(module) and name in hapticut.__all__)]  # all but sweep and plot
PROTOCOL = {"__init__", "__call__", "__len__", "__getitem__", "__contains__", "__iter__", "__enter__", "__exit__"}

bound: set[str] = set()  # all there are
used: set[str] = set()  # those that were called


def has_constructor(cls: type) -> bool:
    """Whether Python can make one; classes that only the library makes have a slot of object's in its place."""
    return not isinstance(vars(cls).get("__init__", object.__init__), types.WrapperDescriptorType)


def _noted(name: str, function: Any) -> Any:
    bound.add(name)

    @functools.wraps(function)
    def call(*arguments: Any, **keywords: Any) -> Any:
        used.add(name)
        return function(*arguments, **keywords)

    return call


def _watch_class(name: str, cls: type) -> None:
    for attribute, value in list(vars(cls).items()):
        full = f"{name}.{attribute}"
        if isinstance(value, type):
            _watch(full, value)
        elif attribute.startswith("_") and attribute not in PROTOCOL:
            continue
        elif isinstance(value, property) and type(value) is property:
            setter = value.fset and _noted(f"{full} (set)", value.fset)
            setattr(cls, attribute, property(_noted(full, value.fget), setter, value.fdel, value.__doc__))
        elif isinstance(value, staticmethod):
            setattr(cls, attribute, staticmethod(_noted(full, value.__func__)))
        elif inspect.isroutine(value) and (attribute != "__init__" or has_constructor(cls)):
            setattr(cls, attribute, _noted(full, getattr(cls, attribute)))


def _watch(name: str, thing: Any) -> None:
    if isinstance(thing, type):
        if not hasattr(thing, "__members__") and not issubclass(thing, Exception):
            _watch_class(name, thing)
    elif inspect.isroutine(thing):
        noted = _noted(name, thing)
        for module in (core, *MODULES):
            if vars(module).get(name) is thing:
                setattr(module, name, noted)


def begin() -> None:
    """Puts a notebook before everything that is bound."""
    for name in dir(core):
        if not name.startswith("_"):
            _watch(name, getattr(core, name))
