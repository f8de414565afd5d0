"""VoxelBlockGrid over `loom.TSDFVolume`."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ....cameras.camera import PinholeCameraIntrinsic
from ....cameras.images import upload_raw_depth
from ....core.attribute_hints import KnownNames
from ....core.checks import check_count, check_positive, check_rigid, is_on_gpu
from ....core.coordinates import origin_of_sensor
from ....core.devices import resolve_device
from ....core.errors import FilePath
from ....core.serialized import Serialized
from ....kernels.images.depth import largest_depth, metric_depth
from ....kernels.linear_algebra import inv, matmul
from ....kernels.memory import download
from ....kernels.volumes.tsdf_blocks import BLOCK_SIDE, BLOCK_VOXELS, block_box, touched_blocks
from ....kernels.volumes.voxel_blocks import COLOR_SCALE
from ....meshing.volume.tsdf import TSDFVolume
from ...argument_types import DeviceLike, TensorImage, TensorLike
from ...core.device import Device
from ...core.dtype import Dtype, float32, int32
from ...core.tensor import Tensor
from ...indices import indices_of
from .geometry import device_of
from .mesh_tensors import CPU, cloud_of
from .tensor_map import TensorMap, wrap
from .tensors import host_of, values_of
from .triangle_mesh import TriangleMesh
from .voxel_corners import voxels_around

ATTRIBUTE_CHANNELS = {"tsdf": 1, "weight": 1, "color": 3}
TRUNCATION_MULTIPLIER = 8.0  # of the voxel size: default truncation
AROUND = {"index": np.int64, "mask": np.bool_, "interp_ratio": np.float32}
RENDERED = ("depth", "vertex", "normal", "color", *AROUND)
BLOCK_VOXEL_OFFSETS = np.indices([BLOCK_SIDE] * 3).reshape(3, -1).T[:, ::-1]  # x fastest


class VoxelBlockGrid(Serialized, KnownNames):
    """Truncated signed distances, weights and colors of voxels in hashed blocks, integrated from depth images.

    Blocks have 8^3 voxels for any `block_resolution`, and their number grows as needed. All integrations have one
    truncation. Extrinsics are world to camera.
    """

    _volume: TSDFVolume | None

    def __init__(
        self,
        attr_names: Sequence[str],
        attr_dtypes: Sequence[Dtype],
        attr_channels: Sequence[Any],
        voxel_size: float = 0.0058,
        block_resolution: int = 16,
        block_count: int = 10000,
        device: DeviceLike = CPU,
    ):
        channels = [int(np.prod(host_of(shape))) for shape in attr_channels]
        given = dict(zip(attr_names, channels, strict=True))
        if not {"tsdf", "weight"} <= given.keys() or not given.items() <= ATTRIBUTE_CHANNELS.items():
            raise ValueError(
                f"attr_names, attr_channels: expected tsdf (1), weight (1) and maybe color (3), got {given}"
            )
        check_count("block_resolution", block_resolution)
        check_count("block_count", block_count)
        self._dtypes = dict(zip(attr_names, attr_dtypes, strict=True))
        self._voxel_size, self._device = check_positive("voxel_size", voxel_size), device_of(device)
        self._volume = None

    def _with_truncation(self, multiplier: float) -> TSDFVolume:
        """The volume, created by the first integration. ValueError if it has another truncation."""
        truncation = check_positive("trunc_voxel_multiplier", multiplier) * self._voxel_size
        volume = self._volume
        is_same = volume is not None and math.isclose(volume.truncation, truncation, rel_tol=1e-6)
        if volume is None or (not is_same and not volume.frame_count):
            sizes = {"voxel_size": self._voxel_size, "truncation": truncation}
            volume = TSDFVolume(**sizes, color="color" in self._dtypes, device=self._device.name)
            self._volume = volume
        elif not is_same:
            first = volume.truncation / self._voxel_size
            raise ValueError(
                f"trunc_voxel_multiplier: expected {first:g} as in the first integration, got {multiplier}"
            )
        return volume

    @property
    def _any(self) -> TSDFVolume:
        return self._with_truncation(TRUNCATION_MULTIPLIER) if self._volume is None else self._volume

    def compute_unique_block_coordinates(
        self,
        depth: TensorImage | TensorLike,
        intrinsic: TensorLike,
        extrinsic: TensorLike,
        depth_scale: float = 1000.0,
        depth_max: float = 3.0,
        trunc_voxel_multiplier: float = TRUNCATION_MULTIPLIER,
    ) -> Tensor:
        """Blocks within the truncation of a depth image, int32 (n, 3), in units of 8 voxels about the grid's origin."""
        truncation = check_positive("trunc_voxel_multiplier", trunc_voxel_multiplier) * self._voxel_size
        device, volume, T = resolve_device(self._device.name), self._volume, inv(_pose(extrinsic))
        raw, scale, farthest, height, width = upload_raw_depth(_pixels(depth), depth_scale, depth_max, device)
        metric, largest = metric_depth(raw, scale, farthest)
        limit = largest_depth(largest)
        if not limit > 0:
            return self._tensor(np.zeros((0, 3), np.int32))
        T[:3, 3] -= volume.origin if volume is not None and volume.frame_count else origin_of_sensor(T[:3, 3])
        camera = _camera(intrinsic, width, height)
        keys = touched_blocks(metric, limit, camera, T, truncation, self._voxel_size)
        return self._tensor(block_box(download(keys)).astype(np.int32))

    def integrate(
        self, block_coords: TensorLike | None, depth: TensorImage | TensorLike, *args: Any, **kwargs: Any
    ) -> None:
        """Integrate an image: (block_coords, depth, [color], intrinsic, [color_intrinsic], extrinsic, ...).

        The touched blocks are computed again: `block_coords` has no effect. Both intrinsics must be equal.
        """
        given = _frame(args, kwargs)
        volume, pixels = self._with_truncation(given["trunc_voxel_multiplier"]), _pixels(depth)
        color = given.get("color") if "color" in self._dtypes else None
        camera = _camera(given["depth_intrinsic"], pixels.shape[1], pixels.shape[0])
        if color is not None:
            color, matrices = _pixels(color), [host_of(given.get(f"{of}_intrinsic")) for of in ("depth", "color")]
            if matrices[1] is not None and not np.array_equal(*matrices):
                raise ValueError(
                    "color_intrinsic: expected that of the depth image, got another one; register the color image to "
                    "the depth image first"
                )
        options = {"depth_scale": given["depth_scale"], "depth_max": given["depth_max"]}
        volume.integrate(pixels, camera, _pose(given["extrinsic"]), color, **options)

    def ray_cast(
        self,
        block_coords: TensorLike | None,
        intrinsic: TensorLike,
        extrinsic: TensorLike,
        width: int,
        height: int,
        render_attributes: Sequence[str] = ("depth", "color"),
        depth_scale: float = 1000.0,
        depth_min: float = 0.1,
        depth_max: float = 3.0,
        weight_threshold: float = 3.0,
        trunc_voxel_multiplier: float = TRUNCATION_MULTIPLIER,
        range_map_down_factor: int = 8,
    ) -> TensorMap:
        """Render depth (h, w, 1) in units of 1 / depth_scale, vertices, normals, and colors of the nearest voxels.

        Also the eight voxels around each surface point, (h, w, 8): `index` in attributes, `mask` and `interp_ratio`.
        Vertices and normals are in the camera frame, normals away from the camera. Pixels without surface are 0.
        Voxels of at least `weight_threshold` frames count. `block_coords` and the last two arguments have no effect.
        """
        missing = [name for name in render_attributes if name not in RENDERED]
        if missing:
            raise ValueError(
                f"render_attributes: expected some of {', '.join(RENDERED)}, got {missing}; "
                "'normal' has the direction of the gradient"
            )
        volume, T = self._any, _pose(extrinsic)
        limits = {"depth_min": depth_min, "depth_max": depth_max}
        threshold = max(math.ceil(weight_threshold) - 1, 0)  # pointloom's is exclusive
        cast = volume.ray_cast(_camera(intrinsic, width, height), T, **limits, weight_threshold=threshold)
        depth = host_of(wrap(cast.depth))
        seen = (depth > 0)[..., None]

        def image(name: str) -> NDArray[np.float64]:
            if name == "depth":
                return (depth * depth_scale)[..., None]
            if name == "color":
                return np.zeros((height, width, 3)) if cast.colors is None else host_of(wrap(cast.colors))
            vectors = host_of(wrap(cast.points if name == "vertex" else cast.normals))
            return matmul(vectors, T[:3, :3].T) + T[:3, 3] if name == "vertex" else -matmul(vectors, T[:3, :3].T)

        around = voxels_around(volume, host_of(wrap(cast.points)), seen) if AROUND.keys() & render_attributes else {}
        made = {
            name: around[name] if name in AROUND else np.nan_to_num(np.where(seen, image(name), 0.0))
            for name in render_attributes
        }
        return TensorMap(
            render_attributes[0] if made else "depth",
            {name: self._tensor(values.astype(AROUND.get(name, np.float32))) for name, values in made.items()},
        )

    def extract_point_cloud(self, weight_threshold: float = 3.0, estimated_point_number: int = -1) -> Any:
        """Surface points with normals and colors. An edge needs more frames than the threshold at both voxels."""
        return cloud_of(self._any.extract_point_cloud(weight_threshold), float32)

    def extract_triangle_mesh(self, weight_threshold: float = 3.0, estimated_vertex_number: int = -1) -> TriangleMesh:
        """Surface with vertex normals and colors. A cell needs more frames than the threshold at all voxels."""
        made = self._any.extract_triangle_mesh(weight_threshold)
        return TriangleMesh.from_native(made.compute_vertex_normals(), float32, int32)

    def attribute(self, attribute_name: str) -> Tensor:
        """Copy of "tsdf" (in truncations), "weight" or "color" (0..255) of all blocks: (blocks, 8, 8, 8, channels).

        The axes are block, z, y, x. Tensors on a GPU have at most 4 axes: call `cpu` first.
        """
        if attribute_name not in self._dtypes:
            raise ValueError(f"attribute_name: expected one of {', '.join(self._dtypes)}, got {attribute_name!r}")
        if self._device.name != "cpu":
            raise ValueError(f"attribute: expected a grid on the CPU, got {self._device}; call grid.cpu().attribute")
        arrays, channels = self._any.downloaded(), ATTRIBUTE_CHANNELS[attribute_name]
        values = arrays.get({"tsdf": "distances", "weight": "weights", "color": "colors"}[attribute_name])
        if values is None:  # frames without color
            values = np.zeros((len(arrays["distances"]), channels))
        blocks = (values / COLOR_SCALE if attribute_name == "color" else values).reshape(
            -1, BLOCK_SIDE, BLOCK_SIDE, BLOCK_SIDE, channels
        )
        return Tensor(blocks.transpose(0, 3, 2, 1, 4), self._dtypes[attribute_name])

    def voxel_indices(self, buf_indices: TensorLike | None = None) -> Tensor:
        """Index of the block, x, y and z of each voxel of some or all blocks, int64 (4, n)."""
        rows = self._rows(buf_indices)
        local = np.tile(BLOCK_VOXEL_OFFSETS, (len(rows), 1))
        return self._tensor(np.vstack([np.repeat(rows, BLOCK_VOXELS), local.T]).astype(np.int64))

    def voxel_coordinates(self, voxel_indices: TensorLike) -> Tensor:
        """Coordinates of voxels from `voxel_indices`, in voxels about the grid's origin, int64 (3, n)."""
        indices = np.asarray(host_of(voxel_indices))
        return self._tensor((self._corners()[indices[0]] + indices[1:].T).T.astype(np.int64))

    def voxel_coordinates_and_flattened_indices(self, buf_indices: TensorLike | None = None) -> tuple[Tensor, Tensor]:
        """Positions [m] of the voxels of some or all blocks, float32 (n, 3), and their rows in attributes, int64 (n,).

        A row is one of `attribute(name).reshape((-1, channels))`.
        """
        rows, volume = self._rows(buf_indices), self._any
        voxels = (self._corners()[rows][:, None] + BLOCK_VOXEL_OFFSETS).reshape(-1, 3)
        flat = (BLOCK_VOXELS * rows[:, None] + np.arange(BLOCK_VOXELS)).reshape(-1)
        positions = voxels * volume.voxel_size + volume.origin
        return self._tensor(positions.astype(np.float32)), self._tensor(flat.astype(np.int64))

    def _rows(self, buf_indices: TensorLike | None) -> NDArray[np.int64]:
        count = self._any.block_count
        if buf_indices is None:
            return np.arange(count)
        return indices_of("buf_indices", host_of(buf_indices), count, f"grid of {count} blocks")

    def _corners(self) -> NDArray[np.int64]:
        """First voxel of each block."""
        return BLOCK_SIDE * block_box(self._any.downloaded()["keys"])

    def save(self, file_name: FilePath) -> None:
        """Write an .npz file of `loom.TSDFVolume`, which Open3D cannot read."""
        self._any.save(file_name)

    @classmethod
    def load(cls, file_name: FilePath) -> Self:
        """Read a file that `save` or `loom.TSDFVolume.save` wrote. Attributes are float32."""
        return cls._around(TSDFVolume.load(file_name))

    @classmethod
    def _around(cls, volume: TSDFVolume) -> Self:
        names = [*ATTRIBUTE_CHANNELS] if volume.has_color else ["tsdf", "weight"]
        device = Device(str(volume.device))
        made = cls(
            names, [float32] * len(names), [ATTRIBUTE_CHANNELS[n] for n in names], volume.voxel_size, device=device
        )
        vars(made)["_volume"] = volume
        return made

    def to(self, device: DeviceLike, copy: bool = False) -> Self:
        """The grid on a device: itself if it is there already, unless `copy`."""
        target = device_of(device)
        if target == self._device and not copy:
            return self
        made = self._around(TSDFVolume.from_downloaded(self._any.downloaded(), resolve_device(target.name)))
        vars(made)["_dtypes"] = dict(self._dtypes)
        return made

    def cpu(self) -> Self:
        return self.to(CPU)

    def cuda(self, device_id: int = 0) -> Self:
        return self.to(Device("CUDA", device_id))

    def _tensor(self, values: NDArray[Any]) -> Tensor:
        return Tensor(values, device=self._device)


