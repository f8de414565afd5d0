"""SQLite files of rosbag2; truncated ones yield their readable rows."""

from __future__ import annotations

import contextlib
import sqlite3
from pathlib import Path
from typing import Any

from ...core.errors import FileError
from ...core.sqlite_files import CutPage, ascending, check_tables, protect
from ..source import open_source
from .message_chunks import Channel, Contents

MAGIC = b"SQLite format 3\0"
_TABLES = ("topics", "messages")


def read_db3(path: Path) -> Contents:
    source: Any = open_source(path)
    if source[: len(MAGIC)] != MAGIC:
        raise FileError(path, "is not a SQLite file", where="byte 0")
    try:
        database = sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro&immutable=1", uri=True, check_same_thread=False)
        database.execute("PRAGMA writable_schema = ON")  # otherwise a file with missing pages cannot be opened
        protect(database, path, is_bounded=True)
        check_tables(database, path, _TABLES)
        cut = CutPage(database, source, _TABLES)
        contents = Contents(path, _Payload(path, database, cut), pieces=[lambda: b""])
        query = "SELECT rowid, id, name, type, serialization_format FROM topics NOT INDEXED"
        for row, key, *texts in ascending(path, database.execute(query)):
            is_cut = cut.bytes and any("\0" in str(text) for text in texts)  # on an overflow page
            if not is_cut and not cut.contains("topics", row, beginning=True):
                contents.add_channel(key, Channel(*map(str, texts)))
    except sqlite3.Error as error:
        raise FileError(path, f"is not a ROS 2 bag, or is damaged at its beginning: {error}") from error
    _find_messages(path, database, contents, cut)
    database.set_progress_handler(None, 0)  # from now on rows are read one by one
    return contents


def _find_messages(path: Path, database: sqlite3.Connection, contents: Contents, cut: CutPage) -> None:
    unusable = 0
    try:
        query = "SELECT rowid, topic_id, timestamp FROM messages NOT INDEXED"
        for row, channel, time in ascending(path, database.execute(query)):
            if cut.contains("messages", row, beginning=True):
                continue
            if isinstance(time, int) and isinstance(channel, int):
                contents.entries.append((time, channel, 0, row))
            else:
                unusable += 1
        if unusable:
            contents.note(f"has {unusable} rows without a time or topic, which were left out")
        if cut.bytes:
            contents.note(f"is cut off after {len(contents.entries)} messages: its last page has {cut.bytes} bytes")
        _compare_with_index(database, contents)
    except (sqlite3.Error, FileError) as error:
        contents.note(f"is cut off or damaged after {len(contents.entries)} messages: {error}")


def _compare_with_index(database: sqlite3.Connection, contents: Contents) -> None:
    """Compare rows with the time index of ROS: damaged pages can lose rows without an error."""
    indexes = [row[1] for row in database.execute("PRAGMA main.index_list(messages)") if not row[4]]
    for name in indexes:
        if [row[2] for row in database.execute("SELECT * FROM pragma_index_info(?)", (name,))] != ["timestamp"]:
            continue
        quoted = '"' + name.replace('"', '""') + '"'
        query = f"SELECT timestamp, rowid FROM messages INDEXED BY {quoted} WHERE timestamp IS NOT NULL"
        count, check = 0, sum(hash((time, row)) for time, _, _, row in contents.entries)
        for time, row in database.execute(query):
            count, check = count + 1, check - hash((time, row))
        if count != len(contents.entries) or check:
            contents.note(f"has an index of {count} messages that contradicts its {len(contents.entries)} rows")


class _Payload:
    def __init__(self, path: Path, database: sqlite3.Connection, cut: CutPage):
        self._path, self._database, self._cut = path, database, cut

    def __call__(self, _: bytes, row_id: int, channel: int, time: int) -> bytes:
        query = "SELECT data FROM messages NOT INDEXED WHERE rowid = ? AND topic_id = ? AND timestamp = ?"
        with contextlib.closing(self._database.cursor()) as cursor:
            try:
                row = cursor.execute(query, (row_id, channel, time)).fetchone()
            except sqlite3.Error as error:
                raise FileError(self._path, f"damaged: {error}", where=f"row {row_id}") from error
        if self._cut.contains("messages", row_id):
            raise FileError(self._path, "a message is cut off", where=f"row {row_id}")
        if row is None or not isinstance(row[0], bytes):
            raise FileError(self._path, "a message is missing", where=f"row {row_id}")
        return row[0]
