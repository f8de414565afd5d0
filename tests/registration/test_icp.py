"""Iterative closest points: accuracy, termination, scales, rejection of pairs, bad input, and free motions."""

import dataclasses
from contextlib import nullcontext as nothing

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import subspace_angles
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.units import NonFiniteWarning

from ..products import each_pair
from .icp_clouds import EACH, KINDS, PLANE, assert_rigid, back, on, wavy, wavy_normals
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
    source = loom.PointCloud((target - T[:3, 3]) @ np.linalg.inv(T[:3, :3]).T, device=device)
    target = loom.PointCloud(target, device=device)
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
@pytest.mark.parametrize("steps", [0, 3])
def test_a_result_describes_its_pose(device, full_pair, kind, steps):
    """Fitness, rmse and pairs are those under the final transformation, not before the last step."""
    source, target = on(device, *full_pair[:2])
    init = None if steps else as_pose([0.02, 0, 0], [0, 0.02, 0])
    rules = reg.ICPConvergenceCriteria(0, 0, steps)
    result = reg.registration_icp(source, target, 0.1, init, KINDS[kind], rules)
    assert (result.iterations, result.converged, result.reliable) == (steps, False, False)
    assert result.warnings == (f"ICP did not converge within {steps} iterations",)
    if not steps:
        np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    if kind != "voxelized":
        expected = reg.evaluate_registration(source, target, 0.1, result.transformation)
        assert result.fitness == expected.fitness
        assert result.inlier_rmse == pytest.approx(expected.inlier_rmse, abs=1e-9 * steps)
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
    given = source, target, 0.05, None, KINDS[kind], criteria
    result = reg.registration_icp(*given, callback_after_iteration=iterations.append)
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
    shifted = points[::2] + np.array([0.05, 0.02, 0.01])
    source, target = (loom.PointCloud(scale * p, device=device) for p in (shifted, points))
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


