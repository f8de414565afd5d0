"""register, multiway, odometry and evaluate: what holds for all of them."""

import pytest

from .commands import run

COMMANDS = ("register", "multiway", "odometry", "evaluate")


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_explains_itself_with_an_example(command):
    shown = run(command, "-h").stdout
    assert f"\n  pointloom {command} " in shown
    assert "--json" in shown
    assert shown.isascii()
    assert f"  {command} " in run("-h").stdout


@pytest.mark.parametrize(
    ("words", "hint"),
    [
        ("register a.ply", "missing argument 'B'"),
        ("register a.ply b.ply --init globl", "--init: expected global, identity or a file of a pose, got 'globl'"),
        ("register a.ply b.ply --method icp", "'--method'"),
        ("register a.ply b.ply --voxel 0", "'--voxel': expected a length in metres above 0, got '0'"),
        ("register a.ply b.ply --distance nan", "'--distance'"),
        ("register a.ply b.ply --aligned c.png --picture ./c.png", "--picture is the file of --aligned, c.png"),
        ("multiway scans", "missing option '-o'"),
        ("multiway scans -o a.log --loops 0", "'--loops': expected a whole number from 1"),
        ("multiway scans -o a.log --job job", "missing option '--voxel'; --job"),
        ("multiway scans -o a.log --voxel 1 --job job --merged b.ply", "--merged holds all clouds in memory"),
        ("multiway scans -o a.log --workers 2", "--workers, --places and --place-error go with --job"),
        ("odometry scans", "missing option '-o'"),
        ("odometry scans -o a.txt --format json", "'--format'"),
        ("odometry scans -o a.txt --min-range -1", "'--min-range': expected a distance in metres, 0 or above"),
        ("odometry scans -o a.txt --min-range inf", "'--min-range'"),
        ("odometry scans -o a.txt --max-range 3", "--min-range 5 leaves nothing within --max-range 3"),
        ("evaluate a.txt", "missing argument 'TRUTH'"),
        ("evaluate a.txt b.txt --alignment umeyama", "'--alignment'"),
    ],
)
def test_a_wrong_call_exits_with_2_and_names_the_option(words, hint):
    result = run(*words.split())
    assert result.exit_code == 2
    assert result.stdout == ""
    first, *others = result.stderr.splitlines()
    assert first.startswith("error: ")
    assert hint in first
    assert others == [f"See 'pointloom {words.split()[0]} --help'."]
