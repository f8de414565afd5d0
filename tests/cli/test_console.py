"""Progress lines of commands: the estimate of the remaining time, and kept folders."""

import re

import click
import numpy as np
import pytest

import pointloom as loom
from pointloom.cli.shell import console
from pointloom.cli.shell.cli import cli
from pointloom.core.verbosity import LOGGER
from pointloom.core.wording import format_duration

from .commands import run


class Clock:
    def __init__(self):
        self.now = 100.0

    def monotonic(self):
        return self.now


@pytest.fixture
def clock(monkeypatch):
    clock = Clock()
    monkeypatch.setattr(console, "time", clock)
    monkeypatch.setattr(console, "LINE_INTERVAL", 5.0)
    return clock


def lines_of(clock, capsys, steps, **options):
    """The lines of (seconds later, stage, done, total)."""
    with console.Progress(**options) as progress:
        for seconds, *step in steps:
            clock.now += seconds
            progress(*step)
    return capsys.readouterr().err.splitlines()


def test_lines_have_the_remaining_time_of_their_stage(clock, capsys):
    steps = [(0, "a", 0, 10), (10, "a", 2, 10), (10, "a", 8, 10), (10, "a", 10, 10), (0, "b", 5, 0), (10, "b", 9, 0)]
    assert lines_of(clock, capsys, steps) == [
        "a: 2 of 10, about 40 s left in this stage",
        "a: 8 of 10, about 5 s left in this stage",
        "a: 10 of 10",
        "b",
    ]


def test_steps_of_an_earlier_run_do_not_count(clock, capsys):
    steps = [(0, "a", 90, 100), (20, "a", 92, 100), (20, "c", 0, 5), (1, "c", 1, 5)]
    assert lines_of(clock, capsys, steps)[:2] == ["a: 92 of 100, about 80 s left in this stage", "c: 0 of 5"]


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(0, "1 s"), (99.4, "99 s"), (100, "2 min"), (3569, "59 min"), (3600, "1 h 0 min"), (7501, "2 h 5 min")],
)
def test_durations_are_rough(seconds, text):
    assert format_duration(seconds) == text


@pytest.mark.parametrize(
    ("options", "seconds", "expected"),
    [
        (
            {"kept": "work"},
            1,
            ["intermediate files: work; the same command continues", "finished work is kept in work"],
        ),
        (
            {"kept": "work", "resume": "--resume"},
            1,
            ["intermediate files: work; the same command with --resume", "fin"],
        ),
        ({}, 61, ["nothing is kept; the same command starts again"]),
        ({}, 59, []),
    ],
)
def test_ctrl_c_reports_what_is_kept(clock, capsys, options, seconds, expected):
    with pytest.raises(KeyboardInterrupt), console.Progress(**options) as progress:
        progress("a", 0, 0)
        clock.now += seconds
        raise KeyboardInterrupt
    lines = [line for line in capsys.readouterr().err.splitlines() if line != "a"]
    assert len(lines) == len(expected)
    assert all(line.startswith(start) for line, start in zip(lines, expected, strict=True))


def commands_below(group, words=()):
    for name, command in group.commands.items():
        if isinstance(command, click.Group):
            yield from commands_below(command, (*words, name))
        else:
            yield (*words, name), command


def test_every_command_has_the_options_q_and_v():
    found = dict(commands_below(cli))
    assert ("tile", "plan") in found and len(found) > 40
    for words, command in found.items():
        names = [set(one.opts) for one in command.params]
        assert {"-q", "--quiet"} in names and {"-v", "--verbose"} in names, words
        result = run(*words, "-q", "-v")
        assert (result.exit_code, "-q excludes -v" in result.stderr) == (2, True) or command.params[0].required, words


def test_quiet_prints_results_and_errors_and_verbose_also_stages_and_times(tmp_path, monkeypatch):
    points = np.random.default_rng(0).random((500, 3))
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud(points, normals=points))
    monkeypatch.setattr(console, "LINE_INTERVAL", 0.0)
    level = LOGGER.level
    source, target = tmp_path / "a.ply", tmp_path / "b.ply"
    words = ("clean", source, "-o", target, "--force")
    plain, quiet, verbose = run(*words), run(*words, "-q"), run(*words, "-v")
    assert plain.exit_code == quiet.exit_code == verbose.exit_code == 0
    assert len({re.sub(r"\d+\.\d+", "", result.stdout) for result in (plain, quiet, verbose)}) == 1 and plain.stdout
    assert quiet.stderr == ""
    assert all(line in verbose.stderr for line in plain.stderr.splitlines()) and len(verbose.stderr) > len(plain.stderr)
    assert re.search(r"^finished after \d+\.\d s$", verbose.stderr, re.MULTILINE)
    assert re.search(r"^\w.*, after \d+\.\d s$", verbose.stderr, re.MULTILINE)
    failed = run("clean", source, "-o", target, "-q")
    assert failed.exit_code == 1 and failed.stderr.startswith("error: ") and LOGGER.level == level
