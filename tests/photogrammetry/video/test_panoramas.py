"""The full chain on small images of the room, and spherical images that become cube faces."""

import importlib.util

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.camera import PinholeCameraIntrinsic
from pointloom.cameras.panoramas import Panorama
from pointloom.datasets.scenes.room import film_pose, look_along, room_views, surface_errors
from pointloom.photogrammetry.sfm.settings import SfmSettings
from pointloom.photogrammetry.sfm.sphere_images import with_all_faces
from pointloom.photogrammetry.video import motion

from ...cli.commands import answer
from ..sfm.conftest import has_pycolmap, silent, write_images


def sampled(image, x, y) -> np.ndarray:
    """Colors between pixels, float64 [n, 3]."""
    i, j = (np.clip(np.floor(at).astype(int), 0, image.shape[axis] - 2) for at, axis in ((x, 1), (y, 0)))
    fx, fy = np.clip(x - i, 0, 1)[:, None], np.clip(y - j, 0, 1)[:, None]
    upper, lower = ((image[row, i] * (1 - fx) + image[row, i + 1] * fx) for row in (j, j + 1))
    return upper * (1 - fy) + lower * fy


def as_image(light, noise_seed, shape) -> np.ndarray:
    noisy = light + np.random.default_rng(noise_seed).normal(0, 2, light.shape)
    return np.clip(np.rint(noisy), 0, 255).astype(np.uint8).reshape(*shape, 3)


def fisheye_images(poses, camera, *, finer=1.5) -> list[np.ndarray]:
    """Images by a CameraModel that unprojects all its pixels, sampled from a pinhole's, `finer` times as dense."""
    v, u = np.mgrid[: camera.height, : camera.width].reshape(2, -1)
    rays = np.asarray(camera.unproject(np.column_stack([u, v]).astype(np.float64)))
    assert np.isfinite(rays).all(), "the lens does not unproject all its pixels"
    slopes = rays[:, :2] / rays[:, 2:]
    focal = finer * float(camera.params[0])
    width, height = (int(2 * np.ceil(1.02 * extent * focal)) for extent in np.abs(slopes).max(axis=0))
    wide = loom.PinholeCameraIntrinsic(width, height, focal, focal, (width - 1) / 2, (height - 1) / 2)
    x, y = (slopes * focal + (wide.cx, wide.cy)).T
    frames = room_views(poses, wide, color_noise=0)
    shape = (camera.height, camera.width)
    return [as_image(sampled(frame.color.astype(np.float64), x, y), k, shape) for k, frame in enumerate(frames)]


