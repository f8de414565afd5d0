"""Fitness, rmse, correspondences and information of two clouds under a pose match Open3D."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.spatial import cKDTree

import pointloom as loom

from ..scan_cases import on_sets
from .poses import as_pose

reg = loom.registration


def exact(points):
    """Coordinates that are exact in float32, so that both libraries see the same."""
    return np.asarray(points, np.float32).astype(np.float64)


@pytest.fixture(scope="module")
def scans(street_pair, room_pair, fragment, terrain):
    """(source, target, pose, distance) of real pairs, downsampled."""
    middle = np.floor(terrain.mean(axis=0))
    subsets = fragment.points[::9], fragment.points[4::9]
    street = [p[p.any(axis=1)] for p in (street_pair.source, street_pair.target)]  # rays without a return are at zero
    return {
        "lidar": (exact(street[0][::14]), exact(street[1][::12]), street_pair.T, 1.0),
        "room": (exact(room_pair.source[::50]), exact(room_pair.target[::50]), room_pair.T, 0.1),
        "fragment": (exact(subsets[0]), exact(subsets[1]), as_pose([0.01, 0, 0.02], [0.03, 0, 0]), 0.04),
        "terrain": (exact(terrain[::3] - middle), exact(terrain[1::3] - middle), as_pose([0, 0, 0.01], [2, 1, 0]), 8.0),
    }


ON_PAIRS = on_sets("scan", shipped=("lidar", "room", "fragment", "terrain"), real=("lidar", "room", "fragment"))


def theirs_of(o3d, source, target, distance, T):
    """Open3D's fitness, error, pairs and information."""
    clouds = [o3d.geometry.PointCloud(o3d.utility.Vector3dVector(p)) for p in (source, target)]
    result = o3d.pipelines.registration.evaluate_registration(*clouds, distance, T)
    information = o3d.pipelines.registration.get_information_matrix_from_point_clouds(*clouds, distance, T)
    return result.fitness, result.inlier_rmse, np.asarray(result.correspondence_set, np.int32), information


def assert_equal(result, theirs, source, target, T):
    """The same pairs except for ties: lattice points have several nearest neighbors."""
    fitness, rmse, other, _ = theirs
    np.testing.assert_allclose(result.fitness, fitness, rtol=1e-12)
    np.testing.assert_allclose(result.inlier_rmse, rmse, rtol=1e-7)
    mine = result.correspondence_set
    np.testing.assert_array_equal(mine[:, 0], other[:, 0])
    differ = mine[:, 1] != other[:, 1]
    moved = source[mine[differ, 0]] @ T[:3, :3].T + T[:3, 3]
    distances = [np.linalg.norm(moved - target[pairs[differ, 1]], axis=1) for pairs in (mine, other)]
    np.testing.assert_allclose(*distances, rtol=1e-5)
    assert differ.mean() < 0.02
    return differ


def check(device, case, theirs, tolerances):
    """Compare pairs, fitness, error and information with Open3D's."""
    source, target, T, distance = case
    clouds = [loom.PointCloud(p, device=device) for p in (source, target)]
    result = reg.evaluate_registration(*clouds, distance, T)
    assert theirs[0] > 0.2
    tied = assert_equal(result, theirs, source, target, T).any()
    assert result.correspondence_set.dtype == np.int32 and result.warnings == ()
    np.testing.assert_array_equal(result.transformation, T)
    assert result.iterations == 0 and not result.converged and result.degenerate_directions.shape == (0, 6)
    actual, information = reg.get_information_matrix_from_point_clouds(*clouds, distance, T), theirs[3]
    np.testing.assert_allclose(actual, information, atol=(1e-2 if tied else tolerances.information) * information.max())
    assert actual[5, 5] == len(theirs[2])
    np.testing.assert_array_equal(actual, actual.T)


@ON_PAIRS
def test_evaluations_of_real_scans_match_open3d(device, scans, o3d, scan, tolerances):
    source, target, T, distance = scans[scan]
    check(device, scans[scan], theirs_of(o3d, source, target, distance, T), tolerances)


def test_an_evaluation_matches_open3d(device, rng, oracle, tolerances):
    source, target, T = exact(rng.random((900, 3))), exact(rng.random((1200, 3))), as_pose([0.1, 0, 0.2], [0.1, 0, 0])
    theirs = oracle("registration/evaluation/rigid", theirs_of, source, target, 0.07, T)
    check(device, (source, target, T, 0.07), theirs, tolerances)


