"""Objects of pointloom.open3d wrap pointloom objects: arrays, vectors, and contents of files."""

import copy
import json
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
    tree = cloud.native.arrays.tree.known
    np.asarray(cloud.points)
    np.asarray(cloud.normals)
    assert tree is not None and cloud.native.arrays.tree.known is tree
    np.asarray(cloud.points)[0] += 1
    assert cloud.native.arrays.tree.known is not tree


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
    before = cloud.native
    copies = [np.array(values) for values in (before.points, before.colors, before.covariances)]
    for vector in (cloud.points, cloud.colors, cloud.covariances):
        np.asarray(vector)[:] = 0
    for values, now in zip(copies, (before.points, before.colors, before.covariances), strict=True):
        assert (values == now).all()
    assert not cloud.native.covariances.any()


def test_covariances_and_planar_patches_of_a_cloud(cloud):
    covariances = np.asarray(o3d.geometry.PointCloud.estimate_point_covariances(cloud))
    cloud.estimate_covariances()
    np.testing.assert_array_equal(covariances, cloud.covariances)
    flat = o3d.geometry.TriangleMesh.create_box(4, 4, 1).sample_points_uniformly(3000, use_triangle_normal=True)
    boxes = flat.detect_planar_patches()
    assert len(boxes) > 1 and max(np.sort(box.extent)[1] for box in boxes) > 3.5
    solid = o3d.geometry.OrientedBoundingBox([0, 0, 0], np.eye(3), [1, 2, 3])
    assert len(o3d.geometry.TriangleMesh.create_from_oriented_bounding_box(solid, scale=[1, 1, 0.1]).triangles) == 12


def test_arrays_of_other_lengths_are_applied_together(cloud):
    cloud.colors = V(np.full((20, 3), 0.5))
    assert not cloud.has_colors() and not cloud.native.has_colors()
    cloud.points = V(np.asarray(cloud.points)[:20])
    assert cloud.has_colors() and cloud.native.has_colors()


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
    image = np.arange(48, dtype=np.uint8).reshape(4, 4, 3)
    mesh.textures = [o3d.geometry.Image(image)]
    assert (np.asarray(mesh.textures[0]) == image).all() and (mesh.native.textures[0] == image[::-1]).all()


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
        (lambda: o3d.geometry.PointCloud().vertices, AttributeError, "cloud.points"),
        (lambda: setattr(o3d.geometry.PointCloud(), "color", 1), AttributeError, "color"),
        (lambda: setattr(o3d.geometry.PointCloud(), "points", [[0, 0, 0]]), TypeError, "Vector3dVector"),
        (lambda: V(np.zeros((3, 4))), ValueError, "array.T"),
        (lambda: o3d.utility.IntVector([0.5]), TypeError, "expected integers"),
        (lambda: o3d.geometry.PointCloud() + loom, TypeError, "expected a PointCloud, got module"),
        (lambda: o3d.geometry.PointCloud().estimate_normals(0.1), TypeError, "KDTreeSearchParamHybrid"),
        (lambda: o3d.geometry.KDTreeFlann(o3d.geometry.PointCloud()), ValueError, "got none"),
        (lambda: o3d.geometry.KDTreeFlann(np.zeros(3)), TypeError, "data: expected"),
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
    points = np.asarray(cloud.points)
    expected = np.linalg.norm(points[:, None] - np.eye(3), axis=2).min(axis=1)
    np.testing.assert_allclose(cloud.compute_point_cloud_distance(loom.PointCloud(np.eye(3))), expected, atol=1e-6)
    np.testing.assert_array_equal(o3d.geometry.PointCloud(loom.PointCloud(np.eye(3))).points, np.eye(3))
    box, large = o3d.geometry.TriangleMesh.create_box(), loom.TriangleMesh.create_box(2, 3, 4)
    both = box + large
    np.testing.assert_array_equal(both.vertices, np.concatenate([np.asarray(box.vertices), large.vertices]))
    np.testing.assert_array_equal(both.triangles, np.concatenate([np.asarray(box.triangles), large.triangles + 8]))


