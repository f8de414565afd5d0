"""Color and depth of one moment: what comes twice, and what comes late, is told; what is right is not."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.slam.dense_slam import STALE, StreamLag

from .slam_walks import begun, blank, changed, fit, frames, verdicts, walk


def stalled(taken, first, last):
    """Frames of which some have the depth picture of the one before the first of them."""
    return [changed(f, depth=taken[first - 1].depth) if first <= k <= last else f for k, f in enumerate(taken)]


def test_a_depth_picture_that_came_before_is_rejected_under_colors_that_move(device):
    taken, slam = frames(*range(10)), begun(device)
    results = slam.run(stalled(taken, 2, 8))  # a thirtieth of a second each
    assert verdicts(results) == ["tracked"] * 5 + ["lost"] * 4 + ["tracked"]
    assert {r.warnings for r in results[5:9]} == {(STALE,)}
    assert not any(r.fused for r in results[5:9])


def test_without_times_three_frames_are_accepted():
    taken = [changed(f, timestamp=None) for f in frames(*range(8))]
    results = begun("cpu").run(stalled(taken, 2, 7))
    assert verdicts(results) == ["tracked"] * 5 + ["lost"] * 3


def test_a_frame_that_is_repeated_now_and_then_is_accepted():
    taken = frames(*range(8))
    results = begun("cpu").run(stalled(stalled(taken, 2, 2), 5, 6))
    assert all(fit(results)) and len(results) == 8


def test_frames_that_repeat_whole_are_a_camera_that_stands_still(device):
    slam = begun(device)
    first = changed(frames(0)[0], timestamp=None)
    assert verdicts(slam.run([first] * 5)) == ["tracked"] * 5


def test_colors_that_are_only_noisy_do_not_move(device):
    slam, first = begun(device), changed(frames(0)[0], timestamp=None)
    rng = np.random.default_rng(1)

    def noisy(f):
        return changed(f, color=np.clip(f.color + rng.normal(0, 3, f.color.shape), 0, 255).astype(np.uint8))

    assert verdicts(slam.run([noisy(first) for _ in range(5)])) == ["tracked"] * 5


def test_a_lens_that_stays_covered_is_blank_and_no_stall(device):
    taken, slam = frames(*range(6)), begun(device)
    moving = [taken[0], *(changed(f, depth=blank(f).depth) for f in taken[1:])]
    assert [r.warnings for r in slam.run(moving)[1:]] == [("the image is blank",)] * 5


def trembling(count: int, late: int, seed: int = 0, period: float | None = None) -> StreamLag:
    """A StreamLag of a hand-held camera whose colors come so many frames late; half of each shift is noise."""
    rng, lag = np.random.default_rng(seed), StreamLag()
    shake = rng.normal(size=(count + 200, 2)) + 3 * np.sin(np.arange(count + 200) / 40)[:, None]
    noise = 0.5 * rng.normal(size=(2, count, 2))
    for k in range(count):
        time = None if period is None else period * k
        lag.add(shake[100 + k - late] + noise[0, k], 0.3 * (shake[100 + k] + noise[1, k]), time)
    return lag


@pytest.mark.parametrize("late", [5, 15, 30, -5, -30])
def test_colors_that_come_late_or_early_are_told_with_the_time(late):
    lag = trembling(90, late, period=1 / 30)
    assert lag.frames == late and math.isclose(lag.seconds, abs(late) / 30)
    assert trembling(90, late).frames == late


@pytest.mark.parametrize("late", [0, 1, 3, -3])
def test_a_tenth_of_a_second_is_accepted(late):
    for seed in range(5):
        assert trembling(200, late, seed).frames is None
        assert trembling(200, late, seed, period=1 / 30).frames is None


def test_few_slow_frames_apart_are_told_by_their_times():
    assert trembling(90, 3, period=1 / 6).frames == 3, "half a second"
    assert trembling(90, 2, period=1 / 30).frames is None


def test_pictures_that_have_nothing_in_common_tell_nothing():
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
    taken, slam = frames(*range(4)), begun(device)
    slam.run(taken[:3])
    slam.stream.lag.frames, slam.stream.lag.seconds = 30, 1.0
    result = slam.step(taken[3])
    said = "color and depth appear to be 1.0 s apart in time"
    assert (result.status, result.warnings, result.fused) == ("uncertain", (said,), False)
    slam.stream.lag.seconds = math.nan
    assert slam.stream.problem == "color and depth appear to be 30 frames apart in time"


def test_a_path_whose_streams_are_apart_is_unreliable():
    path = loom.track(loom.frames_from([(f.color, f.depth) for f in frames(0, 1)], walk().intrinsic), voxel_size=0.04)
    assert path.stream is None and path.reliable
    said = "color and depth appear to be 1.0 s apart in time"
    apart = dataclasses.replace(path, stream=said, uncertain=(0, 1), uncertain_warning=said)
    assert apart.warnings == (said, "2 of 2 poses are uncertain (frame 0-1)")
    assert apart.to_dict()["stream"] == said
    slides = dataclasses.replace(path, uncertain=(0, 1), uncertain_warning="it may slide")
    assert "(frame 0-1): it may slide" in slides.warnings[0]
