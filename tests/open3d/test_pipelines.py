"""Pipelines: scripts of Open3D's pages give Open3D's numbers; options, NDT, and invalid arguments."""

import copy
import pickle

import numpy as np
import pytest
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

import pointloom as loom
import pointloom.open3d as bridge

from .runner import assert_same_results, differences, draw_nothing, results_of

USUAL = 1e-6  # positions are float32 about an origin here, float64 in Open3D
TOLERANCES = {
    "icp_registration": {},
    "colored_icp": {},
    # noise of 0.1 m: fixed points of ICP are close to each other, so other steps may end in another one
    "robust_kernels": dict.fromkeys(("tukey", "huber", "cauchy", "gm"), 1e-3),
    # the residual of a rotation is 2 sin(a / 2) here and sin(a) in Open3D; a last improving step is accepted
    "multiway_registration": {"poses": 1e-5, "again": 1e-5, "moved by": 1e-5, "confidence": 1e-5, "middle": 1e-5},
    # directions that brightness hardly constrains need 35 steps, with other rounding
    "rgbd_odometry": {"color": 1e-3},
}
VOXEL = 0.05  # [m] of rgbd_integration


@pytest.mark.parametrize("page", TOLERANCES)
def test_a_page_gives_the_same_numbers(page, oracle, page_files, monkeypatch):
    assert_same_results(oracle, f"../pages/{page}", page_files, monkeypatch, TOLERANCES[page], USUAL)


@pytest.fixture
def both(o3d, page_files, monkeypatch):
    """Results of a page's script with Open3D and with pointloom.open3d, which draw the same."""

    def run(page):
        drawn = [draw_nothing(monkeypatch, module) for module in (o3d, bridge)]
        pair = [results_of(f"../pages/{page}", package, page_files) for package in ("open3d", "pointloom.open3d")]
        assert drawn[0] == drawn[1] != []
        return pair

    return run


def test_a_volume_has_the_same_surface(both):
    theirs, actual = both("rgbd_integration")
    surfaces = [loom.TriangleMesh(*output.pop("surface")) for output in (theirs, actual)]
    clouds = [output.pop("cloud") for output in (theirs, actual)]
    scalable = [output.pop("scalable") for output in (theirs, actual)]
    tolerances = {"mean color": 0.01, "area": 0.02}  # voxel positions differ, and surface edges with them
    assert differences(theirs, actual, tolerances, USUAL) == []
    # Open3D 0.20 divides the depth of an RGBDImage, already in meters, by 1000 again and gets no voxel blocks
    assert len(scalable[0]) == 0
    pairs = [(surfaces[0], points) for points in (surfaces[1].vertices, clouds[1], scalable[1])]
    for surface, points in (*pairs, (surfaces[1], surfaces[0].vertices), (surfaces[1], clouds[0])):
        scene = loom.RaycastingScene()
        scene.add_triangles(surface)
        assert (np.quantile(scene.compute_distance(points), [0.5, 0.9]) < np.array([0.2, 0.6]) * VOXEL).all()


def test_color_maps_give_the_same_colors(both):
    theirs, actual = both("color_map_optimization")
    plain = [output.pop("plain") for output in (theirs, actual)]
    # except vertices halfway between two pixels, or with the color of such a vertex
    assert (np.abs(plain[0] - plain[1]).max(axis=1) < 1e-6).mean() > 0.95
    # Open3D's steps are an eighth of pointloom's, and on these walls both move 15 cm away from the true poses
    # to different end points, so only the kind of the optimized values is compared
    for name in ("rigid", "bent"):
        colors = [output.pop(name) for output in (theirs, actual)]
        assert colors[0].shape == colors[1].shape and all(0 <= one.min() < one.max() <= 1 for one in colors)
    assert differences(theirs, actual, {}, USUAL) == []


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


