"""The graph of an ONNX file, as far as its last operations need it: nodes, constants of one number, functions.

onnxruntime runs a model and does not hand out its graph, and the `onnx` package is no dependency, so the file is read
here by the wire format of Protocol Buffers (a field's number and kind, then its bytes) with the numbers of onnx.proto3
(onnx/onnx, IR version 3 to 12). Weights are passed over where they lie in the mapped file: what is read is some MB at
most, whatever the file's size. Nothing is decoded but what stands below; other fields may hold anything.
"""

from __future__ import annotations

import dataclasses
import math
import struct
from collections.abc import Iterator
from typing import Any

import numpy as np

from ...files.source import Source

# Kinds of fields on the wire.
VARINT, FIXED64, BYTES, FIXED32 = 0, 1, 2, 5
MOST_VARINT = 10  # bytes of 64 bits, seven each

# Fields of each message, by onnx.proto3.
MODEL_GRAPH, MODEL_FUNCTIONS = 7, 25
GRAPH_NODE, GRAPH_INITIALIZER = 1, 5
FUNCTION_NAME, FUNCTION_INPUT, FUNCTION_OUTPUT, FUNCTION_NODE, FUNCTION_DOMAIN = 1, 4, 5, 7, 10
NODE_INPUT, NODE_OUTPUT, NODE_OPERATION, NODE_ATTRIBUTE, NODE_DOMAIN = 1, 2, 4, 5, 7
ATTRIBUTE_NAME, ATTRIBUTE_FLOAT, ATTRIBUTE_INT, ATTRIBUTE_STRING, ATTRIBUTE_TENSOR = 1, 2, 3, 4, 5
TENSOR_DIMS, TENSOR_TYPE, TENSOR_FLOATS, TENSOR_INTS, TENSOR_LONGS = 1, 2, 4, 5, 7
TENSOR_NAME, TENSOR_RAW, TENSOR_DOUBLES = 8, 9, 10

# Types of elements whose constants are read: of raw bytes, and the field of typed ones.
RAW_TYPES = {1: "<f4", 6: "<i4", 7: "<i8", 10: "<f2", 11: "<f8"}
TYPED_FIELDS = {1: TENSOR_FLOATS, 6: TENSOR_INTS, 7: TENSOR_LONGS, 10: TENSOR_INTS, 11: TENSOR_DOUBLES}
MOST_CONSTANT_BYTES = 4096  # a message of one number with its name; longer ones are weights


class GraphError(Exception):
    """Bytes that are no ONNX model."""


@dataclasses.dataclass(frozen=True)
class Node:
    """One operation.

    Args:
        operation: Its name, such as "Conv".
        domain: Whose it is; empty for ONNX's own.
        inputs, outputs: Names of values; an input that is left out has an empty one.
        attributes: Those of one number or text.
    """

    operation: str
    domain: str
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    attributes: dict[str, float | str]


@dataclasses.dataclass(frozen=True)
class Graph:
    """Nodes by what they give.

    Args:
        producers: The node that gives a value, by the value's name.
        constants: Values that are one number, by their names.
        inputs, outputs: Names in the order of a call; of functions alone.
        functions: The model's functions by domain and name.
    """

    producers: dict[str, Node]
    constants: dict[str, float]
    inputs: tuple[str, ...] = ()
    outputs: tuple[str, ...] = ()
    functions: dict[tuple[str, str], Graph] = dataclasses.field(default_factory=dict)


def read_graph(source: Source) -> Graph:
    """The graph of a model.

    Raises:
        GraphError: The bytes are no ONNX model.
    """
    graph: tuple[int, int] | None = None
    functions: dict[tuple[str, str], Graph] = {}
    for number, value in _fields(source, 0, len(source)):
        if number == MODEL_GRAPH and isinstance(value, tuple):
            graph = value
        elif number == MODEL_FUNCTIONS and isinstance(value, tuple):
            key, function = _read_function(source, *value)
            functions[key] = function
    if graph is None:
        raise GraphError("no graph")
    nodes, constants = [], {}
    for number, value in _fields(source, *graph):
        if number == GRAPH_NODE and isinstance(value, tuple):
            nodes.append(_read_node(source, *value, constants))
        elif number == GRAPH_INITIALIZER and isinstance(value, tuple):
            name, constant = _read_tensor(source, *value)
            if constant is not None:
                constants[name] = constant
    return Graph(_by_output(nodes), constants, functions=functions)


def _by_output(nodes: list[Node]) -> dict[str, Node]:
    return {output: node for node in nodes for output in node.outputs if output}


def _read_function(source: Source, start: int, end: int) -> tuple[tuple[str, str], Graph]:
    wanted = FUNCTION_NAME, FUNCTION_DOMAIN, FUNCTION_INPUT, FUNCTION_OUTPUT
    texts: dict[int, list[str]] = {number: [] for number in wanted}
    nodes: list[Node] = []
    constants: dict[str, float] = {}
    for number, value in _fields(source, start, end):
        if number in texts:
            texts[number].append(_text(source, value))
        elif number == FUNCTION_NODE and isinstance(value, tuple):
            nodes.append(_read_node(source, *value, constants))
    key = "".join(texts[FUNCTION_DOMAIN]), "".join(texts[FUNCTION_NAME])
    ends = tuple(texts[FUNCTION_INPUT]), tuple(texts[FUNCTION_OUTPUT])
    return key, Graph(_by_output(nodes), constants, *ends)


