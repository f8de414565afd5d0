"""
A LiDAR that measures speed: Doppler ICP in a tunnel
====================================================

In a tunnel no shape tells how far one went. A LiDAR that measures how fast each point comes nearer does know: its
radial speeds fix the motion along the axis. ICP with and without them, on the same two scans.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# A tunnel of 5 m in radius, 200 m long, and a car that goes through it at 25 m/s: from one scan to the next, 0.1 s
# later, it is 2.5 m. Every direction is measured with 2 cm of noise in range and 5 cm/s in speed.
tunnel = loom.TriangleMesh.create_cylinder(5.0, 200.0, 96, 40).rotate([[0, 0, 1.0], [0, 1, 0], [-1, 0, 0]], [0, 0, 0])
scene = loom.RaycastingScene()
scene.add_triangles(tunnel.vertices.astype(np.float32), tunnel.triangles)
azimuth, rise = np.meshgrid(np.linspace(-np.pi, np.pi, 512, endpoint=False), np.radians(np.linspace(-22, 22, 40)))
rays = np.column_stack(
    [
        np.cos(rise).ravel() * np.cos(azimuth).ravel(),
        np.cos(rise).ravel() * np.sin(azimuth).ravel(),
        np.sin(rise).ravel(),
    ]
)
period, speed = 0.1, 25.0
velocity = np.array([speed, 0.0, 0.0])


def scan(x, seed):
    """What the sensor measures at x [m]: points in its own frame, and their speeds toward it [m/s]."""
    rng = np.random.default_rng(seed)
    eye = np.tile([x, 0.3, -3.2], (len(rays), 1))
    distance = np.asarray(scene.cast_rays(np.hstack([eye, rays]).astype(np.float32))["t_hit"], np.float64)
    hit = np.isfinite(distance) & (distance < 60) & (distance > 1.5)
    points = rays[hit] * (distance[hit] + rng.normal(scale=0.02, size=hit.sum()))[:, None]
    dopplers = -(rays[hit] @ velocity) + rng.normal(scale=0.05, size=hit.sum())
    return loom.PointCloud(points, dopplers=dopplers.astype(np.float32))


first, second = scan(0.0, 1), scan(speed * period, 2)
target = second.estimate_normals(max_nn=20)
truth = np.eye(4)
truth[0, 3] = -speed * period  # T_second_first: what stood still is 2.5 m nearer
print(first)

# %%
# **By shape alone** every point has a partner, the fit is as good as the noise, and the motion is missed by meters.
plane = reg.registration_icp(first, target, 1.0, np.eye(4), reg.TransformationEstimation.point_to_plane())
print(
    f"point to plane: {plane.transformation[0, 3]:+.3f} m along the tunnel, fitness {plane.fitness:.3f}, "
    f"rmse {plane.inlier_rmse:.3f} m"
)
assert plane.fitness > 0.9 and abs(plane.transformation[0, 3] - truth[0, 3]) > 1.0

# %%
# **With speeds.** The attribute is called ``dopplers`` [m/s], negative where a thing comes nearer. ``lambda_doppler``
# is the fraction of the speeds in the sum, ``period`` the time between the scans [s]; points whose speed contradicts
# the
# motion (cars) may be dropped.
doppler = reg.TransformationEstimationForDopplerICP(period=period, lambda_doppler=0.05, reject_dynamic_outliers=True)
criteria = reg.ICPConvergenceCriteria(max_iteration=100)
result = reg.registration_icp(first, target, 1.0, np.eye(4), doppler, criteria)
print(f"with speeds: {result.transformation[0, 3]:+.3f} m along the tunnel; the truth is {truth[0, 3]:+.3f} m")
angle = np.degrees(np.arccos(np.clip((np.trace(result.transformation[:3, :3]) - 1) / 2, -1, 1)))
print(
    f"{np.linalg.norm(result.transformation[:3, 3] - truth[:3, 3]):.3f} m and {angle:.3f} degrees off, "
    f"{result.iterations} steps"
)
assert np.linalg.norm(result.transformation[:3, 3] - truth[:3, 3]) < 0.05

# %%
# The first scan by the speed of its points: blue comes nearer, red goes away, and the mirror between them is where
# the car is.
near = first.select_by_mask(np.abs(first.points[:, 0]) < 22)
colored = {"geometry": near, "color_by": "dopplers", "colormap": "coolwarm", "limits": (-25, 25), "point_size": 3}
view = loom.View.fit(
    first.points[np.abs(first.points[:, 0]) < 30], direction=(0.45, 0.85, -0.35), width=960, height=560
)
image = loom.render(colored, view, color_bar=True)
