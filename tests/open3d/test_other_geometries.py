"""Voxel grids, octrees and TetraMesh of pointloom.open3d."""

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.open3d.visualization.shown import bounds_of

POINTS = np.random.default_rng(0).normal(size=(50, 3)) * [1, 2, 3]
CUBE = np.array(np.meshgrid(*[[0.0, 1]] * 3)).reshape(3, -1).T


def rotation(o3d):
    return o3d.geometry.get_rotation_matrix_from_xyz([0.1, 0.2, 0.3])


def same(actual, expected, tolerance=1e-8):
    assert len(actual) == len(expected)
    for one, other in zip(actual, expected, strict=True):
        if isinstance(other, str):
            assert one == other
        else:
            np.testing.assert_allclose(one, other, atol=tolerance)


def alpha_shape(o3d):
    """Alpha shape of some of the tetrahedra of a cloud at twice their size."""
    random, vector = np.random.default_rng(0), o3d.utility.Vector3dVector
    cloud = o3d.geometry.PointCloud(vector(random.random((12, 3))))
    cloud.normals, cloud.colors = vector(random.normal(size=(12, 3))), vector(random.random((12, 3)))
    tetras = [[i, i + 1, i + 2, i + 4] for i in range(8)]
    shape = o3d.geometry.TetraMesh(vector(2 * np.asarray(cloud.points)), o3d.utility.Vector4iVector(tetras))
    mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 1.5, shape, list(range(11, -1, -1)))
    triangles = np.sort(np.array(mesh.triangles), axis=1)
    arrays = mesh.vertices, mesh.vertex_normals, mesh.vertex_colors, triangles[np.lexsort(triangles.T)]
    return [*map(np.array, arrays)]


def test_alpha_shapes_of_tetrahedra_agree_with_open3d(oracle):
    expected = oracle("open3d/alpha_shape_of_tetrahedra", alpha_shape)
    same(alpha_shape(o3d), expected, 1e-6)
    assert 4 < len(expected[3]) < 32


def test_the_alpha_shape_of_given_tetrahedra_faces_outward():
    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(POINTS))
    tetrahedra, rows = o3d.geometry.TetraMesh.create_from_point_cloud(cloud)
    mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 1e6, tetrahedra, rows)
    assert mesh.get_volume() == pytest.approx(cloud.compute_convex_hull()[0].get_volume(), rel=1e-6)


V, Voxel, VoxelGrid = o3d.utility.Vector3dVector, o3d.geometry.Voxel, o3d.geometry.VoxelGrid
Modes = VoxelGrid.VoxelPoolingMode
SIZE = 0.5


@pytest.fixture
def cloud(rng):
    made = o3d.geometry.PointCloud(V(rng.normal(size=(400, 3))))
    made.colors = V(rng.random((400, 3)))
    return made


def voxels_of(grid):
    return {tuple(voxel.grid_index.tolist()): voxel.color for voxel in grid.get_voxels()}


@pytest.mark.parametrize(("mode", "pool"), [("AVG", np.mean), ("MIN", np.min), ("MAX", np.max), ("SUM", np.sum)])
def test_a_voxel_has_the_pooled_color_of_its_points(cloud, mode, pool):
    points, colors = np.asarray(cloud.points), np.asarray(cloud.colors)
    grid = VoxelGrid.create_from_point_cloud_within_bounds(cloud, SIZE, [-1] * 3, [1] * 3, Modes[mode])
    cells = np.floor((points + 1) / SIZE).astype(int)
    voxels = voxels_of(grid)
    assert set(voxels) == set(map(tuple, cells.tolist()))
    for cell, color in voxels.items():
        np.testing.assert_allclose(color, pool(colors[(cells == cell).all(axis=1)], axis=0), atol=1e-6)
    assert all(grid.check_if_included(V(points))) and not any(grid.check_if_included(V(points + 100)))
    other = VoxelGrid.create_from_point_cloud(cloud, SIZE, Modes[mode])
    np.testing.assert_allclose(other.origin, points.min(axis=0) - SIZE / 2, atol=1e-6)
    assert all(other.check_if_included(V(points)))


def test_points_that_are_not_finite_have_no_voxel(cloud):
    count = len(VoxelGrid.create_from_point_cloud(cloud, SIZE).get_voxels())
    cloud.points.append([np.nan, 0, 0])
    cloud.colors.append([0, 0, 0])
    assert len(VoxelGrid.create_from_point_cloud(cloud, SIZE).get_voxels()) == count


