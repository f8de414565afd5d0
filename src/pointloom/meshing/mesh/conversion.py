"""Meshes to and from trimesh, Open3D, PyVista and meshio.

Results are copies with float64 positions if the origin is not zero, else float32. One warning lists what the library
cannot store. `TriangleMesh(mesh)` and `from_any` are the inverse.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.devices import DeviceLike
from ...core.other_geometry import OtherGeometry, conversion_of, read_or_refuse, read_other
from ...core.to_other_libraries import UVS, import_library
from ...io.meshes.glb_writer import split_seams
from ...io.table import MeshTable
from ...io.triangulation import split_faces
from ...pcd.point_arrays import PointArrays
from .mesh_arrays import Mesh, MeshArrays


def from_open3d(kind: type[Mesh], mesh: object, *, device: DeviceLike, arrays: str | None) -> Mesh:
    """As `TriangleMesh.from_open3d`."""
    given = read_other(mesh)
    if given is None or given.corners is None or "open3d" not in type(mesh).__module__:
        remedy = conversion_of(mesh, expected="mesh")
        expected = "open3d.geometry or open3d.t.geometry TriangleMesh"
        raise TypeError(f"mesh: expected an {expected}, got {type(mesh)}{remedy}")
    make: Any = kind
    result: Mesh = make(given, device=device, arrays=arrays)
    return result


def to_open3d(mesh: MeshArrays) -> Any:
    """As `TriangleMesh.to_open3d`."""
    o3d, table = import_library("open3d"), mesh_table(mesh)
    vectors, of_numbers = o3d.utility.Vector3dVector, o3d.utility.Vector3iVector
    made = o3d.geometry.TriangleMesh(vectors(table.vertices.astype(np.float64)), of_numbers(table.triangles.copy()))
    if table.vertex_normals is not None:
        made.vertex_normals = vectors(table.vertex_normals.astype(np.float64))
    if table.vertex_colors is not None:
        made.vertex_colors = vectors(table.vertex_colors.astype(np.float64))
    if table.triangle_uvs is not None:
        made.triangle_uvs = o3d.utility.Vector2dVector(table.triangle_uvs.astype(np.float64))
        ids = table.triangle_material_ids
        numbers = np.zeros(len(table.triangles), np.int32) if ids is None else ids
        made.triangle_material_ids = o3d.utility.IntVector(numbers)
        flipped = [np.ascontiguousarray(np.flipud(image)) for image in table.textures]
        made.textures = [o3d.geometry.Image(image) for image in flipped]
    left_out = [*table.attributes, *(f"face {name}" for name in table.triangle_attributes)]
    OtherGeometry("open3d.geometry.TriangleMesh", table.vertices, left_out=left_out).warn()
    return made


def to_open3d_tensor(mesh: MeshArrays) -> Any:
    """As `TriangleMesh.to_open3d_tensor`."""
    o3d, table = import_library("open3d"), mesh_table(mesh)
    tensor, left_out = o3d.core.Tensor, []
    made = o3d.t.geometry.TriangleMesh(
        tensor(np.ascontiguousarray(table.vertices)), tensor(np.ascontiguousarray(table.triangles))
    )
    named = {"normals": table.vertex_normals, "colors": table.vertex_colors, **table.attributes}
    corners = None if table.triangle_uvs is None else table.triangle_uvs.reshape(-1, 3, 2)
    ids = None if table.triangle_material_ids is None else table.triangle_material_ids.reshape(-1, 1)
    of_faces = {"texture_uvs": corners, "material_ids": ids, **table.triangle_attributes}
    for target, columns in ((made.vertex, named), (made.triangle, of_faces)):
        for name, values in columns.items():
            if values is not None and values.dtype == np.float16:
                left_out.append(name)
            elif values is not None:
                rows = values[:, None] if values.ndim == 1 else values
                target[name] = tensor(np.ascontiguousarray(rows))
    if len(table.textures) == 1 and corners is not None:
        made.material.set_default_properties()
        made.material.material_name = "defaultLit"
        made.material.texture_maps["albedo"] = o3d.t.geometry.Image(tensor(table.textures[0].copy()))
    elif table.textures:
        left_out.append("textures")
    OtherGeometry("open3d.t.geometry.TriangleMesh", table.vertices, left_out=left_out).warn()
    return made


def other_geometry(mesh: MeshArrays, source: str) -> OtherGeometry:
    """All arrays for libraries whose texture coordinates are per vertex."""
    table = mesh_table(mesh)
    rows, triangles, uvs = split_seams(table)
    columns = {"normals": table.vertex_normals, "colors": table.vertex_colors, **table.attributes}
    named = {name: values[rows] for name, values in columns.items() if values is not None}
    normals, colors = named.pop("normals", None), named.pop("colors", None)
    faces = dict(table.triangle_attributes)
    if table.triangle_material_ids is not None:
        faces["material_ids"] = table.triangle_material_ids
    return OtherGeometry(
        source,
        table.vertices[rows],
        normals,
        colors,
        named if uvs is None else {**named, UVS: uvs},
        corners=triangles.reshape(-1),
        face_attributes=faces,
        textures=list(table.textures),
        unit=table.unit,
        crs=table.crs,
    )


def mesh_table(mesh: MeshArrays) -> MeshTable:
    """Mesh in file form: positions in float32 without an origin, else in float64 with the origin added."""
    return MeshTable(
        mesh.vertices if mesh.origin.any() else mesh.vertices.astype(np.float32),
        mesh.triangles,
        mesh.vertex_normals,
        mesh.vertex_colors,
        triangle_uvs=mesh.triangle_uvs,
        triangle_material_ids=mesh.triangle_material_ids,
        textures=mesh.textures,
        attributes=dict(mesh.vertex_attributes),
        triangle_attributes=dict(mesh.triangle_attributes),
        unit=mesh.unit,
        crs=mesh.crs,
        up=mesh.arrays.up,
    )


def mesh_arguments(name: str, given: object) -> dict[str, Any]:
    """Arguments of `TriangleMesh` for a mesh of another library. Empty for other objects, such as arrays."""
    if isinstance(given, PointArrays):
        remedy = conversion_of(given, expected="mesh")
        raise TypeError(f"{name}: expected an array or a mesh, got {type(given).__name__}{remedy}")
    other = read_or_refuse(name, given, "mesh")
    if other is None:
        return {}
    corners, count = other.corners, len(other.points)
    if corners is None:
        raise TypeError(
            f"{name}: expected an array or a mesh, got {other.source} without faces. loom.PointCloud(x) makes a cloud, "
            "and loom.meshing.create_surface(cloud) a mesh of it"
        )
    if corners.size and (corners.min() < 0 or corners.max() >= count):
        wrong = corners.max() if corners.max() >= count else corners.min()
        raise ValueError(f"{name}: a face of {other.source} refers to point {wrong}, but it has {count} points")
    lengths = other.lengths
    if lengths is not None and lengths.size and lengths.min() < 3:
        raise ValueError(f"{name}: a face of {other.source} has {lengths.min()} corners; at least 3 are needed")
    if lengths is None or (lengths == 3).all():
        at, repeats = np.arange(len(corners)).reshape(-1, 3), None
    else:
        at, repeats = split_faces(other.source, lengths, corners, other.points), lengths - 2
    other.warn()
    return {
        "vertices": other.points,
        "triangles": corners[at],
        "vertex_normals": other.normals,
        "vertex_colors": other.colors,
        "triangle_uvs": None if other.uvs is None else other.uvs[at.reshape(-1)],
        "triangle_material_ids": _repeated(other.material_ids, repeats),
        "textures": other.textures,
        "vertex_attributes": other.attributes,
        "triangle_attributes": {key: _repeated(values, repeats) for key, values in other.face_attributes.items()},
        "device": other.device,
        "reference": (other.unit, other.crs),
    }


def _repeated(values: NDArray[Any] | None, repeats: NDArray[Any] | None) -> NDArray[Any] | None:
    """Values of faces as values of their triangles."""
    return values if values is None or repeats is None else np.repeat(values, repeats, axis=0)
