"""Pairs of all jobs under their poses."""

from typing import TYPE_CHECKING

from ..algebra.rigid_solve import move
from ..algebra.transform import widen
from ..array_types import AnyArray, Points
from ..lang import array, float32, float64, func, int32, mat44d, struct, vec3, vec3d
from ..memory import full
from ..search.point_tree import LEAF
from ..search.tree_search import squared_radius
from .jobs import Jobs, source_position

if TYPE_CHECKING:
    from ..arrays.side_by_side import SideBySide

NO_PAIR = -1
LARGEST_SQDIST = 3.0e38  # [m^2] below infinity, whose bits have no successor


@struct
class Matches:
    """Poses of jobs and pairs of source points. `max_sqdist` [m^2]; previous poses `earlier`. Search `margins` [m];
    `nearest` position or -1; `lowers` [m]: bound of the distance to all others; `pairs` or NO_PAIR.
    """

    jobs: Jobs
    targets: array(dtype=vec3)
    max_sqdist: float
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
        self.jobs, self.targets, self.max_sqdist = jobs, targets, min(squared_radius(max_distance), LARGEST_SQDIST)
        for name in ("poses", "earlier", "live", "margins"):
            setattr(self, name, states.arrays[name])
        self.nearest, self.pairs = (full(elements, NO_PAIR, int32, device) for _ in range(2))
        self.lowers = full(elements, -1.0, float32, device)
        self.weighted, self.weights = 0, self.lowers.reshape((elements, 1))

    def weigh(self, weights: AnyArray) -> None:
        """Weight the rows by source points: float32 (n, 1), in tree order."""
        self.weighted, self.weights = 1, weights


@struct
class PointColumns:
    """Attributes in tree order, if required: `gradients` [1 / m], `dopplers` [m/s], `directions` from the sensor."""

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
    job = matches.jobs.group_jobs[i // LEAF]
    return move(matches.poses[job], widen(matches.jobs.sources.points[source_position(i, matches.jobs)]))


@func
def paired_target(i: int, matches: Matches) -> vec3d:
    return widen(matches.targets[matches.pairs[i]])


@func
def weight_of(i: int, matches: Matches) -> float64:
    weight = float64(1.0)
    if matches.weighted != 0:
        weight = float64(matches.weights[source_position(i, matches.jobs), 0])
    return weight


@func
def pair_of(i: int, matches: Matches) -> tuple[vec3d, vec3d, float64]:
    """Posed source point, target point, and 1, or zeros without a pair."""
    p = vec3d(0.0)
    q = vec3d(0.0)
    paired = float64(0.0)
    if matches.pairs[i] >= 0:
        p = moved_source(i, matches)
        q = paired_target(i, matches)
        paired = 1.0
    return p, q, paired
