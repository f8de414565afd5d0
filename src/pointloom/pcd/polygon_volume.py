"""SelectionPolygonVolume: a polygon swept along an axis, as in Open3D's JSON, for cropping."""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import Protocol, Self, TypeVar

import numpy as np
import warp as wp
from numpy.typing import ArrayLike, NDArray

from ..cameras.camera import LARGEST_NUMBER
from ..core.array_libraries import hand_out, library_of, view_as
from ..core.atomic import atomic_write
from ..core.checks import check_number, check_rows, is_on_gpu
from ..core.devices import resolve_device
from ..core.errors import FileError
from ..core.gpu_arrays import take_rows
from ..core.json_files import check_keys, read_json_object
from ..kernels.arrays.select import invert_mask, positions_of
from ..kernels.extent.polygons import mask_polygon
from ..kernels.lang import float64, vec2d, vec3d
from ..kernels.memory import cast, upload
from .bounding_box import BOX_REMEDY, BoundingBox
from .point_arrays import PointArrays, check_cloud

# Coordinates u and v of the polygon's plane, and the axis.
AXIS_ORDERS = {"X": (1, 2, 0), "Y": (0, 2, 1), "Z": (0, 1, 2)}
MIN_CORNERS = 3
_KEYS = frozenset(
    ("class_name", "version_major", "version_minor", "bounding_polygon", "orthogonal_axis", "axis_min", "axis_max")
)


class Croppable(Protocol):
    """A cloud."""

    def crop(self, bounding_box: SelectionPolygonVolume, invert: bool = False) -> Self: ...


Cloud = TypeVar("Cloud", bound=Croppable)


@dataclass(frozen=True, init=False, eq=False)
class SelectionPolygonVolume:
    """A polygon swept along a coordinate axis. Selects the same points as Open3D.

    Even-odd rule in float64 world coordinates. Both ends of the axis are inclusive. Points on a lower or left edge are
    outside, on an upper or right edge inside. Points that are not finite are outside.

    Args:
        bounding_polygon: Corners [m], shape (m, 3), at least three. The coordinate along the axis is ignored.
        orthogonal_axis: "X", "Y" or "Z".
        axis_min, axis_max: Range along the axis [m].

    Raises:
        ValueError: If there are fewer than three corners, a number is not finite or beyond 1e100, the axis is unknown,
            or axis_min exceeds axis_max.

    Example:
        >>> import pointloom as loom
        >>> volume = loom.SelectionPolygonVolume([[0, 0, 0], [4, 0, 0], [0, 4, 0]], "Z", axis_min=0, axis_max=2)
        >>> cloud = loom.PointCloud([[1, 1, 1], [3, 3, 1], [1, 1, 3]])
        >>> volume.crop_in_polygon(cloud).tolist(), len(volume.crop_point_cloud(cloud, invert=True))
        ([0], 2)
    """

    bounding_polygon: NDArray[np.float64]
    orthogonal_axis: str
    axis_min: float
    axis_max: float

    def __init__(self, bounding_polygon: ArrayLike, orthogonal_axis: str, axis_min: float, axis_max: float):
        corners = check_rows("bounding_polygon", bounding_polygon, 3, dtype=np.float64)
        if len(corners) < MIN_CORNERS:
            raise ValueError(f"bounding_polygon: expected at least three corners, got {len(corners)}")
        axis = str(orthogonal_axis).upper()
        if axis not in AXIS_ORDERS:
            raise ValueError(f"orthogonal_axis: expected 'X', 'Y' or 'Z', got {orthogonal_axis!r}")
        given = (("axis_min", axis_min), ("axis_max", axis_max))
        ends = np.array([check_number(name, end, allow_nan=True, allow_infinite=True) for name, end in given])
        for name, numbers in (("bounding_polygon", corners), ("axis_min, axis_max", ends)):
            if not (np.abs(numbers) <= LARGEST_NUMBER).all():
                raise ValueError(f"{name}: expected finite numbers up to {LARGEST_NUMBER:g}")
        if ends[0] > ends[1]:
            raise ValueError(f"axis_min, axis_max: expected min <= max, got {axis_min} and {axis_max}")
        object.__setattr__(self, "bounding_polygon", corners.copy())
        object.__setattr__(self, "orthogonal_axis", axis)
        object.__setattr__(self, "axis_min", float(ends[0]))
        object.__setattr__(self, "axis_max", float(ends[1]))

    @classmethod
    def from_json(cls, path: str | os.PathLike[str]) -> SelectionPolygonVolume:
        """Read a volume written by Open3D's viewer (K, then polygon selection) or `to_json`.

        Raises:
            FileError: If the file is not a valid SelectionPolygonVolume of version 1.0.
        """
        content = read_json_object(path)
        check_keys(path, content, required=_KEYS)
        for key, expected in (("class_name", cls.__name__), ("version_major", 1), ("version_minor", 0)):
            if content[key] != expected or isinstance(content[key], bool):
                raise FileError(path, f"expected {expected!r}, got {str(content[key])[:40]!r}", where=f"key {key}")
        corners = content["bounding_polygon"]
        if not isinstance(corners, list) or len(corners) < MIN_CORNERS:
            given = f"{len(corners)}" if isinstance(corners, list) else f"a {type(corners).__name__}"
            raise FileError(
                path, f"expected a list of at least three corners, got {given}", where="key bounding_polygon"
            )
        for row, corner in enumerate(corners):
            if not isinstance(corner, list) or len(corner) != 3:
                raise FileError(path, "expected a list of three numbers", where=f"key bounding_polygon[{row}]")
            for value in corner:
                _check_number(path, value, f"bounding_polygon[{row}]")
        for key in ("axis_min", "axis_max"):
            _check_number(path, content[key], key)
        try:
            return cls(corners, content["orthogonal_axis"], content["axis_min"], content["axis_max"])
        except (TypeError, ValueError) as error:
            raise FileError(path, str(error)) from error

    def to_json(self, path: str | os.PathLike[str]) -> None:
        """Write the volume as Open3D's JSON without loss of digits. Replaces an existing file.

        Raises:
            FileError: If the file cannot be written.

        Example:
            >>> import pointloom as loom
            >>> volume = loom.SelectionPolygonVolume([[0, 0, 0], [4, 0, 0], [0, 4, 0]], "Z", axis_min=0, axis_max=2)
            >>> volume.to_json("corner.json")
            >>> loom.SelectionPolygonVolume.from_json("corner.json").bounding_polygon[1].tolist()
            [4.0, 0.0, 0.0]
        """
        content = {
            "axis_max": self.axis_max,
            "axis_min": self.axis_min,
            "bounding_polygon": self.bounding_polygon.tolist(),
            "class_name": type(self).__name__,
            "orthogonal_axis": self.orthogonal_axis,
            "version_major": 1,
            "version_minor": 0,
        }
        with atomic_write(path) as file:
            file.write(json.dumps(content, indent=4).encode() + b"\n")

    def crop_point_cloud(self, cloud: Cloud, invert: bool = False) -> Cloud:
        """Points of a cloud inside the volume, or with `invert` all others. As `cloud.crop(volume)`."""
        check_cloud("cloud", cloud)
        return cloud.crop(self, invert)

    def crop_in_polygon(self, points: PointArrays | ArrayLike, invert: bool = False) -> NDArray[np.int32]:
        """Ascending indices of the points inside the volume, or with `invert` of all others.

        Args:
            points: A cloud, or an array of shape (n, 3), processed in float64 on the CPU.
            invert: Return the points outside.

        Raises:
            ValueError, TypeError: If the array has a wrong shape or is not numeric.
        """
        if isinstance(points, PointArrays):
            mask, library = mask_volume(self, points.arrays["points"], points.origin), points.array_library
        else:
            mask = mask_volume(self, _wide(points), np.zeros(3))
            library = library_of(points)
        return hand_out(positions_of(invert_mask(mask) if invert else mask), library)


