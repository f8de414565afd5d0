"""Octrees of pointloom.open3d: the nodes of every point, by float64 arithmetic."""

import copy
import json
import pickle

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d

G = o3d.geometry
DEPTH = 4


@pytest.fixture
def cloud(rng):
    made = G.PointCloud(o3d.utility.Vector3dVector(rng.random((300, 3)) * [1, 2, 0.5] + 10))
    made.colors = o3d.utility.Vector3dVector(rng.random((300, 3)))
    return made


@pytest.fixture
def octree(cloud):
    made = G.Octree(DEPTH)
    made.convert_from_point_cloud(cloud, 0.05)
    return made


def nodes_of(octree):
    visited = []
    octree.traverse(lambda node, info: visited.append((node, info)))
    return visited


def leaves_of(octree):
    return [(node, info) for node, info in nodes_of(octree) if isinstance(node, G.OctreeLeafNode)]


def test_leaves_are_the_cells_of_a_grid_and_hold_their_points(cloud, octree):
    points, colors = np.asarray(cloud.points), np.asarray(cloud.colors)
    low, high = points.min(axis=0), points.max(axis=0)
    size = (high - low).max()
    np.testing.assert_allclose(octree.size, size * 1.05)
    np.testing.assert_allclose(octree.origin, np.minimum(low, (low + high) / 2 - size / 2))
    cells = np.floor((points - octree.origin) / octree.size * 2**DEPTH).astype(int)
    leaves = leaves_of(octree)
    assert len(leaves) == len(np.unique(cells, axis=0))
    assert sorted(i for leaf, _ in leaves for i in leaf.indices) == list(range(300))
    for leaf, info in leaves:
        cell = np.rint((info.origin - octree.origin) / info.size).astype(int)
        assert (info.depth, info.size) == (DEPTH, octree.size / 2**DEPTH)
        assert leaf.indices == np.flatnonzero((cells == cell).all(axis=1)).tolist()
        np.testing.assert_allclose(leaf.color, colors[leaf.indices[-1]], atol=1e-6)
        assert info.child_index == (cell % 2) @ [1, 2, 4]


def test_internal_nodes_hold_the_points_below_them(octree):
    for node, _ in nodes_of(octree):
        if isinstance(node, G.OctreeInternalPointNode):
            below = [index for child in node.children if child is not None for index in child.indices]
            assert node.indices == sorted(below)
    assert octree.root_node.indices == list(range(300))


def test_a_point_is_located_in_its_leaf(cloud, octree):
    for index in (0, 17, 299):
        point = np.asarray(cloud.points)[index]
        node, info = octree.locate_leaf_node(point)
        assert index in node.indices and octree.is_point_in_bound(point, info.origin, info.size)
    assert octree.locate_leaf_node([0, 0, 0]) == (None, None)
    assert octree.locate_leaf_node(octree.origin + octree.size * 0.99) == (None, None)
    assert not octree.is_point_in_bound(octree.origin + octree.size, octree.origin, octree.size)


def test_inserted_points_make_the_same_nodes_as_a_cloud(cloud, octree):
    made = G.Octree(DEPTH, octree.origin, octree.size)
    leaf, internal = G.OctreePointColorLeafNode, G.OctreeInternalPointNode
    for index, (point, color) in enumerate(zip(cloud.points, cloud.colors, strict=True)):
        functions = leaf.get_init_function(), leaf.get_update_function(index, color)
        made.insert_point(point, *functions, internal.get_init_function(), internal.get_update_function(index))
    made.insert_point([0, 0, 0], leaf, leaf.get_update_function(300, [0, 0, 0]))  # outside
    pairs = list(zip(nodes_of(made), nodes_of(octree), strict=True))
    assert all(a.indices == b.indices and str(info) == str(other) for (a, info), (b, other) in pairs)
    with pytest.raises(TypeError, match="f_init:"):
        made.insert_point(cloud.points[0] * 0 + octree.origin + octree.size * 0.99, internal, lambda node: None)


