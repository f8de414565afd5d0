"""RGB-D tracking: repetitive scenes, drift with small residuals, small curved objects, real frames.

The scenes are ray cast boxes and spheres with a Kinect's noise. A frame is wrong if its error exceeds 10 cm; poses with
status `uncertain` and `lost` are rejected.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from types import SimpleNamespace
from typing import Any

import numpy as np
from judged import Judged
from real_data import DataMissingError, real_data

import pointloom as loom

AREA, WRONG = "RGB-D tracking", 0.10  # [m]
CAMERA = loom.PinholeCameraIntrinsic(160, 120, 131.0, 131.0, 79.5, 59.5)
VOXEL_SIZE = 0.02  # [m]


def judge() -> Iterator[Judged]:
    for texture in (0.0, 25.0):
        frames = [corridor_frame(i, texture, is_covered=40 <= i < 70) for i in range(100)]
        name = "texture" if texture else "no texture"
        yield tracked(f"corridor of identical doors, {name}, covered for one door", frames, CAMERA, held_out=False)
    yield tracked("table of balls, once around", [table_frame(i, 100) for i in range(100)], CAMERA, held_out=True)
    try:
        data = loom.open_dataset(real_data("rgbd-7scenes-redkitchen"), every=5)
    except DataMissingError as error:
        print(f"kitchen: left out, {error}", file=sys.stderr)
        return
    frames = [data.read(i) for i in range(len(data))]
    yield tracked("kitchen, every 5th frame", frames, data.intrinsic, held_out=False)
    yield tracked("kitchen, every 5th frame, 20 covered", covered(frames, 20, 40), data.intrinsic, held_out=True)


def tracked(case: str, frames: Sequence[Any], camera: Any, *, held_out: bool) -> Judged:
    """The tracking result for frames with known poses."""
    slam = loom.rgbd.DenseSLAM(camera, voxel_size=VOXEL_SIZE, T_init=frames[0].T_world_camera)
    results = slam.run(frames)
    wrong = accepted = rejected = count = 0
    worst = sigma = 0.0
    for frame, result in zip(frames, results, strict=True):
        if not np.any(np.asarray(frame.depth)):
            continue
        count += 1
        distance = np.inf
        if result.pose is not None:
            distance = float(np.linalg.norm(result.pose[:3, 3] - frame.T_world_camera[:3, 3]))
            worst, sigma = max(worst, distance), max(sigma, result.position_deviation)
        is_wrong = result.pose is not None and distance > WRONG
        wrong += is_wrong
        accepted += is_wrong and result.is_tracked
        rejected += not is_wrong and not result.is_tracked
    counts = slam.status_counts
    message = f"{counts['tracked']} tracked, {counts['uncertain']} uncertain, {counts['lost']} lost"
    error = f"{100 * worst:.1f} cm at worst, estimated deviation {100 * sigma:.1f} cm"
    return Judged(AREA, case, count, wrong, accepted, rejected, message, error, held_out=held_out)


def covered(frames: Sequence[Any], first: int, last: int) -> list[Any]:
    """The frames with some of them black."""
    black = {"depth": np.zeros_like(frames[0].depth), "color": np.zeros_like(frames[0].color)}
    fields = ("depth", "color", "T_world_camera", "timestamp", "name")
    return [
        SimpleNamespace(**{name: getattr(frame, name, None) for name in fields} | (black if first <= i < last else {}))
        for i, frame in enumerate(frames)
    ]


def corridor_frame(number: int, texture: float, *, is_covered: bool) -> Any:
    """A path of 5 cm per frame along a corridor with doors 1.5 m apart that protrude by 6 cm."""
    boxes = [((-30.0, -1.0, 0.0), (60.0, 1.0, 2.5), True)]
    for k in range(-2, 10):
        for side in (-1, 1):
            middle = (1.5 * k + 0.75, 0.97 * side, 1.05)
            half = (0.45, 0.05, 1.05)
            low, high = np.subtract(middle, half), np.add(middle, half)
            boxes.append((tuple(low), tuple(high), False))
    t = number / 30.0
    eye = np.array([1.0 + 0.05 * number, 0.05 * np.sin(2 * t), 1.5])
    ahead = np.array([2.0, 0.3 * np.sin(1.3 * t), -0.5])
    return rendered(number, looking(eye, ahead), boxes, [], texture, is_covered)


def table_frame(number: int, count: int) -> Any:
    """A full circle around a table with spheres and small boxes."""
    boxes = [((-4.0, -4.0, 0.0), (4.0, 4.0, 3.0), True), ((-0.7, -0.5, 0.7), (0.7, 0.5, 0.74), False)]
    boxes += [((-0.5, 0.24, 0.74), (-0.3, 0.36, 0.86), False), ((0.1, 0.25, 0.74), (0.2, 0.35, 1.0), False)]
    balls = [
        ((0.1, 0.0, 0.86), 0.12),
        ((-0.3, -0.1, 0.83), 0.09),
        ((0.4, -0.2, 0.80), 0.06),
        ((-0.1, -0.3, 0.79), 0.05),
    ]
    angle = 2 * np.pi * number / count
    eye = np.array([np.cos(angle), np.sin(angle), 1.25])
    return rendered(number, looking(eye, np.array([0.0, 0.0, 0.8]) - eye), boxes, balls, 12.0, False)


def looking(eye: np.ndarray, ahead: np.ndarray) -> np.ndarray:
    """T_world_camera of a camera that looks ahead, with z up in the world."""
    z = ahead / np.linalg.norm(ahead)
    x = np.cross(z, [0.0, 0.0, 1.0])
    x /= np.linalg.norm(x)
    T = np.eye(4)
    T[:3, :4] = np.column_stack([x, np.cross(z, x), z, eye])
    return T


def rendered(number: int, T: np.ndarray, boxes: list, balls: list, texture: float, is_covered: bool) -> Any:
    """A frame of boxes (from inside if the last value is True) and spheres, with noise seeded by its number."""
    rng = np.random.default_rng(number)
    v, u = np.mgrid[: CAMERA.height, : CAMERA.width]
    rays = np.stack([(u - CAMERA.cx) / CAMERA.fx, (v - CAMERA.cy) / CAMERA.fy, np.ones(u.shape)], -1)
    rays[..., :2] += rng.normal(0, 0.2, (*u.shape, 2)) / CAMERA.fx
    directions, eye = rays @ T[:3, :3].T, T[:3, 3]
    depth = np.full(u.shape, np.inf)
    with np.errstate(divide="ignore"):
        for low, high, is_inside in boxes:
            ends = (np.array([low, high])[:, None, None] - eye) / directions
            near, far = ends.min(0).max(-1), ends.max(0).min(-1)
            hit = np.where(is_inside, far, np.where((near < far) & (near > 0), near, np.inf))
            depth = np.minimum(depth, hit)
    for middle, radius in balls:
        m, square = eye - np.array(middle), (directions**2).sum(-1)
        half = directions @ m
        under = half**2 - square * (m @ m - radius**2)
        depth = np.where(under > 0, np.minimum(depth, (-half - np.sqrt(np.maximum(under, 0))) / square), depth)
    points = eye + depth[..., None] * directions
    x, y, z = np.moveaxis(points, -1, 0)
    shade = 140 + texture * (
        np.sin(7.1 * x + 3 * z) + np.sin(2.3 * x - 5 * y + 1) + 0.7 * np.sin(17 * z + 11 * x + 5 * y)
    )
    shade = shade + rng.normal(0, 2, shade.shape)
    depth = depth + rng.normal(0, 1, depth.shape) * (0.0012 + 0.0019 * np.maximum(depth - 0.4, 0) ** 2)
    image = np.where((depth > 0.35) & (depth < 4.5) & (not is_covered), np.rint(1000 * depth), 0).astype(np.uint16)
    color = np.repeat(np.where(is_covered, 0, shade)[..., None], 3, 2).clip(0, 255).astype(np.uint8)
    return SimpleNamespace(depth=image, color=color, T_world_camera=T, timestamp=number / 30.0, name=str(number))


if __name__ == "__main__":
    for answer in judge():
        print(answer, flush=True)
