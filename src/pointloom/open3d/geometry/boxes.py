"""AxisAlignedBoundingBox and OrientedBoundingBox with assignable corners, axes and colors, as in Open3D."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_number, check_shape
from ...kernels.linear_algebra import cube_root, det, matmul
from ...pcd import boxes
from ..argument_types import BoxLike, VectorLike
from ..vectors import Vector3dVector
from ..wrapper import as_array, column, unwrap
from .geometry import Geometry3D, is_rotation

Row = NDArray[np.float64]
WHITE = (1.0, 1.0, 1.0)  # default color of boxes


class Value:
    """An assignable number or row. The pointloom object is made from all of them on demand."""

    def __init__(self, *shape: int):
        self.shape = shape

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    def __get__(self, box: Any, owner: type) -> Any:
        return self if box is None else box.parts()[self.name]

    def __set__(self, box: Any, values: ArrayLike) -> None:
        part = column(self.name, values) if self.shape == (3,) else check_shape(self.name, values, self.shape)
        box.set_parts(**{self.name: part.astype(np.float64)})


class Lengths(Value):
    """Assignable lengths. Signs are dropped."""

    def __set__(self, box: Any, values: ArrayLike) -> None:
        super().__set__(box, np.abs(column(self.name, values)))


class BoundingBox(Geometry3D):
    _internal = ("parts", "set_parts")

    _fields: tuple[str, ...] = ()
    _edited: dict[str, Row] | None = None  # assigned since the last conversion

    color = Value(3)

    @property
    def native(self) -> Any:
        if self._edited is not None:
            made = self._kind(*(self._edited[name] for name in self._fields))
            made.color = self._edited["color"]
            self._wrapped, self._edited = made, None
        return self._wrapped

    def parts(self) -> dict[str, Row]:
        return self._edited or {name: getattr(self._wrapped, name) for name in (*self._fields, "color")}

    def set_parts(self, **parts: Row) -> None:
        self._edited = self.parts() | parts

    def clear(self) -> Self:
        """Reset to an empty box at zero. An axis-aligned box keeps its color, as in Open3D."""
        color, made = self.color, type(self)()
        self._wrapped, self._edited = unwrap(made), None
        if isinstance(made, AxisAlignedBoundingBox):
            self.color = color
        return self

    def transform(self, arg0: ArrayLike) -> Self:
        """Always raises RuntimeError, as in Open3D."""
        raise RuntimeError(
            "transform: a box cannot be transformed by a 4x4 matrix; box.rotate(R, center) and "
            "box.translate(t) move an "
            "OrientedBoundingBox"
        )

    def scale(self, scale: float, center: ArrayLike) -> Self:
        """Scale about a point. A negative factor reflects the box through it."""
        middle = column("center", center)
        super().scale(abs(check_number("scale", scale)), middle)
        return self if scale > 0 else self.translate(2 * (middle - self.get_center()))

    def get_box_points(self) -> Vector3dVector:
        return Vector3dVector(self.native.get_box_points())

    def get_extent(self) -> Row:
        return self.native.get_extent()

    def get_point_indices_within_bounding_box(self, points: VectorLike) -> list[int]:
        return self.native.get_point_indices_within_bounding_box(as_array(points)).tolist()

    def volume(self) -> float:
        return self.native.volume()

    def get_axis_aligned_bounding_box(self) -> AxisAlignedBoundingBox:
        return AxisAlignedBoundingBox.from_native(self.native.get_axis_aligned_bounding_box())

    def get_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return oriented_box(self.native.get_oriented_bounding_box(robust), self)

    def get_minimal_oriented_bounding_box(self, robust: bool = False) -> OrientedBoundingBox:
        return oriented_box(self.native.get_minimal_oriented_bounding_box(robust), self)


class AxisAlignedBoundingBox(BoundingBox):
    """An axis-aligned box with assignable `min_bound`, `max_bound` and `color`.

    The constructor sorts the corners, as in Open3D.
    """

    _kind, _fields = boxes.AxisAlignedBoundingBox, ("min_bound", "max_bound")

    min_bound = Value(3)
    max_bound = Value(3)

    def __init__(self, min_bound: object = (0, 0, 0), max_bound: ArrayLike = (0, 0, 0)):
        given = unwrap(min_bound)
        if not isinstance(given, self._kind):
            given = self._kind(*np.sort([column("min_bound", given), column("max_bound", max_bound)], axis=0))
        self._wrapped, self._shared = given, {}

    @classmethod
    def create_from_points(cls, points: VectorLike) -> Self:
        return cls.from_native(cls._kind.create_from_points(as_array(points)))

    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> Self:
        """Always raises RuntimeError, as in Open3D."""
        raise RuntimeError(
            "rotate: a rotated box is not axis-aligned; box.get_oriented_bounding_box().rotate(R, center)"
        )

    def get_half_extent(self) -> Row:
        return self.native.get_half_extent()

    def get_max_extent(self) -> float:
        return self.native.get_max_extent()

    def get_print_info(self) -> str:
        return self.native.get_print_info()

    def __iadd__(self, other: AxisAlignedBoundingBox) -> Self:
        return self._become(self.native + unwrap(other, AxisAlignedBoundingBox, "other"))

    def __repr__(self) -> str:
        parts = self.parts()
        return f"AxisAlignedBoundingBox: min: {_row(parts['min_bound'])}, max: {_row(parts['max_bound'])}"


class OrientedBoundingBox(BoundingBox):
    """A rotated box with assignable `center`, `R`, `extent` and `color`."""

    _kind, _fields = boxes.OrientedBoundingBox, ("center", "R", "extent")

    center = Value(3)
    R = Value(3, 3)
    extent = Lengths(3)

    def __init__(self, center: object = (0, 0, 0), R: ArrayLike | None = None, extent: ArrayLike = (0, 0, 0)):
        given = unwrap(center)
        if not isinstance(given, self._kind):
            axes = np.eye(3) if R is None else R
            given = self._kind(column("center", given), axes, np.abs(column("extent", extent)))
            given.color = WHITE
        self._wrapped, self._shared = given, {}

    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> Self:
        """Rotate about a point, by default the center. R may include a reflection and a uniform scale."""
        A = np.asarray(R)
        if A.shape != (3, 3) or is_rotation(A):
            return super().rotate(R, center)
        factor = cube_root(float(det(A)))
        axes = matmul(A, self.R) / (factor or 1.0)
        middle = self.center if center is None else column("center", center)
        made = self._kind(middle + matmul(A, self.center - middle), axes, abs(factor) * self.extent)
        made.color = self.color
        return self._become(made)

    @classmethod
    def create_from_axis_aligned_bounding_box(cls, aabox: BoxLike) -> OrientedBoundingBox:
        return oriented_box(
            cls._kind.create_from_axis_aligned_bounding_box(unwrap(aabox, AxisAlignedBoundingBox, "aabox"))
        )

    @classmethod
    def create_from_points(cls, points: VectorLike, robust: bool = False) -> OrientedBoundingBox:
        """Box along the principal axes of points."""
        return oriented_box(cls._kind.create_from_points(as_array(points), robust))

    @classmethod
    def create_from_points_minimal(cls, points: VectorLike, robust: bool = False) -> OrientedBoundingBox:
        """Smallest box of points."""
        return oriented_box(cls._kind.create_from_points_minimal(as_array(points), robust))

    def __repr__(self) -> str:
        parts = self.parts()
        return f"OrientedBoundingBox: center: {_row(parts['center'])}, extent: {_row(parts['extent'])[1:]}"


def oriented_box(native: boxes.OrientedBoundingBox, source: BoundingBox | None = None) -> OrientedBoundingBox:
    """A new box in Open3D's default color, or in that of an oriented one that it is made from."""
    made = OrientedBoundingBox.from_native(native)
    made.color = source.color if isinstance(source, OrientedBoundingBox) else WHITE
    return made


def _row(values: Row) -> str:
    return f"({', '.join(f'{value:g}' for value in values)})"
