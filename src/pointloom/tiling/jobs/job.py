"""Base of jobs: tasks in stages over the manifest, their table and status.

A task is a row: stage, name, input and result in JSON. It depends only on the plan and files, so it can be repeated
anywhere. A stage's tasks are created when the previous stage is done.
"""

from __future__ import annotations

import hashlib
import json
import sqlite3
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

from ... import __version__  # pyright: ignore[reportMissingImports]
from ...core.errors import FileError, FilePath
from ...core.escaped_text import escaped
from ...core.json_fields import Checks, check_fields
from ...core.paths import path_of
from ...core.reports import Assessed, quality
from ...core.wording import plain
from ..job_folder import make_folder
from ..manifest import FINAL_STATES, NAME, Manifest, damage_as_file_errors, new_manifest
from ..plan import check_same_plan
from ..schema import TASKS

_STAGE = "stage"  # of meta: the current stage


class Task(NamedTuple):
    """Name of a task, and its input in JSON's types."""

    name: str
    inputs: dict[str, Any]


class Done(NamedTuple):
    """A finished task: name, input and result."""

    name: str
    inputs: dict[str, Any]
    result: dict[str, Any]


class Job(ABC):
    """A kind of job (KIND, STAGES), opened for one process; `plan` in JSON's types alone determines the result."""

    KIND: ClassVar[str]
    STAGES: ClassVar[tuple[str, ...]]
    PLAN: ClassVar[Checks]

    def __init__(self, plan: dict[str, Any], folder: Path):
        check_fields("plan", plan, self.PLAN)
        self.plan, self.folder, self.device = plan, folder, "cpu"

    @abstractmethod
    def task_fields(self, stage: int) -> tuple[Checks, Checks]:
        """Checks of the input and the result of a stage's tasks, since the folder may be damaged or untrusted."""

    @abstractmethod
    def check(self, done: Callable[[int], Iterator[Done]]) -> None:
        """Raise FileError if planned files, or those read by finished tasks, changed."""

    @abstractmethod
    def do(self, stage: int, name: str, inputs: dict[str, Any]) -> dict[str, Any]:
        """Run a task and return its result in JSON's types. Output files are written atomically and reproducibly."""

    def follow(self, stage: int, done: Callable[[int], Iterator[Done]]) -> Sequence[Task]:
        """Tasks of the next stage; `done(stage)` lists finished tasks."""
        raise NotImplementedError

    def notes(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        return []

    def warnings(self, done: Callable[[int], Iterator[Done]]) -> list[str]:
        """Failed quality checks of the input and of finished tasks."""
        return []


@dataclass(frozen=True)
class JobStatus(Assessed):
    """Progress of a job.

    Attributes:
        folder, job: Its folder, and "fusion" or "registration".
        stage: Name of the current stage's tasks.
        waiting, running, done, failed, aside: Number of tasks in each state, in the stages so far. Failed tasks raised
            an error, quarantined ones (`aside`) killed their workers.
        is_finished: True if all stages are done.
        troubles: (task, error) of failed and quarantined tasks.
        notes: What was skipped, and why.
        task_warnings: Failed quality checks of the input and of finished tasks.
        reliable, warnings: True if no task failed and all quality checks passed so far; else the reasons.
    """

    folder: str
    job: str
    stage: str
    waiting: int
    running: int
    done: int
    failed: int
    aside: int
    is_finished: bool
    troubles: dict[str, str]
    notes: tuple[str, ...]
    task_warnings: tuple[str, ...] = ()

    @property
    def warnings(self) -> tuple[str, ...]:
        return (*(f"{name}: {error}" for name, error in self.troubles.items()), *self.task_warnings)

    def to_dict(self) -> dict[str, Any]:
        return plain(asdict(self)) | quality(self)

    def __str__(self) -> str:
        total = self.waiting + self.running + self.done + self.failed + self.aside
        parts = [f"{self.job}: {self.done} of {total} tasks done" + ("" if self.is_finished else f", at {self.stage}")]
        counts = {"waiting": self.waiting, "running": self.running, "failed": self.failed, "quarantined": self.aside}
        parts += [f"{count} {name}" for name, count in counts.items() if count]
        lines = [*self.warnings, *self.notes]
        return escaped("; ".join(parts)) + "".join(f"\n  {escaped(line)}" for line in lines)


def make_job(kind: type[Job], folder: FilePath, plan: dict[str, Any], tasks: Sequence[Task]) -> JobStatus:
    """Write a new job with its first tasks. Keeps finished work of the same plan, FileError for another one."""
    folder, plan = path_of(folder, "folder"), {"job": kind.KIND} | plan
    if not (folder / NAME).exists():
        make_folder(folder)
        with new_manifest(folder, plan, __version__, TASKS) as base:
            base.execute("INSERT INTO meta VALUES (?, '0')", (_STAGE,))
            _insert(base, 0, tasks)
    with Manifest(folder, is_job=True) as manifest:
        check_same_plan(manifest, plan)
        return status_of(manifest, kind(manifest.plan, folder))


def stamp_of(paths: Iterable[Path]) -> str:
    """Sizes and times of files. FileError if one is missing."""
    digest = hashlib.sha256()
    for path in paths:
        try:
            stat = path.stat()
        except OSError as error:
            raise FileError(path, f"cannot be read: {error.strerror or error}") from error
        digest.update(f"{path}\0{stat.st_size}\0{stat.st_mtime_ns}\0".encode())
    return digest.hexdigest()


def open_manifest(folder: FilePath) -> Manifest:
    """Manifest of a job, checked to be of this version."""
    manifest = Manifest(path_of(folder, "folder"), is_job=True)
    if manifest.version != __version__:
        manifest.base.close()
        reason = f"was planned by pointloom {manifest.version}, this is {__version__}"
        raise FileError(manifest.folder / NAME, reason, remedy="Plan it again in another folder")
    return manifest


def stage_of(manifest: Manifest, job: Job) -> int:
    """The current stage. FileError if the job has no such stage."""
    rows = manifest.rows("SELECT value FROM meta WHERE key = ?", _STAGE)
    with damage_as_file_errors(manifest.folder / NAME):
        return range(len(job.STAGES)).index(int(rows[0]["value"]))


def read_inputs(manifest_path: Path, job: Job, stage: int, name: str, text: str) -> dict[str, Any]:
    """Input of a task. FileError if it is invalid."""
    with damage_as_file_errors(manifest_path):
        inputs = json.loads(text)
        check_fields(f"task {name}", inputs, job.task_fields(stage)[0])
        return inputs


def done_in(manifest: Manifest, job: Job, stage: int) -> Iterator[Done]:
    """Finished tasks of a stage in order, fetched by thousands. FileError if one is invalid."""
    last, path = -1, manifest.folder / NAME
    with damage_as_file_errors(path):
        _, checks = job.task_fields(stage)
    while True:
        query = "SELECT * FROM tasks WHERE stage = ? AND state = 'done' AND id > ? ORDER BY id LIMIT 1000"
        rows = manifest.rows(query, stage, last)
        if not rows:
            return
        for row in rows:
            inputs = read_inputs(path, job, stage, row["name"], row["told"])
            with damage_as_file_errors(path):
                result = json.loads(row["found"])
                check_fields(f"result of {row['name']}", result, checks)
            yield Done(row["name"], inputs, result)
        last = rows[-1]["id"]


def advance(manifest: Manifest, job: Job, stage: int) -> None:
    """Start the next stage, unless another process did."""
    with damage_as_file_errors(manifest.folder / NAME):
        tasks = job.follow(stage, lambda earlier: done_in(manifest, job, earlier))
    with manifest.change() as base:
        query = "UPDATE meta SET value = ? WHERE key = ? AND value = ?"
        if base.execute(query, (str(stage + 1), _STAGE, str(stage))).rowcount:
            _insert(base, stage + 1, tasks)


def _insert(base: sqlite3.Connection, stage: int, tasks: Sequence[Task]) -> None:
    rows = [(stage, task.name, json.dumps(task.inputs, allow_nan=False)) for task in tasks]
    base.executemany("INSERT INTO tasks (stage, name, told) VALUES (?, ?, ?)", rows)


def status_of(manifest: Manifest, job: Job) -> JobStatus:
    counts, stage = manifest.counts("tasks"), stage_of(manifest, job)
    left = sum(counts[state] for state in counts if state not in ("done", "empty"))
    bad = manifest.rows("SELECT name, error FROM tasks WHERE state IN ('failed', 'aside') ORDER BY id")
    with damage_as_file_errors(manifest.folder / NAME):
        done = partial(done_in, manifest, job)
        notes, warnings = tuple(job.notes(done)), tuple(job.warnings(done))
    return JobStatus(
        folder=str(manifest.folder),
        job=job.KIND,
        stage=job.STAGES[stage],
        **{state: counts[state] for state in ("waiting", "running", "done", "failed", "aside")},
        is_finished=not left and stage == len(job.STAGES) - 1,
        troubles={row["name"]: row["error"] or "" for row in bad},
        notes=notes,
        task_warnings=warnings,
    )


def over_in(manifest: Manifest, stage: int) -> int:
    (row,) = manifest.rows(f"SELECT count(*) AS n FROM tasks WHERE stage = ? AND state IN {FINAL_STATES}", stage)
    return row["n"]
