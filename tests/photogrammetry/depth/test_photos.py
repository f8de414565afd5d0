"""Network inputs from rotated, gray, 16-bit, transparent, tiny, huge and black pictures."""

import math

import numpy as np
import pytest
from PIL import Image

import pointloom as loom
from pointloom.photogrammetry.depth.photos import camera_of, take_photo

from .tiny_networks import linear

UPRIGHT = np.random.default_rng(0).integers(0, 256, (24, 40), dtype=np.uint8).repeat(8, 0).repeat(8, 1)
RGB = np.stack([UPRIGHT, 255 - UPRIGHT, UPRIGHT // 2], -1)

# Stored pixels for each orientation that give this picture upright.
STORED = {
    1: RGB, 2: RGB[:, ::-1], 3: RGB[::-1, ::-1], 4: RGB[::-1], 5: RGB.transpose(1, 0, 2),
    6: np.rot90(RGB, 1), 7: np.rot90(RGB, 2).transpose(1, 0, 2), 8: np.rot90(RGB, -1),
}  # fmt: skip


def exif(**tags):
    made = Image.Exif()
    if "orientation" in tags:
        made[0x0112] = tags.pop("orientation")
    inner = made.get_ifd(0x8769)
    for name, value in tags.items():
        inner[{"f35": 0xA405, "mm": 0x920A, "plane": 0xA20E, "unit": 0xA210, "width": 0xA002}[name]] = value
    return made


@pytest.mark.parametrize(("orientation", "suffix"), [*((each, "png") for each in STORED), (6, "jpg")])
def test_exif_rotates_pictures_upright(tmp_path, orientation, suffix):
    path = tmp_path / f"photo.{suffix}"
    options = {"quality": 100, "subsampling": 0} if suffix == "jpg" else {}
    stored = np.ascontiguousarray(STORED[orientation])
    Image.fromarray(stored).save(path, exif=exif(orientation=orientation), **options)
    photo = take_photo(path)
    np.testing.assert_allclose(photo.color.astype(int), RGB, atol=8 if suffix == "jpg" else 0)
    assert photo.is_rotated == (orientation > 4)
    with Image.open(path) as picture:
        from PIL import ImageOps

        np.testing.assert_array_equal(photo.color, np.asarray(ImageOps.exif_transpose(picture)))


def test_a_rotated_jpeg_requires_an_upright_camera(tmp_path):
    path = tmp_path / "photo.jpg"
    Image.fromarray(np.ascontiguousarray(STORED[6])).save(path, exif=exif(orientation=6))
    model = linear(tmp_path / "m.onnx", size=(28, 28))
    assert loom.estimate_depth(path, model).depth.shape == RGB.shape[:2]
    stored = loom.PinholeCameraIntrinsic(192, 320, 300.0, 300.0, 95.5, 159.5)
    with pytest.raises(ValueError, match=r"^intrinsic:.*320.*192"):
        loom.estimate_depth(path, model, intrinsic=stored)
    with pytest.raises(ValueError, match=r"^align:"):
        loom.estimate_depth(path, model, align=np.ones((320, 192)))


def test_an_unknown_orientation_and_damaged_exif_leave_the_picture_as_it_is(tmp_path):
    path = tmp_path / "photo.jpg"
    Image.fromarray(RGB).save(path, exif=exif(orientation=9))
    assert take_photo(path).color.shape == RGB.shape
    Image.fromarray(RGB).save(path, exif=b"Exif\0\0" + bytes(range(40)))
    assert take_photo(path).focal is None


def test_the_focal_length_comes_from_exif(tmp_path):
    def focal_of(**tags):
        Image.fromarray(RGB).save(tmp_path / "p.jpg", exif=exif(**tags))
        return take_photo(tmp_path / "p.jpg").focal

    diagonal = math.hypot(320, 192)
    assert focal_of(f35=26) == pytest.approx(26 / math.hypot(36, 24) * diagonal)
    assert focal_of(mm=4.25, plane=2000.0, unit=3, width=320) == pytest.approx(4.25 * 200)
    assert focal_of(mm=4.25, plane=2000.0, unit=3, width=4000) is None  # the picture was scaled since
    assert focal_of(mm=4.25) is None
    assert focal_of(f35=0) is None
    Image.fromarray(RGB).save(tmp_path / "p.jpg", exif=exif(f35=26))
    camera, source = camera_of(take_photo(tmp_path / "p.jpg"))
    assert source == "EXIF"
    assert (camera.fx, camera.fy) == (pytest.approx(26 / math.hypot(36, 24) * diagonal),) * 2
    assert (camera.cx, camera.cy) == (159.5, 95.5)


def test_60_degrees_are_assumed_and_reported_without_a_focal_length():
    for size in ((192, 320), (320, 192)):
        camera, source = camera_of(take_photo(np.zeros(size, np.uint8)))
        assert source == "assumed 60 degrees"
        assert 2 * math.degrees(math.atan(160 / camera.fx)) == pytest.approx(60)


def test_gray_deep_and_transparent_pictures_are_taken(tmp_path):
    gray = np.repeat(UPRIGHT[..., None], 3, 2)
    deep = UPRIGHT.astype(np.uint16) * 257
    alpha = np.concatenate([RGB, np.full((*UPRIGHT.shape, 1), 7, np.uint8)], 2)
    files = {
        "gray.png": (Image.fromarray(UPRIGHT), gray), "deep.png": (Image.fromarray(deep), gray),
        "alpha.png": (Image.fromarray(alpha), RGB), "palette.png": (Image.fromarray(UPRIGHT).convert("P"), gray),
    }  # fmt: skip
    for name, (picture, expected) in files.items():
        picture.save(tmp_path / name)
        np.testing.assert_array_equal(take_photo(tmp_path / name).color, expected, err_msg=name)
    for array, expected in ((UPRIGHT, gray), (UPRIGHT[..., None], gray), (deep, gray), (alpha, RGB), (RGB, RGB)):
        np.testing.assert_array_equal(take_photo(array).color, expected)
    np.testing.assert_array_equal(take_photo(np.stack([deep] * 3, -1).astype(">u2")).color, gray)


def test_a_single_pixel_and_a_line_of_pixels_have_a_depth(tmp_path):
    model = loom.DepthModel(linear(tmp_path / "m.onnx"), "midas-v2.1-small")
    line = np.linspace(0, 255, 30).astype(np.uint8)
    result = loom.estimate_depth(line[None], model)
    assert result.depth.shape == (1, 30)
    assert len(result.to_point_cloud()) == 30
    with pytest.raises(loom.FileError, match=r"/m\.onnx \(output 'depth'\):"):  # one color shows no depth
        loom.estimate_depth(np.full((1, 1), 9, np.uint8), model)


def test_a_huge_picture_is_downscaled_first(tmp_path):
    model = loom.DepthModel(linear(tmp_path / "m.onnx"), "midas-v2.1-small")
    picture = np.tile(np.linspace(0, 255, 1500).astype(np.uint8), (1000, 1))
    result = loom.estimate_depth(picture, model)
    assert result.depth.shape == (1000, 1500)
    assert result.enlargement == 1000 / 160  # 171 rows of 256 columns, in multiples of 32
    with pytest.raises(ValueError, match=r"^picture:.*depth-anything-v2"):
        loom.estimate_depth(np.zeros((4, 6000), np.uint8), linear(tmp_path / "d.onnx"))


@pytest.mark.parametrize(
    "content", [b"", b"hello", b"\x89PNG\r\n\x1a\n" + b"\0" * 50, b"\xff\xd8\xff\xe0" + b"\1" * 50]
)
def test_files_that_are_no_pictures_are_rejected(tmp_path, content):
    path = tmp_path / "photo.jpg"
    path.write_bytes(content)
    with pytest.raises(loom.FileError, match=r"photo\.jpg"):
        loom.estimate_depth(path, linear(tmp_path / "m.onnx"))


@pytest.mark.parametrize(
    ("array", "error"),
    [
        (np.zeros((4, 4), np.float32), TypeError), (np.zeros((4, 4), bool), TypeError), (np.zeros(4, "u1"), ValueError),
        (np.zeros((0, 4), np.uint8), ValueError), (np.zeros((4, 4, 2), np.uint8), ValueError),
        (np.zeros((2, 4, 4, 3), np.uint8), ValueError), (None, TypeError), ({}, TypeError),
    ],
)  # fmt: skip
def test_other_arrays_are_refused_by_name(array, error):
    with pytest.raises(error, match="picture:"):
        take_photo(array)
