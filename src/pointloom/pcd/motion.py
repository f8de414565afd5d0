"""Affine motions of clouds and other objects."""

from __future__ import annotations

from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.attribute_hints import HintedNames
from ..core.checks import LARGEST_NUMBER, check_finite, check_positive, check_rigid, check_shape
from ..core.dropped_results import returns_new
from ..kernels.linear_algebra import matmul


class Movable(HintedNames):
    """Object with affine motions, by default about its center."""

    __array_ufunc__ = None  # so that NumPy passes operators on to the shape

    def __rmatmul__(self, other: object) -> Self:
        raise TypeError(f"{type(self).__name__} has no operator @; use transform(T) with T of shape [4, 4]")

    def get_center(self) -> NDArray[np.float64]:
        """Center [m], shape (3,)."""
        raise NotImplementedError

    def _finite_center(self) -> NDArray[np.float64]:
        return self.get_center()

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """Apply an affine map; `name` is the argument reported in errors."""
        raise NotImplementedError

    @returns_new
    def translate(self, translation: ArrayLike, relative: bool = True) -> Self:
        """Translate by a vector [m]. With `relative=False`, move the center (`get_center`) there.

        Raises:
            ValueError: If there are not three finite numbers.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [2, 0, 0]]).translate([0, 0, 5], relative=False).points.tolist()
            [[-1.0, 0.0, 5.0], [1.0, 0.0, 5.0]]
        """
        step = check_finite("translation", check_shape("translation", translation, (3,)))
        way = step if relative else step - self._finite_center()
        return self._mapped("translation", map_about(np.eye(3), np.zeros(3), way))

    @returns_new
    def rotate(self, R: ArrayLike, center: ArrayLike | None = None) -> Self:
        """Rotate about a point [m], default the center (`get_center`).

        Raises:
            ValueError: If R is not a rotation matrix (3, 3), or the center is not three finite numbers.
        """
        T = np.eye(4)
        try:
            T[:3, :3] = check_shape("R", R, (3, 3))
        except ValueError as error:  # of another shape, such as angles
            raise ValueError(
                f"{error}: a rotation matrix; scipy.spatial.transform.Rotation.from_euler('xyz', angles, "
                "degrees=True).as_matrix() makes one"
            ) from None
        return self._mapped("center", map_about(check_rigid("R", T)[:3, :3], self._middle(center)))

    @returns_new
    def scale(self, scale: float, center: ArrayLike | None = None) -> Self:
        """Scale about a point [m], default the center (`get_center`). The unit becomes unknown (see `to_unit`).

        Raises:
            ValueError: If the factor is not positive, or the center is not three finite numbers.
        """
        factor = check_positive("scale", scale, maximum=LARGEST_NUMBER)
        return self._mapped("scale, center", map_about(factor * np.eye(3), self._middle(center)))

    def _middle(self, center: ArrayLike | None) -> NDArray[np.float64]:
        return self._finite_center() if center is None else check_finite("center", check_shape("center", center, (3,)))


def map_about(A: NDArray[np.float64], center: NDArray[np.float64], step: ArrayLike = 0.0) -> NDArray[np.float64]:
    """4x4 map that applies A about a point, then a translation."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = A, center - matmul(A, center) + np.asarray(step, np.float64)
    return T
