"""Conversion of Open3D geometries for drawing."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh.mesh import TriangleMesh
from ..geometry import Geometry, Image, RGBDImage
from ..wrapper import Wrapper, unwrap

Entry = dict[str, Any]


def drawn(geometry: object) -> Any:
    """The pointloom geometry, of tensor geometries, too. Images become textured surfaces. Raises TypeError."""
    if not isinstance(geometry, Wrapper) and type(geometry).__module__.startswith("open3d."):
        raise TypeError(f"geometry: expected one of pointloom.open3d's, got Open3D's own {type(geometry).__name__}")
    to_legacy = getattr(type(geometry), "to_legacy", None)
    if to_legacy is not None:
        geometry = to_legacy(geometry)
    if isinstance(geometry, RGBDImage):
        geometry = geometry.color
    if isinstance(geometry, Image):
        return _image_on_a_surface(np.asarray(geometry))
    return unwrap(geometry)


def checked(geometry_list: Iterable[object]) -> list[Any]:
    """A list of geometries. Raises TypeError for a single geometry."""
    if isinstance(geometry_list, Geometry | Image):
        kind = type(geometry_list).__name__
        raise TypeError(f"geometry_list: expected a list of geometries, got a {kind}; put it into brackets")
    return list(geometry_list)


def bounds_of(geometries: list[Any]) -> tuple[Any, Any] | None:
    """Lowest and highest corner of all. None without any."""
    corners = []
    for geometry in geometries:
        shape = drawn(geometry)
        points = shape.vertices if isinstance(shape, TriangleMesh) else None
        if points is not None and not len(points):
            continue
        if points is None and getattr(shape, "is_empty", lambda: False)():
            continue
        bounded = shape if hasattr(shape, "get_min_bound") else geometry  # a VoxelGrid, an Octree
        corners += [bounded.get_min_bound(), bounded.get_max_bound()]
    return (np.min(corners, axis=0), np.max(corners, axis=0)) if corners else None


def _image_on_a_surface(pixels: NDArray[Any]) -> TriangleMesh:
    """A rectangle of an image's size [px] with the image as texture. Larger types than bytes are scaled to gray."""
    if pixels.dtype != np.uint8:
        values = np.nan_to_num(pixels.astype(np.float64), posinf=0.0)
        pixels = (255 * np.clip(values / (values.max(initial=0.0) or 1.0), 0, 1)).astype(np.uint8)
    if pixels.ndim == 2:
        pixels = np.repeat(pixels[..., None], 3, axis=2)
    height, width = pixels.shape[:2]
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float64)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    mesh = TriangleMesh(np.column_stack([corners * (width, height), np.zeros(4)]), faces)
    mesh.triangle_uvs = corners[faces.ravel()]
    mesh.textures = [pixels]
    return mesh
