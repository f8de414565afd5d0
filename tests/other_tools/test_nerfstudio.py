"""Files for nerfstudio, read by its own parser of data sets: rays of its cameras, and points."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import pointloom as loom

LENSES = {
    "pinhole": loom.CameraModel("PINHOLE", 64, 48, [50, 51, 31, 23]),
    "simple_pinhole": loom.CameraModel("SIMPLE_PINHOLE", 48, 64, [50, 24, 32]),
    "simple_radial": loom.CameraModel("SIMPLE_RADIAL", 64, 48, [50, 32, 24, -0.05]),
    "radial": loom.CameraModel("RADIAL", 64, 48, [50, 32, 24, -0.05, 0.01]),
    "opencv": loom.CameraModel("OPENCV", 64, 48, [50, 50.5, 32.2, 24.1, -0.1, 0.02, 0.001, -0.002]),
    "full_opencv": loom.CameraModel("FULL_OPENCV", 64, 48, [50, 50.5, 32, 24, -0.1, 0.02, 0.001, 0, 0.003, 0, 0, 0]),
    "fisheye": loom.CameraModel("OPENCV_FISHEYE", 64, 48, [30, 30.5, 32.2, 24.1, -0.02, 0.002, 0.001, -0.0002]),
}


def model_of(cameras: list[loom.CameraModel]) -> loom.SfmModel:
    rng = np.random.default_rng(0)
    poses = np.tile(np.eye(4), (len(cameras), 1, 1))
    poses[:, :3, :3] = Rotation.random(len(cameras), random_state=0).as_matrix()
    poses[:, :3, 3] = 3 * rng.normal(size=(len(cameras), 3))
    names = [f"{k}.png" for k in range(len(cameras))]
    colors = rng.integers(0, 256, (100, 3)).astype(np.uint8)
    return loom.SfmModel(names, cameras, poses, points=3 * rng.normal(size=(100, 3)), colors=colors)


def parsed(folder: Any, **options: Any) -> Any:
    parsers = pytest.importorskip("nerfstudio.data.dataparsers.nerfstudio_dataparser", exc_type=ImportError)
    config = parsers.NerfstudioDataParserConfig(
        data=folder, center_method="none", auto_scale_poses=False, load_3D_points=True, eval_mode="all", **options
    )
    return config.setup().get_dataparser_outputs("train")


@pytest.mark.filterwarnings("ignore")  # torch warns of indexing in nerfstudio, Python of its open images
@pytest.mark.parametrize("kinds", [[name for name in LENSES if name != "fisheye"], ["fisheye"] * 2])
def test_the_parser_of_nerfstudio_has_the_rays_and_points_of_a_model(tmp_path, kinds):
    torch = pytest.importorskip("torch", exc_type=ImportError)
    model = model_of([LENSES[kind] for kind in kinds])
    loom.write_transforms(tmp_path / "transforms.json", model, images="images")
    (tmp_path / "images").mkdir()
    for name, camera in zip(model.names, model.cameras, strict=True):
        loom.write_image(tmp_path / "images" / name, np.zeros((camera.height, camera.width, 3), np.uint8))
    scene = parsed(tmp_path, orientation_method="none")
    assert [path.name for path in scene.image_filenames] == list(model.names)
    np.testing.assert_allclose(scene.metadata["points3D_xyz"].numpy(), model.points, atol=1e-6)
    np.testing.assert_array_equal(scene.metadata["points3D_rgb"].numpy(), model.colors)
    for k, camera in enumerate(model.cameras):
        pixels = np.random.default_rng(k).uniform(0.1, 0.9, (50, 2)) * [camera.width, camera.height]
        corner = torch.tensor(pixels[:, ::-1] + 0.5, dtype=torch.float32)  # row, column from the image's corner
        rays = scene.cameras.generate_rays(torch.full((50, 1), k), coords=corner)
        T = model.T_world_camera[k]
        np.testing.assert_allclose(rays.origins.numpy(), np.tile(T[:3, 3], (50, 1)), atol=1e-6)
        seen = camera.project((rays.origins.numpy() + 2 * rays.directions.numpy() - T[:3, 3]) @ T[:3, :3])
        np.testing.assert_allclose(seen, pixels, atol=2e-3, err_msg=camera.model)  # float32 [px]


@pytest.mark.filterwarnings("ignore")
def test_the_parser_of_nerfstudio_reads_a_training_folder(tmp_path):
    model = model_of([LENSES["opencv"], LENSES["pinhole"]])
    images = [np.full((camera.height, camera.width, 3), 90, np.uint8) for camera in model.cameras]
    loom.photogrammetry.write_training_folder(tmp_path / "scene", model, images)
    scene = parsed(tmp_path / "scene", orientation_method="none")
    back = loom.read_cameras(tmp_path / "scene/transforms.json")
    assert [path.exists() for path in scene.image_filenames] == [True, True]
    np.testing.assert_allclose(scene.metadata["points3D_xyz"].numpy(), model.points, atol=1e-6)
    for k, camera in enumerate(back.cameras):
        fx, fy, cx, cy = (float(getattr(scene.cameras, name)[k]) for name in ("fx", "fy", "cx", "cy"))
        np.testing.assert_allclose([fx, fy, cx, cy], camera.params[:4], rtol=1e-6)
        np.testing.assert_allclose(
            scene.cameras.camera_to_worlds[k, :, 3].numpy(), model.T_world_camera[k, :3, 3], atol=1e-6
        )
