"""Host work of operations on the emulated device: launches, waits, allocations and transfers.

Python takes some 20 microseconds a launch and a wait 10, more than most of these kernels run. The operations of
docs/gpu.md stay within the limits of host_calls.json. The waits of an operation on a cloud, and the bytes that it
transfers to the host beyond its result, do not grow with the points.
"""

from collections.abc import Mapping
from typing import Any

import numpy as np
import pytest
import warp as wp

import pointloom as loom

from ..small_scenes import COUNT, ON_CLOUDS, ON_HOST, parts_of
from . import host_calls
from .host_calls import CUDA, CountedScenes
from .install import installed
from .settings import Order

ROWS = host_calls.read_table()
MORE = 2_503  # points; no block size divides them
MAX_PER_POINT = 0.5  # bytes for each further point: a mask has one
# Operations, by the beginning of their names, that transfer more; docs/gpu.md lists what grows with the input.
GROWING = {
    "get_oriented_bounding_box": "Qhull's convex hull",
    "get_minimal_oriented_bounding_box": "Qhull's convex hull",
    "knn_search, array": "the line of the digests reads the points as NumPy",
    "splats": "the line of the digests reads the points as NumPy",
    "detail tree": "what pages are sent",
    "detect_planar_patches": "numbers of each patch",
    "rasterize, triangles": "SciPy's Delaunay triangles",
    "assess_registration": "states of ICP's jobs, in more rounds",
}
COMPARED = [name for name in ON_CLOUDS if not name.startswith(ON_HOST)]


@pytest.fixture(scope="module")
def clouds():
    with host_calls.conditions():
        yield CountedScenes()


@pytest.fixture(scope="module")
def works(clouds):
    return host_calls.operations(clouds)


@pytest.fixture(autouse=True)
def forward(settings):
    settings(order=Order.FORWARD, uninitialized=False)


@pytest.mark.parametrize("name", ROWS)
def test_an_operation_does_no_more_host_work_than_listed(works, name):
    messages = host_calls.exceeded(host_calls.counted(works[name], ROWS[name]), ROWS[name])
    command = f"python tests/emulated_cuda/host_calls.py --only {name} --write"
    assert not messages, "\n".join([*messages, f"Reduce the work, or raise the limits: {command}"])


def test_every_operation_is_listed(works):
    assert works.keys() == ROWS.keys(), "python tests/emulated_cuda/host_calls.py --write"


def test_another_wait_in_each_iteration_of_icp_exceeds_its_limit(works):
    """As many further waits as there are."""
    name, number = "icp_plane", wp.zeros(1, device=CUDA)

    def prepare():
        align = works[name]()
        return lambda: [align(), *(number.numpy() for _ in range(ROWS[name]["waits"]))]

    messages = host_calls.exceeded(host_calls.counted(prepare, ROWS[name]), ROWS[name])
    assert [message.partition(":")[0] for message in messages] == ["waits"]


def test_a_limit_is_a_tenth_more_rounded_up():
    assert [host_calls.limit(n) for n in (0, 1, 10, 11, 100)] == [0, 2, 11, 13, 110]
    row = {"launches": 20, "waits": 0}
    assert host_calls.exceeded({"launches": 22, "waits": 0}, row) == []
    assert host_calls.exceeded({"launches": 23, "waits": 1}, row) == [
        "launches: expected at most 22, got 23",
        "waits: expected at most 0, got 1",
    ]


def host_bytes(result: Any) -> int:
    """Bytes of a result that the call has put on the host."""
    if isinstance(result, np.ndarray):
        return result.nbytes
    if result is None or isinstance(result, (wp.array, str, bool, int, float, np.generic, bytes)):
        return 0
    if isinstance(result, Mapping):
        return sum(map(host_bytes, result.values()))
    if isinstance(result, (list, tuple)):
        return sum(map(host_bytes, result))
    return _bytes_of_parts(result)


def _bytes_of_parts(result: Any) -> int:
    """Of an object; a part that is fetched only now is none of them."""
    if isinstance(result, loom.PointCloud):
        return 0  # Warp arrays
    device, sizes = installed(), []
    assert device is not None
    requests = device.count_requests(lambda: sizes.extend(map(host_bytes, parts_of(result).values())))
    return max(0, sum(sizes) - requests["bytes to host"])


def waits_and_bytes(surface: Any, name: str) -> tuple[int, int]:
    """The waits of an operation, and the bytes that it transfers to the host beyond its result."""
    results: list[Any] = []
    counts = host_calls.count_on_device(lambda: results.append(ON_CLOUDS[name](surface)))
    return counts["waits"], max(0, counts["downloaded"] - host_bytes(results[0]))


@pytest.mark.parametrize("name", COMPARED)
def test_waits_and_transfers_to_the_host_do_not_grow_with_the_cloud(clouds, name):
    """Except for the transfers that are listed with a reason, and for twice the waits: some clouds need more rounds."""
    for _ in range(2):  # the first run may fill caches
        (few_waits, few), (more_waits, more) = (waits_and_bytes(clouds.surfaces(n), name) for n in (COUNT, MORE))
        is_growing = more - few > MAX_PER_POINT * (MORE - COUNT)
        if more_waits <= 2 * few_waits and is_growing == name.startswith(tuple(GROWING)):
            break
    assert more_waits <= 2 * few_waits
    assert is_growing == name.startswith(tuple(GROWING)), (few, more)