def test_a_dense_grid_has_all_voxels_of_its_box():
    grid = VoxelGrid.create_dense([1, 2, 3], [0, 0.5, 1], 0.1, 0.3, 0.2, 0.4)
    assert voxels_of(grid).keys() == {(i, j, k) for i in range(3) for j in range(2) for k in range(4)}
    np.testing.assert_allclose([grid.get_min_bound(), grid.get_max_bound()], [[1, 2, 3], [1.3, 2.2, 3.4]])
    np.testing.assert_allclose(grid.get_voxel_center_coordinate([2, 0, 1]), [1.25, 2.05, 3.15])
    assert not grid.get_voxel_center_coordinate([3, 0, 0]).any()
    corners = np.asarray(grid.get_voxel_bounding_points([0, 0, 0]))
    np.testing.assert_allclose(corners[[1, 2, 4]] - corners[0], [[0, 0, 0.1], [0.1, 0, 0], [0, 0.1, 0]], atol=1e-12)


def test_voxels_are_added_recolored_and_removed():
    grid = VoxelGrid.create_dense([0, 0, 0], [1, 0, 0], 1, 2, 1, 1)
    for index in ([5, -1, 0], [0, 0, 0]):
        grid.add_voxel(Voxel(index, [0, 1, 0]))
    grid.remove_voxel([1, 0, 0])
    assert {k: v.tolist() for k, v in voxels_of(grid).items()} == {(0, 0, 0): [0, 1, 0], (5, -1, 0): [0, 1, 0]}
    other = VoxelGrid.create_dense([0, 0, 0], [1, 0, 0], 1, 1, 1, 1)
    assert voxels_of(grid + other)[0, 0, 0].tolist() == [0.5, 0.5, 0]
    for again in (VoxelGrid(grid), copy.deepcopy(grid), pickle.loads(pickle.dumps(grid))):
        again.clear()
        assert not again.has_voxels() and len(grid.get_voxels()) == 2
    with pytest.raises(ValueError, match="other:"):
        grid += VoxelGrid()


def test_a_moved_grid_contains_the_moved_points(cloud):
    points = np.asarray(cloud.points)
    grid = VoxelGrid.create_from_point_cloud(cloud, SIZE)
    voxels, center = voxels_of(grid), grid.get_center()
    R = o3d.geometry.get_rotation_matrix_from_xyz([0.3, -0.2, 0.9])
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R.T, [4, 5, 6]
    grid.rotate(R, [1, 2, 3]).translate([1, 0, 0]).scale(2, [0, 0, 1]).transform(T)

    def move(x):
        x = 2 * ((x - [1, 2, 3]) @ R.T + [2, 2, 3] - [0, 0, 1]) + [0, 0, 1]
        return x @ R + [4, 5, 6]

    assert all(grid.check_if_included(V(move(points)))) and voxels_of(grid).keys() == voxels.keys()
    np.testing.assert_allclose(grid.get_center(), move(center), atol=1e-9)
    np.testing.assert_allclose(grid.rotation, np.eye(3), atol=1e-12)
    assert grid.voxel_size == 2 * SIZE
    np.testing.assert_allclose(grid.translate([0, 0, 0], relative=False).get_center(), 0, atol=1e-9)
    grid.rotation = R
    assert len(grid.native.triangles) == 12 * len(voxels)  # drawn as cubes


def camera(shift=0.0):
    made = o3d.camera.PinholeCameraParameters()
    made.intrinsic.set_intrinsics(40, 30, 30, 30, 19.5, 14.5)
    pose = np.eye(4)
    pose[0, 3] = shift
    made.extrinsic = pose
    return made


@pytest.mark.parametrize("keep", [False, True])
@pytest.mark.parametrize("by_depth", [False, True])
def test_carving_keeps_voxels_with_a_corner_in_the_mask_or_behind_the_depth(keep, by_depth):
    grid = VoxelGrid.create_dense([-1, -1, -1], [1, 0, 0], 0.25, 2, 2, 4)
    cells = sorted(voxels_of(grid))
    image = np.zeros((30, 40), np.float32)
    image[:, :20] = 1.6
    carve = grid.carve_depth_map if by_depth else grid.carve_silhouette
    assert carve(o3d.geometry.Image(image), camera(0.1), keep) is grid
    x, y, z = np.moveaxis(0.25 * (np.array(cells)[:, None] + CUBE) + np.array([-0.9, -1, -1]), -1, 0)
    with np.errstate(divide="ignore", invalid="ignore"):
        u, v = 30 * x / z + 19.5, 30 * y / z + 14.5
        inside = (z > 0) & (u >= 0) & (u <= 39) & (v >= 0) & (v <= 29)
        values = 1.6 * np.clip(20 - u, 0, 1)  # bilinear between columns 19 and 20
    hit = inside & (values > 0) & ((z >= values) | (not by_depth))
    expected = (hit | (~inside & keep)).any(axis=1)
    assert 0 < expected.sum() < len(cells)
    assert sorted(voxels_of(grid)) == [cell for cell, kept in zip(cells, expected, strict=True) if kept]


