"""GLB, glTF 2.0 in one binary file: the triangles of a scene as one mesh.

Every primitive of every node of the scene is taken where the node's transform puts it; primitives that share their
vertices still do. Vertex normals and colours are taken where all have them, else left behind with a warning. Texture
coordinates become those of corners, with v counted from below (glTF counts from above); each material becomes one
picture: its base colour texture, else one pixel of its base colour factor. Numbers of vertices' colours are taken as
they stand, as Open3D and trimesh do; the factor is turned from linear to sRGB.

Passed over: points and lines, the factor of a material with a texture, everything else of materials, transparency,
animations, cameras and lights. Refused by name: Draco and other required extensions, sparse accessors, morph targets,
skins, texture transforms, and buffers in other files.

Source: Khronos, "glTF 2.0 Specification".
"""

from __future__ import annotations

import math
import os
import warnings
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.quaternions import quaternions_to_rotations
from ..pictures.image_files import decode_texture
from ..table import MeshTable
from .glb_container import GlbFile

# Extensions that change nothing of what is read here.
_HARMLESS = ("KHR_materials_unlit", "KHR_mesh_quantization", "KHR_materials_specular", "KHR_materials_ior")
_TRIANGLES, _STRIP, _FAN = 4, 5, 6
_SHARED = ("POSITION", "NORMAL", "COLOR_0")


def read_glb(path: str | os.PathLike[str]) -> MeshTable:
    """Read the triangles of a GLB file.

    Returns:
        The mesh; float32 vertices where no node moves any, else float64.

    Raises:
        FileError: Missing, cut off, lengths, offsets or numbers that contradict each other, no triangles, or something
            that is not read; says what.

    Warns:
        UserWarning: Some primitives have normals or colours and others do not.
    """
    file = GlbFile(path)
    required = file.content.get("extensionsRequired", [])
    strange = [name for name in required if name not in _HARMLESS] if isinstance(required, list) else [required]
    if strange:
        raise file.error(f"needs the extension {str(strange[0])[:60]}, which is not read", remedy="Export without it")
    parts = _Parts(file)
    for node, T in _placed_nodes(file):
        parts.add_mesh(node, T)
    return parts.mesh()


def _placed_nodes(file: GlbFile) -> Iterator[tuple[dict[str, Any], NDArray[np.float64]]]:
    """The nodes of the scene that have a mesh, each with its transform to the world."""
    nodes, scenes = file.objects("nodes"), file.objects("scenes")
    if scenes:
        roots = _children(file, file.take("scenes", file.content.get("scene", 0), "scene"), "nodes")
    else:
        below = {child for node in nodes for child in _children(file, node, "children")}
        roots = [number for number in range(len(nodes)) if number not in below]
    waiting, seen = [(number, np.eye(4)) for number in reversed(roots)], set()
    while waiting:
        number, T_parent = waiting.pop()
        node = file.take("nodes", number, "a node or scene")
        if number in seen:
            raise file.error(f"nodes {number} stands in two places of the tree of nodes")
        seen.add(number)
        T = T_parent @ _transform_of(file, node, f"nodes {number}")
        if not np.isfinite(T).all():
            raise file.error(f"nodes {number} has a transform beyond the range of numbers")
        if "mesh" in node:
            yield node, T
        waiting += [(child, T) for child in reversed(_children(file, node, "children"))]


def _children(file: GlbFile, holder: dict[str, Any], name: str) -> list[int]:
    found = holder.get(name, [])
    if not isinstance(found, list) or not all(type(child) is int for child in found):
        raise file.error(f"{name}: expected a list of numbers of nodes")
    return found


def _transform_of(file: GlbFile, node: dict[str, Any], what: str) -> NDArray[np.float64]:
    if "matrix" in node:
        return file.numbers(node, "matrix", what, [0.0] * 16).reshape(4, 4).T  # columns come first
    T = np.eye(4)
    quaternion = file.numbers(node, "rotation", what, [0.0, 0.0, 0.0, 1.0])
    square = float((quaternion * quaternion).sum())
    if not 0.5 < square < 2:  # of a unit quaternion, rounded
        raise file.error(f"{what}: rotation is no unit quaternion")
    R = quaternions_to_rotations((quaternion / math.sqrt(square))[None])[0]
    T[:3, :3] = R * file.numbers(node, "scale", what, [1.0, 1.0, 1.0])
    T[:3, 3] = file.numbers(node, "translation", what, [0.0, 0.0, 0.0])
    return T


@dataclass
class _Vertices:
    """Vertices that primitives share: where they begin among all, and what is known of them."""

    first: int
    positions: NDArray[Any]
    normals: NDArray[Any] | None
    colors: NDArray[Any] | None


