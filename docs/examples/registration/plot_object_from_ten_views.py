"""
Register ten scans of an object
===============================

On this page you register ten scans of an object in arbitrary order and without initial poses. All pairs are registered,
the accepted ones form a pose graph, and the graph is optimized. Scans that cannot be registered are reported. The
merged cloud is reconstructed to a surface.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Ten scans
# ---------
# Each scan is in its camera coordinates and has noise. The true poses are only used for the evaluation.
views = loom.datasets.object_scans(10)
print(len(views.scans), "scans,", views.scans[0])

# %%
# Register
# --------
# The voxel size is about a tenth of the size of the features: 5 mm for an object of 30 cm. The poses are much more
# accurate than the voxel size.
result = reg.register_multiway(views.scans, voxel_size=0.005)
print(result)
assert result.placed.all()
best = max(result.pairs, key=lambda pair: pair.fitness)
print(f"scans {best.source} and {best.target} have the largest overlap: {100 * best.fitness:.0f} %")
print(
    f"{len(result.pairs)} of 45 pairs were accepted; lowest score "
    f"{min(pair.score for pair in result.pairs if np.isfinite(pair.score)):.2f}"
)

# %%
# Accuracy
# --------
# Both trajectories are relative to the reference scan.
estimate = loom.Trajectory(result.poses)
truth = loom.Trajectory(np.linalg.inv(views.poses[result.reference]) @ views.poses)
error = reg.evaluate_trajectory(estimate, truth)
print(f"rmse {1000 * error.absolute_translation.rmse:.2f} mm and {error.absolute_rotation.rmse:.3f} degrees")
assert error.absolute_translation.rmse < 0.005 and error.absolute_rotation.rmse < 0.6

# %%
# Pose graph
# ----------
# The pose graph can be stored in Open3D's format and extended by further scans.
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "owl.json"
    reg.write_pose_graph(path, result.pose_graph)
    graph = reg.read_pose_graph(path)
certain = sum(not edge.uncertain for edge in graph.edges)
report = result.pose_graph.report
print(f"{len(graph.nodes)} nodes, {len(graph.edges)} edges, {certain} of them certain;", report.criterion)
assert len(graph.nodes) == 10

# %%
# Merged cloud
# ------------
# All points in one coordinate system, downsampled to 1.5 mm, with normals toward the cameras.
registered = []
for scan, pose in zip(views.scans, result.poses, strict=True):
    oriented = scan.estimate_normals(max_nn=20).orient_normals_towards_camera_location([0, 0, 0])
    registered.append(oriented.transform(pose))
merged = (
    loom.PointCloud.concatenate(registered)
    .transform(views.poses[result.reference])
    .voxel_down_sample(0.0015)
    .normalize_normals()
)
scene = loom.RaycastingScene()
mesh = loom.datasets.object_mesh()
scene.add_triangles(mesh.vertices.astype(np.float32), mesh.triangles)
distance = np.asarray(scene.compute_distance(merged.points.astype(np.float32)))
print(
    f"{len(merged):,} points, {1000 * np.median(distance):.2f} mm median error, 95th percentile "
    f"{1000 * np.percentile(distance, 95):.2f} mm"
)
assert np.median(distance) < 0.001

# %%
# The registered scans with one color per scan, and the merged cloud with the colors of the scans:
palette = np.random.default_rng(5).uniform(0.25, 0.95, (10, 3))
back = views.poses[result.reference]
shift = np.array([0.27, 0, 0])
scene_items = [
    {"geometry": scan.without("normals").transform(back).translate(-shift), "color": tuple(color)}
    for scan, color in zip(registered, palette, strict=True)
]
scene_items.append({"geometry": merged.without("normals"), "point_size": 4})
view = loom.View.fit(
    np.vstack([merged.points - shift, merged.points + shift]), direction=(0.15, 1.0, -0.25), width=1120, height=560
)

# %%
# Surface
# -------
# ``create_surface`` with its defaults reconstructs the surface. :ref:`Surface reconstruction methods
# <sphx_glr_gallery_meshes_plot_surface_methods.py>` shows the alternatives.
surface = loom.meshing.create_surface(merged).mesh
off_surface = np.asarray(scene.compute_distance(surface.vertices.astype(np.float32)))
print(surface, f"{1000 * np.median(off_surface):.2f} mm median error, watertight: {surface.is_watertight()}")
assert np.median(off_surface) < 0.001
nearest = loom.NearestNeighborSearch(merged).knn_search(surface.vertices, 1)
surface.vertex_colors = merged.colors[np.ravel(nearest.indices)]
scene_items.append({"geometry": surface.compute_vertex_normals().translate(shift)})
image = loom.render(scene_items, view)

# %%
# What to change
# --------------
# - ``voxel_size`` [m]: 0.01 is faster. Are all scans registered?
# - The scans: use every second one. Which scans are reported as not registered?
# - The voxel size of the merged cloud [m]: 0.003 instead of 0.0015.
#
# Next
# ----
# - :ref:`Global registration and its score <sphx_glr_gallery_registration_plot_global_registration.py>`
# - :doc:`Registration of terrestrial scans </stations>`
