"""What every operation asks of the device and takes from it: launches, graphs, waits, copies, bytes, to the number.

Python takes some 20 microseconds a launch and a wait 10, more than most of these kernels run. What an operation takes
to the host beyond its result does not grow with its input: what does is listed here, with the reason.
"""

from __future__ import annotations

import json

import pytest

from .host_calls import ON_CLOUDS, TABLE, DeviceScenes, device_clouds, measured, operations
from .settings import Order

ROWS = json.loads(TABLE.read_text())
MOST_BYTES = 8_192  # beyond the result: numbers of rounds, of levels, of samples
# What grows with the input, and why.
GROWING = {
    "hidden_point_removal": "Qhull's convex hull",
    "get_oriented_bounding_box": "Qhull's convex hull",
    "get_minimal_oriented_bounding_box": "Qhull's convex hull",
    "compute_convex_hull": "Qhull's convex hull",
}


@pytest.fixture(scope="module")
def scenes():
    with device_clouds():
        yield DeviceScenes()


def as_listed(name: str, scenes: DeviceScenes, settings) -> None:
    settings(order=Order.FORWARD, uninitialised=False)
    found, listed = measured(operations(scenes)[name]), ROWS[name]
    more = {column: (listed[column], count) for column, count in found.items() if count > listed[column]}
    assert not more, f"more than host_calls.json says: {more}"


@pytest.mark.parametrize("name", [name for name in ROWS if name in ON_CLOUDS])
def test_an_operation_on_clouds_asks_no_more_of_the_device_than_is_listed(scenes, settings, name):
    as_listed(name, scenes, settings)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in ROWS if name not in ON_CLOUDS])
def test_an_operation_on_scenes_asks_no_more_of_the_device_than_is_listed(scenes, settings, name):
    as_listed(name, scenes, settings)


def test_every_operation_is_listed(scenes):
    assert set(operations(scenes)) == set(ROWS), "python tests/emulated_cuda/host_calls.py --write"


@pytest.mark.parametrize("name", ROWS)
def test_what_goes_to_the_host_beside_the_result_is_small_or_has_a_reason(name):
    grows = ROWS[name]["beyond"] > MOST_BYTES
    assert grows == (name.partition(",")[0] in GROWING or name in GROWING), f"{ROWS[name]['beyond']} bytes"
