"""Iterative closest points: when it ends, what it leaves out, what it refuses, and that it is the same every time."""

import os
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import subspace_angles
from scipy.spatial.transform import Rotation

import pointloom as loom

from .poses import as_pose

reg = loom.registration
PLANE = reg.TransformationEstimationPointToPlane()
KINDS = {
    "point": reg.TransformationEstimationPointToPoint(),
    "scaled": reg.TransformationEstimationPointToPoint(True),
    "plane": PLANE,
    "robust": reg.TransformationEstimationPointToPlane(reg.TukeyLoss(0.1)),
    "symmetric": reg.TransformationEstimationSymmetric(),
    "generalised": reg.TransformationEstimationForGeneralizedICP(),
    "voxelised": reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1),
    "coloured": reg.TransformationEstimationForColoredICP(),
    "doppler": reg.TransformationEstimationForDopplerICP(),
}
EACH = pytest.mark.parametrize("kind", list(KINDS))


def height(x, y):
    return 0.2 * np.sin(3 * x) * np.cos(4 * y) + 0.1 * np.sin(7 * y + x)


def wavy(rng, count):
    xy = rng.uniform(-1, 1, (count, 2))
    return np.column_stack([xy, height(*xy.T)])


def back(points, T):
    """Where points were before a pose."""
    return (points - T[:3, 3]) @ T[:3, :3]


@pytest.fixture(scope="module")
def pair(surface_pair):
    """Clouds with all that any estimator asks for, and T."""

    def whole(points, paint):
        colors = 0.5 + 0.4 * np.sin(paint @ np.array([[5, 1, 2], [3, 6, 2], [2, 2, 7]]))
        cloud = loom.PointCloud(points[::2], colors=colors[::2], dopplers=np.zeros(len(points[::2]), np.float32))
        return cloud.estimate_normals(max_nn=20)

    T = surface_pair.T
    moved = surface_pair.source @ T[:3, :3].T + T[:3, 3]
    return whole(surface_pair.source, moved), whole(surface_pair.target, surface_pair.target), T


def on(device, *clouds):
    return [c.to(device) for c in clouds]


def assert_rigid(T):
    np.testing.assert_allclose(T[:3, :3] @ T[:3, :3].T, np.eye(3), atol=1e-9)
    assert np.linalg.det(T[:3, :3]) > 0 and (T[3] == [0, 0, 0, 1]).all()


# ------------------------------------------------------------------------------------------------ how near it comes


def test_two_samplings_of_a_surface_meet_to_a_thousandth_of_a_degree(device, rng, angle_between):
    """20 steps point to plane without noise: 50,000 points, as coarser samplings leave the bend between them."""
    T = as_pose([0.02, -0.02, 0.02], [0.02, -0.01, 0.015])  # 2 degrees and 2.7 cm
    target = loom.PointCloud(wavy(rng, 50_000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(wavy(rng, 50_000), T), device=device)
    result = reg.registration_icp(source, target, 0.1, None, PLANE, reg.ICPConvergenceCriteria(0, 0, 20))
    assert angle_between(result.transformation, T) < 0.001
    assert np.abs(result.transformation[:3, 3] - T[:3, 3]).max() < 2e-5


@pytest.mark.parametrize(
    ("kind", "degrees"),
    [("plane", 0.02), ("symmetric", 0.01), ("generalised", 0.01), ("coloured", 0.02), ("point", 0.4)],
)
def test_every_estimator_finds_the_pose(device, pair, kind, degrees, angle_between):
    source, target = on(device, *pair[:2])
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 100)
    result = reg.registration_icp(source, target, 0.15, None, KINDS[kind], rules)
    assert angle_between(result.transformation, pair[2]) < degrees
    assert result.fitness > 0.99 and len(result.degenerate_directions) == 0
    assert_rigid(result.transformation)


@EACH
def test_a_cloud_lies_on_itself(device, pair, kind):
    target = on(device, pair[1])[0]
    result = reg.registration_icp(target, target, 0.1, None, KINDS[kind])
    if kind != "voxelised":  # where points meet the means of voxels
        np.testing.assert_allclose(result.transformation, np.eye(4), atol=1e-12)
        assert (result.fitness, result.iterations) == (1.0, 1) and result.inlier_rmse < 1e-12
    assert result.converged and result.reason == "converged"


