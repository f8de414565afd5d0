"""What is up in a model of structure from motion: by how cameras are held, or by attitudes that they tell.

Whoever takes pictures holds the camera level: the x axes of the pictures are horizontal, whichever way it looks up or
down. So up is the direction that is square to all of them, once they point different ways. What a drone's gimbal tells
is better, and says it of cameras that all look straight down too.

Source: the smallest axis of the sum of x xT, as in OpenSfM's alignment to the ground plane and in nerfstudio's poses.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...files.models.sfm_model import SfmModel
from ...kernels.linear_algebra import eigh, matmul, norm

Array = NDArray[np.float64]

FEWEST = 3  # cameras that say something together
LEAST_SPREAD = 0.02  # of the mean square of the x axes across the way that most of them point: 8 degrees
MOST_TILT = math.sin(math.radians(15.0))  # of x axes that are called level, median
MOST_SIGMA = 4.0  # [degrees] of a direction that is accepted
LEAST_SIGN = 0.2  # of the mean cosine that tells up from down
ATTITUDE_SIGMA = 1.0  # [degrees] of a gimbal, at best
MOST_APART = 10.0  # [degrees] between attitudes and the model, median: what is farther off is told otherwise
TURNS = 10
_CUT = 2.5 * 1.4826  # medians of a deviation beyond which a camera is held otherwise


@dataclass(frozen=True, eq=False)
class UpDirection:
    """What is up in a model.

    Attributes:
        direction: In the model's coordinates, of length 1, shape [3]; None where the cameras do not tell.
        sigma: Its standard deviation [degrees]; infinite where they do not.
        by: "attitudes" that the pictures tell, or "cameras" that are held level; "" where neither tells.
        reason: Why nothing is known, or "".
    """

    direction: Array | None
    sigma: float
    by: str
    reason: str = ""


def up_direction(model: SfmModel, attitudes: Mapping[str, Sequence[float]] | None = None) -> UpDirection:
    """What is up in a model.

    Args:
        model: The model.
        attitudes: Yaw, pitch up from level and roll to the right [degrees] of cameras, by the picture's name; those of
            pictures that the model does not have are passed over.

    Returns:
        The direction, by attitudes where three or more agree with the model, else by level cameras.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> from pointloom.registration.trajectories.up_direction import up_direction
        >>> camera = loom.CameraModel("PINHOLE", 64, 48, [60, 60, 32, 24])
        >>> turns = np.radians([0, 70, 140, 210, 280])
        >>> poses = np.tile(np.eye(4), (5, 1, 1))
        >>> poses[:, 0, 0], poses[:, 0, 2] = np.cos(turns), np.sin(turns)  # turned about y, which points down
        >>> poses[:, 2, 0], poses[:, 2, 2] = -np.sin(turns), np.cos(turns)
        >>> found = up_direction(loom.SfmModel(["a", "b", "c", "d", "e"], [camera] * 5, poses))
        >>> (found.direction.round(6) + 0.0).tolist()
        [0.0, -1.0, 0.0]
    """
    said = _by_attitudes(model, attitudes or {})
    if said.direction is not None:
        return said
    held = _by_level_cameras(model.T_camera_world[:, :3, :3])
    if held.direction is None and said.reason:
        return UpDirection(None, math.inf, "", f"{said.reason}; {held.reason}")
    return held


def up_in_camera(pitch: float, roll: float) -> Array:
    """Up in a camera's coordinates, x right, y down, z ahead, of its pitch and roll [degrees]."""
    p, r = math.radians(pitch), math.radians(roll)
    return np.array([-math.sin(r) * math.cos(p), -math.cos(r) * math.cos(p), math.sin(p)])


def _by_attitudes(model: SfmModel, attitudes: Mapping[str, Sequence[float]]) -> UpDirection:
    known = [(k, attitudes[name]) for k, name in enumerate(model.names) if name in attitudes]
    if len(known) < FEWEST:
        return UpDirection(None, math.inf, "")
    ups = np.array([matmul(model.T_camera_world[k, :3, :3].T, up_in_camera(*angles[1:3])) for k, angles in known])
    way, kept = _median_way(ups)
    apart = np.degrees(np.arccos(np.clip(matmul(ups, way), -1, 1)))
    if float(np.median(apart)) > MOST_APART:
        reason = f"the attitudes that pictures tell lie {np.median(apart):.0f} degrees (median) apart in the model"
        return UpDirection(None, math.inf, "", reason)
    error = math.sqrt(float((apart[kept] ** 2).mean()) / kept.sum())
    return UpDirection(way, max(error, ATTITUDE_SIGMA / math.sqrt(kept.sum())), "attitudes")


def _median_way(ways: Array) -> tuple[Array, NDArray[np.bool_]]:
    """The mean of directions without those that lie far from the rest, and which those are that stay."""
    cosines = matmul(ways, ways.T)
    way = ways[int(np.argmax(np.median(cosines, axis=1)))]  # more than half of them lie near it
    kept = np.ones(len(ways), bool)
    for _ in range(TURNS):
        gaps = np.linalg.norm(ways - way, axis=1)
        kept = gaps <= max(_CUT * float(np.median(gaps)), math.radians(1.0))
        mean = ways[kept].mean(axis=0)
        way = mean / norm(mean)
    return way, kept


def _by_level_cameras(rotations: Array) -> UpDirection:
    count = len(rotations)
    if count < FEWEST:
        return _unknown(f"{count} cameras do not tell what is up")
    x, down, ahead = rotations[:, 0], rotations[:, 1], rotations[:, 2]
    kept = np.ones(count, bool)
    way, values = np.zeros(3), np.zeros(3)
    for _ in range(TURNS):
        values, axes = eigh(matmul(x[kept].T, x[kept]) / kept.sum())
        way, before = axes[:, 0], kept
        tilts = np.abs(matmul(x, way))
        kept = tilts <= max(_CUT * float(np.median(tilts)), math.radians(2.0))
        if kept.sum() < FEWEST or (kept == before).all():
            break
    if kept.sum() < max(FEWEST, count / 2) or float(np.median(np.abs(matmul(x, way)))) > MOST_TILT:
        return _unknown("cameras were not held level")
    if not values[1] > LEAST_SPREAD:
        return _unknown("all pictures lie the same way, or turned by half: their sides do not tell what is up")
    sigma = math.degrees(math.sqrt(max(float(values[0]), 0.0) / (float(values[1]) * kept.sum())))
    sigma = max(sigma, math.degrees(0.01) / math.sqrt(float(values[1]) * kept.sum()))  # nobody holds one better
    if sigma > MOST_SIGMA:
        return _unknown(f"cameras were held so that up is known to {sigma:.0f} degrees alone")
    sign = -float(matmul(down[kept], way).mean())
    if abs(sign) < LEAST_SIGN:  # cameras that look down or up: nearly all look down
        sign = -float(matmul(ahead[kept], way).mean())
        if abs(sign) < LEAST_SIGN:
            return _unknown("pictures lie both ways up")
    return UpDirection(way * math.copysign(1.0, sign), sigma, "cameras")


def _unknown(reason: str) -> UpDirection:
    return UpDirection(None, math.inf, "", reason)


def turn_upright(direction: Array) -> Array:
    """The rotation [3, 3] by the least turn that brings a direction of length 1 to z."""
    x, y, z = direction.tolist()
    if z < -1 + 1e-9:  # upside down: half a turn about x
        return np.diag([1.0, -1.0, -1.0])
    axis = np.array([y, -x, 0.0])  # direction x z
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + cross + matmul(cross, cross) / (1 + z)  # Rodrigues
