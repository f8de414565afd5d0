"""Kernels that would leave most of a large GPU idle: launches with few, long threads.

An H100 has 132 multiprocessors, and a launch below 256 threads for each uses a part of them. All launches of these
small inputs do. A launch counts as small here if its threads, multiplied by the ratio of a typical input to this one,
are fewer. It counts as long if one of its threads accesses memory more than LONG times, some 20 us on a GPU. A kernel
is listed if its small, long launches do more than FRACTION of the memory accesses of an operation.
"""

from collections.abc import Iterable

import pointloom as loom

from .. import host_work
from ..host_work import CUDA
from ..small_scenes import scenes
from .findings import Launch
from .install import Device
from .settings import Order

FULL = 132 * 256  # threads
LONG = 1_000  # memory accesses of a thread: the latencies of as many dependent loads, 20 ns each from the L1 cache
FRACTION = 0.02
COUNT, TYPICAL = 4_001, 200_000  # points
PIXELS = 307_200 // (160 * 120)  # typical images have 640 x 480 pixels
# Operations on scenes, with the ratio of a typical input to theirs.
SCENES = {
    **dict.fromkeys(("tsdf, integrate", "tsdf, extract_triangle_mesh", "tsdf, ray_cast"), PIXELS),
    **dict.fromkeys(("mvs, estimate_depth_maps, pair", "filter_depth_bilateral", "create_normal_map"), PIXELS),
    **dict.fromkeys(("ransac, pairs", "fast global registration", "icp, colored", "rays, all queries"), 50),
    **dict.fromkeys(("mesh, simplify_quadric_decimation", "mesh, create_from_point_cloud_poisson"), 50),
}
LEAVES = "a thread has the eight points of a leaf, in vectors as on the CPU"
FEATURES = "a thread has a row of the features, of which there are as many as voxels"
ROWS = "a thread has a row of pixels"
KNOWN = {
    **dict.fromkeys(("find_cores_kernel", "unite_cores_kernel", "label_borders_kernel", "mask_crowded_kernel"), LEAVES),
    **dict.fromkeys(("find_nearest_rows_kernel", "count_angles_kernel", "sum_histograms_of_lanes_kernel"), FEATURES),
    **dict.fromkeys(("find_codes_kernel", "find_disparities_kernel", "step_rows_kernel"), ROWS),
    "fit_on_edges_kernel": "a thread has an edge of a hull: the smallest box so far ends the search of the next ones",
    "fit_on_facets_kernel": "a thread has a facet of a hull, which has few",
}


def small_and_long(launches: Iterable[Launch], ratio: float) -> dict[str, Launch]:
    """The kernels whose small, long launches do a large part of the work, with the longest of these."""
    launches = list(launches)
    total = sum(each.accesses for each in launches)
    found: dict[str, list[Launch]] = {}
    for each in launches:
        if each.threads * ratio < FULL and each.longest > LONG:
            found.setdefault(each.kernel, []).append(each)
    return {
        kernel: max(some, key=lambda each: each.longest)
        for kernel, some in found.items()
        if sum(each.accesses for each in some) > FRACTION * total
    }


def registered_globally() -> host_work.Work:
    """Clouds with many points to a voxel: a voxel is a fraction of a cloud's extent, so the rows hardly grow."""
    clouds = [loom.PointCloud(scenes.bumpy_surface(COUNT, seed), device=CUDA) for seed in (0, 1)]
    return lambda: loom.registration.register_globally(*clouds, voxel_size=0.25)


def launches_of(device: Device, work: host_work.Work) -> list[Launch]:
    device.synchronize()
    with device.findings.recording() as launches:
        work()
        device.synchronize()
    return launches


def test_few_long_threads_are_found():
    launches = [
        Launch("few", 256, 700_000, 3_000),
        Launch("short", 256, 250_000, 1_000),
        Launch("many", 800, 9**7, 6_000),
    ]
    assert list(small_and_long(launches, TYPICAL / COUNT)) == ["few"]
    assert small_and_long([launches[0], Launch("more work", 10**6, 10**8, 100)], TYPICAL / COUNT) == {}


def test_no_operation_spends_its_time_in_few_long_threads(emulated, settings):
    """Each exception has a reason, and an exception that no longer occurs is removed."""
    settings(order=Order.FORWARD, uninitialized=False)
    with host_work.conditions(CUDA):
        operations = host_work.Operations(CUDA)
        variants = {name.partition(",")[0]: name for name in reversed(operations.on_clouds)}  # the first of each
        works = {name: (operations.on_clouds[name](COUNT), TYPICAL / COUNT) for name in variants.values()}
        works |= {name: (operations.on_scenes[name](0), ratio) for name, ratio in SCENES.items()}
        works |= {"register_globally": (registered_globally(), TYPICAL / COUNT)}
        occurrences: dict[str, str] = {}
        for name, (work, ratio) in works.items():
            for kernel, worst in small_and_long(launches_of(emulated, work), ratio).items():
                occurrences.setdefault(kernel, f"{name}: {worst}")
    assert occurrences.keys() - KNOWN.keys() == set(), occurrences
    assert KNOWN.keys() - occurrences.keys() == set()