@pytest.mark.parametrize("scale", [0.8, 1.0, 1.25])
def test_a_scale_is_found_again(device, rng, scale):
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


# ------------------------------------------------------------------------------------------------ when it ends


@EACH
def test_no_iterations_only_evaluate(device, pair, kind):
    source, target = on(device, *pair[:2])
    init = as_pose([0.02, 0, 0], [0, 0.02, 0])
    result = reg.registration_icp(source, target, 0.1, init, KINDS[kind], reg.ICPConvergenceCriteria(max_iteration=0))
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.iterations, result.converged, result.reason) == (0, False, "max_iteration")
    if kind != "voxelised":
        expected = reg.evaluate_registration(source, target, 0.1, init)
        assert (result.fitness, result.inlier_rmse) == (expected.fitness, expected.inlier_rmse)
        np.testing.assert_array_equal(result.correspondence_set, expected.correspondence_set)


@EACH
def test_a_result_is_that_of_its_pose(device, pair, kind):
    """Fitness, rmse and pairs are those under the transformation, not those before the last step."""
    source, target = on(device, *pair[:2])
    result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], reg.ICPConvergenceCriteria(0, 0, 3))
    assert (result.iterations, result.reason) == (3, "max_iteration")
    if kind != "voxelised":
        expected = reg.evaluate_registration(source, target, 0.1, result.transformation)
        assert result.fitness == expected.fitness
        assert result.inlier_rmse == pytest.approx(expected.inlier_rmse, abs=1e-9)
        np.testing.assert_array_equal(result.correspondence_set, expected.correspondence_set)


@pytest.mark.parametrize("kind", ["point", "plane"])
@pytest.mark.parametrize("limits", [(1e-6, 1e-6), (1e-2, 1e-3), (1e-3, 1.0), (1.0, 1e-5)])
def test_it_ends_when_both_changes_are_below_their_limits(device, pair, kind, limits):
    """Judged after each step against the evaluation before it, the initial one included."""
    source, target = on(device, *pair[:2])
    turns = []
    criteria = reg.ICPConvergenceCriteria(*limits, 60)
    result = reg.registration_icp(
        source, target, 0.05, None, KINDS[kind], criteria, callback_after_iteration=turns.append
    )
    start = reg.evaluate_registration(source, target, 0.05)
    fitness = np.array([start.fitness, *(t["fitness"] for t in turns)])
    rmse = np.array([start.inlier_rmse, *(t["inlier_rmse"] for t in turns)])
    met = (np.abs(np.diff(fitness)) < limits[0]) & (np.abs(np.diff(rmse)) < limits[1])
    assert met.any() and result.converged
    assert result.iterations == len(turns) == np.flatnonzero(met)[0] + 1


def test_the_callback_sees_each_iteration(device, pair):
    source, target = on(device, *pair[:2])
    turns = []
    rules = reg.ICPConvergenceCriteria(0, 0, 4)
    result = reg.registration_icp(source, target, 0.1, None, PLANE, rules, callback_after_iteration=turns.append)
    assert [t["iteration_index"] for t in turns] == [1, 2, 3, 4]
    for steps, turn in enumerate(turns, 1):
        assert set(turn) == {"iteration_index", "transformation", "fitness", "inlier_rmse"}
        alone = reg.registration_icp(source, target, 0.1, None, PLANE, reg.ICPConvergenceCriteria(0, 0, steps))
        np.testing.assert_array_equal(turn["transformation"], alone.transformation)
        assert (turn["fitness"], turn["inlier_rmse"]) == (alone.fitness, alone.inlier_rmse)
    np.testing.assert_array_equal(turns[-1]["transformation"], result.transformation)
    none = []
    reg.registration_icp(
        source,
        target,
        0.1,
        None,
        PLANE,
        reg.ICPConvergenceCriteria(max_iteration=0),
        callback_after_iteration=none.append,
    )
    assert none == []


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ((-1, 1e-6, 30), "relative_fitness: expected a finite number >= 0"),
        ((1e-6, np.nan, 30), "relative_rmse: expected a finite number >= 0"),
        ((1e-6, 1e-6, -1), "max_iteration: expected a whole number >= 0"),
    ],
)
def test_criteria_are_numbers(values, message):
    with pytest.raises(ValueError, match=rf"^{message}"):
        reg.ICPConvergenceCriteria(*values)


