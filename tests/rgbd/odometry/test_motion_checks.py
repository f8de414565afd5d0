"""Pairs of different locations or with an ambiguous motion fail without an exception; each limit counts."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.rgbd import check_rows as at
from pointloom.kernels.rgbd.alignment import Alignment
from pointloom.rgbd.odometry.motion_checks import _first_fault

from .made_frames import BALL, CAMERA, errors_of, frame, image, pose_of

od = loom.rgbd
HERE = pose_of([0, 0, 0], [0, 0, 0])


def half(depth, side):
    """The image with one side only."""
    half_depth, middle = depth.copy(), depth.shape[1] // 2
    half_depth[:, middle:] = np.where(side == "left", 0, half_depth[:, middle:])
    half_depth[:, :middle] = np.where(side == "right", 0, half_depth[:, :middle])
    return half_depth


def plane(rng, tilt, color=None):
    """A noisy image of a flat wall."""
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    depth = 1.5 / (1 + tilt * (u - CAMERA.cx) / CAMERA.fx)
    depth = depth + 0.004 * rng.standard_normal(depth.shape)
    shade = np.full(depth.shape, 120.0) if color is None else color(u, v)
    return depth.astype(np.float32), (shade + 3 * rng.standard_normal(depth.shape)).clip(0, 255).astype(np.uint8)


@pytest.mark.parametrize("blank", ["source", "target", "both"])
def test_a_blank_frame_is_no_success(device, blank):
    depth, color = image(HERE)
    empty = od.OdometryFrame(np.zeros_like(depth), CAMERA, np.zeros_like(color), device=device)
    full = od.OdometryFrame(depth, CAMERA, color, device=device)
    result = od.align_frames(*{"source": (empty, full), "target": (full, empty), "both": (empty, empty)}[blank])
    assert not result.reliable and result.warnings


def test_two_different_image_halves_are_no_success(device):
    depth, color = image(HERE)
    frames = [od.OdometryFrame(half(depth, side), CAMERA, color, device=device) for side in ("left", "right")]
    assert not od.align_frames(*frames).reliable


def test_two_equal_image_halves_are_enough(device):
    depth, color = image(HERE)
    one = od.OdometryFrame(half(depth, "left"), CAMERA, color, device=device)
    result = od.align_frames(one, one)
    assert result.reliable and np.abs(result.transformation - np.eye(4)).max() < 1e-4


@pytest.mark.parametrize("angle", [1.2, 1.6, 2.4, 3.1])
def test_views_of_other_locations_are_no_success(device, angle):
    other = frame(pose_of([0.1, angle, 0.0], [0.2, 0.0, -0.3]), device, noise=1.0, seed=1)
    assert not od.align_frames(frame(HERE, device, noise=1.0), other).reliable


@pytest.mark.parametrize("method", ["point-to-plane", "intensity", "hybrid"])
@pytest.mark.parametrize("tilt", [0.0, 0.6])
def test_a_wall_without_texture_is_no_success(device, rng, method, tilt):
    frames = [od.OdometryFrame(d, CAMERA, c, device=device) for d, c in (plane(rng, tilt), plane(rng, tilt))]
    result = od.align_frames(*frames, method=method)
    assert not result.reliable
    assert method == "intensity" or "determine" in result.warnings[0]  # it drifts off the surface without one


def test_a_wall_with_texture_is(device, rng):
    def pattern(u, v, shift=0):
        return 120 + 60 * np.sin((u + shift) / 4.0) * np.cos(v / 5.0) + 30 * np.cos((u + shift) / 9.0 + v / 7.0)

    images = plane(rng, 0.2, pattern), plane(rng, 0.2, lambda u, v: pattern(u, v, 2))
    frames = [od.OdometryFrame(depth, CAMERA, color, device=device) for depth, color in images]
    assert od.align_frames(*frames).reliable


def test_a_wrong_camera_is_detected_by_the_residual(device):
    wrong = loom.PinholeCameraIntrinsic(CAMERA.width, CAMERA.height, 110.0, 110.0, 70.0, 66.0)
    poses = HERE, pose_of([0.04, -0.12, 0.06], [0.15, 0.05, 0.1])
    images = [image(pose, noise=0.5, seed=k) for k, pose in enumerate(poses)]
    rmse = []
    for camera in (CAMERA, wrong):
        frames = [od.OdometryFrame(depth, camera, color, device=device) for depth, color in images]
        rmse.append(od.align_frames(*frames).inlier_rmse)
    assert rmse[1] > 1.5 * rmse[0]


def test_a_moving_object_does_not_affect_the_camera_pose(device):
    images = [image(HERE, ball=BALL + shift) for shift in ([0, 0, 0], [0.15, 0, 0])]
    result = od.align_frames(*[od.OdometryFrame(depth, CAMERA, color, device=device) for depth, color in images])
    angle, distance = errors_of(result.transformation, np.eye(4))
    assert result.reliable and angle < 0.3 and distance < 8


def fault_of(*, blur=0.0, **sums):
    """The fault of a pair of 1,000 pixels, 900 with depth and 800 on the surface, with other sums."""
    figures = np.zeros(at.EXCESS_SUM + 1)
    good = {"PIXEL_COUNT": 1000, "SEEN_COUNT": 900, "INLIER_COUNT": 800, "IN_FRONT_COUNT": 10}
    good |= {"NORMAL_COUNT": 800, "AGREEING_COUNT": 780, "PLANE_COUNT": 800}
    for name, value in (good | {"EXCESS_SUM": 800.0} | sums).items():
        figures[getattr(at, name)] = value
    none = np.zeros(21)
    alignment = Alignment(np.eye(4), 5, np.ones(4), none, figures, none, none, 0)
    return _first_fault(alignment, *(figures[k] for k in (at.PIXEL_COUNT, at.SEEN_COUNT, at.INLIER_COUNT)), blur)


@pytest.mark.parametrize(
    ("sums", "fault"),
    [
        ({}, ""),
        ({"PIXEL_COUNT": 0}, "the source has no depth"),
        ({"SEEN_COUNT": 200, "INLIER_COUNT": 180}, "only 20% of the source pixels overlap with depth of the target"),
        ({"INLIER_COUNT": 450}, "only 50% of the overlapping pixels agree with the target's surface"),
        ({"IN_FRONT_COUNT": 180}, "20% of the source pixels are in space that the target observed as free"),
        ({"AGREEING_COUNT": 640}, "only 80% of the normals agree"),
        ({"EXCESS_SUM": 12_800.0}, "the surface residual is 4.0 times the depth noise"),
    ],
)
def test_each_sum_counts(sums, fault):
    assert fault_of(**sums) == fault


def test_target_blur_counts_as_noise():
    """Surface distances 4 times noise of 2 mm: a target blurred by 4 mm increases them by the root of 5."""
    sums = {"EXCESS_SUM": 12_800.0, "DISTANCE_SQUARES": 12_800.0 * 0.002**2}
    assert "4.0 times the depth noise" in fault_of(**sums) and fault_of(**sums, blur=0.004) == ""
    assert "3.6 times the depth noise" in fault_of(**sums, blur=0.001)
