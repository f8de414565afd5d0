"""Depth maps and images are read exactly or rejected; a damaged image is never read as another one."""

import io
import struct
import zlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image, ImageFile

from pointloom.core.errors import FileError
from pointloom.io.images import image_files
from pointloom.io.images.image_files import ImageHeader, read_color, read_depth, read_image_header, write_png

from ..pcd.any_cloud import examples


def png_of(width: int, height: int, *streams: bytes, bits: int = 16, color_type: int = 0, interlace: int = 0) -> bytes:
    """A PNG of valid chunks: a header with these values and the given streams."""

    def chunk(kind: bytes, content: bytes) -> bytes:
        return struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))

    head = struct.pack(">IIBBBBB", width, height, bits, color_type, 0, 0, interlace)
    parts = [chunk(b"IHDR", head), *(chunk(b"IDAT", stream) for stream in streams), chunk(b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(parts)


def png_claiming(width: int, height: int) -> bytes:
    """A PNG with a valid header of this size and hardly any pixels."""
    return png_of(width, height, zlib.compress(bytes(64)))


def with_checksums(data: bytes) -> bytes:
    """The same PNG with corrected checksums of all chunks that its lengths lead to."""
    data, offset = bytearray(data), 8
    while offset + 12 <= len(data):
        end = offset + 8 + int.from_bytes(data[offset : offset + 4], "big")
        if end + 4 > len(data):
            break
        data[end : end + 4] = struct.pack(">I", zlib.crc32(data[offset + 4 : end]))
        offset = end + 4
    return bytes(data)


def test_round_trip_is_exact(tmp_path, depth, color):
    for array, read in ((depth, read_depth), (color, read_color)):
        write_png(tmp_path / "p.png", array)
        again = read(tmp_path / "p.png")
        assert again.dtype == array.dtype and again.flags.writeable and np.array_equal(again, array)


@pytest.mark.parametrize("view", ["transposed", "every other", "other byte order"])
def test_any_memory_layout_is_written_correctly(tmp_path, depth, view):
    array = {"transposed": depth.T, "every other": depth[::2, ::-2], "other byte order": depth.astype(">u2")}[view]
    write_png(tmp_path / "d.png", array)
    assert np.array_equal(read_depth(tmp_path / "d.png"), array)


@pytest.mark.parametrize("mode", ["1", "L", "LA", "P", "RGBA", "CMYK"])
def test_every_kind_of_image_becomes_rgb(tmp_path, color, mode):
    name = "c.jpg" if mode == "CMYK" else "c.png"
    image = Image.fromarray(color).convert(mode)
    image.save(tmp_path / name)
    again = read_color(tmp_path / name)
    assert again.shape == (24, 32, 3) and again.dtype == np.uint8
    if mode != "CMYK":
        assert np.array_equal(again, np.asarray(image.convert("RGB")))


def test_transparency_is_dropped_and_does_not_darken(tmp_path, color):
    rgba = np.concatenate([color, np.zeros((24, 32, 1), np.uint8)], axis=2)
    Image.fromarray(rgba).save(tmp_path / "c.png")
    assert np.array_equal(read_color(tmp_path / "c.png"), color)
    palette = Image.fromarray(color).convert("P")
    palette.save(tmp_path / "p.png", transparency=bytes(range(256)))
    assert np.array_equal(read_color(tmp_path / "p.png"), np.asarray(palette.convert("RGB")))


def test_float_depth_is_read_from_npy_with_nan(tmp_path):
    depth = np.array([[0.0, 1.5, np.nan], [np.inf, -1.0, 3.25]], np.float32)
    for k, array in enumerate((depth, np.asfortranarray(depth), depth.astype(">f4"))):
        np.save(tmp_path / f"{k}.npy", array)
        again = read_depth(tmp_path / f"{k}.npy")
        assert again.dtype == np.float32 and again.dtype.isnative and again.flags.c_contiguous and again.flags.writeable
        np.testing.assert_array_equal(again, depth)


def test_headers_report_size_and_type_without_pixels(tmp_path, depth, color):
    write_png(tmp_path / "d.png", depth)
    (tmp_path / "d.png").write_bytes((tmp_path / "d.png").read_bytes()[:33])
    assert read_image_header(tmp_path / "d.png") == ImageHeader("png", 32, 24, 1, 16)
    Image.fromarray(color).save(tmp_path / "c.jpg")
    assert read_image_header(tmp_path / "c.jpg") == ImageHeader("jpeg", 32, 24, 3, 8)


def test_images_are_not_taken_for_depth_nor_depth_or_an_animation_for_color(tmp_path, depth, color):
    for mode in ("L", "RGB", "RGBA", "P"):
        Image.fromarray(color).convert(mode).save(tmp_path / "c.png")
        with pytest.raises(FileError, match=r"/c\.png:.*16-bit"):
            read_depth(tmp_path / "c.png")
    Image.fromarray(color).save(tmp_path / "c.jpg")
    with pytest.raises(FileError, match=r"/c\.jpg:"):
        read_depth(tmp_path / "c.jpg")
    write_png(tmp_path / "d.png", depth)
    with pytest.raises(FileError, match=r"c\.png|d\.png.*read_depth"):
        read_color(tmp_path / "d.png")
    frames = [Image.fromarray(color), Image.fromarray(255 - color)]
    frames[0].save(tmp_path / "a.png", save_all=True, append_images=frames[1:])
    with pytest.raises(FileError, match="an animation"):
        read_color(tmp_path / "a.png")


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"P5 2 2 65535\n", "neither PNG nor JPEG"),
        (b"\x89PNG\r\n\x1a\n", "damaged PNG header"),
        (png_claiming(2**20, 2**20), "1048576 x 1048576"),
        (png_claiming(2**31 - 1, 1), "expected 1 to"),
        (png_claiming(400, 300), "take 240300 bytes, but its stream of pixels contains 64"),
        (png_claiming(4, 4)[:-12], "the end of the PNG is missing"),
        (png_claiming(2**14, 2**14), "take 536887296 bytes"),
        (b"\x93NUMPY", ".npy header"),
    ],
)
def test_damaged_files_are_refused(tmp_path, data, message):
    path = tmp_path / "x.png"
    path.write_bytes(data)
    with pytest.raises(FileError, match=r"x\.png") as caught:
        read_depth(path)
    assert message in str(caught.value)


