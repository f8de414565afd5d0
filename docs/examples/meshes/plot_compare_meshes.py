"""
Compare two meshes: distances, F-score, error map
=================================================

Is the printed part like the drawing, the cheap scan like the good one? ``compare_meshes`` measures distances between
two surfaces in both directions, exactly from points to triangles, and says when the two are not alike at all.
"""

import numpy as np

import pointloom as loom

# %%
# A surface from a noisy scan, and the truth
# ------------------------------------------
#
# 60,000 points of the figure with 0.5 mm of noise, made into a surface by Poisson's method.

truth = loom.datasets.object_mesh()
scan = truth.sample_points_uniformly(60_000, seed=1)
scan.points = scan.points + np.random.default_rng(0).normal(0, 0.0005, (len(scan), 3))
scan = scan.estimate_normals(radius=0.006, max_nn=30).orient_normals_consistent_tangent_plane(20)
made = loom.meshing.create_surface(scan, depth=7).mesh

# %%
# Figures
# -------
#
# An F-score is the fraction of both surfaces that have the other one within a threshold (harmonic mean, percent). The
# Hausdorff distance is the worst place of all. ``limit`` [m] is what you allow: a larger distance adds a warning.

comparison = loom.meshing.compare_meshes(made, truth, thresholds=[0.0005, 0.001, 0.002], limit=0.02)
print(comparison)
figures = comparison.metrics
print(
    "F-scores:", {f"{t * 1e3:g} mm": f"{f:.1f} %" for t, f in zip(comparison.thresholds, figures.fscore, strict=False)}
)
assert comparison.reliable, comparison.warnings
assert max(figures.mean) < 0.001, "half a millimetre of noise is averaged by the surface"
assert np.all(np.diff(figures.fscore) >= 0) and figures.fscore[-1] > 95

# %%
# Wrong units are told, not measured away.

wrong = loom.meshing.compare_meshes(made.scale(1000, [0, 0, 0]), truth, samples=2000)
print(wrong.warnings)
assert not wrong.reliable and "unit" in wrong.warnings[0]

# %%
# Where is it off?
# ----------------
#
# ``compute_error_map`` gives the distance of each vertex from the other surface. As an attribute it can be drawn with
# its scale: the last color is what 98 of 100 vertices stay below.

_, errors = made.compute_error_map(truth)
made.vertex_attributes["error [mm]"] = errors * 1e3
high = float(np.quantile(errors, 0.98)) * 1e3
shown = {"geometry": made.compute_vertex_normals(), "color_by": "error [mm]", "limits": (0, high), "shaded": True}
view = {"front": [0.3, -1, 0.25], "up": [0, 0, 1], "field_of_view": 25, "zoom": 0.72}
image = loom.render(shown, view, (640, 640), color_bar=True)
