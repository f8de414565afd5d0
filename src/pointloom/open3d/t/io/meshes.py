"""Files of meshes of tensors: those of `loom.read_triangle_mesh`, and .npz archives with Open3D's names."""

from __future__ import annotations

import warnings
import zipfile
from pathlib import Path

import numpy as np

from ....core.atomic import atomic_write
from ....core.errors import FileError, FilePath
from ....core.paths import input_path
from ....meshing.mesh import mesh_files
from ...core.dtype import float32, float64, int64
from ...core.tensor import Tensor
from ..geometry.triangle_mesh import TriangleMesh

NPZ = ".npz"
KINDS = ("vertex", "triangle")
PRIMARY = {"vertex_positions": "vertices", "triangle_indices": "triangles"}  # names in .npz archives


def read_triangle_mesh(
    filename: FilePath, enable_post_processing: bool = False, print_progress: bool = False
) -> TriangleMesh:
    """Read a mesh with float32 positions, float64 far from zero. Its first texture is the texture map "albedo".

    Raises FileError if the file is missing or damaged.
    """
    if Path(filename).suffix.lower() == NPZ:
        return _read_npz(filename)
    native = mesh_files.read_triangle_mesh(filename)
    if len(native.textures) > 1:
        warnings.warn(f"{filename}: {len(native.textures)} textures, of which the first is kept", stacklevel=2)
    mesh = TriangleMesh._of(native, float64 if native.origin.any() else float32, int64)
    mesh._set_texture(native.textures[0] if native.textures else None)
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
    native = mesh._textured()
    native.triangle_attributes.pop("normals", None)  # computed
    mesh_files.write_triangle_mesh(
        filename,
        native,
        ascii=write_ascii,
        write_vertex_normals=write_vertex_normals,
        write_vertex_colors=write_vertex_colors,
        write_triangle_uvs=write_triangle_uvs,
    )
    return True


def _read_npz(filename: FilePath) -> TriangleMesh:
    path = input_path(filename)
    try:
        with np.load(path) as file:
            arrays = dict(file)
    except (OSError, ValueError, zipfile.BadZipFile) as error:
        raise FileError(filename, f"cannot be read as a mesh: {error}") from error
    if not {"vertices", "triangles"} <= arrays.keys():
        raise FileError(filename, f"expected vertices and triangles, got {', '.join(arrays) or 'no arrays'}")
    mesh = TriangleMesh(Tensor(arrays.pop("vertices")), Tensor(arrays.pop("triangles")))
    mesh._set_texture(arrays.pop("tex_albedo", None))
    for name, values in arrays.items():
        kind, _, attribute = name.partition("_")
        if kind in ("vertex", "triangle"):
            getattr(mesh, kind)[attribute] = Tensor(values)
        elif name != "material_name":
            warnings.warn(f"{filename}: {name} is dropped; a mesh has vertex_* and triangle_* arrays", stacklevel=3)
    return mesh


def _write_npz(filename: FilePath, mesh: TriangleMesh) -> None:
    arrays = {
        PRIMARY.get(f"{of}_{name}", f"{of}_{name}"): tensor.numpy()
        for of in KINDS
        for name, tensor in getattr(mesh, of).items()
    }
    if (texture := mesh._texture) is not None:
        arrays |= {
            "tex_albedo": texture,
            "material_name": np.frombuffer(mesh.material.material_name.encode(), np.uint8),
        }
    with atomic_write(filename) as file:
        np.savez(file, **arrays)
