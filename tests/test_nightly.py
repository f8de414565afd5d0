"""`make nightly` on a small repository: the drawing by date, stored results, interruptions, the budget, the table."""

import datetime
import json
import os
import re
import select
import subprocess
import sys
from pathlib import Path

import pytest

from .programs import ROOT, script

nightly = script("nightly")

LINE = re.compile(
    r"^(?P<step>[\w-]+) +(?P<result>passed|failed|not run) *(?P<seconds>[\d.]+)? *(?P<cpu>[\d.]+)? *(?P<commit>.*)$"
)


def git(tree, *words):
    command = ["git", "-c", "user.name=a", "-c", "user.email=a@b", *words]
    return subprocess.run(command, cwd=tree, check=True, capture_output=True, text=True).stdout.strip()


@pytest.fixture
def tree(tmp_path, monkeypatch):
    """A repository with one commit; results are stored beside it."""
    monkeypatch.setenv("POINTLOOM_NIGHTLY", str(tmp_path / "results"))
    monkeypatch.delenv("POINTLOOM_DATA", raising=False)
    folder = tmp_path / "tree"
    (folder / "src").mkdir(parents=True)
    (folder / "docs").mkdir()
    for name in ("src/a.py", "docs/page.md", "pyproject.toml"):
        (folder / name).write_text("first\n")
    (folder / ".gitignore").write_text("ran\n*.tmp\n")
    git(folder, "init", "-q")
    git(folder, "add", ".")
    git(folder, "commit", "-q", "-m", "first")
    return folder


def step(name, script="", minutes=1.0, **fields):
    """A step that adds its name to the file `ran`, then runs a script."""
    return nightly.Step(name, ("sh", "-c", f"echo {name} >> ran; {script or 'echo done'}"), minutes, **fields)


def run(tree, steps, *words):
    """Run all steps, unless the words draw or choose some."""
    words = words if any(word in ("--seed", "--only") for word in words) else ("--all", *words)
    return nightly.main(words, root=tree, steps=steps)


def ran(tree):
    """The names of the steps that have run since the last call."""
    path = tree / "ran"
    names = path.read_text().split() if path.exists() else []
    path.unlink(missing_ok=True)
    return names


def table(capsys):
    """The rows of the printed table: (result, seconds, commit) by step."""
    shown = capsys.readouterr().out
    rows = shown[shown.index("\nstep ") :].splitlines()
    return {m["step"]: (m["result"], m["seconds"], m["commit"]) for m in map(LINE.match, rows) if m}


def test_a_step_with_a_result_for_the_same_inputs_is_not_run_again(tree, capsys):
    steps = [step("one"), step("two")]
    assert run(tree, steps) == 0
    assert ran(tree) == ["one", "two"]
    (tree / "src" / "ignored.tmp").write_text("ignored by git")
    assert run(tree, steps) == 0
    assert ran(tree) == []
    assert [row[0] for row in table(capsys).values()] == ["passed", "passed"]


@pytest.mark.parametrize("name", ["src/a.py", "docs/new.md"])
def test_a_step_runs_again_when_a_file_changes_or_is_removed(tree, name):
    steps = [step("one")]
    run(tree, steps)
    (tree / name).write_text("second\n")
    run(tree, steps)
    (tree / name).unlink()
    run(tree, steps, "--only", "one")
    assert ran(tree) == ["one"] * 3


def test_the_command_the_variables_and_real_data_are_inputs(tree, monkeypatch):
    run(tree, [step("one", variables={"ORDER": "2"})])
    run(tree, [step("one", variables={"ORDER": "3"})])
    run(tree, [step("one", "true", variables={"ORDER": "3"})])
    assert ran(tree) == ["one"] * 3
    monkeypatch.setenv("POINTLOOM_DATA", "/data")
    run(tree, [step("one", "true", variables={"ORDER": "3"})])
    assert ran(tree) == ["one"]


def test_the_variables_of_a_step_reach_it_and_those_of_make_do_not(tree, capsys, monkeypatch):
    for name in ("ARGS", "MAKEFLAGS", "RUNS"):
        monkeypatch.setenv(name, "--only one")
    run(tree, [step("one", 'echo "$ORDER:$ARGS:$MAKEFLAGS:$RUNS"', variables={"ORDER": "3"})])
    assert "3:::" in capsys.readouterr().out


