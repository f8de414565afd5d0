"""Arrays of swept outlines: rings, walls, and checks of outlines."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_number, check_numeric, check_rows
from ...kernels.linear_algebra import matmul, norm
from .flat_polygons import signed_area

SAME_AREA = 1e-6  # of a polygon's area: tolerance of its triangulation
LARGEST_STEP = 1e30  # [m] or factor: float32 ends at 3e38


def check_length(name: str, value: object) -> float:
    """Validate a factor or length within float32."""
    number = check_number(name, value)
    if abs(number) > LARGEST_STEP:
        raise ValueError(f"{name}: expected a number up to {LARGEST_STEP:g}, got {number:g}")
    return number


def number_ring_vertices(rings: NDArray[np.float64], is_closed: bool) -> NDArray[np.int64]:
    """Vertex number at each position, (k, m). Vertices that do not move have one."""
    count, width = rings.shape[:2]
    numbers = np.arange(count * width).reshape(count, width)
    numbers[:, (rings == rings[0]).all(axis=(0, 2))] = numbers[:1, (rings == rings[0]).all(axis=(0, 2))]
    if is_closed:
        numbers[-1] = numbers[0]
    return numbers


def wall_triangles(numbers: NDArray[np.int64], lines: NDArray[np.int64]) -> NDArray[np.int64]:
    """Two triangles for each step of each line, (2 (k - 1) n, 3)."""
    a, b = numbers[:-1, lines[:, 0]], numbers[:-1, lines[:, 1]]
    c, d = numbers[1:, lines[:, 1]], numbers[1:, lines[:, 0]]
    return (
        np.concatenate(
            [
                np.stack(corners, -1)
                for pair in zip(a, b, c, d, strict=True)
                for corners in ((pair[0], pair[1], pair[2]), (pair[0], pair[2], pair[3]))
            ]
        )
        if len(a)
        else np.zeros((0, 3), np.int64)
    )


def used_vertices(triangles: NDArray[np.int64]) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """(used vertices, triangles renumbered to them)."""
    triangles = triangles[(triangles != np.roll(triangles, 1, axis=1)).all(axis=1)]
    used, numbers = np.unique(triangles, return_inverse=True)
    return used, numbers.reshape(-1, 3)


def signed_volume(vertices: NDArray[np.float64], triangles: NDArray[np.int64]) -> float:
    """Six times the volume inside the finite triangles, negative if inward."""
    corners = vertices[triangles]
    corners = corners[np.isfinite(corners).all(axis=(1, 2))]
    if not len(corners):
        return 0.0
    corners = corners - corners[0, 0]
    return float(np.einsum("ti,ti->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])))


def check_ring(name: str, points: ArrayLike) -> NDArray[np.float64]:
    """Validate an outline and drop a repeated first point."""
    given = check_numeric(name, points)
    width = 3 if given.ndim == 2 and given.shape[1] == 3 else 2
    ring = check_finite(name, check_rows(name, points, width, dtype=np.float64))
    if len(ring) > 1 and (ring[0] == ring[-1]).all():
        ring = ring[:-1]
    if len(ring) < 3:
        raise ValueError(f"{name}: expected at least three corners, got {len(ring)}")
    return ring


def flatten_outline(vertices: NDArray[np.float64], count: int) -> NDArray[np.float64]:
    """Project positions (n, 2) or (n, 3) to the plane of the first `count`."""
    if vertices.shape[1] == 2:
        return vertices - vertices[0]
    local = vertices - vertices[0]
    ring = local[:count]
    normal = np.cross(ring, np.roll(ring, -1, axis=0)).sum(axis=0)
    size, length = norm(normal), np.linalg.norm(np.roll(ring, -1, axis=0) - ring, axis=1).sum()
    if not size > 1e-12 * length**2:
        raise ValueError("outline: expected a simple polygon, got collinear corners or self-intersections")
    normal /= size
    off = np.abs(matmul(local, normal)).max()
    if off > 1e-6 * length:
        raise ValueError(f"outline, holes: expected coplanar corners, got corners up to {off:g} m off the plane")
    u = np.cross(np.eye(3)[np.abs(normal).argmin()], normal)
    u /= norm(u)
    return matmul(local, np.array([u, np.cross(normal, u)]).T)


def check_area(flat: NDArray[np.float64], order: list[Any], triangles: NDArray[np.int64]) -> None:
    a, b, c = flat[triangles].transpose(1, 0, 2)
    doubled = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    area = sum(signed_area(flat[rows]) for rows in order)
    scale = sum(abs(signed_area(flat[rows])) for rows in order)
    if not abs(np.abs(doubled).sum() / 2 - area) <= SAME_AREA * scale or not area > 0:
        raise ValueError("outline, holes: expected polygons that do not intersect themselves or each other")
