"""The data sets of Open3D 0.20: the name of each file, below the folder of its data set."""

from __future__ import annotations

from .dataset import SampleDataset, file, files, files_in, path_map


class ArmadilloMesh(SampleDataset):
    _similar = "object_mesh()"
    _public = "armadillo"
    path = file("ArmadilloMesh.ply")


class BunnyMesh(SampleDataset):
    _similar = "object_mesh()"
    _public = "bunny"
    path = file("BunnyMesh.ply")


class KnotMesh(SampleDataset):
    _similar = "object_mesh()"
    path = file("KnotMesh.ply")


class EaglePointCloud(SampleDataset):
    _similar = "room_cloud()"
    path = file("EaglePointCloud.ply")


class PCDPointCloud(SampleDataset):
    _similar = "room_cloud()"
    _public = "indoor-fragment"
    path = file("fragment.pcd")


class PLYPointCloud(SampleDataset):
    _similar = "room_cloud()"
    _public = "indoor-fragment"
    path = file("fragment.ply")


class AvocadoModel(SampleDataset):
    _similar = "object_mesh()"
    path = file("AvocadoModel.glb")


class DamagedHelmetModel(SampleDataset):
    _similar = "object_mesh()"
    path = file("DamagedHelmetModel.glb")


class JackJackL515Bag(SampleDataset):
    _similar = "room_frames(24)"
    path = file("JackJackL515Bag.bag")


class SampleL515Bag(SampleDataset):
    _similar = "room_frames(24)"
    path = file("L515_test_s.bag")


class JuneauImage(SampleDataset):
    path = file("JuneauImage.jpg")


class DemoICPPointClouds(SampleDataset):
    _similar = "object_scans()"
    _public = "icp-clouds"
    paths = files("cloud_bin_{}.pcd", range(3))
    transformation_log_path = file("init.log")


class DemoColoredICPPointClouds(SampleDataset):
    _similar = "object_scans()"
    paths = files("frag_{}.ply", (115, 116))


class DemoCropPointCloud(SampleDataset):
    _similar = "room_cloud()"
    point_cloud_path = file("fragment.ply")
    cropped_json_path = file("cropped.json")


class DemoCustomVisualization(SampleDataset):
    _similar = "room_cloud()"
    point_cloud_path = file("fragment.ply")
    camera_trajectory_path = file("camera_trajectory.json")
    render_option_path = file("renderoption.json")


class DemoDopplerICPSequence(SampleDataset):
    _similar = "street_scans()"
    paths = files("xyzd_sequence/{:05d}.xyzd", range(1, 101))
    calibration_path = file("calibration.json")
    trajectory_path = file("ground_truth_poses.txt")


class DemoFeatureMatchingPointClouds(SampleDataset):
    _similar = "object_scans()"
    point_cloud_paths = files("cloud_bin_{}.pcd", range(2))
    fpfh_feature_paths = files("cloud_bin_{}.fpfh.bin", range(2))
    l32d_feature_paths = files("cloud_bin_{}.d32.bin", range(2))


class DemoPoseGraphOptimization(SampleDataset):
    pose_graph_fragment_path = file("pose_graph_example_fragment.json")
    pose_graph_global_path = file("pose_graph_example_global.json")


class LivingRoomPointClouds(SampleDataset):
    _similar = "object_scans()"
    _public = "living-room-fragments"
    paths = files("cloud_bin_{}.ply", range(57))


class OfficePointClouds(SampleDataset):
    _similar = "object_scans()"
    paths = files("cloud_bin_{}.ply", range(53))


class SampleNYURGBDImage(SampleDataset):
    _similar = "room_frames(1)"
    color_path = file("NYU_color.ppm")
    depth_path = file("NYU_depth.pgm")


class SampleSUNRGBDImage(SampleDataset):
    _similar = "room_frames(1)"
    color_path = file("SUN_color.jpg")
    depth_path = file("SUN_depth.png")


class SampleTUMRGBDImage(SampleDataset):
    _similar = "room_frames(1)"
    _public = "tum-frame"
    color_path = file("TUM_color.png")
    depth_path = file("TUM_depth.png")


class SampleRedwoodRGBDImages(SampleDataset):
    _similar = "room_frames(5)"
    _public = "redwood-frames"
    color_paths = files("color/{:05d}.jpg", range(5))
    depth_paths = files("depth/{:05d}.png", range(5))
    trajectory_log_path = file("trajectory.log")
    odometry_log_path = file("odometry.log")
    rgbd_match_path = file("rgbd.match")
    reconstruction_path = file("example_tsdf_pcd.ply")
    camera_intrinsic_path = file("camera_primesense.json")


