"""
Initial pose from picked point pairs
====================================

Three pairs of corresponding points, selected manually in both clouds, determine a pose that ICP refines. Use this if
automatic registration is unreliable. On this page you compute a pose from pairs, include scale, and handle wrong pairs.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two scans
# ---------
# The source is rotated by 130 degrees and translated by half a meter.
truth = np.array(
    [[-0.642788, -0.766044, 0.0, 0.4], [0.766044, -0.642788, 0.0, -0.3], [0.0, 0.0, 1.0, 0.1], [0, 0, 0, 1.0]]
)
u, _, vt = np.linalg.svd(truth[:3, :3])
truth[:3, :3] = u @ vt
mesh = loom.datasets.object_mesh()
target = mesh.sample_points_uniformly(15_000, seed=1)
source = mesh.sample_points_uniformly(15_000, seed=2).transform(np.linalg.inv(truth))
size = float(np.linalg.norm(target.get_max_bound() - target.get_min_bound()))


def pose_error(T):
    """Error at the center of the object: rotation [degrees] and translation [m]."""
    center = np.r_[source.get_center(), 1]
    return (
        np.degrees(np.arccos(np.clip((np.trace(T[:3, :3].T @ truth[:3, :3]) - 1) / 2, -1, 1))),
        np.linalg.norm(((T - truth) @ center)[:3]),
    )


# %%
# Pick points
# -----------
# In ``pointloom view``, points are selected with the mouse. Here the selection is simulated: five distant points of the
# target and the same points in the source, with an error of 3% of the size of the object.
rng = np.random.default_rng(4)
picked_target = target.farthest_point_indices(5)
clicked = target.points[picked_target] + rng.normal(scale=0.015 * size, size=(5, 3))
in_source = (clicked - truth[:3, 3]) @ truth[:3, :3]
picked_source = loom.NearestNeighborSearch(source).knn_search(in_source, 1).indices[:, 0]
pairs = np.column_stack([picked_source, picked_target]).astype(np.int32)
print(pairs)


# %%
# Compute the pose
# ----------------
# The pose minimizes the distances of the pairs. The correspondence distance is as large as the object, so that all
# pairs are used. Three pairs are sufficient. Five pairs average the error of the selection. Select points far away from
# each other, since pairs on one side do not determine the rotation accurately.
def pose_of(pairs, source=source, with_scaling=False):
    """Return the T_target_source that minimizes the distances of the pairs."""
    source_points, target_points = source.select_by_index(pairs[:, 0]), target.select_by_index(pairs[:, 1])
    rows_of_pairs = np.column_stack([np.arange(len(pairs))] * 2).astype(np.int32)
    method = reg.TransformationEstimationPointToPoint(with_scaling)
    return reg.registration_ransac_based_on_correspondence(
        source_points, target_points, rows_of_pairs, size, method, len(pairs)
    )


first = {}
for count in (3, 5):
    result = pose_of(pairs[:count])
    first[count] = result.transformation
    angle, distance = pose_error(first[count])
    print(
        f"{count} pairs: error {angle:.2f} degrees and {1000 * distance:.1f} mm; rmse of the pairs "
        f"{1000 * result.inlier_rmse:.1f} mm"
    )
assert pose_error(first[5])[0] < 8

# %%
# With scale
# ----------
# If one cloud has an arbitrary unit, as a photogrammetric model, the pairs also determine the scale.
half = source.scale(0.5, center=[0, 0, 0])
scaled = pose_of(pairs, half, with_scaling=True).transformation
factor = np.cbrt(np.linalg.det(scaled[:3, :3]))
print(f"scale from five pairs: {factor:.3f}, ground truth 2")
assert abs(factor - 2) < 0.1

# %%
# Wrong pairs
# -----------
# A single wrong pair distorts the least-squares pose. ``registration_robust_based_on_correspondence`` selects
# consistent pairs. In this example, seven of twenty pairs are wrong. ``noise_bound`` is the largest error of a correct
# pair [m].
many = target.farthest_point_indices(20)
clicked = target.points[many] + rng.normal(scale=0.008 * size, size=(20, 3))
rows = loom.NearestNeighborSearch(source).knn_search((clicked - truth[:3, 3]) @ truth[:3, :3], 1).indices[:, 0]
rows[:7] = rng.integers(0, len(source), 7)
clicks = np.column_stack([rows, many]).astype(np.int32)
plain = pose_of(clicks).transformation
robust = reg.registration_robust_based_on_correspondence(source, target, clicks, noise_bound=0.05 * size)
print(
    f"error of least squares {pose_error(plain)[0]:.1f} degrees, "
    f"robust {pose_error(robust.transformation)[0]:.2f} degrees, "
    f"score {robust.score:.2f}"
)
assert 2 * pose_error(robust.transformation)[0] < pose_error(plain)[0] and pose_error(robust.transformation)[0] < 3

# %%
# Refine
# ------
# ICP refines the pose. ``evaluate_registration`` measures the improvement: the fraction of points with a
# correspondence, and its rmse.
before = reg.evaluate_registration(source, target, 0.03 * size, first[5])
result = reg.registration_icp(
    source, target.estimate_normals(max_nn=20), 0.08 * size, first[5], reg.TransformationEstimationPointToPlane()
)
after = reg.evaluate_registration(source, target, 0.03 * size, result.transformation)
print(
    f"picked: fitness {before.fitness:.3f}, rmse {1000 * before.inlier_rmse:.2f} mm; refined: "
    f"{after.fitness:.3f}, {1000 * after.inlier_rmse:.2f} mm"
)
print(f"error {pose_error(result.transformation)[0]:.4f} degrees")
assert pose_error(result.transformation)[0] < 0.2 and after.inlier_rmse < before.inlier_rmse

# %%
# The pairs as lines, and the result:
show = np.eye(4)
show[:3, :3] = truth[:3, :3]
show[:3, 3] = target.get_center() - truth[:3, :3] @ source.get_center() - [1.25 * size, 0, 0]
source_before = source.transform(show)
lines = loom.LineSet.create_from_point_cloud_correspondences(source_before, target, pairs)
right = np.array([1.25 * size, 0, 0])
scene = {
    "source": {"geometry": source_before.paint_uniform_color([0.95, 0.6, 0.1])},
    "target": {"geometry": target.paint_uniform_color([0.2, 0.5, 0.8])},
    "pairs": {"geometry": lines, "color": (0.85, 0.1, 0.2), "line_width": 3},
    "registered": {
        "geometry": source.transform(result.transformation).translate(right).paint_uniform_color([0.95, 0.6, 0.1])
    },
    "registered target": {"geometry": target.translate(right).paint_uniform_color([0.2, 0.5, 0.8])},
}
corners = np.vstack([style["geometry"].points for style in scene.values()])
image = loom.render(scene, loom.View.fit(corners, direction=(0.0, 1.0, -0.3), width=1120, height=420))

# %%
# What to change
# --------------
# - The number of pairs: 3, 5 or 10.
# - The error of the selection as a fraction of the size: 0.015 here.
# - ``noise_bound`` [m]: a value below the error of the selection rejects correct pairs.
#
# Next
# ----
# - :ref:`Chapter 7 <sphx_glr_chapters_plot_07_icp.py>`: ICP, step by step.
# - :doc:`The viewer </viewer>`: point selection.
