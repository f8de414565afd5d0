"""The 16 nearest neighbors of every point in batches of clouds, as float32 tensors of torch.

Baselines measure all pairs (torch.cdist), build a tree of each cloud (scipy, torch_cluster), or measure all pairs in a
kernel (PyTorch3D). `make bench` installs torch. torch_cluster and PyTorch3D, which compile for minutes, are measured if
they are in the environment build/torch, and left out otherwise.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from contest import POINTLOOM, Contestant, Operation, thread_count, timed

K = 16
ROWS = 2000  # queries of one call of cdist on a large cloud: 1.6 GB of distances to 200,000 points


def noisy_spheres(count: int, size: int) -> np.ndarray:
    """Points near unit spheres, float32 (count, size, 3)."""
    points = np.random.default_rng(7).normal(size=(count, size, 3))
    points /= np.linalg.norm(points, axis=-1, keepdims=True)
    return (points + np.random.default_rng(8).normal(0, 0.02, points.shape)).astype(np.float32)


def tensors(points: np.ndarray, device: str) -> Any:
    import torch

    torch.set_num_threads(thread_count())
    return torch.as_tensor(points, device=device)


def search_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom

    clouds = tensors(points, device)
    return lambda: loom.torch.knn(clouds, clouds, K).sqdists.sqrt().cpu().numpy()


def search_cdist(points: np.ndarray, device: str) -> Any:
    import torch

    clouds = tensors(points, device)

    def search() -> Any:
        parts = clouds.split(ROWS, dim=1)
        return torch.cat([torch.cdist(part, clouds).topk(K, largest=False).values for part in parts], 1).cpu().numpy()

    return search


def search_scipy(points: np.ndarray, device: str) -> Any:
    from scipy.spatial import cKDTree

    return lambda: np.stack([cKDTree(cloud).query(cloud, K, workers=thread_count())[0] for cloud in points])


def search_torch_cluster(points: np.ndarray, device: str) -> Any:
    import torch
    import torch_cluster

    clouds = tensors(points, device)
    rows = clouds.reshape(-1, 3)
    batch = torch.arange(len(points), device=device).repeat_interleave(points.shape[1])

    def search() -> Any:
        query, near = torch_cluster.knn(rows, rows, K, batch, batch, num_workers=thread_count())
        return (rows[query] - rows[near]).norm(dim=1).reshape(*points.shape[:2], K).cpu().numpy()

    return search


def search_pytorch3d(points: np.ndarray, device: str) -> Any:
    from pytorch3d.ops import knn_points

    clouds = tensors(points, device)
    return lambda: knn_points(clouds, clouds, K=K).dists.sqrt().cpu().numpy()


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same distances, up to rounding."""
    rounding = 2e-3 if peer.startswith("torch.cdist") else 1e-5  # cdist expands (a - b)^2
    worst = np.abs(np.sort(actual, -1) - np.sort(reference, -1)).max()
    assert worst < rounding, f"distances differ from {peer}'s by up to {worst:.2g}"


OPERATION = Operation(
    name="torch_knn16",
    scenes={
        "32 x 2048": partial(noisy_spheres, 32, 2048),
        "1000 x 256": partial(noisy_spheres, 1000, 256),
        "1 x 200k": partial(noisy_spheres, 1, 200_000),
    },
    quick={"8 x 512": partial(noisy_spheres, 8, 512)},
    contestants=(
        Contestant(POINTLOOM, search_pointloom, np.asarray, ("cpu", "cuda")),
        Contestant("torch.cdist", search_cdist, np.asarray, ("cpu", "cuda")),
        Contestant("scipy", search_scipy, np.asarray),
        Contestant("torch-cluster", search_torch_cluster, np.asarray, ("cpu", "cuda")),
        Contestant("pytorch3d", search_pytorch3d, np.asarray, ("cpu", "cuda")),
    ),
    check=check,
    memory_size="32 x 2048",
    slow={"1 x 200k": ("torch.cdist",)},
)
OPERATIONS = (OPERATION,)


@timed(OPERATION)
def test_torch_knn(time_lap) -> None:
    time_lap()
