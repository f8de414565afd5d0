"""
Doppler ICP in a tunnel
=======================

In a tunnel, the geometry does not determine the motion along the axis. An FMCW LiDAR also measures the radial velocity
of each point, which determines it. On this page you compare ICP with and without Doppler velocities.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two scans in a tunnel
# ---------------------
# The tunnel has a radius of 5 m and a length of 200 m. The vehicle moves at 25 m/s. The scans are 0.1 s and 2.5 m
# apart, with noise of 2 cm in range and 5 cm/s in velocity.
tunnel = loom.TriangleMesh.create_cylinder(5.0, 200.0, 96, 40).rotate([[0, 0, 1.0], [0, 1, 0], [-1, 0, 0]], [0, 0, 0])
scene = loom.RaycastingScene()
scene.add_triangles(tunnel.vertices.astype(np.float32), tunnel.triangles)
azimuth, elevation = np.meshgrid(np.linspace(-np.pi, np.pi, 512, endpoint=False), np.radians(np.linspace(-22, 22, 40)))
rays = np.column_stack(
    [
        np.cos(elevation).ravel() * np.cos(azimuth).ravel(),
        np.cos(elevation).ravel() * np.sin(azimuth).ravel(),
        np.sin(elevation).ravel(),
    ]
)
period, speed = 0.1, 25.0
velocity = np.array([speed, 0.0, 0.0])


def scan(x, seed):
    """Simulate a scan at x [m]: points in sensor coordinates, with radial velocities [m/s]."""
    rng = np.random.default_rng(seed)
    origins = np.tile([x, 0.3, -3.2], (len(rays), 1))
    distance = np.asarray(scene.cast_rays(np.hstack([origins, rays]).astype(np.float32))["t_hit"], np.float64)
    hit = np.isfinite(distance) & (distance < 60) & (distance > 1.5)
    points = rays[hit] * (distance[hit] + rng.normal(scale=0.02, size=hit.sum()))[:, None]
    dopplers = -(rays[hit] @ velocity) + rng.normal(scale=0.05, size=hit.sum())
    return loom.PointCloud(points, dopplers=dopplers.astype(np.float32))


first, second = scan(0.0, 1), scan(speed * period, 2)
target = second.estimate_normals(max_nn=20)
truth = np.eye(4)
truth[0, 3] = -speed * period  # T_second_first: static points are 2.5 m closer
print(first)

# %%
# Geometry only
# -------------
# Every point has a correspondence and the rmse is that of the noise, but the translation has an error of meters.
plane = reg.registration_icp(first, target, 1.0, np.eye(4), reg.TransformationEstimationPointToPlane())
print(
    f"point to plane: {plane.transformation[0, 3]:+.3f} m along the tunnel, fitness {plane.fitness:.3f}, "
    f"rmse {plane.inlier_rmse:.3f} m"
)
assert plane.fitness > 0.9 and abs(plane.transformation[0, 3] - truth[0, 3]) > 1.0

# %%
# With Doppler velocities
# -----------------------
# The attribute ``dopplers`` [m/s] is negative for approaching points. ``lambda_doppler`` is the weight of the
# velocities, ``period`` the time between the scans [s]. Points whose velocity contradicts the motion, such as other
# vehicles, can be removed.
doppler = reg.TransformationEstimationForDopplerICP(period=period, lambda_doppler=0.05, reject_dynamic_outliers=True)
criteria = reg.ICPConvergenceCriteria(max_iteration=100)
result = reg.registration_icp(first, target, 1.0, np.eye(4), doppler, criteria)
print(f"with velocities: {result.transformation[0, 3]:+.3f} m along the tunnel; ground truth {truth[0, 3]:+.3f} m")
angle = np.degrees(np.arccos(np.clip((np.trace(result.transformation[:3, :3]) - 1) / 2, -1, 1)))
print(
    f"error {np.linalg.norm(result.transformation[:3, 3] - truth[:3, 3]):.3f} m and {angle:.3f} degrees, "
    f"{result.iterations} iterations"
)
assert np.linalg.norm(result.transformation[:3, 3] - truth[:3, 3]) < 0.05

# %%
# The first scan colored by velocity. Blue points approach, red points recede. The vehicle is at the boundary between
# them.
central_part = first.select_by_mask(np.abs(first.points[:, 0]) < 22)
colored = {
    "geometry": central_part,
    "color_by": "dopplers",
    "colormap": "coolwarm",
    "limits": (-25, 25),
    "point_size": 3,
}
view = loom.View.fit(
    first.points[np.abs(first.points[:, 0]) < 30], direction=(0.45, 0.85, -0.35), width=960, height=560
)
image = loom.render(colored, view, color_bar=True)

# %%
# What to change
# --------------
# - ``lambda_doppler``: 0 uses the geometry only, 1 the velocities only.
# - The noise of the velocities [m/s]: 0.5 instead of 0.05. How large is the error along the tunnel?
# - ``period`` [s]: a wrong value scales the motion.
#
# Next
# ----
# - :ref:`Degenerate geometry: odometry in a corridor <sphx_glr_gallery_registration_plot_degenerate_corridor.py>`
# - :doc:`Registration </registration>`: all estimation methods.
