"""
Batch ICP: many registrations in one call
=========================================

A hundred small registrations in a loop do not use a GPU or all cores. A batch runs them together with a few kernel
launches per iteration. On this page you register all consecutive scans of a drive in one call, and one scan from many
initial poses.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Scans
# -----
# The data consists of 12 scans of a street, deskewed with the known velocity, downsampled to 30 cm, with normals.
drive = loom.datasets.street_scans(12)
step = np.eye(4)
step[0, 3] = 1.0  # 10 m/s at 10 Hz: 1 m per scan
scans = [reg.deskew_point_cloud(scan, step).voxel_down_sample(0.3).estimate_normals(max_nn=15) for scan in drive.scans]
print(scans[0])

# %%
# Consecutive scans
# -----------------
# The arguments are lists of sources and targets, and an initial pose for each. A cloud in several pairs is preprocessed
# once. Converged registrations cause no further cost.
sources, targets = scans[1:], scans[:-1]
inits = np.tile(step, (len(sources), 1, 1))
estimation = reg.TransformationEstimationForGeneralizedICP()
results = reg.registration_icp_batch(sources, targets, 1.0, inits, estimation)
for k, result in enumerate(results[:3]):
    print(
        f"scan {k + 1} onto {k}: {result.transformation[:3, 3].round(3)} m, fitness {result.fitness:.2f}, "
        f"{result.iterations} iterations"
    )

# %%
# The results are those of single registrations, up to the last digits.
single = reg.registration_icp(sources[4], targets[4], 1.0, inits[4], estimation)
print(f"difference of single and batch: {np.abs(single.transformation - results[4].transformation).max():.1e}")
assert np.allclose(single.transformation, results[4].transformation, atol=1e-9)

# %%
# Chained, the relative poses are a trajectory, the result of odometry without a map.
chain = [np.eye(4)]
for result in results:
    chain.append(chain[-1] @ result.transformation)
path = loom.Trajectory(np.array(chain))
truth = loom.Trajectory(np.linalg.inv(drive.poses[0]) @ drive.poses)
error = reg.evaluate_trajectory(path, truth, align="first", lengths=[5.0, 10.0])
print(f"{error.absolute_translation.max:.3f} m error at the end of {len(results)} m")
assert error.absolute_translation.max < 0.3

# %%
# Many initial poses
# ------------------
# A grid of initial poses shows the convergence range.
offsets = np.linspace(-4, 4, 9)
starts = np.tile(results[0].transformation, (81, 1, 1))
starts[:, :2, 3] += np.array([[x, y] for x in offsets for y in offsets])
batch_results = reg.registration_icp_batch(
    sources[0], targets[0], 2.0, starts, reg.TransformationEstimationPointToPlane()
)
final_positions = np.array([result.transformation[:3, 3] for result in batch_results])
is_correct = np.linalg.norm(final_positions - results[0].transformation[:3, 3], axis=1) < 0.1
print("initial poses that converge (#), x forward from left to right [m]:")
for row in is_correct.reshape(9, 9).T[::-1]:
    print("   " + " ".join("#" if good else "." for good in row))
assert is_correct.reshape(9, 9)[4, 4] and is_correct.sum() >= 9

# %%
# The first and the last scan, 11 m apart, with the poses of the batch:
scene = {}
for name, k, color in (("first", 0, (0.2, 0.5, 0.8)), ("last", 11, (0.95, 0.55, 0.1))):
    cloud = reg.deskew_point_cloud(drive.scans[k], step).transform(path.poses[k])
    street_part = cloud.select_by_mask((np.abs(cloud.points - [5, 0, 4]) < [24, 16, 12]).all(axis=1)).without("colors")
    scene[name] = {"geometry": street_part, "color": color, "point_size": 3}
corners = np.vstack([part["geometry"].points for part in scene.values()])
view = loom.View.fit(corners, direction=(0.35, 0.75, -0.5), width=960, height=640)
image = loom.render(scene, view, legend=True)

# %%
# What to change
# --------------
# - ``offsets`` [m]: a larger grid of initial poses.
# - The correspondence distance [m]: 2.0 in the second batch. A larger value extends the convergence range.
# - ``voxel_size`` [m]: 0.5 instead of 0.3 is faster and less accurate.
#
# Next
# ----
# - :ref:`ICP methods and their convergence range <sphx_glr_gallery_registration_plot_icp_methods_and_basins.py>`
# - :ref:`LiDAR odometry: trajectory and map from scans <sphx_glr_gallery_registration_plot_lidar_odometry.py>`
