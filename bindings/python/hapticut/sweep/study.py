# SPDX-License-Identifier: Apache-2.0
"""The folder of a study: the finished runs, their results, and the table."""
from __future__ import annotations

import hashlib
import json
import os
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from .._hapticut import Error, build_info
from .function import code_of, name_of
from .outcome import Outcome, Run
from .spaces import Space

if TYPE_CHECKING:
    import pandas as pd


def _trace_file(out: Path, run: int) -> Path:
    return out / "traces" / f"run-{run:09d}.npz"


class Study:
    """A folder contains one study. The first line of `runs.jsonl` identifies it; each other line is a finished run."""

    def __init__(self, out: str | os.PathLike[str], space: Space, run: Run, seed: int, resume: bool):
        self.out = Path(out)
        self.space = space
        self.file = self.out / "runs.jsonl"
        self.done: dict[int, dict[str, Any]] = {}
        digest = hashlib.sha256(json.dumps([list(row.values()) for row in space]).encode()).hexdigest()
        identity = {"function": name_of(run), "code of the function": code_of(run), "parameters": list(space[0]),
                    "runs": len(space), "space": digest, "seed": seed, "hapticut": build_info().version}
        try:
            (self.out / "traces").mkdir(parents=True, exist_ok=True)
            if self.file.exists():
                self._continue(identity, resume)
            else:
                self._append(identity)
        except OSError as error:
            raise Error(f"cannot write to the study's folder {self.out}: {error}. Choose another folder by "
                        "`out`.") from None

    def _append(self, line: Mapping[str, Any]) -> None:
        with open(self.file, "ab") as file:
            file.write(json.dumps(line).encode() + b"\n")

    def _continue(self, identity: Mapping[str, Any], resume: bool) -> None:
        """Reads the finished runs. Removes the incomplete line of a killed process: that run is repeated."""
        content = self.file.read_bytes()
        length = content.rfind(b"\n") + 1
        lines = content[:length].splitlines()
        try:
            found: Any = json.loads(lines[0]) if lines else {}
        except ValueError:
            found = None
        if not isinstance(found, dict):
            self._refuse_line(1)
        different = [key for key, value in identity.items() if found.get(key) != value]
        if different:
            raise Error(f"{self.out} contains another study, with another {', '.join(different)}. Choose another "
                        "folder by `out`; nothing was changed.")
        for number, line in enumerate(lines[1:], 2):
            row = self._finished(line)
            if row is None:
                self._refuse_line(number)
            else:
                self.done[row["run"]] = row
        if self.done and not resume:
            raise Error(f"{self.out} contains runs of this study already. Pass resume=True to continue it, or choose "
                        "another folder by `out`; nothing was changed.")
        os.truncate(self.file, length)

    def _finished(self, line: bytes) -> dict[str, Any] | None:
        """The finished run of a line; None when the line is damaged."""
        try:
            row: Any = json.loads(line)
        except ValueError:
            return None
        kinds = {"run": int, "summary": dict, "error": str}
        if not isinstance(row, dict) or not all(isinstance(row.get(key), kind) for key, kind in kinds.items()):
            return None
        return row if row["run"] in range(len(self.space)) else None

    def _refuse_line(self, number: int) -> NoReturn:
        raise Error(f"{self.file} is damaged: line {number} is not a {'study' if number == 1 else 'finished run'}. "
                    f"{'Choose' if number == 1 else 'Remove that line to repeat its run, or choose'} another folder by "
                    "`out`; nothing was changed.")

    def missing(self) -> list[int]:
        """Indices of the runs that are not finished."""
        return [index for index in range(len(self.space)) if index not in self.done]

    def keep(self, outcome: Outcome) -> None:
        """Writes a run: first its traces, then the line that marks it as finished."""
        row = {"run": outcome.index, "summary": outcome.summary, "error": outcome.error}
        try:
            if outcome.traces:
                # Not numpy.savez: its own arguments are names that arrays could not have.
                with zipfile.ZipFile(_trace_file(self.out, outcome.index), "w") as archive:
                    for name, values in outcome.traces.items():
                        with archive.open(f"{name}.npy", "w", force_zip64=True) as member:
                            np.lib.format.write_array(member, values, allow_pickle=False)
            self._append(row)
        except OSError as error:
            raise Error(f"cannot write to the study's folder {self.out}: {error}. Finished runs are kept: "
                        "solve the problem and call sweep again.") from error
        self.done[outcome.index] = row

    def table(self, units: Mapping[str, str]) -> pd.DataFrame:
        """One row per run, in the order of the space: run, parameters, summary and error. Writes `table.csv` too."""
        import pandas as pd

        rows = [self.done[index] for index in range(len(self.space))]
        summary = dict.fromkeys(name for row in rows for name in row["summary"])  # in the order of their appearance
        table = pd.DataFrame({"run": range(len(rows)),
                              **{name: [parameters[name] for parameters in self.space] for name in self.space[0]},
                              **{name: [row["summary"].get(name) for row in rows] for name in summary},
                              "error": [row["error"] or None for row in rows]})
        table.attrs["units"] = {name: unit for name, unit in units.items() if name in table.columns}
        try:
            table.to_csv(self.out / "table.csv", index=False, errors="backslashreplace")
        except OSError as error:
            raise Error(f"cannot write the table: {error}. The runs are kept: call sweep again.") from error
        return table


def load_traces(out: str | os.PathLike[str], run: int) -> dict[str, NDArray[Any]]:
    """The arrays that a run returned, by their names.

    Raises
    ------
    Error
        When the folder contains no arrays of this run.
    """
    path = _trace_file(Path(out), run)
    if not path.exists():
        raise Error(f"{path} does not exist; run {run} returned no array, or is not finished.")
    with np.load(path) as file:
        return {name: file[name] for name in file.files}
