"""OccupancyGrid against OctoMap's ray traversal in plain Python, and against exact geometry.

benchmarks/occupancy.py compares with OctoMap itself: all voxels and log odds are equal.
"""

import pickle

import numpy as np
import pytest

import pointloom as loom
from pointloom.kernels.volumes import occupancy_blocks

EDGE = 0.1
DEFAULTS = {"hit": 0.7, "miss": 0.4, "min": 0.1192, "max": 0.971}


def traverse(start, end, edge=EDGE):
    """The voxels of OctoMap's computeRayKeys without the end voxel: float32 positions, float64 crossings."""
    a, b = np.float32(start), np.float32(end)
    way = b - a
    span = np.float32(np.sqrt(np.float64(way[0] * way[0] + way[1] * way[1] + way[2] * way[2])))
    voxel, last = (np.floor(1 / edge * p.astype(np.float64)).astype(int) for p in (a, b))
    if (voxel == last).all():
        return []
    unit = (way / span).astype(np.float64)
    step, half = np.sign(unit).astype(int), float(np.float32(edge * 0.5))
    with np.errstate(divide="ignore", invalid="ignore"):
        crossing = np.where(step == 0, 1e30, ((voxel + 0.5) * edge + step * half - a) / unit)
        stride = np.where(step == 0, 1e30, edge / np.abs(unit))
    met = []
    while True:
        met.append(tuple(voxel.tolist()))
        tx, ty, tz = crossing
        along = (0 if tx < tz else 2) if tx < ty else (1 if ty < tz else 2)
        voxel[along] += step[along]
        crossing[along] += stride[along]
        if (voxel == last).all() or crossing.min() > span:
            return met


def scans():
    """Three scans of a room from a moving sensor, the last of them at voxel corners."""
    rng = np.random.default_rng(3)
    for k, count in enumerate((150, 149, 80)):
        start = np.float32([0.31 * k, 0.17, 0.05])
        ways = rng.normal(size=(count, 3))
        ends = start + ways / np.abs(ways / [2.1, 1.6, 0.9]).max(axis=1, keepdims=True)
        yield (start, ends.astype(np.float32)) if k < 2 else (np.round(start, 1), np.round(ends, 1).astype(np.float32))


def fold(known, start, ends, max_range):
    """Integrate one scan into a dictionary of log odds, as OctoMap does."""
    odds = {name: np.float32(np.log(p / (1 - p))) for name, p in DEFAULTS.items()}
    passed, hit = set(), set()
    for end in np.float32(ends):
        way = end - np.float32(start)
        span = np.float32(np.sqrt(np.float64(way[0] * way[0] + way[1] * way[1] + way[2] * way[2])))
        if span > max_range:
            end = np.float32(start) + way / span * np.float32(max_range)
        else:
            hit.add(tuple(np.floor(1 / EDGE * end.astype(np.float64)).astype(int).tolist()))
        passed.update(traverse(start, end))
    for voxel in passed | hit:
        value = known.get(voxel, np.float32(0)) + (odds["hit"] if voxel in hit else odds["miss"])
        known[voxel] = min(max(value, odds["min"]), odds["max"])


def log_odds_of(grid):
    low, high = (np.round(ends / grid.voxel_size).astype(int) for ends in grid.bounds - grid.origin)
    cells = np.stack(np.meshgrid(*(np.arange(a, b) for a, b in zip(low, high, strict=True)), indexing="ij"), -1)
    values = grid.log_odds(grid.origin + (cells.reshape(-1, 3) + 0.5) * grid.voxel_size)
    known = ~np.isnan(values)
    return dict(zip(map(tuple, cells.reshape(-1, 3)[known].tolist()), values[known], strict=True))


@pytest.fixture
def room(device):
    grid = loom.OccupancyGrid(EDGE, device=device)
    for start, ends in scans():
        grid.insert_scan(ends, start, max_range=1.9)
    return grid


def test_log_odds_match_a_plain_traversal(room):
    known = {}
    for start, ends in scans():
        fold(known, start, ends, 1.9)
    result = log_odds_of(room)
    assert result.keys() == known.keys()
    assert all(result[voxel] == value for voxel, value in known.items())
    states = room.states((np.array(list(known)) + 0.5) * EDGE)
    assert 50 < (states == 1).sum() < (states == 0).sum()


def test_frequent_observations_are_clamped_and_can_change(device):
    grid, (start, ends) = loom.OccupancyGrid(EDGE, device=device), next(scans())
    known = {}
    for _ in range(7):
        grid.insert_scan(ends[:9], start)
        fold(known, start, ends[:9], 9.0)
    assert log_odds_of(grid) == known
    sure = grid.probabilities((np.array(list(known)) + 0.5) * EDGE)
    assert sure.max() == pytest.approx(0.971) and sure.min() == pytest.approx(0.1192)
    assert (grid.cast_rays(start, (ends[:9] - start).astype(float), 9.0).states == 1).all()


