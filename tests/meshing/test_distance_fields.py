"""Distance fields: SciPy's transform bitwise, brute force around clouds, collision checks."""

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
from pointloom.kernels.volumes import distance_blocks

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


def test_a_slice_and_its_image_match_the_array(scan):
    field = field_of(scan[:-2], "cpu")
    layer = field.slice("y", UTM[1] + 4.2)
    low, high = field.bounds
    section = field.to_array()[:, int((UTM[1] + 4.2 - low[1]) / SIZE)]
    np.testing.assert_array_equal(layer.distances, section.T)
    np.testing.assert_array_equal(layer.extent, np.array([low, high])[:, [0, 2]])
    picture = loom.draw_slice(layer, size=(480, 360))
    colors = {tuple(color) for color in picture.reshape(-1, 3).tolist()}
    assert {(26, 26, 26), (153, 153, 153)} <= colors and len(colors) > 50


def test_a_field_round_trips_through_files_and_pickle(tmp_path, scan):
    signed = loom.DistanceField.from_array(BOXES["half"], 0.5, origin=UTM, signed=True)
    for field in (field_of(scan, "cpu"), signed):
        field.save(tmp_path / "field.npz")
        for again in (loom.DistanceField.load(tmp_path / "field.npz"), pickle.loads(pickle.dumps(field))):
            assert repr(again) == repr(field) and (again.origin == field.origin).all()
            np.testing.assert_array_equal(again._blocks.sqdists, field._blocks.sqdists)
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
    with pytest.raises(ValueError, match="max_distance:"):
        loom.DistanceField.from_voxels([[0, 0, 0]], 0.001, 50.0)
    with pytest.raises(ValueError, match="occupied:"):
        loom.DistanceField.from_array(np.zeros((40_000, 1, 1), bool))
    monkeypatch.setattr(distance_blocks, "BYTES", 2**50)
    with pytest.raises(MemoryError, match=r"a distance field of \d+ blocks"):
        loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, 2.0)


def test_radii_beyond_the_known_distance_are_rejected():
    field = loom.DistanceField.from_voxels([[0, 0, 0]], 1.0, 4.0)
    with pytest.raises(ValueError, match="radii:"):
        field.collides([[9, 9, 9]], 3.0)
    with pytest.raises(ValueError, match=r"poses\[1\]"):
        field.collides_bodies([[0, 0, 0, 1]], np.stack([np.eye(4), 2 * np.eye(4)]))
    with pytest.raises(TypeError, match=r"^DistanceField:.*from_point_cloud"):
        loom.DistanceField()


def test_results_have_the_array_type_of_the_queries(device):
    occupied, points = BOXES["half"], np.random.default_rng(8).uniform(0, 9, (50, 3))
    mask, queries = wp.array(occupied, dtype=wp.bool, device=device), wp.array(points, dtype=wp.vec3d, device=device)
    field = loom.DistanceField.from_array(mask, device=device)
    np.testing.assert_array_equal(field.to_array(values="squared"), squared(occupied))
    result = field.distances(queries)
    assert isinstance(result, wp.array) and str(result.device) == device
    np.testing.assert_array_equal(result.numpy(), field.distances(points))
    radii = wp.full(50, 0.5, dtype=wp.float32, device=device)
    np.testing.assert_array_equal(field.collides(queries, radii).numpy(), field.collides(points, 0.5))
    cloud = loom.PointCloud(points.astype(np.float32), device=device)
    np.testing.assert_array_equal(field.distances(cloud), field.distances(cloud.points))
