"""Frames of a recording as images: one view for all, labels above, plots below."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.devices import DeviceLike, resolve_device
from ...core.progress import ReportProgress, ignore_progress
from ...kernels.lang import int32, vec3
from ...kernels.linear_algebra import matmul
from ...kernels.memory import empty, upload
from ..render.canvas import Canvas
from ..render.legends import cut_text, letter_size
from ..render.open3d_views import OPEN3D_KEYS
from ..render.parts import Lines, Part, Points, Triangles, Triple
from ..render.render import open3d_parameters
from ..render.scene import Scene
from ..render.view import View, ViewLike, fit_view
from .script import Look
from .shapes import spread_rows
from .timeline import Frame, Shape, Timeline

Picture = NDArray[np.uint8]

LOOKED_AT = 1_000  # positions of each shape for fitting the view
# Points beyond FAR times the distance within which most are located may be outside the view: far hits of a scanner.
MAX_DISTANCE_RATIO, GAP_QUANTILE, MIN_POINTS = 2.5, 0.8, 50
PLOT_HEIGHT_FRACTION = 0.22  # of the height, for plots
MAX_PLOTS = 4  # plots side by side. More values are omitted
MIN_STRIP, MIN_PANEL = 40, 80  # [px] minimum readable size
PAST_COLOR, FULL_CURVE, PLOT_BACKGROUND = (0.1, 0.35, 0.75), (0.78, 0.8, 0.83), (1.0, 1.0, 1.0)


def view_frames(timeline: Timeline, look: Look | None, width: int, height: int) -> View:
    """The closest view in world coordinates that shows all frames; `look` is a direction and up, None the default."""
    points = _seen_points(timeline, _core)
    options: dict[str, Any] = {} if look is None else {"direction": look[0], "up": look[1]}
    view = fit_view(points, **options, width=width, height=_picture_height(timeline, width, height))
    T = view.T_world_camera.copy()
    T[:3, 3] += timeline.origin
    return dataclasses.replace(view, T_world_camera=T)


def find_view(view: View | Mapping[str, Any] | None, timeline: Timeline, look: Any, width: int, height: int) -> View:
    """The view of a recording: as given, from Open3D's parameters, or showing all frames."""
    if view is None:
        return view_frames(timeline, look, width, height)
    return view if isinstance(view, View) else _view_by_parameters(timeline, view, width, height)


def check_look(view: ViewLike) -> View | dict[str, Any] | None:
    """Validate a view, or Open3D's parameters of one on a test box."""
    if view is None or isinstance(view, View):
        return view
    if not isinstance(view, Mapping):
        raise TypeError(
            f"view: expected a View, a mapping with {', '.join(OPEN3D_KEYS)}, or None, got {type(view).__name__}"
        )
    given = open3d_parameters("view", view)
    View.from_open3d((np.zeros(3), np.ones(3)), **given)
    return given


def _view_by_parameters(timeline: Timeline, given: Mapping[str, Any], width: int, height: int) -> View:
    """The view with Open3D's parameters for the bounds of all frames."""
    points = _seen_points(timeline, lambda shape: shape.positions.astype(np.float64))
    bounds = (points.min(axis=0), points.max(axis=0)) if len(points) else (np.zeros(3), np.zeros(3))
    low, high = (end + timeline.origin for end in bounds)
    return View.from_open3d((low, high), width=width, height=_picture_height(timeline, width, height), **given)


def _seen_points(timeline: Timeline, points_of: Callable[[Shape], NDArray[np.float64]]) -> NDArray[np.float64]:
    """Sample of the points of all frames relative to the timeline's origin."""
    samples: dict[int, NDArray[np.float64]] = {}
    seen: dict[tuple[int, bytes], NDArray[np.float64]] = {}
    for frame in timeline.frames:
        for placement in frame.shown.values():
            for number in placement.shapes:
                key = number, b"" if placement.pose is None else placement.pose.tobytes()
                if key in seen:
                    continue
                if number not in samples:
                    samples[number] = points_of(timeline.shapes[number])
                points, T = samples[number], placement.pose
                seen[key] = points if T is None else matmul(points, T[:3, :3].T) + T[:3, 3]
    return np.concatenate([np.empty((0, 3)), *seen.values()])


