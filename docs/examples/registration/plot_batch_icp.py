"""
Many pairs in one call
======================

A hundred small registrations, one after the other, keep a GPU and all cores waiting. Together they are a few
launches an iteration. Here all pairs of neighboring scans of a drive are registered in one call, and one scan from
many starts.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Twelve scans of a street, straightened by what the car's own speed says, thinned to 30 cm, with normals.
drive = loom.datasets.street_scans(12)
step = np.eye(4)
step[0, 3] = 1.0  # 10 m/s and ten turns a second: 1 m a scan
scans = [reg.deskew_point_cloud(scan, step).voxel_down_sample(0.3).estimate_normals(max_nn=15) for scan in drive.scans]
print(scans[0])

# %%
# **All neighbors**: lists of sources and of targets, a start for each. A cloud that stands in several jobs is
# prepared once; a job that is done costs nothing more.
sources, targets = scans[1:], scans[:-1]
inits = np.tile(step, (len(sources), 1, 1))
estimation = reg.TransformationEstimation.generalized()
results = reg.registration_icp_batch(sources, targets, 1.0, inits, estimation)
for k, result in enumerate(results[:3]):
    print(
        f"scan {k + 1} onto {k}: {result.transformation[:3, 3].round(3)} m, fitness {result.fitness:.2f}, "
        f"{result.iterations} steps"
    )

# %%
# Each has the same result as alone, to about the last digit.
alone = reg.registration_icp(sources[4], targets[4], 1.0, inits[4], estimation)
print(f"alone and in the batch differ by {np.abs(alone.transformation - results[4].transformation).max():.1e}")
assert np.allclose(alone.transformation, results[4].transformation, atol=1e-9)

# %%
# Chained, they are a path: what an odometry without a map would find. Judged by the truth.
chain = [np.eye(4)]
for result in results:
    chain.append(chain[-1] @ result.transformation)
path = loom.Trajectory(np.array(chain))
truth = loom.Trajectory(np.linalg.inv(drive.poses[0]) @ drive.poses)
error = reg.evaluate_trajectory(path, truth, align="first", lengths=[5.0, 10.0])
print(f"{error.absolute_translation.max:.3f} m at the end of {len(results)} m")
assert error.absolute_translation.max < 0.3

# %%
# **One pair from many starts**: how far may the guess be off? A grid of starts around the right one, in one call.
offsets = np.linspace(-4, 4, 9)
starts = np.tile(results[0].transformation, (81, 1, 1))
starts[:, :2, 3] += np.array([[x, y] for x in offsets for y in offsets])
batch_results = reg.registration_icp_batch(
    sources[0], targets[0], 2.0, starts, reg.TransformationEstimation.point_to_plane()
)
ends = np.array([result.transformation[:3, 3] for result in batch_results])
right = np.linalg.norm(ends - results[0].transformation[:3, 3], axis=1) < 0.1
print("starts that end right, x forward from left to right [m]:")
for row in right.reshape(9, 9).T[::-1]:
    print("   " + " ".join("#" if good else "." for good in row))
assert right.reshape(9, 9)[4, 4] and right.sum() >= 9

# %%
# The first scan and the last, 11 m further on, each in its own color, under the path of the batch.
drawn = {}
for name, k, color in (("first", 0, (0.2, 0.5, 0.8)), ("last", 11, (0.95, 0.55, 0.1))):
    cloud = reg.deskew_point_cloud(drive.scans[k], step).transform(path.poses[k])
    near = cloud.select_by_mask((np.abs(cloud.points - [5, 0, 4]) < [24, 16, 12]).all(axis=1)).without("colors")
    drawn[name] = {"geometry": near, "color": color, "point_size": 3}
corners = np.vstack([part["geometry"].points for part in drawn.values()])
view = loom.View.fit(corners, direction=(0.35, 0.75, -0.5), width=960, height=640)
image = loom.render(drawn, view, legend=True)
