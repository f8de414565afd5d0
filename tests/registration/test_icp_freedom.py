"""ICP with restricted degrees of freedom: against dense least squares; fixed components stay as in `init`."""

from itertools import product

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.registration.icp.leveling import leveled

from ..products import each_pair
from .dense_icp import MOTIONS, DenseICP
from .icp_clouds import KINDS, PLANE, back, noisy_pair, on, wavy
from .poses import as_pose

reg = loom.registration
LONG = reg.ICPConvergenceCriteria(0, 0, 40)
FRAME = Rotation.from_rotvec([0.3, -0.2, 0.5]).as_matrix()
INIT = as_pose([0.01, 0.0, 0.02], [0.01, 0.0, 0.0])
UTM = np.array([691_000.0, 5_334_000.0, 500.0])


@pytest.fixture(scope="module")
def pair():
    return noisy_pair(1)


def dense(source, target, result, kind="plane", **options):
    """The optimal pose for the pairs of a result."""
    if kind == "plane":
        options["normals"] = target.normals
    problem = DenseICP(source.points, target.points, INIT, scaling=kind == "scaled", **options)
    pairs = tuple(np.asarray(result.correspondence_set).T)
    return problem.pose(problem.minimum(pairs, np.zeros(len(problem.free))))


def parameters(T, init, pivot, frame):
    """Roll, pitch, yaw [rad] and displacement [m] of the pivot since a first pose, in a frame."""
    D = frame.T @ T[:3, :3] @ init[:3, :3].T @ frame
    yaw, pitch, roll = Rotation.from_matrix(D).as_euler("ZYX")
    local_pivot = init[:3, :3].T @ (pivot - init[:3, 3])
    return np.array([roll, pitch, yaw, *(frame.T @ (T[:3, :3] @ local_pivot + T[:3, 3] - pivot))])


@pytest.mark.parametrize(
    ("kind", "free", "frame", "pivot"),
    [
        ("plane", ("x", "y", "z", "yaw"), None, None), ("scaled", ("x",), FRAME, None),
        ("plane", ("yaw", "pitch", "x"), FRAME, (0.1, 0.2, 0.3)),
        ("point", ("roll", "pitch", "yaw"), None, (0.5, 0.0, -0.5)),
        *((kind, ("roll", "y", "z", "pitch", "yaw"), FRAME, None) for kind in ("plane", "scaled")),
    ],
)  # fmt: skip
def test_the_pose_matches_dense_least_squares(device, pair, kind, free, frame, pivot):
    source, target = on(device, *pair)
    given = {"free": free, "frame": frame, "pivot": pivot}
    bound = {"constraint": reg.Constraint(**given), "degeneracy": 0}
    result = reg.registration_icp(source, target, 0.3, INIT, KINDS[kind], LONG, **bound)
    wanted = dense(source, target, result, kind, **given)
    np.testing.assert_allclose(result.transformation, wanted, atol=1e-6)
    assert np.abs(result.transformation - INIT).max() > 1e-3  # it moved
    assert result.free == tuple(name for name in MOTIONS if name in free)


@pytest.mark.parametrize("kind", ["point", "scaled", "plane", "robust", "generalized", "voxelized", "colored"])
def test_a_prior_without_information_leaves_the_full_pose(device, full_pair, kind):
    """Two code paths to one pose: the step of all jobs, and that of jobs with a constraint."""
    source, target = on(device, *full_pair[:2])
    prior = reg.Prior(np.eye(4), sigma_translation=1e6, sigma_rotation=1e6)
    given = source, target, 0.2, None, KINDS[kind], LONG
    results = (reg.registration_icp(*given, constraint=p) for p in (None, reg.Constraint(prior=prior)))
    np.testing.assert_allclose(*(result.transformation for result in results), atol=1e-6)


