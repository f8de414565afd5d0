"""Group search on the CPU reads no uninitialized memory, and neighbors do not depend on the size of scratch memory."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import array, cpu_compiler, float32, int32, kernel, launch, tid, vec3
from pointloom.kernels.memory import download, empty, full, upload
from pointloom.kernels.search import group_scratch
from pointloom.kernels.search.group_scratch import GroupScratch
from pointloom.kernels.search.group_search import gather_candidates
from pointloom.kernels.search.point_tree import LEAF, PointTree
from pointloom.kernels.search.tree_search import search_nearest


@kernel
def gather_kernel(center: vec3, max_sqdist: float, tree: PointTree, scratch: GroupScratch, sizes: array(dtype=int32)):
    i = tid()
    sizes[i] = gather_candidates(center, center, 0, max_sqdist, tree, tree.order, scratch, i * scratch.gather)


@pytest.mark.parametrize("compiler", ["taichi", "warp"])
@pytest.mark.parametrize("count", [1, LEAF - 1, LEAF, 3 * LEAF + 5, 300])
def test_values_after_the_last_candidate_are_infinite(compiler, count, rng, monkeypatch):
    """Eight candidates are measured at a time: memory that held numbers near the query must not look like points."""
    warp_device = resolve_device("cpu")
    monkeypatch.setattr(group_scratch, "candidate_room", lambda device, k: 64 * LEAF)
    made = lambda shape, dtype, device: full(shape, {float32: 0.5}.get(dtype, 1), dtype, device)  # noqa: E731
    monkeypatch.setattr(group_scratch, "empty", made)
    points = rng.random((count, 3)).astype(np.float32)
    tree, scratch = PointTree(upload(points, vec3, warp_device)), GroupScratch(warp_device, 1, 8)
    sizes = empty(1, int32, warp_device)
    with cpu_compiler(compiler):
        launch(gather_kernel, 1, [[0.5, 0.5, 0.5], 4.0, tree, scratch, sizes])
    size, rows = int(download(sizes)[0]), [download(a) for a in (scratch.xs, scratch.ys, scratch.zs)]
    assert size == count
    np.testing.assert_array_equal(np.stack(rows, 1)[:size], points[download(scratch.ids)[:size]])
    for row in rows:
        assert np.isinf(row[size : -(-size // LEAF) * LEAF]).all()
        assert (row[-(-size // LEAF) * LEAF :] == 0.5).all()


@pytest.mark.parametrize("compiler", ["taichi", "warp"])
def test_too_many_candidates_do_not_overflow_the_scratch_memory(compiler, rng, monkeypatch):
    warp_device = resolve_device("cpu")
    monkeypatch.setattr(group_scratch, "candidate_room", lambda device, k: 2 * LEAF)
    tree = PointTree(upload(rng.random((50, 3)).astype(np.float32), vec3, warp_device))
    scratch, sizes = GroupScratch(warp_device, 1, 8), empty(1, int32, warp_device)
    scratch.xs, scratch.ys, scratch.zs = (full(4 * LEAF, 0.5, a.dtype, warp_device) for a in (scratch.xs,) * 3)
    with cpu_compiler(compiler):
        launch(gather_kernel, 1, [[0.5, 0.5, 0.5], 4.0, tree, scratch, sizes])
    assert int(download(sizes)[0]) == 2 * LEAF + 1
    for row in (scratch.xs, scratch.ys, scratch.zs):
        assert (download(row)[2 * LEAF :] == 0.5).all()


@pytest.mark.parametrize("k", [1, 7, 40])
def test_neighbors_do_not_depend_on_the_size_of_the_scratch_memory(device, k, rng, monkeypatch):
    """Crowds of equal points, outliers and a surface: groups that fit, groups that do not, growing radii."""
    points = rng.random((1500, 3)).astype(np.float32)
    points[:, 2] *= 0.05
    points[200:500] = points[200]
    points[600:700] = np.round(points[600:700] * 4) / 4
    points[-3:] *= 1000
    tree, results = PointTree(upload(points, vec3, device)), []
    for room in (group_scratch.candidate_room, lambda device, k: 2 * LEAF, lambda device, k: 0):
        monkeypatch.setattr(group_scratch, "candidate_room", room)
        results.append([download(a) for a in search_nearest(tree, tree.source, k)])
    sqdists = ((points[:, None] - points[None]).astype(np.float32) ** 2).sum(2, dtype=np.float32)
    for indices, distances, counts in results:
        assert (counts == k).all()
        np.testing.assert_array_equal(indices, results[0][0])
        np.testing.assert_array_equal(distances, results[0][1])
    exact = np.sort(sqdists, axis=1)[:, :k]
    np.testing.assert_allclose(results[0][1], exact, rtol=1e-5, atol=1e-12)