def test_a_ray_through_corners_steps_along_z_then_y_then_x(device):
    grid = loom.OccupancyGrid(0.5, device=device)
    grid.insert_scan([[1.25, 1.25, 1.25]], [0.25, 0.25, 0.25])
    assert log_odds_of(grid).keys() == {(0, 0, 0), (0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 1, 2), (1, 2, 2), (2, 2, 2)}
    assert log_odds_of(grid).keys() == {*traverse([0.25] * 3, [1.25] * 3, 0.5), (2, 2, 2)}


def test_a_ray_frees_exactly_the_voxels_that_it_crosses(device):
    """All voxels crossed by more than a micrometer in exact geometry, and no others."""
    start, end = np.float32([0.013, 0.027, -0.31]), np.float32([2.71, -1.93, 1.07])
    grid = loom.OccupancyGrid(EDGE, device=device)
    grid.insert_scan(end[None], start)
    way = end.astype(float) - start
    voxels = np.stack(np.meshgrid(*[np.arange(-30, 31)] * 3, indexing="ij"), -1).reshape(-1, 3)
    ends = np.sort(((voxels[:, None] + np.array([0, 1])[:, None]) * EDGE - start) / way, axis=1)
    inside = np.minimum(ends[:, 1].min(axis=1), 1) - np.maximum(ends[:, 0].max(axis=1), 0)
    states = grid.states((voxels + 0.5) * EDGE)
    assert (states[inside > 1e-6] >= 0).all()
    assert (states[inside < -1e-6] == -1).all()
    assert (states >= 0).sum() > 60


def test_far_positions_give_the_same_voxels(device):
    near, far = loom.OccupancyGrid(0.5, device=device), loom.OccupancyGrid(0.5, device=device)
    away = np.array([500_000.0, 5_400_000.0, 300.0])
    for start, ends in scans():
        ends, start = np.round(4 * ends.astype(float)) / 4, np.round(4 * start.astype(float)) / 4  # exact in float32
        near.insert_scan(ends, start)
        far.insert_scan(ends + away, start + away)
    shift = (far.origin - away) * 2
    assert far.origin.any() and (near.voxel_indices() == far.voxel_indices() + shift).all()
    assert len(near.voxel_indices()) > 20


def test_each_ray_can_have_its_own_origin(device):
    pairs = [(start, ends[:20]) for start, ends in scans()]
    ends, starts = np.vstack([e for _, e in pairs]), np.repeat([s for s, _ in pairs], 20, axis=0)
    grid = loom.OccupancyGrid(EDGE, device=device)
    grid.insert_scan(np.vstack([ends, [[np.nan, 0, 0]]]), np.vstack([starts, [[0, 0, 0]]]))
    passed = {voxel for start, end in zip(starts, ends, strict=True) for voxel in traverse(start, end)}
    hit = {tuple(v) for v in np.floor(1 / EDGE * ends.astype(np.float64)).astype(int).tolist()}
    assert log_odds_of(grid).keys() == passed | hit
    assert {tuple(v) for v in grid.voxel_indices().tolist()} == hit


def test_rays_hit_the_first_voxel_that_is_not_free(room):
    rng = np.random.default_rng(5)
    ways, start = rng.normal(size=(60, 3)), np.array([0.03, 0.17, 0.05])
    hits, known = room.cast_rays(start, ways, 4.0), log_odds_of(room)
    for state, distance, voxel, way in zip(hits.states, hits.distances, hits.voxels, ways, strict=True):
        way = way / np.linalg.norm(way)
        traversed = traverse(start, start + 5 * way)
        met = next(v for v in traversed if not known.get(v, np.float32(9)) < 0)
        assert (tuple(voxel), state) == (met, 1 if met in known else -1)
        ends = np.sort((np.stack([voxel, voxel + 1]) * EDGE - start) / way, axis=0)
        assert distance == pytest.approx(max(ends[0].max(), 0), abs=1e-6)
    assert {-1, 1} <= set(hits.states.tolist())
    assert room.cast_rays(start, ways[:3], 0.01).states.tolist() == [0, 0, 0]


def test_exports_agree(room):
    voxels, low = room.voxel_indices(), np.round(room.bounds[0] / EDGE).astype(int)
    dense = room.to_array()
    assert np.array_equal(np.argwhere(np.nan_to_num(dense) >= 0.5) + low, voxels)
    centers = room.to_point_cloud().points
    assert np.array_equal(np.sort(np.floor(centers / EDGE).astype(int), axis=0), np.sort(voxels, axis=0))
    grid = room.to_voxel_grid()
    assert np.allclose(grid.centers, (voxels + 0.5) * EDGE) and grid.dense().sum() == len(voxels)
    some = (voxels[:3] + 0.5) * EDGE
    assert np.allclose(room.probabilities(some), 1 / (1 + np.exp(-room.log_odds(some).astype(float))))
    part = room.to_array([[0, 0, 0], [0.3, 0.2, 0.1]])
    assert np.array_equal(part, dense[tuple(slice(-a, -a + n) for a, n in zip(low, (3, 2, 1), strict=True))], True)