# ------------------------------------------------------------------------------------------------ pairs left out


def test_a_trimmed_share_holds_off_outliers(device, rng, angle_between):
    """30 % of the source lies a little above the surface: all of it pulls, its nearest 65 % do not."""
    T = as_pose([0.01, -0.02, 0.01], [0.01, -0.01, 0.01])
    points = wavy(rng, 4000)
    points[:1200, 2] += rng.uniform(0.05, 0.25, 1200)
    target = loom.PointCloud(wavy(rng, 8000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(points, T), device=device)
    rules = reg.ICPConvergenceCriteria(1e-8, 1e-8, 60)
    plain, trimmed = (
        reg.registration_icp(source, target, 0.4, None, PLANE, rules, overlap=share) for share in (1.0, 0.65)
    )
    off, wrong = (np.abs(r.transformation[:3, 3] - T[:3, 3]).max() for r in (trimmed, plain))
    assert off < 2e-4 and wrong > 0.04
    assert angle_between(trimmed.transformation, T) < 0.01 < 0.1 < angle_between(plain.transformation, T)
    assert trimmed.fitness == 0.65 and len(trimmed.correspondence_set) == 2600
    assert (trimmed.correspondence_set[:, 0] >= 1200).mean() > 0.99


def test_a_share_that_fewer_points_reach_keeps_all_pairs(device, rng):
    """Half of the source has no counterpart at all: the nearest 80 % are all that there are."""
    target = wavy(rng, 2000)
    source = np.concatenate([target[:1000], target[:1000]])
    source[:, 2] += np.where(np.arange(2000) < 1000, 0.01, 50)
    clouds = [loom.PointCloud(p, device=device).estimate_normals(max_nn=20) for p in (source, target)]
    plain, trimmed = (reg.registration_icp(*clouds, 0.1, None, PLANE, overlap=share) for share in (1.0, 0.8))
    assert (trimmed.fitness, trimmed.reason) == (0.5, plain.reason)
    np.testing.assert_array_equal(trimmed.transformation, plain.transformation)


def test_a_thin_wall_is_not_drawn_through_itself(device, rng):
    """One side of a wall of 2 cm that lies nearer to the other one: by their normals the sides are told apart."""

    def wall(side, shift):
        p = rng.uniform(-1, 1, (len(side), 3))
        p[:, 2] = 0.01 * side + 0.05 * np.sin(5 * p[:, 0]) * np.cos(6 * p[:, 1]) + shift
        slopes = 0.25 * np.cos(5 * p[:, 0]) * np.cos(6 * p[:, 1]), -0.3 * np.sin(5 * p[:, 0]) * np.sin(6 * p[:, 1])
        n = np.column_stack([-slopes[0], -slopes[1], np.ones(len(side))])
        return loom.PointCloud(p, normals=n / np.linalg.norm(n, axis=1)[:, None] * side[:, None], device=device)

    source, target = wall(np.full(4000, -1.0), 0.015), wall(np.where(np.arange(10_000) % 2, 1.0, -1.0), 0.0)
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 60)
    plain, parted = (
        reg.registration_icp(source, target, 0.05, None, PLANE, rules, max_normal_angle=angle) for angle in (None, 1.0)
    )
    assert abs(parted.transformation[2, 3] + 0.015) < 2e-4
    assert abs(plain.transformation[2, 3] + 0.015) > 5e-3  # between both
    rows, columns = parted.correspondence_set.T
    assert (np.einsum("ij,ij->i", source.normals[rows], target.normals[columns]) > 0.5).all()


@pytest.mark.parametrize("overlap", [0, -0.1, 1.1, np.nan])
def test_an_overlap_is_a_share(pair, overlap):
    with pytest.raises(ValueError, match=r"^overlap: expected"):
        reg.registration_icp(*pair[:2], 0.1, overlap=overlap)


