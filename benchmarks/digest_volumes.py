"""The operations of digests.py on volumes that are paged to disk."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from digest_scenes import UTM, loom


def paged_volume(d: Any) -> list[Any]:
    """A wall along which a camera goes and comes back, with a scan between, over more blocks than the device holds."""
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
            whole, view = volume.to_volume(), np.eye(4)
            view[:3, 3] = -UTM
            seen = volume.ray_cast(camera, view, depth_max=1.2, weight_threshold=0)
            found = [touched, volume.extract_triangle_mesh(0), volume.extract_point_cloud(1), seen.depth]
            assert volume.block_count > volume.max_blocks
            return [*found, whole.extract_triangle_mesh(0)]


def paged_scans(d: Any) -> list[Any]:
    """Walls on four sides and then behind them: rays carve what lies on disk."""
    side = np.linspace(-0.6, 0.6, 25)
    wall = np.stack([np.repeat(side, 25), np.tile(side, 25)], axis=1)
    with tempfile.TemporaryDirectory() as folder:
        sizes: dict[str, Any] = {"voxel_size": 0.025, "truncation": 0.075, "max_blocks": 220, "page_blocks": 3}
        with loom().PagedTSDFVolume(Path(folder) / "pages", **sizes, color=False, device=d.device) as volume:
            touched = []
            for far, (c, s) in ((far, turn) for far in (1.0, 1.8) for turn in ((1, 0), (0, 1), (-1, 0), (0, -1))):
                turn = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
                points = np.column_stack([np.full(625, far), wall]) @ turn.T
                touched.append(volume.integrate_points(points, turn @ [0.3, 0.0, 0.0]))
            assert volume.block_count > volume.max_blocks
            return [touched, volume.extract_triangle_mesh(0)]


VOLUMES: dict[str, Callable[[Any], Any]] = {"tsdf, paged": paged_volume, "tsdf, paged, integrate_points": paged_scans}
