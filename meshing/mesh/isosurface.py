"""Surfaces of sampled fields: `marching_cubes`."""

from __future__ import annotations

from typing import Any

from ...core.array_libraries import library_of
from .isosurfaces import extract_level
from .mesh import TriangleMesh


def marching_cubes(
    field: Any, level: float = 0.0, *, spacing: Any = (1.0, 1.0, 1.0), origin: Any = (0.0, 0.0, 0.0), device: Any = None
) -> TriangleMesh:
    """Extract the surface on which a sampled field passes a level.

    Args:
        field: Values at the points of a grid, shape [nx, ny, nz] with at least 2 along each axis, z fastest: a NumPy
            array or array-like, a Warp array, or anything with `__cuda_array_interface__` or DLPack. float32 in C order
            is used where it lies; other types and orders are copied to it first.
        level: The value on the surface; taken as float32, as the field is.
        spacing: Distance [m] of neighbouring samples along each axis, three positive numbers.
        origin: Position [m] of sample (0, 0, 0).
        device: Where to compute on an array of the host (default "cpu"); a device array stays where it is.

    Returns:
        The mesh, on that device; empty where nothing passes the level. Triangles turn counter-clockwise seen from the
        side where the field is above the level: normals point outward for distances that are negative inside. Each
        vertex belongs to a triangle, and vertices are shared. The surface ends at the border of the grid.

    Raises:
        TypeError: The field is not numeric.
        ValueError: Another shape, a level or spacing out of range, or more triangles than 32 bits can index.
        DeviceError: No such device, or a device array that lies on another one.

    Notes:
        Same bits from run to run. Besides the mesh about 1 B a sample is needed while it runs; one wait for the device.

        Closed and manifold inside the grid for every field: at an ambiguous face both cells separate the inside
        corners. A sample exactly at the level counts as above it; triangles there may have no area. A cell with a
        sample that is NaN or infinite makes no triangles.

        Unlike scikit-image's `marching_cubes`, ambiguous cells are not resolved by the values inside the cell
        (Lewiner's method), `spacing` and `origin` apply to positions in float64 far from zero, triangles wind the other
        way than its default gives for distances that are negative inside, and a field that never passes the level is
        no error.

        Lorensen and Cline, "Marching cubes", SIGGRAPH 1987; Schroeder, Maynard and Geveci, "Flying edges", LDAV 2015.

    Example:
        >>> import numpy as np
        >>> x, y, z = np.mgrid[-1:1:33j, -1:1:33j, -1:1:33j]
        >>> ball = marching_cubes(np.sqrt(x**2 + y**2 + z**2) - 0.8, spacing=[1 / 16] * 3, origin=[-1, -1, -1])
        >>> ball.is_watertight()
        True
    """
    vertices, triangles, mesh_origin = extract_level(field, level, spacing, origin, device)
    return TriangleMesh._from_device_arrays(vertices, triangles, origin=mesh_origin, library=library_of(field))
