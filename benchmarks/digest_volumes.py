"""The operations of digests.py on volumes that are paged to disk."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from digest_scenes import UTM, loom


def paged_volume(d: Any) -> list[Any]:
    """A wall scanned by a camera that moves along it and back, with a scan in between; more blocks than the device
    holds.
    """
    rng = np.random.default_rng(6)
    camera = loom().PinholeCameraIntrinsic(40, 30, 40.0, 40.0, 19.5, 14.5)
    with tempfile.TemporaryDirectory() as folder:
        sizes: dict[str, Any] = {"voxel_size": 0.025, "truncation": 0.075, "max_blocks": 130, "page_blocks": 3}
        with loom().PagedTSDFVolume(Path(folder) / "pages", **sizes, device=d.device) as volume:
            touched = []
            for k in (0, 1, 2, 3, 4, 3, 1, 0):
                pose = np.eye(4)
                pose[:3, 3] = -UTM - [0.8 * k, 0.0, 0.0]
                depth = 1.0 + rng.normal(0, 0.01, (30, 40))
                color = rng.integers(0, 255, (30, 40, 3)).astype(np.uint8)
                touched.append(volume.integrate(depth, camera, pose, color))
            full, view = volume.to_volume(), np.eye(4)
            view[:3, 3] = -UTM
            rendered = volume.ray_cast(camera, view, depth_max=1.2, weight_threshold=0)
            results = [touched, volume.extract_triangle_mesh(0), volume.extract_point_cloud(1), rendered.depth]
            assert volume.block_count > volume.max_blocks
            return [*results, full.extract_triangle_mesh(0)]


def paged_scans(d: Any) -> list[Any]:
    """Walls on four sides and then behind them: rays carve blocks on disk."""
    side = np.linspace(-0.6, 0.6, 25)
    wall = np.stack([np.repeat(side, 25), np.tile(side, 25)], axis=1)
    with tempfile.TemporaryDirectory() as folder:
        sizes: dict[str, Any] = {"voxel_size": 0.025, "truncation": 0.075, "max_blocks": 220, "page_blocks": 3}
        with loom().PagedTSDFVolume(Path(folder) / "pages", **sizes, color=False, device=d.device) as volume:
            touched = []
            for far, (c, s) in (
                (far, rotation) for far in (1.0, 1.8) for rotation in ((1, 0), (0, 1), (-1, 0), (0, -1))
            ):
                rotation = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
                points = np.column_stack([np.full(625, far), wall]) @ rotation.T
                touched.append(volume.integrate_points(points, rotation @ [0.3, 0.0, 0.0]))
            assert volume.block_count > volume.max_blocks
            return [touched, volume.extract_triangle_mesh(0)]


VOLUMES: dict[str, Callable[[Any], Any]] = {"tsdf, paged": paged_volume, "tsdf, paged, integrate_points": paged_scans}
