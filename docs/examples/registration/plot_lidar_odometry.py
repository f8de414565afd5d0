"""
A LiDAR drive becomes a path and a map
======================================

A car drives through a street, its scanner turns ten times a second: the scans alone give the path, the map,
and a check of the reliability of both. Scans are straightened on the way, since the car moves while the scanner
turns.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Thirty scans, three seconds at 10 m/s, each in the scanner's own frame, with the time of each point. The true poses
# are used to judge alone.
drive = loom.datasets.street_scans(30)
print(drive.scans[0])

# %%
# Scan by scan. ``voxel_size`` is the map's [m]: a hundredth of the range as a rule. The first scan is the world.
odometry = reg.LidarOdometry(max_range=80.0, min_range=1.0)
poses = [odometry.register(scan) for scan in drive.scans]
last = odometry.steps[-1]
print(f"last scan: fitness {last.fitness:.2f}, {last.inliers} inliers, {last.iterations} steps, {last.status}")

# %%
# **Quality** first. ``reliable`` is True if all checks of the path passed; ``warnings`` has those that failed.
summary = odometry.summary
print(summary)
assert summary.reliable

# %%
# **The path** against the true one, both begun at the first scan.
path = loom.Trajectory(np.array(poses))
truth = loom.Trajectory(np.linalg.inv(drive.poses[0]) @ drive.poses)
error = reg.evaluate_trajectory(path, truth, align="first", lengths=[10.0, 20.0])
print(error)
assert error.absolute_translation.max < 0.3  # m, after 29 m
assert error.segment_translation < 1.0  # percent of the way

# %%
# The whole run in one call, from a folder of files or a list of clouds; written as a file that other programs read.
with tempfile.TemporaryDirectory() as folder:
    for k in range(8):
        loom.write_point_cloud(Path(folder) / f"scan{k}.ply", drive.scans[k])
    print(sorted(file.name for file in Path(folder).iterdir()))
    again = reg.run_odometry(folder, max_range=80.0, min_range=1.0)
    assert np.array_equal(again.poses, path.poses[:8])  # the same bits
    loom.write_trajectory(Path(folder) / "path.kitti", path)
    back = loom.read_trajectory(Path(folder) / "path.kitti")
print("read back:", back.poses.shape, f"to {np.abs(back.poses - path.poses).max():.1e}")

# %%
# **The map**: each scan at its pose, straightened by the motion during its turn, and thinned. The colors are
# heights; the line is the path.
registered = []
for index, (scan, pose) in enumerate(zip(drive.scans, path.poses, strict=True)):
    motion = np.linalg.inv(path.poses[index - 1]) @ pose if index else np.linalg.inv(pose) @ path.poses[1]
    registered.append(reg.deskew_point_cloud(scan, motion).transform(pose))
street = loom.PointCloud.concatenate(registered).voxel_down_sample(0.12)
print(street)
center = path.poses[15][:3, 3]
near = street.select_by_mask((np.abs(street.points - center) < [32, 26, 20]).all(axis=1))
positions = path.poses[:, :3, 3] + [0, 0, 0.3]
line = loom.LineSet(positions, np.column_stack([np.arange(29), np.arange(1, 30)]).astype(np.int32))
view = loom.View.fit(near.points, direction=(0.35, 0.75, -0.5), width=960, height=640)
style = {"line_width": 6, "color": (0.9, 0.1, 0.1)}
street_map = loom.render([{"geometry": near, "point_size": 3}, {"geometry": line} | style], view)

# %%
# By kind: what straightening does. The same wall point was measured in several scans; straightened, they lie on each
# other.
raw = loom.PointCloud.concatenate([scan.transform(pose) for scan, pose in zip(drive.scans, path.poses, strict=True)])
truly = loom.PointCloud.concatenate(
    [scan.transform(pose) for scan, pose in zip(registered, np.tile(np.eye(4), (30, 1, 1)), strict=True)]
)
blur = {}
for name, merged in {"as measured": raw, "straightened": truly}.items():
    poles = merged.select_by_mask(
        np.isin(merged["label"], [4, 7]) & (np.abs(merged.points - center) < [15, 20, 20]).all(axis=1)
    )
    shapes = loom.compute_eigen_features(poles, radius=0.4, max_nn=60)
    blur[name] = float(np.nanmedian(shapes["curvature"]))
    print(f"{name}: houses and poles are {blur[name]:.4f} rough")
assert blur["straightened"] < blur["as measured"]

# %%
# The run as it went: play, turn, and scrub through it.
page = Path(tempfile.mkdtemp()) / "drive.html"
with loom.record(page, title="A drive, scan by scan", max_points=40_000):
    reg.run_odometry(drive.scans[:12], max_range=80.0, min_range=1.0)
print(f"{page.stat().st_size / 2**20:.1f} MiB")
