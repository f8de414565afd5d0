"""Convex hulls and the points that a camera sees."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.array_libraries import hand_out_host
from ..core.checks import check_finite, check_positive, check_shape
from ..kernels.arrays.select import gather_rows
from ..kernels.extent.visibility import visible_rows
from ..kernels.lang import int32
from ..kernels.memory import download, upload
from ..kernels.search.hilbert_order import HilbertOrder
from .convex_hull import ConvexHull, find_extremes, hull_of_cloud
from .selection import Selection


@dataclass(frozen=True, eq=False)
class VisibleSurface:
    """The points that a camera sees, joined by triangles that face it.

    `loom.TriangleMesh(surface.vertices, surface.triangles)` makes a mesh of it.

    Attributes:
        vertices: Shape [m, 3], the visible points' world coordinates [m].
        triangles: int32 [t, 3], rows of `vertices`, counter-clockwise seen from the camera.

    Example:
        >>> import pointloom as loom
        >>> cloud = loom.PointCloud([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0.1, 0.1, -5]])
        >>> surface, indices = cloud.hidden_point_removal([0.2, 0.2, 3], 100)
        >>> surface, indices.tolist()
        (VisibleSurface(3 vertices, 1 triangles), [0, 1, 2])
    """

    vertices: NDArray[np.float64]
    triangles: NDArray[np.int32]

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self.vertices):,} vertices, {len(self.triangles):,} triangles)"


class Hulls(Selection):
    """The part of PointCloud that deals with convex hulls."""

    def compute_convex_hull(self, joggle_inputs: bool = False) -> tuple[ConvexHull, NDArray[np.int64]]:
        """The convex hull of the finite points.

        Kernels rule out the points inside a coarse hull of the farthest ones; Qhull makes the hull of the rest from
        float64 positions relative to the origin. Points that lie in one plane, to the rounding of float32, have a flat
        hull: their polygon, seen from both sides (Open3D raises Qhull's error QH6154).

        Args:
            joggle_inputs: Let Qhull move its input by some 1e-11 of its size instead of merging facets.

        Returns:
            The hull, and the index of the cloud's point at each of its vertices, ascending, int64 [m].

        Raises:
            ValueError: No point is finite, or all lie on one line.

        Notes:
            40 B of memory a point. The same bits from run to run. Barber et al., "The Quickhull algorithm for convex
            hulls", TOMS 1996.
        """
        extremes, indices, positions = hull_of_cloud(self._arrays["points"], bool(joggle_inputs))
        if extremes.dimension < 2:
            place = "are equal" if extremes.dimension == 0 else "lie on one line"
            raise ValueError(
                f"points: all {len(self):,} {place}, which has no convex hull; get_oriented_bounding_box() bounds them"
            )
        vertices = positions[extremes.rows] + self._origin
        hull = ConvexHull(vertices, extremes.triangles, extremes.volume, extremes.area)
        return hull, hand_out_host(indices[extremes.rows], self._library, self.device)

    def hidden_point_removal(
        self, camera_location: ArrayLike, radius: float
    ) -> tuple[VisibleSurface, NDArray[np.int64]]:
        """The points that a camera sees: those not hidden behind the surface that the others stand for.

        Points are mirrored about a sphere around the camera; those that become vertices of the convex hull of all and
        the camera are seen. Kernels mirror in float64 and rule out what lies inside a coarse hull, Qhull does the rest.
        A point at the camera itself is not seen (Open3D's hull is of NaN then). Where all points and the camera lie in
        one plane, what is seen in that plane is found (Open3D raises Qhull's error QH6154).

        Args:
            camera_location: World coordinates [m], shape [3].
            radius: Of the sphere [m], at least the distance of the farthest point. Larger radii see more of the
                points, and more of the hidden ones; a thousand times the cloud's size is a start. Test it from the
                scanner's own place, where nearly all should be seen: fewer, and a larger one is needed.

        Returns:
            The surface of the visible points, and their indices, ascending, int64 [m].

        Raises:
            ValueError: The radius is not positive, or the camera not finite.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> u = np.linspace(0, np.pi, 40)
            >>> ball = [[np.sin(a) * np.cos(2 * b), np.sin(a) * np.sin(2 * b), np.cos(a)] for a in u for b in u]
            >>> cloud = loom.PointCloud(ball)
            >>> _, indices = cloud.hidden_point_removal([0, 0, 5], 100)
            >>> bool(cloud.points[indices, 2].min() > 0)
            True

        Notes:
            40 B of memory a point. The same bits from run to run. Katz, Tal and Basri, "Direct visibility of point
            sets", SIGGRAPH 2007.
        """
        camera = check_finite("camera_location", check_shape("camera_location", camera_location, (3,)))
        points = self._arrays["points"]
        candidates, flipped = visible_rows(points, self._origin - camera, check_positive("radius", radius))
        # Qhull is a fifth faster on points that follow a curve through space
        along = download(HilbertOrder(gather_rows(points, candidates)).order)  # sync
        rows, mirrored = download(candidates).astype(np.int64)[along], download(flipped)[along]  # sync
        extremes = find_extremes(np.concatenate([mirrored, np.zeros((1, 3))]))
        seen = extremes.rows[extremes.rows < len(rows)]  # the camera, last of the rows, is no point of the cloud
        triangles = extremes.triangles[(extremes.triangles < len(seen)).all(axis=1)]
        ascending = np.argsort(rows[seen])
        indices = rows[seen][ascending]
        places = np.empty(len(seen), np.int32)
        places[ascending] = np.arange(len(seen), dtype=np.int32)
        triangles = places[triangles]
        vertices = download(gather_rows(points, upload(indices, int32, self.device))) + self._origin
        surface = VisibleSurface(vertices, np.ascontiguousarray(triangles[:, ::-1]))
        return surface, hand_out_host(indices, self._library, self.device)
