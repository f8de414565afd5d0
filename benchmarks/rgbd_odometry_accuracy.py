"""Errors of RGB-D odometry on real frames, and the rate of false successes.

    python benchmarks/rgbd_odometry_accuracy.py $POINTLOOM_DATA

Prints, for each method and frame distance in the kitchen sequence: median and 90th percentile of the errors over 40
pairs, and the number of failures. Then counts successes among pairs without overlap: frames of different data sets,
distant frames of the kitchen (correct poses are excluded), blank and half-blank frames. The ground truth is
KinectFusion's, so differences below a centimeter over long distances are not significant.
"""

from __future__ import annotations

import argparse
import itertools
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import pointloom as loom

STEPS, PAIRS, FRAMES = (1, 5, 10, 20), 40, 300
DEPTH_MAX = 6.0  # [m] as in docs/slam.md
RIGHT = (
    5.0,
    200.0,
)  # [deg, mm] larger errors of a success are false; the ground truth itself drifts by some centimeters


class Kitchen:
    """The 300 frames, prepared on demand."""

    def __init__(self, folder: Path):
        self.frames = loom.open_dataset(folder)
        self.prepare = cache(self._prepare)

    def _prepare(self, i: int) -> Any:
        frame = self.frames.read(i)
        return loom.rgbd.OdometryFrame(frame.depth, self.frames.intrinsic, frame.color, depth_max=DEPTH_MAX)

    def errors(self, pose: np.ndarray, i: int, j: int) -> tuple[float, float]:
        """Rotation error [deg] and translation error [mm]."""
        first, second = (self.frames.frames[k].T_world_camera for k in (i, j))
        error = np.linalg.inv(np.linalg.inv(second) @ first) @ pose
        u, _, vt = np.linalg.svd(error[:3, :3])
        cosine = (np.trace(u @ vt) - 1) / 2
        return float(np.degrees(np.arccos(np.clip(cosine, -1, 1)))), float(1000 * np.linalg.norm(error[:3, 3]))


def print_accuracy(kitchen: Kitchen) -> None:
    print("method         step   median deg   mm      p90 deg   mm   successes")
    for method in ("point-to-plane", "intensity", "hybrid"):
        for step in STEPS:
            errors, successes = [], 0
            for i in np.linspace(0, FRAMES - 1 - step, PAIRS).astype(int).tolist():
                frames = kitchen.prepare(i), kitchen.prepare(i + step)
                result = loom.rgbd.align_frames(*frames, method=method)
                errors.append(kitchen.errors(result.transformation, i, i + step))
                successes += result.reliable
            (angle, distance), (angle_90, distance_90) = np.median(errors, 0), np.percentile(errors, 90, 0)
            line = f"{method.name:14} {step:4d} {angle:12.3f} {distance:6.2f} {angle_90:10.2f} {distance_90:6.1f}"
            print(f"{line}   {successes} of {PAIRS}")


def other_frames(data: Path) -> dict[str, Any]:
    """Frames of other data sets; names start with the data set."""

    def read(path: Path) -> np.ndarray:
        return np.asarray(Image.open(path))

    def camera(f: float, cx: float, cy: float) -> loom.PinholeCameraIntrinsic:
        return loom.PinholeCameraIntrinsic(640, 480, f, f, cx, cy)

    make, frames = loom.rgbd.OdometryFrame, {}
    redwood = data / "rgbd-cupoch-redwood5"
    pairs = zip(sorted(redwood.glob("color/*")), sorted(redwood.glob("depth/*")), strict=True)
    for k, (color, depth) in enumerate(pairs):
        frames[f"redwood {k}"] = make(read(depth), camera(525.0, 319.5, 239.5), read(color)[..., :3])
    sun = data / "rgbd-nvblox-3dmatch" / "seq-01"
    for depth in sorted(sun.glob("*.depth.png")):
        color = read(depth.with_name(depth.name.replace("depth", "color")))[..., :3]
        frames[f"3dmatch {depth.name[6:12]}"] = make(read(depth).astype(np.uint16), camera(570.34, 320.0, 240.0), color)
    desk = data / "rgbd-slambook-ch7"
    for k in (1, 2):
        color, depth = read(desk / f"{k}.png")[..., :3], read(desk / f"{k}_depth.png")
        frames[f"slambook {k}"] = make(depth, camera(521.0, 325.1, 249.7), color, depth_scale=5000.0)
    for case in (1, 2):
        folder = data / "rgbd-tum-pairs" / f"case_{case}"
        for time in ("prev", "curr"):
            color, depth = read(folder / f"img_{time}.png")[..., :3], read(folder / f"dep_{time}.png")
            frame = make(depth, camera(525.0, 319.5, 239.5), color, depth_scale=5000.0)
            frames[f"tum{case} {time}"] = frame
    return frames


