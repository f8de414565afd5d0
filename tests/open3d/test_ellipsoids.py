"""Oriented bounding ellipsoids, and alpha shapes of given tetrahedra, beside those of Open3D."""

import copy
import pickle

import numpy as np
import pytest

import pointloom.open3d as bridge

POINTS = np.random.default_rng(0).normal(size=(50, 3)) * [1, 2, 3]
CUBE = np.array(np.meshgrid(*[[0.0, 1]] * 3)).reshape(3, -1).T
CLOUDS = {"random": POINTS, "few": POINTS[:4], "cube": CUBE, "one missing": np.r_[POINTS[:20], [[np.nan] * 3]]}
MOTIONS = {
    "none": lambda shape, R: shape,
    "moved": lambda shape, R: shape.translate([1, 2, 3]),
    "placed": lambda shape, R: shape.translate([1, 2, 5], relative=False),
    "scaled": lambda shape, R: shape.scale(2, [1, 0, 0]),
    "reflected": lambda shape, R: shape.scale(-2, [1, 0, 0]),
    "rotated": lambda shape, R: shape.rotate(R, [1, 0, 0]),
    "rotated about its center": lambda shape, R: shape.rotate(R),
    "cleared": lambda shape, R: shape.clear(),
}  # fmt: skip


def rotation(o3d):
    return o3d.geometry.get_rotation_matrix_from_xyz([0.1, 0.2, 0.3])


def made(o3d, radii=(1, 2, 0.5)):
    return o3d.geometry.OrientedBoundingEllipsoid([1, 2, 3], rotation(o3d), radii)


def parts(shape):
    values = shape.center, shape.radii, shape.R, shape.get_center(), shape.get_min_bound(), shape.get_max_bound()
    return [*map(np.array, values), shape.volume(), np.array(shape.color), shape.is_empty() * 1, repr(shape)]


def same(actual, expected, tolerance=1e-8):
    assert len(actual) == len(expected)
    for one, other in zip(actual, expected, strict=True):
        if isinstance(other, str):
            assert one == other
        else:
            np.testing.assert_allclose(one, other, atol=tolerance)


def fitted(o3d):
    kind, vector = o3d.geometry.OrientedBoundingEllipsoid, o3d.utility.Vector3dVector
    return [parts(kind.create_from_points(vector(points))) for points in CLOUDS.values()]


def test_fitted_ellipsoids_agree_with_open3d(oracle):
    for actual, expected in zip(fitted(bridge), oracle("open3d/ellipsoids", fitted), strict=True):
        same(actual, expected)


def moved(o3d):
    found = []
    for motion in MOTIONS.values():
        shape = made(o3d)
        shape.color = [1, 0, 0.5]
        assert motion(shape, rotation(o3d)) is shape
        found.append(parts(shape))
    return found


def test_motions_agree_with_open3d(oracle):
    for actual, expected in zip(moved(bridge), oracle("open3d/moved_ellipsoids", moved), strict=True):
        same(actual, expected)


def meshes(o3d):
    mesh = o3d.geometry.TriangleMesh.create_from_oriented_bounding_ellipsoid(made(o3d), [1, 2, 1], 5, True)
    lines = o3d.geometry.LineSet.create_from_oriented_bounding_ellipsoid(made(o3d))
    box = made(o3d).get_oriented_bounding_box()
    arrays = mesh.vertices, mesh.triangles, mesh.triangle_uvs, box.center, box.extent, lines.colors[:2]
    return [*map(np.array, arrays), np.sum(lines.points, axis=0), np.array(lines.lines)[::50], np.abs(box.R)]


def test_meshes_lines_and_boxes_of_an_ellipsoid_agree_with_open3d(oracle):
    same(meshes(bridge), oracle("open3d/ellipsoid_meshes", meshes), 1e-6)


def test_attributes_can_be_assigned_and_copies_are_independent():
    shape = made(bridge)
    shape.center, shape.radii, shape.R = [0, 0, 0], [[1], [1], [2]], np.eye(3)
    other = copy.deepcopy(shape)
    other.center[0] = 7
    assert shape.center[0] == 0 and pickle.loads(pickle.dumps(shape)).get_max_bound().tolist() == [1, 1, 2]
    assert bridge.geometry.OrientedBoundingEllipsoid(other).center[0] == 7


def test_ellipsoids_reject_flat_points_and_matrices():
    flat = POINTS * [1, 1, 0]
    for points, message in ((flat, "not on one plane"), (POINTS[:3], "at least 4 finite points, got 3")):
        for robust in (False, True):
            with pytest.raises(ValueError, match=message):
                bridge.geometry.OrientedBoundingEllipsoid.create_from_points(points, robust)
    with pytest.raises(RuntimeError, match="translate"):
        made(bridge).transform(np.eye(4))
    with pytest.raises(ValueError, match="R"):
        bridge.geometry.OrientedBoundingEllipsoid([0, 0, 0], 2 * np.eye(3), [1, 1, 1])


