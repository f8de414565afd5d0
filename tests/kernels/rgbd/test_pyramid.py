"""Pyramids of frames, brightness of a rendered model, and pixels of objects that moved."""

import numpy as np
import pytest

from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.kernels.lang import float32, uint8, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.rgbd.model_maps import colors_of
from pointloom.kernels.rgbd.moved_pixels import FreeSpace, hide_moved
from pointloom.kernels.rgbd.pyramid import NO_COLOR, level_sizes, make_levels
from pointloom.rgbd.odometry.frames import OdometryFrame

from ...registration.poses import as_pose


def levels_of(depth, device, *, shade=None, normals=None, max_pixels=10**6, lens=(50.0, 50.0, 15.5, 11.5), **options):
    height, width = depth.shape
    brightness = None if shade is None else upload(shade.reshape(-1), float32, device)
    numbers = {"max_pixels": max_pixels, "min_side": 4, "radius": 2}
    numbers["normals"] = None if normals is None else upload(normals.reshape(-1, 3), vec3, device)
    depths = upload(depth.reshape(-1), float32, device)
    return make_levels(depths, brightness, (width, height), lens, **numbers, **options)


def image(levels, values, k):
    (width, height), first = levels.sizes[k], int(levels.firsts[k])
    pixels = download(values)
    return pixels[first : first + width * height].reshape(height, width, *pixels.shape[1:])


def test_near_and_far_are_not_mixed(device):
    depth = np.full((24, 32), 1.0, np.float32)
    depth[:, 15:] = 3.0  # within a block of the next level
    levels = levels_of(depth, device)
    for k in range(levels.count):
        assert set(np.unique(image(levels, levels.depth, k)).round(5)) <= {1.0, 3.0}


def test_a_hole_does_not_grow(device):
    depth = np.full((24, 32), 2.0, np.float32)
    depth[9, 7] = depth[2, 20] = 0.0
    levels = levels_of(depth, device)
    assert np.allclose(image(levels, levels.depth, 1), 2.0)
    depth[8:10, 6:8] = 0.0
    levels = levels_of(depth, device)
    assert np.argwhere(image(levels, levels.depth, 1) == 0).tolist() == [[4, 3]]


def test_a_camera_keeps_the_borders_of_its_image():
    sizes, lenses, halvings = level_sizes(640, 480, (500.0, 510.0, 319.5, 239.5), 100_000, 24)
    assert sizes[0] == (320, 240) and halvings == 1
    for (width, height), (fx, fy, cx, cy) in zip(sizes, lenses, strict=True):
        assert np.allclose([(cx + 0.5) / width, (cy + 0.5) / height, fx / width], [0.5, 0.5, 500 / 640])
        assert np.isclose(fy / height, 510 / 480)


def test_planes_are_those_of_the_surface(device):
    v, u = np.mgrid[:24, :32]
    rays = np.stack([(u - 15.5) / 50, (v - 11.5) / 50, np.ones(u.shape)], -1)
    normal = np.array([0.3, -0.2, -0.9]) / np.linalg.norm([0.3, -0.2, -0.9])
    depth = (-1.5 / (rays @ normal)).astype(np.float32)
    levels = levels_of(depth, device)
    for k in range(2):
        planes = image(levels, levels.planes, k)[2:-2, 2:-2]  # whole windows
        assert np.abs(planes[..., :3] - normal).max() < 2e-3 and np.abs(planes[..., 3] + 1.5).max() < 3e-3


def test_a_plane_does_not_bridge_two_surfaces(device):
    depth = np.full((24, 32), 1.0, np.float32)
    depth[:, 16:] = 1.5
    levels = levels_of(depth, device)
    planes = image(levels, levels.planes, 0)
    valid = planes[planes[..., 3] != 0]
    assert np.abs(valid[:, :3] - [0, 0, -1]).max() < 1e-4


def test_given_normals_are_taken(device):
    depth = np.full((24, 32), 2.0, np.float32)
    normals = np.zeros((24, 32, 3), np.float32)
    normals[..., 2] = 1.5  # away from the camera, not of unit length: both are fixed
    normals[3, 4] = np.nan
    levels = levels_of(depth, device, normals=normals)
    planes = image(levels, levels.planes, 0)
    assert planes[3, 4].tolist() == [0, 0, 0, 0]
    assert np.abs(planes[5:, 5:] - [0, 0, -1, -2]).max() < 1e-5


def test_colors_are_weighed_as_brightness(device):
    pixels = np.tile(np.array([255, 0, 0], np.uint8), (24 * 32, 1))
    depth = upload(np.full(24 * 32, 1.0), float32, device)
    for max_pixels in (10**6, 500):
        numbers = {"max_pixels": max_pixels, "min_side": 4, "radius": 2}
        levels = make_levels(depth, upload(pixels, uint8, device), (32, 24), (50.0, 50.0, 15.5, 11.5), **numbers)
        assert np.allclose(download(levels.brightness), 0.299, atol=1e-6)


@pytest.mark.parametrize("size", [(8, 8), (33, 27), (32, 31), (47, 64), (9, 70)])
@pytest.mark.parametrize("max_pixels", [10**6, 900])
def test_a_level_is_the_mean_of_four_pixels_of_the_finer_one(device, rng, size, max_pixels):
    (width, height), shade = size, rng.random((size[1], size[0])).astype(np.float32)
    shade[rng.random(shade.shape) < 0.02] = NO_COLOR
    levels = levels_of(np.full((height, width), 2.0, np.float32), device, shade=shade, max_pixels=max_pixels)
    finer = shade
    for _ in range(level_sizes(width, height, (50.0, 50.0, 15.5, 11.5), max_pixels, 4)[2]):
        finer = halved(finer)
    for k in range(levels.count):
        np.testing.assert_allclose(image(levels, levels.brightness, k), finer, rtol=1e-6)
        assert np.allclose(image(levels, levels.depth, k), 2.0)
        finer = halved(finer)


