"""Results of tiles are bitwise identical to operations in memory for any tile size."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import read_las
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable
from pointloom.tiling import plan as plan_module
from pointloom.tiling import work_tile
from pointloom.tiling.manifest import UNSORTED_COLOR, Manifest

from .scenes import CORNER, SIDE, STEP, finished, in_memory, plan_of, read_cloud, rows_of, survey, tiled

MIDDLE = (CORNER + np.array([SIDE / 2, SIDE / 2, 0])).tolist()
CHAINS = {
    "voxels": [{"step": "voxel_down_sample", "voxel_size": 0.7}],
    "radius outliers": [{"step": "remove_radius_outlier", "nb_points": 4, "radius": 0.9}],
    "normals in a radius": [{"step": "estimate_normals", "radius": 1.0, "max_nn": None}],
    "normals of both": [{"step": "estimate_normals", "radius": 1.5, "max_nn": 10}],
    "normals of the nearest": [{"step": "estimate_normals", "max_nn": 12}],
    "statistical outliers": [{"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 1.5}],
    "smoothing": [{"step": "smooth_mls", "radius": 1.0, "max_nn": None}],
    "smoothing of the nearest": [{"step": "smooth_mls", "radius": 1.5, "max_nn": 12}],
    "a box": [
        {"step": "crop", "min_bound": MIDDLE, "max_bound": (np.array(MIDDLE) + 15).tolist()},
        {"step": "remove_radius_outlier", "nb_points": 4, "radius": 1.0},
    ],
    "a chain": [
        {"step": "remove_statistical_outlier", "nb_neighbors": 8, "std_ratio": 2.0},
        {"step": "voxel_down_sample", "voxel_size": 0.5},
        {"step": "remove_radius_outlier", "nb_points": 2, "radius": 1.2},
        {"step": "estimate_normals", "max_nn": 10},
    ],
}


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"))


def in_one_piece(files, steps, plan):
    return in_memory(read_cloud(files, np.array(plan["origin"])), steps, plan["voxel_low"])


@pytest.fixture(scope="module")
def small_files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"), count=2500)


OFFSETS = [(0.0, 0.0, 0.0), (412000.0, 5651000.0, 100.0), (1e6, 1e6, 1e6), (-1e6, -5e5, -100.0), (-30.0, -25.0, -2.0)]


@pytest.mark.slow_on_emulated_cuda("ten surveys, each a job of tiles")
@pytest.mark.parametrize("step", [None, 0.05])  # random positions, or many on borders of voxels
@pytest.mark.parametrize("offset", OFFSETS)
def test_voxels_of_tiles_are_those_of_the_public_call(tmp_path, device, offset, step):
    points = np.random.default_rng(3).random((3000, 3)) * (60, 50, 2)
    points = (points if step is None else np.round(points / step) * step) + offset
    path = tmp_path / "survey.laz"
    loom.write_point_cloud(path, loom.PointCloud(np.round(points, 3)))
    cloud = loom.read_point_cloud(path)
    for voxel in (1.0, 0.7):
        expected = cloud.voxel_down_sample(voxel)
        corner = cloud.get_min_bound() - voxel / 2
        for size in (13.7, 200.0):
            job = tmp_path / f"{voxel}-{size}"
            steps = [{"step": "voxel_down_sample", "voxel_size": voxel}]
            status = loom.tiling.plan_tiles(path, steps, job, size=size)
            np.testing.assert_allclose(status.voxel_corners, [corner], atol=1e-5)
            assert f"voxels from {status.voxel_corners[0][0]:.10g}, " in str(status)
            loom.tiling.run_tiles(job, device=device)
            result = loom.read_point_cloud(loom.tiling.finish_tiles(job), device=device)
            assert len(result) == len(expected)
            assert np.max(result.compute_point_cloud_distance(expected.to(device))) < 1e-5  # rounded in the file


def test_the_corner_of_voxels_is_that_of_all_files(files, tmp_path):
    """Also after a step that removes the lowest points. Another corner is a parameter of the step."""
    lowest = np.min([read_las(path).points.min(axis=0) for path in files], axis=0)
    steps = [{"step": "crop", "min_bound": MIDDLE, "max_bound": (np.array(MIDDLE) + 15).tolist()}]
    steps += [{"step": "voxel_down_sample", "voxel_size": 1.0}]
    status = loom.tiling.plan_tiles(files, steps, tmp_path / "job", size=20)
    np.testing.assert_allclose(status.voxel_corners, [lowest - 0.5], atol=1e-4)
    assert loom.tiling.run_tiles(tmp_path / "job").voxel_corners == status.voxel_corners
    steps[1]["corner"] = [0.5, 0.5, 0.0]
    status = loom.tiling.plan_tiles(files, steps, tmp_path / "other", size=20)
    np.testing.assert_allclose(status.voxel_corners, [[0.5, 0.5, 0.0]], atol=1e-9)
    assert "; voxels from 0.5, 0.5, 0" in str(status)


def check(files, steps, job, device="cpu", **options):
    """Check that tiles give the rows of a single machine; return the result."""
    result, plan = tiled(files, steps, job, device, **options)
    expected = in_one_piece(files, steps, plan)
    assert len(expected) > 0
    np.testing.assert_array_equal(rows_of(result), rows_of(expected))
    return result


@pytest.mark.parametrize(
    ("chain", "size"),
    [
        *((chain, 20.0) for chain in ("normals of both", "a box", "a chain")),
        *(pytest.param(chain, 17.3, marks=pytest.mark.slow) for chain in CHAINS),
        pytest.param("a chain", 100.0, marks=pytest.mark.slow),
    ],
)
def test_tiles_of_any_size_are_bitwise_identical_to_one_machine(files, tmp_path, chain, size):
    check(files, CHAINS[chain], tmp_path / "job", size=size)


# Of each class of steps; the slow ones are tested on the CPU as "a chain", or above.
@pytest.mark.parametrize(
    "chain",
    ["normals in a radius", *(pytest.param(name, marks=pytest.mark.slow) for name in ("normals of both", "a box"))],
)
def test_tiles_of_a_device_are_bitwise_identical_to_the_cpu(device, small_files, tmp_path, chain):
    check(small_files, CHAINS[chain], tmp_path / "job", device, size=20.0)


@pytest.mark.parametrize("chain", [pytest.param("smoothing", marks=pytest.mark.slow), "smoothing of the nearest"])
def test_smoothed_tiles_of_a_device_match_the_cpu_within_two_micrometers(device, small_files, tmp_path, chain):
    """A GPU fuses multiplications and additions."""
    result, plan = tiled(small_files, CHAINS[chain], tmp_path / "job", device, size=20.0)
    tables = [rows_of(cloud) for cloud in (result, in_one_piece(small_files, CHAINS[chain], plan))]
    by_time = [rows[np.lexsort(rows[:, 3:].T)] for rows in tables]
    np.testing.assert_array_equal(by_time[0][:, 3:], by_time[1][:, 3:])
    assert np.abs(by_time[0] - by_time[1])[:, :3].max() * STEP <= 2e-6


@pytest.mark.slow
def test_a_too_small_halo_is_doubled(files, tmp_path, monkeypatch):
    init = work_tile.Plan.__init__

    def with_small_guesses(self, plan):
        init(self, plan)
        for step in self.steps:
            step.radius = 0.6

    monkeypatch.setattr(plan_module.Plan, "__init__", with_small_guesses)
    check(files, CHAINS["normals of the nearest"], tmp_path / "job", size=20.0)


@pytest.mark.parametrize("suffix", [pytest.param(".las", marks=pytest.mark.slow), ".copc.laz"])
def test_every_file_format_gives_the_same_result(tmp_path, suffix):
    files = survey(tmp_path, count=2000)
    others = [tmp_path / f"other{number}{suffix}" for number in range(2)]
    for path, like in zip(others, files, strict=True):
        loom.write_point_cloud(path, loom.read_point_cloud(like), like=like, scale=1e-6)
    check(others, CHAINS["normals of the nearest"], tmp_path / "job", size=21.0)


def test_the_result_may_be_a_copc_file(files, tmp_path):
    result = check(files, CHAINS["voxels"], tmp_path / "job", size=30.0, output="copc")
    part = loom.read_copc(tmp_path / "job" / "result.copc.laz", within=loom.AxisAlignedBoundingBox(CORNER, MIDDLE))
    assert 0 < len(part) < len(result)


@pytest.mark.slow
def test_steps_with_radius_zero_lose_no_point_on_rounded_borders(tmp_path):
    corner, cells, size = np.array([636_001.76, 848_935.2]), 14, 41.3
    positions = np.random.default_rng(0).integers(0, cells + 1, (3000, 2)) * size
    points = np.column_stack([corner + positions, np.arange(3000) * 0.01])
    points[0, :2] = corner
    path = tmp_path / "grid.laz"
    write_las(path, PointTable(points, attributes={"gps_time": np.arange(3000.0)}), scale=1e-5, offset=points[0])
    steps = [{"step": "crop", "min_bound": [0, 0, -1], "max_bound": [1e7, 1e7, 1e4]}]
    result, plan = tiled([path], steps, tmp_path / "job", size=size)
    assert np.prod(plan["shape"]) >= cells**2
    np.testing.assert_array_equal(np.sort(result["gps_time"]), np.arange(3000.0))


def brighter(cloud, by):
    cloud["intensity"] = np.asarray(cloud["intensity"]).astype(np.uint16) // by
    return cloud.select_by_mask(np.asarray(cloud["intensity"]) > 1000)


def test_a_function_with_its_radius_is_a_step(files, tmp_path):
    steps = [{"step": "function", "call": brighter, "reach": 0, "arguments": {"by": 2}}]
    result, plan = tiled(files, steps, tmp_path / "job", size=30.0)
    np.testing.assert_array_equal(rows_of(result), rows_of(brighter(read_cloud(files, np.array(plan["origin"])), 2)))


def test_only_the_given_area_is_computed(files, tmp_path):
    low = CORNER[:2] + 12
    only = [*low, *(low + 2)]
    result, plan = tiled(files, CHAINS["radius outliers"], tmp_path / "job", size=10.0, only=only)
    expected = in_memory(read_cloud(files, np.array(plan["origin"])), CHAINS["radius outliers"], None)
    offsets = (expected.points - CORNER)[:, :2]
    mask = ((offsets > 9.999) & (offsets < 19.999)).all(axis=1)
    np.testing.assert_array_equal(rows_of(result), rows_of(expected.select_by_mask(mask)))


def strips(folder):
    """Write the survey as four adjacent files."""
    cloud = read_cloud(survey(folder), CORNER)
    strip = ((cloud.points[:, 0] - CORNER[0]) // (SIDE / 4)).clip(0, 3)
    paths = [folder / f"strip{number}.laz" for number in range(4)]
    for number, path in enumerate(paths):
        loom.write_point_cloud(path, cloud.select_by_mask(strip == number), scale=STEP)
    return paths


def sorted_sources(job):
    with Manifest(job) as manifest:
        return [row["id"] for row in manifest.rows("SELECT id FROM sources WHERE full != ?", UNSORTED_COLOR)]


def test_files_far_from_the_area_are_not_sorted_into_tiles(tmp_path):
    files = strips(tmp_path)
    low = CORNER[:2] + 2
    steps = CHAINS["radius outliers"]
    result, plan = tiled(files, steps, tmp_path / "job", size=10.0, only=[*low, *(low + 4)])
    assert sorted_sources(tmp_path / "job") == [0, 1]
    expected = in_memory(read_cloud(files, np.array(plan["origin"])), steps, None)
    mask = ((expected.points - CORNER)[:, :2] < 9.999).all(axis=1)
    np.testing.assert_array_equal(rows_of(result), rows_of(expected.select_by_mask(mask)))


def test_files_beside_an_area_at_either_end_are_sorted_into_tiles_at_once(tmp_path):
    files = strips(tmp_path)
    for name, low, expected in (("low", 2.0, [0, 1]), ("high", SIDE - 6, [2, 3])):
        low = CORNER[:2] + low
        area = [*low, *(low + 4)]
        loom.tiling.plan_tiles(files, CHAINS["radius outliers"], tmp_path / name, size=10.0, only=area)
        assert sorted_sources(tmp_path / name) == expected


@pytest.mark.slow
def test_a_source_file_is_sorted_into_tiles_on_demand(tmp_path, monkeypatch, two_workers):
    files = strips(tmp_path)
    steps = [{"step": "estimate_normals", "max_nn": 12}]
    low = CORNER[:2] + 2
    with monkeypatch.context() as patch:
        patch.setattr(plan_module, "far_files", lambda *_: {1, 2, 3})
        loom.tiling.plan_tiles(files, steps, tmp_path / "job", size=10.0, only=[*low, *(low + 4)])
    assert sorted_sources(tmp_path / "job") == [0]
    assert loom.tiling.run_tiles(tmp_path / "job", scheduler=two_workers).is_finished
    assert sorted_sources(tmp_path / "job") == [0, 1]
    expected = in_memory(read_cloud(files, np.array(plan_of(tmp_path / "job")["origin"])), steps, None)
    mask = ((expected.points - CORNER)[:, :2] < 9.999).all(axis=1)
    np.testing.assert_array_equal(rows_of(finished(tmp_path / "job")), rows_of(expected.select_by_mask(mask)))
