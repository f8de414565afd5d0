"""NaN, signaling NaN and infinities pass through readers, writers and clouds without NumPy warnings."""

import warnings

import laspy
import numpy as np
import pytest

import pointloom as loom
from pointloom.io.points.formats import READERS, write_table
from pointloom.io.points.las import read_las
from pointloom.io.table import PointTable

from .las_files import edited, make

SIGNALLING = {np.float32: (np.uint32, 0x7F800001), np.float64: (np.uint64, 0x7FF0000000000001)}
KINDS = ("signalling", "all signalling", "infinite", "all infinite", "largest", "far signalling", "far infinite")


def vectors(kind, dtype):
    rows = np.arange(18, dtype=dtype).reshape(6, 3) + dtype(1e6 if kind.startswith("far") else 0)
    unsigned, bits = SIGNALLING[dtype]
    if kind.endswith("signalling"):
        rows.view(unsigned)[2:, 1] = bits
        if kind.startswith("all"):
            rows.view(unsigned)[...] = bits
    elif kind.endswith("infinite"):
        rows[2] = np.inf
        rows[3] = -np.inf
        if kind.startswith("all"):
            rows[...] = np.inf
            rows[::2] = -np.inf
    else:
        rows[2, 1], rows[3, 1] = np.finfo(dtype).max, -np.finfo(dtype).max
    return rows


def attempt(operation, *args, **kwargs):
    """The result, or None if rejected. A warning is an error, even as the cause of a rejection."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.simplefilter("ignore", UserWarning)  # of attributes with other names
        try:
            return operation(*args, **kwargs)
        except (ValueError, TypeError) as error:
            assert "encountered" not in str(error)
            return None


@pytest.mark.parametrize("dtype", SIGNALLING)
@pytest.mark.parametrize("kind", KINDS)
def test_non_finite_cloud_issues_no_warning(kind, dtype, device):
    rows = vectors(kind, dtype)
    cloud = attempt(loom.PointCloud, rows, device=device)
    if cloud is not None:
        points = attempt(lambda: cloud.points)
        np.testing.assert_array_equal(np.isnan(points), np.isnan(rows))
        assert np.isfinite(points[:2]).all() == np.isfinite(rows[:2]).all()
    attempt(loom.PointCloud, rows, origin=[1e5, 0, 0], device=device)
    for name in ("normals", "colors", "intensity"):
        attempt(loom.PointCloud, np.zeros((6, 3)), device=device, **{name: rows})


@pytest.mark.parametrize("dtype", SIGNALLING)
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("name", ["points", "normals", "intensity"])
def test_non_finite_file_issues_no_warning(name, kind, dtype, tmp_path):
    rows = vectors(kind, dtype)
    plain = np.arange(18, dtype=dtype).reshape(6, 3)
    for extension in READERS:
        normals = rows if name == "normals" else np.ones((6, 3)) if extension == ".xyzn" else None
        attributes = {"intensity": rows[:, 1].copy()} if name == "intensity" else {}
        colors = np.full((6, 3), 0.5) if extension == ".xyzrgb" else None
        table = PointTable(rows if name == "points" else plain, normals, colors, attributes)
        for ascii in {False, extension in (".ply", ".pcd")}:
            path = tmp_path / f"{ascii}{extension}"
            attempt(write_table, path, table, ascii=ascii, overwrite=True)
            if path.exists():
                attempt(loom.read_point_cloud, path)
    stored = {"points": plain, name: rows if name != "intensity" else rows[:, 1]}
    np.savez(tmp_path / "raw.npz", **stored)
    attempt(loom.read_point_cloud, tmp_path / "raw.npz")


@pytest.mark.parametrize("bound", ["7ff0000000000001", "7ff0000000000000", "fff0000000000000", "7fefffffffffffff"])
def test_las_header_with_a_non_finite_box_issues_no_warning(bound, small_las):
    edited(small_las, *((at, "<Q", int(bound, 16)) for at in range(179, 227, 8)))
    parts = attempt(lambda: list(loom.read_las_chunks(small_las, 7)))
    assert [len(part) for part in parts] == [7, 7, 6]
    joined = np.concatenate([part.points for part in parts])
    np.testing.assert_allclose(joined, read_las(small_las).points, rtol=0, atol=4)  # 2e7 m apart


def test_extra_dimension_with_a_non_finite_scale_issues_no_warning(tmp_path, rng):
    extra = laspy.ExtraBytesParams("range", "i4", scales=[np.inf], offsets=[-np.inf])
    make(tmp_path / "a.las", 6, 20, rng, [extra])
    cloud = attempt(loom.read_point_cloud, tmp_path / "a.las")
    assert not np.isfinite(cloud["range"]).any()


def test_coordinate_overflow_error_names_the_file(tmp_path):
    (tmp_path / "far.xyz").write_text("0 0 0\n1e39 0 0\n")
    with pytest.raises(loom.FileError, match=r"far\.xyz"):
        loom.read_point_cloud(tmp_path / "far.xyz")
