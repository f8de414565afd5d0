"""Swept shapes: extrusions, polygons, solids of revolution, in NumPy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import (
    check_count,
    check_direction,
    check_finite,
    check_number,
    check_numeric,
    check_rows,
    check_shape,
    shown,
)
from ...core.coordinates import split_origin
from ...core.devices import DeviceLike
from ...kernels.lang import int32, vec3, vec3i
from ...kernels.linear_algebra import matmul, norm
from ...kernels.memory import upload
from .measures import compute_vertex_normals
from .mesh_arrays import Mesh
from .mesh_store import TEXTURE
from .outlines import fill_loops, loops_to_reverse, signed_area
from .primitives import Shape, check_vertex_count, mesh_of_shape

SAME_AREA = 1e-6  # of a polygon's area: tolerance of its triangulation
LARGEST_STEP = 1e30  # [m] or factor: float32 ends at 3e38


def extrude_linear(mesh: Mesh, vector: ArrayLike, scale: float, capping: bool) -> Mesh:
    """As `TriangleMesh.extrude_linear`."""
    shift = check_finite("vector", check_shape("vector", vector, (3,))) * check_length("scale", scale)
    if not shift.any():
        raise ValueError("vector: expected a vector of nonzero length, got zero")
    corners = mesh.vertices
    return _swept(mesh, np.stack([corners, corners + shift]), False, bool(capping))


def extrude_rotation(
    mesh: Mesh, angle: float, axis: ArrayLike, resolution: int, translation: float, capping: bool
) -> Mesh:
    """As `TriangleMesh.extrude_rotation`."""
    direction = check_direction("axis", axis)
    full_angle, rise = np.radians(check_length("angle", angle)), check_length("translation", translation)
    if not full_angle:
        raise ValueError("angle: expected a nonzero angle, got 0")
    steps = check_count("resolution", resolution, minimum=1)
    corners = mesh.vertices
    check_vertex_count("resolution", (steps + 1) * len(corners))
    fractions = np.linspace(0, 1, steps + 1)[:, None, None]
    along = matmul(corners, direction)[:, None] * direction
    across, side = corners - along, np.cross(direction, corners)
    rings = (
        along
        + np.cos(full_angle * fractions) * across
        + np.sin(full_angle * fractions) * side
        + rise * fractions * direction
    )
    is_closed = not rise and abs(abs(float(angle)) - 360) < 1e-9 and steps > 2
    if not rise:
        radii = np.linalg.norm(across, axis=1)
        rings[:, radii <= 1e-7 * np.abs(corners).max(initial=0)] = corners[
            radii <= 1e-7 * np.abs(corners).max(initial=0)
        ]
    return _swept(mesh, rings, is_closed, bool(capping) and not is_closed)


def from_polygon(kind: type[Mesh], outline: ArrayLike, holes: Sequence[ArrayLike], *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.from_polygon`."""
    if not isinstance(holes, Sequence | np.ndarray) or isinstance(holes, str | bytes) or getattr(holes, "ndim", 1) == 0:
        raise TypeError(f"holes: expected a list of outlines, got {shown(holes)}")
    loops = [check_ring("outline", outline), *(check_ring("holes", hole) for hole in holes)]
    if len({loop.shape[1] for loop in loops}) > 1:
        raise ValueError("holes: expected the same number of coordinates per corner as the outline")
    vertices = np.concatenate(loops)
    flat = flatten_outline(vertices, len(loops[0]))
    parts = np.split(flat, np.cumsum([len(loop) for loop in loops])[:-1])
    is_reversed = loops_to_reverse(parts)
    order = np.split(np.arange(len(flat)), np.cumsum([len(loop) for loop in loops])[:-1])
    order = [rows[::-1] if reverse else rows for rows, reverse in zip(order, is_reversed, strict=True)]
    triangles = np.concatenate(order)[fill_loops("from_polygon", [flat[rows] for rows in order])]
    check_area(flat, order, triangles)
    if vertices.shape[1] == 2:
        vertices = np.c_[vertices, np.zeros(len(vertices))]
    return mesh_of_shape(kind, Shape(vertices, triangles, np.zeros((0, 2))), device)


