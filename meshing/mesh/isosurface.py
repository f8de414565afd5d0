"""Surfaces of sampled fields: `marching_cubes`."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp

from ...core.array_libraries import library_of
from ...core.checks import check_number, check_numeric, check_positive, check_shape
from ...core.coordinates import ORIGIN_LIMIT
from ...core.devices import check_same_device, resolve_device
from ...kernels.language.device_lock import lock
from ...kernels.memory import cast, contiguous, upload
from ...kernels.volumes.marching_cubes import extract_surface
from .mesh import TriangleMesh

_FLOAT_MAX = float(np.finfo(np.float32).max)
_FLOAT_TINY = float(np.finfo(np.float32).tiny)


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
        (Lewiner's method), `spacing` and `origin` apply to positions in float64 beyond 1e4 m, triangles wind the other
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
    values = _device_field(field, device)
    nx, ny, nz = values.shape
    level = _check_level(level)
    steps = check_shape("spacing", spacing, (3,))
    for step in steps:
        if check_positive("spacing", step) < _FLOAT_TINY:
            raise ValueError(f"spacing: {float(step)!r} is below what float32 can hold")
    corner = check_shape("origin", origin, (3,))
    far = corner + steps * (np.array(values.shape) - 1)
    if not np.isfinite(corner).all() or not max(np.abs(corner).max(), np.abs(far).max()) < _FLOAT_MAX:
        raise ValueError(f"origin, spacing: the grid from {corner.tolist()} to {far.tolist()} passes float32")
    mesh_origin = np.zeros(3)
    if max(np.abs(corner).max(), np.abs(far).max()) > ORIGIN_LIMIT:
        mesh_origin = np.round((corner + far) / 2)
    rows = values.reshape((nx * ny, nz))
    vertices, triangles = extract_surface(rows, (nx, ny, nz), level, corner - mesh_origin, steps)
    return TriangleMesh.from_device_arrays(vertices, triangles, origin=mesh_origin, library=library_of(field))


def _check_level(level: Any) -> float:
    number = check_number("level", level)
    if abs(number) > _FLOAT_MAX:
        raise ValueError(f"level: expected a finite number within float32, got {level!r}")
    return number


def _device_field(field: Any, device: Any) -> wp.array:
    """The field as a contiguous float32 device array of shape [nx, ny, nz], without a copy where it is one."""
    if not isinstance(field, wp.array) and not isinstance(field, np.ndarray):
        if hasattr(field, "__cuda_array_interface__"):
            resolve_device(None)  # starts Warp
            field = wp.array(field, copy=False)
        elif hasattr(field, "__dlpack__"):
            resolve_device(None)
            with lock:
                field = wp.from_dlpack(field)
    if not isinstance(field, wp.array):
        return _upload_field(field, resolve_device(device))
    if device is not None:
        check_same_device("field, device", field.device, resolve_device(device))
    _check_grid(field.shape)
    if field.dtype == wp.float32:
        return contiguous(field)
    if field.dtype not in (wp.float64, wp.float16, wp.int32, wp.uint8, wp.int8, wp.int16, wp.uint16):
        raise TypeError(f"field: expected real numbers, got {wp.types.type_repr(field.dtype)}")
    return cast(contiguous(field), wp.float32)


def _upload_field(field: Any, device: Any) -> wp.array:
    host = check_numeric("field", field)
    _check_grid(host.shape)
    with np.errstate(over="ignore"):  # beyond float32 is infinite, and cells with infinite corners are left out
        host = np.ascontiguousarray(host, dtype=np.float32)
    return upload(host, wp.float32, device, copied=False)


def _check_grid(shape: tuple[int, ...]) -> None:
    if len(shape) != 3 or min(shape) < 2:
        raise ValueError(f"field: expected shape [nx, ny, nz] with at least 2 along each axis, got {list(shape)}")
