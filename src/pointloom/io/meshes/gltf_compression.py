"""Compressed glTF: Draco meshes (KHR_draco_mesh_compression) and meshoptimizer views (EXT_meshopt_compression).

Decoded by the optional packages DracoPy and meshoptimizer and checked against the file.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..optional_imports import foreign_errors, import_for
from .gltf_file import GltfFile

DRACO = "KHR_draco_mesh_compression"
MESHOPT = ("EXT_meshopt_compression", "KHR_meshopt_compression")
_MESHOPT_FILTERS = {"NONE": (), "OCTAHEDRAL": (4, 8), "QUATERNION": (8,), "EXPONENTIAL": tuple(range(4, 257, 4))}
_MAX_STRIDE = 256


def decode_view(file: GltfFile, packed: dict[str, Any], data: memoryview, name: str) -> tuple[memoryview, int]:
    """The bytes of a view compressed by meshoptimizer, and the element stride."""
    count, stride = file.integer(packed, "count", name), file.integer(packed, "byteStride", name)
    mode, filter_name = packed.get("mode"), packed.get("filter", "NONE")
    is_attribute = mode == "ATTRIBUTES"
    file.check_count(count, f"the elements of {name}")
    if mode not in ("ATTRIBUTES", "TRIANGLES", "INDICES") or filter_name not in _MESHOPT_FILTERS:
        raise file.error(f"{name} is compressed as {str(mode)[:20]} {str(filter_name)[:20]}, which is not supported")
    good = range(4, _MAX_STRIDE + 1, 4) if is_attribute else (2, 4)
    if filter_name != "NONE":
        good = _MESHOPT_FILTERS[filter_name] if is_attribute else ()
    if stride not in good or count < 1 or (mode == "TRIANGLES" and count % 3):
        raise file.error(
            f"{name} is compressed as {mode} {filter_name} of {count} times {stride} bytes, which is invalid"
        )
    package = import_for(file.path, "meshoptimizer", "meshopt")
    with foreign_errors(file.path, f"{name} is compressed with meshoptimizer and damaged"):
        if is_attribute:
            plain = package.decode_vertex_buffer(count, stride, bytes(data)).view(np.uint8).reshape(-1)
        elif mode == "TRIANGLES":
            plain = package.decode_index_buffer(count, stride, bytes(data)).view(np.uint8)
        else:
            plain = package.decode_index_sequence(count, stride, bytes(data)).view(np.uint8)
        if filter_name == "OCTAHEDRAL":
            plain = package.decode_filter_oct(plain, count, stride)
        elif filter_name == "QUATERNION":
            plain = package.decode_filter_quat(plain, count, stride)
        elif filter_name == "EXPONENTIAL":
            plain = package.decode_filter_exp(plain, count, stride)
    return memoryview(plain.tobytes()[: count * stride]), stride


class DracoMesh:
    """A Draco primitive: corners, and vertex values by accessor name."""

    def __init__(self, file: GltfFile, packed: dict[str, Any], data: memoryview, what: str):
        self._file, self._what = file, what
        self._names = file.part(packed, "attributes", what)
        package = import_for(file.path, "DracoPy", "gltf")
        with foreign_errors(file.path, f"{what} is compressed with Draco and damaged"):
            mesh = package.decode(bytes(data))
            faces, attributes = getattr(mesh, "faces", None), mesh.attributes
        if faces is None:
            raise file.error(f"{what}: the Draco data contains points, no triangles")
        self.corners: NDArray[np.int64] = np.asarray(faces).reshape(-1).astype(np.int64)
        file.check_count(len(self.corners), f"the corners of {what}")
        self._values = {entry["unique_id"]: entry["data"] for entry in attributes}

    def get(self, name: str) -> NDArray[Any] | None:
        """The values of an attribute, shape (n, width). None if it was not compressed."""
        if name not in self._names:
            return None
        key = self._names[name]
        if not isinstance(key, int) or key not in self._values:
            raise self._file.error(
                f"{self._what}: the Draco data contains no attribute {str(key)[:20]}, which {name} refers to"
            )
        values = np.asarray(self._values[key])
        return values.reshape(len(values), -1)
