"""Clouds, lines and meshes of tensors: attributes, selections, motions, files and results, against arithmetic."""

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d
from pointloom.open3d.core import Tensor, float32, float64, int32, int64, uint8

g = o3d.t.geometry
COUNT = 60
POINTS = np.random.default_rng(0).random((COUNT, 3)) * (1, 1, 0.2)
LABELS = np.arange(COUNT, dtype=np.int32)[:, None]
MATRICES = np.random.default_rng(1).random((COUNT, 2, 2))
K = np.array([[20.0, 0, 8], [0, 20, 6], [0, 0, 1]])
HALF = [0.0, 0, 0], [0.5, 1, 1]


def cloud_of(where, dtype=np.float32, points=POINTS):
    """A cloud with a column, matrices, flags and bytes."""
    made = g.PointCloud(Tensor(points.astype(dtype), device=where))
    made.point["label"] = Tensor(LABELS, device=where)
    made.point["matrix"] = Tensor(MATRICES, device=where)
    made.point["flag"] = Tensor(LABELS[:, 0] % 2 == 0, device=where)
    made.point.colors = Tensor((POINTS * 255).astype(np.uint8), device=where)
    return made


def labels_of(cloud):
    return cloud.point["label"].numpy()[:, 0]


def test_a_tensor_map_is_a_mapping_with_attributes_and_a_primary_key():
    x = np.zeros((2, 3), np.float32)
    point = g.TensorMap("positions", {"positions": Tensor(x)})
    point.labels = [1, 2]
    point["weights"] = np.ones(2)
    assert [*point] == ["positions", "labels", "weights"] and "labels" in point and len(point) == 3 and point
    assert {name: str(tensor.dtype) for name, tensor in point.items()}["labels"] == "Int64"
    alias = point.positions
    point.positions[0] = 5.0
    assert alias.numpy()[0, 0] == 5 and point.is_size_synchronized()
    point.labels = [1, 2, 3]
    assert not point.is_size_synchronized()
    with pytest.raises(RuntimeError, match="labels"):
        point.assert_size_synchronized()
    del point.labels
    assert point.erase("labels") == 0 and point.erase("weights") == 1 and not hasattr(point, "weights")
    assert repr(point).splitlines()[1] == "  - positions: shape={2, 3}, dtype=Float32, device=CPU:0 (primary)"
    for error, work in (
        (RuntimeError, lambda: point.erase("positions")),
        (KeyError, lambda: point.colors),
        (KeyError, lambda: point.__setitem__("items", x)),
        (TypeError, lambda: point.__setitem__("a", "text")),
        (RuntimeError, lambda: g.TensorMap("positions", {"colors": Tensor(x)})),
    ):
        with pytest.raises(error):
            work()


def test_constructors_share_the_tensors_and_clones_do_not():
    x = np.random.default_rng(0).random((4, 3))
    cloud = g.PointCloud(x)
    assert np.shares_memory(cloud.point.positions.numpy(), x) and not cloud.is_empty() and g.PointCloud().is_empty()
    shared, own = g.PointCloud(cloud), cloud.clone()
    shared.point["a"] = np.zeros(4)
    cloud.translate([1.0, 0, 0])
    assert "a" not in cloud.point and (shared.point.positions.numpy() == x).all()
    assert np.abs(own.point.positions.numpy()[:, 0] - x[:, 0] + 1).max() < 1e-15
    assert (pickle.loads(pickle.dumps(cloud)).point.positions.numpy() == x).all()
    assert cloud.clear() is cloud and cloud.is_empty() and str(cloud.device) == "CPU:0" and cloud.is_cpu
    for wrong in (np.zeros((2, 2)), {"colors": x}):
        with pytest.raises(ValueError, match="positions"):
            g.PointCloud(wrong)
    with pytest.raises(AttributeError, match="point"):
        cloud.point = shared.point


SELECTIONS = {
    "uniform": (lambda c: c.uniform_down_sample(7), range(0, COUNT, 7)),
    "indices": (lambda c: c.select_by_index([5, 1, 1]), [5, 1, 1]),
    "indices, once": (lambda c: c.select_by_index([5, 1, 1], remove_duplicates=True), [1, 5]),
    "indices, inverted": (lambda c: c.select_by_index([*range(2, COUNT)], invert=True), [0, 1]),
    "mask": (lambda c: c.select_by_mask(LABELS[:, 0] < 3), [0, 1, 2]),
    "mask, inverted": (lambda c: c.select_by_mask(LABELS[:, 0] < 50, True), range(50, COUNT)),
    "box": (lambda c: c.crop(g.AxisAlignedBoundingBox(*HALF)), np.flatnonzero(POINTS[:, 0] <= 0.5)),
    "not in box": (lambda c: c.crop(g.AxisAlignedBoundingBox(*HALF), invert=True), np.flatnonzero(POINTS[:, 0] > 0.5)),
}


