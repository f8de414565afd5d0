"""ICP with selected degrees of freedom against known results of other libraries' tests and minimizers.

- PCL (BSD), test/registration/test_registration.cpp: bun0 onto bun4, 50 steps, mean squared distance below 0.001.
- PCL, test/registration/test_registration_api.cpp: TransformationEstimationPointToPlane(LLS) recovers the pose of
  a quadric of 21 x 21 points to 1e-3 per entry; its normals are not those of the surface.
- PCL's registration/warp_point_rigid_3d.h: x, y and the rotation about z, here minimized by SciPy.
- libpointmatcher (BSD), pointmatcher/ErrorMinimizers/PointToPlane.cpp: `force2D` and `force4DOF`, rows of
  (z x p) . n beside n, weighted; and the closed form of 2D and 4D point-to-point (Horn 1987 about one axis).

The reference solutions are written independently in NumPy.
"""

import numpy as np
import pytest
from scipy.spatial import cKDTree
from scipy.spatial.transform import Rotation

import pointloom as loom

from .icp_clouds import KINDS, PLANE, on
from .poses import as_pose, moved

reg = loom.registration
LONG = reg.ICPConvergenceCriteria(0, 0, 60)
PLANAR, LEVEL = ("x", "y", "yaw"), ("x", "y", "z", "yaw")
ALL = ("roll", "pitch", "yaw", "x", "y", "z")
QUADRIC_POSE = np.array(  # of PCL's test, rounded there to four digits
    [[0.9938, 0.0988, 0.0517, 0.1], [-0.0997, 0.9949, 0.0149, -0.2], [-0.05, -0.02, 0.9986, 0.3], [0, 0, 0, 1]]
)


def yawed(x, y, z, yaw):
    """The pose of PCL's WarpPointRigid3D, with a height."""
    T = np.eye(4)
    T[:2, :2] = [[np.cos(yaw), -np.sin(yaw)], [np.sin(yaw), np.cos(yaw)]]
    T[:3, 3] = x, y, z
    return T


def quadric():
    """PCL's test cloud: positions, and normals of another surface."""
    x, y = (grid.ravel() for grid in np.meshgrid(np.arange(-5, 5.1, 0.5), np.arange(-5, 5.1, 0.5), indexing="ij"))
    normals = np.column_stack([-0.2 * x - 0.2, 0.6 * y - 0.2, np.ones_like(x)])
    points = np.column_stack([x, y, 0.1 * x * x + 0.2 * x * y - 0.3 * y + 1])
    return points, normals / np.linalg.norm(normals, axis=1)[:, None]


@pytest.fixture(scope="module")
def bunny(shipped_file):
    """PCL's two scans, the second with normals of ten points."""
    source, target = (loom.read_point_cloud(shipped_file(f"pcl-tests/test/bun{k}.pcd")) for k in (0, 4))
    return source, target.estimate_normals(max_nn=10)


@pytest.fixture(scope="module")
def level_pair():
    """The quadric, a tenth denser than its copy, rotated about z and shifted, with noise; and weights."""
    rng = np.random.default_rng(4)
    points, normals = quadric()
    T = yawed(0.05, -0.04, 0.06, 0.02)
    target = loom.PointCloud(moved(points, T) + 0.01 * rng.normal(size=points.shape), normals=normals @ T[:3, :3].T)
    return loom.PointCloud(points), target, rng.uniform(0.1, 3.0, len(points))


def pairs_of(result):
    return np.asarray(result.correspondence_set).T


def mean_square(source, target, T):
    """PCL's getFitnessScore: the mean squared distance to the nearest point."""
    return float((cKDTree(target).query(moved(source, T))[0] ** 2).mean())


@pytest.mark.parametrize("free", [None, ALL])
@pytest.mark.parametrize("kind", ["point", "plane"])
def test_pcls_bunny_registers_as_in_pcls_test(device, bunny, kind, free):
    source, target = on(device, *bunny)
    rules = reg.ICPConvergenceCriteria(1e-8, 1e-8, 50)
    before = mean_square(source.points, target.points, np.eye(4))
    prior = None if free is None else reg.Prior(np.eye(4), sigma_translation=1e3)  # so that the other step runs
    bound = reg.Constraint(free, prior=prior)
    result = reg.registration_icp(source, target, 1.0, None, KINDS[kind], rules, constraint=bound)
    assert mean_square(source.points, target.points, result.transformation) < min(0.001, before / 2)


