"""Stations, targets and control points of files go from the readers to the registration and to the writer."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration import PositionReadings, read_control_points, read_positions, read_targets


def test_stations_of_a_file_are_registered_with_their_names_and_poses(tmp_path, rng):
    x, y = rng.uniform(-4, 4, (2, 9000))
    ground = np.column_stack([x, y, 0.5 * np.sin(1.5 * x) * np.cos(y) + 0.3 * np.sin(2 * y + x)])
    poses = np.tile(np.eye(4), (3, 1, 1))
    poses[:, :3, 3] = [[0, 0, 1.5], [1.0, 0.5, 1.6], [0.5, -1.0, 1.4]]
    clouds = [loom.PointCloud(ground[k::3] - poses[k, :3, 3]) for k in range(3)]
    loom.write_stations(tmp_path / "a.e57", clouds, poses, names=["A", "B", "C"], crs=25832)
    stations = loom.read_stations(tmp_path / "a.e57")
    found = loom.registration.register_stations(stations, voxel_size=0.2)
    given = loom.registration.register_stations(
        stations.clouds, poses=stations.poses, names=stations.names, voxel_size=0.2
    )
    assert found.names == ("A", "B", "C")
    np.testing.assert_array_equal(found.poses, given.poses)
    loom.write_stations(tmp_path / "b.e57", stations, found.poses)
    written = loom.read_stations(tmp_path / "b.e57")
    assert written.names == found.names and written.crs == 25832
    np.testing.assert_allclose(written.poses, found.poses, atol=1e-9)
    renamed = loom.registration.register_stations(stations, names=["D", "E", "F"], voxel_size=0.2)
    assert renamed.names == ("D", "E", "F")


def test_an_invalid_table_of_targets_names_its_line(tmp_path):
    for text, message in (
        ("north,A,1,2", "line 1"),
        ("north,A,1,2,3\nsouth,A,1,2,3", "got 'south'"),
        ("", "no row"),
        ("north,A,1,2,3\nmid,A,1,x,3", "line 2"),
        ("north,A,1,2,3,-1", "line 1"),
        ("north,A,1,2,nan", "line 1"),
    ):
        (tmp_path / "t.csv").write_text(text)
        with pytest.raises(loom.FileError, match=message):
            read_targets(tmp_path / "t.csv", ["north", "mid"])


def test_control_has_one_sigma_or_three(tmp_path):
    (tmp_path / "c.csv").write_text("name,x,y,z\nA,1,2,3\nB,1,2,3,0.01\nC\t1\t2\t3\t0.1\t0.2\t0.3\n")
    a, b, c = read_control_points(tmp_path / "c.csv")
    assert [v.tolist() for v in (a.sigma, b.sigma, c.sigma)] == [[0.002] * 3, [0.01] * 3, [0.1, 0.2, 0.3]]
    with pytest.raises(loom.FileError, match=r"none\.csv"):
        read_control_points(tmp_path / "none.csv")


def test_stations_are_named_or_numbered(tmp_path):
    (tmp_path / "t.csv").write_text("1;T;1;2;3\nnorth;T;4;5;6;0.01\n# comment\n")
    first, second = read_targets(tmp_path / "t.csv", ("north", "mid"))
    assert (first.station, second.station, second.name, second.sigma) == (1, 0, "T", 0.01)
    (named,) = read_targets(_table(tmp_path, "1,T,1,2,3\n"), ["mid", "north", "1"])
    assert named.station == 2  # a name before a number
    with pytest.raises(TypeError, match=r"names\[0\]"):
        read_targets(tmp_path / "t.csv", [3])


def _table(folder, text):
    path = folder / "table.csv"
    path.write_text(text)
    return path


@pytest.mark.parametrize("row", ["4471,5{0}5261,25{0}410,1", "4471,5{0}5261{0}410", "1,004,471.5{0}2{0}3{0}0.1",
                                 '"4471,5"{0}5261{0}410', "4,471.5{0}5,261.25{0}410.0"])  # fmt: skip
@pytest.mark.parametrize("separator", [";", "\t", " ", "; "])
def test_decimal_commas_are_rejected_by_every_table(tmp_path, row, separator):
    path, row = tmp_path / "table.csv", row.format(separator)
    for read, head in (
        (read_control_points, "T1"),
        (lambda path: read_targets(path, ["hall"]), f"hall{separator}T1"),
        (PositionReadings.read, "0.5"),
        (lambda path: read_positions(path, ["a"]), "a"),
    ):
        path.write_text(f"{head}{separator}{row}\n")
        with pytest.raises(loom.FileError, match=r"table\.csv \(line 1\)"):
            read(path)
