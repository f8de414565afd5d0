"""Every argument of estimating depth maps and of its types refuses what makes no sense, by an error that names it."""

from __future__ import annotations

import inspect
from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, missing_from, read_table
from .made_pictures import camera_at, intrinsic, scene

CALLS = """
loom.mvs.PosedCamera(intrinsic=lens, T_camera_world=pose)
loom.mvs.SparsePoints(points=points, observations=observations)
loom.mvs.DepthMap(depth=depth, normals=normals, confidence=depth)
loom.mvs.DepthMaps(cameras=cameras, sources=sources, maps=[one, one], folder=None)
loom.mvs.estimate_depth_maps(pictures=pictures, cameras=cameras, sparse=sparse, sources=sources, masks=None, seed=0, device="cpu", folder=None, going=None, device_bytes=1000, progress=None)
"""  # noqa: E501
TABLE = {name.removeprefix("mvs."): call for name, call in read_table(CALLS, {}).items()}


@cache
def things() -> dict[str, Any]:
    cameras = [camera_at(0.0, scale=0.5), camera_at(0.2, scale=0.5)]
    pictures, sparse = scene(cameras)
    size = pictures[0].shape
    depth, normals = np.ones(size), np.zeros((*size, 3))
    return {
        "loom": loom, "lens": intrinsic(), "pose": np.eye(4), "points": sparse.points, "sparse": sparse,
        "observations": sparse.observations, "cameras": cameras, "pictures": pictures, "sources": [[1], [0]],
        "depth": depth, "normals": normals, "one": loom.mvs.DepthMap(depth, normals, depth),
    }  # fmt: skip


def test_the_table_names_every_argument():
    calls = {name: set(inspect.signature(getattr(loom.mvs, name)).parameters) for name in TABLE}
    assert missing_from(TABLE, calls) == {}


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    eval(function, things())(**{name: eval(value, dict(things())) for name, value in expressions.items()})


CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # a string is a folder's name
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}
    faults = faults_of(eval(function, dict(things())), good, argument)
    assert not faults, "\n".join(faults)
