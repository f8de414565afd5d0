"""Stored results of `make trust`: what is repeated after an interruption, and after a change of the code."""

import contextlib
import json
import os
import signal
import subprocess
import sys

import pytest

from .programs import ROOT, benchmarks_on_path

with benchmarks_on_path("trust"):
    import results
    import run
    from judged import Case, Judged

ONE = Judged("depth", "a case", 1, 0, 0, 0)


@pytest.fixture(autouse=True)
def folders():
    with benchmarks_on_path("trust"):
        yield


@pytest.fixture
def code(tmp_path, monkeypatch):
    """A repository with one module."""
    path = tmp_path / "src" / "module.py"
    path.parent.mkdir()
    path.write_text("LIMIT = 1\n")
    monkeypatch.setattr(results, "digests_of", lambda paths: _digests(tmp_path, paths))
    return path


def _digests(root, paths):
    from code_digests import digests_of

    return digests_of(paths, root)


def result(case: str, area: str = "depth") -> results.Result:
    return results.Result(area, case, 2.0, (ONE,), ("src/module.py",))


def test_a_result_is_valid_until_its_code_changes(tmp_path, code):
    folder = tmp_path / "results"
    results.Results(folder).add(result("one"))
    assert results.Results(folder).valid["depth", "one"].judged == (ONE,)
    code.write_text("LIMIT = 1  # the same code\n")
    assert results.Results(folder).valid
    code.write_text("LIMIT = 2\n")
    assert not results.Results(folder).valid
    code.unlink()
    assert not results.Results(folder).valid


def test_a_change_during_the_run_makes_results_invalid(tmp_path, code):
    stored = results.Results(tmp_path / "results")
    stored.add(result("before"))
    code.write_text("LIMIT = 2\n")
    stored.add(result("after"))
    assert not results.Results(tmp_path / "results").valid


def test_a_line_that_was_cut_off_is_ignored(tmp_path, code, capsys):
    folder = tmp_path / "results"
    results.Results(folder).add(result("one"))
    with (folder / "depth.jsonl").open("a") as file:
        file.write('{"case": "two", "sec')
    stored = results.Results(folder)
    assert list(stored.valid) == [("depth", "one")] and "cut off" in capsys.readouterr().err
    stored.add(result("three"))
    assert [case for _, case in results.Results(folder).valid] == ["one", "three"]


def test_only_cases_without_a_result_are_run(tmp_path, code):
    stored = results.Results(tmp_path / "results")
    for name in "abcd":
        stored.add(result(name))
    named = {"depth": {name: Case(name, list) for name in "abcde"}, "lidar": {"f": Case("f", list)}}
    jobs = run.jobs_of(named, named, stored)
    assert [(job.area, job.case) for job in jobs] == [("depth", "e"), ("lidar", "f")]
    assert jobs[0].seconds == 2.0 and jobs[1].seconds == run.SECONDS["lidar"]


def test_the_same_fraction_of_each_area_is_drawn_by_a_seed(monkeypatch):
    monkeypatch.setattr(run, "SECONDS", {"one": 400.0, "two": 100.0, "single": 60.0})
    named = {area: {str(k): Case(str(k), list) for k in range(n)} for area, n in (("one", 40), ("two", 200))}
    named["single"] = {"all": Case("all", list)}
    draws = [run.draw(named, f"2026-11-{day:02d}", 280.0) for day in range(1, 31)]
    assert draws[0] == run.draw(named, "2026-11-01", 280.0) != draws[1]
    for drawn in draws:
        single = 60.0 * len(drawn["single"])
        assert 269 < 10 * len(drawn["one"]) + 0.5 * len(drawn["two"]) + single <= 280
        assert abs(len(drawn["one"]) / 40 - len(drawn["two"]) / 200) < 0.2
    assert 5 < sum(len(drawn["single"]) for drawn in draws) < 25
    assert {name for drawn in draws for name in drawn["one"]} == {*named["one"]}
    assert run.draw(named, "a", float("inf")) == named


