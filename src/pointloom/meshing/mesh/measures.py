"""Measures of a mesh: normals, area, volume, bounds, hull, curvature, geodesics, mass."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import view_as
from ...core.checks import check_rows
from ...core.exchange import asnumpy, on_host
from ...kernels.arrays.bounds import bound_points
from ...kernels.arrays.select import gather_rows
from ...kernels.lang import float64, int32
from ...kernels.memory import contiguous, empty, upload
from ...kernels.meshes import mesh_measures
from ...kernels.meshes.geodesics import geodesic_distances
from ...kernels.meshes.mass_integrals import integrate_volume
from ...kernels.meshes.mesh_curvature import measure_curvatures
from ...kernels.meshes.surface_samples import triangle_areas
from ...kernels.surface.orientation import normalize_vectors
from ...pcd.boxes import AxisAlignedBoundingBox
from ...pcd.cloud import PointCloud
from .mesh_arrays import Mesh, MeshArrays
from .mesh_checks import check_finite_corners, check_finite_vertices, check_vertices
from .topology import check_solid
from .value_transfer import sew

SAME_NORMAL = 1e-3  # rounding of float32 normals


class MeshCurvature(NamedTuple):
    """`mean`, `gaussian` and principal (`least`, `largest`) curvatures of vertices [1/m, 1/m^2]. NaN if undefined."""

    mean: NDArray[np.float64]
    gaussian: NDArray[np.float64]
    least: NDArray[np.float64]
    largest: NDArray[np.float64]


def compute_vertex_normals(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.compute_vertex_normals`."""
    vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
    return mesh.with_arrays(vertex_normals=mesh_measures.vertex_normals(vertices, triangles))


def normalize_normals(mesh: Mesh) -> Mesh:
    """As `TriangleMesh.normalize_normals`."""
    if "vertex_normals" not in mesh.arrays:
        return mesh.copy()
    return mesh.with_arrays(vertex_normals=normalize_vectors(mesh.arrays["vertex_normals"]))


def compute_triangle_normals(mesh: MeshArrays) -> NDArray[np.float32]:
    """As `TriangleMesh.compute_triangle_normals`."""
    return mesh.arrays.hand_out(mesh_measures.triangle_normals(mesh.arrays["vertices"], mesh.arrays["triangles"]))


def check_triangle_normals(mesh: MeshArrays, values: ArrayLike) -> None:
    given = check_rows("triangle_normals", on_host("triangle_normals", values), 3, rows=len(mesh), dtype=np.float64)
    if not np.allclose(given, asnumpy(compute_triangle_normals(mesh)), rtol=0, atol=SAME_NORMAL, equal_nan=True):
        raise ValueError(
            "triangle_normals: expected the normals computed from the triangles, got others. "
            "Call orient_triangles() to flip triangles, or set vertex_normals for shading"
        )


def compute_triangle_areas(mesh: MeshArrays) -> NDArray[np.float64]:
    """As `TriangleMesh.compute_triangle_areas`."""
    return mesh.arrays.hand_out(triangle_areas(mesh.arrays["vertices"], mesh.arrays["triangles"]))


def get_surface_area(mesh: MeshArrays) -> float:
    """As `TriangleMesh.get_surface_area`."""
    check_finite_corners("get_surface_area", mesh)
    return finite_area(mesh)


def finite_area(mesh: MeshArrays) -> float:
    """Area of the triangles with finite corners [m^2]."""
    return mesh_measures.measure(mesh.arrays["vertices"], mesh.arrays["triangles"])[0]


def get_volume(mesh: MeshArrays) -> float:
    """As `TriangleMesh.get_volume`."""
    check_solid(mesh, "get_volume")
    return abs(signed_volume(mesh))


def signed_volume(mesh: MeshArrays) -> float:
    return mesh_measures.measure(mesh.arrays["vertices"], mesh.arrays["triangles"])[1]


def mass(mesh: MeshArrays, name: str) -> tuple[float, NDArray[np.float64], NDArray[np.float64]]:
    """Volume, center relative to the origin, and second moments; positive for an inward-facing mesh, too."""
    check_solid(mesh, name)
    if not len(mesh):
        raise ValueError(f"{name}: expected triangles that enclose a volume, got none")
    volume, center, second = integrate_volume(mesh.arrays["vertices"], mesh.arrays["triangles"])
    if volume == 0 or not np.isfinite(center).all():
        raise ValueError(
            f"{name}: expected a mesh that encloses a volume, got {volume:g}. "
            "Orient separate parts outward with orient_triangles(outward=True)"
        )
    return abs(volume), center, second if volume > 0 else -second


def moment_of_inertia(mesh: MeshArrays) -> NDArray[np.float64]:
    """As `TriangleMesh.moment_of_inertia`."""
    second = mass(mesh, "moment_of_inertia")[2]
    return np.eye(3) * np.trace(second) - second


def get_axis_aligned_bounding_box(mesh: MeshArrays) -> AxisAlignedBoundingBox:
    """As `TriangleMesh.get_axis_aligned_bounding_box`."""
    low, high, count = bound_points(mesh.arrays["vertices"])
    if not count:
        return AxisAlignedBoundingBox()
    origin = mesh.arrays.origin
    return AxisAlignedBoundingBox(low.astype(np.float64) + origin, high.astype(np.float64) + origin)


def corner_cloud(mesh: MeshArrays) -> PointCloud:
    """Vertices as a cloud that shares memory."""
    own = mesh.arrays
    return PointCloud.from_device_arrays({"points": own["vertices"]}, own.origin, own.library)


def compute_convex_hull(mesh: Mesh, joggle_inputs: bool) -> tuple[Mesh, NDArray[np.int64]]:
    """As `TriangleMesh.compute_convex_hull`."""
    hull, indices = corner_cloud(mesh).compute_convex_hull(joggle_inputs)
    make: Any = type(mesh)  # TriangleMesh
    made = make(hull.vertices, hull.triangles, device=mesh.device, origin=mesh.arrays.origin)
    made.arrays.library, made.unit, made.crs = mesh.arrays.library, mesh.unit, mesh.crs
    return made, indices


def compute_vertex_curvature(mesh: MeshArrays) -> MeshCurvature:
    """As `TriangleMesh.compute_vertex_curvature`."""
    sewn = sew(mesh)
    curvatures = measure_curvatures(sewn.mesh.arrays["vertices"], sewn.mesh.arrays["triangles"])
    columns: Any = view_as(curvatures, float64, (curvatures.size, 4))
    columns = [contiguous(columns[:, k]) if curvatures.size else empty(0, float64, mesh.device) for k in range(4)]
    parts = [sewn.spread(column) for column in columns]
    return MeshCurvature(*map(mesh.arrays.hand_out, parts))


def compute_geodesic_distances(mesh: MeshArrays, sources: ArrayLike) -> NDArray[np.float64]:
    """As `TriangleMesh.compute_geodesic_distances`."""
    vertices = mesh.arrays["vertices"]
    numbers = check_vertices("sources", sources, vertices.size)
    rows = upload(numbers, int32, mesh.device)
    check_finite_vertices("sources", numbers, gather_rows(vertices, rows))
    sewn = sew(mesh)
    arrays, rows = sewn.mesh.arrays, rows if sewn.sewn_indices is None else gather_rows(sewn.sewn_indices, rows)
    return mesh.arrays.hand_out(sewn.spread(geodesic_distances(arrays["vertices"], arrays["triangles"], rows)))