def _frame(args: tuple[Any, ...], kwargs: dict[str, Any]) -> dict[str, Any]:
    """Arguments of `integrate` by name. Matrices are recognized by their shape."""
    given: dict[str, Any] = {"depth_scale": 1000.0, "depth_max": 3.0, "trunc_voxel_multiplier": TRUNCATION_MULTIPLIER}
    numbers, intrinsics = [*given], ["depth_intrinsic", "color_intrinsic"]
    named = {"depth_intrinsic" if name == "intrinsic" else name: value for name, value in kwargs.items()}
    if unknown := named.keys() - {*numbers, *intrinsics, "color", "extrinsic"}:
        raise TypeError(f"integrate: unexpected arguments {', '.join(sorted(unknown))}")
    for value in args:
        shape = (
            () if hasattr(value, "as_tensor") else tuple(value.shape) if isinstance(value, Tensor) else np.shape(value)
        )
        if isinstance(value, int | float):
            given[numbers.pop(0)] = value
        else:
            given["extrinsic" if shape == (4, 4) else intrinsics.pop(0) if shape == (3, 3) else "color"] = value
    given |= named
    if absent := {"depth_intrinsic", "extrinsic"} - given.keys():
        raise TypeError(f"integrate: expected {' and '.join(sorted(absent))}, matrices (3, 3) and (4, 4), got none")
    return given


def _pixels(image: Any) -> Any:
    """The array of an image, (h, w) or (h, w, c)."""
    array = values_of(image.as_tensor() if hasattr(image, "as_tensor") else image)
    array = array if is_on_gpu(array) else np.asarray(array)
    return array.reshape(array.shape[:2]) if array.ndim == 3 and array.shape[2] == 1 else array


def _camera(intrinsic: TensorLike, width: int, height: int) -> PinholeCameraIntrinsic:
    return PinholeCameraIntrinsic(width, height, np.asarray(host_of(intrinsic), np.float64))


def _pose(extrinsic: TensorLike) -> NDArray[np.float64]:
    return check_rigid("extrinsic", np.asarray(host_of(extrinsic), np.float64))
