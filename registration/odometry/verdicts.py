"""Whether a motion that was found is to be believed."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...kernels.rgbd import verdict_rows as at
from .results import OdometryResult

LEAST_OVERLAP = 0.25
LEAST_INLIERS = 0.6
MOST_IN_FRONT = 0.1
LEAST_AGREEMENT = 0.75
LEAST_CORRELATION = 0.3
LEAST_EIGENVALUE = 0.015
SHIFT = 0.01


def judge(found: Any, source: Any, target: Any, method: Any, rules: Any) -> OdometryResult:
    """The result of an Alignment."""
    v = found.verdict
    pixels, seen, inliers = v[at.PIXELS], v[at.SEEN], v[at.INLIERS]
    reason = _first_fault(found, pixels, seen, inliers)
    smallest = smallest_eigenvalue(found.certainty, v)
    if not reason and smallest < LEAST_EIGENVALUE:
        reason = "the frames do not determine the motion"
    scale = source.width * source.height / max(float(source._levels.counts[min(1, source._levels.count - 1)]), 1.0)
    shades = v[at.SHADE_COUNT]
    return OdometryResult(
        success=not reason,
        transformation=found.pose,
        information=information_of(v) * scale,
        reason=reason,
        inliers=int(inliers),
        fitness=float(inliers / pixels) if pixels else 0.0,
        overlap=float(seen / pixels) if pixels else 0.0,
        inlier_rmse=float(np.sqrt(v[at.SQUARES] / v[27])) if v[27] else 0.0,
        intensity_rmse=float(np.sqrt(v[at.SHADE_SQUARES] / shades)) if shades else float("nan"),
        smallest_eigenvalue=smallest,
        iterations=found.steps,
    )


def _first_fault(found: Any, pixels: float, seen: float, inliers: float) -> str:
    v = found.verdict
    if not np.isfinite(found.pose).all():
        return "the steps left the numbers"
    if pixels == 0:
        return "the source has no depth"
    if seen / pixels < LEAST_OVERLAP:
        return f"only {100 * seen / pixels:.0f} % of the source's pixels meet depth in the target"
    if inliers / seen < LEAST_INLIERS:
        return f"only {100 * inliers / seen:.0f} % of the pixels that meet depth lie on its surface"
    if v[at.IN_FRONT] / seen > MOST_IN_FRONT:
        return f"{100 * v[at.IN_FRONT] / seen:.0f} % of the source's pixels lie where the target looked through"
    if v[at.NORMALS] and v[at.AGREEING] / v[at.NORMALS] < LEAST_AGREEMENT:
        return f"only {100 * v[at.AGREEING] / v[at.NORMALS]:.0f} % of the normals agree"
    if v[at.SHADE_COUNT] > 0.3 * inliers and correlation(v) < LEAST_CORRELATION:
        return f"the brightness does not agree (correlation {correlation(v):.2f})"
    return ""


def correlation(v: NDArray[np.float64]) -> float:
    """The correlation of the brightness of pixels that meet; 1 where there is no contrast."""
    n, s, t, ss, tt, st = v[at.SHADE_COUNT : at.SHADE_COUNT + 6]
    variances = (ss / n - (s / n) ** 2) * (tt / n - (t / n) ** 2)
    return float((st / n - s * t / n / n) / np.sqrt(variances)) if variances > 1e-8 else 1.0


def information_of(v: NDArray[np.float64]) -> NDArray[np.float64]:
    """Sum of G^T G, G = [-[q]x, I], over the inliers' target points q (Choi, Zhou and Koltun 2015)."""
    n = v[at.INLIERS]
    x, y, z, xx, xy, xz, yy, yz, zz = v[at.POINTS : at.POINTS + 9]
    out = np.zeros((6, 6))
    out[:3, :3] = [[yy + zz, -xy, -xz], [-xy, xx + zz, -yz], [-xz, -yz, xx + yy]]
    out[:3, 3:] = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    out[3:, :3] = out[:3, 3:].T
    out[3:, 3:] = n * np.eye(3)
    return out


def smallest_eigenvalue(sums: NDArray[np.float64], v: NDArray[np.float64]) -> float:
    """Of the normal equations about the middle of the points, rotations in units of their spread, as a share."""
    n = v[at.INLIERS]
    if n < 12:
        return 0.0
    h = np.zeros((6, 6))
    h[np.triu_indices(6)] = sums[:21]
    h = h + np.triu(h, 1).T
    c = v[at.POINTS : at.POINTS + 3] / n
    spread = np.sqrt(max((v[at.POINTS + 3] + v[at.POINTS + 6] + v[at.POINTS + 8]) / n - c @ c, 1e-12))
    cross = np.array([[0, -c[2], c[1]], [c[2], 0, -c[0]], [-c[1], c[0], 0]])
    b = np.block([[np.eye(3) / spread, np.zeros((3, 3))], [cross / spread, np.eye(3)]])
    values = np.linalg.eigvalsh(b.T @ h @ b) / n
    return float(values[0] * SHIFT * SHIFT)
