"""One iteration of ICP, the same for all estimators: pair, weigh, sum, solve, move, test."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

from ...kernels.icp.freedom import Freedom
from ...kernels.icp.loop import RegistrationLoop
from ...kernels.icp.pair_rejection import PairRejection
from ...kernels.icp.step import StepRules
from .estimation import TransformationEstimation


@dataclass(frozen=True)
class Iteration:
    """One iteration of all jobs, without a host synchronization.

    It moves the pose T of each job by one Gauss-Newton step for the twist x = (rotation, translation) that minimizes

        E(x) = sum_i w_i |r_i(exp(x) T p_i, q_i)|^2                                                          (1)

    over the pairs of a source point p_i and a target point q_i (Besl and McKay, PAMI 1992; Chen and Medioni, 1992).
    An estimator is a class with a reduction `rows`, which computes r_i, its derivative J_i and the weight w_i of a pair
    (kernels/icp/rows.py).

    Attributes:
        estimation: The estimator.
        loop: Pairs, sums and states of the jobs.
        arguments: Those of the rows after the pairs.
        unweighted_arguments: The same without robust kernels, for the test of undetermined motions; None if the
            estimator tests the sums (3).
        rejection: Further conditions for pairs; None: the match distance alone.
        freedom: Fixed motions and priors of constrained jobs.
    """

    estimation: TransformationEstimation
    loop: RegistrationLoop
    arguments: Sequence[Any]
    unweighted_arguments: Sequence[Any] | None
    rejection: PairRejection | None
    freedom: Freedom | None

    def run(self, rules: StepRules) -> None:
        """Launch the iteration; jobs that have ended are left out on the device."""
        loop = self.loop
        loop.match()  # q_i: the nearest target point of T p_i within the match distance                     (2)
        if self.rejection is not None:
            self.rejection.run()  # without the farthest pairs, or those with different normals
        self.estimation.prepare(loop)  # what the weights w_i depend on, such as the speed of the sensor
        rows = self.estimation.rows  # H = sum_i w_i J_i^T J_i,  b = sum_i w_i J_i^T r_i                      (3)
        loop.sum_rows(rows, self.arguments, self.unweighted_arguments)
        loop.step(rules, self.freedom)  # solve H x = -b;  T := exp(x) T;  test the change of E and the pairs (4)
