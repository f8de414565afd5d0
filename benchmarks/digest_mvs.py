"""The operations of digests.py on depth maps of several images."""

from __future__ import annotations

from typing import Any

import numpy as np
import scenes
from digest_scenes import loom, pose_of


def noisy_depth_maps(d: Any) -> Any:
    """Depth maps of a slanted wall from four positions, with noise, holes and individual colors."""
    mvs, rng = loom().photogrammetry, np.random.default_rng(7)
    lens = loom().PinholeCameraIntrinsic(96, 72, 90.0, 90.0, 47.2, 35.7)
    v, u = np.mgrid[:72, :96]
    cameras, maps = [], []
    for k in range(4):
        T = pose_of(2.0 * k - 3.0, [0.1 * k, 0.02 * k, 0.0])
        directions = np.stack([(u - lens.cx) / lens.fx, (v - lens.cy) / lens.fy, np.ones_like(u)], -1)
        rays = np.einsum("vuj,jk->vuk", directions, T[:3, :3])
        normal = np.array([0.2, 0.1, -1.0]) / np.sqrt(1.05)
        center = scenes.inverse(T)[:3, 3]
        depth = (normal * (np.array([0.0, 0.0, 3.0]) - center)).sum() / (rays * normal).sum(axis=-1)
        depth = depth * (1 + 0.003 * rng.normal(size=depth.shape)) * (rng.random(depth.shape) > 0.1)
        normals = np.broadcast_to(scenes.product(T[:3, :3], normal), (*depth.shape, 3))
        cameras.append(mvs.PosedCamera(lens, T))
        maps.append(mvs.DepthMap(np.maximum(depth, 0), normals, rng.random(depth.shape)))
    return mvs.DepthMaps(cameras, [(1, 2), (0, 2, 3), (1, 0, 3), (2, 1)], maps)


def fused_depth_maps(d: Any) -> list[Any]:
    """Fused points with the colors of each image, and both meshes."""
    mvs, maps = loom().photogrammetry, noisy_depth_maps(d)
    colors = np.random.default_rng(8).integers(0, 256, (4, 72, 96, 3)).astype(np.uint8)
    return [mvs.fuse_depth_maps(maps, list(colors), to=to, device=d.device) for to in ("points", "tsdf", "poisson")]


def filtered_depth_maps(d: Any) -> list[Any]:
    """Filtered depth maps with all criteria, and with few."""
    maps, filtered = noisy_depth_maps(d), loom().photogrammetry.filter_depth_maps
    settings = ({}, {"min_views": 1, "min_support": 0.0, "min_confidence": 0.3})
    return [[each.depth for each in filtered(maps, device=d.device, **options)] for options in settings]
