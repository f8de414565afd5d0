"""Every public function of registration rejects invalid arguments with an error that names them.

The checks run on the host, so the CPU represents all devices. Switches are excluded, as every value is valid.
Result records are excluded, too.
"""

import contextlib
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pointloom as loom
from pointloom import registration as reg

from .. import hostile
from ..recorded_calls import faults_of_recorded, has_record, valid_call

# One line per call that no record of an operation contains: the function, and a valid value of each argument, as
# expressions over `things()`.
CALLS = """
reg.CauchyLoss(k=0.1)
reg.GMLoss(k=0.1)
reg.GeneralizedLoss(k=0.1, shape=1.0)
reg.HuberLoss(k=0.1)
reg.TukeyLoss(k=0.1)
reg.CorrespondenceCheckerBasedOnDistance(distance_threshold=0.5)
reg.CorrespondenceCheckerBasedOnEdgeLength(similarity_threshold=0.9)
reg.CorrespondenceCheckerBasedOnNormal(normal_angle_threshold=0.5)
reg.CorrespondenceCheckerBasedOnSourceRotation(rotation_threshold=three)
by_distance.Check(source=source, target=target, corres=corres, transformation=pose)
tukey.weight(residual=three)
reg.ICPConvergenceCriteria(relative_fitness=1e-6, relative_rmse=1e-6, max_iteration=3)
reg.NormalDistributionsTransformOption(voxel_size=0.5, min_points_per_voxel=6, covariance_regularization=1e-3, transformation_epsilon=1e-6, relative_objective=1e-6, max_iteration=3, outlier_threshold=9.0, neighbor_search_type=1)
reg.Constraint(free=["x", "yaw"], frame=axes, pivot=three, prior=known, noise=0.01)
reg.Prior(transformation=pose, information=None, sigma_translation=0.1, sigma_rotation=0.2)
reg.leveled(init=pose, up_in_source=three, up_in_target=three)
reg.FastGlobalRegistrationOption(division_factor=1.4, maximum_correspondence_distance=0.1, iteration_number=4, tuple_scale=0.9, maximum_tuple_count=100)
reg.GlobalOptimizationConvergenceCriteria(max_iteration=3, min_relative_increment=1e-6, min_relative_residual_increment=1e-6, min_right_term=1e-6, min_residual=1e-6, max_iteration_lm=3, upper_scale_factor=0.6, lower_scale_factor=0.3)
reg.GlobalOptimizationOption(max_correspondence_distance=0.03, edge_prune_threshold=0.25, preference_loop_closure=1.0, reference_node=-1)
reg.TransformationEstimationForColoredICP(lambda_geometric=0.9, kernel=l2)
reg.TransformationEstimationForDopplerICP(period=0.1, lambda_doppler=0.01, doppler_outlier_threshold=2.0, outlier_rejection_min_iteration=2, geometric_robust_loss_min_iteration=0, doppler_robust_loss_min_iteration=2, geometric_kernel=l2, doppler_kernel=l2, transform_vehicle_to_sensor=pose)
reg.TransformationEstimationForGeneralizedICP(epsilon=1e-3, kernel=l2, voxel_size=0.1)
reg.TransformationEstimationPointToPlane(kernel=l2)
reg.TransformationEstimationPointToPoint(kernel=l2)
reg.TransformationEstimationSymmetric(kernel=l2)
reg.PoseGraph(nodes=[node], edges=[])
reg.PoseGraphNode(pose=pose)
reg.PoseGraphEdge(source_node_id=0, target_node_id=1, transformation=pose, information=information, confidence=1.0)
reg.LidarOdometry(voxel_size=0.1, max_range=10.0, min_range=0.1, max_points_per_voxel=5, interval=0.1, initial_threshold=2.0, min_motion=0.1, device="cpu")
odometry().register(scan=source, timestamps=times, prior=pose, imu=readings, time=1.0)
reg.LidarSLAM(submap_length=2.0, folder="map", device="cpu")
slam().register(scan=source, timestamps=times, prior=pose, imu=readings, time=1.0, positions=located)
reg.LidarSLAM.open(folder=saved, device="cpu")
reg.PositionReadings(times=times, positions=track, sigma=0.1, offset=three)
reg.PositionReadings.read(path=gnss, sigma=0.1)
slam().localize(cloud=source)
reg.correspondences_from_features(source_features=features, target_features=features, mutual_consistency_ratio=0.1, ratio=0.9, device="cpu")
reg.deskew_point_cloud(cloud=source, T_start_end=pose, timestamps=times)
reg.evaluate_trajectory(estimate=trajectory, truth=trajectory, align="first", delta=1, lengths=[1.0], max_time_difference=0.1, extrinsic=pose)
reg.fit_to_positions(model=model, positions=positions, max_error=0.1, seed=0)
reg.global_optimization(pose_graph=graph, method="gauss-newton", criteria=criteria, option=option, free=["yaw", "x", "y", "z"])
reg.multi_scale_icp(source=source, target=target, voxel_sizes=[0.3, 0.1], criteria_list=[rules, rules], max_correspondence_distances=[0.4, 0.2], init=pose, estimation_method=to_points, callback_after_iteration=None, overlap=0.8, constraint=bound, weights=times)
reg.read_pose_graph(path="nowhere.json")
reg.read_positions(path=gps, names=["a", "b", "c", "d"])
reg.read_control_points(path="nowhere.csv")
reg.read_targets(path="nowhere.csv", names=["a"])
reg.register_multiway(clouds=[source, target], voxel_size=0.2, neighbors=1, seed=0, known=[], pairs=None, free=None, progress=None)
reg.register_globally(source=source, target=target, voxel_size=0.2, seed=0, free=["x", "y", "z", "yaw"])
reg.register_pair(source=source, target=target, init=pose, method="point-to-plane", voxel_size=0.2, max_correspondence_distance=0.4, progress=None, constraint=bound)
reg.registration_fgr_based_on_correspondence(source=source, target=target, corres=corres, option=None, seed=0)
reg.coherent_point_drift(source=source, target=target, kind="affine", outliers=0.1, width=2.0, stiffness=3.0, init=pose, max_iterations=2, tolerance=0.01, progress=None)
reg.register_nonrigid(source=source, target=target, node_spacing=0.5, max_correspondence_distance=1.0, init=pose, landmarks=None, landmark_weight=1.0, stiffness=[1.0], max_iterations=2, tolerance=0.01, progress=None)
reg.registration_icp(source=source, target=target, max_correspondence_distance=0.2, init=pose, estimation_method=to_points, criteria=rules, overlap=0.9, max_normal_angle=1.0, degeneracy=1e-3, callback_after_iteration=None, constraint=bound, weights=times)
reg.registration_icp_batch(sources=source, targets=target, max_correspondence_distance=0.2, inits=pose, estimation_method=to_points, criteria=rules, overlap=0.9, max_normal_angle=1.0, degeneracy=1e-3, constraint=bound, weights=times)
reg.registration_ransac_based_on_correspondence(source=source, target=target, corres=corres, max_correspondence_distance=0.2, estimation_method=to_points, ransac_n=3, checkers=[by_distance], num_iterations=100, confidence=0.9, seed=0)
reg.registration_robust_based_on_correspondence(source=source, target=target, corres=corres, noise_bound=0.1, seed=0)
reg.registration_ndt(source=source, target=target, option=distributions, init=pose, degeneracy=0.005)
reg.run_odometry(scans=[source, source], timestamps=None, imu=None, progress=None, device="cpu", columns=["x", "y", "z"])
reg.scale_from_known(model=model, a="a", b=three, distance=1.0)
reg.TargetObservation(station=0, name="A", position=three, sigma=0.1)
reg.ControlPoint(name="A", position=three, sigma=0.1)
reg.register_stations(stations=[source], poses=[pose], positions=[three], position_sigma=0.1, rough=1.0, level_sigma=0.1, targets=[seen], control=[held], names=["A"], voxel_size=0.1, overlap=0.2, reference=0, seed=0, progress=None)
reg.write_pose_graph(path="graph.json", pose_graph=graph)
"""  # noqa: E501
HOMES = {"odometry()": "LidarOdometry", "slam()": "LidarSLAM"}
RESULTS = {
    "Deformation", "DriftResult", "ErrorStatistics", "FragmentPair", "FragmentsResult", "GlobalOptimizationReport",
    "LidarLoop", "LidarSLAMSummary", "LidarSubmap", "Localizability", "Localization", "NonRigidResult",
    "OdometryStep", "OdometrySummary", "PairRegistration",
    "SegmentError", "SimilarityFit", "StationPair", "StationsResult", "TrajectoryError",
}  # fmt: skip
MAY_BE_INFINITE = {("GeneralizedLoss", "shape"), ("PoseGraphEdge", "confidence")}  # the latter is checked later
TABLE = hostile.read_table(CALLS, HOMES)
PUBLIC = hostile.public_arguments(reg, RESULTS)
RECORDED = [name for name in sorted(PUBLIC) if name not in TABLE and has_record(name)]
CLOUDS_ONLY = {"source", "target", "cloud", "scan"}


