"""Checks of user input: each limit, masked arrays, and damaged pickles."""

import numpy as np
import pytest
from numpy.lib.recfunctions import structured_to_unstructured

import pointloom as loom
from pointloom.core.checks import check_count, check_positive, check_rigid, check_rows, check_seed, check_transformation
from pointloom.open3d.utility import Vector3dVector


@pytest.mark.parametrize("value", [True, False, np.True_, np.False_, 2.0, "2", None, np.float64(3)])
def test_counts_are_integers_and_not_booleans(value):
    with pytest.raises(TypeError, match=r"^max_nn:"):
        check_count("max_nn", value, minimum=0)


def test_a_count_may_equal_its_minimum():
    assert check_count("n", 1) == 1 and check_count("n", np.int64(7), minimum=7) == 7
    for value, minimum in ((0, 1), (6, 7), (-1, 0)):
        with pytest.raises(ValueError, match=f"^n: expected an integer >= {minimum}, got {value}"):
            check_count("n", value, minimum=minimum)


def test_a_length_may_be_zero_only_where_that_is_allowed():
    assert check_positive("size", 0, allow_zero=True) == 0 and check_positive("size", 5e-324) > 0
    for value in (0, -1e-300, np.nan, np.inf, -np.inf):
        with pytest.raises(ValueError, match=r"^size:"):
            check_positive("size", value)


def test_a_seed_is_below_two_to_the_31st():
    assert check_seed(2**31 - 1) == 2**31 - 1 and check_seed(0) == 0
    for value in (2**31, -1):
        with pytest.raises(ValueError, match=r"^seed:"):
            check_seed(value)


def test_a_pose_may_be_rounded_but_no_mirror_and_no_scale():
    rounded, skew = np.eye(4), np.eye(4)
    rounded[0, 0], skew[0, 1] = 1.009, 0.019  # R R^T is off by 0.018 and 0.019
    assert check_rigid("T", rounded) is not None and check_rigid("T", skew) is not None
    scaled, mirrored, projective, sheared = np.eye(4), np.diag([1.0, 1, -1, 1]), np.eye(4), np.eye(4)
    scaled[0, 0], projective[3, 0], sheared[0, 1] = 1.011, 1e-3, 0.021  # ... by 0.022 and 0.021
    for wrong in (scaled, mirrored, projective, sheared):
        with pytest.raises(ValueError, match=r"^T:"):
            check_rigid("T", wrong)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e200, -0.5])
def test_a_pose_with_one_invalid_number_is_rejected(bad):
    for row, column in np.ndindex(4, 4):
        wrong = np.eye(4)
        wrong[row, column] = bad
        if abs(bad) == 0.5 and column == 3 and row < 3:
            continue  # a translation
        with pytest.raises(ValueError, match=r"^T:"):
            check_rigid("T", wrong)


@pytest.mark.parametrize("scale", [1e-107, 1e-95, 1e-5, 1.0, 1e90])
@pytest.mark.parametrize("smallest", [0.0, 1e-17, 1e-14, 1e-3])
def test_a_transformation_is_invertible_as_by_the_rank_of_numpy(scale, smallest, rng):
    Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
    T = np.eye(4)
    T[:3, :3] = scale * Q @ np.diag([1, 0.5, smallest]) @ Q.T
    if np.linalg.matrix_rank(T[:3, :3]) == 3:
        assert check_transformation("T", T) is T
    else:
        with pytest.raises(ValueError, match=r"^T: expected an invertible matrix"):
            check_transformation("T", T)


@pytest.mark.parametrize("number", [np.nan, np.inf, 1.1e100])
def test_a_transformation_with_one_invalid_number_is_rejected(number):
    for entry in np.ndindex(3, 4):
        T = np.eye(4)
        T[entry] = number
        with pytest.raises(ValueError, match=r"^T: expected"):
            check_transformation("T", T)


def test_rows_have_the_requested_width_and_count():
    assert check_rows("p", [], 3).shape == (0, 3)
    for values, rows in (([[1, 2]], None), ([1, 2, 3], None), ([[1, 2, 3]], 2)):
        with pytest.raises(ValueError, match=r"^p:"):
            check_rows("p", values, 3, rows=rows)


def test_a_number_beyond_float32_is_refused_and_infinity_is_not():
    assert np.isinf(check_rows("p", [[np.inf, 0, 0]], 3, dtype=np.float32)[0, 0])
    with pytest.raises(ValueError, match=r"^p:"):
        check_rows("p", [[1e39, 0, 0]], 3, dtype=np.float32)


CAMERA = loom.PinholeCameraIntrinsic(4, 3, 5.0, 5.0, 1.5, 1.0)


