"""Tables of points with all that PLY and PCD hold, and whether two tables are the same to the bit."""

from __future__ import annotations

import numpy as np

from pointloom.io.table import PointTable


def table_of(count=100, dtype=np.float32, grid=None, **attributes) -> PointTable:
    """Points with normals, colors in steps of 1/255 and attributes of several types, and more of them."""
    rng = np.random.default_rng(3)
    more = {
        "alpha": rng.integers(0, 256, count).astype(np.uint8),
        "ring": rng.integers(-9, 99, count).astype(np.int16),
        "label": rng.integers(-(2**31), 2**31, count).astype(np.int32),
        "curvature": rng.random(count).astype(np.float32),
        "time": rng.random(count) + 1.7e9,
    }
    return PointTable(
        rng.normal(size=(count, 3)).astype(dtype),
        rng.normal(size=(count, 3)).astype(np.float32),
        rng.integers(0, 256, (count, 3)).astype(np.float32) / np.float32(255),
        more | attributes,
        grid,
    )


def assert_same_table(found: PointTable, expected: PointTable) -> None:
    """That two tables hold the same bits of the same types."""
    assert found.grid == expected.grid
    assert sorted(found.attributes) == sorted(expected.attributes)
    pairs = [(getattr(found, name), getattr(expected, name)) for name in ("points", "normals", "colors")]
    for left, right in [*pairs, *((found.attributes[name], expected.attributes[name]) for name in found.attributes)]:
        assert (left is None) == (right is None)
        if right is not None:
            assert left.dtype == right.dtype
            np.testing.assert_array_equal(left, right)
