"""Operations of PointCloud: preserved attributes, unchanged operands, transforms, sums, equal bits in each run."""

import inspect
from contextlib import nullcontext

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.devices import check_same_device

from ..small_scenes import ON_CLOUDS, ON_HOST, SmallScenes, digest
from .any_cloud import examples
from .full_clouds import EXTRAS, UTM, assert_same, contents, full_cloud, rigid

LOST = "^clouds: the {} are dropped, because not all clouds have them$"
NORMALS_ALONE = ["estimate_normals", "orient to direction", "orient to camera", "orient alike", "normalize", "flip"]


def operations():
    box = loom.AxisAlignedBoundingBox([2, 2, 2], [8, 8, 8])
    oriented = loom.OrientedBoundingBox([5, 5, 5], np.eye(3), [6, 6, 6])
    T = np.diag([2.0, 2, 2, 1])
    return {
        "select_by_index": lambda c: c.select_by_index([3, 1, 1]),
        "select_by_index inverted": lambda c: c.select_by_index([3, 1], invert=True),
        "select_by_mask": lambda c: c.select_by_mask(np.arange(len(c)) % 2 == 0),
        "crop": lambda c: c.crop(box),
        "crop inverted": lambda c: c.crop(box, invert=True),
        "crop turned": lambda c: c.crop(oriented),
        "remove_non_finite_points": lambda c: c.remove_non_finite_points(),
        "voxel_down_sample": lambda c: c.voxel_down_sample(3.0),
        "transform": lambda c: c.transform(T),
        "estimate_normals": lambda c: c.estimate_normals(radius=4.0),
        "estimate_normals within": lambda c: c.estimate_normals(radius=4.0, max_nn=None),
        "orient to direction": lambda c: c.orient_normals_to_align_with_direction([1, 0, 0]),
        "orient to camera": lambda c: c.orient_normals_towards_camera_location([0, 0, 99]),
        "orient alike": lambda c: c.orient_normals_consistent_tangent_plane(8),
        "normalize": lambda c: c.normalize_normals(),
        "flip": lambda c: c.flip_normals(),
        "copy": lambda c: c.copy(),
    }


@pytest.mark.parametrize("name", operations())
def test_operations_keep_all_attributes_and_their_operand(device, name, rng):
    cloud = full_cloud(rng, device)
    before = contents(cloud)
    result = operations()[name](cloud)
    assert_same(contents(cloud), before)
    assert result is not cloud and set(contents(result)) == set(before)
    for attribute in EXTRAS:
        assert result[attribute].dtype == cloud[attribute].dtype and len(result[attribute]) == len(result) > 0
    after = contents(result)
    result.points, result.colors, result["ring"] = result.points + 1, np.zeros((len(result), 3)), np.ones(len(result))
    assert_same(contents(cloud), before), "what is assigned to the result does not reach the operand"
    again = operations()[name](cloud)
    assert_same(contents(again), after)


@pytest.mark.parametrize("name", ["transform", *NORMALS_ALONE, "copy"])
def test_an_operation_shares_the_arrays_that_it_did_not_change(device, name, rng):
    cloud = full_cloud(rng, device)
    cloud.grid = (20, 10)
    result = operations()[name](cloud)
    changed = {"copy": (), "transform": ("points", "normals")}.get(name, ("normals",))
    assert result.grid == (20, 10)
    for array in ("points", "normals", "colors", *EXTRAS):
        assert (result.arrays[array] is cloud.arrays[array]) == (array not in changed), array


@pytest.mark.parametrize(
    "name", ["select_by_index", "select_by_mask", "crop", "crop inverted", "crop turned", "remove_non_finite_points"]
)
def test_each_selected_point_keeps_its_own_attributes(device, name, rng):
    cloud = full_cloud(rng, device)
    cloud["row"] = np.arange(len(cloud))
    result = operations()[name](cloud)
    rows = result["row"]
    for array in ("points", "normals", "colors", *EXTRAS):
        np.testing.assert_array_equal(result[array], cloud[array][rows])