def masked(shape, dtype=float, row=1, value=100):
    array = np.ma.masked_array(np.full(shape, 1, dtype), mask=False)
    array[row] = np.ma.masked
    array.data[row] = value
    return array


@pytest.mark.parametrize("kind", [np.ma.asarray, list], ids=["array", "list of rows"])
def test_masked_floats_are_nan_and_arrays_with_an_empty_mask_are_plain(kind):
    points = masked((5, 3))
    cloud = loom.PointCloud(kind(points), normals=kind(points), weight=masked(5))
    for values in (cloud.points, cloud.normals):
        np.testing.assert_array_equal(values, np.ma.filled(points, np.nan))
    np.testing.assert_array_equal(np.isnan(cloud["weight"]), masked(5).mask)
    assert cloud.get_max_bound().max() == 1
    np.testing.assert_array_equal(Vector3dVector(points), np.ma.filled(points, np.nan))
    unmasked = np.ma.masked_array(np.arange(9).reshape(3, 3), mask=False)
    np.testing.assert_array_equal(loom.PointCloud(unmasked).points, unmasked.data)


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("points", lambda: loom.PointCloud(masked((5, 3), int))),
        ("colors", lambda: loom.PointCloud(np.zeros((5, 3)), colors=masked((5, 3), np.uint8))),
        ("colors", lambda: loom.PointCloud(np.zeros((5, 3)), colors=masked((5, 3)))),
        ("ring", lambda: loom.PointCloud(np.zeros((5, 3)), ring=masked(5, int))),
        ("triangles", lambda: loom.TriangleMesh(np.eye(3), masked((2, 3), int))),
        ("color", lambda: loom.RGBDImage(masked((3, 4, 3), np.uint8), np.ones((3, 4)))),
        ("extrinsic", lambda: loom.PointCloud.create_from_depth_image(np.ones((3, 4)), CAMERA, masked((4, 4)))),
    ],
)
def test_masked_entries_without_a_missing_value_are_refused(name, call):
    with pytest.raises(ValueError, match=rf"^{name}: "):
        call()


@pytest.mark.parametrize("dtype", [np.uint16, np.float32])
def test_masked_depth_is_no_measurement(dtype):
    depth = masked((3, 4), dtype)
    for scale in (None, 1.0):
        assert len(loom.PointCloud.create_from_depth_image(depth, CAMERA, depth_scale=scale)) == 8
    volume = loom.TSDFVolume(voxel_size=0.1)
    volume.integrate(depth, CAMERA, np.eye(4), depth_scale=1.0, depth_max=1000.0)
    assert volume.extract_point_cloud(weight_threshold=0).get_max_bound()[2] < 2
    assert loom.filter_depth_bilateral(depth, depth_scale=1.0).max() == pytest.approx(1)


def mesh():
    made = loom.TriangleMesh.create_box().compute_vertex_normals()
    made.triangle_uvs, made.triangle_material_ids = np.zeros((36, 2)), np.zeros(12, int)
    made.vertex_attributes["heat"] = np.arange(8.0)
    return made


def cloud():
    made = loom.PointCloud(np.eye(3), normals=np.eye(3), ring=np.arange(3))
    made.grid = 1, 3
    return made


def image():
    return loom.RGBDImage(np.zeros((4, 6, 3), np.uint8), np.ones((4, 6), np.float32))


def volume():
    made = loom.TSDFVolume(voxel_size=0.1, color=False)
    made.integrate(np.ones((4, 6), np.float32), loom.PinholeCameraIntrinsic(6, 4, 6.0, 6.0, 2.5, 1.5), np.eye(4))
    return made


def grid():
    made = loom.OccupancyGrid(0.1)
    made.insert_scan(np.eye(3), [0, 0, 0])
    return made


def field():
    return loom.DistanceField.from_point_cloud(loom.PointCloud(np.eye(3)), 0.1, 1)


def scene():
    made = loom.RaycastingScene()
    made.add_triangles(loom.TriangleMesh.create_box())
    return made


def put(*keys_and_value):
    """A change of a state: the value under these keys, deleted where it is None."""
    *keys, last, value = keys_and_value

    def change(state):
        for key in keys:
            state[key] = dict(state[key])
            state = state[key]
        if value is None:
            del state[last]
        else:
            state[last] = value

    return change


def vectors(values, kind="vec3"):
    return np.array(values, "i4" if kind == "vec3i" else "f4"), kind


