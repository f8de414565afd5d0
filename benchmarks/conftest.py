"""Timing of an operation: contestants alternate on the same data, in laps, in one process.

In lap 0 a contestant prepares its data and makes one call, whose result is compared with pointloom's: a contestant that
disagrees is an error and is not timed further. This call compiles kernels and starts threads. It counts only for
baselines that take so long that they are not called again. Only the fastest baseline and pointloom determine the ratio
of a row, so a baseline that is clearly slower than the fastest one ends after lap 1.
"""

from __future__ import annotations

import gc
import math
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, NamedTuple

import pytest
from contest import POINTLOOM, Operation, Trial, limit_threads
from real_data import DataMissingError

LAPS = 3  # after lap 0
LAP_SECONDS = 0.3  # timed per lap, at least one round
CONTESTANT_SECONDS = 4.0  # a slow baseline stops after that
CLEARLY_SLOWER = 2.0  # times the fastest baseline
MAX_ROUNDS = 12  # per lap
PAUSE_SECONDS = 0.03  # waiting threads of the previous contestant spin for some ms before they sleep


class Lap(NamedTuple):
    """One contestant's rounds in one lap."""

    operation: Operation
    size: str
    label: str
    lap: int


@dataclass
class Entry:
    """A contestant that has started: the seconds of a usual call, of its calls so far, and of its fastest round."""

    trial: Trial
    estimate: float
    spent: float
    fastest: float = math.inf


class Contest:
    """One operation at one size: its data, or a message about missing data, and the contestants that have started."""

    def __init__(self, operation: Operation, size: str, device: str, quick: bool):
        self.operation, self.size, self.device = operation, size, device
        self.entries: dict[str, Entry] = {}
        self.our_facts: Any = None
        self.missing = ""
        gc.unfreeze()  # objects of earlier contests
        try:
            self.scene = operation.sizes(quick=quick, long=True)[size]()
        except DataMissingError as error:
            self.missing = str(error)
        else:
            self.unit_count = operation.unit_count(self.scene)

    def first_call(self, label: str, benchmark: Any) -> None:
        """Prepare a contestant, time its first call and compare its result with pointloom's."""
        contestant, run_device = self.operation.contestant(label, self.device)
        try:
            trial = contestant.trial(self.scene, run_device)
        except ModuleNotFoundError as error:
            pytest.skip(f"{label}: {error}")
        seconds, result = _timed(trial, benchmark, rounds=1)
        facts = contestant.facts(result)
        del result
        if label == POINTLOOM:
            self.our_facts = facts
            if seconds > CONTESTANT_SECONDS:
                self.entries[label] = Entry(trial, seconds, 0.0)
                return
            begin = time.perf_counter()
            trial.once()  # the first call compiles
            self.entries[label] = Entry(trial, time.perf_counter() - begin, 0.0)
            return
        if self.our_facts is not None:
            self.operation.check(self.our_facts, facts, label)
        self.entries[label] = Entry(trial, seconds, seconds)

    def later_calls(self, label: str, benchmark: Any) -> None:
        """Time the rounds of a later lap."""
        entry = self.entries.get(label)
        if entry is None:
            pytest.skip(f"{label} is out")
        if entry.spent > CONTESTANT_SECONDS:
            pytest.skip("has been timed long enough")
        baselines = [each.fastest for name, each in self.entries.items() if name != POINTLOOM]
        if label != POINTLOOM and CLEARLY_SLOWER * min(baselines) < entry.fastest < math.inf:
            pytest.skip("is clearly slower than another baseline")
        rounds = min(MAX_ROUNDS, max(1, int(LAP_SECONDS / max(entry.estimate, 1e-6))))
        seconds = _timed(entry.trial, benchmark, rounds)[0]
        entry.spent, entry.estimate = entry.spent + seconds, min(entry.estimate, seconds / rounds)
        if benchmark.stats:
            entry.fastest = min(entry.fastest, benchmark.stats.stats.min)


def _timed(trial: Trial, benchmark: Any, rounds: int) -> tuple[float, Any]:
    """Time some rounds: the total [s] and the last result. Results are freed outside the timed region.

    Existing objects are excluded from later garbage collections: those of the loaded libraries take 0.2 to 0.6 s each.
    """
    results: list[Any] = []

    def make() -> tuple[tuple[Any, ...], dict[str, Any]]:
        results.clear()
        return trial.arguments(), {}

    gc.collect()
    gc.freeze()
    time.sleep(PAUSE_SECONDS)
    benchmark.pedantic(lambda *arguments: results.append(trial.call(*arguments)), setup=make, rounds=rounds)
    return benchmark.stats.stats.total if benchmark.stats else 0.0, results.pop()  # no statistics if disabled


# ------------------------------------------------------------------------------------------------ pytest

_contest = pytest.StashKey[Contest | None]()
_problems = pytest.StashKey[dict[str, list[str]]]()


