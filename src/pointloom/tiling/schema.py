"""Tables of a manifest."""

from __future__ import annotations

import contextlib
import sqlite3

TILES = """
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE sources (
    id INTEGER PRIMARY KEY, state TEXT NOT NULL DEFAULT 'waiting', owner TEXT, attempts INTEGER NOT NULL DEFAULT 0,
    points INTEGER NOT NULL DEFAULT 0, full INTEGER NOT NULL DEFAULT 0, bytes INTEGER NOT NULL DEFAULT 0, error TEXT);
CREATE TABLE tiles (
    id INTEGER PRIMARY KEY, ix INTEGER NOT NULL, iy INTEGER NOT NULL, x0 REAL, y0 REAL, x1 REAL, y1 REAL,
    state TEXT NOT NULL DEFAULT 'waiting', pass INTEGER NOT NULL DEFAULT 0, owner TEXT,
    attempts INTEGER NOT NULL DEFAULT 0, points_in INTEGER NOT NULL DEFAULT 0, points_out INTEGER NOT NULL DEFAULT 0,
    error TEXT);
CREATE TABLE joins (
    id INTEGER PRIMARY KEY, state TEXT NOT NULL DEFAULT 'waiting', owner TEXT, attempts INTEGER NOT NULL DEFAULT 0,
    error TEXT);
CREATE INDEX tiles_by_state ON tiles (state, pass, id);
CREATE INDEX sources_by_state ON sources (state);
CREATE TABLE numbers (
    pass INTEGER, tile INTEGER, count INTEGER NOT NULL, total TEXT NOT NULL, squares TEXT NOT NULL,
    PRIMARY KEY (pass, tile));
"""
TASKS = """
CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT NOT NULL);
CREATE TABLE tasks (
    id INTEGER PRIMARY KEY, stage INTEGER NOT NULL, name TEXT NOT NULL, told TEXT NOT NULL, found TEXT,
    state TEXT NOT NULL DEFAULT 'waiting', owner TEXT, attempts INTEGER NOT NULL DEFAULT 0, error TEXT);
CREATE INDEX tasks_by_state ON tasks (stage, state, id);
"""
# Checksums of tile files. In a separate table, which is added to manifests of older runs.
CHECKSUMS = "CREATE TABLE IF NOT EXISTS checksums (tile INTEGER PRIMARY KEY, crc INTEGER NOT NULL)"


def check_schema(base: sqlite3.Connection, tables: str) -> None:
    """Raise ValueError if a database has other tables than a manifest."""
    query = "SELECT type, name, sql FROM sqlite_master WHERE sql IS NOT NULL AND name != 'checksums'"
    with contextlib.closing(sqlite3.connect(":memory:")) as empty:
        empty.executescript(tables)
        expected = set(empty.execute(query))
    actual = {tuple(row) for row in base.execute(query)}
    if actual != expected:
        (_, name, _), *_ = actual ^ expected
        raise ValueError(f"the table or index {name!r} is missing or unexpected")
