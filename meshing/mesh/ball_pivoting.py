"""Meshes of clouds by balls that rest on three points: `TriangleMesh.create_from_point_cloud_ball_pivoting`."""

from __future__ import annotations

from typing import Any, Self

import numpy as np

from ...core.checks import check_list, check_positive, shown
from ...core.told_arguments import told_arguments
from ...core.units import warn_of_units
from ...kernels.arrays.quantiles import quantiles_of
from ...kernels.reconstruction.ball_surface import RollingBall, count_around
from ...kernels.search.neighbor_distances import nearest_distances
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from .mesh_arrays import MeshArrays

FIRST_RADIUS = 1.5  # spacings: the ball bridges the cells of a grid, whose circles have 0.7 of one, and some gaps
LEAST_RADII, MOST_RADII = 3, 6  # taken from the cloud, each twice the one before
WIDE_SHARE = 0.98  # of the points: the last radius is for those farthest from the others, but not for strays
MOST_NEIGHBORS = 2**33  # of all points together, some ten minutes of two cores
LARGEST_SHARE = 1e4  # times the box: beyond it the ball is flat to what float64 tells apart
CORNERS = 3  # points of a triangle
SHORT = 0.1  # of the usual radius: below that a ball hardly touches two points


class BallPivoting(MeshArrays):
    """The part of TriangleMesh that makes one of a cloud by rolling balls."""

    @classmethod
    @told_arguments
    def create_from_point_cloud_ball_pivoting(cls, cloud: PointCloud, radii: Any = None) -> Self:
        """A mesh of a cloud: the triangles that a ball can rest on without a point inside.

        Args:
            cloud: A PointCloud with normals that point out of the surface.
            radii: Radii [m] of the ball, in the order in which they are used: one number or several. None takes 1.5
                times the spacing, which is the median distance of nearest points, and doubles it until three radii are
                there and 98 % of the points have a neighbour within the last one, up to six radii.

        Returns:
            The mesh on the cloud's device: all its points as vertices, in its order and with its normals and colours,
            and triangles that turn counter-clockwise seen from where the normals point. No edge has more than two
            triangles, and neighbours turn the same way. Holes stay where no ball fits.

        Raises:
            TypeError: No PointCloud, or radii that are no numbers.
            ValueError: A cloud without normals, no radius, one that is not a finite number > 0 or is 10,000 times the
                cloud's box, or radii for which the search would take hours; the message gives the estimate.

        Notes:
            Bernardini et al. 1999, "The ball-pivoting algorithm for surface reconstruction", without an order: all
            triangles whose ball is empty and which agree with the normals of their corners are found at once. Where
            several want the same side of an edge that with the smallest circle is taken, ties by indices. So the same
            bits from run to run, on every device and for any number of threads. Open3D's triangles of one radius are
            among them but where they share such an edge; it finds fewer. A later radius adds triangles to edges that
            have one triangle and to points that have none; unlike Open3D it always begins anew there, too. As in
            Open3D a later radius may be the smaller one.

            Points that are not finite, or have a normal that is zero or not finite, take no part; of points at one
            place the first does. Points on one circle, as of a grid, make a fan about the first. All is decided in
            float64 from the float32 coordinates about the cloud's origin, the same at every scale.

            Memory: some 1 kB a point on the CPU, scratch included, for radii of a few spacings; never a list of all
            neighbours.

        Example:
            >>> import numpy as np, pointloom as loom
            >>> rng = np.random.default_rng(0)
            >>> ball = rng.normal(size=(2000, 3))
            >>> ball /= np.linalg.norm(ball, axis=1, keepdims=True)
            >>> cloud = loom.PointCloud(ball, normals=ball)
            >>> mesh = loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, [0.1, 0.2])
            >>> mesh.is_edge_manifold(), len(mesh) > 3900
            (True, True)
        """
        check_cloud("cloud", cloud)
        normals = cloud._required_array(
            "normals",
            "call cloud = cloud.estimate_normals(), then cloud = cloud.orient_normals_consistent_tangent_plane(15)",
        )
        points = cloud._device_array("points")
        given = None if radii is None else _check_radii(radii)
        ball = RollingBall(points, normals, cloud.search_tree)
        extent = float((np.asarray(ball.tree.high, np.float64) - ball.tree.low).max()) if ball.tree.count > 2 else 0.0
        sizes = _default_radii(ball.tree) if given is None else given
        if extent:
            _check_size(sizes, extent)
        triangles = ball.roll(sizes, len(cloud), _check_work)
        if given is not None and not triangles.size and ball.tree.count >= CORNERS:
            told, usual = (", ".join(f"{r:.3g}" for r in radii) for radii in (given, _default_radii(ball.tree)))
            if max(given) < SHORT * _default_radii(ball.tree)[0]:
                m = "" if cloud.unit is None else f" {cloud.unit.symbol}"
                message = f"radii: balls of {told}{m} touch no three points; the points' spacing asks for {usual}{m}"
                warn_of_units(message)
        colors = cloud._device_array("colors") if cloud.has_colors else None
        mesh = cls._from_device_arrays(
            points,
            triangles,
            vertex_normals=normals,
            vertex_colors=colors,
            origin=cloud.origin,
            library=cloud.array_library,
        )
        mesh.unit = cloud.unit
        return mesh


def _check_radii(radii: Any) -> list[float]:
    values = [radii] if isinstance(radii, int | float | np.number) else check_list("radii", radii, "radii [m]")
    if not values:
        raise ValueError("radii: expected one radius [m] or more, got none; None takes them from the cloud's spacing")
    return [check_positive("radii", value) for value in values]


def _default_radii(tree: Any) -> list[float]:
    """From 1.5 times the median distance of nearest points on, each twice the one before."""
    if tree.count < 3:
        return []
    distances = nearest_distances(tree, tree.source, others=True)  # NaN at points out of the tree
    spacing, wide = quantiles_of(distances, (0.5, WIDE_SHARE))  # sync
    radii = [FIRST_RADIUS * spacing * 2**i for i in range(MOST_RADII)]
    needed = sum(radius < wide for radius in radii) + 1
    return radii[: max(LEAST_RADII, needed)]


def _check_size(radii: list[float], extent: float) -> None:
    for radius in radii:
        if radius > LARGEST_SHARE * extent:
            raise ValueError(
                f"radii: {shown(radius)} m is more than {LARGEST_SHARE:,.0f} times the {extent:.3g} m that the points "
                "span; take a few times their spacing, or None"
            )


def _check_work(tree: Any, radius: float, places: Any) -> None:
    """Refuse a radius whose neighbours are too many to look at."""
    if tree.count * places.size <= MOST_NEIGHBORS:
        return
    mean = count_around(tree, places, 2 * radius)  # sync
    if mean * places.size > MOST_NEIGHBORS:
        raise ValueError(
            f"radii: at {radius:.6g} m some {mean:,.0f} points lie within twice the radius of each of {places.size:,}, "
            f"{mean * places.size:.1e} in all, where {MOST_NEIGHBORS:.1e} take minutes; take a smaller radius, or "
            "cloud.voxel_down_sample() with a voxel of half the radius first"
        )
