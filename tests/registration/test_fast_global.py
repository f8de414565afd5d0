"""Global registration from correspondences, fast or robust to nearly all outliers, compared with Open3D."""

from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom
from pointloom.registration.globally import global_registration
from pointloom.registration.globally.global_registration import rate_support

from .hilly_clouds import misplacement
from .poses import as_pose, moved, random_pose
from .wrong_pairs import assert_no_pose, fgr, made_up, robust

reg = loom.registration
VOXEL = 0.05  # [m] of the kitchen


def test_pose_is_exact_once_mu_is_small(device, rng, angle_between):
    """After 16 steps mu is a 15th of its initial value, after 64 below the squared distance."""
    case = made_up(rng, outliers=0.5, noise=0.0)
    results = (fgr(case, device, iteration_number=n, tuple_test=False) for n in (16, 64))
    errors = [angle_between(result.transformation, case.T) for result in results]
    assert errors[1] < 0.02 < errors[0] + 0.02 and errors[1] < errors[0]


def test_triples_exclude_pairs_that_change_lengths(device, rng, angle_between):
    """Nine of ten source points are matched to the same few target points, as features of flat regions are."""
    case = made_up(rng, outliers=0.0, shuffle=False)
    case.pairs[150:, 1] = rng.integers(0, 3, 1350)
    with_test, without = (fgr(case, device, tuple_test=on) for on in (True, False))
    assert angle_between(with_test.transformation, case.T) < 0.5
    assert angle_between(without.transformation, case.T) > 5


def test_result_does_not_depend_on_the_unit_of_length(device, rng):
    """Open3D compares the radius in meters with a squared distance of normalized clouds, which changes the schedule."""
    case = made_up(rng, outliers=0.8)
    in_meters = fgr(case, device)
    for unit in (1024.0, 1 / 1024):  # exact in float32
        scaled = SimpleNamespace(source=unit * case.source, target=unit * case.target, pairs=case.pairs)
        result = fgr(scaled, device, maximum_correspondence_distance=0.025 * unit)
        np.testing.assert_allclose(result.transformation[:3, :3], in_meters.transformation[:3, :3], atol=1e-12)
        np.testing.assert_allclose(result.transformation[:3, 3] / unit, in_meters.transformation[:3, 3], atol=1e-11)


def test_mu_decreases_by_default(device, rng, angle_between):
    case = made_up(rng, outliers=0.5)
    decreased, constant = fgr(case, device), fgr(case, device, decrease_mu=False)
    assert reg.FastGlobalRegistrationOption().decrease_mu
    assert angle_between(decreased.transformation, case.T) < 0.3 * angle_between(constant.transformation, case.T)


def test_absolute_scale_starts_at_one_meter(device, rng, angle_between):
    """A cloud of 100 m radius, one meter apart: mu of 1 m^2 selects the right pairs from the first step."""
    case = made_up(rng, outliers=0.6, noise=1e-4, shuffle=False)
    case.source = 100 * case.source
    case.T = as_pose(shift=[0.3, -0.2, 0.4])
    case.target = moved(case.source, case.T) + 0.01 * rng.normal(size=(1500, 3))
    options = {"maximum_correspondence_distance": 0.1, "tuple_test": False, "decrease_mu": False}
    absolute, relative = (fgr(case, device, use_absolute_scale=on, **options) for on in (True, False))
    assert angle_between(absolute.transformation, case.T) < 0.01 < angle_between(relative.transformation, case.T)
    assert absolute.fitness > 0.99


def annealed(case, steps, *, division_factor=1.4, use_absolute_scale=False, max_distance=0.025):
    """The pose after these steps of Zhou et al., each with weights (mu / (mu + r^2))^2 and a closed form."""
    source, target = case.source[case.pairs[:, 0]], case.target[case.pairs[:, 1]]
    corners = [np.array([cloud.min(0), cloud.max(0)]) for cloud in (case.source, case.target)]
    T = as_pose(shift=corners[1].mean(0) - corners[0].mean(0))
    mu = 1.0 if use_absolute_scale else max(((high - low) ** 2).sum() / 4 for low, high in corners)
    for step in range(steps):
        w = (mu / (mu + ((moved(source, T) - target) ** 2).sum(1))) ** 2
        a, b = w @ source / w.sum(), w @ target / w.sum()
        U, _, V = np.linalg.svd(((target - b) * w[:, None]).T @ (source - a))
        T[:3, :3] = U @ np.diag([1, 1, np.linalg.det(U @ V)]) @ V
        T[:3, 3] = b - T[:3, :3] @ a
        if mu > max_distance**2 and step % 2 == 0:
            mu /= division_factor
    return T


@pytest.mark.parametrize("options", [{}, {"division_factor": 2.5}, {"use_absolute_scale": True}])
@pytest.mark.parametrize("steps", [2, 9])
def test_mu_follows_its_schedule(device, rng, options, steps):
    case = made_up(rng, count=300, outliers=0.6)
    result = fgr(case, device, iteration_number=steps, tuple_test=False, **options)
    np.testing.assert_allclose(result.transformation, annealed(case, steps, **options), atol=1e-5)


