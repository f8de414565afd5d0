"""Arrays of a glTF file: buffers, views and accessors (dense, sparse, compressed), checked against available bytes.

Khronos, "glTF 2.0 Specification", section 3.6.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .gltf_compression import MESHOPT, decode_view
from .gltf_file import GltfFile

COMPONENT_TYPES = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_TYPE_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4, "MAT4": 16}


class GltfArrays:
    """The arrays of a file, with a cache."""

    def __init__(self, file: GltfFile):
        self.file = file
        self._buffers: dict[int, memoryview] = {}
        self._decoded: dict[int, tuple[memoryview, int]] = {}

    def view(self, number: Any, what: str) -> tuple[memoryview, int]:
        """The bytes of a buffer view, and its stride. 0 if packed."""
        file = self.file
        view, name = file.take("bufferViews", number, what), f"bufferViews {number}"
        packed = next(
            (extension for key in MESHOPT if (extension := file.extension(view, key, name)) is not None), None
        )
        if packed is not None:
            if number not in self._decoded:
                self._decoded[number] = decode_view(file, packed, self._slice(packed, name), name)
            return self._decoded[number]
        return self._slice(view, name), file.integer(view, "byteStride", name, 0)

    def _slice(self, view: dict[str, Any], name: str) -> memoryview:
        file = self.file
        buffer = self._buffer(view.get("buffer"), name)
        begin, size = file.integer(view, "byteOffset", name, 0), file.integer(view, "byteLength", name)
        if begin + size > len(buffer):
            raise file.error(f"{name} reaches to byte {begin + size} of a buffer of {len(buffer)}")
        return buffer[begin : begin + size]

    def _buffer(self, number: Any, what: str) -> memoryview:
        file = self.file
        buffer = file.take("buffers", number, what)
        if number not in self._buffers:
            name = f"buffers {number}"
            size = file.integer(buffer, "byteLength", name)
            content = file.binary if "uri" not in buffer else file.uri_bytes(buffer["uri"], name)
            if content is None or (number != 0 and "uri" not in buffer):
                raise file.error(f"{name} has no bytes")
            if size > len(content):
                raise file.error(f"{name} declares {size} bytes, but has {len(content)}", remedy="It may be cut off")
            self._buffers[number] = content[:size]
        return self._buffers[number]

    def accessor(
        self, number: Any, what: str, types: tuple[str, ...], components: str, given: NDArray[Any] | None = None
    ) -> NDArray[Any]:
        """The elements of an accessor, shape (n, width), in their type; normalized integers as float32.
        `components` are allowed NumPy codes separated by blanks, "n" before an integer code requires normalized ones;
        `given` are elements decoded from a compressed mesh."""
        file = self.file
        accessor = file.take("accessors", number, what)
        name = f"accessors {number} ({what})"
        kind, component = accessor.get("type"), file.integer(accessor, "componentType", name)
        code = COMPONENT_TYPES.get(component, "")
        is_normalized = accessor.get("normalized", False) is True
        if kind not in types or not code or f"{'n' * is_normalized}{code[1:]}" not in components.split():
            raise file.error(f"{name} is of the type {str(kind)[:20]} {component}, which is not supported there")
        count, dtype, width = file.integer(accessor, "count", name), np.dtype(code), _TYPE_WIDTHS[kind]
        if given is not None:
            values = self._as_declared(given, count, dtype, width, name)
        elif "sparse" in accessor and "bufferView" not in accessor:
            file.check_count(count, f"the elements of {name}")
            values = np.zeros((count, width), dtype.newbyteorder("="))
        else:
            values = self._elements(accessor, dtype, width, count, name)
        if "sparse" in accessor:
            self._replace_some(file.part(accessor, "sparse", name), values, dtype, name)
        if not is_normalized:
            return values
        return np.maximum(values.astype(np.float32) / np.float32(np.iinfo(dtype).max), np.float32(-1))

    def _elements(
        self, holder: dict[str, Any], dtype: np.dtype[Any], width: int, count: int, name: str, *, steps: bool = True
    ) -> NDArray[Any]:
        file = self.file
        data, stride = self.view(holder.get("bufferView"), name)
        begin, size = file.integer(holder, "byteOffset", name, 0), width * dtype.itemsize
        step = stride if stride and steps else size
        if step < size:
            raise file.error(f"{name} has elements of {size} bytes every {step}")
        if count < 1 or begin + step * (count - 1) + size > len(data):
            raise file.error(f"{name} declares {count} elements, beyond the {len(data)} bytes of its buffer view")
        return np.ndarray((count, width), dtype, data, begin, (step, dtype.itemsize)).astype(dtype.newbyteorder("="))

    def _replace_some(self, sparse: dict[str, Any], values: NDArray[Any], dtype: np.dtype[Any], name: str) -> None:
        file, what = self.file, f"{name}: sparse"
        count = file.integer(sparse, "count", what)
        if not 0 < count <= len(values):
            raise file.error(f"{what} replaces {count} of {len(values)} elements")
        indices, fresh = file.part(sparse, "indices", what), file.part(sparse, "values", what)
        code = COMPONENT_TYPES.get(file.integer(indices, "componentType", what), "")
        if code not in ("<u1", "<u2", "<u4"):
            raise file.error(f"{what} has indices that are not unsigned integers")
        rows = self._elements(indices, np.dtype(code), 1, count, what, steps=False)[:, 0].astype(np.int64)
        if rows[-1] >= len(values) or (np.diff(rows) <= 0).any():
            raise file.error(f"{what} has indices that do not increase, or exceed {len(values)} elements")
        values[rows] = self._elements(fresh, dtype, values.shape[1], count, what, steps=False)

    def _as_declared(
        self, given: NDArray[Any], count: int, dtype: np.dtype[Any], width: int, name: str
    ) -> NDArray[Any]:
        if given.shape != (count, width):
            raise self.file.error(
                f"{name} declares {count} x {width}, but its compressed mesh contains {list(given.shape)}"
            )
        if given.dtype == dtype:
            return given.copy()
        cast = given.astype(dtype) if given.dtype.kind in "iu" and dtype.kind in "iu" else None
        if cast is None or (cast != given).any():
            raise self.file.error(f"{name} declares {dtype}, but its compressed mesh contains {given.dtype}")
        return cast
