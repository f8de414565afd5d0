"""
Points to a surface: which method when
======================================

Poisson averages noise and closes holes, but makes up what no point saw. Ball pivoting joins the points that are there
and leaves holes. Alpha shapes want no normals. The same noisy scan goes through all three, against the true surface.
"""

import warnings

import numpy as np

import pointloom as loom

# %%
# A scan
# ------
#
# 40,000 points with 0.3 mm of noise; the feet were never seen.

truth = loom.datasets.object_mesh()
exact = truth.sample_points_uniformly(40_000, seed=0).points
scan = loom.PointCloud(exact + np.random.default_rng(0).normal(0, 0.0003, exact.shape))
low, high = scan.get_axis_aligned_bounding_box()
scan = scan.select_by_mask(scan.points[:, 2] > low[2] + 0.04 * (high[2] - low[2]))
print(f"{len(scan)} points, {np.linalg.norm(high - low):.3f} m across")

# %%
# One call each
# -------------
#
# ``create_surface`` makes normals where there are none, chooses radii and alpha by the spacing of the points, and
# reports: how much area lies far from all points, how many edges are open, and in ``warnings`` why the surface is
# unreliable.

results = {name: loom.meshing.create_surface(scan, name) for name in ("poisson", "ball", "alpha")}
for name, result in results.items():
    metrics = result.mesh.compute_metrics(truth, n_sampled_points=20_000)
    print(f"{name:8} {len(result.mesh.triangles):7} triangles, closed: {result.mesh.is_watertight()!s:5} "
          f"off the truth {metrics.mean[0] * 1e3:.3f} mm, truth off it {metrics.mean[1] * 1e3:.3f} mm")  # fmt: skip
    for warning in result.warnings:
        print("        ", warning)

far = {name: result.mesh.compute_metrics(truth, n_sampled_points=20_000).mean[0] for name, result in results.items()}
assert far["poisson"] < far["alpha"], "Poisson averages noise away"
assert not any(result.normals.given for result in results.values()), "normals were made by the call"

# %%
# What Poisson made up
# --------------------
#
# The methods alone are class methods of ``TriangleMesh``. Poisson gives a density for each vertex: how many points bear
# it out. Left whole, the surface bulges out below, where nothing was seen; ``trim`` cuts along a smooth line where few
# points are, and drops islands. Normals have to look to one side: a ``NormalsWarning`` tells when they do not.

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
# Which one?
# ----------
#
# ===============================  ===========================================
# scans with noise, normals known  Poisson; trim by density where scans end
# even, clean samples              ball pivoting: the points stay where they are
# no normals, or solids            alpha shapes
# posed depth frames               none of these: fuse them (TSDF)
# ===============================  ===========================================

width = 0.23
shown = {"scan": scan, **{name: result.mesh.compute_vertex_normals() for name, result in results.items()}}
scene, labels = [], []
for i, (name, geometry) in enumerate(shown.items()):
    pose = np.eye(4)
    pose[0, 3] = i * width
    color = (0.35, 0.4, 0.45) if i == 0 else (0.83, 0.74, 0.6)
    scene.append({"geometry": geometry, "pose": pose, "color": color})
    labels.append((name, [i * width, 0, high[2] + 0.02]))
view = {"front": [0.0, -1, 0.2], "up": [0, 0, 1], "field_of_view": 20, "zoom": 0.36}
image = loom.render(scene, view, (1080, 600), labels=labels, point_size=2.5)