def test_options_have_the_repr_of_open3d(oracle):
    texts = oracle("open3d/options", lambda open3d: [repr(one) for one in objects_of(open3d)])
    for text, option in zip(texts, objects_of(bridge), strict=True):
        for same in (option, copy.copy(option), copy.deepcopy(option), pickle.loads(pickle.dumps(option))):
            assert repr(same) == text


def test_options_are_checked_on_use():
    reg = bridge.pipelines.registration
    criteria = reg.ICPConvergenceCriteria()
    criteria.max_iteration = -1
    cloud = bridge.geometry.PointCloud(bridge.utility.Vector3dVector(np.eye(3)))
    with pytest.raises(ValueError, match="max_iteration"):
        reg.registration_icp(cloud, cloud, 1.0, criteria=criteria)
    with pytest.raises(TypeError, match="criteria:"):
        reg.registration_icp(cloud, cloud, 1.0, criteria=reg.RANSACConvergenceCriteria())
    kernel = reg.TukeyLoss(0.1)
    method = reg.TransformationEstimationForColoredICP(kernel)
    kernel.k = 0.3
    assert (method.kernel.k, method.lambda_geometric) == (0.3, 0.968)


def test_gray_volumes_store_the_intensity_of_each_pixel():
    kinds, geometry = bridge.pipelines.integration, bridge.geometry
    ramp = np.tile(np.linspace(0, 255, 40).astype(np.uint8)[None, :, None], (30, 1, 3))
    depth = geometry.Image(np.full((30, 40), 1000, np.uint16))
    camera = bridge.camera.PinholeCameraIntrinsic(40, 30, 35.0, 35.0, 19.5, 14.5)
    frames = [geometry.RGBDImage.create_from_color_and_depth(geometry.Image(ramp), depth, 1000, 3, g) for g in (1, 0)]
    volume = kinds.ScalableTSDFVolume(0.04, 0.16, kinds.TSDFVolumeColorType.Gray32)
    volume.integrate(frames[0], camera, np.eye(4))
    cloud = volume.extract_point_cloud()
    points, colors = np.asarray(cloud.points), np.asarray(cloud.colors)
    np.testing.assert_array_equal(colors, np.repeat(colors[:, :1], 3, axis=1))
    np.testing.assert_allclose(colors[:, 0], (35 * points[:, 0] + 19.5) / 39, atol=0.03)  # a column, and rounding
    with pytest.raises(TypeError, match="image:"):
        volume.integrate(frames[1], camera, np.eye(4))


def poses_of_pairs(package, points, target):
    clouds = [package.geometry.PointCloud(package.utility.Vector3dVector(rows)) for rows in (points, target)]
    pairs = package.utility.Vector2iVector(np.column_stack([np.arange(20)] * 2))
    methods = [package.pipelines.registration.TransformationEstimationPointToPoint(s) for s in (False, True)]
    poses = [np.array(method.compute_transformation(*clouds, pairs)) for method in methods]
    return [(T, method.compute_rmse(*clouds, pairs)) for T, method in zip(poses, methods, strict=True)]


def test_pairs_fix_a_pose_as_in_open3d(oracle, rng):
    points, target = rng.random((20, 3)), rng.random((20, 3))
    expected = oracle("open3d/pairs", poses_of_pairs, points, target)
    for (T, rmse), (T_actual, rmse_actual) in zip(expected, poses_of_pairs(bridge, points, target), strict=True):
        assert np.allclose(T_actual, T, atol=1e-6) and rmse_actual == pytest.approx(rmse, abs=1e-6)


def cloud_of(points, **vectors):
    cloud = bridge.geometry.PointCloud(bridge.utility.Vector3dVector(points))
    for name, rows in vectors.items():
        setattr(cloud, name, bridge.utility.Vector3dVector(rows))
    return cloud


def unit(vectors):
    return vectors / np.linalg.norm(vectors, axis=1, keepdims=True)