@pytest.mark.parametrize(**each_pair(
    free=[("x", "y", "z", "yaw"), ("x",), ("roll", "yaw")], kind=["point", "plane", "generalized", "colored"],
    shift=[np.zeros(3), UTM],
))  # fmt: skip
def test_fixed_components_stay_as_in_init(device, full_pair, kind, shift, free):
    clouds = []
    for cloud in on(device, *full_pair[:2]):
        names = {"normals": cloud.normals, "colors": cloud.colors}
        clouds.append(loom.PointCloud(cloud.points + shift, device=device, **names))
    init = as_pose([0.02, -0.01, 0.01])
    init[:3, 3] = shift - init[:3, :3] @ shift
    pivot = shift + np.array([0.1, 0.2, 0.0])
    for frame in (np.eye(3), FRAME):
        bound = reg.Constraint(free, frame, pivot)
        result = reg.registration_icp(*clouds, 0.2, init, KINDS[kind], LONG, constraint=bound)
        values = parameters(result.transformation, init, pivot, frame)
        fixed = [name not in free for name in MOTIONS]
        assert np.abs(values[fixed]).max() < 1e-12 * max(1.0, np.abs(shift).max())
        assert np.abs(values).max() > 1e-3
    fixed_rows = np.ones(3, bool) if "yaw" not in free else np.array([False, False, True])
    if "roll" not in free:  # exactly level in floating point
        bound = reg.Constraint(free)
        level = reg.registration_icp(*clouds, 0.2, init, KINDS[kind], LONG, constraint=bound).transformation
        np.testing.assert_allclose(level[:3, :3][fixed_rows], init[:3, :3][fixed_rows], atol=1e-15)


def test_a_rail_along_any_axis_keeps_the_initial_rotation_bitwise(device, pair):
    source, target = on(device, *pair)
    init = as_pose([0.02, -0.01, 0.01])
    still = reg.ICPConvergenceCriteria(max_iteration=0)
    start = reg.registration_icp(source, target, 0.3, init, PLANE, still).transformation
    bound = reg.Constraint(("x",), FRAME)
    rail = reg.registration_icp(source, target, 0.3, init, PLANE, LONG, constraint=bound).transformation
    assert (rail[:3, :3] == start[:3, :3]).all() and (rail[:3, 3] != start[:3, 3]).all()


def test_rotations_about_two_axes_are_preserved_across_scales(device, rng):
    """Roll and pitch after roll and pitch are not roll and pitch: all scales are relative to the first pose."""
    T = as_pose(Rotation.from_euler("ZYX", [0, 0.3, 0.25]).as_rotvec())
    target = loom.PointCloud(wavy(rng, 3000), device=device).estimate_normals(max_nn=20)
    source = loom.PointCloud(back(target.points, T), device=device)
    rules = [reg.ICPConvergenceCriteria(1e-9, 1e-9, n) for n in (3, 3, 40)]
    scales = [0.2, 0.1, -1], rules, [1.0, 0.5, 0.3]
    bound = reg.Constraint(("roll", "pitch"), pivot=(0, 0, 0))
    result = reg.multi_scale_icp(source, target, *scales, None, PLANE, constraint=bound)
    np.testing.assert_allclose(result.transformation, T, atol=1e-5)
    values = parameters(result.transformation, np.eye(4), np.zeros(3), np.eye(3))
    assert np.abs(values[2:]).max() < 1e-14


