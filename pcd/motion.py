"""Moving a cloud, and anything that an affine map moves."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import LARGEST_NUMBER, check_finite, check_positive, check_rigid, check_shape
from ..core.dropped_results import returns_new
from ..core.known_names import ToldNames
from ..kernels.linear_algebra import matmul


class Movable(ToldNames):
    """What affine maps move, about its middle where no point is given."""

    def get_center(self) -> NDArray[np.float64]:
        """The middle [m], shape [3]."""
        raise NotImplementedError

    def _finite_center(self) -> NDArray[np.float64]:
        """The middle of what is finite [m], which motions start from."""
        return self.get_center()

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """What it becomes under an affine map; errors call it by the argument that it was made of."""
        raise NotImplementedError

    @returns_new
    def translate(self, translation: ArrayLike, relative: bool = True) -> Self:
        """Moved by a vector [m]; with `relative=False`, its middle (`get_center`) moved there.

        Raises:
            ValueError: Not three finite numbers.

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
        """Turned about a point [m], about its middle (`get_center`) if none is given.

        Raises:
            ValueError: R is no rotation matrix [3, 3], or the centre not three finite numbers.
        """
        T = np.eye(4)
        try:
            T[:3, :3] = check_shape("R", R, (3, 3))
        except ValueError as error:  # an angle, or three
            raise ValueError(
                f"{error}: a rotation matrix; scipy.spatial.transform.Rotation.from_euler('xyz', angles, "
                "degrees=True).as_matrix() makes one"
            ) from None
        return self._mapped("center", map_about(check_rigid("R", T)[:3, :3], self._middle(center)))

    @returns_new
    def scale(self, scale: float, center: ArrayLike | None = None) -> Self:
        """Scaled about a point [m], about its middle (`get_center`) if none is given; normals stay.

        A cloud or mesh made so has no known unit; `to_unit` converts lengths.

        Raises:
            ValueError: The factor is not above zero, or the centre not three finite numbers.
        """
        factor = check_positive("scale", scale, maximum=LARGEST_NUMBER)
        return self._mapped("scale, center", map_about(factor * np.eye(3), self._middle(center)))

    def _middle(self, center: ArrayLike | None) -> NDArray[np.float64]:
        return self._finite_center() if center is None else check_finite("center", check_shape("center", center, (3,)))


def map_about(A: NDArray[np.float64], center: NDArray[np.float64], step: Any = 0.0) -> NDArray[np.float64]:
    """The 4x4 map that applies A about a point, and then a step."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = A, center - matmul(A, center) + np.asarray(step, np.float64)
    return T
