"""Deskewed scans of a moving scanner against explicit motion."""

from functools import partial
from types import SimpleNamespace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from scipy.linalg import expm, logm
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.core.devices import resolve_device
from pointloom.kernels.lang import float64, vec3
from pointloom.kernels.memory import download, upload
from pointloom.kernels.odometry.deskewing import bound_times, deskew_along_path
from pointloom.registration import deskew_point_cloud
from pointloom.registration.lidar.deskewing import SMALL_ANGLE, point_times, twist_of
from pointloom.registration.lidar.raw_scan import part_of_interval
from pointloom.registration.rigid import pose_of, rotation_vector

from .poses import as_pose

small = st.floats(-1.5, 1.5, allow_subnormal=False)


def generator(twist) -> np.ndarray:
    x, y, z, *v = twist
    G = np.zeros((4, 4))
    G[:3, :3], G[:3, 3] = [[0, -z, y], [z, 0, -x], [-y, x, 0]], v
    return G


def skew_scan(world, twist, fractions) -> np.ndarray:
    """Points [n, 3] as seen by a sensor at exp(share * twist)."""
    seen = [np.linalg.inv(expm(s * generator(twist))) @ [*p, 1] for s, p in zip(fractions, world, strict=True)]
    return np.array(seen).reshape(-1, 4)[:, :3]


@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.tuples(*[small] * 6), st.floats(1e-3, 1e9), st.floats(-1e6, 1e6), st.integers(2, 9))
def test_a_scan_is_deskewed_to_its_end(device, tolerances, twist, unit, start, count):
    rng = np.random.default_rng(count)
    fractions = np.linspace(0, 1, count)[rng.permutation(count)]
    world = rng.uniform(-60, 60, (count, 3))
    scan = loom.PointCloud(skew_scan(world, twist, fractions), device=device)
    T = expm(generator(twist))
    deskewed = deskew_point_cloud(scan, T, start + fractions * unit)
    expected = (world - T[:3, 3]) @ T[:3, :3]
    rounding = 200 * np.spacing(abs(start) + unit) / unit  # of the absolute times
    np.testing.assert_allclose(deskewed.points, expected, atol=tolerances.deskew + rounding)


@pytest.mark.parametrize("angle", [0.0, 1e-7, 1e-5, 1.0, 3.0])
def test_a_twist_is_the_logarithm_of_a_pose(angle):
    twist = np.array([0.6 * angle, -0.8 * angle, 0.0, 1.0, 2.0, -3.0])
    np.testing.assert_allclose(twist_of(pose_of(twist)), twist, atol=1e-8)
    if angle > 1e-3:
        G = np.real(logm(pose_of(twist)))
        np.testing.assert_allclose(twist_of(pose_of(twist))[3:], G[:3, 3], atol=1e-8)


def test_a_twist_with_long_translation_and_small_rotation_is_exact():
    """Just below the angle of the series expansion; its second term is 2 micrometers here."""
    for angle in (0.9 * SMALL_ANGLE, 1.1 * SMALL_ANGLE):
        twist = np.array([0.6 * angle, -0.8 * angle, 0.0, 1000.0, 2000.0, -3000.0])
        np.testing.assert_allclose(twist_of(pose_of(twist)), twist, rtol=0, atol=1e-7)


@pytest.mark.parametrize("gap", [1e-7, 1e-8, 2e-6, 1e-3])
def test_a_rotation_just_below_180_degrees_keeps_its_axis_and_sign(rng, gap):
    axes = np.concatenate([rng.normal(size=(50, 3)), np.eye(3), -np.eye(3)])
    for vector in axes / np.linalg.norm(axes, axis=1, keepdims=True) * (np.pi - gap):
        np.testing.assert_allclose(rotation_vector(Rotation.from_rotvec(vector).as_matrix()), vector, atol=1e-8)


@pytest.mark.parametrize(
    ("sweep", "interval", "expected"),
    [(180, None, 0.5), (-90, None, 0.25), (359, None, 1.0), (0, None, 1.0), (180, 0.2, 0.25), (359, 0.1, 0.5)],
)
def test_the_interval_can_be_longer_than_the_scan(device, rng, sweep, interval, expected):
    """From the visible part of a revolution of the sensor, unless the interval is given; beams differ by 5 degrees."""
    fraction = np.sort(rng.random(2000))
    azimuth = np.radians(sweep * fraction - 50 + rng.choice([-2.5, 2.5], 2000)) if sweep else rng.uniform(0, 6.28, 2000)
    points = rng.uniform(5, 50, (2000, 1)) * np.c_[np.cos(azimuth), np.sin(azimuth), rng.uniform(-0.3, 0.3, 2000)]
    points[::7] = np.nan
    cloud, order = loom.PointCloud(points, device=device), rng.permutation(2000)
    cloud, times = cloud.select_by_index(order), (100 + 0.05 * fraction)[order]
    part = part_of_interval(cloud.arrays["points"], point_times(cloud, times), cloud.origin, interval)
    assert part == pytest.approx(expected, rel=0.03)


