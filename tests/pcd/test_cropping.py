"""Selection by index, mask, box and polygon, and removal of duplicates and non-finite points."""

import json
import tempfile
from pathlib import Path

import numpy as np
import pytest
import warp as wp
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import pointloom as loom

from .any_cloud import INTEGERS, NOT_FINITE, clouds, examples, parts, real
from .full_clouds import UTM, full_cloud
from .open3d_clouds import cloud_of


def test_indices_select_in_their_order_with_repeats_and_count_from_the_end(device, rng):
    cloud = full_cloud(rng, device)
    indices = [7, -1, 7, 0, -200, 199]
    np.testing.assert_array_equal(cloud.select_by_index(indices).points, cloud.points[indices])
    for dtype in ("i1", "i8", "u1", "u8"):
        few = np.array([7, 99, 7, 0] if dtype[0] == "u" else [7, -1, 7, -9]).astype(dtype)
        np.testing.assert_array_equal(cloud.select_by_index(few)["label"], cloud["label"][few])
        rest = np.delete(np.arange(200), few.astype(int))
        np.testing.assert_array_equal(cloud.select_by_index(few, invert=True)["label"], cloud["label"][rest])
    left = np.setdiff1d(np.arange(200), np.array(indices) % 200)
    np.testing.assert_array_equal(cloud.select_by_index(indices, invert=True).points, cloud.points[left])
    assert len(cloud.select_by_index([])) == 0 and len(cloud.select_by_index([], invert=True)) == 200


def test_mask_selects_its_true_points(device, rng):
    cloud = full_cloud(rng, device)
    mask = rng.random(200) < 0.4
    np.testing.assert_array_equal(cloud.select_by_mask(mask).points, cloud.points[mask])
    np.testing.assert_array_equal(cloud.select_by_mask(list(map(bool, mask)), invert=True).points, cloud.points[~mask])
    for wrong in (mask.astype(int), mask[:5], mask[:, None], []):
        with pytest.raises(ValueError, match="mask:"):
            cloud.select_by_mask(wrong)


LOW, HIGH = np.array([-0.5, -1, 0.25]), np.array([0.5, 0.75, 1])
ROTATION = Rotation.from_euler("XYZ", (0.3, -0.5, 1.1)).as_matrix()


def boxes_of(library):
    """An axis-aligned box, the same box as an oriented one, and a rotated one, of Open3D or pointloom."""
    rotations = np.eye(3), ROTATION
    oriented = [library.OrientedBoundingBox((LOW + HIGH) / 2, rotation, HIGH - LOW) for rotation in rotations]
    return [library.AxisAlignedBoundingBox(LOW, HIGH), *oriented]


def open3d_crops(o3d, points):
    vectors = o3d.utility.Vector3dVector(points)
    return [np.array(box.get_point_indices_within_bounding_box(vectors), np.int16) for box in boxes_of(o3d.geometry)]


def test_crop_agrees_with_open3d_including_faces(device, rng, oracle):
    points = np.concatenate([rng.integers(-4, 5, (2000, 3)) / 4.0, rng.random((1000, 3)) * 2 - 1])
    cloud = loom.PointCloud(points, device=device)
    positions = cloud.points.copy()
    for box, inside in zip(boxes_of(loom), oracle("pcd/cropping/boxes", open3d_crops, positions), strict=True):
        assert 0 < len(inside) < 3000
        np.testing.assert_array_equal(cloud.crop(box).points, positions[inside])
        np.testing.assert_array_equal(cloud.crop(box, invert=True).points, np.delete(positions, inside, axis=0))
        for given_points in (positions, cloud):
            np.testing.assert_array_equal(box.get_point_indices_within_bounding_box(given_points), inside)


def test_cropping_to_a_face_typed_in_float64_keeps_the_points_on_it(device):
    points = np.array([[0.1, 0.2, 0.3], [0.1, 0.2, 0.4], [UTM[0] % 1, 0.7, 0.9]])
    for shift in (0.0, UTM):
        cloud = loom.PointCloud(points + shift, device=device)
        for point in points + shift:
            assert len(cloud.crop(loom.AxisAlignedBoundingBox(point, point))) == 1


