"""glTF 2.0 (.glb, .gltf): the triangles of a static scene (skins at rest, default morphs) as one mesh.

Normals, colors and attributes (`_NAME` becomes NAME) are kept if all primitives have them. Each used material becomes
one image: base color texture, else one pixel of its factor in sRGB. Alpha is kept for BLEND, thresholded for MASK, else
dropped. Khronos, "glTF 2.0 Specification", section 3.9. KHR_texture_transform. KHR_materials_pbrSpecularGlossiness.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError, FilePath
from ..color_space import linear_to_srgb
from ..images.texture_files import decode_textures, drop_alpha
from ..source import open_source
from ..table import MeshTable
from .gltf_arrays import GltfArrays
from .gltf_file import GltfFile
from .gltf_nodes import list_scene_nodes
from .gltf_primitives import TRIANGLES_MODE, Placing, Primitive, Vertices, placing_of
from .gltf_unsupported import SPECULAR, LeftBehind, check_required

_TRANSFORM = "KHR_texture_transform"
# Texture extensions whose image formats are not supported.
_OTHER_KINDS = {
    "KHR_texture_basisu": "KTX2",
    "EXT_texture_webp": "WebP",
    "EXT_texture_avif": "AVIF",
    "MSFT_texture_dds": "DDS",
}


@dataclass(frozen=True)
class BaseColor:
    """The base color of a material: linear RGBA `factor`, and indices of `texture` and texture `coordinates`.
    `transform` is their affine transform (2, 3), v downwards. `cutoff` is the minimum alpha. 0 is opaque, None blends.
    """

    texture: Any = None
    coordinates: int = 0
    transform: NDArray[np.float64] | None = None
    factor: tuple[float, ...] = (1.0, 1.0, 1.0, 1.0)
    cutoff: float | None = 0.0


class Materials:
    def __init__(self, arrays: GltfArrays, left: LeftBehind):
        self._arrays, self._file, self._left = arrays, arrays.file, left
        self._known: dict[int, BaseColor] = {-1: BaseColor()}

    def base_color(self, number: int) -> BaseColor:
        """The base color of a material; white for -1 (no material)."""
        if number not in self._known:
            self._known[number] = self._read(number)
            self._left.add_material(number)
        return self._known[number]

    def _read(self, number: int) -> BaseColor:
        file, what = self._file, f"materials {number}"
        material = file.take("materials", number, "a primitive")
        look, names = file.part(material, "pbrMetallicRoughness", what), ("baseColorFactor", "baseColorTexture")
        older = file.extension(material, SPECULAR, what)
        if older is not None:
            look, names = older, ("diffuseFactor", "diffuseTexture")
        factor = file.numbers(look, names[0], what, [1.0] * 4)
        mode, cutoff = material.get("alphaMode", "OPAQUE"), 0.0
        if mode == "MASK":
            given = file.numbers({"alphaCutoff": [material.get("alphaCutoff", 0.5)]}, "alphaCutoff", what, [0.5])[0]
            cutoff = given / factor[3] if factor[3] > 0 else np.inf if given > 0 else 0.0
            factor[3] = 1 if names[1] in look or cutoff <= 1 else 0
        elif mode != "BLEND":
            factor[3] = 1
        color = tuple(np.clip(factor, 0, 1).tolist())
        if names[1] not in look:
            return BaseColor(factor=color)
        texture = file.part(look, names[1], what)
        coordinates, transform = file.integer(texture, "texCoord", what, 0), None
        moved = file.extension(texture, _TRANSFORM, what)
        if moved is not None:
            coordinates = file.integer(moved, "texCoord", what, coordinates)
            transform = self._transform(moved, f"{_TRANSFORM} of {what}")
        if color != (1, 1, 1, 1):
            self._left.add("factors of base colors beside a texture", number)
        return BaseColor(texture.get("index"), coordinates, transform, color, None if mode == "BLEND" else cutoff)

    def _transform(self, moved: dict[str, Any], what: str) -> NDArray[np.float64] | None:
        """Scale, rotation, offset; counterclockwise as displayed, so with v downwards."""
        file = self._file
        offset = file.numbers(moved, "offset", what, [0.0, 0.0], limit=1e30)
        scale = file.numbers(moved, "scale", what, [1.0, 1.0], limit=1e30)
        angle = file.numbers({"rotation": [moved.get("rotation", 0.0)]}, "rotation", what, [0.0], limit=1e30)[0]
        c, s = np.cos(angle), np.sin(angle)
        A = np.array([[c, s, 0], [-s, c, 0]]) * [*scale, 0]
        A[:, 2] = offset
        return None if np.array_equal(A, np.eye(2, 3)) else A

    def images(self, used: list[int]) -> tuple[tuple[NDArray[np.uint8], ...], list[int]]:
        """Images of the used materials and the image index of each use.
        Empty if all are plain white, or, noted as dropped, if an image is damaged or the total is too large."""
        numbers = sorted(set(used), key=lambda number: (number < 0, number))
        colors = [self.base_color(number) for number in numbers]
        if all(color.texture is None and color.factor == (1, 1, 1, 1) for color in colors):
            return (), []
        keys: list[Hashable] = []
        given: dict[Hashable, tuple[str, Any]] = {}
        for number, color in zip(numbers, colors, strict=True):
            if color.texture is None:
                keys.append(None)
                continue
            key, name, data = self._image(color.texture, f"materials {number}")
            if data is None:
                self._left.add(f"the textures, because that of materials {number} is {name}")
                return (), []
            keys.append(key)
            given.setdefault(key, (name, data))
        try:
            decoded = decode_textures(self._file.path, given)
        except FileError as error:
            self._left.add(f"the textures, because {error}")
            return (), []
        made: dict[tuple[Hashable, float], NDArray[np.uint8]] = {}
        images = []
        for key, color in zip(keys, colors, strict=True):
            if key is None:
                images.append(_pixel(color.factor))
                continue
            image = decoded[key]
            if color.cutoff is not None and (image.shape[2] == 4 or color.cutoff > 1):
                if (key, color.cutoff) not in made:
                    made[key, color.cutoff] = drop_alpha(image, color.cutoff)
                image = made[key, color.cutoff]
            images.append(image)
        index_of = {number: index for index, number in enumerate(numbers)}
        return tuple(images), [index_of[number] for number in used]

    def _image(self, texture: Any, what: str) -> tuple[Hashable, str, Any]:
        """Key, name and bytes of a texture's image; or the reason for its absence and None."""
        file, arrays = self._file, self._arrays
        content = file.take("textures", texture, what)
        if "source" not in content:
            for name, kind in _OTHER_KINDS.items():
                if file.extension(content, name, f"the texture of {what}") is not None:
                    return None, f"an image of type {kind}, which is not supported", None
        source = file.integer(content, "source", f"the texture of {what}")
        image = file.take("images", source, f"the texture of {what}")
        name, uri = f"{file.path} (images {source})", image.get("uri")
        if uri is None:
            view = image.get("bufferView")
            return ("view", view), name, arrays.view(view, f"images {source}")[0]
        if isinstance(uri, str) and uri[:5].lower() == "data:":
            return ("image", source), name, file.uri_bytes(uri, f"images {source}")
        linked = file.uri_file(uri, f"images {source}")
        if linked is None:
            return None, file.why_missing(uri), None
        return ("file", linked.resolve()), str(linked), memoryview(open_source(linked)[:])


