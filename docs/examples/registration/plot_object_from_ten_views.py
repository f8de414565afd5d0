"""
An object from ten scans, without a turntable
=============================================

Ten scans of an object from all round, in no order and from no known place, become one cloud: every pair is tried,
accepted pairs make a pose graph, and the graph is optimized. Scans without a pose are reported. At the end stands
a surface.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Each scan is in the frame of its own camera, with noise. The true poses judge alone.
views = loom.datasets.object_scans(10)
print(len(views.scans), "scans,", views.scans[0])

# %%
# The voxel is a tenth of what there is to recognize: 5 mm on a figure of 30 cm. Poses end up far finer than it.
result = reg.register_multiway(views.scans, voxel_size=0.005)
print(result)
assert result.placed.all()
best = max(result.pairs, key=lambda pair: pair.fitness)
print(f"scans {best.source} and {best.target} share most: {100 * best.fitness:.0f} %")
print(
    f"{len(result.pairs)} of 45 pairs were accepted; the least score "
    f"{min(pair.score for pair in result.pairs if np.isfinite(pair.score)):.2f}"
)

# %%
# Against the truth, once the frame of the reference scan is taken out of both.
estimate = loom.Trajectory(result.poses)
truth = loom.Trajectory(np.linalg.inv(views.poses[result.reference]) @ views.poses)
error = reg.evaluate_trajectory(estimate, truth)
print(f"cameras to {1000 * error.absolute_translation.rmse:.2f} mm and {error.absolute_rotation.rmse:.3f} degrees")
assert error.absolute_translation.rmse < 0.005 and error.absolute_rotation.rmse < 0.6

# %%
# The graph is what may be kept: Open3D reads the file, and more scans may be added to it.
with tempfile.TemporaryDirectory() as folder:
    path = Path(folder) / "owl.json"
    reg.write_pose_graph(path, result.pose_graph)
    graph = reg.read_pose_graph(path)
certain = sum(not edge.uncertain for edge in graph.edges)
report = result.pose_graph.report
print(f"{len(graph.nodes)} nodes, {len(graph.edges)} edges, {certain} of them certain;", report.criterion)
assert len(graph.nodes) == 10

# %%
# **Together**: all points in one frame, one point every 1.5 mm, with normals that look to the cameras.
registered = []
for scan, pose in zip(views.scans, result.poses, strict=True):
    seen = scan.estimate_normals(max_nn=20).orient_normals_towards_camera_location([0, 0, 0])
    registered.append(seen.transform(pose))
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
    f"{len(merged):,} points, {1000 * np.median(distance):.2f} mm from the true surface in the median, 95 % "
    f"within {1000 * np.percentile(distance, 95):.2f} mm"
)
assert np.median(distance) < 0.001

# %%
# As scanned, each scan with a color of its own, and as painted.
palette = np.random.default_rng(5).uniform(0.25, 0.95, (10, 3))
back = views.poses[result.reference]
shift = np.array([0.27, 0, 0])
drawn = [
    {"geometry": scan.without("normals").transform(back).translate(-shift), "color": tuple(color)}
    for scan, color in zip(registered, palette, strict=True)
]
drawn.append({"geometry": merged.without("normals"), "point_size": 4})
view = loom.View.fit(
    np.vstack([merged.points - shift, merged.points + shift]), direction=(0.15, 1.0, -0.25), width=1120, height=560
)

# %%
# **The surface**, made by one call with its defaults (the pages on surfaces say what else there is).
surface = loom.meshing.create_surface(merged).mesh
off_surface = np.asarray(scene.compute_distance(surface.vertices.astype(np.float32)))
print(surface, f"{1000 * np.median(off_surface):.2f} mm from the true one, watertight: {surface.is_watertight()}")
assert np.median(off_surface) < 0.001
nearest = loom.NearestNeighborSearch(merged).knn_search(surface.vertices, 1)
surface.vertex_colors = merged.colors[np.ravel(nearest.indices)]
drawn.append({"geometry": surface.compute_vertex_normals().translate(shift)})
image = loom.render(drawn, view)