@cache
def things() -> dict[str, Any]:
    rng = np.random.default_rng(0)
    points = rng.random((60, 3)) * [1, 1, 0.2]
    cloud = loom.PointCloud(points, colors=rng.random((60, 3)), dopplers=rng.random(60)).estimate_normals(max_nn=10)
    gps = hostile.temporary_folder() / "gps.txt"
    gps.write_text("a 1 0 0\nb 3 0 0\nc 1 2 0\nd 1 0 2\n")
    gnss, saved = hostile.temporary_folder() / "gnss.txt", hostile.temporary_folder() / "map"
    gnss.write_text("0 1 2 3\n1 2 3 4\n")
    slam_of(cloud, folder=saved)
    poses = np.tile(np.eye(4), (4, 1, 1))
    poses[1:, :3, 3] = -np.eye(3)
    lens = loom.CameraModel("PINHOLE", 16, 12, [10.0, 10.0, 8.0, 6.0])
    nodes, edge = [reg.PoseGraphNode(), reg.PoseGraphNode()], reg.PoseGraphEdge(0, 1)
    return dict(
        reg=reg, source=cloud, target=loom.PointCloud(points + 0.01, colors=rng.random((60, 3)), normals=cloud.normals),
        known=reg.Prior(np.eye(4), sigma_translation=1.0), axes=np.eye(3), bound=reg.Constraint(["x", "yaw"]),
        pose=np.eye(4), corres=np.tile(np.arange(60)[:, None], (1, 2)), three=np.array([0.5, 0.5, 0.5]),
        readings=loom.ImuReadings(np.linspace(0, 1, 60), np.zeros((60, 3)), np.zeros((60, 3))),
        times=np.linspace(0, 1, 60), features=rng.random((60, 5)).astype(np.float32), node=nodes[0],
        information=np.eye(6), graph=reg.PoseGraph(nodes, [edge]), trajectory=loom.Trajectory([np.eye(4)] * 3),
        rules=reg.ICPConvergenceCriteria(max_iteration=3),
        distributions=reg.NormalDistributionsTransformOption(0.5, max_iteration=3),
        option=reg.GlobalOptimizationOption(),
        criteria=reg.GlobalOptimizationConvergenceCriteria(max_iteration=3),
        to_points=reg.TransformationEstimationPointToPoint(), l2=reg.L2Loss(),
        tukey=reg.TukeyLoss(0.1), by_distance=reg.CorrespondenceCheckerBasedOnDistance(0.5),
        model=loom.SfmModel(["a", "b", "c", "d"], [lens] * 4, poses), gps=str(gps),
        positions={"a": (1, 0, 0), "b": (3, 0, 0), "c": (1, 2, 0), "d": (1, 0, 2)},
        seen=reg.TargetObservation(0, "A", [1.0, 0.5, 0.2]), held=reg.ControlPoint("A", [1.0, 0.5, 0.2]),
        odometry=lambda: reg.LidarOdometry(max_range=10.0, min_range=0.01), slam=lambda: slam_of(cloud),
        saved=str(saved), gnss=str(gnss), track=rng.random((60, 3)),
        located=reg.PositionReadings(np.linspace(0, 1, 60), np.zeros((60, 3))),
    )  # fmt: skip


