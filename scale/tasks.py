"""The tasks of a job of tiles: files to be laid by tile, then tiles, pass after pass.

A task is claimed in the manifest, done by a function of the files alone, which may run anywhere, and settled.
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
from .borders import Joined, Leavings, join_step
from .buckets import REMOTE, Filled, fill_buckets, folder_of
from .exact_sums import ExactSums
from .manifest import NAME, NOT_LAID, STATES, Manifest, files_of, said_of
from .plan import Plan, plan_alone
from .schema import CHECKSUMS
from .sources import NotLaidError, check_same
from .work_tile import Outcome, work_tile

Found = Filled | Outcome | Joined


@dataclass(frozen=True)
class Task:
    """A file to be laid by tile, one pass over a tile, or the join of what all tiles left in a pass.

    Attributes:
        table: "sources", "tiles" or "joins".
        number: Of the file, the tile or the pass.
        which_pass: Over the tile.
        numbers: What those measured over all tiles, by the step that needs it.
        fulls: The value of a full colour of each file with buckets.
        left: How many things each tile left for the join, of those that left any.
    """

    table: str
    number: int
    which_pass: int = 0
    numbers: dict[int, ExactSums] = field(default_factory=dict)
    fulls: dict[int, int] = field(default_factory=dict)
    left: dict[int, int] = field(default_factory=dict)


def do_task(plan: Plan, folder: Path, task: Task, owner: str) -> Found:
    """Do a task."""
    if task.table == "sources":
        check_same(plan.files[task.number])
        filled = fill_buckets(plan, folder, task.number, owner)
        try:
            check_same(plan.files[task.number])
        except FileError:  # it was written to meanwhile: the rows are half of each
            shutil.rmtree(folder_of(folder, task.number), ignore_errors=True)
            raise
        return filled
    if task.table == "joins":
        step = plan.passes[task.number]
        assert step is not None
        left = Leavings(folder, step, task.left)
        return join_step(folder, step, plan.steps[step], left, owner)
    return work_tile(plan, folder, task.number, task.which_pass, task.numbers, task.fulls)


def do_task_alone(folder: str, functions: Iterable[str], task: Task, device: str) -> Found:
    """Do a task in a worker process, which opens the plan itself and claims nothing.

    Args:
        folder: Of the job.
        functions: Names of the functions that the caller passed, which are imported.
        task: The task.
        device: Where to compute.
    """
    plan = _plan_of(folder, (Path(folder) / NAME).stat().st_ino, (*functions,))
    plan.device = device
    return do_task(plan, Path(folder), task, REMOTE + uuid.uuid4().hex)


@lru_cache(maxsize=4)
def _plan_of(folder: str, inode: int, functions: tuple[str, ...]) -> Plan:
    return plan_alone(Path(folder), functions)


class Taskbook:
    """What one run claims and settles in a manifest.

    Args:
        manifest: Of the job.
        plan: Its plan.
        part: (which, of how many): its share of the tiles.
        owner: The run's name.
    """

    def __init__(self, manifest: Manifest, plan: Plan, part: tuple[int, int], owner: str):
        self._manifest, self._plan, self.owner = manifest, plan, owner
        self._share: tuple[str, int, int] = ("id % ? = ?", part[1], part[0] - 1)
        self._numbers: dict[int, ExactSums] = {}
        self._fulls: dict[int, int] | None = None

    def take(self) -> Task | bool:
        """Claim the next task; True where one may come once others are done, False where none is left."""
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
        here = (f"pass = ? AND {self._share[0]}", number, *self._share[1:])
        row = manifest.claim("tiles", self.owner, *here)
        if row is not None:
            return self._tile_task(row)
        left = manifest.counts("tiles", *self._share)
        if not (left["waiting"] or left["running"]):
            return False
        if manifest.counts("tiles", "pass = ?", number)["running"]:
            return True
        return bool(manifest.counts("tiles", *here)["waiting"])  # else other shares have tiles of this pass to do

    def _join_task(self, number: int) -> Task | bool | None:
        """The join that a pass is followed by; as `take`, or None where it is done."""
        if self._manifest.claim("joins", self.owner, "id = ?", number) is not None:
            rows = self._manifest.rows("SELECT tile, count FROM numbers WHERE pass = ? AND count > 0", number)
            return Task("joins", number, left={row["tile"]: row["count"] for row in rows})
        counts = self._manifest.counts("joins", "id = ?", number)
        return None if counts["done"] else bool(counts["running"])

    def _tile_task(self, row: Any) -> Task:
        for earlier, step in enumerate(self._plan.passes[: row["pass"]]):
            if step is not None and not self._plan.steps[step].joins and step not in self._numbers:
                self._numbers[step] = sums_of(self._manifest, earlier)
        if self._fulls is None:  # all files are laid, so they stay
            self._fulls = {found["id"]: found["full"] for found in self._manifest.rows("SELECT id, full FROM sources")}
        return Task("tiles", row["id"], row["pass"], dict(self._numbers), self._fulls)

    def do(self, task: Task, device: str) -> Found:
        """Do a task in this process."""
        self._plan.device = device
        return do_task(self._plan, self._manifest.folder, task, self.owner)

    def settle(self, task: Task, found: Found) -> None:
        """Write down what came of a task."""
        if isinstance(found, Filled):
            told: dict[str, Any] = {"points": found.points, "full": found.full, "bytes": found.size}
            self._manifest.settle("sources", task.number, self.owner, state="done", error=None, **told)
            return
        if isinstance(found, Joined):
            self._manifest.settle("joins", task.number, self.owner, state="done", error=None)
            return
        is_last = task.which_pass == len(self._plan.passes) - 1
        told = {"points_in": found.points_in, "points_out": found.points_out, "error": None}
        told |= {"state": ("done" if found.points_out else "empty") if is_last else "waiting"}
        told["pass"] = task.which_pass if is_last else task.which_pass + 1
        with self._manifest.change() as base:
            if not self._manifest.settle_in(base, "tiles", task.number, self.owner, **told):
                return
            if found.checksum is not None:
                base.execute(CHECKSUMS)
                base.execute("INSERT OR REPLACE INTO checksums VALUES (?, ?)", (task.number, found.checksum))
            if not is_last:
                sums = found.sums or ExactSums()
                values = (task.which_pass, task.number, sums.count, hex(sums.total), hex(sums.squares))
                base.execute("INSERT OR REPLACE INTO numbers VALUES (?, ?, ?, ?, ?)", values)

    def fail(self, task: Task, error: Exception) -> None:
        """Write down that a task ended in an error, which would come again.

        A tile that needs a file which is not laid waits for that.
        """
        if isinstance(error, NotLaidError):
            self._fulls = None
            with self._manifest.change() as base:
                told = "UPDATE sources SET state = 'waiting' WHERE id = ? AND state = 'done' AND full = ?"
                base.execute(told, (error.args[0], NOT_LAID))
                self._manifest.settle_in(base, task.table, task.number, self.owner, state="waiting")
            return
        self._manifest.settle(task.table, task.number, self.owner, state="failed", error=said_of(error))

    def set_aside(self, task: Task, reason: str) -> None:
        """Write down that workers died at a task."""
        self._manifest.settle(task.table, task.number, self.owner, state="aside", error=reason)


def lay_again(manifest: Manifest) -> None:
    """Have files wait whose rows by tile are gone, where tiles need them."""
    counts = manifest.counts()
    if not counts["waiting"]:
        return
    with manifest.change() as base:
        for number, source in enumerate(files_of(manifest.plan)):
            if source["kind"] != "copc" and not folder_of(manifest.folder, number).is_dir():
                told = "UPDATE sources SET state = 'waiting' WHERE id = ? AND state = 'done' AND full != ?"
                base.execute(told, (number, NOT_LAID))


def next_pass(manifest: Manifest) -> int | None:
    """The pass that tiles are to be done in now: one begins where all are through the one before."""
    query = "SELECT pass FROM tiles WHERE state = ? ORDER BY pass LIMIT 1"
    found = [row["pass"] for state in STATES if state not in ("done", "empty") for row in manifest.rows(query, state)]
    return min(found, default=None)


def sums_of(manifest: Manifest, number: int) -> ExactSums:
    """The sums of a pass over all tiles."""
    total = ExactSums()
    for row in manifest.rows("SELECT * FROM numbers WHERE pass = ?", number):
        total += ExactSums(row["count"], int(row["total"], 16), int(row["squares"], 16))
    return total
