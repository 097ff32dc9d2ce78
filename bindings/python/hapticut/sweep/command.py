# SPDX-License-Identifier: Apache-2.0
"""The command line of sweeps: `hapticut-sweep study.toml`, or `python -m hapticut.sweep study.toml`."""
from __future__ import annotations

import argparse
import importlib
import importlib.util
import json
import sys
from collections.abc import Mapping, Sequence
from concurrent.futures import Executor
from pathlib import Path
from typing import Any, Optional

import numpy as np

from .._hapticut import Error
from . import sweep
from .chunks import Run
from .scheduler import SerialExecutor
from .spaces import Parameters, Space, latin_hypercube, sobol, space_from

EXAMPLE = """\
A study:

  run = "drill.py:groove"       # a function in a file beside the study, or "package.module:function"
  out = "out/groove"            # default: the name of the study without .toml
  seed = 1

  [grid]                        # one of: grid, latin_hypercube, sobol, runs
  feed = [0.001, 0.002]
  material = ["enamel", "dentin"]

  # [latin_hypercube]           # or sobol
  # n = 64
  # bounds = { feed = [0.001, 0.004], speed = [1000.0, 20000.0, "log"] }

  [constants]                   # the same in every run
  depth = 0.0005

  [units]
  feed = "m/s"
"""
TABLE = (dict, "a table")
KINDS = {"run": (str, 'a text, "file.py:function" or "module:function"'), "out": (str, "a text, the folder"),
         "seed": (int, "a whole number"), "grid": TABLE, "latin_hypercube": TABLE, "sobol": TABLE,
         "runs": (list, "a list of tables"), "constants": TABLE, "units": TABLE}


class FunctionOf:
    """A function of a file or a module, found anew in every worker."""

    def __init__(self, place: str, name: str, folder: str, constants: Mapping[str, Any]):
        self.place = place
        self.name = name
        self.folder = folder
        self.constants = dict(constants)
        # Other constants are another study.
        self.__qualname__ = f"{place}:{name}" + (json.dumps(self.constants, default=str) if constants else "")
        self._function: Optional[Run] = None

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_function": None}

    def find(self) -> Run:
        """Imports it.

        Raises
        ------
        Error
            When there is no such file, module or function.
        """
        if self._function is None:
            module = self._module()
            function = getattr(module, self.name, None)
            if not callable(function):
                raise Error(f"{self.place} has no function {self.name!r}.")
            self._function = function
        return self._function

    def _module(self) -> Any:
        if not self.place.endswith(".py"):
            try:
                return importlib.import_module(self.place)
            except ModuleNotFoundError as error:
                raise Error(f"run: {error}. Give a module that can be imported, or a file ending in .py.") from None
        path = Path(self.folder, self.place)
        specification = importlib.util.spec_from_file_location(f"hapticut_study_{path.stem}", path)
        if not path.is_file() or specification is None or specification.loader is None:
            raise Error(f"run: {path} does not exist.")
        module = importlib.util.module_from_spec(specification)
        sys.modules[module.__name__] = module  # where dataclasses look for their own
        try:
            specification.loader.exec_module(module)
        except Exception as error:
            del sys.modules[module.__name__]
            raise Error(f"run: {path} cannot be imported ({type(error).__name__}: {error}).") from error
        return module

    def __call__(self, parameters: Parameters, rng: np.random.Generator) -> Mapping[str, Any]:
        return self.find()({**self.constants, **parameters}, rng)


def read_toml(path: Path) -> dict[str, Any]:
    """The settings of a study."""
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        with open(path, "rb") as file:
            return dict(tomllib.load(file))
    except OSError as error:
        raise Error(f"cannot read {path}: {error.strerror}.") from None
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise Error(f"{path} is not TOML: {error}.") from None