def test_points_that_are_not_finite_are_removed_by_kind(device, rng):
    points = rng.random((300, 3)).astype(np.float32)
    points[::3, 0], points[1::7, 2], points[6, 1] = np.nan, np.inf, -np.inf
    cloud = loom.PointCloud(points, device=device, row=np.arange(300))
    for remove_nan, remove_infinite in np.ndindex(2, 2):
        bad = (np.isnan(points) & bool(remove_nan)) | (np.isinf(points) & bool(remove_infinite))
        result = cloud.remove_non_finite_points(bool(remove_nan), bool(remove_infinite))
        assert result["row"].tolist() == np.flatnonzero(~bad.any(axis=1)).tolist()
        np.testing.assert_array_equal(points[result["row"]], result.points)


@examples(30)
@given(points=clouds(INTEGERS, real(100), NOT_FINITE, st.sampled_from([5e5, 1e-20])), seed=st.integers(0, 100))
def test_any_small_cloud_is_selected_as_numpy_selects(device, points, seed):
    rng = np.random.default_rng(seed)
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    positions = cloud.points
    finite = np.isfinite(positions).all(axis=1)
    np.testing.assert_array_equal(finite, np.isfinite(points).all(axis=1))
    np.testing.assert_allclose(positions[finite], points[finite], rtol=1.2e-7, atol=0.07)  # 1e6 apart: 6.0e-8 of it
    assert cloud.remove_non_finite_points()["row"].tolist() == np.flatnonzero(finite).tolist()
    mask = rng.random(len(points)) < 0.5
    assert cloud.select_by_mask(mask)["row"].tolist() == np.flatnonzero(mask).tolist()
    low, high = np.sort(rng.uniform(-4, 4, (2, 3)), axis=0)
    inside = ((positions >= low) & (positions <= high)).all(axis=1)
    near_a_face = (np.abs(positions - low) < 0.1).any(axis=1) | (np.abs(positions - high) < 0.1).any(axis=1)
    selected = np.isin(np.arange(len(points)), cloud.crop(loom.AxisAlignedBoundingBox(low, high))["row"])
    assert (selected == inside)[~near_a_face].all()
    if finite.any():
        np.testing.assert_array_equal(cloud.get_min_bound(), positions[finite].min(axis=0))
        np.testing.assert_array_equal(cloud.get_max_bound(), positions[finite].max(axis=0))


def first_rows(points):
    """Rows of first occurrences, by a set; a row with a NaN is equal to none."""
    rows, seen = [], set()
    for row, point in enumerate(points.tolist()):
        if np.isnan(point).any() or tuple(point) not in seen:
            rows.append(row)
        seen.add(tuple(point))
    return rows


def open3d_without_duplicates(o3d, points):
    return np.asarray(cloud_of(o3d, points).remove_duplicated_points().points)


@examples(30)
@given(points=clouds(parts(1, 1), NOT_FINITE, st.sampled_from([-0.0, 1e-45, 0.1])))
def test_first_occurrences_of_any_small_cloud_are_left(device, points):
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    assert cloud.remove_duplicated_points()["row"].tolist() == first_rows(points.astype(np.float32))


def test_zeros_of_both_signs_are_equal_and_nan_equals_nothing_as_in_open3d(device, oracle):
    points = np.array([[0, 0, 0], [np.nan, 0, 0], [-0.0, 0, 0], [np.nan, 0, 0], [np.inf, 0, 0], [np.inf, 0, 0]])
    cloud = loom.PointCloud(points, device=device, row=np.arange(6))
    assert cloud.remove_duplicated_points()["row"].tolist() == [0, 1, 3, 4]
    expected = oracle("pcd/selection/zeros", open3d_without_duplicates, points)
    np.testing.assert_array_equal(cloud.remove_duplicated_points().points, expected)


