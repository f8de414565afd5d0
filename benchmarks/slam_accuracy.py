"""Accuracy of DenseSLAM on the real kitchen and on loops through the synthetic room, with camera effects.

    POINTLOOM_DATA=<folder> python benchmarks/slam_accuracy.py [--only kitchen] [--frames 600] [--size 320x240]

One line per run: frames, their status, ATE after rigid alignment (RMS, maximum), number of tracked frames with an error
above 5 cm relative to the first pose, distance of the surface from the true one (median, 95 %), CPU time per frame. The
plain loops are evaluated again after `close_loops`. The full table takes a quarter of an hour on two cores; the kitchen
needs POINTLOOM_DATA.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from real_data import DataMissingError, real_data

VOXEL_SIZE = 0.01  # [m]
COVERED = 60  # frames: two seconds
WRONG = 0.05  # [m] tracked frames with larger errors are confidently wrong


@dataclass
class Scene:
    """Frames to track, and their ground truth.

    Attributes:
        frames: Frames with their true poses.
        count: Number of frames.
        options: Options of DenseSLAM, except for the voxel size.
        laps: Frame counts at which the error is also evaluated.
        is_room: True if the true surface and the first pose are known.
        is_closed: True if loops are closed at the end.
    """

    frames: Iterable[Any]
    count: int
    intrinsic: Any
    options: dict[str, Any] = field(default_factory=dict)
    laps: tuple[int, ...] = ()
    is_room: bool = False
    is_closed: bool = False


def kitchen(every: int) -> Scene:
    import pointloom as loom

    data = loom.open_dataset(real_data("rgbd-7scenes-redkitchen"), every=every)
    return Scene(data, len(data), data.intrinsic, {"depth_scale": data.depth_scale}, laps=(51,))


def room(frames: int, size: tuple[int, int], path: str, **effects: Any) -> Scene:
    from room_loops import room_loop_sequence

    sequence = room_loop_sequence(frames, path, width=size[0], height=size[1], **effects)
    plain = not effects
    options = {"T_init": sequence.poses[0], "submap_frames": 100 if plain else None}
    return Scene(sequence, len(sequence), sequence.intrinsic, options, is_room=True, is_closed=plain)


def scenes(frames: int, size: tuple[int, int]) -> Iterator[tuple[str, Any]]:
    for every in (1, 2, 3):
        yield f"kitchen, every {every}", lambda every=every: kitchen(every)
    covered = (frames // 6, frames // 6 + COVERED)
    for path in ("round", "eight"):
        yield f"room {path}", lambda path=path: room(frames, size, path)
        yield f"room {path}, covered", lambda path=path: room(frames, size, path, covered=covered)
        for seed in (0, 1):
            name = f"room {path}, person, seed {seed}"
            yield name, lambda path=path, seed=seed: room(frames, size, path, person=True, seed=seed)
        yield f"room {path}, no color", lambda path=path: room(frames, size, path, color=False)
        yield f"room {path}, blur, exposure", lambda path=path: room(frames, size, path, blur=1.0, exposure=0.5)


def run(name: str, scene: Scene) -> None:
    """Track a scene and print its lines."""
    import pointloom as loom

    slam = loom.rgbd.DenseSLAM(scene.intrinsic, voxel_size=VOXEL_SIZE, **scene.options)
    truth, seconds = [], 0.0
    for number, frame in enumerate(scene.frames):
        start = time.process_time()
        slam.step(frame)
        seconds += time.process_time() - start
        truth.append(frame.T_world_camera)
        if sys.stderr.isatty():
            print(f"\r{name}: {number + 1} of {scene.count}", end="\r", file=sys.stderr)
        if number + 1 in scene.laps:
            print(line(f"{name}, {number + 1} frames", slam, truth, seconds), flush=True)
    print(line(name, slam, truth, seconds, scene.is_room), flush=True)
    if scene.is_closed:
        closed = slam.close_loops()
        pairs = len(closed.loops)
        print(line(f"{name}, closed ({pairs} loops)", slam, truth, seconds, scene.is_room), flush=True)


def line(name: str, slam: Any, truth: list[Any], seconds: float, is_room: bool = False) -> str:
    """One line of results so far."""
    import pointloom as loom

    path = slam.trajectory
    error = loom.registration.evaluate_trajectory(
        loom.Trajectory(path.poses), loom.Trajectory(np.array(truth)[path.ids[:, 0]])
    ).absolute_translation
    counts = slam.status_counts
    text = f"{name:32} {len(truth):4} frames: {counts['tracked']:4} tracked {counts['uncertain']:3} uncertain "
    text += f"{counts['lost']:3} lost | ATE {1000 * error.rmse:5.1f} mm, at most {1000 * error.max:5.1f}"
    if is_room:
        errors = np.linalg.norm(path.poses[:, :3, 3] - np.array(truth)[path.ids[:, 0], :3, 3], axis=1)
        text += f" | {int((errors[path.ids[:, 2] == 1] > WRONG).sum())} tracked but wrong"
    if is_room and slam.volume.frame_count > 10:
        from pointloom.datasets.scenes.room import surface_errors

        errors = surface_errors(slam.extract_triangle_mesh().vertices)
        text += f" | surface {1000 * np.median(errors):.1f} mm, 95 % {1000 * np.quantile(errors, 0.95):.1f}"
    return text + f" | {1000 * seconds / len(truth):.0f} ms CPU per frame"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default="", help="runs whose names start with this")
    parser.add_argument("--frames", type=int, default=600, help="of a loop")
    parser.add_argument("--size", default="320x240", help="image size for the room")
    given = parser.parse_args()
    width, _, height = given.size.partition("x")
    for name, make in scenes(given.frames, (int(width), int(height))):
        if name.startswith(given.only):
            try:
                run(name, make())
            except DataMissingError as error:
                print(f"{name}: left out, {error}", flush=True)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
