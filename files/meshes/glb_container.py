"""The container of a GLB file (glTF 2.0, binary): its chunks, and the arrays that its JSON describes.

Everything that the file says of lengths, offsets, counts and numbers is held against what is there before it is used.
Not read are sparse accessors, buffers in other files and compression.

Source: Khronos, "glTF 2.0 Specification", sections 3.6 and 4.
"""

from __future__ import annotations

import base64
import binascii
import json
import os
import struct
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ..source import open_source

MAGIC, JSON_CHUNK, BINARY_CHUNK = b"glTF", 0x4E4F534A, 0x004E4942
COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
_WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


class GlbFile:
    """A GLB file whose container is whole.

    Attributes:
        path: The file.
        content: Its JSON.
    """

    def __init__(self, path: str | os.PathLike[str]):
        """Read it.

        Raises:
            FileError: Missing, no GLB, cut off, or lengths that contradict each other.
        """
        self.path = Path(path)
        self._source = bytes(open_source(path)[:])
        text, self._binary = self._chunks()
        try:
            content = json.loads(text.decode("utf-8"), parse_constant=_refuse_constant)
        except (ValueError, RecursionError) as error:
            raise self.error(f"its JSON is damaged: {error}"[:200]) from error
        if not isinstance(content, dict):
            raise self.error("its JSON is no object")
        self.content: dict[str, Any] = content
        version = content.get("asset", {}).get("version") if isinstance(content.get("asset"), dict) else None
        if not isinstance(version, str) or not version.startswith("2."):
            raise self.error(f"glTF {version!r}; version 2 is read")
        self._buffers: dict[int, bytes] = {}

    def error(self, reason: str, where: str = "", remedy: str = "") -> FileError:
        """The error that this file is wrong."""
        return FileError(self.path, reason, where=where, remedy=remedy)

    def _chunks(self) -> tuple[bytes, bytes | None]:
        data = self._source
        if data[:4] != MAGIC:
            raise self.error("is no GLB: it does not begin with glTF", "byte 0", "A .gltf is text; export .glb")
        if len(data) < 20:
            raise self.error("cut off in its header", f"byte {len(data)}")
        version, length = struct.unpack("<II", data[4:12])
        if version != 2:
            raise self.error(f"GLB version {version}; version 2 is read", "byte 4")
        if length != len(data):
            raise self.error(f"{len(data)} bytes, but its header says {length}", "byte 8", "The file may be cut off")
        chunks, at = [], 12
        while at < length:
            if at + 8 > length:
                raise self.error("cut off in the head of a chunk", f"byte {at}")
            size, kind = struct.unpack("<II", data[at : at + 8])
            if at + 8 + size > length:
                reason = f"a chunk says {size} bytes, {length - at - 8} are left"
                raise self.error(reason, f"byte {at}", "The file may be cut off")
            chunks.append((kind, data[at + 8 : at + 8 + size]))
            at += 8 + size
        if chunks[0][0] != JSON_CHUNK:
            raise self.error("its first chunk is not JSON", "byte 16")
        has_binary = len(chunks) > 1 and chunks[1][0] == BINARY_CHUNK
        return chunks[0][1], chunks[1][1] if has_binary else None

    # ------------------------------------------------------------------------------------------ objects

    def objects(self, kind: str) -> list[dict[str, Any]]:
        """A list of the JSON's objects, such as "meshes"; empty where there is none.

        Raises:
            FileError: Not a list of objects.
        """
        found = self.content.get(kind, [])
        if not isinstance(found, list) or not all(isinstance(entry, dict) for entry in found):
            raise self.error(f"{kind}: expected a list of objects")
        return found

    def take(self, kind: str, number: Any, what: str) -> dict[str, Any]:
        """The object of this number.

        Raises:
            FileError: It is not there; `what` says who names it.
        """
        objects = self.objects(kind)
        if not is_whole(number) or not 0 <= number < len(objects):
            raise self.error(f"{what} names {kind} {str(number)[:40]}, of {len(objects)}")
        return objects[number]

    def whole(self, holder: dict[str, Any], name: str, what: str, default: int | None = None) -> int:
        """A whole number from 0 of an object.

        Raises:
            FileError: It is something else, or missing without a default.
        """
        value = holder.get(name, default)
        if not is_whole(value) or not 0 <= value < 2**53:
            raise self.error(f"{what}: {name} is {str(value)[:40]}, expected a whole number from 0")
        return value

    def numbers(self, holder: dict[str, Any], name: str, what: str, default: list[float]) -> NDArray[np.float64]:
        """A list of finite numbers of an object, as long as the default.

        Raises:
            FileError: It is something else.
        """
        values = holder.get(name, default)
        is_list = isinstance(values, list) and len(values) == len(default)
        if not is_list or not all(isinstance(x, int | float) and abs(x) < 1e300 for x in values):
            raise self.error(f"{what}: {name} is not {len(default)} numbers")
        return np.array(values, np.float64)

    # ------------------------------------------------------------------------------------------ bytes

    def view(self, number: Any, what: str) -> tuple[bytes, int]:
        """The bytes of a buffer view, and the step between its elements; 0 where they lie side by side.

        Raises:
            FileError: Missing, beyond its buffer, or the buffer is in another file.
        """
        view = self.take("bufferViews", number, what)
        name = f"bufferViews {number}"
        buffer = self._buffer(view.get("buffer"), name)
        begin, size = self.whole(view, "byteOffset", name, 0), self.whole(view, "byteLength", name)
        if begin + size > len(buffer):
            raise self.error(f"{name} reaches to byte {begin + size} of a buffer of {len(buffer)}")
        return buffer[begin : begin + size], self.whole(view, "byteStride", name, 0)

    def _buffer(self, number: Any, what: str) -> bytes:
        buffer = self.take("buffers", number, what)
        if number not in self._buffers:
            size = self.whole(buffer, "byteLength", f"buffers {number}")
            held = self._binary if "uri" not in buffer else self.data_uri(buffer["uri"], f"buffers {number}")
            if held is None or (number != 0 and "uri" not in buffer):
                raise self.error(f"buffers {number} has no bytes")
            if size > len(held):
                raise self.error(f"buffers {number} says {size} bytes, {len(held)} are there")
            self._buffers[number] = held[:size]
        return self._buffers[number]

    def data_uri(self, uri: Any, what: str) -> bytes:
        """The bytes that a `data:` URI holds.

        Raises:
            FileError: It is none, or damaged.
        """
        if not isinstance(uri, str) or not uri.startswith("data:"):
            remedy = "Export it as one file with everything embedded"
            raise self.error(f"{what} lies in another file, {str(uri)[:60]!r}", remedy=remedy)
        head, _, body = uri.partition(",")
        try:
            if not head.endswith(";base64"):
                raise ValueError("it is not base64")
            return base64.b64decode(body, validate=True)
        except (ValueError, binascii.Error) as error:
            raise self.error(f"{what}: its data URI is damaged: {error}"[:200]) from error

    def accessor(self, number: Any, what: str, types: tuple[str, ...], components: str) -> NDArray[Any]:
        """The elements of an accessor, shape [n, width], in their own type; normalised integers as float32.

        Args:
            number: Which one.
            what: Who asks, for errors.
            types: Allowed types, such as "VEC3".
            components: Allowed component types, as NumPy codes parted by blanks; of integers, "n" before the code asks
                for normalised ones.

        Raises:
            FileError: Missing, of another type, sparse, or beyond its buffer view.
        """
        accessor = self.take("accessors", number, what)
        name = f"accessors {number} ({what})"
        if "sparse" in accessor:
            raise self.error(f"{name} is sparse, which is not read", remedy="Export without sparse accessors")
        kind, component = accessor.get("type"), self.whole(accessor, "componentType", name)
        code = COMPONENTS.get(component, "")
        is_normalized = accessor.get("normalized", False) is True
        if kind not in types or not code or f"{'n' * is_normalized}{code[1:]}" not in components.split():
            raise self.error(f"{name} is of the type {str(kind)[:20]} {component}, which is not read there")
        count = self.whole(accessor, "count", name)
        data, stride = self.view(accessor.get("bufferView"), name)
        dtype, width = np.dtype(code), _WIDTHS[kind]
        begin, size = self.whole(accessor, "byteOffset", name, 0), width * dtype.itemsize
        step = stride or size
        if step < size:
            raise self.error(f"{name} has elements of {size} bytes every {step}")
        if count < 1 or begin + step * (count - 1) + size > len(data):
            raise self.error(f"{name} says {count} elements, beyond the {len(data)} bytes of its buffer view")
        values = np.ndarray((count, width), dtype, data, begin, (step, dtype.itemsize)).astype(dtype.newbyteorder("="))
        if not is_normalized:
            return values
        return np.maximum(values.astype(np.float32) / np.float32(np.iinfo(dtype).max), np.float32(-1))


def is_whole(value: Any) -> bool:
    """Whether a value of the JSON is a whole number."""
    return isinstance(value, int) and not isinstance(value, bool)


def _refuse_constant(name: str) -> None:
    raise ValueError(f"{name} is no number of JSON")