SHAPES = {"DoubleVector": (4,), "IntVector": (4,), "Vector2dVector": (4, 2), "Vector3dVector": (4, 3)}
SHAPES |= {"Vector2iVector": (4, 2), "Vector3iVector": (4, 3), "Vector4iVector": (4, 4)}
SHAPES |= {"Matrix3dVector": (4, 3, 3), "Matrix4dVector": (4, 4, 4)}
NUMPY = """v - a; a - v; v * np.float64(2); np.float64(2) / v; v < a.mean(); a[v > a.mean()]; v == a; a == v; v != a
np.max(v, axis=0); np.min(v); np.sum(v); np.abs(v); np.sqrt(v); np.isnan(v); np.any(v); np.all(v); np.add(v, 1)
np.power(v, 2); np.multiply(v, v); np.maximum.reduce(v); np.add.accumulate(v); np.cumsum(v); np.clip(v, 1, 2)
np.linalg.norm(v - a.mean(axis=0), axis=-1); np.quantile(v, 0.5); np.round(v, 1); np.where(v > np.mean(v), v, 0)
np.asarray(v, np.int64); np.array_equal(v, a); np.concatenate([v, v]); np.argsort(v, axis=0)
v >= a.min(axis=0); a.mean(axis=0) - v; a.mean(axis=0) > v; v ** np.float64(2); a % v; v // a; np.subtract.outer(v, v)
np.mean(v, axis=0); np.std(v); np.var(v); np.median(v); np.ptp(v, axis=0); np.prod(v, axis=0); np.argmax(v)
np.unique(v); np.ravel(v); np.sort(v, axis=0); np.diff(v, axis=0); np.shape(v); np.size(v); np.ndim(v); np.flip(v)
np.vstack([v, a]); np.stack([v, v]); np.append(v, v); np.delete(v, 0, axis=0); np.insert(v, 0, 1, axis=0); np.tile(v, 2)
np.repeat(v, 2, axis=0); np.roll(v, 1, axis=0); np.split(v, 2)[0]; np.take(v, [0, 2], axis=0); np.isin(v, [1, 2])
np.percentile(v, 30); np.average(v, axis=0); np.histogram(v)[0]; np.nonzero(v)[0]; np.allclose(v, a); np.isclose(v, a)
np.isfinite(v); np.nan_to_num(v); np.zeros_like(v); np.ones_like(v); np.full_like(v, 2); np.expand_dims(v, 0)
np.reshape(v, -1); np.transpose(v); np.moveaxis(v, 0, -1); np.einsum("i...->...", v); np.tensordot(v, v, axes=(0, 0))
np.dot(v, a.T); np.inner(v, v); np.count_nonzero(v); np.digitize(v, [1, 2]); np.interp(v, [0, 9], [0, 1]); np.sign(v)
np.maximum(v, a); np.hypot(v, v); np.logical_and(v, a); np.floor(v); np.exp(v); np.union1d(v, v); np.nansum(v)
np.array(v, np.float32); v == a.tolist(); np.pad(v, 1); np.broadcast_to(v, (2, *a.shape))"""
NUMPY = [call.strip() for call in NUMPY.replace("\n", ";").split(";")]

# Vectors compare as wholes with each other, and are no numbers in Python's own operators.
COMPARED = ["v == new(a)", "v != new(a + 1)", "not v == new(a[1:])", "v != None", "v[1:] == new(a[1:])", "not v == 2"]
REFUSED = ["v - v", "v + 1", "2 * v", "-v", "abs(v)", "v < v", "v < 2", "hash(v)", "v.shape", "v.sum()", "v @ v"]
REFUSED += ["np.add(v, 1, out=v)", "new(a.T[:, None])", "new(['a'])", "new(3)", "v[9]", "v['a']"]
MADE = ["list(a)", "tuple(a)", "(row for row in a)", "iter(a)", "map(list, a) if a.ndim > 1 else map(type(a[0]), a)"]
MADE += ["v", "dict.fromkeys(range(4), 0) and a", "a[::-1][::-1]", "np.asfortranarray(a)", "new(a)[:]"]


def behavior(o3d, kind):
    """True for each call that has the result of the vector's array, and for each that is rejected."""
    array = np.arange(1, 1 + np.prod(SHAPES[kind])).reshape(SHAPES[kind]) % 7 + 1
    array = array.astype(np.int32) if "iVector" in kind or kind == "IntVector" else array / 4
    new = getattr(o3d.utility, kind)
    names = {"np": np, "v": new(array), "a": np.asarray(new(array)), "new": new}
    found = [not is_refused(c, names) and equals(*(eval(c, names | {"v": names[v]}) for v in "va")) for c in NUMPY]
    found += [eval(call, names) for call in COMPARED] + [is_refused(call, names) for call in REFUSED]
    return np.array(found + [equals(np.asarray(new(eval(call, names))), array) for call in MADE], bool)


def equals(one, other):
    return np.array_equal(one, other) and type(one) is type(other)


def is_refused(call, names):
    try:
        eval(call, names)
    except (TypeError, ValueError, AttributeError, IndexError, RuntimeError):
        return True
    return False


@pytest.fixture(scope="module")
def of_open3d(oracle):
    return oracle("open3d/vectors", lambda o3d: {kind: behavior(o3d, kind) for kind in SHAPES})


@pytest.mark.parametrize("kind", SHAPES)
def test_vectors_behave_as_those_of_open3d(kind, of_open3d):
    stored, actual = of_open3d[kind], behavior(o3d, kind)
    calls = [*NUMPY, *COMPARED, *REFUSED, *MADE]
    assert [call for call, one, other in zip(calls, stored, actual, strict=True) if one != other] == []
    assert stored.sum() > 0.95 * len(stored)


