"""
8. Register without a start
===========================

ICP needs a pose that is nearly right. Where nobody knows one, points are described by what lies around them, and
points that look alike are matched. You learn features, the two classic methods that work on them, the one call that
does it all, and how to check whether the result is reliable.
"""

# %%
# Two scans that lie anyhow
# -------------------------
# As in chapter 7, but the source is turned over and put elsewhere, as if it came from another device.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
frames = loom.datasets.room_frames(48)
VOXEL = 0.05  # meters; of rooms. Streets want 0.3 to 0.5, a cup 0.002


def scan(index: int) -> loom.PointCloud:
    """A frame as a cloud in its camera's coordinates."""
    frame = frames[index]
    image = loom.RGBDImage(frame.color, frame.depth, depth_trunc=5.0)
    return loom.PointCloud.create_from_rgbd_image(image, frame.intrinsic)


def off(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """How far a pose is from the true one: degrees and centimeters."""
    rest = np.linalg.inv(truth) @ T
    angle = np.degrees(np.arccos(np.clip((np.trace(rest[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), 100 * float(np.linalg.norm(rest[:3, 3]))


away = np.array([[0.36, 0.48, -0.8, 2.0], [-0.8, 0.6, 0.0, -3.0], [0.48, 0.64, 0.6, 1.0], [0, 0, 0, 1]])
source, target = scan(6).transform(away), scan(14)
truth = np.linalg.inv(frames[14].T_world_camera) @ frames[6].T_world_camera @ np.linalg.inv(away)
print("as they lie: {:.0f} degrees and {:.0f} cm off".format(*off(np.eye(4), truth)))

ORANGE, BLUE = (1.0, 0.706, 0.0), (0.0, 0.55, 0.85)
before = loom.render(
    {"source": {"geometry": source, "color": ORANGE}, "target": {"geometry": target, "color": BLUE}},
    {"front": [0.5, -0.55, -0.8], "up": [0, -1, 0], "zoom": 0.6}, (960, 640), legend=True,
)  # fmt: skip

# %%
# Features
# --------
# FPFH describes a point by how the normals around it are turned against each other: 33 numbers that stay the same
# however the cloud is turned. Thin first, so that both clouds are equally dense. Normals by two voxels, features by
# five: a feature must see more than a normal does.
#
# In Open3D this is ``compute_fpfh_feature(cloud, KDTreeSearchParamHybrid(radius, max_nn))``, whose ``data`` has a
# column a point; here it is an array with a row a point.


def described(cloud: loom.PointCloud, eye: np.ndarray) -> tuple[loom.PointCloud, np.ndarray]:
    """The cloud thinned, with normals toward the scanner, and its features."""
    thin = cloud.voxel_down_sample(VOXEL).estimate_normals(radius=2 * VOXEL, max_nn=30)
    thin = thin.orient_normals_towards_camera_location(eye)
    return thin, loom.compute_fpfh_feature(thin, radius=5 * VOXEL, max_nn=100)


thin_source, source_features = described(source, away[:3, 3])
thin_target, target_features = described(target, np.zeros(3))
print(thin_source, "features:", source_features.shape)
assert source_features.shape == (len(thin_source), 33)

# %%
# Each point is matched with the one whose feature is nearest. Most matches are wrong: a wall looks everywhere alike.
# With the truth at hand we count the right ones:

matches = np.asarray(reg.correspondences_from_features(source_features, target_features, mutual_filter=True))
gaps = np.linalg.norm(thin_source.transform(truth).points[matches[:, 0]] - thin_target.points[matches[:, 1]], axis=1)
right = gaps < 2 * VOXEL
print(f"{len(matches)} matches, {right.mean():.0%} of them right")
assert 10 < right.sum() < len(matches)

rotated = thin_source.transform(truth).translate([4.2, 0, 0])
some = slice(None, None, 12)  # every twelfth, or one sees nothing else
pairs = loom.LineSet.create_from_point_cloud_correspondences(rotated, thin_target, matches[some])
pairs = loom.LineSet(pairs.points, pairs.lines, np.where(right[some, None], [0.1, 0.65, 0.2], [0.9, 0.6, 0.55]))
matched = loom.render(
    [rotated, thin_target, pairs], {"front": [0.1, -0.75, -0.8], "up": [0, -1, 0], "zoom": 0.42}, (960, 640)
)

# %%
# RANSAC
# ------
# Three matches at random make a pose; the pose under which most points find a partner wins. The checkers throw guesses
# away before they are counted: three matches whose triangle has other sides in the other cloud cannot be right.

distance = 1.5 * VOXEL
pairs = reg.correspondences_from_features(source_features, target_features, mutual_filter=True)
ransac = reg.registration_ransac_based_on_correspondence(
    thin_source, thin_target, pairs, distance,
    reg.TransformationEstimation.point_to_point(False), 3,
    [reg.CorrespondenceChecker.by_edge_length(0.9), reg.CorrespondenceChecker.by_distance(distance)],
    num_iterations=100_000, confidence=0.999, seed=0,
)  # fmt: skip
print(ransac)
print("off by {:.1f} degrees and {:.0f} cm".format(*off(ransac.transformation, truth)))

# %%
# Fast global registration
# ------------------------
# FGR takes all matches at once and gives those that disagree with the rest less and less weight. It is quick, and good
# where every second match is right. Here nine in ten are wrong, and its pose may be as wrong. ``score``
# rates how well the surfaces lie on each other there, from 0 to 1; poses above 0.5 are accepted (more of it below).

fast = reg.registration_fgr_based_on_correspondence(
    thin_source, thin_target, pairs,
    reg.FastGlobalRegistrationOption(maximum_correspondence_distance=distance),
)  # fmt: skip
for name, result in (("RANSAC", ransac), ("FGR", fast)):
    angle, step = off(result.transformation, truth)
    print(f"{name:6} score {result.score:.2f}, off by {angle:5.1f} degrees and {step:3.0f} cm")
    assert (result.score > 0.5) == (angle < 3), "a score above 0.5 is a right pose here"

# %%
# All in one
# ----------
# ``register_globally`` thins, describes, matches, searches, refines, and then asks whether the surfaces truly lie on
# each other. One number is to be chosen, the voxel. There is nothing like it in Open3D.

global_result = reg.register_globally(source, target, voxel_size=VOXEL)
print(global_result)
print(
    "score {:.2f}, off by {:.1f} degrees and {:.1f} cm".format(
        global_result.score, *off(global_result.transformation, truth)
    )
)
assert global_result.converged and global_result.score > 0.5
assert off(global_result.transformation, truth)[0] < 2 and off(global_result.transformation, truth)[1] < 6

# %%
# Then ICP
# --------
# A global method ends near the truth, not at it: its clouds were thinned. ICP on finer clouds does the rest.

fine = [cloud.voxel_down_sample(0.02).estimate_normals(radius=0.06, max_nn=30) for cloud in (source, target)]
refined = reg.registration_icp(*fine, 0.05, global_result.transformation, reg.TransformationEstimation.point_to_plane())
print("after ICP off by {:.2f} degrees and {:.1f} cm".format(*off(refined.transformation, truth)))
assert off(refined.transformation, truth)[0] < 1.0 and off(refined.transformation, truth)[1] < 3

after = loom.render(
    {
        "source": {"geometry": source.transform(refined.transformation), "color": ORANGE},
        "target": {"geometry": target, "color": BLUE},
    },
    {"front": [0.5, -0.55, -0.8], "up": [0, -1, 0], "zoom": 0.5}, (960, 640), legend=True,
)  # fmt: skip

# %%
# Is it reliable?
# ---------------
# The worst case is a wrong pose that looks plausible. Two frames that show different parts of the room: every
# method gives *some* pose. ``fitness`` does not warn, since floors and walls fit anywhere. ``score`` does: below 0.5
# do not use the pose, and ``warnings`` says why.

stranger = scan(47)
thin_stranger, stranger_features = described(stranger, np.zeros(3))
wrong = reg.register_globally(source, stranger, voxel_size=VOXEL)
print(f"score {wrong.score:.2f}: {wrong.warnings[0]}")
forced = reg.registration_fgr_based_on_correspondence(
    thin_source, thin_stranger,
    reg.correspondences_from_features(source_features, stranger_features, mutual_filter=True),
    reg.FastGlobalRegistrationOption(maximum_correspondence_distance=distance),
)  # fmt: skip
print(f"FGR on the same clouds: fitness {forced.fitness:.2f}, score {forced.score:.2f}")
assert not wrong.converged and wrong.score < 0.5
assert forced.score < 0.5

# %%
# The result to turn: as they lay, as they lie.

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "global.html", automatic=False, max_points=50_000, title="From no guess") as recording:
    recording.add("source", source, color=ORANGE)
    recording.add("target", target, color=BLUE)
    recording.step("as they lay")
    recording.set_pose("source", global_result.transformation)
    recording.step("register_globally")
    recording.set_pose("source", refined.transformation)
    recording.step("ICP")
page = folder / "global.html"

# %%
# What goes wrong
# ---------------
# **The voxel is too large**: with 0.5 m nothing is left of a chair, and planes fit anywhere. **Too small**: normals
# describe noise. 3,000 to 30,000 voxels a cloud are right; count them:

for voxel_size in (0.025, 0.05, 0.1, 0.5):
    tried = reg.register_globally(source, target, voxel_size=voxel_size)
    count = len(source.voxel_down_sample(voxel_size))
    print(f"voxel {voxel_size:5} m: {count:6} voxels, score {tried.score:.2f}, off by"
          f" {off(tried.transformation, truth)[0]:5.1f} degrees")  # fmt: skip
    if 3000 < count < 40_000:
        assert tried.score > 0.5 and off(tried.transformation, truth)[0] < 2

# %%
# The last line is the trap: with 148 voxels there is nothing left by which a pose could be judged, and the score of
# such a pose is worth nothing, be it high. A score counts where the clouds have thousands of voxels.

# %%
# **Symmetry.** A box fits in four ways, and is reported as 2 to 4 poses that fit alike, whichever were found: the scene
# leaves the choice to you. Of a cylinder or a ball a turn is free, so that poses without number fit, which ``warnings``
# says, too. Fitness is 1 in all of these; ``degenerate_directions`` holds the free motions.

box = loom.TriangleMesh.create_box(1.0, 0.7, 0.4)
tube = loom.TriangleMesh.create_cylinder(0.3, 1.0)
for name, mesh in (("box", box), ("cylinder", tube)):
    one, other = (mesh.sample_points_uniformly(20_000, seed=seed) for seed in (0, 1))
    alike = reg.register_globally(one.transform(away), other, voxel_size=0.04)
    print(f"{name}: fitness {alike.fitness:.2f}, score {alike.score:.2f}: {alike.warnings[0]};"
          f" {len(alike.degenerate_directions)} free motions")  # fmt: skip
    assert alike.fitness > 0.9 and alike.score < 0.5 and not alike.converged
    assert len(alike.degenerate_directions) == (name == "cylinder")

# %%
#
# Try it
# ------
# - ``reg.register_pair(source, target)`` chooses even the voxel; print it.
# - Give RANSAC another ``seed``. How much does its pose change? That of ``register_globally`` does not.
# - Which frames of the walk still register with frame 14, and with which score?
#
# Where to go next
# ----------------
# :ref:`Chapter 10 <sphx_glr_chapters_plot_10_colored_icp.py>` refines by colors.
# :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>` joins many frames; the page
# :doc:`Registration </registration>` says what each method is good for, with figures.