def _wide(points: ArrayLike) -> wp.array:
    """Positions (n, 3) as vec3d, on their GPU or the CPU."""
    if is_on_gpu(points):
        rows = take_rows("points", points, 3)
        return view_as(cast(rows, float64), vec3d, (rows.shape[0],))
    return upload(check_rows("points", points, 3, dtype=np.float64), vec3d, resolve_device("cpu"))


def mask_volume(volume: SelectionPolygonVolume, points: wp.array, origin: NDArray[np.float64]) -> wp.array:
    """uint8 (n,) on the device of the points (vec3 about an origin, or vec3d). 1 inside the volume."""
    axes = AXIS_ORDERS[volume.orthogonal_axis]
    corners = upload(volume.bounding_polygon[:, axes[:2]], vec2d, points.device)
    return mask_polygon(points, origin, corners, axes, volume.axis_min, volume.axis_max)


def mask_cropped(bounding_box: object, points: wp.array, origin: NDArray[np.float64]) -> wp.array:
    """`mask_volume` of a box or a volume. TypeError for others."""
    if isinstance(bounding_box, BoundingBox):
        return bounding_box.mask_points(points, origin)
    if isinstance(bounding_box, SelectionPolygonVolume):
        return mask_volume(bounding_box, points, origin)
    raise TypeError(f"bounding_box: expected a bounding box, got {type(bounding_box).__name__}; {BOX_REMEDY}")


def _check_number(path: str | os.PathLike[str], value: object, key: str) -> None:
    if isinstance(value, bool) or not isinstance(value, int | float) or abs(value) > LARGEST_NUMBER:
        raise FileError(path, f"expected a finite number, got {str(value)[:40]!r}", where=f"key {key}")
