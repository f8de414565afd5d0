"""Manifest of a job: one SQLite file with its plan, tasks and owners.

Changes are transactions, so processes of one machine, or of several on a file system with locks, can share a folder. An
owner has a locked file, which the system releases when its process ends. Then its claims are returned.
"""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
import os
import re
import sqlite3
import uuid
from collections.abc import Container, Iterable, Iterator
from pathlib import Path
from typing import Any

from ..core.checks import shown
from ..core.errors import FileError
from ..core.json_fields import Checks, builds, is_count, optional
from ..core.paths import refuse_links
from ..core.sqlite_files import check_no_code, check_tables, protect
from .plan_check import check_plan
from .schema import CHECKSUMS, TASKS, TILES, check_schema

try:
    import fcntl
except ImportError:  # Windows
    fcntl = None

NAME, LOCKS = "plan.sqlite", "locks"
SCHEMA_VERSION = 3
TABLES = ("sources", "tiles", "joins")  # of tasks
MAX_ATTEMPTS = 3  # worker deaths per task
DIED = f"the worker died {MAX_ATTEMPTS} times at this task, because of memory or an error in a step"
LOCK_TIMEOUT = 60.0  # [s] for another transaction
_REMEDIES = {  # for a missing or different manifest, by whether a job other than tiles is expected
    False: "Call plan_tiles(sources, steps, folder) first, then run_tiles",
    True: "Call plan_fusion or plan_registration first, then run_job",
}
STATES = ("waiting", "running", "done", "empty", "failed", "aside")
# Types of the columns, and of the sums `a`, `b` and `n` of them.
COLUMNS: Checks = {
    **dict.fromkeys(("id", "ix", "iy", "attempts", "points", "points_in", "points_out", "tile", "count"), is_count),
    **dict.fromkeys(("pass", "crc", "a", "b", "n"), optional(is_count)), "full": lambda value: isinstance(value, int),
    **dict.fromkeys(("bytes", "stage"), is_count), "state": lambda value: value in STATES,
    **dict.fromkeys(("owner", "error", "found"), optional(builds(str.encode))),
    **dict.fromkeys(("name", "told", "value"), builds(str.encode)),
    **dict.fromkeys(("total", "squares"), builds(lambda value: int(value, 16))),
}  # fmt: skip
# Python's errors for values in another format.
DAMAGE = (EOFError, LookupError, TypeError, ValueError, AttributeError, OverflowError, RecursionError)
DISTRIBUTES = " distributes"
_OWNER = re.compile(r"[0-9A-Za-z ]{1,64}")
UNSORTED_COLOR = -1  # instead of a full color: a file far from all tiles
FINAL_STATES = ("done", "empty", "failed", "aside")  # final states, reset only by `retry`


def canonical(plan: object) -> str:
    """Canonical text of a plan or a part of it."""
    return json.dumps(plan, sort_keys=True, separators=(",", ":"), allow_nan=False)


def files_of(plan: dict[str, Any]) -> list[dict[str, Any]]:
    """Descriptions of all files by number: the survey's, then those of compared epochs."""
    return [*plan["sources"], *(source for epoch in plan["epochs"] for source in epoch["sources"])]


def message_of(error: Exception) -> str:
    return " ".join(f"{type(error).__name__}: {error}".split())[:2000]


def hash_of(plan: dict[str, Any]) -> str:
    return hashlib.sha256(canonical(plan).encode()).hexdigest()