def test_other_arrays_and_headers_with_a_non_numeric_shape_are_no_depth(tmp_path):
    path = tmp_path / "d.npy"
    for array in (np.zeros((0, 3), np.float32), np.array([[None]]), np.ones((1, 4), np.float32)):
        np.save(path, array, allow_pickle=True)
        path.write_bytes(path.read_bytes().replace(b"(1, 4), }   ", b"(True, 4), }"))
        with pytest.raises(FileError, match=r"d\.npy"):
            read_depth(path)


def test_npy_with_too_few_bytes_is_rejected_before_allocation(tmp_path):
    np.save(tmp_path / "d.npy", np.zeros((10, 10), np.float32))
    data = (tmp_path / "d.npy").read_bytes()
    (tmp_path / "d.npy").write_bytes(data[:-1])
    with pytest.raises(FileError, match=r"/d\.npy:.*399.*400"):
        read_depth(tmp_path / "d.npy")
    (tmp_path / "d.npy").write_bytes(data.replace(b"(10, 10)", b"(99999, 99999)"))
    with pytest.raises(FileError, match="pixels, got 99999 x 99999"):
        read_depth(tmp_path / "d.npy")


def test_missing_files_and_folders_are_file_errors(tmp_path):
    for read in (read_depth, read_color, read_image_header):
        for path in (tmp_path / "none.png", tmp_path):
            with pytest.raises(FileError, match="cannot be read"):
                read(path)


def test_arrays_and_names_unsupported_by_png_are_rejected(tmp_path, depth):
    with pytest.raises(TypeError, match="list"):
        write_png(tmp_path / "x.png", [[1, 2]])
    for shape, message in ((4, "shape"), ((0, 4), "pixels")):
        with pytest.raises(ValueError, match=message):
            write_png(tmp_path / "x.png", np.zeros(shape, np.uint8))
    assert not list(tmp_path.iterdir())
    with pytest.raises(FileError, match=r"/d\.jpg:"):
        write_png(tmp_path / "d.jpg", depth)
    with pytest.raises(FileError, match=r"/d\.png:"):
        write_png(tmp_path / "none" / "d.png", depth)


@examples(25)
@given(offset=st.integers(0, 10_000), change=st.integers(1, 255))
def test_any_changed_byte_is_detected(tmp_path, depth, offset, change):
    write_png(tmp_path / "d.png", depth)
    data = bytearray((tmp_path / "d.png").read_bytes())
    data[offset % len(data)] ^= change
    (tmp_path / "d.png").write_bytes(data)
    with pytest.raises(FileError):
        read_depth(tmp_path / "d.png")


