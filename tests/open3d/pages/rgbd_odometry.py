"""Open3D's documentation, "RGBD odometry", on two frames of a synthetic room."""

import numpy as np
import open3d as o3d

pinhole_camera_intrinsic = o3d.io.read_pinhole_camera_intrinsic("camera.json")
print(pinhole_camera_intrinsic.intrinsic_matrix)

source_color = o3d.io.read_image("color/0.jpg")
source_depth = o3d.io.read_image("depth/0.png")
target_color = o3d.io.read_image("color/1.jpg")
target_depth = o3d.io.read_image("depth/1.png")
source_rgbd_image = o3d.geometry.RGBDImage.create_from_color_and_depth(source_color, source_depth)
target_rgbd_image = o3d.geometry.RGBDImage.create_from_color_and_depth(target_color, target_depth)
target_pcd = o3d.geometry.PointCloud.create_from_rgbd_image(target_rgbd_image, pinhole_camera_intrinsic)

option = o3d.pipelines.odometry.OdometryOption()
odo_init = np.identity(4)
print(option)

[success_color_term, trans_color_term, info] = o3d.pipelines.odometry.compute_rgbd_odometry(
    source_rgbd_image,
    target_rgbd_image,
    pinhole_camera_intrinsic,
    odo_init,
    o3d.pipelines.odometry.RGBDOdometryJacobianFromColorTerm(),
    option,
)
[success_hybrid_term, trans_hybrid_term, info_hybrid] = o3d.pipelines.odometry.compute_rgbd_odometry(
    source_rgbd_image,
    target_rgbd_image,
    pinhole_camera_intrinsic,
    odo_init,
    o3d.pipelines.odometry.RGBDOdometryJacobianFromHybridTerm(),
    option,
)

if success_color_term:
    print("Using RGB-D Odometry")
    print(trans_color_term)
    source_pcd_color_term = o3d.geometry.PointCloud.create_from_rgbd_image(source_rgbd_image, pinhole_camera_intrinsic)
    source_pcd_color_term.transform(trans_color_term)
    o3d.visualization.draw_geometries([target_pcd, source_pcd_color_term])
if success_hybrid_term:
    print("Using Hybrid RGB-D Odometry")
    print(trans_hybrid_term)
    source_pcd_hybrid_term = o3d.geometry.PointCloud.create_from_rgbd_image(source_rgbd_image, pinhole_camera_intrinsic)
    source_pcd_hybrid_term.transform(trans_hybrid_term)
    o3d.visualization.draw_geometries([target_pcd, source_pcd_hybrid_term])

results = {
    "option": repr(option),
    "color success": bool(success_color_term),
    "hybrid success": bool(success_hybrid_term),
    "color": trans_color_term,
    "hybrid": trans_hybrid_term,
    "information": np.asarray(info_hybrid) / info_hybrid[5, 5],
    "points": len(target_pcd.points),
}
