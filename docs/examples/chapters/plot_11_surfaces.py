"""
11. Surface reconstruction
==========================

Volume, area, 3D printing and texture require a surface. In this chapter you reconstruct a surface from points with
three methods: alpha shapes, ball pivoting and Poisson. You choose the method and its parameter, and remove parts of the
surface that no points support.
"""

# %%
# Points with a known surface
# ---------------------------
# The points are samples of an object 30 cm high, so each surface can be compared with the true one. Poisson-disk
# samples are evenly spaced. Real scans are not, as the last part of this chapter shows.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

figure = loom.datasets.object_mesh()
cloud = figure.sample_points_poisson_disk(8000, seed=0)
spacing = float(np.median(cloud.compute_nearest_neighbor_distance()))
print(cloud, f"point spacing {spacing * 1000:.1f} mm")

scene = loom.RaycastingScene()
scene.add_triangles(figure)


def error(mesh: loom.TriangleMesh) -> float:
    """Median distance of the mesh from the true surface [mm]."""
    samples = mesh.sample_points_uniformly(5000, seed=1).points
    return 1000 * float(np.median(scene.compute_distance(samples.astype(np.float32))))


step = np.array([0.25, 0, 0])
view = {"front": [0.1, -1, 0.15], "up": [0, 0, 1], "zoom": 0.5}


def side_by_side(meshes: list, names: list[str]) -> np.ndarray:
    """An image of meshes in a row, with labels."""
    row = [mesh.translate(k * step) for k, mesh in enumerate(meshes)]
    labels = [(name, k * step - [0, 0, 0.2]) for k, name in enumerate(names)]
    return loom.render([mesh.compute_vertex_normals() for mesh in row], view, (960, 640), labels=labels)


# %%
# Alpha shapes
# ------------
# A sphere of radius alpha moves through all space that contains no points. The alpha shape is the boundary of the space
# that it cannot reach. The method needs no normals. Alpha is a length. A value slightly above the point spacing
# preserves detail and leaves holes. A large value fills concave regions. An infinite value gives the convex hull.
#
# Open3D's name works here, too: ``TriangleMesh.create_from_point_cloud_alpha_shape(cloud, alpha)``. The same is true of
# the following methods.

alphas = [1.5 * spacing, 4 * spacing, 20 * spacing]
shapes = loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, alphas)
for alpha, mesh in zip(alphas, shapes, strict=True):
    closed = "closed" if mesh.is_watertight() else "open"
    print(f"alpha {alpha * 1000:5.1f} mm: {len(mesh.triangles):6} triangles, {closed}, error {error(mesh):.2f} mm")
alpha_shapes = side_by_side(shapes, [f"alpha {alpha * 1000:.0f} mm" for alpha in alphas])

assert error(shapes[1]) < error(shapes[2]), "a large alpha fills concave regions"

# %%
# Ball pivoting
# -------------
# A ball that touches three points creates a triangle. It then rotates about each edge until it touches the next point.
# The vertices are the input points, including their noise. Holes remain in sparse regions. The method requires
# normals that point outward. Give two or three radii, beginning with the point spacing. ``None`` selects them
# automatically.

ball = loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, [1.2 * spacing, 2.5 * spacing])
print(f"ball pivoting: {len(ball.triangles)} triangles, error {error(ball):.2f} mm, closed: {ball.is_watertight()}")
assert len(ball.vertices) == len(cloud), "its vertices are the points"

# %%
# Poisson reconstruction
# ----------------------
# Poisson reconstruction computes a smooth closed surface whose normals agree with those of the points. It averages
# noise and closes holes, even those that are real. If a scan shows one side only, the surface may be open at the border
# of its bounding box. ``depth`` is the resolution: 2^depth cells along the longest side. Use 8 for an object, 9 or 10
# for more detail. Each increment gives four times as many triangles, until the cells are smaller than the point
# spacing. Beyond that there is no improvement.

poisson, densities = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, depth=7)
cell = float(np.max(figure.get_max_bound() - figure.get_min_bound())) / 2**7 * 1000
print(f"Poisson: {len(poisson.triangles)} triangles, error {error(poisson):.2f} mm, cells of {cell:.0f} mm,"
      f" closed: {poisson.is_watertight()}")  # fmt: skip
assert poisson.is_watertight() and error(poisson) < 1.0

three = side_by_side(
    [shapes[1].paint_uniform_color([0.55, 0.7, 0.85]), ball.paint_uniform_color([0.6, 0.8, 0.6]),
     poisson.paint_uniform_color([0.95, 0.75, 0.45])],
    ["alpha shape", "ball pivoting", "Poisson"],
)  # fmt: skip

# %%
# A partial scan with noise
# -------------------------
# This scan consists of two views from the front, with known poses and noise. The back was not observed. Normals are
# estimated and oriented toward the cameras.

scans = loom.datasets.object_scans(10)
parts = []
for k in (0, 1):
    part = scans.scans[k].estimate_normals(radius=4 * spacing, max_nn=30)
    parts.append(part.orient_normals_towards_camera_location([0, 0, 0]).transform(scans.poses[k]))
scan = loom.PointCloud.concatenate(parts).voxel_down_sample(0.5 * spacing).normalize_normals()
surface, densities = loom.TriangleMesh.create_from_point_cloud_poisson(scan, depth=7)
densities = np.asarray(densities)
closed = "and is closed" if surface.is_watertight() else "and is open at the border of the box"
print(f"{len(scan)} points of two views; Poisson completes the surface {closed}")

