"""Rectification of an image pair with known poses: corresponding points have the same row.

Both rectified cameras have the axes of the baseline and of the mean viewing direction (Fusiello, Trucco, Verri, "A
compact algorithm for rectification of stereo pairs", Machine Vision and Applications 2000).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import inv, matmul, norm
from .posed_images import PosedCamera

Matrix = NDArray[np.float64]
MIN_SIDEWAYS = 0.5  # sine of the least angle between baseline and mean viewing direction
MAX_GROWTH = 4.0  # limit of the rectified area relative to the larger image
MAX_RECTIFIED_SHIFT = 1e-3  # [px] largest displacement of an image that is already rectified


@dataclasses.dataclass(frozen=True)
class Rectified:
    """One rectified image; `there` maps original to rectified pixels, None if they are the same."""

    lens: tuple[float, float, float, float]
    there: Matrix | None
    back: Matrix  # rotation to the original camera


@dataclasses.dataclass(frozen=True)
class RectifiedPair:
    """Left and right rectified image of one size, and disparity per inverse depth [px unit].

    `order` has the indices of the left and the right camera.
    """

    width: int
    height: int
    views: tuple[Rectified, Rectified]
    order: tuple[int, int]
    per_unit: float

    @property
    def offset(self) -> float:
        """Disparity of points at infinity [px]."""
        return self.views[0].lens[2] - self.views[1].lens[2]

    def disparities(self, cameras: Sequence[PosedCamera], ranges: Sequence[tuple[float, float]]) -> tuple[int, int]:
        """First and last integer disparity of the depth ranges of both cameras, with one more on each side."""
        bounds = []
        for view, index in zip(self.views, self.order, strict=True):
            slopes = matmul(_rays(cameras[index]), view.back[:, 2:])[:, 0]
            bounds += [self.per_unit / (z * slope) for z in ranges[index] for slope in slopes]
        return int(np.floor(min(bounds) + self.offset)) - 1, int(np.ceil(max(bounds) + self.offset)) + 1


def rectify(cameras: Sequence[PosedCamera]) -> RectifiedPair:
    """Rectify two cameras. Raises ValueError if one is in front of the other, or if they look apart."""
    rotations = [camera.T_camera_world[:3, :3] for camera in cameras]
    baseline = cameras[1].center - cameras[0].center
    length = norm(baseline)
    x = baseline / length
    x, order = (x, (0, 1)) if (x * (rotations[0][0] + rotations[1][0])).sum() >= 0 else (-x, (1, 0))
    ahead = (rotations[0][2] + rotations[1][2]) / 2
    z = ahead - (ahead * x).sum() * x
    if norm(z) < MIN_SIDEWAYS:
        raise ValueError(
            "cameras: expected a baseline across the viewing directions, as a rectified pair has, got cameras behind "
            'each other or looking apart. Pass method="patch_match".'
        )
    z /= norm(z)
    R = np.stack([x, np.cross(z, x), z])
    fx = float(np.mean([camera.intrinsic.fx for camera in cameras]))
    fy = float(np.mean([camera.intrinsic.fy for camera in cameras]))
    backs = [matmul(rotations[i], R.T) for i in order]
    boxes = [_box(cameras[i], matmul(np.diag([fx, fy, 1.0]), back.T)) for i, back in zip(order, backs, strict=True)]
    top, bottom = max(box[0][1] for box in boxes), min(box[1][1] for box in boxes)
    cy = -float(top)
    height = int(np.floor(bottom + cy + MAX_RECTIFIED_SHIFT)) + 1
    width = max(int(np.floor(box[1][0] - box[0][0] + MAX_RECTIFIED_SHIFT)) + 1 for box in boxes)
    largest = max(camera.intrinsic.width * camera.intrinsic.height for camera in cameras)
    if height > 0 and width * height > MAX_GROWTH * largest:
        raise ValueError(
            f"cameras: expected viewing directions that can be rectified to at most {MAX_GROWTH:g} times the image "
            f'area, got {width} x {height} pixels. Pass method="patch_match".'
        )
    views = []
    for i, back, box in zip(order, backs, boxes, strict=True):
        lens = (fx, fy, -float(box[0][0]), cy)
        there = matmul(_matrix(lens), back.T, inv(cameras[i].intrinsic.matrix))
        views.append(_same(cameras[i], Rectified(lens, there, back)))
    return RectifiedPair(width, max(height, 0), (views[0], views[1]), order, fx * length)


def _matrix(lens: tuple[float, float, float, float]) -> Matrix:
    return np.array([[lens[0], 0, lens[2]], [0, lens[1], lens[3]], [0, 0, 1]])


def _corners(camera: PosedCamera) -> Matrix:
    right, bottom = camera.intrinsic.width - 1, camera.intrinsic.height - 1
    return np.array([[0, 0, 1], [right, 0, 1], [0, bottom, 1], [right, bottom, 1]], float)


def _rays(camera: PosedCamera) -> Matrix:
    return matmul(_corners(camera), inv(camera.intrinsic.matrix).T)


def _box(camera: PosedCamera, matrix: Matrix) -> Matrix:
    """Lower and upper corner of the projected image, before a principal point is chosen."""
    p = matmul(_rays(camera), matrix.T)
    if not (p[:, 2] > 0).all():
        raise ValueError(
            "cameras: expected viewing directions that can be rectified, got a field of view beyond 180 degrees. "
            'Pass method="patch_match".'
        )
    pixels = p[:, :2] / p[:, 2:]
    return np.stack([pixels.min(axis=0), pixels.max(axis=0)])


def _same(camera: PosedCamera, view: Rectified) -> Rectified:
    """The view with its original pixels, if the image is already rectified."""
    assert view.there is not None
    corners = _corners(camera)
    p = matmul(corners, view.there.T)
    if np.abs(p[:, :2] / p[:, 2:] - corners[:, :2]).max() > MAX_RECTIFIED_SHIFT:
        return view
    K = camera.intrinsic
    return Rectified((K.fx, K.fy, K.cx, K.cy), None, np.eye(3))
