"""Conversion of network outputs to a map of the image size, and the focal length if the network estimates one.

- "map": the output unchanged.
- "canonical": Depth Pro's inverse depth c. Returns 1 / c, the depth if f is the image width, without the focal length
  of metric exports. 10 km and more is invalid (clamped by its `infer`).
- "points": MoGe-2: points up to a shift and a scale, a sky mask, the metric scale.
- "camera": UniDepth V2: points or depth in meters, and the camera matrix.

MoGe's focal length f and shift s (Wang et al. 2025, "MoGe", section 3.1) minimize sum |f (x, y) / (z + s) - (u, v)|^2.
f is linear at each s, which is found by golden section search on some 4,000 points after a scan of eight decades.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .heads import RECIPROCAL
from .inputs import Map, Placement, bring_back
from .presets import Preset

Numbers = NDArray[np.float64]

GRID_SIDE = 64  # rows and columns of sampled points
BEHIND_CAMERA_PERCENTILE = 0.5  # percentile of points that may be behind the camera: ragged mask border
DEPTH_DECADES = (-4.0, 4.0)  # log10 of the nearest depth relative to the extent of the points
DEPTH_STEPS = 200  # search steps, 10% each
GOLDEN_SECTION_STEPS = 60  # steps that reduce the bracket to 1e-12
OTHER_FOCAL = 1.25  # a focal length changed by this factor, with its own best shift, ...
MIN_RISE = 1.1  # ... must fit worse by this factor (a frontal wall fits any) ...
MIN_MISS = 2e-3  # ... and by this fraction of half the diagonal, about a pixel


@dataclasses.dataclass(frozen=True)
class Pinhole:
    """Focal length [px of the map] (None if undetermined), z shift, and root mean square error [px] of a point map."""

    focal: tuple[float, float] | None
    shift: float
    error: float


def recover_pinhole(points: Numbers, valid: NDArray[np.bool_], focal: tuple[float, float] | None) -> Pinhole | None:
    """The focal length and shift of a point map [h, w, 3], or the shift if `focal` is known. None if too sparse."""
    rows, columns = (np.unique(np.linspace(0, side - 1, GRID_SIDE).round().astype(int)) for side in valid.shape)
    grid = np.ix_(rows, columns)
    v, u = np.meshgrid(rows - (valid.shape[0] - 1) / 2, columns - (valid.shape[1] - 1) / 2, indexing="ij")
    seen = valid[grid] & np.isfinite(points[grid]).all(-1)
    if seen.sum() < 2:
        return None
    x, y, z = (points[grid][seen][:, k].astype(np.float64) for k in range(3))
    near = float(np.percentile(z, BEHIND_CAMERA_PERCENTILE))
    far_enough = z >= near
    sample = _Sample(x[far_enough], y[far_enough], z[far_enough] - near, u[seen][far_enough], v[seen][far_enough])
    if focal is not None:
        nearest, cost = sample.search(focal)
        return Pinhole(focal, nearest - near, cost**0.5)
    nearest, cost = sample.search(None)
    best_focal = sample.focal(nearest)
    others = (best_focal * OTHER_FOCAL, best_focal / OTHER_FOCAL)
    min_rise = MIN_RISE**2 * cost + MIN_MISS**2 * float((sample.u**2 + sample.v**2).max())
    is_fixed = best_focal > 0 and all(sample.search((other, other))[1] > min_rise for other in others)
    return Pinhole((best_focal, best_focal) if is_fixed else None, nearest - near, cost**0.5)


@dataclasses.dataclass(frozen=True)
class _Sample:
    x: Numbers
    y: Numbers
    z: Numbers
    u: Numbers
    v: Numbers

    def focal(self, nearest: float) -> float:
        """The best focal length if the nearest point is at this depth."""
        p, q = self.x / (self.z + nearest), self.y / (self.z + nearest)
        return float((p * self.u + q * self.v).sum() / max(float((p * p + q * q).sum()), 1e-300))

    def cost(self, nearest: float, focal: tuple[float, float] | None) -> float:
        fx, fy = (self.focal(nearest),) * 2 if focal is None else focal
        across, down = fx * self.x / (self.z + nearest) - self.u, fy * self.y / (self.z + nearest) - self.v
        return float((across * across + down * down).mean())

    def search(self, focal: tuple[float, float] | None) -> tuple[float, float]:
        """The best depth of the nearest point, and its cost."""
        extent = max(float(np.ptp(axis)) for axis in (self.x, self.y, self.z))
        steps = np.log(max(extent, 1e-12)) + np.linspace(*DEPTH_DECADES, DEPTH_STEPS) * np.log(10)
        best = int(np.argmin([self.cost(float(np.exp(step)), focal) for step in steps]))
        low, high = float(steps[max(best - 1, 0)]), float(steps[min(best + 1, DEPTH_STEPS - 1)])
        fraction = (5**0.5 - 1) / 2
        for _ in range(GOLDEN_SECTION_STEPS):
            first, second = high - fraction * (high - low), low + fraction * (high - low)
            if self.cost(float(np.exp(first)), focal) <= self.cost(float(np.exp(second)), focal):
                high = second
            else:
                low = first
        nearest = float(np.exp((low + high) / 2))
        return nearest, self.cost(nearest, focal)


DEPTH_PRO_MAX_DEPTH = 1e4  # [m] Depth Pro's clamp
MIN_MASK = 0.5  # MoGe's mask threshold, as in its `infer`
FOCAL_LENGTH_RANGE = (0.1, 50.0)  # relative to the image width: 157 and 1 degrees
MAX_ERROR = 0.1  # maximum error of MoGe's points, relative to half the diagonal. Pinhole images have 0.01


class ReadingError(Exception):
    """Outputs that contradict the preset; `remedy` applies if they belong to another one."""

    def __init__(self, reason: str, remedy: str | None = None):
        super().__init__(reason)
        self.remedy = remedy


@dataclasses.dataclass(frozen=True)
class OwnCamera:
    """Camera estimated by a network: focal lengths and principal point [image px]."""

    fx: float
    fy: float
    cx: float
    cy: float


@dataclasses.dataclass(frozen=True)
class Reading:
    """A network's map at the image size (NaN where unknown); `is_metric` is None if it follows from the preset."""

    values: Map
    placement: Placement
    camera: OwnCamera | None = None
    is_metric: bool | None = None


