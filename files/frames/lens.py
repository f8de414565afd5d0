"""Pictures of a real lens brought to those of a pinhole, by the distortion that a camera's driver reports.

Depth takes the nearest pixel, as depths must not be mixed; colour is read between four. What the lens did not see is 0.

Source: Brown 1966; the rational form with k4 to k6 as in OpenCV, "Camera calibration and 3D reconstruction".
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.camera import PinholeCameraIntrinsic

NEGLIGIBLE = 0.05  # [px] a lens that moves no pixel farther is taken for a pinhole

PARTS = 16  # a colour is read at a sixteenth of a pixel: four weights of 1/256 keep the sum within 16 bits

TURNS = 20  # of the fixed-point iteration that turns a model round; 0.001 px are left after a few


class LensMap:
    """Where each pixel of a pinhole camera lies in the picture of a lens.

    Args:
        intrinsic: The camera, of both.
        coefficients: k1, k2, p1, p2, k3 and, of the rational form, k4, k5, k6.
        inverse: The coefficients take distorted places to ideal ones, as RealSense's "inverse Brown-Conrady" does.

    Attributes:
        places: Column and row in the picture of the lens, shape [2, h, w] [px].
        shift: How far the farthest pixel is moved [px].
    """

    def __init__(self, intrinsic: PinholeCameraIntrinsic, coefficients: Any, *, inverse: bool = False):
        k = np.zeros(8)
        k[: len(coefficients)] = coefficients
        v, u = np.mgrid[: intrinsic.height, : intrinsic.width].astype(np.float64)
        ideal = np.stack([(u - intrinsic.cx) / intrinsic.fx, (v - intrinsic.cy) / intrinsic.fy])
        bent = _turn_round(ideal, k) if inverse else distort(ideal, k)
        height, width = u.shape
        u_bent, v_bent = bent[0] * intrinsic.fx + intrinsic.cx, bent[1] * intrinsic.fy + intrinsic.cy
        self.places = np.stack([u_bent, v_bent])
        self.shift = float(np.hypot(u_bent - u, v_bent - v).max())
        self._outside = ~((u_bent >= 0) & (v_bent >= 0) & (u_bent <= width - 1) & (v_bent <= height - 1))
        u_bent, v_bent = np.clip(u_bent, 0, width - 1), np.clip(v_bent, 0, height - 1)
        self._nearest = np.rint(v_bent).astype(np.intp) * width + np.rint(u_bent).astype(np.intp)
        left, upper = np.floor(u_bent).astype(np.intp), np.floor(v_bent).astype(np.intp)
        right, lower = np.minimum(left + 1, width - 1), np.minimum(upper + 1, height - 1)
        x = np.rint((u_bent - left) * PARTS).astype(np.uint16)
        y = np.rint((v_bent - upper) * PARTS).astype(np.uint16)
        self._corners = [
            (row * width + column, weight[..., None])
            for row, column, weight in (
                (upper, left, (PARTS - y) * (PARTS - x)),
                (upper, right, (PARTS - y) * x),
                (lower, left, y * (PARTS - x)),
                (lower, right, y * x),
            )
        ]

    def straighten_depth(self, depth: NDArray[np.uint16]) -> NDArray[np.uint16]:
        """The depth map of a pinhole; depth along the axis is the same, only its pixel is another."""
        straight = depth.ravel()[self._nearest]
        straight[self._outside] = 0
        return straight

    def straighten_color(self, color: NDArray[np.uint8]) -> NDArray[np.uint8]:
        """The colour picture of a pinhole."""
        pixels = color.reshape(-1, 3).astype(np.uint16)
        mixed = np.full(color.shape, PARTS * PARTS // 2, np.uint16)
        for place, weight in self._corners:
            mixed += pixels[place] * weight
        straight = (mixed // (PARTS * PARTS)).astype(np.uint8)
        straight[self._outside] = 0
        return straight


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