class SampleFountainRGBDImages(SampleDataset):
    _similar = "room_frames(33)"
    color_paths = files_in("image", ".jpg")
    depth_paths = files_in("depth", ".png")
    keyframe_poses_log_path = file("scene/key.log")
    reconstruction_path = file("scene/integrated.ply")


class BedroomRGBDImages(SampleDataset):
    _similar = "room_frames(100)"
    color_paths = files("image/{:06d}.jpg", range(1, 21931))
    depth_paths = files("depth/{:06d}.png", range(1, 21931))
    trajectory_log_path = file("bedroom.log")
    reconstruction_path = file("bedroom.ply")


class LoungeRGBDImages(SampleDataset):
    _similar = "room_frames(100)"
    _public = "lounge"
    color_paths = files("color/{:06d}.png", range(1, 3000))
    depth_paths = files("depth/{:06d}.png", range(1, 3000))
    trajectory_log_path = file("lounge_trajectory.log")
    reconstruction_path = file("lounge.ply")


class RedwoodIndoorLivingRoom1(SampleDataset):
    _similar = "room_frames(100)"
    _public = "living-room"
    point_cloud_path = file("livingroom.ply")
    color_paths = files("color/{:05d}.jpg", range(2870))
    depth_paths = files("depth/{:05d}.png", range(2870))
    noisy_depth_paths = files("depth_noisy/{:05d}.png", range(2870))
    oni_path = file("livingroom1.oni")
    trajectory_path = file("livingroom1-traj.txt")
    noise_model_path = file("dist-model.txt")


class RedwoodIndoorLivingRoom2(SampleDataset):
    _similar = "room_frames(100)"
    point_cloud_path = file("livingroom.ply")
    color_paths = files("color/{:05d}.jpg", range(2350))
    depth_paths = files("depth/{:05d}.png", range(2350))
    noisy_depth_paths = files("depth_noisy/{:05d}.png", range(2350))
    oni_path = file("livingroom2.oni")
    trajectory_path = file("livingroom2-traj.txt")
    noise_model_path = file("dist-model.txt")


class RedwoodIndoorOffice1(SampleDataset):
    _similar = "room_frames(100)"
    point_cloud_path = file("office.ply")
    color_paths = files("color/{:05d}.jpg", range(2690))
    depth_paths = files("depth/{:05d}.png", range(2690))
    noisy_depth_paths = files("depth_noisy/{:05d}.png", range(2690))
    oni_path = file("office1.oni")
    trajectory_path = file("office1-traj.txt")
    noise_model_path = file("dist-model.txt")


class RedwoodIndoorOffice2(SampleDataset):
    _similar = "room_frames(100)"
    point_cloud_path = file("office.ply")
    color_paths = files("color/{:05d}.jpg", range(2538))
    depth_paths = files("depth/{:05d}.png", range(2538))
    noisy_depth_paths = files("depth_noisy/{:05d}.png", range(2538))
    oni_path = file("office2.oni")
    trajectory_path = file("office2-traj.txt")
    noise_model_path = file("dist-model.txt")


class CrateModel(SampleDataset):
    _similar = "object_mesh()"
    path = file("crate.obj")
    path_map = path_map(crate_material="crate.mtl", crate_model="crate.obj", texture_image="crate.jpg")


class MonkeyModel(SampleDataset):
    _similar = "object_mesh()"
    path = file("monkey.obj")
    path_map = path_map(
        albedo="albedo.png",
        ao="ao.png",
        metallic="metallic.png",
        monkey_material="monkey.mtl",
        monkey_model="monkey.obj",
        monkey_solid_material="monkey_solid.mtl",
        monkey_solid_model="monkey_solid.obj",
        normal="normal.png",
        roughness="roughness.png",
    )


class SwordModel(SampleDataset):
    _similar = "object_mesh()"
    path = file("UV.obj")
    path_map = path_map(
        sword_material="UV.mtl",
        sword_model="UV.obj",
        base_color="UV_blinn1SG_BaseColor.png",
        metallic="UV_blinn1SG_Metallic.png",
        normal="UV_blinn1SG_Normal.png",
        roughness="UV_blinn1SG_Roughness.png",
    )