@pytest.mark.parametrize("count", [0, 1, 2, 1000])
def test_equal_points_become_the_first_of_them_with_its_attributes(device, count):
    cloud = loom.PointCloud(
        np.full((count, 3), 5.4e6), normals=np.arange(3.0 * count).reshape(-1, 3), time=np.arange(count) / 3,
        device=device,
    )  # fmt: skip
    result = cloud.remove_duplicated_points()
    assert len(result) == min(count, 1)
    np.testing.assert_array_equal(result.points, cloud.points[:1])
    np.testing.assert_array_equal(result.normals, cloud.normals[:1])
    np.testing.assert_array_equal(result["time"], cloud["time"][:1])


KEYS = {
    "a slice": slice(2, 9, 3), "an open slice": slice(None, 4), "a slice from the end": slice(-3, None),
    "a slice backwards": slice(None, None, -2), "a slice beyond": slice(8, 99), "an empty slice": slice(5, 5),
    "a mask": np.arange(10) % 3 == 1, "a list of booleans": [True, False] * 5, "an empty mask": np.zeros(10, bool),
    "indices": np.array([7, 0, 0, 3]), "indices from the end": [-1, -10, 4], "no index": [],
    "unsigned indices": np.array([9, 2], np.uint8), "a view": np.arange(10)[::-3],
}  # fmt: skip


@pytest.mark.parametrize("name", KEYS)
def test_points_are_selected_as_numpy_selects_rows(device, name):
    rng, key = np.random.default_rng(0), KEYS[name]
    cloud = loom.PointCloud(
        np.add(rng.random((10, 3)), [5e5, 5e6, 0]), normals=rng.normal(size=(10, 3)), colors=rng.random((10, 3)),
        label=np.arange(10), weights=rng.random((10, 2)).astype(np.float32), unit="metre", device=device,
    )  # fmt: skip
    result, rows = cloud[key], np.zeros(0, int) if name == "no index" else key
    for attribute in ("points", "normals", "colors", "label", "weights"):
        np.testing.assert_array_equal(result[attribute], cloud[attribute][rows])
        assert result[attribute].dtype == cloud[attribute].dtype
    assert (result.unit, result.device) == (cloud.unit, cloud.device)
    np.testing.assert_array_equal(result.origin, cloud.origin)


def test_arrays_of_the_device_select_too(device):
    cloud = loom.PointCloud(np.arange(30.0).reshape(10, 3), device=device)
    indices, mask = np.array([3, -1, 0]), np.arange(10) > 6
    for key in (indices, mask):
        given = wp.array(key, dtype=wp.bool if key.dtype == bool else wp.int64, device=device)
        np.testing.assert_array_equal(cloud[given].points, cloud.points[key])


SQUARE = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]


def text_of(**changes):
    """JSON text of a volume with some keys changed, or removed if None."""
    content = {
        "axis_max": 2.0, "axis_min": -1.0, "bounding_polygon": SQUARE, "class_name": "SelectionPolygonVolume",
        "orthogonal_axis": "Z", "version_major": 1, "version_minor": 0, **changes,
    }  # fmt: skip
    return json.dumps({key: value for key, value in content.items() if value is not None})


@pytest.fixture(scope="module")
def open3d_volume(o3d, tmp_path_factory):
    """A function that converts a volume to Open3D's through its file."""
    path = tmp_path_factory.mktemp("volumes") / "volume.json"

    def convert(volume):
        volume.to_json(path)
        return o3d.visualization.read_selection_polygon_volume(str(path))

    return convert


def open3d_indices(o3d, volume, points):
    return list(volume.crop_in_polygon(cloud_of(o3d, points)))


def open3d_choices(o3d, volumes, points):
    """Rows inside each volume, which Open3D reads from pointloom's file."""
    results = []
    with tempfile.TemporaryDirectory() as folder:
        for volume in volumes:
            path = Path(folder) / "volume.json"
            volume.to_json(path)
            open3d_polygon = o3d.visualization.read_selection_polygon_volume(str(path))
            results.append(np.array(open3d_indices(o3d, open3d_polygon, points), np.int16))
    return results


