"""Sample elimination in rounds: the samples that a heap would leave, one removal after the other."""

import heapq

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.meshes import poisson_disk
from pointloom.kernels.search import neighbor_limits
from pointloom.kernels.search.point_tree import PointTree


def by_rounds(points: np.ndarray, count: int, widest: float, device: str) -> np.ndarray:
    tree = PointTree(upload(points, vec3, device))
    return download(poisson_disk.eliminate_samples(tree, count, widest)).copy()


def by_heap(points: np.ndarray, count: int, widest: float) -> np.ndarray:
    """Yuksel's algorithm as he gives it: the heaviest sample goes, of equal ones the one of the highest index."""
    points = points.astype(np.float32)
    rows = np.flatnonzero(np.isfinite(points).all(axis=1))
    narrowest = widest * 0.65 * (1 - (count / len(rows)) ** 1.5)
    gaps = points[rows][:, None] - points[rows][None]
    squares = gaps[..., 0] ** 2 + gaps[..., 1] ** 2 + gaps[..., 2] ** 2
    distances = np.sqrt(squares.astype(np.float64))
    shares = np.clip((1 - distances / widest) / (1 - narrowest / widest), 0, 1)
    near = squares < widest**2
    weights = np.where(near, (((shares**2) ** 2) ** 2 * 2**30).astype(np.int64), 0)
    np.fill_diagonal(weights, 0)
    total = weights.sum(axis=1)
    left = np.ones(len(rows), bool)
    heap = [(-total[i], -i) for i in range(len(rows))]
    heapq.heapify(heap)
    while left.sum() > count:
        weight, i = heapq.heappop(heap)
        i = -i
        if not left[i] or -weight != total[i]:
            continue
        left[i] = False
        total -= weights[i]
        for j in np.flatnonzero(left & (weights[i] > 0)):
            heapq.heappush(heap, (-total[j], -j))
    return rows[left]


def scene(name: str, rng: np.random.Generator) -> tuple[np.ndarray, float]:
    if name == "square":
        return np.column_stack([rng.random((500, 2)), np.zeros(500)]), 1.0
    if name == "ball":
        points = rng.normal(size=(500, 3))
        return points / np.linalg.norm(points, axis=1, keepdims=True), 4 * np.pi
    if name == "grid":  # every distance many times over, so that many samples weigh the same
        return np.stack(np.meshgrid(np.arange(21), np.arange(21), [0]), -1).reshape(-1, 3) / 21.0, 1.0
    if name == "copies":
        return np.repeat(rng.random((60, 3)), 10, axis=0), 1.0
    if name == "strays":  # no two within the radius
        return rng.random((400, 3)) * 1e4, 1.0
    if name == "nowhere":
        points = rng.random((400, 3)) * [1, 1, 0]
        points[::7] = np.nan
        return points, 1.0
    points = np.concatenate([rng.random((400, 3)) * [0.02, 0.02, 0], rng.random((60, 3)) * 50])
    return points, 1.0


@pytest.mark.parametrize(("count", "in_rounds"), [(57, False), (300, True)])
@pytest.mark.parametrize("name", ["square", "ball", "grid", "copies", "strays", "nowhere", "crowd and strays"])
def test_the_samples_equal_those_of_a_heap(device, rng, monkeypatch, name, count, in_rounds):
    monkeypatch.setattr(poisson_disk, "MAX_SEQUENTIAL", 0 if in_rounds else 2**16)
    points, area = scene(name, rng)
    widest = 2 * np.sqrt(area / count / (2 * np.sqrt(3)))
    np.testing.assert_array_equal(by_rounds(points, count, widest, device), by_heap(points, count, widest))


def test_more_samples_within_the_radius_than_a_group_gathers_are_weighted_too(device, rng, monkeypatch):
    monkeypatch.setattr(neighbor_limits, "LIST_SIZE", 1)  # 512 of them
    points = rng.random((560, 3)) * [1, 1, 0]
    widest = 2 * np.sqrt(1 / 2 / (2 * np.sqrt(3)))
    np.testing.assert_array_equal(by_rounds(points, 2, widest, device), by_heap(points, 2, widest))


def test_more_pairs_than_fit_are_counted_and_refused(device, rng, monkeypatch):
    monkeypatch.setattr(poisson_disk, "MAX_PAIRS", 1000)
    monkeypatch.setattr(poisson_disk, "MAX_ROOM", 0)
    with pytest.raises(poisson_disk.CrowdedError) as caught:
        by_rounds(rng.random((100, 3)), 10, 3.0, device)
    assert caught.value.pair_count == 9900
