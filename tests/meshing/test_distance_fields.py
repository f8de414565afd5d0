"""Distance fields against SciPy and brute force, occupancy grids against OctoMap's traversal in plain Python."""

import pickle

import numpy as np
import pytest
import warp as wp
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage
from scipy.interpolate import RegularGridInterpolator
from scipy.spatial import cKDTree

import pointloom as loom
from pointloom.core.errors import FileError
from pointloom.kernels.volumes import distance_blocks, occupancy_blocks

FAR = 2**31 - 1
UTM = np.array([500000.0, 5400000.0, 200.0])
FAR_AWAY = np.array([90_000.0, 0, 0])
SIZE, MAX_DISTANCE = 0.25, 2.0


def squared(occupied):
    """SciPy's squared distances as integers."""
    return np.rint(ndimage.distance_transform_edt(~occupied) ** 2).astype(np.int64)


def first_nearest(occupied, cells):
    """The nearest occupied voxel of each query; ties go to the first along x, then y, then z."""
    there = np.argwhere(occupied)
    return there[((cells[:, None] - there[None]) ** 2).sum(axis=2).argmin(axis=1)]


BOXES = {
    "sparse": np.random.default_rng(0).random((19, 30, 11)) < 0.004,
    "half": np.random.default_rng(1).random((9, 16, 17)) < 0.5,
    "long": np.random.default_rng(2).random((2, 150, 3)) < 0.02,
    "one": np.arange(13 * 7 * 21).reshape(13, 7, 21) == (4 * 7 + 6) * 21 + 20,
    "solid": np.ones((8, 9, 10), bool),
}