def claim_another_device(cloud, monkeypatch):
    device_of = property(lambda c: "cuda:7" if c is cloud else c.arrays["points"].device)
    monkeypatch.setattr(loom.PointCloud, "device", device_of)


def test_a_cloud_moved_to_another_device_and_back_is_the_same(device, rng, monkeypatch):
    """Without a GPU the cloud only claims another device: everything except the copy itself is tested."""
    cloud = full_cloud(rng, device, shift=UTM)
    cloud.grid = (20, 10)
    assert cloud.to(cloud.device) is cloud
    if not cloud.device.is_cuda:
        claim_another_device(cloud, monkeypatch)
    there = cloud.to("cpu")
    assert str(there.device) == "cpu" and there is not cloud
    assert_same(contents(there), contents(cloud))
    assert_same(contents(there.to(device)), contents(cloud))


def test_operands_on_two_devices_are_an_error(rng, monkeypatch):
    """A stand-in for a second device tests the rule without a GPU."""
    cloud, other = loom.PointCloud(rng.random((9, 3))), loom.PointCloud(rng.random((9, 3)))
    search = loom.NearestNeighborSearch(cloud)
    claim_another_device(other, monkeypatch)
    for call in (lambda: search.knn_search(other, 1), lambda: search.radius_search(other, 1.0)):
        with pytest.raises(loom.DeviceError, match="queries:"):
            call()
    with pytest.raises(loom.DeviceError, match="left:"):
        check_same_device("left", "a", "b")


@pytest.mark.parametrize("scale", [1.0, 0.001, 250.0])
def test_transform_agrees_with_numpy_in_float64(device, scale, rng, tolerances):
    cloud, T = full_cloud(rng, device), rigid(rng)
    T[:3, :3] *= scale
    result = cloud.transform(T)
    expected = cloud.points @ T[:3, :3].T + T[:3, 3]
    size = np.abs(expected - result.origin).max()
    np.testing.assert_allclose(result.points, expected, rtol=0, atol=tolerances.transform_relative * size)
    rotated = cloud.normals.astype(float) @ (T[:3, :3] / scale).T
    np.testing.assert_allclose(result.normals, rotated, rtol=0, atol=tolerances.unit_length)


def test_normals_stay_normal_to_a_sheared_plane(device, rng, tolerances):
    A = np.array([[1, 2, 0], [0, 1, 0.5], [0.3, 0, -2]])
    n = np.array([0.6, 0, 0.8])
    u, v = np.array([0, 1, 0.0]), np.array([0.8, 0, -0.6])
    T = np.eye(4)
    T[:3, :3] = A
    transformed = loom.PointCloud(np.zeros((1, 3)), normals=n[None], device=device).transform(T).normals[0]
    for across in (u, v):
        assert abs(transformed @ (A @ across)) < 4 * tolerances.unit_length
    np.testing.assert_allclose(np.linalg.norm(transformed), 1, rtol=tolerances.unit_length)


TILES = np.array([[5e5, 5.4e6, 300], [500_600, 5_400_250, 280], [499_000, 5_401_000, 310]])
NONE, NORMALS, COLORS, BOTH = (), ("normals",), ("colors",), ("normals", "colors")
SUMS = [(left, right, (3, 2)) for left in (NONE, NORMALS, BOTH) for right in (NONE, COLORS, BOTH)]
SUMS += [(BOTH, right, counts) for right in (NONE, COLORS) for counts in ((0, 2), (3, 0))]
SUMS += [(NONE, BOTH, (0, 2)), (NORMALS, NONE, (3, 0))]


