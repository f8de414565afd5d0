"""Check the speed of 24 operations in 90 seconds, each beside its best baseline, against recorded ratios.

make speed                                one line per row; exit code 1 if a row is slower than recorded in two tries
make speed ARGS="--only odometry"         rows by name prefix
make speed ARGS=--record                  measure five times and store the medians for this processor

The ratio of a row is the baseline's time divided by pointloom's. README.md ("Speed check") describes the method.
"""

from __future__ import annotations

import argparse
import contextlib
import datetime
import gc
import importlib.util
import io
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

STARTED = time.monotonic()
FOLDER = Path(__file__).resolve().parent
sys.path.insert(0, str(FOLDER))

from contest import POINTLOOM, Operation, Trial, limit_threads, operations, thread_count, versions  # noqa: E402
from run import git  # noqa: E402

RECORDS = FOLDER / "results" / "speed-cpu.json"
BENCH_RESULTS = FOLDER / "results" / "operations-cpu.json"
LIMIT = 0.8  # smallest accepted factor of the recorded ratio, if the record is of this processor
OTHER_PROCESSOR_LIMIT = 0.4  # the same for a record of another processor: AMD and Intel differ by factors down to 0.59
TOTAL_SECONDS = 85.0  # of a whole check; second tries share what is left of it
ROW_SECONDS = 1.5  # of timed rounds in a first try
RETRY_SECONDS = (3.0, 8.0)  # the same in a second try: lower and upper bound
MIN_PAIRS, MAX_PAIRS = 3, 25
CLEAR_PAIRS = 5  # pairs after which a row that is clearly above the limit ends early
CLEAR_MARGIN = 1.15  # times the limit
MAX_REPEATS = 4  # rounds of the faster contestant in one pair
MIN_REPEATS = 2  # of short calls: the first one after a pause is up to twice as slow on some virtual machines
SHORT_CALL = 0.1  # [s]; a longer call is hardly changed by the pause before it
PAUSE_SECONDS = 0.03  # between contestants: waiting threads of the previous one spin for some ms before they sleep
BUSY_CORES = 0.25  # used by other processes: above it the machine is busy
RECORD_RUNS = 5
MIN_MACHINE_ROWS = 8  # rows whose baselines tell how fast this machine is beside that of the record


class Row(NamedTuple):
    """An operation at one size, and the label of its best baseline."""

    operation: str
    size: str
    baseline: str

    @property
    def key(self) -> tuple[str, str]:
        """Operation and size, which identify a row in a record."""
        return self.operation, self.size

    def __str__(self) -> str:
        return f"{self.operation} {self.size}"


ROWS = (
    Row("voxel_down_sample", "200k", "small_gicp"),
    Row("normals_hybrid", "50k", "open3d-tensor"),
    Row("knn20_query", "lidar synthetic", "small_gicp"),
    Row("statistical_outliers", "50k", "open3d-legacy"),
    Row("dbscan", "50k", "open3d-legacy"),
    Row("segment_plane", "50k", "open3d-legacy"),
    Row("orient_consistently", "20k", "open3d-legacy"),
    Row("hidden_points", "50k", "open3d-legacy"),
    Row("convex_hull", "200k", "open3d-legacy"),
    Row("cloud_distance", "200k", "pykdtree"),
    Row("fpfh", "50k", "open3d-tensor"),
    Row("feature_matching", "8k", "open3d-tensor"),
    Row("register_globally", "200k, 8 cm", "kiss-matcher"),
    Row("icp_plane", "20k", "small_gicp"),
    Row("gicp", "200k", "small_gicp"),
    Row("odometry", "64 beams, 115k", "rko-lio, no deskewing"),
    Row("odometry", "16 beams, 14k", "rko-lio, no deskewing"),
    Row("depth_to_cloud_with_normals", "3 frames", "open3d-tensor"),
    Row("rgbd_odometry", "pair", "open3d-tensor"),
    Row("tsdf_integrate", "3 frames", "open3d-tensor"),
    Row("tsdf_mesh", "3 frames", "open3d-tensor"),
    Row("marching_cubes", "256^3", "vtk"),
    Row("ray_casting", "camera 1280x960", "open3d-tensor"),
    Row("decimation", "wavy 76k to 7k", "fast-simplification"),
)
PACKAGES = {  # of the baselines; a module has the same name with underscores
    "open3d-legacy": "open3d",
    "open3d-tensor": "open3d",
    "small_gicp": "small_gicp",
    "pykdtree": "pykdtree",
    "kiss-matcher": "kiss-matcher",
    "rko-lio, no deskewing": "rko-lio",
    "vtk": "vtk",
    "fast-simplification": "fast-simplification",
}


