"""
Global registration and its score
=================================

On this page you register two scans in arbitrary poses without an initial pose, and check the reliability of the result
by its score. The check is important, since every method returns a pose, even for two clouds without any overlap.
"""

import numpy as np

import pointloom as loom
from pointloom.registration.voxel_size import choose_voxel_size

reg = loom.registration

# %%
# Two partial scans
# -----------------
# The scans contain different parts of a room with some overlap. The second one is rotated by 140 degrees about an
# oblique axis.
room = loom.datasets.room_cloud().without("colors")
low, high = room.get_min_bound(), room.get_max_bound()
fraction = (room.points[:, 0] - low[0]) / (high[0] - low[0])
rng = np.random.default_rng(1)
is_odd = rng.random(len(room)) < 0.5  # no point is in both
target = room.select_by_mask((fraction < 0.68) & is_odd)
source = room.select_by_mask((fraction > 0.32) & ~is_odd)
axis, angle = np.array([0.3, 0.5, 0.81]), np.radians(140)
axis /= np.linalg.norm(axis)
K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
truth = np.eye(4)
truth[:3, :3] = np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K
truth[:3, 3] = [1.0, -2.0, 0.5]
source = source.transform(np.linalg.inv(truth))
print(f"source {len(source):,}, target {len(target):,} points")


def pose_error(T):
    """Error at the center of the source: rotation [degrees] and translation [m]."""
    center = np.r_[source.get_center(), 1]
    rotation_error = np.degrees(2 * np.arcsin(min(1, np.linalg.norm(T[:3, :3] - truth[:3, :3]) / np.sqrt(8))))
    return rotation_error, np.linalg.norm(((T - truth) @ center)[:3])


# %%
# One call
# --------
# ``register_pair`` selects the voxel size, searches for the pose, refines it, and assesses it. ``warnings`` contains
# the reasons if the result is unreliable.
pair = reg.register_pair(source, target)
print(pair)
rotation_error, distance = pose_error(pair.transformation)
print(f"{rotation_error:.3f} degrees, {1000 * distance:.1f} mm from the ground truth")
assert pair.reliable and rotation_error < 0.5 and distance < 0.02

# %%
# Separate steps
# --------------
# ``register_globally`` searches for the pose. Its parameter is the voxel size: smaller than the details, larger than
# the noise. ``choose_voxel_size`` proposes a value. Poses with a score above 0.5 are accepted.
voxel = choose_voxel_size(source, target)
result = reg.register_globally(source, target, voxel_size=voxel)
print(f"voxels of {voxel} m: score {result.score:.2f}, error {pose_error(result.transformation)[0]:.2f} degrees")
assert result.converged and result.score > 0.5

# %%
# Scores of wrong poses
# ---------------------
# The script computes the score of four poses: the true pose, two poses with an error of 60 cm, and one with an error of
# 180 degrees. Before the assessment, a pose is refined locally. The score cannot detect every error. The last pose
# slides along walls that both scans contain, and only the furniture shows the error. Compare the scores of such
# candidates instead of using the threshold 0.5.
shifted_across, upside_down = truth.copy(), truth @ np.diag([-1.0, -1.0, 1.0, 1.0])
shifted_across[1, 3] += 0.6
shifted_along = truth.copy()
shifted_along[0, 3] += 0.6
scores = {
    name: reg.assess_registration(source, target, T, 1.5 * voxel).score
    for name, T in {
        "ground truth": truth,
        "60 cm across": shifted_across,
        "rotated by 180 degrees": upside_down,
        "60 cm along": shifted_along,
    }.items()
}
print({name: round(score, 2) for name, score in scores.items()})
assert scores["ground truth"] > 0.5 > max(scores["60 cm across"], scores["rotated by 180 degrees"])
assert scores["ground truth"] == max(scores.values())

# %%
# Complete assessment
# -------------------
# The assessment of the result is computed on first access: fitness, score, displacement of the surfaces, undetermined
# motions, and standard deviations of the pose.
print(pair.assessment)
assert pair.assessment.score > 0.5 and pair.assessment.localizability.reliable

# %%
# Clouds without overlap
# ----------------------
# The clouds are a room and a street, scaled to the same size. The pose with the best fit has a high fitness, but a low
# score.
street = loom.datasets.street_scans(1).scans[0]
street = loom.PointCloud(street.points).scale(0.12, center=[0, 0, 0])
wrong = reg.register_globally(street, target, voxel_size=voxel)
print(f"fitness {wrong.fitness:.2f}, score {wrong.score:.2f}: {wrong.warnings[0]}")
assert not wrong.converged and wrong.score < 0.5

# %%
# The input and the registered scans:
inner = loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
registered = source.transform(pair.transformation)
shift = np.array([6.5, 4.5, 0])
scene = {
    "target": {"geometry": target.crop(inner), "color": (0.2, 0.5, 0.8)},
    "source": {"geometry": registered.crop(inner), "color": (0.95, 0.6, 0.15)},
    "target before": {"geometry": target.crop(inner).translate(-shift), "color": (0.2, 0.5, 0.8)},
    "source before": {
        "geometry": source.translate(room.get_center() - source.get_center() - shift + [1.0, -1.0, 0.5]),
        "color": (0.95, 0.6, 0.15),
    },
}
corners = np.vstack([style["geometry"].points for style in scene.values()])
image = loom.render(
    scene,
    loom.View.fit(corners, direction=(-0.5, 0.62, -0.8), width=1120, height=560),
    legend=[("target", (0.2, 0.5, 0.8)), ("source", (0.95, 0.6, 0.15))],
)

# %%
# What to change
# --------------
# - ``voxel`` [m]: twice the proposed value removes details that determine the pose.
# - The overlap: 0.68 and 0.32 are the limits of both parts along x. At which overlap does the score fall below 0.5?
# - The distance of ``assess_registration`` [m]: 1.5 voxels here. A larger value accepts less accurate poses.
#
# Next
# ----
# - :ref:`Chapter 8 <sphx_glr_chapters_plot_08_global_registration.py>`: features, RANSAC and FGR.
# - :doc:`How a registration is assessed </assessment>`
# - :ref:`Register ten scans of an object <sphx_glr_gallery_registration_plot_object_from_ten_views.py>`