def test_a_failed_step_does_not_stop_the_next_ones(tree, capsys):
    steps = [step("bad", "echo the reason; echo 'make: *** Error 3'; exit 3"), step("good")]
    assert run(tree, steps) == 1
    assert ran(tree) == ["bad", "good"]
    shown = capsys.readouterr().out
    assert re.search(r"^failed: bad: the reason\n +log: (.*)$", shown, re.MULTILINE)
    log = Path(re.search(r"^ +log: (.*bad.*)$", shown, re.MULTILINE)[1])
    assert log.read_text().splitlines()[0] == "the reason"


def test_a_step_without_tests_passes_only_if_it_may_be_empty(tree, capsys):
    script = "echo '==== 12 deselected in 0.5s ===='; echo 'make: *** [Makefile:9: test-all] Error {}'; exit 2"
    cases = (("empty", 5, True), ("failed", 1, True), ("other", 5, False))
    steps = [step(name, script.format(code), may_be_empty=is_fine) for name, code, is_fine in cases]
    assert run(tree, steps) == 1
    assert [row[0] for row in table(capsys).values()] == ["passed", "failed", "failed"]


def test_a_failed_step_runs_again_only_on_request(tree, capsys):
    steps = [step("bad", "test -e fixed.tmp"), step("good")]
    run(tree, steps)
    ran(tree)
    assert run(tree, steps) == 1
    assert ran(tree) == []
    (tree / "fixed.tmp").touch()
    assert run(tree, steps, "--only", "ba", "--again") == 0
    assert ran(tree) == ["bad"]


def test_the_table_has_result_seconds_and_commit_of_each_step(tree, capsys):
    commit = git(tree, "rev-parse", "--short=8", "HEAD")
    steps = [step("one"), step("two", "exit 1"), step("three", minutes=1000)]
    assert run(tree, steps, "--budget", "60") == 1
    shown = table(capsys)
    assert {name: row[0] for name, row in shown.items()} == {"one": "passed", "two": "failed", "three": "not run"}
    assert shown["one"][2] == shown["two"][2] == commit and float(shown["one"][1]) >= 0
    assert shown["three"][1:] == (None, "")
    (tree / "src" / "a.py").write_text("second\n")
    run(tree, steps, "--budget", "0")
    assert table(capsys)["one"] == ("not run", None, f"passed at {commit}, for other inputs")
    run(tree, steps, "--only", "one")
    assert table(capsys)["one"][2] == f"{commit}+"


def test_the_budget_starts_only_steps_that_are_expected_to_end_in_it(tree, capsys):
    steps = [step("slow", minutes=90), step("quick", minutes=10), step("known", minutes=90)]
    run(tree, steps, "--only", "known")  # takes less than a second
    (tree / "src" / "a.py").write_text("second\n")
    ran(tree)
    capsys.readouterr()
    assert run(tree, steps, "--budget", "30") == 1
    assert ran(tree) == ["quick", "known"]
    assert "remaining: 1 steps, 90 min expected: slow" in capsys.readouterr().out


DRIVER = """
import sys
from pathlib import Path
sys.path.insert(0, sys.argv[1])
import nightly
steps = [nightly.Step(name, ("sh", "-c", script), 1.0) for name, script in zip(sys.argv[2::2], sys.argv[3::2])]
sys.exit(nightly.main(["--all"], root=Path.cwd(), steps=steps))
"""


