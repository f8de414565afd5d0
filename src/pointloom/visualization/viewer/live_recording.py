"""Recording of a viewer's history since `set_time`."""

from __future__ import annotations

import dataclasses
import os
from typing import Any

import numpy as np

from ...core.checks import check_count, check_name, check_positive
from ...core.paths import path_of
from ..recording.film import find_view
from ..recording.options import MAX_FPS, MAX_FRAMES, MAX_POINTS, check_picture_size
from ..recording.shapes import ShapeStore, Sketch, pose_about, sketch, spread_rows
from ..recording.timeline import Frame, Placement, Timeline
from ..recording.writers import check_recording, write_recording
from .items import Item
from .live_timeline import LiveTimeline, State
from .scene import Scene
from .scene_edits import SceneEdits
from .screenshots import shown_geometry

Moment = tuple[str, dict[str, State]]


def write_history(
    edits: SceneEdits,
    path: str | os.PathLike[str],
    *,
    fps: float = 10.0,
    size: tuple[int, int] = (960, 720),
    max_points: int = MAX_POINTS,
    max_frames: int = MAX_FRAMES,
    title: str = "",
    background: Any = None,
    overwrite: bool = True,
) -> None:
    """Write the time steps of a viewer as a recording with one frame each. See `Viewer.save_recording`.

    More than `max_frames` steps are sampled evenly, including the newest.
    """
    scene = edits.scene
    fps, size = check_positive("fps", fps, maximum=MAX_FPS), check_picture_size(size)
    point_limit, max_frames = check_count("max_points", max_points), check_count("max_frames", max_frames, minimum=2)
    ground = scene.background.tolist() if background is None else background
    output = path_of(path)
    check_recording(output, fps=fps, background=ground, overwrite=overwrite)
    title = check_name("title", title)
    with scene.lock:
        history = edits.timeline
        if history is None:
            raise ValueError("no time step was recorded: call viewer.set_time(t) before the changes of each time step")
        moments = moments_of(history, max_frames)
        view = edits.display.view_of(None) if edits.display.sessions or scene.has_own_view else None
        notes = [f"{max_frames:,} of {len(history.times):,} time steps"] if len(moments) < len(history.times) else []
    timeline = Drawn(scene, point_limit).timeline(moments)  # without the lock: program and pages continue
    timeline.title, timeline.fps = ", ".join([title, *notes] if title else notes), fps
    view = find_view(view, timeline, None, *size)
    look = {"view": view, "background": tuple(ground), "overwrite": overwrite}
    write_recording(output, timeline, size=size, report_progress=lambda *_: None, **look)


def moments_of(history: LiveTimeline, max_count: int) -> list[Moment]:
    """Label and scene of each step. At most `max_count`, evenly sampled including the newest."""
    count = len(history.times)
    rows = count - 1 - spread_rows(count, max_count)[::-1]
    return [(history.text_of(history.times[row]), history.scene_at(history.dropped + row)) for row in rows.tolist()]


class Drawn:
    """Converts the geometries of time steps to shapes, each once."""

    def __init__(self, scene: Scene, max_points: int):
        self._scene, self._max_points = scene, max_points
        self._store = ShapeStore()
        self._sketches: dict[Item, tuple[Sketch, tuple[int, ...]]] = {}
        self._origin: Any = None

    def timeline(self, moments: list[Moment]) -> Timeline:
        frames = []
        for label, scene in moments:
            shown = {name: self._placement(state) for name, state in scene.items() if state.visible}
            frames.append(Frame(shown, label))
        return Timeline(np.zeros(3) if self._origin is None else self._origin, self._store.shapes, frames)

    def _placement(self, state: State) -> Placement:
        drawn, numbers = self._sketch(state.item)
        pose = drawn.pose
        if state.pose is not None:
            pose = state.pose if pose is None else state.pose @ pose
        return Placement(numbers, pose_about(pose, drawn.origin, self._origin))

    def _sketch(self, item: Item) -> tuple[Sketch, tuple[int, ...]]:
        entry = self._sketches.get(item)
        if entry is None:
            _, geometry, style = shown_geometry(self._scene, item)
            drawn = sketch(geometry, dataclasses.replace(style, pose=item.style.pose), self._max_points)
            if self._origin is None:
                self._origin = drawn.origin.copy()
            entry = self._sketches[item] = drawn, tuple(self._store.add(shape) for shape in drawn.shapes)
        return entry
