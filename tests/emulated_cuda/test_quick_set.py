"""The set of tests that CI runs on the emulated device: its file, and the choice of its tests."""

from ..smallest_set import Taken, smallest_set
from . import quick_set

TESTS = {
    "fast": Taken(0.1, items={1, 2}),
    "slow, takes all": Taken(9.0, items={1, 2, 3, 4}),
    "third": Taken(0.1, items={3}),
    "both": Taken(0.5, items={2, 3}),
    "alone": Taken(5.0, items={4}),
    "required": Taken(2.0, items={3}),
}


def test_the_smallest_set_takes_all_items_in_the_fewest_seconds():
    assert smallest_set({name: TESTS[name] for name in TESTS if name != "required"}) == {"fast", "third", "alone"}
    assert smallest_set(TESTS, ["required"]) == {"required", "fast", "alone"}


def test_a_test_whose_items_later_tests_take_is_removed():
    """A greedy choice begins with the test of many items, which the two others then replace."""
    tests = {"many": Taken(0.6, items={1, 2, 3, 4}), "a": Taken(0.5, items={1, 2, 5}), "b": Taken(0.5, items={3, 4, 6})}
    assert smallest_set(tests) == {"a", "b"}


def test_names_of_tests_that_no_longer_exist_are_found():
    name = "tests/pcd/test_hulls.py::test_none[cuda:0]"
    assert quick_set.missing_tests([name], ["tests/pcd/test_boxes.py::test_a"]) == []  # the file was not collected
    assert quick_set.missing_tests([name], ["tests/pcd/test_hulls.py::test_a"]) == [name]
    assert quick_set.missing_tests(["tests/none.py::test_a"], []) == ["tests/none.py::test_a"]


def test_a_kernel_that_no_test_launches_is_found():
    kernels = quick_set.kernel_names()
    assert len(kernels) > 1000 and {"bound_points_kernel", "sum_moments"} <= kernels
    launched = {*kernels - {"bound_points_kernel", "sum_moments"}, "sum_moments_fold_tiles"}
    assert quick_set.unlisted_kernels(launched, ()) == ["bound_points_kernel"]
    assert quick_set.unlisted_kernels(launched, ["bound_points_kernel"]) == []


def test_the_file_names_only_kernels_that_exist():
    assert quick_set.read_set().kernels <= quick_set.kernel_names()
