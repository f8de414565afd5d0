"""OrientedBoundingEllipsoid of tensors, over that of `o3d.geometry`."""

from __future__ import annotations

import copy
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ... import geometry as legacy
from ...core.dtype import Dtype, float32
from ...core.tensor import Tensor
from ...geometry.ellipsoids import fit_ellipsoid
from .boxes import CPU, AxisAlignedBoundingBox, BoundingBox, OrientedBoundingBox
from .tensor_map import matrix_of, tensor_of, wrap


class OrientedBoundingEllipsoid(BoundingBox):
    """An ellipsoid.

    Args:
        center: Center (3,). Or a device of an empty ellipsoid, or an ellipsoid to copy.
        rotation: Axes as columns (3, 3).
        radii: Lengths of the half axes (3,).
    """

    _kind = legacy.OrientedBoundingEllipsoid

    def __init__(self, center: Any = CPU, rotation: Any = None, radii: Any = None, *, device: Any = None):
        fields = {"center": center, "rotation": rotation, "radii": radii}
        self._start(center if device is None else device, fields)

    @staticmethod
    def create_from_points(points: Any, robust: bool = False) -> OrientedBoundingEllipsoid:
        """Ellipsoid of smallest volume around points (n, 3), in their type."""
        tensor = tensor_of("points", points)
        made = legacy.OrientedBoundingEllipsoid(*fit_ellipsoid(tensor.cpu().numpy(), robust))
        return OrientedBoundingEllipsoid._of(made, tensor.dtype, tensor.device)

    @property
    def center(self) -> Tensor:
        return self._tensor(self._native.center)

    @property
    def rotation(self) -> Tensor:
        return self._tensor(self._native.R)

    @property
    def radii(self) -> Tensor:
        return self._tensor(self._native.radii)

    def set_center(self, center: Any) -> None:
        self._set(center=matrix_of("center", center, (3,)))

    def set_rotation(self, rotation: Any) -> None:
        self._set(R=matrix_of("rotation", rotation, (3, 3)))

    def set_radii(self, radii: Any) -> None:
        self._set(radii=matrix_of("radii", radii, (3,)))

    def _set(self, **parts: NDArray[np.float64]) -> None:
        given = {name: getattr(self._native, name) for name in ("center", "R", "radii")}
        self._become(self._kind(**given | parts))

    def translate(self, translation: Any, relative: bool = True) -> Self:
        """Translate by a vector. With `relative=False`, move the center there."""
        return self._become(copy.copy(self._native).translate(matrix_of("translation", translation, (3,)), relative))

    def scale(self, scale: float, center: Any = None) -> Self:
        """Scale about a point, by default the center."""
        about = self._native.center if center is None else matrix_of("center", center, (3,))
        return self._become(copy.copy(self._native).scale(scale, about))

    def rotate(self, rotation: Any, center: Any = None) -> Self:
        """Rotate about a point, by default the center."""
        about = None if center is None else matrix_of("center", center, (3,))
        return self._become(copy.copy(self._native).rotate(matrix_of("rotation", rotation, (3, 3)), about))

    def get_ellipsoid_points(self) -> Tensor:
        """The ends of the axes (6, 3)."""
        return self._tensor(self._native._ends())

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        """Box of the ends of the axes."""
        return AxisAlignedBoundingBox.from_legacy(self._native.get_axis_aligned_bounding_box(), self._dtype, self._home)

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        """Box along the axes, the longest first."""
        return OrientedBoundingBox.from_legacy(self._native.get_oriented_bounding_box(), self._dtype, self._home)

    get_minimal_oriented_bounding_box = get_oriented_bounding_box

    def get_point_indices_within_bounding_ellipsoid(self, points: Any) -> Tensor:
        """Ascending indices of the points inside, surface included, int64."""
        tensor, native = tensor_of("points", points), self._native
        offsets = (tensor.cpu().numpy().astype(np.float64) - native.center) @ native.R
        with np.errstate(divide="ignore", invalid="ignore"):
            inside = ((offsets / native.radii) ** 2).sum(axis=1) <= 1
        return wrap(np.flatnonzero(inside)).to(tensor.device)

    def to_legacy(self) -> Any:
        made = copy.copy(self._native)
        made.color = self._rgb
        return made

    @classmethod
    def from_legacy(cls, box: Any, dtype: Dtype = float32, device: Any = CPU) -> Self:
        if not isinstance(box, legacy.OrientedBoundingEllipsoid):
            raise TypeError(f"ellipsoid: expected an OrientedBoundingEllipsoid, got {type(box).__name__}")
        return cls._of(copy.copy(box), dtype, device, box.color)

    def __repr__(self) -> str:
        return f"OrientedBoundingEllipsoid[{self.dtype}, {self.device}]"
