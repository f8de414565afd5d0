"""AxisAlignedBoundingBox and OrientedBoundingBox of tensors, over those of pointloom."""

from __future__ import annotations

import enum
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ....pcd import boxes, cloud
from ... import geometry as legacy
from ...argument_types import BoxLike, DeviceLike, TensorLike
from ...core.device import Device
from ...core.dtype import Dtype, float32, float64
from ...core.tensor import Tensor
from ...wrapper import unwrap
from .geometry import CPU, Geometry, device_of
from .tensor_map import matrix_of, tensor_of, wrap


class MethodOBBCreate(enum.Enum):
    """How an oriented box is fitted. Both minimal methods give the smallest box."""

    PCA, MINIMAL_APPROX, MINIMAL_JYLANKI = range(3)


class BoundingBox(Geometry):
    """A box of float64 numbers, read as tensors of one type on one device. Setters and motions change it in place."""

    _kind: ClassVar[Any]  # the pointloom class
    native: Any
    _rgb: NDArray[np.float64]
    _dtype: Dtype

    def _start(self, first: object, fields: dict[str, Any]) -> None:
        """Set the box from the arguments of a constructor: a device, a box, or a tensor for each field."""
        if isinstance(first, type(self)):
            vars(self).update(vars(first))
            return
        self._rgb = np.ones(3)
        if isinstance(first, Device | str):
            self.native, self._dtype, self._home = self._zero(), float32, device_of(first)
            return
        tensors = [tensor_of(name, values) for name, values in fields.items()]
        types = {tensor.dtype for tensor in tensors}
        if len(types) > 1 or not types <= {float32, float64}:
            raise TypeError(
                f"{', '.join(fields)}: expected float32 or float64, all the same, got {sorted(map(str, types))}"
            )
        self._dtype, self._home = tensors[0].dtype, tensors[0].device
        self.native = self._made(*(tensor.numpy().astype(np.float64) for tensor in tensors))

    def _made(self, *values: NDArray[np.float64]) -> Any:
        return self._kind(*values)

    @classmethod
    def _zero(cls) -> Any:
        return cls._kind()

    @classmethod
    def from_native(cls, native: Any, dtype: Dtype, device: DeviceLike, color: ArrayLike = (1, 1, 1)) -> Self:
        """Wrap a pointloom box."""
        box = cls.__new__(cls)
        vars(box).update(native=native, _dtype=dtype, _rgb=np.array(color, np.float64), _home=device_of(device))
        return box

    def _tensor(self, values: ArrayLike) -> Tensor:
        return Tensor(values, self._dtype, self._home)

    def _become(self, native: Any) -> Self:
        self.native = native
        return self

    @property
    def device(self) -> Device:
        return self._home

    @property
    def dtype(self) -> Dtype:
        return self._dtype

    @property
    def color(self) -> Tensor:
        return self._tensor(self._rgb)

    def set_color(self, color: TensorLike) -> None:
        rgb = matrix_of("color", color, (3,))
        if not ((rgb >= 0) & (rgb <= 1)).all():
            raise ValueError(f"color: expected three numbers in 0..1, got {rgb.tolist()}")
        self._rgb = rgb

    def is_empty(self) -> bool:
        """True if the volume is zero."""
        return self.volume() == 0

    def clear(self) -> Self:
        """Reset to an empty box at zero."""
        return self._become(self._zero())

    def get_box_points(self) -> Tensor:
        """Corners (8, 3)."""
        return self._tensor(self.native.get_box_points())

    def get_min_bound(self) -> Tensor:
        return self._tensor(self.native.get_min_bound())

    def get_max_bound(self) -> Tensor:
        return self._tensor(self.native.get_max_bound())

    def volume(self) -> float:
        return float(self.native.volume())

    def get_point_indices_within_bounding_box(self, points: TensorLike) -> Tensor:
        """Ascending indices of the points inside, faces included, int64."""
        return wrap(self.native.get_point_indices_within_bounding_box(tensor_of("points", points).array))

    def translate(self, translation: TensorLike, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        return self._become(self.native.translate(matrix_of("translation", translation, (3,)), relative))

    def scale(self, scale: float, center: TensorLike | None = None) -> Self:
        """Scale about a point, by default the center."""
        return self._become(self.native.scale(scale, None if center is None else matrix_of("center", center, (3,))))

    def to_legacy(self) -> Any:
        kind = getattr(legacy, type(self).__name__)
        box = kind.from_native(self.native)
        box.color = self._rgb
        return box

    @classmethod
    def from_legacy(cls, box: BoxLike, dtype: Dtype = float32, device: DeviceLike = CPU) -> Self:
        native = unwrap(box, getattr(legacy, cls.__name__), "box")
        return cls.from_native(native, dtype, device, native.color)


class AxisAlignedBoundingBox(BoundingBox):
    """An axis-aligned box. The constructor sorts the corners.

    Args:
        min_bound, max_bound: Corners (3,). Or a device of an empty box, or a box to copy.
    """

    _kind = boxes.AxisAlignedBoundingBox

    def __init__(self, min_bound: object = CPU, max_bound: object = None, *, device: DeviceLike | None = None):
        self._start(min_bound if device is None else device, {"min_bound": min_bound, "max_bound": max_bound})

    def _made(self, *values: NDArray[np.float64]) -> Any:
        return self._kind(*np.sort(values, axis=0))

    @property
    def min_bound(self) -> Tensor:
        return self.get_min_bound()

    @property
    def max_bound(self) -> Tensor:
        return self.get_max_bound()

    def set_min_bound(self, min_bound: TensorLike) -> None:
        self._become(self._kind(matrix_of("min_bound", min_bound, (3,)), self.native.max_bound))

    def set_max_bound(self, max_bound: TensorLike) -> None:
        self._become(self._kind(self.native.min_bound, matrix_of("max_bound", max_bound, (3,))))

    @staticmethod
    def create_from_points(points: TensorLike) -> AxisAlignedBoundingBox:
        """Box of points (n, 3), in their type. Zero without points."""
        tensor = tensor_of("points", points)
        if not tensor.shape[0]:
            return AxisAlignedBoundingBox(tensor.device)
        if tensor.is_cpu:
            return AxisAlignedBoundingBox(tensor.min((0,)), tensor.max((0,)))
        native = cloud.PointCloud(tensor.array).get_axis_aligned_bounding_box()
        return AxisAlignedBoundingBox.from_native(native, tensor.dtype, tensor.device)

    def get_center(self) -> Tensor:
        return self._tensor(self.native.get_center())

    def get_extent(self) -> Tensor:
        return self._tensor(self.native.get_extent())

    def get_half_extent(self) -> Tensor:
        return self._tensor(self.native.get_half_extent())

    def get_max_extent(self) -> float:
        return float(self.native.get_max_extent())

    def get_oriented_bounding_box(self) -> OrientedBoundingBox:
        made = self.native.get_oriented_bounding_box()
        return OrientedBoundingBox.from_native(made, self._dtype, self._home, self._rgb)

    def __iadd__(self, other: object) -> Self:
        if not isinstance(other, AxisAlignedBoundingBox):
            raise TypeError(f"other: expected an AxisAlignedBoundingBox, got {type(other).__name__}")
        return self._become(self.native + other.native)

    def __add__(self, other: object) -> AxisAlignedBoundingBox:
        """The box of both boxes."""
        made = self.clone()
        made += other
        return made

    def __repr__(self) -> str:
        low, high = (" ".join(f"{v:.8g}" for v in row) for row in (self.native.min_bound, self.native.max_bound))
        return f"AxisAlignedBoundingBox[[{low}] - [{high}], {self.dtype}, {self.device}]"


class OrientedBoundingBox(BoundingBox):
    """A rotated box.

    Args:
        center: Center (3,). Or a device of an empty box, or a box to copy.
        rotation: Axes as columns (3, 3).
        extent: Edge lengths (3,).
    """

    _kind = boxes.OrientedBoundingBox

    @classmethod
    def _zero(cls) -> Any:
        return cls._kind(np.zeros(3), np.eye(3), np.zeros(3))

    def __init__(
        self, center: object = CPU, rotation: object = None, extent: object = None, *, device: DeviceLike | None = None
    ):
        fields = {"center": center, "rotation": rotation, "extent": extent}
        self._start(center if device is None else device, fields)

    @property
    def center(self) -> Tensor:
        return self._tensor(self.native.center)

    @property
    def rotation(self) -> Tensor:
        return self._tensor(self.native.R)

    @property
    def extent(self) -> Tensor:
        return self._tensor(self.native.extent)

    def set_center(self, center: TensorLike) -> None:
        self._become(self._kind(matrix_of("center", center, (3,)), self.native.R, self.native.extent))

    def set_rotation(self, rotation: TensorLike) -> None:
        self._become(self._kind(self.native.center, matrix_of("rotation", rotation, (3, 3)), self.native.extent))

    def set_extent(self, extent: TensorLike) -> None:
        self._become(self._kind(self.native.center, self.native.R, matrix_of("extent", extent, (3,))))

    def rotate(self, rotation: TensorLike, center: TensorLike | None = None) -> Self:
        """Rotate about a point, by default the center."""
        about = None if center is None else matrix_of("center", center, (3,))
        return self._become(self.native.rotate(matrix_of("rotation", rotation, (3, 3)), about))

    def transform(self, transformation: TensorLike) -> Self:
        """Apply a rigid 4x4 matrix."""
        T = matrix_of("transformation", transformation, (4, 4))
        return self._become(self.native.rotate(T[:3, :3], np.zeros(3)).translate(T[:3, 3]))

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox.from_native(
            self.native.get_axis_aligned_bounding_box(), self._dtype, self._home, self._rgb
        )

    @staticmethod
    def create_from_axis_aligned_bounding_box(aabb: AxisAlignedBoundingBox) -> OrientedBoundingBox:
        return aabb.get_oriented_bounding_box()

    @staticmethod
    def create_from_points(
        points: TensorLike, robust: bool = False, method: MethodOBBCreate = MethodOBBCreate.MINIMAL_APPROX
    ) -> OrientedBoundingBox:
        """The smallest box of points (n, 3), or that along their principal axes, in their type."""
        tensor = tensor_of("points", points)
        native = cloud.PointCloud(tensor.array)
        fit = (
            native.get_oriented_bounding_box
            if method is MethodOBBCreate.PCA
            else native.get_minimal_oriented_bounding_box
        )
        return OrientedBoundingBox.from_native(fit(robust), tensor.dtype, tensor.device)

    def __repr__(self) -> str:
        return f"OrientedBoundingBox[{self.dtype}, {self.device}]"
