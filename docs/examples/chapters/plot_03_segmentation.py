"""
3. Take a cloud apart
=====================

What belongs to the floor, what is one thing and what another, how large is it, how far is this from that, and what
can be seen from here? You learn the tools with which a cloud becomes things: boxes, colors, distances, hulls,
planes, clusters and hidden points.
"""

# %%
# Crop
# ----
# A box keeps what is inside. Here: the part of the room with the sofa and the coffee table. The six numbers are the
# lowest and the highest corner, in meters, along the axes of the cloud.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

room = loom.datasets.room_cloud(voxel_size=0.02)
corner = room.crop(loom.AxisAlignedBoundingBox([0.1, 1.0, -0.05], [2.5, 3.2, 1.2]))
print(f"{len(corner)} of {len(room)} points lie in the box")

above = {"front": [0.75, -0.55, 0.6], "up": [0, 0, 1], "zoom": 0.62}
cropped = loom.render(corner, above, (960, 640))

# %%
# Take the floor away: planes
# ---------------------------
# Things that stand on a floor are joined by it. So the floor goes first. ``segment_plane`` finds the plane with the
# most points (RANSAC: three points at random make a plane; the plane that most points lie on wins). Three numbers:
# how far a point may lie off the plane (more than the noise of the scan, here 2 cm, so that the rug counts as floor),
# how many points make a guess (3), how many guesses are made.
#
# The plane comes as a, b, c, d with a x + b y + c z + d = 0; (a, b, c) is its normal.

(a, b, c, d), rows = corner.segment_plane(distance_threshold=0.02, ransac_n=3, num_iterations=1000)
print(f"{a:.3f} x + {b:.3f} y + {c:.3f} z + {d:.3f} = 0 with {len(rows)} points")
floor = corner.select_by_index(rows)
things = corner.select_by_index(rows, invert=True)

assert abs(c) > 0.99, "the floor is level"
assert abs(d) < 0.02, "and at height 0"

# %%
# Which are the things? Clusters
# ------------------------------
# DBSCAN joins points that are closer than ``eps``, if they have at least ``min_points`` neighbors within it. With
# voxels of 2 cm an ``eps`` of 5 cm bridges one missing voxel. Label -1 means: belongs to nothing, mostly noise.
#
# In Open3D the same; there ``labels`` is an ``IntVector``, here an array.

labels = np.asarray(things.cluster_dbscan(eps=0.05, min_points=8))
count = labels.max() + 1
sizes = np.bincount(labels[labels >= 0])
print(count, "clusters of", sorted(sizes.tolist(), reverse=True), "points;", (labels < 0).sum(), "points are noise")
assert count >= 2

painted = things.copy()
painted["cluster"] = labels
gray = floor.paint_uniform_color([0.85, 0.85, 0.85])
clusters_seen = loom.render([{"geometry": painted, "color_by": "cluster"}, gray], above, (960, 640))

# %%
# ``eps`` decides. Too small, and a thing falls to pieces; too large, and all is one. Try it on a scale and take the
# middle of the range in which the count stays put:

for eps in (0.02, 0.05, 0.1, 0.3):
    cluster_labels = np.asarray(things.cluster_dbscan(eps, 8))
    print(f"eps {eps:4} m: {cluster_labels.max() + 1:3} clusters, {(cluster_labels < 0).sum():5} points of noise")

assert np.asarray(things.cluster_dbscan(1.0, 8)).max() == 0, "at one metre all is one"

# %%
# How large is a thing? Boxes and hulls
# -------------------------------------
# Of the sofa, the largest cluster: the box along the axes, the smallest box that may be turned, and the convex hull,
# the shape of a rubber skin pulled over it. The turned box tells length, width and height of a thing that stands
# askew. (``get_oriented_bounding_box`` turns with the spread of the points, which is quick, and seldom the smallest.)

sofa = things.select_by_mask(labels == int(np.argmax(sizes)))
upright, oriented = sofa.get_axis_aligned_bounding_box(), sofa.get_minimal_oriented_bounding_box()
hull, _ = sofa.compute_convex_hull()
print("box along the axes:", upright.get_extent().round(2), "m")
print("turned box:", np.sort(oriented.extent)[::-1].round(2), "m")
print(f"hull: {loom.TriangleMesh(hull.vertices, hull.triangles).get_volume():.2f} m3, boxes"
      f" {upright.volume():.2f} and {oriented.volume():.2f} m3")  # fmt: skip

assert oriented.volume() <= 1.01 * upright.volume()
assert np.all(upright.get_min_bound() <= sofa.points.min(axis=0) + 1e-6)
assert loom.TriangleMesh(hull.vertices, hull.triangles).get_volume() <= upright.volume()

