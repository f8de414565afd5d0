"""Points sampled from the surface of a mesh."""

from __future__ import annotations

import math
from typing import Any

from ...core.checks import check_count, check_seed
from ...kernels.memory import check_room
from ...kernels.meshes.poisson_disk import CrowdedError, eliminate_samples
from ...kernels.meshes.surface_samples import SurfaceSamples
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from .mesh_arrays import MeshArrays
from .mesh_checks import check_finite_corners

SAMPLE_BYTES = 64  # per sampled point, with triangle, weights, normal and color
MAX_SAMPLES = 2**24  # initial points of Poisson disk sampling: about 4 GB with neighbors


def sample_points_uniformly(
    mesh: MeshArrays, number_of_points: int, use_triangle_normal: bool, seed: int
) -> PointCloud:
    """As `TriangleMesh.sample_points_uniformly`."""
    count, seed = check_count("number_of_points", number_of_points), check_seed(seed)
    return draw_samples(mesh, _surface(mesh, "sample_points_uniformly"), count, use_triangle_normal, seed)


def sample_points_poisson_disk(
    mesh: MeshArrays,
    number_of_points: int,
    init_factor: int,
    pcl: PointCloud | None,
    use_triangle_normal: bool,
    seed: int,
) -> PointCloud:
    """As `TriangleMesh.sample_points_poisson_disk`."""
    count, factor, seed = (
        check_count("number_of_points", number_of_points),
        check_count("init_factor", init_factor),
        check_seed(seed),
    )
    surface = _surface(mesh, "sample_points_poisson_disk")
    if pcl is None:
        name, advice = "number_of_points, init_factor", "use fewer"
        if count * factor > MAX_SAMPLES:
            raise ValueError(f"{name}: expected up to {MAX_SAMPLES:,} initial points, got {count * factor:,}; {advice}")
        start = draw_samples(mesh, surface, count * factor, use_triangle_normal, seed)
    else:
        check_cloud("pcl", pcl)
        name, advice = "pcl", "downsample it first, for example with pcl.random_down_sample"
        start = pcl.to(mesh.device)
        if len(start) > MAX_SAMPLES:
            raise ValueError(f"{name}: expected up to {MAX_SAMPLES:,} points, got {len(start):,}; {advice}")
    return _spread(start, count, surface.area, name, advice)


def check_surface(mesh: MeshArrays, surface: SurfaceSamples, operation: str) -> None:
    if not len(mesh):
        raise ValueError(f"{operation}: expected a mesh with triangles to sample, got none")
    check_finite_corners(operation, mesh)
    if not surface.area > 0:
        raise ValueError(
            f"{operation}: expected triangles with an area, but all {len(mesh)} triangles have "
            "coincident or collinear corners"
        )


def draw_samples(
    mesh: MeshArrays, surface: SurfaceSamples, count: int, use_triangle_normal: bool, seed: int
) -> PointCloud:
    check_room(mesh.device, count * SAMPLE_BYTES, f"number_of_points: {count:,} points and their intermediate arrays")
    surface.draw(count, seed)
    arrays: dict[str, Any] = {"points": surface.mix(mesh.arrays["vertices"])}
    if use_triangle_normal:
        arrays["normals"] = surface.triangle_normals()
    elif "vertex_normals" in mesh.arrays:
        arrays["normals"] = surface.mix(mesh.arrays["vertex_normals"], unit=True)
    if "vertex_colors" in mesh.arrays:
        arrays["colors"] = surface.mix(mesh.arrays["vertex_colors"])
    cloud = PointCloud.from_device_arrays(arrays, mesh.arrays.origin.copy(), mesh.arrays.library)
    cloud.unit, cloud.crs = mesh._unit, mesh._crs
    return cloud


def _surface(mesh: MeshArrays, operation: str) -> SurfaceSamples:
    surface = SurfaceSamples(mesh.arrays["vertices"], mesh.arrays["triangles"])
    check_surface(mesh, surface, operation)
    return surface


def _spread(start: PointCloud, count: int, area: float, name: str, advice: str) -> PointCloud:
    """Select `count` evenly spaced points; `name` is the argument reported in errors."""
    tree = start.search_tree()
    if tree.count < count:
        raise ValueError(f"{name}: expected at least number_of_points = {count} finite points, got {tree.count}")
    if tree.count == count:
        return start.remove_non_finite_points()
    widest = 2 * math.sqrt(area / count / (2 * math.sqrt(3)))  # hexagonal packing of discs with half this radius
    try:
        return start.select_rows(eliminate_samples(tree, count, widest))
    except CrowdedError as error:
        raise ValueError(
            f"{name}: expected up to 2^30 pairs of points closer than {widest:.3g} m, got {error.pair_count:,}; "
            f"{advice}"
        ) from error
