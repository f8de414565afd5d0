"""Clouds put together, by + and by concatenate, and painted."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

TILES = np.array([[5e5, 5.4e6, 300], [500_600, 5_400_250, 280], [499_000, 5_401_000, 310]])


def test_a_sum_is_open3ds(device, fragment, to_open3d):
    parts = [
        (a[:1000], a[50_000:50_003], a[90_000:110_000]) for a in (fragment.points, fragment.normals, fragment.colors)
    ]
    clouds = [
        loom.PointCloud(points, normals=normals, colors=colors, device=device)
        for points, normals, colors in zip(*parts, strict=True)
    ]
    oracle = to_open3d(fragment.points[:0])
    for cloud in clouds:
        oracle = oracle + to_open3d(cloud.points, cloud.normals, cloud.colors)
    for found in (clouds[0] + clouds[1] + clouds[2], sum(clouds), loom.PointCloud.concatenate(clouds)):
        for name in ("points", "normals", "colors"):
            np.testing.assert_array_equal(found[name], np.asarray(getattr(oracle, name)))


@pytest.mark.parametrize("left", [(), ("normals",), ("normals", "colors")])
@pytest.mark.parametrize("right", [(), ("colors",), ("normals", "colors")])
@pytest.mark.parametrize("counts", [(3, 2), (0, 2), (3, 0)])
def test_normals_and_colours_are_kept_where_open3d_keeps_them(device, left, right, counts, rng, to_open3d):
    ours, oracles = [], []
    for names, count in zip((left, right), counts, strict=True):
        vectors = {name: rng.random((count, 3)) for name in names}
        points = rng.random((count, 3)).astype(np.float32)
        ours.append(loom.PointCloud(points, device=device, **vectors))
        oracles.append(to_open3d(points, **vectors))
    found, expected = ours[0] + ours[1], oracles[0] + oracles[1]
    assert (found.has_normals, found.has_colors) == (expected.has_normals(), expected.has_colors())
    np.testing.assert_array_equal(found.points, np.asarray(expected.points))


def test_attributes_that_all_clouds_have_are_kept_in_their_type(device, rng):
    dtypes = ("i1", "u1", "i2", "u4", "i8", "u8", "f2", "f4", "f8", "?")
    clouds = []
    for count in (5, 1, 12):
        attributes = {f"a{dtype.replace('?', 'b')}": rng.integers(0, 2, count).astype(dtype) for dtype in dtypes}
        attributes["wide"] = rng.integers(0, 9, (count, 3)).astype(np.int16)
        attributes[f"own{count}"] = np.ones(count)
        clouds.append(loom.PointCloud(rng.random((count, 3)), device=device, **attributes))
    found = loom.PointCloud.concatenate(iter(clouds))
    shared = set(clouds[0].attributes) - {"own5"}
    assert set(found.attributes) == shared and len(shared) == 11
    for name in shared:
        assert found[name].dtype == clouds[0][name].dtype
        np.testing.assert_array_equal(found[name], np.concatenate([cloud[name] for cloud in clouds]))


def test_clouds_about_several_origins_are_brought_to_that_of_the_largest(device, rng, tolerances):
    sizes = (5, 90, 40)
    clouds = [
        loom.PointCloud(rng.random((n, 3)) * 200 + tile, device=device) for n, tile in zip(sizes, TILES, strict=True)
    ]
    assert len({tuple(cloud.origin) for cloud in clouds}) == 3
    found = loom.PointCloud.concatenate(clouds)
    assert found.origin.tolist() == clouds[1].origin.tolist()
    expected = np.concatenate([cloud.points for cloud in clouds])
    limit = tolerances.float32_relative * np.abs(expected - found.origin).max()
    np.testing.assert_allclose(found.points, expected, rtol=0, atol=limit)
    assert limit < tolerances.position
    np.testing.assert_array_equal(found.points[5:95], clouds[1].points), "those of the largest keep their bits"


def test_an_empty_cloud_changes_nothing_not_even_the_origin(device, rng):
    cloud = loom.PointCloud(rng.random((9, 3)) + TILES[0], device=device, row=np.arange(9))
    for found in (loom.PointCloud(device=device) + cloud, cloud + loom.PointCloud(device=device), sum([cloud])):
        np.testing.assert_array_equal(found.points, cloud.points)
        assert (found.origin == cloud.origin).all() and found["row"].tolist() == list(range(9))
    nothing = loom.PointCloud(device=device) + loom.PointCloud([], device=device, ring=np.zeros(0, np.int32))
    assert len(nothing) == 0


def test_points_that_are_not_finite_are_carried_along(device):
    near = loom.PointCloud([[0, 0, 0], [np.nan, 1, np.inf]], device=device)
    far = loom.PointCloud([[np.inf, 5.4e6, 1], [5e5, 5.4e6, 1], [np.nan] * 3], device=device)
    for found in (near + far, far + near):
        expected = [near, far] if found.points[0].tolist() == [0, 0, 0] else [far, near]
        np.testing.assert_array_equal(found.points, np.concatenate([cloud.points for cloud in expected]))


parts = st.lists(st.tuples(st.integers(0, 5), st.sampled_from([0.0, 3e4, 5e5, -7e6])), min_size=1, max_size=5)


@settings(derandomize=True, deadline=None, max_examples=60)
@given(parts=parts, seed=st.integers(0, 99))
def check_any_parts(device, parts, seed):
    rng = np.random.default_rng(seed)
    clouds = [
        loom.PointCloud(rng.integers(-99, 99, (n, 3)) + shift, device=device, row=np.arange(n)) for n, shift in parts
    ]
    for found in (loom.PointCloud.concatenate(clouds), sum(clouds)):
        np.testing.assert_array_equal(found.points, np.concatenate([c.points for c in clouds])), "whole numbers: exact"
        np.testing.assert_array_equal(found["row"], np.concatenate([c["row"] for c in clouds]))


def test_any_clouds_are_put_together_as_numpy_does(device):
    check_any_parts(device)


def test_an_operand_is_left_as_it_was_and_in_place_addition_is_a_new_cloud(device, rng):
    cloud = loom.PointCloud(rng.random((4, 3)), device=device)
    before, held = cloud.points, cloud
    cloud += held
    assert len(cloud) == 8 and len(held) == 4
    cloud["points"] = np.zeros((8, 3))
    np.testing.assert_array_equal(held.points, before)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda a, b: a.concatenate([]), ValueError, "clouds: expected at least one cloud, got none"),
        (lambda a, b: a.concatenate([a, 3]), TypeError, "clouds: expected a PointCloud, got int"),
        (lambda a, b: a + 3, TypeError, "a cloud and a int cannot be added"),
        (lambda a, b: 1 + a, TypeError, "a cloud and a int cannot be added"),
        (lambda a, b: a + b, TypeError, "label: expected one type in all clouds, got int32 and int64; convert one"),
        (lambda a, b: b + loom.PointCloud([[0, 0, 0]], label=[[1, 2]]), ValueError, "label: expected as many columns"),
    ],
)
def test_what_cannot_be_put_together_is_refused(call, error, message):
    a = loom.PointCloud([[0, 0, 0]], label=np.array([1], np.int32))
    with pytest.raises(error, match=message):
        call(a, loom.PointCloud([[0, 0, 0]], label=np.array([1], np.int64)))


def test_clouds_on_two_devices_are_refused(rng, monkeypatch):
    """A stand-in for a second device, so that the rule is held where there is no GPU."""
    cloud, other = loom.PointCloud(rng.random((9, 3))), loom.PointCloud(rng.random((9, 3)))
    monkeypatch.setattr(
        loom.PointCloud, "device", property(lambda c: "cuda:7" if c is other else c.array("points").device)
    )
    with pytest.raises(loom.DeviceError, match=r"clouds: operands on cuda:7 and cpu"):
        cloud + other


def test_a_painted_cloud_has_one_colour_and_all_else_as_before(device, rng, to_open3d):
    cloud = loom.PointCloud(rng.random((7, 3)), colors=rng.random((7, 3)), row=np.arange(7), device=device)
    cloud.grid = (7, 1)
    found = cloud.paint_uniform_color([0.1, 1, 0])
    expected = np.asarray(to_open3d(cloud.points).paint_uniform_color([0.1, 1, 0]).colors)
    np.testing.assert_array_equal(found.colors, expected.astype(np.float32))
    assert (
        found.array("points") is cloud.array("points") and found.grid == (7, 1) and found["row"].tolist() == [*range(7)]
    )
    assert (cloud.colors != found.colors).any()
    assert loom.PointCloud(device=device).paint_uniform_color((0, 0, 0)).colors.shape == (0, 3)


@pytest.mark.parametrize(
    ("color", "message"),
    [
        ([255, 0, 0], r"color: expected 0..1, got \[255.0, 0.0, 0.0\]; divide 8-bit colours by 255"),
        ([0, -0.1, 0], "color: expected 0..1"),
        ([0, np.nan, 0], "color: expected 0..1"),
        ([0, 0], r"color: expected shape \[3\], got \[2\]"),
    ],
)
def test_a_colour_that_is_none_is_refused(color, message):
    with pytest.raises(ValueError, match=message):
        loom.PointCloud([[0, 0, 0]]).paint_uniform_color(color)
