"""
10. Colored ICP
================

A flat floor slides under ICP: its shape does not say where along itself it lies. Its pattern does. Colored ICP uses
both, from coarse to fine. You learn when it is worth it, how to set its scales, and when colors mislead.
"""

# %%
# Where shape is not enough
# -------------------------
# Two scans of a rug, one of them turned by 3 degrees and pushed along the floor. Only what lies below 3 cm of height is
# kept, so that there is nothing but the pattern to tell where it lies.

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
    """A turn about the vertical through the middle of the rug, and a step."""
    angle, middle = np.radians(degrees), np.asarray(rug.get_center())
    T = np.eye(4)
    T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    T[:3, 3] = middle - T[:3, :3] @ middle + step
    return T


def off(T: np.ndarray, truth: np.ndarray) -> tuple[float, float]:
    """How far a pose is from the true one at the rug: degrees and millimeters."""
    rest = np.linalg.inv(truth) @ T
    middle = np.append(source.get_center(), 1)
    angle = np.degrees(np.arccos(np.clip((np.trace(rest[:3, :3]) - 1) / 2, -1, 1)))
    return float(angle), 1000 * float(np.linalg.norm((rest @ middle - middle)[:3]))


away = perturbation(3.0, (0.05, -0.04, 0.02))
source = source.transform(away)
truth = np.linalg.inv(away)
print(source, target)
print("the start is {:.1f} degrees and {:.0f} mm off".format(*off(np.eye(4), truth)))

view = {"front": [0.25, -0.5, 0.85], "up": [0, 0, 1], "zoom": 0.55}
before = loom.render([source, target], view, (960, 640))

# %%
# Shape alone
# -----------
# Point to plane brings the two sheets onto one height and stops. It reports that three motions (two translations
# and a rotation) are not determined.

shape = reg.registration_icp(source, target, 0.06, np.eye(4), reg.TransformationEstimation.point_to_plane())
print(shape)
print("not determined:", len(shape.degenerate_directions), "of 6 motions")
print("off by {:.2f} degrees and {:.0f} mm".format(*off(shape.transformation, truth)))
assert len(shape.degenerate_directions) == 3
assert off(shape.transformation, truth)[1] > 30

# %%
# Shape and color, from coarse to fine
# -------------------------------------
# Colored ICP asks for each pair: how far off is the plane, and how far off is the color, if the source is moved
# along the plane by the slope of the colors there? ``lambda_geometric`` weighs the two: 0.968, Open3D's default, is
# nearly all shape; it leaves the motions to color that shape does not determine.
#
# Colors have a slope over a short way only, so it goes by scales: large voxels blur the pattern and reach far, small
# ones are exact. The first distance has to be about the error of the start (here some 7 cm: 8 cm), the last one or two
# spacings of the points (here some 2 cm of either half of the rug). Between them halve; the voxel is the distance;
# normals by two voxels. It is the loop of Open3D's tutorial:

T = np.eye(4)
for voxel_size, iterations in ((0.08, 50), (0.04, 30), (0.02, 20)):
    thin = [
        cloud.voxel_down_sample(voxel_size).estimate_normals(radius=2 * voxel_size, max_nn=30)
        for cloud in (source, target)
    ]
    result = reg.registration_icp(
        *thin, voxel_size, T, reg.TransformationEstimation.colored(lambda_geometric=0.968),
        reg.ICPConvergenceCriteria(relative_fitness=1e-6, relative_rmse=1e-6, max_iteration=iterations),
    )  # fmt: skip
    T = result.transformation
    print(f"voxel {voxel_size} m: {result.iterations:2} iterations, off by {off(T, truth)[0]:.2f} degrees,"
          f" {off(T, truth)[1]:.0f} mm")  # fmt: skip

assert off(T, truth)[0] < 0.5 and off(T, truth)[1] < 8

# %%
# After: the squares of one lie on the squares of the other.

after = loom.render([source.transform(T), target], view, (960, 640))

# %%
# The same loop is one call. ``estimate_normals=True`` makes the normals of each scale.

