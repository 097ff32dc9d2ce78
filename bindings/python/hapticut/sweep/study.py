# SPDX-License-Identifier: Apache-2.0
"""The folder of a study: what was asked for, what has been done so far, and the table of the results."""
from __future__ import annotations

import importlib.util
import json
import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .._hapticut import Error, build_info
from .chunks import Row
from .spaces import Space

if TYPE_CHECKING:
    import pandas as pd

FORMAT = 1


def write_whole(path: Path, data: bytes) -> None:
    """Writes a file that is either complete or not there."""
    part = path.with_name(path.name + ".part")
    with open(part, "wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    os.replace(part, path)


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

    def keep(self, rows: Iterable[Row]) -> None:
        """Writes a chunk: first its traces, then the file that says that it is done."""
        lines = []
        for row in rows:
            if row.traces:
                self._write_traces(row)
            entry = row.as_json()
            lines.append(json.dumps(entry))
            self.done[row.index] = entry
        first = json.loads(lines[0])["run"]
        write_whole(self.out / "chunks" / f"run-{first:09d}.jsonl", ("\n".join(lines) + "\n").encode())

    def _write_traces(self, row: Row) -> None:
        folder = self.out / "traces"
        folder.mkdir(exist_ok=True)
        part = folder / f"run-{row.index:09d}.npz.part"
        with open(part, "wb") as file:
            arrays: dict[str, Any] = dict(row.traces)
            np.savez(file, **arrays)
        os.replace(part, folder / f"run-{row.index:09d}.npz")

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
        data["error"] = [self.done[index]["error"] for index in range(len(self.space))]
        table = pd.DataFrame(data)
        table.attrs["units"] = {name: unit for name, unit in self.units.items() if name in table.columns}
        return table

    def write_table(self) -> tuple[pd.DataFrame, Path]:
        """The table, and the file it is in: Parquet where pyarrow is there, else CSV."""
        table = self.table()
        if importlib.util.find_spec("pyarrow") is not None:
            path = self.out / "table.parquet"
            part = path.with_name(path.name + ".part")
            table.to_parquet(part, engine="pyarrow", index=False)
            os.replace(part, path)
        else:
            path = self.out / "table.csv"
            write_whole(path, table.to_csv(index=False).encode())
        return table, path


def load_traces(out: str | os.PathLike[str], run: int) -> dict[str, NDArray[Any]]:
    """The arrays that a run returned, by their names.

    Raises
    ------
    Error
        When the folder holds none of this run.
    """
    path = Path(out) / "traces" / f"run-{run:09d}.npz"
    if not path.exists():
        raise Error(f"{path} does not exist; run {run} returned no array, or was not made.")
    with np.load(path) as file:
        return {name: file[name] for name in file.files}