@pytest.mark.parametrize("shown", [QUADRIC_POSE, yawed(0.1, -0.2, 0.3, -0.1)], ids=["as PCL's", "level"])
def test_pcls_quadric_is_registered(device, shown):
    """With 6 DoF from PCL's pose, with 4 DoF from an untilted pose. PCL has given pairs; here the search starts at
    two thirds of the motion."""
    points, normals = quadric()
    T = shown.copy()
    u, _, v = np.linalg.svd(shown[:3, :3])
    T[:3, :3] = u @ v
    target = loom.PointCloud(moved(points, T), normals=normals @ T[:3, :3].T, device=device)
    init = as_pose(Rotation.from_matrix(T[:3, :3]).as_rotvec() * 2 / 3, T[:3, 3] * 2 / 3)
    free = ALL if shown is QUADRIC_POSE else LEVEL
    prior = reg.Prior(init, sigma_translation=1e4)
    bound, source = reg.Constraint(free, prior=prior), loom.PointCloud(points, device=device)
    result = reg.registration_icp(source, target, 1.0, init, PLANE, LONG, constraint=bound)
    np.testing.assert_allclose(result.transformation, shown, atol=1e-3)
    assert np.abs(result.transformation - init).max() > 0.03


def by_rows(source, target, normals, weights, motions):
    """libpointmatcher's minimizer, iterated on fixed pairs: weighted rows of (z x p) . n beside n."""
    T = np.eye(4)
    for _ in range(60):
        p = moved(source, T)
        rows = np.column_stack([p[:, 0] * normals[:, 1] - p[:, 1] * normals[:, 0], normals])[:, motions]
        r = ((p - target) * normals).sum(axis=1)
        x = np.zeros(4)
        x[motions] = np.linalg.solve(rows.T @ (weights[:, None] * rows), -rows.T @ (weights * r))
        T = yawed(*x[1:], x[0]) @ T
    return T


@pytest.mark.parametrize(("free", "motions"), [(LEVEL, [0, 1, 2, 3]), (PLANAR, [0, 1, 2])], ids=["4DOF", "2D"])
@pytest.mark.parametrize("weighted", [False, True])
def test_level_motions_match_libpointmatchers_weighted_point_to_plane(device, level_pair, free, motions, weighted):
    """`force4DOF`; and x, y, yaw of a 3D cloud, whose rows include the normals' heights that `force2D` drops."""
    source, target = on(device, *level_pair[:2])
    weights = level_pair[2] if weighted else np.ones(len(source))
    given = {"weights": weights} if weighted else {}
    bound = reg.Constraint(free)
    result = reg.registration_icp(source, target, 0.4, None, PLANE, LONG, constraint=bound, **given)
    i, j = pairs_of(result)
    wanted = by_rows(source.points[i], target.points[j], target.normals[j], weights[i], motions)
    np.testing.assert_allclose(result.transformation, wanted, atol=1e-7)
    if weighted:  # the height matters
        other = by_rows(source.points[i], target.points[j], target.normals[j], np.ones(len(i)), motions)
        assert np.abs(other - wanted).max() > 1e-5


def test_level_point_to_point_matches_the_closed_form(device, level_pair):
    """Horn 1987 about one axis: the angle from the sums of products about the means, as in PCL's 2D estimation."""
    source, target = on(device, *level_pair[:2])
    result = reg.registration_icp(source, target, 0.4, None, KINDS["point"], LONG, constraint=reg.Constraint(LEVEL))
    i, j = pairs_of(result)
    p, q = source.points[i], target.points[j]
    a, b = p - p.mean(axis=0), q - q.mean(axis=0)
    yaw = np.arctan2((a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum(), (a[:, :2] * b[:, :2]).sum())
    wanted = yawed(0, 0, 0, yaw)
    wanted[:3, 3] = q.mean(axis=0) - wanted[:3, :3] @ p.mean(axis=0)
    np.testing.assert_allclose(result.transformation, wanted, atol=1e-9)
    six = reg.registration_icp(source, target, 0.4, as_pose([0, 0, 0]), KINDS["point"], LONG).transformation
    assert np.abs(six - wanted).max() > 1e-5  # with six degrees of freedom it tilts with the noise