def test_angles_of_normals_need_normals(pair):
    bare = loom.PointCloud(pair[0].points)
    for clouds, name in (((bare, pair[1]), "source"), ((pair[0], bare), "target")):
        with pytest.raises(ValueError, match=rf"^{name}: max_normal_angle needs normals, .* call estimate_normals"):
            reg.registration_icp(*clouds, 0.1, max_normal_angle=0.5)
    with pytest.raises(ValueError, match=r"^max_normal_angle: the voxels of a voxelised target have no normals"):
        reg.registration_icp(*pair[:2], 0.1, None, KINDS["voxelised"], max_normal_angle=0.5)
    with pytest.raises(ValueError, match=r"^max_normal_angle: expected a finite number > 0"):
        reg.registration_icp(*pair[:2], 0.1, max_normal_angle=0)


# ------------------------------------------------------------------------------------------------ degenerate clouds


AXES = np.eye(6)  # rotations, then translations
FREE = {
    "plane": AXES[[2, 3, 4]], "corridor": AXES[[4]], "sphere": AXES[:3], "cylinder": AXES[[2, 5]], "surface": AXES[:0],
}  # fmt: skip
SIZES = {"plane": 2, "corridor": 6, "sphere": 2, "cylinder": 4, "surface": 2}  # [m]


def degenerate(shape, rng, count):
    """Points on a shape, and its normals."""
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
    x, y, _ = points.T
    n = np.column_stack(
        [
            -0.6 * np.cos(3 * x) * np.cos(4 * y) - 0.1 * np.cos(7 * y + x),
            0.8 * np.sin(3 * x) * np.sin(4 * y) - 0.7 * np.cos(7 * y + x),
            np.ones(count),
        ]
    )
    return points, n / np.linalg.norm(n, axis=1)[:, None]


@pytest.mark.parametrize("kind", ["plane", "symmetric", "generalised", "robust"])
@pytest.mark.parametrize("noise", ["exact", "estimated", "noisy"])
@pytest.mark.parametrize("shape", list(FREE))
def test_free_motions_are_told_and_left_out(device, shape, noise, kind, rng):
    """Two samplings of a shape: as many free motions as it has, in their directions, and no step along them."""
    clouds, T = [], as_pose([0.01, -0.02, 0.015], [0.02, -0.03, 0.02])
    for pose in (T, np.eye(4)):
        points, normals = degenerate(shape, rng, 3000)
        if noise == "noisy":  # by a thousandth of its size
            points = points + 1e-3 * SIZES[shape] * rng.normal(size=points.shape)
        cloud = loom.PointCloud(back(points, pose), normals=normals @ pose[:3, :3], device=device)
        clouds.append(cloud if noise == "exact" else cloud.estimate_normals(max_nn=20))
    result = reg.registration_icp(*clouds, 0.3, None, KINDS[kind])
    free, found = FREE[shape], result.degenerate_directions
    assert len(found) == len(free)
    np.testing.assert_allclose(found @ found.T, np.eye(len(free)), atol=1e-9)
    if len(free):
        assert np.degrees(subspace_angles(found.T, free.T)).max() < 3
        M, middle = result.transformation, clouds[0].points.mean(axis=0)
        motion = [*Rotation.from_matrix(M[:3, :3]).as_rotvec(), *(M[:3, :3] @ middle + M[:3, 3] - middle)]
        assert np.abs(free @ motion).max() < 1.5e-3
    pull = M if len(free) else result.transformation
    assert np.abs(pull - np.eye(4)).max() > 5e-3  # it did move along the others


def test_noise_moves_a_plane_where_degeneracy_is_0(device, rng):
    """As Open3D does; with a limit it stays."""
    clouds = []
    for shift in ([0.1, 0.05, 0.02], [0, 0, 0]):
        points = degenerate("plane", rng, 3000)[0] + shift + 2e-3 * rng.normal(size=(3000, 3))
        clouds.append(loom.PointCloud(points, device=device).estimate_normals(max_nn=20))
    held, loose = (reg.registration_icp(*clouds, 0.2, None, PLANE, degeneracy=d) for d in (5e-3, 0))
    assert np.abs(held.transformation[:2, 3]).max() < 2e-3 < np.abs(loose.transformation[:2, 3]).max()
    assert len(held.degenerate_directions) == 3 and len(loose.degenerate_directions) == 0
    with pytest.raises(ValueError, match=r"^degeneracy: expected a share from 0 to below 1"):
        reg.registration_icp(*clouds, 0.2, None, PLANE, degeneracy=1)


