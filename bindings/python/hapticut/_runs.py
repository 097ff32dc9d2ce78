# SPDX-License-Identifier: Apache-2.0
"""What is said of a run of which no step was taken."""
from __future__ import annotations

import contextlib
import threading
import warnings
from collections.abc import Iterator

from ._hapticut import Error

_here = threading.local()


def none_taken(text: str) -> None:
    """A warning, or an error within `none_taken_is_an_error`."""
    if getattr(_here, "raises", False):
        raise Error(text)
    warnings.warn(text, UserWarning, stacklevel=2)


@contextlib.contextmanager
def none_taken_is_an_error() -> Iterator[None]:
    """In this thread: a sweep has no other place to say it."""
    _here.raises = True
    try:
        yield
    finally:
        _here.raises = False
