"""Wrong cameras of RGB-D frames: color of another camera, flipped images, a lens with distortion, a wrong depth unit.

    python benchmarks/trust/cameras.py

Each fault is one result of `track` and one of `fuse` with true poses, on sites of seeds that chose no constant
(places.py). It is accepted if the result has no warning. Color of a raw Kinect (0.9 of the focal length, 25 mm to the
side) hardly affects poses and is a note, so it counts as correct.
"""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import places
import sensors
from judged import Judged, table

SEED, FRAMES, SCALE, EVERY = 44, 45, 0.5, 4
KINDS = ("corridor", "hall", "table", "staircase", "tunnel")
DISTORTION, WIDE = -0.25, 0.7  # k1 of a wide lens, and its focal length relative to the usual one
COLORS = {"color of a raw Kinect": (0.9, -0.025), "color of a raw RealSense": (1.55, -0.015)}  # focal length, [m]
WRONG_DEPTHS = {"millimeters read as 5,000 units": 0.2, "5,000 units read as millimeters": 5.0}


def judge() -> Iterator[Judged]:
    """The cases; about a minute of CPU time."""
    for kind in KINDS:
        yield from judge_site(kind, SEED)


def judge_site(kind: str, seed: int) -> Iterator[Judged]:
    site = places.KINDS[kind](seed)
    camera = sensors.DepthCamera(site, seed, scale=SCALE)
    way = {"table": sensors.around, "staircase": sensors.climb}.get(kind, sensors.walking_path)
    poses = way(FRAMES, seed)
    frames = [integers(f) for f in camera.film(poses)]
    K = camera.intrinsic
    yield from judged(f"{kind} {seed}, correct", frames, K, is_wrong=False)
    for name, (focal, aside) in COLORS.items():
        other = sensors.DepthCamera(site, seed, scale=SCALE, zoom=focal)
        shift = np.eye(4)
        shift[0, 3] = aside
        changed = [with_color(f, other.image(T @ shift, k)) for k, (f, T) in enumerate(zip(frames, poses, strict=True))]
        yield from judged(f"{kind} {seed}, {name}", changed, K, is_wrong=focal > 1)
    for name, (rows, columns) in {"mirrored": (1, -1), "rotated by 180 degrees": (-1, -1)}.items():
        changed = [with_color(f, np.ascontiguousarray(f.color[::rows, ::columns])) for f in frames]
        yield from judged(f"{kind} {seed}, color {name}", changed, K)
    swapped = dataclasses.replace(K, cx=K.cy, cy=K.cx)
    yield from judged(f"{kind} {seed}, cx and cy swapped", frames, swapped)
    for name, factor in WRONG_DEPTHS.items():
        changed = [of(np.rint(f.depth * (1.0 if factor < 1 else factor)).astype(np.uint16), f) for f in frames]
        yield from judged(f"{kind} {seed}, {name}", changed, K, depth_scale=5000.0 if factor < 1 else 1000.0)
    wide = sensors.DepthCamera(site, seed, scale=SCALE, zoom=WIDE)
    for k1 in (0.0, DISTORTION):
        wide.rays = undistorted(wide.rays, k1)
        lens = f"k1 of {k1}, omitted" if k1 else "a wide lens without distortion"
        yield from judged(
            f"{kind} {seed}, {lens}", [integers(f) for f in wide.film(poses)], wide.intrinsic, is_wrong=k1 != 0
        )


def undistorted(rays: Any, k1: float) -> Any:
    """Rays of the pixels of a lens with x (1 + k1 r^2) at the ray x."""
    x = rays[..., :2].copy()
    for _ in range(20):
        x = rays[..., :2] / (1 + k1 * (x**2).sum(-1, keepdims=True))
    return np.concatenate([x, rays[..., 2:]], axis=-1)


def of(depth: Any, frame: Any) -> Any:
    return SimpleNamespace(**{**vars(frame), "depth": depth})


def integers(frame: Any) -> Any:
    """A frame with depth in millimeters."""
    depth = np.rint(1000 * frame.depth).astype(np.uint16)
    return SimpleNamespace(
        depth=depth, color=frame.color, timestamp=frame.timestamp, name=frame.name, T_world_camera=frame.pose
    )


def with_color(frame: Any, color: Any) -> Any:
    return SimpleNamespace(**{**vars(frame), "color": color})


def judged(
    case: str, frames: Sequence[Any], camera: Any, *, is_wrong: bool = True, depth_scale: float = 1000.0
) -> Iterator[Judged]:
    import pointloom as loom

    path = loom.rgbd.track(loom.frames_from(list(frames), camera, depth_scale=depth_scale), voxel_size=0.02)
    fused = loom.rgbd.fuse(loom.frames_from(list(frames[::EVERY]), camera, depth_scale=depth_scale), voxel_size=0.02)
    for name, result in (("track", path), ("fuse", fused)):
        warnings, notes = "; ".join(result.warnings), "; ".join(result.notes)
        area = f"camera of RGB-D frames, {name}"
        accepted, refused = int(is_wrong and not warnings), int(not is_wrong and bool(warnings))
        yield Judged(area, case, 1, int(is_wrong), accepted, refused, warnings or notes)


if __name__ == "__main__":
    for number, one in enumerate(judge()):
        print("\n".join(table([one])[2 if number else 0 :]), flush=True)
