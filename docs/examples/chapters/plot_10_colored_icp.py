"""
10. Colored ICP
===============

On a planar surface, ICP cannot determine the translation along the surface. The color pattern can. Colored ICP combines
geometry and color, from coarse to fine scales. In this chapter you apply it, choose its scales, and learn when color is
misleading.
"""

# %%
# A scene where geometry is insufficient
# --------------------------------------
# The data consists of two scans of a rug. One of them is rotated by 3 degrees and translated along the floor. Points
# above 3 cm are removed, so only the color pattern determines the position along the floor.

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
room = loom.datasets.room_cloud(voxel_size=0.015)
rug = room.crop(loom.AxisAlignedBoundingBox([1.2, 1.05, -0.05], [2.4, 2.9, 0.03]))
is_target = np.random.default_rng(0).random(len(rug)) < 0.5  # no point of one cloud is in the other
target, source = rug.select_by_mask(is_target), rug.select_by_mask(~is_target)


def perturbation(degrees: float, step: tuple[float, float, float]) -> np.ndarray:
    """A rotation about the vertical axis through the center of the rug, and a translation."""
    angle, center = np.radians(degrees), np.asarray(rug.get_center())
    T = np.eye(4)
    T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    T[:3, 3] = center - T[:3, :3] @ center + step
    return T


