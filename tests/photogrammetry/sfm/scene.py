"""A synthetic scene with enough texture for matching: a wall and three boards in front of it."""

import numpy as np
from PIL import Image

WIDTH, HEIGHT, FOCAL = 320, 240, 300.0

# Middle and the two half sides of each plane.
PLANES = [
    ((0, 0, 4), (3, 0, 0.8), (0, 2.2, 0.3)),
    ((-0.7, 0.2, 2.8), (0.5, 0, -0.15), (0.05, 0.5, 0.1)),
    ((0.6, -0.3, 3.1), (0.45, 0.05, 0.2), (0, 0.45, -0.2)),
    ((0.3, 0.55, 2.5), (0.35, 0, 0.1), (0, 0.25, 0.2)),
]
GRAIN = ((8, 0.2), (32, 0.3), (128, 0.5))  # cells of the noise on a plane, and its weight


def grains() -> list[np.ndarray]:
    rng = np.random.default_rng(0)
    textures = []
    for _ in PLANES:
        sums = np.zeros((512, 512))
        for cells, weight in GRAIN:
            noise = Image.fromarray(rng.random((cells, cells)).astype(np.float32))
            sums += weight * np.asarray(noise.resize((512, 512), Image.Resampling.BICUBIC))
        textures.append(np.clip(128 + 55 * (sums - sums.mean()) / sums.std(), 0, 255))
    return textures


TEXTURES = grains()


def camera_pose(along: float, *, rotate_only: bool = False) -> np.ndarray:
    """T_camera_world at -0.5..0.5 of a path past the scene, or of a rotation at its center."""
    center = np.zeros(3) if rotate_only else np.array([1.2 * along, 0.15 * np.sin(6 * along), 0.1 * np.cos(5 * along)])
    yaw = (0.6 if rotate_only else 0.25) * along
    T = np.eye(4)
    T[:3, :3] = [[np.cos(yaw), 0, np.sin(yaw)], [0, 1, 0], [-np.sin(yaw), 0, np.cos(yaw)]]
    T[:3, 3] = -T[:3, :3] @ center
    return T


def image(T_camera_world: np.ndarray, focal: float = FOCAL) -> np.ndarray:
    """The image of a camera, shape [240, 320], uint8."""
    R, t = T_camera_world[:3, :3], T_camera_world[:3, 3]
    center = -R.T @ t
    v, u = np.mgrid[:HEIGHT, :WIDTH]
    x, y = (u - (WIDTH - 1) / 2) / focal, (v - (HEIGHT - 1) / 2) / focal
    rays = np.stack([x, y, np.ones_like(x)], axis=-1) @ R
    nearest, seen = np.full((HEIGHT, WIDTH), np.inf), np.zeros((HEIGHT, WIDTH))
    for plane, texture in zip(PLANES, TEXTURES, strict=True):
        middle, a, b = (np.array(vector, float) for vector in plane)
        normal = np.cross(a, b)
        depth = ((middle - center) @ normal) / (rays @ normal)
        at = center + depth[..., None] * rays - middle
        sides = np.stack([at @ a, at @ b], -1) @ np.linalg.inv([[a @ a, a @ b], [a @ b, b @ b]])
        hit = (depth > 0) & (np.abs(sides) < 1).all(-1) & (depth < nearest)
        seen[hit] = sampled(texture, (np.clip(sides, -1, 1) + 1) / 2)[hit]
        nearest[hit] = depth[hit]
    return np.clip(seen + 0.5, 0, 255).astype(np.uint8)


def sampled(texture: np.ndarray, where: np.ndarray) -> np.ndarray:
    """Bilinear samples of a texture, `where` in 0..1 on both axes."""
    position = where * (len(texture) - 2)
    i, j = position[..., 0].astype(int), position[..., 1].astype(int)
    p, q = position[..., 0] - i, position[..., 1] - j
    upper = texture[j, i] * (1 - p) + texture[j, i + 1] * p
    return upper * (1 - q) + (texture[j + 1, i] * (1 - p) + texture[j + 1, i + 1] * p) * q


def camera_path(count: int, **options: bool) -> list[np.ndarray]:
    return [camera_pose(k / (count - 1) - 0.5, **options) for k in range(count)]