def mesh_to_simplify() -> Any:
    """A closed surface of 76,460 triangles, and a tenth of them as target; the benchmark's middle size is real data."""
    from bench_decimation import wavy

    return wavy(128, 0.1)


OWN_SCENES = {("decimation", "wavy 76k to 7k"): mesh_to_simplify}


def scene_of(row: Row, operation: Operation) -> Callable[[], Any]:
    """The function that creates the data of a row, also from the sizes of quick runs."""
    sizes = {**operation.scenes, **operation.quick}
    return sizes[row.size] if row.size in sizes else OWN_SCENES[row.key]


# ------------------------------------------------------------------------------------------------ times


def used_core_seconds() -> float:
    """Seconds that the available cores have spent on all processes; NaN where the system does not report them."""
    try:
        lines = Path("/proc/stat").read_text().splitlines()
        cores = {f"cpu{core}" for core in os.sched_getaffinity(0)}
    except (OSError, AttributeError):
        return float("nan")
    used = 0
    for name, *values in map(str.split, lines):
        if name in cores:
            user, nice, system, _idle, _wait, irq, soft_irq, stolen, *_ = map(int, values)
            used += user + nice + system + irq + soft_irq + stolen  # by other virtual machines
    return used / os.sysconf("SC_CLK_TCK")


@dataclass(frozen=True)
class Clock:
    """The functions that read and spend time. Tests replace them.

    Attributes:
        wall: Time [s].
        cpu: CPU time of all threads of this process [s].
        cores: CPU time of all processes on the available cores [s].
        sleep: Waits for some seconds.
    """

    wall: Callable[[], float] = time.perf_counter
    cpu: Callable[[], float] = time.process_time
    cores: Callable[[], float] = used_core_seconds
    sleep: Callable[[float], None] = time.sleep


class Round(NamedTuple):
    """Wall and CPU seconds of one call."""

    wall: float
    cpu: float


@dataclass
class Rounds:
    """Rounds of pointloom and of the baseline in alternation.

    Attributes:
        pairs: The rounds of both contestants in each pair, pointloom first.
        other_load: Cores that other processes used meanwhile.
    """

    pairs: list[tuple[list[Round], list[Round]]] = field(default_factory=list)
    other_load: float = 0.0

    def best(self, side: int) -> float:
        """Seconds of the fastest round: other load only adds time."""
        return min(call.wall for pair in self.pairs for call in pair[side])

    @property
    def ratio(self) -> float:
        """The baseline's time divided by pointloom's, of the fastest rounds."""
        return self.best(1) / self.best(0)

    @property
    def cpu_ratio(self) -> float:
        """The same of CPU times, which another process changes less."""
        ours, theirs = (min(call.cpu for pair in self.pairs for call in pair[side]) for side in (0, 1))
        return theirs / max(ours, 1e-9)

    @property
    def is_busy(self) -> bool:
        """True if other processes used the cores."""
        return self.other_load > BUSY_CORES


@contextlib.contextmanager
def few_objects_to_collect() -> Iterator[None]:
    """Exclude the existing objects from garbage collection, which then takes no time and only runs between rounds."""
    gc.collect()
    gc.freeze()
    gc.disable()
    try:
        yield
    finally:
        gc.enable()
        gc.unfreeze()


