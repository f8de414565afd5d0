"""Images with missing or excess pixels are rejected, never filled in."""

import io
import struct
import zlib

import numpy as np
import pytest
from PIL import Image, ImageFile

from pointloom.core.errors import FileError
from pointloom.io.pictures.image_files import read_color, read_depth, write_png

from .png_files import png_of, with_checksums

DEEP = {"bits": 16, "color_type": 0}
RED_GREEN_BLUE = {"bits": 8, "color_type": 2}


@pytest.mark.parametrize(("kind", "pixel", "read"), [(DEEP, 2, read_depth), (RED_GREEN_BLUE, 3, read_color)])
@pytest.mark.parametrize(
    ("rows", "cut", "message"),
    [
        (24, 0, None),
        (12, 0, "but its stream of pixels contains"),
        (23, 0, "but its stream of pixels contains"),
        (0, 0, "but its stream of pixels contains 0"),
        (25, 0, "but its stream of pixels contains more"),
        (48, 0, "but its stream of pixels contains more"),
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


def test_interlaced_pictures_of_every_depth_and_size_are_read(tmp_path):
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
    picture = np.random.default_rng(3).integers(0, 256, (53, 70, 3), np.uint8) // 3 + 80
    Image.fromarray(picture[:, :, 0] if is_gray else picture).save(file, "JPEG", **JPEGS[kind])
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