def test_points_on_a_line_tell_of_the_turn_about_it(device, rng):
    line = np.outer(np.linspace(-1, 1, 300), [1.0, 0, 0])
    T = as_pose([0, 0.01, 0.02], [0.001, 0.002, 0.003])
    source, target = (loom.PointCloud(p, device=device) for p in (back(line, T), line))
    result = reg.registration_icp(source, target, 0.2, None, None, reg.ICPConvergenceCriteria(1e-12, 1e-12, 200))
    moved = source.points @ result.transformation[:3, :3].T + result.transformation[:3, 3]
    assert np.abs(moved[:, 1:]).max() < 1e-6
    np.testing.assert_allclose(np.abs(result.degenerate_directions), [[1, 0, 0, 0, 0, 0]], atol=1e-3)
    assert_rigid(result.transformation)


# ------------------------------------------------------------------------------------------------ where clouds lie


@pytest.mark.parametrize("kind", [k for k in KINDS if k not in ("doppler", "scaled")])
def test_far_from_zero_the_pose_is_that_of_centred_clouds(device, pair, kind):
    """UTM coordinates: the motion about the cloud's middle is the same to 1e-6."""
    source, target = on(device, *pair[:2])
    shift = np.array([5e5, 5.4e6, 100.0])
    rules = reg.ICPConvergenceCriteria(0, 0, 15)
    near = reg.registration_icp(source, target, 0.15, None, KINDS[kind], rules).transformation
    clouds = []
    for cloud, own in ((source, [0, 0, 0]), (target, [40, -30, 2])):  # origins of their own
        attributes = {name: cloud[name] for name in ("dopplers",)}
        clouds.append(
            loom.PointCloud(
                cloud.points + shift + own, normals=cloud.normals, colors=cloud.colors, device=device, **attributes
            )
        )
    assert all(c.origin.any() for c in clouds)
    init = as_pose(shift=[40, -30, 2])
    far = reg.registration_icp(*clouds, 0.15, init, KINDS[kind], rules).transformation
    np.testing.assert_allclose(far[:3, :3], near[:3, :3], atol=2e-5 if kind == "voxelised" else 1e-6)
    middle = np.array([0.1, -0.2, 0.05])
    moved = far[:3, :3] @ (middle + shift) + far[:3, 3] - shift - [40, -30, 2]
    np.testing.assert_allclose(moved, near[:3, :3] @ middle + near[:3, 3], atol=2e-5 if kind == "voxelised" else 1e-6)


def test_clouds_of_symmetric_shapes_keep_the_turn_they_come_with(device, rng):
    """A cube of lattice points fits itself 24 times; from near a quarter turn it goes there and not home."""
    cube = np.stack(np.meshgrid(*[np.linspace(-1, 1, 9)] * 3, indexing="ij"), -1).reshape(-1, 3)
    quarter = as_pose([0, 0, np.pi / 2])
    source, target = (loom.PointCloud(rng.permutation(cube), device=device) for _ in range(2))
    init = as_pose([0.02, -0.03, 0.02], [0.02, 0.01, 0]) @ quarter
    result = reg.registration_icp(source, target, 0.2, init, None, reg.ICPConvergenceCriteria(1e-9, 1e-9, 100))
    np.testing.assert_allclose(result.transformation, quarter, atol=1e-6)


# ------------------------------------------------------------------------------------------------ bad input


def full_cloud(points, device="cpu"):
    count = len(points)
    normals = np.tile([0.0, 0, 1], (count, 1))
    dopplers = np.zeros(count, np.float32)
    return loom.PointCloud(points, normals=normals, colors=np.full((count, 3), 0.5), dopplers=dopplers, device=device)


