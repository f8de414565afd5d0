"""
7. ICP: bring two clouds together
=================================

Two scans of one place, each in the coordinates of its own scanner: ICP finds the motion that lays one onto the other,
if you know roughly where to begin. You learn its kinds, its one important number, how to tell whether it worked, and
what it cannot know.
"""

# %%
# Two scans and the truth
# -----------------------
# Two images of a depth camera, a step apart, each a cloud in its camera's own coordinates. The data knows where the
# cameras stood, so we can measure how wrong a result is. A pose is a 4 x 4 matrix that takes the source's coordinates
# to the target's: ``T_target_source``.

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
frames = loom.datasets.room_frames(24)


def scan(index: int, voxel_size: float = 0.03) -> loom.PointCloud:
    """A frame as a cloud in its camera's coordinates, thinned, with normals toward the camera."""
    frame = frames[index]
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=5.0)
    cloud = loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic).voxel_down_sample(voxel_size)
    return cloud.estimate_normals(radius=3 * voxel_size, max_nn=30).orient_normals_towards_camera_location([0, 0, 0])


def off(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """How far a pose is from the true one: degrees and meters."""
    rest = np.linalg.inv(truth) @ T
    angle = np.degrees(np.arccos(np.clip((np.trace(rest[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), float(np.linalg.norm(rest[:3, 3]))


def perturbation(degrees: float, step: tuple[float, float, float]) -> np.ndarray:
    """A motion: a turn about the vertical axis of the camera, and a step."""
    angle, T = np.radians(degrees), np.eye(4)
    T[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    T[:3, 3] = step
    return T


source, target = scan(6), scan(10)
truth = np.linalg.inv(frames[10].T_world_camera) @ frames[6].T_world_camera
start = truth @ perturbation(5.0, (0.06, -0.04, 0.05))
print(source, target)
print("the start is {:.1f} degrees and {:.2f} m off".format(*off(start, truth)))

# %%
# Where we begin: orange has to come onto blue.

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.55, 0.85)
SIZE = {"point_size": 0.025, "metric": True}
view = {"front": [0.5, -0.55, -0.8], "up": [0, -1, 0], "zoom": 0.5}


def drawn(T: np.ndarray) -> dict:
    """Both clouds, the source where the pose puts it."""
    return {
        "source": {"geometry": source, "pose": T, "color": ORANGE, **SIZE},
        "target": {"geometry": target, "color": BLUE, **SIZE},
    }


before = loom.render(drawn(start), view, (960, 640), legend=True)

# %%
# How good is a pose?
# -------------------
# Each source point looks for the nearest target point. If that is nearer than ``max_correspondence_distance``, the
# two are a pair. **Fitness** is the fraction of source points that have a partner, 0 to 1. **inlier_rmse** is how far
# the partners are apart, in meters. Neither knows the truth; and both depend on the distance, so compare them at one
# distance only.
#
# In Open3D all names of this chapter are the same, under ``o3d.pipelines.registration``.

distance = 0.12
at_start = reg.evaluate_registration(source, target, distance, start)
print(at_start)

# %%
# Point to point
# --------------
# Pair each point with its nearest, move the source so that the pairs come together, and again. Walls that slide along
# themselves make this slow: the nearest point holds a point where it is.

point = reg.registration_icp(
    source, target, distance, start, reg.TransformationEstimation.point_to_point(),
    reg.ICPConvergenceCriteria(max_iteration=200),
)  # fmt: skip
print(point)
print("off by {:.2f} degrees and {:.1f} mm".format(*(np.array(off(point.transformation, truth)) * [1, 1000])))

# %%
# Point to plane
# --------------
# Bring each point onto the plane of its partner, along which it may slide. It needs normals of the target (chapter
# 2), and far fewer steps.

plane = reg.registration_icp(
    source, target, distance, start, reg.TransformationEstimation.point_to_plane(),
    reg.ICPConvergenceCriteria(max_iteration=200),
)  # fmt: skip
print(plane)
print("off by {:.2f} degrees and {:.1f} mm".format(*(np.array(off(plane.transformation, truth)) * [1, 1000])))

assert plane.iterations < point.iterations
assert plane.fitness > at_start.fitness and plane.inlier_rmse < at_start.inlier_rmse
assert off(plane.transformation, truth)[0] < 0.7 and off(plane.transformation, truth)[1] < 0.03

after = loom.render(drawn(plane.transformation), view, (960, 640), legend=True)

# %%
# Colored by how far each point is from the other scan. What only one camera saw has no partner and stays far; that
# is no error of the pose.

moved = source.transform(plane.transformation)
moved["apart"] = moved.compute_point_cloud_distance(target)
apart = loom.render(
    {"geometry": moved, "color_by": "apart", "limits": (0.0, 0.1), **SIZE}, view, (960, 640), color_bar=True
)
print(f"half of the points are within {np.median(moved['apart']) * 1000:.0f} mm of the other scan")

# %%
# The one number
# --------------
# The distance has to be larger than the error of the start, or the right partners are out of reach; and small, or wrong
# partners beyond the edge of the overlap (the part of the scene that both scans show) pull. Two to four voxels is a
# good end. Begin wide and end narrow if the initial pose is far off: ``multi_scale_icp`` does that in one call. It
# takes a voxel size, criteria and a distance for each scale; chapter 10 has it in full.

for radius in (0.01, 0.03, 0.12, 0.5, 2.0):
    tried = reg.registration_icp(source, target, radius, start, reg.TransformationEstimation.point_to_plane())
    angle, step = off(tried.transformation, truth)
    print(
        f"distance {radius:4} m: fitness {tried.fitness:.2f}, truly off by {angle:5.2f} degrees, {step * 100:5.1f} cm"
    )

narrow = reg.registration_icp(source, target, 0.01, start, reg.TransformationEstimation.point_to_plane())
assert off(narrow.transformation, truth)[0] > off(plane.transformation, truth)[0]

# %%
# Mind the last line: with 2 m everything has a partner, fitness is near 1, and the pose is the worse for it. A high
# fitness at a large distance proves nothing.
#
# Scans that share a part only
# ----------------------------
# What one camera alone saw has no right partner, but near the edge of the overlap it has a wrong one, and that pulls.
# ``overlap=None`` finds in each iteration which fraction of the points to keep, those whose partners are nearest
# (*trimmed* ICP: the worst pairs are cut off). Take it from a start that is nearly right. It costs little where much
# is shared, and saves the pose where little is, as of frames 0 and 23:

room_pairs = {"6 -> 10": (source, target, truth)}
first, last = scan(0), scan(23)
room_pairs["0 -> 23"] = (first, last, np.linalg.inv(frames[23].T_world_camera) @ frames[0].T_world_camera)
errors, figures, scores = {}, {}, {}
for name, (left, right, true_pose) in room_pairs.items():
    for overlap in (1.0, None):
        tried = reg.registration_icp(
            left, right, distance, true_pose @ perturbation(5.0, (0.06, -0.04, 0.05)),
            reg.TransformationEstimation.point_to_plane(), reg.ICPConvergenceCriteria(max_iteration=200),
            overlap=overlap,
        )  # fmt: skip
        alike = reg.evaluate_registration(left, right, distance, tried.transformation)
        score = reg.assess_registration(left, right, tried.transformation, 0.045).score
        key = name, overlap
        errors[key], figures[key], scores[key] = off(tried.transformation, true_pose)[1] * 1000, (tried, alike), score
        print(f"{name}, overlap={overlap}: off by {errors[key]:5.1f} mm; of the result: fitness {tried.fitness:.2f},"
              f" rmse {tried.inlier_rmse * 1000:.0f} mm; of all pairs: fitness {alike.fitness:.2f},"
              f" rmse {alike.inlier_rmse * 1000:.0f} mm; score {score:.2f}")  # fmt: skip

for name in room_pairs:
    assert errors[name, None] < 4 < errors[name, 1.0]
assert figures["6 -> 10", None][0].fitness < figures["6 -> 10", None][1].fitness

# %%
# With ``overlap`` the fitness of the result is the fraction that was kept, and its rmse that of those pairs alone, so
# they
# do not compare with the figures of a run without it. ``evaluate_registration`` asks both poses the same. Even so the
# wrong pose of frames 0 and 23 has the higher fitness, since its walls lie on walls that are others:
# ``assess_registration`` compares the surfaces, and its score (0 to 1; accept poses above 0.5, chapter 8) rejects the
# pose here.

assert figures["0 -> 23", 1.0][1].fitness > figures["0 -> 23", None][1].fitness
assert scores["0 -> 23", 1.0] < 0.5 < scores["0 -> 23", None]

# %%
# What ICP cannot know
# --------------------
# A wall slides along itself and turns in its plane, and every pose fits. ICP leaves such motions out and says so:
# three of six are not determined. (Open3D's moves along them by what the noise says.)

wall = loom.TriangleMesh.create_plane(2.0, 1.5).compute_vertex_normals().sample_points_uniformly(4000, seed=0)
on_wall = reg.registration_icp(
    wall, wall, distance, perturbation(2, (0.0, 0.0, 0.02)), reg.TransformationEstimation.point_to_plane()
)
print("converged:", on_wall.converged, "- not determined:", len(on_wall.degenerate_directions), "of 6 motions")
print("in the room:", len(plane.degenerate_directions))
assert len(on_wall.degenerate_directions) == 3
assert len(plane.degenerate_directions) == 0

# %%
# How firmly each motion is held is in the information matrix, 6 x 6: three turns, three steps. Its inverse, times the
# variance of the noise, is the covariance of the pose, if errors were independent, which they never quite are: take its
# square root as the ratio between directions, and not as a promise.

information = reg.get_information_matrix_from_point_clouds(source, target, distance, plane.transformation)
covariance = plane.inlier_rmse**2 * np.linalg.inv(information)
print("standard deviations of x, y, z:", (np.sqrt(np.diag(covariance)[3:]) * 1000).round(2), "mm, at the least")
assert information.shape == (6, 6) and information[5, 5] == len(plane.correspondence_set)

# %%
# The steps as a page that plays, with fitness and error beside it:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "icp.html", max_points=40_000, title="Point-to-plane ICP") as recording:
    reg.registration_icp(source, target, distance, start, reg.TransformationEstimation.point_to_plane())
page = folder / "icp.html"

# %%
# What goes wrong
# ---------------
# **Millimeters on meters.** Nothing is near anything, and the result says what it looks like:

in_millimeters = source.scale(1000.0, center=[0, 0, 0])
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    lost = reg.registration_icp(in_millimeters, target, distance)
print(caught[0].category.__name__, "-", caught[0].message)
print(lost)
assert lost.fitness == 0.0

# %%
# **The start is too far away.** ICP ends somewhere else, and may well call that converged, as it only looks around
# itself. Fitness is lower than it should be, but not 0. From 35 degrees off:

far = reg.registration_icp(source, target, distance, truth @ perturbation(35.0, (0.2, 0, 0)),
                           reg.TransformationEstimation.point_to_plane())  # fmt: skip
print(far)
print("off by {:.0f} degrees, {:.2f} m".format(*off(far.transformation, truth)))
assert max(off(far.transformation, truth)[0] / 10, off(far.transformation, truth)[1] / 0.5) > 1
assert far.fitness < plane.fitness

# %%
# **The result is dropped.** ``result.transformation`` is a number for you to use: ``source.transform(...)`` gives the
# moved cloud, and ``source`` stays where it was. **The inverse is used.** The pose takes the source to the target. If
# clouds move apart, try ``np.linalg.inv``.
#
# Try it
# ------
# - ``TransformationEstimation.generalized()`` in place of point to plane: is it more exact?
# - Begin 20, 30, 40 degrees off. From where on does it fail?
# - Begin nearer and farther from the truth with frames 0 and 23. How near does ``overlap=None`` want to begin?
#
# Where to go next
# ----------------
# :ref:`Chapter 8 <sphx_glr_chapters_plot_08_register_without_a_start.py>` needs no start.
# :ref:`Chapter 10 <sphx_glr_chapters_plot_10_colored_icp.py>` uses colors,
# :ref:`chapter 12 <sphx_glr_chapters_plot_12_animation.py>` shows every step,
# :ref:`chapter 14 <sphx_glr_chapters_plot_14_robust_kernels_and_numpy.py>` keeps wrong pairs out. The page
# :doc:`Registration </registration>` says which method when, and from how far each succeeds.
