"""Every argument of bundles refuses what makes no sense, by an error that names it."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, read_table
from .made_maps import true_maps

CALLS = """
loom.mvs.read_depth_bundle(path="nowhere.npz", names=["a", "b"], device="cpu")
bundle.transform(transformation=pose)
bundle.fuse(to="points", voxel_size=0.5, min_confidence=0.1, max_relative=0.01, device="cpu", progress=None)
"""
TABLE = read_table(CALLS, {"bundle": "DepthBundle"})


@cache
def things() -> dict[str, Any]:
    bundle = loom.mvs.DepthBundle(true_maps(2), None, ("a", "b"), "VGGT")
    return {"loom": loom, "bundle": bundle, "pose": np.eye(4)}


@pytest.mark.parametrize(("call", "argument"), [(call, name) for call, (_, names) in TABLE.items() for name in names])
def test_a_hostile_value_is_refused_by_name(call, argument, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    function, expressions = TABLE[call]
    values = things()
    good = {name: eval(expression, dict(values)) for name, expression in expressions.items()}
    faults = faults_of(lambda **given: eval(function, dict(values))(**given), good, argument)
    assert not faults, "\n".join(faults)
