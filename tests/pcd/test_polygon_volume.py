"""SelectionPolygonVolume: Open3D's choice of points, on any axis, at any coordinates, and its files read strictly."""

from __future__ import annotations

import json

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

SQUARE = [[0, 0, 0], [4, 0, 0], [4, 4, 0], [0, 4, 0]]


def text_of(**changes):
    """A volume's JSON with some keys changed, or left out where None."""
    content = {
        "axis_max": 2.0, "axis_min": -1.0, "bounding_polygon": SQUARE, "class_name": "SelectionPolygonVolume",
        "orthogonal_axis": "Z", "version_major": 1, "version_minor": 0, **changes,
    }  # fmt: skip
    return json.dumps({key: value for key, value in content.items() if value is not None})


@pytest.fixture(scope="module")
def open3d_volume(tmp_path_factory):
    """A function that makes Open3D's volume of ours, by our file."""
    import open3d as o3d

    path = tmp_path_factory.mktemp("volumes") / "volume.json"

    def convert(volume):
        volume.to_json(path)
        return o3d.visualization.read_selection_polygon_volume(str(path))

    return convert


def open3d_indices(oracle, points):
    import open3d as o3d

    cloud = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(np.array(points, np.float64)))
    return list(oracle.crop_in_polygon(cloud))


def star(middle, radii, axis):
    """A pentagram: five corners, each joined with the next but one; its middle is surrounded twice."""
    angles = np.arange(5) * 4 * np.pi / 5 + 0.3
    corners = np.full((5, 3), 7.5)
    u, v = [a for a in range(3) if a != axis]
    corners[:, u] = middle[u] + radii[u] * np.cos(angles)
    corners[:, v] = middle[v] + radii[v] * np.sin(angles)
    return corners


def concave(middle, radii, axis):
    """An arrow head with a notch, its corners beyond the cloud in part."""
    corners = np.full((4, 3), -1.0)
    u, v = [a for a in range(3) if a != axis]
    corners[:, u] = middle[u] + radii[u] * np.array([-1, 0, 1.2, 0])
    corners[:, v] = middle[v] + radii[v] * np.array([-0.8, -0.2, -0.9, 1.1])
    return corners


def check_against_open3d(device, volume, cloud, open3d_volume):
    """Both ways to crop, and both inverted."""
    points = cloud.points
    expected = open3d_indices(open3d_volume(volume), points)
    assert 0 < len(expected) < len(points)
    others = np.setdiff1d(np.arange(len(points)), expected)
    for operand in (cloud, points):
        assert volume.crop_in_polygon(operand).tolist() == expected
        np.testing.assert_array_equal(volume.crop_in_polygon(operand, invert=True), others)
    np.testing.assert_array_equal(volume.crop_point_cloud(cloud).points, points[expected])
    np.testing.assert_array_equal(cloud.crop(volume, invert=True).points, points[others])


@pytest.mark.parametrize("shape", [star, concave])
@pytest.mark.parametrize("axis", range(3))
def test_choices_in_the_fragment_are_open3ds(device, axis, shape, fragment, open3d_volume):
    points = fragment.points[::3]
    low, high = np.quantile(points, [0.1, 0.9], axis=0)
    volume = loom.SelectionPolygonVolume(
        shape((low + high) / 2, (high - low) * 0.7, axis), "XYZ"[axis], low[axis], high[axis]
    )
    check_against_open3d(device, volume, loom.PointCloud(points, device=device), open3d_volume)


def test_choices_in_a_lidar_scan_are_open3ds(device, lidar, open3d_volume):
    volume = loom.SelectionPolygonVolume(star([5, 0, 0], [30, 12, 0], 2), "z", -1.8, 1.0)
    check_against_open3d(device, volume, loom.PointCloud(lidar[:, :3], device=device), open3d_volume)


@pytest.mark.parametrize("axis", range(3))
def test_choices_at_utm_coordinates_are_open3ds(device, axis, shipped_file, open3d_volume):
    """Open3D's arithmetic is exact enough there; float32 would round the corners by half a metre."""
    cloud = loom.read_point_cloud(shipped_file("lidar-pcl-terrain/samp21-utm.pcd")).to(device)
    low, high = np.quantile(cloud.points, [0.05, 0.95], axis=0)
    corners = star((low + high) / 2, (high - low) * 0.6, axis) + 0.12345
    volume = loom.SelectionPolygonVolume(corners, "XYZ"[axis], low[axis], high[axis])
    check_against_open3d(device, volume, cloud, open3d_volume)


