# SPDX-License-Identifier: Apache-2.0
"""The cutting-force model for haptic rendering: step it, sweep it, plot it.

The names are those of the C++ library. Everything is in SI units and in the world frame W, which is the workpiece's,
unless a name says otherwise. Arrays are float64: points ``(n, 3)``, poses ``(4, 4)`` homogeneous matrices, twists
``(6,)`` linear then angular. What cannot be done raises ``hapticut.Error`` with what was given, what is allowed and
what to do.

``hapticut.presets`` holds ready-made materials, ``hapticut.units`` factors to SI; ``hapticut.sweep`` and
``hapticut.plot`` are imported when they are first used.
"""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from . import _hapticut, presets, units
from ._hapticut import *  # noqa: F403
from ._pose import Pose

if TYPE_CHECKING:
    from . import plot as plot
    from .sweep import sweep as sweep

__version__: str = _hapticut.build_info().version
__all__ = [name for name in dir(_hapticut) if not name.startswith("_")] + ["Pose", "plot", "presets", "sweep", "units"]


def __getattr__(name: str) -> Any:
    if name in ("plot", "sweep"):
        return importlib.import_module(f"{__name__}.{name}")
    hint = ""
    if not _hapticut.kWithIo:
        hint = "; this build has no file formats but .vdb (HAPTICUT_WITH_IO was off: see `pip install -v .`)"
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}{hint}")