def test_triples_have_sides_of_a_minimum_ratio_and_a_maximum_count(device, rng):
    case = made_up(rng, outliers=0.0)
    case.target = 0.9 * case.target
    assert_no_pose(fgr(case, device, tuple_scale=0.95), "10 correspondences needed, 0 left after the tuple test")
    assert fgr(case, device, tuple_scale=0.85, maximum_correspondence_distance=0.2).fitness > 0.9
    case.target = case.target / 0.9
    assert_no_pose(fgr(case, device, maximum_tuple_count=3), "10 correspondences needed, 9 left after the tuple test")
    assert fgr(case, device, maximum_tuple_count=30).fitness > 0.9


def fgr_of_open3d(o3d, case):
    theirs = o3d.pipelines.registration
    o3d.utility.random.seed(0)
    clouds = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(p)) for p in (case.source, case.target)]
    option = theirs.FastGlobalRegistrationOption(decrease_mu=True, maximum_correspondence_distance=0.025)
    pairs = o3d.utility.Vector2iVector(case.pairs.astype(np.int32))
    result = theirs.registration_fgr_based_on_correspondence(*clouds, pairs, option)
    return result.transformation, result.fitness


@pytest.mark.parametrize("outliers", [0.5, 0.8])
def test_errors_are_at_most_those_of_open3d(device, rng, outliers, angle_between, oracle):
    case = made_up(rng, outliers=outliers)
    expected, fitness = oracle(f"registration/fast_global/{outliers}", fgr_of_open3d, case)
    result = fgr(case, device)
    assert angle_between(result.transformation, case.T) <= angle_between(expected, case.T) + 0.05
    assert result.fitness >= fitness - 0.01


@pytest.fixture(scope="module")
def featured(room_pair):
    """The scans of the room in voxels, with features and estimated normals."""
    pair = SimpleNamespace(T=room_pair.T)
    for name in ("source", "target"):
        cloud = loom.PointCloud(getattr(room_pair, name)).voxel_down_sample(VOXEL)
        cloud = cloud.estimate_normals(radius=2 * VOXEL, max_nn=30)
        feature = loom.compute_fpfh_feature(cloud, radius=5 * VOXEL, max_nn=100)
        setattr(pair, name, SimpleNamespace(points=cloud.points, feature=feature.copy()))
    return pair


@pytest.fixture(scope="module")
def best_of_open3d(featured, o3d, to_open3d):
    """The best fitness of Open3D over three seeds, from the same points and features."""
    r = o3d.pipelines.registration
    features = [r.Feature(), r.Feature()]
    for feature, cloud in zip(features, (featured.source, featured.target), strict=True):
        feature.data = cloud.feature.T.astype(np.float64)
    pair = [to_open3d(cloud.points) for cloud in (featured.source, featured.target)]
    option = r.FastGlobalRegistrationOption(maximum_correspondence_distance=VOXEL / 2, decrease_mu=True)
    fitnesses = []
    for seed in range(3):
        o3d.utility.random.seed(seed)
        fitnesses.append(r.registration_fgr_based_on_feature_matching(*pair, *features, option).fitness)
    return max(fitnesses)


@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_kitchen_is_registered(device, featured, seed, angle_between, tolerances):
    result = of_kitchen(device, featured, VOXEL / 2, seed)
    assert result.score > 0.5 and angle_between(result.transformation, featured.T) < tolerances.fgr_degrees
    assert np.linalg.norm(result.transformation[:3, 3] - featured.T[:3, 3]) < tolerances.kitchen_distance


def test_kitchen_is_registered_as_well_as_by_open3d_at_its_final_scale(device, featured, best_of_open3d, tolerances):
    """Open3D's final mu is the distance in meters, pointloom's its square: the equivalent scale is that of the root."""
    pair = [loom.PointCloud(c.points, device=device) for c in (featured.source, featured.target)]
    for seed in range(3):
        T = of_kitchen(device, featured, np.sqrt(VOXEL / 2), seed).transformation
        assert reg.evaluate_registration(*pair, VOXEL / 2, T).fitness > best_of_open3d - tolerances.fgr_fitness


def of_kitchen(device, featured, distance, seed):
    pair = [loom.PointCloud(c.points, device=device) for c in (featured.source, featured.target)]
    option = reg.FastGlobalRegistrationOption(maximum_correspondence_distance=distance)
    features = featured.source.feature, featured.target.feature
    pairs = reg.correspondences_from_features(*features, True, 0.0)
    return reg.registration_fgr_based_on_correspondence(*pair, pairs, option, seed=seed)


def test_outliers_alone_fail_with_a_reason(device, rng):
    case = made_up(rng, 40, outliers=1.0)
    case.target = rng.uniform(-1000, 1000, (40, 3))
    assert_no_pose(fgr(case, device, tuple_scale=1.0), "10 correspondences needed, 0 left after the tuple test")


def test_another_seed_gives_other_triples(device, rng):
    case = made_up(rng, outliers=0.9, noise=0.01)
    assert (fgr(case, device, 3).transformation != fgr(case, device, 4).transformation).any()


