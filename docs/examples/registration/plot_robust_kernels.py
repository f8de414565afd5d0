"""
Robust kernels for ICP with clutter
===================================

In least squares, all correspondences have the same weight, so wrong ones bias the pose. A robust kernel reduces the
weight of large residuals. On this page you compare seven kernels on a scan in which a third of the points is clutter.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# A scan with clutter
# -------------------
# The scan of a room has an initial error of 8 cm and 4 degrees. A third of its points is clutter, 5 to 30 cm in front
# of the surfaces.
rng = np.random.default_rng(7)
room = loom.datasets.room_cloud().voxel_down_sample(0.06)
target = room.without("colors")
picked = np.sort(rng.choice(len(room), len(room) // 2, replace=False))
good = room.points[picked] + rng.normal(scale=0.004, size=(len(picked), 3))
bad_rows = picked[: len(picked) // 2]
bad = room.points[bad_rows] + room.normals[bad_rows] * rng.uniform(0.05, 0.3, (len(bad_rows), 1))
truth = np.eye(4)
angle = np.radians(4)
truth[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
truth[:3, 3] = 0.06, -0.04, 0.03
scan = loom.PointCloud(np.vstack([good, bad])).transform(np.linalg.inv(truth))
is_bad = np.r_[np.zeros(len(good), bool), np.ones(len(bad), bool)]
print(f"{len(scan)} points, {100 * is_bad.mean():.0f} % of them clutter")


def pose_error(T):
    """Error at the center of the room: rotation [degrees] and translation [m]."""
    center = np.r_[room.get_center(), 1]
    E = T @ np.linalg.inv(truth)
    return np.degrees(np.arccos(np.clip((np.trace(E[:3, :3]) - 1) / 2, -1, 1))), np.linalg.norm(
        (E @ center - center)[:3]
    )


# %%
# Kernels
# -------
# ``k`` is the residual in meters above which the weight decreases, about three times the noise. L2 is least squares.
# Huber and L1 reduce the weight of large residuals. Cauchy, Geman-McClure and Tukey nearly remove them. The generalized
# loss contains all of them as special cases. The k of Geman-McClure is a squared length, as in Open3D.
k = 0.02
kernels = {
    "L2 (least squares)": reg.L2Loss(),
    "L1": reg.L1Loss(),
    "Huber": reg.HuberLoss(k),
    "Cauchy": reg.CauchyLoss(k),
    "Geman-McClure": reg.GMLoss(k**2),
    "Tukey": reg.TukeyLoss(3 * k),
    "generalized, -2": reg.GeneralizedLoss(k, shape=-2.0),
}
criteria = reg.ICPConvergenceCriteria(max_iteration=80)
error, poses = {}, {}
for name, kernel in kernels.items():
    result = reg.registration_icp(
        scan, target, 0.4, np.eye(4), reg.TransformationEstimationPointToPlane(kernel), criteria
    )
    error[name], poses[name] = pose_error(result.transformation), result.transformation
    print(f"{name:20} {error[name][0]:.3f} degrees, {1000 * error[name][1]:5.1f} mm, {result.iterations} iterations")
for name in ("Cauchy", "Geman-McClure", "Tukey"):
    assert error[name][1] < 0.3 * error["L2 (least squares)"][1]
assert error["Tukey"][1] < 0.01

# %%
# The room, with the registered inliers in blue and the clutter in orange:
registered = scan.transform(poses["Tukey"])
low, high = room.get_min_bound(), room.get_max_bound()
inner = loom.AxisAlignedBoundingBox([low[0], low[1] + 0.35, low[2]], [high[0] - 0.35, high[1], low[2] + 2.2])
scene = {
    "room": {"geometry": target.crop(inner), "color": (0.8, 0.8, 0.78)},
    "inliers": {"geometry": registered.select_by_mask(~is_bad).crop(inner), "color": (0.2, 0.5, 0.8), "point_size": 3},
    "clutter": {
        "geometry": registered.select_by_mask(is_bad).crop(inner),
        "color": (0.95, 0.55, 0.15),
        "point_size": 3,
    },
}
image = loom.render(
    scene, loom.View.fit(target.crop(inner).points, direction=(-0.5, 0.62, -0.8), width=960, height=640), legend=True
)

# %%
# What to change
# --------------
# - ``k`` [m]: 0.002 is below the noise, 0.2 is as large as the distance of the clutter.
# - The fraction of clutter: a third here. Which kernel fails first?
# - The correspondence distance [m]: 0.4. A smaller value also removes clutter, but needs a better initial pose.
#
# Next
# ----
# - :ref:`Chapter 14 <sphx_glr_chapters_plot_14_robust_kernels_and_numpy.py>`: choice of k from the noise.
# - :ref:`ICP with low overlap <sphx_glr_gallery_registration_plot_low_overlap.py>`
