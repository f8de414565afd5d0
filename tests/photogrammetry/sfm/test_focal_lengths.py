"""Photographs of several lenses, of a wrongly given lens, and without a focal length in EXIF."""

import sqlite3

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.settings import SfmSettings

from .conftest import has_pycolmap, write_images
from .scene import FOCAL, HEIGHT, WIDTH, camera_path, image

COUNT = 8


@pytest.fixture(autouse=True)
def _wants_colmap():
    if not has_pycolmap():
        pytest.skip("pycolmap is not installed")


def exif_of(film: int, *, focal: float | tuple[int, int] = 4.25) -> Image.Exif:
    """EXIF of a telephone with a focal length, and its 35 mm equivalent."""
    exif = Image.Exif()
    exif[0x010F], exif[0x0110], exif[0x8769] = "Maker", "Phone 1", {0x920A: focal, 0xA405: film}
    return exif


def write_photographs(folder, images, films) -> None:
    folder.mkdir()
    for k, (pixels, film) in enumerate(zip(images, films, strict=True)):
        options = {} if film is None else {"exif": exif_of(film)}
        Image.fromarray(pixels).save(folder / f"{k}.jpg", quality=95, **options)


def cameras_of(database) -> list[tuple[float, int]]:
    """Focal lengths of the cameras of a database, and whether EXIF gave them."""
    with sqlite3.connect(database) as connection:
        rows = connection.execute("SELECT params, prior_focal_length FROM cameras ORDER BY 1").fetchall()
    return sorted((float(np.frombuffer(params)[0]), prior) for params, prior in rows)


@pytest.mark.slow
def test_images_of_one_size_are_grouped_into_cameras_by_exif(scene_images, tmp_path):
    write_photographs(tmp_path / "photos", scene_images[:5], [28, 50, 28, None, 50])
    choice = loom.photogrammetry.choose_frames(tmp_path / "photos", tmp_path / "frames")
    assert any("EXIF contains 3 cameras or focal lengths" in remark for remark in choice.notes)
    features = find_features(tmp_path / "frames", tmp_path / "f.db", SfmSettings(max_features=100))
    assert (features.camera_count, features.sizes) == (3, {(WIDTH, HEIGHT): 5})
    diagonal = np.hypot(WIDTH, HEIGHT) / np.hypot(36, 24)
    expected = sorted([(0.85 * WIDTH, 0), (28 * diagonal, 1), (50 * diagonal, 1)])
    assert cameras_of(tmp_path / "f.db") == [(pytest.approx(focal, rel=1e-3), prior) for focal, prior in expected]
    known = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, FOCAL, FOCAL, 159.5, 119.5)
    one = find_features(tmp_path / "frames", tmp_path / "g.db", SfmSettings(max_features=100, intrinsic=known))
    assert one.camera_count == 1 and [focal for focal, _ in cameras_of(tmp_path / "g.db")] == [FOCAL]


@pytest.mark.slow
def test_an_unrecorded_zoom_becomes_two_cameras(tmp_path):
    images = [image(T, FOCAL * (1.5 if k % 2 else 1.0)) for k, T in enumerate(camera_path(COUNT))]
    result = loom.photogrammetry.reconstruct_images(
        write_images(tmp_path / "p", images), tmp_path / "work", SfmSettings(max_features=800)
    )
    assert result.model is not None and len(result.model) == COUNT and len(set(result.model.cameras)) == 2
    for name, camera in zip(result.model.names, result.model.cameras, strict=True):
        factor = 1.5 if int(name.split()[1][0]) % 2 else 1.0
        assert camera.params[0] == pytest.approx(factor * FOCAL, rel=0.03)
    assert "2 cameras with different focal lengths do" in " ".join(result.quality.notes)


@pytest.mark.slow
def test_a_wrong_given_camera_is_reported_with_both_focal_lengths(scene_images, tmp_path):
    images = write_images(tmp_path / "p", scene_images)
    wrong = loom.PinholeCameraIntrinsic(WIDTH, HEIGHT, 1.2 * FOCAL, 1.2 * FOCAL, 159.5, 119.5)
    result = loom.photogrammetry.reconstruct_images(
        images, tmp_path / "work", SfmSettings(max_features=800, intrinsic=wrong)
    )
    assert not result.reliable and "given focal length is 360 px" in str(result.warnings)
    assert result.quality.focal is not None and result.quality.focal.found == pytest.approx(FOCAL, rel=0.03)


@pytest.mark.slow
@pytest.mark.parametrize("film", [None, 32])
def test_forward_motion_keeps_the_focal_length_of_exif(tmp_path, film):
    poses = [np.eye(4) for _ in range(COUNT)]
    for k, T in enumerate(poses):
        T[2, 3] = -0.12 * k
    write_photographs(tmp_path / "p", [image(T) for T in poses], [film] * COUNT)
    result = loom.photogrammetry.reconstruct_images(tmp_path / "p", tmp_path / "work", SfmSettings(max_features=800))
    assert result.model is not None
    if film is None:
        assert not result.reliable and "the images do not determine the focal length" in str(result.warnings)
    else:
        expected = 32 * np.hypot(WIDTH, HEIGHT) / np.hypot(36, 24)  # 296 of 300
        assert result.model.cameras[0].params[0] == pytest.approx(expected, rel=1e-3)
        assert "EXIF's 295.8 px" in " ".join(result.quality.notes)
        assert result.reliable or "focal length" not in str(result.warnings)
