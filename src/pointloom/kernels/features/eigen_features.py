"""Eigenvalue features of each point's neighborhood.

Weinmann et al., "Semantic point cloud interpretation based on optimal neighborhoods, relevant features and efficient
classifiers", ISPRS Journal 105, 2015, section 3.2.1 (equations 5 to 12, normalized eigenvalues) and 3.2.2 (density).
Surface variation: Pauly, Gross and Kobbelt 2002.
"""

from typing import TYPE_CHECKING

from ..algebra.eigen import eigenvalues, smallest_eigenvector
from ..algebra.moments import covariance_of, moments
from ..array_types import Array2, Device, Scalars
from ..arrays.packed_keys import key_number
from ..lang import NAN, array, float32, float64, func, int32, kernel, launch, log, pow, sqrt, struct, tid, vec3d
from ..memory import empty, full
from ..search.distinct_points import by_distinct_points
from ..search.group_scratch import GroupScratch, LaunchPart, stored_key
from ..search.neighbor_limits import Neighborhood, members_of, neighbors_of
from ..search.point_tree import LARGEST_SQDIST
from ..surface.neighbor_moments import sum_neighbor_moments

if TYPE_CHECKING:
    from ..search.point_tree import PointTree

MIN_NEIGHBORS = 3.0  # fewer points define no plane
UNIT_BALL_VOLUME = 4.18879020478639  # the volume of a ball of radius 1
MIN_RELATIVE_EIGENVALUE = 1.0e-15  # of the largest eigenvalue: below is rounding
SHAPES = (
    "linearity",
    "planarity",
    "sphericity",
    "omnivariance",
    "anisotropy",
    "eigenentropy",
    "curvature",
    "verticality",
    "density",
)


@func
def eigenvalues_of(m: moments) -> vec3d:
    """Eigenvalues [m^2] of the covariance in ascending order. Zero below rounding."""
    values = eigenvalues(covariance_of(m))
    floor_value = values[2] * float64(MIN_RELATIVE_EIGENVALUE)
    low = float64(0.0)
    middle = float64(0.0)
    if values[0] > floor_value:
        low = values[0]
    if values[1] > floor_value:
        middle = values[1]
    return vec3d(low, middle, max(values[2], 0.0))


@func
def entropy_of(fraction: float64) -> float64:
    """-x ln x, and its limit at zero."""
    entropy = float64(0.0)
    if fraction > 0.0:
        entropy = -fraction * log(fraction)
    return entropy


@struct
class Shapes:
    """Features per point, NaN until measured: `eigenvalues` [m^2], largest first; `density` [1 / m^3]."""

    eigenvalues: array(dtype=float32, ndim=2)
    linearity: array(dtype=float32)
    planarity: array(dtype=float32)
    sphericity: array(dtype=float32)
    omnivariance: array(dtype=float32)
    anisotropy: array(dtype=float32)
    eigenentropy: array(dtype=float32)
    curvature: array(dtype=float32)
    verticality: array(dtype=float32)
    density: array(dtype=float32)

    def __init__(self, count: int, device: Device) -> None:
        self.eigenvalues = full((count, 3), NAN, float32, device)
        for name in SHAPES:
            setattr(self, name, full(count, NAN, float32, device))


@func
def density_of(count: float64, sqdist: float) -> float:
    """Points per cubic meter of a ball of squared radius [m^2]. NaN if it is zero or infinite."""
    density = float(NAN)
    if sqdist > 0.0 and sqdist < LARGEST_SQDIST:
        radius = sqrt(float64(sqdist))
        density = float(count / (radius * radius * radius * float64(UNIT_BALL_VOLUME)))
    return density


@kernel(max_registers=80)
def find_ends_kernel(
    part: LaunchPart,
    ranks: array(dtype=int32),
    neighborhood: Neighborhood,
    scratch: GroupScratch,
    max_nn: int,
    sqradius: float,
    ends: array(dtype=float32),
):
    """Squared radius of the ball of each neighborhood: of the last neighbor if there are `max_nn`."""
    i = tid()
    for member, base, stored in members_of(i, part, ranks, neighborhood, scratch):
        rank = ranks[member]
        limit = neighborhood.limits[rank]
        count = int(0)
        farthest = float(0.0)
        if stored < 0:
            for j, sqdist in neighbors_of(rank, neighborhood):
                count += 1
                farthest = max(farthest, sqdist)
        for j in range(stored):
            key = stored_key(scratch, base, j)
            if key <= limit:
                count += 1
                farthest = max(farthest, key_number(key))
        ends[rank] = farthest if count == max_nn else sqradius


