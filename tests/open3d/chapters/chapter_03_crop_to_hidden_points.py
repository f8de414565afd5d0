import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("fragment.ply")
vol = o3d.visualization.read_selection_polygon_volume("cropped.json")
chair = vol.crop_point_cloud(pcd)
chair.paint_uniform_color([1, 0.706, 0])  # [R, G, B]
dists = pcd.compute_point_cloud_distance(chair)
dists = np.asarray(dists)
ind = np.where(dists > 0.01)[0]
pcd_without_chair = pcd.select_by_index(ind)
results = {"chair": np.asarray(chair.points), "painted": np.asarray(chair.colors), "distances": dists}
results["left"] = len(pcd_without_chair.points)
aabb = chair.get_axis_aligned_bounding_box()
aabb.color = (1, 0, 0)
obb = chair.get_oriented_bounding_box()
obb.color = (0, 1, 0)
results["box"] = [aabb.min_bound, aabb.max_bound, aabb.color, obb.center, np.sort(obb.extent), obb.color]
results["volume"] = [aabb.volume(), obb.volume()]
o3d.visualization.draw_geometries([chair, aabb, obb])

mesh = o3d.io.read_triangle_mesh("bunny.ply")
mesh.compute_vertex_normals()
pcl = mesh.sample_points_poisson_disk(number_of_points=200)
hull, _ = pcl.compute_convex_hull()
hull_ls = o3d.geometry.LineSet.create_from_triangle_mesh(hull)
hull_ls.paint_uniform_color((1, 0, 0))
results["hull is closed"] = bool(2 * len(hull_ls.lines) == 3 * len(hull.triangles) and len(pcl.points) == 200)
results["lines are red"] = bool((np.asarray(hull_ls.colors) == [1, 0, 0]).all() and hull_ls.has_colors())
o3d.visualization.draw_geometries([pcl, hull_ls])

pcd = o3d.io.read_point_cloud("street.pcd")
pcd = pcd.voxel_down_sample(voxel_size=0.3)
with o3d.utility.VerbosityContextManager(o3d.utility.VerbosityLevel.Error) as cm:
    labels = np.array(pcd.cluster_dbscan(eps=0.8, min_points=8, print_progress=False))
max_label = labels.max()
results["clusters"] = int(max_label) + 1
results["sizes of clusters"] = np.sort(np.bincount(labels + 1))
colors = np.random.rand(len(labels), 3)
colors[labels < 0] = 0
pcd.colors = o3d.utility.Vector3dVector(colors[:, :3])
o3d.visualization.draw_geometries([pcd])

pcd = o3d.io.read_point_cloud("street.pcd")
plane_model, inliers = pcd.segment_plane(distance_threshold=0.1, ransac_n=3, num_iterations=1000)
[a, b, c, d] = plane_model
results["plane is the road"] = bool(abs(c) > 0.999 and abs(abs(d) - 1.6) < 0.02 and len(inliers) > 3000)
inlier_cloud = pcd.select_by_index(inliers)
inlier_cloud.paint_uniform_color([1, 0, 0])
outlier_cloud = pcd.select_by_index(inliers, invert=True)
results["parts"] = len(inlier_cloud.points) + len(outlier_cloud.points)
o3d.visualization.draw_geometries([inlier_cloud, outlier_cloud])

diameter = np.linalg.norm(np.asarray(pcd.get_max_bound()) - np.asarray(pcd.get_min_bound()))
camera = [0, 0, diameter]
radius = diameter * 1000
_, pt_map = pcd.hidden_point_removal(camera, radius)
results["visible"] = np.sort(pt_map)
pcd = pcd.select_by_index(pt_map)
o3d.visualization.draw_geometries([pcd])
