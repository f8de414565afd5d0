"""The pinhole camera and Open3D's JSON files of it.

Pixel centers have integer coordinates: a point (x, y, z) [m] in the camera frame (x right, y down, z forward) projects
to u = fx x / z + cx, v = fy y / z + cy. No skew, no lens distortion.
"""

from __future__ import annotations

import dataclasses
import enum
import json
import os
from typing import Any, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.atomic import atomic_write
from ..core.attribute_hints import HintedNames
from ..core.checks import LARGEST_NUMBER as LARGEST_NUMBER
from ..core.checks import check_count, check_number, check_positive, check_shape
from ..core.dropped_results import returns_new
from ..core.errors import FileError
from ..core.json_files import check_keys, json_numbers, read_json_object
from ..core.paths import path_of

# Metadata keys of Open3D and its recorders that do not change the projection. Any other key raises,
# since it may (distortion coefficients, a crop).
_HARMLESS_KEYS = frozenset(
    (
        *("class_name", "version_major", "version_minor", "color_format", "color_mode", "depth_format", "depth_mode"),
        *("depth_scale", "device_name", "fps", "serial_number", "stream_length_usec"),
    )
)

MAX_PIXELS = 2**16  # maximum side: wider than any camera or panorama
MAX_SIDE_PER_FOCAL = 20.0  # image sides per focal length: 168 degrees
MAX_IN_ALL = 2**28  # maximum pixels: 2 GB at 8 B per pixel


def check_pixels(name: str, value: object) -> int:
    return check_count(name, value, maximum=MAX_PIXELS, because="no camera or panorama is larger; scale it")


class PinholeCameraIntrinsicParameters(enum.Enum):
    """Open3D's predefined cameras, for `PinholeCameraIntrinsic`.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.cameras.camera import PinholeCameraIntrinsicParameters
        >>> loom.PinholeCameraIntrinsic(PinholeCameraIntrinsicParameters.PrimeSenseDefault).get_focal_length()
        (525.0, 525.0)
    """

    PrimeSenseDefault = (640, 480, 525.0, 525.0, 319.5, 239.5)
    Kinect2DepthCameraDefault = (512, 424, 365.456, 365.456, 254.878, 205.395)
    Kinect2ColorCameraDefault = (1920, 1080, 1059.9718, 1059.9718, 975.7193, 545.9533)


