"""RANSAC: robust to mostly wrong correspondences, as good as Open3D on real scans, a reason for each failure."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.globally import checkers

from .poses import as_pose, moved, pose_within
from .wrong_pairs import assert_no_pose, fgr, made_up, ransac, robust

reg = loom.registration


@pytest.mark.parametrize("ransac_n", [4, 8])
def test_any_sample_size_recovers_the_pose(device, rng, ransac_n, angle_between):
    case = made_up(rng, outliers=0.4)
    result = ransac(case, device, ransac_n=ransac_n)
    assert angle_between(result.transformation, case.T) < 0.05 and result.fitness > 0.99


@pytest.mark.slow
def test_scale_is_estimated_on_request(device, rng, angle_between):
    case = made_up(rng, outliers=0.7, scale=1.7)
    method = reg.TransformationEstimationPointToPoint(with_scaling=True)
    result = ransac(case, device, estimation_method=method)
    scale = np.cbrt(np.linalg.det(result.transformation[:3, :3]))
    assert abs(scale - 1.7) < 2e-3 and result.fitness > 0.99
    unit = result.transformation.copy()
    unit[:3, :3] /= scale
    true = case.T.copy()
    true[:3, :3] /= 1.7
    assert angle_between(unit, true) < 0.05
    assert ransac(case, device).fitness < 0.3, "a rigid motion cannot bring them together"


def test_the_best_hypothesis_is_refined_beyond_its_sample(device, rng, angle_between):
    """Without any refit the error is up to half a degree here, without the refit to the clouds 0.3."""
    case = made_up(rng, outliers=0.5, noise=0.01)
    errors = [angle_between(ransac(case, device, 0.03, seed=seed).transformation, case.T) for seed in range(4)]
    assert max(errors) < 0.1


def test_hypotheses_are_ranked_by_matches_then_distance(device, rng):
    """Two poses with the same matched points: an exact copy and one shifted by half the distance."""
    points = rng.uniform(-1, 1, (300, 3))
    shifted, rows = points + np.array([0, 5, 0]) + 0.006 * rng.choice([-1, 1], (300, 3)), np.arange(300)
    target = np.concatenate([points + np.array([5, 0, 0]), shifted])
    pairs = np.concatenate([np.column_stack([rows, rows]), np.column_stack([rows, 300 + rows])])
    for there in (target, np.roll(target, 300, axis=0)):
        result = ransac(SimpleNamespace(source=points, target=there, pairs=pairs), device, 0.05)
        np.testing.assert_allclose(result.transformation[:3, 3], [5, 0, 0], atol=1e-5)


def test_fitness_of_all_points_decides_not_the_correspondences(device, rng):
    """Most given correspondences agree on a pose that matches few of the source's points."""
    shape = rng.uniform(-1, 1, (600, 3))
    lump = rng.uniform(-0.1, 0.1, (120, 3))  # the source's corner that has a copy elsewhere in the target
    source = np.concatenate([shape, lump])
    T_true, T_lump = pose_within(rng), pose_within(rng, 8.0)
    target = np.concatenate([moved(source, T_true), moved(lump, T_lump)])
    right = np.column_stack([np.arange(60), np.arange(60)])
    wrong = np.column_stack([np.arange(600, 720), np.arange(720, 840)])
    case = SimpleNamespace(source=source, target=target, pairs=np.concatenate([right, wrong]))
    result = ransac(case, device, num_iterations=20000, confidence=1.0)
    np.testing.assert_allclose(result.transformation, T_true, atol=1e-4)


def test_normal_checker_rejects_an_upside_down_mirror_image(device, rng):
    """A flat grid fits itself face up and face down; only the normals distinguish them."""
    flat = np.column_stack([rng.uniform(-1, 1, (400, 2)), np.zeros(400)])
    rotation = np.diag([1.0, -1, -1, 1])
    both = np.concatenate([flat, moved(flat, rotation)])
    normals = np.tile([0, 0, 1.0], (400, 1))
    rows = np.arange(400)
    pairs = np.concatenate([np.column_stack([rows, rows]), np.repeat(np.column_stack([rows, 400 + rows]), 3, 0)])
    source = loom.PointCloud(flat, normals=normals, device=device)
    target = loom.PointCloud(both, normals=np.concatenate([normals, normals]), device=device)
    checker = [reg.CorrespondenceCheckerBasedOnNormal(0.5)]
    result = reg.registration_ransac_based_on_correspondence(source, target, pairs, 0.02, checkers=checker)
    np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-5)
    bare = loom.PointCloud(flat, device=device), loom.PointCloud(both, device=device)
    result = reg.registration_ransac_based_on_correspondence(*bare, pairs, 0.02, checkers=checker)
    assert result.fitness > 0.99, "missing normals pass"


