"""Boxes of tensors, against float64 arithmetic."""

import copy

import numpy as np
import pytest

import pointloom.open3d as o3d

g, Tensor = o3d.t.geometry, o3d.core.Tensor
LOW, HIGH = np.array([0.0, 1, 2]), np.array([1.0, 3, 5])
R = np.array([[0.6, -0.8, 0], [0.8, 0.6, 0], [0, 0, 1]])
CENTER, EXTENT = np.array([1.0, 2, 3]), np.array([2.0, 4, 6])
POINTS = np.random.default_rng(0).random((40, 3)) * 6


@pytest.fixture
def where(device):
    return o3d.core.Device(device.upper())


@pytest.fixture(params=[np.float32, np.float64])
def aligned(request, where):
    return g.AxisAlignedBoundingBox(*(Tensor(end.astype(request.param), device=where) for end in (LOW, HIGH)))


@pytest.fixture
def turned(where):
    return g.OrientedBoundingBox(*(Tensor(part, device=where) for part in (CENTER, R, EXTENT)))


def same(tensor, values, tolerance=1e-6):
    return tensor.shape == np.shape(values) and np.abs(tensor.numpy() - values).max() < tolerance


def test_an_aligned_box_has_its_measures_in_its_type(aligned, where):
    for tensor, values in (
        (aligned.min_bound, LOW),
        (aligned.max_bound, HIGH),
        (aligned.get_center(), (LOW + HIGH) / 2),
        (aligned.get_extent(), HIGH - LOW),
        (aligned.get_half_extent(), (HIGH - LOW) / 2),
        (aligned.color, [1, 1, 1]),
    ):
        assert same(tensor, values) and tensor.dtype == aligned.dtype and tensor.device == where == aligned.device
    assert (aligned.volume(), aligned.get_max_extent(), aligned.is_empty()) == (6, 3, False)
    corners = {tuple(row) for row in aligned.get_box_points().numpy().tolist()}
    assert corners == {(x, y, z) for x in (0, 1) for y in (1, 3) for z in (2, 5)}
    inside = ((POINTS >= LOW) & (POINTS <= HIGH)).all(axis=1)
    rows = aligned.get_point_indices_within_bounding_box(Tensor(POINTS, device=where))
    assert rows.numpy().tolist() == np.flatnonzero(inside).tolist() and str(rows.dtype) == "Int64"


def test_an_aligned_box_moves_in_place(aligned):
    before = copy.copy(aligned)
    assert aligned.translate([1.0, 0, 0]) is aligned and same(aligned.min_bound, np.add(LOW, [1, 0, 0]))
    assert same(aligned.translate([0.0, 0, 0], relative=False).get_center(), [0, 0, 0])
    assert same(aligned.scale(2.0).get_extent(), 2 * (HIGH - LOW))
    assert same(aligned.clone().scale(0.5, aligned.min_bound).min_bound, aligned.min_bound.numpy())
    assert same(before.min_bound, LOW)  # the copy stayed
    union = before + g.AxisAlignedBoundingBox([-1.0, 2, 2], [0.5, 9, 3])
    assert same(union.min_bound, [-1, 1, 2]) and same(union.max_bound, [1, 9, 5])
    before.set_min_bound([0.5, 1, 2])
    before.set_max_bound([0.6, 3, 5])
    before.set_color([0.0, 0.5, 1])
    assert same(before.min_bound, [0.5, 1, 2]) and same(before.max_bound, [0.6, 3, 5])
    assert same(before.color, [0, 0.5, 1]) and same(before.clear().max_bound, [0, 0, 0]) and before.is_empty()


def test_the_constructor_sorts_corners_and_setters_reject_them():
    box = g.AxisAlignedBoundingBox([1.0, 0, 0], [0.0, 1, 1])
    assert same(box.min_bound, [0, 0, 0]) and repr(box) == "AxisAlignedBoundingBox[[0 0 0] - [1 1 1], Float64, CPU:0]"
    for name, work in (
        ("min_bound", lambda: box.set_min_bound([2.0, 0, 0])),
        ("max_bound", lambda: box.set_max_bound([1.0, 2])),
        ("color", lambda: box.set_color([2.0, 0, 0])),
        ("other", lambda: box + 1),
        ("min_bound", lambda: g.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1])),
        ("min_bound", lambda: setattr(box, "min_bound", [0.0, 0, 0])),
    ):
        with pytest.raises((ValueError, TypeError, AttributeError), match=name):
            work()


