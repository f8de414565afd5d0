"""First occurrences, for any hash."""

import numpy as np
import pytest

from pointloom.kernels.lang import vec3
from pointloom.kernels.memory import upload
from pointloom.kernels.sampling import duplicates
from pointloom.kernels.sampling.duplicates import first_occurrences


@pytest.mark.parametrize("hash_bits", [1, 3, 50])
def test_first_occurrences_do_not_depend_on_the_hash(device, hash_bits, rng, monkeypatch):
    """With one or three bits nearly all points share their hash with others."""
    points = rng.integers(-2, 3, (200, 3)).astype(np.float32) / 3
    points[::17, 0] = np.nan
    expected, visited = [], set()
    for row, point in enumerate(points.tolist()):
        if np.isnan(point).any() or tuple(point) not in visited:
            expected.append(row)
        visited.add(tuple(point))
    monkeypatch.setattr(duplicates, "WORD_BITS", 8 + hash_bits)
    assert first_occurrences(upload(points, vec3, device)).numpy().tolist() == expected


def test_subnormal_coordinates_are_not_zero(device):
    """In threads that take subnormal numbers for zero too."""
    points = np.array([[0, 0, 0], [1e-45, 0, 0], [-0.0, 0, 0], [-1e-45, 0, 0], [1e-45, 0, 0]], np.float32)
    assert first_occurrences(upload(points, vec3, device)).numpy().tolist() == [0, 1, 3]
