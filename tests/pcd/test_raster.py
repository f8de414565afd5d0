"""Rasters: arithmetic on a common grid, GeoTIFF, contour lines and profiles agree with formulas and contourpy."""

import dataclasses
import itertools
import sys

import contourpy
import numpy as np
import pyproj
import pytest
import rasterio

import pointloom as loom
from pointloom.core.units import UnitWarning
from pointloom.pcd import geotiff
from pointloom.pcd.contour_files import joined_lines
from pointloom.pcd.contours import trace_contours

EAST, NORTH = 412_300.0, 5_651_200.0
SHIFT = np.array([EAST, NORTH, 0.0])


def plane(rng, *, shift=(0.0, 0.0), height=0.0, count=4000, **options):
    """A plane at UTM coordinates with the height of its points as x / 10."""
    x, y = rng.uniform(0, 20, (2, count)) + np.array(shift)[:, None]
    return loom.PointCloud(np.column_stack([EAST + x, NORTH + y, 100 + 0.1 * x + height]), **options)


def test_rasters_of_two_surveys_have_one_grid_and_subtract(rng):
    before = loom.rasterize(plane(rng), 0.5, "lowest")
    after = loom.rasterize(plane(rng, shift=(3.3, -4.2), height=2.0), 0.5, "lowest")
    assert not np.mod(np.concatenate([before.corner, after.corner]), 0.5).any()
    change = after - before
    low = np.maximum(before.corner, after.corner)
    high = np.minimum(before.bounds[2:], after.bounds[2:])
    assert change.bounds == (*low, *high) and change.kind == "difference"
    assert np.nanmedian(change.values) == pytest.approx(2.0, abs=0.01)
    rows, columns = change.values.shape
    for row, column in ((0, 0), (rows - 1, columns - 1), (rows // 2, 3)):
        x, y = low[0] + (column + 0.5) * 0.5, high[1] - (row + 0.5) * 0.5
        values = []
        for raster in (before, after):
            k = int((raster.bounds[3] - y) / 0.5), int((x - raster.corner[0]) / 0.5)
            values.append(float(raster.values[k]))
        assert change.values[row, column] == np.float32(values[1] - values[0]) or np.isnan(sum(values))
    np.testing.assert_array_equal((before + change).values, (change + before).values)
    np.testing.assert_array_equal((before + 2).values, (before - -2.0).values)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"cell": 0.25}, r"expected one grid, got cells of 0\.5 .* and cells of 0\.25"),
        ({"corner": (0.1, 0.0)}, r"Create both with one cell and corner, as in rasterize\(cloud, 0\.5, corner="),
        ({"crs": "EPSG:25833"}, "expected one coordinate system, got EPSG:25832 and EPSG:25833"),
        ({"shift": (500.0, 0.0)}, "expected rasters that overlap"),
    ],
)
def test_different_grids_are_an_error_that_names_both(rng, options, message):
    shift = options.pop("shift", (0.0, 0.0))
    first = loom.rasterize(plane(rng), 0.5, "dsm", crs="EPSG:25832")
    second = loom.rasterize(plane(rng, shift=shift), kind="dsm", **({"cell": 0.5, "crs": "EPSG:25832"} | options))
    for call in (lambda: first - second, lambda: first + second):
        with pytest.raises(ValueError, match=message):
            call()


def test_different_units_warn_and_other_operands_raise(rng):
    first, second = (loom.rasterize(plane(rng, unit=unit), 1.0, "dsm") for unit in ("metre", "foot"))
    with pytest.warns(UnitWarning, match="metre and foot"):
        assert (first - second).unit is None
    for call in (lambda: first - "a", lambda: first + first.values, lambda: first - None):
        with pytest.raises(TypeError, match="expected a Raster or a number"):
            call()
    with pytest.raises(TypeError):
        first.values + first
    with pytest.raises(ValueError, match="finite"):
        first + float("nan")


@pytest.mark.parametrize("crs", [None, "EPSG:26910", "EPSG:2225", "EPSG:25832+7837"])
@pytest.mark.parametrize(("cell", "corner"), [(1.0, (0, 0)), (0.3, (0, 0)), (0.1, (0.13, 0.77))])
def test_a_geotiff_is_read_bit_for_bit(rng, tmp_path, crs, cell, corner):
    raster = loom.rasterize(plane(rng, count=300), cell, "dsm", corner=corner, crs=crs).fill_gaps(0.5)
    path = raster.write(tmp_path / "a.tif")
    found = loom.read_raster(path)
    np.testing.assert_array_equal(found.values, raster.values)
    np.testing.assert_array_equal(found.filled, raster.filled)
    np.testing.assert_array_equal(found.corner, raster.corner)
    assert (found.cell, found.kind, found.nodata) == (cell, "dsm", raster.nodata)
    assert (found.crs is None) == (crs is None) and (found - raster).values.shape == raster.values.shape
    assert found.unit == {None: None, "EPSG:2225": "US survey foot"}.get(crs, "metre")
    assert found.write(tmp_path / "b.tif").read_bytes() == path.read_bytes()


