"""Tiny ONNX networks with the names, sizes, normalization and last operations of published exports.

Instead of weights they decode the picture: gray g of 0..255 is depth 1 + 9 g / 255 meters. Each network encodes this
depth as its family does, after the families' own code (src/pointloom/photogrammetry/depth/heads.py).
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper

from .tiny_networks import FLOAT, save

IMAGENET = np.array([0.485, 0.456, 0.406]), np.array([0.229, 0.224, 0.225])
HALF = np.full(3, 0.5), np.full(3, 0.5)
UNIT = np.zeros(3), np.ones(3)
BYTES = np.zeros(3), np.full(3, 1 / 255)

FOCAL = 0.9  # of the pictures: the focal length over their width
MOGE_SHIFT, MOGE_SCALE = 0.75, 1.6  # the missing depth of MoGe's points, before the scale to meters

make = helper.make_node


def picture_of(height: int = 60, width: int = 80) -> np.ndarray:
    """A picture whose gray encodes the depth of a sloping floor with a box in front."""
    v, u = np.mgrid[:height, :width]
    gray = 220 - 150 * v / height + 20 * np.sin(5 * u / width)
    box = (abs(u / width - 0.6) < 0.15) & (abs(v / height - 0.5) < 0.2)
    return np.repeat(np.where(box, 60, gray).round().astype(np.uint8)[..., None], 3, 2)


def depth_of(picture: np.ndarray) -> np.ndarray:
    return 1 + 9 * picture[..., 0].astype(np.float64) / 255


def _decode(statistics: tuple[np.ndarray, np.ndarray]) -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """Nodes that make depth z [1, 1, h, w] of an input x with this mean and deviation."""
    mean, std = statistics
    kernel = (9 * std / 3).astype(np.float32).reshape(1, 3, 1, 1)
    return [make("Conv", ["x", "kernel", "bias"], ["z"])], {
        "kernel": kernel, "bias": np.array([1 + 9 * mean.mean()], np.float32), "axis": np.array([1], np.int64),
    }  # fmt: skip


def _logit(share: str, out: str) -> list[onnx.NodeProto]:
    """log(p / (1 - p)), whose sigmoid is p."""
    return [
        make("Sub", ["one", share], [f"{out}.rest"]),
        make("Div", [share, f"{out}.rest"], [f"{out}.odds"]),
        make("Log", [f"{out}.odds"], [out]),
    ]


def _relative() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """Depth Anything V2, relative: the head's ReLU, and that of `forward`."""
    return [
        make("Reciprocal", ["z"], ["raw"]), make("Relu", ["raw"], ["once"]), make("Relu", ["once"], ["twice"]),
        make("Squeeze", ["twice", "axis"], ["out"]),
    ], {}  # fmt: skip


def _sigmoid(farthest: float) -> Callable[[], tuple[list[onnx.NodeProto], dict[str, Any]]]:
    """Depth Anything V2, metric."""

    def head() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
        nodes = [make("Div", ["z", "range"], ["p"]), *_logit("p", "l"), make("Sigmoid", ["l"], ["s"])]
        nodes += [make("Mul", ["s", "range"], ["m"]), make("Squeeze", ["m", "axis"], ["out"])]
        return nodes, {"range": np.float32(farthest), "one": np.float32(1)}

    return head


def _clipped() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """A metric network exported with the last function of the relative one: a logit below 0 gives 0."""
    nodes = [make("Div", ["z", "far"], ["p"]), *_logit("p", "l"), make("Relu", ["l"], ["s"])]
    nodes += [make("Mul", ["s", "range"], ["m"]), make("Squeeze", ["m", "axis"], ["out"])]
    return nodes, {"far": np.float32(10.5), "range": np.float32(20), "one": np.float32(1)}


def _bins() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """ZoeDepth: depths of two bins, 1 and 10 m, weighted by a softmax."""
    nodes = [make("Sub", ["z", "one"], ["above"]), make("Div", ["above", "nine"], ["share"])]
    nodes += [make("Clip", ["share", "low", "high"], ["p"]), *_logit("p", "l"), make("Mul", ["l", "zero"], ["o"])]
    nodes += [make("Concat", ["o", "l"], ["logits"], axis=1), make("Softmax", ["logits"], ["shares"], axis=1)]
    nodes += [make("Mul", ["shares", "centers"], ["parts"]), make("ReduceSum", ["parts", "axis"], ["m"], keepdims=1)]
    nodes += [make("Squeeze", ["m", "axis"], ["out"])]
    constants = {
        name: np.float32(v) for name, v in {"one": 1, "nine": 9, "zero": 0, "low": 1e-4, "high": 0.9999}.items()
    }
    return nodes, {**constants, "centers": np.array([1, 10], np.float32).reshape(1, 2, 1, 1)}


