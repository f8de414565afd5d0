"""What a registration found, and how far to trust it."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property
from typing import Any

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.checks import is_on_gpu
from ..core.exchange import share_numbers
from ..kernels.memory import download

FEWEST_TARGETS = 10  # that fix a scale
SHARED = 10  # source points a target point, from which on they tell nothing of the source's size
Pairs = NDArray[np.int32]


class RegistrationResult:
    """A transformation from source to target, and how well the clouds lie on each other under it.

    Attributes:
        transformation: T_target_source, float64 [4, 4]: takes the source's world coordinates to the target's.
        fitness: Share of the source's points that have a correspondence, 0..1; more is better.
        inlier_rmse: Root of the mean squared distance [m] of the correspondences; 0 without any.
        iterations: Steps that were taken.
        converged: Whether the criteria were met.
        reason: Why it stopped, in words: "converged", "max_iteration", "no correspondences", ...
        hint: What may be the matter where there are no correspondences: where both clouds are, and how large.
        degenerate_directions: float64 [k, 6]: motions that the clouds do not determine, and along which the source was
            not moved: rotation about x, y, z through the middle of the correspondences, as the length of the arc at the
            source's spread, then translation; unit vectors. Empty where all six are determined.
    """

    def __init__(
        self,
        transformation: NDArray[np.float64],
        fitness: float,
        inlier_rmse: float,
        correspondences: Pairs | Callable[[], Pairs],
        *,
        iterations: int = 0,
        converged: bool = False,
        reason: str = "",
        degenerate_directions: NDArray[np.float64] | None = None,
        score: float | Callable[[], float] | None = None,
        free: tuple[str, ...] | None = None,
        held_count: int = 0,
        motion: NDArray[np.float64] | None = None,
    ):
        self.transformation, self.fitness, self.inlier_rmse = transformation, fitness, inlier_rmse
        self.iterations, self.converged, self.reason, self._score = iterations, converged, reason, score
        self.degenerate_directions = np.empty((0, 6)) if degenerate_directions is None else degenerate_directions
        self.free, self.prior_directions = free, self.degenerate_directions[:held_count]
        self._motion = motion  # the parameters since the first pose, of a registration that goes on from here
        self._correspondences, self.hint = correspondences, ""

    @cached_property
    def correspondence_set(self) -> Pairs:
        """Indices (source, target) of the correspondences, int32 [m, 2], by source; made when first read.

        An array of the library that the source cloud was made of. A pickle holds those of Warp as NumPy.
        """
        return self._correspondences() if callable(self._correspondences) else self._correspondences

    @property
    def score(self) -> float | None:
        """Confidence in a result without an initial pose, 0..1; None of methods that refine one.

        Above 0.5 the clouds do lie on each other, as far as they tell.
        RANSAC and fast global registration rate their pose when this is first read.
        """
        if callable(self._score):
            self._score = self._score()
        return self._score

    @score.setter
    def score(self, value: float | Callable[[], float] | None) -> None:
        self._score = value

    def check_scale(self) -> None:
        """End a similarity as not converged if so few target points are matched that any smaller scale fits as well.

        A source that shrinks to the spacing of the target has fitness 1 and an rmse near 0.
        """
        pairs = self.correspondence_set
        on_device = isinstance(pairs, wp.array) or is_on_gpu(pairs)
        rows = download(share_numbers("pairs", pairs)) if on_device else np.asarray(pairs)
        targets = len(np.unique(rows[:, 1]))
        if targets < FEWEST_TARGETS and len(rows) > SHARED * targets:
            self.converged = False
            self.reason = f"scale not determined: {len(rows):,} source points match {targets} target points"

    def __getstate__(self) -> dict[str, Any]:
        """All of it, what is fetched or rated when first read among it, for pickle."""
        pairs = self.correspondence_set
        known = {"_correspondences": download(pairs) if isinstance(pairs, wp.array) else pairs, "_score": self.score}
        return {**{name: value for name, value in vars(self).items() if name != "correspondence_set"}, **known}

    def __repr__(self) -> str:
        believed = f", score {self._score:.2f}" if isinstance(self._score, float) else ""
        why = f"{self.reason or 'not stated'}{f': {self.hint}' if self.hint else ''}"
        return (
            f"RegistrationResult(fitness {self.fitness:.4f}, inlier_rmse {self.inlier_rmse:.6g}, "
            f"{self.iterations} iterations, {why}{believed})"
        )
