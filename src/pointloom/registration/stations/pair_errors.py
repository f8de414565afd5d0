"""Errors of the poses of station pairs: scatter by blocks of the survey, and errors common to all points of a pair."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import eigh, eigvalsh, inv, matmul
from ...kernels.memory import download
from ...kernels.surface.hollow_side import Surface
from ..assessment_constants import MATCH_VOXELS
from ..pose_errors import common_covariance, motions_of_source, step_between
from ..unobservable_motions import judge_motions
from .observations import Array

MIN_BLOCKS = 12  # minimum occupied blocks for an error estimate
MIN_INFORMATION_RATIO = 1e-3  # constraint relative to the largest one: motions below have no information
MAX_RELATIVE_ERROR = 0.1  # standard deviation relative to the lever: undetermined


@dataclass(frozen=True, eq=False)
class PairErrors:
    """Error of a pair's pose: a motion of the source in its own frame, of the free motions (rotation, translation).

    Attributes:
        blocks: Keys of the blocks of space, int64 [b]. Points of other pairs in the same block have correlated errors.
        influences: Error by each block, [b, d].
        common: Covariance of errors that are common to all points, [d, d].
        information: Inverse of the covariance. Zero along motions without a constraint, [d, d].
        is_open: True if the surfaces do not determine all motions.
    """

    blocks: NDArray[np.int64]
    influences: Array
    common: Array
    information: Array
    is_open: bool


def pair_errors(
    surfaces: tuple[Surface, Surface],
    origins: tuple[Array, Array],
    pose: Array,
    size: float,
    free: Sequence[int],
    frame: Array | None,
) -> PairErrors | None:
    """The errors of a pose T_target_source about the origins of two clouds in voxels of a size [m].

    `frame`: T_survey_target about the target's origin, in which space is divided into blocks. None: the target's.
    Returns None if too few points match.
    """
    step = step_between(*surfaces, pose, MATCH_VOXELS * size, size, free, frame)
    if step is None or step.blocks is None or len(step.influences) < MIN_BLOCKS:
        return None
    common = common_covariance(step, lambda: judge_motions(*surfaces, pose, step.distance, step.free))
    values, vectors = eigh(step.unit)
    V = vectors[:, values * MIN_INFORMATION_RATIO < values[0]]
    covariance = matmul(V.T, step.scatter + (common + common.T) / 2, V)
    to_source = motions_of_source(step, origins[0])
    from_source, motion = inv(to_source), matmul(to_source, V, V.T)
    information = matmul(from_source.T, V, inv(covariance), V.T, from_source)
    return PairErrors(
        download(step.blocks),
        matmul(step.influences, motion.T),
        matmul(motion, common, motion.T),
        (information + information.T) / 2,
        V.shape[1] < len(V) or float(eigvalsh(covariance)[-1]) > (MAX_RELATIVE_ERROR * step.rows.lever) ** 2,
    )
