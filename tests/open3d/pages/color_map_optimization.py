"""Open3D's documentation, "Color map optimization", on three frames of a synthetic room."""

import numpy as np
import open3d as o3d

camera = o3d.io.read_pinhole_camera_intrinsic("camera.json")
rgbd_images = []
for i in range(3):
    depth = o3d.io.read_image(f"depth/{i}.png")
    color = o3d.io.read_image(f"color/{i}.jpg")
    rgbd_image = o3d.geometry.RGBDImage.create_from_color_and_depth(color, depth, convert_rgb_to_intensity=False)
    rgbd_images.append(rgbd_image)

camera_trajectory = o3d.io.read_pinhole_camera_trajectory("cameras.json")
mesh = o3d.io.read_triangle_mesh("room.ply")

color_map, scene = o3d.pipelines.color_map, (mesh, rgbd_images, camera_trajectory)
option = color_map.RigidOptimizerOption(maximum_iteration=0)
mesh_plain, camera_trajectory_plain = color_map.run_rigid_optimizer(*scene, option)
o3d.visualization.draw_geometries([mesh_plain])

option = color_map.RigidOptimizerOption(maximum_iteration=20)
mesh_rigid, trajectory_rigid = color_map.run_rigid_optimizer(*scene, option)
o3d.visualization.draw_geometries([mesh_rigid])
option = color_map.NonRigidOptimizerOption(maximum_iteration=10)
mesh_bent, trajectory_bent = color_map.run_non_rigid_optimizer(*scene, option)
o3d.visualization.draw_geometries([mesh_bent])

results = {
    "plain": np.asarray(mesh_plain.vertex_colors),
    "rigid": np.asarray(mesh_rigid.vertex_colors),
    "bent": np.asarray(mesh_bent.vertex_colors),
    "cameras": [parameter.extrinsic for parameter in camera_trajectory_plain.parameters],
    "size": trajectory_rigid.parameters[0].intrinsic.width,
    "count": len(trajectory_bent.parameters),
}
