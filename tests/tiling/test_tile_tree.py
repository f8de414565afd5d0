"""COPC from tiles on disk: the octree computed in memory, for any memory limit; errors leave no file."""

from contextlib import nullcontext

import laspy
import numpy as np
import pytest
from laspy.copc import Bounds, CopcReader

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.io.points.copc import open_copc
from pointloom.io.points.copc_writer import write_copc
from pointloom.io.points.las import open_las, read_las
from pointloom.tiling import tile_tree

from .scenes import CORNER, survey

KEEP = [{"step": "crop", "min_bound": (CORNER - 10).tolist(), "max_bound": (CORNER + 1e4).tolist()}]


def job_of(cloud, folder, size, **options):
    """A completed run that keeps all points."""
    loom.write_point_cloud(folder / "cloud.laz", cloud, scale=0.001)
    loom.tiling.plan_tiles(folder / "cloud.laz", KEEP, folder / "job", size=size)
    assert loom.tiling.run_tiles(folder / "job").is_finished
    return folder / "job"


def dense_in_a_corner(count=15_000):
    """A surface so dense in one corner that points share voxels of the coarsest level."""
    rng = np.random.default_rng(7)
    xy = rng.random((count, 2)) ** 6 * 40
    points = np.column_stack([xy, np.sin(xy[:, 0]) + 0.01 * rng.normal(size=count)]) + CORNER
    return loom.PointCloud(points, gps_time=rng.random(count), height=rng.random(count).astype(np.float32))


def in_memory(job, path):
    merged = loom.tiling.finish_tiles(job, path.with_name("merged.laz"))
    header = open_las(merged).header
    write_copc(path, read_las(merged), scale=header.scales, offset=header.offsets, like=header)
    return path


@pytest.fixture(scope="module")
def job(tmp_path_factory):
    return job_of(dense_in_a_corner(), tmp_path_factory.mktemp("dense"), 9.0)


def test_the_file_is_bitwise_identical_to_the_one_made_in_memory(job, tmp_path):
    result = loom.tiling.finish_tiles(job, tmp_path / "a.copc.laz")
    assert result.read_bytes() == in_memory(job, tmp_path / "b.copc.laz").read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize("max_points", [9000, 2000])
def test_sequential_cells_give_the_nodes_of_the_file_made_in_memory(job, tmp_path, monkeypatch, max_points):
    monkeypatch.setattr(tile_tree, "MAX_POINTS", max_points)
    monkeypatch.setattr(tile_tree, "MIN_POINTS", 200)
    monkeypatch.setattr("pointloom.io.points.copc_writer._MIN_NODE_POINTS", 200)
    monkeypatch.setattr(tile_tree, "_CACHE_BYTES", 1)
    result = open_copc(loom.tiling.finish_tiles(job, tmp_path / "a.copc.laz"))
    expected = open_copc(in_memory(job, tmp_path / "b.copc.laz"))
    assert expected.nodes["level"].max() >= 4
    names = ["level", "cell", "count"]
    np.testing.assert_array_equal(result.nodes[names], expected.nodes[names])
    for k in range(len(result.nodes)):
        assert result.unpack(np.array([k])) == expected.unpack(np.array([k]))