def test_sets_and_dictionaries_become_vectors():
    assert list(o3d.utility.IntVector({3, 1})) == [1, 3]
    assert list(o3d.utility.IntVector({3: 0, 1: 0})) == [3, 1]
    numbers = o3d.utility.DoubleVector(x / 2 for x in range(3))
    numbers.extend(x for x in (5, 6))
    assert list(numbers) == [0, 0.5, 1, 5, 6]
    with pytest.raises(TypeError, match="Vector3dVector"):
        o3d.utility.Vector3dVector("abc")


@pytest.fixture
def colored(rng):
    made = o3d.geometry.PointCloud(V(rng.random((20, 3)).astype(np.float32)))
    made.normals = V(np.tile([0.0, 0.6, 0.8], (20, 1)))
    made.colors = V(rng.integers(0, 256, (20, 3)) / 255)
    return made


@pytest.mark.parametrize("is_text", [False, True])
@pytest.mark.parametrize("is_colored", [False, True])
def test_line_sets_are_read_as_written(rng, tmp_path, is_text, is_colored):
    lines = o3d.geometry.LineSet(V(rng.random((5, 3)).astype(np.float32)), o3d.utility.Vector2iVector([[0, 4], [2, 1]]))
    if is_colored:
        lines.colors = V([[1, 0, 0.2], [0, 1, 0.4]])
    assert o3d.io.write_line_set(tmp_path / "lines.ply", lines, write_ascii=is_text)
    again = o3d.io.read_line_set(tmp_path / "lines.ply")
    np.testing.assert_array_equal(again.points, lines.points)
    np.testing.assert_array_equal(again.lines, lines.lines)
    assert again.has_colors() == is_colored
    np.testing.assert_allclose(again.colors, lines.colors, atol=1e-7)


@pytest.mark.parametrize(
    ("rows", "where"),
    [
        ("0 0 nan\n1 0 0\n0 1", r"element vertex, row 0, property z\): expected finite"),
        *((f"0 0 0\n1 0 0\n0 {end}", r"element edge, row 0, property vertex2\): expected integers from 0 to 1")
          for end in ("2", "-1", "0.5", "nan")),
    ],
)  # fmt: skip
def test_wrong_values_of_a_line_set_are_named(tmp_path, rows, where):
    names = {"vertex 2": ("x", "y", "z"), "edge 1": ("vertex1", "vertex2")}
    head = [f"element {of}\n" + "".join(f"property double {p}\n" for p in each) for of, each in names.items()]
    (tmp_path / "lines.ply").write_text(f"ply\nformat ascii 1.0\n{''.join(head)}end_header\n{rows}\n")
    with pytest.raises(loom.FileError, match=rf"lines\.ply.*{where}"):
        o3d.io.read_line_set(tmp_path / "lines.ply")


@pytest.mark.parametrize(
    "data", [b"", b"\1\0\0\0", np.array([1, 2], "<i4").tobytes() + np.array([0, np.nan]).tobytes()]
)
def test_damaged_features_are_named(tmp_path, data):
    (tmp_path / "a.bin").write_bytes(data)
    with pytest.raises(loom.FileError, match=r"a\.bin.*expected"):
        o3d.io.read_feature(tmp_path / "a.bin")


@pytest.mark.parametrize(
    ("wrong", "where"),
    [({"extrinsic": [2.0] * 16}, "extrinsic"), ({"class_name": "PinholeCamera"}, "class_name"),
     ({"version_major": True}, "version_major")],
)  # fmt: skip
def test_wrong_values_of_camera_parameters_are_named(tmp_path, wrong, where):
    path, parameters = tmp_path / "camera.json", o3d.camera.PinholeCameraParameters()
    parameters.intrinsic = o3d.camera.PinholeCameraIntrinsic(64, 48, 50, 50, 31.5, 23.5)
    o3d.io.write_pinhole_camera_parameters(path, parameters)
    path.write_text(json.dumps(json.loads(path.read_text()) | wrong))
    with pytest.raises(loom.FileError, match=rf"camera\.json \(key {where}\)"):
        o3d.io.read_pinhole_camera_parameters(path)


def test_files_without_lines_are_reported(colored, tmp_path):
    o3d.io.write_point_cloud(tmp_path / "cloud.ply", colored)
    with pytest.raises(loom.FileError, match="edge"):
        o3d.io.read_line_set(tmp_path / "cloud.ply")
    with pytest.raises(ValueError, match="filename:"):
        o3d.io.read_line_set(tmp_path / "cloud.obj")
    with pytest.raises(TypeError, match="line_set:"):
        o3d.io.write_line_set(tmp_path / "lines.ply", colored)