def read_outputs(
    preset: Preset,
    head: str | None,
    given: dict[str, Any],
    placement: Placement,
    focal: tuple[float, float],
    *,
    is_known: bool,
) -> Reading:
    """Convert the outputs by name; `focal` [px] is that of the image, known or assumed."""
    if preset.reading == "canonical":
        return _read_canonical(head, given, placement)
    if preset.reading == "points":
        return _read_points(given, placement, focal, is_known=is_known)
    if preset.reading == "camera":
        return _read_with_camera(given, placement)
    values = _plane(given["depth"], placement)
    return Reading(bring_back(_with_range(values), placement), placement)


def _read_canonical(head: str | None, given: dict[str, Any], placement: Placement) -> Reading:
    values = _with_range(_plane(given["depth"], placement))
    own = _own_focal(given, placement)
    with np.errstate(divide="ignore", invalid="ignore"):
        if head == RECIPROCAL:
            if own is None:
                meters = bring_back(
                    np.where(values < 0.999 * DEPTH_PRO_MAX_DEPTH, values, np.float32(np.nan)), placement
                )
                return Reading(meters, placement, is_metric=True)
            own_fraction = np.float32(own / placement.width)
            values = np.where(values < 0.999 * DEPTH_PRO_MAX_DEPTH, own_fraction / values, np.float32(0))
        canonical = bring_back(np.asarray(values, np.float32), placement)
        depth = np.where(canonical * DEPTH_PRO_MAX_DEPTH > 1, np.float32(1) / canonical, np.float32(np.nan)).astype(
            np.float32
        )
    middle = (placement.width - 1) / 2, (placement.height - 1) / 2
    return Reading(depth, placement, None if own is None else OwnCamera(own, own, *middle))


def _own_focal(given: dict[str, Any], placement: Placement) -> float | None:
    """Depth Pro's focal length along x [image px]."""
    if "focal" in given:
        focal = _number(given["focal"]) * placement.width / placement.columns
        description = f"a focal length of {focal:g} px for {placement.width} columns"
    elif "view" in given:
        view = _number(given["view"])
        focal = placement.width / 2 / max(math.tan(math.radians(view) / 2), 1e-9) if 0 < view < 180 else 0.0
        description = f"a field of view of {view:g} degrees"
    else:
        return None
    if not FOCAL_LENGTH_RANGE[0] < focal / placement.width < FOCAL_LENGTH_RANGE[1]:
        raise ReadingError(f"returned {description}, which no lens has")
    return focal


