"""Files of meshes of tensors: those of `loom.read_triangle_mesh`, and .npz archives with Open3D's names."""

from __future__ import annotations

import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....core.atomic import atomic_write
from ....core.checks import check_textures
from ....core.errors import FileError, FilePath, values_of_file
from ....core.escaped_text import escaped
from ....core.paths import path_of
from ....io.points.npz import read_arrays
from ....meshing.mesh import mesh_files
from ...core.dtype import float32, float64, int64
from ...core.tensor import Tensor
from ...io.shapes import read_native_mesh
from ..geometry.triangle_mesh import TriangleMesh
from .attributes import check_attribute_names, set_attribute

NPZ = ".npz"
KINDS = ("vertex", "triangle")
PRIMARY = {"vertex_positions": "vertices", "triangle_indices": "triangles"}  # names in .npz archives


def read_triangle_mesh(
    filename: FilePath, enable_post_processing: bool = False, print_progress: bool = False
) -> TriangleMesh:
    """Read a mesh with float32 positions, float64 far from zero, and the vertices of `o3d.io.read_triangle_mesh`.

    Its first texture is the texture map "albedo".

    Raises FileError if the file is missing or damaged.
    """
    if Path(filename).suffix.lower() == NPZ:
        return _read_npz(filename)
    native = read_native_mesh(filename)
    if len(native.textures) > 1:
        message = f"{filename}: {len(native.textures)} textures, of which the first is kept"
        warnings.warn(escaped(message), stacklevel=2)
    check_attribute_names(filename, "vertex", native.vertex_attributes, "positions")
    check_attribute_names(filename, "triangle", native.triangle_attributes, "indices")
    mesh = TriangleMesh.from_native(native, float64 if native.origin.any() else float32, int64)
    mesh.set_texture(native.textures[0] if native.textures else None)
    return mesh


def write_triangle_mesh(
    filename: FilePath,
    mesh: TriangleMesh,
    write_ascii: bool = False,
    compressed: bool = False,
    write_vertex_normals: bool = True,
    write_vertex_colors: bool = True,
    write_triangle_uvs: bool = True,
    print_progress: bool = False,
) -> bool:
    """Write a mesh with the texture map "albedo" of its material. Only .npz files keep triangle normals."""
    if not isinstance(mesh, TriangleMesh):
        raise TypeError(f"mesh: expected an o3d.t.geometry.TriangleMesh, got {type(mesh).__name__}")
    if Path(filename).suffix.lower() == NPZ:
        _write_npz(filename, mesh)
        return True
    native = mesh.textured()
    native.triangle_attributes.pop("normals", None)  # computed
    mesh_files.write_triangle_mesh(
        filename,
        native,
        write_ascii=write_ascii,
        write_vertex_normals=write_vertex_normals,
        write_vertex_colors=write_vertex_colors,
        write_triangle_uvs=write_triangle_uvs,
        up="y",  # Open3D does not rotate
    )
    return True


def _read_npz(filename: FilePath) -> TriangleMesh:
    arrays = read_arrays(path_of(filename, "filename"))
    if not {"vertices", "triangles"} <= arrays.keys():
        raise FileError(filename, f"expected vertices and triangles, got {', '.join(arrays) or 'no arrays'}")
    vertices, triangles = arrays.pop("vertices"), arrays.pop("triangles")
    _check_surface(filename, vertices, triangles)
    with values_of_file(filename):
        mesh = TriangleMesh(Tensor(vertices), Tensor(triangles))
        texture = arrays.pop("tex_albedo", None)
        mesh.set_texture(None if texture is None else check_textures("tex_albedo", [texture])[0])
    counts = {"vertex": len(vertices), "triangle": len(triangles)}
    for name, values in arrays.items():
        kind, _, attribute = name.partition("_")
        if kind in counts:
            if values.shape[:1] != (counts[kind],):
                reason = f"expected {counts[kind]} rows, got the shape {list(values.shape)}"
                raise FileError(filename, reason, where=f"array {name}")
            set_attribute(filename, getattr(mesh, kind), attribute, values)
        elif name != "material_name":
            message = f"{filename}: {name} is dropped; a mesh has vertex_* and triangle_* arrays"
            warnings.warn(escaped(message), stacklevel=3)
    return mesh


def _check_surface(filename: FilePath, vertices: NDArray[Any], triangles: NDArray[Any]) -> None:
    """Raise FileError unless vertices are finite, and triangles are indices of them."""
    if vertices.dtype.kind != "f" or vertices.shape[1:] != (3,) or vertices.ndim != 2:
        reason = f"expected floats of shape [n, 3], got {vertices.dtype} {list(vertices.shape)}"
        raise FileError(filename, reason, where="array vertices")
    if not np.isfinite(vertices).all():
        row = int(np.flatnonzero(~np.isfinite(vertices).all(axis=1))[0])
        raise FileError(
            filename, f"expected finite numbers, got {vertices[row].tolist()}", where=f"vertices, row {row}"
        )
    if triangles.dtype.kind not in "iu" or triangles.shape[1:] != (3,) or triangles.ndim != 2:
        reason = f"expected integers of shape [m, 3], got {triangles.dtype} {list(triangles.shape)}"
        raise FileError(filename, reason, where="array triangles")
    is_valid = ((triangles >= 0) & (triangles < len(vertices))).all(axis=1)
    if not is_valid.all():
        row = int(np.flatnonzero(~is_valid)[0])
        reason = f"expected indices of {len(vertices)} vertices, got {triangles[row].tolist()}"
        raise FileError(filename, reason, where=f"triangles, row {row}")


def _write_npz(filename: FilePath, mesh: TriangleMesh) -> None:
    arrays = {
        PRIMARY.get(f"{of}_{name}", f"{of}_{name}"): tensor.numpy()
        for of in KINDS
        for name, tensor in getattr(mesh, of).items()
    }
    if (texture := mesh.texture) is not None:
        arrays |= {
            "tex_albedo": texture,
            "material_name": np.frombuffer(mesh.material.material_name.encode(), np.uint8),
        }
    with atomic_write(filename) as file:
        np.savez(file, **arrays)
