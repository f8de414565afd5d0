import numpy as np
import open3d as o3d

mesh = o3d.io.read_triangle_mesh("bunny.ply")
results = {"said": str(mesh), "vertices": np.array(mesh.vertices), "triangles": np.array(mesh.triangles)}
results["before"] = f"{mesh.has_triangle_normals()}"
mesh.compute_vertex_normals()
results["after"] = f"{mesh.has_vertex_normals()} {mesh.has_triangle_normals()}"
results["triangle normals"] = np.array(mesh.triangle_normals)
half = o3d.geometry.TriangleMesh(mesh)
half.triangles = o3d.utility.Vector3iVector(np.asarray(half.triangles)[: len(half.triangles) // 2, :])
half.triangle_normals = o3d.utility.Vector3dVector(np.asarray(half.triangle_normals)[: len(half.triangles), :])
results["half"] = f"{half} {half.has_triangle_normals()}"
half.paint_uniform_color([1, 0.706, 0])
results["colors"] = np.asarray(half.vertex_colors)
o3d.visualization.draw_geometries([half])


def check_properties(mesh):
    edges = [mesh.is_edge_manifold(allow_boundary_edges=allowed) for allowed in (True, False)]
    checks = [mesh.is_vertex_manifold(), mesh.is_self_intersecting(), mesh.is_watertight(), mesh.is_orientable()]
    return [*edges, *checks, len(mesh.get_non_manifold_edges(allow_boundary_edges=False))]


moebius = o3d.geometry.TriangleMesh.create_mobius(twists=1)
results["properties"] = [check_properties(half), check_properties(moebius), check_properties(mesh)]
results["area and volume"] = [mesh.get_surface_area(), mesh.get_volume(), mesh.euler_poincare_characteristic()]
parts, counts, areas = half.cluster_connected_triangles()
results["parts"] = [np.sort(counts), np.sort(np.round(counts))]
results["area of parts"] = np.sort(areas)
vertices_in = np.asarray(mesh.vertices).copy()
noisy = vertices_in + np.random.default_rng(0).uniform(-2e-3, 2e-3, size=vertices_in.shape)
mesh.vertices = o3d.utility.Vector3dVector(noisy)
results["simple"] = np.asarray(mesh.filter_smooth_simple(number_of_iterations=3).vertices)
results["laplacian"] = np.asarray(mesh.filter_smooth_laplacian(number_of_iterations=5).vertices)
results["taubin"] = np.asarray(mesh.filter_smooth_taubin(number_of_iterations=5).vertices)
results["sharpened"] = np.asarray(mesh.filter_sharpen(number_of_iterations=1, strength=1).vertices)
mesh.vertices = o3d.utility.Vector3dVector(vertices_in)
voxel_size = max(mesh.get_max_bound() - mesh.get_min_bound()) / 16
average = o3d.geometry.SimplificationContraction.Average
mesh_smp = mesh.simplify_vertex_clustering(voxel_size=voxel_size, contraction=average)
results["clustered"] = str(mesh_smp)
mesh_smp = mesh.simplify_quadric_decimation(target_number_of_triangles=600)
results["decimated"] = len(mesh_smp.triangles)
box = o3d.geometry.TriangleMesh.create_box()
results["midpoint"] = np.asarray(box.subdivide_midpoint(number_of_iterations=1).vertices)
results["loop"] = np.asarray(box.subdivide_loop(number_of_iterations=2).vertices)
cropped = mesh.crop(o3d.geometry.AxisAlignedBoundingBox(mesh.get_min_bound(), mesh.get_center()))
results["cropped"] = str(cropped)
static = o3d.utility.IntVector([0, 1, 2, 500])
positions = np.asarray(mesh.vertices)[[0, 1, 2, 500]]
positions[3] += [0.02, 0, 0]
bent = mesh.deform_as_rigid_as_possible(static, o3d.utility.Vector3dVector(positions), max_iter=5)
results["deformed"] = np.asarray(bent.vertices)
mesh.remove_triangles_by_mask(np.arange(len(mesh.triangles)) % 2 == 0)
mesh.remove_unreferenced_vertices()
results["every second"] = str(mesh)
box.compute_adjacency_list()
results["neighbors"] = [sorted(around) for around in box.adjacency_list][1]
results["sphere"] = str(o3d.geometry.TriangleMesh.create_sphere(1.0, 10) + box)
