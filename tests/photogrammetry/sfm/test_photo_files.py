"""Folders of HEIC, TIFF, WebP and DNG, and masks of images: pixels, orientation, lens, damaged files."""

import importlib
import shutil
import sqlite3
import struct
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from PIL.TiffImagePlugin import IFDRational

import pointloom as loom
from pointloom.io.images import photo_files
from pointloom.photogrammetry.sfm.features import find_features
from pointloom.photogrammetry.sfm.image_folder import read_header, read_image, read_lens, read_orientation
from pointloom.photogrammetry.sfm.settings import SfmSettings

from .conftest import has_pycolmap, left_half, write_images

HEIC = Path(__file__).with_name("telephone.heic")
LENS = ("Maker", "Telephone 1", "5.2", "26", "")


def scene() -> np.ndarray:
    """48 x 64 pixels with colors that increase to the right and down, and a white patch at the upper left."""
    y, x = np.mgrid[0:48, 0:64]
    pixels = np.stack([4 * x, 5 * y, np.full_like(x, 40)], axis=2).astype(np.uint8)
    pixels[4:14, 6:26] = 250
    return pixels


def exif(orientation: int) -> Image.Exif:
    tags = Image.Exif()
    tags[0x010F], tags[0x0110], tags[0x0112] = "Maker", "Telephone 1", orientation
    inner = tags.get_ifd(0x8769)
    inner[0x920A], inner[0xA405] = IFDRational(26, 5), 26
    return tags


def written(folder: Path, name: str) -> np.ndarray:
    with Image.open(folder / name) as image:
        assert image.getexif().get(0x0112, 1) == 1
        return np.array(image.convert("RGB")).astype(int)


def dng(path: Path, gray: np.ndarray, *, cut: int = 0, orientation: int = 1) -> Path:
    """A DNG of one 16-bit mosaic, red first, little-endian, with the minimum of tags for a raw decoder."""
    height, width = gray.shape
    data = gray.astype("<u2").tobytes()
    matrix = [(1, 1) if i % 4 == 0 else (0, 1) for i in range(9)]
    tags: dict[int, tuple[int, list]] = {
        254: (4, [0]), 256: (4, [width]), 257: (4, [height]), 258: (3, [16]), 259: (3, [1]), 262: (3, [32803]),
        271: (2, list(b"Maker\0")), 272: (2, list(b"Telephone 1\0")), 273: (4, [0]), 274: (3, [orientation]),
        277: (3, [1]), 278: (4, [height]), 279: (4, [len(data)]), 33421: (3, [2, 2]), 33422: (1, [0, 1, 1, 2]),
        50706: (1, [1, 4, 0, 0]), 50708: (2, list(b"Maker Telephone 1\0")), 50714: (4, [0]), 50717: (4, [65535]),
        50721: (10, matrix), 50728: (5, [(1, 1)] * 3), 50778: (3, [21]),
    }  # fmt: skip
    forms = {1: "B", 2: "B", 3: "H", 4: "I", 5: "II", 10: "ii"}
    behind = 8 + 2 + 12 * len(tags) + 4
    entries, extra = b"", b""
    for tag, (kind, values) in tags.items():
        body = b"".join(struct.pack(f"<{forms[kind]}", *(v if isinstance(v, tuple) else (v,))) for v in values)
        if tag == 273:
            value_offset = len(entries) + 8
        if len(body) > 4:
            extra += b"\0" * (len(extra) % 2)
            body, extra = struct.pack("<I", behind + len(extra)), extra + body
        entries += struct.pack("<HHI", tag, kind, len(values)) + body.ljust(4, b"\0")
    start = struct.pack("<I", behind + len(extra))
    entries = entries[:value_offset] + start + entries[value_offset + 4 :]
    content = b"II*\0" + struct.pack("<IH", 8, len(tags)) + entries + b"\0" * 4 + extra + data
    path.write_bytes(content[: len(content) - cut])
    return path


def mosaic() -> np.ndarray:
    """A white square at the upper left on gray, 48 x 64."""
    gray = np.full((48, 64), 6000, np.uint16) + np.arange(64, dtype=np.uint16) * 40
    gray[6:18, 8:24] = 50000
    return gray