STEPS = np.arange(50) / 500  # [s] a scan of 0.1 s


@pytest.mark.parametrize("times", [np.zeros(50), np.full(50, 1.7e9), np.float32(np.full(50, 99))])
def test_times_without_effect_are_reported(device, rng, times):
    scan = loom.PointCloud(rng.uniform(5, 9, (50, 3)), device=device)
    with pytest.warns(UserWarning, match=r"^timestamps:.*50.*1"):
        deskew_point_cloud(scan, np.eye(4), times)
    with pytest.warns(UserWarning, match=r"^timestamps: "):
        loom.registration.LidarOdometry(min_range=1.0, device=device).register(scan, times)


@pytest.mark.parametrize("unit", [1, 1e3, 1e6, 1e9])
@pytest.mark.parametrize("start", [1.7e9, 1_700_000_063.95, 604_799.0])
@pytest.mark.parametrize("kind", ["attribute", "argument", "argument in float64"])
def test_times_that_float32_does_not_resolve_are_rejected(device, rng, start, unit, kind):
    scan = loom.PointCloud(rng.uniform(5, 9, (50, 3)), device=device)
    times = ((start + STEPS) * unit).astype(np.float32)
    if kind == "attribute":
        scan, times = loom.PointCloud(scan.points, t=times, device=device), None
    elif times.dtype == np.float32 and kind == "argument in float64":
        times = times.astype(np.float64)
        if len(np.unique(times)) == 1:  # could as well be one time of the scan
            return
    for interval in (None, 0.1):
        odometry = loom.registration.LidarOdometry(min_range=1.0, interval=interval, device=device)
        for call in (partial(deskew_point_cloud, scan, np.eye(4), times), partial(odometry.register, scan, times)):
            with pytest.raises(ValueError, match=r"^timestamps: expected times in float64, got float32 numbers up to"):
                call()


@pytest.mark.parametrize("start", [0.0, 100.0, 1.7e9])
@pytest.mark.parametrize("unit", [1, 1e3, 1e9])
@pytest.mark.parametrize("kind", [np.float32, np.float64, np.int64])
@pytest.mark.filterwarnings("error")
def test_times_that_resolve_the_scan_are_accepted_in_any_unit(device, rng, start, unit, kind):
    if (kind == np.float32 and start > 100) or (kind == np.int64 and unit == 1):
        start, unit = 0.0, 1e9
    scan = loom.PointCloud(rng.uniform(5, 9, (50, 3)), device=device)
    times, T = (np.rint((start + STEPS) * unit) if kind == np.int64 else (start + STEPS) * unit).astype(kind), np.eye(4)
    T[0, 3] = 1.0
    exact = deskew_point_cloud(scan, T, STEPS)
    np.testing.assert_allclose(deskew_point_cloud(scan, T, times).points, exact.points, rtol=0, atol=0.02)


def test_seconds_in_float32_are_rejected_if_they_are_too_coarse():
    poses, epoch = np.tile(np.eye(4), (3, 1, 1)), np.float32(1.7e9 + np.arange(3))
    camera = loom.PinholeCameraIntrinsic(4, 3, 5, 5, 2, 1)
    frame = SimpleNamespace(color=None, depth=np.ones((3, 4), np.float32), timestamp=epoch[0])
    wall = loom.PointCloud(np.random.default_rng(0).random((50, 3)))
    for name, call in (
        ("timestamps", lambda: loom.Trajectory(poses, epoch)),
        ("timestamps", lambda: loom.registration.run_odometry([wall] * 3, timestamps=epoch)),
        ("frame-000000: timestamp", lambda: next(iter(loom.frames_from([frame], camera)))),
        ("timestamp", lambda: loom.rgbd.DenseSLAM(camera, voxel_size=0.1).step(frame)),
    ):
        with pytest.raises(ValueError, match=f"{name}: expected times in float64, got float32"):
            call()
    assert loom.Trajectory(poses, np.float32([1e5, 1e5 + 1, 1e5 + 2])).timestamps[1] == 1e5 + 1
    assert loom.Trajectory(poses, epoch.astype(np.float64)).timestamps.dtype == np.float64


