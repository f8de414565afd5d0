"""Synchronization of color and depth: repeated and delayed images are reported, correct ones are not."""

import dataclasses
import types

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.slam import dense_slam
from pointloom.rgbd.slam.frame_checks import BLANK
from pointloom.rgbd.slam.results import TrackingResult
from pointloom.rgbd.slam.stream_check import DOUBTFUL, MIRRORED_SIGNS, STALE, Apart, FrozenDepth, Rotations, StreamLag
from pointloom.rgbd.slam.tracking import covered_frames

from ...products import few_quick
from .slam_walks import begun, blank, changed, fit, frames, sequence, statuses


def stalled(source, first, last):
    """Frames, some of which repeat the depth image of an earlier frame."""
    return [changed(f, depth=source[first - 1].depth) if first <= k <= last else f for k, f in enumerate(source)]


def test_a_repeated_depth_image_is_rejected_if_colors_change(device):
    source, slam = frames(*range(10)), begun(device)
    results = slam.run(stalled(source, 2, 8))  # 1/30 s each
    assert statuses(results) == ["tracked"] * 5 + ["lost"] * 4 + ["tracked"]
    assert {r.warnings for r in results[5:9]} == {(STALE,)} and not any(r.fused for r in results[5:9])


def test_without_times_three_frames_are_accepted():
    source = [changed(f, timestamp=None) for f in frames(*range(8))]
    assert statuses(begun("cpu").run(stalled(source, 2, 7))) == ["tracked"] * 5 + ["lost"] * 3


def test_a_frame_that_is_repeated_now_and_then_is_accepted():
    results = begun("cpu").run(stalled(stalled(frames(*range(8)), 2, 2), 5, 6))
    assert all(fit(results)) and len(results) == 8


def test_a_covered_lens_is_blank_and_no_stalled_stream(device):
    source, slam = frames(*range(6)), begun(device)
    moving = [source[0], *(changed(f, depth=blank(f).depth) for f in source[1:])]
    assert [r.warnings for r in slam.run(moving)[1:]] == [("the image is blank",)] * 5


def rotations(color, depth):
    """Rotations [rad] with an accuracy of 0.06 degrees by depth; the third direction is undetermined."""
    return Rotations(color, depth, np.eye(3), np.array([1e-6, 1e-6, 1.0]))


def shaking(count, late, seed=0, period=1 / 30, stretch=None):
    """A StreamLag of a hand-held camera whose depth is late by this many frames, perhaps only in a stretch of them."""
    rng, lag = np.random.default_rng(seed), StreamLag()
    t = np.arange(-100, count + 100)[:, None]
    rates, phases = rng.uniform(0.1, 0.6, (4, 3)), rng.uniform(0, 6.28, (4, 3))
    shake = 0.004 * sum(np.sin(rate * t + phase) for rate, phase in zip(rates, phases, strict=True))
    noise = 0.0003 * rng.normal(size=(2, count, 3))
    for k in range(count):
        is_late = stretch is None or k in stretch
        position = 100 + k - (late if is_late else 0)
        below, part = int(np.floor(position)), position - np.floor(position)
        depth = (1 - part) * shake[below] + part * shake[below + 1]
        lag.add_rotations(rotations(shake[100 + k] + noise[0, k], depth + noise[1, k]), period and period * k)
    return lag


@pytest.mark.parametrize("late", [1.5, 2, 5, 15, 30, -2, -30])
def test_late_or_early_depth_is_reported_with_its_delay(late):
    lag = shaking(90, late)
    assert abs(lag.current.frames - late) < 0.2 and abs(lag.current.seconds - late / 30) < 0.007
    assert lag.current.first == 0 and lag.current.last == 89
    assert abs(shaking(90, late, period=None).current.frames - late) < 0.2


@few_quick(2, "late", [1, 0, -1, 0.5])
def test_a_frame_at_30_hz_is_accepted(late):
    for seed in range(5):
        assert not shaking(120, late, seed).apart and not shaking(120, late, seed, period=None).apart