class ResultsDisagreeError(Exception):
    """The results of pointloom and of the baseline differ."""


class Contest:
    """The two contestants of a row, prepared on the same data; their first results agree.

    Raises:
        ResultsDisagreeError: They do not.
    """

    def __init__(self, row: Row, operation: Operation, clock: Clock):
        self.row, self.clock, self.trials = row, clock, []
        scene, facts = scene_of(row, operation)(), []
        for label in (POINTLOOM, row.baseline):
            contestant, device = operation.contestant(label, "cpu")
            trial = contestant.trial(scene, device)
            facts.append(contestant.facts(trial.once()))
            self.trials.append(trial)
        try:
            with contextlib.redirect_stderr(io.StringIO()):  # some checks print distances
                operation.check(*facts, row.baseline)
        except AssertionError as error:
            reason = str(error).strip().splitlines() or ["the results differ"]
            raise ResultsDisagreeError(reason[0]) from error
        del facts
        with few_objects_to_collect():
            estimates = [self._rounds(trial, 1)[0].wall for trial in self.trials]  # the first call compiled
        self.repeats = [
            max(MIN_REPEATS if e < SHORT_CALL else 1, min(MAX_REPEATS, int(max(estimates) / (3 * max(e, 1e-9)))))
            for e in estimates
        ]

    def run(self, seconds: float, is_enough: Callable[[Rounds], bool] = lambda rounds: False) -> Rounds:
        """Time pairs of rounds for some seconds, or until there are enough."""
        with few_objects_to_collect():
            return self._run(seconds, is_enough)

    def _run(self, seconds: float, is_enough: Callable[[Rounds], bool]) -> Rounds:
        rounds, begin, cpu, cores = Rounds(), self.clock.wall(), self.clock.cpu(), self.clock.cores()
        while True:
            ours, theirs = map(self._rounds, self.trials, self.repeats)
            rounds.pairs.append((ours, theirs))
            spent, count = self.clock.wall() - begin, len(rounds.pairs)
            other = self.clock.cores() - cores - (self.clock.cpu() - cpu)
            rounds.other_load = max(0.0, other / spent) if spent > 0 and other == other else 0.0
            is_over = spent + spent / count > seconds or count >= MAX_PAIRS
            if count >= MIN_PAIRS and (is_over or is_enough(rounds)):
                return rounds

    def _rounds(self, trial: Trial, count: int) -> list[Round]:
        """Time some calls of one contestant, after a pause."""
        self.clock.sleep(PAUSE_SECONDS)
        return [self._round(trial) for _ in range(count)]

    def _round(self, trial: Trial) -> Round:
        """Time one call. Its arguments are made and its result is freed outside of the timed region."""
        arguments = trial.arguments()
        gc.collect()
        wall, cpu = self.clock.wall(), self.clock.cpu()
        result = trial.call(*arguments)
        wall, cpu = self.clock.wall() - wall, self.clock.cpu() - cpu
        del result
        return Round(wall, cpu)


def contests(rows: Sequence[Row], clock: Clock) -> Iterator[tuple[Row, Contest | ResultsDisagreeError]]:
    """Yield each row with its contestants ready."""
    known = operations()
    for row in rows:
        try:
            contest = Contest(row, known[row.operation][1], clock)
        except ResultsDisagreeError as error:
            yield row, error
            continue
        yield row, contest


# ------------------------------------------------------------------------------------------------ records


class Expected(NamedTuple):
    """The recorded ratio of a row.

    Attributes:
        ratio: Of wall times.
        cpu_ratio: Of CPU times; None if not recorded.
        limit: Smallest accepted factor.
        source: The commit, date and processor of the record.
        commit: The commit alone.
        seconds: Recorded times of pointloom and of the baseline [s], of this processor; None if not recorded.
    """

    ratio: float
    cpu_ratio: float | None
    limit: float
    source: str = ""
    commit: str = ""
    seconds: tuple[float, float] | None = None