@EACH
@pytest.mark.parametrize("counts", [(0, 0), (0, 9), (9, 0)])
def test_empty_clouds_leave_the_initial_pose(device, kind, counts, rng):
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    clouds = (full_cloud(rng.random((n, 3)), device) for n in counts)
    result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.fitness, result.inlier_rmse, result.iterations) == (0.0, 0.0, 0)
    assert (result.converged, result.reason) == (False, "no correspondences")
    assert result.correspondence_set.shape == (0, 2) and result.correspondence_set.dtype == np.int32


@EACH
@pytest.mark.parametrize("nans", [False, True])
def test_clouds_without_pairs_leave_the_initial_pose(device, kind, nans, rng):
    """Open3D's tensor form resets it to the identity."""
    init = as_pose([0.1, 0.2, 0.3], [1, 2, 3])
    source = rng.random((20, 3)) + 50
    clouds = full_cloud(np.full((20, 3), np.nan) if nans else source, device), full_cloud(rng.random((30, 3)), device)
    result = reg.registration_icp(*clouds, 1.0, init, KINDS[kind])
    np.testing.assert_allclose(result.transformation, init, atol=1e-14)
    assert (result.fitness, result.converged, result.reason) == (0.0, False, "no correspondences")


@EACH
def test_pairs_that_are_lost_on_the_way_are_told(device, kind):
    """A step that tears the clouds apart ends with the pose that it led to."""
    source, target = (full_cloud(p, device) for p in ([[0.0, 0, 0], [0, 1, 0]], [[0.0, 0, 0.09], [0.05, 1, 0]]))
    result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], reg.ICPConvergenceCriteria(0, 0, 50))
    assert np.isfinite(result.transformation).all()
    assert (result.reason == "no correspondences") == (result.fitness == 0)


@EACH
@pytest.mark.parametrize("counts", [(1, 1), (1, 5), (2, 2), (3, 3), (5, 1)])
def test_few_points_give_finite_poses(device, kind, counts, rng):
    clouds = (full_cloud(rng.random((n, 3)), device) for n in counts)
    result = reg.registration_icp(*clouds, 2.0, None, KINDS[kind])
    assert np.isfinite(result.transformation).all() and 0 <= result.fitness <= 1
    if kind != "scaled":
        assert_rigid(result.transformation)


@EACH
def test_points_that_are_not_finite_do_not_count(device, pair, kind):
    """NaN and infinity sprinkled over both clouds: the pose of the clouds without them."""
    source, target = on(device, *pair[:2])
    spoiled = []
    for cloud in (source, target):
        order = np.arange(len(cloud) + 30) % len(cloud)
        points = cloud.points[order]
        points[-30:, :] = [np.nan, 0.1, 0.1]
        points[-10:, 2] = np.inf
        attributes = {n: cloud[n][order] for n in ("dopplers",)}
        normals = cloud.normals[order]
        normals[-30:] = np.nan
        colors = cloud.colors[order]
        spoiled.append(loom.PointCloud(points, normals=normals, colors=colors, device=device, **attributes))
    rules = reg.ICPConvergenceCriteria(0, 0, 5)
    clean = reg.registration_icp(source, target, 0.15, None, KINDS[kind], rules)
    result = reg.registration_icp(*spoiled, 0.15, None, KINDS[kind], rules)
    np.testing.assert_allclose(result.transformation, clean.transformation, atol=1e-9)
    assert result.fitness == clean.fitness


@EACH
@pytest.mark.parametrize("distance", [0, -1, np.nan, np.inf])
def test_a_distance_is_positive_and_finite(pair, kind, distance):
    with pytest.raises(ValueError, match=r"^max_correspondence_distance: expected a finite number > 0"):
        reg.registration_icp(*pair[:2], distance, None, KINDS[kind])


@pytest.mark.parametrize(
    ("init", "message"),
    [
        (np.eye(3), "expected shape \\[4, 4\\], got \\[3, 3\\]"),
        (np.full((4, 4), np.nan), "expected a finite"),
        (np.diag([2.0, 2, 2, 1]), "expected a rigid motion"),
        (np.diag([1.0, 1, -1, 1]), "expected a rigid motion"),
        (np.array([[1, 0.5, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), "expected a rigid motion"),
        (np.zeros((4, 4)), "expected a finite affine"),
        (np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 1, 1.0]]), "expected a finite affine"),
    ],
)
def test_an_initial_pose_is_rigid(pair, init, message):
    with pytest.raises(ValueError, match=rf"^init: {message}"):
        reg.registration_icp(*pair[:2], 0.1, init)