def test_late_depth_in_a_stretch_of_two_seconds_is_reported_for_that_stretch():
    lag = shaking(200, 30, stretch=range(80, 140))
    assert lag.current is None and len(lag.apart) == 1
    assert 70 <= lag.apart[0].first <= 80 and 135 <= lag.apart[0].last <= 150
    assert abs(lag.apart[0].seconds - 1.0) < 0.02 and str(lag.apart[0]).startswith("depth is 1.00 s late")


def test_late_depth_is_doubtful_before_it_is_reported():
    doubtful, reported = (
        next(k for k in range(16, 60) if is_noted(shaking(k, 30, stretch=range(60))))
        for is_noted in (lambda lag: lag.is_doubtful, lambda lag: lag.current is not None)
    )
    assert doubtful < reported <= 30 and not any(shaking(k, 0).is_doubtful for k in range(10, 60, 3))


@few_quick(1, ("steady", "spread"), [(0.01, 0.0003), (0, 1e-5)], ids=["steady", "none"])
def test_a_steady_rotation_and_a_stationary_camera_are_synchronized(steady, spread):
    for seed in range(10):
        rng, lag = np.random.default_rng(seed), StreamLag()
        for _ in range(150):
            lag.add_rotations(rotations(*(steady + spread * rng.normal(size=(2, 3)))), None)
        assert not lag.apart


@pytest.mark.slow
@pytest.mark.parametrize("excess", [0.0, 1.0])
def test_unrelated_rotations_are_reported_without_a_delay_if_the_scene_is_rigid(excess):
    for seed in range(10):
        rng, lag = np.random.default_rng(seed), StreamLag()
        for _ in range(150):
            pair = rotations(*(0.01 * rng.normal(size=(2, 3))))
            lag.add_rotations(dataclasses.replace(pair, excess=excess), None)
        if excess:  # a large object moves, so that neither rotation is the camera's
            assert not lag.apart
        else:
            assert np.isnan(lag.current.frames) and not lag.current.mirrored
            assert "no constant delay explains it" in str(lag.current)


@pytest.mark.parametrize("rate", [-1 / 6, 1 / 6, 0.25, 1.0])
def test_streams_of_two_rates_are_reported_without_a_delay(rate):
    rng, lag = np.random.default_rng(4), StreamLag()
    t = np.arange(-50, 700)[:, None]
    rates, phases = rng.uniform(0.1, 0.6, (4, 3)), rng.uniform(0, 6.28, (4, 3))
    angle = np.cumsum(0.004 * sum(np.sin(r * t + phase) for r, phase in zip(rates, phases, strict=True)), axis=0)
    for k in range(1, 150):
        at = np.array([k - 1, k]) * (1 + rate) + 50
        depth = np.diff([np.interp(at, np.arange(len(angle)), angle[:, axis]) for axis in range(3)], axis=1)[:, 0]
        color = angle[50 + k] - angle[49 + k]
        lag.add_rotations(rotations(*(one + 0.0003 * rng.normal(size=3) for one in (color, depth))), k / 30)
    assert np.isnan(lag.current.frames) and "different rates (pair their images by time)" in str(lag.current)


@pytest.mark.parametrize(("kind", "signs"), sorted(MIRRORED_SIGNS.items()))
def test_mirrored_depth_is_reported(kind, signs):
    rng, lag = np.random.default_rng(2), StreamLag()
    for _ in range(60):
        color = 0.01 * rng.normal(size=3)
        full = Rotations(color, signs * color + 0.0003 * rng.normal(size=3), np.eye(3), np.full(3, 1e-6))
        lag.add_rotations(full, None)
    assert lag.current.mirrored == kind and f"mirrored or rotated ({kind})" in str(lag.current)


def test_a_periodic_motion_gives_the_shortest_delay():
    lag = StreamLag()
    for k in range(120):
        waves = [0.005 * np.sin(2 * np.pi * (k - late) / 40 + np.arange(3)) for late in (0, 3)]
        lag.add_rotations(rotations(*waves), None)
    assert abs(lag.current.frames - 3) < 0.3


