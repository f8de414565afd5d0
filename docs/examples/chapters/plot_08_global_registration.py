"""
8. Global registration
======================

Global registration estimates the transformation between two clouds without an initial pose. It describes points by
features and matches points with similar features. In this chapter you compute features, use RANSAC and FGR, use the
single call ``register_globally``, and check whether the result is reliable.
"""

# %%
# Two scans in arbitrary poses
# ----------------------------
# The data is that of chapter 7, but the source is rotated and moved far away.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
frames = loom.datasets.room_frames(48)
VOXEL = 0.05  # [m], for rooms. Use 0.3 to 0.5 for streets, 0.002 for a cup


def scan(index: int) -> loom.PointCloud:
    """A frame as a cloud in camera coordinates."""
    frame = frames[index]
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=5.0)
    return loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic)


def pose_error(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """Error of a pose: rotation [degrees] and translation [cm]."""
    residual = np.linalg.inv(truth) @ T
    angle = np.degrees(np.arccos(np.clip((np.trace(residual[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), 100 * float(np.linalg.norm(residual[:3, 3]))


arbitrary_pose = np.array([[0.36, 0.48, -0.8, 2.0], [-0.8, 0.6, 0.0, -3.0], [0.48, 0.64, 0.6, 1.0], [0, 0, 0, 1]])
source, target = scan(6).transform(arbitrary_pose), scan(14)
truth = np.linalg.inv(frames[14].T_world_camera) @ frames[6].T_world_camera @ np.linalg.inv(arbitrary_pose)
print("initial error: {:.0f} degrees and {:.0f} cm".format(*pose_error(np.eye(4), truth)))

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.55, 0.85)
before = loom.render(
    {"source": {"geometry": source, "color": ORANGE}, "target": {"geometry": target, "color": BLUE}},
    {"front": [0.5, -0.55, -0.8], "up": [0, -1, 0], "zoom": 0.6}, (960, 640), legend=True,
)  # fmt: skip

# %%
# Features
# --------
# FPFH describes a point by 33 numbers: histograms of the angles between the normals of its neighbors. They do not
# depend on the pose of the cloud. Downsample first, so that both clouds have the same density. Use a radius of two
# voxels for normals and five voxels for features.
#
# Open3D's ``compute_fpfh_feature(cloud, KDTreeSearchParamHybrid(radius, max_nn))`` returns an object whose ``data`` has
# one column per point. Here the result is an array with one row per point.


def compute_features(cloud: loom.PointCloud, sensor_position: np.ndarray) -> tuple[loom.PointCloud, np.ndarray]:
    """Return the downsampled cloud, with normals toward the sensor, and its features."""
    downsampled = cloud.voxel_down_sample(VOXEL).estimate_normals(radius=2 * VOXEL, max_nn=30)
    downsampled = downsampled.orient_normals_towards_camera_location(sensor_position)
    return downsampled, loom.compute_fpfh_feature(downsampled, radius=5 * VOXEL, max_nn=100)


source_down, source_features = compute_features(source, arbitrary_pose[:3, 3])
target_down, target_features = compute_features(target, np.zeros(3))
print(source_down, "features:", source_features.shape)
assert source_features.shape == (len(source_down), 33)

# %%
# Each point is matched with the point with the most similar feature. Most matches are wrong, since points of a wall
# have similar features. With the ground truth, the correct matches can be counted:

matches = np.asarray(reg.correspondences_from_features(source_features, target_features, mutual_filter=True))
gaps = np.linalg.norm(source_down.transform(truth).points[matches[:, 0]] - target_down.points[matches[:, 1]], axis=1)
is_correct = gaps < 2 * VOXEL
print(f"{len(matches)} matches, {is_correct.mean():.0%} of them correct")
assert 10 < is_correct.sum() < len(matches)

rotated = source_down.transform(truth).translate([4.2, 0, 0])
some = slice(None, None, 12)  # every twelfth, for a clear image
pairs = loom.LineSet.create_from_point_cloud_correspondences(rotated, target_down, matches[some])
pairs = loom.LineSet(pairs.points, pairs.lines, np.where(is_correct[some, None], [0.1, 0.65, 0.2], [0.9, 0.6, 0.55]))
matched = loom.render(
    [rotated, target_down, pairs], {"front": [0.1, -0.75, -0.8], "up": [0, -1, 0], "zoom": 0.42}, (960, 640)
)

# %%
# RANSAC
# ------
# RANSAC computes a pose from three random matches, counts the points with a correspondence, and repeats. The pose with
# the most correspondences is selected. The checkers reject samples before counting: the edge lengths of the two
# triangles must agree.

distance = 1.5 * VOXEL
pairs = reg.correspondences_from_features(source_features, target_features, mutual_filter=True)
ransac = reg.registration_ransac_based_on_correspondence(
    source_down, target_down, pairs, distance,
    reg.TransformationEstimationPointToPoint(False), 3,
    [reg.CorrespondenceCheckerBasedOnEdgeLength(0.9), reg.CorrespondenceCheckerBasedOnDistance(distance)],
    num_iterations=100_000, confidence=0.999, seed=0,
)  # fmt: skip
print(ransac)
print("error: {:.1f} degrees and {:.0f} cm".format(*pose_error(ransac.transformation, truth)))

# %%
# Fast global registration
# ------------------------
# FGR uses all matches and decreases the weight of inconsistent ones in each iteration. It is fast, and reliable if
# about half of the matches are correct. Here nine of ten are wrong, so it may fail. ``score`` measures the agreement of
# the surfaces from 0 to 1. Poses above 0.5 are accepted.

fast = reg.registration_fgr_based_on_correspondence(
    source_down, target_down, pairs,
    reg.FastGlobalRegistrationOption(maximum_correspondence_distance=distance),
)  # fmt: skip
for name, result in (("RANSAC", ransac), ("FGR", fast)):
    angle, step = pose_error(result.transformation, truth)
    print(f"{name:6} score {result.score:.2f}, error {angle:5.1f} degrees and {step:3.0f} cm")
    assert (result.score > 0.5) == (angle < 3), "a score above 0.5 indicates a correct pose"

# %%
# All steps in one call
# ---------------------
# ``register_globally`` downsamples, computes and matches features, searches for the pose, refines it, and compares the
# surfaces. Its only parameter is the voxel size. Open3D has no equivalent.

global_result = reg.register_globally(source, target, voxel_size=VOXEL)
print(global_result)
print(
    "score {:.2f}, error {:.1f} degrees and {:.1f} cm".format(
        global_result.score, *pose_error(global_result.transformation, truth)
    )
)
assert global_result.converged and global_result.score > 0.5
assert pose_error(global_result.transformation, truth)[0] < 2 and pose_error(global_result.transformation, truth)[1] < 6

# %%
# Refine by ICP
# -------------
# Global registration uses downsampled clouds, so its result is approximate. ICP on denser clouds refines it.

fine = [cloud.voxel_down_sample(0.02).estimate_normals(radius=0.06, max_nn=30) for cloud in (source, target)]
refined = reg.registration_icp(*fine, 0.05, global_result.transformation, reg.TransformationEstimationPointToPlane())
print("error after ICP: {:.2f} degrees and {:.1f} cm".format(*pose_error(refined.transformation, truth)))
assert pose_error(refined.transformation, truth)[0] < 1.0 and pose_error(refined.transformation, truth)[1] < 3

after = loom.render(
    {
        "source": {"geometry": source.transform(refined.transformation), "color": ORANGE},
        "target": {"geometry": target, "color": BLUE},
    },
    {"front": [0.5, -0.55, -0.8], "up": [0, -1, 0], "zoom": 0.5}, (960, 640), legend=True,
)  # fmt: skip

# %%
# Check the reliability
# ---------------------
# Every method returns a pose, even if the clouds do not overlap. The following two frames show different parts of the
# room. The fitness is not low, since floors and walls fit in many poses. The score is below 0.5. Do not use such a
# pose. ``warnings`` contains the reasons.

unrelated = scan(47)
unrelated_down, unrelated_features = compute_features(unrelated, np.zeros(3))
wrong = reg.register_globally(source, unrelated, voxel_size=VOXEL)
print(f"score {wrong.score:.2f}: {wrong.warnings[0]}")
fgr_result = reg.registration_fgr_based_on_correspondence(
    source_down, unrelated_down,
    reg.correspondences_from_features(source_features, unrelated_features, mutual_filter=True),
    reg.FastGlobalRegistrationOption(maximum_correspondence_distance=distance),
)  # fmt: skip
print(f"FGR on the same clouds: fitness {fgr_result.fitness:.2f}, score {fgr_result.score:.2f}")
assert not wrong.converged and wrong.score < 0.5
assert fgr_result.score < 0.5

# %%
# The initial and the estimated poses as an interactive page:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "global.html", automatic=False, max_points=50_000, title="Global registration") as recording:
    recording.add("source", source, color=ORANGE)
    recording.add("target", target, color=BLUE)
    recording.step("initial poses")
    recording.set_pose("source", global_result.transformation)
    recording.step("register_globally")
    recording.set_pose("source", refined.transformation)
    recording.step("ICP")
page = folder / "global.html"

# %%
# Common mistakes
# ---------------
# **A wrong voxel size.** If the voxels are too large, as with 0.5 m, small objects disappear and the remaining planes
# fit in many poses. If they are too small, the features describe noise. Use a size that leaves 3,000 to 30,000 points
# per cloud:

for voxel_size in (0.025, 0.05, 0.1, 0.5):
    trial = reg.register_globally(source, target, voxel_size=voxel_size)
    count = len(source.voxel_down_sample(voxel_size))
    print(f"voxel {voxel_size:5} m: {count:6} voxels, score {trial.score:.2f}, error"
          f" {pose_error(trial.transformation, truth)[0]:5.1f} degrees")  # fmt: skip
    if 3000 < count < 40_000:
        assert trial.score > 0.5 and pose_error(trial.transformation, truth)[0] < 2

# %%
# The last voxel size leaves 148 points. The score is not reliable with so few points, even if it is high. It requires
# thousands of points.

# %%
# **Symmetry.** A box fits in four poses, and the warnings list 2 to 4 equivalent poses. A cylinder can be rotated about
# its axis, so infinitely many poses fit. ``warnings`` reports this, and ``degenerate_directions`` contains the
# undetermined motions. The fitness is 1 in all these cases.

box = loom.TriangleMesh.create_box(1.0, 0.7, 0.4)
tube = loom.TriangleMesh.create_cylinder(0.3, 1.0)
for name, mesh in (("box", box), ("cylinder", tube)):
    one, other = (mesh.sample_points_uniformly(20_000, seed=seed) for seed in (0, 1))
    symmetric = reg.register_globally(one.transform(arbitrary_pose), other, voxel_size=0.04)
    print(f"{name}: fitness {symmetric.fitness:.2f}, score {symmetric.score:.2f}: {symmetric.warnings[0]};"
          f" {len(symmetric.degenerate_directions)} undetermined motions")  # fmt: skip
    assert symmetric.fitness > 0.9 and symmetric.score < 0.5 and not symmetric.converged
    assert len(symmetric.degenerate_directions) == (name == "cylinder")

# %%
# What to change
# --------------
# - ``VOXEL`` [m]: larger values are faster and less reliable.
# - ``seed`` of RANSAC: how much does the pose change? ``register_globally`` is deterministic.
# - The frames: which frames of the trajectory can be registered with frame 14, and with which score?
# - ``reg.register_pair(source, target)`` also selects the voxel size.
#
# Next
# ----
# - :ref:`Chapter 10 <sphx_glr_chapters_plot_10_colored_icp.py>`: refinement with colors.
# - :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>`: models from many frames.
# - :doc:`Registration </registration>`: comparison of the methods with measurements.
# - :doc:`When to trust a result </trust>`: scores and warnings.