class Manifest:
    """An open manifest, for one thread: `folder`, `plan` in JSON's types, `version` of pointloom that planned it."""

    def __init__(self, folder: Path, *, is_job: bool = False):
        """Open a manifest of tiles or another job (jobs/job.py). FileError if missing or of another kind."""
        self.folder, path = folder, folder / NAME
        try:
            is_there = path.is_file()
        except OSError as error:
            raise FileError(path, f"cannot be read: {error.strerror or error}") from error
        if not is_there:
            raise FileError(path, "does not exist", remedy=_REMEDIES[is_job])
        refuse_links(folder)
        self.base = connect(path)
        try:
            check_no_code(self.base, path, remedy="Plan it again in another folder")
            meta = dict(self.base.execute("SELECT key, value FROM meta").fetchall())
            if meta.get("schema") != str(SCHEMA_VERSION):
                reason = f"expected a manifest of schema {SCHEMA_VERSION}, got schema {meta.get('schema')}"
                raise FileError(path, reason, remedy="Plan it again in another folder")
            self.plan: dict[str, Any] = json.loads(meta["plan"])
            self.version = meta["version"]
            if hash_of(self.plan) != meta["hash"]:
                raise FileError(path, "its plan does not match its hash", remedy="Plan it again in another folder")
            if ("job" in self.plan) != is_job:
                raise FileError(path, f"is a job of {self.plan.get('job', 'tiles')}", remedy=_REMEDIES[not is_job])
            check_schema(self.base, TASKS if is_job else TILES)
            if not is_job:
                check_plan(self.plan)
        except (sqlite3.DatabaseError, KeyError, ValueError, TypeError, AttributeError, RecursionError) as error:
            self.base.close()
            if isinstance(error, FileError):
                raise
            code = getattr(error, "sqlite_errorcode", sqlite3.SQLITE_ERROR)
            if isinstance(error, sqlite3.OperationalError) and code != sqlite3.SQLITE_ERROR:  # full disk, permissions
                raise FileError(path, f"the manifest cannot be used: {error}") from error
            raise FileError(path, f"is not a manifest: {error}", remedy="Plan it again") from error
        self.tables = ("tasks",) if is_job else TABLES
        if not is_job:
            self._check_ids()

    def _check_ids(self) -> None:
        """Raise FileError if a row names a file, tile or pass that the plan does not have."""
        counts = len(files_of(self.plan)), math.prod(self.plan["shape"]), len(self.plan["steps"]) + 1
        for table, count in zip(TABLES, counts, strict=True):
            for row in self.rows(f"SELECT id FROM {table} WHERE id < 0 OR id >= {count} LIMIT 1"):
                reason = f"the manifest is damaged: {table} has no number {row['id']}"
                raise FileError(self.folder / NAME, reason, remedy="Plan it again in another folder")

    def __enter__(self) -> Manifest:
        return self

    def __exit__(self, *_: object) -> None:
        self.base.close()

    @contextlib.contextmanager
    def change(self) -> Iterator[sqlite3.Connection]:
        with as_file_errors(self.folder / NAME):
            self.base.execute("BEGIN IMMEDIATE")
            try:
                yield self.base
                self.base.execute("COMMIT")
            except BaseException:
                if self.base.in_transaction:  # a full disk may have ended it
                    self.base.execute("ROLLBACK")
                raise

    def rows(self, query: str, *values: Any) -> list[sqlite3.Row]:
        with as_file_errors(self.folder / NAME):
            return self._checked(self.base.execute(query, values).fetchall())

    def _checked(self, rows: list[sqlite3.Row]) -> list[sqlite3.Row]:
        """The rows, if their values have the types of their columns. SQLite stores values of any type."""
        for k, name in enumerate(rows[0].keys() if rows else ()):
            is_right = COLUMNS.get(name, lambda _: True)
            for row in rows:
                if not is_right(row[k]):
                    reason = f"the manifest is damaged: {name} is {shown(row[k])}"
                    raise FileError(self.folder / NAME, reason, remedy="Plan it again in another folder")
        return rows

    def claim(self, table: str, owner: str, where: str = "1", *values: Any) -> sqlite3.Row | None:
        """Claim the first waiting row of a table for a worker. None if there is none."""
        with self.change() as base:
            query = f"SELECT * FROM {table} WHERE state = 'waiting' AND {where} ORDER BY id LIMIT 1"
            rows = self._checked(base.execute(query, values).fetchall())
            for row in rows:
                base.execute(f"UPDATE {table} SET state = 'running', owner = ? WHERE id = ?", (owner, row["id"]))
        return rows[0] if rows else None

    def record(self, table: str, row: int, owner: str, **values: Any) -> bool:
        """Record the result of a claimed row. False if the worker no longer owns it."""
        with self.change() as base:
            return self.record_in(base, table, row, owner, **values)

    @staticmethod
    def record_in(base: sqlite3.Connection, table: str, row: int, owner: str, **values: Any) -> bool:
        assignments = ", ".join(f"{name} = ?" for name in values)
        query = f"UPDATE {table} SET {assignments}, owner = NULL WHERE id = ? AND owner = ? AND state = 'running'"
        return base.execute(query, (*values.values(), row, owner)).rowcount == 1

    def release_claims(self, *, is_death: bool = True) -> int:
        """Release the claims of dead workers. Returns the number of rows. A task is quarantined after several deaths. A
        requested stop does not count."""
        given = 0
        for owner in self.owners():
            lock = lock_of(self.folder, owner)
            if not is_dead(self.folder, owner):
                continue
            counted = int(is_death and not owner.endswith(DISTRIBUTES))
            with self.change() as base:
                for table in self.tables:
                    query = (
                        f"UPDATE {table} SET attempts = attempts + {counted}, owner = NULL,"
                        f" error = CASE WHEN attempts + {counted} >= ? THEN ? ELSE error END,"
                        f" state = CASE WHEN attempts + {counted} >= ? THEN 'aside' ELSE 'waiting' END"
                        " WHERE owner = ? AND state = 'running'"
                    )
                    given += base.execute(query, (MAX_ATTEMPTS, DIED, MAX_ATTEMPTS, owner)).rowcount
            lock.unlink(missing_ok=True)
        return given

    def owners(self) -> list[str]:
        queries = [f"SELECT owner FROM {table} WHERE state = 'running'" for table in self.tables]
        return [row["owner"] for row in self.rows(" UNION ".join(queries))]

    def has(self, table: str, *states: str) -> bool:
        """True if rows have one of these states, by index."""
        query = f"SELECT 1 FROM {table} WHERE state IN ({', '.join('?' * len(states))}) LIMIT 1"
        return bool(self.rows(query, *states))

    def counts(self, table: str = "tiles", where: str = "1", *values: Any) -> dict[str, int]:
        """Number of rows in each state."""
        rows = self.rows(f"SELECT state, count(*) AS n FROM {table} WHERE {where} GROUP BY state", *values)
        return {state: 0 for state in STATES} | {row["state"]: row["n"] for row in rows}


