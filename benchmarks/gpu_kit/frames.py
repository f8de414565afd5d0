"""Sequences of frames: the distribution of the time of a frame, with its preparation and all waits.

    python -m gpu_kit.frames STATE SECONDS

RGB-D frames of 640 x 480 pixels, given as NumPy arrays as a camera delivers them, and LiDAR scans of 57,600 rays. A
sequence has 100 frames. The first 5 create graphs and buffers. They count separately.
"""

from __future__ import annotations

import multiprocessing
import sys
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np

from gpu_kit import device as devices
from gpu_kit.documents import keep_part, saved_part
from gpu_kit.runner import MORE

FRAMES, FIRST = (100, 5) if not devices.is_dry() else (4, 1)
WIDTH, HEIGHT, AZIMUTHS, BEAMS = (640, 480, 900, 64) if not devices.is_dry() else (160, 120, 225, 16)
LOOP, DEPTH_MAX = 900, 4.0  # frames of the complete loop of the camera, and [m]
AT_LEAST = 3.0  # seconds for a sequence


class Sequence(NamedTuple):
    """The call of a frame by its number, and facts at the end: a time counts only if the result is right."""

    call: Callable[[int], Any]
    end: Callable[[], dict[str, Any]] = dict


class Room(NamedTuple):
    """Depth [mm], color, camera to world, and the camera."""

    depths: list[np.ndarray]
    colors: list[np.ndarray]
    poses: np.ndarray
    camera: Any


def room() -> Room:
    """Frames of a hand-held camera in the furnished room, at 30 Hz."""
    from room_loops import room_loop_sequence

    sequence = room_loop_sequence(LOOP, width=WIDTH, height=HEIGHT, device=devices.NAME)
    frames = [sequence.read(k) for k in range(FRAMES)]
    poses = np.array([frame.T_world_camera for frame in frames])
    return Room([frame.depth for frame in frames], [frame.color for frame in frames], poses, sequence.intrinsic)


def street(_: int = 0) -> Any:
    """A drive: scans, the times of their points, and the true poses."""
    from street import drive

    return drive(FRAMES, beams=BEAMS, azimuths=AZIMUTHS)


def tsdf(frames: Room) -> Sequence:
    import scenes

    import pointloom as loom

    volume = loom.TSDFVolume(voxel_size=0.01, truncation=0.04, color=True, device=devices.NAME)
    limits = {"depth_scale": 1000.0, "depth_max": DEPTH_MAX}
    extrinsics = [scenes.inverse(pose) for pose in frames.poses]

    def call(k: int) -> Any:
        return volume.integrate(frames.depths[k], frames.camera, extrinsics[k], frames.colors[k], **limits)

    return Sequence(call)


def rgbd(frames: Room) -> Sequence:
    from pointloom import rgbd

    previous = []

    def call(k: int) -> Any:
        frame = rgbd.OdometryFrame(frames.depths[k], frames.camera, frames.colors[k], device=devices.NAME)
        result = rgbd.align_frames(frame, previous.pop()) if previous else None
        previous.append(frame)
        return result

    return Sequence(call)


def slam(frames: Room) -> Sequence:
    import pointloom as loom

    system = loom.rgbd.DenseSLAM(frames.camera, voxel_size=6.4 / WIDTH, depth_max=DEPTH_MAX, device=devices.NAME)
    true = np.linalg.inv(frames.poses[0]) @ frames.poses

    def end() -> dict[str, Any]:
        poses = system.trajectory.poses
        error = np.linalg.norm(poses[-1][:3, 3] - true[len(poses) - 1][:3, 3])
        return {"frames lost": FRAMES - len(poses), "error_m": float(error)}

    return Sequence(lambda k: system.step(SimpleNamespace(depth=frames.depths[k], color=frames.colors[k])), end)


def lidar(drive: Any) -> Sequence:
    import pointloom as loom

    run, poses = loom.registration.LidarOdometry(voxel_size=1.0, device=devices.NAME), []

    def call(k: int) -> None:
        poses.append(run.register(loom.PointCloud(drive.scans[k], time=drive.times[k], device=devices.NAME)))

    def end() -> dict[str, Any]:
        true = np.linalg.inv(drive.poses[0]) @ drive.poses[-1]
        moved = np.linalg.inv(np.asarray(poses[0])) @ np.asarray(poses[-1])
        return {"error_m": float(np.linalg.norm(moved[:3, 3] - true[:3, 3]))}

    return Sequence(call, end)


SEQUENCES: dict[str, tuple[str, Callable[[Any], Sequence]]] = {
    "TSDF, color": ("room", tsdf),
    "RGB-D odometry": ("room", rgbd),
    "SLAM": ("room", slam),
    "LiDAR odometry": ("street", lidar),
}


def measured(sequence: Sequence) -> dict[str, Any]:
    """The distribution of the times of synchronized frames [ms]."""
    import warp as wp

    seconds = []
    for k in range(FRAMES):
        wp.synchronize_device(devices.NAME)
        start = time.perf_counter()
        sequence.call(k)
        wp.synchronize_device(devices.NAME)
        seconds.append(1e3 * (time.perf_counter() - start))
    later = np.array(seconds[FIRST:])
    return {
        "frames": len(later),
        "median_ms": float(np.median(later)),
        "p99_ms": float(np.quantile(later, 0.99)),
        "max_ms": float(later.max()),
        "first_ms": seconds[0],
        "ms": [round(value, 3) for value in seconds],
        **sequence.end(),
    }


def main() -> int:
    """Measure the remaining sequences; returns MORE if some remain."""
    state, end = Path(sys.argv[1]), time.monotonic() + float(sys.argv[2])
    with multiprocessing.get_context("spawn").Pool(1) as pool:  # the street is created beside the room
        drive = pool.map_async(street, [0])
        device, results = devices.start(), saved_part(state, "frames")
        data: dict[str, Any] = {"room": room(), "street": drive.get()[0]}
    for name, (source, make) in SEQUENCES.items():
        if name in results:
            continue
        if end - time.monotonic() < AT_LEAST:
            print("no time left before", name)
            return MORE
        try:
            results[name] = measured(make(data[source]))
        except Exception as error:
            traceback.print_exc(limit=4)
            results[name] = {"error": f"{type(error).__name__}: {str(error)[:300]}"}
        shown = {key: value for key, value in results[name].items() if key != "ms"}
        print(f"{name}: {shown}", flush=True)
        keep_part(state, device, "frames", results)
    return 1 if any("error" in each for each in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
