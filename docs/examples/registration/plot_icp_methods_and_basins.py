"""
ICP methods and their convergence range
=======================================

ICP refines an approximate pose. Its residual determines the accuracy and the convergence range. On this page you
compare five methods from initial errors of 0 to 120 degrees with a known true pose.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two scans of an object
# ----------------------
# Source and target are disjoint halves of the same point set, with noise of 0.6 mm. No point is in both.
rng = np.random.default_rng(0)
mesh = loom.datasets.object_mesh()
cloud = mesh.sample_points_uniformly(12_000, seed=2)
size = float(np.linalg.norm(cloud.get_max_bound() - cloud.get_min_bound()))
noise = rng.normal(scale=0.0015 * size, size=(12_000, 3))
cloud = loom.PointCloud(cloud.points + noise, colors=cloud.colors)
is_target = np.arange(12_000) % 2 == 0
target = cloud.select_by_mask(is_target).estimate_normals(max_nn=20).orient_normals_consistent_tangent_plane(12)
source = cloud.select_by_mask(~is_target).estimate_normals(max_nn=20).orient_normals_consistent_tangent_plane(12)
print(f"{len(source)} and {len(target)} points, {100 * size:.1f} cm across")


def perturbed(degrees, axis):
    """Initial pose T_target_source: a rotation about the center."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    T = np.eye(4)
    T[:3, :3] = np.eye(3) + s * K + (1 - c) * K @ K
    T[:3, 3] = cloud.get_center() - T[:3, :3] @ cloud.get_center()
    return T


def pose_error(T):
    """Error of a pose, where the true pose is the identity: rotation [degrees], translation at the center [m]."""
    angle = np.degrees(2 * np.arcsin(min(np.linalg.norm(T[:3, :3] - np.eye(3)) / np.sqrt(8), 1)))
    return angle, np.linalg.norm((T @ np.r_[cloud.get_center(), 1])[:3] - cloud.get_center())


# %%
# Methods
# -------
# Point-to-plane ICP lets surfaces slide along each other and needs few iterations. Generalized ICP compares local
# surfaces of both clouds. Symmetric ICP is suitable for curved surfaces. Colored ICP helps if the geometry does not
# determine all motions.
methods = {
    "point to point": reg.TransformationEstimationPointToPoint(),
    "point to plane": reg.TransformationEstimationPointToPlane(),
    "generalized": reg.TransformationEstimationForGeneralizedICP(),
    "symmetric": reg.TransformationEstimationSymmetric(),
    "colored": reg.TransformationEstimationForColoredICP(),
}
distance = 0.15 * size  # maximum distance of a pair [m]: a larger value extends the range and reduces the accuracy
angles = np.array([0, 20, 40, 60, 90, 120])
axes = rng.normal(size=(4, 3))
axes /= np.linalg.norm(axes, axis=1, keepdims=True)
inits = np.array([perturbed(angle, axis) for angle in angles for axis in axes])

# %%
# Convergence range
# -----------------
# All initial poses of a method run in one batch. A run succeeds if its final error is below 1 degree.
criteria = reg.ICPConvergenceCriteria(max_iteration=40)
success_rate, steps, accuracy = {}, {}, {}
for name, method in methods.items():
    results = reg.registration_icp_batch(source, target, distance, inits, method, criteria)
    errors = np.array([pose_error(result.transformation) for result in results])
    success = errors[:, 0] < 1.0
    success_rate[name] = success.reshape(len(angles), len(axes)).mean(axis=1)
    steps[name] = np.median([result.iterations for result, good in zip(results, success, strict=True) if good])
    accuracy[name] = np.median(errors[success], axis=0)
    print(
        f"{name:15} {accuracy[name][0]:.3f} degrees, {1000 * accuracy[name][1]:.3f} mm, {steps[name]:3.0f} iterations; "
        "success from "
        + " ".join(f"{angle}:{100 * fraction:.0f}%" for angle, fraction in zip(angles, success_rate[name], strict=True))
    )
    assert success_rate[name][:2].min() == 1.0  # all methods succeed from 20 degrees
assert accuracy["generalized"][0] < accuracy["point to point"][0] + 0.05
assert steps["point to plane"] < steps["point to point"]

# %%
# Single registrations
# --------------------
# All methods return the same type of result.
init = perturbed(10, axes[0])
for name, method in methods.items():
    registration = reg.registration_icp(source, target, distance, init, method)
    print(
        f"{name:15} fitness {registration.fitness:.3f}, rmse {1000 * registration.inlier_rmse:.2f} mm, "
        f"error {pose_error(registration.transformation)[0]:.3f} degrees, converged: {registration.converged}"
    )
    assert pose_error(registration.transformation)[0] < 1.0

# %%
# The initial pose with an error of 60 degrees, and the result:
start = perturbed(60, axes[1])
end = reg.registration_icp(source, target, distance, start, methods["point to plane"], criteria).transformation
shift = np.array([1.1 * size, 0, 0])
scene = {
    "target": {"geometry": target.without("colors"), "color": (0.2, 0.5, 0.8)},
    "before": {"geometry": source.without("colors").transform(start), "color": (0.95, 0.6, 0.1)},
    "target (after)": {"geometry": target.without("colors").translate(shift), "color": (0.2, 0.5, 0.8)},
    "after": {"geometry": source.without("colors").transform(end).translate(shift), "color": (0.95, 0.6, 0.1)},
}
corners = np.vstack([style["geometry"].points for style in scene.values()])
image = loom.render(
    scene,
    loom.View.fit(corners, direction=(0.0, 1.0, -0.35), width=960, height=480),
    legend=[("target", (0.2, 0.5, 0.8)), ("source", (0.95, 0.6, 0.1))],
)

# %%
# What to change
# --------------
# - ``distance`` as a fraction of the size: 0.05 reduces the convergence range, 0.5 the accuracy.
# - The noise as a fraction of the size: 0.01 instead of 0.0015. Which method is the most accurate?
# - ``max_iteration``: does 100 increase the success rate of point-to-point ICP?
#
# Next
# ----
# - :ref:`Chapter 7 <sphx_glr_chapters_plot_07_icp.py>`: ICP, step by step.
# - :ref:`ICP with low overlap <sphx_glr_gallery_registration_plot_low_overlap.py>`
# - :ref:`Robust kernels for ICP with clutter <sphx_glr_gallery_registration_plot_robust_kernels.py>`
