"""Commands of surveyors: results agree with the library, and errors name the remedy."""

import warnings
from contextlib import nullcontext

import laspy
import numpy as np
import pyproj
import pytest

import pointloom as loom
from pointloom.io.meshes.by_extension import write_mesh
from pointloom.io.points.by_extension import write_table
from pointloom.io.points.codecs import WriteOptions
from pointloom.io.points.las_crs import GeographicWarning
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import MeshTable, PointTable

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


def test_ground_reports_terrain_that_may_be_steeper_than_the_slope(tmp_path, rng):
    x, y = rng.random((2, 25_000)) * 110
    z = 6.0 * np.floor(np.maximum(np.hypot(x - 55, y - 55) - 15, 0) / 12)
    loom.write_point_cloud(tmp_path / "steps.ply", loom.PointCloud(np.column_stack([x, y, z])))
    report = unreliable("ground", tmp_path / "steps.ply", tmp_path / "a.ply")
    assert "with --slope=0.15 are ground with --slope=0.45" in report["warnings"][0]
    assert report["points"] < answer("ground", tmp_path / "steps.ply", tmp_path / "b.ply", "--slope", 0.45)["points"]


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


def test_a_raster_is_described_shown_and_drawn_as_contours(tile, tmp_path):
    output_of("dtm", tile, "-o", dtm := tmp_path / "dtm.tif", "--kind", "lowest", "--cell", 2)
    raster = loom.read_raster(dtm)
    (facts,) = answer("info", dtm)["files"]
    assert (facts["kind"], facts["coordinate_system"], facts["cell"]) == ("raster", "EPSG:25832", 2.0)
    assert facts["heights"]["highest"] == float(np.nanmax(raster.values))
    assert f"{np.isfinite(raster.values).sum()} points" in output_of("view", dtm, "--screenshot", tmp_path / "dtm.png")
    pytest.importorskip("pyogrio")
    report = answer("contours", dtm, "-o", tmp_path / "lines.gpkg", "--interval", 0.5)
    levels = np.unique(raster.contour_lines(0.5).points[:, 2])
    assert (report["levels"], report["lowest"], report["highest"]) == (len(levels), levels[0], levels[-1])
    assert "exists already" in refusal("contours", dtm, "-o", tmp_path / "lines.gpkg", "--interval", 0.5)
    assert "is not a GeoTIFF" in refusal("contours", tile, "-o", tmp_path / "b.gpkg", "--interval", 0.5)
    (raster + 3.0).write(tmp_path / "high.tif")
    assert unreliable("contours", tmp_path / "high.tif", "-o", tmp_path / "c.gpkg", "--interval", 1e3)["lines"] == 0


def test_volume_is_that_of_the_library_from_clouds_meshes_and_rasters(tmp_path, rng):
    before, after = (rng.uniform(0, 20, (20_000, 3)) * (1, 1, 0.001) for _ in range(2))
    after[:, 2] += np.maximum(0, 2 - np.hypot(after[:, 0] - 10, after[:, 1] - 10))  # a cone of 8.38 m^3
    clouds = [loom.PointCloud(each, unit="metre", classification=np.full(20_000, 2)) for each in (before, after)]
    for name, cloud in zip(("a.ply", "b.ply"), clouds, strict=True):
        loom.write_point_cloud(tmp_path / name, cloud)
    outputs = {name: tmp_path / f"change.{name}" for name in ("tif", "png", "html")}
    words = ["volume", tmp_path / "a.ply", tmp_path / "b.ply", "--cell", 0.5]
    options = ["-o", outputs["tif"], "--picture", outputs["png"], "--report", outputs["html"]]
    report = answer(*words, *options)
    expected = loom.volume_change(*clouds, 0.5)
    assert report["net"] == expected.net == pytest.approx(8 * np.pi / 3, abs=report["net_uncertainty"])
    np.testing.assert_array_equal(loom.read_raster(outputs["tif"]).values, expected.difference.values)
    page = outputs["html"].read_text()
    assert page.count("<img") == 1 and f"{expected.net:,.2f}" in page and "All quality checks passed" in page
    assert loom.read_color(outputs["png"]).shape[2] == 3

    output_of("dtm", tmp_path / "b.ply", "-o", tmp_path / "b.tif", "--cell", 0.5)
    mixed = answer("volume", tmp_path / "a.ply", tmp_path / "b.tif")
    assert mixed["net"] == pytest.approx(report["net"], abs=0.6)
    assert "Pass --cell" in refusal(*words[:3])
    assert "--cell: expected 0.5, that of " in refusal("volume", tmp_path / "b.tif", tmp_path / "b.ply", "--cell", 2)
    assert run(*words, "--picture", outputs["png"], "--report", outputs["png"], "--force").exit_code == 2
    loom.write_point_cloud(tmp_path / "high.ply", clouds[0].translate([0, 0, 0.3]))
    high = unreliable(
        "volume", tmp_path / "a.ply", tmp_path / "high.ply", "--cell", 0.5, "--report", outputs["html"], "--force"
    )
    assert "pass --registration-error" in high["warnings"][0] and "Unreliable result" in outputs["html"].read_text()


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


