"""Results are bitwise identical for any order of threads.

The operations are those of benchmarks/digests.py, on scenes that are small enough for four orders.
"""

import numpy as np
import pytest

from ..kernels.arrays.test_blocks import COUNT, FAR, rotate
from ..small_scenes import ON_CLOUDS, ON_HOST, ONCE, digest
from .plugin import QUICK
from .settings import Order

ON_SCENES = (
    *("create_from_depth_image, normals", "create_from_rgbd_image", "filter_depth", "erode_depth", "create_normal_map"),
    *("tsdf, integrate", "tsdf, extract", "tsdf, ray_cast", "marching_cubes", "iterate_odometry"),
    *("ransac, pairs", "ransac, features", "fast global", "robust registration", "register_globally"),
    *("icp, colored", "icp, overlap", "icp, degeneracy", "registration_icp_batch", "multi_scale_icp"),
    *("mesh, ", "rays, ", "scene, ", "color_map", "render, "),
    *("mvs, ", "rgbd odometry", "deskew_point_cloud", "undistort_image", "tsdf, fuse_volumes"),
)
LONG = (
    "slam, DenseSLAM",
    "odometry",
    "odometry, as measured",
    "run_reconstruction_system",
    "SLAC",
    "register_multiway",
)


@pytest.fixture
def same_in_all_orders(settings, pytestconfig):
    """A function (work): its result is the same in each order, of which CI takes the two that are furthest apart."""
    orders = (Order.FORWARD, Order.INTERLEAVED) if pytestconfig.getoption(QUICK) else tuple(Order)

    def check(work) -> None:
        digests = {}
        for order in orders:
            settings(order=order, seed=int(order) + 1)
            digests[order.name] = digest(work())
        assert len(set(digests.values())) == 1, digests

    return check


@pytest.mark.parametrize("operation", [name for name in ON_CLOUDS if not name.startswith(ON_HOST)])
def test_results_on_clouds_do_not_depend_on_the_order_of_threads(small, same_in_all_orders, operation):
    same_in_all_orders(lambda: ON_CLOUDS[operation](small.surface))


SCENES = [n for n in ONCE if n.startswith(ON_SCENES) and not n.startswith(ON_HOST) and not n.endswith("far")]


@pytest.mark.parametrize("operation", [*SCENES, *(pytest.param(name, marks=pytest.mark.slow) for name in LONG)])
def test_results_of_scenes_do_not_depend_on_the_order_of_threads(small, same_in_all_orders, operation):
    same_in_all_orders(lambda: ONCE[operation](small))


@pytest.mark.parametrize("order", list(Order))
def test_a_barrier_orders_the_accesses_of_a_block(settings, order):
    settings(order=order, seed=int(order) + 1)
    np.testing.assert_array_equal(rotate("cuda:0", 5), np.roll(np.arange(COUNT), -10 * FAR))
