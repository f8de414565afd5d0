"""
Compare trajectories: ATE and RPE
=================================

The absolute trajectory error (ATE) is the error of the positions, the relative pose error (RPE) the error of motions.
Both depend on alignment and settings. On this page you compute them with each alignment, for a trajectory with known
errors.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two trajectories
# ----------------
# The ground truth is a drive of 240 m with timestamps. The estimate has a scale error of 3%, drift of the heading, and
# noise.
rng = np.random.default_rng(0)
count = 240
t = np.arange(count) * 0.1
positions = np.column_stack([t * 10, 12 * np.sin(t * 10 / 40), 2 * np.sin(t * 10 / 90)])
heading = np.arctan2(np.gradient(positions[:, 1]), np.gradient(positions[:, 0]))


def poses_of(positions, heading):
    """T_world_sensor of positions [m] and headings [rad]."""
    T = np.tile(np.eye(4), (len(positions), 1, 1))
    c, s = np.cos(heading), np.sin(heading)
    T[:, 0, 0], T[:, 0, 1], T[:, 1, 0], T[:, 1, 1] = c, -s, s, c
    T[:, :3, 3] = positions
    return T


truth = loom.Trajectory(poses_of(positions, heading), timestamps=t)
steps = np.linalg.inv(truth.poses[:-1]) @ truth.poses[1:]
steps[:, :3, 3] *= 1.03
drift = np.radians(0.04) + rng.normal(scale=np.radians(0.05), size=len(steps))
noise_poses = poses_of(rng.normal(scale=0.01, size=(len(steps), 3)), drift)
chain = [np.eye(4)]
for step in steps @ noise_poses:
    chain.append(chain[-1] @ step)
estimate = loom.Trajectory(np.array(chain), timestamps=t + 0.004)  # timestamps with an offset of 4 ms

# %%
# Alignment
# ---------
# "first" aligns the first poses: the error of a robot that uses the trajectory. The default is a least-squares
# alignment of all poses, as in benchmarks. With scale, it is suitable for monocular methods, whose scale is arbitrary.
# It hides the scale error of 3% here.
errors = {
    "no alignment": reg.evaluate_trajectory(estimate, truth, align=False, lengths=[50.0, 100.0]),
    "first pose": reg.evaluate_trajectory(estimate, truth, align="first", lengths=[50.0, 100.0]),
    "least squares": reg.evaluate_trajectory(estimate, truth, lengths=[50.0, 100.0]),
    "with a scale": reg.evaluate_trajectory(estimate, truth, with_scale=True, lengths=[50.0, 100.0]),
}
for name, error in errors.items():
    print(
        f"{name:14} ATE {error.absolute_translation.rmse:6.2f} m, RPE "
        f"{100 * error.relative_translation.rmse:.2f} cm, scale {error.scale:.3f}"
    )
ate = {name: error.absolute_translation.rmse for name, error in errors.items()}
assert ate["with a scale"] < ate["least squares"] < ate["first pose"]
assert abs(1 / errors["with a scale"].scale - 1.03) < 0.01

# %%
# RPE and segment errors
# ----------------------
# RPE is the error of motions over ``delta`` poses, and independent of the alignment. KITTI's metric is the error over
# segments in percent of the distance. Use it to compare drives of different length, since the ATE increases with the
# length.
aligned_error = errors["least squares"]
assert len(aligned_error.segments)
for segment in aligned_error.segments:
    print(segment)
print(f"{aligned_error.segment_translation:.2f} % and {aligned_error.segment_rotation:.4f} degrees/m over all of them")
assert abs(aligned_error.segment_translation - 3.0) < 1.0  # the scale error of 3 %
ten = reg.evaluate_trajectory(estimate, truth, delta=10)
motion = ten.relative_translation
print(
    f"over ten poses: {motion.rmse:.3f} m rmse, {motion.max:.3f} m maximum, of "
    f"{10 * np.linalg.norm(np.diff(positions, axis=0), axis=1).mean():.1f} m"
)

# %%
# Timestamps
# ----------
# Poses are associated by time, with a tolerance of 20 ms. Missing poses are ignored.
half = loom.Trajectory(estimate.poses[::2], timestamps=estimate.timestamps[::2])
some = reg.evaluate_trajectory(half, truth)
print(f"{len(some.pairs)} of {count} poses compared")
assert len(some.pairs) == count // 2

# %%
# Files
# -----
# The suffix selects the format: TUM (time and quaternion), KITTI (twelve numbers), Redwood (log).
with tempfile.TemporaryDirectory() as folder:
    for name in ("path.tum", "path.kitti", "path.log"):
        loom.write_trajectory(Path(folder) / name, estimate)
        read_back = loom.read_trajectory(Path(folder) / name)
        print(
            f"{name:11}{(Path(folder) / name).stat().st_size / 1024:5.1f} KiB, error of poses "
            f"{np.abs(read_back.poses - estimate.poses).max():.0e}, times "
            f"{'stored' if read_back.timestamps is not None else 'not stored'}"
        )
        assert np.abs(read_back.poses - estimate.poses).max() < 1e-5

# %%
# Both trajectories from above, with lines between associated poses. ``pointloom evaluate --picture`` plots the error.
aligned = aligned_error.transformation @ estimate.poses
from_first = errors["first pose"].transformation @ estimate.poses
pairs = np.column_stack([np.arange(0, count, 8), count + np.arange(0, count, 8)]).astype(np.int32)
along = np.column_stack([np.arange(count - 1), np.arange(1, count)]).astype(np.int32)
scene = {
    "true": {"geometry": loom.LineSet(positions, along), "color": (0.5, 0.5, 0.5), "line_width": 4},
    "least squares": {"geometry": loom.LineSet(aligned[:, :3, 3], along), "color": (0.1, 0.55, 0.3), "line_width": 4},
    "first pose": {"geometry": loom.LineSet(from_first[:, :3, 3], along), "color": (0.9, 0.35, 0.15), "line_width": 4},
    "error": {
        "geometry": loom.LineSet(np.vstack([from_first[:, :3, 3], positions]), pairs),
        "color": (0.9, 0.7, 0.5),
        "line_width": 1,
    },
}
image = loom.render(
    scene,
    loom.View.fit(
        np.vstack([positions, from_first[:, :3, 3]]), direction=(0, 0.35, -1), up=(0, 1, 0), width=1120, height=420
    ),
    legend=True,
)

# %%
# What to change
# --------------
# - ``delta`` [poses]: 1 measures the noise, 50 the drift.
# - ``lengths`` [m]: KITTI uses 100 to 800 m.
# - ``align`` and ``with_scale``: report which one you used.
#
# Next
# ----
# - :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>`: RGB-D odometry.
# - :ref:`LiDAR odometry: trajectory and map from scans <sphx_glr_gallery_registration_plot_lidar_odometry.py>`
