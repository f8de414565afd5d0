"""register_pair: its steps, its report, rejected clouds, and pairs that stay level."""

import re

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.voxel_size import choose_voxel_size

from ..cli.surface_poses import NEAR, POSE, bumpy, colors_at, moved
from .poses import as_pose

reg = loom.registration
PLANE = reg.TransformationEstimationPointToPlane()


@pytest.fixture
def pair(rng, device):
    """A surface sampled twice, the first under NEAR's inverse, with colors."""
    points, others = bumpy(rng), bumpy(rng)
    source = loom.PointCloud(moved(points, np.linalg.inv(NEAR)), colors=colors_at(points), device=device)
    return source, loom.PointCloud(others, colors=colors_at(others), device=device)


def test_a_given_initial_pose_is_refined_on_three_scales(pair):
    result = reg.register_pair(*pair, init=np.eye(4), voxel_size=0.06)
    sizes, limits = [0.24, 0.12, 0.06], [0.48, 0.24, 0.12]
    rules = [reg.ICPConvergenceCriteria()] * 3
    plain = reg.multi_scale_icp(*pair, sizes, rules, limits, None, PLANE, estimate_normals=True)
    np.testing.assert_array_equal(result.transformation, plain.transformation)
    assert (result.result.iterations, result.init) == (plain.iterations, "given")
    assert result.max_correspondence_distance == 0.12
    assert result.score == reg.assess_registration(*pair, plain.transformation, 1.5 * 0.06).score > 0.5
    assert result.assessment.score == result.score and result.assessment is result.assessment
    np.testing.assert_allclose(result.transformation, NEAR, atol=0.01)
    assert result.reliable


METHODS = {
    "point-to-point": reg.TransformationEstimationPointToPoint(),
    "symmetric": reg.TransformationEstimationSymmetric(),
    "generalized": reg.TransformationEstimationForGeneralizedICP(),
    "colored": reg.TransformationEstimationForColoredICP(),
}


@pytest.mark.parametrize("method", METHODS)
def test_each_method_refines_within_the_requested_distance(pair, method):
    distance = 0.15
    result = reg.register_pair(*pair, init=NEAR, voxel_size=0.12, method=method, max_correspondence_distance=distance)
    rules = [reg.ICPConvergenceCriteria()]
    plain = reg.multi_scale_icp(*pair, [0.12], rules, [distance], NEAR, METHODS[method], estimate_normals=True)
    np.testing.assert_array_equal(result.transformation, plain.transformation)
    assert result.method == method and result.max_correspondence_distance == distance


def test_pairs_farther_than_the_requested_distance_are_not_used(pair):
    away = as_pose(shift=[0, 0, 0.3]) @ NEAR
    near, far = (reg.register_pair(*pair, init=away, voxel_size=0.1, method="point-to-point",
                                   max_correspondence_distance=distance) for distance in (0.1, 1.0))  # fmt: skip
    np.testing.assert_allclose(near.transformation, away)
    assert abs(far.transformation[2, 3] - NEAR[2, 3]) < 0.01


def test_without_an_initial_pose_it_searches_globally(rng):
    points = bumpy(rng)
    source = loom.PointCloud(moved(points[points[:, 0] > -0.4], np.linalg.inv(POSE)))
    target = loom.PointCloud(points[points[:, 0] < 0.4])
    result = reg.register_pair(source, target, voxel_size=0.06)
    np.testing.assert_allclose(result.transformation, POSE, atol=0.01)
    start = reg.register_globally(source, target, voxel_size=0.06)
    thin = [cloud.voxel_down_sample(0.06) for cloud in (source, target)]
    thin[1] = thin[1].estimate_normals(radius=3 * 0.06, max_nn=30)
    plain = reg.registration_icp(*thin, 0.12, start.transformation, PLANE)
    np.testing.assert_array_equal(result.transformation, plain.transformation)
    assert result.init == "global" and result.thinned == tuple(map(len, thin))


def test_normals_are_estimated_only_for_clouds_without_them(pair):
    source, target = pair
    with_normals = target.estimate_normals(max_nn=8)
    rules = [reg.ICPConvergenceCriteria(max_iteration=4)]
    for cloud, estimated in ((target, ("target",)), (with_normals, ())):
        assert reg.register_pair(source, cloud, init=np.eye(4), voxel_size=0.1).normals_estimated == estimated
    given = source, with_normals, [0.1], rules, [0.2], None, PLANE
    results = [reg.multi_scale_icp(*given, estimate_normals=wanted) for wanted in (False, True)]
    np.testing.assert_array_equal(results[0].transformation, results[1].transformation)
    with pytest.raises(ValueError, match="target:"):
        reg.multi_scale_icp(source, target, [0.1], rules, [0.2], None, PLANE)
    result = reg.multi_scale_icp(source, target, [-1], rules, [0.2], None, PLANE, estimate_normals=True)
    plain = reg.registration_icp(source, target.estimate_normals(max_nn=30), 0.2, None, PLANE, rules[0])
    np.testing.assert_array_equal(result.transformation, plain.transformation)


