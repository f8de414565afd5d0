"""Localizability of each motion from two clouds: free motions are reported, weak constraints are not called free."""

import numpy as np
import pytest
from scipy.linalg import subspace_angles

import pointloom as loom

from .poses import as_pose
from .test_icp_degenerate import FREE, degenerate

reg = loom.registration
UTM = np.array([455_000.25, 5_420_000.5, 312.0])


def scans(shape, rng, *, noise=0.0, corner=(0.0, 0.0, 0.0), device="cpu", change=None):
    clouds = []
    for _ in range(2):
        points = degenerate(shape, rng, 12_000)[0]
        if change is not None:
            points = change(points)
        clouds.append(loom.PointCloud(points + noise * rng.normal(size=points.shape) + corner, device=device))
    return clouds


@pytest.mark.parametrize("shape", list(FREE))
def test_free_motions_match_the_shape_at_any_noise(device, shape, rng):
    for noise in (0.0, 0.02):
        result = reg.localizability(*scans(shape, rng, noise=noise, corner=UTM, device=device), np.eye(4), 0.25)
        assert len(result.open_motions) == len(FREE[shape]), (noise, str(result))
        assert (result.reliable) == (not len(FREE[shape]))
        if len(FREE[shape]):
            assert np.degrees(subspace_angles(result.open_motions.T, FREE[shape].T)).max() < 6
        np.testing.assert_allclose(result.motions @ result.motions.T, np.eye(6), atol=1e-9)
        assert np.abs(result.middle - UTM).max() < 0.5


def test_a_corridor_constrained_by_its_end_is_partially_localizable(rng):
    def with_end(points):
        points = points.copy()
        points[::60] = np.column_stack([rng.uniform(-0.5, 0.5, 200), np.full(200, 3.0), rng.uniform(-0.5, 0.5, 200)])
        return points

    result = reg.localizability(*scans("corridor", rng, noise=0.005, change=with_end), np.eye(4), 0.25)
    assert result.kinds == ("partial", *("full",) * 5) and result.reliable
    assert abs(result.motions[0, 4]) > 0.99


def test_a_prior_constrains_only_free_motions(rng):
    """Along the corridor the source follows odometry, across it the walls."""
    truth = as_pose([0.0, 0.0, 0.01], [0.02, 0.15, 0.0])
    source, target = scans("corridor", rng, noise=0.005)
    source = source.transform(np.linalg.inv(truth)).estimate_normals(max_nn=20)
    target = target.estimate_normals(max_nn=20)
    first = reg.registration_icp(source, target, 0.25, None, reg.TransformationEstimationPointToPlane())
    actual = reg.localizability(source, target, first.transformation, 0.25)
    assert actual.translations == pytest.approx(np.array([[0.0, 1.0, 0.0]]), abs=0.02)
    odometry = as_pose([0.0, 0.0, 0.03], [0.1, 0.15, 0.05])  # correct along the corridor, wrong across it
    result = reg.registration_icp(
        source, target, 0.25, first.transformation, reg.TransformationEstimationPointToPlane(),
        prior=actual.prior(odometry, 0.01), pivot=actual.middle, degeneracy=0,
    )  # fmt: skip
    off = np.abs(result.transformation - truth)
    assert off[1, 3] < 0.02 and off[[0, 2], 3].max() < 0.01 and off[:3, :3].max() < 0.005
    assert abs(first.transformation[1, 3] - 0.15) > 0.1
    surface = reg.localizability(*scans("surface", rng), np.eye(4), 0.2)
    with pytest.raises(ValueError, match=r"^prior:"):
        surface.prior(np.eye(4), 0.1)


def test_disjoint_clouds_constrain_nothing():
    cube = loom.PointCloud(np.random.default_rng(0).uniform(size=(3000, 3)))
    far = reg.localizability(cube, cube.translate([50, 0, 0]), np.eye(4), 0.1)
    assert far.kinds == ("none",) * 6 and "no surface" in str(far.warnings)
    empty = reg.localizability(loom.PointCloud(), cube, np.eye(4), 0.1)
    assert empty.kinds == ("none",) * 6