class Film:
    """Renders the frames of a timeline from a view in world coordinates (its size is ignored)."""

    def __init__(
        self, timeline: Timeline, view: View, width: int, height: int, background: Triple, device: DeviceLike = None
    ):
        self.timeline, self.width, self.height, self.background = timeline, width, height, background
        self._names = _plotted(timeline, width, height)
        self._picture_height = _picture_height(timeline, width, height)
        self._stills = Stills(timeline, _sized(view, width, self._picture_height), background, device)
        self._plots = _Plots(timeline, self._names, width, height - self._picture_height, device)

    def __len__(self) -> int:
        return len(self.timeline.frames)

    def draw(self, number: int) -> Picture:
        """Render a frame, shape (height, width, 3), uint8."""
        frame = self.timeline.frames[number]
        canvas = self._stills.draw(frame)
        size = letter_size(canvas)
        texts = [text for text in (self.timeline.title, frame.label) if text]
        lines = [
            (cut_text(text, size, self.width - 2 * size), size, (1 + 1.5 * k) * size) for k, text in enumerate(texts)
        ]
        canvas.texts(lines, size=size, anchor="upper left", halo=self.background)
        picture = canvas.to_numpy()
        return np.vstack([picture, self._plots.draw(number)]) if self._names else picture

    def frames(self, report_progress: ReportProgress = ignore_progress) -> Iterator[Picture]:
        for number in range(len(self)):
            report_progress("drawing", number, len(self))
            yield self.draw(number)
        report_progress("drawing", len(self), len(self))