# %%
# Each vertex has a **density**. It is the logarithm of the number of supporting points, in units of octree levels: one
# less is a quarter of the points. Vertices of low density are extrapolated. The image shows the density by color and
# the surface after removal of low densities. Here a third of the vertices is extrapolated. With scans from all sides it
# would be a hundredth. Increase the fraction until all unobserved parts are removed.

fraction = (densities - densities.min()) / np.ptp(densities)
colored_by_density = surface.copy()
colored_by_density.vertex_colors = (1 - fraction)[:, None] * [0.25, 0.25, 0.75] + fraction[:, None] * [1.0, 0.75, 0.2]
low = float(np.quantile(densities, 0.35))
masked_surface = surface.remove_vertices_by_mask(densities < low)
trimmed = surface.trim(densities, low)
print(f"below {low:.1f}: {(densities < low).mean():.0%} of the vertices are removed")

side_view = {"front": [1.0, -0.35, 0.2], "up": [0, 0, 1], "zoom": 0.52}
along = np.array([0.07, 0.19, 0])
trimmed_mesh = trimmed.compute_vertex_normals().paint_uniform_color([0.95, 0.75, 0.45])
masked = loom.render(
    [colored_by_density.translate(-along), trimmed_mesh.translate(along)],
    side_view, (960, 640), labels=[("by density", -along - [0, 0, 0.2]), ("trimmed", along - [0, 0, 0.2])],
)  # fmt: skip


def worst(mesh: loom.TriangleMesh) -> float:
    """95th percentile of the distance from the true surface [mm]."""
    samples = mesh.sample_points_uniformly(5000, seed=1).points
    return 1000 * float(np.quantile(scene.compute_distance(samples.astype(np.float32)), 0.95))


print(f"95th percentile of the error: {worst(surface):.0f} mm before, {worst(masked_surface):.0f} mm after the mask,"
      f" {worst(trimmed):.0f} mm after trim")  # fmt: skip
assert worst(masked_surface) < 0.5 * worst(surface)
assert not masked_surface.is_watertight(), "it is open where there are no points"

# %%
# ``remove_vertices_by_mask`` removes whole triangles, as in Open3D. ``trim`` cuts along a smooth line and removes
# isolated parts.
#
# ``create_surface`` performs all steps in one call. It estimates missing normals and checks whether the result is
# reliable.

result = loom.meshing.create_surface(scan, "poisson", depth=7)
print(result)
assert not result.reliable and result.warnings[0] in str(result)

# %%
# An interactive page: the complete surface colored by density, then the trimmed surface.

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(
    folder / "surface.html", automatic=False, title="Poisson surface, before and after trimming"
) as recording:
    recording.add("surface", colored_by_density)
    recording.step("complete, by density")
    recording.update("surface", trimmed.compute_vertex_normals())
    recording.step("trimmed")
page = folder / "surface.html"

# %%
# Common mistakes
# ---------------
# **Inconsistent normals.** ``estimate_normals`` does not determine the sign, so the normals of different regions may
# point to opposite sides. Poisson reconstruction and ball pivoting then create a wrong surface. ``normal_disagreement``
# is the fraction of neighbors with opposite normals. It should be close to 0. It counts the borders between regions,
# not their area: with 2%, half of the surface may be inverted. Display the normals as colors. Poisson warns above 10%,
# but smaller values may also damage the result. ``orient_normals_consistent_tangent_plane`` makes them consistent.

unoriented = loom.PointCloud(cloud.points).estimate_normals(max_nn=20)
oriented = unoriented.orient_normals_consistent_tangent_plane(20)
from_unoriented, _ = loom.TriangleMesh.create_from_point_cloud_poisson(unoriented, depth=6)
from_oriented, _ = loom.TriangleMesh.create_from_point_cloud_poisson(oriented, depth=6)
print(
    f"estimated: {unoriented.normal_disagreement():.1%} disagree, error of the surface {error(from_unoriented):.1f} mm"
)
print(f"oriented:  {oriented.normal_disagreement():.1%} disagree, error of the surface {error(from_oriented):.1f} mm")
assert oriented.normal_disagreement() < 0.2 * unoriented.normal_disagreement()
assert error(from_oriented) < 0.5 * error(from_unoriented)

orientation_comparison = side_by_side([from_unoriented, from_oriented], ["estimated normals", "oriented normals"])

# %%
# **Inverted normals.** If all normals point inward, the shape is correct but the shading is dark. Use
# ``cloud.flip_normals()``.
#
# **A radius in the wrong unit.** An alpha of 0.03 on a cloud in millimeters gives no triangles.
#
# What to change
# --------------
# - The noise: add 2 mm to ``cloud.points``. Which method is the most sensitive?
# - ``depth`` of Poisson: compare triangles and error for 5 and 9.
# - The radii of ball pivoting [m]: use one radius only. Where are the holes?
#
# Next
# ----
# - :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>`: surfaces from depth images, which are more
#   accurate if such images are available.
# - :doc:`Surface reconstruction </surfaces>`: measurements for each method.
# - :doc:`Triangle meshes </meshes>`: cleaning, simplification, smoothing, texture.
