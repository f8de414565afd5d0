"""Areas, volumes and profiles against closed forms, at UTM coordinates."""

import math

import numpy as np
import pytest

from pointloom.core.units import DEGREE, FOOT, METRE
from pointloom.drawing.viewer.tools.areas import area_rows, measure_polygon, quantity_text
from pointloom.drawing.viewer.tools.heaps import heap_rows, measure_heap, usual_cell
from pointloom.drawing.viewer.tools.profiles import (
    middle_line,
    profile_along,
    profile_csv,
    profile_picture,
    profile_rows,
)

UTM = np.array([412_345.0, 5_412_345.0, 300.0])


def turned(points, slope, heading=0.0):
    """Tilted about y, then turned about z."""
    c, s, d, e = math.cos(slope), math.sin(slope), math.cos(heading), math.sin(heading)
    tilt = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    return np.asarray(points, float) @ tilt.T @ np.array([[d, -e, 0], [e, d, 0], [0, 0, 1]]).T


def square(side, height=0.0):
    half = side / 2
    return np.array([[-half, -half, height], [half, -half, height], [half, half, height], [-half, half, height]])


def even(side, step):
    """Places of a square about zero."""
    ends = np.arange(-side / 2 + step / 2, side / 2, step)
    return (a.ravel() for a in np.meshgrid(ends, ends))


def test_a_tilted_polygon_has_its_own_area_and_that_of_a_map():
    found = measure_polygon(turned(square(4), math.radians(60), 0.3) + UTM)
    assert found.area == pytest.approx(16, rel=1e-8) and found.from_above == pytest.approx(8, rel=1e-8)
    assert found.perimeter == pytest.approx(16, rel=1e-8) and found.slope == pytest.approx(60, abs=1e-6)
    assert found.surface == pytest.approx(16, rel=1e-8) and found.off_plane < 1e-8 and not found.crosses


def test_a_hollow_polygon_has_the_area_of_its_triangles_and_not_of_a_fan():
    comb = [[0, 0, 0], [5, 0, 0], [5, 4, 0], [4, 4, 0], [4, 1, 0], [3, 1, 0], [3, 4, 0], [2, 4, 0], [2, 1, 0]]
    comb += [[1, 1, 0], [1, 4, 0], [0, 4, 0]]
    for corners in (np.array(comb), np.array(comb)[::-1], np.roll(comb, 7, axis=0)):
        found = measure_polygon(turned(corners, 0.7, 1.1) + UTM)
        assert found.area == pytest.approx(14, rel=1e-7) and found.surface == pytest.approx(14, rel=1e-7)


def test_a_roof_has_more_area_than_its_plane_and_says_so():
    roof = np.array([[0, 0, 0], [4, 0, 0], [4, 3, 3.0], [4, 6, 0], [0, 6, 0], [0, 3, 3]])
    found = measure_polygon(roof + UTM)
    assert found.from_above == pytest.approx(24) and found.surface == pytest.approx(24 * math.sqrt(2))
    assert "over its triangles" in dict(area_rows(found, METRE)) and found.off_plane > 1


def test_sides_that_cross_are_told():
    found = measure_polygon([[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 2.5, 0]])
    assert found.crosses and math.isnan(found.surface) and "its sides cross" in dict(area_rows(found, None))


def test_areas_are_in_the_unit_of_the_data():
    found = measure_polygon(square(2))
    assert dict(area_rows(found, FOOT))["area"] == "4.0000 ft²"
    assert dict(area_rows(found, None))["area"] == "4.0000 square units"
    assert quantity_text(2.5e9, METRE, 3) == "2,500,000,000 m³"
    with pytest.raises(ValueError, match="project_to_utm"):
        area_rows(found, DEGREE)


@pytest.mark.parametrize(
    "bad", [[[0, 0, 0], [1, 1, 1]], [[0, 0, 0], [1, 1, 1], [2, 2, 2]], [[0, 0, 0], [1, 0, 0], [0, np.nan, 0]]]
)
def test_what_has_no_area_is_refused(bad):
    with pytest.raises(ValueError, match="points"):
        measure_polygon(bad)