def rough_pair(rng, count=1000, right=30, noise=0.003):
    """Random points in a unit cube, moved, with `count` correspondences of which `right` are correct."""
    p, T = rng.random((count, 3)), random_pose(rng)
    q = moved(p, T) + rng.normal(0, noise, p.shape)
    pairs = np.column_stack([np.arange(count), np.arange(count)])
    pairs[right:, 1] = rng.integers(0, count, count - right)
    return SimpleNamespace(source=p, target=q, pairs=pairs[rng.permutation(count)], T=T)


def assert_placed(result, case, tolerances):
    points = case.source[np.isfinite(case.source).all(axis=1)]
    angle, distance = misplacement(result.transformation, case.T, points)
    assert angle < tolerances.robust_degrees and distance < tolerances.robust_distance


@pytest.mark.slow
def test_one_percent_of_ten_thousand_correspondences_suffices(device, rng, tolerances):
    case = rough_pair(rng, 10000, 100, noise=0.002)
    result = robust(case, device, 0.01)
    assert_placed(result, case, tolerances)
    assert result.score > 0.9


def test_outliers_alone_are_rejected(device, rng):
    for count in (20, 200, 1500):
        result = robust(rough_pair(rng, count, 0), device)
        assert result.score < 0.3 and not result.converged


def test_two_motions_with_equal_support_are_ambiguous(device, rng):
    p = rng.random((200, 3))
    q = np.vstack([moved(p[:100], random_pose(rng)), moved(p[100:], random_pose(rng))])
    pairs = np.column_stack([np.arange(200)] * 2)
    cases = (SimpleNamespace(source=p, target=q, pairs=pairs[:count]) for count in (200, 125))
    even, majority = (robust(case, device, 0.01) for case in cases)
    assert even.score < 0.1 and not even.converged and "another pose" in even.warnings[0]
    assert majority.score > 0.8 and majority.converged


@settings(max_examples=15, deadline=None)
@given(seed=st.integers(0, 2**31 - 1), count=st.integers(8, 40))
def test_exact_correspondences_give_the_exact_pose(seed, count):
    rng = np.random.default_rng(seed)
    T, p = random_pose(rng, 10.0), rng.random((count, 3))
    pairs = np.column_stack([np.arange(count)] * 2)
    result = robust(SimpleNamespace(source=p, target=moved(p, T), pairs=pairs), bound=0.02)
    np.testing.assert_allclose(result.transformation, T, atol=1e-5 * (1 + np.abs(T).max()))
    assert result.fitness == 1.0


def test_non_finite_points_and_duplicates_change_nothing(device, rng, tolerances):
    case = rough_pair(rng, 500, 40)
    case.source[7], case.target[9, 1] = np.nan, np.inf
    wrong = case.pairs[case.pairs[:, 0] != case.pairs[:, 1]]
    case.pairs = np.vstack([case.pairs, np.repeat(wrong[:1], 300, axis=0)])  # one wrong correspondence, 300 times
    assert_placed(robust(case, device), case, tolerances)


def test_a_pose_from_three_correspondences_is_rejected(device):
    cloud = loom.PointCloud(np.eye(3), device=device)
    result = reg.registration_robust_based_on_correspondence(cloud, cloud, [[0, 0], [1, 1], [2, 2]], 0.1)
    np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-6)
    assert result.score < 0.1


def test_the_seed_selects_among_too_many_correspondences(device, rng, tolerances, monkeypatch):
    monkeypatch.setattr(global_registration, "MAX_PAIRS", 300)
    case = rough_pair(rng, 1000, 400)
    results = [robust(case, device, seed=seed) for seed in (0, 0, 1)]
    one, same, other = (result.transformation for result in results)
    assert (one == same).all() and (one != other).any()
    for result in results:
        assert_placed(result, case, tolerances)


def test_score_grows_with_the_lead_over_the_second_pose():
    assert rate_support(np.array([])) == 0.0 and rate_support(np.array([3.0])) < 0.1
    assert rate_support(np.array([22.0, 10.0])) == pytest.approx(0.5)
    scores = [rate_support(np.array([k, 10.0])) for k in (10, 15, 22, 40, 100)]
    assert np.all(np.diff(scores) > 0) and scores[-1] > 0.99


@pytest.mark.slow
def test_features_give_the_pose_and_the_clouds_rate_it(device, hilly_pair, angle_between):
    source, target, T = hilly_pair
    clouds = []
    for points in (source, target):
        thinned = loom.PointCloud(points, device=device).voxel_down_sample(0.05)
        thinned = thinned.estimate_normals(radius=0.15, max_nn=None)
        clouds.append(thinned.orient_normals_towards_camera_location(thinned.points.mean(axis=0)))
    features = [loom.compute_fpfh_feature(cloud, radius=0.25, max_nn=None) for cloud in clouds]
    for mutual in (True, False):
        pairs = reg.correspondences_from_features(*features, mutual, 0.0)
        result = reg.registration_robust_based_on_correspondence(*clouds, pairs, 0.075)
        assert angle_between(result.transformation, T) < 1.5
        assert reg.assess_registration(*clouds, result.transformation, 0.075).score > 0.5