class _Plots:
    """The strip of plots. The static part is drawn once."""

    def __init__(self, timeline: Timeline, names: Sequence[str], width: int, height: int, device: DeviceLike):
        self._names, self._count = names, len(timeline.frames)
        self._values = [np.array([frame.values.get(name, math.nan) for frame in timeline.frames]) for name in names]
        self._panel, self._height = width / max(len(names), 1), height
        if not names:
            return
        self._ground = Canvas.blank(width, height, PLOT_BACKGROUND, device)
        self._size = letter_size(self._ground)
        self._limits = [_limits(values) for values in self._values]
        for k, values in enumerate(self._values):
            left, top, right, bottom = self._box(k)
            self._ground.rectangle(left, top, right - left, bottom - top, outline=FULL_CURVE)
            for run in _runs(self._plot_points(k, values)):
                self._ground.polyline(run, color=FULL_CURVE, width=1.5)

    def draw(self, number: int) -> Picture:
        canvas = self._ground.copy()
        for k, (name, values) in enumerate(zip(self._names, self._values, strict=True)):
            points = self._plot_points(k, values)
            for run in _runs(points[: number + 1]):
                canvas.polyline(run, color=PAST_COLOR, width=2.0)
            known = np.flatnonzero(np.isfinite(values[: number + 1]))
            left, top, right, _ = self._box(k)
            text = name
            if len(known):
                canvas.dots(points[known[-1]][None], radius=3.5, color=PAST_COLOR)
                text = f"{name}  {values[known[-1]]:.4g}"
            canvas.text(cut_text(text, self._size, right - left), left, top - 0.7 * self._size, size=self._size)
        return canvas.to_numpy()

    def _box(self, k: int) -> tuple[float, float, float, float]:
        size = self._size
        return k * self._panel + size, 1.6 * size, (k + 1) * self._panel - size, self._height - 0.6 * size

    def _plot_points(self, k: int, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Positions of values in the strip [px]. NaN for missing values."""
        left, top, right, bottom = self._box(k)
        low, high = self._limits[k]
        across = left + 4 + (right - left - 8) * np.arange(self._count) / max(self._count - 1, 1)
        down = bottom - 4 - (bottom - top - 8) * (values - low) / (high - low)
        return np.column_stack([across, down])


def _plotted(timeline: Timeline, width: int, height: int) -> list[str]:
    """Names of plotted values in the order of their first appearance."""
    if round(PLOT_HEIGHT_FRACTION * height / 2) * 2 < MIN_STRIP:
        return []
    names = dict.fromkeys(name for frame in timeline.frames for name in frame.values)
    return list(names)[: min(MAX_PLOTS, width // MIN_PANEL)]


def _picture_height(timeline: Timeline, width: int, height: int) -> int:
    """Number of rows above the plots; even if `height` is even."""
    return height - round(PLOT_HEIGHT_FRACTION * height / 2) * 2 if _plotted(timeline, width, height) else height


def _limits(values: NDArray[np.float64]) -> tuple[float, float]:
    finite = values[np.isfinite(values)]
    if not len(finite):
        return 0.0, 1.0
    low, high = float(finite.min()), float(finite.max())
    return (low, high) if high > low else (low - 0.5 * (abs(low) or 1), high + 0.5 * (abs(high) or 1))


def _runs(points: NDArray[np.float64]) -> list[NDArray[np.float64]]:
    known = np.isfinite(points).all(axis=1)
    ends = np.flatnonzero(np.diff(np.concatenate([[0], known.astype(int), [0]])))
    return [points[a:b] for a, b in ends.reshape(-1, 2).tolist() if b - a > 1]


def _core(shape: Shape) -> NDArray[np.float64]:
    """Sample of positions of a shape. For points without the farthest ones."""
    points = shape.positions[spread_rows(len(shape.positions), LOOKED_AT)].astype(np.float64)
    if shape.kind != "points" or len(points) < MIN_POINTS:
        return points
    gaps = np.linalg.norm(points - np.median(points, axis=0), axis=1)
    return points[gaps <= MAX_DISTANCE_RATIO * np.quantile(gaps, GAP_QUANTILE)]


def _sized(view: View, width: int, height: int) -> View:
    """The view for another image size, with at least the same visible width and height."""
    camera = view.intrinsic
    scale = min(width / camera.width, height / camera.height)
    changed = dataclasses.replace(
        camera,
        width=width,
        height=height,
        fx=camera.fx * scale,
        fy=camera.fy * scale,
        cx=(width - 1) / 2 + (camera.cx - (camera.width - 1) / 2) * scale,
        cy=(height - 1) / 2 + (camera.cy - (camera.height - 1) / 2) * scale,
    )
    return dataclasses.replace(view, intrinsic=changed)


class Stills:
    """Renders the frames of a timeline. Unchanged shapes stay on the device (None: CPU)."""

    def __init__(self, timeline: Timeline, view: View, background: Triple, device: DeviceLike):
        self._timeline, self._background, self._device = timeline, background, resolve_device(device)
        T = view.T_world_camera.copy()
        T[:3, 3] -= timeline.origin  # origin of the shapes, so that no large numbers are rounded
        self._view = dataclasses.replace(view, T_world_camera=T)
        self._parts: dict[int, Part] = {}

    def draw(self, frame: Frame) -> Canvas:
        """Image of a frame, as a Canvas."""
        placements = [(number, each.pose) for each in frame.shown.values() for number in each.shapes]
        wanted = {number for number, _ in placements}
        self._parts = {number: part for number, part in self._parts.items() if number in wanted}
        for number in sorted(wanted - set(self._parts)):
            self._parts[number] = _part(self._timeline.shapes[number], self._device)
        parts = [dataclasses.replace(self._parts[number], pose=pose) for number, pose in placements]
        camera = self._view.intrinsic
        picture = Scene(parts, self._device).draw(self._view).before(self._background)
        return Canvas(picture, camera.width, camera.height)


def _part(shape: Shape, device: Any) -> Part:
    red, green, blue = (np.array(shape.plain) / 255).tolist()
    none = empty(0, vec3, device)
    colors = none if shape.colors is None else upload(shape.colors / np.float32(255), vec3, device)
    normals = none if shape.normals is None else upload(shape.normals, vec3, device)
    positions, origin = upload(shape.positions, vec3, device), np.zeros(3)
    plain = red, green, blue
    if shape.kind == "points":
        return Points(positions, origin, colors, normals, size=shape.size, plain=plain)
    indices = upload(np.empty(0, np.int32) if shape.indices is None else shape.indices.ravel(), int32, device)
    if shape.kind == "lines":
        return Lines(positions, origin, indices, colors, width=shape.size, plain=plain)
    faces: dict[str, Any] = {"wireframe": shape.wireframe, "cull": shape.cull, "lit": not shape.unlit}
    return Triangles(positions, origin, indices, colors, normals, **faces, plain=plain)
