"""
14. Robust kernels, and clouds as NumPy arrays
==============================================

Part of every scan is wrong: somebody walked by, a chair was moved, glass mirrored. One wrong pair of points can pull
ICP further than a hundred right ones hold it. You learn kernels, which keep wrong pairs from counting, and how to
change points, normals and attributes with NumPy, which you need for anything that the library has no call for.
"""

# %%
# Points are arrays
# -----------------
# ``cloud.points``, ``normals`` and ``colors`` are NumPy arrays of shape [n, 3]. They are read-only: what you compute is
# assigned, and the cloud knows that it changed.
#
# In Open3D one writes ``np.asarray(cloud.points)`` and ``o3d.utility.Vector3dVector(array)``; the first works here
# too, the second is not needed. There writing into the array changes the cloud, here it is an error:

import tempfile
from pathlib import Path

import numpy as np

import pointloom as loom

reg = loom.registration
figure = loom.datasets.object_mesh()
target = figure.sample_points_uniformly(12_000, seed=1)

try:
    target.points[0] = 0
except ValueError as error:
    print(error)
else:
    raise AssertionError("points are read-only")

raised = target.copy()
raised.points = target.points + np.array([0, 0, 0.1])
print("the copy is", (raised.get_center() - target.get_center()).round(3)[2], "m higher")
assert np.allclose(raised.points - target.points, [0, 0, 0.1], atol=1e-5)

# %%
# Attributes
# ----------
# Anything with a row a point can be kept beside the points: intensity, time, class. It goes along through selections,
# thinning and files. ``cloud.attributes`` lists them. Masks are arrays of booleans, made as in NumPy; to keep one in a
# file make integers of it, since PLY, PCD and LAS have no type for booleans, and say so.

height = target.points[:, 2]
target["height"] = height
target["part"] = (height > 0.05).astype(np.int32)
print(target.attributes)
head = target.select_by_mask(target["part"] == 1)
print(head, "of", target)
assert len(head["height"]) == len(head) and head["height"].min() > 0.05

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
loom.write_point_cloud(folder / "figure.ply", target)
again = loom.read_point_cloud(folder / "figure.ply")
assert np.allclose(again["height"], target["height"], atol=1e-6)

# %%
# Colors by a rule of your own, from 0 to 1. Here: stripes by height over the colors of the figure.

striped = target.copy()
stripes = (np.floor(height / 0.02) % 2)[:, None]
striped.colors = 0.75 * target.colors + 0.25 * stripes
view = {"front": [0.15, -1, 0.15], "up": [0, 0, 1], "zoom": 0.62}
painted = loom.render([striped, {"geometry": head.translate([0.28, 0, 0]), "color_by": "height"}], view, (960, 640))

# %%
# A spoilt scan
# -------------
# The source: the same figure, sampled anew, with noise of 1 mm, moved, and with two kinds of rubbish. Somebody's
# hand, a lump of points beside the figure, and one wing that was bent outwards by 1.5 cm.

rng = np.random.default_rng(0)
points = figure.sample_points_uniformly(12_000, seed=2).points
points = points + rng.normal(0, 0.001, points.shape)
wing = (points[:, 0] > 0.05) & (points[:, 2] < 0.03)
points = points + wing[:, None] * [0.015, 0.004, 0.0]
hand = rng.normal([0.1, -0.05, 0.0], [0.012, 0.012, 0.03], (2500, 3))
spoilt = loom.PointCloud(np.vstack([points, hand]))
is_wrong = np.concatenate([wing, np.ones(len(hand), bool)])
print(f"{is_wrong.mean():.0%} of the source is wrong")


def perturbation(degrees: float, step: tuple[float, float, float]) -> np.ndarray:
    """A turn about the vertical, and a step."""
    angle, T = np.radians(degrees), np.eye(4)
    T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    T[:3, 3] = step
    return T


away = perturbation(6.0, (0.01, -0.008, 0.006))
source, truth = spoilt.transform(away), np.linalg.inv(away)


