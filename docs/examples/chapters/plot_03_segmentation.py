"""
3. Segmentation: planes, clusters, hidden points
================================================

In this chapter you separate the floor of a room from the objects on it, find the objects as clusters, and measure their
size and distance. You also compute which points are visible from a given position. The tools are bounding boxes, plane
segmentation, DBSCAN, convex hulls, cloud-to-cloud distances and hidden point removal.
"""

# %%
# Crop
# ----
# A bounding box selects the points inside it. This one contains the sofa and the coffee table of the room. It is
# defined by its lowest and its highest corner, in meters along the axes.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

room = loom.datasets.room_cloud(voxel_size=0.02)
corner = room.crop(loom.AxisAlignedBoundingBox([0.1, 1.0, -0.05], [2.5, 3.2, 1.2]))
print(f"{len(corner)} of {len(room)} points are in the box")

from_above = {"front": [0.75, -0.55, 0.6], "up": [0, 0, 1], "zoom": 0.62}
cropped = loom.render(corner, from_above, (960, 640))

# %%
# Remove the floor: plane segmentation
# ------------------------------------
# The floor connects the objects on it, so it is removed first. ``segment_plane`` finds the plane with the most points
# by RANSAC: it draws three random points, counts the points close to their plane, and repeats. ``distance_threshold``
# is the maximum distance of a point from the plane. It should exceed the noise of the scan. Here it is 2 cm, so that
# the rug belongs to the floor. ``ransac_n`` is the number of points per sample, ``num_iterations`` the number of
# samples.
#
# The result is (a, b, c, d) with a x + b y + c z + d = 0. The normal is (a, b, c).

(a, b, c, d), rows = corner.segment_plane(distance_threshold=0.02, ransac_n=3, num_iterations=1000)
print(f"{a:.3f} x + {b:.3f} y + {c:.3f} z + {d:.3f} = 0 with {len(rows)} points")
floor = corner.select_by_index(rows)
things = corner.select_by_index(rows, invert=True)

assert abs(c) > 0.99, "the floor is level"
assert abs(d) < 0.02, "and at height 0"

# %%
# Find the objects: clusters
# --------------------------
# DBSCAN joins points that are closer than ``eps`` and have at least ``min_points`` neighbors within that distance. With
# voxels of 2 cm, an ``eps`` of 5 cm bridges one missing voxel. The label -1 marks noise.
#
# Open3D's ``cluster_dbscan`` returns an ``IntVector``. Here the labels are an array.

labels = np.asarray(things.cluster_dbscan(eps=0.05, min_points=8))
count = labels.max() + 1
sizes = np.bincount(labels[labels >= 0])
print(count, "clusters of", sorted(sizes.tolist(), reverse=True), "points;", (labels < 0).sum(), "points are noise")
assert count >= 2

painted = things.copy()
painted["cluster"] = labels
gray = floor.paint_uniform_color([0.85, 0.85, 0.85])
clusters_seen = loom.render([{"geometry": painted, "color_by": "cluster"}, gray], from_above, (960, 640))

# %%
# If ``eps`` is too small, an object breaks into several clusters. If it is too large, objects merge. Try several
# values, and use one from the middle of the range in which the number of clusters is stable:

for eps in (0.02, 0.05, 0.1, 0.3):
    cluster_labels = np.asarray(things.cluster_dbscan(eps, 8))
    print(f"eps {eps:4} m: {cluster_labels.max() + 1:3} clusters, {(cluster_labels < 0).sum():5} points of noise")

assert np.asarray(things.cluster_dbscan(1.0, 8)).max() == 0, "with 1 m there is one cluster"

# %%
# Measure an object: boxes and hulls
# ----------------------------------
# The largest cluster is the sofa. The script computes its axis-aligned bounding box, its minimal oriented bounding box
# and its convex hull. The oriented box gives length, width and height of a rotated object.
# ``get_oriented_bounding_box`` uses the principal axes of the points. It is faster, but its box is rarely minimal.

sofa = things.select_by_mask(labels == int(np.argmax(sizes)))
aligned, oriented = sofa.get_axis_aligned_bounding_box(), sofa.get_minimal_oriented_bounding_box()
hull, _ = sofa.compute_convex_hull()
print("box along the axes:", aligned.get_extent().round(2), "m")
print("oriented box:", np.sort(oriented.extent)[::-1].round(2), "m")
print(f"hull: {loom.TriangleMesh(hull.vertices, hull.triangles).get_volume():.2f} m3, boxes"
      f" {aligned.volume():.2f} and {oriented.volume():.2f} m3")  # fmt: skip

assert oriented.volume() <= 1.01 * aligned.volume()
assert np.all(aligned.get_min_bound() <= sofa.points.min(axis=0) + 1e-6)
assert loom.TriangleMesh(hull.vertices, hull.triangles).get_volume() <= aligned.volume()

measured = loom.render(
    [
        sofa,
        {"geometry": aligned, "color": (0.85, 0.15, 0.1), "line_width": 3},
        {"geometry": hull, "wireframe": True, "color": (0.0, 0.55, 0.8)},
    ],
    {"front": [0.85, -0.35, 0.45], "up": [0, 0, 1], "zoom": 0.75},
    (960, 640),
)  # fmt: skip

# %%
# Compute distances
# -----------------
# ``compute_point_cloud_distance`` returns, for each point of a cloud, the distance to the nearest point of another
# cloud. Use it to measure the gap between objects, or to detect changes between two scans.

