"""Checks of depth camera images without motion: registration of color to depth, the depth unit, the principal point."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.cameras.frame_check import FrameCheck, depth_step, why_implausible

from ..products import few_quick

CAMERA = loom.PinholeCameraIntrinsic(320, 240, 262.5, 262.5, 159.5, 119.5)
FLIPS = {"mirrored left-right": (1, -1), "mirrored upside down": (-1, 1), "rotated by 180 degrees": (-1, -1)}


def images(seed, scale=1.0, shift=(0.0, 0.0), contrast=1.0):
    """Depth [mm] and color of overlapping rectangles; color has another focal length and principal point."""
    rng = np.random.default_rng(seed)
    depth, color = np.full((240, 320), 4000, np.uint16), np.full((240, 320, 3), 120.0)
    for z in np.sort(rng.uniform(800, 3500, 25))[::-1]:
        low = rng.uniform(-20, [300, 220])
        high, shade = low + rng.uniform(25, 90, 2), contrast * rng.uniform(-100, 100)
        for out, k, d, value in ((depth, 1.0, (0.0, 0.0), z), (color, scale, shift, 120 + shade)):
            (u, v), (u1, v1) = (np.rint((p - (159.5, 119.5)) * k + (159.5, 119.5) + d).astype(int) for p in (low, high))
            out[max(v, 0) : max(v1, 0), max(u, 0) : max(u1, 0)] = value
    return depth, np.clip(color + rng.normal(0, 2, color.shape), 0, 255).astype(np.uint8)


def warnings_of(frames, depth_scale=1000.0, camera=CAMERA):
    check = FrameCheck(camera, depth_scale)
    for depth, color in frames:
        check.add(depth, color)
    return (*check.warnings, *check.notes)


@few_quick(1, "kind", [np.uint8, np.float32, "gray"])
def test_registered_images_have_no_warning(kind):
    for seed in range(4):
        frames = [images(4 * seed + k) for k in range(4)]
        if kind == "gray":
            frames = [(z, c[..., 0]) for z, c in frames]
        elif kind == np.float32:
            frames = [(z.astype(np.float32) / 1000, c.astype(np.float32) / 255) for z, c in frames]
        assert warnings_of(frames) == ()


@pytest.mark.parametrize("kind", FLIPS)
@pytest.mark.parametrize("is_depth", [False, True])
def test_a_flipped_image_is_named(kind, is_depth):
    rows, columns = FLIPS[kind]
    frames = [images(k) for k in range(4)]
    flipped = [
        (z[::rows, ::columns], c) if is_depth else (z, c[::rows, ::columns]) for z, c in frames
    ]  # fmt: skip
    (warning,) = warnings_of(flipped)
    assert warning.startswith(
        f"color and depth are not registered: the edges of depth fit the color image if they are {kind}"
    )


@pytest.mark.parametrize(("scale", "shift"), [(0.9, (4, 0)), (0.74, (0, 0)), (1.25, (-6, 0)), (1.0, (12, 2))])
def test_color_of_another_camera_is_reported(scale, shift):
    (warning,) = warnings_of([images(k, scale, shift) for k in range(6)])
    assert f"scaled by {scale:.2g}" in warning if scale != 1.0 else f"shifted by {shift[0]}, " in warning


@pytest.mark.parametrize(("scale", "is_severe"), [(0.9, False), (0.8, True)])
def test_a_small_scale_is_a_note(scale, is_severe):
    check = FrameCheck(CAMERA, 1000.0)
    for k in range(6):
        check.add(*images(k, scale))
    assert (len(check.warnings), len(check.notes)) == (is_severe, not is_severe)


def test_small_shifts_and_images_without_edges_are_not_reported():
    assert warnings_of([images(k, 1.0, (4, 2)) for k in range(6)]) == ()
    assert warnings_of([images(k, 0.9, contrast=0.0) for k in range(6)]) == ()
    assert warnings_of([(np.full((240, 320), 1000, np.uint16), images(0)[1])] * 6) == ()
    assert warnings_of([]) == warnings_of([(images(0)[0], None)]) == ()


@pytest.mark.slow
def test_frames_of_a_long_stream_are_sampled():
    check = FrameCheck(CAMERA, 1000.0)
    for k in range(100):
        z, c = images(k % 5)
        check.add(z, c if k < 10 else c[:, ::-1])
    assert "mirrored left-right" in check.warnings[0]


def structured_light(units, step=0.0029):
    """Depth whose inverse is a multiple of `step`, in units per meter."""
    nearness = np.arange(60, 400) * step
    return np.tile(np.rint(units / nearness), 100)[: 240 * 140].reshape(240, 140).astype(np.uint16)


@pytest.mark.parametrize("step", [0.0027, 0.0036])
@pytest.mark.parametrize(("units", "given"), [(1000, 5000), (5000, 1000), (1000, 4000)])
def test_the_unit_of_structured_light_is_reported(step, units, given):
    (warning,) = warnings_of([(structured_light(units, step), None)] * 3, given)
    assert warning.endswith(f"not with {given}; pass depth_scale={units}")
    assert warnings_of([(structured_light(units, step), None)] * 3, units) == ()


def test_other_sensors_have_no_unit():
    rng = np.random.default_rng(3)
    assert np.isnan(depth_step(rng.integers(500, 4000, (240, 320)).astype(np.uint16)))
    assert np.isnan(depth_step(np.full((240, 320), 1000, np.uint16)))
    stereo = [(structured_light(1000, 0.0012), None)] * 3
    assert warnings_of(stereo) == ()
    wide = loom.PinholeCameraIntrinsic(1280, 720, 930, 930, 640, 360)
    assert warnings_of([(structured_light(1000, 0.0006), None)] * 3, camera=wide) == ()


def test_steps_of_depth_do_not_depend_on_the_integer_type():
    depth = structured_light(1000)
    assert depth_step(depth) == depth_step(depth.astype(np.int32)) > 0


def test_a_camera_of_other_images_is_reported():
    assert why_implausible(CAMERA) == ""
    swapped = loom.PinholeCameraIntrinsic(640, 480, 525, 525, 239.5, 319.5)
    assert why_implausible(swapped).endswith("images of 640 x 480; cx and cy may be swapped")
    larger = loom.PinholeCameraIntrinsic(640, 480, 1050, 1050, 639.5, 479.5)
    assert why_implausible(larger).endswith("it may be for 1279 x 959")
    assert "field of view" in why_implausible(loom.PinholeCameraIntrinsic(640, 480, 9000, 9000, 319.5, 239.5))