class _Parts:
    """The primitives of a file, gathered one by one."""

    def __init__(self, file: GlbFile):
        self.file = file
        self.vertices: list[_Vertices] = []
        self.triangles: list[NDArray[np.int64]] = []
        self.uvs: list[NDArray[np.float32] | None] = []
        self.materials: list[int] = []
        self._count = 0

    def add_mesh(self, node: dict[str, Any], T: NDArray[np.float64]) -> None:
        """Take the triangles of a node's mesh."""
        mesh, what = self.file.take("meshes", node["mesh"], "a node"), f"meshes {node['mesh']}"
        if "skin" in node:
            raise self.file.error(f"{what} has a skin, which is not read", remedy="Export without armatures")
        primitives = mesh.get("primitives")
        if not isinstance(primitives, list) or not all(isinstance(entry, dict) for entry in primitives):
            raise self.file.error(f"{what}: primitives: expected a list of objects")
        shared: dict[tuple[Any, ...], _Vertices] = {}
        for primitive in primitives:
            self._add_primitive(primitive, T, what, shared)

    def _add_primitive(
        self, primitive: dict[str, Any], T: NDArray[np.float64], what: str, shared: dict[tuple[Any, ...], _Vertices]
    ) -> None:
        file, mode = self.file, self.file.whole(primitive, "mode", what, _TRIANGLES)
        extensions = primitive.get("extensions", {})
        for name in extensions if isinstance(extensions, dict) else [extensions]:
            if name == "KHR_draco_mesh_compression":
                raise file.error(f"{what} is compressed with Draco, which is not read", remedy="Export without it")
        if primitive.get("targets"):
            raise file.error(f"{what} has morph targets, which are not read", remedy="Export without shape keys")
        attributes = primitive.get("attributes")
        if not isinstance(attributes, dict):
            raise file.error(f"{what}: a primitive has no attributes")
        if mode > _FAN:
            raise file.error(f"{what} has the unknown mode {mode}")
        if mode < _TRIANGLES or "POSITION" not in attributes:
            return
        key = tuple(str(attributes.get(name)) for name in _SHARED)
        if key not in shared:
            shared[key] = self._read_vertices(attributes, T, what)
        vertices = shared[key]
        corners = self._read_corners(primitive, mode, len(vertices.positions), what)
        if np.linalg.det(T[:3, :3]) < 0:  # a mirror turns triangles round
            corners = corners[:, ::-1]
        material = file.whole(primitive, "material", what) if "material" in primitive else -1
        self.triangles.append(corners + vertices.first)
        self.materials.append(material)
        self.uvs.append(self._read_uvs(attributes, material, corners, len(vertices.positions), what))

    def _read_vertices(self, attributes: dict[str, Any], T: NDArray[np.float64], what: str) -> _Vertices:
        file = self.file
        quantized = "f4 i1 u1 i2 u2 ni1 nu1 ni2 nu2"
        positions = file.accessor(attributes["POSITION"], f"POSITION of {what}", ("VEC3",), quantized)
        normals = colors = None
        if "NORMAL" in attributes:
            normals = file.accessor(attributes["NORMAL"], f"NORMAL of {what}", ("VEC3",), "f4 ni1 ni2")
        if "COLOR_0" in attributes:
            colors = file.accessor(attributes["COLOR_0"], f"COLOR_0 of {what}", ("VEC3", "VEC4"), "f4 nu1 nu2")[:, :3]
            if not ((colors >= 0) & (colors <= 1)).all():
                raise file.error(f"COLOR_0 of {what}: a colour is outside 0..1")
        for name, values in (("NORMAL", normals), ("COLOR_0", colors)):
            if values is not None and len(values) != len(positions):
                raise file.error(f"{name} of {what} has {len(values)} elements, POSITION {len(positions)}")
        if not np.array_equal(T, np.eye(4)):
            with quiet():
                positions = positions.astype(np.float64) @ T[:3, :3].T + T[:3, 3]
                if normals is not None:
                    normals = _turned(normals, T[:3, :3])
        vertices = _Vertices(self._count, positions, normals, colors)
        self._count += len(positions)
        self.vertices.append(vertices)
        return vertices

    def _read_corners(self, primitive: dict[str, Any], mode: int, count: int, what: str) -> NDArray[np.int64]:
        if "indices" in primitive:
            indices = self.file.accessor(primitive["indices"], f"indices of {what}", ("SCALAR",), "u1 u2 u4")
            corners = indices[:, 0].astype(np.int64)
            if corners.max() >= count:
                raise self.file.error(f"indices of {what} name vertex {corners.max()}, of {count}")
        else:
            corners = np.arange(count)
        if mode == _TRIANGLES:
            if len(corners) % 3:
                raise self.file.error(f"{what}: {len(corners)} corners are no whole triangles")
            return corners.reshape(-1, 3)
        k = np.arange(max(len(corners) - 2, 0))
        if mode == _STRIP:  # every other triangle of a strip is wound the other way
            return np.stack([corners[k], corners[k + 1 + k % 2], corners[k + 2 - k % 2]], axis=1)
        return np.stack([corners[k + 1], corners[k + 2], np.broadcast_to(corners[0], k.shape)], axis=1)

    def _read_uvs(
        self, attributes: dict[str, Any], material: int, corners: NDArray[np.int64], count: int, what: str
    ) -> NDArray[np.float32] | None:
        name = f"TEXCOORD_{_base_color(self.file, material)[1]}"
        if name not in attributes:
            return None
        uvs = self.file.accessor(attributes[name], f"{name} of {what}", ("VEC2",), "f4 nu1 nu2").copy()
        if len(uvs) != count:
            raise self.file.error(f"{name} of {what} has {len(uvs)} elements, POSITION {count}")
        uvs[:, 1] = 1 - uvs[:, 1]  # glTF's v runs down
        return uvs[corners.reshape(-1)]

    def mesh(self) -> MeshTable:
        """All of them as one mesh."""
        if not self.triangles:
            raise self.file.error("holds no triangles")
        counts = [len(part) for part in self.triangles]
        positions = np.concatenate([part.positions for part in self.vertices])
        mesh = MeshTable(positions, np.concatenate(self.triangles), self._of_all("normals"), self._of_all("colors"))
        mesh.textures, numbers = _pictures_of(self.file, self.materials)
        if mesh.textures and any(numbers):
            mesh.triangle_material_ids = np.repeat(numbers, counts)
        if mesh.textures or any(part is not None for part in self.uvs):
            blank = [np.zeros((3 * count, 2), np.float32) for count in counts]
            given = [part if part is not None else zero for part, zero in zip(self.uvs, blank, strict=True)]
            mesh.triangle_uvs = np.concatenate(given)
        return mesh.checked()

    def _of_all(self, name: str) -> NDArray[np.float32] | None:
        found = [getattr(part, name) for part in self.vertices]
        if all(values is not None for values in found):
            return np.concatenate(found).astype(np.float32)
        if any(values is not None for values in found):
            message = f"{self.file.path}: the {name} are left behind, since some primitives have none"
            warnings.warn(message, UserWarning, stacklevel=5)
        return None