@pytest.mark.parametrize("orientation", [1, 6])
@pytest.mark.parametrize("name", ["a.tif", "a.webp"])
def test_tiff_and_webp_are_upright_and_keep_their_lens(tmp_path, name, orientation):
    (tmp_path / "in").mkdir()
    options = {"lossless": True} if name.endswith("webp") else {}
    Image.fromarray(scene()).save(tmp_path / "in" / name, exif=exif(orientation).tobytes(), **options)
    choice = loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out", kind="png")
    upright = scene() if orientation == 1 else np.rot90(scene(), 3)
    assert choice.names == ("a.png",) and np.array_equal(written(tmp_path / "out", "a.png"), upright)
    assert read_lens(tmp_path / "in" / name) == LENS == read_lens(tmp_path / "out" / "a.png")


def test_heic_of_a_telephone_is_upright_and_keeps_its_lens(tmp_path):
    pytest.importorskip("pi_heif")
    (tmp_path / "in").mkdir()
    shutil.copy(HEIC, tmp_path / "in" / "IMG_0001.HEIC")
    choice = loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out")
    assert choice.names == ("IMG_0001.jpg",) and choice.sizes == {(48, 64): 1}
    pixels = written(tmp_path / "out", "IMG_0001.jpg")
    error = np.abs(pixels - np.rot90(scene(), 3).astype(int))
    assert np.median(error) < 6 and pixels[8:20, 36:40].min() > 225
    assert read_lens(tmp_path / "out" / "IMG_0001.jpg") == LENS


@pytest.mark.parametrize("kind", ["heic", "webp", "tif", "jpg", "png"])
def test_invalid_exif_is_ignored(tmp_path, rng, kind):
    if kind == "heic":
        pytest.importorskip("pi_heif")
        data = HEIC.read_bytes()
        begin, end = data.index(b"Exif\0\0") - 40, len(data)
    else:
        Image.fromarray(scene()).save(tmp_path / f"whole.{kind}", exif=exif(6))
        data = (tmp_path / f"whole.{kind}").read_bytes()
        begin = max(data.find(mark) for mark in (b"Exif\0\0", b"eXIf", b"EXIF", b"Maker"))
        end = begin + 200
    path = tmp_path / f"a.{kind}"
    for trial in range(40):
        spoiled = bytearray(data)
        at = int(rng.integers(begin, end))
        if kind == "heic" and trial % 2:
            spoiled[at:at] = bytes(4)
        spoiled[at : at + 2] = rng.bytes(2)
        path.write_bytes(spoiled)
        for read in (
            read_lens,
            read_orientation,
            lambda p: loom.photogrammetry.read_image_positions([p]),
            read_upright,
        ):
            try:
                read(path)
            except loom.FileError as error:
                assert str(path) in str(error)


def read_upright(path):
    return read_image(path, read_header(path))


@pytest.mark.parametrize("orientation", [1, 6])
def test_a_dng_is_developed_and_rotated(tmp_path, orientation):
    pytest.importorskip("rawpy")
    (tmp_path / "in").mkdir()
    path = dng(tmp_path / "in" / "raw.dng", mosaic(), orientation=orientation)
    loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out", kind="png")
    pixels = written(tmp_path / "out", "raw.png")
    assert pixels.shape == ((48, 64, 3) if orientation == 1 else (64, 48, 3))
    inside, outside = (pixels[12, 16], pixels[40, 50]) if orientation == 1 else (pixels[16, 35], pixels[50, 7])
    assert inside.min() > 150 and outside.max() < 120 and np.ptp(inside) < 60
    assert read_lens(path)[:2] == LENS[:2]


@pytest.mark.parametrize("fraction", [0.0, 0.9, None])
@pytest.mark.parametrize("kind", ["heic", "tif", "webp", "dng"])
def test_truncated_files_and_those_of_another_kind_are_excluded_and_named(tmp_path, kind, fraction):
    pytest.importorskip({"heic": "pi_heif", "dng": "rawpy"}.get(kind, "PIL"))
    source = write_images(tmp_path / "in", [scene()], ["good.png"])
    complete = tmp_path / f"whole.{kind}"
    if kind == "heic":
        shutil.copy(HEIC, complete)
    elif kind == "dng":
        dng(complete, mosaic())
    else:
        Image.fromarray(scene()).save(complete)
    data = complete.read_bytes()
    data = b"no image at all, but text" * 20 if fraction is None else data[: int(fraction * len(data))]
    (source / f"bad.{kind}").write_bytes(data)
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.names == ("good.png",) and list(choice.left_out) == [f"bad.{kind}"]
    assert f"1 of 2 images cannot be read and are left out: bad.{kind} (" in choice.warnings[0]
    if kind == "dng" and fraction is not None:
        assert choice.left_out["bad.dng"].split(":")[0] == ("cut off" if fraction else "empty")


