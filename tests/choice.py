"""Which compilers the tests run on, and which tests share a process: what `make test` leaves out of `make test-all`.

`make test` is `pytest -m "not slow" --compilers warp`, `make test-all` is pytest without these. A test that takes
`device` and is marked `both_compilers` runs on both in either: the tests of the compilers themselves. That Taichi makes
of each operation what Warp makes of it is the claim of tests/test_compilers.py, which runs in either too. CI runs
`make test-all` with `--compilers kernels`: on both what is in tests/kernels too, where kernels meet all that they may.

Taichi is optional. Where it is not installed, what is marked `taichi` or has a parameter that says Taichi is left out;
one that is installed and does not import is no reason to leave out anything.
"""

from __future__ import annotations

import importlib.util
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

OPTION = "--compilers"
COMPILERS = {"cpu-taichi": "taichi", "cpu-warp": "warp"}
HAS_TAICHI = importlib.util.find_spec("taichi") is not None
TESTS = Path(__file__).parent

# Groups of tests that take longest, the longest first, so that the last ones to be handed out are short. By the
# seconds of `make test`: only the order counts, and folders that are not named come behind these.
DEAREST = (
    "registration", "pcd", "test_compilers.py", "scale", "meshing", "drawing/viewer", "files", "app",
    "kernels/language", "photos/sfm", "photos/depth", "rgbd/slam", "test_doctests.py", "kernels/reconstruction",
    "test_blocks.py", "rgbd/reconstruction", "drawing/render", "bridge", "test_imports.py", "kernels",
)  # fmt: skip


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        OPTION,
        choices=("both", "kernels", "warp"),
        default="both",
        help="CPU compilers of tests that are not of the compilers; kernels: both in tests/kernels, Warp elsewhere",
    )


def places_of(config: pytest.Config, definition: pytest.Item) -> list[str]:
    """The CPU runs of a test that takes `device`, as its name says them."""
    return [place for place, compiler in COMPILERS.items() if compiler == "warp" or runs_on_both(config, definition)]


def runs_on_both(config: pytest.Config, item: pytest.Item) -> bool:
    """Whether a test that takes `device` has runs on either compiler."""
    chosen = config.getoption(OPTION)
    if chosen == "both" or item.get_closest_marker("both_compilers") is not None:
        return True
    return chosen == "kernels" and TESTS / "kernels" in item.path.parents


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Taichi's tests are left out where it is not; the dearest rooms begin, in processes of pytest-xdist."""
    left_out = [item for item in items if is_of_taichi(item)] if not HAS_TAICHI else []
    if left_out:
        config.hook.pytest_deselected(items=left_out)
        items[:] = [item for item in items if not is_of_taichi(item)]
    if hasattr(config, "workerinput"):
        items.sort(key=lambda item: rank_of(group_of(item.path), DEAREST))


def is_of_taichi(item: pytest.Item) -> bool:
    """Whether a test asks for Taichi, by its mark or by a parameter."""
    parameters = getattr(item, "callspec", None)
    words = [value for value in parameters.params.values() if isinstance(value, str)] if parameters else []
    return item.get_closest_marker("taichi") is not None or "taichi" in words or "cpu-taichi" in words


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """Tests of a room share a process, which so loads the room's kernels once, and makes its fixtures once.

    By the names of the tests: what xdist_group adds to them for `--dist loadgroup` does not arrive under pytest 9.2.
    """
    from xdist.scheduler import LoadScopeScheduling

    class Rooms(LoadScopeScheduling):
        def _split_scope(self, nodeid: str) -> str:
            return group_of(config.rootpath / nodeid.partition("::")[0])

    return Rooms(config, log)


def group_of(path: Path) -> str:
    """The house of a test file, or its room where it has rooms; of a file that lies beside the houses, itself."""
    house, *rest = path.relative_to(TESTS).parts
    return "/".join([house, *rest[:-1][:1]])


def rank_of(group: str, dearest: Sequence[str]) -> int:
    return dearest.index(group) if group in dearest else len(dearest)
