"""Result of the alignment of two frames and its reliability."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.reports import Assessed


@dataclasses.dataclass(frozen=True, eq=False)
class OdometryResult(Assessed):
    """The motion between two frames. Unpacks as Open3D's (reliable, transformation, information).

    Attributes:
        transformation: T_target_source, float64 [4, 4]; where it failed, the latest guess.
        information: Of the pixels that agree, about the target's camera, rotation first, float64 [6, 6], as Open3D's
            pose graphs want it: its last entry counts them, scaled to the full picture. Zero where it failed.
        warnings: Why the motion is unreliable; empty if it is reliable.
        inliers: Pixels of the source that lie on the target's surface, at the size that was compared.
        fitness: Their share of the source's pixels with depth.
        overlap: Share of the source's pixels with depth that the target shows with depth.
        inlier_rmse: Distance from the target's surface [m], root of the mean square.
        intensity_rmse: Difference of brightness, 0..1, after the exposures are brought together; NaN without colours.
        smallest_eigenvalue: How much the least determined motion costs by 1 cm: a pixel's mean square, in variances
            of the noise. Below 0.015 the frames do not determine it.
        iterations: Steps taken in all levels.
        contradiction: What the pixels that lie on the target's surface say against the motion by their normals, their
            distances or their brightness; empty where nothing. Somebody who stands in front of a scene hides pixels,
            but does not change what the others say.
        covariance: Of the motion about the target's camera, rotation first [rad, m], float64 [6, 6]: how far it may be
            off by noise. It holds where nothing speaks against the motion.
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

    def __iter__(self) -> Iterator[Any]:
        return iter((self.reliable, self.transformation, self.information))

    def __repr__(self) -> str:
        verdict = "reliable" if self.reliable else f"unreliable: {'; '.join(self.warnings)}"
        rmse = f"inlier_rmse {self.inlier_rmse:.6g}"
        return f"OdometryResult({verdict}, fitness {self.fitness:.4f}, {rmse}, {self.iterations} iterations)"


def spread_information(count: float, moments: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sum of G^T G, G = [-[q]x, I], of points q by their sums and those of their products above the diagonal."""
    x, y, z, xx, xy, xz, yy, yz, zz = moments
    out = np.zeros((6, 6))
    out[:3, :3] = [[yy + zz, -xy, -xz], [-xy, xx + zz, -yz], [-xz, -yz, xx + yy]]
    out[:3, 3:] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    out[3:, :3] = out[:3, 3:].T
    out[3:, 3:] = count * np.eye(3)
    return out
