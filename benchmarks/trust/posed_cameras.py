"""Wrong cameras of frames with known poses, as `fuse` gets them: focal lengths, principal points, depth units.

    python benchmarks/trust/run.py --only posed_cameras --all --cases

Windows of 30 to 150 frames of a kitchen (frames 150 to 299) and walks of 24 frames through the sites of places.py, with
the right camera and with 11 other ones each. A camera is wrong if it displaces more than a quarter of the measured
points by over 3 cm along their normals. Other cameras with smaller errors do not count. Fits of single values were
chosen on frames 0 to 149 and on sites of seeds 700 and 701. Older limits were chosen on all frames of the kitchen.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator, Sequence
from functools import partial
from types import SimpleNamespace
from typing import Any

import numpy as np
import places
import sensors
from judged import Case, Judged
from real_data import DataMissingError
from rgbd_recordings import opened

AREA, FAR, MAX_FRACTION, MAX_DEPTH = "camera of posed frames, fuse", 0.03, 0.25, 4.0  # [m]
SEEDS, SITE_FRAMES, EVERY, POSE_NOISES = (710, 711), 24, 3, (0.0, 0.003, 0.01)
WINDOWS, SHORTEST, LONGEST, MOST_FRAMES = 20, 30, 150, 40
CENTER = 0.05  # of the width
# Factors of fx and fy, displacement of the principal point in widths, and factor of the depth.
CAMERAS = {
    "right": (1.0, 1.0, 0.0, 0.0, 1.0),
    "f x 1.1": (1.1, 1.1, 0.0, 0.0, 1.0),
    "f x 0.9": (0.9, 0.9, 0.0, 0.0, 1.0),
    "fx x 1.1": (1.1, 1.0, 0.0, 0.0, 1.0),
    "cx + 5%": (1.0, 1.0, CENTER, 0.0, 1.0),
    "cx - 5%": (1.0, 1.0, -CENTER, 0.0, 1.0),
    "cy + 5%": (1.0, 1.0, 0.0, CENTER, 1.0),
    "cy - 5%": (1.0, 1.0, 0.0, -CENTER, 1.0),
    "1,050 units": (1.0, 1.0, 0.0, 0.0, 1 / 1.05),
    "950 units": (1.0, 1.0, 0.0, 0.0, 1 / 0.95),
    "1,100 units": (1.0, 1.0, 0.0, 0.0, 1 / 1.1),
    "900 units": (1.0, 1.0, 0.0, 0.0, 1 / 0.9),
}


def cases() -> Iterator[Case]:
    for number in range(WINDOWS):
        yield Case(f"kitchen, window {number}", partial(_kitchen, number))
    for seed, kind in itertools.product(SEEDS, places.KINDS):
        yield Case(f"{kind} {seed}", partial(_site, kind, seed))


def _kitchen(number: int) -> Iterator[Judged]:
    frames = next((each for each in opened(is_fitted=False) if each.recording.camera == "Kinect, kitchen"), None)
    if frames is None:
        raise DataMissingError("rgbd-7scenes-redkitchen does not exist in POINTLOOM_DATA")
    rng = np.random.default_rng([number, 30])
    count = int(rng.integers(SHORTEST, LONGEST + 1))
    first = int(rng.integers(0, len(frames.numbers) - count + 1))
    read = [frames.read(k) for k in frames.numbers[first : first + count : max(1, count // MOST_FRAMES)]]
    name = f"kitchen {frames.numbers[first]} to {frames.numbers[first] + count - 1}"
    yield from _judged(name, frames.data.intrinsic, [f.depth for f in read], np.array([f.pose for f in read]))


def _site(kind: str, seed: int) -> Iterator[Judged]:
    camera, rng = sensors.DepthCamera(places.KINDS[kind](seed), seed, scale=0.5), np.random.default_rng([seed, 77])
    way = {"table": sensors.around, "staircase": sensors.climb}.get(kind, sensors.walking_path)
    read = camera.film(way(SITE_FRAMES * EVERY, seed)[::EVERY])
    poses, noise = np.array([f.pose for f in read]), rng.choice(POSE_NOISES)
    poses[:, :3, 3] += rng.normal(0, noise / np.sqrt(3), (len(poses), 3))
    yield from _judged(f"{kind} {seed}", camera.intrinsic, [f.depth for f in read], poses)


def _judged(name: str, K: Any, depths: Sequence[np.ndarray], poses: np.ndarray) -> Iterator[Judged]:
    import pointloom as loom

    for camera, (fx, fy, u, v, unit) in CAMERAS.items():
        shift = u * K.width, v * K.width
        given = dataclasses.replace(K, fx=fx * K.fx, fy=fy * K.fy, cx=K.cx + shift[0], cy=K.cy + shift[1])
        fraction = _displaced(K, given, unit, depths[:: max(1, len(depths) // 16)])
        if camera != "right" and fraction <= MAX_FRACTION:
            continue
        frames = [
            SimpleNamespace(depth=z * np.float32(unit), color=None, T_world_camera=T, timestamp=None, name=str(k))
            for k, (z, T) in enumerate(zip(depths, poses, strict=True))
        ]
        result = loom.rgbd.fuse(loom.frames_from(frames, given), voxel_size=0.02, depth_max=MAX_DEPTH)
        warnings, wrong = "; ".join(result.warnings), camera != "right"
        accepted, refused = wrong and not warnings, not wrong and bool(warnings)
        text = warnings or "; ".join(result.notes)
        yield Judged(AREA, f"{name}, {camera}", 1, wrong, accepted, refused, text, f"{fraction:.0%} displaced")


def _displaced(K: Any, given: Any, unit: float, depths: Sequence[np.ndarray]) -> float:
    """Fraction of the points that another camera displaces by over 3 cm along their normals."""
    step, distances = max(1, K.width // 80), []
    for depth in depths:
        z = depth[::step, ::step].astype(np.float64)
        true, other = _points(K, z, step), _points(given, z * unit, step)
        along, across = true[1:-1, 2:] - true[1:-1, :-2], true[2:, 1:-1] - true[:-2, 1:-1]
        normals = np.cross(along, across)
        normals /= np.maximum(np.linalg.norm(normals, axis=-1, keepdims=True), 1e-9)
        seen = (z > 0) & (z < MAX_DEPTH)
        is_surface = seen[1:-1, 1:-1] & seen[1:-1, 2:] & seen[1:-1, :-2] & seen[2:, 1:-1] & seen[:-2, 1:-1]
        is_surface &= (np.linalg.norm(along, axis=-1) < 0.3) & (np.linalg.norm(across, axis=-1) < 0.3)
        distances.append(np.abs(((other - true)[1:-1, 1:-1] * normals).sum(axis=-1))[is_surface])
    every = np.concatenate(distances)
    return float((every > FAR).mean()) if len(every) else 0.0


def _points(K: Any, z: np.ndarray, step: int) -> np.ndarray:
    v, u = np.mgrid[: z.shape[0], : z.shape[1]] * step
    return np.stack([(u - K.cx) / K.fx * z, (v - K.cy) / K.fy * z, z], axis=-1)
