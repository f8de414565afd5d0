"""`InUnit`: unit of length of clouds and meshes."""

from __future__ import annotations

from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ..core.checks import RIGID_TOLERANCE
from ..core.dropped_results import returns_new
from ..core.units import LengthUnit, check_unit
from ..kernels.linear_algebra import matmul


class InUnit:
    """An object with a unit of length."""

    _unit: LengthUnit | None = None

    @property
    def unit(self) -> LengthUnit | None:
        """Unit of the coordinates, such as "foot", from a file or assigned. None if unknown, treated as meters.

        Lengths in arguments and results use it. Assignment changes no coordinate. See `to_unit`.

        Raises:
            TypeError, ValueError: If the assigned value is not a known unit name or a `LengthUnit`.

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
        """Convert coordinates, origin and covariances to another unit. Other attributes stay.

        The origin is scaled in float64, the rest in float32: exact to 6e-8 of the distance from it.

        Args:
            unit: Such as "metre", "foot", "US survey foot", or a `LengthUnit`.

        Raises:
            TypeError: If `unit` is not a unit.
            ValueError: If a unit is unknown or degrees (see `project_to_utm`), or coordinates exceed float32.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[0, 0, 1000]], unit="US survey foot").to_unit("metre")
            >>> cloud.points.round(4).tolist(), cloud.unit.name
            ([[0.0, 0.0, 304.8006]], 'metre')
        """
        new_unit = check_unit("unit", unit)
        if new_unit is None:
            raise TypeError("unit: expected the name of a unit, got None")
        if self._unit is None:
            raise ValueError("unit: the unit of the cloud is unknown. Assign it first, as in cloud.unit = 'foot'")
        if self._unit.meters is None or new_unit.meters is None:
            raise ValueError(
                f"unit: cannot convert {self._unit} to {new_unit}, as degrees are not lengths. Use project_to_utm"
            )
        result = self._enlarged(self._unit.meters / new_unit.meters)
        result.unit = new_unit
        return result

    def _enlarged(self, factor: float) -> Self:
        raise NotImplementedError


def unit_under(unit: LengthUnit | None, A: NDArray[Any]) -> LengthUnit | None:
    """Unit after a map with the 3x3 part A. None if it changes lengths by more than rounding."""
    return unit if unit is None or np.abs(matmul(A, A.T) - np.eye(3)).max() <= RIGID_TOLERANCE else None
