"""The operations of benchmarks/digests.py on scenes that are small enough to run each of them several times."""

from __future__ import annotations

import sys
from functools import cached_property
from pathlib import Path
from typing import Any

import pointloom as loom

BENCHMARKS = str(Path(__file__).parents[1] / "benchmarks")
sys.path.append(BENCHMARKS)
import digest_scenes  # noqa: E402
import scenes  # noqa: E402
from digests import digest, parts_of  # noqa: E402
from operations_on_clouds import ON_CLOUDS  # noqa: E402
from operations_on_scenes import ONCE  # noqa: E402

sys.path.remove(BENCHMARKS)

__all__ = ["ONCE", "ON_CLOUDS", "ON_HOST", "SmallScenes", "digest", "digest_scenes", "parts_of"]

COUNT = 1_009  # points of the small surface; no block size divides it
# Files, pickles and boxes never leave the host; hulls are SciPy's, some shapes NumPy's.
ON_HOST = (
    *("write and read", "pickle", "compute_convex_hull", "get_point_indices_within"),
    *("mesh, write", "mesh, shapes", "mesh, textured files"),
)


class SmallScenes(digest_scenes.Scenes):
    """Scenes of which each operation takes some tenths of a second."""

    @cached_property
    def surface(self) -> digest_scenes.SampledSurface:
        return self.sample(COUNT, 10, change=digest_scenes.soil)

    @cached_property
    def ball(self) -> Any:
        return loom.meshing.marching_cubes(scenes.wavy_ball(14), spacing=[0.15] * 3, device=self.device)

    @cached_property
    def thinned(self) -> list:
        points = [scenes.bumpy_surface(4_000, seed) for seed in (50, 51)]
        parts = [points[0][points[0][:, 0] < 0.7], points[1][points[1][:, 0] > -1.3]]
        source, target = (self.cloud(part).voxel_down_sample(0.12).estimate_normals(max_nn=20) for part in parts)
        up = [c.orient_normals_to_align_with_direction() for c in (source, target)]
        return [up[0].transform(scenes.inverse(digest_scenes.ROTATED)), up[1]]
