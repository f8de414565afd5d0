"""`from_any`: clouds and meshes of other libraries."""

from __future__ import annotations

from typing import Any

from ...core.devices import DeviceLike
from ...core.other_geometry import read_or_refuse
from ...pcd.cloud import PointCloud
from .mesh import TriangleMesh


def from_any(geometry: object, *, device: DeviceLike = None, arrays: str | None = None) -> PointCloud | TriangleMesh:
    """Convert a cloud or a mesh of another library, with all its attributes. Nothing is imported for this.

    `PointCloud(x)`, `TriangleMesh(x)`, `render`, `draw`, `write_point_cloud` and `write_triangle_mesh` accept the same
    objects. The inverse are `to_open3d`, `to_open3d_tensor`, `to_trimesh`, `to_pyvista` and `to_meshio`.

    Args:
        geometry: A cloud or mesh of Open3D (legacy or tensor), trimesh, PyVista or meshio, a `vtkPolyData`, or a
            scene of trimesh with meshes. Or points, shape (n, 3). Clouds and meshes of pointloom are returned.
        device: Target device. If None: that of a GPU tensor, or the CPU.
        arrays: Library of returned arrays, as of `PointCloud`. If None: that of the points, or "numpy".

    Returns:
        A mesh if the object has faces, else a cloud. Polygons are triangulated. Colors in 0..255 or 0..1 are found by
        their type and range. Positions in float64 keep their precision through the origin.

    Raises:
        TypeError: If the object is none of these. The message names a conversion if there is one.
        ValueError: If it has only lines, strips or volumes, or if its arrays do not fit together.
        DeviceError: If the device does not exist.

    Warns:
        UserWarning: One warning with the names of all parts that are left out.

    Example:
        >>> import pointloom as loom, trimesh
        >>> loom.from_any(trimesh.creation.box())
        TriangleMesh(8 vertices, 12 triangles, cpu)
    """
    if isinstance(geometry, PointCloud | TriangleMesh):
        return geometry if device is None and arrays is None else geometry.to(device or geometry.device, arrays=arrays)
    if is_scene(geometry):
        scene: Any = geometry
        parts = [from_any(part, device=device, arrays=arrays) for part in scene.dump()]
        meshes = [part for part in parts if isinstance(part, TriangleMesh)]
        if not parts or len(meshes) < len(parts):
            raise TypeError(f"geometry: expected a scene of meshes, got {len(parts) - len(meshes)} other parts")
        return meshes[0] if len(meshes) == 1 else TriangleMesh.concatenate(meshes)
    other = read_or_refuse("geometry", geometry)
    given: Any = geometry if other is None else other
    if other is not None and other.corners is not None:
        return TriangleMesh(given, device=device, arrays=arrays)
    return PointCloud(given, device=device, arrays=arrays)


def is_scene(geometry: object) -> bool:
    """True for a scene of trimesh."""
    return type(geometry).__name__ == "Scene" and hasattr(geometry, "dump") and hasattr(geometry, "geometry")
