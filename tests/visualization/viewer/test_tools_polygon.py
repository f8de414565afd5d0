"""A polygon drawn on the screen selects the visible points inside it, and Open3D crops the same from the saved file."""

import json
import tempfile
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.visualization.render.view import View, fit_view
from pointloom.visualization.viewer.tools.picking import project
from pointloom.visualization.viewer.tools.polygon_crop import (
    indices_in_volume,
    looks_along_axis,
    nearest_axis,
    polygon_to_volume,
    seen_inside,
    view_along,
)

UTM = np.array([412_345.0, 5_412_345.0, 300.0])
STAR = np.array([[0, -170], [60, -40], [190, -30], [80, 60], [120, 190], [0, 100], [-120, 190], [-80, 60], [-190, -20]])
MIDDLE = np.array([449.5, 299.5])
OFFSETS = {"here": np.zeros(3), "UTM": UTM}


def scene(rng, scale=1.0, shift=0.0):
    return rng.uniform((-2, -1, 0), (2, 1, 1.5), (6000, 3)) * scale + shift


def looking(points, axis, direction=(-0.65, 0.7, -0.75)):
    """The view along an axis onto points, and a star around the image center."""
    view = view_along(fit_view(points, width=900, height=600, direction=direction), points.min(0), points.max(0), axis)
    return view, STAR + MIDDLE


def contains(polygon, u, v):
    """The even-odd rule in NumPy, for points off the edges."""
    inside = np.zeros(len(u), bool)
    for (au, av), (bu, bv) in zip(polygon, np.roll(polygon, -1, axis=0), strict=True):
        crosses = (av < v) != (bv < v)
        with np.errstate(all="ignore"):
            inside ^= crosses & (au + (v - av) / (bv - av) * (bu - au) < u)
    return inside


def seen_at(view, points):
    q = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    camera = view.intrinsic
    return camera.fx * q[:, 0] / q[:, 2] + camera.cx, camera.fy * q[:, 1] / q[:, 2] + camera.cy, q[:, 2]


def open3ds_crop(o3d, saved, points):
    """The indices that Open3D's crop by a saved file selects."""
    with tempfile.TemporaryDirectory() as folder:
        Path(f"{folder}/cropped.json").write_text(saved)
        volume = o3d.visualization.read_selection_polygon_volume(f"{folder}/cropped.json")
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(points)))
    return np.array(volume.crop_in_polygon(cloud), np.int32)


@pytest.mark.parametrize(("axis", "location"), [("X", "here"), ("Y", "UTM"), ("Z", "UTM")])
def test_the_saved_file_crops_the_same_points_in_open3d(device, rng, tmp_path, axis, location, oracle):
    points = scene(rng, shift=OFFSETS[location])
    view, star = looking(points, axis)
    cloud = loom.PointCloud(points, device=device)
    volume = polygon_to_volume(view, star, cloud)
    volume.to_json(tmp_path / "cropped.json")
    selected = indices_in_volume(cloud, volume)
    saved = (tmp_path / "cropped.json").read_text()
    expected = oracle(
        f"visualization/polygon_crop/{axis.lower()}_{location.lower()}", open3ds_crop, saved, cloud.points
    )
    assert expected.tolist() == selected.tolist() and len(selected) > 300
    read = loom.SelectionPolygonVolume.from_json(tmp_path / "cropped.json")
    np.testing.assert_array_equal(indices_in_volume(cloud, read), selected)


@pytest.mark.parametrize(("axis", "scale"), [("X", 1e-3), ("Y", 1.0), ("Z", 1e5)])
def test_the_volume_contains_the_points_inside_the_polygon_to_a_pixel(rng, axis, scale):
    points = scene(rng, scale)
    cloud = loom.PointCloud(points)
    view, star = looking(cloud.points, axis)
    u, v, _ = seen_at(view, cloud.points)
    inside = contains(star, u, v)
    selected = np.zeros(len(points), bool)
    selected[indices_in_volume(cloud, polygon_to_volume(view, star, cloud))] = True
    for index in np.flatnonzero(selected != inside):  # only points seen within a pixel of the line may differ
        sides = [contains(star, np.array([u[index] + du]), np.array([v[index] + dv]))[0] for du, dv in
                 ((1, 0), (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1, -1), (-1, 1))]  # fmt: skip
        assert len(set(sides)) == 2
    assert (selected != inside).mean() < 0.003 and 0.05 < inside.mean() < 0.9


def test_the_file_is_like_open3ds_own(rng, tmp_path):
    points = scene(rng)
    view, star = looking(points, "Y")
    polygon_to_volume(view, star, points).to_json(tmp_path / "cropped.json")
    content = json.loads((tmp_path / "cropped.json").read_text())
    assert content["class_name"] == "SelectionPolygonVolume" and content["orthogonal_axis"] == "Y"
    assert (content["version_major"], content["version_minor"]) == (1, 0)
    assert len(content["bounding_polygon"]) == len(star) and not np.array(content["bounding_polygon"])[:, 1].any()
    low, high = points[:, 1].min(), points[:, 1].max()
    assert content["axis_min"] == pytest.approx(2 * low - high) and content["axis_max"] == pytest.approx(2 * high - low)