def write_tif(path, bands, **changes):
    profile = {
        "driver": "GTiff", "height": bands.shape[1], "width": bands.shape[2], "count": len(bands),
        "dtype": bands.dtype, "transform": rasterio.Affine(2.0, 0, EAST, 0, -2.0, NORTH), "crs": "EPSG:25832",
    }  # fmt: skip
    with rasterio.open(path, "w", **(profile | changes)) as file:
        file.write(bands)
    return path


def test_rasters_of_other_programs_are_read(tmp_path):
    stored = np.arange(12, dtype=np.int16).reshape(1, 3, 4)
    found = loom.read_raster(write_tif(tmp_path / "a.tif", stored, nodata=5))
    expected = np.where(stored[0] == 5, np.nan, stored[0].astype(np.float32))
    np.testing.assert_array_equal(found.values, expected)
    assert found.bounds == (EAST, NORTH - 6, EAST + 8, NORTH) and (found.crs, found.unit) == ("EPSG:25832", "metre")
    path = write_tif(tmp_path / "b.tif", stored)
    with rasterio.open(path, "r+") as file:
        file.scales, file.offsets = (0.01,), (100.0,)
    np.testing.assert_allclose(loom.read_raster(path).values, 100 + 0.01 * stored[0], rtol=1e-6)


@pytest.mark.parametrize(
    ("bands", "changes", "message"),
    [
        (3, {}, "expected one band, got 3"),
        (1, {"transform": rasterio.Affine(2, 0, 0, 0, -3, 0)}, "expected square cells"),
        (1, {"transform": rasterio.Affine(2, 0, 0, 0, 2, 0)}, "expected square cells"),
        (1, {"transform": rasterio.Affine(2, 1, 0, 0, -2, 0)}, "expected square cells"),
        (1, {"dtype": "complex64"}, "expected real values"),
    ],
)
def test_unsupported_rasters_are_errors(tmp_path, bands, changes, message):
    path = write_tif(tmp_path / "a.tif", np.zeros((bands, 3, 4), changes.get("dtype", "f4")), **changes)
    with pytest.raises(loom.FileError, match=message):
        loom.read_raster(path)


