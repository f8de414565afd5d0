"""The viewer's level-of-detail tree: building it, and selecting the nodes of a view.

No baseline builds such a tree. The table shows related work on the same points: the index of a search tree (pykdtree,
scipy), which orders the points without levels; and one grid with the voxels of the coarsest level (Open3D). The view is
compared with preparing all points.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import POINTLOOM, Contestant, Operation, load_open3d, timed

BUDGET = 300_000
CELL = 4.0 / 128  # [m] voxel size of the coarsest level of the surface, whose cube has a side of 4 m


def prepare_pointloom(points: np.ndarray, device: str) -> Any:
    import pointloom as loom
    from pointloom.visualization.viewer.detail_tree import DetailTree

    cloud = loom.PointCloud(points, device=device)
    return lambda: DetailTree.from_cloud(cloud)


def prepare_pykdtree(points: np.ndarray, device: str) -> Any:
    from pykdtree.kdtree import KDTree

    single = points.astype(np.float32)
    return lambda: KDTree(single)


def prepare_scipy(points: np.ndarray, device: str) -> Any:
    from scipy.spatial import cKDTree

    return lambda: cKDTree(points)


def prepare_open3d_legacy(points: np.ndarray, device: str) -> Any:
    o3d = load_open3d()
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
    return lambda: cloud.voxel_down_sample(CELL)


def tree_facts(tree: Any) -> dict[str, int]:
    return {"points": tree.count, "coarsest": int(tree.counts[tree.levels == 0].sum())}


def check_build(actual: dict[str, int], reference: dict[str, int], peer: str) -> None:
    """Check for the same number of points, and for the grid, which has another origin, about the same number of
    voxels (10 %).
    """
    for name, count in reference.items():
        slack = 0.1 * count if name == "coarsest" else 0
        assert abs(actual[name] - count) <= slack, f"{name}: {actual[name]}, {peer} {count}"


def prepare_view(points: np.ndarray, device: str) -> Any:
    from pointloom.visualization.render.view import fit_view

    tree = prepare_pointloom(points, device)()
    view = fit_view(points)
    return lambda: [tree.node(i) for i in tree.select(view, BUDGET)]


def prepare_all_points(points: np.ndarray, device: str) -> Any:
    tree = prepare_pointloom(points, device)()
    return lambda: [tree.node(i) for i in range(len(tree))]


def check_view(actual: list[Any], reference: list[Any], peer: str) -> None:
    """Check that the selection is within or near the budget, and that each node belongs to the tree."""
    count, total = (sum(len(node.indices) for node in nodes) for nodes in (actual, reference))
    assert min(total, 0.5 * BUDGET) <= count <= min(total, BUDGET)


SIZES = {"1M": partial(scenes.bumpy_surface, 1_000_000), "10M": partial(scenes.bumpy_surface, 10_000_000)}
QUICK = {"50k": partial(scenes.bumpy_surface, 50_000)}

BUILD = Operation(
    name="detail_tree_build",
    scenes=SIZES,
    quick=QUICK,
    contestants=(
        Contestant(POINTLOOM, prepare_pointloom, tree_facts, ("cpu", "cuda")),
        Contestant("pykdtree", prepare_pykdtree, lambda tree: {"points": tree.n}),
        Contestant("scipy", prepare_scipy, lambda tree: {"points": tree.n}),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: {"coarsest": len(cloud.points)}),
    ),
    check=check_build,
    long=("10M",),
    targets={"1M": 2},
    reasons={"1M": "Open3D builds one grid of the coarsest level, which is a part of the tree."},
)
VIEW = Operation(
    name="detail_tree_view",
    scenes={"300k of 1M": SIZES["1M"]},
    quick=QUICK,
    contestants=(
        Contestant(POINTLOOM, prepare_view, lambda nodes: nodes, ("cpu", "cuda")),
        Contestant("all points", prepare_all_points, lambda nodes: nodes),
    ),
    check=check_view,
)
OPERATIONS = (BUILD, VIEW)


@timed(BUILD)
def test_detail_tree_build(time_lap) -> None:
    time_lap()


@timed(VIEW)
def test_detail_tree_view(time_lap) -> None:
    time_lap()
