"""Every argument of `loom.record` refuses what makes no sense, by an error that names it."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, missing_from, public_arguments, read_table

CALLS = """
loom.record(path="a.html", fps=10.0, size=(16, 12), max_points=100, max_frames=10, title="t", view=view, background=(1, 1, 1), progress=print)
"""  # noqa: E501
TABLE = read_table(CALLS, {})
CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


def test_the_table_names_every_argument():
    assert missing_from(TABLE, public_arguments(loom, set(loom.__all__) - {"record"})) == {}


@cache
def things() -> dict[str, Any]:
    camera = loom.PinholeCameraIntrinsic(16, 12, 15.0, 15.0, 7.5, 5.5)
    return {"loom": loom, "view": loom.View(camera, np.eye(4))}


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument):
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}
    faults = faults_of(lambda **given: eval(function, dict(things()))(**given), good, argument)
    assert not faults, "\n".join(faults)
