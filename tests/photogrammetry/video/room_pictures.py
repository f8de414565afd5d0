"""Pictures of the demo's room by a distorted lens, and spherical pictures."""

import numpy as np

import pointloom as loom
from pointloom.cameras.panoramas import Panorama
from pointloom.datasets.scenes.room import room_views


def sampled(picture, x, y) -> np.ndarray:
    """Colors between pixels, float64 [n, 3]."""
    i, j = (np.clip(np.floor(at).astype(int), 0, picture.shape[axis] - 2) for at, axis in ((x, 1), (y, 0)))
    fx, fy = np.clip(x - i, 0, 1)[:, None], np.clip(y - j, 0, 1)[:, None]
    upper, lower = ((picture[row, i] * (1 - fx) + picture[row, i + 1] * fx) for row in (j, j + 1))
    return upper * (1 - fy) + lower * fy


def as_picture(light, noise_seed, shape) -> np.ndarray:
    noisy = light + np.random.default_rng(noise_seed).normal(0, 2, light.shape)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8).reshape(*shape, 3)


def fisheye_pictures(poses, camera, *, finer=1.5) -> list[np.ndarray]:
    """Pictures by a CameraModel that unprojects all its pixels, sampled from a pinhole's, `finer` times as dense."""
    v, u = np.mgrid[: camera.height, : camera.width].reshape(2, -1)
    rays = np.asarray(camera.unproject(np.column_stack([u, v]).astype(np.float64)))
    assert np.isfinite(rays).all(), "the lens does not unproject all its pixels"
    slopes = rays[:, :2] / rays[:, 2:]
    focal = finer * float(camera.params[0])
    width, height = (int(2 * np.ceil(1.02 * extent * focal)) for extent in np.abs(slopes).max(axis=0))
    wide = loom.PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    x, y = (slopes * focal + (wide.cx, wide.cy)).T
    frames = room_views(poses, wide, color_noise=0)
    shape = (camera.height, camera.width)
    return [as_picture(sampled(frame.color.astype(np.float64), x, y), k, shape) for k, frame in enumerate(frames)]


def spheres_from(poses, height=256, *, finer=2) -> list[np.ndarray]:
    """Equirectangular pictures, uint8 [height, 2 height, 3], sampled from six pinholes, `finer` times as dense."""
    faces = Panorama(2 * height, height, side=finer * height // 2)
    lens = faces.intrinsic
    v, u = np.mgrid[:height, : 2 * height].reshape(2, -1)
    longitude, latitude = (u + 0.5) / height * np.pi - np.pi, np.pi / 2 - (v + 0.5) / height * np.pi
    across = np.cos(latitude)
    rays = np.column_stack([across * np.sin(longitude), -np.sin(latitude), across * np.cos(longitude)])
    nearest = np.stack([rays @ rotation[:, 2] for rotation in faces.turns]).argmax(axis=0)
    made = []
    for k, pose in enumerate(np.asarray(poses)):
        light = np.zeros((len(u), 3))
        for n, rotation in enumerate(faces.turns):
            T = np.array(pose, np.float64)
            T[:3, :3] = pose[:3, :3] @ rotation
            face = next(iter(room_views([T], lens, color_noise=0))).color.astype(np.float64)
            x, y, z = (rays[nearest == n] @ rotation).T
            light[nearest == n] = sampled(face, x / z * lens.fx + lens.cx, y / z * lens.fy + lens.cy)
        made.append(as_picture(light, k, (height, 2 * height)))
    return made
