"""The viewer's tree of detail: built, and asked for what a view shows.

No peer here builds such a tree. What stands beside are anchors, other work over the same points: the index of a search
tree (pykdtree, scipy), which orders the points once and gives no levels; and one grid with the voxels of the coarsest
level (Open3D), which finds the points of one level of many. Beside the view stands what it saves, all points made
ready.
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import scenes
from contest import OURS, Contestant, Operation, load_open3d, timed

BUDGET = 300_000
CELL = 4.0 / 128  # [m] voxels of the coarsest level of the surface, whose cube has a side of 4 m


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


def check_build(ours: dict[str, int], theirs: dict[str, int], peer: str) -> None:
    """As many points; and of the one grid, which begins elsewhere, as many voxels but for a tenth."""
    for name, count in theirs.items():
        slack = 0.1 * count if name == "coarsest" else 0
        assert abs(ours[name] - count) <= slack, f"{name}: {ours[name]}, {peer} {count}"


def prepare_view(points: np.ndarray, device: str) -> Any:
    from pointloom.visualization.render.view import fit_view

    tree = prepare_pointloom(points, device)()
    view = fit_view(points)
    return lambda: [tree.node(i) for i in tree.select(view, BUDGET)]


def prepare_all_points(points: np.ndarray, device: str) -> Any:
    tree = prepare_pointloom(points, device)()
    return lambda: [tree.node(i) for i in range(len(tree))]


def check_view(ours: list[Any], theirs: list[Any], peer: str) -> None:
    """Within the budget, or near it, and each a node of the whole."""
    count, total = (sum(len(node.indices) for node in nodes) for nodes in (ours, theirs))
    assert min(total, 0.5 * BUDGET) <= count <= min(total, BUDGET)


SIZES = {"1M": partial(scenes.bumpy_surface, 1_000_000), "10M": partial(scenes.bumpy_surface, 10_000_000)}
QUICK = {"50k": partial(scenes.bumpy_surface, 50_000)}

BUILD = Operation(
    name="detail_tree_build",
    scenes=SIZES,
    quick=QUICK,
    contestants=(
        Contestant(OURS, prepare_pointloom, tree_facts, ("cpu", "cuda")),
        Contestant("pykdtree", prepare_pykdtree, lambda tree: {"points": tree.n}),
        Contestant("scipy", prepare_scipy, lambda tree: {"points": tree.n}),
        Contestant("open3d-legacy", prepare_open3d_legacy, lambda cloud: {"coarsest": len(cloud.points)}),
    ),
    check=check_build,
)
VIEW = Operation(
    name="detail_tree_view",
    scenes={"300k of 1M": SIZES["1M"]},
    quick=QUICK,
    contestants=(
        Contestant(OURS, prepare_view, lambda nodes: nodes, ("cpu", "cuda")),
        Contestant("all points", prepare_all_points, lambda nodes: nodes),
    ),
    check=check_view,
)
OPERATIONS = (BUILD, VIEW)


@timed(BUILD)
def test_detail_tree_build(turn) -> None:
    turn()


@timed(VIEW)
def test_detail_tree_view(turn) -> None:
    turn()
