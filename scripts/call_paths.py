"""Count the files and functions of pointloom that a later call of some operations enters: part of `make totals`.

A call should read as check, prepare, launch, return. The output is one line of JSON.
"""

from __future__ import annotations

import contextlib
import gc
import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import pointloom as loom

PACKAGE = str(Path(loom.__file__).parent) + "/"
COMPREHENSIONS = {"<listcomp>", "<setcomp>", "<dictcomp>", "<genexpr>"}  # Python versions differ in their frames
POINTS = 20_000


def path_of(call: Callable[[], Any]) -> tuple[int, int]:
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
    return len({file for file, _ in entered}), len(entered)


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
    registration = loom.registration
    return {
        "register_globally": lambda: registration.register_globally(source, target, voxel_size=0.05),
        "estimate_normals(max_nn=30)": lambda: loom.PointCloud(surface).estimate_normals(max_nn=30),
        "estimate_normals(radius=0.1, max_nn=30)": lambda: loom.PointCloud(surface).estimate_normals(
            radius=0.1, max_nn=30
        ),
        "registration_icp, point to plane": lambda: registration.registration_icp(
            source.transform(pose), with_normals, 0.1, None, registration.TransformationEstimationPointToPlane()
        ),
        "TSDFVolume.integrate": lambda: volume.integrate(depth, camera, np.eye(4), color),
        "voxel_down_sample": lambda: target.voxel_down_sample(0.05),
        "segment_plane": lambda: target.segment_plane(0.01, 3, 100),
    }


if __name__ == "__main__":
    loom.set_num_threads(1)  # whether a launch uses the thread pool depends on its duration
    paths = {}
    for name, call in operations().items():
        with contextlib.suppress(AttributeError, TypeError):  # other versions may lack a name or a parameter
            paths[name] = path_of(call)
    print(json.dumps(paths))
