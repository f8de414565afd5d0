"""Boxes of detected planes: cartons on a floor, unobserved faces, invalid input; and checks of fitted shapes."""

from dataclasses import replace

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import float32
from pointloom.kernels.memory import download, upload
from pointloom.kernels.segmentation.shape_alternatives import Band, count_band
from pointloom.kernels.segmentation.shape_fit import frame_of
from pointloom.kernels.segmentation.shape_models import PLANE
from pointloom.kernels.segmentation.shape_search import DetectedShape
from pointloom.pcd.segmentation import limits_of, search_of

from .made_shapes import made_shape

UTM = np.array([500_000.0, 5_400_000.0, 300.0])


def face(rng, count, fixed, at, *sides):
    """Points of a rectangle across an axis, within the bounds along the other axes."""
    points = np.zeros((count, 3))
    points[:, fixed] = at
    for axis, (low, high) in zip([k for k in range(3) if k != fixed], sides, strict=True):
        points[:, axis] = low + (high - low) * rng.random(count)
    return points


def boxes_of(points, device, rng, rotation=None, noise=0.001):
    moved = (points + noise * rng.normal(size=points.shape)) @ (np.eye(3) if rotation is None else rotation).T + UTM
    cloud = loom.PointCloud(moved, device=device).estimate_normals(max_nn=30)
    detection = loom.detect_shapes(cloud, 0.004, 25, kinds="plane", min_support=300, cluster_epsilon=0.06)
    return loom.find_boxes(cloud, detection, 0.016), detection


def test_cartons_on_a_floor_are_boxes_without_it(device):
    rng = np.random.default_rng(4)
    small, large = ((0, 0.4), (0, 0.3), (0, 0.2)), ((0.6, 1.2), (0.5, 0.9), (0, 0.5))
    parts = [face(rng, 5000, 2, 0.0, (-0.5, 1.5), (-0.5, 1.5))]
    for x, y, z in (small, large):
        parts += [face(rng, 1500, 2, z[1], x, y), face(rng, 1200, 0, x[0], y, z), face(rng, 1200, 1, y[0], x, z)]
    parts.append(face(rng, 1200, 0, 1.2, large[1], large[2]))
    rotation = np.linalg.qr(rng.normal(size=(3, 3)))[0]
    rotation[:, 0] *= np.sign(np.linalg.det(rotation))
    boxes, detection = boxes_of(np.vstack(parts), device, rng, rotation)
    assert len(detection.shapes) == 8 and [int((box.faces >= 0).sum()) for box in boxes] == [4, 3]
    for box, (x, y, z) in zip(boxes, (large, small), strict=True):
        sides = np.array([x, y, z])
        assert box.reliable, box
        np.testing.assert_allclose(np.sort(box.size), np.sort(np.ptp(sides, axis=1)), atol=0.008)
        np.testing.assert_allclose(box.center, rotation @ sides.mean(axis=1) + UTM, atol=0.005)
        np.testing.assert_allclose(box.axes @ box.axes.T, np.eye(3), atol=1e-12)
        assert np.linalg.det(box.axes) > 0
        mesh = loom.TriangleMesh(*box.to_mesh())
        assert mesh.get_volume() == pytest.approx(np.prod(box.size), rel=1e-4)
        assert box.support == sum(detection.shapes[k].support for k in box.faces.ravel() if k >= 0)


def test_unobserved_length_of_two_faces_is_reported(device):
    rng = np.random.default_rng(5)
    top, front = face(rng, 1500, 2, 0.2, (0, 0.4), (0, 0.3)), face(rng, 1500, 1, 0.0, (0, 0.4), (0, 0.2))
    (box,), _ = boxes_of(np.vstack([top, front]), device, rng)
    assert not box.reliable and [reason.split(":")[0] for reason in box.warnings] == ["size open"]
    np.testing.assert_allclose(np.sort(box.size), [0.2, 0.3, 0.4], atol=0.008)
    assert box.to_dict()["warnings"] == list(box.warnings) and str(box).startswith("box: ")


