"""KITTI scans without a header: accepted and rejected files."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.shell.cli import cli
from pointloom.core.errors import FileError
from pointloom.io.points.kitti_bin import read_kitti_bin


def test_a_real_scan_is_read_to_the_bit(real_file):
    path = real_file("lidar-kitti-frame/kitti/000008.bin")
    table, rows = read_kitti_bin(path), np.fromfile(path, np.float32).reshape(-1, 4)
    np.testing.assert_array_equal(table.points, rows[:, :3])
    np.testing.assert_array_equal(table.attributes["intensity"], rows[:, 3])
    assert table.points.dtype == table.attributes["intensity"].dtype == np.float32


def test_non_finite_points_are_preserved(tmp_path):
    rows = np.array([[np.nan, 1, 2, 0.5], [1, np.inf, 3, np.nan]], "<f4")
    rows.tofile(tmp_path / "a.bin")
    table = read_kitti_bin(tmp_path / "a.bin")
    np.testing.assert_array_equal(np.column_stack([table.points, table.attributes["intensity"]]), rows)


@pytest.mark.parametrize("cut", [1, 4, 12, 15])
def test_a_file_that_is_cut_off_is_refused(tmp_path, cut):
    (tmp_path / "a.bin").write_bytes(np.ones(40, "<f4").tobytes()[:-cut])
    with pytest.raises(FileError, match=r"/a\.bin \(byte 144\):.*16"):
        read_kitti_bin(tmp_path / "a.bin")


def scanner_revolution(points=1200, rings=40, seed=0):
    """x y z intensity ring time of a scanner in a street, in columns of rings."""
    rng = np.random.default_rng(seed)
    ring, azimuth = np.arange(points) % rings, np.arange(points) // rings * 0.2
    elevation = np.radians(-25 + 40 * (ring * 7 % rings) / rings)  # not in the order of the angles
    ranges = np.minimum(np.where(elevation < 0, -1.7 / np.sin(elevation - 1e-3), 90), rng.uniform(4, 60, points))
    x, y = (ranges * np.cos(elevation) * f(azimuth) for f in (np.cos, np.sin))
    rows = [x, y, ranges * np.sin(elevation), rng.integers(0, 256, points), ring, np.linspace(0, 0.1, points)]
    return np.column_stack(rows).astype("<f4")


COLUMNS = ["x", "y", "z", "intensity", "ring", "time", "range", "label"]
NAMES = {width: COLUMNS[:width] for width in (3, 5, 6, 8)}


@pytest.mark.parametrize("width", NAMES)
@pytest.mark.parametrize("scale", [1, 1 / 255])
def test_other_layouts_are_refused_without_columns_and_read_with_them(tmp_path, width, scale):
    rows = scanner_revolution()
    rows[:, 3] *= scale
    rows = np.ascontiguousarray(np.column_stack([rows, np.abs(rows[:, :2])])[:, :width])
    rows.tofile(tmp_path / "a.bin")
    with pytest.raises(FileError, match=r"a\.bin.*columns="):
        loom.read_point_cloud(tmp_path / "a.bin")
    cloud = loom.read_point_cloud(tmp_path / "a.bin", columns=NAMES[width])
    np.testing.assert_array_equal(cloud.points.astype("f4"), rows[:, :3])
    for name, values in zip(NAMES[width][3:], rows[:, 3:].T, strict=True):
        np.testing.assert_array_equal(cloud[name], values)


@pytest.mark.parametrize("rings", [1, 5, 16, 32, 40, 60])
@pytest.mark.parametrize("scale", [1, 1 / 255, 0])
def test_scans_of_kitti_s_layout_need_no_columns(tmp_path, rings, scale):
    rows = np.ascontiguousarray(scanner_revolution(12_600, rings)[:, :4])
    rows[:, 3] *= scale
    rows.tofile(tmp_path / "a.bin")
    np.testing.assert_array_equal(loom.read_point_cloud(tmp_path / "a.bin").points.astype("f4"), rows[:, :3])


def test_runs_of_scans_and_commands_take_columns(tmp_path, capsys):
    wall = np.array([[10, 0.5 * i, 0.5 * j, 7, j] for i in range(-20, 20) for j in range(20)], "<f4")
    folder = tmp_path / "scans"
    folder.mkdir()
    for name in ("0.bin", "1.bin"):
        wall.tofile(folder / name)
    assert len(loom.registration.run_odometry(folder, columns=NAMES[5])) == 2
    names = ["--columns", ",".join(NAMES[5])]
    scan, copy = str(folder / "0.bin"), str(tmp_path / "copy.ply")
    for command in (
        ["info", scan],
        ["convert", scan, copy],
        ["downsample", scan, copy, "--voxel", "0.1", "--force"],
        ["odometry", str(folder), "-o", str(tmp_path / "poses.kitti")],
        ["register", scan, copy, "--init", "identity", "--voxel", "0.5"],
        ["multiway", str(folder), "-o", str(tmp_path / "poses.tum"), "--voxel", "0.5"],
        ["change", scan, copy, "--cylinder", "0.6"],
        ["view", scan, copy, "--screenshot", str(tmp_path / "view.png")],
    ):
        with pytest.raises(SystemExit) as leaving:
            cli([*command, *names])
        assert leaving.value.code in (0, 3), capsys.readouterr().err  # 3: a single wall is insufficient for odometry
    assert loom.read_point_cloud(copy).attributes.keys() == {"intensity", "ring"}
    for command in (["register", copy, copy], ["change", copy, copy], ["view", copy, "--save-html", "a.html"]):
        with pytest.raises(SystemExit):
            cli([*command, *names])
        assert "columns: only .xyz" in capsys.readouterr().err
    with pytest.raises(SystemExit):
        cli(["multiway", str(folder), "-o", "a.tum", "--voxel", "1", "--job", "job", *names])
    assert "--columns is not supported with --job" in capsys.readouterr().err


@pytest.mark.parametrize("dtype", ["<u2", ">u2", "<i4", "<f8", ">f4", ">f8"])
@pytest.mark.filterwarnings("error")
def test_numbers_of_another_type_are_refused(tmp_path, rng, dtype):
    numbers = rng.integers(500, 4000, (1000, 12)) if dtype[1] in "ui" else rng.random((1000, 12)) * 20
    numbers.astype(dtype).tofile(tmp_path / "a.bin")
    with pytest.raises(FileError, match=r"/a\.bin.*not a scan of float32"):
        loom.read_point_cloud(tmp_path / "a.bin")


@pytest.mark.parametrize("columns", [None, ["x", "y", "z", "intensity"]])
def test_a_header_of_integers_is_not_read_as_a_point(tmp_path, rng, columns):
    header = np.array([1000, 4, 1, 0], "<i4").tobytes()
    (tmp_path / "a.bin").write_bytes(header + (rng.random((1000, 4)) * 20).astype("<f4").tobytes())
    with pytest.raises(FileError, match="header"):
        loom.read_point_cloud(tmp_path / "a.bin", columns=columns)
