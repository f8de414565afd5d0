"""A LAS file that tests may damage."""

from __future__ import annotations

import pytest

from .las_files import make


@pytest.fixture
def small_las(tmp_path, rng):
    """A LAS 1.2 file of 20 points of format 3, which start at byte 227."""
    make(tmp_path / "small.las", 3, 20, rng)
    return tmp_path / "small.las"