@pytest.fixture
def corridor(tmp_path, rng):
    """The stored integers of a corridor of 424 km in LAZ with steps of 1 mm, where float32 has steps of 16 mm.

    `a.laz` has all of them in groups of 20 m, `even.laz` and `odd.laz` every other one. `index` is the row.
    """
    starts = np.repeat(rng.integers(-150_000_000, 150_000_000, 100), 30)
    raw = np.column_stack([starts, starts, np.zeros(3000, int)]) + rng.integers(0, 20_000, (3000, 3))
    for name, rows in (("a", slice(None)), ("even", slice(0, None, 2)), ("odd", slice(1, None, 2))):
        table = PointTable(raw[rows] * 0.001 + [550_000, 5_450_000, 0], attributes={"index": np.arange(3000)[rows]})
        write_las(tmp_path / f"{name}.laz", table, scale=0.001, offset=[550_000, 5_450_000, 0])
    np.savetxt(tmp_path / "unmoved.txt", np.eye(4))
    return raw


EXACT_COMMANDS = {
    "convert": ("a.laz", "out.laz"),
    "clean": ("a.laz", "out.laz"),
    "crop": ("a.laz", "out.laz", "--box", 0, 0, -1, 1e6, 1e7, 100),
    "merge": ("even.laz", "odd.laz", "-o", "out.laz"),
    "transform": ("a.laz", "out.laz", "--pose", "unmoved.txt"),
    "normals": ("a.laz", "out.laz"),
    "cluster": ("a.laz", "out.laz", "--radius", 10),
    "plane": ("a.laz", "out.laz", "--distance", 5),
    "downsample": ("a.laz", "out.laz", "--every", 3),
    "split": ("a.laz", "-o", "parts", "--cell", 1e6),
}