def test_rotation_checker_selects_the_smaller_rotation(device, rng):
    points = rng.uniform(-1, 1, (300, 3))
    rotated = moved(points, np.diag([-1.0, -1, 1, 1])) + np.array([4, 0, 0])
    pairs = np.concatenate([np.column_stack([np.arange(300), k * 300 + np.arange(300)]) for k in (0, 1, 1, 1)])
    case = SimpleNamespace(source=points, target=np.concatenate([points, rotated]), pairs=pairs)
    level = reg.CorrespondenceCheckerBasedOnSourceRotation([0.2, 0.2, 1.0])
    np.testing.assert_allclose(ransac(case, device, checkers=[level]).transformation, np.eye(4), atol=1e-5)


def test_confidence_one_draws_all_hypotheses(device, rng):
    case = made_up(rng, 200, outliers=0.0)
    result = ransac(case, device, num_iterations=7000, confidence=1.0)
    assert result.iterations == 7000 and not result.converged and "within 7,000 iterations" in result.warnings[0]
    assert result.fitness > 0.99


def test_one_iteration_suffices_without_outliers(device, rng):
    case = made_up(rng, 200, outliers=0.0, noise=0.0)
    result = ransac(case, device, num_iterations=1)
    assert result.iterations == 1 and result.fitness == 1


def test_another_seed_gives_other_samples(device, rng):
    case = made_up(rng, outliers=0.9, noise=0.005)
    few = 40  # so few that chance decides
    poses = {ransac(case, device, seed=seed, num_iterations=few).transformation.tobytes() for seed in range(5)}
    assert len(poses) == 5


def test_the_stricter_of_two_checkers_applies_on_the_device():
    normal, edges, distance, rotation = (
        reg.CorrespondenceCheckerBasedOnNormal, reg.CorrespondenceCheckerBasedOnEdgeLength,
        reg.CorrespondenceCheckerBasedOnDistance, reg.CorrespondenceCheckerBasedOnSourceRotation,
    )  # fmt: skip
    alone = checkers.checks_of([normal(0.3), edges(0.8), distance(0.05), rotation([0.1, 2.0, 0.3])])
    assert (alone.cosine, alone.similarity, alone.distance) == (np.cos(0.3), 0.8, 0.05)
    assert tuple(alone.rotation) == (0.1, 2.0, 0.3)
    strict, loose = [normal(0.3), edges(0.8), distance(0.05)], [normal(0.5), edges(0.7), distance(0.06)]
    for pairs in (strict + loose, loose + strict):
        both = checkers.checks_of([*pairs, rotation([0.1, 3.0, 0.4]), rotation([0.2, 2.0, 0.3])])
        assert (both.cosine, both.similarity, both.distance) == (np.cos(0.3), 0.8, 0.05)
        assert tuple(both.rotation) == (0.1, 2.0, 0.3)


def test_a_pose_with_a_low_score_is_unreliable_although_the_search_converged(device, rng):
    case = made_up(rng, 200, outliers=0.0)
    result = ransac(case, device)
    assert result.converged and result.score == 0, "scattered points show no surface"
    assert not result.reliable and result.to_dict()["reliable"] is False
    assert result.warnings[0].startswith("the score is 0.00, not above 0.5")
    result.score = 0.9
    assert result.reliable and result.to_dict()["warnings"] == []


VOXEL = 0.05  # [m] of the kitchen
DISTANCE = 1.5 * VOXEL


def tutorial_checkers(library, distance=DISTANCE):
    return [library.CorrespondenceCheckerBasedOnEdgeLength(0.9), library.CorrespondenceCheckerBasedOnDistance(distance)]


