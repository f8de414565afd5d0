"""
Cast rays: what is visible, inside, how far
===========================================

``RaycastingScene`` holds meshes for questions: what does a sensor see from here, which points are in the shade, which
lie inside, how far is the nearest surface. A simulated depth camera, a shadow and a signed distance field follow.
"""

import numpy as np

import pointloom as loom

# %%
# A scene
# -------
#
# Each mesh gets a number, by which hits tell what they met. A mesh may stand in several places (``add_instance``) and
# be moved (``set_pose``) without its tree being built again.

owl = loom.datasets.object_mesh().compute_vertex_normals()
floor = loom.TriangleMesh.create_plane(1.2, 1.2).translate([-0.6, -0.6, float(owl.get_min_bound()[2])])
scene = loom.RaycastingScene()
owl_id = scene.add_triangles(owl)
floor_id = scene.add_triangles(floor)
pose = np.eye(4)
pose[:3, 3] = [0.3, 0.12, 0]
second_id = scene.add_instance(owl_id, pose)

# %%
# What a camera sees
# ------------------
#
# Rays are rows of six numbers: a place and a direction. Those of a pinhole camera come by themselves. ``t_hit`` is how
# far along the direction the first hit is, infinite where there is none. As in Open3D, these rays have the middle of
# the first pixel at (0.5, 0.5), everything else here at (0, 0): so half a pixel goes to the principal point.

view = loom.View.fit(
    np.vstack([owl.vertices, owl.vertices + pose[:3, 3]]), direction=(0.35, 1, -0.45), width=960, height=640
)
K = view.intrinsic.intrinsic_matrix + np.array([[0, 0, 0.5], [0, 0, 0.5], [0, 0, 0]])
rays = scene.create_rays_pinhole(K, np.linalg.inv(view.T_world_camera), 960, 640)
hits = scene.cast_rays(rays)
names = {owl_id: "owl", second_id: "second owl", floor_id: "floor", scene.INVALID_ID: "nothing"}
for number, count in zip(*np.unique(hits["geometry_ids"], return_counts=True), strict=False):
    print(f"{names[int(number)]:11} {count:6} rays")
assert set(np.unique(hits["geometry_ids"]).tolist()) >= {owl_id, second_id, floor_id}

# %%
# The drawn image agrees: its own depths along the optical axis are those of the rays.

depth = loom.render([owl, owl.transform(pose), floor], view, depth=True)[1]
along = hits["t_hit"] * (np.asarray(rays)[..., 3:] @ view.T_world_camera[:3, 2])
both = np.isfinite(along) & (depth > 0)
print(f"rays and image differ by {np.median(np.abs(along - depth)[both]) * 1e3:.3f} mm (median)")
assert both.mean() > 0.5 and np.median(np.abs(along - depth)[both]) < 1e-4

# %%
# Shade
# -----
#
# From each place that was hit a ray goes to the lamp; ``test_occlusions`` only asks whether something is in between. It
# starts a little above the surface.

seen = np.isfinite(hits["t_hit"])
hit_points = (np.asarray(rays)[..., :3] + hits["t_hit"][..., None] * np.asarray(rays)[..., 3:])[seen]
normals = hits["primitive_normals"][seen]
lamp = np.array([-0.7, -0.8, 1.0])
to_lamp = lamp - hit_points
to_rays = np.hstack([hit_points + 1e-4 * normals, to_lamp]).astype(np.float32)
dark = scene.test_occlusions(to_rays, tfar=1.0) | ((normals * to_lamp).sum(axis=1) < 0)
print(f"{100 * dark.mean():.0f} % of the visible points are in the shade")
assert 0.05 < dark.mean() < 0.8

light = np.clip((normals * to_lamp).sum(axis=1) / np.linalg.norm(to_lamp, axis=1), 0, 1)
tint = np.array(
    [
        {owl_id: (0.85, 0.6, 0.4), second_id: (0.5, 0.65, 0.85), floor_id: (0.93, 0.93, 0.9)}[int(g)]
        for g in hits["geometry_ids"][seen]
    ]
)
lit = loom.PointCloud(hit_points, colors=np.clip(tint * (0.35 + 0.65 * light * ~dark)[:, None], 0, 1))
image = loom.render({"geometry": lit, "shaded": False}, view)

# %%
# Inside or outside
# -----------------
#
# A grid across the middle of the first owl: signed distances [m], negative inside. For a closed mesh the sign is exact
# at any distance; ``sign_method`` says how it was found.

alone = loom.RaycastingScene()
alone.add_triangles(owl)
x, z = np.meshgrid(np.linspace(-0.15, 0.15, 300), np.linspace(-0.17, 0.17, 340))
grid = np.stack([x, np.zeros_like(x), z], axis=-1).reshape(-1, 3).astype(np.float32)
signed = alone.compute_signed_distance(grid)
inside = alone.compute_occupancy(grid) > 0
print(f"{inside.sum()} of {len(grid)} places inside; signs by {alone.sign_method}")
assert np.array_equal(inside, signed <= 0)
assert np.allclose(np.abs(signed), alone.compute_distance(grid), atol=1e-6)
area = inside.sum() * (0.3 / 299) * (0.34 / 339)
parity = alone.count_intersections(np.hstack([grid, np.tile(np.float32([0, 0, 1]), (len(grid), 1))])) % 2 == 1
assert (parity == inside).mean() > 0.995, "a ray out of a closed solid meets its surface an odd number of times"
print(f"the section has {area * 1e4:.1f} cm^2")

field = loom.PointCloud(grid)
field["signed distance [m]"] = signed
section = owl.slice_plane([0, 0, 0], [0, 1, 0])
shown = [
    {
        "geometry": field,
        "color_by": "signed distance [m]",
        "colormap": "coolwarm",
        "limits": (-0.08, 0.08),
        "shaded": False,
    },
    {"geometry": section, "line_width": 3},
]
distances = loom.render(
    shown, {"front": [0, -1, 0], "up": [0, 0, 1], "field_of_view": 20, "zoom": 0.72}, (960, 640), color_bar=True
)
