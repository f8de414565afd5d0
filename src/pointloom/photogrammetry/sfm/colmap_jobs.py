"""Jobs for the COLMAP process: results, progress, and error messages."""

from __future__ import annotations

import contextlib
import json
import os
import select
import shutil
import sqlite3
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any
from urllib.parse import quote

from ...core.errors import FileError
from ...core.sqlite_files import check_no_code, protect
from ...core.wording import format_bytes
from .limited_process import LimitedProcess, python_command

_WORKER = Path(__file__).with_name("colmap_worker.py")
_POLL_INTERVAL = 0.5  # [s]
_PEEK_INTERVAL = 0.01  # [s]
_READ_AT_ONCE = 1 << 16
_NEW_DATABASE = "photogrammetry.find_features creates one"
_LITTLE_SPACE = 1 << 20  # [B] free space that counts as a full disk
_SPACE = "Free some space, or work in another folder"
_FULL_DISK = ("disk is full", "No space left", "disk I/O error")

MAX_SECONDS = 4 * 3600.0  # per stage: 150 images take minutes

Report = Callable[[dict[str, Any]], None]


def run_job(
    job: dict[str, Any],
    path: Path,
    *,
    max_seconds: float,
    max_memory: int | None,
    poll: Callable[[], None] | None = None,
    report: Report | None = None,
) -> tuple[dict[str, Any], int]:
    """Run a COLMAP job. Returns its result and peak memory [B]. FileError if it fails or passes a limit."""
    command = python_command(_WORKER)
    last: dict[str, Any] = {}
    with LimitedProcess(command, max_seconds=max_seconds, max_memory=max_memory, stdin=json.dumps(job)) as process:
        for message in _messages(process, poll):
            last = message
            if report is not None and not message.keys() & {"done", "failed", "missing"}:
                report(message)
        if "done" in last and process.wait() == 0:
            if poll is not None:
                poll()
            return last["done"], process.peak_bytes
        reason, remedy = _what_failed(job["stage"], last, process, Path(job["database"]).parent.parent)
    raise FileError(path, reason, remedy=remedy)


def _messages(process: LimitedProcess, poll: Callable[[], None] | None) -> Iterator[dict[str, Any]]:
    assert process.stdout is not None
    handle, rest = process.stdout.fileno(), b""
    while True:
        if not _has_output(handle):
            if poll is not None:
                poll()
            continue
        read = os.read(handle, _READ_AT_ONCE)
        if not read:
            return
        *lines, rest = (rest + read).split(b"\n")
        for line in lines:
            with contextlib.suppress(ValueError):
                message = json.loads(line)
                if isinstance(message, dict):
                    yield message


def _has_output(handle: int) -> bool:
    """Wait until a pipe has output or has ended, or for the polling interval."""
    if sys.platform != "win32":
        return bool(select.select([handle], [], [], _POLL_INTERVAL)[0])
    import _winapi  # `select` takes sockets only
    import msvcrt

    end = time.monotonic() + _POLL_INTERVAL
    while time.monotonic() < end:
        try:
            if _winapi.PeekNamedPipe(msvcrt.get_osfhandle(handle), 0)[0]:  # type: ignore[attr-defined]
                return True
        except BrokenPipeError:  # ended
            return True
        time.sleep(_PEEK_INTERVAL)
    return False


_NOUNS = {"features": "finding features", "matches": "matching", "model": "mapping", "points": "triangulation"}


def _what_failed(stage: str, last: dict[str, Any], process: LimitedProcess, folder: Path) -> tuple[str, str]:
    noun = _NOUNS[stage]
    if "missing" in last:
        return "structure from motion needs the package pycolmap", 'pip install "pointloom[sfm]"'
    words = " / ".join(filter(None, (str(last.get("failed", "")), process.last_words())))
    output = f"; its last output: {words}" if words else ""
    if process.killed_for == "time":
        return f"{noun} {process.why_ended()}{output}", "Give it more time, or fewer or smaller images"
    if process.killed_for == "memory" or "out of memory" in words:
        return f"{noun} {process.why_ended()}{output}", "Give it more memory, or fewer or smaller images"
    free_bytes = shutil.disk_usage(folder).free
    if free_bytes < _LITTLE_SPACE or any(text in words for text in _FULL_DISK):
        reason = f"{noun} failed with {format_bytes(free_bytes)} free on the disk of {folder}{output}"
        return reason, _SPACE
    if "failed" in last:
        return f"{noun} failed: {words}", ""
    remedy = "Run it again; the system sends SIGKILL if memory runs out: fewer or smaller images need less"
    return f"{noun} {process.why_ended()}{output}", remedy


@contextlib.contextmanager
def open_database(path: Path) -> Iterator[sqlite3.Connection]:
    """Open COLMAP's database for reading, even while COLMAP writes to it."""
    if not path.is_file():
        reason = "is not a COLMAP database" if path.exists() else "does not exist"
        raise FileError(path, reason, remedy=_NEW_DATABASE)
    try:
        with contextlib.closing(sqlite3.connect(f"file:{quote(os.fspath(path))}?mode=ro", uri=True)) as database:
            protect(database, path)
            check_no_code(database, path, remedy=_NEW_DATABASE)
            yield database
    except FileError:
        raise
    except (sqlite3.Error, TypeError, ValueError, OverflowError) as error:  # SQLite stores any type in any column
        raise FileError(path, f"cannot be read as a COLMAP database: {error}", remedy=_NEW_DATABASE) from error


def names_by_number(database: sqlite3.Connection, path: Path) -> dict[int, str]:
    """The names of the images by their numbers, which ascend. Raises `FileError` for values of other types."""
    rows = database.execute("SELECT image_id, name FROM images ORDER BY image_id").fetchall()
    for number, name in rows:
        if type(number) is not int or not isinstance(name, str) or not name or "\0" in name:
            reason = f"expected a number and a name per image, got {number!r} and {name!r}"
            raise FileError(path, reason[:200], remedy=_NEW_DATABASE)
    return dict(rows)


def count_rows(path: Path, table: str) -> int:
    with contextlib.suppress(FileError), open_database(path) as database:
        return database.execute(f"SELECT count(*) FROM {table}").fetchone()[0]
    return 0


@contextlib.contextmanager
def database_in_the_making(target: Path) -> Iterator[Path]:
    """A temporary database path, renamed at the end, or removed on errors."""
    with scratch_beside(target) as folder:
        part = folder / "database.db"
        yield part
        with contextlib.closing(sqlite3.connect(part)) as database:
            database.execute("PRAGMA journal_mode=DELETE")  # merge COLMAP's journal into the file
        part.replace(target)


@contextlib.contextmanager
def scratch_beside(target: Path) -> Iterator[Path]:
    """A temporary folder on the target's disk; disk errors name the target."""
    try:
        with tempfile.TemporaryDirectory(prefix=f".{target.name}.", dir=target.parent) as folder:
            yield Path(folder)
    except FileError:
        raise
    except (OSError, sqlite3.Error) as error:
        reason = str(getattr(error, "strerror", None) or error)
        remedy = _SPACE if any(text in reason for text in _FULL_DISK) else ""
        raise FileError(target, f"cannot be written: {reason}", remedy=remedy) from error
