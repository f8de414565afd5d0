"""Every public call on depth networks rejects invalid arguments by name."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import pointloom as loom

from ...hostile import missing_from, public_arguments, read_table
from ..argument_tests import argument_tests
from .tiny_networks import linear

CALLS = """
loom.photogrammetry.DepthModel(path=path, preset="depth-anything-v2", device="cpu", threads=1)
model().run(image=image)
loom.photogrammetry.estimate_depth(image=image, model=path, intrinsic=camera, align=depth, depth_scale=1000.0, tiles=1, seed=0, progress=None)
estimate().to_point_cloud(stride=1, device="cpu")
"""  # noqa: E501
TABLE = read_table(CALLS, {"model()": "DepthModel", "estimate()": "DepthEstimate"})
IMAGE = np.random.default_rng(0).integers(0, 256, (28, 42, 3), dtype=np.uint8)
CAMERA = loom.PinholeCameraIntrinsic(42, 28, 40.0, 40.0, 20.5, 13.5)
NAMES = {"DepthModel", "estimate_depth"}


@pytest.fixture(scope="module")
def things(tmp_path_factory) -> dict[str, Any]:
    folder = tmp_path_factory.mktemp("model")
    path = linear(folder / "m.onnx", size=(28, 42))
    model = loom.photogrammetry.DepthModel(path)
    depth = 1 / (model.run(IMAGE).astype(float) + 3)
    estimate = loom.photogrammetry.estimate_depth(IMAGE, model)
    return {
        "loom": loom, "path": path, "image": IMAGE, "camera": CAMERA, "depth": depth,
        "model": lambda: model, "estimate": lambda: estimate,
    }  # fmt: skip


def test_the_table_names_every_argument_of_every_public_call():
    public = SimpleNamespace(__all__=sorted(NAMES), **{name: getattr(loom.photogrammetry, name) for name in NAMES})
    assert missing_from(TABLE, public_arguments(public, set())) == {}  # type: ignore[arg-type]


test_good_arguments_are_accepted, test_hostile_values_are_rejected_by_name = argument_tests(TABLE)
