"""Every estimator with every kernel takes Open3D's steps: the first one, and the total of all.

Open3D linearizes about the origin, pointloom about the centroid of the pairs: the scenes have that at the origin.
"""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom
from pointloom import open3d
from pointloom.registration.icp.preparation import generalized_covariances
from pointloom.registration.rigid import fit_pose

from .estimator_steps import DISTANCE, legacy_cloud, result_after, tensor_after, tensor_cloud, tensor_kernel
from .icp_clouds import back, noisy_pair, wavy, wavy_normals
from .poses import as_pose

reg = loom.registration
KERNELS = {
    "L2Loss": (), "L1Loss": (), "HuberLoss": (0.01,), "CauchyLoss": (0.02,), "GMLoss": (0.01,), "TukeyLoss": (0.06,),
}  # fmt: skip
WHITENED = KERNELS | {"HuberLoss": (1.0,), "TukeyLoss": (5.0,)}  # residuals of whitened rows have no unit
# The estimator, its arguments (kernels by name) and the number of steps.
STEPS = [
    *(("PointToPoint", (scaling,), steps) for scaling in (False, True) for steps in (1, 20)),
    *((name, (loss,), 1) for name in ("PointToPlane", "Symmetric") for loss in KERNELS),
    *((name, (loss,), 20) for name in ("PointToPlane", "Symmetric") for loss in ("L2Loss", "TukeyLoss")),
    ("Symmetric", ("L1Loss",), 20),  # to planes Open3D's steps differ between runs: weights of 1e9 near the planes
    *(("ForGeneralizedICP", (1e-3, loss), 1) for loss in KERNELS),
    *(("ForGeneralizedICP", (1e-3, loss), 20) for loss in ("L2Loss", "CauchyLoss")),
    *(("ForColoredICP", (0.968, loss), 1) for loss in KERNELS),
    *(("ForColoredICP", (fraction, loss), 20) for fraction, loss in ((0.968, "L2Loss"), (0.5, "HuberLoss"))),
]
ESTIMATORS = ("PointToPoint", "PointToPlane", "Symmetric", "ForGeneralizedICP", "ForColoredICP")
SHAPES = (2.0, 1.0, 0.0, -2.0, -1e8)


@pytest.fixture(scope="module")
def pair():
    """Two samplings of a surface, 3 degrees and 5 cm apart, with normals and colors; 4 % of the source is clutter."""
    rng = np.random.default_rng(2)
    T = as_pose([0.03, -0.04, 0.02], [0.03, -0.03, 0.02])
    target, source = wavy(rng, 2500), wavy(rng, 2000)
    colors = [0.5 + 0.4 * np.sin(p @ np.array([[5, 1, 2], [3, 6, 2], [2, 2, 7]])) for p in (source, target)]
    normals = wavy_normals(source) @ T[:3, :3], wavy_normals(target)
    source[:80, 2] += rng.uniform(-0.1, 0.1, 80)
    arrays = zip((back(source, T), target), normals, colors, strict=True)
    made = [loom.PointCloud(p, normals=n, colors=c) for p, n, c in arrays]
    return about_pairs(SimpleNamespace(source=made[0], target=made[1], T=T), np.eye(4))[0]


def about_pairs(pair, init):
    """The clouds and a pose, shifted so that the centroid of the paired source points is at 0."""
    correspondences = reg.evaluate_registration(pair.source, pair.target, DISTANCE, init).correspondence_set
    shift = as_pose([0, 0, 0], -(pair.source.points[correspondences[:, 0]] @ init[:3, :3].T + init[:3, 3]).mean(axis=0))
    source, target = (cloud.transform(shift) for cloud in (pair.source, pair.target))
    T, init = (shift @ pose @ np.linalg.inv(shift) for pose in (pair.T, init))
    return SimpleNamespace(source=source, target=target, T=T), init


def method_of(module, name, arguments):
    """An estimator of pointloom or Open3D; kernels by their names."""
    kernels = WHITENED if name == "ForGeneralizedICP" else KERNELS
    made = (getattr(module, a)(*kernels[a]) if isinstance(a, str) else a for a in arguments)
    return getattr(module, f"TransformationEstimation{name}")(*made)


