"""sample_points_uniformly of a mesh of 76k triangles, beside Open3D."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from bench_poisson_disk import Scene, surface
from contest import POINTLOOM, Contestant, Operation, timed, waiting
from mesh_scenes import in_open3d, in_pointloom
from reasons import CALL


def prepare_pointloom(scene: Scene, device: str) -> Any:
    mesh = in_pointloom(scene[0], device)
    return waiting(lambda: mesh.sample_points_uniformly(scene[1]), device, "warp")


def prepare_open3d(scene: Scene, device: str) -> Any:
    mesh = in_open3d(scene[0])
    return lambda: mesh.sample_points_uniformly(scene[1])


def spread(points: np.ndarray) -> np.ndarray:
    """Count, mean and spread of points, which are comparable for random samples."""
    return np.array([len(points), *points.mean(axis=0), *points.std(axis=0)])


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    assert actual[0] == reference[0]
    np.testing.assert_allclose(
        actual[1:], reference[1:], atol=8 * reference[4:].max() / np.sqrt(reference[0]), err_msg=peer
    )


MESH_SAMPLING = Operation(
    name="mesh_sampling",
    scenes={"1k": partial(surface, 1000, 16), "100k": partial(surface, 100_000), "1M": partial(surface, 1_000_000)},
    quick={"5k": partial(surface, 5_000, 32)},
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, lambda cloud: spread(cloud.points), ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, lambda cloud: spread(np.asarray(cloud.points))),
    ),
    check=check,
    reasons={"1k": CALL},
)
OPERATIONS = (MESH_SAMPLING,)


@timed(MESH_SAMPLING)
def test_mesh_sampling(time_lap) -> None:
    time_lap()
