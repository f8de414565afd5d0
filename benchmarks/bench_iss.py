"""compute_iss_keypoints, including the search structure and the choice of the radii."""

from __future__ import annotations

from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, load_open3d, timed, waiting


def surface(count: int) -> Any:
    return lambda: scenes.bumpy_surface(count)


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(points, device=device)
    return Trial(waiting(loom.compute_iss_keypoints, device, "warp"), setup=lambda: anew(cloud))


def prepare_open3d_legacy(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return lambda: o3d.geometry.keypoint.compute_iss_keypoints(cloud)


def in_order(cloud: Any) -> np.ndarray:
    """The keypoints as sorted rows."""
    return np.unique(np.asarray(cloud.points), axis=0)


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same points; those with neighbors exactly on the radius may differ."""
    keypoints, baseline_keypoints = ({tuple(p) for p in points} for points in (actual, reference))
    different = len(keypoints ^ baseline_keypoints)
    assert different <= 0.01 * len(baseline_keypoints), (
        f"{different} of {len(baseline_keypoints)} keypoints are not {peer}'s"
    )


OPERATION = Operation(
    name="iss_keypoints",
    scenes={"1k": surface(1000), "200k": surface(200_000), "1M": surface(1_000_000)},
    quick={"50k": surface(50_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, in_order, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, in_order),
    ),
    check=check,
    memory_size="200k",
    targets={"200k": 5, "1M": 5},
)
OPERATIONS = (OPERATION,)


@timed(OPERATION)
def test_iss_keypoints(time_lap) -> None:
    time_lap()
