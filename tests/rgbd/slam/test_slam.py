"""A camera without poses in: its path and the surface out, and a verdict on each frame."""

from __future__ import annotations

import numpy as np
import pytest

import pointloom as loom
from pointloom.datasets.scenes.room import surface_errors

from .slam_walks import HEIGHT, VOXEL, WIDTH, begun, blank, changed, error_of, frame, frames, verdicts, walk

# Noise of some 5 mm a pixel at 2 m and voxels of 4 cm in pictures of 80 x 60: a hundredth of them is within reach.
NEAR, TURNED = 0.02, 0.5  # [m], [degrees]


def assert_found(results, true):
    for result, shown in zip(results, true, strict=True):
        assert result.status == "tracked", f"frame {result.index}: {result.warnings}"
        off, turned = error_of(result, shown)
        assert off < NEAR and turned < TURNED, f"frame {result.index} is {1000 * off:.0f} mm, {turned:.2f} degrees off"


def test_a_walk_is_tracked_and_its_surface_is_the_rooms(device):
    taken, slam = frames(*range(10)), begun(device)
    assert_found(slam.run(taken), taken)
    assert slam.status_counts == {"tracked": 10, "uncertain": 0, "lost": 0}
    assert slam.volume.frame_count == 10
    errors = surface_errors(slam.extract_triangle_mesh().vertices)
    assert len(errors) > 300 and np.median(errors) < 0.01


def test_the_trajectory_has_the_frames_numbers_and_times(device):
    taken, slam = frames(0, 1, 2), begun(device)
    slam.run([taken[0], blank(taken[1]), taken[2]])
    path = slam.trajectory
    assert path.ids is not None and path.timestamps is not None
    assert path.ids.tolist() == [[0, 0, 1], [2, 2, 1]]
    assert path.timestamps.tolist() == [taken[0].timestamp, taken[2].timestamp]


def lit(shown, gain):
    return changed(shown, color=np.clip(shown.color * gain, 0, 255).astype(np.uint8))


@pytest.mark.parametrize(
    "change",
    [
        lambda k, shown: changed(shown, color=None),
        lambda k, shown: changed(shown, color=None) if k in (2, 3) else shown,
        lambda k, shown: lit(shown, 1 + 0.4 * np.sin(2 * k)),
        lambda k, shown: frame(2 * k),
    ],
    ids=["depth alone", "some without color", "rolling exposure", "farther apart"],
)
def test_other_frames_are_tracked_too(device, change):
    taken, slam = [change(k, frame(k)) for k in range(6)], begun(device)
    assert_found(slam.run(taken), taken)
    assert slam.volume.frame_count == 6
    colors = slam.render(taken[0].T_world_camera).colors
    assert (colors is None) == all(shown.color is None for shown in taken)


def test_what_does_not_lie_on_the_model_is_not_fused(device):
    slam, shown = begun(device), frame(4)
    assert slam.step(blank(frame(0))).status == "lost"
    slam.run(frames(*range(4)))
    assert slam.results[1].status == "tracked", "the world begins with the first frame that has depth"
    dark, elsewhere = slam.step(blank(shown)), slam.step(frame(150))
    assert (dark.status, dark.pose, dark.fused) == ("lost", None, False) and "blank" in dark.warnings[0]
    assert (elsewhere.status, elsewhere.pose) == ("lost", None) and elsewhere.warnings
    wall = changed(shown, depth=np.full_like(shown.depth, 1200), color=np.full_like(shown.color, 90))
    assert slam.step(wall).status != "tracked"
    assert slam.volume.frame_count == 4


def test_a_camera_that_was_covered_for_a_while_is_found_again(device):
    """Meanwhile it moves by 6 frames of this walk, some 9 cm and 7 degrees."""
    slam = begun(device)
    slam.run(frames(*range(6)))
    lost = [slam.step(blank(frame(6))) for _ in range(12)]
    assert set(verdicts(lost)) == {"lost"}
    assert slam.volume.frame_count == 6
    results = slam.run(frames(9, 10, 11))
    assert results[-1].status == "tracked"
    off, turned = error_of(results[-1], frame(11))
    assert off < 2 * NEAR and turned < 2 * TURNED


def test_a_lost_camera_is_found_again_from_a_keyframe(device):
    slam = begun(device)
    slam.run(frames(*range(0, 28, 2)))
    assert len(slam.keyframes) >= 3
    slam.step(blank(frame(28)))
    first, second = slam.run(frames(1, 2))  # where it began, far from where it was last
    assert first.relocalized and not second.relocalized
    assert_found([first, second], frames(1, 2))


