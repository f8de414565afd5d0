"""SLAM without given poses: the path, the surface, a status for each frame, and the submaps."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.datasets.scenes.room import surface_errors
from pointloom.registration.rigid import pose_of
from pointloom.rgbd.slam.submaps import SubmapRecorder, tracked_run

from .loop_scenes import CAMERA, hall_depth, hall_run, record
from .slam_walks import HEIGHT, VOXEL, WIDTH, begun, blank, changed, error_of, frame, frames, sequence, statuses

# Noise of some 5 mm a pixel at 2 m and voxels of 4 cm in images of 80 x 60 allow a hundredth of them.
NEAR, MAX_ROTATION_ERROR = 0.02, 0.5  # [m], [degrees]


def assert_tracked(results, true):
    for result, shown in zip(results, true, strict=True):
        assert result.status == "tracked", f"frame {result.index}: {result.warnings}"
        error, angle = error_of(result, shown)
        assert error < NEAR and angle < MAX_ROTATION_ERROR, f"frame {result.index}: {error:.3f} m, {angle:.2f} degrees"


def test_a_sequence_is_tracked_and_its_surface_is_the_rooms(device):
    source, slam = frames(*range(10)), begun(device)
    assert_tracked(slam.run(source), source)
    assert slam.status_counts == {"tracked": 10, "uncertain": 0, "lost": 0} and slam.volume.frame_count == 10
    errors = surface_errors(slam.extract_triangle_mesh().vertices)
    assert len(errors) > 300 and np.median(errors) < 0.01


def test_the_trajectory_has_the_frames_numbers_and_times(device):
    source, slam = frames(0, 1, 2), begun(device)
    slam.run([source[0], blank(source[1]), source[2]])
    path = slam.trajectory
    assert path.ids is not None and path.timestamps is not None and path.ids.tolist() == [[0, 0, 1], [2, 2, 1]]
    assert path.timestamps.tolist() == [source[0].timestamp, source[2].timestamp]


@pytest.mark.parametrize(
    "change",
    [
        lambda k, shown: changed(shown, color=None),
        lambda k, shown: changed(shown, color=None) if k in (2, 3) else shown,
        lambda k, f: changed(f, color=np.clip(f.color * (1 + 0.4 * np.sin(2 * k)), 0, 255).astype(np.uint8)),
        lambda k, shown: frame(2 * k),
    ],
    ids=["depth alone", "some without color", "rolling exposure", "farther apart"],
)
def test_other_frames_are_tracked_too(device, change):
    source, slam = [change(k, frame(k)) for k in range(6)], begun(device)
    assert_tracked(slam.run(source), source)
    assert slam.volume.frame_count == 6
    colors = slam.render(source[0].T_world_camera).colors
    assert (colors is None) == all(shown.color is None for shown in source)


def test_depth_off_the_model_is_not_fused(device):
    slam, shown = begun(device), frame(4)
    assert slam.step(blank(frame(0))).status == "lost"
    slam.run(frames(*range(4)))
    assert slam.results[1].status == "tracked", "the world begins with the first frame that has depth"
    dark, elsewhere = slam.step(blank(shown)), slam.step(frame(150))
    assert (dark.status, dark.pose, dark.fused) == ("lost", None, False) and "blank" in dark.warnings[0]
    assert (elsewhere.status, elsewhere.pose) == ("lost", None) and elsewhere.warnings
    wall = changed(shown, depth=np.full_like(shown.depth, 1200), color=np.full_like(shown.color, 90))
    assert slam.step(wall).status != "tracked" and slam.volume.frame_count == 4


def test_a_camera_that_was_covered_is_relocalized(device):
    """The camera moves by 6 frames of this sequence while covered, some 9 cm and 7 degrees."""
    slam = begun(device)
    slam.run(frames(*range(6)))
    assert set(statuses([slam.step(blank(frame(6))) for _ in range(12)])) == {"lost"}
    assert slam.volume.frame_count == 6
    results = slam.run(frames(9, 10, 11))
    assert results[-1].status == "tracked"
    error, angle = error_of(results[-1], frame(11))
    assert error < 2 * NEAR and angle < 2 * MAX_ROTATION_ERROR


@pytest.mark.slow
def test_a_lost_camera_is_relocalized_from_a_keyframe(device):
    slam = begun(device)
    slam.run(frames(*range(0, 28, 2)))
    assert len(slam.keyframes) >= 3
    slam.step(blank(frame(28)))
    first, second = slam.run(frames(1, 2))  # the start, far from the last pose
    assert first.relocalized and not second.relocalized
    assert_tracked([first, second], frames(1, 2))


def test_a_flat_wall_without_color_is_uncertain_as_long_as_it_lasts(device):
    """3 mm of noise, as of a real camera; only the first frame is fused."""
    rng, slam = np.random.default_rng(0), begun(device)
    for number in range(8):
        depth = (1200 + rng.normal(0, 3, (HEIGHT, WIDTH))).round().astype(np.uint16)
        assert slam.step(changed(frame(0), depth=depth, color=None)).status == ("uncertain" if number else "tracked")
    assert slam.volume.frame_count == 1


def test_a_person_in_a_quarter_of_the_image_does_not_lose_the_camera(device):
    source, slam = frames(*range(8)), begun(device)
    slam.run(source[:5])
    for k, shown in enumerate(source[5:]):
        depth = shown.depth.copy()
        depth[10:, 10 + 4 * k : 28 + 4 * k] = 900
        result = slam.step(changed(shown, depth=depth))
        assert result.status != "lost", result.warnings
        error, angle = error_of(result, shown)
        assert error < 2 * NEAR and angle < 2 * MAX_ROTATION_ERROR


def test_runs_of_one_frame_or_none_are_valid(device):
    slam = begun(device)
    assert slam.run([]) == [] and len(slam.trajectory) == 0 and len(slam.extract_triangle_mesh().vertices) == 0
    (result,) = slam.run(frames(0))
    assert result.status == "tracked" and np.array_equal(result.pose, frame(0).T_world_camera)
    assert len(slam.extract_triangle_mesh(0).vertices) > 100


@pytest.mark.parametrize("jump", [-5.0, 1000.0, np.nan])
def test_a_time_jump_only_resets_the_velocity(device, jump):
    source, slam = frames(*range(5)), begun(device)
    slam.run(source[:3])
    time = source[2].timestamp + jump
    if np.isnan(jump):
        with pytest.raises(ValueError, match="timestamp"):
            slam.step(changed(source[3], timestamp=time))
        return
    assert_tracked([slam.step(changed(source[3], timestamp=time))], source[3:4])
    assert_tracked([slam.step(changed(source[4], timestamp=time + 1 / 30))], source[4:5])


def test_tracking_alone_does_not_change_the_model(device):
    slam = begun(device)
    slam.run(frames(0, 1))
    result = slam.track(frame(2))
    assert result.is_tracked and not result.fused and slam.volume.frame_count == 2
    assert slam.integrate(frame(2)) and slam.results[-1].fused and slam.volume.frame_count == 3
    with pytest.raises(ValueError, match=r"^frame:"):
        slam.integrate(frame(2))


def test_a_model_tracks_and_renders(device):
    model = loom.rgbd.SlamModel(sequence().intrinsic, voxel_size=VOXEL, device=device)
    first, second = frames(0, 1)
    model.integrate(first, first.T_world_camera)
    result = model.track_frame(second, first.T_world_camera)
    assert result.reliable, result.warnings
    assert np.linalg.norm(result.transformation[:3, 3] - second.T_world_camera[:3, 3]) < NEAR
    view = model.render(first.T_world_camera)
    both = (view.depth > 0) & (first.depth > 0)
    assert both.mean() > 0.5 and np.median(np.abs(view.depth - first.depth / 1000)[both]) < 0.02
    assert len(model.extract_point_cloud(0)) > 100


def test_a_model_has_the_requested_truncation_scale_range_and_start(device):
    shown = frame(0)
    start = np.array([[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    options = {"truncation": 0.3, "depth_scale": 2000.0, "depth_max": 1.2, "T_init": start, "leave_out_moving": False}
    model = loom.rgbd.SlamModel(sequence().intrinsic, voxel_size=VOXEL, device=device, **options)
    assert model.volume.truncation == pytest.approx(0.3) and not model.leave_out_moving
    np.testing.assert_array_equal(model.current_frame_pose, start)
    model.integrate(shown, np.eye(4))
    depth = model.extract_point_cloud(0).points[:, 2]
    assert depth.min() == pytest.approx(shown.depth[shown.depth > 0].min() / 2000, abs=VOXEL)
    assert 1.1 < depth.max() < 1.2 + VOXEL < shown.depth.max() / 2000
    views = [model.seen_from(np.eye(4), weight_threshold=threshold) for threshold in (0.0, 1.0)]
    seen, unseen = (loom.rgbd.align_frames(view, view).inliers for view in views)
    assert seen > 50 and unseen == 0  # one frame has a weight of 1
    slam = loom.rgbd.DenseSLAM(sequence().intrinsic, voxel_size=VOXEL, device=device, truncation=0.3)
    slam.step(shown)
    assert slam.volume.truncation == pytest.approx(0.3)


def test_the_seed_of_the_keyframes_is_the_requested_one():
    slam = loom.rgbd.DenseSLAM(sequence().intrinsic, voxel_size=VOXEL, seed=7)
    slam.step(frame(0))
    assert slam.keyframes.seed == 7


def test_images_of_another_size_are_refused(device):
    slam, shown = begun(device), frame(0)
    with pytest.raises(ValueError, match="intrinsic"):
        slam.step(changed(shown, depth=shown.depth[:-1], color=None))
    with pytest.raises(ValueError, match="color"):
        slam.step(changed(shown, color=shown.color[:-1]))
    with pytest.raises(TypeError, match="frame"):
        slam.step(shown.depth)
    assert slam.results == []


def test_an_image_pair_is_a_frame(device):
    shown, slam = frame(0), begun(device)
    gray = loom.RGBDImage.create_from_color_and_depth(shown.color, shown.depth, depth_trunc=4.0)
    assert slam.step(gray).status == "tracked"
    assert slam.step(loom.RGBDImage(frame(1).color, frame(1).depth, depth_trunc=4.0)).status == "tracked"


def test_closing_loops_preserves_a_good_path_and_rebuilds_the_model(device):
    """Without drift, poses are unchanged, the model of all submaps is the room's, and tracking continues."""
    source, slam = frames(*range(12)), begun(device, submap_frames=6)
    slam.run(source[:10])
    before = slam.trajectory.poses
    stages: list[str] = []
    closure = slam.close_loops(progress=lambda stage, done, total: stages.append(stage))
    assert len(closure.T_world_submap) >= 2 and stages and np.abs(slam.trajectory.poses - before).max() < 0.02
    errors = surface_errors(slam.extract_triangle_mesh().vertices)
    assert len(errors) > 300 and np.median(errors) < 0.01
    assert_tracked(slam.run(source[10:]), source[10:])