def _read_points(given: dict[str, Any], placement: Placement, focal: tuple[float, float], *, is_known: bool) -> Reading:
    """Depth of a point map. Up to scale if no focal length is known."""
    rows, columns = placement.rows, placement.columns
    points = np.asarray(given["depth"], np.float64)
    if points.shape != (1, rows, columns, 3):
        raise ReadingError(f"expected points of shape [1, {rows}, {columns}, 3], got {list(points.shape)}")
    valid = np.isfinite(points[0]).all(-1)
    if "mask" in given:
        mask = np.asarray(given["mask"], np.float32)
        if mask.size != rows * columns:
            raise ReadingError(f"expected a mask of shape [1, {rows}, {columns}], got {list(mask.shape)}")
        valid &= mask.reshape(rows, columns) > MIN_MASK
    scale = _number(given["scale"])
    if not scale > 0:
        raise ReadingError(f"expected a scale > 0, got {scale:g}")
    inside = np.zeros((rows, columns), bool)
    inside[_inside(placement)] = True
    across, down = placement.scale
    of_map = focal[0] * across, focal[1] * down
    pinhole = recover_pinhole(points[0], valid & inside, of_map if is_known else None)
    fixed = pinhole is not None and pinhole.focal is not None
    if pinhole is not None and not fixed:
        pinhole = recover_pinhole(points[0], valid & inside, of_map)
    if pinhole is None or pinhole.focal is None:
        raise ReadingError("returned almost no points outside the sky")
    error = pinhole.error / math.hypot(*placement.used) * 2
    if error > MAX_ERROR:
        camera, remedy = ("the given camera", "Check the camera") if is_known else ("any focal length", None)
        reason = f"returned points that project {error:.0%} of half the diagonal away from their pixels, with {camera}"
        raise ReadingError(reason, remedy)
    z = np.where(valid, scale * (points[0, ..., 2] + pinhole.shift), np.nan).astype(np.float32)
    middle = (placement.width - 1) / 2, (placement.height - 1) / 2
    own = OwnCamera(pinhole.focal[0] / across, pinhole.focal[1] / down, *middle) if fixed and not is_known else None
    return Reading(bring_back(z, placement), placement, own, is_metric=fixed)


def _read_with_camera(given: dict[str, Any], placement: Placement) -> Reading:
    maps = np.asarray(given["depth"], np.float32)
    if maps.shape == (1, 3, placement.rows, placement.columns):
        maps = maps[:, 2]
    depth = bring_back(_with_range(_plane(maps, placement)), placement)
    if "camera" not in given:
        return Reading(depth, placement)
    matrix = np.asarray(given["camera"], np.float64)
    if matrix.size != 9 or not np.isfinite(matrix).all():
        raise ReadingError(f"expected a finite camera of shape [1, 3, 3], got {list(matrix.shape)}")
    (fx, _, cx), (_, fy, cy), _ = matrix.reshape(3, 3)
    across, down = placement.scale
    if not all(FOCAL_LENGTH_RANGE[0] < focal / placement.used[1] < FOCAL_LENGTH_RANGE[1] for focal in (fx, fy)):
        raise ReadingError(f"returned focal lengths of {fx:g} and {fy:g} px, which no lens has")
    # UniDepth's pixel centers are at half integers
    middle = (cx - placement.left) / across - 0.5, (cy - placement.top) / down - 0.5
    return Reading(depth, placement, OwnCamera(fx / across, fy / down, *middle))


def _plane(given: Any, placement: Placement) -> Map:
    size = (placement.rows, placement.columns)
    shape = list(np.shape(given))
    if len(shape) < 3 or tuple(shape[-2:]) != size or any(extent != 1 for extent in shape[:-2]):
        raise ReadingError(f"expected [1, {size[0]}, {size[1]}] for an input of {size[0]} x {size[1]}, got {shape}")
    values = np.asarray(given, np.float32).reshape(size)
    if not np.isfinite(values).all():
        fraction = 1 - np.isfinite(values).mean()
        raise ReadingError(f"{fraction:.1%} of the output is NaN or infinite", "Use a float32 export of the model")
    return values


def _with_range(values: Map) -> Map:
    if values.size > 1 and np.nanmax(values) == np.nanmin(values):
        raise ReadingError(f"returned {np.nanmax(values):g} for every pixel, so there is no depth")
    return values


def _inside(placement: Placement) -> tuple[slice, slice]:
    top, left, used = placement.top, placement.left, placement.used
    return slice(top, top + used[0]), slice(left, left + used[1])


def _number(given: Any) -> float:
    array: NDArray[Any] = np.asarray(given)
    if array.size != 1 or not np.isfinite(array).all():
        raise ReadingError(f"expected one number, got shape {list(array.shape)}")
    return float(array.reshape(-1)[0])
