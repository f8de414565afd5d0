"""
ICP: which method, and from how far
===================================

ICP moves a cloud onto another from a pose nearby. What its pairs are asked to bring together decides how exact it
gets, and from how far away it still finds the pose. Five kinds of it are begun here from 0 to 120 degrees off, and
the truth is known.
"""

import numpy as np

import pointloom as loom

reg = loom.registration

# %%
# Two scans of one object: the target is one half of the points of a surface, the source the other half, with noise of
# 0.6 mm each. No point is in both, so that no pair is exact.
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
    """The pose T_target_source to begin from: turned about the middle."""
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    K = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    T = np.eye(4)
    T[:3, :3] = np.eye(3) + s * K + (1 - c) * K @ K
    T[:3, 3] = cloud.get_center() - T[:3, :3] @ cloud.get_center()
    return T


def off(T):
    """How far a pose is from the truth, the identity: degrees, and meters at the object's middle."""
    angle = np.degrees(2 * np.arcsin(min(np.linalg.norm(T[:3, :3] - np.eye(3)) / np.sqrt(8), 1)))
    return angle, np.linalg.norm((T @ np.r_[cloud.get_center(), 1])[:3] - cloud.get_center())


# %%
# The kinds. Point-to-plane lets surfaces slide along each other, which is why it needs few steps; generalized ICP
# compares surface with surface; the symmetric one suits curved things; colors help where the shape alone leaves a
# motion open.
methods = {
    "point to point": reg.TransformationEstimation.point_to_point(),
    "point to plane": reg.TransformationEstimation.point_to_plane(),
    "generalized": reg.TransformationEstimation.generalized(),
    "symmetric": reg.TransformationEstimation.symmetric(),
    "colored": reg.TransformationEstimation.colored(),
}
distance = 0.15 * size  # pairs lie nearer than this [m]; larger reaches farther, and is led astray more
angles = np.array([0, 20, 40, 60, 90, 120])
axes = rng.normal(size=(4, 3))
axes /= np.linalg.norm(axes, axis=1, keepdims=True)
inits = np.array([perturbed(angle, axis) for angle in angles for axis in axes])

# %%
# All starts of a method run in one batch. Reached is what ends within 1 degree.
criteria = reg.ICPConvergenceCriteria(max_iteration=40)
reached, steps, exact = {}, {}, {}
for name, method in methods.items():
    results = reg.registration_icp_batch(source, target, distance, inits, method, criteria)
    errors = np.array([off(result.transformation) for result in results])
    success = errors[:, 0] < 1.0
    reached[name] = success.reshape(len(angles), len(axes)).mean(axis=1)
    steps[name] = np.median([result.iterations for result, good in zip(results, success, strict=True) if good])
    exact[name] = np.median(errors[success], axis=0)
    print(
        f"{name:15} {exact[name][0]:.3f} degrees, {1000 * exact[name][1]:.3f} mm, {steps[name]:3.0f} steps; "
        "reached from "
        + " ".join(f"{angle}:{100 * fraction:.0f}%" for angle, fraction in zip(angles, reached[name], strict=True))
    )
    assert reached[name][:2].min() == 1.0  # from 20 degrees all of them do
assert exact["generalized"][0] < exact["point to point"][0] + 0.05
assert steps["point to plane"] < steps["point to point"]

# %%
# One pair at a time, all methods return the same kind of result.
init = perturbed(10, axes[0])
for name, method in methods.items():
    registration = reg.registration_icp(source, target, distance, init, method)
    print(
        f"{name:15} fitness {registration.fitness:.3f}, rmse {1000 * registration.inlier_rmse:.2f} mm, "
        f"{off(registration.transformation)[0]:.3f} degrees off, converged: {registration.converged}"
    )
    assert off(registration.transformation)[0] < 1.0

# %%
# Before, from 60 degrees off, and after.
start = perturbed(60, axes[1])
end = reg.registration_icp(source, target, distance, start, methods["point to plane"], criteria).transformation
shift = np.array([1.1 * size, 0, 0])
scene = {
    "target": {"geometry": target.without("colors"), "color": (0.2, 0.5, 0.8)},
    "before": {"geometry": source.without("colors").transform(start), "color": (0.95, 0.6, 0.1)},
    "target again": {"geometry": target.without("colors").translate(shift), "color": (0.2, 0.5, 0.8)},
    "after": {"geometry": source.without("colors").transform(end).translate(shift), "color": (0.95, 0.6, 0.1)},
}
corners = np.vstack([style["geometry"].points for style in scene.values()])
image = loom.render(
    scene,
    loom.View.fit(corners, direction=(0.0, 1.0, -0.35), width=960, height=480),
    legend=[("target", (0.2, 0.5, 0.8)), ("source", (0.95, 0.6, 0.1))],
)
