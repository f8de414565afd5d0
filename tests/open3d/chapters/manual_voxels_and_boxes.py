import numpy as np
import open3d as o3d

mesh = o3d.io.read_triangle_mesh("bunny.ply")
mesh.scale(1 / np.max(mesh.get_max_bound() - mesh.get_min_bound()), center=mesh.get_center())
pcd = o3d.io.read_point_cloud("fragment.ply")
voxel_grid = o3d.geometry.VoxelGrid.create_from_point_cloud(pcd, voxel_size=0.2)
voxels = voxel_grid.get_voxels()
index = np.array([voxel.grid_index for voxel in voxels])
order = np.lexsort(index.T)
results = {"said": str(voxel_grid), "indices": index[order]}
results["colors"] = np.array([voxel.color for voxel in voxels])[order]
results["grid"] = [*voxel_grid.origin, voxel_grid.voxel_size, *voxel_grid.get_center(), *voxel_grid.get_max_bound()]
queries = np.asarray(pcd.points)[:100]
output = voxel_grid.check_if_included(o3d.utility.Vector3dVector(queries))
results["included"] = output[:10]
o3d.visualization.draw_geometries([voxel_grid])
of_mesh = o3d.geometry.VoxelGrid.create_from_triangle_mesh(mesh, voxel_size=0.1)
index = np.array([voxel.grid_index for voxel in of_mesh.get_voxels()])
results["voxels of the mesh"] = index[np.lexsort(index.T)]
box = o3d.geometry.OrientedBoundingBox.create_from_points(pcd.points)
results["box"] = [box.get_center(), np.sort(box.extent)]
box.R = np.eye(3)
box.extent = [1, 2, 3]
results["cropped"] = np.asarray(pcd.crop(box).points)
lines = o3d.geometry.LineSet.create_from_oriented_bounding_box(box)
results["edges"] = np.asarray(lines.points)
corners, edges = o3d.utility.Vector3dVector(np.eye(3)), o3d.utility.Vector2iVector([[0, 1], [1, 2]])
lines = o3d.geometry.LineSet(points=corners, lines=edges)
lines.colors = o3d.utility.Vector3dVector([[1, 0, 0], [0, 1, 0]])
lines.translate([0, 0, 1])
results["lines"] = [*np.asarray(lines.points), *np.asarray(lines.colors)]
aligned = pcd.get_axis_aligned_bounding_box()
results["inside"] = len(aligned.get_point_indices_within_bounding_box(pcd.points))
keypoints = o3d.geometry.keypoint.compute_iss_keypoints(mesh.sample_points_uniformly(10))
results["keypoints"] = bool(len(keypoints.points) <= 10)
pcd.points = mesh.vertices
keypoints = o3d.geometry.keypoint.compute_iss_keypoints(pcd, salient_radius=0.15, non_max_radius=0.1)
results["keypoints of the mesh"] = np.asarray(keypoints.points)
tetra_mesh, pt_map = o3d.geometry.TetraMesh.create_from_point_cloud(pcd)
for alpha in (0.3, 0.1):
    shape = o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(pcd, alpha, tetra_mesh, pt_map)
    results[f"alpha {alpha}"] = len(shape.triangles)
