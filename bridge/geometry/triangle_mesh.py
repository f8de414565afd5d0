"""TriangleMesh, changed in place as in Open3D: each method is that of `loom.TriangleMesh` with the same name."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ...meshing.mesh import mesh
from ..held import Rows, as_array, ours
from ..indices import indices_of
from ..seeds import next_seed
from ..vectors import DoubleVector, IntVector, Vector2dVector, Vector2iVector, Vector3dVector, Vector3iVector
from .enums import DeformAsRigidAsPossibleEnergy, FilterScope, SimplificationContraction
from .image import Image
from .point_cloud import PointCloud
from .triangle_normals import TriangleNormals

PARTS = ("vertex_normals", "vertex_colors", "triangle_uvs", "triangle_material_ids")  # and vertices and triangles


class TriangleMesh(TriangleNormals):
    """Vertices and triangles: vectors that are assigned, and written to by `np.asarray`.

    Methods that say so change the mesh, the others return a new one.
    """

    _kind = mesh.TriangleMesh
    _has_adjacency = False

    triangles = Rows(Vector3iVector)
    triangle_uvs = Rows(Vector2dVector)
    triangle_material_ids = Rows(IntVector)

    def __init__(self, vertices: Any = (), triangles: Any = ()):
        given = ours(vertices)
        self._held, self._out = given if isinstance(given, self._kind) else mesh.TriangleMesh(), {}
        if isinstance(vertices, TriangleMesh):
            vars(self).update(vars(vertices.__copy__()))
        elif given is not self._held:
            self.vertices, self.triangles = Vector3dVector(vertices), Vector3iVector(triangles)

    def __copy__(self) -> Self:
        made = super().__copy__()
        made._faces, made._has_adjacency = self._faces, self._has_adjacency
        return made

    def __getstate__(self) -> dict[str, Any]:
        state = super().__getstate__()
        return state | {"faces": True if self._faces is state["ours"] else self._faces}

    def __setstate__(self, state: dict[str, Any]) -> None:
        super().__setstate__(state)
        self._faces = self._held if state["faces"] is True else state["faces"]

    def _read(self, name: str) -> NDArray[Any]:
        found = self._face_rows() if name == "triangle_normals" else getattr(self._held, name)
        kind = getattr(type(self), name).kind
        return np.zeros((0, *kind._row), kind._dtype) if found is None else found

    def _token(self, ours: Any, name: str) -> tuple[Any, ...] | None:
        arrays = ours._device_arrays
        if name == "triangle_normals":  # TriangleNormals fills that vector
            return ()
        if name not in arrays:
            return None
        return arrays[name], ours.origin.tobytes() if name == "vertices" else b""

    def _made(self, changed: list[str]) -> Any:
        if "triangle_normals" in changed:
            self._faces = np.array(self.triangle_normals) if self._count("triangle_normals") else None
        held, is_moved = self._held, bool({"vertices", "triangles"} & set(changed))
        counts = {name: self._count(name) for name in ("vertices", "triangles")}
        if counts["vertices"] != len(held.vertices) or counts["triangles"] != len(held):
            for name in ("vertices", "triangles", *PARTS):
                self._vector(name)  # of the old mesh
            changed = [*PARTS]
            made = mesh.TriangleMesh(
                *map(np.array, (self.vertices, self.triangles)), textures=held.textures, device=held.device
            )
        else:
            made = held.copy()
            for name in ("vertices", "triangles"):
                if name in changed:
                    setattr(made, name, np.array(self._vector(name)))
        lengths: dict[str, int] = dict(
            zip(PARTS, (*[counts["vertices"]] * 2, 3 * counts["triangles"], counts["triangles"]), strict=True)
        )
        for name in (name for name in PARTS if name in changed):
            if self._count(name) == lengths[name] > 0:
                setattr(made, name, np.asarray(self._vector(name)))
            elif name in made._device_arrays:
                made = made._with_arrays(**{name: None})
        if self._faces is held and not is_moved:
            self._faces = made
        return made

    def _rows(self, kind: str, name: str, indices: Any) -> NDArray[np.int64]:
        """Indices of vertices or of triangles."""
        count = self._count(kind)
        return indices_of(name, indices, count, f"mesh of {count} {kind}")

    def __repr__(self) -> str:
        return f"TriangleMesh with {self._count('vertices')} points and {self._count('triangles')} triangles."

    @property
    def textures(self) -> list[Image]:
        """Pictures, their lowest row first as in Open3D; a list to assign, changes in it do not count."""
        return [Image(np.flipud(texture)) for texture in self._held.textures]

    @textures.setter
    def textures(self, values: Any) -> None:
        made = self._ours.copy()
        made.textures = [np.flipud(as_array(value)) for value in values]
        self._become(made)

    @property
    def adjacency_list(self) -> list[set[int]]:
        """The neighbours of each vertex, once `compute_adjacency_list` was called."""
        if not self._has_adjacency:
            return []
        starts, neighbors = self._ours.compute_adjacency_list()
        return [set(part.tolist()) for part in np.split(neighbors, starts[1:-1])]

    def clear(self) -> Self:
        """Drop all that it holds."""
        self._has_adjacency = False
        return super().clear()._set_faces(None)

    def has_triangles(self) -> bool:
        """Whether there are vertices and triangles."""
        return self.has_vertices() and self._count("triangles") > 0

    def has_triangle_normals(self) -> bool:
        """Whether each triangle has a normal."""
        return 0 < self._count("triangles") == self._count("triangle_normals")

    def has_adjacency_list(self) -> bool:
        """Whether `compute_adjacency_list` was called."""
        return self._has_adjacency

    def has_triangle_uvs(self) -> bool:
        """Whether each corner has texture coordinates."""
        return 0 < 3 * self._count("triangles") == self._count("triangle_uvs")

    def has_triangle_material_ids(self) -> bool:
        """Whether each triangle has the number of its texture."""
        return 0 < self._count("triangles") == self._count("triangle_material_ids")

    def has_textures(self) -> bool:
        """Whether there are textures."""
        return len(self._held.textures) > 0

    # ---------------------------------------------------------------------------------------- that change the mesh

    def compute_adjacency_list(self) -> Self:
        """Fill `adjacency_list`."""
        self._has_adjacency = True
        return self

    def remove_degenerate_triangles(self) -> Self:
        """Drop triangles that name a vertex twice."""
        return self._keep(lambda mesh: mesh.remove_degenerate_triangles())

    def remove_duplicated_triangles(self) -> Self:
        """Keep one of equal triangles."""
        return self._keep(lambda mesh: mesh.remove_duplicated_triangles())

    def remove_duplicated_vertices(self) -> Self:
        """Keep one of equal vertices."""
        return self._become(self._ours.remove_duplicated_vertices())

    def remove_non_manifold_edges(self) -> Self:
        """Drop the smallest triangles at edges of more than two."""
        return self._keep(lambda mesh: mesh.remove_non_manifold_edges())

    def remove_unreferenced_vertices(self) -> Self:
        """Drop vertices without triangles."""
        return self._become(self._ours.remove_unreferenced_vertices())

    def merge_close_vertices(self, eps: float) -> Self:
        """Make one of vertices nearer than `eps`."""
        made = self._ours.merge_close_vertices(eps)
        return self._become(made)._set_faces(None if self._faces is None else made)

    def remove_triangles_by_index(self, triangle_indices: Any) -> None:
        """Drop triangles of these numbers."""
        rows = self._rows("triangles", "triangle_indices", triangle_indices)
        self._keep(lambda mesh: mesh.remove_triangles_by_index(rows))

    def remove_triangles_by_mask(self, triangle_mask: Any) -> None:
        """Drop the triangles that are marked."""
        self._keep(lambda mesh: mesh.remove_triangles_by_mask(np.asarray(triangle_mask, bool)))

    def remove_vertices_by_index(self, vertex_indices: Any) -> None:
        """Drop vertices of these numbers, and their triangles."""
        rows = self._rows("vertices", "vertex_indices", vertex_indices)
        self._keep(lambda mesh: mesh.remove_vertices_by_index(rows))

    def remove_vertices_by_mask(self, vertex_mask: Any) -> None:
        """Drop the vertices that are marked, and their triangles."""
        self._keep(lambda mesh: mesh.remove_vertices_by_mask(np.asarray(vertex_mask, bool)))

    def orient_triangles(self) -> bool:
        """Turn triangles alike; whether that can be done."""
        turned, is_orientable = self._ours.orient_triangles()
        self._become(turned)
        return is_orientable

    # ---------------------------------------------------------------------------------------- that give other meshes

    def select_by_index(self, indices: Any, cleanup: bool = True) -> TriangleMesh:
        """The vertices of these numbers, and the triangles between them."""
        rows = self._rows("vertices", "indices", indices)
        made, faces = self._selected(lambda mesh: mesh.select_by_index(rows, cleanup))
        return self._new(made, faces=faces)

    def crop(self, bounding_box: Any) -> TriangleMesh:
        """The vertices in a box, and the triangles between them."""
        made, faces = self._selected(lambda mesh: mesh.crop(ours(bounding_box)))
        return self._new(made, faces=faces)

    def subdivide_midpoint(self, number_of_iterations: int = 1) -> TriangleMesh:
        """Four triangles of each."""
        return self._recomputed(self._ours.subdivide_midpoint(number_of_iterations))

    def subdivide_loop(self, number_of_iterations: int = 1) -> TriangleMesh:
        """Four triangles of each, smoothed."""
        return self._recomputed(self._ours.subdivide_loop(number_of_iterations))

    def simplify_vertex_clustering(
        self, voxel_size: float, contraction: SimplificationContraction = SimplificationContraction.Average
    ) -> TriangleMesh:
        """One vertex a voxel."""
        return self._recomputed(self._ours.simplify_vertex_clustering(voxel_size, contraction.name.lower()))

    def simplify_quadric_decimation(
        self, target_number_of_triangles: int, maximum_error: float = np.inf, boundary_weight: float = 1.0
    ) -> TriangleMesh:
        """Fewer triangles, near the surface."""
        limits = target_number_of_triangles, maximum_error, boundary_weight
        return self._recomputed(self._ours.simplify_quadric_decimation(*limits))

    def filter_sharpen(
        self, number_of_iterations: int = 1, strength: float = 1, filter_scope: FilterScope = FilterScope.All
    ) -> TriangleMesh:
        """Details made stronger."""
        made = self._ours.filter_sharpen(number_of_iterations, strength, filter_scope.name.lower())
        return self._new(made)

    def filter_smooth_simple(
        self, number_of_iterations: int = 1, filter_scope: FilterScope = FilterScope.All
    ) -> TriangleMesh:
        """Each vertex the mean of itself and its neighbours."""
        made = self._ours.filter_smooth_simple(number_of_iterations, filter_scope.name.lower())
        return self._new(made)

    def filter_smooth_laplacian(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, filter_scope: FilterScope = FilterScope.All
    ) -> TriangleMesh:
        """Each vertex towards its neighbours."""
        made = self._ours.filter_smooth_laplacian(number_of_iterations, lambda_filter, filter_scope.name.lower())
        return self._new(made)

    def filter_smooth_taubin(
        self,
        number_of_iterations: int = 1,
        lambda_filter: float = 0.5,
        mu: float = -0.53,
        filter_scope: FilterScope = FilterScope.All,
    ) -> TriangleMesh:
        """As `filter_smooth_laplacian`, without shrinking."""
        made = self._ours.filter_smooth_taubin(number_of_iterations, lambda_filter, mu, filter_scope.name.lower())
        return self._new(made)

    def deform_as_rigid_as_possible(
        self,
        constraint_vertex_indices: Any,
        constraint_vertex_positions: Any,
        max_iter: int,
        energy: DeformAsRigidAsPossibleEnergy = DeformAsRigidAsPossibleEnergy.Spokes,
        smoothed_alpha: float = 0.01,
    ) -> TriangleMesh:
        """Some vertices moved to places, the others after them."""
        made = self._ours.deform_as_rigid_as_possible(
            np.asarray(constraint_vertex_indices),
            np.asarray(constraint_vertex_positions),
            max_iter,
            energy.name.lower(),
            smoothed_alpha,
        )
        return self._new(made)

    # ------------------------------------------------------------------------------------------------ that give clouds

    def sample_points_uniformly(self, number_of_points: int = 100, use_triangle_normal: bool = False) -> PointCloud:
        """Points on the surface, by `o3d.utility.random.seed`."""
        surface, is_own = self._sampled(use_triangle_normal)
        return PointCloud._of(surface.sample_points_uniformly(number_of_points, is_own, next_seed()))

    def sample_points_poisson_disk(
        self, number_of_points: int, init_factor: float = 5, pcl: Any = None, use_triangle_normal: bool = False
    ) -> PointCloud:
        """Points on the surface with room between them, by `o3d.utility.random.seed`."""
        given = None if pcl is None else ours(pcl, PointCloud, "pcl")
        surface, is_own = self._sampled(use_triangle_normal)
        made = surface.sample_points_poisson_disk(number_of_points, int(init_factor), given, is_own, next_seed())
        return PointCloud._of(made)

    # ------------------------------------------------------------------------------------------------ that answer

    def cluster_connected_triangles(self) -> tuple[IntVector, list[int], DoubleVector]:
        """The part of each triangle, and how many triangles and which area each part has."""
        labels, counts, areas = self._ours.cluster_connected_triangles()
        return IntVector(labels), counts.tolist(), DoubleVector(areas)

    def get_surface_area(self) -> float:
        """The area of all triangles."""
        return self._ours.get_surface_area()

    def get_volume(self) -> float:
        """The volume that a closed mesh holds."""
        return self._ours.get_volume()

    def euler_poincare_characteristic(self) -> int:
        """Vertices and triangles less edges; vertices without triangles count, as in Open3D."""
        mesh = self._ours
        unused = len(mesh.vertices) - len(np.unique(mesh.triangles))
        return mesh.euler_poincare_characteristic() + unused

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """Whether no edge has more than two triangles."""
        return self._ours.is_edge_manifold(allow_boundary_edges)

    def is_vertex_manifold(self) -> bool:
        """Whether the triangles at each vertex are one fan."""
        return self._ours.is_vertex_manifold()

    def is_orientable(self) -> bool:
        """Whether triangles can be turned alike."""
        return self._ours.is_orientable()

    def is_watertight(self) -> bool:
        """Whether each edge has two triangles."""
        return self._ours.is_watertight()

    def is_self_intersecting(self) -> bool:
        """Whether triangles cut each other."""
        return self._ours.is_self_intersecting()

    def is_intersecting(self, arg0: Any) -> bool:
        """Whether another mesh cuts this one."""
        return self._ours.is_intersecting(ours(arg0, TriangleMesh, "other"))

    def get_non_manifold_edges(self, allow_boundary_edges: bool = True) -> Vector2iVector:
        """Edges of more than two triangles."""
        return Vector2iVector(self._ours.get_non_manifold_edges(allow_boundary_edges))

    def get_non_manifold_vertices(self) -> IntVector:
        """Vertices whose triangles are not one fan."""
        return IntVector(self._ours.get_non_manifold_vertices())

    def get_self_intersecting_triangles(self) -> Vector2iVector:
        """Pairs of triangles that cut each other."""
        return Vector2iVector(self._ours.get_self_intersecting_triangles())
