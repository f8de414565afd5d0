"""
14. Robust kernels and NumPy arrays
===================================

Parts of a scan may be wrong: moving people, displaced objects, reflections. In least squares, a single wrong
correspondence can have more influence than a hundred correct ones. In this chapter you use robust kernels, which limit
this influence. You also modify points, normals and attributes with NumPy, for operations that the library does not
have.
"""

# %%
# Points as arrays
# ----------------
# ``cloud.points``, ``normals`` and ``colors`` are NumPy arrays of shape ``(n, 3)``. They are read-only. Assign a new
# array to change them.
#
# In Open3D, use ``np.asarray(cloud.points)`` and ``o3d.utility.Vector3dVector(array)``. The former works here, too, and
# the latter is not needed. Writing to the array changes the cloud in Open3D. Here it raises an error:

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
# Attributes store one value per point, for example intensity, time or class. Selections, downsampling and files
# preserve them. ``cloud.attributes`` lists them. A mask is a boolean array. PLY, PCD and LAS have no boolean type, so
# convert a mask to integers before writing. Otherwise an error is raised.

height = target.points[:, 2]
target["height"] = height
target["part"] = (height > 0.05).astype(np.int32)
print(target.attributes)
head = target.select_by_mask(target["part"] == 1)
print(head, "of", target)
assert len(head["height"]) == len(head) and head["height"].min() > 0.05

folder = Path(tempfile.mkdtemp(prefix="pointloom-"))
loom.write_point_cloud(folder / "figure.ply", target)
read_back = loom.read_point_cloud(folder / "figure.ply")
assert np.allclose(read_back["height"], target["height"], atol=1e-6)

# %%
# Colors can be computed by any rule, with values from 0 to 1. This one adds stripes by height.

striped = target.copy()
stripes = (np.floor(height / 0.02) % 2)[:, None]
striped.colors = 0.75 * target.colors + 0.25 * stripes
view = {"front": [0.15, -1, 0.15], "up": [0, 0, 1], "zoom": 0.62}
painted = loom.render([striped, {"geometry": head.translate([0.28, 0, 0]), "color_by": "height"}], view, (960, 640))

# %%
# A scan with wrong parts
# -----------------------
# The source is another sample of the same object with noise of 1 mm and a different pose. It has two wrong parts: a
# group of points next to the object, and one wing that is displaced by 1.5 cm.

rng = np.random.default_rng(0)
points = figure.sample_points_uniformly(12_000, seed=2).points
points = points + rng.normal(0, 0.001, points.shape)
wing = (points[:, 0] > 0.05) & (points[:, 2] < 0.03)
points = points + wing[:, None] * [0.015, 0.004, 0.0]
extra_points = rng.normal([0.1, -0.05, 0.0], [0.012, 0.012, 0.03], (2500, 3))
corrupted = loom.PointCloud(np.vstack([points, extra_points]))
is_wrong = np.concatenate([wing, np.ones(len(extra_points), bool)])
print(f"{is_wrong.mean():.0%} of the source is wrong")


