# SPDX-License-Identifier: Apache-2.0
"""Distributes the names of the compiled module to the modules of the package.

Each module imports its names as themselves (``Box as Box``): type checkers then treat them as exported. `export` does
the same at run time.
"""
from __future__ import annotations

import sys
from typing import Any

from . import _hapticut

_hapticut._shorten_signatures()


def export(module: str, *more: str) -> None:
    """Sets ``__all__`` of a module that has none: its names from the compiled module, and ``more``. Sets ``__module__``
    of the objects of these names to the module. ``dir`` shows that list. The error for a missing name tells which
    module has the name."""
    namespace = vars(sys.modules[module])
    if "__all__" not in namespace:
        compiled = [name for name in namespace if name in _hapticut.__all__]
        namespace["__all__"] = sorted([*compiled, *more])
        for name in compiled:
            move(namespace[name], module)

    def listed() -> list[str]:
        return sorted([*namespace["__all__"], *(name for name in namespace if name.startswith("__"))])

    def missing(name: str) -> Any:
        raise AttributeError(f"module {module!r} has no attribute {name!r}{where_is(name)}")

    namespace.setdefault("__dir__", listed)
    namespace.setdefault("__getattr__", missing)


def move(thing: Any, module: str) -> None:
    """Sets the module of a function, or of a class and its inner classes."""
    if isinstance(thing, type):
        for inner in vars(thing).values():
            if isinstance(inner, type) and inner.__module__ == _hapticut.__name__:
                move(inner, module)
    if hasattr(thing, "__module__"):
        thing.__module__ = module


def where_is(name: str) -> str:
    """The end of the message about a missing name: where the name is."""
    for place, module in sorted(sys.modules.items()):
        if f"{place}.".startswith(f"{__package__}.") and "._" not in place and name in getattr(module, "__all__", ()):
            return f"; it is {place}.{name}"
    if not _hapticut.kWithIo:
        return "; this build has no file formats but .vdb (HAPTICUT_WITH_IMPORT was off: see `pip install -v .`)"
    return ""
