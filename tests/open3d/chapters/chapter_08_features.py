import copy

import numpy as np
import open3d as o3d


def preprocess_point_cloud(pcd, voxel_size):
    pcd_down = pcd.voxel_down_sample(voxel_size)
    pcd_down.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(radius=voxel_size * 2, max_nn=30))
    pcd_down.orient_normals_towards_camera_location()
    near = o3d.geometry.KDTreeSearchParamHybrid(radius=voxel_size * 5, max_nn=100)
    pcd_fpfh = o3d.pipelines.registration.compute_fpfh_feature(pcd_down, near)
    return pcd_down, pcd_fpfh


def off(transformation):
    return np.abs(transformation @ truth - np.eye(4)).max()


voxel_size = 0.12
target = o3d.io.read_point_cloud("0.pcd")
source = copy.deepcopy(target)
rotation = o3d.geometry.get_rotation_matrix_from_xyz((0.3, -0.4, 0.5))
truth = np.eye(4)
truth[:3, :3], truth[:3, 3] = rotation, [0.5, -0.2, 0.3]
source.transform(truth)
target_down, target_fpfh = preprocess_point_cloud(target, voxel_size)
results = {"features": [target_fpfh.dimension(), target_fpfh.num()]}
sums = target_fpfh.data.sum(axis=0)  # three histograms of 100 and the 100 of their neighbors
results["each histogram is whole"] = bool(np.abs(sums - 600).max() < 1e-3)
source_down = copy.deepcopy(target_down).transform(truth)
near = o3d.geometry.KDTreeSearchParamHybrid(radius=voxel_size * 5, max_nn=100)
source_fpfh = o3d.pipelines.registration.compute_fpfh_feature(source_down, near)
matches = np.asarray(o3d.pipelines.registration.correspondences_from_features(source_fpfh, target_fpfh, True))
results["most points match themselves"] = bool((matches[:, 0] == matches[:, 1]).mean() > 0.9)
o3d.utility.random.seed(3)
distance_threshold = voxel_size * 1.5
registration = o3d.pipelines.registration
both = source_down, target_down, source_fpfh, target_fpfh
method = registration.TransformationEstimationPointToPoint(False)
checkers = [registration.CorrespondenceCheckerBasedOnEdgeLength(0.9)]
checkers.append(registration.CorrespondenceCheckerBasedOnDistance(distance_threshold))
criteria = registration.RANSACConvergenceCriteria(10000)
match = registration.registration_ransac_based_on_feature_matching
result_ransac = match(*both, True, distance_threshold, method, 3, checkers, criteria)
results["RANSAC finds the pose"] = bool(off(result_ransac.transformation) < 0.1)
start, method = result_ransac.transformation, registration.TransformationEstimationPointToPoint()
criteria = registration.ICPConvergenceCriteria(max_iteration=100)
result_icp = registration.registration_icp(source_down, target_down, 0.1, start, method, criteria)
results["refined"] = bool(off(result_icp.transformation) < 1e-3 and result_icp.fitness > 0.99)
option = registration.FastGlobalRegistrationOption(maximum_correspondence_distance=voxel_size * 0.5)
result_fast = registration.registration_fgr_based_on_feature_matching(*both, option)
results["fast finds the pose"] = bool(off(result_fast.transformation) < 0.02)