coordinate = st.one_of(st.integers(-2, 2).map(float), st.floats(-3, 3, width=32, allow_subnormal=False))
triples = st.tuples(coordinate, coordinate, coordinate)


@settings(derandomize=True, deadline=None, max_examples=80)
@given(
    corners=st.lists(triples, min_size=3, max_size=7), points=st.lists(triples, min_size=1, max_size=30),
    axis=st.sampled_from("XYZxyz"), ends=st.tuples(coordinate, coordinate),
)  # fmt: skip
def check_any_polygon(device, open3d_volume, corners, points, axis, ends):
    """Corners and points on a lattice lie on each other's edges; polygons cross themselves or are flat."""
    volume = loom.SelectionPolygonVolume(corners, axis, min(ends), max(ends))
    expected = open3d_indices(open3d_volume(volume), points)
    assert volume.crop_in_polygon(loom.PointCloud(points, device=device)).tolist() == expected
    assert volume.crop_in_polygon(points).tolist() == expected


def test_any_polygon_chooses_what_open3ds_does(device, open3d_volume):
    check_any_polygon(device, open3d_volume)


def test_ends_are_inclusive_and_of_the_edges_the_upper_ones(device):
    volume = loom.SelectionPolygonVolume(SQUARE, "Z", -1, 2)
    points = [[1, 1, -1], [1, 1, 2], [1, 1, 2.1], [0, 1, 0], [4, 1, 0], [1, 0, 0], [1, 4, 0], [0, 0, 0], [4, 4, 0]]
    assert volume.crop_in_polygon(loom.PointCloud(points, device=device)).tolist() == [0, 1, 4, 6, 8]


def test_points_that_are_not_finite_are_outside(device, open3d_volume):
    volume = loom.SelectionPolygonVolume(SQUARE, "Z", -1, 2)
    points = [[1, 1, 0], [1, 1, np.nan], [np.nan, 1, 0], [np.inf, 1, 0], [1, 1, -np.inf], [3, 3, 1]]
    cloud = loom.PointCloud(points, device=device)
    assert volume.crop_in_polygon(cloud).tolist() == volume.crop_in_polygon(points).tolist() == [0, 5]
    assert volume.crop_in_polygon(cloud, invert=True).tolist() == [1, 2, 3, 4]
    assert 1 in open3d_indices(open3d_volume(volume), points), "Open3D takes a NaN along the axis for inside"


def test_a_crop_carries_attributes_and_origin(device, rng):
    cloud = loom.PointCloud(
        rng.random((50, 3)) * 8 + [5e5, 5.4e6, 0], normals=rng.normal(size=(50, 3)), row=np.arange(50), device=device
    )
    volume = loom.SelectionPolygonVolume(np.add(SQUARE, [5e5, 5.4e6, 0]), "Z", 0, 8)
    rows = volume.crop_in_polygon(cloud)
    found = volume.crop_point_cloud(cloud)
    assert 0 < len(rows) < 50 and rows.dtype == np.int32 and (found.origin == cloud.origin).all()
    for name in ("points", "normals", "row"):
        np.testing.assert_array_equal(found[name], cloud[name][rows])


def test_an_empty_cloud_has_nothing_inside(device):
    volume = loom.SelectionPolygonVolume(SQUARE, "Z", -1, 2)
    empty = loom.PointCloud(device=device)
    assert (
        len(volume.crop_point_cloud(empty))
        == len(volume.crop_in_polygon(empty))
        == len(volume.crop_in_polygon([]))
        == 0
    )


# ------------------------------------------------------------------------------------------------ making and files


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((SQUARE[:2], "Z", 0, 1), "bounding_polygon: expected at least three corners, got 2"),
        (([[0, 0]] * 3, "Z", 0, 1), r"bounding_polygon: expected shape \[n, 3\], got \[3, 2\]"),
        (([[0, 0, np.nan]] * 3, "Z", 0, 1), "bounding_polygon: expected finite numbers"),
        ((SQUARE, "W", 0, 1), "orthogonal_axis: expected 'X', 'Y' or 'Z', got 'W'"),
        ((SQUARE, None, 0, 1), "orthogonal_axis: expected 'X', 'Y' or 'Z', got None"),
        ((SQUARE, "Z", 1, 0), "axis_min, axis_max: expected min <= max, got 1 and 0"),
        ((SQUARE, "Z", 0, np.inf), "axis_min, axis_max: expected finite numbers"),
    ],
)
def test_a_volume_that_is_none_is_refused(arguments, message):
    with pytest.raises(ValueError, match=message):
        loom.SelectionPolygonVolume(*arguments)


