"""Reduced ONNX graph: nodes, scalar constants, functions."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from ...core.errors import FileError
from ...core.paths import plain_name
from ...io.optional_imports import foreign_errors, import_for

NUMBER_TYPES = ("FLOAT", "FLOAT16", "DOUBLE", "INT32", "INT64")
NO_MODEL = "not a usable ONNX model"
WEIGHTS_REMEDY = "Put its weight file (often NAME.onnx_data) into the same folder, under its original name"


@dataclasses.dataclass(frozen=True)
class Node:
    """An operation of a `domain` (empty: ONNX) with its scalar or text attributes. Omitted inputs are empty names."""

    operation: str
    domain: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    attributes: dict[str, float | str]


@dataclasses.dataclass(frozen=True)
class Graph:
    """Nodes by the name of their outputs, scalar constants, and functions by domain and name."""

    producers: dict[str, Node]
    constants: dict[str, float]
    inputs: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    functions: dict[tuple[str, str], Graph] = dataclasses.field(default_factory=dict)


def load_graph(path: str) -> Graph:
    """Read a model's graph without external files. FileError if invalid or if onnx is missing."""
    onnx = import_for(path, "onnx", "depth")
    with foreign_errors(path, NO_MODEL, remedy="Download or export the file again"):
        model = onnx.load(path, format="protobuf", load_external_data=False)
        for name in _external_files(model):
            _check_external_file(Path(path), name)
        return read_graph(model)


def read_graph(model: Any) -> Graph:
    functions = {
        (each.domain, each.name): _graph(each.node, {}, tuple(each.input), tuple(each.output))
        for each in model.functions
    }
    constants = {each.name: number for each in model.graph.initializer if (number := _number(each)) is not None}
    return dataclasses.replace(_graph(model.graph.node, constants), functions=functions)


def _graph(nodes: Any, constants: dict[str, float], inputs: tuple[str, ...] = (), outputs: tuple[str, ...] = ()):
    producers = {}
    for each in nodes:
        attributes = {a.name: value for a in each.attribute if (value := _value(a)) is not None}
        node = Node(each.op_type, each.domain, tuple(each.input), tuple(each.output), attributes)
        producers |= {output: node for output in node.outputs if output}
        given = next((attributes[name] for name in ("value", "value_float", "value_int") if name in attributes), None)
        if node.operation == "Constant" and len(node.outputs) == 1 and isinstance(given, float):
            constants[node.outputs[0]] = given
    return Graph(producers, constants, inputs, outputs)


def _value(attribute: Any) -> float | str | None:
    if attribute.HasField("t"):
        return _number(attribute.t)
    if attribute.HasField("s"):
        return attribute.s.decode("utf-8", "replace")
    for field in ("i", "f"):
        if attribute.HasField(field):
            return float(getattr(attribute, field))
    return None


def _number(tensor: Any) -> float | None:
    """Scalar tensor, or None (also if stored in another file)."""
    from onnx import TensorProto, numpy_helper

    types = [TensorProto.DataType.Value(name) for name in NUMBER_TYPES]
    is_external = tensor.data_location == TensorProto.EXTERNAL
    if is_external or tensor.data_type not in types or math.prod(tensor.dims) != 1:
        return None
    try:
        return float(numpy_helper.to_array(tensor).item())
    except ValueError:  # the data length contradicts the shape
        return None


def _external_files(model: Any) -> Iterator[str]:
    from onnx import TensorProto

    waiting = [model]
    while waiting:
        message = waiting.pop()
        if isinstance(message, TensorProto):
            yield from (entry.value for entry in message.external_data if entry.key == "location")
            continue
        for field, value in message.ListFields():
            if field.message_type is not None:
                waiting.extend([value] if hasattr(value, "ListFields") else value)


def _check_external_file(path: Path, name: str) -> None:
    """Check that a weight file is in the model's folder (or that of a link's target)."""
    file = path.parent / plain_name(path, name, remedy="Export the model with its weights in the same folder")
    if not file.is_file():
        raise FileError(path, f"its weights are in {name}, which does not exist", remedy=WEIGHTS_REMEDY)
    if file.resolve().parent not in (path.parent.resolve(), path.resolve().parent):
        reason = f"its weights are in {name}, a symbolic link to another folder"
        raise FileError(path, reason, remedy="Replace the link with the file")