def legacy_after(o3d, clouds, name, arguments, steps, init=None):
    """Open3D's result: pose, fitness, error, and the target index of each source point."""
    theirs = o3d.pipelines.registration
    own = {"ForColoredICP": theirs.registration_colored_icp, "ForGeneralizedICP": theirs.registration_generalized_icp}
    method, rules = method_of(theirs, name, arguments), theirs.ICPConvergenceCriteria(0, 0, steps)
    init = np.eye(4) if init is None else init
    result = own.get(name, theirs.registration_icp)(*clouds, DISTANCE, init, method, rules)
    rows, columns = np.asarray(result.correspondence_set).T
    targets = np.full(len(clouds[0].points), -1, np.int16)
    targets[rows] = columns
    return result.transformation, result.fitness, result.inlier_rmse, targets


def all_steps(o3d, pair):
    clouds = [legacy_cloud(o3d, cloud) for cloud in (pair.source, pair.target)]
    poses, *figures, _ = zip(*(legacy_after(o3d, clouds, *case) for case in STEPS), strict=True)
    return np.array(poses), np.array(figures).T


@pytest.fixture(scope="module")
def theirs(pair, oracle):
    """Open3D's pose, fitness and error of each of STEPS."""
    poses, figures = oracle("registration/estimation/steps", all_steps, pair)
    return {str(case): (pose, *both) for case, pose, both in zip(STEPS, poses, figures, strict=True)}


def assert_same(actual, theirs, tolerance):
    """The same pose, and the same pairs except those that such a small motion changes."""
    transformation, fitness, rmse, *targets = theirs
    np.testing.assert_allclose(actual.transformation, transformation, rtol=0, atol=tolerance)
    assert actual.fitness == pytest.approx(fitness, abs=tolerance)
    assert actual.inlier_rmse == pytest.approx(rmse, abs=tolerance)
    for column in targets:
        mine = np.full(len(column), -1)
        mine[actual.correspondence_set[:, 0]] = actual.correspondence_set[:, 1]
        assert (mine != column).sum() <= (6 if tolerance > 1e-5 else 0)


@pytest.mark.parametrize(("name", "arguments", "steps"), STEPS, ids=str)
def test_steps_match_open3d(device, pair, theirs, name, arguments, steps, tolerances):
    kind = {"ForGeneralizedICP": "icp_pose_float32", "ForColoredICP": "icp_pose_colored"}.get(name, "icp_pose")
    if "L1Loss" in arguments and (steps > 1 or name.startswith("For")):
        kind = "icp_pose_l1"
    result = result_after(device, pair, method_of(reg, name, arguments), steps)
    assert_same(result, theirs[str((name, arguments, steps))], getattr(tolerances, kind))


@pytest.mark.parametrize("loss", list(KERNELS))
def test_zero_color_weight_gives_point_to_plane(device, pair, loss, tolerances):
    """For L1 too, where Open3D divides zero residuals of the empty rows by zero and does not move."""
    methods = method_of(reg, "ForColoredICP", (1.0, loss)), method_of(reg, "PointToPlane", (loss,))
    result, expected = (result_after(device, pair, method, 3).transformation for method in methods)
    np.testing.assert_allclose(result, expected, rtol=0, atol=tolerances.icp_pose)


def steps_from(o3d, pair, init):
    clouds = [legacy_cloud(o3d, cloud) for cloud in (pair.source, pair.target)]
    return {name: legacy_after(o3d, clouds, name, (), 1, init) for name in ESTIMATORS}


def test_steps_from_an_initial_pose_match_open3d(device, pair, oracle, tolerances):
    """Source normals and covariances rotate with the initial pose."""
    pair, init = about_pairs(pair, as_pose([0.05, 0.1, 0.3], [0.05, 0, 0.02]) @ pair.T)
    for name, expected in oracle("registration/estimation/initial_pose", steps_from, pair, init).items():
        tolerance = tolerances.icp_pose_colored if name == "ForColoredICP" else tolerances.icp_pose_float32
        assert expected[1] > 0.5
        assert_same(result_after(device, pair, method_of(reg, name, ()), 1, init), expected, tolerance)


def steps_with(o3d, pair, covariances):
    clouds = [legacy_cloud(o3d, cloud) for cloud in (pair.source, pair.target)]
    clouds[0].covariances = o3d.utility.Matrix3dVector(covariances.astype(np.float64))
    return legacy_after(o3d, clouds, "ForGeneralizedICP", (), 5)[:3]


