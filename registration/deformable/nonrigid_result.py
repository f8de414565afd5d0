"""Result of `register_nonrigid` and its reliability."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_number, check_numeric
from ...core.reports import Assessed, Fields, Report, failed, quality
from ...core.wording import format_share
from ...pcd.cloud import PointCloud
from .deformation import Deformation

Array = NDArray[np.float64]
SAME = 1e-3  # of the node spacing: residuals that differ by less are the same
LEAST_SHARE, MOST_FOLDED, MOST_STRAIN = 0.75, 0.01, 0.22


@dataclass(frozen=True, eq=False)
class NonRigidResult(Report, Assessed):
    """What `register_nonrigid` found, and how far to trust it; `print` shows it.

    Attributes:
        deformation: Takes the source, and what stands with it, to the target.
        warped: The source, bent.
        correspondences: The target's point that each of the source's came to, int32 [n]; -1 of those without.
        residuals: How far each lies from its partner's plane [m], float64 [n]; NaN without one.
        matched: Share of the source's points that lie on the target, 0..1.
        covered: Share of the target's points that the bent source reaches.
        rmse: Of the residuals [m].
        rigid_pose: Where ICP leaves the source, unbent: T_target_source, float64 [4, 4].
        rigid_rmse, rigid_matched: The same of the source there.
        folded: Share of the points at which the bend folds over.
        strain: How much nodes are pulled apart beside their distance, at nine tenths of them; bending alone is none.
        iterations: Steps in all.
        converged: Whether each stiffness settled.
        node_spacing: About how far nodes are apart [m].
        target_count: Points of the target.
        better_start: Where `init` was given: a pose, half a turn away, from which the body bends with less strain.
    """

    deformation: Deformation
    warped: PointCloud
    correspondences: NDArray[np.int32]
    residuals: Array
    matched: float
    covered: float
    rmse: float
    rigid_pose: Array
    rigid_rmse: float
    rigid_matched: float
    folded: float
    strain: float
    iterations: int
    converged: bool
    node_spacing: float
    target_count: int
    better_start: NDArray[np.float64] | None = None

    @property
    def is_rigid(self) -> bool:
        """Whether the source lies on the target as well without a bend."""
        return (
            self.rigid_matched >= 0.98 * self.matched and self.rigid_rmse <= 1.1 * self.rmse + SAME * self.node_spacing
        )

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        share, fold = max(self.matched, self.covered), self.folded > MOST_FOLDED
        turned = self.better_start is not None
        return failed(
            f"only {format_share(share)} of either cloud lies on the other" if share < LEAST_SHARE else None,
            f"the bend folds over at {format_share(self.folded)} of the points" if fold else None,
            f"the body would be stretched by {self.strain:.0%}" if self.strain > MOST_STRAIN else None,
            "from a start half a turn away (better_start) it fits with less strain" if turned else None,
        )

    def to_dict(self) -> dict[str, Any]:
        """The figures, in JSON's types."""
        names = ("matched", "covered", "rmse", "rigid_rmse", "rigid_matched", "folded", "strain", "iterations")
        found = {name: getattr(self, name) for name in names}
        return {"nodes": len(self.deformation), **found, "converged": self.converged, **quality(self)}

    def fields(self) -> Fields:
        """How the bend came about and how good it is."""
        unbent = f"rmse {self.rigid_rmse:.4g}, {format_share(self.rigid_matched)} of the source on the target"
        return [
            ("nodes", f"{len(self.deformation):,}"),
            ("matched", f"{format_share(self.matched)} of the source, {format_share(self.covered)} of the target"),
            ("rmse", f"{self.rmse:.4g}"),
            ("unbent", unbent),
            ("strain", f"{self.strain:.1%}, folded at {format_share(self.folded)}"),
            ("steps", f"{self.iterations}{'' if self.converged else ', not settled'}"),
            *(("warning", warning) for warning in self.warnings),
        ]

    def transfer(self, values: ArrayLike, missing: float = np.nan) -> NDArray[Any]:
        """What the target's points have, at the points of the source that lie on them.

        Args:
            values: Of the target's points, such as `target.colors` or `target["label"]`, shape [m] or [m, c].
            missing: What points without a partner get; give a number where the values are whole.

        Returns:
            Shape [n] or [n, c], in the type of the values.

        Raises:
            ValueError: Another number of rows than the target has points, or `missing` is none of their type.
            TypeError: Not numeric.
        """
        rows = check_numeric("values", values)
        if rows.ndim not in (1, 2) or len(rows) != self.target_count:
            raise ValueError(
                f"values: expected {self.target_count} rows, one a point of the target, got {list(rows.shape)}"
            )
        blank = check_number("missing", missing, allow_nan=True, allow_infinite=True)
        with np.errstate(invalid="ignore", over="ignore"):
            filled = np.asarray(blank).astype(rows.dtype)
        if rows.dtype.kind != "f" and filled != blank:
            raise ValueError(f"missing: {missing} is no {rows.dtype}; give a whole number")
        taken = np.full((len(self.correspondences), *rows.shape[1:]), filled, rows.dtype)
        has = self.correspondences >= 0
        taken[has] = rows[self.correspondences[has]]
        return taken