def revolve(kind: type[Mesh], profile: ArrayLike, angle: float, resolution: int, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.revolve`."""
    line = check_finite("profile", check_rows("profile", profile, 2, dtype=np.float64))
    if len(line) < 2 or (line[:, 0] < 0).any():
        raise ValueError(f"profile: expected at least two points (radius >= 0, height), got {line.tolist()[:4]}")
    degrees, steps = check_number("angle", angle), check_count("resolution", resolution, minimum=3)
    if not 0 < abs(degrees) <= 360:
        raise ValueError(f"angle: expected a nonzero angle from -360 to 360 degrees, got {degrees}")
    is_ring = len(line) > 2 and bool((line[0] == line[-1]).all())
    line = line[:-1] if is_ring else line
    check_vertex_count("profile, resolution", (steps + 1) * len(line))
    angles = np.radians(degrees) * np.linspace(0, 1, steps + 1)
    radius, height = line.T
    rings = np.stack(
        [np.outer(np.cos(angles), radius), np.outer(np.sin(angles), radius), np.tile(height, (steps + 1, 1))], -1
    )
    first = np.arange(len(line) - (not is_ring))
    pairs = np.c_[first, (first + 1) % len(line)]
    if degrees < 0:
        pairs = pairs[:, ::-1]
    numbers = number_ring_vertices(rings, abs(degrees) == 360)
    used, triangles = used_vertices(wall_triangles(numbers, pairs))
    return mesh_of_shape(kind, Shape(rings.reshape(-1, 3)[used], triangles, np.zeros((0, 2))), device)


def _swept(mesh: Mesh, rings: NDArray[np.float64], is_closed: bool, capping: bool) -> Mesh:
    """Join copies of the vertices at k positions, shape (k, m, 3), by walls along the border."""
    source_triangles = mesh.triangles.astype(np.int64)
    sides = source_triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)
    low, high = np.sort(sides, axis=1).T
    _, group, counts = np.unique(low * (len(mesh.vertices) + 1) + high, return_inverse=True, return_counts=True)
    on_border = np.flatnonzero(counts[group.reshape(-1)] == 1)
    numbers = number_ring_vertices(rings, is_closed)
    vertices = rings.reshape(-1, 3)
    ends = np.concatenate([numbers[0][source_triangles[:, ::-1]], numbers[-1][source_triangles]])
    walls = wall_triangles(numbers, sides[on_border])
    surface = walls if is_closed else np.concatenate([ends, walls])
    sources = np.concatenate(
        [
            np.arange(len(source_triangles)),
            np.arange(len(source_triangles)),
            np.tile(on_border // 3, 2 * (len(rings) - 1)),
        ]
    )
    keep = np.ones(len(surface), bool) if capping or is_closed else np.arange(len(surface)) >= 2 * len(source_triangles)
    sources = sources[2 * len(source_triangles) :] if is_closed else sources
    keep &= (surface != np.roll(surface, 1, axis=1)).all(axis=1)
    if signed_volume(vertices, surface) < 0:
        surface = surface[:, ::-1]
    used, triangles = used_vertices(surface[keep])
    return _with_copies(mesh, vertices[used], used % max(rings.shape[1], 1), triangles, sources[keep])


def _with_copies(
    mesh: Mesh, vertices: Any, of_vertices: NDArray[np.int64], triangles: Any, of_triangles: NDArray[np.int64]
) -> Mesh:
    """New vertices and triangles with attributes copied from this mesh, without normals and textures."""
    local, origin = split_origin(vertices)
    bare = mesh.with_arrays(vertex_normals=None, **dict.fromkeys(TEXTURE))
    arrays = bare.arrays.vertices_at(upload(of_vertices.astype(np.int32), int32, mesh.device))
    arrays |= bare.arrays.triangles_at(upload(of_triangles.astype(np.int32), int32, mesh.device))
    arrays["vertices"] = upload(local, vec3, mesh.device)
    arrays["triangles"] = upload(triangles.astype(np.int32), vec3i, mesh.device)
    swept = bare.with_arrays(**arrays, origin=origin)
    return compute_vertex_normals(swept) if "vertex_normals" in mesh.arrays else swept


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
