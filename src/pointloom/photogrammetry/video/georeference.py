"""Georeferencing of a model by image positions (GNSS): meters east, north and up.

A RANSAC similarity (3D, or horizontal with a known up), then weighted least squares with lower weights for heights,
estimated from the residuals. Accepted by the standard deviations of scale and rotation.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...cameras.image_names import ImageNames
from ...io.models.sfm_model import SfmModel
from ...pcd.geodesy import WorldFrame
from ...registration.trajectories.similarity import fit_to_positions
from ...registration.trajectories.up_direction import UpDirection
from ...registration.trajectories.weighted_similarity import Rows, UndeterminedError, WeightedFit, fit_level, fit_rows
from ..sfm.image_positions import ImagePosition, ImagePositions

Array = NDArray[np.float64]

MIN_POSITIONS = 3  # positions
DEFAULT_SIGMA, HEIGHT_FACTOR = 3.0, 2.0  # [m] default GNSS sigma, and the factor for heights
MIN_SIGMA = 0.005  # [m] lower bound
MIN_EXTENT = 3.0  # minimum extent of the positions, in sigmas
WORST_SCALE, WORST_TILT, WORST_YAW = 0.05, 5.0, 10.0  # maximum relative scale sigma, tilt and yaw sigma [degrees]
MAX_RELATIVE_RMS = 0.05  # maximum RMS residual relative to the extent
MAX_WRONG = 1 / 3  # maximum outlier fraction
NO_HEIGHT = 1e4  # [m] standard deviation of unknown heights
OUTLIER_RESIDUAL = 3.5  # normalized residual of an outlier
MAX_ITERATIONS = 12
MIN_POSITIONS_FOR_ACCURACY = 8  # minimum positions to estimate their accuracy
_MEDIAN_PLAN, _MEDIAN_HEIGHT = 1.1774, 0.6745  # medians of 2D and 1D normal errors, in sigmas


class NotSettledError(ValueError):
    """The positions do not determine the similarity, or contradict the model."""


@dataclass(frozen=True, eq=False)
class PlacesFit:
    """Agreement of image positions with the model.

    Attributes:
        frame: Local frame in meters about the median position.
        T_world_model: Similarity into it, float64 [4, 4].
        scale: Meters per model unit.
        names: Images with a position.
        residuals: Estimated minus given, east, north and up, [n, 3] [m]. NaN without altitude.
        inliers: Mask of the positions used, [n].
        horizontal_rms, vertical_rms: Of the inliers [m]. The latter NaN without altitudes.
        extent: Horizontal bounding box diagonal [m].
        scale_sigma: Relative standard deviation of the scale.
        tilt_sigma, yaw_sigma: Standard deviations of up and north [degrees].
    """

    frame: WorldFrame
    T_world_model: Array
    scale: float
    names: tuple[str, ...]
    residuals: Array
    inliers: NDArray[np.bool_]
    horizontal_rms: float
    vertical_rms: float
    extent: float
    scale_sigma: float
    tilt_sigma: float
    yaw_sigma: float

    @property
    def left_out(self) -> tuple[str, ...]:
        return tuple(name for name, fits in zip(self.names, self.inliers, strict=True) if not fits)

    def problem(self) -> str | None:
        wrong = len(self.left_out)
        if not (self.horizontal_rms > MAX_RELATIVE_RMS * self.extent or wrong > MAX_WRONG * len(self.names)):
            return None
        return (
            f"the GPS and the estimated positions of the images differ by {self.horizontal_rms:.3g} m in plan over "
            f"{self.extent:.3g} m, without {wrong} outliers of {len(self.names)}"
        )

    def to_dict(self) -> dict[str, Any]:
        rows = np.where(np.isfinite(self.residuals), self.residuals, 0.0).round(4).tolist()
        return {
            **frame_to_dict(self.frame),
            "places": len(self.names),
            "left_out": list(self.left_out),
            "horizontal_rms_m": self.horizontal_rms,
            "vertical_rms_m": None if math.isnan(self.vertical_rms) else self.vertical_rms,
            "extent_m": self.extent,
            "scale_sigma": self.scale_sigma,
            "tilt_sigma_degrees": self.tilt_sigma,
            "yaw_sigma_degrees": self.yaw_sigma,
            "residuals_m": dict(zip(self.names, rows, strict=True)),
        }


def positions_by_image(image_positions: ImagePositions, names: tuple[str, ...]) -> dict[str, ImagePosition]:
    result: dict[str, ImagePosition] = {}
    images = ImageNames(names)
    for position in image_positions.places:
        meant = images.matching(position.name)
        if len(meant) == 1:
            result[names[meant[0]]] = position
    return result


def attitudes_of(image_positions: ImagePositions, names: tuple[str, ...]) -> dict[str, tuple[float, float, float]]:
    result: dict[str, tuple[float, float, float]] = {}
    images = ImageNames(names)
    for name, angles in image_positions.attitudes.items():
        meant = images.matching(name)
        if len(meant) == 1:
            result[names[meant[0]]] = angles
    return result


def fit_image_positions(model: SfmModel, image_positions: ImagePositions, up: UpDirection) -> PlacesFit:
    by_name = positions_by_image(image_positions, model.names)
    if len(by_name) < MIN_POSITIONS:
        raise NotSettledError(
            f"{len(by_name)} images of the model have a GPS position; {MIN_POSITIONS} or more are needed"
        )
    frame = image_positions.frame
    names = tuple(name for name in model.names if name in by_name)
    target, sigma = _targets(frame, [by_name[name] for name in names])
    source = model.centers[[model.index_of(name) for name in names]]
    extent = float(np.linalg.norm(np.ptp(target[:, :2], axis=0)))
    min_extent = MIN_EXTENT * float(np.median(sigma[:, 0]))
    if not extent > min_extent:
        raise NotSettledError(
            f"the GPS positions cover only {extent:.3g} m, at an accuracy of {min_extent / MIN_EXTENT:.3g} m each"
        )
    try:
        T = _first(model, names, source, target, up)
        fit, inliers = _refined(source, target, sigma, up, T)
    except UndeterminedError as error:
        raise NotSettledError(str(error)) from None
    gaps = source @ fit.T[:3, :3].T + fit.T[:3, 3] - target
    plan = float(np.sqrt((gaps[inliers, :2] ** 2).sum(axis=1).mean()))
    heights = gaps[inliers, 2][np.isfinite(gaps[inliers, 2])]
    vertical = math.sqrt(float((heights**2).mean())) if len(heights) else math.nan
    result = PlacesFit(
        frame, fit.T, fit.scale, names, gaps, inliers, plan, vertical, extent,
        fit.scale_sigma, fit.tilt_sigma, fit.yaw_sigma,
    )  # fmt: skip
    if fit.scale_sigma > WORST_SCALE or fit.tilt_sigma > WORST_TILT or fit.yaw_sigma > WORST_YAW:
        raise NotSettledError(
            f"the GPS positions determine the scale to only {100 * fit.scale_sigma:.2g}%, up to "
            f"{fit.tilt_sigma:.2g} degrees and "
            f"north to {fit.yaw_sigma:.2g}: for their accuracy they are too close together, or collinear"
        )
    return result


def enu_of(frame: WorldFrame, positions: Sequence[ImagePosition]) -> Array:
    """East, north and up of image positions, NaN for unknown heights, [n, 3] [m]."""
    rows = [[p.latitude, p.longitude, frame.altitude if p.altitude is None else p.altitude] for p in positions]
    target = frame.to_enu(np.array(rows))
    target[[p.altitude is None for p in positions], 2] = np.nan
    return target


def frame_to_dict(frame: WorldFrame) -> dict[str, Any]:
    origin = {"latitude": frame.latitude, "longitude": frame.longitude, "altitude": frame.altitude}
    return {"origin": origin, "epsg": frame.epsg}


def _targets(frame: WorldFrame, positions: list[ImagePosition]) -> tuple[Array, Array]:
    target = enu_of(frame, positions)
    sigma = np.empty_like(target)
    for k, position in enumerate(positions):
        plan = max(position.horizontal_sigma or DEFAULT_SIGMA, MIN_SIGMA)
        sigma[k] = plan, plan, max(position.vertical_sigma or HEIGHT_FACTOR * plan, MIN_SIGMA)
        if position.altitude is None:
            sigma[k, 2] = np.inf
    return target, sigma


def _first(model: SfmModel, names: tuple[str, ...], source: Array, target: Array, up: UpDirection) -> Array:
    level = None
    if up.direction is not None:
        level = fit_level(source, target, up.direction)
    known = np.isfinite(target[:, 2])
    if known.sum() < MIN_POSITIONS:
        if level is None:
            raise UndeterminedError("no altitudes are given, and the cameras do not determine the up direction")
        return level
    if level is not None:
        return level
    given = {name: target[k] for k, name in enumerate(names) if known[k]}
    try:
        return fit_to_positions(model, given).transformation
    except ValueError as error:
        raise UndeterminedError(str(error)) from None


def _refined(
    source: Array, target: Array, sigma: Array, up: UpDirection, T: Array
) -> tuple[WeightedFit, NDArray[np.bool_]]:
    filled = np.where(np.isfinite(target), target, 0.0)
    if not np.isfinite(target[:, 2]).any():
        sigma = np.where(np.isfinite(sigma), sigma, NO_HEIGHT)  # to get a numeric height
    known = {"up": up.direction, "up_sigma": math.radians(up.sigma)} if up.direction is not None else {}
    fit, inliers = None, np.zeros(len(source), bool)
    for _ in range(MAX_ITERATIONS):
        gaps = source @ T[:3, :3].T + T[:3, 3] - target
        agree, factors = _agreeing(gaps, sigma, inliers)
        if agree.sum() < MIN_POSITIONS:
            raise UndeterminedError(f"only {agree.sum()} of {len(source)} GPS positions agree with the model")
        fit = fit_rows(Rows(source[agree], filled[agree], (sigma * factors)[agree], **known), T)
        T = fit.T
        if (agree == inliers).all():
            break
        inliers = agree
    assert fit is not None
    return fit, inliers


def _agreeing(gaps: Array, sigma: Array, before: NDArray[np.bool_]) -> tuple[NDArray[np.bool_], Array]:
    """Mask of the inliers, and the ratio of actual to stated errors along each axis."""
    count = len(gaps)
    # small sample correction of the median (Rousseeuw and Leroy 1987)
    slack = 1.0 + 5.0 / max(count - MIN_POSITIONS, 1)
    plan = np.linalg.norm(gaps[:, :2], axis=1) / sigma[:, 0]
    height = np.abs(gaps[:, 2]) / sigma[:, 2]
    known = np.isfinite(height) & np.isfinite(sigma[:, 2])
    reference = before if before.sum() > MIN_POSITIONS else np.ones(count, bool)
    worse = np.ones(3)
    limits = [OUTLIER_RESIDUAL * slack * float(np.median(plan)) / _MEDIAN_PLAN, math.inf]
    if (known & reference).any():
        limits[1] = OUTLIER_RESIDUAL * slack * float(np.median(height[known & reference])) / _MEDIAN_HEIGHT
    limits = [max(limit, 0.1) for limit in limits]  # lower bound, in stated sigmas
    agree = (plan <= limits[0]) & (~known | (height <= limits[1]))
    if agree.sum() >= MIN_POSITIONS_FOR_ACCURACY:
        worse[:2] = _spread_of(plan[agree] / math.sqrt(2.0))
        if (known & agree).sum() >= MIN_POSITIONS_FOR_ACCURACY:
            worse[2] = _spread_of(height[known & agree])
    return agree, worse


def _spread_of(errors: Array) -> float:
    """Standard deviation of normalized residuals after a fit of 7 unknowns, at least 0.01."""
    count = len(errors)
    return max(math.sqrt(float((errors**2).sum()) / (count - 7.0 / 3.0)), 0.01)