def test_a_box_has_its_volume_where_the_polygon_cuts_through_cells():
    x, y = even(12, 0.05)
    inside = (np.abs(x) < 2.03) & (np.abs(y) < 2.03)
    points = np.column_stack([x, y, np.where(inside, 3.0, 0.0)]) + UTM
    found = measure_heap(points, square(4.06) + UTM, cell=0.17)
    assert found.cut == pytest.approx(4.06**2 * 3, rel=1e-6) and found.fill == 0 and found.empty == 0
    assert found.area == pytest.approx(4.06**2, rel=1e-9)


def test_a_pyramid_on_a_slope_has_a_third_of_its_box():
    x, y = even(12, 0.04)
    slope = 0.3 * x - 0.2 * y
    heap = np.maximum(0.0, 4 * (1 - np.maximum(np.abs(x), np.abs(y)) / 5))
    corners = square(10)
    corners[:, 2] = 0.3 * corners[:, 0] - 0.2 * corners[:, 1]
    found = measure_heap(np.column_stack([x, y, slope + heap]) + UTM, corners + UTM, cell=0.2)
    assert found.cut == pytest.approx(100 * 4 / 3, rel=1e-3) and found.fill < 1e-6
    assert found.slope == pytest.approx(math.degrees(math.atan(math.hypot(0.3, 0.2))))


def test_cut_and_fill_are_told_apart():
    x, y = even(10, 0.05)
    mound, pit = np.hypot(x + 2, y), np.hypot(x - 2, y)
    z = np.sqrt(np.maximum(0, 2.25 - mound**2)) - np.sqrt(np.maximum(0, 1 - pit**2))
    found = measure_heap(np.column_stack([x, y, z]) + UTM, square(9) + UTM, cell=0.1, base=300.0)
    assert found.cut == pytest.approx(2 / 3 * math.pi * 1.5**3, rel=3e-3)  # hemispheres
    assert found.fill == pytest.approx(2 / 3 * math.pi, rel=3e-3) and found.net == found.cut - found.fill
    raised = measure_heap(np.column_stack([x, y, z]) + UTM, square(9) + UTM, cell=0.1, base=299.0)
    assert raised.net == pytest.approx(found.net + 81, rel=1e-9)


def test_a_hole_in_a_slope_is_spanned_and_told():
    x, y = even(10, 0.1)
    points = np.column_stack([x, y, 5 + 0.4 * x + 0.1 * y])
    hole = (np.abs(x - 1) < 1.5) & (np.abs(y) < 1)
    found = measure_heap(points[~hole] + UTM, square(10) + UTM, cell=0.2)
    assert found.net == pytest.approx(500, rel=1e-4) and found.empty == found.filled == pytest.approx(0.06, abs=0.01)
    left = measure_heap(points[~hole] + UTM, square(10) + UTM, cell=0.2, fill_empty=False)
    assert left.filled == 0 and left.net == pytest.approx(500 - 5 * 6 - 0.4 * 6, rel=0.02)
    rows = dict(heap_rows(found, METRE, coarser=left))
    assert "taken from the cells around" in rows["cells without points"] and rows["net"].endswith(" m³")
    assert "counted as nothing" in dict(heap_rows(left, None))["cells without points"]


def test_a_polygon_of_any_shape_has_its_area_in_cells(rng):
    angles = np.sort(rng.uniform(0, 2 * math.pi, 23))
    corners = np.column_stack([np.cos(angles), np.sin(angles), 0 * angles]) * rng.uniform(2, 6, 23)[:, None]
    places = np.column_stack([*(a for a in even(14, 0.05)), np.full(280 * 280, 1.0)])
    found = measure_heap(places + UTM, corners + UTM, cell=0.3, base=300.0)
    area = measure_polygon(corners + UTM).from_above
    assert found.area == pytest.approx(area, rel=2e-4) and found.cut == pytest.approx(area, rel=2e-4)


