"""Surfaces of sampled fields as arrays, and by Open3D's name."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_number, check_numeric, check_positive, check_shape, shown
from ...core.coordinates import choose_origin
from ...core.devices import check_same_device, resolve_device
from ...kernels.language.device_lock import lock
from ...kernels.memory import cast, contiguous, upload
from ...kernels.meshes.mesh_edits import flip_triangles
from ...kernels.volumes.marching_cubes import extract_surface
from .mesh_joining import MeshJoining

_FLOAT_MAX = float(np.finfo(np.float32).max)
_FLOAT_TINY = float(np.finfo(np.float32).tiny)


class Isosurfaces(MeshJoining):
    """The part of TriangleMesh that makes surfaces of sampled fields."""

    @classmethod
    def create_isosurfaces(cls, volume: ArrayLike, contour_values: ArrayLike = (0.0,), device: Any = None) -> Self:
        """The surfaces on which a sampled field passes some values, one behind the other, as Open3D has them.

        `marching_cubes` is the same for one value, with the spacing of the samples and another order of axes.

        Args:
            volume: Values at the points (x, y, z) of a grid, shape [nz, ny, nx] with at least 2 along each axis.
            contour_values: The values on the surfaces, taken as float32.
            device: "cpu" (default), "cuda:N" or "auto".

        Returns:
            The mesh, one unit of length a sample; triangles turn counter-clockwise seen from where the field is below.

        Raises:
            ValueError, TypeError, DeviceError: As `marching_cubes`.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> z, y, x = np.mgrid[:9, :9, :9] - 4.0
            >>> ball = loom.TriangleMesh.create_isosurfaces(3 - np.sqrt(x**2 + y**2 + z**2))
            >>> ball.is_watertight(), ball.get_center().round(3).tolist()
            (True, [4.0, 4.0, 4.0])
        """
        levels = check_finite("contour_values", np.atleast_1d(check_numeric("contour_values", contour_values)))
        if levels.ndim != 1 or not levels.size or levels.dtype == np.bool_:
            raise ValueError(f"contour_values: expected numbers, shape [k], got {shown(contour_values)}")
        if np.abs(levels).max() > _FLOAT_MAX:
            raise ValueError(f"contour_values: expected numbers within float32, got {shown(contour_values)}")
        field = np.asarray(check_numeric("volume", volume)).T
        if field.ndim != 3 or min(field.shape) < 2:
            found = list(field.shape[::-1])
            raise ValueError(f"volume: expected shape [nz, ny, nx] with at least 2 along each axis, got {found}")
        parts = []
        for level in levels.tolist():
            vertices, triangles, origin = extract_level(field, level, (1.0,) * 3, (0.0,) * 3, device)
            parts.append(cls._from_device_arrays(vertices, flip_triangles(triangles), origin=origin))
        return cls.concatenate(parts)


def extract_level(
    field: Any, level: float, spacing: Any, origin: Any, device: Any
) -> tuple[wp.array, wp.array, NDArray[np.float64]]:
    """(vertices, triangles, origin): see `marching_cubes`."""
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
    mesh_origin = choose_origin(np.array([corner, far]))
    rows = values.reshape((nx * ny, nz))
    vertices, triangles = extract_surface(rows, (nx, ny, nz), level, corner - mesh_origin, steps)
    return vertices, triangles, mesh_origin


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
