"""Normals whose sign depends on the surface alone: they point to the side towards which it is hollow.

Features of a point change where normals are turned over, and a cloud that may be moved anyhow says nothing of where its
sensor stood. The mean of a wider neighbourhood lies on the hollow side of a curved surface, whichever way the cloud is
turned (the rule by which Tombari, Salti and Di Stefano 2010 choose the axes of a local frame). On a plane noise
decides; there nothing is lost, since all planes look alike.

One walk a point through the tree, float64 sums of differences to the point, no list of neighbours. 12 B read and
written a point beside the search.
"""

from ..algebra.eigen import largest_entry, smallest_eigenvector, sorted_eigenvalues
from ..algebra.moments import add_rounded_difference, covariance_of, moments
from ..array_types import Points, Vectors
from ..arrays.select import gather_rows, positions_of
from ..extent.masks import mask_finite
from ..lang import NAN, array, float64, kernel, launch, tid, vec3, vec3d
from ..memory import full
from ..search.bucket_walk import points_in_reach
from ..search.point_tree import BUCKET, PointTree
from ..search.tree_search import reach_of

FEWEST = 5.0  # neighbours, the point among them, that show which way a surface lies
STRAIGHT = 1.0e-3  # ratio of variances below which they lie on a line, and the plane through it is any


@kernel(most_registers=128)
def find_sides_kernel(tree: PointTree, narrow: float, wide: float, normals: array(dtype=vec3)):
    """The normal of each point's narrow neighbourhood, on the side of the mean of its wide one."""
    i = tid()
    p = tree.points[i]
    total = moments(0.0)
    middle = vec3d(0.0, 0.0, 0.0)
    for j, sqdist in points_in_reach(i // BUCKET, p, wide, tree):
        q = tree.points[j]
        middle += vec3d(float64(q[0] - p[0]), float64(q[1] - p[1]), float64(q[2] - p[2]))
        if sqdist <= narrow:
            total = add_rounded_difference(total, p, q)
    n = vec3(NAN, NAN, NAN)
    if total[0] >= float64(FEWEST):
        covariance = covariance_of(total)
        size = largest_entry(covariance)
        if size > 0.0:
            values = sorted_eigenvalues(covariance * (1.0 / size))
            if values[1] > float64(STRAIGHT) * values[2]:
                v = smallest_eigenvector(covariance)
                if v[0] * middle[0] + v[1] * middle[1] + v[2] * middle[2] < 0.0:
                    v = -v
                n = vec3(float(v[0]), float(v[1]), float(v[2]))
    normals[tree.order[i]] = n


def find_sides(tree: PointTree, narrow: float, wide: float) -> Vectors:
    """Unit normals of a tree's points on the hollow side of the surface.

    Args:
        tree: A PointTree.
        narrow: Radius [m] of the neighbourhood that a plane is fitted to.
        wide: Radius [m] of the one whose mean decides the side, not smaller.

    Returns:
        Device array of vec3 [n]; NaN where fewer than five neighbours, or neighbours on a line, show no surface, and
        for points that are not finite.
    """
    normals = full(tree.source.size, vec3(NAN, NAN, NAN), vec3, tree.device)
    launch(find_sides_kernel, tree.count, [tree, reach_of(narrow), reach_of(wide), normals])
    return normals


class Surface:
    """The points of a cloud where a surface shows, their normals on its hollow side, and a tree over them.

    Attributes:
        points, normals: Device arrays of vec3 [m], none of them NaN, in the cloud's order.
        tree: PointTree of the points.
    """

    def __init__(self, points: Points, narrow: float, wide: float) -> None:
        """Take the points of a device array of vec3; radii [m] as of `find_sides`."""
        normals = find_sides(PointTree(points), narrow, wide)
        rows = positions_of(mask_finite(normals, 1, 1))
        self._keep(gather_rows(points, rows), gather_rows(normals, rows))

    @classmethod
    def of_known(cls, points: Points, normals: Vectors) -> "Surface":
        """One whose points and normals were found before: the same bits."""
        surface = cls.__new__(cls)
        surface._keep(points, normals)
        return surface

    def _keep(self, points: Points, normals: Vectors) -> None:
        self.points, self.normals = points, normals
        self.tree, self.device = PointTree(points), points.device

    def __len__(self) -> int:
        return self.points.size