def pose_error(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """Error of a pose at the center of the rug: rotation [degrees] and translation [mm]."""
    residual = np.linalg.inv(truth) @ T
    center = np.append(source.get_center(), 1)
    angle = np.degrees(np.arccos(np.clip((np.trace(residual[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), 1000 * float(np.linalg.norm((residual @ center - center)[:3]))


initial_motion = perturbation(3.0, (0.05, -0.04, 0.02))
source = source.transform(initial_motion)
truth = np.linalg.inv(initial_motion)
print(source, target)
print("initial error: {:.1f} degrees and {:.0f} mm".format(*pose_error(np.eye(4), truth)))

view = {"front": [0.25, -0.5, 0.85], "up": [0, 0, 1], "zoom": 0.55}
before = loom.render([source, target], view, (960, 640))

# %%
# Geometry only
# -------------
# Point-to-plane ICP aligns the height of the two planes. It reports that three motions are not determined: two
# translations and one rotation.

shape = reg.registration_icp(source, target, 0.06, np.eye(4), reg.TransformationEstimationPointToPlane())
print(shape)
print("undetermined:", len(shape.degenerate_directions), "of 6 motions")
print("error: {:.2f} degrees and {:.0f} mm".format(*pose_error(shape.transformation, truth)))
assert len(shape.degenerate_directions) == 3
assert pose_error(shape.transformation, truth)[1] > 30

# %%
# Geometry and color, from coarse to fine
# ---------------------------------------
# Colored ICP minimizes two residuals for each correspondence: the distance from the tangent plane, and the difference
# of color. The color of the target is extrapolated along the plane with its gradient. ``lambda_geometric`` is the
# weight of the geometry. With 0.968, Open3D's default, color mostly determines the motions that the geometry does not
# determine.
#
# A color gradient is only valid over a short distance, so the registration uses several scales. Large voxels blur the
# pattern and have a larger convergence range. Small voxels are more accurate. The first correspondence distance should
# be about the initial error (here 7 cm, so 8 cm is used), the last one one to two point spacings (here 2 cm). Halve it
# in between. Use the distance as the voxel size, and two voxels as the radius of the normals. This is the loop of
# Open3D's tutorial:

T = np.eye(4)
for voxel_size, iterations in ((0.08, 50), (0.04, 30), (0.02, 20)):
    thin = [
        cloud.voxel_down_sample(voxel_size).estimate_normals(radius=2 * voxel_size, max_nn=30)
        for cloud in (source, target)
    ]
    result = reg.registration_icp(
        *thin, voxel_size, T, reg.TransformationEstimationForColoredICP(lambda_geometric=0.968),
        reg.ICPConvergenceCriteria(relative_fitness=1e-6, relative_rmse=1e-6, max_iteration=iterations),
    )  # fmt: skip
    T = result.transformation
    print(f"voxel {voxel_size} m: {result.iterations:2} iterations, error {pose_error(T, truth)[0]:.2f} degrees,"
          f" {pose_error(T, truth)[1]:.0f} mm")  # fmt: skip

assert pose_error(T, truth)[0] < 0.5 and pose_error(T, truth)[1] < 8

# %%
# The result: the patterns of both scans coincide.

after = loom.render([source.transform(T), target], view, (960, 640))

# %%
# The same loop in one call. ``estimate_normals=True`` estimates the normals of each scale.

rules = [reg.ICPConvergenceCriteria(max_iteration=count) for count in (50, 30, 20)]
at_once = reg.multi_scale_icp(
    source.without("normals"), target.without("normals"), [0.08, 0.04, 0.02], rules, [0.08, 0.04, 0.02], np.eye(4),
    reg.TransformationEstimationForColoredICP(), estimate_normals=True,
)  # fmt: skip
print("multi_scale_icp: error {:.2f} degrees and {:.0f} mm".format(*pose_error(at_once.transformation, truth)))
assert pose_error(at_once.transformation, truth)[1] < 10

# %%
# Convergence range
# -----------------
# The pattern of the rug repeats every 37 cm. If the initial pose is closer to the next repetition, ICP converges to a
# wrong pose. A repetitive pattern has the same effect on color as a plane has on geometry. Only the fitness is lower,
# since a part of the rug has no correspondence.

errors, fractions = {}, {}
for shift in (0.05, 0.1, 0.3, 0.7):
    trial = reg.multi_scale_icp(
        source.without("normals"), target.without("normals"), [0.08, 0.04, 0.02], rules, [0.08, 0.04, 0.02],
        truth @ perturbation(0, (0, shift, 0)), reg.TransformationEstimationForColoredICP(), estimate_normals=True,
    )  # fmt: skip
    errors[shift], fractions[shift] = pose_error(trial.transformation, truth)[1], trial.fitness
    print(f"initial error {shift * 100:2.0f} cm, final error {errors[shift] / 10:5.1f} cm, fitness {trial.fitness:.2f}")
assert errors[0.1] < 10 and errors[0.3] > 300
assert fractions[0.3] < fractions[0.1] - 0.1

# %%
# A recording of the iterations:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "colors.html", automatic=False, max_points=60_000, title="Colored ICP") as recording:
    recording.add("target", target)
    recording.add("source", source)
    T = np.eye(4)
    recording.step("initial pose")
    for voxel_size in (0.08, 0.04, 0.02):
        thin = [
            cloud.voxel_down_sample(voxel_size).estimate_normals(radius=2 * voxel_size, max_nn=30)
            for cloud in (source, target)
        ]
        by_color = reg.TransformationEstimationForColoredICP()
        for count in range(8):
            one = reg.ICPConvergenceCriteria(max_iteration=3)
            T = reg.registration_icp(*thin, voxel_size, T, by_color, one).transformation
            recording.set_pose("source", T)
            recording.plot("error [mm]", pose_error(T, truth)[1])
            recording.step(f"voxels of {voxel_size} m, step {3 * (count + 1)}")
page = folder / "colors.html"

# %%
# Common mistakes
# ---------------
# **Missing colors** or normals raise an error that names them:

try:
    bare, method = source.without("colors"), reg.TransformationEstimationForColoredICP()
    reg.registration_icp(bare, target, 0.05, None, method)
except ValueError as error:
    message = str(error)
    print(message)
assert "color" in message

# %%
# **Colors from 0 to 255.** Colors range from 0 to 1. Arrays of uint8 are scaled automatically. Float arrays with values
# up to 255 raise an error. Divide them: ``loom.PointCloud(points, colors=values / 255)``.

eight_bits = (source.colors * 255).round().astype(np.uint8)
assert abs(loom.PointCloud(source.points, colors=eight_bits).colors - source.colors).max() < 0.005
try:
    loom.PointCloud(source.points, colors=eight_bits.astype(np.float64))
except ValueError as error:
    message = str(error)
    print(message)
assert "255" in message

# %%
# **Different illumination.** If one scan was taken by day and the other one with artificial light, colors differ
# without motion, and colored ICP may be wrong. The fitness does not detect this, since it only measures distances.
# Compare the result with ``lambda_geometric=1.0``: where the geometry determines the pose, both should agree.
# Alternatively, adjust mean and variance of each color channel of one scan to the other before the registration.
#
# **Check without ground truth.** Inspect the pattern in the overlap, as above. Repeat the registration from several
# initial poses, and check that the results agree. If the geometry alone has ``degenerate_directions``, trust the result
# only if the pattern is not repetitive.
#
# What to change
# --------------
# - ``lambda_geometric``: 1.0 uses geometry only, 0.5 gives color more weight. Which one is the most accurate here?
# - The first distance [m]: 0.16 instead of 0.08 tolerates a larger initial error.
# - The data: register two frames of chapter 7. Does color improve the result if the scene has furniture?
#
# Next
# ----
# - :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>`: registration of images, frame by frame.
# - :doc:`Registration </registration>`: comparison of all variants of ICP.
