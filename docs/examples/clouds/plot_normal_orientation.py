"""
Normal orientation
==================

A plane fit gives the normal of a point, but not its sign. On this page you compare three methods that choose the sign
with the ground truth. Use them before surface reconstruction, which requires consistently oriented normals.
"""

import numpy as np

import pointloom as loom

# %%
# Points with known normals
# -------------------------
# The points are samples of a mesh, so the true normals are known.
mesh = loom.datasets.object_mesh()
exact = mesh.compute_vertex_normals().sample_points_uniformly(20_000, seed=0)
truth = exact.normals
size = np.linalg.norm(exact.get_max_bound() - exact.get_min_bound())
cloud = loom.PointCloud(exact.points).estimate_normals(max_nn=16)
print(f"{len(cloud)} points, {size:.3f} m across")

# %%
# Direction
# ---------
# Without the sign, the median error is some degrees on details of 3 mm. ``max_nn`` is the main parameter: more
# neighbors reduce noise and round edges.
cosines = np.abs(np.einsum("ij,ij->i", cloud.normals, truth)).clip(0, 1)
angle = np.degrees(np.arccos(cosines))
print(f"median angle to the true normals {np.median(angle):.2f} degrees")
assert np.median(angle) < 10

# %%
# Sign
# ----
# ``orient_normals_towards_camera_location`` is correct for a single view, ``orient_normals_to_align_with_direction``
# for terrain, and ``orient_normals_consistent_tangent_plane`` for complete objects: it propagates the sign between
# neighbors. ``normal_disagreement`` is the fraction of neighbors with opposite normals, from 0 to 1. It does not need
# the ground truth.
methods = {
    "estimated": cloud,
    "toward (0, 0, 1)": cloud.orient_normals_to_align_with_direction([0, 0, 1]),
    "toward a camera": cloud.orient_normals_towards_camera_location(
        cloud.get_center() + np.array([0, -3 * size, size])
    ),
    "propagated": cloud.orient_normals_consistent_tangent_plane(12),
}
fraction_correct = {}
for name, oriented in methods.items():
    agrees = np.einsum("ij,ij->i", oriented.normals, truth) > 0
    fraction_correct[name] = agrees.mean()
    print(f"{name:18} {100 * agrees.mean():5.1f} % outward, disagreement {oriented.normal_disagreement():.3f}")
assert fraction_correct["propagated"] > 0.95
assert fraction_correct["toward (0, 0, 1)"] < 0.9  # the normals of the lower half point inward

# %%
# Blue normals point outward, orange ones inward.
scene, labels = {}, []
for index, (name, oriented) in enumerate(methods.items()):
    agrees = np.einsum("ij,ij->i", oriented.normals, truth) > 0
    painted = loom.PointCloud(oriented.points, colors=np.where(agrees[:, None], [0.15, 0.5, 0.8], [0.95, 0.5, 0.1]))
    shift = np.array([0.85 * size * index, 0, 0])
    scene[name] = {"geometry": painted.translate(shift), "point_size": 3}
    labels.append((f"{name}: {100 * fraction_correct[name]:.0f} %", shift + cloud.get_center() + [0, 0, 0.62 * size]))
corners = np.vstack([style["geometry"].points for style in scene.values()] + [[position] for _, position in labels])
view = loom.View.fit(corners, direction=(0.0, 1.0, -0.3), width=1120, height=420)
sides = loom.render(scene, view, labels=labels)

# %%
# Effect on a surface
# -------------------
# With oriented normals, the reconstructed surface is closed.
surface = loom.TriangleMesh.create_from_point_cloud_poisson(methods["propagated"], depth=6)[0]
print(surface)
closed = loom.render(
    surface.compute_vertex_normals().paint_uniform_color([0.7, 0.76, 0.8]),
    {"front": [0.5, -1.0, 0.35], "up": [0, 0, 1], "zoom": 0.75},
    (960, 640),
)

# %%
# What to change
# --------------
# - ``max_nn`` of ``estimate_normals``: 8 is noisy, 60 rounds the edges.
# - k of ``orient_normals_consistent_tangent_plane``: a larger value bridges gaps, and may connect opposite sides of
#   thin parts.
# - The reference of ``methods``: replace the propagated normals by the estimated ones in the reconstruction.
#
# Next
# ----
# - :ref:`Chapter 2 <sphx_glr_chapters_plot_02_voxels_and_normals.py>`: normals, step by step.
# - :ref:`Surface reconstruction methods <sphx_glr_gallery_meshes_plot_surface_methods.py>`