def open3d_has(o3d):
    results = []
    for left, right, counts in SUMS:
        clouds = []
        for names, count in zip((left, right), counts, strict=True):
            cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.zeros((count, 3))))
            for name in names:
                setattr(cloud, name, o3d.utility.Vector3dVector(np.ones((count, 3))))
            clouds.append(cloud)
        total = clouds[0] + clouds[1]
        results.append((total.has_normals(), total.has_colors()))
    return results


def test_normals_and_colors_survive_addition_as_in_open3d(device, rng, oracle):
    for (left, right, counts), expected in zip(SUMS, oracle("pcd/composition/kept", open3d_has), strict=True):
        clouds = [
            loom.PointCloud(rng.random((count, 3)), device=device, **{name: rng.random((count, 3)) for name in names})
            for names, count in zip((left, right), counts, strict=True)
        ]
        lacks = all(counts) and ("colors" in left) != ("colors" in right)  # normals are estimated again
        with pytest.warns(UserWarning, match="dropped, because") if lacks else nullcontext():
            result = clouds[0] + clouds[1]
        assert (result.has_normals, result.has_colors) == expected, (left, right, counts)
        np.testing.assert_array_equal(result.points, np.concatenate([cloud.points for cloud in clouds]))


def test_common_attributes_keep_their_type(device, rng):
    dtypes = ("i1", "u1", "i2", "u4", "i8", "u8", "f2", "f4", "f8", "?")
    clouds = []
    for count in (5, 1, 12):
        attributes = {f"a{dtype.replace('?', 'b')}": rng.integers(0, 2, count).astype(dtype) for dtype in dtypes}
        attributes["wide"] = rng.integers(0, 9, (count, 3)).astype(np.int16)
        attributes[f"own{count}"] = np.ones(count)
        clouds.append(loom.PointCloud(rng.random((count, 3)), device=device, **attributes))
    with pytest.warns(UserWarning, match=LOST.format("own5, own1 and own12")):
        result = loom.PointCloud.concatenate(iter(clouds))
    shared = set(clouds[0].attributes) - {"own5"}
    assert set(result.attributes) == shared and len(shared) == 11
    for name in shared:
        assert result[name].dtype == clouds[0][name].dtype
        np.testing.assert_array_equal(result[name], np.concatenate([cloud[name] for cloud in clouds]))


def test_clouds_about_several_origins_are_brought_to_that_of_the_largest(device, rng, tolerances):
    shifted = [rng.random((n, 3)) * 200 + tile for n, tile in zip((5, 90, 40), TILES, strict=True)]
    clouds = [loom.PointCloud(points, device=device) for points in shifted]
    assert len({tuple(cloud.origin) for cloud in clouds}) == 3
    result = loom.PointCloud.concatenate(clouds)
    assert result.origin.tolist() == clouds[1].origin.tolist()
    expected = np.concatenate([cloud.points for cloud in clouds])
    limit = tolerances.float32_relative * np.abs(expected - result.origin).max()
    np.testing.assert_allclose(result.points, expected, rtol=0, atol=limit)
    assert limit < tolerances.position
    np.testing.assert_array_equal(result.points[5:95], clouds[1].points), "those of the largest keep their bits"


def test_adding_an_empty_cloud_keeps_the_origin(device, rng):
    cloud = loom.PointCloud(rng.random((9, 3)) + TILES[0], device=device, row=np.arange(9))
    for result in (loom.PointCloud(device=device) + cloud, cloud + loom.PointCloud(device=device), sum([cloud])):
        np.testing.assert_array_equal(result.points, cloud.points)
        assert (result.origin == cloud.origin).all() and result["row"].tolist() == list(range(9))
    nothing = loom.PointCloud(device=device) + loom.PointCloud([], device=device, ring=np.zeros(0, np.int32))
    assert len(nothing) == 0


parts = st.lists(st.tuples(st.integers(0, 5), st.sampled_from([0.0, 3e4, 5e5, -7e6])), min_size=1, max_size=5)