@pytest.fixture(scope="module")
def median_of_open3d(featured, o3d, to_open3d):
    """The median fitness of Open3D over nine seeds, from the same points and features.

    Its fitness ranges from 0.58 to 0.61 with the seed, pointloom's from 0.605 to 0.606: the best of three is random.
    """
    r = o3d.pipelines.registration
    pair, features = [], []
    for cloud in (featured.source, featured.target):
        pair.append(to_open3d(cloud.points, cloud.normals))
        feature = r.Feature()
        feature.data = cloud.feature.T.astype(np.float64)
        features.append(feature)
    method, criteria = r.TransformationEstimationPointToPoint(False), r.RANSACConvergenceCriteria(100000, 0.999)
    fitnesses = []
    for seed in range(9):
        o3d.utility.random.seed(seed)
        result = r.registration_ransac_based_on_feature_matching(
            *pair, *features, True, DISTANCE, method, 3, tutorial_checkers(r), criteria
        )
        fitnesses.append(result.fitness)
    return float(np.median(fitnesses))


def kitchen_clouds(featured, device):
    return [loom.PointCloud(c.points, normals=c.normals, device=device) for c in (featured.source, featured.target)]


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
def test_kitchen_is_registered_at_least_as_well_as_by_open3d(
    device, featured, median_of_open3d, seed, angle_between, tolerances
):
    pairs = reg.correspondences_from_features(featured.source.feature, featured.target.feature, True)
    given = *kitchen_clouds(featured, device), pairs, DISTANCE
    limits = [reg.CorrespondenceCheckerBasedOnEdgeLength(0.9), reg.CorrespondenceCheckerBasedOnDistance(DISTANCE)]
    result = reg.registration_ransac_based_on_correspondence(*given, checkers=limits, seed=seed)
    assert result.fitness > median_of_open3d - tolerances.ransac_fitness
    assert angle_between(result.transformation, featured.T) < tolerances.kitchen_degrees
    assert np.linalg.norm(result.transformation[:3, 3] - featured.T[:3, 3]) < tolerances.kitchen_distance
    assert result.converged and result.iterations < 40000
    assert result.score > 0.5


def test_fitness_error_and_correspondences_match_open3d_at_that_pose(device, featured, o3d, to_open3d, tolerances):
    pairs = reg.correspondences_from_features(featured.source.feature, featured.target.feature, True)
    pair = kitchen_clouds(featured, device)
    result = reg.registration_ransac_based_on_correspondence(*pair, pairs, DISTANCE)
    clouds = (to_open3d(cloud.points) for cloud in pair)
    expected = o3d.pipelines.registration.evaluate_registration(*clouds, DISTANCE, result.transformation)
    assert abs(result.fitness - expected.fitness) <= 1.5 / len(pair[0]), "a point at the very distance"
    assert abs(result.inlier_rmse - expected.inlier_rmse) < tolerances.distance_absolute
    actual, theirs = ({tuple(pair) for pair in np.asarray(r.correspondence_set)} for r in (result, expected))
    assert len(actual ^ theirs) <= 4


CHECKERS = {
    "length": lambda r: r.CorrespondenceCheckerBasedOnEdgeLength(0.7),
    "distance": lambda r: r.CorrespondenceCheckerBasedOnDistance(0.6),
    "normal": lambda r: r.CorrespondenceCheckerBasedOnNormal(1.2),
    "rotation": lambda r: r.CorrespondenceCheckerBasedOnSourceRotation(np.array([1.5, 1.2, 2.0])),
}


def small_cases():
    """Lattice clouds with equal lengths and coincident points, pairs and poses."""
    for seed in range(120):
        rng = np.random.default_rng(seed)
        points = rng.integers(0, 3, (2, 6, 3)).astype(float)
        points[1] = points[int(seed % 2 == 0)] + 0.1 * rng.random()
        normals = rng.normal(size=(2, 6, 3))
        normals /= np.linalg.norm(normals, axis=2, keepdims=True)
        pairs, T = rng.integers(0, 6, (1 + seed % 5, 2)).astype(np.int32), as_pose(rng.normal(size=3), rng.random(3))
        pairs[:, 1] = pairs[:, int(seed % 4 == 0)]
        yield points, normals.astype(np.float32) if seed % 3 else None, pairs, np.eye(4) if seed % 2 else T


