"""Tables of points with all data types of PLY and PCD, and their bitwise comparison."""

import numpy as np

from pointloom.io.table import MeshTable, PointTable


def table_of(count=100, dtype=np.float32, grid=None, **attributes) -> PointTable:
    """Points with normals, colors in steps of 1/255 and attributes of several types, plus additional ones."""
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


def mesh_of(count=50, dtype=np.float32, normals=True, colors=True, **attributes) -> MeshTable:
    """90 triangles of distinct vertices, none of which uses the last, with normals and colors in steps of 1/255."""
    rng = np.random.default_rng(7)
    return MeshTable(
        rng.normal(size=(count, 3)).astype(dtype),
        rng.permuted(np.tile(np.arange(count - 1), (90, 1)), axis=1)[:, :3].astype(np.int32),
        rng.normal(size=(count, 3)).astype(np.float32) if normals else None,
        rng.integers(0, 256, (count, 3)).astype(np.float32) / np.float32(255) if colors else None,
        attributes,
    )


def assert_same_table(result: PointTable, expected: PointTable) -> None:
    """Check that two tables are bitwise identical and have the same types."""
    assert result.grid == expected.grid and sorted(result.attributes) == sorted(expected.attributes)
    pairs = [(getattr(result, name), getattr(expected, name)) for name in ("points", "normals", "colors")]
    for left, right in [*pairs, *((result.attributes[name], expected.attributes[name]) for name in result.attributes)]:
        assert (left is None) == (right is None)
        if right is not None:
            assert left.dtype == right.dtype
            np.testing.assert_array_equal(left, right)