def test_crossing_tilted_or_separate_planes_form_no_box(device):
    rng = np.random.default_rng(6)
    floor = face(rng, 2000, 2, 0.0, (-1, 1), (0, 1))
    across, away = face(rng, 1500, 0, 0.0, (0, 1), (-0.5, 0.5)), face(rng, 1500, 0, 1.3, (0, 1), (0.3, 1))
    leaning = face(rng, 1500, 0, 1.0, (0, 1), (0, 1))
    leaning[:, 0] += 0.3 * leaning[:, 2]
    for other in (across, away, leaning):
        assert boxes_of(np.vstack([floor, other]), device, rng)[0] == []


def test_invalid_detections_are_rejected(device, rng):
    cloud = loom.PointCloud(rng.random((300, 3)), device=device).estimate_normals()
    detection = loom.detect_shapes(cloud, 0.01, num_iterations=100)
    assert loom.find_boxes(cloud, detection) == []
    with pytest.raises(TypeError, match="shapes:"):
        loom.find_boxes(cloud, 3)
    with pytest.raises(ValueError, match="shapes:"):
        loom.find_boxes(loom.PointCloud(np.eye(3)[:2], device=device), detection)
    with pytest.raises(ValueError, match="angle_threshold_deg:"):
        loom.find_boxes(cloud, detection, angle_threshold_deg=60)


@pytest.mark.parametrize(
    ("kind", "fitted_kind", "warning"),
    [
        ("cylinder", "sphere", "runs on"),
        ("sphere", "cone", "runs on"),
        ("torus", "cylinder", "other kind: a torus fits better"),
        ("cylinder", "cone", "other kind: a cylinder fits as well"),
    ],
)
def test_shape_fitted_as_another_kind_is_unreliable(device, kind, fitted_kind, warning):
    points, _, _ = made_shape(kind, 3000, np.random.default_rng(100), 0.004, arc=0.25 if fitted_kind == "cone" else 1.0)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    shape, _ = cloud.segment_shape(fitted_kind, 0.012, 25, num_iterations=2000)
    assert any(reason.startswith(warning) for reason in shape.warnings), shape


def test_bent_strip_fitted_as_a_plane_warns_of_a_cylinder(device):
    points, _, _ = made_shape("cylinder", 3000, np.random.default_rng(100), 0.004, arc=0.1)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    (plane,) = loom.detect_shapes(cloud, 0.012, 25, kinds="plane", min_support=1000).shapes
    assert plane.kind == "plane" and not plane.reliable
    assert any("other kind" in reason and "fits better" in reason for reason in plane.warnings), plane


def test_points_beside_a_plane_are_counted_within_its_box_by_distance_and_by_normal(device, rng):
    heights = np.repeat([0.0, 0.015, 0.029, 0.04], 100)
    points = np.vstack([np.column_stack([rng.random((400, 2)), heights]), [[5.0, 5.0, 0.0]] * 3])
    normals = np.tile([0.0, 0.0, 1.0], (403, 1))
    normals[:400:4] = [1.0, 0.0, 0.0]
    search, _ = search_of(loom.PointCloud(points, normals=normals, device=device), limits_of(0.01, 20.0, 0.0, None))
    plane = np.concatenate([-search.center, [0.0, 0.0, 1.0, 1.0, 1.0]])
    detected = DetectedShape(PLANE, replace(search.fitter.fit(PLANE, plane, search.rows), shape=plane), search.rows)
    frame = frame_of(np.array([0.0, 0.0, 1.0]))
    ends = np.array([[0.0, 0.0, 0.0], [1.0, 1.0, 0.0]]) @ frame.T
    box = upload(np.concatenate([ends.min(axis=0), ends.max(axis=0)]).astype(np.float32), float32, search.device)
    band = Band(*download(count_band(search, detected, box, 0.01, 0.9)).tolist())
    assert band == Band(on=100, beside=200, on_facing=75, beside_facing=150)
