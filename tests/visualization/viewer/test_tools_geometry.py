"""Tools without a browser: measuring, clip planes, pairs, picking, and selection by a polygon."""

import math
import tempfile
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import DEGREE, FOOT
from pointloom.kernels.memory import download
from pointloom.visualization.render.view import View, fit_view
from pointloom.visualization.viewer.tools.clip_planes import Clip, clip_mesh, hidden_points
from pointloom.visualization.viewer.tools.correspondences import fit_pairs, register_from_pairs
from pointloom.visualization.viewer.tools.measuring import (
    angle_at,
    distance_between,
    length_text,
    measurements,
    path_length,
)
from pointloom.visualization.viewer.tools.picking import (
    Target,
    coordinate_text,
    describe_row,
    pick,
    project,
    ray_through,
)
from pointloom.visualization.viewer.tools.polygon_crop import (
    indices_in_volume,
    looks_along_axis,
    nearest_axis,
    polygon_to_volume,
    seen_inside,
    view_along,
)

UTM = np.array([412_345.0, 5_412_345.0, 300.0])
POSE = np.array([[0, -1, 0, 5], [1, 0, 0, -3], [0, 0, 1, 2], [0, 0, 0, 1.0]])


def rotation(axis, angle):
    x, y, z = np.array(axis) / np.linalg.norm(axis)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def pose_of(axis, angle, shift):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = rotation(axis, angle), shift
    return T


def wavy(side=60):
    """A surface with a unique registration."""
    x, y = (a.ravel() / side * 3 for a in np.mgrid[:side, :side].astype(float))
    return np.column_stack([x, y, 0.3 * np.sin(2.3 * x) * np.cos(1.7 * y) + 0.1 * x * y])


def test_a_distance_has_its_parts_and_its_slope():
    d = distance_between(UTM, UTM + np.array([3.0, 4, 5]))
    assert (d.dx, d.dy, d.dz) == (3, 4, 5) and d.length == pytest.approx(math.sqrt(50)) and d.slope == pytest.approx(45)
    assert distance_between([0, 0, 1], [0, 0, 0]).slope == -90
    assert distance_between([0, 0, 0], [0, 0, 0]).length == 0 and math.isnan(distance_between(UTM, UTM).slope)


def test_an_angle_is_the_same_at_any_scale():
    for scale in (1e-200, 1.0, 1e90):
        assert angle_at([scale, 0, 0], [0, 0, 0], [scale, scale, 0]) == pytest.approx(45)
    assert angle_at([1, 0, 0], [0, 0, 0], [-1, 0, 0]) == 180 and angle_at([1, 0, 0], [0, 0, 0], [3, 0, 0]) == 0
    assert math.isnan(angle_at([0, 0, 0], [0, 0, 0], [1, 0, 0]))


def test_clicks_measure_more_the_more_there_are():
    points = np.array([[0, 0, 0], [3, 0, 0], [3, 4, 0]])
    assert measurements(points[:1]) == [] and path_length(points[:1]) == 0
    two, three = dict(measurements(points[:2])), dict(measurements(points))
    assert two == {"distance": "3.0000 m", "dx": "3.0000 m", "dy": "0.0000 m", "dz": "0.0000 m", "slope": "0.00°"}
    assert three["distance"] == "4.0000 m" and three["path"] == "7.0000 m over 2 parts" and three["angle"] == "90.00°"
    feet = dict(measurements(points, FOOT))
    assert feet["distance"] == "4.0000 ft" and feet["path"] == "7.0000 ft over 2 parts" and feet["dz"] == "0.0000 ft"
    assert dict(measurements(points, DEGREE)) == {"dx": "0.0000 deg", "dy": "4.0000 deg", "dz": "0.0000"}
    assert length_text(1.5e-7) == "1.5e-07 m" and length_text(2.5e9) == "2.5e+09 m"


def test_selected_points_are_in_the_box_and_before_the_plane(rng, device):
    points = rng.uniform(-1, 1, (8000, 3)) + UTM
    low, high = UTM - np.array([0.5, np.inf, 1]), UTM + np.array([0.5, 0.2, 1])
    clip = Clip(low=low, high=high, normal=[1, 1, 0], offset=(UTM[0] + UTM[1]) / math.sqrt(2))
    p = points - UTM
    expected = (np.abs(p[:, 0]) <= 0.5) & (p[:, 1] <= 0.2) & (p[:, 0] + p[:, 1] >= 0)
    near = np.abs(p[:, 0] + p[:, 1]) < 1e-6
    assert (clip.keep(points) == expected)[~near].all() and 200 < expected.sum() < 1000
    cloud = loom.PointCloud(points, device=device)
    np.testing.assert_array_equal(hidden_points(cloud, clip).numpy() == 0, clip.keep(cloud.points))