@pytest.mark.parametrize("name", SELECTIONS)
def test_selections_keep_all_attributes(where, name):
    work, rows = SELECTIONS[name]
    before, rows = cloud_of(where, np.float64), [*rows]
    made = work(before)
    assert labels_of(made).tolist() == rows and made.device == where
    for key, tensor in before.point.items():
        assert made.point[key].dtype == tensor.dtype and (made.point[key].numpy() == tensor.numpy()[rows]).all()


def test_removed_points_are_known_by_a_mask(where):
    points = np.concatenate([POINTS[:50], [[9, 9, 9.0]], [[np.nan, 0, 0]], POINTS[:8]])
    distances = np.sort(np.linalg.norm(points[:, None] - points, axis=2), axis=1)
    for made, expected in (
        (cloud_of(where, points=points).remove_radius_outliers(2, 0.3), distances[:, 1] < 0.3),
        (cloud_of(where, points=points).remove_non_finite_points(), np.isfinite(points).all(axis=1)),
        (cloud_of(where, points=points).remove_duplicated_points(), np.arange(COUNT) < 52),
        (cloud_of(where, points=points).remove_statistical_outliers(4, 3.0), np.arange(COUNT) != 50),
    ):
        cloud, mask = made
        assert mask.numpy().dtype == bool and mask.device == where
        assert (mask.numpy() == expected)[np.isfinite(points).all(axis=1)].all()
        assert labels_of(cloud).tolist() == np.flatnonzero(mask.numpy()).tolist()


def test_a_voxel_of_a_grid_through_zero_becomes_the_mean_of_all_attributes(where):
    points = POINTS - 0.5
    made = cloud_of(where, np.float64, points).voxel_down_sample(0.4)
    _, voxel = np.unique(np.floor(points / 0.4), axis=0, return_inverse=True)
    count = voxel.max() + 1
    assert made.point.positions.shape == (count, 3)
    for name, values, tolerance in (("positions", points, 1e-15), ("matrix", MATRICES, 1e-15), ("label", LABELS, 0)):
        means = np.array([values[voxel == i].mean(axis=0) for i in range(count)]).astype(values.dtype)
        assert np.abs(made.point[name].numpy() - means).max() <= tolerance


def test_samples_are_of_the_requested_size(where):
    cloud = cloud_of(where)
    assert len(set(labels_of(cloud.random_down_sample(0.5)))) == COUNT // 2
    farthest = labels_of(cloud.farthest_point_down_sample(2))
    assert farthest.tolist() == [0, np.linalg.norm(POINTS - POINTS[0], axis=1).argmax()]