def test_images_for_carving_are_float32_of_the_cameras_size():
    grid = VoxelGrid.create_dense([0, 0, 0], [1, 0, 0], 1, 1, 1, 1)
    with pytest.raises(TypeError, match="silhouette_mask:"):
        grid.carve_silhouette(o3d.geometry.Image(np.ones((30, 40), np.uint8)), camera())
    with pytest.raises(ValueError, match="depth_map:"):
        grid.carve_depth_map(o3d.geometry.Image(np.ones((30, 41), np.float32)), camera())
    with pytest.raises(TypeError, match="camera_params:"):
        grid.carve_depth_map(o3d.geometry.Image(np.ones((30, 40), np.float32)), None)


@pytest.mark.parametrize("is_text", [False, True])
def test_a_grid_is_read_as_written(cloud, tmp_path, is_text):
    grid = VoxelGrid.create_from_point_cloud(cloud, SIZE)
    grid.rotate(o3d.geometry.get_rotation_matrix_from_xyz([0.3, -0.2, 0.9]), [1, 2, 3])
    path = tmp_path / "grid.ply"
    assert o3d.io.write_voxel_grid(path, grid, write_ascii=is_text)
    again = o3d.io.read_voxel_grid(path)
    np.testing.assert_array_equal(again.origin, grid.origin)
    np.testing.assert_array_equal(again.rotation, grid.rotation)
    colors = voxels_of(again)
    assert (again.voxel_size, colors.keys()) == (SIZE, voxels_of(grid).keys())
    np.testing.assert_allclose(list(colors.values()), list(voxels_of(grid).values()), atol=0.5 / 255 + 1e-9)


def test_a_window_shows_the_bounds_of_voxels_and_octrees(cloud):
    grid, octree = VoxelGrid.create_from_point_cloud(cloud, SIZE), o3d.geometry.Octree(3)
    octree.convert_from_point_cloud(cloud)
    for geometry in (grid, octree):
        low, high = bounds_of([geometry])
        np.testing.assert_allclose([low, high], [geometry.get_min_bound(), geometry.get_max_bound()])


G = o3d.geometry
DEPTH = 4


@pytest.fixture
def scattered(rng):
    made = G.PointCloud(o3d.utility.Vector3dVector(rng.random((300, 3)) * [1, 2, 0.5] + 10))
    made.colors = o3d.utility.Vector3dVector(rng.random((300, 3)))
    return made


@pytest.fixture
def octree(scattered):
    made = G.Octree(DEPTH)
    made.convert_from_point_cloud(scattered, 0.05)
    return made


def nodes_of(octree):
    visited = []
    octree.traverse(lambda node, info: visited.append((node, info)))
    return visited


def leaves_of(octree):
    return [(node, info) for node, info in nodes_of(octree) if isinstance(node, G.OctreeLeafNode)]


def test_leaves_are_the_cells_of_a_grid_and_hold_their_points(scattered, octree):
    points, colors = np.asarray(scattered.points), np.asarray(scattered.colors)
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


def test_a_point_is_located_in_its_leaf(scattered, octree):
    for index in (0, 17, 299):
        point = np.asarray(scattered.points)[index]
        node, info = octree.locate_leaf_node(point)
        assert index in node.indices and octree.is_point_in_bound(point, info.origin, info.size)
    assert octree.locate_leaf_node([0, 0, 0]) == (None, None)
    assert octree.locate_leaf_node(octree.origin + octree.size * 0.99) == (None, None)
    assert not octree.is_point_in_bound(octree.origin + octree.size, octree.origin, octree.size)


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


def test_copies_have_the_same_nodes(octree):
    copies = G.Octree(octree), copy.deepcopy(octree), pickle.loads(pickle.dumps(octree))
    for again in copies:
        assert (again.size, again.max_depth, again.origin.tolist()) == (octree.size, DEPTH, octree.origin.tolist())
        pairs = list(zip(leaves_of(again), leaves_of(octree), strict=True))
        assert all(a == b and a is not b for (a, _), (b, _) in pairs)


GRID = """ply
format ascii 1.0
element origin 1
property double x
property double y
property double z
element rotation 1
{rotation}element voxel_size 1
property double val
element vertex {count}
property double x
property double y
property double z
property float red
property float green
property float blue
end_header
{values}
"""
ROTATION = "".join(f"property double r{row}{column}\n" for row in range(3) for column in range(3))
SOUND = {"origin": "0 0 0", "rotation": "1 0 0 0 1 0 0 0 1", "size": "0.25", "cell": "1 0 0 255 0 9"}


