"""TriangleMesh, changed in place as in Open3D: each method is that of `loom.TriangleMesh` with the same name."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_number
from ...core.joined_parts import MissingPartsWarning
from ...core.units import without_warnings
from ...kernels.linear_algebra import inv, matmul
from ...meshing.mesh import mesh
from .. import geometry
from ..argument_types import BoxLike, CloudLike, ImageLike, IndicesLike, VectorLike
from ..indices import indices_of
from ..seeds import next_seed
from ..vectors import DoubleVector, IntVector, Vector2dVector, Vector2iVector, Vector3dVector, Vector3iVector
from ..wrapper import Forwarded, Rows, as_array, column, unwrap
from .alpha_shapes import alpha_faces
from .bounded import BoundedByBoxes
from .enums import DeformAsRigidAsPossibleEnergy, FilterScope, SimplificationContraction
from .image import Image
from .point_cloud import PointCloud


class MeshBase(BoundedByBoxes):
    vertices = Rows(Vector3dVector)
    vertex_normals = Rows(Vector3dVector)
    vertex_colors = Rows(Vector3dVector)

    def has_vertices(self) -> bool:
        return self._count("vertices") > 0

    def has_vertex_normals(self) -> bool:
        return 0 < self._count("vertices") == self._count("vertex_normals")

    def has_vertex_colors(self) -> bool:
        return 0 < self._count("vertices") == self._count("vertex_colors")

    def is_empty(self) -> bool:
        return not self.has_vertices()

    def paint_uniform_color(self, color: ArrayLike) -> Self:
        return self._become(self.native.paint_uniform_color(column("color", color)))

    def normalize_normals(self) -> Self:
        return self._become(self.native.normalize_normals())

    def compute_convex_hull(self) -> tuple[Any, list[int]]:
        """Mesh of the hull, and the indices of its vertices."""
        hull, rows = self.native.compute_convex_hull()
        return geometry.TriangleMesh.from_native(hull), rows.tolist()


NativeMesh = mesh.TriangleMesh


class MeshFactories(MeshBase):
    triangles = Rows(Vector3iVector)

    create_box = Forwarded(NativeMesh.create_box)
    create_tetrahedron = Forwarded(NativeMesh.create_tetrahedron)
    create_octahedron = Forwarded(NativeMesh.create_octahedron)
    create_icosahedron = Forwarded(NativeMesh.create_icosahedron)
    create_sphere = Forwarded(NativeMesh.create_sphere)
    create_ellipsoid = Forwarded(NativeMesh.create_ellipsoid)
    create_cylinder = Forwarded(NativeMesh.create_cylinder)
    create_cone = Forwarded(NativeMesh.create_cone)
    create_torus = Forwarded(NativeMesh.create_torus)
    create_arrow = Forwarded(NativeMesh.create_arrow)
    create_mobius = Forwarded(NativeMesh.create_mobius)

    @classmethod
    def create_coordinate_frame(cls, size: float = 1.0, origin: ArrayLike = (0.0, 0.0, 0.0)) -> Self:
        """Arrows along x (red), y (green) and z (blue), with triangle normals."""
        made: Any = cls.from_native(NativeMesh.create_coordinate_frame(size, column("origin", origin)))
        return made.compute_triangle_normals()

    @classmethod
    def create_from_oriented_bounding_box(
        cls, obox: BoxLike, scale: ArrayLike = (1.0, 1.0, 1.0), create_uv_map: bool = False
    ) -> Self:
        """A mesh of a box, scaled per axis."""
        box = unwrap(obox)
        extent = box.extent * np.asarray(scale, np.float64)
        width, height, depth = extent.tolist()
        made = NativeMesh.create_box(width, height, depth, create_uv_map).translate(-extent / 2)
        return cls.from_native(made.rotate(box.R, [0, 0, 0]).translate(box.center))

    @classmethod
    def create_from_point_cloud_alpha_shape(
        cls, pcd: CloudLike, alpha: float, tetra_mesh: Any = None, pt_map: Any = None
    ) -> Self:
        """Alpha shape of a cloud, or of given tetrahedra.

        `pt_map` lists the points whose normals and colors their vertices get.
        """
        if tetra_mesh is None:
            return cls.from_native(
                NativeMesh.create_from_point_cloud_alpha_shape(unwrap(pcd, PointCloud, "pcd"), alpha)
            )
        vertices = np.array(tetra_mesh.vertices)
        rows, triangles = alpha_faces(vertices, np.array(tetra_mesh.tetras), check_number("alpha", alpha))
        made = cls.from_native(NativeMesh())
        made.vertices, made.triangles = Vector3dVector(vertices[rows]), Vector3iVector(triangles)
        for name in ("normals", "colors"):
            if pt_map is not None and getattr(pcd, f"has_{name}")():
                points = indices_of("pt_map", pt_map, len(pcd.points), f"cloud of {len(pcd.points)} points")
                setattr(made, f"vertex_{name}", Vector3dVector(np.array(getattr(pcd, name))[points[rows]]))
        return made

    @classmethod
    def create_from_point_cloud_ball_pivoting(cls, pcd: CloudLike, radii: ArrayLike) -> Self:
        """Surface of balls that roll over the points, with triangle normals."""
        cloud = unwrap(pcd, PointCloud, "pcd")
        made: Any = cls.from_native(NativeMesh.create_from_point_cloud_ball_pivoting(cloud, np.asarray(radii)))
        vars(made)["_faces"] = made.native
        return made

    @classmethod
    def create_from_point_cloud_poisson(
        cls,
        pcd: CloudLike,
        depth: int = 8,
        width: float = 0,
        scale: float = 1.1,
        linear_fit: bool = False,
        n_threads: int = -1,
        full_depth: int = 5,
        samples_per_node: float = 1.5,
        point_weight: float = 2.0,
    ) -> tuple[Self, DoubleVector]:
        """Closed surface from normals, and a density per vertex. `width` > 0 replaces `depth`.

        `n_threads` and `full_depth` have no effect.
        """
        made, densities = NativeMesh.create_from_point_cloud_poisson(
            unwrap(pcd, PointCloud, "pcd"),
            8 if width > 0 else depth,
            width,
            scale,
            linear_fit,
            point_weight=point_weight,
            samples_per_node=samples_per_node,
        )
        return cls.from_native(made), DoubleVector(densities)


ROWS = "triangle normals of pointloom.open3d"  # attribute of triangles during a selection


class TriangleNormals(MeshFactories):
    """Triangle normals, computed or assigned and kept until computed again, as in Open3D.

    `_faces` is None without normals, a mesh for the unit normals of its triangles, or an array (t, 3). Computed normals
    follow the mesh until its arrays are written to.
    """

    _internal = ("face_rows",)

    _arrays: ClassVar = {"vertices": "points", "vertex_normals": "normals", "triangle_normals": "normals"}
    _faces: Any = None

    triangle_normals = Rows(Vector3dVector)

    def face_rows(self) -> NDArray[np.float64]:
        """Normals as an array, empty without normals."""
        if self._faces is None:
            return np.zeros((0, 3))
        return self._faces if isinstance(self._faces, np.ndarray) else self._faces.triangle_normals.astype(np.float64)

    def _follow(self, old: Any, new: Any) -> None:
        """Computed normals become those of the new triangles, assigned ones are kept."""
        if self._faces is not old:
            return
        arrays, others = old.arrays, new.arrays
        self._faces = new
        if any(arrays[name] is not others[name] for name in ("vertices", "triangles")):
            self._show_faces()

    def _set_faces(self, faces: Any) -> Self:
        self._faces = faces
        self._show_faces()
        return self

    def _show_faces(self) -> None:
        """Copy the normals into the borrowed vector."""
        out = self._shared.get("triangle_normals")
        if out is not None:
            out.vector.refill(self.face_rows())
            out.keep()

    def _moved(self, new: Any, A: NDArray[np.float64]) -> Self:
        """Replace the mesh by its image under a map with the 3x3 part A; assigned normals rotate with the surface."""
        self._become(new)
        if self._faces is None or self._faces is new:
            return self
        rows = self.face_rows()
        rotated = matmul(rows, inv(A))
        lengths = [np.linalg.norm(part, axis=1, keepdims=True) for part in (rows, rotated)]
        return self._set_faces(rotated * np.divide(lengths[0], lengths[1], where=lengths[1] > 0, out=lengths[1]))

    def _selected(self, operation: Callable[[Any], Any]) -> tuple[Any, Any]:
        """The mesh that an operation makes by selecting triangles, and their normals."""
        current = self.native
        rows = self.face_rows()
        if self._faces is None or self._faces is current or len(rows) != len(current):
            made = operation(current)
            return made, made if self._faces is current else self._faces
        marked = current.copy()
        marked.triangle_attributes[ROWS] = rows
        made = operation(marked)
        return made, made.triangle_attributes.pop(ROWS)

    def _keep(self, operation: Callable[[Any], Any]) -> Self:
        """Remove the triangles that an operation does not select."""
        made, faces = self._selected(operation)
        self._become(made)
        return self._set_faces(faces)

    def _sampled(self, use_triangle_normal: bool) -> tuple[Any, bool]:
        """A mesh for sampling, and whether the samples use computed triangle normals.

        Assigned normals are given to the corners of triangles that share no vertices.
        """
        current = self.native
        if use_triangle_normal and self._faces is None:
            self._set_faces(current)
        rows = self.face_rows() if use_triangle_normal and self._faces is not current else ()
        if not len(rows) or len(rows) != len(current):
            return current, use_triangle_normal
        corners, colors = current.triangles.reshape(-1), current.vertex_colors
        apart = type(current)(
            current.vertices[corners],
            np.arange(len(corners), dtype=np.int32).reshape(-1, 3),
            vertex_normals=np.repeat(rows, 3, axis=0),
            vertex_colors=None if colors is None else colors[corners],
            device=current.device,
            origin=current.origin,
        )
        return apart, False

    def _new(self, made: Any, *, faces: Any = None) -> Any:
        other = type(self).from_native(made)
        vars(other)["_faces"] = faces
        return other

    def _recomputed(self, made: Any) -> Any:
        """Another mesh, with computed triangle normals if this one has normals."""
        return self._new(made, faces=None if self._faces is None else made)

    def _joined(self, other: object) -> tuple[Any, Any]:
        """Both meshes as one. Normals are kept if all triangles have them."""
        parts = [(self.native, self), (unwrap(other, type(self), "other"), other)]
        with without_warnings(MissingPartsWarning):  # as in Open3D
            made = parts[0][0] + parts[1][0]
        nonempty = [(mesh, getattr(part, "_faces", None), part) for mesh, part in parts if len(mesh)]
        if not nonempty or any(faces is None for _, faces, _ in nonempty):
            return made, None
        if all(faces is mesh for mesh, faces, _ in nonempty):
            return made, made
        return made, np.concatenate([part.face_rows() for _, _, part in nonempty])

    def __add__(self, other: object) -> Any:
        made, faces = self._joined(other)
        return self._new(made, faces=faces)

    def __iadd__(self, other: object) -> Self:
        made, faces = self._joined(other)
        self._become(made)
        return self._set_faces(faces)

    def compute_triangle_normals(self, normalized: bool = True) -> Self:
        """Compute triangle normals of length 1, or of twice the area.

        Vertex normals are scaled to unit length too if `normalized`, as in Open3D.
        """
        if not normalized:
            return self._set_faces(_area_vectors(self.native))
        if self.has_vertex_normals():
            self._become(self.native.normalize_normals())
        return self._set_faces(self.native)

    def compute_vertex_normals(self, normalized: bool = True) -> Self:
        """Compute vertex normals (sums of area vectors) and triangle normals. Unit length unless `normalized=False`."""
        current = self.native
        if normalized:
            self._become(current.compute_vertex_normals())
            return self._set_faces(self.native)
        areas = _area_vectors(current)
        sums = np.zeros((len(current.vertices), 3))
        np.add.at(sums, current.triangles.reshape(-1), np.repeat(areas, 3, axis=0))
        made = current.copy()
        made.vertex_normals = sums
        self._become(made)
        return self._set_faces(areas)

    def normalize_normals(self) -> Self:
        self._become(self.native.normalize_normals())
        if not isinstance(self._faces, np.ndarray):
            return self
        lengths = np.linalg.norm(self._faces, axis=1, keepdims=True)
        return self._set_faces(np.divide(self._faces, lengths, where=lengths > 0, out=self._faces.copy()))


def _area_vectors(mesh: NativeMesh) -> NDArray[np.float64]:
    """Triangle normals with a length of twice the area, shape (t, 3)."""
    corners = (mesh.vertices - mesh.origin)[mesh.triangles]
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])


PARTS = ("vertex_normals", "vertex_colors", "triangle_uvs", "triangle_material_ids")  # and vertices and triangles


class TriangleMesh(TriangleNormals):
    """Vertices and triangles as vectors that can be assigned and written to by `np.asarray`.

    Some methods change the mesh, others return a new one, as in Open3D.
    """

    _kind = mesh.TriangleMesh
    _has_adjacency = False

    triangle_uvs = Rows(Vector2dVector)
    triangle_material_ids = Rows(IntVector)

    def __init__(self, vertices: Any = (), triangles: VectorLike = ()):
        given = unwrap(vertices)
        if hasattr(given, "estimate_normals"):  # a cloud, which can be read as an array
            unwrap(vertices, TriangleMesh, "vertices")
        self._wrapped, self._shared = given if isinstance(given, self._kind) else mesh.TriangleMesh(), {}
        if isinstance(vertices, TriangleMesh):
            vars(self).update(vars(vertices.__copy__()))
        elif given is not self._wrapped:
            self.vertices, self.triangles = Vector3dVector(vertices), Vector3iVector(triangles)

    def __copy__(self) -> Self:
        made = super().__copy__()
        vars(made).update(_faces=self._faces, _has_adjacency=self._has_adjacency)
        return made

    def __getstate__(self) -> dict[str, Any]:
        state = super().__getstate__()
        return state | {"faces": True if self._faces is state["ours"] else self._faces}

    def __setstate__(self, state: dict[str, Any]) -> None:
        super().__setstate__(state)
        self._faces = self._wrapped if state["faces"] is True else state["faces"]

    def _read(self, name: str) -> NDArray[Any]:
        values = self.face_rows() if name == "triangle_normals" else getattr(self._wrapped, name)
        return np.asarray(getattr(type(self), name).kind()) if values is None else values

    def _token(self, native: Any, name: str) -> tuple[Any, ...] | None:
        arrays = native.arrays
        if name == "triangle_normals":  # TriangleNormals fills that vector
            return ()
        if name not in arrays:
            return None
        return arrays[name], native.origin.tobytes() if name == "vertices" else b""

    def _made(self, changed: list[str]) -> Any:
        if "triangle_normals" in changed:
            self._faces = np.array(self.triangle_normals) if self._count("triangle_normals") else None
        current, is_moved = self._wrapped, bool({"vertices", "triangles"} & set(changed))
        counts = {name: self._count(name) for name in ("vertices", "triangles")}
        if counts["vertices"] != len(current.vertices) or counts["triangles"] != len(current):
            for name in ("vertices", "triangles", *PARTS):
                self.vector(name)  # of the old mesh
            changed = [*PARTS]
            made = mesh.TriangleMesh(
                *map(np.array, (self.vertices, self.triangles)), textures=current.textures, device=current.device
            )
        else:
            made = current.copy()
            for name in ("vertices", "triangles"):
                if name in changed:
                    setattr(made, name, np.array(self.vector(name)))
        lengths: dict[str, int] = dict(
            zip(PARTS, (*[counts["vertices"]] * 2, 3 * counts["triangles"], counts["triangles"]), strict=True)
        )
        for name in (name for name in PARTS if name in changed):
            if self._count(name) == lengths[name] > 0:
                setattr(made, name, np.asarray(self.vector(name)))
            elif name in made.arrays:
                made = made.with_arrays(**{name: None})
        if self._faces is current and not is_moved:
            self._faces = made
        return made

    def _rows(self, kind: str, name: str, indices: IndicesLike) -> NDArray[np.int64]:
        count = self._count(kind)
        return indices_of(name, indices, count, f"mesh of {count} {kind}")

    def __repr__(self) -> str:
        return f"TriangleMesh with {self._count('vertices')} points and {self._count('triangles')} triangles."

    @property
    def textures(self) -> list[Image]:
        """Images, lowest row first as in Open3D. Assign a list, changes in the list have no effect."""
        return [Image(np.flipud(texture)) for texture in self._wrapped.textures]

    @textures.setter
    def textures(self, values: Iterable[ImageLike]) -> None:
        made = self.native.copy()
        made.textures = [np.flipud(as_array(value)) for value in values]
        self._become(made)

    @property
    def adjacency_list(self) -> list[set[int]]:
        """Neighbors of each vertex, after `compute_adjacency_list`."""
        if not self._has_adjacency:
            return []
        starts, neighbors = self.native.compute_adjacency_list()
        return [set(part.tolist()) for part in np.split(neighbors, starts[1:-1])]

    def clear(self) -> Self:
        self._has_adjacency = False
        super().clear()
        return self._set_faces(None)

    def has_triangles(self) -> bool:
        return self.has_vertices() and self._count("triangles") > 0

    def has_triangle_normals(self) -> bool:
        return 0 < self._count("triangles") == self._count("triangle_normals")

    def has_adjacency_list(self) -> bool:
        return self._has_adjacency

    def has_triangle_uvs(self) -> bool:
        return 0 < 3 * self._count("triangles") == self._count("triangle_uvs")

    def has_triangle_material_ids(self) -> bool:
        return 0 < self._count("triangles") == self._count("triangle_material_ids")

    def has_textures(self) -> bool:
        return len(self._wrapped.textures) > 0

    def compute_adjacency_list(self) -> Self:
        self._has_adjacency = True
        return self

    def remove_degenerate_triangles(self) -> Self:
        """Remove triangles with a repeated vertex."""
        return self._keep(lambda mesh: mesh.remove_degenerate_triangles())

    def remove_duplicated_triangles(self) -> Self:
        return self._keep(lambda mesh: mesh.remove_duplicated_triangles())

    def remove_duplicated_vertices(self) -> Self:
        return self._become(self.native.remove_duplicated_vertices())

    def remove_non_manifold_edges(self) -> Self:
        """Remove the smallest triangles at edges with more than two."""
        return self._keep(lambda mesh: mesh.remove_non_manifold_edges())

    def remove_unreferenced_vertices(self) -> Self:
        return self._become(self.native.remove_unreferenced_vertices())

    def merge_close_vertices(self, eps: float) -> Self:
        """Merge vertices closer than `eps`."""
        made = self.native.merge_close_vertices(eps)
        self._become(made)
        return self._set_faces(None if self._faces is None else made)

    def remove_triangles_by_index(self, triangle_indices: IndicesLike) -> None:
        rows = self._rows("triangles", "triangle_indices", triangle_indices)
        self._keep(lambda mesh: mesh.remove_triangles_by_index(rows))

    def remove_triangles_by_mask(self, triangle_mask: ArrayLike) -> None:
        self._keep(lambda mesh: mesh.remove_triangles_by_mask(np.asarray(triangle_mask, bool)))

    def remove_vertices_by_index(self, vertex_indices: IndicesLike) -> None:
        rows = self._rows("vertices", "vertex_indices", vertex_indices)
        self._keep(lambda mesh: mesh.remove_vertices_by_index(rows))

    def remove_vertices_by_mask(self, vertex_mask: ArrayLike) -> None:
        self._keep(lambda mesh: mesh.remove_vertices_by_mask(np.asarray(vertex_mask, bool)))

    def orient_triangles(self) -> bool:
        """Orient triangles consistently. Returns `is_orientable()`."""
        oriented, is_orientable = self.native.orient_triangles()
        self._become(oriented.with_arrays(vertex_normals=self.native.arrays.get("vertex_normals")))
        return is_orientable and self.is_edge_manifold()

    def select_by_index(self, indices: IndicesLike, cleanup: bool = True) -> TriangleMesh:
        rows = self._rows("vertices", "indices", indices)
        made, faces = self._selected(lambda mesh: mesh.select_by_index(rows, cleanup))
        return self._new(made, faces=faces)

    def crop(self, bounding_box: BoxLike) -> TriangleMesh:
        made, faces = self._selected(lambda mesh: mesh.crop(unwrap(bounding_box)))
        return self._new(made, faces=faces)

    def subdivide_midpoint(self, number_of_iterations: int = 1) -> TriangleMesh:
        return self._recomputed(self.native.subdivide_midpoint(number_of_iterations))

    def subdivide_loop(self, number_of_iterations: int = 1) -> TriangleMesh:
        return self._recomputed(self.native.subdivide_loop(number_of_iterations))

    def simplify_vertex_clustering(
        self, voxel_size: float, contraction: SimplificationContraction = SimplificationContraction.Average
    ) -> TriangleMesh:
        return self._recomputed(self.native.simplify_vertex_clustering(voxel_size, contraction.name.lower()))

    def simplify_quadric_decimation(
        self, target_number_of_triangles: int, maximum_error: float = np.inf, boundary_weight: float = 1.0
    ) -> TriangleMesh:
        limits = target_number_of_triangles, maximum_error, boundary_weight
        return self._recomputed(self.native.simplify_quadric_decimation(*limits))

    def filter_sharpen(
        self, number_of_iterations: int = 1, strength: float = 1, filter_scope: FilterScope = FilterScope.All
    ) -> TriangleMesh:
        return self._new(self.native.filter_sharpen(number_of_iterations, strength, filter_scope.name.lower()))

    def filter_smooth_simple(
        self, number_of_iterations: int = 1, filter_scope: FilterScope = FilterScope.All
    ) -> TriangleMesh:
        return self._new(self.native.filter_smooth_simple(number_of_iterations, filter_scope.name.lower()))

    def filter_smooth_laplacian(
        self, number_of_iterations: int = 1, lambda_filter: float = 0.5, filter_scope: FilterScope = FilterScope.All
    ) -> TriangleMesh:
        scope = filter_scope.name.lower()
        return self._new(self.native.filter_smooth_laplacian(number_of_iterations, lambda_filter, scope))

    def filter_smooth_taubin(
        self,
        number_of_iterations: int = 1,
        lambda_filter: float = 0.5,
        mu: float = -0.53,
        filter_scope: FilterScope = FilterScope.All,
    ) -> TriangleMesh:
        scope = filter_scope.name.lower()
        return self._new(self.native.filter_smooth_taubin(number_of_iterations, lambda_filter, mu, scope))

    def deform_as_rigid_as_possible(
        self,
        constraint_vertex_indices: ArrayLike,
        constraint_vertex_positions: ArrayLike,
        max_iter: int,
        energy: DeformAsRigidAsPossibleEnergy = DeformAsRigidAsPossibleEnergy.Spokes,
        smoothed_alpha: float = 0.01,
    ) -> TriangleMesh:
        made = self.native.deform_as_rigid_as_possible(
            np.asarray(constraint_vertex_indices),
            np.asarray(constraint_vertex_positions),
            max_iter,
            energy.name.lower(),
            smoothed_alpha,
        )
        return self._new(made)

    def sample_points_uniformly(self, number_of_points: int = 100, use_triangle_normal: bool = False) -> PointCloud:
        """Random points on the surface, seeded by `o3d.utility.random.seed`."""
        surface, is_own = self._sampled(use_triangle_normal)
        return PointCloud.from_native(surface.sample_points_uniformly(number_of_points, is_own, next_seed()))

    def sample_points_poisson_disk(
        self,
        number_of_points: int,
        init_factor: float = 5,
        pcl: CloudLike | None = None,
        use_triangle_normal: bool = False,
    ) -> PointCloud:
        """Random points on the surface with a minimum distance, seeded by `o3d.utility.random.seed`."""
        given = None if pcl is None else unwrap(pcl, PointCloud, "pcl")
        surface, is_own = self._sampled(use_triangle_normal)
        made = surface.sample_points_poisson_disk(number_of_points, int(init_factor), given, is_own, next_seed())
        return PointCloud.from_native(made)

    def cluster_connected_triangles(self) -> tuple[IntVector, list[int], DoubleVector]:
        """Cluster of each triangle, and number of triangles and area of each cluster."""
        labels, counts, areas = self.native.cluster_connected_triangles()
        return IntVector(labels), counts.tolist(), DoubleVector(areas)

    def get_surface_area(self) -> float:
        return self.native.get_surface_area()

    def get_volume(self) -> float:
        return self.native.get_volume()

    def euler_poincare_characteristic(self) -> int:
        """V - E + F. Unreferenced vertices count, as in Open3D."""
        mesh = self.native
        unused = len(mesh.vertices) - len(np.unique(mesh.triangles))
        return mesh.euler_poincare_characteristic() + unused

    def is_edge_manifold(self, allow_boundary_edges: bool = True) -> bool:
        """True if no edge has more than two triangles."""
        return self.native.is_edge_manifold(allow_boundary_edges)

    def is_vertex_manifold(self) -> bool:
        """True if the triangles at each vertex form one fan."""
        return self.native.is_vertex_manifold()

    def is_orientable(self) -> bool:
        """True if triangles that share an edge can all be oriented alike. False if an edge has more than two."""
        return self.is_edge_manifold() and self.native.is_orientable()

    def is_watertight(self) -> bool:
        """True if edges have two triangles, those of a vertex form one fan, and none intersect. True if empty."""
        return self.is_edge_manifold(False) and self.is_vertex_manifold() and not self.is_self_intersecting()

    def is_self_intersecting(self) -> bool:
        return self.native.is_self_intersecting()

    def is_intersecting(self, arg0: object) -> bool:
        return self.native.is_intersecting(unwrap(arg0, TriangleMesh, "other"))

    def get_non_manifold_edges(self, allow_boundary_edges: bool = True) -> Vector2iVector:
        """Edges with more than two triangles."""
        return Vector2iVector(self.native.get_non_manifold_edges(allow_boundary_edges))

    def get_non_manifold_vertices(self) -> IntVector:
        """Vertices whose triangles do not form one fan."""
        return IntVector(self.native.get_non_manifold_vertices())

    def get_self_intersecting_triangles(self) -> Vector2iVector:
        """Pairs of intersecting triangles."""
        return Vector2iVector(self.native.get_self_intersecting_triangles())