def spheres_from(poses, height=256, *, finer=2) -> list[np.ndarray]:
    """Equirectangular images, uint8 [height, 2 height, 3], sampled from six pinholes, `finer` times as dense."""
    faces = Panorama(2 * height, height, side=finer * height // 2)
    lens = faces.intrinsic
    v, u = np.mgrid[:height, : 2 * height].reshape(2, -1)
    longitude, latitude = (u + 0.5) / height * np.pi - np.pi, np.pi / 2 - (v + 0.5) / height * np.pi
    across = np.cos(latitude)
    rays = np.column_stack([across * np.sin(longitude), -np.sin(latitude), across * np.cos(longitude)])
    nearest = np.stack([rays @ rotation[:, 2] for rotation in faces.turns]).argmax(axis=0)
    made = []
    for k, pose in enumerate(np.asarray(poses)):
        light = np.zeros((len(u), 3))
        for n, rotation in enumerate(faces.turns):
            T = np.array(pose, np.float64)
            T[:3, :3] = pose[:3, :3] @ rotation
            face = next(iter(room_views([T], lens, color_noise=0))).color.astype(np.float64)
            x, y, z = (rays[nearest == n] @ rotation).T
            light[nearest == n] = sampled(face, x / z * lens.fx + lens.cx, y / z * lens.fy + lens.cy)
        made.append(as_image(light, k, (height, 2 * height)))
    return made


def test_spherical_images_become_faces_with_masks(tmp_path):
    images = np.random.default_rng(0).integers(0, 256, (2, 64, 128, 3), dtype=np.uint8)
    source = write_images(tmp_path / "in", images, ["0.png", "1.png"])
    (tmp_path / "out").mkdir()

    def not_below(pixels, name):
        return np.arange(len(pixels))[:, None].repeat(pixels.shape[1], 1) < 32

    given = {"max_frames": 9, "masks": not_below, "panorama": True}
    report = motion.take_frames(tmp_path / "out", silent, source=source, **given)
    names = [f"{k}_{face}.jpg" for k in range(2) for face in ("front", "right", "back", "left", "up")]
    assert report["names"] == names and report["kept"] == 10 and report["frames"] == 2
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [motion.IMAGES, motion.MASKS]
    assert sorted(path.name for path in (tmp_path / "out" / motion.IMAGES).iterdir()) == sorted(names)
    up, front = (np.array(Image.open(tmp_path / "out" / motion.MASKS / f"0_{k}.jpg.png")) for k in ("up", "front"))
    assert up.min() == 255 and front[:18].min() == 255 and front[-18:].max() == 0


def test_a_pinhole_image_is_no_spherical_one(tmp_path):
    pixels = np.random.default_rng(0).integers(0, 256, (60, 80, 3), dtype=np.uint8)
    source = write_images(tmp_path / "in", [pixels], ["a.png"])
    (tmp_path / "out").mkdir()
    with pytest.raises(loom.FileError, match=r"a\.png:"):
        motion.take_frames(tmp_path / "out", silent, source=source, max_frames=9, masks=None, panorama=True)
    with pytest.raises(ValueError, match="panorama:"):
        loom.photogrammetry.VideoSettings(panorama=True, camera_model="OPENCV_FISHEYE")


def test_unregistered_faces_take_the_pose_of_their_image():
    rng = np.random.default_rng(0)
    panorama = Panorama(64, 32)
    camera = loom.CameraModel.from_intrinsic(panorama.intrinsic)
    names = [f"my_sphere_{k}_{face}.jpg" for k in range(3) for face in panorama.names]
    poses = []
    for _ in range(3):
        front, center = np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.normal(size=3)
        front *= np.sign(np.linalg.det(front))
        for rotation in panorama.turns:  # from the face's camera to the front one's
            T = np.eye(4)
            T[:3, :3] = rotation.T @ front
            T[:3, 3] = -T[:3, :3] @ center
            poses.append(T)
    registered = [k for k in range(18) if k not in (2, 5, 6, 7) and k < 12]  # of the last image none is placed
    given = [names[k] for k in registered], [camera] * len(registered), [poses[k] for k in registered]
    some = loom.SfmModel(*given, points=np.eye(3))
    complete, added = with_all_faces(some, names)
    assert sorted(added) == sorted(names[k] for k in (2, 5, 6, 7)) and len(complete) == 12
    for name, T in zip(complete.names, complete.T_camera_world, strict=True):
        np.testing.assert_allclose(T, poses[names.index(name)], atol=1e-12)
    assert with_all_faces(complete, names) == (complete, [])


def off_truth(model, centers) -> np.ndarray:
    """Position errors of cameras [m] after the best similarity transform."""
    fit = loom.registration.fit_to_positions(model, dict(zip(model.names, centers, strict=True)))
    return np.linalg.norm(model.transform(fit.transformation).centers - centers, axis=1)


@pytest.mark.nightly
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_spherical_images_have_their_true_position(tmp_path):
    centers = np.array([film_pose(k / 30)[:3, 3] for k in range(10)])
    spheres = spheres_from([look_along(center, (1.0, 0.15, 0.0)) for center in centers], 384)
    source = write_images(tmp_path / "in", spheres, [f"{k}.png" for k in range(10)])
    (tmp_path / "out").mkdir()
    report = motion.take_frames(tmp_path / "out", silent, source=source, max_frames=10, masks=None, panorama=True)
    lens = Panorama(768, 384).intrinsic
    result = loom.photogrammetry.reconstruct_images(
        tmp_path / "out" / motion.IMAGES, tmp_path / "work", SfmSettings(intrinsic=lens)
    )
    assert report["kept"] == 60 and result.model is not None and len(result.model) >= 45
    complete, _ = with_all_faces(result.model, report["names"])
    assert len(complete) == 60
    off = off_truth(complete, np.array([centers[int(name[0])] for name in complete.names]))
    assert np.sqrt(np.mean(off**2)) < 0.01, off  # 3 mm; the walk is 2.2 m long


@pytest.mark.nightly
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
@pytest.mark.parametrize("mapper", ["incremental", "global"])
def test_an_uncalibrated_fisheye_is_calibrated_and_registered(tmp_path, mapper):
    poses = np.array([film_pose(k / 60) for k in range(10)])
    lens = loom.CameraModel("OPENCV_FISHEYE", 320, 240, [160, 160, 160, 120, 0.02, -0.01, 0, 0])
    images = write_images(tmp_path / "in", fisheye_images(poses, lens), [f"{k}.png" for k in range(10)])
    settings = SfmSettings(camera_model="OPENCV_FISHEYE", mapper=mapper)
    result = loom.photogrammetry.reconstruct_images(images, tmp_path / "work", settings)
    assert result.model is not None and len(result.model) == 10
    assert result.model.cameras[0].params[0] == pytest.approx(160, rel=0.02)
    off = off_truth(result.model, np.array([poses[int(name[0])][:3, 3] for name in result.model.names]))
    assert np.sqrt(np.mean(off**2)) < 0.005, off


COUNT, WIDTH, HEIGHT, FOCAL = 9, 320, 240, 262.5
SIZE = 240  # of the images for depth: a pixel is 1 cm at 2 m
EYE, RIGHT, TARGET = np.array([2.5, 2.05, 1.6]), np.array([-0.907, 0.422, 0.0]), np.array([1.6, 0.1, 1.0])


@pytest.fixture(scope="module")
def views():
    """A meter from left to right, alternating up and down, looking at the middle of the bookcase."""
    camera = PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, (WIDTH - 1) / 2, (HEIGHT - 1) / 2)
    poses = []
    for k, side in enumerate(np.linspace(-1, 1, COUNT)):
        eye = EYE + 0.5 * side * RIGHT + 0.1 * (-1) ** k * np.array([0, 0, 1])
        poses.append(look_along(eye, tuple(TARGET - eye)))
    return room_views(np.array(poses), camera)