class FlightHelmetModel(SampleDataset):
    _similar = "object_mesh()"
    path = file("FlightHelmet.gltf")
    path_map = path_map(
        flight_helmet="FlightHelmet.gltf",
        flight_helmet_bin="FlightHelmet.bin",
        mat_glass_plastic_base="FlightHelmet_Materials_GlassPlasticMat_BaseColor.png",
        mat_glass_plastic_normal="FlightHelmet_Materials_GlassPlasticMat_Normal.png",
        mat_glass_plastic_occlusion_rough_metal="FlightHelmet_Materials_GlassPlasticMat_OcclusionRoughMetal.png",
        mat_leather_parts_base="FlightHelmet_Materials_LeatherPartsMat_BaseColor.png",
        mat_leather_parts_normal="FlightHelmet_Materials_LeatherPartsMat_Normal.png",
        mat_leather_parts_occlusion_rough_metal="FlightHelmet_Materials_LeatherPartsMat_OcclusionRoughMetal.png",
        mat_lenses_base="FlightHelmet_Materials_LensesMat_BaseColor.png",
        mat_lenses_normal="FlightHelmet_Materials_LensesMat_Normal.png",
        mat_lenses_occlusion_rough_metal="FlightHelmet_Materials_LensesMat_OcclusionRoughMetal.png",
        mat_metal_parts_base="FlightHelmet_Materials_MetalPartsMat_BaseColor.png",
        mat_metal_parts_normal="FlightHelmet_Materials_MetalPartsMat_Normal.png",
        mat_metal_parts_occlusion_rough_metal="FlightHelmet_Materials_MetalPartsMat_OcclusionRoughMetal.png",
        mat_rubber_wood_base="FlightHelmet_Materials_RubberWoodMat_BaseColor.png",
        mat_rubber_wood_normal="FlightHelmet_Materials_RubberWoodMat_Normal.png",
        mat_rubber_wood_occlusion_rough_metal="FlightHelmet_Materials_RubberWoodMat_OcclusionRoughMetal.png",
    )


class MetalTexture(SampleDataset):
    albedo_texture_path = file("Metal008_Color.jpg")
    normal_texture_path = file("Metal008_NormalDX.jpg")
    roughness_texture_path = file("Metal008_Roughness.jpg")
    metallic_texture_path = file("Metal008_Metalness.jpg")
    path_map = path_map(
        albedo="Metal008_Color.jpg",
        normal="Metal008_NormalDX.jpg",
        roughness="Metal008_Roughness.jpg",
        metallic="Metal008_Metalness.jpg",
    )


class PaintedPlasterTexture(SampleDataset):
    albedo_texture_path = file("PaintedPlaster017_Color.jpg")
    normal_texture_path = file("PaintedPlaster017_NormalDX.jpg")
    roughness_texture_path = file("noiseTexture.png")
    path_map = path_map(
        albedo="PaintedPlaster017_Color.jpg", normal="PaintedPlaster017_NormalDX.jpg", roughness="noiseTexture.png"
    )


class TerrazzoTexture(SampleDataset):
    albedo_texture_path = file("Terrazzo018_Color.jpg")
    normal_texture_path = file("Terrazzo018_NormalDX.jpg")
    roughness_texture_path = file("Terrazzo018_Roughness.jpg")
    path_map = path_map(
        albedo="Terrazzo018_Color.jpg", normal="Terrazzo018_NormalDX.jpg", roughness="Terrazzo018_Roughness.jpg"
    )


class TilesTexture(SampleDataset):
    albedo_texture_path = file("Tiles074_Color.jpg")
    normal_texture_path = file("Tiles074_NormalDX.jpg")
    roughness_texture_path = file("Tiles074_Roughness.jpg")
    path_map = path_map(albedo="Tiles074_Color.jpg", normal="Tiles074_NormalDX.jpg", roughness="Tiles074_Roughness.jpg")


class WoodFloorTexture(SampleDataset):
    albedo_texture_path = file("WoodFloor050_Color.jpg")
    normal_texture_path = file("WoodFloor050_NormalDX.jpg")
    roughness_texture_path = file("WoodFloor050_Roughness.jpg")
    path_map = path_map(
        albedo="WoodFloor050_Color.jpg", normal="WoodFloor050_NormalDX.jpg", roughness="WoodFloor050_Roughness.jpg"
    )


class WoodTexture(SampleDataset):
    albedo_texture_path = file("Wood049_Color.jpg")
    normal_texture_path = file("Wood049_NormalDX.jpg")
    roughness_texture_path = file("Wood049_Roughness.jpg")
    path_map = path_map(albedo="Wood049_Color.jpg", normal="Wood049_NormalDX.jpg", roughness="Wood049_Roughness.jpg")
