"""TriangleMesh: shared vertices and triangles on one device. Operations are inherited from one module per topic."""

from __future__ import annotations

import os
from collections.abc import Mapping
from typing import Any

from numpy.typing import ArrayLike

from ...core.argument_errors import explain_argument_errors
from ...core.array_libraries import NUMPY, library_for, library_of
from ...core.checks import check_rows, check_shape, is_on_gpu, shown
from ...core.coordinate_systems import is_in_degrees
from ...core.coordinates import choose_origin, split_origin, warn_if_coarse
from ...core.devices import DeviceLike, resolve_device
from ...core.gpu_arrays import take_corners, take_points
from ...io.table import MeshTable
from ...kernels.lang import vec3, vec3i
from ...kernels.memory import upload
from ...pcd.extent_text import reference_text
from .mesh_attributes import assign_all, listed
from .mesh_conversion import MeshConversion, mesh_arguments
from .mesh_mass import MeshMass
from .mesh_primitives import MeshPrimitives
from .mesh_reconstruction import MeshReconstruction
from .mesh_remeshing import MeshRemeshing
from .mesh_repair import MeshRepair
from .mesh_store import MeshStore
from .mesh_texture import MeshTexture


class TriangleMesh(
    MeshPrimitives, MeshMass, MeshRepair, MeshRemeshing, MeshReconstruction, MeshTexture, MeshConversion
):
    """A triangle mesh with optional vertex normals and colors, texture coordinates, textures and other attributes.

    float32 (int32 triangles) on one device, relative to a float64 `origin`. Operations return new meshes that share
    unchanged arrays, and arrays of the vertices' library (docs/arrays.md). `len(mesh)` counts triangles.

    Args:
        vertices: Positions [m], shape (m, 3). Or a mesh of trimesh, Open3D, PyVista, VTK or meshio, see `from_any`.
        triangles: Vertex indices, shape (t, 3), counterclockwise from outside.
        vertex_normals, vertex_colors: Shape (m, 3). Colors in 0..1.
        triangle_uvs: Texture coordinates of corners, shape (3 t, 2).
        triangle_material_ids: Texture index of each triangle, shape (t,).
        textures: Images, uint8 (height, width, 3 or 4).
        vertex_attributes, triangle_attributes: Other values by name, any number type, one row per vertex or triangle.
        device: "cpu", "cuda:N" or "auto". If None: the vertices' GPU, or the CPU.
        origin: Stored origin (3,). If None: zero, or near the median of vertices that are far from zero.
        arrays: Library of returned arrays: "numpy", "warp", "torch", "cupy" or "jax". If None: that of the vertices.

    Raises:
        TypeError: If an array is not numeric, or triangles are not integers.
        ValueError, DeviceError: If a shape or index is invalid, or if the device does not exist.
        ImportError: If the library of `arrays` is not installed.

    Example:
        >>> mesh = TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
        >>> mesh.get_surface_area()
        1.0
        >>> mesh.compute_vertex_normals().vertex_normals[0].tolist()
        [0.0, 0.0, 1.0]
    """

    @explain_argument_errors
    def __init__(
        self,
        vertices: ArrayLike = (),
        triangles: Any = (),
        *,
        vertex_normals: ArrayLike | None = None,
        vertex_colors: ArrayLike | None = None,
        triangle_uvs: ArrayLike | None = None,
        triangle_material_ids: ArrayLike | None = None,
        textures: Any = (),
        vertex_attributes: Mapping[str, Any] | None = None,
        triangle_attributes: Mapping[str, Any] | None = None,
        device: DeviceLike = None,
        origin: ArrayLike | None = None,
        arrays: str | None = None,
    ):
        _refuse_path(vertices)
        if given := mesh_arguments("vertices", vertices):
            own = {"vertex_normals": vertex_normals, "vertex_colors": vertex_colors, "triangle_uvs": triangle_uvs}
            own |= {"triangle_material_ids": triangle_material_ids, "vertex_attributes": vertex_attributes}
            own |= {"triangle_attributes": triangle_attributes, "device": device}
            unit, crs = given.pop("reference")
            given |= {name: values for name, values in own.items() if values is not None}
            if origin is None and is_in_degrees(unit, crs):
                origin = choose_origin(check_rows("vertices", given["vertices"], 3), in_degrees=True)
            vars(self).update(vars(TriangleMesh(**given, origin=origin, arrays=arrays)))
            self.unit, self.crs = unit, crs
            return
        library = library_for(arrays, vertices)
        anchor = None if origin is None else check_shape("origin", origin, (3,))
        if is_on_gpu(vertices):
            local, start = take_points("vertices", vertices, anchor)
            corners = take_corners(triangles, local.device, local.size)
        else:
            positions = check_rows("vertices", vertices, 3)
            if len(positions) >= 2**31:
                raise ValueError(f"vertices: {len(positions)} vertices exceed the range of 32-bit triangle indices")
            table = MeshTable(positions, triangles).checked()
            rows, start = split_origin(table.vertices, anchor)
            if anchor is None:
                warn_if_coarse("vertices", positions, start)
            where, is_copied = resolve_device(device), library_of(vertices) == NUMPY
            local = upload(rows, vec3, where, copied=is_copied)
            corners = upload(table.triangles, vec3i, where, copied=is_copied)
        vars(self)["arrays"] = MeshStore({"vertices": local, "triangles": corners}, start, library)
        for name, values in (("vertex_normals", vertex_normals), ("vertex_colors", vertex_colors)):
            if values is not None:
                self._assign(name, values)
        assign_all(self.vertex_attributes, vertex_attributes)
        assign_all(self.triangle_attributes, triangle_attributes)
        if triangle_uvs is not None:
            self.triangle_uvs = triangle_uvs
        if triangle_material_ids is not None:
            self.triangle_material_ids = triangle_material_ids
        self.textures = textures
        if device is not None and resolve_device(device) != self.device:  # arrays were on a GPU
            vars(self)["arrays"] = self.to(resolve_device(device)).arrays

    def __repr__(self) -> str:
        parts = [f"{self.arrays['vertices'].size} vertices", f"{len(self)} triangles"]
        parts += [name for name in self.arrays if name not in ("vertices", "triangles")]
        parts += [f"{kind}[{listed(columns)}]" for kind, columns in self.arrays.attributes.items() if columns]
        if self.unit is not None or self.crs is not None:  # bounds wait for the device
            parts.append(reference_text(self, self.get_min_bound(), self.get_max_bound()))
        return f"{type(self).__name__}({', '.join([*parts, str(self.device)])})"


def _refuse_path(vertices: ArrayLike) -> None:
    if isinstance(vertices, str | os.PathLike):
        remedy = "loom.read_triangle_mesh(path) reads a file"
        raise TypeError(f"vertices: expected real numbers, got {shown(vertices)}; {remedy}")