def _read_node(source: Source, start: int, end: int, constants: dict[str, float]) -> Node:
    """A node; one that gives a constant of one number is entered there."""
    texts: dict[int, list[str]] = {number: [] for number in (NODE_INPUT, NODE_OUTPUT, NODE_OPERATION, NODE_DOMAIN)}
    attributes: dict[str, float | str] = {}
    for number, value in _fields(source, start, end):
        if number in texts:
            texts[number].append(_text(source, value))
        elif number == NODE_ATTRIBUTE and isinstance(value, tuple):
            name, found = _read_attribute(source, *value)
            if found is not None:
                attributes[name] = found
    operation, domain = "".join(texts[NODE_OPERATION]), "".join(texts[NODE_DOMAIN])
    outputs = tuple(texts[NODE_OUTPUT])
    given = next((attributes[name] for name in ("value", "value_float", "value_int") if name in attributes), None)
    if operation == "Constant" and len(outputs) == 1 and isinstance(given, float):
        constants[outputs[0]] = given
    return Node(operation, domain, tuple(texts[NODE_INPUT]), outputs, attributes)


def _read_attribute(source: Source, start: int, end: int) -> tuple[str, float | str | None]:
    name, found = "", None
    for number, value in _fields(source, start, end):
        if number == ATTRIBUTE_NAME:
            name = _text(source, value)
        elif number == ATTRIBUTE_FLOAT and isinstance(value, bytes):
            found = float(struct.unpack("<f", value)[0])
        elif number == ATTRIBUTE_INT and isinstance(value, int):
            found = float(value)
        elif number == ATTRIBUTE_STRING:
            found = _text(source, value)
        elif number == ATTRIBUTE_TENSOR and isinstance(value, tuple):
            found = _read_tensor(source, *value)[1]
    return name, found


def _read_tensor(source: Source, start: int, end: int) -> tuple[str, float | None]:
    """A tensor's name, and its number if it holds one that lies in the file."""
    if end - start > MOST_CONSTANT_BYTES:
        return "", None
    name, kind, count, found = "", 0, 1, {}
    for number, value in _fields(source, start, end):
        if number == TENSOR_NAME:
            name = _text(source, value)
        elif number == TENSOR_TYPE and isinstance(value, int):
            kind = value
        elif number == TENSOR_DIMS:
            count *= math.prod(_whole_numbers(source, value))
        elif number in (TENSOR_RAW, TENSOR_FLOATS, TENSOR_INTS, TENSOR_LONGS, TENSOR_DOUBLES):
            found[number] = value
    if count != 1 or kind not in RAW_TYPES:
        return name, None
    raw = found.get(TENSOR_RAW)
    if isinstance(raw, tuple):
        return name, _number(source[raw[0] : raw[1]], RAW_TYPES[kind])
    return name, _typed_number(source, kind, found.get(TYPED_FIELDS[kind]))


def _typed_number(source: Source, kind: int, value: Any) -> float | None:
    """The number of a field of its own type: alone, or the only one of packed ones."""
    if value is None:
        return None
    if kind in (6, 7, 10):
        numbers = _whole_numbers(source, value)
        if len(numbers) != 1:
            return None
        bits = numbers[0] - (1 << 64 if numbers[0] >= 1 << 63 else 0)
        return _number(struct.pack("<H", bits & 0xFFFF), "<f2") if kind == 10 else float(bits)
    content = source[value[0] : value[1]] if isinstance(value, tuple) else value
    return _number(content, RAW_TYPES[kind]) if isinstance(content, bytes) else None


def _number(content: bytes, kind: str) -> float | None:
    return float(np.frombuffer(content, kind)[0]) if len(content) == np.dtype(kind).itemsize else None


def _whole_numbers(source: Source, value: Any) -> list[int]:
    """One whole number, or packed ones."""
    if isinstance(value, int):
        return [value]
    numbers = []
    if isinstance(value, tuple):
        at, end = value
        while at < end:
            number, at = _varint(source, at, end)
            numbers.append(number)
    return numbers


def _text(source: Source, value: Any) -> str:
    if not isinstance(value, tuple):
        raise GraphError("a text is no text")
    return source[value[0] : value[1]].decode("utf-8", "replace")


def _fields(source: Source, at: int, end: int) -> Iterator[tuple[int, int | bytes | tuple[int, int]]]:
    """Each field of a message: its number, and a whole number, the bytes of a fixed one, or its start and end."""
    while at < end:
        tag, at = _varint(source, at, end)
        number, kind = tag >> 3, tag & 7
        if kind == VARINT:
            value, at = _varint(source, at, end)
            yield number, value
        elif kind == BYTES:
            length, at = _varint(source, at, end)
            if length > end - at:
                raise GraphError("a field is longer than what holds it")
            yield number, (at, at + length)
            at += length
        elif kind in (FIXED32, FIXED64):
            length = 4 if kind == FIXED32 else 8
            if length > end - at:
                raise GraphError("a number is cut")
            yield number, bytes(source[at : at + length])
            at += length
        else:
            raise GraphError("an unknown kind of field")


def _varint(source: Source, at: int, end: int) -> tuple[int, int]:
    """A whole number of seven bits a byte, the lowest first, and where it ends."""
    number = 0
    for k in range(min(MOST_VARINT, end - at)):
        byte = source[at + k]
        number |= (byte & 0x7F) << (7 * k)
        if byte < 0x80:
            return number, at + k + 1
    raise GraphError("a whole number without an end")
