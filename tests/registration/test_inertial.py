"""LiDAR odometry with an IMU: motion and deskewing by the gyroscope, its bias, gravity, gaps and clocks."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom
from pointloom.registration import LidarOdometry, LidarSLAM, leveled, run_odometry
from pointloom.registration.lidar.inertial import InertialTracker, integrate, rotation_path

from .inertial_drives import GRAVITY, Drive, growing, shake, stroll, surface_distances
from .poses import as_pose

OPTIONS = {"max_range": 30, "min_range": 0.3, "voxel_size": 0.3}


def follow(drive, readings=None, **options):
    odometry = LidarOdometry(**OPTIONS, **options)
    for scan in drive.scans:
        odometry.register(scan, imu=readings)
    return odometry


def readings_of(rates, forces=None, times=None, **pose):
    times = np.arange(len(rates)) / 200 if times is None else times
    return loom.ImuReadings(times, rates, np.tile(GRAVITY, (len(rates), 1)) if forces is None else forces, **pose)


@pytest.fixture(scope="module")
def shaken():
    return Drive(26, shake(150), stroll, bias=np.radians([0.5, -0.5, 0.5]), tilt=(4, -6, 0), start=1.7e9)


@pytest.fixture(scope="module")
def followed(shaken):
    return follow(shaken, shaken.readings)


@pytest.mark.slow
def test_a_shaken_scanner_is_followed_only_with_the_imu(shaken, followed):
    errors, alone = shaken.errors(followed), shaken.errors(follow(shaken))
    assert errors.rotation.max() < 0.5 and errors.position.max() < 0.04 and followed.summary.reliable
    assert alone.rotation.max() > 10 and alone.position.max() > 0.1
    assert followed.summary.without_imu == () and followed.summary.imu_differing == ()


def map_thickness(drive, readings=None):
    """90th percentile [m] of the distances of the map's points from the true surfaces."""
    slam = LidarSLAM(**OPTIONS)
    for scan in drive.scans:
        slam.register(scan, imu=readings)
    T = drive.poses[0]
    return np.percentile(surface_distances(slam.map.points @ T[:3, :3].T + T[:3, 3]), 90)


@pytest.mark.slow
def test_the_map_of_a_shaken_scanner_is_as_thin_as_that_of_a_smooth_path():
    smooth, shaken = Drive(16, positions=stroll), Drive(16, shake(250), stroll)
    thin = map_thickness(shaken, shaken.readings)
    assert thin < 1.3 * map_thickness(smooth) and thin < 0.2 * map_thickness(shaken)


def test_the_bias_is_estimated_and_the_world_is_leveled(shaken, followed):
    bias = np.degrees(followed._known.inertial.bias)
    np.testing.assert_allclose(bias, [0.5, -0.5, 0.5], atol=0.12)
    up = shaken.poses[0][:3, :3].T @ [0, 0, 1]
    assert np.degrees(np.arccos(followed.up @ up)) < 0.5
    level = leveled(None, followed.up)
    assert np.degrees(np.arccos((level[:3, :3] @ up)[2])) < 0.5


def test_turns_of_60_degrees_between_scans_are_followed():
    drive = Drive(16, lambda t: growing(t) * np.stack([np.radians(600) * t, 0 * t, 0 * t], 1), stroll)
    errors = drive.errors(follow(drive, drive.readings))
    assert errors.rotation.max() < 0.5 and errors.position.max() < 0.06


@pytest.mark.slow
def test_an_imu_at_rest_changes_nothing_material():
    drive = Drive(12, noise=1.0)
    with_imu, without = follow(drive, drive.readings), follow(drive)
    np.testing.assert_allclose(with_imu.poses, without.poses, atol=3e-3)
    assert with_imu.summary.reliable and np.degrees(np.arccos(with_imu.up[2])) < 0.3


@pytest.mark.slow
def test_a_rotated_imu_beside_the_scanner_needs_its_pose():
    T = as_pose(np.radians([180.0, 0.0, 30.0]), [0.3, -0.2, 0.1])
    drive = Drive(16, shake(100), stroll, T_sensor_imu=T)
    errors = drive.errors(follow(drive, drive.readings))
    assert errors.rotation.max() < 0.5 and errors.position.max() < 0.04
    readings = drive.readings
    wrong = loom.ImuReadings(readings.times, readings.angular_velocity, readings.linear_acceleration)
    assert "T_sensor_imu" in "".join(follow(drive, wrong).summary.warnings)


