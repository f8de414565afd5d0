"""Planes and planar patches: as good as Open3D on real scans, exact far from the origin, and reproducible."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from .open3d_clouds import cloud_of

LIMITS = {"ransac_n": 3, "num_iterations": 1000, "probability": 1.0}


def degrees_between(a, b):
    return np.degrees(np.arccos(min(1.0, abs(a @ b) / np.linalg.norm(a) / np.linalg.norm(b))))


def open3d_plane(o3d, points, threshold, **limits):
    o3d.utility.random.seed(0)
    model, inliers = cloud_of(o3d, points).segment_plane(threshold, **limits)
    return np.asarray(model), np.asarray(inliers)


def cluttered(rng, count=4000, plane_fraction=0.5, noise=0.003, normal=(0.3, -0.2, 1.0), offset=0.4):
    """A noisy plane in a unit cube with uniform clutter; the model and the mask of its points."""
    normal = np.array(normal) / np.linalg.norm(normal)
    points = rng.random((count, 3)) - 0.5
    member = rng.random(count) < plane_fraction
    height = points @ normal - offset
    flat = points - height[:, None] * normal + noise * rng.normal(size=(count, 1)) * normal
    return np.where(member[:, None], flat, points), np.append(normal, -offset), member


@pytest.fixture(scope="module")
def terrain(scan_file):
    return loom.read_point_cloud(scan_file("lidar-pcl-terrain/samp31-utm.pcd")).points


@pytest.fixture(scope="module")
def scans(fragment, lidar, terrain):
    """Points by name, the tile centered, and a threshold for each."""
    near, wide = (fragment.points[::4], 0.02), (lidar[:, :3].astype(float), 0.1)
    return {"fragment": near, "lidar": wide, "terrain": (terrain - np.round(np.median(terrain, axis=0)), 0.5)}


@pytest.mark.parametrize("scan", ["fragment", "lidar", "terrain"])
def test_plane_of_a_real_scan_is_as_good_as_open3ds(device, scan, scans, o3d, tolerances):
    points, threshold = scans[scan]
    model, inliers = loom.PointCloud(points, device=device).segment_plane(threshold, **LIMITS)
    expected, their_inliers = open3d_plane(o3d, points, threshold, **LIMITS)
    assert len(inliers) > tolerances.plane_inliers * len(their_inliers)
    assert degrees_between(model[:3], expected[:3]) < tolerances.plane_degrees
    shared = np.intersect1d(inliers, their_inliers).size / np.union1d(inliers, their_inliers).size
    assert shared > tolerances.plane_overlap


def open3d_fit(o3d, points):
    return open3d_plane(o3d, points, 1e6, ransac_n=3, num_iterations=1)[0]


def test_final_plane_of_made_inliers_is_open3ds_fit(device, rng, oracle, tolerances):
    points, _, member = cluttered(rng, 1000)
    points = points[member].astype(np.float32).astype(float)
    expected = oracle("pcd/planes/fit", open3d_fit, points)
    model, inliers = loom.PointCloud(points, device=device).segment_plane(1.0)
    assert len(inliers) == len(points)
    assert degrees_between(model[:3], expected[:3]) < tolerances.plane_fit_degrees


@pytest.mark.parametrize(("normal", "ransac_n"), [((0, 0, 1), 5), ((1, 0, 0), 3), ((0.3, -0.2, 1), 3), ((-2, 1, 1), 5)])
def test_known_plane_is_detected_among_noise_and_clutter(device, rng, normal, ransac_n):
    points, true, member = cluttered(rng, normal=normal, offset=0.1)
    model, inliers = loom.PointCloud(points, device=device).segment_plane(0.01, ransac_n, 1000)
    assert degrees_between(model[:3], true[:3]) < 0.1
    assert np.isin(np.flatnonzero(member), inliers).mean() > 0.99
    assert (np.abs(points[inliers] @ model[:3] + model[3]) < 0.012).all(), "they are those before the fit"


def test_inliers_ascend_and_the_normal_is_unit_with_its_largest_component_positive(device, rng, tolerances):
    for normal in rng.normal(size=(6, 3)):
        points, _, _ = cluttered(rng, 600, normal=normal, offset=0.0)
        model, inliers = loom.PointCloud(points, device=device).segment_plane(0.02)
        assert model.dtype == np.float64 and inliers.dtype == np.int32
        assert (np.diff(inliers) > 0).all()
        assert abs(np.linalg.norm(model[:3]) - 1) < tolerances.plane_unit
        assert model[np.argmax(np.abs(model[:3]))] > 0


def test_all_points_of_an_exact_plane_are_inliers(device, rng):
    points = np.column_stack([rng.random((1037, 2)), np.full(1037, 2.5)])
    model, inliers = loom.PointCloud(points, device=device).segment_plane(1e-6)
    assert inliers.tolist() == list(range(1037))
    np.testing.assert_allclose(model, [0, 0, 1, -2.5], atol=1e-12)


def test_three_points_have_their_plane(device):
    model, inliers = loom.PointCloud([[1, 0, 0], [0, 1, 0], [0, 0, 1]], device=device).segment_plane(0.01)
    np.testing.assert_allclose(model, [3**-0.5] * 3 + [-(3**-0.5)], atol=1e-7)
    assert inliers.tolist() == [0, 1, 2]


def test_the_seed_chooses_the_samples(device, rng):
    cloud = loom.PointCloud(rng.random((500, 3)), device=device)
    models = [cloud.segment_plane(0.05, num_iterations=5, seed=seed)[0].tolist() for seed in (0, 0, 1, 2**31 - 1)]
    assert models[0] == models[1] and len({tuple(m) for m in models}) == 3


def test_a_probability_ends_the_search_after_a_batch_and_one_never(device, rng):
    """Half of the points are in the plane: 11 samples contain an all-inlier sample with a probability of 0.9."""
    points, _, _ = cluttered(rng, 3000, plane_fraction=0.6, noise=0.006)
    cloud = loom.PointCloud(points, device=device)
    limits = ((3000, 0.9), (32, 1.0), (3000, 1.0))
    early, batch, all_samples = (len(cloud.segment_plane(0.01, 3, *each)[1]) for each in limits)
    assert early == batch < all_samples


def faces(rng, sizes=(900, 600, 300)):
    """Faces of a box at x, y or z = 0 with a little noise, the face of each point."""
    parts = []
    for axis, size in enumerate(sizes):
        part = rng.uniform(0.1, 1, (size, 3))
        part[:, axis] = 0.002 * rng.normal(size=size)
        parts.append(part)
    return np.vstack(parts), np.repeat(np.arange(len(sizes)), sizes)


def test_planes_are_segmented_successively_from_the_remaining_points(device, rng):
    points, face = faces(rng)
    order = rng.permutation(len(points))
    labels, models = loom.PointCloud(points[order], device=device).segment_planes(0.01, min_points=100)
    assert labels.dtype == np.int32 and models.shape == (3, 4)
    assert (labels == face[order]).mean() > 0.995
    for axis, model in enumerate(models):
        np.testing.assert_allclose(model, np.append(np.eye(3)[axis], 0), atol=2e-3)


def test_first_of_several_planes_is_the_single_plane(device, rng):
    points, _, _ = cluttered(rng, 2000)
    cloud = loom.PointCloud(points, device=device)
    model, inliers = cloud.segment_plane(0.01)
    labels, models = cloud.segment_planes(0.01, max_planes=1)
    np.testing.assert_array_equal(models[0], model)
    np.testing.assert_array_equal(np.flatnonzero(labels == 0), inliers)
    assert set(labels.tolist()) == {-1, 0}


def test_limits_end_the_search_for_planes(device, rng):
    points, _ = faces(rng)
    points[5] = np.nan
    cloud = loom.PointCloud(points, device=device)
    assert len(cloud.segment_planes(0.01, min_points=500)[1]) == 2
    assert len(cloud.segment_planes(0.01, max_planes=1)[1]) == 1
    labels, models = cloud.segment_planes(0.01, min_points=5000)
    assert models.shape == (0, 4) and (labels == -1).all()
    assert cloud.segment_planes(0.01)[0][5] == -1


@pytest.mark.parametrize("count", [0, 1, 2])
def test_clouds_of_fewer_than_three_points_have_no_planes(device, count):
    cloud = loom.PointCloud(np.arange(3.0 * count).reshape(count, 3), device=device)
    labels, models = cloud.segment_planes(0.1, min_points=1)
    assert labels.tolist() == [-1] * count and models.shape == (0, 4)
    with pytest.raises(ValueError, match=f"ransac_n: expected at most the {count} finite points of the cloud, got 3"):
        cloud.segment_plane(0.1)


@pytest.mark.parametrize("points", [np.ones((50, 3)), np.outer(np.arange(50), [1, 2, -1])], ids=["equal", "line"])
def test_points_on_a_line_have_no_plane(device, points):
    """Open3D returns a plane of zeros with all points as inliers."""
    cloud = loom.PointCloud(points, device=device)
    for ransac_n in (3, 6):
        with pytest.raises(ValueError, match="no plane found"):
            cloud.segment_plane(0.01, ransac_n)
        assert cloud.segment_planes(0.01, ransac_n, min_points=1)[1].shape == (0, 4)


coordinates = st.one_of(st.integers(-3, 3).map(float), st.floats(-3, 3, width=32), st.just(np.nan))


@pytest.mark.slow
@settings(max_examples=60, deadline=None)
@given(rows=st.lists(st.tuples(coordinates, coordinates, coordinates), min_size=3, max_size=40), seed=st.integers(0, 9))
def test_no_better_plane_exists_through_three_points_of_a_small_cloud(rows, seed):
    """Some thousand samples include nearly all triples of ten points: none has more inliers by brute force."""
    points = np.array(rows[:10])
    finite = points[np.isfinite(points).all(axis=1)]
    triples = [finite[list(t)] for t in np.ndindex(*[len(finite)] * 3) if t[0] < t[1] < t[2]]
    best = 0
    for p, q, r in triples:
        normal = np.cross(q - p, r - p)
        size = np.linalg.norm(normal)
        if size > 1e-3 * np.linalg.norm(q - p) * np.linalg.norm(r - p):  # thinner ones depend on rounding
            best = max(best, (np.abs((finite - p) @ normal) / size < 0.0999).sum())
    if best == 0:
        return
    model, inliers = loom.PointCloud(points).segment_plane(0.1, 3, 2000, 1.0, seed=seed)
    assert len(inliers) >= best
    assert abs(np.linalg.norm(model[:3]) - 1) < 1e-12 and np.isfinite(points[inliers]).all()


TUTORIAL = {"normal_variance_threshold_deg": 60, "coplanarity_deg": 75, "outlier_ratio": 0.75}
ROOM = np.array([6.0, 4.0, 2.7])  # [m]


def room(rng, count, noise, size=ROOM):
    """Points of the six faces of a box, equally many per face, and the face of each: axis, or axis + 3."""
    face = np.arange(count) % 6
    points = rng.random((count, 3)) * size
    points[np.arange(count), face % 3] = np.where(face < 3, 0, size[face % 3])
    return points + noise * rng.normal(size=points.shape), face


def covered(box, other, slack):
    """Fraction of a box's face inside another box that is enlarged by a slack [m]."""
    u, v = np.meshgrid(np.linspace(-0.45, 0.45, 20), np.linspace(-0.45, 0.45, 20))
    face = np.stack([u, v, 0 * u], axis=-1).reshape(-1, 3) * np.asarray(box.extent)
    local = (face @ np.asarray(box.R).T + np.asarray(box.center) - np.asarray(other.center)) @ np.asarray(other.R)
    return (np.abs(local) <= np.asarray(other.extent) / 2 + slack).all(axis=1).mean()


