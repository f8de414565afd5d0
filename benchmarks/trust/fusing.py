"""Reliability of posed frames: fused, refined, colored on a mesh; of their camera; of registered clouds.

Frames are those of the synthetic room with sensor noise, and of walks through the sites of places.py, on which no
constant was chosen, at 160 x 120 pixels. A fused surface is correct if 90 % of its vertices are within 3 cm of the
scene.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
import places
import sensors
from judged import Case, Judged
from sensors import DepthCamera

NEAR, MIN_FRACTION = 0.03, 0.9  # [m], fraction of the vertices
FRAMES = 24
SEEDS, FOCAL_SEEDS = range(300, 322), range(400, 443)  # of the sites: 7 kinds, 4 and 2 results each
SITE_FRAMES, FOCAL_FRAMES, SCALE, SITE_VOXEL = 12, 30, 0.5, 0.02
WRONG_FOCAL = 0.05  # relative focal length error that should be reported


def cases() -> Iterator[Case]:
    yield Case("room", _fused_room)
    yield Case("room, focal lengths", _focal)
    for seed, kind in itertools.product(SEEDS, places.KINDS):
        yield Case(f"{kind} {seed}", partial(_fused_site, kind, seed))
    for seed, kind in itertools.product(FOCAL_SEEDS, places.KINDS):
        yield Case(f"{kind} {seed}, focal lengths", partial(_focal_of_site, kind, seed))


def _sequence() -> Any:
    from room_loops import room_loop_sequence

    return room_loop_sequence(30 * FRAMES, "round", width=320, height=240)


def _fused_room() -> Iterator[Judged]:
    """Poses that are correct, noisy, of other frames, of another convention; depth in other units."""
    sequence = _sequence()
    frames = [sequence.read(k) for k in range(0, len(sequence), 30)]
    truth = np.array([sequence.poses[k] for k in range(0, len(sequence), 30)])
    rng = np.random.default_rng(2)
    shaken = {far: _shaken(truth, far, rng) for far in (0.01, 0.05, 0.3)}
    cases: list[tuple[str, np.ndarray, float]] = [
        ("true poses", truth, 1.0),
        ("poses off by 1 cm", shaken[0.01], 1.0),
        ("poses off by 5 cm", shaken[0.05], 1.0),
        ("poses off by 30 cm", shaken[0.3], 1.0),
        ("poses of other frames", np.roll(truth, 7, axis=0), 1.0),
        ("poses inverted", np.linalg.inv(truth), 1.0),
        ("depth twice as far", truth, 2.0),
        ("depth in thousandths", truth, 0.001),
    ]
    for case, poses, unit in cases:
        yield from _fused(case, _Posed(sequence.intrinsic, frames, poses, unit), 0.02, _is_room)


def _fused(
    case: str, stream: _Posed, voxel_size: float, is_right: Callable[[Any], tuple[bool, str]]
) -> Iterator[Judged]:
    import pointloom as loom

    for refined in (False, True):
        result = loom.rgbd.fuse(stream, voxel_size=voxel_size, refine=refined, depth_max=4.0)
        right, figure = is_right(result.mesh.transform(stream.first_error) if refined else result.mesh)
        area = "fusion, poses refined" if refined else "fusion, poses as given"
        warnings = "; ".join(result.warnings)
        yield Judged(area, case, 1, not right, not right and not warnings, right and bool(warnings), warnings, figure)


def _filmed(kind: str, seed: int, count: int, every: int) -> tuple[DepthCamera, list[Any]]:
    """Frames of a walk through a site, with their true poses."""
    camera = DepthCamera(places.KINDS[kind](seed), seed, scale=SCALE)
    way = {"table": sensors.around, "staircase": sensors.climb}.get(kind, sensors.walking_path)
    return camera, camera.film(way(count * every, seed)[::every])


def _fused_site(kind: str, seed: int) -> Iterator[Judged]:
    """Two faults, drawn by seed, and correct poses."""
    camera, frames = _filmed(kind, seed, SITE_FRAMES, 3)
    truth, rng = np.array([f.pose for f in frames]), np.random.default_rng([seed, 12])
    slight, strong, turned = 0.002 * 10 ** rng.uniform(0, 1), 0.03 * 10 ** rng.uniform(0, 1), rng.uniform(1, 10)
    unit = float(rng.choice([0.001, 0.5, 0.8, 1.25, 2.0, 10.0]))
    faults = [
        (f"poses off by {1000 * strong:.0f} mm", _shaken(truth, strong, rng), 1.0),
        ("poses of other frames", np.roll(truth, int(rng.integers(3, SITE_FRAMES - 3)), axis=0), 1.0),
        ("poses inverted", np.linalg.inv(truth), 1.0),
        (f"depth times {unit:g}", truth, unit),
        (f"every second pose rotated by {turned:.0f} degrees", _rotated(truth, turned), 1.0),
    ]
    chosen = [faults[k] for k in rng.permutation(len(faults))[:2]]
    chosen += [("true poses", truth, 1.0), (f"poses off by {1000 * slight:.0f} mm", _shaken(truth, slight, rng), 1.0)]
    for case, poses, unit in chosen:
        yield from _fused(
            f"{kind} {seed}, {case}",
            _Posed(camera.intrinsic, frames, poses, unit),
            SITE_VOXEL,
            partial(_is_site, camera),
        )


def _rotated(poses: np.ndarray, degrees: float) -> np.ndarray:
    """Every second pose rotated about the camera's vertical axis."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    changed = poses.copy()
    changed[::2, :3, :3] = poses[::2, :3, :3] @ np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return changed


