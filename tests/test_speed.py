"""The speed check on operations with given times: pairs of rounds, second tries, records, messages. No real time."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest

from .programs import BENCHMARKS as FOLDER
from .programs import benchmarks_on_path

PROCESSOR = "Maker Model, family 1, model 2, 2 cores"


@pytest.fixture(scope="module", autouse=True)
def speed() -> Iterator[ModuleType]:
    with benchmarks_on_path():
        import speed

        # Collections take long among the objects of so many tests.
        speed.gc = SimpleNamespace(**dict.fromkeys(("collect", "freeze", "unfreeze", "enable", "disable"), int))
        yield speed


# ------------------------------------------------------------------------------------------------ fakes


@dataclass
class Times:
    """A clock that only calls advance, and the log of these calls.

    Attributes:
        other_load: Cores that other processes use.
    """

    now: float = 0.0
    used: float = 0.0
    other_load: float = 0.0
    log: list[str] = field(default_factory=list)

    def spend(self, seconds: float, cpu: float | None = None) -> None:
        """Advance by wall seconds, and by CPU seconds of this process (default: the same)."""
        self.now += seconds
        self.used += seconds if cpu is None else cpu

    def clock(self) -> Any:
        import speed

        return speed.Clock(
            wall=lambda: self.now,
            cpu=lambda: self.used,
            cores=lambda: self.used + self.other_load * self.now,
            sleep=lambda seconds: None,
        )


Spending = Callable[[int], tuple[float, float]]  # number of the call -> wall and CPU seconds


def constant(seconds: float, cpu: float | None = None) -> Spending:
    """Every round takes longer than its CPU time, if that is given, as two threads do beside a busy process."""
    return lambda number: (seconds, seconds if cpu is None else cpu)


def fake_operation(times: Times, ours: Spending, theirs: Spending, *, name: str = "fake", agree: bool = True) -> Any:
    """An operation whose calls only advance the clock; with `agree=False` the results differ."""
    import contest

    def prepare(label: str, spending: Spending) -> Callable[[Any, str], Any]:
        calls = iter(range(10**6))

        def call() -> str:
            times.log.append(label)
            times.spend(*spending(next(calls)))
            return "result" if agree else label

        return lambda scene, device: call

    def check(actual: str, reference: str, peer: str) -> None:
        assert actual == reference, f"{actual} is not {reference}"

    contestants = (
        contest.Contestant(contest.POINTLOOM, prepare("pointloom", ours), lambda result: result),
        contest.Contestant("other", prepare("other", theirs), lambda result: result),
    )
    return contest.Operation(name, {"small": lambda: None}, {}, contestants, check)


def row_of(name: str = "fake") -> Any:
    import speed

    return speed.Row(name, "small", "other")


def record_of(ratio: float, *, processor: str = PROCESSOR, date: str = "2026-02-01", names: Any = ("fake",)) -> Any:
    rows = [{**row_of(name)._asdict(), "ratio": ratio, "cpu_ratio": ratio} for name in names]
    return {"processor": processor, "commit": "0123456789ab", "date": date, "versions": {}, "rows": rows}


@pytest.fixture
def run(monkeypatch, tmp_path, capsys, speed) -> Callable[..., SimpleNamespace]:
    """Run the command on fake operations: `run(times, operations, records, *arguments)`."""

    def run_command(times: Times, operations: list[Any], records: list[Any], *arguments: str) -> SimpleNamespace:
        path = tmp_path / "speed.json"
        path.write_text(json.dumps({"records": records}))
        monkeypatch.setattr(speed, "ROWS", tuple(row_of(operation.name) for operation in operations))
        monkeypatch.setattr(speed, "operations", lambda: {o.name: ("bench_fake", o) for o in operations})
        monkeypatch.setattr(speed, "PACKAGES", {"other": "json"})
        monkeypatch.setattr(speed, "BENCH_RESULTS", tmp_path / "none.json")
        monkeypatch.setattr(speed, "limit_threads", lambda device: None)
        monkeypatch.setattr(speed, "processor", lambda: PROCESSOR)
        code = speed.main([*arguments, "--records", str(path)], times.clock())
        text = capsys.readouterr()
        return SimpleNamespace(code=code, out=text.out, err=text.err, path=path, log=times.log)

    return run_command


@pytest.fixture
def run_one(run) -> Callable[..., SimpleNamespace]:
    """The same for one operation of two numbers of seconds, or functions of the call: `run_one(ours, theirs, ...)`."""

    def run_operation(ours: Any, theirs: Any, records: Any, *arguments: str, load: float = 0.0) -> SimpleNamespace:
        times = Times(other_load=load)
        spendings = (given if callable(given) else constant(given) for given in (ours, theirs))
        return run(times, [fake_operation(times, *spendings)], records, *arguments)

    return run_operation


# ------------------------------------------------------------------------------------------------ tries


def test_a_row_at_its_recorded_ratio_passes_after_three_alternating_pairs(run_one):
    result = run_one(0.01, 0.02, [record_of(2.0)])
    assert result.code == 0 and "1 row: 1 passed, 0 failed" in result.out
    first, pair = ["pointloom", "other"], ["pointloom", "pointloom", "other", "other"]  # two rounds of a short call
    assert result.log == 2 * first + 3 * pair


@pytest.mark.parametrize(("factor", "pairs"), [(1.01, 3), (0.95, 5), (0.85, 25), (0.7, 2 * 25)])
def test_a_row_closer_to_the_limit_has_more_pairs(run_one, factor, pairs, speed):
    assert (speed.MIN_PAIRS, speed.CLEAR_PAIRS, speed.MAX_PAIRS) == (3, 5, 25)
    result = run_one(0.01, 0.01 * factor, [record_of(1.0)])
    assert result.log.count("pointloom") == result.log.count("other") == 2 + 2 * pairs
    assert result.code == (factor < speed.LIMIT)


def test_long_calls_have_one_round_in_a_pair(run_one):
    assert run_one(0.2, 0.4, [record_of(2.0)]).log == (2 + 3) * ["pointloom", "other"]


def test_a_first_call_that_is_slow_after_a_pause_does_not_count(speed):
    times, is_cold = Times(), []
    clock = replace(times.clock(), sleep=lambda seconds: is_cold.append(True))

    def ours(number: int) -> tuple[float, float]:
        seconds = 0.02 if is_cold else 0.01
        is_cold.clear()
        return seconds, seconds

    contest = speed.Contest(row_of(), fake_operation(times, ours, constant(0.03)), clock)
    assert contest.run(1.0).ratio == pytest.approx(3.0)


def test_a_row_below_the_limit_fails_after_a_second_and_longer_try(run_one):
    result = run_one(0.02, 0.02, [record_of(1.3)])
    assert result.code == 1 and result.out.count("BELOW 0.8") == 2 and result.out.count("second try") == 1
    assert "FAILED fake small: expected a ratio of at least 1.04 to other (0.8 of 1.30" in result.out
    assert "measured 1.00 and 1.00" in result.out and 'make bench ARGS="--only fake"' in result.out
    assert "git bisect start HEAD 01234567 " in result.out


def test_second_tries_are_longer_and_share_the_remaining_time_within_bounds(monkeypatch, speed):
    times, names = Times(), ("a", "b")
    known = {n: ("bench_fake", fake_operation(times, constant(0.2), constant(0.2), name=n)) for n in names}
    monkeypatch.setattr(speed, "operations", lambda: known)
    rows = [row_of(name) for name in names]
    expected = dict.fromkeys(rows, speed.Expected(2.0, None, 0.8))
    counts = []
    monkeypatch.setattr(speed, "line_of", lambda row, rounds, *rest: counts.append(len(rounds.pairs)))
    short, long = speed.RETRY_SECONDS
    for begin, seconds in ((0.0, long), (-2 * speed.TOTAL_SECONDS, short)):
        counts.clear()
        check = speed.Check(rows, expected, times.clock(), times.now + begin)
        check.run()
        assert check.failed == rows and min(counts[2:]) > max(counts[:2]) >= min(counts[:2]) >= speed.MIN_PAIRS
        assert all(seconds - 0.8 < 0.4 * count <= seconds for count in counts[2:])


def test_a_row_that_is_slow_in_its_first_try_only_passes(run):
    times = Times()

    def ours(number: int) -> tuple[float, float]:
        return (0.4, 0.4) if times.now < 3 else (0.2, 0.2)

    result = run(times, [fake_operation(times, ours, constant(0.2))], [record_of(1.0)])
    assert result.code == 0 and result.out.count("BELOW") == 1 and "1 passed, 0 failed" in result.out


def test_rounds_that_another_process_delays_do_not_change_the_ratio(run_one):
    result = run_one(lambda number: (0.05 if number % 3 else 0.01, 0.01), 0.02, [record_of(2.0)])
    assert result.code == 0 and "BELOW" not in result.out


def test_a_slower_row_does_not_hide_behind_the_others(run):
    times = Times()
    operations = [
        fake_operation(times, constant(seconds), constant(0.02), name=name)
        for name, seconds in (("a", 0.01), ("b", 0.02), ("c", 0.005))
    ]
    result = run(times, operations, [record_of(2.0, names=("a", "b", "c"))])
    assert result.code == 1 and "3 rows: 2 passed, 1 failed" in result.out
    assert "FAILED b small" in result.out and "FAILED a" not in result.out and "--only b" in result.out


def test_a_faster_contestant_has_more_rounds_in_a_pair_than_a_slow_one(run_one, speed):
    log = run_one(0.001, 0.5, [record_of(500.0)]).log
    assert log.count("pointloom") == 2 + 3 * speed.MAX_REPEATS and log.count("other") == 2 + 3


# ------------------------------------------------------------------------------------------------ busy machines


@pytest.mark.parametrize(("other_load", "code"), [(1.0, 0), (0.0, 1)])
def test_cpu_times_count_on_a_busy_machine_only(run_one, other_load, code):
    result = run_one(constant(0.02, 0.01), constant(0.02, 0.02), [record_of(2.0)], load=other_load)
    assert result.code == code and ("passed by CPU times" in result.out) == (code == 0)
    assert ("Other processes used 1.0 cores on average" in result.out) == (code == 0)


@pytest.mark.parametrize(
    ("ours", "others", "code"),
    [(0.01, 0.02, 0), (0.013, 0.02, 1), (0.013, 0.03, 0), (0.02, 0.03, 1)],
    ids=["faster baseline", "slower row", "slower machine", "slower row on a slower machine"],
)
def test_a_row_passes_by_its_own_time_if_only_its_baseline_is_faster(run, ours, others, code, speed):
    times, names = Times(), [f"row {k}" for k in range(speed.MIN_MACHINE_ROWS)]
    operations = [fake_operation(times, constant(others / 2), constant(others), name=name) for name in names[1:]]
    operations.append(fake_operation(times, constant(ours), constant(0.014), name=names[0]))
    record: Any = record_of(2.0, names=names)
    for row in record["rows"]:
        row |= {"pointloom_s": 0.01, "baseline_s": 0.02}
    result = run(times, operations, [record])
    assert result.code == code and ("passed by pointloom's time" in result.out) == (code == 0)
    assert run(times, operations[-1:], [record]).code == 1  # one row does not tell how fast the machine is


def test_more_work_fails_on_a_busy_machine_too(run_one):
    assert run_one(constant(0.04, 0.02), constant(0.02, 0.02), [record_of(2.0)], load=1.0).code == 1


# ------------------------------------------------------------------------------------------------ records


@pytest.mark.parametrize(("ours", "code"), [(0.01, 0), (0.0125, 0), (0.018, 0), (0.03, 1)])
def test_a_record_of_another_processor_has_a_lower_limit_and_a_note(run_one, ours, code):
    result = run_one(ours, 0.014, [record_of(1.8, processor="Other Chip, 2 cores")])
    assert result.code == code and "note: No record for this processor" in result.out and "Other Chip" in result.out
    assert ("BELOW 0.4" in result.out) == bool(code)


def test_the_record_of_this_processor_goes_before_newer_records_of_others(run_one):
    records = [record_of(2.0), record_of(9.0, processor="Maker Model, family 7, 2 cores", date="2026-03-01")]
    result = run_one(0.01, 0.02, records)
    assert result.code == 0 and "note" not in result.out


def test_the_nearest_record_has_the_model_name_then_the_vendor_then_the_latest_date(speed):
    same = record_of(1.0, processor="Maker Model, family 9, 2 cores")
    vendor = record_of(1.0, processor="Maker Other, 2 cores")
    old, new = record_of(1.0, processor="Chip A"), record_of(1.0, processor="Chip B", date="2026-05-01")
    bench = {**record_of(1.0, processor="Maker Model", date="2026-06-01"), "is_bench": True}
    assert speed.nearest_first([bench, old, new, vendor, same], PROCESSOR) == [same, vendor, new, old, bench]


def test_a_row_without_a_record_is_counted_separately(run):
    times = Times()
    operations = [fake_operation(times, constant(0.01), constant(0.02), name=name) for name in ("a", "b")]
    result = run(times, operations, [record_of(2.0, names=("a",))])
    assert result.code == 0 and "2 rows: 1 passed, 0 failed, 1 without a record (b small)" in result.out


def test_a_check_without_any_record_is_a_usage_error(run_one):
    result = run_one(0.01, 0.02, [])
    assert result.code == 2 and "make speed ARGS=--record" in result.err and not result.log


def test_the_last_benchmark_is_a_record_of_each_baseline(tmp_path, speed):
    bench = tmp_path / "bench.json"
    contestants = {"pointloom": {"min_s": 0.01}, "other": {"min_s": 0.02}, "third": {"min_s": 0.03}}
    result = {"operation": "fake", "size": "small", "contestants": contestants}
    about = {"machine": {"cpu": "Maker Model"}, "commit": "0123456789ab", "date": "2026-01-01"}
    bench.write_text(json.dumps({**about, "results": [result, {**result, "contestants": {"other": {"min_s": 1.0}}}]}))
    records = speed.saved_records(tmp_path / "none.json", bench)
    rows = [row_of(), row_of()._replace(baseline="third"), row_of("unknown")]
    expected = speed.expected_ratios(records, PROCESSOR, rows)
    assert [expected[row].ratio for row in rows[:2]] == [2.0, 3.0] and rows[2] not in expected
    assert {entry.limit for entry in expected.values()} == {speed.OTHER_PROCESSOR_LIMIT}


def test_other_versions_of_a_baseline_are_noted(run_one):
    result = run_one(0.01, 0.02, [{**record_of(2.0), "versions": {"numpy": "0.1"}}])
    assert result.code == 0 and "note: The record was measured with other versions: numpy 0.1 (now " in result.out


@pytest.fixture
def measured(monkeypatch, speed) -> list[float]:
    """The ratios of the runs of `--record`, which start no process."""
    ratios: list[float] = []
    left = iter(ratios)

    def measure(command: list[str], **options: Any) -> SimpleNamespace:
        ratio = next(left, None)
        if ratio is None:
            return SimpleNamespace(returncode=130)
        row = {**row_of()._asdict(), "ratio": ratio, "cpu_ratio": ratio, "other_load": 0.0}
        Path(command[command.index("--measure") + 1]).write_text(json.dumps([row]))
        return SimpleNamespace(returncode=0)

    monkeypatch.setattr(speed, "git", lambda *words: "0123456789ab")
    monkeypatch.setattr(speed, "subprocess", SimpleNamespace(run=measure))
    return ratios


def test_a_record_has_the_median_of_five_runs_and_replaces_that_of_this_processor_only(run_one, measured):
    measured += [1.0, 5.0, 2.0, 1.1, 3.0]
    other = record_of(7.0, processor="Other Chip, 2 cores")
    result = run_one(1, 1, [record_of(4.0), other], "--record")
    saved = json.loads(result.path.read_text())["records"]
    assert result.code == 0 and saved[0] == other and len(saved) == 2
    new = saved[1]
    assert new["processor"] == PROCESSOR and new["commit"] == "0123456789ab" and new["runs"] == 5
    assert (new["rows"][0]["ratio"], new["rows"][0]["lowest"], new["rows"][0]["highest"]) == (2.0, 1.0, 5.0)
    assert "SLOWER than the previous record: fake small, 4.00 to 2.00" in result.out


def test_an_interrupted_recording_saves_nothing(run_one, measured):
    measured += [1.0, 2.0]  # the third run is interrupted
    result = run_one(1, 1, [record_of(4.0)], "--record")
    assert result.code == 130 and json.loads(result.path.read_text())["records"] == [record_of(4.0)]


def test_measurements_of_a_record_have_both_ratios(run_one, tmp_path):
    path = tmp_path / "run.json"
    result = run_one(constant(0.01, 0.02), constant(0.03, 0.03), [], "--measure", str(path))
    (row,) = json.loads(path.read_text())
    assert result.code == 0 and row["ratio"] == pytest.approx(3) and row["cpu_ratio"] == pytest.approx(1.5)
    assert (row["operation"], row["size"], row["baseline"]) == row_of()


# ------------------------------------------------------------------------------------------------ errors


def test_an_interrupt_ends_without_a_traceback(run_one):
    def interrupted(number: int) -> tuple[float, float]:
        if number == 3:
            raise KeyboardInterrupt
        return 0.01, 0.01

    result = run_one(interrupted, 0.01, [record_of(1.0)])
    assert result.code == 130 and "Interrupted" in result.err


def test_results_that_disagree_fail_and_the_other_rows_are_measured(run):
    times = Times()
    operations = [
        fake_operation(times, constant(0.01), constant(0.02), name="a", agree=False),
        fake_operation(times, constant(0.01), constant(0.02), name="b"),
    ]
    result = run(times, operations, [record_of(2.0, names=("a", "b"))])
    assert result.code == 1 and "2 rows: 1 passed, 1 failed" in result.out
    assert "FAILED a small: the results differ from other's: pointloom is not other" in result.out


def test_a_missing_baseline_is_reported_before_any_measurement(monkeypatch, capsys, speed):
    row = row_of()
    monkeypatch.setattr(speed, "ROWS", (row,))
    monkeypatch.setattr(speed, "PACKAGES", {"other": "no-package-of-this-name"})
    monkeypatch.setattr(speed, "limit_threads", lambda device: None)
    assert speed.main([]) == 2
    message = capsys.readouterr().err
    assert "missing: no-package-of-this-name." in message and "`make speed` installs" in message


def test_a_damaged_file_of_records_is_a_usage_error_that_names_the_file(tmp_path, speed):
    path = tmp_path / "speed.json"
    for text in ("", "[]", "{}"):
        path.write_text(text)
        with pytest.raises(ValueError, match=r"speed\.json: expected a JSON document with records"):
            speed.records_in(path)


def test_an_unknown_name_is_a_usage_error_with_the_known_names(run_one):
    result = run_one(1, 1, [record_of(1.0)], "--only", "fraud")
    assert result.code == 2 and "--only fraud: expected a prefix of one of fake" in result.err


def test_a_record_of_single_rows_is_a_usage_error(speed):
    with pytest.raises(SystemExit) as ended:
        speed.main(["--record", "--only", "odometry"])
    assert ended.value.code == 2


# ------------------------------------------------------------------------------------------------ rows


def test_each_of_the_24_rows_has_data_both_contestants_and_a_package(speed):
    import contest

    known = contest.operations()
    assert len(set(speed.ROWS)) == len({row.key for row in speed.ROWS}) == 24
    assert {row.baseline for row in speed.ROWS} == set(speed.PACKAGES)
    for row in speed.ROWS:
        operation = known[row.operation][1]
        assert callable(speed.scene_of(row, operation))
        assert operation.contestant(row.baseline, "cpu")[0].name == row.baseline
    assert {row.size.split(",")[0] for row in speed.ROWS if row.operation == "odometry"} == {"64 beams", "16 beams"}


def test_the_processor_and_the_used_time_of_this_machine_are_readable(speed):
    assert speed.processor().endswith(" cores")
    before = speed.used_core_seconds()
    assert before != before or 0 <= before <= speed.used_core_seconds()


def test_the_command_lists_its_options(speed, capsys):
    with pytest.raises(SystemExit, match=r"^0$"):
        speed.main(["--help"])
    shown = capsys.readouterr().out
    assert "--record" in shown and "--only NAME" in shown


@pytest.mark.slow
def test_the_program_starts_without_the_fixtures_of_the_tests():
    subprocess.run([sys.executable, FOLDER / "speed.py", "--help"], capture_output=True, check=True)