def halved(shade):
    rows, columns = shade.shape[0] // 2, shade.shape[1] // 2
    four = shade[: 2 * rows, : 2 * columns].reshape(rows, 2, columns, 2)
    return np.where(four.min(axis=(1, 3)) < 0, np.float32(NO_COLOR), four.mean(axis=(1, 3)))


def test_invalid_depth_and_brightness_are_none(device):
    depth, shade = (np.full((8, 8), value, np.float32) for value in (2.0, 0.5))
    depth[0, :4] = shade[0, :4] = np.nan, np.inf, -1.0, 2.0e6
    levels = levels_of(depth, device, shade=shade)
    assert (image(levels, levels.depth, 0)[0, :4] == 0.0).all()
    assert (image(levels, levels.brightness, 0)[0, :4] == NO_COLOR).all()


def test_without_colors_there_is_no_brightness(device):
    levels = levels_of(np.full((24, 32), 1.0, np.float32), device)
    assert (download(levels.brightness) < 0).all()


@pytest.mark.parametrize("is_rendered", [False, True])
def test_a_rendered_image_has_no_brightness_without_depth(device, rng, is_rendered):
    depth, shade = np.full((24, 32), 1.0, np.float32), rng.random((24, 32)).astype(np.float32)
    depth[rng.random(depth.shape) < 0.2] = 0.0
    levels = levels_of(depth, device, shade=shade, is_rendered=is_rendered)
    expected = np.where((depth > 0) | (not is_rendered), shade, np.float32(NO_COLOR))
    np.testing.assert_array_equal(image(levels, levels.brightness, 0), expected)


def test_colors_are_rounded_to_nearest_even_bytes(device, rng):
    depth = np.float32([0, *np.ones(99)])
    colors = rng.random((100, 3)).astype(np.float32)
    colors[1:3] = [[0.5, 0.5, 0.5], [0.5 / 255, 1.5 / 255, 2.5 / 255]]
    pixels = colors_of(upload(depth, float32, device), upload(colors, vec3, device))
    scaled = 255 * colors.astype(np.float32)
    expected = np.rint(np.where(depth[:, None] > 0, scaled, np.float32(127.5)))
    np.testing.assert_array_equal(download(pixels), expected.astype(np.uint8))
    assert (scaled % 1 == 0.5).any()


CAMERA = PinholeCameraIntrinsic(64, 48, 60.0, 60.0, 31.5, 23.5)
WALL = 2.0  # [m]


def hidden(device, before, now, T=None, *more, camera=CAMERA):
    """Which pixels of `now` are hidden by the frame `before`, and by more of them."""
    frames = [OdometryFrame(frame.astype(np.float32), CAMERA, device=device) for frame in (before, *more)]
    depth = upload(now.astype(np.float32).reshape(-1), float32, device)
    views = [(FreeSpace(frame.levels), np.eye(4) if T is None else T) for frame in frames]
    filtered = download(hide_moved(depth, camera, views)).reshape(now.shape)
    assert ((filtered == now.astype(np.float32)) | (filtered == 0)).all()
    return (filtered == 0) & (now > 0)


def wall():
    return np.full((48, 64), WALL)


def with_box(column, depth=1.2):
    image = wall()
    image[10:40, column : column + 12] = depth
    return image


def test_new_objects_are_hidden_and_uncovered_surfaces_are_not(device):
    came = hidden(device, wall(), with_box(20))
    inner = np.zeros_like(came)
    inner[10:40, 20:32] = True
    assert np.array_equal(came, inner)
    assert not hidden(device, with_box(20), wall()).any()


def test_static_surfaces_stay(device):
    assert not hidden(device, with_box(20), with_box(20)).any()
    assert not hidden(device, wall(), wall() - 0.08).any(), "less than the margin"


def test_where_the_earlier_frame_saw_nothing_nothing_is_known(device):
    before = wall()
    before[:, 20:30] = 0
    moved = hidden(device, before, with_box(20))
    assert not moved[:, 19:31].any(), "nor beside it"
    assert moved[10:40, 31].all()


@pytest.mark.parametrize("shift", [-0.2, 0.2])
def test_the_earlier_camera_may_have_another_pose(device, shift):
    """A box that stays where it is falls on itself; one that came falls on the wall."""
    T = as_pose(shift=[shift, 0, 0])
    pixels = round(60 * shift / 1.2)
    assert not hidden(device, with_box(20 + pixels), with_box(20), T).any()
    assert hidden(device, wall(), with_box(20), T)[12:38, 22:30].all()


def test_pixels_outside_the_earlier_view_are_not_hidden(device):
    for shift in ([50.0, 0, 0], [0, 0, -5.0]):
        assert not hidden(device, wall(), with_box(20), as_pose(shift=shift)).any()


def test_either_of_two_earlier_frames_is_enough(device):
    """One saw the box, the other the wall behind it; pixels of an image of twice the size are tested in fours."""
    wide_camera = PinholeCameraIntrinsic(128, 96, 120.0, 120.0, 63.5, 47.5)
    now = np.kron(with_box(20), np.ones((2, 2)))
    for first, second in ((with_box(20), wall()), (wall(), with_box(20))):
        assert np.array_equal(hidden(device, first, now, None, second, camera=wide_camera), now < WALL)
