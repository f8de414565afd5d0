"""Depth maps and pictures: read bit for bit, or refused; a damaged PNG is never read as another picture."""

from __future__ import annotations

import io
import os
import struct
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image, ImageFile

from pointloom.pcd.errors import FileError
from pointloom.pcd.io.image_files import PictureHeader, read_color, read_depth, read_picture_header, write_png

DATA = os.environ.get("POINTLOOM_DATA")
needs_data = pytest.mark.skipif(not DATA, reason="POINTLOOM_DATA is not set: no real pictures")
BITS = settings(
    max_examples=250, derandomize=True, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)


@pytest.fixture
def depth() -> np.ndarray:
    depth = np.random.default_rng(0).integers(0, 2**16, (24, 32), np.uint16)
    depth[0, :4] = 0, 1, 255, 65535
    return depth


@pytest.fixture
def color() -> np.ndarray:
    return np.random.default_rng(1).integers(0, 256, (24, 32, 3), np.uint8)


def png_of(width: int, height: int, *streams: bytes, bits: int = 16, color_type: int = 0, interlace: int = 0) -> bytes:
    """A PNG of sound chunks: a header that says this, and the streams as they are."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, interlace)
    parts = [chunk(b"IHDR", head), *(chunk(b"IDAT", stream) for stream in streams), chunk(b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def png_claiming(width: int, height: int) -> bytes:
    """A PNG with a sound header of this size and no pixels to speak of."""
    return png_of(width, height, zlib.compress(bytes(64)))


def test_depth_comes_back_bit_for_bit(tmp_path, depth):
    write_png(tmp_path / "d.png", depth)
    again = read_depth(tmp_path / "d.png")
    assert again.dtype == np.uint16 and again.flags.writeable and np.array_equal(again, depth)


def test_color_comes_back_bit_for_bit(tmp_path, color):
    write_png(tmp_path / "c.png", color)
    again = read_color(tmp_path / "c.png")
    assert again.dtype == np.uint8 and again.flags.writeable and np.array_equal(again, color)


@pytest.mark.parametrize("view", ["transposed", "every other", "other byte order"])
def test_any_memory_layout_is_written_as_it_looks(tmp_path, depth, view):
    array = {"transposed": depth.T, "every other": depth[::2, ::-2], "other byte order": depth.astype(">u2")}[view]
    write_png(tmp_path / "d.png", array)
    assert np.array_equal(read_depth(tmp_path / "d.png"), array)


def test_open3d_reads_what_we_write(tmp_path, depth, color):
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    for name, array in (("d.png", depth), ("c.png", color), ("g.png", color[:, :, 0])):
        write_png(tmp_path / name, array)
        assert np.array_equal(np.asarray(o3d.io.read_image(str(tmp_path / name))), array)


@needs_data
def test_real_frames_are_read_as_open3d_reads_them():
    o3d = pytest.importorskip("open3d", exc_type=ImportError)
    folder = Path(str(DATA))
    for path in ("rgbd-7scenes-redkitchen/frame-000007.depth.png", "rgbd-cupoch-redwood5/depth/00003.png"):
        assert np.array_equal(read_depth(folder / path), np.asarray(o3d.io.read_image(str(folder / path))))
    path = folder / "rgbd-cupoch-redwood5/color/00003.jpg"
    theirs = np.asarray(o3d.io.read_image(str(path))).astype(int)
    assert np.abs(read_color(path).astype(int) - theirs).max() <= 3  # two JPEG decoders round differently


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGBA", "CMYK"])
def test_every_kind_of_picture_becomes_rgb(tmp_path, color, mode):
    name = "c.jpg" if mode == "CMYK" else "c.png"
    picture = Image.fromarray(color).convert(mode)
    picture.save(tmp_path / name)
    again = read_color(tmp_path / name)
    assert again.shape == (24, 32, 3) and again.dtype == np.uint8
    if mode != "CMYK":
        assert np.array_equal(again, np.asarray(picture.convert("RGB")))


def test_transparency_is_dropped_and_does_not_darken(tmp_path, color):
    rgba = np.concatenate([color, np.zeros((24, 32, 1), np.uint8)], axis=2)
    Image.fromarray(rgba).save(tmp_path / "c.png")
    assert np.array_equal(read_color(tmp_path / "c.png"), color)
    palette = Image.fromarray(color).convert("P")
    palette.save(tmp_path / "p.png", transparency=bytes(range(256)))
    assert np.array_equal(read_color(tmp_path / "p.png"), np.asarray(palette.convert("RGB")))


def test_float_depth_comes_from_npy_and_keeps_nan(tmp_path):
    depth = np.array([[0.0, 1.5, np.nan], [np.inf, -1.0, 3.25]], np.float32)
    for k, array in enumerate((depth, np.asfortranarray(depth), depth.astype(">f4"))):
        np.save(tmp_path / f"{k}.npy", array)
        again = read_depth(tmp_path / f"{k}.npy")
        assert again.dtype == np.float32 and again.dtype.isnative and again.flags.c_contiguous and again.flags.writeable
        np.testing.assert_array_equal(again, depth)


def test_headers_tell_size_and_kind_without_the_pixels(tmp_path, depth, color):
    write_png(tmp_path / "d.png", depth)
    (tmp_path / "d.png").write_bytes((tmp_path / "d.png").read_bytes()[:33])
    assert read_picture_header(tmp_path / "d.png") == PictureHeader("png", 32, 24, 1, 16)
    Image.fromarray(color).save(tmp_path / "c.jpg")
    assert read_picture_header(tmp_path / "c.jpg") == PictureHeader("jpeg", 32, 24, 3, 8)


@pytest.mark.parametrize("mode", ["L", "RGB", "RGBA", "P"])
def test_pictures_are_not_taken_for_depth(tmp_path, color, mode):
    Image.fromarray(color).convert(mode).save(tmp_path / "c.png")
    with pytest.raises(FileError, match=r"expected a depth map.*16-bit grey PNG"):
        read_depth(tmp_path / "c.png")


def test_jpeg_is_not_taken_for_depth_nor_depth_for_color(tmp_path, depth, color):
    Image.fromarray(color).save(tmp_path / "c.jpg")
    with pytest.raises(FileError, match="expected a depth map, got a JPEG"):
        read_depth(tmp_path / "c.jpg")
    write_png(tmp_path / "d.png", depth)
    with pytest.raises(FileError, match=r"c\.png|d\.png.*read_depth"):
        read_color(tmp_path / "d.png")


@pytest.mark.parametrize(
    ("data", "claim"),
    [
        (b"", "empty"),
        (b"P5 2 2 65535\n", "neither PNG nor JPEG"),
        (b"\x89PNG\r\n\x1a\n", "damaged PNG header"),
        (b"\xff\xd8\xff\xe0", "damaged picture"),
        (png_claiming(2**20, 2**20), "1048576 x 1048576"),
        (png_claiming(2**31 - 1, 1), "expected 1 to"),
        (png_claiming(0, 5), "expected 1 to"),
        (png_claiming(400, 300), "take 240300 bytes, but its stream of pixels holds 64"),
        (png_claiming(4, 4)[:-12], "the end of the PNG is missing"),
        (png_claiming(2**14, 2**14), "take 536887296 bytes"),
        (b"\x93NUMPY", ".npy header"),
        (b"\x93NUMPY\x07\x00" + bytes(200), ".npy header"),
    ],
)
def test_damaged_files_are_refused(tmp_path, data, claim):
    path = tmp_path / "x.png"
    path.write_bytes(data)
    with pytest.raises(FileError, match=r"x\.png") as caught:
        read_depth(path)
    assert claim in str(caught.value)


@pytest.mark.parametrize(
    "array",
    [
        np.zeros((2, 3)),
        np.zeros((2, 3), np.int32),
        np.zeros((1, 2, 3), np.float32),
        np.zeros((0, 3), np.float32),
        np.array([[None]]),
    ],
)
def test_other_arrays_are_no_depth(tmp_path, array):
    np.save(tmp_path / "d.npy", array, allow_pickle=True)
    with pytest.raises(FileError, match=r"d\.npy"):
        read_depth(tmp_path / "d.npy")


def test_an_npy_header_whose_shape_is_no_number_is_refused(tmp_path):
    path = tmp_path / "d.npy"
    np.save(path, np.ones((1, 4), np.float32))
    path.write_bytes(path.read_bytes().replace(b"(1, 4), }   ", b"(True, 4), }"))
    with pytest.raises(FileError, match=r"d\.npy: damaged \.npy header: its shape is \(True, 4\)"):
        read_depth(path)


def test_npy_that_announces_more_than_it_holds_is_refused_before_allocation(tmp_path):
    np.save(tmp_path / "d.npy", np.zeros((10, 10), np.float32))
    data = (tmp_path / "d.npy").read_bytes()
    (tmp_path / "d.npy").write_bytes(data[:-1])
    with pytest.raises(FileError, match="399 bytes of data, 400 announced"):
        read_depth(tmp_path / "d.npy")
    (tmp_path / "d.npy").write_bytes(data.replace(b"(10, 10)", b"(99999, 99999)"))
    with pytest.raises(FileError, match="pixels, got 99999 x 99999"):
        read_depth(tmp_path / "d.npy")


def test_missing_files_and_folders_are_file_errors(tmp_path):
    for read in (read_depth, read_color, read_picture_header):
        for path in (tmp_path / "none.png", tmp_path):
            with pytest.raises(FileError, match="cannot be read"):
                read(path)


def test_cut_off_pictures_are_errors_at_every_length(tmp_path, depth, color):
    assert not ImageFile.LOAD_TRUNCATED_IMAGES
    write_png(tmp_path / "d.png", depth)
    data = (tmp_path / "d.png").read_bytes()
    for length in range(0, len(data), 7):
        (tmp_path / "d.png").write_bytes(data[:length])
        with pytest.raises(FileError):
            read_depth(tmp_path / "d.png")
    file = io.BytesIO()
    Image.fromarray(color).save(file, "JPEG")
    for length in range(0, len(file.getvalue()) - 16, 23):
        (tmp_path / "c.jpg").write_bytes(file.getvalue()[:length])
        with pytest.raises(FileError):
            read_color(tmp_path / "c.jpg")


DEEP = {"bits": 16, "color_type": 0}
RED_GREEN_BLUE = {"bits": 8, "color_type": 2}


@pytest.mark.parametrize(("kind", "pixel", "read"), [(DEEP, 2, read_depth), (RED_GREEN_BLUE, 3, read_color)])
@pytest.mark.parametrize(
    ("rows", "cut", "claim"),
    [
        (24, 0, None),
        (12, 0, "but its stream of pixels holds"),
        (23, 0, "but its stream of pixels holds"),
        (0, 0, "but its stream of pixels holds 0"),
        (25, 0, "but its stream of pixels holds more"),
        (48, 0, "but its stream of pixels holds more"),
        (24, 1, "lacks its end and checksum"),
        (24, 4, "lacks its end and checksum"),
        (24, 30, "but its stream of pixels holds"),
    ],
)
def test_a_png_whose_stream_does_not_fit_its_header_is_refused(tmp_path, kind, pixel, read, rows, cut, claim):
    rng, path = np.random.default_rng(2), tmp_path / "x.png"
    stream = zlib.compress(b"".join(b"\0" + rng.bytes(32 * pixel) for _ in range(rows)))
    path.write_bytes(png_of(32, 24, stream[: len(stream) - cut], **kind))
    if claim is None:
        assert read(path).shape[:2] == (24, 32)
        return
    with pytest.raises(FileError, match=r"x\.png \(IDAT\)") as caught:
        read(path)
    assert claim in str(caught.value)


@pytest.mark.parametrize(("width", "height"), [(48, 32), (24, 64), (12, 32), (24, 16), (10_000, 10_000), (33, 24)])
def test_a_png_whose_header_was_changed_is_refused_with_sound_checksums(tmp_path, depth, width, height):
    write_png(tmp_path / "d.png", depth)
    data = bytearray((tmp_path / "d.png").read_bytes())
    data[16:24] = struct.pack(">II", width, height)
    (tmp_path / "d.png").write_bytes(with_checksums(bytes(data)))
    with pytest.raises(FileError, match="stream of pixels holds"):
        read_depth(tmp_path / "d.png")


def test_what_else_a_png_may_not_have_is_refused(tmp_path, monkeypatch):
    monkeypatch.setattr(ImageFile, "LOAD_TRUNCATED_IMAGES", True)  # with which Pillow goes on behind an error
    row = b"\0" + bytes(8)
    whole = zlib.compress(row * 4)
    cases = {
        "goes on behind its end": png_of(4, 4, whole + b"more"),
        "not zlib's": png_of(4, 4, b"no stream"),
        "unknown filter": png_of(4, 4, zlib.compress(row * 3 + b"\5" + bytes(8))),
        "no 16 bits a channel for colour type 3": png_of(4, 4, whole, color_type=3),
        "interlacing 2": png_of(4, 4, whole, interlace=2),
        "holds 36": png_of(4, 4, whole, interlace=1),
    }
    sound = png_of(4, 4, whole[:5], whole[5:])
    cases["not in one run"] = sound[:-12] + sound[8:33].replace(b"IHDR", b"tEXt") + sound[33:]
    cases["a second PNG header"] = sound[:33] + sound[8:]
    cases["a chunk 'CRIT' that is unknown"] = sound[:33] + sound[8:33].replace(b"IHDR", b"CRIT") + sound[33:]
    for claim, data in cases.items():
        (tmp_path / "x.png").write_bytes(with_checksums(data))
        with pytest.raises(FileError, match=claim):
            read_depth(tmp_path / "x.png")
    (tmp_path / "x.png").write_bytes(sound)
    assert not read_depth(tmp_path / "x.png").any()


def test_texts_and_profiles_of_a_png_are_left_aside_whatever_they_unpack_to(tmp_path, depth):
    write_png(tmp_path / "d.png", depth)
    data = (tmp_path / "d.png").read_bytes()
    bomb = zlib.compress(bytes(10**8))
    chunks = b""
    for kind, content in ((b"zTXt", b"key\0\0" + bomb), (b"iCCP", b"name\0\0" + bomb), (b"tEXt", b"damaged")):
        chunks += struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    (tmp_path / "d.png").write_bytes(data[:33] + chunks + data[33:-12] + chunks + data[-12:])
    assert np.array_equal(read_depth(tmp_path / "d.png"), depth)


def test_interlaced_pictures_of_every_depth_and_size_are_read(tmp_path):
    """Their passes are of up to seven sizes, some of them empty; Pillow writes none, so these are all of one value."""
    for bits, color_type, channels in [(1, 0, 1), (4, 0, 1), (8, 2, 3), (8, 4, 2), (16, 0, 1), (16, 2, 3), (16, 6, 4)]:
        for width, height in [(1, 1), (2, 1), (1, 5), (4, 4), (5, 3), (8, 8), (9, 17)]:
            size = 0
            for x, y, across, down in zip((0, 4, 0, 2, 0, 1, 0), (0, 0, 4, 0, 2, 0, 1), (8, 8, 4, 4, 2, 2, 1),
                                          (8, 8, 8, 4, 4, 2, 2), strict=True):  # fmt: skip
                columns, rows = len(range(x, width, across)), len(range(y, height, down))
                size += rows * (1 + -(-columns * bits * channels // 8)) if columns else 0
            path, kind = tmp_path / "i.png", {"bits": bits, "color_type": color_type, "interlace": 1}
            path.write_bytes(png_of(width, height, zlib.compress(bytes(size)), **kind))
            read = read_depth if (bits, color_type) == (16, 0) else read_color
            assert read(path).shape[:2] == (height, width)
            path.write_bytes(png_of(width, height, zlib.compress(bytes(size - 1)), **kind))
            with pytest.raises(FileError, match="stream of pixels holds"):
                read(path)


JPEGS = {
    "baseline": {}, "optimized": {"optimize": True}, "fine": {"quality": 100, "subsampling": 0},
    "restarts": {"restart_marker_rows": 1}, "progressive": {"progressive": True},
    "progressive restarts": {"progressive": True, "restart_marker_rows": 1},
}  # fmt: skip


@pytest.mark.parametrize("kind", JPEGS)
@pytest.mark.parametrize("is_grey", [False, True])
@pytest.mark.parametrize("end", [b"", b"\xff\xd9"])
def test_a_jpeg_that_ends_early_is_refused_with_and_without_an_end_mark(tmp_path, kind, is_grey, end):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    picture = np.random.default_rng(3).integers(0, 256, (53, 70, 3), np.uint8) // 3 + 80
    Image.fromarray(picture[:, :, 0] if is_grey else picture).save(file, "JPEG", **JPEGS[kind])
    data = file.getvalue()
    path.write_bytes(data + b"what some cameras append")
    assert np.array_equal(read_color(path), np.asarray(Image.open(file).convert("RGB")))
    start = data.index(b"\xff\xda")
    for length in range(start, len(data) - 24, (len(data) - start) // 25):
        path.write_bytes(data[:length] + end)
        with pytest.raises(FileError, match=r"c\.jpg"):
            read_color(path)


def test_a_jpeg_that_cannot_hold_its_pixels_is_refused_before_memory_is_taken(tmp_path, color):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    Image.fromarray(color).save(file, "JPEG", progressive=True)
    data = bytearray(file.getvalue())
    place = data.index(b"\xff\xc2")
    data[place + 5 : place + 9] = struct.pack(">HH", 2**14, 2**14)
    path.write_bytes(data)
    with pytest.raises(FileError, match="16384 x 16384 pixels cannot lie in"):
        read_color(path)


def test_a_jpeg_without_one_of_its_scans_is_refused(tmp_path, color):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    Image.fromarray(color).save(file, "JPEG", progressive=True)
    data = file.getvalue()
    places = [k for k in range(len(data)) if data[k : k + 2] in (b"\xff\xda", b"\xff\xc4")]  # scans, and their tables
    for place in places[2:]:
        path.write_bytes(data[:place] + b"\xff\xd9")
        with pytest.raises(FileError, match="ends before the scans of all its channels"):
            read_color(path)


def test_jpegs_of_which_it_cannot_be_told_are_refused_by_name(tmp_path, color, monkeypatch):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    Image.fromarray(color).save(file, "JPEG")
    path.write_bytes(file.getvalue().replace(b"\xff\xc0\0\x11", b"\xff\xc9\0\x11"))
    with pytest.raises(FileError, match=r"SOF9.*Store it as PNG"):
        read_color(path)
    path.write_bytes(file.getvalue())
    monkeypatch.setattr(ImageFile, "LOAD_TRUNCATED_IMAGES", True)
    with pytest.raises(FileError, match=r"c\.jpg.*LOAD_TRUNCATED_IMAGES = False"):
        read_color(path)


def test_an_animation_is_not_a_frame(tmp_path, color):
    frames = [Image.fromarray(color), Image.fromarray(255 - color)]
    frames[0].save(tmp_path / "a.png", save_all=True, append_images=frames[1:])
    with pytest.raises(FileError, match="an animation"):
        read_color(tmp_path / "a.png")


@pytest.mark.parametrize(
    ("array", "error", "claim"),
    [
        (np.zeros((4, 4)), TypeError, "float64"),
        (np.zeros((4, 4), np.int16), TypeError, "int16"),
        ([[1, 2]], TypeError, "list"),
        (np.zeros((4, 4, 4), np.uint8), ValueError, r"\[4, 4, 4\]"),
        (np.zeros((4, 4, 3), np.uint16), ValueError, r"expected shape \[h, w\] for uint16"),
        (np.zeros(4, np.uint8), ValueError, "shape"),
        (np.zeros((0, 4), np.uint8), ValueError, "pixels"),
    ],
)
def test_arrays_that_png_cannot_hold_are_refused(tmp_path, array, error, claim):
    with pytest.raises(error, match=claim):
        write_png(tmp_path / "x.png", array)
    assert not list(tmp_path.iterdir())


def test_png_is_not_written_under_another_name(tmp_path, depth):
    with pytest.raises(FileError, match=r"ends in \.png"):
        write_png(tmp_path / "d.jpg", depth)
    with pytest.raises(FileError, match="does not exist"):
        write_png(tmp_path / "none" / "d.png", depth)


@BITS
@given(place=st.integers(0, 10_000), change=st.integers(1, 255))
def test_a_changed_byte_is_noticed_wherever_it_lies(tmp_path, depth, place, change):
    write_png(tmp_path / "d.png", depth)
    data = bytearray((tmp_path / "d.png").read_bytes())
    data[place % len(data)] ^= change
    (tmp_path / "d.png").write_bytes(data)
    with pytest.raises(FileError):
        read_depth(tmp_path / "d.png")


@pytest.mark.parametrize("name", ["c.png", "c.jpg", "d.npy"])
@BITS
@given(start=st.integers(0, 10_000), length=st.integers(0, 8), patch=st.binary(max_size=8), sound=st.booleans())
def test_changed_bytes_give_a_picture_or_a_file_error(tmp_path, color, name, start, length, patch, sound):
    """Also where the checksums were made to fit again, so that the decoder sees the damage."""
    path = tmp_path / name
    if name == "d.npy":
        np.save(path, color[:, :, 0].astype(np.float32))
    else:
        Image.fromarray(color[:8, :8]).save(path)
    data = path.read_bytes()
    start %= min(len(data), 160) if name == "d.npy" else len(data)
    data = data[:start] + patch + data[start + length :]
    path.write_bytes(with_checksums(data) if sound and name == "c.png" else data)
    try:
        array = read_depth(path) if name == "d.npy" else read_color(path)
    except FileError:
        return
    assert array.ndim == (2 if name == "d.npy" else 3) and array.size


def with_checksums(data: bytes) -> bytes:
    """The same PNG with the checksum of each chunk made to fit, as far as its lengths lead."""
    data, place = bytearray(data), 8
    while place + 12 <= len(data):
        end = place + 8 + int.from_bytes(data[place : place + 4], "big")
        if end + 4 > len(data):
            break
        data[end : end + 4] = struct.pack(">I", zlib.crc32(data[place + 4 : end]))
        place = end + 4
    return bytes(data)
