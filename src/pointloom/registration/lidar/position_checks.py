"""Checks of given positions against the map: the offset and drift of their clock, and the order of their axes."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from ...kernels.linear_algebra import inv, matmul, solve
from ..rigid import skews
from .lidar_graph import SubmapGraph
from .position_priors import FINAL_STEPS, MAX_PRIOR_SQUARE, WIDTH_STEP, PositionPriors, align_path, path_cost

Array = NDArray[np.float64]

MIN_ROWS = 12  # positions that determine a clock beside the pose: 36 coordinates for 8 numbers
# Prior standard deviations of the corrections: rotation [rad], translation [m], and offset and drift of the clock [s].
# They only keep undetermined ones finite, such as the offset on a straight path at constant speed.
PRIOR_SIGMAS = np.array([0.5] * 3 + [1e4] * 3 + [100.0] * 2)
# Standard deviations of a significant offset or drift: 6e-7 of correct clocks exceed it by independent errors.
CLOCK_SIGMAS = 5.0
MIN_SHIFT = 0.5  # of the median sigma, and [m]: smaller displacements by the clock are those of bends of the map
MAX_ROUNDS = 8  # of the estimate with a graph that is bent less each time: half of the offset remained after the first
MAX_TILT = math.radians(30)  # between the up axes of the first scan and of the positions: five sigmas of the level
AXES_ROWS = 100  # positions for the test of the axes
AXES_COST = 0.7  # of the cost of the given axes: other axes fit better
# Orders and signs of axes that differ by more than a heading: all 48 with the four headings of each alike.
AXES = [
    (order, signs)
    for order, signs in (
        ((0, 1, 2), (1, 1, 1)), ((1, 0, 2), (1, 1, 1)), ((1, 0, 2), (1, 1, -1)), ((0, 1, 2), (1, 1, -1)),
        ((1, 2, 0), (1, 1, 1)), ((2, 1, 0), (1, 1, 1)), ((2, 1, 0), (1, 1, -1)), ((1, 2, 0), (1, 1, -1)),
        ((2, 0, 1), (1, 1, 1)), ((0, 2, 1), (1, 1, 1)), ((0, 2, 1), (1, 1, -1)), ((2, 0, 1), (1, 1, -1)),
    )
]  # fmt: skip


@dataclass(frozen=True)
class ClockError:
    """How late the times of positions are [s], by the path: `offset` on average and its standard deviation `sigma`.

    `drift` is the change of the offset from the first to the last position, with its standard deviation `drift_sigma`.
    `shifts` [m] are the displacements by both along the path: root mean squares. `times` [s] are the first and last of
    the positions, and `position_sigma` [m] is their median standard deviation.
    """

    offset: float
    sigma: float
    drift: float
    drift_sigma: float
    shifts: tuple[float, float]
    position_sigma: float
    times: tuple[float, float]

    @property
    def is_late(self) -> bool:
        return self._is_significant(self.offset, self.sigma, self.shifts[0])

    @property
    def is_drifting(self) -> bool:
        return self._is_significant(self.drift, self.drift_sigma, self.shifts[1])

    def _is_significant(self, value: float, sigma: float, shift: float) -> bool:
        return abs(value) > CLOCK_SIGMAS * sigma and shift > MIN_SHIFT * max(self.position_sigma, 1.0)

    @property
    def is_small(self) -> bool:
        """True if both are within two standard deviations."""
        return abs(self.offset) < 2 * self.sigma and abs(self.drift) < 2 * self.drift_sigma

    def at(self, times: Array) -> Array:
        """The offset [s] at some times."""
        first, last = self.times
        return self.offset + self.drift * ((times - first) / (last - first) - 0.5)

    def plus(self, more: ClockError) -> ClockError:
        """With a further error, in ratio to which the displacements grow."""
        offset, drift = self.offset + more.offset, self.drift + more.drift
        pairs = zip((offset, drift), (self.offset, self.drift), self.shifts, strict=True)
        shifts = [abs(new / old) * shift if old else shift for new, old, shift in pairs]
        return replace(more, offset=offset, drift=drift, shifts=(shifts[0], shifts[1]))

    @property
    def problem(self) -> str | None:
        """The reason why the positions are of no use, with the remedy. None if the clock is right."""
        if self.is_drifting:
            first, last = (self.offset + sign * self.drift / 2 for sign in (-1, 1))
            return (
                f"the clock of the positions drifts: their times are {_late(first)} at first and {_late(last)} at last "
                f"(+-{self.drift_sigma:.2f} s). Correct them with the clock of the scans"
            )
        if self.is_late:
            shift = f"{self.shifts[0]:.1f} m along the path"
            return (
                f"the times of the positions are {_late(self.offset)} (+-{self.sigma:.2f} s), or the offset of the "
                f"antenna is wrong by {shift}. Pass times {'-' if self.offset > 0 else '+'} {abs(self.offset):.2f} s"
            )
        return None


def _late(offset: float) -> str:
    return f"{abs(offset):.2f} s {'late' if offset > 0 else 'early'}"


def clock_of_graph(graph: SubmapGraph) -> ClockError | None:
    """The error of the clock of the given positions, with the path that they determine if it is corrected."""
    found, priors = None, graph.priors
    for _ in range(MAX_ROUNDS):
        if graph.reference is None:
            break
        clock = clock_error(graph.priors, np.array(graph.poses), graph.reference)
        found = clock if found is None or clock is None else found.plus(clock)
        if clock is None or found is None or found.problem is None or clock.is_small:
            break
        moved = _at_times(priors, np.array(graph.poses), priors.times - found.at(priors.times))
        if moved is None:
            break
        graph = SubmapGraph(graph.poses, graph.edges, moved, graph.reference).optimized()
    return found


def _at_times(priors: PositionPriors, poses: Array, times: Array) -> PositionPriors | None:
    """The priors with the points of the path at other times, by cubic interpolation. None if the times do not grow."""
    from scipy.interpolate import CubicHermiteSpline  # slow import

    R = poses[priors.nodes][:, :3, :3]
    velocities = matmul(R, priors.velocities[:, :, None])[:, :, 0]
    rows = velocities.any(axis=1)
    known = priors.times[rows]
    if not (np.diff(known) > 0).all():
        return None
    path = CubicHermiteSpline(known, priors.world_points(poses)[rows], velocities[rows])
    near = np.clip(times, known[0], known[-1])
    speeds = path(near, 1)
    points = path(near) + speeds * (times - near)[:, None] - poses[priors.nodes][:, :3, 3]
    points, speeds = (matmul(R.transpose(0, 2, 1), each[:, :, None])[:, :, 0] for each in (points, speeds))
    speeds[~rows] = 0.0
    return replace(priors, points=points, velocities=speeds)


def clock_error(priors: PositionPriors, poses: Array, reference: Array) -> ClockError | None:
    """Estimate the offset and drift of the clock of aligned positions, with a correction of the reference.

    Robust least squares, as of the graph. None with few positions, or without motion.
    """
    rows = priors.at(priors.is_aligned & priors.velocities.any(axis=1))
    if len(rows) < MIN_ROWS or not np.ptp(rows.times) > 0:
        return None
    R = reference[:3, :3]
    points = matmul(rows.world_points(poses) - reference[:3, 3], R)
    velocities = matmul(matmul(poses[rows.nodes][:, :3, :3], rows.velocities[:, :, None])[:, :, 0], R)
    span = float(np.ptp(rows.times))
    times = float(rows.times.min()), float(rows.times.max())
    parts = (rows.times - times[0]) / span - 0.5
    levers = -skews(points - points.mean(axis=0))
    shifts = np.stack([-velocities, -velocities * parts[:, None]], axis=2)
    A = np.concatenate([levers, np.tile(np.eye(3), (len(rows), 1, 1)), shifts], axis=2)
    A = A * PRIOR_SIGMAS / rows.sigmas[:, :, None]
    errors = (rows.positions - points) / rows.sigmas
    x, steps = np.zeros(len(PRIOR_SIGMAS)), 0
    squares = (errors * errors).sum(axis=1)
    width = rows.first_width(squares)
    while True:
        weights = rows.shares * (width / (width + squares)) ** 2
        weighted = (A * weights[:, None, None]).reshape(-1, len(x))
        N = matmul(weighted.T, A.reshape(-1, len(x))) + np.eye(len(x))
        x = solve(N, matmul(weighted.T, errors.ravel()))
        rest = errors - matmul(A, x)
        squares = (rest * rest).sum(axis=1)
        steps += width <= MAX_PRIOR_SQUARE
        if steps > FINAL_STEPS:
            break
        width = max(width / WIDTH_STEP, MAX_PRIOR_SQUARE)
    scale = max(1.0, float((weights * squares).sum() / (3 * weights.sum())))
    sigmas = np.sqrt(np.diag(inv(N)) * scale) * PRIOR_SIGMAS
    offset, drift = (float(value) for value in (x * PRIOR_SIGMAS)[6:])
    speed = float(np.sqrt((velocities * velocities).sum(axis=1).mean()))
    lengths = abs(offset) * speed, abs(drift) * speed * float(np.sqrt((parts * parts).mean()))
    position_sigma = float(np.median(rows.sigmas))
    return ClockError(offset, float(sigmas[6]), drift, float(sigmas[7]), lengths, position_sigma, times)


def better_axes(points: Array, positions: Array, sigmas: Array) -> str | None:
    """An order and signs of axes with which positions fit a path better by far, as an expression. None without one.

    Only a diagnosis: a path on flat ground does not determine the sign of the height.
    """
    step = max(1, len(points) // AXES_ROWS)
    p, q, s = points[::step], positions[::step], sigmas[::step]
    costs = []
    for order, signs in AXES:
        given, sigma = q[:, order] * signs, s[:, order]
        T = align_path(p, given, sigma)
        costs.append(math.inf if T is None else path_cost(T, p, given, sigma))
    if not min(costs) < min(AXES_COST * costs[0], MAX_PRIOR_SQUARE * len(p)):
        return None
    order, signs = AXES[next(k for k, cost in enumerate(costs) if cost <= min(costs) / AXES_COST)]
    factor = "" if min(signs) > 0 else f" * {list(signs)}"
    return f"positions[:, {list(order)}]{factor}"


def tilt_of(reference: Array) -> float:
    """Angle [rad] between the up axis of the first scan and that of the positions."""
    return math.acos(min(max(float(reference[2, 2]), -1.0), 1.0))
