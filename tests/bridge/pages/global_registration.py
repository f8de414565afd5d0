"""Open3D's documentation, "Global registration", on two frames of a made room, one of them turned and moved."""

import copy

import numpy as np
import open3d as o3d


def draw_registration_result(source, target, transformation):
    source_temp = copy.deepcopy(source)
    target_temp = copy.deepcopy(target)
    source_temp.paint_uniform_color([1, 0.706, 0])
    target_temp.paint_uniform_color([0, 0.651, 0.929])
    source_temp.transform(transformation)
    o3d.visualization.draw_geometries([source_temp, target_temp])


def preprocess_point_cloud(pcd, voxel_size):
    pcd_down = pcd.voxel_down_sample(voxel_size)
    radius_normal = voxel_size * 2
    pcd_down.estimate_normals(o3d.geometry.KDTreeSearchParamHybrid(radius=radius_normal, max_nn=30))
    pcd_down.orient_normals_towards_camera_location()
    radius_feature = voxel_size * 5
    pcd_fpfh = o3d.pipelines.registration.compute_fpfh_feature(
        pcd_down, o3d.geometry.KDTreeSearchParamHybrid(radius=radius_feature, max_nn=100)
    )
    return pcd_down, pcd_fpfh


def prepare_dataset(voxel_size):
    source = o3d.io.read_point_cloud("0.pcd")
    target = o3d.io.read_point_cloud("1.pcd")
    source_down, source_fpfh = preprocess_point_cloud(source, voxel_size)
    target_down, target_fpfh = preprocess_point_cloud(target, voxel_size)
    trans_init = np.asarray([[0.0, 0.0, 1.0, 0.0], [1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0]])
    source.transform(trans_init)
    source_down.transform(trans_init)
    draw_registration_result(source, target, np.identity(4))
    return source, target, source_down, target_down, source_fpfh, target_fpfh, trans_init


voxel_size = 0.099  # no multiple of two millimetres, on which depths lie: voxels' faces go between them
source, target, source_down, target_down, source_fpfh, target_fpfh, moved = prepare_dataset(voxel_size)


def execute_global_registration(source_down, target_down, source_fpfh, target_fpfh, voxel_size):
    distance_threshold = voxel_size * 1.5
    return o3d.pipelines.registration.registration_ransac_based_on_feature_matching(
        source_down,
        target_down,
        source_fpfh,
        target_fpfh,
        True,
        distance_threshold,
        o3d.pipelines.registration.TransformationEstimationPointToPoint(False),
        3,
        [
            o3d.pipelines.registration.CorrespondenceCheckerBasedOnEdgeLength(0.9),
            o3d.pipelines.registration.CorrespondenceCheckerBasedOnDistance(distance_threshold),
        ],
        o3d.pipelines.registration.RANSACConvergenceCriteria(100000, 0.999),
    )


result_ransac = execute_global_registration(source_down, target_down, source_fpfh, target_fpfh, voxel_size)
print(result_ransac)
draw_registration_result(source_down, target_down, result_ransac.transformation)


def refine_registration(source, target, voxel_size):
    distance_threshold = voxel_size * 0.4
    return o3d.pipelines.registration.registration_icp(
        source,
        target,
        distance_threshold,
        result_ransac.transformation,
        o3d.pipelines.registration.TransformationEstimationPointToPlane(),
        o3d.pipelines.registration.ICPConvergenceCriteria(max_iteration=200),
    )


target.estimate_normals()
result_icp = refine_registration(source, target, voxel_size)
print(result_icp)
draw_registration_result(source, target, result_icp.transformation)


def execute_fast_global_registration(source_down, target_down, source_fpfh, target_fpfh, voxel_size):
    distance_threshold = voxel_size * 0.5
    return o3d.pipelines.registration.registration_fgr_based_on_feature_matching(
        source_down,
        target_down,
        source_fpfh,
        target_fpfh,
        o3d.pipelines.registration.FastGlobalRegistrationOption(maximum_correspondence_distance=distance_threshold),
    )


result_fast = execute_fast_global_registration(source_down, target_down, source_fpfh, target_fpfh, voxel_size)
print(result_fast)
draw_registration_result(source_down, target_down, result_fast.transformation)

places = np.lexsort(np.round(np.asarray(target_down.points), 6).T)
matches = o3d.pipelines.registration.correspondences_from_features(source_fpfh, target_fpfh, True)
found = {
    "icp": result_icp.transformation,
    "icp fitness": result_icp.fitness,
    "target features": target_fpfh.data[:, places],
    "dimension": source_fpfh.dimension(),
    "features": source_fpfh.num(),
    "matches": len(np.asarray(matches)),
    "poses": {"ransac": result_ransac.transformation @ moved, "fast": result_fast.transformation @ moved},
}
