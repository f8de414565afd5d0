"""farthest_point_down_sample to 1000 points, the search structure included, beside Open3D's point clouds and fpsample.

fpsample runs on one core whatever the number of threads. It begins at a point of its own choice, so that its points are
others; whether they are as far apart is what can be compared.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import OURS, Contestant, Operation, Trial, anew, load_open3d, open3d_device, timed, waiting

SAMPLES = 1000
TREE_HEIGHT = 7  # of fpsample, the best of 3, 5, 7, 9 and 11 at 200k and at 1M
ANY_START = 0.1  # relative difference of distances between sequences from two starts


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    cloud = loom.PointCloud(points, device=device)
    return Trial(waiting(lambda c: c.farthest_point_down_sample(SAMPLES), device, "warp"), setup=lambda: anew(cloud))


def prepare_open3d_legacy(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return lambda: cloud.farthest_point_down_sample(SAMPLES)


def prepare_open3d_tensor(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.t.geometry.PointCloud(o3d.core.Tensor(points.astype(np.float32), device=open3d_device(device)))
    return waiting(lambda: cloud.farthest_point_down_sample(SAMPLES), device, "open3d")


def prepare_fpsample(points: np.ndarray, device: str) -> Any:
    import fpsample

    given = points.astype(np.float32)
    return lambda: given[fpsample.bucket_fps_kdline_sampling(given, SAMPLES, h=TREE_HEIGHT, start_idx=0)]


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    """As many points, as far apart, and most of them the same: one near-tie that float32 decides moves a few others."""
    from scipy.spatial import cKDTree

    assert len(ours) == len(theirs)
    apart = [cKDTree(points).query(points, k=2)[0][:, 1].min() for points in (ours, theirs)]
    begins_elsewhere = peer.startswith("fpsample")
    limit = ANY_START if begins_elsewhere else 1e-2
    assert abs(apart[0] / apart[1] - 1) < limit, f"{apart[0]:.5f} m apart, {peer}'s {apart[1]:.5f} m"
    if begins_elsewhere:
        return
    same = (cKDTree(theirs).query(ours)[0] < 1e-5).mean()
    assert same > 0.9, f"{1 - same:.1%} of the points are not {peer}'s"


FARTHEST_POINTS = Operation(
    name="farthest_points",
    scenes={"200k": partial(scenes.bumpy_surface, 200_000), "1M": partial(scenes.bumpy_surface, 1_000_000)},
    quick={"20k": partial(scenes.bumpy_surface, 20_000)},
    contestants=(
        Contestant(OURS, prepare_pointloom, lambda cloud: cloud.points, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: np.asarray(cloud.points)),
        Contestant(
            "open3d-tensor", prepare_open3d_tensor, lambda cloud: cloud.point.positions.cpu().numpy(), ("cpu", "cuda")
        ),
        Contestant("fpsample", prepare_fpsample, lambda points: points.astype(np.float64)),
    ),
    check=check,
)
OPERATIONS = (FARTHEST_POINTS,)


@timed(FARTHEST_POINTS)
def test_farthest_points(turn) -> None:
    turn()
