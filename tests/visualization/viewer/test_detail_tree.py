"""The multi-resolution tree: each point in one node, nodes around their points, and selection by a view."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.pcd.detail_nodes import CHILD_FRACTION, MIN_POINTS
from pointloom.visualization.render.view import View, fit_view
from pointloom.visualization.viewer import detail_tree
from pointloom.visualization.viewer.detail_files import sample_file
from pointloom.visualization.viewer.detail_tree import DetailTree

UTM = np.array([512_345.0, 5_402_111.0, 240.0])


def hills(rng, count, origin=(0.0, 0.0, 0.0)):
    points = rng.random((count, 3)) * [80, 60, 0]
    points[:, 2] = 3 * np.sin(points[:, 0] / 7) * np.cos(points[:, 1] / 9)
    return points + origin


def check_nodes(tree, points):
    """Each finite point in one node, and within its cube."""
    indices = np.concatenate([tree.indices_of(i) for i in range(len(tree))] or [np.empty(0, np.int64)])
    assert np.array_equal(np.sort(indices), np.flatnonzero(np.isfinite(points).all(axis=1)))
    assert tree.count == len(indices) == tree.counts.sum()
    for i in range(len(tree)):
        node = tree.node(i)
        world = node.positions.astype(np.float64) + node.middle
        step = np.spacing(np.float32(np.abs(points[node.indices] - tree.origin).max(initial=0)))
        # rounded about the origin, and about the middle
        assert np.abs(world - points[node.indices]).max() <= 2 * step + node.half * 2.0**-23
        assert np.abs(node.positions).max() <= node.half * (1 + 1e-6) + 2 * step


@pytest.mark.parametrize("origin", [np.zeros(3), UTM], ids=["at zero", "at UTM coordinates"])
def test_each_point_is_in_one_node_and_within_its_cube(device, origin, rng):
    points = hills(rng, 120_000, origin)
    points[::1000] = np.nan
    tree = DetailTree.from_cloud(loom.PointCloud(points, device=device))
    assert 20 < len(tree) < 200
    check_nodes(tree, points)


def test_nodes_are_the_same_on_every_device_and_in_every_run(device, rng):
    points = hills(rng, 30_000, UTM)
    tree = DetailTree.from_cloud(loom.PointCloud(points, device=device))
    plain = DetailTree.from_cloud(loom.PointCloud(points, device="cpu"))
    for name in ("_order", "counts", "middles"):
        assert np.array_equal(getattr(tree, name), getattr(plain, name)), name


@pytest.mark.slow
def test_points_down_to_a_level_are_evenly_spaced(rng):
    """Of two points in one voxel, one may be in a node without children: few, by the given limits."""
    points = hills(rng, 150_000).astype(np.float32).astype(np.float64)
    tree = DetailTree.from_cloud(loom.PointCloud(points))
    for level in range(int(tree.levels.max()) + 1):
        nodes = np.flatnonzero(tree.levels <= level)
        drawn = np.concatenate([tree.points_of(i) for i in nodes])
        spacing = tree.spacings[nodes].min()
        voxels = np.unique(np.floor((drawn - tree._corner - tree.origin) / spacing), axis=0)
        every = np.unique(np.floor((points - tree._corner - tree.origin) / spacing), axis=0)
        assert len(drawn) - len(voxels) <= len(nodes) * MIN_POINTS + len(drawn) / CHILD_FRACTION
        assert len(voxels) >= (0.8 if tree.levels.max() > level else 1.0) * len(every)


@pytest.mark.slow
def test_a_level_of_a_dense_cloud_leaves_no_voxel_empty(rng):
    points = rng.random((200_000, 3)).astype(np.float32)
    tree = DetailTree.from_cloud(loom.PointCloud(points))
    drawn = np.concatenate([tree.points_of(i) for i in np.flatnonzero(tree.levels == 0)])
    spacing = tree.spacings[0]
    voxels = np.unique(np.floor((drawn - tree._corner) / spacing), axis=0)
    every = np.unique(np.floor((points.astype(np.float64) - tree._corner) / spacing), axis=0)
    assert np.array_equal(voxels, every)


def test_large_nodes_are_cut_and_stay_within_their_cubes(rng, monkeypatch):
    monkeypatch.setattr(detail_tree, "MAX_POINTS", 500)
    points = rng.random((30_000, 3))
    points[:2000] = 0.3  # coincident points, which cannot be split
    tree = DetailTree.from_cloud(loom.PointCloud(points))
    assert tree.counts.max() <= 500
    check_nodes(tree, points.astype(np.float32).astype(np.float64))


@pytest.mark.parametrize(
    "points",
    [np.zeros((0, 3)), np.full((3, 3), np.nan), [[1.0, 2, 3]], np.full((20_000, 3), 7.0), [[0, 0, 0], [1e-30, 0, 0]],
     [[0, 0, 0], [1e30, 1, 1]], [[1e-42, 0, 0], [2e-42, 0, 0]]],
    ids=["none", "none finite", "one", "one place", "tiny", "huge", "subnormal"],
)  # fmt: skip
def test_odd_clouds_have_trees(points):
    points = np.asarray(points, np.float64)
    tree = DetailTree.from_cloud(loom.PointCloud(points, origin=np.zeros(3)))
    check_nodes(tree, points)
    if len(tree):
        assert tree.select(fit_view(points), 10**6)
    assert (tree.counts <= detail_tree.MAX_POINTS).all()


def look_at(points, distance=None):
    view = fit_view(points, width=1000, height=750)
    if distance is None:
        return view
    T = view.T_world_camera.copy()
    T[:3, 3] = points.mean(axis=0) - distance * T[:3, 2]
    return View(view.intrinsic, T)


@pytest.fixture(scope="module")
def hilly():
    """Points at UTM coordinates and their tree."""
    points = hills(np.random.default_rng(0), 100_000, UTM)
    return points, DetailTree.from_cloud(loom.PointCloud(points))


def test_a_view_takes_coarse_nodes_first_within_the_budget(hilly):
    points, tree = hilly
    visible = set(np.flatnonzero(tree._in_view(look_at(points))).tolist())
    for budget in (1, 20_000, 10**9):
        nodes = tree.select(look_at(points), budget)
        assert sum(tree.counts[nodes]) <= max(budget, tree.counts[nodes[0]])
        assert len(nodes) == len(set(nodes))
        at = {node: position for position, node in enumerate(nodes)}
        for node in nodes:
            inside = np.abs(tree.middles[node] - tree._level_middles).max(axis=1) < tree._level_halves
            above = np.flatnonzero(inside & (tree.levels < tree.levels[node])).tolist()
            assert all(at[k] < at[node] for k in above if k in visible), "what a node refines comes before it"
    assert tree.select(look_at(points), 0) == []
    far, near = (tree.select(look_at(points, distance), 40_000) for distance in (400.0, 8.0))
    assert tree.levels[near].max() > tree.levels[far].max()
    farthest = tree.select(look_at(points, 50_000.0), 10**9)  # the rest would be finer than pixels
    assert farthest and tree.levels[farthest].max() == 0


def test_a_view_takes_all_points_that_it_shows(hilly):
    points, tree = hilly
    view = look_at(points, distance=35.0)
    local = (points - view.T_world_camera[:3, 3]) @ view.T_world_camera[:3, :3]
    camera = view.intrinsic
    with np.errstate(divide="ignore"):
        u = camera.fx * local[:, 0] / local[:, 2] + camera.cx
        v = camera.fy * local[:, 1] / local[:, 2] + camera.cy
    shown = (local[:, 2] > 0) & (u > -0.5) & (u < camera.width - 0.5) & (v > -0.5) & (v < camera.height - 0.5)
    selected = np.concatenate([tree.indices_of(i) for i in tree.select(view, 10**9, finest=0.0)])
    assert 5_000 < shown.sum() < 60_000
    assert set(np.flatnonzero(shown)) <= set(selected.tolist())
    assert len(selected) < len(points), "what is out of view is left out"


@pytest.mark.parametrize("suffix", [".ply", ".pcd", ".xyz", ".npz", ".laz"])
def test_the_tree_of_a_file_is_that_of_its_cloud(tmp_path, suffix, rng, monkeypatch):
    if suffix == ".laz":
        pytest.importorskip("laspy")
    monkeypatch.setattr("pointloom.visualization.viewer.detail_tree._POINTS_PER_PART", 7_001)
    path = tmp_path / f"cloud{suffix}"
    cloud = loom.PointCloud(np.round(hills(rng, 25_000, UTM), 3))
    if suffix != ".xyz":
        cloud.colors = rng.integers(0, 256, (25_000, 3)) / 255
        cloud["intensity"] = np.arange(25_000, dtype=np.uint16) % 999
    loom.write_point_cloud(path, cloud)
    reported = []
    attributes = ["intensity"] if suffix != ".xyz" else []
    tree = DetailTree.from_file(path, attributes=attributes, progress=lambda *step: reported.append(step))
    read = loom.read_point_cloud(path)
    check_nodes(tree, read.points)
    assert np.abs(tree.low - read.points.min(axis=0)).max() < 1e-2
    assert reported[0] == ("reading", 0, 100) and reported[-1] == ("reading", 100, 100) and reported == sorted(reported)
    for i in (0, len(tree) - 1):
        node = tree.node(i)
        if suffix == ".xyz":
            assert node.colors is None
            continue
        assert np.array_equal(node.colors, np.rint(read.colors[node.indices] * 255))
        assert np.array_equal(tree.attributes["intensity"], read["intensity"])


@pytest.mark.parametrize("suffix", [".ply", ".pcd", ".las"])
def test_a_sample_is_spread_over_the_file(tmp_path, suffix, rng):
    if suffix == ".las":
        pytest.importorskip("laspy")
    points = np.round(hills(rng, 10_000, UTM), 3)
    loom.write_point_cloud(tmp_path / f"c{suffix}", loom.PointCloud(points, colors=rng.random((10_000, 3))))
    sample = sample_file(tmp_path / f"c{suffix}", 999)
    assert sample is not None
    cloud = loom.read_point_cloud(tmp_path / f"c{suffix}")
    assert len(sample) == len(range(0, 10_000, 11))
    assert np.abs(sample.points - cloud.points[::11]).max() < 1e-2
    assert np.array_equal(sample.colors, cloud.colors[::11])


def test_a_sample_of_a_compressed_file_is_of_each_chunk(tmp_path, rng):
    """LASzip's chunks have 50,000 points."""
    pytest.importorskip("laspy")
    path = tmp_path / "c.laz"
    points = np.round(hills(rng, 120_000, UTM), 3)
    points[:, 2] = np.arange(120_000) / 100
    loom.write_point_cloud(path, loom.PointCloud(points), scale=0.001)
    for count, expected in ((3000, [1000] * 3), (2, [1, 1]), (10**6, [50_000, 50_000, 20_000])):
        sample = sample_file(path, count)
        assert sample is not None
        numbers = np.rint(sample.points[:, 2] * 100).astype(int)
        assert np.bincount(numbers // 50_000)[:: 1 if count > 2 else 2].tolist() == expected
        assert np.abs(sample.points - points[numbers]).max() < 1e-2


def test_files_that_are_read_completely_give_no_sample(tmp_path):
    loom.write_point_cloud(tmp_path / "a.xyz", loom.PointCloud([[0, 0, 0]]))
    loom.write_point_cloud(tmp_path / "a.ply", loom.PointCloud([[0, 0, 0]]), write_ascii=True)
    assert sample_file(tmp_path / "a.xyz", 10) is None
    assert sample_file(tmp_path / "a.ply", 10) is None
    assert DetailTree.from_file(tmp_path / "a.ply").count == 1


@pytest.mark.parametrize(("suffix", "change"), [(".ply", -1), (".pcd", -1), (".pcd", 1)])
def test_a_file_that_does_not_fit_its_header_is_refused(tmp_path, suffix, change, rng):
    path = tmp_path / f"c{suffix}"
    loom.write_point_cloud(path, loom.PointCloud(rng.random((100, 3))))
    content = path.read_bytes()
    path.write_bytes(content[:change] if change < 0 else content + b"x")
    for read in (DetailTree.from_file, lambda p: sample_file(p, 10)):
        with pytest.raises(FileError, match=r"truncated|follow"):
            read(path)


def test_an_attribute_that_a_file_lacks_is_named(tmp_path):
    for name in ("a.ply", "a.xyz"):
        loom.write_point_cloud(tmp_path / name, loom.PointCloud([[0, 0, 0]]))
        with pytest.raises(FileError, match="no attribute 'ring'"):
            DetailTree.from_file(tmp_path / name, attributes=["ring"])