measured = loom.render(
    [
        sofa,
        {"geometry": upright, "color": (0.85, 0.15, 0.1), "line_width": 3},
        {"geometry": hull, "wireframe": True, "color": (0.0, 0.55, 0.8)},
    ],
    {"front": [0.85, -0.35, 0.45], "up": [0, 0, 1], "zoom": 0.75},
    (960, 640),
)  # fmt: skip

# %%
# Paint, and measure distances
# ----------------------------
# ``compute_point_cloud_distance`` gives, for each point of one cloud, how far the nearest point of another is. So
# what is near the sofa can be shown, or what changed between two scans of a place.

things["distance"] = things.compute_point_cloud_distance(sofa)
table = things.select_by_mask(labels == int(np.argsort(sizes)[-2]))
gap = float(table["distance"].min())
print(f"the top of the coffee table is {gap * 100:.0f} cm from the sofa, at a height of"
      f" {np.median(table.points[:, 2]) * 100:.0f} cm")  # fmt: skip

distances = loom.render(
    [sofa.paint_uniform_color([1.0, 0.706, 0.0]), {"geometry": table, "color_by": "distance", "colormap": "turbo"}],
    above,
    (960, 640),
    color_bar=True,
)  # fmt: skip
assert 0.05 < gap < 1.0, "one walks through, but not with a bicycle"

# %%
# What is seen from here? Hidden points
# -------------------------------------
# A cloud has no surface, so one looks through it. ``hidden_point_removal`` keeps what an eye at a place would see. Its
# radius is no size of the room: the larger, the more points count as seen, of the hidden ones too. A thousand times
# the diameter is a start, as in Open3D's tutorial.

diameter = float(np.linalg.norm(corner.get_max_bound() - corner.get_min_bound()))
eye = np.array([4.0, 0.2, 1.6])
_, seen = corner.hidden_point_removal(eye, 1000 * diameter)
visible, hidden = corner.select_by_index(seen), corner.select_by_index(seen, invert=True)
print(f"{len(visible) / len(corner):.0%} of the points are seen from {eye} m")
assert 0.05 < len(visible) / len(corner) < 0.9

from_the_other_side = {"front": [-0.45, 0.45, 0.75], "up": [0, 0, 1], "zoom": 0.66}
shadow = loom.render(
    {"seen": visible, "hidden": {"geometry": hidden, "color": (0.78, 0.78, 0.82)}},
    from_the_other_side, (960, 640), legend=[("gray: hidden from the eye", (0.78, 0.78, 0.82))],
)  # fmt: skip

# %%
# Does the radius suit your cloud? Test it from the scanner's own place, where nearly all points should be seen. Fewer:
# take a larger one. One frame of the noisy camera, from where it stood:

frame = loom.datasets.room_frames(24)[20]
scan = loom.PointCloud.create_from_depth_image(frame.depth, frame.intrinsic)
across = float(np.linalg.norm(scan.get_max_bound() - scan.get_min_bound()))
fractions = {times: len(scan.hidden_point_removal([0, 0, 0], times * across)[1]) / len(scan) for times in (100, 1000)}
for times, fraction in fractions.items():
    print(f"{times:4} times the diameter: {fraction:.0%} of what the camera saw counts as seen")
assert fractions[100] < 0.6 and fractions[1000] > 0.9

# %%
# The clusters one after another, as a page that plays:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "clusters.html", max_points=40_000, title="Clusters") as recording:
    things.cluster_dbscan(eps=0.05, min_points=30)
page = folder / "clusters.html"

# %%
# What goes wrong
# ---------------
# **Radii in the wrong unit.** ``eps=50`` on a cloud in meters makes one cluster, ``eps=0.05`` on millimeters none.
# Look at the extent, as in chapter 1.
#
# **The plane is a wall.** The plane with most points need not be the floor. Ask its normal, or take several planes and
# choose:

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
# Try it
# ------
# - Take the box off the floor by its lower corner alone (z from 0.03). When is that enough, and when are planes needed?
# - Which clusters are the legs of the table, and why are they not part of it? Look from below.
# - Move ``eye`` to (2, 2, 4) and look from above.
#
# Where to go next
# ----------------
# :ref:`Chapter 4 <sphx_glr_chapters_plot_04_thin_and_clean.py>` cleans clouds. The page
# :doc:`Ground classification </terrain>` has what to take for uneven ground in the open, where no plane fits. The page
# :doc:`Rendering images and plots </pictures>` has all styles of boxes, hulls and labels.
