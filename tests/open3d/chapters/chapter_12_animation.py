import numpy as np
import open3d as o3d

source = o3d.io.read_point_cloud("0.pcd")
target = o3d.io.read_point_cloud("1.pcd")
trans = np.asarray([[1, 0, 0, -0.05], [0, 1, 0, 0.05], [0, 0, 1, 0.02], [0.0, 0.0, 0.0, 1.0]])
source.transform(trans)
vis = o3d.visualization.Visualizer()
vis.create_window()
vis.add_geometry(source)
vis.add_geometry(target)
points = np.asarray(source.points)
results = {}
for i in range(3):
    reg = o3d.pipelines.registration
    method, criteria = reg.TransformationEstimationPointToPoint(), reg.ICPConvergenceCriteria(max_iteration=1)
    result = reg.registration_icp(source, target, 0.05, np.eye(4), method, criteria)
    source.transform(result.transformation)
    vis.update_geometry(source)
    vis.poll_events()
    vis.update_renderer()
    results[f"step {i}"] = [result.fitness, result.inlier_rmse]
vis.destroy_window()
results["points"] = points  # assigned before the steps: they follow
