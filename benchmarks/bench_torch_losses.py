"""Chamfer distances of pairs of clouds as float32 tensors of torch: values, and gradients of both clouds.

Baselines measure all pairs (torch.cdist), build a tree of each cloud (scipy, without gradients), or search neighbors
(PyTorch3D). Those that are not installed are left out.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from bench_torch_neighbors import noisy_spheres, tensors
from contest import POINTLOOM, Contestant, Operation, thread_count, timed


def pairs(count: int, size: int) -> np.ndarray:
    """Pairs of noisy spheres, float32 (2, count, size, 3)."""
    clouds = noisy_spheres(count, size)
    return np.stack([clouds, (clouds[:, ::-1] * np.float32([1.0, 1.1, 0.9]))])


def by_pointloom(source: Any, target: Any) -> Any:
    import pointloom as loom

    return loom.torch.chamfer_distance(source, target)


def by_cdist(source: Any, target: Any) -> Any:
    import torch

    squares = torch.cdist(source, target, compute_mode="donot_use_mm_for_euclid_dist").square()
    return squares.amin(2).mean(1) + squares.amin(1).mean(1)


def prepare(measure: Callable[[Any, Any], Any], clouds: np.ndarray, device: str, *, gradients: bool) -> Any:
    """A call that returns the distances (B), or the gradients with respect to both batches (2, B, N, 3)."""
    import torch

    source, target = tensors(clouds, device).requires_grad_(gradients)

    def call() -> Any:
        distances = measure(source, target)
        if not gradients:
            return distances.cpu().numpy()
        return torch.stack(torch.autograd.grad(distances.sum(), (source, target))).cpu().numpy()

    return call


def prepare_pytorch3d(clouds: np.ndarray, device: str, *, gradients: bool) -> Any:
    from pytorch3d.loss import chamfer_distance

    return prepare(lambda *pair: chamfer_distance(*pair, batch_reduction=None)[0], clouds, device, gradients=gradients)


def prepare_scipy(clouds: np.ndarray, device: str) -> Any:
    from scipy.spatial import cKDTree

    def one_way(source: np.ndarray, target: np.ndarray) -> Any:
        return (cKDTree(target).query(source, workers=thread_count())[0] ** 2).mean()

    return lambda: np.array([one_way(a, b) + one_way(b, a) for a, b in zip(*clouds, strict=True)])


def check(actual: np.ndarray, reference: np.ndarray, peer: str) -> None:
    """Check for the same distances or gradients, up to rounding."""
    np.testing.assert_allclose(actual, reference, rtol=1e-4, atol=1e-7, err_msg=f"not those of {peer}")


def operation(name: str, *, gradients: bool) -> Operation:
    measured = {
        POINTLOOM: partial(prepare, by_pointloom),
        "torch.cdist": partial(prepare, by_cdist),
        "pytorch3d": prepare_pytorch3d,
    }
    contestants = [
        Contestant(peer, partial(prepared, gradients=gradients), np.asarray, ("cpu", "cuda"))
        for peer, prepared in measured.items()
    ]
    if not gradients:
        contestants.append(Contestant("scipy", prepare_scipy, np.asarray))
    return Operation(
        name=name,
        scenes={"32 x 2048": partial(pairs, 32, 2048), "1000 x 256": partial(pairs, 1000, 256)},
        quick={"8 x 512": partial(pairs, 8, 512)},
        contestants=tuple(contestants),
        check=check,
        memory_size="32 x 2048",
    )


CHAMFER = operation("torch_chamfer", gradients=False)
CHAMFER_GRADIENTS = operation("torch_chamfer_gradients", gradients=True)
OPERATIONS = (CHAMFER, CHAMFER_GRADIENTS)


@timed(CHAMFER)
def test_torch_chamfer(time_lap) -> None:
    time_lap()


@timed(CHAMFER_GRADIENTS)
def test_torch_chamfer_gradients(time_lap) -> None:
    time_lap()
