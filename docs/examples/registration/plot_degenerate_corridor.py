"""
What scans of a corridor do not tell
====================================

In a bare corridor every scan looks like the one before: nothing in it says how far the scanner went. The honest
answer of an odometry is then "I do not know along x", not a path. Here it says so, and what to do: a prior from
wheels or an IMU closes the gap.
"""

import numpy as np

import pointloom as loom

reg = loom.registration


# %%
# A corridor, 2.4 m wide and 2.6 m high, and a scanner that goes along it with 0.3 m a scan. Bare: walls, floor,
# ceiling. Furnished: with cupboards at uneven distances and both ends in view. 5 mm of noise.
def corridor(furnished):
    """A scene to cast rays at."""
    parts = [loom.TriangleMesh.create_box(120, 0.1, 2.6).translate([-60, side, 0]) for side in (-1.3, 1.2)]
    parts += [loom.TriangleMesh.create_box(120, 2.4, 0.1).translate([-60, -1.2, height]) for height in (-0.1, 2.6)]
    if furnished:
        rng = np.random.default_rng(3)
        parts += [
            loom.TriangleMesh.create_box(0.1, 2.4, 2.6).translate([x, -1.2, 0]) for x in (-6.0, 13.0)
        ]  # its two ends
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


azimuth, rise = np.meshgrid(np.linspace(-np.pi, np.pi, 720, endpoint=False), np.radians(np.linspace(-40, 40, 32)))
rays = np.column_stack(
    [
        np.cos(rise).ravel() * np.cos(azimuth).ravel(),
        np.cos(rise).ravel() * np.sin(azimuth).ravel(),
        np.sin(rise).ravel(),
    ]
)


def scan_along(scene, count=14, step=0.3, seed=0):
    """Scans along x, each in the scanner's frame, no farther than 25 m."""
    rng = np.random.default_rng(seed)
    scans = []
    for k in range(count):
        eye = np.tile([step * k, 0.1, 1.3], (len(rays), 1))
        distance = np.asarray(scene.cast_rays(np.hstack([eye, rays]).astype(np.float32))["t_hit"], np.float64)
        hit = np.isfinite(distance) & (distance < 25)
        measured = distance[hit] + rng.normal(scale=0.005, size=hit.sum())
        scans.append(loom.PointCloud(rays[hit] * measured[:, None]))
    return scans


options = {"voxel_size": 0.15, "max_range": 25.0, "min_range": 0.5, "initial_threshold": 0.4, "deskew": False}
bare_scans, furnished_scans = (scan_along(corridor(furnished)[0]) for furnished in (False, True))

# %%
# **The bare corridor from its scans alone** is refused, with the direction that is open. That refusal is the point:
# the path itself looks as smooth as any. It stands still in it, since the rings that a scanner draws on walls move
# with it.
odometry = reg.LidarOdometry(**options)
for scan in bare_scans:
    odometry.register(scan)
bare = odometry.summary
print(bare)
print("warnings:", bare.warnings)
assert not bare.reliable and len(bare.undetermined) > 10 and "x" in bare.open_motions

# %%
# **The cure**: tell it the motion from elsewhere. ``prior`` is the motion since the scan before; here wheels that
# measure 5 % too much. In the bare corridor the path keeps some of the wheels' error, and most scans say that they
# did not tell; in the furnished one the scans mend it.
wheels = np.eye(4)
wheels[0, 3] = 0.3 * 1.05
ends, poses, determined = {}, {}, {}
for name, scans in {"bare": bare_scans, "furnished": furnished_scans}.items():
    odometry = reg.LidarOdometry(**options)
    poses[name] = []
    for k, scan in enumerate(scans):
        poses[name].append(odometry.register(scan, prior=wheels if k else None))
    ends[name] = poses[name][-1][:3, 3]
    determined[name] = sum(not step.undetermined for step in odometry.steps[1:])
    print(
        f"{name:9}: ends at {ends[name].round(3)} m, the truth is [3.9, 0, 0]; "
        f"{determined[name]} of 13 scans determine the motion"
    )
error = {name: np.linalg.norm(end - [3.9, 0, 0]) for name, end in ends.items()}
assert error["furnished"] < 0.02 < error["bare"] < 0.25
assert determined["bare"] < 7 and determined["furnished"] > 10

# %%
# ICP between two such scans alone is perfect and wrong: every point has a partner, and the motion of 30 cm is not
# found. Its ``degenerate_directions`` name motions that the pairs do not determine at all, as on one wall; the
# corridor's edges, where normals are rounded, are enough to hide it. Fitness does not measure reliability.
target, source = (scan.voxel_down_sample(0.1).estimate_normals(max_nn=15) for scan in bare_scans[:2])
plane = reg.TransformationEstimation.point_to_plane()
result = reg.registration_icp(source, target, 0.5, np.eye(4), plane)
print(
    f"corridor: fitness {result.fitness:.3f}, {result.transformation[0, 3]:.3f} m along x, "
    f"{len(result.degenerate_directions)} motions open"
)
assert result.fitness > 0.98 and abs(result.transformation[0, 3] - 0.3) > 0.1
wall = target.select_by_mask((target.points[:, 1] > 1.05) & (np.abs(target.normals[:, 1]) > 0.99))
result = reg.registration_icp(wall, wall, 0.5, np.eye(4), plane)
print(f"one wall: fitness {result.fitness:.3f}, {len(result.degenerate_directions)} motions open")
assert len(result.degenerate_directions) == 3  # two ways along the wall, and the turn in it

# %%
# Both corridors, cut open, with the path that each gave.
drawn, labels = [], []
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
                drawn.append(
                    box.translate(np.maximum(low, [-2, -9, -9]) + shift).paint_uniform_color([0.82, 0.82, 0.8])
                )
    positions = np.array(poses[name])[:, :3, 3] + shift + [0, 0.1, 1.3]
    color = (0.85, 0.2, 0.15) if name == "bare" else (0.1, 0.55, 0.3)
    drawn += [
        loom.TriangleMesh.create_sphere(0.09).translate(position).paint_uniform_color(color) for position in positions
    ]
    labels.append(
        (f"{name}: {determined[name]} of 13 scans determine the motion", positions[len(positions) // 2] + [0, 0, 0.8])
    )
corners = np.array([[-2, -6.3, 0], [14, -6.3, 0], [-2, 1.3, 2.6], [14, 1.3, 2.6]])
image = loom.render(drawn, loom.View.fit(corners, direction=(0.2, 0.8, -0.7), width=960, height=560), labels=labels)
