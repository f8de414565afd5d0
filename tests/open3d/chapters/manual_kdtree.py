import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("fragment.ply")
pcd.paint_uniform_color([0.5, 0.5, 0.5])
pcd_tree = o3d.geometry.KDTreeFlann(pcd)
pcd.colors[1500] = [1, 0, 0]
[k, idx, d2] = pcd_tree.search_knn_vector_3d(pcd.points[1500], 200)
np.asarray(pcd.colors)[idx[1:], :] = [0, 0, 1]
results = {"knn": list(idx), "squared": np.asarray(d2), "k": k}
[k, idx, _] = pcd_tree.search_radius_vector_3d(pcd.points[1500], 0.2)
np.asarray(pcd.colors)[idx[1:], :] = [0, 1, 0]
results["radius"] = list(idx)
[k, idx, _] = pcd_tree.search_hybrid_vector_3d(pcd.points[700], 0.2, 20)
results["hybrid"] = list(idx)
results["colors"] = np.asarray(pcd.colors)
o3d.visualization.draw_geometries([pcd])
parameters = o3d.geometry.KDTreeSearchParamHybrid(0.1, 5)
results["by parameter"] = list(pcd_tree.search_vector_3d(pcd.points[3], parameters)[1])
results["said"] = f"{parameters} {o3d.geometry.KDTreeSearchParamKNN()} {o3d.geometry.KDTreeSearchParamRadius(0.5)}"
high = np.random.default_rng(0).random((33, 100))
results["columns"] = list(o3d.geometry.KDTreeFlann(high).search_knn_vector_xd(high[:, 7], 4)[1])
