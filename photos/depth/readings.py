"""What a network's outputs say: a map of the picture's size, and the focal length where the network finds one.

- "map": the output as it is.
- "canonical": Depth Pro. Canonical inverse depth c, which is resized as in its `infer`; given back is 1 / c, the depth
  where f is the picture's width. An export that gives metres has used its own focal length, which is taken out again,
  since a known one is better (`infer(f_px=...)`). 10 km and farther is none: there `infer` clamps.
- "points": MoGe-2. Points up to a shift and a scale along the view, a mask of the sky, the scale to metres.
  Metres along the optical axis.
- "camera": UniDepth V2. Points or depth in metres, and the camera matrix that the network found.

From a point map that lacks a shift along the view to depth: MoGe's focal length and shift. The network gives points (x,
y, z) of a pinhole camera whose z lacks a shift and whose focal length is not said (Wang et al. 2025, "MoGe", section
3.1). Both are those that put the points where their pixels are:

    min over f, s of   sum | f (x, y) / (z + s) - (u, v) |^2 ,   (u, v) from the middle of the picture

f is linear and is solved for at each s, so one unknown is left; it is searched for over eight decades, then by golden
section, which ends in the one minimum that a start at 0 may miss. Some 4,000 points of a grid are enough for two
unknowns. On the host: a few ms. The same bits always.
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

GRID = 64  # rows and columns of points that are looked at
NEAREST = 0.5  # percent of the points that may lie behind the camera: the mask's ragged rim
DECADES = (-4.0, 4.0)  # of the nearest point's depth over the extent of the points
STEPS = 200  # of the search: 10 % each
GOLDEN = 60  # steps that leave 1e-12 of the bracket
OTHER_FOCAL = 1.25  # a focal length this much longer or shorter, with its own best shift, ...
LEAST_RISE = 1.1  # ... must fit worse by this factor; a wall seen from the front fits any as well ...
LEAST_MISS = 2e-3  # ... and by this share of half the diagonal: a pixel of a thousand, no network's points are better


@dataclasses.dataclass(frozen=True)
class Pinhole:
    """What puts points where their pixels are.

    Args:
        focal: Along x and y [px of the map]; None where the points do not fix it.
        shift: What z lacks.
        error: How far the points then lie from their pixels, root mean square [px of the map].
    """

    focal: tuple[float, float] | None
    shift: float
    error: float


def recover_pinhole(points: Numbers, valid: NDArray[np.bool_], focal: tuple[float, float] | None) -> Pinhole | None:
    """The focal length and shift of a point map, or the shift alone where the focal length is known.

    Args:
        points: Shape [h, w, 3].
        valid: Which of them are points, shape [h, w].
        focal: Along x and y [px of the map], or None.

    Returns:
        None where there are hardly points.
    """
    rows, columns = (np.unique(np.linspace(0, side - 1, GRID).round().astype(int)) for side in valid.shape)
    grid = np.ix_(rows, columns)
    v, u = np.meshgrid(rows - (valid.shape[0] - 1) / 2, columns - (valid.shape[1] - 1) / 2, indexing="ij")
    seen = valid[grid] & np.isfinite(points[grid]).all(-1)
    if seen.sum() < 2:
        return None
    x, y, z = (points[grid][seen][:, k].astype(np.float64) for k in range(3))
    near = float(np.percentile(z, NEAREST))
    kept = z >= near
    sample = _Sample(x[kept], y[kept], z[kept] - near, u[seen][kept], v[seen][kept])
    if focal is not None:
        nearest, cost = sample.search(focal)
        return Pinhole(focal, nearest - near, cost**0.5)
    nearest, cost = sample.search(None)
    found = sample.focal(nearest)
    others = (found * OTHER_FOCAL, found / OTHER_FOCAL)
    least = LEAST_RISE**2 * cost + LEAST_MISS**2 * float((sample.u**2 + sample.v**2).max())
    is_fixed = found > 0 and all(sample.search((other, other))[1] > least for other in others)
    return Pinhole((found, found) if is_fixed else None, nearest - near, cost**0.5)


@dataclasses.dataclass(frozen=True)
class _Sample:
    x: Numbers
    y: Numbers
    z: Numbers
    u: Numbers
    v: Numbers

    def focal(self, nearest: float) -> float:
        """The focal length that fits best where the nearest point lies so far off."""
        p, q = self.x / (self.z + nearest), self.y / (self.z + nearest)
        return float((p * self.u + q * self.v).sum() / max(float((p * p + q * q).sum()), 1e-300))

    def cost(self, nearest: float, focal: tuple[float, float] | None) -> float:
        """Mean squared distance of the points from their pixels."""
        fx, fy = (self.focal(nearest),) * 2 if focal is None else focal
        across, down = fx * self.x / (self.z + nearest) - self.u, fy * self.y / (self.z + nearest) - self.v
        return float((across * across + down * down).mean())

    def search(self, focal: tuple[float, float] | None) -> tuple[float, float]:
        """How far off the nearest point lies, and what that costs."""
        extent = max(float(np.ptp(axis)) for axis in (self.x, self.y, self.z))
        steps = np.log(max(extent, 1e-12)) + np.linspace(*DECADES, STEPS) * np.log(10)
        best = int(np.argmin([self.cost(float(np.exp(step)), focal) for step in steps]))
        low, high = float(steps[max(best - 1, 0)]), float(steps[min(best + 1, STEPS - 1)])
        share = (5**0.5 - 1) / 2
        for _ in range(GOLDEN):
            first, second = high - share * (high - low), low + share * (high - low)
            if self.cost(float(np.exp(first)), focal) <= self.cost(float(np.exp(second)), focal):
                high = second
            else:
                low = first
        nearest = float(np.exp((low + high) / 2))
        return nearest, self.cost(nearest, focal)


FARTHEST = 1e4  # [m] to which Depth Pro clamps
LEAST_MASK = 0.5  # of MoGe's mask, as in its `infer`
FOCALS = (0.1, 50.0)  # over the picture's width: 157 and 1 degrees; else it is no focal length
MOST_ERROR = (
    0.1  # of half the diagonal by which MoGe's points may miss their pixels; a map of a pinhole's picture: 0.01
)


class ReadingError(Exception):
    """Outputs that are not what the preset says; the message says how, `remedy` what to do where that is another."""

    def __init__(self, reason: str, remedy: str | None = None):
        super().__init__(reason)
        self.remedy = remedy


@dataclasses.dataclass(frozen=True)
class OwnCamera:
    """The camera that a network found in a picture: focal lengths and principal point [px of the picture]."""

    fx: float
    fy: float
    cx: float
    cy: float


@dataclasses.dataclass(frozen=True)
class Reading:
    """What a network says of a picture.

    Args:
        values: Map of the picture's size in the network's own unit; NaN where it sees nothing.
        placement: Where the picture lay in the input.
        camera: What the network found; None of most.
        is_metric: Values are metres, or lack a scale, whatever the camera; None where that follows from the preset.
    """

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
    """What outputs say.

    Args:
        preset: Which network it is.
        head: What its graph ends in.
        given: Outputs by what they hold: "depth", and those of `Preset.others`.
        placement: Where the picture lay in the input.
        focal: Of the picture's camera along x and y [px].
        is_known: Whether that is known, and not only assumed.

    Raises:
        ReadingError: They are not what the preset says.
    """
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
                metres = bring_back(np.where(values < 0.999 * FARTHEST, values, np.float32(np.nan)), placement)
                return Reading(metres, placement, is_metric=True)
            own_share = np.float32(own / placement.width)
            values = np.where(values < 0.999 * FARTHEST, own_share / values, np.float32(0))
        canonical = bring_back(np.asarray(values, np.float32), placement)
        depth = np.where(canonical * FARTHEST > 1, np.float32(1) / canonical, np.float32(np.nan)).astype(np.float32)
    middle = (placement.width - 1) / 2, (placement.height - 1) / 2
    return Reading(depth, placement, None if own is None else OwnCamera(own, own, *middle))


def _own_focal(given: dict[str, Any], placement: Placement) -> float | None:
    """The focal length that Depth Pro found, along x [px of the picture]."""
    if "focal" in given:
        focal = _number(given["focal"]) * placement.width / placement.columns
        said = f"a focal length of {focal:g} px for {placement.width} columns"
    elif "view" in given:
        view = _number(given["view"])
        focal = placement.width / 2 / max(math.tan(math.radians(view) / 2), 1e-9) if 0 < view < 180 else 0.0
        said = f"a field of view of {view:g} degrees"
    else:
        return None
    if not FOCALS[0] < focal / placement.width < FOCALS[1]:
        raise ReadingError(f"gave {said}, which no lens has")
    return focal


def _read_points(given: dict[str, Any], placement: Placement, focal: tuple[float, float], *, is_known: bool) -> Reading:
    """Depth of a point map; where neither the camera nor the points tell the focal length, up to a scale."""
    rows, columns = placement.rows, placement.columns
    points = np.asarray(given["depth"], np.float64)
    if points.shape != (1, rows, columns, 3):
        raise ReadingError(f"gave points of {list(points.shape)}, expected [1, {rows}, {columns}, 3]")
    valid = np.isfinite(points[0]).all(-1)
    if "mask" in given:
        mask = np.asarray(given["mask"], np.float32)
        if mask.size != rows * columns:
            raise ReadingError(f"gave a mask of {list(mask.shape)}, expected [1, {rows}, {columns}]")
        valid &= mask.reshape(rows, columns) > LEAST_MASK
    scale = _number(given["scale"])
    if not scale > 0:
        raise ReadingError(f"gave a scale of {scale:g}")
    inside = np.zeros((rows, columns), bool)
    inside[_inside(placement)] = True
    across, down = placement.scale
    of_map = focal[0] * across, focal[1] * down
    found = recover_pinhole(points[0], valid & inside, of_map if is_known else None)
    fixed = found is not None and found.focal is not None
    if found is not None and not fixed:
        found = recover_pinhole(points[0], valid & inside, of_map)
    if found is None or found.focal is None:
        raise ReadingError("gave hardly a point that is not sky")
    error = found.error / math.hypot(*placement.used) * 2
    if error > MOST_ERROR:
        camera, remedy = ("the camera given", "Check the camera") if is_known else ("any focal length", None)
        reason = (
            f"gave points that do not lie where their pixels are, by {error:.0%} of half the diagonal, with {camera}"
        )
        raise ReadingError(reason, remedy)
    z = np.where(valid, scale * (points[0, ..., 2] + found.shift), np.nan).astype(np.float32)
    middle = (placement.width - 1) / 2, (placement.height - 1) / 2
    own = OwnCamera(found.focal[0] / across, found.focal[1] / down, *middle) if fixed and not is_known else None
    return Reading(bring_back(z, placement), placement, own, is_metric=fixed)


def _read_with_camera(given: dict[str, Any], placement: Placement) -> Reading:
    found = np.asarray(given["depth"], np.float32)
    if found.shape == (1, 3, placement.rows, placement.columns):
        found = found[:, 2]
    depth = bring_back(_with_range(_plane(found, placement)), placement)
    if "camera" not in given:
        return Reading(depth, placement)
    matrix = np.asarray(given["camera"], np.float64)
    if matrix.size != 9 or not np.isfinite(matrix).all():
        raise ReadingError(f"gave a camera of {list(matrix.shape)}, expected [1, 3, 3]")
    (fx, _, cx), (_, fy, cy), _ = matrix.reshape(3, 3)
    across, down = placement.scale
    if not all(FOCALS[0] < focal / placement.used[1] < FOCALS[1] for focal in (fx, fy)):
        raise ReadingError(f"gave focal lengths of {fx:g} and {fy:g} px, which no lens has")
    # its pixels' middles lie at halves, ours at whole numbers
    middle = (cx - placement.left) / across - 0.5, (cy - placement.top) / down - 0.5
    return Reading(depth, placement, OwnCamera(fx / across, fy / down, *middle))


def _plane(given: Any, placement: Placement) -> Map:
    """An output as a map of the input's size, once it is one."""
    size = (placement.rows, placement.columns)
    found = list(np.shape(given))
    if len(found) < 3 or tuple(found[-2:]) != size or any(extent != 1 for extent in found[:-2]):
        raise ReadingError(f"gave {found} for an input of {size[0]} x {size[1]}, expected [1, {size[0]}, {size[1]}]")
    values = np.asarray(given, np.float32).reshape(size)
    if not np.isfinite(values).all():
        share = 1 - np.isfinite(values).mean()
        raise ReadingError(f"{share:.1%} of what it gave is NaN or infinite", "Take a float32 export of it")
    return values


def _with_range(values: Map) -> Map:
    """The same, once it does not say one thing everywhere."""
    if values.size > 1 and np.nanmax(values) == np.nanmin(values):
        raise ReadingError(f"gave {np.nanmax(values):g} for every pixel, so no depth was seen")
    return values


def _inside(placement: Placement) -> tuple[slice, slice]:
    top, left, used = placement.top, placement.left, placement.used
    return slice(top, top + used[0]), slice(left, left + used[1])


def _number(given: Any) -> float:
    array: NDArray[Any] = np.asarray(given)
    if array.size != 1 or not np.isfinite(array).all():
        raise ReadingError(f"gave {list(array.shape)} where one number was expected")
    return float(array.reshape(-1)[0])
