"""ground, dtm, merge, transform, split: results agree with the library, and errors name the remedy."""

import numpy as np
import pytest

import pointloom as loom

from .commands import answer, names_in, output_of, refusal, run, unreliable


@pytest.fixture
def tile(tmp_path, rng):
    """A LAZ tile of a slope with a building at UTM coordinates."""
    x, y = rng.uniform(0, 60, (2, 8000))
    building = (abs(x - 30) < 6) & (abs(y - 20) < 8)
    points = np.column_stack([412_300 + x, 5_651_200 + y, 0.05 * x + np.where(building, 5.0, 0.0)])
    classes = np.where(building, 6, 0).astype(np.uint8)
    cloud = loom.PointCloud(points, classification=classes, crs=25832, unit="metre")
    loom.write_point_cloud(tmp_path / "tile.laz", cloud, scale=0.001)
    return tmp_path / "tile.laz"


def test_ground_classifies_and_keeps_other_classes(tile, tmp_path):
    report = answer("ground", tile, tmp_path / "ground.laz")
    before, after = loom.read_point_cloud(tile), loom.read_point_cloud(tmp_path / "ground.laz")
    is_ground = np.asarray(loom.classify_ground(before))
    expected = np.where(is_ground, 2, np.where(before["classification"] == 6, 6, 1))
    np.testing.assert_array_equal(after["classification"], expected)
    np.testing.assert_array_equal(after.points, before.points)
    assert (report["points"], report["points_in"]) == (int(is_ground.sum()), 8000) and after.crs == 25832
    assert "classes are not written to .xyz" in refusal("ground", tile, tmp_path / "a.xyz")


def test_dtm_is_the_raster_of_the_library(tile, tmp_path):
    output = tmp_path / "dtm.tif"
    assert "Run pointloom ground first" in refusal("dtm", tile, "-o", output)
    output_of("ground", tile, tmp_path / "ground.laz")
    report = answer("dtm", tmp_path / "ground.laz", "-o", output, "--cell", 2, "--fill", 30)
    found = loom.read_raster(output)
    cloud = loom.read_point_cloud(tmp_path / "ground.laz")
    np.testing.assert_array_equal(found.values, loom.rasterize(cloud, 2.0).fill_gaps(30.0).values)
    assert (report["crs"], report["known"], report["shape"]) == ("EPSG:25832", found.values.size, [*found.values.shape])
    assert "exists already" in refusal("dtm", tmp_path / "ground.laz", "-o", output)
    assert "rasters are not written to .png" in refusal("dtm", tile, "-o", tmp_path / "a.png")
    answer("dtm", tile, "-o", output, "--kind", "lowest", "--force")
    assert loom.read_raster(output).kind == "lowest"
    bare = loom.PointCloud(cloud.points)
    loom.write_point_cloud(tmp_path / "bare.ply", bare)
    assert "has no classification. Run pointloom ground first" in refusal(
        "dtm", tmp_path / "bare.ply", "-o", output, "--force"
    )


def test_merge_concatenates_and_reports_dropped_attributes(tile, tmp_path):
    cloud = loom.read_point_cloud(tile)
    more = cloud[:100]
    more["extra"] = np.arange(100)
    loom.write_point_cloud(tmp_path / "more.laz", more, scale=0.001)
    report = answer("merge", tile, tmp_path / "more.laz", "-o", tmp_path / "both.laz")
    both = loom.read_point_cloud(tmp_path / "both.laz")
    np.testing.assert_array_equal(both.points, np.concatenate([cloud.points, cloud.points[:100]]))
    assert report["dropped"] == ["extra"] and report["points"] == 8100 and both.crs == 25832
    assert [*report["sources"].values()] == [8000, 100]
    loom.write_point_cloud(tmp_path / "other.laz", cloud.reproject(25833))
    assert "expected one coordinate system" in refusal("merge", tile, tmp_path / "other.laz", "-o", tmp_path / "a.laz")
    assert not (tmp_path / "a.laz").exists()