def test_repeated_steps_of_given_pairs_reach_the_least_squares_pose(rng):
    """A loop of ICP written by the user, with some pairs twice and a robust kernel or none."""
    reg, pairs = bridge.pipelines.registration, np.column_stack([rng.integers(0, 40, 60)] * 2)
    couples, normals = bridge.utility.Vector2iVector(pairs), unit(rng.normal(size=(40, 3)))
    points = rng.random((40, 3))
    target = Rotation.from_rotvec([0.05, -0.1, 0.08]).apply(points) + rng.normal(0, 0.01, (40, 3))

    def gaps(x):
        return ((Rotation.from_rotvec(x[:3]).apply(points) + x[3:] - target) * normals).sum(axis=1)[pairs[:, 1]]

    for loss, kernel in (("linear", reg.L2Loss()), ("huber", reg.HuberLoss(0.01)), ("cauchy", reg.CauchyLoss(0.02))):
        method = reg.TransformationEstimationPointToPlane(kernel)
        source, fixed = cloud_of(points), cloud_of(target, normals=normals)
        rmse = np.sqrt((gaps(np.zeros(6)) ** 2).mean())  # without the kernel
        assert method.compute_rmse(source, fixed, couples) == pytest.approx(rmse, rel=1e-6)
        for _ in range(40):
            source.transform(method.compute_transformation(source, fixed, couples))
        least = least_squares(gaps, np.zeros(6), loss=loss, f_scale=getattr(kernel, "k", 1.0), xtol=1e-12, ftol=1e-12)
        reached = Rotation.from_rotvec(least.x[:3]).apply(points) + least.x[3:]
        assert np.allclose(np.asarray(source.points), reached, atol=2e-5)
    none = bridge.utility.Vector2iVector()
    assert np.array_equal(method.compute_transformation(source, fixed, none), np.eye(4))
    assert method.compute_rmse(source, fixed, none) == 0


def test_residuals_of_given_pairs_are_those_of_each_estimator(rng):
    reg, pairs = bridge.pipelines.registration, rng.integers(0, 40, (60, 2))
    points, target, source_colors, colors = rng.random((4, 40, 3))
    left, right = (unit(rng.normal(size=(40, 3))) for _ in range(2))
    clouds = cloud_of(points, normals=left, colors=source_colors), cloud_of(target, normals=right, colors=colors)
    gap, n, m = points[pairs[:, 0]] - target[pairs[:, 1]], right[pairs[:, 1]], left[pairs[:, 0]]
    both = n + m * np.where((m * n).sum(axis=1, keepdims=True) < 0, -1, 1)
    C = [np.eye(3) - (1 - 0.001) * v[:, :, None] * v[:, None, :] for v in (n, m)]  # flat along each normal
    weighted = np.einsum("ni,nij,nj->n", gap, np.linalg.inv(C[0] + C[1]), gap)
    squares = {
        reg.TransformationEstimationSymmetric(): (gap * both).sum(axis=1) ** 2,
        reg.TransformationEstimationForGeneralizedICP(): weighted,
        reg.TransformationEstimationForColoredICP(1.0): (gap * n).sum(axis=1) ** 2,
    }
    for method, square in squares.items():
        couples = bridge.utility.Vector2iVector(pairs)
        assert method.compute_rmse(*clouds, couples) == pytest.approx(np.sqrt(square.mean()), rel=1e-5)
        moved = clouds[0].__copy__().transform(method.compute_transformation(*clouds, couples))
        assert method.compute_rmse(moved, clouds[1], couples) < np.sqrt(square.mean())
    # brightness rises along x: a shift along x and z is seen, one along y is not
    plane = np.pad(rng.random((200, 2)), ((0, 0), (0, 1)))
    gray = np.repeat(0.2 + 0.5 * plane[:, :1], 3, axis=1)
    flat = cloud_of(plane, normals=np.tile([0, 0, 1.0], (200, 1)), colors=gray)
    shifted = cloud_of(plane + np.array([0.02, 0.1, 0.01]), colors=gray)
    method = reg.TransformationEstimationForColoredICP(0.6)
    same = bridge.utility.Vector2iVector([[i, i] for i in range(200)])
    expected = np.sqrt(0.6 * 0.01**2 + 0.4 * (0.5 * 0.02) ** 2)
    assert method.compute_rmse(shifted, flat, same) == pytest.approx(expected, rel=1e-4)
    assert np.allclose(method.compute_transformation(shifted, flat, same)[:3, 3], (-0.02, 0, -0.01), atol=1e-4)


