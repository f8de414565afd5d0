"""Two runs of each operation on clouds give the same bits: benchmarks/digest_on_clouds.py, on two equal scenes."""

import pytest

from ..small_scenes import ON_CLOUDS, ON_HOST, SmallScenes, digest

COUNT = 6_007  # points: more than the filters of hulls and visible points ask for
ELSEWHERE = ("alpha", "detail", "from_point_cloud", "splats", "write")  # tests of other folders, and the host alone
OPERATIONS = [name for name in ON_CLOUDS if not name.startswith((*ON_HOST, *ELSEWHERE))]
OPERATIONS = OPERATIONS[: OPERATIONS.index("icp, point to point")]


@pytest.fixture(scope="module")
def places():
    """A function (device) -> the scene there, twice, so that search trees are built twice, too."""
    made = {}
    return lambda device: made.setdefault(device, [SmallScenes(device).place(COUNT, 10) for _ in range(2)])


@pytest.mark.parametrize("name", OPERATIONS)
def test_two_runs_give_the_same_bits(device, name, places):
    first, second = (digest(ON_CLOUDS[name](place)) for place in places(device))
    assert first == second
