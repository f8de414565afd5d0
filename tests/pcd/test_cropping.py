"""Selection by index and mask, crops by boxes, and removal of non-finite points."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import pointloom as loom

from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, real
from .full_clouds import UTM, full_cloud


def test_indices_select_in_their_order_with_repeats_and_count_from_the_end(device, rng):
    cloud = full_cloud(rng, device)
    indices = [7, -1, 7, 0, -200, 199]
    np.testing.assert_array_equal(cloud.select_by_index(indices).points, cloud.points[indices])
    for dtype in ("i1", "i8", "u1", "u8"):
        few = np.array([7, 99, 7, 0] if dtype[0] == "u" else [7, -1, 7, -9]).astype(dtype)
        np.testing.assert_array_equal(cloud.select_by_index(few)["label"], cloud["label"][few])
        rest = np.delete(np.arange(200), few.astype(int))
        np.testing.assert_array_equal(cloud.select_by_index(few, invert=True)["label"], cloud["label"][rest])
    left = np.setdiff1d(np.arange(200), np.array(indices) % 200)
    np.testing.assert_array_equal(cloud.select_by_index(indices, invert=True).points, cloud.points[left])
    assert len(cloud.select_by_index([])) == 0 and len(cloud.select_by_index([], invert=True)) == 200


def test_mask_selects_its_true_points(device, rng):
    cloud = full_cloud(rng, device)
    mask = rng.random(200) < 0.4
    np.testing.assert_array_equal(cloud.select_by_mask(mask).points, cloud.points[mask])
    np.testing.assert_array_equal(cloud.select_by_mask(list(map(bool, mask)), invert=True).points, cloud.points[~mask])
    for wrong in (mask.astype(int), mask[:5], mask[:, None], []):
        with pytest.raises(ValueError, match="mask:"):
            cloud.select_by_mask(wrong)


LOW, HIGH = np.array([-0.5, -1, 0.25]), np.array([0.5, 0.75, 1])
ROTATION = Rotation.from_euler("XYZ", (0.3, -0.5, 1.1)).as_matrix()


def boxes_of(library):
    """An axis-aligned box, the same box as an oriented one, and a rotated one, of Open3D or pointloom."""
    rotations = np.eye(3), ROTATION
    oriented = [library.OrientedBoundingBox((LOW + HIGH) / 2, rotation, HIGH - LOW) for rotation in rotations]
    return [library.AxisAlignedBoundingBox(LOW, HIGH), *oriented]


def open3d_crops(o3d, points):
    vectors = o3d.utility.Vector3dVector(points)
    return [np.array(box.get_point_indices_within_bounding_box(vectors), np.int16) for box in boxes_of(o3d.geometry)]


def test_crop_agrees_with_open3d_including_faces(device, rng, oracle):
    points = np.concatenate([rng.integers(-4, 5, (2000, 3)) / 4.0, rng.random((1000, 3)) * 2 - 1])
    cloud = loom.PointCloud(points, device=device)
    positions = cloud.points.copy()
    for box, inside in zip(boxes_of(loom), oracle("pcd/cropping/boxes", open3d_crops, positions), strict=True):
        assert 0 < len(inside) < 3000
        np.testing.assert_array_equal(cloud.crop(box).points, positions[inside])
        np.testing.assert_array_equal(cloud.crop(box, invert=True).points, np.delete(positions, inside, axis=0))
        for given_points in (positions, cloud):
            np.testing.assert_array_equal(box.get_point_indices_within_bounding_box(given_points), inside)


def test_cropping_to_a_face_typed_in_float64_keeps_the_points_on_it(device):
    points = np.array([[0.1, 0.2, 0.3], [0.1, 0.2, 0.4], [UTM[0] % 1, 0.7, 0.9]])
    for shift in (0.0, UTM):
        cloud = loom.PointCloud(points + shift, device=device)
        for point in points + shift:
            assert len(cloud.crop(loom.AxisAlignedBoundingBox(point, point))) == 1


def test_points_that_are_not_finite_are_removed_by_kind(device, rng):
    points = rng.random((300, 3)).astype(np.float32)
    points[::3, 0], points[1::7, 2], points[6, 1] = np.nan, np.inf, -np.inf
    cloud = loom.PointCloud(points, device=device, row=np.arange(300))
    for remove_nan, remove_infinite in np.ndindex(2, 2):
        bad = (np.isnan(points) & bool(remove_nan)) | (np.isinf(points) & bool(remove_infinite))
        result = cloud.remove_non_finite_points(bool(remove_nan), bool(remove_infinite))
        assert result["row"].tolist() == np.flatnonzero(~bad.any(axis=1)).tolist()
        np.testing.assert_array_equal(points[result["row"]], result.points)


@examples(30)
@given(points=clouds(INTEGERS, real(100), NOT_FINITE, st.sampled_from([5e5, 1e-20])), seed=st.integers(0, 100))
def test_any_small_cloud_is_selected_as_numpy_selects(device, points, seed):
    rng = np.random.default_rng(seed)
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    positions = cloud.points
    finite = np.isfinite(positions).all(axis=1)
    np.testing.assert_array_equal(finite, np.isfinite(points).all(axis=1))
    np.testing.assert_allclose(positions[finite], points[finite], rtol=1.2e-7, atol=0.07)  # 1e6 apart: 6.0e-8 of it
    assert cloud.remove_non_finite_points()["row"].tolist() == np.flatnonzero(finite).tolist()
    mask = rng.random(len(points)) < 0.5
    assert cloud.select_by_mask(mask)["row"].tolist() == np.flatnonzero(mask).tolist()
    low, high = np.sort(rng.uniform(-4, 4, (2, 3)), axis=0)
    inside = ((positions >= low) & (positions <= high)).all(axis=1)
    near_a_face = (np.abs(positions - low) < 0.1).any(axis=1) | (np.abs(positions - high) < 0.1).any(axis=1)
    selected = np.isin(np.arange(len(points)), cloud.crop(loom.AxisAlignedBoundingBox(low, high))["row"])
    assert (selected == inside)[~near_a_face].all()
    if finite.any():
        np.testing.assert_array_equal(cloud.get_min_bound(), positions[finite].min(axis=0))
        np.testing.assert_array_equal(cloud.get_max_bound(), positions[finite].max(axis=0))
