"""
Features, RANSAC and FGR
========================

Global registration consists of features, matching, and a search for the pose that most matches agree with. On this page
you run these steps separately, and compare three search methods on the same matches, of which four of five are wrong.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two views of an object
# ----------------------
# Each scan is in its camera coordinates. They share about half of the surface.
views = loom.datasets.object_scans(10)
source, target = views.scans[1], views.scans[2]
truth = np.linalg.inv(views.poses[2]) @ views.poses[1]  # T_target_source
print(source, target)


def pose_error(T):
    """Error at the center of the source: rotation [degrees] and translation [mm]."""
    center = np.r_[source.get_center(), 1]
    angle = np.degrees(2 * np.arcsin(min(1, np.linalg.norm(T[:3, :3] - truth[:3, :3]) / np.sqrt(8))))
    return angle, 1000 * np.linalg.norm(((T - truth) @ center)[:3])


# %%
# Downsample and compute features
# -------------------------------
# The voxel size is 4 mm. Normals use a radius of two voxels and are oriented toward the camera, which is at the origin.
# FPFH features use five voxels. These ratios are suitable for most data.
voxel = 0.004
downsampled, features = [], []
for cloud in (source, target):
    cloud = cloud.voxel_down_sample(voxel).estimate_normals(radius=2 * voxel, max_nn=30)
    cloud = cloud.orient_normals_towards_camera_location([0, 0, 0])
    downsampled.append(cloud)
    features.append(loom.compute_fpfh_feature(cloud, radius=5 * voxel, max_nn=100))
print(downsampled[0], features[0].shape)

# %%
# Match
# -----
# Each point is matched with the point with the most similar feature. ``mutual_filter`` keeps matches that are mutual.
pairs = reg.correspondences_from_features(*features, mutual_filter=True)
distances = np.linalg.norm(
    downsampled[0].transform(truth).points[pairs[:, 0]] - downsampled[1].points[pairs[:, 1]], axis=1
)
is_correct = distances < 2 * voxel
print(f"{len(pairs)} pairs, {100 * is_correct.mean():.0f} % of them correct")
assert 0.03 < is_correct.mean() < 0.9

# %%
# Search for the pose
# -------------------
# RANSAC samples three matches and counts correspondences. The checkers reject wrong samples early: edges of different
# length, or inconsistent normals. FGR minimizes the distances of all matches with a robust kernel that becomes
# narrower. The robust method selects matches with consistent pairwise distances and is not random.
checkers = [
    reg.CorrespondenceCheckerBasedOnEdgeLength(0.9),
    reg.CorrespondenceCheckerBasedOnDistance(1.5 * voxel),
    reg.CorrespondenceCheckerBasedOnNormal(np.radians(40)),
]
option = reg.FastGlobalRegistrationOption(maximum_correspondence_distance=1.5 * voxel)
results = {
    "RANSAC": reg.registration_ransac_based_on_correspondence(
        *downsampled, pairs, 1.5 * voxel, checkers=checkers, num_iterations=200_000, seed=0
    ),
    "FGR": reg.registration_fgr_based_on_correspondence(*downsampled, pairs, option),
    "robust": reg.registration_robust_based_on_correspondence(*downsampled, pairs, 1.5 * voxel),
}
for name, result in results.items():
    angle, distance = pose_error(result.transformation)
    print(
        f"{name:20} {angle:6.2f} degrees, {distance:5.1f} mm, fitness {result.fitness:.2f}, score "
        f"{reg.assess_registration(*downsampled, result.transformation, 1.5 * voxel).score:.2f}"
    )
for name in ("RANSAC", "robust"):
    assert pose_error(results[name].transformation)[0] < 5

# %%
# Refine
# ------
# ICP refines the pose on the complete clouds.
normals = target.estimate_normals(max_nn=20)
refined = reg.registration_icp(
    source,
    normals,
    2 * voxel,
    results["robust"].transformation,
    reg.TransformationEstimationPointToPlane(),
    overlap=None,
)
print(f"after ICP: {pose_error(refined.transformation)[0]:.3f} degrees, {pose_error(refined.transformation)[1]:.2f} mm")
assert pose_error(refined.transformation)[0] < 0.5

# %%
# Upright scans
# -------------
# If both scans are upright, ``CorrespondenceCheckerBasedOnSourceRotation`` rejects poses with a tilt, and RANSAC only
# searches for the rotation about the vertical axis. These cameras are not upright, so the script only tests the
# checker.
rotation_checker = reg.CorrespondenceCheckerBasedOnSourceRotation([np.radians(10), np.radians(10), np.pi])
assert rotation_checker.Check(*downsampled, pairs[:3], np.eye(4)) and not rotation_checker.Check(
    *downsampled, pairs[:3], np.diag([1.0, -1, -1, 1])
)

# %%
# The matches, with correct ones in green and wrong ones in red, and both scans after refinement:
shift = np.eye(4)
shift[:3, 3] = [-0.34, 0, 0]
shifted_source = downsampled[0].transform(shift)
scene = [{"geometry": source.transform(shift), "point_size": 3}, {"geometry": target, "point_size": 3}]
for good, color in ((False, (0.85, 0.2, 0.15)), (True, (0.1, 0.65, 0.25))):
    lines = loom.LineSet.create_from_point_cloud_correspondences(
        shifted_source, downsampled[1], pairs[is_correct == good][:: 8 if good else 16]
    )
    scene.append({"geometry": lines, "color": color, "line_width": 1})
offset = np.array([0.3, 0, 0])
scene += [
    {"geometry": target.translate(offset).without("colors"), "color": (0.2, 0.5, 0.8)},
    {
        "geometry": source.transform(refined.transformation).translate(offset).without("colors"),
        "color": (0.95, 0.6, 0.15),
    },
]
corners = np.vstack([part["geometry"].points for part in scene])
image = loom.render(scene, loom.View.fit(corners, direction=(0.05, 0.1, 1.0), up=(0, -1, 0), width=1120, height=480))

# %%
# What to change
# --------------
# - ``voxel`` [m]: 0.008 is faster and gives fewer matches.
# - ``mutual_filter``: ``False`` gives more matches with a smaller fraction of correct ones.
# - ``num_iterations`` of RANSAC: 2,000 instead of 200,000. Is the score still above 0.5?
#
# Next
# ----
# - :ref:`Chapter 8 <sphx_glr_chapters_plot_08_global_registration.py>`: global registration, step by step.
# - :ref:`Global registration and its score <sphx_glr_gallery_registration_plot_global_registration.py>`
# - :doc:`Choosing a method </which-method>`
