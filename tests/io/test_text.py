"""XYZ, XYZN, XYZRGB and PTS: reading, rejected files, and agreement with Open3D."""

import re
from dataclasses import replace

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.io.points.text import read_text, write_text
from pointloom.io.table import PointTable

from .point_tables import assert_same_table

SUFFIXES = (".xyz", ".xyzn", ".xyzrgb", ".pts")


def table_for(suffix, count=50):
    rng = np.random.default_rng(6)
    points, normals = rng.normal(size=(count, 3)) * 1e6, rng.normal(size=(count, 3)).astype(np.float32)
    colors = rng.integers(0, 256, (count, 3)).astype(np.float32) / np.float32(255)
    has_colors = suffix in (".xyzrgb", ".pts")
    return PointTable(points, normals if suffix == ".xyzn" else None, colors if has_colors else None)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_supported_values_survive_a_round_trip_exactly(tmp_path, suffix):
    path, table = tmp_path / f"cloud{suffix}", table_for(suffix)
    write_text(path, table)
    assert_same_table(read_text(path), table)


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_comments_and_blank_lines_are_skipped_in_the_xyz_family(tmp_path, end):
    path = tmp_path / "c.XYZ"
    path.write_bytes(f"# x y z{end}{end}1 2 3{end}  # grüße{end} \t{end}4\t5  -6e-1{end}{end}".encode())
    np.testing.assert_array_equal(read_text(path).points, [[1, 2, 3], [4, 5, -0.6]])


@pytest.mark.parametrize("with_intensity", [False, True])
@pytest.mark.parametrize("with_colors", [False, True])
@pytest.mark.parametrize("count", [0, 1, 9])
def test_pts_stores_intensity_and_colors_in_any_combination(tmp_path, with_intensity, with_colors, count):
    path, table = tmp_path / "c.pts", table_for(".pts", count)
    if not with_colors:
        table.colors = None
    if with_intensity:
        table.attributes["intensity"] = np.arange(count) - 0.123
    write_text(path, table)
    assert path.read_text().split("\n")[0] == str(count) and len(read_text(path).points) == count
    if count:
        assert_same_table(read_text(path), table)


@pytest.mark.parametrize(
    ("name", "content", "where", "reason"),
    [
        ("c.xyz", "", "byte 0", "is empty"),
        ("c.xyz", "# nothing\n", "", "contains no points"),
        ("c.xyz", "# c\n1 2 3\n4 5 x\n", "line 3", "not a number: 'x'"),
        ("c.xyz", "1 2 3\n4 5 \0\n", "line 2", "expected 3 values, got 2"),
        ("c.xyz", "1 2 3\n4 5 6\0\n", "line 2", r"not a number: '6\x00'"),
        ("c.xyz", "1 2 3\n4 5 1_0\n", "line 2", "not a number: '1_0'"),
        ("c.xyz", "1 2 3\n4 5 1e400\n", "line 2", "beyond the range of float64"),
        ("c.xyzn", "1 2 3 0 0 1e39\n", "row 0", "a normal is beyond the range of float32"),
        ("c.xyzrgb", "1 2 3 0 0 1\n1 2 3 0 0 255\n", "row 1", "a color is outside 0..1"),
        ("c.pts", "-1\n", "line 1", "negative"),
        ("c.pts", "1e3\n", "line 1", "not a whole number"),
        ("c.pts", "10000000000\n1 2 3\n", "line 2", "truncated: 1 of 10000000000 points"),
        ("c.pts", "1\n1 2 3\n4 5 6\n", "line 3", "1 lines follow the declared 1 points"),
        ("c.pts", "1\n1 2 3 4 5\n", "line 2", "expected 3, 4, 6 or 7 values, got 5"),
        ("c.pts", "1\n1 2 3 0 0 256\n", "line 2", "does not fit"),
        ("c.txt", "1 2 3\n", "", "'.txt' is not one of .xyz, .xyzn, .xyzrgb, .pts"),
    ],
)
def test_damaged_file_is_rejected_with_location_and_reason(tmp_path, name, content, where, reason):
    path = tmp_path / name
    path.write_text(content)
    with pytest.raises(FileError, match=re.escape(reason)) as caught:
        read_text(path)
    assert caught.value.where == where


def test_unsupported_data_is_rejected_with_a_suggestion_of_ply(tmp_path):
    for suffix, change, reason in (
        (".xyz", {"colors": np.zeros((50, 3))}, ".xyz cannot store colors"),
        (".pts", {"attributes": {"ring": np.zeros(50)}}, ".pts cannot store the attribute 'ring'"),
        (".xyzrgb", {"colors": None}, ".xyzrgb needs colors"),
    ):
        with pytest.raises(FileError, match=re.escape(reason)) as caught:
            write_text(tmp_path / f"c{suffix}", replace(table_for(suffix), **change))
        assert ".ply" in caught.value.remedy and not list(tmp_path.iterdir())
