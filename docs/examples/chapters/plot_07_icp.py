"""
7. ICP: align two point clouds
==============================

Two scans of the same scene are in the coordinate systems of their scanners. ICP (iterative closest point) estimates the
transformation between them from an approximate initial pose. In this chapter you use its variants, choose the
correspondence distance, and check whether the result is reliable.
"""

# %%
# Two scans with ground truth
# ---------------------------
# The scans are two frames of a depth camera at different poses. Each cloud is in its own camera coordinates. The true
# poses are known, so errors can be measured. A pose is a 4 x 4 matrix that maps source to target coordinates:
# ``T_target_source``.

import tempfile
import warnings
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
frames = loom.datasets.room_frames(24)


def scan(index: int, voxel_size: float = 0.03) -> loom.PointCloud:
    """A frame as a downsampled cloud in camera coordinates, with normals toward the camera."""
    frame = frames[index]
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=5.0)
    cloud = loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic).voxel_down_sample(voxel_size)
    return cloud.estimate_normals(radius=3 * voxel_size, max_nn=30).orient_normals_towards_camera_location([0, 0, 0])


def pose_error(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """Error of a pose: rotation [degrees] and translation [m]."""
    residual = np.linalg.inv(truth) @ T
    angle = np.degrees(np.arccos(np.clip((np.trace(residual[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), float(np.linalg.norm(residual[:3, 3]))


def perturbation(degrees: float, step: tuple[float, float, float]) -> np.ndarray:
    """A rotation about the vertical axis of the camera, and a translation."""
    angle, T = np.radians(degrees), np.eye(4)
    T[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    T[:3, 3] = step
    return T


source, target = scan(6), scan(10)
truth = np.linalg.inv(frames[10].T_world_camera) @ frames[6].T_world_camera
start = truth @ perturbation(5.0, (0.06, -0.04, 0.05))
print(source, target)
print("initial error: {:.1f} degrees and {:.2f} m".format(*pose_error(start, truth)))

# %%
# The initial pose: the source is orange, the target blue.

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.55, 0.85)
SIZE = {"point_size": 0.025, "metric": True}
view = {"front": [0.5, -0.55, -0.8], "up": [0, -1, 0], "zoom": 0.5}


def scene_at(T: np.ndarray) -> dict:
    """Both clouds, with the source at pose T."""
    return {
        "source": {"geometry": source, "pose": T, "color": ORANGE, **SIZE},
        "target": {"geometry": target, "color": BLUE, **SIZE},
    }


before = loom.render(scene_at(start), view, (960, 640), legend=True)

# %%
# Evaluate a pose
# ---------------
# For each source point, the nearest target point is found. The pair is a correspondence if its distance is below
# ``max_correspondence_distance``. **Fitness** is the fraction of source points with a correspondence, from 0 to 1.
# **inlier_rmse** is the root mean square distance of the correspondences in meters. Both depend on the correspondence
# distance, so only compare values with the same distance. Neither measures the pose error.
#
# All names of this chapter are those of ``o3d.pipelines.registration``.

distance = 0.12
at_start = reg.evaluate_registration(source, target, distance, start)
print(at_start)

# %%
# Point to point
# --------------
# Each iteration pairs every source point with its nearest target point and computes the transformation that minimizes
# the distances. Convergence is slow, since points on planar surfaces resist sliding along the surface.

point = reg.registration_icp(
    source, target, distance, start, reg.TransformationEstimationPointToPoint(),
    reg.ICPConvergenceCriteria(max_iteration=200),
)  # fmt: skip
print(point)
print("error: {:.2f} degrees and {:.1f} mm".format(*(np.array(pose_error(point.transformation, truth)) * [1, 1000])))

# %%
# Point to plane
# --------------
# This variant minimizes the distance of each source point from the tangent plane of its target point, so surfaces can
# slide. It requires normals of the target (chapter 2) and far fewer iterations.

plane = reg.registration_icp(
    source, target, distance, start, reg.TransformationEstimationPointToPlane(),
    reg.ICPConvergenceCriteria(max_iteration=200),
)  # fmt: skip
print(plane)
print("error: {:.2f} degrees and {:.1f} mm".format(*(np.array(pose_error(plane.transformation, truth)) * [1, 1000])))

assert plane.iterations < point.iterations
assert plane.fitness > at_start.fitness and plane.inlier_rmse < at_start.inlier_rmse
assert pose_error(plane.transformation, truth)[0] < 0.7 and pose_error(plane.transformation, truth)[1] < 0.03

after = loom.render(scene_at(plane.transformation), view, (960, 640), legend=True)

# %%
# The source colored by its distance from the target. Points that only one camera observed have no counterpart and a
# large distance. This is not an error of the pose.

moved = source.transform(plane.transformation)
moved["distance"] = moved.compute_point_cloud_distance(target)
distance_image = loom.render(
    {"geometry": moved, "color_by": "distance", "limits": (0.0, 0.1), **SIZE}, view, (960, 640), color_bar=True
)
print(f"median distance from the other scan: {np.median(moved['distance']) * 1000:.0f} mm")

# %%
# Choose the correspondence distance
# ----------------------------------
# The distance must exceed the error of the initial pose, otherwise the correct correspondences are not found. If it is
# too large, wrong correspondences outside the overlap bias the result. The overlap is the part of the scene that both
# scans contain. A good final value is two to four voxels. If the initial pose is inaccurate, begin with a large
# distance and decrease it. ``multi_scale_icp`` does this in one call, with a voxel size, criteria and a distance for
# each scale. Chapter 10 shows it.

for radius in (0.01, 0.03, 0.12, 0.5, 2.0):
    trial = reg.registration_icp(source, target, radius, start, reg.TransformationEstimationPointToPlane())
    angle, step = pose_error(trial.transformation, truth)
    print(f"distance {radius:4} m: fitness {trial.fitness:.2f}, error {angle:5.2f} degrees, {step * 100:5.1f} cm")

narrow = reg.registration_icp(source, target, 0.01, start, reg.TransformationEstimationPointToPlane())
assert pose_error(narrow.transformation, truth)[0] > pose_error(plane.transformation, truth)[0]

# %%
# In the last line, the distance is 2 m. Every point has a correspondence and the fitness is close to 1, but the pose is
# less accurate. A high fitness with a large distance does not indicate a good pose.
#
# Partial overlap
# ---------------
# Points outside the overlap have no correct correspondence. Close to its border they get a wrong one, which biases the
# result. With ``overlap=None``, each iteration estimates the fraction of points to use and keeps the correspondences
# with the smallest distances (*trimmed* ICP). It needs a good initial pose. With a large overlap the effect is small.
# With a small overlap, as between frames 0 and 23, it is necessary:

room_pairs = {"6 -> 10": (source, target, truth)}
first, last = scan(0), scan(23)
room_pairs["0 -> 23"] = (first, last, np.linalg.inv(frames[23].T_world_camera) @ frames[0].T_world_camera)
errors, figures, scores = {}, {}, {}
for name, (left, right, true_pose) in room_pairs.items():
    for overlap in (1.0, None):
        trial = reg.registration_icp(
            left, right, distance, true_pose @ perturbation(5.0, (0.06, -0.04, 0.05)),
            reg.TransformationEstimationPointToPlane(), reg.ICPConvergenceCriteria(max_iteration=200),
            overlap=overlap,
        )  # fmt: skip
        all_pairs = reg.evaluate_registration(left, right, distance, trial.transformation)
        score = reg.assess_registration(left, right, trial.transformation, 0.045).score
        key = name, overlap
        errors[key], figures[key], scores[key] = (
            pose_error(trial.transformation, true_pose)[1] * 1000,
            (trial, all_pairs),
            score,
        )
        print(f"{name}, overlap={overlap}: error {errors[key]:5.1f} mm; selected pairs: fitness {trial.fitness:.2f},"
              f" rmse {trial.inlier_rmse * 1000:.0f} mm; all pairs: fitness {all_pairs.fitness:.2f},"
              f" rmse {all_pairs.inlier_rmse * 1000:.0f} mm; score {score:.2f}")  # fmt: skip

for name in room_pairs:
    assert errors[name, None] < 4 < errors[name, 1.0]
assert figures["6 -> 10", None][0].fitness < figures["6 -> 10", None][1].fitness

# %%
# With ``overlap``, fitness and rmse of the result only describe the selected correspondences, so they cannot be
# compared with those of a run without it. ``evaluate_registration`` evaluates both poses in the same way. For frames 0
# and 23, the wrong pose still has the higher fitness, since some of its walls coincide with other walls.
# ``assess_registration`` compares the surfaces. Its score ranges from 0 to 1. Poses above 0.5 are accepted (chapter 8).
# It rejects the wrong pose.

assert figures["0 -> 23", 1.0][1].fitness > figures["0 -> 23", None][1].fitness
assert scores["0 -> 23", 1.0] < 0.5 < scores["0 -> 23", None]

# %%
# Undetermined motions
# --------------------
# If the scene is a single wall, translations in the wall and the rotation about its normal are not determined. ICP
# detects these directions, does not move along them, and reports them: three of six here. In Open3D, noise determines
# the motion along them.

wall = loom.TriangleMesh.create_plane(2.0, 1.5).compute_vertex_normals().sample_points_uniformly(4000, seed=0)
on_wall = reg.registration_icp(
    wall, wall, distance, perturbation(2, (0.0, 0.0, 0.02)), reg.TransformationEstimationPointToPlane()
)
print("converged:", on_wall.converged, "- not determined:", len(on_wall.degenerate_directions), "of 6 motions")
print("in the room:", len(plane.degenerate_directions))
assert len(on_wall.degenerate_directions) == 3
assert len(plane.degenerate_directions) == 0

# %%
# The information matrix (6 x 6: three rotations, three translations) describes how well each motion is determined. Its
# inverse times the variance of the noise is the covariance of the pose, if the errors are independent. They rarely are,
# so use the standard deviations to compare directions, and as a lower bound of the error.

information = reg.get_information_matrix_from_point_clouds(source, target, distance, plane.transformation)
covariance = plane.inlier_rmse**2 * np.linalg.inv(information)
print("standard deviations of x, y, z:", (np.sqrt(np.diag(covariance)[3:]) * 1000).round(2), "mm (lower bound)")
assert information.shape == (6, 6) and information[5, 5] == len(plane.correspondence_set)

# %%
# A recording of the iterations, with plots of fitness and rmse:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "icp.html", max_points=40_000, title="Point-to-plane ICP") as recording:
    reg.registration_icp(source, target, distance, start, reg.TransformationEstimationPointToPlane())
page = folder / "icp.html"

# %%
# Common mistakes
# ---------------
# **Different units.** If one cloud is in millimeters and the other in meters, there are no correspondences. A warning
# reports the likely cause:

in_millimeters = source.scale(1000.0, center=[0, 0, 0])
with warnings.catch_warnings(record=True) as caught:
    warnings.simplefilter("always")
    lost = reg.registration_icp(in_millimeters, target, distance)
print(caught[0].category.__name__, "-", caught[0].message)
print(lost)
assert lost.fitness == 0.0

# %%
# **A bad initial pose.** ICP converges to a local minimum. The result may be reported as converged, since convergence
# only describes the last iterations. The fitness is lower, but not 0. This is the result from an initial error of 35
# degrees:

far = reg.registration_icp(source, target, distance, truth @ perturbation(35.0, (0.2, 0, 0)),
                           reg.TransformationEstimationPointToPlane())  # fmt: skip
print(far)
print("error: {:.0f} degrees, {:.2f} m".format(*pose_error(far.transformation, truth)))
assert max(pose_error(far.transformation, truth)[0] / 10, pose_error(far.transformation, truth)[1] / 0.5) > 1
assert far.fitness < plane.fitness

# %%
# **A pose that is not applied.** ICP does not modify the source. Apply the pose:
# ``source.transform(result.transformation)``. **An inverted pose.** The pose maps source to target. If the clouds move
# away from each other, use ``np.linalg.inv``.
#
# What to change
# --------------
# - The estimation: ``TransformationEstimationForGeneralizedICP()`` instead of point to plane. Is it more accurate?
# - The initial rotation [degrees]: 20, 30 and 40. At which value does ICP fail?
# - ``max_correspondence_distance`` [m]: a smaller value is more accurate but needs a better initial pose.
#
# Next
# ----
# - :ref:`Chapter 8 <sphx_glr_chapters_plot_08_global_registration.py>`: registration without an initial pose.
# - :ref:`Chapter 10 <sphx_glr_chapters_plot_10_colored_icp.py>`: ICP with colors.
# - :ref:`Chapter 12 <sphx_glr_chapters_plot_12_animation.py>`: recordings of all iterations.
# - :ref:`Chapter 14 <sphx_glr_chapters_plot_14_robust_kernels_and_numpy.py>`: robust kernels against wrong
#   correspondences.
# - :doc:`Registration </registration>`: choice of the method, and its convergence range.
