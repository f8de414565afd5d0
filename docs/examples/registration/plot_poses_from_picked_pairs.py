"""
A first pose from points picked by hand
=======================================

Three pairs of points that somebody clicked in both clouds give a pose, ICP does the rest. Take this page when two
scans hardly look alike, or when an automatic pose is refused: a person sees what belongs together. How many pairs,
and how exact?
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two scans of an object, the second one anyhow: turned by 130 degrees and moved by half a metre.
truth = np.array(
    [[-0.642788, -0.766044, 0.0, 0.4], [0.766044, -0.642788, 0.0, -0.3], [0.0, 0.0, 1.0, 0.1], [0, 0, 0, 1.0]]
)
u, _, vt = np.linalg.svd(truth[:3, :3])
truth[:3, :3] = u @ vt
mesh = loom.datasets.object_mesh()
target = mesh.sample_points_uniformly(15_000, seed=1)
source = mesh.sample_points_uniformly(15_000, seed=2).transform(np.linalg.inv(truth))
size = float(np.linalg.norm(target.get_max_bound() - target.get_min_bound()))


def off(T):
    """Degrees and meters from the truth, at the middle of the object."""
    middle = np.r_[source.get_center(), 1]
    return (
        np.degrees(np.arccos(np.clip((np.trace(T[:3, :3].T @ truth[:3, :3]) - 1) / 2, -1, 1))),
        np.linalg.norm(((T - truth) @ middle)[:3]),
    )


# %%
# **Picking.** In the viewer of ``pointloom view`` one clicks; here the clicks are made: five places of the target,
# far from each other, and the same places in the source, each missed by some 3 % of the object's size, as one clicks.
rng = np.random.default_rng(4)
picked_target = target.farthest_point_indices(5)
beside = target.points[picked_target] + rng.normal(scale=0.015 * size, size=(5, 3))
in_source = (beside - truth[:3, 3]) @ truth[:3, :3]
picked_source = loom.NearestNeighborSearch(source).knn_search(in_source, 1).indices[:, 0]
pairs = np.column_stack([picked_source, picked_target]).astype(np.int32)
print(pairs)


# %%
# **The pose** of the pairs in least squares: the picked points as two small clouds, and all pairs accepted, as the
# distance within which they count is as large as the object. Three pairs do; five average the hand's errors. Pick far
# apart: a pose from pairs on one end is a lever that ends in the air.
def pose_of(pairs, source=source, with_scaling=False):
    """T_target_source that brings the picked points together best."""
    left, right = source.select_by_index(pairs[:, 0]), target.select_by_index(pairs[:, 1])
    together = np.column_stack([np.arange(len(pairs))] * 2).astype(np.int32)
    method = reg.TransformationEstimation.point_to_point(with_scaling)
    return reg.registration_ransac_based_on_correspondence(left, right, together, size, method, len(pairs))


first = {}
for count in (3, 5):
    result = pose_of(pairs[:count])
    first[count] = result.transformation
    angle, distance = off(first[count])
    print(
        f"{count} pairs: {angle:.2f} degrees and {1000 * distance:.1f} mm off; the pairs fit to "
        f"{1000 * result.inlier_rmse:.1f} mm"
    )
assert off(first[5])[0] < 8

# %%
# **With a scale**, where one cloud has no known unit (a photogrammetric model): the same pairs tell it.
half = source.scale(0.5, center=[0, 0, 0])
scaled = pose_of(pairs, half, with_scaling=True).transformation
factor = np.cbrt(np.linalg.det(scaled[:3, :3]))
print(f"scale from five pairs: {factor:.3f}, the truth is 2")
assert abs(factor - 2) < 0.1

# %%
# **A wrong click** ruins least squares. ``registration_robust_based_on_correspondence`` finds the pairs that agree
# and leaves the others: here twenty pairs, of which seven were clicked anywhere. ``noise_bound`` is how far a good
# click may miss [m].
many = target.farthest_point_indices(20)
beside = target.points[many] + rng.normal(scale=0.008 * size, size=(20, 3))
rows = loom.NearestNeighborSearch(source).knn_search((beside - truth[:3, 3]) @ truth[:3, :3], 1).indices[:, 0]
rows[:7] = rng.integers(0, len(source), 7)
clicks = np.column_stack([rows, many]).astype(np.int32)
plain = pose_of(clicks).transformation
robust = reg.registration_robust_based_on_correspondence(source, target, clicks, noise_bound=0.05 * size)
print(
    f"least squares {off(plain)[0]:.1f} degrees off, robust {off(robust.transformation)[0]:.2f} degrees, "
    f"score {robust.score:.2f}"
)
assert 2 * off(robust.transformation)[0] < off(plain)[0] and off(robust.transformation)[0] < 3

# %%
# **ICP** ends the work. ``evaluate_registration`` tells how well it lies: the fraction of points with a partner nearer
# than the distance, and how near.
before = reg.evaluate_registration(source, target, 0.03 * size, first[5])
result = reg.registration_icp(
    source, target.estimate_normals(max_nn=20), 0.08 * size, first[5], reg.TransformationEstimation.point_to_plane()
)
after = reg.evaluate_registration(source, target, 0.03 * size, result.transformation)
print(
    f"picked: fitness {before.fitness:.3f}, rmse {1000 * before.inlier_rmse:.2f} mm; refined: "
    f"{after.fitness:.3f}, {1000 * after.inlier_rmse:.2f} mm"
)
print(f"{off(result.transformation)[0]:.4f} degrees off")
assert off(result.transformation)[0] < 0.2 and after.inlier_rmse < before.inlier_rmse

# %%
# The picked pairs as lines, and the result beside it.
show = np.eye(4)
show[:3, :3] = truth[:3, :3]
show[:3, 3] = target.get_center() - truth[:3, :3] @ source.get_center() - [1.25 * size, 0, 0]
apart = source.transform(show)
lines = loom.LineSet.create_from_point_cloud_correspondences(apart, target, pairs)
right = np.array([1.25 * size, 0, 0])
scene = {
    "source": {"geometry": apart.paint_uniform_color([0.95, 0.6, 0.1])},
    "target": {"geometry": target.paint_uniform_color([0.2, 0.5, 0.8])},
    "pairs": {"geometry": lines, "color": (0.85, 0.1, 0.2), "line_width": 3},
    "done": {
        "geometry": source.transform(result.transformation).translate(right).paint_uniform_color([0.95, 0.6, 0.1])
    },
    "done target": {"geometry": target.translate(right).paint_uniform_color([0.2, 0.5, 0.8])},
}
corners = np.vstack([style["geometry"].points for style in scene.values()])
image = loom.render(scene, loom.View.fit(corners, direction=(0.0, 1.0, -0.3), width=1120, height=420))
