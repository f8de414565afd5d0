"""The tests of `make test`, the compilers that tests run on, and the tests that share a process.

`make test` is `pytest --quick`, `make test-all` is pytest without it. `--quick` leaves out the tests that are marked
`slow` or `nightly`, those that need Open3D itself (tests/oracle.py) and all runs on Taichi, which is optional. CI runs
`--rest`, too: those but Taichi's, the `nightly` ones, and the ones in nightly_tests.txt (tests/rest_set.py), and with
real data all tests that read these. `make nightly` runs all others with `--nightly`, the tests that use stored answers
of Open3D among them, with Open3D, and Taichi's with `--taichi`. Without an option the tests of tests/kernels that take
`device`, and others marked `both_compilers`, run on Warp and on Taichi. tests/test_compilers.py compares all operations
on both.
"""

from __future__ import annotations

import importlib.util
import os
from collections.abc import Container, Sequence
from pathlib import Path
from typing import Any

import pytest

from . import oracle, rest_set

OPTION, REST, NIGHTLY, TAICHI = "--quick", "--rest", "--nightly", "--taichi"
COMPILERS = {"cpu-taichi": "taichi", "cpu-warp": "warp"}
HAS_TAICHI = importlib.util.find_spec("taichi") is not None
TESTS = Path(__file__).parent

# Groups of tests that take longest, the longest first, so that the last ones to be handed out are short. By the
# seconds of `make test`: only the order counts, and folders that are not named come behind these.
SLOWEST = (
    "emulated_cuda/test_orders.py", "emulated_cuda/test_host_calls.py",
    "registration", "pcd", "test_compilers.py", "tiling", "meshing", "visualization/viewer", "io", "cli",
    "kernels/language", "photogrammetry/sfm", "photogrammetry/depth", "rgbd/slam", "test_doctests.py",
    "kernels/reconstruction", "test_blocks.py", "rgbd/reconstruction", "visualization/render", "open3d",
    "test_imports.py", "kernels",
)  # fmt: skip


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(OPTION, action="store_true", help="the tests of `make test`: no slow ones, no Open3D, no Taichi")
    parser.addoption(REST, action="store_true", help="the tests that CI runs after those of --quick")
    parser.addoption(NIGHTLY, action="store_true", help="the tests that neither --quick nor --rest runs")
    parser.addoption(TAICHI, action="store_true", help="the tests that run on Taichi")


def cpu_devices_of(definition: pytest.Item) -> list[str]:
    """The CPU runs of a test that takes `device`, as its name gives them."""
    both = definition.get_closest_marker("both_compilers") is not None or TESTS / "kernels" in definition.path.parents
    return [name for name, compiler in COMPILERS.items() if both or compiler == "warp"]


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out tests, and begin with the groups that take longest in processes of pytest-xdist."""
    quick, rest, nightly = (config.getoption(option) for option in (OPTION, REST, NIGHTLY))
    taichi, mode = config.getoption(TAICHI), oracle.mode_of(config)
    left_out = rest_set.left_out() if rest or nightly else ()
    selected = [
        item
        for item in items
        if (HAS_TAICHI or not needs_taichi(item))
        and oracle.is_selected(mode, fixtures_of(item))
        and not (quick and is_left_out(item))
        and (not rest or is_in_rest(item, left_out))
        and (not nightly or is_in_nightly(item, left_out))
        and (not taichi or needs_taichi(item))
    ]
    if len(selected) < len(items):
        chosen = set(selected)
        config.hook.pytest_deselected(items=[item for item in items if item not in chosen])
        items[:] = selected
    if hasattr(config, "workerinput"):
        items.sort(key=lambda item: rank_of(group_of(item.path), SLOWEST))


def is_left_out(item: pytest.Item) -> bool:
    """True if a test does not run in `make test`."""
    marks = {mark.name for mark in item.iter_markers()}
    return bool(marks & {"slow", "nightly"}) or needs_taichi(item) or "o3d" in fixtures_of(item)


def is_in_rest(item: pytest.Item, left_out: Container[str]) -> bool:
    """True if CI runs a test after `make test`."""
    is_nightly = item.get_closest_marker("nightly") is not None or item.nodeid in left_out
    reads_data = item.get_closest_marker("real_data") is not None and bool(os.environ.get("POINTLOOM_DATA"))
    return (is_left_out(item) or reads_data) and not is_nightly and not needs_taichi(item)


def is_in_nightly(item: pytest.Item, left_out: Container[str]) -> bool:
    """True if only `make nightly` runs a test, or runs it with Open3D instead of a stored answer."""
    if needs_taichi(item):
        return False
    return "oracle" in fixtures_of(item) or (is_left_out(item) and not is_in_rest(item, left_out))


def fixtures_of(item: pytest.Item) -> Sequence[str]:
    return getattr(item, "fixturenames", ())


def needs_taichi(item: pytest.Item) -> bool:
    """True if a test runs on Taichi, by its mark or by a parameter."""
    parameters = getattr(item, "callspec", None)
    words = [value for value in parameters.params.values() if isinstance(value, str)] if parameters else []
    return item.get_closest_marker("taichi") is not None or "taichi" in words or "cpu-taichi" in words


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Tests of a subpackage share a process, which loads its kernels and makes its fixtures once.

    By the names of the tests: what xdist_group adds to them for `--dist loadgroup` does not arrive under pytest 9.2.
    """
    from xdist.scheduler import LoadScopeScheduling

    class PackageScheduling(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return group_of(config.rootpath / nodeid.partition("::")[0])

    return PackageScheduling(config, log)


def group_of(path: Path) -> str:
    """The package or subpackage of a test file; for a file directly in tests/ or in tests/emulated_cuda, the file."""
    package, *rest = path.relative_to(TESTS).parts
    return "/".join([package, *(rest if package == "emulated_cuda" else rest[:-1])[:1]])


def rank_of(group: str, slowest: Sequence[str]) -> int:
    return slowest.index(group) if group in slowest else len(slowest)
