"""
11. Surfaces from points
========================

Points have no inside, no area, nothing to print or to put an image on: for these one needs a surface. You learn the
three classic ways, which one suits which scan, what their one number means, and how to cut away what a method made
up.
"""

# %%
# Points of a known figure
# ------------------------
# Samples of a figure 30 cm high, so that each surface can be held against the true one. Poisson-disk samples are spread
# evenly; scans are not, and we shall see who minds.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

figure = loom.datasets.object_mesh()
cloud = figure.sample_points_poisson_disk(8000, seed=0)
spacing = float(np.median(cloud.compute_nearest_neighbor_distance()))
print(cloud, f"some {spacing * 1000:.1f} mm apart")

scene = loom.RaycastingScene()
scene.add_triangles(figure)


def error(mesh: loom.TriangleMesh) -> float:
    """Half of the mesh is within this distance of the true surface [mm]."""
    samples = mesh.sample_points_uniformly(5000, seed=1).points
    return 1000 * float(np.median(scene.compute_distance(samples.astype(np.float32))))


step = np.array([0.25, 0, 0])
view = {"front": [0.1, -1, 0.15], "up": [0, 0, 1], "zoom": 0.5}


def side_by_side(meshes: list, names: list[str]) -> np.ndarray:
    """An image of meshes in a row, with what each is."""
    row = [mesh.translate(k * step) for k, mesh in enumerate(meshes)]
    labels = [(name, k * step - [0, 0, 0.2]) for k, name in enumerate(names)]
    return loom.render([mesh.compute_vertex_normals() for mesh in row], view, (960, 640), labels=labels)


# %%
# Alpha shapes
# ------------
# A ball of radius alpha rolls everywhere around and, where the points let it, between them; what it cannot reach is
# inside. It needs no normals. Alpha is a length: a bit above the spacing keeps detail and tears holes, a large one
# fills hollows, an infinite one is the convex hull.
#
# In Open3D: ``TriangleMesh.create_from_point_cloud_alpha_shape(cloud, alpha)``; that name works here too, as do those
# below.

alphas = [1.5 * spacing, 4 * spacing, 20 * spacing]
shapes = loom.TriangleMesh.create_from_point_cloud_alpha_shape(cloud, alphas)
for alpha, mesh in zip(alphas, shapes, strict=True):
    closed = "closed" if mesh.is_watertight() else "open"
    print(f"alpha {alpha * 1000:5.1f} mm: {len(mesh.triangles):6} triangles, {closed}, {error(mesh):.2f} mm off")
alpha_shapes = side_by_side(shapes, [f"alpha {alpha * 1000:.0f} mm" for alpha in alphas])

assert error(shapes[1]) < error(shapes[2]), "a large alpha fills hollows"

# %%
# Ball pivoting
# -------------
# A ball lies on three points, which become a triangle, and tips over each edge until it meets the next point. It
# keeps the points themselves, so it keeps their noise, and where points are thin it leaves holes. It needs normals
# that look outwards. Give two or three radii, from the spacing up; ``None`` chooses them.

ball = loom.TriangleMesh.create_from_point_cloud_ball_pivoting(cloud, [1.2 * spacing, 2.5 * spacing])
print(f"ball pivoting: {len(ball.triangles)} triangles, {error(ball):.2f} mm off, closed: {ball.is_watertight()}")
assert len(ball.vertices) == len(cloud), "its vertices are the points"

# %%
# Poisson
# -------
# The smoothest closed surface whose normals agree with those of the points. It averages noise and closes holes, also
# those that should stay open; of a scan of one side it may be cut open where it leaves the box that it is computed in.
# ``depth`` is its resolution: 2^depth cells along the longest side; 8 for an object, 9 or 10 for detail. Each step is
# four times the triangles, until cells are finer than the points are apart: from there on it adds nothing.

poisson, densities = loom.TriangleMesh.create_from_point_cloud_poisson(cloud, depth=7)
cell = float(np.max(figure.get_max_bound() - figure.get_min_bound())) / 2**7 * 1000
print(f"Poisson: {len(poisson.triangles)} triangles, {error(poisson):.2f} mm off, cells of some {cell:.0f} mm,"
      f" closed: {poisson.is_watertight()}")  # fmt: skip
assert poisson.is_watertight() and error(poisson) < 1.0

three = side_by_side(
    [shapes[1].paint_uniform_color([0.55, 0.7, 0.85]), ball.paint_uniform_color([0.6, 0.8, 0.6]),
     poisson.paint_uniform_color([0.95, 0.75, 0.45])],
    ["alpha shape", "ball pivoting", "Poisson"],
)  # fmt: skip

# %%
# A real scan: one side only, and noise
# -------------------------------------
# Now what a camera gives: two scans from the front, in their true places. No camera saw the back. Normals have to be
# made; since we know where each camera stood, they are turned toward it.

scans = loom.datasets.object_scans(10)
parts = []
for k in (0, 1):
    part = scans.scans[k].estimate_normals(radius=4 * spacing, max_nn=30)
    parts.append(part.orient_normals_towards_camera_location([0, 0, 0]).transform(scans.poses[k]))
