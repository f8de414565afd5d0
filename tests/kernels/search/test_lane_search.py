"""What the lanes of a CUDA warp list together: leaves near any of four boxes, each around eight of their points."""

import numpy as np
import pytest

from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import WARP, array, float32, int32, kernel, lane, launch, tid, vec3
from pointloom.kernels.memory import download, empty, upload
from pointloom.kernels.search import group_scratch
from pointloom.kernels.search.group_scratch import GroupScratch
from pointloom.kernels.search.lane_search import list_leaves
from pointloom.kernels.search.point_tree import FAN, LEAF, SIDES, PointTree, measure_box


@kernel
def list_leaves_kernel(
    points: array(dtype=vec3), radii: array(dtype=float32), tree: PointTree, scratch: GroupScratch,
    sizes: array(dtype=int32),
):  # fmt: skip
    """By the CPU: eight points after another, whose boxes are measured against every leaf."""
    i = tid()
    if i == 0:
        size = 0
        for leaf in range((tree.count + LEAF - 1) // LEAF):
            near = 0
            for eight in range(WARP // LEAF):
                low = points[eight * LEAF] + vec3(0.0, 0.0, 0.0)
                high = points[eight * LEAF] + vec3(0.0, 0.0, 0.0)
                widest = 0.0
                for j in range(eight * LEAF, (eight + 1) * LEAF):
                    p = points[j]
                    low = vec3(min(low[0], p[0]), min(low[1], p[1]), min(low[2], p[2]))
                    high = vec3(max(high[0], p[0]), max(high[1], p[1]), max(high[2], p[2]))
                    widest = max(widest, radii[j])
                if measure_box(tree.boxes, leaf // FAN, leaf % FAN, low, high) <= widest:
                    near = 1
            if near == 1:
                scratch.ids[size] = leaf * LEAF
                size += 1
        sizes[0] = size


@list_leaves_kernel.on_cuda
def list_leaves_of_lanes_kernel(
    points: array(dtype=vec3), radii: array(dtype=float32), tree: PointTree, scratch: GroupScratch,
    sizes: array(dtype=int32),
):  # fmt: skip
    """By the lanes of one warp."""
    i = tid()
    size = list_leaves(points[lane()], radii[lane()], 0, tree, scratch, 0)
    if i == 0:
        sizes[0] = size


@pytest.mark.parametrize("apart", [0.0, 0.4], ids=["together", "apart"])
def test_leaves_near_each_eight_points_are_listed_and_no_others(device, apart, rng, monkeypatch):
    warp_device = resolve_device(device)
    monkeypatch.setattr(group_scratch, "candidate_room", lambda device, k: 1024)
    tree = PointTree(upload(rng.random((4000, 3)).astype(np.float32), vec3, warp_device))
    centers = np.repeat(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1]], np.float32), LEAF, axis=0)
    points = (0.3 + apart * centers + 0.05 * rng.random((WARP, 3))).astype(np.float32)
    radii = np.repeat(np.float32([0.001, 0.002, 0.004, 0.01]), LEAF)
    radii[::3] = 0.0
    scratch, sizes = GroupScratch(warp_device, WARP, 8), empty(1, int32, warp_device)
    given = [upload(points, vec3, warp_device), upload(radii, float32, warp_device), tree, scratch, sizes]
    launch(list_leaves_kernel, WARP, given)
    size = int(download(sizes)[0])
    boxes = download(tree.boxes)[: -(-tree.count // (LEAF * FAN)) * SIDES].reshape(-1, 2, 3, FAN)
    low, high = (boxes[:, side].transpose(0, 2, 1).reshape(-1, 3) for side in (0, 1))
    near = np.zeros(len(low), bool)
    for eight in range(WARP // LEAF):
        group = slice(eight * LEAF, (eight + 1) * LEAF)
        gaps = np.maximum(np.maximum(low - points[group].max(0), points[group].min(0) - high), 0)
        near |= (gaps.astype(np.float64) ** 2).sum(1) <= radii[group].max()
    leaves = np.flatnonzero(near)
    assert 4 < len(leaves) < 60 + 300 * (apart == 0)
    np.testing.assert_array_equal(np.sort(download(scratch.ids[:size])), leaves * LEAF)
