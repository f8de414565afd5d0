"""
Normals, and the side they look to
==================================

A plane fitted to the neighbors of a point gives its normal, but not which of the two sides is outside. Three ways
of choosing it are compared with the truth here. Take this page before a surface is made of points: a normal that
looks to the wrong side turns the surface inside out there.
"""

import numpy as np

import pointloom as loom

# %%
# Points on a figure whose surface is known, so the true normals are too.
mesh = loom.datasets.object_mesh()
exact = mesh.compute_vertex_normals().sample_points_uniformly(20_000, seed=0)
truth = exact.normals
size = np.linalg.norm(exact.get_max_bound() - exact.get_min_bound())
cloud = loom.PointCloud(exact.points).estimate_normals(max_nn=16)
print(f"{len(cloud)} points, {size:.3f} m across")

# %%
# The directions are right: the median angle to the true ones is some degrees on feathers of 3 mm. ``max_nn`` is what
# to change for other data: more neighbors even out noise, and round off edges.
cosines = np.abs(np.einsum("ij,ij->i", cloud.normals, truth)).clip(0, 1)
angle = np.degrees(np.arccos(cosines))
print(f"median angle to the true normals {np.median(angle):.2f} degrees")
assert np.median(angle) < 10

# %%
# The sides are not: nothing has told them. ``orient_normals_towards_camera_location`` is right for one view,
# ``orient_normals_to_align_with_direction`` for terrain, and ``orient_normals_consistent_tangent_plane`` for a whole
# object: it hands the side on from neighbor to neighbor. ``normal_disagreement`` needs no truth: it says how many
# neighbors contradict each other, from 0 to 1.
ways = {
    "as fitted": cloud,
    "toward (0, 0, 1)": cloud.orient_normals_to_align_with_direction([0, 0, 1]),
    "toward a camera": cloud.orient_normals_towards_camera_location(
        cloud.get_center() + np.array([0, -3 * size, size])
    ),
    "handed on": cloud.orient_normals_consistent_tangent_plane(12),
}
right = {}
for name, oriented in ways.items():
    agrees = np.einsum("ij,ij->i", oriented.normals, truth) > 0
    right[name] = agrees.mean()
    print(f"{name:18} {100 * agrees.mean():5.1f} % outwards, disagreement {oriented.normal_disagreement():.3f}")
assert right["handed on"] > 0.95
assert right["toward (0, 0, 1)"] < 0.9  # the lower half looks inwards

# %%
# Orange looks inwards, blue outwards.
scene, labels = {}, []
for index, (name, oriented) in enumerate(ways.items()):
    agrees = np.einsum("ij,ij->i", oriented.normals, truth) > 0
    painted = loom.PointCloud(oriented.points, colors=np.where(agrees[:, None], [0.15, 0.5, 0.8], [0.95, 0.5, 0.1]))
    shift = np.array([0.85 * size * index, 0, 0])
    scene[name] = {"geometry": painted.translate(shift), "point_size": 3}
    labels.append((f"{name}: {100 * right[name]:.0f} %", shift + cloud.get_center() + [0, 0, 0.62 * size]))
drawn = np.vstack([style["geometry"].points for style in scene.values()] + [[position] for _, position in labels])
view = loom.View.fit(drawn, direction=(0.0, 1.0, -0.3), width=1120, height=420)
sides = loom.render(scene, view, labels=labels)

# %%
# What the normals are for: with the right sides, the surface closes.
surface = loom.TriangleMesh.create_from_point_cloud_poisson(ways["handed on"], depth=6)[0]
print(surface)
closed = loom.render(
    surface.compute_vertex_normals().paint_uniform_color([0.7, 0.76, 0.8]),
    {"front": [0.5, -1.0, 0.35], "up": [0, 0, 1], "zoom": 0.75},
    (960, 640),
)
