"""Picking: a click selects the front point near the pixel, by its exact index, at any coordinates."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.memory import download
from pointloom.visualization.render.view import View, fit_view
from pointloom.visualization.viewer.tools.clip_planes import Clip, hidden_points
from pointloom.visualization.viewer.tools.picking import (
    Target,
    coordinate_text,
    describe_point,
    pick,
    pick_point,
    project,
    ray_through,
)

UTM = np.array([412_345.0, 5_412_345.0, 300.0])
FRONT = View(loom.PinholeCameraIntrinsic(641, 481, 500.0, 500.0, 320.0, 240.0), np.eye(4))  # along z, from the origin


def grid(side=40, spacing=0.05):
    """A tilted surface with points some ten pixels apart in a fitted view."""
    x, y = (a.ravel() * spacing for a in np.mgrid[:side, :side].astype(float))
    return np.column_stack([x, y, 0.1 * np.sin(2 * x) * np.cos(3 * y)])


def sphere(count=3000):
    z = 1 - (2 * np.arange(count) + 1) / count
    angle = np.pi * (1 + 5**0.5) * np.arange(count)
    return np.column_stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z])


def oracle(points, view, x, y, radius, hidden=None):
    """The same rule in NumPy, for one point at a time in float64."""
    q = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    camera = view.intrinsic
    with np.errstate(all="ignore"):
        u, v = (camera.fx * q[:, 0] / q[:, 2] + camera.cx, camera.fy * q[:, 1] / q[:, 2] + camera.cy)
        square = (u - x) ** 2 + (v - y) ** 2
    near = np.isfinite(points).all(axis=1) & (q[:, 2] > 0) & (square <= radius**2)
    near &= np.ones(len(points), bool) if hidden is None else ~hidden
    if not near.any():
        return None
    foremost = q[near, 2].min()
    cost = square + ((q[:, 2] - foremost) * camera.fx / foremost / 10) ** 2
    return int(np.flatnonzero(near)[cost[near].argmin()])


@pytest.mark.parametrize(
    ("shift", "scale"), [(UTM, 1.0), (np.zeros(3), 1e-4), (UTM, 1e4)], ids=["UTM", "small", "large"]
)
def test_a_click_on_a_point_picks_that_point(device, shift, scale):
    points = grid() * scale + shift
    cloud, view = loom.PointCloud(points, device=device), fit_view(points, width=640, height=480)
    for index in range(0, len(points), 97):
        x, y, _ = project(view, points[index])
        assert pick_point(cloud, view, x, y) == index
        assert pick_point(cloud, view, x + 1.0, y - 1.0) == index


def test_the_choice_is_that_of_the_rule_written_in_numpy(device, rng):
    points = np.vstack([sphere(), grid(), rng.normal(size=(3000, 3))])
    hidden = rng.random(len(points)) < 0.3
    cloud, view = loom.PointCloud(points, device=device), fit_view(points, width=640, height=480)
    stored = loom.PointCloud(points).points
    marks = cloud.copy()
    marks["hidden"] = hidden.astype(np.uint8)
    n_hits = 0
    for x, y in rng.uniform((160, 120), (480, 360), (40, 2)):
        expected = oracle(stored, view, x, y, 6.0)
        assert pick_point(cloud, view, x, y) == expected
        assert pick_point(cloud, view, x, y, hidden=marks.array("hidden")) == oracle(stored, view, x, y, 6.0, hidden)
        n_hits += expected is not None
    assert n_hits > 20


def test_points_behind_the_surface_are_not_picked_through_its_gaps(device):
    points = sphere()
    cloud, view = loom.PointCloud(points, device=device), fit_view(points, width=640, height=480)
    eye = view.T_world_camera[:3, 3]
    away = eye / np.linalg.norm(eye)
    for index in np.flatnonzero(points @ away < -0.5)[::50]:  # on the far side: a click there selects the near one
        x, y, _ = project(view, points[index])
        met = pick_point(cloud, view, x, y, radius=12.0)
        assert met is not None and points[met] @ away > 0.3


def test_nothing_is_picked_beyond_the_radius(device):
    cloud = loom.PointCloud([[0, 0, 2.0]], device=device)
    assert pick_point(cloud, FRONT, 320, 240) == 0
    assert pick_point(cloud, FRONT, 326, 240) == 0
    assert pick_point(cloud, FRONT, 326.01, 240) is None
    assert pick_point(cloud, FRONT, 340, 240, radius=20) == 0
    assert pick_point(loom.PointCloud(device=device), FRONT, 320, 240) is None


def test_non_finite_points_and_those_behind_the_camera_are_not_picked(device):
    points = [[np.nan, 0, 1], [0, 0, -1], [0, 0, 0], [0, np.inf, 1], [0, 0, 3]]
    assert pick_point(loom.PointCloud(points, device=device), FRONT, 320, 240) == 4
    assert pick_point(loom.PointCloud(points[:4], device=device), FRONT, 320, 240) is None


def test_of_coincident_points_the_first_is_picked(device):
    assert pick_point(loom.PointCloud([[0, 0, 2]] * 1000, device=device), FRONT, 321, 240) == 0


def test_a_pose_moves_the_picked_point(device):
    points = grid()
    pose = np.array([[0, -1, 0, 5], [1, 0, 0, -3], [0, 0, 1, 2], [0, 0, 0, 1.0]])
    moved = points @ pose[:3, :3].T + pose[:3, 3]
    cloud, view = loom.PointCloud(points, device=device), fit_view(moved, width=640, height=480)
    for index in (0, 777, 1599):
        x, y, _ = project(view, moved[index])
        assert pick_point(cloud, view, x, y, pose=pose) == index
        hit = pick([Target("cloud", cloud, pose=pose)], view, x, y)
        np.testing.assert_allclose(hit.point, moved[index], atol=1e-6)


def test_the_front_cloud_or_mesh_is_picked(device):
    near = loom.PointCloud([[0.0, 0, 2]], device=device)
    far = loom.PointCloud([[0.0, 0, 3], [0.001, 0, 4]], device=device)
    wall = loom.RaycastingScene(device=device)
    wall.add_triangles(loom.TriangleMesh([[-1, -1, 2.5], [1, -1, 2.5], [0, 1, 2.5]], [[0, 1, 2]], device=device))
    targets = [Target("far", far), Target("wall", scene=wall), Target("near", near)]
    assert (pick(targets, FRONT, 320, 240).name, pick(targets[:2], FRONT, 320, 240).name) == ("near", "wall")
    met = pick(targets[:2], FRONT, 330, 240)
    assert met.index is None and met.triangle == 0
    np.testing.assert_allclose(met.point, [10 / 500 * 2.5, 0, 2.5], atol=1e-6)
    assert pick(targets[:1], FRONT, 320, 240).index == 0
    assert pick([], FRONT, 320, 240) is None


def test_points_hidden_by_clip_planes_are_not_picked(device):
    cloud = loom.PointCloud([[0, 0, 2.0], [0, 0, 3.0], [0, 0, 4.0]], device=device)
    assert pick_point(cloud, FRONT, 320, 240, hidden=hidden_points(cloud, Clip(low=[-1, -1, 2.5]))) == 1
    plane = Clip(normal=[0, 0, 2], offset=3.5)
    assert pick_point(cloud, FRONT, 320, 240, hidden=hidden_points(cloud, plane)) == 2
    shift = np.eye(4)
    shift[2, 3] = 1.0
    assert pick_point(cloud, FRONT, 320, 240, pose=shift, hidden=hidden_points(cloud, plane, pose=shift)) == 1


def test_points_outside_a_box_or_not_finite_are_hidden(device):
    points = [[0, 0, 2.0], [0, 0, 3.0], [0, 0, 4.0], [np.nan, 0, 3.0], [0.5, 0, 3.0], [0, 2, 3.0]]
    hidden = hidden_points(loom.PointCloud(points, device=device), Clip(low=[-1, -1, 2.5], high=[1, 1, 3.5]))
    assert download(hidden).tolist() == [1, 0, 1, 1, 0, 1]


def test_the_ray_through_a_pixel_hits_its_point():
    view = fit_view(grid() + UTM, width=640, height=480)
    position = grid()[123] + UTM
    x, y, depth = project(view, position)
    eye, ray = ray_through(view, x, y)
    np.testing.assert_allclose(eye + depth * ray, position, atol=1e-6)
    assert np.isnan(project(view, eye - ray)[0])


@pytest.mark.parametrize(
    ("change", "error", "words"),
    [
        ({"cloud": np.zeros((3, 3))}, TypeError, "cloud"),
        ({"view": "front"}, TypeError, "view: expected a View"),
        ({"x": np.nan}, ValueError, "x"),
        ({"y": "left"}, TypeError, "y"),
        ({"radius": 0}, ValueError, "radius"),
        ({"pose": np.eye(3)}, ValueError, "pose"),
    ],
)
def test_invalid_arguments_are_rejected_by_name(change, error, words):
    given = {"cloud": loom.PointCloud([[0, 0, 2.0]]), "view": FRONT, "x": 320, "y": 240} | change
    with pytest.raises(error, match=words):
        pick_point(**given)


def test_all_attributes_of_a_point_are_reported():
    points, values = np.array([[0.1, 0.25, -3]]) + UTM, {"label": np.array([7], np.int32), "wind": [[0.5, 2.0]]}
    cloud = loom.PointCloud(points, colors=[[1, 0.5, 0]], normals=[[0, 0, 1]], **values)
    rows = dict(describe_point(cloud, 0))
    assert rows["index"] == "0" and rows["color"] == "255 128 0" and rows["normal"] == "0.0000 0.0000 1.0000"
    assert rows["label"] == "7" and rows["wind"] == "0.5 2"
    assert [float(rows[axis]) for axis in "xyz"] == pytest.approx([412_345.1, 5_412_345.25, 297.0], abs=1e-6)
    assert dict(describe_point(cloud, 0, np.array([1.0, 2.0, 3.0])))["y"] == "2"
    with pytest.raises(IndexError):
        describe_point(cloud, 1)


def test_coordinates_have_the_digits_that_they_have():
    assert coordinate_text(0.1, 7e-9) == "0.1"
    assert coordinate_text(float(np.float32(0.1)), 7e-9) == "0.1"
    assert coordinate_text(5_412_345.25, 4e-6) == "5412345.25"
    assert coordinate_text(-0.0) == "0" and coordinate_text(np.nan) == "nan" and coordinate_text(-np.inf) == "-inf"
    assert float(coordinate_text(1.25e-9, 1e-16)) == 1.25e-9 and float(coordinate_text(3e20, 1e13)) == 3e20
