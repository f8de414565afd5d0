"""Meshes put together: one behind another."""

from __future__ import annotations

import warnings
from collections.abc import Iterable
from typing import Any, Self

from ...core.checks import check_list
from ...core.devices import check_same_device
from ...kernels.arrays.concatenation import concatenate_points, concatenate_rows
from ...kernels.lang import int32
from ...kernels.memory import zeros
from ...kernels.meshes.mesh_edits import raise_numbers, shift_triangles
from .mesh_arrays import MeshArrays
from .mesh_rows import ATTRIBUTES

MOST = 2**31 - 1  # vertices and triangles are counted in 32 bits


class MeshJoining(MeshArrays):
    """The part of TriangleMesh that puts meshes together."""

    def __add__(self, other: Any) -> Self:
        """The triangles of both meshes, see `concatenate`."""
        if not isinstance(other, MeshArrays):
            return NotImplemented
        return self.concatenate([self, other])

    def __radd__(self, other: Any) -> Self:
        """The mesh itself for 0, where `sum` begins."""
        if isinstance(other, int) and other == 0:
            return self.copy()
        return NotImplemented

    @classmethod
    def concatenate(cls, meshes: Iterable[MeshArrays]) -> Self:
        """The triangles of several meshes, one behind the other; nothing is merged, see `remove_duplicated_vertices`.

        Of normals, colours, textures and further attributes those are kept that all meshes have, as Open3D's `+` does;
        meshes without vertices have no say. Textures follow each other, and material numbers with them. The result
        takes the origin of the mesh with most vertices.

        Args:
            meshes: At least one, all on one device.

        Raises:
            ValueError: No mesh, an attribute whose columns differ, or more than 2^31 - 1 vertices or triangles.
            TypeError: Not meshes, or an attribute whose types differ.
            DeviceError: Meshes on different devices.

        Warns:
            UserWarning: Some meshes are textured and some are not, so textures are left out.

        Example:
            >>> import pointloom as loom
            >>> box = loom.TriangleMesh.create_box()
            >>> both = box + box.translate([2, 0, 0])
            >>> both.get_volume(), len(loom.TriangleMesh.concatenate([box] * 10))
            (2.0, 120)
        """
        given = check_list("meshes", meshes, "triangle meshes")
        if not given:
            raise ValueError("meshes: expected at least one mesh, got none")
        for mesh in given:
            if not isinstance(mesh, MeshArrays):
                raise TypeError(f"meshes: expected TriangleMesh, got {type(mesh).__name__}")
            check_same_device("meshes", mesh.device, given[0].device)
        parts = [mesh for mesh in given if mesh._arrays["vertices"].size] or given[:1]
        for name in ("vertices", "triangles"):
            if sum(mesh._arrays[name].size for mesh in parts) > MOST:
                raise ValueError(f"meshes: more than 2^31 - 1 {name}; keep them in several meshes")
        return cls._joined(parts)

    @classmethod
    def _joined(cls, parts: list[MeshArrays]) -> Self:
        origin = max(parts, key=lambda mesh: mesh._arrays["vertices"].size)._origin
        shifts = [mesh._origin - origin for mesh in parts]
        arrays: dict[str, Any] = {
            "vertices": concatenate_points([mesh._arrays["vertices"] for mesh in parts], shifts),
            "triangles": concatenate_rows(_numbered(parts)),
        }
        for name in ("vertex_normals", "vertex_colors"):
            if all(name in mesh._arrays for mesh in parts):
                arrays[name] = concatenate_rows([mesh._arrays[name] for mesh in parts])
        for kind in ATTRIBUTES:
            shared = [n for n in parts[0]._attributes[kind] if all(n in mesh._attributes[kind] for mesh in parts)]
            arrays[kind] = {
                name: _joined_columns(name, [mesh._attributes[kind][name] for mesh in parts]) for name in shared
            }
        return cls._from_device_arrays(**arrays | _joined_textures(parts), origin=origin, library=parts[0]._library)


def _numbered(parts: list[MeshArrays]) -> list[Any]:
    """The triangles of each mesh by the vertices of all."""
    numbered, start = [], 0
    for mesh in parts:
        triangles = mesh._arrays["triangles"]
        numbered.append(shift_triangles(triangles, start) if start else triangles)
        start += mesh._arrays["vertices"].size
    return numbered


def _joined_columns(name: str, columns: list[Any]) -> Any:
    """Values of one attribute behind one another."""
    first = columns[0]
    for column in columns:
        if column.dtype != first.dtype:
            kinds = f"{first.dtype.__name__} and {column.dtype.__name__}"
            raise TypeError(f"{name}: the meshes have it in {kinds}; convert one of them")
        if column.shape[1:] != first.shape[1:]:
            raise ValueError(
                f"{name}: the meshes have it in rows of {list(first.shape[1:])} and {list(column.shape[1:])}"
            )
    return concatenate_rows(columns)


def _joined_textures(parts: list[MeshArrays]) -> dict[str, Any]:
    """Texture coordinates, material numbers and pictures, as `_from_device_arrays` takes them."""
    triangled = [mesh for mesh in parts if len(mesh)]
    names = ("triangle_uvs", "triangle_material_ids")
    if any("triangle_uvs" in mesh._arrays for mesh in triangled):
        kinds = {("triangle_uvs" in mesh._arrays, bool(mesh._textures)) for mesh in triangled}
        if len(kinds) > 1:
            warnings.warn("textures: left out, as not all meshes have them", stacklevel=4)
            return {}
    joined: dict[str, Any] = {"textures": tuple(picture for mesh in triangled for picture in mesh._textures)}
    if triangled and "triangle_uvs" in triangled[0]._arrays:
        joined[names[0]] = concatenate_rows([mesh._arrays[names[0]] for mesh in triangled])
    has_pictures = bool(joined["textures"])
    if (has_pictures and len(triangled) > 1) or (triangled and all(names[1] in mesh._arrays for mesh in triangled)):
        ids, first = [], 0
        for mesh in triangled:
            own = mesh._arrays.get(names[1])
            own = zeros(len(mesh), int32, mesh._device) if own is None else own
            ids.append(raise_numbers(own, first) if first else own)
            first += len(mesh._textures)
        joined[names[1]] = concatenate_rows(ids)
    return joined
