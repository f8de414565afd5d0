"""Registration results."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from importlib import import_module
from typing import Any, NamedTuple

import numpy as np
import warp as wp
from numpy.typing import NDArray

from ..core.checks import is_on_gpu
from ..core.exchange import share_numbers
from ..core.reports import Assessed, failed, quality
from ..core.serialized import keep_through_forks
from ..core.wording import format_fraction, plain
from ..kernels.memory import download
from ..pcd.cloud import PointCloud
from .assessment import RegistrationAssessment
from .assessment_constants import MIN_SCORE
from .matching import Pairs
from .pose_check import find_problem
from .pose_errors import PoseCovariance
from .unobservable_motions import describe_open

MIN_TARGETS = 10  # minimum matched targets for a scale
MAX_SOURCES_PER_TARGET = 10  # source points per target point above which the scale is undetermined
MIN_FITNESS = 0.1  # results below are unreliable
# RMS distance of correspondences in match distances below which one cloud is a copy of the other. Rounding to float32
# gives 1e-6 and less, two samplings of a surface at least 0.02 (a tenth of the point spacing).
MAX_COPY_RMSE = 1e-4


class Outcome(NamedTuple):
    """How a registration ended."""

    iterations: int = 0
    converged: bool = False
    warnings: tuple[str, ...] = ()


class Motions(NamedTuple):
    """Motions of a registration: undetermined ones [k, 6], free ones, the number of the former that a prior
    determines, and the parameters since the initial pose, to continue from there.
    """

    degenerate: NDArray[np.float64] = np.empty((0, 6))
    free: tuple[str, ...] | None = None
    prior_count: int = 0
    parameters: NDArray[np.float64] | None = None


class Registered(NamedTuple):
    """Registered clouds. They share points with the given ones, which copy them when they are changed in place.

    `feature_ratio`: that of Evidence, of a search for the pose.
    """

    source: PointCloud
    target: PointCloud
    max_distance: float
    has_scale: bool = False
    uses_surfaces_only: bool = True
    feature_ratio: float = 0.0


class RegistrationResult(Assessed):
    """A transformation from source to target, and its quality.

    Attributes:
        transformation: T_target_source, float64 [4, 4], in world coordinates.
        fitness: Fraction of source points with a correspondence, 0..1.
        inlier_rmse: Root mean square distance [m] of the correspondences. 0 without any.
        iterations: Number of steps.
        converged: True if the criteria were met.
        degenerate_directions: float64 [k, 6]: unit motions that the clouds do not determine and that were left out:
            rotation about x, y, z through the center of the correspondences (times the source's spread), then
            translation. Empty if all six are determined.
        alternatives: Other poses T_target_source, float64 [4, 4] each, under which a global registration found that the
            clouds match as well. Empty if there are none, or if the clouds do not match. A result with alternatives is
            not reliable.
    """

    def __init__(
        self,
        transformation: NDArray[np.float64],
        fitness: float,
        inlier_rmse: float,
        correspondences: Pairs | Callable[[], Pairs],
        *,
        outcome: Outcome | None = None,
        motions: Motions | None = None,
        clouds: Registered | None = None,
    ):
        self.transformation, self.fitness, self.inlier_rmse = transformation, fitness, inlier_rmse
        self.iterations, self.converged, self._warnings = outcome or Outcome()
        self._score: float | Callable[[], float] | None = None
        self.degenerate_directions, self.free, prior_count, self.motion = motions or Motions()
        self.prior_directions = self.degenerate_directions[:prior_count]
        self.alternatives: tuple[NDArray[np.float64], ...] = ()
        self._correspondences, self._clouds = correspondences, clouds
        self._assessment: RegistrationAssessment | None = None
        self._assessed_pose = transformation.copy()  # assessed if the attribute is changed
        self._lock = threading.RLock()  # an assessment is computed once, also if several threads read it
        keep_through_forks(self)

    @cached_property
    def correspondence_set(self) -> Pairs:
        """Indices (source, target) of the correspondences, int32 [m, 2], by source; computed on first access.

        In the array library of the source cloud; pickles contain Warp arrays as NumPy.
        """
        return self._correspondences() if callable(self._correspondences) else self._correspondences

    @property
    def assessment(self) -> RegistrationAssessment:
        """The `assess_registration` of the registered clouds, computed on first access.

        Raises `ValueError` for results without clouds: those that were unpickled, or found no pose.
        """
        with self._lock:
            made = self._assessment
            if made is None:
                if self._clouds is None:
                    found = "got one that was unpickled or found no pose. Call assess_registration with the clouds"
                    raise ValueError(f"assessment: expected a result with its clouds, {found}")
                assess = import_module(str(__package__)).assess_registration  # by its public name, as it runs ICP
                source, target, distance, *_ = self._clouds
                made = assess(source, target, self._assessed_pose, distance)
                evidence = made.evidence._replace(feature_ratio=self._clouds.feature_ratio)
                made = self._assessment = replace(made, evidence=evidence)
            return made

    @cached_property
    def covariance(self) -> PoseCovariance | None:
        """Covariance of the error of the pose, of `assessment`, computed on first access.

        Priors and fixed motions are not used. None with a scale or without a pose.
        """
        return None if self._clouds is None or self._clouds.has_scale else self.assessment.covariance

    @property
    def score(self) -> float | None:
        """Confidence of a global registration, 0..1. None for refinement methods.

        Above 0.5 the clouds agree. RANSAC and fast global registration compute it on first access.
        """
        if callable(self._score):
            self._score = self._score()
        return self._score

    @score.setter
    def score(self, value: float | Callable[[], float] | None) -> None:
        self._score = value

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy. Empty if the result is reliable.

        The first checks need no computation: convergence, the number of correspondences, undetermined motions. If none
        of them failed, the score decides if there is one. Otherwise the surfaces of both clouds are compared under the
        pose on first access, in voxels of about 1/32 of their size (0.02 to 0.5 s on a CPU). The comparison is cached.
        Few points, and points without surfaces, must match better than unrelated points would by chance. Results from
        correspondences alone are not compared.
        """
        return self._known_warnings() or failed(self._low_score() if self.score is not None else self._surface_problem)

    @warnings.setter
    def warnings(self, value: tuple[str, ...]) -> None:
        self._warnings = value

    def _known_warnings(self) -> tuple[str, ...]:
        """Failed checks that need no computation. A score includes the overlap and the undetermined motions."""
        if self._score is not None:
            return self._warnings
        motions = self.degenerate_directions[len(self.prior_directions) :]
        low = f"only {format_fraction(self.fitness)} of the source has a correspondence, less than {MIN_FITNESS:.0%}"
        remedy = "Start closer to the true pose, or use a larger max_correspondence_distance"
        is_low = 0 < self.fitness < MIN_FITNESS
        open_motions = describe_open(motions) if len(motions) else None
        return (*self._warnings, *failed(f"{low}. {remedy}" if is_low else None, open_motions))

    def _low_score(self) -> str:
        score = self.score
        if score is None or score > MIN_SCORE:
            return ""
        why = "the surfaces hardly overlap, or a motion is undetermined"
        return f"the score is {score:.2f}, not above {MIN_SCORE}: {why}"

    @cached_property
    def _surface_problem(self) -> str:
        """Evidence of the surfaces against the pose. "" if there is none, or without clouds."""
        if self._clouds is None:
            return ""
        source, target, distance, _, uses_surfaces_only, _ = self._clouds
        coincide = self.fitness > 0.5 and self.inlier_rmse < MAX_COPY_RMSE * distance
        may_be_open = coincide or self.free is not None or not uses_surfaces_only
        return find_problem(source, target, self._assessed_pose, may_be_open=may_be_open)

    def to_dict(self) -> dict[str, Any]:
        """All but the correspondences and the covariance in JSON types, with `reliable` and `warnings`."""
        names = ("transformation", "fitness", "inlier_rmse", "iterations", "converged", "score")
        names += ("degenerate_directions", "prior_directions", "free", "alternatives")
        return {name: plain(getattr(self, name)) for name in names} | quality(self)

    def check_scale(self) -> None:
        """Check a pose with a scale. `converged` is False if any smaller scale fits as well by matching few points.

        A source that shrinks to the target's point spacing has fitness 1 and an rmse near 0.
        """
        self._clouds = None if self._clouds is None else self._clouds._replace(has_scale=True)
        pairs = self.correspondence_set
        on_device = isinstance(pairs, wp.array) or is_on_gpu(pairs)
        rows = download(share_numbers("pairs", pairs)) if on_device else np.asarray(pairs)
        targets = len(np.unique(rows[:, 1]))
        if targets < MIN_TARGETS and len(rows) > MAX_SOURCES_PER_TARGET * targets:
            self.converged = False
            self.warnings = (f"scale not determined: {len(rows):,} source points match {targets} target points",)

    def __getstate__(self) -> dict[str, Any]:
        """State for pickle and deepcopy without clouds, with all values computed that need them."""
        pairs, _ = self.correspondence_set, (self.warnings, self.covariance)
        known = {"_correspondences": download(pairs) if isinstance(pairs, wp.array) else pairs, "_score": self.score}
        known |= {"_clouds": None, "_assessment": None}
        left_out = {"correspondence_set", "_lock"}
        return {**{name: value for name, value in vars(self).items() if name not in left_out}, **known}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state, _lock=threading.RLock())
        keep_through_forks(self)

    def __copy__(self) -> RegistrationResult:
        """A result with the same clouds, which computes on access what this one has not computed."""
        made = type(self).__new__(type(self))
        made.__setstate__(vars(self))
        return made

    def __repr__(self) -> str:
        score = f", score {self._score:.2f}" if isinstance(self._score, float) else ""
        state = "; ".join(self._warnings) or ("converged" if self.converged else "not converged")
        return (
            f"RegistrationResult(fitness {self.fitness:.4f}, inlier_rmse {self.inlier_rmse:.6g}, "
            f"{self.iterations} iterations, {state}{score})"
        )
