"""
Pose graphs and loop closure
============================

Small errors of a trajectory accumulate, so that the end of a loop does not meet its start. On this page you build a
pose graph, add loop closures, optimize it, and see that a wrong loop closure is rejected. The data is simulated, so the
true trajectory is known.
"""

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# A trajectory with drift
# -----------------------
# The trajectory has 60 poses on two rounds about a block of 12 x 8 m. Each relative motion has an error of 1 cm and 0.4
# degrees, and a systematic error of the heading.
rng = np.random.default_rng(6)
count = 60
s = 2 * np.pi * np.arange(count) * 2 / count
positions = np.column_stack([6 * np.cos(s) * (1 + 0.1 * np.cos(4 * s)), 4 * np.sin(s), 0.05 * np.arange(count)])


def pose(position, heading):
    """T_world_node of a position [m] and a heading [rad] about z."""
    T = np.eye(4)
    T[:2, :2] = [[np.cos(heading), -np.sin(heading)], [np.sin(heading), np.cos(heading)]]
    T[:3, 3] = position
    return T


directions = np.gradient(positions, axis=0)
truth = np.array(
    [pose(position, np.arctan2(step[1], step[0])) for position, step in zip(positions, directions, strict=True)]
)


def measured(a, b, noise=1.0):
    """Simulated measurement of T_b_a: the true motion with an error."""
    T = np.linalg.inv(truth[b]) @ truth[a]
    return T @ pose(
        noise * rng.normal(scale=[0.01, 0.01, 0.005]), noise * (rng.normal(scale=np.radians(0.4)) + np.radians(0.25))
    )


information = np.diag([200.0, 200.0, 200.0, 1000.0, 1000.0, 1000.0])
steps = [reg.PoseGraphEdge(k, k + 1, measured(k, k + 1), information) for k in range(count - 1)]
poses = [truth[0]]
for edge in steps:
    poses.append(poses[-1] @ np.linalg.inv(edge.transformation))
drifted = loom.Trajectory(np.array(poses))
true_path = loom.Trajectory(truth)
before = reg.evaluate_trajectory(drifted, true_path, align="first", lengths=[10.0])
print(f"before: {before.absolute_translation.rmse:.2f} m rmse, {before.absolute_translation.max:.2f} m maximum")

# %%
# Loop closures
# -------------
# Positions of the first round are observed again in the second round. Loop closures are *uncertain*, since different
# places may look similar. One of them is wrong.
closures = [
    reg.PoseGraphEdge(k, k + 30, measured(k, k + 30, 0.5), information, uncertain=True) for k in range(0, 30, 6)
]
false_closure = np.linalg.inv(truth[40]) @ truth[10] @ pose([3.0, -2.0, 0.0], 1.2)
closures.append(reg.PoseGraphEdge(3, 45, false_closure, information, uncertain=True))
graph = reg.PoseGraph([reg.PoseGraphNode(T) for T in poses], steps + closures)

# %%
# Optimize
# --------
# ``max_correspondence_distance`` is the largest expected error of a correct loop closure [m]. The pose of
# ``reference_node`` remains fixed. The result is a new graph with a report that lists the rejected edges.
option = reg.GlobalOptimizationOption(max_correspondence_distance=0.3, edge_prune_threshold=0.25, reference_node=0)
criteria = reg.GlobalOptimizationConvergenceCriteria(max_iteration=100)
solved = reg.global_optimization(graph, "levenberg-marquardt", criteria, option)
report = solved.report
print(
    f"{report.iterations} iterations, residual {report.initial_residual:.1f} to {report.residual:.3f},",
    report.criterion,
)
print("rejected:", [(graph.edges[k].source_node_id, graph.edges[k].target_node_id) for k in report.pruned_edges])
after_path = loom.Trajectory(np.array([node.pose for node in solved.nodes]))
after = reg.evaluate_trajectory(after_path, true_path, align="first", lengths=[10.0])
print(f"after: {after.absolute_translation.rmse:.2f} m rmse, {after.absolute_translation.max:.2f} m maximum")
assert report.pruned_edges.tolist() == [len(steps) + 5]  # the wrong loop closure only
assert after.absolute_translation.rmse < 0.5 * before.absolute_translation.rmse

# %%
# If the wrong loop closure is marked as certain, least squares accepts it and distorts the trajectory.
all_certain = [
    reg.PoseGraphEdge(e.source_node_id, e.target_node_id, e.transformation, e.information) for e in steps + closures
]
distorted = reg.global_optimization(reg.PoseGraph(graph.nodes, all_certain), "gauss-newton", criteria, option)
distorted_path = loom.Trajectory(np.array([node.pose for node in distorted.nodes]))
worse = reg.evaluate_trajectory(distorted_path, true_path, align="first", lengths=[10.0])
print(f"with the wrong loop accepted: {worse.absolute_translation.rmse:.2f} m rmse")
assert worse.absolute_translation.rmse > 2 * after.absolute_translation.rmse

# %%
# Files
# -----
# Pose graphs are stored in Open3D's format.
with tempfile.TemporaryDirectory() as folder:
    reg.write_pose_graph(Path(folder) / "walk.json", solved)
    read_back = reg.read_pose_graph(Path(folder) / "walk.json")
assert len(read_back.nodes) == count and np.allclose(read_back.nodes[-1].pose, solved.nodes[-1].pose)

# %%
# Information matrices
# --------------------
# For clouds, the information matrix of an edge is computed from the correspondences. It describes how well each of the
# six motions is determined.
scan = loom.datasets.object_scans(2).scans[0].voxel_down_sample(0.004)
weights = reg.get_information_matrix_from_point_clouds(scan, scan, 0.01, np.eye(4))
print("pairs:", int(weights[5, 5]), "of", len(scan), "points")
assert weights[5, 5] == len(scan)


# %%
# The true, the drifted and the optimized trajectory, with the accepted loop closures:
def trajectory_style(path, color, z=0.0):
    """A trajectory as a line."""
    points = path.poses[:, :3, 3] + [0, 0, z]
    lines = np.column_stack([np.arange(count - 1), np.arange(1, count)]).astype(np.int32)
    return {"geometry": loom.LineSet(points, lines), "color": color, "line_width": 5}


accepted = [(edge.source_node_id, edge.target_node_id) for edge in solved.edges if edge.uncertain]
loops = {
    "geometry": loom.LineSet(after_path.poses[:, :3, 3], np.array(accepted, np.int32)),
    "color": (0.2, 0.5, 0.8),
    "line_width": 2,
}
scene = {
    "true": trajectory_style(true_path, (0.6, 0.6, 0.6)),
    "drifted": trajectory_style(drifted, (0.9, 0.3, 0.15)),
    "optimized": trajectory_style(after_path, (0.1, 0.55, 0.3)),
    "closures": loops,
}
corners = np.vstack([drifted.poses[:, :3, 3], positions])
image = loom.render(scene, loom.View.fit(corners, direction=(0.2, 0.7, -0.8), width=960, height=640), legend=True)

# %%
# What to change
# --------------
# - ``edge_prune_threshold``: 0 keeps all edges, larger values reject more loop closures.
# - ``max_correspondence_distance`` [m]: larger values give loop closures more weight.
# - The number of loop closures: use only one. How large is the remaining error?
#
# Next
# ----
# - :ref:`Merge TSDF volumes and submaps <sphx_glr_gallery_rgbd_plot_submaps.py>`: loop closure for RGB-D
#   frames.
# - :ref:`Compare trajectories: ATE and RPE <sphx_glr_gallery_registration_plot_compare_trajectories.py>`