def test_frames_without_rotations_are_left_out():
    lag = StreamLag()
    for k in range(90):
        shake = [0.005 * np.sin(0.3 * np.arange(3) + 0.4 * (k - late)) for late in (0, 6)]
        lag.add_rotations(None if k % 3 == 0 else rotations(*shake), None)
    assert abs(abs(lag.current.frames) - 6) < 0.2


def noisy(f, original, seed):
    """The frame with the depth of another one, and one millimeter of noise."""
    rng, z = np.random.default_rng(seed), original.depth.astype(float)
    return changed(f, depth=np.where(z > 0, np.rint(z + rng.normal(0, 1, z.shape)), 0).astype(np.uint16))


def test_repeated_depth_with_sensor_noise_is_rejected(device):
    source, slam = frames(*range(18)), begun(device)
    results = slam.run([noisy(f, source[min(k, 3)], k) for k, f in enumerate(source)])
    assert statuses(results)[:4] == ["tracked"] * 4 and {r.warnings for r in results[9:]} == {(STALE,)}
    assert slam.stream.problems is None


@pytest.mark.parametrize("is_moving", [False, True])
def test_only_depth_that_changes_by_noise_alone_is_frozen(is_moving):
    """While colors rotate and surfaces, such as a wall that comes nearer, do not."""
    rng, frozen = np.random.default_rng(0), FrozenDepth()
    counts = []
    for k in range(20):
        nearness = 0.5 + 0.001 * rng.normal(size=(30, 40)) + 0.004 * k * is_moving
        view = types.SimpleNamespace(host_nearness=nearness.astype(np.float32))
        counts.append(frozen.add(rotations(np.array([0.01, 0, 0]), np.zeros(3)) if k else None, view))
    assert (counts[-1] > 3) != is_moving and any(counts) != is_moving


def noisy_color(f, _, seed):
    color = f.color + np.random.default_rng(seed).normal(0, 3, f.color.shape)
    return changed(f, color=np.clip(color, 0, 255).astype(np.uint8))


@pytest.mark.parametrize("noise", [lambda f, *_: f, noisy_color, noisy], ids=["none", "color", "depth"])
def test_repeated_frames_with_or_without_noise_are_a_stationary_camera(device, noise):
    slam, first = begun(device), changed(frames(0)[0], timestamp=None)
    assert statuses(slam.run([noise(first, first, k) for k in range(12)])) == ["tracked"] * 12


@pytest.mark.slow
def test_depth_two_frames_late_is_uncertain_from_the_first_frame():
    source = frames(*np.rint(6 + 6 * np.sin(0.4 * np.arange(34) + np.sin(0.9 * np.arange(34)))).astype(int).tolist())
    late = [changed(f, depth=source[k].depth, timestamp=k / 30) for k, f in enumerate(source[2:])]
    slam = begun("cpu")
    assert "tracked" not in statuses(slam.run(late)) and "depth is 0.07 s late" in slam.stream.problem
    assert not any(r.fused and not r.has_drifted for r in slam.results)
    assert slam.volume.frame_count == sum(r.fused for r in slam.results) and slam.model.frame_count > 10


@pytest.mark.slow
def test_doubtful_frames_are_accepted_after_the_window_without_a_problem():
    source, slam = frames(*range(12)), begun("cpu")
    compare = slam.stream.compare
    slam.stream.compare = lambda frame: compare(frame) or (DOUBTFUL if len(slam.results) == 5 else "")
    images = [source[k if k < 12 else 22 - k] for k in range(22)]
    slam.run([changed(f, depth=f.depth.copy(), timestamp=k / 30) for k, f in enumerate(images)])
    assert (slam.results[5].status, slam.results[5].warnings) == ("uncertain", (DOUBTFUL,))
    assert (slam.volume.frame_count, slam.model.frame_count) == (21, 22) and not slam.results[5].fused
    slam.run([changed(f, depth=f.depth.copy(), timestamp=k / 30) for k, f in enumerate(images[:10], 22)])
    assert statuses(slam.results) == ["tracked"] * 32
    assert all(r.fused for r in slam.results) and slam.volume.frame_count == slam.model.frame_count == 32


