"""Stages of a long job: each makes one folder, whole or not at all, and says in a record what it was made from.

A stage's files appear under their name when all are written; then the record is, with digests of the files and of what
they were made from: the settings that bear on the stage, and the files of the stages before. So a later run keeps
what would come out the same again, also where an earlier stage was made anew and gave the same bytes.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ...pcd import watching
from ...pcd.camera import read_json_object
from ...pcd.errors import FileError
from ..console import ReportProgress, peak_bytes, to_json
from ..reconstruction.records import digest_of, read_record, write_record

RECORDS = "records"
PART = ".part"  # behind the name of a folder that is not whole yet


@dataclass(frozen=True, eq=False)
class Made:
    """What a stage left.

    Attributes:
        name: The stage's.
        folder: Where its files lie.
        digest: Of the files: equal digests are equal files.
        told: What it says of itself, in JSON's types.
        cost: "seconds" and "cpu_seconds" of the run that made it, and "peak_bytes", the most that this process, or one
            that it waited for, had held by then.
        kept: Whether an earlier run made it.
    """

    name: str
    folder: Path
    digest: str
    told: dict[str, Any]
    cost: dict[str, float]
    kept: bool


@dataclass(frozen=True, eq=False)
class Stage:
    """One step of a job.

    Attributes:
        name: Of the stage, its folder and its record.
        make: Writes the files into the empty folder that it is given, tells how far it is (step, done, of how many),
            and gives what is to be told of it. It reads nothing but the files of `after`.
        settings: What else decides its files, in JSON's types.
        after: The stages whose files it reads.
        version: Raised where it begins to make something else of the same.
    """

    name: str
    make: Callable[[Path, ReportProgress], Mapping[str, Any]]
    settings: Mapping[str, Any] = field(default_factory=dict)
    after: tuple[Made, ...] = ()
    version: int = 1

    @property
    def made_from(self) -> str:
        """Digest of all that decides its files."""
        return digest_of([self.name, self.version, dict(self.settings), [[m.name, m.digest] for m in self.after]])


class Chain:
    """Runs stages in one folder.

    Args:
        root: The job's folder, which is there.
        names: Of all stages that there may be.
        resume: Keep what an earlier run left and what still fits; else all that stages left is removed first.
        progress: Called with "stage: step", how many are done, and how many there are (0: nobody knows).

    Raises:
        FileError: What an earlier run left cannot be removed.
    """

    def __init__(self, root: Path, names: Sequence[str], *, resume: bool, progress: ReportProgress):
        self.root, self.made = root, dict[str, Made]()
        self._resume, self._progress = resume, progress
        with _told_as_file_errors(root):
            (root / RECORDS).mkdir(exist_ok=True)
            for name in names:
                _remove(root / f"{name}{PART}")
            if not resume:
                for name in names:
                    self._record(name).unlink(missing_ok=True)
                    _remove(root / name)

    def run(self, stage: Stage) -> Made:
        """Run a stage, or keep what it left.

        Raises:
            FileError: A file that cannot be written, as on a full disk. Whatever the stage raises; what was finished
                before stays.
        """
        record = self._record(stage.name)
        found = read_record(record, stage.name, self.root, stage.made_from) if self._resume else None
        result = found or self._make(stage)
        digest = digest_of(read_json_object(record)["files"])
        made = Made(stage.name, self.root / stage.name, digest, result["told"], result["cost"], found is not None)
        self.made[stage.name] = made
        return made

    def _make(self, stage: Stage) -> dict[str, Any]:
        watching.report("stage", name=stage.name)
        folder, part, record = self.root / stage.name, self.root / f"{stage.name}{PART}", self._record(stage.name)
        meter = _Meter()
        with _told_as_file_errors(part):
            try:
                part.mkdir()
                told = stage.make(part, lambda step, *of: self._tell(stage.name, step, *of))
                record.unlink(missing_ok=True)
                _remove(folder)
                part.rename(folder)
            except BaseException:
                shutil.rmtree(part, ignore_errors=True)
                raise
            files = sorted(path for path in folder.rglob("*") if path.is_file())
        result = {"told": json.loads(to_json(dict(told))), "cost": meter.cost()}
        write_record(record, stage.name, stage.made_from, self.root, files, result)
        return result

    def _tell(self, name: str, step: str, done: int, total: int) -> None:
        self._progress(name if step in ("", name) else f"{name}: {step}", done, total)

    def _record(self, name: str) -> Path:
        return self.root / RECORDS / f"{name}.json"


@contextlib.contextmanager
def _told_as_file_errors(path: Path) -> Iterator[None]:
    try:
        yield
    except OSError as error:
        if error.strerror is None:
            raise
        raise FileError(error.filename or path, f"cannot be written: {error.strerror}") from error


class _Meter:
    """What a stage costs."""

    def __init__(self):
        self._wall, self._cpu = time.perf_counter(), _cpu_seconds()

    def cost(self) -> dict[str, float]:
        """Seconds since it began, and the most memory that the process has held so far."""
        seconds, cpu = time.perf_counter() - self._wall, _cpu_seconds() - self._cpu
        return {"seconds": round(seconds, 3), "cpu_seconds": round(cpu, 3), "peak_bytes": peak_bytes_of_all()}


def _cpu_seconds() -> float:
    """Of this process and of the children that it waited for."""
    return sum(os.times()[:4])


def peak_bytes_of_all() -> int:
    """The most memory [B] that this process, or one that it started and waited for, has held so far."""
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return max(peak_bytes(), resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss * unit)


def _remove(folder: Path) -> None:
    if folder.is_dir() and not folder.is_symlink():
        shutil.rmtree(folder)
    else:
        folder.unlink(missing_ok=True)
