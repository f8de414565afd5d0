import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("./street.pcd")
downpcd = pcd.voxel_down_sample(voxel_size=1)
points = np.asarray(downpcd.points)
order = np.lexsort(np.round(points, 4).T)  # voxels are not ordered
results = {"voxels": points[order]}
downpcd.estimate_normals(search_param=o3d.geometry.KDTreeSearchParamHybrid(radius=5, max_nn=40))
downpcd.orient_normals_to_align_with_direction([0.36, 0.48, 0.8])
results["normals"] = np.asarray(downpcd.normals)[order]
results["count"] = len(downpcd.normals)
results["a point is a row"] = bool(downpcd.points[0].shape == (3,) == downpcd.normals[0].shape)
o3d.visualization.draw_geometries([downpcd])
