"""Plain Warp kernels of the comparison with Warp's own HashGrid and Mesh."""

from __future__ import annotations

from typing import Any

import warp as wp


@wp.kernel
def count_within(grid: wp.uint64, points: wp.array(dtype=wp.vec3), radius: float, counts: wp.array(dtype=int)):  # type: ignore[valid-type]
    """Count the points within a radius of each point, itself included."""
    k = wp.hash_grid_point_id(grid, wp.tid())
    point, count = points[k], wp.int32(0)
    for other in wp.hash_grid_query(grid, point, radius):
        if wp.length_sq(points[other] - point) < radius * radius:
            count += 1
    counts[k] = count


@wp.kernel
def find_closest(mesh: wp.uint64, queries: wp.array(dtype=wp.vec3), closest: wp.array(dtype=wp.vec3)):  # type: ignore[valid-type]
    """Find the closest point of a mesh to each query."""
    k = wp.tid()
    found = wp.mesh_query_point_no_sign(mesh, queries[k], 1.0e6)
    closest[k] = wp.mesh_eval_position(mesh, found.face, found.u, found.v)


@wp.kernel
def cast(mesh: wp.uint64, rays: wp.array2d(dtype=float), hits: wp.array(dtype=float)):  # type: ignore[valid-type]
    """Cast rays at a mesh: the distance to the first hit, infinite without one."""
    k = wp.tid()
    start = wp.vec3(rays[k, 0], rays[k, 1], rays[k, 2])
    direction = wp.vec3(rays[k, 3], rays[k, 4], rays[k, 5])
    length = wp.length(direction)
    found = wp.mesh_query_ray(mesh, start, direction / length, 1.0e6)
    hits[k] = wp.where(found.result, found.t / length, wp.inf)


def mesh_of(vertices: Any, triangles: Any, device: str) -> Any:
    """Warp's mesh with its tree."""
    points = wp.array(vertices, dtype=wp.vec3, device=device)
    return wp.Mesh(points, wp.array(triangles.ravel(), dtype=int, device=device))