def test_clouds_and_meshes_have_ellipsoids_of_their_points(device):
    g, Tensor = bridge.t.geometry, bridge.core.Tensor
    legacy = bridge.geometry.OrientedBoundingEllipsoid.create_from_points(POINTS)
    cloud = bridge.geometry.PointCloud(bridge.utility.Vector3dVector(POINTS))
    same(parts(cloud.get_oriented_bounding_ellipsoid()), parts(legacy))
    where = bridge.core.Device(device.upper())
    shape = g.PointCloud(Tensor(POINTS, device=where)).get_oriented_bounding_ellipsoid()
    assert shape.device == where and str(shape.radii.dtype) == "Float64"
    same([shape.center.numpy(), shape.rotation.numpy(), shape.volume()], [legacy.center, legacy.R, legacy.volume()])
    ball = g.TriangleMesh.create_sphere(2.0, device=where).get_oriented_bounding_ellipsoid()
    np.testing.assert_allclose(ball.radii.numpy(), 2, atol=1e-4)


def test_ellipsoids_of_tensors_move_and_convert():
    kind, R = bridge.t.geometry.OrientedBoundingEllipsoid, rotation(bridge)
    shape = kind.from_legacy(made(bridge), bridge.core.float64)
    before = shape.clone()
    shape.set_color([1.0, 0, 0])
    assert shape.translate([1.0, 0, 0]).scale(2.0).rotate(R, [0.0, 0, 0]) is shape
    expected = made(bridge).translate([1, 0, 0]).scale(2, [2, 2, 3]).rotate(R, [0, 0, 0])
    expected.color = [1, 0, 0]
    same(parts(shape.to_legacy()), parts(expected))
    same(parts(before.to_legacy()), parts(made(bridge)))
    ends = before.get_ellipsoid_points()
    assert ends.shape == (6, 3)
    inside = before.get_point_indices_within_bounding_ellipsoid(np.r_[[[9.0, 9, 9], [1, 2, 3]], 0.99 * ends.numpy()
                                                                     + 0.01 * np.array([1, 2, 3])])  # fmt: skip
    assert inside.numpy().tolist() == [1, 2, 3, 4, 5, 6, 7]
    before.set_radii([1.0, 1, 1])
    before.set_center([0.0, 0, 0])
    before.set_rotation(np.eye(3))
    assert before.get_axis_aligned_bounding_box().max_bound.numpy().tolist() == [1, 1, 1]
    assert before.get_oriented_bounding_box().extent.numpy().tolist() == [2, 2, 2]
    mesh = bridge.t.geometry.TriangleMesh.create_from_oriented_bounding_ellipsoid(before, resolution=6)
    lines = bridge.t.geometry.LineSet.create_from_oriented_bounding_ellipsoid(before, resolution=6)
    np.testing.assert_allclose(np.linalg.norm(mesh.vertex.positions.numpy(), axis=1), 1, atol=1e-6)
    assert lines.point.positions.shape == mesh.vertex.positions.shape
    with pytest.raises(TypeError, match="ellipsoid"):
        kind.from_legacy(bridge.geometry.AxisAlignedBoundingBox())


def alpha_shape(o3d):
    """Alpha shape of some of the tetrahedra of a cloud at twice their size."""
    random, vector = np.random.default_rng(0), o3d.utility.Vector3dVector
    cloud = o3d.geometry.PointCloud(vector(random.random((12, 3))))
    cloud.normals, cloud.colors = vector(random.normal(size=(12, 3))), vector(random.random((12, 3)))
    tetras = [[i, i + 1, i + 2, i + 4] for i in range(8)]
    shape = o3d.geometry.TetraMesh(vector(2 * np.asarray(cloud.points)), o3d.utility.Vector4iVector(tetras))
    rows = list(range(11, -1, -1))
    mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 1.5, shape, rows)
    triangles = np.sort(np.array(mesh.triangles), axis=1)
    arrays = mesh.vertices, mesh.vertex_normals, mesh.vertex_colors, triangles[np.lexsort(triangles.T)]
    return [*map(np.array, arrays)]


def test_the_alpha_shape_of_given_tetrahedra_agrees_with_open3d(oracle):
    expected = oracle("open3d/alpha_shape_of_tetrahedra", alpha_shape)
    assert 4 < len(expected[3]) < 32
    same(alpha_shape(bridge), expected, 1e-6)


def test_the_alpha_shape_of_given_tetrahedra_faces_outward():
    cloud = bridge.geometry.PointCloud(bridge.utility.Vector3dVector(POINTS))
    tetrahedra, rows = bridge.geometry.TetraMesh.create_from_point_cloud(cloud)
    mesh = bridge.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, 1e6, tetrahedra, rows)
    assert mesh.get_volume() == pytest.approx(cloud.compute_convex_hull()[0].get_volume(), rel=1e-6)


def test_the_flags_of_the_build_and_the_compiled_module_have_open3ds_names():
    assert bridge._build_config["BUILD_CUDA_MODULE"] is True and bridge._build_config["BUILD_GUI"] is False
    assert bridge._build_config["GLIBCXX_USE_CXX11_ABI"] == bridge.pybind._GLIBCXX_USE_CXX11_ABI
    assert bridge.pybind.geometry.PointCloud is bridge.geometry.PointCloud
    with pytest.raises(AttributeError, match="nothing"):
        bridge.pybind.nothing  # noqa: B018


def test_there_are_no_sycl_devices(capsys):
    sycl = bridge.core.sycl
    assert (sycl.device_count(), sycl.is_available(), sycl.get_available_devices()) == (0, False, [])
    sycl.enable_persistent_jit_cache()
    sycl.print_sycl_devices()
    assert capsys.readouterr().out == "No SYCL devices.\n"
