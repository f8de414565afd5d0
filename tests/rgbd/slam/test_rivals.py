"""Similar locations: a pose that fits better than its rivals is accepted, others are uncertain."""

import dataclasses
from functools import cache

import numpy as np
import pytest

import pointloom as loom
from pointloom.rgbd.slam.frame_checks import SURE_OVERLAP, fits_worse, judge_recognition
from pointloom.rgbd.slam.tracker import find_rivals

from .slam_walks import begun, blank, changed
from .slam_walks import frame as room_frame
from .test_frame_checks import GOOD

WIDTH, HEIGHT, PERIOD = 80, 60, 0.5
CAMERA = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 66.0, 66.0, 39.5, 29.5)
STEP = 0.05  # [m] per frame along the wall


@cache
def wall_frame(number: int, has_texture: bool):
    """A wall with identical pillars every half meter, seen by a camera that moves along it."""
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    x, y = (u - CAMERA.cx) / CAMERA.fx, (v - CAMERA.cy) / CAMERA.fy
    at, depth = STEP * number, np.full(x.shape, 1.6)
    for wanted in (1.6, 1.3):  # the wall, then the pillars before it, whose sides are not visible
        along = (at + wanted * x) % PERIOD
        is_there = (along < 0.2) & (np.abs(wanted * y) < 0.35) if wanted < 1.6 else np.ones_like(x, bool)
        depth = np.where(is_there, wanted + 0.1 * np.sin(2 * np.pi * along / 0.2) * (wanted < 1.6), depth)
    depth += 0.1 * np.sin(9 * depth * y)
    position = at + depth * x
    shade = 120 + has_texture * (60 * np.sin(7.3 * position) + 25 * np.sin(19.1 * position + 3 * y))
    pose = np.eye(4)
    pose[0, 3] = at
    color = np.repeat(shade[..., None], 3, 2).clip(0, 255).astype(np.uint8)
    made = dataclasses.make_dataclass("Frame", ["depth", "color", "T_world_camera", "timestamp", "name"])
    return made(depth.astype(np.float32), color, pose, number / 5.0, str(number))


@cache
def covered_sequence(device: str, has_texture: bool):
    """The results of a sequence in which the camera moves by one pillar while it is covered."""
    shown = [wall_frame(number, has_texture) for number in range(24)]
    source = [blank(frame) if 12 <= int(frame.name) < 21 else frame for frame in shown]
    slam = loom.rgbd.DenseSLAM(CAMERA, voxel_size=0.03, device=device)
    return slam.run(source), slam


@pytest.mark.slow
def test_a_similar_location_is_never_accepted_wrongly(device):
    for has_texture in (False, True):
        results, _ = covered_sequence(device, has_texture)
        assert all(r.fused for r in results[:12])
        for result in results[21:]:
            if result.status == "tracked":
                assert abs(result.pose[0, 3] - STEP * result.index) < 0.05


def test_ambiguous_frames_without_texture_are_uncertain_and_not_fused(device):
    results, _ = covered_sequence(device, False)
    assert [r.status for r in results[21:]] == ["uncertain"] * 3
    assert "away fits equally well" in results[21].warnings[0] and not any(r.fused for r in results[21:])


def test_rivals_of_a_wall_of_like_pillars_are_a_pillar_away(device):
    _, slam = covered_sequence(device, False)
    shown = wall_frame(8, False)
    rivals = find_rivals(slam.model, slam.model.prepare(shown).pyramid, shown.T_world_camera)
    offs = [abs(rival[0, 3] - shown.T_world_camera[0, 3]) for rival in rivals]
    assert any(abs(distance - PERIOD) < 0.1 for distance in offs)
    again = find_rivals(slam.model, slam.model.prepare(shown).pyramid, shown.T_world_camera)
    assert all(np.array_equal(a, b) for a, b in zip(rivals, again, strict=True))


def test_a_frame_without_depth_has_no_rivals(device):
    slam = loom.rgbd.DenseSLAM(CAMERA, voxel_size=0.03, device=device)
    slam.step(wall_frame(0, False))
    hole = changed(wall_frame(0, False), depth=np.zeros((HEIGHT, WIDTH), np.float32))
    assert find_rivals(slam.model, slam.model.prepare(hole).pyramid, np.eye(4)) == []


@pytest.mark.parametrize(("noise", "expected"), [(10, "tracked"), (80, "lost")])  # [of 255]
def test_a_relocalization_with_unusual_brightness_is_rejected(noise, expected):
    source, rng = [changed(room_frame(k), timestamp=None) for k in range(14)], np.random.default_rng(0)
    color = source[8].color + rng.normal(0, noise, source[8].color.shape)
    back = changed(source[8], color=color.clip(0, 255).astype(np.uint8))
    *_, result = begun("cpu").run([*source, *[blank(source[0])] * 8, back])
    assert (result.status, result.relocalized) == (expected, expected == "tracked")
    assert expected == "tracked" or result.warnings[0].startswith("its brightness residual is")


@pytest.mark.parametrize(("usual", "expected"), [(0.004, "lost"), (0.01, "tracked"), (float("nan"), "tracked")])
def test_a_relocalization_far_off_the_model_is_rejected(usual, expected):
    status, _ = judge_recognition(dataclasses.replace(GOOD, inlier_rmse=0.015), SURE_OVERLAP, float("nan"), usual)
    assert status == expected


@pytest.mark.parametrize(
    ("change", "is_worse"),
    [
        ({}, False),
        ({"intensity_rmse": 0.05}, True),
        ({"intensity_rmse": 0.018}, False),
        ({"fitness": 0.45}, True),
        ({"fitness": 0.45, "overlap": 0.5}, False),  # it shows less, and fits that as well
        ({"warnings": ("in free space of the target",), "overlap": 0.1, "fitness": 0.09}, False),
        ({"warnings": ("in free space of the target",)}, True),
    ],
)
def test_a_rival_is_rejected_by_contradictions_not_by_missing_data(change, is_worse):
    assert fits_worse(dataclasses.replace(GOOD, **change), GOOD) == is_worse