def test_transform_moves_clouds_and_meshes(tile, mesh, tmp_path):
    T = np.array([[0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1.0]])
    np.savetxt(tmp_path / "T.txt", T)
    cloud, moved, back = loom.read_point_cloud(tile), tmp_path / "moved.laz", tmp_path / "back.laz"
    report = answer("transform", tile, moved, "--pose", tmp_path / "T.txt")
    np.testing.assert_allclose(loom.read_point_cloud(moved).points, cloud.transform(T).points, atol=1e-3)
    assert report["matrix"] == T.tolist() and loom.read_point_cloud(moved).crs == 25832
    output_of("transform", moved, back, "--pose", tmp_path / "T.txt", "--inverse")
    np.testing.assert_allclose(loom.read_point_cloud(back).points, cloud.points, atol=2e-3)
    assert answer("transform", tile, back, "--crs", "EPSG:25833", "--force")["crs"] == "EPSG:25833"
    np.testing.assert_allclose(loom.read_point_cloud(back).points, cloud.reproject(25833).points, atol=1e-3)
    assert answer("transform", tile, back, "--unit", "foot", "--force")["unit"] == "foot"
    assert loom.read_point_cloud(back).unit == "foot" and loom.read_point_cloud(back).crs is None
    report = answer("transform", mesh, tmp_path / "big.ply", "--scale", 2)
    big = loom.read_triangle_mesh(tmp_path / "big.ply")
    assert report["kind"] == "mesh" and len(big) == 2 and big.get_max_bound().tolist() == [2, 2, 0]
    output_of("transform", tile, tmp_path / "a.npz", "--translate", 1, 2, 3)
    moved = loom.read_point_cloud(tmp_path / "a.npz").points - [[1, 2, 3]]
    np.testing.assert_allclose(moved, cloud.points, atol=1e-4)


def test_split_writes_each_point_into_one_part(tile, tmp_path):
    cloud, folder = loom.read_point_cloud(tile), tmp_path / "parts"
    report = answer("split", tile, "-o", folder, "--by", "classification")
    assert names_in(folder) == ["tile_classification_0.laz", "tile_classification_6.laz"] == [*report["parts"]]
    building = loom.read_point_cloud(folder / "tile_classification_6.laz")
    expected = cloud.points[np.asarray(cloud["classification"]) == 6]
    np.testing.assert_allclose(building.points, expected, rtol=0, atol=2e-6)  # float32 about other origins
    cells = tmp_path / "cells"
    output_of("split", tile, "-o", cells, "--cell", 30, "--format", "ply")
    parts = [loom.read_point_cloud(cells / name) for name in names_in(cells)]
    assert sum(map(len, parts)) == 8000 and len(parts) == 9
    for name, part in zip(names_in(cells), parts, strict=True):
        column, row = map(int, name.removesuffix(".ply").split("_")[1:])
        assert (np.floor(part.points[:, :2] / 30) == [column, row]).all()
    assert "exists already" in refusal("split", tile, "-o", folder, "--by", "classification")
    assert "has no attribute 'gone'" in refusal("split", tile, "-o", tmp_path / "no", "--by", "gone")
    assert "expected 1 to 1,000" in refusal("split", tile, "-o", tmp_path / "no", "--cell", 0.5)
    assert not (tmp_path / "no").exists()


def test_points_without_a_value_are_reported(tmp_path):
    points = np.array([[0, 0, 0], [1, 1, 0], [np.nan, 0, 0]])
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, kind=np.array([1.0, np.nan, 2.0])))
    report = unreliable("split", tmp_path / "a.ply", "-o", tmp_path / "parts", "--by", "kind")
    assert names_in(tmp_path / "parts") == ["a_kind_1.ply", "a_kind_2.ply"] and "1 points" in report["warnings"][0]


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("transform a.ply b.ply", "expected one of --pose, --translate, --scale, --crs and --unit"),
        ("transform a.ply b.ply --scale 2 --unit foot", "expected one of --pose"),
        ("transform a.ply b.ply --scale 2 --inverse", "--inverse requires --pose"),
        ("split a.ply -o b", "expected one of --by and --cell"),
        ("split a.ply -o b --by a --cell 2", "expected one of --by and --cell"),
        ("merge -o b.ply", "IN..."),
        ("dtm a.ply", "--output"),
        ("ground a.ply b.ply --cell 0", "'--cell'"),
    ],
)
def test_usage_errors(words, message):
    result = run(*words.split())
    assert result.exit_code == 2 and message in result.stderr
