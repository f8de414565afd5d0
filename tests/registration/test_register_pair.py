"""register_pair: the steps of which it is made, what it tells, and the clouds that it refuses."""

import numpy as np
import pytest

import pointloom as loom
from pointloom.registration.voxel_size import choose_voxel_size

from ..cli.surface_poses import NEAR, POSE, bumpy, colors_at, moved

reg = loom.registration
PLANE = reg.TransformationEstimationPointToPlane()


@pytest.fixture
def pair(rng, device):
    """A surface sampled twice, the first under NEAR's inverse, with colors."""
    points, others = bumpy(rng), bumpy(rng)
    source = loom.PointCloud(moved(points, np.linalg.inv(NEAR)), colors=colors_at(points), device=device)
    return source, loom.PointCloud(others, colors=colors_at(others), device=device)


def test_a_start_that_is_given_is_refined_on_three_scales(pair):
    found = reg.register_pair(*pair, init=np.eye(4), voxel_size=0.06)
    sizes, limits = [0.24, 0.12, 0.06], [0.48, 0.24, 0.12]
    rules = [reg.ICPConvergenceCriteria()] * 3
    plain = reg.multi_scale_icp(*pair, sizes, rules, limits, None, PLANE, estimate_normals=True)
    np.testing.assert_array_equal(found.transformation, plain.transformation)
    assert (found.result.iterations, found.init, found.max_correspondence_distance) == (plain.iterations, "given", 0.12)
    assert found.score == reg.rate_registration(*pair, plain.transformation, 1.5 * 0.06) > 0.5
    np.testing.assert_allclose(found.transformation, NEAR, atol=0.01)
    assert found.reliable


def test_without_a_start_it_searches(rng):
    points = bumpy(rng)
    source = loom.PointCloud(moved(points[points[:, 0] > -0.4], np.linalg.inv(POSE)))
    target = loom.PointCloud(points[points[:, 0] < 0.4])
    found = reg.register_pair(source, target, voxel_size=0.06)
    np.testing.assert_allclose(found.transformation, POSE, atol=0.01)
    start = reg.register_globally(source, target, voxel_size=0.06)
    thin = [cloud.voxel_down_sample(0.06) for cloud in (source, target)]
    thin[1] = thin[1].estimate_normals(radius=3 * 0.06, max_nn=30)
    plain = reg.registration_icp(*thin, 0.12, start.transformation, PLANE)
    np.testing.assert_array_equal(found.transformation, plain.transformation)
    assert found.init == "global" and found.thinned == tuple(map(len, thin))


def test_normals_are_estimated_of_the_clouds_that_lack_them_alone(pair):
    source, target = pair
    with_normals = target.estimate_normals(max_nn=8)
    rules = [reg.ICPConvergenceCriteria(max_iteration=4)]
    for cloud, estimated in ((target, ("target",)), (with_normals, ())):
        assert reg.register_pair(source, cloud, init=np.eye(4), voxel_size=0.1).normals_estimated == estimated
    told = [
        reg.multi_scale_icp(source, with_normals, [0.1], rules, [0.2], None, PLANE, estimate_normals=wanted)
        for wanted in (False, True)
    ]
    np.testing.assert_array_equal(told[0].transformation, told[1].transformation)
    with pytest.raises(ValueError, match="target:"):
        reg.multi_scale_icp(source, target, [0.1], rules, [0.2], None, PLANE)
    whole = reg.multi_scale_icp(source, target, [-1], rules, [0.2], None, PLANE, estimate_normals=True)
    plain = reg.registration_icp(source, target.estimate_normals(max_nn=30), 0.2, None, PLANE, rules[0])
    np.testing.assert_array_equal(whole.transformation, plain.transformation)


def test_it_tells_its_stages_and_says_what_it_found(pair):
    stages = []
    found = reg.register_pair(*pair, progress=lambda stage, done, total: stages.append((stage, done, total)))
    assert stages == [("voxels", 0, 0), ("search", 0, 0), ("refine", 0, 0), ("rate", 0, 0)]
    assert found.voxel_size == choose_voxel_size(*pair) and not found.voxel_size_given
    report = found.to_dict()
    assert report["transformation"] == found.transformation.tolist()
    assert report["points"] == {"source": len(pair[0]), "target": len(pair[1])}
    assert f"{found.transformation[1, 3]:.9f}" in str(found)
    assert "chosen from the clouds" in str(found)


def test_a_pose_without_correspondences_is_unreliable(pair):
    far = np.eye(4)
    far[0, 3] = 1000
    found = reg.register_pair(*pair, init=far, voxel_size=0.06)
    assert found.warnings == ("no point of the source has a correspondence",)


def test_a_voxel_size_wants_clouds():
    with pytest.raises(ValueError, match="clouds:"):
        choose_voxel_size()
    with pytest.raises(TypeError, match=r"clouds\[0\]:"):
        choose_voxel_size(np.zeros((4, 3)))  # pyright: ignore[reportArgumentType]
    assert choose_voxel_size(loom.PointCloud(np.ones((50, 3)))) == 1
