"""Scripts of Open3D's pages on pipelines give Open3D's numbers when their import line is changed."""

from __future__ import annotations

import copy
import pickle

import numpy as np
import pytest

import pointloom as loom
import pointloom.open3d as bridge

from .runner import assert_found_by_both, differences, draw_nothing, found_by

USUAL = 1e-6  # positions are float32 about an origin here, float64 there
TOLERANCES = {
    "icp_registration": {},
    "colored_icp": {},
    # noise of 0.1 m: the fixed points of ICP are close to each other, and other steps end in another one
    "robust_kernels": dict.fromkeys(("tukey", "huber", "cauchy", "gm"), 1e-3),
    # the misfit of a turn is 2 sin(a / 2) here and sin(a) there; a last step that still helps is taken
    "multiway_registration": {"poses": 1e-5, "again": 1e-5, "moved by": 1e-5, "confidence": 1e-5, "middle": 1e-5},
    # what brightness alone leaves nearly open is found by 35 steps of other sums
    "rgbd_odometry": {"color": 1e-3},
}
VOXEL = 0.05  # [m] of rgbd_integration


@pytest.mark.parametrize("page", TOLERANCES)
def test_a_page_gives_the_same_numbers(page, oracle, page_files, monkeypatch):
    assert_found_by_both(oracle, f"../pages/{page}", page_files, monkeypatch, TOLERANCES[page], USUAL)


@pytest.fixture
def both(o3d, page_files, monkeypatch):
    """What a page's script finds with Open3D and with its names here, which draw the same."""

    def run(page):
        shown = [draw_nothing(monkeypatch, module) for module in (o3d, bridge)]
        pair = [found_by(f"../pages/{page}", package, page_files) for package in ("open3d", "pointloom.open3d")]
        assert shown[0] == shown[1] != []
        return pair

    return run


def test_a_volume_has_the_same_surface(both):
    theirs, ours = both("rgbd_integration")
    surfaces = [loom.TriangleMesh(*found.pop("surface")) for found in (theirs, ours)]
    clouds = [found.pop("cloud") for found in (theirs, ours)]
    scalable = [found.pop("scalable") for found in (theirs, ours)]
    tolerances = {"mean color": 0.01, "area": 0.02}  # voxels lie at other places, edges of the surface with them
    assert differences(theirs, ours, tolerances, USUAL) == []
    # Open3D 0.20 divides the depth of an RGBDImage, which is in meters, by 1000 again, and finds no block of voxels
    assert len(scalable[0]) == 0
    pairs = [(surfaces[0], points) for points in (surfaces[1].vertices, clouds[1], scalable[1])]
    for surface, points in (*pairs, (surfaces[1], surfaces[0].vertices), (surfaces[1], clouds[0])):
        scene = loom.RaycastingScene()
        scene.add_triangles(surface)
        distances = np.quantile(scene.compute_distance(points), [0.5, 0.9])
        assert (distances < np.array([0.2, 0.6]) * VOXEL).all()


def test_color_maps_give_the_same_colors(both):
    theirs, ours = both("color_map_optimization")
    plain = [found.pop("plain") for found in (theirs, ours)]
    # but where a vertex lies half way between two pixels, or takes the color of one that does
    assert (np.abs(plain[0] - plain[1]).max(axis=1) < 1e-6).mean() > 0.95
    # a step of theirs is an eighth of ours, and on these walls both walk 15 cm away from the true poses: each ends
    # elsewhere, so that of what is optimized only the kind is compared
    for name in ("rigid", "bent"):
        colors = [found.pop(name) for found in (theirs, ours)]
        assert colors[0].shape == colors[1].shape and all(0 <= one.min() < one.max() <= 1 for one in colors)
    assert differences(theirs, ours, {}, USUAL) == []


