"""Clouds put together: one behind another, and one colour for all points."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any, Self

from numpy.typing import ArrayLike

from ..core.checks import check_color, check_list
from ..core.devices import check_same_device
from ..core.dropped_results import returns_new
from ..core.units import common_unit
from ..kernels.arrays.concatenation import concatenate_points, concatenate_rows
from ..kernels.lang import vec3
from ..kernels.memory import full
from .point_arrays import PointArrays, check_cloud

_NO_SUM = (
    "a cloud and a {} cannot be added: cloud.translate(vector) moves it, cloud.points = array sets its points, and "
    "cloud + loom.PointCloud(array) adds points"
)
MAX_POINTS = 2**31 - 1  # rows are counted in 32 bits


class Composition(PointArrays):
    """The part of PointCloud that puts clouds together."""

    def __add__(self, other: Any) -> Self:
        """The points of both clouds, see `concatenate`."""
        if not isinstance(other, PointArrays):
            raise TypeError(_NO_SUM.format(type(other).__name__))
        return self.concatenate([self, other])

    def __radd__(self, other: Any) -> Self:
        """The cloud itself for 0, where `sum` begins."""
        if isinstance(other, int) and other == 0:
            return self.copy()
        raise TypeError(_NO_SUM.format(type(other).__name__))

    @classmethod
    def concatenate(cls, clouds: Iterable[PointArrays]) -> Self:
        """The points of several clouds, one behind the other.

        Of normals, colours and further attributes those are kept that all clouds have, as Open3D's `+` does; clouds
        without points have no say. The result takes the origin of the largest cloud, where most points lie, and the
        others are brought to it in float64. It has the unit of those whose unit is known; where these differ, a
        UnitWarning says so, and it has none. O(total) time and memory; a sum of many clouds copies again and again.

        Args:
            clouds: At least one, all on one device.

        Raises:
            ValueError: No cloud, an attribute whose columns differ, or more than 2^31 - 1 points.
            TypeError: Not clouds, or an attribute whose types differ.
            DeviceError: Clouds on different devices.

        Example:
            >>> import pointloom as loom
            >>> a = loom.PointCloud([[0, 0, 0]], ring=[1], time=[0.5])
            >>> b = loom.PointCloud([[5e5, 5.4e6, 0], [5e5, 5.4e6, 1]], ring=[2, 3])
            >>> both = loom.PointCloud.concatenate([a, b])
            >>> both["ring"].tolist(), list(both.attributes), both.points[2].tolist()
            ([1, 2, 3], ['ring'], [500000.0, 5400000.0, 1.0])
        """
        given = check_list("clouds", clouds, "point clouds")
        if not given:
            raise ValueError("clouds: expected at least one cloud, got none")
        for cloud in given:
            check_cloud("clouds", cloud)
            check_same_device("clouds", cloud.device, given[0].device)
        parts = [cloud for cloud in given if len(cloud)] or given[:1]
        total = sum(map(len, parts))
        if total > MAX_POINTS:
            raise ValueError(f"clouds: {total:,} points are more than 2^31 - 1; keep them in several clouds")
        unit = common_unit("clouds", (part.unit for part in parts))
        largest = max(parts, key=len)
        shifts = [part.origin - largest.origin for part in parts]
        arrays = {"points": concatenate_points([part._device_array("points") for part in parts], shifts)}
        for name in parts[0]._device_arrays:
            if name == "points" or not all(name in part for part in parts):
                continue
            rows = [part.array(name) for part in parts]
            _check_alike(name, rows)
            arrays[name] = concatenate_rows(rows)
        whole = cls._from_device_arrays(arrays, largest.origin, parts[0].array_library)
        whole.unit = unit
        return whole

    @returns_new
    def paint_uniform_color(self, color: ArrayLike) -> Self:
        """The cloud with one colour for all points.

        Args:
            color: Red, green and blue, 0..1; Open3D clips what lies outside, here it is an error.

        Raises:
            ValueError: Not three numbers, or outside 0..1.

        Example:
            >>> import pointloom as loom
            >>> loom.PointCloud([[0, 0, 0], [1, 1, 1]]).paint_uniform_color([1, 0.5, 0]).colors.tolist()
            [[1.0, 0.5, 0.0], [1.0, 0.5, 0.0]]
        """
        rgb = check_color("color", color)
        colors = full(len(self), vec3(*rgb.tolist()), vec3, self.device)
        return self._with_arrays({**self._arrays, "colors": colors}, grid=self.grid)


def _check_alike(name: str, rows: Sequence[Any]) -> None:
    first = rows[0]
    for values in rows:
        if values.dtype != first.dtype:
            found = f"{first.dtype.__name__} and {values.dtype.__name__}"
            raise TypeError(f"{name}: expected one type in all clouds, got {found}; convert one")
        if values.shape[1:] != first.shape[1:]:
            found = f"{[*first.shape[1:]]} and {[*values.shape[1:]]}"
            raise ValueError(f"{name}: expected as many columns in all clouds, got shapes [n, ...] with {found}")