def pytest_addoption(parser: pytest.Parser) -> None:
    group = parser.getgroup("pointloom benchmarks")
    group.addoption("--bench-device", default="cpu", help="device of pointloom: cpu or cuda:0")
    group.addoption("--bench-quick", action="store_true", help="small sizes, one lap")
    group.addoption("--bench-long", action="store_true", help="the long sizes, too")
    group.addoption("--bench-operation", action="append", help="only this operation; may be repeated")


def pytest_configure(config: pytest.Config) -> None:
    limit_threads(config.getoption("--bench-device"))
    config.stash[_problems] = {"failed": [], "skipped": []}


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    operation, config = getattr(metafunc.function, "operation", None), metafunc.config
    if operation is None:
        return
    quick = config.getoption("--bench-quick")
    device, long = config.getoption("--bench-device"), config.getoption("--bench-long")
    sizes = operation.sizes(quick=quick, long=long)
    laps = 1 if quick else LAPS

    def names(size: str) -> list[str]:
        slow = () if long or device != "cpu" else operation.slow.get(size, ())
        return [label for contestant, _, label in operation.contestants_on(device) if contestant.name not in slow]

    parameters = [Lap(operation, s, label, lap) for s in sizes for lap in range(1 + laps) for label in names(s)]
    ids = [f"{t.size}-{t.label}-{t.lap}".replace(" ", "_") for t in parameters]
    metafunc.parametrize("time_lap", parameters, ids=ids, indirect=True)


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    requested = config.getoption("--bench-operation")
    if not requested:
        return
    selected = [item for item in items if item.function.operation.name in requested]
    config.hook.pytest_deselected(items=[i for i in items if i not in selected])
    items[:] = selected


def announce(item: pytest.Item) -> None:
    """Print the next operation and size and its number: the first call of each may compile for a long time."""
    pending = (other.callspec.params["time_lap"] for other in item.session.items if hasattr(other, "callspec"))
    cases = list(dict.fromkeys((lap.operation.name, lap.size) for lap in pending))
    lap = item.callspec.params["time_lap"]
    index = cases.index((lap.operation.name, lap.size))
    print(f"  {lap.operation.name} {lap.size} ({index + 1} of {len(cases)})", file=sys.stderr, flush=True)


@pytest.fixture
def time_lap(request: pytest.FixtureRequest, benchmark: Any) -> Iterator[Callable[[], None]]:
    """Time the rounds of one lap when called."""
    operation, size, label, lap = request.param
    stash = request.config.stash
    contest = stash.get(_contest, None)
    if contest is None or (contest.operation, contest.size) != (operation, size):
        stash[_contest] = contest = None  # frees the old data first
        announce(request.node)
        device, quick = (request.config.getoption(f"--bench-{name}") for name in ("device", "quick"))
        stash[_contest] = contest = Contest(operation, size, device, quick)
        if contest.missing:
            stash[_problems]["skipped"].append(f"{operation.name} {size}: {contest.missing}")
    if contest.missing:
        pytest.skip(contest.missing)

    def run_rounds() -> None:
        benchmark.group = f"{operation.name} {size}"
        (contest.later_calls if lap else contest.first_call)(label, benchmark)
        benchmark.extra_info.update(operation=operation.name, size=size, label=label, lap=lap, units=contest.unit_count)
        if benchmark.stats:
            best = 1000 * benchmark.stats.stats.min / contest.unit_count
            print(f"  {operation.name:18} {size:16} {label:20} lap {lap} {best:10.2f} ms", file=sys.stderr, flush=True)

    yield run_rounds


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    if report.failed and hasattr(report.longrepr, "reprcrash"):
        message = str(report.longrepr.reprcrash.message).split("\n")[0]
        print(f"  {report.nodeid.split('::')[-1]}: {message}", file=sys.stderr, flush=True)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item: pytest.Item) -> Any:
    report = yield
    if hasattr(item, "callspec") and (report.failed or report.skipped):
        lap = item.callspec.params["time_lap"]
        reason = report.longrepr[2] if report.skipped else str(report.longrepr.reprcrash.message).split("\n")[0]
        problems = item.config.stash[_problems]
        if report.failed:
            problems["failed"].append(f"{lap.operation.name} {lap.size} {lap.label}: {reason}")
        elif "No module" in reason:
            problems["skipped"].append(f"{lap.operation.name}: {reason.removeprefix('Skipped: ')}")
    return report


def pytest_unconfigure(config: pytest.Config) -> None:
    config.stash[_contest] = None  # tensors that exist when Open3D shuts down are reported as leaks


def pytest_benchmark_generate_machine_info() -> dict[str, str]:
    return {}  # contains the host name, and takes a second; run.py writes its own


def pytest_benchmark_generate_commit_info() -> dict[str, str]:
    return {}


def pytest_benchmark_update_json(config: pytest.Config, output_json: dict[str, Any]) -> None:
    output_json["problems"] = config.stash[_problems]
