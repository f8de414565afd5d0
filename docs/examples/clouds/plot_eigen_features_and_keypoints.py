"""
Edges, wires and surfaces told apart
====================================

How the neighbors of a point lie says what it belongs to: along a line, on a plane, or all around. These
eigen-features sort walls from wires and corners from floors without any training, and are the usual input of a
classifier. Keypoints (ISS) are the few places that can be found again in another scan.
"""

import numpy as np

import pointloom as loom

# %%
# A shed with a wire above it and a bush beside it, with 5 mm of noise: made here, so that what each point belongs to
# is known.
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
# ``linearity``, ``planarity`` and ``sphericity`` add up to one. The radius is the one thing to choose: some ten times
# the noise at least, and smaller than what is to be told apart.
shapes = loom.compute_eigen_features(cloud, radius=0.15, max_nn=None)
for name in parts:
    of = kind == name
    print(
        f"{name:6}"
        + "".join(
            f"  {key} {np.nanmedian(shapes[key][of]):.2f}"
            for key in ("linearity", "planarity", "sphericity", "verticality", "curvature")
        )
    )
strongest = np.argmax(np.column_stack([shapes[key] for key in ("linearity", "planarity", "sphericity")]), axis=1)
right = {
    "wire": (strongest[kind == "wire"] == 0).mean(),
    "floor": (strongest[kind == "floor"] == 1).mean(),
    "bush": (strongest[kind == "bush"] == 2).mean(),
}
print({name: f"{100 * fraction:.1f} %" for name, fraction in right.items()})
assert right["wire"] > 0.99 and right["floor"] > 0.9 and right["bush"] > 0.5

colors = np.array([[0.9, 0.35, 0.15], [0.35, 0.6, 0.8], [0.3, 0.65, 0.3]])[strongest]
view = loom.View.fit(points, direction=(-0.5, 0.75, -0.45), width=960, height=640)
edge_image = loom.render(
    {"geometry": loom.PointCloud(points, colors=colors), "point_size": 3.5},
    view,
    legend=[("along a line", (0.9, 0.35, 0.15)), ("on a plane", (0.35, 0.6, 0.8)), ("all around", (0.3, 0.65, 0.3))],
)

# %%
# ``estimate_curvature`` is the part of it that finds edges: 0 on a plane, more where it bends.
shed = cloud.select_by_mask(kind == "box")
shed = loom.estimate_curvature(shed, radius=0.15, max_nn=None)
inside = (np.abs(shed.points - [1.0, 0.75, 0.6]) > np.array([1.0, 0.75, 0.6]) - 0.1).sum(axis=1) >= 2
print(
    f"curvature: median on faces {np.median(shed['curvature'][~inside]):.4f}, near edges "
    f"{np.median(shed['curvature'][inside]):.4f}"
)
assert np.median(shed["curvature"][inside]) > 5 * np.median(shed["curvature"][~inside])

# %%
# Keypoints on the shed: where three faces meet, each is alone in its surroundings. ``salient_radius`` is what is
# looked at around a point, ``non_max_radius`` how far apart two keypoints are at least; both in meters.
keypoints, rows = loom.compute_iss_keypoints(shed, salient_radius=0.25, non_max_radius=0.3, return_indices=True)
corners = np.array([[x, y, 1.2] for x in (0, 2.0) for y in (0, 1.5)])
nearest = loom.NearestNeighborSearch(keypoints).knn_search(corners, 1)
distances = np.sqrt(nearest.sqdists[:, 0])
print(f"{len(keypoints)} keypoints; from the roof's four corners the nearest is {np.round(distances, 3)} m")
assert distances.max() < 0.15

marks = [
    loom.TriangleMesh.create_sphere(0.045).translate(position).paint_uniform_color([0.9, 0.2, 0.1])
    for position in keypoints.points
]
keypoint_image = loom.render(
    [{"geometry": shed, "color_by": "curvature", "colormap": "viridis", "point_size": 4}, *marks],
    loom.View.fit(shed.points, direction=(-0.5, 0.75, -0.6), width=960, height=640),
    color_bar=True,
)