def matches(box, others, tolerances):
    for other in others:
        cosine = abs(np.asarray(box.R)[:, 2] @ np.asarray(other.R)[:, 2])
        if cosine > np.cos(np.radians(tolerances.patch_degrees)):
            shared = max(covered(box, other, tolerances.patch_slack), covered(other, box, tolerances.patch_slack))
            if shared > tolerances.patch_overlap:
                return True
    return False


@pytest.fixture(scope="module", params=["stored", "fitted"])
def scan(request, fragment, o3d, to_open3d):
    """Half of the fragment with normals, and Open3D's patches of it."""
    cloud = loom.PointCloud(fragment.points[::2], normals=fragment.normals[::2])
    if request.param == "fitted":
        cloud = cloud.estimate_normals(max_nn=30)
    limits = dict(TUTORIAL, min_plane_edge_length=0, min_num_points=0)
    oracle = to_open3d(cloud.points, cloud.normals)
    return cloud, oracle.detect_planar_patches(**limits, search_param=o3d.geometry.KDTreeSearchParamKNN(30))


def test_patches_of_the_fragment_are_open3ds(device, scan, tolerances):
    cloud, expected = scan
    result = cloud.to(device).detect_planar_patches(**TUTORIAL)
    for boxes, others in ((result, expected), (expected, result)):
        areas = np.array([box.extent[0] * box.extent[1] for box in boxes])
        known = np.array([matches(box, others, tolerances) for box in boxes])
        assert areas[known].sum() / areas.sum() > tolerances.patch_area


