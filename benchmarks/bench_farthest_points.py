"""farthest_point_down_sample to 1000 points, the search structure included, beside Open3D's point clouds and fpsample.

fpsample runs on one core whatever the number of threads. It begins at a point of its own choice, so that its points are
others: each has to be the farthest from those before it.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import OURS, Contestant, Operation, Trial, anew, load_open3d, open3d_device, timed, waiting

SAMPLES = 1000
TREE_HEIGHT = 7  # of fpsample, the best of 3, 5, 7, 9 and 11 at 200k and at 1M
STEPS = (1, 10, 100, 500, SAMPLES - 1)  # of a sequence whose next point is looked at


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
    return lambda: (given, given[fpsample.bucket_fps_kdline_sampling(given, SAMPLES, h=TREE_HEIGHT, start_idx=0)])


def check_sequence(cloud: np.ndarray, points: np.ndarray, peer: str) -> None:
    """Each point is the farthest of the cloud from those before it, to rounding."""
    from scipy.spatial import cKDTree

    for k in STEPS:
        before = cKDTree(points[:k])
        farthest, reached = before.query(cloud)[0].max(), before.query(points[k])[0]
        assert reached > 0.999 * farthest, f"{peer}'s point {k} is {reached:.5f} m away, another {farthest:.5f} m"


def check(ours: np.ndarray, theirs: np.ndarray | tuple[np.ndarray, np.ndarray], peer: str) -> None:
    """As many points, as far apart, and most of them the same: one near-tie that float32 decides moves a few others."""
    from scipy.spatial import cKDTree

    if isinstance(theirs, tuple):
        assert len(ours) == len(theirs[1])
        return check_sequence(*theirs, peer)
    assert len(ours) == len(theirs)
    same = (cKDTree(theirs).query(ours)[0] < 1e-5).mean()
    assert same > 0.9, f"{1 - same:.1%} of the points are not {peer}'s"
    apart = [cKDTree(points).query(points, k=2)[0][:, 1].min() for points in (ours, theirs)]
    assert abs(apart[0] / apart[1] - 1) < 1e-2, f"{apart[0]:.5f} m apart, {peer}'s {apart[1]:.5f} m"


MAX_POINTS = Operation(
    name="farthest_points",
    scenes={"200k": partial(scenes.bumpy_surface, 200_000), "1M": partial(scenes.bumpy_surface, 1_000_000)},
    quick={"20k": partial(scenes.bumpy_surface, 20_000)},
    contestants=(
        Contestant(OURS, prepare_pointloom, lambda cloud: cloud.points, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: np.asarray(cloud.points)),
        Contestant(
            "open3d-tensor", prepare_open3d_tensor, lambda cloud: cloud.point.positions.cpu().numpy(), ("cpu", "cuda")
        ),
        Contestant("fpsample", prepare_fpsample, lambda found: found),
    ),
    check=check,
)
OPERATIONS = (MAX_POINTS,)


@timed(MAX_POINTS)
def test_farthest_points(turn) -> None:
    turn()