@pytest.fixture(scope="module")
def photos(views, tmp_path_factory):
    folder = tmp_path_factory.mktemp("photos")
    for k in range(COUNT):
        Image.fromarray(views.read(k).color).save(folder / f"photo_{k}.png")
    return folder


@pytest.fixture(scope="module")
def made(photos, tmp_path_factory):
    """The report of one run, and its folder."""
    if importlib.util.find_spec("pycolmap") is None:  # never imported beside NumPy
        pytest.skip("the extra sfm is not there")
    folder = tmp_path_factory.mktemp("made")
    outputs = ("-o", folder / "mesh.ply", "--trajectory", folder / "poses.log", "--work", folder / "work")
    return answer("video", photos, *outputs, "--max-size", SIZE, "--device", "cpu"), folder


def true_points(views):
    """Points of every 4th pixel of every image, in the room [m]."""
    v, u = (each.reshape(-1) for each in np.mgrid[0:HEIGHT:4, 0:WIDTH:4])
    rays = np.stack([(u - (WIDTH - 1) / 2) / FOCAL, (v - (HEIGHT - 1) / 2) / FOCAL, np.ones(len(u))], axis=1)
    points = []
    for k in range(COUNT):
        frame = views.read(k)
        depth = np.asarray(frame.depth, np.float64)[v, u]
        points.append((rays * depth[:, None])[depth > 0] @ frame.T_world_camera[:3, :3].T + frame.T_world_camera[:3, 3])
    return np.concatenate(points)


def errors_of_cameras(folder, views):
    """Errors of the cameras after the best similarity transform to the true ones."""
    path = loom.read_trajectory(folder / "poses.log")
    assert path.ids[:, 0].tolist() == list(range(COUNT))  # the numbers in the photos' names
    truth = loom.Trajectory(views.poses)
    return loom.registration.evaluate_trajectory(loom.Trajectory(path.poses), truth, with_scale=True)


@pytest.mark.slow
def test_photos_alone_give_accurate_poses_and_surface(made, views):
    report, folder = made
    assert (report["model"]["registered_count"], report["units"], report["reliable"]) == (COUNT, "arbitrary", True)
    assert report["fused"]["fraction"] > 0.6
    errors = errors_of_cameras(folder, views)
    assert errors.absolute_translation.rmse < 0.005 * np.linalg.norm(np.ptp(views.poses[:, :3, 3], axis=0))
    mesh = loom.read_triangle_mesh(folder / "mesh.ply").transform(errors.transformation)
    away, scene = surface_errors(mesh.vertices), loom.RaycastingScene()
    scene.add_triangles(mesh)
    assert np.median(away) < 0.01
    assert np.mean(away <= 0.02) > 0.9
    assert np.mean(scene.compute_distance(true_points(views).astype(np.float32)) <= 0.02) > 0.6
