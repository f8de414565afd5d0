"""Coordinate frames of a recording: the tree of `tf` and `tf_static`."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ...core.checks import check_finite, check_name, check_numeric
from ...core.errors import FileError
from ...core.escaped_text import escaped
from ...core.quaternions import quaternions_to_rotations
from ...core.time_checks import check_seconds
from .motions import stamp_of_header

TRANSFORMS = ("tf2_msgs/msg/TFMessage", "tf/msg/tfMessage")
FIXED = "tf_static"  # suffix of static transform topics
_MAX_NORM_ERROR = 1e-3  # maximum deviation of a quaternion's length from 1
_MIN_LINEAR_COSINE = 0.9995  # cosine of half an angle above which linear interpolation equals slerp to 1e-8

Matrix = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class _Joint:
    """Poses of a frame in its parent over time. Fixed if there are no times."""

    parent: str
    times: NDArray[np.float64] | None
    translations: NDArray[np.float64]
    rotations: NDArray[np.float64]


class RecordedTransforms:
    """The frames of a recording and the transforms between them, from `Recording.transforms`.

    Attributes:
        path: The recording.
        frames: The names of all frames, sorted.
        parents: The parent of each frame that has one.

    Example:
        >>> import pointloom as loom
        >>> from pointloom.io.bags.recording import Recording
        >>> def path_of_base(recording: Recording, times):
        ...     return recording.transforms().lookup("odom", "base_link", times)  # T_odom_base [n, 4, 4]
    """

    def __init__(self, path: Path, joints: dict[str, _Joint], contested: dict[str, list[str]]):
        self.path, self._joints, self._contested = path, joints, contested
        self.parents = {child: joint.parent for child, joint in sorted(joints.items())}
        self.frames = sorted({*self.parents, *self.parents.values()})

    def __repr__(self) -> str:
        roots = [frame for frame in self.frames if frame not in self.parents]
        return f"RecordedTransforms({len(self.frames)} frames below {escaped(', '.join(roots))})"

    def span(self, frame: str) -> tuple[float, float] | None:
        """First and last time [s] of a frame's transform to its parent. None if it is fixed.

        Raises:
            FileError: No such frame, or one without a parent.
        """
        self._check(check_name("frame", frame))
        if frame not in self._joints:
            raise FileError(self.path, f"the frame {frame} has no parent: it is a root")
        times = self._joints[frame].times
        return None if times is None else (float(times[0]), float(times[-1]))

    def lookup(self, target: str, source: str, time: ArrayLike | None = None) -> Matrix:
        """T_target_source, which transforms points from `source` to `target`.

        Args:
            target: Target frame.
            source: Source frame.
            time: Time [s], scalar or shape (n,). None if all transforms between the frames are fixed.

        Returns:
            float64 (4, 4), or (n, 4, 4) for several times. Translations are interpolated linearly, rotations by slerp.
            There is no extrapolation.

        Raises:
            FileError: A missing frame, frames that are not connected, a frame with two parents, or a time outside the
                record.
            ValueError: Non-finite times, another shape, or float32 times more than 10 ms apart from the next number.
        """
        if time is not None:
            check_seconds("time", check_numeric("time", time))
        times = None if time is None else check_finite("time", check_numeric("time", time).astype(np.float64))
        if times is not None and times.ndim > 1:
            raise ValueError(f"time: expected one, or shape [n], got {list(times.shape)}")
        up, down = self._ways(_plain(check_name("target", target)), _plain(check_name("source", source)))
        every = None if times is None else np.atleast_1d(times)
        count = 1 if every is None else len(every)
        T_common_target, T_common_source = self._product(up, every, count), self._product(down, every, count)
        poses = _inverse(T_common_target) @ T_common_source
        return poses if times is not None and times.ndim else poses[0]

    def _check(self, frame: str) -> None:
        if frame not in self.frames:
            raise FileError(self.path, f"has no frame {frame!r}", remedy=f"There are {', '.join(self.frames)}")

    def _above(self, frame: str) -> list[str]:
        self._check(frame)
        path = [frame]
        while (parent := self.parents.get(path[-1])) is not None:
            if path[-1] in self._contested:
                parents = " and ".join(self._contested[path[-1]])
                raise FileError(
                    self.path, f"the frame {path[-1]} has the parents {parents}", remedy="One parent is allowed"
                )
            if parent in path:
                raise FileError(self.path, f"the frames {' in '.join([*path, parent])} form a cycle")
            path.append(parent)
        return path

    def _ways(self, target: str, source: str) -> tuple[list[str], list[str]]:
        """The frames from both to below their lowest common ancestor."""
        one, other = self._above(target), self._above(source)
        common = next((frame for frame in one if frame in other), None)
        if common is None:
            reason = (
                f"the frames {target} and {source} are not connected: one is below {one[-1]}, one below {other[-1]}"
            )
            raise FileError(self.path, reason)
        return one[: one.index(common)], other[: other.index(common)]

    def _product(self, path: list[str], times: NDArray[np.float64] | None, count: int) -> Matrix:
        """Transform from the first frame of a path to the parent of its last."""
        product = np.tile(np.eye(4), (count, 1, 1))
        for frame in path:
            product = self._joint_at(frame, times) @ product
        return product

    def _joint_at(self, frame: str, times: NDArray[np.float64] | None) -> Matrix:
        joint = self._joints[frame]
        if joint.times is None:
            return _matrices(joint.translations, joint.rotations)
        if times is None:
            reason = f"the frame {frame} moves in {joint.parent}: its pose depends on the time, and no time is given"
            raise FileError(self.path, reason)
        first, last = joint.times[0], joint.times[-1]
        outside = (times < first) | (times > last)
        if outside.any():
            reason = f"the frame {frame} is known in {joint.parent} from {first:.6f} to {last:.6f} s"
            raise FileError(self.path, f"{reason}, and not at {times[outside][0]:.6f} s")
        after = np.minimum(np.searchsorted(joint.times, times, side="right"), len(joint.times) - 1)
        before = np.maximum(after - 1, 0)
        gap = joint.times[after] - joint.times[before]
        fraction = np.divide(times - joint.times[before], gap, out=np.zeros(len(times)), where=gap > 0)[:, None]
        translations = joint.translations[before] + fraction * (joint.translations[after] - joint.translations[before])
        return _matrices(translations, _between(joint.rotations[before], joint.rotations[after], fraction))


def transforms_of_messages(path: Path, messages: Iterable[tuple[str, int, Any]]) -> RecordedTransforms:
    """The tree of TFMessage messages (topic, number, content) in time order. Raises `FileError` if one is invalid."""
    rows: dict[str, dict[str, list[tuple[float, list[float]]]]] = {}
    fixed: set[tuple[str, str]] = set()
    for topic, number, content in messages:
        for parent, child, time, row in _rows(path, topic, number, content):
            rows.setdefault(child, {}).setdefault(parent, []).append((time, row))
            if topic.endswith(FIXED):
                fixed.add((child, parent))
    if not rows:
        raise FileError(path, "contains no transform")
    joints = {}
    for child, by_parent in rows.items():
        parent, samples = next(iter(by_parent.items()))
        is_fixed = (child, parent) in fixed
        used = samples[-1:] if is_fixed else sorted(dict(samples).items())  # of equal times the last one wins
        table = np.array([row for _, row in used], np.float64)
        times = None if is_fixed else np.array([time for time, _ in used])
        joints[child] = _Joint(parent, times, table[:, :3], table[:, 3:])
    return RecordedTransforms(path, joints, {child: [*several] for child, several in rows.items() if len(several) > 1})


def _rows(path: Path, topic: str, number: int, content: Any) -> Iterator[tuple[str, str, float, list[float]]]:
    """Parent, child, time [s], translation and unit quaternion (x, y, z, w) of a message's transforms."""
    for item in content.transforms:
        translation, q = item.transform.translation, item.transform.rotation
        row = [translation.x, translation.y, translation.z, q.x, q.y, q.z, q.w]
        length = float(np.linalg.norm(row[3:]))
        parent, child = _plain(item.header.frame_id), _plain(item.child_frame_id)
        if not np.isfinite(row).all() or abs(length - 1) > _MAX_NORM_ERROR:
            reason = f"{topic}: message {number} contains no transform of {child}: {row[:3]}, rotation {row[3:]}"
            raise FileError(path, reason)
        if not parent or not child or parent == child:
            raise FileError(path, f"{topic}: message {number} has a transform from {child!r} to {parent!r}")
        yield parent, child, stamp_of_header(item.header), [*row[:3], *(x / length for x in row[3:])]


