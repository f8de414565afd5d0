"""Static types of device arrays by element and rank. At run time each is `wp.array`, and launches check the arguments.
`Array1[Any]` is for elements made with `vector`. Type checkers use `array[vec3, Literal[1]]` of typings/warp.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, TypeAlias, TypeVar

import warp as wp
from warp import float32, float64, int32, int64, mat44d, uint8, vec3, vec3d, vec3i

Element = TypeVar("Element")
Rank = TypeVar("Rank")
Device: TypeAlias = wp.Device

if TYPE_CHECKING:
    DeviceArray: TypeAlias = wp.array[Element, Rank]
    Array1: TypeAlias = wp.array[Element, Literal[1]]
    Array2: TypeAlias = wp.array[Element, Literal[2]]
    Array3: TypeAlias = wp.array[Element, Literal[3]]
else:

    class DeviceArray:
        """Warp's array with any subscript: annotations are evaluated at import, and `| None` needs a class."""

        def __class_getitem__(cls, _):
            return wp.array

    Array1 = Array2 = Array3 = DeviceArray

AnyArray: TypeAlias = wp.array
Array = TypeVar("Array", bound=wp.array)  # the same element and rank in and out

Points: TypeAlias = Array1[vec3]  # float32, about an origin
Vectors: TypeAlias = Array1[vec3]  # not positions: normals, colors
Positions: TypeAlias = Array1[vec3d]  # float64
Triangles: TypeAlias = Array1[vec3i]  # rows of three vertices
Cells: TypeAlias = Array1[vec3i]  # integer grid coordinates
Poses: TypeAlias = Array1[mat44d]
Scalars: TypeAlias = Array1[float32]
Doubles: TypeAlias = Array1[float64]
Indices: TypeAlias = Array1[int32]  # rows of another array
Integers: TypeAlias = Array1[int32]  # counts, labels, flags
LongIntegers: TypeAlias = Array1[int64]
Keys: TypeAlias = Array1[int64]
Mask: TypeAlias = Array1[uint8]  # 0 or 1
Bytes: TypeAlias = Array1[uint8]