@pytest.mark.parametrize("tenths", [1, 5, 9])
def test_a_dng_of_any_tenths_of_its_size_is_a_named_error(tmp_path, tenths):
    pytest.importorskip("rawpy")
    path = dng(tmp_path / "a.dng", mosaic())
    data = path.read_bytes()
    path.write_bytes(data[: len(data) * tenths // 10])
    for read in (photo_files.read_photo_header, photo_files.read_photo):
        with pytest.raises(loom.FileError, match=r"a\.dng"):
            read(path)


@pytest.mark.parametrize(("kind", "module"), [("heic", "pi_heif"), ("dng", "rawpy")])
def test_a_missing_extra_is_reported_with_its_install_command(tmp_path, monkeypatch, kind, module):
    real = importlib.import_module

    def missing(name, *rest):
        if name in ("pi_heif", "pillow_heif", "rawpy"):
            raise ImportError(name)
        return real(name, *rest)

    monkeypatch.setattr(importlib, "import_module", missing)
    source = write_images(tmp_path / "in", [scene()], ["a.png"])
    (source / f"b.{kind}").write_bytes(b"x" * 100)
    with pytest.raises(loom.FileError, match=rf'b.{kind}: .{kind} needs the package {module}.*"pointloom\[photos\]"'):
        loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_a_raw_file_beside_its_jpeg_is_the_same_photograph(tmp_path):
    source = write_images(tmp_path / "in", [scene(), scene()], ["IMG_1.jpg", "IMG_2.jpg"])
    (source / "Img_1.DNG").write_bytes(b"not even read")
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out")
    assert choice.names == ("IMG_1.jpg", "IMG_2.jpg") and choice.frame_count == 2
    assert choice.notes == ("left out, since the folder also contains a JPEG or PNG of them: Img_1.DNG",)


def test_deep_gray_tiff_becomes_gray_of_8_bits(tmp_path):
    (tmp_path / "in").mkdir()
    deep = (scene()[..., 0].astype(np.uint16)) * 256
    Image.fromarray(deep).save(tmp_path / "in" / "a.tif")
    loom.photogrammetry.choose_frames(tmp_path / "in", tmp_path / "out", kind="png")
    assert np.abs(written(tmp_path / "out", "a.png")[..., 1] - scene()[..., 0]).max() <= 1
    Image.fromarray(np.ones((48, 64), np.float32)).save(tmp_path / "in" / "b.tif")
    with pytest.raises(loom.FileError, match=r"b\.tif:"):
        photo_files.read_photo(tmp_path / "in" / "b.tif")


SIZE = (120, 160)


def masks_of(folder: Path) -> dict[str, np.ndarray]:
    return {path.name: np.array(Image.open(path)) for path in sorted(folder.iterdir())}


@pytest.mark.parametrize("name", ["a.jpg.png", "a.png", "a.jpg.jpg"])
def test_masks_with_common_names_are_matched(panned, tmp_path, name):
    source = write_images(tmp_path / "in", panned[:2], ["a.jpg", "b.jpg"])
    masks = write_images(tmp_path / "masks", [left_half(SIZE)], [name])
    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out", masks=masks)
    written = masks_of(tmp_path / "out_masks")
    assert list(written) == ["a.jpg.png"] and np.array_equal(written["a.jpg.png"], left_half(SIZE))
    assert choice.notes == ("1 image without a mask, used completely: b.jpg",)


def test_masks_are_rotated_and_scaled_with_their_images(panned, tmp_path):
    (tmp_path / "in").mkdir()
    exif = Image.Exif()
    exif[0x0112] = 6
    Image.fromarray(panned[0]).save(tmp_path / "in" / "a.jpg", exif=exif)
    top = np.ascontiguousarray(np.rot90(left_half(SIZE), 3))
    for drawn in (left_half(SIZE), top):  # on the image as it is stored, or upright
        masks = write_images(tmp_path / f"masks {len(drawn)}", [drawn], ["a.png"])
        out = tmp_path / f"out {len(drawn)}"
        loom.photogrammetry.choose_frames(tmp_path / "in", out, masks=masks, max_size=80)
        (mask,) = masks_of(out.with_name(out.name + "_masks")).values()
        assert mask.shape == (80, 60) and mask[:40].min() == 255 and mask[40:].max() == 0


def test_transparent_pixels_are_masked(panned, tmp_path):
    rgba = np.dstack([*[panned[0]] * 3, left_half(SIZE)])
    source = tmp_path / "in"
    source.mkdir()
    Image.fromarray(rgba).save(source / "a.png")
    Image.fromarray(rgba).save(source / "b.webp", lossless=True)
    loom.photogrammetry.choose_frames(source, tmp_path / "out", masks="alpha")
    written = masks_of(tmp_path / "out_masks")
    assert len(written) == 2 and all(np.array_equal(mask, left_half(SIZE)) for mask in written.values())
    write_images(tmp_path / "plain", panned[:2])
    with pytest.raises(loom.FileError, match="/plain:"):
        loom.photogrammetry.choose_frames(tmp_path / "plain", tmp_path / "new", masks="alpha")
    assert not (tmp_path / "new").exists() and not (tmp_path / "new_masks").exists()


def test_a_function_masks_pixels_or_complete_images(panned, tmp_path):
    source, calls = write_images(tmp_path / "in", panned[:3], ["a.jpg", "b.jpg", "c.jpg"]), []

    def mask_of(pixels, name):
        calls.append((name, pixels.shape))
        return {"a.jpg": left_half(SIZE), "b.jpg": np.zeros(SIZE, bool), "c.jpg": None}[name]

    choice = loom.photogrammetry.choose_frames(source, tmp_path / "out", masks=mask_of)
    assert calls == [(name, (*SIZE, 3)) for name in ("a.jpg", "b.jpg", "c.jpg")]
    assert choice.names == ("a.jpg", "c.jpg") and choice.left_out == {"b.jpg": "its mask excludes all pixels"}
    assert not (tmp_path / "out" / "b.jpg").exists() and list(masks_of(tmp_path / "out_masks")) == ["a.jpg.png"]


def test_masks_that_do_not_fit_are_named(panned, tmp_path):
    source = write_images(tmp_path / "in", panned[:2], ["a.jpg", "b.jpg"])
    black = write_images(tmp_path / "black", [np.zeros(SIZE, np.uint8)] * 2, ["a.png", "b.png"])
    for masks, error, message in (
        (write_images(tmp_path / "wide", [left_half((120, 180))], ["a.png"]), loom.FileError, r"a\.png:"),
        (write_images(tmp_path / "none", []), loom.FileError, r"/in:.*a\.jpg\.png"),
        (black, loom.FileError, r"/in:.*2"),
        (lambda pixels, name: np.ones(SIZE), TypeError, r"masks\(a\.jpg\):.*uint8"),
        (lambda pixels, name: np.ones((5, 5), bool), ValueError, r"masks\(a\.jpg\):.*120.*160"),
        ("nowhere", loom.FileError, r"^nowhere:"),
    ):
        with pytest.raises(error, match=message):
            loom.photogrammetry.choose_frames(source, tmp_path / "out", masks=masks)
    assert not (tmp_path / "out").exists() and not (tmp_path / "out_masks").exists()


@pytest.mark.slow
@pytest.mark.skipif(not has_pycolmap(), reason="pycolmap is not installed")
def test_no_feature_is_detected_in_black_mask_pixels(scene_images, tmp_path):
    images = write_images(tmp_path / "in", scene_images[:2], ["a.png", "b.png"])
    masks = write_images(tmp_path / "masks", [left_half(scene_images[0].shape)], ["a.png.png"])
    features = find_features(images, tmp_path / "f.db", SfmSettings(max_features=500), masks=masks)
    with sqlite3.connect(tmp_path / "f.db") as database:
        rows = dict(database.execute("SELECT image_id, data FROM keypoints"))
    columns = [np.frombuffer(rows[k + 1], np.float32).reshape(n, -1)[:, 0] for k, n in enumerate(features.counts)]
    middle = scene_images[0].shape[1] / 2
    assert columns[0].max() <= middle + 1 and len(columns[0]) > 30 and columns[1].max() > 1.5 * middle
    (masks / "b.png.png").write_bytes((masks / "a.png.png").read_bytes()[:-9])
    with pytest.raises(loom.FileError, match=r"b\.png\.png"):
        find_features(images, tmp_path / "f.db", masks=masks)