def _is_site(camera: DepthCamera, mesh: Any) -> tuple[bool, str]:
    if not len(mesh):
        return False, "no surface"
    distances = camera.scene.compute_distance(np.asarray(mesh.vertices, np.float32))
    fraction = float((distances < NEAR).mean())
    return fraction >= MIN_FRACTION, f"{fraction:.0%} within 3 cm"


class _Posed:
    """Frames with replaced poses and depths.

    `first_error` moves the first pose, which is not refined, to the true one: refined poses are relative to it.
    """

    depth_scale = 1.0

    def __init__(self, intrinsic: Any, frames: Sequence[Any], poses: np.ndarray, unit: float):
        self.intrinsic, self._frames, self._poses, self._unit = intrinsic, frames, poses, unit
        self.first_error = _pose_of(frames[0]) @ np.linalg.inv(poses[0])

    def __len__(self) -> int:
        return len(self._frames)

    def read(self, index: int) -> Any:
        f = self._frames[index]
        depth = (_metres(f) * self._unit).astype(np.float32)
        return SimpleNamespace(
            depth=depth, color=f.color, timestamp=f.timestamp, name=f.name, T_world_camera=self._poses[index]
        )


def _pose_of(frame: Any) -> np.ndarray:
    return frame.pose if hasattr(frame, "pose") else frame.T_world_camera


def _metres(frame: Any) -> np.ndarray:
    depth = np.asarray(frame.depth)
    return depth / 1000 if depth.dtype.kind in "iu" else depth


def _shaken(poses: np.ndarray, far: float, rng: np.random.Generator) -> np.ndarray:
    moved = poses.copy()
    moved[:, :3, 3] += rng.normal(0, far / np.sqrt(3), (len(poses), 3))
    return moved


def _is_room(mesh: Any) -> tuple[bool, str]:
    from pointloom.datasets.scenes.room import surface_errors

    if not len(mesh):
        return False, "no surface"
    errors = np.abs(surface_errors(mesh.vertices))
    fraction = float((errors < NEAR).mean())
    return fraction >= MIN_FRACTION, f"{fraction:.0%} within 3 cm"


def _focal() -> Iterator[Judged]:
    """Frames with a wrong focal length."""
    sequence = _sequence()
    frames: Sequence[Any] = [sequence.read(k) for k in range(0, len(sequence) // 2, 3)]
    taken = [(f.color, _metres(f).astype(np.float32)) for f in frames]
    for factor in (1.0, 0.98, 1.15, 0.85, 1.3):
        yield _focal_case(f"times {factor:g}", taken, sequence.intrinsic, factor)


def _focal_of_site(kind: str, seed: int) -> Iterator[Judged]:
    """A focal length that is correct within 2 %, and one that is wrong by 6 to 30 %, drawn by seed."""
    camera, frames = _filmed(kind, seed, FOCAL_FRAMES, 3)
    taken, rng = [(f.color, f.depth) for f in frames], np.random.default_rng([seed, 13])
    slight, strong = rng.uniform(0.98, 1.02), 1 + rng.choice([-1, 1]) * 0.06 * 5 ** rng.uniform(0, 1)
    for factor in (float(slight), float(strong)):
        yield _focal_case(f"{kind} {seed}, times {factor:.3f}", taken, camera.intrinsic, factor)


def _focal_case(case: str, taken: Sequence[Any], K: Any, factor: float) -> Judged:
    import pointloom as loom

    stream = loom.frames_from(taken, dataclasses.replace(K, fx=K.fx * factor, fy=K.fy * factor))
    path = loom.rgbd.track(stream, voxel_size=SITE_VOXEL)
    check = loom.rgbd.check_focal(stream, path.trajectory)
    wrong, warnings = abs(factor - 1) > WRONG_FOCAL, "; ".join((*(check.warnings if check else ()), *path.warnings))
    accepted, rejected = wrong and not warnings, not wrong and bool(warnings)
    return Judged("focal length of a depth camera", case, 1, wrong, accepted, rejected, warnings)
