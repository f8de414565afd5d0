"""Distance queries of a scene: nearest triangle, distance, inside test."""

from __future__ import annotations

from typing import Any

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ...core.array_libraries import Form, form_of
from ...core.checks import check_count, check_numeric
from ...core.coordinates import quiet
from ...core.devices import DeviceLike
from ...core.gpu_arrays import take_positions
from ...kernels.algebra.transform import transform_points
from ...kernels.arrays.origins import add_origin
from ...kernels.lang import float64, vec3
from ...kernels.linear_algebra import inv
from ...kernels.memory import upload, zeros
from ...kernels.meshes.pseudonormals import Pseudonormals, volume_of_shell
from ...kernels.rays.closest_points import ClosestPoints, describe, find_sides, mark_inside, sign_distances
from ...kernels.rays.cutting_triangles import meet_anywhere
from ...kernels.rays.nearest_triangle import NearestTriangles
from ...kernels.rays.winding_numbers import Dipoles, add_winding_numbers
from .scene_geometries import SceneGeometries

INVALID_ID = 0xFFFFFFFF
PSEUDONORMALS, WINDING_NUMBERS = "pseudonormals", "winding_numbers"


class SceneDistances(SceneGeometries):
    """Methods of RaycastingScene that measure distances.

    `sign_method` is the inside test: "pseudonormals" (Baerentzen and Aanaes 2005), exact, for one closed, consistently
    oriented mesh without degenerate or intersecting triangles. Otherwise "winding_numbers" (Jacobson et al. 2013;
    Barill et al. 2018), inside above 1/2. Both treat an inverted mesh as if it faced outward.
    """

    _side_data: dict[int, Pseudonormals | None]  # by mesh, built on demand. None if not applicable
    _dipoles: dict[int, Dipoles]

    def __init__(self, device: DeviceLike = None):
        super().__init__(device)
        self._side_data, self._dipoles = {}, {}

    @property
    def sign_method(self) -> str:
        """Inside test of `compute_signed_distance` and `compute_occupancy` for the current scene.

        "pseudonormals" if the scene is one closed shell, else "winding_numbers".

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2]])
            0
            >>> scene.sign_method
            'winding_numbers'
        """
        if len(self) == 1 and self._pseudonormals(0) is not None:
            return PSEUDONORMALS
        return WINDING_NUMBERS

    def compute_closest_points(self, query_points: ArrayLike, nthreads: int = 0) -> dict[str, NDArray[Any]]:
        """Find the closest surface point of each query.

        Float64. Ties go to the lowest geometry, then triangle. Bitwise identical on every device. 80 B per query.

        Args:
            query_points: Shape (..., 3), float32 or float64.
            nthreads: Ignored. For compatibility with Open3D.

        Returns:
            Arrays in the leading shape of the queries. If there is no closest point (queries that are not finite or
            1.8e19 m away, empty scene): NaN, INVALID_ID or zeros.

            - points: (..., 3), float32, or float64 if the scene is far from zero.
            - geometry_ids: uint32 (...), as returned by `add_triangles`.
            - primitive_ids: uint32 (...), triangle index in its mesh.
            - primitive_uvs: float32 (..., 2), weights of the second and third corner.
            - primitive_normals: float32 (..., 3), unit normal by the right-hand rule; (0, 0, 1) without area.

        Raises:
            TypeError, ValueError: If the queries are not numeric or have another shape.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            0
            >>> found = scene.compute_closest_points([[0.25, 0.5, 2], [-3, 0, 0]])
            >>> found["points"].tolist(), found["primitive_ids"].tolist()
            ([[0.25, 0.5, 0.0], [0.0, 0.0, 0.0]], [0, 0])
        """
        queries, shape, form = self._device_queries(query_points, nthreads)
        nearest, closest = self._find_nearest(queries), ClosestPoints(queries)
        poses = self._stored_poses()
        for number in range(len(self)):
            there = self._seen_from(number, queries)
            describe(there, self._trees[self._mesh_of[number]], nearest, number, poses[number], closest)
        points = add_origin(closest.points, self._origin) if self._origin.any() else closest.points
        arrays = {"points": points, "geometry_ids": nearest.meshes, "primitive_ids": nearest.triangles}
        arrays |= {"primitive_uvs": closest.uvs, "primitive_normals": closest.normals}
        return form.hand_out_all(arrays, dict.fromkeys(("geometry_ids", "primitive_ids"), np.uint32), shape=shape)

    def compute_distance(self, query_points: ArrayLike, nthreads: int = 0) -> NDArray[np.float32]:
        """Distance of each query to the surface.

        Args:
            query_points: Shape (..., 3), float32 or float64.
            nthreads: Ignored. For compatibility with Open3D.

        Returns:
            Distances [m], float32 (...): infinite in an empty scene or beyond 1.8e19 m, NaN for queries that are not
            finite. Measured in float64, bitwise identical on every device. 24 B per query.

        Raises:
            TypeError, ValueError: If the queries are not numeric or have another shape.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> scene.add_triangles([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
            0
            >>> scene.compute_distance([[[0.2, 0.2, 2], [4, 0, 4]]]).tolist()
            [[2.0, 5.0]]
        """
        queries, shape, form = self._device_queries(query_points, nthreads)
        outside = zeros(queries.size, float64, self._device)
        return form.hand_out(sign_distances(queries, self._find_nearest(queries).sqdists, outside), shape=shape)

    def compute_signed_distance(
        self, query_points: ArrayLike, nthreads: int = 0, nsamples: int = 1
    ) -> NDArray[np.float32]:
        """Signed distance of each query to the surface: negative inside, positive outside.

        The sign follows `sign_method` (Open3D counts intersections of a ray). Its data is built at the first call.

        Args:
            query_points: Shape (..., 3), float32 or float64.
            nthreads, nsamples: Without effect, for compatibility with Open3D; `nsamples` must be odd.

        Returns:
            Distances [m], float32 (...): infinite in an empty scene or beyond 1.8e19 m, NaN for queries that are not
            finite. Bitwise identical on every device.

        Raises:
            TypeError, ValueError: If the queries are not numeric or have another shape, or `nsamples` is even.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
            >>> scene.add_triangles(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
            0
            >>> scene.compute_signed_distance([[0.5, 1, 1], [-3, 0, 0], [0, 1, 1]]).tolist(), scene.sign_method
            ([-0.5, 3.0, 0.0], 'pseudonormals')
        """
        distances, shape, form = self._signed_distances(query_points, nthreads, nsamples)
        return form.hand_out(distances, shape=shape)

    def compute_occupancy(self, query_points: ArrayLike, nthreads: int = 0, nsamples: int = 1) -> NDArray[np.float32]:
        """Test which queries are inside, as `compute_signed_distance`. The surface itself is inside.

        Args:
            query_points: Shape (..., 3), float32 or float64.
            nthreads, nsamples: Without effect, for compatibility with Open3D; `nsamples` must be odd.

        Returns:
            float32 (...): 1 inside, 0 outside, NaN for queries that are not finite.

        Raises:
            TypeError, ValueError: As `compute_signed_distance`.

        Example:
            >>> import pointloom as loom
            >>> scene = loom.RaycastingScene()
            >>> corners = [[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4]]
            >>> scene.add_triangles(corners, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
            0
            >>> scene.compute_occupancy([[1, 1, 1], [2, 2, 2]]).tolist()
            [1.0, 0.0]
        """
        distances, shape, form = self._signed_distances(query_points, nthreads, nsamples)
        return form.hand_out(mark_inside(distances), shape=shape)

    def _signed_distances(
        self, query_points: Any, nthreads: Any, nsamples: int
    ) -> tuple[wp.array, tuple[int, ...], Form]:
        """(distances on the device, leading shape, input form)."""
        samples = check_count("nsamples", nsamples)
        if samples % 2 == 0:
            raise ValueError(f"nsamples: expected an odd number, got {samples}")
        queries, shape, form = self._device_queries(query_points, nthreads)
        nearest = self._find_nearest(queries)
        sides = self._pseudonormals(0) if len(self) == 1 else None
        if sides is not None:
            numbers = find_sides(self._seen_from(0, queries), nearest, sides)
        else:
            numbers = self._winding_numbers(queries, nearest.order)
        return sign_distances(queries, nearest.sqdists, numbers), shape, form

    def _device_queries(self, query_points: ArrayLike, nthreads: int) -> tuple[wp.array, tuple[int, ...], Form]:
        """(queries about the scene's origin as vec3 (n,), leading shape, input form)."""
        check_count("nthreads", nthreads, minimum=0)
        form = form_of(query_points)
        if not form.on_host:
            return *take_positions("query_points", query_points, self._origin, self._device), form
        given = check_numeric("query_points", query_points)
        if given.ndim == 0 or given.shape[-1] != 3:
            raise ValueError(f"query_points: expected shape [..., 3], got {list(given.shape)}")
        flat, origin = given.reshape(-1, 3), self._origin
        if origin.any():
            flat = flat.astype(np.float64) - origin
        with quiet():  # float32 overflow is infinite and finds nothing
            flat = np.ascontiguousarray(flat, np.float32)
        return upload(flat, vec3, self._device, copied=False), given.shape[:-1], form

    def _seen_from(self, number: int, queries: wp.array) -> wp.array:
        back = inv(self._stored_poses()[number])
        if np.array_equal(back, np.eye(4)):
            return queries
        return transform_points(queries, back[:3, :3], back[:3, 3])

    def _find_nearest(self, queries: wp.array) -> NearestTriangles:
        nearest = NearestTriangles(queries)
        for number in range(len(self)):
            nearest.search(self._trees[self._mesh_of[number]], self._seen_from(number, queries), number)
        return nearest

    def _winding_numbers(self, queries: wp.array, order: Any) -> wp.array:
        numbers = zeros(queries.size, float64, self._device)
        for number, mesh in enumerate(self._mesh_of):
            if mesh not in self._dipoles:
                self._dipoles[mesh] = Dipoles(self._trees[mesh])
            add_winding_numbers(self._dipoles[mesh], self._seen_from(number, queries), order, numbers)
        return numbers

    def _pseudonormals(self, geometry: int) -> Pseudonormals | None:
        """Pseudonormals of a geometry. None if it is not a closed shell."""
        number = self._mesh_of[geometry]
        if number not in self._side_data:
            mesh = self._meshes[number]
            vertices, triangles = mesh.arrays["vertices"], mesh.arrays["triangles"]
            volume = volume_of_shell(vertices, triangles)  # sync
            if volume is not None and meet_anywhere(self._trees[number], vertices, triangles):
                volume = None
            self._side_data[number] = None if volume is None else Pseudonormals(vertices, triangles, volume)
        return self._side_data[number]
