"""The data sets of Open3D 0.20: the name of each file, below the folder of its data set."""

from __future__ import annotations

from typing import ClassVar

from .dataset import SampleDataset, file, files, files_in, path_map


class ArmadilloMesh(SampleDataset, similar="object_mesh()", public="armadillo"):
    path = file("ArmadilloMesh.ply")


class BunnyMesh(SampleDataset, similar="object_mesh()", public="bunny"):
    path = file("BunnyMesh.ply")


class KnotMesh(SampleDataset, similar="object_mesh()"):
    path = file("KnotMesh.ply")


class EaglePointCloud(SampleDataset, similar="room_cloud()"):
    path = file("EaglePointCloud.ply")


class PCDPointCloud(SampleDataset, similar="room_cloud()", public="indoor-fragment"):
    path = file("fragment.pcd")


class PLYPointCloud(SampleDataset, similar="room_cloud()", public="indoor-fragment"):
    path = file("fragment.ply")


class AvocadoModel(SampleDataset, similar="object_mesh()"):
    path = file("AvocadoModel.glb")


class DamagedHelmetModel(SampleDataset, similar="object_mesh()"):
    path = file("DamagedHelmetModel.glb")


class JackJackL515Bag(SampleDataset, similar="room_frames(24)"):
    path = file("JackJackL515Bag.bag")


class SampleL515Bag(SampleDataset, similar="room_frames(24)"):
    path = file("L515_test_s.bag")


class JuneauImage(SampleDataset):
    path = file("JuneauImage.jpg")


class DemoICPPointClouds(SampleDataset, similar="object_scans()", public="icp-clouds"):
    paths = files("cloud_bin_{}.pcd", range(3))
    transformation_log_path = file("init.log")


class DemoColoredICPPointClouds(SampleDataset, similar="object_scans()"):
    paths = files("frag_{}.ply", (115, 116))


class DemoCropPointCloud(SampleDataset, similar="room_cloud()"):
    point_cloud_path = file("fragment.ply")
    cropped_json_path = file("cropped.json")


class DemoCustomVisualization(SampleDataset, similar="room_cloud()"):
    point_cloud_path = file("fragment.ply")
    camera_trajectory_path = file("camera_trajectory.json")
    render_option_path = file("renderoption.json")


class DemoDopplerICPSequence(SampleDataset, similar="street_scans()"):
    paths = files("xyzd_sequence/{:05d}.xyzd", range(1, 101))
    calibration_path = file("calibration.json")
    trajectory_path = file("ground_truth_poses.txt")


class DemoFeatureMatchingPointClouds(SampleDataset, similar="object_scans()"):
    point_cloud_paths = files("cloud_bin_{}.pcd", range(2))
    fpfh_feature_paths = files("cloud_bin_{}.fpfh.bin", range(2))
    l32d_feature_paths = files("cloud_bin_{}.d32.bin", range(2))


class DemoPoseGraphOptimization(SampleDataset):
    pose_graph_fragment_path = file("pose_graph_example_fragment.json")
    pose_graph_global_path = file("pose_graph_example_global.json")


class LivingRoomPointClouds(SampleDataset, similar="object_scans()", public="living-room-fragments"):
    paths = files("cloud_bin_{}.ply", range(57))


class OfficePointClouds(SampleDataset, similar="object_scans()"):
    paths = files("cloud_bin_{}.ply", range(53))


class SampleNYURGBDImage(SampleDataset, similar="room_frames(1)"):
    color_path = file("NYU_color.ppm")
    depth_path = file("NYU_depth.pgm")


class SampleSUNRGBDImage(SampleDataset, similar="room_frames(1)"):
    color_path = file("SUN_color.jpg")
    depth_path = file("SUN_depth.png")


class SampleTUMRGBDImage(SampleDataset, similar="room_frames(1)", public="tum-frame"):
    color_path = file("TUM_color.png")
    depth_path = file("TUM_depth.png")


class SampleRedwoodRGBDImages(SampleDataset, similar="room_frames(5)", public="redwood-frames"):
    color_paths = files("color/{:05d}.jpg", range(5))
    depth_paths = files("depth/{:05d}.png", range(5))
    trajectory_log_path = file("trajectory.log")
    odometry_log_path = file("odometry.log")
    rgbd_match_path = file("rgbd.match")
    reconstruction_path = file("example_tsdf_pcd.ply")
    camera_intrinsic_path = file("camera_primesense.json")


class SampleFountainRGBDImages(SampleDataset, similar="room_frames(33)"):
    color_paths = files_in("image", ".jpg")
    depth_paths = files_in("depth", ".png")
    keyframe_poses_log_path = file("scene/key.log")
    reconstruction_path = file("scene/integrated.ply")


