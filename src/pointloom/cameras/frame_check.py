"""Checks of depth camera images that need no motion: `FrameCheck`.

The edges of depth are also edges of color if both images show the same view. The mean color gradient at the depth edges
is compared over mirrored images, scales about the center, and shifts. The steps between depth values of structured
light grow with the squared depth, by a factor that all such sensors share, which determines the depth unit.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..core.reports import failed
from .camera import PinholeCameraIntrinsic

Floats = NDArray[np.float64]

MAX_FRAMES = 8  # sampled frames
CELL_COLUMNS = 160  # cells of a row: 4 px of 640
MIN_JUMP = 0.08  # relative depth difference of neighboring cells at an edge
STRONG_PERCENTILE = 90.0  # of the gradients of an image: those above it are equal
MAX_SHIFT = 8  # [cells] tested shifts: 5% of the width
TESTED_SCALES = np.array([0.625, 0.68, 0.74, 0.8, 0.85, 0.9, 0.95, 1.0, 1.05, 1.11, 1.18, 1.25, 1.35, 1.47, 1.6])
MIN_EDGES, MIN_IN_VIEW = 800, 0.25  # cells, and fraction of them in the color image
# Registered: five recordings within 2 cells, of which a moving camera shifts one by time, scale 1.
MAX_REGISTERED_SHIFT, MAX_REGISTERED_SCALE = 3, 0.06
# Colors of such a scale hardly affect poses: those of the kitchen, of an unregistered Kinect, fit at 0.9 (2026-11-29).
MAX_HARMLESS_SCALE = 1.15
MIN_PEAK = 4.0  # excess of the best fit over the median of all, in standard deviations of all
MAX_REGISTERED_RATIO = 0.6  # of the excess of the images as given to that of the best fit
FLIP_SIGNS = {
    "": (1, 1),
    "mirrored left-right": (1, -1),
    "mirrored upside down": (-1, 1),
    "rotated by 180 degrees": (-1, -1),
}

# Usual step of the depth by squared depth [1/m] of structured light: Kinects of four recordings 0.0027 to 0.0029, an
# Xtion 0.0036 (2026-11-29). A wrong unit multiplies it. Stereo cameras of 640 px have 0.0009 to 0.0016 by their data.
USUAL_STEP = 0.003
UNITS_PER_METER = (1000.0, 5000.0)  # per meter, of such sensors: millimeters, and the unit of TUM
MAX_UNIT_ERROR, MIN_SCALE_ERROR = 1.25, 2.0  # factors: of the estimated unit, and of a wrong one
MAX_STRUCTURED_LIGHT_WIDTH = 640  # [px] stereo cameras with larger images have steps of 0.0006
MIN_STEPS, MAX_STEP_SPREAD = 40, 0.12  # number of steps, and their median relative deviation
MIN_STEP_VALUES = 3  # units of the smallest step: rounding hides smaller ones

# Real depth cameras have their principal point within 5 % of the size from the center. One farther off probably belongs
# to images of another size.
MAX_FROM_MIDDLE, MAX_SWAPPED_FROM_MIDDLE = 0.15, 0.05
FIELDS_OF_VIEW = (10.0, 150.0)  # [degrees] plausible for a pinhole camera


class _Sample(NamedTuple):
    """Depth [any unit] of cells, and the gray image of their pixels."""

    depth: NDArray[Any]
    gray: NDArray[Any]


class _Registration(NamedTuple):
    """How color is not registered to depth, and whether it affects poses."""

    problem: str | None = None
    is_severe: bool = False


class FrameCheck:
    """Keeps a few small frames of a stream, and checks whether their images and the camera belong together.

    Args:
        intrinsic: The camera of both images.
        depth_scale: Integer depth units per meter.
    """

    def __init__(self, intrinsic: PinholeCameraIntrinsic, depth_scale: float):
        self._intrinsic, self._depth_scale = intrinsic, depth_scale
        self._side = max(1, intrinsic.width // CELL_COLUMNS)
        self._samples: list[_Sample] = []
        self._steps: list[float] = []
        self._every, self._count = 1, 0
        self._pairing = -1, _Registration()

    def add(self, depth: ArrayLike | None, color: ArrayLike | None) -> None:
        """Add the next frame on the host. Others are skipped."""
        if self._count % self._every == 0 and isinstance(depth, np.ndarray) and depth.ndim == 2:
            if len(self._samples) == MAX_FRAMES:
                self._samples = self._samples[::2]
                self._every *= 2
            if len(self._steps) < MAX_FRAMES and depth.dtype.kind in "iu":
                self._steps.append(depth_step(depth) * self._depth_scale)
            if isinstance(color, np.ndarray) and color.shape[:2] == depth.shape:
                gray = color if color.ndim == 2 else color[..., min(1, color.shape[2] - 1)]
                self._samples.append(_Sample(depth[:: self._side, :: self._side].copy(), gray.copy()))
        self._count += 1

    @property
    def warnings(self) -> tuple[str, ...]:
        """Failed checks of the frames so far."""
        pairing = self._registered
        return failed(pairing.problem if pairing.is_severe else None, self._why_scaled())

    @property
    def notes(self) -> tuple[str, ...]:
        """A registration of color that is not exact, which affects colors, not poses."""
        pairing = self._registered
        return () if pairing.is_severe else failed(pairing.problem)

    @property
    def _registered(self) -> _Registration:
        if self._pairing[0] != self._count:
            self._pairing = self._count, _registration(self._samples, self._side)
        return self._pairing[1]

    def _why_scaled(self) -> str | None:
        known = [step for step in self._steps if np.isfinite(step)]
        if len(known) <= 0.5 * len(self._steps) or self._intrinsic.width > MAX_STRUCTURED_LIGHT_WIDTH:
            return None
        step, given = float(np.median(known)), self._depth_scale
        likely = min(UNITS_PER_METER, key=lambda unit: abs(math.log(unit * step / given / USUAL_STEP)))
        is_unit = max(likely * step / given / USUAL_STEP, given * USUAL_STEP / step / likely) < MAX_UNIT_ERROR
        if not is_unit or max(likely / given, given / likely) < MIN_SCALE_ERROR:
            return None
        return (
            f"depth_scale: depth values are {step:.2g} z^2 apart [m], which is usual with {likely:g} units per meter, "
            f"not with {given:g}; pass depth_scale={likely:g}"
        )


def why_implausible(camera: PinholeCameraIntrinsic) -> str:
    """Why a camera probably belongs to other images: its principal point or field of view. Empty if it is plausible."""
    size = np.array([camera.width, camera.height])
    off, off_if_swapped = (
        float((np.abs(np.array(center) - (size - 1) / 2) / size).max())
        for center in ((camera.cx, camera.cy), (camera.cy, camera.cx))
    )
    if off > MAX_FROM_MIDDLE:
        reason = f"its principal point ({camera.cx:g}, {camera.cy:g}) is far from the center of images of"
        likely = f"it may be for {2 * camera.cx:.0f} x {2 * camera.cy:.0f}"
        if off_if_swapped < MAX_SWAPPED_FROM_MIDDLE:
            likely = "cx and cy may be swapped"
        return f"{reason} {camera.width} x {camera.height}; {likely}"
    for name, length, focal in (("width", camera.width, camera.fx), ("height", camera.height, camera.fy)):
        view = float(2 * np.degrees(np.arctan(length / (2 * focal))))
        if not FIELDS_OF_VIEW[0] <= view <= FIELDS_OF_VIEW[1]:
            return f"its focal length {focal:g} gives a field of view of {view:.3g} degrees for a {name} of {length}"
    return ""


def depth_step(depth: NDArray[Any]) -> float:
    """Median of (next value - value) / value^2 of an integer depth image [1/unit]. NaN if this is not constant."""
    if depth.dtype == np.uint16:  # as below, without a conversion to 64 bits
        is_seen = np.zeros(65_536, bool)
        is_seen[depth.ravel()] = True
        seen = np.flatnonzero(is_seen)
    else:
        seen = np.flatnonzero(np.bincount(depth.ravel()))
    values = seen[1:-1].astype(np.float64)  # without none and the largest
    values = values[values < 60_000]
    if len(values) < MIN_STEPS:
        return np.nan
    steps, middle = np.diff(values), 0.5 * (values[1:] + values[:-1])
    is_known = steps >= MIN_STEP_VALUES
    if is_known.sum() < MIN_STEPS:
        return np.nan
    ratio = steps[is_known] / middle[is_known] ** 2
    median = float(np.median(ratio))
    return median if np.median(np.abs(ratio - median)) < MAX_STEP_SPREAD * median else np.nan


def _brightness(gray: NDArray[Any], side: int) -> NDArray[np.float32]:
    """Mean of the pixels of each whole cell, up to 255."""
    rows, columns = (side * (length // side) for length in gray.shape)
    pixels = (gray[v:rows:side, u:columns:side] for v in range(side) for u in range(side))
    total = sum(pixels, np.zeros((rows // side, columns // side), np.float32))
    return total * np.float32((255.0 if gray.dtype.kind == "f" else 1.0) / side**2)


def _edges(z: NDArray[np.float32]) -> NDArray[np.bool_]:
    """Cells on the near side of a jump in depth."""
    out = np.zeros(z.shape, bool)
    for one, two in ((np.s_[:-1], np.s_[1:]), (np.s_[:, :-1], np.s_[:, 1:])):
        a, b = z[one], z[two]
        is_jump = (a > 0) & (b > 0) & (np.abs(a - b) > MIN_JUMP * np.minimum(a, b))
        out[one] |= is_jump & (a < b)
        out[two] |= is_jump & (b < a)
    return out


def _scores(sample: _Sample, side: int) -> tuple[Floats, Floats, int]:
    """Sums of color gradients at depth edges by kind and scale, and shift, with the edges in view; and their number."""
    shade = _brightness(sample.gray, side)
    depth = sample.depth[: shade.shape[0], : shade.shape[1]].astype(np.float32)
    is_edge = _edges(np.nan_to_num(depth, posinf=0.0, neginf=0.0))
    gy, gx = np.gradient(shade)
    gradient = np.hypot(gx, gy)
    gradient = np.minimum(gradient / (np.percentile(gradient, STRONG_PERCENTILE) + 0.5), 1.0)
    (v, u), (rows, columns) = np.nonzero(is_edge), is_edge.shape
    gradient, size = gradient - gradient.mean(), 2 * MAX_SHIFT + 1
    sums, seen = (
        np.zeros((len(FLIP_SIGNS) + len(TESTED_SCALES) - 1, size * size)),
        np.zeros(len(FLIP_SIGNS) + len(TESTED_SCALES) - 1),
    )
    pad = MAX_SHIFT
    offsets = (np.arange(size)[:, None] * (columns + 2 * pad) + np.arange(size)).ravel()
    for k, (signs, scale) in enumerate(_hypotheses()):
        x = np.rint((columns - 1) / 2 + (u - (columns - 1) / 2) * scale).astype(int)
        y = np.rint((rows - 1) / 2 + (v - (rows - 1) / 2) * scale).astype(int)
        keep = (x >= 0) & (x < columns) & (y >= 0) & (y < rows)
        padded = np.pad(gradient[:: signs[0], :: signs[1]], pad)
        first = y[keep] * (columns + 2 * pad) + x[keep]
        seen[k] = keep.sum()
        sums[k] = padded.ravel()[first[:, None] + offsets].sum(axis=0) if keep.any() else 0.0
    return sums, seen, len(u)


def _hypotheses() -> list[tuple[tuple[int, int], float]]:
    """Signs of the axes, and scale. The images as given are the first."""
    return [(signs, 1.0) for signs in FLIP_SIGNS.values()] + [((1, 1), float(s)) for s in TESTED_SCALES if s != 1.0]


def _registration(samples: list[_Sample], side: int) -> _Registration:
    """Compare color with depth over flips, scales and shifts."""
    scores = [_scores(sample, side) for sample in samples]
    count = sum(number for *_, number in scores)
    if count < MIN_EDGES:
        return _Registration()
    seen = np.sum([one for _, one, _ in scores], axis=0)
    mean = np.sum([one for one, *_ in scores], axis=0) / np.maximum(seen, 1.0)[:, None]
    is_tested = seen >= MIN_IN_VIEW * count
    usual = float(np.median(mean[is_tested]))
    spread = 1.48 * float(np.median(np.abs(mean[is_tested] - usual)))
    excess = np.where(is_tested[:, None], (mean - usual) * np.sqrt(seen / count)[:, None], 0.0)
    kind, at = np.unravel_index(int(excess.argmax()), excess.shape)
    signs, scale = _hypotheses()[int(kind)]
    size = 2 * MAX_SHIFT + 1
    shift = np.array([int(at) % size - MAX_SHIFT, int(at) // size - MAX_SHIFT])
    near = np.abs(np.arange(size) - MAX_SHIFT) <= MAX_REGISTERED_SHIFT - 1
    given = float(excess[0].reshape(size, size)[np.ix_(near, near)].max())
    is_registered = signs == (1, 1) and abs(scale - 1.0) < MAX_REGISTERED_SCALE
    is_registered &= bool(np.abs(shift).max() < MAX_REGISTERED_SHIFT)
    best = float(excess.max())
    if is_registered or best < MIN_PEAK * spread or given > MAX_REGISTERED_RATIO * best:
        return _Registration()
    how = [next(name for name, its_signs in FLIP_SIGNS.items() if its_signs == signs)] if signs != (1, 1) else []
    how += [f"scaled by {scale:.2g}"] if scale != 1.0 else []
    how += [f"shifted by {shift[0] * side:d}, {shift[1] * side:d} px"] if np.abs(shift).max() > 1 else []
    is_severe = signs != (1, 1) or abs(np.log(scale)) > np.log(MAX_HARMLESS_SCALE)
    text = f"color and depth are not registered: the edges of depth fit the color image if they are {' and '.join(how)}"
    return _Registration(f"{text}; register color to depth before", bool(is_severe))
