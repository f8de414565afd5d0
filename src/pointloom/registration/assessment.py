"""The result of `assess_registration`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..core.reports import Assessed, Fields, Report, as_json, failed, with_warnings
from ..core.wording import format_fraction
from .alignment import Alignment
from .assessment_constants import MATCH_VOXELS, MIN_DISPLACEMENT, MIN_SCORE
from .evidence import Evidence
from .pose_errors import PoseCovariance
from .unobservable_motions import Localizability, describe_motions


@dataclass(frozen=True, eq=False)
class RegistrationAssessment(Report, Assessed):
    """The assessment of a pose of two clouds. `reliable` if none of its four parts rejects the pose.

    Attributes:
        transformation: The assessed pose, T_target_source.
        max_correspondence_distance: Match distance [m].
        fitness: Fraction of source points with a correspondence, 0..1, as of `evaluate_registration`.
        inlier_rmse: Root mean square distance [m] of the correspondences, likewise. 0 without any.
        evidence: What the surfaces show about the pose, refined within the match distance.
        covariance: Covariance of the error of the pose. Motions that the surfaces do not determine have standard
            deviations of the size of the overlap. Infinite if the surfaces hardly match.
        localizability: The motions that the surfaces determine, and those that they do not (`open_motions`).
        alignment: Displacement of the surfaces, a better pose, and the test of the displacement.
    """

    transformation: NDArray[np.float64]
    max_correspondence_distance: float
    fitness: float
    inlier_rmse: float
    evidence: Evidence
    covariance: PoseCovariance
    localizability: Localizability
    alignment: Alignment

    @property
    def score(self) -> float:
        """Confidence that the clouds show the same place, 0..1. Accepted above 0.5."""
        return self.evidence.score

    @property
    def warnings(self) -> tuple[str, ...]:
        """Each failed check with its remedy: the score, the displacement, and the undetermined motions."""
        remedy = "Register the clouds with register_globally, or use clouds that overlap more"
        low = f"the score is {self.score:.2f}, not above {MIN_SCORE}: {self.evidence.problem}. {remedy}"
        rejected = low if self.score <= MIN_SCORE else None
        displaced = () if self.notes else self.alignment.warnings
        return failed(rejected, *displaced, *self.localizability.warnings)

    @property
    def notes(self) -> tuple[str, ...]:
        """A detected displacement below the resolution of a registration."""
        limit = MIN_DISPLACEMENT * self.max_correspondence_distance / MATCH_VOXELS
        is_small = self.alignment.is_supported and self.alignment.displacement < limit
        return self.alignment.warnings if is_small else ()

    def fields(self) -> Fields:
        rotations, shifts = self.covariance.sigmas.reshape(2, 3)
        motions = self.localizability.open_motions
        rows = [
            ("fitness", f"{format_fraction(self.fitness)}, rmse {self.inlier_rmse:.4g} m"),
            ("score", f"{self.score:.2f}"),
            ("displacement", f"{self.alignment.displacement:.3g} m, standard deviation {self.alignment.sigma:.2g} m"),
            ("undetermined", describe_motions(motions) if len(motions) else "none"),
            ("sigma", " ".join(f"{s:.2g}" for s in shifts) + " m; " + " ".join(f"{s:.2g}" for s in rotations) + " rad"),
        ]
        return with_warnings(rows, self)

    def to_dict(self) -> dict[str, Any]:
        """All attributes in JSON types, with `score`, `features`, `notes`, `reliable` and `warnings`."""
        features = {"score": self.score, "features": self.evidence.features, "notes": list(self.notes)}
        return {name: value for name, value in as_json(self).items() if name != "evidence"} | features