def test_motions_write_into_the_tensor_and_keep_its_type(where):
    c, s = np.cos(0.3), np.sin(0.3)
    T = np.array([[c, -s, 0, 1.0], [s, c, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])
    for dtype, tolerance in ((np.float32, 1e-6), (np.float64, 1e-6 if where.name != "cpu" else 1e-14)):
        cloud = cloud_of(where, dtype)
        alias, expected = cloud.point.positions, POINTS
        for work, change in (
            (lambda cloud: cloud.transform(T), lambda x: x @ T[:3, :3].T + T[:3, 3]),
            (lambda cloud: cloud.rotate(T[:3, :3], [1.0, 0, 0]), lambda x: (x - [1, 0, 0]) @ T[:3, :3].T + [1, 0, 0]),
            (lambda cloud: cloud.scale(-2.0, [1.0, 0, 0]), lambda x: -2 * (x - [1, 0, 0]) + [1, 0, 0]),
            (lambda cloud: cloud.translate(Tensor([1.0, 2, 3])), lambda x: np.add(x, [1, 2, 3])),
            (lambda cloud: cloud.translate([1.0, 2, 3], relative=False), lambda x: x - x.mean(axis=0) + [1, 2, 3]),
        ):
            expected = change(expected)
            assert work(cloud) is cloud and alias.numpy().dtype == dtype
            assert np.abs(alias.numpy() - expected).max() < 10 * tolerance
        assert np.abs(cloud.get_center().numpy() - [1, 2, 3]).max() < 1e-5
        assert np.abs(cloud.get_min_bound().numpy() - expected.min(axis=0)).max() < 1e-5
        assert np.abs(cloud.get_max_bound().numpy() - expected.max(axis=0)).max() < 1e-5


def test_normals_stay_perpendicular_to_a_sheared_plane(where):
    shear = np.eye(4)
    shear[2, 0] = 1.0
    cloud = cloud_of(where, points=POINTS * (1, 1, 0))
    cloud.estimate_normals(8)
    cloud.orient_normals_to_align_with_direction()
    assert np.abs(cloud.point.normals.numpy() - [0, 0, 1]).max() < 1e-6
    cloud.orient_normals_towards_camera_location([0.0, 0, -5])
    cloud.transform(shear)
    assert np.abs(cloud.point.normals.numpy() - np.array([1, 0, -1]) / np.sqrt(2)).max() < 1e-6
    cloud.point.normals = cloud.point.normals * 3.0
    assert np.abs(np.linalg.norm(cloud.normalize_normals().point.normals.numpy(), axis=1) - 1).max() < 1e-6


def test_a_projective_matrix_divides():
    T = np.eye(4)
    T[3, 0] = 0.5
    moved = g.PointCloud(POINTS.copy()).transform(T).point.positions.numpy()
    assert np.abs(moved - POINTS / (1 + 0.5 * POINTS[:, :1])).max() < 1e-15


def test_both_clouds_need_the_attributes_of_the_first(where):
    first, second = cloud_of(where), cloud_of(where)
    second.point["more"] = Tensor(LABELS, device=where)
    made = first + second
    assert labels_of(made).tolist() == [*range(COUNT)] * 2 and "more" not in made.point
    with pytest.raises(RuntimeError, match="more"):
        second.append(first)
    with pytest.raises(RuntimeError, match="positions"):
        first.append(cloud_of(where, np.float64))


def test_legacy_clouds_keep_positions_normals_and_colors(where):
    cloud = cloud_of(where, np.float64)
    cloud.estimate_normals()
    legacy = cloud.to_legacy()
    assert (np.asarray(legacy.points) == POINTS).all()
    assert np.abs(np.asarray(legacy.colors) - cloud.point.colors.numpy() / 255).max() < 1e-7
    back = g.PointCloud.from_legacy(legacy, o3d.core.float64, where)
    assert (back.point.positions.numpy() == POINTS).all() and back.device == where
    assert np.abs(back.point.normals.numpy() - cloud.point.normals.numpy()).max() < 1e-6
    assert str(g.PointCloud.from_legacy(legacy).point.colors.dtype) == "Float32"
    assert (cloud.paint_uniform_color([0.0, 0.5, 7]).point.colors.numpy() == [0, 0.5, 1]).all()
    with pytest.raises(TypeError, match="pcd_legacy"):
        g.PointCloud.from_legacy(cloud)


def test_results_are_tensors_on_the_device(where):
    flat = cloud_of(where, points=POINTS * (1, 1, 0))
    plane, rows = flat.segment_plane()
    assert np.abs(np.abs(plane.numpy()) - [0, 0, 1, 0]).max() < 1e-6 and len(rows) == COUNT
    labels = flat.cluster_dbscan(2.0, 2)
    hull = cloud_of(where).compute_convex_hull()
    _, seen = cloud_of(where).hidden_point_removal([0.0, 0, 5], 1000.0)
    corners = hull.vertex["point_indices"]
    assert not labels.numpy().any()
    for tensor, kind in ((rows, "Int64"), (seen, "Int64"), (labels, "Int32"), (corners, "Int32"), (plane, "Float64")):
        assert str(tensor.dtype) == kind and tensor.device == where
    assert np.abs(hull.vertex.positions.numpy() - POINTS[corners.numpy()]).max() < 1e-6
    other = cloud_of(where, points=np.add(POINTS, [0.01, 0, 0]))
    metrics = cloud_of(where).compute_metrics(other, [g.Metric.HausdorffDistance], g.MetricParameters())
    assert metrics.shape == (1,) and 0 < float(metrics.numpy()[0]) <= 0.01 + 1e-6


def test_gradients_of_a_linear_color_are_its_slope(where):
    cloud = cloud_of(where, points=POINTS * (1, 1, 0))
    cloud.point.normals = Tensor(np.tile(np.float32([0, 0, 1]), (COUNT, 1)), device=where)
    cloud.point.colors = Tensor(np.float32(POINTS[:, :1] * [[0.3, 0.6, 0.9]]), device=where)
    cloud.estimate_color_gradients(10, 1.0)
    assert np.abs(cloud.point["color_gradients"].numpy() - [0.6, 0, 0]).max() < 1e-3


def test_smooth_points_of_a_plane_stay_in_it(where):
    noisy = POINTS * (1, 1, 0) + np.random.default_rng(0).normal(0, 1e-3, (COUNT, 1)) * (0, 0, 1)
    cloud = cloud_of(where, points=noisy)
    for made in (cloud.smooth_mls(0.5, 30), cloud.smooth_bilateral(0.5, 30), cloud.smooth_laplacian(2)):
        assert made.point.positions.numpy()[:, 2].std() < 0.6 * noisy[:, 2].std() and labels_of(made)[9] == 9
    assert np.abs(cloud.smooth_taubin(0).point.positions.numpy() - noisy).max() < 1e-6


def test_the_boundary_of_a_grid_is_its_rim(where):
    grid = np.stack(np.meshgrid(np.arange(7.0), np.arange(7.0), [0.0]), -1).reshape(-1, 3)
    cloud = g.PointCloud(Tensor(grid, device=where))
    cloud.point.normals = Tensor(np.tile([0.0, 0, 1], (49, 1)), device=where)
    rim, mask = cloud.compute_boundary_points(1.5, 30, 120.0)
    assert (mask.numpy() == ((grid[:, :2] % 6 == 0).any(axis=1))).all() and len(rim.point.positions) == 24


@pytest.mark.parametrize("with_normals", [False, True])
def test_depth_images_become_points_and_points_depth_images(where, with_normals):
    depth = (1000 + 10 * np.arange(16)[None] + np.zeros((12, 1))).astype(np.uint16)
    depth[3, 4] = 0
    color = np.random.default_rng(0).integers(0, 255, (12, 16, 3), np.uint8)
    T = np.eye(4)
    T[2, 3] = 0.5  # the world is half a meter behind the camera
    image = g.RGBDImage(g.Image(color).to(where), g.Image(depth).to(where))
    cloud = g.PointCloud.create_from_rgbd_image(image, K, T, depth_max=5.0, with_normals=with_normals)
    v, u = np.indices(depth.shape)
    z = depth / 1000
    expected = np.stack([(u - 8) / 20 * z, (v - 6) / 20 * z, z - 0.5], -1)
    assert cloud.device == where
    if with_normals:
        assert cloud.point.normals.numpy()[:, 2].max() < 0 and len(cloud.point.normals) == 11 * 15 - 3
        return
    assert np.abs(cloud.point.positions.numpy() - expected[depth > 0]).max() < 1e-6
    assert np.abs(cloud.point.colors.numpy() * 255 - color[depth > 0]).max() < 1e-4
    half = g.PointCloud.create_from_depth_image(image.depth, K, T, stride=2)
    assert np.abs(half.point.positions.numpy() - expected[::2, ::2].reshape(-1, 3)).max() < 1e-6
    back = cloud.project_to_depth_image(16, 12, K, T, depth_max=5.0)
    assert np.abs(back.as_tensor().numpy()[..., 0] - depth).max() < 1e-3
    both = cloud.project_to_rgbd_image(16, 12, K, T, depth_max=5.0)
    assert np.abs(both.color.as_tensor().numpy()[depth > 0] * 255 - color[depth > 0]).max() < 1e-4
    assert np.abs(both.depth.as_tensor().numpy()[..., 0] - depth).max() < 1e-3


def test_lines_move_and_keep_their_colors(where):
    lines = g.LineSet(Tensor(POINTS.astype(np.float32), device=where), Tensor([[0, 1], [1, 2]], device=where))
    lines.paint_uniform_color([1.0, 0, 0])
    alias = lines.point.positions
    lines.translate([1.0, 0, 0]).scale(2.0, [0.0, 0, 0])
    assert np.abs(alias.numpy() - 2 * np.add(POINTS, [1, 0, 0])).max() < 1e-5
    legacy = lines.to_legacy()
    assert np.asarray(legacy.colors).tolist() == [[1, 0, 0]] * 2
    assert np.asarray(legacy.lines).tolist() == [[0, 1], [1, 2]]
    back = g.LineSet.from_legacy(legacy, device=where)
    assert str(back.line.indices.dtype) == "Int64" and back.device == where
    assert (back.line.indices.numpy() == [[0, 1], [1, 2]]).all() and repr(lines).startswith(f"LineSet on {where}")
    camera = g.LineSet.create_camera_visualization(16, 12, K, np.eye(4), 2.0, [0.0, 1, 0])
    assert np.allclose(camera.point.positions.numpy()[1], [-0.8, -0.6, 2]) and len(camera.line.indices) == 11
    assert camera.line.colors.numpy()[:2].tolist() == [[0, 1, 0]] * 2 and lines.clear().is_empty()
    bare = g.LineSet.from_legacy(g.LineSet(POINTS[:2].copy(), [[0, 1]]).to_legacy())
    assert "colors" not in bare.line and g.LineSet().to_legacy().is_empty()
    with pytest.raises(ValueError, match="indices"):
        g.LineSet(POINTS, np.zeros((2, 3), int))


Mesh = o3d.t.geometry.TriangleMesh
PRIMITIVES = ["box", "sphere", "tetrahedron", "octahedron", "icosahedron", "cylinder", "cone", "ellipsoid", "torus"]
PRIMITIVES += ["arrow", "coordinate_frame", "mobius"]
AREAS = [4, 4, 6, 6, 4, 4, 6, 6, 3, 3, 3, 3]  # of the triangles of a box 2 x 3 x 4
TURN = np.array([[0.0, -1, 0, 1], [1, 0, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]])


@pytest.fixture
def box(where):
    return Mesh.create_box(2, 3, 4, float64, int32, where)


def values(tensor):
    return tensor.numpy()


def volume(mesh):
    return mesh.to_legacy().get_volume()


@pytest.mark.parametrize("name", PRIMITIVES)
def test_primitives_have_the_requested_types_and_the_shape_of_the_legacy_ones(name):
    made = getattr(Mesh, f"create_{name}")(float_dtype=float64, int_dtype=int32)
    legacy = getattr(o3d.geometry.TriangleMesh, f"create_{name}")()
    assert (made.vertex.positions.dtype, made.triangle.indices.dtype) == (float64, int32)
    np.testing.assert_allclose(values(made.vertex.positions), np.asarray(legacy.vertices), atol=1e-6)
    np.testing.assert_array_equal(values(made.triangle.indices), np.asarray(legacy.triangles))
    default = getattr(Mesh, f"create_{name}")()
    assert (default.vertex.positions.dtype, default.triangle.indices.dtype) == (float32, int64)


def test_a_mesh_of_tensors_shares_them_and_describes_itself(where):
    corners, rows = Tensor(np.eye(3), float64, where), Tensor([[0, 1, 2]], int64, where)
    mesh = Mesh(corners, rows)
    shared, own = Mesh(mesh), mesh.clone()
    corners[0, 0] = 5.0
    assert [values(m.vertex.positions)[0, 0] for m in (mesh, shared, own)] == [5, 5, 1]
    assert mesh.device == where and mesh.is_cuda == (where.name != "cpu") and not mesh.is_empty()
    assert str(mesh).startswith(f"TriangleMesh on {where} [3 vertices (Float64) and 1 triangles (Int64)].")
    for same in (copy.deepcopy(mesh), pickle.loads(pickle.dumps(mesh)), mesh.to(where, copy=True)):
        np.testing.assert_array_equal(values(same.vertex.positions), values(corners))
    empty = Mesh(device=where)
    assert empty.is_empty() and empty.device == where and empty.get_surface_area() == 0
    assert mesh.clear().is_empty() and mesh.device == where


def test_legacy_meshes_keep_their_digits_colors_normals_and_texture():
    legacy = o3d.geometry.TriangleMesh.create_box(create_uv_map=True)
    legacy.vertices = o3d.utility.Vector3dVector(np.asarray(legacy.vertices) + 1 / 3)
    legacy.compute_vertex_normals()
    legacy.paint_uniform_color([0.2, 0.4, 0.6])
    legacy.textures = [o3d.geometry.Image(np.arange(48, dtype=np.uint8).reshape(4, 4, 3))]
    mesh = Mesh.from_legacy(legacy, float64, int32)
    assert mesh.triangle.texture_uvs.numpy().shape == (12, 3, 2) and mesh.triangle.indices.dtype == int32
    assert mesh.has_valid_material()
    np.testing.assert_array_equal(values(mesh.material.texture_maps["albedo"].as_tensor())[0, 0], [36, 37, 38])
    back = mesh.to_legacy()
    for name in ("vertices", "triangles", "vertex_normals", "vertex_colors", "triangle_normals", "triangle_uvs"):
        np.testing.assert_array_equal(np.asarray(getattr(back, name)), np.asarray(getattr(legacy, name)))
    np.testing.assert_array_equal(np.asarray(back.textures[0]), np.asarray(legacy.textures[0]))
    mesh.vertex.colors = Tensor(np.full((8, 3), 51, np.uint8))
    np.testing.assert_allclose(np.asarray(mesh.to_legacy().vertex_colors), 0.2)


def test_normals_areas_and_bounds_of_a_box(box):
    box.compute_vertex_normals(normalized=False)
    np.testing.assert_allclose(np.linalg.norm(values(box.triangle.normals), axis=1), 2 * np.array(AREAS))
    np.testing.assert_allclose(values(box.vertex.normals)[0], [-12, -8, -6])  # by hand: areas at corner 0
    box.normalize_normals()
    unit = values(box.triangle.normals)
    np.testing.assert_allclose(np.linalg.norm(unit, axis=1), 1)
    box.compute_vertex_normals()
    np.testing.assert_allclose(values(box.triangle.normals), unit, atol=1e-7)
    np.testing.assert_allclose(values(box.compute_triangle_areas().triangle.areas), AREAS)
    assert box.triangle.areas.dtype == box.vertex.normals.dtype == float64 and box.get_surface_area() == 52
    places = [values(v).tolist() for v in (box.get_min_bound(), box.get_max_bound(), box.get_center())]
    assert places == [[0, 0, 0], [2, 3, 4], [1, 1.5, 2]]
    assert values(box.get_axis_aligned_bounding_box().get_extent()).tolist() == [2, 3, 4]


def test_motions_change_positions_and_both_normals_in_place(box):
    start, memory = values(box.vertex.positions).copy(), box.vertex.positions
    box.compute_vertex_normals()
    before = values(box.triangle.normals).copy(), values(box.vertex.normals).copy()
    assert box.transform(TURN) is box
    np.testing.assert_allclose(values(memory), start @ TURN[:3, :3].T + TURN[:3, 3], atol=1e-12)
    for name, old in zip(("triangle", "vertex"), before, strict=True):
        normals = values(getattr(box, name)["normals"])
        np.testing.assert_allclose(normals, old @ TURN[:3, :3].T, atol=1e-6)
    box.rotate(Tensor(TURN[:3, :3].T), Tensor(TURN[:3, 3])).translate([-1, -2, -3])
    np.testing.assert_allclose(values(box.vertex.positions), start, atol=1e-12)
    box.scale(0.5, [0, 0, 0]).translate([5, 5, 5], relative=False)
    np.testing.assert_allclose(values(box.get_min_bound()), [4.5, 4.25, 4], atol=1e-12)


def test_selections_keep_attributes_types_and_order(box):
    box.vertex.number = Tensor(np.arange(8), int64, box.device)
    box.vertex.colors = Tensor(np.full((8, 3), 200), uint8, box.device)
    box.triangle.grid = Tensor(np.arange(48.0).reshape(12, 2, 2), float32, box.device)
    chosen = box.select_by_index([7, 2, 0, 1, 99, -3])
    assert values(chosen.vertex.number).tolist() == [0, 1, 2, 7] and chosen.vertex.colors.dtype == uint8
    expected = [[0, 1, 2]], [[[16, 17], [18, 19]]]
    assert (values(chosen.triangle.indices).tolist(), values(chosen.triangle.grid).tolist()) == expected
    top = box.select_faces_by_mask(Tensor(np.arange(12) < 2, device=box.device))
    assert values(top.vertex.positions)[:, 1].tolist() == [3] * 4 and top.triangle.indices.dtype == int32
    assert "number" not in box.select_by_index([0, 1], copy_attributes=False).vertex
    for wrong in (lambda: box.select_by_index([0.5]), lambda: box.select_faces_by_mask(np.ones(11, bool))):
        with pytest.raises(RuntimeError, match=r"indices|mask"):
            wrong()
    three = Mesh(Tensor(np.eye(4, 3), device=box.device), Tensor([[0, 1, 3], [0, 1, 3], [1, 0, 3]], device=box.device))
    assert values(three.get_non_manifold_edges()).tolist() == [[0, 1], [0, 3], [1, 3]]
    assert values(three.remove_unreferenced_vertices().vertex.positions).shape == (3, 3)
    assert values(three.remove_non_manifold_edges().get_non_manifold_edges()).shape == (0, 2)


def test_cuts_sweeps_hulls_and_holes_have_the_volumes_of_solids(box):
    half = box.compute_triangle_areas().clip_plane(Tensor([1.0, 0, 0]), [1, 0, 0])
    assert values(half.get_max_bound() - half.get_min_bound()).tolist() == [1, 3, 4] and "areas" not in half.triangle
    assert volume(half.fill_holes()) == pytest.approx(12) and half.vertex.positions.dtype == float64
    lines = box.slice_plane([0, 0, 1], [0, 0, 1], [0, 1])
    ends = values(lines.point.positions)[values(lines.line.indices)]
    assert np.linalg.norm(ends[:, 0] - ends[:, 1], axis=1).sum() == pytest.approx(2 * 10)
    flat = Mesh(Tensor([[2.0, 0, 0], [3, 0, 0], [2, 0, 1]], device=box.device), Tensor([[0, 1, 2]], device=box.device))
    assert volume(flat.extrude_linear([0, -2, 0], 1.5)) == pytest.approx(1.5)
    ring = flat.extrude_rotation(360, [0, 0, 1], 64)  # Pappus: area 1/2, centroid at 7/3
    assert volume(ring) == pytest.approx(np.pi * 7 / 3, rel=2e-3)
    hull = box.compute_convex_hull()
    assert volume(hull) == pytest.approx(24) and sorted(values(hull.vertex.point_indices)) == [*range(8)]
    ball = Mesh.create_sphere(1.0, 20, device=box.device).simplify_quadric_decimation(0.5)
    assert len(values(ball.triangle.indices)) == 760 and volume(ball) == pytest.approx(4 / 3 * np.pi, rel=0.02)


def test_solids_are_combined(where):
    pytest.importorskip("manifold3d")
    one, two = (Mesh.create_box(device=where) for _ in range(2))
    two.translate([0.5, 0.5, 0.5])
    made = one.boolean_union(two), one.boolean_intersection(two), one.boolean_difference(two)
    assert [volume(mesh) for mesh in made] == pytest.approx([15 / 8, 1 / 8, 7 / 8])


def test_samples_and_metrics_of_parallel_triangles(where):
    floor = Mesh(Tensor([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float32, where), Tensor([[0, 1, 2]], int64, where))
    floor.vertex.colors = Tensor(np.full((3, 3), 51), uint8, where)
    cloud = floor.sample_points_uniformly(50, use_triangle_normal=True)
    assert cloud.device == where and (values(cloud.point.positions) @ [1, 1, 0] <= 1).all()
    assert (values(cloud.point.normals) == [0, 0, 1]).all()
    np.testing.assert_allclose(values(cloud.point.colors), 0.2, atol=1e-6)
    kinds, options = o3d.t.geometry.Metric, o3d.t.geometry.MetricParameters([1, 3], 500)
    found = floor.compute_metrics(floor.clone().translate([0, 0, 2]), (o3d.t.geometry.FScore, *kinds), options)
    np.testing.assert_allclose(values(found), [0, 100, 4, 2, 0, 100], atol=1e-6)
    with pytest.raises(TypeError, match="mesh2"):
        floor.compute_metrics(o3d.geometry.TriangleMesh(), (), options)


def test_isosurfaces_are_in_samples():
    z, y, x = np.mgrid[:9, :9, :9] - 4.0
    ball = Mesh.create_isosurfaces(Tensor(np.sqrt(x**2 + y**2 + (2 * z) ** 2).astype(np.float32)), [3.0])
    np.testing.assert_allclose(values(ball.get_max_bound()), [7, 7, 5.5], atol=0.1)
    assert ball.vertex.normals.dtype == float32


def test_attributes_are_baked_into_texels_at_their_centers(where):
    corners = Tensor([[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]], float32, where)
    plane = Mesh(corners, Tensor([[0, 1, 2], [0, 2, 3]], int64, where))
    plane.triangle.texture_uvs = Tensor(values(corners)[values(plane.triangle.indices)][..., :2] / 8, float32, where)
    plane.triangle.number = Tensor([7, 8], int32, where)
    texture = values(plane.bake_vertex_attr_textures(4, {"positions"}, margin=0.1, fill=-1)["positions"])
    np.testing.assert_allclose(texture[3, :2], [[1, 1, 0], [3, 1, 0]], atol=1e-6)  # lower left quarter
    np.testing.assert_allclose(texture[2, 1], [3, 3, 0], atol=1e-6)
    assert (texture[:2] == -1).all() and (texture[:, 2:] == -1).all() and "positions" in plane.material.texture_maps
    numbers = values(plane.bake_triangle_attr_textures(8, ["number"], 0.1, 0, False)["number"])
    assert (numbers[7, 2], numbers[5, 0], numbers[0, 0]) == (7, 8, 0) and "number" not in plane.material.texture_maps


def test_files_keep_meshes_and_textures(tmp_path):
    mesh = Mesh.from_legacy(o3d.geometry.TriangleMesh.create_box(create_uv_map=True), float64)
    pixels = np.zeros((4, 4, 3), np.uint8)
    pixels[0, 0] = 10, 20, 30
    mesh.material.set_default_properties()
    mesh.material.texture_maps["albedo"] = o3d.t.geometry.Image(Tensor(pixels))
    for name in ("m.obj", "m.npz", "m.ply"):
        assert o3d.t.io.write_triangle_mesh(tmp_path / name, mesh)
        back = o3d.t.io.read_triangle_mesh(tmp_path / name)
        np.testing.assert_array_equal(values(back.triangle.indices), values(mesh.triangle.indices))
        np.testing.assert_array_equal(values(back.vertex.positions), values(mesh.vertex.positions))
        np.testing.assert_allclose(values(back.triangle.texture_uvs), values(mesh.triangle.texture_uvs), atol=1e-6)
        np.testing.assert_array_equal(values(back.material.texture_maps["albedo"].as_tensor()), pixels)
        assert "number" not in mesh.vertex or values(back.vertex.number).tolist() == [*range(8)]
        mesh.vertex.number = Tensor(np.arange(8, dtype=np.int32))
    assert o3d.t.io.read_triangle_mesh(tmp_path / "m.npz").vertex.positions.dtype == float64
    mesh.vertex.colors = Tensor(np.full((8, 3), 51, np.uint8))
    mesh.compute_vertex_normals().translate([5e5, 5e6, 0])
    o3d.t.io.write_triangle_mesh(tmp_path / "far.ply", mesh)
    far = o3d.t.io.read_triangle_mesh(tmp_path / "far.ply")
    np.testing.assert_allclose(values(far.vertex.positions), values(mesh.vertex.positions), rtol=0, atol=1e-6)
    np.testing.assert_allclose(values(far.vertex.colors), 0.2, atol=1e-7)
    assert far.vertex.positions.dtype == float64 and "normals" in far.vertex and "normals" not in far.triangle
    np.savez(tmp_path / "other.npz", a=np.zeros(3))
    with pytest.raises(loom.FileError, match="vertices"):
        o3d.t.io.read_triangle_mesh(tmp_path / "other.npz")
    with pytest.raises(loom.FileError, match="missing"):
        o3d.t.io.read_triangle_mesh(tmp_path / "missing.npz")


@pytest.mark.parametrize(
    ("call", "error", "name"),
    [
        (lambda m: Mesh.from_legacy(m), TypeError, "mesh_legacy"),
        (lambda m: Mesh(np.zeros((2, 2)), [[0, 1, 0]]), ValueError, "positions"),
        (lambda m: m.simplify_quadric_decimation(100), ValueError, "target_reduction"),
        (lambda m: m.boolean_union(m.to_legacy()), TypeError, "mesh"),
        (lambda m: m.bake_vertex_attr_textures(8, {"positions"}), ValueError, "texture_uvs"),
        (lambda m: m.to_mitsuba("a"), AttributeError, "not here"),
        (lambda m: Mesh.create_text("a"), AttributeError, "not here"),
    ],
)
def test_wrong_arguments_and_missing_methods_are_named(call, error, name):
    with pytest.raises(error, match=name):
        call(Mesh.create_box())