def test_multiple_scales_enlarge_the_convergence_basin(device, rng, angle_between):
    """Open3D's tutorial: three voxel sizes with distances; the finest scale alone fails."""
    T = as_pose([0.2, -0.3, 0.4], [0.3, -0.2, 0.2])
    target = loom.PointCloud(wavy(rng, 12_000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(wavy(rng, 12_000), T), device=device)
    rules = [reg.ICPConvergenceCriteria(1e-4, 1e-4, 20), reg.ICPConvergenceCriteria(1e-5, 1e-5, 15)]
    rules += [reg.ICPConvergenceCriteria(1e-6, 1e-6, 10)]
    steps, scales = [], ([0.1, 0.05, -1], rules, [0.3, 0.14, 0.07])
    result = reg.multi_scale_icp(source, target, *scales, None, PLANE, callback_after_iteration=steps.append)
    alone = reg.registration_icp(source, target, 0.07, None, PLANE, rules[2])
    assert angle_between(result.transformation, T) < 0.02 < 5 < angle_between(alone.transformation, T)
    assert result.fitness > 0.98 and len(result.correspondence_set) > 11_000
    assert [t["scale_index"] for t in steps] == sorted(t["scale_index"] for t in steps)
    assert {t["scale_index"] for t in steps} == {0, 1, 2} and result.iterations == len(steps)


def test_one_scale_equals_plain_icp(device, full_pair):
    source, target = on(device, *full_pair[:2])
    rules = reg.ICPConvergenceCriteria(max_iteration=7)
    one = reg.multi_scale_icp(source, target, [-1], [rules], [0.1], full_pair[2], PLANE)
    plain = reg.registration_icp(source, target, 0.1, full_pair[2], PLANE, rules)
    np.testing.assert_array_equal(one.transformation, plain.transformation)
    result = reg.multi_scale_icp(source, target, [-1], [rules], [0.1], full_pair[2], PLANE, overlap=1.0)
    np.testing.assert_array_equal(result.transformation, plain.transformation)


def test_a_low_overlap_is_estimated(device, rng, angle_between):
    points, others = wavy(rng, 16_000), wavy(rng, 16_000)
    T = as_pose([0.02, -0.01, 0.03], [0.02, 0.01, -0.02])
    target = loom.PointCloud(others[others[:, 0] > -0.25], device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(points[points[:, 0] < 0.25], T), device=device)
    rules = [reg.ICPConvergenceCriteria(1e-6, 1e-6, 40)]
    given = source, target, [0.03], rules, [0.4], None, PLANE
    trimmed, full = (reg.multi_scale_icp(*given, overlap=overlap) for overlap in (None, 1.0))
    assert angle_between(trimmed.transformation, T) < 0.2 * angle_between(full.transformation, T)
    thinned = (cloud.voxel_down_sample(0.03) for cloud in (source, target))
    again = reg.evaluate_registration(*thinned, 0.4, trimmed.transformation)
    assert trimmed.fitness == again.fitness and len(trimmed.correspondence_set) == len(again.correspondence_set)


def test_trimming_suppresses_outliers(device, rng, angle_between):
    """30 % of the source is slightly above the surface: all of it biases the pose, its nearest 65 % do not."""
    T = as_pose([0.01, -0.02, 0.01], [0.01, -0.01, 0.01])
    points = wavy(rng, 4000)
    points[:1200, 2] += rng.uniform(0.05, 0.25, 1200)
    target = loom.PointCloud(wavy(rng, 8000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(points, T), device=device)
    rules = reg.ICPConvergenceCriteria(1e-8, 1e-8, 60)
    given = source, target, 0.4, None, PLANE, rules
    plain, trimmed = (reg.registration_icp(*given, overlap=fraction) for fraction in (1.0, 0.65))
    off, wrong = (np.abs(r.transformation[:3, 3] - T[:3, 3]).max() for r in (trimmed, plain))
    assert off < 2e-4 and wrong > 0.04
    assert angle_between(trimmed.transformation, T) < 0.01 < 0.1 < angle_between(plain.transformation, T)
    assert trimmed.fitness == 0.65 and len(trimmed.correspondence_set) == 2600
    assert (trimmed.correspondence_set[:, 0] >= 1200).mean() > 0.99


def test_an_overlap_above_the_matched_fraction_keeps_all_pairs(device, rng):
    """Half of the source has no counterpart: the nearest 80 % are all existing pairs."""
    target = wavy(rng, 2000)
    source = np.concatenate([target[:1000], target[:1000]])
    source[:, 2] += np.where(np.arange(2000) < 1000, 0.01, 50)
    clouds = [loom.PointCloud(p, device=device).estimate_normals(max_nn=20) for p in (source, target)]
    plain, trimmed = (reg.registration_icp(*clouds, 0.1, None, PLANE, overlap=fraction) for fraction in (1.0, 0.8))
    assert (trimmed.fitness, trimmed.warnings) == (0.5, plain.warnings)
    np.testing.assert_array_equal(trimmed.transformation, plain.transformation)


def test_a_thin_wall_is_not_pulled_through_itself(device, rng):
    """One side of a 2 cm wall is closer to the other side: the normals distinguish them."""

    def wall(side, shift):
        p = rng.uniform(-1, 1, (len(side), 3))
        p[:, 2] = 0.01 * side + 0.05 * np.sin(5 * p[:, 0]) * np.cos(6 * p[:, 1]) + shift
        slopes = 0.25 * np.cos(5 * p[:, 0]) * np.cos(6 * p[:, 1]), -0.3 * np.sin(5 * p[:, 0]) * np.sin(6 * p[:, 1])
        n = np.column_stack([-slopes[0], -slopes[1], np.ones(len(side))])
        return loom.PointCloud(p, normals=n / np.linalg.norm(n, axis=1)[:, None] * side[:, None], device=device)

    source, target = wall(np.full(4000, -1.0), 0.015), wall(np.where(np.arange(10_000) % 2, 1.0, -1.0), 0.0)
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 60)
    given = source, target, 0.05, None, PLANE, rules
    plain, parted = (reg.registration_icp(*given, max_normal_angle=angle) for angle in (None, 1.0))
    assert abs(parted.transformation[2, 3] + 0.015) < 2e-4
    assert abs(plain.transformation[2, 3] + 0.015) > 5e-3  # between both
    rows, columns = parted.correspondence_set.T
    assert (np.einsum("ij,ij->i", source.normals[rows], target.normals[columns]) > 0.5).all()


def pull_of_an_edge(rng, count):
    """A wavy floor and a step beyond its edge at x = 0: the source has both, the target only the floor."""
    points = wavy(rng, count)
    points[:, 2] += np.where(points[:, 0] > 0.0, 0.15, 0)
    return points


@pytest.mark.parametrize("kind", ["point", "plane", "symmetric", "generalized", "voxelized"])
def test_the_overlap_is_estimated(device, kind, rng, angle_between):
    """Three fifths of the source are beyond the target's edge but within the distance; estimating the overlap helps."""
    T = as_pose([0.01, -0.02, 0.01], [0.01, -0.01, 0.01])
    points, floor = pull_of_an_edge(rng, 4000), wavy(rng, 8000)
    points, floor = points[points[:, 0] > -0.7], floor[floor[:, 0] < 0]
    target, source = loom.PointCloud(floor, device=device), loom.PointCloud(back(points, T), device=device)
    source, target = source.estimate_normals(max_nn=20), target.estimate_normals(max_nn=20)
    rules = reg.ICPConvergenceCriteria(1e-8, 1e-8, 60)
    given = source, target, 0.3, None, KINDS[kind], rules
    plain, trimmed = (reg.registration_icp(*given, overlap=fraction) for fraction in (1.0, None))
    off, wrong = (angle_between(r.transformation, T) for r in (trimmed, plain))
    assert off < 0.4 and wrong > 2.5 * off
    assert 0.3 < trimmed.fitness < min(0.45, plain.fitness)
    assert (source.points[trimmed.correspondence_set[:, 0]] @ T[:3, :3].T + T[:3, 3])[:, 0].max() < 0.1


def test_a_batch_estimates_the_overlap_of_each_pair(device, rng):
    floor = wavy(rng, 3000)
    targets = [loom.PointCloud(floor[floor[:, 0] < edge], device=device) for edge in (-0.2, 0.5)]
    source = loom.PointCloud(floor[::2] + np.full(3, 0.01), device=device)
    results = reg.registration_icp_batch(source, targets, 0.3, overlap=None)
    for target, result in zip(targets, results, strict=True):
        alone = reg.registration_icp(source, target, 0.3, overlap=None)
        np.testing.assert_allclose(result.transformation, alone.transformation, atol=1e-9)
        assert result.fitness == alone.fitness == pytest.approx(len(target) / len(floor), abs=0.03)


def test_the_overlap_of_a_copy_is_full(device, rng):
    points = wavy(rng, 2000)
    cloud = loom.PointCloud(points, device=device)
    for moved in (0.0, 0.01):
        source = loom.PointCloud(points, device=device).translate((moved, 0, 0))
        result = reg.registration_icp(source, cloud, 0.3, overlap=None)
        assert result.fitness == 1.0 and np.abs(result.transformation[:3, 3] - [-moved, 0, 0]).max() < 1e-6


def full_cloud(points, device="cpu"):
    count = len(points)
    normals = np.tile([0.0, 0, 1], (count, 1))
    dopplers = np.zeros(count, np.float32)
    return loom.PointCloud(points, normals=normals, colors=np.full((count, 3), 0.5), dopplers=dopplers, device=device)


@EACH
def test_empty_clouds_leave_the_initial_pose(device, kind, rng):
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    for counts in ((0, 0), (0, 9), (9, 0)):
        clouds = (full_cloud(rng.random((n, 3)), device) for n in counts)
        result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
        np.testing.assert_allclose(result.transformation, init, atol=1e-14)
        assert (result.fitness, result.inlier_rmse, result.iterations) == (0.0, 0.0, 0)
        assert not result.converged and result.warnings[0].startswith("no correspondences: ")
        assert result.correspondence_set.shape == (0, 2) and result.correspondence_set.dtype == np.int32


@EACH
@pytest.mark.parametrize("nans", [False, True])
def test_clouds_without_pairs_leave_the_initial_pose(device, kind, nans, rng):
    """Open3D's tensor form resets it to the identity."""
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    source = rng.random((20, 3)) + 50
    clouds = full_cloud(np.full((20, 3), np.nan) if nans else source, device), full_cloud(rng.random((30, 3)), device)
    with nothing() if nans else pytest.warns(loom.UnitWarning, match=r"centers 9\d\.?\d* m apart"):
        result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.fitness, result.converged) == (0.0, False)
    assert result.warnings[0].startswith("no correspondences: ")


