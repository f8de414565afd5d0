"""Volumes between epochs agree with analytic shapes and float64 sums, and their uncertainty with repeated surveys."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.core.units import UnitWarning

EAST, NORTH = 412_300.0, 5_651_200.0
PILE = 3 * np.pi * 64  # of 3 exp(-(x^2 + y^2) / 8^2)


def epoch(rng, pile, *, count=60_000, noise=0.0, device="cpu", **options):
    x, y = rng.uniform(0, 60, (2, count)) + rng.uniform(-0.4, 0.4, (2, 1))
    z = (
        100
        + 0.02 * x
        + pile * 3 * np.exp(-(((x - 30) / 8) ** 2) - ((y - 30) / 8) ** 2)
        + noise * rng.normal(size=count)
    )
    return loom.PointCloud(np.column_stack([EAST + x, NORTH + y, z]), device=device, **options)


@pytest.mark.parametrize("noise", [0.0, 0.05])
def test_the_volume_of_a_pile_is_within_its_uncertainty(device, rng, noise):
    found = loom.volume_change(*(epoch(rng, pile, noise=noise, device=device) for pile in (0, 1)), 1.0)
    assert (
        found.reliable and abs(found.net - PILE) < max(1.5 * found.net_uncertainty, 1.0) and found.net_uncertainty < 5
    )
    assert found.net == pytest.approx(found.fill - found.cut) and found.significant_fill == pytest.approx(
        PILE, rel=0.02
    )
    back = loom.volume_change(epoch(rng, 1, device=device), epoch(rng, 0, device=device), 1.0)
    assert back.cut == pytest.approx(PILE, rel=0.01) and back.significant_cut == pytest.approx(PILE, rel=0.01)


@pytest.mark.parametrize("corner", [(0.0, 0.0), (0.25, 0.75)])
def test_the_corner_is_one_of_a_cell(corner):
    x, y = (axis.ravel() + 0.5 for axis in np.meshgrid(np.arange(12.0), np.arange(12.0)))
    before = loom.PointCloud(np.column_stack([x, y, 0 * x]))
    found = loom.volume_change(before, before.translate([0, 0, 0.5]), 1.0, corner=corner)
    np.testing.assert_allclose(np.mod(found.difference.corner, 1), corner)
    assert found.net == pytest.approx(0.5 * found.area)


def test_rasters_and_meshes_are_compared_with_clouds(rng):
    clouds = [epoch(rng, pile, classification=np.full(60_000, 2, np.uint8)) for pile in (0, 1)]
    rasters = [loom.rasterize(cloud, 1.0) for cloud in clouds]
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(-1, 61, 125), np.linspace(-1, 61, 125)))
    rows = np.arange(124 * 125).reshape(124, 125)[:, :124].ravel()
    halves = [rows, rows + 1, rows + 126], [rows, rows + 126, rows + 125]
    triangles = np.concatenate([np.column_stack(corners) for corners in halves])
    z = 100 + 0.02 * x + 3 * np.exp(-(((x - 30) / 8) ** 2) - ((y - 30) / 8) ** 2)
    mesh = loom.TriangleMesh(np.column_stack([EAST + x, NORTH + y, z]), triangles)
    for before, after, cell in (
        (*rasters, None),
        (clouds[0], rasters[1], None),
        (clouds[0], mesh, 1.0),
        (rasters[0], mesh, 1.0),
    ):
        found = loom.volume_change(before, after, cell)
        assert found.net == pytest.approx(PILE, rel=0.01)
    no_spread = loom.volume_change(*rasters)
    assert np.isnan([no_spread.net_uncertainty, no_spread.significant_fill]).all() and "unknown" in str(no_spread)
    known = loom.volume_change(*rasters, registration_error=0.01)
    assert known.net_uncertainty == pytest.approx(1.96 * 0.01 * known.area)


def test_each_cell_agrees_with_sums_in_float64(rng):
    clouds = [epoch(rng, pile, count=8000, noise=0.1) for pile in (0, 1)]
    found = loom.volume_change(*clouds, 2.0, registration_error=0.02, max_gap=0)
    statistics = []
    for cloud in clouds:
        points = cloud.points.astype(np.float64)
        column, row = np.floor(points[:, :2].T / 2).astype(int)
        cells = {}
        for key, z in zip(zip(column, row, strict=True), points[:, 2], strict=True):
            cells.setdefault(key, []).append(z)
        statistics.append({key: (np.mean(z), np.var(z, ddof=1) / len(z)) for key, z in cells.items() if len(z) >= 4})
    both = statistics[0].keys() & statistics[1].keys()
    difference = found.difference
    rows, checked = difference.values.shape[0], 0
    for column, row in both:
        j = column - round(difference.corner[0] / 2)
        i = rows - 1 - (row - round(difference.corner[1] / 2))
        (a, va), (b, vb) = (each[column, row] for each in statistics)
        assert difference.values[i, j] == pytest.approx(b - a, abs=2e-5)
        assert found.level_of_detection[i, j] == pytest.approx(1.96 * (np.sqrt(va + vb) + 0.02), rel=1e-4)
        checked += 1
    values = difference.values[np.isfinite(difference.values)].astype(np.float64)
    assert checked > 800 and found.net == pytest.approx(values.sum() * 4, rel=1e-5)
    assert found.cut == pytest.approx(-values[values < 0].sum() * 4, rel=1e-5) and found.area == len(values) * 4


def test_the_interval_contains_the_truth_as_often_as_stated():
    inside, runs = 0, 100
    for seed in range(runs):
        rng = np.random.default_rng(seed)
        offset = rng.normal(0, 0.01)
        x, y = rng.uniform(0, 12, (2, 2, 1000))
        z = 0.2 * x + 0.03 * rng.normal(size=x.shape) + np.array([[0], [0.05 + offset]])
        clouds = (loom.PointCloud(np.column_stack(rows)) for rows in zip(x, y, z, strict=True))
        found = loom.volume_change(*clouds, 1.0, registration_error=0.01)
        inside += abs(found.net - 0.05 * found.area) < found.net_uncertainty
    assert 88 <= inside <= 100  # binomial distribution of 0.95: fewer than 88 has a probability of 0.3 %


def test_gaps_are_interpolated_but_not_the_outside(rng):
    x, y = rng.uniform(0, 20, (2, 20_000))
    z = 0.1 * x
    hole = (np.abs(x - 10) < 1.4) & (np.abs(y - 10) < 1.4)
    full, holed = (loom.PointCloud(np.column_stack([x, y, z])[mask]) for mask in (hole | ~hole, ~hole))
    found = loom.volume_change(full, holed, 1.0)
    assert found.interpolated_area == 4.0 and abs(found.net) < 0.1 and found.missing_area == 0
    none = loom.volume_change(full, holed, 1.0, max_gap=0)
    assert none.interpolated_area == 0 and none.missing_area == 4.0 and none.area == 396.0
    corner = loom.PointCloud(np.column_stack([x, y, z])[(x < 10) | (y < 10)])
    assert loom.volume_change(full, corner, 1.0).area == 300.0
    few = loom.PointCloud(np.column_stack([x, y, z])[(x < 10) & (y < 2) | (x > 19) & (y > 19)])
    assert "only 21 of 400 cells have a height in both epochs" in loom.volume_change(full, few, 1.0).warnings[0]


def test_ground_classes_systems_and_units_are_checked(rng):
    before, after = (epoch(rng, pile, count=4000) for pile in (0, 1))
    classes = np.where(np.arange(4000) < 3000, 2, 5).astype(np.uint8)
    high = loom.PointCloud(after.points + np.where(classes == 5, 9, 0)[:, None] * [0, 0, 1.0], classification=classes)
    with pytest.raises(ValueError, match="before: expected ground points"):
        loom.volume_change(before, high, 2.0)
    ground = loom.PointCloud(before.points, classification=np.full(4000, 2, np.uint8))
    assert loom.volume_change(ground, high, 2.0).net == pytest.approx(PILE, rel=0.05)
    assert loom.volume_change(ground, high, 2.0, classes=[2, 5]).net > 4000
    zones = [loom.PointCloud(cloud.points, crs=crs) for cloud, crs in ((before, 25832), (after, 25833))]
    with pytest.raises(ValueError, match="expected one coordinate system"):
        loom.volume_change(*zones, 2.0)
    units = [loom.PointCloud(cloud.points, unit=unit) for cloud, unit in ((before, "foot"), (after, "metre"))]
    with pytest.warns(UnitWarning, match="foot and metre"):
        assert loom.volume_change(*units, 2.0).unit is None
    with pytest.raises(ValueError, match="cell: expected the edge of a cell, got None"):
        loom.volume_change(before, after)
    with pytest.raises(ValueError, match=r"cell: expected 2\.0, that of the raster"):
        loom.volume_change(loom.rasterize(before, 2.0, "dsm"), after, 1.0)
    report = loom.volume_change(before, after, 2.0).to_dict()
    assert report["reliable"] and "difference" not in report and report["net"] == report["fill"] - report["cut"]
