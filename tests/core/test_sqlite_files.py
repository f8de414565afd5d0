"""SQLite files of unknown origin run no code and read no views."""

import contextlib
import sqlite3

import pytest

import pointloom as loom
from pointloom.core.sqlite_files import protect
from pointloom.photogrammetry.sfm.colmap_jobs import open_database
from pointloom.tiling.manifest import NAME, Manifest, new_manifest, read_plan

CODE = [
    "CREATE VIEW more AS SELECT 1",
    "CREATE TRIGGER more AFTER INSERT ON meta BEGIN DELETE FROM meta; END",
    "CREATE VIRTUAL TABLE more USING fts4(a)",
]


@pytest.mark.parametrize("code", CODE, ids=["view", "trigger", "virtual"])
def test_a_manifest_or_database_with_code_is_an_error(tmp_path, code):
    with new_manifest(tmp_path, {}, "1", "CREATE TABLE meta (key TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID"):
        pass
    with contextlib.closing(sqlite3.connect(tmp_path / NAME)) as base:
        base.execute(code)
        base.commit()
    with pytest.raises(loom.FileError, match="'more'"):
        Manifest(tmp_path)
    with pytest.raises(loom.FileError, match="'more'"), open_database(tmp_path / NAME):
        pass


def test_a_plan_that_is_a_view_is_an_error(tmp_path):
    with contextlib.closing(sqlite3.connect(tmp_path / NAME)) as base:
        base.execute("CREATE VIEW meta AS SELECT 'plan' AS key, '{}' AS value")
    with pytest.raises(loom.FileError, match=NAME):
        read_plan(tmp_path)


def test_a_bounded_query_ends(tmp_path):
    with contextlib.closing(sqlite3.connect(tmp_path / "a.db")) as base:
        base.execute("CREATE TABLE a (b)")
        protect(base, tmp_path / "a.db", is_bounded=True)
        with pytest.raises(sqlite3.OperationalError):
            base.execute("WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL SELECT x + 1 FROM c) SELECT max(x) FROM c")
