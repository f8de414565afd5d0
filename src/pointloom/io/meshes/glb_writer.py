"""Write a mesh as glTF 2.0 (.glb, or .gltf with m.bin and m_0.png, ...): one node, one mesh, a primitive per texture.

Positions are float32 relative to the node translation. Seam vertices are duplicated. An attribute NAME becomes _NAME if
its type is exact in glTF. Images with alpha use MASK for 0 and 255, else BLEND. Vertex colors become linear. Khronos,
"glTF 2.0".
"""

from __future__ import annotations

import json
import struct
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any
from urllib.parse import quote

import numpy as np
from numpy.typing import NDArray

from ...core.atomic import atomic_write, check_writable
from ...core.coordinates import quiet, split_origin
from ...core.errors import FileError, FilePath
from ...core.up_axis import AXES
from ..color_space import srgb_to_linear
from ..columns import warn_left_out
from ..images.image_files import encode_png
from ..images.texture_files import alpha_mode, derived_name, image_names, write_with
from ..table import MeshTable
from .glb_container import BINARY_CHUNK, GLB_MAGIC, JSON_CHUNK
from .gltf_arrays import COMPONENT_TYPES
from .gltf_file import UP_BEFORE
from .gltf_primitives import ALPHA

_VERTEX_TARGET, _INDEX_TARGET = 34962, 34963
_CODES = {np.dtype(code): number for number, code in COMPONENT_TYPES.items()}
_MAX_WIDTH = 4


