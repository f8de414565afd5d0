import copy

import numpy as np
import open3d as o3d

x = np.linspace(-3, 3, 41)
mesh_x, mesh_y = np.meshgrid(x, x)
z = np.sinc(np.power(mesh_x, 2) + np.power(mesh_y, 2))
xyz = np.stack([mesh_x.ravel(), mesh_y.ravel(), z.ravel()], axis=1)
pcd = o3d.geometry.PointCloud()
pcd.points = o3d.utility.Vector3dVector(xyz)
results = {"said": f"{pcd} {pcd.points}", "points": np.asarray(pcd.points)}
xyz_load = np.asarray(pcd.points)
results["exact"] = bool((xyz_load == xyz).all())
o3d.visualization.draw_geometries([pcd])

mesh = o3d.geometry.TriangleMesh.create_coordinate_frame()
mesh_tx = copy.deepcopy(mesh).translate((1.3, 0, 0))
mesh_ty = copy.deepcopy(mesh).translate((0, 1.3, 0))
results["centers"] = [mesh.get_center(), mesh_tx.get_center(), mesh_ty.get_center()]
mesh_mv = copy.deepcopy(mesh).translate((2, 2, 2), relative=False)
results["moved"] = mesh_mv.get_center()
mesh_r = copy.deepcopy(mesh)
R = mesh.get_rotation_matrix_from_xyz((np.pi / 2, 0, np.pi / 4))
mesh_r.rotate(R, center=(0, 0, 0))
results["R"], results["rotated"] = R, np.asarray(mesh_r.vertices)
mesh_s = copy.deepcopy(mesh).translate((2, 0, 0))
mesh_s.scale(0.5, center=mesh_s.get_center())
results["scaled"] = np.asarray(mesh_s.vertices)
T = np.eye(4)
T[:3, :3] = mesh.get_rotation_matrix_from_xyz((0, np.pi / 3, np.pi / 2))
T[0, 3], T[1, 3] = 1, 1.3
mesh_t = copy.deepcopy(mesh).transform(T)
results["transformed"] = np.asarray(mesh_t.vertices)
o3d.visualization.draw_geometries([mesh, mesh_t])

pcd.estimate_normals(o3d.geometry.KDTreeSearchParamRadius(0.47))
pcd.orient_normals_to_align_with_direction()
results["normals"] = np.asarray(pcd.normals)
mean, covariance = pcd.compute_mean_and_covariance()
results["mean"], results["covariance"] = mean, covariance
results["spacing"] = np.asarray(pcd.compute_nearest_neighbor_distance())
results["mahalanobis"] = np.asarray(pcd.compute_mahalanobis_distance())
down, ids, rows = pcd.voxel_down_sample_and_trace(0.5, pcd.get_min_bound(), pcd.get_max_bound(), False)
results["trace"] = [len(down.points), len(rows), sum(map(len, rows))]
results["farthest"] = np.asarray(pcd.farthest_point_down_sample(20).points)
results["patches"] = len(pcd.select_by_index(range(200)).points)
both = pcd + mesh_t.sample_points_uniformly(100)
results["both"] = f"{both} {both.has_normals()} {both.has_colors()}"
