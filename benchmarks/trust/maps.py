"""Maps of a camera that was lost for long: joined if they show the same place, kept separate if undetermined.

A wrong join is the worst result. Maps of different rooms must never be joined; overlapping maps of one room should be.
Constants were chosen on the figure eight through the room of `pointloom.datasets`; box rooms are held out.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from typing import Any

import map_scenes
import numpy as np
from judged import Judged

SEEDS = range(400, 408)
VOXEL = 0.03  # [m]
WRONG = 0.06  # [m] two voxels: maximum error of a correct frame
AREA = "RGB-D maps"


def judge() -> Iterator[Judged]:
    """Runs that lose the camera for long, and pairs of maps."""
    yield from _runs()
    maps = {(seed, k): _tracked(seed, k) for seed in SEEDS for k in range(2)}
    yield _pairs("maps of different rooms", [(maps[a, 0], maps[b, 0]) for a, b in itertools.combinations(SEEDS, 2)])
    yield _pairs("maps of one room that share a third to a half", [(maps[s, 0], maps[s, 1]) for s in SEEDS])


def _slam(frames: Sequence[Any], **options: Any) -> Any:
    import pointloom as loom

    slam = loom.rgbd.DenseSLAM(map_scenes.camera(), voxel_size=VOXEL, **options)
    slam.run(frames)
    return slam


def _tracked(seed: int, k: int) -> tuple[Any, list[Any], int]:
    """A path over about 80 degrees of a room: the second starts at the middle of the first."""
    first = 37 * seed % 360 + 45 * k
    frames = map_scenes.BoxRoom(seed).frames_around(np.arange(first, first + 80, 2.0), seed + k)
    return _slam(frames), frames, seed


def _pairs(case: str, pairs: Sequence[tuple[Any, Any]]) -> Judged:
    """Joining of maps of two runs by overlap."""
    from pointloom.rgbd.slam.map_merging import find_join

    wrong = accepted = rejected = 0
    worst, reasons = 0.0, set()
    for (first, seen, room), (second, shown, other) in pairs:
        target, source = first._maps.here, second._maps.here
        results = [*first.results, *(_of_map(result, 1) for result in second.results)]
        source.number = 1
        join = find_join(target, source, results, 0)
        source.number = 0
        true = np.linalg.inv(seen[0].T_world_camera) @ shown[0].T_world_camera
        error_m = np.inf if join is None or room != other else _off(join.T_target_source, true)
        is_joined = join is not None and not join.refused
        is_wrong = room != other or (is_joined and error_m > WRONG)
        wrong += is_wrong
        accepted += is_wrong and is_joined
        rejected += not is_wrong and not is_joined
        if is_joined and np.isfinite(error_m):
            worst = max(worst, error_m)
        if not is_joined:
            reasons.add("no pose is believed" if join is None else join.refused.split(":")[0])
    error = f"joins at most {1000 * worst:.0f} mm off" if worst else ""
    return Judged(AREA, case, len(pairs), wrong, accepted, rejected, "; ".join(sorted(reasons)), error)


def _of_map(result: Any, number: int) -> Any:
    import dataclasses

    return dataclasses.replace(result, map=number)


def _off(T: Any, true: Any) -> float:
    """Error of a pose at a point two meters in front of the camera [m]."""
    points = np.array([[x, y, 2.0, 1.0] for x in (-1, 1) for y in (-0.7, 0.7)])
    return float(np.linalg.norm(((T - true) @ points.T)[:3], axis=0).max())


def _runs() -> Iterator[Judged]:
    """A camera that moves while covered, and then sees new parts of the scene."""
    for seed in (410, 411, 412):
        room = map_scenes.BoxRoom(seed)
        first_angles, second_angles = np.arange(0, 60, 1.5), np.arange(150, 240, 1.5)
        back = np.arange(240, 20, -1.5)
        yield _run(
            f"room of boxes {seed}, elsewhere when it sees again, and back",
            room,
            [first_angles, second_angles, back],
            seed,
        )
        yield _run(f"room of boxes {seed}, elsewhere for good", room, [first_angles, second_angles], seed)
    first, second = map_scenes.BoxRoom(420), map_scenes.BoxRoom(421)
    frames = [*first.frames_around(np.arange(0, 60, 1.5), 1), *second.frames_around(np.arange(150, 240, 1.5), 2)]
    yield _judge_slam("carried into another room", _slam(frames), frames, [0] * 40 + [1] * 60)


def _run(case: str, room: Any, parts: Sequence[Any], seed: int) -> Judged:
    frames = [frame for part in parts for frame in room.frames_around(part, seed)]
    return _judge_slam(case, _slam(frames), frames, [0] * len(frames))


def _judge_slam(case: str, slam: Any, frames: Sequence[Any], rooms: Sequence[int]) -> Judged:
    """Judge frames: wrong if the pose is inconsistent with the first frame of its map."""
    slam.join_maps()
    wrong = refused = 0
    worst = 0.0
    firsts = {result.map: result for result in reversed(slam.results) if result.pose is not None}
    for result, frame, room in zip(slam.results, frames, rooms, strict=True):
        if result.pose is None:
            refused += 1
            continue
        first = firsts[result.map]
        true = np.linalg.inv(frames[first.index].T_world_camera) @ frame.T_world_camera
        error = np.inf if room != rooms[first.index] else _off(np.linalg.inv(first.pose) @ result.pose, true)
        wrong += error > WRONG and result.is_tracked
        worst = max(worst, error)
    sizes = slam.map_sizes
    maps = f"{len(sizes)} maps of {', '.join(map(str, sizes.values()))} frames" if len(sizes) > 1 else "one map"
    return Judged(AREA, case, len(frames), wrong, wrong, refused, maps, f"at most {1000 * worst:.0f} mm off")