def test_the_number_of_voxels_that_the_error_names_is_enough():
    cloud = loom.PointCloud(0.1 * np.argwhere(np.ones((5, 5, 2))))  # one point per voxel
    with pytest.raises(ValueError, match=r"source: has points in 2 voxels of 0\.1 m") as caught:
        reg.register_pair(cloud.select_by_index([0, 1]), cloud, init=np.eye(4), voxel_size=0.1)
    (needed,) = re.findall(r"and (\d+) are needed", str(caught.value))
    few = cloud.select_by_index(range(int(needed)))
    assert reg.register_pair(few, cloud, init=np.eye(4), voxel_size=0.1).thinned == (len(few), 50)


def test_stages_and_results_are_reported(pair):
    stages = []
    result = reg.register_pair(*pair, progress=lambda stage, done, total: stages.append((stage, done, total)))
    assert stages == [("voxels", 0, 0), ("search", 0, 0), ("refine", 0, 0), ("rate", 0, 0)]
    assert result.voxel_size == choose_voxel_size(*pair) and not result.voxel_size_given
    report = result.to_dict()
    assert report["transformation"] == result.transformation.tolist()
    assert report["points"] == {"source": len(pair[0]), "target": len(pair[1])}
    assert f"{result.transformation[1, 3]:.9f}" in str(result) and "chosen from the clouds" in str(result)


def test_a_pose_without_correspondences_is_unreliable(pair):
    result = reg.register_pair(*pair, init=as_pose(shift=[1000, 0, 0]), voxel_size=0.06)
    assert result.warnings == ("no point of the source has a correspondence",)


def test_coincident_points_have_a_voxel_size_of_one():
    assert choose_voxel_size(loom.PointCloud(np.ones((50, 3)))) == 1


LEVEL = ("x", "y", "z", "yaw")
LEVEL_POSE = as_pose([0, 0, 2.0], [3.0, -2.0, 0.5])


@pytest.fixture(scope="module")
def points():
    return bumpy(np.random.default_rng(4))


def pair_of(points, T, device="cpu"):
    """Two parts of a surface with large overlap, the source moved back by a pose."""
    source, target = points[points[:, 0] > -0.5], points[points[:, 0] < 0.5]
    return [loom.PointCloud(p, device=device) for p in (moved(source, np.linalg.inv(T)), target)]


def test_a_level_search_gives_an_exactly_level_pose(device, points):
    clouds = pair_of(points, LEVEL_POSE, device)
    result = reg.register_globally(*clouds, voxel_size=0.06, free=LEVEL)
    assert (result.transformation[2, :3] == [0, 0, 1]).all() and (result.transformation[:2, 2] == 0).all()
    np.testing.assert_allclose(result.transformation, LEVEL_POSE, atol=0.02)
    assert result.converged and result.score > 0.5 and set(result.free) == set(LEVEL)
    all_six = reg.register_globally(*clouds, voxel_size=0.06, free=("roll", "pitch", *LEVEL))
    assert (all_six.transformation == reg.register_globally(*clouds, voxel_size=0.06).transformation).all()


def test_a_cloud_that_is_not_level_is_reported(points):
    """A source tilted by 40 degrees: no pose found by features is level, and none is forced to be."""
    result = reg.register_globally(*pair_of(points, as_pose([0.7, 0, 0])), voxel_size=0.06, free=LEVEL)
    assert not result.converged and result.score < 0.5
    assert "candidate poses tilt by 15 degrees or more" in result.warnings[0]


def test_a_level_pair_is_reported_as_such(points):
    result = reg.register_pair(*pair_of(points, LEVEL_POSE), voxel_size=0.06, constraint=reg.Constraint(LEVEL))
    assert (result.transformation[2, :3] == [0, 0, 1]).all() and result.reliable
    np.testing.assert_allclose(result.transformation, LEVEL_POSE, atol=0.01)
    assert set(result.to_dict()["free"]) == set(LEVEL) and "yaw, x, y, z" in str(result)
    plain = reg.register_pair(*pair_of(points, LEVEL_POSE), voxel_size=0.06)
    assert plain.to_dict()["free"] is None and " free" not in str(plain)


def test_a_prior_constrains_a_plane(rng):
    floor = np.column_stack([rng.uniform(-2, 2, (4000, 2)), rng.normal(0, 1e-3, 4000)])
    source, target = loom.PointCloud(floor - [0.1, 0, 0]), loom.PointCloud(floor)
    known = reg.Prior(as_pose([0, 0, 0], [0.1, 0, 0]), sigma_translation=0.05, sigma_rotation=0.01)
    result = reg.register_pair(source, target, init=np.eye(4), voxel_size=0.1, constraint=reg.Constraint(prior=known))
    np.testing.assert_allclose(result.transformation[:3, 3], [0.1, 0, 0], atol=0.01)
    assert len(result.to_dict()["prior_directions"]) == 3 and "3 of 6 motions" in str(result)
