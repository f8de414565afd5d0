"""
Points to a surface: which method when
======================================

Poisson averages noise and closes holes, but makes up what no point saw. Ball pivoting joins the points that are there and leaves
holes. Alpha shapes want no normals. The same noisy scan goes through all three, against the true surface.
"""

import warnings

import numpy as np

import pointloom as loom

# %%
# A scan
# ------
#
# 40,000 points with 0.3 mm of noise; the feet were never seen.

truth = loom.data.object_mesh()
scan = truth.sample_points_uniformly(40_000, seed=0)
scan.points = scan.points + np.random.default_rng(0).normal(0, 0.0003, (len(scan), 3))
low, high = scan.get_axis_aligned_bounding_box()
scan = scan.select_by_mask(scan.points[:, 2] > low[2] + 0.04 * (high[2] - low[2]))
print(f"{len(scan)} points, {np.linalg.norm(high - low):.3f} m across")

# %%
# One call each
# -------------
#
# `create_surface` makes normals where there are none, chooses radii and alpha by the spacing of the points, and reports: how much
# area lies far from all points, how many edges are open, and `poor`, why the surface is not to be believed.

results = {name: loom.create_surface(scan, name) for name in ("poisson", "ball_pivoting", "alpha_shape")}
for name, result in results.items():
    metrics = result.mesh.compute_metrics(truth, n_sampled_points=20_000)
    print(f"{name:13} {len(result.mesh.triangles):7} triangles, closed: {result.mesh.is_watertight()!s:5} "
          f"off the truth {metrics.mean[0] * 1e3:.3f} mm, truth off it {metrics.mean[1] * 1e3:.3f} mm")  # fmt: skip
    if result.poor:
        print("              ", result.poor)
