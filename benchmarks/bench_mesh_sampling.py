"""sample_points_uniformly of a mesh of 76k triangles, beside Open3D's."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from bench_poisson_disk import Scene, surface
from contest import OURS, Contestant, Operation, timed, waiting
from mesh_scenes import in_open3d, in_pointloom


def prepare_pointloom(scene: Scene, device: str) -> Any:
    mesh = in_pointloom(scene[0], device)
    return waiting(lambda: mesh.sample_points_uniformly(scene[1]), device, "warp")


def prepare_open3d(scene: Scene, device: str) -> Any:
    mesh = in_open3d(scene[0])
    return lambda: mesh.sample_points_uniformly(scene[1])


def spread(points: np.ndarray) -> np.ndarray:
    """Count, mean and spread of points: random ones agree in nothing else."""
    return np.array([len(points), *points.mean(axis=0), *points.std(axis=0)])


def check(ours: np.ndarray, theirs: np.ndarray, peer: str) -> None:
    assert ours[0] == theirs[0]
    np.testing.assert_allclose(ours[1:], theirs[1:], atol=8 * theirs[4:].max() / np.sqrt(theirs[0]), err_msg=peer)


MESH_SAMPLING = Operation(
    name="mesh_sampling",
    scenes={"100k": partial(surface, 100_000), "1M": partial(surface, 1_000_000)},
    quick={"5k": partial(surface, 5_000, 32)},
    contestants=(
        Contestant(OURS, prepare_pointloom, lambda cloud: spread(cloud.points), ("cpu", "cuda")),
        Contestant("open3d-legacy", prepare_open3d, lambda cloud: spread(np.asarray(cloud.points))),
    ),
    check=check,
)
OPERATIONS = (MESH_SAMPLING,)


@timed(MESH_SAMPLING)
def test_mesh_sampling(turn) -> None:
    turn()