@pytest.mark.parametrize("command", EXACT_COMMANDS)
def test_commands_keep_the_integers_of_wide_las_files(command, corridor, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    arguments = EXACT_COMMANDS[command]
    result = run(command, *arguments, "--json")
    assert result.exit_code == 0 and "rounded" not in result.stderr
    outputs = [path for path in (tmp_path / "parts").glob("*.laz")] or [tmp_path / "out.laz"]
    for path in outputs:
        las = laspy.read(path)
        np.testing.assert_array_equal(las.header.scales, [0.001] * 3)
        assert len(las) and np.abs(las.xyz - corridor[las["index"]] * 0.001 - [550_000, 5_450_000, 0]).max() < 1e-6
    if command == "merge":
        assert sorted(las["index"]) == list(range(3000))


@pytest.mark.filterwarnings("always::pointloom.core.units.UnitWarning")
def test_change_and_aligned_sources_keep_the_integers_of_wide_las_files(corridor, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    commands = [("change", "a.laz", "even.laz", "--cylinder", 8, "-o", "points.laz", "--painted", "painted.laz")]
    commands += [("change", "a.laz", "even.laz", "--cylinder", 8, "-o", "cores.laz", "--cores", 5)]
    commands += [("register", "a.laz", "even.laz", "-o", "T.txt", "--init", "identity", "--voxel", 1)]
    commands[-1] += ("--aligned", "aligned.laz")
    for command in commands:
        lines = [line for line in run(*command).stderr.splitlines() if "rounded to float32" in line]
        assert {line.partition(".laz: ")[0] for line in lines} == {"warning: a", "warning: even"} and len(lines) == 2
        assert all("in steps of up to 0.0156. The steps of the file are 0.001." in line for line in lines)
    T = np.loadtxt("T.txt")
    for name, pose in (("points.laz", None), ("painted.laz", None), ("cores.laz", None), ("aligned.laz", T)):
        las = laspy.read(name)
        world = corridor[las["index"]] * 0.001 + [550_000, 5_450_000, 0]
        world = world if pose is None else world @ pose[:3, :3].T + pose[:3, 3]
        assert np.abs(las.xyz - world).max() < 0.00051


def test_rounded_points_of_a_file_are_one_warning_for_each_file(corridor, tmp_path):
    with pytest.warns(loom.UnitWarning, match="a.laz: .* of 3,000 points far from .* up to 0.0156.*are 0.001") as read:
        cloud = loom.read_point_cloud(tmp_path / "a.laz")
    with pytest.warns(loom.UnitWarning, match="a.laz: points far") as read_in_chunks:
        assert len(list(loom.read_las_chunks(tmp_path / "a.laz", 1000))) == 3
    with pytest.warns(loom.UnitWarning, match="b.laz: .* of 3,000 points") as written:
        loom.write_point_cloud(tmp_path / "b.laz", cloud, like=tmp_path / "a.laz")
    assert len(read) == len(read_in_chunks) == len(written) == 1
    loom.write_point_cloud(tmp_path / "c.laz", cloud, scale=0.05)  # coarser than float32
    write_las(tmp_path / "near.laz", PointTable(corridor % 30_000_000 * 0.001), scale=0.001)  # 30 km
    for name in ("c.laz", "near.laz"):
        loom.read_point_cloud(tmp_path / name)


@pytest.mark.parametrize("name", ["a.csv", "a.xyz", "a.ply", "a.pcd", "a.npy", "a.npz"])
def test_rounded_points_of_files_without_steps_are_a_warning_too(corridor, tmp_path, name):
    points = corridor * 0.001 + [550_000, 5_450_000, 0]
    for values, is_coarse in ((points, True), (np.round(points, 1), False)):
        write_table(tmp_path / name, PointTable(values), WriteOptions())
        with pytest.warns(loom.UnitWarning, match=f"{name}: .* are 0.001") if is_coarse else nullcontext():
            loom.read_point_cloud(tmp_path / name)
    mesh = MeshTable(points, np.arange(3000).reshape(-1, 3))
    write_mesh(tmp_path / "mesh.ply", mesh, ascii=False, overwrite=True)
    with pytest.warns(loom.UnitWarning, match="mesh.ply: .* of 3,000 points"):
        loom.read_triangle_mesh(tmp_path / "mesh.ply")


def test_merged_files_have_the_finest_steps_and_all_decimals(tmp_path, rng):
    values = np.round(rng.random((3, 50, 3)) * 100 + [412_300, 5_651_200, 100], 4)
    write_las(tmp_path / "coarse.laz", PointTable(np.round(values[0], 2)), scale=0.01)
    write_las(tmp_path / "fine.laz", PointTable(values[1]), scale=0.0001)
    write_table(tmp_path / "text.csv", PointTable(np.round(values[2], 3)), WriteOptions())
    expected = np.vstack([np.round(values[0], 2), values[1], np.round(values[2], 3)])
    for order in ([0, 1, 2], [2, 0, 1]):
        sources = [tmp_path / ("coarse.laz", "fine.laz", "text.csv")[k] for k in order]
        output_of("merge", *sources, "-o", tmp_path / "both.laz", "--force")
        assert laspy.read(tmp_path / "both.laz").header.scales.tolist() == [0.0001] * 3
        rows = np.concatenate([np.arange(50) + 50 * k for k in order])
        np.testing.assert_allclose(laspy.read(tmp_path / "both.laz").xyz, expected[rows], rtol=0, atol=1e-8)


@pytest.mark.parametrize("relief", [0.0, 200.0])
def test_a_survey_in_degrees_keeps_its_centimeters_there_and_back(tmp_path, rng, relief):
    utm = np.column_stack([rng.random((500, 2)) * 500 + [412_300, 5_651_200], rng.random(500) * relief + 100])
    loom.write_point_cloud(tmp_path / "utm.laz", loom.PointCloud(utm, crs=25832))
    output_of("transform", tmp_path / "utm.laz", tmp_path / "degrees.laz", "--crs", "EPSG:4326")
    las = laspy.read(tmp_path / "degrees.laz")
    assert las.header.scales[:2].tolist() == [1e-7, 1e-7]
    exact = pyproj.Transformer.from_crs(25832, 4326, always_xy=True).transform(*utm[:, :2].T)
    assert np.abs(las.xyz[:, :2] - np.column_stack(exact)).max() < 0.6e-7 and np.abs(las.z - utm[:, 2]).max() < 0.001
    with pytest.warns(GeographicWarning):
        loom.write_point_cloud(tmp_path / "copy.laz", loom.read_point_cloud(tmp_path / "degrees.laz"))
    np.testing.assert_allclose(laspy.read(tmp_path / "copy.laz").xyz, las.xyz, rtol=0, atol=1e-12)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", GeographicWarning)
        output_of("transform", tmp_path / "degrees.laz", tmp_path / "back.laz", "--crs", "EPSG:25832")
    assert np.abs(laspy.read(tmp_path / "back.laz").xyz - utm).max() < 0.01
