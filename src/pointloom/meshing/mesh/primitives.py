"""Primitives: boxes, spheres, cylinders and other shapes. Their arrays are those of Open3D, made in NumPy."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_count, check_finite, check_number, check_positive, check_shape
from ...core.coordinates import split_origin
from ...core.devices import DeviceLike, resolve_device
from ...kernels.lang import vec2, vec3, vec3i
from ...kernels.memory import upload
from .measures import compute_vertex_normals
from .mesh_arrays import Mesh

MAX_LENGTH = 1e30  # [m] limit of lengths: float32 with margin for sums
MAX_VERTICES = 2**22  # more than an image can resolve
_BOX_TRIANGLES = (
    (4, 7, 5), (4, 6, 7), (0, 2, 4), (2, 6, 4), (0, 1, 2), (1, 3, 2),
    (1, 5, 7), (1, 7, 3), (2, 3, 7), (2, 7, 6), (0, 4, 1), (1, 4, 5),
)  # fmt: skip
# In quarters of the image: the faces of the unfolded box.
_BOX_UVS = (
    2, 2, 3, 3, 2, 3,  2, 2, 3, 2, 3, 3,  1, 2, 1, 1, 2, 2,  1, 1, 2, 1, 2, 2,
    1, 2, 1, 3, 0, 2,  1, 3, 0, 3, 0, 2,  1, 3, 2, 3, 2, 4,  1, 3, 2, 4, 1, 4,
    1, 1, 1, 0, 2, 0,  1, 1, 2, 0, 2, 1,  1, 2, 2, 2, 1, 3,  1, 3, 2, 2, 2, 3,
)  # fmt: skip
_EACH_FACE = (
    0, 0, 1, 1, 1, 0,  0, 0, 0, 1, 1, 1,  0, 0, 0, 1, 1, 0,  0, 1, 1, 1, 1, 0,
    0, 0, 1, 0, 0, 1,  1, 0, 1, 1, 0, 1,  0, 0, 1, 0, 1, 1,  0, 0, 1, 1, 0, 1,
    0, 0, 1, 0, 1, 1,  0, 0, 1, 1, 0, 1,  0, 0, 0, 1, 1, 0,  1, 0, 0, 1, 1, 1,
)  # fmt: skip
_ICOSAHEDRON_UVS = (
    (0, 4, 1), (0, 1, 5), (1, 4, 9), (1, 9, 10), (1, 10, 5), (0, 8, 4), (0, 11, 8), (0, 5, 11), (5, 6, 11), (5, 10, 6),
    (4, 8, 7), (4, 7, 9), (3, 6, 2), (3, 2, 7), (2, 6, 10), (2, 10, 9), (2, 9, 7), (3, 11, 6), (3, 8, 11), (3, 7, 8),
)  # fmt: skip
# Columns and half rows of the triangles of edge 2/11 into which Open3D divides the image, corner by corner.
_ICOSAHEDRON_AT = (
    0, 2, 1, 1, 1, 3,  0, 4, 1, 3, 1, 5,  1, 3, 1, 1, 2, 2,  1, 3, 2, 2, 2, 4,  1, 3, 2, 4, 1, 5,
    0, 10, 1, 9, 1, 11,  0, 8, 1, 7, 1, 9,  0, 6, 1, 5, 1, 7,  1, 5, 2, 6, 1, 7,  1, 5, 2, 4, 2, 6,
    1, 11, 1, 9, 2, 10,  1, 1, 2, 0, 2, 2,  2, 8, 2, 6, 3, 7,  2, 8, 3, 9, 2, 10,  3, 5, 2, 6, 2, 4,
    3, 3, 2, 4, 2, 2,  3, 1, 2, 2, 2, 0,  2, 8, 1, 7, 2, 6,  2, 8, 1, 9, 1, 7,  2, 8, 2, 10, 1, 9,
)  # fmt: skip
_UV_COLUMNS = (0.0001, 0.1575, 0.3149, 0.4724)
_UV_ROWS = (0.0001, 0.091, 0.1819, 0.2728, 0.3637, 0.4546, 0.5454, 0.6363, 0.7272, 0.8181, 0.909, 0.9999)


class Shape(NamedTuple):
    """Vertices float64 (m, 3), triangles (t, 3), and texture coordinates of their corners, (3 t, 2)."""

    vertices: NDArray[Any]
    triangles: NDArray[Any]
    uvs: NDArray[Any]


def create_box(
    kind: type[Mesh],
    width: float,
    height: float,
    depth: float,
    create_uv_map: bool,
    map_texture_to_each_face: bool,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_box`."""
    x, y, z = positive_lengths(width=width, height=height, depth=depth)
    return mesh_of_shape(kind, box(x, y, z, bool(map_texture_to_each_face)), device, with_uvs=create_uv_map)