def test_without_submaps_there_is_nothing_to_close(device):
    with pytest.raises(ValueError, match="submap_frames"):
        begun(device).close_loops()
    with pytest.raises(ValueError, match="submap_frames"):
        begun(device, submap_frames=10).close_loops()


def along_x(count, step=0.01):
    return [pose_of(np.array([0, 0, 0, step * i, 0, 0])) for i in range(count)]


def test_each_submap_shares_its_last_frames_with_the_next():
    submaps = record(along_x(25), frames=10, shared=0.2).finish()
    assert [(s.frames[0], s.frames[-1]) for s in submaps] == [(0, 9), (8, 17), (16, 24)]
    assert [s.follows for s in submaps] == [False, True, True]
    assert sum(s.volume.frame_count for s in submaps) == 29


def test_a_submap_without_its_own_frames_is_omitted():
    assert [s.frames[-1] for s in record(along_x(10), frames=10, shared=0.2).finish()] == [9]


def test_a_fast_camera_fills_submaps_sooner():
    submaps = record(along_x(20, step=0.1), frames=100, max_length=0.5, shared=0.2).finish()
    assert len(submaps) >= 4 and all(np.ptp(s.T_world_camera[:, 0, 3]) <= 0.61 for s in submaps)
    turning = [pose_of(np.array([0, 0.1 * i, 0, 0, 0, 0])) for i in range(20)]
    assert len(record(turning, frames=100, max_length=0.5).finish()) >= 4


