"""SIFT features of one picture, and mutual matches of two, by kernels of our own."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from ...core.checks import check_count, check_finite, check_numeric, check_positive, check_rows, check_shape
from ...core.devices import resolve_device
from ...kernels.keypoints.descriptors import WIDTH
from ...kernels.keypoints.mutual_matches import Descriptors, match_mutually
from ...kernels.keypoints.sift import BYTES_A_PIXEL, FeatureFinder
from ...kernels.lang import uint8
from ...kernels.memory import check_room, upload
from .picture_folder import scaled_size

MAX_FEATURES = 4096
MAX_RATIO = 0.8  # of the distances of the nearest and the second feature (Lowe 2004)
MAX_DISTANCE = 0.7  # [rad] between two descriptors, as COLMAP has it

_LENGTH = 512.0  # of a descriptor
_MOST_FEATURES = 2**17
_MOST_PIXELS = 2**31 // 24 - 2**20  # six levels of twice the size are numbered by 31 bits
_LUMA = (0.2126, 0.7152, 0.0722, 0.0)  # ITU-R BT.709, as COLMAP makes pictures grey


@dataclasses.dataclass(frozen=True, eq=False)
class Keypoints:
    """Features of a picture.

    Args:
        positions: x and y, float32 [n, 2] [px], the middle of the first pixel being (0, 0).
        scales: How far the picture is blurred where each stands out, float32 [n] [px].
        orientations: The direction of most slopes around it, from x to y, float32 [n] [rad].
        descriptors: What it looks like, uint8 [n, 128], of length 512.
    """

    positions: NDArray[np.float32]
    scales: NDArray[np.float32]
    orientations: NDArray[np.float32]
    descriptors: NDArray[np.uint8]

    def __post_init__(self) -> None:
        """Check the shapes, and keep arrays of these types."""
        positions = check_finite("positions", check_rows("positions", self.positions, 2, dtype=np.float64))
        object.__setattr__(self, "positions", positions.astype(np.float32))
        for name in ("scales", "orientations"):
            values = check_finite(name, check_shape(name, getattr(self, name), (len(positions),)))
            object.__setattr__(self, name, values.astype(np.float32))
        descriptors = check_rows("descriptors", self.descriptors, WIDTH, rows=len(positions), dtype=np.uint8)
        object.__setattr__(self, "descriptors", descriptors)

    def __len__(self) -> int:
        """How many there are."""
        return len(self.positions)

    def __repr__(self) -> str:
        """Their number."""
        return f"Keypoints({len(self)})"


def detect_keypoints(
    picture: Any, *, max_features: int = MAX_FEATURES, max_size: int | None = None, mask: Any = None, device: Any = None
) -> Keypoints:
    """Find SIFT features (Lowe 2004) in a picture.

    Args:
        picture: uint8 [h, w] grey or [h, w, 3] RGB.
        max_features: Finer scales are left out once there are more features than this; each scale is taken whole, so
            that there may be more, and those with two orientations count once.
        max_size: The longer side is scaled down to this to find features [px]; None keeps the size.
        mask: bool [h, w]; no features where it is False. None for everywhere.
        device: Where to compute; None for the CPU.

    Returns:
        Features in pixels of the picture as given, from fine to coarse; none in an even or tiny picture.

    Raises:
        TypeError, ValueError: An argument out of range; a picture of other numbers than uint8, or with no pixel; a
            mask of another size; more than 88 million pixels after scaling.
        MemoryError: Too little memory on the device.
        DeviceError: No such device.

    Notes:
        The same bits on every device and from run to run. The numbers are COLMAP's and VLFeat's: a first octave of
        twice the size, three scales an octave and four octaves, differences of 0.0067, edges of 10, up to two
        orientations, RootSIFT (Arandjelovic and Zisserman 2012). Memory on the device: 300 B for each pixel.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> y, x = np.mgrid[:64, :64]
        >>> spot = 255 * np.exp(-((x - 30) ** 2 + (y - 40) ** 2) / 32)
        >>> loom.sfm.detect_keypoints(spot.astype(np.uint8)).positions[0].round(1)
        array([30., 40.], dtype=float32)
    """
    given = _checked_picture(picture)
    height, width = given.shape[:2]
    check_count("max_features", max_features, maximum=_MOST_FEATURES, because="matching takes its square")
    if max_size is not None:
        check_count("max_size", max_size, minimum=64, maximum=2**16, because="no camera has more pixels")
    seen = None if mask is None else _checked_mask(mask, (height, width))
    target = resolve_device(device)
    size = scaled_size((width, height), max_size)
    if size[0] * size[1] > _MOST_PIXELS:
        raise ValueError(f"picture: {size[0]} x {size[1]} are more than {_MOST_PIXELS:,} pixels; give a max_size")
    check_room(target, BYTES_A_PIXEL * size[0] * size[1], f"a scale space of {size[0]} x {size[1]} pixels")
    return KeypointFinder(size, target).find(np.ascontiguousarray(given), seen, int(max_features))


class KeypointFinder:
    """Finds features of pictures of one size after scaling, in arrays that are used for one after the other.

    Args:
        size: Width and height at which features are found [px].
        device: Where to compute.
    """

    def __init__(self, size: tuple[int, int], device: Any) -> None:
        self.size, self.device = size, device
        self.finder = FeatureFinder(*size, device)

    def find(self, picture: NDArray[np.uint8], mask: NDArray[np.bool_] | None, max_features: int) -> Keypoints:
        """The features of a picture, in its own pixels."""
        image = Image.fromarray(picture)
        grey = image.convert("L", _LUMA) if picture.ndim == 3 else image
        scaled = grey if grey.size == self.size else grey.resize(self.size, Image.Resampling.BILINEAR)
        seen = np.zeros(0, np.uint8)
        if mask is not None:
            marks = Image.fromarray(mask.view(np.uint8))
            seen = np.asarray(marks.resize(self.size, Image.Resampling.NEAREST), np.uint8).reshape(-1)
        pixels = np.asarray(scaled, np.uint8).reshape(-1)
        on_device = upload(pixels, uint8, self.device), upload(seen, uint8, self.device)
        features, descriptors = self.finder.find(*on_device, max_features)
        factors = np.array([grey.width / self.size[0], grey.height / self.size[1]])
        if grey.size != self.size:
            features[:, :2] = (features[:, :2] + 0.5) * factors - 0.5
            features[:, 2] *= factors.mean()
        scales, turns = (np.ascontiguousarray(features[:, k]) for k in (2, 3))
        return Keypoints(np.ascontiguousarray(features[:, :2]), scales, turns, descriptors)


def match_keypoints(
    a: Keypoints, b: Keypoints, *, max_ratio: float = MAX_RATIO, max_distance: float = MAX_DISTANCE, device: Any = None
) -> NDArray[np.int64]:
    """Match the features of two pictures: those that are each other's nearest, clearly nearer than the second.

    Args:
        a: Features of one picture.
        b: Features of the other.
        max_ratio: Of the distances of the nearest and the second, in both directions.
        max_distance: Of two descriptors [rad].
        device: Where to compute; None for the CPU.

    Returns:
        Rows of `a` and of `b`, int64 [k, 2], by row of `a`.

    Raises:
        TypeError, ValueError: No Keypoints; a limit out of range.
        DeviceError: No such device.

    Notes:
        All descriptors are compared, in whole numbers: the same matches on every device and from run to run. Ties go
        to the lower row.

    Example:
        >>> import numpy as np, pointloom as loom
        >>> y, x = np.mgrid[:64, :64]
        >>> spots = [255 * np.exp(-((x - u) ** 2 + (y - v) ** 2) / 32) for u, v in ((20, 20), (44, 40))]
        >>> keypoints = loom.sfm.detect_keypoints(sum(spots).astype(np.uint8))
        >>> bool((loom.sfm.match_keypoints(keypoints, keypoints)[:, 0] >= 0).all())
        True
    """
    for name, value in (("a", a), ("b", b)):
        if not isinstance(value, Keypoints):
            raise TypeError(f"{name}: expected Keypoints, got {type(value).__name__}")
    check_positive("max_ratio", max_ratio, maximum=1.0)
    check_positive("max_distance", max_distance, maximum=np.pi)
    pairs = np.array([[0, 1]], np.int64)
    return match_descriptors([a.descriptors, b.descriptors], pairs, resolve_device(device), max_ratio, max_distance)[0]


def match_descriptors(
    descriptors: Sequence[NDArray[np.uint8]],
    pairs: NDArray[np.int64],
    device: Any,
    max_ratio: float = MAX_RATIO,
    max_distance: float = MAX_DISTANCE,
) -> list[NDArray[np.int64]]:
    """Matches of pairs [p, 2] of pictures, as `match_keypoints` has them of each."""
    firsts = np.concatenate([[0], np.cumsum([len(each) for each in descriptors])]).astype(np.int64)
    features = Descriptors(firsts, np.concatenate(descriptors), device)
    most = int((2.0 * _LENGTH * np.sin(max_distance / 2)) ** 2)
    return match_mutually(features, pairs, ratio=max_ratio**2, most=most)


def _checked_picture(picture: Any) -> NDArray[np.uint8]:
    """A picture as an array."""
    array = check_numeric("picture", picture)
    if array.dtype != np.uint8:
        raise TypeError(f"picture: expected numbers of type uint8, got {array.dtype}; scale brightness to 0..255")
    if array.ndim not in (2, 3) or (array.ndim == 3 and array.shape[2] != 3) or 0 in array.shape:
        raise ValueError(f"picture: expected shape [h, w] or [h, w, 3], got {list(array.shape)}")
    return array


def _checked_mask(mask: Any, shape: tuple[int, int]) -> NDArray[np.bool_]:
    """A mask as a contiguous array."""
    array = check_numeric("mask", mask)
    if array.dtype != np.bool_:
        raise TypeError(f"mask: expected bool, got {array.dtype}; give mask != 0")
    if array.shape != shape:
        raise ValueError(f"mask: expected shape {list(shape)} as the picture has it, got {list(array.shape)}")
    return np.ascontiguousarray(array)