def checked_by_open3d(o3d):
    """Whether each of the small cases passes each checker."""
    theirs, results = o3d.pipelines.registration, []
    for points, normals, pairs, T in small_cases():
        clouds = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(p)) for p in points.astype(np.float32)]
        for cloud, n in zip(clouds, () if normals is None else normals):  # noqa: B905
            cloud.normals = o3d.utility.Vector3dVector(n)
        pairs = o3d.utility.Vector2iVector(pairs)
        results.append([make(theirs).Check(*clouds, pairs, T) for make in CHECKERS.values()])
    return np.array(results)


def test_checkers_match_open3d(oracle):
    expected = oracle("registration/ransac/checkers", checked_by_open3d)
    assert (expected.mean(axis=0) > 0.05).all() and (expected.mean(axis=0) < 0.95).all()
    for (points, normals, pairs, T), answers in zip(small_cases(), expected, strict=True):
        normals = [None, None] if normals is None else normals
        clouds = [loom.PointCloud(p, normals=n) for p, n in zip(points, normals, strict=True)]
        assert [make(checkers).Check(*clouds, pairs, T) for make in CHECKERS.values()] == answers.tolist()


# For each method: its call, the minimal number of correspondences, and the pose errors [degrees], [m].
METHODS = {"ransac": (ransac, 3, 0.05, 1e-3), "fgr": (fgr, 10, 0.5, 0.01), "robust": (robust, 3, 0.5, 0.01)}
EACH = pytest.mark.parametrize("method", METHODS)


@pytest.mark.parametrize(
    ("method", "outliers"),
    [("ransac", 0.0), ("ransac", 0.95), ("fgr", 0.0), ("fgr", 0.8), ("fgr", 0.95), ("robust", 0.5), ("robust", 0.98)],
)
def test_the_pose_is_estimated_among_outlier_correspondences(device, rng, method, outliers, angle_between):
    case, (run, _, degrees, distance) = made_up(rng, outliers=outliers), METHODS[method]
    result = run(case, device)
    assert angle_between(result.transformation, case.T) < degrees
    assert np.linalg.norm(result.transformation[:3, 3] - case.T[:3, 3]) < distance
    assert result.fitness > 0.95 and result.converged and result.transformation.dtype == np.float64


@EACH
def test_too_few_correspondences_fail_with_a_reason(device, rng, method):
    run, minimum, _, _ = METHODS[method]
    for count in (0, 1, minimum - 1):
        case = made_up(rng, 50, outliers=0.0)
        case.pairs = case.pairs[:count]
        result = run(case, device)
        assert (result.transformation == np.eye(4)).all() and result.score == 0 and not result.converged
        (warning,) = result.warnings
        assert f"{count} given" in warning or f"of {count} correspondences" in warning


def test_empty_clouds_fail_with_a_reason(device):
    empty, one = loom.PointCloud(np.empty((0, 3)), device=device), loom.PointCloud([[0, 0, 0]], device=device)
    for pair in ((empty, empty), (empty, one), (one, empty)):
        result = reg.registration_ransac_based_on_correspondence(*pair, np.empty((0, 2)), 0.1)
        assert_no_pose(result, "0 given")
        assert_no_pose(reg.registration_fgr_based_on_correspondence(*pair, np.empty((0, 2))), "0 given")


@pytest.mark.parametrize("shape", ["one place", "line", "plane"])
def test_degenerate_clouds_raise_no_exception(device, rng, shape):
    t = rng.uniform(-1, 1, (200, 1))
    points = {
        "one place": np.ones((200, 3)),
        "line": t * [1, 2, 3],
        "plane": np.column_stack([t, rng.uniform(-1, 1, 200), np.zeros(200)]),
    }[shape]
    pairs = np.column_stack([np.arange(200)] * 2)
    case = SimpleNamespace(source=points, target=np.add(points, [1.0, 0, 0]), pairs=pairs)
    scaled = reg.TransformationEstimationPointToPoint(True)
    results = [ransac(case, device, estimation_method=method, num_iterations=3000) for method in (None, scaled)]
    results += [fgr(case, device, tuple_test=tested) for tested in (True, False)]
    for k, result in enumerate(results):
        assert np.isfinite(result.transformation).all()
        if shape == "one place" and k < 3:
            assert_no_pose(result, "no hypothesis passed" if k < 2 else "0 left")
        else:
            np.testing.assert_allclose(moved(points, result.transformation), case.target, atol=1e-5)
            assert result.fitness == 1