def slam_of(cloud: loom.PointCloud, folder: Path | None = None) -> Any:
    slam = reg.LidarSLAM(max_range=10.0, min_range=0.01, folder=folder)
    slam.register(cloud)
    slam.finish()
    return slam


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)


def test_every_argument_of_every_public_call_is_in_the_table_or_a_record():
    missing = hostile.missing_from(TABLE, {name: PUBLIC[name] for name in PUBLIC if name not in RECORDED})
    assert missing == {}, "add a record in benchmarks/operations_on_clouds.py or operations_on_scenes.py"


@pytest.mark.parametrize("call", RECORDED)
def test_a_hostile_value_in_a_recorded_call_is_rejected_by_name(call):
    faults = faults_of_recorded(call, PUBLIC[call], CLOUDS_ONLY)
    assert not faults, "\n".join(faults)


@pytest.mark.filterwarnings("ignore::pointloom.DroppedResultWarning")
@pytest.mark.parametrize("call", TABLE)
def test_valid_arguments_are_accepted(call):
    function, expressions = TABLE[call]
    values = dict(things())
    good = {name: eval(expression, values) for name, expression in expressions.items()}
    with contextlib.suppress(loom.FileError):  # of files that do not exist
        eval(function, values)(**good)


CASES = [(call, name) for call, (_, names) in TABLE.items() for name, good in names.items() if good != "True"]
# Accepted values run a full registration each. The forms of ICP share the checks of their common arguments.
FORMS = ("registration_icp_batch", "multi_scale_icp")
EXPENSIVE = {(call, name) for call in FORMS for name in TABLE[call][1] if name in set(TABLE["registration_icp"][1])}
for call, names in (
    ("register_stations", "rough voxel_size overlap position_sigma level_sigma seed"),
    ("register_nonrigid", "max_correspondence_distance landmark_weight stiffness tolerance"),
    ("register_pair", "init max_correspondence_distance constraint"),
):
    EXPENSIVE |= {(call, name) for name in names.split()}
