"""Triangles of a mesh that run into each other, or into another mesh."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...core.devices import check_same_device
from ...kernels.arrays.concatenation import concatenate_points
from ...kernels.arrays.row_numbers import pair_up
from ...kernels.meshes.mesh_edits import shift_triangles
from ...kernels.rays.cutting_triangles import find_meeting_pairs
from ...kernels.rays.triangle_tree import TriangleTree
from .finite_corners import check_finite_corners
from .mesh_arrays import MeshArrays

if TYPE_CHECKING:
    from .mesh import TriangleMesh


class MeshIntersections(MeshArrays):
    """The part of TriangleMesh that finds triangles with a point in common.

    Corners and edges belong to their triangles, and what touches meets. It is decided exactly for the float32
    coordinates that a mesh stores, by float64 with a bound of its error and by whole numbers where that leaves it
    open, so that neither size nor place matter. Open3D reports triangles that lie apart in one plane (#5117, #5525) and
    misses some that touch. Triangles without area count as the edges that they are. In lists of triangles those with a
    corner that is not finite meet nothing; `is_self_intersecting` and `is_intersecting` raise ValueError for them.
    """

    def is_self_intersecting(self) -> bool:
        """Whether any two triangles without a common vertex have a point in common.

        Raises:
            ValueError: A triangle has a corner that is not finite.

        Notes:
            As of `get_self_intersecting_triangles`.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).is_self_intersecting()
            True
        """
        check_finite_corners("is_self_intersecting", self)
        return len(self.get_self_intersecting_triangles()) > 0

    def get_self_intersecting_triangles(self) -> NDArray[np.int32]:
        """The pairs of triangles without a common vertex that have a point in common.

        Returns:
            int32 [k, 2], the lower number first, ascending. Vertices at one place with two numbers are two vertices,
            so in a soup of triangles all neighbours meet; as in Open3D.

        Raises:
            ValueError: 2^31 pairs or more.

        Notes:
            O(n log n) time for a surface, O(n + k) memory; Open3D tests all pairs. Same bits from run to run and on
            every device. Guigue and Devillers 2003; Shewchuk 1997 for the bounds.

        Example:
            >>> import pointloom as loom
            >>> corners = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]]
            >>> loom.TriangleMesh(corners, [[0, 1, 2], [3, 4, 5]]).get_self_intersecting_triangles().tolist()
            [[0, 1]]
        """
        vertices, triangles = self._arrays["vertices"], self._arrays["triangles"]
        tree = TriangleTree(vertices, triangles)
        first, second = find_meeting_pairs(tree, vertices, triangles, triangles, within=True)
        return self._handed_out(pair_up(first, second))

    def is_intersecting(self, other: TriangleMesh) -> bool:
        """Whether a triangle of this mesh and one of another have a point in common.

        Where one mesh lies inside the other, the surfaces have none: see `RaycastingScene.compute_occupancy`.

        Args:
            other: Another mesh on the same device; where its `origin` is another one, its vertices are rounded to
                float32 about this one's.

        Raises:
            TypeError: No mesh.
            DeviceError: The meshes are on different devices.
            ValueError: 2^31 pairs of triangles or more, or a triangle with a corner that is not finite.

        Example:
            >>> import pointloom as loom
            >>> floor = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 2, 0]], [[0, 1, 2]])
            >>> wall = loom.TriangleMesh([[0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 1]], [[0, 1, 2]])
            >>> floor.is_intersecting(wall)
            True
        """
        check_mesh("other", other)
        check_same_device("other", self._device, other.device)
        check_finite_corners("is_intersecting", self)
        check_finite_corners("is_intersecting: other", other)
        if not len(self) or not len(other):
            return False
        own = self._arrays["vertices"]
        shifts = [np.zeros(3), other.origin - self._origin]
        vertices = concatenate_points([own, other._device_arrays["vertices"]], shifts)
        theirs = shift_triangles(other._device_arrays["triangles"], own.size)
        tree = TriangleTree(vertices, theirs)
        return find_meeting_pairs(tree, vertices, self._arrays["triangles"], theirs, within=False)[0].size > 0


def check_mesh(name: str, mesh: Any) -> None:
    """Refuse what is no mesh.

    Raises:
        TypeError: It is none.
    """
    if not isinstance(mesh, MeshArrays):
        raise TypeError(f"{name}: expected a TriangleMesh, got {type(mesh).__name__}")
