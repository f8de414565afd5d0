"""Errors against the truth: planted ones are found at their size, and nothing else is."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.data.scenes.room import room_views
from pointloom.data.scenes.room_errors import camera_errors, depth_errors, room_mesh_errors
from pointloom.data.scenes.room_video import room_video_poses


def moved(poses, scale, turn, shift):
    """The same cameras in another unit and frame."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = Rotation.from_euler("xyz", turn, degrees=True).as_matrix(), shift
    other = T @ poses
    other[:, :3, 3] *= scale
    return other


@pytest.mark.parametrize("scale", [1.0, 1e-3, 250.0])
def test_cameras_in_another_unit_and_frame_have_no_error(scale):
    truths = room_video_poses(9)
    found = camera_errors(moved(truths, scale, (20, -70, 130), (5, -3, 400)), truths)
    assert found.compared == 9
    assert found.scale == pytest.approx(1 / scale, rel=1e-9)
    assert found.m.max < 1e-9 and found.deg.max < 1e-4
    assert found.extent_m == pytest.approx(np.linalg.norm(np.ptp(truths[:, :3, 3], axis=0)))


def test_planted_errors_of_cameras_are_found_at_their_size():
    truths, rng = room_video_poses(60), np.random.default_rng(0)
    poses = truths.copy()
    poses[:, :3, 3] += rng.normal(0, 0.002, (60, 3))
    found = camera_errors(moved(poses, 3.0, (1, 2, 3), (4, 5, 6)), truths)
    assert found.m.rmse == pytest.approx(0.002 * 3**0.5, rel=0.1)
    assert found.percent.rmse == pytest.approx(100 * found.m.rmse / found.extent_m)
    turned = truths.copy()
    turned[:, :3, :3] @= Rotation.from_rotvec(np.radians(rng.normal(0, 0.1, (60, 3)))).as_matrix()
    found = camera_errors(moved(turned, 3.0, (1, 2, 3), (4, 5, 6)), truths)
    assert found.deg.rmse == pytest.approx(0.1 * 3**0.5, rel=0.2)
    assert found.m.max < 1e-9


def test_similarity_takes_the_model_to_the_truth():
    truths = room_video_poses(12)
    poses = moved(truths, 4.0, (10, 20, 30), (1, 2, 3))
    T = np.array(camera_errors(poses, truths).transformation)
    np.testing.assert_allclose((T @ poses)[:, :3, 3], truths[:, :3, 3], atol=1e-9)


def test_too_few_cameras_have_no_errors():
    truths = room_video_poses(9)
    assert camera_errors(truths[:2], truths[:2]) is None
    assert camera_errors(np.zeros((0, 4, 4)), np.zeros((0, 4, 4))) is None
    still = np.repeat(truths[:1], 5, axis=0)
    assert camera_errors(truths[:5], still) is None and camera_errors(still, truths[:5]) is None


def test_poses_that_are_none_are_refused():
    good = np.tile(np.eye(4), (3, 1, 1))
    for poses, truths, message in (
        (np.eye(4), good, r"poses: expected shape \[n, 4, 4\], got \[4, 4\]"),
        (good, np.tile(np.eye(4), (4, 1, 1)), "truths: expected 3 poses"),
        (2 * good, good, r"poses\[0\]: expected a rigid"),
    ):
        with pytest.raises(ValueError, match=message):
            camera_errors(poses, truths)
    for poses, error in (([], ValueError), ("poses", TypeError), ([np.ones((4, 4))], ValueError)):
        with pytest.raises(error, match="poses"):
            room_views(poses, loom.PinholeCameraIntrinsic(4, 3, 3.0, 3.0, 1.5, 1.0))


def test_planted_errors_of_depth_are_found_at_their_size():
    truth = np.full((40, 50), 2.0)
    depth = truth * np.where(np.arange(50) < 10, 1.02, 1.004)
    depth[:8] = 0
    found = depth_errors([(depth, truth)])
    assert found.kept == pytest.approx(0.8)
    assert found.median_relative == pytest.approx(0.004)
    assert found.within == pytest.approx(0.8)
    assert found.complete == pytest.approx(0.64)
    assert found.p90_relative == pytest.approx(0.02)


def test_what_has_no_true_depth_does_not_count():
    truth, depth = np.zeros((4, 4)), np.ones((4, 4))
    truth[0] = 1
    assert depth_errors([(depth, truth)]).kept == 1.0
    assert depth_errors([(depth, truth * 0)]) is None
    assert depth_errors([]) is None
    nothing = depth_errors([(depth * 0, truth)])
    assert nothing.kept == 0 and np.isnan(nothing.median_relative)


def test_pictures_count_alike_an_error_at_the_limit_is_within_and_other_shapes_are_refused():
    small, large = np.ones((2, 2)), np.ones((50, 50))
    assert depth_errors([(small, small), (0 * large, large)]).kept == 0.5
    assert depth_errors([(np.full((1, 3), 2.02), np.full((1, 3), 2.0))]).within == 1.0
    for shapes in (((4, 4), (4, 5)), ((4,), (4,)), ((2, 2, 2), (2, 2, 2))):
        with pytest.raises(ValueError, match=r"pairs\[0\]: expected two maps of one shape"):
            depth_errors([(np.ones(shapes[0]), np.ones(shapes[1]))])


def test_a_mesh_of_the_floor_is_right_and_covers_the_floor_alone(device):
    """A sheet 5 mm below the floor's rug is near it; it covers what was seen of the floor and not of a wall."""
    corners = [[0.0, 0.0, 0.005], [5, 0, 0.005], [5, 4, 0.005], [0, 4, 0.005]]
    mesh = loom.TriangleMesh(corners, [[0, 1, 2], [0, 2, 3]], device=device).subdivide_midpoint(6)
    rng = np.random.default_rng(0)
    floor = np.column_stack([rng.uniform(0.5, 4.5, 60), rng.uniform(0.5, 3.5, 60), np.zeros(60)])
    wall = np.column_stack([rng.uniform(0.5, 4.5, 20), np.full(20, 4.0), rng.uniform(1, 2, 20)])
    found = room_mesh_errors(mesh, np.concatenate([floor, wall]))
    assert found.vertices == len(mesh.vertices)
    assert found.covered == 0.75
    assert found.median < 0.0051 and found.within > 0.8
    assert room_mesh_errors(loom.TriangleMesh(np.zeros((0, 3)), np.zeros((0, 3), int)), np.zeros((1, 3))) is None


def test_views_are_those_of_the_poses_and_the_camera(device):
    camera = loom.PinholeCameraIntrinsic(40, 30, 30.0, 31.0, 18.0, 15.5)
    poses = room_video_poses(3)
    views = room_views(poses, camera, device=device)
    assert np.array_equal(views.poses, poses) and len(views) == 3
    again = room_views(poses[1:2], camera, device=device).read(0)
    assert np.array_equal(again.depth, views.read(1).depth)
    assert views.read(0).intrinsic == camera
