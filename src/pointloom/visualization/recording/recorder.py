"""Recording of the steps of algorithms: `record`."""

from __future__ import annotations

import contextlib
import dataclasses
import os
import warnings
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_name, check_number, check_progress, check_transformation
from ...core.escaped_text import escaped
from ...core.observers import watch
from ...core.paths import path_of
from ...core.progress import ReportProgress
from ...core.serialized import Serialized
from ..render.parts import Matrix, Triple
from ..render.styles import STYLE_KEYS, Style
from ..render.up_axis import direction_under, up_of_geometry
from ..render.view import View
from .film import Film, find_view
from .options import MAX_FRAMES, MAX_POINTS, RecordingOptions
from .script import Stage
from .scripts import Scripts
from .shapes import ShapeStore, Sketch, pose_about, sketch, usual_size
from .timeline import Frame, Placement, Timeline
from .writers import check_recording, write_recording

MAX_BYTES = 2**29  # of shapes; beyond it every second frame is dropped
NOTHING = (
    "nothing was recorded: no algorithm inside the block reports its steps, and step() was not called. Those that do "
    "are listed in docs/recordings.md; add(name, geometry) and step() make frames of anything"
)
# of the bytes stay after dropping frames: then the memory is not due to the number of frames
MAX_REMAINING_FRACTION = 0.9


def record(
    path: str | os.PathLike[str],
    *,
    fps: float = 10.0,
    size: tuple[int, int] = (960, 720),
    max_points: int = MAX_POINTS,
    max_frames: int = MAX_FRAMES,
    title: str = "",
    view: View | Mapping[str, Any] | None = None,
    background: Triple = (1.0, 1.0, 1.0),
    automatic: bool = True,
    overwrite: bool = True,
    progress: ReportProgress | None = None,
) -> Recorder:
    """Record the steps of algorithms inside a `with` block as a web page with a player, an animation or a video.

    The suffix of the path chooses the format. Rerun and Foxglove display .rrd and .mcap.

    Recorded automatically: iterations of ICP, fused and tracked frames, scans of LiDAR odometry, clusters, planes and
    registered fragments. Other frames are made with `add`, `update`, `set_pose`, `plot` and `step`.

    Args:
        path: A web page (.html: one file that plays from disk, with plots), an animation (.gif, or .mp4, which
            requires ffmpeg), or a recording for Rerun (.rrd: rerun-sdk) or Foxglove (.mcap: foxglove-sdk).
        fps: Frames per second, at most 50 for .gif.
        size: Width and height of an animation [px]; rounded to even numbers for a video.
        max_points: Clouds with more points are sampled and meshes with more vertices simplified, which the title
            reports.
        max_frames: If exceeded, every second frame is dropped, also of the following ones.
        title: Title above the frames.
        view: A View, or a mapping with Open3D's front, lookat, up, zoom, field_of_view as in `render`. If None,
            everything is visible in all frames.
        background: Red, green and blue, 0 to 1.
        automatic: Record algorithms that run inside the block.
        overwrite: Replace an existing file.
        progress: Called with "drawing", the number of finished frames and their total while an animation is written.

    Returns:
        A Recorder for a `with` block. The file is written at the end of the block.

    Raises:
        FileError: Unknown suffix, a path that cannot be written, or missing ffmpeg or package. Raised before any work.
        TypeError, ValueError: An argument is out of range.

    Notes:
        Results are bitwise identical with and without a recording, but ICP waits for the device once per iteration. If
        the block ends with an error or Ctrl-C, the frames until then are written and the title reports it. Without any
        frame, a warning is issued and no file is written. Other threads are not recorded. Unchanged shapes are stored
        once, up to 512 MB in total; beyond it frames are dropped as for `max_frames`.

    Example:
        >>> import os, tempfile, numpy as np, pointloom as loom
        >>> points = np.random.default_rng(0).random((200, 3))
        >>> target, source = loom.PointCloud(points), loom.PointCloud(points + 0.02)
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     with loom.record(f"{folder}/icp.html") as r:
        ...         result = loom.registration.registration_icp(source, target, 0.1)
        ...     os.listdir(folder), len(r.timeline.frames) == result.iterations + 1
        (['icp.html'], True)
    """
    options = RecordingOptions(fps, size, max_points, max_frames, title, view, background, overwrite)
    return Recorder(path_of(path), options, automatic=automatic, progress=progress)


class NothingRecordedError(ValueError):
    """Raised if there is no frame to write."""


