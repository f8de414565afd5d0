"""Odometry, SLAM, voxel block grids and ray casting of tensors."""

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as bridge
import pointloom.open3d as o3d
from pointloom.open3d.core import Tensor, float32, float64, int32, int64, uint16, uint32

WIDTH, HEIGHT, FARTHEST, FAR_OF_SLAM = 96, 72, 10.0, 6.0


@pytest.fixture(scope="module")
def views():
    """Two frames of a synthetic room."""
    return loom.datasets.room_frames(2, width=WIDTH, height=HEIGHT)


def images_of(package, views, device="CPU:0"):
    """RGBDImages with 16-bit depth in millimeters, and the camera matrix."""
    Tensor, Image, where = package.core.Tensor, package.t.geometry.Image, package.core.Device(device)
    images = []
    for view in views:
        depth = (view.depth * 1000).round().astype(np.uint16)
        arrays = np.ascontiguousarray(view.color), depth
        images.append(package.t.geometry.RGBDImage(*(Image(Tensor(values, device=where)) for values in arrays)))
    return images, Tensor(np.asarray(views[0].intrinsic.matrix))


def pose_of(package, views, method):
    """Transformation, inlier RMSE and fitness of `rgbd_odometry_multi_scale`."""
    (source, target), K = images_of(package, views)
    odometry, start = package.t.pipelines.odometry, package.core.Tensor(np.eye(4))
    levels = [odometry.OdometryConvergenceCriteria(steps) for steps in (8, 4, 2)]
    method = getattr(odometry.Method, method)
    found = odometry.rgbd_odometry_multi_scale(source, target, K, start, 1000.0, FARTHEST, levels, method)
    return found.transformation.numpy(), found.inlier_rmse, found.fitness


def plane_results_of(package, views):
    """The pose by `PointToPlane`, and the information matrix at this pose."""
    (source, target), K = images_of(package, views)
    pose = pose_of(package, views, "PointToPlane")
    depths, T = (source.depth, target.depth), package.core.Tensor(pose[0])
    information = package.t.pipelines.odometry.compute_odometry_information_matrix
    return pose, information(*depths, K, T, 0.07, 1000.0, FARTHEST).numpy()


def compare_poses(actual, expected, tolerance):
    (T, rmse, fitness), (expected_T, expected_rmse, expected_fitness) = actual, expected
    assert np.allclose(T, expected_T, atol=tolerance) and fitness == pytest.approx(expected_fitness, abs=2e-3)
    assert rmse == pytest.approx(expected_rmse, rel=5e-3)


def test_odometry_is_that_of_open3d(oracle, views):
    expected, expected_information = oracle("open3d/t/odometry", plane_results_of, views)
    actual, information = plane_results_of(bridge, views)
    compare_poses(actual, expected, 1e-5)
    assert np.allclose(information, expected_information, atol=2e-3 * expected_information.max())


def test_odometry_with_intensity_is_near_that_of_open3d(o3d, views):
    """Open3D returns one of two poses, 3e-4 apart. Intensity alone ends anywhere in images of this size."""
    compare_poses(pose_of(bridge, views, "Hybrid"), pose_of(o3d, views, "Hybrid"), 1e-3)


def test_point_to_plane_odometry_finds_the_motion(device, views):
    (source, target), K = images_of(bridge, views, device.upper())
    odometry = bridge.t.pipelines.odometry
    levels = [odometry.OdometryConvergenceCriteria(steps) for steps in (20, 10, 5)]
    method = odometry.Method.PointToPlane
    found = odometry.rgbd_odometry_multi_scale(source, target, K, np.eye(4), 1000.0, FARTHEST, levels, method)
    T = np.linalg.inv(views[1].T_world_camera) @ views[0].T_world_camera
    assert np.linalg.norm(T[:3, 3]) > 0.05 and np.allclose(found.transformation.numpy(), T, atol=6e-3)