def test_old_argument_orders_are_explained():
    reg, cloud, feature = bridge.pipelines.registration, cloud_of(np.eye(3)), bridge.pipelines.registration.Feature()
    assert reg.RANSACConvergenceCriteria(4000000, 500).confidence == 1  # a count before Open3D 0.12
    with pytest.raises(TypeError, match="mutual_filter:"):
        reg.registration_ransac_based_on_feature_matching(cloud, cloud, feature, feature, 0.05, None)
    with pytest.raises(TypeError, match="checkers:"):
        criteria = reg.RANSACConvergenceCriteria()
        reg.registration_ransac_based_on_correspondence(cloud, cloud, [[0, 0]], 0.05, None, 3, criteria)


def test_graphs_copy_their_nodes_and_edges():
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


reg = bridge.pipelines.registration
SHIFT = np.array([0.0625, -0.03125, 0.0625])


def ndt_results(package, points):
    theirs, results = package.pipelines.registration, []
    clouds = [package.geometry.PointCloud(package.utility.Vector3dVector(p)) for p in (points, points + SHIFT)]
    for option in ({"voxel_size": 0.5}, {"voxel_size": 0.5, "neighbor_search_type": 0}):
        found = theirs.registration_ndt(*clouds, theirs.NormalDistributionsTransformOption(**option), np.eye(4))
        pairs = np.asarray(found.correspondence_set)
        pairs = pairs[np.argsort(pairs[:, 0], kind="stable")]
        results.append((np.array(found.transformation), found.fitness, found.inlier_rmse, pairs))
    return results


def test_ndt_matches_open3d(oracle, rng):
    x, y = np.round(rng.uniform(-1, 1, (2, 800)) * 2**16) / 2**16
    points = np.column_stack([x, y, np.round(0.3 * np.sin(3 * x) * np.cos(4 * y) * 2**16) / 2**16])
    expected = oracle("open3d/ndt", ndt_results, points)
    for (T, fitness, rmse, pairs), found in zip(expected, ndt_results(bridge, points), strict=True):
        np.testing.assert_allclose(found[0], T, rtol=0, atol=1e-5)  # the default limits end both a step apart
        assert found[1] == pytest.approx(fitness, abs=2 / 800) and found[2] == pytest.approx(rmse, abs=1e-4)
        assert (found[3][: len(pairs)] == pairs[: len(found[3])]).mean() > 0.98
        assert np.abs(T[:3, 3] - SHIFT).max() < 0.02


def option_texts(package):
    kind = package.pipelines.registration.NormalDistributionsTransformOption
    options = kind(), kind(0.25, 7, 1e-7), kind(2, outlier_threshold=4.5, neighbor_search_type=0, max_iteration=100)
    return [repr(one) for option in options for one in (option, copy.copy(option), kind(option))]


def test_ndt_options_have_the_repr_of_open3d(oracle):
    assert option_texts(bridge) == oracle("open3d/ndt_options", option_texts)
    option = reg.NormalDistributionsTransformOption(0.25)
    assert repr(pickle.loads(pickle.dumps(option))) == repr(option) == repr(copy.deepcopy(option))