@pytest.mark.parametrize("name", ["c.png", "c.jpg", "d.npy"])
@examples(25)
@given(
    start=st.integers(0, 10_000), length=st.integers(0, 8), patch=st.binary(max_size=8), valid_checksums=st.booleans()
)
def test_changed_bytes_give_an_image_or_a_file_error(tmp_path, color, name, start, length, patch, valid_checksums):
    """Includes corrected checksums, so that the decoder sees the damage."""
    path = tmp_path / name
    if name == "d.npy":
        np.save(path, color[:, :, 0].astype(np.float32))
    else:
        Image.fromarray(color[:8, :8]).save(path)
    data = path.read_bytes()
    start %= min(len(data), 160) if name == "d.npy" else len(data)
    data = data[:start] + patch + data[start + length :]
    path.write_bytes(with_checksums(data) if valid_checksums and name == "c.png" else data)
    try:
        array = read_depth(path) if name == "d.npy" else read_color(path)
    except FileError:
        return
    assert array.ndim == (2 if name == "d.npy" else 3) and array.size


DEEP = {"bits": 16, "color_type": 0}
RED_GREEN_BLUE = {"bits": 8, "color_type": 2}


@pytest.mark.parametrize(("kind", "pixel", "read"), [(DEEP, 2, read_depth), (RED_GREEN_BLUE, 3, read_color)])
@pytest.mark.parametrize(
    ("rows", "cut", "message"),
    [
        (24, 0, None),
        (12, 0, "but its stream of pixels contains"),
        (0, 0, "but its stream of pixels contains 0"),
        (25, 0, "but its stream of pixels contains more"),
        (24, 1, "lacks its end and checksum"),
        (24, 4, "lacks its end and checksum"),
        (24, 30, "but its stream of pixels contains"),
    ],
)
def test_png_stream_that_contradicts_its_header_is_rejected(tmp_path, kind, pixel, read, rows, cut, message):
    rng, path = np.random.default_rng(2), tmp_path / "x.png"
    stream = zlib.compress(b"".join(b"\0" + rng.bytes(32 * pixel) for _ in range(rows)))
    path.write_bytes(png_of(32, 24, stream[: len(stream) - cut], **kind))
    if message is None:
        assert read(path).shape[:2] == (24, 32)
        return
    with pytest.raises(FileError, match=r"x\.png") as caught:
        read(path)
    assert message in str(caught.value)


@pytest.mark.parametrize(("width", "height"), [(48, 32), (24, 64), (12, 32), (24, 16), (10_000, 10_000), (33, 24)])
def test_png_with_a_changed_header_and_valid_checksums_is_rejected(tmp_path, depth, width, height):
    write_png(tmp_path / "d.png", depth)
    data = bytearray((tmp_path / "d.png").read_bytes())
    data[16:24] = struct.pack(">II", width, height)
    (tmp_path / "d.png").write_bytes(with_checksums(bytes(data)))
    with pytest.raises(FileError, match=r"/d\.png \(IDAT\):"):
        read_depth(tmp_path / "d.png")


def test_other_invalid_pngs_are_rejected(tmp_path, monkeypatch):
    monkeypatch.setattr(ImageFile, "LOAD_TRUNCATED_IMAGES", True)  # with which Pillow continues after an error
    row = b"\0" + bytes(8)
    compressed = zlib.compress(row * 4)
    cases = {
        "continues after its end": png_of(4, 4, compressed + b"more"),
        "not a zlib stream": png_of(4, 4, b"no stream"),
        "unknown filter": png_of(4, 4, zlib.compress(row * 3 + b"\5" + bytes(8))),
        "no 16 bits a channel for color type 3": png_of(4, 4, compressed, color_type=3),
        "interlacing 2": png_of(4, 4, compressed, interlace=2),
        "contains 36": png_of(4, 4, compressed, interlace=1),
    }
    valid = png_of(4, 4, compressed[:5], compressed[5:])
    cases["not in one run"] = valid[:-12] + valid[8:33].replace(b"IHDR", b"tEXt") + valid[33:]
    cases["a second PNG header"] = valid[:33] + valid[8:]
    cases["a chunk 'CRIT' that is unknown"] = valid[:33] + valid[8:33].replace(b"IHDR", b"CRIT") + valid[33:]
    for message, data in cases.items():
        (tmp_path / "x.png").write_bytes(with_checksums(data))
        with pytest.raises(FileError, match=message):
            read_depth(tmp_path / "x.png")
    (tmp_path / "x.png").write_bytes(valid)
    assert not read_depth(tmp_path / "x.png").any()


def test_text_and_profiles_of_a_png_are_not_decompressed(tmp_path, depth):
    write_png(tmp_path / "d.png", depth)
    data = (tmp_path / "d.png").read_bytes()
    bomb = zlib.compress(bytes(10**8))
    chunks = b""
    for kind, content in ((b"zTXt", b"key\0\0" + bomb), (b"iCCP", b"name\0\0" + bomb), (b"tEXt", b"damaged")):
        chunks += struct.pack(">I", len(content)) + kind + content + struct.pack(">I", zlib.crc32(kind + content))
    (tmp_path / "d.png").write_bytes(data[:33] + chunks + data[33:-12] + chunks + data[-12:])
    assert np.array_equal(read_depth(tmp_path / "d.png"), depth)


