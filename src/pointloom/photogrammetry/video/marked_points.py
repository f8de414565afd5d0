"""Triangulation of marked points: position, covariance, and residuals of the marks.

Hartley and Zisserman, "Multiple view geometry", 2004, section 12.2 (linear solution), then Gauss-Newton in pixels.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...cameras.image_names import matching_images
from ...io.models.sfm_model import SfmModel
from ...registration.rigid import skews
from .ground_control import ControlMark

Array = NDArray[np.float64]

MAX_ITERATIONS = 20
MARK_SIGMA = 0.5  # [px] standard deviation of a mark
DERIVATIVE_STEP = 1e-6  # relative step of numeric derivatives
MAX_MARK_ERROR = 15.0  # [px] maximum error of a mark
OUTLIER_IMPROVEMENT = 1.3  # improvement without an outlier mark, with four and more
OUTLIER_IMPROVEMENT_OF_THREE = 3.0  # improvement without one of three
MIN_ANGLE = math.radians(0.5)  # minimum angle between two rays


@dataclass(frozen=True, eq=False)
class MarkedPoint:
    """A triangulated point: `position` [3] with `covariance`, or None with a `reason`. Mark `errors` [px] by image."""

    name: str
    position: Array | None
    covariance: Array
    errors: dict[str, float]
    left_out: tuple[str, ...] = ()
    reason: str = ""

    @property
    def rms(self) -> float:
        return math.sqrt(sum(e * e for e in self.errors.values()) / len(self.errors)) if self.errors else math.nan


def locate_marks(model: SfmModel, marks: Sequence[ControlMark]) -> dict[str, MarkedPoint]:
    images = {mark.image: matching_images(mark.image, model.names) for mark in marks}
    by_name: dict[str, list[tuple[int, Array]]] = {mark.point: [] for mark in marks}
    for mark in marks:
        if len(meant := images[mark.image]) == 1:
            by_name[mark.point].append((meant[0], mark.pixel))
    return {name: _located(model, name, seen) for name, seen in by_name.items()}


def _located(model: SfmModel, name: str, seen: list[tuple[int, Array]]) -> MarkedPoint:
    left: list[str] = []
    while True:
        nowhere = MarkedPoint(name, None, np.full((3, 3), np.inf), {}, tuple(left))
        if len({k for k, _ in seen}) < 2:
            count = (
                f"{len(seen)} image{'s' * (len(seen) != 1)} of the model "
                f"ha{'s' if len(seen) == 1 else 've'} a mark of it"
            )
            return _because(nowhere, f"{count}; mark it in two or more registered images")
        rays = _rays(model, seen)
        if not np.isfinite(rays).all():
            return _because(nowhere, "a mark is outside the field of view of its lens")
        if _widest(rays) < MIN_ANGLE:
            return _because(nowhere, "all images show it from one direction: the rays do not intersect")
        position, covariance = _adjusted(model, seen, _meeting(model, seen, rays))
        if position is None:
            return _because(nowhere, "the rays of its marks do not intersect in front of the cameras")
        errors = np.linalg.norm(_gaps(model, seen, position), axis=1)
        errors_by_image = {model.names[k]: float(e) for (k, _), e in zip(seen, errors, strict=True)}
        if not errors.max() > MAX_MARK_ERROR:
            return MarkedPoint(name, position, covariance, errors_by_image, tuple(left))
        wrong = _odd_one(model, seen, math.sqrt(float((errors**2).mean()))) if len(seen) > 2 else None
        if wrong is None and len(seen) > 3:
            # all somewhat off: the model is deformed
            return MarkedPoint(name, position, covariance, errors_by_image, tuple(left))
        if wrong is None:
            which = ", ".join(model.names[k] for k, _ in seen)
            return _because(nowhere, f"its marks in {which} contradict each other by {errors.max():.0f} px; check them")
        left.append(model.names[seen[wrong][0]])
        seen = seen[:wrong] + seen[wrong + 1 :]


def _odd_one(model: SfmModel, seen: list[tuple[int, Array]], rms: float) -> int | None:
    left = np.full(len(seen), np.inf)
    for k in range(len(seen)):
        rest = seen[:k] + seen[k + 1 :]
        rays = _rays(model, rest)
        if _widest(rays) >= MIN_ANGLE:
            position, _ = _adjusted(model, rest, _meeting(model, rest, rays))
            left[k] = np.inf if position is None else np.sqrt((_gaps(model, rest, position) ** 2).sum(axis=1).mean())
    first, second = np.argsort(left, kind="stable")[:2].tolist()
    if len(seen) == 3:  # any two nearly agree, so the third must be far worse
        return first if OUTLIER_IMPROVEMENT_OF_THREE * max(left[first], MARK_SIGMA) < left[second] else None
    return first if OUTLIER_IMPROVEMENT * left[first] < rms else None


def _because(point: MarkedPoint, reason: str) -> MarkedPoint:
    return MarkedPoint(point.name, None, point.covariance, {}, point.left_out, reason)


def _rays(model: SfmModel, seen: list[tuple[int, Array]]) -> Array:
    rays = np.array([model.cameras[k].unproject(pixel[None])[0] for k, pixel in seen])
    rotated = np.array([model.T_camera_world[k, :3, :3].T @ ray for (k, _), ray in zip(seen, rays, strict=True)])
    return rotated / np.linalg.norm(rotated, axis=1, keepdims=True)


def _widest(rays: Array) -> float:
    return float(np.arccos(np.clip(rays @ rays.T, -1, 1)).max())


def _meeting(model: SfmModel, seen: list[tuple[int, Array]], rays: Array) -> Array:
    centers = model.centers[[k for k, _ in seen]]
    across = skews(rays)
    squares = across.transpose(0, 2, 1) @ across
    return np.linalg.lstsq(squares.sum(axis=0), np.einsum("nij,nj->i", squares, centers), rcond=None)[0]


def _adjusted(model: SfmModel, seen: list[tuple[int, Array]], position: Array) -> tuple[Array | None, Array]:
    normal = np.eye(3)
    for _ in range(MAX_ITERATIONS):
        gaps = _gaps(model, seen, position)
        if not np.isfinite(gaps).all():
            return None, normal
        far = DERIVATIVE_STEP * float(np.median(np.linalg.norm(model.centers[[k for k, _ in seen]] - position, axis=1)))
        columns = [
            (_gaps(model, seen, position + far * axis) - _gaps(model, seen, position - far * axis)).reshape(-1)
            / (2 * far)
            for axis in np.eye(3)
        ]
        J = np.stack(columns, axis=1)
        if not np.isfinite(J).all():
            return None, normal
        normal = J.T @ J
        step = np.linalg.lstsq(normal, J.T @ gaps.reshape(-1), rcond=None)[0]
        position = position - step
        if np.linalg.norm(step) < far * 1e-3:
            break
    gaps = _gaps(model, seen, position)
    spread = math.sqrt(float((gaps**2).sum()) / max(2 * len(seen) - 3, 1))
    if not np.isfinite(spread):
        return None, normal
    covariance = max(spread, MARK_SIGMA) ** 2 * np.linalg.pinv(normal)
    return position, covariance.astype(np.float64)


def _gaps(model: SfmModel, seen: list[tuple[int, Array]], position: Array) -> Array:
    """Reprojection errors [px]. NaN behind a camera."""
    errors = []
    for k, pixel in seen:
        T = model.T_camera_world[k]
        inside = T[:3, :3] @ position + T[:3, 3]
        errors.append(model.cameras[k].project(inside[None])[0] - pixel if inside[2] > 0 else np.full(2, np.nan))
    return np.array(errors)
