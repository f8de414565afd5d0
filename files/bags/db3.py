"""The SQLite files of rosbag2; of one that is cut short, the rows that are there."""

from __future__ import annotations

import contextlib
import sqlite3
from pathlib import Path

from ...core.errors import FileError
from ..source import open_source
from .pieces import Channel, Contents

MAGIC = b"SQLite format 3\0"


def read_db3(path: Path) -> Contents:
    """Find all messages of a file.

    Raises:
        FileError: No such file, or one whose list of topics cannot be read.
    """
    if open_source(path)[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is no SQLite file", where="byte 0")
    try:
        database = sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro&immutable=1", uri=True, check_same_thread=False)
        database.execute("PRAGMA writable_schema = ON")  # else a file with fewer pages than it says is not opened
        topics = database.execute("SELECT id, name, type, serialization_format FROM topics").fetchall()
    except sqlite3.Error as error:
        raise FileError(path, f"is no bag of ROS 2, or damaged at its beginning: {error}") from error
    found = Contents(path, lambda data, place: _payload(path, database, place), pieces=[lambda: b""])
    found.channels = {key: Channel(str(topic), str(kind), str(form)) for key, topic, kind, form in topics}
    try:
        for row, channel, time in database.execute("SELECT id, topic_id, timestamp FROM messages NOT INDEXED"):
            if isinstance(time, int) and isinstance(channel, int):
                found.entries.append((time, channel, 0, row))
    except sqlite3.Error as error:
        found.damage = f"is cut off or damaged after {len(found.entries)} messages: {error}"
    return found


def _payload(path: Path, database: sqlite3.Connection, place: int) -> bytes:
    with contextlib.closing(database.cursor()) as cursor:
        try:
            row = cursor.execute("SELECT data FROM messages WHERE id = ?", (place,)).fetchone()
        except sqlite3.Error as error:
            raise FileError(path, f"damaged: {error}", where=f"row {place}") from error
    if row is None or not isinstance(row[0], bytes):
        raise FileError(path, "a message is missing", where=f"row {place}")
    return row[0]
