"""Primitives: boxes, spheres, cylinders and other shapes. Their arrays equal Open3D's."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ...core.checks import check_count, check_finite, check_number, check_positive, check_shape
from ...core.coordinates import split_origin
from ...core.devices import DeviceLike, resolve_device
from ...kernels.lang import vec2, vec3, vec3i
from ...kernels.memory import upload
from . import shape_arrays as shapes
from .measures import compute_vertex_normals
from .mesh_arrays import Mesh
from .shape_arrays import Shape

MAX_LENGTH = 1e30  # [m] limit of lengths: float32 with margin for sums
MAX_VERTICES = 2**22  # more than an image can resolve


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
    return mesh_of_shape(kind, shapes.box(x, y, z, bool(map_texture_to_each_face)), device, with_uvs=create_uv_map)


def create_plane(kind: type[Mesh], width: float, height: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_plane`."""
    return mesh_of_shape(
        kind, shapes.plane(*positive_lengths(width=width, height=height)), device, with_uvs=create_uv_map
    )


def create_tetrahedron(kind: type[Mesh], radius: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_tetrahedron`."""
    return mesh_of_shape(kind, shapes.tetrahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)


def create_octahedron(kind: type[Mesh], radius: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_octahedron`."""
    return mesh_of_shape(kind, shapes.octahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)


def create_icosahedron(kind: type[Mesh], radius: float, create_uv_map: bool, *, device: DeviceLike) -> Mesh:
    """As `TriangleMesh.create_icosahedron`."""
    return mesh_of_shape(kind, shapes.icosahedron(*positive_lengths(radius=radius)), device, with_uvs=create_uv_map)


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
    ball = shapes.sphere(1.0, steps)
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
    return mesh_of_shape(kind, shapes.cylinder(*sizes, *counts), device, with_uvs=create_uv_map)


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
    return mesh_of_shape(kind, shapes.cone(*sizes, *counts), device, with_uvs=create_uv_map)


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
    return mesh_of_shape(kind, shapes.torus(*radii, *counts), device)


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
    parts = [shapes.sphere(0.06 * length, 20), *arrows]
    colors = [[0.5, 0.5, 0.5], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
    mesh = compute_vertex_normals(mesh_of_shape(kind, shapes.joined(parts), device))
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
    return mesh_of_shape(kind, shapes.mobius(columns, rows, half_twists, around, flat, breadth, factor), device)


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
    stem = shapes.moved(shapes.cylinder(shaft_radius, shaft, resolution, below), (0, 0, shaft * 0.5))
    tip = shapes.moved(shapes.cone(head_radius, head, resolution, above), (0, 0, shaft))
    return shapes.joined([stem, tip])