def _plain(frame: str) -> str:
    """The frame name without the leading slash of ROS 1."""
    return frame.removeprefix("/")


def _between(a: Matrix, b: Matrix, fraction: Matrix) -> Matrix:
    """Slerp of unit quaternions on the shorter arc (Shoemake 1985), shape (n, 4)."""
    cosine = (a * b).sum(axis=1, keepdims=True)
    b, cosine = np.where(cosine < 0, -b, b), np.abs(cosine)
    half = np.arccos(np.minimum(cosine, 1.0))
    sine = np.where(cosine < _MIN_LINEAR_COSINE, np.sin(half), 1.0)
    first = np.where(cosine < _MIN_LINEAR_COSINE, np.sin((1 - fraction) * half) / sine, 1 - fraction)
    second = np.where(cosine < _MIN_LINEAR_COSINE, np.sin(fraction * half) / sine, fraction)
    mixed = first * a + second * b
    return mixed / np.linalg.norm(mixed, axis=1, keepdims=True)


def _matrices(translations: Matrix, rotations: Matrix) -> Matrix:
    poses = np.tile(np.eye(4), (len(translations), 1, 1))
    poses[:, :3, :3], poses[:, :3, 3] = quaternions_to_rotations(rotations), translations
    return poses


def _inverse(T: Matrix) -> Matrix:
    back = np.tile(np.eye(4), (len(T), 1, 1))
    R = T[:, :3, :3].transpose(0, 2, 1)
    back[:, :3, :3], back[:, :3, 3] = R, -(R @ T[:, :3, 3:])[:, :, 0]
    return back