def test_odometry_reports_what_it_cannot_use(views):
    (source, target), K = images_of(bridge, views)
    odometry = bridge.t.pipelines.odometry
    blank = bridge.t.geometry.Image(bridge.core.Tensor(np.zeros((HEIGHT, WIDTH), np.uint16)))
    empty = bridge.t.geometry.RGBDImage(source.color, blank)
    with pytest.raises(RuntimeError, match="do not determine"):
        odometry.rgbd_odometry_multi_scale(source, empty, K)
    with pytest.raises(TypeError, match="source:"):
        odometry.rgbd_odometry_multi_scale(source.depth, target, K)
    with pytest.raises(TypeError, match="criteria_list:"):
        odometry.rgbd_odometry_multi_scale(source, target, K, criteria_list=[3])
    floats = bridge.t.geometry.RGBDImage(source.color.to(bridge.core.float32), source.depth)
    first = [odometry.rgbd_odometry_multi_scale(one, target, K, depth_max=FARTHEST) for one in (source, floats)]
    assert np.allclose(*(one.transformation.numpy() for one in first), atol=1e-3)


@pytest.mark.slow
def test_a_model_tracks_a_camera_as_the_example_of_dense_slam(device):
    views = loom.datasets.room_frames(3, width=WIDTH, height=HEIGHT)
    slam, Tensor, where = bridge.t.pipelines.slam, bridge.core.Tensor, bridge.core.Device(device.upper())
    K = Tensor(np.asarray(views[0].intrinsic.matrix))
    model = slam.Model(0.03, 16, 1000, Tensor(np.eye(4)), where)
    given, rendered = (slam.Frame(HEIGHT, WIDTH, K, where) for _ in range(2))
    T_world_camera = np.eye(4)
    for i, view in enumerate(views):
        depth = Tensor((view.depth * 1000).round().astype(np.uint16))
        given.set_data_from_image("depth", bridge.t.geometry.Image(depth))
        given.set_data("color", Tensor(np.ascontiguousarray(view.color)))
        if i:
            found = model.track_frame_to_model(given, rendered, 1000.0, FAR_OF_SLAM, 0.07)
            T_world_camera = T_world_camera @ found.transformation.numpy()
        model.update_frame_pose(i, T_world_camera)
        model.integrate(given, 1000.0, FAR_OF_SLAM, 8.0)
        model.synthesize_model_frame(rendered, 1000.0, 0.1, FAR_OF_SLAM, 8.0, i == 2)
    true = np.linalg.inv(views[0].T_world_camera) @ views[2].T_world_camera
    assert np.linalg.norm(true[:3, 3]) > 0.05
    assert np.allclose(model.get_current_frame_pose().numpy(), true, atol=8e-3)
    depth = rendered.get_data("depth")
    assert depth.device == where and depth.shape == (HEIGHT, WIDTH, 1)
    assert rendered.get_data_as_image("color").columns == WIDTH
    seen = (depth.numpy()[..., 0] > 0) & (views[2].depth < FAR_OF_SLAM)
    assert seen.mean() > 0.4 and np.median(np.abs(depth.numpy()[..., 0] / 1000 - views[2].depth)[seen]) < 0.015
    cloud, mesh = model.extract_pointcloud(2.0), model.extract_trianglemesh(2.0)
    assert len(cloud.point.positions.numpy()) > 1000 and len(mesh.vertex.positions.numpy()) > 1000
    assert model.frame_id == 2 and slam.Model(model).voxel_grid is model.voxel_grid


def test_frames_and_models_explain_what_is_missing():
    slam = bridge.t.pipelines.slam
    frame = slam.Frame(3, 4, np.eye(3), "CPU:0")
    assert (frame.height(), frame.width()) == (3, 4)
    with pytest.raises(KeyError, match="depth"):
        frame.get_data("depth")
    with pytest.raises(AttributeError, match="voxel_grid"):
        slam.Model(0.01, device="CPU:0").frustum_block_coords  # noqa: B018
    with pytest.raises(AttributeError, match="run_slac_optimizer_for_fragments"):
        bridge.t.pipelines.slac  # noqa: B018


Grid, Image = o3d.t.geometry.VoxelBlockGrid, o3d.t.geometry.Image
K = np.array([[60.0, 0, 31.5], [0, 60, 23.5], [0, 0, 1]])
T = np.array([[1, 0, 0, 0.1], [0, 0, -1, 0.2], [0, 1, 0, 0.3], [0, 0, 0, 1.0]])  # world to camera
SIZE, TRUNCATION, FRAMES, COLOR = 0.02, 0.08, 4, (200, 100, 50)
LIMITS = 1000.0, 3.0, 4.0  # scale and maximum of depth, truncation in voxels