@examples(25)
@given(parts=parts, seed=st.integers(0, 99))
def test_concatenation_agrees_with_numpy(device, parts, seed):
    rng = np.random.default_rng(seed)
    positions = [rng.integers(-99, 99, (n, 3)) + shift for n, shift in parts]
    clouds = [loom.PointCloud(points, device=device, row=np.arange(len(points))) for points in positions]
    for result in (loom.PointCloud.concatenate(clouds), sum(clouds)):
        np.testing.assert_array_equal(result.points, np.concatenate([c.points for c in clouds])), "whole numbers: exact"
        np.testing.assert_array_equal(result["row"], np.concatenate([c["row"] for c in clouds]))


def test_addition_creates_a_new_cloud_and_keeps_its_operands(device, rng):
    cloud = loom.PointCloud(rng.random((4, 3)), device=device)
    before, original = cloud.points, cloud
    cloud += original
    assert len(cloud) == 8 and len(original) == 4
    cloud["points"] = np.zeros((8, 3))
    np.testing.assert_array_equal(original.points, before)


def test_attributes_of_two_types_or_widths_are_refused():
    a, b, c = (loom.PointCloud([[0, 0, 0]], label=np.array(x)) for x in (np.int32([1]), np.int64([1]), [[1, 2]]))
    with pytest.raises(TypeError, match="label:"):
        a + b
    with pytest.raises(ValueError, match="label:"):
        b + c


def test_painted_cloud_has_one_color_and_its_other_attributes(device, rng):
    cloud = loom.PointCloud(rng.random((7, 3)), colors=rng.random((7, 3)), row=np.arange(7), device=device)
    cloud.grid = (7, 1)
    result = cloud.paint_uniform_color([0.1, 1, 0])
    np.testing.assert_array_equal(result.colors, np.tile(np.float32([0.1, 1, 0]), (7, 1)))
    assert result.arrays["points"] is cloud.arrays["points"] and result.grid == (7, 1)
    assert result["row"].tolist() == [*range(7)]
    assert (cloud.colors != result.colors).any()
    assert loom.PointCloud(device=device).paint_uniform_color((0, 0, 0)).colors.shape == (0, 3)


COUNT = 6_007  # points: above the thresholds of the filters of hulls and visible points
ELSEWHERE = ("alpha", "detail", "from_point_cloud", "splats", "write")  # tested in other folders, or host code
OPERATIONS = [name for name in ON_CLOUDS if not name.startswith((*ON_HOST, *ELSEWHERE))]
OPERATIONS = OPERATIONS[: OPERATIONS.index("icp, point to point")]


@pytest.fixture(scope="module")
def scenes():
    """A function (device) -> two equal scenes, so that search trees are built twice."""
    made = {}
    return lambda device: made.setdefault(device, [SmallScenes(device).sample(COUNT, 10) for _ in range(2)])


@pytest.mark.parametrize("name", OPERATIONS)
def test_two_runs_are_bitwise_identical(device, name, scenes):
    first, second = (digest(ON_CLOUDS[name](scene)) for scene in scenes(device))
    assert first == second


