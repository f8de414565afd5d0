"""KITTI's scans without a header: what is read, and what cannot be one."""

from __future__ import annotations

import numpy as np
import pytest

from pointloom.core.errors import FileError
from pointloom.files.points.kitti_bin import read_kitti_bin


def test_a_real_scan_is_read_to_the_bit(real_file):
    path = real_file("lidar-kitti-frame/kitti/000008.bin")
    table, rows = read_kitti_bin(path), np.fromfile(path, np.float32).reshape(-1, 4)
    np.testing.assert_array_equal(table.points, rows[:, :3])
    np.testing.assert_array_equal(table.attributes["intensity"], rows[:, 3])
    assert table.points.dtype == table.attributes["intensity"].dtype == np.float32


def test_points_that_are_no_numbers_are_kept(tmp_path):
    rows = np.array([[np.nan, 1, 2, 0.5], [1, np.inf, 3, np.nan]], "<f4")
    rows.tofile(tmp_path / "a.bin")
    table = read_kitti_bin(tmp_path / "a.bin")
    np.testing.assert_array_equal(np.column_stack([table.points, table.attributes["intensity"]]), rows)


@pytest.mark.parametrize("cut", [1, 4, 12, 15])
def test_a_file_that_is_cut_off_is_refused(tmp_path, cut):
    (tmp_path / "a.bin").write_bytes(np.ones(40, "<f4").tobytes()[:-cut])
    with pytest.raises(FileError, match=r"\(byte 144\): \d+ bytes are not a multiple of 16"):
        read_kitti_bin(tmp_path / "a.bin")


def test_other_numbers_are_refused(tmp_path):
    np.sqrt(np.arange(40.0)).tofile(tmp_path / "a.bin")  # float64
    with pytest.raises(FileError, match="this is no scan of float32 x, y, z, intensity"):
        read_kitti_bin(tmp_path / "a.bin")


def test_no_file_and_no_byte_are_named(tmp_path):
    with pytest.raises(FileError, match="does not exist"):
        read_kitti_bin(tmp_path / "a.bin")
    (tmp_path / "a.bin").touch()
    with pytest.raises(FileError, match="is empty"):
        read_kitti_bin(tmp_path / "a.bin")