def print_like_pairs(frames: dict[str, Any]) -> None:
    names = list(frames)
    for first, second in itertools.pairwise(names):
        if first.split()[0] == second.split()[0]:
            result = loom.rgbd.align_frames(frames[first], frames[second])
            angle = np.degrees(np.arccos(np.clip((np.trace(result.transformation[:3, :3]) - 1) / 2, -1, 1)))
            distance = 1000 * np.linalg.norm(result.transformation[:3, 3])
            figures = f"{angle:.2f} deg {distance:.1f} mm, rmse {1000 * result.inlier_rmse:.1f} mm"
            status, warnings = "success" if result.reliable else "no success", " ".join(result.warnings)
            print(f"{first} -> {second}: {status}, {figures} {warnings}")


def unlike_pairs(kitchen: Kitchen, frames: dict[str, Any]) -> Iterator[tuple[Any, Any]]:
    for name, frame in frames.items():
        for i in range(0, FRAMES, 30):
            yield frame, kitchen.prepare(i)
            yield kitchen.prepare(i), frame
        yield from ((frame, other) for key, other in frames.items() if key[:3] != name[:3])


def blank_pairs(kitchen: Kitchen) -> Iterator[tuple[Any, Any]]:
    make, camera = loom.rgbd.OdometryFrame, kitchen.frames.intrinsic
    blank = make(np.zeros((480, 640), np.uint16), camera, np.zeros((480, 640, 3), np.uint8))
    for i in range(0, FRAMES, 6):
        complete, frame = kitchen.prepare(i), kitchen.frames.read(i)
        yield from ((blank, complete), (complete, blank))
        sides = []
        for side in (slice(0, 320), slice(320, 640)):
            depth, color = np.zeros_like(frame.depth), np.zeros_like(frame.color)
            depth[:, side], color[:, side] = frame.depth[:, side], frame.color[:, side]
            sides.append(make(depth, camera, color))
        yield from ((sides[0], sides[1]), (sides[1], sides[0]))


def count_successes(pairs: Any) -> str:
    results = [
        loom.rgbd.align_frames(*pair, method=method) for pair in pairs for method in ("hybrid", "point-to-plane")
    ]
    return f"{sum(result.reliable for result in results)} of {len(results)}"


def print_far_pairs(kitchen: Kitchen, count: int = 400) -> None:
    rng, right, false, missed, farthest = np.random.default_rng(1), 0, 0, 0, (0.0, 0.0)
    pairs = [sorted(rng.integers(0, FRAMES, 2).tolist()) for _ in range(count)]
    for i, j in pairs:
        result = loom.rgbd.align_frames(kitchen.prepare(i), kitchen.prepare(j))
        errors = kitchen.errors(result.transformation, i, j)
        is_right = errors[0] < RIGHT[0] and errors[1] < RIGHT[1]
        right += result.reliable and is_right
        false += result.reliable and not is_right
        missed += not result.reliable and is_right
        farthest = max(farthest, errors) if result.reliable else farthest
    refused = count - right - false - missed
    print(
        f"{count} random pairs of the kitchen: {right} correct successes, {false} false ones, {missed} correct rejected"
    )
    print(f"  {refused} wrong rejected; largest error of a success: {farthest[0]:.1f} deg {farthest[1]:.0f} mm")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=Path)
    data = parser.parse_args().data
    kitchen, frames = Kitchen(data / "rgbd-7scenes-redkitchen"), other_frames(data)
    print_accuracy(kitchen)
    print_like_pairs(frames)
    print("false successes, different data sets:", count_successes(unlike_pairs(kitchen, frames)))
    print("false successes, blank or half-blank:", count_successes(blank_pairs(kitchen)))
    print_far_pairs(kitchen)


if __name__ == "__main__":
    main()
