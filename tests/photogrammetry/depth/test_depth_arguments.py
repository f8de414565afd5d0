"""Every public call on depth networks rejects invalid arguments by name."""

from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.depth.settings import DepthSettings

from ...hostile import faults_of, missing_from, public_arguments, read_table
from .tiny_networks import linear

CALLS = """
loom.DepthModel(path=path, preset="depth-anything-v2", device="cpu", threads=1)
model().run(picture=picture)
loom.estimate_depth(picture=picture, model=path, preset="depth-anything-v2", intrinsic=camera, align=depth, depth_scale=1000.0, tiles=1, seed=0, device="cpu", progress=None)
estimate().to_point_cloud(stride=1, device="cpu")
"""  # noqa: E501
TABLE = read_table(CALLS, {"model()": "DepthModel", "estimate()": "DepthEstimate"})
PICTURE = np.random.default_rng(0).integers(0, 256, (28, 42, 3), dtype=np.uint8)
CAMERA = loom.PinholeCameraIntrinsic(42, 28, 40.0, 40.0, 20.5, 13.5)
NAMES = {"DepthModel", "estimate_depth"}


@pytest.fixture(scope="module")
def things(tmp_path_factory) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("model")
    path = linear(folder / "m.onnx", size=(28, 42))
    Image.fromarray(PICTURE).save(folder / "photo.png")
    model = loom.DepthModel(path)
    depth = 1 / (model.run(PICTURE).astype(float) + 3)
    estimate = loom.estimate_depth(PICTURE, model)

    return {
        "loom": loom, "path": path, "picture": PICTURE, "camera": CAMERA, "depth": depth,
        "model": lambda: model, "estimate": lambda: estimate, "photo": folder / "photo.png",
        "settings": DepthSettings(), "place": lambda kind: folder / f"out.{kind}",
    }  # fmt: skip


@cache
def arguments() -> dict[str, set[str]]:
    public = SimpleNamespace(__all__=sorted(NAMES), **{name: getattr(loom, name) for name in NAMES})
    result: dict[str, set[str]] = public_arguments(public, set())  # type: ignore[arg-type]
    return result


def test_the_table_names_every_argument_of_every_public_call():
    assert missing_from(TABLE, arguments()) == {}


def run(call: str, things: dict[str, Any], given: dict[str, Any]) -> Any:
    """Call a function of the table; outputs of earlier calls are replaced."""
    again = {"overwrite": True} if call == "depth_of_pictures" else {}
    return eval(TABLE[call][0], dict(things))(**given, **again)


@pytest.mark.parametrize("call", TABLE)
def test_the_good_arguments_are_taken(call, things):
    run(call, things, {name: eval(value, dict(things)) for name, value in TABLE[call][1].items()})


CASES = [(call, name) for call, (_, names) in TABLE.items() for name in names]


@pytest.mark.parametrize(("call", "argument"), CASES)
def test_a_hostile_value_is_refused_by_name(call, argument, things):
    good = {name: eval(expression, dict(things)) for name, expression in TABLE[call][1].items()}
    faults = faults_of(lambda **given: run(call, things, given), good, argument)
    assert not faults, "\n".join(faults)