@pytest.mark.parametrize("init", [np.diag([1.0, 1, -1, 1]), np.diag([1.0, 2, 3, 1])])
def test_a_scaled_initial_pose_is_a_similarity(pair, init):
    with pytest.raises(ValueError, match=r"^init: expected a"):
        reg.registration_icp(*pair[:2], 0.1, init, KINDS["scaled"])


def test_an_initial_pose_that_is_nearly_rigid_is_made_so(device, pair):
    """Poses of data sets are rounded to a few digits."""
    source, target = on(device, *pair[:2])
    init = pair[2] + 1e-3 * np.array([[1, -1, 1, 0], [-1, 1, 1, 0], [1, 1, -1, 0], [0, 0, 0, 0]])
    for kind in ("point", "plane"):
        assert_rigid(reg.registration_icp(source, target, 0.1, init, KINDS[kind]).transformation)


# ------------------------------------------------------------------------------------------------ from coarse to fine


def test_scales_lead_from_farther_away(device, rng, angle_between):
    """Open3D's tutorial: three voxel sizes, each with its distance; the finest alone does not find it."""
    T = as_pose([0.2, -0.3, 0.4], [0.3, -0.2, 0.2])
    target = loom.PointCloud(wavy(rng, 12_000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(wavy(rng, 12_000), T), device=device)
    rules = [reg.ICPConvergenceCriteria(1e-4, 1e-4, 20), reg.ICPConvergenceCriteria(1e-5, 1e-5, 15)]
    rules += [reg.ICPConvergenceCriteria(1e-6, 1e-6, 10)]
    turns = []
    result = reg.multi_scale_icp(
        source, target, [0.1, 0.05, -1], rules, [0.3, 0.14, 0.07], None, PLANE, callback_after_iteration=turns.append
    )
    alone = reg.registration_icp(source, target, 0.07, None, PLANE, rules[2])
    assert angle_between(result.transformation, T) < 0.02 < 5 < angle_between(alone.transformation, T)
    assert result.fitness > 0.98 and len(result.correspondence_set) > 11_000
    assert [t["scale_index"] for t in turns] == sorted(t["scale_index"] for t in turns)
    assert {t["scale_index"] for t in turns} == {0, 1, 2} and result.iterations == len(turns)


def test_one_scale_is_plain_icp(device, pair):
    source, target = on(device, *pair[:2])
    rules = reg.ICPConvergenceCriteria(max_iteration=7)
    one = reg.multi_scale_icp(source, target, [-1], [rules], [0.1], pair[2], PLANE)
    plain = reg.registration_icp(source, target, 0.1, pair[2], PLANE, rules)
    np.testing.assert_array_equal(one.transformation, plain.transformation)


@pytest.mark.parametrize(
    ("sizes", "message"),
    [
        ([0.1, 0.2], "voxel_sizes: expected positive sizes in descending order"),
        ([0.1, 0.1], "voxel_sizes: expected positive sizes in descending order"),
        ([-1, 0.1], "voxel_sizes: expected positive sizes in descending order"),
        ([np.nan, 0.1], "voxel_sizes: expected positive sizes in descending order"),
        ([0.1], "voxel_sizes, criteria_list, max_correspondence_distances: expected lists of one length"),
        ([], "voxel_sizes, criteria_list, max_correspondence_distances: expected lists of one length"),
    ],
)
def test_voxel_sizes_descend(pair, sizes, message):
    rules = [reg.ICPConvergenceCriteria()] * 2
    with pytest.raises(ValueError, match=rf"^{message}"):
        reg.multi_scale_icp(*pair[:2], sizes, rules, [0.2, 0.1])


# ------------------------------------------------------------------------------------------------ the same every time


@EACH
def test_two_runs_give_the_same_bits(device, pair, kind):
    source, target = on(device, *pair[:2])
    one, two = (reg.registration_icp(source, target, 0.15, None, KINDS[kind], overlap=0.9) for _ in range(2))
    np.testing.assert_array_equal(one.transformation, two.transformation)
    np.testing.assert_array_equal(one.correspondence_set, two.correspondence_set)
    assert (one.fitness, one.inlier_rmse, one.iterations) == (two.fitness, two.inlier_rmse, two.iterations)


DIGEST = """
import hashlib, numpy as np, pointloom as loom
reg, rng = loom.registration, np.random.default_rng(3)
def cloud(shift):
    xy = rng.uniform(-1, 1, (12000, 2))
    points = np.column_stack([xy, 0.2 * np.sin(3 * xy[:, 0]) * np.cos(4 * xy[:, 1])])
    points[::500] = np.nan
    colors, speeds = rng.random((12000, 3)), rng.random(12000).astype(np.float32)
    return loom.PointCloud(points + shift, colors=colors, dopplers=speeds).estimate_normals(max_nn=12)
source, target = cloud(0.02), cloud(0)
name = "TransformationEstimation"
methods = [getattr(reg, name + end)() for end in ("PointToPlane", "Symmetric", "ForColoredICP", "ForDopplerICP")]
methods += [reg.TransformationEstimationPointToPoint(True), reg.TransformationEstimationForGeneralizedICP()]
methods += [reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1)]
methods += [reg.TransformationEstimationPointToPlane(reg.CauchyLoss(0.02))]
for method in methods:
    r = reg.registration_icp(source, target, 0.1, None, method, reg.ICPConvergenceCriteria(0, 0, 4), overlap=0.9)
    bits = r.transformation.tobytes() + r.correspondence_set.tobytes() + np.float64(r.inlier_rmse).tobytes()
    print(hashlib.sha256(bits).hexdigest())
"""


def test_any_number_of_threads_gives_the_same_bits():
    runs = []
    for threads in ("1", "2"):
        environment = os.environ | {"POINTLOOM_CPU": "taichi", "POINTLOOM_CPU_THREADS": threads}
        environment["PYTHONPATH"] = os.pathsep.join(p for p in sys.path if p)
        pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "text": True}
        runs.append(subprocess.Popen([sys.executable, "-c", DIGEST], env=environment, **pipes))
    answers = [run.communicate() for run in runs]  # both at once: most of their time is the start
    assert [run.returncode for run in runs] == [0, 0], answers
    assert answers[0][0] == answers[1][0] and len(set(answers[0][0].split())) == 8