def random_covariances(rng, count):
    A = 0.2 * rng.normal(size=(count, 3, 3)) + np.diag([1.0, 0.7, 0.1])
    return (A @ A.transpose(0, 2, 1) + 0.01 * np.eye(3)).astype(np.float32)


def test_own_covariances_of_open3d_are_used_as_they_are(pair, oracle, rng, tolerances):
    """For each cloud separately: one has covariances, those of the other follow from its normals."""
    C = random_covariances(rng, len(pair.source))
    expected = oracle("registration/estimation/covariances", steps_with, pair, C)
    for mine, theirs in zip(steps_with(open3d, pair, C), expected, strict=True):
        np.testing.assert_allclose(mine, theirs, rtol=0, atol=tolerances.icp_pose_float32)


def test_own_covariances_are_used_before_normals_as_planes(device, pair, rng):
    """Across the smallest variance. Only their shape counts. Planes remain as they are."""
    C = random_covariances(rng, len(pair.source))
    thin = np.linalg.eigh(C.astype(np.float64))[1][:, :, 0]
    planes = np.eye(3) - 0.999 * thin[:, :, None] * thin[:, None, :]
    method = method_of(reg, "ForGeneralizedICP", ())
    poses = []
    for covariances in (C, 1e-4 * C, planes, None):
        source = loom.PointCloud(pair.source.points, normals=thin if covariances is None else pair.source.normals)
        if covariances is not None:
            source["covariances"] = covariances.reshape(-1, 9).astype(np.float32)
        poses.append(result_after(device, SimpleNamespace(source=source, target=pair.target), method, 5).transformation)
    np.testing.assert_allclose(poses[:3], [poses[3]] * 3, atol=1e-5)
    assert np.abs(result_after(device, pair, method, 5).transformation - poses[0]).max() > 1e-4


def test_covariances_without_a_smallest_variance_are_isotropic(device):
    """Of points that coincide, are on a line, or are the same in all directions."""
    line = np.outer([1, 2, 2], [1, 2, 2]) / 9
    plane = np.diag([1.0, 1, 1e-2])
    given = np.array([np.zeros((3, 3)), line, 4 * np.eye(3), plane, np.full((3, 3), np.nan), 1e-12 * plane])
    cloud = loom.PointCloud(np.zeros((6, 3)), covariances=given.reshape(-1, 9).astype(np.float32), device=device)
    made = loom.PointCloud(np.zeros((6, 3)), covariances=generalized_covariances(cloud, 1e-3).numpy()).covariances
    flat = np.diag([1.0, 1, 1e-3])
    expected = [np.eye(3), np.eye(3), np.eye(3), flat, np.full((3, 3), np.nan), flat]
    np.testing.assert_allclose(made, expected, atol=1e-6)


@pytest.mark.parametrize("voxel_size", [None, 1.0])
def test_covariances_and_normals_of_a_street_give_the_same_accuracy(device, voxel_size):
    """Of the same 10 neighbors. Ground, walls with bays, and poles, thinned with distance, with noise of 1 cm."""
    method = reg.TransformationEstimationForGeneralizedICP(voxel_size=voxel_size)
    errors = []
    for seed in range(3):
        rng = np.random.default_rng(seed)
        truth = as_pose(rng.normal(0, 0.02, 3), rng.normal(0, 0.2, 3))
        scans = [street(rng, pose, device) for pose in (truth, np.eye(4))]
        for prepare in (lambda c: c.estimate_normals(max_nn=10), lambda c: c.estimate_covariances(max_nn=10)):
            result = reg.registration_icp(*map(prepare, scans), 1.0, np.eye(4), method)
            errors.append(np.linalg.norm((np.linalg.inv(truth) @ result.transformation)[:3, 3]))
    by_normals, by_covariances = np.array(errors).reshape(-1, 2).T
    assert by_normals.max() < 0.05
    np.testing.assert_allclose(by_covariances, by_normals, atol=1e-4)