def connect(path: Path) -> sqlite3.Connection:
    with as_file_errors(path):
        base = sqlite3.connect(path, timeout=LOCK_TIMEOUT, isolation_level=None)
        base.row_factory = sqlite3.Row
        protect(base, path)
        if is_shared(path.parent):
            _leave_log(base, path)
        else:  # a power failure may lose finished work, a killed process does not
            base.execute("PRAGMA synchronous = NORMAL")
        return base


def _leave_log(base: sqlite3.Connection, path: Path) -> None:
    """Disable SQLite's write-ahead log, which works for one machine only."""
    try:
        base.execute("PRAGMA journal_mode = DELETE")
    except sqlite3.OperationalError as error:
        base.close()
        reason = f"the manifest is in use on the machine with its disk, without access for other machines: {error}"
        raise FileError(
            path, reason, remedy="End the runs on that machine, or start all runs on machines that mount the folder"
        ) from error


def read_plan(folder: Path) -> dict[str, Any]:
    """Read the immutable plan, without a lock."""
    path = folder / NAME
    with as_file_errors(path):
        try:
            is_there = path.is_file()
        except OSError as error:
            raise FileError(path, f"cannot be read: {error.strerror or error}") from error
        if not is_there:
            raise FileError(path, "does not exist", remedy="Mount the folder under the same path for all workers")
        base = sqlite3.connect(f"{path.absolute().as_uri()}?immutable=1", uri=True)
        with contextlib.closing(base), damage_as_file_errors(path):
            protect(base, path)
            check_tables(base, path, ["meta"])
            (text,) = base.execute("SELECT value FROM meta WHERE key = 'plan'").fetchone()
            plan = json.loads(text)
            check_plan(plan)
            return plan


def write_manifest(
    folder: Path,
    plan: dict[str, Any],
    version: str,
    tiles: list[tuple[Any, ...]],
    far: Container[int] = (),
    joins: Iterable[int] = (),
) -> None:
    """Write a new manifest of tiles atomically. Tiles are (id, ix, iy, x0, y0, x1, y1); `far` are unneeded files,
    `joins` the passes followed by a join."""
    with new_manifest(folder, plan, version, TILES + CHECKSUMS) as base:
        has_windows = [source["kind"] == "copc" for source in files_of(plan)]
        rows = [
            (k, "done" if windows or k in far else "waiting", UNSORTED_COLOR if k in far else 0)
            for k, windows in enumerate(has_windows)
        ]
        base.executemany("INSERT INTO sources (id, state, full) VALUES (?, ?, ?)", rows)
        base.executemany("INSERT INTO tiles (id, ix, iy, x0, y0, x1, y1) VALUES (?, ?, ?, ?, ?, ?, ?)", tiles)
        base.executemany("INSERT INTO joins (id) VALUES (?)", [(number,) for number in joins])


@contextlib.contextmanager
def new_manifest(folder: Path, plan: dict[str, Any], version: str, tables: str) -> Iterator[sqlite3.Connection]:
    """Manifest with a plan and empty tables, renamed to its final name when the block ends."""
    path, part = folder / NAME, folder / f"{NAME}.{uuid.uuid4().hex}.part"
    base = connect(part)
    with as_file_errors(path):
        try:
            base.executescript(tables)
            base.execute("BEGIN")
            meta = {"schema": str(SCHEMA_VERSION), "version": version, "plan": canonical(plan), "hash": hash_of(plan)}
            base.executemany("INSERT INTO meta VALUES (?, ?)", meta.items())
            yield base
            base.execute("COMMIT")
            if not is_shared(folder):
                base.execute("PRAGMA journal_mode = WAL")
            base.close()
            os.link(part, path)  # fails if another process created it
        except FileExistsError as error:
            raise FileError(
                path, "another process is planning a job in this folder", remedy="Wait until it has finished"
            ) from error
        finally:
            base.close()
            part.unlink(missing_ok=True)


