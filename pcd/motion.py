"""Moving a cloud, and anything that an affine map moves."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.checks import LARGEST_NUMBER, check_finite, check_positive, check_rigid, check_shape, check_transformation
from ..core.coordinates import FLOAT32_MAX, origin_under
from ..core.dropped_results import returns_new
from ..core.known_names import ToldNames
from ..kernels.algebra.transform import transform_covariances, transform_directions, transform_points
from ..kernels.lang import float32
from ..kernels.linear_algebra import inv, matmul
from .bounding import Bounding
from .units import unit_under


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


class Motion(Bounding, Movable):
    """The part of PointCloud that moves it."""

    @returns_new
    def transform(self, transformation: ArrayLike) -> Self:
        """The cloud under a 4x4 affine map, computed in float64; normals are turned, and keep their lengths.

        Covariances C become A C A^T, with A the map's 3x3 part (Open3D's are right for rotations alone). A map that
        changes lengths by more than rounding of a rotation may (1 %) leaves the cloud without a known unit.

        Raises:
            ValueError: Not finite, not invertible, or the last row is not (0, 0, 0, 1).
        """
        return self._mapped("transformation", check_transformation("transformation", transformation))

    # ------------------------------------------------------------------------------------------ internals

    def _mapped(self, name: str, T: NDArray[np.float64]) -> Self:
        """The cloud under an affine map; errors call it by the argument that it was made of."""
        A, t = T[:3, :3], T[:3, 3]
        moved = matmul(A, self._origin) + t
        origin = origin_under(name, A, t, *self._device_bounds(), moved)
        cloud = self._under(A, moved - origin, origin)
        cloud._unit = unit_under(self._unit, A)
        return cloud

    def _enlarged(self, factor: float) -> Self:
        reach = np.abs(np.array(self._device_bounds()) - self._origin).max() * factor
        if not reach <= FLOAT32_MAX:
            raise ValueError(f"unit: takes points {reach:.3g} from their origin, farther than float32 holds")
        return self._under(factor * np.eye(3), np.zeros(3), self._origin * factor)

    def _under(self, A: NDArray[np.float64], shift: NDArray[np.float64], origin: NDArray[np.float64]) -> Self:
        """The cloud about another origin, its arrays under a map from the old one to the new one."""
        arrays = dict(self._arrays)
        arrays["points"] = transform_points(arrays["points"], A, shift)
        is_shift = np.array_equal(A, np.eye(3))  # normals and covariances stay what they are
        if self.has_normals and not is_shift:
            arrays["normals"] = transform_directions(arrays["normals"], inv(A).T)
        if (
            not is_shift
            and "covariances" in arrays
            and arrays["covariances"].dtype == float32
            and arrays["covariances"].shape[1:] == (9,)
        ):
            arrays["covariances"] = transform_covariances(arrays["covariances"], A)
        cloud = self._with_arrays(arrays, grid=self.grid)
        cloud._origin = origin
        return cloud


def map_about(A: NDArray[np.float64], center: NDArray[np.float64], step: Any = 0.0) -> NDArray[np.float64]:
    """The 4x4 map that applies A about a point, and then a step."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = A, center - matmul(A, center) + np.asarray(step, np.float64)
    return T
