"""Recordings for other viewers: `.rrd` of Rerun and `.mcap` of Foxglove, with the packages of those viewers.

Positions stay relative to the timeline's origin, since both viewers draw in float32. The origin is stored beside them.
A shape is written in the frame that shows it first, a pose in each frame in which it changes.
"""

from __future__ import annotations

import importlib.util
import tempfile
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ...core.errors import FileError
from ...core.quaternions import rotations_to_quaternions
from ...kernels.linear_algebra import matmul
from .timeline import Frame, Placement, Shape, Timeline

PACKAGES = {".rrd": ("rerun", "rerun-sdk"), ".mcap": ("foxglove", "foxglove-sdk")}  # suffix: module, name on PyPI
ROOT = "scene"
NANOSECONDS_PER_SECOND = 1_000_000_000
RIGID_TOLERANCE = 1e-6  # of R R^T - I: Foxglove has no scaled or sheared frames
NOWHERE = Placement(())


def check_package(path: str | Path) -> None:
    """Raise FileError if the package for the suffix is not installed."""
    suffix = Path(path).suffix.lower()
    module, package = PACKAGES[suffix]
    if importlib.util.find_spec(module) is None:
        remedy = f"pip install {package}, or use a file name that ends in .html"
        raise FileError(path, f"writing {suffix} requires the package {package}", remedy=remedy)


def export(path: str | Path, timeline: Timeline) -> bytes:
    """The content of the file of a timeline in the format of the suffix."""
    suffix = Path(path).suffix.lower()
    writers: dict[str, Callable[[Path, Timeline], None]] = {".rrd": _write_rrd, ".mcap": _write_mcap}
    with tempfile.TemporaryDirectory(prefix="pointloom-") as folder:  # both packages write to a path of their own
        made = Path(folder) / f"recording{suffix}"
        writers[suffix](made, timeline)
        return made.read_bytes()


@dataclass(frozen=True, eq=False)
class _Change:
    """A name whose shapes or pose differ from those of the previous frame. Without shapes, it is not displayed."""

    name: str
    shapes: tuple[Shape, ...]
    pose: NDArray[np.float64]
    has_new_shapes: bool


def _changes(timeline: Timeline) -> Iterator[tuple[int, Frame, list[_Change]]]:
    """Yield number, frame and changes of each frame."""
    before: dict[str, Placement] = {}
    for number, frame in enumerate(timeline.frames):
        changes = []
        for name in {**before, **frame.shown}:
            old, new = before.get(name, NOWHERE), frame.shown.get(name, NOWHERE)
            was, T = (np.eye(4) if placement.pose is None else placement.pose for placement in (old, new))
            if old.shapes != new.shapes or not np.array_equal(was, T):
                shapes = tuple(timeline.shapes[k] for k in new.shapes)
                changes.append(_Change(name, shapes, T, old.shapes != new.shapes))
        yield number, frame, changes
        before = frame.shown


def _write_rrd(path: Path, timeline: Timeline) -> None:
    import rerun as rr  # pyright: ignore[reportMissingImports]  an optional package

    stream = rr.RecordingStream(timeline.title or timeline.name or "pointloom")
    stream.save(path)
    stream.log(ROOT, rr.AnyValues(origin=timeline.origin), static=True)
    for number, frame, changes in _changes(timeline):
        stream.set_time("frame", sequence=number)
        stream.set_time("time", duration=number / timeline.fps)
        for change in changes:
            entity = f"{ROOT}/{rr.escape_entity_path_part(change.name)}"
            if change.has_new_shapes:
                stream.log(entity, rr.Clear(recursive=True))
            T = change.pose
            stream.log(entity, rr.Transform3D(translation=T[:3, 3], mat3x3=T[:3, :3]))
            for k, shape in enumerate(change.shapes if change.has_new_shapes else ()):
                stream.log(f"{entity}/{k}", _rerun_shape(rr, shape))
        if frame.label:
            stream.log("label", rr.TextLog(frame.label))
        for name, value in frame.values.items():
            stream.log(f"plots/{rr.escape_entity_path_part(name)}", rr.Scalars(float(value)))
    stream.flush()
    stream.disconnect()


