"""ICP with a pose prior: against dense least squares, in corridors, and for invalid priors."""

import numpy as np
import pytest

import pointloom as loom

from ..products import each_pair
from .dense_icp import MOTIONS, DenseICP, motion
from .icp_clouds import KINDS, PLANE, noisy_pair, on
from .poses import as_pose
from .test_icp import degenerate

reg = loom.registration
LONG = reg.ICPConvergenceCriteria(0, 0, 300)
INIT = as_pose([0.01, 0.0, 0.02], [0.01, 0.0, 0.0])
UTM = np.array([691_000.0, 5_334_000.0, 500.0])


@pytest.fixture(scope="module")
def pair():
    return noisy_pair(2)


@pytest.mark.parametrize(**each_pair(
    free=[None, ("x", "y", "z", "yaw"), ("roll", "pitch", "yaw", "x")], kind=["plane", "point", "scaled"],
    noise=[0.05, None], rank=[6, 2],
))  # fmt: skip
def test_the_pose_matches_dense_least_squares(device, pair, free, kind, noise, rank, rng):
    """The prior differs from the truth, so that both have an effect."""
    source, target = on(device, *pair)
    offset = np.where([name in (free or MOTIONS) for name in MOTIONS], [0.02, -0.01, 0.03, 0.01, 0.01, -0.02], 0)
    apart = motion([*offset, 0], np.array([0.3, 0.2, 0.1]), np.eye(3)) @ INIT
    A = rng.normal(size=(6, rank)) * 300
    prior, weights = reg.Prior(apart, A @ A.T), rng.random(len(source)).astype(np.float32)
    given = {"pivot": (0.3, 0.2, 0.1), "noise": noise}
    bound, options = reg.Constraint(free, prior=prior, **given), {"degeneracy": 0, "weights": weights}
    result = reg.registration_icp(source, target, 0.3, INIT, KINDS[kind], LONG, constraint=bound, **options)
    given |= {"weights": weights.astype(float), "prior": (apart, np.asarray(prior.information))}
    given |= {"normals": target.normals if kind == "plane" else None, "scaling": kind == "scaled"}
    problem = DenseICP(source.points, target.points, INIT, free=free or MOTIONS, **given)
    pairs = tuple(np.asarray(result.correspondence_set).T)
    wanted = problem.pose(problem.minimum(pairs, np.zeros(len(problem.free))))
    np.testing.assert_allclose(result.transformation, wanted, atol=1e-6)
    bound = reg.Constraint(free)
    alone = reg.registration_icp(source, target, 0.3, INIT, KINDS[kind], LONG, constraint=bound, **options)
    assert np.abs(result.transformation - alone.transformation).max() > 3e-5  # it had an effect


def test_residuals_far_from_the_prior_are_exact(device, pair):
    """The logarithm and its derivative far from identity: about x by 3 rad, with the same weight as the pairs."""
    source, target = on(device, *pair)
    information = np.diag([1.0, 2.0, 3.0, 0, 0, 0]) * 1e4
    for angle in ([3.0, 0.2, -0.1], [0.1, -3.0, 0.2], [0.1, 0.2, 3.05], [0.5, 0, 0]):
        prior = reg.Prior(as_pose(angle), information)
        bound = reg.Constraint(prior=prior, noise=0.01, pivot=(0, 0, 0))
        result = reg.registration_icp(source, target, 0.3, INIT, PLANE, LONG, constraint=bound)
        given = {"prior": (as_pose(angle), information), "noise": 0.01, "pivot": (0, 0, 0), "normals": target.normals}
        problem = DenseICP(source.points, target.points, INIT, **given)
        pairs = tuple(np.asarray(result.correspondence_set).T)
        near = np.zeros(6)
        np.testing.assert_allclose(result.transformation, problem.pose(problem.minimum(pairs, near)), atol=1e-6)


def corridor(rng, shift=0, device="cpu"):
    """Two scans of a uniform corridor along y; the second is 0.3 m ahead."""
    clouds = []
    for way in (0.3, 0.0):
        points, normals = degenerate("corridor", rng, 3000)
        moved = points + 2e-3 * rng.normal(size=points.shape) + [0.02 * (way > 0), way * 0, 0] + shift
        clouds.append(loom.PointCloud(moved, normals=normals, device=device))
    return clouds


@pytest.mark.parametrize(("kind", "shift"), [("plane", 0.0), ("generalized", UTM), ("robust", UTM)])
def test_a_corridor_is_constrained_by_odometry_along_its_axis(device, kind, shift, rng):
    """Without a prior the motion along it is zero and reported; with a prior it follows odometry, also reported."""
    source, target = corridor(rng, shift, device)
    alone = reg.registration_icp(source, target, 0.3, None, KINDS[kind])
    np.testing.assert_allclose(np.abs(alone.degenerate_directions), [[0, 0, 0, 0, 1, 0]], atol=0.02)
    assert len(alone.prior_directions) == 0
    odometry = reg.Prior(as_pose([0, 0, 0], [0.1, 0.3, 0.05]), sigma_translation=0.2, sigma_rotation=0.05)
    bound = reg.Constraint(prior=odometry)
    constrained = reg.registration_icp(source, target, 0.3, None, KINDS[kind], LONG, constraint=bound)
    middle = source.get_center()
    way = constrained.transformation[:3, :3] @ middle + constrained.transformation[:3, 3] - middle
    np.testing.assert_allclose(way, [-0.02, 0.3, 0], atol=3e-3)  # the prior along it, the walls across it
    np.testing.assert_allclose(constrained.prior_directions, constrained.degenerate_directions, atol=0)
    np.testing.assert_allclose(np.abs(constrained.prior_directions), [[0, 0, 0, 0, 1, 0]], atol=0.02)


