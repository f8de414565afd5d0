"""What odometry reports: one record a scan, and a summary of the run."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.checks import check_list
from ...core.number_runs import some_runs
from ...core.reports import Assessed, Fields, Report
from ...core.wording import format_share, plain
from ...kernels.linear_algebra import eigh, matmul, norm

Matrix = NDArray[np.float64]
Direction = tuple[float, float, float]

NO_POINTS, FIRST_SCAN = "no points in range", "first scan"  # reasons of a step

# Of a scan's disagreement, above which it lies beside the map; the second where none of it lies near the map, with a
# straight line to two thirds of it. On made-up drives whose truth is known (streets, halls, woods, corridors; 0 to 38
# m/s, scanners that turn and one that draws roses in the hand) scans that were right had 0.005 to 0.28, lost ones 0.29
# to 0.71; scans of other places 0.25 to 0.44, of which the former with a fitness of 0.2; submaps 3 to 12 m apart 0.49
# to 0.59.
STRAYED_DISAGREEMENT, ALONE_DISAGREEMENT = 0.3, 0.1

# A loop that stands still between two places is common and harmless; where more of the scans do not come to rest than
# this, there is no place where they fit.
MOST_UNSETTLED = 0.2

# Of the scans or of the path that may rest on constant velocity; and so many scans on end, over which a car that brakes
# gently (1 m/s^2, ten scans a second) leaves it by half a metre.
MOST_UNDETERMINED, MOST_UNDETERMINED_ON_END = 0.1, 10
# A scanner stands where it moved less than this in three scans [m, rad]. Then it sees nothing new, and its fitness is
# 0.99 to 1.00; with lorries passing by on two lanes, 0.97 to 0.99; among lorries that drive with it at 1 m a scan, so
# that it only seems to stand, 0.88 to 0.98. Half of such scans, and five at least, tell.
REST, RESTING_FITNESS, MOST_CONTRADICTED, LEAST_RESTING = (0.1, 0.02), 0.97, 0.5, 5
ALONG_AXIS = 0.99  # of a unit vector, above which a direction is called by its axis


@dataclass(frozen=True, eq=False)
class OdometryStep:
    """What became of one scan.

    Attributes:
        index: Number of the scan, from 0.
        pose: T_world_sensor at the end of the scan, float64 [4, 4]; the world is the sensor's frame of the first scan.
        threshold: Standard deviation [m] of the prediction's error: correspondences lie within three of it.
        inliers: Points of the thinned scan with a correspondence in the map.
        fitness: Their share of the thinned scan, 0..1.
        inlier_rmse: Root of their mean squared distance [m].
        iterations: Turns of the ICP loop.
        converged: Whether the loop came to rest, or there was nothing to match yet.
        is_predicted: Whether the pose is that of constant velocity alone: the scan did not tell.
        reason: "converged", "first scan", "max_iteration", "no points in range" or "no overlap".
        misfit: `inlier_rmse` in edges of the map's voxels: some 0.3 to 0.6 where the scan lies on the map.
        disagreement: Mean cost (0..1) of the distances from the map's planes, of points that have one: up to 0.2 where
            the scan lies on the map.
        undetermined: Unit vectors of the world along which the scan does not tell where the sensor is, as in a bare
            corridor: there the pose is the predicted one.
        undetermined_turns: Unit axes about which it does not tell how the sensor is turned, likewise.
        rivals: Vectors [m] of the world from the pose to others where the scan lies as well, such as the next of many
            like doors: looked for while the scanner's motion is not known.
        has_prior: Whether the prediction was given to `register`.
        has_joined: Whether the scan lay on the one before it, which lay beside the map, and both joined it.
    """

    index: int
    pose: Matrix
    threshold: float
    inliers: int
    fitness: float
    inlier_rmse: float
    iterations: int
    converged: bool
    is_predicted: bool
    reason: str
    misfit: float = 0.0
    disagreement: float = 0.0
    undetermined: tuple[Direction, ...] = ()
    undetermined_turns: tuple[Direction, ...] = ()
    rivals: tuple[Direction, ...] = ()
    has_prior: bool = False
    has_joined: bool = False

    @property
    def is_undetermined(self) -> bool:
        """Whether the scan leaves a motion open."""
        return bool(self.undetermined or self.undetermined_turns)

    @property
    def has_strayed(self) -> bool:
        """Whether the scan lies beside the map, on other things than those it shows, however many points pair up."""
        limit = min(STRAYED_DISAGREEMENT, ALONE_DISAGREEMENT + STRAYED_DISAGREEMENT * self.fitness)
        return not self.is_predicted and self.disagreement > limit

    @property
    def is_sound(self) -> bool:
        """Whether the scan lies on the map, or is the first: only such scans join the map and tell the motion."""
        return not self.is_predicted and not self.has_strayed

    @property
    def is_unsettled(self) -> bool:
        """Whether the loop was still moving the scan when its turns ran out."""
        return self.reason == "max_iteration"


@dataclass(frozen=True)
class OdometrySummary(Report, Assessed):
    """A run of odometry in a few numbers; `print` shows it as `pointloom odometry` does.

    Attributes:
        scan_count: Scans so far.
        distance: Length of the path [m].
        predicted: Numbers of the scans whose pose was only predicted: the path may be torn there.
        unsettled: Numbers of the scans whose loop did not come to rest: a few are usual, many tell of a lost path.
        strayed: Numbers of the scans that lie beside the map and were left out: where the last scan is one of them, the
            path is likely wrong from the first of them on.
        mean_fitness: Of the scans that were matched; NaN where there are none.
        mean_iterations: Likewise.
        empty: Numbers of the scans that have no points in range.
        undetermined: Numbers of the scans that leave a motion open, where the path is that of constant velocity.
        open_motions: Which motion that is, such as "along x" or "along x, along y, about z"; empty where there is none.
        undetermined_distance: Length of the path [m] that ends in these scans.
        ambiguous: Numbers of the scans that lie as well elsewhere, while the motion was not known.
        rival: The way [m] from the first of them to the nearest such place; empty where there is none.
        contradicted: Numbers of the scans with which the scanner seems to stand while much of what it sees is new: what
            moves with it may be taken for what stands.
        resting: How many scans it seems to stand.
    """

    scan_count: int
    distance: float
    predicted: tuple[int, ...]
    unsettled: tuple[int, ...]
    strayed: tuple[int, ...]
    mean_fitness: float
    mean_iterations: float
    empty: tuple[int, ...] = ()
    undetermined: tuple[int, ...] = ()
    open_motions: str = ""
    undetermined_distance: float = 0.0
    ambiguous: tuple[int, ...] = ()
    rival: Direction | tuple[()] = ()
    contradicted: tuple[int, ...] = ()
    resting: int = 0

    @property
    def is_contradicted(self) -> bool:
        """Whether the scanner seems to stand while the scans show that much moves by."""
        return len(self.contradicted) >= LEAST_RESTING and len(self.contradicted) > MOST_CONTRADICTED * self.resting

    @property
    def is_undetermined(self) -> bool:
        """Whether too much of the path rests on constant velocity."""
        numbers, last = self.undetermined, MOST_UNDETERMINED_ON_END - 1
        return (
            len(numbers) > MOST_UNDETERMINED * (self.scan_count - 1)
            or self.undetermined_distance > MOST_UNDETERMINED * self.distance
            or any(b - a == last for a, b in zip(numbers, numbers[last:], strict=False))
        )

    @property
    def has_seen(self) -> bool:
        """Whether any scan had points in range."""
        return len(self.empty) < self.scan_count

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed quality checks, each with its remedy; empty if the result is reliable."""
        if not self.has_seen:
            return ("no scan has points in range",)
        reasons, count = [], self.scan_count
        if torn := self.predicted:
            reasons.append(
                f"{len(torn)} of {count} scans do not overlap those before them, or have no points in range, so the "
                f"path may be torn at {_scans(torn)}"
            )
        if strayed := self.strayed:
            lost = f"so the path is likely lost from scan {strayed[0]} on; give scans that lie closer together, or"
            left_out = "which were left out: the path goes on behind them from where constant velocity led"
            then = f"{lost} another max_range" if strayed[-1] == count - 1 else left_out
            beside = f"{len(strayed)} of {count} scans lie beside the map of those before them ({_scans(strayed)})"
            reasons.append(f"{beside}, {then}")
        if self.ambiguous:
            length = math.hypot(*self.rival)
            way = _direction(np.array(self.rival) / length)
            reasons.append(
                f"{len(self.ambiguous)} of the first scans lie as well {length:.2f} m away along {way} "
                f"({_scans(self.ambiguous)}), so each motion may be off by that; begin at rest with a smaller "
                "initial_threshold, or give priors"
            )
        if self.is_contradicted:
            reasons.append(
                f"the scanner seems to stand still while {len(self.contradicted)} scans show much that was not there "
                f"before ({_scans(self.contradicted)}): what moves with it may be taken for what stands"
            )
        if self.is_undetermined:
            reasons.append(
                f"{len(self.undetermined)} of {count} scans do not determine the motion {self.open_motions} "
                f"({_scans(self.undetermined)}), where constant velocity was assumed"
            )
        if not strayed and len(self.unsettled) > MOST_UNSETTLED * (count - 1):
            reasons.append(
                f"{len(self.unsettled)} of {count} scans did not come to rest on the map ({_scans(self.unsettled)})"
            )
        return tuple(reasons)

    def to_dict(self) -> dict[str, Any]:
        """All of it in JSON's types, with the unit in the name."""
        return plain(
            {
                "scans": self.scan_count,
                "path_length_m": self.distance,
                "mean_fitness": self.mean_fitness,
                "mean_iterations": self.mean_iterations,
                "predicted": self.predicted,
                "strayed": self.strayed,
                "unsettled": self.unsettled,
                "undetermined": self.undetermined,
                "open_motions": self.open_motions,
                "undetermined_path_m": self.undetermined_distance,
                "ambiguous": self.ambiguous,
                "rival_m": self.rival or None,
                "contradicted": self.contradicted,
            }
        )

    def fields(self) -> Fields:
        """How many scans and how long a path, how well they fit, and which of them do not."""
        fields = [("scans", f"{self.scan_count:,}"), ("path", f"{self.distance:.2f} m")]
        if not math.isnan(self.mean_fitness):
            fit = f"fitness {format_share(self.mean_fitness)} and {self.mean_iterations:.1f} iterations on average"
            fields.append(("fit", fit))
        rows = ("predicted", self.predicted), ("beside map", self.strayed), ("not at rest", self.unsettled)
        fields += [(label, f"{len(numbers):,}: {_scans(numbers)}") for label, numbers in rows if numbers]
        rows = ("fit elsewhere", self.ambiguous), ("contradicted", self.contradicted if self.is_contradicted else ())
        fields += [(label, f"{len(numbers):,}: {_scans(numbers)}") for label, numbers in rows if numbers]
        if self.undetermined:
            where = f"{self.open_motions}, {_scans(self.undetermined)}"
            fields.append(("undetermined", f"{len(self.undetermined):,}: {where}"))
        return fields


