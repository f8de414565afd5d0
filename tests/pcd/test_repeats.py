"""Each operation of benchmarks/digest_on_clouds.py gives bitwise identical results in two runs."""

import pytest

from ..small_scenes import ON_CLOUDS, ON_HOST, SmallScenes, digest

COUNT = 6_007  # points: above the thresholds of the filters of hulls and visible points
ELSEWHERE = ("alpha", "detail", "from_point_cloud", "splats", "write")  # tested in other folders, or host code
OPERATIONS = [name for name in ON_CLOUDS if not name.startswith((*ON_HOST, *ELSEWHERE))]
OPERATIONS = OPERATIONS[: OPERATIONS.index("icp, point to point")]


@pytest.fixture(scope="module")
def scenes():
    """A function (device) -> two equal scenes, so that search trees are built twice."""
    made = {}
    return lambda device: made.setdefault(device, [SmallScenes(device).sample(COUNT, 10) for _ in range(2)])


@pytest.mark.parametrize("name", OPERATIONS)
def test_two_runs_are_bitwise_identical(device, name, scenes):
    first, second = (digest(ON_CLOUDS[name](scene)) for scene in scenes(device))
    assert first == second
