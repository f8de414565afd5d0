"""
From any pose, and when to believe it
=====================================

Two scans that lie anyhow are brought together without a first guess, and the answer says how far to believe it: a
score. The score matters more than the pose, since some pose comes out of any two clouds, also of two that have
nothing in common.
"""

import numpy as np

import pointloom as loom
from pointloom.registration.voxel_size import choose_voxel_size

reg = loom.registration

# %%
# Two parts of a room that share some, as two scans from two places do; the second one is turned by 140 degrees about
# a slant axis.
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


def off(T):
    """Degrees and meters from the true pose, at the middle of the source."""
    middle = np.r_[source.get_center(), 1]
    rotation_error = np.degrees(2 * np.arcsin(min(1, np.linalg.norm(T[:3, :3] - truth[:3, :3]) / np.sqrt(8))))
    return rotation_error, np.linalg.norm(((T - truth) @ middle)[:3])


# %%
# **In one call.** ``register_pair`` chooses the voxels, searches, refines and rates. ``warnings`` has the reasons
# if the result is unreliable.
pair = reg.register_pair(source, target)
print(pair)
rotation_error, distance = off(pair.transformation)
print(f"{rotation_error:.3f} degrees, {1000 * distance:.1f} mm from the truth")
assert pair.reliable and rotation_error < 0.5 and distance < 0.02

# %%
# **The parts of it.** ``register_globally`` searches; its voxel is the one thing to choose: smaller than what there
# is to recognize, larger than the noise. ``choose_voxel_size`` proposes one. A score above 0.5 is a pose that is
# believed.
voxel = choose_voxel_size(source, target)
result = reg.register_globally(source, target, voxel_size=voxel)
print(f"voxels of {voxel} m: score {result.score:.2f}, {off(result.transformation)[0]:.2f} degrees off")
assert result.converged and result.score > 0.5

# %%
# **What is not believed.** The right pose rated, one that is 60 cm off across the room, and one that is turned by
# half a turn. A pose that is a voxel or two off is brought nearer before it is judged. The score is not blind-proof:
# the last pose slides along the walls that both scans have, and nothing but furniture tells it from the right one.
# Two such poses are compared by their scores, not by 0.5.
beside, upside = truth.copy(), truth @ np.diag([-1.0, -1.0, 1.0, 1.0])
beside[1, 3] += 0.6
along = truth.copy()
along[0, 3] += 0.6
scores = {
    name: reg.assess_registration(source, target, T, 1.5 * voxel).score
    for name, T in {"the truth": truth, "60 cm beside": beside, "turned round": upside, "60 cm along": along}.items()
}
print({name: round(score, 2) for name, score in scores.items()})
assert scores["the truth"] > 0.5 > max(scores["60 cm beside"], scores["turned round"])
assert scores["the truth"] == max(scores.values())

# %%
# **The whole assessment** of the pose found, computed on first access: fitness, score, displacement of the surfaces,
# undetermined motions and the standard deviations of the pose.
print(pair.assessment)
assert pair.assessment.score > 0.5 and pair.assessment.localizability.reliable

# %%
# **Clouds that have nothing in common**: a room and a street. Some pose has the best fit, and fitness alone would not
# tell; the score does. The street is made as small as the room, so that size gives nothing away.
street = loom.datasets.street_scans(1).scans[0]
street = loom.PointCloud(street.points).scale(0.12, center=[0, 0, 0])
wrong = reg.register_globally(street, target, voxel_size=voxel)
print(f"fitness {wrong.fitness:.2f}, score {wrong.score:.2f}: {wrong.warnings[0]}")
assert not wrong.converged and wrong.score < 0.5

# %%
# The clouds as they were given, and under the pose found.
inner = loom.AxisAlignedBoundingBox([low[0], low[1] + 0.1, low[2]], [high[0] - 0.1, high[1], low[2] + 2.2])
moved = source.transform(pair.transformation)
shift = np.array([6.5, 4.5, 0])
scene = {
    "target": {"geometry": target.crop(inner), "color": (0.2, 0.5, 0.8)},
    "source": {"geometry": moved.crop(inner), "color": (0.95, 0.6, 0.15)},
    "target as given": {"geometry": target.crop(inner).translate(-shift), "color": (0.2, 0.5, 0.8)},
    "source as given": {
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