def test_a_true_result_of_the_callback_skips_children(octree):
    depths = []

    def visit(node, info):
        depths.append(info.depth)
        return info.depth == 1

    octree.traverse(visit)
    assert depths == [0] + [1] * sum(child is not None for child in octree.root_node.children)


def test_voxels_of_an_octree_make_its_leaves_again(octree):
    grid = octree.to_voxel_grid()
    assert grid.voxel_size == octree.size / 2**DEPTH
    again = grid.to_octree(DEPTH + 1)
    assert isinstance(again.root_node, G.OctreeInternalNode)
    voxels = {tuple(voxel.grid_index): voxel.color for voxel in grid.get_voxels()}
    assert len(leaves_of(again)) == len(leaves_of(octree)) == len(voxels)
    for leaf, info in leaves_of(again):
        np.testing.assert_array_equal(leaf.color, voxels[tuple(grid.get_voxel(info.origin + info.size / 2))])
    other = G.VoxelGrid()
    other.create_from_octree(octree)
    assert other.get_voxel(grid.get_center()).tolist() == grid.get_voxel(grid.get_center()).tolist()


def test_copies_and_files_have_the_same_nodes(octree, tmp_path):
    path = tmp_path / "tree.json"
    assert o3d.io.write_octree(path, octree)
    for again in (
        G.Octree(octree),
        copy.deepcopy(octree),
        pickle.loads(pickle.dumps(octree)),
        o3d.io.read_octree(path),
    ):
        assert (again.size, again.max_depth, again.origin.tolist()) == (octree.size, DEPTH, octree.origin.tolist())
        pairs = list(zip(leaves_of(again), leaves_of(octree), strict=True))
        assert all(a == b and a is not b for (a, _), (b, _) in pairs)


def test_damaged_files_are_reported(octree, tmp_path):
    path = tmp_path / "tree.json"
    o3d.io.write_octree(path, G.Octree(2, [0, 0, 0], 1))
    assert o3d.io.read_octree(path).is_empty()
    good = json.loads(path.read_text())
    for wrong in ({"tree": {"class_name": "Node"}}, {"tree": {"class_name": "OctreeInternalNode"}}, {"size": -1}):
        path.write_text(json.dumps(good | wrong))
        with pytest.raises(loom.FileError, match=r"tree\.json"):
            o3d.io.read_octree(path)


def test_bounds_are_those_of_the_cube_and_motions_raise(octree):
    np.testing.assert_allclose(octree.get_max_bound() - octree.get_min_bound(), octree.size)
    np.testing.assert_allclose(octree.get_center(), octree.origin + octree.size / 2)
    np.testing.assert_allclose(octree.get_oriented_bounding_box().volume(), octree.size**3)
    with pytest.raises(RuntimeError):
        octree.translate([1, 0, 0])
    assert octree.clear().is_empty() and not octree.get_max_bound().any()
    with pytest.raises(ValueError, match="size_expand:"):
        octree.convert_from_point_cloud(G.PointCloud(), 2)


def test_equal_points_have_a_leaf_in_a_cube_of_the_expansion():
    tree = G.Octree(3)
    points = np.r_[np.ones((4, 3)), np.full((1, 3), np.nan)]
    tree.convert_from_point_cloud(G.PointCloud(o3d.utility.Vector3dVector(points)), 0.5)
    assert [leaf.indices for leaf, _ in leaves_of(tree)] == [[0, 1, 2, 3]] and tree.size == 0.5
    root = G.Octree(0, [0, 0, 0], 1)
    root.insert_point([0.5] * 3, G.OctreeColorLeafNode, G.OctreeColorLeafNode.get_update_function([1, 0, 0]))
    assert root.root_node.clone() == root.root_node and root.root_node.color.tolist() == [1, 0, 0]
