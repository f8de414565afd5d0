"""Measuring, clip planes and registration from picked pairs, without a browser."""

import json
import math

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import DEGREE, FOOT
from pointloom.visualization.viewer.tools.clip_planes import Clip, clip_mesh, hidden_points
from pointloom.visualization.viewer.tools.correspondences import fit_pairs, register_from_pairs, save_pairs
from pointloom.visualization.viewer.tools.measuring import (
    angle_at,
    distance_between,
    length_text,
    measurements,
    path_length,
)

UTM = np.array([412_345.0, 5_412_345.0, 300.0])


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
    assert cut.get_surface_area() == pytest.approx(
        3 * 1.5**2, rel=1e-5
    )  # three sides of the box are whole squares less
    assert clip_mesh(mesh, Clip()) is mesh and clip_mesh(mesh, Clip(low=[-1, -1, -1])) is mesh
    assert len(clip_mesh(mesh, Clip(low=[3, 0, 0]))) == 0
    shifted = clip_mesh(mesh, Clip(low=[10.5, -9, -9]), pose=pose_of([0, 0, 1], 0, [10, 0, 0]))
    np.testing.assert_allclose(shifted.vertices[:, 0].min(), 0.5, atol=1e-6)


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"low": [1, 0, 0], "high": [0, 1, 1]}, "low <= high"),
        ({"low": [np.nan, 0, 0]}, "NaN"),
        ({"normal": [0, 0, 0]}, "expected a direction"),
        ({"normal": [0, np.inf, 0]}, "normal"),
        ({"high": [1, 2]}, "high"),
        ({"offset": np.nan}, "offset"),
    ],
)
def test_invalid_planes_are_rejected(given, words):
    with pytest.raises(ValueError, match=words):
        Clip(**given)


def test_pairs_give_the_motion_that_brings_them_together(rng):
    T = pose_of([1, -2, 0.5], 2.1, [30, -20, 5])
    source = rng.normal(size=(6, 3)) + UTM
    target = source @ T[:3, :3].T + T[:3, 3]
    fit = fit_pairs(source, target)
    np.testing.assert_allclose(fit.transformation[:3, :3], T[:3, :3], atol=1e-7)
    assert fit.rms < 1e-7 and np.linalg.det(fit.transformation[:3, :3]) == pytest.approx(1)
    mirrored = fit_pairs(source, source * [1, 1, -1])
    assert np.linalg.det(mirrored.transformation[:3, :3]) == pytest.approx(1) and mirrored.rms > 0.1


@pytest.mark.parametrize(
    ("source", "words"),
    [
        ([[0, 0, 0], [1, 0, 0]], "at least three, got 2; pick 1 more"),
        (np.zeros((0, 3)), "at least three, got 0"),
        ([[0, 0, 0], [1, 1, 1], [2, 2, 2.01]], "points of the source are collinear"),
        ([[1, 1, 1]] * 3, "points of the source are identical"),
        ([[0, 0, 0], [1, 0, 0], [0, np.nan, 0]], "source"),
    ],
)
def test_pairs_that_leave_a_motion_open_are_refused(source, words):
    with pytest.raises(ValueError, match=words):
        fit_pairs(source, np.array(source) + 1)


@pytest.mark.parametrize("shift", [np.zeros(3), UTM], ids=["here", "UTM"])
def test_rough_pairs_and_icp_bring_two_clouds_together(device, rng, shift):
    points = wavy()
    T = pose_of([0.2, 0.3, 1], 1.9, [4, -3, 2])
    target = loom.PointCloud(points + shift, device=device)
    source = loom.PointCloud((points - T[:3, 3]) @ T[:3, :3] + shift, device=device)
    rows = [130, 1770, 3480, 3550]
    poses = []
    missed = rng.normal(scale=0.03, size=(len(rows), 3))
    result = register_from_pairs(
        source, target, source.points[rows], target.points[rows] + missed, on_pose=poses.append
    )
    moved = source.points @ result.transformation[:3, :3].T + result.transformation[:3, 3]
    assert np.abs(moved - target.points).max() < 1e-3 < result.fit.rms
    assert result.refined and result.fitness > 0.99 and result.inlier_rmse < 1e-3
    assert len(poses) > 2 and np.array_equal(poses[0], result.fit.transformation)
    assert np.array_equal(poses[-1], result.transformation)
    rough = register_from_pairs(source, target, source.points[rows], target.points[rows] + missed, refine=False)
    assert not rough.refined and np.array_equal(rough.transformation, result.fit.transformation)


def test_wrong_pairs_are_reported_and_leave_the_picked_pose():
    target = loom.PointCloud(wavy())
    far = [[90, 0, 0], [91, 0, 0], [90, 1, 0]]
    result = register_from_pairs(target, target, target.points[[0, 500, 3000]], far, max_correspondence_distance=0.1)
    assert not result.refined and result.fitness == 0 and "check the pairs" in result.warnings[0]


def test_clouds_with_nothing_to_register_are_refused():
    three = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    with pytest.raises(ValueError, match="source:"):
        register_from_pairs(loom.PointCloud(), loom.PointCloud(three), three, three)
    with pytest.raises(TypeError, match="target"):
        register_from_pairs(loom.PointCloud(three), three, three, three)
    with pytest.raises(ValueError, match="all points are identical"):
        register_from_pairs(loom.PointCloud(three[:1]), loom.PointCloud(three[:1]), three, three)


def test_pairs_are_written_to_be_read_again(tmp_path):
    target = loom.PointCloud(wavy())
    rows = [130, 1770, 3480]
    result = register_from_pairs(target, target, target.points[rows], target.points[rows])
    pairs = np.column_stack([rows, rows])
    save_pairs(tmp_path / "pairs.json", ("a", "b"), pairs, target.points[rows], target.points[rows], result)
    content = json.loads((tmp_path / "pairs.json").read_text())
    assert content["correspondences"] == pairs.tolist() and content["source"] == "a"
    assert np.array_equal(content["T_target_source"], result.transformation)