def test_attributes_and_order_are_preserved(device):
    T = as_pose(shift=[2.0, 0, 0])
    scan = loom.PointCloud(
        [[1, 0, 0], [np.nan, 0, 0], [3, 0, 0], [4, 0, 0]],
        t=np.array([0, 0, 1, 2], np.uint32), intensity=[1, 2, 3, 4.0], device=device,
    )  # fmt: skip
    scan.grid = (2, 2)
    moved = deskew_point_cloud(scan, T)
    np.testing.assert_allclose(moved.points[:, 0], [-1, np.nan, 2, 4], atol=1e-6)
    assert moved["intensity"].tolist() == [1, 2, 3, 4] and moved.grid == (2, 2)
    np.testing.assert_allclose(scan.points[:, 0], [1, np.nan, 3, 4])


def test_invalid_points_do_not_define_the_time_range(device):
    T = as_pose(shift=[1.0, 0, 0])
    scan = loom.PointCloud([[0, 0, 0], [5, 0, 0], [np.nan, 0, 0], [5, 0, 0], [5, 0, 0]], device=device)
    moved = deskew_point_cloud(scan, T, [-100.0, 10.0, 1e9, 12.0, np.nan])
    np.testing.assert_allclose(moved.points[[1, 3], 0], [4, 5], atol=1e-6)
    assert np.isnan(moved.points[4]).all()


@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(hnp.arrays(np.float64, st.integers(0, 3), elements=st.just(3.0)))
def test_equal_times_and_empty_scans_are_unchanged(device, times):
    points = np.arange(3.0 * len(times)).reshape(-1, 3)
    T = as_pose(shift=[0, 5.0, 0])
    np.testing.assert_array_equal(deskew_point_cloud(loom.PointCloud(points, device=device), T, times).points, points)


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_non_finite_times_do_not_end_the_scan(device, value):
    scan = loom.PointCloud(np.arange(12.0).reshape(4, 3) + 1, device=device)
    T = as_pose(shift=[1.0, 0, 0])
    result = deskew_point_cloud(scan, T, [value, 5.0, 5.0, value]).points  # one finite time
    np.testing.assert_array_equal(np.isnan(result).any(axis=1), [True, False, False, True])
    with pytest.raises(ValueError, match="timestamps:"):
        deskew_point_cloud(scan, T, np.full(4, value))


@pytest.mark.parametrize("size", [0.0, 1e-5, 0.5])
def test_points_follow_rotations_between_steps(device, size):
    """Each point by the exponential of the rotation vector between two steps and its fraction of the velocity."""
    device, rng = resolve_device(device), np.random.default_rng(4)
    fractions, p = rng.permutation(np.linspace(-1, 0, 41)), rng.uniform(-30, 30, (42, 3)).astype(np.float32)
    rotations, velocity = size * rng.normal(size=(9, 3)), np.array([0.7, -0.4, 0.2])
    points, times = upload(p, vec3, device), upload(np.append(5 + 0.1 * fractions, np.nan), float64, device)
    moved = download(deskew_along_path(points, times, np.ones(3), bound_times(points, times), rotations, velocity))
    for i, fraction in enumerate(fractions):
        vector = [np.interp(fraction, np.linspace(-1, 0, 9), column) for column in rotations.T]
        expected = expm(generator([*vector, *(fraction * velocity)])) @ [*(p[i] + 1), 1]
        np.testing.assert_allclose(moved[i], expected[:3], atol=3e-5)
    assert np.isnan(moved[-1]).all()


def test_normals_are_deskewed_with_their_points(device, rng):
    """The tips of the normals, deskewed as points, are the tips of the deskewed normals."""
    points, normals, times = rng.uniform(-20, 20, (50, 3)), rng.normal(size=(50, 3)), rng.random(50)
    times[:2], normals = (0, 1), normals / np.linalg.norm(normals, axis=1, keepdims=True)
    T = expm(generator([0.3, -0.2, 0.9, 2, 1, -1]))
    scan = loom.PointCloud(points, normals=normals, time=times, device=device)
    deskewed, tips = (
        deskew_point_cloud(one, T) for one in (scan, loom.PointCloud(points + normals, time=times, device=device))
    )
    np.testing.assert_allclose(deskewed.normals, tips.points - deskewed.points, atol=2e-5)
    assert abs(deskewed.normals - normals).max() > 0.1
