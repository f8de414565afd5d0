"""Open3D's documentation, "Non-blocking visualization": ICP while a window follows."""

import numpy as np
import open3d as o3d

source_raw = o3d.io.read_point_cloud("0.pcd")
target_raw = o3d.io.read_point_cloud("1.pcd")
source = source_raw.voxel_down_sample(voxel_size=0.047)
target = target_raw.voxel_down_sample(voxel_size=0.047)
trans = [[0.999, -0.04, 0.0, 0.05], [0.04, 0.999, 0.0, -0.03], [0.0, 0.0, 1.0, 0.04], [0.0, 0.0, 0.0, 1.0]]
source.transform(trans)

flip_transform = [[1, 0, 0, 0], [0, -1, 0, 0], [0, 0, -1, 0], [0, 0, 0, 1]]
source.transform(flip_transform)
target.transform(flip_transform)
target.estimate_normals()

vis = o3d.visualization.Visualizer()
vis.create_window()
vis.add_geometry(source)
vis.add_geometry(target)
threshold = 0.1
icp_iteration = 12
save_image = False

for i in range(icp_iteration):
    reg_p2l = o3d.pipelines.registration.registration_icp(
        source,
        target,
        threshold,
        np.identity(4),
        o3d.pipelines.registration.TransformationEstimationPointToPlane(),
        o3d.pipelines.registration.ICPConvergenceCriteria(max_iteration=1),
    )
    source.transform(reg_p2l.transformation)
    vis.update_geometry(source)
    vis.poll_events()
    vis.update_renderer()
    if save_image:
        vis.capture_screen_image(f"temp_{i:04d}.jpg")
depth = np.asarray(vis.capture_depth_float_buffer(True))
vis.destroy_window()

found = {
    "depth": np.median(depth[depth > 0]),
    "fitness": reg_p2l.fitness,
    "rmse": reg_p2l.inlier_rmse,
    "step": reg_p2l.transformation,
    "middle": source.get_center(),
    "spread": np.asarray(source.points).std(axis=0),
}
