import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("street.pcd")
results = {"before": len(pcd.points)}
pcd = pcd.uniform_down_sample(every_k_points=5)
results["after"] = np.asarray(pcd.points)


def display_inlier_outlier(pcd, ind):
    inlier_cloud = pcd.select_by_index(ind)
    outlier_cloud = pcd.select_by_index(ind, invert=True)
    outlier_cloud.paint_uniform_color([1, 0, 0])
    inlier_cloud.paint_uniform_color([0.8, 0.8, 0.8])
    o3d.visualization.draw_geometries([inlier_cloud, outlier_cloud])
    return inlier_cloud + outlier_cloud


pcd = o3d.io.read_point_cloud("street.pcd")
pcd = pcd.uniform_down_sample(every_k_points=2)
cl, ind = pcd.remove_statistical_outlier(nb_neighbors=20, std_ratio=2.0)
results["statistical"] = ind
results["colors"] = np.asarray(display_inlier_outlier(pcd, ind).colors)
cl, ind = pcd.remove_radius_outlier(nb_points=10, radius=1.0)
results["radius"] = ind
results["kept"] = np.asarray(cl.points)