def processor() -> str:
    """Model name, family and model number of the processor, and the number of cores in use."""
    facts: dict[str, str] = {}
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            name, _, value = line.partition(":")
            facts.setdefault(name.strip(), value.strip())
        cores = len(os.sched_getaffinity(0))
    except (OSError, AttributeError):
        cores = os.cpu_count() or 1
    name = facts.get("model name") or platform.processor() or platform.machine()
    numbers = "".join(f", {n} {facts[k]}" for n, k in (("family", "cpu family"), ("model", "model")) if k in facts)
    return f"{name}{numbers}, {min(cores, thread_count())} cores"


def records_in(path: Path) -> list[dict[str, Any]]:
    """The records of all processors in a file; empty if it does not exist.

    Raises:
        ValueError: The file is damaged.
    """
    try:
        return list(json.loads(path.read_text())["records"]) if path.exists() else []
    except (json.JSONDecodeError, KeyError, TypeError) as error:
        raise ValueError(f"{path}: expected a JSON document with records, got {error!r}. Restore the file.") from error


def saved_records(path: Path, bench: Path) -> list[dict[str, Any]]:
    """The records of all processors, and the last complete benchmark as one more, without a model number."""
    records = records_in(path)
    if bench.exists():
        run = json.loads(bench.read_text())
        rows = [
            {"operation": result["operation"], "size": result["size"], "baseline": label, "ratio": theirs / ours}
            for result in run["results"]
            if (ours := result["contestants"].get(POINTLOOM, {}).get("min_s"))
            for label, theirs in ((label, times["min_s"]) for label, times in result["contestants"].items())
            if label != POINTLOOM
        ]
        about = {"processor": run["machine"]["cpu"], "commit": run["commit"], "date": run["date"], "is_bench": True}
        records.append({**about, "rows": rows})
    return records


def nearest_first(records: list[dict[str, Any]], name: str) -> list[dict[str, Any]]:
    """Sort records: this processor, the same model name, the same vendor, others; the newest first among equals.

    The last complete benchmark is the last one, since it measures by another method.
    """

    def distance(record: dict[str, Any]) -> tuple[bool, int]:
        theirs = record["processor"]
        parts = (theirs == name, theirs.split(",")[0] == name.split(",")[0], theirs.split()[0] == name.split()[0])
        return record.get("is_bench", False), parts.index(True) if any(parts) else len(parts)

    return sorted(sorted(records, key=lambda record: record["date"], reverse=True), key=distance)


def expected_ratios(records: list[dict[str, Any]], name: str, rows: Sequence[Row]) -> dict[Row, Expected]:
    """The recorded ratio of each row from the nearest record that has it. Rows without one are left out."""
    expected: dict[Row, Expected] = {}
    for record in nearest_first(records, name):
        is_same = record["processor"] == name and not record.get("is_bench", False)
        limit = LIMIT if is_same else OTHER_PROCESSOR_LIMIT
        kind = "benchmark" if record.get("is_bench") else "record"
        commit = record["commit"][:8]
        source = f"{kind} of commit {commit}, {record['date'][:10]}, {record['processor']}"
        by_key = {(entry["operation"], entry["size"], entry["baseline"]): entry for entry in record["rows"]}
        for row in rows:
            if row not in expected and (entry := by_key.get(tuple(row))):
                seconds = (entry["pointloom_s"], entry["baseline_s"]) if is_same and "baseline_s" in entry else None
                expected[row] = Expected(entry["ratio"], entry.get("cpu_ratio"), limit, source, commit, seconds)
    return expected


