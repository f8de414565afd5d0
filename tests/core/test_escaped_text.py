"""Text from files is printed without terminal control characters."""

import ast
import json
import pickle
from pathlib import Path

import numpy as np
import pytest

import pointloom as loom
from pointloom.core import html_tables, reports, verbosity, wording
from pointloom.core.errors import FileError
from pointloom.core.escaped_text import escaped
from pointloom.io.bags.recording import Recording
from pointloom.io.columns import warn_of_loss
from pointloom.io.points.formats import read_points
from pointloom.rgbd.reconstruction.config import ReconstructionConfig
from pointloom.tiling.jobs.job import JobStatus

from ..test_imports import ROOT

EVIL = "a\x1b]0;owned\x07\x9b2K\x7f\u202e\ud800\r\x00b"
SHOWN = r"a\x1b]0;owned\x07\x9b2K\x7f\u202e\ud800\x0d\x00b"


def warned(text):
    with pytest.warns(UserWarning) as caught:
        warn_of_loss(text, text, text)
    return str(caught[0].message)


def logged(text, capsys):
    verbosity._print(text)
    return capsys.readouterr().err


def missing(name):
    with pytest.raises(ValueError, match="other") as caught:
        loom.PointCloud(np.zeros((1, 3)), **{name: np.zeros(1)})["other"]
    return str(caught.value)


def refused(call, *arguments):
    with pytest.raises(ValueError) as caught:
        call(*arguments)
    return str(caught.value)


TEXTS = {
    "an error": lambda text, _: str(FileError(text, text, where=text, remedy=text)),
    "an error from another process": lambda text, _: str(pickle.loads(pickle.dumps(FileError(text, text)))),
    "a warning": lambda text, _: warned(text),
    "a report": lambda text, _: reports.in_columns([(text, text)]),
    "a table in a notebook": lambda text, _: html_tables.html_table(text, [(text, text)]),
    "a log": logged,
    "a job": lambda text, _: str(JobStatus("", "", "", 0, 0, 0, 0, 0, False, {text: text}, (text,))),
    "a cloud": lambda text, _: repr(loom.PointCloud(np.zeros((1, 3)), **{text: np.zeros(1)})),
    "an attribute that is missing": lambda text, _: missing(text),
    "a few names": lambda text, _: wording.few_of([text], 3),
    "a format without columns": lambda text, _: refused(read_points, f"a.{text}", ["x"]),
    "a configuration": lambda text, _: refused(ReconstructionConfig.from_names, {text: 1}),
    "a recording": lambda text, _: repr(Recording(Path(text.replace("\0", "")), [])),
}


@pytest.mark.parametrize("text_of", TEXTS.values(), ids=TEXTS)
def test_control_characters_are_shown(text_of, capsys):
    text = text_of(EVIL, capsys)
    assert r"a\x1b]0;owned\x07\x9b2K\x7f\u202e\ud800\x0d" in text
    assert escaped(text, lines=True) == text


def test_one_line_stays_one(capsys):
    assert "\n" not in str(FileError("a\nerror: none", "b\nc"))
    assert escaped("a\nb", lines=True) == "a\nb" and escaped(EVIL) == SHOWN
    assert reports.in_columns([("size", "1\nmesh  none")]) == "  size  1\n        mesh  none"


def test_json_keeps_what_it_escapes():
    text = wording.json_text({EVIL: EVIL, "line": "é\n\t"})
    assert escaped(text, lines=True) == text and json.loads(text) == {EVIL: EVIL, "line": "é\n\t"}


def test_warnings_of_readers_and_writers_are_escaped():
    """Each names a path, and many what a file calls its parts."""
    plain = []
    for path in (ROOT / "src/pointloom/io").rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Call) and ast.unparse(node.func) == "warnings.warn":
                message = ast.unparse(node.args[0])
                is_escaped = message.startswith("escaped(") or f"{message} = escaped(" in path.read_text()
                plain += [] if is_escaped else [f"{path.name}:{node.lineno}"]
    assert not plain