def test_a_batch_has_a_pivot_and_a_prior_for_each_job(device, pair):
    source, target = on(device, *pair)
    sigmas = {"sigma_translation": 0.01, "sigma_rotation": 0.02}
    priors = [reg.Prior(as_pose([0, 0, a], [a, 0, 0]), **sigmas) for a in (0.0, 0.05, 0.0)]
    pivots = np.array([[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [0.0, 0.0, 0.0]])
    shared, weights = {"free": ("x", "y", "z", "yaw"), "noise": 0.05}, np.linspace(0, 1, len(source))
    inits = np.stack([np.eye(4), np.eye(4), as_pose([0, 0, 0], [100, 0, 0])])  # the last one has no pairs
    given = {"constraint": reg.Constraint(pivot=pivots, prior=priors, **shared), "weights": weights}
    results = reg.registration_icp_batch(source, target, 0.3, inits, PLANE, LONG, **given)
    assert results[2].warnings == ("no correspondences",)
    for job, result in enumerate(results[:2]):
        own = reg.Constraint(pivot=pivots[job], prior=priors[job], **shared)
        one = reg.registration_icp(source, target, 0.3, None, PLANE, LONG, constraint=own, weights=weights)
        np.testing.assert_allclose(result.transformation, one.transformation, atol=1e-12)
    assert np.abs(results[0].transformation - results[1].transformation).max() > 1e-3


def test_naming_all_freedoms_equals_no_restriction(device, pair):
    source, target = on(device, *pair)
    given = source, target, 0.3, INIT, PLANE
    free, bound = (reg.registration_icp(*given, constraint=c) for c in (None, reg.Constraint(MOTIONS)))
    assert (free.transformation == bound.transformation).all() and bound.free is None
    assert reg.Constraint().free == MOTIONS and reg.Constraint(iter(("x", "yaw"))).free == ("yaw", "x")


def test_weights_count_as_duplicate_points(device, full_pair, rng):
    source, target = on(device, *full_pair[:2])
    weights = rng.integers(0, 3, len(source))
    rows = np.repeat(np.arange(len(source)), weights)
    names = {"normals": source.normals, "colors": source.colors, "dopplers": source["dopplers"]}
    repeated = loom.PointCloud(source.points[rows], device=device, **{n: v[rows] for n, v in names.items()})
    source["fraction"] = weights.astype(np.float32)
    for kind, method in KINDS.items():
        weighted = reg.registration_icp(source, target, 0.2, None, method, LONG, weights="fraction", degeneracy=0)
        wanted = reg.registration_icp(repeated, target, 0.2, None, method, LONG, degeneracy=0)
        np.testing.assert_allclose(weighted.transformation, wanted.transformation, atol=1e-7, err_msg=kind)
        plain = reg.registration_icp(source, target, 0.2, None, method, LONG, degeneracy=0)
        assert np.abs(weighted.transformation - plain.transformation).max() > 1e-6, kind


def test_empty_clouds_and_single_points_respect_the_freedom(device):
    for points in (np.zeros((0, 3)), np.zeros((1, 3)), np.zeros((2, 3))):
        source = loom.PointCloud(points, device=device)
        target = loom.PointCloud(points + np.array([0.05, 0.02, 0.0]), device=device)
        for free, kind in product((("x",), ("yaw",), ("roll", "pitch", "yaw")), ("point", "scaled")):
            bound = reg.Constraint(free)
            result = reg.registration_icp(source, target, 0.1, None, KINDS[kind], LONG, constraint=bound)
            wanted = [0.05 * (free == ("x",) and len(points) > 0), 0, 0]
            np.testing.assert_allclose(result.transformation[:3, 3], wanted, atol=1e-7)


def test_motion_along_a_rail_is_reported_degenerate(device, rng):
    """A flat floor, and a cloud that may only slide along it: the single degree of freedom is degenerate."""
    floor = np.column_stack([rng.uniform(-2, 2, (2000, 2)), rng.normal(0, 1e-3, 2000)])  # noise constrains it slightly
    target = loom.PointCloud(floor, device=device).estimate_normals(max_nn=10)
    source = loom.PointCloud(floor + np.array([0.05, 0, 0.02]), device=device)
    result = reg.registration_icp(source, target, 0.3, None, PLANE, constraint=reg.Constraint(("x",)))
    np.testing.assert_allclose(np.abs(result.degenerate_directions), [[0, 0, 0, 1, 0, 0]], atol=1e-9)
    assert (result.transformation == np.eye(4)).all()
    both = reg.registration_icp(source, target, 0.3, None, PLANE, constraint=reg.Constraint(("x", "z")))
    assert len(both.degenerate_directions) == 1 and len(both.prior_directions) == 0
    np.testing.assert_allclose(both.transformation[:3, 3], [0, 0, -0.02], atol=1e-3)


def test_a_leveled_pose_aligns_the_up_directions(rng):
    for _ in range(20):
        init, up = as_pose(rng.normal(size=3), rng.normal(size=3)), rng.normal(size=3)
        T = leveled(init, up, (0, 0, 2))
        np.testing.assert_allclose(T[:3, :3] @ up, [0, 0, np.linalg.norm(up)], atol=1e-12)
        np.testing.assert_allclose(T[:3, 3], init[:3, 3], atol=0)
        min_angle = np.arccos(np.clip((init[:3, :3] @ up)[2] / np.linalg.norm(up), -1, 1))
        assert abs(Rotation.from_matrix(T[:3, :3] @ init[:3, :3].T).magnitude() - min_angle) < 1e-9
    np.testing.assert_allclose(leveled(None, (0, 0, 9.81)), np.eye(4), atol=0)
