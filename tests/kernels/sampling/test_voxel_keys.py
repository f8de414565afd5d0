"""Voxel groups by float64 arithmetic in ascending order of the key, and first occurrences of points."""

import itertools

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from pointloom.kernels.arrays import first_rows
from pointloom.kernels.arrays.duplicates import first_occurrences
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling.voxel_keys import VoxelGroups


def group(device, points, size):
    """The groups, and their points as lists of rows, of a grid that starts at the lowest corner."""
    finite = points[np.isfinite(points).all(axis=1)].astype(np.float64)
    corner = finite.min(axis=0)
    cells = np.floor((finite.max(axis=0) - corner) / size) + 1
    groups = VoxelGroups(upload(points, vec3, device), corner, size, cells)
    order, starts = groups.order.numpy(), groups.starts.numpy()
    assert len(starts) == groups.count + 1
    return [order[a:b].tolist() for a, b in itertools.pairwise(starts)]


def expected_groups(points, size):
    """The same by a dictionary of cells."""
    finite = np.isfinite(points).all(axis=1)
    corner = points[finite].astype(np.float64).min(axis=0)
    groups: dict[tuple[int, ...], list[int]] = {}
    for row in np.flatnonzero(finite):
        cell = tuple(int(c) for c in np.floor((points[row].astype(np.float64) - corner) / size))
        groups.setdefault(cell, []).append(int(row))
    return [groups[cell] for cell in sorted(groups)]


@pytest.mark.parametrize("count", [1, 2, 31, 1000])
@pytest.mark.parametrize("size", [0.01, 0.3, 50.0])
def test_points_fall_into_the_voxels_that_a_dictionary_gives(device, count, size, rng):
    points = (rng.normal(size=(count, 3)) * [1, 5, 0.2] - [0, 3, 0]).astype(np.float32)
    assert group(device, points, size) == expected_groups(points, size)


def test_a_grid_of_more_than_62_bits_is_refused_with_its_size(device):
    points = upload(np.array([[0, 0, 0], [1, 1, 1]], np.float32), vec3, device)
    grids = ((1e-9, [1e9 + 1, 3.0, 1e30], ""), (1e-9, [np.inf] * 3, ".*2.*62"))
    for size, cells, message in (*grids, (1.0, [2**21] * 3, 3 * ".*2.*097.*152" + ".*2.*62")):  # the last of 63 bits
        with pytest.raises(ValueError, match=f"^voxel_size:{message}"):
            VoxelGroups(points, np.zeros(3), size, cells)


def test_a_grid_of_exactly_62_bits_is_taken(device):
    points = np.array([[0, 0, 0], [2.0**30, 2.0**30 - 64, 0.5], [2.0**30, 2.0**30 - 64, 0.5]], np.float32)
    groups = VoxelGroups(upload(points, vec3, device), np.zeros(3), 1.0, [2**30 + 1, 2**30, 1])
    assert groups.order.numpy().tolist() == [0, 1, 2] and groups.starts.numpy().tolist() == [0, 1, 3]


coordinates = st.one_of(
    st.integers(-2, 2).map(float),
    st.floats(-4, 4, width=32, allow_subnormal=False),
    st.sampled_from([np.nan, np.inf, -np.inf, 1000.0]),
)
rows = st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=1, max_size=40)


@settings(derandomize=True, deadline=None, max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(points=rows.map(lambda p: np.array(p, np.float32)), size=st.sampled_from([0.1, 0.5, 1.0, 7.0]))
def test_any_points_fall_into_the_voxels_that_a_dictionary_gives(device, points, size):
    if np.isfinite(points).all(axis=1).any():
        assert group(device, points, size) == expected_groups(points, size)


@pytest.mark.parametrize("slots", [1, 2, 50])
def test_first_occurrences_do_not_depend_on_the_size_of_the_table(device, slots, rng, monkeypatch):
    """With one slot per point nearly all probes meet other points."""
    points = rng.integers(-3, 4, (256, 3)).astype(np.float32) / 3
    points[::17, 0] = np.nan
    expected, visited = [], set()
    for row, point in enumerate(points.tolist()):
        if np.isnan(point).any() or tuple(point) not in visited:
            expected.append(row)
        visited.add(tuple(point))
    monkeypatch.setattr(first_rows, "MIN_SLOTS_PER_ROW", slots)
    assert first_occurrences(upload(points, vec3, device)).numpy().tolist() == expected


def test_subnormal_coordinates_are_not_zero(device):
    """In threads that take subnormal numbers for zero too."""
    points = np.array([[0, 0, 0], [1e-45, 0, 0], [-0.0, 0, 0], [-1e-45, 0, 0], [1e-45, 0, 0]], np.float32)
    assert first_occurrences(upload(points, vec3, device)).numpy().tolist() == [0, 1, 3]
