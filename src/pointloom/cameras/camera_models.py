"""Camera models with lens distortion: COLMAP's and Agisoft Metashape's.

Pixel centers are integers here, but at .5 in COLMAP and Metashape: `params` are stored as in their files.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.attribute_hints import nearest_name
from ..core.checks import (
    check_count,
    check_finite,
    check_fraction,
    check_list,
    check_name,
    check_number,
    check_numeric,
    shown,
)
from ..core.exchange import hand_back, on_host
from .camera import MAX_IN_ALL, MAX_PIXELS, PinholeCameraIntrinsic, check_camera, check_pixels
from .lens_projection import DIVISION, EQUIDISTANT, FIELD_OF_VIEW, PERSPECTIVE, UNIFIED, Lens

PIXEL_OFFSET = 0.5  # COLMAP's principal point minus pointloom's [px]
MIN_SIDE_FRACTION = 0.2  # of an undistorted side as a fraction of the original, as in COLMAP
MAX_SIDE_FRACTION = 2.0


class _Model(NamedTuple):
    number: int | None  # id in COLMAP's binary files, or None
    params: str
    terms: Callable[[list[float]], dict[str, Any]]  # lens terms from the parameters after the principal point


def _radial(k: list[float]) -> dict[str, Any]:
    return {"radial": (*k, *[0.0] * (4 - len(k)))}


def _fisheye(k: list[float]) -> dict[str, Any]:
    return {"kind": EQUIDISTANT, **_radial(k)}


def _opencv(k: list[float]) -> dict[str, Any]:
    return {**_radial(k[:2]), "tangential": tuple(k[2:])}


def _full_opencv(k: list[float]) -> dict[str, Any]:
    return {**_radial([*k[:2], k[4]]), "tangential": tuple(k[2:4]), "rational": tuple(k[5:])}


def _thin_prism(k: list[float]) -> dict[str, Any]:
    return {**_fisheye([*k[:2], *k[4:6]]), "tangential": tuple(k[2:4]), "prism": tuple(k[6:])}


def _metashape(k: list[float]) -> dict[str, Any]:
    return {**_radial(k[:4]), "tangential": (k[5], k[4])}  # p1 and p2 are swapped relative to OpenCV


MODELS = {
    "SIMPLE_PINHOLE": _Model(0, "f, cx, cy", _radial),
    "PINHOLE": _Model(1, "fx, fy, cx, cy", _radial),
    "SIMPLE_RADIAL": _Model(2, "f, cx, cy, k", _radial),
    "RADIAL": _Model(3, "f, cx, cy, k1, k2", _radial),
    "OPENCV": _Model(4, "fx, fy, cx, cy, k1, k2, p1, p2", _opencv),
    "OPENCV_FISHEYE": _Model(5, "fx, fy, cx, cy, k1, k2, k3, k4", _fisheye),
    "FULL_OPENCV": _Model(6, "fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, k5, k6", _full_opencv),
    "FOV": _Model(7, "fx, fy, cx, cy, omega", lambda k: {"kind": FIELD_OF_VIEW, "shape": (abs(k[0]), 0.0)}),
    "SIMPLE_RADIAL_FISHEYE": _Model(8, "f, cx, cy, k", _fisheye),
    "RADIAL_FISHEYE": _Model(9, "f, cx, cy, k1, k2", _fisheye),
    "THIN_PRISM_FISHEYE": _Model(10, "fx, fy, cx, cy, k1, k2, p1, p2, k3, k4, sx1, sy1", _thin_prism),
    "SIMPLE_DIVISION": _Model(12, "f, cx, cy, k", lambda k: {"kind": DIVISION, "shape": (k[0], 0.0)}),
    "DIVISION": _Model(13, "fx, fy, cx, cy, k", lambda k: {"kind": DIVISION, "shape": (k[0], 0.0)}),
    "SIMPLE_FISHEYE": _Model(14, "f, cx, cy", _fisheye),
    "FISHEYE": _Model(15, "fx, fy, cx, cy", _fisheye),
    "EUCM": _Model(16, "fx, fy, cx, cy, alpha, beta", lambda k: {"kind": UNIFIED, "shape": (k[0], k[1])}),
    "METASHAPE": _Model(None, "f, cx, cy, k1, k2, k3, k4, p1, p2, b1, b2", _metashape),
    "METASHAPE_FISHEYE": _Model(
        None, "f, cx, cy, k1, k2, k3, k4, p1, p2, b1, b2", lambda k: {"kind": EQUIDISTANT, **_metashape(k)}
    ),
}
MODEL_NUMBERS = {model.number: name for name, model in MODELS.items() if model.number is not None}
_SIDES = "no camera or panorama is larger"
UNSUPPORTED = {11: "RAD_TAN_THIN_PRISM_FISHEYE", 17: "EQUIRECTANGULAR"}  # COLMAP models of other families


@dataclasses.dataclass(frozen=True)
class CameraModel:
    """A camera with a lens distortion model.

    Args:
        model: COLMAP's SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, OPENCV_FISHEYE, FULL_OPENCV, FOV,
            SIMPLE_RADIAL_FISHEYE, RADIAL_FISHEYE, THIN_PRISM_FISHEYE, SIMPLE_DIVISION, DIVISION, SIMPLE_FISHEYE,
            FISHEYE or EUCM. METASHAPE or METASHAPE_FISHEYE (f, cx, cy, k1, k2, k3, k4, p1, p2, b1, b2).
        width: Columns [px].
        height: Rows [px].
        params: Parameters in COLMAP's order, as in its files: the image corner is (0, 0), so the principal point is
            that of pointloom + 0.5.

    Raises:
        TypeError: Not numbers.
        ValueError: An unknown model, a wrong parameter count, non-finite numbers, a focal length that is not positive,
            or a size out of range.

    Notes:
        Points outside the range where the distortion is monotonic, and rays 90 degrees or more off the axis, give NaN.
        With extreme tangential or prism factors (0.02 is large) two rays may share a pixel. One of them is returned.

    Example:
        >>> import pointloom as loom
        >>> camera = loom.CameraModel("SIMPLE_RADIAL", 640, 480, [500, 320, 240, -0.1])
        >>> camera.project([[0.5, 0, 1]]).round(3).tolist()
        [[563.25, 239.5]]
        >>> camera.unproject([[563.25, 239.5]]).round(6).tolist()
        [[0.5, 0.0, 1.0]]
    """

    model: str
    width: int
    height: int
    params: tuple[float, ...]

    def __post_init__(self):
        if check_name("model", self.model) not in MODELS:
            if self.model in UNSUPPORTED.values():
                raise ValueError(f"model: {self.model} is not supported. Undistort its images with COLMAP first")
            raise ValueError(f"model: unknown {shown(self.model)}{nearest_name(self.model, MODELS)}; {_known_models()}")
        for name in ("width", "height"):
            object.__setattr__(self, name, check_pixels(name, getattr(self, name)))
        if self.width * self.height > MAX_IN_ALL:
            raise ValueError(f"width, height: {self.width} x {self.height} pixels are more than 2^28; scale the camera")
        numbers = tuple(check_number("params", value) for value in check_list("params", self.params, "numbers"))
        names = MODELS[self.model].params
        if len(numbers) != len(names.split(", ")):
            raise ValueError(f"params: {self.model} takes {names}; got {len(numbers)} numbers")
        check_finite("params", np.array(numbers))
        object.__setattr__(self, "params", numbers)
        focal, (first, second) = self._lens.focal, self._lens.shape
        if self._lens.kind == FIELD_OF_VIEW and not abs(first) < math.pi:
            raise ValueError(f"params: expected omega between -pi and pi, got {first:g}; it is an angle [rad]")
        if self._lens.kind == UNIFIED and not (0 <= first <= 1 and second > 0):
            raise ValueError(f"params: expected alpha in 0..1 and beta > 0, got {first:g} and {second:g}")
        if not min(focal) > 1e-6:
            raise ValueError(f"params: expected focal lengths above 1e-6 px, got {focal[0]:g} and {focal[1]:g}")

    @cached_property
    def _lens(self) -> Lens:
        names, numbers = MODELS[self.model].params.split(", "), list(self.params)
        at = names.index("cx")
        fx, fy = numbers[0], numbers[at - 1]
        skew = 0.0
        terms = numbers[at + 2 :]
        if names[-1] == "b2":
            fx, skew, terms = fx + numbers[-2], numbers[-1], terms[:-2]
        center = (numbers[at] - PIXEL_OFFSET, numbers[at + 1] - PIXEL_OFFSET)
        across = max(abs(center[0]), abs(self.width - 1 - center[0])) / max(fx, 1e-300)
        down = max(abs(center[1]), abs(self.height - 1 - center[1])) / max(fy, 1e-300)
        given = {"kind": PERSPECTIVE, **MODELS[self.model].terms(terms)}
        return Lens(focal=(fx, fy), center=center, extent=math.hypot(across, down), skew=skew, **given)

    @property
    def is_pinhole(self) -> bool:
        """True if there is no distortion, so that images need no undistortion."""
        return self._lens.is_pinhole and self._lens.skew == 0

    @property
    def intrinsic(self) -> PinholeCameraIntrinsic:
        """The equivalent pinhole camera.

        Raises:
            ValueError: The lens has distortion. See `undistorted`.
        """
        if not self.is_pinhole:
            raise ValueError(f"model: expected a camera without distortion, got {self.model}. Use loom.undistort_image")
        (fx, fy), (cx, cy) = self._lens.focal, self._lens.center
        return PinholeCameraIntrinsic(self.width, self.height, fx, fy, cx, cy)

    @classmethod
    def from_intrinsic(cls, intrinsic: PinholeCameraIntrinsic) -> CameraModel:
        """The PINHOLE model of a pinhole camera.

        Raises:
            TypeError: No PinholeCameraIntrinsic.
        """
        check_camera("intrinsic", intrinsic)
        params = (intrinsic.fx, intrinsic.fy, intrinsic.cx + PIXEL_OFFSET, intrinsic.cy + PIXEL_OFFSET)
        return cls("PINHOLE", intrinsic.width, intrinsic.height, params)

    def project(self, points: ArrayLike) -> NDArray[np.float64]:
        """Project points to pixels, on the host.

        Args:
            points: In the camera frame (x right, y down, z forward), shape (n, 3).

        Returns:
            Columns and rows, shape (n, 2) [px], inside the image or not. NaN behind the camera or outside the lens. An
            array of the points' library, on their device.

        Raises:
            TypeError: Not numbers.
            ValueError: Another shape.

        Example:
            >>> import pointloom as loom
            >>> loom.CameraModel("PINHOLE", 640, 480, [500, 500, 320, 240]).project([[0, 0, 2], [0, 0, -2]]).tolist()
            [[319.5, 239.5], [nan, nan]]
        """
        given = _check_columns("points", points, 3)
        with np.errstate(all="ignore"):
            rays = given[:, :2] / given[:, 2:]
        rays[~(given[:, 2] > 0)] = np.nan
        return hand_back(self._lens.project(rays), points)

    def unproject(self, pixels: ArrayLike) -> NDArray[np.float64]:
        """Compute the rays of pixels by Newton's method, to 1e-12, on the host.

        Args:
            pixels: Columns and rows, shape (n, 2) [px].

        Returns:
            Rays with z = 1 in the camera frame, shape (n, 3). NaN where the lens has no inverse. An array of the
            library of the pixels, on their device.

        Raises:
            TypeError: Not numbers.
            ValueError: Another shape.

        Example:
            >>> import pointloom as loom
            >>> camera = loom.CameraModel("SIMPLE_RADIAL", 640, 480, [200, 320, 240, -0.2])  # turns 172 px off
            >>> camera.unproject([[319.5, 239.5], [519.5, 239.5]]).tolist()
            [[0.0, 0.0, 1.0], [nan, nan, nan]]
        """
        rays = self._lens.unproject(_check_columns("pixels", pixels, 2))
        depth = np.where(np.isfinite(rays[:, :1]), 1.0, np.nan)
        return hand_back(np.concatenate([rays, depth], axis=1), pixels)

    def undistorted(
        self, *, blank_fraction: float = 0.0, max_size: int | None = None, size: tuple[int, int] | None = None
    ) -> PinholeCameraIntrinsic:
        """The pinhole camera of the undistorted images.

        COLMAP's rule: focal lengths and the relative principal point stay. Each side is between the largest size
        without blank pixels (`blank_fraction` 0) and the smallest without loss (1), limited to 0.2 to 2 times the
        original.

        Args:
            blank_fraction: 0 to 1, position between the two sizes.
            max_size: Maximum side length [px]. Larger images are scaled down.
            size: Width and height [px] to resize to, ignoring proportions. Not with `max_size`.

        Returns:
            The camera, with integer pixel centers. A pinhole is unchanged.

        Raises:
            TypeError: Not numbers.
            ValueError: A number out of range, both sizes, or a lens without an inverse along a border.

        Example:
            >>> import pointloom as loom
            >>> camera = loom.CameraModel("SIMPLE_RADIAL", 640, 480, [500, 320, 240, -0.1])
            >>> straight = camera.undistorted()
            >>> straight.width, straight.height, straight.fx
            (668, 490, 500.0)
        """
        fraction = check_fraction("blank_fraction", blank_fraction)
        if max_size is not None and size is not None:
            raise ValueError("max_size, size: give one of them")
        longest = None if max_size is None else check_count("max_size", max_size, maximum=MAX_PIXELS, because=_SIDES)
        sides = None if size is None else _check_size(size)
        width, height = (self.width, self.height) if self.is_pinhole else _straight_size(self, fraction)
        (fx, fy), center = self._lens.focal, self._lens.center
        straight = PinholeCameraIntrinsic(self.width, self.height, fx, fy, *center)
        if (width, height) != (self.width, self.height):  # unchanged values stay bitwise equal
            cx = (center[0] + PIXEL_OFFSET) * width / self.width - PIXEL_OFFSET
            cy = (center[1] + PIXEL_OFFSET) * height / self.height - PIXEL_OFFSET
            straight = PinholeCameraIntrinsic(width, height, fx, fy, cx, cy)
        if longest is not None and longest < max(width, height):
            factor = longest / max(width, height)  # rounded down to whole pixels, as in COLMAP's Rescale
            sides = max(round(width * factor), 1), max(round(height * factor), 1)
        return straight if sides is None else _resized(straight, *sides)


def _straight_size(camera: CameraModel, blank_fraction: float) -> tuple[int, int]:
    """Width and height of the undistorted image at the lens's focal length."""
    width, height = camera.width, camera.height
    # in COLMAP's convention, for borders at 0 and width
    center = [value + PIXEL_OFFSET for value in camera._lens.center]
    rows, columns = np.arange(height, dtype=np.float64), np.arange(width, dtype=np.float64)
    lengths = []
    for axis, side, along in ((0, width, rows), (1, height, columns)):
        pixels = np.zeros((2, len(along), 2))
        pixels[:, :, 1 - axis], pixels[1, :, axis] = along, side - 1
        border_pixels = camera._lens.unproject(pixels.reshape(-1, 2))[:, axis].reshape(2, -1)
        border_pixels = border_pixels * camera._lens.focal[axis] + center[axis]
        if not np.isfinite(border_pixels).any(axis=1).all():
            name = ("left or right", "upper or lower")[axis]
            raise ValueError(f"params: {camera.model} has no inverse at the {name} border. Check the calibration")
        before, after = center[axis], side - PIXEL_OFFSET - center[axis]
        with np.errstate(all="ignore"):
            low, high = before / (before - np.nanmin(border_pixels[0])), after / (np.nanmax(border_pixels[1]) - before)
            min_ratio = min(low, high)
            max_ratio = max(
                before / (before - np.nanmax(border_pixels[0])), after / (np.nanmin(border_pixels[1]) - before)
            )
            scale = 1.0 / (min_ratio * blank_fraction + max_ratio * (1.0 - blank_fraction))
        scale = min(max(scale, MIN_SIDE_FRACTION), MAX_SIDE_FRACTION) if scale == scale else 1.0
        lengths.append(max(int(scale * side), 1))
    return lengths[0], lengths[1]


def _resized(camera: PinholeCameraIntrinsic, width: int, height: int) -> PinholeCameraIntrinsic:
    sx, sy = width / camera.width, height / camera.height
    cx, cy = (camera.cx + PIXEL_OFFSET) * sx - PIXEL_OFFSET, (camera.cy + PIXEL_OFFSET) * sy - PIXEL_OFFSET
    return PinholeCameraIntrinsic(width, height, camera.fx * sx, camera.fy * sy, cx, cy)


def _check_size(size: object) -> tuple[int, int]:
    sides = [check_pixels("size", side) for side in check_list("size", size, "two sides [px]")]
    if len(sides) != 2:
        raise ValueError(f"size: expected width and height, got {len(sides)} numbers")
    return sides[0], sides[1]


def _check_columns(name: str, values: object, width: int) -> NDArray[np.float64]:
    array = check_numeric(name, on_host(name, values))
    if array.size == 0 and len(array.shape) and array.shape[0] == 0:
        array = array.reshape(0, width)
    if array.ndim != 2 or array.shape[1] != width:
        raise ValueError(f"{name}: expected shape [n, {width}], got {list(array.shape)}")
    return array.astype(np.float64)


def _known_models() -> str:
    return f"known models: {', '.join(MODELS)}"
