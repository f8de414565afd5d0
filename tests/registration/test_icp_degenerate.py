"""Motions that the clouds do not constrain are reported and excluded from the steps."""

import numpy as np
import pytest
from scipy.linalg import subspace_angles
from scipy.spatial.transform import Rotation

import pointloom as loom

from ..products import each_pair
from .icp_clouds import KINDS, PLANE, assert_rigid, back, wavy, wavy_normals
from .poses import as_pose

reg = loom.registration

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


@pytest.mark.parametrize(
    **each_pair(
        shape=list(FREE), noise=["exact", "estimated", "noisy"], kind=["plane", "symmetric", "generalized", "robust"]
    )
)
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
