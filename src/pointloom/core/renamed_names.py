"""Public names that were renamed or replaced, for the errors of unknown names. docs/migration.md has the same table."""

from __future__ import annotations

RENAMED = {
    # packages
    "loom.change": "loom.m3c2, loom.meshing.compare_cloud_to_mesh, loom.draw_change or loom.paint_change",
    "loom.color_map": "loom.meshing",
    "loom.mvs": "loom.photogrammetry",
    "loom.odometry": "loom.rgbd",
    "loom.reconstruction": "loom.rgbd",
    "loom.sfm": "loom.photogrammetry",
    "loom.slam": "loom.rgbd",
    "loom.video": "loom.photogrammetry",
    # functions of packages
    "loom.check_focal": "loom.rgbd.check_focal",
    "loom.clean_mesh": "loom.meshing.clean_mesh",
    "loom.compare_meshes": "loom.meshing.compare_meshes",
    "loom.create_surface": "loom.meshing.create_surface",
    "loom.DepthModel": "loom.photogrammetry.DepthModel",
    "loom.estimate_depth": "loom.photogrammetry.estimate_depth",
    "loom.evaluate_depth": "loom.photogrammetry.evaluate_depth",
    "loom.fuse": "loom.rgbd.fuse",
    "loom.fuse_splats": "loom.meshing.fuse_splats",
    "loom.fuse_volumes": "loom.meshing.fuse_volumes",
    "loom.marching_cubes": "loom.meshing.marching_cubes",
    "loom.orthophoto": "loom.meshing.orthophoto",
    "loom.reconstruct": "loom.rgbd.reconstruct",
    "loom.simplify_mesh": "loom.meshing.simplify_mesh",
    "loom.smooth_mesh": "loom.meshing.smooth_mesh",
    "loom.track": "loom.rgbd.track",
    # one name, one thing
    "loom.change.cloud_to_mesh": "loom.meshing.compare_cloud_to_mesh",
    "loom.change.draw": "loom.draw_change",
    "loom.change.m3c2": "loom.m3c2",
    "loom.change.paint": "loom.paint_change",
    "loom.color_map.texture_from_pictures": "loom.meshing.texture_from_images",
    "loom.fit_view": "loom.View.fit",
    "loom.meshing.NonRigidOptimizerOption": "loom.meshing.ColorMapOption",
    "loom.meshing.RigidOptimizerOption": "loom.meshing.ColorMapOption",
    "loom.meshing.run_non_rigid_optimizer": "loom.meshing.optimize_color_map",
    "loom.meshing.run_rigid_optimizer": "loom.meshing.optimize_color_map",
    "loom.mvs.fuse": "loom.photogrammetry.fuse_depth_maps",
    "loom.odometry.Method": "loom.rgbd.align_frames",
    "loom.pyrdown_color": "loom.create_depth_pyramid",
    "loom.pyrdown_depth": "loom.create_depth_pyramid",
    "loom.read_colmap_model": "loom.read_cameras",
    "loom.read_metashape_cameras": "loom.read_cameras",
    "loom.read_pinhole_camera_intrinsic": "loom.PinholeCameraIntrinsic.read",
    "loom.reconstruction.run_system": "loom.rgbd.run_reconstruction_system",
    "loom.registration.CauchyLoss": "loom.registration.RobustKernel.cauchy",
    "loom.registration.check_alignment": "loom.registration.assess_registration",
    "loom.registration.CorrespondenceCheckerBasedOnDistance": "loom.registration.CorrespondenceChecker.by_distance",
    "loom.registration.CorrespondenceCheckerBasedOnEdgeLength": (
        "loom.registration.CorrespondenceChecker.by_edge_length"
    ),
    "loom.registration.CorrespondenceCheckerBasedOnNormal": "loom.registration.CorrespondenceChecker.by_normal",
    "loom.registration.CorrespondenceCheckerBasedOnSourceRotation": (
        "loom.registration.CorrespondenceChecker.by_rotation"
    ),
    "loom.registration.GeneralizedLoss": "loom.registration.RobustKernel.general",
    "loom.registration.GlobalOptimizationGaussNewton": "loom.registration.global_optimization",
    "loom.registration.GlobalOptimizationLevenbergMarquardt": "loom.registration.global_optimization",
    "loom.registration.GMLoss": "loom.registration.RobustKernel.geman_mcclure",
    "loom.registration.HuberLoss": "loom.registration.RobustKernel.huber",
    "loom.registration.iterate_odometry": "loom.registration.LidarOdometry or loom.registration.run_odometry",
    "loom.registration.L1Loss": "loom.registration.RobustKernel.l1",
    "loom.registration.L2Loss": "loom.registration.RobustKernel.l2",
    "loom.registration.list_scans": "loom.registration.run_odometry",
    "loom.registration.localizability": "loom.registration.assess_registration",
    "loom.registration.pose_covariance": "loom.registration.assess_registration",
    "loom.registration.RANSACConvergenceCriteria": "loom.registration.registration_ransac_based_on_correspondence",
    "loom.registration.rate_registration": "loom.registration.assess_registration",
    "loom.registration.register_fragments": "loom.registration.register_multiway",
    "loom.registration.registration_colored_icp": "loom.registration.registration_icp",
    "loom.registration.registration_fgr_based_on_feature_matching": (
        "loom.registration.correspondences_from_features, loom.registration.registration_fgr_based_on_correspondence"
    ),
    "loom.registration.registration_generalized_icp": "loom.registration.registration_icp",
    "loom.registration.registration_ransac_based_on_feature_matching": (
        "loom.registration.correspondences_from_features, loom.registration.registration_ransac_based_on_correspondence"
    ),
    "loom.registration.registration_robust_based_on_feature_matching": (
        "loom.registration.correspondences_from_features, loom.registration.registration_robust_based_on_correspondence"
    ),
    "loom.registration.registration_symmetric_icp": "loom.registration.registration_icp",
    "loom.registration.summarize_steps": "loom.registration.LidarOdometry.summary",
    "loom.registration.TransformationEstimationForColoredICP": "loom.registration.TransformationEstimation.colored",
    "loom.registration.TransformationEstimationForGeneralizedICP": (
        "loom.registration.TransformationEstimation.generalized"
    ),
    "loom.registration.TransformationEstimationPointToPlane": (
        "loom.registration.TransformationEstimation.point_to_plane"
    ),
    "loom.registration.TransformationEstimationPointToPoint": (
        "loom.registration.TransformationEstimation.point_to_point"
    ),
    "loom.registration.TransformationEstimationSymmetric": "loom.registration.TransformationEstimation.symmetric",
    "loom.registration.TukeyLoss": "loom.registration.RobustKernel.tukey",
    "loom.rgbd.integrate_scene": "loom.rgbd.run_reconstruction_system",
    "loom.rgbd.make_fragments": "loom.rgbd.run_reconstruction_system",
    "loom.rgbd.OdometryConvergenceCriteria": "loom.rgbd.compute_rgbd_odometry",
    "loom.rgbd.OdometryLossParams": "loom.rgbd.compute_rgbd_odometry",
    "loom.rgbd.OdometryMethod": "loom.rgbd.align_frames",
    "loom.rgbd.OdometryOption": "loom.rgbd.compute_rgbd_odometry",
    "loom.rgbd.refine_registration": "loom.rgbd.run_reconstruction_system",
    "loom.rgbd.refine_with_slac": "loom.rgbd.run_reconstruction_system",
    "loom.rgbd.register_fragments": "loom.rgbd.run_reconstruction_system",
    "loom.rgbd.rgbd_odometry_multi_scale": "loom.rgbd.compute_rgbd_odometry",
    "loom.rgbd.RGBDOdometryJacobianFromColorTerm": "loom.rgbd.compute_rgbd_odometry",
    "loom.rgbd.RGBDOdometryJacobianFromHybridTerm": "loom.rgbd.compute_rgbd_odometry",
    "loom.sample_file": "loom.DetailTree.sample",
    "loom.save_picture": "loom.write_image",
    "loom.sfm.map_pictures": "loom.photogrammetry.map_images",
    "loom.sfm.match": "loom.photogrammetry.match_features",
    "loom.sfm.read_picture_places": "loom.photogrammetry.read_image_positions",
    "loom.sfm.reconstruct": "loom.photogrammetry.reconstruct_images",
    "loom.slam.Model": "loom.rgbd.SlamModel",
    "loom.undistort_picture": "loom.undistort_image",
    "loom.utm_epsg": "loom.project_to_utm",
    "loom.video.Outputs": "loom.photogrammetry.VideoOutputs",
    "loom.video.reconstruct": "loom.photogrammetry.reconstruct_video",
    "loom.video.Settings": "loom.photogrammetry.VideoSettings",
    "loom.video.Units": "loom.photogrammetry.VideoUnits",
    "loom.video.WorldFrame": "loom.WorldFrame",
    "loom.write_pinhole_camera_intrinsic": "loom.PinholeCameraIntrinsic.write",
}


def renamed(package: str, name: str) -> str:
    """The new name of `package.name`, by its old or its present package, such as `loom.rgbd.Model`; "" if unknown."""
    if new := RENAMED.get(f"{package}.{name}"):
        return new
    moved = [new for old, new in RENAMED.items() if old.rpartition(".")[2] == name and new.startswith(f"{package}.")]
    return " or ".join(moved)
