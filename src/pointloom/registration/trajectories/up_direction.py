"""Up direction of an SfM model from level cameras, or from known attitudes.

Photographers keep the camera level, so the x axes of the images are horizontal: up is the smallest eigenvector of the
sum of x xT (as in OpenSfM and nerfstudio). Gimbal attitudes are better, and work for nadir images.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...core.reports import AssessedRecord
from ...core.up_axis import Direction, up_of_camera
from ...io.models.sfm_model import SfmModel
from ...kernels.linear_algebra import eigh, matmul, norm

Array = NDArray[np.float64]

MIN_CAMERAS = 3  # minimum cameras
MIN_SPREAD = 0.02  # minimum spread of the x axes: 8 degrees
MAX_TILT = math.sin(math.radians(15.0))  # maximum median tilt of level cameras
MAX_SIGMA = 4.0  # [degrees] maximum standard deviation
MIN_SIGN = 0.2  # minimum mean cosine that separates up from down
ATTITUDE_SIGMA = 1.0  # [degrees] gimbal accuracy
MAX_APART = 10.0  # [degrees] maximum median difference between attitudes and the model
REWEIGHTING_ITERATIONS = 10
_OUTLIER_MEDIANS = 2.5 * 1.4826  # in median deviations, for outliers


@dataclass(frozen=True, eq=False)
class UpDirection(AssessedRecord):
    """Up direction of a model.

    Attributes:
        direction: Unit vector in model coordinates, shape [3]. None if unknown.
        sigma: Standard deviation [degrees], infinite if unknown.
        by: "attitudes", "cameras", or "".
        warnings: Why the direction is unknown. Empty if it is known.
    """

    direction: Array | None
    sigma: float
    by: str
    warnings: tuple[str, ...] = ()


def up_direction(model: SfmModel, attitudes: Mapping[str, Sequence[float]] | None = None) -> UpDirection:
    """Up direction by three or more consistent attitudes (yaw, pitch, roll [degrees]), else by level cameras."""
    from_attitudes = _by_attitudes(model, attitudes or {})
    if from_attitudes.direction is not None:
        return from_attitudes
    from_level = _by_level_cameras(model.T_camera_world[:, :3, :3])
    if from_level.direction is None:
        return UpDirection(None, math.inf, "", (*from_attitudes.warnings, *from_level.warnings))
    return from_level


def up_of_poses(T_world_camera: Array) -> Direction:
    """Up direction of the world of poses (n, 4, 4) by level cameras, else by the first one: an axis if one is near."""
    level = _by_level_cameras(T_world_camera[:, :3, :3].transpose(0, 2, 1)).direction
    if level is None:
        return up_of_camera(T_world_camera[0])
    largest = int(np.abs(level).argmax())
    if math.degrees(math.hypot(*np.delete(level, largest).tolist())) < MAX_SIGMA:
        level = np.where(np.arange(3) == largest, np.copysign(1.0, level), 0.0)
    x, y, z = level.tolist()
    return x, y, z


def up_in_camera(pitch: float, roll: float) -> Array:
    """Up in camera coordinates (x right, y down, z forward) from pitch and roll [degrees]."""
    p, r = math.radians(pitch), math.radians(roll)
    return np.array([-math.sin(r) * math.cos(p), -math.cos(r) * math.cos(p), math.sin(p)])


def _by_attitudes(model: SfmModel, attitudes: Mapping[str, Sequence[float]]) -> UpDirection:
    known = [(k, attitudes[name]) for k, name in enumerate(model.names) if name in attitudes]
    if len(known) < MIN_CAMERAS:
        return UpDirection(None, math.inf, "")
    ups = np.array([matmul(model.T_camera_world[k, :3, :3].T, up_in_camera(*angles[1:3])) for k, angles in known])
    way, is_inlier = _median_way(ups)
    apart = np.degrees(np.arccos(np.clip(matmul(ups, way), -1, 1)))
    if float(np.median(apart)) > MAX_APART:
        warning = f"the attitudes of the images differ by {np.median(apart):.0f} degrees (median) in the model"
        return UpDirection(None, math.inf, "", (warning,))
    error = math.sqrt(float((apart[is_inlier] ** 2).mean()) / is_inlier.sum())
    return UpDirection(way, max(error, ATTITUDE_SIGMA / math.sqrt(is_inlier.sum())), "attitudes")


def _median_way(ways: Array) -> tuple[Array, NDArray[np.bool_]]:
    cosines = matmul(ways, ways.T)
    way = ways[int(np.argmax(np.median(cosines, axis=1)))]  # more than half are near it
    is_inlier = np.ones(len(ways), bool)
    for _ in range(REWEIGHTING_ITERATIONS):
        gaps = np.linalg.norm(ways - way, axis=1)
        is_inlier = gaps <= max(_OUTLIER_MEDIANS * float(np.median(gaps)), math.radians(1.0))
        mean = ways[is_inlier].mean(axis=0)
        way = mean / norm(mean)
    return way, is_inlier


def _by_level_cameras(rotations: Array) -> UpDirection:
    count = len(rotations)
    if count < MIN_CAMERAS:
        return _unknown(f"{count} cameras do not determine the up direction")
    x, down, ahead = rotations[:, 0], rotations[:, 1], rotations[:, 2]
    is_inlier = np.ones(count, bool)
    way, values = np.zeros(3), np.zeros(3)
    for _ in range(REWEIGHTING_ITERATIONS):
        values, axes = eigh(matmul(x[is_inlier].T, x[is_inlier]) / is_inlier.sum())
        way, before = axes[:, 0], is_inlier
        tilts = np.abs(matmul(x, way))
        is_inlier = tilts <= max(_OUTLIER_MEDIANS * float(np.median(tilts)), math.radians(2.0))
        if is_inlier.sum() < MIN_CAMERAS or (is_inlier == before).all():
            break
    if is_inlier.sum() < max(MIN_CAMERAS, count / 2) or float(np.median(np.abs(matmul(x, way)))) > MAX_TILT:
        return _unknown("cameras were not held level")
    if not values[1] > MIN_SPREAD:
        return _unknown(
            "all images have one orientation, or the opposite: their sides do not determine the up direction"
        )
    sigma = math.degrees(math.sqrt(max(float(values[0]), 0.0) / (float(values[1]) * is_inlier.sum())))
    # limit of hand-held accuracy
    sigma = max(sigma, math.degrees(0.01) / math.sqrt(float(values[1]) * is_inlier.sum()))
    if sigma > MAX_SIGMA:
        return _unknown(f"the cameras determine the up direction only to {sigma:.0f} degrees")
    sign = -float(matmul(down[is_inlier], way).mean())
    if abs(sign) < MIN_SIGN:  # cameras that look down or up: nearly all look down
        sign = -float(matmul(ahead[is_inlier], way).mean())
        if abs(sign) < MIN_SIGN:
            return _unknown("the images are both upright and upside down")
    return UpDirection(way * math.copysign(1.0, sign), sigma, "cameras")


def _unknown(warning: str) -> UpDirection:
    return UpDirection(None, math.inf, "", (warning,))


def upright_rotation(direction: Array) -> Array:
    """The smallest rotation [3, 3] from a unit vector to z."""
    x, y, z = direction.tolist()
    if z < -1 + 1e-9:  # upside down: half a turn about x
        return np.diag([1.0, -1.0, -1.0])
    axis = np.array([y, -x, 0.0])  # direction x z
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + cross + matmul(cross, cross) / (1 + z)  # Rodrigues
