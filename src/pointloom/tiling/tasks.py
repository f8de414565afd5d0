"""Tasks of a job of tiles: sort files into tiles, then process tiles, pass by pass.

A task is claimed in the manifest, computed from the files alone, and recorded.
"""

from __future__ import annotations

import shutil
import uuid
from collections.abc import Iterable
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from typing import Any

from ..core.errors import FileError
from .border_merging import BorderData, Joined, join_step
from .buckets import REMOTE, Filled, fill_buckets, folder_of
from .exact_sums import ExactSums
from .manifest import NAME, STATES, UNSORTED_COLOR, Manifest, files_of, message_of
from .plan import Plan, plan_alone
from .schema import CHECKSUMS
from .sources import UnsortedFileError, check_unchanged
from .work_tile import Outcome, work_tile

Result = Filled | Outcome | Joined


@dataclass(frozen=True)
class Task:
    """A file to sort, one pass over a tile, or the join after a pass. `table` is "sources", "tiles" or "joins";
    `numbers` are global sums by step, `fulls` full color values of bucket files, `left` the number of items that tiles
    left for the join."""

    table: str
    number: int
    which_pass: int = 0
    numbers: dict[int, ExactSums] = field(default_factory=dict)
    fulls: dict[int, int] = field(default_factory=dict)
    left: dict[int, int] = field(default_factory=dict)


def do_task(plan: Plan, folder: Path, task: Task, owner: str) -> Result:
    if task.table == "sources":
        check_unchanged(plan.files[task.number])
        filled = fill_buckets(plan, folder, task.number, owner)
        try:
            check_unchanged(plan.files[task.number])
        except FileError:  # modified meanwhile: the rows are mixed
            shutil.rmtree(folder_of(folder, task.number), ignore_errors=True)
            raise
        return filled
    if task.table == "joins":
        step = plan.passes[task.number]
        assert step is not None
        left = BorderData(folder, step, task.left)
        return join_step(folder, step, plan.steps[step], left, owner)
    return work_tile(plan, folder, task.number, task.which_pass, task.numbers, task.fulls)


def do_task_alone(folder: str, functions: Iterable[str], task: Task, device: str) -> Result:
    """Run a task in a worker process, which opens the plan and imports the named functions."""
    plan = _plan_of(folder, (Path(folder) / NAME).stat().st_ino, (*functions,))
    plan.device = device
    return do_task(plan, Path(folder), task, REMOTE + uuid.uuid4().hex)


@lru_cache(maxsize=4)
def _plan_of(folder: str, inode: int, functions: tuple[str, ...]) -> Plan:
    return plan_alone(Path(folder), functions)


