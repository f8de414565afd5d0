"""First occurrences, in hash tables of any size."""

import numpy as np
import pytest

from pointloom.kernels.arrays import first_rows
from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling.duplicates import first_occurrences


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
    monkeypatch.setattr(first_rows, "SLOTS", slots)
    assert first_occurrences(upload(points, vec3, device)).numpy().tolist() == expected


def test_subnormal_coordinates_are_not_zero(device):
    """In threads that take subnormal numbers for zero too."""
    points = np.array([[0, 0, 0], [1e-45, 0, 0], [-0.0, 0, 0], [-1e-45, 0, 0], [1e-45, 0, 0]], np.float32)
    assert first_occurrences(upload(points, vec3, device)).numpy().tolist() == [0, 1, 3]
