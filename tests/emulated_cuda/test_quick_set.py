"""The choice of the tests that CI runs, and the file that names the others."""

from ..smallest_set import LeftOut, Taken, smallest_set

TESTS = {
    "fast": Taken(0.1, items={1, 2}),
    "slow, takes all": Taken(9.0, items={1, 2, 3, 4}),
    "third": Taken(0.1, items={3}),
    "both": Taken(0.5, items={2, 3}),
    "alone": Taken(5.0, items={4}),
    "required": Taken(2.0, items={3}),
}
CASES = [f"tests/a.py::test_a[{k}]" for k in range(4)]
OTHERS = ["tests/a.py::test_b", "tests/b.py::test_c[x: y z]", "tests/b.py::test_c[other]"]


def test_the_smallest_set_takes_all_items_in_the_fewest_seconds():
    assert smallest_set({name: TESTS[name] for name in TESTS if name != "required"}) == {"fast", "third", "alone"}
    assert smallest_set(TESTS, ["required"]) == {"required", "fast", "alone"}


def test_a_test_whose_items_later_tests_take_is_removed():
    """A greedy choice begins with the test of many items, which the two others then replace."""
    tests = {"many": Taken(0.6, items={1, 2, 3, 4}), "a": Taken(0.5, items={1, 2, 5}), "b": Taken(0.5, items={3, 4, 6})}
    assert smallest_set(tests) == {"a", "b"}


def written(left_out: LeftOut, path) -> LeftOut:
    left_out.write(path, "# a comment\n")
    return LeftOut(path)


def test_all_tests_run_but_those_left_out(tmp_path):
    left = {*CASES[:3], *OTHERS[:2]}
    left_out = LeftOut()
    left_out.leave_out(left, [*CASES, *OTHERS])
    read = written(left_out, tmp_path / "set.txt")
    assert {node for node in [*CASES, *OTHERS] if node in read} == left
    new = ["tests/a.py::test_new", "tests/c.py::test_a[0]", "tests/b.py::test_c[new]"]
    assert not [node for node in new if node in read]
    assert "tests/a.py::test_a[new]" in read  # most cases of the function are


def test_a_smaller_set_is_chosen_from_the_tests_of_an_earlier_one(tmp_path):
    """Of a function that was left out, only the case that ran was a candidate."""
    left_out = LeftOut()
    left_out.leave_out(CASES[:3], CASES)
    for left, expected in (([], CASES[:3]), (CASES[3:], CASES)):
        left_out = written(left_out, tmp_path / "set.txt")
        left_out.leave_out(left, [CASES[3], OTHERS[0]])
        assert [node for node in [*CASES, *OTHERS] if node in left_out] == expected