def _turned(normals: NDArray[Any], A: NDArray[np.float64]) -> NDArray[np.float64]:
    """Normals of a surface that is moved by A, of unit length where they have one: by A's cofactors."""
    cofactors = np.stack([np.cross(A[1], A[2]), np.cross(A[2], A[0]), np.cross(A[0], A[1])])
    turned = normals @ cofactors.T * np.sign(np.linalg.det(A))
    lengths = np.linalg.norm(turned, axis=1, keepdims=True)
    return np.divide(turned, lengths, out=np.zeros_like(turned), where=lengths > 0)


def _base_color(file: GlbFile, material: int) -> tuple[dict[str, Any] | None, int]:
    """A material's reference to its texture, and which texture coordinates that takes; None and 0 without."""
    if material < 0:
        return None, 0
    look = file.take("materials", material, "a primitive").get("pbrMetallicRoughness", {})
    texture = look.get("baseColorTexture") if isinstance(look, dict) else None
    if texture is None:
        return None, 0
    what = f"materials {material}"
    if not isinstance(texture, dict):
        raise file.error(f"{what}: baseColorTexture is no object")
    if texture.get("extensions"):
        named = ", ".join(map(str, texture["extensions"])) if isinstance(texture["extensions"], dict) else "extensions"
        raise file.error(f"{what}: its texture has {named[:60]}, which is not read")
    return texture, file.whole(texture, "texCoord", what, 0)


def _pictures_of(file: GlbFile, used: list[int]) -> tuple[tuple[NDArray[np.uint8], ...], list[int]]:
    """One picture a material, and which each primitive has; none where all materials are plain white."""
    decoded: dict[int, NDArray[np.uint8]] = {}
    pictures, is_plain = [], True
    for number, material in enumerate(file.objects("materials")):
        texture, _ = _base_color(file, number)
        if texture is None:
            look = material.get("pbrMetallicRoughness", {})
            factor = [1.0] * 4
            if isinstance(look, dict):
                factor = file.numbers(look, "baseColorFactor", f"materials {number}", [1.0] * 4)
            pictures.append(_pixel(np.array(factor[:3])))
            is_plain &= bool((pictures[-1] == 255).all())
        else:
            is_plain = False
            held = file.take("textures", texture.get("index"), f"materials {number}")
            source = file.whole(held, "source", f"the texture of materials {number}")
            image = file.take("images", source, f"the texture of materials {number}")
            if source not in decoded:
                decoded[source] = _decode_image(file, image, f"images {source}")
            pictures.append(decoded[source])
    if is_plain:
        return (), []
    if -1 in used:
        pictures.append(_pixel(np.ones(3)))
    return tuple(pictures), [number if number >= 0 else len(pictures) - 1 for number in used]


def _decode_image(file: GlbFile, image: dict[str, Any], what: str) -> NDArray[np.uint8]:
    data = file.data_uri(image["uri"], what) if "uri" in image else file.view(image.get("bufferView"), what)[0]
    return decode_texture(f"{file.path} ({what})", data)


def _pixel(linear: NDArray[np.float64]) -> NDArray[np.uint8]:
    """A picture of one pixel, from linear light to sRGB (IEC 61966-2-1)."""
    linear = np.clip(linear, 0, 1)
    curved = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    return np.rint(curved * 255).astype(np.uint8).reshape(1, 1, 3)
