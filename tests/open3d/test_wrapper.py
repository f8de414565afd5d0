"""Objects of pointloom.open3d wrap pointloom objects: ownership and synchronization of arrays."""

import copy
import pickle
import subprocess
import sys

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as o3d

V = o3d.utility.Vector3dVector


@pytest.fixture
def cloud():
    return o3d.geometry.PointCloud(V(np.random.default_rng(0).random((50, 3))))


def test_the_import_is_as_light_as_that_of_the_package():
    program = "import sys, pointloom.open3d; print({'warp', 'numpy', 'scipy', 'open3d'} & set(sys.modules))"
    answer = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True, timeout=300)
    assert answer.stdout.strip() == "set()"


def test_writes_to_an_array_take_effect(cloud):
    points = np.asarray(cloud.points)
    points += [0, 0, 5]
    assert cloud.get_center()[2] > 5
    cloud.points[3] = [7, 7, 7]
    assert cloud.get_max_bound().tolist() == [7, 7, 7]


def test_arrays_follow_inplace_operations(cloud):
    points, vector = np.asarray(cloud.points), cloud.points
    before = points.copy()
    assert cloud.translate([1, 0, 0]) is cloud and np.abs(points - before - [1, 0, 0]).max() < 1e-6
    assert cloud.points is vector


def test_the_tree_stays_while_no_array_is_written_to(cloud):
    cloud.estimate_normals()
    tree = cloud._native._known_search_tree
    np.asarray(cloud.points)
    np.asarray(cloud.normals)
    assert tree is not None and cloud._native._known_search_tree is tree
    np.asarray(cloud.points)[0] += 1
    assert cloud._native._known_search_tree is not tree


def test_points_that_were_assigned_keep_their_digits(cloud):
    values = np.random.default_rng(1).random((50, 3)) * 1e6
    cloud.points = V(values)
    cloud.paint_uniform_color([1, 0, 0])
    assert (np.asarray(cloud.points) == values).all()
    cloud.normals = V(values)
    cloud.translate([1, 0, 0])
    assert (np.asarray(cloud.normals) == values).all()


def test_conversion_shares_no_memory_with_vectors(cloud):
    cloud.colors = V(np.full((50, 3), 0.5))
    cloud.covariances = o3d.utility.Matrix3dVector(np.tile(np.eye(3), (50, 1, 1)))
    before = cloud._native
    copies = [np.array(values) for values in (before.points, before.colors, before.covariances)]
    for vector in (cloud.points, cloud.colors, cloud.covariances):
        np.asarray(vector)[:] = 0
    for values, now in zip(copies, (before.points, before.colors, before.covariances), strict=True):
        assert (values == now).all()
    assert not cloud._native.covariances.any()


def test_arrays_of_other_lengths_are_applied_together(cloud):
    cloud.colors = V(np.full((20, 3), 0.5))
    assert not cloud.has_colors() and not cloud._native.has_colors()
    cloud.points = V(np.asarray(cloud.points)[:20])
    assert cloud.has_colors() and cloud._native.has_colors()


@pytest.mark.parametrize(
    "again", [copy.copy, copy.deepcopy, o3d.geometry.PointCloud, lambda c: pickle.loads(pickle.dumps(c))]
)
def test_copies_are_others(cloud, again):
    cloud.paint_uniform_color([0, 1, 0])
    np.asarray(cloud.colors)[0] = [0, 0, 1]
    other = again(cloud)
    np.asarray(other.points)[0] = 9
    other.translate([1, 1, 1])
    assert cloud.get_max_bound().max() <= 1
    assert np.asarray(other.colors)[0].tolist() == [0, 0, 1] and repr(other) == "PointCloud with 50 points."


def test_a_mesh_has_normals_of_triangles_once_they_were_computed():
    mesh = o3d.geometry.TriangleMesh.create_box()
    assert not mesh.has_triangle_normals() and len(mesh.triangle_normals) == 0
    normals = mesh.triangle_normals
    mesh.compute_triangle_normals()
    assert mesh.has_triangle_normals() and len(normals) == 12
    mesh.remove_triangles_by_index([0, 1])
    assert len(normals) == 10
    assert pickle.loads(pickle.dumps(mesh)).has_triangle_normals() and copy.deepcopy(mesh).has_triangle_normals()


def test_triangles_may_be_assigned_before_vertices_and_bounds_one_after_the_other():
    mesh = o3d.geometry.TriangleMesh()
    mesh.triangles = o3d.utility.Vector3iVector([[0, 1, 2]])
    mesh.vertices = V(np.eye(3))
    assert mesh.get_surface_area() == pytest.approx(np.sqrt(3) / 2)
    box = o3d.geometry.AxisAlignedBoundingBox([0, 0, 0], [1, 1, 1])
    box.min_bound = [4, 4, 4]
    box.max_bound = [5, 6, 7]
    assert box.volume() == 6


