"""PointCloud of tensors: each method is that of `loom.PointCloud`, on the device of the tensors."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Self

import numpy as np

from ....kernels.icp.color_gradients import estimate_color_gradients
from ....pcd import cloud
from ....pcd.metrics import compute_metrics
from ... import geometry as legacy
from ...argument_types import DeviceLike, TensorLike
from ...core.device import Device
from ...core.dtype import Dtype, float32, float64, int32, int64
from ...core.tensor import Tensor
from ...seeds import next_seed
from ...wrapper import IDENTITY_POSE
from .. import geometry
from . import depth_points
from .boundary import boundary_rows
from .geometry import CPU, device_of
from .image import Image
from .metrics import Metric, MetricParameters, listed_metrics
from .moved import MovedGeometry
from .native import attribute, columns_of, converted, mask_of, native_of, positions_of, rows_of, select
from .rgbd_image import RGBDImage
from .tensor_map import TensorMap, count_of, listed, matrix_of, tensor_of, wrap

UP_DIRECTION, ZERO_POINT = (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)
UNLIMITED_RADIUS = 1e18  # [m]


class PointCloud(MovedGeometry):
    """Points with any attributes as tensors: `cloud.point.positions` (n, 3), `cloud.point["intensity"]`.

    Selections keep all attributes. Motions and methods of normals and colors change the cloud, others return a new one.

    Args:
        device: Device of an empty cloud. Or positions (n, 3), tensors by name, or a cloud, which are shared.
        positions, map_keys_to_tensors: The same by keyword.
    """

    _parts, _fixed = ("point",), ("point",)

    point: TensorMap

    def __init__(self, device: Any = CPU, *, positions: object = None, map_keys_to_tensors: object = None):
        given = next((v for v in (positions, map_keys_to_tensors) if v is not None), device)
        if isinstance(given, PointCloud):
            vars(self).update(vars(given.__copy__()))
            return
        self.point = TensorMap("positions")
        if isinstance(given, Device | str):
            self._home = device_of(given)
            return
        tensors = given if isinstance(given, dict | TensorMap) else {"positions": given}
        if "positions" not in tensors:
            raise ValueError(f"map_keys_to_tensors: expected positions, got {[*tensors]}")
        for name, values in tensors.items():
            self.point[name] = values
        self._home = self.point.positions.device
        if self.point.positions.shape[1:] != (3,):
            raise ValueError(f"positions: expected shape [n, 3], got {list(self.point.positions.shape)}")

    @staticmethod
    def from_legacy(pcd_legacy: object, dtype: Dtype = float32, device: DeviceLike = CPU) -> PointCloud:
        """Positions, normals and colors of a `geometry.PointCloud`."""
        if not isinstance(pcd_legacy, legacy.PointCloud):
            raise TypeError(f"pcd_legacy: expected a geometry.PointCloud, got {type(pcd_legacy).__name__}")
        made, where = PointCloud(device_of(device)), device_of(device)
        for name, known in (("positions", "points"), ("colors", "colors"), ("normals", "normals")):
            values = np.asarray(getattr(pcd_legacy, known))
            if len(values):
                made.point[name] = Tensor(values, dtype, where)
        return made

    def to_legacy(self) -> Any:
        """A `geometry.PointCloud` with positions, normals and colors. Integer colors are scaled to 0..1."""
        made = legacy.PointCloud()
        if "positions" in self.point:
            made.points = self.point.positions.numpy().astype(np.float64)
        if "normals" in self.point:
            made.normals = self.point.normals.numpy().astype(np.float64)
        if "colors" in self.point:
            colors = self.point.colors.numpy()
            made.colors = colors / np.float64(np.iinfo(colors.dtype).max if colors.dtype.kind == "u" else 1)
        return made

    def append(self, other: PointCloud) -> PointCloud:
        """A cloud of both. The other one must have all attributes of this one."""
        missing = [name for name in self.point if name not in other.point]
        if missing:
            raise RuntimeError(
                f"other: expected the attributes {[*self.point]}, without {missing} got {[*other.point]}"
            )
        parts = {name: (tensor, other.point[name]) for name, tensor in self.point.items()}
        for name, (first, second) in parts.items():
            if first.dtype != second.dtype or first.shape[1:] != second.shape[1:]:
                raise RuntimeError(
                    f"{name}: expected {first.dtype} (n, {first.shape[1:]}), got {second.dtype} {second.shape}"
                )
        return PointCloud({name: first.append(second, 0) for name, (first, second) in parts.items()})

    def __add__(self, other: PointCloud) -> PointCloud:
        return self.append(other)

    def _selected(self, method: str, *args: Any) -> tuple[PointCloud, Tensor]:
        """The points that a method of a cloud keeps, with all attributes, and a mask of them."""
        made = PointCloud(self.device)
        vars(made)["point"], rows = select(self.point, method, *args)
        return made, mask_of(rows, count_of(self.point))

    def select_by_mask(self, boolean_mask: TensorLike, invert: bool = False) -> PointCloud:
        return self._selected("select_by_mask", tensor_of("boolean_mask", boolean_mask).array, invert)[0]

    def select_by_index(self, indices: TensorLike, invert: bool = False, remove_duplicates: bool = False) -> PointCloud:
        """The points at indices in their order with repeats. Inverted or without repeats: in the order of the cloud."""
        rows = tensor_of("indices", indices)
        if remove_duplicates and not invert:
            return self.select_by_mask(mask_of(rows, count_of(self.point)))
        return self._selected("select_by_index", rows.array, invert)[0]

    def crop(self, aabb: Any = None, invert: bool = False, *, obb: Any = None) -> PointCloud:
        """The points inside a box, faces included, or the others."""
        rows = (aabb if obb is None else obb).get_point_indices_within_bounding_box(self.point.positions)
        return self.select_by_index(rows, invert)

    def voxel_down_sample(self, voxel_size: float, reduction: str = "mean") -> PointCloud:
        """Mean of the points and attributes in each voxel of a grid through zero."""
        if reduction != "mean":
            raise ValueError(f"reduction: expected 'mean', got {reduction!r}")
        columns = {f"_{name}": columns_of(tensor, float64).array for name, tensor in self.point.items()}
        native = cloud.PointCloud(self.point.positions.array, **columns)
        made = PointCloud(self.device)
        vars(made)["point"] = rows_of(native.voxel_down_sample_and_trace(voxel_size, ZERO_POINT).cloud, self.point)
        return made

    def uniform_down_sample(self, every_k_points: int) -> PointCloud:
        return self._selected("uniform_down_sample", every_k_points)[0]

    def random_down_sample(self, sampling_ratio: float) -> PointCloud:
        """Random fraction of the points, seeded by `o3d.utility.random.seed`, in order."""
        return self._selected("random_down_sample", sampling_ratio, next_seed())[0]

    def farthest_point_down_sample(self, num_samples: int, start_index: int = 0) -> PointCloud:
        return self._selected("farthest_point_down_sample", num_samples, start_index)[0]

    def remove_radius_outliers(self, nb_points: int, search_radius: float) -> tuple[PointCloud, Tensor]:
        """The points with at least `nb_points` within the radius, counting themselves, and a mask of them."""
        if nb_points == 1:
            return self.remove_non_finite_points()
        return self._selected("remove_radius_outlier", nb_points - 1, search_radius)

    def remove_statistical_outliers(self, nb_neighbors: int, std_ratio: float) -> tuple[PointCloud, Tensor]:
        """The inlier cloud, and a mask of them."""
        return self._selected("remove_statistical_outlier", nb_neighbors, std_ratio)

    def remove_non_finite_points(
        self, remove_nan: bool = True, remove_infinite: bool = True
    ) -> tuple[PointCloud, Tensor]:
        """The remaining cloud, and a mask of its points."""
        return self._selected("remove_non_finite_points", remove_nan, remove_infinite)

    def remove_duplicated_points(self) -> tuple[PointCloud, Tensor]:
        """The first point at each float32 position, and a mask of them."""
        return self._selected("remove_duplicated_points")

    def paint_uniform_color(self, color: TensorLike) -> Self:
        """Set one color for all points. Floats are limited to 0..1."""
        rgb = tensor_of("color", color)
        values = matrix_of("color", rgb, (3,))
        if rgb.dtype in (float32, float64):
            values = values.clip(0, 1)
        self.point.colors = Tensor(np.tile(values, (count_of(self.point), 1)), rgb.dtype, self.device)
        return self

    def _set_normals(self, native: cloud.PointCloud) -> Self:
        self.point.normals = attribute(native, "normals", self.point.positions.dtype)
        return self

    def estimate_normals(self, max_nn: int | None = 30, radius: float | None = None) -> None:
        """Estimate normals, on the side of existing ones."""
        self._set_normals(native_of(self.point, "normals").estimate_normals(radius=radius, max_nn=max_nn))

    def normalize_normals(self) -> Self:
        return (
            self._set_normals(native_of(self.point, "normals").normalize_normals()) if "normals" in self.point else self
        )

    def orient_normals_to_align_with_direction(self, orientation_reference: TensorLike = UP_DIRECTION) -> None:
        direction = matrix_of("orientation_reference", orientation_reference, (3,))
        self._set_normals(native_of(self.point, "normals").orient_normals_to_align_with_direction(direction))

    def orient_normals_towards_camera_location(self, camera_location: TensorLike = ZERO_POINT) -> None:
        camera = matrix_of("camera_location", camera_location, (3,))
        self._set_normals(native_of(self.point, "normals").orient_normals_towards_camera_location(camera))

    def orient_normals_consistent_tangent_plane(
        self, k: int, lambda_penalty: float = 0.0, cos_alpha_tol: float = 1.0
    ) -> None:
        native = native_of(self.point, "normals")
        self._set_normals(native.orient_normals_consistent_tangent_plane(k, lambda_penalty, cos_alpha_tol))

    def estimate_color_gradients(self, max_nn: int | None = 30, radius: float | None = None) -> None:
        """Set `point.color_gradients`, the slope of the intensity in the tangent plane [1/m], unless it exists."""
        if "color_gradients" in self.point:
            return
        native = native_of(self.point, "normals", "colors")
        normals, colors = (native.arrays.required(name, f"assign point.{name}") for name in ("normals", "colors"))
        distance, count = UNLIMITED_RADIUS if radius is None else radius, len(native) if max_nn is None else max_nn
        _, gradients = estimate_color_gradients(native.search_tree(), normals, colors, distance, count)
        dtype = self.point.colors.dtype
        made = converted(wrap(native.arrays.hand_out(gradients)), dtype if dtype in (float32, float64) else float32)
        self.point["color_gradients"] = made

    def _smoothed(self, native: cloud.PointCloud) -> PointCloud:
        """A copy with the positions, and normals if there are, of a result."""
        made = self.clone()
        made.point.positions = positions_of(native, self.point.positions.dtype)
        if "normals" in self.point:
            made.point.normals = attribute(native, "normals", self.point.positions.dtype)
        return made

    def smooth_mls(self, radius: float = 0.05, max_nn: int = 30) -> PointCloud:
        return self._smoothed(native_of(self.point, "normals").smooth_mls(radius=radius, max_nn=max_nn))

    def smooth_bilateral(
        self, radius: float = 0.05, max_nn: int = 30, sigma_s: float = 0.05, sigma_r: float = 0.05
    ) -> PointCloud:
        native = native_of(self.point, "normals")
        return self._smoothed(native.smooth_bilateral(radius=radius, max_nn=max_nn, sigma_s=sigma_s, sigma_r=sigma_r))

    def smooth_laplacian(
        self, iterations: int = 10, lambda_: float = 0.5, max_nn: int = 20, use_fixed_neighborhoods: bool = False
    ) -> PointCloud:
        native = native_of(self.point, "normals")
        return self._smoothed(native.smooth_laplacian(iterations, lambda_, max_nn, use_fixed_neighborhoods))

    def smooth_taubin(
        self,
        iterations: int = 10,
        lambda_: float = 0.5,
        mu: float = -0.53,
        max_nn: int = 20,
        use_fixed_neighborhoods: bool = False,
    ) -> PointCloud:
        native = native_of(self.point, "normals")
        return self._smoothed(native.smooth_taubin(iterations, lambda_, mu, max_nn, use_fixed_neighborhoods))

    @staticmethod
    def create_from_depth_image(
        depth: Image,
        intrinsics: TensorLike,
        extrinsics: TensorLike = IDENTITY_POSE,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
        stride: int = 1,
        with_normals: bool = False,
    ) -> PointCloud:
        """Points of a depth image divided by `depth_scale`, float32; `extrinsics` is world to camera."""
        numbers = depth_scale, depth_max, stride, with_normals
        return PointCloud(depth_points.points_of_images(depth, None, intrinsics, extrinsics, *numbers))

    @staticmethod
    def create_from_rgbd_image(
        rgbd_image: RGBDImage,
        intrinsics: TensorLike,
        extrinsics: TensorLike = IDENTITY_POSE,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
        stride: int = 1,
        with_normals: bool = False,
    ) -> PointCloud:
        """Points with colors 0..1; arguments as of `create_from_depth_image`."""
        images, numbers = (rgbd_image.depth, rgbd_image.color), (depth_scale, depth_max, stride, with_normals)
        return PointCloud(depth_points.points_of_images(*images, intrinsics, extrinsics, *numbers))

    def project_to_depth_image(
        self,
        width: int,
        height: int,
        intrinsics: TensorLike,
        extrinsics: TensorLike = IDENTITY_POSE,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
    ) -> Image:
        """Depth of the nearest point in each pixel times `depth_scale`, float32."""
        native = native_of(self.point)
        return depth_points.project_depth(native, width, height, intrinsics, extrinsics, depth_scale, depth_max)

    def project_to_rgbd_image(
        self,
        width: int,
        height: int,
        intrinsics: TensorLike,
        extrinsics: TensorLike = IDENTITY_POSE,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
    ) -> RGBDImage:
        """Color 0..1, rounded to bytes, and depth as of `project_to_depth_image`."""
        native = native_of(self.point, "colors")
        return depth_points.project_rgbd(native, width, height, intrinsics, extrinsics, depth_scale, depth_max)

    def hidden_point_removal(self, camera_location: TensorLike, radius: float) -> tuple[Any, Tensor]:
        """Mesh of the points visible from a camera, and their indices, int64."""
        camera = matrix_of("camera_location", camera_location, (3,))
        surface, rows = native_of(self.point).hidden_point_removal(camera, radius)
        positions = Tensor(surface.vertices, self.point.positions.dtype, self.device)
        mesh = geometry.TriangleMesh(positions, Tensor(surface.triangles, int64, self.device))
        return mesh, converted(wrap(rows), int64)

    def compute_convex_hull(self, joggle_inputs: bool = False) -> Any:
        """Mesh of the hull in float64, with `vertex["point_indices"]`."""
        hull, rows = native_of(self.point).compute_convex_hull(joggle_inputs)
        mesh = geometry.TriangleMesh(
            Tensor(hull.vertices, device=self.device), Tensor(hull.triangles, int32, self.device)
        )
        mesh.vertex["point_indices"] = converted(wrap(rows), int32)
        return mesh

    def cluster_dbscan(self, eps: float, min_points: int, print_progress: bool = False) -> Tensor:
        """A label per point, -1 for noise, int32."""
        return wrap(native_of(self.point).cluster_dbscan(eps, min_points, print_progress))

    def segment_plane(
        self, distance_threshold: float = 0.01, ransac_n: int = 3, num_iterations: int = 100, probability: float = 0.999
    ) -> tuple[Tensor, Tensor]:
        """The plane (a, b, c, d) with most inliers, float64, and their indices, int64."""
        numbers = distance_threshold, ransac_n, num_iterations, probability
        plane, rows = native_of(self.point).segment_plane(*numbers, seed=next_seed())
        return Tensor(np.asarray(plane), float64, self.device), converted(wrap(rows), int64)

    def compute_boundary_points(
        self, radius: float, max_nn: int = 30, angle_threshold: float = 90.0
    ) -> tuple[PointCloud, Tensor]:
        """The points whose neighbors leave a gap of more than an angle in degrees around the normal, and a mask."""
        rows = boundary_rows(native_of(self.point, "normals"), radius, max_nn, angle_threshold)
        return self._selected("select_by_index", rows)

    def compute_metrics(self, pcd2: PointCloud, metrics: Iterable[Metric], params: MetricParameters) -> Tensor:
        """The metrics in their order, float32, F-scores once per radius."""
        found: Any = compute_metrics(native_of(self.point), native_of(pcd2.point), [*params.fscore_radius])
        return Tensor(listed_metrics(found, metrics))

    def __repr__(self) -> str:
        kind = f" ({self.point.positions.dtype})" if "positions" in self.point else ""
        return f"PointCloud on {self.device} [{count_of(self.point)} points{kind}].\nAttributes:{listed(self.point)}"
