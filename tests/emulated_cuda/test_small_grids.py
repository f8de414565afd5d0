"""Kernels that would leave most of a large GPU idle: launches with few, long threads.

An H100 has 132 multiprocessors, and a launch below 256 threads for each uses a part of them. All launches of these
small inputs do. A launch counts as small here if its threads, multiplied by the ratio of a typical input to this one,
are fewer. It counts as long if one of its threads accesses memory more than LONG times, some 20 us on a GPU. A kernel
is listed if its small, long launches do more than FRACTION of the memory accesses of an operation.
"""

from collections.abc import Iterable
from functools import partial

import numpy as np

import pointloom as loom
from pointloom.kernels.lang import int32, vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.poses.consensus_poses import find_consensus
from pointloom.kernels.poses.pair_fits import PairCoordinates
from pointloom.registration.globally.global_registration import MAX_PAIRS

from ..small_scenes import ON_CLOUDS, ON_HOST, ONCE, scenes
from .findings import Launch
from .host_calls import CUDA, CountedScenes, Work, conditions
from .install import Device
from .settings import Order

FULL = 132 * 256  # threads
LONG = 1_000  # memory accesses of a thread: the latencies of as many dependent loads, 20 ns each from the L1 cache
FRACTION = 0.02
COUNT, TYPICAL = 4_001, 200_000  # points
PAIRS = 700  # correspondences, of MAX_PAIRS
PIXELS = 307_200 // (160 * 120)  # typical images have 640 x 480 pixels
# Operations on scenes, with the ratio of a typical input to theirs.
SCENES = {
    **dict.fromkeys(("tsdf, integrate", "tsdf, extract_triangle_mesh", "tsdf, ray_cast"), PIXELS),
    "mvs, estimate_depth_maps, pair": PIXELS,
    **dict.fromkeys(("ransac, pairs", "fast global registration", "icp, colored", "rays, all queries"), 50),
    **dict.fromkeys(("mesh, simplify_quadric_decimation", "mesh, create_from_point_cloud_poisson"), 50),
}
FEATURES = "a thread has a row of the features, of which there are as many as voxels"
KNOWN = {
    **dict.fromkeys(("count_angles_kernel", "sum_histograms_of_lanes_kernel"), FEATURES),
    "step_rows_in_lanes_kernel": "a warp has a row of an image, of which each pixel depends on the previous one",
    "score_in_lanes_kernel": "a warp has 512 pairs and eight poses: 256 poses and MAX_PAIRS give 32,768 threads",
    "fit_on_edges_kernel": "a thread has an edge of a hull: the smallest box so far ends the search of the next ones",
    "choose_in_block_kernel": "one block chooses among up to 8,192 points. Larger clouds have a launch per choice",
    "search_nearest_of_lanes_kernel": "a sample of 200 points is searched for a radius with too few neighbors",
    "renew_level_kernel": "one block solves the coarse levels, whatever the number of samples",
    "fit_on_facets_kernel": "a thread has a facet of a hull, which has few",
    "extract_planes_kernel": "a block finds three planes of a surface one after another; a call has many surfaces",
    "find_sides_kernel": "a thread has a voxel of a surface",
}

OF_SMALL_INPUTS = ("rank_keys_kernel",)  # sorts up to 4,096 keys. Typical inputs have more, which Warp sorts


def small_and_long(launches: Iterable[Launch], ratio: float) -> dict[str, Launch]:
    """The kernels whose small, long launches do a large part of the work, with the longest of these."""
    launches = [each for each in launches if each.kernel not in OF_SMALL_INPUTS]
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


def registered_globally() -> Work:
    """Clouds with many points to a voxel: a voxel is a fraction of a cloud's extent, so the rows hardly grow."""
    clouds = [loom.PointCloud(scenes.bumpy_surface(COUNT, seed), device=CUDA) for seed in (0, 1)]
    return lambda: loom.registration.register_globally(*clouds, voxel_size=0.25)


def consensus() -> Work:
    p, q = np.random.default_rng(0).random((2, PAIRS, 3)).astype(np.float32)
    q[: PAIRS // 10] = p[: PAIRS // 10]
    ends = [upload(points, vec3, CUDA) for points in (p, q)]
    rows = upload(np.arange(PAIRS)[:, None] * [1, 1], int32, CUDA)
    pairs = PairCoordinates(*ends, rows, *np.zeros((2, 3), np.float32))
    return lambda: find_consensus(pairs, 0.03, 0.03, np.eye(3))


def launches_of(device: Device, work: Work) -> list[Launch]:
    """The launches of a second call: the first one of a process also makes what later ones share."""
    work()
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
    with conditions():
        data = CountedScenes()
        surface = data.surfaces(COUNT)
        on_clouds = [name for name in ON_CLOUDS if not name.startswith(ON_HOST)]
        variants = {name.partition(",")[0]: name for name in reversed(on_clouds)}  # the first of each
        works = {name: (partial(ON_CLOUDS[name], surface), TYPICAL / COUNT) for name in variants.values()}
        works |= {name: (partial(ONCE[name], data), ratio) for name, ratio in SCENES.items()}
        works |= {"register_globally": (registered_globally(), TYPICAL / COUNT)}
        works |= {"find_consensus": (consensus(), MAX_PAIRS / PAIRS)}
        occurrences: dict[str, str] = {}
        for name, (work, ratio) in works.items():
            for kernel, worst in small_and_long(launches_of(emulated, work), ratio).items():
                occurrences.setdefault(kernel, f"{name}: {worst}")
    assert occurrences.keys() - KNOWN.keys() == set(), occurrences
    assert KNOWN.keys() - occurrences.keys() == set()