def test_a_flat_wall_without_color_is_uncertain_as_long_as_it_lasts(device):
    """3 mm of noise, as of a real camera; nothing is fused but the frame that the world begins with."""
    rng, slam = np.random.default_rng(0), begun(device)
    for number in range(8):
        depth = (1200 + rng.normal(0, 3, (HEIGHT, WIDTH))).round().astype(np.uint16)
        result = slam.step(changed(frame(0), depth=depth, color=None))
        assert result.status == ("uncertain" if number else "tracked")
    assert slam.volume.frame_count == 1


def test_somebody_in_a_quarter_of_the_picture_does_not_lose_the_camera(device):
    taken, slam = frames(*range(8)), begun(device)
    slam.run(taken[:5])
    for k, shown in enumerate(taken[5:]):
        depth = shown.depth.copy()
        depth[10:, 10 + 4 * k : 28 + 4 * k] = 900
        result = slam.step(changed(shown, depth=depth))
        assert result.status != "lost", result.warnings
        off, turned = error_of(result, shown)
        assert off < 2 * NEAR and turned < 2 * TURNED


def test_one_frame_or_none_is_a_run_too(device):
    slam = begun(device)
    assert slam.run([]) == [] and len(slam.trajectory) == 0
    assert len(slam.extract_triangle_mesh().vertices) == 0
    (result,) = slam.run(frames(0))
    assert result.status == "tracked"
    assert np.array_equal(result.pose, frame(0).T_world_camera)
    assert len(slam.extract_triangle_mesh(0).vertices) > 100


@pytest.mark.parametrize("jump", [-5.0, 1000.0, np.nan])
def test_time_that_jumps_takes_the_velocity_away_and_nothing_else(device, jump):
    taken, slam = frames(*range(5)), begun(device)
    slam.run(taken[:3])
    time = taken[2].timestamp + jump
    if np.isnan(jump):
        with pytest.raises(ValueError, match="timestamp"):
            slam.step(changed(taken[3], timestamp=time))
        return
    assert_found([slam.step(changed(taken[3], timestamp=time))], taken[3:4])
    assert_found([slam.step(changed(taken[4], timestamp=time + 1 / 30))], taken[4:5])


def test_tracking_alone_leaves_the_model_as_it_is(device):
    slam = begun(device)
    slam.run(frames(0, 1))
    result = slam.track(frame(2))
    assert result.is_tracked and not result.fused and slam.volume.frame_count == 2
    assert slam.integrate(frame(2)) and slam.results[-1].fused
    assert slam.volume.frame_count == 3
    with pytest.raises(ValueError, match=r"^frame:"):
        slam.integrate(frame(2))


def test_a_model_tracks_and_renders(device):
    model = loom.slam.Model(walk().intrinsic, voxel_size=VOXEL, device=device)
    first, second = frames(0, 1)
    model.integrate(first, first.T_world_camera)
    found = model.track_frame(second, first.T_world_camera)
    assert found.reliable, found.warnings
    off = np.linalg.norm(found.transformation[:3, 3] - second.T_world_camera[:3, 3])
    assert off < NEAR
    view = model.render(first.T_world_camera)
    both = (view.depth > 0) & (first.depth > 0)
    assert both.mean() > 0.5
    assert np.median(np.abs(view.depth - first.depth / 1000)[both]) < 0.02
    assert len(model.extract_point_cloud(0)) > 100


def test_pictures_of_another_size_are_refused(device):
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


def test_closing_loops_keeps_a_good_path_and_fuses_the_model_anew(device):
    """Nothing drifted here: poses stay, and the model of all submaps is the room's, and goes on being tracked."""
    taken, slam = frames(*range(12)), begun(device, submap_frames=6)
    slam.run(taken[:10])
    before = slam.trajectory.poses
    said: list[str] = []
    closure = slam.close_loops(progress=lambda stage, done, total: said.append(stage))
    assert len(closure.T_world_submap) >= 2 and said
    assert np.abs(slam.trajectory.poses - before).max() < 0.02
    errors = surface_errors(slam.extract_triangle_mesh().vertices)
    assert len(errors) > 300 and np.median(errors) < 0.01
    assert_found(slam.run(taken[10:]), taken[10:])


def test_without_submaps_there_is_nothing_to_close(device):
    with pytest.raises(ValueError, match="submap_frames"):
        begun(device).close_loops()
    with pytest.raises(ValueError, match="submap_frames"):
        begun(device, submap_frames=10).close_loops()