def star(middle, radii, axis):
    """A pentagram: each of the five corners is joined with the next but one; its center is enclosed twice."""
    angles = np.arange(5) * 4 * np.pi / 5 + 0.3
    corners = np.full((5, 3), 7.5)
    u, v = [a for a in range(3) if a != axis]
    corners[:, u] = middle[u] + radii[u] * np.cos(angles)
    corners[:, v] = middle[v] + radii[v] * np.sin(angles)
    return corners


def concave(middle, radii, axis):
    """An arrow head with a notch; some of its corners are outside the cloud."""
    corners = np.full((4, 3), -1.0)
    u, v = [a for a in range(3) if a != axis]
    corners[:, u] = middle[u] + radii[u] * np.array([-1, 0, 1.2, 0])
    corners[:, v] = middle[v] + radii[v] * np.array([-0.8, -0.2, -0.9, 1.1])
    return corners


@pytest.mark.parametrize("at", [np.zeros(3), np.array([5e5, 5.4e6, 200])], ids=["here", "utm"])
def test_choices_are_open3ds(device, at, rng, oracle):
    """Open3D's arithmetic is exact enough in UTM; float32 would round the corners by half a meter."""
    cloud = loom.PointCloud(np.round(rng.random((500, 3)) * 64) / 8 + at, device=device)
    volumes = [
        loom.SelectionPolygonVolume(shape(at + 4.1, [3.5, 3.7, 3.2], axis), "XYZ"[axis], at[axis] + 1, at[axis] + 7)
        for axis in range(3)
        for shape in (star, concave)
    ]
    name, points = "pcd/polygon_volume/" + ("utm" if at.any() else "here"), cloud.points
    for volume, expected in zip(volumes, oracle(name, open3d_choices, volumes, points), strict=True):
        assert 0 < len(expected) < len(points)
        others = np.setdiff1d(np.arange(len(points)), expected)
        for operand in (cloud, points):
            np.testing.assert_array_equal(volume.crop_in_polygon(operand), expected)
            np.testing.assert_array_equal(volume.crop_in_polygon(operand, invert=True), others)
        np.testing.assert_array_equal(volume.crop_point_cloud(cloud).points, points[expected])
        np.testing.assert_array_equal(cloud.crop(volume, invert=True).points, points[others])


COORDINATES = st.integers(-2, 2).map(float), real(3)


@examples(80)
@given(
    corners=clouds(*COORDINATES, min_size=3, max_size=7), points=clouds(*COORDINATES, min_size=1, max_size=30),
    axis=st.sampled_from("XYZxyz"), ends=st.tuples(*[st.one_of(*COORDINATES)] * 2),
)  # fmt: skip
def test_any_polygon_agrees_with_open3d(device, o3d, open3d_volume, corners, points, axis, ends):
    """Corners and points of a lattice are on each other's edges; polygons are self-intersecting or flat."""
    volume = loom.SelectionPolygonVolume(corners, axis, min(ends), max(ends))
    expected = open3d_indices(o3d, open3d_volume(volume), points)
    assert volume.crop_in_polygon(loom.PointCloud(points, device=device)).tolist() == expected
    assert volume.crop_in_polygon(points).tolist() == expected


def test_axis_limits_and_upper_edges_are_inclusive(device):
    volume = loom.SelectionPolygonVolume(SQUARE, "Z", -1, 2)
    points = [[1, 1, -1], [1, 1, 2], [1, 1, 2.1], [0, 1, 0], [4, 1, 0], [1, 0, 0], [1, 4, 0], [0, 0, 0], [4, 4, 0]]
    assert volume.crop_in_polygon(loom.PointCloud(points, device=device)).tolist() == [0, 1, 4, 6, 8]