@dataclasses.dataclass(frozen=True, init=False)
class PinholeCameraIntrinsic(HintedNames):
    """Size and projection of a pinhole camera.

    As in Open3D, also accepts one of `PinholeCameraIntrinsicParameters`, or the size and K:
    `PinholeCameraIntrinsic(640, 480, K)`.

    Args:
        width: Columns [px].
        height: Rows [px].
        fx: Focal length along x [px].
        fy: Focal length along y [px].
        cx: Column of the principal point [px]; may be outside the image, as in a crop.
        cy: Row of the principal point [px].

    Raises:
        TypeError: Not numbers.
        ValueError: A size or focal length that is not positive, a non-finite value, a side above 2^16 pixels, or more
            than 2^28 pixels.

    Example:
        >>> camera = PinholeCameraIntrinsic.prime_sense_default()
        >>> camera.width, camera.fx, camera.cx
        (640, 525.0, 319.5)
        >>> camera.scaled(0.5).cx
        159.5
    """

    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float

    @overload
    def __init__(self, width: PinholeCameraIntrinsicParameters) -> None: ...
    @overload
    def __init__(self, width: int, height: int, fx: ArrayLike) -> None: ...
    @overload
    def __init__(self, width: int, height: int, fx: float, fy: float, cx: float, cy: float) -> None: ...
    def __init__(
        self, width: Any = None, height: Any = None, fx: Any = None, fy: Any = None, cx: Any = None, cy: Any = None
    ):
        given: Any = (width, height, fx, fy, cx, cy)
        if isinstance(width, PinholeCameraIntrinsicParameters):
            given = width.value
        elif fx is not None and fy is None and cx is None and cy is None and np.ndim(fx) == 2:
            given = dataclasses.astuple(self.from_matrix(fx, width, height))
        missing = [field.name for field, value in zip(dataclasses.fields(self), given, strict=True) if value is None]
        if missing:
            raise TypeError(
                f"{', '.join(missing)}: missing; expected PinholeCameraIntrinsic(width, height, fx, fy, cx, cy), "
                "(width, height, K), (PinholeCameraIntrinsicParameters.PrimeSenseDefault), or "
                "PinholeCameraIntrinsic.read(path)"
            )
        for field, value in zip(dataclasses.fields(self), given, strict=True):
            object.__setattr__(self, field.name, value)
        self._check()

    def _check(self) -> None:
        for name in ("width", "height"):
            object.__setattr__(self, name, check_pixels(name, getattr(self, name)))
        if self.width * self.height > MAX_IN_ALL:
            raise ValueError(f"width, height: {self.width} x {self.height} pixels are more than 2^28; scale the camera")
        for name in ("fx", "fy"):
            object.__setattr__(self, name, check_positive(name, getattr(self, name)))
        for name in ("cx", "cy"):
            object.__setattr__(self, name, check_number(name, getattr(self, name)))

    @property
    def matrix(self) -> NDArray[np.float64]:
        """The calibration matrix K, shape (3, 3) [px]. A new array each time."""
        return np.array([[self.fx, 0.0, self.cx], [0.0, self.fy, self.cy], [0.0, 0.0, 1.0]])

    @property
    def intrinsic_matrix(self) -> NDArray[np.float64]:
        """Open3D's name of `matrix`."""
        return self.matrix

    def get_focal_length(self) -> tuple[float, float]:
        """The focal lengths (fx, fy) [px]."""
        return self.fx, self.fy

    def get_principal_point(self) -> tuple[float, float]:
        """The principal point (cx, cy) [px]."""
        return self.cx, self.cy

    def get_skew(self) -> float:
        """The skew [px], always 0."""
        return 0.0

    def is_valid(self) -> bool:
        """True: invalid cameras cannot be constructed."""
        return True

    @returns_new
    def set_intrinsics(
        self, width: int, height: int, fx: float, fy: float, cx: float, cy: float
    ) -> PinholeCameraIntrinsic:
        """Return a camera with these values. The object itself is immutable."""
        return PinholeCameraIntrinsic(width, height, fx, fy, cx, cy)

    @returns_new
    def scaled(self, factor: float) -> PinholeCameraIntrinsic:
        """The camera of images resized by `factor`, by area or interpolation.

        The size is rounded to pixels and each axis uses the resulting ratio: c' = (c + 0.5) factor - 0.5. (Open3D
        halves c itself, which is right for subsampling every second pixel.)

        Raises:
            ValueError: The factor is not positive, or leaves no pixel.
        """
        factor = check_positive("factor", factor)
        largest = MAX_PIXELS / max(self.width, self.height)
        if factor > largest:
            raise ValueError(f"factor: {factor} makes a side of more than 2^16 pixels; expected at most {largest:.4g}")
        width, height = round(self.width * factor), round(self.height * factor)
        if width < 1 or height < 1:
            raise ValueError(f"factor: {factor} leaves no pixel of a {self.width} x {self.height} image")
        sx, sy = width / self.width, height / self.height
        cx, cy = (self.cx + 0.5) * sx - 0.5, (self.cy + 0.5) * sy - 0.5
        return PinholeCameraIntrinsic(width, height, self.fx * sx, self.fy * sy, cx, cy)

    @classmethod
    def prime_sense_default(cls) -> PinholeCameraIntrinsic:
        """PrimeSense, Kinect v1 and Xtion cameras: 640 x 480, f 525, c (319.5, 239.5)."""
        return cls(PinholeCameraIntrinsicParameters.PrimeSenseDefault)

    @classmethod
    def kinect2_depth_default(cls) -> PinholeCameraIntrinsic:
        """The depth camera of Kinect v2: 512 x 424."""
        return cls(PinholeCameraIntrinsicParameters.Kinect2DepthCameraDefault)

    @classmethod
    def kinect2_color_default(cls) -> PinholeCameraIntrinsic:
        """The color camera of Kinect v2: 1920 x 1080."""
        return cls(PinholeCameraIntrinsicParameters.Kinect2ColorCameraDefault)

    @staticmethod
    def read(path: str | os.PathLike[str]) -> PinholeCameraIntrinsic:
        """Read a camera from Open3D's JSON.

        Reads `{"width", "height", "intrinsic_matrix"}` with the 9 numbers of K column by column, or the intrinsic of a
        PinholeCameraParameters object. Recorder metadata (`serial_number`, `depth_scale` and others) is ignored.
        Unknown keys raise, since they may change the projection.

        Raises:
            FileError: Unreadable, not JSON, or a key that is missing, unknown or out of range.

        Example:
            >>> import pointloom as loom
            >>> camera = loom.PinholeCameraIntrinsic(640, 480, 525.0, 525.0, 319.5, 239.5)
            >>> camera.write("camera.json")
            >>> loom.PinholeCameraIntrinsic.read("camera.json") == camera
            True
        """
        return read_pinhole_camera_intrinsic(path)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Write the camera as Open3D's JSON with all digits. An existing file is replaced.

        Raises:
            FileError: The file cannot be written.
        """
        write_pinhole_camera_intrinsic(path, self)

    @classmethod
    def from_matrix(cls, K: ArrayLike, width: int, height: int) -> PinholeCameraIntrinsic:
        """The camera with calibration matrix K, shape (3, 3) [px].

        Raises:
            ValueError: Another shape, a last row other than (0, 0, 1), skew, or values out of range.
        """
        K = check_shape("K", K, (3, 3))
        if not np.isfinite(K).all():
            raise ValueError("K: expected finite numbers, got NaN or infinite entries")
        if np.abs(K[2] - (0, 0, 1)).max() > 1e-9:
            raise ValueError(f"K: expected the last row (0, 0, 1), got {K[2].tolist()}")
        if K[0, 1] != 0 or K[1, 0] != 0:
            raise ValueError(f"K: expected no skew, got K[0, 1] = {K[0, 1]} and K[1, 0] = {K[1, 0]}")
        return cls(width, height, *(float(K[index]) for index in ((0, 0), (1, 1), (0, 2), (1, 2))))


def is_one_camera(value: object) -> bool:
    """True for a camera or a matrix [3, 3], not for a sequence of them."""
    if isinstance(value, list | tuple):
        return len(value) == 3 and all(np.shape(row) == (3,) for row in value)
    return isinstance(value, PinholeCameraIntrinsic) or getattr(value, "shape", None) == (3, 3)


def check_camera(name: str, camera: object, size: tuple[int, int] | None = None) -> PinholeCameraIntrinsic:
    """A camera. Its matrix [3, 3] is accepted if `size`, (width, height) of the images, is known."""
    if isinstance(camera, PinholeCameraIntrinsic):
        return camera
    if size is None or not (hasattr(camera, "shape") or isinstance(camera, list | tuple)):
        raise TypeError(
            f"{name}: expected a PinholeCameraIntrinsic, got {type(camera).__name__}; "
            "create one with PinholeCameraIntrinsic.from_matrix(K, width, height)"
        )
    try:
        result = PinholeCameraIntrinsic.from_matrix(check_shape(name, camera, (3, 3)), *size)
    except ValueError as error:
        raise ValueError(str(error) if str(error).startswith(name) else f"{name}: {error}") from None
    if result.fx * MAX_SIDE_PER_FOCAL < size[0] or result.fy * MAX_SIDE_PER_FOCAL < size[1]:
        raise ValueError(
            f"{name}: expected fx and fy in pixels, got {result.fx:g} and {result.fy:g}, a field of view of nearly "
            f"180 degrees at {size[0]} x {size[1]} pixels; pass a matrix in pixels or a PinholeCameraIntrinsic"
        )
    return result


def read_pinhole_camera_intrinsic(path: str | os.PathLike[str]) -> PinholeCameraIntrinsic:
    """Read a camera from Open3D's JSON, see `PinholeCameraIntrinsic.read`."""
    content = read_json_object(path)
    where = ""
    if "intrinsic" in content:
        check_keys(path, content, required={"intrinsic"}, optional=_HARMLESS_KEYS | {"extrinsic"})
        content, where = content["intrinsic"], "intrinsic."
        if not isinstance(content, dict):
            raise FileError(path, "expected an object", where="key intrinsic")
    keys = {"width", "height", "intrinsic_matrix"}
    check_keys(path, content, required=keys, optional=_HARMLESS_KEYS, where=where)
    K = read_json_matrix(path, content["intrinsic_matrix"], 3, where=f"key {where}intrinsic_matrix")
    try:
        return PinholeCameraIntrinsic.from_matrix(K, content["width"], content["height"])
    except (TypeError, ValueError) as error:
        remedy = "The matrix is stored column by column: [fx, 0, 0, 0, fy, 0, cx, cy, 1]"
        raise FileError(path, str(error), where=f"object {where[:-1]}" if where else "", remedy=remedy) from error


def write_pinhole_camera_intrinsic(path: str | os.PathLike[str], intrinsic: PinholeCameraIntrinsic) -> None:
    """Write a camera as Open3D's JSON, see `PinholeCameraIntrinsic.write`."""
    path = path_of(path)
    text = json.dumps(intrinsic_to_json(check_camera("intrinsic", intrinsic)), indent=4)
    with atomic_write(path) as file:
        file.write(text.encode() + b"\n")


def intrinsic_to_json(intrinsic: PinholeCameraIntrinsic) -> dict[str, Any]:
    columns = intrinsic.matrix.T.ravel().tolist()
    return {"width": intrinsic.width, "height": intrinsic.height, "intrinsic_matrix": columns}


def read_json_matrix(path: str | os.PathLike[str], values: object, side: int, *, where: str) -> NDArray[np.float64]:
    """The square matrix of a column-major JSON list."""
    numbers = json_numbers(path, values, side * side, where=where)
    return np.array(numbers, np.float64).reshape(side, side).T