@pytest.mark.parametrize(
    ("part", "value", "where"),
    [
        *(("cell", f"{x} 0 0 0 0 0", r"element vertex, row 0, property x\): expected integers") for x in
          ("nan", "inf", "1e30", "3000000000", "0.7")),
        *(("cell", f"1 0 0 0 {green} 0", r"element vertex, row 0, property green\): expected colors") for green in
          ("nan", "256", "-1")),
        ("cell", "1 0 0 0 0 0\n1 0 0 0 0 9", "expected each voxel once"),
        *(("size", value, "voxel_size") for value in ("0", "-1", "nan", "inf")),
        *(("origin", f"0 {y} 0", r"element origin, row 0, property y\): expected finite") for y in ("nan", "1e300")),
        *(("rotation", f"1 0 0 0 1 0 0 0 {r}", "rotation") for r in ("nan", "2", "-1")),
    ],
)  # fmt: skip
def test_wrong_values_of_a_voxel_grid_are_named(tmp_path, part, value, where):
    path = tmp_path / "grid.ply"
    for values in (SOUND, SOUND | {part: value}):
        count = values["cell"].count("\n") + 1
        path.write_text(GRID.format(rotation=ROTATION, count=count, values="\n".join(values.values())))
        if values is SOUND:
            (voxel,) = o3d.io.read_voxel_grid(path).get_voxels()
            np.testing.assert_allclose(voxel.color, [1, 0, 9 / 255])
            assert voxel.grid_index.tolist() == [1, 0, 0]
        else:
            with pytest.raises(loom.FileError, match=rf"grid\.ply.*{where}"):
                o3d.io.read_voxel_grid(path)


def test_an_empty_voxel_grid_is_read_as_written(tmp_path):
    o3d.io.write_voxel_grid(tmp_path / "grid.ply", VoxelGrid())
    assert not o3d.io.read_voxel_grid(tmp_path / "grid.ply").has_voxels()


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
    leaf = leaves_of(tree)[0][0]
    assert leaf.clone() == leaf and leaf.clone() is not leaf


def test_tetrahedra_of_a_cloud_fill_its_hull_without_points_inside_their_spheres(rng):
    points = rng.normal(size=(60, 3))
    points[7] = np.nan
    mesh, rows = G.TetraMesh.create_from_point_cloud(G.PointCloud(V(np.r_[points, points[:1]])))
    assert len(rows) == 59 and 7 not in rows and {0, 60} - set(rows) != set()
    vertices = np.asarray(mesh.vertices)
    np.testing.assert_array_equal(vertices, np.r_[points, points[:1]][rows])
    corners = vertices[np.asarray(mesh.tetras)]
    a, edges = corners[:, 0], corners[:, 1:] - corners[:, :1]
    volume = np.abs(np.linalg.det(edges)).sum() / 6
    np.testing.assert_allclose(volume, mesh.compute_convex_hull()[0].get_volume(), rtol=1e-5)
    centers = a + np.linalg.solve(2 * edges, (edges**2).sum(axis=2)[..., None])[..., 0]
    radii = np.linalg.norm(centers - a, axis=1)
    assert (np.linalg.norm(vertices - centers[:, None], axis=2) >= radii[:, None] * (1 - 1e-6)).all()


@pytest.mark.parametrize("points", [np.zeros((0, 3)), np.eye(3), np.c_[np.eye(5)[:, :2], np.zeros(5)]])
def test_points_on_a_plane_have_no_tetrahedra(points):
    with pytest.raises(ValueError, match="point_cloud:"):
        G.TetraMesh.create_from_point_cloud(G.PointCloud(V(points)))


def small():
    return G.TetraMesh(V(np.eye(4, 3, -1)), o3d.utility.Vector4iVector([[0, 1, 2, 3]]))


def test_meshes_of_tetrahedra_are_moved_and_copied():
    mesh = small()
    assert np.asarray(mesh.tetras).tolist() == [[0, 1, 2, 3]] and mesh.has_tetras()
    mesh.translate([1, 0, 0]).paint_uniform_color([1, 0, 0])
    np.testing.assert_allclose(mesh.get_center(), [1.25, 0.25, 0.25])
    assert mesh.has_vertex_colors()
    for again in (copy.deepcopy(mesh), G.TetraMesh(mesh), pickle.loads(pickle.dumps(mesh))):
        assert str(again) == "TetraMesh with 4 points and 1 tetrahedra."
        assert str(again.clear()) == "TetraMesh with 0 points and 0 tetrahedra."
    assert len(mesh.tetras) == 1 and mesh.get_geometry_type() == G.Geometry.TetraMesh
