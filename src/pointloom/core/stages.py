"""Resumable jobs: each stage writes one folder atomically and a record of its inputs.

The record has digests of the files, settings and preceding stages, so that a later run reuses unchanged results.
"""

from __future__ import annotations

import contextlib
import json
import shutil
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from . import observers
from .errors import FileError
from .json_fields import Check, has_fields, is_count, is_number, is_object, is_text
from .json_files import read_json_object
from .paths import os_errors, refuse_links
from .progress import ReportProgress
from .records import RECORDS, digest_of, read_record, record_file, write_record
from .timing import Clock, peak_bytes_of_all
from .wording import json_text

PART = ".part"  # suffix of an incomplete folder
OLD = ".old.part"  # suffix of a folder that is replaced
GOING = ".going"  # suffix of the folder of a resumable stage
_MADE_FROM = "made_from"


@dataclass(frozen=True, eq=False)
class StageResult:
    """The result of a stage; equal digests mean equal files.
    `report` is that of the stage, `cost` has "seconds", "cpu_seconds" and "peak_bytes" of the run that made it,
    `is_reused` is True for an earlier run, `outdated` names versions for which an earlier result was rejected."""

    name: str
    folder: Path
    digest: str
    report: dict[str, Any]
    cost: dict[str, float]
    is_reused: bool
    outdated: str = ""


@dataclass(frozen=True, eq=False)
class Stage:
    """One step of a job.

    Attributes:
        make: Writes the files to an empty folder, calls progress(step, done, total), returns a report; reads only
            `after`'s files.
        settings: Other inputs, as JSON types.
        version, code: Version of the stage and of the packages used. A change invalidates the result.
        goes_on: If True, `make` gets a third argument, a folder that survives interruptions.
        is_report: Check of the fields of a report in the record of an earlier run.
    """

    name: str
    make: Callable[..., Mapping[str, Any]]
    settings: Mapping[str, Any] = field(default_factory=dict)
    after: tuple[StageResult, ...] = ()
    version: int = 1
    code: Mapping[str, str] = field(default_factory=dict)
    goes_on: bool = False
    is_report: Check = is_object

    def is_result(self, value: object) -> bool:
        """True for the result in the record of a run."""
        costs = has_fields(dict.fromkeys(("seconds", "cpu_seconds", "peak_bytes"), is_number))
        versions = {"version": is_count, "code": lambda code: is_object(code) and all(map(is_text, code.values()))}
        return has_fields({"told": self.is_report, "cost": costs, **versions}, versions)(value)

    @property
    def made_from(self) -> str:
        before = [[made.name, made.digest] for made in self.after]
        return digest_of([self.name, self.version, dict(self.settings), before, dict(self.code)])


