"""Result of the alignment of two frames and its reliability."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import AssessedRecord


@dataclasses.dataclass(frozen=True, eq=False)
class OdometryResult(AssessedRecord):
    """The motion between two frames. Unpacks as Open3D's (reliable, transformation, information).

    Attributes:
        transformation: T_target_source, float64 [4, 4]. The last estimate if it failed.
        information: Of the inlier pixels, about the target's camera, rotation first, float64 [6, 6], as in Open3D's
            pose graphs. The last entry is their number at full size. Zero if it failed.
        warnings: Why the motion is unreliable. Empty if it is reliable.
        inliers: Source pixels on the target's surface, at the compared size.
        fitness: Their fraction of the source's depth pixels.
        overlap: Fraction of the source's depth pixels where the target has depth.
        inlier_rmse: Root mean square distance from the target's surface [m].
        intensity_rmse: Brightness difference, 0..1, after exposure correction. NaN without color.
        smallest_eigenvalue: Mean squared cost of 1 cm along the least determined motion, in noise variances; below
            0.015 the motion is undetermined.
        iterations: Steps in all levels.
        contradiction: Contradiction of the inliers by normals, distances or brightness, or empty. Ignores occlusion.
        covariance: Of the motion about the target's camera, rotation first [rad, m], float64 [6, 6]. Errors that both
            frames share, of a lens for example, are not included. Valid if the motion is not contradicted.
        check_covariance: A wider one, for the checks of tracking: residuals do not contain all errors of a model.
        unit_covariance: That of an error of 1 m along each motion of the inliers, rotations in units of their spread.
        bias: Root mean square distance from the surface [m] beyond the noise of the sensor, by errors that neighboring
            pixels share.
    """

    transformation: NDArray[np.float64]
    information: NDArray[np.float64]
    warnings: tuple[str, ...] = ()
    inliers: int = 0
    fitness: float = 0.0
    overlap: float = 0.0
    inlier_rmse: float = 0.0
    intensity_rmse: float = float("nan")
    smallest_eigenvalue: float = 0.0
    iterations: int = 0
    contradiction: str = ""
    covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))
    check_covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))
    unit_covariance: NDArray[np.float64] = dataclasses.field(default_factory=lambda: np.zeros((6, 6)))
    bias: float = 0.0

    def __iter__(self) -> Iterator[Any]:
        return iter((self.reliable, self.transformation, self.information))

    def __repr__(self) -> str:
        status = "reliable" if self.reliable else f"unreliable: {'; '.join(self.warnings)}"
        rmse = f"inlier_rmse {self.inlier_rmse:.6g}"
        return f"OdometryResult({status}, fitness {self.fitness:.4f}, {rmse}, {self.iterations} iterations)"


def spread_information(count: float, moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sum of G^T G, G = [-[q]x, I], from the first and second moments of points q."""
    x, y, z, xx, xy, xz, yy, yz, zz = moments
    out = np.zeros((6, 6))
    out[:3, :3] = [[yy + zz, -xy, -xz], [-xy, xx + zz, -yz], [-xz, -yz, xx + yy]]
    out[:3, 3:] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    out[3:, :3] = out[:3, 3:].T
    out[3:, 3:] = count * np.eye(3)
    return out
