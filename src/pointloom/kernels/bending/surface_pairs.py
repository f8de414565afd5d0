"""Correspondences between a deformed body and a surface, and boundary points of a surface. Pairs are rejected by
distance, normal, or if on the boundary. On a straight boundary the neighbors' center is offset along the surface by
0.42 of their radius, inside by about 0.1.
"""

from ..algebra.transform import widen
from ..array_types import Array2, Integers, Points, Vectors
from ..arrays.packed_keys import key_index, key_number
from ..lang import array, compute, dot, float32, float64, int32, int64, isfinite, kernel, sqrt, struct, tid, vec3, vec3d
from ..search.point_tree import PointTree
from ..search.tree_search import search_nearest
from .bending_steps import BendingRows

BORDER_FRACTION = 0.3  # of the neighborhood radius: between boundary and interior
BORDER_NEIGHBORS = 20  # neighbors. Points with fewer than half of them are not classified


@struct
class Surface:
    """Target surface: `points`, `normals` vec3 (m); `borders` int32 (m), 1 on the boundary."""

    points: array(dtype=vec3)
    normals: array(dtype=vec3)
    borders: array(dtype=int32)

    def __init__(self, points: Points, normals: Vectors, borders: Integers) -> None:
        self.points, self.normals, self.borders = points, normals, borders


@struct
class PairRule:
    """Pair options: `min_cosine` between normals, either sign unless `sided`; `plane_weight`, `point_weight`."""

    min_cosine: float64
    sided: int
    plane_weight: float64
    point_weight: float64

    def __init__(self, min_cosine: float, sided: bool, plane_weight: float, point_weight: float) -> None:
        self.min_cosine, self.sided = float(min_cosine), int(sided)
        self.plane_weight, self.point_weight = float(plane_weight), float(point_weight)


@kernel
def find_borders_kernel(
    points: array(dtype=vec3),
    normals: array(dtype=vec3),
    near: array(dtype=int32, ndim=2),
    sqdists: array(dtype=float32, ndim=2),
    counts: array(dtype=int32),
    borders: array(dtype=int32),
):
    """1 if the neighbors' center is offset."""
    i = tid()
    is_border = 0
    count = counts[i]
    if count > BORDER_NEIGHBORS // 2:
        p = widen(points[i])
        total = vec3d(0.0, 0.0, 0.0)
        for k in range(count):
            total += widen(points[near[i, k]]) - p
        total = total / float64(count)
        n = widen(normals[i])
        total = total - dot(total, n) * n
        sqradius = float64(sqdists[i, count - 1])
        if dot(total, total) > float64(BORDER_FRACTION * BORDER_FRACTION) * sqradius:
            is_border = 1
    borders[i] = is_border


@kernel
def pair_points_kernel(
    moved: array(dtype=vec3),
    normals: array(dtype=vec3),
    nearest: array(dtype=int64),
    surface: Surface,
    rule: PairRule,
    rows: BendingRows,
    partners: array(dtype=int32),
    distances: array(dtype=float64),
):
    """Partner of each point, its row, and the distance, or -1 for none."""
    i = tid()
    partner = key_index(nearest[i])
    is_paired = 0
    if partner >= 0 and isfinite(moved[i]):
        if surface.borders[partner] == 0:
            agreement = dot(widen(normals[i]), widen(surface.normals[partner]))
            if rule.sided == 0:
                agreement = abs(agreement)
            if isfinite(agreement) and agreement >= rule.min_cosine:
                is_paired = 1
    distance = float64(-1.0)
    plane_weight = float64(0.0)
    point_weight = float64(0.0)
    if is_paired == 1:
        rows.targets[i] = widen(surface.points[partner])
        rows.normals[i] = surface.normals[partner]
        distance = sqrt(float64(key_number(nearest[i])))
        plane_weight = rule.plane_weight
        point_weight = rule.point_weight
    else:
        partner = -1
    rows.plane_weights[i] = plane_weight
    rows.point_weights[i] = point_weight
    partners[i] = partner
    distances[i] = distance


@kernel
def measure_residuals_kernel(
    moved: array(dtype=vec3), partners: array(dtype=int32), surface: Surface, residuals: array(dtype=float64)
):
    """Distance of each point from its partner's plane, or -1 without one."""
    i = tid()
    residual = float64(-1.0)
    if partners[i] >= 0:
        n = widen(surface.normals[partners[i]])
        residual = abs(dot(widen(moved[i]) - widen(surface.points[partners[i]]), n))
    residuals[i] = residual


@kernel
def pin_rows_kernel(first: int, targets: array(dtype=vec3d), weight: float64, rows: BendingRows):
    i = tid()
    rows.targets[first + i] = targets[i]
    rows.normals[first + i] = vec3(0.0, 0.0, 0.0)
    rows.plane_weights[first + i] = 0.0
    rows.point_weights[first + i] = weight


def find_borders(tree: PointTree, normals: Vectors) -> Integers:
    near: tuple[Array2[int32], Array2[float32], Integers] = search_nearest(tree, tree.source, BORDER_NEIGHBORS)
    return compute(find_borders_kernel, tree.source.size, [tree.source, normals, *near], int32, tree.device)