@EACH
def test_lost_pairs_during_iteration_are_reported(device, kind):
    """A step that separates the clouds ends with the pose of that step."""
    source, target = (full_cloud(p, device) for p in ([[0.0, 0, 0], [0, 1, 0]], [[0.0, 0, 0.09], [0.05, 1, 0]]))
    result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], reg.ICPConvergenceCriteria(0, 0, 50))
    assert np.isfinite(result.transformation).all()
    assert any("no correspondences" in warning for warning in result.warnings) == (result.fitness == 0)


@pytest.mark.parametrize("side", [0, 1], ids=["source", "target"])
@pytest.mark.parametrize(
    ("kind", "column"),
    [(k, "normals") for k in ("plane", "robust", "symmetric", "generalized", "voxelized", "colored", "doppler")]
    + [("generalized", "covariances"), ("doppler", "dopplers")],
)
def test_a_point_with_a_non_finite_value_is_excluded(device, full_pair, kind, column, side):
    """The pose is that of the clouds without the point, and a warning counts it."""
    clouds, rows = list(on(device, *full_pair[:2])), [5, 77]
    original = clouds[side]
    if column == "covariances":
        original = original.estimate_covariances(max_nn=20)
    spoiled, values = original.copy(), np.array(original[column])
    values[rows] = np.nan
    spoiled[column] = values
    results = []
    is_used = kind in ("symmetric", "generalized", "voxelized") or side == (column == "normals")
    for cloud in (spoiled, original.select_by_index(rows, invert=True) if is_used else original):
        clouds[side] = cloud
        with pytest.warns(NonFiniteWarning, match="2 of") if cloud is spoiled and is_used else nothing():
            results.append(reg.registration_icp(*clouds, 0.1, None, KINDS[kind]))
    limit = 1e-6 if kind == "colored" else 1e-9  # the color of the point still counts in the gradients beside it
    np.testing.assert_allclose(results[0].transformation, results[1].transformation, rtol=0, atol=limit)
    assert results[0].fitness == results[1].fitness and results[0].converged