@pytest.mark.slow
def test_scans_without_readings_keep_the_velocity():
    drive = Drive(14, positions=stroll)
    keep = (drive.readings.times < 0.55) | (drive.readings.times > 0.72)
    parts = (getattr(drive.readings, name)[keep] for name in ("times", "angular_velocity", "linear_acceleration"))
    odometry = follow(drive, loom.ImuReadings(*parts))
    assert odometry.summary.without_imu == (5, 6, 7) and drive.errors(odometry).position.max() < 0.04


def test_live_readings_of_each_scan_give_the_same_poses(shaken, followed):
    odometry, times = LidarOdometry(**OPTIONS), shaken.readings.times
    for k, scan in enumerate(shaken.scans[:8]):
        new = slice(*np.searchsorted(times, 1.7e9 + 0.1 * k + np.array([-0.02, 0.12])))
        names = "times", "angular_velocity", "linear_acceleration"
        odometry.register(scan, imu=loom.ImuReadings(*(getattr(shaken.readings, name)[new] for name in names)))
    np.testing.assert_array_equal(odometry.poses, followed.poses[:8])


def test_times_of_scans_replace_point_times(shaken, followed):
    scans = [loom.PointCloud(scan.points, time=scan["time"] - scan["time"].min()) for scan in shaken.scans[:6]]
    ends = [scan["time"].max() for scan in shaken.scans[:6]]
    path = run_odometry(scans, imu=shaken.readings, timestamps=ends, **OPTIONS)
    np.testing.assert_allclose(path.poses, followed.poses[:6], atol=1e-4)
    assert path.timestamps.tolist() == ends
    bare = [loom.PointCloud(scan.points) for scan in shaken.scans[:3]]
    assert len(run_odometry(bare, imu=shaken.readings, timestamps=ends[:3], **OPTIONS)) == 3


def test_wrong_clocks_are_errors_that_name_the_argument(shaken):
    readings, scan = shaken.readings, shaken.scans[0]
    boot = loom.ImuReadings(readings.times - 1.7e9, readings.angular_velocity, readings.linear_acceleration)
    odometry = LidarOdometry(**OPTIONS)
    with pytest.raises(ValueError, match=r"^imu: .*1700000000\.1.*same clock"):
        odometry.register(scan, imu=boot)
    with pytest.raises(ValueError, match=r"^time: .*no point times"):
        odometry.register(loom.PointCloud(scan.points), imu=readings)
    with pytest.raises(ValueError, match=r"^timestamps: .*seconds"):
        odometry.register(loom.PointCloud(scan.points), scan["time"] * 1e3, imu=readings)
    with pytest.raises(ValueError, match=r"^timestamps: .*seconds"):  # milliseconds since the start
        odometry.register(loom.PointCloud(scan.points), (scan["time"] - 1.7e9) * 1e3, imu=boot)
    with pytest.raises(ValueError, match=r"^imu: .*none"):
        odometry.register(scan, imu=loom.ImuReadings([], np.zeros((0, 3)), np.zeros((0, 3))))
    with pytest.raises(TypeError, match=r"^imu: "):
        odometry.register(scan, imu=readings.angular_velocity)
    assert len(odometry.steps) == 0
    odometry.register(scan, imu=readings)
    with pytest.raises(ValueError, match=r"^time, timestamps: .*after"):
        odometry.register(scan, imu=readings)
    assert len(odometry.steps) == 1
    with pytest.raises(ValueError, match=r"^timestamps: .*2"):
        run_odometry(shaken.scans[:3], imu=readings, timestamps=[1.7e9, 1.7e9 + 0.1], **OPTIONS)


