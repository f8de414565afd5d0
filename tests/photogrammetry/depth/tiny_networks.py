"""Depth networks with few weights, as ONNX files; their outputs can be computed exactly."""

from ast import literal_eval
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
import onnx
from onnx import TensorProto, helper, numpy_helper

FLOAT = TensorProto.FLOAT
WEIGHTS = (0.25, 0.5, 0.125)  # of red, green and blue


def nodes_of(text: str) -> list[onnx.NodeProto]:
    """Nodes `operation inputs -> output attribute=value`, separated by semicolons; "_" is an input that is left out."""
    nodes = []
    for line in text.split(";"):
        call, _, result = line.partition("->")
        (operation, *inputs), (output, *options) = call.split(), result.split()
        attributes = {name: literal_eval(value) for name, value in (option.split("=") for option in options)}
        nodes.append(helper.make_node(operation, [each.strip("_") for each in inputs], [output], **attributes))
    return nodes


def save(path: Path, nodes: list[onnx.NodeProto] | str, inputs, outputs, **constants: Any) -> Path:
    """Write these nodes to a file; inputs and outputs are given by name, type and shape."""
    nodes = nodes_of(nodes) if isinstance(nodes, str) else nodes
    values = [numpy_helper.from_array(np.asarray(value), name) for name, value in constants.items()]
    ends = [[helper.make_tensor_value_info(*each) for each in side] for side in (inputs, outputs)]
    graph = helper.make_graph(nodes, "tiny", *ends, values)
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 17)], ir_version=8)
    onnx.save(model, str(path))
    return path


def linear(
    path: Path, *, size=("h", "w"), weights=WEIGHTS, offset=0.0, squeeze=False, views=False, kind=FLOAT, name="depth"
) -> Path:
    """Gives weights . (red, green, blue) + offset for each pixel; [1, 1, h, w], or [1, h, w] squeezed.

    With views the input has five dimensions, and one view of them all.
    """
    number = np.float32 if kind == FLOAT else np.float16
    kernel = np.array(weights, number).reshape(1, 3, 1, 1)
    last = f"map; Squeeze map one -> {name}" if squeeze else name
    nodes, shape = f"Conv x kernel offset -> {last}", [1, 3, *size]
    if views:
        nodes, shape = f"Squeeze x one -> flat; Conv flat kernel offset -> {last}", [1, 1, 3, *size]
    out = [1, *size] if squeeze else [1, 1, *size]
    constants = {"kernel": kernel, "offset": np.array([offset], number), "one": np.array([1], np.int64)}
    if not (views or squeeze):
        del constants["one"]
    return save(path, nodes, [("x", kind, shape)], [(name, kind, out)], **constants)


def in_strides(path: Path, stride: int = 14) -> Path:
    """Gives the mean of each complete square block; incomplete blocks at the right and bottom are dropped."""
    nodes = "ReduceMean x -> gray axes=[1] keepdims=1;"
    nodes += f"AveragePool gray -> cells kernel_shape=[{stride},{stride}] strides=[{stride},{stride}];"
    nodes += "Resize cells _ scales -> depth mode='nearest'"
    sizes = [("x", FLOAT, [1, 3, "h", "w"])], [("depth", FLOAT, [1, 1, "rows", "columns"])]
    return save(path, nodes, *sizes, scales=np.array([1, 1, stride, stride], np.float32))


def fixed_map(path: Path, values: np.ndarray) -> Path:
    """Gives these numbers, float32 [h, w], for any image of their size."""
    nodes = "Mul x zero -> nothing; ReduceMean nothing -> plane axes=[1] keepdims=1; Add plane values -> depth"
    values = np.asarray(values, np.float32)[None, None]
    constants = {"zero": np.float32(0), "values": values}
    return save(path, nodes, [("x", FLOAT, [1, 3, "h", "w"])], [("depth", FLOAT, [1, 1, "h", "w"])], **constants)


def with_mean(path: Path, size: tuple[int, int]) -> Path:
    """Gives red + the mean red of the input, so that added borders can be detected."""
    nodes = "Conv x kernel -> red; GlobalAveragePool red -> mean; Add red mean -> predicted_depth"
    ends = [("x", FLOAT, [1, 3, *size])], [("predicted_depth", FLOAT, [1, 1, *size])]
    return save(path, nodes, *ends, kernel=np.array([1, 0, 0], np.float32).reshape(1, 3, 1, 1))


def busy(path: Path) -> Path:
    """Convolutions, attention and a norm over some thousand numbers, as in real networks."""
    rng = np.random.default_rng(5)
    shapes = {"k1": (32, 3, 14, 14), "k2": (32, 32), "k3": (1, 32, 3, 3)}
    kernels = {name: rng.normal(0, 0.2, shape).astype(np.float32) for name, shape in shapes.items()}
    sizes = {"flat": np.array([0, 32, -1], np.int64), "scales": np.array([1, 1, 14, 14], np.float32)}
    constants = kernels | sizes | {"scale": np.ones(32, np.float32)}
    nodes = "Conv x k1 -> patches strides=[14,14]; Shape patches -> shape; Reshape patches flat -> rows;"
    nodes += "Transpose rows -> tokens perm=[0,2,1]; LayerNormalization tokens scale -> normed;"
    nodes += "MatMul normed k2 -> queries; MatMul queries rows -> scores; Softmax scores -> shares axis=-1;"
    nodes += "MatMul shares normed -> mixed; Transpose mixed -> columns perm=[0,2,1]; Reshape columns shape -> planes;"
    nodes += "Add planes patches -> sum; Resize sum _ scales -> large mode='linear';"
    nodes += "Conv large k3 -> depth pads=[1,1,1,1]"
    return save(path, nodes, [("x", FLOAT, [1, 3, "h", "w"])], [("depth", FLOAT, [1, 1, "h", "w"])], **constants)


def seen_by(preset: Any, image: np.ndarray, weights: Sequence[float] = WEIGHTS) -> np.ndarray:
    """The output of `linear` for an image that is not resized, with the preset's normalization."""
    values = (image.astype(np.float64) / 255 * preset.levels - preset.mean) / preset.std
    return values @ np.array(weights)
