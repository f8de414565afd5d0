"""Pyramids of frames: near and far are not mixed, holes do not grow, pixels keep their positions, planes are right."""

import numpy as np

from pointloom.kernels.lang import float32, uint8, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.rgbd.pyramid import level_sizes, make_levels


def levels_of(depth, device, *, shade=None, normals=None, max_pixels=10**6, lens=(50.0, 50.0, 15.5, 11.5)):
    height, width = depth.shape
    brightness = None if shade is None else upload(shade.reshape(-1), float32, device)
    numbers = {"max_pixels": max_pixels, "min_side": 4, "radius": 2}
    numbers["normals"] = None if normals is None else upload(normals.reshape(-1, 3), vec3, device)
    return make_levels(upload(depth.reshape(-1), float32, device), brightness, width, height, lens, **numbers)


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
        assert np.abs(planes[..., :3] - normal).max() < 2e-3
        assert np.abs(planes[..., 3] + 1.5).max() < 3e-3


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
        levels = make_levels(depth, upload(pixels, uint8, device), 32, 24, (50.0, 50.0, 15.5, 11.5), **numbers)
        assert np.allclose(download(levels.brightness), 0.299, atol=1e-6)


def test_without_colors_there_is_no_brightness(device):
    levels = levels_of(np.full((24, 32), 1.0, np.float32), device)
    assert (download(levels.brightness) < 0).all()