def test_a_submap_after_a_loss_follows_none():
    submaps = record([*along_x(5), None, None, *along_x(5)], frames=100).finish()
    assert [s.frames.tolist() for s in submaps] == [[0, 1, 2, 3, 4], [7, 8, 9, 10, 11]]
    assert [s.follows for s in submaps] == [False, False]


def test_a_submap_is_in_the_frame_of_its_first_camera():
    """Also far from the world's origin, where local coordinates stay small."""
    far = pose_of(np.array([0, 0, 1.0, 500_000.0, 5_400_000.0, 300.0]))
    submap = record([far @ pose for pose in along_x(3)]).finish()[0]
    assert np.abs(submap.T_world_submap - far).max() < 1e-9 and (submap.volume.origin == 0).all()
    assert np.abs(submap.T_submap_camera - along_x(3)).max() < 1e-8
    assert np.abs(submap.cloud(0.05).points[:, 2] - 1.5).max() < 1e-4


def test_tracked_poses_are_those_given_to_the_recorder():
    poses = along_x(25)
    numbers, tracked = tracked_run(record(poses, frames=10).finish())
    assert (numbers == np.arange(25)).all() and np.abs(tracked - poses).max() < 1e-12


def test_a_cloud_of_a_submap_is_on_its_surface(device):
    submap = hall_run(device, 4, (0.0, 1.2))
    cloud = submap.cloud(0.1)
    points = cloud.points @ submap.T_world_submap[:3, :3].T + submap.T_world_submap[:3, 3]
    distances = np.abs(np.abs(points) - [2.0, 2.0, 1.2]).min(axis=1)
    assert len(cloud) > 300 and np.median(distances) < 0.01 and cloud.has_normals()


