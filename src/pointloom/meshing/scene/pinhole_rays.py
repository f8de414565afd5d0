"""Rays of a pinhole camera, one per pixel."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_count, check_finite, check_number, check_shape, check_transformation
from ...core.coordinates import NEAR_ZERO
from ...kernels.linear_algebra import inv, matmul, norm

MAX_PIXELS = 2**28  # of an image, as for cameras of clouds
MATRICES = ("intrinsic_matrix", "extrinsic_matrix", "width_px", "height_px")
VIEW = ("fov_deg", "center", "eye", "up", "width_px", "height_px")


def pinhole_rays(*args: Any, **kwargs: Any) -> NDArray[Any]:
    given = _named(args, kwargs)
    width, height = check_count("width_px", given["width_px"]), check_count("height_px", given["height_px"])
    if width * height > MAX_PIXELS:
        raise ValueError(f"width_px, height_px: expected up to {MAX_PIXELS} pixels, got {width} x {height}")
    if "fov_deg" in given:
        K, T = _camera_of_view(given, width, height)
    else:
        K = check_finite("intrinsic_matrix", check_shape("intrinsic_matrix", given["intrinsic_matrix"], (3, 3)))
        if np.linalg.matrix_rank(K) < 3:
            raise ValueError(f"intrinsic_matrix: expected an invertible matrix, got {K.tolist()}")
        T = check_transformation("extrinsic_matrix", given["extrinsic_matrix"])
    return _rays(K, T, width, height)


def _named(args: tuple[Any, ...], kwargs: dict[str, Any]) -> dict[str, Any]:
    """Arguments by name, of either signature."""
    names = VIEW if "fov_deg" in kwargs or len(args) + len(kwargs) == len(VIEW) else MATRICES
    given = dict(zip(names, args, strict=False)) | kwargs
    if len(args) + len(kwargs) != len(names) or set(given) != set(names):
        raise TypeError(
            f"create_rays_pinhole: expected ({', '.join(MATRICES)}) or ({', '.join(VIEW)}), "
            f"got {len(args)} positional arguments and {sorted(kwargs)}"
        )
    return given


def _camera_of_view(given: dict[str, Any], width: int, height: int) -> tuple[NDArray[Any], NDArray[Any]]:
    """Intrinsic and extrinsic matrix of a look-at camera. Rows follow `up`."""
    fov = check_number("fov_deg", given["fov_deg"])
    if not 0 < fov < 180:
        raise ValueError(f"fov_deg: expected a field of view between 0 and 180, got {fov}")
    center, eye, up = (check_finite(n, check_shape(n, given[n], (3,))) for n in ("center", "eye", "up"))
    focal = 0.5 * width / math.tan(math.radians(fov) / 2)
    forward = _unit("center, eye", center - eye, "the camera is at the point it looks at")
    right = _unit("up", np.cross(up, forward), "it is parallel to the view direction, or zero")
    T = np.eye(4)
    T[:3, :3] = right, np.cross(forward, right), forward
    T[:3, 3] = matmul(-T[:3, :3], eye)
    return np.array([[focal, 0, width / 2], [0, focal, height / 2], [0, 0, 1]]), T


def _unit(name: str, v: NDArray[np.float64], complaint: str) -> NDArray[np.float64]:
    size = norm(v)
    if not size > 0:
        raise ValueError(f"{name}: {complaint}")
    return v / size


def _rays(K: NDArray[Any], T: NDArray[Any], width: int, height: int) -> NDArray[Any]:
    back = inv(T)
    to_scene = matmul(back[:3, :3], inv(K))
    far = np.abs(back[:3, 3]).max() > NEAR_ZERO
    rays = np.empty((height, width, 6), np.float64 if far else np.float32)
    columns, rows = np.arange(width) + 0.5, np.arange(height) + 0.5
    rays[..., :3] = back[:3, 3] + 0.0  # avoids negative zero
    for axis in range(3):
        a, b, c = to_scene[axis]
        rays[..., 3 + axis] = a * columns + (b * rows + c)[:, None]
    return rays