def summarize_steps(steps: Sequence[OdometryStep]) -> OdometrySummary:
    """The run that these steps make up.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.registration.lidar.lidar_runs import iterate_odometry
        >>> from pointloom.registration.lidar.lidar_steps import summarize_steps
        >>> wall = loom.PointCloud([[10, 0.5 * i, 0.5 * j] for i in range(-20, 20) for j in range(20)])
        >>> steps = list(iterate_odometry([wall, loom.PointCloud(), wall]))
        >>> summarize_steps(steps).predicted
        (1,)
    """
    steps = check_list("steps", steps, "OdometryStep")
    for step in steps:
        if not isinstance(step, OdometryStep):
            raise TypeError(f"steps: expected a list of OdometryStep, got one of {type(step).__name__}")
    matched = [step for step in steps if step.iterations]
    path = np.array([step.pose[:3, 3] for step in steps]).reshape(-1, 3)
    lengths = np.linalg.norm(np.diff(path, axis=0, prepend=path[:1]), axis=1)
    free = [step for step in steps if step.is_undetermined and not step.has_prior]
    split = [step for step in steps if step.rivals]
    resting = _resting(steps)
    return OdometrySummary(
        len(steps),
        float(lengths[1:].sum()),
        tuple(step.index for step in steps if step.is_predicted),
        tuple(step.index for step in steps if step.is_unsettled),
        tuple(step.index for step in steps if step.has_strayed),
        float(np.mean([step.fitness for step in matched])) if matched else math.nan,
        float(np.mean([step.iterations for step in matched])) if matched else math.nan,
        tuple(step.index for step in steps if step.reason == NO_POINTS),
        tuple(step.index for step in free),
        _open_motions(free),
        float(sum(lengths[i] for i, step in enumerate(steps) if step.is_undetermined and not step.has_prior)),
        tuple(step.index for step in split),
        min(split[0].rivals, key=lambda way: math.hypot(*way)) if split else (),
        tuple(step.index for step in resting if step.fitness < RESTING_FITNESS),
        len(resting),
    )


