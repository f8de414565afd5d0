"""
Compare two meshes: distances, F-score, error map
=================================================

On this page you measure the distances between two surfaces in both directions, for example of a scan and a CAD model.
The distances are exact, from points to triangles. You also display the error of each vertex.
"""

import numpy as np

import pointloom as loom

# %%
# A reconstructed surface and the ground truth
# --------------------------------------------
#
# The surface is a Poisson reconstruction of 60,000 points with noise of 0.5 mm.

truth = loom.datasets.object_mesh()
scan = truth.sample_points_uniformly(60_000, seed=1)
scan.points = scan.points + np.random.default_rng(0).normal(0, 0.0005, (len(scan), 3))
scan = scan.estimate_normals(radius=0.006, max_nn=30).orient_normals_consistent_tangent_plane(20)
reconstructed = loom.meshing.create_surface(scan, depth=7).mesh

# %%
# Metrics
# -------
#
# The F-score is the harmonic mean of two fractions, in percent: how much of each surface is within a threshold of the
# other one. The Hausdorff distance is the maximum distance. ``limit`` [m] is a tolerance. A larger distance adds a
# warning.

comparison = loom.meshing.compare_meshes(reconstructed, truth, thresholds=[0.0005, 0.001, 0.002], limit=0.02)
print(comparison)
figures = comparison.metrics
print(
    "F-scores:", {f"{t * 1e3:g} mm": f"{f:.1f} %" for t, f in zip(comparison.thresholds, figures.fscore, strict=False)}
)
assert comparison.reliable, comparison.warnings
assert max(figures.mean) < 0.001, "the surface averages the noise of 0.5 mm"
assert np.all(np.diff(figures.fscore) >= 0) and figures.fscore[-1] > 95

# %%
# Different units cause a warning.

wrong = loom.meshing.compare_meshes(reconstructed.scale(1000, [0, 0, 0]), truth, samples=2000)
print(wrong.warnings)
assert not wrong.reliable and "unit" in wrong.warnings[0]

# %%
# Error map
# ---------
#
# ``compute_error_map`` returns the distance of each vertex from the other surface. The color map ends at the 98th
# percentile.

_, errors = reconstructed.compute_error_map(truth)
reconstructed.vertex_attributes["error [mm]"] = errors * 1e3
high = float(np.quantile(errors, 0.98)) * 1e3
style = {
    "geometry": reconstructed.compute_vertex_normals(),
    "color_by": "error [mm]",
    "limits": (0, high),
    "shaded": True,
}
view = {"front": [0.3, -1, 0.25], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.72}
image = loom.render(style, view, (640, 640), color_bar=True)

# %%
# What to change
# --------------
# - ``thresholds`` [m]: choose them by the required tolerance.
# - ``limit`` [m]: a value below the Hausdorff distance adds a warning.
# - ``samples``: more samples give more accurate metrics and take longer.
#
# Next
# ----
# - :ref:`Change detection between two scans <sphx_glr_gallery_clouds_plot_change_detection.py>`
# - :ref:`Surface reconstruction methods <sphx_glr_gallery_meshes_plot_surface_methods.py>`