def test_files_copies_and_pickles_preserve_the_grid(room, tmp_path, device):
    room.save(tmp_path / "grid.npz")
    loaded = loom.OccupancyGrid.load(tmp_path / "grid.npz", device=device)
    for other in (loaded, room.copy(), pickle.loads(pickle.dumps(room))):
        assert log_odds_of(other) == log_odds_of(room) and other.scan_count == 3 == room.scan_count
        start, ends = next(scans())
        other.insert_scan(ends, start)
        assert other.scan_count == 4 and log_odds_of(other) != log_odds_of(room)
    with np.load(tmp_path / "grid.npz") as members:
        arrays = dict(members)
    for name, value, reason in [
        ("odds", arrays["odds"] + 5, "odds: outside the clamping range"),
        ("keys", arrays["keys"] * 0, "keys: blocks out of range or repeated"),
        ("probabilities", arrays["probabilities"][[1, 0, 2, 3]], "hit: "),
        ("scan_count", np.array(-1), "scan_count: -1"),
    ]:
        np.savez(tmp_path / "bad.npz", **(arrays | {name: value}))
        with pytest.raises(loom.FileError, match=reason):
            loom.OccupancyGrid.load(tmp_path / "bad.npz")


def test_invalid_scans_are_rejected_and_change_nothing(room):
    before, memory = log_odds_of(room), room.memory_bytes
    start, ends = next(scans())
    wild = np.vstack([ends, [[1e7, 0, 0]]])
    for given, reason in (
        ((ends, None), "origin: expected the sensor position"),
        ((wild, start), "use max_range or larger voxels"),
        ((np.vstack([ends, [[9000, 9000, 9000]]]), start), "fills a box of .* use max_range"),
        ((np.vstack([ends, [[np.inf, 0, 0]]]), start), "points: expected finite points"),
        ((ends, [1e9, 0, 0]), "origin: a ray starts 1e.09 m"),
        ((ends, ends[:3]), "origin"),
    ):
        with pytest.raises(ValueError, match=reason):
            room.insert_scan(*given)
    assert log_odds_of(room) == before and room.scan_count == 3 and room.memory_bytes == memory
    assert room.insert_scan(wild[-1:], start, max_range=1.0) > 0
    wrong = ((0.4,), "hit: .* got 0.4"), ((0.7, 0.6), "miss: .* got 0.6"), ((0.7, 0.4, 0.6), "min, max")
    for probabilities, reason in wrong:
        with pytest.raises(ValueError, match=reason):
            loom.OccupancyGrid(EDGE, *probabilities)


def test_an_interrupted_scan_is_integrated_completely_or_not_at_all(room, monkeypatch):
    before, (start, ends) = log_odds_of(room), next(scans())
    launch = occupancy_blocks.launch
    for kernel, count in (("mark_passed_kernel", 3), ("fold_scan_kernel", 4)):

        def stop(given, *rest, last=kernel):
            if last == "fold_scan_kernel" or given is not getattr(occupancy_blocks, last):
                launch(given, *rest)
            if given is getattr(occupancy_blocks, last):
                raise KeyboardInterrupt

        monkeypatch.setattr(occupancy_blocks, "launch", stop)
        with pytest.raises(KeyboardInterrupt):
            room.insert_scan(ends + np.float32(3), start)
        monkeypatch.setattr(occupancy_blocks, "launch", launch)
        assert room.scan_count == count and (log_odds_of(room) == before) == (count == 3)


def test_a_distance_field_uses_the_occupied_voxels(room):
    field = loom.DistanceField.from_occupancy_grid(room, 1.0)
    voxels = room.voxel_indices()
    assert np.array_equal(field.occupied_voxels[np.lexsort(field.occupied_voxels.T[::-1])], voxels)
    assert not field.distances(room.to_point_cloud()).any()


def test_a_grid_without_scans_is_unknown(device):
    grid = loom.OccupancyGrid(EDGE, device=device)
    assert grid.insert_scan(np.zeros((0, 3)), [0, 0, 0]) == 0 and grid.insert_scan([[np.nan] * 3], [0, 0, 0]) == 0
    assert grid.states([[0, 0, 0], [np.nan, 0, 0]]).tolist() == [-1, -1]
    assert grid.scan_count == 0 and grid.voxel_indices().shape == (0, 3) and len(grid.to_point_cloud()) == 0
    assert len(grid.to_voxel_grid()) == 0 and grid.to_array().size == 0
    assert grid.cast_rays([0, 0, 0], [[0, 0, 1]], 1).states.tolist() == [-1]
