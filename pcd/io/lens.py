"""Pictures of a real lens brought to those of a pinhole, by the distortion that a camera's driver reports.

Depth takes the nearest pixel, as depths must not be mixed; colour is read between four. What the lens did not see is 0.

Source: Brown 1966; the rational form with k4 to k6 as in OpenCV, "Camera calibration and 3D reconstruction".
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..camera import PinholeCameraIntrinsic

NEGLIGIBLE = 0.05  # [px] a lens that moves no pixel farther is taken for a pinhole

TURNS = 20  # of the fixed-point iteration that turns a model round; 0.001 px are left after a few


class LensMap:
    """Where each pixel of a pinhole camera lies in the picture of a lens.

    Args:
        intrinsic: The camera, of both.
        coefficients: k1, k2, p1, p2, k3 and, of the rational form, k4, k5, k6.
        inverse: The coefficients take distorted places to ideal ones, as RealSense's "inverse Brown-Conrady" does.

    Attributes:
        shift: How far the farthest pixel is moved [px].
    """

    def __init__(self, intrinsic: PinholeCameraIntrinsic, coefficients: Any, *, inverse: bool = False):
        k = np.zeros(8)
        k[: len(coefficients)] = coefficients
        v, u = np.mgrid[: intrinsic.height, : intrinsic.width].astype(np.float64)
        ideal = np.stack([(u - intrinsic.cx) / intrinsic.fx, (v - intrinsic.cy) / intrinsic.fy])
        bent = _turn_round(ideal, k) if inverse else distort(ideal, k)
        self._u, self._v = bent[0] * intrinsic.fx + intrinsic.cx, bent[1] * intrinsic.fy + intrinsic.cy
        self.shift = float(np.hypot(self._u - u, self._v - v).max())
        high = np.array([intrinsic.height - 1, intrinsic.width - 1])
        self._inside = (self._u >= 0) & (self._v >= 0) & (self._u <= high[1]) & (self._v <= high[0])
        self._low = np.clip(np.floor(np.stack([self._v, self._u])), 0, np.maximum(high - 1, 0)[:, None, None]).astype(
            int
        )

    def straighten_depth(self, depth: NDArray[np.uint16]) -> NDArray[np.uint16]:
        """The depth map of a pinhole; depth along the axis is the same, only its pixel is another."""
        rows = np.clip(np.rint(self._v), 0, depth.shape[0] - 1).astype(int)
        columns = np.clip(np.rint(self._u), 0, depth.shape[1] - 1).astype(int)
        return np.where(self._inside, depth[rows, columns], 0).astype(depth.dtype)

    def straighten_color(self, color: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """The colour picture of a pinhole."""
        v, u = self._low
        v1, u1 = np.minimum(v + 1, color.shape[0] - 1), np.minimum(u + 1, color.shape[1] - 1)
        a, b = (self._v - v)[..., None].astype(np.float32), (self._u - u)[..., None].astype(np.float32)
        upper, lower = color[v, u] * (1 - b) + color[v, u1] * b, color[v1, u] * (1 - b) + color[v1, u1] * b
        mixed = np.rint(upper * (1 - a) + lower * a)
        return np.where(self._inside[..., None], mixed, 0).astype(np.uint8)


def distort(places: NDArray[np.float64], k: NDArray[np.float64]) -> NDArray[np.float64]:
    """Where a lens puts the rays of ideal places x, y, shape [2, ...], at a depth of one."""
    x, y = places
    r2 = x * x + y * y
    radial = (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])))
    return np.stack([
        x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x),
        y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y,
    ])  # fmt: skip


def _turn_round(places: NDArray[np.float64], k: NDArray[np.float64]) -> NDArray[np.float64]:
    """The places that the model takes to these."""
    found = places.copy()
    for _ in range(TURNS):
        found = found - (distort(found, k) - places)
    return found