def test_the_submap_in_progress_can_be_extracted():
    recorder = SubmapRecorder(CAMERA, voxel_size=0.1, color=False)
    assert recorder.current is None
    recorder.add(hall_depth(np.eye(4)), np.eye(4))
    assert recorder.current.frames.tolist() == [0]


@pytest.mark.parametrize("truncation", [0.2, 0.45])
def test_submaps_have_the_requested_truncation(truncation):
    recorder = SubmapRecorder(CAMERA, voxel_size=0.1, color=False, truncation=truncation)
    recorder.add(hall_depth(np.eye(4)), np.eye(4))
    assert recorder.current.volume.truncation == pytest.approx(truncation)


def test_bad_frames_and_sizes_are_refused():
    recorder = record(along_x(3))
    with pytest.raises(ValueError, match="number:"):
        recorder.add(np.ones((48, 64)), np.eye(4), number=2)
    with pytest.raises(ValueError, match="T_world_camera"):
        recorder.add(np.ones((48, 64)), 2 * np.eye(4))
    for options, message in (
        ({"shared": 0.6}, "shared"),
        ({"frames": 0}, "frames"),
        ({"max_length": 0.0}, "max_length"),
        ({"voxel_size": -1.0}, "voxel_size"),
    ):
        with pytest.raises(ValueError, match=message):
            SubmapRecorder(CAMERA, **{"voxel_size": 0.1} | options)
