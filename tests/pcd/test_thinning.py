"""Thinning by a fixed grid: the point nearest to the center of each cell, independent of the rest of the cloud."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

UTM = np.array([5e5, 5.4e6, 100.0])


def brute(cloud, spacing, corner):
    positions = (cloud.points - cloud.origin).astype(np.float32).astype(np.float64) - (np.array(corner) - cloud.origin)
    best = {}
    for row, position in enumerate(positions):
        if not np.isfinite(position).all():
            continue
        cell = np.floor(position / spacing)
        off = (((position / spacing - cell) - 0.5) ** 2).sum()
        if off < best.get(tuple(cell), (np.inf, 0))[0]:
            best[tuple(cell)] = (off, row)
    return sorted(row for _, row in best.values())


@pytest.mark.parametrize(("at", "corner"), [(np.zeros(3), (0.3, -7.1, 2e3)), (UTM, (0, 0, 0))], ids=["here", "in UTM"])
def test_each_cell_keeps_one_point_unchanged(device, rng, at, corner):
    points = np.round(rng.random((3000, 3)) * (10, 10, 2), 1) + at
    points[::100] = np.nan
    cloud = loom.PointCloud(points, device=device, row=np.arange(len(points)))
    thinned = cloud.thin(0.7, corner)
    assert thinned["row"].tolist() == brute(cloud, 0.7, corner)
    np.testing.assert_array_equal(thinned.points, cloud.points[thinned["row"]])
    assert thinned.thin(0.7, corner)["row"].tolist() == thinned["row"].tolist()


def test_parts_cut_between_cells_thin_like_the_full_cloud(device, rng):
    points = rng.random((4000, 3)) * (8, 8, 1) + UTM
    full = loom.PointCloud(points, origin=UTM, device=device, row=np.arange(len(points)))
    left = full.points[:, 0] < UTM[0] + 4.0
    parts = [full.select_by_mask(mask).thin(0.5) for mask in (left, ~left)]
    rows = np.sort(np.concatenate([np.asarray(part["row"]) for part in parts]))
    assert rows.tolist() == full.thin(0.5)["row"].tolist()


@settings(max_examples=30, deadline=None)
@given(st.lists(st.tuples(*[st.integers(-6, 6)] * 3), max_size=30), st.sampled_from([0.5, 1.0, 3.0]))
def test_any_small_cloud_is_thinned_as_a_dictionary_thins_it(positions, spacing):
    cloud = loom.PointCloud(np.array(positions, np.float64).reshape(-1, 3) / 2, row=np.arange(len(positions)))
    assert cloud.thin(spacing)["row"].tolist() == brute(cloud, spacing, (0, 0, 0))
