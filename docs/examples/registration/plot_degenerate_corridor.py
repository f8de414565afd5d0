"""
Degenerate geometry: odometry in a corridor
===========================================

In an empty corridor, scans do not determine the motion along it. A reliable odometry must report this instead of an
arbitrary trajectory. On this page you detect the undetermined direction, and add a motion prior from wheels or an IMU.
"""

import numpy as np

import pointloom as loom

reg = loom.registration


# %%
# Simulated scans
# ---------------
# The corridor is 2.4 m wide and 2.6 m high, and the scanner moves 0.3 m per scan. The noise is 5 mm. A second corridor
# has furniture and visible ends.
def corridor(furnished):
    """A scene for ray casting."""
    parts = [loom.TriangleMesh.create_box(120, 0.1, 2.6).translate([-60, side, 0]) for side in (-1.3, 1.2)]
    parts += [loom.TriangleMesh.create_box(120, 2.4, 0.1).translate([-60, -1.2, height]) for height in (-0.1, 2.6)]
    if furnished:
        rng = np.random.default_rng(3)
        parts += [
            loom.TriangleMesh.create_box(0.1, 2.4, 2.6).translate([x, -1.2, 0]) for x in (-6.0, 13.0)
        ]  # both ends
        for x in np.arange(-5, 12, 2.3):
            side = rng.choice([-1, 1])
            size = rng.uniform([0.3, 0.4, 0.5], [1.2, 0.9, 2.4])
            parts.append(
                loom.TriangleMesh.create_box(*size).translate(
                    [x + rng.uniform(0, 1.5), side * (1.2 - size[1] / 2) - size[1] / 2, 0]
                )
            )
    scene = loom.RaycastingScene()
    for part in parts:
        scene.add_triangles(part.vertices.astype(np.float32), part.triangles)
    return scene, parts


azimuth, elevation = np.meshgrid(np.linspace(-np.pi, np.pi, 720, endpoint=False), np.radians(np.linspace(-40, 40, 32)))
rays = np.column_stack(
    [
        np.cos(elevation).ravel() * np.cos(azimuth).ravel(),
        np.cos(elevation).ravel() * np.sin(azimuth).ravel(),
        np.sin(elevation).ravel(),
    ]
)


def scan_along(scene, count=14, step=0.3, seed=0):
    """Scans along x in sensor coordinates, with a range of 25 m."""
    rng = np.random.default_rng(seed)
    scans = []
    for k in range(count):
        origins = np.tile([step * k, 0.1, 1.3], (len(rays), 1))
        distance = np.asarray(scene.cast_rays(np.hstack([origins, rays]).astype(np.float32))["t_hit"], np.float64)
        hit = np.isfinite(distance) & (distance < 25)
        measured = distance[hit] + rng.normal(scale=0.005, size=hit.sum())
        scans.append(loom.PointCloud(rays[hit] * measured[:, None]))
    return scans


options = {"voxel_size": 0.15, "max_range": 25.0, "min_range": 0.5, "initial_threshold": 0.4, "deskew": False}
bare_scans, furnished_scans = (scan_along(corridor(furnished)[0]) for furnished in (False, True))

# %%
# Without a prior
# ---------------
# The result in the empty corridor is reported as unreliable, with the undetermined direction. The trajectory itself
# looks plausible, but hardly moves: the scan lines on the walls move with the scanner.
odometry = reg.LidarOdometry(**options)
for scan in bare_scans:
    odometry.register(scan)
bare = odometry.summary
print(bare)
print("warnings:", bare.warnings)
assert not bare.reliable and len(bare.undetermined) > 10 and "x" in bare.open_motions