def test_information_is_about_the_world_origin(device, rng, tolerances):
    """Also at UTM coordinates: against float64 sums over the target's own world coordinates."""
    shift = np.array([5e5, 5.4e6, 120.0])
    target, source = exact(rng.random((300, 3))), exact(rng.random((200, 3)))
    clouds = [loom.PointCloud(p, device=device) for p in (source + shift + [64, 0, 0], target + shift)]
    T = as_pose([0, 0, 0], [-64, 0, 0])
    result = reg.get_information_matrix_from_point_clouds(*clouds, 0.2, T)
    pairs = reg.evaluate_registration(*clouds, 0.2, T).correspondence_set
    expected = np.zeros((6, 6))
    for x, y, z in clouds[1].points[pairs[:, 1]]:
        G = np.array([[0, z, -y, 1, 0, 0], [-z, 0, x, 0, 1, 0], [y, -x, 0, 0, 0, 1]])
        expected += G.T @ G
    np.testing.assert_allclose(result, expected, rtol=1e-10, atol=tolerances.information)
    assert len(pairs) > 150


def test_any_affine_map_is_evaluated(device, rng, oracle):
    T = np.eye(4)
    T[:3] = [[1.3, 0.2, 0, 0.1], [0, 0.8, 0.1, -0.2], [0.1, 0, -1.1, 0.9]]
    source, target = exact(rng.random((500, 3))), exact(rng.random((800, 3)))
    clouds = (loom.PointCloud(p, device=device) for p in (source, target))
    result = reg.evaluate_registration(*clouds, 0.1, T)
    theirs = oracle("registration/evaluation/affine", theirs_of, source, target, 0.1, T)
    assert_equal(result, theirs, source, target, T)


@pytest.mark.parametrize("counts", [(0, 5), (5, 0), (0, 0), (1, 1), (2, 1), (1, 2)])
def test_tiny_clouds_are_evaluated(device, counts):
    source, target = (loom.PointCloud(np.zeros((n, 3)), device=device) for n in counts)
    result = reg.evaluate_registration(source, target, 1.0)
    paired = min(counts) > 0
    assert (result.fitness, result.inlier_rmse) == (float(paired), 0.0)
    assert result.correspondence_set.shape == (counts[0] if paired else 0, 2)
    information = reg.get_information_matrix_from_point_clouds(source, target, 1.0, np.eye(4))
    np.testing.assert_array_equal(information, np.diag([0, 0, 0, 1, 1, 1]) * (counts[0] if paired else 0))


def test_pairs_remain_available_after_other_evaluations(device, rng):
    """They are fetched on first access and belong to their own evaluation."""
    source, target = (loom.PointCloud(rng.random((50, 3)), device=device) for _ in range(2))
    one = reg.evaluate_registration(source, target, 0.3)
    reg.evaluate_registration(target, source, 0.1)
    expected = reg.evaluate_registration(source, target, 0.3).correspondence_set
    np.testing.assert_array_equal(one.correspondence_set, expected)
    assert one.correspondence_set is one.correspondence_set


@settings(max_examples=25, deadline=None)
@given(
    clouds=st.tuples(
        *[hnp.arrays(np.float32, st.tuples(st.integers(0, 40), st.just(3)), elements=st.integers(0, 5))] * 2
    ),
    holes=st.integers(0, 3),
    shift=st.tuples(*[st.sampled_from([0.0, 0.25, 1.0])] * 3),
    distance=st.sampled_from([0.2, 0.5, 1.0, 1.1, 9.0]),
)
def test_evaluations_match_brute_force(clouds, holes, shift, distance):
    source, target = (c.copy() for c in clouds)
    source[: holes * 2 : 2], target[:holes] = np.nan, np.inf
    T = as_pose([0, 0, np.pi / 2], shift).round(15)
    result = reg.evaluate_registration(loom.PointCloud(source), loom.PointCloud(target), distance, T)
    is_finite, there = (np.isfinite(c).all(axis=1) for c in (source, target))
    moved = source.astype(float) @ T[:3, :3].T + T[:3, 3]
    nearest = np.full(len(source), np.inf)
    if there.any() and is_finite.any():
        nearest[is_finite] = cKDTree(target[there].astype(float)).query(moved[is_finite])[0]
    paired = nearest < distance
    np.testing.assert_array_equal(result.correspondence_set[:, 0], np.flatnonzero(paired))
    rows, columns = result.correspondence_set.T
    np.testing.assert_allclose(np.linalg.norm(moved[rows] - target[columns], axis=1), nearest[paired], atol=1e-6)
    assert result.fitness == paired.sum() / max(1, is_finite.sum())
    rmse = np.sqrt(np.square(nearest[paired]).mean()) if paired.any() else 0.0
    assert result.inlier_rmse == pytest.approx(rmse, abs=1e-6)
