"""Areas as polygons: the tiles they touch, the points they contain, and their coordinate systems."""

import json

import numpy as np
import pytest

import pointloom as loom
from pointloom.tiling.polygons import overlapping_boxes, parse_area, to_json
from pointloom.tiling.status import tile_status

from .scenes import CORNER, SIDE, in_memory, plan_of, read_cloud, rows_of, survey, tiled

OUTER = np.array([[2.5, 3], [38, 5], [33, 36], [12, 31]])
HOLE = np.array([[15, 12], [25, 14], [20, 24]])
OTHER = np.array([[30, 30], [39.9, 30], [39.9, 39.9]])


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    return survey(tmp_path_factory.mktemp("survey"))


def geojson(*polygons):
    geometries = [{"type": "Polygon", "coordinates": [[*map(list, [*ring, ring[0]])] for ring in p]} for p in polygons]
    features = [{"type": "Feature", "properties": {}, "geometry": geometry} for geometry in geometries]
    return {"type": "FeatureCollection", "features": features}


def moved(*rings):
    return [(ring + CORNER[:2]).tolist() for ring in rings]


@pytest.mark.parametrize("size", [20.0, pytest.param(6.0, marks=pytest.mark.slow)])
def test_points_in_polygons_match_one_machine(files, tmp_path, size):
    polygons = geojson(moved(OUTER, HOLE), moved(OTHER))
    for invert in (False, True):
        step = {"step": "crop", "polygon": polygons, "invert": invert}
        result, plan = tiled(files, [step], tmp_path / f"job{invert}", size=size)
        cloud = read_cloud(files, np.array(plan["origin"]))
        rings = [np.pad(ring, ((0, 0), (0, 1))) for ring in moved(OUTER, HOLE, OTHER)]
        volumes = [loom.SelectionPolygonVolume(ring, "Z", -1e9, 1e9) for ring in rings]
        inside = [np.isin(np.arange(len(cloud)), volume.crop_in_polygon(cloud)) for volume in volumes]
        keep = (inside[0] ^ inside[1]) | inside[2]
        np.testing.assert_array_equal(rows_of(result), rows_of(cloud.select_by_mask(keep != invert)))
        assert 0 < keep.sum() < len(cloud)


def test_only_tiles_that_polygons_touch_are_computed(files, tmp_path):
    (tmp_path / "area.geojson").write_text(json.dumps(geojson(moved(OUTER, HOLE))))
    steps = [{"step": "remove_radius_outlier", "nb_points": 3, "radius": 1.5}]
    loom.tiling.plan_tiles(files, steps, tmp_path / "job", size=7.0, only=tmp_path / "area.geojson")
    assert loom.tiling.run_tiles(tmp_path / "job").is_finished
    result = read_cloud([loom.tiling.finish_tiles(tmp_path / "job")], np.array(plan_of(tmp_path / "job")["origin"]))
    cloud, plan = read_cloud(files, result.origin), plan_of(tmp_path / "job")
    filtered = in_memory(cloud, steps, plan["voxel_low"])
    cells = np.floor((filtered.points[:, :2] - plan["corner"]) / plan["size"]).clip(0, np.array(plan["shape"]) - 1)
    lows = np.array(plan["corner"]) + cells * plan["size"]
    meets = overlapping_boxes([[OUTER + CORNER[:2], HOLE + CORNER[:2]]], lows, lows + plan["size"])
    np.testing.assert_array_equal(rows_of(result), rows_of(filtered.select_by_mask(meets)))
    assert 0 < meets.sum() < len(filtered)
    status = loom.tiling.plan_tiles(files, steps, tmp_path / "other", size=7.0, only=moved(HOLE)[0])
    assert status.waiting < 16 < tile_status(tmp_path / "job").done


