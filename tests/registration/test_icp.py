"""Iterative closest points: accuracy, termination, and reproducibility."""

import dataclasses

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import pointloom as loom

from .icp_clouds import EACH, KINDS, PLANE, assert_rigid, back, on, wavy
from .poses import as_pose

reg = loom.registration


def test_two_samplings_of_a_surface_align_to_a_thousandth_of_a_degree(device, rng, angle_between):
    """20 point-to-plane steps without noise: 50,000 points, as coarser samplings leave the curvature between them."""
    T = as_pose([0.02, -0.02, 0.02], [0.02, -0.01, 0.015])  # 2 degrees and 2.7 cm
    target = loom.PointCloud(wavy(rng, 50_000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(wavy(rng, 50_000), T), device=device)
    result = reg.registration_icp(source, target, 0.1, None, PLANE, reg.ICPConvergenceCriteria(0, 0, 20))
    assert angle_between(result.transformation, T) < 0.001
    assert np.abs(result.transformation[:3, 3] - T[:3, 3]).max() < 2e-5


@pytest.mark.parametrize(
    ("kind", "degrees"),
    [("plane", 0.02), ("symmetric", 0.01), ("generalized", 0.01), ("colored", 0.02), ("point", 0.4)],
)
def test_every_estimator_converges_to_the_pose(device, full_pair, kind, degrees, angle_between):
    source, target = on(device, *full_pair[:2])
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 100)
    result = reg.registration_icp(source, target, 0.15, None, KINDS[kind], rules)
    assert angle_between(result.transformation, full_pair[2]) < degrees
    assert result.fitness > 0.99 and len(result.degenerate_directions) == 0
    assert_rigid(result.transformation)


@EACH
def test_a_step_far_from_the_origin_equals_one_near_it(device, full_pair, kind):
    """Rotations are linearized about the pairs: about the origin, 500 m away, a 1 degree step would miss by 8 cm."""
    if kind == "doppler":
        pytest.skip("the origin is the sensor")
    clouds, o = on(device, *full_pair[:2]), np.array([512.0, -256, 64])
    far = [
        loom.PointCloud(c.points + o, origin=[0, 0, 0], normals=c.normals, colors=c.colors, device=device)
        for c in clouds
    ]
    rules = reg.ICPConvergenceCriteria(0, 0, 3)
    near, moved = (reg.registration_icp(*pair, 0.15, None, KINDS[kind], rules) for pair in (clouds, far))
    shift = as_pose([0, 0, 0], o)
    expected = shift @ near.transformation @ np.linalg.inv(shift)
    # positions and voxels are rounded to 3e-5 m at 512 m
    np.testing.assert_allclose((expected @ np.append(o, 1)), moved.transformation @ np.append(o, 1), atol=2e-3)


@EACH
def test_a_cloud_matches_itself(device, full_pair, kind):
    target = on(device, full_pair[1])[0]
    result = reg.registration_icp(target, target, 0.1, None, KINDS[kind])
    if kind != "voxelized":  # where points match the means of voxels
        np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-12)
        assert (result.fitness, result.iterations) == (1.0, 1) and result.inlier_rmse < 1e-12
    assert result.converged and result.reliable and result.warnings == ()


@pytest.mark.parametrize("scale", [0.8, 1.0, 1.25])
def test_a_scale_is_recovered(device, rng, scale):
    target = rng.random((1500, 3))
    T = as_pose([0.01, 0.02, -0.01], [0.01, 0, 0.01])
    T[:3, :3] *= scale
    source, target = (
        loom.PointCloud(p, device=device) for p in ((target - T[:3, 3]) @ np.linalg.inv(T[:3, :3]).T, target)
    )
    rules = reg.ICPConvergenceCriteria(1e-12, 1e-12, 200)
    init = np.diag([scale * 0.98] * 3 + [1.0])
    result = reg.registration_icp(source, target, 0.3, init, KINDS["scaled"], rules)
    np.testing.assert_allclose(result.transformation, T, atol=1e-6)
    assert_rigid(reg.registration_icp(source, target, 0.3, None, KINDS["point"], rules).transformation)


def test_a_collapsing_scale_is_not_converged(device, rng):
    """Every point of a ball that shrinks to a point of a plane has a correspondence there."""
    ball, plane = rng.normal(size=(600, 3)), np.c_[rng.uniform(-2, 2, (900, 2)), np.zeros(900)]
    ball /= np.linalg.norm(ball, axis=1)[:, None]
    source, target = (loom.PointCloud(p, device=device) for p in (ball + np.array([0, 0, 3.0]), plane))
    method = reg.TransformationEstimationPointToPoint(with_scaling=True)
    wrong = np.c_[np.arange(600), rng.integers(0, 900, 600)]
    for result in (
        reg.registration_icp(source, target, 5.0, None, method, reg.ICPConvergenceCriteria(max_iteration=200)),
        reg.registration_ransac_based_on_correspondence(source, target, wrong, 0.15, method, seed=1),
    ):
        assert result.fitness == 1 and not result.converged and "scale" in result.warnings[0]