scan = loom.PointCloud.concatenate(parts).voxel_down_sample(0.5 * spacing).normalize_normals()
surface, densities = loom.TriangleMesh.create_from_point_cloud_poisson(scan, depth=7)
densities = np.asarray(densities)
closed = "and is closed" if surface.is_watertight() else "and is cut open where it leaves the box"
print(f"{len(scan)} points of two sides; Poisson makes up the rest {closed}")

# %%
# What is made up? Each vertex has a **density**: how many points speak for it, as a depth of the tree, so that one
# less means a quarter of the points. Low ones are guesses. Colored by density, the guess at the back shows, and a
# mask cuts it. Here a third of the vertices is guessed; of a scan from all sides it is a hundredth. Raise the fraction
# until nothing is left that nobody saw.

fraction = (densities - densities.min()) / np.ptp(densities)
shown = surface.copy()
shown.vertex_colors = (1 - fraction)[:, None] * [0.25, 0.25, 0.75] + fraction[:, None] * [1.0, 0.75, 0.2]
low = float(np.quantile(densities, 0.35))
sure = surface.remove_vertices_by_mask(densities < low)
trimmed = surface.trim(densities, low)
print(f"below {low:.1f}: {(densities < low).mean():.0%} of the vertices go")

side_view = {"front": [1.0, -0.35, 0.2], "up": [0, 0, 1], "zoom": 0.52}
along = np.array([0.07, 0.19, 0])
trimmed_mesh = trimmed.compute_vertex_normals().paint_uniform_color([0.95, 0.75, 0.45])
masked = loom.render(
    [shown.translate(-along), trimmed_mesh.translate(along)],
    side_view, (960, 640), labels=[("by density", -along - [0, 0, 0.2]), ("cut", along - [0, 0, 0.2])],
)  # fmt: skip


def worst(mesh: loom.TriangleMesh) -> float:
    """A twentieth of the mesh is farther off the true surface than this [mm]."""
    samples = mesh.sample_points_uniformly(5000, seed=1).points
    return 1000 * float(np.quantile(scene.compute_distance(samples.astype(np.float32)), 0.95))


print(f"the worst twentieth is {worst(surface):.0f} mm off before, {worst(sure):.0f} mm after the mask,"
      f" {worst(trimmed):.0f} mm after trim")  # fmt: skip
assert worst(sure) < 0.5 * worst(surface)
assert not sure.is_watertight(), "it is open where nobody looked"

# %%
# ``remove_vertices_by_mask`` cuts along triangles, as in Open3D; ``trim`` cuts along a smooth line and drops islands.
#
# All in one call: ``create_surface`` estimates missing normals and checks whether the result is reliable.

result = loom.meshing.create_surface(scan, "poisson", depth=7)
print(result)
assert not result.reliable and result.warnings[0] in str(result)

# %%
# To turn: all of it by density, then what is left, in the colors of the scan.

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "surface.html", automatic=False, title="Poisson, and what points bear out") as recording:
    recording.add("surface", shown)
    recording.step("all of it, by density")
    recording.update("surface", trimmed.compute_vertex_normals())
    recording.step("cut")
page = folder / "surface.html"

# %%
# What goes wrong
# ---------------
# **Normals on both sides.** ``estimate_normals`` does not know outside from inside: its signs change from patch to
# patch. Poisson and ball pivoting then make a crumpled thing. ``normal_disagreement`` tells the fraction of neighbors
# that look to opposite sides: it should be near 0. It counts the borders between patches, not their size: 2 % may be
# half the surface, so look at it, colored by its normals. From a tenth on Poisson warns; a closed figure may be spoilt
# below that. ``orient_normals_consistent_tangent_plane`` mends it.

guessed = loom.PointCloud(cloud.points).estimate_normals(max_nn=20)
oriented = guessed.orient_normals_consistent_tangent_plane(20)
crumpled, _ = loom.TriangleMesh.create_from_point_cloud_poisson(guessed, depth=6)
repaired, _ = loom.TriangleMesh.create_from_point_cloud_poisson(oriented, depth=6)
print(f"as guessed: {guessed.normal_disagreement():.1%} disagree, the surface is {error(crumpled):.1f} mm off")
print(f"oriented:   {oriented.normal_disagreement():.1%} disagree, the surface is {error(repaired):.1f} mm off")
assert oriented.normal_disagreement() < 0.2 * guessed.normal_disagreement()
assert error(repaired) < 0.5 * error(crumpled)

inside_out = side_by_side([crumpled, repaired], ["signs as guessed", "oriented"])

# %%
# **Inside out.** If all normals look inwards, the surface is right and dark: ``cloud.flip_normals()``.
#
# **A radius in the wrong unit.** An alpha of 0.03 on a cloud in millimeters gives no triangle at all.
#
# Try it
# ------
# - Add 2 mm of noise to ``cloud.points``. Which of the three surfaces suffers most?
# - Poisson with depth 5 and 9. How do triangles and error change?
# - Ball pivoting with one radius: where are the holes?
#
# Where to go next
# ----------------
# :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>` makes surfaces of depth images, which is better
# still where one has them. The page :doc:`Surfaces from points </surfaces>` has figures for each method,
# :doc:`Meshes </meshes>` what to do with a mesh: clean, simplify, smooth, texture.