class Taskbook:
    """Claims and results of one run in a manifest; `part` is (index, count)."""

    def __init__(self, manifest: Manifest, plan: Plan, part: tuple[int, int], owner: str):
        self._manifest, self._plan, self.owner = manifest, plan, owner
        self._fraction: tuple[str, int, int] = ("id % ? = ?", part[1], part[0] - 1)
        self._numbers: dict[int, ExactSums] = {}
        self._fulls: dict[int, int] | None = None

    def take(self) -> Task | bool:
        """Claim the next task. True if one may follow, False if none is left."""
        manifest = self._manifest
        row = manifest.claim("sources", self.owner)
        if row is not None:
            self._fulls = None
            return Task("sources", row["id"])
        if manifest.has("sources", "failed", "aside"):
            return False
        if manifest.has("sources", "running"):
            self._fulls = None
            return True
        number = next_pass(manifest)
        if number is None:
            return False
        if number - 1 in self._plan.joined_passes and (task := self._join_task(number - 1)) is not None:
            return task
        here = (f"pass = ? AND {self._fraction[0]}", number, *self._fraction[1:])
        row = manifest.claim("tiles", self.owner, *here)
        if row is not None:
            return self._tile_task(row)
        left = manifest.counts("tiles", *self._fraction)
        if not (left["waiting"] or left["running"]):
            return False
        if manifest.counts("tiles", "pass = ?", number)["running"]:
            return True
        return bool(manifest.counts("tiles", *here)["waiting"])  # otherwise other parts still process this pass

    def _join_task(self, number: int) -> Task | bool | None:
        """Join after a pass. As `take`, or None if done."""
        if self._manifest.claim("joins", self.owner, "id = ?", number) is not None:
            rows = self._manifest.rows("SELECT tile, count FROM numbers WHERE pass = ? AND count > 0", number)
            return Task("joins", number, left={row["tile"]: row["count"] for row in rows})
        counts = self._manifest.counts("joins", "id = ?", number)
        return None if counts["done"] else bool(counts["running"])

    def _tile_task(self, row: Any) -> Task:
        for earlier, step in enumerate(self._plan.passes[: row["pass"]]):
            if step is not None and not self._plan.steps[step].joins and step not in self._numbers:
                self._numbers[step] = sums_of(self._manifest, earlier)
        if self._fulls is None:  # all files are sorted, so the values are final
            self._fulls = {
                source["id"]: source["full"] for source in self._manifest.rows("SELECT id, full FROM sources")
            }
        return Task("tiles", row["id"], row["pass"], dict(self._numbers), self._fulls)

    def do(self, task: Task, device: str) -> Result:
        self._plan.device = device
        return do_task(self._plan, self._manifest.folder, task, self.owner)

    def record(self, task: Task, result: Result) -> None:
        if isinstance(result, Filled):
            columns: dict[str, Any] = {"points": result.points, "full": result.full, "bytes": result.size}
            self._manifest.record("sources", task.number, self.owner, state="done", error=None, **columns)
            return
        if isinstance(result, Joined):
            self._manifest.record("joins", task.number, self.owner, state="done", error=None)
            return
        is_last = task.which_pass == len(self._plan.passes) - 1
        columns = {"points_in": result.points_in, "points_out": result.points_out, "error": None}
        columns |= {"state": ("done" if result.points_out else "empty") if is_last else "waiting"}
        columns["pass"] = task.which_pass if is_last else task.which_pass + 1
        with self._manifest.change() as base:
            if not self._manifest.record_in(base, "tiles", task.number, self.owner, **columns):
                return
            if result.checksum is not None:
                base.execute(CHECKSUMS)
                base.execute("INSERT OR REPLACE INTO checksums VALUES (?, ?)", (task.number, result.checksum))
            if not is_last:
                sums = result.sums or ExactSums()
                values = (task.which_pass, task.number, sums.count, hex(sums.total), hex(sums.squares))
                base.execute("INSERT OR REPLACE INTO numbers VALUES (?, ?, ?, ?, ?)", values)

    def fail(self, task: Task, error: Exception) -> None:
        """Record the error of a task. A tile that needs an unsorted file waits for it."""
        if isinstance(error, UnsortedFileError):
            self._fulls = None
            with self._manifest.change() as base:
                query = "UPDATE sources SET state = 'waiting' WHERE id = ? AND state = 'done' AND full = ?"
                base.execute(query, (error.args[0], UNSORTED_COLOR))
                self._manifest.record_in(base, task.table, task.number, self.owner, state="waiting")
            return
        self._manifest.record(task.table, task.number, self.owner, state="failed", error=message_of(error))

    def quarantine(self, task: Task, reason: str) -> None:
        self._manifest.record(task.table, task.number, self.owner, state="aside", error=reason)


def reset_missing_buckets(manifest: Manifest) -> None:
    """Reset files whose buckets are missing but needed by tiles."""
    counts = manifest.counts()
    if not counts["waiting"]:
        return
    with manifest.change() as base:
        for number, source in enumerate(files_of(manifest.plan)):
            if source["kind"] != "copc" and not folder_of(manifest.folder, number).is_dir():
                query = "UPDATE sources SET state = 'waiting' WHERE id = ? AND state = 'done' AND full != ?"
                base.execute(query, (number, UNSORTED_COLOR))


def next_pass(manifest: Manifest) -> int | None:
    """Current pass. The next one starts when all tiles are through."""
    query = "SELECT pass FROM tiles WHERE state = ? ORDER BY pass LIMIT 1"
    passes = [row["pass"] for state in STATES if state not in ("done", "empty") for row in manifest.rows(query, state)]
    return min(passes, default=None)


def sums_of(manifest: Manifest, number: int) -> ExactSums:
    total = ExactSums()
    for row in manifest.rows("SELECT * FROM numbers WHERE pass = ?", number):
        total += ExactSums(row["count"], int(row["total"], 16), int(row["squares"], 16))
    return total
