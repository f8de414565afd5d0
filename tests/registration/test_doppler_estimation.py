"""The Doppler estimator takes Open3D's steps and resolves motions that planes cannot."""

from types import SimpleNamespace

import numpy as np
import pytest

import pointloom as loom

from .estimator_steps import result_after, tensor_after, tensor_cloud, tensor_kernel
from .poses import as_pose

reg = loom.registration
STEPS = (20, 40)


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


def theirs(o3d, rules, kernels=("L2Loss", "L2Loss"), sensor=None):
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
    methods = [theirs(o3d, rules, **options) for rules, options in DOPPLER.values()]
    return np.array([[tensor_after(o3d, clouds, method, n) for n in STEPS] for method in methods])


@pytest.fixture(scope="module")
def answers(drive, oracle):
    """Open3D's pose for each case after each of STEPS."""
    return dict(zip(DOPPLER, oracle("registration/estimation/doppler", steps_of_all, drive), strict=True))


@pytest.mark.parametrize("name", list(DOPPLER))
def test_doppler_steps_match_open3d(device, drive, answers, name, tolerances):
    rules, options = DOPPLER[name]
    for steps, expected in zip(STEPS, answers[name], strict=True):
        result = result_after(device, drive, doppler_method(rules, **options), steps, degeneracy=0)
        np.testing.assert_allclose(result.transformation, expected, rtol=0, atol=tolerances.icp_pose_float32)


@pytest.mark.parametrize("share", [0.01, 0.9])
def test_the_weight_of_speeds_does_not_make_a_room_degenerate(device, drive, share, angle_between):
    """Rows of radial speeds are long, as they are divided by the period: they add no information to the walls'."""
    method = reg.TransformationEstimationForDopplerICP(0.1, share, True)
    result = result_after(device, drive, method, 12)
    assert len(result.degenerate_directions) == 0
    assert angle_between(result.transformation, drive.T) < 0.1


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
    method = reg.TransformationEstimationForDopplerICP(lambda_doppler=0.1)
    transformation = reg.registration_icp(scan, target, 1.0, None, method, rules).transformation
    planes = reg.registration_icp(
        scan, target, 1.0, None, reg.TransformationEstimationPointToPlane(), rules
    ).transformation
    assert abs(transformation[0, 3] - 0.3) < 0.01 < 0.1 < abs(planes[0, 3] - 0.3)
