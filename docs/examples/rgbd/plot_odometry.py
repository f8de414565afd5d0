"""
The motion between two depth frames
===================================

RGB-D odometry: two images of one camera, and the motion in between. The result is checked, since two frames
that do not show the same place have no motion between them.
"""

import numpy as np

import pointloom as loom
from pointloom.rgbd.odometry.rgbd_odometry import compute_odometry_information_matrix

od = loom.rgbd

# %%
# Two frames of a walk
# --------------------

frames = loom.datasets.room_frames(24)
first, second = frames[2], frames[3]
camera = first.intrinsic
true = np.linalg.inv(second.T_world_camera) @ first.T_world_camera  # from the first camera's frame to the second's


def difference(T):
    """Angle [degrees] and distance [mm] from the true motion."""
    E = np.linalg.inv(T) @ true
    return np.degrees(np.arccos(np.clip((np.trace(E[:3, :3]) - 1) / 2, -1, 1))), 1e3 * np.linalg.norm(E[:3, 3])


still = difference(np.eye(4))
print(f"the camera rotated by {still[0]:.1f} degrees and moved {still[1] / 10:.1f} cm")

# %%
# Align
# -----
#
# An ``OdometryFrame`` is a pyramid on the device, made once and used in each pair. ``hybrid`` compares surfaces and
# brightness, so a wall without shape or a floor without color is enough.

source = od.OdometryFrame(first.depth, camera, first.color, depth_scale=1.0)
target = od.OdometryFrame(second.depth, camera, second.color, depth_scale=1.0)
result = od.align_frames(source, target)
assert result.reliable, result.warnings
print(f"fitness {result.fitness:.2f}, inlier rmse {result.inlier_rmse * 1e3:.1f} mm, {result.iterations} iterations")
for name, method in {"both": "hybrid", "surface": "point-to-plane", "brightness": "intensity"}.items():
    tried = od.align_frames(source, target, method=method)
    angle, moved = difference(tried.transformation)
    print(f"{name:10} off by {angle:.3f} degrees, {moved:.1f} mm {tried.warnings}")
assert difference(result.transformation)[0] < 0.5 and difference(result.transformation)[1] < 15

# %%
# Two places
# ----------
#
# Frames that do not overlap give an unreliable result with a warning.

far = frames[14]
refused = od.align_frames(source, od.OdometryFrame(far.depth, camera, far.color, depth_scale=1.0))
print("warnings:", refused.warnings)
assert not refused.reliable

# %%
# Two images
# ----------
#
# ``compute_rgbd_odometry`` takes RGB-D images like Open3D's function, and its result unpacks in the same way. A pose
# graph needs the information matrix for an edge.

pair = [loom.RGBDImage(f.color, f.depth, depth_scale=1.0, depth_trunc=4.0) for f in (first, second)]
success, T, information = od.compute_rgbd_odometry(*pair, camera)
assert success and information.shape == (6, 6)
matrix = compute_odometry_information_matrix(first.depth, second.depth, camera, T, 0.03, depth_scale=1.0)
print(f"error {difference(T)[1]:.1f} mm; {matrix[5, 5]:.0f} pixels agree")
assert difference(T)[1] < 20

# %%
# Before and after
# ----------------
#
# The first frame in orange, the second in blue, from above: as if the camera had not moved, and with the motion that
# was found.

clouds = [loom.PointCloud.create_from_rgbd_image(image, camera) for image in pair]
colors = [(0.95, 0.6, 0.1), (0.1, 0.5, 0.85)]
view = loom.View.fit(clouds[1].points, direction=(0.15, 0.75, 1.0), up=(0, -1, 0), width=640, height=640)
images = []
for moved in (clouds[0], clouds[0].transform(result.transformation)):
    scene = [{"geometry": cloud, "color": color} for cloud, color in zip((moved, clouds[1]), colors, strict=False)]
    images.append(
        loom.render(
            scene, view, (640, 640), legend=[("first frame", colors[0]), ("second frame", colors[1])], point_size=2.5
        )
    )
image = np.hstack(images)