@pytest.mark.slow
def test_frames_that_were_fused_too_early_to_be_removed_are_counted(monkeypatch):
    monkeypatch.setattr(dense_slam, "MAX_UNCHECKED", 5)
    source = frames(*np.rint(6 + 6 * np.sin(0.4 * np.arange(34) + np.sin(0.9 * np.arange(34)))).astype(int).tolist())
    late = [(f.color, source[k].depth, k / 30) for k, f in enumerate(source[2:])]
    path = loom.rgbd.track(loom.frames_from(late, begun("cpu").model.intrinsic))
    assert "of these frames" in path.stream and path.stream.endswith("remain in the model")


@pytest.mark.parametrize("submap_frames", [None, 2])
def test_reported_frames_are_uncertain_and_withdrawn_from_the_surface(device, submap_frames):
    source, slam = frames(*range(4)), begun(device, submap_frames=submap_frames)
    slam.run(source[:3])
    slam.stream.lag.current = Apart(1, 3, 30.0, 1.0)
    result = slam.step(source[3])
    message = (
        "depth is 1.00 s late compared with color in frame 1-3; pair each color image with the depth image that is "
        "1.00 s later"
    )
    assert (result.status, result.warnings, result.fused) == ("uncertain", (message,), False)
    assert statuses(slam.results) == ["tracked", "uncertain", "uncertain", "uncertain"]
    assert [r.fused for r in slam.results] == [True, False, False, False] and slam.volume.frame_count == 1
    assert (slam.model.surface_volume.frame_count, slam.model.volume.frame_count) == (1, 3)
    alone = begun(device, submap_frames=submap_frames)
    alone.run(source[:1])
    for close in (lambda _: None, loom.rgbd.DenseSLAM.close_loops)[: 1 if submap_frames is None else 2]:
        close(slam), close(alone)
        vertices, expected = (np.sort(each.extract_triangle_mesh(0).vertices, axis=0) for each in (slam, alone))
        np.testing.assert_allclose(vertices, expected, atol=1e-5)
    assert str(Apart(1, 3, -30.0, np.nan)).startswith("depth is 30.0 frames early")


@pytest.fixture(scope="module")
def path():
    """The path of two frames."""
    images = [(f.color, f.depth) for f in frames(0, 1)]
    return loom.rgbd.track(loom.frames_from(images, sequence().intrinsic), voxel_size=0.04)


def test_a_path_with_unsynchronized_streams_is_unreliable(path):
    assert path.stream is None and path.reliable
    message = "color and depth appear to be 1.0 s apart in time"
    apart = dataclasses.replace(path, stream=message, uncertain=(0, 1), uncertain_warning=message)
    assert apart.warnings == (message, "2 of 2 poses are uncertain (frame 0-1)")
    assert apart.to_dict()["stream"] == message
    slides = dataclasses.replace(path, uncertain=(0, 1), uncertain_warning="it may slide")
    assert "(frame 0-1): it may slide" in slides.warnings[0]


def test_a_short_gap_of_blank_frames_is_no_failure_if_tracking_resumes():
    def covered(gap, after, step=1 / 30):
        seen = TrackingResult(np.eye(4), "tracked")
        results = [seen] * 3 + [TrackingResult(None, "lost", (BLANK,))] * gap + after
        timed = [dataclasses.replace(result, timestamp=step * k) for k, result in enumerate(results)]
        return covered_frames(dict(enumerate(timed)), 0)

    tracked, doubted = TrackingResult(np.eye(4), "tracked"), TrackingResult(np.eye(4), "uncertain", ("far",))
    assert covered(10, [tracked]) == list(range(3, 13))
    assert covered(10, []) == covered(10, [doubted, tracked]) == []
    assert covered(20, [tracked]) == covered(10, [tracked], step=0.1) == [], "longer than half a second"
    assert covered(10, [dataclasses.replace(tracked, map=1)]) == []


def test_covered_frames_and_fixed_objects_are_notes(path):
    noted = dataclasses.replace(path, lost={1: BLANK}, covered=(1,), notes=("1 frames are blank",))
    assert noted.reliable and noted.to_dict()["notes"] == ["1 frames are blank"]
    assert not dataclasses.replace(path, lost={1: BLANK}).reliable