def test_overlapping_boxes_match_a_fine_raster():
    rng = np.random.default_rng(3)
    for _ in range(8):
        ring, hole = rng.random((7, 2)) * 10, rng.random((4, 2)) * 10
        lows = np.stack(np.meshgrid(np.arange(10), np.arange(10)), axis=-1).reshape(-1, 2).astype(float)
        overlaps = overlapping_boxes([[ring, hole]], lows, lows + 1)
        positions = (np.stack(np.meshgrid(np.arange(400), np.arange(400)), axis=-1).reshape(-1, 2) + 0.5) / 40
        odd = np.zeros(len(positions), bool)
        for corners in (ring, hole):
            for a, b in zip(np.roll(corners, 1, axis=0), corners, strict=True):
                spans = (a[1] < positions[:, 1]) != (b[1] < positions[:, 1])
                with np.errstate(all="ignore"):
                    odd ^= spans & (a[0] + (positions[:, 1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) < positions[:, 0])
        cells = (positions[odd] // 1).astype(int)
        covered = np.zeros(100, bool)
        covered[cells[:, 1] * 10 + cells[:, 0]] = True
        assert not (covered & ~overlaps).any()
        assert (overlaps & ~covered).sum() < 30  # edges pass through some without covering them


def test_all_formats_of_an_area_give_the_same_area(tmp_path):
    ring = [[1.0, 2.0], [5.0, 2.0], [3.0, 6.5]]
    closed = [*ring, ring[0]]
    text = "POLYGON Z ((1 2 7, 5 2 7, 3 6.5 8, 1 2 7))"
    (tmp_path / "a.wkt").write_text(text)
    (tmp_path / "a.json").write_text(json.dumps({"type": "Polygon", "coordinates": [closed]}))
    forms = [ring, closed, text, "SRID=25832;MULTIPOLYGON(((1 2,5 2,3 6.5,1 2)))", str(tmp_path / "a.wkt")]
    forms += [tmp_path / "a.json", {"type": "MultiPolygon", "coordinates": [[closed]]}, [[ring]], np.array(ring)]
    for form in forms:
        assert to_json(parse_area("area", form)) == [[ring]]


@pytest.mark.parametrize(
    ("area", "message"),
    [
        ([[0, 0], [1, 1]], "at least three corners"),
        ([[0, 0], [1, np.nan], [2, 2]], "finite"),
        ("POINT(1 2)", "expected GeoJSON"),
        ("POLYGON((1 2, 3 x, 4 5))", "not well-known text"),
        ("[[0, 0], [1, 0], [1, 1]]", "expected an object of GeoJSON"),
        ({"type": "LineString", "coordinates": [[0, 0], [1, 1]]}, "expected polygons, got a 'LineString'"),
        ({"type": "FeatureCollection", "features": []}, "at least one polygon"),
        ({"type": "Polygon"}, "without 'coordinates'"),
        ("nowhere.geojson", "nowhere.geojson.*cannot be read"),
    ],
)
def test_invalid_areas_are_rejected(files, tmp_path, area, message):
    with pytest.raises((ValueError, loom.FileError), match=message):
        loom.tiling.plan_tiles(files, [{"step": "crop", "polygon": area}], tmp_path / "job")
    with pytest.raises((ValueError, loom.FileError), match=message):
        loom.tiling.plan_tiles(files, [], tmp_path / "job", only=area)


def test_areas_in_degrees_are_transformed_to_the_survey_if_their_crs_is_given(tmp_path):
    pyproj = pytest.importorskip("pyproj")
    import laspy

    from pointloom.io.points.las_writer import write_las
    from pointloom.io.table import PointTable

    points = np.random.default_rng(0).random((2000, 3)) * (SIDE, SIDE, 1) + CORNER
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = [1e-3] * 3, CORNER
    header.add_crs(pyproj.CRS("EPSG:25832"))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.write(tmp_path / "a.laz")
    write_las(tmp_path / "none.laz", PointTable(points))
    back = pyproj.Transformer.from_crs("EPSG:25832", "EPSG:4326", always_xy=True)
    degrees = np.column_stack(back.transform(*(OUTER + CORNER[:2]).T))
    step = {"step": "crop", "polygon": degrees.tolist(), "polygon_crs": "EPSG:4326"}
    result, _ = tiled([tmp_path / "a.laz"], [step], tmp_path / "job", size=21.0)
    straight, _ = tiled([tmp_path / "a.laz"], [{"step": "crop", "polygon": moved(OUTER)[0]}], tmp_path / "b", size=41.0)
    assert abs(len(result) - len(straight)) <= 1 and 500 < len(result) < 1900
    with pytest.raises(ValueError, match=r"^steps:.*4326"):
        loom.tiling.plan_tiles(tmp_path / "a.laz", [step | {"polygon_crs": None}], tmp_path / "x")
    with pytest.raises(ValueError, match=r"^steps:.*0"):
        loom.tiling.plan_tiles(tmp_path / "a.laz", [step | {"polygon_crs": "EPSG:0"}], tmp_path / "x")
    with pytest.raises(loom.FileError, match=r"/none\.laz:"):
        loom.tiling.plan_tiles(tmp_path / "none.laz", [step], tmp_path / "x")
    with pytest.raises(ValueError, match="only_crs:"):
        loom.tiling.plan_tiles(tmp_path / "a.laz", [], tmp_path / "x", only=(0, 0, 1, 1), only_crs="EPSG:4326")


def nested(count, inner):
    for _ in range(count):
        inner = {"type": "GeometryCollection", "geometries": [inner]}
    return inner


SQUARE = {"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1]]]}
DAMAGED = {
    "a ring of a number": '{"type": "Polygon", "coordinates": [[1.5]]}',
    "a corner of a word": '{"type": "Polygon", "coordinates": [[[0, 0], ["x", 1], [1, 1]]]}',
    "corners of two lengths": '{"type": "Polygon", "coordinates": [[[0, 0], [1], [1, 1]]]}',
    "coordinates of a number": '{"type": "Polygon", "coordinates": 7}',
    "a number of 400 digits": '{"type": "Polygon", "coordinates": [[[0, 0], [1%s, 1], [1, 1]]]}' % ("0" * 400),
    "a list for a type": '{"type": [], "coordinates": []}',
    "features of a number": '{"type": "FeatureCollection", "features": 1}',
    "a feature of nothing": '{"type": "FeatureCollection", "features": [null]}',
    "a corner of one number": "POLYGON((0 0, 1, 1 1))",
    "brackets in each other": "POLYGON(" + "(" * 100_000 + ")" * 100_000 + ")",
    "lists in each other": "[" * 100_000,
    "collections in each other": json.dumps(nested(300, SQUARE)),
}


@pytest.mark.parametrize("text", DAMAGED.values(), ids=DAMAGED)
def test_a_damaged_area_is_an_error_that_names_the_file(tmp_path, text):
    path = tmp_path / "area.geojson"
    path.write_text(text)
    with pytest.raises(loom.FileError, match=r"area\.geojson"):
        parse_area("only", path)
    with pytest.raises(ValueError, match="only"):
        parse_area("only", text)


@pytest.mark.parametrize("before", ["", "SRID=1;", "POLYGON", "MULTIPOLYGON Z"])
def test_an_area_is_read_in_linear_time(before):
    """A quadratic parser would take minutes."""
    blanks = " " * 1_000_000
    with pytest.raises(ValueError, match="only"):
        parse_area("only", f"{blanks}{before}{blanks}x{blanks}")
    assert len(parse_area("only", blanks + json.dumps(nested(50, SQUARE)) + blanks)) == 1