def _rerun_shape(rr: ModuleType, shape: Shape) -> object:
    """The archetype of a shape. Sizes are in pixels, which Rerun marks by a negative radius."""
    colors = shape.plain if shape.colors is None else shape.colors
    if shape.kind == "points":
        return rr.Points3D(shape.positions, colors=colors, radii=-shape.size / 2)
    if shape.kind == "lines":
        return rr.LineStrips3D(shape.positions[shape.indices], colors=colors, radii=-shape.size / 2)
    style = {"albedo_factor": colors} if shape.colors is None else {"vertex_colors": colors}
    return rr.Mesh3D(
        vertex_positions=shape.positions, triangle_indices=shape.indices, vertex_normals=shape.normals, **style
    )


def _write_mcap(path: Path, timeline: Timeline) -> None:
    import foxglove  # pyright: ignore[reportMissingImports]  an optional package
    from foxglove import channels  # pyright: ignore[reportMissingImports]

    context = foxglove.Context()
    transforms = channels.FrameTransformChannel("/tf", context=context)
    scene = channels.SceneUpdateChannel("/scene", context=context)
    logs = channels.LogChannel("/label", context=context)
    names = {name for frame in timeline.frames for name in frame.values}
    schema = {"type": "object", "properties": {name: {"type": "number"} for name in sorted(names)}}
    plots = foxglove.Channel("/plots", schema=schema, message_encoding="json", context=context)
    clouds: dict[str, Any] = {}
    with foxglove.open_mcap(path, context=context):
        for number, frame, changes in _changes(timeline):
            messages = _Messages(round(number / timeline.fps * NANOSECONDS_PER_SECOND))
            if number == 0:
                transforms.log(messages.transform("world", ROOT, _translation(timeline.origin)), log_time=messages.time)
            for change in changes:
                frame_id, pose = (change.name, None) if _is_rigid(change.pose) else (ROOT, change.pose)
                if pose is None:
                    transforms.log(messages.transform(ROOT, change.name, change.pose), log_time=messages.time)
                    if not change.has_new_shapes:
                        continue
                points = [shape for shape in change.shapes if shape.kind == "points"]
                if points or change.name in clouds:  # an empty cloud replaces one that is no longer displayed
                    if change.name not in clouds:
                        clouds[change.name] = channels.PointCloudChannel(f"/points/{change.name}", context=context)
                    clouds[change.name].log(messages.cloud(frame_id, points, pose), log_time=messages.time)
                scene.log(messages.scene(change, frame_id, pose), log_time=messages.time)
            if frame.label:
                logs.log(messages.label(frame.label), log_time=messages.time)
            if frame.values:
                plots.log({name: float(value) for name, value in frame.values.items()}, log_time=messages.time)


