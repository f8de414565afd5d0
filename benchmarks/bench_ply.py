"""Binary PLY with positions (float) and colors (uchar), beside Open3D's tensor cloud.

The file to read is in the page cache. Writing ends when the file is renamed, not when it is on disk.
"""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, load_open3d, timed
from reasons import CALL


def reading_pointloom(scene: scenes.ColoredPoints, device: str) -> Any:
    import pointloom as loom

    path = scene.source
    return lambda: loom.read_point_cloud(path)


def reading_open3d(scene: scenes.ColoredPoints, device: str) -> Any:
    o3d = load_open3d()
    path = scene.source
    return lambda: o3d.t.io.read_point_cloud(path)


def writing_pointloom(scene: scenes.ColoredPoints, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(scene.points, colors=scene.colors)
    return _writing(scene, "pointloom", lambda path: loom.write_point_cloud(path, cloud))


def writing_open3d(scene: scenes.ColoredPoints, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(scene.points))
    cloud.point.colors = o3d.core.Tensor(scene.colors)
    return _writing(scene, "open3d", lambda path: o3d.t.io.write_point_cloud(path, cloud))


def _writing(scene: scenes.ColoredPoints, name: str, write: Any) -> Trial:
    """A new file for each call: replacing a file would also time the removal of the old one."""
    path = scene.path(name)

    def write_path(_: None) -> str:
        write(path)
        return path

    return Trial(write_path, setup=lambda: Path(path).unlink(missing_ok=True))


def facts_pointloom(cloud: Any) -> tuple[np.ndarray, np.ndarray]:
    return cloud.points.astype(np.float32), np.round(cloud.colors * 255).astype(np.uint8)


def facts_open3d(cloud: Any) -> tuple[np.ndarray, np.ndarray]:
    return cloud.point.positions.numpy(), cloud.point.colors.numpy()


def facts_of_file(path: str) -> tuple[np.ndarray, np.ndarray]:
    """The file's content as Open3D reads it."""
    return facts_open3d(load_open3d().t.io.read_point_cloud(path))


def check(actual: tuple[np.ndarray, np.ndarray], reference: tuple[np.ndarray, np.ndarray], peer: str) -> None:
    """Check for bitwise identical content."""
    for own, other, name in zip(actual, reference, ("points", "colors"), strict=True):
        assert own.dtype == other.dtype, f"{name}: {own.dtype}, {peer} {other.dtype}"
        assert own.shape == other.shape, f"{name}: {own.shape}, {peer} {other.shape}"
        assert np.array_equal(own, other), f"{name} differ from {peer}'s"


READ = Operation(
    name="ply_read",
    scenes={"1k": partial(scenes.colored_points, 1000), "5M": partial(scenes.colored_points, 5_000_000)},
    quick={"200k": partial(scenes.colored_points, 200_000)},
    contestants=(
        Contestant(POINTLOOM, reading_pointloom, facts_pointloom),
        Contestant("open3d-tensor", reading_open3d, facts_open3d),
    ),
    check=check,
    targets={"5M": 1},
    reasons={"1k": CALL},
)
WRITE = Operation(
    name="ply_write",
    scenes=READ.scenes,
    quick=READ.quick,
    contestants=(
        Contestant(POINTLOOM, writing_pointloom, facts_of_file),
        Contestant("open3d-tensor", writing_open3d, facts_of_file),
    ),
    check=check,
    targets={"5M": 1},
    reasons={"1k": CALL},
)
OPERATIONS = (READ, WRITE)


@timed(READ)
def test_ply_read(time_lap) -> None:
    time_lap()


@timed(WRITE)
def test_ply_write(time_lap) -> None:
    time_lap()