def test_boxes_of_points_contain_them(where):
    tensor = Tensor(POINTS, device=where)
    box = g.AxisAlignedBoundingBox.create_from_points(tensor)
    assert same(box.min_bound, POINTS.min(axis=0)) and same(box.max_bound, POINTS.max(axis=0)) and box.device == where
    assert g.AxisAlignedBoundingBox.create_from_points(tensor[:0]).is_empty()
    smallest, principal = (
        g.OrientedBoundingBox.create_from_points(tensor, method=method)
        for method in (g.MethodOBBCreate.MINIMAL_APPROX, g.MethodOBBCreate.PCA)
    )
    assert smallest.volume() <= principal.volume() and smallest.volume() <= box.volume()
    for fitted in (smallest, principal):
        local = (POINTS - fitted.center.numpy()) @ fitted.rotation.numpy()
        assert (np.abs(local) <= fitted.extent.numpy() / 2 + 1e-5).all()
    cloud = g.PointCloud(tensor)
    assert same(cloud.get_oriented_bounding_box().extent, smallest.extent.numpy())
    assert same(cloud.get_axis_aligned_bounding_box().min_bound, POINTS.min(axis=0))


def test_an_oriented_box_moves_in_place(turned, where):
    half = EXTENT / 2
    corners = CENTER + np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half @ R.T
    assert same(turned.get_min_bound(), corners.min(axis=0)) and same(turned.get_max_bound(), corners.max(axis=0))
    assert same(turned.get_axis_aligned_bounding_box().max_bound, corners.max(axis=0)) and turned.volume() == 48
    found = turned.get_box_points().numpy()
    assert np.abs(np.sort(found, axis=0) - np.sort(corners, axis=0)).max() < 1e-6
    inside = (np.abs((POINTS - CENTER) @ R) <= half).all(axis=1)
    rows = turned.get_point_indices_within_bounding_box(Tensor(POINTS, device=where))
    assert rows.numpy().tolist() == np.flatnonzero(inside).tolist()
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, (5, 6, 7)
    assert (
        turned.transform(T) is turned and same(turned.center, R @ CENTER + [5, 6, 7]) and same(turned.rotation, R @ R)
    )
    assert same(turned.rotate(R.T).rotation, R) and same(
        turned.rotate(R.T, [0.0, 0, 0]).center, CENTER + R.T @ [5, 6, 7]
    )
    assert same(turned.translate([1.0, 1, 1], relative=False).center, [1, 1, 1])
    assert same(turned.scale(2.0, [0.0, 0, 0]).center, [2, 2, 2]) and same(turned.extent, 2 * EXTENT)
    turned.set_center(CENTER)
    turned.set_rotation(R)
    turned.set_extent(EXTENT)
    assert same(turned.center, CENTER) and same(turned.rotation, R) and same(turned.extent, EXTENT)
    with pytest.raises(ValueError, match="extent"):
        turned.set_extent([-1.0, 0, 0])
    with pytest.raises(ValueError, match="R"):
        turned.set_rotation(2 * np.eye(3))
    assert turned.clear().is_empty() and repr(turned) == f"OrientedBoundingBox[Float64, {where}]"


def test_legacy_boxes_keep_corners_axes_and_color(aligned, turned, where):
    aligned.set_color([1.0, 0, 0])
    legacy = aligned.to_legacy()
    assert legacy.min_bound.tolist() == LOW.tolist() and legacy.color.tolist() == [1, 0, 0]
    back = g.AxisAlignedBoundingBox.from_legacy(legacy, aligned.dtype, where)
    assert same(back.max_bound, HIGH) and same(back.color, [1, 0, 0]) and back.device == where
    assert same(aligned.get_oriented_bounding_box().extent, HIGH - LOW)
    box = g.OrientedBoundingBox.from_legacy(turned.to_legacy())
    assert same(box.rotation, R) and str(box.dtype) == "Float32" and str(g.OrientedBoundingBox().dtype) == "Float32"
