"""Features, thinning and change detection by tiles match a single machine."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.las import read_las
from pointloom.io.points.las_writer import write_las
from pointloom.io.table import PointTable

from .scenes import CORNER, SIZES, STEP, in_memory, read_cloud, rows_of, survey, tiled


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("first"))


def assert_same(result, expected, *names):
    """Check that two clouds have the same rows with bitwise identical attributes."""
    assert len(expected) > 0
    tables = []
    for cloud in (result, expected):
        columns = [np.rint((cloud.points - cloud.origin) / STEP), np.asarray(cloud["gps_time"], np.float64)[:, None]]
        for name in names:
            values = np.asarray(cloud[name]).reshape(len(cloud), -1)
            assert np.isfinite(values.astype(np.float64)).mean() > 0.1, name
            columns.append(values)
        rows = np.column_stack(columns).astype(np.float64).view(np.int64)
        tables.append(rows[np.lexsort(rows.T)])
    np.testing.assert_array_equal(*tables)


@pytest.mark.parametrize(
    ("size", "search"),
    [(20.0, {"max_nn": 12}), pytest.param(17.3, {"radius": 1.0, "max_nn": None}, marks=pytest.mark.slow)],
)
def test_features_of_tiles_match_one_machine(files, tmp_path, size, search):
    names = ["linearity", "planarity", "sphericity", "curvature", "verticality", "density"]
    result, plan = tiled(files, [{"step": "features", "names": names} | search], tmp_path / "job", size=size)
    assert_same(result, loom.compute_eigen_features(read_cloud(files, np.array(plan["origin"])), **search), *names)
    assert "omnivariance" not in result.attributes


@pytest.mark.parametrize("size", SIZES)
def test_thinned_tiles_match_one_machine(files, tmp_path, size):
    steps = [{"step": "thin", "spacing": 0.9}, {"step": "estimate_normals", "max_nn": 8}]
    result, plan = tiled(files, steps, tmp_path / "job", size=size)
    cloud = read_cloud(files, np.array(plan["origin"])).thin(0.9)
    assert len(cloud) < 3000
    expected = cloud.estimate_normals(max_nn=8).orient_normals_to_align_with_direction()
    np.testing.assert_array_equal(rows_of(result), rows_of(expected))


def test_names_of_features_are_checked(files, tmp_path):
    with pytest.raises(ValueError, match=r"^steps:"):
        loom.tiling.plan_tiles(files, [{"step": "features", "names": ["planar"]}], tmp_path / "job")
    with pytest.raises(ValueError, match="names:"):
        loom.tiling.plan_tiles(files, [{"step": "features", "names": []}], tmp_path / "job")


@pytest.fixture(scope="module")
def second_epoch(tmp_path_factory):
    """A second epoch of the survey, shifted, in files of another order."""
    folder = tmp_path_factory.mktemp("second_epoch")
    table = read_las(survey(folder, files=3, seed=5)[0])
    table.points = np.round((table.points + np.array([7.0, 1.0, 0.3])) / 0.05) * 0.05
    write_las(folder / "part9.laz", table, scale=1e-7, offset=CORNER)
    (folder / "part0.laz").unlink()
    return folder


def epoch_of(folder, plan):
    return read_cloud(sorted(folder.iterdir()), np.array(plan["origin"]))


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
def test_distances_to_another_epoch_match_one_machine(files, second_epoch, tmp_path, size):
    steps = [{"step": "distance", "other": second_epoch, "max_distance": 0.5}]
    result, plan = tiled(files, steps, tmp_path / "job", size=size)
    expected = read_cloud(files, np.array(plan["origin"]))
    distances = np.asarray(expected.compute_point_cloud_distance(epoch_of(second_epoch, plan)))
    assert 0.1 < (distances > 0.5).mean() < 0.9
    expected["distance"] = np.where(distances <= 0.5, distances, np.nan).astype(np.float32)
    assert_same(result, expected, "distance")


M3C2 = {"cylinder_radius": 0.8, "max_distance": 1.5, "registration_error": 0.01}
ATTRIBUTES = ("m3c2_distance", "level_of_detection", "significant", "points_before", "points_after")


def changed(cloud, cores, other, **options):
    result = loom.m3c2(cloud, other, core_points=cores, **options)
    cores = cores.copy()
    values = (result.distances, result.level_of_detection, result.is_significant, *result.counts.T)
    for name, value in zip(ATTRIBUTES, values, strict=True):
        cores[name] = np.asarray(value).astype(np.float32)
    return cores, result


@pytest.mark.parametrize("size", SIZES)
def test_m3c2_of_tiles_matches_one_machine(files, second_epoch, tmp_path, size):
    steps = [{"step": "m3c2", "other": str(second_epoch), "normal_radii": [1.0, 2.2], **M3C2}]
    actual, plan = tiled(files, steps, tmp_path / "job", size=size)
    cloud = read_cloud(files, np.array(plan["origin"]))
    expected, result = changed(cloud, cloud, epoch_of(second_epoch, plan), normal_radii=[1.0, 2.2], **M3C2)
    assert 0.02 < result.is_significant.mean() < 0.9 and (result.scales == 1.0).any() and (result.scales == 2.2).any()
    assert_same(actual, expected, *ATTRIBUTES)


def test_m3c2_at_thinned_core_points_after_another_step(files, second_epoch, tmp_path):
    steps = [
        {"step": "voxel_down_sample", "voxel_size": 0.3},
        {"step": "m3c2", "other": [second_epoch], "direction": [0, 0, 1], "core_spacing": 2.5, **M3C2},
    ]
    result, plan = tiled(files, steps, tmp_path / "job", size=30.0)
    cloud = in_memory(read_cloud(files, np.array(plan["origin"])), steps[:1], plan["voxel_low"])
    expected, _ = changed(cloud, cloud.thin(2.5), epoch_of(second_epoch, plan), directions=[0, 0, 1], **M3C2)
    assert len(expected) < 600
    assert_same(result, expected, *ATTRIBUTES)


def test_epochs_in_copc_files_are_read_by_windows(files, second_epoch, tmp_path):
    other = tmp_path / "later.copc.laz"
    loom.write_point_cloud(other, loom.read_point_cloud(sorted(second_epoch.iterdir())[0]), scale=1e-6)
    steps = [{"step": "distance", "other": other, "max_distance": 2.0}]
    result, plan = tiled(files, steps, tmp_path / "job", size=30.0)
    expected = read_cloud(files, np.array(plan["origin"]))
    distances = np.asarray(expected.compute_point_cloud_distance(read_cloud([other], np.array(plan["origin"]))))
    expected["distance"] = np.where(distances <= 2.0, distances, np.nan).astype(np.float32)
    assert_same(result, expected, "distance")


def test_an_epoch_that_cannot_be_compared_is_named(files, second_epoch, tmp_path):
    def plan(number=0, **params):
        steps = [{"step": "distance", "max_distance": 1.0} | params]
        loom.tiling.plan_tiles(files, steps, tmp_path / f"job{number}")

    for other, expected in [({}, "'other'"), ({"other": 3}, "other"), ({"other": tmp_path / "gone.laz"}, "gone")]:
        with pytest.raises((ValueError, loom.FileError), match=expected):
            plan(**other)
    table = read_las(files[0])
    table.points = table.points + 1000.0
    write_las(tmp_path / "far.laz", table, scale=1e-3)
    with pytest.raises(loom.FileError, match=r"/far\.laz:"):
        plan(other=tmp_path / "far.laz")
    plan(1, other=second_epoch)
    with pytest.raises(loom.FileError, match=r"part1\.laz"):
        table.points = table.points - 1000.0
        write_las(tmp_path / "far2.laz", table, scale=1e-3)
        plan(1, other=tmp_path / "far2.laz")


def test_an_epoch_of_another_coordinate_system_is_named(files, tmp_path):
    laspy, pyproj = pytest.importorskip("laspy"), pytest.importorskip("pyproj")
    other, content = tmp_path / "later.laz", laspy.read(files[0])
    content.header.add_crs(pyproj.CRS.from_epsg(25832))
    content.write(other)
    with pytest.raises(loom.FileError, match=r"/later\.laz:.*part0.*ETRS89"):
        loom.tiling.plan_tiles(files, [{"step": "distance", "other": other, "max_distance": 1.0}], tmp_path / "job")


def test_an_epoch_that_has_changed_is_rejected(files, tmp_path):
    other = tmp_path / "later.laz"
    write_las(other, read_las(files[0]), scale=1e-3)
    loom.tiling.plan_tiles(files, [{"step": "distance", "other": other, "max_distance": 1.0}], tmp_path / "job")
    write_las(other, read_las(files[1]), scale=1e-3)
    with pytest.raises(loom.FileError, match=r"/later\.laz:"):
        loom.tiling.run_tiles(tmp_path / "job")


@pytest.mark.parametrize("size", [60.0, pytest.param(23.7, marks=pytest.mark.slow)])
def test_the_change_of_a_real_slope_matches_one_machine(terrain, tmp_path, size):
    points = terrain[(np.abs(terrain[:, :2] - np.median(terrain[:, :2], axis=0)) < 60).all(axis=1)]
    second_epoch = points[1::2].copy()
    second_epoch[second_epoch[:, 0] > np.median(second_epoch[:, 0]), 2] -= 0.5
    paths = [tmp_path / "before.laz", tmp_path / "after.laz"]
    for path, rows in zip(paths, (points[::2], second_epoch), strict=True):
        write_las(path, PointTable(rows, attributes={"gps_time": np.arange(len(rows)) * 1.0}), scale=1e-4)
    params = {"normal_radii": [4.0, 8.0], "cylinder_radius": 4.0, "max_distance": 6.0}
    steps = [{"step": "m3c2", "other": paths[1], **params}, {"step": "features", "radius": 6.0, "max_nn": None}]
    actual, plan = tiled(paths[:1], steps, tmp_path / "job", size=size)
    cloud, other = (read_cloud([path], np.array(plan["origin"])) for path in paths)
    expected, result = changed(cloud, cloud, other, **params)
    assert 0.1 < result.is_significant.mean() < 0.9
    shapes = loom.compute_eigen_features(expected, radius=6.0, max_nn=None)
    assert_same(actual, shapes, *ATTRIBUTES, "linearity", "verticality", "density")


def test_an_epoch_may_have_another_format_than_las(files, second_epoch, tmp_path):
    """Points in PLY files, relative to another corner: the same distances within float32 precision."""
    first = read_cloud(files, CORNER)
    loom.write_point_cloud(tmp_path / "first.ply", loom.PointCloud(first.points))
    loom.write_point_cloud(tmp_path / "later.ply", loom.PointCloud(epoch_of(second_epoch, {"origin": CORNER}).points))
    step = {"step": "distance", "max_distance": 0.5}
    expected = np.asarray(first.compute_point_cloud_distance(epoch_of(second_epoch, {"origin": CORNER})))
    job, steps = tmp_path / "job", [step | {"other": str(tmp_path / "later.ply")}]
    for _ in range(2):  # the same plan
        loom.tiling.plan_tiles(tmp_path / "first.ply", steps, job, size=30.0)
    assert loom.tiling.run_tiles(job).is_finished
    result = np.sort(np.asarray(loom.read_point_cloud(loom.tiling.finish_tiles(job))["distance"]))
    np.testing.assert_allclose(result, np.sort(np.where(expected <= 0.5, expected, np.nan)), atol=2e-4)
    assert np.isfinite(result).mean() > 0.1