def test_a_crop_carries_attributes_and_origin(device, rng):
    points, normals = rng.random((50, 3)) * 8 + [5e5, 5.4e6, 0], rng.normal(size=(50, 3))
    cloud = loom.PointCloud(points, normals=normals, row=np.arange(50), device=device)
    volume = loom.SelectionPolygonVolume(np.add(SQUARE, [5e5, 5.4e6, 0]), "Z", 0, 8)
    rows = volume.crop_in_polygon(cloud)
    result = volume.crop_point_cloud(cloud)
    assert 0 < len(rows) < 50 and rows.dtype == np.int32 and (result.origin == cloud.origin).all()
    for name in ("points", "normals", "row"):
        np.testing.assert_array_equal(result[name], cloud[name][rows])


def test_a_file_gives_back_every_bit(tmp_path, rng):
    volume = loom.SelectionPolygonVolume(rng.normal(size=(9, 3)) * 1e6 + 1 / 3, "y", -np.pi, 1e-17)
    volume.to_json(tmp_path / "volume.json")
    again = loom.SelectionPolygonVolume.from_json(tmp_path / "volume.json")
    np.testing.assert_array_equal(again.bounding_polygon, volume.bounding_polygon)
    assert (again.orthogonal_axis, again.axis_min, again.axis_max) == ("Y", -np.pi, 1e-17)
    (tmp_path / "a.json").write_text(text_of(axis_min=0))  # with integers
    assert loom.SelectionPolygonVolume.from_json(tmp_path / "a.json").axis_min == 0.0


BAD_FILES = {
    "{": "line 1, column 2.*not JSON: Expecting",
    "[]": "expected a JSON object, got a list",
    b"\xff\xfe\x00": "not valid JSON|not JSON",
    text_of()[:-1] + ', "axis_min": 1}': "key 'axis_min' is given twice",
    text_of(axis_min=float("nan")): "NaN is not a number",
    text_of(axis_max=10**200): r"key axis_max.*expected a finite number, got '1000",
    text_of(axis_min=None): "key axis_min.*missing",
    text_of(version_major=None): "key version_major.*missing",
    text_of(volume=1): "key volume.*is unknown",
    text_of(class_name="PointCloud"): "key class_name.*expected 'SelectionPolygonVolume', got 'PointCloud'",
    text_of(version_major=2): "key version_major.*expected 1, got '2'",
    text_of(version_major=True): "key version_major.*expected 1, got 'True'",
    text_of(bounding_polygon={"a": 1}): "key bounding_polygon.*at least three corners, got a dict",
    text_of(bounding_polygon=SQUARE[:2]): "key bounding_polygon.*at least three corners, got 2",
    text_of(bounding_polygon=[[0, 0, 0], [0, 1]] * 2): r"bounding_polygon\[1\].*list of three numbers",
    text_of(bounding_polygon=[[0, 0, "0"]] * 3): r"bounding_polygon\[0\].*expected a finite number, got '0'",
    text_of(axis_max=True): "key axis_max.*expected a finite number, got 'True'",
    text_of(orthogonal_axis="W"): "orthogonal_axis: expected 'X', 'Y' or 'Z', got 'W'",
    text_of(orthogonal_axis=["Z"]): "orthogonal_axis: expected 'X', 'Y' or 'Z'",
    text_of(axis_min=3): "expected min <= max",
}


@pytest.mark.parametrize("content", BAD_FILES, ids=BAD_FILES.values())
def test_invalid_file_is_rejected_with_its_location(tmp_path, content):
    path = tmp_path / "bad.json"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(loom.FileError, match=f"bad.json.*({BAD_FILES[content]})"):
        loom.SelectionPolygonVolume.from_json(path)


def test_inaccessible_paths_are_file_errors(tmp_path):
    with pytest.raises(loom.FileError, match=r"/missing\.json:"):
        loom.SelectionPolygonVolume.from_json(tmp_path / "missing.json")
    with pytest.raises(loom.FileError, match=r"/a\.json:"):
        loom.SelectionPolygonVolume(SQUARE, "Z", 0, 1).to_json(tmp_path / "no" / "a.json")
