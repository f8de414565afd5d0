"""
Features, RANSAC and FGR: poses from no guess, by hand
======================================================

What searches for a pose without a first guess consists of three parts: points described by what lies around them,
pairs of like descriptions, and a way to find the pose that most pairs agree with. Four such ways get the same pairs
here, of which four in five are wrong.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two scans of an object from its two sides, each in its camera's frame; they share some half of the surface.
views = loom.datasets.object_scans(10)
source, target = views.scans[1], views.scans[2]
truth = np.linalg.inv(views.poses[2]) @ views.poses[1]  # T_target_source
print(source, target)


def off(T):
    """Degrees and millimeters from the truth, at the middle of the source."""
    middle = np.r_[source.get_center(), 1]
    angle = np.degrees(2 * np.arcsin(min(1, np.linalg.norm(T[:3, :3] - truth[:3, :3]) / np.sqrt(8))))
    return angle, 1000 * np.linalg.norm(((T - truth) @ middle)[:3])


# %%
# **Thin and describe.** Voxels of 4 mm; normals from 2 voxels around, that look to the camera (at the origin of its
# frame), so that both scans mean the same side; FPFH from 5 voxels. These ratios do for most data.
voxel = 0.004
thin, features = [], []
for cloud in (source, target):
    cloud = cloud.voxel_down_sample(voxel).estimate_normals(radius=2 * voxel, max_nn=30)
    cloud = cloud.orient_normals_towards_camera_location([0, 0, 0])
    thin.append(cloud)
    features.append(loom.compute_fpfh_feature(cloud, radius=5 * voxel, max_nn=100))
print(thin[0], features[0].shape)

# %%
# **Pair.** Each point with the one whose description is nearest; ``mutual_filter`` keeps those that choose each
# other.
pairs = reg.correspondences_from_features(*features, mutual_filter=True)
apart = np.linalg.norm(thin[0].transform(truth).points[pairs[:, 0]] - thin[1].points[pairs[:, 1]], axis=1)
right = apart < 2 * voxel
print(f"{len(pairs)} pairs, {100 * right.mean():.0f} % of them right")
assert 0.03 < right.mean() < 0.9

# %%
# **Agree.** RANSAC draws triples and counts; the checkers refuse a triple cheaply: edges that differ in length,
# normals that disagree. FGR minimizes over all pairs with a robust kernel that tightens. The robust form looks for
# pairs that keep their distances; it draws nothing.
checkers = [
    reg.CorrespondenceChecker.by_edge_length(0.9),
    reg.CorrespondenceChecker.by_distance(1.5 * voxel),
    reg.CorrespondenceChecker.by_normal(np.radians(40)),
]
option = reg.FastGlobalRegistrationOption(maximum_correspondence_distance=1.5 * voxel)
results = {
    "RANSAC": reg.registration_ransac_based_on_correspondence(
        *thin, pairs, 1.5 * voxel, checkers=checkers, num_iterations=200_000, seed=0
    ),
    "FGR": reg.registration_fgr_based_on_correspondence(*thin, pairs, option),
    "robust": reg.registration_robust_based_on_correspondence(*thin, pairs, 1.5 * voxel),
}
for name, result in results.items():
    angle, distance = off(result.transformation)
    print(
        f"{name:20} {angle:6.2f} degrees, {distance:5.1f} mm off, fitness {result.fitness:.2f}, score "
        f"{reg.assess_registration(*thin, result.transformation, 1.5 * voxel).score:.2f}"
    )
for name in ("RANSAC", "robust"):
    assert off(results[name].transformation)[0] < 5

# %%
# **Refine** by ICP on the full clouds, from a pose that is nearly right.
normals = target.estimate_normals(max_nn=20)
refined = reg.registration_icp(
    source,
    normals,
    2 * voxel,
    results["robust"].transformation,
    reg.TransformationEstimation.point_to_plane(),
    overlap=None,
)
print(f"after ICP: {off(refined.transformation)[0]:.3f} degrees, {off(refined.transformation)[1]:.2f} mm")
assert off(refined.transformation)[0] < 0.5

# %%
# Where scans stand upright, say so: this checker refuses poses that tilt, and RANSAC has to find only the turn about
# one axis. In the frames of these cameras that is not z, so it has nothing to accept here; it is shown for what it
# says.
upright = reg.CorrespondenceChecker.by_rotation([np.radians(10), np.radians(10), np.pi])
assert upright.Check(*thin, pairs[:3], np.eye(4)) and not upright.Check(*thin, pairs[:3], np.diag([1.0, -1, -1, 1]))

# %%
# The pairs: green right, red wrong, every eighth of them; and both scans under the refined pose.
shift = np.eye(4)
shift[:3, 3] = [-0.34, 0, 0]
beside = thin[0].transform(shift)
scene = [{"geometry": source.transform(shift), "point_size": 3}, {"geometry": target, "point_size": 3}]
for good, color in ((False, (0.85, 0.2, 0.15)), (True, (0.1, 0.65, 0.25))):
    lines = loom.LineSet.create_from_point_cloud_correspondences(
        beside, thin[1], pairs[right == good][:: 8 if good else 16]
    )
    scene.append({"geometry": lines, "color": color, "line_width": 1})
third = np.array([0.3, 0, 0])
scene += [
    {"geometry": target.translate(third).without("colors"), "color": (0.2, 0.5, 0.8)},
    {
        "geometry": source.transform(refined.transformation).translate(third).without("colors"),
        "color": (0.95, 0.6, 0.15),
    },
]
corners = np.vstack([part["geometry"].points for part in scene])
image = loom.render(scene, loom.View.fit(corners, direction=(0.05, 0.1, 1.0), up=(0, -1, 0), width=1120, height=480))
