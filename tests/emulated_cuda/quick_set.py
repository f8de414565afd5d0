"""The tests that CI runs on the emulated device, in order 3: quick_set.txt.

    make emulated-set              measures which branches of kernels each test takes, and writes the file
    make emulated-set TESTS=full   with all tests of cuda:0 as candidates (hours)

The set consists of the tests of tests/emulated_cuda (host calls, streams, memory, orders of threads) that take at most
MAX_SECONDS, and of the least expensive others that take the same branches of kernels as all candidates together. A run
of the whole set fails if a kernel is neither launched nor named in the file, so that a new kernel gets a test.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Collection, Iterable
from pathlib import Path
from typing import NamedTuple

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tests.emulated_cuda import kernel_coverage
from tests.smallest_set import recorded, smallest_set

FOLDER = "tests/emulated_cuda/"
FILE = Path(__file__).with_name("quick_set.txt")
MAX_SECONDS = 1.0  # CPU [s] of a test of the device that is in the set in any case
NOT_LAUNCHED, LEFT_OUT = "not launched: ", "left out: "  # begin the lines of kernels and of tests of the device
KERNELS = {"kernel", "reduction", "segment_reduction"}
HEAD = """\
# Tests that CI runs on the emulated CUDA device beside those of tests/emulated_cuda that are not left out. Written by
# `make emulated-set` (quick_set.py): {chosen} of {candidates} tests, {seconds:.0f} of {all_seconds:.0f} CPU s, with all
# {items} outcomes of conditions and starts of functions.
"""


class QuickSet(NamedTuple):
    """The content of the file.

    Attributes:
        tests: Names of tests that the set needs beside those of the device.
        left_out: Names of tests of the device that are not in the set.
        kernels: Names of kernels that the set does not launch.
    """

    tests: frozenset[str]
    left_out: frozenset[str]
    kernels: frozenset[str]


def read_set(path: Path = FILE) -> QuickSet:
    """The content of the file."""
    lines = [line for line in path.read_text().splitlines() if line and not line.startswith("#")]
    left_out, kernels = (
        frozenset(line.removeprefix(start) for line in lines if line.startswith(start))
        for start in (LEFT_OUT, NOT_LAUNCHED)
    )
    return QuickSet(
        frozenset(line for line in lines if not line.startswith((LEFT_OUT, NOT_LAUNCHED))), left_out, kernels
    )


def missing_tests(names: Iterable[str], collected: Iterable[str]) -> list[str]:
    """The names whose file was collected, but which are no tests of it."""
    nodes = set(collected)
    files = {node.partition("::")[0] for node in nodes}
    root = kernel_coverage.ROOT
    return sorted(
        name
        for name in names
        if name not in nodes and (name.partition("::")[0] in files or not (root / name.partition("::")[0]).exists())
    )


def kernel_names() -> set[str]:
    """The names of all kernels of kernels/."""
    functions = (f for path in kernel_coverage.kernel_files() for f in kernel_coverage.functions_of(path))
    return {function.name for function in functions if kernel_coverage.is_device_code(function, KERNELS)}


def started_functions(items: Collection[int]) -> set[str]:
    """The names of the device functions that tests started, by the marks that they took (plugin.py)."""
    functions = (f for path in kernel_coverage.kernel_files() for f in kernel_coverage.functions_of(path))
    return {f.name for f in functions if hasattr(f, "mark") and 2 * f.mark + kernel_coverage.TRUE in items}


def unlisted_kernels(launched: Collection[str], listed: Collection[str]) -> list[str]:
    """Kernels that a run did not launch and that are not listed.

    A reduction is several kernels whose names begin with its name.
    """
    starts = {name[: match.end()] for name in launched for match in re.finditer(r"[^_](?=_|$)", name)}
    return sorted(kernel_names() - starts - set(listed))


def write(contexts: Path) -> str:
    """Choose the tests by what each took, and write the file; returns its head."""
    tests = recorded(contexts)
    of_device = {name for name in tests if name.startswith(FOLDER)}
    chosen = smallest_set(tests, {name for name in of_device if tests[name].seconds <= MAX_SECONDS})
    items = set().union(*(taken.items for taken in tests.values()))
    head = HEAD.format(
        chosen=len(chosen),
        candidates=len(tests),
        seconds=sum(tests[name].seconds for name in chosen),
        all_seconds=sum(taken.seconds for taken in tests.values()),
        items=len(items),
    )
    lines = sorted(chosen - of_device)
    lines += [LEFT_OUT + name for name in sorted(of_device - chosen)]
    lines += [NOT_LAUNCHED + kernel for kernel in sorted(kernel_names() - started_functions(items))]
    FILE.write_text(head + "".join(f"{line}\n" for line in lines))
    return head


if __name__ == "__main__":
    print(write(Path(sys.argv[1])), end="")
