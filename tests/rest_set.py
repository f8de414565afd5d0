"""The tests that CI leaves to `make nightly` because other tests take the same lines: nightly_tests.txt.

    make rest-set    measures the lines that each test takes, and writes the file

CI runs the quick tests (`make test`) and then the rest (`--rest`). Of the rest it needs the least expensive tests that
take each line of the product that no quick test takes, and the tests that start processes (their lines are not
measured). All others are in the file. A new test is not in the file, so CI runs it.
"""

from __future__ import annotations

import sys
from collections.abc import Iterable
from pathlib import Path

import pytest

from .smallest_set import LeftOut, Recorder, Taken, recorded, smallest_set

OPTION, TOGETHER = "--lines", "--lines-together"
TESTS = Path(__file__).parent
ROOT = TESTS.parent
FILE = TESTS / "nightly_tests.txt"
PRODUCT = ROOT / "src"
LINES_OF_FILE = 100_000  # number of a line: number of its file times this, plus the line
CHILD_SECONDS = 0.5  # CPU [s] of child processes from which on a test is one of processes
HEAD = """\
# Tests that CI leaves to `make nightly`: other tests take the same lines. Written by `make rest-set` (rest_set.py).
"""


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(OPTION, metavar="FOLDER", help="write the lines that each test takes into this folder")
    parser.addoption(TOGETHER, action="store_true", help="with --lines: the lines of all tests together")


def pytest_configure(config: pytest.Config) -> None:
    if folder := config.getoption(OPTION):
        config.pluginmanager.register(LineContexts(Path(folder).resolve(), together=config.getoption(TOGETHER)))


def left_out() -> LeftOut:
    """The tests in the file."""
    return LeftOut(FILE)


class LineContexts(Recorder):
    """Records the lines of the product that each test takes in its process, with the package coverage."""

    def __init__(self, folder: Path, *, together: bool) -> None:
        import coverage

        super().__init__(folder)
        self.together = together
        self.coverage = coverage.Coverage(data_file=None, config_file=False, source=[str(PRODUCT)])
        self.coverage.start()

    def begin(self, node: str) -> None:
        if not self.together:
            self.coverage.switch_context(node)

    def end(self) -> Iterable[int]:
        return ()

    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        if not self.tests:
            return
        self.coverage.stop()
        data, files = self.coverage.get_data(), {str(path): k for k, path in enumerate(product_files())}
        taken: dict[str, set[int]] = {}
        for file in data.measured_files():
            if (number := files.get(str(Path(file).resolve()))) is None:  # of a test, since removed
                continue
            first = LINES_OF_FILE * number
            if self.together:
                taken.setdefault("", set()).update(first + line for line in data.lines(file) or ())
                continue
            for line, contexts in data.contexts_by_lineno(file).items():
                for node in filter(None, contexts):  # lines of imports belong to no test
                    taken.setdefault(node, set()).add(first + line)
        for node, items in taken.items():
            self.tests.setdefault(node, [0.0, 0.0, ()])[2] = sorted(items)
        super().pytest_sessionfinish(session)


def product_files() -> list[Path]:
    """All modules of the product, in the order of their names."""
    return sorted(path.resolve() for path in PRODUCT.rglob("*.py"))


def required_tests(tests: dict[str, Taken]) -> set[str]:
    """The tests that CI keeps in any case: those of processes."""
    return {name for name, taken in tests.items() if taken.of_children > CHILD_SECONDS}


def main(folder: Path) -> int:
    """Write the file by the records of `folder`/quick and `folder`/rest, and print what was chosen."""
    quick = set().union(*(taken.items for taken in recorded(folder / "quick").values()))
    tests = recorded(folder / "rest")
    for taken in tests.values():
        taken.items -= quick
    chosen = smallest_set(tests, required_tests(tests))
    left = tests.keys() - chosen
    written = left_out()
    written.leave_out(left, tests)
    written.write(FILE, HEAD)
    for title, names in (("run by CI", chosen), ("left to nightly", left)):
        print(f"{title}: {len(names)} tests, {sum(tests[name].seconds for name in names):.0f} CPU s")
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