def street(rng, pose, device):
    parts = [np.c_[rng.uniform(-20, 20, 20000), rng.uniform(-8, 8, 20000), np.zeros(20000)]]
    for side, period, depth in ((8.0, 6, -0.8), (-8.0, 7, 1.0)):
        wall = np.c_[rng.uniform(-20, 20, 10000), np.full(10000, side), rng.uniform(0, 5, 10000)]
        wall[:, 1] += depth * (wall[:, 0] % period < 2.5)
        parts.append(wall)
    for k in range(8):
        a = rng.uniform(0, 2 * np.pi, 300)
        pole = np.c_[0.3 * np.cos(a), 0.3 * np.sin(a), rng.uniform(0, 4, 300)]
        parts.append(np.add(pole, [5 * k - 18, 5 * (-1) ** k, 0]))
    points = np.concatenate(parts)
    near = 18 / np.maximum(np.linalg.norm(points[:, :2], axis=1), 1) ** 2
    points = points[rng.random(len(points)) < near]
    points += rng.normal(0, 0.01, points.shape)
    return loom.PointCloud((points - pose[:3, 3]) @ pose[:3, :3], device=device).voxel_down_sample(0.25)


def steps_of_shapes(o3d, pair):
    clouds = [tensor_cloud(o3d, cloud) for cloud in (pair.source, pair.target)]
    plane = o3d.t.pipelines.registration.TransformationEstimationPointToPlane
    methods = [plane(tensor_kernel(o3d, "GeneralizedLoss", 0.02, shape)) for shape in SHAPES]
    return np.array([[tensor_after(o3d, clouds, method, steps) for steps in (1, 20)] for method in methods])


def test_steps_of_general_kernels_match_open3d(device, pair, oracle, tolerances):
    answers = oracle("registration/estimation/general_kernels", steps_of_shapes, pair)
    for shape, expected in zip(SHAPES, answers, strict=True):
        method = reg.TransformationEstimationPointToPlane(reg.GeneralizedLoss(0.02, shape))
        for steps, pose in zip((1, 20), expected, strict=True):
            actual = result_after(device, pair, method, steps).transformation
            np.testing.assert_allclose(actual, pose, rtol=0, atol=tolerances.icp_pose, err_msg=f"{shape} {steps}")


def test_point_to_point_weights_depend_on_distance(device, pair, tolerances):
    """One weighted step against the closed form in float64."""
    method = reg.TransformationEstimationPointToPoint(kernel=reg.CauchyLoss(0.03))
    result = result_after(device, pair, method, 1).transformation
    pairs = reg.evaluate_registration(pair.source, pair.target, DISTANCE).correspondence_set
    p, q = pair.source.points[pairs[:, 0]], pair.target.points[pairs[:, 1]]
    w = 1 / (1 + ((p - q) ** 2).sum(axis=1) / 0.03**2)
    np.testing.assert_allclose(result, fit_pose(p, q, weights=w), rtol=0, atol=tolerances.icp_pose)


def test_voxelized_gicp_matches_the_plain_form(device, pair, angle_between):
    result = result_after(device, pair, reg.TransformationEstimationForGeneralizedICP(voxel_size=0.1), 30)
    assert angle_between(result.transformation, pair.T) < 0.1
    assert np.abs(result.transformation[:3, 3] - pair.T[:3, 3]).max() < 2e-3
    rows, voxels = result.correspondence_set.T
    assert (np.diff(rows) > 0).all() and voxels.min() >= 0 and result.fitness == len(rows) / len(pair.source)


DOPPLER_STEPS = (20, 40)


@pytest.fixture(scope="module")
def drive():
    """A scan with radial speeds, clutter, and the room a moment later, for a car that moves by the inverse of T."""
    rng = np.random.default_rng(4)
    T = as_pose([0.004, -0.003, 0.02], [0.05, -0.03, 0.02])  # source to target, in 0.1 s
    (target, normals), (source, _) = room(rng, 4000), room(rng, 3000)
    source = (source - T[:3, 3]) @ T[:3, :3]
    ways = source / np.linalg.norm(source, axis=1, keepdims=True)
    speeds = ways @ (T[:3, 3] / 0.1) + 0.02 * rng.normal(size=3000)
    speeds[::17] += rng.uniform(3, 6, len(speeds[::17]))
    cloud = loom.PointCloud(source, dopplers=speeds.astype(np.float32))
    return SimpleNamespace(source=cloud, target=loom.PointCloud(target, normals=normals), T=T)