def test_the_view_along_an_axis_shows_all_and_keeps_ones_side_and_up(rng):
    points = scene(rng, shift=UTM)
    for direction, axis, sign in (((-1, 0.2, -0.3), "X", -1), ((0.1, 1, -0.3), "Y", 1), ((0.1, 0.2, -1), "Z", -1)):
        before = fit_view(points, direction=direction, width=900, height=600)
        assert nearest_axis(before) == (axis, sign) and not looks_along_axis(before)
        view = view_along(before, points.min(0), points.max(0))
        assert nearest_axis(view) == (axis, sign) and looks_along_axis(view)
        u, v, depth = seen_at(view, points)
        assert min(u.min(), v.min(), depth.min()) > 0 and u.max() < 899 and v.max() < 599
        assert np.ptp(depth) < 0.01 * depth.min()
        assert view.T_world_camera[:3, 1] @ before.T_world_camera[:3, 1] > 0.5
        assert np.linalg.det(view.T_world_camera[:3, :3]) == pytest.approx(1)
    assert nearest_axis(view_along(before, points.min(0), points.max(0), "X"))[0] == "X"


def test_in_a_free_view_the_points_seen_inside_are_taken(device, rng):
    points = np.vstack([scene(rng), [[np.nan, 0, 0]]])
    view = fit_view(points, width=900, height=600)
    star = STAR + MIDDLE
    cloud = loom.PointCloud(points, device=device)
    u, v, depth = seen_at(view, cloud.points)
    expected = np.flatnonzero(contains(star, u, v) & (depth > 0))
    assert seen_inside(cloud, view, star).tolist() == expected.tolist() and len(expected) > 300
    pose = np.array([[0, -1, 0, 5], [1, 0, 0, -3], [0, 0, 1, 2], [0, 0, 0, 1.0]])
    moved = View(view.intrinsic, pose @ view.T_world_camera)
    assert seen_inside(cloud, moved, star, pose=pose).tolist() == expected.tolist()


def test_nothing_behind_the_camera_is_seen_inside(device):
    view = fit_view([[0, 0, 0], [1, 1, 1]], width=320, height=240)
    behind = view.T_world_camera[:3, 3] - 2 * view.T_world_camera[:3, 2]
    frame = [[-1e6, -1e6], [1e6, -1e6], [1e6, 1e6], [-1e6, 1e6]]
    assert seen_inside(loom.PointCloud([behind, [0, 0, 0]], device=device), view, frame).tolist() == [1]
    assert seen_inside(loom.PointCloud(device=device), view, frame).tolist() == []


def test_a_pose_puts_the_cloud_where_the_polygon_is(rng):
    points = scene(rng)
    pose = np.eye(4)
    pose[:3, 3] = 10, 20, 30
    view, star = looking(points + pose[:3, 3], "Z")
    cloud = loom.PointCloud(points)
    with_pose = indices_in_volume(cloud, polygon_to_volume(view, star, cloud, pose=pose), pose=pose)
    alone = loom.PointCloud(points + pose[:3, 3])
    assert abs(len(with_pose) - len(indices_in_volume(alone, polygon_to_volume(view, star, alone)))) <= 2


@pytest.mark.parametrize(
    ("polygon", "words"),
    [
        ([[0, 0], [1, 1]], "at least three corners"),
        ([[0, 0], [100, 100], [200, 200]], "not collinear"),
        ([[5, 5]] * 4, "not collinear"),
        ([[0, 0], [1, np.nan], [1, 0]], "polygon"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "polygon"),
    ],
)
def test_a_polygon_that_is_none_is_refused(polygon, words):
    view = fit_view([[0, 0, 0], [1, 1, 1]])
    for crop in (seen_inside, lambda cloud, view, corners: polygon_to_volume(view, corners, cloud)):
        with pytest.raises(ValueError, match=words):
            crop(loom.PointCloud([[0, 0, 0]]), view, polygon)


def test_a_rotated_view_and_a_cloud_without_points_are_rejected(rng):
    points = scene(rng)
    with pytest.raises(ValueError, match="along an axis"):
        polygon_to_volume(fit_view(points), STAR, points)
    view, star = looking(points, "Z")
    with pytest.raises(ValueError, match=r"^points:"):
        polygon_to_volume(view, star, np.full((3, 3), np.nan))


def test_the_prism_is_exact_halfway_between_the_first_and_the_last_point_seen_inside():
    view = fit_view(
        [[-3, -3, 0], [3, 3, 6]], direction=(0, 0, -1), up=(0, 1, 0), width=640, height=480
    )  # only near the camera
    points = np.array([[0, 0, 1], [0.1, 0, 2], [0, 0.1, 4], [2.9, 2.9, 0], [-2.9, -2.9, 6]])
    polygon = [[200, 120], [440, 130], [430, 350], [210, 360]]
    assert seen_inside(loom.PointCloud(points), view, polygon).tolist() == [0, 1, 2]
    beside = [[u - 175, v - 100] for u, v in polygon]
    assert seen_inside(loom.PointCloud(points), view, beside).tolist() == []
    for corners, level in ((polygon, 2.5), (beside, 3.0)):
        for corner, vertex in zip(corners, polygon_to_volume(view, corners, points).bounding_polygon, strict=True):
            np.testing.assert_allclose(project(view, [vertex[0], vertex[1], level])[:2], corner, atol=1e-6)