def test_a_volume_does_not_follow_the_array_it_was_made_of():
    corners = np.array(SQUARE, float)
    volume = loom.SelectionPolygonVolume(corners, "Z", 0, 1)
    corners[:] = 9
    assert volume.bounding_polygon.tolist() == np.array(SQUARE, float).tolist()


def test_a_file_gives_back_every_bit_and_open3d_reads_it(tmp_path, rng, open3d_volume):
    volume = loom.SelectionPolygonVolume(rng.normal(size=(9, 3)) * 1e6 + 1 / 3, "y", -np.pi, 1e-17)
    volume.to_json(tmp_path / "volume.json")
    again = loom.SelectionPolygonVolume.from_json(tmp_path / "volume.json")
    oracle = open3d_volume(volume)
    for other in (again, oracle):
        np.testing.assert_array_equal(np.asarray(other.bounding_polygon), volume.bounding_polygon)
        assert (other.orthogonal_axis, other.axis_min, other.axis_max) == ("Y", -np.pi, 1e-17)


def test_a_file_with_whole_numbers_is_read(tmp_path):
    (tmp_path / "a.json").write_text(text_of(axis_min=0))
    assert loom.SelectionPolygonVolume.from_json(tmp_path / "a.json").axis_min == 0.0


BAD_FILES = {
    "no json": ("{", "line 1, column 2.*not JSON: Expecting"),
    "list": ("[]", "expected a JSON object, got a list"),
    "not utf-8": (b"\xff\xfe\x00", "not valid JSON|not JSON"),
    "deep": ("[" * 10**6, "not valid JSON|not JSON"),
    "twice": (text_of()[:-1] + ', "axis_min": 1}', "key 'axis_min' is given twice"),
    "nan": (text_of(axis_min=float("nan")), "NaN is not a number"),
    "infinite": (text_of().replace("2.0", "1e999"), "1e999 is too large"),
    "huge": (text_of(axis_max=10**200), r"key axis_max.*expected a finite number, got '1000"),
    "missing": (text_of(axis_min=None), "key axis_min.*missing"),
    "no version": (text_of(version_major=None), "key version_major.*missing"),
    "unknown": (text_of(volume=1), "key volume.*of unknown meaning"),
    "class": (text_of(class_name="PointCloud"), "key class_name.*expected 'SelectionPolygonVolume', got 'PointCloud'"),
    "version": (text_of(version_major=2), "key version_major.*expected 1, got '2'"),
    "version type": (text_of(version_major=True), "key version_major.*expected 1, got 'True'"),
    "no polygon": (text_of(bounding_polygon={"a": 1}), "key bounding_polygon.*at least three corners, got a dict"),
    "two corners": (text_of(bounding_polygon=SQUARE[:2]), "key bounding_polygon.*at least three corners, got 2"),
    "flat corner": (text_of(bounding_polygon=[[0, 0, 0], [0, 1]] * 2), r"bounding_polygon\[1\].*list of three numbers"),
    "word": (text_of(bounding_polygon=[[0, 0, "0"]] * 3), r"bounding_polygon\[0\].*expected a finite number, got '0'"),
    "truth": (text_of(axis_max=True), "key axis_max.*expected a finite number, got 'True'"),
    "axis": (text_of(orthogonal_axis="W"), "orthogonal_axis: expected 'X', 'Y' or 'Z', got 'W'"),
    "axis type": (text_of(orthogonal_axis=["Z"]), "orthogonal_axis: expected 'X', 'Y' or 'Z'"),
    "ends": (text_of(axis_min=3), "expected min <= max"),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_a_bad_file_is_refused_with_the_place(tmp_path, name):
    content, message = BAD_FILES[name]
    path = tmp_path / "bad.json"
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(loom.FileError, match=f"bad.json.*({message})"):
        loom.SelectionPolygonVolume.from_json(path)


def test_places_that_cannot_be_read_or_written_are_file_errors(tmp_path):
    with pytest.raises(loom.FileError, match="cannot be read"):
        loom.SelectionPolygonVolume.from_json(tmp_path / "missing.json")
    with pytest.raises(loom.FileError, match="does not exist"):
        loom.SelectionPolygonVolume(SQUARE, "Z", 0, 1).to_json(tmp_path / "no" / "a.json")
