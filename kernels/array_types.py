"""Types of device arrays by element and rank: what a type checker holds at the door of the kernels.

`Points` is no `Positions` (another element), no `Array2[vec3]` (another rank) and no NumPy array; what is only known to
be Warp's array passes for each. `Array1[Any]` is for elements that a room makes with `vector`. At run time each of
these is Warp's class: nothing is checked there, and a launch checks what its kernel says. To a type checker they are
Warp's own `array[vec3, Literal[1]]`, with slices that keep element and rank by typings/warp.
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
        """Warp's array, whatever stands in the brackets: annotations are read at import, and `| None` wants a class."""

        def __class_getitem__(cls, _):
            return wp.array

    Array1 = Array2 = Array3 = DeviceArray

AnyArray: TypeAlias = wp.array
Array = TypeVar("Array", bound=wp.array)  # the same element and rank in and out

Points: TypeAlias = Array1[vec3]  # float32, about an origin
Vectors: TypeAlias = Array1[vec3]  # what is no place: normals, colours
Positions: TypeAlias = Array1[vec3d]  # float64
Triangles: TypeAlias = Array1[vec3i]  # rows of three vertices
Cells: TypeAlias = Array1[vec3i]  # whole coordinates in a grid
Poses: TypeAlias = Array1[mat44d]
Scalars: TypeAlias = Array1[float32]
Doubles: TypeAlias = Array1[float64]
Indices: TypeAlias = Array1[int32]  # rows of another array
Integers: TypeAlias = Array1[int32]  # counts, labels, flags
LongIntegers: TypeAlias = Array1[int64]
Keys: TypeAlias = Array1[int64]
Mask: TypeAlias = Array1[uint8]  # 0 or 1
Bytes: TypeAlias = Array1[uint8]
