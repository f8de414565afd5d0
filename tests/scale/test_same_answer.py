"""Tiles give the bits of the operations in memory, whatever their size."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.files.points.las_writer import write_las
from pointloom.files.table import PointTable
from pointloom.scale import work_tile
from pointloom.scale.manifest import NOT_LAID, Manifest

from .scenes import CORNER, SIDE, SIZES, STEP, finished, in_memory, plan_of, rows_of, survey, tiled, whole_cloud

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
        {"step": "remove_radius_outlier", "nb_points": 4, "radius": 0.9},
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


@pytest.mark.parametrize("size", SIZES)
@pytest.mark.parametrize("chain", CHAINS)
def test_tiles_of_any_size_give_the_bits_of_one_machine(files, tmp_path, chain, size):
    found, plan = tiled(files, CHAINS[chain], tmp_path / "job", size=size)
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), CHAINS[chain], plan["voxel_corner"])
    assert len(expected) > 0
    np.testing.assert_array_equal(rows_of(found), rows_of(expected))


@pytest.mark.slow
def test_points_that_are_equally_near_are_why_tiles_share_a_curve(files, tmp_path, monkeypatch):
    steps = CHAINS["normals of the nearest"]
    monkeypatch.setattr(work_tile, "_adopt_tree", lambda plan, part: None)
    found, plan = tiled(files, steps, tmp_path / "job", size=10.0)
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), steps, plan["voxel_corner"])
    assert not np.array_equal(rows_of(found), rows_of(expected))


def test_a_halo_that_is_too_small_is_doubled(files, tmp_path, monkeypatch):
    steps = CHAINS["normals of the nearest"]
    loom.scale.plan_tiles(files, steps, tmp_path / "job", size=20.0)
    monkeypatch.setattr("pointloom.scale.plan.Plan.__init__", _with_small_guesses(work_tile.Plan.__init__))
    assert loom.scale.run_tiles(tmp_path / "job").is_finished
    found = finished(tmp_path / "job")
    plan = plan_of(tmp_path / "job")
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), steps, plan["voxel_corner"])
    np.testing.assert_array_equal(rows_of(found), rows_of(expected))


def _with_small_guesses(init):
    def make(self, told):
        init(self, told)
        for step in self.steps:
            step.reach = 0.6

    return make


def test_without_the_certificate_a_small_halo_gives_another_answer(files, tmp_path, monkeypatch):
    steps = CHAINS["normals of the nearest"]
    monkeypatch.setattr("pointloom.scale.plan.Plan.__init__", _with_small_guesses(work_tile.Plan.__init__))
    monkeypatch.setattr(work_tile, "_certify", lambda *_: None)
    found, plan = tiled(files, steps, tmp_path / "job", size=20.0)
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), steps, plan["voxel_corner"])
    assert not np.array_equal(rows_of(found), rows_of(expected))


@pytest.mark.parametrize("suffix", [".las", ".copc.laz"])
def test_every_kind_of_file_gives_the_same(tmp_path, suffix):
    files = survey(tmp_path, count=3000, files=3)
    clouds = [loom.read_point_cloud(path) for path in files]
    others = [tmp_path / f"other{number}{suffix}" for number in range(3)]
    for cloud, path, like in zip(clouds, others, files, strict=True):
        loom.write_point_cloud(path, cloud, like=like, scale=1e-6)
    steps = CHAINS["normals of the nearest"]
    found, plan = tiled(others, steps, tmp_path / "job", size=11.0)
    expected = in_memory(whole_cloud(others, np.array(plan["origin"])), steps, plan["voxel_corner"])
    np.testing.assert_array_equal(rows_of(found), rows_of(expected))


def test_the_result_may_be_a_copc_file(files, tmp_path):
    found, plan = tiled(files, CHAINS["voxels"], tmp_path / "job", size=20.0, output="copc")
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), CHAINS["voxels"], plan["voxel_corner"])
    np.testing.assert_array_equal(rows_of(found), rows_of(expected))
    part = loom.read_copc(tmp_path / "job" / "result.copc.laz", within=loom.AxisAlignedBoundingBox(CORNER, MIDDLE))
    assert 0 < len(part) < len(found)


@pytest.mark.slow
@pytest.mark.parametrize("size", [134.48, 41.3, 9.7])
def test_steps_without_reach_lose_no_point_on_borders_that_are_rounded(tmp_path, size):
    corner, cells = np.array([636_001.76, 848_935.2]), 14
    places = np.random.default_rng(0).integers(0, cells + 1, (3000, 2)) * size
    points = np.column_stack([corner + places, np.arange(3000) * 0.01])
    points[0, :2] = corner
    path = tmp_path / "grid.laz"
    write_las(path, PointTable(points, attributes={"gps_time": np.arange(3000.0)}), scale=1e-5, offset=points[0])
    steps = [{"step": "crop", "min_bound": [0, 0, -1], "max_bound": [1e7, 1e7, 1e4]}]
    found, plan = tiled([path], steps, tmp_path / "job", size=size)
    assert np.prod(plan["shape"]) >= cells**2
    np.testing.assert_array_equal(np.sort(found["gps_time"]), np.arange(3000.0))


def brighter(cloud, by):
    cloud["intensity"] = np.asarray(cloud["intensity"]).astype(np.uint16) // by
    return cloud.select_by_mask(np.asarray(cloud["intensity"]) > 1000)


def test_a_function_with_its_reach_is_a_step(files, tmp_path):
    steps = [{"step": "function", "call": brighter, "reach": 0, "arguments": {"by": 2}}]
    found, plan = tiled(files, steps, tmp_path / "job", size=15.0)
    expected = brighter(whole_cloud(files, np.array(plan["origin"])), 2)
    np.testing.assert_array_equal(rows_of(found), rows_of(expected))


def test_an_area_is_done_alone(files, tmp_path):
    low = CORNER[:2] + 12
    only = [*low, *(low + 2)]
    found, plan = tiled(files, CHAINS["radius outliers"], tmp_path / "job", size=10.0, only=only)
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), CHAINS["radius outliers"], None)
    x, y = (expected.points - CORNER)[:, :2].T
    mask = (x > 9.999) & (x < 19.999) & (y > 9.999) & (y < 19.999)
    np.testing.assert_array_equal(rows_of(found), rows_of(expected.select_by_mask(mask)))


def strips(folder):
    """The survey as four files side by side, and the buckets that a job of one tile lays."""
    cloud = whole_cloud(survey(folder), CORNER)
    paths = []
    for number, low in enumerate(np.arange(4) * SIDE / 4):
        x = cloud.points[:, 0] - CORNER[0]
        last = number == 3
        part = cloud.select_by_mask((x >= low) & ((x < low + SIDE / 4) | last))
        paths.append(folder / f"strip{number}.laz")
        loom.write_point_cloud(paths[-1], part, scale=STEP)
    return paths


def laid(job):
    with Manifest(job) as manifest:
        return [row["id"] for row in manifest.rows("SELECT id FROM sources WHERE full != ?", NOT_LAID)]


def test_files_that_are_far_from_the_area_are_not_laid(tmp_path):
    files = strips(tmp_path)
    low = CORNER[:2] + 2
    steps = CHAINS["radius outliers"]
    found, plan = tiled(files, steps, tmp_path / "job", size=10.0, only=[*low, *(low + 4)])
    assert laid(tmp_path / "job") == [0, 1]
    expected = in_memory(whole_cloud(files, np.array(plan["origin"])), steps, None)
    mask = ((expected.points - CORNER)[:, :2] < 9.999).all(axis=1)
    np.testing.assert_array_equal(rows_of(found), rows_of(expected.select_by_mask(mask)))


@pytest.mark.slow
@pytest.mark.parametrize("how", [{}, {"workers": 2}])
def test_a_file_that_turns_out_to_be_needed_is_laid_then(tmp_path, monkeypatch, how):
    files = strips(tmp_path)
    steps = [{"step": "estimate_normals", "max_nn": 12}]
    low = CORNER[:2] + 2
    with monkeypatch.context() as patch:
        patch.setattr("pointloom.scale.plan.far_files", lambda *_: {1, 2, 3})
        loom.scale.plan_tiles(files, steps, tmp_path / "job", size=10.0, only=[*low, *(low + 4)])
    assert laid(tmp_path / "job") == [0]
    assert loom.scale.run_tiles(tmp_path / "job", **how).is_finished
    assert laid(tmp_path / "job") == [0, 1]
    expected = in_memory(whole_cloud(files, np.array(plan_of(tmp_path / "job")["origin"])), steps, None)
    mask = ((expected.points - CORNER)[:, :2] < 9.999).all(axis=1)
    np.testing.assert_array_equal(rows_of(finished(tmp_path / "job")), rows_of(expected.select_by_mask(mask)))