def perturbation(degrees: float, step: tuple[float, float, float]) -> np.ndarray:
    """A rotation about the vertical axis, and a translation."""
    angle, T = np.radians(degrees), np.eye(4)
    T[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    T[:3, 3] = step
    return T


initial_motion = perturbation(6.0, (0.01, -0.008, 0.006))
source, truth = corrupted.transform(initial_motion), np.linalg.inv(initial_motion)


def pose_error(T: np.ndarray) -> tuple[float, float]:
    """Error of a pose: rotation [degrees], and mean displacement of the points [mm]."""
    residual = T @ initial_motion
    angle = np.degrees(np.arccos(np.clip((np.trace(residual[:3, :3]) - 1) / 2, -1, 1)))
    moved = corrupted.points @ residual[:3, :3].T + residual[:3, 3]
    return float(angle), 1000 * float(np.linalg.norm(moved - corrupted.points, axis=1).mean())


# %%
# Robust kernels
# --------------
# In least squares, the cost of a correspondence is proportional to its squared distance. A robust kernel limits the
# cost:
#
# ===================================== ====================================================
# kernel                                cost of a correspondence at distance r
# ===================================== ====================================================
# ``L2Loss()``                          r^2: distant pairs dominate
# ``HuberLoss(k)``                      proportional to r beyond k
# ``CauchyLoss(k)``, ``GMLoss(k)``      increases more and more slowly beyond k
# ``TukeyLoss(k)``                      constant beyond k
# ===================================== ====================================================
#
# ``k`` is the largest distance that is still considered noise, two to three times its standard deviation. Here the
# noise is 1 mm, so k is 3 mm. For ``GMLoss``, k is the square of this distance, as in Open3D. If the noise is
# unknown, estimate it from the distances along the normals, as below. The kernels are those of Open3D's
# ``pipelines.registration``.

DISTANCE = 0.04
kernels = {
    "L2": reg.L2Loss(),
    "Huber": reg.HuberLoss(0.003),
    "Cauchy": reg.CauchyLoss(0.003),
    "GM": reg.GMLoss(0.003**2),
    "Tukey": reg.TukeyLoss(0.003),
}
rules = reg.ICPConvergenceCriteria(max_iteration=100)
start = reg.registration_icp(source, target, DISTANCE, np.eye(4), reg.TransformationEstimationPointToPlane(), rules)
pose_errors = {}
for name, kernel in kernels.items():
    method = reg.TransformationEstimationPointToPlane(kernel)
    result = reg.registration_icp(source, target, DISTANCE, start.transformation, method, rules)
    pose_errors[name] = pose_error(result.transformation)
    print(f"{name:7} {pose_errors[name][0]:5.2f} degrees, {pose_errors[name][1]:5.2f} mm; fitness {result.fitness:.2f}")

assert pose_errors["Tukey"][1] < 0.5 * pose_errors["L2"][1]
assert pose_errors["Cauchy"][1] < pose_errors["L2"][1] and pose_errors["GM"][1] < pose_errors["L2"][1]

# %%
# The fitness does not show the difference: it is highest for least squares, the least accurate pose. The distribution
# of distances does. With a kernel, the correct points are on the surface and the wrong points have large distances.
# With least squares, all points have an error.

best = reg.registration_icp(
    source, target, DISTANCE, start.transformation, reg.TransformationEstimationPointToPlane(kernels["Tukey"]), rules
)
panels = {}
for k, (name, T) in enumerate({"L2": start.transformation, "Tukey": best.transformation}.items()):
    panel = source.transform(T)
    panel["distance"] = panel.compute_point_cloud_distance(target) * 1000
    fraction = float((panel["distance"][~is_wrong] < 3).mean())
    print(f"{name}: {fraction:.0%} of the correct points are within 3 mm of the target")
    panels[name] = panel.translate([0.3 * k, 0, 0])
errors = loom.render(
    [{"geometry": panel, "color_by": "distance", "limits": (0.0, 15.0), "colormap": "turbo"}
     for panel in panels.values()],
    view, (960, 640), color_bar=True,
    labels=[("L2", np.array([0, 0, -0.19])), ("Tukey", np.array([0.3, 0, -0.19]))],
)  # fmt: skip

# %%
# Choose k
# --------
# If k is too small, correct correspondences have no influence, and ICP does not move. If it is too large, the result is
# that of least squares. Begin with a large k and decrease it to three times the noise.

for k in (0.0001, 0.001, 0.003, 0.01, 0.1):
    method = reg.TransformationEstimationPointToPlane(reg.TukeyLoss(k))
    result = reg.registration_icp(source, target, DISTANCE, start.transformation, method, rules)
    print(f"Tukey with k {k * 1000:6.1f} mm: error {pose_error(result.transformation)[1]:5.2f} mm")

# %%
# The median distance times 1.48 is the standard deviation of the noise, if less than half of the points are wrong. Use
# the distances **along the normals of the target**, as in point-to-plane ICP. Distances between points also contain the
# point spacing. With sparse points they are three to four times too large. Here a third of the points is wrong, so the
# estimate is slightly larger than the true noise of 1 mm.

search = loom.NearestNeighborSearch(target)


def noise(T: np.ndarray) -> float:
    """Robust standard deviation [m] of the distances along the normals."""
    p = source.transform(T).points
    i = search.knn_search(p, 1).indices[:, 0]
    return 1.48 * float(np.median(np.abs(((p - target.points[i]) * target.normals[i]).sum(1))))


point_to_point_noise = 1.48 * float(
    np.median(source.transform(best.transformation).compute_point_cloud_distance(target))
)
print(
    f"noise along the normals {1000 * noise(best.transformation):.1f} mm, "
    f"from point to point {1000 * point_to_point_noise:.1f} mm"
)
assert 0.0005 < noise(best.transformation) < 0.002 < point_to_point_noise

# %%
# The distances also contain the error of the pose, so the first estimate of k is too large. Repeat the registration and
# the estimate until k is constant:

T = start.transformation
for _ in range(4):
    k = 3 * noise(T)
    method = reg.TransformationEstimationPointToPlane(reg.TukeyLoss(k))
    T = reg.registration_icp(source, target, DISTANCE, T, method, rules).transformation
    print(f"k {1000 * k:4.1f} mm: error {pose_error(T)[1]:.2f} mm")
assert pose_error(T)[1] < 0.5 and k < 0.008

# %%
# Modify normals
# --------------
# One line inverts all normals. ``cloud.flip_normals()`` does the same.

inward = target.copy()
inward.normals = -target.normals
assert np.allclose(inward.normals, target.flip_normals().normals)

# %%
# Both results as an interactive page:

with loom.record(folder / "robust.html", automatic=False, title="L2, then Tukey: distance in mm") as recording:
    recording.add("target", target, color=(0.75, 0.75, 0.78))
    recording.add("source", panels["L2"], color_by="distance", limits=(0.0, 15.0), colormap="turbo")
    recording.step("L2")
    recording.update(
        "source", panels["Tukey"].translate([-0.3, 0, 0]), color_by="distance", limits=(0.0, 15.0), colormap="turbo"
    )
    recording.step("Tukey")
page = folder / "robust.html"

# %%
# Common mistakes
# ---------------
# **Transposed points** and **colors up to 255** raise an error that contains the correction:

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
# **A kernel for point-to-point ICP** is available as ``TransformationEstimationPointToPoint(with_scaling=False,
# kernel=...)``. Its distances contain the point spacing, so k must be larger than the spacing. Otherwise correct
# correspondences have no influence.

spacing = float(np.median(target.compute_nearest_neighbor_distance()))
pose_errors = {}
for k in (1.5 * spacing, 5 * spacing):
    method = reg.TransformationEstimationPointToPoint(with_scaling=False, kernel=reg.TukeyLoss(k))
    T = reg.registration_icp(source, target, DISTANCE, start.transformation, method, rules).transformation
    pose_errors[k] = pose_error(T)[1]
    print(f"point to point, k {1000 * k:.1f} mm, {k / spacing:.1f} spacings: error {pose_errors[k]:.2f} mm")
assert pose_errors[5 * spacing] < 1 < pose_errors[1.5 * spacing]

# %%
# What to change
# --------------
# - The size of the group of wrong points [m]: increase it to the size of the object. Which kernel fails first?
# - ``k`` [m]: 0.001 is too small, 0.1 is equivalent to least squares.
# - ``overlap=None`` in ``registration_icp``: removes the worst correspondences instead of using a kernel. Which is more
#   accurate here?
#
# Next
# ----
# - :ref:`Chapter 15 <sphx_glr_chapters_plot_15_frames_to_a_model.py>`: models from many frames.
# - :doc:`Array libraries </arrays>`: PyTorch, CuPy and JAX instead of NumPy.
