"""What tracking takes from a volume and gives to it with nothing on the host: rendered maps, frames on the device."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.lang import float32, uint8, uint16
from pointloom.kernels.memory import download, upload

from .tsdf_scenes import CAMERA, SMALL, TRUNCATION, VOXEL, fingerprint, look_at, plane_depth, rays_of, small_frames

WALL = np.array([0.0, 0.0, -1.0])
GREY = np.array([0.2990, 0.5870, 0.1140])


def painted_wall(device, *, color=True, origin=(0.0, 0.0, 0.0)):
    """A wall with a ramp of colour along x, seen from three places; and the brightness at world places."""

    def shade(points):
        x = (points[..., 0] - origin[0])[..., None]
        return np.clip(0.5 + x * [1.0, 0.5, -0.4], 0, 1)

    volume = loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, color=color, device=device)
    for eye in ((0, 0, -1.2), (0.1, 0.1, -1.1), (-0.1, 0.05, -1.15)):
        T = look_at(np.add(eye, origin), origin)
        depth = plane_depth(CAMERA, T, WALL, -origin[2])
        points = rays_of(CAMERA, T) * depth[..., None] + T[:3, 3]
        paint = np.round(255 * shade(points)).astype(np.uint8) if color else None
        volume.integrate(depth, CAMERA, np.linalg.inv(T), paint)
    return volume, lambda points: shade(points) @ GREY


def rendered(volume, T, **options):
    maps = volume.render_maps(CAMERA, T, weight_threshold=0, **options)
    shape = (CAMERA.height, CAMERA.width)
    intensity = None if maps.intensity is None else download(maps.intensity).reshape(shape)
    return download(maps.depth).reshape(shape), download(maps.normals).reshape(*shape, 3), intensity


@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (4e5, 5e6, 200.0)])
def test_rendered_maps_are_the_cast_picture_in_the_cameras_frame(device, origin):
    volume, _ = painted_wall(device, origin=origin)
    T = look_at(np.add((0.05, -0.1, -1.0), origin), np.add((0.3, 0.1, 0.0), origin))
    extrinsic = np.linalg.inv(T)
    depth, normals, _ = rendered(volume, np.linalg.inv(extrinsic))
    view = volume.ray_cast(CAMERA, extrinsic, weight_threshold=0)
    assert np.array_equal(depth, view.depth)
    both = np.isfinite(normals).all(-1) & np.isfinite(view.normals).all(-1)
    assert both.sum() > 10_000
    assert np.abs(normals - view.normals @ T[:3, :3])[both].max() < 1e-3
    assert (normals[both][:, 2] < 0).all(), "they point to the camera's side"
    assert np.isnan(normals[depth == 0]).all()


def test_rendered_brightness_is_that_of_the_surface_and_smooth(device):
    """Within half a grey step of 8-bit colours and a tenth of a voxel's; the nearest voxel's would be off by half."""
    volume, brightness = painted_wall(device)
    T = look_at((0.05, -0.1, -0.9))
    depth, normals, intensity = rendered(volume, T)
    truth = brightness(rays_of(CAMERA, T) * depth[..., None] + T[:3, 3])
    inner = np.isfinite(normals).all(-1)
    for shift in (-3, 3):
        inner &= np.roll(inner, shift, 0) & np.roll(inner, shift, 1)
    assert inner.sum() > 8000
    error = np.abs(intensity - truth)[inner]
    slope = 0.55  # of brightness a metre
    assert np.quantile(error, 0.99) < 0.3 * VOXEL * slope + 0.5 / 255
    assert not intensity[depth == 0].any()


def test_a_volume_without_colour_renders_no_brightness(device):
    volume, _ = painted_wall(device, color=False)
    depth, _, intensity = rendered(volume, look_at((0, 0, -1.0)))
    assert intensity is None
    assert (depth > 0).sum() > 10_000


def test_a_view_of_nothing_is_empty(device):
    volume = loom.TSDFVolume(voxel_size=VOXEL, device=device)
    depth, normals, intensity = rendered(volume, np.eye(4))
    assert not depth.any() and np.isnan(normals).all() and intensity is None
    volume, _ = painted_wall(device)
    assert not rendered(volume, np.eye(4), depth_max=0.2)[0].any()


def test_limits_of_a_rendered_view_are_checked(device):
    volume, _ = painted_wall(device)
    with pytest.raises(ValueError, match="depth_min"):
        volume.render_maps(CAMERA, np.eye(4), depth_min=2.0, depth_max=1.0)


@pytest.mark.parametrize("raw", [uint16, float32])
def test_a_frame_that_is_on_the_device_is_folded_like_any_other(device, rng, raw):
    a, b = (loom.TSDFVolume(voxel_size=VOXEL, truncation=TRUNCATION, device=device) for _ in range(2))
    for depth, T, color in small_frames(rng, 4):
        image, scale = ((depth * 1000).astype(np.uint16), 1000.0) if raw == uint16 else (depth.astype(np.float32), 1.0)
        E = np.linalg.inv(T)
        a.integrate(image, SMALL, E, color, depth_max=2.0)
        arrays = upload(image.reshape(-1), raw, b.device), upload(color.reshape(-1, 3), uint8, b.device)
        b.integrate_device_frame(arrays[0], SMALL, np.linalg.inv(E), arrays[1], scale, 2.0)
    assert a.frame_count == b.frame_count == 4
    assert fingerprint(a) == fingerprint(b)