def room(rng, count):
    """Points on the walls of a room of 2.4 x 2 x 1.6 m around the sensor, and their normals."""
    p, faces = rng.uniform(-1, 1, (count, 3)), rng.integers(0, 3, count)
    p[np.arange(count), faces] = rng.choice([-1.0, 1.0], count)
    return p * [1.2, 1.0, 0.8] + [0.1, 0.05, -0.1], np.eye(3)[faces]


LOSSES = {"L2Loss": (), "TukeyLoss": (0.1,)}


def doppler_method(rules, kernels=("L2Loss", "L2Loss"), sensor=None):
    losses = [getattr(reg, name)(*LOSSES[name]) for name in kernels]
    return reg.TransformationEstimationForDopplerICP(*rules, *losses, np.eye(4) if sensor is None else sensor)


def doppler_of_open3d(o3d, rules, kernels=("L2Loss", "L2Loss"), sensor=None):
    losses = [tensor_kernel(o3d, name, *(LOSSES[name] or (1.0,))) for name in kernels]
    sensor = o3d.core.Tensor(np.eye(4) if sensor is None else sensor)
    return o3d.t.pipelines.registration.TransformationEstimationForDopplerICP(*rules, *losses, sensor)


DOPPLER = {
    "plain": ((0.1, 0.01, False, 2.0, 2, 0, 2), {}),
    "half and half": ((0.1, 0.5, False, 2.0, 2, 0, 2), {}),
    "outliers": ((0.1, 0.3, True, 2.0, 2, 0, 2), {}),
    "outliers at once": ((0.1, 0.3, True, 1.0, 0, 0, 2), {}),
    "kernels": ((0.1, 0.3, False, 2.0, 2, 0, 2), {"kernels": ("TukeyLoss", "TukeyLoss")}),
    "kernels late": ((0.1, 0.3, True, 2.0, 3, 2, 4), {"kernels": ("TukeyLoss", "TukeyLoss")}),
    "mounted": ((0.1, 0.3, False, 2.0, 2, 0, 2), {"sensor": as_pose([0, 0, 0.6], [0.5, -0.2, 0.1])}),
    "slower": ((0.25, 0.1, False, 2.0, 2, 0, 2), {}),
}


def steps_of_all(o3d, drive):
    points = drive.source.points
    ways = points / np.linalg.norm(points, axis=1, keepdims=True)
    source = tensor_cloud(o3d, drive.source, dopplers=drive.source["dopplers"].reshape(-1, 1), directions=ways)
    clouds = source, tensor_cloud(o3d, drive.target)
    methods = [doppler_of_open3d(o3d, rules, **options) for rules, options in DOPPLER.values()]
    return np.array([[tensor_after(o3d, clouds, method, n) for n in DOPPLER_STEPS] for method in methods])


@pytest.fixture(scope="module")
def answers(drive, oracle):
    """Open3D's pose for each case after each of DOPPLER_STEPS."""
    return dict(zip(DOPPLER, oracle("registration/estimation/doppler", steps_of_all, drive), strict=True))


@pytest.mark.parametrize("name", list(DOPPLER))
def test_doppler_steps_match_open3d(device, drive, answers, name, tolerances):
    rules, options = DOPPLER[name]
    for steps, expected in zip(DOPPLER_STEPS, answers[name], strict=True):
        result = result_after(device, drive, doppler_method(rules, **options), steps, degeneracy=0)
        np.testing.assert_allclose(result.transformation, expected, rtol=0, atol=tolerances.icp_pose_float32)


@pytest.mark.parametrize("fraction", [0.01, 0.9])
def test_the_weight_of_speeds_does_not_make_a_room_degenerate(device, drive, fraction, angle_between):
    """Rows of radial speeds are long, as they are divided by the period: they add no information to the walls'."""
    method = reg.TransformationEstimationForDopplerICP(0.1, fraction, True)
    result = result_after(device, drive, method, 12)
    assert len(result.degenerate_directions) == 0 and angle_between(result.transformation, drive.T) < 0.1


