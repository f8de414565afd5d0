"""Every argument of the tree of detail refuses what makes no sense, by an error that names it."""

from __future__ import annotations

import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import calls_of_clouds, faults_of, faults_of_clouds, missing_from, public_arguments, read_table

CALLS = """
loom.DetailTree.from_cloud(cloud=cloud)
loom.DetailTree.from_file(path=scan, attributes=["label"], device="cpu", progress=None)
tree.are_refined(nodes=[0])
tree.colors_of(indices=[0, 1])
tree.indices_of(i=0)
tree.node(i=0)
tree.pixels(view=view, lengths=tree.spacings)
tree.points_of(i=0)
tree.select(view=view, budget=100, counts=tree.counts, finest=0.5)
tree.shares_in_view(view=view, nodes=[0])
loom.sample_file(path=scan, count=10)
"""
TABLE = read_table(CALLS, {"tree": "DetailTree"})
CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@cache
def things() -> dict[str, Any]:
    """What the expressions of the table name."""
    rng = np.random.default_rng(0)
    points = rng.random((60, 3))
    cloud = loom.PointCloud(points, colors=rng.random((60, 3)), label=np.arange(60, dtype=np.int32))
    scan = Path(tempfile.mkdtemp()) / "scan.ply"
    loom.write_point_cloud(scan, cloud)
    tree = loom.DetailTree.from_cloud(cloud)
    return {"loom": loom, "cloud": cloud, "scan": str(scan), "tree": tree, "view": loom.fit_view(points)}


def test_the_table_names_every_argument_of_every_public_call():
    known = {"DetailTree", "sample_file"}
    assert missing_from(TABLE, public_arguments(loom, set(loom.__all__) - known)) == {}


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    eval(function, dict(things()))(**{name: eval(value, dict(things())) for name, value in expressions.items()})


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}
    faults = faults_of(
        lambda **given: eval(function, dict(things()))(**given), good, argument, clouds=argument == "cloud"
    )
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("call", calls_of_clouds(TABLE, ("cloud", "other")))
def test_a_hostile_cloud_is_answered_without_a_warning(call):
    faults = faults_of_clouds(TABLE[call], ("cloud", "other"), things())
    assert not faults, "\n".join(faults)
