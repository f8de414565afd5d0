"""Voxel down-sampling: Open3D's voxels and means, on grids of any size and position."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial import cKDTree

import pointloom as loom

from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, real
from .open3d_clouds import cloud_of


def matched(actual, expected, limit):
    """Rows of `actual` in the order of `expected`; each must be within `limit` [m] of its counterpart."""
    assert len(actual) == len(expected)
    distances, rows = cKDTree(actual).query(expected)
    assert distances.max() <= limit, distances.max()
    assert len(np.unique(rows)) == len(rows)
    return rows


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
@pytest.mark.parametrize("size", [0.02, 0.05, 0.1, 0.5, 10.0])
def test_the_fragments_voxels_and_means_are_open3ds(device, size, fragment, to_open3d, tolerances):
    cloud = loom.PointCloud(fragment.points, normals=fragment.normals, colors=fragment.colors, device=device)
    result = cloud.voxel_down_sample(size)
    expected = to_open3d(fragment.points, cloud.normals, cloud.colors).voxel_down_sample(size)
    rows = matched(result.points, np.asarray(expected.points), np.sqrt(3) * tolerances.voxel_mean)
    limit = tolerances.voxel_attribute
    np.testing.assert_allclose(result.colors[rows], np.asarray(expected.colors), rtol=0, atol=limit)
    np.testing.assert_allclose(result.normals[rows], np.asarray(expected.normals), rtol=0, atol=limit)
    if size >= 0.1:
        assert np.linalg.norm(result.normals, axis=1).min() < 0.9, "means of normals are not made unit again"


def brute_force(points, size):
    """Voxels in ascending order and the rows of each, by float64 arithmetic on the stored coordinates."""
    finite = np.flatnonzero(np.isfinite(points).all(axis=1))
    groups: dict[tuple[int, ...], list[int]] = {}
    if len(finite):
        corner = points[finite].min(axis=0) - size / 2
        for row, cell in zip(finite, np.floor((points[finite] - corner) / size).astype(np.int64), strict=True):
            groups.setdefault(tuple(cell.tolist()), []).append(int(row))
    return [groups[cell] for cell in sorted(groups)]


def test_floating_attributes_are_averaged_and_others_taken_from_the_first_point(device, rng):
    points = (rng.random((400, 3)) * 4 - 2).astype(np.float32)
    attributes = {
        "time": rng.random(400) + 1.7e9, "pair": rng.random((400, 2)).astype(np.float32),
        "half": rng.random(400).astype(np.float16), "label": rng.integers(-9, 9, 400), "flag": rng.random(400) < 0.5,
        "code": rng.integers(0, 255, (400, 2)).astype(np.uint8),
    }  # fmt: skip
    result = loom.PointCloud(points, device=device, **attributes).voxel_down_sample(1.0)
    groups = brute_force(points.astype(float), 1.0)
    assert len(result) == len(groups) < 200
    for name, values in attributes.items():
        assert result[name].dtype == values.dtype
        if values.dtype.kind == "f":
            expected = np.array([values[g].astype(float).mean(axis=0) for g in groups]).astype(values.dtype)
            actual, wanted = result[name].astype(float), expected.astype(float)
            np.testing.assert_allclose(actual, wanted, rtol=np.finfo(values.dtype).eps)
        else:
            np.testing.assert_array_equal(result[name], [values[g[0]] for g in groups])


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
def test_means_are_summed_in_double_precision(device, rng):
    """30,000 points near 9,999 m: a float32 sum would be off by meters, a mean by centimeters."""
    points = (9999 + rng.random((30_000, 3)) * 0.5).astype(np.float32).astype(np.float64)
    result = loom.PointCloud(points, device=device).voxel_down_sample(10.0)
    np.testing.assert_allclose(result.points, points.mean(axis=0)[None], rtol=6.1e-8)


@pytest.mark.parametrize("axis", range(3))
def test_an_axis_may_have_more_than_2_to_the_20_cells(device, axis, rng):
    points = rng.random((600, 3)).astype(np.float32)
    points[:, axis] = (rng.integers(0, 2**23, 600) - 2**22) / np.float32(512)
    points[1::2] = points[::2]
    cloud = loom.PointCloud(points, device=device)
    assert np.ptp(points[:, axis]) / 0.001 > 2**22
    result = cloud.voxel_down_sample(0.001)
    groups = brute_force(cloud.points, 0.001)
    assert len(result) == len(groups) <= 300
    np.testing.assert_array_equal(result.points, [cloud.points[g].mean(axis=0).astype(np.float32) for g in groups])


def open3d_voxels(o3d, points, size, *vectors):
    cloud = cloud_of(o3d, points, *vectors).voxel_down_sample(size)
    return [np.asarray(getattr(cloud, name)) for name in ("points", "normals", "colors")]


def test_voxels_of_a_made_cloud_are_open3ds_also_at_utm_coordinates(device, rng, oracle, tolerances):
    utm = np.array([501234.0, 5412345.0, 212.0])
    points = rng.random((600, 3)) * [50, 50, 5]
    vectors = {"normals": rng.normal(size=(600, 3)), "colors": rng.random((600, 3))}
    cloud = loom.PointCloud(points + utm, device=device, **vectors)
    result, centerd = cloud.voxel_down_sample(10.0), cloud.points - utm  # as stored: float32 about the origin
    expected = oracle("pcd/voxel_down_sample/uniform", open3d_voxels, centerd, 10.0, cloud.normals, cloud.colors)
    rows = matched(result.points - utm, expected[0], tolerances.position / 100)
    for name, values in zip(("normals", "colors"), expected[1:], strict=True):
        np.testing.assert_allclose(result[name][rows], values, rtol=0, atol=tolerances.voxel_attribute)


@pytest.mark.filterwarnings("ignore::pointloom.UnitWarning")  # a warning is correct for such a length
def test_a_voxel_larger_than_the_cloud_gives_its_mean(device, rng):
    points = rng.random((100, 3)).astype(np.float32)
    for size in (10.0, 1e30, 1e300):
        result = loom.PointCloud(points, device=device).voxel_down_sample(size).points
        np.testing.assert_allclose(result, points.astype(float).mean(axis=0)[None], rtol=6.1e-8)


@examples(30)
@given(
    points=clouds(INTEGERS, real(5), NOT_FINITE, st.sampled_from([900.0, 1e-20])),
    size=st.sampled_from([0.01, 0.5, 1.0, 100.0]),
)
def test_any_small_cloud_is_averaged_as_numpy_averages(device, points, size):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)), time=np.arange(len(points)) * 1.5)
    result, groups = cloud.voxel_down_sample(size), brute_force(cloud.points, size)
    assert result["row"].tolist() == [g[0] for g in groups]
    np.testing.assert_allclose(result["time"], [np.mean(g) * 1.5 for g in groups], rtol=1e-15)
    means = np.array([cloud.points[g].sum(axis=0) / len(g) for g in groups]).reshape(-1, 3)
    np.testing.assert_array_equal(result.points, means.astype(np.float32))
