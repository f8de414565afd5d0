"""
ICP with low overlap
====================

If two scans share a quarter of the scene, three quarters of the points have no correct correspondence. ICP pairs them
with the nearest points anyway, which biases the pose. On this page you limit the correspondences by the overlap, which
is given or estimated.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two partial scans
# -----------------
# The parts of the room share a quarter of its length. The initial error is 2 degrees and 6 cm, as after a coarse
# registration.
room = loom.datasets.room_cloud().voxel_down_sample(0.04)
low, high = room.get_min_bound(), room.get_max_bound()
fraction = (room.points[:, 0] - low[0]) / (high[0] - low[0])
rng = np.random.default_rng(2)
is_odd = rng.random(len(room)) < 0.5
target = room.select_by_mask((fraction < 0.57) & is_odd)
source = room.select_by_mask((fraction > 0.43) & ~is_odd)
truth_fraction = ((fraction > 0.43) & (fraction < 0.57) & ~is_odd).sum() / len(source)
theta = np.radians(2.0)
start = np.eye(4)
start[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
start[:3, 3] = source.get_center() - start[:3, :3] @ source.get_center() + [0.05, 0.03, 0.02]
print(f"{len(source)} and {len(target)} points; {100 * truth_fraction:.0f} % of the source points are in the overlap")


def pose_error(T):
    """Error of a pose, where the true pose is the identity: rotation [degrees] and translation at the center [mm]."""
    center = np.r_[0.5 * (low + high), 1]
    angle = np.degrees(2 * np.arcsin(min(1, np.linalg.norm(T[:3, :3] - np.eye(3)) / np.sqrt(8))))
    return angle, 1000 * np.linalg.norm((T @ center - center)[:3])


# %%
# Trimmed correspondences
# -----------------------
# The correspondence distance determines how many wrong pairs are used. The script compares all pairs (``overlap=1.0``,
# as in other libraries), a given fraction, and the estimated fraction (``overlap=None``).
method = reg.TransformationEstimationForGeneralizedICP()
criteria = reg.ICPConvergenceCriteria(max_iteration=80)
errors = {}
for distance in (0.16, 0.4, 1.0):
    for name, overlap in {"all pairs": 1.0, "30 % given": 0.3, "estimated": None}.items():
        registration = reg.registration_icp(source, target, distance, start, method, criteria, overlap=overlap)
        errors[distance, name] = pose_error(registration.transformation)
        print(
            f"within {distance:4.2f} m, {name:10}: {errors[distance, name][0]:.3f} degrees, "
            f"{errors[distance, name][1]:6.1f} mm, inliers {100 * registration.fitness:.0f} %"
        )
for distance in (0.4, 1.0):
    assert errors[distance, "estimated"][1] < 0.5 * errors[distance, "all pairs"][1]
assert errors[0.4, "estimated"][1] < 15

# %%
# An overestimated overlap increases the error: 30% were given, 21% are correct, and the error is some centimeters.
# ``multi_scale_icp`` estimates the overlap if less than half of the points have a correspondence. A large distance on
# the coarse scale can move the source too far away, so begin with the smallest distance that the initial error permits.
rules = [reg.ICPConvergenceCriteria(max_iteration=60)] * 2
coarse_to_fine = {}
for first in (0.16, 0.48):
    multi_scale = reg.multi_scale_icp(
        source, target, [0.08, -1], rules, [first, 0.12], start, reg.TransformationEstimationPointToPlane()
    )
    coarse_to_fine[first] = pose_error(multi_scale.transformation)
    print(f"two scales from {first} m: {coarse_to_fine[first][0]:.3f} degrees, {coarse_to_fine[first][1]:.1f} mm")
assert coarse_to_fine[0.16][1] < coarse_to_fine[0.48][1]

# %%
# Normals
# -------
# ``max_normal_angle`` [rad] rejects pairs with different normals.
angled = reg.registration_icp(source, target, 0.4, start, method, criteria, max_normal_angle=np.radians(25))
print(
    f"normals within 25 degrees: {pose_error(angled.transformation)[0]:.3f} degrees, "
    f"{pose_error(angled.transformation)[1]:.1f} mm"
)

# %%
# The results from above, with all pairs and with the estimated overlap. The source is orange, the target blue. The
# walls should coincide.
shift = np.array([0, -(high[1] - low[1]) - 0.8, 0])
with_all_pairs = reg.registration_icp(source, target, 1.0, start, method, criteria)
with_overlap = reg.registration_icp(source, target, 1.0, start, method, criteria, overlap=None)
slab = loom.AxisAlignedBoundingBox(low - 1, [high[0] + 1, high[1] + 1, low[2] + 2.2])
scene = []
for result, step in ((with_all_pairs, 0), (with_overlap, 1)):
    scene += [
        {
            "geometry": target.without("colors", "normals").crop(slab).translate(step * shift),
            "color": (0.2, 0.5, 0.8),
            "point_size": 2,
        },
        {
            "geometry": source.without("colors", "normals")
            .transform(result.transformation)
            .crop(slab)
            .translate(step * shift),
            "color": (0.95, 0.55, 0.1),
            "point_size": 2,
        },
    ]
corners = np.vstack([part["geometry"].points for part in scene])
labels = [("all pairs", 0.5 * (low + high) + [0, 0, 1]), ("estimated overlap", 0.5 * (low + high) + shift + [0, 0, 1])]
image = loom.render(
    scene, loom.View.fit(corners, direction=(0, 0.02, -1), up=(1, 0, 0), width=1120, height=640), labels=labels
)

# %%
# What to change
# --------------
# - ``overlap``: 0.2 is the true value, 0.5 is too large.
# - The correspondence distance [m]: 0.16, 0.4 and 1.0 in the loop.
# - ``max_normal_angle`` [rad]: a smaller angle rejects more pairs, including correct ones of noisy normals.
#
# Next
# ----
# - :ref:`Chapter 7 <sphx_glr_chapters_plot_07_icp.py>`: ICP, step by step.
# - :ref:`Robust kernels for ICP with clutter <sphx_glr_gallery_registration_plot_robust_kernels.py>`
