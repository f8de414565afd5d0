"""The points of a shape that hang together, those that no shape has yet, and how far points are from theirs.

Schnabel, Wahl and Klein 2007, section 4.5, count the largest connected part of a shape's points in a bitmap over its
parameters. Here points hang together by steps in space, shorter than a reach: as exact, and no kind needs a chart of
its own. A tree over the points, 20 B of memory each, and the disjoint sets of DBSCAN.
"""

from ..array_types import Indices, Integers, Points, Scalars
from ..arrays.select import gather_rows, positions_of
from ..lang import array, float32, int32, kernel, launch, tid, uint8, vec3, vec3d
from ..memory import empty
from ..search.point_tree import PointTree
from .cluster_labels import rank_by_size
from .dbscan import cluster_points
from .plane_samples import sampled_point
from .shape_models import measure
from .shape_search import Found, ShapeSearch


@kernel
def mask_label_kernel(labels: array(dtype=int32), rows: array(dtype=int32), label: int, mask: array(dtype=uint8)):
    """1 where the point of a row has a label."""
    i = tid()
    mask[i] = uint8(1 if labels[rows[i]] == label else 0)


@kernel
def mask_first_part_kernel(labels: array(dtype=int32), mask: array(dtype=uint8)):
    """1 for points of the first cluster."""
    i = tid()
    mask[i] = uint8(1 if labels[i] == 0 else 0)


@kernel
def write_distances_kernel(
    points: array(dtype=vec3),
    rows: array(dtype=int32),
    center: vec3d,
    kind: int,
    p: vec3d,
    a: vec3d,
    sizes: vec3d,
    distances: array(dtype=float32),
):
    """The signed distance of each point from a shape, at its row."""
    i = tid()
    m = measure(kind, p, a, sizes[0], sizes[1], sampled_point(points, rows[i], center))
    distances[rows[i]] = float32(m[0])


def largest_part(points: Points, rows: Indices, reach: float) -> Indices:
    """The rows of the largest group of points that hang together by steps shorter than a reach, in their order."""
    if rows.size == 0:
        return rows
    chosen = gather_rows(points, rows)
    labels, count = cluster_points(PointTree(chosen), rows.size, reach, 1)
    rank_by_size(labels, count, 1, rows.size)
    mask = empty(rows.size, uint8, rows.device)
    launch(mask_first_part_kernel, rows.size, [labels, mask])
    return gather_rows(rows, positions_of(mask))


def rows_labelled(labels: Integers, rows: Indices, label: int) -> Indices:
    """Those of some rows whose points have a label, in their order; one sync."""
    mask = empty(rows.size, uint8, rows.device)
    launch(mask_label_kernel, rows.size, [labels, rows, label, mask])
    return gather_rows(rows, positions_of(mask))


def write_distances(search: ShapeSearch, found: Found, distances: Scalars) -> None:
    """distances[rows of the shape] = their signed distance from it [m]."""
    shape = found.fit.shape
    place, axis, sizes = vec3d(*shape[:3]), vec3d(*shape[3:6]), vec3d(shape[6], shape[7], 0.0)
    arguments = [search.points, found.rows, vec3d(*search.center), found.kind, place, axis, sizes, distances]
    launch(write_distances_kernel, found.rows.size, arguments)
