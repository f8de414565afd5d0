"""Streams of a depth camera: depth that stands still, colors that come late, what is fixed to the camera or moves.

    POINTLOOM_DATA=<folder> python benchmarks/trust/stream.py

A tracked frame is wrong that is off by more than 10 cm with the first pose the true one; a run whose pictures are not
of one moment is one answer, wrong as it is, and is rejected if the path is unreliable for that reason. The kitchen
needs POINTLOOM_DATA.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from judged import Judged, table
from real_data import DataMissingError, real_data

AREA = "RGB-D streams"
WRONG = 0.10  # [m] a tracked frame that is off by more is wrongly accepted
VOXEL = 0.02  # [m]
LATE = 30  # frames: a second


def kitchen(count: int) -> tuple[list[Any], Any]:
    """Frames of the real kitchen at half the size, and their camera."""
    import pointloom as loom

    data = loom.open_dataset(real_data("rgbd-7scenes-redkitchen"))
    frames = []
    for index in range(count):
        f = data.read(index)
        height, width = f.depth.shape
        color = f.color.reshape(height // 2, 2, width // 2, 2, 3).mean(axis=(1, 3)).astype(np.uint8)
        frames.append(of(np.ascontiguousarray(f.depth[::2, ::2]), color, f.T_world_camera, index / 30))
    return frames, data.intrinsic.scaled(0.5)


def room(count: int, **effects: Any) -> tuple[list[Any], Any]:
    """Frames of a loop through the made-up room, and their camera."""
    from pointloom.datasets.scenes.room import room_loop_sequence

    made = room_loop_sequence(400, "eight", width=160, height=120, **effects)
    frames = [made.read(index) for index in range(count)]
    return [of(f.depth, f.color, f.T_world_camera, f.timestamp) for f in frames], made.intrinsic


def of(depth: Any, color: Any, pose: Any, time: float) -> Any:
    return SimpleNamespace(depth=depth, color=color, T_world_camera=pose, timestamp=time, name="")


def with_object(frames: Sequence[Any], share: float, sway: float = 0.0) -> list[Any]:
    """Something half a metre before the camera over a share of the width, fixed to it or swaying by a share of it."""
    height, width = frames[0].depth.shape
    v, u = np.mgrid[:height, :width]
    rng, out = np.random.default_rng(11), []
    for k, f in enumerate(frames):
        left = (0.5 - 0.5 * share) * width + sway * width * np.sin(k / 15) if sway else 0.0
        mask = (u >= left) & (u < left + share * width)
        z = 520 + 60 * np.sin((u - left) / 23) + 30 * np.cos(v / 31) + rng.normal(0, 1.5, u.shape)
        shade = np.stack([120 + 60 * np.sin((u - left) / 9), 100 + 50 * np.cos(v / 7), np.full(u.shape, 90)], axis=-1)
        depth, color = f.depth.copy(), f.color.copy()
        depth[mask] = np.rint(z[mask]).astype(depth.dtype)
        color[mask] = np.clip(shade[mask] + rng.normal(0, 2, shade[mask].shape), 0, 255).astype(np.uint8)
        out.append(of(depth, color, f.T_world_camera, f.timestamp))
    return out


def late(frames: Sequence[Any], count: int) -> list[Any]:
    """Each frame with the depth of so many frames later."""
    return [of(g.depth, f.color, f.T_world_camera, f.timestamp) for f, g in zip(frames, frames[count:], strict=False)]


def frozen(frames: Sequence[Any], first: int) -> list[Any]:
    """Frames whose depth stands still from one on."""
    still = frames[first].depth
    return [f if k < first else of(still, f.color, f.T_world_camera, f.timestamp) for k, f in enumerate(frames)]


def run(case: str, frames: Sequence[Any], camera: Any, *, is_sound: bool = True, held_out: bool = True) -> Judged:
    """Track frames and judge each, or the run as one where its pictures are not of one moment."""
    import pointloom as loom

    slam = loom.slam.DenseSLAM(camera, voxel_size=VOXEL, T_init=frames[0].T_world_camera)
    results = slam.run(frames)
    off = np.array([_off(result, f) for result, f in zip(results, frames, strict=True)])
    tracked = np.array([result.is_tracked for result in results])
    counts = slam.status_counts
    said = f"{counts['tracked']} tracked, {counts['uncertain']} uncertain, {counts['lost']} lost"
    doubt = slam.stream.problem or ""
    error = f"at most {100 * np.nanmax(np.where(tracked, off, np.nan)):.0f} cm where tracked"
    if not is_sound:
        believed = int(not doubt)
        return Judged(AREA, case, 1, 1, believed, 0, doubt or said, error, held_out=held_out)
    wrong = off > WRONG  # a frame that is lost has no wrong pose: it counts as right, and refused
    refused = int((~tracked & ~wrong).sum())
    said = "; ".join(filter(None, (said, doubt)))
    return Judged(
        AREA, case, len(off), int(wrong.sum()), int((wrong & tracked).sum()), refused, said, error, "", held_out
    )


def _off(result: Any, frame: Any) -> float:
    """How far a pose is off [m]; 0 where there is none."""
    return 0.0 if result.pose is None else float(np.linalg.norm(result.pose[:3, 3] - frame.T_world_camera[:3, 3]))


def judge_stall(case: str, frames: Sequence[Any], camera: Any, first: int, *, held_out: bool) -> Judged:
    """A run whose depth stands still from a frame on: all from the fourth after it is wrong."""
    import pointloom as loom

    slam = loom.slam.DenseSLAM(camera, voxel_size=VOXEL, T_init=frames[0].T_world_camera)
    results = slam.run(frozen(frames, first))
    tracked = np.array([result.is_tracked for result in results])
    wrong = np.arange(len(results)) > first + 3
    said = next(("; ".join(result.warnings) for result in results if not result.is_tracked), "")
    believed, refused = int((tracked & wrong).sum()), int((~tracked & ~wrong).sum())
    return Judged(AREA, case, len(results), int(wrong.sum()), believed, refused, said, held_out=held_out)


def judge() -> Iterator[Judged]:
    """The cases; some 2 minutes of CPU."""
    frames, camera = room(110)
    yield run("room, nothing wrong", frames, camera)
    yield run("room, depth 0.1 s later", late(frames[:63], 3), camera)
    yield judge_stall("room, depth frozen from frame 60", frames[:80], camera, 60, held_out=True)
    yield run("room, something fixed in 35 % of the picture", with_object(frames[:60], 0.35), camera)
    yield run("room, something over 45 % sways", with_object(frames[:60], 0.45, 0.2), camera)
    frames, camera = room(110, person=True, seed=3)
    yield run("room, somebody walks about", frames, camera)
    try:
        frames, camera = kitchen(120)
    except DataMissingError as error:
        print(f"kitchen: left out, {error}", file=sys.stderr)
        return
    yield from judge_kitchen(frames, camera)


def judge_kitchen(frames: list[Any], camera: Any) -> Iterator[Judged]:
    sound: list[tuple[str, Callable[[], list[Any]]]] = [
        ("nothing wrong, every second", lambda: frames[::2]),
        ("depth 0.1 s later", lambda: late(frames[:63], 3)),
        ("something fixed in 30 % of the picture", lambda: with_object(frames[:60], 0.3)),
        ("something fixed in 50 % of the picture", lambda: with_object(frames[:60], 0.5)),
        ("something over half the width sways", lambda: with_object(frames[:60], 0.5, 0.2)),
    ]
    for case, make in sound:
        yield run(f"kitchen, {case}", make(), camera, held_out=False)
    yield judge_stall("kitchen, depth frozen from frame 60", frames[:80], camera, 60, held_out=False)
    for count in (LATE // 2, LATE):
        name = f"kitchen, depth {count / LATE:g} s later"
        yield run(name, late(frames[: 90 + count], count), camera, is_sound=False, held_out=False)


if __name__ == "__main__":
    for number, one in enumerate(judge()):
        print("\n".join(table([one])[2 if number else 0 :]), flush=True)
