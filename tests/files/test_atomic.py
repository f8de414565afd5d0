"""Outputs are whole or not there: their modes, and what becomes of the file whose place they take."""

from __future__ import annotations

import os

import pytest

import pointloom as loom
from pointloom.core.atomic import atomic_write


def write(path, content, **options):
    with atomic_write(path, **options) as file:
        file.write(content)


@pytest.mark.parametrize(("mask", "mode"), [(0o022, 0o644), (0o077, 0o600), (0o002, 0o664)])
def test_a_new_file_has_the_mode_that_the_users_mask_says(tmp_path, mask, mode):
    before = os.umask(mask)
    try:
        write(tmp_path / "a", b"new")
    finally:
        os.umask(before)
    assert (tmp_path / "a").stat().st_mode & 0o777 == mode


@pytest.mark.parametrize("mode", [0o600, 0o640, 0o444])
def test_a_file_that_is_replaced_keeps_its_mode(tmp_path, mode):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    path.chmod(mode)
    write(path, b"new")
    assert path.read_bytes() == b"new" and path.stat().st_mode & 0o777 == mode


def test_who_reads_the_old_file_goes_on_reading_it(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"old bytes")
    with path.open("rb") as reader:
        first = reader.read(4)
        write(path, b"new bytes, and more")
        assert first + reader.read() == b"old bytes"
    assert path.read_bytes() == b"new bytes, and more"


@pytest.mark.parametrize("overwrite", [True, False])
def test_the_place_is_as_it_was_until_the_block_ends(tmp_path, overwrite):
    path = tmp_path / "a"
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(b"half")
        file.flush()
        assert not path.exists()
    assert path.read_bytes() == b"half"
    assert [p.name for p in tmp_path.iterdir()] == ["a"]


def test_a_file_that_another_program_made_meanwhile_is_kept(tmp_path):
    path = tmp_path / "a"
    with pytest.raises(loom.FileError, match="a: exists already"), atomic_write(path, overwrite=False) as file:
        file.write(b"mine")
        path.write_bytes(b"theirs")
    assert path.read_bytes() == b"theirs"
    assert [p.name for p in tmp_path.iterdir()] == ["a"]


def test_an_error_in_the_block_leaves_the_old_file_and_nothing_else(tmp_path):
    path = tmp_path / "a"
    path.write_bytes(b"old")
    with pytest.raises(RuntimeError, match="midway"), atomic_write(path) as file:
        file.write(b"new")
        raise RuntimeError("midway")
    assert path.read_bytes() == b"old"
    assert [p.name for p in tmp_path.iterdir()] == ["a"]