def test_boxes_stay_valid():
    box = o3d.geometry.AxisAlignedBoundingBox([0, 0, 0], [1, 2, 3]).scale(-2, center=[0, 0, 1])
    assert box.min_bound.tolist() == [-2, -4, -3] and box.max_bound.tolist() == [0, 0, 3]
    rotated = o3d.geometry.OrientedBoundingBox([0, 0, 0], np.eye(3), [1, -2, 3])
    rotated.extent = [-4, 5, 6]
    assert rotated.volume() == 120
    with pytest.raises(ValueError, match="R:"):
        rotated.rotate(np.diag([1, 1, 0]), center=[0, 0, 0])
    with pytest.raises(ValueError, match="scale:"):
        rotated.scale(0, center=[0, 0, 0])


def test_textures_begin_with_their_lowest_row():
    mesh = o3d.geometry.TriangleMesh.create_box(create_uv_map=True)
    picture = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)
    mesh.textures = [o3d.geometry.Image(picture)]
    assert (np.asarray(mesh.textures[0]) == picture).all() and (mesh._native.textures[0] == picture[::-1]).all()


def test_random_operations_follow_one_seed():
    mesh = o3d.geometry.TriangleMesh.create_box()
    runs = []
    for _ in range(2):
        o3d.utility.random.seed(7)
        runs.append([np.asarray(mesh.sample_points_uniformly(5).points).tolist() for _ in range(2)])
    assert runs[0] == runs[1] and runs[0][0] != runs[0][1]


def test_vectors_grow_like_lists():
    numbers = o3d.utility.IntVector([3, 1])
    numbers.append(4)
    numbers.extend([1, 5])
    numbers.insert(0, 9)
    assert (list(numbers), numbers.count(1), numbers.pop(), 4 in numbers) == ([9, 3, 1, 4, 1, 5], 2, 5, True)
    numbers.remove(1)
    assert list(numbers[1:]) == [3, 4, 1] and np.asarray(numbers).dtype == np.int32
    rows = V()
    rows.append([1, 2, 3])
    assert np.asarray(rows).shape == (1, 3) and pickle.loads(pickle.dumps(rows)) == rows


@pytest.mark.parametrize(
    ("wrong", "kind", "message"),
    [
        (lambda: o3d.t.io.RGBDVideoReader, AttributeError, "loom.RealSenseCamera"),
        (lambda: o3d.geometry.PointCloud().vertices, AttributeError, "cloud.points"),
        (lambda: o3d.geometry.TriangleMesh.create_nothing, AttributeError, "create_nothing"),
        (lambda: setattr(o3d.geometry.PointCloud(), "color", 1), AttributeError, "color"),
        (lambda: setattr(o3d.geometry.PointCloud(), "points", [[0, 0, 0]]), TypeError, "Vector3dVector"),
        (lambda: V(np.zeros((3, 4))), ValueError, "array.T"),
        (lambda: o3d.utility.IntVector([0.5]), TypeError, "expected integers"),
        (lambda: o3d.geometry.PointCloud() + loom, TypeError, "expected a PointCloud, got module"),
        (lambda: o3d.geometry.TriangleMesh() + loom, TypeError, "expected a TriangleMesh, got module"),
        (lambda: o3d.geometry.PointCloud().estimate_normals(0.1), TypeError, "KDTreeSearchParamHybrid"),
        (lambda: o3d.io.read_point_cloud("nowhere.ply"), loom.FileError, "nowhere.ply"),
        (lambda: o3d.geometry.KDTreeFlann(o3d.geometry.PointCloud()), ValueError, "got none"),
        (lambda: o3d.geometry.Image(np.zeros((2, 2))), TypeError, "astype"),
    ],
)  # fmt: skip
def test_missing_features_name_the_pointloom_equivalent(wrong, kind, message):
    with pytest.raises(kind, match=message):
        wrong()


def test_objects_of_the_real_package_are_rejected(to_open3d):
    with pytest.raises(TypeError, match="target:"):
        o3d.geometry.PointCloud(V(np.eye(3))).compute_point_cloud_distance(to_open3d(np.eye(3)))


def test_pointloom_objects_are_accepted(cloud):
    assert len(cloud.compute_point_cloud_distance(loom.PointCloud(np.eye(3)))) == 50
    assert o3d.geometry.PointCloud(loom.PointCloud(np.eye(3))).has_points()
    assert len((o3d.geometry.TriangleMesh.create_box() + loom.TriangleMesh.create_box()).triangles) == 24