things["distance"] = things.compute_point_cloud_distance(sofa)
table = things.select_by_mask(labels == int(np.argsort(sizes)[-2]))
gap = float(table["distance"].min())
print(f"the top of the coffee table is {gap * 100:.0f} cm from the sofa, at a height of"
      f" {np.median(table.points[:, 2]) * 100:.0f} cm")  # fmt: skip

distances = loom.render(
    [sofa.paint_uniform_color([1.0, 0.706, 0.0]), {"geometry": table, "color_by": "distance", "colormap": "turbo"}],
    from_above,
    (960, 640),
    color_bar=True,
)  # fmt: skip
assert 0.05 < gap < 1.0, "the gap is between 5 cm and 1 m"

# %%
# Visible and hidden points
# -------------------------
# Points have no area and do not hide each other. ``hidden_point_removal`` estimates which points are visible from a
# position. Its ``radius`` is the radius of a sphere that is used for the projection, not a size in the scene. A larger
# radius classifies more points as visible, including hidden ones. A good first value is 1,000 times the diameter of the
# cloud, as in Open3D's tutorial.

diameter = float(np.linalg.norm(corner.get_max_bound() - corner.get_min_bound()))
viewpoint = np.array([4.0, 0.2, 1.6])
_, visible_rows = corner.hidden_point_removal(viewpoint, 1000 * diameter)
visible, hidden = corner.select_by_index(visible_rows), corner.select_by_index(visible_rows, invert=True)
print(f"{len(visible) / len(corner):.0%} of the points are visible from {viewpoint} m")
assert 0.05 < len(visible) / len(corner) < 0.9

from_the_other_side = {"front": [-0.45, 0.45, 0.75], "up": [0, 0, 1], "zoom": 0.66}
visibility = loom.render(
    {"visible": visible, "hidden": {"geometry": hidden, "color": (0.78, 0.78, 0.82)}},
    from_the_other_side, (960, 640), legend=[("gray: hidden", (0.78, 0.78, 0.82))],
)  # fmt: skip

# %%
# Check the radius from the position of the scanner, where nearly all points should be visible. If fewer are, use a
# larger radius. This is one frame of the noisy camera, seen from the camera position:

frame = loom.datasets.room_frames(24)[20]
scan = loom.PointCloud.create_from_depth_image(frame.depth, frame.intrinsic)
diameter_of_scan = float(np.linalg.norm(scan.get_max_bound() - scan.get_min_bound()))
fractions = {
    times: len(scan.hidden_point_removal([0, 0, 0], times * diameter_of_scan)[1]) / len(scan) for times in (100, 1000)
}
for times, fraction in fractions.items():
    print(f"{times:4} times the diameter: {fraction:.0%} of the camera's points are classified as visible")
assert fractions[100] < 0.6 and fractions[1000] > 0.9

# %%
# A recording of the clustering:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "clusters.html", max_points=40_000, title="Clusters") as recording:
    things.cluster_dbscan(eps=0.05, min_points=30)
page = folder / "clusters.html"

# %%
# Common mistakes
# ---------------
# **A radius in the wrong unit.** On a cloud in meters, ``eps=50`` gives one cluster. On a cloud in millimeters,
# ``eps=0.05`` gives none. Print the extent first, as in chapter 1.
#
# **The largest plane is a wall.** The plane with the most points is not always the floor. Check its normal, or segment
# several planes and choose one:

labels_of_planes, planes = room.segment_planes(distance_threshold=0.03, num_iterations=500, max_planes=6)
for k, (nx, ny, nz, _) in enumerate(planes):
    print(f"plane {k}: normal ({nx:5.2f} {ny:5.2f} {nz:5.2f}), {(labels_of_planes == k).sum():6} points")

room["plane"] = np.asarray(labels_of_planes)
level = [k for k, model in enumerate(planes) if abs(model[2]) > 0.99]
heights = {k: float(room.points[np.asarray(labels_of_planes) == k, 2].mean()) for k in level}
lowest = min(heights, key=heights.get)
print(f"the floor is plane {lowest}, at a height of {heights[lowest]:.2f} m")
assert abs(heights[lowest]) < 0.03

no_ceiling = room.crop(loom.AxisAlignedBoundingBox([-0.1, 0.06, -0.1], [4.92, 4.3, 2.5]))
planes_seen = loom.render(
    {"geometry": no_ceiling.select_by_mask(np.asarray(no_ceiling["plane"]) >= 0), "color_by": "plane"},
    {"front": [0.55, -0.75, 0.62], "up": [0, 0, 1], "zoom": 0.56},
    (960, 640),
)

# %%
# What to change
# --------------
# - ``distance_threshold`` [m]: with 0.005, does the rug still belong to the floor?
# - ``eps`` [m] and ``min_points``: find the values at which the table and the sofa merge.
# - The crop box: set its lowest z to 0.03. When is that sufficient, and when is plane segmentation needed?
# - ``viewpoint`` [m]: (2, 2, 4) looks down from above.
#
# Next
# ----
# - :ref:`Chapter 4 <sphx_glr_chapters_plot_04_downsampling_and_outliers.py>`: downsampling and outlier removal.
# - :doc:`Ground classification </terrain>`: uneven ground outdoors, where no plane fits.
# - :doc:`Rendering images and plots </pictures>`: styles of boxes, hulls and labels.