def _pixel(linear: tuple[float, ...]) -> NDArray[np.uint8]:
    """An image of one pixel, converted from linear to sRGB. With alpha if not opaque."""
    curved = linear_to_srgb(np.array(linear[:3]))
    values = [*curved, linear[3]] if linear[3] < 1 else curved
    return np.rint(np.array(values) * 255).astype(np.uint8).reshape(1, 1, -1)


def read_glb(path: FilePath, *, outside_files: bool = False) -> MeshTable:
    """Read the triangles of a .glb or .gltf file, with axes as stored (y is up by the standard).
    Vertices are float32 if no node transforms them, else float64."""
    file = GltfFile(path, outside_files=outside_files)
    check_required(file)
    parts = _Parts(file)
    tree = list_scene_nodes(file)
    for number in tree.with_mesh:
        parts.add_mesh(number, placing_of(parts.arrays, tree, number))
    mesh = parts.mesh(tree.with_mesh)
    mesh.up = file.up_before
    parts.left.warn(stacklevel=4)
    return mesh


class _Parts:
    def __init__(self, file: GltfFile):
        self.file, self.arrays, self.left = file, GltfArrays(file), LeftBehind(file)
        self.looks = Materials(self.arrays, self.left)
        self.vertices: list[Vertices] = []
        self.triangles: list[NDArray[np.int64]] = []
        self.uvs: list[NDArray[np.float32] | None] = []
        self.materials: list[int] = []
        self._counts = [0, 0, 0]  # of vertices, triangles, and values of attributes
        self._primitives: dict[int, list[Primitive]] = {}  # by mesh, for all nodes
        self._uvs: dict[Hashable, NDArray[np.float32] | None] = {}  # of vertices

    def add_mesh(self, number: int, placing: Placing) -> None:
        file = self.file
        mesh_index = file.take("nodes", number, "a scene")["mesh"]
        mesh, what = file.take("meshes", mesh_index, "a node"), f"meshes {mesh_index}"
        if mesh_index not in self._primitives:
            self._primitives[mesh_index] = [*self._read_primitives(mesh, what)]
        shared: dict[str, Vertices] = {}
        for primitive in self._primitives[mesh_index]:
            if primitive.has_triangles:
                self._add(primitive, primitive.material, placing, shared)
            else:
                self.left.add("points and lines" if primitive.mode < TRIANGLES_MODE else "triangles without positions")

    def _read_primitives(self, mesh: dict[str, Any], what: str) -> Iterator[Primitive]:
        primitives = mesh.get("primitives")
        if not isinstance(primitives, list) or not all(isinstance(entry, dict) for entry in primitives):
            raise self.file.error(f"{what}: primitives: expected a list of objects")
        for content in primitives:
            yield Primitive(self.arrays, self.left, content, what)

    def _add(self, primitive: Primitive, material: int, placing: Placing, shared: dict[str, Vertices]) -> None:
        if primitive.key not in shared:
            new_vertices = primitive.read_vertices(self._counts[0], placing)
            shared[primitive.key] = new_vertices
            self.vertices.append(new_vertices)
            self._counts[0] += len(new_vertices.positions)
            self._counts[2] += len(new_vertices.positions) * len(new_vertices.attributes)
            self.file.check_count(self._counts[2], "the values of attributes of all nodes")
        vertices = shared[primitive.key]
        count = len(vertices.positions)
        corners = primitive.read_corners(count)
        self._counts[1] += len(corners)
        self.file.check_count(self._counts[1], "the triangles of all nodes")
        if vertices.is_mirrored:  # a reflection flips triangle orientation
            corners = corners[:, ::-1]
        color = self.looks.base_color(material)
        self.triangles.append(corners + vertices.first)
        self.materials.append(material)
        self.uvs.append(primitive.read_uvs(color.coordinates, color.transform, corners, count, self._uvs))

    def mesh(self, nodes: list[int]) -> MeshTable:
        if not sum(len(part) for part in self.triangles):
            raise self.file.error("contains no triangles")
        counts = [len(part) for part in self.triangles]
        positions = np.concatenate([part.positions for part in self.vertices])
        mesh = MeshTable(positions, np.concatenate(self.triangles), self._of_all("normals"), self._of_all("colors"))
        mesh.attributes = self._attributes()
        mesh.textures, numbers = self.looks.images(self.materials)
        if mesh.textures and any(numbers):
            mesh.triangle_material_ids = np.repeat(numbers, counts)
        if mesh.textures or any(part is not None for part in self.uvs):
            blank = [np.zeros((3 * count, 2), np.float32) for count in counts]
            given = [part if part is not None else zero for part, zero in zip(self.uvs, blank, strict=True)]
            mesh.triangle_uvs = np.concatenate(given)
        self.left.add_scene(nodes, sorted({number for number in self.materials if number >= 0}))
        return mesh.checked()

    def _of_all(self, name: str) -> NDArray[np.float32] | None:
        values_of_parts = [getattr(part, name) for part in self.vertices]
        if all(values is not None for values in values_of_parts):
            return np.concatenate(values_of_parts).astype(np.float32)
        if any(values is not None for values in values_of_parts):
            self.left.add(f"the {name}, because some primitives have none")
        return None

    def _attributes(self) -> dict[str, NDArray[np.generic]]:
        joined = {}
        for name in dict.fromkeys(name for part in self.vertices for name in part.attributes):
            parts = [part.attributes.get(name) for part in self.vertices]
            given = [values for values in parts if values is not None]
            if len(given) == len(parts) and len({values.shape[1:] for values in given}) == 1:
                joined[name] = np.concatenate(given)
            else:
                self.left.add(f"the attribute {name[:60]}, because some primitives have none of its kind")
        return joined
