"""A wavy wall seen by cameras with different exposures."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

import pointloom as loom

CAMERA = loom.PinholeCameraIntrinsic(96, 72, 90.0, 90.0, 47.5, 35.5)


class WallScene(NamedTuple):
    """The mesh, images, and poses (world to camera)."""

    mesh: Any
    images: list[NDArray[np.uint8]]
    extrinsics: list[NDArray[np.float64]]


def wall_colors(x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack([0.5 + 0.1 * np.sin(9 * x), 0.45 + 0.1 * np.cos(7 * y), 0.5 + 0.1 * np.sin(5 * (x + y))], -1)


def wall_mesh(side: int = 17, **options: Any) -> Any:
    """A square of 1.6 m at z = 0, its triangles facing -z."""
    j, i = np.mgrid[:side, :side]
    uv, at = np.stack([i, j], -1).reshape(-1, 2) / (side - 1), (j * side + i)[:-1, :-1].ravel()
    triangles = np.concatenate([np.stack([at, at + side, at + 1], 1), np.stack([at + 1, at + side, at + side + 1], 1)])
    vertices = np.column_stack([1.6 * uv - 0.8, np.zeros(len(uv))])
    return loom.TriangleMesh(vertices, triangles, **options)


def wall_scene(gains: Any = (1.0, 1.0, 1.0), device: Any = "cpu") -> WallScene:
    """Images of the wall from 1 m away, left to right, multiplied by gains."""
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    images, extrinsics = [], []
    for k, gain in enumerate(gains):
        T = np.eye(4)
        T[0, 3], T[2, 3] = -0.45 * (k - (len(gains) - 1) / 2), 1.0
        x, y = (u - CAMERA.cx) / CAMERA.fx - T[0, 3], (v - CAMERA.cy) / CAMERA.fy
        images.append(np.clip(np.rint(255 * gain * wall_colors(x, y)), 0, 255).astype(np.uint8))
        extrinsics.append(T)
    return WallScene(wall_mesh(device=device), images, extrinsics)


def sampled(mesh: Any, row: int, fraction: Any) -> NDArray[np.float64]:
    """The bilinear texture value at barycentric coordinates of a triangle, 0..255."""
    image = mesh.textures[0].astype(np.float64)
    u, v = np.asarray(fraction) @ np.asarray(mesh.triangle_uvs, np.float64).reshape(-1, 3, 2)[row]
    return bilinear(image, u * image.shape[1] - 0.5, (1 - v) * image.shape[0] - 0.5)


def bilinear(values: NDArray[Any], x: float, y: float) -> NDArray[np.float64]:
    """The value at column x and row y of an image, interpolated between four pixels."""
    i, j = int(x), int(y)
    above, below = (row[i] * (1 - (x - i)) + row[i + 1] * (x - i) for row in values[j : j + 2])
    return above * (1 - (y - j)) + below * (y - j)


def steps_of(mesh: Any, views: NDArray[np.int32]) -> NDArray[np.float64]:
    """The color steps in the middle of edges between triangles of different images, averaged over channels, 0..255."""
    edges: dict[frozenset[int], list[tuple[int, NDArray[np.float64]]]] = {}
    for t, corners in enumerate(np.asarray(mesh.triangles).tolist()):
        for k in range(3):
            fraction = np.full(3, 0.5)
            fraction[(k + 2) % 3] = 0.0
            edges.setdefault(frozenset((corners[k], corners[(k + 1) % 3])), []).append((t, fraction))
    pairs = [sides for sides in edges.values() if len(sides) == 2]
    seams = [(a, b) for a, b in pairs if views[a[0]] != views[b[0]] and min(views[a[0]], views[b[0]]) >= 0]
    return np.array([np.abs(sampled(mesh, *a) - sampled(mesh, *b)).mean() for a, b in seams])
