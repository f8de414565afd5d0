"""Open3D's documentation, "Colored point cloud registration", on two frames of a synthetic room."""

import copy

import numpy as np
import open3d as o3d


def draw_registration_result_original_color(source, target, transformation):
    source_temp = copy.deepcopy(source)
    source_temp.transform(transformation)
    o3d.visualization.draw_geometries([source_temp, target])


source = o3d.io.read_point_cloud("0.pcd")
target = o3d.io.read_point_cloud("1.pcd")
current_transformation = np.identity(4)
draw_registration_result_original_color(source, target, current_transformation)

voxel_radius = [0.2, 0.1, 0.05]
max_iter = [50, 30, 14]
results = {}
for scale in range(3):
    radius, near = voxel_radius[scale], o3d.geometry.KDTreeSearchParamHybrid(radius=voxel_radius[scale] * 2, max_nn=30)
    source_down = source.voxel_down_sample(radius)
    target_down = target.voxel_down_sample(radius)
    source_down.estimate_normals(near)
    target_down.estimate_normals(near)
    reg = o3d.pipelines.registration
    criteria = reg.ICPConvergenceCriteria(relative_fitness=1e-6, relative_rmse=1e-6, max_iteration=max_iter[scale])
    method = reg.TransformationEstimationForColoredICP()
    result_icp = reg.registration_colored_icp(
        source_down, target_down, radius, current_transformation, method, criteria
    )
    current_transformation = result_icp.transformation
    print(result_icp)
    results |= {f"fitness {scale}": result_icp.fitness, f"rmse {scale}": result_icp.inlier_rmse}
draw_registration_result_original_color(source, target, result_icp.transformation)
results |= {"transformation": result_icp.transformation, "pairs": len(result_icp.correspondence_set)}
