"""Level ICP on real scans: a street, and an airborne survey at its own coordinates."""

import numpy as np

import pointloom as loom
from pointloom.registration.icp.leveling import leveled

from .poses import as_pose

reg = loom.registration
LEVEL = ("x", "y", "z", "yaw")
GENERALIZED = reg.TransformationEstimationForGeneralizedICP()
PLANE = reg.TransformationEstimationPointToPlane()


def thinned(points, size, device):
    return loom.PointCloud(points, device=device).voxel_down_sample(size).estimate_normals(max_nn=10)


def test_a_level_street_is_registered_with_four_degrees_of_freedom(device, street_pair, angle_between):
    """The truth tilts by 0.16 degrees. Six degrees of freedom end 0.66 degrees and 1.0 cm off, four 0.23 and 1.5."""
    source, target = (thinned(p, 0.4, device) for p in (street_pair.source, street_pair.target))
    rules = reg.ICPConvergenceCriteria(1e-6, 1e-6, 50)
    free, level = (
        reg.registration_icp(source, target, 1.0, None, GENERALIZED, rules, free=f).transformation
        for f in (None, LEVEL)
    )
    assert (level[2, :3] == [0, 0, 1]).all() and (level[:2, 2] == 0).all()  # exactly level
    assert angle_between(level, street_pair.T) < min(0.4, angle_between(free, street_pair.T) + 0.05)
    assert np.linalg.norm((level - street_pair.T)[:3, 3]) < 0.05
    assert np.linalg.norm((level - free)[:3, 3]) < 0.05


def test_a_tilted_street_is_registered_after_leveling_by_gravity(device, street_pair, angle_between):
    """The sensor is tilted by 10 degrees; the accelerometer provides the tilt, and four degrees of freedom the rest."""
    askew = as_pose([0.15, -0.1, 0])
    source = thinned((street_pair.source - askew[:3, 3]) @ askew[:3, :3], 0.4, device)
    target = thinned(street_pair.target, 0.4, device)
    init = leveled(None, up_in_source=askew[:3, :3].T @ [0, 0, 9.81])
    transformation = reg.registration_icp(source, target, 1.0, init, GENERALIZED, free=LEVEL).transformation
    assert angle_between(transformation, street_pair.T @ askew) < 0.4
    up = transformation[:3, :3] @ askew[:3, :3].T @ [0, 0, 1]
    np.testing.assert_allclose(up, [0, 0, 1], atol=1e-12)
    tilted = reg.registration_icp(source, target, 1.0, None, GENERALIZED, free=LEVEL)
    assert angle_between(tilted.transformation, street_pair.T @ askew) > 8  # a wrong gravity stays in the pose


def test_an_airborne_survey_stays_level_at_its_coordinates(device, real_file):
    """Half of the points against the others, shifted and rotated: feet, 640 km from zero."""
    points = loom.read_point_cloud(real_file("lidar-pdal/laz/autzen_trim.laz")).points
    half, middle = np.random.default_rng(0).random(len(points)) < 0.5, points.mean(axis=0)
    T = as_pose([0, 0, 0.026])
    T[:3, 3] = middle - T[:3, :3] @ middle + [1.5, -1.0, 0.7]
    source = thinned((points[half] - T[:3, 3]) @ T[:3, :3], 8, device)
    target = thinned(points[~half], 8, device)
    result = reg.registration_icp(source, target, 20.0, None, PLANE, free=LEVEL)
    M = result.transformation
    assert (M[2, :3] == [0, 0, 1]).all() and (M[:2, 2] == 0).all() and result.converged
    point = np.linalg.solve(T, [*middle, 1])
    assert np.abs((M @ point)[:3] - middle).max() < 0.6  # a tenth of a voxel
    rail = reg.registration_icp(source, target, 20.0, T, PLANE, free=("z",)).transformation
    assert np.abs(rail[:2, 3] - T[:2, 3]).max() < 1e-12 * np.abs(T).max() and abs(rail[2, 3] - T[2, 3]) < 0.2
