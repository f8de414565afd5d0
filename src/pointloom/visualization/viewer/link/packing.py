"""Encoding of batches of operations for pages: `pack`.

A message is `u32 LE H | H bytes of JSON | arrays` (docs/viewer-protocol.md). Arrays are passed in slices without a
copy.
"""

from __future__ import annotations

import json
import logging
import struct
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

ALIGNMENT_BYTES = 8
MAX_FRAME_BYTES = 1 << 20  # maximum in the server's buffers for a page that does not read

log = logging.getLogger("pointloom.viewer")
Op = dict[str, Any]


def pack(ops: list[Op]) -> Iterator[memoryview]:
    """Yield the bytes of a message with these operations, at most `MAX_FRAME_BYTES` each.

    1D arrays become rows of one number.
    """
    arrays: list[NDArray[Any]] = []
    texts = [text for op in ops if (text := _write(op, arrays))]
    described = [[kind_of(values), len(values), _width(values)] for values in arrays]
    # Offsets are part of the JSON and change its length, so they start at a safe upper bound.
    size = sum(map(len, texts)) + len(texts) + 64 * len(arrays) + 64
    start = _up(4 + size)
    for entry, values in zip(described, arrays, strict=True):
        entry.append(start)
        start = _up(start + values.nbytes)
    first = described[0][3] if described else 0
    text = '{"do":[' + ",".join(texts) + '],"arrays":' + json.dumps(described, separators=(",", ":")) + "}"
    header = text.encode("ascii")
    header = header.ljust((first or _up(4 + len(header))) - 4)
    yield from _slices(memoryview(struct.pack("<I", len(header)) + header))
    for values in arrays:
        if values.nbytes:
            yield from _slices(values.reshape(-1).view(np.uint8).data)
        if gap := -values.nbytes % ALIGNMENT_BYTES:
            yield memoryview(bytes(gap))


def kind_of(values: NDArray[Any]) -> str:
    return f"{values.dtype.kind}{values.dtype.itemsize}"


def bytes_of(op: Op) -> int:
    """Approximate size of an operation with its arrays."""
    return 256 + sum(value.nbytes if isinstance(value, np.ndarray) else 0 for value in op.values())


def _write(op: Op, arrays: list[NDArray[Any]]) -> str:
    """JSON of an operation with its arrays by number; "" if it cannot be encoded."""
    count = len(arrays)
    fields: Op = {}
    for name, value in op.items():
        if isinstance(value, np.ndarray):
            fields[name] = len(arrays)
            arrays.append(np.ascontiguousarray(value))
        else:
            fields[name] = value
    try:
        return json.dumps(fields, allow_nan=False, separators=(",", ":"), default=_plain)
    except (TypeError, ValueError):
        log.exception("an operation of the viewer could not be sent")
        del arrays[count:]
        return ""


def _plain(value: object) -> Any:
    if isinstance(value, np.generic):
        return value.item()
    raise TypeError(f"{type(value).__name__} cannot be written as JSON")


def _width(values: NDArray[Any]) -> int:
    return int(np.prod(values.shape[1:], dtype=np.int64))


def _up(offset: int) -> int:
    return -(-offset // ALIGNMENT_BYTES) * ALIGNMENT_BYTES


def _slices(data: memoryview) -> Iterator[memoryview]:
    for start in range(0, len(data), MAX_FRAME_BYTES):
        yield data[start : start + MAX_FRAME_BYTES]