@pytest.mark.parametrize("name", BOXES)
def test_a_box_has_scipys_distances_and_the_first_of_the_nearest(device, name):
    occupied = BOXES[name]
    field = loom.DistanceField.from_array(occupied, 0.5, device=device)
    expected = squared(occupied)
    np.testing.assert_array_equal(field.to_array(values="squared"), expected)
    np.testing.assert_array_equal(field.to_array(), (np.sqrt(expected) * 0.5).astype(np.float32))
    cells = np.argwhere(np.ones_like(occupied))[:: max(1, occupied.size // 500)]
    nearest = field.occupied_voxels[field.to_array(values="nearest")[tuple(cells.T)]]
    np.testing.assert_array_equal(nearest, first_nearest(occupied, cells))


@settings(max_examples=15, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(0.5, 9.0))
def test_max_distance_cuts_a_box_and_changes_nothing_within_it(seed, max_distance):
    rng = np.random.default_rng(seed)
    occupied = rng.random(rng.integers(1, 20, 3)) < rng.choice([0.003, 0.1, 0.7])
    occupied[0, 0, 0] = True
    cut = loom.DistanceField.from_array(occupied, max_distance=max_distance, signed=True)
    outer = squared(occupied)
    inner = squared(~occupied) if not occupied.all() else np.full(occupied.shape, FAR)
    within = np.where(inner <= max_distance**2, -inner, -FAR)
    expected = np.where(occupied, within, np.where(outer <= max_distance**2, outer, FAR))
    np.testing.assert_array_equal(cut.to_array(values="squared"), expected)
    np.testing.assert_array_equal(cut.to_array(values="known"), np.abs(expected) != FAR)
    assert np.abs(cut.to_array()).max() <= np.float32(max_distance)


def test_signed_distances_are_scipys_two_transforms(device):
    ball = ((np.indices((21, 18, 15)) - np.array([9, 8, 7])[:, None, None, None]) ** 2).sum(axis=0) < 36
    field = loom.DistanceField.from_array(ball, signed=True, device=device)
    expected = ndimage.distance_transform_edt(~ball) - ndimage.distance_transform_edt(ball)
    np.testing.assert_array_equal(field.to_array(), expected.astype(np.float32))
    solid = loom.DistanceField.from_array(np.ones((3, 3, 3), bool), signed=True, device=device)
    assert solid.to_array().max() == -np.inf


@pytest.fixture(scope="module")
def scan():
    """Some walls at UTM coordinates, one far point, and one invalid point."""
    rng = np.random.default_rng(5)
    points = rng.random((1500, 3)) * (12, 9, 3)
    points[:500, 0], points[500:1000, 1] = 3.1, 4.2
    return np.vstack([UTM + points, UTM + FAR_AWAY, np.full((1, 3), np.nan)])


def field_of(scan, device):
    return loom.DistanceField.from_point_cloud(loom.PointCloud(scan, device=device), SIZE, MAX_DISTANCE)


def centers_of(field):
    return (field.occupied_voxels + 0.5) * field.voxel_size + field.origin


def test_a_cloud_at_utm_has_the_distances_of_brute_force(device, scan):
    field = field_of(scan, device)
    assert (field.origin == field.origin.round()).all() and np.abs(field.origin - UTM).max() < 20
    finite = scan[:-1]
    cells = np.floor((finite - field.origin) / SIZE)
    on_border = np.abs((finite - field.origin) / SIZE - cells - 0.5).max(axis=1) > 0.49
    assert {*map(tuple, field.occupied_voxels)} >= {*map(tuple, cells[~on_border].astype(int))}
    centers = centers_of(field)
    queries = UTM + np.random.default_rng(6).uniform((-4, -4, -4), (16, 13, 7), (4000, 3))
    middles = (np.floor((queries - field.origin) / SIZE) + 0.5) * SIZE + field.origin
    distances, _ = cKDTree(centers).query(middles)
    known = distances <= MAX_DISTANCE + 1e-9
    assert 500 < known.sum() < 3500
    np.testing.assert_array_equal(field.is_known(queries), known)
    np.testing.assert_allclose(field.distances(queries), np.where(known, distances, MAX_DISTANCE), rtol=1e-6)
    result = field.nearest_obstacles(queries)
    np.testing.assert_array_equal(result.rows >= 0, known)
    np.testing.assert_array_equal(result.positions[known], centers[result.rows[known]])
    np.testing.assert_allclose(np.linalg.norm(result.positions - middles, axis=1)[known], distances[known], rtol=1e-9)


def test_an_outlier_point_uses_only_its_own_blocks(scan):
    with_it, without = field_of(scan, "cpu"), field_of(scan[:-2], "cpu")
    alone = loom.DistanceField.from_voxels([[0, 0, 0]], SIZE, MAX_DISTANCE)
    assert with_it.block_count <= without.block_count + 2 * alone.block_count
    assert with_it.slice("z", UTM[2] + 1).distances.shape[1] > FAR_AWAY[0] / SIZE
    with pytest.raises(ValueError, match="bounds:"):
        with_it.to_array([UTM - 1e5, UTM + 1e5])
    with pytest.raises(ValueError, match=r"a voxel lies .* from the field's origin.*the points extend from"):
        field_of(np.vstack([scan, UTM + 100 * FAR_AWAY]), "cpu")


def test_interpolated_distances_are_linear_and_gradients_are_their_differences(device):
    occupied = BOXES["sparse"]
    field = loom.DistanceField.from_array(occupied, 0.5, origin=UTM, device=device)
    axes = [UTM[k] + 0.5 * (np.arange(n) + 0.5) for k, n in enumerate(occupied.shape)]
    between = RegularGridInterpolator(axes, field.to_array().astype(np.float64))
    queries = UTM + np.random.default_rng(3).uniform(0.5, np.array(occupied.shape) * 0.5 - 0.5, (2000, 3))
    np.testing.assert_allclose(field.distances(queries, interpolate=True), between(queries), atol=2e-6)
    steps = 0.25 * np.eye(3)
    slopes = np.stack([(between(queries + step) - between(queries - step)) / 0.5 for step in steps], axis=1)
    np.testing.assert_allclose(field.gradients(queries), slopes, atol=1e-5)
    cut = loom.DistanceField.from_array(occupied, 0.5, origin=UTM, max_distance=2.0, device=device)
    is_known = np.isfinite(RegularGridInterpolator(axes, np.where(cut.to_array(values="known"), 0, np.nan))(queries))
    expected = np.where(is_known, field.distances(queries, interpolate=True), cut.distances(queries))
    np.testing.assert_array_equal(cut.distances(queries, interpolate=True), expected)
    assert 100 < is_known.sum() < 1900 and np.isnan(cut.gradients(queries[~is_known])).all()
    outside = [UTM - 1, UTM + 1e9, [np.nan, 0, 0]]
    assert np.isnan(field.distances(outside)).all() and np.isnan(field.gradients(outside)).all()
    assert not field.is_known(outside).any() and field.collides(outside, 0.0).all()


def test_invalid_queries_and_those_beyond_max_distance_have_no_nearest_obstacle(device):
    field = loom.DistanceField.from_voxels([[0, 0, 0]], 0.5, 1.0, device=device)
    result = field.nearest_obstacles([[0.3, 0.2, 0.1], [np.nan, 0, 0], [0, np.inf, 0], [1e3, 0, 0]])
    assert result.rows.tolist() == [0, -1, -1, -1] and np.isnan(result.positions[1:]).all()
    np.testing.assert_array_equal(result.positions[0], [0.25, 0.25, 0.25])
    assert np.isnan(result.distances[1:3]).all() and result.distances[3] == 1.0
    bounds = [[-20.0, 0, 0], [5.0, 0.5, 0.5]]
    cells = np.arange(-40, 10)
    known = np.abs(cells) <= 2
    np.testing.assert_array_equal(field.to_array(bounds)[:, 0, 0], np.where(known, np.abs(cells) * 0.5, 1.0))
    np.testing.assert_array_equal(field.to_array(bounds, values="nearest")[:, 0, 0], np.where(known, 0, -1))
    squared = field.to_array(bounds, values="squared")[:, 0, 0]
    np.testing.assert_array_equal(squared, np.where(known, cells**2, 2**31 - 1))


def test_no_touching_sphere_is_reported_free(device, scan):
    field, walls = field_of(scan, device), cKDTree(scan[:-1])
    rng = np.random.default_rng(7)
    centers, radii = UTM + rng.uniform((-3, -3, -3), (15, 12, 6), (20_000, 3)), rng.uniform(0, 1.2, 20_000)
    collides = field.collides(centers, radii)
    assert collides[walls.query(centers)[0] <= radii].all()
    apart = cKDTree(centers_of(field)).query(centers)[0]
    assert not collides[apart > radii + 2 * np.sqrt(3) * SIZE].any()
    spheres = np.array([[0, 0, 0, 0.3], [0.9, 0, 0.2, 0.5], [-0.4, 0.1, 0, 0.2]])
    poses = np.tile(np.eye(4), (500, 1, 1))
    rotations = np.linalg.qr(rng.normal(size=(500, 3, 3)))[0]
    poses[:, :3, :3], poses[:, :3, 3] = rotations * np.linalg.det(rotations)[:, None, None], centers[:500]
    result = field.collides_bodies(spheres, poses)
    parts = np.einsum("mij,kj->mki", poses[:, :3, :3], spheres[:, :3]) + poses[:, None, :3, 3]
    one_by_one = field.collides(parts.reshape(-1, 3), np.tile(spheres[:, 3], 500)).reshape(500, 3).any(axis=1)
    np.testing.assert_array_equal(result.collides, one_by_one)
    truth = (walls.query(parts)[0] - spheres[:, 3]).min(axis=1)
    assert (result.clearance <= truth).all() and 50 < result.collides.sum() < 450


def test_empty_space_is_at_infinite_or_maximum_distance(device):
    box = loom.DistanceField.from_array(np.zeros((3, 4, 5), bool), device=device)
    assert np.isposinf(box.to_array()).all() and not box.collides([[1, 1, 1]], 1e6).any()
    empty = loom.DistanceField.from_point_cloud(loom.PointCloud([[np.nan] * 3], device=device), 0.1, 1)
    assert (empty.block_count, empty.voxel_count) == (0, 0) and empty.distances([[0, 0, 0]]).tolist() == [1.0]
    with pytest.raises(ValueError, match="layer:"):
        loom.draw_slice(empty.slice("z", 0))


@pytest.mark.slow
def test_a_slice_and_its_image_match_the_array(scan):
    field = field_of(scan[:-2], "cpu")
    layer = field.slice("y", UTM[1] + 4.2)
    low, high = field.bounds
    section = field.to_array()[:, int((UTM[1] + 4.2 - low[1]) / SIZE)]
    np.testing.assert_array_equal(layer.distances, section.T)
    np.testing.assert_array_equal(layer.extent, np.array([low, high])[:, [0, 2]])
    image = loom.draw_slice(layer, size=(480, 360))
    colors = {tuple(color) for color in image.reshape(-1, 3).tolist()}
    assert {(26, 26, 26), (153, 153, 153)} <= colors and len(colors) > 50


def test_a_field_round_trips_through_files_and_pickle(tmp_path, scan):
    signed = loom.DistanceField.from_array(BOXES["half"], 0.5, origin=UTM, signed=True)
    for field in (field_of(scan, "cpu"), signed):
        field.save(tmp_path / "field.npz")
        for again in (loom.DistanceField.load(tmp_path / "field.npz"), pickle.loads(pickle.dumps(field))):
            assert repr(again) == repr(field) and (again.origin == field.origin).all()
            np.testing.assert_array_equal(again.blocks.sqdists, field.blocks.sqdists)
            np.testing.assert_array_equal(again.occupied_voxels, field.occupied_voxels)


DAMAGE = {
    "lacks voxels": lambda a: a.pop("voxels"),
    "contains unknown arrays": lambda a: a.update(more=np.zeros(1)),
    "voxels: expected int32": lambda a: a.update(voxels=a["voxels"].astype(np.int64)),
    "voxels: repeated": lambda a: a.update(voxels=a["voxels"][[0, 0]]),
    "voxels: out of range": lambda a: a.update(voxels=a["voxels"] + 90),
    "sizes: expected": lambda a: a.update(sizes=np.array([-1.0, 2.0])),
    "origin: not finite": lambda a: a.update(origin=np.array([np.nan, 0, 0])),
    "shape: ": lambda a: a.update(shape=np.array([0, 3, 3])),
    "voxels are .* across": lambda a: a.update(shape=np.array([2**40, 7, 21])),
    "is not a pointloom distance field": lambda a: a.update(format=np.zeros(3, np.uint8)),
}


def test_a_damaged_file_is_a_named_error(tmp_path):
    path = tmp_path / "field.npz"
    loom.DistanceField.from_array(BOXES["one"]).save(path)
    with np.load(path) as file:
        contents = dict(file)
    for reason, damage in DAMAGE.items():
        arrays = dict(contents)
        damage(arrays)
        np.savez(tmp_path / "damaged.npz", **arrays)
        with pytest.raises(FileError, match=reason):
            loom.DistanceField.load(tmp_path / "damaged.npz")
    (tmp_path / "cut.npz").write_bytes(path.read_bytes()[:-30])
    with pytest.raises(FileError, match=r"/cut\.npz:"):
        loom.DistanceField.load(tmp_path / "cut.npz")
    with pytest.raises(FileError):
        loom.DistanceField.from_array(BOXES["one"]).save(path, overwrite=False)


def test_too_large_fields_are_rejected_with_their_size(monkeypatch):
    with pytest.raises(ValueError, match=r"would need [\d,]+ blocks"):
        loom.DistanceField.from_voxels([[0, 0, 0]], 0.01, 20.0)
    monkeypatch.setattr(distance_blocks, "BLOCK_BYTES", 2**50)
    with pytest.raises(MemoryError, match=r"a distance field of \d+ blocks"):
        loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, 2.0)


def test_results_have_the_array_type_of_the_queries(device):
    occupied, points = BOXES["half"], np.random.default_rng(8).uniform(0, 9, (50, 3))
    mask, queries = wp.array(occupied, dtype=wp.bool, device=device), wp.array(points, dtype=wp.vec3d, device=device)
    field = loom.DistanceField.from_array(mask, device=device)
    squares = field.to_array(values="squared")  # on a GPU an array of Warp, too
    np.testing.assert_array_equal(loom.asnumpy(squares), squared(occupied))
    result = field.distances(queries)
    assert isinstance(result, wp.array) and str(result.device) == device
    np.testing.assert_array_equal(result.numpy(), field.distances(points))
    radii = wp.full(50, 0.5, dtype=wp.float32, device=device)
    np.testing.assert_array_equal(field.collides(queries, radii).numpy(), field.collides(points, 0.5))
    cloud = loom.PointCloud(points.astype(np.float32), device=device)
    np.testing.assert_array_equal(field.distances(cloud), field.distances(cloud.points))


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
    assert result.keys() == known.keys() and all(result[voxel] == value for voxel, value in known.items())
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
    assert log_odds_of(grid).keys() == passed | hit and {tuple(v) for v in grid.voxel_indices().tolist()} == hit


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
    for arguments, reason in (
        ((ends, None), "origin: expected the sensor position"),
        ((wild, start), "use max_range or larger voxels"),
        ((np.vstack([ends, [[9000, 9000, 9000]]]), start), "fills a box of .* use max_range"),
        ((np.vstack([ends, [[np.inf, 0, 0]]]), start), "points: expected finite points"),
        ((ends, [1e9, 0, 0]), "origin: a ray starts 1e.09 m"),
        ((ends, ends[:3]), "origin"),
    ):
        with pytest.raises(ValueError, match=reason):
            room.insert_scan(*arguments)
    assert log_odds_of(room) == before and room.scan_count == 3 and room.memory_bytes == memory
    assert room.insert_scan(wild[-1:], start, max_range=1.0) > 0
    assert room.memory_bytes < 5e6 and np.abs(room.bounds).max() < 6.5
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


def test_a_slice_covers_the_requested_bounds(device):
    field = loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, max_distance=9, device=device)
    part = field.slice("z", 1.5, bounds=[[-2, 0, 0], [3, 2, 1]])
    x, y = np.meshgrid(np.arange(-2, 3), np.arange(2))
    np.testing.assert_allclose(part.distances, np.sqrt(x**2 + y**2 + 1), rtol=1e-6)
    grid = loom.TriangleMesh.create_box().voxelize(0.25)
    assert str(loom.DistanceField.from_voxel_grid(grid, 2.0, device=device).device) == device