def read_study(path: Path) -> dict[str, Any]:
    """The settings of a study, each of the kind that it must be."""
    settings = read_toml(path)
    unknown = set(settings) - set(KINDS)
    if unknown:
        raise Error(f"{path} has the unknown keys {sorted(unknown)}; known are {sorted(KINDS)}.")
    for key, value in settings.items():
        kind, words = KINDS[key]
        if not isinstance(value, kind):
            raise Error(f"{key} = {value!r} in {path}; it must be {words}.")
    return settings


def space_of(settings: Mapping[str, Any], path: Path) -> Space:
    """The space of a study."""
    kinds = [kind for kind in ("grid", "latin_hypercube", "sobol", "runs") if kind in settings]
    if len(kinds) != 1:
        found = " and ".join(kinds) or "no space"
        raise Error(f"{path} has {found}; give one of grid, latin_hypercube, sobol and runs.")
    given = settings[kinds[0]]
    if kinds[0] in ("grid", "runs"):
        return space_from(given)
    unknown = set(given) - {"n", "bounds", "seed"}
    if unknown or not {"n", "bounds"} <= set(given):
        raise Error(f"[{kinds[0]}] of {path} has {sorted(given)}; it needs n and bounds, and may have seed.")
    maker = latin_hypercube if kinds[0] == "latin_hypercube" else sobol
    return maker(given["n"], given["bounds"], given.get("seed", 0))


def executor_of(name: str) -> tuple[Optional[Executor], Any]:
    """The executor of a name, and what has to be closed after it."""
    if name == "processes":
        return None, None
    if name == "serial":
        return SerialExecutor(), None
    if name.startswith("dask://") or name == "dask":
        try:
            from dask import distributed
        except ImportError:
            raise Error("dask is not installed: pip install 'hapticut[cluster]'.") from None
        try:
            make_client: Any = distributed.Client
            client = make_client("tcp://" + name[len("dask://"):] if name != "dask" else None)
        except (OSError, ValueError) as error:
            raise Error(f"no dask scheduler answers at {name}: {error}.") from None
        return client.get_executor(), client
    raise Error(f"there is no executor {name!r}; choose processes, serial, dask or dask://HOST:PORT.")


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Reads the command line, makes the study and says where the table is."""
    parser = argparse.ArgumentParser(prog="hapticut-sweep", description="Makes every run of a study.", epilog=EXAMPLE,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", type=Path, help="a TOML file")
    parser.add_argument("--executor", default="processes", help="processes (default), serial, dask, dask://HOST:PORT")
    parser.add_argument("--workers", type=int, help="processes of the pool")
    parser.add_argument("--out", type=Path, help="folder of the study, instead of the file's")
    parser.add_argument("--no-resume", action="store_true", help="refuse a folder that holds runs")
    parser.add_argument("--quiet", action="store_true", help="no progress bar")
    options = parser.parse_args(arguments)
    try:
        settings = read_study(options.study)
        place, _, name = settings.get("run", "").rpartition(":")
        if not place or not name:
            raise Error(f"run = {settings.get('run')!r} in {options.study}; give \"file.py:function\" or "
                        "\"module:function\".")
        space, constants = space_of(settings, options.study), settings.get("constants", {})
        shared = set(space.names) & set(constants)
        if shared:
            raise Error(f"{options.study} has {sorted(shared)} both in [constants] and among the parameters.")
        run = FunctionOf(place, name, str(options.study.resolve().parent), constants)
        run.find()
        out = options.out or Path(settings.get("out", options.study.with_suffix("").name))
        executor, client = executor_of(options.executor)
        try:
            table = sweep(space, run, executor, out, resume=not options.no_resume, seed=settings.get("seed", 0),
                          units=settings.get("units"), workers=options.workers, progress=not options.quiet)
        finally:
            if client is not None:
                client.close()
    except (Error, KeyboardInterrupt) as error:
        text = "interrupted; what was finished is kept" if isinstance(error, KeyboardInterrupt) else str(error)
        print(f"hapticut-sweep: {text}", file=sys.stderr)
        return 1
    failed = int(table["error"].notna().sum())
    print(f"{len(table)} runs, {failed} failed; the table is in {out}")
    return 0 if failed == 0 else 2
