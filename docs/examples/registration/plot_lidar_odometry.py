"""
LiDAR odometry: trajectory and map from scans
=============================================

On this page you estimate the trajectory of a vehicle from its LiDAR scans, check its reliability, and build a map. The
scans are deskewed, since the vehicle moves while the scanner rotates.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# A drive
# -------
# The data consists of 30 scans at 10 Hz and 10 m/s, in sensor coordinates, with a time for each point. The true poses
# are only used for the evaluation.
drive = loom.datasets.street_scans(30)
print(drive.scans[0])

# %%
# Register scan by scan
# ---------------------
# ``voxel_size`` is the voxel size of the map [m]. The default is a hundredth of the maximum range. The first scan
# defines the world coordinates.
odometry = reg.LidarOdometry(max_range=80.0, min_range=1.0)
poses = [odometry.register(scan) for scan in drive.scans]
last = odometry.steps[-1]
print(f"last scan: fitness {last.fitness:.2f}, {last.inliers} inliers, {last.iterations} iterations, {last.status}")

# %%
# Reliability
# -----------
# ``reliable`` is True if all checks of the trajectory passed. ``warnings`` contains the failed checks.
summary = odometry.summary
print(summary)
assert summary.reliable

# %%
# Accuracy
# --------
# The trajectory and the ground truth are aligned at the first pose.
path = loom.Trajectory(np.array(poses))
truth = loom.Trajectory(np.linalg.inv(drive.poses[0]) @ drive.poses)
error = reg.evaluate_trajectory(path, truth, align="first", lengths=[10.0, 20.0])
print(error)
assert error.absolute_translation.max < 0.3  # m, after 29 m
assert error.segment_translation < 1.0  # percent of the distance

# %%
# One call
# --------
# ``run_odometry`` processes a folder of files or a list of clouds. The trajectory is written in a common format.
with tempfile.TemporaryDirectory() as folder:
    for k in range(8):
        loom.write_point_cloud(Path(folder) / f"scan{k}.ply", drive.scans[k])
    print(sorted(file.name for file in Path(folder).iterdir()))
    one_call = reg.run_odometry(folder, max_range=80.0, min_range=1.0)
    assert np.array_equal(one_call.poses, path.poses[:8])  # bitwise identical
    loom.write_trajectory(Path(folder) / "path.kitti", path)
    read_back = loom.read_trajectory(Path(folder) / "path.kitti")
print("read back:", read_back.poses.shape, f"error {np.abs(read_back.poses - path.poses).max():.1e}")

# %%
# Map
# ---
# Each scan is deskewed, transformed by its pose, and added to the map. The color is the height, the line is the
# trajectory.
registered = []
for index, (scan, pose) in enumerate(zip(drive.scans, path.poses, strict=True)):
    motion = np.linalg.inv(path.poses[index - 1]) @ pose if index else np.linalg.inv(pose) @ path.poses[1]
    registered.append(reg.deskew_point_cloud(scan, motion).transform(pose))
street = loom.PointCloud.concatenate(registered).voxel_down_sample(0.12)
print(street)
center = path.poses[15][:3, 3]
map_part = street.select_by_mask((np.abs(street.points - center) < [32, 26, 20]).all(axis=1))
positions = path.poses[:, :3, 3] + [0, 0, 0.3]
line = loom.LineSet(positions, np.column_stack([np.arange(29), np.arange(1, 30)]).astype(np.int32))
view = loom.View.fit(map_part.points, direction=(0.35, 0.75, -0.5), width=960, height=640)
style = {"line_width": 6, "color": (0.9, 0.1, 0.1)}
street_map = loom.render([{"geometry": map_part, "point_size": 3}, {"geometry": line} | style], view)

# %%
# The effect of deskewing
# -----------------------
# A surface that is measured in several scans is sharper after deskewing.
raw = loom.PointCloud.concatenate([scan.transform(pose) for scan, pose in zip(drive.scans, path.poses, strict=True)])
deskewed = loom.PointCloud.concatenate(
    [scan.transform(pose) for scan, pose in zip(registered, np.tile(np.eye(4), (30, 1, 1)), strict=True)]
)
roughness = {}
for name, merged in {"as measured": raw, "deskewed": deskewed}.items():
    poles = merged.select_by_mask(
        np.isin(merged["label"], [4, 7]) & (np.abs(merged.points - center) < [15, 20, 20]).all(axis=1)
    )
    shapes = loom.compute_eigen_features(poles, radius=0.4, max_nn=60)
    roughness[name] = float(np.nanmedian(shapes["curvature"]))
    print(f"{name}: roughness of houses and poles {roughness[name]:.4f}")
assert roughness["deskewed"] < roughness["as measured"]

# %%
# A recording of the odometry:
page = Path(tempfile.mkdtemp()) / "drive.html"
with loom.record(page, title="A drive, scan by scan", max_points=40_000):
    reg.run_odometry(drive.scans[:12], max_range=80.0, min_range=1.0)
print(f"{page.stat().st_size / 2**20:.1f} MiB")

# %%
# What to change
# --------------
# - ``max_range`` and ``min_range`` [m]: the range of the points that are used.
# - ``voxel_size`` of the map [m]: a larger value is faster and less accurate.
# - ``deskew``: ``False`` if the scans are already deskewed.
#
# Next
# ----
# - :ref:`Pose graphs and loop closure <sphx_glr_gallery_registration_plot_pose_graph_loop_closure.py>`
# - :ref:`Degenerate geometry: odometry in a corridor <sphx_glr_gallery_registration_plot_degenerate_corridor.py>`
# - :doc:`Registration </registration>`: LiDAR SLAM with loop closure.
