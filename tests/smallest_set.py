"""The smallest set of tests that takes all that a larger set takes, by the CPU seconds of each test.

The items of a test are what it takes of the product: branches of kernels (tests/emulated_cuda/quick_set.py) or lines of
Python (tests/rest_set.py). Weighted set cover is solved greedily (Chvatal, "A greedy heuristic for the set-covering
problem", Mathematics of Operations Research 1979). Then tests whose items the others take are removed, the slowest
first.
"""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest

from .cpu_seconds import cpu_seconds

KEPT = "+ "  # begins the name of a case that runs although its function is left out
FIXED_SECONDS = 0.05  # CPU [s] of any test: its collection, its fixtures, its report


@dataclass
class Taken:
    """What a test takes.

    Attributes:
        seconds: CPU seconds of the test and of its child processes.
        of_children: CPU seconds of its child processes alone.
        items: Numbers of the items that it takes.
    """

    seconds: float
    of_children: float = 0.0
    items: set[int] = field(default_factory=set)


def smallest_set(tests: Mapping[str, Taken], required: Collection[str] = ()) -> set[str]:
    """Names of tests that take all items of all tests: the required ones and the least expensive others.

    Args:
        tests: Each candidate by its name.
        required: Names that are in the result in any case.
    """
    count = Counter(item for name in required for item in tests[name].items)
    open_items = set().union(*(taken.items for taken in tests.values())) - count.keys()
    remaining = {name: taken.items & open_items for name, taken in sorted(tests.items()) if name not in set(required)}
    chosen: list[str] = []
    while open_items:
        best = max(remaining, key=lambda name: len(remaining[name]) / (tests[name].seconds + FIXED_SECONDS))
        taken = remaining.pop(best)
        chosen.append(best)
        count.update(tests[best].items)
        open_items -= taken
        remaining = {name: rest for name, items in remaining.items() if (rest := items - taken)}
    for name in sorted(chosen, key=lambda name: -tests[name].seconds):
        if all(count[item] > 1 for item in tests[name].items):
            chosen.remove(name)
            count.subtract(tests[name].items)
    return {*required, *chosen}


class Recorder:
    """A plugin of pytest that writes what each test takes: a file for each process, read by `recorded`.

    Subclasses define `begin` and `end`.
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.tests: dict[str, list[Any]] = {}  # seconds, seconds of child processes, items

    def begin(self, node: str) -> None:
        """Forget what was taken before a test."""
        raise NotImplementedError

    def end(self) -> Iterable[int]:
        """Numbers of what was taken since `begin`."""
        raise NotImplementedError

    @pytest.hookimpl(wrapper=True, tryfirst=True)
    def pytest_runtest_protocol(self, item: pytest.Item) -> Iterator[Any]:
        self.begin(item.nodeid)
        own, children = cpu_seconds()
        result = yield
        own, children = (now - before for now, before in zip(cpu_seconds(), (own, children), strict=True))
        self.tests[item.nodeid] = [round(own + children, 3), round(children, 3), sorted(self.end())]
        return result

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if self.tests:
            process = getattr(session.config, "workerinput", {}).get("workerid", "main")
            self.folder.mkdir(parents=True, exist_ok=True)
            (self.folder / f"{process}.json").write_text(json.dumps(self.tests))


def recorded(folder: Path) -> dict[str, Taken]:
    """The tests of all processes that a Recorder wrote into a folder."""
    tests = {}
    for path in sorted(folder.glob("*.json")):
        for name, (seconds, of_children, items) in json.loads(path.read_text()).items():
            known = tests.setdefault(name, Taken(seconds, of_children))
            known.items.update(items)
    return tests


class LeftOut:
    """The tests that a set leaves out, by the names in a file. All others run: new ones, too.

    A line of the file is the path of tests and the names of functions, or the name of one case. A name without a test
    has no effect.
    """

    def __init__(self, path: Path | None = None) -> None:
        text = path.read_text() if path is not None and path.exists() else ""
        lines = [line for line in text.splitlines() if line and not line.startswith("#")]
        self.kept = {line.removeprefix(KEPT) for line in lines if line.startswith(KEPT)}
        self.cases = {line for line in lines if "::" in line and not line.startswith(KEPT)}
        files = (line.partition(": ") for line in lines if "::" not in line)
        self.functions = {f"{file}::{name}" for file, _, names in files for name in names.split()}

    def __contains__(self, node: str) -> bool:
        """True if a test is left out."""
        return node in self.cases or (node.partition("[")[0] in self.functions and node not in self.kept)

    def leave_out(self, left: Collection[str], every: Iterable[str]) -> None:
        """Leave out tests, and no others of `every`: a function instead of its cases if most of them are."""
        cases: dict[str, set[str]] = {}
        for node in every:
            cases.setdefault(node.partition("[")[0], set()).add(node)
        for function, nodes in cases.items():
            out = nodes & set(left)
            self.kept -= nodes
            self.cases -= nodes
            if function in self.functions or 2 * len(out) > len(nodes):
                self.functions.add(function)
                self.kept |= nodes - out
            else:
                self.cases |= out

    def write(self, path: Path, head: str) -> None:
        """Write the file below a comment."""
        names: dict[str, list[str]] = {}
        for function in sorted(self.functions):
            file, _, name = function.partition("::")
            names.setdefault(file, []).append(name)
        lines = [f"{file}: {' '.join(functions)}" for file, functions in names.items()]
        lines += [*sorted(self.cases), *(KEPT + name for name in sorted(self.kept))]
        path.write_text(head + "".join(f"{line}\n" for line in lines))