# %%
# With a prior
# ------------
# ``prior`` is the motion since the previous scan, here from wheels with a scale error of 5%. In the empty corridor, a
# part of the error remains, and most scans are reported as undetermined. In the furnished corridor, the scans correct
# it.
wheels = np.eye(4)
wheels[0, 3] = 0.3 * 1.05
final_positions, poses, determined_count = {}, {}, {}
for name, scans in {"bare": bare_scans, "furnished": furnished_scans}.items():
    odometry = reg.LidarOdometry(**options)
    poses[name] = []
    for k, scan in enumerate(scans):
        poses[name].append(odometry.register(scan, prior=wheels if k else None))
    final_positions[name] = poses[name][-1][:3, 3]
    determined_count[name] = sum(not step.undetermined for step in odometry.steps[1:])
    print(
        f"{name:9}: final position {final_positions[name].round(3)} m, ground truth [3.9, 0, 0]; "
        f"{determined_count[name]} of 13 scans determine the motion"
    )
error = {name: np.linalg.norm(end - [3.9, 0, 0]) for name, end in final_positions.items()}
assert error["furnished"] < 0.02 < error["bare"] < 0.25
assert determined_count["bare"] < 7 and determined_count["furnished"] > 10

# %%
# ICP only
# --------
# ICP of two such scans has a perfect fitness and a wrong pose: the motion of 30 cm is not detected.
# ``degenerate_directions`` lists motions that are not determined at all, as for a single wall. Noisy normals at the
# edges of the corridor are sufficient to hide the degeneracy. Fitness does not measure reliability.
target, source = (scan.voxel_down_sample(0.1).estimate_normals(max_nn=15) for scan in bare_scans[:2])
plane = reg.TransformationEstimationPointToPlane()
result = reg.registration_icp(source, target, 0.5, np.eye(4), plane)
print(
    f"corridor: fitness {result.fitness:.3f}, {result.transformation[0, 3]:.3f} m along x, "
    f"{len(result.degenerate_directions)} motions undetermined"
)
assert result.fitness > 0.98 and abs(result.transformation[0, 3] - 0.3) > 0.1
wall = target.select_by_mask((target.points[:, 1] > 1.05) & (np.abs(target.normals[:, 1]) > 0.99))
result = reg.registration_icp(wall, wall, 0.5, np.eye(4), plane)
print(f"one wall: fitness {result.fitness:.3f}, {len(result.degenerate_directions)} motions undetermined")
assert len(result.degenerate_directions) == 3  # two translations along the wall, and the rotation in its plane

# %%
# Both corridors with the estimated positions:
scene, labels = [], []
for row, name in enumerate(poses):
    _, parts = corridor(name == "furnished")
    shift = np.array([0, -5.0 * row, 0])
    for part in parts:
        low, high = part.get_min_bound(), part.get_max_bound()
        if high[2] - low[2] > 0.2 or low[2] < 0:  # not the ceiling
            box = loom.TriangleMesh.create_box(
                *(np.minimum(high, [14, 9, 9]) - np.maximum(low, [-2, -9, -9])).clip(1e-3)
            )
            if low[0] < 14 and high[0] > -2 and not (low[1] < -1.25 and high[0] - low[0] > 50):
                scene.append(
                    box.translate(np.maximum(low, [-2, -9, -9]) + shift).paint_uniform_color([0.82, 0.82, 0.8])
                )
    positions = np.array(poses[name])[:, :3, 3] + shift + [0, 0.1, 1.3]
    color = (0.85, 0.2, 0.15) if name == "bare" else (0.1, 0.55, 0.3)
    scene += [
        loom.TriangleMesh.create_sphere(0.09).translate(position).paint_uniform_color(color) for position in positions
    ]
    labels.append(
        (
            f"{name}: {determined_count[name]} of 13 scans determine the motion",
            positions[len(positions) // 2] + [0, 0, 0.8],
        )
    )
corners = np.array([[-2, -6.3, 0], [14, -6.3, 0], [-2, 1.3, 2.6], [14, 1.3, 2.6]])
image = loom.render(scene, loom.View.fit(corners, direction=(0.2, 0.8, -0.7), width=960, height=560), labels=labels)

# %%
# What to change
# --------------
# - The scale error of the wheels: 1.05 is 5%.
# - ``max_range`` [m]: 40 in a corridor with visible ends at a larger distance.
# - The furniture: how many objects are needed to determine the motion?
#
# Next
# ----
# - :ref:`Doppler ICP in a tunnel <sphx_glr_gallery_registration_plot_doppler_icp.py>`
# - :doc:`When to trust a result </trust>`
