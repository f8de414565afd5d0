"""Coordinates that are in a unit: `InUnit`, of clouds and meshes."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ..core.checks import RIGID_TOLERANCE
from ..core.dropped_results import returns_new
from ..core.units import LengthUnit, check_unit
from ..kernels.linear_algebra import matmul


class InUnit:
    """What has a unit of length."""

    _unit: LengthUnit | None = None

    @property
    def unit(self) -> LengthUnit | None:
        """The unit of the coordinates, such as "foot", as a file or you told it; None where it is not known.

        Lengths that operations take and give are in it. What is said where it is not known says metres. To assign a
        name changes no coordinate: `to_unit` does. It goes along through operations and files.

        Raises:
            TypeError: What is assigned is no text.
            ValueError: No unit has the assigned name; `LengthUnit` makes further ones.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 10000]])
            >>> cloud.unit = "ft"
            >>> cloud.unit.name, cloud.to_unit("metre").points.tolist()
            ('foot', [[0.0, 0.0, 3048.0]])
        """
        return self._unit

    @unit.setter
    def unit(self, value: str | LengthUnit | None) -> None:
        self._unit = check_unit("unit", value)

    @returns_new
    def to_unit(self, unit: str | LengthUnit) -> Self:
        """The same in another unit of length: coordinates and origin multiplied, covariances twice.

        Other values, such as an attribute that holds lengths, stay as they are.

        Args:
            unit: Such as "metre", "foot", "US survey foot", or a `LengthUnit`.

        Raises:
            TypeError: No name of a unit.
            ValueError: No such unit, the own is not known (assign `unit`), one of them is degrees (`project_to_utm`
                makes metres of these), or coordinates beyond float32.

        Notes:
            The origin is multiplied in float64, what counts from it in float32: exact to 6e-8 of the distance from it.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 1000]], unit="US survey foot").to_unit("metre")
            >>> cloud.points.round(4).tolist(), cloud.unit.name
            ([[0.0, 0.0, 304.8006]], 'metre')
        """
        wanted = check_unit("unit", unit)
        if wanted is None:
            raise TypeError("unit: expected the name of a unit, got None")
        if self._unit is None:
            raise ValueError("unit: the own unit is not known; assign it first, as in cloud.unit = 'foot'")
        if self._unit.metres is None or wanted.metres is None:
            raise ValueError(f"unit: {self._unit} to {wanted}: degrees are no lengths; project_to_utm makes metres")
        result = self._enlarged(self._unit.metres / wanted.metres)
        result._unit = wanted
        return result

    def _enlarged(self, factor: float) -> Self:
        """With all lengths multiplied, about zero."""
        raise NotImplementedError


def unit_under(unit: LengthUnit | None, A: NDArray[Any]) -> LengthUnit | None:
    """The unit behind a map with the 3x3 part A: none where it changes lengths by more than rounding may."""
    return unit if np.abs(matmul(A, A.T) - np.eye(3)).max() <= RIGID_TOLERANCE else None
