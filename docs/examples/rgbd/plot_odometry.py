"""
RGB-D odometry of two frames
============================

On this page you estimate the motion of a camera between two RGB-D frames with three methods, and check the reliability
of the result. Frames without overlap have no valid result.
"""

import numpy as np

import pointloom as loom
from pointloom.rgbd.odometry.rgbd_odometry import compute_odometry_information_matrix

od = loom.rgbd

# %%
# Two frames
# ----------

frames = loom.datasets.room_frames(24)
first, second = frames[2], frames[3]
camera = first.intrinsic
true = np.linalg.inv(second.T_world_camera) @ first.T_world_camera  # from first to second camera coordinates


def motion_error(T):
    """Error of a motion: rotation [degrees] and translation [mm]."""
    E = np.linalg.inv(T) @ true
    return np.degrees(np.arccos(np.clip((np.trace(E[:3, :3]) - 1) / 2, -1, 1))), 1e3 * np.linalg.norm(E[:3, 3])


still = motion_error(np.eye(4))
print(f"the camera rotated by {still[0]:.1f} degrees and moved {still[1] / 10:.1f} cm")

# %%
# Align
# -----
#
# ``OdometryFrame`` is an image pyramid on the device, computed once and used in each pair. The ``hybrid`` method
# compares surfaces and intensities, so either geometry or texture is sufficient.

source = od.OdometryFrame(first.depth, camera, first.color, depth_scale=1.0)
target = od.OdometryFrame(second.depth, camera, second.color, depth_scale=1.0)
result = od.align_frames(source, target)
assert result.reliable, result.warnings
print(f"fitness {result.fitness:.2f}, inlier rmse {result.inlier_rmse * 1e3:.1f} mm, {result.iterations} iterations")
for name, method in {"both": "hybrid", "surface": "point-to-plane", "brightness": "intensity"}.items():
    tried = od.align_frames(source, target, method=method)
    angle, distance = motion_error(tried.transformation)
    print(f"{name:10} error {angle:.3f} degrees, {distance:.1f} mm {tried.warnings}")
assert motion_error(result.transformation)[0] < 0.5 and motion_error(result.transformation)[1] < 15

# %%
# Frames without overlap
# ----------------------
#
# The result is unreliable and has a warning.

distant_frame = frames[14]
unreliable = od.align_frames(
    source, od.OdometryFrame(distant_frame.depth, camera, distant_frame.color, depth_scale=1.0)
)
print("warnings:", unreliable.warnings)
assert not unreliable.reliable

# %%
# Open3D's interface
# ------------------
#
# ``compute_rgbd_odometry`` has the parameters and the result of Open3D's function. The information matrix is the weight
# of an edge in a pose graph.

pair = [loom.RGBDImage(f.color, f.depth, depth_scale=1.0, depth_trunc=4.0) for f in (first, second)]
success, T, information = od.compute_rgbd_odometry(*pair, camera)
assert success and information.shape == (6, 6)
matrix = compute_odometry_information_matrix(first.depth, second.depth, camera, T, 0.03, depth_scale=1.0)
print(f"error {motion_error(T)[1]:.1f} mm; {matrix[5, 5]:.0f} pixels agree")
assert motion_error(T)[1] < 20

# %%
# Before and after
# ----------------
#
# The first frame is orange, the second blue, seen from above: without motion, and with the estimated motion.

clouds = [loom.PointCloud.create_from_rgbd_image(image, camera) for image in pair]
colors = [(0.95, 0.6, 0.1), (0.1, 0.5, 0.85)]
view = loom.View.fit(clouds[1].points, direction=(0.15, 0.75, 1.0), up=(0, -1, 0), width=640, height=640)
images = []
for distance in (clouds[0], clouds[0].transform(result.transformation)):
    scene = [{"geometry": cloud, "color": color} for cloud, color in zip((distance, clouds[1]), colors, strict=False)]
    images.append(
        loom.render(
            scene, view, (640, 640), legend=[("first frame", colors[0]), ("second frame", colors[1])], point_size=2.5
        )
    )
image = np.hstack(images)

# %%
# What to change
# --------------
# - The frames: 2 and 4, 2 and 6. At which distance is the result unreliable?
# - ``method``: ``"hybrid"``, ``"point-to-plane"`` or ``"intensity"``.
# - ``depth_trunc`` [m]: 2.0 excludes distant depth.
#
# Next
# ----
# - :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>`: odometry, step by step.
# - :ref:`Track a depth camera in real time <sphx_glr_gallery_rgbd_plot_track_live.py>`