def _clamped() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """Metric3D: max - ReLU(max - (ReLU(x - min) + min)), in one dimension more than the others."""
    nodes = [make("Sub", ["z", "least"], ["a"]), make("Relu", ["a"], ["b"]), make("Add", ["b", "least"], ["c"])]
    nodes += [make("Sub", ["most", "c"], ["d"]), make("Relu", ["d"], ["e"]), make("Sub", ["most", "e"], ["out"])]
    return nodes, {"least": np.float32(0.1), "most": np.float32(200)}


def _exponential() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """Depth Anything 3."""
    return [make("Log", ["z"], ["l"]), make("Exp", ["l"], ["e"]), make("Squeeze", ["e", "axis"], ["out"])], {}


def _canonical() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """Depth Pro's forward pass: c = (f / w) / z, and the field of view [degrees]."""
    nodes = [make("Div", ["focal", "z"], ["raw"]), make("Relu", ["raw"], ["out"])]
    view = 2 * np.degrees(np.arctan(0.5 / FOCAL))
    nodes += [make("ReduceMean", ["z"], ["mean"], keepdims=1), make("Mul", ["mean", "zero"], ["nothing"])]
    nodes += [make("Add", ["nothing", "view"], ["fov_deg"])]
    return nodes, {"focal": np.float32(FOCAL), "zero": np.float32(0), "view": np.float32(view)}


def _meters() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """Depth Pro's `infer` at its own size: meters by the estimated focal length [px of 1536]."""
    nodes = [make("Div", ["focal", "z"], ["raw"]), make("Relu", ["raw"], ["c"]), make("ReduceMean", ["z"], ["mean"])]
    nodes += [make("Mul", ["mean", "zero"], ["nothing"]), make("Add", ["nothing", "pixels"], ["focallength_px"])]
    nodes += [make("Div", ["width", "focallength_px"], ["w_f"]), make("Mul", ["c", "w_f"], ["inverse"])]
    nodes += [make("Clip", ["inverse", "low", "high"], ["kept"]), make("Reciprocal", ["kept"], ["depth"])]
    nodes += [make("Squeeze", ["depth", "axis"], ["out"])]
    constants = {"focal": FOCAL, "zero": 0, "pixels": FOCAL * 1536, "width": 1536, "low": 1e-4, "high": 1e4}
    return nodes, {name: np.float32(value) for name, value in constants.items()}


def _rays() -> list[onnx.NodeProto]:
    """Nodes that give x and y of the points at depth z, for a camera of FOCAL at any size."""
    nodes = [make("Mul", ["z", "zero"], ["nothing"]), make("Add", ["nothing", "one"], ["ones"])]
    nodes += [make("CumSum", ["ones", "three"], ["u"]), make("CumSum", ["ones", "two"], ["v"])]
    nodes += [make("ReduceMax", ["u"], ["w"], keepdims=1), make("Mul", ["w", "focal"], ["f"])]
    for axis in "uv":
        nodes += [
            make("ReduceMean", [axis], [f"{axis}.mid"], keepdims=1),
            make("Sub", [axis, f"{axis}.mid"], [f"{axis}0"]),
        ]
        nodes += [make("Mul", [f"{axis}0", "z"], [f"{axis}z"]), make("Div", [f"{axis}z", "f"], [f"{axis}p"])]
    return nodes


_RAYS = {"zero": np.float32(0), "one": np.float32(1), "focal": np.float32(FOCAL)}
_RAYS |= {"two": np.int64(2), "three": np.int64(3)}


def _points() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """MoGe-2: points without their shift and scale, a mask that excludes white pixels, the scale."""
    nodes = [*_rays(), make("Sub", ["z", "shift"], ["zs"]), make("Concat", ["up", "vp", "zs"], ["all"], axis=1)]
    nodes += [make("Div", ["all", "size"], ["small"]), make("Transpose", ["small"], ["out"], perm=[0, 2, 3, 1])]
    nodes += [make("Sub", ["white", "z"], ["dark"]), make("Mul", ["dark", "hundred"], ["sure"])]
    nodes += [make("Sigmoid", ["sure"], ["m"]), make("Squeeze", ["m", "axis"], ["mask"])]
    nodes += [make("ReduceMax", ["nothing"], ["n"], keepdims=0), make("Add", ["n", "sizes"], ["metric_scale"])]
    constants = {"shift": MOGE_SHIFT, "size": MOGE_SCALE, "white": 9.8, "hundred": 100}
    values: dict[str, Any] = {name: np.float32(value) for name, value in constants.items()}
    return nodes, {**_RAYS, **values, "sizes": np.array([MOGE_SCALE], np.float32)}