def test_readings_are_checked_and_immutable():
    times, zeros = np.arange(4.0), np.zeros((4, 3))
    for message, arguments in {
        "^times: .*decrease.*index 2": ([0, 2, 1, 3], zeros, zeros),
        "^times: .*finite": ([0, 1, np.nan, 3], zeros, zeros),
        "^times: .*Divide nanoseconds": (1.7e18 + times, zeros, zeros),
        "^times: .*float64": ((1.7e9 + times).astype(np.float32), zeros, zeros),
        "^times: .*shape": (zeros, zeros, zeros),
        "^angular_velocity: .*shape": (times, zeros[:3], zeros),
        "^linear_acceleration: .*NaN": (times, zeros, np.full((4, 3), np.inf)),
        "^orientation: .*shape": (times, zeros, zeros, zeros),
        "^T_sensor_imu: ": (times, zeros, zeros, None, 2 * np.eye(4)),
    }.items():
        with pytest.raises(ValueError, match=message):
            loom.ImuReadings(*arguments)
    readings = loom.ImuReadings(times, zeros, zeros)
    with pytest.raises(ValueError, match="read-only"):
        readings.times[0] = 1
    assert len(readings) == 4 and zeros.flags.writeable


@pytest.mark.parametrize("rate", [100, 400])
def test_integrals_follow_from_the_readings(rate):
    """A cone: the angular velocity rotates, so that the order of rotations matters."""
    times = np.arange(0, 1.0001, 1 / rate)

    def rotation(t):
        w = 2 * np.pi * 3 * t
        return Rotation.from_rotvec(np.stack([0.3 * np.cos(w), 0.3 * np.sin(w), 2 * t], axis=1))

    d = 1e-5
    rates = (rotation(times - d).inv() * rotation(times + d)).as_rotvec() / (2 * d)
    found = integrate(readings_of(rates, times=times), 0.2031, 0.9127, np.zeros(3))
    true = rotation(np.array([0.2031])).inv() * rotation(np.array([0.9127]))
    error = (Rotation.from_matrix(found.rotation) * true.inv()).magnitude().item()
    assert error < 50 / rate**2  # of second order
    b = np.array([1e-4, -2e-4, 3e-4])
    biased = integrate(readings_of(rates, times=times), 0.2031, 0.9127, b)
    moved = Rotation.from_matrix(found.rotation.T @ biased.rotation).as_rotvec()
    np.testing.assert_allclose(moved, -found.bias_jacobian @ b, atol=1e-7)
    path = rotation_path(readings_of(rates, times=times), 0.8127, 0.9127, np.zeros(3))
    wanted = rotation(np.array([0.9127])).inv() * rotation(np.linspace(0.8127, 0.9127, len(path)))
    np.testing.assert_allclose(path, wanted.as_rotvec(), atol=50 / rate**2)


def test_displacement_of_an_accelerated_rotating_sensor_is_exact():
    """From known velocity and gravity, the second integral gives the position."""
    drive = Drive(0, shake(200), stroll, beams=1, azimuths=1)
    times = np.arange(0.0, 3.0, 1 / 400)
    readings = drive.measure(times, (0, 0, 0), 0.0, np.random.default_rng(0))
    tracker = InertialTracker(gravity_sum=GRAVITY * 2, gravity_time=2.0)
    for k in range(12, 18):
        end = 0.1 * k
        motion = tracker.predict(readings, k, end - 0.1, end)
        if k > 13:
            true = np.linalg.inv(drive.matrix(end - 0.1)) @ drive.matrix(end)
            np.testing.assert_allclose(motion.motion, true, atol=2e-4)
            assert motion.part == pytest.approx(1.0)
        step = follow_step(k, drive.matrix(end))
        tracker = motion.after(step)
    np.testing.assert_allclose(tracker.gravity, GRAVITY, atol=0.01)


def follow_step(index, pose):
    from pointloom.registration.lidar.lidar_steps import OdometryStep

    return OdometryStep(index, pose, 1.0, 100, 1.0, 0.01, 5, converged=True, is_predicted=False, status="converged")


def test_missing_readings_have_no_integral():
    rates = np.zeros((100, 3))
    readings = readings_of(rates)  # up to 0.495 s
    assert integrate(readings, 0.1, 0.53, np.zeros(3)) is not None
    for start, end in ((0.1, 0.56), (-0.1, 0.2), (0.8, 0.82), (-1.0, -0.9)):
        assert integrate(readings, start, end, np.zeros(3)) is None
    rates[50] = np.nan
    assert integrate(readings_of(rates), 0.1, 0.4, np.zeros(3)) is None
    assert integrate(readings_of(np.zeros((2, 3)), times=np.array([0.0, 9.0])), 4.0, 4.04, np.zeros(3)) is None
    forces = np.full((100, 3), np.nan)
    assert integrate(readings_of(np.zeros((100, 3)), forces), 0.1, 0.4, np.zeros(3)).late is None
