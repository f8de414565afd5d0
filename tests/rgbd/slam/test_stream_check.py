"""Synchronization of color and depth: repeated and delayed images are reported, correct ones are not."""

import dataclasses
import math

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.slam.dense_slam import STALE, StreamLag

from .slam_walks import begun, blank, changed, fit, frames, sequence, statuses


def stalled(source, first, last):
    """Frames, some of which repeat the depth image of an earlier frame."""
    return [changed(f, depth=source[first - 1].depth) if first <= k <= last else f for k, f in enumerate(source)]


def test_a_repeated_depth_image_is_rejected_if_colors_change(device):
    source, slam = frames(*range(10)), begun(device)
    results = slam.run(stalled(source, 2, 8))  # 1/30 s each
    assert statuses(results) == ["tracked"] * 5 + ["lost"] * 4 + ["tracked"]
    assert {r.warnings for r in results[5:9]} == {(STALE,)}
    assert not any(r.fused for r in results[5:9])


def test_without_times_three_frames_are_accepted():
    source = [changed(f, timestamp=None) for f in frames(*range(8))]
    results = begun("cpu").run(stalled(source, 2, 7))
    assert statuses(results) == ["tracked"] * 5 + ["lost"] * 3


def test_a_frame_that_is_repeated_now_and_then_is_accepted():
    source = frames(*range(8))
    results = begun("cpu").run(stalled(stalled(source, 2, 2), 5, 6))
    assert all(fit(results)) and len(results) == 8


def test_repeated_frames_are_a_stationary_camera(device):
    slam = begun(device)
    first = changed(frames(0)[0], timestamp=None)
    assert statuses(slam.run([first] * 5)) == ["tracked"] * 5


def test_colors_that_are_only_noisy_do_not_move(device):
    slam, first = begun(device), changed(frames(0)[0], timestamp=None)
    rng = np.random.default_rng(1)

    def noisy(f):
        return changed(f, color=np.clip(f.color + rng.normal(0, 3, f.color.shape), 0, 255).astype(np.uint8))

    assert statuses(slam.run([noisy(first) for _ in range(5)])) == ["tracked"] * 5


def test_a_covered_lens_is_blank_and_no_stalled_stream(device):
    source, slam = frames(*range(6)), begun(device)
    moving = [source[0], *(changed(f, depth=blank(f).depth) for f in source[1:])]
    assert [r.warnings for r in slam.run(moving)[1:]] == [("the image is blank",)] * 5


def trembling(count: int, late: int, seed: int = 0, period: float | None = None) -> StreamLag:
    """A StreamLag of a hand-held camera whose colors are delayed by this many frames; half of each shift is noise."""
    rng, lag = np.random.default_rng(seed), StreamLag()
    shake = rng.normal(size=(count + 200, 2)) + 3 * np.sin(np.arange(count + 200) / 40)[:, None]
    noise = 0.5 * rng.normal(size=(2, count, 2))
    for k in range(count):
        time = None if period is None else period * k
        lag.add(shake[100 + k - late] + noise[0, k], 0.3 * (shake[100 + k] + noise[1, k]), time)
    return lag


@pytest.mark.parametrize("late", [5, 15, 30, -5, -30])
def test_delayed_or_early_colors_are_reported_with_the_delay(late):
    lag = trembling(90, late, period=1 / 30)
    assert lag.frames == late and math.isclose(lag.seconds, abs(late) / 30)
    assert trembling(90, late).frames == late


@pytest.mark.parametrize("late", [0, 1, 3, -3])
def test_a_tenth_of_a_second_is_accepted(late):
    for seed in range(5):
        assert trembling(200, late, seed).frames is None
        assert trembling(200, late, seed, period=1 / 30).frames is None


def test_few_slow_frames_apart_are_detected_by_their_times():
    assert trembling(90, 3, period=1 / 6).frames == 3, "half a second"
    assert trembling(90, 2, period=1 / 30).frames is None


def test_unrelated_images_give_no_delay():
    for seed in range(20):
        rng, lag = np.random.default_rng(seed), StreamLag()
        for _ in range(150):
            lag.add(rng.normal(size=2), rng.normal(size=2), None)
        assert lag.frames is None


def test_frames_without_a_shift_are_left_out():
    rng, lag = np.random.default_rng(3), StreamLag()
    shake = rng.normal(size=(150, 2))
    for k in range(20, 140):
        lag.add(shake[k - 20], np.full(2, np.nan) if k % 3 == 0 else shake[k], None)
    assert lag.frames == 20


def test_reported_frames_are_uncertain_and_make_the_path_unreliable(device):
    source, slam = frames(*range(4)), begun(device)
    slam.run(source[:3])
    slam.stream.lag.frames, slam.stream.lag.seconds = 30, 1.0
    result = slam.step(source[3])
    message = "color and depth appear to be 1.0 s apart in time"
    assert (result.status, result.warnings, result.fused) == ("uncertain", (message,), False)
    slam.stream.lag.seconds = math.nan
    assert slam.stream.problem == "color and depth appear to be 30 frames apart in time"


def test_a_path_with_unsynchronized_streams_is_unreliable():
    path = loom.track(
        loom.frames_from([(f.color, f.depth) for f in frames(0, 1)], sequence().intrinsic), voxel_size=0.04
    )
    assert path.stream is None and path.reliable
    message = "color and depth appear to be 1.0 s apart in time"
    apart = dataclasses.replace(path, stream=message, uncertain=(0, 1), uncertain_warning=message)
    assert apart.warnings == (message, "2 of 2 poses are uncertain (frame 0-1)")
    assert apart.to_dict()["stream"] == message
    slides = dataclasses.replace(path, uncertain=(0, 1), uncertain_warning="it may slide")
    assert "(frame 0-1): it may slide" in slides.warnings[0]
