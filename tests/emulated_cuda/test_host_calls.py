"""Host work of every operation on the emulated device: device calls, transfers, allocations and Python calls.

Python takes some 20 microseconds a launch and a wait 10, more than most of these kernels run. The counts are exact and
do not exceed host_calls.json. The bytes that an operation transfers to the host beyond its result do not grow with its
input, except for the operations listed here with the reason. ../test_host_calls.py has the counts of the CPU.
"""

import pytest

from .. import host_work
from ..host_work import CUDA, SIZES
from .host_calls import count_on_device
from .settings import Order

ROWS = host_work.read_table()[CUDA]
WORKS = host_work.Operations(CUDA)  # nothing runs yet
ON_CLOUDS = [name for name in ROWS if name in WORKS.on_clouds]
MAX_PER_POINT = 0.5  # bytes for each further point: a mask has one
MAX_BYTES = 8_192  # beyond the result: numbers of rounds, of levels, of samples
# Operations, by the beginning of their names, that transfer more; docs/gpu.md lists what grows with the input.
MORE = {
    "Qhull's convex hull": ("get_oriented_bounding_box", "get_minimal_oriented_bounding_box"),
    "the line of the digests reads points, vertices or triangles as NumPy": (
        *("knn_search, array", "points picked", "mesh, cluster", "mesh, deform", "mesh, metrics", "mesh, remove_"),
        *("mesh, sample_points_uniformly", "mesh, topology", "mesh, triangles that meet", "mesh, trim"),
        *(
            "room, film",
            "run_reconstruction_system",
            "slam, DenseSLAM",
            "splats",
            "occupancy, asked",
            "occupancy, cast_rays",
        ),
    ),
    "samples of features, rows of matches and of what agrees, up to a number": (
        *("correspondences_from_features", "ransac, ", "fast global", "robust registration", "register_"),
    ),
    "states of jobs, 3,840 bytes for each of several calls or steps": (
        *("icp, callback", "icp, criteria", "icp, degeneracy", "icp, held", "icp, point to plane, robust"),
        *("icp, point to point, scaling", "multi_scale_icp", "registration_icp_batch", "assess_registration"),
    ),
    "orders of the legs of a scan, 11,440 bytes a scan": ("odometry", "iterate_odometry"),
    "a step is solved on the host, 248 bytes each": ("rgbd odometry",),
    "nodes of the control grid": ("SLAC",),
    "a step of a field of k Gaussians is solved on the host, 8 k^2 bytes each": ("coherent_point_drift",),
    "covariances of pairs come of float64 rows of thinned matches, on the host": ("register_stations",),
    "what pages are sent": ("detail tree",),
    "blocks on their way to a disk and back": ("tsdf, paged",),
    "up to 20,000 colors, of which a legend shows the mean": ("render, values",),
    "which part of a mesh lies in which is asked of NumPy": ("mesh, repair", "mesh, sheets"),
    "vertices are projected on the host, in float64": ("orthophoto",),
    "holes of a depth image are filled on the host": ("fill_depth_holes",),
    "numbers of each patch": ("detect_planar_patches",),
    "the best samples of each batch, the sums of each fit": (
        *(f"segment_shape, {kind}" for kind in ("sphere", "cylinder", "cone", "torus")),
        *("detect_shapes", "fit_shape"),
    ),
}
GROWING = (*MORE["Qhull's convex hull"], "knn_search, array", "detail tree", "detect_planar_patches", "splats")
GROWING = (*GROWING, "rasterize, triangles")


@pytest.fixture(scope="module", autouse=True)
def counting_conditions():
    with host_work.conditions(CUDA):
        yield


@pytest.fixture(autouse=True)
def forward(settings):
    settings(order=Order.FORWARD, uninitialized=False)


def assert_within_limits(name: str, sizes: slice) -> None:
    host_work.assert_within_limits(WORKS, name, count_on_device, ROWS[name], sizes)


@pytest.mark.parametrize("name", ON_CLOUDS)
def test_an_operation_on_clouds_does_no_more_host_work_than_listed(name):
    """At the two smaller sizes: a count that grows faster with the size than the limits do exceeds one of them."""
    assert_within_limits(name, slice(0, 2))


@pytest.mark.slow
@pytest.mark.parametrize("name", ON_CLOUDS)
def test_an_operation_on_the_largest_clouds_does_no_more_host_work_than_listed(name):
    assert_within_limits(name, slice(2, None))


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in ROWS if name not in ON_CLOUDS])
def test_an_operation_on_scenes_does_no_more_host_work_than_listed(name):
    assert_within_limits(name, slice(None))


def test_every_operation_is_listed():
    assert set(WORKS.all) == set(ROWS), "python tests/emulated_cuda/host_calls.py --write"


def beyond(name: str) -> list[int]:
    """The limits of the bytes beyond the result, at each size that has one."""
    limits = [host_work.limits_at(ROWS[name], k) for k in range(len(WORKS.sizes_of(name)))]
    return [at_size["beyond"] for at_size in limits if "beyond" in at_size]


@pytest.mark.parametrize("name", ROWS)
def test_extra_host_transfers_are_small_or_have_a_reason(name):
    has_reason = any(name.startswith(names) for names in MORE.values())
    assert max(beyond(name)[:1], default=0) <= MAX_BYTES or has_reason, f"{beyond(name)[0]} bytes"


def test_no_reason_is_out_of_date():
    large = [name for name in ROWS if max(beyond(name)[:1], default=0) > MAX_BYTES]
    prefixes = [prefix for names in MORE.values() for prefix in names]
    assert not [prefix for prefix in prefixes if not any(name.startswith(prefix) for name in large)]


GROWTH_LIMITED = [name for name in ON_CLOUDS if not name.startswith(GROWING) and len(beyond(name)) == len(SIZES)]


@pytest.mark.parametrize("name", GROWTH_LIMITED)
def test_extra_host_transfers_do_not_grow_with_the_cloud(name):
    """By the limits at the three sizes, which the tests above compare with the counts."""
    few, more, most = beyond(name)
    growth = (more - few) / (SIZES[1] - SIZES[0]), (most - more) / (SIZES[2] - SIZES[1])  # bytes per further point
    assert min(growth) < MAX_PER_POINT, growth  # a few points may end a decision earlier
