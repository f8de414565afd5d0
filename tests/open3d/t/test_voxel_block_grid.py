"""`o3d.t.geometry.VoxelBlockGrid`: a plane seen by a rotated camera, with values by arithmetic."""

import numpy as np
import pytest

import pointloom.open3d as o3d
from pointloom.open3d.core import Tensor, float32, float64, int32, int64, uint16

Grid, Image = o3d.t.geometry.VoxelBlockGrid, o3d.t.geometry.Image
K = np.array([[60.0, 0, 31.5], [0, 60, 23.5], [0, 0, 1]])
T = np.array([[1, 0, 0, 0.1], [0, 0, -1, 0.2], [0, 1, 0, 0.3], [0, 0, 0, 1.0]])  # world to camera
SIZE, TRUNCATION, FRAMES, COLOR = 0.02, 0.08, 4, (200, 100, 50)
LIMITS = 1000.0, 3.0, 4.0  # scale and maximum of depth, truncation in voxels


def device_named(device):
    return o3d.core.Device(device.upper())


def images(where):
    """Depth and color of a plane at 1 m."""
    depth, color = np.full((48, 64), 1000, np.uint16), np.full((48, 64, 3), COLOR, np.uint8)
    return [Image(Tensor(pixels, device=where)) for pixels in (depth, color)]


def colored(where):
    names, channels = ("tsdf", "weight", "color"), ((1), (1), (3))
    return Grid(names, (float32, uint16, float32), channels, SIZE, 16, 100, where)


@pytest.fixture
def grid(device):
    where = device_named(device)
    made, (depth, color) = colored(where), images(where)
    blocks = made.compute_unique_block_coordinates(depth, Tensor(K), Tensor(T), *LIMITS)
    assert blocks.dtype == int32 and blocks.device == where and blocks.shape[1] == 3
    for _ in range(FRAMES):
        made.integrate(blocks, depth, color, Tensor(K), Tensor(T), *LIMITS)
    return made


def depths_of(points):
    return (points @ T[:3, :3].T + T[:3, 3])[:, 2]


def test_voxels_store_the_truncated_distance_to_the_plane(grid):
    grid = grid.cpu()
    positions, rows = grid.voxel_coordinates_and_flattened_indices()
    tsdf, weight, color = (grid.attribute(name) for name in ("tsdf", "weight", "color"))
    blocks = len(tsdf.numpy())
    assert tuple(color.shape) == (blocks, 8, 8, 8, 3) and (tsdf.dtype, weight.dtype) == (float32, uint16)
    seen = weight.numpy().reshape(-1)[rows.numpy()] > 0
    expected = np.minimum((1 - depths_of(positions.numpy()[seen])) / TRUNCATION, 1)
    np.testing.assert_allclose(tsdf.numpy().reshape(-1)[rows.numpy()][seen], expected, atol=2e-6)
    assert set(weight.numpy().reshape(-1)) == {0, FRAMES} and (expected >= -1 - 1e-6).all()
    np.testing.assert_array_equal(color.numpy().reshape(-1, 3)[rows.numpy()][seen], np.tile(COLOR, (seen.sum(), 1)))
    indices = grid.voxel_indices()
    assert indices.dtype == int64 and tuple(indices.shape) == (4, 512 * blocks)
    np.testing.assert_allclose(grid.voxel_coordinates(indices).numpy().T * SIZE, positions.numpy(), atol=1e-6)
    one = [result.numpy() for result in grid.voxel_coordinates_and_flattened_indices(Tensor([1]))]
    np.testing.assert_array_equal(one[0], positions.numpy()[512:1024])
    np.testing.assert_array_equal(one[1], np.arange(512, 1024))
    np.testing.assert_allclose(one[0][1] - one[0][0], [SIZE, 0, 0], atol=1e-6)  # x is the last axis


def test_views_show_the_plane_from_the_camera(grid, device):
    names = ["depth", "vertex", "normal", "color"]
    view = grid.ray_cast(None, K, T, 64, 48, names, 1000.0, 0.1, 3.0, FRAMES, 4.0)
    assert all(view[name].dtype == float32 and view[name].device == device_named(device) for name in names)
    depth, vertex, normal, color = (view[name].numpy() for name in names)
    assert depth.shape == (48, 64, 1) and [*view] == names
    inside = np.s_[4:-4, 4:-4]
    np.testing.assert_allclose(depth[inside], 1000, atol=0.01)
    v, u = np.mgrid[:48, :64]
    rays = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(u.shape)], -1)
    np.testing.assert_allclose(vertex[inside], rays[inside], atol=1e-5)
    np.testing.assert_allclose(normal[inside], np.broadcast_to([0, 0, 1], rays.shape)[inside], atol=1e-5)
    np.testing.assert_allclose(color[inside], np.broadcast_to(COLOR, rays.shape)[inside] / 255, atol=1e-4)
    names += ["index", "mask", "interp_ratio"]
    around = grid.ray_cast(None, K, T, 64, 48, names, 1000.0, weight_threshold=FRAMES)
    index, mask, ratio = (around[name].numpy()[inside] for name in names[4:])
    assert index.dtype == np.int64 and mask.dtype == bool and mask.all()
    np.testing.assert_allclose(ratio.sum(-1), 1, atol=1e-6)
    positions = grid.voxel_coordinates_and_flattened_indices()[0].numpy()  # rows are those of attributes
    world = (vertex[inside] - T[:3, 3]) @ T[:3, :3]
    np.testing.assert_allclose((positions[index] * ratio[..., None]).sum(-2), world, atol=1e-5)
    behind = grid.ray_cast(None, K, np.diag([1, 1, -1, 1]) @ np.diag([1, -1, 1, 1]) @ T, 64, 48, names, 1000.0)
    assert not any(behind[name].numpy().any() for name in names)
    late = grid.ray_cast(None, K, T, 64, 48, weight_threshold=FRAMES + 1, trunc_voxel_multiplier=4.0)
    assert not late.depth.numpy().any()


