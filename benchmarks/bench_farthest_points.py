"""farthest_point_down_sample to 1000 points, search structure included, beside Open3D's point clouds and fpsample.

fpsample always runs on one core. It starts at a point of its own choice, so its points differ; each must be the
farthest
from the previous ones.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, Trial, anew, load_open3d, open3d_device, timed, waiting

SAMPLES = 1000
TREE_HEIGHT = 7  # of fpsample, the best of 3, 5, 7, 9 and 11 at 200k and at 1M
STEPS = (1, 10, 100, 500, SAMPLES - 1)  # positions in the sequence whose next point is checked


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
    """Check that each point is the farthest of the cloud from the previous ones, to rounding."""
    from scipy.spatial import cKDTree

    for k in STEPS:
        before = cKDTree(points[:k])
        farthest, reached = before.query(cloud)[0].max(), before.query(points[k])[0]
        assert reached > 0.999 * farthest, f"{peer}'s point {k} is {reached:.5f} m away, another {farthest:.5f} m"


def check(actual: np.ndarray, reference: np.ndarray | tuple[np.ndarray, np.ndarray], peer: str) -> None:
    """Check for the same count and spacing, and mostly the same points: one near-tie changes a few others."""
    from scipy.spatial import cKDTree

    if isinstance(reference, tuple):
        assert len(actual) == len(reference[1])
        return check_sequence(*reference, peer)
    assert len(actual) == len(reference)
    same = (cKDTree(reference).query(actual)[0] < 1e-5).mean()
    assert same > 0.9, f"{1 - same:.1%} of the points are not {peer}'s"
    spacings = [cKDTree(points).query(points, k=2)[0][:, 1].min() for points in (actual, reference)]
    assert abs(spacings[0] / spacings[1] - 1) < 1e-2, f"{spacings[0]:.5f} m apart, {peer}'s {spacings[1]:.5f} m"


MAX_POINTS = Operation(
    name="farthest_points",
    scenes={
        "2k": partial(scenes.bumpy_surface, 2000),
        "200k": partial(scenes.bumpy_surface, 200_000),
        "1M": partial(scenes.bumpy_surface, 1_000_000),
    },
    quick={"20k": partial(scenes.bumpy_surface, 20_000)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda cloud: cloud.points, ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: np.asarray(cloud.points)),
        Contestant(  # a minute on the CPU, fifty times the time of the legacy cloud
            "open3d-tensor", prepare_open3d_tensor, lambda cloud: cloud.point.positions.cpu().numpy(), ("cuda",)
        ),
        Contestant("fpsample", prepare_fpsample, lambda points: points),
    ),
    check=check,
    targets={"200k": 3, "1M": 3},
    reasons=dict.fromkeys(["200k", "1M"], "Most of the time is building the tree; the choices are a fifth."),
)
OPERATIONS = (MAX_POINTS,)


@timed(MAX_POINTS)
def test_farthest_points(time_lap) -> None:
    time_lap()