class BedroomRGBDImages(SampleDataset, similar="room_frames(100)"):
    color_paths = files("image/{:06d}.jpg", range(1, 21931))
    depth_paths = files("depth/{:06d}.png", range(1, 21931))
    trajectory_log_path = file("bedroom.log")
    reconstruction_path = file("bedroom.ply")


class LoungeRGBDImages(SampleDataset, similar="room_frames(100)", public="lounge"):
    color_paths = files("color/{:06d}.png", range(1, 3000))
    depth_paths = files("depth/{:06d}.png", range(1, 3000))
    trajectory_log_path = file("lounge_trajectory.log")
    reconstruction_path = file("lounge.ply")


class RedwoodRoom(SampleDataset, similar="room_frames(100)"):
    """Frames of a synthetic room, and its points and camera poses."""

    _scene: ClassVar[str]
    _numbers: ClassVar[range]
    point_cloud_path = property(lambda self: self._path(f"{self._scene.rstrip('12')}.ply"))
    color_paths = property(lambda self: self._paths("color/{:05d}.jpg", self._numbers))
    depth_paths = property(lambda self: self._paths("depth/{:05d}.png", self._numbers))
    noisy_depth_paths = property(lambda self: self._paths("depth_noisy/{:05d}.png", self._numbers))
    oni_path = property(lambda self: self._path(f"{self._scene}.oni"))
    trajectory_path = property(lambda self: self._path(f"{self._scene}-traj.txt"))
    noise_model_path = file("dist-model.txt")


class RedwoodIndoorLivingRoom1(RedwoodRoom, public="living-room"):
    _scene, _numbers = "livingroom1", range(2870)


class RedwoodIndoorLivingRoom2(RedwoodRoom):
    _scene, _numbers = "livingroom2", range(2350)


class RedwoodIndoorOffice1(RedwoodRoom):
    _scene, _numbers = "office1", range(2690)


class RedwoodIndoorOffice2(RedwoodRoom):
    _scene, _numbers = "office2", range(2538)


class CrateModel(SampleDataset, similar="object_mesh()"):
    path = file("crate.obj")
    path_map = path_map(crate_material="crate.mtl", crate_model="crate.obj", texture_image="crate.jpg")


class MonkeyModel(SampleDataset, similar="object_mesh()"):
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


class SwordModel(SampleDataset, similar="object_mesh()"):
    path = file("UV.obj")
    path_map = path_map(
        sword_material="UV.mtl",
        sword_model="UV.obj",
        base_color="UV_blinn1SG_BaseColor.png",
        metallic="UV_blinn1SG_Metallic.png",
        normal="UV_blinn1SG_Normal.png",
        roughness="UV_blinn1SG_Roughness.png",
    )


_HELMET_PARTS = {
    "glass_plastic": "GlassPlasticMat",
    "leather_parts": "LeatherPartsMat",
    "lenses": "LensesMat",
    "metal_parts": "MetalPartsMat",
    "rubber_wood": "RubberWoodMat",
}
_HELMET_MAPS = {"base": "BaseColor", "normal": "Normal", "occlusion_rough_metal": "OcclusionRoughMetal"}


class FlightHelmetModel(SampleDataset, similar="object_mesh()"):
    path = file("FlightHelmet.gltf")
    path_map = path_map(
        flight_helmet="FlightHelmet.gltf",
        flight_helmet_bin="FlightHelmet.bin",
        **{
            f"mat_{part}_{kind}": f"FlightHelmet_Materials_{material}_{name}.png"
            for part, material in _HELMET_PARTS.items()
            for kind, name in _HELMET_MAPS.items()
        },
    )


class Texture(SampleDataset):
    """Images of a surface by kind."""

    _images: ClassVar[dict[str, str]]
    albedo_texture_path = property(lambda self: self._path(self._images["albedo"]))
    normal_texture_path = property(lambda self: self._path(self._images["normal"]))
    roughness_texture_path = property(lambda self: self._path(self._images["roughness"]))
    path_map = property(lambda self: {key: self._path(name) for key, name in self._images.items()})


def _images(prefix: str, **names: str) -> dict[str, str]:
    """Images with a common prefix by kind."""
    kinds = {"albedo": "Color", "normal": "NormalDX", "roughness": "Roughness"}
    return {kind: f"{prefix}_{name}.jpg" for kind, name in (kinds | names).items()}


class MetalTexture(Texture):
    _images = _images("Metal008", metallic="Metalness")
    metallic_texture_path = file("Metal008_Metalness.jpg")


class PaintedPlasterTexture(Texture):
    _images: ClassVar = _images("PaintedPlaster017") | {"roughness": "noiseTexture.png"}


class TerrazzoTexture(Texture):
    _images = _images("Terrazzo018")


class TilesTexture(Texture):
    _images = _images("Tiles074")


class WoodFloorTexture(Texture):
    _images = _images("WoodFloor050")


class WoodTexture(Texture):
    _images = _images("Wood049")