def off(T: np.ndarray) -> tuple[float, float]:
    """How far a pose is from the true one: degrees, and millimeters in the mean over the points."""
    rest = T @ away
    angle = np.degrees(np.arccos(np.clip((np.trace(rest[:3, :3]) - 1) / 2, -1, 1)))
    moved = spoilt.points @ rest[:3, :3].T + rest[:3, 3]
    return float(angle), 1000 * float(np.linalg.norm(moved - spoilt.points, axis=1).mean())


# %%
# Kernels
# -------
# Least squares gives a pair that is twice as far four times the say. A kernel turns that down:
#
# ===================================== ====================================================
# kernel                                cost of a pair at distance r
# ===================================== ====================================================
# ``l2()``                              r^2: distant pairs dominate
# ``huber(k)``                          proportional to r beyond k
# ``cauchy(k)``, ``geman_mcclure(k)``   grows ever more slowly beyond k
# ``tukey(k)``                          constant beyond k
# ===================================== ====================================================
#
# ``k`` is a length: what is still noise. Two to three times the standard deviation of the noise is right, here 1 mm
# of noise, so 3 mm. (Of ``geman_mcclure`` alone it is the square of that length, as in Open3D.) If the noise is
# unknown, estimate it from the distances along the normals between clouds that nearly fit (below). The kernels are
# those of Open3D's ``pipelines.registration``, which has a class for each.

DISTANCE = 0.04
kernels = {
    "L2": reg.RobustKernel.l2(),
    "Huber": reg.RobustKernel.huber(0.003),
    "Cauchy": reg.RobustKernel.cauchy(0.003),
    "GM": reg.RobustKernel.geman_mcclure(0.003**2),
    "Tukey": reg.RobustKernel.tukey(0.003),
}
rules = reg.ICPConvergenceCriteria(max_iteration=100)
start = reg.registration_icp(source, target, DISTANCE, np.eye(4), reg.TransformationEstimation.point_to_plane(), rules)
ends = {}
for name, kernel in kernels.items():
    method = reg.TransformationEstimation.point_to_plane(kernel)
    result = reg.registration_icp(source, target, DISTANCE, start.transformation, method, rules)
    ends[name] = off(result.transformation)
    print(f"{name:7} {ends[name][0]:5.2f} degrees, {ends[name][1]:5.2f} mm off; fitness {result.fitness:.2f}")

assert ends["Tukey"][1] < 0.5 * ends["L2"][1]
assert ends["Cauchy"][1] < ends["L2"][1] and ends["GM"][1] < ends["L2"][1]

# %%
# Fitness is the same for all: it does not see this. What does is where the distances are. With a kernel the right
# points lie on the surface and the wrong ones stand out; with least squares everything is a bit wrong.

best = reg.registration_icp(
    source, target, DISTANCE, start.transformation, reg.TransformationEstimation.point_to_plane(kernels["Tukey"]), rules
)
panels = {}
for k, (name, T) in enumerate({"L2": start.transformation, "Tukey": best.transformation}.items()):
    panel = source.transform(T)
    panel["apart"] = panel.compute_point_cloud_distance(target) * 1000
    fraction = float((panel["apart"][~is_wrong] < 3).mean())
    print(f"{name}: {fraction:.0%} of the good points lie within 3 mm of the target")
    panels[name] = panel.translate([0.3 * k, 0, 0])
errors = loom.render(
    [{"geometry": panel, "color_by": "apart", "limits": (0.0, 15.0), "colormap": "turbo"} for panel in panels.values()],
    view, (960, 640), color_bar=True,
    labels=[("L2", np.array([0, 0, -0.19])), ("Tukey", np.array([0.3, 0, -0.19]))],
)  # fmt: skip

# %%
# How large is k?
# ---------------
# Too small, and right pairs do not count either, so that ICP stays where it is; too large, and it is L2 again. A good
# way down is to begin with a large k, and end with three times the noise (below).

for k in (0.0001, 0.001, 0.003, 0.01, 0.1):
    method = reg.TransformationEstimation.point_to_plane(reg.RobustKernel.tukey(k))
    result = reg.registration_icp(source, target, DISTANCE, start.transformation, method, rules)
    print(f"Tukey with k {k * 1000:6.1f} mm: {off(result.transformation)[1]:5.2f} mm off")

