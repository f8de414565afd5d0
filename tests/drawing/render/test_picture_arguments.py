"""Every argument of every public call of pictures refuses what makes no sense, by an error that names it."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import faults_of, missing_from, public_arguments, read_table

CALLS = """
loom.render(geometries=cloud, camera=view, size=(16, 12), point_size=2.0, background=(1, 1, 1), shading="flat", labels=[("a", [0, 0, 0])], legend=[("a", (1, 0, 0))], color_bar=None, scale_bar=True, up="y", device="cpu")
loom.View(intrinsic=camera, T_world_camera=pose)
loom.View.from_open3d(bounds=bounds, zoom=0.7, front=[0, 0, 1.0], lookat=[0, 0, 0.0], up=[0, 1.0, 0], field_of_view=60.0, width=16, height=12)
view.to_open3d(bounds=bounds)
loom.fit_view(points=points, direction=(0, 1, 0), up=(0, 0, 1), width=16, height=12)
loom.read_view(path="view.json", width=16, height=12)
loom.write_view(path="view.json", view=view, bounds=bounds)
loom.plots.histogram(values=[0.0, 1.0], title="a", labels=("a", "b"), bins=5, limits=(0.0, 1.0), colormap="jet", color_limits=(0.0, 1.0), marks=[("m", 0.5)], size=(320, 240), device="cpu")
loom.plots.curves(series={"a": [0.0, 1.0]}, x=[0.0, 1.0], title="a", labels=("a", "b"), limits=(0.0, 1.0), size=(320, 240), device="cpu")
loom.save_picture(path="picture.png", image=picture)
loom.CameraFrustum(intrinsic=camera, T_world_camera=pose, scale=0.2, color=(1, 0, 0))
"""  # noqa: E501
TABLE = read_table(CALLS, {"view": "View"})
CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


def test_the_table_names_every_argument_of_every_public_call():
    known = {"render", "save_picture", "View", "fit_view", "read_view", "write_view", "CameraFrustum"}
    assert missing_from(TABLE, public_arguments(loom, set(loom.__all__) - known)) == {}


@cache
def things() -> dict[str, Any]:
    bounds = ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0])
    return {
        "loom": loom,
        "cloud": loom.PointCloud(np.random.default_rng(0).random((50, 3))),
        "points": np.random.default_rng(0).random((50, 3)),
        "camera": loom.PinholeCameraIntrinsic(16, 12, 15.0, 15.0, 7.5, 5.5),
        "view": loom.View.from_open3d(bounds, width=16, height=12),
        "bounds": bounds,
        "pose": np.eye(4),
        "picture": np.zeros((12, 16, 3), np.uint8),
    }


@pytest.fixture
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    loom.write_view("view.json", things()["view"], things()["bounds"])


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call):
    function, expressions = TABLE[call]
    eval(function, dict(things()))(**{name: eval(value, dict(things())) for name, value in expressions.items()})


@pytest.mark.usefixtures("folder")
@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument):
    function, expressions = TABLE[call]
    good = {name: eval(expression, dict(things())) for name, expression in expressions.items()}
    also = {"geometries": "points", "bounds": "zoom"}.get(argument, "")
    faults = faults_of(lambda **given: eval(function, dict(things()))(**given), good, argument, also=also)
    assert not faults, "\n".join(faults)
