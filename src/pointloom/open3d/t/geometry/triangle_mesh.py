"""TriangleMesh of tensors: each method is that of `loom.TriangleMesh` with the same name."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike

from ....core.checks import check_number
from ....kernels.meshes import mesh_measures
from ....meshing.mesh.value_transfer import with_attributes_of
from ....pcd.motion import map_about
from ... import geometry as legacy
from ...argument_types import DeviceLike, TensorLike, VectorLike
from ...core.dtype import Dtype, bool8, float32, int32, int64
from ...core.tensor import Tensor
from ...seeds import next_seed
from ...vectors import Vector, Vector2dVector, Vector3dVector, Vector3iVector
from .. import geometry
from .geometry import device_of
from .mesh_baking import BakedTextures
from .mesh_factories import MeshFactories
from .mesh_tensors import CPU, NativeMesh, cloud_of
from .metrics import Metric, MetricParameters, listed_metrics
from .tensor_map import TensorMap, count_of, wrap
from .tensors import host_of, new_tensor, values_of

OF_FACES = ("normals", "areas")  # computed triangle attributes


class TriangleMesh(MeshFactories, BakedTextures):
    """A mesh of tensors on one device. Some methods change the mesh, others return a new one, as in Open3D."""

    @classmethod
    def from_legacy(
        cls, mesh_legacy: object, vertex_dtype: Dtype = float32, triangle_dtype: Dtype = int64, device: DeviceLike = CPU
    ) -> Self:
        """Copy a mesh of `o3d.geometry`. Its first texture becomes the texture map "albedo" of the material."""
        if not isinstance(mesh_legacy, legacy.TriangleMesh):
            raise TypeError(f"mesh_legacy: expected an o3d.geometry.TriangleMesh, got {type(mesh_legacy).__name__}")
        made, where = cls(device=device), device_of(device)

        def put(part: TensorMap, name: str, vector: Vector, dtype: Dtype, shape: tuple[int, ...] = (-1, 3)) -> None:
            if len(vector):
                part[name] = Tensor(np.asarray(vector).reshape(shape), dtype, where)

        put(made.vertex, "positions", mesh_legacy.vertices, vertex_dtype)
        put(made.vertex, "normals", mesh_legacy.vertex_normals, vertex_dtype)
        put(made.vertex, "colors", mesh_legacy.vertex_colors, vertex_dtype)
        put(made.triangle, "indices", mesh_legacy.triangles, triangle_dtype)
        put(made.triangle, "normals", mesh_legacy.triangle_normals, vertex_dtype)
        put(made.triangle, "texture_uvs", mesh_legacy.triangle_uvs, vertex_dtype, (-1, 3, 2))
        textures = mesh_legacy.native.textures
        made.set_texture(textures[0] if textures else None)
        return made

    def to_legacy(self) -> Any:
        """Copy as a mesh of `o3d.geometry`. Its colors are in 0..1. Attributes without equivalent are dropped."""
        made = legacy.TriangleMesh()
        for part, name, target, kind in (
            (self.vertex, "positions", "vertices", Vector3dVector),
            (self.triangle, "indices", "triangles", Vector3iVector),
            (self.vertex, "normals", "vertex_normals", Vector3dVector),
            (self.vertex, "colors", "vertex_colors", Vector3dVector),
            (self.triangle, "normals", "triangle_normals", Vector3dVector),
            (self.triangle, "texture_uvs", "triangle_uvs", Vector2dVector),
        ):
            if name in part:
                values = part[name].numpy().reshape(-1, 2 if kind is Vector2dVector else 3)
                setattr(made, target, kind(values / 255 if values.dtype == np.uint8 else values))
        if self.texture is not None and "texture_uvs" in self.triangle:
            made.textures = [legacy.Image(np.flipud(self.texture))]
        return made

    def transform(self, transformation: TensorLike) -> Self:
        """Apply a 4x4 matrix. Normals stay perpendicular to the surface and keep their lengths."""
        T = np.array(host_of(transformation), np.float64)
        self._cloud().transform(T)
        if "normals" in self.triangle:
            T[:3, 3], T[3] = 0, (0, 0, 0, 1)
            normals = self.triangle["normals"]
            geometry.PointCloud({"positions": normals.clone(), "normals": normals}).transform(T)
        return self

    def translate(self, translation: TensorLike, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        self._cloud().translate(translation, relative)
        return self

    def scale(self, scale: float, center: TensorLike) -> Self:
        self._cloud().scale(scale, center)
        return self

    def rotate(self, R: TensorLike, center: TensorLike) -> Self:
        return self.transform(map_about(*(np.asarray(host_of(value), np.float64) for value in (R, center))))

    def get_min_bound(self) -> Tensor:
        return self._cloud().get_min_bound()

    def get_max_bound(self) -> Tensor:
        return self._cloud().get_max_bound()

    def get_center(self) -> Tensor:
        """Mean of the vertices."""
        return self._cloud().get_center()

    def get_axis_aligned_bounding_box(self) -> Any:
        return self._cloud().get_axis_aligned_bounding_box()

    def get_oriented_bounding_box(self) -> Any:
        """The smallest box."""
        return self._cloud().get_oriented_bounding_box()

    def _cloud(self) -> Any:
        """A cloud that shares the positions and normals of the vertices."""
        shared = {name: tensor for name, tensor in self.vertex.items() if name in ("positions", "normals")}
        return geometry.PointCloud(shared)

    def get_surface_area(self) -> float:
        return self.surface.get_surface_area()

    def get_non_manifold_edges(self, allow_boundary_edges: bool = True) -> Tensor:
        edges = self.surface.get_non_manifold_edges(allow_boundary_edges)
        return new_tensor(edges, self.triangle["indices"].dtype.numpy)

    def compute_vertex_normals(self, normalized: bool = True) -> Self:
        """Set vertex normals (sums of area vectors) and triangle normals. Unit length unless `normalized=False`."""
        if self.is_empty():
            return self
        native = self.surface
        if not normalized:
            made = legacy.TriangleMesh.from_native(native).compute_vertex_normals(False)
            self.vertex["normals"] = self._floats(made.vertex_normals)
            self.triangle["normals"] = self._floats(made.triangle_normals)
            return self
        self.vertex["normals"] = new_tensor(
            native.compute_vertex_normals().arrays["vertex_normals"], self._float_dtype.numpy
        )
        return self.compute_triangle_normals()

    def compute_triangle_normals(self, normalized: bool = True) -> Self:
        """Set triangle normals of length 1, or of twice the area."""
        if self.is_empty():
            return self
        native = self.surface
        if normalized:
            normals = mesh_measures.triangle_normals(native.arrays["vertices"], native.arrays["triangles"])
            self.triangle["normals"] = new_tensor(normals, self._float_dtype.numpy, (len(native), 3))
        else:
            made = legacy.TriangleMesh.from_native(native).compute_triangle_normals(False)
            self.triangle["normals"] = self._floats(made.triangle_normals)
        return self

    def compute_triangle_areas(self) -> Self:
        """Set the triangle attribute `areas`."""
        if not self.is_empty():
            self.triangle["areas"] = new_tensor(self.surface.compute_triangle_areas(), self._float_dtype.numpy)
        return self

    def normalize_normals(self) -> Self:
        for part in (self.vertex, self.triangle):
            if "normals" in part:
                normals = part["normals"]
                made = _as_normals(normals).normalize_normals().arrays["vertex_normals"]
                part["normals"] = new_tensor(made, normals.dtype.numpy, tuple(normals.shape))
        return self

    def remove_unreferenced_vertices(self) -> Self:
        return self.set_native(self.native.remove_unreferenced_vertices())

    def remove_non_manifold_edges(self) -> Self:
        """Remove the smallest triangles at edges with more than two."""
        return self.set_native(self.native.remove_non_manifold_edges())

    def compute_uvatlas(
        self,
        size: int = 512,
        gutter: float = 1.0,
        max_stretch: float = 1 / 6,
        parallel_partitions: int = 1,
        nthreads: int = 0,
    ) -> None:
        """Set texture coordinates by xatlas. `max_stretch` and the counts have no effect. Returns nothing."""
        self.set_native(self.native.compute_uvatlas(size, gutter))

    def project_images_to_albedo(
        self,
        images: Iterable[Any],
        intrinsic_matrices: Iterable[Any],
        extrinsic_matrices: Iterable[Any],
        tex_size: int = 1024,
        update_material: bool = True,
    ) -> Any:
        """Image of the texture from posed images, uint8 (tex_size, tex_size, 3), also set in the material."""
        made = self.native.project_images_to_albedo(
            [host_of(image.as_tensor()) for image in images],
            [*map(host_of, intrinsic_matrices)],
            [*map(host_of, extrinsic_matrices)],
            tex_size,
        )
        if update_material:
            self.set_texture(made.textures[0])
        return geometry.Image(Tensor(made.textures[0]))

    def boolean_union(self, mesh: TriangleMesh, tolerance: float = 1e-6) -> Self:
        """Union of two closed meshes. `tolerance` has no effect."""
        return self._new(self.native.boolean_union(_mesh("mesh", mesh)))

    def boolean_intersection(self, mesh: TriangleMesh, tolerance: float = 1e-6) -> Self:
        return self._new(self.native.boolean_intersection(_mesh("mesh", mesh)))

    def boolean_difference(self, mesh: TriangleMesh, tolerance: float = 1e-6) -> Self:
        return self._new(self.native.boolean_difference(_mesh("mesh", mesh)))

    def clip_plane(self, point: TensorLike, normal: TensorLike) -> Self:
        """Part on the side of the normal."""
        return self._new(self._without("areas").clip_plane(host_of(point), host_of(normal)))

    def slice_plane(self, point: TensorLike, normal: TensorLike, contour_values: ArrayLike = (0.0,)) -> Any:
        """Sections with parallel planes as a LineSet, whose points have interpolated vertex attributes."""
        source = self.surface
        lines = source.slice_plane(host_of(point), host_of(normal), contour_values)
        given = {name: tensor for name, tensor in self.vertex.items() if name != "positions"}
        for name, tensor in given.items():
            source.vertex_attributes[name] = host_of(tensor).reshape(len(source.vertices), -1).astype(np.float64)
        cut = with_attributes_of(NativeMesh(lines.points, device=source.device, origin=source.origin), source)
        ends = Tensor(lines.lines, int64, self.device)
        made = geometry.LineSet(Tensor(lines.points, self._float_dtype, self.device), ends)
        for name, tensor in given.items():
            values = cut.vertex_attributes[name] if len(lines.points) else np.zeros(0)
            values = values if tensor.dtype.numpy.kind == "f" else np.rint(values)
            made.point[name] = Tensor(values.reshape(-1, *tensor.shape[1:]), tensor.dtype, self.device)
        return made

    def fill_holes(self, hole_size: float = 1e6) -> Self:
        return self._new(self._without(*OF_FACES).fill_holes(hole_size))

    def simplify_quadric_decimation(self, target_reduction: float, preserve_volume: bool = True) -> Self:
        """Remove a fraction of the triangles. `preserve_volume` has no effect."""
        reduction = check_number("target_reduction", target_reduction)
        if not 0 <= reduction < 1:
            raise ValueError(f"target_reduction: expected a fraction from 0 to less than 1, got {reduction}")
        native = self._without(*OF_FACES)
        return self._new(native.simplify_quadric_decimation(max(1, round((1 - reduction) * len(native)))))

    def extrude_linear(self, vector: TensorLike, scale: float = 1.0, capping: bool = True) -> Self:
        return self._new(self._without(*OF_FACES).extrude_linear(host_of(vector), scale, capping))

    def extrude_rotation(
        self, angle: float, axis: TensorLike, resolution: int = 16, translation: float = 0.0, capping: bool = True
    ) -> Self:
        """Sweep by a rotation [degrees] about an axis through the origin."""
        return self._new(
            self._without(*OF_FACES).extrude_rotation(angle, host_of(axis), resolution, translation, capping)
        )

    def select_by_index(self, indices: TensorLike, copy_attributes: bool = True) -> Self:
        """Vertices by index, in the order of the mesh, and the triangles between them.

        Indices out of range are ignored, as in Open3D.
        """
        rows = np.asarray(host_of(indices))
        if rows.ndim != 1 or (rows.size and rows.dtype.kind not in "iu"):
            raise RuntimeError(f"indices: expected integers of shape [k], got {rows.dtype} of {list(rows.shape)}")
        native = self.native if copy_attributes else self.surface
        rows = np.unique(rows.astype(np.int64))
        return self._new(native.select_by_index(rows[(rows >= 0) & (rows < count_of(self.vertex))], cleanup=False))

    def select_faces_by_mask(self, mask: TensorLike) -> Self:
        """Triangles by a boolean mask (t,), with their vertices."""
        given, count = mask if isinstance(mask, Tensor) else Tensor(mask), count_of(self.triangle)
        if given.dtype != bool8 or tuple(given.shape) != (count,):
            raise RuntimeError(f"mask: expected booleans of shape [{count}], got {given.dtype} of {list(given.shape)}")
        return self._new(self.native.select_faces_by_mask(values_of(given)))

    def compute_convex_hull(self, joggle_inputs: bool = False) -> Self:
        """Hull of the vertices. Its vertex attribute `point_indices` has their indices in this mesh."""
        hull, rows = self.surface.compute_convex_hull(joggle_inputs)
        made = self._new(hull)
        made.vertex["point_indices"] = Tensor(host_of(wrap(rows)), int32, self.device)
        return made

    def sample_points_uniformly(self, number_of_points: int, use_triangle_normal: bool = False) -> Any:
        """Random points on the surface, seeded by `o3d.utility.random.seed`."""
        made = self.textured().sample_points_uniformly(number_of_points, use_triangle_normal, next_seed())
        return cloud_of(made, self._float_dtype)

    def compute_metrics(self, mesh2: TriangleMesh, metrics: Iterable[Metric], params: MetricParameters) -> Tensor:
        """Compare two surfaces. The Hausdorff distance is that of the surfaces, not of samples."""
        options = params.fscore_radius, params.n_sampled_points
        measured = self.surface.compute_metrics(_mesh("mesh2", mesh2), *options, seed=next_seed())
        return Tensor(listed_metrics(measured, metrics), device=self.device)

    def _without(self, *names: str) -> Any:
        """The mesh without triangle attributes that an operation makes invalid."""
        native = self.native
        for name in names:
            native.triangle_attributes.pop(name, None)
        return native

    @property
    def _float_dtype(self) -> Dtype:
        """Type of positions, if floating."""
        dtype = self.vertex["positions"].dtype if "positions" in self.vertex else float32
        return dtype if dtype.numpy.kind == "f" else float32

    def _floats(self, values: VectorLike) -> Tensor:
        return Tensor(np.asarray(values), self._float_dtype, self.device)


def _as_normals(normals: Tensor) -> Any:
    """A mesh with these vectors as normals, for operations on normals."""
    return NativeMesh(values_of(normals), vertex_normals=values_of(normals))


def _mesh(name: str, value: object) -> Any:
    if not isinstance(value, TriangleMesh):
        given = type(value).__name__
        raise TypeError(f"{name}: expected an o3d.t.geometry.TriangleMesh, got {given}; from_legacy converts one")
    return value.native