def test_interlaced_images_of_every_depth_and_size_are_read(tmp_path):
    """Their passes have up to seven sizes, some of them empty. Pillow writes none, so all have one value."""
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
            with pytest.raises(FileError, match=r"/i\.png \(IDAT\):"):
                read(path)


JPEGS = {
    "baseline": {}, "optimized": {"optimize": True}, "fine": {"quality": 100, "subsampling": 0},
    "restarts": {"restart_marker_rows": 1}, "progressive": {"progressive": True},
    "progressive restarts": {"progressive": True, "restart_marker_rows": 1},
}  # fmt: skip


@pytest.mark.parametrize("kind", JPEGS)
@pytest.mark.parametrize("is_gray", [False, True])
@pytest.mark.parametrize("end", [b"", b"\xff\xd9"])
def test_a_jpeg_that_ends_early_is_refused_with_and_without_an_end_mark(tmp_path, kind, is_gray, end):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    image = np.random.default_rng(3).integers(0, 256, (53, 70, 3), np.uint8) // 3 + 80
    Image.fromarray(image[:, :, 0] if is_gray else image).save(file, "JPEG", **JPEGS[kind])
    data = file.getvalue()
    path.write_bytes(data + b"what some cameras append")
    assert np.array_equal(read_color(path), np.asarray(Image.open(file).convert("RGB")))
    start = data.index(b"\xff\xda")
    for length in range(start, len(data) - 24, (len(data) - start) // 25):
        path.write_bytes(data[:length] + end)
        with pytest.raises(FileError, match=r"c\.jpg"):
            read_color(path)


def test_a_jpeg_without_one_of_its_scans_or_with_too_few_bytes_is_refused_before_allocation(tmp_path, color):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    Image.fromarray(color).save(file, "JPEG", progressive=True)
    data = file.getvalue()
    at = data.index(b"\xff\xc2") + 5
    path.write_bytes(data[:at] + struct.pack(">HH", 2**14, 2**14) + data[at + 4 :])
    with pytest.raises(FileError, match=r"/c\.jpg \(byte 242\):.*16384.*16384"):
        read_color(path)
    offsets = [k for k in range(len(data)) if data[k : k + 2] in (b"\xff\xda", b"\xff\xc4")]  # scans, and their tables
    for offset in offsets[2:]:
        path.write_bytes(data[:offset] + b"\xff\xd9")
        with pytest.raises(FileError, match=r"/c\.jpg:"):
            read_color(path)


@pytest.mark.parametrize(("marker", "at", "new", "reason"), [
    (b"\xff\xc0", 9, b"\0", "damaged: its frame"),
    (b"\xff\xc0", 9, b"\4", "damaged: its frame"),
    (b"\xff\xda", 4, b"\0", "damaged: the head of a scan"),
    (b"\xff\xda", 4, b"\4", "damaged: the head of a scan"),
    (b"\xff\xda", 5, b"\x4d", "damaged: the head of a scan"),  # a component that the frame does not have
])  # fmt: skip
def test_jpegs_with_damaged_segments_are_rejected_with_their_byte(tmp_path, color, marker, at, new, reason):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    Image.fromarray(color).save(file, "JPEG")
    data = file.getvalue()
    begin = data.index(marker)
    assert image_files.testable_jpegs(path, data)
    with pytest.raises(FileError, match=rf"/c\.jpg \(byte {begin + 2}\): {reason}"):
        image_files.testable_jpegs(path, data[: begin + at] + new + data[begin + at + len(new) :])
    length = int.from_bytes(data[begin + 2 : begin + 4], "big")
    if marker == b"\xff\xc0":  # a second frame
        twice = data[: begin + 2 + length] + data[begin:]
        with pytest.raises(FileError, match=rf"/c\.jpg \(byte {begin + 4 + length}\): {reason}"):
            image_files.testable_jpegs(path, twice)


def test_unverifiable_jpegs_are_rejected_with_a_reason(tmp_path, color, monkeypatch):
    path, file = tmp_path / "c.jpg", io.BytesIO()
    Image.fromarray(color).save(file, "JPEG")
    path.write_bytes(file.getvalue().replace(b"\xff\xc0\0\x11", b"\xff\xc9\0\x11"))
    with pytest.raises(FileError, match=r"/c\.jpg \(byte 160\):.*SOF9"):
        read_color(path)
    path.write_bytes(file.getvalue())
    monkeypatch.setattr(ImageFile, "LOAD_TRUNCATED_IMAGES", True)
    with pytest.raises(FileError, match=r"/c\.jpg:.*LOAD_TRUNCATED_IMAGES"):
        read_color(path)
