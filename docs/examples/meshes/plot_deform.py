"""
As-rigid-as-possible deformation
================================

On this page you deform a mesh by handles: some vertices are fixed, others are moved, and all other vertices follow so
that the shape is preserved locally. Use it to pose figures, to fit markers, or to correct a model by measured points.
"""

import numpy as np

import pointloom as loom

# %%
# Handles
# -------
#
# A handle is a vertex with a target position. The lower tenth of the bar is fixed. The upper tenth is rotated by 120
# degrees about the axis of the bar and tilted by 40 degrees.

bar = loom.TriangleMesh.create_box(0.06, 0.06, 0.4).translate([-0.03, -0.03, 0]).remesh_isotropic(0.008)
heights = bar.vertices[:, 2]
fixed, dragged = np.flatnonzero(heights < 0.04), np.flatnonzero(heights > 0.36)
twist, lean = np.radians([120, 40])
about_z = np.array([[np.cos(twist), -np.sin(twist), 0], [np.sin(twist), np.cos(twist), 0], [0, 0, 1]])
about_y = np.array([[np.cos(lean), 0, np.sin(lean)], [0, 1, 0], [-np.sin(lean), 0, np.cos(lean)]])
rotation = about_y @ about_z
center = bar.vertices[dragged].mean(axis=0)
targets = (bar.vertices[dragged] - center) @ rotation.T + [0.12, 0, 0.33]

# %%
# Solve
# -----
#
# The solver uses 300 iterations. More iterations decrease the energy further. ``energy="smoothed"`` distributes the
# bending more evenly.

indices = np.concatenate([fixed, dragged])
positions = np.concatenate([bar.vertices[fixed], targets])
bent = bar.deform_as_rigid_as_possible(indices, positions, 300)

before = loom.LineSet.create_from_triangle_mesh(bar)
ends = before.lines
lengths = np.linalg.norm(np.diff(bar.vertices[ends], axis=1)[:, 0], axis=1)
stretch = np.linalg.norm(np.diff(bent.vertices[ends], axis=1)[:, 0], axis=1) / lengths
print(f"error of the handles {np.abs(bent.vertices[indices] - positions).max() * 1e6:.2f} um")
print(
    f"edges are {np.median(np.abs(stretch - 1)) * 100:.1f} % longer or shorter "
    f"(median), {np.quantile(np.abs(stretch - 1), 0.99) * 100:.0f} % (99th percentile)"
)
assert np.allclose(bent.vertices[indices], positions, atol=1e-6)
assert np.median(np.abs(stretch - 1)) < 0.1

# %%
# For comparison, a linear blend of the motions of the handles collapses in the middle.

fraction = np.clip((heights - 0.04) / 0.32, 0, 1)[:, None]
moved_vertices = (bar.vertices - center) @ rotation.T + [0.12, 0, 0.33]
blend = bar.copy()
blend.vertices = (1 - fraction) * bar.vertices + fraction * moved_vertices
blend_stretch = np.linalg.norm(np.diff(blend.vertices[ends], axis=1)[:, 0], axis=1) / lengths
print(f"edges of the blend: {np.quantile(np.abs(blend_stretch - 1), 0.99) * 100:.0f} % (99th percentile)")
print(
    f"volume ratio: {bent.get_volume() / bar.get_volume():.2f}, "
    f"of the blend {blend.get_volume() / bar.get_volume():.2f}"
)
assert np.quantile(np.abs(stretch - 1), 0.99) < np.quantile(np.abs(blend_stretch - 1), 0.99)
assert bent.get_volume() > 1.1 * blend.get_volume()

# %%
# Fixed vertices are dark, moved ones red.

scene = []
for i, mesh in enumerate((bar, blend, bent)):
    colors = np.tile([0.93, 0.8, 0.55], (len(mesh.vertices), 1))
    colors[fixed], colors[dragged] = (0.3, 0.33, 0.4), (0.8, 0.25, 0.2)
    mesh.vertex_colors = colors
    scene.append({"geometry": mesh.translate([0.33 * i - 0.1 * (i > 0), 0, 0]), "wireframe": True})
labels = [("original", [0, 0, 0.43]), ("linear blend", [0.33, 0, 0.43]), ("as-rigid-as-possible", [0.66, 0, 0.43])]
view = {"front": [-0.15, -1, 0.25], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.5}
image = loom.render(scene, view, (960, 640), labels=labels)

# %%
# What to change
# --------------
# - ``twist`` and ``lean`` [degrees]: 180 and 80. Does the bar intersect itself?
# - The iterations: 20 instead of 300 leaves a visible error.
# - ``energy``: ``"smoothed"``.
#
# Next
# ----
# - :doc:`Non-rigid registration </bending>`: deformation to fit another scan.
# - :ref:`Mesh smoothing without shrinkage <sphx_glr_gallery_meshes_plot_smooth.py>`
