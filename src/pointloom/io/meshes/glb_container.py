"""The GLB container (glTF 2.0, binary): header, JSON chunk, binary chunk.

Khronos, "glTF 2.0 Specification", section 4.
"""

from __future__ import annotations

import struct

from ...core.errors import FileError, FilePath

GLB_MAGIC, JSON_CHUNK, BINARY_CHUNK = b"glTF", 0x4E4F534A, 0x004E4942


def split_chunks(path: FilePath, data: memoryview) -> tuple[memoryview, memoryview | None]:
    if data[:4] != GLB_MAGIC:
        raise FileError(path, "is not a GLB: it does not begin with glTF", where="byte 0", remedy="Is it a .gltf?")
    if len(data) < 20:
        raise FileError(path, "cut off in its header", where=f"byte {len(data)}")
    version, length = struct.unpack("<II", data[4:12])
    if version != 2:
        raise FileError(path, f"GLB version {version}; version 2 is read", where="byte 4")
    if length != len(data):
        reason = f"{len(data)} bytes, but its header declares {length}"
        raise FileError(path, reason, where="byte 8", remedy="The file may be cut off")
    chunks, at = [], 12
    while at < length:
        if at + 8 > length:
            raise FileError(path, "cut off in the head of a chunk", where=f"byte {at}")
        size, kind = struct.unpack("<II", data[at : at + 8])
        if at + 8 + size > length:
            reason = f"a chunk declares {size} bytes, but {length - at - 8} are left"
            raise FileError(path, reason, where=f"byte {at}", remedy="The file may be cut off")
        chunks.append((kind, data[at + 8 : at + 8 + size]))
        at += 8 + size
    if chunks[0][0] != JSON_CHUNK:
        raise FileError(path, "its first chunk is not JSON", where="byte 16")
    has_binary = len(chunks) > 1 and chunks[1][0] == BINARY_CHUNK
    return chunks[0][1], chunks[1][1] if has_binary else None