@EACH
def test_non_finite_points_are_ignored(device, full_pair, kind):
    """NaN and infinity sprinkled over both clouds: the pose of the clouds without them."""
    source, target = on(device, *full_pair[:2])
    spoiled = []
    for cloud in (source, target):
        order = np.arange(len(cloud) + 30) % len(cloud)
        points = cloud.points[order]
        points[-30:, :] = [np.nan, 0.1, 0.1]
        points[-10:, 2] = np.inf
        normals = cloud.normals[order]
        normals[-30:] = np.nan
        attributes = {"colors": cloud.colors[order], "dopplers": cloud["dopplers"][order]}
        spoiled.append(loom.PointCloud(points, normals=normals, device=device, **attributes))
    rules = reg.ICPConvergenceCriteria(0, 0, 5)
    clean = reg.registration_icp(source, target, 0.15, None, KINDS[kind], rules)
    result = reg.registration_icp(*spoiled, 0.15, None, KINDS[kind], rules)
    np.testing.assert_allclose(result.transformation, clean.transformation, atol=1e-9)
    assert result.fitness == clean.fitness


def test_a_nearly_rigid_initial_pose_is_made_rigid(device, full_pair):
    """Poses of data sets are rounded to a few digits."""
    source, target = on(device, *full_pair[:2])
    init = full_pair[2] + 1e-3 * np.array([[1, -1, 1, 0], [-1, 1, 1, 0], [1, 1, -1, 0], [0, 0, 0, 0]])
    for kind in ("point", "plane"):
        assert_rigid(reg.registration_icp(source, target, 0.1, init, KINDS[kind]).transformation)


AXES = np.eye(6)  # rotations, then translations
FREE = {
    "plane": AXES[[2, 3, 4]], "corridor": AXES[[4]], "sphere": AXES[:3], "cylinder": AXES[[2, 5]], "surface": AXES[:0],
}  # fmt: skip
SIZES = {"plane": 2, "corridor": 6, "sphere": 2, "cylinder": 4, "surface": 2}  # [m]


def degenerate(shape, rng, count):
    """Points on a shape, and their normals."""
    a, u, y = rng.uniform(0, 2 * np.pi, count), rng.uniform(-1, 1, (2, count)), rng.uniform(-3, 3, count)
    zero = np.zeros(count)
    if shape == "plane":
        return np.column_stack([*u, zero]), np.tile([0, 0, 1.0], (count, 1))
    if shape == "corridor":  # along y: two walls and a floor
        side = np.arange(count) % 3
        points = np.column_stack([np.where(side == 2, u[0], 2.0 * side - 1), y, np.where(side == 2, -1, u[1])])
        return points, np.stack([(side < 2) * 1.0, zero, (side == 2) * 1.0], axis=1)
    if shape == "sphere":
        n = rng.normal(size=(count, 3))
        n /= np.linalg.norm(n, axis=1)[:, None]
        return n, n
    if shape == "cylinder":  # along z
        n = np.column_stack([np.cos(a), np.sin(a), zero])
        return n + np.column_stack([zero, zero, 2 * u[0]]), n
    points = wavy(rng, count)
    return points, wavy_normals(points)


