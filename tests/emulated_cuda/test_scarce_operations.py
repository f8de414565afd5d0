"""Memory that runs out in any operation is a MemoryError by the device's name, and the operation goes on afterward.

At a few allocations of each, spread over its course; test_scarce_memory.py tries every one of some of them.
"""

import pytest

from ..small_scenes import ON_CLOUDS, ON_HOST, ONCE, digest
from .scarce_memory import failing_allocation

TRIED = 4  # allocations of an operation
QUICK = (
    *("voxel_down_sample", "estimate_normals, knn", "cluster_dbscan", "icp, point to plane", "knn_search"),
    *("orient_normals_consistent_tangent_plane", "detect_planar_patches", "segment_plane", "compute_fpfh_feature, knn"),
)


def check(emulated, work) -> None:
    digest(work())  # what is kept after a first call is there
    with failing_allocation(emulated) as allocated:
        result = work()
    expected, count = digest(result), allocated.count
    for number in sorted({1 + k * (count - 1) // (TRIED - 1) for k in range(TRIED)} if count else ()):
        with failing_allocation(emulated, number) as tried:
            try:
                again = work()
            except MemoryError as error:
                assert "cuda:0 has no room" in str(error) or " would take about " in str(error)
            else:
                assert tried.count > number, "what it did without was not needed"
                assert digest(again) == expected
        assert digest(work()) == expected


ON_DEVICE = [name for name in ON_CLOUDS if not name.startswith(ON_HOST)]


@pytest.mark.parametrize("name", [n if n in QUICK else pytest.param(n, marks=pytest.mark.slow) for n in ON_DEVICE])
def test_any_operation_on_clouds_goes_on_after_memory_ran_out(emulated, small, name):
    check(emulated, lambda: ON_CLOUDS[name](small.surface))


@pytest.mark.slow
@pytest.mark.parametrize("operation", [name for name in ONCE if not name.startswith(ON_HOST)])
def test_any_operation_on_scenes_goes_on_after_memory_ran_out(emulated, small, operation):
    check(emulated, lambda: ONCE[operation](small))
