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

odometry = o3d.pipelines.odometry
images = source_rgbd_image, target_rgbd_image
terms = odometry.RGBDOdometryJacobianFromColorTerm(), odometry.RGBDOdometryJacobianFromHybridTerm()
[success_color_term, trans_color_term, info], [success_hybrid_term, trans_hybrid_term, info_hybrid] = (
    odometry.compute_rgbd_odometry(*images, pinhole_camera_intrinsic, odo_init, term, option) for term in terms
)
for success, trans in ((success_color_term, trans_color_term), (success_hybrid_term, trans_hybrid_term)):
    if success:
        print(trans)
        source_pcd = o3d.geometry.PointCloud.create_from_rgbd_image(source_rgbd_image, pinhole_camera_intrinsic)
        source_pcd.transform(trans)
        o3d.visualization.draw_geometries([target_pcd, source_pcd])

results = {
    "option": repr(option),
    "color success": bool(success_color_term),
    "hybrid success": bool(success_hybrid_term),
    "color": trans_color_term,
    "hybrid": trans_hybrid_term,
    "information": np.asarray(info_hybrid) / info_hybrid[5, 5],
    "points": len(target_pcd.points),
}
