"""Points on the surface of a mesh: drawn by area, and spread evenly."""

from __future__ import annotations

import math
from typing import Any

from ...core.checks import check_count, check_seed
from ...core.told_arguments import told_arguments
from ...kernels.memory import check_room
from ...kernels.meshes.poisson_disk import CrowdedError, eliminate_samples
from ...kernels.meshes.surface_samples import SurfaceSamples
from ...pcd.cloud import PointCloud
from ...pcd.point_arrays import check_cloud
from .finite_corners import check_finite_corners
from .mesh_arrays import MeshArrays

SAMPLE_BYTES = 64  # of a point that is drawn, with its triangle, weights, normal and colour
MOST_SAMPLES = 2**24  # that an even choice begins with: about 4 GB with their neighbours


class MeshSampling(MeshArrays):
    """The part of TriangleMesh that samples its surface."""

    @told_arguments
    def sample_points_uniformly(
        self, number_of_points: int = 100, use_triangle_normal: bool = False, seed: int = 0
    ) -> PointCloud:
        """Points drawn from the surface at random, each place as likely as any other.

        Args:
            number_of_points: How many.
            use_triangle_normal: Give the points the normals of their triangles.
            seed: Chooses the points, 0..2^31 - 1.

        Returns:
            The points, about the mesh's origin. Where the mesh has vertex normals or colours, with those between the
            corners of their triangles; normals of unit length (Open3D leaves them shorter). Triangles without area get
            no points.

        Raises:
            ValueError: A count below 1, no triangles, none with an area, or one with a corner that is not finite.
            TypeError: No whole numbers.
            MemoryError: The device has no room for so many points.

        Notes:
            8 B of memory a triangle, 28 B a point beside the result. The same points on every device: the first k of
            n are those of k.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [2, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            >>> cloud = mesh.sample_points_uniformly(500, use_triangle_normal=True)
            >>> len(cloud), cloud.normals[0].tolist(), bool((cloud.points @ [1, 2, 0] <= 2).all())
            (500, [0.0, 0.0, 1.0], True)
        """
        count, seed = check_count("number_of_points", number_of_points), check_seed(seed)
        return self._draw(self._surface("sample_points_uniformly"), count, use_triangle_normal, seed)

    @told_arguments
    def sample_points_poisson_disk(
        self,
        number_of_points: int,
        init_factor: int = 5,
        pcl: PointCloud | None = None,
        use_triangle_normal: bool = False,
        seed: int = 0,
    ) -> PointCloud:
        """Points spread evenly over the surface: none is much closer to the next than the others are.

        Of `init_factor` times as many random points, those are removed one after the other that have the most and the
        nearest others about them. Open3D does the same; which points come back differs with the random ones.

        Args:
            number_of_points: How many come back, exactly.
            init_factor: Random points to begin with, for each one that comes back; 1 removes none.
            pcl: Points to choose from instead; they come back with all their attributes.
            use_triangle_normal: Give random points the normals of their triangles.
            seed: Chooses the random points, 0..2^31 - 1.

        Returns:
            The points, in the order in which they were drawn (or stand in `pcl`), as of `sample_points_uniformly`.

        Raises:
            ValueError: A count below 1, no triangles, none with an area, one with a corner that is not finite, fewer
                finite points in `pcl` than wanted, more than 2^24 to begin with, or more than 2^30 pairs of neighbors
                among them.
            TypeError: No whole numbers, or a `pcl` that is no PointCloud.
            MemoryError: The device has no room for the points or their neighbours.

        Notes:
            About 350 B of memory for each point to begin with where init_factor is 5, 260 of them for its neighbours,
            whose number grows in proportion to it. The same points on every device. Yuksel 2015, with its alpha 8, beta
            0.65 and gamma 1.5.

        Example:
            >>> import pointloom as loom
            >>> mesh = loom.TriangleMesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
            >>> cloud = mesh.sample_points_poisson_disk(200)
            >>> gaps = cloud.compute_nearest_neighbor_distance()
            >>> len(cloud), bool(gaps.min() > 0.7 * gaps.mean())
            (200, True)
        """
        count, factor, seed = (
            check_count("number_of_points", number_of_points),
            check_count("init_factor", init_factor),
            check_seed(seed),
        )
        surface = self._surface("sample_points_poisson_disk")
        if pcl is None:
            name, advice = "number_of_points, init_factor", "take fewer"
            if count * factor > MOST_SAMPLES:
                raise ValueError(
                    f"{name}: expected up to {MOST_SAMPLES:,} points to begin with, got {count * factor:,}; {advice}"
                )
            start = self._draw(surface, count * factor, use_triangle_normal, seed)
        else:
            check_cloud("pcl", pcl)
            name, advice = "pcl", "thin it first, as by pcl.random_down_sample"
            start = pcl.to(self.device)
            if len(start) > MOST_SAMPLES:
                raise ValueError(f"{name}: expected up to {MOST_SAMPLES:,} points, got {len(start):,}; {advice}")
        return _spread(start, count, surface.area, name, advice)

    # ------------------------------------------------------------------------------------------ internals

    def _surface(self, operation: str) -> SurfaceSamples:
        """The surface to draw from."""
        surface = SurfaceSamples(self._arrays["vertices"], self._arrays["triangles"])
        self._check_surface(surface, operation)
        return surface

    def _check_surface(self, surface: SurfaceSamples, operation: str) -> None:
        """Refuse a surface that there is nothing to draw from."""
        if not len(self):
            raise ValueError(f"{operation}: the mesh has no triangles, so it has no surface to draw points from")
        check_finite_corners(operation, self)
        if not surface.area > 0:
            raise ValueError(
                f"{operation}: none of the mesh's {len(self)} triangles has an area; each has two corners at one "
                "place, or all three on a line"
            )

    def _draw(self, surface: SurfaceSamples, count: int, use_triangle_normal: bool, seed: int) -> PointCloud:
        check_room(self._device, count * SAMPLE_BYTES, f"number_of_points: {count:,} points with what they are made of")
        surface.draw(count, seed)
        arrays: dict[str, Any] = {"points": surface.mix(self._arrays["vertices"])}
        if use_triangle_normal:
            arrays["normals"] = surface.triangle_normals()
        elif "vertex_normals" in self._arrays:
            arrays["normals"] = surface.mix(self._arrays["vertex_normals"], unit=True)
        if "vertex_colors" in self._arrays:
            arrays["colors"] = surface.mix(self._arrays["vertex_colors"])
        cloud = PointCloud._from_device_arrays(arrays, self._origin.copy(), self._library)
        cloud.unit = self._unit
        return cloud


def _spread(start: PointCloud, count: int, area: float, name: str, advice: str) -> PointCloud:
    """`count` of the points that spread evenly over an area; `name` is the argument that says where they come from."""
    tree = start.search_tree()
    if tree.count < count:
        raise ValueError(f"{name}: expected at least number_of_points = {count} finite points, got {tree.count}")
    if tree.count == count:
        return start.remove_non_finite_points()
    widest = 2 * math.sqrt(area / count / (2 * math.sqrt(3)))  # where discs of half of it fill the plane
    try:
        return start._select_rows(eliminate_samples(tree, count, widest))
    except CrowdedError as error:
        raise ValueError(
            f"{name}: {error.pair_count:,} pairs of points lie closer than {widest:.3g} m, expected up to 2^30; "
            f"{advice}"
        ) from error
