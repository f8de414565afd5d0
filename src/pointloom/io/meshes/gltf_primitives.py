"""A primitive of a glTF mesh: vertices in the world at rest, triangles, texture coordinates.

Default morph weights are applied, then the skin's joints or the node transform. Khronos, "glTF 2.0 Specification",
section 3.7.
"""

from __future__ import annotations

from collections.abc import Hashable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.coordinates import quiet
from ...core.errors import FileError
from ..color_space import linear_to_srgb
from ..columns import fit_colors
from .gltf_arrays import GltfArrays
from .gltf_compression import DRACO, DracoMesh
from .gltf_nodes import Tree, blend_joints, joint_transforms, move_points, transform_normals
from .gltf_unsupported import LeftBehind

TRIANGLES_MODE, STRIP_MODE, FAN_MODE = 4, 5, 6
ALPHA = "alpha"

# Component types, including KHR_mesh_quantization; "n" is for normalized ones.
_POSITION = "f4 i1 u1 i2 u2 ni1 nu1 ni2 nu2"
_NORMAL = "f4 ni1 ni2"
_COLOR = "f4 nu1 nu2"
_UV = "f4 i1 u1 i2 u2 ni1 nu1 ni2 nu2"
_WEIGHTS = "f4 nu1 nu2"
_CUSTOM = "f4 i1 u1 i2 u2 u4 ni1 nu1 ni2 nu2"
_PLACELESS = ("TANGENT", "COLOR_", "JOINTS_", "WEIGHTS_", "TEXCOORD_")


@dataclass
class Vertices:
    """Vertices shared by primitives, with their offset; `is_mirrored` means that triangle orientation is flipped."""

    first: int
    positions: NDArray[Any]
    normals: NDArray[Any] | None
    colors: NDArray[Any] | None
    attributes: dict[str, NDArray[Any]] = field(default_factory=dict)
    is_mirrored: bool = False


@dataclass
class Placing:
    """The placement of a mesh by node transform or skin joints, with morph weights."""

    T: NDArray[np.float64]
    joints: NDArray[np.float64] | None
    weights: list[float] | None


def placing_of(arrays: GltfArrays, tree: Tree, number: int) -> Placing:
    file = arrays.file
    node, what = file.take("nodes", number, "a scene"), f"nodes {number}"
    mesh = file.take("meshes", node["mesh"], what)
    joints = joint_transforms(arrays, tree, file.integer(node, "skin", what)) if "skin" in node else None
    weights = node.get("weights", mesh.get("weights"))
    if weights is not None and not isinstance(weights, list):
        raise file.error(f"{what}: weights are not a list of numbers")
    return Placing(tree.T_world_node[number], joints, weights)


