"""Global registration of level clouds: the search keeps them level, and the report of `register_pair`."""

import numpy as np
import pytest

import pointloom as loom

from ..cli.surface_poses import bumpy, moved
from .poses import as_pose

reg = loom.registration
LEVEL = ("x", "y", "z", "yaw")
POSE = as_pose([0, 0, 2.0], [3.0, -2.0, 0.5])


@pytest.fixture(scope="module")
def points():
    return bumpy(np.random.default_rng(4))


def pair_of(points, T, device="cpu"):
    """Two parts of a surface with large overlap, the source moved back by a pose."""
    source, target = points[points[:, 0] > -0.5], points[points[:, 0] < 0.5]
    return [loom.PointCloud(p, device=device) for p in (moved(source, np.linalg.inv(T)), target)]


def test_a_level_search_gives_an_exactly_level_pose(device, points):
    clouds = pair_of(points, POSE, device)
    result = reg.register_globally(*clouds, voxel_size=0.06, free=LEVEL)
    assert (result.transformation[2, :3] == [0, 0, 1]).all() and (result.transformation[:2, 2] == 0).all()
    np.testing.assert_allclose(result.transformation, POSE, atol=0.02)
    assert result.converged and result.score > 0.5 and set(result.free) == set(LEVEL)
    all_six = reg.register_globally(*clouds, voxel_size=0.06, free=("roll", "pitch", *LEVEL))
    assert (all_six.transformation == reg.register_globally(*clouds, voxel_size=0.06).transformation).all()


def test_a_cloud_that_is_not_level_is_reported(points):
    """A source tilted by 40 degrees: no pose found by features is level, and none is forced to be."""
    result = reg.register_globally(*pair_of(points, as_pose([0.7, 0, 0])), voxel_size=0.06, free=LEVEL)
    assert not result.converged and result.score < 0.5
    assert "candidate poses tilt by 15 degrees or more" in result.warnings[0]


def test_a_level_pair_is_reported_as_such(points):
    result = reg.register_pair(*pair_of(points, POSE), voxel_size=0.06, free=LEVEL)
    assert (result.transformation[2, :3] == [0, 0, 1]).all() and result.reliable
    np.testing.assert_allclose(result.transformation, POSE, atol=0.01)
    assert set(result.to_dict()["free"]) == set(LEVEL) and "yaw, x, y, z" in str(result)
    plain = reg.register_pair(*pair_of(points, POSE), voxel_size=0.06)
    assert plain.to_dict()["free"] is None and " free" not in str(plain)


def test_a_prior_constrains_a_plane(rng):
    floor = np.column_stack([rng.uniform(-2, 2, (4000, 2)), rng.normal(0, 1e-3, 4000)])
    source, target = loom.PointCloud(floor - [0.1, 0, 0]), loom.PointCloud(floor)
    known = reg.Prior(as_pose([0, 0, 0], [0.1, 0, 0]), sigma_translation=0.05, sigma_rotation=0.01)
    result = reg.register_pair(source, target, init=np.eye(4), voxel_size=0.1, prior=known)
    np.testing.assert_allclose(result.transformation[:3, 3], [0.1, 0, 0], atol=0.01)
    assert len(result.to_dict()["prior_directions"]) == 3 and "3 of 6 motions" in str(result)
