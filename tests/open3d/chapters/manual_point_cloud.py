import numpy as np
import open3d as o3d

pcd = o3d.io.read_point_cloud("fragment.ply")
limits = {"normal_variance_threshold_deg": 60, "coplanarity_deg": 75, "outlier_ratio": 0.75}
near = o3d.geometry.KDTreeSearchParamKNN(knn=30)
oboxes = pcd.detect_planar_patches(**limits, min_plane_edge_length=0, min_num_points=0, search_param=near)
results = {"there are patches": bool(len(oboxes) > 1 and oboxes[0].volume() >= 0)}
meshes = [o3d.geometry.TriangleMesh.create_from_oriented_bounding_box(box, scale=[1, 1, 0.1]) for box in oboxes]
results["a box of each"] = bool(all(len(mesh.triangles) == 12 for mesh in meshes))
o3d.visualization.draw_geometries([oboxes[0], pcd])

few = pcd.uniform_down_sample(8)
few.orient_normals_consistent_tangent_plane(12)
along = (np.asarray(few.normals) * np.asarray(few.points)).sum(axis=1)
results["a side each"] = bool(few.has_normals() and len(along) == len(few.points))
few.estimate_covariances(o3d.geometry.KDTreeSearchParamKNN(12))
results["covariances"] = np.asarray(few.covariances)
results["of points"] = np.asarray(o3d.geometry.PointCloud.estimate_point_covariances(few))[:5]

points = np.array([[0, 0, 0], [0, 0, 0], [1, np.nan, 0], [2, 0, np.inf], [3, 3, 3]])
dirty = o3d.geometry.PointCloud(o3d.utility.Vector3dVector(points))
dirty.remove_non_finite_points()
results["finite"] = np.array(dirty.points)
dirty.remove_duplicated_points()
results["distinct"] = np.asarray(dirty.points)
results["bounds"] = [dirty.get_min_bound(), dirty.get_max_bound(), dirty.get_center()]
results["questions"] = f"{dirty.has_points()} {dirty.has_normals()} {dirty.has_colors()} {dirty.is_empty()}"
o3d.utility.random.seed(1)
results["half"] = len(pcd.random_down_sample(0.5).points)
smooth = pcd.smooth_laplacian(iterations=2, knn=10)
results["smooth"] = np.asarray(smooth.points)
box = o3d.geometry.AxisAlignedBoundingBox([-1, -1, 0], [1, 1, 3])
results["in"], results["out"] = len(pcd.crop(box).points), len(pcd.crop(box, invert=True).points)
combined = o3d.geometry.PointCloud()
for part in (pcd, few, pcd):
    combined += part
results["combined"] = f"{combined} {combined.has_colors()} {combined.has_normals()}"
combined.clear()
results["cleared"] = f"{combined} {combined.is_empty()}"
