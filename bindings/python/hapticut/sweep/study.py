# SPDX-License-Identifier: Apache-2.0
"""The folder of a study: what was asked for, what has been done so far, and the table of the results."""
from __future__ import annotations

import importlib.util
import json
import os
import warnings
import zipfile
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from .._hapticut import Error, build_info
from .chunks import Row
from .spaces import Space

if TYPE_CHECKING:
    import pandas as pd

FORMAT = 1


@contextmanager
def whole_file(path: Path, on_disk: bool = True) -> Iterator[BinaryIO]:
    """A file to write to that in the end is either complete or not there; on the disk even if the power fails then."""
    part = path.with_name(path.name + ".part")
    try:
        with open(part, "wb") as file:
            yield file
            file.flush()
            if on_disk:
                os.fsync(file.fileno())
        os.replace(part, path)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def write_whole(path: Path, data: bytes) -> None:
    """Writes such a file at once."""
    with whole_file(path) as file:
        file.write(data)


class Study:
    """One folder holds one study; what is in it is never overwritten by another."""

    def __init__(self, out: str | os.PathLike[str], space: Space, run_name: str, seed: int, units: Mapping[str, str],
                 resume: bool):
        self.out = Path(out)
        self.space = space
        self.units = dict(units)
        self.identity = {
            "format": FORMAT,
            "run": run_name,
            "parameters": space.names,
            "runs": len(space),
            "space": space.digest(),
            "seed": seed,
            "hapticut": build_info().version,
        }
        self.done: dict[int, dict[str, Any]] = {}
        try:
            (self.out / "chunks").mkdir(parents=True, exist_ok=True)
            self._claim(resume)
            # Said before the first run, not after an hour of them.
            write_whole(self.out / "chunks" / "writable", b"")
            (self.out / "chunks" / "writable").unlink()
        except OSError as error:
            raise Error(f"cannot write to the study's folder {self.out}: {error}. Choose another one by "
                        "`out`.") from None

    def _claim(self, resume: bool) -> None:
        description = self.out / "study.json"
        if not description.exists():
            if any((self.out / "chunks").glob("*.jsonl")):
                raise Error(f"{self.out} holds runs, but no study.json that says of what. Choose another folder by "
                            "`out`.")
            text = json.dumps({**self.identity, "units": self.units}, indent=2)
            write_whole(description, (text + "\n").encode())
            return
        try:
            found = json.loads(description.read_text(encoding="utf-8"))
        except ValueError:
            raise Error(f"{description} is damaged. Choose another folder by `out`, or remove this one.") from None
        different = [key for key, value in self.identity.items() if found.get(key) != value]
        if different:
            raise Error(f"{self.out} holds another study, with another {', '.join(different)}. Choose another folder "
                        "by `out`; nothing was changed.")
        if not resume and any((self.out / "chunks").glob("*.jsonl")):
            raise Error(f"{self.out} holds runs of this study already. Pass resume=True to go on with it, or choose "
                        "another folder by `out`; nothing was changed.")
        self._read_chunks()

    def _read_chunks(self) -> None:
        for path in sorted((self.out / "chunks").glob("*.jsonl")):
            try:
                rows = [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]
                self.done.update({int(row["run"]): row for row in rows})
            except (ValueError, KeyError, TypeError):
                raise Error(f"{path} is damaged. Remove it: its runs will then be made again.") from None

    def missing(self) -> list[int]:
        """Indices of the runs that are still to be made."""
        return [index for index in range(len(self.space)) if index not in self.done]

    def keep(self, rows: Sequence[Row]) -> None:
        """Writes a chunk: first its traces, then the file that says that it is done."""
        entries = [row.as_json() for row in rows]
        text = "".join(json.dumps(entry) + "\n" for entry in entries)
        try:
            for row in rows:
                if row.traces:
                    self._write_traces(row)
            write_whole(self.out / "chunks" / f"run-{rows[0].index:09d}.jsonl", text.encode())
        except OSError as error:
            raise self._cannot_write(error) from error
        self.done.update({entry["run"]: entry for entry in entries})

    def _write_traces(self, row: Row) -> None:
        folder = self.out / "traces"
        folder.mkdir(exist_ok=True)
        # Not numpy.savez, whose own arguments are names that no array can have.
        path = folder / f"run-{row.index:09d}.npz"  # one for each run: too many to wait for the disk
        with whole_file(path, on_disk=False) as file, zipfile.ZipFile(file, "w") as archive:
            for name, values in row.traces.items():
                with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                    np.lib.format.write_array(member, values, allow_pickle=False)

    def _cannot_write(self, error: OSError) -> Error:
        return Error(f"cannot write to the study's folder {self.out}: {error}. What was finished is kept: call sweep "
                     "again to go on when that is mended.")

    def table(self) -> pd.DataFrame:
        """One row per run, in the order of the space: run, parameters, summary and error."""
        import pandas as pd

        columns: list[str] = []
        for index in range(len(self.space)):
            columns += [name for name in self.done[index]["summary"] if name not in columns]
        data: dict[str, list[Any]] = {"run": list(range(len(self.space)))}
        for name in self.space.names:
            data[name] = [parameters[name] for parameters in self.space]
        for name in columns:
            data[name] = [self.done[index]["summary"].get(name) for index in range(len(self.space))]
        data["error"] = [self.done[index]["error"] or None for index in range(len(self.space))]
        table = pd.DataFrame(data)
        table.attrs["units"] = {name: unit for name, unit in self.units.items() if name in table.columns}
        return table

    def write_table(self) -> tuple[pd.DataFrame, Path]:
        """The table, and the file it is in: Parquet where pyarrow is there and every column has one type, else CSV."""
        table = self.table()
        parquet = importlib.util.find_spec("pyarrow") is not None
        mixed = [str(name) for name in table.columns if _mixes_types(table[name])]
        if parquet and mixed:
            warnings.warn(f"column {', '.join(mixed)} holds texts and numbers, which Parquet cannot; the table is "
                          "written as table.csv.", stacklevel=4)
        parquet = parquet and not mixed
        path = self.out / ("table.parquet" if parquet else "table.csv")
        try:
            with whole_file(path) as file:
                if parquet:
                    table.to_parquet(file, engine="pyarrow", index=False)
                else:
                    file.write(table.to_csv(index=False).encode())
        except OSError as error:
            raise self._cannot_write(error) from error
        return table, path


def _mixes_types(column: pd.Series) -> bool:
    """Whether there are texts beside numbers, or truth values beside others."""
    kinds = {float if isinstance(value, int) and not isinstance(value, bool) else type(value)
             for value in column if value is not None} if column.dtype == object else set()
    return len(kinds) > 1


def load_traces(out: str | os.PathLike[str], run: int) -> dict[str, NDArray[Any]]:
    """The arrays that a run returned, by their names.

    Raises
    ------
    Error
        When the folder holds no arrays of this run.
    """
    path = Path(out) / "traces" / f"run-{run:09d}.npz"
    if not path.exists():
        raise Error(f"{path} does not exist; run {run} returned no array, or was not made.")
    with np.load(path) as file:
        return {name: file[name] for name in file.files}
