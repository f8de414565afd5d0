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


source = o3d.io.read_point_cloud("0.pcd")
target = o3d.io.read_point_cloud("1.pcd")
threshold = 0.05
trans_init = np.asarray([[1, 0, 0, -0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0.0, 0.0, 0.0, 1.0]])
before = np.asarray(source.points).copy()
draw_registration_result(source, target, trans_init)
found = {"source stays": bool((np.asarray(source.points) == before).all())}
evaluation = o3d.pipelines.registration.evaluate_registration(source, target, threshold, trans_init)
found["before"] = [evaluation.fitness, evaluation.inlier_rmse]
reg_p2p = o3d.pipelines.registration.registration_icp(
    source,
    target,
    threshold,
    trans_init,
    o3d.pipelines.registration.TransformationEstimationPointToPoint(),
    o3d.pipelines.registration.ICPConvergenceCriteria(max_iteration=60),
)
found["after"] = [reg_p2p.fitness, reg_p2p.inlier_rmse]
found["pose"] = reg_p2p.transformation
pairs = np.asarray(reg_p2p.correspondence_set)
found["a pair an inlier"] = bool(len(pairs) == round(reg_p2p.fitness * len(source.points)))
