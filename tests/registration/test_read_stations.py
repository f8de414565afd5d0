"""Stations, targets and control points of files go from the readers to the registration and to the writer."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.photogrammetry.depth.estimation import read_distances
from pointloom.photogrammetry.video.control_files import read_ground_control
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
    (tmp_path / "c.csv").write_text("A,1,2,3\nB,1,2,3,0.01\nC\t1\t2\t3\t0.1\t0.2\t0.3\n")
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
def test_decimal_commas_between_blanks_are_rejected_by_every_table(tmp_path, row):
    path, row = tmp_path / "table.csv", row.format(" ")
    for read, head in (
        (read_control_points, "T1"),
        (lambda path: read_targets(path, ["hall"]), "hall T1"),
        (PositionReadings.read, "0.5"),
        (lambda path: read_positions(path, ["a"]), "a"),
    ):
        path.write_text(f"{head} {row}\n")
        with pytest.raises(loom.FileError, match=r"table\.csv \(line 1"):
            read(path)


def _of_control(path):
    points = read_control_points(path)
    return [(p.name, *p.position, *p.sigma) for p in points]


def _of_targets(path):
    return [(t.station, t.name, *t.position, t.sigma) for t in read_targets(path, ["hall", "yard 2"])]


def _of_readings(path):
    readings = PositionReadings.read(path, sigma=0.7)
    return np.column_stack([readings.times, readings.positions, readings.sigma]).tolist()


def _of_images(path):
    return [(name, *position) for name, position in read_positions(path, ["a.jpg", "b.jpg"]).items()]


def _of_ground(path):
    control = read_ground_control(path)
    points = [(p.name, *p.position, *np.asarray(p.sigma)) for p in control.points]
    return points + [(m.point, m.image, *m.pixel) for m in control.marks]


# For each reader: columns, two rows, and other titles of the columns. Numbers have decimals, words have none.
TABLES = {
    "control": (_of_control, "name x y z", ["T1 4471.5 5261.25 410.125", "T2 4481.5 5271.25 411.5"],
                "Point easting Northing height"),
    "control, sigma": (_of_control, "name x y z sigma", ["T1 4471.5 5261.25 410.125 0.01", "T2 1.5 2.5 3.5 0.02"],
                       "id E N Elevation std"),
    "control, sigmas": (_of_control, "name x y z sigma_x sigma_y sigma_z", ["T1 71.5 61.5 4.5 0.01 0.02 0.05"],
                        "target_name east north up std_east std_north std_up"),
    "targets": (_of_targets, "station name x y z", ["hall T1 1.5 2.5 0.25", "1 T1 -3.5 2.5 0.25"],
                "scan target X[m] Y[m] Z[m]"),
    "targets, sigma": (_of_targets, "station name x y z sigma", ["hall T1 1.5 2.5 0.25 0.001"],
                       "Scan Point x_m y_m z_m sd"),
    "readings": (_of_readings, "time x y z", ["0.5 431000.5 5400000.25 250.5", "1.5 431001.5 5400001.25 251.5"],
                 "timestamp easting northing alt"),
    "readings, sigma": (_of_readings, "time x y z sigma", ["0.5 31.5 54.25 2.5 0.5", "1.5 32.5 55.25 2.5 0.25"],
                        "t[s] E N Up sigma[m]"),
    "readings, sigmas": (_of_readings, "time x y z sigma_x sigma_y sigma_z", ["0.5 31.5 54.25 2.5 0.5 0.25 1.5"],
                         "time_s x y elevation sx sy sz"),
    "images": (_of_images, "name x y z", ["a.jpg 1.5 2.5 3.5", "b.jpg 4.5 5.5 6.5"], "image east north height"),
    "distances": (lambda path: read_distances(path).tolist(), "u v meters", ["10.5 20.5 1.25", "11.5 21.25 2.25"],
                  "column row depth"),
    "ground": (_of_ground, "name x y z sigma sigma_z image column row",
               ["A 471.5 261.25 41.5 0.01 0.03 a.jpg 32.5 24.5", "B 571.5 361.25 42.5 0.01 0.03 a.jpg 52.5 34.5"],
               "point easting northing height std std_height photo px py"),
}  # fmt: skip


def _written(path, head, rows, mark):
    path.write_text("".join(f"{mark.join(row)}\n" for row in ([head] if head else []) + rows))
    return path


@pytest.mark.parametrize("kind", TABLES)
def test_columns_are_read_by_their_titles_in_any_order(tmp_path, rng, kind):
    read, columns, rows, titles = TABLES[kind]
    path, rows = tmp_path / "table.csv", [row.split() for row in rows]
    expected = read(_written(path, columns.split(), rows, ","))
    assert kind == "ground" or read(_written(path, None, rows, " ")) == expected
    for mark in (",", ";", "\t", " ", ", "):
        for head in (columns.split(), titles.split()):
            order = rng.permutation(len(head))
            found = read(_written(path, [head[k] for k in order], [[row[k] for k in order] for row in rows], mark))
            assert found == expected, (mark, head, order)
            if kind != "ground":
                comment = ["# " + head[order[0]], *(head[k] for k in order[1:])]
                assert read(_written(path, comment, [[row[k] for k in order] for row in rows], mark)) == expected


@pytest.mark.parametrize("kind", TABLES)
def test_decimal_commas_are_read_between_other_separators(tmp_path, kind):
    read, columns, rows, _ = TABLES[kind]
    path, rows = tmp_path / "table.csv", [row.split() for row in rows]
    expected = read(_written(path, columns.split(), rows, ","))
    commas = [[word if "jpg" in word else word.replace(".", ",") for word in row] for row in rows]
    for mark in (";", "\t", "; "):
        assert read(_written(path, columns.split(), commas, mark)) == expected
        assert kind == "ground" or read(_written(path, None, commas, mark)) == expected
    quoted = [[f'"{word}"' for word in row] for row in commas]
    assert read(_written(path, columns.split(), quoted, ",")) == expected
    for head in (columns.split(), None):
        for mark in (",", ", ", " "):
            with pytest.raises(loom.FileError, match=r"table\.csv"):
                read(_written(path, head, commas, mark))
    mixed = [*commas[:1], *rows]
    with pytest.raises(loom.FileError, match=r"line 3, column \d+\): expected decimal commas as in line 2"):
        read(_written(path, columns.split(), mixed, ";"))


@pytest.mark.parametrize("kind", TABLES)
def test_rows_with_another_number_of_columns_are_rejected_with_their_line(tmp_path, kind):
    read, columns, rows, _ = TABLES[kind]
    path, head, rows = tmp_path / "table.csv", columns.split(), [row.split() for row in rows]
    for mark in (",", ";", "\t"):
        for wrong in (rows[0][:-1], [*rows[0], "7.5"], rows[0][1:]):
            with pytest.raises(loom.FileError, match=r"table\.csv \(line 3"):
                read(_written(path, head, [rows[0], wrong], mark))
    if kind != "ground":
        for width in (len(head) + 4, 2):
            with pytest.raises(loom.FileError, match=r"table\.csv"):
                read(_written(path, None, [(rows[0] + ["7.5"] * 4)[:width]], ","))


@pytest.mark.parametrize("kind", TABLES)
def test_unknown_columns_are_named_and_mistakable_ones_rejected(tmp_path, kind):
    read, columns, rows, _ = TABLES[kind]
    path, head, rows = tmp_path / "table.csv", columns.split(), [row.split() for row in rows]
    expected = read(_written(path, head, rows, ","))
    with pytest.warns(UserWarning, match=r"line 1\): ignored the unknown columns 'quality'"):
        assert read(_written(path, ["quality", *head], [["4", *row] for row in rows], ",")) == expected
    number = next(k for k, name in enumerate(head) if name in ("x", "u"))
    for title in (f"{head[number]}_mm", f"{head[number]} [mm]", "sigma_mm", "", head[number]):
        with pytest.raises(loom.FileError, match=r"table\.csv \(line 1, column"):
            read(_written(path, [title, *head], [["4.5", *row] for row in rows], ","))
        wrong = [title if k == number else name for k, name in enumerate(head)]
        if title != head[number]:
            with pytest.raises(loom.FileError, match=r"table\.csv \(line 1"):
                read(_written(path, wrong, rows, ","))
    lacking = [name for name in head if name not in ("y", "v")]
    with pytest.raises(loom.FileError, match=r"table\.csv \(line"):
        read(_written(path, lacking, [row[: len(lacking)] for row in rows], ","))


def test_names_with_blanks_are_not_split_in_tables_of_blanks(tmp_path):
    for row in ("P 1 4471.5 5261.25 410", "P 1 4471.5 5261.25 0.5", "P A 4471.5 5261.25 410", "P A B C 4.5 5.5 4.5"):
        for head in ("", "name x y z\n"):
            with pytest.raises(loom.FileError, match=r"table\.csv \(line \d"):
                read_control_points(_table(tmp_path, f"{head}{row}\n"))
    with pytest.raises(loom.FileError, match="line 1"):
        read_targets(_table(tmp_path, "hall P 1 4471.5 5261.25 410\n"), ["hall"])
    (point,) = read_control_points(_table(tmp_path, '"P 1" 4471.5 5261.25 410.5\n'))
    assert (point.name, point.position.tolist()) == ("P 1", [4471.5, 5261.25, 410.5])
    with pytest.raises(loom.FileError, match="may be name x y z"):  # decimal commas between commas
        read_control_points(_table(tmp_path, "T1,4471,5,5261,25,410,2\n"))
    with pytest.raises(loom.FileError, match=r"line 1.*name x y z"):
        read_positions(_table(tmp_path, "a.jpg 7 1.5 2.5 3.5\n"), ["a.jpg"])


def test_degrees_are_read_by_the_reader_of_ground_control_only(tmp_path):
    head, row = "name,lat,lon,height,image,column,row", "A,47.5,8.25,410.5,a.jpg,1,2"
    control = read_ground_control(_table(tmp_path, f"# crs EPSG:4326\n{head}\n{row}\n"))
    assert control.positions.tolist() == [[8.25, 47.5, 410.5]]
    for crs in ("", "# crs EPSG:32632\n"):
        with pytest.raises(loom.FileError, match="expected a coordinate system in degrees"):
            read_ground_control(_table(tmp_path, f"{crs}{head}\n{row}\n"))
    for read, first in ((read_control_points, "name"), (PositionReadings.read, "time")):
        with pytest.raises(loom.FileError, match="Convert degrees to meters"):
            read(_table(tmp_path, f"{first},lat,lon,height\n1,47.5,8.25,410.5\n"))
