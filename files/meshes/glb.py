"""glTF 2.0, as one binary file (GLB) or as text with files beside it: the triangles of a scene at rest, as one mesh.

Every primitive of every node of the scene is taken where the node's transform, or its skin at rest, puts it, with the
default weights of its morph targets; primitives that share their vertices still do. Vertex normals, colours and
attributes are taken where all have them. An attribute `_NAME` becomes NAME, the alpha of colours "alpha". Texture
coordinates become those of corners, with v counted from below (glTF counts from above) and the material's texture
transform applied; each material that triangles have becomes one picture: its base colour texture, else one pixel of its
base color factor. Vertex colors and factors are converted from linear light to sRGB. Vertex colors outside 0..1 are
clamped with a warning. Vertex colors that are NaN or of an unknown type are left behind with a warning, and so are
texture coordinates of an unknown type.

What a mesh has no place for is left behind with one warning that lists it (gltf_left.py): points and lines, the factor
of a material with a texture, everything else of materials, names of parts, animations, cameras and lights. Refused by
name are extensions that a file requires and that are not read.

Source: Khronos, "glTF 2.0 Specification".
"""

from __future__ import annotations

import os

import numpy as np
from numpy.typing import NDArray

from ..table import MeshTable
from .gltf_arrays import GltfArrays
from .gltf_file import GltfFile
from .gltf_left import LeftBehind, check_required
from .gltf_materials import Materials
from .gltf_nodes import walk_scene
from .gltf_primitives import TRIANGLES, Placing, Primitive, Vertices, placing_of


def read_glb(path: str | os.PathLike[str], *, outside_files: bool = False) -> MeshTable:
    """Read the triangles of a glTF file, .glb or .gltf.

    Args:
        path: The file.
        outside_files: Whether names of buffers and pictures that lead out of the file's folder are followed.

    Returns:
        The mesh; float32 vertices where no node moves any, else float64. Axes are the file's: y is up by the standard.

    Raises:
        FileError: Missing, cut off, lengths, offsets or numbers that contradict each other, no triangles, more of them
            than the file bears, or something that is not read; says what.

    Warns:
        UserWarning: Something is left behind; says all of it.
    """
    file = GltfFile(path, outside_files=outside_files)
    check_required(file)
    parts = _Parts(file)
    tree = walk_scene(file)
    for number in tree.with_mesh:
        parts.add_mesh(number, placing_of(parts.arrays, tree, number))
    mesh = parts.mesh(tree.with_mesh)
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
        self._counts = [0, 0]  # of vertices and triangles

    def add_mesh(self, number: int, placing: Placing) -> None:
        """Take the triangles of a node's mesh."""
        file = self.file
        place = file.take("nodes", number, "a scene")["mesh"]
        mesh, what = file.take("meshes", place, "a node"), f"meshes {place}"
        primitives = mesh.get("primitives")
        if not isinstance(primitives, list) or not all(isinstance(entry, dict) for entry in primitives):
            raise file.error(f"{what}: primitives: expected a list of objects")
        shared: dict[str, Vertices] = {}
        for content in primitives:
            primitive = Primitive(self.arrays, self.left, content, what)
            if primitive.has_triangles:
                material = file.whole(content, "material", what) if "material" in content else -1
                self._add(primitive, material, placing, shared)
            else:
                self.left.add("points and lines" if primitive.mode < TRIANGLES else "triangles without positions")

    def _add(self, primitive: Primitive, material: int, placing: Placing, shared: dict[str, Vertices]) -> None:
        if primitive.key not in shared:
            found = primitive.read_vertices(self._counts[0], placing)
            shared[primitive.key] = found
            self.vertices.append(found)
            self._counts[0] += len(found.positions)
        vertices = shared[primitive.key]
        count = len(vertices.positions)
        corners = primitive.read_corners(count)
        self._counts[1] += len(corners)
        self.file.check_count(self._counts[1], "the triangles of all nodes")
        if vertices.is_mirrored:  # a mirror turns triangles round
            corners = corners[:, ::-1]
        color = self.looks.base_color(material)
        self.triangles.append(corners + vertices.first)
        self.materials.append(material)
        self.uvs.append(primitive.read_uvs(color.coordinates, color.transform, corners, count))

    def mesh(self, nodes: list[int]) -> MeshTable:
        """All of them as one mesh."""
        if not sum(len(part) for part in self.triangles):
            raise self.file.error("holds no triangles")
        counts = [len(part) for part in self.triangles]
        positions = np.concatenate([part.positions for part in self.vertices])
        mesh = MeshTable(positions, np.concatenate(self.triangles), self._of_all("normals"), self._of_all("colors"))
        mesh.attributes = self._attributes()
        mesh.textures, numbers = self.looks.pictures(self.materials)
        if mesh.textures and any(numbers):
            mesh.triangle_material_ids = np.repeat(numbers, counts)
        if mesh.textures or any(part is not None for part in self.uvs):
            blank = [np.zeros((3 * count, 2), np.float32) for count in counts]
            given = [part if part is not None else zero for part, zero in zip(self.uvs, blank, strict=True)]
            mesh.triangle_uvs = np.concatenate(given)
        self.left.add_scene(nodes, sorted({number for number in self.materials if number >= 0}))
        return mesh.checked()

    def _of_all(self, name: str) -> NDArray[np.float32] | None:
        found = [getattr(part, name) for part in self.vertices]
        if all(values is not None for values in found):
            return np.concatenate(found).astype(np.float32)
        if any(values is not None for values in found):
            self.left.add(f"the {name}, since some primitives have none")
        return None

    def _attributes(self) -> dict[str, NDArray[np.generic]]:
        found = {}
        for name in dict.fromkeys(name for part in self.vertices for name in part.attributes):
            parts = [part.attributes.get(name) for part in self.vertices]
            given = [values for values in parts if values is not None]
            if len(given) == len(parts) and len({values.shape[1:] for values in given}) == 1:
                found[name] = np.concatenate(given)
            else:
                self.left.add(f"the attribute {name[:60]}, since some primitives have none of its kind")
        return found