@pytest.mark.parametrize(
    ("noise", "shift", "rotated"), [(0.0, 0.0, False), (0.02, 0.0, False), (0.005, 5.0e6, True)], ids=str
)
def test_a_room_has_its_six_faces(device, noise, shift, rotated, rng):
    """Open3D detects only some of them without noise: no point is closer than 0 to an exact plane."""
    points, _ = room(rng, 12_000, noise)
    R, offset = np.eye(3), np.array([shift / 10, shift, 100])
    if rotated:
        R = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        R *= np.sign(np.linalg.det(R))
    cloud = loom.PointCloud(points @ R.T + offset, device=device).estimate_normals(max_nn=30)
    patches = cloud.detect_planar_patches()
    assert len(patches) == 6
    faces = set()
    for patch in patches:
        np.testing.assert_allclose(patch.R.T @ patch.R, np.eye(3), atol=1e-9)
        rotation, middle = R.T @ patch.R, R.T @ (patch.center - offset)
        axis = int(np.abs(rotation[:, 2]).argmax())
        assert abs(rotation[axis, 2]) > 0.999 and np.linalg.det(patch.R) > 0
        assert not rotated or np.abs(rotation[:, 0]).max() > 0.99, "sides along the room's own edges"
        faces.add((axis, bool(middle[axis] > ROOM[axis] / 2)))
        assert min(abs(middle[axis]), abs(middle[axis] - ROOM[axis])) < 0.15
        sides = np.sort(np.delete(ROOM, axis))
        assert (np.sort(patch.extent[:2]) > 0.75 * sides).all() and (np.sort(patch.extent[:2]) < sides + 0.2).all()
    assert len(faces) == 6


