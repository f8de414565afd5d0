"""tile plan, run, status, retry and finish."""

import json
import os
import select
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from pointloom.cli.jobs import tiles as tile_jobs
from pointloom.cli.shell import tile_command
from pointloom.cli.shell.cli import cli
from pointloom.io.points.copc import open_copc
from pointloom.io.points.las import open_las
from pointloom.tiling import finish
from pointloom.tiling import plan as planning
from pointloom.tiling.manifest import Manifest
from pointloom.tiling.status import TileStatus

from ..sigint import sigint_enabled
from ..test_imports import ROOT
from ..tiling.scenes import finished, rows_of, survey, tiled
from .commands import answer, names_in, refusal, run

RADIUS = [{"step": "remove_radius_outlier", "nb_points": 4, "radius": 0.9}]
OWN = ["own_steps-1.0.dist-info", "own_steps.py"]
FAILING = """
import time

def fails_once(cloud):
    if not __import__("pathlib").Path("fixed").exists():
        raise RuntimeError("two\\nlines")
    return cloud

def is_slow(cloud):
    with open("begun", "wb", buffering=0) as pipe:
        pipe.write(b".")
    time.sleep(0.3)
    return cloud
"""


@pytest.fixture
def job(tmp_path, monkeypatch):
    """A working directory with a survey of two files and steps.toml."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.syspath_prepend(tmp_path)
    (tmp_path / "survey").mkdir()
    survey(tmp_path / "survey", count=2000)
    (tmp_path / "steps.toml").write_text('[[step]]\nstep = "remove_radius_outlier"\nnb_points = 4\nradius = 0.9\n')
    (tmp_path / "own_steps.py").write_text(FAILING)
    package = tmp_path / OWN[0]  # as an installed package that registers two entry points
    package.mkdir()
    (package / "METADATA").write_text("Metadata-Version: 2.1\nName: own_steps\nVersion: 1.0\n")
    points = [f"{name} = own_steps:{name}" for name in ("fails_once", "is_slow")]
    (package / "entry_points.txt").write_text("\n".join(["[pointloom.steps]", *points]))
    return tmp_path


def plan_with(job, call):
    (job / "own.toml").write_text(f'[[step]]\nstep = "function"\ncall = "{call}"\nreach = 0\n')
    assert run("tile", "plan", "survey", "--steps", "own.toml", "-o", "job", "--size", "20").exit_code == 0


@pytest.mark.slow
def test_the_commands_match_the_functions(job):
    report = answer("tile", "plan", "survey", "--steps", "steps.toml", "-o", "job", "--size", "10")
    assert (report["command"], report["waiting"], report["sources_waiting"]) == ("tile plan", 25, 2)
    status = answer("tile", "status", "job")
    assert (status["waiting"], status["is_finished"]) == (25, False)
    report = answer("tile", "run", "job")
    assert report["is_finished"] and report["points_in"] == report["points"] == 2050
    assert answer("tile", "finish", "job", "-o", "out.laz")["files"] == ["out.laz"]
    assert not (job / "job" / "buckets").exists()
    printed = run("tile", "status", "job").stdout
    assert "25 of 25 done" in printed and "temporary" not in printed
    expected, _ = tiled([*(job / "survey").glob("*.laz")], RADIUS, job / "other", size=40.0)
    np.testing.assert_array_equal(rows_of(finished(job / "job")), rows_of(expected))


def test_planning_accepts_an_area_a_point_count_and_copc(job):
    words = ["tile", "plan", "survey", "--steps", "steps.toml", "-o"]
    assert answer(*words, "a", "--points", "500")["waiting"] == 9
    area = "500001,4000001,500009,4000009"
    assert answer(*words, "b", "--size", "10", "--only", area, "--output", "copc")["waiting"] == 1
    assert answer("tile", "run", "b", "--serial")["is_finished"]
    assert answer("tile", "finish", "b")["files"] == ["b/result.copc.laz"]
    assert "exists already" in refusal("tile", "finish", "b")
    assert answer("tile", "finish", "b", "--force")["is_finished"]


def test_finish_writes_the_requested_file_and_refuses_names_of_other_formats(job):
    answer("tile", "plan", "survey", "--steps", "steps.toml", "-o", "job", "--size", "25")
    answer("tile", "run", "job")
    count = answer("tile", "status", "job")["points_out"]
    assert answer("tile", "finish", "job", "--output", "las")["files"] == ["job/result.las"]
    assert open_las(job / "job/result.las").header.point_count == count
    assert not open_las(job / "job/result.las").header.is_compressed
    assert answer("tile", "finish", "job", "-o", "out.copc.laz", "--output", "copc")["files"] == ["out.copc.laz"]
    assert len(open_copc(job / "out.copc.laz").read().points) == count
    for words, message in (
        ("--output copc -o out.laz", "is not a file name for --output 'copc'. Use the extension .copc.laz"),
        ("--output laz -o out.copc.laz", "is not a file name for --output 'laz'"),
        ("-o out.xyz", "is not a file name of a LAS or LAZ file. Use the extension .laz or .las or .copc.laz"),
    ):
        assert message in " ".join(refusal("tile", "finish", "job", *words.split()).split())
    assert names_in(job) == ["job", "out.copc.laz", *OWN, "steps.toml", "survey"]


def test_parts_of_an_array_share_the_tiles(job):
    answer("tile", "plan", "survey", "--steps", "steps.toml", "-o", "job", "--size", "20")
    first = run("tile", "run", "job", "--part", "1/2")
    assert first.exit_code == 0 and "4 tiles are waiting" in first.stderr
    assert answer("tile", "run", "job", "--part", "2/2")["is_finished"]


def test_failed_tiles_are_named_with_the_command_to_repeat_them(job):
    plan_with(job, "fails_once")
    result = run("tile", "run", "job", "--serial")
    assert result.exit_code == 3 and "unreliable result: 9 failed of 9 tiles: 0_0, 1_0, 2_0, " in result.stderr
    (line,) = [line for line in result.stdout.splitlines() if line.startswith("  1_1 ")]
    assert line.endswith("RuntimeError: two lines; run it alone with `pointloom tile run job --tile 1_1`")
    assert run("tile", "status", "job").exit_code == 3
    (job / "fixed").touch()
    repeated = run("tile", "run", "job", "--tile", "1_1", "--json")
    assert (repeated.exit_code, json.loads(repeated.stdout)["done"]) == (3, 1)
    report = answer("tile", "retry", "job")
    assert (report["waiting"], report["done"], report["failed"]) == (8, 1, 0)
    assert answer("tile", "run", "job")["is_finished"]


def test_a_damaged_file_is_an_error_that_names_the_commands(job):
    answer("tile", "plan", "survey", "--steps", "steps.toml", "-o", "job", "--size", "20")
    assert "Call pointloom tile run" in refusal("tile", "finish", "job")
    with Manifest(job / "job") as manifest, manifest.change() as base:
        base.execute("UPDATE sources SET state = 'failed', error = 'it is torn' WHERE id = 1")
    message = refusal("tile", "run", "job")
    assert "part1.laz: its points cannot be sorted into tiles: it is torn" in message
    assert "run pointloom tile retry" in message and run("tile", "status", "job").exit_code == 3


@pytest.mark.parametrize("command", ["run", "status", "retry", "finish"])
def test_a_folder_without_a_plan_is_rejected(job, command):
    assert "plan.sqlite: does not exist. Run pointloom tile plan first" in refusal("tile", command, "nowhere")
    assert not (job / "nowhere").exists()


def test_bad_plans_are_rejected_and_leave_nothing(job):
    for words, message in (
        ("survey --steps no.toml", "no.toml: cannot be read"),
        ("survey --steps own_steps.py", "own_steps.py: not TOML"),
        ("nothing.laz --steps steps.toml", "nothing.laz"),
        ("steps.toml --steps steps.toml", "expected one of .las"),
        ("survey --steps steps.toml --only 1,2,3,4", "overlaps the tiles"),
    ):
        assert message in refusal("tile", "plan", *words.split(), "-o", "job")


@pytest.mark.slow
@pytest.mark.parametrize("how", [["--serial"], ["--workers", "2"]])
def test_ctrl_c_prints_one_line_and_the_next_run_continues(job, how):
    """Repeated four times; no tile may be counted as having killed its workers."""
    plan_with(job, "is_slow")
    setup = (
        f"import sys; sys.path[:0] = [{str(ROOT / 'src')!r}, {str(job)!r}]; from pointloom.cli.shell.cli import main; "
        "from pointloom.cli.shell import console; console.LINE_INTERVAL = 1e9; "  # no progress, even on slow machines
    )
    words = [sys.executable, "-c", f"{setup}main()", "tile", "run", "job", *how]
    os.mkfifo("begun")
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    begun = os.open("begun", os.O_RDWR)  # also for writing, so that no process waits for a reader
    for _ in range(4):
        before = answer("tile", "status", "job")
        with sigint_enabled():
            process = subprocess.Popen(words, process_group=0, text=True, **pipes)
        assert select.select([begun], [], [], 300)[0]
        os.killpg(process.pid, signal.SIGINT)  # as a terminal does
        stdout, stderr = process.communicate(timeout=300)
        assert (process.returncode, stdout, stderr.split()[-1]) == (130, "", "interrupted")
        assert "finished work is kept in job; the same command continues from it" in stderr
        os.read(begun, 1000)  # what this run wrote
        after = answer("tile", "status", "job")
        assert after["running"] == after["aside"] == 0 and after["done"] >= before["done"]
    os.close(begun)
    Path("begun").unlink()
    Path("begun").touch()
    with Manifest(job / "job") as manifest:
        assert sum(row["attempts"] for row in manifest.rows("SELECT attempts FROM tiles")) == 0
    assert answer("tile", "run", "job", "--workers", "2")["is_finished"]


def test_the_options_match_the_library_and_long_lists_of_names_are_cut():
    names = {f"{k}_0": "torn" for k in range(30)}
    report = tile_jobs.report_of("run", TileStatus("job", 0, 0, 0, 0, 30, 0, 0, 10, 0, 0, 0, names))
    assert "; ".join(report.warnings).endswith("18_0, 19_0 and 10 more") and len(report.to_dict()["troubles"]) == 30
    assert planning.OUTPUTS == tile_command.OUTPUTS and (*finish.FILES,) == tile_command.FILES
    commands = cli.commands["tile"].commands
    assert sorted(commands) == ["finish", "plan", "retry", "run", "status"]
    for name in commands:
        printed = run("tile", name, "--help").stdout
        assert "--json" in printed and f"\n  pointloom tile {name}" in printed and printed.isascii()
