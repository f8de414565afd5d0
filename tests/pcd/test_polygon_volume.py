"""SelectionPolygonVolume: selects the same points as Open3D on any axis and at any coordinates; strict file reading."""

import json
import tempfile
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from .any_cloud import clouds, examples, real
from .open3d_clouds import cloud_of

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


def check_choice(volume, cloud, expected):
    points = cloud.points
    assert 0 < len(expected) < len(points)
    others = np.setdiff1d(np.arange(len(points)), expected)
    for operand in (cloud, points):
        np.testing.assert_array_equal(volume.crop_in_polygon(operand), expected)
        np.testing.assert_array_equal(volume.crop_in_polygon(operand, invert=True), others)
    np.testing.assert_array_equal(volume.crop_point_cloud(cloud).points, points[expected])
    np.testing.assert_array_equal(cloud.crop(volume, invert=True).points, points[others])


@pytest.mark.parametrize("at", [np.zeros(3), np.array([5e5, 5.4e6, 200])], ids=["here", "utm"])
def test_choices_are_open3ds(device, at, rng, oracle):
    """Open3D's arithmetic is exact enough in UTM; float32 would round the corners by half a meter."""
    cloud = loom.PointCloud(np.round(rng.random((500, 3)) * 64) / 8 + at, device=device)
    volumes = [
        loom.SelectionPolygonVolume(shape(at + 4.1, [3.5, 3.7, 3.2], axis), "XYZ"[axis], at[axis] + 1, at[axis] + 7)
        for axis in range(3)
        for shape in (star, concave)
    ]
    name = "pcd/polygon_volume/" + ("utm" if at.any() else "here")
    for volume, expected in zip(volumes, oracle(name, open3d_choices, volumes, cloud.points), strict=True):
        check_choice(volume, cloud, expected)


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


def test_file_with_integers_is_read(tmp_path):
    (tmp_path / "a.json").write_text(text_of(axis_min=0))
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