class Chain:
    """Runs stages in an existing folder; `resume` reuses valid results of earlier runs."""

    def __init__(self, root: Path, names: Sequence[str], *, resume: bool, progress: ReportProgress):
        self.root, self.made = root, dict[str, StageResult]()
        self._resume, self._progress = resume, progress
        with os_errors(root, "written"):
            refuse_links(root, recursive=True)
            (root / RECORDS).mkdir(exist_ok=True)
            for name in names:
                _remove(root / f"{name}{PART}")
                _remove(root / f"{name}{OLD}")
            if not resume:
                listed = {name: _listed(root, name) for name in names}
                for name, own in listed.items():
                    _check_own(root, name, own)
                for name, own in listed.items():
                    if own is not None:
                        _set_aside(root, name)
                    record_file(root, name).unlink(missing_ok=True)
                    _remove(root / f"{name}{OLD}")
                    _remove(root / f"{name}{GOING}")

    def run(self, stage: Stage) -> StageResult:
        record = record_file(self.root, stage.name)
        record_content = (
            read_record(record, stage.name, self.root, stage.is_result, stage.made_from) if self._resume else None
        )
        outdated = "" if record_content or not self._resume else self._outdated(stage, record)
        result = record_content or self._make(stage)
        digest = digest_of(read_json_object(record)["files"])
        made = StageResult(
            stage.name,
            self.root / stage.name,
            digest,
            result["told"],
            result["cost"],
            record_content is not None,
            outdated,
        )
        self.made[stage.name] = made
        return made

    def _outdated(self, stage: Stage, record: Path) -> str:
        """The versions of the existing result, if they differ."""
        old = read_record(record, stage.name, self.root, stage.is_result)
        if old is None:
            return ""
        was = {**old.get("code", {}), "its version": old.get("version", 1)}
        now = {**stage.code, "its version": stage.version}
        others = [name for name in was | now if was.get(name) != now.get(name)]
        return ", ".join(f"{name} {was.get(name, 'unknown')}, now {now.get(name, 'none')}" for name in others)

    @contextlib.contextmanager
    def _going(self, stage: Stage) -> Iterator[tuple[Path, ...]]:
        """The persistent folder of a resumable stage, removed when the stage is complete."""
        if not stage.goes_on:
            yield ()
            return
        folder = self.root / f"{stage.name}{GOING}"
        mark = folder / _MADE_FROM
        if not mark.is_file() or mark.read_bytes() != stage.made_from.encode():
            _remove(folder)
            folder.mkdir()
            mark.write_text(stage.made_from, encoding="utf-8")
        yield (folder,)
        _remove(folder)

    def _make(self, stage: Stage) -> dict[str, Any]:
        observers.report("stage", name=stage.name)
        folder, part = self.root / stage.name, self.root / f"{stage.name}{PART}"
        record = record_file(self.root, stage.name)
        clock = Clock()
        with os_errors(part, "written"):
            listed = _listed(self.root, stage.name)
            _check_own(self.root, stage.name, listed)
            try:
                part.mkdir()
                with self._going(stage) as going:
                    stage_report = stage.make(
                        part, lambda step, *of: self._report_progress(stage.name, step, *of), *going
                    )
            except BaseException:
                shutil.rmtree(part, ignore_errors=True)
                raise
        clock.stop(stage.name)
        seconds, cpu = clock.seconds[stage.name], clock.cpu_seconds[stage.name]
        cost = {"seconds": round(seconds, 3), "cpu_seconds": round(cpu, 3), "peak_bytes": peak_bytes_of_all()}
        result = {"told": json.loads(json_text(dict(stage_report))), "cost": cost}
        result |= {"version": stage.version, "code": dict(stage.code)}
        with os_errors(folder, "written"):
            # the record lists the files of the folder at each moment, or there is no folder
            files = {f"{stage.name}/{file.relative_to(part).as_posix()}": file for file in _files_in(part)}
            _check_own(self.root, stage.name, {*files, *(listed or ())})
            _set_aside(self.root, stage.name)
            write_record(record, stage.name, stage.made_from, files, result)
            part.rename(folder)
            _remove(self.root / f"{stage.name}{OLD}")
        return result

    def _report_progress(self, name: str, step: str, done: int, total: int) -> None:
        self._progress(name if step in ("", name) else f"{name}: {step}", done, total)


def _files_in(folder: Path) -> list[Path]:
    return sorted(path for path in folder.rglob("*") if not path.is_dir())


def _listed(root: Path, name: str) -> set[str] | None:
    """The files in the record of a stage, also of a damaged stage. None if the record cannot be read."""
    try:
        files = read_json_object(record_file(root, name)).get("files")
    except FileError:
        return None
    return set(files) if isinstance(files, dict) else None


def _check_own(root: Path, name: str, own: set[str] | None) -> None:
    """Raise FileError if the folder of a stage, which is to be removed, has another file. None: they are unknown."""
    folder = root / name
    for path in _files_in(folder) if folder.is_dir() else [folder] if folder.exists() else []:
        if own is not None and path.relative_to(root).as_posix() not in own:
            reason = f"is not a file of the run, which replaces the folder {name}"
            raise FileError(path, reason, remedy="Move it to another folder")


def _set_aside(root: Path, name: str) -> None:
    """Rename the folder of a stage, so that an interrupted removal leaves no folder without a record."""
    if (root / name).is_dir():
        (root / name).rename(root / f"{name}{OLD}")


def _remove(folder: Path) -> None:
    if folder.is_dir() and not folder.is_symlink():
        shutil.rmtree(folder)
    else:
        folder.unlink(missing_ok=True)
