"""Device calls and transfers of every operation: launches, graphs, waits, copies and bytes are counted exactly.

Python takes some 20 microseconds a launch and a wait 10, more than most of these kernels run. What an operation takes
to the host beyond its result does not grow with its input: what does is listed here, with the reason.
"""

import json

import pytest

from .host_calls import ON_CLOUDS, TABLE, DeviceScenes, device_clouds, measured, operations
from .settings import Order

ROWS = json.loads(TABLE.read_text())
SIZES, MAX_PER_POINT = (1_009, 2_503, 4_001), 0.5  # points; bytes for each further one: a mask has one
MAX_BYTES = 8_192  # beyond the result: numbers of rounds, of levels, of samples
# Operations, by the beginning of their names, that transfer more; docs/gpu.md lists what grows with the input.
MORE = {
    "Qhull's convex hull": ("get_oriented_bounding_box", "get_minimal_oriented_bounding_box"),
    "the line of the digests reads points, vertices or triangles as NumPy": (
        *("knn_search, array", "points picked", "mesh, cluster", "mesh, deform", "mesh, metrics", "mesh, remove_"),
        *("mesh, sample_points_uniformly", "mesh, topology", "mesh, triangles that meet", "mesh, trim"),
        *("room, film", "run_system", "slam, DenseSLAM", "splats", "occupancy, asked", "occupancy, cast_rays"),
    ),
    "samples of features, rows of matches and of what agrees, up to a number": (
        *("correspondences_from_features", "ransac, ", "fast global", "robust registration", "register_"),
    ),
    "states of jobs, 3,840 bytes for each of several calls or steps": (
        *("icp, callback", "icp, criteria", "icp, degeneracy", "icp, held", "icp, point to plane, robust"),
        *("icp, point to point, scaling", "multi_scale_icp", "registration_icp_batch"),
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
    "numbers of each patch": ("detect_planar_patches",),
    "the best samples of each batch, the sums of each fit": (
        *("segment_sphere", "segment_cylinder", "segment_cone", "segment_torus", "detect_shapes", "fit_shape"),
    ),
}


@pytest.fixture(scope="module")
def scenes():
    with device_clouds():
        yield DeviceScenes()


def as_listed(name: str, scenes: DeviceScenes, settings) -> None:
    settings(order=Order.FORWARD, uninitialized=False)
    counts, listed = measured(operations(scenes)[name]), ROWS[name]
    more = {column: (listed[column], count) for column, count in counts.items() if count > listed[column]}
    assert not more, f"more than host_calls.json says: {more}"


@pytest.mark.parametrize("name", [name for name in ROWS if name in ON_CLOUDS])
def test_an_operation_on_clouds_makes_no_more_device_calls_than_listed(scenes, settings, name):
    as_listed(name, scenes, settings)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in ROWS if name not in ON_CLOUDS])
def test_an_operation_on_scenes_makes_no_more_device_calls_than_listed(scenes, settings, name):
    as_listed(name, scenes, settings)


def test_every_operation_is_listed(scenes):
    assert set(operations(scenes)) == set(ROWS), "python tests/emulated_cuda/host_calls.py --write"


@pytest.mark.parametrize("name", ROWS)
def test_extra_host_transfers_are_small_or_have_a_reason(name):
    has_reason = any(name.startswith(names) for names in MORE.values())
    assert ROWS[name]["beyond"] <= MAX_BYTES or has_reason, f"{ROWS[name]['beyond']} bytes"


def test_no_reason_is_out_of_date():
    large = [name for name, row in ROWS.items() if row["beyond"] > MAX_BYTES]
    prefixes = [prefix for names in MORE.values() for prefix in names]
    assert not [prefix for prefix in prefixes if not any(name.startswith(prefix) for name in large)]


@pytest.mark.parametrize("name", [name for name in ROWS if name in ON_CLOUDS])
def test_extra_host_transfers_do_not_grow_with_the_cloud(scenes, settings, name):
    settings(order=Order.FORWARD, uninitialized=False)

    def growth(few: int, many: int) -> float:
        """Bytes for each further point."""
        first, second = (measured(lambda: ON_CLOUDS[name](scenes.surfaces(n)))["beyond"] for n in (few, many))  # noqa: B023
        return (second - first) / (many - few)

    grows = "knn_search, array", "detail tree", "detect_planar_patches", "rasterize, triangles", "splats"
    reason = name.startswith((*MORE["Qhull's convex hull"], *grows))
    few, more, most = SIZES  # a few points may end a decision earlier
    assert reason or growth(few, more) < MAX_PER_POINT or growth(more, most) < MAX_PER_POINT
