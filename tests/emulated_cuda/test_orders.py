"""What operations return is the same, bit for bit, whatever the order in which threads run.

The operations are those of benchmarks/digests.py, on scenes that are small enough for four orders.
"""

from __future__ import annotations

import sys
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from .plugin import QUICK
from .settings import Order

DEVICE = "cuda:0"
BENCHMARKS = str(Path(__file__).parents[2] / "benchmarks")
sys.path.append(BENCHMARKS)
import digest_scenes  # noqa: E402
import scenes  # noqa: E402
from digest_on_clouds import ON_CLOUDS  # noqa: E402
from digest_once import ONCE  # noqa: E402
from digests import digest  # noqa: E402

sys.path.remove(BENCHMARKS)

COUNT = 1_009  # points of the small surface; no block size divides it
# Files, pickles and boxes never leave the host; hulls are SciPy's.
HOST_ONLY = ("write and read", "pickle", "compute_convex_hull", "get_point_indices_within")
ON_SCENES = (
    *("from_depth_image, normals", "from_rgbd_image", "filter_depth", "erode_depth", "create_normal_map"),
    *("tsdf, integrate", "tsdf, extract", "tsdf, ray_cast", "marching_cubes", "iterate_odometry"),
    *("ransac, pairs", "ransac, features", "fast global", "robust registration", "register_globally"),
    *("icp, coloured", "icp, overlap", "icp, degeneracy", "registration_icp_batch", "multi_scale_icp"),
    *("mesh, ", "rays, ", "scene, ", "color_map"),
)
ON_HOST = ("mesh, write", "mesh, shapes", "mesh, textured files")  # files, and shapes that NumPy makes


class SmallScenes(digest_scenes.Scenes):
    """Scenes of which each operation takes some tenths of a second."""

    @cached_property
    def surface(self) -> digest_scenes.Place:
        return self.place(COUNT, 10, change=digest_scenes.soil)

    @cached_property
    def ball(self) -> Any:
        return loom.marching_cubes(scenes.wavy_ball(14), spacing=[0.15] * 3, device=self.device)

    @cached_property
    def thinned(self) -> list:
        points = [scenes.bumpy_surface(4_000, seed) for seed in (50, 51)]
        parts = [points[0][points[0][:, 0] < 0.7], points[1][points[1][:, 0] > -1.3]]
        source, target = (self.cloud(part).voxel_down_sample(0.12).estimate_normals(max_nn=20) for part in parts)
        up = [c.orient_normals_to_align_with_direction() for c in (source, target)]
        return [up[0].transform(np.linalg.inv(digest_scenes.TURNED)), up[1]]


@pytest.fixture(scope="module")
def small() -> SmallScenes:
    return SmallScenes(DEVICE)


@pytest.fixture
def same_in_all_orders(settings, pytestconfig):
    """A function (work): its result is the same in each order, of which CI takes the two that are furthest apart."""
    orders = (Order.FORWARD, Order.INTERLEAVED) if pytestconfig.getoption(QUICK) else tuple(Order)

    def check(work) -> None:
        found = {}
        for order in orders:
            settings(order=order, seed=int(order) + 1)
            found[order.name] = digest(work())
        assert len(set(found.values())) == 1, found

    return check


@pytest.mark.parametrize("operation", [name for name in ON_CLOUDS if not name.startswith(HOST_ONLY)])
def test_results_on_clouds_do_not_depend_on_the_order_of_threads(small, same_in_all_orders, operation):
    same_in_all_orders(lambda: ON_CLOUDS[operation](small.surface))


@pytest.mark.parametrize(
    "operation",
    [name for name in ONCE if name.startswith(ON_SCENES) and not name.startswith(ON_HOST) and not name.endswith("far")],
)
def test_results_of_scenes_do_not_depend_on_the_order_of_threads(small, same_in_all_orders, operation):
    same_in_all_orders(lambda: ONCE[operation](small))