def write_glb(path: FilePath, mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as GLB (up to 4 GiB) atomically. Unsupported attributes are dropped with a warning."""
    path = check_writable(path, overwrite=overwrite)
    scene = _scene_of(path, mesh)
    images = [{"bufferView": scene.body.add_bytes(encode_png(each)), "mimeType": "image/png"} for each in scene.images]
    text = _text(scene, images, {})
    text += b" " * (-len(text) % 4)
    body = bytes(scene.body.data)
    length = 12 + 8 + len(text) + 8 + len(body)
    if length >= 2**32:
        raise FileError(path, f"GLB is limited to 4 GiB, and the mesh needs {length} bytes", remedy="Write .ply")
    with atomic_write(path, overwrite=overwrite) as file:
        file.write(GLB_MAGIC + struct.pack("<II", 2, length) + struct.pack("<II", len(text), JSON_CHUNK) + text)
        file.write(struct.pack("<II", len(body), BINARY_CHUNK))
        file.write(body)


def write_gltf(path: FilePath, mesh: MeshTable, *, overwrite: bool = True) -> None:
    """Write a triangle mesh as glTF text with m.bin and m_0.png, ... beside m.gltf, each file atomically."""
    path = check_writable(path, overwrite=overwrite)
    scene, name = _scene_of(path, mesh), derived_name(path, ".bin")
    beside: dict[str, Any] = dict(zip(image_names(path, len(scene.images)), scene.images, strict=True))
    text = _text(scene, [{"uri": quote(image)} for image in beside], {"uri": quote(name)})
    with write_with(path, {name: bytes(scene.body.data), **beside}, overwrite=overwrite) as file:
        file.write(text)


def storable_in_gltf(mesh: MeshTable) -> tuple[MeshTable, list[str]]:
    """The part of a mesh that glTF stores, and the names of the other attributes."""
    columns = {name: _column_of(np.asarray(values)) for name, values in mesh.attributes.items() if name}
    storable = {name: mesh.attributes[name] for name, column in columns.items() if column is not None}
    left_out = [name for name in mesh.attributes if name not in storable] + [*mesh.triangle_attributes]
    return replace(mesh, attributes=storable, triangle_attributes={}), left_out


@dataclass
class _Scene:
    """The content to write: JSON without buffers and images, arrays, unique images."""

    content: dict[str, Any]
    body: _Body
    images: list[NDArray[np.uint8]]


def _scene_of(path: Path, mesh: MeshTable) -> _Scene:
    mesh = mesh.checked()
    mesh, left_out = storable_in_gltf(mesh)
    warn_left_out(path, "glTF", [name or repr(name) for name in left_out], stacklevel=4)
    if not len(mesh.triangles):
        raise FileError(path, "GLB cannot store a mesh without triangles", remedy="Write .ply")
    with quiet():
        positions, origin = split_origin(mesh.vertices)
    rows, corners, uvs = split_seams(mesh)
    columns = {name: values[rows] for name, values in _columns(mesh, positions).items()}
    if uvs is not None:
        columns["TEXCOORD_0"] = np.stack([uvs[:, 0], 1 - uvs[:, 1]], axis=1)  # v is downwards in glTF
    for name, values in columns.items():
        if values.dtype.kind == "f" and not np.isfinite(values).all():
            row = int(rows[np.flatnonzero(~np.isfinite(values).all(axis=1))[0]])
            raise FileError(path, f"{name}: GLB cannot store NaN or infinite values", where=f"vertex {row}")
    return _assemble(columns, corners, mesh, origin)


def _columns(mesh: MeshTable, positions: NDArray[Any]) -> dict[str, NDArray[Any]]:
    """Vertex values by file name, shape (m, c)."""
    colors, attributes = mesh.vertex_colors, dict(mesh.attributes)
    if colors is not None:
        colors = srgb_to_linear(colors)
        alpha = attributes.get(ALPHA, np.empty((0, 0)))
        if alpha.ndim == 1 and alpha.dtype.kind == "f" and ((alpha >= 0) & (alpha <= 1)).all():
            colors = np.column_stack([colors, attributes.pop(ALPHA)])
        colors = colors.astype(np.float32)
    columns = {"POSITION": positions, "NORMAL": mesh.vertex_normals, "COLOR_0": colors}
    columns |= {f"_{name}": _column_of(values) for name, values in attributes.items()}
    return {name: values for name, values in columns.items() if values is not None}


def _column_of(values: NDArray[Any]) -> NDArray[Any] | None:
    """An attribute in a glTF vertex type, shape (m, 1 to 4), or None."""
    column = values.reshape(len(values), -1) if values.ndim == 1 or values.shape[1] else None
    if column is None or column.shape[1] > _MAX_WIDTH:
        return None
    if column.dtype == np.bool_:
        return column.astype(np.uint8)
    if column.dtype.kind in "iu" and column.dtype.itemsize <= 2:
        return column
    if column.dtype.kind not in "iuf":
        return None
    with quiet():
        single = column.astype(np.float32)
        same = single.astype(column.dtype) == column
    largest = 2**24 if column.dtype.kind in "iu" else np.inf
    return single if (same | np.isnan(single)).all() and (np.abs(single) <= largest).all() else None


def split_seams(mesh: MeshTable) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float32] | None]:
    """Source of each written vertex, corner indices, and texture coordinates."""
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
    new_index = np.empty(len(order), np.int64)
    new_index[order] = np.cumsum(is_first) - 1
    firsts = order[is_first]
    return vertex[firsts].astype(np.int64), new_index[: mesh.triangles.size].reshape(-1, 3), uvs[firsts]


def _assemble(
    columns: dict[str, NDArray[Any]], corners: NDArray[np.int64], mesh: MeshTable, origin: NDArray[np.float64]
) -> _Scene:
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
    if mesh.up not in (None, AXES["y"]):
        content["asset"]["extras"] = {UP_BEFORE: mesh.up}
    images = list({id(image): image for image in mesh.textures}.values())
    if images:
        modes = {id(image): alpha_mode(image) for image in images}
        image_index = {id(image): number for number, image in enumerate(images)}
        content |= {
            "textures": [{"source": number} for number in range(len(images))],
            "materials": [_material(image_index[id(image)], modes[id(image)]) for image in mesh.textures],
        }
        images = [image[..., :3] if modes[id(image)] == "OPAQUE" else image for image in images]
    return _Scene(content, body, images)


def _text(scene: _Scene, images: list[dict[str, Any]], buffer: dict[str, Any]) -> bytes:
    """The JSON of a scene with its images and buffer."""
    body = scene.body
    content = scene.content | ({"images": images} if images else {})
    content |= {"accessors": body.accessors, "bufferViews": body.views}
    content["buffers"] = [buffer | {"byteLength": len(body.data)}]
    return json.dumps(content, separators=(",", ":")).encode("ascii")


def _material(texture: int, mode: str) -> dict[str, Any]:
    look = {"baseColorTexture": {"index": texture}, "metallicFactor": 0.0, "roughnessFactor": 1.0}
    material: dict[str, Any] = {"pbrMetallicRoughness": look, "doubleSided": True}
    return material | ({} if mode == "OPAQUE" else {"alphaMode": mode})


class _Body:
    def __init__(self):
        self.data = bytearray()
        self.views: list[dict[str, Any]] = []
        self.accessors: list[dict[str, Any]] = []

    def add_bytes(self, content: bytes) -> int:
        """Append bytes aligned to 4. Returns the buffer view."""
        self.views.append({"buffer": 0, "byteOffset": len(self.data), "byteLength": len(content)})
        self.data += content + b"\0" * (-len(content) % 4)
        return len(self.views) - 1

    def add_array(self, values: NDArray[Any], target: int, with_bounds: bool) -> int:
        """Append rows of numbers, aligned to 4 bytes at vertices. Returns the accessor."""
        code = np.dtype(values.dtype.newbyteorder("<"))
        little = np.ascontiguousarray(values, code)
        size = code.itemsize * little.shape[1]
        step = size + -size % 4 if target == _VERTEX_TARGET else size
        padded = little.view(np.uint8).reshape(len(little), size)
        view = self.add_bytes(np.pad(padded, ((0, 0), (0, step - size))).tobytes())
        self.views[view] |= {"target": target} | ({"byteStride": step} if step != size else {})
        kind = "SCALAR" if values.shape[1] == 1 else f"VEC{values.shape[1]}"
        accessor: dict[str, Any] = {
            "bufferView": view,
            "componentType": _CODES[code],
            "count": len(values),
            "type": kind,
        }
        if with_bounds:
            accessor |= {"min": little.min(axis=0).tolist(), "max": little.max(axis=0).tolist()}
        self.accessors.append(accessor)
        return len(self.accessors) - 1