@EACH
def test_zero_iterations_only_evaluate(device, full_pair, kind):
    source, target = on(device, *full_pair[:2])
    init = as_pose([0.02, 0, 0], [0, 0.02, 0])
    result = reg.registration_icp(source, target, 0.1, init, KINDS[kind], reg.ICPConvergenceCriteria(max_iteration=0))
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.iterations, result.converged, result.reliable) == (0, False, False)
    assert result.warnings == ("ICP did not converge within 0 iterations",)
    if kind != "voxelized":
        expected = reg.evaluate_registration(source, target, 0.1, init)
        assert (result.fitness, result.inlier_rmse) == (expected.fitness, expected.inlier_rmse)
        np.testing.assert_array_equal(result.correspondence_set, expected.correspondence_set)


@EACH
def test_a_result_describes_its_pose(device, full_pair, kind):
    """Fitness, rmse and pairs are those under the final transformation, not before the last step."""
    source, target = on(device, *full_pair[:2])
    result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], reg.ICPConvergenceCriteria(0, 0, 3))
    assert (result.iterations, result.warnings) == (3, ("ICP did not converge within 3 iterations",))
    if kind != "voxelized":
        expected = reg.evaluate_registration(source, target, 0.1, result.transformation)
        assert result.fitness == expected.fitness
        assert result.inlier_rmse == pytest.approx(expected.inlier_rmse, abs=1e-9)
        np.testing.assert_array_equal(result.correspondence_set, expected.correspondence_set)


@pytest.mark.parametrize(
    ("kind", "limits"),
    [("point", (1e-6, 1e-6)), ("plane", (1e-6, 1e-6)), ("plane", (1e-2, 1e-3)), ("point", (1e-3, 1.0)),
     ("plane", (1.0, 1e-5))],
)  # fmt: skip
def test_it_stops_when_both_changes_are_below_their_limits(device, full_pair, kind, limits):
    """Compared after each step with the previous evaluation, including the initial one."""
    source, target = on(device, *full_pair[:2])
    iterations = []
    criteria = reg.ICPConvergenceCriteria(*limits, 60)
    result = reg.registration_icp(
        source, target, 0.05, None, KINDS[kind], criteria, callback_after_iteration=iterations.append
    )
    start = reg.evaluate_registration(source, target, 0.05)
    fitness = np.array([start.fitness, *(t["fitness"] for t in iterations)])
    rmse = np.array([start.inlier_rmse, *(t["inlier_rmse"] for t in iterations)])
    met = (np.abs(np.diff(fitness)) < limits[0]) & (np.abs(np.diff(rmse)) < limits[1])
    assert met.any() and result.converged
    assert result.iterations == len(iterations) == np.flatnonzero(met)[0] + 1


def test_the_callback_receives_each_iteration(device, full_pair):
    source, target = on(device, *full_pair[:2])
    iterations = []
    rules = reg.ICPConvergenceCriteria(0, 0, 4)
    result = reg.registration_icp(source, target, 0.1, None, PLANE, rules, callback_after_iteration=iterations.append)
    assert [t["iteration_index"] for t in iterations] == [1, 2, 3, 4]
    for steps, iteration in enumerate(iterations, 1):
        assert set(iteration) == {"iteration_index", "transformation", "fitness", "inlier_rmse"}
        alone = reg.registration_icp(source, target, 0.1, None, PLANE, reg.ICPConvergenceCriteria(0, 0, steps))
        np.testing.assert_array_equal(iteration["transformation"], alone.transformation)
        assert (iteration["fitness"], iteration["inlier_rmse"]) == (alone.fitness, alone.inlier_rmse)
    np.testing.assert_array_equal(iterations[-1]["transformation"], result.transformation)
    none, rules = [], reg.ICPConvergenceCriteria(max_iteration=0)
    reg.registration_icp(source, target, 0.1, None, PLANE, rules, callback_after_iteration=none.append)
    assert none == []