@pytest.mark.parametrize(**each_pair(
    shape=list(FREE), noise=["exact", "estimated", "noisy"], kind=["plane", "symmetric", "generalized", "robust"]
))  # fmt: skip
def test_free_motions_are_reported_and_excluded(device, shape, noise, kind, rng):
    """As in Open3D; with a limit it stays."""
    clouds, T = [], as_pose([0.01, -0.02, 0.015], [0.02, -0.03, 0.02])
    for pose in (T, np.eye(4)):
        points, normals = degenerate(shape, rng, 3000)
        if noise == "noisy":  # by a thousandth of its size
            points = points + 1e-3 * SIZES[shape] * rng.normal(size=points.shape)
        cloud = loom.PointCloud(back(points, pose), normals=normals @ pose[:3, :3], device=device)
        clouds.append(cloud if noise == "exact" else cloud.estimate_normals(max_nn=20))
    result = reg.registration_icp(*clouds, 0.3, None, KINDS[kind])
    free, directions = FREE[shape], result.degenerate_directions
    assert len(directions) == len(free)
    np.testing.assert_allclose(directions @ directions.T, np.eye(len(free)), atol=1e-9)
    if len(free):
        assert np.degrees(subspace_angles(directions.T, free.T)).max() < 3
        M, middle = result.transformation, clouds[0].points.mean(axis=0)
        motion = [*Rotation.from_matrix(M[:3, :3]).as_rotvec(), *(M[:3, :3] @ middle + M[:3, 3] - middle)]
        assert np.abs(free @ motion).max() < 1.5e-3
    pull = M if len(free) else result.transformation
    assert np.abs(pull - np.eye(4)).max() > 5e-3  # it moved along the others


def test_noise_moves_a_plane_where_degeneracy_is_0(device, rng):
    clouds = []
    for shift in ([0.1, 0.05, 0.02], [0, 0, 0]):
        points = degenerate("plane", rng, 3000)[0] + shift + 2e-3 * rng.normal(size=(3000, 3))
        clouds.append(loom.PointCloud(points, device=device).estimate_normals(max_nn=20))
    fixed, loose = (reg.registration_icp(*clouds, 0.2, None, PLANE, degeneracy=d) for d in (5e-3, 0))
    assert np.abs(fixed.transformation[:2, 3]).max() < 2e-3 < np.abs(loose.transformation[:2, 3]).max()
    assert len(fixed.degenerate_directions) == 3 and len(loose.degenerate_directions) == 0


def test_collinear_points_report_the_rotation_about_their_line(device, rng):
    line = np.outer(np.linspace(-1, 1, 300), [1.0, 0, 0])
    T = as_pose([0, 0.01, 0.02], [0.001, 0.002, 0.003])
    source, target = (loom.PointCloud(p, device=device) for p in (back(line, T), line))
    result = reg.registration_icp(source, target, 0.2, None, None, reg.ICPConvergenceCriteria(1e-12, 1e-12, 200))
    moved = source.points @ result.transformation[:3, :3].T + result.transformation[:3, 3]
    assert np.abs(moved[:, 1:]).max() < 1e-6
    np.testing.assert_allclose(np.abs(result.degenerate_directions), [[1, 0, 0, 0, 0, 0]], atol=1e-3)
    assert_rigid(result.transformation)


def test_a_weakly_constrained_street_is_not_degenerate(device, rng):
    """A corridor whose end is 0.7 % of its points: an eigenvalue of a hundredth of the largest, as streets have."""
    points, normals = degenerate("corridor", rng, 4000)
    points[:28] = np.column_stack([rng.uniform(-0.6, 0.6, 28), np.full(28, 3.0), rng.uniform(-0.6, 0.6, 28)])
    normals[:28] = [0, -1, 0]
    T = as_pose([0, 0, 0], [0, 0.03, 0])
    source = loom.PointCloud(back(points, T), normals=normals, device=device)
    result = reg.registration_icp(source, loom.PointCloud(points, normals=normals, device=device), 0.2, None, PLANE)
    assert len(result.degenerate_directions) == 0
    np.testing.assert_allclose(result.transformation, T, atol=1e-4)