@pytest.mark.parametrize(
    ("polygon", "given", "words"),
    [
        (square(2)[:2], {}, "at least three"),
        (turned(square(2), math.pi / 2), {}, "one line"),
        (turned(square(2), math.radians(85)), {}, "slopes by 85 degrees"),
        (square(2) + 50, {}, "no point lies inside"),
        (square(2e6), {}, "give a larger side"),
        (square(2), {"cell": 0}, "cell"),
        (square(2), {"base": math.nan}, "base"),
    ],
)
def test_what_has_no_volume_is_refused(polygon, given, words):
    with pytest.raises(ValueError, match=words):
        measure_heap([[0, 0, 1], [np.nan, 0, 0]], polygon, **{"cell": 0.1, **given})


def test_cells_are_wide_enough_for_their_points():
    assert usual_cell(600, 100.0) == 1.0 and usual_cell(0, 1.0) > 1


def test_a_profile_follows_its_line_around_a_corner():
    x, y = even(20, 0.1)
    points = np.column_stack([x, y, 2 * x + y]) + UTM
    path = np.array([[-8.01, -8.01, 9], [5.99, -8.01, 0], [5.99, 3.99, 5.0]]) + UTM
    found = profile_along(points, path, width=0.5)
    np.testing.assert_allclose(found.corners, [0, 14, 26])
    east = found.distances < 13.5
    np.testing.assert_allclose(
        found.heights[east] - 300, 2 * (found.distances[east] - 8.01) - 8.01 + found.offsets[east]
    )
    north = found.distances > 14.5
    np.testing.assert_allclose(
        found.heights[north] - 300, 3.97 + found.distances[north] - 14 - 2 * found.offsets[north]
    )
    assert np.abs(found.offsets).max() <= 0.25 and (np.diff(found.distances) >= 0).all()
    assert len(np.unique(found.rows)) == len(found.rows) == pytest.approx(26 * 0.5 * 100, rel=0.02)


def test_nothing_beyond_the_ends_of_a_line_counts():
    found = profile_along(
        [[-0.1, 0, 1], [0, 0, 1], [5, 0.5, 1], [5, -0.51, 1], [10.1, 0, 1]], [[0, 0, 0], [10, 0, 7]], width=1
    )
    assert found.rows.tolist() == [1, 2] and found.offsets.tolist() == [0.0, 0.5]


def test_a_profile_is_told_drawn_and_written(rng):
    points = np.column_stack([rng.uniform(0, 10, 4000), rng.normal(0, 0.2, 4000), np.zeros(4000)]) + UTM
    points[:, 2] += 3 * (points[:, 0] - UTM[0])
    points = points[np.abs(points[:, 0] - UTM[0] - 5) > 1]
    found = profile_along(points, np.array([[0, 0, 0], [10, 0, 0]]) + UTM, width=0.6)
    rows = dict(profile_rows(found, METRE))
    assert rows["length"] == "10.0000 m, from above" and rows["without points"] == "20.0 % of the way"
    assert float(rows["from end to end"].split()[0]) == pytest.approx(30, abs=0.4)
    places, medians = middle_line(found)
    there = np.isfinite(medians)
    np.testing.assert_allclose(medians[there], 300 + 3 * places[there], atol=0.1)
    table = np.genfromtxt(
        profile_csv(found, points, np.arange(len(points))).decode().splitlines(), delimiter=",", names=True
    )
    np.testing.assert_allclose(table["x"], points[found.rows, 0], atol=1e-6)
    assert table["index"].astype(int).tolist() == found.rows.tolist()
    picture = profile_picture(found, METRE, colors=np.tile(np.array([[200, 0, 0]], np.uint8), (len(found.rows), 1)))
    assert picture.shape == (420, 900, 3) and ((picture[..., 0] > 190) & (picture[..., 1] < 150)).sum() > 1000


def test_a_profile_without_points_says_so():
    found = profile_along(np.zeros((0, 3)), [[0, 0, 0], [1, 0, 0]], width=1)
    assert dict(profile_rows(found, None))["heights"].startswith("none") and profile_picture(found, None).any()
    with pytest.raises(ValueError, match="above the other"):
        profile_along([[0, 0, 0]], [[0, 0, 0], [0, 0, 5]], width=1)