def test_doppler_resolves_motion_that_planes_cannot(device):
    """A tunnel: its walls do not constrain motion along it, radial speeds do."""
    rng = np.random.default_rng(5)

    def tunnel(count):
        angle, along = rng.uniform(0, 2 * np.pi, count), rng.uniform(-8, 8, count)
        radius = 2 + 0.3 * np.cos(2 * angle)
        return np.column_stack([along, radius * np.cos(angle), radius * np.sin(angle)])

    T = as_pose([0, 0, 0], [0.3, 0, 0])
    source = tunnel(3000) - T[:3, 3]
    speeds = (source / np.linalg.norm(source, axis=1, keepdims=True)) @ T[:3, 3] / 0.1
    scan = loom.PointCloud(source, dopplers=speeds, device=device)
    target = loom.PointCloud(tunnel(6000), device=device).estimate_normals(max_nn=20)
    rules = reg.ICPConvergenceCriteria(1e-9, 1e-9, 50)
    methods = (
        reg.TransformationEstimationForDopplerICP(lambda_doppler=0.1),
        reg.TransformationEstimationPointToPlane(),
    )
    results = (reg.registration_icp(scan, target, 1.0, None, method, rules) for method in methods)
    with_speeds, by_planes = (abs(result.transformation[0, 3] - 0.3) for result in results)
    assert with_speeds < 0.01 < 0.1 < by_planes


def test_a_robust_kernel_of_colored_icp_ignores_wrong_colors(rng):
    """A fifth of the points is black: the Tukey loss removes their photometric rows, as far ones with any color."""
    points = wavy(rng, 3000)
    paint = np.repeat(0.5 + 0.4 * np.sin(6 * points[:, :1]), 3, axis=1)
    target = loom.PointCloud(points, normals=wavy_normals(points), colors=paint)
    spoiled = paint.copy()
    spoiled[::5] = 0
    T = as_pose([0, 0, 0.01], [0.02, 0.01, 0.0])
    source = loom.PointCloud(back(points, T), colors=spoiled)
    rules, make = reg.ICPConvergenceCriteria(1e-10, 1e-10, 60), reg.TransformationEstimationForColoredICP
    errors = []
    for method in (make(0.5), make(0.5, kernel=reg.TukeyLoss(0.15))):
        result = reg.registration_icp(source, target, 0.1, None, method, rules)
        errors.append(np.abs(result.transformation - T).max())
    print(errors)
    assert errors[1] < 0.3 * errors[0]


@pytest.mark.parametrize("name", ["PointToPoint", "PointToPlane", "Symmetric", "ForGeneralizedICP", "ForColoredICP"])
def test_a_kernel_may_be_the_only_argument_of_an_estimator_as_in_open3d(name):
    make = getattr(reg, f"TransformationEstimation{name}")
    assert make(reg.TukeyLoss(0.1)) == make(kernel=reg.TukeyLoss(0.1)) != make()
    if name.startswith("For"):
        with pytest.raises(TypeError, match="expected a number, got TukeyLoss"):
            make(reg.TukeyLoss(0.1), kernel=reg.HuberLoss(0.1))


def test_a_robust_kernel_of_symmetric_icp_ignores_a_displaced_part(rng):
    """A fifth of the source is 2 cm above the surface. Both normals count: residuals are twice a distance."""
    points = wavy(rng, 3000)
    target = loom.PointCloud(points, normals=wavy_normals(points))
    T = as_pose([0, 0, 0.01], [0.02, 0.01, 0.0])
    displaced = points + [0, 0, 0.02] * (np.arange(len(points)) % 5 == 0)[:, None]
    source = loom.PointCloud(back(displaced, T), normals=wavy_normals(points) @ T[:3, :3])
    rules, make = reg.ICPConvergenceCriteria(1e-10, 1e-10, 60), reg.TransformationEstimationSymmetric
    errors = []
    for method in (make(), make(kernel=reg.TukeyLoss(0.02))):
        result = reg.registration_icp(source, target, 0.1, None, method, rules)
        errors.append(np.abs(result.transformation - T).max())
    assert errors[1] < 0.1 * errors[0], errors


def test_generalized_icp_with_isotropic_covariances_is_point_to_point(rng):
    """With epsilon = 1 each point has the identity as covariance."""
    source, target = noisy_pair(3)
    rules = reg.ICPConvergenceCriteria(1e-12, 1e-12, 60)
    generalized = reg.TransformationEstimationForGeneralizedICP
    results = [
        reg.registration_icp(source, target, 0.15, None, method, rules).transformation
        for method in (reg.TransformationEstimationPointToPoint(), generalized(epsilon=1.0), generalized())
    ]
    np.testing.assert_allclose(results[1], results[0], atol=1e-5)
    assert np.abs(results[2] - results[0]).max() > 1e-4
