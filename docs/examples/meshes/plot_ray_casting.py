"""
Ray casting: visibility, distance, occupancy
============================================

On this page you use ``RaycastingScene`` for queries on meshes: which surfaces a sensor observes, which points are in
shadow, which points are inside a mesh, and how far the nearest surface is. The examples are a simulated depth camera, a
shadow, and a signed distance field.
"""

import numpy as np

import pointloom as loom

# %%
# A scene
# -------
#
# Each mesh has an id that the results contain. A mesh can be added several times (``add_instance``) and moved
# (``set_pose``) without rebuilding its tree.

owl = loom.datasets.object_mesh().compute_vertex_normals()
floor = loom.TriangleMesh.create_plane(1.2, 1.2).translate([-0.6, -0.6, float(owl.get_min_bound()[2])])
scene = loom.RaycastingScene()
owl_id = scene.add_triangles(owl)
floor_id = scene.add_triangles(floor)
pose = np.eye(4)
pose[:3, 3] = [0.3, 0.12, 0]
second_id = scene.add_instance(owl_id, pose)

# %%
# A simulated camera
# ------------------
#
# A ray consists of six numbers: origin and direction. ``create_rays_pinhole`` creates the rays of a camera. ``t_hit``
# is the distance of the first hit in units of the direction, and infinite without a hit. As in Open3D, the center of
# the first pixel is at (0.5, 0.5) here, while other functions of pointloom use (0, 0). Therefore 0.5 is added to the
# principal point.

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
# The depth of a rendered image agrees with the depth of the rays.

depth = loom.render([owl, owl.transform(pose), floor], view, depth=True)[1]
ray_depth = hits["t_hit"] * (np.asarray(rays)[..., 3:] @ view.T_world_camera[:3, 2])
both = np.isfinite(ray_depth) & (depth > 0)
print(f"difference of rays and image {np.median(np.abs(ray_depth - depth)[both]) * 1e3:.3f} mm (median)")
assert both.mean() > 0.5 and np.median(np.abs(ray_depth - depth)[both]) < 1e-4

# %%
# Shadows
# -------
#
# A ray is cast from each visible point to the lamp. ``test_occlusions`` only reports whether there is a hit. The
# origins are slightly above the surface.

is_hit = np.isfinite(hits["t_hit"])
hit_points = (np.asarray(rays)[..., :3] + hits["t_hit"][..., None] * np.asarray(rays)[..., 3:])[is_hit]
normals = hits["primitive_normals"][is_hit]
lamp = np.array([-0.7, -0.8, 1.0])
to_lamp = lamp - hit_points
to_rays = np.hstack([hit_points + 1e-4 * normals, to_lamp]).astype(np.float32)
in_shadow = scene.test_occlusions(to_rays, tfar=1.0) | ((normals * to_lamp).sum(axis=1) < 0)
print(f"{100 * in_shadow.mean():.0f} % of the visible points are in shadow")
assert 0.05 < in_shadow.mean() < 0.8

light = np.clip((normals * to_lamp).sum(axis=1) / np.linalg.norm(to_lamp, axis=1), 0, 1)
tint = np.array(
    [
        {owl_id: (0.85, 0.6, 0.4), second_id: (0.5, 0.65, 0.85), floor_id: (0.93, 0.93, 0.9)}[int(g)]
        for g in hits["geometry_ids"][is_hit]
    ]
)
lit = loom.PointCloud(hit_points, colors=np.clip(tint * (0.35 + 0.65 * light * ~in_shadow)[:, None], 0, 1))
image = loom.render({"geometry": lit, "shaded": False}, view)

# %%
# Inside and outside
# ------------------
#
# The script computes signed distances [m] on a grid through the first mesh. They are negative inside. For closed
# meshes, the sign is exact at any distance. ``sign_method`` reports the method.

owl_scene = loom.RaycastingScene()
owl_scene.add_triangles(owl)
x, z = np.meshgrid(np.linspace(-0.15, 0.15, 300), np.linspace(-0.17, 0.17, 340))
grid = np.stack([x, np.zeros_like(x), z], axis=-1).reshape(-1, 3).astype(np.float32)
signed = owl_scene.compute_signed_distance(grid)
inside = owl_scene.compute_occupancy(grid) > 0
print(f"{inside.sum()} of {len(grid)} points inside; sign method {owl_scene.sign_method}")
assert np.array_equal(inside, signed <= 0)
assert np.allclose(np.abs(signed), owl_scene.compute_distance(grid), atol=1e-6)
area = inside.sum() * (0.3 / 299) * (0.34 / 339)
parity = owl_scene.count_intersections(np.hstack([grid, np.tile(np.float32([0, 0, 1]), (len(grid), 1))])) % 2 == 1
assert (parity == inside).mean() > 0.995, "a ray from inside a closed solid hits its surface an odd number of times"
print(f"area of the section: {area * 1e4:.1f} cm^2")

field = loom.PointCloud(grid)
field["signed distance [m]"] = signed
section = owl.slice_plane([0, 0, 0], [0, 1, 0])
scene_styles = [
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
    scene_styles, {"front": [0, -1, 0], "up": [0, 0, 1], "field_of_view": 20, "zoom": 0.72}, (960, 640), color_bar=True
)

# %%
# What to change
# --------------
# - The position of the lamp [m].
# - ``direction`` of the view: the viewing direction of the simulated camera.
# - The resolution of the grid: 300 x 340 points.
#
# Next
# ----
# - :ref:`Cropping and hidden point removal <sphx_glr_gallery_clouds_plot_crop_and_hidden_points.py>`: visibility of
#   points without a mesh.
# - :doc:`Occupancy grids and distance fields </occupancy>`
