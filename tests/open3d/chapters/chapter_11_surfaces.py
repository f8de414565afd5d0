import numpy as np
import open3d as o3d

o3d.utility.random.seed(0)
bunny = o3d.io.read_triangle_mesh("bunny.ply")
bunny.compute_vertex_normals()
pcd = bunny.sample_points_poisson_disk(500)
results = {"samples": len(pcd.points), "they have normals": bool(pcd.has_normals())}

pcd = o3d.geometry.PointCloud()  # the vertices: both packages reconstruct the same points
pcd.points, pcd.normals = bunny.vertices, bunny.vertex_normals
size = np.linalg.norm(pcd.get_max_bound() - pcd.get_min_bound())
mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(pcd, size / 12)
mesh.compute_vertex_normals()
results["alpha shape"] = str(mesh)
o3d.visualization.draw_geometries([mesh], mesh_show_back_face=True)

radii = np.mean(pcd.compute_nearest_neighbor_distance()) * np.array([3, 6, 12])
rec_mesh = o3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(pcd, o3d.utility.DoubleVector(radii))
results["balls reach the surface"] = bool(rec_mesh.get_surface_area() > 0.85 * bunny.get_surface_area())

with o3d.utility.VerbosityContextManager(o3d.utility.VerbosityLevel.Error) as cm:
    mesh, densities = o3d.geometry.TriangleMesh.create_from_point_cloud_poisson(pcd, depth=5)
mesh.paint_uniform_color([1, 0.706, 0])
results["Poisson's area"] = mesh.get_surface_area()
densities = np.asarray(densities)
results["a density a vertex"] = bool(len(densities) == len(mesh.vertices))
shade = (densities - densities.min()) / (densities.max() - densities.min())
density_mesh = o3d.geometry.TriangleMesh()
density_mesh.vertices = mesh.vertices
density_mesh.triangles = mesh.triangles
density_mesh.triangle_normals = mesh.triangle_normals
density_mesh.vertex_colors = o3d.utility.Vector3dVector(np.column_stack([shade, 1 - shade, shade]))
results["the shaded mesh is the same"] = bool(len(density_mesh.triangles) == len(mesh.triangles))
results["it is shaded"] = bool(density_mesh.has_vertex_colors())
o3d.visualization.draw_geometries([density_mesh])
vertices_to_remove = densities < np.quantile(densities, 0.1)
before = len(mesh.vertices)
mesh.remove_vertices_by_mask(vertices_to_remove)
results["the thin part goes"] = bool(len(mesh.vertices) == before - vertices_to_remove.sum())