def _resting(steps: Sequence[OdometryStep]) -> list[OdometryStep]:
    """Matched scans at whose pose the scanner was three scans before too."""
    found = []
    for before, step in zip(steps, steps[3:], strict=False):
        way = norm(step.pose[:3, 3] - before.pose[:3, 3])
        turn = norm(step.pose[:3, :3] - before.pose[:3, :3]) / math.sqrt(2)
        if step.is_sound and step.iterations and way < REST[0] and turn < REST[1]:
            found.append(step)
    return found


def _open_motions(steps: Sequence[OdometryStep]) -> str:
    """What these scans leave open, in words: the directions that half of them share, or the one that most do."""
    ways: list[tuple[float, str]] = []
    for word, found in (
        ("along", [row for step in steps for row in step.undetermined]),
        ("about", [row for step in steps for row in step.undetermined_turns]),
    ):
        if found:
            rows = np.array(found)
            values, vectors = eigh(matmul(rows.T, rows) / len(steps))
            ways += [(float(values[i]), f"{word} {_direction(vectors[:, i])}") for i in (2, 1, 0)]
    return ", ".join(way for share, way in ways if share > 0.5) or max(ways, default=(0.0, ""))[1]


def _direction(v: NDArray[np.float64]) -> str:
    axis = int(np.abs(v).argmax())
    if abs(v[axis]) > ALONG_AXIS:
        return "xyz"[axis]
    return "({:.2f}, {:.2f}, {:.2f})".format(*(v * np.sign(v[axis])))


def _scans(numbers: Sequence[int]) -> str:
    return f"scan {some_runs(numbers)}"