rules = [reg.ICPConvergenceCriteria(max_iteration=count) for count in (50, 30, 20)]
at_once = reg.multi_scale_icp(
    source.without("normals"), target.without("normals"), [0.08, 0.04, 0.02], rules, [0.08, 0.04, 0.02], np.eye(4),
    reg.TransformationEstimation.colored(), estimate_normals=True,
)  # fmt: skip
print("multi_scale_icp: off by {:.2f} degrees and {:.0f} mm".format(*off(at_once.transformation, truth)))
assert off(at_once.transformation, truth)[1] < 10

# %%
# How far does it reach?
# ----------------------
# The squares of the rug repeat every 37 cm. Begin nearer to the next red square than to the right one, and the wrong
# squares meet. Patterns that repeat are for colors what a wall is for shape. Only the fraction of points that find a
# partner tells, since a part of the rug now hangs over the edge.

ends, fractions = {}, {}
for push in (0.05, 0.1, 0.3, 0.7):
    tried = reg.multi_scale_icp(
        source.without("normals"), target.without("normals"), [0.08, 0.04, 0.02], rules, [0.08, 0.04, 0.02],
        truth @ perturbation(0, (0, push, 0)), reg.TransformationEstimation.colored(), estimate_normals=True,
    )  # fmt: skip
    ends[push], fractions[push] = off(tried.transformation, truth)[1], tried.fitness
    print(f"from {push * 100:2.0f} cm off it ends {ends[push] / 10:5.1f} cm off, fitness {tried.fitness:.2f}")
assert ends[0.1] < 10 and ends[0.3] > 300
assert fractions[0.3] < fractions[0.1] - 0.1

# %%
# The steps to watch:

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
with loom.record(folder / "colors.html", automatic=False, max_points=60_000, title="Colored ICP") as recording:
    recording.add("target", target)
    recording.add("source", source)
    T = np.eye(4)
    recording.step("as it lay")
    for voxel_size in (0.08, 0.04, 0.02):
        thin = [
            cloud.voxel_down_sample(voxel_size).estimate_normals(radius=2 * voxel_size, max_nn=30)
            for cloud in (source, target)
        ]
        by_color = reg.TransformationEstimation.colored()
        for count in range(8):
            one = reg.ICPConvergenceCriteria(max_iteration=3)
            T = reg.registration_icp(*thin, voxel_size, T, by_color, one).transformation
            recording.set_pose("source", T)
            recording.plot("off the truth [mm]", off(T, truth)[1])
            recording.step(f"voxels of {voxel_size} m, step {3 * (count + 1)}")
page = folder / "colors.html"

# %%
# What goes wrong
# ---------------
# **No colors**, or no normals: an error says which, and what makes them.

try:
    bare, method = source.without("colors"), reg.TransformationEstimation.colored()
    reg.registration_icp(bare, target, 0.05, None, method)
except ValueError as error:
    message = str(error)
    print(message)
assert "color" in message

# %%
# **Colors from 0 to 255.** They are 0 to 1 here. Arrays of uint8 are taken and scaled; floats from 0 to 255 are
# refused, so divide them: ``loom.PointCloud(points, colors=values / 255)``.

eight_bits = (source.colors * 255).round().astype(np.uint8)
assert abs(loom.PointCloud(source.points, colors=eight_bits).colors - source.colors).max() < 0.005
try:
    loom.PointCloud(source.points, colors=eight_bits.astype(np.float64))
except ValueError as error:
    message = str(error)
    print(message)
assert "255" in message

# %%
# **Another light.** One scan by day and one by lamp differ in color where nothing moved. Then colors mislead, and
# fitness does not tell, as it knows distances alone. Compare with ``lambda_geometric=1.0``: where shape fixes the pose
# both should end alike. Or bring the colors of one to the mean and the spread of the other's, channel by channel,
# before you begin.
#
# **Is it right?** Without a truth, as in life: look at the pattern where the two meet (as above); begin from a few
# other starts, a little off, and see whether they end at one pose; and where shape leaves motions open
# (``degenerate_directions`` of shape alone), trust the colors only if the pattern does not repeat.
#
# Try it
# ------
# - ``lambda_geometric=1.0`` is shape alone, 0.5 trusts colors more. Which one is best here?
# - Do the same with two frames of the walk (chapter 7). Is colored ICP any better where there is furniture?
#
# Where to go next
# ----------------
# :ref:`Chapter 13 <sphx_glr_chapters_plot_13_rgbd_odometry.py>` does the same with the images themselves, frame after
# frame. The page :doc:`Registration </registration>` compares all kinds of ICP.
