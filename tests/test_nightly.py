"""`make nightly` on a small repository: stored results, digests of inputs, interruptions, the budget, the table."""

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

LINE = re.compile(r"^(?P<step>[\w-]+) +(?P<result>passed|failed|not run) *(?P<seconds>[\d.]+)? *(?P<commit>.*)$")


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


def step(name, script="", **fields):
    """A step that adds its name to the file `ran`, then runs a script."""
    return nightly.Step(
        name, ("sh", "-c", f"echo {name} >> ran; {script or 'echo done'}"), **{"inputs": ("src/",)} | fields
    )


def run(tree, steps, *words):
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
    (tree / "docs" / "page.md").write_text("no input of these steps")
    (tree / "src" / "ignored.tmp").write_text("ignored by git")
    assert run(tree, steps) == 0
    assert ran(tree) == []
    assert [row[0] for row in table(capsys).values()] == ["passed", "passed"]


@pytest.mark.parametrize("name", ["src/a.py", "src/new.py", "pyproject.toml", "constraints/test.txt"])
def test_a_step_runs_again_when_a_file_that_it_depends_on_changes(tree, name):
    steps = [step("code"), step("page", inputs=("docs/",))]
    run(tree, steps)
    ran(tree)
    (tree / name).parent.mkdir(exist_ok=True)
    (tree / name).write_text("second\n")
    assert run(tree, steps) == 0
    assert ran(tree) == (["code"] if name.startswith("src/") else ["code", "page"])


def test_a_removed_file_changes_the_digest_and_an_excluded_one_does_not(tree):
    (tree / "src" / "list.toml").write_text("1")
    steps = [step("all"), step("without", inputs=("src/", "!src/a")), step("one", inputs=("!src/", "src/list"))]
    run(tree, steps)
    ran(tree)
    (tree / "src" / "a.py").unlink()
    run(tree, steps)
    assert ran(tree) == ["all"]
    (tree / "src" / "list.toml").write_text("2")
    run(tree, steps)
    assert ran(tree) == ["all", "without", "one"]


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
steps = [nightly.Step(name, ("sh", "-c", script), ("src/",)) for name, script in zip(sys.argv[2::2], sys.argv[3::2])]
sys.exit(nightly.main([], root=Path.cwd(), steps=steps))
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


def test_an_unknown_step_is_an_error_that_lists_the_known_ones(tree, capsys):
    with pytest.raises(SystemExit):
        run(tree, [step("fuzz"), step("flakes-1")], "--only", "muta")
    assert "got 'muta'. Steps: flakes, fuzz" in capsys.readouterr().err


ALL_STEPS = nightly.all_steps(ROOT)


def test_names_of_steps_are_unique_and_their_inputs_exist():
    assert len({step.name for step in ALL_STEPS}) == len(ALL_STEPS)
    for prefix in {prefix for step in ALL_STEPS for prefix in step.inputs}:
        assert (ROOT / prefix.removeprefix("!")).exists(), prefix


def test_the_steps_of_a_set_take_each_of_its_test_files_once():
    packages = re.search(r"^PACKAGES := (.*)$", (ROOT / "Makefile").read_text(), re.MULTILINE)[1].split()
    emulated = [ROOT / "tests" / package for package in (*packages, "emulated_cuda")]
    families = {f"emulated-{order}-": emulated for order in nightly.ORDERS} | {"nightly-tests-": [ROOT / "tests"]}
    for family, folders in families.items():
        steps = [step for step in ALL_STEPS if step.name.startswith(family)]
        named = [ROOT / word for step in steps for word in re.findall(r"tests/[\w/.]+", step.command[-1])]
        taken = [file for path in named for file in (path.rglob("test_*.py") if path.is_dir() else [path])]
        assert sorted(taken) == sorted(file for folder in folders for file in folder.rglob("test_*.py"))


def test_each_list_of_mutants_is_covered_by_its_parts():
    commands = [step.command[-1] for step in ALL_STEPS if step.name.startswith("mutants-")]
    words, parts = [re.search(r"--from (\S+) --part (\d+)/(\d+)", command) for command in commands], {}
    for word in words:
        parts.setdefault((word[1], int(word[3])), []).append(int(word[2]))
    assert sorted(name for name, _ in parts) == sorted(path.name for path in (ROOT / "tests/mutants").glob("*.toml"))
    assert all(numbers == [*range(1, total + 1)] for (_, total), numbers in parts.items())


def test_all_architectures_of_check_cuda_are_steps():
    assert f"ARCHITECTURES = {nightly.ARCHITECTURES}" in (ROOT / "src/pointloom/kernels/check_cuda.py").read_text()
