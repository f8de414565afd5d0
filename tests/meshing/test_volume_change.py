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


def even(rng, density):
    return rng.random((2, round(400 * density))) * 20


def lines(rng, density):
    """Scan lines 0.9 m apart."""
    x = np.repeat(np.arange(0, 20, 0.9) + rng.uniform(0, 0.9), round(18 * density)) % 20
    return np.stack([x, rng.random(len(x)) * 20])


def crossing(rng, density):
    return lines(rng, density)[::-1]


def from_left(rng, density):
    """Seen from (-5, 10): the density is 1 / r^2."""
    x, y = rng.random((2, round(4000 * density))) * 20
    seen = rng.random(len(x)) < 25 / ((x + 5) ** 2 + (y - 10) ** 2)
    return np.stack([x, y])[:, seen][:, : round(400 * density)]


def from_right(rng, density):
    x, y = from_left(rng, density)
    return np.stack([20 - x, y])


def clustered(rng, density):
    return np.mod(np.repeat(rng.random((2, round(50 * density))) * 20, 8, axis=1) + rng.normal(0, 0.1), 20)


PATTERNS = [(even, even), (lines, lines), (crossing, lines), (from_left, from_right), (clustered, even)]


def surveys(
    seed, patterns, surface, *, density=6.0, noise=0.03, scale=1.0, origin=(0.0, 0.0, 0.0), pile=0.0, device="cpu"
):
    """Two epochs of 20 x 20 m. The second one has a cone of 12 m in diameter."""
    rng = np.random.default_rng(seed)
    for k, pattern in enumerate(patterns):
        x, y = pattern(rng, density)
        z = surface(x, y) + noise * rng.normal(size=len(x)) + k * pile * np.maximum(0, 1 - np.hypot(x - 10, y - 10) / 6)
        yield loom.PointCloud(np.column_stack([x, y, z]) * scale + np.array(origin), device=device)


def hills(x, y):
    return 0.8 * x + 0.3 * np.sin(x / 3) * np.cos(y / 4)


@pytest.mark.parametrize("patterns", PATTERNS[1::2], ids=lambda pair: "-".join(each.__name__ for each in pair))
@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (EAST, NORTH, 300.0)], ids=["local", "utm"])
def test_cells_have_the_height_of_a_curved_surface_at_their_middle(device, patterns, origin):
    def bowl(x, y):
        return 0.6 * x - 0.9 * y + 0.05 * x**2 - 0.03 * x * y + 0.02 * y**2

    flat = loom.PointCloud(np.column_stack([*(even(np.random.default_rng(9), 40)), np.zeros(16000)]) + origin)
    for cloud in surveys(1, patterns, bowl, noise=0, origin=origin, device=device):
        found = loom.volume_change(flat, cloud, 1.0)
        rows, columns = found.difference.values.shape
        x, y = found.difference.corner[0] + np.arange(columns) + 0.5, found.difference.corner[1] + np.arange(rows) + 0.5
        expected = bowl(x - origin[0], (y - origin[1])[::-1, None])
        near = np.isfinite(found.difference.values)
        assert near.mean() > 0.8 and found.interpolated_area >= 0
        np.testing.assert_allclose(found.difference.values[near], expected[near], atol=5e-3)


@pytest.mark.both_compilers
def test_heights_are_bitwise_the_same_on_each_device(device):
    made = [
        loom.volume_change(*surveys(3, (from_left, lines), hills, density=2, pile=1.5, device=each), 1.0)
        for each in (device, "cpu")
    ]
    assert np.array_equal(*(each.difference.values for each in made), equal_nan=True)
    assert np.array_equal(*(each.level_of_detection for each in made), equal_nan=True)
    assert made[0].to_dict() == made[1].to_dict()


def test_sums_are_those_of_the_cells(rng):
    clouds = [epoch(rng, pile, count=8000, noise=0.1) for pile in (0, 1)]
    found = loom.volume_change(*clouds, 2.0, registration_error=0.02, max_gap=0)
    values = found.difference.values[np.isfinite(found.difference.values)].astype(np.float64)
    assert len(values) > 800 and found.net == pytest.approx(values.sum() * 4, rel=1e-5)
    assert found.cut == pytest.approx(-values[values < 0].sum() * 4, rel=1e-5) and found.area == len(values) * 4
    significant = np.abs(found.difference.values) > found.level_of_detection
    assert found.significant_fill == pytest.approx(
        4 * found.difference.values[significant & (found.difference.values > 0)].sum(), rel=1e-5
    )


def spread_of(changes, uncertainties):
    """Root mean square of changes in units of their stated standard deviation."""
    return np.sqrt(np.mean((np.array(changes) / (np.array(uncertainties) / 1.96)) ** 2))


@pytest.mark.parametrize("patterns", PATTERNS, ids=lambda pair: "-".join(each.__name__ for each in pair))
@pytest.mark.parametrize(("density", "cell"), [(1.5, 1.0), (6, 2.0)])
def test_uncertainties_are_those_of_repeated_surveys(patterns, density, cell):
    found = [loom.volume_change(*surveys(seed, patterns, hills, density=density), cell) for seed in range(15)]
    # Chi-squared distribution of 15: 0.45 and 1.6 have a probability below 0.2 %. Misfits of gaps make it smaller.
    spread = spread_of([each.net for each in found], [each.net_uncertainty for each in found])
    assert (0.45 if cell == 2.0 else 0.2) < spread < 1.6
    cells = [(each.difference.values.ravel(), each.level_of_detection.ravel()) for each in found]
    changes, limits = (np.concatenate(each) for each in zip(*cells, strict=True))
    exceeding = np.mean(np.abs(changes[np.isfinite(changes)]) > limits[np.isfinite(changes)])
    assert exceeding < 0.1