def test_only_rows_of_complete_areas_are_written(tmp_path, monkeypatch, capsys):
    def written(*words):
        monkeypatch.setattr(sys, "argv", ["run.py", "--output", str(tmp_path / "results"), *words])
        page.write_text(
            "<!-- rates -->\n| a |\n|---|\n<!-- /rates -->\n<!-- cases -->\n| a |\n|---|\n<!-- /cases -->\n"
        )
        assert run.main() == 0
        return [row.split(" | ")[0] for row in page.read_text().splitlines() if row.startswith("| depth")]

    page = tmp_path / "page.md"
    cases = {str(k): Case(str(k), list) for k in range(4)}
    judged = [Judged("depth network", "a case", 1, 1, 0, 0)]
    monkeypatch.setattr(run, "PAGE", page)
    monkeypatch.setattr(run, "areas", lambda: ["depth"])
    monkeypatch.setattr(run, "cases_of", lambda area: cases)
    monkeypatch.setattr(run, "SECONDS", {"depth": 240.0 * len(os.sched_getaffinity(0))})
    monkeypatch.setattr(
        run,
        "run_jobs",
        lambda jobs: ((job, results.Result(job.area, job.case, 1.0, tuple(judged), ())) for job in jobs),
    )
    assert written("--write", "--budget", "2") == []
    shown = capsys.readouterr()
    assert "2 of 4 cases drawn" in shown.out and "| depth network | 0 of 2 (0.0 to 65.8 %) | - |" in shown.out
    assert "rows not written, since cases are missing: depth" in shown.err
    assert written("--all", "--write") == ["| depth network"]
    assert "2 of 4 cases left" in capsys.readouterr().out


def test_a_process_keeps_its_area_and_then_takes_the_most_expensive_one_that_is_free():
    jobs = [run.Job("a", "1", 5.0), run.Job("b", "2", 1.0), run.Job("c", "3", 2.0), run.Job("a", "4", 5.0)]
    assert run.next_job(jobs, "b", {"a"}).case == "2"
    assert run.next_job(jobs, "", {"a"}).case == "3"
    assert run.next_job([jobs[0], jobs[3]], "c", {"a"}).case == "1"


def test_a_process_that_starts_during_an_interruption_is_stopped(monkeypatch):
    stopped = []

    class Interrupted(run.Worker):
        def start(self, job):
            raise KeyboardInterrupt

        def stop(self):
            stopped.append(self)

    monkeypatch.setattr(run, "Worker", Interrupted)
    monkeypatch.setattr(run, "ONE_THREAD", {})
    with pytest.raises(KeyboardInterrupt):
        list(run.run_jobs([run.Job("a", "1", 1.0)]))
    assert len(stopped) == len(os.sched_getaffinity(0))


def test_every_area_lists_its_cases_once():
    for area in run.areas():
        assert run.cases_of(area), area


AREA = """
import os, signal
from judged import Case, Judged

def judged(k):
    if k == 2 and "PIPE" in os.environ:
        signal.pause()
    return [Judged("made", f"case {k}", 1, 0, 0, 0)]

def cases():
    for k in range(8):
        yield Case(f"case {k}", lambda k=k: judged(k))
    yield Case("fails", lambda: 1 / 0)
"""
SCRIPT = """
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored by children of background jobs
sys.path[:0] = [{folders}]
import run

class Reporting(run.Results):
    def add(self, result):
        super().add(result)
        if len(self.valid) == 2 and "PIPE" in os.environ:
            open(os.environ["PIPE"], "w").close()

run.Results = Reporting
run.OWN["made"] = run.SECONDS["made"] = 4.0
run.areas = lambda: ["made"]
if __name__ == "__main__":
    raise SystemExit(run.main())
"""


@pytest.mark.slow
@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGKILL])
def test_an_interrupted_run_continues(tmp_path, how):
    (tmp_path / "made.py").write_text(AREA)
    script, output = tmp_path / "script.py", tmp_path / "output"
    folders = ", ".join(repr(str(path)) for path in (tmp_path, ROOT / "benchmarks" / "trust", ROOT / "benchmarks"))
    script.write_text(SCRIPT.format(folders=folders))
    command, lines = [sys.executable, str(script), "--all", "--output", str(output)], output / "made.jsonl"
    os.mkfifo(pipe := tmp_path / "pipe")
    first = subprocess.Popen(command, env=os.environ | {"PIPE": str(pipe)}, start_new_session=True)
    pipe.read_bytes()  # until two cases are stored
    os.kill(first.pid, how)
    assert first.wait(60) != 0
    with contextlib.suppress(ProcessLookupError):
        os.killpg(first.pid, signal.SIGKILL)  # workers whose parent was killed
    done = [json.loads(line)["case"] for line in lines.read_text().splitlines()]
    assert 2 <= len(done) < 8
    second = subprocess.run(command, capture_output=True, text=True, timeout=300, check=False)
    after = [json.loads(line)["case"] for line in lines.read_text().splitlines()]
    assert after[: len(done)] == done and sorted(after) == [f"case {k}" for k in range(8)]
    assert f"{9 - len(done)} of 9 cases left" in second.stdout
    assert second.returncode == 1 and "made, fails: ZeroDivisionError" in second.stderr
