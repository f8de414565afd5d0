"""Clouds that are level, registered from no start: a search that keeps them so, and what `register_pair` says of it."""

import numpy as np
import pytest

import pointloom as loom

from ..cli.surface_poses import bumpy, moved
from .poses import as_pose

reg = loom.registration
LEVEL = ("x", "y", "z", "yaw")
TURN = as_pose([0, 0, 2.0], [3.0, -2.0, 0.5])


@pytest.fixture(scope="module")
def points():
    return bumpy(np.random.default_rng(4))


def pair_of(points, T, device="cpu"):
    """Two parts of a surface that share most of it, the source moved back by a pose."""
    source, target = points[points[:, 0] > -0.5], points[points[:, 0] < 0.5]
    return [loom.PointCloud(p, device=device) for p in (moved(source, np.linalg.inv(T)), target)]


def test_a_search_among_level_poses_finds_one_that_is_level_to_the_bit(device, points):
    clouds = pair_of(points, TURN, device)
    result = reg.register_globally(*clouds, voxel_size=0.06, free=LEVEL)
    assert (result.transformation[2, :3] == [0, 0, 1]).all() and (result.transformation[:2, 2] == 0).all()
    np.testing.assert_allclose(result.transformation, TURN, atol=0.02)
    assert result.converged and result.score > 0.5 and set(result.free) == set(LEVEL)
    all_six = reg.register_globally(*clouds, voxel_size=0.06, free=("roll", "pitch", *LEVEL))
    assert (all_six.transformation == reg.register_globally(*clouds, voxel_size=0.06).transformation).all()


def test_a_cloud_that_is_not_level_is_told(points):
    """A source that hangs 40 degrees askew: no pose that features find is level, and none is made so."""
    result = reg.register_globally(*pair_of(points, as_pose([0.7, 0, 0])), voxel_size=0.06, free=LEVEL)
    assert not result.converged and result.score < 0.5
    assert "candidate poses tilt by 15 degrees or more" in result.warnings[0]


def test_a_pair_that_is_kept_level_says_so(points):
    found = reg.register_pair(*pair_of(points, TURN), voxel_size=0.06, free=LEVEL)
    assert (found.transformation[2, :3] == [0, 0, 1]).all() and found.reliable
    np.testing.assert_allclose(found.transformation, TURN, atol=0.01)
    assert set(found.to_dict()["free"]) == set(LEVEL) and "yaw, x, y, z" in str(found)
    plain = reg.register_pair(*pair_of(points, TURN), voxel_size=0.06)
    assert plain.to_dict()["free"] is None and " free" not in str(plain)


def test_a_plane_is_held_by_what_is_known_of_it(rng):
    floor = np.column_stack([rng.uniform(-2, 2, (4000, 2)), rng.normal(0, 1e-3, 4000)])
    source, target = loom.PointCloud(floor - [0.1, 0, 0]), loom.PointCloud(floor)
    known = reg.Prior(as_pose([0, 0, 0], [0.1, 0, 0]), sigma_translation=0.05, sigma_rotation=0.01)
    found = reg.register_pair(source, target, init=np.eye(4), voxel_size=0.1, prior=known)
    np.testing.assert_allclose(found.transformation[:3, 3], [0.1, 0, 0], atol=0.01)
    assert len(found.to_dict()["prior_directions"]) == 3 and "3 of 6 motions" in str(found)