def images(where):
    """Depth and color of a plane at 1 m."""
    depth, color = np.full((48, 64), 1000, np.uint16), np.full((48, 64, 3), COLOR, np.uint8)
    return [Image(Tensor(pixels, device=where)) for pixels in (depth, color)]


def colored(where):
    names, channels = ("tsdf", "weight", "color"), ((1), (1), (3))
    return Grid(names, (float32, uint16, float32), channels, SIZE, 16, 100, where)


@pytest.fixture
def grid(where):
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


def test_views_show_the_plane_from_the_camera(grid, where):
    names = ["depth", "vertex", "normal", "color"]
    view = grid.ray_cast(None, K, T, 64, 48, names, 1000.0, 0.1, 3.0, FRAMES, 4.0)
    assert all(view[name].dtype == float32 and view[name].device == where for name in names)
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


def test_the_surface_is_the_plane(grid, where):
    mesh, cloud = grid.extract_triangle_mesh(), grid.extract_point_cloud(FRAMES - 1)
    assert mesh.device == cloud.device == where
    assert (mesh.vertex.positions.dtype, mesh.triangle.indices.dtype) == (float32, int32)
    for tensors in (mesh.vertex, cloud.point):
        np.testing.assert_allclose(depths_of(tensors.positions.numpy()), 1, atol=1e-5)
        np.testing.assert_allclose(tensors.normals.numpy() @ T[2, :3], -1, atol=1e-4)  # toward the camera
        np.testing.assert_allclose(tensors.colors.numpy()[0], np.array(COLOR) / 255, atol=1e-4)
    assert mesh.get_surface_area() == pytest.approx(64 / 60 * 48 / 60, rel=0.1)
    assert grid.extract_triangle_mesh(FRAMES).is_empty() and grid.extract_point_cloud(FRAMES).is_empty()


def test_all_forms_of_integrate_and_files_give_the_same_grid(grid, where, tmp_path):
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
        (lambda *_: Scene().add_triangles(o3d.geometry.TriangleMesh.create_box()), TypeError, "mesh"),
        (lambda *_: Scene().cast_rays(np.zeros((2, 5), np.float32)), ValueError, "rays"),
        (lambda *_: Scene().compute_distance(np.zeros((2, 4), np.float32)), ValueError, "query_points"),
        (lambda g, d, c: Grid(["tsdf"], [float32], [1]), ValueError, "attr_names"),
        (lambda g, d, c: Grid(["tsdf", "weight", "label"], [float32] * 3, [1] * 3), ValueError, "attr_names"),
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


Scene, Mesh = o3d.t.geometry.RaycastingScene, o3d.t.geometry.TriangleMesh
INVALID = 2**32 - 1
TYPES = {"t_hit": "float32", "geometry_ids": "uint32", "primitive_ids": "uint32", "ray_splits": "uint32"}
TYPES |= {"ray_ids": "uint32", "primitive_uvs": "float32", "primitive_normals": "float32", "points": "float32"}


@pytest.fixture
def scene(where):
    made = Scene(device=where)
    assert made.add_triangles(Mesh.create_box(device=where)) == 0
    return made


def on(where, values, dtype=float32):
    return Tensor(values, dtype, where)


def read(results, where):
    """Results as NumPy arrays, after a check of types and devices."""
    assert all(v.device == where and v.numpy().dtype == TYPES[k] for k, v in results.items())
    return {name: tensor.numpy() for name, tensor in results.items()}


RAYS = [[[0.25, 0.5, 3, 0, 0, -1], [0.25, 0.5, 0.5, 0, 0, 2]], [[5, 5, 5, 1, 0, 0], [-1, 0.25, 0.5, 0.5, 0, 0]]]


def test_rays_hit_the_box_at_known_parameters(scene, where):
    found = read(scene.cast_rays(on(where, RAYS)), where)
    np.testing.assert_array_equal(found["t_hit"], [[2, 0.25], [np.inf, 2]])
    np.testing.assert_array_equal(found["geometry_ids"], [[0, 0], [INVALID, 0]])
    np.testing.assert_array_equal(found["primitive_normals"], [[[0, 0, 1], [0, 0, 1]], [[0, 0, 0], [-1, 0, 0]]])
    assert found["primitive_ids"][1, 0] == INVALID == Scene.INVALID_ID and found["primitive_uvs"].shape == (2, 2, 2)
    box = Mesh.create_box()
    corners = box.vertex.positions.numpy()[box.triangle.indices.numpy()[found["primitive_ids"][0, 0]]]
    u, v = found["primitive_uvs"][0, 0]
    np.testing.assert_allclose((1 - u - v) * corners[0] + u * corners[1] + v * corners[2], [0.25, 0.5, 1], atol=1e-6)


