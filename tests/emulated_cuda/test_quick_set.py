"""The quick set names tests that exist."""

import pytest

from .kernel_coverage import ROOT
from .quick_set import PREFIXES, is_in_quick_set


@pytest.mark.parametrize("prefix", PREFIXES)
def test_each_name_begins_a_test_that_exists(prefix):
    path, _, name = prefix.partition("::")
    assert (ROOT / path).exists()
    assert not name or f"\ndef {name.partition('[')[0]}" in (ROOT / path).read_text()


def test_a_run_on_the_device_is_in_the_set_and_one_on_the_cpu_is_not():
    test = "tests/pcd/test_hulls.py::test_the_hull_of_a_made_cloud_is_open3ds"
    assert is_in_quick_set(f"{test}[cuda:0-slab-stretch1]") and not is_in_quick_set(f"{test}[cpu-warp-slab-stretch1]")
    assert not is_in_quick_set("tests/pcd/test_hulls.py::test_another[cuda:0]")