OBJECTS = """
registration.CauchyLoss(0.1), registration.L1Loss(), registration.L2Loss(), registration.TukeyLoss(k=0.1)
registration.CorrespondenceCheckerBasedOnDistance(0.1), registration.CorrespondenceCheckerBasedOnEdgeLength()
registration.CorrespondenceCheckerBasedOnNormal(0.1)
registration.CorrespondenceCheckerBasedOnSourceRotation([0.1, 0.2, 0.3])
registration.FastGlobalRegistrationOption(), registration.FastGlobalRegistrationOption(tuple_test=False)
registration.GlobalOptimizationOption(), registration.GlobalOptimizationOption(reference_node=0)
registration.GlobalOptimizationConvergenceCriteria(), registration.GlobalOptimizationLevenbergMarquardt()
registration.ICPConvergenceCriteria(), registration.ICPConvergenceCriteria(max_iteration=2000)
registration.RANSACConvergenceCriteria(), registration.RANSACConvergenceCriteria(4000000, 0.9)
registration.PoseGraph(), registration.PoseGraphNode(), registration.PoseGraphEdge(0, 1, uncertain=True)
registration.TransformationEstimationPointToPoint(), registration.TransformationEstimationPointToPoint(True)
registration.TransformationEstimationForColoredICP(0.5), registration.TransformationEstimationForGeneralizedICP()
registration.TransformationEstimationForColoredICP(registration.TukeyLoss(0.1)), registration.Feature()
registration.RegistrationResult(), odometry.OdometryOption(depth_max=2.5)
odometry.RGBDOdometryJacobianFromHybridTerm()
"""


def objects_of(package):
    names = {name: getattr(package.pipelines, name) for name in ("registration", "odometry")}
    return [one for line in OBJECTS.strip().splitlines() for one in eval(f"[{line}]", names)]


def test_options_say_themselves_as_those_of_open3d(oracle):
    texts = oracle("open3d/options", lambda open3d: [repr(one) for one in objects_of(open3d)])
    for said, ours in zip(texts, objects_of(bridge), strict=True):
        for same in (ours, copy.copy(ours), copy.deepcopy(ours), pickle.loads(pickle.dumps(ours))):
            assert repr(same) == said


def test_options_are_assigned_and_checked_where_they_are_used():
    reg = bridge.pipelines.registration
    criteria = reg.ICPConvergenceCriteria()
    criteria.max_iteration = -1
    cloud = bridge.geometry.PointCloud(bridge.utility.Vector3dVector(np.eye(3)))
    with pytest.raises(ValueError, match="max_iteration"):
        reg.registration_icp(cloud, cloud, 1.0, np.eye(4), reg.TransformationEstimationPointToPoint(), criteria)
    with pytest.raises(TypeError, match="criteria:"):
        reg.registration_icp(cloud, cloud, 1.0, criteria=reg.RANSACConvergenceCriteria())
    kernel = reg.TukeyLoss(0.1)
    method = reg.TransformationEstimationForColoredICP(kernel)
    kernel.k = 0.3
    assert (method.kernel.k, method.lambda_geometric) == (0.3, 0.968)
    with pytest.raises(ValueError, match="color_type:"):
        kinds = bridge.pipelines.integration
        kinds.ScalableTSDFVolume(0.1, 0.4, kinds.TSDFVolumeColorType.Gray32)


def poses_of_pairs(package, points, turned):
    clouds = [package.geometry.PointCloud(package.utility.Vector3dVector(rows)) for rows in (points, turned)]
    pairs = package.utility.Vector2iVector(np.column_stack([np.arange(20)] * 2))
    methods = [package.pipelines.registration.TransformationEstimationPointToPoint(s) for s in (False, True)]
    return [
        (np.array(method.compute_transformation(*clouds, pairs)), method.compute_rmse(*clouds, pairs))
        for method in methods
    ]


def test_pairs_fix_a_pose_as_in_open3d(oracle, rng):
    points, turned = rng.random((20, 3)), rng.random((20, 3))
    wanted = oracle("open3d/pairs", poses_of_pairs, points, turned)
    for (T, rmse), (T_ours, rmse_ours) in zip(wanted, poses_of_pairs(bridge, points, turned), strict=True):
        assert np.allclose(T_ours, T, atol=1e-6)
        assert rmse_ours == pytest.approx(rmse, abs=1e-6)


def test_graphs_keep_copies_of_what_is_put_into_them():
    reg, pose = bridge.pipelines.registration, np.eye(4)
    graph, node = reg.PoseGraph(), reg.PoseGraphNode(pose)
    graph.nodes.append(node)
    pose[0, 3] = node.pose[1, 3] = 5.0
    node.pose = 7 * np.eye(4)
    assert np.array_equal(graph.nodes[0].pose, np.eye(4))
    graph.nodes[0].pose = np.diag([1.0, -1, -1, 1])
    assert graph.nodes[0].pose[1, 1] == -1
    with pytest.raises(TypeError, match="PoseGraphNodeVector:"):
        graph.nodes.append(pose)
