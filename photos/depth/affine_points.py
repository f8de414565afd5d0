"""From a point map that lacks a shift along the view to depth: MoGe's focal length and shift.

The network gives points (x, y, z) of a pinhole camera whose z lacks a shift and whose focal length is not said (Wang et
al. 2025, "MoGe", section 3.1). Both are those that put the points where their pixels are:

    min over f, s of   sum | f (x, y) / (z + s) - (u, v) |^2 ,   (u, v) from the middle of the picture

f is linear and is solved for at each s, so one unknown is left; it is searched for over eight decades, then by golden
section, which ends in the one minimum that a start at 0 may miss. Some 4,000 points of a grid are enough for two
unknowns. On the host: a few ms. The same bits always.
"""

from __future__ import annotations

import dataclasses

import numpy as np
from numpy.typing import NDArray

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
