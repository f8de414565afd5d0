"""Every argument of choosing sources, filtering and fusing refuses what makes no sense, by an error that names it."""

from __future__ import annotations

import inspect
from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, missing_from, read_table
from .made_maps import true_maps

CALLS = """
loom.mvs.choose_sources(cameras=cameras, sparse=sparse, count=8)
loom.mvs.filter_depth_maps(maps=maps, min_views=2, max_pixels=1.0, max_relative=0.01, min_confidence=0.0, min_support=0.25, folder=None, device="cpu", progress=None)
loom.mvs.fuse(maps=maps, pictures=None, to="points", voxel_size=0.5, min_views=2, max_pixels=2.0, max_relative=0.01, max_angle=30.0, device="cpu", progress=None)
"""  # noqa: E501
TABLE = {name.removeprefix("mvs."): call for name, call in read_table(CALLS, {}).items()}


@cache
def things() -> dict[str, Any]:
    maps = true_maps(2)
    sparse = loom.mvs.SparsePoints(np.array([[0.0, 0.0, 3.0]]), np.array([[0, 0], [1, 0]]))
    return {"loom": loom, "maps": maps, "cameras": list(maps.cameras), "sparse": sparse}


def test_the_table_names_every_argument():
    calls = {name: set(inspect.signature(getattr(loom.mvs, name)).parameters) for name in TABLE}
    assert missing_from(TABLE, calls) == {}


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    eval(function, things())(**{name: eval(value, dict(things())) for name, value in expressions.items()})


@pytest.mark.parametrize(("call", "argument"), [(call, name) for call, (_, names) in TABLE.items() for name in names])
def test_a_hostile_value_is_refused_by_name(call, argument, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # a string may be a folder
    function, expressions = TABLE[call]
    values = things()
    good = {name: eval(expression, dict(values)) for name, expression in expressions.items()}
    faults = faults_of(lambda **given: eval(function, dict(values))(**given), good, argument)
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize("to", ["points", "tsdf", "poisson"])
@pytest.mark.parametrize("scale", [1e-30, 1e-3, 1e6, 1e30])
def test_a_world_of_any_size_is_fused_or_refused(to, scale):
    maps = true_maps(2)
    cameras = []
    for camera in maps.cameras:
        T = camera.T_camera_world.copy()
        T[:3, 3] *= scale
        cameras.append(loom.mvs.PosedCamera(camera.intrinsic, T))
    resized = [loom.mvs.DepthMap(each.depth * scale, each.normals, each.confidence) for each in maps]
    try:
        made = loom.mvs.fuse(loom.mvs.DepthMaps(cameras, maps.sources, resized), None, to=to)
    except (ValueError, MemoryError) as error:
        assert scale in (1e-30, 1e30), error
    else:
        assert len(made) > (1000 if scale in (1e-3, 1e6) else 0)
