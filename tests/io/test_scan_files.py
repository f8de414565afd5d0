"""The scans of a folder in order, and invalid folders."""

import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.scan_files import list_scans
from pointloom.registration import run_odometry


def test_names_with_leading_zeros_and_words_are_ordered(tmp_path):
    names = ["a1.pcd", "a01.pcd", "a002.pcd", "a10.pcd", "b.pcd", "2.pcd", "10.pcd"]
    for name in names:
        (tmp_path / name).touch()
    (tmp_path / "notes.md").touch()
    (tmp_path / "more.pcd").mkdir()
    listed = [path.name for path in list_scans(tmp_path)]
    assert listed == ["a01.pcd", "a1.pcd", "a002.pcd", "a10.pcd", "b.pcd", "2.pcd", "10.pcd"]


def test_tables_beside_scans_are_no_scans(tmp_path):
    for name in ("1.csv", "2.csv"):
        (tmp_path / name).write_text("0,0,0\n1,2,3\n")
    assert [path.name for path in list_scans(tmp_path)] == ["1.csv", "2.csv"]
    for name in ("1.bin", "times.txt"):
        (tmp_path / name).touch()
    assert [path.name for path in list_scans(tmp_path)] == ["1.bin"]


def test_folders_that_are_none_are_named(tmp_path):
    with pytest.raises(FileError, match="/nowhere:"):
        run_odometry(tmp_path / "nowhere")
    with pytest.raises(FileError, match="contains no scan"):
        run_odometry(tmp_path)
    (tmp_path / "1.bin").touch()
    (tmp_path / "2.ply").touch()
    with pytest.raises(FileError, match=r"several types: \.bin, \.ply"):
        run_odometry(tmp_path)
    with pytest.raises(FileError, match=r"/1\.bin:"):
        run_odometry(tmp_path / "1.bin")
    with pytest.raises(FileError, match="is empty"):
        run_odometry([tmp_path / "1.bin"])
    for wrong in (loom.PointCloud([[1, 2, 3]]), [3]):
        with pytest.raises(TypeError, match=r"^scans:"):
            run_odometry(wrong)
    with pytest.raises(ValueError, match="timestamps:"):
        run_odometry([loom.PointCloud([[1, 2, 3]])], timestamps=[0.0, 1.0])
    assert len(run_odometry([])) == 0
