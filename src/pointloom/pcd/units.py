"""`InUnit`: unit of length and coordinate system of clouds and meshes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from ..core.checks import RIGID_TOLERANCE
from ..core.coordinate_systems import CoordinateSystem, Reprojection, check_crs, common_crs, is_in_degrees
from ..core.dropped_results import returns_new
from ..core.units import DEGREE, LengthUnit, check_unit, common_unit, unit_by_name
from ..kernels.linear_algebra import matmul


class HasReference(Protocol):
    """A cloud, a mesh or a table with a unit of length and a coordinate system."""

    @property
    def unit(self) -> LengthUnit | None: ...
    @property
    def crs(self) -> CoordinateSystem | None: ...


class InUnit:
    """An object with a unit of length and a coordinate reference system."""

    _unit: LengthUnit | None = None
    _crs: CoordinateSystem | None = None

    @property
    def crs(self) -> CoordinateSystem | None:
        """Coordinate reference system, from a file or assigned: "EPSG:25832", 25832 or WKT. None if unknown.

        Operations keep it. If two objects with different systems meet, a ValueError names both. Assignment changes no
        coordinate. See `reproject`.

        Raises:
            TypeError, ValueError: If the assigned value is not a coordinate system.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[412300.0, 5651200.0, 120.0]])
            >>> cloud.crs = 25832
            >>> cloud.crs.name, cloud[:1].crs.epsg
            ('EPSG:25832', 25832)
        """
        return self._crs

    @crs.setter
    def crs(self, value: str | int | CoordinateSystem | None) -> None:
        self._crs = check_crs("crs", value)

    @returns_new
    def reproject(self, epsg: str | int | CoordinateSystem) -> Self:
        """Transform to another coordinate system in float64, by pyproj on the CPU (`pip install "pointloom[geo]"`).

        Heights are transformed if both systems have a vertical part, otherwise they stay. Normals are rotated along.

        Args:
            epsg: The target: an EPSG code, "EPSG:25832+7837" with heights, well-known text, or a `CoordinateSystem`.

        Raises:
            TypeError: If `epsg` is not a coordinate system.
            ValueError: If `crs` is None, a system is unknown, points have no position in the target, the heights would
                be in another unit than x and y, or the cloud has covariances.
            PointloomError: If pyproj is not installed.

        Example:
            >>> import pointloom as loom
            >>> cloud = loom.PointCloud([[412300.0, 5651200.0, 120.0]], crs=25832)
            >>> moved = cloud.reproject(25833)
            >>> moved.points.round(2).tolist(), moved.crs.epsg
            ([[-8383.11, 5675515.08, 120.0]], 25833)
        """
        target = check_crs("epsg", epsg)
        if target is None:
            raise TypeError("epsg: expected a coordinate system such as 25832, got None")
        if self._crs is None:
            raise ValueError("crs: the coordinate system is unknown. Assign it first, as in cloud.crs = 25832")
        way = Reprojection(self._crs, target)
        result = self._reprojected(way)
        result.crs, result.unit = target, DEGREE if way.unit_name == "degree" else unit_by_name(way.unit_name)
        return result

    def _reprojected(self, way: Reprojection) -> Self:
        raise NotImplementedError

    @property
    def _in_degrees(self) -> bool:
        """True if x and y are degrees of longitude and latitude."""
        return is_in_degrees(self._unit, self._crs)

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
        """Convert coordinates, origin and covariances to another unit. Other attributes stay, `crs` becomes unknown.

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
        factor = self._unit.meters / new_unit.meters
        result = self._enlarged(factor)
        result.unit, result.crs = new_unit, self._crs if factor == 1 else None
        return result

    def _enlarged(self, factor: float) -> Self:
        raise NotImplementedError


def unit_under(unit: LengthUnit | None, A: NDArray[Any]) -> LengthUnit | None:
    """Unit after a map with the 3x3 part A. None if it changes lengths by more than rounding."""
    return unit if unit is None or _is_rigid(A) else None


def crs_under(crs: CoordinateSystem | None, A: NDArray[Any]) -> CoordinateSystem | None:
    """Coordinate system after a map with the 3x3 part A. None if it changes lengths by more than rounding."""
    return crs if crs is None or _is_rigid(A) else None


def _is_rigid(A: NDArray[Any]) -> bool:
    return bool(np.abs(matmul(A, A.T) - np.eye(3)).max() <= RIGID_TOLERANCE)


def common_reference(name: str, objects: Sequence[HasReference]) -> tuple[LengthUnit | None, CoordinateSystem | None]:
    """Common unit and coordinate system of objects that meet. Unknown ones adopt those of the others.

    Raises:
        ValueError: Two coordinate systems differ.

    Warns:
        UnitWarning: Two units differ.
    """
    return common_unit(name, (each.unit for each in objects)), common_crs(name, (each.crs for each in objects))
