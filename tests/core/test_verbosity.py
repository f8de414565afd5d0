"""Messages are visible without logging configuration, and follow the program's configuration otherwise."""

import logging
import os
import subprocess
import sys

import pytest

import pointloom as loom
from pointloom.core.checks import check_progress
from pointloom.core.verbosity import get_verbosity_level

SCRIPT = """
import sys, time, logging
import pointloom as loom
from pointloom.core import verbosity
from pointloom.core.checks import check_progress
{begin}
verbosity.LOG_INTERVAL = 0.0
say = check_progress(None)
say("pairs", 3, 10)
logging.getLogger("pointloom").debug("details")
"""


def output_of(begin):
    command = [sys.executable, "-c", SCRIPT.format(begin=begin)]
    settings = {name: value for name, value in os.environ.items() if name != "POINTLOOM_VERBOSITY"}
    run = subprocess.run(command, capture_output=True, text=True, check=True, env=settings)
    assert run.stdout == ""
    return run.stderr


@pytest.mark.parametrize(
    ("begin", "output"),
    [
        pytest.param("", "pointloom: pairs 3 of 10, after 0 s\n", marks=pytest.mark.slow),
        (
            "loom.set_verbosity_level(loom.VerbosityLevel.Debug)",
            "pointloom: pairs 3 of 10, after 0 s\npointloom: details\n",
        ),
        ("logging.basicConfig(format='mine %(message)s')", "mine pairs 3 of 10, after 0 s\n"),
    ],
)
def test_a_long_call_prints_its_progress(begin, output):
    assert output_of(begin) == output


def test_a_short_call_prints_nothing(caplog):
    with caplog.at_level(logging.INFO, "pointloom"):
        report = check_progress(None)
        for done in range(100):
            report("pairs", done, 100)
    assert caplog.records == []


def test_debug_prints_each_stage(caplog):
    with loom.VerbosityContextManager(loom.VerbosityLevel.Debug):
        report = check_progress(None)
        for stage in ("voxels", "search", "search", "refine"):
            report(stage, 0, 0)
    assert [record.getMessage() for record in caplog.records] == ["voxels", "search", "refine"]


def test_a_block_leaves_the_level_as_it_was():
    logger = logging.getLogger("pointloom")
    before = logger.level
    with loom.VerbosityContextManager(loom.VerbosityLevel.Error):
        assert get_verbosity_level() is loom.VerbosityLevel.Error and logger.level == logging.ERROR
        with pytest.raises(KeyError), loom.VerbosityContextManager(loom.VerbosityLevel.Debug):
            assert get_verbosity_level() is loom.VerbosityLevel.Debug
            raise KeyError
        assert get_verbosity_level() is loom.VerbosityLevel.Error
    assert logger.level == before
    for wrong in (2, "Info", None):
        with pytest.raises(TypeError, match=r"^verbosity_level:.*VerbosityLevel\.Error"):
            loom.set_verbosity_level(wrong)
        with pytest.raises(TypeError, match="expected a VerbosityLevel"):
            loom.VerbosityContextManager(wrong)


def test_requested_progress_is_printed(capsys):
    cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    cloud.cluster_dbscan(2.0, 2, print_progress=True)
    filtered, _ = cloud.remove_radius_outlier(1, 2.0, print_progress=True)
    lines = capsys.readouterr().err.splitlines()
    assert lines[0] == "pointloom: clusters of 4 points ..."
    assert lines[1].startswith("pointloom: clusters of 4 points: ")
    assert len(lines) == 4 and len(filtered) == 4
    cloud.cluster_dbscan(2.0, 2)
    assert capsys.readouterr().err == ""


def test_a_closed_stderr_is_ignored(monkeypatch, capsys):
    cloud = loom.PointCloud([[0, 0, 0]])
    monkeypatch.setattr(sys, "stderr", None)
    cloud.cluster_dbscan(2.0, 2, print_progress=True)
    assert capsys.readouterr().out == ""


@pytest.mark.slow
@pytest.mark.parametrize(("given", "level"), [("error", "Error"), ("DEBUG", "Debug"), ("loud", "Info"), ("", "Info")])
def test_the_environment_sets_the_verbosity(given, level):
    program = "import pointloom as loom; loom.PointCloud([[0, 0, 0]]); "
    program += "from pointloom.core.verbosity import get_verbosity_level as level; print(level().name)"
    command = [sys.executable, "-c", "from pointloom.core import verbosity; verbosity.start(); " + program]
    settings = os.environ | {"POINTLOOM_VERBOSITY": given}
    assert subprocess.run(command, capture_output=True, text=True, check=True, env=settings).stdout.strip() == level