def test_all_intersections_are_counted_listed_and_tested(scene, where):
    rays = on(where, RAYS)
    counts = scene.count_intersections(rays)
    assert counts.dtype == int32 and counts.numpy().tolist() == [[2, 1], [0, 2]]
    listed = read(scene.list_intersections(rays), where)
    assert listed["ray_splits"].tolist() == [0, 2, 3, 3, 5] and listed["ray_ids"].tolist() == [0, 0, 1, 3, 3]
    np.testing.assert_array_equal(listed["t_hit"], [2, 3, 0.25, 2, 4])
    blocked = [scene.test_occlusions(rays, *limits).numpy() for limits in ((), (0.0, 1.5), (2.5,))]
    assert [b.tolist() for b in blocked] == [[[1, 1], [0, 1]], [[0, 1], [0, 0]], [[1, 0], [0, 1]]]


def test_distances_to_the_box_are_signed_and_have_the_shape_of_the_queries(scene, where):
    queries = on(where, [[[0.5, 0.5, 0.5], [2, 0.5, 0.5]], [[0.5, 0.5, 1.25], [4, 5, 0.5]]])
    for method, expected in (
        (scene.compute_distance, [[0.5, 1], [0.25, 5]]),
        (scene.compute_signed_distance, [[-0.5, 1], [0.25, 5]]),
        (scene.compute_occupancy, [[1, 0], [0, 0]]),
    ):
        found = method(queries, nthreads=2)
        assert found.dtype == float32 and found.device == where
        np.testing.assert_array_equal(found.numpy(), expected)
    closest = read(scene.compute_closest_points(queries), where)
    np.testing.assert_array_equal(closest["points"][0, 1], [1, 0.5, 0.5])
    np.testing.assert_array_equal(closest["points"][1, 1], [1, 1, 0.5])
    assert closest["geometry_ids"].tolist() == [[0, 0], [0, 0]]


def test_geometries_are_numbered_and_taken_as_tensors_arrays_or_meshes(where):
    made = Scene(0, where)
    corners = np.array([[0, 0, 2], [1, 0, 2], [0, 1, 2]])
    assert made.add_triangles(on(where, corners, float64), on(where, [[0, 1, 2]], uint32)) == 0
    assert made.add_triangles(vertex_positions=corners + 1.0, triangle_indices=np.array([[0, 1, 2]])) == 1
    assert made.add_triangles(mesh=Mesh.create_box(device=where)) == 2
    rays = np.array([[0.2, 0.2, 9, 0, 0, -1], [1.2, 1.2, 9, 0, 0, -1]], np.float32)
    for scene in (made, copy.deepcopy(made), pickle.loads(pickle.dumps(made))):
        assert scene.cast_rays(rays)["geometry_ids"].numpy().tolist() == [0, 1]
    assert Scene().cast_rays(rays)["t_hit"].numpy().tolist() == [np.inf] * 2


def test_rays_of_a_camera_pass_through_pixel_centers():
    K, T = [[4.0, 0, 1.5], [0, 4, 1], [0, 0, 1]], np.eye(4)
    T[:3, 3] = 0, 0, 2
    rays = Scene.create_rays_pinhole(Tensor(K), extrinsic_matrix=Tensor(T), width_px=3, height_px=2)
    assert rays.dtype == float32 and tuple(rays.shape) == (2, 3, 6)
    np.testing.assert_allclose(rays.numpy()[1, 2], [0, 0, -2, 1 / 4, 0.5 / 4, 1])
    view = Scene.create_rays_pinhole(90, Tensor([0.0, 0, 0]), [0, 0, 2], [0, 1, 0], 2, 2).numpy()
    np.testing.assert_allclose(view[0, 0], [0, 0, 2, 0.5, -0.5, -1], atol=1e-7)
