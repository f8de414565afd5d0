"""
Eigenvalue features and keypoints
=================================

The eigenvalues of a neighborhood show whether its points are on a line, on a plane, or in a volume. On this page you
compute these features to separate wires, walls and vegetation without training. They are also a common input of
classifiers. You also detect ISS keypoints, which can be found again in another scan.
"""

import numpy as np

import pointloom as loom

# %%
# A test scene
# ------------
# The scene is a box-shaped building with a wire above it and a bush next to it, with noise of 5 mm. The class of each
# point is known.
rng = np.random.default_rng(2)
box = loom.TriangleMesh.create_box(2.0, 1.5, 1.2).sample_points_uniformly(24_000, seed=1).points
floor = np.column_stack([rng.uniform(-2, 4, 30_000), rng.uniform(-2, 3.5, 30_000), np.zeros(30_000)])
wire_x = rng.uniform(-2, 4, 2_500)
wire = np.column_stack([wire_x, np.full(2_500, 0.7), 2.2 + 0.03 * (wire_x - 1) ** 2])
bush = rng.normal(size=(6_000, 3))
bush = [3.2, -0.8, 0.6] + 0.55 * bush / np.linalg.norm(bush, axis=1, keepdims=True) * rng.random((6_000, 1)) ** (1 / 3)
parts = {"box": box[box[:, 2] > 0.01], "floor": floor, "wire": wire, "bush": bush}
kind = np.repeat(list(parts), [len(points) for points in parts.values()])
points = np.vstack(list(parts.values())) + rng.normal(scale=0.005, size=(len(kind), 3))
cloud = loom.PointCloud(points)

# %%
# Eigenvalue features
# -------------------
# ``linearity``, ``planarity`` and ``sphericity`` sum to 1. The radius is the only parameter. It should be at least 10
# times the noise, and smaller than the objects.
shapes = loom.compute_eigen_features(cloud, radius=0.15, max_nn=None)
for name in parts:
    of_part = kind == name
    print(
        f"{name:6}"
        + "".join(
            f"  {key} {np.nanmedian(shapes[key][of_part]):.2f}"
            for key in ("linearity", "planarity", "sphericity", "verticality", "curvature")
        )
    )
strongest = np.argmax(np.column_stack([shapes[key] for key in ("linearity", "planarity", "sphericity")]), axis=1)
accuracy = {
    "wire": (strongest[kind == "wire"] == 0).mean(),
    "floor": (strongest[kind == "floor"] == 1).mean(),
    "bush": (strongest[kind == "bush"] == 2).mean(),
}
print({name: f"{100 * fraction:.1f} %" for name, fraction in accuracy.items()})
assert accuracy["wire"] > 0.99 and accuracy["floor"] > 0.9 and accuracy["bush"] > 0.5

colors = np.array([[0.9, 0.35, 0.15], [0.35, 0.6, 0.8], [0.3, 0.65, 0.3]])[strongest]
view = loom.View.fit(points, direction=(-0.5, 0.75, -0.45), width=960, height=640)
edge_image = loom.render(
    {"geometry": loom.PointCloud(points, colors=colors), "point_size": 3.5},
    view,
    legend=[("linear", (0.9, 0.35, 0.15)), ("planar", (0.35, 0.6, 0.8)), ("volumetric", (0.3, 0.65, 0.3))],
)

# %%
# Edges
# -----
# ``estimate_curvature`` computes the surface variation: 0 on a plane, larger at edges.
building = cloud.select_by_mask(kind == "box")
building = loom.estimate_curvature(building, radius=0.15, max_nn=None)
near_edge = (np.abs(building.points - [1.0, 0.75, 0.6]) > np.array([1.0, 0.75, 0.6]) - 0.1).sum(axis=1) >= 2
print(
    f"curvature: median on faces {np.median(building['curvature'][~near_edge]):.4f}, near edges "
    f"{np.median(building['curvature'][near_edge]):.4f}"
)
assert np.median(building["curvature"][near_edge]) > 5 * np.median(building["curvature"][~near_edge])

# %%
# Keypoints
# ---------
# The keypoints of the building are at its corners. ``salient_radius`` is the radius of the neighborhood,
# ``non_max_radius`` the minimum distance of two keypoints, both in meters.
keypoints, rows = loom.compute_iss_keypoints(building, salient_radius=0.25, non_max_radius=0.3, return_indices=True)
corners = np.array([[x, y, 1.2] for x in (0, 2.0) for y in (0, 1.5)])
nearest = loom.NearestNeighborSearch(keypoints).knn_search(corners, 1)
distances = np.sqrt(nearest.sqdists[:, 0])
print(f"{len(keypoints)} keypoints; distances from the four corners of the roof: {np.round(distances, 3)} m")
assert distances.max() < 0.15

markers = [
    loom.TriangleMesh.create_sphere(0.045).translate(position).paint_uniform_color([0.9, 0.2, 0.1])
    for position in keypoints.points
]
keypoint_image = loom.render(
    [{"geometry": building, "color_by": "curvature", "colormap": "viridis", "point_size": 4}, *markers],
    loom.View.fit(building.points, direction=(-0.5, 0.75, -0.6), width=960, height=640),
    color_bar=True,
)

# %%
# What to change
# --------------
# - ``radius`` [m]: 0.02 is close to the noise, and 1.2 exceeds the distance of the wire from the roof.
# - ``salient_radius`` [m]: a larger value gives fewer keypoints.
# - The noise [m]: with ``scale=0.02`` a larger radius is needed.
#
# Next
# ----
# - :ref:`Features, RANSAC and FGR <sphx_glr_gallery_registration_plot_features_ransac_fgr.py>`: features for
#   registration.
# - :doc:`Shape detection </shapes>`: planes, spheres, cylinders, cones and tori.