@pytest.mark.parametrize("options", [
    {"voxel_size": -1.0}, {"voxel_size": np.inf}, {"min_points_per_voxel": 3}, {"covariance_regularization": 1.0},
    {"transformation_epsilon": 0.0}, {"relative_objective": np.nan}, {"max_iteration": 0}, {"outlier_threshold": 0.0},
    {"neighbor_search_type": 2},
])  # fmt: skip
def test_invalid_ndt_options_are_rejected_when_made_and_when_used(options):
    (name, value) = next(iter(options.items()))
    for kind in (RuntimeError, ValueError):
        with pytest.raises(kind, match=f"{name}:"):
            reg.NormalDistributionsTransformOption(**options)
    option = reg.NormalDistributionsTransformOption()
    setattr(option, name, value)
    cloud = cloud_of(np.random.default_rng(0).random((50, 3)))
    with pytest.raises(RuntimeError, match=f"{name}:"):
        reg.registration_ndt(cloud, cloud, option)


def test_ndt_takes_no_criteria_of_icp_and_needs_voxels():
    cloud = cloud_of(np.random.default_rng(0).random((50, 3)))
    for arguments in ((None, np.eye(4), reg.ICPConvergenceCriteria()), (reg.ICPConvergenceCriteria(),)):
        with pytest.raises(TypeError):
            reg.registration_ndt(cloud, cloud, *arguments)
    with pytest.raises(RuntimeError, match=r"voxel_size: .*Increase it"):
        reg.registration_ndt(cloud, cloud, reg.NormalDistributionsTransformOption(0.001))
    empty = reg.registration_ndt(cloud_of(np.empty((0, 3))), cloud)
    assert empty.fitness == 0 and len(empty.correspondence_set) == 0 and np.array_equal(empty.transformation, np.eye(4))


PAIRS = bridge.utility.Vector2iVector([[0, 0]])
CALLS = {
    "registration_icp": lambda a, b: reg.registration_icp(a, b, -1.0),
    "evaluate_registration": lambda a, b: reg.evaluate_registration(a, b, 0.1, np.zeros((4, 4))),
    "plane": lambda a, b: reg.registration_icp(a, b, 0.1, np.eye(4), reg.TransformationEstimationPointToPlane()),
    "plane step": lambda a, b: reg.TransformationEstimationPointToPlane().compute_transformation(a, b, PAIRS),
    "plane rmse": lambda a, b: reg.TransformationEstimationPointToPlane().compute_rmse(a, b, PAIRS),
    "symmetric": lambda a, b: reg.registration_symmetric_icp(a, b, 0.1),
    "colored": lambda a, b: reg.registration_colored_icp(a, b, 0.1),
    "features": lambda a, _: reg.compute_fpfh_feature(a, bridge.geometry.KDTreeSearchParamKNN(5)),
}


def errors_of(package, points):
    """The names of the errors of the calls."""
    module, places = package.pipelines.registration, globals()
    kept = {name: places[name] for name in ("reg", "bridge", "PAIRS")}
    places.update(reg=module, bridge=package, PAIRS=package.utility.Vector2iVector([[0, 0]]))
    clouds = [package.geometry.PointCloud(package.utility.Vector3dVector(points)) for _ in range(2)]
    names = []
    try:
        for call in CALLS.values():
            try:
                call(*clouds)
                names.append("none")
            except Exception as error:
                names.append("RuntimeError" if isinstance(error, RuntimeError) else type(error).__name__)
    finally:
        places.update(kept)
    return names


def test_invalid_arguments_are_runtime_errors_and_value_errors(oracle):
    points = np.random.default_rng(0).random((20, 3))
    theirs = dict(zip(CALLS, oracle("open3d/registration_errors", errors_of, points), strict=True))
    assert sum(name == "RuntimeError" for name in theirs.values()) >= 5
    for name, call in CALLS.items():
        if theirs[name] == "RuntimeError":
            for kind in (RuntimeError, ValueError):
                with pytest.raises(kind):
                    call(cloud_of(points), cloud_of(points))


def test_symmetric_icp_names_the_cloud_without_normals():
    bare, full = cloud_of(np.eye(3)), cloud_of(np.eye(3), normals=np.eye(3))
    for pair, name in (((bare, full), "source"), ((full, bare), "target")):
        with pytest.raises(RuntimeError, match=rf"{name}: .* call {name}\.estimate_normals"):
            reg.registration_symmetric_icp(*pair, 0.1)
