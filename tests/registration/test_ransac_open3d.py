"""RANSAC against Open3D's: results from the same features, and each checker."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.globally import checkers

from .poses import as_pose

reg = loom.registration
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
    features = featured.source.feature, featured.target.feature
    result = reg.registration_ransac_based_on_feature_matching(
        *kitchen_clouds(featured, device), *features, True, DISTANCE, checkers=tutorial_checkers(reg), seed=seed
    )
    assert result.fitness > median_of_open3d - tolerances.ransac_fitness
    assert angle_between(result.transformation, featured.T) < tolerances.kitchen_degrees
    assert np.linalg.norm(result.transformation[:3, 3] - featured.T[:3, 3]) < tolerances.kitchen_distance
    assert result.converged and result.iterations < 40000
    assert result.score > 0.5


def test_fitness_error_and_correspondences_match_open3d_at_that_pose(device, featured, o3d, to_open3d, tolerances):
    features = featured.source.feature, featured.target.feature
    pair = kitchen_clouds(featured, device)
    result = reg.registration_ransac_based_on_feature_matching(*pair, *features, True, DISTANCE)
    expected = o3d.pipelines.registration.evaluate_registration(
        *(to_open3d(cloud.points) for cloud in pair), DISTANCE, result.transformation
    )
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