def test_the_surface_is_the_plane(grid, device):
    mesh, cloud = grid.extract_triangle_mesh(), grid.extract_point_cloud(FRAMES - 1)
    assert mesh.device == cloud.device == device_named(device)
    assert (mesh.vertex.positions.dtype, mesh.triangle.indices.dtype) == (float32, int32)
    for tensors in (mesh.vertex, cloud.point):
        np.testing.assert_allclose(depths_of(tensors.positions.numpy()), 1, atol=1e-5)
        np.testing.assert_allclose(tensors.normals.numpy() @ T[2, :3], -1, atol=1e-4)  # toward the camera
        np.testing.assert_allclose(tensors.colors.numpy()[0], np.array(COLOR) / 255, atol=1e-4)
    assert mesh.get_surface_area() == pytest.approx(64 / 60 * 48 / 60, rel=0.1)
    assert grid.extract_triangle_mesh(FRAMES).is_empty() and grid.extract_point_cloud(FRAMES).is_empty()


def test_all_forms_of_integrate_and_files_give_the_same_grid(grid, device, tmp_path):
    where = device_named(device)
    depth, color = images(where)
    k, t = Tensor(K, float64), Tensor(T, float32)
    other = colored(where)
    other.integrate(None, depth, color, k, k, t, *LIMITS)
    other.integrate(None, depth, color, depth_intrinsic=k, color_intrinsic=k, extrinsic=t, trunc_voxel_multiplier=4.0)
    other.integrate(None, depth=depth, color=color, intrinsic=k, extrinsic=t, trunc_voxel_multiplier=4.0)
    other.integrate(None, depth.as_tensor(), color, k, t, *LIMITS)
    plain = Grid(("tsdf", "weight"), (float32, float32), ((1), (1)), SIZE, device=where)
    for _ in range(FRAMES):
        plain.integrate(None, depth, k, t, *LIMITS)
    plain.save(tmp_path / "grid.npz")
    expected = grid.extract_triangle_mesh().vertex.positions.numpy()
    for made in (other, plain, Grid.load(tmp_path / "grid.npz"), plain.to(where, copy=True)):
        np.testing.assert_array_equal(made.extract_triangle_mesh().vertex.positions.numpy(), expected)
    assert Grid.load(tmp_path / "grid.npz").attribute("weight").dtype == float32


@pytest.mark.parametrize(
    ("call", "error", "name"),
    [
        (lambda g, d, c: Grid(["tsdf"], [float32], [1]), ValueError, "attr_names"),
        (lambda g, d, c: Grid(["tsdf", "weight", "label"], [float32] * 3, [1] * 3), ValueError, "HashMap"),
        (lambda g, d, c: g.integrate(None, d, c, K, 2 * K, T), ValueError, "color_intrinsic"),
        (lambda g, d, c: g.integrate(None, d, c, K), TypeError, "extrinsic"),
        (lambda g, d, c: g.integrate(None, d, c, K, T, depth_scal=1), TypeError, "depth_scal"),
        (lambda g, d, c: g.ray_cast(None, K, T, 4, 4, ["range"]), ValueError, "render_attributes"),
        (lambda g, d, c: g.attribute("label"), ValueError, "attribute_name"),
        (lambda g, d, c: g.voxel_indices([5]), IndexError, "buf_indices"),
        (lambda g, d, c: g.hashmap(), AttributeError, "voxel_coordinates_and_flattened_indices"),
    ],
)
def test_wrong_arguments_and_missing_methods_are_named(call, error, name):
    with pytest.raises(error, match=name):
        call(colored("CPU:0"), *images("CPU:0"))


def test_another_truncation_is_rejected():
    grid, (depth, color) = colored("CPU:0"), images("CPU:0")
    grid.compute_unique_block_coordinates(depth, K, T, trunc_voxel_multiplier=2.0)
    assert grid.extract_triangle_mesh().is_empty() and grid.voxel_indices().shape[1] == 0
    grid.integrate(None, depth, color, K, T, trunc_voxel_multiplier=5.0)
    with pytest.raises(ValueError, match="trunc_voxel_multiplier"):
        grid.integrate(None, depth, color, K, T, trunc_voxel_multiplier=4.0)
