"""The operations of digests.py that estimate depth maps."""

from __future__ import annotations

from typing import Any

import numpy as np
from digest_scenes import loom, pose_of


def estimated_depth_maps(d: Any) -> list[Any]:
    """Depth maps of three images of a textured wall."""
    return _depth_maps_of(d, np.random.default_rng(9).integers(0, 256, (60, 80), dtype=np.uint8))


def plain_depth_maps(d: Any) -> list[Any]:
    """Depth maps of three images of a wall with an untextured center: it gets the plane of its frame."""
    rng = np.random.default_rng(9)
    wall = rng.integers(0, 256, (60, 80), dtype=np.uint8)
    wall[18:42, 22:56] = rng.integers(126, 131, (24, 34), dtype=np.uint8)
    return _depth_maps_of(d, wall)


def pair_depth_maps(d: Any) -> list[Any]:
    """Depth maps of a rectified pair and of a rotated one by semi-global matching."""
    from pointloom.photogrammetry.mvs.posed_images import SparsePoints

    mvs = loom().photogrammetry
    wall = np.random.default_rng(9).integers(0, 256, (60, 80), dtype=np.uint8).repeat(2, 0).repeat(2, 1)
    lens = loom().PinholeCameraIntrinsic(72, 36, 80.0, 80.0, 35.5, 17.5)
    points, results = [[x, y, 2.0] for x in (-0.6, 0.0, 0.6) for y in (-0.3, 0.3)], []
    for degrees in (0.0, 3.0):
        T = pose_of(degrees, [-4 * 2.0 / 80.0, 0.0, 0.0])
        cameras = [mvs.PosedCamera(lens, np.eye(4)), mvs.PosedCamera(lens, T)]
        sparse = SparsePoints(points, [[i, k] for i in range(2) for k in range(6)])
        images, sources = [wall[10:46, 20:92], wall[10:46, 24:96]], [(1,), (0,)]
        maps = mvs.estimate_depth_maps(images, cameras, sparse, sources=sources, method="sgm", device=d.device)
        results += [[each.depth, each.normals, each.confidence] for each in maps]
    return results


def _depth_maps_of(d: Any, texture: Any) -> list[Any]:
    """Depth maps of three images of a wall at 2 m; one image is shifted by four pixels horizontally, one by three
    vertically.
    """
    from pointloom.photogrammetry.mvs.posed_images import SparsePoints

    mvs = loom().photogrammetry
    wall = texture.repeat(2, 0).repeat(2, 1)
    lens = loom().PinholeCameraIntrinsic(96, 72, 80.0, 80.0, 47.5, 35.5)
    cameras, images = [], []
    for across, down in ((0, 0), (4, 0), (0, 3)):
        T = np.eye(4)
        T[:2, 3] = -across * 2.0 / 80.0, -down * 2.0 / 80.0
        cameras.append(mvs.PosedCamera(lens, T))
        images.append(wall[10 + down : 82 + down, 20 + across : 116 + across])
    points = [[x, y, 2.0] for x in (-0.8, 0.0, 0.8) for y in (-0.5, 0.5)]
    sparse = SparsePoints(points, [[i, k] for i in range(3) for k in range(6)])
    sources = [(1, 2), (0, 2), (0, 1)]
    maps = mvs.estimate_depth_maps(images, cameras, sparse, sources=sources, device=d.device)
    return [[each.depth, each.normals, each.confidence] for each in maps]