# %%
# The median of the distances, times 1.48, is the standard deviation of the noise as long as less than half is
# rubbish. Take the distances **along the target's normals**, which is what point to plane looks at: from point to
# point they hold the spacing of the target's points as well, and are three to four times too large where points are
# sparse. (A third of rubbish makes it somewhat too large still: the noise is 1 mm.)

tree = loom.NearestNeighborSearch(target)


def noise(T: np.ndarray) -> float:
    """The standard deviation of the distances along the normals [m], by their median."""
    p = source.transform(T).points
    i = tree.knn_search(p, 1).indices[:, 0]
    return 1.48 * float(np.median(np.abs(((p - target.points[i]) * target.normals[i]).sum(1))))


apart = 1.48 * float(np.median(source.transform(best.transformation).compute_point_cloud_distance(target)))
print(f"noise along the normals {1000 * noise(best.transformation):.1f} mm, from point to point {1000 * apart:.1f} mm")
assert 0.0005 < noise(best.transformation) < 0.002 < apart

# %%
# Before the fit is good the distances hold its error: after least squares they give a large k. That is the way down:
# fit with it, measure again, until k stays.

T = start.transformation
for _ in range(4):
    k = 3 * noise(T)
    method = reg.TransformationEstimation.point_to_plane(reg.RobustKernel.tukey(k))
    T = reg.registration_icp(source, target, DISTANCE, T, method, rules).transformation
    print(f"k {1000 * k:4.1f} mm: {off(T)[1]:.2f} mm off")
assert off(T)[1] < 0.5 and k < 0.008

# %%
# Normals as arrays
# -----------------
# To turn normals inside out is one line. (``cloud.flip_normals()`` does the same.)

inward = target.copy()
inward.normals = -target.normals
assert np.allclose(inward.normals, target.flip_normals().normals)

# %%
# Both results to turn:

with loom.record(folder / "robust.html", automatic=False, title="L2, then Tukey: distance in mm") as recording:
    recording.add("target", target, color=(0.75, 0.75, 0.78))
    recording.add("source", panels["L2"], color_by="apart", limits=(0.0, 15.0), colormap="turbo")
    recording.step("L2")
    recording.update(
        "source", panels["Tukey"].translate([-0.3, 0, 0]), color_by="apart", limits=(0.0, 15.0), colormap="turbo"
    )
    recording.step("Tukey")
page = folder / "robust.html"

# %%
# What goes wrong
# ---------------
# **Three rows of n for n rows of three**, and colors up to 255: both are refused, with the mend.

for wrong in (
    lambda: loom.PointCloud(target.points.T),
    lambda: loom.PointCloud(target.points, colors=target.colors * 255),
):
    try:
        wrong()
    except ValueError as error:
        print(error)
    else:
        raise AssertionError("accepted")

# %%
# **A kernel for point to point** works too, as ``TransformationEstimation.point_to_point(with_scaling=False,
# kernel=...)``. There the distance is from point to point and holds the spacing: k must be well above the spacing of
# the points, or right pairs do not count.

spacing = float(np.median(target.compute_nearest_neighbor_distance()))
ends = {}
for k in (1.5 * spacing, 5 * spacing):
    method = reg.TransformationEstimation.point_to_point(with_scaling=False, kernel=reg.RobustKernel.tukey(k))
    T = reg.registration_icp(source, target, DISTANCE, start.transformation, method, rules).transformation
    ends[k] = off(T)[1]
    print(f"point to point, k {1000 * k:.1f} mm, {k / spacing:.1f} spacings: {ends[k]:.2f} mm off")
assert ends[5 * spacing] < 1 < ends[1.5 * spacing]

# %%
# Try it
# ------
# - Let the hand be as large as the figure. Which kernel fails first?
# - ``overlap=None`` in ``registration_icp`` drops the worst pairs in place of a kernel. Which is better here?
#
# Where to go next
# ----------------
# :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>` puts many frames together. The page
# :doc:`Arrays come back as they came </arrays>` has torch, cupy and jax in place of NumPy.