def notes(records: list[dict[str, Any]], name: str, expected: Mapping[Row, Expected]) -> list[str]:
    """One line for each reason why the comparison is less exact than usual."""
    lines = []
    if not any(record["processor"] == name and not record.get("is_bench") for record in records):
        sources = " and ".join(dict.fromkeys(entry.source for entry in expected.values()))
        lines.append(
            f"No record for this processor ({name}): compared with the {sources}. "
            f'Rows fail below {OTHER_PROCESSOR_LIMIT} of it, not {LIMIT}. Record with `make speed ARGS="--record"`.'
        )
        return lines
    recorded = nearest_first(records, name)[0].get("versions", {})
    installed = versions()
    changed = [
        f"{package} {recorded[package]} (now {installed.get(package, 'missing')})"
        for package in recorded
        if package != POINTLOOM and installed.get(package) != recorded[package]
    ]
    if changed:
        lines.append(f"The record was measured with other versions: {', '.join(changed)}.")
    return lines


# ------------------------------------------------------------------------------------------------ check


class Outcome(NamedTuple):
    """One try of a row.

    Attributes:
        factor: The ratio divided by the recorded one; None without a record.
        passed: True if it is not below the limit.
        remark: What passed instead, if the ratio of wall times is below the limit.
    """

    ratio: float
    factor: float | None
    passed: bool
    remark: str = ""


def outcome_of(rounds: Rounds, expected: Expected | None, machine: float | None = None) -> Outcome:
    """Compare rounds with the record.

    On a busy machine the wall times of contestants with different numbers of threads change differently. The CPU times
    count there, too. Some baselines differ by a factor of two between processes of one machine (large allocations). A
    row whose baseline alone is faster passes by pointloom's time, scaled by the speed of the machine.

    Args:
        rounds: The measured rounds.
        expected: The record of the row.
        machine: The time of the baselines of all rows divided by the recorded one; None if unknown.
    """
    ratio = rounds.ratio
    if expected is None:
        return Outcome(ratio, None, True)
    factor = ratio / expected.ratio
    if factor >= expected.limit:
        return Outcome(ratio, factor, True)
    if rounds.is_busy and expected.cpu_ratio is not None and rounds.cpu_ratio / expected.cpu_ratio >= expected.limit:
        return Outcome(ratio, factor, True, "passed by CPU times")
    if machine is not None and expected.seconds is not None:
        own = rounds.best(0) / (machine * expected.seconds[0])
        if own <= 1 / expected.limit:
            return Outcome(ratio, factor, True, f"passed by pointloom's time, {own:.2f} of the recorded one")
    return Outcome(ratio, factor, False)


def is_clear(rounds: Rounds, expected: Expected | None) -> bool:
    """True if more rounds would not change the outcome: at the record, or well above the limit in several pairs."""
    if expected is None:
        return len(rounds.pairs) >= CLEAR_PAIRS
    factor = rounds.ratio / expected.ratio
    return factor >= 1 or (len(rounds.pairs) >= CLEAR_PAIRS and factor >= CLEAR_MARGIN * expected.limit)


