"""A folder of pictures of all directions becomes one of a cube's faces, with masks, and a lens that is known."""

from __future__ import annotations

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


def test_pictures_of_all_directions_become_faces_with_their_masks(tmp_path):
    source = tmp_path / "in"
    source.mkdir()
    (tmp_path / "out").mkdir()
    rng = np.random.default_rng(0)
    for k in range(2):
        Image.fromarray(rng.integers(0, 256, (64, 128, 3), dtype=np.uint8)).save(source / f"{k}.png")

    def not_below(pixels, name):
        return np.arange(len(pixels))[:, None].repeat(pixels.shape[1], 1) < 32

    given = {"max_frames": 9, "masks": not_below, "panorama": True}
    told = motion.take_frames(tmp_path / "out", quiet, source=source, **given)
    names = [f"{k}_{face}.jpg" for k in range(2) for face in ("front", "right", "back", "left", "up")]
    assert told["names"] == names and told["kept"] == 10 and told["frames"] == 2
    assert sorted(path.name for path in (tmp_path / "out").iterdir()) == [motion.PICTURES, motion.MASKS]
    assert sorted(path.name for path in (tmp_path / "out" / motion.PICTURES).iterdir()) == sorted(names)
    up, front = (np.array(Image.open(tmp_path / "out" / motion.MASKS / f"0_{k}.jpg.png")) for k in ("up", "front"))
    assert up.min() == 255 and front[:18].min() == 255 and front[-18:].max() == 0


def test_a_picture_of_a_lens_is_none_of_all_directions(tmp_path):
    source = tmp_path / "in"
    source.mkdir()
    (tmp_path / "out").mkdir()
    pixels = np.random.default_rng(0).integers(0, 256, (60, 80, 3), dtype=np.uint8)
    Image.fromarray(pixels).save(source / "a.png")
    with pytest.raises(loom.FileError, match=r"a\.png:"):
        motion.take_frames(tmp_path / "out", quiet, source=source, max_frames=9, masks=None, panorama=True)
    with pytest.raises(ValueError, match="panorama:"):
        loom.video.Settings(panorama=True, camera_model="OPENCV_FISHEYE")


def test_faces_that_were_not_placed_stand_where_the_others_of_their_picture_say():
    rng = np.random.default_rng(0)
    panorama = Panorama(64, 32)
    camera = loom.CameraModel.from_intrinsic(panorama.intrinsic)
    names = [f"my_sphere_{k}_{face}.jpg" for k in range(3) for face in panorama.names]
    poses = []
    for _ in range(3):
        front, center = np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.normal(size=3)
        front *= np.sign(np.linalg.det(front))
        for turn in panorama.turns:  # from the face's camera to the front one's
            T = np.eye(4)
            T[:3, :3] = turn.T @ front
            T[:3, 3] = -T[:3, :3] @ center
            poses.append(T)
    kept = [k for k in range(18) if k not in (2, 5, 6, 7) and k < 12]  # of the last picture none is placed
    some = loom.SfmModel([names[k] for k in kept], [camera] * len(kept), [poses[k] for k in kept], points=np.eye(3))
    whole, added = with_all_faces(some, names)
    assert sorted(added) == sorted(names[k] for k in (2, 5, 6, 7)) and len(whole) == 12
    for name, T in zip(whole.names, whole.T_camera_world, strict=True):
        np.testing.assert_allclose(T, poses[names.index(name)], atol=1e-12)
    assert with_all_faces(whole, names) == (whole, [])


def off_truth(model, centers) -> np.ndarray:
    """How far cameras are from where they stood [m], after the similarity that fits them."""
    fit = loom.registration.fit_to_positions(model, dict(zip(model.names, centers, strict=True)))
    return np.linalg.norm(model.transform(fit.transformation).centers - centers, axis=1)


@pytest.mark.nightly
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_pictures_of_all_directions_are_placed_where_they_were_taken(tmp_path):
    centers = np.array([film_pose(k / 30)[:3, 3] for k in range(10)])
    spheres = spheres_from([look_along(center, (1.0, 0.15, 0.0)) for center in centers], 384)
    source = write_pictures(tmp_path / "in", spheres, [f"{k}.png" for k in range(10)])
    (tmp_path / "out").mkdir()
    told = motion.take_frames(tmp_path / "out", quiet, source=source, max_frames=10, masks=None, panorama=True)
    lens = Panorama(768, 384).intrinsic
    result = loom.sfm.reconstruct(tmp_path / "out" / motion.PICTURES, tmp_path / "work", intrinsic=lens)
    assert told["kept"] == 60 and result.model is not None and len(result.model) >= 45
    whole, _ = with_all_faces(result.model, told["names"])
    assert len(whole) == 60
    off = off_truth(whole, np.array([centers[int(name[0])] for name in whole.names]))
    assert np.sqrt(np.mean(off**2)) < 0.01, off  # 3 mm; the walk is 2.2 m long


@pytest.mark.nightly
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
@pytest.mark.parametrize("mapper", ["incremental", "global"])
def test_pictures_of_a_fisheye_that_nobody_measured_are_placed_and_it_is_found(tmp_path, mapper):
    poses = np.array([film_pose(k / 60) for k in range(10)])
    lens = loom.CameraModel("OPENCV_FISHEYE", 320, 240, [160, 160, 160, 120, 0.02, -0.01, 0, 0])
    pictures = write_pictures(tmp_path / "in", fisheye_pictures(poses, lens), [f"{k}.png" for k in range(10)])
    result = loom.sfm.reconstruct(pictures, tmp_path / "work", camera_model="OPENCV_FISHEYE", mapper=mapper)
    assert result.model is not None and len(result.model) == 10
    assert result.model.cameras[0].params[0] == pytest.approx(160, rel=0.02)
    off = off_truth(result.model, np.array([poses[int(name[0])][:3, 3] for name in result.model.names]))
    assert np.sqrt(np.mean(off**2)) < 0.005, off