def test_damaged_files_and_other_names_are_errors(rng, tmp_path, monkeypatch):
    path = loom.rasterize(plane(rng), 0.2, "dsm").write(tmp_path / "a.tif")
    content = path.read_bytes()
    for damaged in (b"", content[:100], content[: len(content) // 2], b"II*\0" + bytes(100)):
        path.write_bytes(damaged)
        with pytest.raises(loom.FileError, match=r"not an intact GeoTIFF|has no georeference"):
            loom.read_raster(path)
    with pytest.raises(loom.FileError, match="not a GeoTIFF file name"):
        loom.read_raster(tmp_path / "a.png")
    monkeypatch.setitem(sys.modules, "rasterio", None)
    with pytest.raises(loom.FileError, match="needs the package rasterio"):
        loom.read_raster(path)


@pytest.mark.parametrize("side", [1024, 8192])
def test_a_raster_without_blocks_takes_memory_of_its_file(tmp_path, monkeypatch, side):
    path = tmp_path / "a.tif"
    profile = {"driver": "GTiff", "height": side, "width": side, "count": 1, "dtype": "float32", "sparse_ok": True,
               "tiled": True, "blockxsize": 1024, "blockysize": 1024}  # fmt: skip
    with rasterio.open(path, "w", transform=rasterio.Affine(1, 0, 5, 0, -1, 5), **profile):
        pass
    if side == 1024:
        assert loom.read_raster(path).values.shape == (side, side)
        monkeypatch.setattr(geotiff, "_fields_of", lambda file: np.empty(1 << 58))
    with pytest.raises(loom.FileError, match=r"a\.tif: (needs more memory|8,192 x 8,192 cells do not fit into)"):
        loom.read_raster(path)


def test_a_value_that_equals_nodata_is_not_written_as_a_gap(rng, tmp_path):
    raster = loom.rasterize(plane(rng), 5.0, "dsm")
    raster = dataclasses.replace(raster, nodata=float(raster.values[0, 0]))
    with pytest.raises(loom.FileError, match="a value equals nodata"):
        raster.write(tmp_path / "a.tif")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("kind", ["smooth", "ties", "gaps"])
def test_contour_lines_are_those_of_contourpy(rng, kind):
    for _ in range(60):
        heights = rng.normal(size=rng.integers(2, 9, 2))
        level = float(rng.normal())
        if kind == "ties":
            heights, level = np.round(heights * 2) / 2, round(level * 2) / 2
        if kind == "gaps":
            heights[rng.random(heights.shape) < 0.1] = np.nan
        found = trace_contours(heights, np.zeros(2), 1.0, np.array([level]))
        grid = contourpy.contour_generator(z=np.ma.masked_invalid(heights), name="serial", corner_mask=False)
        expected = {
            tuple(sorted(map(tuple, np.round(pair, 9) + 0.0)))
            for line in grid.lines(level)
            for pair in itertools.pairwise(line)
        }
        ends = {tuple(sorted(map(tuple, np.round(found.points[pair][:, :2], 9) + 0.0))) for pair in found.lines}
        assert ends == {pair for pair in expected if pair[0] != pair[1]}
        assert (found.points[:, 2] == level).all()


def test_contour_lines_have_float64_coordinates_and_close_around_a_hill():
    x, y = np.mgrid[0:40, 0:40].reshape(2, -1) + 0.5
    hill = loom.PointCloud(np.column_stack([EAST + x, NORTH + y, 50 - np.hypot(x - 20, y - 20)]))
    lines = loom.rasterize(hill, 1.0, "lowest").contour_lines(levels=[40.0])
    radii = np.hypot(lines.points[:, 0] - EAST - 20, lines.points[:, 1] - NORTH - 20)
    assert np.abs(radii - 10).max() < 0.02 and (np.bincount(lines.lines.ravel()) == 2).all()
    levels = np.unique(loom.rasterize(hill, 1.0, "lowest").contour_lines(2.5).points[:, 2])
    np.testing.assert_array_equal(levels, np.arange(22.5, 50.0, 2.5))
    raster = loom.rasterize(hill, 1.0, "lowest")
    for options in (
        {},
        {"interval": 1.0, "levels": [1.0]},
        {"interval": 0.0},
        {"interval": 1e-9},
        {"levels": [np.inf]},
    ):
        with pytest.raises(ValueError, match=r"interval|levels"):
            raster.contour_lines(**options)
    empty = dataclasses.replace(raster, values=np.full((5, 5), np.nan, np.float32), filled=np.zeros((5, 5), bool))
    assert not len(empty.contour_lines(1.0).lines)


@pytest.mark.parametrize("ending", [".gpkg", ".geojson", ".dxf"])
def test_files_of_contours_have_one_line_per_contour_and_its_height(ending, tmp_path):
    pyogrio = pytest.importorskip("pyogrio")
    x, y = np.mgrid[0:40, 0:30].reshape(2, -1) + 0.5
    hill = loom.PointCloud(np.column_stack([EAST + x, NORTH + y, 50 - np.hypot(x - 20, y - 15)]))
    raster = loom.rasterize(hill, 1.0, "lowest", crs="EPSG:25832")
    path = raster.write_contours(tmp_path / f"lines{ending}", 5.0)
    first = path.read_bytes()
    assert raster.write_contours(path, 5.0).read_bytes() == first  # reproducible, and replaced
    with pytest.raises(loom.FileError, match="exists already"):
        raster.write_contours(path, 5.0, overwrite=False)

    meta, _, geometries, fields = pyogrio.raw.read(path)
    lines = [np.frombuffer(each[9:], "<f8").reshape(-1, 3) for each in geometries]
    expected = joined_lines(raster.contour_lines(5.0))
    assert [len(line) for line in lines] == [len(line) for line in expected]
    assert {line[0, 2] for line in lines} == {30.0, 35.0, 40.0, 45.0}
    rings = [line for line in lines if (line[0] == line[-1]).all()]
    assert sorted(line[0, 2] for line in rings) == [40.0, 45.0]  # the lower ones end at the border
    if ending != ".dxf":
        np.testing.assert_array_equal(fields[0], [line[0, 2] for line in lines])
    if ending == ".geojson":
        east, north = pyproj.Transformer.from_crs("EPSG:25832", "EPSG:4326", always_xy=True).transform(
            *np.concatenate(expected)[:, :2].T
        )
        np.testing.assert_allclose(np.concatenate(lines)[:, :2], np.column_stack([east, north]), atol=1e-9)
    else:
        digits = 1e-8 if ending == ".dxf" else 0  # DXF has 15 digits
        np.testing.assert_allclose(np.concatenate(lines), np.concatenate(expected), rtol=0, atol=digits)
    assert meta["crs"] == {".gpkg": "EPSG:25832", ".geojson": meta["crs"], ".dxf": None}[ending]


def test_joined_lines_contain_each_segment_once(rng):
    for _ in range(30):
        heights = np.round(rng.normal(size=rng.integers(2, 12, 2)) * 2) / 2  # ties: nodes with three and four lines
        lines = trace_contours(heights, np.zeros(2), 1.0, np.array([-0.5, 0.0, 0.5]))
        found = [
            tuple(sorted([tuple(a), tuple(b)])) for line in joined_lines(lines) for a, b in itertools.pairwise(line)
        ]
        segments = [tuple(sorted(map(tuple, lines.points[pair]))) for pair in lines.lines]
        assert sorted(found) == sorted(segments)


def test_contours_name_the_remedy_if_they_cannot_be_written(tmp_path, monkeypatch):
    raster = loom.rasterize(loom.PointCloud(np.random.default_rng(0).random((99, 3))), 0.25, "lowest")
    for name in ("lines.shp", "lines", "lines.json"):
        with pytest.raises(loom.FileError, match=r"expected \.gpkg, \.geojson, \.dxf"):
            raster.write_contours(tmp_path / name, 0.1)
    pytest.importorskip("pyogrio")
    with pytest.raises(loom.FileError, match="is unknown"):
        dataclasses.replace(raster, crs="EPSG:1").write_contours(tmp_path / "lines.gpkg", 0.1)
    assert not [*tmp_path.iterdir()]
    empty = dataclasses.replace(raster, values=np.full_like(raster.values, np.nan))
    assert empty.write_contours(tmp_path / "empty.gpkg", 0.1).stat().st_size
    monkeypatch.setitem(sys.modules, "pyogrio", None)
    with pytest.raises(loom.FileError, match=r'needs the package pyogrio\. pip install "pointloom\[geo\]"'):
        raster.write_contours(tmp_path / "lines.gpkg", 0.1)


def test_profile_of_a_raster_is_bilinear(rng):
    x, y = np.mgrid[0:30, 0:20].reshape(2, -1) + 0.5
    raster = loom.rasterize(loom.PointCloud(np.column_stack([EAST + x, NORTH + y, 0.1 * x - 0.2 * y])), 1.0, "lowest")
    line = np.array([[2.0, 3.0], [10.0, 9.0], [10.0, 9.0], [25.0, 9.0]]) + SHIFT[:2]
    found = loom.profile(raster, line, spacing=0.7)
    assert found.distances[-1] == 25.0 and np.allclose(np.diff(found.distances[:-1]), 0.7) and found.indices is None
    expected = 0.1 * (found.points[:, 0] - EAST) - 0.2 * (found.points[:, 1] - NORTH)
    np.testing.assert_allclose(found.heights, expected, atol=1e-6)
    steps = np.hypot(*np.diff(found.points[:, :2], axis=0).T)
    assert (steps <= 0.7 + 1e-9).all() and len(loom.profile(raster, line).distances) == 26
    outside = loom.profile(raster, [[EAST - 5, NORTH + 5], [EAST + 5, NORTH + 5]])
    assert np.isnan(outside.heights[:6]).all() and np.isfinite(outside.heights[6:]).all()


def test_profile_of_a_cloud_agrees_with_brute_force(rng):
    points = rng.uniform(0, 10, (2000, 3)) + SHIFT
    points[5, 2] = np.nan
    line = np.array([[1.0, 1.0], [8.0, 3.0], [4.0, 9.0]]) + SHIFT[:2]
    cloud = loom.PointCloud(points)
    found = loom.profile(cloud, line, width=1.2)
    at, begin, expected = cloud.points, 0.0, {}
    for number, (a, b) in enumerate(itertools.pairwise(line)):
        length = np.hypot(*(b - a))
        for k, p in enumerate(at):
            along = (p[:2] - a) @ (b - a) / length
            if (number == 0 and along < 0) or (number == 1 and along > length) or not np.isfinite(p[2]):
                continue
            along = min(max(along, 0), length)
            distance = np.hypot(*(p[:2] - a - along * (b - a) / length))
            if distance <= 0.6 and distance < expected.get(k, (np.inf,))[0]:
                expected[k] = distance, begin + along
        begin += length
    assert sorted(found.indices.tolist()) == sorted(expected) and len(expected) > 50
    for k, distance, offset in zip(found.indices, found.distances, found.offsets, strict=True):
        assert (abs(offset), distance) == pytest.approx(expected[k], abs=1e-9)
    assert (np.diff(found.distances) >= 0).all() and np.array_equal(found.points, at[found.indices])
    left = loom.profile(loom.PointCloud([[5, 1, 0], [5, -1, 0]]), [[0, 0], [10, 0]], width=4)
    assert left.offsets.tolist() == [1.0, -1.0]