class Primitive:
    def __init__(self, arrays: GltfArrays, left: LeftBehind, content: dict[str, Any], what: str):
        """Parse the primitive. Only Draco meshes are decoded."""
        self._arrays, self._file, self._left, self._what = arrays, arrays.file, left, what
        self._content = content
        self.mode = self._file.integer(content, "mode", what, TRIANGLES_MODE)
        if self.mode > FAN_MODE:
            raise self._file.error(f"{what} has the unknown mode {self.mode}")
        attributes = content.get("attributes")
        if not isinstance(attributes, dict):
            raise self._file.error(f"{what}: a primitive has no attributes")
        self._attributes: dict[str, Any] = attributes
        targets = content.get("targets", [])
        if not isinstance(targets, list) or not all(isinstance(target, dict) for target in targets):
            raise self._file.error(f"{what}: targets: expected a list of objects")
        self._targets: list[dict[str, Any]] = targets
        self._weights: dict[int, NDArray[np.float64]] = {}  # of the targets, by the identity of their list
        self._moved: dict[tuple[str, int], NDArray[Any]] = {}  # by morphs, for all nodes with these weights
        self._values: tuple[NDArray[Any] | None, dict[str, NDArray[Any]]] | None = None
        self.has_triangles = self.mode >= TRIANGLES_MODE and "POSITION" in attributes
        packed = self._file.extension(content, DRACO, what)
        self._packed = packed if packed is not None and self.has_triangles and not self._has_uncompressed() else None
        self._draco: DracoMesh | None = None
        if self._packed is not None:
            data = arrays.view(self._packed.get("bufferView"), f"{DRACO} of {what}")[0]
            self._draco = DracoMesh(self._file, self._packed, data, what)

    def _has_uncompressed(self) -> bool:
        """True if all arrays are also stored without compression."""
        numbers = [*self._attributes.values(), self._content.get("indices")]
        return all("bufferView" in self._file.take("accessors", number, self._what) for number in numbers)

    @cached_property
    def key(self) -> str:
        names = {name: number for name, number in self._attributes.items() if not name.startswith("TEXCOORD")}
        return repr((sorted(names.items()), self._targets, self._packed))

    def _array(self, name: str, types: tuple[str, ...], components: str, count: int | None) -> NDArray[Any]:
        given = self._draco.get(name) if self._draco is not None else None
        what = f"{name} of {self._what}"
        values = self._arrays.accessor(self._attributes[name], what, types, components, given)
        if count is not None and len(values) != count:
            raise self._file.error(f"{what} has {len(values)} elements, POSITION {count}")
        return values

    def read_vertices(self, first: int, placing: Placing) -> Vertices:
        """Its transformed vertices; `first` is their offset among all."""
        positions = self._array("POSITION", ("VEC3",), _POSITION, None)
        count = len(positions)
        self._file.check_count(first + count, "the vertices of all nodes")
        self._check_finite(positions, "is NaN or infinite")
        normals = self._array("NORMAL", ("VEC3",), _NORMAL, count) if "NORMAL" in self._attributes else None
        if self._values is None:
            self._values = self._colors_and_attributes(count)
        colors, attributes = self._values
        positions = self._morphed("POSITION", positions, _POSITION, placing)
        self._check_finite(positions, "is moved by a morph target to a NaN or infinite position")
        if normals is not None:
            normals = self._morphed("NORMAL", normals, _NORMAL, placing)
        vertices = Vertices(first, positions, normals, colors, attributes)
        self._apply_transform(vertices, placing)
        self._check_finite(vertices.positions, "is moved by its node beyond the range of numbers")
        return vertices

    @cached_property
    def material(self) -> int:
        """The number of its material. -1 without one."""
        return self._file.integer(self._content, "material", self._what) if "material" in self._content else -1

    def _colors_and_attributes(self, count: int) -> tuple[NDArray[Any] | None, dict[str, NDArray[Any]]]:
        colors, attributes = self._colors(count)
        return colors, attributes | self._custom(count, attributes)

    def _check_finite(self, positions: NDArray[Any], reason: str) -> None:
        is_finite = np.isfinite(positions).all(axis=1)
        if not is_finite.all():
            raise self._file.error(f"POSITION of {self._what} {reason}", where=f"vertex {int(np.argmin(is_finite))}")

    def _colors(self, count: int) -> tuple[NDArray[Any] | None, dict[str, NDArray[Any]]]:
        """sRGB colors, and alpha as an attribute unless it is 1 everywhere. None if one is not finite."""
        if "COLOR_0" not in self._attributes:
            return None, {}
        try:
            clamped, note = fit_colors([*self._array("COLOR_0", ("VEC3", "VEC4"), _COLOR, count).T], 1)
        except FileError as error:
            clamped, note = None, error.reason
        if clamped is None:
            self._left.add(f"the colors of {self._what}, because {note}")
            return None, {}
        if note:
            self._left.add(f"the exact colors of {self._what}, because {note}")
        has_alpha = clamped.shape[1] == 4 and not (clamped[:, 3] == 1).all()
        colors = linear_to_srgb(clamped[:, :3]).astype(np.float32)
        return colors, {ALPHA: clamped[:, 3]} if has_alpha else {}

    def _custom(self, count: int, standard: dict[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
        """Attributes with a leading underscore, without it. Others are noted as dropped."""
        custom: dict[str, NDArray[Any]] = {}
        for name in self._attributes:
            if name.startswith("_") and len(name) > 1 and name[1:] not in standard:
                accessor = self._file.take("accessors", self._attributes[name], f"{name} of {self._what}")
                if accessor.get("type") not in ("SCALAR", "VEC2", "VEC3", "VEC4"):
                    self._left.add(f"the attribute {name[:60]}")
                    continue
                values = self._array(name, ("SCALAR", "VEC2", "VEC3", "VEC4"), _CUSTOM, count)
                custom[name[1:]] = values[:, 0] if values.shape[1] == 1 else values
            elif name not in ("POSITION", "NORMAL", "COLOR_0") and not name.startswith(_PLACELESS):
                self._left.add(f"the attribute {name[:60]}")
            elif name == "TANGENT":
                self._left.add("tangents")
            elif name.startswith("COLOR_") and name != "COLOR_0":
                self._left.add(f"the colors {name[:60]}")
        return custom

    def _morphed(self, name: str, values: NDArray[Any], components: str, placing: Placing) -> NDArray[Any]:
        if not self._targets:
            return values
        self._left.add("morph targets, but for their default weights")
        if placing.weights is None:
            return values
        key = name, id(placing.weights)
        if key not in self._moved:
            self._moved[key] = self._moved_by(name, values, components, placing.weights)
        return self._moved[key]

    def _moved_by(self, name: str, values: NDArray[Any], components: str, weights: list[float]) -> NDArray[Any]:
        """The values moved by the morph targets."""
        if id(weights) not in self._weights:
            self._weights[id(weights)] = self._file.numbers(
                {"weights": weights}, "weights", f"the node of {self._what}", [0.0] * len(self._targets), limit=1e30
            )
        given, moved = self._weights[id(weights)], values
        for number, (target, weight) in enumerate(zip(self._targets, given, strict=True)):
            if weight == 0 or name not in target:
                continue
            what = f"{name} of target {number} of {self._what}"
            offsets = self._arrays.accessor(target[name], what, ("VEC3",), components)
            if len(offsets) != len(values):
                raise self._file.error(f"{what} has {len(offsets)} elements, {name} {len(values)}")
            with quiet():
                moved = moved.astype(np.float64) + weight * offsets
        if moved is not values and any(set(target) - {"POSITION", "NORMAL", "TANGENT"} for target in self._targets):
            self._left.add("colors and texture coordinates of morph targets")
        return moved

    def _apply_transform(self, vertices: Vertices, placing: Placing) -> None:
        if placing.joints is None:
            T = placing.T
            if np.array_equal(T, np.eye(4)):
                return
            vertices.is_mirrored = bool(np.linalg.det(T[:3, :3]) < 0)
        elif "JOINTS_0" not in self._attributes or "WEIGHTS_0" not in self._attributes:
            raise self._file.error(f"{self._what} has a skin, but no joints and weights at its vertices")
        else:
            count, joints, weights = len(vertices.positions), [], []
            for k in range(sum(name.startswith("JOINTS_") for name in self._attributes)):
                if f"JOINTS_{k}" not in self._attributes or f"WEIGHTS_{k}" not in self._attributes:
                    raise self._file.error(f"{self._what} has no JOINTS_{k} and WEIGHTS_{k}, but later ones")
                joints.append(self._array(f"JOINTS_{k}", ("VEC4",), "u1 u2", count).astype(np.int64))
                weights.append(self._array(f"WEIGHTS_{k}", ("VEC4",), _WEIGHTS, count))
            what = f"JOINTS of {self._what}"
            T = blend_joints(self._file, placing.joints, np.hstack(joints), np.hstack(weights), what)
            vertices.is_mirrored = bool((np.linalg.det(T[:, :3, :3]) < 0).all())
        vertices.positions = move_points(vertices.positions, T)
        if vertices.normals is not None:
            vertices.normals = transform_normals(vertices.normals, T)

    def read_corners(self, count: int) -> NDArray[np.int64]:
        mode, corners = self.mode, self._indices()
        if corners is None:
            corners = np.arange(count)
        elif len(corners) and corners.max() >= count:
            raise self._file.error(f"indices of {self._what} refer to vertex {corners.max()}, of {count}")
        if self._draco is not None:  # also triangulates strips
            mode = TRIANGLES_MODE
        if mode == TRIANGLES_MODE:
            if rest := len(corners) % 3:  # skipped, as the specification demands
                self._left.add(f"{rest} of {len(corners)} corners of {self._what}, which are no complete triangle")
            return corners[: len(corners) - rest].reshape(-1, 3)
        k = np.arange(max(len(corners) - 2, 0))
        if mode == STRIP_MODE:  # every other triangle of a strip has the opposite orientation
            return np.stack([corners[k], corners[k + 1 + k % 2], corners[k + 2 - k % 2]], axis=1)
        return np.stack([corners[k + 1], corners[k + 2], np.broadcast_to(corners[0], k.shape)], axis=1)

    def _indices(self) -> NDArray[np.int64] | None:
        if "indices" not in self._content:
            return None if self._draco is None else self._draco.corners
        given, what = None, f"indices of {self._what}"
        if self._draco is not None:
            if self.mode != TRIANGLES_MODE:
                return self._draco.corners
            given = self._draco.corners[:, None]
        return self._arrays.accessor(self._content["indices"], what, ("SCALAR",), "u1 u2 u4", given)[:, 0].astype(
            np.int64
        )

    def read_uvs(
        self,
        number: int,
        transform: NDArray[np.float64] | None,
        corners: NDArray[np.int64],
        count: int,
        decoded: dict[Hashable, NDArray[np.float32] | None],
    ) -> NDArray[np.float32] | None:
        """Texture coordinates of corners, v upwards, or None. `decoded` are those of vertices, for other primitives."""
        name = f"TEXCOORD_{number}"
        for other in self._attributes:
            if other.startswith("TEXCOORD_") and other != name:
                self._left.add(f"the texture coordinates {other[:60]}")
        if name not in self._attributes:
            return None
        key = self.key, self._attributes[name], None if transform is None else transform.tobytes()
        if key not in decoded:
            try:
                uvs = self._array(name, ("VEC2",), _UV, count).astype(np.float32)
            except FileError as error:
                self._left.add(f"the texture coordinates {name} of {self._what}, because {error.reason}")
                decoded[key] = None
                return None
            with quiet():
                if transform is not None:
                    uvs = (uvs.astype(np.float64) @ transform[:, :2].T + transform[:, 2]).astype(np.float32)
                uvs[:, 1] = 1 - uvs[:, 1]
            decoded[key] = uvs
        found = decoded[key]
        return None if found is None else found[corners.reshape(-1)]
