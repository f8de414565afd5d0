"""Voxel grids of pointloom.open3d: pooling, carving and motions, by float64 arithmetic."""

import copy
import pickle

import numpy as np
import pytest

import pointloom.open3d as o3d
from pointloom.open3d.visualization.shown import bounds_of

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
    assert len(grid._native.triangles) == 12 * len(voxels)  # drawn as cubes


def camera(shift=0.0):
    made = o3d.camera.PinholeCameraParameters()
    made.intrinsic.set_intrinsics(40, 30, 30, 30, 19.5, 14.5)
    pose = np.eye(4)
    pose[0, 3] = shift
    made.extrinsic = pose
    return made


def corners_of(cells):
    steps = np.stack(np.meshgrid(*[[0, 1]] * 3), axis=-1).reshape(-1, 3)
    return [-1, -1, -1] + (np.array(cells)[:, None] + steps) * 0.25


@pytest.mark.parametrize("keep", [False, True])
@pytest.mark.parametrize("by_depth", [False, True])
def test_carving_keeps_voxels_with_a_corner_in_the_mask_or_behind_the_depth(keep, by_depth):
    grid = VoxelGrid.create_dense([-1, -1, -1], [1, 0, 0], 0.25, 2, 2, 4)
    cells = sorted(voxels_of(grid))
    image = np.zeros((30, 40), np.float32)
    image[:, :20] = 1.6
    carve = grid.carve_depth_map if by_depth else grid.carve_silhouette
    assert carve(o3d.geometry.Image(image), camera(0.1), keep) is grid
    x, y, z = np.moveaxis(corners_of(cells) + np.array([0.1, 0, 0]), -1, 0)
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