class Recorder(Serialized):
    """An active recording to the file `path`, with the `max_points` of `record`."""

    _up: Triple | None = None  # up axis of the first geometry that defines one

    def __init__(
        self, path: Path, options: RecordingOptions, *, automatic: bool, progress: ReportProgress | None
    ) -> None:
        self.path, self._options, self.max_points = path, options, options.max_points
        self._report_progress = check_progress(progress)
        check_recording(path, fps=options.fps, background=options.background, overwrite=options.overwrite)
        self._store, self._max_bytes = ShapeStore(), MAX_BYTES
        self._origin: NDArray[np.float64] | None = None
        self._device: Any = None
        self._geometries: dict[str, ShownGeometry] = {}
        self._counts: dict[str, tuple[int, int]] = {}
        self._values: dict[str, float] = {}
        self._frames: list[Frame] = []
        self._last: Frame | None = None  # the last frame, if it was dropped
        self._seen, self._stride, self._is_dirty, self._is_discarded = 0, 1, False, False
        self._scripts = Scripts(self, self._show) if automatic else None
        self._owner: Stage | None = None
        self._owners: dict[str, Stage] = {}
        self._watching = contextlib.ExitStack()
        self._seen_from: View | None = None  # view of the written file

    def __repr__(self) -> str:
        return f"Recorder({escaped(self.path)}, {len(self._frames)} frames, {len(self._store.shapes)} shapes)"

    def _repr_mimebundle_(
        self, include: Iterable[str] | None = None, exclude: Iterable[str] | None = None
    ) -> dict[str, Any]:
        """For notebooks: the recording, once it is written."""
        from .cell_output import notebook_size, recording_output

        if self._seen_from is None:
            return {"text/plain": repr(self)}
        width, height = notebook_size(self._options.size)
        film = Film(self.timeline, self._seen_from, width, height, self._options.background, self._device)
        return recording_output(self.path, repr(self), film)

    def __enter__(self) -> Recorder:
        if self._scripts is not None:
            self._watching.enter_context(watch(self._scripts.take))
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._watching.close()
        if self._is_discarded:
            return
        if error is None:
            try:
                self.save()
            except NothingRecordedError as nothing:
                warnings.warn(escaped(f"no file is written: {nothing}"), stacklevel=2)
        elif self._frames:
            try:
                self.save(note=f"ended by {type(error).__name__}")
            except Exception as second:  # the first error is the one to report
                error.add_note(f"and the recording could not be written: {second}")

    def add(self, name: str, geometry: object, **style: Any) -> None:
        """Show a geometry from the next step on, replacing one of the same name.

        Args:
            name: Unique name.
            geometry: Any type that `loom.render` draws.
            **style: color, point_size, color_by, ... as in dictionaries of `loom.render`.

        Raises:
            TypeError, ValueError: Unsupported geometry, unknown style key, or a value out of range.
        """
        name, chosen = check_name("name", name), style_of(style)
        pose = self._geometries[name].pose if name in self._geometries and chosen.pose is None else None
        self._set(name, sketch(geometry, chosen, self.max_points), chosen, pose)
        self._up = self._up or up_of_geometry(geometry, chosen.pose)

    def update(self, name: str, geometry: object, **style: Any) -> None:
        """Replace a geometry. Style and pose are kept unless given. Raises `KeyError` or as `add`."""
        entry = self._known(name)
        chosen = dataclasses.replace(entry.style, **fields_of(style))
        pose = entry.pose if chosen.pose is None else None
        self._set(name, sketch(geometry, chosen, self.max_points), chosen, pose)

    def set_pose(self, name: str, pose: ArrayLike) -> None:
        """Set the pose (4x4, geometry to world) of a geometry without a copy of it.

        Raises `KeyError` for an unknown name and `ValueError` if `pose` is not a transformation.
        """
        entry, T = self._known(name), np.array(check_transformation("pose", pose))
        self._geometries[name] = dataclasses.replace(entry, pose=T)
        self._is_dirty = True

    def remove(self, name: str) -> None:
        """Remove a geometry from the next frame on. Raises `KeyError` for an unknown name."""
        self._known(name)
        del self._geometries[name]
        self._is_dirty = True

    def plot(self, name: str, value: float) -> None:
        """Add a number to the plot of the next frame. NaN leaves a gap. Raises `TypeError` for other types."""
        number = check_number("value", value, allow_nan=True, allow_infinite=True)
        self._values[check_name("name", name)] = number
        self._is_dirty = True

    def step(self, label: str = "") -> None:
        """Add a frame of the current geometries and of the numbers plotted since the last frame."""
        shown = {name: entry.placement(self.origin) for name, entry in self._geometries.items()}
        frame = Frame(shown, check_name("label", label), self._values)
        self._values, self._is_dirty, self._last = {}, False, None
        if self._seen % self._stride:
            self._last = frame
        else:
            self._frames.append(frame)
        self._seen += 1
        if len(self._frames) > self._options.max_frames:
            self._thin()
        if self._store.size > self._max_bytes:
            self._forget()
        while self._store.size > self._max_bytes and len(self._frames) > 2:
            before = self._store.size
            self._thin()
            if self._store.size > MAX_REMAINING_FRACTION * before:
                self._max_bytes = 2 * self._store.size

    @property
    def names(self) -> list[str]:
        return list(self._geometries)

    @property
    def origin(self) -> NDArray[np.float64]:
        """Origin of the positions [m], taken from the first geometry."""
        return np.zeros(3) if self._origin is None else self._origin

    @property
    def timeline(self) -> Timeline:
        frames = [*self._frames, *([] if self._last is None else [self._last])]
        name = self._options.title or self.path.stem
        return Timeline(self.origin, self._store.shapes, frames, self._title_of(frames), self._options.fps, name)

    def discard(self) -> None:
        """Do not write a file at the end of the block."""
        self._is_discarded = True

    def save(self, *, note: str = "") -> None:
        """Write the file atomically, with `note` appended to the title. Called at the end of the `with` block.

        Raises:
            ValueError, FileError: No frames (a warning at the end of the `with` block), or the file cannot be written.
        """
        if self._scripts is not None:
            self._scripts.finish()
        if self._is_dirty:
            self.step()
        self._forget()
        timeline = self.timeline
        if not timeline.frames:
            raise NothingRecordedError(f"{os.fspath(self.path)}: {NOTHING}")
        if note:
            timeline.title = ", ".join([timeline.title, note] if timeline.title else [note])
        look = None if self._scripts is None else self._scripts.look
        look = look if self._up is None else (direction_under(self._up), self._up)
        options = self._options
        view = find_view(options.view, timeline, look, *options.size)
        looks: dict[str, Any] = {"view": view, "background": options.background, "overwrite": options.overwrite}
        write_recording(
            self.path, timeline, size=options.size, report_progress=self._report_progress, device=self._device, **looks
        )
        self._seen_from = view

    def _set(self, name: str, drawn: Sketch, style: Style, pose: Matrix | None) -> None:
        if self._origin is None and drawn.shapes:
            self._origin, self._device = drawn.origin.copy(), drawn.device
        numbers = tuple(self._store.add(shape) for shape in drawn.shapes)
        self._geometries[name] = ShownGeometry(numbers, drawn.origin, style, drawn.pose if pose is None else pose)
        self._counts[name] = drawn.drawn, drawn.total
        self._is_dirty = True

    def _show(
        self,
        name: str,
        drawn: Sequence[tuple[Any, dict[str, Any]]],
        max_points: int,
        owner: Stage,
        total: int | None = None,
    ) -> None:
        """Show geometries of an algorithm under one name and drop those of other owners."""
        if self._owner is not owner:
            for earlier in [name for name, by in self._owners.items() if by is not owner and name in self._geometries]:
                del self._geometries[earlier]
            self._owner, self._owners = owner, {}
        self._owners[name] = owner
        if len(drawn) > 1:  # all parts of one cloud have one point size
            point_count = sum(len(geometry) for geometry, _ in drawn)
            drawn = [(geometry, {"point_size": usual_size(point_count), **style}) for geometry, style in drawn]
        styles = [style_of(style) for _, style in drawn]
        sketches = [sketch(geometry, style, max_points) for (geometry, _), style in zip(drawn, styles, strict=True)]
        shapes = [shape for each in sketches for shape in each.shapes]
        count, all_points = sum(each.drawn for each in sketches), sum(each.total for each in sketches)
        counts = {"drawn": count, "total": all_points if total is None else total}
        self._set(name, dataclasses.replace(sketches[0], shapes=shapes, **counts), styles[0], None)

    def _known(self, name: str) -> ShownGeometry:
        if check_name("name", name) not in self._geometries:
            raise KeyError(f"{name!r}: no such geometry; add it first. Existing: {sorted(self._geometries)}")
        return self._geometries[name]

    def _thin(self) -> None:
        """Drop every second frame, also of the following ones."""
        self._frames, self._stride = self._frames[::2], 2 * self._stride
        self._forget()

    def _forget(self) -> None:
        """Free the shapes that only dropped frames used."""
        now = Frame({name: entry.placement(self.origin) for name, entry in self._geometries.items()})
        last = [] if self._last is None else [self._last]
        *frames, now = self._store.keep_used([*self._frames, *last, now])
        self._last = frames.pop() if last else None
        self._frames = frames
        self._geometries = {
            n: dataclasses.replace(entry, shapes=now.shown[n].shapes) for n, entry in self._geometries.items()
        }

    def _title_of(self, frames: Iterable[Frame]) -> str:
        shown = {name for frame in frames for name in frame.shown}
        notes = [
            f"{n}: {k:,} of {total:,} points" for n, (k, total) in self._counts.items() if n in shown and k < total
        ]
        if self._stride > 1:
            notes.append(f"one of {self._stride} steps")
        return ", ".join([self._options.title, *notes] if self._options.title else notes)


@dataclasses.dataclass(frozen=True, eq=False)
class ShownGeometry:
    """A displayed geometry: numbers of its shapes, their origin, style and pose."""

    shapes: tuple[int, ...]
    origin: NDArray[np.float64]
    style: Style
    pose: Matrix | None

    def placement(self, origin: NDArray[np.float64]) -> Placement:
        """Its shapes and pose relative to another origin."""
        return Placement(self.shapes, pose_about(self.pose, self.origin, origin))


def style_of(style: dict[str, Any]) -> Style:
    """Style from keys. Raises ValueError for unknown keys and values out of range."""
    return Style(**fields_of(style))


def fields_of(style: dict[str, Any]) -> dict[str, Any]:
    """Fields of a style. Raises ValueError for unknown keys."""
    unknown = [key for key in style if key not in STYLE_KEYS]
    if unknown:
        raise ValueError(f"style: expected {', '.join(STYLE_KEYS)}, got {unknown[0]!r}")
    return style
