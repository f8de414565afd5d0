"""What odometry reports: one record a scan, and a summary of the run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..pcd.checks import check_list

Matrix = NDArray[np.float64]

# Of a scan's misfit, above which it lies beside the map. On drives whose truth is known (a made-up street at 5 to
# 30 m/s, voxels of 0.5 to 4 m, all scans or every second to thirteenth) the worst step of paths that were right had
# 0.41 to 0.69, of lost ones 0.71 to 0.96; of a real pair of scans 0.49 to 0.60, of real submaps 3 to 12 m apart 0.75 to
# 1.05.
STRAYED_MISFIT = 0.7


@dataclass(frozen=True, eq=False)
class OdometryStep:
    """What became of one scan.

    Attributes:
        index: Number of the scan, from 0.
        pose: T_world_sensor at the end of the scan, float64 [4, 4]; the world is the sensor's frame of the first scan.
        threshold: Standard deviation [m] of the prediction's error: correspondences lie within three of it.
        inliers: Points of the thinned scan with a correspondence in the map.
        fitness: Their share of the thinned scan, 0..1.
        inlier_rmse: Root of their mean squared distance [m].
        iterations: Turns of the ICP loop.
        converged: Whether the loop came to rest, or there was nothing to match yet.
        is_predicted: Whether the pose is that of constant velocity alone: the scan did not tell.
        reason: "converged", "first scan", "max_iteration", "no points in range" or "no overlap".
        misfit: `inlier_rmse` in edges of the map's voxels: some 0.3 to 0.6 where the scan lies on the map.
    """

    index: int
    pose: Matrix
    threshold: float
    inliers: int
    fitness: float
    inlier_rmse: float
    iterations: int
    converged: bool
    is_predicted: bool
    reason: str
    misfit: float = 0.0

    @property
    def has_strayed(self) -> bool:
        """Whether the scan lies beside the map, on other things than those it shows, however many points pair up."""
        return not self.is_predicted and self.misfit > STRAYED_MISFIT

    @property
    def is_unsettled(self) -> bool:
        """Whether the loop was still moving the scan when its turns ran out."""
        return self.reason == "max_iteration"


@dataclass(frozen=True)
class OdometrySummary:
    """A run of odometry in a few numbers.

    Attributes:
        scan_count: Scans so far.
        distance: Length of the path [m].
        predicted: Numbers of the scans whose pose was only predicted: the path may be torn there.
        unsettled: Numbers of the scans whose loop did not come to rest: a few are usual, many tell of a lost path.
        strayed: Numbers of the scans that lie beside the map: the path is likely wrong from the first of them on.
        mean_fitness: Of the scans that were matched; NaN where there are none.
        mean_iterations: Likewise.
    """

    scan_count: int
    distance: float
    predicted: tuple[int, ...]
    unsettled: tuple[int, ...]
    strayed: tuple[int, ...]
    mean_fitness: float
    mean_iterations: float


def summarize_steps(steps: Sequence[OdometryStep]) -> OdometrySummary:
    """The run that these steps make up.

    Example:
        >>> import pointloom as loom
        >>> wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
        >>> steps = list(loom.registration.iterate_odometry([wall, loom.PointCloud(), wall]))
        >>> loom.registration.summarize_steps(steps).predicted
        (1,)
    """
    steps = check_list("steps", steps, "OdometryStep")
    for step in steps:
        if not isinstance(step, OdometryStep):
            raise TypeError(f"steps: expected a list of OdometryStep, got one of {type(step).__name__}")
    matched = [step for step in steps if step.iterations]
    path = np.array([step.pose[:3, 3] for step in steps]).reshape(-1, 3)
    return OdometrySummary(
        len(steps),
        float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum()),
        tuple(step.index for step in steps if step.is_predicted),
        tuple(step.index for step in steps if step.is_unsettled),
        tuple(step.index for step in steps if step.has_strayed),
        float(np.mean([step.fitness for step in matched])) if matched else math.nan,
        float(np.mean([step.iterations for step in matched])) if matched else math.nan,
    )
