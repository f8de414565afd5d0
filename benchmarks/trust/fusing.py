"""Reliability of posed frames: fused, refined, colored on a mesh; of their camera; of registered clouds.

Frames are those of the synthetic room with sensor noise. A fused surface is correct if 90 % of its vertices are within
3 cm of the room.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
from judged import Judged

NEAR, MIN_FRACTION = 0.03, 0.9  # [m], fraction of the vertices
FRAMES = 24
WRONG_FOCAL = 0.05  # relative focal length error that should be reported


def judge() -> Iterator[Judged]:
    yield from _fused()
    yield from _focal()


def _sequence() -> Any:
    from room_loops import room_loop_sequence

    return room_loop_sequence(30 * FRAMES, "round", width=320, height=240)


def _fused() -> Iterator[Judged]:
    """Poses that are correct, noisy, of other frames, of another convention; depth in other units."""
    import pointloom as loom

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
        for refined in (False, True):
            stream = _Posed(sequence.intrinsic, frames, poses, unit)
            result = loom.rgbd.fuse(stream, voxel_size=0.02, refine=refined, depth_max=4.0)
            right, figure = _is_room(result.mesh)
            area = "fusion, poses refined" if refined else "fusion, poses as given"
            warnings = "; ".join(result.warnings)
            yield Judged(
                area, case, 1, not right, not right and not warnings, right and bool(warnings), warnings, figure
            )


class _Posed:
    """Frames with replaced poses and depths."""

    depth_scale = 1.0

    def __init__(self, intrinsic: Any, frames: Sequence[Any], poses: np.ndarray, unit: float):
        self.intrinsic, self._frames, self._poses, self._unit = intrinsic, frames, poses, unit

    def __len__(self) -> int:
        return len(self._frames)

    def read(self, index: int) -> Any:
        f = self._frames[index]
        depth = (_metres(f) * self._unit).astype(np.float32)
        return dataclasses.replace(f, depth=depth, T_world_camera=self._poses[index])


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
    import pointloom as loom

    sequence = _sequence()
    frames: Sequence[Any] = [sequence.read(k) for k in range(0, len(sequence) // 2, 3)]
    for factor in (1.0, 0.98, 1.15, 0.85, 1.3):
        K = sequence.intrinsic
        camera = dataclasses.replace(K, fx=K.fx * factor, fy=K.fy * factor)
        taken = [(f.color, _metres(f).astype(np.float32)) for f in frames]
        stream = loom.frames_from(taken, camera)
        path = loom.rgbd.track(stream, voxel_size=0.02)
        check = loom.rgbd.check_focal(stream, path.trajectory)
        wrong = abs(factor - 1) > WRONG_FOCAL
        warnings = "; ".join((*check.warnings, *path.warnings))
        passed = not warnings
        yield Judged(
            "focal length of a depth camera",
            f"times {factor:g}",
            1,
            wrong,
            wrong and passed,
            not wrong and not passed,
            warnings,
        )
