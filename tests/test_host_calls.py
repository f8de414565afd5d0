"""Host work of operations on the CPU: launches, allocations and Python calls do not exceed host_calls.json.

The counts are exact. They find a function that is called for each element, a copy or a launch too many, and not a
kernel that became slower. emulated_cuda/test_host_calls.py has the counts of the CUDA device.
"""

import json

import pytest
import warp as wp

import pointloom as loom
from pointloom.kernels.arrays.subsets import step_rows
from pointloom.kernels.language import warp_parts

from . import host_work
from .host_work import CPU, PythonCalls, UnstableCountsError, count_on_cpu, merged, rises, settled_counts

ROWS = host_work.read_table()[CPU]
# With a GPU each launch looks for its device. Other versions of Warp may launch in another way.
pytestmark = pytest.mark.skipif(
    wp.is_cuda_available() or wp.__version__ not in warp_parts.TESTED,
    reason="the counts are those of a machine without a GPU and of the tested version of Warp",
)


@pytest.fixture(scope="module")
def works():
    with host_work.conditions(CPU):
        yield host_work.Operations(CPU)


@pytest.mark.parametrize("name", ROWS)
def test_an_operation_does_no_more_host_work_than_listed(works, name):
    host_work.assert_within_limits(works, name, count_on_cpu, ROWS[name])


def test_every_operation_is_listed(works):
    assert set(works.all) == set(ROWS), "python tests/emulated_cuda/host_calls.py --device cpu --write"


def test_each_launch_and_each_array_is_counted():
    device = wp.get_device("cpu")
    counts = count_on_cpu(lambda: [step_rows(count, 1, device) for count in (1, 1_000, 3_000)])
    assert (counts["launches"], counts["allocations"], counts["allocated"]) == (3, 3, 4 * 4_001)


def test_calls_of_the_library_are_counted_and_no_others():
    def calls_of(work) -> int:
        with PythonCalls() as calls:
            work()
        return calls.calls

    box = loom.AxisAlignedBoundingBox([0, 0, 0], [1, 2, 3])
    once = calls_of(box.volume)
    assert once > 0
    assert calls_of(lambda: [box.volume() for _ in range(5)]) == 5 * once
    assert calls_of(lambda: json.loads("[1]")) == 0


def test_counts_that_never_settle_are_an_error():
    runs = iter(range(1_000))
    with pytest.raises(UnstableCountsError, match="expected two successive equal counts"):
        settled_counts(lambda: {"python": next(runs)})
    first = iter((9, 5, 5))  # warm-up
    assert settled_counts(lambda: {"python": next(first)}) == {"python": 5}
    assert settled_counts(lambda: {"python": 4}, {"python": 5}) == {"python": 4}


def test_a_message_names_operation_device_size_column_limit_and_count():
    row = {"python": 7, "allocated": [10, 20, 30]}
    counts = [{"python": 7, "allocated": 10}, {"python": 8, "allocated": 21}]
    assert rises("crop", CPU, host_work.SIZES, row, counts) == [
        "crop on cpu at 2,503 points: python: limit 7, got 8",
        "crop on cpu at 2,503 points: allocated: limit 20, got 21",
    ]


def test_limits_fall_without_and_rise_only_with_a_reason():
    row = {"python": 7, "allocated": [10, 20, 30], "why": "an earlier reason"}
    counts = [{"python": 6, "allocated": n} for n in (10, 25, 20)]
    assert merged(row, counts, None) == {"python": 6, "allocated": [10, 20, 20], "why": "an earlier reason"}
    assert merged(row, counts, "a new array") == {"python": 6, "allocated": [10, 25, 20], "why": "a new array"}
    assert merged({"python": 7}, [{"python": 6}], None) == {"python": 6}