EXPENSIVE &= set(CASES)


def marked(values, expensive):
    assert {*values} >= expensive
    return [
        pytest.param(*np.atleast_1d(value).tolist(), marks=pytest.mark.slow if value in expensive else ())
        for value in values
    ]


@pytest.mark.parametrize(("call", "argument"), marked(CASES, EXPENSIVE))
def test_a_hostile_value_is_rejected_by_name(call, argument):
    check_argument(call, argument, every=(call, argument) in EXPENSIVE)


@pytest.mark.slow
@pytest.mark.parametrize("call", TABLE)
def test_all_hostile_values_are_rejected_by_name(call):
    for case in CASES:
        if case[0] == call and case not in EXPENSIVE:
            check_argument(*case, every=True)


def check_argument(call, argument, every):
    function, expressions = TABLE[call]
    values = things()
    good = {name: eval(expression, dict(values)) for name, expression in expressions.items()}
    kinds = {"clouds": argument in CLOUDS_ONLY, "finite": (call, argument) not in MAY_BE_INFINITE, "every": every}
    faults = hostile.faults_of(hostile.call_of(function, values), good, argument, **kinds)
    assert not faults, "\n".join(faults)


CLOUDS = ("source", "target")


@pytest.mark.parametrize("call", marked(hostile.calls_of_clouds(TABLE, CLOUDS), {"register_stations", *FORMS}))
def test_a_hostile_cloud_causes_no_warning(call):
    faults = hostile.faults_of_clouds(TABLE[call], CLOUDS, things())
    assert not faults, "\n".join(faults)


@pytest.mark.slow_on_emulated_cuda("checks of the host alone")
@pytest.mark.parametrize("call", [*TABLE, *RECORDED])
def test_a_mesh_as_a_cloud_names_the_conversion(call):
    if call in TABLE:
        function, values = TABLE[call][0], dict(things())
        arguments = {n: eval(good, values) for n, good in TABLE[call][1].items()}
        faults = hostile.faults_of_exchange(hostile.call_of(function, values), arguments)
    else:
        faults = hostile.faults_of_exchange(*valid_call(call))
    assert not faults, "\n".join(faults)