def interrupted(tree, steps):
    """Run steps in a process of its own, since one of them ends that process. Returns its exit code and output."""
    words = [word for s in steps for word in (s.name, s.command[-1])]
    command = [sys.executable, "-c", DRIVER, str(ROOT / "scripts"), *words]
    done = subprocess.run(command, cwd=tree, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


@pytest.mark.parametrize("signal", ["INT", "TERM", "KILL"])
def test_the_next_run_continues_after_an_interruption(tree, signal, capsys):
    # Ends the runner in the first run, and passes in the second one.
    script = f"test -e second.tmp && exit 0; touch second.tmp; kill -{signal} $PPID; sleep 600"
    if signal == "KILL":  # nobody ends the step
        script = script.replace("sleep 600", "exit 1")
    steps = [step("first"), step("second", script), step("third")]
    code, shown = interrupted(tree, steps)
    assert code == (-9 if signal == "KILL" else 130)
    assert ran(tree) == ["first", "second"]
    if signal != "KILL":
        assert re.search(r"^first +passed", shown, re.MULTILINE)
        assert re.search(r"^second +not run", shown, re.MULTILINE)
        assert "remaining: 2 steps" in shown
    assert run(tree, steps) == 0
    assert ran(tree) == ["second", "third"]


def test_an_interruption_ends_all_processes_of_the_step(tree):
    os.mkfifo(tree / "open.tmp")
    end = os.open(tree / "open.tmp", os.O_RDONLY | os.O_NONBLOCK)
    script = "exec 9> open.tmp; sleep 600 & kill -TERM $PPID; wait"
    assert interrupted(tree, [step("one", script)])[0] == 130
    assert select.select([end], [], [], 60)[0] and os.read(end, 1) == b""  # no process has the file open for writing
    os.close(end)


def test_a_step_whose_inputs_change_while_it_runs_is_not_counted(tree, capsys):
    steps = [step("one", "test -e second.tmp || echo changed > src/a.py; touch second.tmp")]
    assert run(tree, steps) == 1
    assert table(capsys)["one"][0] == "not run"
    assert run(tree, steps) == 0
    assert ran(tree) == ["one", "one"]


def test_a_stored_result_has_all_facts(tree, tmp_path):
    run(tree, [step("one", "echo last; echo")])
    result = json.loads((tmp_path / "results" / "results.json").read_text())["one"]
    assert result["result"] == "passed" and result["last_line"] == "last"
    assert len(result["digest"]) == 64 and result["commit"] == git(tree, "rev-parse", "--short=8", "HEAD")
    assert result["seconds"] >= 0 and result["cpu_seconds"] >= 0
    assert (tmp_path / "results" / "logs" / "one.log").read_text() == "last\n\n"


def test_a_damaged_file_of_results_is_an_error_that_names_it(tree, tmp_path):
    run(tree, [step("one")])
    path = tmp_path / "results" / "results.json"
    path.write_text(path.read_text()[:50])
    with pytest.raises(SystemExit, match=re.escape(str(path))):
        run(tree, [step("one")])


def test_an_unknown_step_is_an_error_that_lists_the_known_ones(tree):
    with pytest.raises(SystemExit, match=r"--only: .* \(flakes, fuzz\), got 'muta'"):
        run(tree, [step("fuzz"), step("flakes-1")], "--only", "muta")


def test_a_step_that_takes_much_longer_than_expected_is_ended_and_fails(tree, monkeypatch, capsys):
    monkeypatch.setattr(nightly, "MIN_LIMIT", 0.2)
    assert run(tree, [step("long", "sleep 600", minutes=1e-4), step("next")]) == 1
    assert "failed: long: ended after 0 minutes" in capsys.readouterr().out
    assert ran(tree) == ["long", "next"]


# ------------------------------------------------------------------------------------------------ the drawing

MONDAY, TUESDAY, WEDNESDAY = "2026-11-30", "2026-12-01", "2026-12-02"


def on(steps, day):
    """The names of the steps that are among the first ones of a day."""
    cycle = nightly.Cycle(steps, datetime.date.fromisoformat(day))
    return [step.name for step in steps if cycle.age(step) == 0]


def test_a_drawn_run_takes_the_steps_of_its_day_first_and_then_those_missed(tree):
    steps = [*(step(name, minutes=25) for name in "abcd"), step("daily", minutes=5, is_daily=True)]
    first, second = on(steps, MONDAY), on(steps, TUESDAY)
    assert len(first) == len(second) == 3 and {*first} | {*second} == {*"abcd", "daily"}
    assert run(tree, steps, "--seed", MONDAY) == 0
    names = ran(tree)
    assert {*names[:3]} == {*first} and {*names[3:]} == {*second} - {"daily"}
    assert run(tree, steps, "--seed", MONDAY) == 0
    assert ran(tree) == []
    (tree / "src" / "a.py").write_text("second\n")
    assert run(tree, steps, "--seed", TUESDAY) == 0  # the others have passed since their day, with another tree
    assert {*ran(tree)} == {*second}
    (tree / "src" / "a.py").write_text("third\n")
    assert run(tree, steps, "--seed", WEDNESDAY) == 0
    assert {*ran(tree)} == {*first}


def test_a_step_that_failed_in_a_drawn_run_runs_again_when_a_file_changes(tree):
    steps = [step("bad", "grep second src/a.py"), step("good")]
    assert run(tree, steps, "--seed", MONDAY) == 1
    assert run(tree, steps, "--seed", MONDAY) == 1
    assert sorted(ran(tree)) == ["bad", "good"]
    (tree / "src" / "a.py").write_text("second\n")
    assert run(tree, steps, "--seed", MONDAY) == 0
    assert ran(tree) == ["bad"]


def test_results_of_the_same_day_count_toward_the_budget(tree, tmp_path, capsys):
    run(tree, [step("long")], "--seed", MONDAY)
    path = tmp_path / "results" / "results.json"
    results = json.loads(path.read_text())
    results["long"]["seconds"] = 58 * 60.0
    path.write_text(json.dumps(results))
    ran(tree)
    steps = [step("long", is_daily=True), step("more", minutes=5, is_daily=True), step("short", is_daily=True)]
    assert run(tree, steps, "--seed", MONDAY) == 0
    assert ran(tree) == ["short"]
    assert "remaining: 1 steps, 5 min expected: more" in capsys.readouterr().out
    (tree / "src" / "a.py").write_text("second\n")
    run(tree, steps, "--seed", TUESDAY)
    assert ran(tree) == ["long", "more", "short"]


def test_the_table_counts_the_steps_that_were_not_drawn(tree, capsys):
    steps = [step(name, minutes=40) for name in "abc"] + [step("whole", minutes=90)]
    run(tree, steps, "--seed", MONDAY, "--budget", "50")
    run(tree, steps, "--seed", TUESDAY, "--budget", "0")
    shown = capsys.readouterr().out
    assert f"not drawn on {MONDAY}: 1 of 4 steps, each is among the first once in 2 days" in shown
    assert f"not drawn on {TUESDAY}: 3 of 4 steps" in shown
    assert "without any result of the last 2 days: 1 of 4 steps" in shown


DAY = datetime.date(2026, 11, 30)
ALL_STEPS = nightly.all_steps(DAY)


def test_each_step_that_fits_into_the_budget_is_drawn_once_in_a_cycle():
    days = nightly.Cycle(ALL_STEPS, DAY).days
    for offset in range(days):
        cycle = nightly.Cycle(ALL_STEPS, DAY + datetime.timedelta(offset))
        minutes = sum(step.minutes for step in ALL_STEPS if cycle.age(step) == 0)
        assert minutes < 1.1 * nightly.BUDGET
    drawn = [step for step in ALL_STEPS if not step.is_daily and step.minutes <= nightly.BUDGET]
    cycles = [nightly.Cycle(ALL_STEPS, DAY + datetime.timedelta(offset)) for offset in range(days)]
    assert all(sum(cycle.age(step) == 0 for cycle in cycles) == 1 for step in drawn)


def test_names_of_steps_are_unique():
    assert len({step.name for step in ALL_STEPS}) == len(ALL_STEPS)


def test_daily_steps_have_the_date_as_seed():
    tomorrow = nightly.all_steps(DAY + datetime.timedelta(1))
    assert [a.name for a, b in zip(ALL_STEPS, tomorrow, strict=True) if a.command != b.command] == [
        step.name for step in ALL_STEPS if step.is_daily
    ]


def test_the_steps_of_a_set_take_each_of_its_test_files_once():
    packages = re.search(r"^PACKAGES := (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)[1].split()
    emulated = [ROOT / "tests" / package for package in (*packages, "emulated_cuda")]
    families = {f"emulated-{order}-": emulated for order in nightly.ORDERS} | {"nightly-tests-": [ROOT / "tests"]}
    for family, folders in families.items():
        steps = [step for step in ALL_STEPS if step.name.startswith(family)]
        named = [ROOT / word for step in steps for word in re.findall(r"tests/[\w/.]+", step.command[-1])]
        taken = [file for path in named for file in (path.rglob("test_*.py") if path.is_dir() else [path])]
        assert sorted(taken) == sorted(file for folder in folders for file in folder.rglob("test_*.py"))


def test_all_architectures_of_check_cuda_are_steps():
    assert f"ARCHITECTURES = {nightly.ARCHITECTURES}" in (ROOT / "src/pointloom/kernels/check_cuda.py").read_text()


OTHER_NAMES = {
    "datafusion": "rerun-sdk",  # by its extra "catalog"
    "foxglove": "foxglove-sdk",
    "pil": "pillow",
    "rerun": "rerun-sdk",
    "skimage": "scikit-image",
    "vtkmodules": "vtk",
}


def test_each_package_that_a_test_may_skip_for_is_installed_by_a_list_of_constraints_or_a_step():
    lists = "\n".join(path.read_text() for path in (ROOT / "constraints").glob("*.txt"))
    installed = {name.lower().replace("_", "-") for name in re.findall(r"^[\w.-]+", lists, re.MULTILINE)}
    installed |= {re.split("[<>=]", word)[0] for word in nightly.OTHERS.split()}
    missing = set()
    for path in (ROOT / "tests").rglob("*.py"):
        modules = re.findall(r"""importorskip\(["']([\w]+)""", path.read_text(encoding="utf-8"))
        for module in {module for module in modules if module not in sys.stdlib_module_names}:
            package = module.lower().replace("_", "-")
            if OTHER_NAMES.get(package, package) not in installed:
                missing.add((path.relative_to(ROOT).as_posix(), module))
    assert not missing