@settings(max_examples=80, deadline=None)
@given(
    seed=st.integers(0, 2**20),
    counts=st.tuples(st.integers(0, 60), st.integers(0, 60)),
    lattice=st.booleans(),
    turn=st.tuples(*[st.floats(-3, 3)] * 3),
    shift=st.tuples(*[st.floats(-2, 2)] * 3),
    kind=st.sampled_from(list(KINDS)),
    distance=st.sampled_from([0.05, 0.5, 3.0, 1e9]),
    overlap=st.sampled_from([1.0, 0.5]),
)
def test_any_result_is_finite_and_rigid(seed, counts, lattice, turn, shift, kind, distance, overlap):
    rng, clouds = np.random.default_rng(seed), []
    for count in counts:
        points = rng.integers(0, 3, (count, 3)) * 0.5 if lattice else rng.normal(size=(count, 3))
        points = points.astype(float)
        points[rng.random(count) < 0.05] = np.nan
        normals = rng.normal(size=(count, 3))
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        extra = {"colors": rng.random((count, 3)), "dopplers": rng.normal(size=count).astype(np.float32)}
        clouds.append(loom.PointCloud(points, normals=normals, **extra))
    result = reg.registration_icp(*clouds, distance, as_pose(turn, shift), KINDS[kind], overlap=overlap)
    T = result.transformation
    assert np.isfinite(T).all() and 0 <= result.fitness <= 1 and np.isfinite(result.inlier_rmse)
    if kind == "scaled":
        T[:3, :3] /= np.cbrt(np.linalg.det(T[:3, :3]))
    assert_rigid(T)
    assert len(result.correspondence_set) == round(result.fitness * max(1, np.isfinite(clouds[0].points[:, 0]).sum()))
