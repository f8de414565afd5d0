"""hidden_point_removal: a surface seen from above, as in Open3D's tutorial, and a real indoor scene."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed, waiting
from real_data import real_data


@dataclass(frozen=True)
class View:
    """Points, and the tutorial's camera: height equal to the cloud's size, radius 100 times that."""

    points: np.ndarray

    @property
    def size(self) -> float:
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))

    @property
    def camera(self) -> list[float]:
        return [0.0, 0.0, self.size]


def surface(count: int) -> Callable[[], View]:
    return lambda: View(scenes.bumpy_surface(count))


def fragment() -> View:
    path = real_data("cloud-cupoch/fragment.pcd")
    return View(np.asarray(load_open3d().io.read_point_cloud(str(path)).points))


def prepare_pointloom(view: View, device: str) -> Any:
    import pointloom as loom

    cloud, camera, radius = loom.PointCloud(view.points, device=device), view.camera, 100 * view.size
    return waiting(lambda: cloud.hidden_point_removal(camera, radius)[1], device, "warp")


def prepare_open3d(view: View, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(view.points))
    camera, radius = view.camera, 100 * view.size
    return lambda: cloud.hidden_point_removal(camera, radius)[1]


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same visible points, except for duplicates, of which either may be visible."""
    assert len(actual) == len(reference), f"{len(actual)} points are visible, {len(reference)} for {peer}"
    assert len(np.intersect1d(actual, reference)) > 0.999 * len(actual), f"the visible points are not {peer}'s"


HIDDEN = Operation(
    name="hidden_points",
    scenes={"1k": surface(1000), "200k": surface(200_000), "1M": surface(1_000_000), "fragment": fragment},
    quick={"50k": surface(50_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, np.sort, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, np.sort),
    ),
    check=check,
    memory_size="1M",
    targets={"200k": 3, "1M": 1, "fragment": 3},
)
OPERATIONS = (HIDDEN,)


@timed(HIDDEN)
def test_hidden_points(time_lap) -> None:
    time_lap()