def test_a_floor_with_a_step_is_two_patches(device, rng):
    """The two levels do not fit each other; rough points on the step fit both, which joins them in Open3D."""
    x, y = rng.random((2, 24_000)) * [[2], [1.5]]
    rough = np.where((x > 0.95) & (x < 1.15), 0.0075, 0.003)
    height = 0.04 * np.clip((x - 1) / 0.1, 0, 1) + rough * rng.normal(size=len(x))
    frame = [[0, 0, 1.5], [2, 1.5, 1.5]]  # far above, so that a level is not an eighth of the box
    points = np.vstack([np.column_stack([x, y, height]), frame])
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    patches = sorted(cloud.detect_planar_patches(**TUTORIAL), key=lambda patch: patch.center[0])
    assert len(patches) == 2
    for patch, middle, level in zip(patches, (0.5, 1.5), (0.0, 0.04), strict=True):
        assert sorted(patch.extent)[1:] == pytest.approx([1.0, 1.5], abs=0.1)
        assert patch.center[[0, 2]] == pytest.approx([middle, level], abs=0.06)


def test_box_of_a_rectangle_is_the_rectangle(device, rng):
    """Minimal area to a tenth of a degree, all points inside up to rounding."""
    side = rng.random((20_000, 2)) * [3.0, 1.0]
    angle = np.radians(17.0)
    across = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    flat = np.column_stack([side @ across.T, 0.002 * rng.normal(size=20_000)])
    frame = np.array([[0, 0, 4.0], [3, 0, 4.2]])  # far below, so that the rectangle is not an eighth of the box
    cloud = loom.PointCloud(np.vstack([flat, frame]), device=device).estimate_normals(max_nn=20)
    (patch,) = cloud.detect_planar_patches()
    np.testing.assert_allclose(np.sort(patch.extent)[1:], [1.0, 3.0], atol=0.02)
    long_side = patch.R[:, np.argmax(patch.extent)]
    assert abs(long_side @ [np.cos(angle), np.sin(angle), 0]) > np.cos(np.radians(0.5))
    local = np.abs((cloud.points[:-2] - patch.center) @ patch.R)
    assert (local <= patch.extent / 2 + 1e-5).all(axis=1).mean() > 0.98, "its outliers may lie outside"