class Check:
    """A run over some rows: first tries in order, then second tries of the rows that are below their limit."""

    def __init__(self, rows: Sequence[Row], expected: Mapping[Row, Expected], clock: Clock, begin: float):
        self.rows, self.expected, self.clock, self.begin = rows, expected, clock, begin
        self.tries: dict[Row, list[Outcome]] = {}
        self.disagreeing: dict[Row, str] = {}
        self.loads: list[float] = []
        self.baseline_factors: list[float] = []
        self.machine: float | None = None

    def run(self) -> None:
        """Measure all rows."""
        print(HEADING, flush=True)
        below: list[Contest] = []
        for row, contest in contests(self.rows, self.clock):
            if isinstance(contest, ResultsDisagreeError):
                self.disagreeing[row] = str(contest)
                print(f"{row.operation:28}{row.size:20}results disagree: {contest}", flush=True)
            elif not self._try(contest, ROW_SECONDS, ""):
                below.append(contest)
        self.machine = statistics.median(factors) if len(factors := self.baseline_factors) >= MIN_MACHINE_ROWS else None
        for k, contest in enumerate(below):
            left = (self.begin + TOTAL_SECONDS - self.clock.wall()) / (len(below) - k)
            self._try(contest, min(max(left, RETRY_SECONDS[0]), RETRY_SECONDS[1]), "second try")

    def _try(self, contest: Contest, seconds: float, remark: str) -> bool:
        """Measure a row, print its line, and return True if it passed."""
        row = contest.row
        expected = self.expected.get(row)
        rounds = contest.run(seconds, lambda rounds: is_clear(rounds, expected))
        outcome = outcome_of(rounds, expected, self.machine)
        if expected and expected.seconds:
            self.baseline_factors.append(rounds.best(1) / expected.seconds[1])
        self.tries.setdefault(row, []).append(outcome)
        self.loads.append(rounds.other_load)
        print(line_of(row, rounds, expected, outcome, remark), flush=True)
        return outcome.passed

    @property
    def failed(self) -> list[Row]:
        """Rows that were below their limit in both tries, and rows whose results disagree."""
        return [row for row in self.rows if row in self.disagreeing or not self.tries[row][-1].passed]


HEADING = (
    f"{'operation':28}{'size':20}{'pointloom':>13}{'baseline':>13}{'ratio':>8}{'recorded':>10}{'factor':>8}  remarks"
)


def line_of(row: Row, rounds: Rounds, expected: Expected | None, outcome: Outcome, remark: str = "") -> str:
    """The line of one try."""
    recorded = f"{expected.ratio:.2f}" if expected else "none"
    factor = "-" if outcome.factor is None else f"{outcome.factor:.2f}"
    remarks = [remark] if remark else []
    if not outcome.passed:
        remarks.append(f"BELOW {expected.limit if expected else LIMIT}")
    if outcome.remark:
        remarks.append(outcome.remark)
    if rounds.is_busy:
        remarks.append(f"busy machine ({rounds.other_load:.1f} cores)")
    times = "".join(f"{1000 * rounds.best(side):10.2f} ms" for side in (0, 1))
    text = f"{row.operation:28}{row.size:20}{times}{outcome.ratio:8.2f}{recorded:>10}{factor:>8}  {', '.join(remarks)}"
    return text.rstrip()


def summary(check: Check, seconds: float) -> list[str]:
    """The closing lines: counts in words, then the failed rows and the next steps."""
    failed, none = check.failed, [row for row in check.rows if row not in check.expected]
    passed = len(check.rows) - len(set(failed) | set(none))
    count = len(check.rows)
    text = f"{count} {'row' if count == 1 else 'rows'}: {passed} passed, {len(failed)} failed"
    if none:
        text += f", {len(none)} without a record ({', '.join(map(str, none))})"
    lines = [f"{text}, in {seconds:.0f} s."]
    if (load := statistics.mean(check.loads or [0.0])) > BUSY_CORES:
        lines.append(f"Other processes used {load:.1f} cores on average: the times are inaccurate.")
    for row in failed:
        if row in check.disagreeing:
            lines.append(f"FAILED {row}: the results differ from {row.baseline}'s: {check.disagreeing[row]}")
            continue
        expected, tries = check.expected[row], check.tries[row]
        ratios = " and ".join(f"{outcome.ratio:.2f}" for outcome in tries)
        lines.append(
            f"FAILED {row}: expected a ratio of at least {expected.limit * expected.ratio:.2f} to {row.baseline} "
            f"({expected.limit} of {expected.ratio:.2f}, {expected.source}), measured {ratios}."
        )
    if failed:
        names = " ".join(f"--only {name}" for name in dict.fromkeys(row.operation for row in failed))
        commit = next((check.expected[row].commit for row in failed if row in check.expected), "COMMIT")
        lines += [
            f'To look closer: make bench ARGS="{names}", or with --profile for the times of each kernel.',
            f'To find the commit: git bisect start HEAD {commit} && git bisect run make speed ARGS="{names}"',
            'If the change is intended: make speed ARGS="--record", and give the reason in the commit.',
        ]
    return lines