def test_a_pose_brings_points_under_the_planes(rng):
    T = pose_of([1, 2, 3], 0.7, [5, 6, 7])
    points = rng.uniform(-1, 1, (500, 3))
    clip, cloud = Clip(low=[4.5, 5.5, 6.5], high=[9, 9, 9]), loom.PointCloud(points)
    for p, kept in ((points, clip.keeper(T)(points)), (cloud.points, hidden_points(cloud, clip, pose=T).numpy() == 0)):
        np.testing.assert_array_equal(kept, clip.keep(p @ T[:3, :3].T + T[:3, 3]))


def test_no_planes_select_all_finite_points():
    clip = Clip()
    assert not clip.cuts and hidden_points(loom.PointCloud([[0, 0, 0]]), clip) is None
    assert clip.keep([[1e30, 0, 0], [np.nan, 0, 0]]).tolist() == [True, False]
    assert Clip(normal=[0, 0, 5]).cuts and Clip(high=[0, np.inf, np.inf]).cuts


def test_a_mesh_is_cut_through_its_triangles(device):
    mesh = loom.TriangleMesh.create_box(2, 2, 2).to(device)
    cut = clip_mesh(mesh, Clip(low=[0.5, 0.5, 0.5], high=[9, 9, 9]))
    np.testing.assert_allclose(cut.vertices.min(0), 0.5, atol=1e-6)
    assert cut.get_surface_area() == pytest.approx(3 * 1.5**2, rel=1e-5)  # three whole squares less
    assert clip_mesh(mesh, Clip()) is mesh and clip_mesh(mesh, Clip(low=[-1, -1, -1])) is mesh
    assert len(clip_mesh(mesh, Clip(low=[3, 0, 0]))) == 0
    shifted = clip_mesh(mesh, Clip(low=[10.5, -9, -9]), pose=pose_of([0, 0, 1], 0, [10, 0, 0]))
    np.testing.assert_allclose(shifted.vertices[:, 0].min(), 0.5, atol=1e-6)


def test_pairs_give_the_motion_that_brings_them_together(rng):
    T = pose_of([1, -2, 0.5], 2.1, [30, -20, 5])
    source = rng.normal(size=(6, 3)) + UTM
    target = source @ T[:3, :3].T + T[:3, 3]
    fit = fit_pairs(source, target)
    np.testing.assert_allclose(fit.transformation[:3, :3], T[:3, :3], atol=1e-7)
    assert fit.rms < 1e-7 and np.linalg.det(fit.transformation[:3, :3]) == pytest.approx(1)
    mirrored = fit_pairs(source, source * [1, 1, -1])
    assert np.linalg.det(mirrored.transformation[:3, :3]) == pytest.approx(1) and mirrored.rms > 0.1


@pytest.mark.parametrize("shift", [np.zeros(3), UTM], ids=["here", "UTM"])
def test_rough_pairs_and_icp_bring_two_clouds_together(device, rng, shift):
    points = wavy()
    T = pose_of([0.2, 0.3, 1], 1.9, [4, -3, 2])
    target = loom.PointCloud(points + shift, device=device)
    source = loom.PointCloud((points - T[:3, 3]) @ T[:3, :3] + shift, device=device)
    rows = [130, 1770, 3480, 3550]
    poses = []
    noise = rng.normal(scale=0.03, size=(len(rows), 3))
    result = register_from_pairs(source, target, source.points[rows], target.points[rows] + noise, on_pose=poses.append)
    moved = source.points @ result.transformation[:3, :3].T + result.transformation[:3, 3]
    assert np.abs(moved - target.points).max() < 1e-3 < result.fit.rms
    assert result.refined and result.fitness > 0.99 and result.inlier_rmse < 1e-3
    assert len(poses) > 2 and np.array_equal(poses[0], result.fit.transformation)
    assert np.array_equal(poses[-1], result.transformation)
    rough = register_from_pairs(source, target, source.points[rows], target.points[rows] + noise, refine=False)
    assert not rough.refined and np.array_equal(rough.transformation, result.fit.transformation)


def test_wrong_pairs_are_reported_and_leave_the_picked_pose():
    target = loom.PointCloud(wavy())
    far = [[90, 0, 0], [91, 0, 0], [90, 1, 0]]
    result = register_from_pairs(target, target, target.points[[0, 500, 3000]], far, max_correspondence_distance=0.1)
    assert not result.refined and result.fitness == 0 and "check the pairs" in result.warnings[0]
    options = {"max_correspondence_distance": 0.1, "refine": False}
    unrefined = register_from_pairs(target, target, target.points[[0, 500, 3000]], far, **options)
    assert unrefined.warnings == result.warnings and not unrefined.reliable


FRONT = View(loom.PinholeCameraIntrinsic(641, 481, 500.0, 500.0, 320.0, 240.0), np.eye(4))  # along z, from the origin


def grid(side=40, spacing=0.05):
    """A tilted surface with points some ten pixels apart in a fitted view."""
    x, y = (a.ravel() * spacing for a in np.mgrid[:side, :side].astype(float))
    return np.column_stack([x, y, 0.1 * np.sin(2 * x) * np.cos(3 * y)])


