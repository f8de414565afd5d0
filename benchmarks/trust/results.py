"""Stored results of `make trust`: a run that was interrupted continues where it ended.

A folder has one file of JSON lines per area, one line per case: its name, its CPU seconds, its results and the digest
of the code that it ran. `code.json` contains the modules of each digest. Lines are appended, so that an interruption
loses at most the case that was running. The last line of a case counts.

A result is valid until the code of a module changes that was imported when the case ended, or of another module in
their folders (kernels: only of imported ones). Comments and docstrings do not count (code_digests.py), nor do run.py
and this file, real data, and the versions of other packages. Delete the folder after a change of these.
"""

from __future__ import annotations

import dataclasses
import json
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from code_digests import KERNELS, ROOT, digests_of, row_digest
from judged import Judged

from pointloom.core.atomic import atomic_path

TREES = ("src/", "benchmarks/", "tests/")
RUNNER = {"benchmarks/trust/run.py", "benchmarks/trust/results.py"}


@dataclass(frozen=True)
class Result:
    """The results of a case, its CPU time [s], and the modules that it ran, by path in the repository."""

    area: str
    case: str
    seconds: float
    judged: tuple[Judged, ...]
    modules: tuple[str, ...]


def imported_modules() -> tuple[str, ...]:
    """Modules of the repository that this process has imported, and those in their folders outside kernels/."""
    files = (getattr(module, "__file__", None) for module in list(sys.modules.values()))
    paths = {Path(file).resolve() for file in files if file and file.endswith(".py")}
    own = {path for path in paths if path.is_relative_to(ROOT) and _relative(path).startswith(TREES)}
    folders = {path.parent for path in own if _relative(path).startswith("src/")}
    beside = {path for folder in folders for path in folder.glob("*.py") if not _relative(path).startswith(KERNELS)}
    return tuple(sorted({_relative(path) for path in own | beside} - RUNNER))


def _relative(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()


class Results:
    """The results in a folder. `valid` has those of the present code, by area and case."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        self._code: dict[str, list[str]] = {}
        if (folder / "code.json").exists():
            self._code = json.loads((folder / "code.json").read_text())
        self._digests = digests_of({path for paths in self._code.values() for path in paths})
        current = {digest for digest, paths in self._code.items() if self._digest(paths) == digest}
        self.valid: dict[tuple[str, str], Result] = {}
        for path in sorted(folder.glob("*.jsonl")):
            for record in read_lines(path):
                if record["code"] in current:
                    result = _result_of(path.stem, record)
                    self.valid[result.area, result.case] = result

    def _digest(self, paths: Iterable[str]) -> str:
        return row_digest({path: self._digests.get(path, "") for path in paths})

    def add(self, result: Result) -> None:
        """Store a result. Modules that changed since the folder was opened make it invalid in the next run."""
        missing = set(result.modules) - set(self._digests)
        self._digests |= dict.fromkeys(missing, "") | digests_of(missing)
        code = self._digest(result.modules)
        if code not in self._code:
            self._code[code] = list(result.modules)
            with atomic_path(self.folder / "code.json") as path:
                path.write_text(json.dumps(self._code))
        rows = [dataclasses.asdict(each) for each in result.judged]
        record = {"case": result.case, "seconds": round(result.seconds, 2), "code": code, "judged": rows}
        with (self.folder / f"{result.area}.jsonl").open("ab+") as file:
            file.seek(max(file.seek(0, 2) - 1, 0))
            torn = file.read(1) not in (b"", b"\n")  # a line that an interruption cut off
            file.write(b"\n" * torn + json.dumps(record, default=_plain).encode() + b"\n")
        self.valid[result.area, result.case] = result


def _result_of(area: str, record: dict[str, Any]) -> Result:
    judged = tuple(Judged(**row) for row in record["judged"])
    return Result(area, record["case"], record["seconds"], judged, ())


def _plain(value: Any) -> Any:
    """NumPy's numbers as those of JSON."""
    return value.item()


def read_lines(path: Path) -> list[dict[str, Any]]:
    """The complete lines of a file."""
    lines = []
    for line in path.read_text().splitlines():
        try:
            lines.append(json.loads(line))
        except json.JSONDecodeError:
            print(f"{path}: a line that was cut off is ignored", file=sys.stderr)
    return lines