# ------------------------------------------------------------------------------------------------ record


def measure(rows: Sequence[Row], clock: Clock) -> list[dict[str, Any]]:
    """Measure rows without a comparison, with all rounds; for a record."""
    results = []
    for row, contest in contests(rows, clock):
        if isinstance(contest, ResultsDisagreeError):
            raise contest
        rounds = contest.run(ROW_SECONDS)
        results.append({
            **row._asdict(), "ratio": rounds.ratio, "cpu_ratio": rounds.cpu_ratio, "pointloom_s": rounds.best(0),
            "baseline_s": rounds.best(1), "other_load": rounds.other_load,
        })  # fmt: skip
        print(line_of(row, rounds, None, Outcome(rounds.ratio, None, True)), flush=True)
    return results


def medians(runs: Sequence[Sequence[Mapping[str, Any]]]) -> list[dict[str, Any]]:
    """The median of each number of each row, and the lowest and highest ratio."""
    rows = []
    for entries in zip(*runs, strict=True):
        row = {
            name: statistics.median(entry[name] for entry in entries) if isinstance(value, float) else value
            for name, value in entries[0].items()
        }
        ratios = [entry["ratio"] for entry in entries]
        rows.append(row | {"lowest": min(ratios), "highest": max(ratios)})
    return rows


def record(path: Path = RECORDS, count: int = RECORD_RUNS) -> int:
    """Measure all rows several times, each in a new process, and store the medians for this processor.

    A previous record of the processor is replaced; rows that became slower are printed. Returns the exit code.
    """
    runs = []
    for number in range(1, count + 1):
        print(f"[{number}/{count}]", flush=True)
        with tempfile.TemporaryDirectory(prefix="speed-") as folder:
            output = Path(folder) / "run.json"
            command = [sys.executable, str(Path(__file__).resolve()), "--measure", str(output)]
            code = subprocess.run(command, check=False).returncode
            if code == 130:
                raise KeyboardInterrupt
            if code != 0:
                print(f"error: the measurement ended with code {code}. Nothing is recorded.", file=sys.stderr)
                return 1
            runs.append(json.loads(output.read_text()))
    rows, name = medians(runs), processor()
    previous = records_in(path)
    for line in changes(rows, next((r for r in previous if r["processor"] == name), None)):
        print(line)
    commit, used = git("rev-parse", "--short=12", "HEAD"), {POINTLOOM, *PACKAGES.values()}
    about = {
        "processor": name,
        "commit": commit or "unknown",
        "dirty": bool(git("status", "--porcelain", "--", ":/", f":!{RECORDS.parent}")) if commit else None,
        "date": datetime.datetime.now(datetime.UTC).isoformat(timespec="seconds"),
        "runs": count,
        "versions": {package: version for package, version in versions().items() if package in used},
    }
    records = [r for r in previous if r["processor"] != name] + [about | {"rows": rows}]
    from pointloom.core.atomic import atomic_write

    with atomic_write(path) as file:
        file.write((json.dumps({"schema": 1, "records": records}, indent=1) + "\n").encode())
    print(f"Recorded {len(rows)} rows for {name} in {os.path.relpath(path)}.")
    if (load := statistics.mean(row["other_load"] for row in rows)) > BUSY_CORES:
        print(f"Other processes used {load:.1f} cores: the record is inaccurate. Record again on a quiet machine.")
    return 0