@pytest.mark.parametrize("scale", [1.0, 1000.0])
def test_the_unit_of_length_changes_nothing(scale):
    metres = loom.volume_change(*surveys(0, (lines, even), hills, pile=1.5, density=2), 1.0)
    found = loom.volume_change(*surveys(0, (lines, even), hills, pile=1.5, density=2, scale=scale), scale)
    for name in ("net", "fill", "net_uncertainty", "significant_fill"):
        assert getattr(found, name) == pytest.approx(getattr(metres, name) * scale**3, rel=1e-4)


SHADOWS = {
    "flank": lambda x, y: (np.abs(y - 10) < 3) & (x > 11) & (x < 14.5),
    "side": lambda x, y: (np.abs(x - 10) < 3) & (y > 11) & (y < 14.5),
    "foot": lambda x, y: (np.abs(y - 10) < 2.9) & (x > 12.2) & (x < 15.8),
    "top": lambda x, y: (np.abs(y - 10) < 1.75) & (x > 8) & (x < 12),
}


@pytest.mark.parametrize("shadow", SHADOWS)
@pytest.mark.parametrize(("slope", "height"), [(0.5, 0.0), (0.5, 1.5)])
def test_the_interval_contains_the_truth_of_a_pile_with_a_shadow(shadow, slope, height):
    truth, inside = np.pi * 12 * height, 0
    for seed in range(10):
        before, after = surveys(seed, (even, even), lambda x, y: slope * x, density=10, pile=height)
        x, y, _ = after.points.T
        found = loom.volume_change(before, loom.PointCloud(after.points[~SHADOWS[shadow](x, y)]), 1.0)
        assert found.interpolated_area >= 6 and found.net_uncertainty < (0.15 * truth if height else 1.0)
        inside += abs(found.net - truth) <= found.net_uncertainty
    assert inside >= 8  # 7 of 10 or fewer have a probability of 1.2 % at 95 %


@pytest.mark.parametrize("limit", [11.0, 6.0])
@pytest.mark.parametrize(("axis", "epochs"), [(0, slice(None)), (1, slice(None, None, -1))], ids=["after", "before"])
def test_area_outside_of_the_other_epoch_is_missing(axis, epochs, limit):
    before, after = surveys(0, (even, even), lambda x, y: 0 * x, density=20, pile=1.5)
    cut = loom.PointCloud(after.points[after.points[:, axis] < limit])
    found = loom.volume_change(*(before, cut)[epochs], 1.0)
    assert found.area == 20 * limit and found.missing_area == 400 - 20 * limit
    assert not found.reliable and "next to the missing area changed by" in " ".join(found.warnings)
    flat = loom.PointCloud(before.points[before.points[:, axis] < 11])
    level = loom.volume_change(*(before, flat)[epochs], 1.0)
    assert level.missing_area == 180 and level.reliable


@pytest.mark.parametrize("pile", [0.0, -1.5])
@pytest.mark.parametrize(("kind", "scale"), [("cloud", 1000.0), ("raster", 1.0), ("mesh", 1.0)])
def test_a_height_offset_of_an_epoch_is_reported(pile, kind, scale):
    if kind == "mesh":
        x, y = (axis.ravel() * 0.5 for axis in np.meshgrid(np.arange(41.0), np.arange(41.0)))
        rows = np.arange(40 * 41).reshape(40, 41)[:, :40].ravel()
        halves = [rows, rows + 1, rows + 42], [rows, rows + 42, rows + 41]
        mesh = loom.TriangleMesh(
            np.column_stack([x, y, 0.3 * x]) * scale, np.concatenate([np.column_stack(each) for each in halves])
        )
    for offset, error, is_reported in ((0.0, 0.0, False), (0.2, 0.0, True), (-47.0, 0.02, True), (0.02, 0.02, False)):
        before, after = surveys(2, (even, even), lambda x, y: 0.3 * x, density=10, pile=pile, scale=scale)
        moved = loom.PointCloud(after.points + np.array([0, 0, offset * scale]))
        first = mesh if kind == "mesh" else before
        if kind == "raster":
            first, moved = (loom.rasterize(each, scale, "lowest") for each in (before, moved))
        found = loom.volume_change(first, moved, None if kind == "raster" else scale, registration_error=error * scale)
        assert any("the heights before and after differ by" in each for each in found.warnings) == is_reported


def test_piles_of_any_outline_are_no_height_offset():
    for seed in range(5):
        before, after = surveys(seed, (even, lines), hills, density=8, pile=2.0)
        for radius in (3.0, 5.0, 7.0):
            cropped = [each.points[np.hypot(*(each.points[:, :2] - 10).T) < radius] for each in (before, after)]
            found = loom.volume_change(*map(loom.PointCloud, cropped), 0.5)
            assert not any("heights before and after" in each for each in found.warnings)


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


def test_a_grid_that_does_not_fit_into_memory_is_refused_before_it_is_computed(monkeypatch, rng):
    epochs = [loom.PointCloud(rng.random((500, 3)) * (20, 20, 0.1)) for _ in range(2)]
    monkeypatch.setattr("pointloom.pcd.raster_cells.free_bytes", lambda _: 100_000)
    assert loom.volume_change(*epochs, 4.0).area > 0
    with pytest.raises(MemoryError, match="cell: 1 gives 20 x 20 cells, which need"):
        loom.volume_change(*epochs, 1.0)
