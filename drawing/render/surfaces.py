"""What is drawn of meshes and voxel grids: `Triangles`, one for each texture."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.array_libraries import view_as
from ...kernels.lang import int32, vec2, vec3
from ...kernels.memory import empty, upload
from ...meshing.mesh.mesh import TriangleMesh
from ...meshing.mesh.voxel_grid import VoxelGrid
from ...pcd.cloud import PointCloud
from .outlines import Segments, upload_lines
from .parts import Part, Triangles

# The faces of a cube: the axis and side that they look to, and their corners counterclockwise seen from outside.
_FACES = (
    ((-1, 0, 0), ((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0))),
    ((1, 0, 0), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1))),
    ((0, -1, 0), ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1))),
    ((0, 1, 0), ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0))),
    ((0, 0, -1), ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0))),
    ((0, 0, 1), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))),
)


def mesh_parts(mesh: TriangleMesh, chosen: dict[str, Any]) -> list[Part]:
    """What is drawn of a mesh where it lies.

    Args:
        mesh: The mesh; its arrays are shared.
        chosen: Fields of `Triangles`; a `plain` colour and a `coloring` replace the mesh's own, textures too.
    """
    arrays, none = mesh._device_arrays, empty(0, vec3, mesh.device)
    held: dict[str, Any] = {
        "positions": arrays["vertices"],
        "origin": mesh.origin,
        "normals": arrays.get("vertex_normals", none),
        "colors": none if "plain" in chosen else arrays.get("vertex_colors", none),
        **chosen,
    }
    if "triangle_uvs" not in arrays or not mesh.textures or chosen.keys() & {"plain", "coloring"}:
        return [Triangles(indices=_flat(arrays["triangles"]), **held)]
    if "triangle_material_ids" not in arrays:
        uvs, texture = arrays["triangle_uvs"], mesh.textures[0]
        return [Triangles(indices=_flat(arrays["triangles"]), uvs=uvs, texture=texture, **held)]
    ids = np.asarray(mesh.triangle_material_ids)
    parts: list[Part] = []
    for number in np.unique(ids).tolist():
        taken = mesh._triangles_at(upload(np.flatnonzero(ids == number).astype(np.int32), int32, mesh.device))
        surface = (
            {"uvs": taken["triangle_uvs"], "texture": mesh.textures[number]} if number < len(mesh.textures) else {}
        )
        parts.append(Triangles(indices=_flat(taken["triangles"]), **surface, **held))
    return parts


def vertices_of(mesh: TriangleMesh) -> PointCloud:
    """The vertices of a mesh with what is known of them; normals, colours and attributes follow."""
    arrays = mesh._device_arrays
    renamed = {"vertices": "points", "vertex_normals": "normals", "vertex_colors": "colors"}
    held = {new: arrays[old] for old, new in renamed.items() if old in arrays}
    cloud = PointCloud._from_device_arrays(held, mesh.origin)
    for name, values in mesh.vertex_attributes.items():
        cloud[name] = values
    cloud.unit = mesh.unit
    return cloud


def _flat(triangles: Any) -> Any:
    """Triples of vertices as int32 [3 t], in the same memory."""
    return view_as(triangles, int32, (3 * triangles.size,))


def voxel_parts(grid: VoxelGrid, chosen: dict[str, Any], device: Any) -> list[Part]:
    """The outer faces of the voxels of a grid as shaded squares; with a wireframe, their edges too."""
    corners = outer_faces(grid)
    count, origin = len(corners), np.asarray(grid.origin, np.float64)
    first = 4 * np.arange(count)[:, None]
    indices = (first + np.array([0, 1, 2, 0, 2, 3])).ravel()
    local = corners.reshape(-1, 3) * grid.voxel_size
    none, wireframe = empty(0, vec3, device), chosen.pop("wireframe", False)
    held: dict[str, Any] = {"colors": none, "normals": none, "uvs": empty(0, vec2, device), "lit": True, **chosen}
    positions = upload(local, vec3, device)
    parts: list[Part] = [Triangles(positions, origin, upload(indices, int32, device), **held)]
    if wireframe and count:
        places, rows = np.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
        sides = rows.reshape(-1)[first + np.array([0, 1, 1, 2, 2, 3, 3, 0])].reshape(-1, 2)
        lines = np.unique(np.sort(sides, axis=1), axis=0)
        parts.append(upload_lines(Segments(places * grid.voxel_size + origin, lines), device))
    return parts


def outer_faces(grid: VoxelGrid) -> NDArray[np.int64]:
    """The faces between voxels that are occupied and such that are not, corners in voxels, shape [k, 4, 3]."""
    cells = np.asarray(grid.coordinates, np.int64)
    sizes = np.asarray(grid.counts, np.int64) + 2
    occupied = _keys(cells, sizes)  # ascending, as the coordinates are
    faces = []
    for side, corners in _FACES:
        asked = _keys(cells + side, sizes)
        place = np.searchsorted(occupied, asked).clip(max=max(len(cells) - 1, 0))
        open_cells = cells[occupied[place] != asked] if len(cells) else cells
        faces.append(open_cells[:, None] + np.array(corners))
    return np.concatenate(faces)


def _keys(cells: NDArray[np.int64], sizes: NDArray[np.int64]) -> NDArray[np.int64]:
    """A number for each cell of a grid that is one cell larger on each side."""
    x, y, z = (cells + 1).T
    return (x * sizes[1] + y) * sizes[2] + z