def create_plane(kind: type[Mesh], width: float, height: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_plane`."""
    return mesh_of_shape(kind, plane(*positive_lengths(width=width, height=height)), device, with_uvs=create_uv_map)


def create_tetrahedron(kind: type[Mesh], radius: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_tetrahedron`."""
    return mesh_of_shape(kind, tetrahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)


def create_octahedron(kind: type[Mesh], radius: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_octahedron`."""
    return mesh_of_shape(kind, octahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)


def create_icosahedron(kind: type[Mesh], radius: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_icosahedron`."""
    return mesh_of_shape(kind, icosahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)


def create_sphere(kind: type[Mesh], radius: float, resolution: int, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_sphere`."""
    (r,) = positive_lengths(radius=radius)
    return create_ellipsoid(kind, r, r, r, resolution, create_uv_map, device=device)


def create_ellipsoid(
    kind: type[Mesh],
    radius_x: float,
    radius_y: float,
    radius_z: float,
    resolution: int,
    create_uv_map: bool,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_ellipsoid`."""
    radii = positive_lengths(radius_x=radius_x, radius_y=radius_y, radius_z=radius_z)
    steps = check_count("resolution", resolution, minimum=2)
    check_vertex_count("resolution", 2 * steps * (steps - 1) + 2)
    ball = sphere(1.0, steps)
    return mesh_of_shape(kind, ball._replace(vertices=ball.vertices * radii), device, with_uvs=create_uv_map)


def create_cylinder(
    kind: type[Mesh],
    radius: float,
    height: float,
    resolution: int,
    split: int,
    create_uv_map: bool,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_cylinder`."""
    sizes = positive_lengths(radius=radius, height=height)
    counts = checked_counts(resolution=(resolution, 3), split=(split, 1))
    check_vertex_count("resolution, split", counts[0] * (counts[1] + 1) + 2)
    return mesh_of_shape(kind, cylinder(*sizes, *counts), device, with_uvs=create_uv_map)


def create_cone(
    kind: type[Mesh],
    radius: float,
    height: float,
    resolution: int,
    split: int,
    create_uv_map: bool,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_cone`."""
    sizes = positive_lengths(radius=radius, height=height)
    counts = checked_counts(resolution=(resolution, 3), split=(split, 1))
    check_vertex_count("resolution, split", counts[0] * counts[1] + 2)
    return mesh_of_shape(kind, cone(*sizes, *counts), device, with_uvs=create_uv_map)


def create_torus(
    kind: type[Mesh],
    torus_radius: float,
    tube_radius: float,
    radial_resolution: int,
    tubular_resolution: int,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_torus`."""
    radii = positive_lengths(torus_radius=torus_radius, tube_radius=tube_radius)
    counts = checked_counts(radial_resolution=(radial_resolution, 3), tubular_resolution=(tubular_resolution, 3))
    check_vertex_count("radial_resolution, tubular_resolution", counts[0] * counts[1])
    return mesh_of_shape(kind, torus(*radii, *counts), device)


def create_arrow(
    kind: type[Mesh],
    cylinder_radius: float,
    cone_radius: float,
    cylinder_height: float,
    cone_height: float,
    resolution: int,
    cylinder_split: int,
    cone_split: int,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_arrow`."""
    sizes = positive_lengths(
        cylinder_radius=cylinder_radius,
        cone_radius=cone_radius,
        cylinder_height=cylinder_height,
        cone_height=cone_height,
    )
    counts = checked_counts(resolution=(resolution, 3), cylinder_split=(cylinder_split, 1), cone_split=(cone_split, 1))
    check_vertex_count("resolution, cylinder_split, cone_split", counts[0] * (counts[1] + counts[2] + 1) + 4)
    return mesh_of_shape(kind, _arrow(*sizes, *counts), device)


def create_coordinate_frame(kind: type[Mesh], size: float, origin: ArrayLike, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_coordinate_frame`."""
    (length,) = positive_lengths(size=size)
    center = check_finite("origin", check_shape("origin", origin, (3,)))
    if np.abs(center).max() > MAX_LENGTH:
        raise ValueError(f"origin: expected coordinates up to {MAX_LENGTH:g} m, got {center.tolist()}")
    along_z = _arrow(0.035 * length, 0.06 * length, 0.8 * length, 0.2 * length, 20, 4, 1)
    x, y, z = along_z.vertices.T
    arrows = [along_z._replace(vertices=np.stack(axes, axis=1)) for axes in ((z, x, y), (y, z, x), (x, y, z))]
    parts = [sphere(0.06 * length, 20), *arrows]
    colors = [[0.5, 0.5, 0.5], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    mesh = compute_vertex_normals(mesh_of_shape(kind, joined(parts), device))
    mesh.vertex_colors = np.repeat(colors, [len(part.vertices) for part in parts], axis=0)
    local, anchor = split_origin(mesh.vertices + center)
    return mesh.with_arrays(vertices=upload(local, vec3, mesh.device), origin=anchor)


def create_mobius(
    kind: type[Mesh],
    length_split: int,
    width_split: int,
    twists: int,
    radius: float,
    flatness: float,
    width: float,
    scale: float,
    *,
    device: DeviceLike,
) -> Mesh:
    """As `TriangleMesh.create_mobius`."""
    columns, rows, half_twists = checked_counts(
        length_split=(length_split, 3), width_split=(width_split, 2), twists=(twists, 0)
    )
    around, breadth, factor = positive_lengths(radius=radius, width=width, scale=scale)
    flat = check_number("flatness", flatness)
    if flat == 0 or abs(flat) > MAX_LENGTH:
        raise ValueError(f"flatness: expected a number other than 0 up to {MAX_LENGTH:g}, got {flat:g}")
    check_vertex_count("length_split, width_split", columns * rows)
    return mesh_of_shape(kind, mobius(columns, rows, half_twists, around, flat, breadth, factor), device)


def mesh_of_shape(kind: type[Mesh], shape: Shape, device: DeviceLike, *, with_uvs: bool = False) -> Mesh:
    target = resolve_device(device)
    local, origin = split_origin(shape.vertices)
    made = {
        "vertices": upload(local, vec3, target),
        "triangles": upload(shape.triangles.astype(np.int32), vec3i, target),
        "triangle_uvs": upload(shape.uvs.astype(np.float32), vec2, target) if with_uvs else None,
    }
    return kind.from_device_arrays(made, origin)


def positive_lengths(**lengths: float) -> Any:
    return tuple(check_positive(name, value, maximum=MAX_LENGTH) for name, value in lengths.items())


def checked_counts(**counts: tuple[int, int]) -> Any:
    """Validate integers, each given with its minimum. Returns a tuple."""
    return tuple(check_count(name, value, minimum=minimum) for name, (value, minimum) in counts.items())


def check_vertex_count(names: str, vertex_count: int) -> None:
    """Raise ValueError if a shape has too many vertices; `names` are the arguments to report."""
    if vertex_count > MAX_VERTICES:
        raise ValueError(f"{names}: expected at most 2^22 vertices, got {vertex_count:,}. Use fewer steps")


def _arrow(
    shaft_radius: float, head_radius: float, shaft: float, head: float, resolution: int, below: int, above: int
) -> Shape:
    stem = moved(cylinder(shaft_radius, shaft, resolution, below), (0, 0, shaft * 0.5))
    tip = moved(cone(head_radius, head, resolution, above), (0, 0, shaft))
    return joined([stem, tip])


def box(width: float, height: float, depth: float, each_face: bool) -> Shape:
    """Box at the origin, with the image on each face or the unfolded box in the image."""
    corners = [[x, y, z] for y in (0, 1) for z in (0, 1) for x in (0, 1)]
    uvs = np.array(_EACH_FACE, float) if each_face else np.array(_BOX_UVS) / 4
    return Shape(np.array(corners) * [width, height, depth], np.array(_BOX_TRIANGLES), uvs.reshape(-1, 2))


def plane(width: float, height: float) -> Shape:
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])
    triangles = np.array([[0, 1, 2], [0, 2, 3]])
    return Shape(corners * [width, height, 0.0], triangles, corners[triangles.reshape(-1), :2].astype(float))


def tetrahedron(radius: float) -> Shape:
    a, b, c = np.sqrt(8 / 9), np.sqrt(2 / 9), np.sqrt(2 / 3)
    corners = [[a, 0, -1 / 3], [-b, c, -1 / 3], [-b, -c, -1 / 3], [0, 0, 1]]
    # three faces around one corner, the fourth beside them. 0.866 is the height of a triangle of edge 1
    at = [(0.866, 0.5), (0.433, 0.75), (0.433, 0.25), (0.866, 1.0), (0.866, 0.0), (0.0, 0.5)]
    order = [0, 1, 2, 0, 3, 1, 0, 2, 4, 2, 1, 5]
    return Shape(
        radius * np.array(corners), np.array([[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]), np.array(at)[order]
    )


def octahedron(radius: float) -> Shape:
    corners = np.concatenate([np.eye(3), -np.eye(3)])
    triangles = [[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [0, 5, 1], [1, 5, 3], [3, 5, 4], [4, 5, 0]]
    step = (0.0, 0.1444, 0.2887, 0.433, 0.5773)  # quarters of two heights of a triangle of edge 1/3
    upper = [(0, 3), (1, 2), (2, 3), (1, 2), (3, 2), (2, 3), (3, 2), (4, 3), (2, 3), (4, 3), (3, 4), (2, 3)]
    lower = [(0, 1), (2, 1), (1, 2), (1, 2), (2, 1), (3, 2), (3, 2), (2, 1), (4, 1), (4, 1), (2, 1), (3, 0)]
    return Shape(radius * corners, np.array(triangles), np.array([(step[u], v / 4) for u, v in upper + lower]))


def icosahedron(radius: float) -> Shape:
    """Twelve corners. Open3D's `radius` is half an edge, not the distance of the corners."""
    p = (1 + np.sqrt(5)) / 2
    corners = [
        [-1, 0, p], [1, 0, p], [1, 0, -p], [-1, 0, -p], [0, -p, 1], [0, p, 1],
        [0, p, -1], [0, -p, -1], [-p, -1, 0], [p, -1, 0], [p, 1, 0], [-p, 1, 0],
    ]  # fmt: skip
    at = np.array(_ICOSAHEDRON_AT).reshape(-1, 2)
    uvs = np.stack([np.array(_UV_COLUMNS)[at[:, 0]], np.array(_UV_ROWS)[at[:, 1]]], axis=1)
    return Shape(radius * np.array(corners), np.array(_ICOSAHEDRON_UVS), uvs)


def _band(rows: int, columns: int, first: int) -> tuple[NDArray[np.int64], NDArray[np.float64]]:
    """Triangles between `rows` + 1 closed rings, and their (row, column) coordinates."""
    i, j = (part.reshape(-1, 1) for part in np.mgrid[:rows, :columns])
    at = np.concatenate([i + 1, j, i, j + 1, i, j, i + 1, j, i + 1, j + 1, i, j + 1], axis=1).reshape(-1, 2)
    return (first + at[:, 0] * columns + at[:, 1] % columns).reshape(-1, 3), at.astype(float)


def _alternate(first: NDArray, second: NDArray) -> NDArray:
    """Interleave the rows of two arrays."""
    return np.stack([first, second], axis=1).reshape(-1, *first.shape[1:])


def sphere(radius: float, resolution: int) -> Shape:
    n = 2 * resolution
    alpha = (np.pi / resolution * np.arange(1, resolution))[:, None]
    theta = (np.pi / resolution * np.arange(n))[None, :]
    rings = [np.sin(alpha) * np.cos(theta), np.sin(alpha) * np.sin(theta), np.cos(alpha) + 0 * theta]
    vertices = np.concatenate([[[0, 0, 1], [0, 0, -1]], np.stack(rings, axis=-1).reshape(-1, 3)]) * radius
    j, last = np.arange(n), 2 + n * (resolution - 2)
    after = (j + 1) % n
    tops, bottoms = (2 + j, 2 + after), (last + after, last + j)
    caps = _alternate(np.stack([0 * j, *tops], axis=1), np.stack([0 * j + 1, *bottoms], axis=1))
    row, column = 1 / resolution, 1 / n
    middle = column / 2 + column * j
    upper = np.stack([0 * middle, middle, 0 * middle + row, column * j, 0 * middle + row, column * (j + 1)], axis=1)
    at_end = 0 * middle + row * (resolution - 1)
    lower = np.stack([0 * middle + 1, middle, at_end, column * (j + 1), at_end, column * j], axis=1)
    body, at = _band(resolution - 2, n, 2)
    uvs = np.concatenate([_alternate(upper, lower).reshape(-1, 2), np.add(at, [1, 0]) * [row, column]])
    return Shape(vertices, np.concatenate([caps, body]), uvs)


def cylinder(radius: float, height: float, resolution: int, split: int) -> Shape:
    j = np.arange(resolution)
    theta = 2 * np.pi / resolution * j
    ring = np.stack([np.cos(theta), np.sin(theta)], axis=1)
    levels = height * 0.5 - height / split * np.arange(split + 1)
    rings = np.concatenate([np.tile(ring * radius, (split + 1, 1)), np.repeat(levels, resolution)[:, None]], axis=1)
    after, last = (j + 1) % resolution, 2 + resolution * split
    top = np.stack([0 * j, 2 + j, 2 + after], axis=1)
    bottom = np.stack([0 * j + 1, last + after, last + j], axis=1)
    here, next_one, middle = ring * 0.25, ring[after] * 0.25, np.zeros_like(ring)
    upper = np.add(np.stack([middle, here, next_one], axis=1), [0.75, 0.25])
    lower = np.add(np.stack([middle, next_one, here], axis=1), [0.75, 0.75])
    body, at = _band(split, resolution, 2)
    uvs = np.concatenate([_alternate(upper, lower).reshape(-1, 2), at * [1 / split, 1 / resolution]])
    ends = [[0, 0, height * 0.5], [0, 0, -height * 0.5]]
    return Shape(np.concatenate([ends, rings]), np.concatenate([_alternate(top, bottom), body]), uvs)


def cone(radius: float, height: float, resolution: int, split: int) -> Shape:
    j, i = np.arange(resolution), np.arange(split)
    theta = 2 * np.pi / resolution * j
    ring = np.stack([np.cos(theta), np.sin(theta)], axis=1)
    flat = (((split - i) / split)[:, None, None] * ring).reshape(-1, 2)
    rings = np.concatenate([radius * flat, np.repeat(height / split * i, resolution)[:, None]], axis=1)
    after, last = (j + 1) % resolution, 2 + resolution * (split - 1)
    bottom = np.stack([0 * j, 2 + after, 2 + j], axis=1)
    tip = np.stack([0 * j + 1, last + j, last + after], axis=1)
    row, column = (part.reshape(-1) for part in np.mgrid[: split - 1, :resolution])
    here = 2 + resolution * row
    there, column_after = here + resolution, (column + 1) % resolution
    first = np.stack([there + column_after, here + column, here + column_after], axis=1)
    second = np.stack([there + column_after, there + column, here + column], axis=1)
    triangles = np.concatenate([_alternate(bottom, tip), _alternate(first, second)])
    on_image = np.concatenate([np.zeros((2, 2)), 0.25 * flat])[triangles.reshape(-1)]
    middles = np.tile([0.5, 0.75], (len(on_image), 1))
    is_bottom = np.zeros(len(triangles), bool)
    is_bottom[: 2 * resolution : 2] = True
    middles[np.repeat(is_bottom, 3), 1] = 0.25
    return Shape(np.concatenate([[[0, 0, 0], [0, 0, height]], rings]), triangles, on_image + middles)


def torus(torus_radius: float, tube_radius: float, radial: int, tubular: int) -> Shape:
    """Rings around the tube. No texture coordinates."""
    u = (2 * np.pi / radial * np.arange(radial))[:, None]
    v = (2 * np.pi / tubular * np.arange(tubular))[None, :]
    away = torus_radius + tube_radius * np.cos(v)
    vertices = np.stack([away * np.cos(u), away * np.sin(u), tube_radius * np.sin(v) + 0 * u], axis=-1).reshape(-1, 3)
    i, j = (part.reshape(-1) for part in np.mgrid[:radial, :tubular])
    here, there = i * tubular, (i + 1) % radial * tubular
    after = (j + 1) % tubular
    first = np.stack([there + j, there + after, here + j], axis=1)
    second = np.stack([here + j, there + after, here + after], axis=1)
    return Shape(vertices, _alternate(first, second), np.empty((0, 2)))


def mobius(
    length_split: int, width_split: int, twists: int, radius: float, flatness: float, width: float, scale: float
) -> Shape:
    u = (2 * np.pi / length_split * np.arange(length_split))[:, None]
    v = (-width / 2 + width / (width_split - 1) * np.arange(width_split))[None, :]
    alpha = twists * 0.5 * u
    away = np.cos(alpha) * v + radius
    coordinates = [away * np.cos(u), away * np.sin(u), np.sin(alpha) * v * flatness]
    i, j = np.mgrid[:length_split, : width_split - 1]
    number = i * width_split + j
    here, beside = number, number + 1
    there = (i + 1) % length_split * width_split + j
    across = there + 1
    if twists % 2 == 1:  # the last piece meets the first one upside down
        there[-1], across[-1] = width_split - 1 - j[-1], width_split - 2 - j[-1]
    even = [[here, across, beside, here, there, across], [beside, here, there, beside, there, across]]
    corners = np.where((i + j) % 2 == 0, np.array(even[0]), np.array(even[1]))
    _orient_last(corners, twists, here, beside, there, across, i + j)
    return Shape(
        scale * np.stack(coordinates, axis=-1).reshape(-1, 3),
        corners.transpose(1, 2, 0).reshape(-1, 3),
        np.empty((0, 2)),
    )


def _orient_last(
    corners: NDArray, twists: int, here: NDArray, beside: NDArray, there: NDArray, across: NDArray, parity: NDArray
) -> None:
    """Last pieces of a strip, whose triangles Open3D starts at other corners."""
    a, b, c, d = here[-1], beside[-1], there[-1], across[-1]
    if twists % 2 == 1:
        even, odd = [d, a, b, c, a, d], [a, b, c, c, b, d]
    else:
        even, odd = [a, d, b, a, c, d], [a, c, b, b, c, d]
    corners[:, -1] = np.where(parity[-1] % 2 == 0, np.array(even), np.array(odd))


def moved(shape: Shape, shift: tuple[float, float, float]) -> Shape:
    return shape._replace(vertices=shape.vertices + shift)


def joined(shapes: list[Shape]) -> Shape:
    """Concatenate shapes, without texture coordinates."""
    begins = np.cumsum([0, *(len(shape.vertices) for shape in shapes)])
    triangles = [shape.triangles + begin for shape, begin in zip(shapes, begins, strict=False)]
    return Shape(np.concatenate([shape.vertices for shape in shapes]), np.concatenate(triangles), np.empty((0, 2)))
