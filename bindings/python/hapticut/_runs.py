# SPDX-License-Identifier: Apache-2.0
"""The warning about a run without a step."""
from __future__ import annotations

import contextlib
import threading
import warnings
from collections.abc import Iterator

from ._hapticut import Error

_here = threading.local()


def warn_no_steps(text: str) -> None:
    """Warns; raises Error within `no_steps_are_an_error`."""
    if getattr(_here, "raises", False):
        raise Error(text)
    warnings.warn(text, UserWarning, stacklevel=2)


@contextlib.contextmanager
def no_steps_are_an_error() -> Iterator[None]:
    """Makes `warn_no_steps` raise in this thread, because a sweep reports only errors."""
    _here.raises = True
    try:
        yield
    finally:
        _here.raises = False