def test_a_prior_without_axis_information_leaves_the_axis_free(device, rng):
    """Singular information constrains part: of a plane's three free motions one is constrained, and comes first."""
    source, target = corridor(rng, 0.0, device)
    level = reg.Prior(as_pose([0, 0, 0], [0, 0.3, 0]), sigma_rotation=0.01)
    result = reg.registration_icp(source, target, 0.3, None, PLANE, constraint=reg.Constraint(prior=level))
    assert len(result.degenerate_directions) == 1 and len(result.prior_directions) == 0
    assert abs(result.transformation[1, 3]) < 1e-3
    floor = np.column_stack([rng.uniform(-2, 2, (2000, 2)), np.zeros(2000)])
    target = loom.PointCloud(floor, normals=np.tile([0.0, 0, 1], (2000, 1)), device=device)
    source = loom.PointCloud(floor + np.array([0, 0, 0.02]), device=device)
    slope = np.zeros((6, 6))
    slope[3:5, 3:5] = 1e4 * np.outer([0.6, 0.8], [0.6, 0.8])
    known = reg.Prior(as_pose([0, 0, 0], [0.1, 0.1, 0.5]), slope)
    result = reg.registration_icp(source, target, 0.3, None, PLANE, LONG, constraint=reg.Constraint(prior=known))
    assert len(result.degenerate_directions) == 3
    np.testing.assert_allclose(np.abs(result.prior_directions), [[0, 0, 0, 0.6, 0.8, 0]], atol=1e-6)
    np.testing.assert_allclose(result.transformation[:3, 3], [0.6 * 0.14, 0.8 * 0.14, -0.02], atol=1e-5)
    np.testing.assert_allclose(result.transformation[:3, :3], np.eye(3), atol=1e-6)


def test_pairs_override_a_wrong_prior_where_they_determine_the_pose(device, pair):
    """A prior 5 cm off with sigma 2 cm: 700 pairs of 3 mm dominate; a prior with sigma 10 um dominates them."""
    source, target = on(device, *pair)
    free = reg.registration_icp(source, target, 0.3, INIT, PLANE, LONG).transformation
    poses = []
    for sigma in (0.02, 1e-5):
        prior = reg.Prior(as_pose([0, 0, 0], [0.05, 0, 0]) @ free, sigma_translation=sigma)
        bound = reg.Constraint(prior=prior, pivot=(0, 0, 0))
        result = reg.registration_icp(source, target, 0.3, INIT, PLANE, LONG, constraint=bound)
        poses.append(result.transformation - free)
    assert np.abs(poses[0])[:3, 3].max() < 2e-3
    np.testing.assert_allclose(poses[1][:3, 3], [0.05, 0, 0], atol=5e-3)


def test_a_prior_has_an_effect_beside_exact_pairs(device, rng):
    """Residuals of exactly zero: noise has a lower limit, so the prior still constrains the axis of a corridor."""
    points, normals = degenerate("corridor", rng, 2000)
    cloud = loom.PointCloud(points, normals=normals, device=device)
    prior = reg.Prior(as_pose([0, 0, 0], [0, 0.1, 0]), sigma_translation=0.1)
    result = reg.registration_icp(cloud, cloud, 0.05, None, PLANE, LONG, constraint=reg.Constraint(prior=prior))
    np.testing.assert_allclose(result.transformation[:3, 3], [0, 0.1, 0], atol=1e-3)


def test_an_unreachable_prior_is_reported(pair):
    def register(free, prior):
        reg.registration_icp(*pair, 0.3, None, PLANE, constraint=reg.Constraint(free, prior=prior))

    beside, level = as_pose([0, 0, 0], [0, 0.5, 0]), ("x", "y", "z", "yaw")
    with pytest.raises(ValueError, match=r"^constraint: prior"):
        register(("x",), reg.Prior(beside, sigma_translation=0.01))
    for prior in (reg.Prior(beside, sigma_translation=0.2), reg.Prior(beside, sigma_rotation=0.01)):
        register(("x",), prior)
    register(level, reg.Prior(as_pose([0, 0, 2.0]), sigma_rotation=0.01))  # a yaw that is free, far away
    with pytest.raises(ValueError, match=r"^constraint: prior"):
        register(level, reg.Prior(as_pose([0.5, 0, 0]), sigma_rotation=0.01))
