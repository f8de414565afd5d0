"""Open3D's documentation, "ICP registration", on two frames of a synthetic room."""

import copy

import numpy as np
import open3d as o3d


def draw_registration_result(source, target, transformation):
    source_temp, target_temp = copy.deepcopy(source), copy.deepcopy(target)
    source_temp.paint_uniform_color([1, 0.706, 0])
    target_temp.paint_uniform_color([0, 0.651, 0.929])
    source_temp.transform(transformation)
    view = {"front": [0.9288, -0.2951, -0.2242], "lookat": [1.6784, 2.0612, 1.4451], "up": [-0.3402, -0.9189, -0.1996]}
    o3d.visualization.draw_geometries([source_temp, target_temp], zoom=0.4459, **view)


source = o3d.io.read_point_cloud("0.pcd").uniform_down_sample(3)
target = o3d.io.read_point_cloud("1.pcd").uniform_down_sample(3)
target.estimate_normals()
threshold = 0.1
rows = [0.999, -0.03, 0.03, 0.02], [0.03, 0.999, -0.02, -0.02], [-0.03, 0.02, 0.999, 0.03], [0, 0, 0, 1]
trans_init = np.asarray(rows)
trans_init[:3, :3] = np.linalg.qr(trans_init[:3, :3])[0] * np.sign(np.diag(np.linalg.qr(trans_init[:3, :3])[1]))
draw_registration_result(source, target, trans_init)

reg = o3d.pipelines.registration
evaluation = reg.evaluate_registration(source, target, threshold, trans_init)
print(evaluation)

point_to_point = reg.TransformationEstimationPointToPoint()
reg_p2p = reg.registration_icp(source, target, threshold, trans_init, point_to_point)
print(reg_p2p)
print(reg_p2p.transformation)
draw_registration_result(source, target, reg_p2p.transformation)

criteria = reg.ICPConvergenceCriteria(max_iteration=2000)
reg_p2p_long = reg.registration_icp(source, target, threshold, trans_init, point_to_point, criteria)

point_to_plane = reg.TransformationEstimationPointToPlane()
reg_p2l = reg.registration_icp(source, target, threshold, trans_init, point_to_plane)
print(reg_p2l)
draw_registration_result(source, target, reg_p2l.transformation)
information = reg.get_information_matrix_from_point_clouds(source, target, threshold, reg_p2l.transformation)

pairs = np.asarray(evaluation.correspondence_set)
results = {"evaluation": str(evaluation), "pairs": pairs, "information": information}
for name, result in {"p2p": reg_p2p, "p2p long": reg_p2p_long, "p2l": reg_p2l}.items():
    results |= {f"{name} fitness": result.fitness, f"{name} rmse": result.inlier_rmse, name: result.transformation}
