"""Evaluation of a registration."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.argument_errors import explain_argument_errors
from ...core.checks import check_positive, check_transformation
from ...kernels.icp.jobs import Jobs
from ...kernels.icp.loop import Matching
from ...pcd.cloud import PointCloud
from ..correspondence_input import check_clouds
from ..result import Outcome, RegistrationResult
from ..rigid import to_local
from .estimation import TransformationEstimationPointToPoint
from .matched_clouds import MatchedClouds, grow_forest, order_points


@explain_argument_errors
def evaluate_registration(
    source: PointCloud, target: PointCloud, max_correspondence_distance: float, transformation: ArrayLike | None = None
) -> RegistrationResult:
    """Compute fitness, rmse and correspondences of two clouds under a pose.

    Args:
        source, target: The clouds.
        max_correspondence_distance: Correspondences must be closer than this [m].
        transformation: T_target_source, any affine 4x4; None: the identity.

    Returns:
        The result, with the given transformation. `reliable` as of `registration_icp`, without convergence.

    Raises:
        ValueError, DeviceError: A distance that is not positive, a singular transformation, or clouds on different
            devices.

    Example:
        >>> import pointloom as loom
        >>> source, target = loom.PointCloud([[0, 0, 0], [5, 0, 0]]), loom.PointCloud([[0, 0, 0.1]])
        >>> result = loom.registration.evaluate_registration(source, target, 0.5)
        >>> result.fitness, round(result.inlier_rmse, 6), result.correspondence_set.tolist()
        (0.5, 0.1, [[0, 0]])
    """
    T = np.eye(4) if transformation is None else check_transformation("transformation", transformation)
    evaluation = _evaluate(source, target, max_correspondence_distance, T)
    (fitness,), (rmse,) = (values.tolist() for values in evaluation.loop.measure_pairs())
    return RegistrationResult(
        T.copy(),
        fitness,
        rmse,
        lambda: evaluation.pairs_of(0),
        outcome=Outcome(warnings=() if fitness else ("no correspondences",)),
        clouds=evaluation.clouds_of(0),
    )


def get_information_matrix_from_point_clouds(
    source: PointCloud, target: PointCloud, max_correspondence_distance: float, transformation: ArrayLike
) -> NDArray[np.float64]:
    """Compute the information matrix of a registration for pose graph edges.

    Args:
        source, target, max_correspondence_distance, transformation: As of `evaluate_registration`.

    Returns:
        The sum of G^T G over the correspondences' target points q, with G = (-[q]x, I): float64 [6, 6], rotation first,
        about the world origin. The last entry is the number of correspondences (Choi et al. 2015, eq. 4).

    Raises:
        ValueError, DeviceError: As `evaluate_registration`.
    """
    T = check_transformation("transformation", transformation)
    return _evaluate(source, target, max_correspondence_distance, T).information()[0]


def fitness_of(
    sources: Sequence[PointCloud], targets: Sequence[PointCloud], distance: float, poses: NDArray[np.float64]
) -> list[float]:
    """The fitness of many pairs of checked clouds under their poses [n, 4, 4], in the same launches."""
    return _Evaluation(sources, targets, distance, poses).loop.measure_pairs()[0].tolist()


class _Evaluation(MatchedClouds[Matching]):
    """Pairs of checked clouds under their poses [n, 4, 4], in the same launches."""

    def __init__(
        self, sources: Sequence[PointCloud], targets: Sequence[PointCloud], distance: float, poses: NDArray[np.float64]
    ):
        super().__init__(sources, targets, distance, TransformationEstimationPointToPoint())
        left, right = self._sides()
        self.source_clouds = order_points(left)
        jobs = Jobs(self.source_clouds, grow_forest(right), self.source_of, self.target_of)
        self.loop = Matching(jobs, to_local(poses, *self.origins), distance)
        self.loop.match()


def _evaluate(source: PointCloud, target: PointCloud, distance: float, T: NDArray[np.float64]) -> _Evaluation:
    check_clouds(source, target)
    return _Evaluation([source], [target], check_positive("max_correspondence_distance", distance), T[None])