@contextlib.contextmanager
def as_file_errors(path: Path) -> Iterator[None]:
    """Convert errors of SQLite and the system to FileError."""
    try:
        yield
    except (sqlite3.Error, UnicodeDecodeError) as error:  # a damaged schema, which SQLite quotes
        raise FileError(path, f"the manifest cannot be used: {error}") from error
    except FileError:
        raise
    except OSError as error:
        raise FileError(path, f"cannot be written: {error.strerror or error}") from error


@contextlib.contextmanager
def damage_as_file_errors(path: Path) -> Iterator[None]:
    """Convert errors about the content of a plan or task to FileError."""
    try:
        yield
    except FileError:
        raise
    except DAMAGE as error:
        reason = f"the manifest is damaged: {type(error).__name__}: {error}"
        raise FileError(path, reason, remedy="Plan it again in another folder") from error


def lock_of(folder: Path, owner: Any) -> Path:
    """Path of a worker's lock. FileError if the owner's name is invalid, such as a path."""
    if not isinstance(owner, str) or not _OWNER.fullmatch(owner):
        reason = f"the manifest is damaged: expected the name of a worker, got {owner!r}"
        raise FileError(folder / NAME, reason, remedy="Plan it again in another folder")
    return folder / LOCKS / owner


@contextlib.contextmanager
def worker_lock(folder: Path, *, computes: bool = True) -> Iterator[str]:
    """Name of an owner of tasks for the duration of the block, or until the process ends. A process that only
    distributes tasks has a name ending in DISTRIBUTES. Its death is not counted against tasks."""
    owner = uuid.uuid4().hex + ("" if computes else DISTRIBUTES)
    path = lock_of(folder, owner)
    with as_file_errors(path):
        path.parent.mkdir(exist_ok=True)
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        if fcntl is not None:
            with as_file_errors(path):
                fcntl.flock(descriptor, fcntl.LOCK_EX)
        yield owner
    finally:
        if fcntl is None:  # Windows removes no open file
            os.close(descriptor)
        path.unlink(missing_ok=True)
        if fcntl is not None:
            os.close(descriptor)


@contextlib.contextmanager
def exclusive(folder: Path, name: str) -> Iterator[None]:
    """Enter a named block exclusively. FileError if another process is in it."""
    path = folder / LOCKS / name
    with as_file_errors(path):
        path.parent.mkdir(exist_ok=True)
        descriptor = os.open(path, os.O_RDWR | os.O_CREAT, 0o666)
    try:
        if fcntl is not None:
            try:
                fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except OSError as error:
                raise FileError(folder, f"another process is running `{name}` on this job") from error
        yield
        if fcntl is not None:
            path.unlink(missing_ok=True)
    finally:
        os.close(descriptor)


def clear_locks(folder: Path) -> None:
    """Remove locks of dead workers when no task is left. A worker that starts now is ignored."""
    for path in (folder / LOCKS).glob("*"):
        if _OWNER.fullmatch(path.name) and is_dead(folder, path.name):
            path.unlink(missing_ok=True)


def is_dead(folder: Path, owner: str) -> bool:
    """True if no process holds a worker's lock."""
    try:
        descriptor = os.open(lock_of(folder, owner), os.O_RDWR)
    except (FileNotFoundError, FileError):  # no worker has another name
        return True
    try:
        if fcntl is None:
            return False
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except OSError:
        return False
    else:
        return True
    finally:
        os.close(descriptor)


MOUNTS = Path("/proc/self/mountinfo")  # Linux; elsewhere folders count as local
OVER_NETWORKS = {
    "9p", "afs", "beegfs", "ceph", "cifs", "coda", "davfs", "glusterfs", "gpfs", "juicefs", "lustre", "ncpfs", "nfs",
    "nfs4", "ocfs2", "orangefs", "panfs", "pvfs2", "rclone", "s3fs", "smb3", "smbfs", "sshfs", "vboxsf", "virtiofs",
    "wekafs",
}  # fmt: skip


def is_shared(folder: Path) -> bool:
    """True if the file system type allows access from other machines."""
    try:
        lines = MOUNTS.read_text(encoding="utf-8").splitlines()
        resolved = folder.resolve()
    except OSError:
        return False
    file_system, deepest = "", -1
    for line in lines:
        before, _, after = line.partition(" - ")
        mount, kind = Path(_unescaped(before.split()[4])), after.split()[0]
        if resolved.is_relative_to(mount) and len(mount.parts) >= deepest:  # later mounts hide earlier ones
            file_system, deepest = kind, len(mount.parts)
    return file_system.removeprefix("fuse.") in OVER_NETWORKS


def _unescaped(text: str) -> str:
    """Path from the mount table, which escapes spaces as \\040."""
    return re.sub(r"\\([0-7]{3})", lambda code: chr(int(code[1], 8)), text)