# Colors and speeds have units of their own.
@pytest.mark.parametrize(
    ("kind", "exponent"),
    [("point", -42), ("scaled", -20), ("plane", -42), ("plane", 8), ("symmetric", -20), ("generalized", -42),
     ("voxelized", 8)],
)  # fmt: skip
def test_registration_is_scale_invariant(device, kind, exponent, rng):
    """With default criteria: the same steps, and the same pose up to the unit of its translation."""
    T = as_pose([0.05, -0.06, 0.04], [0.05, -0.04, 0.03])
    source, target, results = back(wavy(rng, 800), T), wavy(rng, 1500), []
    for scale in (1.0, 2.0**exponent):
        clouds = [loom.PointCloud(scale * p, device=device).estimate_normals(max_nn=20) for p in (source, target)]
        method = KINDS[kind]
        if method._target_voxel_size is not None:
            method = dataclasses.replace(method, voxel_size=scale * method._target_voxel_size)
        results.append(reg.registration_icp(*clouds, 0.3 * scale, None, method))
        results[-1].transformation[:3, 3] /= scale
    one, other = results
    np.testing.assert_array_equal(other.transformation, one.transformation)
    assert (other.fitness, other.iterations, other.warnings) == (one.fitness, one.iterations, one.warnings)
    assert len(other.degenerate_directions) == len(one.degenerate_directions) == 0
    assert np.abs(one.transformation - T).max() < 0.02 < np.abs(np.eye(4) - T).max()


def test_a_source_in_another_unit_gives_the_same_result(device, rng):
    """Millimeters to meters: the source's extent is measured under the pose, which scales."""
    points, unit = wavy(rng, 1500), 2.0**10
    target, results = loom.PointCloud(points, device=device), []
    for scale in (1.0, unit):
        init = np.diag([1 / scale] * 3 + [1.0])
        source = loom.PointCloud(scale * (points[::2] * 1.02 + [0.01, -0.02, 0.01]), device=device)
        results.append(reg.registration_icp(source, target, 0.3, init, KINDS["scaled"]))
    assert results[0].iterations == results[1].iterations
    np.testing.assert_allclose(results[1].transformation[:3, :3] * unit, results[0].transformation[:3, :3], atol=1e-6)


def test_a_given_rmse_limit_is_in_meters(device, rng):
    """As in Open3D: one micrometer ends the registration of a cloud of that size after one step."""
    points, scale = wavy(rng, 800), 2.0**-20
    source, target = (
        loom.PointCloud(scale * p, device=device) for p in (points[::2] + np.array([0.05, 0.02, 0.01]), points)
    )
    given = reg.registration_icp(source, target, 0.3 * scale, None, None, reg.ICPConvergenceCriteria(1e-6, 1e-6, 30))
    default = reg.registration_icp(source, target, 0.3 * scale)
    assert given.iterations == 1 < default.iterations and default.inlier_rmse < given.inlier_rmse


def test_symmetric_clouds_keep_their_initial_rotation(device, rng):
    """A cube of lattice points has 24 symmetries; near a quarter turn it converges there and not to the identity."""
    cube = np.stack(np.meshgrid(*[np.linspace(-1, 1, 9)] * 3, indexing="ij"), -1).reshape(-1, 3)
    quarter = as_pose([0, 0, np.pi / 2])
    source, target = (loom.PointCloud(rng.permutation(cube), device=device) for _ in range(2))
    init = as_pose([0.02, -0.03, 0.02], [0.02, 0.01, 0]) @ quarter
    result = reg.registration_icp(source, target, 0.2, init, None, reg.ICPConvergenceCriteria(1e-9, 1e-9, 100))
    np.testing.assert_allclose(result.transformation, quarter, atol=1e-6)


@settings(max_examples=25, deadline=None)
@given(
    seed=st.integers(0, 2**20),
    counts=st.tuples(st.integers(0, 60), st.integers(0, 60)),
    lattice=st.booleans(),
    rotvec=st.tuples(*[st.floats(-3, 3)] * 3),
    shift=st.tuples(*[st.floats(-2, 2)] * 3),
    kind=st.sampled_from(list(KINDS)),
    distance=st.sampled_from([0.05, 0.5, 3.0, 1e9]),
    overlap=st.sampled_from([1.0, 0.5]),
)
def test_any_result_is_finite_and_rigid(seed, counts, lattice, rotvec, shift, kind, distance, overlap):
    rng, clouds = np.random.default_rng(seed), []
    for count in counts:
        points = rng.integers(0, 3, (count, 3)) * 0.5 if lattice else rng.normal(size=(count, 3))
        points = points.astype(float)
        points[rng.random(count) < 0.05] = np.nan
        normals = rng.normal(size=(count, 3))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        extra = {"colors": rng.random((count, 3)), "dopplers": rng.normal(size=count).astype(np.float32)}
        clouds.append(loom.PointCloud(points, normals=normals, **extra))
    result = reg.registration_icp(*clouds, distance, as_pose(rotvec, shift), KINDS[kind], overlap=overlap)
    T = result.transformation
    assert np.isfinite(T).all() and 0 <= result.fitness <= 1 and np.isfinite(result.inlier_rmse)
    if kind == "scaled":
        T[:3, :3] /= np.cbrt(np.linalg.det(T[:3, :3]))
    assert_rigid(T)
    assert len(result.correspondence_set) == round(result.fitness * max(1, np.isfinite(clouds[0].points[:, 0]).sum()))
