"""Clouds concatenated and painted."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import pointloom as loom

from .any_cloud import examples

TILES = np.array([[5e5, 5.4e6, 300], [500_600, 5_400_250, 280], [499_000, 5_401_000, 310]])


NONE, NORMALS, COLORS, BOTH = (), ("normals",), ("colors",), ("normals", "colors")
SUMS = [
    (left, right, counts)
    for left, right, counts in (
        *((left, right, (3, 2)) for left in (NONE, NORMALS, BOTH) for right in (NONE, COLORS, BOTH)),
        *((BOTH, right, counts) for right in (NONE, COLORS) for counts in ((0, 2), (3, 0))),
        (NONE, BOTH, (0, 2)),
        (NORMALS, NONE, (3, 0)),
    )
]


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
    clouds = [
        loom.PointCloud(rng.integers(-99, 99, (n, 3)) + shift, device=device, row=np.arange(n)) for n, shift in parts
    ]
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
    assert result.array("points") is cloud.array("points") and result.grid == (7, 1)
    assert result["row"].tolist() == [*range(7)]
    assert (cloud.colors != result.colors).any()
    assert loom.PointCloud(device=device).paint_uniform_color((0, 0, 0)).colors.shape == (0, 3)
