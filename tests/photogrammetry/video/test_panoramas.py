"""A folder of spherical pictures becomes one of cube faces, with masks and a known lens."""

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.cameras.panoramas import Panorama
from pointloom.datasets.scenes.room import film_pose, look_along
from pointloom.photogrammetry.sfm.sphere_pictures import with_all_faces
from pointloom.photogrammetry.video import motion

from ..sfm.conftest import has_pycolmap, write_pictures
from .room_pictures import fisheye_pictures, spheres_from


def quiet(*_):
    pass


def test_spherical_pictures_become_faces_with_masks(tmp_path):
    pictures = np.random.default_rng(0).integers(0, 256, (2, 64, 128, 3), dtype=np.uint8)
    source = write_pictures(tmp_path / "in", pictures, ["0.png", "1.png"])
    (tmp_path / "out").mkdir()

    def not_below(pixels, name):
        return np.arange(len(pixels))[:, None].repeat(pixels.shape[1], 1) < 32

    given = {"max_frames": 9, "masks": not_below, "panorama": True}
    report = motion.take_frames(tmp_path / "out", quiet, source=source, **given)
    names = [f"{k}_{face}.jpg" for k in range(2) for face in ("front", "right", "back", "left", "up")]
    assert report["names"] == names and report["kept"] == 10 and report["frames"] == 2
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [motion.PICTURES, motion.MASKS]
    assert sorted(path.name for path in (tmp_path / "out" / motion.PICTURES).iterdir()) == sorted(names)
    up, front = (np.array(Image.open(tmp_path / "out" / motion.MASKS / f"0_{k}.jpg.png")) for k in ("up", "front"))
    assert up.min() == 255 and front[:18].min() == 255 and front[-18:].max() == 0


def test_a_pinhole_picture_is_no_spherical_one(tmp_path):
    pixels = np.random.default_rng(0).integers(0, 256, (60, 80, 3), dtype=np.uint8)
    source = write_pictures(tmp_path / "in", [pixels], ["a.png"])
    (tmp_path / "out").mkdir()
    with pytest.raises(loom.FileError, match=r"a\.png:"):
        motion.take_frames(tmp_path / "out", quiet, source=source, max_frames=9, masks=None, panorama=True)
    with pytest.raises(ValueError, match="panorama:"):
        loom.video.Settings(panorama=True, camera_model="OPENCV_FISHEYE")


def test_unregistered_faces_take_the_pose_of_their_picture():
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
    registered = [k for k in range(18) if k not in (2, 5, 6, 7) and k < 12]  # of the last picture none is placed
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
def test_spherical_pictures_have_their_true_position(tmp_path):
    centers = np.array([film_pose(k / 30)[:3, 3] for k in range(10)])
    spheres = spheres_from([look_along(center, (1.0, 0.15, 0.0)) for center in centers], 384)
    source = write_pictures(tmp_path / "in", spheres, [f"{k}.png" for k in range(10)])
    (tmp_path / "out").mkdir()
    report = motion.take_frames(tmp_path / "out", quiet, source=source, max_frames=10, masks=None, panorama=True)
    lens = Panorama(768, 384).intrinsic
    result = loom.sfm.reconstruct(tmp_path / "out" / motion.PICTURES, tmp_path / "work", intrinsic=lens)
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
    pictures = write_pictures(tmp_path / "in", fisheye_pictures(poses, lens), [f"{k}.png" for k in range(10)])
    result = loom.sfm.reconstruct(pictures, tmp_path / "work", camera_model="OPENCV_FISHEYE", mapper=mapper)
    assert result.model is not None and len(result.model) == 10
    assert result.model.cameras[0].params[0] == pytest.approx(160, rel=0.02)
    off = off_truth(result.model, np.array([poses[int(name[0])][:3, 3] for name in result.model.names]))
    assert np.sqrt(np.mean(off**2)) < 0.005, off