SURVEY = [9.5, 50.0, 0.0]  # degrees
SCREW = rigid(np.random.default_rng(3))
MOVED = {
    "smooth_mls": lambda c: c.smooth_mls(radius=None, max_nn=12),
    "smooth_bilateral": lambda c: c.smooth_bilateral(radius=4.0),
    "smooth_laplacian": lambda c: c.smooth_laplacian(2),
    "smooth_laplacian, fixed": lambda c: c.smooth_laplacian(2, use_fixed_neighborhoods=True),
    "smooth_taubin": lambda c: c.smooth_taubin(2),
    "deskew_point_cloud": lambda c: loom.registration.deskew_point_cloud(c, SCREW),
}
SHARED = {
    "copy": lambda c: c.copy(),
    "crop": lambda c: c.crop(loom.OrientedBoundingBox(c.get_center(), np.eye(3), [99, 99, 99])),
    "estimate_covariances": lambda c: c.estimate_covariances(),
    "estimate_normals": lambda c: c.estimate_normals(),
    "farthest_point_down_sample": lambda c: c.farthest_point_down_sample(50),
    "flip_normals": lambda c: c.flip_normals(),
    "normalize_normals": lambda c: c.normalize_normals(),
    "paint_uniform_color": lambda c: c.paint_uniform_color([1, 0, 0]),
    "random_down_sample": lambda c: c.random_down_sample(0.5),
    "remove_duplicated_points": lambda c: c.remove_duplicated_points(),
    "remove_non_finite_points": lambda c: c.remove_non_finite_points(),
    "remove_radius_outlier": lambda c: c.remove_radius_outlier(2, 3.0)[0],
    "remove_statistical_outlier": lambda c: c.remove_statistical_outlier(9, 1.0)[0],
    "select_by_index": lambda c: c.select_by_index([3, 1, 1]),
    "select_by_mask": lambda c: c.select_by_mask(np.arange(len(c)) % 2 == 0),
    "uniform_down_sample": lambda c: c.uniform_down_sample(3),
    "to": lambda c: c.to("cpu", arrays="warp"),
    "translate": lambda c: c.translate([1, 2, 3]),
    "scale": lambda c: c.scale(2.0),
    "rotate": lambda c: c.rotate(SCREW[:3, :3]),
    "transform": lambda c: c.transform(SCREW),
    "slice": lambda c: c[::3],
    "concatenate": lambda c: c + c,
}
# Results that depend on axes, on coordinates or on a direction, and are tested for their arrays alone.
OF_AXES = {
    "orient_normals_consistent_tangent_plane": lambda c: c.orient_normals_consistent_tangent_plane(8),
    "orient_normals_to_align_with_direction": lambda c: c.orient_normals_to_align_with_direction(),
    "orient_normals_towards_camera_location": lambda c: c.orient_normals_towards_camera_location(),
    "thin": lambda c: c.thin(2.0),
    "to_unit": lambda c: c.to_unit("foot"),
    "voxel_down_sample": lambda c: c.voxel_down_sample(2.0),
    "voxel_down_sample_and_trace": lambda c: c.voxel_down_sample_and_trace(2.0).cloud,
}
OTHER_RESULTS = {"clear", "reproject", "without"}  # empty, refuses covariances, without named arrays


def complete(rng, device):
    """A cloud with every kind of array, a time for each point, and covariances as float64."""
    cloud = full_cloud(rng, device).estimate_covariances()
    cloud["covariances"], cloud.unit = cloud.covariances.reshape(-1, 9).astype(float), "metre"
    return cloud


def test_the_tables_have_all_methods_that_return_a_cloud():
    kinds = {name: inspect.unwrap(f) for name, f in inspect.getmembers(loom.PointCloud, inspect.isfunction)}
    found = {name for name, f in kinds.items() if "Self" in str(f.__annotations__.get("return"))}
    public = {name for name in found if name[0] != "_" and name in dir(loom.PointCloud)}
    assert public <= {*MOVED, *SHARED, *OF_AXES, *OTHER_RESULTS}


@pytest.mark.parametrize("name", [*MOVED, *SHARED, *OF_AXES])
def test_a_result_has_covariances_unless_its_points_moved_relative_to_each_other(device, name, rng):
    cloud = complete(rng, device)
    result = (MOVED | SHARED | OF_AXES)[name](cloud)
    assert set(result.arrays) == set(cloud.arrays) - ({"covariances"} if name in MOVED else set())