def sphere(count=3000):
    z = 1 - (2 * np.arange(count) + 1) / count
    angle = np.pi * (1 + 5**0.5) * np.arange(count)
    return np.column_stack([np.sqrt(1 - z * z) * np.cos(angle), np.sqrt(1 - z * z) * np.sin(angle), z])


def pick_point(cloud, view, x, y, *, pose=None, hidden=None, **options):
    hit = pick([Target("cloud", cloud, pose=pose, hidden=hidden)], view, x, y, **options)
    return None if hit is None else hit.index


def oracle(points, view, x, y, radius, hidden=None):
    """The same rule in NumPy, for one point at a time in float64."""
    with np.errstate(all="ignore"):
        u, v, depth = seen_at(view, points)
        square = (u - x) ** 2 + (v - y) ** 2
    near = np.isfinite(points).all(axis=1) & (depth > 0) & (square <= radius**2)
    near &= np.ones(len(points), bool) if hidden is None else ~hidden
    if not near.any():
        return None
    foremost = depth[near].min()
    cost = square + ((depth - foremost) * view.intrinsic.fx / foremost / 10) ** 2
    return int(np.flatnonzero(near)[cost[near].argmin()])


@pytest.mark.parametrize(("shift", "scale"), [(UTM, 1.0), (0, 1e-4), (UTM, 1e4)], ids=["UTM", "small", "large"])
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
        assert pick_point(cloud, view, x, y, hidden=marks.arrays["hidden"]) == oracle(stored, view, x, y, 6.0, hidden)
        n_hits += expected is not None
    assert n_hits > 20


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
    moved = points @ POSE[:3, :3].T + POSE[:3, 3]
    cloud, view = loom.PointCloud(points, device=device), fit_view(moved, width=640, height=480)
    for index in (0, 777, 1599):
        x, y, _ = project(view, moved[index])
        assert pick_point(cloud, view, x, y, pose=POSE) == index
        hit = pick([Target("cloud", cloud, pose=POSE)], view, x, y)
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


def test_all_attributes_of_a_point_are_reported():
    points, values = np.array([[0.1, 0.25, -3]]) + UTM, {"label": np.array([7], np.int32), "wind": [[0.5, 2.0]]}
    cloud = loom.PointCloud(points, colors=[[1, 0.5, 0]], normals=[[0, 0, 1]], **values)
    rows = dict(describe_row(cloud, 0))
    assert rows["index"] == "0" and rows["color"] == "255 128 0" and rows["normal"] == "0.0000 0.0000 1.0000"
    assert rows["label"] == "7" and rows["wind"] == "0.5 2"
    assert [float(rows[axis]) for axis in "xyz"] == pytest.approx([412_345.1, 5_412_345.25, 297.0], abs=1e-6)
    assert dict(describe_row(cloud, 0, np.array([1.0, 2.0, 3.0])))["y"] == "2"


def test_coordinates_have_the_digits_that_they_have():
    assert coordinate_text(0.1, 7e-9) == "0.1"
    assert coordinate_text(float(np.float32(0.1)), 7e-9) == "0.1"
    assert coordinate_text(5_412_345.25, 4e-6) == "5412345.25"
    assert coordinate_text(-0.0) == "0" and coordinate_text(np.nan) == "nan" and coordinate_text(-np.inf) == "-inf"
    assert float(coordinate_text(1.25e-9, 1e-16)) == 1.25e-9 and float(coordinate_text(3e20, 1e13)) == 3e20


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
    name = f"visualization/polygon_crop/{axis.lower()}_{location.lower()}"
    assert oracle(name, open3ds_crop, saved, cloud.points).tolist() == selected.tolist() and len(selected) > 300
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
    moved = View(view.intrinsic, POSE @ view.T_world_camera)
    assert seen_inside(cloud, moved, star, pose=POSE).tolist() == expected.tolist()


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


def test_the_prism_is_exact_halfway_between_the_first_and_the_last_point_seen_inside():
    bounds = [[-3, -3, 0], [3, 3, 6]]  # only near the camera
    view = fit_view(bounds, direction=(0, 0, -1), up=(0, 1, 0), width=640, height=480)
    points = np.array([[0, 0, 1], [0.1, 0, 2], [0, 0.1, 4], [2.9, 2.9, 0], [-2.9, -2.9, 6]])
    polygon = [[200, 120], [440, 130], [430, 350], [210, 360]]
    assert seen_inside(loom.PointCloud(points), view, polygon).tolist() == [0, 1, 2]
    beside = [[u - 175, v - 100] for u, v in polygon]
    assert seen_inside(loom.PointCloud(points), view, beside).tolist() == []
    for corners, level in ((polygon, 2.5), (beside, 3.0)):
        for corner, vertex in zip(corners, polygon_to_volume(view, corners, points).bounding_polygon, strict=True):
            np.testing.assert_allclose(project(view, [vertex[0], vertex[1], level])[:2], corner, atol=1e-6)