def _with_camera() -> tuple[list[onnx.NodeProto], dict[str, Any]]:
    """UniDepth V2: points, and the camera matrix of the input with pixel centers at half-integers."""
    nodes = [*_rays(), make("Concat", ["up", "vp", "z"], ["out"], axis=1)]
    nodes += [
        make("ReduceMax", ["v"], ["h"], keepdims=1),
        make("Mul", ["w", "half"], ["cx"]),
        make("Mul", ["h", "half"], ["cy"]),
    ]
    nodes += [make("Mul", ["w", "zero"], ["o"]), make("Add", ["o", "one"], ["i"])]
    nodes += [make("Concat", ["f", "o", "cx", "o", "f", "cy", "o", "o", "i"], ["row"], axis=3)]
    nodes += [make("Reshape", ["row", "matrix"], ["intrinsics"])]
    return nodes, {**_RAYS, "half": np.float32(0.5), "matrix": np.array([1, 3, 3], np.int64)}


OPEN = ("h", "w")
PAIR = ("predicted_depth", "focallength_px")
# By name: the preset, mean and deviation, size, head, names of the input and of the outputs.
FILES: dict[str, tuple[str, Any, tuple[Any, Any], Any, str, tuple[str, ...]]] = {
    "dav2": ("depth-anything-v2", IMAGENET, OPEN, _relative, "pixel_values", ("predicted_depth",)),
    "dav2 indoor": ("depth-anything-v2-metric", IMAGENET, OPEN, _sigmoid(20), "pixel_values", ("predicted_depth",)),
    "dav2 outdoor": ("depth-anything-v2-metric", IMAGENET, (518, 518), _sigmoid(80), "image", ("depth",)),
    "dpt": ("dpt", HALF, OPEN, _relative, "pixel_values", ("predicted_depth",)),
    "midas": ("midas-v2.1-onnx", UNIT, (384, 384), _relative, "0", ("797",)),
    "zoedepth": ("zoedepth", HALF, OPEN, _bins, "pixel_values", ("predicted_depth",)),
    "zoedepth fixed": ("zoedepth", HALF, (384, 512), _bins, "pixel_values", ("predicted_depth",)),
    "depth pro": ("depth-pro", HALF, (1536, 1536), _canonical, "image", ("canonical_inverse_depth", "fov_deg")),
    "depth pro meters": ("depth-pro", HALF, (1536, 1536), _meters, "pixel_values", PAIR),
    "moge-2": ("moge-2", UNIT, OPEN, _points, "image", ("points", "mask", "metric_scale")),
    "unidepth": ("unidepth-v2", IMAGENET, (462, 616), _with_camera, "rgbs", ("pts_3d", "intrinsics")),
    "metric3d": ("metric3d-v2", BYTES, (616, 1064), _clamped, "image", ("pred_depth",)),
    "metric3d portrait": ("metric3d-v2", BYTES, (1064, 616), _clamped, "pixel_values", ("predicted_depth",)),
    "metric3d convnext": ("metric3d-convnext", BYTES, (544, 1216), _clamped, "image", ("pred_depth",)),
    "da3": ("depth-anything-3", IMAGENET, OPEN, _exponential, "pixel_values", ("predicted_depth",)),
    "dav2 broken": ("depth-anything-v2-metric", IMAGENET, OPEN, _clipped, "image", ("depth",)),
}  # fmt: skip


def published(path: Path, name: str) -> Path:
    _, statistics, size, head, source, outputs = FILES[name]
    nodes, constants = _decode(statistics)
    last, more = head()
    nodes = [make("Identity", [source], ["x"]), *nodes, *last, make("Identity", ["out"], [outputs[0]])]
    inputs = [(source, FLOAT, [1, 3, *size])]
    if name == "moge-2":
        inputs.append(("num_tokens", TensorProto.INT64, []))
        nodes.append(make("Cast", ["num_tokens"], ["tokens"], to=FLOAT))
    used = {value for node in nodes for value in node.input}
    constants = {key: value for key, value in {**constants, **more}.items() if key in used}
    return save(path, nodes, inputs, [(output, FLOAT, None) for output in outputs], **constants)
