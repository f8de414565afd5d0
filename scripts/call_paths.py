"""Count the files and functions of pointloom that a later call of six operations enters: part of `make lint`.

A call should read as check, prepare, launch, return. The limits may only be lowered.
"""

from __future__ import annotations

import gc
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import pointloom as loom

PACKAGE = str(Path(loom.__file__).parent) + "/"
COMPREHENSIONS = {"<listcomp>", "<setcomp>", "<dictcomp>", "<genexpr>"}  # Python versions differ in their frames
POINTS = 20_000
LIMITS = {  # operation: files and functions, at most
    "register_globally": (61, 241),
    "estimate_normals(max_nn=30)": (26, 62),
    "estimate_normals(radius=0.1, max_nn=30)": (30, 76),
    "registration_icp, point to plane": (39, 120),
    "TSDFVolume.integrate": (25, 74),
    "voxel_down_sample": (16, 29),
    "segment_plane": (19, 44),
}


class CallPath(NamedTuple):
    """Files and functions of the library that a call enters."""

    files: int
    functions: int


def path_of(call: Callable[[], Any]) -> CallPath:
    """Run a call twice, which loads and prepares its kernels, and count what the third one enters in this thread."""
    entered: set[tuple[str, str]] = set()

    def record(frame: Any, event: str, _: Any) -> None:
        code = frame.f_code
        if event == "call" and code.co_filename.startswith(PACKAGE) and code.co_name not in COMPREHENSIONS:
            entered.add((code.co_filename, code.co_qualname))

    for _ in range(2):
        call()
    gc.collect()
    gc.disable()  # its finalizers would count
    sys.setprofile(record)
    try:
        call()
    finally:
        sys.setprofile(None)
        gc.enable()
    return CallPath(len({file for file, _ in entered}), len(entered))


def operations() -> dict[str, Callable[[], Any]]:
    """The operations on small scenes: two halves of a wavy surface and a flat depth image."""
    rng = np.random.default_rng(0)
    x, y = rng.uniform(-1, 1, (2, POINTS))
    surface = np.column_stack([x, y, 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)])
    pose = np.array([[0, -1, 0, 5], [1, 0, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1.0]])
    target, moved = loom.PointCloud(surface[x < 0.6]), loom.PointCloud(surface[x > -0.6])
    source, with_normals = moved.transform(np.linalg.inv(pose)), target.estimate_normals(max_nn=30)
    camera, volume = loom.PinholeCameraIntrinsic(64, 48, 50, 50, 32, 24), loom.TSDFVolume(voxel_size=0.05)
    depth, color = np.ones((48, 64), np.float32), np.zeros((48, 64, 3), np.uint8)
    icp, plane = loom.registration.registration_icp, loom.registration.TransformationEstimation.point_to_plane
    calls = (
        lambda: loom.registration.register_globally(source, target, voxel_size=0.05),
        lambda: loom.PointCloud(surface).estimate_normals(max_nn=30),
        lambda: loom.PointCloud(surface).estimate_normals(radius=0.1, max_nn=30),
        lambda: icp(source.transform(pose), with_normals, 0.1, None, plane()),
        lambda: volume.integrate(depth, camera, np.eye(4), color),
        lambda: target.voxel_down_sample(0.05),
        lambda: target.segment_plane(0.01, 3, 100),
    )
    return dict(zip(LIMITS, calls, strict=True))


def main() -> int:
    """The command."""
    loom.set_num_threads(1)  # whether a launch uses the thread pool depends on its duration
    is_over = False
    for name, call in operations().items():
        path, limits = path_of(call), CallPath(*LIMITS[name])
        is_over |= path.files > limits.files or path.functions > limits.functions
        print(
            f"{name}: {path.files} files (at most {limits.files}), "
            f"{path.functions} functions (at most {limits.functions})"
        )
    if is_over:
        print("A call enters more files or functions than allowed; shorten its path", file=sys.stderr)
    return int(is_over)


if __name__ == "__main__":
    sys.exit(main())
