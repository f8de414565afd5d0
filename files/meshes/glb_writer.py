"""A mesh as GLB (glTF 2.0): one node, one mesh, a primitive for each of its textures, pictures as PNG inside.

Positions are float32 about the node's translation, so that coordinates far from zero stay exact. glTF has texture
coordinates at vertices: a vertex whose corners have several is written several times. Triangles come in the order of
their materials. Not held: attributes (refused), material numbers of a mesh that has no textures, NaN.

Source: Khronos, "glTF 2.0 Specification".
"""

from __future__ import annotations

import json
import os
import struct
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.coordinates import quiet, split_origin
from ...core.errors import FileError
from ..pictures.image_files import encode_png
from ..table import MeshTable
from .glb_container import BINARY_CHUNK, JSON_CHUNK, MAGIC

_FLOAT, _UINT = 5126, 5125
_VERTEX_TARGET, _INDEX_TARGET = 34962, 34963


def write_glb(path: str | os.PathLike[str], mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as GLB.

    Args:
        path: The file; it appears whole or not at all.
        mesh: The mesh.
        overwrite: Whether an existing file may be replaced.

    Raises:
        FileError: The place cannot be written, the mesh has attributes or no triangles, a value is not finite in
            float32, or the file would pass 4 GiB.
        ValueError: An array of the mesh has the wrong shape, or a triangle names a missing vertex or texture.
    """
    path = check_writable(path, overwrite=overwrite)
    mesh = mesh.checked()
    if mesh.attributes:
        reason = f"GLB cannot hold the attributes {', '.join(mesh.attributes)}"
        raise FileError(path, reason, remedy="Write .ply, or drop them first")
    if not len(mesh.triangles):
        raise FileError(path, "GLB cannot hold a mesh without triangles", remedy="Write .ply")
    with quiet():
        positions, origin = split_origin(mesh.vertices)
    rows, corners, uvs = _split_seams(mesh)
    arrays = {"POSITION": positions, "NORMAL": mesh.vertex_normals, "COLOR_0": mesh.vertex_colors}
    columns = {name: values[rows] for name, values in arrays.items() if values is not None}
    if uvs is not None:
        columns["TEXCOORD_0"] = np.stack([uvs[:, 0], 1 - uvs[:, 1]], axis=1)  # glTF's v runs down
    for name, values in columns.items():
        if not np.isfinite(values).all():
            row = int(rows[np.flatnonzero(~np.isfinite(values).all(axis=1))[0]])
            raise FileError(path, f"{name}: GLB cannot hold NaN or infinite values", where=f"vertex {row}")
    data = _assemble(columns, corners, mesh, origin)
    if len(data) >= 2**32:
        raise FileError(path, f"GLB ends at 4 GiB, and the mesh takes {len(data)} bytes", remedy="Write .ply")
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(data)


def _split_seams(mesh: MeshTable) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float32] | None]:
    """The vertex of each written vertex, the corners among those, and their texture coordinates."""
    count = len(mesh.vertices)
    if mesh.triangle_uvs is None:
        return np.arange(count), mesh.triangles.astype(np.int64), None
    unused = np.ones(count, bool)
    unused[mesh.triangles] = False
    loose = np.flatnonzero(unused)
    vertex = np.concatenate([mesh.triangles.reshape(-1), loose])
    uvs = np.concatenate([mesh.triangle_uvs, np.zeros((len(loose), 2), np.float32)])
    order = np.lexsort((uvs[:, 1], uvs[:, 0], vertex))
    is_first = np.ones(len(order), bool)
    is_first[1:] = (np.diff(vertex[order]) != 0) | (uvs[order][1:] != uvs[order][:-1]).any(axis=1)
    place = np.empty(len(order), np.int64)
    place[order] = np.cumsum(is_first) - 1
    firsts = order[is_first]
    return vertex[firsts].astype(np.int64), place[: mesh.triangles.size].reshape(-1, 3), uvs[firsts]


def _assemble(
    columns: dict[str, NDArray[Any]], corners: NDArray[np.int64], mesh: MeshTable, origin: NDArray[np.float64]
) -> bytes:
    """The bytes of the file."""
    body = _Body()
    attributes = {name: body.add_array(values, _VERTEX_TARGET, name == "POSITION") for name, values in columns.items()}
    ids = mesh.triangle_material_ids if mesh.textures else None
    primitives = []
    for number in [0] if ids is None else np.unique(ids):
        chosen = corners if ids is None else corners[ids == number]
        indices = body.add_array(chosen.reshape(-1, 1).astype(np.uint32), _INDEX_TARGET, False)
        primitives.append({"attributes": attributes, "indices": indices, "mode": 4})
        if mesh.textures:
            primitives[-1]["material"] = int(number)
    node: dict[str, Any] = {"mesh": 0}
    if origin.any():
        node["translation"] = origin.tolist()
    content: dict[str, Any] = {
        "asset": {"version": "2.0", "generator": "pointloom"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [node],
        "meshes": [{"primitives": primitives}],
    }
    if mesh.textures:
        images = [
            {"bufferView": body.add_bytes(encode_png(picture)), "mimeType": "image/png"} for picture in mesh.textures
        ]
        content |= {
            "images": images,
            "textures": [{"source": number} for number in range(len(images))],
            "materials": [_material(number, picture) for number, picture in enumerate(mesh.textures)],
        }
    content |= {"accessors": body.accessors, "bufferViews": body.views, "buffers": [{"byteLength": len(body.data)}]}
    text = json.dumps(content, separators=(",", ":")).encode("ascii")
    text += b" " * (-len(text) % 4)
    length = 12 + 8 + len(text) + 8 + len(body.data)
    head = MAGIC + struct.pack("<II", 2, min(length, 2**32 - 1))
    chunk = struct.pack("<II", min(len(body.data), 2**32 - 1), BINARY_CHUNK)
    return b"".join([head, struct.pack("<II", len(text), JSON_CHUNK), text, chunk, bytes(body.data)])


def _material(number: int, picture: NDArray[np.uint8]) -> dict[str, Any]:
    look = {"baseColorTexture": {"index": number}, "metallicFactor": 0.0, "roughnessFactor": 1.0}
    material: dict[str, Any] = {"name": f"material_{number}", "pbrMetallicRoughness": look, "doubleSided": True}
    return material | ({"alphaMode": "BLEND"} if picture.shape[2] == 4 else {})


class _Body:
    """The binary chunk while it grows, and the JSON that says what lies where."""

    def __init__(self):
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add_bytes(self, content: bytes) -> int:
        """Append bytes from a multiple of four on; their buffer view."""
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)})
        self.data += content + b"\0" * (-len(content) % 4)
        return len(self.views) - 1

    def add_array(self, values: NDArray[Any], target: int, with_bounds: bool) -> int:
        """Append rows of float32 or uint32; their accessor."""
        is_float = values.dtype.kind == "f"
        little = np.ascontiguousarray(values, "<f4" if is_float else "<u4")
        view = self.add_bytes(little.tobytes())
        self.views[view]["target"] = target
        kind = "SCALAR" if values.shape[1] == 1 else f"VEC{values.shape[1]}"
        accessor: dict[str, Any] = {
            "bufferView": view,
            "componentType": _FLOAT if is_float else _UINT,
            "count": len(values),
            "type": kind,
        }
        if with_bounds:
            accessor |= {"min": little.min(axis=0).tolist(), "max": little.max(axis=0).tolist()}
        self.accessors.append(accessor)
        return len(self.accessors) - 1