def changes(rows: Sequence[Mapping[str, Any]], previous: Mapping[str, Any] | None) -> Iterator[str]:
    """Yield a line for each row whose ratio differs by more than 10 % from the previous record."""
    before = {(r["operation"], r["size"], r["baseline"]): r["ratio"] for r in previous["rows"]} if previous else {}
    for row in rows:
        old = before.get((row["operation"], row["size"], row["baseline"]))
        if old and abs(row["ratio"] / old - 1) > 0.1:
            word = "SLOWER" if row["ratio"] < old else "faster"
            yield f"{word} than the previous record: {row['operation']} {row['size']}, {old:.2f} to {row['ratio']:.2f}"


# ------------------------------------------------------------------------------------------------ command


def main(arguments: list[str] | None = None, clock: Clock | None = None) -> int:
    """Run the check. Returns 0, or 1 if a row failed, 2 for usage errors, 130 if interrupted."""
    options, clock = _options(arguments), clock or Clock()
    try:
        if options.record:
            return record(options.records)
        limit_threads("cpu")
        rows = choose(options.only)
        if options.measure:
            options.measure.write_text(json.dumps(measure(rows, clock)))
            return 0
        return compare(rows, options.records, clock)
    except ValueError as error:
        print(f"error: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        if not options.measure:
            print("\nInterrupted: nothing is saved.", file=sys.stderr)
        return 130


def _options(arguments: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description="Check the speed of 24 operations beside their best baselines.")
    parser.add_argument("--only", action="append", metavar="NAME", help="rows whose operation starts with NAME")
    parser.add_argument("--record", action="store_true", help="measure and store the ratios of this processor")
    parser.add_argument("--records", type=Path, default=RECORDS, metavar="FILE", help="the file of records")
    parser.add_argument("--measure", type=Path, metavar="FILE", help="write measured ratios, compare with nothing")
    options = parser.parse_args(arguments)
    if options.record and (options.only or options.measure):
        parser.error("--record: expected no --only and no --measure, since a record contains all rows of one run")
    return options


def choose(only: list[str] | None) -> list[Row]:
    """The rows whose operation starts with one of these prefixes.

    Raises:
        ValueError: A prefix matches no row, or a baseline is not installed.
    """
    for prefix in only or ():
        if not any(row.operation.startswith(prefix) for row in ROWS):
            names = ", ".join(dict.fromkeys(row.operation for row in ROWS))
            raise ValueError(f"--only {prefix}: expected a prefix of one of {names}")
    rows = [row for row in ROWS if not only or row.operation.startswith(tuple(only))]
    needed = {PACKAGES[row.baseline] for row in rows}
    missing = [package for package in sorted(needed) if importlib.util.find_spec(package.replace("-", "_")) is None]
    if missing:
        raise ValueError(
            f"expected all baselines to be installed, missing: {', '.join(missing)}. `make speed` installs "
            "them. If it did not, remove .venv/.stamp-bench and run it again."
        )
    return rows


def compare(rows: Sequence[Row], path: Path, clock: Clock) -> int:
    """Compare rows with the record; returns the exit code."""
    name, records = processor(), saved_records(path, BENCH_RESULTS)
    expected = expected_ratios(records, name, rows)
    if not expected:
        raise ValueError(f"{path} and {BENCH_RESULTS} have none of these rows. Run `make speed ARGS=--record` first.")
    for line in notes(records, name, expected):
        print(f"note: {line}", flush=True)
    check = Check(rows, expected, clock, clock.wall() - (time.monotonic() - STARTED))
    check.run()
    print("\n".join(summary(check, time.monotonic() - STARTED)), flush=True)
    return 1 if check.failed else 0


def separate_output() -> None:
    """Keep the standard output for the lines of this check: RKO-LIO logs to the same file descriptor."""
    lines = os.fdopen(os.dup(1), "w", buffering=1, encoding=sys.stdout.encoding)
    null = os.open(os.devnull, os.O_WRONLY)
    os.dup2(null, 1)
    os.close(null)
    sys.stdout = lines


if __name__ == "__main__":
    if not {"--record", "--help", "-h"} & set(sys.argv):  # processes that load no library
        separate_output()
    sys.exit(main())
