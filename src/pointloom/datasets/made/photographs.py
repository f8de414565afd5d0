"""Synthetic photographs of the owl on a patterned cloth, for structure from motion, stereo and texturing."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic
from ...core.checks import check_count, check_seed
from ...kernels.lang import float32, uint8
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import download, upload
from ...kernels.scenes.color_noise import measure_colors
from ...kernels.scenes.value_noise import grain_pixels
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.scene.raycasting_scene import RaycastingScene
from ..array_cache import Arrays, cached
from .objects import object_mesh
from .results import PosedImages
from .views import MeshView, ring, scene_of, view_mesh

PHOTO_CAMERA = PinholeCameraIntrinsic(640, 480, 720.0, 720.0, 319.5, 239.5)
CAMERA_DISTANCE = 0.62  # [m]
CAMERA_ELEVATIONS = (math.radians(22), math.radians(34))  # elevations of the camera, alternating
CLOTH_SIDE, CLOTH_STEP, CHECK_SIDE = 0.8, 0.01, 0.06  # [m] side of the cloth, of its cells, of its pattern's squares
GRAIN_SCALE = 10.0  # the room texture of 12 cm to 15 mm becomes 12 to 1.5 mm
COLOR_NOISE = 1.0  # [of 255] standard deviation, as of a photograph in good light
LIGHT_DIRECTION = np.array([0.45, -0.55, 0.7]) / norm([0.45, -0.55, 0.7])
AMBIENT_LIGHT = 0.55
SHADOW_OFFSET = 0.0008  # [m] offset of shadow rays from the surface


def photographs(count: int = 12, *, seed: int = 0) -> PosedImages:
    """Synthetic photographs of the owl of `object_mesh` on a checkered cloth, from all sides.

    The light is fixed. The camera circles once at 0.62 m from the center, alternating between 22 and 34 degrees above.
    All surfaces have texture down to 1.5 mm.

    Args:
        count: Number of images, evenly spaced: 12 are 30 degrees apart. Feature matching needs 20 degrees or less.
        seed: Seed of the sensor noise, 1 of 255.

    Returns:
        `images`: uint8 RGB (480, 640, 3); `intrinsic`: the camera, without distortion. Ground truth `poses`:
        T_object_camera, float64 (n, 4, 4) [m], in the frame of `object_mesh`, and `depths`, float32 (480, 640) [m].

    Raises:
        TypeError: A count that is not an integer.
        ValueError: A count below 1.

    Notes:
        Bitwise reproducible. Cached in the user's cache folder if it took long.

    Example:
        >>> import pointloom as loom
        >>> shots = loom.datasets.photographs(1)
        >>> shots.images[0].shape, round(float(shots.depths[0].min()), 1)
        ((480, 640, 3), 0.0)
    """
    count, seed = check_count("count", count), check_seed(seed)
    poses = ring(count, CAMERA_DISTANCE, CAMERA_ELEVATIONS, start=-math.pi / 2)

    def make() -> Arrays:
        stage = _stage()
        scene = scene_of(stage)
        views = [view_mesh(stage, scene, PHOTO_CAMERA, T) for T in poses]
        images = [_image(view, scene, T, seed, k) for k, (view, T) in enumerate(zip(views, poses, strict=True))]
        return {"images": np.array(images), "depths": np.array([view.depth for view in views], np.float32)}

    arrays = cached("photographs", {"count": count, "seed": seed}, make)
    return PosedImages(list(arrays["images"]), PHOTO_CAMERA, poses, list(arrays["depths"]))


def _stage() -> TriangleMesh:
    figure, steps = object_mesh(), round(CLOTH_SIDE / CLOTH_STEP)
    sides = (np.arange(steps + 1) - steps / 2) * CLOTH_STEP
    x, y = np.meshgrid(sides, sides, indexing="ij")
    floor = np.full(x.shape, figure.get_min_bound()[2])
    k = (np.arange(steps)[:, None] * (steps + 1) + np.arange(steps)).reshape(-1)
    triangles = np.concatenate([np.stack([k, k + steps + 1, k + steps + 2], 1), np.stack([k, k + steps + 2, k + 1], 1)])
    odd = (np.floor(x / CHECK_SIDE + 0.25) + np.floor(y / CHECK_SIDE + 0.25)) % 2
    colors = np.where(odd[..., None] > 0, (0.90, 0.86, 0.78), (0.24, 0.42, 0.58)).reshape(-1, 3)
    cloth = TriangleMesh(np.stack([x, y, floor], -1).reshape(-1, 3), triangles, vertex_colors=colors)
    return figure + cloth


def _image(view: MeshView, scene: RaycastingScene, T: NDArray[np.float64], seed: int, frame: int) -> NDArray[np.uint8]:
    """The sensor image: color with light, shadow, texture and noise."""
    off = view.points + SHADOW_OFFSET * view.normals
    rays = np.concatenate([off, np.broadcast_to(LIGHT_DIRECTION, off.shape)], axis=-1)
    lit = ~scene.test_occlusions(rays)
    light = AMBIENT_LIGHT + (1 - AMBIENT_LIGHT) * np.clip(matmul(view.normals, LIGHT_DIRECTION), 0, 1) * lit
    colors = np.where(view.depth[..., None] > 0, view.colors * light[..., None], (0.80, 0.82, 0.85))
    flat = upload(np.rint(255 * np.clip(colors, 0, 1)).astype(np.uint8).reshape(-1), uint8, "cpu")
    depth = upload((GRAIN_SCALE * view.depth).astype(np.float32).reshape(-1), float32, "cpu")
    enlarged = T.copy()
    enlarged[:3, 3] *= GRAIN_SCALE
    grained = grain_pixels(PHOTO_CAMERA, enlarged, depth, flat)
    noisy = measure_colors(grained, sigma=COLOR_NOISE, seed=seed, frame=frame)
    return np.array(download(noisy), np.uint8).reshape(PHOTO_CAMERA.height, PHOTO_CAMERA.width, 3)