@pytest.mark.parametrize(
    ("make", "change"),
    [
        (mesh, put("arrays", None)),
        (mesh, put("arrays", "triangles", vectors([[0, 1, 8]] * 12, "vec3i"))),
        (mesh, put("arrays", "triangles", vectors([[0, 1, -1]] * 12, "vec3i"))),
        (mesh, put("arrays", "vertices", vectors(np.zeros((7, 3))))),
        (mesh, put("arrays", "vertices", (np.zeros((8, 3)), "vec3"))),
        (mesh, put("arrays", "vertices", (np.zeros((12, 2), "f4"), "vec3"))),
        (mesh, put("arrays", "vertex_normals", vectors(np.zeros((7, 3))))),
        (mesh, put("arrays", "vertex_normals", (np.array([None] * 8), ""))),
        (mesh, put("arrays", "triangle_uvs", vectors(np.zeros((35, 2)), "vec2"))),
        (mesh, put("arrays", "triangle_material_ids", (np.full(12, -1, "i4"), ""))),
        (mesh, put("arrays", "unknown", vectors(np.zeros((8, 3))))),
        (mesh, put("attributes", "vertex_attributes", {"heat": (np.zeros(7), "")})),
        (mesh, put("textures", (np.zeros((2, 2), np.uint8),))),
        (mesh, put("origin", np.full(3, np.nan))),
        (mesh, put("library", "other")),
        (cloud, put("arrays", "points", vectors(np.zeros((2, 3))))),
        (cloud, put("arrays", "points", (np.zeros(3), ""))),
        (cloud, put("arrays", "normals", vectors(np.zeros((4, 3))))),
        (cloud, put("arrays", "ring", "text")),
        (cloud, put("grid", (3, 3))),
        (cloud, put("origin", [np.inf, 0, 0])),
        (image, put("height", 400)),
        (image, put("arrays", "depth_array", (np.ones(23, "f4"), ""))),
        (image, put("arrays", "color_array", (np.ones((24, 4), "u1"), ""))),
        (volume, put("arrays", "keys", np.zeros(1, np.int64))),
        (volume, put("arrays", "sizes", np.array([1e300, 1e300]))),
        (volume, put("arrays", "distances", None)),
        (grid, put("arrays", "odds", np.zeros(512, np.float32))),
        (grid, put("arrays", "voxel_size", np.array(5e-324))),
        (field, put("arrays", "voxels", np.zeros((2, 3), np.int32))),
        (field, put("arrays", "sizes", np.zeros(3))),
        (scene, put("mesh_of", [1])),
        (scene, put("mesh_of", [-1])),
        (scene, put("poses", [])),
        (scene, put("poses", [np.full((4, 4), np.nan)])),
        (scene, put("meshes", [3])),
    ],
)
def test_a_damaged_state_is_refused(make, change):
    kind, state = type(make()), make().__getstate__()
    kind.__new__(kind).__setstate__(state)  # as it is, it is taken
    change(state)
    with pytest.raises(ValueError, match="the pickle is damaged or of another version"):
        kind.__new__(kind).__setstate__(state)


def test_a_search_of_something_else_than_a_cloud_is_refused():
    kind = loom.NearestNeighborSearch
    with pytest.raises(TypeError, match="cloud"):
        kind.__new__(kind).__setstate__(np.eye(3))


@pytest.mark.parametrize(
    ("make", "names"),
    [
        (image, ["color_array", "depth_array", "height", "width", "device"]),
        (volume, ["device", "has_color", "voxel_size", "truncation"]),
        (grid, ["device", "voxel_size"]),
        (field, ["device", "voxel_size", "max_distance", "shape", "origin", "is_signed"]),
    ],
)
def test_attributes_that_arrays_depend_on_cannot_be_assigned(make, names):
    made = make()
    for name in names:
        with pytest.raises(AttributeError, match=name):
            setattr(made, name, getattr(made, name))


def test_a_transformation_without_its_last_row_is_answered_by_the_row():
    for shape in (loom.PointCloud(np.eye(3)), loom.TriangleMesh.create_box()):
        with pytest.raises(ValueError, match=r"transformation: .* got \[3, 4\]; append the row \[0, 0, 0, 1\]"):
            shape.transform(np.eye(4)[:3])


def test_a_structured_array_is_answered_by_its_conversion():
    rows = np.ones(2, [("x", "f4"), ("y", "f4"), ("z", "f4"), ("id", "i4")])
    with pytest.raises(TypeError, match=r"points: .* fields x, y, z, id; pass .*structured_to_unstructured\(points"):
        loom.PointCloud(rows)
    points = structured_to_unstructured(rows[["x", "y", "z"]])
    assert loom.PointCloud(points).points.tolist() == [[1, 1, 1]] * 2


@pytest.mark.parametrize("value", [1 + 2j, np.complex128(1), np.complex64(1 + 2j), np.array(1 + 2j)])
def test_complex_numbers_are_not_real_numbers(value):
    with pytest.raises(TypeError, match="params: expected a"):
        loom.CameraModel("PINHOLE", 64, 48, [value, 5, 32, 24])