@kernel
def measure_shapes_kernel(
    sums: array(dtype=moments), ends: array(dtype=float32), order: array(dtype=int32), shapes: Shapes
):
    """Eigenvalues and features of each point. NaN for degenerate neighborhoods."""
    i = tid()
    at = order[i]
    m = sums[i]
    v = eigenvalues_of(m)
    total = v[0] + v[1] + v[2]
    if m[0] >= float64(MIN_NEIGHBORS) and total > 0.0:
        shapes.eigenvalues[at, 0] = float(v[2])
        shapes.eigenvalues[at, 1] = float(v[1])
        shapes.eigenvalues[at, 2] = float(v[0])
        shapes.linearity[at] = float((v[2] - v[1]) / v[2])
        shapes.planarity[at] = float((v[1] - v[0]) / v[2])
        shapes.sphericity[at] = float(v[0] / v[2])
        shapes.anisotropy[at] = float((v[2] - v[0]) / v[2])
        e = v / total
        shapes.omnivariance[at] = float(pow(e[0] * e[1] * e[2], float64(1.0) / float64(3.0)))
        shapes.eigenentropy[at] = float(entropy_of(e[0]) + entropy_of(e[1]) + entropy_of(e[2]))
        shapes.curvature[at] = float(e[0])
        normal = smallest_eigenvector(covariance_of(m))
        shapes.verticality[at] = float(1.0 - abs(normal[2]))
        shapes.density[at] = density_of(m[0], ends[i])


@kernel
def measure_curvature_kernel(sums: array(dtype=moments), order: array(dtype=int32), curvature: array(dtype=float32)):
    i = tid()
    m = sums[i]
    v = eigenvalues_of(m)
    total = v[0] + v[1] + v[2]
    if m[0] >= float64(MIN_NEIGHBORS) and total > 0.0:
        curvature[order[i]] = float(v[0] / total)


def measure_shapes(tree: "PointTree", radius: float, max_nn: int | None) -> dict[str, Scalars | Array2[float32]]:
    """Eigenvalues (n, 3), largest first, and SHAPES (n), float32 by name. NaN for fewer than three neighbors. `max_nn`
    includes the point itself. None takes all within `radius` [m] (exclusive).
    """
    names = ("eigenvalues", *SHAPES)
    found = by_distinct_points(tree, max_nn, radius, lambda tree: _measure_shapes(tree, radius, max_nn))
    return dict(zip(names, found, strict=True))


def _measure_shapes(tree: "PointTree", radius: float, max_nn: int | None) -> list[Scalars | Array2[float32]]:
    around = Neighborhood(tree, radius, max_nn)
    sums = sum_neighbor_moments(around)
    shapes = Shapes(tree.source.size, tree.device)
    if max_nn is None:
        ends = full(tree.count, around.max_sqdist, float32, tree.device)
    else:
        ends = empty(tree.count, float32, tree.device)
        around.visit(find_ends_kernel, around.positions, [max_nn, around.max_sqdist, ends])
    launch(measure_shapes_kernel, tree.count, [sums, ends, tree.order, shapes])
    return [getattr(shapes, name) for name in ("eigenvalues", *SHAPES)]


def measure_curvature(tree: "PointTree", radius: float, max_nn: int | None) -> Scalars:
    """Surface variation of each neighborhood, float32 (n), 0 .. 1/3. NaN as in `measure_shapes`."""
    (curvature,) = by_distinct_points(tree, max_nn, radius, lambda tree: [_measure_curvature(tree, radius, max_nn)])
    return curvature


def _measure_curvature(tree: "PointTree", radius: float, max_nn: int | None) -> Scalars:
    sums = sum_neighbor_moments(Neighborhood(tree, radius, max_nn))
    curvature = full(tree.source.size, NAN, float32, tree.device)
    launch(measure_curvature_kernel, tree.count, [sums, tree.order, curvature])
    return curvature