@pytest.mark.parametrize("name", [*MOVED, *SHARED])
def test_normals_and_covariances_rotate_with_the_points(device, name, rng):
    """The result of a rotated cloud is the rotated result, in every array."""
    cloud, operation = complete(rng, device), (MOVED | SHARED)[name]
    motion = np.eye(4)
    motion[:3, :3] = rigid(rng)[:3, :3]
    if name in ("translate", "rotate", "transform", "deskew_point_cloud"):
        motion[:3, :3] = Rotation.from_rotvec(0.7 * np.array(rotation_axis(SCREW))).as_matrix()  # commutes with it
    plain, result, R = operation(cloud), operation(cloud.transform(motion)), motion[:3, :3]
    expected, signs = plain.normals @ R.T, 1.0
    if name.startswith(("estimate_normals", "smooth_mls")):  # planes fitted to rounded points, of either side
        signs = np.sign((result.normals * expected).sum(axis=1, keepdims=True))
    np.testing.assert_allclose(result.normals * signs, expected, rtol=0, atol=1e-3)
    if "covariances" in plain:
        expected = R @ plain.covariances @ R.T
        np.testing.assert_allclose(result.covariances, expected, rtol=0, atol=1e-5 * abs(expected).max())


def rotation_axis(T):
    return Rotation.from_matrix(T[:3, :3]).as_rotvec() / np.linalg.norm(Rotation.from_matrix(T[:3, :3]).as_rotvec())


@pytest.mark.parametrize("name", ["attribute", "item"])
def test_assigned_points_have_no_covariances_of_the_old_ones(device, name, rng):
    cloud = complete(rng, device)
    other = cloud.copy()
    if name == "item":
        other["points"] = cloud.points[::-1]
    else:
        other.points = cloud.points[::-1]
    assert "covariances" in cloud and set(other.arrays) == set(cloud.arrays) - {"covariances"}
    with pytest.raises(ValueError, match="covariances"):
        _ = other.covariances


def test_projected_points_have_no_covariances_in_degrees(device, rng):
    cloud = loom.PointCloud(SURVEY + rng.random((99, 3)) * 1e-3, crs=4326, device=device).estimate_covariances()
    assert "covariances" not in loom.project_to_utm(cloud)
    with pytest.raises(ValueError, match="covariances cannot be reprojected"):
        cloud.reproject(32632)


def test_generalized_icp_ignores_the_covariances_of_the_points_before_smoothing(device, rng):
    """A rough surface that was smoothed has the covariances of the smooth one."""
    x, y = rng.random((2, 900)) * 4
    rough = loom.PointCloud(np.column_stack([x, y, 0.2 * np.sin(3 * x) + 0.02 * rng.normal(size=900)]), device=device)
    smooth = [cloud.smooth_mls(radius=0.4, max_nn=40) for cloud in (rough, rough.estimate_covariances(max_nn=20))]
    register, step = loom.registration.registration_icp, loom.registration.TransformationEstimationForGeneralizedICP()
    poses = [register(one.translate([0.02, 0.01, 0.01]), one, 0.3, np.eye(4), step).transformation for one in smooth]
    np.testing.assert_array_equal(poses[0], poses[1])


JOINS = [lambda a, b: a + b, lambda a, b: b + a, lambda a, b: loom.PointCloud.concatenate([a, b])]


@pytest.mark.parametrize("join", JOINS)
def test_a_sum_names_the_arrays_that_some_clouds_lack(device, join, rng):
    first, second = full_cloud(rng, device, 5), full_cloud(rng, device, 6)
    del first.normals, second.attributes["ring"]
    with pytest.warns(UserWarning, match=LOST.format("ring")) as caught:  # normals can be estimated again
        total = join(first, second)
    assert len(caught) == 1 and set(total.arrays) == set(first.arrays) & set(second.arrays)
    with pytest.warns(UserWarning, match=LOST.format("ring and time")):
        _ = loom.PointCloud.concatenate([first, second.without("time"), second])


def test_a_sum_of_equal_arrays_or_with_an_empty_cloud_is_quiet(device, rng):
    cloud = full_cloud(rng, device, 5)
    assert set((cloud + loom.PointCloud(device=device) + cloud).arrays) == set(cloud.arrays)
