"""Fixtures: a LAS file that tests may damage, and images."""

import numpy as np
import pytest

from .las_files import make


@pytest.fixture
def small_las(tmp_path, rng):
    """A LAS 1.2 file of 20 points of format 3; its points start at byte 227."""
    make(tmp_path / "small.las", 3, 20, rng)
    return tmp_path / "small.las"


@pytest.fixture
def depth() -> np.ndarray:
    depth = np.random.default_rng(0).integers(0, 2**16, (24, 32), np.uint16)
    depth[0, :4] = 0, 1, 255, 65535
    return depth


@pytest.fixture
def color() -> np.ndarray:
    return np.random.default_rng(1).integers(0, 256, (24, 32, 3), np.uint8)