class _Messages:
    """Messages of Foxglove at a time [ns]."""

    def __init__(self, time: int):
        from foxglove import messages  # pyright: ignore[reportMissingImports]

        self.time, self._types = time, messages
        self._stamp = messages.Timestamp(*divmod(time, NANOSECONDS_PER_SECOND))

    def label(self, text: str) -> object:
        return self._types.Log(timestamp=self._stamp, level=self._types.LogLevel.Info, message=text)

    def transform(self, parent: str, child: str, T: NDArray[np.float64]) -> object:
        x, y, z, w = rotations_to_quaternions(T[None, :3, :3])[0].tolist()
        return self._types.FrameTransform(
            timestamp=self._stamp,
            parent_frame_id=parent,
            child_frame_id=child,
            translation=self._types.Vector3(**dict(zip("xyz", T[:3, 3].tolist(), strict=True))),
            rotation=self._types.Quaternion(x=x, y=y, z=z, w=w),
        )

    def cloud(self, frame_id: str, shapes: Sequence[Shape], pose: NDArray[np.float64] | None) -> object:
        """All points of some shapes: float32 x, y, z, then uint8 red, green, blue, alpha."""
        rows = np.zeros(sum(len(shape.positions) for shape in shapes), [("xyz", "<f4", 3), ("rgba", "u1", 4)])
        rows["rgba"] = 255
        rows["xyz"] = np.concatenate([np.empty((0, 3)), *(_placed(shape, pose) for shape in shapes)])
        rows["rgba"][:, :3] = np.concatenate([np.empty((0, 3)), *map(_colors, shapes)])
        kinds, field = self._types.PackedElementFieldNumericType, self._types.PackedElementField
        fields = [field(name=name, offset=4 * k, type=kinds.Float32) for k, name in enumerate("xyz")]
        names = ("red", "green", "blue", "alpha")
        fields += [field(name=name, offset=12 + k, type=kinds.Uint8) for k, name in enumerate(names)]
        return self._types.PointCloud(
            timestamp=self._stamp,
            frame_id=frame_id,
            pose=self._types.Pose(
                position=self._types.Vector3(x=0, y=0, z=0), orientation=self._types.Quaternion(x=0, y=0, z=0, w=1)
            ),
            point_stride=rows.itemsize,
            fields=fields,
            data=rows.tobytes(),
        )

    def scene(self, change: _Change, frame_id: str, pose: NDArray[np.float64] | None) -> object:
        """Replace the lines and triangles of a name."""
        lines, triangles = (
            [self._primitive(shape, pose) for shape in change.shapes if shape.kind == kind]
            for kind in ("lines", "triangles")
        )
        deletion = self._types.SceneEntityDeletion(timestamp=self._stamp, id=change.name)
        if not lines and not triangles:
            return self._types.SceneUpdate(deletions=[deletion])
        entity = self._types.SceneEntity(
            timestamp=self._stamp, frame_id=frame_id, id=change.name, lines=lines, triangles=triangles
        )
        return self._types.SceneUpdate(entities=[entity])  # replaces an entity of the same name

    def _primitive(self, shape: Shape, pose: NDArray[np.float64] | None) -> object:
        """Lines or triangles. Colors of lines belong to segments, in Foxglove to points."""
        assert shape.indices is not None
        positions, colors, indices = _placed(shape, pose), _colors(shape) / 255, shape.indices.ravel()
        if shape.kind == "lines":
            positions, colors, indices = positions[indices], np.repeat(colors, 2, axis=0), np.empty(0, np.int32)
        points = [self._types.Point3(x=x, y=y, z=z) for x, y, z in positions.tolist()]
        paints = [self._types.Color(r=r, g=g, b=b, a=1.0) for r, g, b in colors.tolist()]
        parts: dict[str, Any] = {"points": points, "colors": paints, "indices": indices.tolist()}
        if shape.kind == "triangles":
            return self._types.TriangleListPrimitive(**parts)
        kind = self._types.LinePrimitiveLineType.LineList
        return self._types.LinePrimitive(type=kind, thickness=shape.size, scale_invariant=True, **parts)


def _is_rigid(T: NDArray[np.float64]) -> bool:
    R = T[:3, :3]
    return bool(abs(matmul(R, R.T) - np.eye(3)).max() < RIGID_TOLERANCE and np.linalg.det(R) > 0)


def _translation(offset: NDArray[np.float64]) -> NDArray[np.float64]:
    T = np.eye(4)
    T[:3, 3] = offset
    return T


def _placed(shape: Shape, pose: NDArray[np.float64] | None) -> NDArray[np.float64]:
    """Positions of a shape, at its pose unless this is the pose of its frame."""
    positions = shape.positions.astype(np.float64)
    return positions if pose is None else matmul(positions, pose[:3, :3].T) + pose[:3, 3]


def _colors(shape: Shape) -> NDArray[np.uint8]:
    """A color for each point, or for each line."""
    rows = len(shape.positions) if shape.kind != "lines" or shape.indices is None else len(shape.indices)
    return np.broadcast_to(np.array(shape.plain, np.uint8), (rows, 3)) if shape.colors is None else shape.colors