def test_normals_need_no_common_side(device, rng):
    """Open3D uses the median of the signed normals, which is undefined for mixed signs."""
    points, _ = room(rng, 12_000, 0.004)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    expected = cloud.detect_planar_patches()
    cloud.normals = cloud.normals * rng.choice([-1.0, 1.0], len(cloud))[:, None]
    result = cloud.detect_planar_patches()
    assert len(result) == len(expected) == 6
    for a, b in zip(result, expected, strict=True):
        np.testing.assert_allclose(a.center, b.center, atol=1e-5)
        np.testing.assert_allclose(a.extent, b.extent, atol=1e-5)


def test_a_ball_and_a_cloud_of_noise_have_no_large_patch(device, rng):
    directions = rng.normal(size=(8000, 3))
    ball = directions / np.linalg.norm(directions, axis=1, keepdims=True)
    for points in (ball, rng.random((8000, 3))):
        patches = loom.PointCloud(points, device=device).estimate_normals(max_nn=20).detect_planar_patches(20, 85, 0.3)
        assert all(patch.extent[:2].max() < 0.8 for patch in patches)


def test_limits_choose_patches(device, rng):
    points, _ = room(rng, 12_000, 0.004)
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=30)
    assert len(cloud.detect_planar_patches(min_plane_edge_length=5.0)) == 4, "the others are 4 m long"
    assert cloud.detect_planar_patches(min_plane_edge_length=50.0) == []
    assert cloud.detect_planar_patches(min_num_points=20_000) == []
    assert cloud.detect_planar_patches(normal_variance_threshold_deg=0.0) == []
    assert len(cloud.detect_planar_patches(radius=0.5)) == 6
    assert cloud.detect_planar_patches(radius=1e-6) == [], "no neighbor to grow to"


@pytest.mark.parametrize("count", [0, 1, 2, 12])
def test_clouds_of_a_few_points_have_no_patches(device, count):
    points = np.column_stack([np.arange(count), np.arange(count) % 3, np.zeros(count)]).astype(float).reshape(-1, 3)
    cloud = loom.PointCloud(points, normals=np.tile([0, 0, 1.0], (count, 1)), device=device)
    assert cloud.detect_planar_patches() == []


@pytest.mark.parametrize("points", [np.ones((500, 3)), np.outer(np.linspace(0, 1, 500), [1, 2, 3])])
def test_equal_points_and_lines_end(device, points):
    cloud = loom.PointCloud(points, device=device).estimate_normals(max_nn=10)
    patches = cloud.detect_planar_patches()
    assert all(np.sort(patch.extent)[1] < 0.002 * patch.extent.max() for patch in patches), "a tenth of a degree"


@settings(max_examples=10, deadline=None)
@given(seed=st.integers(0, 2**20), kind=st.sampled_from(["lattice", "noise", "copies", "nan"]))
def test_boxes_of_any_cloud_are_boxes(seed, kind):
    rng = np.random.default_rng(seed)
    points = rng.integers(0, 5, (150, 3)).astype(float) if kind == "lattice" else rng.random((150, 3))
    if kind == "copies":
        points = np.repeat(points[:15], 10, axis=0)
    if kind == "nan":
        points[rng.random(150) < 0.3] = np.nan
    patches = loom.PointCloud(points).estimate_normals(max_nn=8).detect_planar_patches(80, 30, 1.0, max_nn=8)
    sizes = [patch.extent[:2].prod() for patch in patches]
    assert np.isfinite(sizes).all() and (np.array(sizes) >= 0).all()


def test_a_plane_of_few_points_is_reported(device, rng):
    cloud = loom.PointCloud(rng.random((500, 3)), device=device)
    for call in (lambda: cloud.segment_plane(0.001), lambda: cloud.segment_planes(0.001, min_points=3, max_planes=1)):
        with pytest.warns(loom.UnitWarning, match="the largest one has only"):
            call()
    with pytest.warns(loom.UnitWarning, match="none has 100 points"):
        cloud.segment_planes(0.001)


def test_a_distance_beyond_the_cloud_warns_for_one_plane_and_for_several(rng, device):
    cloud = loom.PointCloud(rng.random((500, 3)), device=device)
    for search in (cloud.segment_plane, cloud.segment_planes):
        with pytest.warns(UserWarning, match="distance_threshold: 100 m exceeds the extent.*assigned to one plane"):
            search(100.0)
