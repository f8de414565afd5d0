"""PinholeCameraIntrinsic with assignable size and matrix."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...cameras import camera
from ...core.checks import check_shape
from ..wrapper import PlainWrapper


class PinholeCameraIntrinsic(PlainWrapper):
    """Camera from (width, height, fx, fy, cx, cy), (width, height, K), or PinholeCameraIntrinsicParameters.

    Without arguments the size is -1 x -1 (invalid).
    """

    _kind = camera.PinholeCameraIntrinsic

    def __init__(
        self,
        width: Any = None,
        height: Any = None,
        fx: Any = None,
        fy: Any = None,
        cx: Any = None,
        cy: Any = None,
        *,
        intrinsic_matrix: Any = None,
    ):
        self._shared, self._size, self._matrix = {}, (-1, -1), np.eye(3)
        if isinstance(width, PinholeCameraIntrinsic):
            vars(self).update(vars(width))
        elif width is not None:
            given = (width, height, fx if intrinsic_matrix is None else intrinsic_matrix, fy, cx, cy)
            self._take(width if isinstance(width, self._kind) else self._kind(*(v for v in given if v is not None)))

    @classmethod
    def from_native(cls, native: camera.PinholeCameraIntrinsic) -> Self:
        return cls(native)

    def _take(self, native: camera.PinholeCameraIntrinsic) -> None:
        self._size, self._matrix = (native.width, native.height), native.matrix

    @property
    def native(self) -> camera.PinholeCameraIntrinsic:
        return self._kind(*self._size, self._matrix)

    def __copy__(self) -> Self:
        return type(self)(self)

    @property
    def width(self) -> int:
        return self._size[0]

    @width.setter
    def width(self, value: int) -> None:
        self._size = int(value), self._size[1]

    @property
    def height(self) -> int:
        return self._size[1]

    @height.setter
    def height(self, value: int) -> None:
        self._size = self._size[0], int(value)

    @property
    def intrinsic_matrix(self) -> NDArray[np.float64]:
        """K, shape (3, 3), read-only array; assignable."""
        matrix = self._matrix.copy()
        matrix.flags.writeable = False
        return matrix

    @intrinsic_matrix.setter
    def intrinsic_matrix(self, values: ArrayLike) -> None:
        self._matrix = check_shape("intrinsic_matrix", values, (3, 3)).astype(np.float64)

    def set_intrinsics(self, width: int, height: int, fx: float, fy: float, cx: float, cy: float) -> None:
        self._take(self._kind(width, height, fx, fy, cx, cy))

    def get_focal_length(self) -> tuple[float, float]:
        """(fx, fy)."""
        return float(self._matrix[0, 0]), float(self._matrix[1, 1])

    def get_principal_point(self) -> tuple[float, float]:
        """(cx, cy)."""
        return float(self._matrix[0, 2]), float(self._matrix[1, 2])

    def get_skew(self) -> float:
        """The skew. Cameras with skew are rejected where used."""
        return float(self._matrix[0, 1])

    def is_valid(self) -> bool:
        return min(self._size) > 0

    def __repr__(self) -> str:
        return f"PinholeCameraIntrinsic(width={self.width}, height={self.height}, )"