@pytest.mark.slow
def test_cells_smaller_than_a_voxel_have_one_point_in_each_voxel_of_a_level(job, tmp_path, monkeypatch):
    monkeypatch.setattr(tile_tree, "MAX_POINTS", 150)
    monkeypatch.setattr(tile_tree, "MIN_POINTS", 0)
    monkeypatch.setattr("pointloom.io.points.copc_writer._MIN_NODE_POINTS", 0)
    paths, counts = zip(*((path, open_las(path).header.point_count) for path in (job / "tiles").iterdir()), strict=True)
    tree = tile_tree.TileTree([*paths], [*counts], lambda *_: None)
    assert max(leaf.depth for leaf in tree.leaves) > 7
    levels: dict[int, list] = {}
    for node in tree.nodes():
        levels.setdefault(node.level, []).append(tree.positions(node.rows))
        low = tree.corner + np.array(node.cell) * tree.side / 2**node.level
        assert (levels[node.level][-1] >= low - 1e-9).all()
        assert (levels[node.level][-1] <= low + tree.side / 2**node.level + 1e-9).all()
    coarse = np.concatenate(levels[0])
    everything = np.concatenate([points for level_points in levels.values() for points in level_points])
    cells = [np.minimum((points - tree.corner) // (tree.side / 128), 127) for points in (coarse, everything)]
    assert {len(np.unique(each, axis=0)) for each in cells} == {len(coarse)} and len(everything) == sum(counts)


def test_laspy_reads_all_points_and_windows(job, tmp_path, monkeypatch):
    monkeypatch.setattr(tile_tree, "MAX_POINTS", 4000)
    path = loom.tiling.finish_tiles(job, tmp_path / "a.copc.laz")
    stored = read_las(path).points
    low, high = CORNER + np.array([1, 2, -5]), CORNER + np.array([9, 8, 5])
    with CopcReader.open(str(path)) as reader:
        assert reader.header.point_count == len(reader.query()) == 15_000
        inside = ((stored >= low) & (stored <= high)).all(axis=1).sum()
        assert 0 < len(reader.query(bounds=Bounds(low, high))) == inside


@pytest.mark.parametrize(
    "points",
    [np.tile(CORNER, (500, 1)), CORNER + np.arange(500)[:, None] * np.array([0.05, 0, 0]), CORNER[None]],
    ids=["coincident", "a line", "one point"],
)
def test_coincident_and_collinear_points(tmp_path, points):
    path = loom.tiling.finish_tiles(job_of(loom.PointCloud(points), tmp_path, 7.0), tmp_path / "a.copc.laz")
    stored = [np.sort(read_las(each).points, axis=0) for each in (path, tmp_path / "cloud.laz")]
    np.testing.assert_array_equal(*stored)


def test_a_chunk_on_the_upper_bound_of_a_cell_is_complete(tmp_path, monkeypatch):
    """Its points are a wall in the last of the finest cells (4.8 micrometers) before the middle of the cube."""
    monkeypatch.setattr(tile_tree, "MAX_POINTS", 100)
    points = np.random.default_rng(0).integers(0, 1000, (900, 3)) / 100.0
    points[600:, 0], points[0], points[1] = 4.999998, 0.0, 10.0
    paths = [tmp_path / "most.laz", tmp_path / "wall.laz"]
    loom.write_point_cloud(paths[0], loom.PointCloud(points[:600]), scale=1e-6)
    loom.write_point_cloud(paths[1], loom.PointCloud(points[600:]), like=paths[0])
    tree = tile_tree.TileTree(paths, [600, 300], lambda *_: None)
    found = np.concatenate([tree.positions(node.rows) for node in tree.nodes()])
    np.testing.assert_allclose(found[np.lexsort(found.T)], points[np.lexsort(points.T)], atol=1e-9)


def test_too_many_coincident_points_are_an_error(tmp_path, monkeypatch):
    monkeypatch.setattr(tile_tree, "MAX_POINTS", 100)
    job = job_of(loom.PointCloud(np.tile(CORNER, (500, 1))), tmp_path, 7.0)
    with pytest.raises(FileError, match=r"/tiles:.*500.*voxel_down_sample"):
        loom.tiling.finish_tiles(job, tmp_path / "a.copc.laz")
    assert not [*tmp_path.glob("*.copc.laz*")]


@pytest.mark.parametrize("fault", ["another", "damaged"])
def test_a_bad_tile_is_named_and_no_file_is_left(tmp_path, fault):
    job = job_of(loom.PointCloud(read_las(survey(tmp_path, count=3000, files=1)[0]).points), tmp_path, 20.0)
    tile = job / "tiles" / "1_1.laz"
    content = tile.read_bytes()
    if fault == "another":
        loom.write_point_cloud(tile, loom.read_point_cloud(tile).select_by_index([0, 1, 2]), like=tile)
    else:
        begin = open_las(tile).header.begin
        tile.write_bytes(content[: begin + 700] + bytes(300) + content[begin + 1000 :])
    with pytest.raises(FileError, match=r"1_1\.laz"):
        loom.tiling.finish_tiles(job, tmp_path / "a.copc.laz")
    assert not [path for path in tmp_path.iterdir() if "copc" in path.name]


def test_an_existing_target_is_rejected_first_without_overwrite(job, tmp_path):
    (tmp_path / "a.copc.laz").write_bytes(b"mine")
    with pytest.raises(FileError, match="exists already"):
        loom.tiling.finish_tiles(job, tmp_path / "a.copc.laz", overwrite=False)
    assert (tmp_path / "a.copc.laz").read_bytes() == b"mine"


@pytest.mark.slow
@pytest.mark.parametrize("count", [1, 2])
def test_tiles_keep_missing_values_apart_and_the_records_of_a_single_file(tmp_path, count):
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.file_source_id = np.full(3, 0.001), 9
    more = {"scales": [0.01], "offsets": [1.0], "no_data": [-9999]}
    header.add_extra_dim(laspy.ExtraBytesParams("height", "i2", "above ground", **more))
    header.vlrs.append(laspy.VLR("mine", 7, "calibration", b"abc"))
    las, rng = laspy.LasData(header), np.random.default_rng(0)
    las.x, las.y, las.z = rng.random((3, 300)) * 20
    las.points.array["height"] = np.where(np.arange(300) % 3, np.arange(300), -9999)
    for k in range(count):
        las.write(tmp_path / f"{k}.las")
    with pytest.warns(UserWarning, match="records mine 7") if count > 1 else nullcontext():
        loom.tiling.plan_tiles([tmp_path / f"{k}.las" for k in range(count)], [], tmp_path / "job", size=10.0)
    assert loom.tiling.run_tiles(tmp_path / "job").is_finished
    for name in ("a.laz", "a.copc.laz"):
        result = laspy.read(loom.tiling.finish_tiles(tmp_path / "job", tmp_path / name))
        assert np.isnan(result["height"]).sum() == 100 * count
        (record,) = result.vlrs.get("ExtraBytesVlr")[0].extra_bytes_structs
        assert (record.min, record.max, record.description) == (1.01, 1 + 2.99, b"above ground")
        assert bool(result.vlrs.get_by_id("mine")) == (result.header.file_source_id == 9) == (count == 1)


def test_unknown_outputs_are_rejected(tmp_path):
    with pytest.raises(ValueError, match=r"^output:"):
        loom.tiling.finish_tiles(tmp_path, tmp_path / "x", output="ept")
