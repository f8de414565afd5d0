"""The pairs of all jobs under their poses: what an iteration finds, drops, sums and then moves on from."""

from typing import TYPE_CHECKING

from ..algebra.rigid_solve import move
from ..algebra.transform import widen
from ..array_types import AnyArray, Points
from ..lang import array, float32, float64, func, int32, mat44d, struct, vec3, vec3d
from ..memory import full
from ..search.point_tree import LEAF
from ..search.tree_search import reach_of
from .jobs import Jobs, source_place

if TYPE_CHECKING:
    from ..arrays.side_by_side import SideBySide

NO_PAIR = -1
LARGEST_REACH = 3.0e38  # [m^2] below infinity, whose bits have no successor


@struct
class Matches:
    """The poses of jobs, and the target point that each source point is paired with.

    Args:
        jobs: The jobs.
        states: Their `job_states`.
        max_distance: Pairs this far apart or farther do not count [m].
        targets: Positions that pairs refer to, vec3.

    Attributes:
        jobs: Whose element is whose.
        targets: The target points at their places, or the means of voxels.
        reach: Greatest squared distance of a pair [m^2].
        live: int32 [jobs], 0 where a job has come to its end.
        poses, earlier: T_target_source of each job between coordinates about the clouds' origins, and the one before.
        margins: How much farther than the nearest point [m] the search of each job looks.
        nearest: The place of the target point that each element was found nearest to; -1 for none.
        lowers: A lower bound [m] of its distance to every other target point.
        pairs: What each element is paired with, a place in `targets`; NO_PAIR for none.
        weighted: 1 where the rows of pairs are weighted by their source points.
        weights: float32 [n, 1], at the places of the source's points; not read where they are not.
    """

    jobs: Jobs
    targets: array(dtype=vec3)
    reach: float
    live: array(dtype=int32)
    poses: array(dtype=mat44d)
    earlier: array(dtype=mat44d)
    margins: array(dtype=float32)
    nearest: array(dtype=int32)
    lowers: array(dtype=float32)
    pairs: array(dtype=int32)
    weighted: int
    weights: array(dtype=float32, ndim=2)

    def __init__(self, jobs: Jobs, states: "SideBySide", max_distance: float, targets: Points) -> None:
        device, elements = jobs.device, jobs.group_count * LEAF
        self.jobs, self.targets, self.reach = jobs, targets, min(reach_of(max_distance), LARGEST_REACH)
        for name in ("poses", "earlier", "live", "margins"):
            setattr(self, name, states.arrays[name])
        self.nearest, self.pairs = (full(elements, NO_PAIR, int32, device) for _ in range(2))
        self.lowers = full(elements, -1.0, float32, device)
        self.weighted, self.weights = 0, self.lowers.reshape((elements, 1))

    def weigh(self, weights: AnyArray) -> None:
        """Weight the rows of pairs by their source points: float32 [n, 1], at the places of the points."""
        self.weighted, self.weights = 1, weights


@struct
class PointColumns:
    """What the points of one side have beside their positions; only what the rows in question need is there.

    Attributes:
        normals: vec3, at the places of the points.
        covariances: float32 [n, 9], row by row.
        intensities: float32 [n, 1].
        gradients: Of the intensity along the surface [1 / m], vec3.
        dopplers: Radial speeds [m/s], float32 [n, 1].
        directions: Unit vectors from the sensor, vec3.
    """

    normals: array(dtype=vec3)
    covariances: array(dtype=float32, ndim=2)
    intensities: array(dtype=float32, ndim=2)
    gradients: array(dtype=vec3)
    dopplers: array(dtype=float32, ndim=2)
    directions: array(dtype=vec3)

    def __init__(self, **arrays: AnyArray | None) -> None:
        vars(self).update(arrays)


@func
def moved_source(i: int, matches: Matches) -> vec3d:
    """The source point of element i under its job's pose."""
    job = matches.jobs.group_jobs[i // LEAF]
    return move(matches.poses[job], widen(matches.jobs.sources.points[source_place(i, matches.jobs)]))


@func
def paired_target(i: int, matches: Matches) -> vec3d:
    """The target point that element i is paired with."""
    return widen(matches.targets[matches.pairs[i]])


@func
def weight_of(i: int, matches: Matches) -> float64:
    """What the rows of element i's pair count."""
    weight = float64(1.0)
    if matches.weighted != 0:
        weight = float64(matches.weights[source_place(i, matches.jobs), 0])
    return weight


@func
def pair_of(i: int, matches: Matches) -> tuple[vec3d, vec3d, float64]:
    """The source point of element i under its pose, its target point, and 1; zeros where it has no pair."""
    p = vec3d(0.0)
    q = vec3d(0.0)
    paired = float64(0.0)
    if matches.pairs[i] >= 0:
        p = moved_source(i, matches)
        q = paired_target(i, matches)
        paired = 1.0
    return p, q, paired
