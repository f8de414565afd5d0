"""Outputs are written atomically: file modes, and the previous file."""

import os
import subprocess
import sys

import pytest

import pointloom as loom
from pointloom.core import atomic
from pointloom.core.atomic import atomic_folder, atomic_write, restore_folder
from pointloom.io.optional_imports import foreign_errors


def write(path, content, **options):
    with atomic_write(path, **options) as file:
        file.write(content)


@pytest.mark.parametrize(("mask", "mode"), [(0o022, 0o644), (0o077, 0o600), (0o002, 0o664)])
def test_new_file_mode_follows_the_umask(tmp_path, mask, mode):
    before = os.umask(mask)
    try:
        write(tmp_path / "a", b"new")
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == mode


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o444, 0o666])
def test_a_file_that_is_replaced_keeps_its_mode(tmp_path, mode):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    path.chmod(mode)
    write(path, b"new")
    assert path.read_bytes() == b"new" and path.stat().st_mode & 0o777 == mode


def test_open_readers_of_the_old_file_are_unaffected(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"old bytes")
    with path.open("rb") as reader:
        first = reader.read(4)
        write(path, b"new bytes, and more")
        assert first + reader.read() == b"old bytes"
    assert path.read_bytes() == b"new bytes, and more"


@pytest.mark.parametrize("overwrite", [True, False])
def test_target_is_unchanged_until_the_block_ends(tmp_path, overwrite):
    path = tmp_path / "a"
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(b"half")
        file.flush()
        assert not path.exists()
    assert path.read_bytes() == b"half" and [p.name for p in tmp_path.iterdir()] == ["a"]


def test_file_created_by_another_program_or_before_an_error_in_the_block_is_preserved(tmp_path):
    path = tmp_path / "a"
    with pytest.raises(loom.FileError, match="a:"), atomic_write(path, overwrite=False) as file:
        file.write(b"mine")
        path.write_bytes(b"theirs")
    with pytest.raises(RuntimeError, match="midway"), atomic_write(path) as file:
        file.write(b"new")
        raise RuntimeError("midway")
    assert path.read_bytes() == b"theirs" and [p.name for p in tmp_path.iterdir()] == ["a"]


@pytest.mark.parametrize(("mask", "before", "mode"), [(0o022, 0, 0o755), (0o077, 0, 0o700), (0o022, 0o700, 0o700)])
def test_a_folder_has_the_mode_of_mkdir_or_of_the_replaced_folder(tmp_path, mask, before, mode):
    path, old_mask = tmp_path / "out", os.umask(mask)
    try:
        if before:
            path.mkdir()
            path.chmod(before)
        write_folder(path, "new")
    finally:
        os.umask(old_mask)
    assert path.stat().st_mode & 0o777 == mode


def test_writers_never_call_umask(tmp_path, monkeypatch):
    def forbidden(mask):
        raise AssertionError("the umask belongs to all threads")

    monkeypatch.setattr(os, "umask", forbidden)
    write(tmp_path / "a", b"new")
    write_folder(tmp_path / "out", "new")


def write_folder(path, content):
    with atomic_folder(path, "marker") as folder:
        (folder / "marker").write_text(content)


KILLED = """
import os, sys
from pointloom.core import atomic
from pointloom.core.atomic import atomic_folder
calls = [0]
def counted(function):
    def call(*args, **kwargs):
        if (calls := calls_of()) == int(sys.argv[2]):
            os._exit(9)
        return function(*args, **kwargs)
    return call
def calls_of():
    calls[0] += 1
    return calls[0]
os.rename, os.rmdir, os.unlink = counted(os.rename), counted(os.rmdir), counted(os.unlink)
with atomic_folder(sys.argv[1], "marker") as folder:
    (folder / "marker").write_text("new")
"""


@pytest.mark.parametrize("reader", ["restore", "write"])
def test_a_folder_survives_a_kill_at_each_step_of_its_replacement(tmp_path, reader):
    ends = set()
    for step in range(1, 9):
        path = tmp_path / str(step) / "out"
        path.parent.mkdir()
        write_folder(path, "old")
        done = subprocess.run([sys.executable, "-c", KILLED, path, str(step)], check=False)
        if reader == "restore":
            restore_folder(path / "marker")
            ends.add((done.returncode, (path / "marker").read_text()))
        else:
            with pytest.raises(loom.FileError, match="exists already"), atomic_folder(path, "marker", overwrite=False):
                pass
            write_folder(path, "next")
            assert not [*path.parent.glob("*.old")]
    assert reader == "write" or ends == {(9, "old"), (9, "new"), (0, "new")}


def test_folder_that_cannot_be_replaced_is_preserved(tmp_path, monkeypatch):
    path, rename = tmp_path / "out", os.rename
    write_folder(path, "old")

    def failing(source, target):
        if str(source).endswith(".part"):
            raise OSError(5, "Input/output error")
        rename(source, target)

    monkeypatch.setattr(os, "rename", failing)
    with pytest.raises(loom.FileError, match="out"):
        write_folder(path, "new")
    assert (path / "marker").read_text() == "old" and [p.name for p in tmp_path.iterdir()] == ["out"]


@pytest.mark.parametrize("answer", ["raises", "goes on"])
@pytest.mark.parametrize("stop", [KeyboardInterrupt, SystemExit])
def test_original_error_is_reported_through_other_packages(tmp_path, monkeypatch, answer, stop):
    def interrupted(file, data):
        raise stop("time is up")

    monkeypatch.setattr(atomic, "_write", interrupted)
    with pytest.raises(stop), atomic_write(tmp_path / "a.laz") as file, foreign_errors("a.laz", "cannot be written"):
        try:
            file.write(bytes(1 << 20))
        except BaseException:  # as in Rust's callbacks
            if answer == "raises":
                raise RuntimeError("IoError: Failed to call write") from None
    assert not [*tmp_path.iterdir()]
