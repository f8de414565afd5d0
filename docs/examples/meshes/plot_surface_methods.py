"""
Surface reconstruction methods
==============================

Poisson reconstruction averages noise and closes holes, but also extrapolates into unobserved regions. Ball pivoting
connects the input points and leaves holes. Alpha shapes need no normals. On this page you apply all three methods to
the same noisy scan and compare them with the true surface.
"""

import warnings

import numpy as np

import pointloom as loom

# %%
# A noisy scan
# ------------
#
# The scan has 40,000 points with noise of 0.3 mm. The lowest part of the object was not observed.

truth = loom.datasets.object_mesh()
exact = truth.sample_points_uniformly(40_000, seed=0).points
scan = loom.PointCloud(exact + np.random.default_rng(0).normal(0, 0.0003, exact.shape))
low, high = scan.get_axis_aligned_bounding_box()
scan = scan.select_by_mask(scan.points[:, 2] > low[2] + 0.04 * (high[2] - low[2]))
print(f"{len(scan)} points, {np.linalg.norm(high - low):.3f} m across")

# %%
# Compare the methods
# -------------------
#
# ``create_surface`` estimates missing normals and selects radii and alpha by the point spacing. It reports the area far
# from all points, the number of boundary edges, and warnings if the surface is unreliable.

results = {name: loom.meshing.create_surface(scan, name) for name in ("poisson", "ball", "alpha")}
for name, result in results.items():
    metrics = result.mesh.compute_metrics(truth, n_sampled_points=20_000)
    print(f"{name:8} {len(result.mesh.triangles):7} triangles, closed: {result.mesh.is_watertight()!s:5} "
          f"accuracy {metrics.mean[0] * 1e3:.3f} mm, completeness {metrics.mean[1] * 1e3:.3f} mm")  # fmt: skip
    for warning in result.warnings:
        print("        ", warning)

accuracy = {
    name: result.mesh.compute_metrics(truth, n_sampled_points=20_000).mean[0] for name, result in results.items()
}
assert accuracy["poisson"] < accuracy["alpha"], "Poisson reconstruction averages noise"
assert not any(result.normals.given for result in results.values()), "the call estimated the normals"

# %%
# Trim a Poisson surface
# ----------------------
#
# The methods are also class methods of ``TriangleMesh``. Poisson reconstruction returns a density for each vertex, a
# measure of the number of supporting points. The untrimmed surface extends below the object, where there are no points.
# ``trim`` cuts it along a smooth line and removes isolated parts. The normals must be oriented consistently. Otherwise
# a ``NormalsWarning`` is emitted.

scan = scan.estimate_normals(radius=0.008, max_nn=30)
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    loom.TriangleMesh.create_from_point_cloud_poisson(scan, depth=6)
print([str(w.message)[:90] for w in caught if issubclass(w.category, loom.NormalsWarning)])
scan = scan.orient_normals_consistent_tangent_plane(20)
untrimmed, densities = loom.TriangleMesh.create_from_point_cloud_poisson(scan, depth=7)
trimmed = untrimmed.trim(densities, float(np.quantile(densities, 0.05)))
distances = {
    name: float(loom.PointCloud(mesh.vertices).compute_point_cloud_distance(scan).max())
    for name, mesh in [("untrimmed", untrimmed), ("trimmed", trimmed)]
}
print(
    f"largest distance from the points: untrimmed {distances['untrimmed'] * 1e3:.1f} mm, "
    f"trimmed {distances['trimmed'] * 1e3:.1f} mm"
)
assert distances["trimmed"] < 0.5 * distances["untrimmed"]

# %%
# Choose a method
# ---------------
#
# ===============================  ===========================================
# noisy scans with normals         Poisson, trimmed by density
# evenly sampled points            ball pivoting, which keeps the points
# no normals, or solids            alpha shapes
# posed depth frames               TSDF fusion instead
# ===============================  ===========================================

width = 0.23
geometries = {"scan": scan, **{name: result.mesh.compute_vertex_normals() for name, result in results.items()}}
scene, labels = [], []
for i, (name, geometry) in enumerate(geometries.items()):
    pose = np.eye(4)
    pose[0, 3] = i * width
    color = (0.35, 0.4, 0.45) if i == 0 else (0.83, 0.74, 0.6)
    scene.append({"geometry": geometry, "pose": pose, "color": color})
    labels.append((name, [i * width, 0, high[2] + 0.02]))
view = {"front": [0.0, -1, 0.2], "up": [0, 0, 1], "field_of_view": 20, "zoom": 0.36}
image = loom.render(scene, view, (1080, 600), labels=labels, point_size=2.5)

# %%
# What to change
# --------------
# - ``depth`` of Poisson: 5 to 9. Each increment doubles the resolution.
# - The quantile of ``trim``: 0.2 instead of 0.05 removes more of the surface.
# - The noise [m]: 0.001. Which method is the most sensitive?
#
# Next
# ----
# - :ref:`Chapter 11 <sphx_glr_chapters_plot_11_surfaces.py>`: surface reconstruction, step by step.
# - :doc:`Surface reconstruction </surfaces>`: all methods with measurements.
